// The sentences of verdicts in the languages of the page: node test/reasons.mjs MODULE
// What the table has is said by the library, and what the library says of the pages of its own tests stands in the table,
// but for a few.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { runInNewContext } from "node:vm";
import { load } from "./load.mjs";

const root = new URL("../../../", import.meta.url);
const page = (name) => readFileSync(new URL(`crates/web/page/${name}.js`, root), "utf8");
const parts = ["words", "reasons", "problems", "translate"].map(page).join("\n");
const { REASONS, CODES, LANGUAGES, WORDS, translated } = runInNewContext(
  `const navigator = { language: "zh-CN" }; ${parts} ({ REASONS, CODES, LANGUAGES, WORDS, translated })`);

for (const [name, words] of Object.entries(WORDS)) {
  assert.ok(typeof words === "string" || words.length === LANGUAGES.length, `${name} is said in every language`);
}

const sources = ["src", "crates/web/src"]
  .flatMap((folder) => readdirSync(new URL(folder, root), { recursive: true }).map((file) => `${folder}/${file}`))
  .filter((file) => /\.(rs|txt)$/.test(file))
  .map((file) => readFileSync(new URL(file, root), "utf8"))
  .join("\n");
// A sentence may be put together of several: its parts are looked for.
const fragments = (english) => english.split("{}").map((part) => part.replace(/^[,\s]*(is )?/, "").trim()).filter((part) => /\p{L}{3}/u.test(part));
const gone = Object.values(REASONS).flat().map(([english]) => english).filter((english) => !fragments(english).every((part) => sources.includes(part)));
assert.deepEqual(gone, [], "the library no longer says this");

const codes = readFileSync(new URL("src/language/diagnostic/code.rs", root), "utf8").match(/(?<= = ")E\d+(?=": ")/g);
for (const [language, names] of Object.entries(CODES)) assert.deepEqual(Object.keys(names), codes, `each code has a name: ${language}`);

// What is wrong in the queries of the library's own tests: most of it is a sentence here.
const errors = new URL("tests/corpus/errors/", root);
const messages = readdirSync(errors).flatMap((file) => readFileSync(new URL(file, errors), "utf8").match(/(?<=^(?:error|note|warning)\[E\d+\]: ).*/gm) ?? []);
const known = messages.filter((message) => translated(message) !== null).length;
if (process.env.SHOW) console.log(messages.filter((message) => translated(message) === null).join("\n"));
console.log(`${messages.length} messages, ${known} of them in Chinese; the others stand behind the name of their code`);
assert.ok(known * 2 > messages.length, "half of the messages");

const answer = await load(process.argv[2]);
const missing = new Map();
let count = 0;
const notes = new URL("tests/corpus/notes/", root);
for (const file of readdirSync(notes).filter((file) => /^\d.*\.(md|tex)$/.test(file))) {
  const as = file.endsWith(".tex") ? "latex" : "markdown";
  const { formulas } = answer({ do: "check", text: readFileSync(new URL(file, notes), "utf8"), as });
  for (const { reason, witness, instances, warning, notes } of formulas) {
    for (const sentence of [reason, witness, instances, warning, ...notes].filter(Boolean)) {
      count++;
      if (translated(sentence) === null) missing.set(sentence, file);
    }
  }
}
for (const [sentence, file] of missing) console.log(`  not in Chinese (${file}): ${sentence}`);
console.log(`${count} sentences of verdicts, ${missing.size} of them not in Chinese`);
// A new one is shown in English until it stands in the table.
assert.ok(count > 1000 && missing.size * 100 < count, "one in a hundred is missing");
