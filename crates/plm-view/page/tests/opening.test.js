// What a page shows before anybody has chosen: its path, its units, what its address says of parameters.

import assert from "node:assert/strict";
import { test } from "node:test";
import { tellingPoint } from "../src/opening.js";
import { readResults } from "../src/results.js";
import { changedSettings, showSettings } from "../src/settings.js";
import { scaleOf } from "../src/units.js";
import { makeNpz } from "./support/npz.js";
import { doublePendulum, workshop } from "./support/scenes.js";

const runOf = async (made) => (await readResults(new Uint8Array(makeNpz([made])))).runs[0];

test("the path is of a declared position, else of a free end that goes far", async () => {
  assert.equal(tellingPoint(await runOf(doublePendulum())), "forearm.tip");
  const declared = doublePendulum();
  declared.head.columns[0] = { name: "arm.p12.position.x", unit: "mm" };
  assert.equal(tellingPoint(await runOf(declared)), "arm.p12");
  const centre = doublePendulum();
  centre.head.columns[0] = { name: "arm.x", unit: "m" };
  assert.equal(tellingPoint(await runOf(centre)), "arm.G");
  const run = await runOf(workshop());
  const body = run.mechanism.bodies.find(({ name }) => tellingPoint(run).startsWith(`${name}.`));
  assert.ok(body !== undefined, tellingPoint(run));
  assert.equal(tellingPoint(null), null);
});

test("what has no unit of its own is shown in declared ones", async () => {
  const run = await runOf(doublePendulum());
  assert.deepEqual(scaleOf(run, "arm.tip.x", "m"), { unit: "mm", factor: 1e-3 });
  assert.deepEqual(scaleOf(run, "arm.omega", "rad/s"), { unit: "deg/s", factor: Math.PI / 180 });
  assert.deepEqual(scaleOf(run, "shoulder.force.x", "N"), { unit: "N", factor: 1 });
  assert.deepEqual(scaleOf(run, "inertia", "kg*m^2"), { unit: "kg*m^2", factor: 1 });
  const column = run.quantities().find(({ name }) => name === "forearm.x");
  assert.equal(column.unit, "mm");
  assert.ok(Math.abs(column.read(3) - 1e3 * run.poses.at(3, 6)) < 1e-9);
});

test("an address names what is not as declared, and restores it to the bit", () => {
  const mechanism = {
    parameters: [{ name: "rod", unit: "mm", factor: 1e-3, default: 0.08 }, { name: "mass", unit: "kg", factor: 1, default: 2 }],
    inputs: [{ name: "torque", unit: "N*m", factor: 1, default: 0.5 }, { name: "plm_pull_0_x", unit: "N", factor: 1, default: 0 }],
  };
  const live = {
    isInPage: true,
    mechanism,
    settings: { parameter: [0.35, 2], input: [-2.5, 7] },
    set(kind, index, value) {
      this.settings[kind][index] = value;
    },
  };
  assert.deepEqual(changedSettings({ live }), [["p.rod", "350"], ["i.torque", "-2.5"]]);
  showSettings({ live }, new URLSearchParams("p.rod=80&p.mass=3.25&t=1"));
  assert.deepEqual(live.settings, { parameter: [0.08, 3.25], input: [0.5, 7] });
  showSettings({ live }, new URLSearchParams("p.mass=nonsense"));
  assert.deepEqual(live.settings.parameter, [0.08, 3.25], "what is no number is left");
  assert.deepEqual(changedSettings({ live: { ...live, isInPage: false } }), [], "a program that serves the page is set by itself");
});
