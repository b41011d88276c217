// The worker that runs the mechanism of a live page, from a text that the page holds.

import { workerText } from "./worker.js";

/** Starts the worker. */
export function startWorker() {
  const address = URL.createObjectURL(new Blob([workerText()], { type: "text/javascript" }));
  const worker = new Worker(address);
  URL.revokeObjectURL(address);
  return worker;
}
