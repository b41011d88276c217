// Paths of points: of ports, or of the centre of gravity.

import { lastNotAbove } from "./numbers.js";

/** @import {Pen} from "./pen.js" */
/** @import {Run} from "./run.js" */
/** @import {Scene} from "./scene.js" */
/** @import {Projection} from "./view.js" */

/** @typedef {{name: string, body: number, x: number, y: number}} TracePoint `arm.tip`, or `arm.G`; in the axes of the body */
/** @typedef {{version: number, stride: number, line: number[][], times: number[][]}} TracePath in unbroken pieces */

/** Points of a path at most: more cannot be told apart. */
const MOST_POINTS = 4000;

/**
 * All points that can be traced.
 * @param {Run} run
 * @returns {TracePoint[]}
 */
export function tracePoints(run) {
  return run.mechanism.bodies.flatMap((body, index) => [
    { name: `${body.name}.G`, body: index, x: 0, y: 0 },
    ...body.ports.map((port) => ({ name: `${body.name}.${port.name}`, body: index, x: port.x, y: port.y })),
  ]);
}

/**
 * @param {Run} run
 * @param {TracePoint} point
 * @returns {TracePath}
 */
export function tracePath(run, point) {
  const stride = Math.max(1, Math.ceil(run.rows / MOST_POINTS));
  /** @type {TracePath} */
  const path = { version: run.version, stride, line: [], times: [] };
  /** @type {number[]} */
  let line = [];
  /** @type {number[]} */
  let times = [];
  const finish = () => {
    if (line.length > 2) {
      path.line.push(line);
      path.times.push(times);
    }
    [line, times] = [[], []];
  };
  for (let row = 0; row < run.rows; row = row + stride < run.rows || row === run.rows - 1 ? row + stride : run.rows - 1) {
    const [x, y, angle] = [0, 1, 2].map((axis) => run.poses.at(row, 6 * point.body + axis));
    const [px, py] = [
      x + Math.cos(angle) * point.x - Math.sin(angle) * point.y,
      y + Math.sin(angle) * point.x + Math.cos(angle) * point.y,
    ];
    if (Number.isFinite(px + py)) {
      line.push(px, py);
      times.push(run.time.data[row]);
    } else {
      finish();
    }
  }
  finish();
  return path;
}

/**
 * The whole path faintly, and what has been travelled strongly.
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {TracePath} path
 * @param {{body: number, time: number, projection: Projection, colour: string}} how
 */
export function drawTrace(pen, scene, path, { body, time, projection, colour }) {
  for (const { points, times } of seenPath(path, projection, scene.levels.bodies[body])) {
    pen.line(points, { stroke: colour, width: 1.2, opacity: 0.35 });
    const travelled = 1 + lastNotAbove(times, times.length, time);
    if (travelled > 1) pen.line(points.slice(0, 2 * travelled), { stroke: colour, width: 2 });
  }
}

/** Points nearer than this, in pixels, are one. */
const NEAR = 0.5;

/** @typedef {{points: number[], times: number[]}} ScreenLine */

/** Paths as they were seen last: most frames look from the same place. @type {WeakMap<TracePath, {seen: string, lines: ScreenLine[]}>} */
const seenPaths = new WeakMap();

/** @param {TracePath} path @param {Projection} projection @param {number} z */
function seenPath(path, projection, z) {
  const { x0, y0, xx, xy, xz, yx, yy, yz } = projection;
  const seen = [x0, y0, xx, xy, xz, yx, yy, yz, z].join();
  const known = seenPaths.get(path);
  if (known?.seen === seen) return known.lines;
  const lines = path.line.map((line, at) => thinned(projection.line(line, z), path.times[at]));
  seenPaths.set(path, { seen, lines });
  return lines;
}

/** @param {number[]} all @param {number[]} when @returns {ScreenLine} */
function thinned(all, when) {
  /** @type {ScreenLine} */
  const kept = { points: [all[0], all[1]], times: [when[0]] };
  const last = when.length - 1;
  for (let at = 1; at <= last; at++) {
    const [x, y] = [all[2 * at], all[2 * at + 1]];
    const before = kept.points.length - 2;
    if (at < last && Math.abs(x - kept.points[before]) < NEAR && Math.abs(y - kept.points[before + 1]) < NEAR) continue;
    kept.points.push(x, y);
    kept.times.push(when[at]);
  }
  return kept;
}
