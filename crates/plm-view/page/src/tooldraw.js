// Tools in the picture: instant centres, centrodes, measures.

import { drawArrow } from "./arrows.js";
import { centrodes, instantCentre, motionOf } from "./centres.js";
import { markOf, measured, measureOf, placeOfMark, unitOf } from "./measure.js";
import { movedOutline } from "./outline.js";
import { BAR } from "./scene.js";
import { quantityText } from "./text.js";

/** @import {App} from "./app.js" */
/** @import {Centrodes, Motion} from "./centres.js" */
/** @import {Mark, Measure} from "./measure.js" */
/** @import {Palette} from "./palette.js" */
/** @import {Pen} from "./pen.js" */
/** @import {Moment, Run} from "./run.js" */
/** @import {Scene} from "./scene.js" */
/** @import {Places} from "./solid.js" */
/** @import {Projection} from "./view.js" */

/**
 * What the picture shows now; `taken`: where words stand already, x y and half their widths.
 * @typedef {{places: Places, moment: Moment, projection: Projection, palette: Palette, taken: number[][]}} Now
 */

/** Centres that are farther away than so many bodies are left out. */
const FAR = 60;
const CROSS = 5;
/** Length of the sides of an angle, and radius of its arc, pixels. */
const SIDE = 46;

/** @type {WeakMap<Run, Map<number, Centrodes>>} */
const knownCentrodes = new WeakMap();

/** @param {Pen} pen @param {App} app @param {Scene} scene @param {Omit<Now, "taken">} shown */
export function drawTools(pen, app, scene, shown) {
  /** @type {Now} */
  const now = { ...shown, taken: [] };
  const { tools } = app;
  const { mechanism } = scene;
  if (tools.centrodes) drawCentrodes(pen, app, scene, now);
  if (tools.centres) drawCentres(pen, app, scene, now);
  for (const name of tools.measures) {
    const measure = measureOf(mechanism, name);
    if (measure !== null) drawMeasure(pen, scene, measure, now);
  }
  for (const mark of app.marks) drawMark(pen, scene, mark, now, true);
}

/**
 * A cross with a name, where it is in the picture.
 * @param {Pen} pen
 * @param {number[]} at pixels
 * @param {string} name
 * @param {Now} now
 */
function drawCross(pen, [x, y], name, { projection: { area }, palette, taken }) {
  if (x < area.x || y < area.y || x > area.x + area.width || y > area.y + area.height) return;
  for (const [stroke, width] of /** @type {[string, number][]} */ ([[palette.background, 4], [palette.velocity, 1.8]])) {
    pen.line([x - CROSS, y - CROSS, x + CROSS, y + CROSS], { stroke, width });
    pen.line([x - CROSS, y + CROSS, x + CROSS, y - CROSS], { stroke, width });
  }
  const half = 3.5 * name.length;
  const line = freeLine(taken, x + 9 + half, y + 11, half);
  pen.text(x + 9, line, name, { colour: palette.velocity, size: 12, halo: palette.background });
}

/** Of each body against the ground; of a pair the common one too, and the line on which Kennedy's theorem has all three. @param {Pen} pen @param {App} app @param {Scene} scene @param {Now} now */
function drawCentres(pen, { tools }, scene, now) {
  const { run, mechanism, levels } = scene;
  const { projection, palette, places, moment } = now;
  const motions = mechanism.bodies.map((_, body) => motionOf(run, moment, body, places.poses));
  const centreOnScreen = (/** @type {Motion} */ a, /** @type {Motion | undefined} */ b, /** @type {number} */ body) => {
    const centre = instantCentre(a, b);
    const isFar = centre === null || Math.hypot(centre[0] - a.x, centre[1] - a.y) > (FAR * scene.radius) / BAR;
    return isFar ? null : projection.point(centre[0], centre[1], levels.bodies[body]);
  };
  const [a, b] = tools.pair.map((name) => mechanism.bodies.findIndex((body) => body.name === name));
  const grounded = motions.map((motion, body) => centreOnScreen(motion, undefined, body));
  if (a >= 0 && b >= 0) {
    const common = centreOnScreen(motions[a], motions[b], a);
    const line = [grounded[a], grounded[b], common].filter((at) => at !== null).sort((p, q) => p[0] - q[0] || p[1] - q[1]);
    if (line.length === 3) pen.line([...line[0], ...line[2]], { stroke: palette.velocity, width: 1, dash: [5, 4] });
    if (common !== null) drawCross(pen, common, `${tools.pair.join("–")}`, now);
  }
  // Bodies with one centre share a cross.
  const names = new Map(grounded.map((at, body) => [at === null ? "" : at.map(Math.round).join(), body]));
  for (const [key, body] of names) {
    const at = grounded[body];
    if (at === null) continue;
    const same = mechanism.bodies.filter((_, other) => grounded[other]?.map(Math.round).join() === key);
    drawCross(pen, at, same.map(({ name }) => name).join(", "), now);
  }
}

/** Of the selected body: on the ground as a line, on the body with dashes; they roll on one another. @param {Pen} pen @param {App} app @param {Scene} scene @param {Now} now */
function drawCentrodes(pen, app, scene, { projection, palette, places }) {
  const { selected, tools } = app;
  const named = scene.mechanism.bodies.findIndex(({ name }) => name === tools.pair[0]);
  const body = selected?.kind === "body" ? selected.index : named;
  if (body < 0) return;
  const { fixed, moving } = centrodesOf(scene, body);
  const z = scene.levels.bodies[body];
  const stroke = palette.velocity;
  for (const line of fixed) pen.line(projection.line(line, z), { stroke, width: 1.6, opacity: 0.8 });
  const pose = places.poses.subarray(3 * body, 3 * body + 3);
  for (const line of moving) pen.line(projection.line(movedOutline(line, pose), z), { stroke, width: 1.6, opacity: 0.8, dash: [6, 4] });
}

/** @param {Scene} scene @param {number} body */
function centrodesOf({ run, radius }, body) {
  const known = knownCentrodes.get(run) ?? new Map();
  knownCentrodes.set(run, known);
  const found = known.get(body);
  if (found?.version === run.version) return found;
  const made = centrodes(run, body, (FAR * radius) / BAR);
  known.set(body, made);
  return made;
}

/** @param {Scene} scene @param {Mark} mark @param {Now} now */
function markOnScreen({ mechanism, levels, radius }, mark, { places, projection }) {
  const [x, y] = placeOfMark(mark, places, mechanism);
  const port = mechanism.ground.find(({ name }) => `ground.${name}` === mark.name);
  const z = mark.body === null ? (port?.depth ?? 0) : levels.bodies[mark.body];
  return { x, y, z: z + 0.5 * radius, at: projection.point(x, y, z + 0.5 * radius) };
}

/** @param {Pen} pen @param {Scene} scene @param {Mark} mark @param {Now} now @param {boolean} isNamed */
function drawMark(pen, scene, mark, now, isNamed) {
  const [x, y] = markOnScreen(scene, mark, now).at;
  const { palette } = now;
  const corners = Array.from({ length: 32 }, (_, at) => (at % 2 === 0 ? x + 4.5 * Math.cos((Math.PI * at) / 16) : y + 4.5 * Math.sin((Math.PI * (at - 1)) / 16)));
  pen.polygon(corners, { fill: palette.background, stroke: palette.ink, width: 1.6 });
  if (isNamed) pen.text(x + 9, y - 10, mark.name, { colour: palette.ink, size: 12, halo: palette.background });
}

/** @param {Pen} pen @param {Scene} scene @param {Measure} measure @param {Now} now */
function drawMeasure(pen, scene, measure, now) {
  const { unit, factor } = unitOf(scene.run, measure.kind);
  const value = measured(measure, now.places, scene.mechanism);
  if (!Number.isFinite(value)) return;
  const text = quantityText(value / factor, unit);
  if (measure.kind === "distance") drawDistance(pen, scene, measure, now, text);
  else drawAngle(pen, scene, measure, now, value, text);
}

/** The next place from `y` on downwards for words of half a width around `x`, which is taken then. @param {number[][]} taken @param {number} x @param {number} y @param {number} half */
function freeLine(taken, x, y, half) {
  let line = y;
  while (taken.some(([tx, ty, other]) => Math.abs(tx - x) < half + other && Math.abs(ty - line) < 15)) line += 4;
  taken.push([x, line, half]);
  return line;
}

/** A value, farther down where another one stands. @param {Pen} pen @param {number[]} at @param {string} text @param {Now} now */
function writeValue(pen, [x, y], text, { palette, taken }) {
  pen.text(x, freeLine(taken, x, y, 4 * text.length), text, { colour: palette.ink, size: 13, align: "middle", bold: true, halo: palette.background });
}

/** @param {Pen} pen @param {Scene} scene @param {Measure} measure @param {Now} now @param {string} text */
function drawDistance(pen, scene, { marks }, now, text) {
  const { palette } = now;
  const [from, to] = marks.map((mark) => markOnScreen(scene, mark, now).at);
  const middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
  pen.line([...from, ...to], { stroke: palette.background, width: 5, opacity: 0.7 });
  drawArrow(pen, middle, from, palette.ink);
  drawArrow(pen, middle, to, palette.ink);
  // Beside the line, whichever way it runs.
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  const [nx, ny] = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
  const side = ny > 0 ? -1 : 1;
  const along = Math.abs(nx) * 3.6 * text.length + Math.abs(ny) * 12;
  writeValue(pen, [middle[0] + side * nx * along, middle[1] + side * ny * along], text, now);
  for (const mark of marks) drawMark(pen, scene, mark, now, false);
}

/** @param {Pen} pen @param {Scene} scene @param {Measure} measure @param {Now} now @param {number} value rad @param {string} text */
function drawAngle(pen, scene, { marks }, now, value, text) {
  const { palette, projection, places } = now;
  const isBodies = marks[0].point === null;
  const { x, y, z } = markOnScreen(scene, marks[isBodies ? 0 : 1], now);
  const [tx, ty] = placeOfMark(marks[0], places, scene.mechanism);
  const first = isBodies ? places.poses[3 * (marks[0].body ?? 0) + 2] : Math.atan2(ty - y, tx - x);
  const reach = SIDE / projection.scale;
  const point = (/** @type {number} */ angle, /** @type {number} */ share) =>
    projection.point(x + share * reach * Math.cos(angle), y + share * reach * Math.sin(angle), z);
  const arc = Array.from({ length: 33 }, (_, at) => point(first + (value * at) / 32, 0.8)).flat();
  const sides = [first, first + value].map((angle) => [...point(angle, 0), ...point(angle, isBodies ? 1.5 : 1.1)]);
  for (const line of [...sides, arc]) pen.line(line, { stroke: palette.background, width: 5, opacity: 0.7 });
  for (const line of sides) pen.line(line, { stroke: palette.ink, width: 1.4, dash: [5, 3] });
  pen.line(arc, { stroke: palette.ink, width: 1.8 });
  if (!isBodies) for (const mark of marks) drawMark(pen, scene, mark, now, false);
  writeValue(pen, point(first + 0.5 * value, 1.35), text, now);
}

/** Whether a mark is of this mechanism. @param {App} app @param {string} name */
export function knowsMark({ run }, name) {
  return run !== null && markOf(run.mechanism, name) !== null;
}
