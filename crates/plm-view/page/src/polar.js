// Force of a joint in the plane: its vector as a hodograph, or its magnitude around the angle of a body.

import { linearTicks } from "./ticks.js";
import { shortNumber, withUnit } from "./text.js";

/** @import {Palette} from "./palette.js" */
/** @import {Pen} from "./pen.js" */
/** @import {Moment, Run} from "./run.js" */
/** @import {Area} from "./view.js" */

/** @typedef {{joint: string, body: string | null}} PolarChoice body null: the vector itself */
/** @typedef {{title: string, unit: string, read: (moment: Moment) => [number, number]}} PolarCurve points of the plane */

/** Points of a curve at most. */
const MOST_VECTORS = 4000;
const LETTER = 11;

/** Joints whose forces are recorded. @param {Run} run */
export function forceJoints(run) {
  const names = new Set(run.columns.map(({ name }) => name));
  return run.mechanism.parts.map(({ name }) => name).filter((name) => names.has(`${name}.force.x`) && names.has(`${name}.force.y`));
}

/**
 * @param {Run} run
 * @param {PolarChoice} choice
 * @returns {PolarCurve | null} null where the run has no such force
 */
export function polarCurve(run, { joint, body }) {
  const quantities = run.quantities();
  const find = (/** @type {string} */ name) => quantities.find((quantity) => quantity.name === name);
  const [x, y] = [find(`${joint}.force.x`), find(`${joint}.force.y`)];
  if (x === undefined || y === undefined) return null;
  const vector = (/** @type {Moment} */ moment) => [run.valueAt(x, moment), run.valueAt(y, moment)];
  const { unit } = x;
  if (body === null) return { title: `${joint}.force`, unit, read: (moment) => /** @type {[number, number]} */ (vector(moment)) };
  const index = run.mechanism.bodies.findIndex(({ name }) => name === body);
  if (index < 0) return null;
  const poses = new Float64Array(3 * run.mechanism.bodies.length);
  return {
    title: `|${joint}.force| around ${body}.angle`,
    unit,
    read: (moment) => {
      const size = Math.hypot(...vector(moment));
      run.posesAt(moment, poses);
      const angle = poses[3 * index + 2];
      return [size * Math.cos(angle), size * Math.sin(angle)];
    },
  };
}

/**
 * The largest distance from the middle that is finite, and unbroken pieces x y x y … over all rows.
 * @param {Run} run
 * @param {PolarCurve} curve
 */
export function polarPoints(run, curve) {
  const stride = Math.max(1, Math.ceil(run.rows / MOST_VECTORS));
  let largest = 0;
  /** @type {number[][]} */
  const pieces = [];
  let isBroken = true;
  for (let row = 0; row < run.rows; row = row + stride < run.rows || row === run.rows - 1 ? row + stride : run.rows - 1) {
    const [x, y] = curve.read({ row, share: 0 });
    const isGap = !Number.isFinite(x + y);
    if (!isGap) {
      if (isBroken) pieces.push([]);
      pieces[pieces.length - 1].push(x, y);
      largest = Math.max(largest, Math.hypot(x, y));
    }
    isBroken = isGap;
  }
  return { largest, pieces };
}

/**
 * Circles of equal size with their values, spokes, the curve, and an arrow to where it is now.
 * @param {Pen} pen
 * @param {Area} area
 * @param {{largest: number, pieces: number[][]}} points
 * @param {{palette: Palette, curve: PolarCurve, isAngular: boolean, now: [number, number] | null}} how
 */
export function drawPolar(pen, area, { largest, pieces }, { palette, curve, isAngular, now }) {
  const [cx, cy] = [area.x + 0.5 * area.width, area.y + 0.5 * area.height + 9];
  const radius = Math.max(20, 0.5 * Math.min(area.width - 60, area.height - 62));
  const most = largest > 0 ? 1.05 * largest : 1;
  const at = (/** @type {number} */ x, /** @type {number} */ y) => [cx + (x / most) * radius, cy - (y / most) * radius];
  const letters = { colour: palette.faint, size: LETTER };
  for (let degrees = 0; degrees < 360; degrees += 30) {
    const [x, y] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
    const isAxis = degrees % 90 === 0;
    pen.line([cx, cy, cx + radius * x, cy - radius * y], { stroke: isAxis ? palette.faint : palette.grid, width: isAxis ? 1.2 : 1 });
    const name = isAngular ? `${degrees}°` : { 0: "x", 90: "y" }[degrees];
    if (name !== undefined && (isAngular || isAxis)) {
      pen.text(cx + (radius + 14) * x, cy - (radius + 11) * y, name, { ...letters, align: "middle" });
    }
  }
  for (const { value, label } of linearTicks(0, most, 4).filter(({ value }) => value > 0 && value <= most)) {
    pen.polygon(circleAround(cx, cy, (value / most) * radius), { stroke: palette.grid, width: 1 });
    const [x, y] = at(0.924 * value, 0.383 * value);
    pen.text(x, y, label, { ...letters, align: "middle", halo: palette.background });
  }
  for (const piece of pieces) {
    const line = [];
    for (let point = 0; point < piece.length; point += 2) line.push(...at(piece[point], piece[point + 1]));
    if (line.length === 2) line.push(line[0] + 0.01, line[1]);
    pen.line(line, { stroke: palette.force, width: 1.6 });
  }
  if (now !== null && Number.isFinite(now[0] + now[1])) {
    const [x, y] = at(...now);
    pen.line([cx, cy, x, y], { stroke: palette.ink, width: 1.4 });
    pen.polygon(circleAround(x, y, 3.5), { fill: palette.ink });
  }
  pen.text(area.x + 4, area.y + 10, withUnit(curve.title, curve.unit), { ...letters, colour: palette.ink, size: 12 });
}

/** @param {number} x @param {number} y @param {number} radius */
function circleAround(x, y, radius) {
  return Array.from({ length: 96 }, (_, at) => {
    const angle = (Math.PI * (at >> 1)) / 24;
    return at % 2 === 0 ? x + radius * Math.cos(angle) : y + radius * Math.sin(angle);
  });
}

/** What it says now, for who does not see it. @param {[number, number]} point @param {PolarCurve} curve */
export function polarText([x, y], curve) {
  return `${curve.title}: ${withUnit(shortNumber(Math.hypot(x, y)), curve.unit)}`;
}
