// The state of the page in the fragment of its address: JSON, deflated, in the letters of base64url.

/** A link unpacks to no more. */
const LONGEST_STATE = 1 << 20;

/** Browsers and mail programs cut longer ones. */
const LONGEST_LINK = 24 << 10;

const isText = (value, most) => typeof value === "string" && value.length <= most;
const isList = (value, most, each) => Array.isArray(value) && value.length <= most && value.every(each);
/** What the page writes for a number: a fraction, or sums and products of some while one is being computed. */
const isNumber = (value) => isText(value, 60) && /^[\d\s()+*/.-]+$/.test(value);

/** So many inputs of a link run by themselves, if they take no longer than this. */
const FEW_INPUTS = 8;
const SOON = 2000;

/** What a link may hold: a field and what its value must be. */
const FIELDS = {
  v: (value) => value === 1,
  lang: (value) => LANGUAGES.includes(value),
  ask: (value) => isList(value, 1000, (input) => isText(input, LONGEST_INPUT)),
  page: (value) => isText(value, LONGEST_PAGE),
  format: (value) => ["auto", "markdown", "latex", "rst", "notebook"].includes(value),
  play: (value) =>
    value !== null && typeof value === "object" && ["bezier", "bspline"].includes(value.kind) && [1, 2, 4, 12].includes(value.grid) &&
    isNumber(value.t) && Number.isInteger(value.degree) && isList(value.points, 40, (point) => isList(point, 2, isNumber)) &&
    isList(value.knots, 60, isNumber) && isList(value.ends, 2, isNumber),
};

class Broken extends Error {}

const Link = {
  wait: 0,
  ready: false,
  /** The fragment that was written last. */
  own: null,

  async packed(state) {
    const bytes = new TextEncoder().encode(JSON.stringify(state));
    const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    const packed = new Uint8Array(await new Response(stream).arrayBuffer());
    let raw = "";
    for (const byte of packed) raw += String.fromCharCode(byte);
    return btoa(raw).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  },

  /** The state of a fragment; throws `Broken` with the reason. */
  async unpacked(fragment) {
    if (!/^[\w-]+$/.test(fragment)) throw new Broken(say("link_foreign"));
    let text = "";
    try {
      const raw = atob(fragment.replaceAll("-", "+").replaceAll("_", "/"));
      const bytes = Uint8Array.from(raw, (c) => c.charCodeAt(0));
      const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
      const decoder = new TextDecoder("utf-8", { fatal: true });
      const reader = stream.getReader();
      for (;;) {
        const { done, value } = await reader.read();
        if (done) break;
        text += decoder.decode(value, { stream: true });
        if (text.length > LONGEST_STATE) throw new Broken(say("too_long", text.length >> 10, LONGEST_STATE >> 10));
      }
      text += decoder.decode();
    } catch (error) {
      throw error instanceof Broken ? error : new Broken(say("link_short"));
    }
    let state;
    try {
      state = JSON.parse(text);
    } catch {
      throw new Broken(say("link_short"));
    }
    if (state === null || typeof state !== "object" || Array.isArray(state) || state.v !== 1) throw new Broken(say("link_foreign"));
    for (const [name, value] of Object.entries(state)) {
      if (!Object.hasOwn(FIELDS, name) || !FIELDS[name](value)) throw new Broken(say("link_field", name));
    }
    return state;
  },

  state() {
    const page = byId("page").value;
    return {
      v: 1, lang, ask: Ask.inputs.slice(-1000),
      ...(page !== "" && page.length <= LONGEST_PAGE ? { page, format: byId("format").value } : {}),
      play: Play.state,
    };
  },

  changed() {
    if (!Link.ready) return;
    clearTimeout(Link.wait);
    Link.wait = setTimeout(() => Link.write(), 400);
  },

  async write() {
    const state = Link.state();
    let packed = await Link.packed(state);
    if (packed.length > LONGEST_LINK) {
      delete state.page;
      packed = await Link.packed(state);
    }
    Link.own = `#${packed}`;
    history.replaceState(null, "", Link.own);
    return state;
  },

  async copy(button) {
    const state = await Link.write();
    if (byId("page").value !== "" && !state.page) notice(say("link_long"));
    await copy(location.href, button);
  },

  /** Brings the page to the state of its address. */
  async read() {
    const fragment = location.hash.slice(1);
    if (fragment !== "") {
      try {
        await Link.apply(await Link.unpacked(fragment));
      } catch (error) {
        if (!(error instanceof Broken)) throw error;
        notice(make("strong", {}, say("link_broken")), " ", error.message);
      }
    }
    Link.ready = true;
  },

  async apply(state) {
    if (state.lang) {
      lang = state.lang;
      translate();
    }
    if (state.play) Play.load(state.play);
    if (state.page) Check.put(state.page, state.format ?? "auto");
    await Link.run(state.ask ?? []);
  },

  /** Inputs that somebody sent: a few run at once, more of them when they are wanted. */
  async run(inputs) {
    const began = performance.now();
    for (const [i, input] of inputs.entries()) {
      if (i >= FEW_INPUTS || performance.now() - began > SOON) {
        const rest = inputs.slice(i);
        const all = async () => {
          node.remove();
          for (const input of rest) await Ask.run(input);
        };
        const node = notice(say("link_many", rest.length), " ", make("button", { type: "button", class: "small", onclick: all }, say("link_run")));
        return;
      }
      await Ask.run(input);
    }
  },
};
