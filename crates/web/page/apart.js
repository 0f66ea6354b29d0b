// A module in the order in which it compresses best: of some hundred functions at a time, first all their opcodes, then all indices of
// their variables, and so on. It is put together again as it is unpacked, block by block; pack.mjs takes it apart.

/** Where the bytes of each kind go: opcodes with what stands in few bits, variables, constants, offsets, calls, and the rest. */
const STREAMS = 7;
const [OPCODE, VARIABLE, INTEGER, OFFSET, CALL, FLOAT, REST] = Array(STREAMS).keys();

/** The streams of the numbers behind an opcode. */
const NUMBERS = Array(256);
const behind = (from, to, ...streams) => NUMBERS.fill(streams, from, to + 1);
behind(0x00, 0x01); // unreachable, nop
behind(0x02, 0x04, OPCODE); // block, loop, if
behind(0x05, 0x05); // else
behind(0x06, 0x09, OPCODE); // try, catch, throw, rethrow
behind(0x0b, 0x0b); // end
behind(0x0c, 0x0d, OPCODE); // br, br_if
behind(0x0f, 0x0f); // return
behind(0x10, 0x10, CALL);
behind(0x11, 0x11, REST, REST); // call_indirect
behind(0x18, 0x18, OPCODE); // delegate
behind(0x19, 0x1b); // catch_all, drop, select
behind(0x20, 0x22, VARIABLE);
behind(0x23, 0x24, OPCODE); // global.get, global.set
behind(0x28, 0x3e, OPCODE, OFFSET); // loads and stores: alignment, offset
behind(0x3f, 0x40, OPCODE); // memory.size, memory.grow
behind(0x41, 0x41, INTEGER);
behind(0x42, 0x42, REST); // i64.const
behind(0x45, 0xc4); // arithmetic
behind(0xd0, 0xd2, REST); // references
/** The same of what follows the opcode 0xfc, by its number. */
const EXTENDED = [0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 2, 1, 2, 1, 2, 1, 1, 1];

/** Goes through functions of `length` bytes in all; `move` moves the next byte of a stream, and returns it. */
function walk(length, move) {
  let at = 0;
  const byte = (stream) => {
    at++;
    return move(stream);
  };
  const number = (stream) => {
    let read = byte(stream);
    let value = read & 127;
    for (let unit = 128; read > 127; unit *= 128) {
      read = byte(stream);
      value += (read & 127) * unit;
    }
    return value;
  };
  const several = (count, read, stream) => {
    for (; count > 0; count--) read(stream);
  };
  while (at < length) {
    const size = number(REST);
    const end = at + size;
    for (let kinds = number(REST); kinds > 0; kinds--) {
      number(REST);
      byte(REST);
    }
    while (at < end) {
      const opcode = byte(OPCODE);
      const streams = NUMBERS[opcode];
      if (streams) for (let i = 0; i < streams.length; i++) number(streams[i]);
      else if (opcode === 0x0e) several(number(REST) + 1, number, REST); // br_table
      else if (opcode === 0x43) several(4, byte, FLOAT);
      else if (opcode === 0x44) several(8, byte, FLOAT);
      else if (opcode === 0xfc) several(EXTENDED[number(OPCODE)], number, OPCODE);
      else throw new Error(`no instruction of the module begins with 0x${opcode.toString(16)}`);
    }
    if (at !== end) throw new Error("a function of the module does not end where it says");
  }
}

/** A block begins with how many bytes it stands for, and how many each stream has; without streams they follow as they are. */
const HEAD = 4 * (1 + STREAMS);

/** The bytes that a block stands for. */
function together(length, sizes, block) {
  const total = sizes.reduce((sum, size) => sum + size, 0);
  if (total === 0) return block;
  const bytes = new Uint8Array(length);
  let written = 0;
  let begin = 0;
  const next = Uint32Array.from(sizes, (size) => (begin += size) - size);
  walk(length, (stream) => (bytes[written++] = block[next[stream]++]));
  return bytes;
}

/** A stream that takes blocks in pieces of any size, and gives the module. */
function assembled() {
  let waiting = new Uint8Array(0);
  return new TransformStream({
    transform(piece, out) {
      const joined = new Uint8Array(waiting.length + piece.length);
      joined.set(waiting);
      joined.set(piece, waiting.length);
      let at = 0;
      while (joined.length - at >= HEAD) {
        const head = new DataView(joined.buffer, at, HEAD);
        const [length, ...sizes] = Array.from({ length: 1 + STREAMS }, (_, i) => head.getUint32(4 * i, true));
        const size = sizes.reduce((sum, size) => sum + size, 0) || length;
        if (joined.length - at - HEAD < size) break;
        at += HEAD;
        out.enqueue(together(length, sizes, joined.subarray(at, at + size)));
        at += size;
      }
      waiting = joined.subarray(at);
    },
  });
}
