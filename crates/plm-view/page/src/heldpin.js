// A pin that is held: numbers under the hand are parameters of a text that was compiled once, and each move sets them and begins again.

import { besidePin, millimetres, pinOf, sketchStep, snapped } from "./snap.js";

/** @import {Drawn, PlacedPort} from "./pencil.js" */
/** @import {Press, Sketch} from "./sketch.js" */
/** @import {Snapped} from "./snap.js" */
/** @import {Projection} from "./view.js" */

/** So far, s, the path of a point is drawn, and so long, ms, it may take. */
const PATH_AHEAD = { duration: 1, most: 12 };

export class HeldPin {
  /**
   * @param {Sketch} sketch
   * @param {PlacedPort} port
   * @param {boolean} isFree whether bars keep their poses
   */
  constructor(sketch, port, isFree) {
    this.sketch = sketch;
    this.text = sketch.text;
    this.places = sketch.places();
    this.port = port;
    this.isFree = isFree;
    const { parts } = sketch.sheet;
    /** Its ports, and those with which they cannot be joined. */
    this.pin = pinOf(parts, port);
    this.except = besidePin(this.places, parts, this.pin);
    this.grid = 1e-3;
    /** @type {Snapped | null} */
    this.snapped = null;
    this.to = port.at;
    this.why = "";
    /** What a hand has to know there. @type {string[]} */
    this.told = [];
    /** When the next second ends early, s; null where it does not. @type {number | null} */
    this.stops = null;
    /** Whether the text with parameters was asked for, and whether it moves. */
    this.isLifted = false;
    this.isReady = false;
    this.isBusy = false;
    /** @type {string[]} */
    this.parameters = [];
    /** Values that are not set yet. @type {number[] | null} */
    this.next = null;
    /** The path of a point from the start on, absolute axes. @type {number[]} */
    this.path = [];
  }

  get name() {
    return { owner: this.port.owner, port: this.port.port };
  }

  /** What is asked of the pencil. @param {number[]} to */
  gesture(to) {
    return { port: this.name, to, grid: this.grid, free: this.isFree };
  }

  /**
   * @param {Projection} projection
   * @param {number} x
   * @param {number} y
   * @param {Press} how
   */
  move(projection, x, y, how) {
    const { pencil } = this.sketch;
    this.grid = sketchStep(projection.scale);
    this.snapped = snapped(this.places, projection, x, y, { ...how, except: this.except, moving: this.pin });
    if (this.snapped === null) return;
    const drawn = /** @type {Drawn} */ (pencil.ask(this.text, { kind: "drag", live: true, ...this.gesture(this.snapped.at) }, this.places));
    this.why = drawn.why ?? "";
    if (drawn.why !== undefined) return;
    this.told = drawn.told ?? [];
    this.to = drawn.to ?? this.snapped.at;
    if (!this.isLifted) this.lift();
    this.next = drawn.values ?? [];
    this.send();
  }

  /** Numbers under the hand become parameters. */
  lift() {
    const { pencil, exchange } = this.sketch;
    this.isLifted = true;
    const lifted = pencil.ask(this.text, { kind: "lift", ...this.gesture(this.port.at) }, this.places);
    if (lifted.why !== undefined) return;
    this.parameters = lifted.parameters;
    void exchange.declare(lifted.text, true).then((isShown) => {
      this.isReady = isShown === true;
      this.send();
    });
  }

  /** The values that are wanted last are set, once the ones before have been answered. */
  send() {
    const { sketch, next } = this;
    const { live } = sketch.app;
    if (sketch.held !== this || !this.isReady || this.isBusy || next === null || live === null || next.length !== this.parameters.length) return;
    this.next = null;
    this.isBusy = true;
    live.whenDragged = (path, stops) => {
      this.isBusy = false;
      [this.path, this.stops] = [path, stops];
      sketch.app.touch();
      this.send();
    };
    const index = (/** @type {string} */ wanted) => live.mechanism.parameters.findIndex(({ name }) => name === wanted);
    live.send({ kind: "parameters", values: next.map((value, at) => [index(this.parameters[at]), value]), trace: this.traced() });
  }

  /** What a hand is told: why it cannot, else where it is, and what becomes of the mechanism there. */
  get words() {
    if (this.why !== "") return this.why;
    const stops = this.stops === null ? [] : [`it stops after ${Number(this.stops.toFixed(2))} s`];
    return [`${millimetres(this.to[0])}, ${millimetres(this.to[1])} mm`, ...this.told, ...stops].join("; ");
  }

  /** The point whose path is drawn. */
  traced() {
    const { run, traces, usualTraces } = this.sketch.app;
    const [owner, port] = (traces[0] ?? usualTraces[0] ?? "").split(".");
    const body = run?.mechanism.bodies.findIndex(({ name }) => name === owner) ?? -1;
    const at = run?.mechanism.bodies[body]?.ports.find(({ name }) => name === port);
    if (at === undefined) return port === "G" && body >= 0 ? { body, point: [0, 0], ...PATH_AHEAD } : null;
    return { body, point: [at.x, at.y], ...PATH_AHEAD };
  }
}
