// Results: those in the page itself, and those that are opened or dropped.

import { element } from "./dom.js";
import { inflated } from "./zip.js";

/** @import {App} from "./app.js" */

/**
 * The results that Rust has put into the page; null if there are none.
 * @returns {Uint8Array | null}
 */
export function embeddedResults() {
  return bytesOf("results");
}

/**
 * The module of WebAssembly that Rust has put into the page; null if there is none.
 * @returns {Promise<Uint8Array | null>}
 */
export async function embeddedModule() {
  const packed = bytesOf("module");
  return packed === null ? null : inflated(packed);
}

/** The bytes in an element of the page, which has them as base64. @param {string} id */
function bytesOf(id) {
  const text = document.getElementById(id)?.textContent?.trim() ?? "";
  if (text === "") return null;
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let at = 0; at < letters.length; at++) bytes[at] = letters.charCodeAt(at);
  return bytes;
}

/** @param {App} app */
export function chooseFile(app) {
  const input = element("input", { type: "file", accept: ".npz,.zip" });
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file !== undefined) void loadFile(app, file);
  });
  input.click();
}

/** @param {App} app @param {File} file */
async function loadFile(app, file) {
  try {
    const isShown = await app.load(new Uint8Array(await file.arrayBuffer()));
    if (isShown) showTitle(file.name);
  } catch (error) {
    app.tell("error", `${file.name} cannot be read: ${error instanceof Error ? error.message : error}`);
  }
}

/** @param {string} title */
function showTitle(title) {
  document.title = title;
  const heading = document.querySelector("h1");
  if (heading !== null) heading.textContent = title;
}

/** Files may be dropped anywhere. @param {App} app */
export function listenToDrops(app) {
  const mark = (/** @type {boolean} */ isOver) => document.body.classList.toggle("dropping", isOver);
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    mark(true);
  });
  document.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) mark(false);
  });
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    mark(false);
    const file = event.dataTransfer?.files[0];
    if (file !== undefined) void loadFile(app, file);
  });
}
