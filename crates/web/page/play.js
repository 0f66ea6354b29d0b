// A curve with movable control points. Places are fractions; the module computes, this file only draws.

const WORLD = { width: 12, height: 7 };
const UNIT = 60;
const SLIDER = 120;
const MOST_POINTS = 8;

const STARTS = {
  bezier: () => ({
    kind: "bezier", grid: 2, t: "2/5", ends: ["0", "1"], degree: 3,
    points: [["1", "1"], ["3", "6"], ["9", "6"], ["11", "2"]], knots: [],
  }),
  bspline: () => ({
    kind: "bspline", grid: 2, t: "3/2", ends: [], degree: 3,
    points: [["1", "1"], ["2", "5"], ["5", "6"], ["8", "1"], ["10", "2"], ["11", "6"]],
    knots: ["0", "0", "0", "0", "1", "2", "3", "3", "3", "3"],
  }),
};

/** Follows a pointer that is down on a node: `moved` gets the share of a box's width and height where it is, until it is up. */
function followed(event, node, box, moved) {
  node.setPointerCapture(event.pointerId);
  const follow = ({ clientX, clientY }) => {
    const { left, top, width, height } = box.getBoundingClientRect();
    moved((clientX - left) / width, (clientY - top) / height);
  };
  const ends = ["pointerup", "pointercancel"];
  const done = () => {
    node.removeEventListener("pointermove", follow);
    for (const end of ends) node.removeEventListener(end, done);
  };
  node.addEventListener("pointermove", follow);
  for (const end of ends) node.addEventListener(end, done);
}

const Play = {
  engine: new Engine(),
  state: STARTS.bezier(),
  answer: null,
  dirty: false,
  running: false,
  handles: [],
  ticks: [],

  begin() {
    for (const kind of ["bezier", "bspline"]) {
      byId(`kind-${kind}`).addEventListener("change", () => Play.load(STARTS[kind]()));
    }
    byId("grid").addEventListener("change", (event) => Play.change({ grid: Number(event.target.value) }));
    byId("t").addEventListener("input", (event) => {
      const [a, b] = Play.domain();
      Play.change({ t: `(${a}) + ((${b}) - (${a})) * ${event.target.value}/${SLIDER}` });
    });
    byId("t-exact").addEventListener("change", (event) => Play.change({ t: event.target.value }));
    byId("more").addEventListener("click", () => Play.resize(1));
    byId("less").addEventListener("click", () => Play.resize(-1));
    byId("play-reset").addEventListener("click", () => Play.load(STARTS[Play.state.kind]()));
    for (const form of ["svg", "tikz"]) {
      byId(`play-${form}`).addEventListener("click", (event) => Play.figure(form, event.currentTarget));
    }
    byId("play-ask").addEventListener("click", () => {
      if (!Play.answer) return;
      Ask.run(Play.answer.query);
      byId("ask").scrollIntoView();
    });
    Play.grid();
    Play.load(Play.state);
  },

  domain() {
    const known = Play.answer?.domain.map((end) => end.text);
    return known ?? (Play.state.ends.length ? Play.state.ends : ["0", "3"]);
  },

  load(state) {
    Play.state = state;
    byId(`kind-${state.kind}`).checked = true;
    byId("grid").value = String(state.grid);
    Play.answer = null;
    Play.change({});
  },

  change(part) {
    Object.assign(Play.state, part);
    Play.dirty = true;
    Play.compute();
  },

  /** One request at a time, for the newest state. */
  async compute() {
    if (Play.running) return;
    Play.running = true;
    while (Play.dirty) {
      Play.dirty = false;
      const { kind, points, knots, degree, ends, t } = Play.state;
      const request = { do: "play", kind, points, t, ...(kind === "bezier" ? { ends } : { knots, degree }) };
      try {
        const answer = await Play.engine.call(request);
        byId("play-problem").textContent = told(answer.refused ?? "");
        if (!answer.refused) Play.answer = { ...answer, kind };
        // A link may hold a curve that there is not, and nothing was before it.
        if (answer.refused && Play.answer?.kind !== kind && !Play.dirty) {
          notice(told(answer.refused));
          Play.load(STARTS[kind]());
          continue;
        }
        // Lowest terms, as the module writes them, or what was before; what was moved meanwhile stays.
        if (!Play.dirty && Play.answer) {
          Play.state.points = Play.answer.control.map((point) => [point.x, point.y]);
          Play.state.t = Play.answer.t.text;
          if (kind === "bspline") Play.state.knots = Play.answer.knots.map((knot) => knot.text);
        }
        if (!answer.refused) Play.show();
      } catch (error) {
        byId("play-problem").textContent = lost(error);
      }
      Link.changed();
    }
    Play.running = false;
  },

  /** One control point more or less; a spline gets a knot with it. */
  resize(by) {
    const { kind, points, degree } = Play.state;
    const count = points.length + by;
    if (count > MOST_POINTS || count < (kind === "bezier" ? 2 : degree + 1)) return;
    const fresh = [...points];
    if (by < 0) {
      fresh.splice(Math.floor(points.length / 2), 1);
    } else {
      const at = Math.floor(points.length / 2);
      const [p, q] = [fresh[at - 1], fresh[at]];
      fresh.splice(at, 0, [0, 1].map((k) => `((${p[k]}) + (${q[k]}))/2`));
    }
    if (kind === "bezier") return Play.change({ points: fresh, degree: fresh.length - 1 });
    const last = fresh.length - degree;
    const inner = Array.from({ length: last - 1 }, (_, i) => String(i + 1));
    const knots = [...Array(degree + 1).fill("0"), ...inner, ...Array(degree + 1).fill(String(last))];
    Play.change({ points: fresh, knots, t: `${last}/2` });
  },

  async figure(form, button) {
    const input = Play.answer?.query;
    if (!input) return;
    try {
      const answer = await Play.engine.call({ do: "ask", session: [], input, lang });
      if (answer.answers[0]) await copy(answer.answers[0][form], button);
    } catch (error) {
      byId("play-problem").textContent = lost(error);
    }
  },

  // ---- drawing ----

  grid() {
    const lines = byId("canvas").querySelector(".grid");
    for (let x = 0; x <= WORLD.width; x++) lines.append(draw("line", { x1: x * UNIT, y1: 0, x2: x * UNIT, y2: WORLD.height * UNIT }));
    for (let y = 0; y <= WORLD.height; y++) lines.append(draw("line", { x1: 0, y1: y * UNIT, x2: WORLD.width * UNIT, y2: y * UNIT }));
  },

  spot: ([x, y]) => [x * UNIT, (WORLD.height - y) * UNIT],

  show() {
    const { answer } = Play;
    const canvas = byId("canvas");
    const points = (list) => list.map((one) => Play.spot(one.at).join(" ")).join(" ");
    const put = (name, ...nodes) => canvas.querySelector(`.${name}`).replaceChildren(...nodes);
    put("polygon", draw("polyline", { points: points(answer.control) }));
    const flip = `matrix(${UNIT} 0 0 ${-UNIT} 0 ${WORLD.height * UNIT})`;
    put("curve", ...answer.paths.map((d, i) => draw("path", { d, transform: flip, class: `piece-${i % 2}` })));
    const inner = answer.levels.slice(1);
    put("levels", ...inner.flatMap((level, r) => {
      const last = r === inner.length - 1;
      const dots = level.map((one, i) => {
        const [x, y] = Play.spot(one.at);
        return draw("circle", { cx: x, cy: y, r: last ? 7 : 4, class: last ? "last" : "dot", "data-entry": `${r + 1}-${i}` });
      });
      return level.length > 1 ? [draw("polyline", { points: points(level) }), ...dots] : dots;
    }));
    put("joints", ...(answer.joints ?? []).map((joint) => {
      const [x, y] = Play.spot(joint.at);
      return draw("rect", { x: x - 4, y: y - 4, width: 8, height: 8 });
    }));
    Play.showHandles();
    Play.showLabels();
    Play.showPyramid();
    Play.showKnots();
    byId("play-values").replaceChildren(formula(answer.value, true), formula(answer.tangent, true));
    const [a, b] = answer.domain;
    const exact = byId("t-exact");
    if (document.activeElement !== exact) exact.value = answer.t.text;
    const part = (answer.t.at - a.at) / (b.at - a.at);
    if (document.activeElement !== byId("t")) byId("t").value = String(Math.round(part * SLIDER));
    byId("t").setAttribute("aria-valuetext", answer.t.text);
    byId("play-degree").textContent = String(answer.degree);
  },

  showHandles() {
    const group = byId("canvas").querySelector(".handles");
    const { control } = Play.answer;
    while (Play.handles.length > control.length) Play.handles.pop().remove();
    while (Play.handles.length < control.length) {
      const i = Play.handles.length;
      const node = draw("g", { class: "handle", tabindex: "0", role: "button" });
      node.append(draw("circle", { r: 18, class: "reach" }), draw("circle", { r: 7, class: "dot" }));
      node.addEventListener("pointerdown", (event) => Play.drag(event, i));
      node.addEventListener("keydown", (event) => Play.nudge(event, i));
      group.append(node);
      Play.handles.push(node);
    }
    control.forEach((one, i) => {
      const [x, y] = Play.spot(one.at);
      Play.handles[i].setAttribute("transform", `translate(${x} ${y})`);
      Play.handles[i].setAttribute("aria-label", say("point_name", one.label, one.x, one.y));
    });
  },

  /** A place as a fraction of the grid, inside the picture. */
  snapped(value, largest) {
    const { grid } = Play.state;
    const k = Math.round(Math.min(Math.max(value, 0), largest) * grid);
    return grid === 1 ? String(k) : `${k}/${grid}`;
  },

  move(i, x, y) {
    const points = Play.state.points.map((point) => [...point]);
    points[i] = [Play.snapped(x, WORLD.width), Play.snapped(y, WORLD.height)];
    Play.change({ points });
  },

  drag(event, i) {
    event.preventDefault();
    Play.handles[i].focus();
    followed(event, Play.handles[i], byId("canvas"), (x, y) => Play.move(i, x * WORLD.width, (1 - y) * WORLD.height));
  },

  nudge(event, i) {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!step) return;
    event.preventDefault();
    const [x, y] = Play.answer.control[i].at;
    Play.move(i, x + step[0] / Play.state.grid, y + step[1] / Play.state.grid);
  },

  /** Points of the curve as shares of the picture. */
  sampled() {
    const paths = [...byId("canvas").querySelectorAll(".curve path")];
    return paths.flatMap((path) => {
      const length = path.getTotalLength();
      return Array.from({ length: 33 }, (_, i) => path.getPointAtLength((length * i) / 32)).map(({ x, y }) => [x / WORLD.width, 1 - y / WORLD.height]);
    });
  },

  /**
   * Names beside the control points and the point of the curve: away from the middle of the polygon, but where that would
   * leave the picture, hide a point or another name, or lie on the curve, in the direction that does the least of it.
   */
  showLabels() {
    const { control, levels } = Play.answer;
    const middle = [0, 1].map((k) => control.reduce((sum, one) => sum + one.at[k], 0) / control.length);
    const last = levels[levels.length - 1][0];
    const away = ({ at }) => Math.atan2(middle[1] - at[1], at[0] - middle[0]);
    const all = [...control.map((one) => ({ ...one, angle: away(one) })), { ...last, place: "last", angle: Math.PI / 2 }];
    const nodes = all.map((one) => make("span", { class: `label ${one.place ?? ""}` }, formula(one.label_latex)));
    byId("labels").replaceChildren(...nodes);
    const stage = byId("labels").getBoundingClientRect();
    const share = all.map((one) => Play.spot(one.at)).map(([x, y]) => [x / (WORLD.width * UNIT), y / (WORLD.height * UNIT)]);
    const scaled = ([x, y]) => [x * stage.width, y * stage.height];
    const points = share.map(scaled);
    const curve = Play.sampled().map(scaled);
    const sizes = nodes.map((node) => node.getBoundingClientRect()).map(({ width, height }) => [width / 2, height / 2]);
    const put = [];
    nodes.forEach((node, i) => {
      const [width, height] = sizes[i];
      const near = ([px, py], [x, y], by) => Math.abs(px - x) < width + by && Math.abs(py - y) < height + by;
      const turned = (turn, off) => {
        const [dx, dy] = [Math.cos(all[i].angle + turn), Math.sin(all[i].angle + turn)];
        // As far as the point is free of the name.
        const far = Math.min((width + off) / Math.abs(dx), (height + off) / Math.abs(dy));
        return [points[i][0] + dx * far, points[i][1] + dy * far];
      };
      const harm = (at) => {
        const [x, y] = at;
        const out = x < width + 4 || x > stage.width - width - 4 || y < height + 4 || y > stage.height - height - 4;
        const names = put.filter((one) => Math.abs(one.at[0] - x) < one.width + width + 2 && Math.abs(one.at[1] - y) < one.height + height + 1).length;
        const hidden = points.filter((point) => near(point, at, 6)).length;
        return 1000 * out + 100 * (names + hidden) + curve.filter((point) => near(point, at, 1)).length;
      };
      const turns = [0, 1, -1, 2, -2, 3, -3, 4].map((turn) => (turn * Math.PI) / 4);
      const places = [8, 22, 40].flatMap((off) => turns.map((turn) => turned(turn, off)));
      // A name that stands far away may be taken for that of another point.
      const harms = places.map((at, i) => harm(at) + 2 * Math.floor(i / turns.length));
      const at = places[harms.indexOf(Math.min(...harms))];
      put.push({ at, width, height });
      node.style.left = `${share[i][0] * 100}%`;
      node.style.top = `${share[i][1] * 100}%`;
      node.style.transform = `translate(-50%, -50%) translate(${at[0] - points[i][0]}px, ${at[1] - points[i][1]}px)`;
    });
  },

  /** Level r is column r; an entry stands between the two that it comes from. */
  showPyramid() {
    const { levels } = Play.answer;
    const entries = levels.flatMap((level, r) =>
      level.map((one, i) => {
        const node = make("div", { class: `entry-cell${r === levels.length - 1 ? " last" : ""}`, role: "listitem" }, formula(one.label_latex), formula(one.latex));
        node.style.gridColumn = String(r + 1);
        node.style.gridRow = `${2 * i + r + 1} / span 2`;
        const mark = (on) => {
          byId("canvas").querySelector(`[data-entry="${r}-${i}"]`)?.classList.toggle("hot", on);
          if (r === 0) Play.handles[i + (Play.answer.first ?? 0)]?.classList.toggle("hot", on);
        };
        node.addEventListener("mouseenter", () => mark(true));
        node.addEventListener("mouseleave", () => mark(false));
        return node;
      }));
    byId("pyramid").replaceChildren(...entries);
  },

  showKnots() {
    const bar = byId("knots");
    const { knots } = Play.answer;
    byId("knot-row").hidden = !knots;
    if (!knots) return;
    const [low, high] = [knots[0].at, knots[knots.length - 1].at];
    const share = (at) => ((at - low) / (high - low)) * 100;
    while (Play.ticks.length > knots.length) Play.ticks.pop().remove();
    while (Play.ticks.length < knots.length) {
      const i = Play.ticks.length;
      const tick = make("button", { type: "button", class: "knot" }, make("span", {}));
      tick.addEventListener("pointerdown", (event) => Play.dragKnot(event, i));
      tick.addEventListener("keydown", (event) => {
        const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
        if (!step) return;
        event.preventDefault();
        Play.moveKnot(i, Play.answer.knots[i].at + step / Play.state.grid);
      });
      bar.append(tick);
      Play.ticks.push(tick);
    }
    const seen = new Map();
    knots.forEach((knot, i) => {
      const again = seen.get(knot.text) ?? 0;
      seen.set(knot.text, again + 1);
      const tick = Play.ticks[i];
      tick.style.left = `${share(knot.at)}%`;
      tick.style.setProperty("--again", String(again));
      tick.firstChild.textContent = again === 0 ? knot.text : "";
      tick.setAttribute("aria-label", say("knot_name", i, knot.text));
      // The ends of a clamped spline stay, so that its domain does.
      tick.disabled = i <= Play.answer.degree || i >= knots.length - 1 - Play.answer.degree;
    });
    byId("knot-t").style.left = `${share(Play.answer.t.at)}%`;
  },

  /** A knot stays between its neighbours. */
  moveKnot(i, value) {
    const { knots } = Play.answer;
    const { grid } = Play.state;
    const k = Math.round(value * grid);
    if (k / grid < knots[i - 1].at || k / grid > knots[i + 1].at) return;
    const fresh = [...Play.state.knots];
    fresh[i] = grid === 1 ? String(k) : `${k}/${grid}`;
    Play.change({ knots: fresh });
  },

  dragKnot(event, i) {
    const { knots } = Play.answer;
    const [low, high] = [knots[0].at, knots[knots.length - 1].at];
    followed(event, Play.ticks[i], byId("knots"), (x) => Play.moveKnot(i, low + x * (high - low)));
  },
};
