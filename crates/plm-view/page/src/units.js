// The units in which a mechanism was declared: what has none of its own is shown in those of its parameters and outputs.

/** @import {Run} from "./run.js" */

/** @typedef {{unit: string, factor: number}} Scale a value in SI is one in the unit times the factor */

/** @type {{[unit: string]: number}} */
const LENGTHS = { mm: 1e-3, cm: 1e-2, dm: 0.1, km: 1e3, in: 0.0254, ft: 0.3048 };
/** @type {{[unit: string]: number}} */
const ANGLES = { deg: Math.PI / 180, rad: 1 };

/** What was found of a run. @type {WeakMap<object, {length: Scale, angle: Scale}>} */
const knownUnits = new WeakMap();

/**
 * The unit of a quantity: that of the column of its name, else the declared one of its kind.
 * @param {Pick<Run, "mechanism" | "columns">} run
 * @param {string} name
 * @param {string} si m, m/s, rad, rad/s; others stay
 * @returns {Scale}
 */
export function scaleOf(run, name, si) {
  const column = run.columns.find((candidate) => candidate.name === name);
  if (column !== undefined) return { unit: column.unit, factor: column.factor ?? LENGTHS[column.unit] ?? ANGLES[column.unit] ?? 1 };
  const { length, angle } = unitsOf(run);
  const [kind, ...rest] = si.split("/");
  const scale = { m: length, rad: angle }[kind];
  // A moment of inertia or a stiffness has further units in it.
  return scale === undefined || (rest.length > 0 && rest[0] !== "s") ? { unit: si, factor: 1 } : { unit: [scale.unit, ...rest].join("/"), factor: scale.factor };
}

/** @param {Pick<Run, "mechanism" | "columns">} run */
function unitsOf(run) {
  const { mechanism, columns } = run;
  const known = knownUnits.get(columns);
  if (known !== undefined) return known;
  const units = [...mechanism.parameters, ...mechanism.inputs, ...columns].map(({ unit }) => unit);
  const found = {
    length: scaleAmong(units, LENGTHS) ?? { unit: "m", factor: 1 },
    angle: scaleAmong(units, ANGLES) ?? { unit: "deg", factor: ANGLES["deg"] },
  };
  knownUnits.set(columns, found);
  return found;
}

/** The first of the units that a table has. @param {string[]} units @param {{[unit: string]: number}} table @returns {Scale | null} */
function scaleAmong(units, table) {
  const unit = units.find((candidate) => Object.hasOwn(table, candidate));
  return unit === undefined ? null : { unit, factor: table[unit] };
}
