// The program that serves this page, used as a worker is: its events come in, messages go back, one after the other.

/** @import {RunHead} from "./format.js" */
/** @import {FromWorker, ToWorker} from "./worker.js" */

/** How long it is waited before a lost program is looked for again, ms. */
const RETRY = 1000;

/**
 * What a program says besides what a worker says: who it is, whether it runs; and that it cannot be heard any more.
 * @typedef {{kind: "hello", run: string, pulls: boolean, about: RunHead}} Hello
 * @typedef {Hello | {kind: "running", isRunning: boolean, speed: number} | {kind: "lost"}} FromProgram
 */

export class Program {
  /**
   * @param {() => EventSource} connect
   * @param {(body: string) => Promise<unknown>} send
   */
  constructor(connect, send) {
    this.connect = connect;
    this.send = send;
    /** @type {((event: MessageEvent<any>) => void) | null} */
    this.onmessage = null;
    /** Heard before somebody listens. @type {(FromWorker | FromProgram)[]} */
    this.heard = [];
    this.isListening = false;
    /** Not sent yet. @type {ToWorker[]} */
    this.waiting = [];
    this.isSending = false;
    this.isClosed = false;
  }

  /** Listens; the first greeting, or null if there is nobody. @returns {Promise<Hello | null>} */
  open() {
    return new Promise((resolve) => {
      const source = this.connect();
      source.onmessage = ({ data }) => {
        const message = readEvent(data);
        if (message.kind === "hello") resolve(message);
        this.tell(message);
      };
      source.onerror = () => {
        source.close();
        resolve(null);
        this.tell({ kind: "lost" });
        if (!this.isClosed) setTimeout(() => void this.open(), RETRY);
      };
      this.source = source;
    });
  }

  /** Nothing is heard any more. */
  close() {
    this.isClosed = true;
    this.source?.close();
  }

  /** @param {FromWorker | FromProgram} message */
  tell(message) {
    if (this.isListening) this.onmessage?.(new MessageEvent("message", { data: message }));
    else this.heard.push(message);
  }

  /** @param {ToWorker} message */
  postMessage(message) {
    if (message.kind === "load") {
      // Whoever listens is being made.
      queueMicrotask(() => {
        this.isListening = true;
        for (const early of this.heard.splice(0)) this.tell(early);
      });
      return;
    }
    // Of a slider that moves faster than messages go its last value counts.
    const last = this.waiting.at(-1);
    if (last !== undefined && isSameDial(last, message)) this.waiting.pop();
    this.waiting.push(message);
    if (!this.isSending) void this.sendAll();
  }

  async sendAll() {
    this.isSending = true;
    for (let message = this.waiting.shift(); message !== undefined; message = this.waiting.shift()) {
      try {
        await this.send(JSON.stringify(message));
      } catch {
        // The stream of events tells that the program is lost; what was meant for it is of no use to the next.
        this.waiting.length = 0;
      }
    }
    this.isSending = false;
  }
}

/** @param {ToWorker} a @param {ToWorker} b */
function isSameDial(a, b) {
  if (a.kind === "parameter" || a.kind === "input") return a.kind === b.kind && a.index === b.index;
  return a.kind === "pull" && a.kind === b.kind;
}

/** An event; JSON has no numbers that are none. @param {string} text @returns {FromWorker | FromProgram} */
function readEvent(text) {
  const message = JSON.parse(text);
  for (const name of ["numbers", "shape"]) {
    const list = message[name];
    if (Array.isArray(list)) message[name] = Float64Array.from(list, (number) => number ?? NaN);
  }
  for (const name of ["parameters", "inputs"]) {
    const list = message[name];
    if (Array.isArray(list)) message[name] = list.map((number) => number ?? NaN);
  }
  return message;
}
