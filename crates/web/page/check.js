// Lecture notes: the text with its verdicts beside the lines, and the findings.

const LONGEST_PAGE = 512 << 10;

/** A check of a text that was edited meanwhile may go on for so long: what it found is of use to the next one. */
const PATIENCE = 2500;

/** More cards are shown when they are asked for. */
const MOST_CARDS = 200;

const PAGE = String.raw`# The polar form of a quadratic

Let $F(t) = t^2 + 2t$ and let $f$ be its polar form. Then
$$f(t_1, t_2) = t_1 t_2 + t_1 + t_2,$$
so $f(0, 1) = 1$ and $F(3) = f(3, 3) = 16$.

The Bernstein polynomials are $B_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}$. They sum to one:
$$\sum_{i=0}^n B_i^n(t) = 1.$$

Raising the degree:
$$B_i^n(t) = \Bigl(1 - \frac{i}{n+1}\Bigr) B_i^{n+1}(t) + \frac{i+1}{n+1} B_{i-1}^{n+1}(t).$$
`;

/** Where two texts differ: as far as they begin alike, and where the ends that are alike begin in each. */
function difference(old, fresh) {
  const most = Math.min(old.length, fresh.length);
  let start = 0;
  while (start < most && old[start] === fresh[start]) start++;
  let alike = 0;
  while (alike < most - start && old[old.length - 1 - alike] === fresh[fresh.length - 1 - alike]) alike++;
  return { start, oldEnd: old.length - alike, by: fresh.length - old.length };
}

const Check = {
  engine: new Engine(),
  formulas: [],
  /** The text in which the formulas stand. */
  checked: null,
  /** Whether the text was edited since its formulas were judged. */
  stale: false,
  running: false,
  newer: false,
  every: false,
  wait: 0,
  patience: 0,

  begin() {
    const text = byId("page");
    text.addEventListener("input", () => Check.edited());
    text.addEventListener("scroll", () => Check.scroll());
    byId("format").addEventListener("change", () => Check.edited(0));
    byId("check-stop").addEventListener("click", () => {
      Check.newer = false;
      Check.engine.stop();
    });
    byId("check-example").addEventListener("click", () => Check.put(PAGE, "auto"));
    byId("only-wrong").addEventListener("change", () => Check.list());
    byId("apply-all").addEventListener("click", () => Check.apply(Check.formulas.filter((one) => one.verdict === "refuted").flatMap((one) => one.fixes)));
    new ResizeObserver(() => Check.marks()).observe(text);
    Check.list();
  },

  put(text, format) {
    byId("format").value = format;
    byId("page").value = text;
    Check.edited(0);
  },

  edited(delay = 150) {
    const value = byId("page").value;
    clearTimeout(Check.wait);
    Link.changed();
    if (value.length > LONGEST_PAGE) {
      Check.forget();
      Check.say(say("too_long", value.length >> 10, LONGEST_PAGE >> 10));
      return;
    }
    Check.follow(value);
    Check.wait = setTimeout(() => Check.run(), delay);
  },

  forget() {
    Check.formulas = [];
    Check.checked = null;
    Check.marks();
    byId("findings").replaceChildren();
  },

  /** The text was edited: verdicts that the edit did not touch go along with their formulas until there are new ones. */
  follow(value) {
    if (Check.checked === null || Check.formulas.length === 0) {
      Check.forget();
      Check.say(value.trim() === "" ? "" : say("computing"));
      return;
    }
    const { start, oldEnd, by } = difference(Check.checked, value);
    const lines = (text) => text.split("\n").length;
    const byLines = by === 0 && oldEnd === start ? 0 : lines(value.slice(start, oldEnd + by)) - lines(Check.checked.slice(start, oldEnd));
    const moved = (place) => {
      if (place.to <= start) return true;
      if (place.from < oldEnd) return false;
      place.from += by;
      place.to += by;
      return true;
    };
    Check.formulas = Check.formulas.filter((one) => {
      const behind = one.from >= oldEnd;
      if (!moved(one)) {
        one.node?.remove();
        return false;
      }
      if (behind && byLines !== 0) {
        one.line += byLines;
        if (one.place) one.place.textContent = say("line", one.line);
      }
      one.fixes = one.fixes.every(moved) ? one.fixes : [];
      return true;
    });
    Check.checked = value;
    Check.age(true);
    Check.marks();
  },

  age(stale) {
    Check.stale = stale;
    for (const name of ["findings", "mirror", "gutter"]) byId(name).classList.toggle("stale", stale);
  },

  async run() {
    if (Check.running) {
      Check.newer = true;
      Check.patience ||= setTimeout(() => Check.engine.stop(), PATIENCE);
      return;
    }
    const text = byId("page").value;
    if (text.trim() === "") {
      Check.forget();
      Check.checked = "";
      Check.list();
      return;
    }
    Check.running = true;
    Check.newer = false;
    const busy = setTimeout(() => (byId("check-busy").hidden = false), 250);
    const format = byId("format").value;
    const request = { do: "check", text, again: true, ...(format === "auto" ? {} : { as: format }) };
    try {
      Check.shown(await Check.engine.call(request, (report) => Check.shown(report, text)), text);
    } catch (error) {
      if (byId("page").value === text) Check.say(lost(error));
    } finally {
      clearTimeout(busy);
      clearTimeout(Check.patience);
      Check.patience = 0;
      Check.running = false;
      byId("check-busy").hidden = true;
      if (Check.newer) Check.run();
    }
  },

  /** A report, or a part of one, on a text that may have been edited meanwhile. */
  shown(report, text) {
    const value = byId("page").value;
    if (value.length > LONGEST_PAGE || value.trim() === "") return;
    if (report.refused) {
      if (value !== text) return;
      Check.forget();
      Check.say(told(report.refused));
      return;
    }
    Check.report = report;
    Check.formulas = report.formulas;
    Check.checked = text;
    byId("format").options[0].textContent = say("auto_is", say(report.as));
    Check.list(report);
    if (value !== text) Check.follow(value);
    else {
      Check.age(report.partial === true);
      Check.marks();
    }
  },

  say(words) {
    byId("summary").textContent = words;
    byId("apply-all").hidden = true;
  },

  /** The findings: those that are wrong first. */
  list(report) {
    const out = byId("findings");
    const all = Check.formulas.filter((one) => one.kind !== "none" || one.warning);
    const wrong = byId("only-wrong").checked;
    const rank = (one) => (one.verdict === "refuted" ? 0 : one.warning ? 1 : 2);
    const shown = all.filter((one) => !wrong || rank(one) < 2).sort((a, b) => rank(a) - rank(b) || a.from - b.from);
    const cut = Check.every ? shown : shown.slice(0, MOST_CARDS);
    out.replaceChildren(...cut.map((one) => (one.node = Check.card(one))));
    if (cut.length < shown.length) {
      const all = () => {
        Check.every = true;
        Check.list();
      };
      out.append(make("li", {}, make("button", { type: "button", class: "small", onclick: all }, say("show_all", shown.length))));
    }
    if (Check.checked === null || Check.checked === "") {
      Check.say(Check.checked === "" || byId("page").value === "" ? say("empty_check") : "");
    } else {
      const problems = Check.report.problems.map((one) => told(one.message));
      const words = Check.formulas.length > 0 ? [say("summary", Check.report)] : Check.report.partial ? [] : [say("no_formula")];
      if (Check.report.partial) words.push(say("computing"));
      Check.say([...words, ...problems].join(" "));
      byId("apply-all").hidden = !all.some((one) => one.verdict === "refuted" && one.fixes.length > 0);
      if (report && !report.partial) announce(byId("summary").textContent);
    }
  },

  card(one) {
    const rows = [];
    const row = (name, ...content) => rows.push(make("dt", {}, say(name)), make("dd", {}, ...content));
    const place = make("button", { type: "button", class: "quiet place", onclick: () => Check.go(one) }, say("line", one.line));
    one.place = place;
    if (one.witness) row("counterexample", make("span", { class: "mono" }, told(one.witness)));
    if (one.suggestion) {
      const apply = one.fixes.length === 0 ? null
        : make("button", { type: "button", class: "small", onclick: () => Check.apply(one.fixes) }, say("apply"));
      row("suggestion", formula(one.suggestion), " ", apply);
    }
    if (one.warning) row("suspicious", told(one.warning));
    if (one.instances) row("tried", told(one.instances));
    for (const note of one.notes) row("assumed", told(note));
    const loud = one.verdict === "refuted" || one.warning;
    const details = rows.length === 0 ? null : make("dl", {}, ...rows);
    return make("li", { class: `card ${one.verdict}` },
      make("div", { class: "head" }, badge(one.verdict), place),
      formula(one.reading || one.latex, true, one.latex),
      one.reason ? make("p", { class: "reason" }, told(one.reason)) : null,
      details && !loud ? make("details", {}, make("summary", {}, say("details")), details) : details);
  },

  /** Selects a formula in the text. */
  go(one) {
    if (Check.checked !== byId("page").value) return;
    const text = byId("page");
    text.focus();
    text.setSelectionRange(one.from, one.to);
    const mark = byId("mirror").querySelector(`[data-from="${one.from}"]`);
    if (mark) text.scrollTop = Math.max(0, mark.offsetTop - text.clientHeight / 3);
  },

  /** Puts edits in, the last one first, so that places before it stay. */
  apply(fixes) {
    const text = byId("page");
    if (Check.checked !== text.value) return;
    let end = Infinity;
    for (const fix of [...fixes].sort((a, b) => b.from - a.from)) {
      if (fix.to > end) continue;
      text.setRangeText(fix.text, fix.from, fix.to, "end");
      end = fix.from;
    }
    Check.edited(0);
  },

  /** The same text behind the page, with the formulas marked, and a sign beside each line that has one. */
  marks() {
    const mirror = byId("mirror");
    const text = byId("page");
    const value = text.value;
    if (Check.checked !== value) {
      mirror.replaceChildren();
      byId("gutter").replaceChildren();
      return;
    }
    // Relations of a chain share their sides; what is worse is painted over what is better.
    const worst = ["refuted", "undecided", "unread", "sampled", "proved", "definition"];
    const shown = Check.formulas.filter((one) => one.kind !== "none");
    const paint = new Int32Array(value.length).fill(-1);
    shown.map((one, i) => i).sort((a, b) => worst.indexOf(shown[b].verdict) - worst.indexOf(shown[a].verdict))
      .forEach((i) => paint.fill(i, shown[i].from, shown[i].to));
    const pieces = [];
    for (let at = 0; at < value.length; ) {
      let end = at + 1;
      while (end < value.length && paint[end] === paint[at]) end++;
      const one = shown[paint[at]];
      const text = value.slice(at, end);
      pieces.push(one ? make("span", { class: `mark ${one.verdict}`, "data-from": one.from, "data-line": one.line }, text) : text);
      at = end;
    }
    mirror.replaceChildren(...pieces, "\n");
    mirror.style.width = `${text.clientWidth}px`;
    const lines = new Map();
    for (const node of mirror.querySelectorAll(".mark")) {
      const verdict = worst.find((word) => node.classList.contains(word));
      const top = node.offsetTop;
      const before = lines.get(top);
      if (!before || worst.indexOf(verdict) < worst.indexOf(before.verdict)) {
        lines.set(top, { verdict, from: Number(node.dataset.from), line: node.dataset.line });
      }
    }
    byId("gutter").replaceChildren(...[...lines].map(([top, { verdict, from, line }]) => {
      const sign = make("button", { type: "button", class: `sign ${verdict}`, title: say(verdict), "aria-label": `${say("line", line)}: ${say(verdict)}`,
        onclick: () => Check.go(shown.find((one) => one.from === from && one.verdict === verdict)) }, SIGNS[verdict]);
      sign.style.top = `${top}px`;
      return sign;
    }));
    Check.scroll();
  },

  scroll() {
    const top = byId("page").scrollTop;
    byId("mirror").style.transform = `translateY(${-top}px)`;
    byId("gutter").style.transform = `translateY(${-top}px)`;
  },
};
