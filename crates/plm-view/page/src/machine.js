// The mechanism of a module of WebAssembly: steps, settings, pulls, and states that are kept.
//
// `LiveMachine`, `instanceOf` and `writeText` go into workers as text, so that they use nothing from outside of themselves.

/** @import {FromWorker, Pull, Trace, Trouble} from "./worker.js" */

/**
 * What a module exports: `crates/plm-view/src/live/shim.rs`.
 * @typedef {{memory: WebAssembly.Memory, plm_restart: () => number, plm_reset: () => number, plm_step: (dt: number) => number,
 *   plm_read: () => number, plm_length: () => number, plm_shape: () => number, plm_shape_length: () => number,
 *   plm_parameter: (index: number) => number, plm_set_parameter: (index: number, value: number) => void,
 *   plm_input: (index: number) => number, plm_set_input: (index: number, value: number) => void,
 *   plm_pull: (body: number, x: number, y: number, fx: number, fy: number) => void,
 *   plm_place: (body: number, x: number, y: number, angle: number) => number,
 *   plm_trouble: () => number, plm_size_names: () => number, plm_contacts: () => number, plm_text_length: () => number}} LiveExports
 * A module that makes a mechanism of a text, too: `examples/playground/src/lib.rs`.
 * @typedef {LiveExports & {plm_room: (length: number) => number, plm_compile: () => number, plm_message: () => number,
 *   plm_results: () => number, plm_results_length: () => number}} CompilerExports
 */

/**
 * What an instance of a module exports. A module may have functions of its own made while it runs: it writes a module of WebAssembly,
 * whose function `run` gets a place in its table (`crates/plm-jit/src/page.rs`).
 * @param {WebAssembly.Module} module
 * @returns {any}
 */
export function instanceOf(module) {
  /** @type {any} */
  let own = null;
  const translated = (/** @type {number} */ begin, /** @type {number} */ length) => {
    const { memory, __indirect_function_table: table } = own;
    try {
      const made = new WebAssembly.Module(new Uint8Array(memory.buffer, begin, length));
      const { run } = new WebAssembly.Instance(made, { plm: { memory, table } }).exports;
      const place = table.grow(1);
      table.set(place, run);
      return place;
    } catch {
      // It goes by steps, as before.
      return 0;
    }
  };
  own = new WebAssembly.Instance(module, { plm: { plm_translated: translated } }).exports;
  return own;
}

/**
 * Puts a text into the room of a module.
 * @param {{memory: WebAssembly.Memory, plm_room: (length: number) => number}} exports
 * @param {string} text
 */
export function writeText(exports, text) {
  const bytes = new TextEncoder().encode(text);
  const room = exports.plm_room(bytes.length);
  new Uint8Array(exports.memory.buffer, room, bytes.length).set(bytes);
}

/**
 * All of a module's memory that is not 0, with what the machine knows besides.
 * @typedef {{blocks: [number, Uint8Array][], inputs: Map<number, number>, isAssembled: boolean, isStuck: boolean}} KeptState
 */

export class LiveMachine {
  /**
   * @param {LiveExports} exports
   * @param {{parameters: number, inputs: number}} counts
   * @param {(message: FromWorker) => void} post
   */
  constructor(exports, counts, post) {
    this.exports = exports;
    this.counts = counts;
    this.post = post;
    /** Inputs that were set by hand: they outlive a start that failed. @type {Map<number, number>} */
    this.inputs = new Map();
    /** @type {Pull | null} */
    this.pull = null;
    /** Rows that are not posted yet. @type {Float64Array[]} */
    this.rows = [];
    this.now = new Float64Array(0);
    this.isAssembled = false;
    /** It cannot go on until something is changed. */
    this.isStuck = false;
    this.told = "null";
    this.toldContacts = "";
    /** @type {Map<number, KeptState>} */
    this.kept = new Map();
  }

  read() {
    const { exports } = this;
    // The memory may grow while it is read.
    const [place, length] = [exports.plm_read(), exports.plm_length()];
    this.now = new Float64Array(exports.memory.buffer, place, length).slice();
    return this.now;
  }

  /** Posts a message after the rows that came before. @param {FromWorker} message */
  send(message) {
    this.flush();
    this.post(message);
  }

  flush() {
    if (this.rows.length === 0) return;
    const width = this.rows[0].length;
    const numbers = new Float64Array(width * this.rows.length);
    this.rows.forEach((row, at) => numbers.set(row, at * width));
    this.rows = [];
    this.post({ kind: "rows", width, numbers });
  }

  /** A text that the module keeps. @param {() => number} ask gives its place */
  text(ask) {
    const [place, length] = [ask(), this.exports.plm_text_length()];
    return new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, place, length));
  }

  /** @returns {Trouble | null} */
  trouble() {
    const words = this.text(this.exports.plm_trouble);
    if (words === "") return null;
    const [time, part, gap, ...text] = words.split("\n");
    return { time: Number(time), part, gap: Number(gap), text: text.join("\n") };
  }

  /** Tells what is wrong, or that nothing is any more. */
  tellTrouble() {
    const trouble = this.trouble();
    const words = JSON.stringify(trouble);
    if (words === this.told) return;
    this.told = words;
    this.send({ kind: "trouble", trouble });
  }

  /** Tells what the rows of contact do, where that has changed. */
  tellContacts() {
    const lines = this.text(this.exports.plm_contacts);
    if (lines === this.toldContacts) return;
    this.toldContacts = lines;
    const contacts = lines === "" ? [] : lines.split("\n").map((line) => line.split("\t"));
    this.send({ kind: "contacts", contacts: contacts.map(([mode, name]) => ({ name, mode })) });
  }

  tellSettings() {
    const { exports, counts } = this;
    const parameters = Array.from({ length: counts.parameters }, (_, index) => exports.plm_parameter(index));
    const inputs = Array.from({ length: counts.inputs }, (_, index) => exports.plm_input(index));
    const [place, length] = [exports.plm_shape(), exports.plm_shape_length()];
    const shape = new Float64Array(exports.memory.buffer, place, length).slice();
    this.send({ kind: "settings", parameters, inputs, shape, sizeNames: this.text(exports.plm_size_names) });
  }

  /** @param {"restart" | "reset"} how */
  begin(how) {
    const { exports } = this;
    if (how === "reset") this.inputs.clear();
    this.isAssembled = (how === "reset" ? exports.plm_reset() : exports.plm_restart()) === 1;
    for (const [index, value] of this.inputs) exports.plm_set_input(index, value);
    this.tellBegun();
  }

  tellBegun() {
    this.isStuck = !this.isAssembled;
    this.send({ kind: "began", numbers: this.read(), isAssembled: this.isAssembled });
    this.tellTrouble();
    this.tellContacts();
    this.tellSettings();
  }

  /**
   * Keeps the state as it is: memory between two calls of a module is all that it has.
   * @param {number} id
   */
  keep(id) {
    const size = 1024;
    const memory = new Uint8Array(this.exports.memory.buffer);
    /** @type {KeptState} */
    const state = { blocks: [], inputs: new Map(this.inputs), isAssembled: this.isAssembled, isStuck: this.isStuck };
    for (let at = 0; at < memory.length; at += size) {
      const block = memory.subarray(at, at + size);
      if (block.some((byte) => byte !== 0)) state.blocks.push([at, block.slice()]);
    }
    this.kept.delete(id);
    this.kept.set(id, state);
    // The oldest are forgotten, as the page has forgotten them.
    for (const old of this.kept.keys()) if (this.kept.size > 200) this.kept.delete(old);
  }

  /** @param {number} id of a state that is kept */
  comeBack(id) {
    const state = this.kept.get(id);
    if (state === undefined) return;
    const memory = new Uint8Array(this.exports.memory.buffer).fill(0);
    for (const [at, block] of state.blocks) memory.set(block, at);
    [this.inputs, this.isAssembled, this.isStuck, this.pull] = [new Map(state.inputs), state.isAssembled, state.isStuck, null];
    this.send({ kind: "returned", numbers: this.read(), id });
    this.tellTrouble();
    this.tellContacts();
    this.tellSettings();
  }

  /** @param {"parameter" | "input"} kind @param {number} index @param {number} value SI */
  set(kind, index, value) {
    const { exports } = this;
    if (kind === "input") {
      this.inputs.set(index, value);
      exports.plm_set_input(index, value);
    } else {
      exports.plm_set_parameter(index, value);
    }
    this.isStuck = false;
    // At the start a parameter acts on the assembly at once.
    if (kind === "parameter" && (!this.isAssembled || this.now[0] === 0)) this.begin("restart");
    else {
      this.tellSettings();
      // Whether it can be assembled so is known at once.
      if (kind === "parameter") this.tellTrouble();
    }
  }

  /**
   * Sets parameters together, and begins once; the path that a point will have comes with the answer.
   * @param {[number, number][]} values by index, SI
   * @param {Trace | null} trace
   */
  setAll(values, trace) {
    for (const [index, value] of values) this.exports.plm_set_parameter(index, value);
    const { path, stops } = trace === null ? { path: [], stops: null } : this.pathOf(trace);
    this.begin("restart");
    this.send({ kind: "dragged", path, stops });
  }

  /** The path of a point from the start on, x and y in turn, and when the run ends early. @param {Trace} trace */
  pathOf({ body, point, duration, most }) {
    /** @type {number[]} */
    const path = [];
    const began = performance.now();
    let goesOn = true;
    if (this.exports.plm_restart() !== 1) return { path, stops: null };
    for (const [index, value] of this.inputs) this.exports.plm_set_input(index, value);
    do {
      this.read();
      const { x, y } = this.pointOf(body, point);
      path.push(x, y);
      if (this.now[0] >= duration || performance.now() - began >= most) break;
      goesOn = this.exports.plm_step(0.01) === 1;
    } while (goesOn);
    return { path, stops: goesOn ? null : this.now[0] };
  }

  /**
   * What another instance of the module does from the start on, with the settings of this one: rows for so many seconds, or for as
   * many as it computes in `most` ms.
   * @param {LiveExports} other
   * @param {number} duration s
   * @param {number} most
   */
  tellAhead(other, duration, most) {
    for (let index = 0; index < this.counts.parameters; index++) other.plm_set_parameter(index, this.exports.plm_parameter(index));
    const began = performance.now();
    if (other.plm_restart() !== 1) return;
    for (const [index, value] of this.inputs) other.plm_set_input(index, value);
    const ahead = new LiveMachine(other, this.counts, this.post);
    const numbers = [...ahead.read()];
    const width = numbers.length;
    for (let time = 0; time < duration && performance.now() - began < most && other.plm_step(0.01) === 1; time += 0.01) {
      numbers.push(...ahead.read());
    }
    this.send({ kind: "ahead", width, numbers: new Float64Array(numbers) });
  }

  /** Goes on by `dt`, s. @param {number} dt */
  step(dt) {
    if (this.isStuck) return;
    this.applyPull();
    if (this.exports.plm_step(dt) === 1) this.rows.push(this.read());
    else this.isStuck = true;
    if (this.isStuck || this.told !== "null") this.tellTrouble();
  }

  /** A point of a body now, and its velocity, in absolute axes. @param {number} body @param {number[]} point */
  pointOf(body, [u, v]) {
    const [x, y, angle, vx, vy, omega] = this.now.subarray(1 + 6 * body, 7 + 6 * body);
    const [dx, dy] = [Math.cos(angle) * u - Math.sin(angle) * v, Math.sin(angle) * u + Math.cos(angle) * v];
    return { x: x + dx, y: y + dy, vx: vx - omega * dy, vy: vy + omega * dx };
  }

  /** The turn that moves the end of an arm by the part of a distance that is across the arm, rad. @param {number[]} arm @param {number[]} by */
  turnTo([u, v], [dx, dy]) {
    const square = u * u + v * v;
    return square > 0 ? (u * dy - v * dx) / square : 0;
  }

  applyPull() {
    if (this.pull === null) return;
    const { body, point, target, stiffness, damping, force } = this.pull;
    const { x, y, vx, vy } = this.pointOf(body, point);
    const [fx, fy] = force ?? [stiffness * (target[0] - x) - damping * vx, stiffness * (target[1] - y) - damping * vy];
    this.exports.plm_pull(body, x, y, fx, fy);
  }

  /** @param {Pull | null} pull */
  setPull(pull) {
    const before = this.pull?.body;
    if (before !== undefined && before !== pull?.body) this.exports.plm_pull(before, 0, 0, 0, 0);
    this.pull = pull;
    this.isStuck &&= !this.isAssembled;
  }

  /**
   * Places a body so that a point of it comes near a target, or turns it. All bodies give way when joints close, so that it
   * comes a part of the way: the next trial asks for as much more as the last one fell short. Where a shift of its centre of gravity
   * is taken back, as that of a link which is pinned there, it is turned about it.
   * @param {number} body
   * @param {number[]} point
   * @param {number[]} target
   * @param {number} turn rad; if it is not 0, the target does not count
   */
  place(body, point, target, turn) {
    const goal = this.now[3 + 6 * body] + turn;
    let [gain, turns] = [1, false];
    for (let left = 12; left > 0; left--) {
      const { x, y } = this.pointOf(body, point);
      const [gx, gy, angle] = this.now.subarray(1 + 6 * body, 4 + 6 * body);
      const rest = turn === 0 ? [target[0] - x, target[1] - y, 0] : [0, 0, goal - angle];
      if (Math.hypot(...rest) < 1e-9) break;
      const ask = turns ? [0, 0, this.turnTo([x - gx, y - gy], rest)] : rest;
      if (this.exports.plm_place(body, gx + gain * ask[0], gy + gain * ask[1], angle + gain * ask[2]) !== 1) {
        if (gain === 1) break;
        gain = Math.max(1, gain / 4);
        continue;
      }
      this.read();
      const after = this.pointOf(body, point);
      const moved = turn === 0 ? [after.x - x, after.y - y, 0] : [0, 0, this.now[3 + 6 * body] - angle];
      const along = moved.reduce((sum, part, at) => sum + part * rest[at], 0);
      // It goes no farther that way.
      if (along < 1e-6 * Math.hypot(...rest) ** 2) {
        if (turn !== 0 || turns) break;
        [gain, turns] = [1, true];
        continue;
      }
      gain = Math.min(Math.max((gain * along) / Math.hypot(...moved) ** 2, 1), 30);
    }
    this.tellBegun();
    this.send({ kind: "placed" });
  }
}
