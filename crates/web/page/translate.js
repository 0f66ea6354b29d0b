// What the library says, in the language of the page: the sentences of reasons.js and problems.js, and what finds them.

/** The sentences of a language with what finds them, the more telling ones first. */
const READERS = Object.fromEntries(Object.entries(REASONS).map(([language, table]) => {
  const plain = (text) => text.replace(/[.*+?^$|()[\]\\]/g, "\\$&");
  const readers = table.map(([english, said]) => {
    const parts = english.split("{}");
    // In "sigma_{i,n}" braces are no holes.
    return { find: new RegExp(`^${parts.map((part) => plain(part).replace(/[{}]/g, "\\$&")).join("((?:(?!; ).)+?)")}$`, "su"), said, told: parts.join("").length };
  });
  return [language, readers.sort((a, b) => b.told - a.told)];
}));

/** A sentence in the language of the page, or nothing if it is not known there. */
function translated(sentence) {
  for (const { find, said } of READERS[lang]) {
    const found = find.exec(sentence);
    if (!found) continue;
    const holes = found.slice(1).map((hole) => translated(hole) ?? hole);
    let next = 0;
    return said.replace(/\{(\d?)\}/g, (_, number) => holes[number ? number - 1 : next++]);
  }
  const pieces = sentence.split("; ");
  if (pieces.length < 2) return null;
  const told = pieces.map(translated);
  return told.includes(null) ? null : told.join(";");
}

/** What the library says, in the language of the page where the page has words for it. */
const told = (sentence) => (READERS[lang] && sentence ? translated(sentence) ?? sentence : sentence);
