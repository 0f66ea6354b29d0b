// Compresses the module as the page carries it, and says its size: node pack.mjs MODULE. Too large a module fails.
import { gzip } from "@gfx/zopfli";
import { readFileSync, writeFileSync } from "node:fs";

/** Who opens the page over a telephone waits for it: 2 MiB at most. */
const MOST = 2 * 1024 * 1024;

const [, , path] = process.argv;
const module = readFileSync(path);
gzip(module, { numiterations: 5 }, (error, packed) => {
  if (error) throw error;
  writeFileSync(`${path}.gz`, packed);
  console.error(`build: ${path}: ${module.length} bytes, ${packed.length} compressed`);
  if (packed.length > MOST) {
    console.error(`build: more than ${MOST} bytes are too much for a page`);
    process.exit(1);
  }
});
