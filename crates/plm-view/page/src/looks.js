// Shapes that the declaration of a part asks for.

import { depthOfFrame } from "./levels.js";
import { boxOutline, circleOutline, contourOutline, movedOutline } from "./outline.js";
import { framePose } from "./solid.js";

/** @import {Frame, Look} from "./format.js" */
/** @import {PartDraft} from "./pieces.js" */
/** @import {Piece, Places, Tone} from "./solid.js" */

/** Corners of a circle. */
const RIM_CORNERS = 60;

/**
 * The pieces of all shapes of a part.
 * @param {PartDraft} draft
 * @returns {Piece[]}
 */
export function shapePieces(draft) {
  return draft.part.shapes.map((shape) => shapePiece(draft, shape));
}

/**
 * @param {PartDraft} draft
 * @param {Look} shape
 * @returns {Piece}
 */
function shapePiece(draft, shape) {
  const { look, body } = shape;
  const { radius, thickness } = draft;
  const [back, own] = draft.scene.slabOf({ ...shape, argument: "" });
  const front = shape.symbol ? topAt(draft, { ...shape, argument: "" }) : own;
  const place = placedBy(draft, shape);
  const flat = shape.points.slice(hasOrigin(shape) ? 1 : 0).flat();
  const moving = (/** @type {Tone} */ tone, /** @type {[number, number]} */ at, /** @type {(places: Places) => number[]} */ make, isLine = false) =>
    ({ ...draft.moving(tone, at, make, { isLine }), body: body ?? -1 });
  /** @type {[number, number]} */
  const top = [front, front + 0.25 * thickness];
  if (look === "circle") {
    const rim = circleOutline(0, 0, Math.abs(flat[0]), RIM_CORNERS);
    return moving(draft.tone, top, place([0.8 * Math.abs(flat[0]), 0, ...rim, rim[0], rim[1]]), true);
  }
  if (look === "line") return moving(draft.tone, top, place(flat), true);
  if (look === "mark") return moving(draft.tone, top, place(contourOutline(pairs(flat))));
  // What a body is made of stands behind what is drawn of its ports.
  /** @type {[number, number]} */
  const below = [back - 0.25 * thickness, back];
  if (look !== "surface") return moving("body", below, place(contourOutline(pairs(flat))));
  if (flat.length > 0) return moving("mount", below, place(contourOutline(pairs(bandBelow(flat, 1.2 * radius)))));
  const reach = draft.reach({ ...shape, argument: "" }, draft.part.frames.map((_, at) => at));
  return moving("mount", below, (places) => {
    const { low, high } = reach(places);
    return place(boxOutline(low - 4 * radius, high + 4 * radius, -1.2 * radius, 0))(places);
  });
}

/**
 * Where the bodies end that have the depth of a frame: symbols stand in front of them.
 * @param {PartDraft} draft
 * @param {Frame} frame
 */
function topAt({ scene, thickness }, frame) {
  const { mechanism, levels } = scene;
  const depth = depthOfFrame(mechanism, frame);
  const middles = levels.bodies.filter((_, body) => mechanism.bodies[body].depth === depth);
  return Math.max(depth, ...middles) + 0.5 * thickness;
}

/** @param {Look} shape */
const hasOrigin = ({ look, symbol }) => symbol || look === "circle";

/** @param {number[]} flat */
const pairs = (flat) => Array.from({ length: flat.length / 2 }, (_, at) => [flat[2 * at], flat[2 * at + 1]]);

/**
 * Puts points into the plane: those of a symbol in half widths of a bar, along the line to another frame in shares of it.
 * @param {PartDraft} draft
 * @param {Look} shape
 */
function placedBy(draft, shape) {
  const { body, port, towards, symbol } = shape;
  const { mechanism } = draft.scene;
  const unit = symbol ? draft.radius : 1;
  return (/** @type {number[]} */ flat) => (/** @type {Places} */ places) => {
    let [x, y, angle] = framePose(mechanism, { argument: "", body, port }, places);
    let along = unit;
    if (towards !== null) {
      const [u, v] = framePose(mechanism, { argument: "", body: towards[0], port: towards[1] }, places);
      angle = Math.atan2(v - y, u - x);
      if (symbol) along = Math.hypot(u - x, v - y);
    }
    const [x0, y0] = (hasOrigin(shape) ? shape.points[0] : null) ?? [0, 0];
    const scaled = flat.map((value, at) => (at % 2 === 0 ? x0 + along * value : y0 + unit * value));
    return movedOutline(scaled, [x, y, angle]);
  };
}

/**
 * A band on the right of a line of points.
 * @param {number[]} line
 * @param {number} width
 */
function bandBelow(line, width) {
  const count = line.length / 2;
  const normal = (/** @type {number} */ at) => {
    const [dx, dy] = [line[2 * at + 2] - line[2 * at], line[2 * at + 3] - line[2 * at + 1]];
    const length = Math.hypot(dx, dy) || 1;
    return [dy / length, -dx / length];
  };
  const below = [];
  for (let at = count - 1; at >= 0; at--) {
    const [a, b] = [normal(Math.max(at - 1, 0)), normal(Math.min(at, count - 2))];
    const share = width / Math.max(1 + a[0] * b[0] + a[1] * b[1], 0.5);
    below.push(line[2 * at] + share * (a[0] + b[0]), line[2 * at + 1] + share * (a[1] + b[1]));
  }
  return [...line, ...below];
}
