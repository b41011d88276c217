// What is shown, in the address: a link shows the same.

import { LAYOUTS } from "./commands.js";
import { SPEEDS } from "./player.js";
import { usualCurves } from "./runview.js";
import { changedSettings, showSettings } from "./settings.js";
import { showTools, toolParts } from "./tools.js";

/** @import {App, Layout, Mode} from "./app.js" */

const MODES = ["pan", "orbit", "zoom", "window", "info", "distance", "angle"];
/** Of a page with the mechanism itself, too. */
const LIVE_MODES = [...MODES, "pull", "place"];

/**
 * What is shown, as the part of an address after `#`. What is usual is left out.
 * @param {App} app
 */
export function addressOf(app) {
  const { view, player } = app;
  const parts = new URLSearchParams();
  const put = (/** @type {string} */ name, /** @type {string | number} */ value, /** @type {string | number} */ usual) => {
    if (value !== usual) parts.set(name, String(value));
  };
  // A link to what plays begins to play; one to a moment has its time, be it the first.
  if (!player.isFollowing && !player.isPlaying) parts.set("t", String(rounded(player.time)));
  const isFront = view.azimuth === 0 && view.elevation === 0;
  if (!app.isFitted || !isFront) parts.set("view", [view.azimuth, view.elevation, view.scale, ...view.target].map(rounded).join(","));
  put("mode", app.mode, app.live?.usualMode ?? "pan");
  put("wire", Number(app.isWire), 0);
  put("run", app.run?.name ?? "", app.runViews[0]?.run.name ?? "");
  put("layout", app.layout, "one");
  put("hidden", app.runViews.filter((shown) => !shown.isShown).map(({ run }) => run.name).join("|"), "");
  put("select", app.selected === null ? "" : `${app.selected.kind}:${app.selected.index}`, "");
  put("curves", app.curves.join("|"), usualCurves(app.run).join("|"));
  put("against", app.across ?? "", "");
  put("log", app.logUnits.map((unit) => unit || "1").join("|"), "");
  put("paths", app.traces.join("|"), app.usualTraces.join("|"));
  put("forces", Number(app.showsForces), 0);
  put("velocities", Number(app.showsVelocities), 0);
  put("arrows", rounded(app.arrowFactor), 1);
  put("speed", player.speed, 1);
  put("loop", Number(player.isLooping), 0);
  put("step", player.chosenStep ?? "", "");
  put("rate", app.refreshRate, 60);
  put("back", app.background ?? "", "");
  put("theme", app.theme, "auto");
  put("tab", app.tab, app.live === null ? "curves" : "live");
  put("panel", Number(app.hasPanel), 1);
  for (const [name, value] of [...toolParts(app), ...changedSettings(app)]) parts.set(name, value);
  put("text", app.packedText, "");
  return parts.toString();
}

/**
 * Shows what an address says; what it does not know is left as it is.
 * @param {App} app
 * @param {string} hash with or without `#`
 */
export function showAddress(app, hash) {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const { player } = app;
  const run = app.runViews.findIndex((shown) => shown.run.name === parts.get("run"));
  if (run >= 0) app.activate(run);
  const layout = parts.get("layout");
  if (layout !== null && layout in LAYOUTS) app.layout = /** @type {Layout} */ (layout);
  const hidden = names(parts.get("hidden"));
  for (const shown of app.runViews) shown.isShown = !hidden.includes(shown.run.name);
  app.updateBounds();
  showSwitches(app, parts);
  showTools(app, parts);
  app.isViewGiven = parts.has("view");
  if (app.isViewGiven) showView(app, numbers(parts.get("view")));
  else if (layout !== null) app.zoomToExtents();
  if (parts.has("curves")) app.curves = known(app, names(parts.get("curves")));
  app.across = known(app, names(parts.get("against")))[0] ?? null;
  app.logUnits = names(parts.get("log")).map((unit) => (unit === "1" ? "" : unit));
  app.isPathGiven = parts.has("paths");
  if (app.isPathGiven) app.traces = names(parts.get("paths"));
  const [kind, index] = (parts.get("select") ?? "").split(":");
  app.selected = app.items().find((item) => item.kind === kind && item.index === Number(index)) ?? null;
  showSettings(app, parts);
  if (parts.has("t")) player.seek(Number(parts.get("t")) || 0);
  if (parts.get("play") === "1") player.play();
  app.change();
}

/** @param {App} app @param {URLSearchParams} parts */
function showSwitches(app, parts) {
  const { player } = app;
  const chosen = (/** @type {string} */ name, /** @type {string[]} */ list, /** @type {string} */ usual) => {
    const value = parts.get(name) ?? "";
    return list.includes(value) ? value : usual;
  };
  app.mode = /** @type {Mode} */ (chosen("mode", app.live === null ? MODES : LIVE_MODES, app.mode));
  // A live source may have added tabs: the panel knows which there are.
  app.tab = parts.get("tab") ?? app.tab;
  app.theme = /** @type {App["theme"]} */ (chosen("theme", ["auto", "light", "dark"], app.theme));
  app.isWire = parts.get("wire") === "1";
  app.showsForces = parts.get("forces") === "1";
  app.showsVelocities = parts.get("velocities") === "1";
  app.hasPanel = parts.get("panel") !== "0";
  app.arrowFactor = positive(parts.get("arrows")) ?? 1;
  app.refreshRate = positive(parts.get("rate")) ?? 60;
  app.background = /^#[0-9a-f]{6}$/i.test(parts.get("back") ?? "") ? parts.get("back") : null;
  player.speed = Math.min(positive(parts.get("speed")) ?? 1, SPEEDS[SPEEDS.length - 1]);
  player.isLooping = parts.get("loop") === "1";
  player.chosenStep = positive(parts.get("step"));
}

/** @param {App} app @param {number[]} numbers */
function showView(app, [azimuth, elevation, scale, ...target]) {
  if (target.length !== 3 || ![azimuth, elevation, scale, ...target].every(Number.isFinite) || scale <= 0) return;
  Object.assign(app.view, { azimuth, elevation, scale, target });
}

/** @param {App} app @param {string[]} curves */
function known(app, curves) {
  const all = new Set(app.run?.quantities().map(({ name }) => name));
  return curves.filter((name) => all.has(name));
}

/** @param {string | null} text */
function names(text) {
  return text === null || text === "" ? [] : text.split("|");
}

/** @param {string | null} text */
function numbers(text) {
  return text === null ? [] : text.split(",").map(Number);
}

/** @param {string | null} text @returns {number | null} */
function positive(text) {
  const value = Number(text);
  return text !== null && Number.isFinite(value) && value > 0 ? value : null;
}

/** @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(7));
}

/** So often, ms, the address follows at most: browsers refuse more. */
const ADDRESS_EVERY = 300;

/**
 * Keeps the address up to date; while the run plays without its time.
 * @param {App} app
 * @returns {() => void} to be called after every frame
 */
export function addressKeeper(app) {
  let isWaiting = false;
  let written = "";
  return () => {
    if (isWaiting || app.run === null) return;
    isWaiting = true;
    setTimeout(() => {
      isWaiting = false;
      const address = addressOf(app);
      if (address === written || app.run === null) return;
      written = address;
      history.replaceState(null, "", `#${address}`);
    }, ADDRESS_EVERY);
  };
}
