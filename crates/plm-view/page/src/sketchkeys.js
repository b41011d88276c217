// Drawing by keyboard alone: Tab goes from pin to pin, arrow keys move a pin or the place where Enter presses.

import { millimetres, portKey, sketchStep } from "./snap.js";

/** @import {Sketch} from "./sketch.js" */

/** @type {{[name: string]: number[]}} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/** A step of an arrow key is a round one, and no shorter, in pixels. */
const KEY_PIXELS = 8;

const withoutRounding = (/** @type {number} */ part) => Number(part.toPrecision(12)) + 0;

/** Whether a key means something while somebody draws. @param {Sketch} sketch @param {string} name */
export function obeyDrawingKey(sketch, name) {
  if (name === "Tab" || name === "Shift+Tab") return toNextPin(sketch, name === "Tab" ? 1 : -1);
  if (name === "Enter") return sketch.tool !== "move" && pressHere(sketch);
  const arrow = ARROWS[name];
  if (arrow === undefined || (sketch.tool === "move" && sketch.chosen === null)) return false;
  const step = sketchStep(sketch.app.view.scale, KEY_PIXELS);
  const by = arrow.map((part) => part * step);
  if (sketch.tool === "move") sketch.nudge(by);
  else {
    const from = sketch.cursor ?? middle(sketch, step);
    sketch.cursor = from.map((part, axis) => withoutRounding(part + (sketch.cursor === null ? 0 : by[axis])));
  }
  sketch.isByKeys = true;
  return true;
}

/** What a place is for, in words. @param {Sketch} sketch */
export function drawingKeyWords(sketch) {
  const { chosen, cursor, isByKeys, tool } = sketch;
  if (!isByKeys) return "";
  if (tool !== "move") return cursor === null ? "" : ` Enter: at ${cursor.map(millimetres).join(", ")} mm.`;
  return chosen === null ? "" : `${portKey(chosen)}: arrow keys move it, Enter types its numbers.`;
}

/** The middle of the picture, to a step. @param {Sketch} sketch @param {number} step */
function middle({ app }, step) {
  const { area } = app;
  const at = app.view.projection(area).onPlane(area.x + area.width / 2, area.y + area.height / 2, 0) ?? [0, 0];
  return at.slice(0, 2).map((part) => Math.round(part / step) * step);
}

/** The next pin, or the one before; past the last one the key goes on through the page. @param {Sketch} sketch @param {1 | -1} by */
function toNextPin(sketch, by) {
  const { chosen, cursor, tool } = sketch;
  const isSame = (/** @type {number[]} */ one, /** @type {number[]} */ other) => Math.hypot(one[0] - other[0], one[1] - other[1]) < 1e-9;
  const places = sketch.places();
  const pins = places.filter(({ at }, k) => places.findIndex((each) => isSame(each.at, at)) === k);
  const here = tool === "move" ? places.find((place) => chosen !== null && portKey(place) === portKey(chosen))?.at : cursor;
  const at = here == null ? -1 : pins.findIndex((pin) => isSame(pin.at, here));
  const next = pins[at === -1 && by < 0 ? pins.length - 1 : at + by];
  if (next === undefined) {
    sketch.choose(null);
    return false;
  }
  if (tool === "move") sketch.choose({ owner: next.owner, port: next.port });
  else sketch.cursor = next.at.slice();
  sketch.isByKeys = true;
  sketch.changed();
  return true;
}

/** A press at the place that arrow keys have chosen. @param {Sketch} sketch */
function pressHere(sketch) {
  const { app, cursor } = sketch;
  if (cursor === null) return false;
  const projection = app.view.projection(app.area);
  const [x, y] = projection.point(cursor[0], cursor[1], 0);
  sketch.press(projection, x, y, {});
  sketch.release(projection, x, y, { hasMoved: false });
  return true;
}
