// What is under the pointer: by geometry, from the nearest piece to the farthest.

import { distanceToLine, isInside } from "./outline.js";
import { placePieces } from "./place.js";

/** @import {Placed} from "./place.js" */
/** @import {Scene} from "./scene.js" */
/** @import {Item, Places} from "./solid.js" */
/** @import {Projection} from "./view.js" */

/** How near, in pixels, is near enough for a line or a small piece: for a mouse, and for a finger. */
const REACH = 5;
export const FINGER_REACH = 22;

/**
 * @param {Scene} scene
 * @param {Places} places
 * @param {Projection} projection
 * @param {number} x
 * @param {number} y
 * @param {{reach?: number, kind?: Item["kind"] | null}} [how] how near is near enough, and what alone is looked for
 * @returns {Item | null}
 */
export function pickItem(scene, places, projection, x, y, { reach = REACH, kind = null } = {}) {
  const all = placePieces(scene, places, projection).reverse();
  const placed = kind === null ? all : all.filter(({ piece }) => piece.item.kind === kind);
  const hit = placed.find((candidate) => isHit(candidate, x, y));
  if (hit !== undefined) return hit.piece.item;
  let [nearest, distance] = [/** @type {Item | null} */ (null), reach];
  for (const candidate of placed) {
    const away = borderDistance(candidate, x, y);
    if (away < distance) [nearest, distance] = [candidate.piece.item, away];
  }
  return nearest;
}

/** @param {Placed} placed @param {number} x @param {number} y */
function isHit(placed, x, y) {
  const { near, far, piece } = placed;
  if (piece.isLine) return distanceToLine(near, x, y) < REACH;
  if (isInside(near, x, y)) return true;
  if (far === near) return false;
  return isInside(far, x, y) || placed.strips.some(({ from, lights }) => isOnWall(placed, from, lights.length, x, y));
}

/** @param {Placed} placed @param {number} from @param {number} count @param {number} x @param {number} y */
function isOnWall({ near, far }, from, count, x, y) {
  const corners = near.length / 2;
  for (let step = 0; step < count; step++) {
    const [a, b] = [2 * ((from + step) % corners), 2 * ((from + step + 1) % corners)];
    const wall = [near[a], near[a + 1], near[b], near[b + 1], far[b], far[b + 1], far[a], far[a + 1]];
    if (isInside(wall, x, y)) return true;
  }
  return false;
}

/** @param {Placed} placed @param {number} x @param {number} y */
function borderDistance({ near }, x, y) {
  return distanceToLine([...near, near[0], near[1]], x, y);
}
