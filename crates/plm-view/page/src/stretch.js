// Stretches of a run that are shown as a moving picture: all of it, one turn of a body, or as long as the motion takes to repeat.

/** @import {Run} from "./run.js" */

/** @typedef {"run" | "turn" | "loop"} StretchName */
/** @typedef {{from: number, to: number}} Stretch times */

/** Poses that differ by less are the same, as a share of how far they move; an angle by less, rad. */
const SAME_POSE = 0.01;
/** Rows that are looked at for how far things move. */
const SAMPLES_OF_SPREAD = 1000;

/**
 * One turn of a body, from a time on, or where there is no whole one after it the last one before the end; null where the body makes none.
 * @param {Run} run
 * @param {number} body
 * @param {number} from
 * @returns {Stretch | null}
 */
export function turnOf(run, body, from) {
  if (run.rows < 2) return null;
  const start = run.momentAt(from).row;
  const ahead = crossing(run, body, start, 1);
  if (ahead !== null) return { from: run.time.data[start], to: ahead };
  const back = crossing(run, body, run.rows - 1, -1);
  return back === null ? null : { from: back, to: run.end };
}

/**
 * The time at which the angle of a body is a turn away from that of a row.
 * @param {Run} run
 * @param {number} body
 * @param {number} start
 * @param {1 | -1} step
 */
function crossing(run, body, start, step) {
  const [angle, rate] = [6 * body + 2, 6 * body + 5];
  const whole = 2 * Math.PI;
  let sum = 0;
  for (let row = start + step; row >= 0 && row < run.rows; row += step) {
    const before = row - step;
    const width = run.time.data[row] - run.time.data[before];
    const expected = 0.5 * width * (run.poses.at(row, rate) + run.poses.at(before, rate)) || 0;
    const change = run.poses.at(row, angle) - run.poses.at(before, angle);
    // It may have lost whole turns between the rows.
    const turned = change - whole * Math.round((change - expected) / whole);
    if (!Number.isFinite(turned)) return null;
    if (Math.abs(sum + turned) >= whole) return run.time.data[before] + ((whole - Math.abs(sum)) / Math.abs(turned)) * width;
    sum += turned;
  }
  return null;
}

/**
 * The shortest stretch from a time on after which all bodies stand as at its beginning and move as there, but for whole turns; null
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

/** How far a number of the poses goes, about. @param {Run} run @param {number} column */
function spreadOf(run, column) {
  let [low, high] = [Infinity, -Infinity];
  for (let row = 0; row < run.rows; row += Math.ceil(run.rows / SAMPLES_OF_SPREAD)) {
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
