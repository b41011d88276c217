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
