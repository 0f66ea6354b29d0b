// Takes a module apart as page/apart.js puts it together: node pack.mjs MODULE PACKED
import { readFileSync, writeFileSync } from "node:fs";

const [, , modulePath, packedPath] = process.argv;
const source = readFileSync(new URL("page/apart.js", import.meta.url), "utf8");
const { walk, assembled, STREAMS } = new Function(`"use strict"; ${source}; return { walk, assembled, STREAMS };`)();
// What is put together before the rest has come: smaller blocks are compiled sooner, larger ones compress better.
const BLOCK = 1 << 20;

const module = readFileSync(modulePath);
const parts = [];
function part(from, to, streams = Array(STREAMS).fill([])) {
  const head = Buffer.alloc(4 * (1 + STREAMS));
  [to - from, ...streams.map((stream) => stream.length)].forEach((size, i) => head.writeUInt32LE(size, 4 * i));
  parts.push(head, ...(to > from && streams.every((stream) => stream.length === 0) ? [module.subarray(from, to)] : streams.map((stream) => Buffer.from(stream))));
}
function number(at) {
  let value = 0;
  for (let unit = 1; ; unit *= 128) {
    const byte = module[at++];
    value += (byte & 127) * unit;
    if (byte < 128) return [value, at];
  }
}

const CODE = 10;
let done = 0;
for (let at = 8; at < module.length; ) {
  const [size, begin] = number(at + 1);
  const end = begin + size;
  if (module[at] === CODE) {
    let [functions, from] = number(begin);
    part(done, from);
    for (let to = from; to < end; from = to) {
      while (to < end && to - from < BLOCK) {
        const [length, body] = number(to);
        to = body + length;
      }
      const streams = Array.from({ length: STREAMS }, () => []);
      let read = from;
      walk(to - from, (stream) => {
        streams[stream].push(module[read]);
        return module[read++];
      });
      part(from, to, streams);
    }
    done = end;
  }
  at = end;
}
part(done, module.length);

const packed = Buffer.concat(parts);
const again = await new Response(new Blob([packed]).stream().pipeThrough(assembled())).arrayBuffer();
if (!module.equals(Buffer.from(again))) throw new Error("the module is not the same when it is put together again");
writeFileSync(packedPath, packed);
