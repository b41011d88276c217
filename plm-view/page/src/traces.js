// Paths of points: of ports, or of the centre of gravity.

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
  const z = scene.levels.bodies[body];
  path.line.forEach((line, at) => {
    const points = projection.line(line, z);
    pen.line(points, { stroke: colour, width: 1.2, opacity: 0.35 });
    const travelled = path.times[at].filter((when) => when <= time).length;
    if (travelled > 1) pen.line(points.slice(0, 2 * travelled), { stroke: colour, width: 2 });
  });
}
