// Solids: slabs along z with an outline; and where frames are.

import { movedOutline } from "./outline.js";

/** @import {Frame, Mechanism} from "./format.js" */

/** @typedef {{kind: "body" | "part" | "port", index: number}} Item what can be selected; a port is one of the ground */
/** @typedef {"body" | "ground" | "joint" | "mount" | "cylinder" | "rod" | "groove" | "spring"} Tone */
/** @typedef {{poses: Float64Array, ground: Float64Array}} Places x y θ of each body, and of each port of the ground */
/**
 * A slab from z0 to z1. Its outline is fixed to a body (or to the ground: -1), or made anew at every time; null where it
 * cannot be drawn. `side` 1 or -1: it can be seen from that side along z alone.
 * @typedef {{item: Item, tone: Tone, z0: number, z1: number, body: number, outline: number[] | null,
 *   shape: ((places: Places) => number[] | null) | null, isLine: boolean, side: number}} Piece
 */

/**
 * @param {Item} item
 * @param {Tone} tone
 * @param {[number, number]} slab
 * @param {number} body
 * @param {number[]} outline
 * @param {number} [side]
 * @returns {Piece}
 */
export function fixedPiece(item, tone, slab, body, outline, side = 0) {
  return { item, tone, z0: slab[0], z1: slab[1], body, outline, shape: null, isLine: false, side };
}

/**
 * The outline of a piece in absolute axes; null where it cannot be drawn.
 * @param {Piece} piece
 * @param {Places} places
 */
export function outlineAt(piece, places) {
  const outline =
    piece.shape !== null
      ? piece.shape(places)
      : piece.outline !== null && piece.body >= 0
        ? movedOutline(piece.outline, places.poses.subarray(3 * piece.body, 3 * piece.body + 3))
        : piece.outline;
  return outline !== null && Number.isFinite(outline[0] + outline[1]) ? outline : null;
}

/**
 * Place and angle of a frame: x y θ in absolute axes.
 * @param {Mechanism} mechanism
 * @param {Frame} frame
 * @param {Places} places
 * @returns {[number, number, number]}
 */
export function framePose(mechanism, frame, places) {
  const { body, port } = frame;
  if (body === null) {
    if (port === null) return [0, 0, 0];
    return [places.ground[3 * port], places.ground[3 * port + 1], places.ground[3 * port + 2]];
  }
  const [x, y, angle] = [places.poses[3 * body], places.poses[3 * body + 1], places.poses[3 * body + 2]];
  if (port === null) return [x, y, angle];
  const at = mechanism.bodies[body].ports[port];
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [x + cos * at.x - sin * at.y, y + sin * at.x + cos * at.y, angle + at.angle];
}
