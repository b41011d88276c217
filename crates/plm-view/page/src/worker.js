// The worker of a live page: a mechanism is stepped in real time, and its rows are posted.
//
// `liveWorker` goes into the worker as text, so that it uses nothing from outside of itself but what goes with it.

import { LiveMachine, instanceOf, writeText } from "./machine.js";

/** @import {CompilerExports} from "./machine.js" */

/**
 * A spring from a point of a body (in its axes) to a target in absolute axes; or a constant force, N.
 * @typedef {{body: number, point: number[], target: number[], stiffness: number, damping: number, force: number[] | null}} Pull
 * A point of a body whose path is asked for: for so many seconds of the run, in no more than `most` ms.
 * @typedef {{body: number, point: number[], duration: number, most: number}} Trace
 * A row of contact, and what it does: `closed`, `slips forwards`.
 * @typedef {{name: string, mode: string}} Contact
 */

/**
 * What is wrong; `gap`: by how much the part stays open where all others are closed, m or rad, not a number where nothing is.
 * @typedef {{time: number, part: string, gap: number, text: string}} Trouble
 */

/**
 * @typedef {{kind: "load", wasm: Uint8Array | null, parameters: number, inputs: number}
 *   | {kind: "declare", module: WebAssembly.Module, text: string} | {kind: "run" | "pause" | "restart" | "reset"}
 *   | {kind: "speed", speed: number} | {kind: "step", dt: number, count: number}
 *   | {kind: "parameter" | "input", index: number, value: number} | {kind: "parameters", values: [number, number][], trace: Trace | null}
 *   | {kind: "pull", pull: Pull | null}
 *   | {kind: "place", body: number, point: number[], target: number[], turn: number}
 *   | {kind: "ahead", duration: number} | {kind: "keep" | "return", id: number}} ToWorker
 * @typedef {{kind: "declared", results: Uint8Array | null, text: string} | {kind: "rows", width: number, numbers: Float64Array}
 *   | {kind: "ahead", width: number, numbers: Float64Array}
 *   | {kind: "returned", numbers: Float64Array, id: number}
 *   | {kind: "began", numbers: Float64Array, isAssembled: boolean}
 *   | {kind: "trouble", trouble: Trouble | null} | {kind: "contacts", contacts: Contact[]} | {kind: "placed"}
 *   | {kind: "dragged", path: number[], stops: number | null} | {kind: "broken", text: string}
 *   | {kind: "settings", parameters: number[], inputs: number[], shape: Float64Array, sizeNames: string}} FromWorker
 */

/**
 * Obeys messages and keeps the time.
 * @param {{onmessage: ((event: MessageEvent<ToWorker>) => void) | null, postMessage: (message: FromWorker) => void}} scope
 */
export function liveWorker(scope) {
  /** Rows are no farther apart, s of the run; and at speeds below 1 none of the screen. */
  const longestStep = 0.01;
  /** One turn computes no longer, ms: messages wait meanwhile. */
  const longestTurn = 40;
  /** @type {WebAssembly.Module | null} */
  let module = null;
  /** What the module makes its mechanism of; null where it holds one. @type {string | null} */
  let declaration = null;
  /** @type {any} */
  let exports = null;
  /** @type {LiveMachine | null} */
  let machine = null;
  let isRunning = false;
  let speed = 1;
  let due = 0;
  let last = 0;

  const turn = () => {
    if (!isRunning || machine === null) return;
    const now = performance.now();
    due += (Math.min(now - last, 100) / 1000) * speed;
    last = now;
    const step = longestStep * Math.min(speed, 1);
    while (due >= step && !machine.isStuck) {
      machine.step(step);
      due -= step;
      // Where the machine is too slow the run is slower, and skips nothing.
      if (performance.now() - now > longestTurn) due = 0;
    }
    if (machine.isStuck) due = 0;
    machine.flush();
    machine.tellContacts();
    setTimeout(() => guarded(turn), 8);
  };
  const guarded = (/** @type {() => unknown} */ act) => {
    try {
      act();
    } catch (error) {
      isRunning = false;
      machine = null;
      scope.postMessage({ kind: "broken", text: error instanceof Error ? error.message : String(error) });
    }
  };

  /** @param {LiveMachine} on @param {ToWorker} message */
  const obey = (on, message) => {
    if (message.kind === "run") {
      if (isRunning) return;
      [isRunning, last, due] = [true, performance.now(), 0];
      on.isStuck &&= !on.isAssembled;
      setTimeout(() => guarded(turn), 0);
    } else if (message.kind === "pause") isRunning = false;
    else if (message.kind === "speed") speed = message.speed;
    else if (message.kind === "restart" || message.kind === "reset") on.begin(message.kind);
    else if (message.kind === "parameter" || message.kind === "input") on.set(message.kind, message.index, message.value);
    else if (message.kind === "parameters") on.setAll(message.values, message.trace);
    else if (message.kind === "pull") on.setPull(message.pull);
    else if (message.kind === "keep") on.keep(message.id);
    else if (message.kind === "return") on.comeBack(message.id);
    else if (message.kind === "place") on.place(message.body, message.point, message.target, message.turn);
    else if (message.kind === "ahead" && module !== null) {
      const other = instanceOf(module);
      if (declaration !== null) compile(other, declaration);
      on.tellAhead(other, message.duration, 2 * longestTurn);
    } else if (message.kind === "step") {
      on.isStuck &&= !on.isAssembled;
      for (let left = message.count; left > 0; left--) on.step(message.dt);
      on.flush();
      on.tellContacts();
    }
  };

  /** Makes a mechanism of a text; whether it is one. @param {CompilerExports} of @param {string} text */
  const compile = (of, text) => {
    writeText(of, text);
    return of.plm_compile() === 1;
  };
  /** @param {CompilerExports} of @param {string} text */
  const declare = (of, text) => {
    [exports, declaration] = [of, text];
    const isGood = compile(of, text);
    const [place, length] = isGood ? [of.plm_results(), of.plm_results_length()] : [of.plm_message(), of.plm_text_length()];
    const bytes = new Uint8Array(of.memory.buffer, place, length).slice();
    scope.postMessage({ kind: "declared", results: isGood ? bytes : null, text: isGood ? "" : new TextDecoder().decode(bytes) });
  };

  /** What came before the module was there. @type {ToWorker[]} */
  const waiting = [];
  /** @param {{parameters: number, inputs: number}} counts */
  const begin = (counts) => {
    const on = new LiveMachine(exports, counts, (message) => scope.postMessage(message));
    machine = on;
    on.begin("restart");
    for (const message of waiting.splice(0)) obey(on, message);
  };
  /** Its instance, then what is to be done with it. @param {BufferSource | WebAssembly.Module} source @param {(of: any) => void} then */
  const load = (source, then) => {
    const compiled = source instanceof WebAssembly.Module ? Promise.resolve(source) : WebAssembly.compile(source);
    compiled.then(
      (found) =>
        guarded(() => {
          module = found;
          then(instanceOf(found));
        }),
      (/** @type {unknown} */ error) => guarded(() => { throw error; }),
    );
  };
  scope.onmessage = ({ data }) => {
    const on = machine;
    if (data.kind === "declare") load(data.module, (of) => declare(of, data.text));
    else if (data.kind === "load" && data.wasm === null) guarded(() => begin(data));
    else if (data.kind === "load") {
      load(/** @type {Uint8Array<ArrayBuffer>} */ (data.wasm), (of) => {
        exports = of;
        begin(data);
      });
    } else if (on === null) waiting.push(data);
    else guarded(() => obey(on, data));
  };
}

/** The text of the worker. */
export function workerText() {
  // By name, whatever a bundler makes of a class at the top.
  return `${writeText}\n${instanceOf}\nconst LiveMachine = ${LiveMachine};\n${liveWorker}\nliveWorker(self);\n`;
}
