// Drawing without a browser: where a hand goes, and what its presses ask of the pencil.

import assert from "node:assert/strict";
import { test } from "node:test";
import { App } from "../src/app.js";
import { Sketch } from "../src/sketch.js";
import { alongStep, besidePin, lineText, nearestPort, pinOf, portKey, sketchStep, snapped } from "../src/snap.js";

const place = (name, x, y, more = {}) => {
  const [owner, port] = name.split(".");
  return { owner, port, at: [x, y], angle: 0, ...more };
};
const pin = (one, other) => ({ name: `${one}-${other}`, kind: "revolute", pin: true, ports: [place(one, 0, 0), place(other, 0, 0)] });

/** A picture of 1000 pixels for a metre, with its origin in the middle. */
const appOf = () => {
  const app = new App();
  app.view.scale = 1000;
  app.mode = "draw";
  return app;
};

test("the step of a picture is a round one, no finer than a pixel", () => {
  assert.deepEqual([1000, 999, 500, 100, 1e5].map((scale) => sketchStep(scale)), [1e-3, 2e-3, 2e-3, 1e-2, 1e-5]);
  assert.equal(sketchStep(1000, 24), 0.05);
});

test("a hand goes onto a pin, else onto lines through pins, else onto the grid", () => {
  const app = appOf();
  const projection = app.view.projection(app.area);
  const places = [place("a.a", 0.1, 0.05), place("b.a", -0.2, 0)];
  const at = (x, y, how) => snapped(places, projection, ...projection.point(x, y, 0), how);
  assert.equal(portKey(at(0.105, 0.052).onto), "a.a");
  assert.deepEqual(at(0.105, 0.052).at, [0.1, 0.05]);
  assert.deepEqual(at(0.0304, 0.0333).at, [0.03, 0.033]);
  // At the height of one of them, as far as it is away.
  assert.deepEqual(at(0.3, 0.053).at, [0.3, 0.05]);
  assert.deepEqual(at(0.3, 0.053).along, [[0.1, 0.05]]);
  // What goes with the hand holds it nowhere.
  const moving = new Set(["a.a"]);
  assert.deepEqual(at(0.105, 0.052, { except: moving, moving }), { at: [0.105, 0.052], onto: null, along: [] });
  assert.equal(nearestPort(places, projection, ...projection.point(0.12, 0.05, 0)), null);
  assert.equal(nearestPort(places, projection, ...projection.point(0.12, 0.05, 0), { reach: 22 }), places[0]);
});

test("where a pin is on the ground, a hand takes the body", () => {
  const app = appOf();
  const projection = app.view.projection(app.area);
  const all = [place("ground.g1", 0, 0), place("bar1.a", 1e-5, 0), place("ground.g2", 0.1, 0)];
  const near = (places, x) => portKey(nearestPort(places, projection, ...projection.point(x, 0, 0)));
  assert.equal(near(all, -0.002), "bar1.a");
  assert.equal(near(all.toReversed(), -0.002), "bar1.a");
  assert.equal(near(all, 0.099), "ground.g2");
});

test("lines have directions in steps of 15 degrees, and are told", () => {
  const [x, y] = alongStep([0.1, 0.1], [0.2, 0.104]);
  assert.ok(Math.abs(y - 0.1) < 1e-15 && Math.abs(x - 0.1 - Math.hypot(0.1, 0.004)) < 1e-15);
  assert.equal(lineText([0, 0], [0.03, 0.04]), "50 mm, 53.1°");
  assert.equal(lineText([0, 0], [0.1, 0]), "100 mm, 0°");
});

test("a pin is all ports that joints hold together", () => {
  const parts = [pin("a.b", "b.a"), pin("b.a", "c.x"), { ...pin("c.y", "d.a"), pin: false }];
  assert.deepEqual([...pinOf(parts, place("c.x", 0, 0))].sort(), ["a.b", "b.a", "c.x"]);
  assert.deepEqual([...pinOf(parts, place("d.a", 0, 0))], ["d.a"]);
  const places = ["a.a", "a.b", "b.a", "c.x", "c.y", "d.a", "e.a"].map((name) => place(name, 0, 0));
  // All of a, b and c are of bodies of that pin.
  assert.deepEqual([...besidePin(places, parts, pinOf(parts, place("a.b", 0, 0)))].sort(), ["a.a", "a.b", "b.a", "c.x", "c.y"]);
});

/** A sheet whose pencil notes what it is asked. */
function sheetOf(places, parts = []) {
  const app = appOf();
  const asked = [];
  const steps = [];
  let answer = { edits: [] };
  const pencil = {
    ask: (_, gesture) => (asked.push(gesture), answer),
    sheet: () => ({ places, parts }),
  };
  const exchange = { text: null, declare: (text, isLifted) => (steps.push([text, isLifted]), Promise.resolve(null)), clear: () => {} };
  const sketch = new Sketch(app, exchange, pencil);
  sketch.pane = { editor: { text: () => "text" }, step: (name) => steps.push(name) };
  const projection = app.view.projection(app.area);
  const on = (x, y) => [projection, ...projection.point(x, y, 0)];
  const click = (x, y, how = {}) => {
    const taken = sketch.press(...on(x, y), how);
    sketch.release(...on(x, y), { ...how, hasMoved: false });
    return taken;
  };
  return { app, sketch, asked, steps, on, click, answer: (next) => (answer = next) };
}

test("two presses make a bar, with ends on pins, on the ground, or anywhere", () => {
  const { sketch, asked, steps, click } = sheetOf([place("bar1.b", 0.1, 0.05)]);
  sketch.tool = "bar";
  click(-0.1, -0.1, { isShift: true });
  assert.deepEqual(asked, []);
  click(0.1, 0.05);
  assert.deepEqual(asked, [{ kind: "bar", ends: [{ at: [-0.1, -0.1], ground: true }, { owner: "bar1", port: "b" }], grid: 1e-3 }]);
  assert.deepEqual([steps, sketch.from], [["draw a bar"], null]);
  // Begun, and given up.
  click(0, 0);
  assert.ok(sketch.cancel() && sketch.from === null && !sketch.cancel());
});

test("a bar is drawn by one pull, too", () => {
  const { sketch, asked, on } = sheetOf([]);
  sketch.tool = "bar";
  sketch.press(...on(0, 0), {});
  sketch.release(...on(0.05, 0.02), { hasMoved: true });
  assert.deepEqual(asked[0].ends, [{ at: [0, 0], ground: false }, { at: [0.05, 0.02], ground: false }]);
});

test("a bar gets another pin, and a pin slides along a bar or along the ground", () => {
  const places = [place("bar1.a", 0, 0), place("bar1.b", 0.1, 0.05), place("bar2.a", -0.1, -0.1), place("bar2.b", -0.1, 0.1)];
  const { app, sketch, asked, click } = sheetOf(places);
  sketch.tool = "point";
  click(0.3, 0.2);
  assert.deepEqual([asked, sketch.from, app.messages.at(-1).text], [[], null, "A bar is wanted here."]);
  click(-0.1, 0.02);
  click(0.1, 0.05);
  click(0.052, 0.025);
  click(-0.05, 0.08, { isShift: true });
  sketch.tool = "slide";
  click(0.1, 0.05);
  click(-0.1, -0.03);
  click(0.1, 0.05);
  click(0.2, 0.05);
  const port = { owner: "bar1", port: "b" };
  assert.deepEqual(asked, [
    { kind: "port", body: "bar2", end: port, grid: 1e-3 },
    { kind: "port", body: "bar1", end: { at: [-0.05, 0.08], ground: true }, grid: 1e-3 },
    { kind: "groove", body: "bar2", port, grid: 1e-3 },
    { kind: "slide", toward: [0.2, 0.05], port, grid: 1e-3 },
  ]);
});

test("a pin that is dragged is lifted once, and let go as one gesture", async () => {
  const { sketch, asked, steps, on, answer } = sheetOf([place("bar1.a", 0, 0), place("bar1.b", 0.1, 0.05), place("bar2.a", 0.3, 0.1)]);
  answer({ edits: [{}], values: [0.12, 0.06], to: [0.12, 0.06], text: "lifted", parameters: ["plm_drag_0", "plm_drag_1"] });
  assert.equal(sketch.press(...on(0.1, 0.05), {}), true);
  for (const x of [0.11, 0.12]) sketch.held.move(...on(x, 0.06), {});
  assert.deepEqual(asked.map(({ kind, live }) => [kind, live === true]), [["drag", true], ["lift", false], ["drag", true]]);
  assert.deepEqual(steps, [["lifted", true]]);
  sketch.release(...on(0.12, 0.06), { hasMoved: true });
  assert.deepEqual(asked.at(-1), { kind: "drag", port: { owner: "bar1", port: "b" }, to: [0.12, 0.06], grid: 1e-3, free: false, onto: undefined });
  assert.equal(steps.at(-1), "move bar1.b");
  // Dropped on another pin it is joined to it.
  sketch.press(...on(0.1, 0.05), {});
  sketch.held.move(...on(0.305, 0.1), {});
  sketch.release(...on(0.305, 0.1), { hasMoved: true });
  assert.equal(asked.at(-1).kind, "merge");
  assert.deepEqual(asked.at(-1).onto, { owner: "bar2", port: "a" });
  // Taken back, the text itself moves again.
  sketch.press(...on(0.1, 0.05), {});
  sketch.held.move(...on(0.2, 0.2), {});
  sketch.cancel();
  assert.deepEqual(steps.at(-1), ["text", undefined]);
});

test("a press beside all pins is none of drawing, and one on a pin chooses it", () => {
  const { sketch, click } = sheetOf([place("bar1.b", 0.1, 0.05)], []);
  assert.equal(click(0.1, 0.05), true);
  assert.deepEqual(sketch.chosen, { owner: "bar1", port: "b" });
  assert.equal(sketch.press(sketch.app.view.projection(sketch.app.area), 5, 5, {}), false);
  assert.equal(sketch.chosen, null);
});

test("why a gesture is none is told, and nothing is written", () => {
  const { app, sketch, steps, click, answer } = sheetOf([place("bar1.b", 0.1, 0.05)]);
  answer({ why: "the motion of `bar1` is prescribed already" });
  sketch.tool = "motor";
  click(0.1, 0.05);
  assert.deepEqual([steps, app.messages.map(({ text }) => text)], [[], ["The motion of `bar1` is prescribed already."]]);
});
