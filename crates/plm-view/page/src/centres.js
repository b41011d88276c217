// Instant centres: where two bodies have one velocity; and centrodes, which are their paths on each of the two.

import { hermiteRate } from "./numbers.js";

/** @import {Moment, Run} from "./run.js" */

/** @typedef {{x: number, y: number, angle: number, vx: number, vy: number, omega: number}} Motion of a body; rates a second */
/** @typedef {{version: number, fixed: number[][], moving: number[][]}} Centrodes unbroken pieces x y x y …: on the ground, and in the axes of the body */

/** The ground as a body. @type {Motion} */
const AT_REST = { x: 0, y: 0, angle: 0, vx: 0, vy: 0, omega: 0 };
/** Rows of a centrode at most. */
const MOST_ROWS = 2000;

/**
 * The motion of a body as it is drawn: the cubic through the recorded poses and rates, and its derivative. Where a recording has no
 * rates, they are differences of its rows.
 * @param {Run} run
 * @param {Moment} moment
 * @param {number | null} body null: the ground
 * @param {Float64Array} poses of all bodies at that moment
 * @returns {Motion}
 */
export function motionOf(run, { row, share }, body, poses) {
  if (body === null) return AT_REST;
  // The last row ends an interval.
  const isLast = row + 1 >= run.rows && row > 0;
  const [from, at] = isLast ? [row - 1, 1] : [row, share];
  const to = Math.min(from + 1, run.rows - 1);
  const width = run.time.data[to] - run.time.data[from];
  const rates = [0, 1, 2].map((axis) => {
    const [value, rate] = [6 * body + axis, 6 * body + axis + 3];
    let b = run.poses.at(to, value);
    const a = run.poses.at(from, value);
    if (axis === 2) b -= 2 * Math.PI * Math.round((b - a) / (2 * Math.PI)) || 0;
    return hermiteRate(at, width, a, run.poses.at(from, rate), b, run.poses.at(to, rate));
  });
  const [x, y, angle] = poses.subarray(3 * body, 3 * body + 3);
  return { x, y, angle, vx: rates[0], vy: rates[1], omega: rates[2] };
}

/**
 * The point at which two bodies have one velocity; null where they only slide along one another, so that it is infinitely far.
 * @param {Motion} a
 * @param {Motion} [b]
 * @returns {[number, number] | null}
 */
export function instantCentre(a, b = AT_REST) {
  const turn = a.omega - b.omega;
  // Velocities of the points of both bodies that are at the origin.
  const u = a.vx + a.omega * a.y - (b.vx + b.omega * b.y);
  const v = a.vy - a.omega * a.x - (b.vy - b.omega * b.x);
  const [x, y] = [-v / turn, u / turn];
  return Number.isFinite(x + y) ? [x, y] : null;
}

/**
 * A point in the axes of a body.
 * @param {Motion} body
 * @param {[number, number]} point
 */
export function inBody({ x, y, angle }, [px, py]) {
  const [cos, sin, dx, dy] = [Math.cos(angle), Math.sin(angle), px - x, py - y];
  return [cos * dx + sin * dy, cos * dy - sin * dx];
}

/**
 * Both centrodes of a body against the ground, over all rows; broken where the centre is farther away than `reach`.
 * @param {Run} run
 * @param {number} body
 * @param {number} reach
 * @returns {Centrodes}
 */
export function centrodes(run, body, reach) {
  /** @type {Centrodes} */
  const found = { version: run.version, fixed: [], moving: [] };
  const stride = Math.max(1, Math.ceil(run.rows / MOST_ROWS));
  const poses = new Float64Array(3 * run.mechanism.bodies.length);
  let isBroken = true;
  for (let row = 0; row < run.rows; row += stride) {
    for (let axis = 0; axis < 3; axis++) poses[3 * body + axis] = run.poses.at(row, 6 * body + axis);
    const motion = motionOf(run, { row, share: 0 }, body, poses);
    const centre = instantCentre(motion);
    if (centre === null || Math.hypot(centre[0] - motion.x, centre[1] - motion.y) > reach) {
      isBroken = true;
      continue;
    }
    if (isBroken) {
      found.fixed.push([]);
      found.moving.push([]);
    }
    isBroken = false;
    found.fixed[found.fixed.length - 1].push(...centre);
    found.moving[found.moving.length - 1].push(...inBody(motion, centre));
  }
  return found;
}
