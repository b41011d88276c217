// Stretches of a run that are shown as a moving picture: all of it, one turn of a body, or as long as the motion takes to repeat.

/** @import {Run} from "./run.js" */

/** @typedef {"run" | "turn" | "loop"} StretchName */
/** @typedef {{from: number, to: number}} Stretch times */

/** Poses that differ by less are the same, as a share of how far they move; an angle by less, rad. */
const SAME_POSE = 0.01;

/**
 * One turn of a body, from a time on, or where there is no whole one behind it the last one before the end; null where the body makes none.
 * @param {Run} run
 * @param {number} body
 * @param {number} from
 * @returns {Stretch | null}
 */
export function turnOf(run, body, from) {
  const { times, angles } = unwrapped(run, body);
  const start = Math.max(0, times.findLastIndex((time) => time <= from));
  const ahead = crossing(times, angles, start, 1);
  if (ahead !== null) return { from: times[start], to: ahead };
  const back = crossing(times, angles, times.length - 1, -1);
  return back === null ? null : { from: back, to: times[times.length - 1] };
}

/**
 * The time at which an angle is a turn away from that of a row.
 * @param {number[]} times
 * @param {number[]} angles
 * @param {number} start
 * @param {1 | -1} step
 */
function crossing(times, angles, start, step) {
  for (let row = start + step; row >= 0 && row < times.length; row += step) {
    const far = Math.abs(angles[row] - angles[start]) - 2 * Math.PI;
    if (far < 0) continue;
    const before = Math.abs(angles[row - step] - angles[start]) - 2 * Math.PI;
    return times[row - step] + (before / (before - far)) * (times[row] - times[row - step]);
  }
  return null;
}

/** The angle of a body without jumps by whole turns. @param {Run} run @param {number} body */
export function unwrapped(run, body) {
  const times = Array.from({ length: run.rows }, (_, row) => run.time.data[row]);
  let turns = 0;
  const angles = times.map((_, row) => {
    const [angle, rate] = [run.poses.at(row, 6 * body + 2), run.poses.at(row, 6 * body + 5)];
    if (row > 0) {
      const width = times[row] - times[row - 1];
      const expected = run.poses.at(row - 1, 6 * body + 2) + 0.5 * width * (run.poses.at(row - 1, 6 * body + 5) + rate || 0);
      turns += Math.round((expected - angle) / (2 * Math.PI)) || 0;
    }
    return angle + 2 * Math.PI * turns;
  });
  return { times, angles };
}

/**
 * The shortest stretch from a time on behind which all bodies stand as at its beginning and move as there, but for whole turns; null
 * where they do not come back.
 * @param {Run} run
 * @param {number} from
 * @returns {Stretch | null}
 */
export function loopOf(run, from) {
  const count = run.mechanism.bodies.length;
  const start = run.momentAt(from).row;
  const size = Math.max(1e-12, ...Array.from({ length: 2 * count }, (_, at) => spreadOf(run, 6 * (at >> 1) + (at & 1))));
  const apart = (/** @type {number} */ row) => {
    let most = 0;
    for (let body = 0; body < count; body++) {
      const [dx, dy, turn] = [0, 1, 2].map((axis) => run.poses.at(row, 6 * body + axis) - run.poses.at(start, 6 * body + axis));
      const angle = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
      most = Math.max(most, Math.hypot(dx, dy) / size, Math.abs(angle));
    }
    return most;
  };
  const isSameWay = (/** @type {number} */ row) => {
    let along = 0;
    for (let body = 0; body < count; body++) {
      for (const [axis, unit] of [[3, size], [4, size], [5, 1]]) {
        along += (run.poses.at(row, 6 * body + axis) * run.poses.at(start, 6 * body + axis)) / (unit * unit);
      }
    }
    return along >= 0;
  };
  // Rows may be so far apart that none comes nearer than half a step.
  const step = start + 1 < run.rows ? apart(start + 1) : 0;
  let hasLeft = false;
  for (let row = start + 1; row < run.rows; row++) {
    const distance = apart(row);
    hasLeft ||= distance > 5 * SAME_POSE && distance > 3 * step;
    if (!hasLeft || distance > Math.max(SAME_POSE, 0.75 * step) || !isSameWay(row)) continue;
    const isNext = row + 1 < run.rows && apart(row + 1) < distance;
    return { from: run.time.data[start], to: run.time.data[isNext ? row + 1 : row] };
  }
  return null;
}

/** How far a number of the poses goes. @param {Run} run @param {number} column */
function spreadOf(run, column) {
  let [low, high] = [Infinity, -Infinity];
  for (let row = 0; row < run.rows; row++) {
    const value = run.poses.at(row, column);
    [low, high] = [Math.min(low, value), Math.max(high, value)];
  }
  return high - low;
}

/** The body whose turn is meant: the one that is asked for, or the first that makes one. @param {Run} run @param {number | null} asked @param {number} from */
export function turningBody(run, asked, from) {
  const bodies = run.mechanism.bodies.map((_, index) => index);
  const order = asked === null ? bodies : [asked, ...bodies];
  return order.find((body) => turnOf(run, body, from) !== null) ?? null;
}
