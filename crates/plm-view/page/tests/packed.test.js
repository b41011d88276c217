// The compiler in the playground's page: seven bits a letter, compressed by LZMA.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { undense } from "../src/dense.js";
import { unlzma } from "../src/lzma.js";

/** Is there the program? */
function hasXz() {
  try {
    execFileSync("xz", ["--version"]);
    return true;
  } catch {
    return false;
  }
}

const xz = (input, settings) => new Uint8Array(execFileSync("xz", ["--format=lzma", `--lzma1=preset=9e,${settings}`, "--stdout"], { input }));

/** Texts of all kinds: none, short, repeated, words, noise, and far apart. */
function samples() {
  let seed = 1;
  const random = () => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0) >>> 16;
  const noise = Uint8Array.from({ length: 40_000 }, random);
  const words = ["mass", "inertia", " ", "port", "(0, 1) m;", "\n"];
  const text = new TextEncoder().encode(Array.from({ length: 30_000 }, () => words[random() % words.length]).join(""));
  return [new Uint8Array(0), new Uint8Array([7]), new Uint8Array(300_000), text, noise, Uint8Array.from([...noise, ...text, ...noise])];
}

test("what xz has compressed comes back to the byte", { skip: hasXz() ? false : "skipped: xz is missing" }, () => {
  for (const bytes of samples()) {
    for (const settings of ["lc=4,pb=0", "lc=3,pb=2", "lc=0,lp=2,pb=4"]) assert.deepEqual(unlzma(xz(bytes, settings)), bytes);
  }
  const cut = xz(samples()[3], "lc=4,pb=0").slice(0, 900);
  assert.throws(() => unlzma(cut), /no LZMA/);
});

test("seven bits are a letter, and barred letters stand in pairs", () => {
  assert.deepEqual([...undense("")], []);
  // 1000001 1000010 1: A, B, and the rest.
  assert.deepEqual([...undense("AB@")], [0b10000011, 0b00001010]);
  // NUL with A after it; CR with nothing after it.
  assert.deepEqual([...undense(`${String.fromCharCode(0xa0 + 65)}@`)], [0b00000001, 0b00000110]);
  assert.deepEqual([...undense(`A${String.fromCharCode(0xa0 + 4 * 128)}`)], [0b10000010]);
});
