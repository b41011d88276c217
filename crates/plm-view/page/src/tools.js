// Tools: what is measured and drawn over the picture besides, as values. An address has them, and the history goes back to them.

import { MOST_GHOSTS } from "./ghosts.js";
import { addMeasures, measureOf } from "./measure.js";

/** @import {App} from "./app.js" */

/**
 * `pair`: names of two bodies whose common centre is drawn. `measures`: names as `measureName` gives them. `force`: the joint of the polar
 * plot, empty for none; `around`: the body around whose angle it is drawn, empty for the vector.
 * @typedef {{ghosts: number, centres: boolean, centrodes: boolean, pair: string[], measures: string[], force: string,
 *   around: string}} Tools
 */

/** @returns {Tools} */
export function usualTools() {
  return { ghosts: 0, centres: false, centrodes: false, pair: [], measures: [], force: "", around: "" };
}

/** The parts of an address that tools have; what is usual is left out. @param {App} app @returns {[string, string][]} */
export function toolParts({ tools }) {
  /** @type {[string, string][]} */
  const all = [
    ["ghosts", tools.ghosts > 0 ? String(tools.ghosts) : ""],
    ["centres", tools.centres ? "1" : ""],
    ["centrodes", tools.centrodes ? "1" : ""],
    ["pair", tools.pair.join("|")],
    ["measures", tools.measures.join("|")],
    ["polar", tools.force],
    ["around", tools.around],
  ];
  return all.filter(([, value]) => value !== "");
}

/** @param {App} app @param {URLSearchParams} parts */
export function showTools(app, parts) {
  const mechanism = app.run?.mechanism;
  if (mechanism === undefined) return;
  const list = (/** @type {string} */ name) => (parts.get(name) ?? "").split("|").filter((part) => part !== "");
  const isBody = (/** @type {string} */ name) => mechanism.bodies.some((body) => body.name === name);
  const pair = list("pair").filter(isBody);
  app.tools = {
    ghosts: ghostCount(Number(parts.get("ghosts") ?? 0)),
    centres: parts.get("centres") === "1",
    centrodes: parts.get("centrodes") === "1",
    pair: pair.length === 2 ? pair : [],
    measures: list("measures").filter((name) => measureOf(mechanism, name) !== null),
    force: mechanism.parts.some(({ name }) => name === parts.get("polar")) ? (parts.get("polar") ?? "") : "",
    around: isBody(parts.get("around") ?? "") ? (parts.get("around") ?? "") : "",
  };
  for (const { run } of app.runViews) addMeasures(run, app.tools.measures);
}

/** @param {number} count */
export function ghostCount(count) {
  return Number.isFinite(count) ? Math.max(0, Math.min(MOST_GHOSTS, Math.round(count))) : 0;
}

/** Two bodies chosen one after the other are a pair. @param {App} app @param {number | null} before of the body that was selected */
export function choosePair({ tools, run, selected }, before) {
  if (run === null || !tools.centres || before === null || selected?.kind !== "body" || selected.index === before) return;
  tools.pair = [run.mechanism.bodies[before].name, run.mechanism.bodies[selected.index].name];
}
