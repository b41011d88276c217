// A results file becomes runs.

import { readContents } from "./format.js";
import { readNpy } from "./npy.js";
import { Run, Table } from "./run.js";
import { readZip } from "./zip.js";

/** @import {RunHead} from "./format.js" */
/** @import {ZipEntry} from "./zip.js" */

/** @typedef {{runs: Run[], madeBy: string, warnings: string[]}} Results */

/**
 * @param {Uint8Array} bytes
 * @returns {Promise<Results>}
 * @throws {Error} where nothing can be shown; what is missing of the rest is told by warnings
 */
export async function readResults(bytes) {
  const { entries, warnings } = await readZip(bytes);
  const byName = new Map(entries.map((entry) => [entry.name, entry]));
  const json = byName.get("plm.json");
  if (json === undefined || !json.whole) {
    const found = entries.slice(0, 5).map((entry) => entry.name);
    throw new Error(
      json === undefined
        ? `this archive is no results file: it holds no plm.json (it holds ${found.join(", ") || "nothing"})`
        : "the results file is damaged: its plm.json, which names the mechanism, is not whole",
    );
  }
  const contents = readContents(json.bytes);
  const runs = contents.runs.map((head, index) => runOf(head, index, byName, warnings));
  return { runs, madeBy: contents.made_by ?? "", warnings };
}

/**
 * @param {RunHead} head
 * @param {number} index
 * @param {Map<string, ZipEntry>} byName
 * @param {string[]} warnings
 */
function runOf(head, index, byName, warnings) {
  const { bodies, ground } = head.mechanism;
  /** @param {string} name @param {number} width */
  const table = (name, width) => tableOf(byName.get(`${index}/${name}.npy`), `${index}/${name}.npy`, width, warnings);
  const time = table("time", 1);
  const poses = table("poses", 6 * bodies.length);
  const values = table("values", head.columns.length);
  const hasGround = byName.has(`${index}/ground.npy`);
  const tables = { time, poses, values, ground: hasGround ? table("ground", 3 * ground.length) : null };
  const rows = wholeRows(tables.time.rows, [poses, values, tables.ground]);
  if (rows < time.rows) warnings.push(`Run "${head.name}": ${rows} of ${time.rows} rows are whole.`);
  time.rows = rows;
  return new Run(head, tables);
}

/**
 * How many rows all arrays have. One that is missing altogether is drawn as gaps: the others are still worth seeing.
 * @param {number} rows
 * @param {(Table | null)[]} tables
 */
function wholeRows(rows, tables) {
  const there = tables.filter((table) => table !== null && table.width > 0 && table.rows > 0);
  return Math.min(rows, ...there.map((table) => /** @type {Table} */ (table).rows));
}

/**
 * @param {ZipEntry | undefined} entry
 * @param {string} name
 * @param {number} width
 * @param {string[]} warnings
 */
function tableOf(entry, name, width, warnings) {
  if (entry === undefined) {
    if (width > 0) warnings.push(`${name} is missing.`);
    return new Table(width);
  }
  try {
    const { shape, data, whole } = readNpy(entry.bytes, name);
    const found = shape.slice(1).reduce((product, size) => product * size, 1);
    if (found !== width) throw new Error(`${name} has ${found} numbers a row; ${width} are expected`);
    if (!whole) warnings.push(`${name} is cut off after ${shape[0]} rows.`);
    return new Table(width, data, shape[0]);
  } catch (error) {
    warnings.push(`${error instanceof Error ? error.message : error}.`);
    return new Table(width);
  }
}
