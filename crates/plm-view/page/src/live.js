// The mechanism itself in the page: it runs in a worker, and what it computes becomes the rows of a run.
//
// A live source adds a `Run` by `app.addRun`, appends rows, calls `app.rowsAppended`, and adds its tab by `panel.add`.

import { lengthText } from "./fault.js";
import { FollowCamera } from "./followcamera.js";
import { KeptStates } from "./keptstates.js";
import { Run } from "./run.js";
import { BAR, Scene } from "./scene.js";
import { readShape } from "./shape.js";
import { startWorker } from "./startworker.js";

/** @import {App, Mode} from "./app.js" */
/** @import {RunHead} from "./format.js" */
/** @import {Contact, FromWorker, Pull, ToWorker} from "./worker.js" */

/** Without a recording so much is kept, s. */
export const LIVE_WINDOW = 20;
/** So far, s, it is looked ahead before the view is chosen. */
const LOOK_AHEAD = 6;
/** How often a pulled body swings at most, rad/s: a force that is renewed every 10 ms follows it well. */
const FASTEST_SWING = 40;
/** Damping of a pull, as a share of the critical one. */
const PULL_DAMPING = 0.5;

export class Live {
  /**
   * @param {App} app
   * @param {RunHead} head of a run with all observed quantities
   * @param {Uint8Array | null} wasm null where the worker has the mechanism
   * @param {Pick<Worker, "postMessage"> & {onmessage: unknown}} [worker]
   */
  constructor(app, head, wasm, worker = startWorker()) {
    this.app = app;
    this.run = Run.empty(liveHead(head));
    this.run.isLive = true;
    this.isRunning = false;
    this.isAssembled = false;
    this.isBroken = false;
    /** Whether numbers of its text are parameters while a hand holds them. */
    this.isLifted = false;
    /** Whether it runs in this page, and nowhere else. */
    this.isInPage = true;
    /** Why nothing is heard of it, in words. */
    this.gone = "";
    /** What can be done with its bodies. @type {string[]} */
    this.modes = ["pull", "place"];
    /** When the recording began, s; null while nothing is recorded. @type {number | null} */
    this.recordsFrom = null;
    /** @type {Run[]} */
    this.recordings = [];
    /** As set, SI. @type {{parameter: number[], input: number[]}} */
    this.settings = { parameter: [], input: [] };
    this.speed = 1;
    this.followCamera = new FollowCamera(app);
    /** The settings with which it was looked ahead. */
    this.lookedFor = "";
    /** The parameter that was turned last, and its value: what is open then is due to it. */
    this.turned = "";
    /** @type {Pull | null} */
    this.pulled = null;
    this.states = new KeptStates(this);
    /** What is wrong with its start; null where nothing is. @type {import("./worker.js").Trouble | null} */
    this.trouble = null;
    /** Hears the path of a point once parameters are set together, and when it ends early. @type {(path: number[], stops: number | null) => void} */
    this.whenDragged = () => {};
    /** What it has opened, in words. */
    this.opened = "";
    /** Rises with the settings. */
    this.revision = 0;
    /** Rows of contact at the last row. @type {Contact[]} */
    this.contacts = [];
    /** A placement that the worker has not answered, and the one to be asked for then. */
    this.placing = { isAsked: false, next: /** @type {ToWorker | null} */ (null) };
    this.worker = worker;
    worker.onmessage = (/** @type {MessageEvent<FromWorker>} */ { data }) => this.hear(data);
    const { parameters, inputs } = this.run.mechanism;
    this.send({ kind: "load", wasm, parameters: parameters.length, inputs: inputs.length });
  }

  /** Why no force moves anything, in words; empty where one does. */
  get unmoved() {
    const isDriven = this.mechanism.report?.formulation === "kinematics";
    return isDriven ? "Nothing to pull: the motion is prescribed, and no freedom is left that a force could move." : "";
  }

  /** What dragging does at first. @returns {Mode} */
  get usualMode() {
    return this.modes.includes("pull") && this.unmoved === "" ? "pull" : "pan";
  }

  /** @param {ToWorker} message */
  send(message) {
    this.worker.postMessage(message);
  }

  get mechanism() {
    return this.run.mechanism;
  }

  /** Whether it is on the screen. */
  get isShown() {
    return this.app.runViews.some(({ run }) => run === this.run);
  }

  /** Its run among the others, and on the screen. */
  show() {
    if (!this.isShown) this.app.addRun(this.run);
    this.app.activate(this.app.runViews.findIndex(({ run }) => run === this.run));
  }

  /** Brought up to date in every frame. */
  update() {
    const { player } = this.app;
    if (this.speed !== player.speed) {
      this.speed = player.speed;
      this.send({ kind: "speed", speed: this.speed });
    }
    if (this.isRunning && !this.isShown) this.unseen();
    if (this.app.run === this.run) this.followCamera.update();
    player.pace = this.isRunning && this.app.run === this.run && this.run.fault === null ? this.speed : null;
  }

  /** Nobody looks at it. */
  unseen() {
    this.pause();
  }

  start() {
    if (this.isBroken) return;
    this.show();
    this.app.player.stop();
    this.app.player.isFollowing = true;
    this.ask(true);
    this.send({ kind: "run" });
    this.app.change();
  }

  pause() {
    this.ask(false);
    this.send({ kind: "pause" });
    this.app.change();
  }

  /** A mechanism of the page's own does as it is asked. @param {boolean} isRunning */
  ask(isRunning) {
    this.isRunning = isRunning;
  }

  /** So many steps, one after the other. @param {number} dt s @param {number} [count] */
  step(dt, count = 1) {
    this.pause();
    this.app.player.isFollowing = true;
    this.send({ kind: "step", dt, count });
  }

  /** Begins again with the parameters as they are. */
  restart() {
    this.app.history.keepState("restart");
    this.show();
    this.send({ kind: "restart" });
  }

  /** Begins again as declared. */
  reset() {
    this.app.history.keepState("reset");
    this.show();
    this.send({ kind: "reset" });
  }

  /** @param {"parameter" | "input"} kind @param {number} index @param {number} value SI */
  set(kind, index, value) {
    const before = this.settings[kind][index];
    if (!Number.isFinite(value) || value === before) return;
    this.settings[kind][index] = value;
    this.send({ kind, index, value });
    const list = kind === "parameter" ? this.mechanism.parameters : this.mechanism.inputs;
    const { name, factor, unit } = list[index];
    const shown = `${Number((value / factor).toPrecision(6))} ${unit}`.trim();
    if (kind === "parameter") this.turned = `${name} ${shown}`;
    if (Number.isFinite(before)) this.app.history.add({ kind: "set", name: `${name} = ${shown}`, of: kind, index, from: before, to: value });
    this.note(name, `${name} = ${shown}`);
  }

  /** An event; turning one thing for a while is one. @param {string} name @param {string} what */
  note(name, what) {
    const { events, end } = this.run;
    if (this.run.rows < 2) return;
    const last = events.at(-1);
    if (last !== undefined && last.what.startsWith(`${name} = `) && end - last.time < 1) events.pop();
    events.push({ time: end, what, row: null });
  }

  /** @param {Pull | null} pull */
  pull(pull) {
    if (pull !== null && this.pulled === null) this.app.history.keepState(`pull ${this.mechanism.bodies[pull.body].name}`);
    this.pulled = pull;
    this.send({ kind: "pull", pull });
  }

  /**
   * @param {number} body
   * @param {number[]} point in its axes
   * @param {number[]} target of the point, absolute axes
   * @param {number} [turn] rad
   */
  place(body, point, target, turn = 0) {
    if (this.isRunning) this.pause();
    this.app.history.keepState(`place ${this.mechanism.bodies[body].name}`);
    /** @type {ToWorker} */
    const wanted = { kind: "place", body, point, target, turn };
    // Of many that come while one is worked out the last alone counts.
    if (this.placing.isAsked) this.placing.next = wanted;
    else this.send(wanted);
    this.placing.isAsked = true;
  }

  /**
   * A spring that holds the whole weight when it is as long as a quarter of the mechanism; softer where it would shake a
   * light body.
   * @param {number} body
   * @param {number[]} point
   */
  stiffness(body, [u, v]) {
    const { bodies } = this.mechanism;
    const total = bodies.reduce((sum, { mass }) => sum + (mass || 0), 0);
    const { mass, inertia } = bodies[body];
    const felt = Math.max(1 / (1 / mass + (u * u + v * v) / inertia) || 0, 0.01 * total);
    const stiffness = Math.min((4 * 9.81 * total) / this.size(), felt * FASTEST_SWING ** 2);
    return { stiffness, damping: 2 * PULL_DAMPING * Math.sqrt(stiffness * felt) };
  }

  /** The usual size of its bodies, m. */
  size() {
    const shown = this.app.runViews.find(({ run }) => run === this.run);
    return shown === undefined ? 1 : shown.scene.radius / BAR;
  }

  record() {
    if (this.recordsFrom === null) this.recordsFrom = this.run.end;
    else this.stopRecording();
    this.app.change();
  }

  /** What was recorded becomes a run of its own. */
  stopRecording() {
    const { run, recordsFrom: from } = this;
    this.recordsFrom = null;
    if (from === null || run.rows === 0) return;
    const copy = run.since(from, `recording ${this.recordings.length + 1}`);
    if (copy.rows < 2) return;
    this.recordings.push(copy);
    this.app.addRun(copy);
  }

  /** What is exported: the recordings, one that still goes on too; without any, what is kept. */
  kept() {
    const { run, recordsFrom } = this;
    if (recordsFrom !== null) return [...this.recordings, run.since(recordsFrom, `recording ${this.recordings.length + 1}`)];
    return this.recordings.length > 0 ? this.recordings : [run];
  }

  /** @param {FromWorker} message */
  hear(message) {
    if (message.kind === "rows") {
      for (let at = 0; at < message.numbers.length; at += message.width) this.append(message.numbers.subarray(at, at + message.width));
      this.trim();
      this.app.rowsAppended(this.run);
    } else if (message.kind === "ahead") this.seeAhead(message.numbers, message.width);
    else if (message.kind === "returned") this.states.arrive(message.numbers, message.id);
    else if (message.kind === "began") this.begin(message.numbers, message.isAssembled);
    else if (message.kind === "settings") this.take(message);
    else if (message.kind === "contacts") this.contacts = message.contacts;
    else if (message.kind === "trouble") {
      const { trouble } = message;
      this.trouble = trouble;
      this.run.fault = trouble === null ? null : { time: trouble.time, part: trouble.part, text: trouble.text };
      this.opened = this.openText(trouble);
      this.app.tellFault();
      this.app.change();
    } else if (message.kind === "dragged") this.whenDragged(message.path, message.stops);
    else if (message.kind === "placed") {
      const { next } = this.placing;
      this.placing = { isAsked: next !== null, next: null };
      if (next !== null) this.send(next);
    } else if (message.kind === "broken") this.breakDown(`The module has stopped: ${message.text}. Load the page anew.`);
  }

  /**
   * What a parameter has opened, as `rod_length 80 mm: small_end is 20 mm open`; nothing where it is something else.
   * @param {import("./worker.js").Trouble | null} trouble
   */
  openText(trouble) {
    if (trouble === null || this.turned === "" || !Number.isFinite(trouble.gap)) return "";
    // A pin is open by a length; what else is, the cause says in its words.
    const isPin = this.mechanism.parts.some(({ name, pair }) => name === trouble.part && pair === "revolute");
    return isPin ? `${this.turned}: ${trouble.part} is ${lengthText(trouble.gap)} open` : "";
  }

  /** @param {string} text */
  breakDown(text) {
    this.isBroken = true;
    this.pause();
    this.app.tell("error", text);
  }

  /** Asks what it will do: the view and the path are chosen by that. */
  lookAhead() {
    const { parameters, inputs } = this.mechanism;
    const values = [...parameters.map(({ value }) => value), ...inputs.map((input, at) => this.settings.input[at] ?? input.default ?? 0)];
    // With the same settings it will do the same.
    if (values.join() === this.lookedFor) return;
    this.lookedFor = values.join();
    this.send({ kind: "ahead", duration: LOOK_AHEAD });
  }

  /** @param {Float64Array} numbers of rows @param {number} width */
  seeAhead(numbers, width) {
    const { app, followCamera } = this;
    const shown = app.runViews.find(({ run }) => run === this.run);
    const ahead = Run.empty({ ...this.run.head, mechanism: this.mechanism });
    for (let at = 0; at < numbers.length; at += width) this.append(numbers.subarray(at, at + width), ahead);
    if (shown === undefined || ahead.rows < 2) return;
    shown.ahead = new Scene(ahead).extents();
    app.drawUsualPath(ahead);
    if (followCamera.chosen !== null && followCamera.isOwn() && app.drag === null) followCamera.choose();
    app.change();
  }

  /** @param {Float64Array} numbers as `plm_read` gives them @param {Run} [run] */
  append(numbers, run = this.run) {
    const { mechanism } = this;
    const [bodies, ground] = [6 * mechanism.bodies.length, 3 * mechanism.ground.length];
    const places = numbers.subarray(1 + bodies, 1 + bodies + ground);
    run.append(numbers[0], numbers.subarray(1, 1 + bodies), numbers.subarray(1 + bodies + ground), places);
  }

  /**
   * A start. Where nothing could be assembled the last picture stays, if there is one.
   * @param {Float64Array} numbers
   * @param {boolean} isAssembled
   */
  begin(numbers, isAssembled) {
    const { run, app, mechanism } = this;
    const expected = 1 + 6 * mechanism.bodies.length + 3 * mechanism.ground.length + run.columns.length;
    if (numbers.length !== expected) {
      this.breakDown(`The module is not of this mechanism: it gives ${numbers.length} numbers where the results have ${expected}.`);
      return;
    }
    const isFirst = run.rows === 0;
    this.isAssembled = isAssembled;
    if (isAssembled || isFirst) {
      const isRecording = this.recordsFrom !== null;
      this.stopRecording();
      run.clear();
      this.states.era += 1;
      this.append(numbers);
      if (isRecording) this.recordsFrom = run.start;
      if (!isAssembled) run.declareGround();
    }
    if (app.run === run) app.player.isFollowing = true;
    app.rowsAppended(run);
    if (isFirst) app.drawUsualPath(run);
    if (isFirst && isAssembled) this.lookAhead();
    if (isAssembled && !isFirst) this.followCamera.begin();
    // Where a recorded run told how large it is, the view is chosen already.
    if (isFirst && app.runViews.every((shown) => shown.run.isLive) && !app.isViewGiven) this.followCamera.choose();
  }

  /** @param {Extract<FromWorker, {kind: "settings"}>} settings */
  take({ parameters, inputs, shape, sizeNames }) {
    const { mechanism } = this;
    // Where nothing is assembled there are no inputs.
    const known = inputs.map((value, index) => (Number.isNaN(value) ? (this.settings.input[index] ?? 0) : value));
    this.settings = { parameter: parameters, input: known };
    mechanism.parameters.forEach((parameter, index) => (parameter.value = parameters[index]));
    this.revision += 1;
    if (readShape(mechanism, shape, sizeNames)) this.app.shapeChanged(this.run);
    this.app.touch();
  }

  /** Rows that are older than the window go, unless they are recorded. */
  trim() {
    const { run, recordsFrom } = this;
    const from = Math.min(recordsFrom ?? Infinity, run.end - LIVE_WINDOW);
    if (run.start < from) run.dropBefore(from);
  }
}

/** @param {RunHead} head @returns {RunHead} */
function liveHead(head) {
  const live = structuredClone(head);
  // The page pulls by parts and inputs of its own.
  live.mechanism.parts = live.mechanism.parts.filter(({ kind }) => kind !== "plm_pull");
  return { ...live, name: "live", method: "runs in this page", events: [], fault: null };
}
