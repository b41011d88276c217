// One mechanism in the place of another: the last good text is what moves.

import { element } from "./dom.js";
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
    /** Whether one waits: a text that is typed will be followed by others. */
    this.keepsSpare = true;
    /** The worker of what is shown. @type {Carrier | null} */
    this.shown = null;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    /** The text of what is shown; null where nothing is. @type {string | null} */
    this.text = null;
    /** How many mechanisms have been shown. */
    this.count = 0;
    /** Why the last text is no mechanism; empty where it is one. */
    this.why = "";
    /** Hears the name of what is shown; null where nothing is. @type {(name: string | null) => void} */
    this.named = () => {};
    /** Whether the first mechanism begins to move. */
    this.begins = () => !matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  /**
   * Makes a mechanism of a text, and shows it where it is one; a text before that is not done is given up.
   * @param {string} text
   * @param {boolean} [isLifted] whether numbers of it are parameters while a hand holds them
   * @returns {Promise<boolean | null>} whether it is shown; null where another text came between
   */
  declare(text, isLifted = false) {
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
        if (this.keepsSpare) this.spare ??= this.start();
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
            this.text = text;
            end(true);
            this.show(runs[0].head, candidate, isLifted);
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

  /** Nothing is shown any more: a sheet on which nothing is. */
  clear() {
    const { app } = this;
    this.drop();
    this.text = null;
    app.live?.pause();
    app.live = null;
    app.runViews = [];
    app.selected = null;
    app.messages = [];
    this.named(null);
    app.change();
  }

  /** Nothing of it runs any more. */
  end() {
    this.clear();
    for (const worker of [this.shown, this.spare]) worker?.terminate();
    this.shown = this.spare = null;
  }

  /** @param {import("./format.js").RunHead} head @param {Carrier} worker @param {boolean} isLifted */
  show(head, worker, isLifted) {
    const { app } = this;
    const before = app.live;
    const keepLook = lookOf(app);
    this.shown?.terminate();
    this.shown = worker;
    app.messages = [];
    const live = new Live(app, head, null, worker);
    live.isLifted = isLifted;
    app.live = live;
    // What dragging does is that of the machine, unless somebody has chosen otherwise.
    if (before !== null && app.mode === before.usualMode) app.mode = live.usualMode;
    app.replaceRuns([live.run]);
    keepLook();
    if (before !== null) keepSettings(before, live);
    // A view that somebody has chosen stays as long as it is the same mechanism.
    if (before?.mechanism.name !== head.mechanism.name || before.followCamera.chosen !== null) live.followCamera.choose();
    this.count += 1;
    // Who draws stands at the start.
    const goesOn = app.mode !== "draw" && (before?.isRunning ?? this.begins());
    if (goesOn) live.start();
    this.named(head.mechanism.name);
    app.change();
  }
}

/**
 * What is selected and which paths are drawn stays over an exchange, where there still is what has these names; gives what does that.
 * @param {App} app
 */
function lookOf(app) {
  const { selected, traces, run } = app;
  const isChosen = traces.join() !== app.usualTraces.join();
  const list = (/** @type {import("./format.js").Mechanism} */ { bodies, parts, ground }) => ({ body: bodies, part: parts, port: ground });
  const name = selected === null || run === null ? null : list(run.mechanism)[selected.kind][selected.index]?.name;
  return () => {
    const { mechanism } = /** @type {import("./run.js").Run} */ (app.run);
    const index = selected === null ? -1 : list(mechanism)[selected.kind].findIndex((each) => each.name === name);
    if (selected !== null && index >= 0) app.selected = { kind: selected.kind, index };
    const bodies = new Set(mechanism.bodies.map((body) => body.name));
    const kept = traces.filter((each) => bodies.has(each.split(".")[0]));
    if (kept.length > 0 && (isChosen || app.mode === "draw")) app.traces = kept;
  };
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
    // While a hand holds numbers the page shows those of the text.
    if (live === null && this.of !== null) {
      [this.of, this.panel] = [null, null];
      this.sheet.replaceChildren(element("p", { class: "hint" }, "Nothing moves yet."));
    }
    if (live !== this.of && live !== null && !live.isLifted) {
      this.of = live;
      this.sheet.replaceChildren();
      this.panel = new LivePanel(this.app, live, this.sheet);
    }
    this.panel?.update();
  }
}
