// Puts the page, its scripts, KaTeX with its fonts and the module into one HTML file: node bundle.mjs MODULE.xz PAGE
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

const [, , modulePath, pagePath] = process.argv;
const here = new URL(".", import.meta.url);
const read = (path) => readFileSync(new URL(path, here), "utf8");

// Faces that formulas of notes seldom need are not carried along: a browser makes bold and slanted ones of those that are there, and
// takes the system's letters for the others.
const LEFT_OUT = /KaTeX_(Main-BoldItalic|Main-Italic|Math-BoldItalic|Caligraphic-Bold|Fraktur-Bold|SansSerif-\w+|Typewriter-\w+)\./;
const FROM_SYSTEM = { KaTeX_SansSerif: ["Helvetica", "Arial", "Liberation Sans", "DejaVu Sans"], KaTeX_Typewriter: ["Courier New", "Liberation Mono", "DejaVu Sans Mono"] };

// Browsers that have WebAssembly with exceptions take fonts as woff2.
function katexStyle() {
  const style = read("node_modules/katex/dist/katex.min.css").replace(/@font-face\{[^}]*\}/g, (face) => (LEFT_OUT.test(face) ? "" : face));
  const carried = style.replace(/src:url\((fonts\/[\w-]+\.woff2)\)[^;}]*/g, (_, path) => {
    const font = readFileSync(new URL(`node_modules/katex/dist/${path}`, here)).toString("base64");
    return `src:url(data:font/woff2;base64,${font}) format("woff2")`;
  });
  const local = Object.entries(FROM_SYSTEM).map(([name, faces]) => `@font-face{font-family:${name};src:${faces.map((face) => `local("${face}")`).join(",")}}`);
  return [carried, ...local].join("");
}

const PARTS = ["words", "reasons", "problems", "translate", "show", "apart", "engine", "ask", "check", "play", "link", "warm", "main"];
const script = `"use strict";(() => {\n${PARTS.map((name) => read(`page/${name}.js`)).join("\n")}\n})();`;
const style = `${katexStyle()}\n${read("page/style.css")}`;
const katex = read("node_modules/katex/dist/katex.min.js");
const unpack = read("node_modules/xz-decompress/dist/package/xz-decompress.min.js");
const version = read("Cargo.toml").match(/^version = "(.*)"/m)[1];
const module = readFileSync(modulePath);

for (const [name, text] of Object.entries({ script, katex, unpack, worker: read("page/worker.js") })) {
  if (/<\/script|<!--/i.test(text)) throw new Error(`${name} cannot stand in a page: it would end its element`);
}
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const policy = [
  "default-src 'none'",
  `script-src ${hash(katex)} ${hash(unpack)} ${hash(script)} 'wasm-unsafe-eval'`,
  "worker-src blob:",
  `style-src ${hash(style)}`,
  "font-src data:",
  "img-src blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const values = { policy, style, katex, unpack, script, version, worker: read("page/worker.js"), module: module.toString("base64") };
const page = read("page/index.html").replace(/\{\{(\w+)\}\}/g, (_, name) => values[name]);
writeFileSync(pagePath, page);
// As a server sends it.
console.error(`build: ${pagePath}: ${Buffer.byteLength(page)} bytes, ${gzipSync(page, { level: 9 }).length} compressed by gzip`);
