// A run that is shown, with all that is worked out once for it.

import { forceField, velocityField } from "./arrows.js";
import { isMarked } from "./run.js";
import { Scene } from "./scene.js";

/** @import {App} from "./app.js" */
/** @import {ArrowField} from "./arrows.js" */
/** @import {Run} from "./run.js" */

/** @import {Box} from "./view.js" */

/**
 * `ahead`: where a live run will go.
 * @typedef {{run: Run, scene: Scene, forces: ArrowField, velocities: ArrowField, isShown: boolean, ahead: Box | null}} RunView
 */

/** What is drawn of a run. @param {Run} run */
export function sceneOf(run) {
  const scene = new Scene(run);
  return { scene, forces: forceField(scene), velocities: velocityField(scene) };
}

/**
 * Curves for a first look: what was measured, with readings and residuals, else the first few columns of the first unit.
 * @param {Run | null} run
 */
export function usualCurves(run) {
  const quantities = run?.quantities() ?? [];
  const marked = quantities.filter(isMarked).slice(0, 4);
  if (marked.length > 0) {
    const isRead = (/** @type {string} */ name) => marked.some((mark) => mark.name.startsWith(`${name} `));
    const curves = quantities.filter((quantity) => !isMarked(quantity) && isRead(quantity.name));
    return [...curves, ...marked].map(({ name }) => name);
  }
  const first = quantities[0];
  return quantities.filter(({ unit }) => unit === first.unit).slice(0, 3).map(({ name }) => name);
}

/** Arrows keep the scale of the largest that was ever seen. @param {RunView} shown */
export function growArrows(shown) {
  const moment = { row: Math.max(0, shown.run.rows - 1), share: 0 };
  if (shown.run.rows === 0) return;
  for (const field of [shown.forces, shown.velocities]) {
    for (const { u, v } of field.arrows(shown.scene.places, moment)) {
      const size = Math.hypot(u, v);
      if (Number.isFinite(size)) field.largest = Math.max(field.largest, size);
    }
  }
}

/**
 * The times of events of a run, of its fault too, in rising order.
 * @param {Run} run
 * @returns {number[]}
 */
function eventTimes({ events, fault }) {
  const times = events.map(({ time }) => time);
  if (fault !== null) times.push(fault.time);
  return [...new Set(times)].sort((a, b) => a - b);
}

/** @param {App} app @param {number} direction 1 or -1 */
export function jumpToEvent({ run, player }, direction) {
  const times = run === null ? [] : eventTimes(run);
  const next = direction > 0 ? times.find((at) => at > player.time) : times.findLast((at) => at < player.time);
  player.stop();
  if (next !== undefined) player.seek(next);
}
