// Why a run stands still, in words.

import { timeText, withShortNumbers } from "./text.js";

/** @import {App} from "./app.js" */

/** Why the run that is shown stands still; empty where it does not. @param {App} app */
export function faultWords({ run, live }) {
  const fault = run?.fault ?? null;
  if (fault === null) return "";
  const isLive = run === live?.run;
  if (isLive && live?.opened) return live.opened;
  const what = run?.isLive ? "Stopped" : "The run ended";
  const where = fault.part === "" ? "" : `${fault.part}: `;
  const when = isLive && live?.isAssembled === false ? "It does not start" : `${what} at ${timeText(fault.time, fault.time)}`;
  return `${when}: ${where}${withShortNumbers(fault.text)}`;
}

/** What is missing at a start that cannot be assembled. @param {import("./worker.js").Trouble | null} trouble */
export function missingWords(trouble) {
  if (trouble === null) return "it cannot be assembled";
  return Number.isFinite(trouble.gap) ? `${lengthText(trouble.gap)} missing: ${trouble.part}` : trouble.text.split("\n")[0];
}

/** A length in the unit in which people say it. @param {number} length m */
export function lengthText(length) {
  const [size, unit] = length < 1 ? [1000 * length, "mm"] : [length, "m"];
  return `${Number(size.toPrecision(3))} ${unit}`;
}
