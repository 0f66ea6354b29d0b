// The module under Node: requests and answers as objects.
import { readFileSync } from "node:fs";

export async function load(path) {
  let argument, result, exports;
  const bytes = (at, length) => new Uint8Array(exports.memory.buffer, at, length);
  const host = {
    wasm_minimal_protocol_write_args_to_buffer: (at) => bytes(at, argument.length).set(argument),
    wasm_minimal_protocol_send_result_to_host: (at, length) => (result = Buffer.from(bytes(at, length)).toString()),
  };
  ({ exports } = (await WebAssembly.instantiate(readFileSync(path), { typst_env: host })).instance);
  return (request) => {
    argument = new TextEncoder().encode(JSON.stringify(request));
    const status = exports.answer(argument.length);
    if (status !== 0) throw new Error(result);
    return JSON.parse(result);
  };
}
