// Measuring: distances and angles between points and bodies that are picked. They follow the motion, and are curves like any other.

import { scaleOf } from "./units.js";

/** @import {Mechanism} from "./format.js" */
/** @import {Quantity, Run} from "./run.js" */
/** @import {Places} from "./solid.js" */

/**
 * What is picked: a point in the axes of a body (null: of the ground), or the body as a whole. A port, or G, has its name.
 * @typedef {{body: number | null, point: [number, number] | null, name: string}} Mark
 * @typedef {"distance" | "angle"} MeasureKind
 * @typedef {{kind: MeasureKind, marks: Mark[]}} Measure two points; two bodies, or three points with the angle at the second
 */

/** All points that have a name, of bodies and of the ground. @param {Mechanism} mechanism @returns {Mark[]} */
export function namedMarks({ bodies, ground }) {
  return [
    ...bodies.flatMap((body, index) => [
      ...body.ports.map((port) => pointMark(index, port.x, port.y, `${body.name}.${port.name}`)),
      pointMark(index, 0, 0, `${body.name}.G`),
    ]),
    ...ground.map((port) => pointMark(null, port.x, port.y, `ground.${port.name}`)),
  ];
}

/** @param {number | null} body @param {number} x @param {number} y @param {string} name @returns {Mark} */
function pointMark(body, x, y, name) {
  return { body, point: [x, y], name };
}

/** A point of a body that has no name is called by its place. @param {Mechanism} mechanism @param {number} body @param {[number, number]} point @returns {Mark} */
export function freeMark(mechanism, body, point) {
  const [x, y] = point.map((value) => Number(value.toPrecision(4)));
  return { body, point: [x, y], name: `${mechanism.bodies[body].name}(${x};${y})` };
}

/** @param {Mechanism} mechanism @param {number} body @returns {Mark} */
export function bodyMark(mechanism, body) {
  return { body, point: null, name: mechanism.bodies[body].name };
}

/**
 * The mark of a name as it stands in an address; null where there is none such.
 * @param {Mechanism} mechanism
 * @param {string} name
 * @returns {Mark | null}
 */
export function markOf(mechanism, name) {
  const named = namedMarks(mechanism).find((mark) => mark.name === name);
  if (named !== undefined) return named;
  const [, of, x, y] = /^([^(]+)(?:\(([^;]+);([^)]+)\))?$/.exec(name) ?? [];
  const body = mechanism.bodies.findIndex((candidate) => candidate.name === of);
  if (body < 0) return null;
  if (x === undefined) return bodyMark(mechanism, body);
  const point = [Number(x), Number(y)];
  return point.every(Number.isFinite) ? freeMark(mechanism, body, [point[0], point[1]]) : null;
}

/** How many marks make a measure: as soon as they do, it is one. @param {MeasureKind} kind @param {Mark[]} marks */
export function isWhole(kind, marks) {
  const isPoints = marks[0]?.point !== null;
  return marks.length === (kind === "angle" && isPoints ? 3 : 2);
}

/** Marks with one more; one of the other sort begins anew. @param {MeasureKind} kind @param {Mark[]} marks @param {Mark} mark @returns {Mark[]} */
export function withMark(kind, marks, mark) {
  const isSame = marks.every((other) => (other.point === null) === (mark.point === null) && other.name !== mark.name);
  return isSame && !isWhole(kind, marks) ? [...marks, mark] : [mark];
}

/** @param {Measure} measure */
export function measureName({ kind, marks }) {
  return `${kind}(${marks.map(({ name }) => name).join(",")})`;
}

/**
 * The measure of such a name; null where it is none.
 * @param {Mechanism} mechanism
 * @param {string} name
 * @returns {Measure | null}
 */
export function measureOf(mechanism, name) {
  const [, kind, list] = /^(distance|angle)\((.*)\)$/.exec(name) ?? [];
  if (list === undefined) return null;
  const marks = list.split(",").map((each) => markOf(mechanism, each));
  const found = /** @type {Mark[]} */ (marks.filter((mark) => mark !== null));
  const measure = { kind: /** @type {MeasureKind} */ (kind), marks: found };
  const isPointless = kind === "distance" && found.some(({ point }) => point === null);
  return found.length === marks.length && isWhole(measure.kind, found) && !isPointless ? measure : null;
}

/**
 * Where a point is in absolute axes; of a body as a whole its centre of gravity.
 * @param {Mark} mark
 * @param {Places} places
 * @param {Mechanism} mechanism
 * @returns {[number, number]}
 */
export function placeOfMark({ body, point, name }, { poses, ground }, mechanism) {
  const [u, v] = point ?? [0, 0];
  if (body === null) {
    // Ports of the ground may move.
    const port = mechanism.ground.findIndex((candidate) => `ground.${candidate.name}` === name);
    return port < 0 ? [u, v] : [ground[3 * port], ground[3 * port + 1]];
  }
  const [x, y, angle] = poses.subarray(3 * body, 3 * body + 3);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [x + cos * u - sin * v, y + sin * u + cos * v];
}

/**
 * What is measured, in m or rad; an angle from the first to the last, between -π and π, of bodies that of the second against the first.
 * @param {Measure} measure
 * @param {Places} places
 * @param {Mechanism} mechanism
 */
export function measured({ kind, marks }, places, mechanism) {
  if (kind === "angle" && marks[0].point === null) {
    const [a, b] = marks.map(({ body }) => places.poses[3 * (body ?? 0) + 2]);
    return halfTurns(b - a);
  }
  const at = marks.map((mark) => placeOfMark(mark, places, mechanism));
  if (kind === "distance") return Math.hypot(at[1][0] - at[0][0], at[1][1] - at[0][1]);
  const [from, to] = [at[0], at[2]].map(([x, y]) => Math.atan2(y - at[1][1], x - at[1][0]));
  return halfTurns(to - from);
}

/** An angle without whole turns. @param {number} angle */
function halfTurns(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/** The declared unit of what is measured. @param {Run} run @param {MeasureKind} kind */
export function unitOf(run, kind) {
  return scaleOf(run, "", kind === "angle" ? "rad" : "m");
}

/**
 * A measure as a quantity of a run, in the declared unit.
 * @param {Run} run
 * @param {Measure} measure
 * @returns {Quantity}
 */
export function measureQuantity(run, measure) {
  const { unit, factor } = unitOf(run, measure.kind);
  const { bodies, ground } = run.mechanism;
  const places = { poses: new Float64Array(3 * bodies.length), ground: new Float64Array(3 * ground.length) };
  const moving = [...new Set(measure.marks.flatMap(({ body }) => (body === null ? [] : [body])))];
  const read = (/** @type {number} */ row) => {
    for (const body of moving) {
      for (let axis = 0; axis < 3; axis++) places.poses[3 * body + axis] = run.poses.at(row, 6 * body + axis);
    }
    run.groundAt({ row, share: 0 }, places.ground);
    return measured(measure, places, run.mechanism) / factor;
  };
  return { name: measureName(measure), unit, read };
}

/** A run has the measures as quantities. @param {Run} run @param {string[]} names */
export function addMeasures(run, names) {
  if (run.measures.map(({ name }) => name).join() === names.join()) return;
  run.measures = names.flatMap((name) => {
    const measure = measureOf(run.mechanism, name);
    return measure === null ? [] : [measureQuantity(run, measure)];
  });
}
