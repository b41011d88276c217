// Values between their unit and SI: what a declaration says is shown, and what is typed is what a declaration would have.

import assert from "node:assert/strict";
import { test } from "node:test";
import { forceField } from "../src/arrows.js";
import { rangeAround } from "../src/dials.js";
import { valueOf } from "../src/settings.js";
import { fromSi, toSi } from "../src/numbers.js";
import { readResults } from "../src/results.js";
import { Scene } from "../src/scene.js";
import { makeNpz } from "./support/npz.js";
import { doublePendulum } from "./support/scenes.js";

/** Units that are a power of ten of SI's, by their exponents: um^2, mm^2, cm^2, mm, cm, kN, bar, MPa. */
const DECIMAL = [-12, -6, -4, -3, -2, 3, 5, 6];
/** Those of which π is a part, or 60. */
const OTHERS = [Math.PI / 180, 2 * Math.PI, (2 * Math.PI) / 60, 1 / 60_000, 60, 3600];

/** Decimals of one to seven digits, as people write them. */
function* decimals(count) {
  const seed = 20261124;
  console.log(`seed ${seed}`);
  let state = seed;
  const random = (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
  for (let k = 0; k < count; k++) {
    const digits = 1 + random(7);
    const shift = random(5);
    yield `${random(2) === 0 ? "-" : ""}${1 + random(10 ** digits)}e-${shift}`;
  }
}

test("350 mm is 0.35 m, and is shown so", () => {
  assert.equal(toSi(350, 1e-3), 0.35);
  assert.equal(fromSi(0.35, 1e-3), 350);
  assert.deepEqual(rangeAround(fromSi(0.35, 1e-3), 1), { low: 0, high: 700, step: 3.5 });
});

test("decimals in decimal units come back, to the bit", () => {
  let naive = 0;
  for (const text of decimals(4000)) {
    const [digits, shift] = text.split("e");
    for (const exponent of DECIMAL) {
      const factor = Number(`1e${exponent}`);
      // A text is read to the nearest number: what the compiler makes of the declaration.
      const declared = Number(`${digits}e${Number(shift) + exponent}`);
      assert.equal(fromSi(declared, factor), Number(text), `${text} times ${factor}`);
      // Up to the rounding of the decimal itself where the unit is larger than SI's.
      if (factor < 1 && Number.isInteger(Number(text))) assert.equal(toSi(Number(text), factor), declared, `${text} times ${factor}`);
      naive += Number(Number(text) * factor !== declared);
    }
  }
  assert.ok(naive > 1000 && fromSi(0, 1e-3) === 0, `${naive}: the plain product would do`);
});

test("decimals in any unit are shown as they were typed, and the usual value is restored", () => {
  for (const text of decimals(4000)) {
    const value = Number(text);
    for (const factor of OTHERS) {
      assert.equal(fromSi(toSi(value, factor), factor), value, `${text} times ${factor}`);
      // Rounded in another order, as a compiler may do it.
      const declared = 1 / (1 / factor / value);
      assert.equal(fromSi(declared, factor), value, `${text} times ${factor}`);
      assert.equal(valueOf(value, factor, declared), declared);
    }
  }
  for (const none of [NaN, Infinity]) assert.ok(Object.is(fromSi(none, 1e-3), none));
});

test("arrows of forces are in newtons, whatever the unit of a column", async () => {
  const largest = async (/** @type {{unit: string, factor?: number}} */ force, /** @type {number} */ scale) => {
    const run = doublePendulum({ end: 1 });
    const { columns } = run.head;
    const isForce = columns.map(({ unit }) => unit === "N");
    run.values = run.values.map((value, index) => (isForce[index % columns.length] ? value * scale : value));
    run.head.columns = columns.map((column, index) => (isForce[index] ? { ...column, ...force } : column));
    const { runs } = await readResults(new Uint8Array(makeNpz([run])));
    return forceField(new Scene(runs[0])).largest;
  };
  const newton = await largest({ unit: "N" }, 1);
  const kilonewton = await largest({ unit: "kN", factor: 1000 }, 1e-3);
  assert.ok(newton > 100 && Math.abs(kilonewton - newton) < 1e-9 * newton, `${newton} ${kilonewton}`);
});
