// Arrows of forces and velocities, with their scale.

import { niceNear } from "./numbers.js";
import { framePose } from "./solid.js";
import { quantityText } from "./text.js";

/** @import {Pen} from "./pen.js" */
/** @import {Run, Moment} from "./run.js" */
/** @import {Scene} from "./scene.js" */
/** @import {Places} from "./solid.js" */
/** @import {Projection} from "./view.js" */

/** @typedef {{name: string, x: number, y: number, z: number, u: number, v: number}} Arrow from a point, in the unit of its quantity */
/** @typedef {{unit: string, largest: number, arrows: (places: Places, moment: Moment) => Arrow[]}} ArrowField */

/** Rows that are looked at for the largest arrow of a run. */
const ARROW_SAMPLES = 4000;
/** The length of the largest arrow in sizes of bars, before the user's factor. */
const LONGEST = 18;

/**
 * Forces of joints: what each does to the body of its first frame, or to the other one if that is the ground.
 * @param {Scene} scene
 * @returns {ArrowField}
 */
export function forceField(scene) {
  const { run, mechanism } = scene;
  const column = new Map(run.columns.map(({ name, factor }, index) => [name, { index, factor: factor ?? 1 }]));
  // In N, in whatever unit a column is.
  const force = (/** @type {number} */ row, /** @type {{index: number, factor: number}} */ { index, factor }) =>
    run.values.at(row, index) * factor;
  const joints = mechanism.parts.flatMap((part) => {
    const [x, y] = [column.get(`${part.name}.force.x`), column.get(`${part.name}.force.y`)];
    if (x === undefined || y === undefined || part.frames.length === 0) return [];
    const standsOnGround = part.frames[0].body === null && part.frames.length > 1;
    // A pin in a slot feels the force at the pin, which is the second frame.
    const at = standsOnGround || part.pair === "pin_slot" ? Math.min(1, part.frames.length - 1) : 0;
    return [{ name: part.name, frame: part.frames[at], sign: standsOnGround ? -1 : 1, x, y }];
  });
  const size = (/** @type {number} */ row) =>
    joints.map(({ x, y }) => Math.hypot(force(row, x), force(row, y)));
  const arrows = (/** @type {Places} */ places, /** @type {Moment} */ { row, share }) =>
    joints.map(({ name, frame, sign, x, y }) => {
      const between = (/** @type {{index: number, factor: number}} */ at) => {
        const value = force(row, at);
        return share === 0 ? value : (1 - share) * value + share * force(row + 1, at);
      };
      const [px, py] = framePose(mechanism, frame, places);
      return { name, x: px, y: py, z: scene.slabOf(frame)[1], u: sign * between(x), v: sign * between(y) };
    });
  return { unit: "N", largest: largestOf(run, size), arrows };
}

/**
 * Velocities of the centres of gravity.
 * @param {Scene} scene
 * @returns {ArrowField}
 */
export function velocityField(scene) {
  const { run, mechanism } = scene;
  const bodies = mechanism.bodies.map((_, index) => index);
  const size = (/** @type {number} */ row) =>
    bodies.map((body) => Math.hypot(run.poses.at(row, 6 * body + 3), run.poses.at(row, 6 * body + 4)));
  const arrows = (/** @type {Places} */ places, /** @type {Moment} */ { row, share }) =>
    bodies.map((body) => {
      const between = (/** @type {number} */ at) => {
        const value = run.poses.at(row, at);
        return share === 0 ? value : (1 - share) * value + share * run.poses.at(row + 1, at);
      };
      const [x, y] = [places.poses[3 * body], places.poses[3 * body + 1]];
      const z = scene.slabOf({ argument: "", body, port: null })[1];
      return { name: mechanism.bodies[body].name, x, y, z, u: between(6 * body + 3), v: between(6 * body + 4) };
    });
  return { unit: "m/s", largest: largestOf(run, size), arrows };
}

/**
 * The largest finite size over the rows, sampled where there are many.
 * @param {Run} run
 * @param {(row: number) => number[]} sizes
 */
function largestOf(run, sizes) {
  const stride = Math.max(1, Math.floor(run.rows / ARROW_SAMPLES));
  let largest = 0;
  for (let row = 0; row < run.rows; row += stride) {
    for (const size of sizes(row)) if (size > largest && Number.isFinite(size)) largest = size;
  }
  return largest;
}

/**
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {ArrowField} field
 * @param {{places: Places, moment: Moment, projection: Projection, colour: string, factor: number,
 *   only?: string[] | null}} how `only`: names of those that are drawn
 */
export function drawArrows(pen, scene, field, { places, moment, projection, colour, factor, only = null }) {
  const metres = metresFor(scene, field, factor);
  for (const { name, x, y, z, u, v } of field.arrows(places, moment)) {
    if (!Number.isFinite(x + y + u + v) || only?.includes(name) === false) continue;
    const [from, to] = [projection.point(x, y, z), projection.point(x + metres * u, y + metres * v, z)];
    drawArrow(pen, from, to, colour);
  }
}

/**
 * Metres for a unit of the quantity.
 * @param {Scene} scene
 * @param {ArrowField} field
 * @param {number} factor
 */
function metresFor(scene, field, factor) {
  return field.largest > 0 ? (factor * LONGEST * scene.radius) / field.largest : 0;
}

/**
 * @param {Pen} pen
 * @param {number[]} from
 * @param {number[]} to
 * @param {string} colour
 */
export function drawArrow(pen, from, to, colour) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 1.5) return;
  const [ux, uy] = [dx / length, dy / length];
  const head = Math.min(10, 0.6 * length);
  const [bx, by] = [to[0] - head * ux, to[1] - head * uy];
  pen.line([from[0], from[1], bx, by], { stroke: colour, width: 2 });
  const half = 0.4 * head;
  pen.polygon([to[0], to[1], bx - half * uy, by + half * ux, bx + half * uy, by - half * ux], { fill: colour });
}

/**
 * What an arrow of a certain length means, in a corner.
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {ArrowField} field
 * @param {{projection: Projection, colour: string, ink: string, factor: number, name: string, line: number}} how
 */
export function drawArrowKey(pen, scene, field, { projection, colour, ink, factor, name, line }) {
  const pixels = metresFor(scene, field, factor) * projection.scale;
  const area = projection.area;
  const y = area.y + 18 + 20 * line;
  if (pixels === 0) {
    pen.text(area.x + 14, y, `${name}: none recorded`, { colour: ink, size: 12 });
    return;
  }
  const value = niceNear(50 / pixels);
  const length = Math.min(value * pixels, 0.4 * area.width);
  drawArrow(pen, [area.x + 14, y], [area.x + 14 + length, y], colour);
  pen.text(area.x + 22 + length, y, `${name} ${quantityText(value, field.unit)}`, { colour: ink, size: 12 });
}
