// Paints placed pieces.

import { rgbText } from "./palette.js";
import { lightOn, placePieces } from "./place.js";

/** @import {Palette, Rgb} from "./palette.js" */
/** @import {Pen} from "./pen.js" */
/** @import {Placed, WallStrip} from "./place.js" */
/** @import {Scene} from "./scene.js" */
/** @import {Item, Places} from "./solid.js" */
/** @import {Projection} from "./view.js" */

/**
 * How a scene is painted: as surfaces or as frames; in its own colours, or all in the colour of another run; each body in a
 * colour of its own, or all in one where runs have theirs.
 * @typedef {{palette: Palette, isWire: boolean, selected: Item | null, ghost: Rgb | null, isPlain?: boolean}} Manner
 */

/** Walls of smaller pieces (in pixels) are painted in one colour. */
const SMALL = 14;

/**
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {Places} places
 * @param {Projection} projection
 * @param {Manner} manner
 */
export function drawScene(pen, scene, places, projection, manner) {
  const face = lightOn(0, 0, projection.toViewer[2] >= 0 ? 1 : -1, projection);
  const chosen = [];
  for (const placed of placePieces(scene, places, projection)) {
    drawPlaced(pen, placed, face, manner);
    if (sameItem(placed.piece.item, manner.selected)) chosen.push(placed);
  }
  // What is selected shows its outline through everything.
  for (const placed of chosen) drawContour(pen, placed, { stroke: manner.palette.select, width: 2.2 });
}

/**
 * @param {Item | null} a
 * @param {Item | null} b
 */
export function sameItem(a, b) {
  return a !== null && b !== null && a.kind === b.kind && a.index === b.index;
}

/** @param {Palette} palette @param {number} body -1: the ground @returns {Rgb} */
export function bodyColour({ bodies, tones }, body) {
  return body < 0 ? tones.ground : bodies[body % bodies.length];
}

/**
 * @param {Pen} pen
 * @param {Placed} placed
 * @param {number} face light on it
 * @param {Manner} manner
 */
function drawPlaced(pen, placed, face, { palette, isWire, ghost, isPlain = false }) {
  const { piece, near } = placed;
  const own = piece.tone === "body" && !isPlain ? bodyColour(palette, piece.body) : palette.tones[piece.tone];
  const rgb = ghost ?? own;
  const opacity = ghost === null ? 1 : 0.5;
  if (piece.isLine) {
    if (!isWire && ghost === null) pen.line(near, { stroke: rgbText(palette.edge), width: 3.4 });
    pen.line(near, { stroke: rgbText(rgb), width: 2, opacity });
    return;
  }
  if (isWire) {
    drawContour(pen, placed, { stroke: rgbText(rgb, palette.name === "light" ? 0.8 : 1.15), width: 1.2, opacity });
    if (placed.far !== near) pen.polygon(placed.far, { stroke: rgbText(rgb), width: 0.6, opacity: 0.5 * opacity });
    return;
  }
  const edge = ghost === null ? rgbText(palette.edge) : rgbText(ghost, 0.5);
  for (const strip of placed.strips) drawWalls(pen, placed, strip, { rgb, edge, opacity });
  pen.polygon(near, { fill: rgbText(rgb, face), stroke: edge, width: 1, opacity });
}

/**
 * @param {Pen} pen
 * @param {Placed} placed
 * @param {WallStrip} strip
 * @param {{rgb: Rgb, edge: string, opacity: number}} colours
 */
function drawWalls(pen, placed, strip, { rgb, edge, opacity }) {
  const { lights } = strip;
  const whole = stripPolygon(placed, strip.from, lights.length);
  if (isSmall(placed.near)) {
    pen.polygon(whole, { fill: rgbText(rgb, 0.8 * lights[lights.length >> 1]), stroke: edge, width: 1, opacity });
    return;
  }
  for (let at = 0; at < lights.length; ) {
    let end = at + 1;
    while (end < lights.length && lights[end] === lights[at]) end++;
    const fill = rgbText(rgb, 0.85 * lights[at]);
    // The thin line of its own colour closes the seam to the next one.
    pen.polygon(stripPolygon(placed, strip.from + at, end - at), { fill, stroke: fill, width: 0.7, opacity });
    at = end;
  }
  pen.polygon(whole, { stroke: edge, width: 1, opacity });
}

/**
 * The walls behind `count` corners, as one polygon: along the near face and back along the far one.
 * @param {Placed} placed
 * @param {number} from
 * @param {number} count
 */
function stripPolygon({ near, far }, from, count) {
  const corners = near.length / 2;
  const points = [];
  for (let step = 0; step <= count; step++) {
    const at = 2 * ((from + step) % corners);
    points.push(near[at], near[at + 1]);
  }
  for (let step = count; step >= 0; step--) {
    const at = 2 * ((from + step) % corners);
    points.push(far[at], far[at + 1]);
  }
  return points;
}

/** @param {number[]} points */
function isSmall(points) {
  let [low, high] = [points[0], points[0]];
  for (let at = 2; at < points.length; at += 2) {
    low = Math.min(low, points[at]);
    high = Math.max(high, points[at]);
  }
  return high - low < SMALL;
}

/**
 * @param {Pen} pen
 * @param {Placed} placed
 * @param {import("./pen.js").Paint} paint
 */
function drawContour(pen, placed, paint) {
  if (placed.piece.isLine) {
    pen.line(placed.near, { ...paint, width: 3 });
    return;
  }
  for (const strip of placed.strips) pen.polygon(stripPolygon(placed, strip.from, strip.lights.length), paint);
  pen.polygon(placed.near, paint);
}
