// What plm.json in a results file says.

/**
 * @typedef {{name: string, x: number, y: number, angle: number}} Port place from G, in the axes of the body
 * @typedef {{name: string, mass: number, inertia: number, depth: number, ports: Port[], contour: number[][] | null,
 *   holes: number[][][]}} Body
 * @typedef {Port & {depth: number, moves?: boolean}} GroundPort place in absolute axes, at time 0
 * @typedef {{argument: string, body: number | null, port: number | null}} Frame body null: ground; port null: G, or the
 *   origin of the ground
 * @typedef {{look: string, body: number | null, port: number | null, towards: (number | null)[] | null, symbol: boolean,
 *   points: number[][]}} Look what is drawn of a part, in the axes of a frame; the first point of a symbol and of a circle is where its origin is
 * @typedef {{name: string, kind: string, pair: string | null, frames: Frame[], sizes: {[name: string]: number},
 *   shapes: Look[]}} Part
 * @typedef {{name: string, unit: string, factor: number, exponents: number[], default: number, value: number}} Parameter
 * @typedef {{name: string, unit: string, factor: number, exponents?: number[], default?: number | null}} Input
 * @typedef {{formulation: string, reason: string, degrees_of_freedom: number, operations: {[name: string]: number}}} Report
 * @typedef {{name: string, doc: string, report: Report | null, bodies: Body[], ground: GroundPort[], parts: Part[],
 *   parameters: Parameter[], inputs: Input[],
 *   states: {name: string, unit: string}[]}} Mechanism
 * @typedef {"motion" | "reading" | "residual"} Role curves are drawn of motions, marks of readings and residuals
 * @typedef {{name: string, unit: string, factor?: number | null, role?: Role}} Column a value in SI is one in the unit times the
 *   factor, 1 if nothing is said
 * @typedef {{time: number, what: string, row: number | null}} RunEvent
 * @typedef {{time: number, part: string, text: string}} RunFault
 * @typedef {{name: string, mechanism: Mechanism, method: string, columns: Column[], events: RunEvent[],
 *   fault: RunFault | null, notices?: string[]}} RunHead all of a run but its arrays
 * @typedef {{format: string, version: number, made_by: string, runs: RunHead[]}} Contents
 */

/** The version that this page reads. */
const FORMAT_VERSION = 1;

/**
 * A shape that a value must have: the name of a type, a list of one shape, or shapes by name; `?` allows null or nothing.
 * @typedef {string | ShapeList | ShapeTable} Shape
 */

/** @typedef {{[name: string]: Shape}} ShapeTable */
/** @typedef {Shape[]} ShapeList */

/** @type {Shape} */
const PORT_SHAPE = { name: "string", x: "number", y: "number", angle: "number" };

/** @type {Shape} */
const RUN_SHAPE = {
  name: "string",
  mechanism: {
    name: "string",
    bodies: [{ name: "string", mass: "number|null", inertia: "number|null", depth: "number", ports: [PORT_SHAPE] }],
    ground: [PORT_SHAPE],
    parts: [{ name: "string", kind: "string", frames: [{ argument: "string", body: "number?", port: "number?" }] }],
    "parameters?": [{ name: "string", unit: "string", factor: "number", value: "number" }],
  },
  columns: [{ name: "string", unit: "string", "role?": "string" }],
  "events?": [{ time: "number", what: "string" }],
};

/**
 * The contents of a results file, with what may be left out filled in.
 * @param {Uint8Array} bytes of plm.json
 * @returns {Contents}
 * @throws {Error} that says what is missing
 */
export function readContents(bytes) {
  let json;
  try {
    json = JSON.parse(new TextDecoder().decode(bytes));
  } catch (error) {
    throw new Error(`plm.json cannot be read: ${error instanceof Error ? error.message : error}`);
  }
  if (json?.format !== "plm results") throw new Error('plm.json does not say "format": "plm results"');
  if (json.version > FORMAT_VERSION) {
    throw new Error(
      `the results are of version ${json.version}, and this page reads version ${FORMAT_VERSION}: ` +
        "write the page anew with the program that wrote the results",
    );
  }
  checkShape(json.runs, [RUN_SHAPE], "runs");
  for (const run of json.runs) fillRun(run);
  return json;
}

/** @param {any} run */
function fillRun(run) {
  run.events ??= [];
  run.fault ??= null;
  run.notices ??= [];
  run.method ??= "";
  const { mechanism } = run;
  mechanism.doc ??= "";
  mechanism.report ??= null;
  mechanism.parameters ??= [];
  mechanism.inputs ??= [];
  mechanism.states ??= [];
  for (const body of mechanism.bodies) {
    body.contour ??= null;
    body.holes ??= [];
    // JSON has no NaN: a body without mass.
    body.mass ??= NaN;
    body.inertia ??= NaN;
  }
  for (const port of mechanism.ground) port.depth ??= 0;
  for (const part of mechanism.parts) {
    part.pair ??= null;
    part.sizes ??= {};
    part.shapes ??= [];
    for (const shape of part.shapes) {
      shape.towards ??= null;
      shape.symbol ??= false;
    }
    for (const frame of [...part.frames, ...part.shapes]) checkFrame(frame, mechanism, part.name);
  }
}

/**
 * @param {{body: number | null, port: number | null}} frame
 * @param {Mechanism} mechanism
 * @param {string} part
 */
function checkFrame(frame, mechanism, part) {
  frame.body ??= null;
  frame.port ??= null;
  const body = frame.body === null ? null : mechanism.bodies[frame.body];
  const ports = body === null ? mechanism.ground : body?.ports;
  if (ports === undefined) throw new Error(`plm.json: part "${part}" joins body ${frame.body}, which there is not`);
  if (frame.port !== null && ports[frame.port] === undefined) {
    throw new Error(`plm.json: part "${part}" joins port ${frame.port} of "${body?.name ?? "ground"}", which there is not`);
  }
}

/**
 * @param {any} value
 * @param {Shape} shape
 * @param {string} place
 */
function checkShape(value, shape, place) {
  if (typeof shape === "string") {
    const type = shape.replace("?", "").replace("|null", "");
    const mayMiss = shape.endsWith("?") && (value === null || value === undefined);
    if (shape.endsWith("|null") && value === null) return;
    if (!mayMiss && typeof value !== type) throw shapeError(place, type, value);
  } else if (Array.isArray(shape)) {
    if (!Array.isArray(value)) throw shapeError(place, "list", value);
    value.forEach((element, index) => checkShape(element, shape[0], `${place}[${index}]`));
  } else {
    if (typeof value !== "object" || value === null) throw shapeError(place, "object", value);
    for (const [key, inner] of Object.entries(shape)) {
      const name = key.replace("?", "");
      if (name === key || value[name] !== undefined) checkShape(value[name], inner, `${place}.${name}`);
    }
  }
}

/**
 * @param {string} place
 * @param {string} expected
 * @param {any} found
 */
function shapeError(place, expected, found) {
  const what = found === undefined ? "is missing" : `is ${JSON.stringify(found)}`;
  return new Error(`plm.json: ${place} ${what}; a ${expected} is expected`);
}
