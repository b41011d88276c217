// Moving pictures: the picture of a stretch of the run, frame by frame, as GIF or by the browser's own recorder as video.

import { GifEncoder, PaletteMaker } from "./gif.js";
import { CanvasPen } from "./pen.js";
import { drawPicture } from "./picture.js";

/** @import {App} from "./app.js" */
/** @import {Stretch} from "./stretch.js" */

/** @typedef {{times: number[], rate: number}} Film times of the run, and frames a second */
/** @typedef {{width: number, height: number}} Size pixels */
/** @typedef {{isCancelled: () => boolean, tell: (done: number, bytes: number) => void}} Watch */

const MOST_FRAMES = 900;
/** Frames whose colours make the palette. */
const PALETTE_FRAMES = 12;
/** So long, ms, work goes on before the page is let live. */
const TURN = 30;
/** Kinds of video in the order in which they are wanted, with the ends of their names. */
const VIDEO_KINDS = [["video/mp4;codecs=avc1.42E01F", "mp4"], ["video/webm;codecs=vp9", "webm"], ["video/webm", "webm"]];

/**
 * The frames of a stretch at a speed. A loop leaves out the last moment, which is the first again. Where they would be too many they
 * are fewer a second.
 * @param {Stretch} stretch
 * @param {number} speed
 * @param {number} rate frames a second
 * @param {boolean} isLoop
 * @returns {Film}
 */
export function filmOf({ from, to }, speed, rate, isLoop) {
  const seconds = (to - from) / speed;
  const count = Math.max(1, Math.min(MOST_FRAMES, Math.round(seconds * rate)));
  const times = Array.from({ length: isLoop ? count : count + 1 }, (_, at) => from + (at / count) * (to - from));
  return { times, rate: seconds > 0 ? count / seconds : rate };
}

/** @returns {{type: string, end: string} | null} the kind of video that this browser records */
export function videoKind() {
  if (typeof MediaRecorder === "undefined" || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  const found = VIDEO_KINDS.find(([type]) => MediaRecorder.isTypeSupported(type));
  return found === undefined ? null : { type: found[0], end: found[1] };
}

/** A canvas on which frames are painted. @param {App} app @param {Size} size */
function filmCanvas(app, { width, height }) {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (context === null) throw new Error("this browser draws no Canvas 2D");
  const pen = new CanvasPen(context);
  const paint = (/** @type {number} */ time) => {
    const { player, area } = app;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = app.palette.background;
    context.fillRect(0, 0, width, height);
    context.setTransform(width / area.width, 0, 0, height / area.height, 0, 0);
    const now = player.time;
    player.time = time;
    drawPicture(pen, app);
    player.time = now;
  };
  return { canvas, paint, pixels: () => new Uint32Array(context.getImageData(0, 0, width, height).data.buffer) };
}

/** Lets the page live when it has waited too long. */
function breather() {
  let since = performance.now();
  return async () => {
    if (performance.now() - since < TURN) return;
    await new Promise((resolve) => setTimeout(resolve, 0));
    since = performance.now();
  };
}

/**
 * @param {App} app
 * @param {Film} film
 * @param {Size} size
 * @param {Watch} watch
 * @returns {Promise<Uint8Array<ArrayBuffer> | null>} null where it was cancelled
 */
export async function makeGif(app, { times, rate }, size, watch) {
  const { paint, pixels } = filmCanvas(app, size);
  const rest = breather();
  const palette = new PaletteMaker();
  const stride = Math.max(1, Math.floor(times.length / PALETTE_FRAMES));
  for (let at = 0; at < times.length; at += stride) {
    paint(times[at]);
    palette.add(pixels());
    await rest();
    if (watch.isCancelled()) return null;
  }
  const gif = new GifEncoder(size.width, size.height, palette.finish());
  for (let at = 0; at < times.length; at++) {
    paint(times[at]);
    // Rounded ends, so that delays of whole hundredths add up to the duration.
    gif.addFrame(pixels(), Math.max(2, Math.round((100 * (at + 1)) / rate) - Math.round((100 * at) / rate)));
    watch.tell(at + 1, gif.length);
    await rest();
    if (watch.isCancelled()) return null;
  }
  return gif.finish();
}

/**
 * Takes as long as the video lasts, because the recorder keeps the time.
 * @param {App} app
 * @param {Film} film
 * @param {Size} size
 * @param {Watch} watch
 * @returns {Promise<Blob | null>} null where it was cancelled
 */
export async function makeVideo(app, { times, rate }, { width, height }, watch) {
  const kind = videoKind();
  if (kind === null) throw new Error("this browser records no video");
  // Coders of video want even numbers.
  const { canvas, paint } = filmCanvas(app, { width: width & ~1, height: height & ~1 });
  const stream = canvas.captureStream(0);
  const track = /** @type {CanvasCaptureMediaStreamTrack} */ (stream.getVideoTracks()[0]);
  const recorder = new MediaRecorder(stream, { mimeType: kind.type, videoBitsPerSecond: 6e6 });
  /** @type {Blob[]} */
  const parts = [];
  let bytes = 0;
  recorder.ondataavailable = ({ data }) => {
    parts.push(data);
    bytes += data.size;
  };
  const stopped = new Promise((resolve) => (recorder.onstop = resolve));
  recorder.start(200);
  const began = performance.now();
  for (let at = 0; at < times.length && !watch.isCancelled(); at++) {
    paint(times[at]);
    track.requestFrame();
    watch.tell(at + 1, bytes);
    const due = began + (1000 * (at + 1)) / rate;
    await new Promise((resolve) => setTimeout(resolve, Math.max(0, due - performance.now())));
  }
  recorder.stop();
  await stopped;
  track.stop();
  return watch.isCancelled() ? null : new Blob(parts, { type: kind.type });
}
