// What is under the pointer: by geometry, from the nearest piece to the farthest.

import { distanceToLine, isInside } from "./outline.js";
import { placePieces } from "./place.js";

/** @import {Placed} from "./place.js" */
/** @import {Scene} from "./scene.js" */
/** @import {Item, Places} from "./solid.js" */
/** @import {Projection} from "./view.js" */

/** How near, in pixels, is near enough for a line or a small piece. */
const REACH = 5;

/**
 * @param {Scene} scene
 * @param {Places} places
 * @param {Projection} projection
 * @param {number} x
 * @param {number} y
 * @returns {Item | null}
 */
export function pickItem(scene, places, projection, x, y) {
  const placed = placePieces(scene, places, projection).reverse();
  const hit = placed.find((candidate) => isHit(candidate, x, y));
  const near = hit ?? placed.find((candidate) => borderDistance(candidate, x, y) < REACH);
  return near?.piece.item ?? null;
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
