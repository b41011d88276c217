// What parameters change of a mechanism: a live module tells it as numbers.

/** @import {Mechanism} from "./format.js" */

/** What was read last, for each mechanism. @type {WeakMap<Mechanism, string>} */
const knownShapes = new WeakMap();

/**
 * Puts the numbers of `plm_shape` (crates/plm-view/src/live/shim.rs) into a mechanism; whether anything changed.
 * @param {Mechanism} mechanism
 * @param {Float64Array} numbers
 * @param {string} sizeNames as `plm_size_names` gives them
 */
export function readShape(mechanism, numbers, sizeNames) {
  const text = numbers.join();
  if (knownShapes.get(mechanism) === text) return false;
  knownShapes.set(mechanism, text);
  let at = 0;
  const next = () => numbers[at++];
  const points = () => {
    const list = Array.from({ length: next() }, () => [next(), next()]);
    return list.flat().every(Number.isFinite) ? list : [];
  };
  const place = (/** @type {import("./format.js").Port} */ port) => ([port.x, port.y, port.angle] = [next(), next(), next()]);
  for (const body of mechanism.bodies) {
    [body.mass, body.inertia, body.depth] = [next(), next(), next()];
    body.ports.forEach(place);
    const contour = points();
    body.contour = contour.length > 0 ? contour : null;
  }
  for (const port of mechanism.ground) {
    place(port);
    port.depth = next();
  }
  for (const line of sizeNames === "" ? [] : sizeNames.split("\n")) {
    const [name, ...sizes] = line.split(" ");
    const part = mechanism.parts.find((candidate) => candidate.name === name);
    const read = sizes.map((size) => [size.replace(/_diameter$/, ""), next()]);
    // As in a results file: what was not given is left out.
    if (part !== undefined) part.sizes = Object.fromEntries(read.filter(([, size]) => Number.isFinite(size) && size !== 0));
  }
  for (const part of mechanism.parts) part.shapes.forEach((shape) => (shape.points = points()));
  for (const body of mechanism.bodies) body.holes = body.holes.map(points);
  return true;
}
