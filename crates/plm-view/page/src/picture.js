// The picture of the scene, on the canvas or in a file.

import { drawArrowKey, drawArrows } from "./arrows.js";
import { drawAxes, drawFault, drawDrag, drawScaleBar, drawSelection } from "./decor.js";
import { saveBlob } from "./dom.js";
import { drawScene } from "./draw.js";
import { drawGhosts } from "./ghosts.js";
import { CanvasPen, SvgPen } from "./pen.js";
import { pickItem } from "./pick.js";
import { drawTools } from "./tooldraw.js";
import { drawTrace, tracePath, tracePoints } from "./traces.js";

/** @import {App} from "./app.js" */
/** @import {RunView} from "./runview.js" */
/** @import {Palette} from "./palette.js" */
/** @import {Pen} from "./pen.js" */
/** @import {Run} from "./run.js" */
/** @import {Item} from "./solid.js" */
/** @import {TracePath} from "./traces.js" */
/** @import {Area} from "./view.js" */

/** Paths are worked out once. @type {WeakMap<Run, Map<string, TracePath>>} */
const knownPaths = new WeakMap();

/**
 * Draws all of the picture but its background.
 * @param {Pen} pen
 * @param {App} app
 */
export function drawPicture(pen, app) {
  const shown = app.visible();
  const { palette } = app;
  const areas = app.areas();
  shown.forEach((each, at) => {
    const isSide = app.layout === "side" && shown.length > 1;
    pen.within(areas[at], () => drawRun(pen, app, each, areas[at]));
    if (isSide || (app.layout === "overlay" && shown.length > 1)) drawRunName(pen, app, each, areas[at], isSide ? 0 : at);
  });
  if (shown.length > 0) {
    const projection = app.view.projection(app.area);
    if (app.hasAxes) {
      drawAxes(pen, projection, palette);
      drawScaleBar(pen, projection, palette);
    }
  }
  if (app.window !== null) drawWindow(pen, app.window, palette);
}

/**
 * @param {Pen} pen
 * @param {App} app
 * @param {RunView} shown
 * @param {Area} area
 */
function drawRun(pen, app, { run, scene, forces, velocities }, area) {
  const { palette, selected } = app;
  const isGhost = app.layout === "overlay" && run !== app.run;
  const projection = app.view.projection(area);
  if (run.rows === 0) return;
  const time = Math.min(Math.max(app.player.time, run.start), run.end);
  if (app.tools.ghosts > 0 && !isGhost) drawGhosts(pen, scene, app.tools.ghosts, { projection, palette, isWire: app.isWire });
  const places = scene.at(time);
  const moment = run.momentAt(time);
  const ghost = isGhost ? ghostColour(app, run) : null;
  const isPlain = app.layout === "overlay" && app.visible().length > 1;
  drawScene(pen, scene, places, projection, { palette, isWire: app.isWire, selected: isGhost ? null : selected, ghost, isPlain });
  const points = app.traces.length > 0 ? tracePoints(run) : [];
  app.traces.forEach((name, at) => {
    const point = points.find((candidate) => candidate.name === name);
    if (point === undefined) return;
    const colour = palette.trace[at % palette.trace.length];
    drawTrace(pen, scene, pathOf(run, name), { body: point.body, time, projection, colour });
  });
  if (isGhost) return;
  const how = { places, moment, projection, factor: app.arrowFactor };
  if (app.showsVelocities) drawArrows(pen, scene, velocities, { ...how, colour: palette.velocity });
  if (app.showsForces) drawArrows(pen, scene, forces, { ...how, colour: palette.force, only: app.forcesOf });
  if (app.drag !== null && run.isLive) drawDrag(pen, scene, app.drag, places, projection, palette);
  if (selected !== null) drawSelection(pen, scene, selected, places, projection, palette);
  drawTools(pen, app, scene, { places, moment, projection, palette });
  if (run.fault !== null && time >= run.fault.time) drawFault(pen, scene, run.fault.part, places, projection, palette);
  if (app.hasArrowKey) drawKeys(pen, app, { scene, forces, velocities }, area);
}

/**
 * @param {Pen} pen
 * @param {App} app
 * @param {Pick<RunView, "scene" | "forces" | "velocities">} shown
 * @param {Area} area
 */
function drawKeys(pen, app, { scene, forces, velocities }, area) {
  const { palette } = app;
  const how = { projection: app.view.projection(area), ink: palette.ink, factor: app.arrowFactor };
  let line = app.layout === "one" ? 0 : 1 + (app.layout === "overlay" ? app.visible().length - 1 : 0);
  if (app.showsForces) drawArrowKey(pen, scene, forces, { ...how, colour: palette.force, name: "force", line: line++ });
  if (app.showsVelocities) drawArrowKey(pen, scene, velocities, { ...how, colour: palette.velocity, name: "velocity", line });
}

/**
 * @param {Run} run
 * @param {string} name
 */
function pathOf(run, name) {
  const paths = knownPaths.get(run) ?? new Map();
  knownPaths.set(run, paths);
  const known = paths.get(name);
  if (known?.version === run.version) return known;
  const point = tracePoints(run).find((candidate) => candidate.name === name);
  const path = point === undefined ? { version: run.version, stride: 1, line: [], times: [] } : tracePath(run, point);
  paths.set(name, path);
  return path;
}

/** @param {App} app @param {Run} run */
export function ghostColour(app, run) {
  const { ghosts } = app.palette;
  return ghosts[app.runViews.findIndex((shown) => shown.run === run) % ghosts.length];
}

/**
 * @param {Pen} pen
 * @param {App} app
 * @param {RunView} shown
 * @param {Area} area
 * @param {number} line
 */
function drawRunName(pen, app, { run }, area, line) {
  const { palette } = app;
  const isActive = run === app.run;
  const [x, y] = [area.x + 14, area.y + 18 + 20 * line];
  if (app.layout === "side") {
    const corners = [area.x, area.y, area.x + area.width, area.y, area.x + area.width, area.y + area.height, area.x, area.y + area.height];
    pen.polygon(corners, { stroke: palette.grid, width: 1 });
  }
  const rgb = isActive || app.layout === "side" ? palette.tones.body : ghostColour(app, run);
  pen.polygon([x, y - 5, x + 10, y - 5, x + 10, y + 5, x, y + 5], { fill: `rgb(${rgb.join(",")})` });
  pen.text(x + 16, y, run.name, { colour: palette.ink, size: 12, bold: isActive });
}

/** @param {Pen} pen @param {Area} window @param {Palette} palette */
function drawWindow(pen, { x, y, width, height }, palette) {
  const corners = [x, y, x + width, y, x + width, y + height, x, y + height];
  pen.polygon(corners, { fill: palette.select, opacity: 0.12 });
  pen.polygon(corners, { stroke: palette.select, width: 2, dash: [5, 4] });
}

/**
 * The run and the object under a point of the picture.
 * @param {App} app
 * @param {number} x
 * @param {number} y
 * @param {{reach?: number, kind?: Item["kind"] | null}} [how]
 * @returns {{index: number, item: Item | null}}
 */
export function pickAt(app, x, y, how) {
  const shown = app.visible();
  const areas = app.areas();
  for (let at = shown.length - 1; at >= 0; at--) {
    const area = areas[at];
    if (x < area.x || y < area.y || x > area.x + area.width || y > area.y + area.height) continue;
    const { run, scene } = shown[at];
    if (run.rows === 0) continue;
    const places = scene.at(Math.min(app.player.time, run.end));
    const item = pickItem(scene, places, app.view.projection(area), x, y, how);
    if (item !== null || app.layout !== "overlay") return { index: app.runViews.indexOf(shown[at]), item };
  }
  return { index: app.active, item: null };
}

/** A name for files: that of the mechanism. @param {App} app */
export function fileStem(app) {
  return (app.run?.mechanism.name ?? "picture").replace(/[^\p{L}\p{N}._-]+/gu, "-");
}

/** @param {App} app */
export function pictureSvg(app) {
  const pen = new SvgPen();
  drawPicture(pen, app);
  const { width, height } = app.area;
  return pen.finish(width, height, app.palette.background, app.run?.mechanism.name ?? "");
}

/** @param {App} app */
export function saveSvg(app) {
  saveBlob(new Blob([pictureSvg(app)], { type: "image/svg+xml" }), `${fileStem(app)}.svg`);
}

/** Twice as many pixels as on the screen, for print. @param {App} app */
export async function savePng(app) {
  const { width, height } = app.area;
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [2 * width, 2 * height];
  const context = canvas.getContext("2d");
  if (context === null) return;
  context.scale(2, 2);
  context.fillStyle = app.palette.background;
  context.fillRect(0, 0, width, height);
  drawPicture(new CanvasPen(context), app);
  const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
  if (blob instanceof Blob) saveBlob(blob, `${fileStem(app)}.png`);
}
