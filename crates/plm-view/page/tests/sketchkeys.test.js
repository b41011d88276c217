// Drawing by keyboard alone, without a browser: what keys ask of the pencil.

import assert from "node:assert/strict";
import { test } from "node:test";
import { App } from "../src/app.js";
import { Sketch } from "../src/sketch.js";
import { drawingKeyWords, obeyDrawingKey } from "../src/sketchkeys.js";

const place = (name, x, y, more = {}) => {
  const [owner, port] = name.split(".");
  return { owner, port, at: [x, y], angle: 0, guessed: false, ...more };
};

/** A sheet of 1000 pixels for a metre, whose pencil notes what it is asked. */
function sheetOf(places) {
  const app = new App();
  app.view.scale = 1000;
  app.mode = "draw";
  const asked = [];
  const pencil = { ask: (_, gesture) => (asked.push(gesture), { edits: [] }), sheet: () => ({ places, parts: [] }) };
  const exchange = { text: null, declare: () => Promise.resolve(null), clear: () => {} };
  const sketch = new Sketch(app, exchange, pencil);
  sketch.pane = { editor: { text: () => "text" }, step: () => {} };
  const keys = (...names) => names.map((name) => obeyDrawingKey(sketch, name));
  return { app, sketch, asked, keys };
}

test("Tab goes through the pins, and past the last one through the page", () => {
  const { sketch, keys } = sheetOf([place("bar1.a", 0, 0), place("bar1.b", 0.1, 0), place("bar2.a", 0.1, 0), place("bar2.b", 0.2, 0.1)]);
  const chosen = () => sketch.chosen && `${sketch.chosen.owner}.${sketch.chosen.port}`;
  const seen = [0, 1, 2, 3].map(() => [keys("Tab")[0], chosen()]);
  assert.deepEqual(seen, [[true, "bar1.a"], [true, "bar1.b"], [true, "bar2.b"], [false, null]]);
  assert.deepEqual([keys("Shift+Tab"), chosen()], [[true], "bar2.b"]);
  assert.equal(drawingKeyWords(sketch), "bar2.b: arrow keys move it, Enter types its numbers.");
  const empty = sheetOf([]);
  assert.deepEqual(empty.keys("Tab", "Shift+Tab", "ArrowLeft", "Enter"), [false, false, false, false]);
});

test("arrow keys move the chosen pin by a round step of the picture", () => {
  const { sketch, asked, keys } = sheetOf([place("bar1.a", 0.1, 0.05)]);
  keys("Tab", "ArrowLeft", "ArrowUp");
  const drag = (to) => ({ kind: "drag", port: { owner: "bar1", port: "a" }, to, grid: 1e-3, free: false });
  // Ten pixels are a centimetre; the sheet of the test stays.
  assert.deepEqual(asked, [drag([0.09, 0.05]), drag([0.1, 0.06])]);
  sketch.choose(null);
  assert.deepEqual([keys("ArrowLeft"), asked.length], [[false], 2]);
});

test("a pin that assembly may move waits until it is known where it stands", () => {
  const { sketch, asked, keys } = sheetOf([place("bar1.a", 0.1, 0.05, { guessed: true })]);
  keys("Tab", "ArrowLeft", "ArrowLeft");
  assert.deepEqual([asked, sketch.waiting.map((part) => Number(part.toFixed(9)))], [[], [-0.02, 0]]);
  // The text moves now.
  Object.defineProperty(sketch, "isCurrent", { value: true });
  sketch.places = () => [place("bar1.a", 0.12, 0.04)];
  sketch.nudge([0, 0]);
  assert.deepEqual([asked[0].to, sketch.waiting], [[0.1, 0.04], [0, 0]]);
});

test("a bar is drawn by arrow keys and Enter", () => {
  const { app, sketch, asked, keys } = sheetOf([place("bar1.b", 0.1, 0)]);
  app.view.target = [0, 0, 0];
  sketch.take("bar");
  // The first arrow shows the place, in the middle.
  assert.deepEqual([keys("ArrowRight"), sketch.cursor], [[true], [0, 0]]);
  keys("ArrowLeft", "ArrowDown", "ArrowDown");
  assert.equal(drawingKeyWords(sketch), " Enter: at -10, -20 mm.");
  keys("Enter", "Tab", "Enter");
  assert.deepEqual(asked, [{ kind: "bar", ends: [{ at: [-0.01, -0.02], ground: false }, { owner: "bar1", port: "b" }], grid: 1e-3 }]);
  sketch.take("move");
  assert.equal(sketch.cursor, null);
});

test("what is chosen is copied, mirrored and locked", () => {
  const { app, sketch, asked } = sheetOf([place("bar1.b", 0.1, 0)]);
  const port = { owner: "bar1", port: "b" };
  const told = () => app.messages.at(-1).text;
  sketch.copy();
  assert.equal(told(), "A bar is wanted, which is selected.");
  sketch.mirror();
  assert.deepEqual([asked, told()], [[], "A pin of two bars is wanted, which is chosen."]);
  sketch.choose(port);
  sketch.copy();
  sketch.mirror();
  sketch.lock("y");
  assert.deepEqual(asked, [
    { kind: "copy", body: "bar1", by: [0.05, -0.05], grid: 1e-3 },
    { kind: "mirror", port, grid: 1e-3 },
    { kind: "lock", port, dimension: "y" },
  ]);
});
