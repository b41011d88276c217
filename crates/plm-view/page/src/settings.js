// Parameters and inputs in the address: those alone that are not as declared, in their units. `p.reach=350` is a parameter, `i.torque=3`
// an input.

import { fromSi, toSi } from "./numbers.js";

/** @import {App} from "./app.js" */
/** @import {Live} from "./live.js" */

/** @typedef {{key: string, kind: "parameter" | "input", index: number, factor: number, usual: number}} Setting */

/**
 * What is asked for, SI; the usual value to the last bit where it is that.
 * @param {number} shown in the unit
 * @param {number} factor
 * @param {number} usual SI
 */
export function valueOf(shown, factor, usual) {
  return shown === fromSi(usual, factor) ? usual : toSi(shown, factor);
}

/** All that can be set of a mechanism in the page; what a program serves is set by that program. @param {Live} live @returns {Setting[]} */
function settingsOf(live) {
  const { parameters, inputs } = live.mechanism;
  return [
    ...parameters.map(({ name, factor, default: usual }, index) => ({ key: `p.${name}`, kind: /** @type {const} */ ("parameter"), index, factor, usual })),
    ...inputs.map(({ name, factor, default: usual }, index) => ({ key: `i.${name}`, kind: /** @type {const} */ ("input"), index, factor, usual: usual ?? 0 })),
  ].filter(({ key }) => !key.startsWith("i.plm_pull_"));
}

/** @param {App} app @returns {[string, string][]} */
export function changedSettings({ live }) {
  if (live === null || !live.isInPage) return [];
  return settingsOf(live).flatMap(({ key, kind, index, factor, usual }) => {
    const value = live.settings[kind][index] ?? usual;
    return value === usual || !Number.isFinite(value) ? [] : [[key, String(fromSi(value, factor))]];
  });
}

/** What an address does not name is as declared. @param {App} app @param {URLSearchParams} parts */
export function showSettings({ live }, parts) {
  if (live === null || !live.isInPage) return;
  for (const { key, kind, index, factor, usual } of settingsOf(live)) {
    const shown = parts.get(key);
    const value = shown === null || shown.trim() === "" ? usual : valueOf(Number(shown), factor, usual);
    if (Number.isFinite(value) && value !== (live.settings[kind][index] ?? usual)) live.set(kind, index, value);
  }
}
