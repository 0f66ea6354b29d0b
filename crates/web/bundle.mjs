// Puts the page, its scripts, KaTeX with its fonts and the module into one HTML file: node bundle.mjs MODULE.xz PAGE
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";

const [, , modulePath, pagePath] = process.argv;
const here = new URL(".", import.meta.url);
const read = (path) => readFileSync(new URL(path, here), "utf8");

// Browsers that have WebAssembly with exceptions take fonts as woff2.
function katexStyle() {
  const style = read("node_modules/katex/dist/katex.min.css");
  return style.replace(/src:url\((fonts\/[\w-]+\.woff2)\)[^;}]*/g, (_, path) => {
    const font = readFileSync(new URL(`node_modules/katex/dist/${path}`, here)).toString("base64");
    return `src:url(data:font/woff2;base64,${font}) format("woff2")`;
  });
}

const PARTS = ["words", "reasons", "problems", "translate", "show", "engine", "ask", "check", "play", "link", "warm", "main"];
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
console.error(`build: ${pagePath}: ${Buffer.byteLength(page)} bytes`);
