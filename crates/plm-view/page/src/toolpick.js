// Picking for tools: points and bodies to be measured between, by mouse or finger.

import { bodyMark, freeMark, isWhole, measureName, namedMarks, placeOfMark, withMark } from "./measure.js";
import { pickAt } from "./picture.js";

/** @import {App} from "./app.js" */
/** @import {Mark, MeasureKind} from "./measure.js" */

/** A point that has a name is picked within so many pixels; by a finger within more. */
const NEAR_POINT = 12;

/** What a press measures; null in another mode. @param {App} app @returns {MeasureKind | null} */
export function measuring({ mode }) {
  return mode === "distance" || mode === "angle" ? mode : null;
}

/**
 * The point with a name that is near a place of the picture; else the point of the body there, or the body itself for an angle.
 * @param {App} app
 * @param {number} x
 * @param {number} y
 * @param {{reach?: number}} how
 * @returns {Mark | null}
 */
function markAt(app, x, y, how) {
  const at = app.visible().findIndex(({ run }) => run === app.run);
  const { run, scene } = app;
  if (at < 0 || run === null || scene === null || run.rows === 0) return null;
  const { mechanism, levels } = scene;
  const projection = app.view.projection(app.areas()[at]);
  const places = scene.at(Math.min(app.player.time, run.end));
  const depth = (/** @type {Mark} */ { body, name }) =>
    body === null ? (mechanism.ground.find((port) => `ground.${port.name}` === name)?.depth ?? 0) : levels.bodies[body];
  let best = { mark: /** @type {Mark | null} */ (null), distance: Math.max(NEAR_POINT, how.reach ?? 0) };
  for (const mark of namedMarks(mechanism)) {
    // For an angle the middle of a body is the body.
    if (app.mode === "angle" && mark.name.endsWith(".G")) continue;
    const [px, py] = projection.point(...placeOfMark(mark, places, mechanism), depth(mark));
    const distance = Math.hypot(px - x, py - y);
    if (distance < best.distance) best = { mark, distance };
  }
  if (best.mark !== null) return best.mark;
  const { item } = pickAt(app, x, y, { ...how, kind: "body" });
  if (item?.kind !== "body") return null;
  if (app.mode === "angle") return bodyMark(mechanism, item.index);
  const point = projection.onPlane(x, y, levels.bodies[item.index]);
  if (point === null) return null;
  const [gx, gy, angle] = places.poses.subarray(3 * item.index, 3 * item.index + 3);
  const [dx, dy, cos, sin] = [point[0] - gx, point[1] - gy, Math.cos(angle), Math.sin(angle)];
  return freeMark(mechanism, item.index, [cos * dx + sin * dy, cos * dy - sin * dx]);
}

/**
 * A press in the picture while something is measured.
 * @param {App} app
 * @param {number} x
 * @param {number} y
 * @param {{reach?: number}} how
 */
export function pressMeasure(app, x, y, how) {
  const mark = markAt(app, x, y, how);
  if (mark !== null) addMark(app, mark);
}

/** @param {App} app @param {Mark} mark */
export function addMark(app, mark) {
  const kind = measuring(app) ?? "distance";
  app.marks = withMark(kind, app.marks, mark);
  if (isWhole(kind, app.marks)) {
    const name = measureName({ kind, marks: app.marks });
    app.marks = [];
    if (!app.tools.measures.includes(name)) app.tools.measures.push(name);
  }
  app.change();
}

/** A measure goes, and its curve. @param {App} app @param {string} name */
export function removeMeasure(app, name) {
  app.tools.measures = app.tools.measures.filter((other) => other !== name);
  app.curves = app.curves.filter((other) => other !== name);
  if (app.across === name) app.across = null;
  app.change();
}

/** What Escape lets go of measuring: marks, then measures, then the mode; whether there was anything. @param {App} app */
export function dropMeasures(app) {
  const { tools } = app;
  if (app.marks.length > 0) app.marks = [];
  else if (tools.measures.length > 0) for (const name of tools.measures) removeMeasure(app, name);
  else if (measuring(app) !== null) app.mode = app.live?.usualMode ?? "pan";
  else return false;
  app.change();
  return true;
}
