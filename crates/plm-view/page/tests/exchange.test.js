// One mechanism in the place of another.

import assert from "node:assert/strict";
import { test } from "node:test";
import { LiveMachine } from "../src/machine.js";

/** A link of 2 m, pinned to the ground at its centre of gravity: whatever it is asked for, it stays there and turns. */
function pinnedLink() {
  const memory = new WebAssembly.Memory({ initial: 1 });
  const numbers = new Float64Array(memory.buffer, 0, 7);
  const none = () => 0;
  return {
    memory,
    plm_read: none,
    plm_length: () => 7,
    plm_place: (/** @type {number} */ body, /** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ angle) => {
      numbers[3 + 6 * body] = angle;
      return Number.isFinite(x + y + angle) ? 1 : 0;
    },
    ...{ plm_trouble: none, plm_contacts: none, plm_size_names: none, plm_text_length: none, plm_shape: none, plm_shape_length: none },
    ...{ plm_parameter: none, plm_input: none },
  };
}

test("a link that is pinned at its centre of gravity turns to where it is dragged", () => {
  for (const goal of [0.1, 1.2, Math.PI / 2, -2.5]) {
    const machine = new LiveMachine(/** @type {any} */ (pinnedLink()), { parameters: 0, inputs: 0 }, () => {});
    machine.read();
    // In steps, as a pointer moves.
    for (let step = 1; step <= 8; step++) {
      const angle = (goal * step) / 8;
      machine.place(0, [1, 0], [1.5 * Math.cos(angle), 1.5 * Math.sin(angle)], 0);
    }
    assert.ok(Math.abs(machine.now[3] - goal) < 1e-3, `${machine.now[3]} for ${goal}`);
  }
});
