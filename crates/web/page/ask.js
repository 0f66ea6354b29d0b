// The prompt: inputs, answers, history, completion.

const LONGEST_INPUT = 64 << 10;

const EXAMPLES = [
  "f := polar(t^3 + 3t)",
  "f(0, 1/2, t)",
  "F(t) := (1-t)^2 p_0 + 2 t (1-t) p_1 + t^2 p_2",
  "polar(F)",
  "(t+1)^2 = t^2 + 1",
  "derive(polar, t^3 - t)",
  "figure_casteljau(bezier([[0, 0], [1, 3], [4, 4], [6, 1]]), 2/5)",
];

const Ask = {
  /** Inputs that were run and changed the session or had an answer: they are what a link holds, and what a new worker repeats. */
  inputs: [],
  history: [],
  at: 0,
  draft: "",
  list: null,
  completing: false,
  again: false,

  engine: new Engine(
    () => Ask.inputs.map((input) => ({ do: "ask", input, lang })),
    (place) => {
      notice(say("forgotten", Ask.inputs[place]));
      Ask.inputs.length = place;
      Link.changed();
    },
  ),

  begin() {
    const box = byId("prompt");
    byId("ask-form").addEventListener("submit", (event) => {
      event.preventDefault();
      Ask.run(box.value);
    });
    box.addEventListener("keydown", (event) => Ask.key(event));
    box.addEventListener("input", () => {
      Ask.grow();
      Ask.narrow();
      Ask.complete(false);
    });
    box.addEventListener("blur", () => setTimeout(() => Ask.close(), 150));
    byId("ask-stop").addEventListener("click", () => Ask.engine.stop());
    byId("ask-clear").addEventListener("click", () => Ask.clear());
    const chips = byId("ask-examples");
    for (const example of EXAMPLES) {
      chips.append(make("button", { type: "button", class: "chip", onclick: () => Ask.run(example) }, example));
    }
  },

  grow() {
    const box = byId("prompt");
    box.rows = Math.min(12, box.value.split("\n").length);
  },

  async clear() {
    Ask.inputs = [];
    byId("answers").replaceChildren();
    Ask.engine.stop();
    Link.changed();
    byId("prompt").focus();
  },

  async key(event) {
    const box = byId("prompt");
    if (Ask.list && ["ArrowDown", "ArrowUp"].includes(event.key)) {
      event.preventDefault();
      Ask.choose(event.key === "ArrowDown" ? 1 : -1);
    } else if (event.key === "Escape" && Ask.list) {
      event.preventDefault();
      Ask.close();
    } else if (event.key === "Tab" && !event.shiftKey && box.value.trim() !== "" && (Ask.list || /[\w\\]$/u.test(box.value.slice(0, box.selectionStart)))) {
      event.preventDefault();
      if (Ask.list) Ask.take();
      else await Ask.complete(true);
    } else if (event.key === "Enter" && !event.shiftKey && !event.isComposing) {
      event.preventDefault();
      if (Ask.list && Ask.chosen >= 0) Ask.take();
      else Ask.entered();
    } else if (event.key === "ArrowUp" && !box.value.slice(0, box.selectionStart).includes("\n")) {
      Ask.recall(event, -1);
    } else if (event.key === "ArrowDown" && !box.value.slice(box.selectionEnd).includes("\n")) {
      Ask.recall(event, 1);
    }
  },

  recall(event, step) {
    const box = byId("prompt");
    const to = Ask.at + step;
    if (to < 0 || to > Ask.history.length) return;
    event.preventDefault();
    if (Ask.at === Ask.history.length) Ask.draft = box.value;
    Ask.at = to;
    box.value = to === Ask.history.length ? Ask.draft : Ask.history[to];
    box.selectionStart = box.selectionEnd = box.value.length;
    Ask.grow();
    Ask.close();
  },

  /** Enter: an input that is not complete gets another line. */
  async entered() {
    const box = byId("prompt");
    const input = box.value;
    if (input.trim() === "") return;
    if (!Ask.engine.busy && input.length <= LONGEST_INPUT) {
      const { incomplete } = await Ask.engine.call({ do: "incomplete", input }).catch(Ask.aside);
      if (incomplete && box.value === input) {
        box.setRangeText("\n", box.selectionStart, box.selectionEnd, "end");
        Ask.grow();
        return;
      }
    }
    Ask.run(input);
  },

  async complete(asked) {
    const box = byId("prompt");
    const before = box.value.slice(0, box.selectionStart);
    if (Ask.completing) {
      // The word has grown meanwhile: it is asked for again.
      Ask.again = true;
      return;
    }
    if (Ask.engine.busy || before.length > LONGEST_INPUT || !(asked || /[\p{L}\\][\w\\]+$/u.test(before))) return Ask.close();
    Ask.completing = true;
    Ask.again = false;
    const { from, candidates } = await Ask.engine.call({ do: "complete", before }).catch(Ask.aside);
    Ask.completing = false;
    if (Ask.again) return Ask.complete(asked);
    if (box.value.slice(0, box.selectionStart) !== before || document.activeElement !== box) return;
    const word = before.slice(from);
    if (candidates.length === 0 || (candidates.length === 1 && candidates[0].put === word)) return Ask.close();
    if (asked && candidates.length === 1) return Ask.put(from, candidates[0].put);
    Ask.open(from, candidates.slice(0, 12));
  },

  /** A question beside the input that was lost: the input goes on without its answer. */
  aside(error) {
    if (error.kind === "trapped") notice(lost(error), " ", say("session_kept"));
    return { candidates: [] };
  },

  /** What no longer begins as the word does leaves the list at once: a key pressed before the next answer never takes it. */
  narrow() {
    if (!Ask.list) return;
    const { from, candidates } = Ask.list;
    const box = byId("prompt");
    const word = box.value.slice(from, box.selectionStart);
    const left = candidates.filter((candidate) => candidate.put.startsWith(word));
    if (word === "" || left.length === 0) Ask.close();
    else Ask.open(from, left);
  },

  /** Shows candidates; the one that was chosen stays so. */
  open(from, candidates) {
    const chosen = Ask.list?.candidates[Ask.chosen]?.put;
    const list = byId("candidates");
    list.replaceChildren(
      ...candidates.map((candidate, i) =>
        make("li", { role: "option", id: `candidate-${i}`, "aria-selected": "false", onmousedown: (event) => {
          event.preventDefault();
          Ask.put(from, candidate.put);
        } }, candidate.shown)),
    );
    list.hidden = false;
    Ask.list = { from, candidates };
    byId("prompt").setAttribute("aria-expanded", "true");
    Ask.mark(candidates.findIndex((candidate) => candidate.put === chosen));
  },

  choose(step) {
    const count = Ask.list.candidates.length;
    Ask.mark(Ask.chosen < 0 && step < 0 ? count - 1 : (Ask.chosen + step + count) % count);
  },

  /** The candidate that Enter takes, none with -1. */
  mark(place) {
    Ask.chosen = place;
    if (place < 0) return byId("prompt").removeAttribute("aria-activedescendant");
    [...byId("candidates").children].forEach((node, i) => node.setAttribute("aria-selected", String(i === Ask.chosen)));
    byId("prompt").setAttribute("aria-activedescendant", `candidate-${Ask.chosen}`);
    byId(`candidate-${Ask.chosen}`).scrollIntoView({ block: "nearest" });
  },

  take() {
    const { from, candidates } = Ask.list;
    Ask.put(from, candidates[Math.max(0, Ask.chosen)].put);
  },

  put(from, text) {
    const box = byId("prompt");
    box.setRangeText(text, from, box.selectionStart, "end");
    Ask.close();
    box.focus();
  },

  close() {
    byId("candidates").hidden = true;
    Ask.list = null;
    const box = byId("prompt");
    box.setAttribute("aria-expanded", "false");
    box.removeAttribute("aria-activedescendant");
  },

  /** Runs an input and shows what comes of it. */
  async run(input) {
    input = input.trim();
    if (input === "") return;
    const box = byId("prompt");
    if (input.length > LONGEST_INPUT) {
      notice(say("too_long", input.length >> 10, LONGEST_INPUT >> 10));
      return;
    }
    Ask.close();
    if (box.value.trim() === input) box.value = "";
    Ask.grow();
    Ask.history.push(input);
    Ask.at = Ask.history.length;
    const out = make("div", { class: "out" });
    const again = make("button", { type: "button", class: "input", onclick: () => Ask.edit(input) }, input);
    const entry = make("li", { class: "entry" }, again, out);
    byId("answers").append(entry);
    const busy = setTimeout(() => {
      byId("ask-busy").hidden = false;
      entry.scrollIntoView({ block: "nearest" });
    }, 250);
    try {
      const answer = await Ask.engine.call({ do: "ask", input, lang });
      if (answer.refused) {
        out.append(make("p", { class: "problem" }, told(answer.refused)));
      } else {
        if (answer.answers.length > 0) {
          Ask.inputs.push(input);
          Link.changed();
        }
        out.append(...answer.answers.map((one) => Ask.shown(one)));
        if (answer.problem) out.append(Ask.problem(answer.problem, input));
        announce(answer.answers.map((one) => one.text).join("\n") || answer.problem?.message || "");
      }
    } catch (error) {
      out.append(make("p", { class: "problem" }, lost(error), " ", say("session_kept")));
    } finally {
      clearTimeout(busy);
      byId("ask-busy").hidden = Ask.engine.busy;
      if (!Ask.engine.busy) byId("ask-busy").hidden = true;
      entry.scrollIntoView({ block: "nearest" });
    }
  },

  edit(input) {
    const box = byId("prompt");
    box.value = input;
    Ask.grow();
    box.focus();
  },

  shown(answer) {
    const node = make("div", { class: `answer ${answer.kind}` });
    const tools = make("div", { class: "tools" });
    if (answer.kind === "picture") {
      node.append(picture(answer.svg, answer.title));
      tools.append(copier("copy_svg", answer.svg), copier("copy_tikz", answer.tikz));
    } else if (answer.kind === "steps") {
      const lines = answer.lines.map((line) =>
        make("tr", {}, make("td", {}, formula(line.left)), make("td", {}, formula(line.right)), make("td", { class: "reason" }, ...sentence(line.reason))));
      node.append(make("table", { class: "steps" }, make("tbody", {}, ...lines)));
      tools.append(copier("copy_text", answer.text));
    } else if (answer.kind === "claim") {
      const rest = answer.text.split("\n").slice(1).map((line) => told(line.replace(/^ {2}/, ""))).join("\n");
      node.append(
        make("div", { class: "claimed" }, badge(answer.verdict), answer.latex === null ? null : formula(answer.latex, true)),
        rest === "" ? null : make("pre", { class: "because" }, rest),
      );
      tools.append(copier("copy_text", answer.text));
    } else if (answer.latex === null) {
      node.append(make("pre", {}, answer.text));
      tools.append(copier("copy_text", answer.text));
    } else {
      node.append(formula(answer.latex, true, answer.text));
      tools.append(copier("copy_latex", answer.latex), copier("copy_text", answer.text));
    }
    for (const note of answer.notes) node.append(make("p", { class: "note" }, told(note.message)));
    node.append(tools);
    return node;
  },

  problem(problem, input) {
    const node = make("div", { class: "problem" }, make("p", {}, ...problemWords(problem)));
    if (problem.to > problem.from) {
      node.append(make("pre", {}, input.slice(0, problem.from), make("mark", {}, input.slice(problem.from, problem.to)), input.slice(problem.to)));
    }
    for (const hint of problem.hints) node.append(make("p", { class: "hint" }, told(hint)));
    return node;
  },
};

const SIGNS = { proved: "✓", sampled: "≈", refuted: "✗", undecided: "?", unread: "–", definition: ":=", none: "·" };

/** A verdict as a sign and a word. */
const badge = (verdict) =>
  make("span", { class: `badge ${verdict}` }, make("span", { "aria-hidden": "true" }, SIGNS[verdict]), " ", say(verdict));
