// A moving picture of a page, as an animated WebP that repeats for ever:
//
//     node browser/moving.js PAGE.html OUT.webp [options]
//
//     --width 560 --height 350   size in pixels
//     --frames 70 --fps 20       number of frames, and how many are shown in a second
//     --from 0 --period 2.5      seconds of the run that are shown; where it repeats, the loop has no seam.
//                                Without --period: until the state comes back to that at --from, else to the end of the run.
//                                Without --from: the second period if there is one, else from the start
//     --scheme light|dark        colours; --back "#ffffff" is a background of one's own
//     --view front|isometric|…   direction of view, or `azimuth,elevation` in degrees; all that moves is in the frame
//     --paths "coupler.tip|…"    paths of points that are drawn
//     --forces all|"joint|…"     joints whose force has an arrow; --velocities draws those of all bodies
//     --arrows 1.5               length of arrows; --key draws what their length means
//
// A page that computes the mechanism itself is run to --from + --period first; --period must be given then.

import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { skip, theBrowser } from "./support/browser.js";
import { changedPatch, inPalette, muxWebp, paletteOf } from "./support/webp.js";

const OPTIONS = /** @type {const} */ ({
  width: "560", height: "", frames: "70", fps: "20", from: "", period: "", scheme: "light", back: "", view: "front",
  paths: "", forces: "", arrows: "1", margin: "0.03",
});

/** More than this is too large for a README. */
const MOST_BYTES = 500_000;

/**
 * The file of a moving picture, and what it shows.
 * @param {string} address @param {Given} given
 */
export async function movingPicture(address, given = {}) {
  const { raw, size, times, tab } = await framesOf(address, given);
  try {
    const file = await encode(tab, size, raw, Number(given.fps ?? OPTIONS.fps));
    return { file, frames: times.length, from: times[0], period: (times[1] - times[0]) * times.length };
  } finally {
    await tab.close();
  }
}

/** @typedef {Partial<Record<keyof typeof OPTIONS | "velocities" | "key", any>>} Given options by their names */

/**
 * The frames of a moving picture as pixels, or each `every`-th of them, with the tab in which the page stands.
 * @param {string} address @param {Given} given @param {number} [every]
 */
export async function framesOf(address, given, every = 1) {
  const how = { ...OPTIONS, ...given };
  const [width, count] = [Number(how.width), Number(how.frames)];
  const height = Number(how.height) || 2 * Math.round(0.3125 * width);
  // In a window that is much smaller, Chromium draws one frame a second.
  const viewport = { width: Math.max(width, 1200), height: Math.max(height, 800) };
  const tab = await (await theBrowser()).newPage({ viewport, deviceScaleFactor: 2 });
  try {
    await openBare(tab, address, { scheme: how.scheme, width, height });
    const times = await tab.evaluate(showMotion, { ...how, count });
    await tab.evaluate(frameMotion, { times, margin: Number(how.margin) });
    const raw = [];
    for (const time of times.filter((_, at) => at % every === 0)) {
      const text = await tab.evaluate(grabFrame, { time, width, height });
      raw.push({ width, height, data: new Uint8ClampedArray(Buffer.from(text, "base64")) });
    }
    return { raw, size: { width, height }, times, tab };
  } catch (error) {
    await tab.close();
    throw error;
  }
}

/** The picture alone. */
async function openBare(tab, address, { scheme, width, height }) {
  // Who asked for less motion begins it: the page stands until it is told how far to run.
  await tab.emulateMedia({ colorScheme: scheme, reducedMotion: "reduce" });
  await tab.goto(address);
  await tab.waitForFunction(() => "plmPage" in window && window.plmPage.app.run !== null);
  const place = `position: fixed !important; left: 0; top: 0; width: ${width}px; height: ${height}px; z-index: 1000;`;
  await tab.addStyleTag({ content: `#stage { ${place} } #stage > :not(#picture) { display: none !important; }` });
  await tab.evaluate(() => document.fonts.ready);
}

/** In the page: shows what was asked for, and gives the times of the frames. */
async function showMotion({ count, from, period, scheme, back, view, paths, forces, velocities, arrows, key }) {
  const { app } = window.plmPage;
  app.stop();
  if (app.live?.isShown) await runLive();
  const { run } = app;
  if (run === null || run.rows < 2) throw new Error("the page has no run to show; one that computes needs --period");
  const listed = (text) => text.split("|").filter((name) => name !== "");
  const points = run.mechanism.bodies.flatMap(({ name, ports }) => [`${name}.G`, ...ports.map((port) => `${name}.${port.name}`)]);
  const unknown = listed(paths).filter((name) => !points.includes(name));
  if (unknown.length > 0) throw new Error(`no points ${unknown.join(", ")}; there are ${points.join(", ")}`);
  const joints = run.mechanism.parts.map(({ name }) => name);
  const forcesOf = forces === "all" || forces === "" ? null : listed(forces);
  const strangers = forcesOf?.filter((name) => !joints.includes(name)) ?? [];
  if (strangers.length > 0) throw new Error(`no joints ${strangers.join(", ")}; there are ${joints.join(", ")}`);
  Object.assign(app, { theme: scheme, background: back || null, refreshRate: 1000, selected: null, window: null, isWire: false });
  Object.assign(app, { traces: listed(paths), showsForces: forces !== "", forcesOf, showsVelocities: Boolean(velocities) });
  Object.assign(app, { arrowFactor: Number(arrows), layout: "one", hasAxes: false, hasArrowKey: Boolean(key) });
  const [azimuth, elevation] = view.split(",").map(Number);
  if (Number.isFinite(azimuth)) Object.assign(app.view, { azimuth, elevation: elevation || 0 });
  else app.view.lookFrom(view);
  if (app.live !== null) app.live.followCamera.chosen = null;
  const begun = from === "" ? run.start : Number(from);
  const repeats = period !== "" ? Number(period) : recurrence(begun);
  const whole = repeats ?? run.end - begun;
  // After a first period all of the path has been travelled.
  const start = from === "" && repeats !== null && run.end >= begun + 2 * repeats ? begun + repeats : begun;
  return Array.from({ length: count }, (_, frame) => start + (frame * whole) / count);

  async function runLive() {
    const { live } = app;
    const [first, last] = [Number(from), Number(from) + Number(period)];
    if (!(last > first)) return;
    live.step((last - first) / (4 * count), Math.ceil((4 * count * (last + 0.01)) / (last - first)));
    while (live.run.end < last && live.run.fault === null) await new Promise(requestAnimationFrame);
  }

  /** How long it takes until all bodies are where they were, with their rates; null if they never are. */
  function recurrence(time) {
    const { poses, rows, mechanism } = run;
    const row0 = Math.min(run.momentAt(time).row, rows - 2);
    const columns = mechanism.bodies.flatMap((_, body) => [0, 1, 2, 3, 4, 5].map((axis) => 6 * body + axis));
    const spans = columns.map((column) => {
      if (column % 6 === 2) return 1;
      let [low, high] = [Infinity, -Infinity];
      for (let row = row0; row < rows; row++) [low, high] = [Math.min(low, poses.at(row, column)), Math.max(high, poses.at(row, column))];
      // What hardly moves must not decide by its rounding.
      return Math.max(high - low, 1e-6);
    });
    const away = (row) =>
      Math.max(...columns.map((column, at) => {
        const change = poses.at(row, column) - poses.at(row0, column);
        return column % 6 === 2 ? Math.abs(Math.sin(0.5 * change)) : Math.abs(change) / spans[at];
      }));
    let hasLeft = false;
    for (let row = row0 + 1; row < rows; row++) {
      const now = away(row);
      hasLeft ||= now > 0.3;
      if (!hasLeft || now > 0.05 || (row + 1 < rows && away(row + 1) < now)) continue;
      return run.time.data[row] - run.time.data[row0];
    }
    return null;
  }
}

/** In the page: everything that is drawn at these times is in the picture, as large as it can be. */
async function frameMotion({ times, margin }) {
  const { app } = window.plmPage;
  const canvas = document.querySelector("#picture");
  const next = () => new Promise(requestAnimationFrame);
  app.touch();
  await next();
  await next();
  app.zoomToExtents();
  // From far enough no arrow is cut off; a second look, at all frames, measures more exactly.
  for (const factor of [0.35, 1]) {
    app.view.zoom(factor);
    let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const [at, time] of times.entries()) {
      if (factor < 1 && at % 4 !== 0) continue;
      app.player.seek(time);
      app.touch();
      await next();
      await next();
      const { width, height } = canvas;
      const words = new Uint32Array(canvas.getContext("2d").getImageData(0, 0, width, height).data.buffer);
      for (let at = 0; at < words.length; at++) {
        if (words[at] === words[0]) continue;
        const [x, y] = [at % width, Math.floor(at / width)];
        [left, right] = [Math.min(left, x), Math.max(right, x)];
        [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
      }
    }
    if (right < left) throw new Error("nothing is drawn");
    const ratio = canvas.width / app.area.width;
    const rim = margin * Math.min(app.area.width, app.area.height);
    const scale = Math.min(app.area.width / ((right - left) / ratio + 2 * rim), app.area.height / ((bottom - top) / ratio + 2 * rim));
    // The middle of what is drawn comes to the middle of the picture.
    app.view.pan(0.5 * app.area.width - (0.5 * (left + right)) / ratio, 0.5 * app.area.height - (0.5 * (top + bottom)) / ratio);
    // Arrows have heads of a fixed size, and lines a width: not quite as near as the measure tells.
    app.view.zoom(factor === 1 ? Math.min(scale, 1.02) : 0.94 * scale);
  }
}

/** In the page: a frame in the size of the animation, as text of its RGBA. */
async function grabFrame({ time, width, height }) {
  const { app } = window.plmPage;
  app.player.seek(time);
  app.touch();
  const next = () => new Promise(requestAnimationFrame);
  await next();
  await next();
  const small = new OffscreenCanvas(width, height);
  const context = small.getContext("2d");
  context.imageSmoothingQuality = "high";
  context.drawImage(document.querySelector("#picture"), 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  let text = "";
  for (let at = 0; at < data.length; at += 0x8000) text += String.fromCharCode(...data.subarray(at, at + 0x8000));
  return btoa(text);
}

async function encode(tab, size, raw, fps) {
  const frames = inPalette(raw, paletteOf(raw));
  const coded = [];
  let shown = 0;
  for (const [at, frame] of frames.entries()) {
    const patch = changedPatch(at === 0 ? null : frames[at - 1], frame);
    const { x, y, width, height, data } = patch;
    const text = await tab.evaluate(stillWebp, { width, height, pixels: Buffer.from(data).toString("base64") });
    // Rounded so that all of it takes as long as it should.
    const until = Math.round((1000 * (at + 1)) / fps);
    coded.push({ x, y, width, height, ms: until - shown, webp: Buffer.from(text, "base64") });
    shown = until;
  }
  return muxWebp(size, coded);
}

/** In the page: pixels as a lossless WebP file. */
async function stillWebp({ width, height, pixels }) {
  const data = Uint8ClampedArray.from(atob(pixels), (sign) => sign.charCodeAt(0));
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  canvas.getContext("2d").putImageData(new ImageData(data, width, height), 0, 0);
  const blob = await new Promise((done) => canvas.toBlob(done, "image/webp", 1));
  const bytes = new Uint8Array(await blob.arrayBuffer());
  let text = "";
  for (let at = 0; at < bytes.length; at += 0x8000) text += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
  return btoa(text);
}

if (process.argv[1]?.endsWith("moving.js")) {
  if (skip) throw new Error(skip);
  const names = Object.keys(OPTIONS).map((name) => [name, { type: "string" }]);
  const options = Object.fromEntries([...names, ["velocities", { type: "boolean" }], ["key", { type: "boolean" }]]);
  const { values, positionals } = parseArgs({ options, allowPositionals: true });
  const [source, target] = positionals;
  if (target === undefined) throw new Error("usage: node browser/moving.js PAGE.html OUT.webp [options]; its first lines tell which");
  const { file, frames, from, period } = await movingPicture(pathToFileURL(resolve(source)).href, values);
  if (file.length > MOST_BYTES) throw new Error(`${target} would have ${file.length} bytes, more than ${MOST_BYTES}`);
  writeFileSync(target, file);
  console.log(`${target}: ${frames} frames, ${(file.length / 1000).toFixed(0)} kB, from ${from.toPrecision(4)} s for ${period.toPrecision(4)} s`);
  await (await theBrowser()).close();
}
