// Undoing what was set, pulled and placed of a live mechanism: its state comes back to the bit.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { App } from "../src/app.js";
import { Live } from "../src/live.js";
import { LiveMachine } from "../src/machine.js";
import { fourBarHead, modulePath, nativeRows, runOfRows, withoutModule } from "./support/live.js";
import { makeNpz } from "./support/npz.js";

/**
 * A page of the four-bar whose machine answers at once.
 */
async function livePage(t) {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const { instance } = await WebAssembly.instantiate(readFileSync(modulePath()), {});
  const app = new App();
  await app.load(new Uint8Array(makeNpz([runOfRows(fourBarHead(), nativeRows().slice(0, 1))])));
  const worker = { onmessage: null, postMessage: (message) => obey(message) };
  const machine = new LiveMachine(instance.exports, { parameters: 2, inputs: 1 }, (data) => worker.onmessage({ data }));
  const obey = (message) => {
    const { kind } = message;
    if (kind === "parameter" || kind === "input") machine.set(kind, message.index, message.value);
    else if (kind === "restart" || kind === "reset") machine.begin(kind);
    else if (kind === "pull") machine.setPull(message.pull);
    else if (kind === "place") machine.place(message.body, message.point, message.target, message.turn);
    else if (kind === "keep") machine.keep(message.id);
    else if (kind === "return") machine.comeBack(message.id);
    else if (kind === "step") {
      for (let left = message.count; left > 0; left--) machine.step(message.dt);
      machine.flush();
    }
  };
  app.live = new Live(app, app.run.head, new Uint8Array(0), worker);
  app.live.show();
  machine.begin("restart");
  return { app, live: app.live, machine };
}

const bits = (numbers) => [...new BigUint64Array(Float64Array.from(numbers).buffer)];
const PULL = { body: 0, point: [0.5, 0], target: [0, 3], stiffness: 300, damping: 1, force: null };

test("a pulled state comes back to the bit, and goes on as it went", { skip: withoutModule }, async (t) => {
  const { app, live, machine } = await livePage(t);
  live.step(0.01, 50);
  const before = bits(machine.now);
  live.step(0.01, 20);
  const went = bits(machine.now);
  // The same again, with a pull.
  live.restart();
  live.step(0.01, 50);
  assert.deepEqual(bits(machine.now), before);
  live.pull(PULL);
  live.pull({ ...PULL, target: [1, 3] });
  live.step(0.01, 30);
  live.pull(null);
  // Without the force, which the reactions of the last row still had.
  const pulled = bits(machine.read());
  assert.notDeepEqual(pulled.slice(1), went.slice(1));
  app.history.undo();
  assert.deepEqual(bits(machine.now), before);
  assert.equal(live.run.rows, 51, "rows after that moment are gone");
  assert.equal(live.run.end, machine.now[0]);
  live.step(0.01, 20);
  assert.deepEqual(bits(machine.now), went, "no force is left");
  app.history.redo();
  assert.deepEqual(bits(machine.now), pulled);
  assert.deepEqual(app.history.done.map(({ name }) => name), ["restart", `pull ${live.mechanism.bodies[0].name}`]);
});

test("a placement, a restart and a reset are undone, with the rows that are still known", { skip: withoutModule }, async (t) => {
  const { app, live, machine } = await livePage(t);
  live.step(0.01, 30);
  const before = bits(machine.now);
  const angle = machine.now[3] + 0.2;
  for (let step = 1; step < 5; step++) live.place(0, [0.5, 0], [Math.cos(angle + 0.02 * step), Math.sin(angle + 0.02 * step)]);
  const placed = bits(machine.now);
  assert.equal(live.run.rows, 1);
  assert.equal(app.history.done.length, 1, "one drag is one deed");
  live.set("parameter", 0, 0.41);
  live.reset();
  assert.deepEqual(live.settings.parameter[0], live.mechanism.parameters[0].default);
  app.history.undo();
  assert.equal(live.settings.parameter[0], 0.41, "a reset gives back what was set");
  app.history.undo();
  assert.equal(live.settings.parameter[0], live.mechanism.parameters[0].default);
  app.history.undo();
  assert.deepEqual(bits(machine.now), before);
  assert.deepEqual([live.run.rows, live.run.end], [1, machine.now[0]], "between the placed start and that moment nothing is drawn");
  app.history.redo();
  assert.deepEqual(bits(machine.now), placed);
});

test("one drag is one deed, however slow; the next one is another", { skip: withoutModule }, async (t) => {
  const { app, live, machine } = await livePage(t);
  const angle = machine.now[3];
  const clock = t.mock.method(performance, "now", () => 5000 * (clock.mock.callCount() + 1));
  for (let drags = 1; drags < 3; drags++) {
    app.drag = { kind: "place", body: 0, point: [0.5, 0], target: [0, 0], reach: null };
    for (let step = 1; step < 4; step++) live.place(0, [0.5, 0], [Math.cos(angle + 0.05 * step), Math.sin(angle + 0.05 * step)]);
    app.drag = null;
    assert.equal(app.history.done.length, drags);
  }
});

test("values that were set go back and forth; a slider that is drawn is one deed", { skip: withoutModule }, async (t) => {
  const { app, live } = await livePage(t);
  const usual = live.settings.parameter[0];
  for (const value of [0.4, 0.41, 0.42]) live.set("parameter", 0, value);
  live.set("input", 0, 3);
  assert.deepEqual(app.history.done.map(({ kind, from, to }) => [kind, from, to]), [["set", usual, 0.42], ["set", 0, 3]]);
  app.history.undo();
  assert.equal(live.settings.input[0], 0);
  app.history.undo();
  assert.equal(live.settings.parameter[0], usual);
  app.history.redo();
  app.history.redo();
  assert.deepEqual([live.settings.parameter[0], live.settings.input[0]], [0.42, 3]);
  assert.match(app.messages.at(-1).text, /^Done again: .* = 3/);
});

test("what a program serves is set again, and its states are its own", () => {
  const app = new App();
  const sent = [];
  const head = { name: "m", mechanism: { name: "M", bodies: [], ground: [], parts: [], parameters: [], inputs: [{ name: "u", unit: "", factor: 1 }] }, columns: [], events: [], fault: null };
  app.live = new Live(app, head, new Uint8Array(0), { postMessage: (message) => sent.push(message), onmessage: null });
  app.live.isInPage = false;
  app.live.settings.input = [1];
  app.live.restart();
  app.live.set("input", 0, 2);
  assert.ok(sent.every(({ kind }) => kind !== "keep"), JSON.stringify(sent));
  assert.deepEqual(app.history.done.map(({ kind }) => kind), ["set"]);
});
