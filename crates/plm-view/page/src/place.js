// Pieces on the screen, from the farthest to the nearest.

import { outlineAt } from "./solid.js";

/** @import {Scene} from "./scene.js" */
/** @import {Piece, Places} from "./solid.js" */
/** @import {Projection} from "./view.js" */

/**
 * A piece on the screen: the face that looks at the viewer, the one behind it, and its walls that can be seen, each a strip
 * of quadrangles.
 * @typedef {{piece: Piece, near: number[], far: number[], strips: WallStrip[], z: number, depth: number, order: number}} Placed
 * @typedef {{from: number, to: number, lights: number[]}} WallStrip corners `from` to `to` of the outline, going around it;
 *   the light on the wall behind each corner
 */

/** Above it the faces are seen so steeply that pieces of one level do not hide one another. */
const STEEP = 0.5;

/**
 * @param {Scene} scene
 * @param {Places} places
 * @param {Projection} projection
 * @returns {Placed[]}
 */
export function placePieces(scene, places, projection) {
  const [vx, vy, vz] = projection.toViewer;
  const front = vz >= 0 ? 1 : -1;
  /** @type {Placed[]} */
  const placed = [];
  scene.pieces.forEach((piece, order) => {
    if (piece.side * front < 0 && Math.abs(vz) > STEEP) return;
    const outline = outlineAt(piece, places);
    if (outline === null) return;
    const [nearZ, farZ] = front > 0 ? [piece.z1, piece.z0] : [piece.z0, piece.z1];
    const isFlat = piece.isLine || Math.hypot(vx, vy) < 1e-9;
    const near = projection.line(outline, piece.isLine ? 0.5 * (nearZ + farZ) : nearZ);
    placed.push({
      piece,
      near,
      far: isFlat ? near : projection.line(outline, farZ),
      strips: isFlat ? [] : wallStrips(outline, projection),
      z: 0.5 * (piece.z0 + piece.z1) * front,
      depth: Math.abs(vz) > STEEP ? 0 : outline[0] * vx + outline[1] * vy,
      order,
    });
  });
  // Slabs of different levels do not touch along z, so that their order is exact. Within one level it is the distance
  // where walls are seen, else the order of declaration.
  return placed.sort((a, b) => a.z - b.z || a.depth - b.depth || a.order - b.order);
}

/** Where the light comes from, in axes of the screen: right, up, to the viewer. */
const LIGHT_FROM = [-0.41, 0.58, 0.7];

/**
 * How light a surface is: 1 if it looks straight at the viewer.
 * @param {number} nx normal in absolute axes
 * @param {number} ny
 * @param {number} nz
 * @param {Projection} projection
 */
export function lightOn(nx, ny, nz, { right, up, toViewer }) {
  const along = (/** @type {number[]} */ axis) => nx * axis[0] + ny * axis[1] + nz * axis[2];
  const share = along(right) * LIGHT_FROM[0] + along(up) * LIGHT_FROM[1] + along(toViewer) * LIGHT_FROM[2];
  return Math.min(1.12, 0.6 + 0.4 * Math.max(0, share / LIGHT_FROM[2]));
}

/** Steps of light: walls of one step are painted at once. */
const LIGHT_STEPS = 12;

/**
 * @param {number[]} outline
 * @param {Projection} projection
 * @returns {WallStrip[]}
 */
function wallStrips(outline, projection) {
  const [vx, vy] = projection.toViewer;
  const count = outline.length / 2;
  /** @type {number[]} light on the wall behind each corner; -1 if it looks away */
  const lights = new Array(count);
  for (let corner = 0; corner < count; corner++) {
    const [at, next] = [2 * corner, 2 * ((corner + 1) % count)];
    const [dx, dy] = [outline[next] - outline[at], outline[next + 1] - outline[at + 1]];
    const length = Math.hypot(dx, dy);
    const facing = dy * vx - dx * vy;
    lights[corner] =
      length > 0 && facing > 1e-9 * length
        ? Math.round(LIGHT_STEPS * lightOn(dy / length, -dx / length, 0, projection)) / LIGHT_STEPS
        : -1;
  }
  return facingRuns(lights);
}

/**
 * Runs of corners with walls that face the viewer, once around.
 * @param {number[]} lights
 * @returns {WallStrip[]}
 */
function facingRuns(lights) {
  const count = lights.length;
  const away = lights.indexOf(-1);
  if (away < 0) return [];
  /** @type {WallStrip[]} */
  const strips = [];
  for (let step = 1; step <= count; step++) {
    const corner = (away + step) % count;
    if (lights[corner] < 0) continue;
    const from = corner;
    const run = [];
    while (lights[(away + step) % count] >= 0) {
      run.push(lights[(away + step) % count]);
      step++;
    }
    strips.push({ from, to: (from + run.length) % count, lights: run });
  }
  return strips;
}
