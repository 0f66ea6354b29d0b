// One instance of the module. A message is {module} or {id, request}; an answer {id, answer} or {id, trap}, and before it
// {id, partial} for what was found so far.
"use strict";
let exports = null;
let argument = null;
let result = null;
let current = null;

const bytes = (at, length) => new Uint8Array(exports.memory.buffer, at, length);

// The functions that Typst gives to its plugins; the module needs no others.
const host = {
  typst_env: {
    wasm_minimal_protocol_write_args_to_buffer: (at) => bytes(at, argument.length).set(argument),
    wasm_minimal_protocol_send_result_to_host: (at, length) => {
      result = new TextDecoder().decode(bytes(at, length));
      if (result.endsWith('"partial":true}')) self.postMessage({ id: current, partial: JSON.parse(result) });
    },
  },
};

function answered(request) {
  argument = new TextEncoder().encode(JSON.stringify(request));
  if (exports.answer(argument.length) !== 0) throw new Error(result);
  return JSON.parse(result);
}

self.onmessage = ({ data }) => {
  if (data.module) {
    exports = new WebAssembly.Instance(data.module, host).exports;
    return;
  }
  current = data.id;
  try {
    self.postMessage({ id: data.id, answer: answered(data.request) });
  } catch (error) {
    // The memory of an instance that trapped is not to be trusted.
    self.postMessage({ id: data.id, trap: String(error && error.message ? error.message : error) });
  }
};
