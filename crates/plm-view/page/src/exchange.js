// One mechanism in the place of another: the last good text is what moves.

import { Live } from "./live.js";
import { LivePanel } from "./livepanel.js";
import { readResults } from "./results.js";

/** @import {App} from "./app.js" */
/** @import {FromWorker} from "./worker.js" */

/** A text that takes longer to become a mechanism, ms, is given up. */
const LONGEST_COMPILATION = 10_000;

/**
 * @typedef {{onmessage: ((event: MessageEvent<any>) => void) | null, postMessage: (message: any) => void, terminate: () => void}} Carrier
 */

export class Exchange {
  /**
   * @param {App} app
   * @param {WebAssembly.Module} module
   * @param {() => Carrier} start starts a worker
   */
  constructor(app, module, start) {
    this.app = app;
    this.module = module;
    this.start = start;
    /** The worker whose text is compiled. @type {Carrier | null} */
    this.candidate = null;
    /** A worker that waits for a text, so that none waits for a worker. @type {Carrier | null} */
    this.spare = null;
    /** The worker of what is shown. @type {Carrier | null} */
    this.shown = null;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    /** How many mechanisms have been shown. */
    this.count = 0;
    /** Why the last text is no mechanism; empty where it is one. */
    this.why = "";
  }

  /**
   * Makes a mechanism of a text, and shows it where it is one; a text before that is not done is given up.
   * @param {string} text
   * @returns {Promise<boolean | null>} whether it is shown; null where another text came between
   */
  declare(text) {
    this.drop();
    const candidate = this.spare ?? this.start();
    this.spare = null;
    this.candidate = candidate;
    return new Promise((resolve) => {
      const end = (/** @type {boolean | null} */ is) => {
        if (this.candidate === candidate) {
          clearTimeout(this.timer);
          this.candidate = null;
        }
        if (is !== true) candidate.terminate();
        this.spare ??= this.start();
        resolve(is);
      };
      const refuse = (/** @type {string} */ why) => {
        this.why = why;
        end(false);
      };
      this.timer = setTimeout(() => refuse(`it takes longer than ${LONGEST_COMPILATION / 1000} s`), LONGEST_COMPILATION);
      candidate.onmessage = async (/** @type {MessageEvent<FromWorker>} */ { data }) => {
        if (this.candidate !== candidate) end(null);
        else if (data.kind === "declared" && data.results !== null && data.results.length > 0) {
          const { runs } = await readResults(data.results);
          if (this.candidate !== candidate) end(null);
          else {
            this.why = "";
            end(true);
            this.show(runs[0].head, candidate);
          }
        } else refuse("text" in data ? data.text : "");
      };
      candidate.postMessage({ kind: "declare", module: this.module, text });
    });
  }

  /** The text that is being compiled is not wanted any more. */
  drop() {
    clearTimeout(this.timer);
    const { candidate } = this;
    this.candidate = null;
    candidate?.onmessage?.(new MessageEvent("message", { data: { kind: "broken", text: "" } }));
  }

  /** @param {import("./format.js").RunHead} head @param {Carrier} worker */
  show(head, worker) {
    const { app } = this;
    const before = app.live;
    this.shown?.terminate();
    this.shown = worker;
    app.messages = [];
    const live = new Live(app, head, null, worker);
    app.live = live;
    // What dragging does is that of the machine, unless somebody has chosen otherwise.
    if (before !== null && app.mode === before.usualMode) app.mode = live.usualMode;
    app.replaceRuns([live.run]);
    if (before !== null) keepSettings(before, live);
    // A view that somebody has chosen stays as long as it is the same mechanism.
    if (before?.mechanism.name !== head.mechanism.name || before.followCamera.chosen !== null) live.followCamera.choose();
    this.count += 1;
    const goesOn = before?.isRunning ?? !matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (goesOn) live.start();
    document.title = head.mechanism.name;
    document.querySelector("h1")?.replaceChildren(head.mechanism.name);
    app.change();
  }
}

/** What was turned by hand stays so, where the text has not changed it. @param {Live} before @param {Live} live */
function keepSettings(before, live) {
  for (const kind of /** @type {const} */ (["parameter", "input"])) {
    const [old, now] = [before, live].map(({ mechanism }) => (kind === "parameter" ? mechanism.parameters : mechanism.inputs));
    now.forEach(({ name, default: usual }, index) => {
      const at = old.findIndex((each) => each.name === name && each.default === usual);
      const value = before.settings[kind][at];
      if (at >= 0 && value !== undefined && value !== usual) live.set(kind, index, value);
    });
  }
}

/** The tab of the mechanism that is shown. */
export class LiveTab {
  /** @param {App} app @param {HTMLElement} sheet */
  constructor(app, sheet) {
    this.app = app;
    this.sheet = sheet;
    /** @type {Live | null} */
    this.of = null;
    /** @type {LivePanel | null} */
    this.panel = null;
  }

  update() {
    const { live } = this.app;
    if (live !== this.of && live !== null) {
      this.of = live;
      this.sheet.replaceChildren();
      this.panel = new LivePanel(this.app, live, this.sheet);
    }
    this.panel?.update();
  }
}
