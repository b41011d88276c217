// Writes runs: as a results file, as CSV.

import { checkSum } from "./zip.js";

/** @import {Run, Table} from "./run.js" */

/** @typedef {Uint8Array<ArrayBuffer>} Bytes */

/** 1 January 1980, in the form of zip: the same runs give the same bytes. */
const NO_DATE = 0x21;
/** Version 2.0 of zip, which has deflate and folders. */
const ZIP_VERSION = 20;

/**
 * @param {Run[]} runs
 * @param {string} madeBy
 * @returns {Promise<Bytes>} a results file (.npz)
 */
export function resultsFile(runs, madeBy) {
  const heads = runs.map(({ name, head, mechanism, columns, events, fault }) => ({ ...head, name, mechanism, columns, events, fault }));
  const contents = { format: "plm results", version: 1, made_by: madeBy, runs: heads };
  /** @type {[string, Bytes][]} */
  const files = [["plm.json", new TextEncoder().encode(JSON.stringify(contents))]];
  runs.forEach(({ mechanism, time, poses, values, ground }, index) => {
    const { rows } = time;
    const put = (/** @type {string} */ name, /** @type {number[]} */ shape, /** @type {Table} */ table) =>
      files.push([`${index}/${name}.npy`, npyFile([rows, ...shape], table.data.subarray(0, rows * table.width))]);
    put("time", [], time);
    put("poses", [mechanism.bodies.length, 6], poses);
    put("values", [values.width], values);
    // Ports that stand still are in plm.json.
    if (ground !== null && mechanism.ground.some((port) => port.moves ?? true)) put("ground", [mechanism.ground.length, 3], ground);
  });
  return zipFile(files);
}

/**
 * @param {number[]} shape
 * @param {Float64Array | Float32Array} numbers
 * @returns {Bytes} an array of NumPy
 */
function npyFile(shape, numbers) {
  const sizes = shape.length === 1 ? `${shape[0]},` : shape.join(", ");
  const text = `{'descr': '<f8', 'fortran_order': False, 'shape': (${sizes}), }`;
  // The numbers begin at a multiple of 64 bytes.
  const header = `${text.padEnd(64 * Math.ceil((text.length + 11) / 64) - 11)}\n`;
  const bytes = new Uint8Array(10 + header.length + 8 * numbers.length);
  bytes.set([0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59, 1, 0, header.length & 255, header.length >> 8]);
  bytes.set(new TextEncoder().encode(header), 10);
  bytes.set(new Uint8Array(Float64Array.from(numbers).buffer), 10 + header.length);
  return bytes;
}

/**
 * @param {[string, Bytes][]} files
 * @returns {Promise<Bytes>} a zip archive
 */
export async function zipFile(files) {
  /** @type {Bytes[]} */
  const parts = [];
  /** @type {Bytes[]} */
  const directory = [];
  let at = 0;
  for (const [name, bytes] of files) {
    const title = new TextEncoder().encode(name);
    const data = await deflated(bytes);
    // Flags (names are UTF-8), method, time, date, sum, sizes, lengths of name and extra field.
    const about = little([2, 0x800], [2, 8], [2, 0], [2, NO_DATE], [4, checkSum(bytes)], [4, data.length], [4, bytes.length], [2, title.length], [2, 0]);
    const local = joined([little([4, 0x04034b50], [2, ZIP_VERSION]), about, title, data]);
    const place = little([2, 0], [2, 0], [2, 0], [4, 0], [4, at]);
    directory.push(little([4, 0x02014b50], [2, ZIP_VERSION], [2, ZIP_VERSION]), about, place, title);
    parts.push(local);
    at += local.length;
  }
  const contents = joined(directory);
  const end = little([4, 0x06054b50], [2, 0], [2, 0], [2, files.length], [2, files.length], [4, contents.length], [4, at], [2, 0]);
  return joined([...parts, contents, end]);
}

/** @param {Bytes} bytes */
export async function deflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Numbers of so many bytes, the lowest first. @param {...[number, number]} numbers size and value */
function little(...numbers) {
  const bytes = numbers.flatMap(([size, value]) => Array.from({ length: size }, (_, at) => (value >>> (8 * at)) & 255));
  return new Uint8Array(bytes);
}

/** @param {Bytes[]} parts */
function joined(parts) {
  const bytes = new Uint8Array(parts.reduce((length, part) => length + part.length, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

/**
 * The columns of a run, as Rust writes them: `time (s),arm.angle (deg)`.
 * @param {Run} run
 */
export function csvText(run) {
  const heading = ["time (s)", ...run.columns.map(({ name, unit }) => (unit === "" ? name : `${name} (${unit})`))];
  const lines = [heading.map(csvField).join(",")];
  for (let row = 0; row < run.rows; row++) {
    const values = run.columns.map((_, column) => run.values.at(row, column));
    lines.push([run.time.data[row], ...values].map(csvNumber).join(","));
  }
  return `${lines.join("\n")}\n`;
}

/** @param {string} text */
function csvField(text) {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** The shortest text that reads back to the same bits. @param {number} value */
function csvNumber(value) {
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  return Object.is(value, -0) ? "-0.0" : String(value);
}
