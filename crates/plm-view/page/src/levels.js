// Where bodies, jacks and springs stand along z: the declared depth, and beside one another where that is the same.

/** @import {Mechanism, Part} from "./format.js" */

/**
 * Whether a part is drawn as a body between two points, though it has none in the equations: a part of the user's own with a
 * piston or a rod is a jack.
 * @param {Part} part
 * @returns {"jack" | "spring" | null}
 */
export function linkKind({ kind, pair, frames, sizes }) {
  if (frames.length < 2 || pair !== null) return null;
  if (kind === "jack" || kind === "gas_spring" || "piston" in sizes || "rod" in sizes) return "jack";
  return kind === "spring" ? "spring" : null;
}

/**
 * @typedef {{bodies: number[], links: Map<number, number>, thickness: number}} Levels middle of each body along z; that of
 *   each jack and spring by the number of its part
 */

/**
 * Bodies that a joint connects and that have the same depth are laid side by side, as bars of a linkage are: each takes the
 * lowest layer that none of its neighbours has. The ground has layer 0 at the depths of its ports.
 * @param {Mechanism} mechanism
 * @param {number} wanted thickness
 * @returns {Levels}
 */
export function levelsOf(mechanism, wanted) {
  const { bodies, parts } = mechanism;
  const links = parts.map((part, index) => ({ part, index })).filter(({ part }) => linkKind(part) !== null);
  const depths = [
    ...bodies.map((body) => body.depth),
    ...links.map(({ part }) => depthOfFrame(mechanism, part.frames[0])),
  ];
  const neighbours = neighboursOf(mechanism, links.map(({ index }) => index));
  /** @type {number[]} */
  const layers = [];
  depths.forEach((depth, node) => {
    const taken = neighbours[node].map((other) => {
      if (typeof other === "object") return other.depth === depth ? 0 : -1;
      return other < node && depths[other] === depth ? layers[other] : -1;
    });
    let layer = 0;
    while (taken.includes(layer)) layer++;
    layers.push(layer);
  });
  const thickness = thicknessOf([...depths, ...mechanism.ground.map((port) => port.depth)], layers, wanted);
  const middles = depths.map((depth, node) => depth + layers[node] * LAYER_PITCH * thickness);
  return {
    bodies: middles.slice(0, bodies.length),
    links: new Map(links.map(({ index }, at) => [index, middles[bodies.length + at]])),
    thickness,
  };
}

/** From layer to layer, in thicknesses. */
const LAYER_PITCH = 1.3;

/**
 * Thin enough that all layers of one depth end before the next depth: then sorting by depth is exact.
 * @param {number[]} depths
 * @param {number[]} layers
 * @param {number} wanted
 */
function thicknessOf(depths, layers, wanted) {
  const rising = [...new Set(depths)].sort((a, b) => a - b);
  const gaps = rising.slice(1).map((depth, at) => depth - rising[at]);
  const most = Math.max(0, ...layers) + 1;
  return Math.min(wanted, ...gaps.map((gap) => (0.9 * gap) / (LAYER_PITCH * most)));
}

/**
 * Who may not be in one layer with whom: numbers of bodies, then of links; or a place on the ground.
 * @param {Mechanism} mechanism
 * @param {number[]} links
 */
function neighboursOf({ bodies, parts, ground }, links) {
  /** @type {(number | {depth: number})[][]} */
  const neighbours = Array.from({ length: bodies.length + links.length }, () => []);
  parts.forEach((part, index) => {
    const isLink = linkKind(part) !== null;
    if ((part.pair === null && !isLink) || part.pair === "weld") return;
    const ends = part.frames.map((frame) =>
      frame.body ?? { depth: frame.port === null ? 0 : ground[frame.port].depth },
    );
    const nodes = isLink ? [...ends, bodies.length + links.indexOf(index)] : ends;
    for (const node of nodes) {
      if (typeof node === "number") neighbours[node].push(...nodes.filter((other) => other !== node));
    }
  });
  return neighbours;
}

/**
 * @param {Mechanism} mechanism
 * @param {import("./format.js").Frame} frame
 */
export function depthOfFrame(mechanism, frame) {
  if (frame.body !== null) return mechanism.bodies[frame.body].depth;
  return frame.port === null ? 0 : mechanism.ground[frame.port].depth;
}
