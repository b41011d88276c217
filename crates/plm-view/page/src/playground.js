// Playground entry: starts a page in which a mechanism is typed.

import { byId } from "./dom.js";
import { undense } from "./dense.js";
import { dragTool, listenToDragKeys } from "./drag.js";
import { EditorPane } from "./editorpane.js";
import { EquationsTab } from "./equations.js";
import { Exchange, LiveTab } from "./exchange.js";
import { languageWorkerOf } from "./language.js";
import { unlzma } from "./lzma.js";
import { startPage } from "./main.js";
import { unpackText } from "./packedtext.js";
import { Pencil } from "./pencil.js";
import { Sketch } from "./sketch.js";
import { SketchBar } from "./sketchbar.js";
import { drawSheet, drawSketch } from "./sketchdraw.js";
import { startWorker } from "./startworker.js";
import { inflated } from "./zip.js";

/** @import {App} from "./app.js" */
/** @import {Example} from "./editorpane.js" */
/** @import {Panel} from "./panel.js" */

/** Bytes of all declarations to begin with, at most. */
const LONGEST_GALLERY = 1 << 22;

/** The bytes of the compiler; null where there are none. */
function packedModule() {
  const text = document.getElementById("packed-module")?.textContent ?? "";
  return text === "" ? null : unlzma(undense(text));
}

/** The declarations to begin with. @returns {Promise<Example[]>} */
async function embeddedGallery() {
  const text = document.getElementById("packed-gallery")?.textContent ?? "";
  return text === "" ? [] : JSON.parse(new TextDecoder().decode(await inflated(undense(text), LONGEST_GALLERY)));
}

/**
 * Brings the mechanism to life that the address holds, or the first one of the gallery.
 * @param {App} app
 * @returns {Promise<(panel: Panel) => void>}
 */
async function beginPlay(app) {
  const [wasm, gallery] = [packedModule(), await embeddedGallery()];
  if (wasm === null || gallery.length === 0) {
    app.tell("error", "The page holds no compiler, or nothing to begin with.");
    return () => {};
  }
  const module = await WebAssembly.compile(/** @type {Uint8Array<ArrayBuffer>} */ (wasm));
  const exchange = new Exchange(app, module, startWorker);
  exchange.named = (name) => {
    if (name !== null) document.title = name;
    document.querySelector("h1")?.replaceChildren(name ?? "Drawing");
  };
  const asked = await unpackText(new URLSearchParams(location.hash.slice(1)).get("text") ?? "");
  const text = asked ?? gallery[0].text;
  app.grip = dragTool(app);
  app.tab = "live";
  listenToDragKeys(app);
  const isShown = await exchange.declare(text);
  // Without any mechanism there is no page; what is wrong with the text stands beside it.
  if (isShown !== true) await exchange.declare(gallery[0].text);
  app.mode = app.live?.usualMode ?? "pan";
  const pane = new EditorPane(app, exchange, gallery, text);
  const sketch = drawIn(app, exchange, module, pane);
  Object.assign(window, { plmPlay: { exchange, pane, sketch } });
  return (panel) => {
    panel.add("live", "Live", (sheet) => new LiveTab(app, sheet));
    panel.add("equations", "Equations", (sheet) => new EquationsTab(app, exchange, languageWorkerOf(module), sheet));
  };
}

/**
 * Draws in the picture of the text.
 * @param {App} app
 * @param {Exchange} exchange
 * @param {WebAssembly.Module} module
 * @param {EditorPane} pane
 */
function drawIn(app, exchange, module, pane) {
  const sketch = new Sketch(app, exchange, new Pencil(module));
  sketch.pane = pane;
  app.sketch = sketch;
  const bar = new SketchBar(sketch, byId("stage", HTMLElement));
  byId("empty", HTMLElement).replaceChildren("An empty sheet.");
  sketch.drawBelow = (pen) => drawSheet(pen, sketch);
  sketch.drawOver = (pen) => {
    drawSketch(pen, sketch);
    bar.update();
  };
  return sketch;
}

void startPage(beginPlay);
