// Workers of a page, from texts that the page holds.

import { workerText } from "./worker.js";

/** Starts the worker that runs the mechanism of a live page. */
export function startWorker() {
  return workerOf(workerText());
}

/** A worker with a text of its own. @param {string} text */
export function workerOf(text) {
  const address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  const worker = new Worker(address);
  URL.revokeObjectURL(address);
  return worker;
}
