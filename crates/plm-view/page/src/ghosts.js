// Ghost poses: where the bodies are at equal intervals of the run, drawn faintly behind the picture.

import { drawScene } from "./draw.js";

/** @import {Palette} from "./palette.js" */
/** @import {Paint, Pen} from "./pen.js" */
/** @import {Run} from "./run.js" */
/** @import {Scene} from "./scene.js" */
/** @import {Projection} from "./view.js" */

/** Of a live run poses so far apart are drawn, s. */
const LIVE_STEP = 0.1;
export const MOST_GHOSTS = 60;

/**
 * The times of so many ghost poses: over all of a recording, from its first row to its last; of a live run the last ones, which stand
 * still while it goes on.
 * @param {Run} run
 * @param {number} count
 * @returns {number[]}
 */
export function ghostTimes(run, count) {
  if (run.rows < 2) return [];
  if (!run.isLive) {
    const step = (run.end - run.start) / Math.max(1, count - 1);
    return Array.from({ length: count }, (_, at) => (at === count - 1 ? run.end : run.start + at * step));
  }
  const last = Math.floor(run.end / LIVE_STEP);
  return Array.from({ length: count }, (_, at) => (last - count + 1 + at) * LIVE_STEP).filter((time) => time >= run.start);
}

/** A pen that paints all through. @param {Pen} pen @param {number} share @returns {Pen} */
function faintPen(pen, share) {
  const faint = (/** @type {Paint} */ paint) => ({ ...paint, opacity: share * (paint.opacity ?? 1) });
  return {
    polygon: (points, paint) => pen.polygon(points, faint(paint)),
    line: (points, paint) => pen.line(points, faint(paint)),
    text: (...text) => pen.text(...text),
    within: (area, draw) => pen.within(area, draw),
  };
}

/**
 * The bodies alone: what stands on the ground would be painted again and again.
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {number} count
 * @param {{projection: Projection, palette: Palette, isWire: boolean}} how
 */
export function drawGhosts(pen, scene, count, { projection, palette, isWire }) {
  const bodies = /** @type {Scene} */ ({ pieces: scene.pieces.filter(({ item }) => item.kind === "body") });
  const faint = faintPen(pen, Math.max(0.08, 0.4 / Math.sqrt(count)));
  for (const time of ghostTimes(scene.run, count)) {
    drawScene(faint, bodies, scene.at(time), projection, { palette, isWire, selected: null, ghost: null });
  }
}
