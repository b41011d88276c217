// What a page shows before anybody has chosen: the path of its most telling point, and the run as it plays.

import { SPEEDS } from "./player.js";
import { tracePoints } from "./traces.js";

/** @import {App} from "./app.js" */
/** @import {Run} from "./run.js" */
/** @import {TracePoint} from "./traces.js" */

/** Rows that a path is measured by. */
const SAMPLES = 200;
/** A run plays in no less than this, s: a shorter one is slowed down. */
const SHORTEST_SHOW = 2;

/**
 * The point whose path tells most: one whose position is a declared output; else the one with the longest path, first among those
 * that no joint holds and whose body does not turn on the ground, as of a coupler or of the last body.
 * @param {Run | null} run
 * @returns {string | null}
 */
export function tellingPoint(run) {
  if (run === null) return null;
  const points = tracePoints(run);
  const declared = run.columns.map(({ name }) => /^(.+?)(\.position)?\.x$/.exec(name)?.[1] ?? "");
  const named = points.find(({ name }) => declared.includes(name) || declared.includes(name.replace(/\.G$/, "")));
  if (named !== undefined) return named.name;
  const { grounded, held } = jointsOf(run);
  let best = { name: /** @type {string | null} */ (null), rank: -1, length: -1 };
  for (const point of points) {
    const isCentre = point.name.endsWith(".G");
    const rank = 2 * Number(!grounded.has(point.body)) + Number(!isCentre && !held.has(point.name));
    const length = pathLength(run, point);
    if (rank > best.rank || (rank === best.rank && length > 1.001 * best.length)) best = { name: point.name, rank, length };
  }
  return best.name;
}

/** The bodies that joints hold on the ground, and the points that joints hold. @param {Run} run */
function jointsOf({ mechanism: { parts, bodies } }) {
  /** @type {Set<number>} */
  const grounded = new Set();
  /** @type {Set<string>} */
  const held = new Set();
  for (const { pair, frames } of parts) {
    if (pair === null) continue;
    const isOnGround = frames.some(({ body }) => body === null);
    for (const { body, port } of frames) {
      if (body === null) continue;
      if (isOnGround) grounded.add(body);
      held.add(`${bodies[body].name}.${port === null ? "G" : bodies[body].ports[port].name}`);
    }
  }
  return { grounded, held };
}

/** @param {Run} run @param {TracePoint} point */
function pathLength(run, { body, x, y }) {
  const count = Math.min(run.rows, SAMPLES);
  let [length, lastX, lastY] = [0, NaN, NaN];
  for (let sample = 0; sample < count; sample++) {
    const row = count > 1 ? Math.round((sample * (run.rows - 1)) / (count - 1)) : 0;
    const [gx, gy, angle] = [0, 1, 2].map((axis) => run.poses.at(row, 6 * body + axis));
    const [px, py] = [gx + Math.cos(angle) * x - Math.sin(angle) * y, gy + Math.sin(angle) * x + Math.cos(angle) * y];
    length += Math.hypot(px - lastX, py - lastY) || 0;
    [lastX, lastY] = [px, py];
  }
  return length;
}

/**
 * Plays a recorded run over and over, one that ends with a fault once. Who asked for less motion begins it, and a link that names
 * a time shows that time.
 * @param {App} app
 * @param {string} hash the address after `#`
 */
export function playByItself(app, hash) {
  const asked = new URLSearchParams(hash.replace(/^#/, ""));
  const { player, run } = app;
  const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (run === null || app.live !== null || isStill || asked.has("t") || asked.has("play") || player.duration === 0) return;
  if (!asked.has("loop")) player.isLooping = run.fault === null;
  if (!asked.has("speed")) player.speed = openingSpeed(player.duration);
  player.play();
}

/** The fastest speed at which a run is long enough to be watched, real time at most. @param {number} duration s */
function openingSpeed(duration) {
  return SPEEDS.findLast((speed) => speed <= 1 && duration / speed >= SHORTEST_SHOW) ?? SPEEDS[0];
}
