// Drag tool: pulls and places bodies of a live mechanism, by mouse and by keys.

import { belongsTo, keyName } from "./keys.js";
import { say } from "./say.js";

/** @import {App, Grip} from "./app.js" */
/** @import {Live} from "./live.js" */
/** @import {Projection} from "./view.js" */

/** Directions on the screen: to the right, upwards. @type {{[key: string]: number[]}} */
const ARROW_KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/** Turns of a placed body, rad. @type {{[key: string]: number}} */
const TURN_KEYS = { PageUp: Math.PI / 90, PageDown: -Math.PI / 90 };
/** The length of a spring by key, and the way of a placed body, as shares of the size of the mechanism. */
const KEY_PULL = 0.25;
const KEY_STEP = 0.01;

/**
 * Takes hold of the point of a body that is seen at a place of the screen; whether it can be seen.
 * @param {App} app
 * @param {"pull" | "place"} kind
 * @param {number} body
 * @param {Projection} projection
 * @param {number} px
 * @param {number} py
 */
function grab(app, kind, body, projection, px, py) {
  const shown = app.runViews.find(({ run }) => run.isLive);
  const whyNot = kind === "pull" ? (app.live?.unmoved ?? "") : "";
  if (whyNot !== "") {
    say(app, whyNot);
    return false;
  }
  const target = shown === undefined ? null : projection.onPlane(px, py, shown.scene.levels.bodies[body]);
  if (shown === undefined || target === null) return false;
  const [x, y, angle] = shown.scene.at(Math.min(app.player.time, shown.run.end)).poses.subarray(3 * body, 3 * body + 3);
  const [dx, dy, cos, sin] = [target[0] - x, target[1] - y, Math.cos(angle), Math.sin(angle)];
  app.drag = { kind, body, point: [cos * dx + sin * dy, cos * dy - sin * dx], target, reach: null };
  app.player.isFollowing = true;
  app.select({ kind: "body", index: body });
  return true;
}

/**
 * @param {App} app
 * @param {Projection} projection
 * @param {number} px
 * @param {number} py
 */
function moveBody(app, projection, px, py) {
  const { drag, live, scene } = app;
  if (drag === null || live === null || scene === null) return;
  const target = projection.onPlane(px, py, scene.levels.bodies[drag.body]);
  if (target === null) return;
  drag.target = target;
  const { body, point } = drag;
  if (drag.kind === "place") live.place(body, point, target);
  else live.pull({ body, point, target, ...live.stiffness(body, point), force: null });
}

/** @param {App} app */
function releaseBody(app) {
  if (app.drag?.kind === "pull") app.live?.pull(null);
  app.drag = null;
}

/** @param {App} app @returns {Grip} */
export function dragTool(app) {
  return {
    grab: (kind, body, projection, x, y) => grab(app, kind, body, projection, x, y),
    move: (projection, x, y) => moveBody(app, projection, x, y),
    letGo: () => releaseBody(app),
  };
}

/**
 * Arrow keys pull the selected body while they are down, or move it; page keys turn it.
 * @param {App} app
 */
export function listenToDragKeys(app) {
  /** @type {Set<string>} */
  const down = new Set();
  document.addEventListener("keydown", (event) => {
    const { live, selected, mode } = app;
    const isDragged = mode === "place" || (mode === "pull" && event.key in ARROW_KEYS);
    if (live === null || app.run !== live.run || selected?.kind !== "body" || !isDragged) return;
    if (keyName(event) !== event.key || !(event.key in ARROW_KEYS || event.key in TURN_KEYS)) return;
    const target = event.target instanceof HTMLElement ? event.target : document.body;
    if (document.querySelector("dialog[open]") !== null || target.id === "time" || belongsTo(target, event.key)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    down.add(event.key);
    if (mode === "place") placeByKey(app, live, selected.index, event.key);
    else if (!event.repeat) pullByKeys(app, live, selected.index, down);
    app.touch();
  });
  const release = (/** @type {string[]} */ keys) => {
    if (!keys.some((key) => down.delete(key)) || app.live === null) return;
    if (app.drag?.kind === "pull" && down.size > 0) pullByKeys(app, app.live, app.drag.body, down);
    else releaseBody(app);
    app.touch();
  };
  document.addEventListener("keyup", (event) => release([event.key]));
  window.addEventListener("blur", () => release([...down]));
}

/** A direction of the screen in absolute axes. @param {App} app @param {number[]} direction */
function alongScreen(app, [dx, dy]) {
  const [right, up] = app.view.axes();
  return [dx * right[0] + dy * up[0], dx * right[1] + dy * up[1]];
}

/** @param {App} app @param {number} body */
function centreOf(app, body) {
  const { run } = app;
  const row = Math.max(0, (run?.rows ?? 0) - 1);
  return [run?.poses.at(row, 6 * body) ?? NaN, run?.poses.at(row, 6 * body + 1) ?? NaN];
}

/**
 * A constant force at the centre of gravity, as large as that of a spring pulled so far by the mouse.
 * @param {App} app
 * @param {Live} live
 * @param {number} body
 * @param {Set<string>} down
 */
function pullByKeys(app, live, body, down) {
  const sum = [...down].reduce(([x, y], key) => [x + (ARROW_KEYS[key]?.[0] ?? 0), y + (ARROW_KEYS[key]?.[1] ?? 0)], [0, 0]);
  const along = alongScreen(app, sum);
  const { stiffness } = live.stiffness(body, [0, 0]);
  const reach = along.map((part) => KEY_PULL * live.size() * part);
  const hold = { body, point: [0, 0], target: [0, 0] };
  app.player.isFollowing = true;
  app.drag = { kind: "pull", ...hold, reach };
  live.pull({ ...hold, stiffness, damping: 0, force: reach.map((part) => stiffness * part) });
}

/** @param {App} app @param {Live} live @param {number} body @param {string} key */
function placeByKey(app, live, body, key) {
  const along = alongScreen(app, ARROW_KEYS[key] ?? [0, 0]);
  const step = KEY_STEP * live.size();
  const [x, y] = centreOf(app, body);
  live.place(body, [0, 0], [x + step * along[0], y + step * along[1]], TURN_KEYS[key] ?? 0);
}
