// Runs a bare program that is WebAssembly: node tests/wasm.mjs PROGRAM
import { readFileSync, writeSync } from "node:fs";

let memory;
const machine = {
  write: (text, length) => writeSync(1, new Uint8Array(memory.buffer, text, length)),
  end: (code) => { throw new Error(`ended with ${code}`); },
};
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), { machine });
memory = instance.exports.memory;
process.exitCode = instance.exports.program();
