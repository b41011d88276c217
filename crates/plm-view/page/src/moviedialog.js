// Dialog of moving pictures: which stretch, how wide, as what; progress, and what has become of it.

import { optionRow, showDialog } from "./dialogs.js";
import { element, saveBlob, setText } from "./dom.js";
import { filmOf, makeGif, makeVideo, videoKind } from "./movie.js";
import { fileStem } from "./picture.js";
import { loopOf, turningBody, turnOf } from "./stretch.js";
import { shortNumber } from "./text.js";

/** @import {App} from "./app.js" */
/** @import {Stretch, StretchName} from "./stretch.js" */

/** Frames a second: delays of a GIF are whole hundredths of a second. */
const GIF_RATE = 25;
const VIDEO_RATE = 30;
const WIDEST = 1920;

/**
 * The stretches that there are, with their names.
 * @param {App} app
 * @returns {Map<StretchName, {name: string, stretch: Stretch}>}
 */
function stretchesOf({ run, player, selected }) {
  const found = new Map();
  if (run === null || run.rows < 2) return found;
  const body = turningBody(run, selected?.kind === "body" ? selected.index : null, player.time);
  const turn = body === null ? null : turnOf(run, body, player.time);
  const loop = loopOf(run, player.time) ?? loopOf(run, run.start);
  if (turn !== null && body !== null) found.set("turn", { name: `one turn of ${run.mechanism.bodies[body].name}`, stretch: turn });
  if (loop !== null) found.set("loop", { name: "the loop, until all stands as now", stretch: loop });
  return found.set("run", { name: "the whole run", stretch: { from: run.start, to: run.end } });
}

/** @param {number} bytes */
function sizeText(bytes) {
  return bytes < 1e6 ? `${Math.ceil(bytes / 1000)} kB` : `${shortNumber(bytes / 1e6, 3)} MB`;
}

/** @param {App} app */
export function openMovie(app) {
  app.stop();
  const stretches = stretchesOf(app);
  const video = videoKind();
  const { area } = app;
  const kind = element("select", { id: "movie-kind" }, new Option("GIF", "gif"), ...(video === null ? [] : [new Option(`Video (${video.end})`, "video")]));
  const part = element("select", { id: "movie-part" }, ...[...stretches].map(([value, { name }]) => new Option(name, value)));
  const width = element("input", { type: "number", id: "movie-width", min: 100, max: WIDEST, value: Math.min(WIDEST, Math.round(area.width)) });
  const progress = element("progress", { id: "movie-progress", max: 1, value: 0, "aria-label": "Frames that are done" });
  const state = element("p", { id: "movie-state", role: "status" });
  const go = element("button", { type: "button", id: "movie-go" }, "Save");
  const cancel = element("button", { type: "button", id: "movie-cancel", hidden: true }, "Cancel");
  let isCancelled = false;

  const plan = () => {
    const chosen = stretches.get(/** @type {StretchName} */ (part.value));
    if (chosen === undefined) return null;
    const wide = Math.max(100, Math.min(WIDEST, Math.round(Number(width.value)) || area.width));
    const film = filmOf(chosen.stretch, app.player.speed, kind.value === "gif" ? GIF_RATE : VIDEO_RATE, part.value !== "run");
    return { film, size: { width: wide, height: Math.max(1, Math.round((wide * area.height) / area.width)) } };
  };
  const foretell = () => {
    const planned = plan();
    go.disabled = planned === null;
    if (planned === null) setText(state, "Nothing has been recorded.");
    else setText(state, `${planned.film.times.length} frames, ${shortNumber(planned.film.times.length / planned.film.rate, 3)} s, ${planned.size.width} × ${planned.size.height} pixels`);
  };
  const save = async () => {
    const planned = plan();
    if (planned === null) return;
    const { film, size } = planned;
    isCancelled = false;
    [go.disabled, cancel.hidden] = [true, false];
    const tell = (/** @type {number} */ done, /** @type {number} */ bytes) => {
      progress.value = done / film.times.length;
      setText(state, `Frame ${done} of ${film.times.length}, ${sizeText(bytes)}`);
    };
    const watch = { isCancelled: () => isCancelled || !cancel.isConnected, tell };
    try {
      const made = kind.value === "gif" ? await makeGif(app, film, size, watch) : await makeVideo(app, film, size, watch);
      const blob = made instanceof Uint8Array ? new Blob([made], { type: "image/gif" }) : made;
      if (blob !== null) saveBlob(blob, `${fileStem(app)}.${kind.value === "gif" ? "gif" : (video?.end ?? "webm")}`);
      setText(state, blob === null ? "Cancelled." : `Saved: ${film.times.length} frames, ${size.width} × ${size.height} pixels, ${sizeText(blob.size)}.`);
    } catch (error) {
      setText(state, `It could not be made: ${error instanceof Error ? error.message : error}`);
    }
    [go.disabled, cancel.hidden, progress.value] = [false, true, 0];
  };
  for (const control of [kind, part, width]) control.addEventListener("input", foretell);
  go.addEventListener("click", () => void save());
  cancel.addEventListener("click", () => (isCancelled = true));
  showDialog("Moving picture", [
    optionRow("What", part),
    optionRow("As", kind),
    optionRow("Width, pixels", width),
    element("p", { class: "hint" }, `It shows the picture as it is, at a speed of ${shortNumber(app.player.speed)}×.`),
    progress,
    state,
    element("div", { class: "row" }, go, cancel),
  ]);
  foretell();
}
