// The module under Node: answers, limits, and the verdicts of the program on the same page.
//   node test/module.mjs MODULE [PROGRAM]
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { load } from "./load.mjs";

const [, , path, program] = process.argv;
const answer = await load(path);

const ask = (input, session) => answer({ do: "ask", input, session });

// The module needs nothing but the protocol of Typst's plugins.
assert.deepEqual(
  [...new Set(WebAssembly.Module.imports(new WebAssembly.Module(readFileSync(path))).map((one) => one.module))],
  ["typst_env"],
);

assert.equal(ask("f := polar(t^2 + 2t)").answers[0].text, "f(t1, t2) = t1 t2 + (t1 + t2)");
assert.equal(ask("f(0, 1/2)").answers[0].latex, "\\frac{1}{2}");

// Every kind of limit unwinds, and the session is as before.
for (const [input, code] of [["2^(10^9)", "E403"], ["expand((x+y+z+w)^60)", "E402"], ["(t+1)^1000000000", "E402"]]) {
  assert.equal(ask(input).problem.code, code, input);
  assert.equal(ask("f(1, 1)").answers[0].text, "3");
}
const endless = "n! for n in 0..10^9";
assert.ok(ask(endless).problem, endless);
ask("g(n) := g(n-1)");
assert.match(ask("g(3)").problem.message, /nested|deep/);
// A request that brings its session does not see that of others.
assert.equal(ask("f(0, 1)", []).answers.length, 0);
assert.equal(ask("f(0, 1)", ["f := polar(t)^2 + 1", "f := polar(t^2)"]).answers[0].text, "0");

if (program) {
  const pages = ["../../examples/slides.md", ...(process.env.PAGES ?? "").split(":").filter(Boolean)];
  for (const page of pages) {
    const file = page.startsWith("../") ? new URL(`../${page}`, import.meta.url).pathname : page;
    const as = /\.(tex|latex)$/.test(file) ? "latex" : "markdown";
    let native;
    let begin = performance.now();
    try {
      native = execFileSync(program, ["notes", "check", file, "--report", "json"], { maxBuffer: 1 << 26, stdio: ["ignore", "pipe", "ignore"] });
    } catch (error) {
      native = error.stdout;
    }
    const nativeTime = performance.now() - begin;
    begin = performance.now();
    const report = answer({ do: "check", text: readFileSync(file, "utf8"), as, name: file });
    const time = performance.now() - begin;
    const expected = JSON.parse(native);
    const without = (formulas) => formulas.map(({ from, to, fixes, typst, suggestion_typst, ...rest }) => rest);
    assert.deepEqual(without(report.formulas), expected.files[0].formulas, `${page}: the same verdicts`);
    assert.deepEqual(report.summary, expected.summary);
    console.log(`${page}: ${report.formulas.length} formulas, ${Math.round(time)} ms; the program ${Math.round(nativeTime)} ms`);
  }
}
console.log("the module answers as it should");
