// Elements, formulas and messages. What comes from outside is always text, never markup.

/** An element: `make("p", {class: "a"}, "text", child)`. */
function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

const SVG = "http://www.w3.org/2000/svg";

function draw(tag, attributes = {}) {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  return node;
}

const formulas = new Map();

/** A formula set by KaTeX; its text if KaTeX cannot. */
function formula(latex, display = false, fallback = latex) {
  const key = (display ? "d" : "i") + latex;
  if (!formulas.has(key)) {
    const node = make(display ? "div" : "span", { class: display ? "formula display" : "formula" });
    try {
      katex.render(latex, node, { displayMode: display, throwOnError: true, strict: "ignore", trust: false, maxExpand: 1000 });
    } catch {
      node.replaceChildren(make("code", {}, fallback));
    }
    if (formulas.size > 3000) formulas.clear();
    formulas.set(key, node);
  }
  return formulas.get(key).cloneNode(true);
}

/** Pieces of words and formulas. */
const sentence = (pieces) => pieces.map((piece) => (piece.latex ? formula(piece.latex) : piece.words));

/** A picture as an image: nothing in it can run. */
function picture(svg, title) {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  const image = make("img", { class: "picture", alt: title, src: address });
  image.addEventListener("load", () => URL.revokeObjectURL(address));
  return image;
}

/** Copies a text, or shows it for copying where the browser does not allow that. */
async function copy(text, button) {
  try {
    await navigator.clipboard.writeText(text);
    const before = button.textContent;
    button.textContent = say("copied");
    announce(say("copied"));
    setTimeout(() => (button.textContent = before), 1200);
  } catch {
    const area = make("textarea", { readonly: true, rows: "12", "aria-label": say("copy_by_hand") });
    area.value = text;
    const close = make("button", { class: "quiet", onclick: () => dialog.close() }, say("close"));
    const dialog = make("dialog", {}, make("p", {}, say("copy_by_hand")), area, close);
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
    area.select();
  }
}

const copier = (name, text) => {
  const button = make("button", { class: "quiet", type: "button" }, say(name));
  button.addEventListener("click", () => copy(text, button));
  return button;
};

/** Says something to screen readers. */
function announce(words) {
  document.getElementById("live").textContent = words;
}

/** A line at the top of the page, until it is closed. */
function notice(...lines) {
  const close = make("button", { class: "quiet", type: "button", onclick: () => node.remove() }, say("close"));
  const node = make("div", { class: "notice", role: "alert" }, make("p", {}, ...lines), close);
  document.getElementById("notices").append(node);
  return node;
}

const lost = (error) => (error.kind === "stopped" ? say("stopped") : say("trapped", error.message));

const byId = (id) => document.getElementById(id);
