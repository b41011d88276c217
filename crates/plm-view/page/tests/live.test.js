// The mechanism in the page, without a browser: the machine of the worker, its numbers, what is written.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { App } from "../src/app.js";
import { COMMANDS, commandsOf, LIVE_COMMANDS } from "../src/commands.js";
import { Live, LIVE_WINDOW } from "../src/live.js";
import { rangeAround } from "../src/dials.js";
import { Player } from "../src/player.js";
import { readResults } from "../src/results.js";
import { Run } from "../src/run.js";
import { readShape } from "../src/shape.js";
import { View } from "../src/view.js";
import { LiveMachine } from "../src/machine.js";
import { csvText, resultsFile } from "../src/write.js";
import { modulePath, nativeRows, withoutModule } from "./support/live.js";
import { headOf } from "./support/scenes.js";

const same = (a, b) => assert.deepEqual(new BigUint64Array(Float64Array.from(a).buffer), new BigUint64Array(Float64Array.from(b).buffer));

const oneBody = (more = {}) =>
  headOf(
    {
      name: "M",
      bodies: [{ name: "b", mass: 2, inertia: 0.5, depth: 0, ports: [{ name: "p", x: 1, y: 0, angle: 0 }], contour: null }],
      ground: [{ name: "o", x: 0, y: 0, angle: 0, depth: 0 }],
      parameters: [{ name: "reach", unit: "mm", factor: 1e-3, default: 0.4, value: 0.4 }],
      ...more,
    },
    { columns: [{ name: "b.angle, unwrapped", unit: "rad" }, { name: "ratio", unit: "" }] },
  );

/** A live run whose worker only notes what it is sent. */
function liveApp(head = oneBody()) {
  const app = new App();
  const sent = [];
  app.live = new Live(app, head, new Uint8Array(0), { postMessage: (message) => sent.push(message), onmessage: null });
  app.live.show();
  return { app, live: app.live, sent };
}

const rowAt = (time) => [time, 0.1 * time, 0, 2 * time, 0.1, 0, 2, 0, 0, 0, 2 * time, 7];
const rows = (...times) => ({ kind: "rows", width: 12, numbers: Float64Array.from(times.flatMap(rowAt)) });
const began = (time = 0, isAssembled = true) => ({ kind: "began", numbers: Float64Array.from(rowAt(time)), isAssembled });

test("the machine of the worker has the bits of the native run", { skip: withoutModule }, async () => {
  const { instance } = await WebAssembly.instantiate(readFileSync(modulePath()), {});
  const heard = [];
  const machine = new LiveMachine(instance.exports, { parameters: 2, inputs: 1 }, (message) => heard.push(message));
  machine.begin("restart");
  const native = nativeRows();
  for (let k = 0; k < native.length; k++) {
    if (k === 150) machine.set("parameter", 0, 0.41);
    if (k === 200) instance.exports.plm_pull(1, 0.3, 0.2, 4, -2);
    machine.step(0.01);
    same(machine.now, native[k]);
  }
  machine.set("parameter", 0, 9);
  machine.begin("restart");
  const { trouble } = heard.findLast(({ kind }) => kind === "trouble");
  assert.ok(machine.isStuck && trouble.part !== "" && trouble.text.length > 10, JSON.stringify(trouble));
  // Mended, it stands at the start again.
  machine.set("parameter", 0, 0.4);
  assert.ok(!machine.isStuck);
  assert.equal(heard.findLast(({ kind }) => kind === "trouble").trouble, null);
  machine.step(0.01);
  same(machine.now, native[0]);
});

test("a placed point comes where it is asked to, and the joints close", { skip: withoutModule }, async () => {
  const { instance } = await WebAssembly.instantiate(readFileSync(modulePath()), {});
  const machine = new LiveMachine(instance.exports, { parameters: 2, inputs: 1 }, () => {});
  machine.begin("restart");
  // The end of the crank, along its circle around the origin.
  const angle = machine.now[3] + 0.15;
  machine.place(0, [0.5, 0], [Math.cos(angle), Math.sin(angle)], 0);
  const { x, y } = machine.pointOf(0, [0.5, 0]);
  assert.ok(Math.hypot(x - Math.cos(angle), y - Math.sin(angle)) < 2e-3, `${x} ${y}`);
  assert.ok(Math.abs(Math.hypot(x, y) - 1) < 1e-9);
  // A turn, by the number.
  machine.place(0, [0, 0], [0, 0], 0.1);
  assert.ok(Math.abs(machine.now[3] - angle - 0.1) < 5e-3, `${machine.now[3]} ${angle + 0.1}`);
  const [b, c] = [machine.pointOf(1, [-0.2, 0]), machine.pointOf(0, [0.5, 0])];
  assert.ok(Math.hypot(b.x - c.x, b.y - c.y) < 1e-9);
});

test("a spring pulls a point of a body, and a force is taken away with it", () => {
  const pulls = [];
  const machine = new LiveMachine({ plm_pull: (...numbers) => pulls.push(numbers) }, { parameters: 0, inputs: 0 }, () => {});
  // G at (1, 2), turned by a right angle, moving by (3, 0) and turning by 2 rad/s: the point (0.5, 0) is at (1, 2.5).
  machine.now = Float64Array.from([0, 1, 2, Math.PI / 2, 3, 0, 2]);
  machine.setPull({ body: 0, point: [0.5, 0], target: [4, 2.5], stiffness: 10, damping: 1, force: null });
  machine.applyPull();
  const [body, x, y, fx, fy] = pulls[0];
  // Its velocity is (3 - 2*0.5, 0).
  [[body, 0], [x, 1], [y, 2.5], [fx, 10 * 3 - 2], [fy, 0]].forEach(([found, expected]) => assert.ok(Math.abs(found - expected) < 1e-12, `${pulls[0]}`));
  machine.setPull(null);
  assert.deepEqual(pulls[1], [0, 0, 0, 0, 0]);
  machine.applyPull();
  assert.equal(pulls.length, 2);
});

test("rows become a run, and without a recording a window of it stays", () => {
  const { app, live } = liveApp();
  live.hear(began());
  live.hear(rows(...Array.from({ length: 3000 }, (_, k) => (k + 1) / 100)));
  assert.equal(live.run.end, 30);
  assert.ok(live.run.start <= 30 - LIVE_WINDOW && live.run.start > 30 - LIVE_WINDOW - 0.02, `${live.run.start}`);
  assert.equal(app.player.time, 30);
  assert.equal(live.run.values.at(0, 0), 2 * live.run.start);
  assert.deepEqual([live.run.poses.rows, live.run.values.rows, live.run.ground.rows], Array(3).fill(live.run.rows));
});

test("a recording keeps everything, and becomes a run", () => {
  const { app, live } = liveApp();
  live.hear(began());
  live.hear(rows(1, 2));
  live.record();
  live.hear(rows(3, 25, 50));
  live.record();
  assert.deepEqual([...live.recordings[0].time.data], [2, 3, 25, 50]);
  assert.deepEqual(app.runViews.map(({ run }) => run.name), ["live", "recording 1"]);
  // A start ends a recording and begins the next.
  live.record();
  live.hear(rows(51, 52));
  live.hear(began());
  live.hear(rows(0.01, 0.02));
  assert.deepEqual(live.kept().map(({ name, rows: count }) => [name, count]), [["recording 1", 4], ["recording 2", 3], ["recording 3", 3]]);
});

test("what was turned is an event, once for a while", () => {
  const { live, sent } = liveApp();
  live.hear(began());
  live.hear(rows(1, 2));
  live.set("parameter", 0, 0.41);
  live.set("parameter", 0, 0.42);
  live.set("parameter", 0, Number.NaN);
  assert.deepEqual(live.run.events, [{ time: 2, what: "reach = 420 mm", row: null }]);
  assert.deepEqual(sent.filter(({ kind }) => kind === "parameter").map(({ value }) => value), [0.41, 0.42]);
});

test("trouble is told with its part, the picture stays, and a start clears it", () => {
  const { app, live } = liveApp();
  live.hear(began());
  live.hear(rows(1));
  live.hear(began(0, false));
  live.hear({ kind: "trouble", trouble: { time: 0, part: "pin", text: "the loop stays open" } });
  assert.equal(live.run.rows, 2);
  assert.deepEqual(app.messages.map(({ kind, text }) => [kind, text.replace(/^[^:]*: /, "")]), [["fault", "pin: the loop stays open"]]);
  live.hear(began());
  live.hear({ kind: "trouble", trouble: null });
  assert.deepEqual([app.messages.length, live.run.fault, live.run.rows], [0, null, 1]);
});

test("what a parameter has opened is told with its value and the joint, and goes when it is turned back", () => {
  const pin = { name: "pin", kind: "revolute", pair: "revolute", frames: [{ argument: "a", body: null, port: 0 }, { argument: "b", body: 0, port: 0 }], sizes: {} };
  const { app, live } = liveApp(oneBody({ parts: [pin, { ...pin, name: "rail", kind: "prismatic", pair: "prismatic" }] }));
  live.hear(began());
  live.hear(rows(1));
  live.set("parameter", 0, 0.08);
  const told = (part, gap) => {
    live.hear({ kind: "trouble", trouble: { time: 1, part, gap, text: "cannot be assembled" } });
    return app.messages.filter(({ kind }) => kind === "fault").map(({ text }) => text);
  };
  assert.deepEqual(told("pin", 0.12), ["reach 80 mm: pin is 120 mm open"]);
  assert.deepEqual(told("pin", 1.23456), ["reach 80 mm: pin is 1.23 m open"]);
  // The ring is at the part.
  assert.equal(live.run.fault.part, "pin");
  for (const [part, gap] of [["rail", 0.1], ["pin", Number.NaN]]) assert.match(told(part, gap)[0], new RegExp(`^Stopped at .*: ${part}: cannot be assembled$`));
  live.set("parameter", 0, 0.4);
  live.hear({ kind: "trouble", trouble: null });
  assert.deepEqual([app.messages.length, live.run.fault], [0, null]);
});

test("the machine says at once whether a parameter can be assembled", () => {
  const said = { open: "1\npin\n0.12\nit is open" };
  const bytes = new TextEncoder();
  const memory = { buffer: new ArrayBuffer(4096) };
  let words = "";
  const exports = {
    memory,
    plm_set_parameter: (_, value) => (words = value < 0.1 ? said.open : ""),
    plm_parameter: () => 0,
    plm_input: () => 0,
    plm_shape: () => 0,
    plm_shape_length: () => 0,
    plm_size_names: () => 0,
    plm_contacts: () => 0,
    plm_trouble: () => (new Uint8Array(memory.buffer).set(bytes.encode(words)), 0),
    plm_text_length: () => words.length,
  };
  const heard = [];
  const machine = new LiveMachine(exports, { parameters: 1, inputs: 0 }, (message) => heard.push(message));
  [machine.isAssembled, machine.now] = [true, Float64Array.from([1])];
  machine.set("parameter", 0, 0.08);
  assert.deepEqual(heard.findLast(({ kind }) => kind === "trouble").trouble, { time: 1, part: "pin", gap: 0.12, text: "it is open" });
  machine.set("parameter", 0, 0.35);
  assert.equal(heard.findLast(({ kind }) => kind === "trouble").trouble, null);
});

test("the machine tells what rows of contact do, where that has changed", () => {
  const memory = { buffer: new ArrayBuffer(4096) };
  let words = "open\tfloor\nunloaded\tslip";
  const put = () => (new Uint8Array(memory.buffer).set(new TextEncoder().encode(words)), 0);
  const exports = { memory, plm_contacts: put, plm_text_length: () => words.length };
  const heard = [];
  const machine = new LiveMachine(exports, { parameters: 0, inputs: 0 }, (message) => heard.push(message));
  machine.tellContacts();
  machine.tellContacts();
  words = "closed\tfloor\nslips forwards\tslip";
  machine.tellContacts();
  const modes = heard.map(({ contacts }) => contacts.map(({ name, mode }) => `${name} ${mode}`));
  assert.deepEqual(modes, [["floor open", "slip unloaded"], ["floor closed", "slip slips forwards"]]);
  const { live } = liveApp();
  live.hear(heard[1]);
  assert.deepEqual(live.contacts[1], { name: "slip", mode: "slips forwards" });
});

test("a module of another mechanism is refused in words", () => {
  const { app, live } = liveApp();
  live.hear({ kind: "began", numbers: new Float64Array(5), isAssembled: true });
  assert.match(app.messages[0].text, /not of this mechanism: it gives 5 numbers where the results have 12/);
  live.start();
  assert.ok(!live.isRunning);
});

test("of many placements the first and the last are asked for", () => {
  const { live, sent } = liveApp();
  for (const x of [1, 2, 3, 4]) live.place(0, [0, 0], [x, 0]);
  live.hear({ kind: "placed" });
  live.hear({ kind: "placed" });
  live.place(0, [0, 0], [5, 0]);
  assert.deepEqual(sent.filter(({ kind }) => kind === "place").map(({ target }) => target[0]), [1, 4, 5]);
});

test("a pull holds the weight at a few sizes of a body, and shakes no light one", () => {
  const { live } = liveApp();
  const { stiffness, damping } = live.stiffness(0, [0, 0]);
  // 2 kg and a bar from G to 1 m: a quarter of a metre holds the weight.
  assert.ok(Math.abs(stiffness * 0.25 - 2 * 9.81) < 1e-9, `${stiffness}`);
  assert.ok(damping > 0);
  const light = liveApp(oneBody({ bodies: [...oneBody().mechanism.bodies, { ...oneBody().mechanism.bodies[0], mass: 0.01, inertia: 1e-4 }] }));
  const felt = 1 / (1 / 0.01 + 1 / 1e-4);
  assert.ok(light.live.stiffness(1, [1, 0]).stiffness / Math.max(felt, 0.01 * 2.01) <= 1600 * (1 + 1e-12));
});

test("what parameters change of bodies is drawn", () => {
  const pin = { name: "hinge", kind: "revolute", pair: "revolute", frames: [{ argument: "a", body: null, port: 0 }, { argument: "b", body: 0, port: 0 }], sizes: { pin: 0.1 } };
  const { mechanism } = oneBody({ parts: [pin, { ...pin, name: "ram", kind: "jack", pair: null, sizes: {}, shapes: [{ look: "circle", body: 0, port: 0, towards: null, symbol: false, points: [[0, 0], [1, 0]] }] }] });
  mechanism.bodies[0].holes = [[]];
  const sizes = "hinge pin_diameter\nram free_length piston_diameter rod_diameter";
  const numbers = Float64Array.from([3, 0.6, 0.1, 1.5, 0, 0, 3, 0, 0, 1, 0, 0, 1, 0.2, 0.3, 0, 0.05, 0.15, 0.7, 0.09, 0, 2, 0, 0, 0.4, 0, 3, 0.1, 0.1, 0.2, 0.1, 0.1, 0.2]);
  assert.ok(readShape(mechanism, numbers, sizes));
  assert.deepEqual(mechanism.parts.map((part) => part.sizes), [{ pin: 0.15 }, { free_length: 0.7, piston: 0.09 }]);
  assert.deepEqual(mechanism.bodies[0], { name: "b", mass: 3, inertia: 0.6, depth: 0.1, ports: [{ name: "p", x: 1.5, y: 0, angle: 0 }], contour: [[0, 0], [1, 0], [0, 1]], holes: [[[0.1, 0.1], [0.2, 0.1], [0.1, 0.2]]] });
  assert.deepEqual(mechanism.parts[1].shapes[0].points, [[0, 0], [0.4, 0]]);
  assert.deepEqual(mechanism.ground[0], { name: "o", x: 0.2, y: 0.3, angle: 0, depth: 0.05 });
  assert.ok(!readShape(mechanism, numbers.slice(), sizes), "nothing has changed");
});

test("what is exported is read back to the bit, by the page's own reader", async () => {
  const { live } = liveApp();
  live.hear(began());
  live.hear(rows(1 / 3, 0.7, Math.PI));
  live.set("parameter", 0, 0.41);
  const bytes = await resultsFile(live.kept(), "plm test");
  const { runs, madeBy, warnings } = await readResults(bytes);
  assert.deepEqual([warnings, madeBy, runs.length], [[], "plm test", 1]);
  const [run] = runs;
  for (const name of ["time", "poses", "values", "ground"]) {
    const { data, rows: count, width } = live.run[name];
    same(run[name].data, data.subarray(0, count * width));
  }
  assert.deepEqual([run.columns, run.events.map(({ what }) => what), run.mechanism.parameters[0].value], [live.run.columns, ["reach = 410 mm"], 0.4]);
  // Ports that stand still are left out.
  for (const port of live.mechanism.ground) port.moves = false;
  const [still] = (await readResults(await resultsFile(live.kept(), ""))).runs;
  assert.equal(still.ground, null);
});

test("a table has names, units, and numbers that read back", () => {
  const run = Run.empty(oneBody());
  run.append(0.1, [0, 0, 0, 0, 0, 0], [1 / 3, -0], [0, 0, 0]);
  run.append(0.2, [0, 0, 0, 0, 0, 0], [NaN, -Infinity], [0, 0, 0]);
  assert.equal(csvText(run), 'time (s),"b.angle, unwrapped (rad)",ratio\n0.1,0.3333333333333333,-0.0\n0.2,NaN,-inf\n');
});

test("ranges stand around what is usual", () => {
  assert.deepEqual(rangeAround(400, 1), { low: 0, high: 800, step: 4 });
  assert.deepEqual(rangeAround(-0.5, 1), { low: -1, high: 0, step: 0.005 });
  assert.deepEqual(rangeAround(0, 20), { low: -20, high: 20, step: 0.2 });
});

test("the time runs along behind a live source without jerks", () => {
  const player = new Player();
  [player.isFollowing, player.pace] = [true, 1];
  player.setBounds(0, 0.05);
  let [now, end] = [0, 0.05];
  const steps = [];
  for (let frame = 0; frame < 120; frame++) {
    now += 1000 / 60;
    // Rows come every 10 ms.
    end = 0.05 + 0.01 * Math.floor(now / 10);
    player.setBounds(0, end);
    const before = player.time;
    player.tick(now);
    if (frame > 60) steps.push(player.time - before);
    assert.ok(player.time <= end);
  }
  assert.ok(Math.max(...steps) < 1.15 / 60 && Math.min(...steps) > 0.85 / 60, `${Math.min(...steps)} ${Math.max(...steps)}`);
  player.pace = null;
  player.setBounds(0, end);
  assert.equal(player.time, end);
});

test("a place of the screen is a point of a plane, from every side but its edge", () => {
  const view = new View();
  const area = { x: 10, y: 20, width: 600, height: 400 };
  for (const name of ["front", "back", "isometric"]) {
    view.lookFrom(name);
    const projection = view.projection(area);
    const [px, py] = projection.point(0.3, -0.7, 0.2);
    projection.onPlane(px, py, 0.2).forEach((found, axis) => assert.ok(Math.abs(found - [0.3, -0.7][axis]) < 1e-12, name));
  }
  view.lookFrom("top");
  assert.equal(view.projection(area).onPlane(100, 100, 0), null);
});

test("only a live page has the commands of one, and no key has two meanings there either", () => {
  assert.equal(commandsOf(new App()), COMMANDS);
  const { app } = liveApp();
  const keys = commandsOf(app).flatMap((command) => command.keys);
  assert.equal(keys.length, COMMANDS.flatMap((command) => command.keys).length + LIVE_COMMANDS.flatMap((command) => command.keys).length);
  assert.equal(new Set(keys).size, keys.length);
});

test("play, stop and step move the mechanism at the end of its run, and time before it", () => {
  const { app, live, sent } = liveApp();
  live.hear(began());
  live.hear(rows(1, 2));
  app.play();
  assert.deepEqual([live.isRunning, app.player.isPlaying], [true, false]);
  app.stop();
  app.stepForwards();
  assert.deepEqual(sent.slice(-4).map(({ kind }) => kind), ["run", "pause", "pause", "step"]);
  app.player.seek(0.5);
  app.play();
  assert.deepEqual([live.isRunning, app.player.isPlaying], [false, true]);
});
