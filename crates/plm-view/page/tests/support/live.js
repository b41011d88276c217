// The four-bar that `tests/live_module.rs` builds, and its native run.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { headOf } from "./scenes.js";

const folder = process.env["PLM_LIVE"];

/** Why tests of the live page are skipped; false if they run. */
export const withoutModule =
  folder !== undefined && existsSync(join(folder, "four_bar.json"))
    ? false
    : "skipped: there is no module; `cargo test -p plm-planar --test live_module` builds it, and PLM_LIVE names its folder, target/tmp/live";

/** The module of WebAssembly. */
export const modulePath = () => join(folder, "four_bar.wasm");

const about = () => JSON.parse(readFileSync(join(folder, "four_bar.json"), "utf8"));

/** What a results file says of it. */
export function fourBarHead() {
  const { mechanism, columns } = about();
  return headOf(mechanism, { name: "recorded", columns });
}

/** The numbers of the native run, a row for each interval: a parameter is turned after 150, a body pulled after 200. */
export function nativeRows() {
  const numbers = (line) => new Float64Array(BigUint64Array.from(line.split(" "), (word) => BigInt(`0x${word}`)).buffer);
  return about().native.map(numbers);
}

/** Rows as `plm_read` gives them, as a run for `makeNpz`. */
export function runOfRows(head, rows) {
  const [bodies, ground] = [6 * head.mechanism.bodies.length, 3 * head.mechanism.ground.length];
  return {
    head,
    time: rows.map((row) => row[0]),
    poses: rows.flatMap((row) => [...row.subarray(1, 1 + bodies)]),
    values: rows.flatMap((row) => [...row.subarray(1 + bodies + ground)]),
  };
}
