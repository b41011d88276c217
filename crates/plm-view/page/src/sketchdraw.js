// What drawing shows over the picture: a grid below it, handles, what is begun or held, and half a mechanism.

import { drawLabel } from "./decor.js";
import { missingWords } from "./fault.js";
import { circleOutline, roundedHull } from "./outline.js";
import { lineText, millimetres, pinOf, portKey, sketchStep, snapped } from "./snap.js";
import { guideAt, strokeEnd } from "./strokes.js";

/** @import {Palette} from "./palette.js" */
/** @import {Pen} from "./pen.js" */
/** @import {PlacedPort} from "./pencil.js" */
/** @import {HeldPin} from "./heldpin.js" */
/** @import {Sketch} from "./sketch.js" */
/** @import {Snapped} from "./snap.js" */
/** @import {Projection} from "./view.js" */

/** Lines of the grid are no nearer, in pixels. */
const GRID_PIXELS = 24;
/** Half the side of a handle, in pixels: at rest, and under the pointer. */
const HANDLE = 4;
const HANDLE_NEAR = 6;
/** Half the width of a bar that is only drawn yet, m. */
const DRAWN_WIDTH = 0.01;

/** The grid of a drawing, below the picture. @param {Pen} pen @param {Sketch} sketch */
export function drawSheet(pen, sketch) {
  const { app } = sketch;
  if (!sketch.isOn || app.view.azimuth !== 0 || app.view.elevation !== 0) return;
  const { area, palette } = app;
  const projection = app.view.projection(area);
  const step = sketchStep(projection.scale, GRID_PIXELS);
  const [low, high] = [projection.onPlane(area.x, area.y + area.height, 0), projection.onPlane(area.x + area.width, area.y, 0)];
  if (low === null || high === null) return;
  for (const axis of [0, 1]) {
    for (let k = Math.ceil(low[axis] / step); k * step <= high[axis]; k++) {
      const at = axis === 0 ? projection.point(k * step, 0, 0)[0] : projection.point(0, k * step, 0)[1];
      const line = axis === 0 ? [at, area.y, at, area.y + area.height] : [area.x, at, area.x + area.width, at];
      pen.line(line, { stroke: k === 0 ? palette.faint : palette.grid, width: 1, opacity: k === 0 ? 0.6 : k % 5 === 0 ? 1 : 0.5 });
    }
  }
}

/** All that is drawn over the picture. @param {Pen} pen @param {Sketch} sketch */
export function drawSketch(pen, sketch) {
  const { app, held } = sketch;
  if (!sketch.isOn) return;
  const projection = app.view.projection(app.area);
  if (!sketch.isCurrent && held === null) drawHalf(pen, sketch, projection);
  if (sketch.isMoving && held === null) return;
  const places = sketch.places();
  const pointer = pointed(sketch, projection);
  if (sketch.cursor !== null && pointer !== null) drawAim(pen, pointer, app.palette);
  const place = pointer === null || held !== null ? null : sketch.from !== null ? strokeEnd(sketch, projection, pointer[0], pointer[1]) : snapped(places, projection, pointer[0], pointer[1]);
  drawHandles(pen, sketch, places, projection, place);
  if (held !== null) drawHeld(pen, sketch, held, projection);
  else if (sketch.from !== null && place !== null) drawBegun(pen, sketch, place, projection);
  else if (place !== null && place.onto === null && sketch.tool === "bar") drawGuides(pen, place, projection, app.palette);
}

/** What is under the hand: the pointer, or the place that arrow keys have chosen. @param {Sketch} sketch @param {Projection} projection */
function pointed({ app, cursor }, projection) {
  if (cursor !== null) return projection.point(cursor[0], cursor[1], 0);
  return app.pointer === null ? null : [app.pointer.x, app.pointer.y];
}

/** @param {Pen} pen @param {number[]} at @param {Palette} palette */
function drawAim(pen, [x, y], palette) {
  for (const line of [[x - 14, y, x + 14, y], [x, y - 14, x, y + 14]]) pen.line(line, { stroke: palette.select, width: 2 });
}

/** Half a mechanism: bodies and the ground as the text tells them. @param {Pen} pen @param {Sketch} sketch @param {Projection} projection */
function drawHalf(pen, sketch, projection) {
  const { places, parts } = sketch.sheet;
  const { palette } = sketch.app;
  /** @type {Map<string, PlacedPort[]>} */
  const owners = new Map();
  for (const place of places) owners.set(place.owner, [...(owners.get(place.owner) ?? []), place]);
  const width = Math.max(3, DRAWN_WIDTH * projection.scale);
  for (const [owner, ports] of owners) {
    const points = ports.map(({ at }) => projection.point(at[0], at[1], 0));
    if (owner === "ground") for (const [x, y] of points) pen.polygon([x, y, x - 9, y + 15, x + 9, y + 15], { stroke: palette.faint, width: 1.5, dash: [4, 3] });
    else pen.polygon(roundedHull(points, width), { fill: palette.faint, stroke: palette.faint, width: 1.5, opacity: 0.3 });
  }
  const at = new Map(places.map((place) => [portKey(place), place.at]));
  for (const part of parts) {
    const [one, other] = part.ports.map((port) => at.get(portKey(port)));
    if (one === undefined || other === undefined) continue;
    const gap = Math.hypot(other[0] - one[0], other[1] - one[1]);
    const [from, to] = [one, other].map(([x, y]) => projection.point(x, y, 0));
    pen.line([...from, ...to], { stroke: part.pin ? palette.fault : palette.faint, width: 1.5, dash: [4, 3] });
    if (part.pin && gap * projection.scale > 3) drawGap(pen, sketch, to, `${millimetres(gap)} mm missing: ${part.name}`);
  }
}

/** @param {Pen} pen @param {Sketch} sketch @param {number[]} at on the screen @param {string} text */
function drawGap(pen, { app }, [x, y], text) {
  pen.polygon(circleOutline(x, y, 14), { stroke: app.palette.fault, width: 2, dash: [5, 4] });
  drawLabel(pen, x, y, text, app.area, app.palette);
}

/** @param {Pen} pen @param {Sketch} sketch @param {PlacedPort[]} places @param {Projection} projection @param {Snapped | null} under what is under the pointer */
function drawHandles(pen, sketch, places, projection, under) {
  const { palette } = sketch.app;
  const chosen = sketch.chosen === null ? null : pinOf(sketch.sheet.parts, sketch.chosen);
  for (const place of places) {
    const [x, y] = projection.point(place.at[0], place.at[1], 0);
    const isNear = under?.onto != null && portKey(under.onto) === portKey(place);
    const r = isNear ? HANDLE_NEAR : HANDLE;
    const isChosen = chosen?.has(portKey(place)) === true;
    pen.polygon([x - r, y - r, x + r, y - r, x + r, y + r, x - r, y + r], { fill: isNear || isChosen ? palette.select : palette.background, stroke: palette.select, width: 1.5 });
  }
}

/** Lines through other pins that hold the hand. @param {Pen} pen @param {Snapped} place @param {Projection} projection @param {Palette} palette */
function drawGuides(pen, { at, along }, projection, palette) {
  const to = projection.point(at[0], at[1], 0);
  for (const line of along) pen.line([...projection.point(line[0], line[1], 0), ...to], { stroke: palette.select, width: 1, dash: [2, 4] });
}

/** What a second place will end. @param {Pen} pen @param {Sketch} sketch @param {Snapped} place @param {Projection} projection */
function drawBegun(pen, sketch, place, projection) {
  const { app, from, tool } = sketch;
  if (from === null) return;
  const { palette } = app;
  const pointer = pointed(sketch, projection);
  const guide = pointer === null ? null : guideAt(sketch, projection, pointer[0], pointer[1]);
  const [x, y] = projection.point(from.at[0], from.at[1], 0);
  const [px, py] = projection.point(place.at[0], place.at[1], 0);
  drawGuides(pen, place, projection, palette);
  // A rail goes on at both sides.
  if (tool === "slide" && guide === null) pen.line([2 * x - px, 2 * y - py, px, py], { stroke: palette.select, width: 2, dash: [10, 4] });
  else pen.line([x, y, px, py], { stroke: palette.select, width: 3, dash: [6, 4] });
  drawLabel(pen, px, py, guide === null ? lineText(from.at, place.at) : `along ${guide}`, app.area, palette);
}

/** What is held, where it goes, and the path of a point. @param {Pen} pen @param {Sketch} sketch @param {HeldPin} held @param {Projection} projection */
function drawHeld(pen, sketch, held, projection) {
  const { app } = sketch;
  const { palette, live } = app;
  if (held.path.length > 2) {
    const line = [];
    for (let at = 0; at < held.path.length; at += 2) line.push(...projection.point(held.path[at], held.path[at + 1], 0));
    pen.line(line, { stroke: palette.trace[0], width: 2 });
  }
  if (held.snapped === null) return;
  drawGuides(pen, held.snapped, projection, palette);
  const [x, y] = projection.point(held.to[0], held.to[1], 0);
  if (held.snapped.onto !== null) pen.polygon(circleOutline(x, y, 11), { stroke: palette.select, width: 2.5 });
  const isOpen = held.isReady && live !== null && !live.isAssembled;
  const words = held.why === "" && isOpen && held.told.length === 0 ? missingWords(live.trouble) : held.words;
  const isWarned = held.told.length > 0 || held.stops !== null;
  if (isOpen || (isWarned && held.why === "")) pen.polygon(circleOutline(x, y, 14), { stroke: palette.fault, width: 2, dash: [5, 4] });
  drawLabel(pen, x, y, words, app.area, palette);
}
