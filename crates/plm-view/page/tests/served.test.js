// A served page, without a browser and without a program: what comes in, what goes out.

import assert from "node:assert/strict";
import { test } from "node:test";
import { App } from "../src/app.js";
import { commandsOf } from "../src/commands.js";
import { Program } from "../src/program.js";
import { ServedLive } from "../src/servedlive.js";
import { headOf } from "./support/scenes.js";

const mechanism = {
  name: "M",
  bodies: [{ name: "b", mass: 2, inertia: 0.5, depth: 0, ports: [], contour: null }],
  inputs: [{ name: "force", unit: "N", factor: 1, exponents: [1, 1, -2, 0, 0, 0, 0], default: 0 }],
};
const head = () => headOf(mechanism, { columns: [{ name: "b.angle", unit: "rad" }] });
const hello = (run = "1", more = {}) => ({ kind: "hello", run, pulls: false, about: { ...head(), ...more } });

/** A stream of events that the test speaks for. */
function stream() {
  const source = { onmessage: null, onerror: null, isOpen: true, close: () => (source.isOpen = false) };
  const say = (message) => source.onmessage({ data: JSON.stringify(message) });
  return { source, say };
}

const rowAt = (time) => [time, 0.1 * time, 0, time, 0.1, 0, 1, time];
const rows = (...times) => ({ kind: "rows", width: 8, numbers: times.flatMap(rowAt) });
const began = (time) => ({ kind: "began", numbers: rowAt(time), isAssembled: true });

/** Until all that was promised is done. */
const settled = () => new Promise((done) => setImmediate(done));

async function listening(pulls = false) {
  const streams = [];
  const sent = [];
  const connect = () => {
    streams.push(stream());
    return streams.at(-1).source;
  };
  const program = new Program(connect, async (body) => void sent.push(JSON.parse(body)));
  const greeting = program.open();
  streams[0].say(hello());
  streams[0].say(began(0));
  assert.equal((await greeting).run, "1");
  const app = new App();
  const live = new ServedLive(app, head(), program, pulls);
  app.live = live;
  live.show();
  await settled();
  return { app, live, program, streams, sent };
}

test("rows that come in are rows of the run, and numbers that are none stay none", async () => {
  const { live, streams } = await listening();
  streams[0].say(rows(0.1, 0.2));
  streams[0].say({ kind: "rows", width: 8, numbers: [0.3, 1, 2, 3, 4, 5, 6, null] });
  assert.deepEqual([...live.run.time.data.subarray(0, 4)], [0, 0.1, 0.2, 0.3]);
  assert.ok(Number.isNaN(live.run.values.at(3, 0)));
  assert.equal(live.run.poses.at(3, 2), 3);
  streams[0].say({ kind: "running", isRunning: true, speed: 0.5 });
  assert.deepEqual([live.isRunning, live.app.player.speed], [true, 0.5]);
  live.update();
});

test("messages go one after the other, and of a dial the last", async () => {
  const { live, sent, program } = await listening();
  let answered = () => {};
  program.send = (body) => {
    sent.push(JSON.parse(body));
    return new Promise((done) => (answered = done));
  };
  live.set("input", 0, 1);
  live.set("input", 0, 2);
  live.set("input", 0, 3);
  live.pause();
  live.set("input", 0, 4);
  assert.deepEqual(sent, [{ kind: "input", index: 0, value: 1 }]);
  for (let left = 4; left > 0; left--) {
    answered();
    await settled();
  }
  assert.deepEqual(sent.slice(1), [{ kind: "input", index: 0, value: 3 }, { kind: "pause" }, { kind: "input", index: 0, value: 4 }]);
});

test("it is paused when the program says so, not when it is asked", async () => {
  const { live, streams, sent } = await listening();
  live.start();
  assert.ok(!live.isRunning);
  streams[0].say({ kind: "running", isRunning: true, speed: 1 });
  live.pause();
  streams[0].say(rows(0.1));
  assert.ok(live.isRunning);
  streams[0].say({ kind: "running", isRunning: false, speed: 1 });
  await settled();
  assert.deepEqual([live.isRunning, live.run.end, sent], [false, 0.1, [{ kind: "run" }, { kind: "pause" }]]);
});

test("a program that ends is told of, keeps its rows, and is found again", async (t) => {
  const { app, live, streams } = await listening();
  t.mock.timers.enable({ apis: ["setTimeout"] });
  streams[0].say(rows(0.1, 0.2));
  streams[0].say({ kind: "running", isRunning: true, speed: 0.5 });
  streams[0].source.onerror();
  assert.ok(!live.isRunning && !streams[0].source.isOpen);
  assert.match(live.gone, /ended/);
  assert.deepEqual(app.messages.map(({ text }) => text), [live.gone]);
  assert.equal(live.run.rows, 3);
  t.mock.timers.tick(1000);
  assert.equal(streams.length, 2);
  // The same start of the program: it goes on.
  streams[1].say(hello());
  streams[1].say(began(0.3));
  streams[1].say(rows(0.4));
  assert.deepEqual([live.gone, app.messages.length, live.run.rows, live.run.start], ["", 0, 4, 0]);
  // Another start: it begins.
  streams[1].source.onerror();
  t.mock.timers.tick(1000);
  streams[2].say(hello("2"));
  streams[2].say(began(0));
  assert.equal(live.run.rows, 1);
  // Another mechanism is not mixed up with it.
  streams[2].source.onerror();
  t.mock.timers.tick(1000);
  streams[3].say(hello("3", { columns: [{ name: "other", unit: "" }] }));
  assert.match(live.gone, /Another mechanism/);
  assert.ok(!streams[3].source.isOpen);
});

test("what the program cannot do is not offered", async () => {
  const ids = (app) => commandsOf(app).map(({ id }) => id);
  const { app } = await listening();
  assert.ok(!ids(app).includes("pull") && !ids(app).includes("place") && ids(app).includes("restart"));
  const { app: pulled } = await listening(true);
  assert.ok(ids(pulled).includes("pull") && !ids(pulled).includes("place"));
});

test("a prescribed motion says why nothing can be pulled", async (t) => {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const { app, live } = await listening(true);
  const pull = commandsOf(app).find(({ id }) => id === "pull");
  assert.deepEqual([pull.whyNot(app), live.usualMode], ["", "pull"]);
  live.run.mechanism.report = { formulation: "kinematics" };
  assert.match(pull.whyNot(app), /motion is prescribed/);
  pull.run(app);
  assert.deepEqual([app.mode, live.usualMode], ["pan", "pan"]);
  assert.match(app.messages.at(-1).text, /motion is prescribed/);
  live.run.mechanism.report = { formulation: "joint coordinates" };
  pull.run(app);
  assert.equal(app.mode, "pull");
});

test("a program that was never there leaves a page that says so", async () => {
  const { source } = stream();
  const program = new Program(() => source, async () => {});
  const greeting = program.open();
  program.close();
  source.onerror();
  assert.equal(await greeting, null);
});
