// The solids of a mechanism: slabs along z with an outline, fixed to a body or moving with the time.

import { depthOfFrame, levelsOf } from "./levels.js";
import { contourOutline, roundedHull } from "./outline.js";
import { piecesOfPart } from "./pieces.js";
import { fixedPiece, outlineAt } from "./solid.js";

/** @import {Body, Frame, Mechanism} from "./format.js" */
/** @import {Piece, Places} from "./solid.js" */
/** @import {Run} from "./run.js" */
/** @import {Box} from "./view.js" */

export class Scene {
  /** @param {Run} run */
  constructor(run) {
    const { mechanism } = run;
    this.run = run;
    /** @type {Mechanism} */
    this.mechanism = mechanism;
    /** Half the width of a bar. */
    this.radius = BAR * typicalSize(run);
    this.levels = levelsOf(mechanism, 0.6 * this.radius);
    /** @type {Places} */
    this.places = placesFor(mechanism);
    /** @type {Piece[]} */
    this.pieces = [
      ...mechanism.bodies.flatMap((body, index) => this.bodyPieces(body, index)),
      ...mechanism.parts.flatMap((_, index) => piecesOfPart(this, index)),
    ];
  }

  /** @param {Frame} frame @returns {[number, number]} the slab along z of what the frame is on */
  slabOf(frame) {
    const half = 0.5 * this.levels.thickness;
    const middle = frame.body === null ? depthOfFrame(this.mechanism, frame) : this.levels.bodies[frame.body];
    return [middle - half, middle + half];
  }

  /**
   * @param {Body} body
   * @param {number} index
   * @returns {Piece[]}
   */
  bodyPieces(body, index) {
    const half = 0.5 * this.levels.thickness;
    const middle = this.levels.bodies[index];
    const outline =
      body.contour === null
        ? roundedHull(pointsOfBody(body), this.radiusOf(body, index))
        : contourOutline(body.contour, body.holes);
    return [fixedPiece({ kind: "body", index }, "body", [middle - half, middle + half], index, outline)];
  }

  /**
   * Half the width of a body that is drawn from its ports: never so wide that it is no bar, and wider than its pins.
   * @param {Body} body
   * @param {number} index
   */
  radiusOf(body, index) {
    const length = spread(pointsOfBody(body));
    const pins = this.mechanism.parts
      .filter((part) => part.frames.some((frame) => frame.body === index))
      .map((part) => 0.5 * (part.sizes["pin"] ?? 0));
    const slim = length > 0 ? Math.min(this.radius, 0.3 * length) : 1.4 * this.radius;
    return Math.max(slim, 1.4 * Math.max(0, ...pins));
  }

  /**
   * Where everything is at a time.
   * @param {number} time
   */
  at(time) {
    const moment = this.run.momentAt(time);
    this.run.posesAt(moment, this.places.poses);
    this.run.groundAt(moment, this.places.ground);
    return this.places;
  }

  /**
   * The box that holds everything over the whole run, sampled.
   * @returns {Box}
   */
  extents() {
    const { rows } = this.run;
    const samples = Math.min(rows, EXTENT_SAMPLES);
    /** @type {Box} */
    const box = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
    // Rails reach as far as their bodies have been seen to go: the first pass finds out.
    for (const isSecond of [false, true]) {
      for (let sample = 0; sample < samples; sample++) {
        const row = samples > 1 ? Math.round((sample * (rows - 1)) / (samples - 1)) : 0;
        const places = this.at(this.run.time.data[row]);
        for (const piece of this.pieces) {
          const outline = outlineAt(piece, places);
          if (isSecond && outline !== null) widen(box, outline, piece);
        }
      }
    }
    return box.low[0] <= box.high[0] ? box : { low: [-1, -1, 0], high: [1, 1, 0] };
  }
}

/** Half the width of a bar, as a share of the usual size of bodies. */
export const BAR = 0.055;
/** Rows that are looked at for the extents of a run. */
const EXTENT_SAMPLES = 100;

/** @param {Mechanism} mechanism @returns {Places} */
function placesFor(mechanism) {
  return {
    poses: new Float64Array(3 * mechanism.bodies.length),
    ground: new Float64Array(3 * mechanism.ground.length),
  };
}

/**
 * The points that an outline is made around: the ports, and G where they alone make no bar.
 * @param {Body} body
 */
export function pointsOfBody(body) {
  const points = body.ports.map(({ x, y }) => [x, y]);
  return spread(points) > 0 ? points : [...points, [0, 0]];
}

/** @param {number[][]} points */
function spread(points) {
  let largest = 0;
  for (const [x, y] of points) {
    for (const [u, v] of points) largest = Math.max(largest, Math.hypot(x - u, y - v));
  }
  return largest;
}

/** @param {Run} run */
function typicalSize(run) {
  const { bodies, ground } = run.mechanism;
  const points = (/** @type {Body} */ body) => body.contour ?? pointsOfBody(body);
  const sizes = bodies.map((body) => spread(points(body))).filter((size) => size > 0);
  sizes.sort((a, b) => a - b);
  if (sizes.length > 0) return sizes[sizes.length >> 1];
  // Points alone: what lies between them.
  const centres = bodies.map((_, body) => [run.poses.at(0, 6 * body), run.poses.at(0, 6 * body + 1)]);
  const between = run.rows > 0 ? spread([...centres, ...ground.map(({ x, y }) => [x, y])]) : 0;
  return between > 0 ? 0.5 * between : 1;
}

/**
 * @param {Box} box
 * @param {number[]} outline
 * @param {Piece} piece
 */
function widen(box, outline, piece) {
  for (let at = 0; at < outline.length; at++) {
    const axis = at % 2;
    if (Number.isNaN(outline[at])) continue;
    box.low[axis] = Math.min(box.low[axis], outline[at]);
    box.high[axis] = Math.max(box.high[axis], outline[at]);
  }
  box.low[2] = Math.min(box.low[2], piece.z0);
  box.high[2] = Math.max(box.high[2], piece.z1);
}
