// Drawing in the picture: what a hand does there is an edit of the text, and the picture follows the text.
//
// States: at rest; a pin is held (`heldpin.js`); something is begun that a second place ends.

import { HeldPin } from "./heldpin.js";
import { say } from "./say.js";
import { nearestPort, pinOf, portKey, sketchStep } from "./snap.js";
import { framePose } from "./solid.js";
import { beginStroke, endStroke, groundAt, motorAt } from "./strokes.js";

/** @import {App} from "./app.js" */
/** @import {EditorPane} from "./editorpane.js" */
/** @import {Exchange} from "./exchange.js" */
/** @import {Drawn, Gesture, Pencil, PlacedPort, PortName, SketchSheet} from "./pencil.js" */
/** @import {Begun} from "./strokes.js" */
/** @import {Projection} from "./view.js" */

/** @typedef {"move" | "bar" | "point" | "ground" | "slide" | "motor" | string} SketchTool the last: a word of the table of parts */
/** @typedef {{isShift?: boolean, isAlt?: boolean, reach?: number}} Press */

/** An empty sheet, m. */
const EMPTY_SHEET = { low: [-0.15, -0.12, 0], high: [0.45, 0.28, 0] };

export class Sketch {
  /**
   * @param {App} app
   * @param {Exchange} exchange
   * @param {Pencil} pencil
   */
  constructor(app, exchange, pencil) {
    this.app = app;
    this.exchange = exchange;
    this.pencil = pencil;
    /** @type {EditorPane | null} */
    this.pane = null;
    /** @type {SketchTool} */
    this.tool = "move";
    /** @type {HeldPin | null} */
    this.held = null;
    /** What a second place ends: its first one. @type {Begun | null} */
    this.from = null;
    /** Whether this press has begun it. */
    this.isBegun = false;
    /** The pin whose dimensions are shown. @type {PortName | null} */
    this.chosen = null;
    /** Where Enter presses. @type {number[] | null} */
    this.cursor = null;
    /** Whether the keyboard was used last. */
    this.isByKeys = false;
    /** How far the chosen pin goes once it is known where it stands. @type {number[]} */
    this.waiting = [0, 0];
    /** @type {{text: string, sheet: SketchSheet}} */
    this.read = { text: "", sheet: { places: [], parts: [] } };
    /** @type {{of: unknown, era: number, places: PlacedPort[]} | null} */
    this.start = null;
    /** Called when tools or fields have to be shown anew. */
    this.onChange = () => {};
    /** What is drawn below the picture, and over it. @type {(pen: import("./pen.js").Pen) => void} */
    this.drawBelow = () => {};
    /** @type {(pen: import("./pen.js").Pen) => void} */
    this.drawOver = () => {};
  }

  get isOn() {
    return this.app.mode === "draw";
  }

  get text() {
    return this.pane?.editor.text() ?? "";
  }

  /** The text as far as it is one. @returns {SketchSheet} */
  get sheet() {
    const { text } = this;
    if (this.read.text !== text) this.read = { text, sheet: this.pencil.sheet(text) };
    return this.read.sheet;
  }

  /** Whether what moves is the text. */
  get isCurrent() {
    return this.app.run !== null && this.exchange.text === this.text;
  }

  /** Ports at the start, as they are assembled; null where nothing is, or where the start is not kept. @returns {PlacedPort[] | null} */
  assembled() {
    const { live, run, scene } = this.app;
    if (live === null || run !== live.run || scene === null || run.rows === 0 || run.start !== 0) return this.start?.of === live ? (this.start?.places ?? null) : null;
    if (this.start?.of === live && this.start.era === live.states.era) return this.start.places;
    const at = scene.at(0);
    const { mechanism } = run;
    const place = (/** @type {number | null} */ body, /** @type {string} */ owner, /** @type {string} */ name, /** @type {number} */ port) => {
      const [x, y] = framePose(mechanism, { argument: "", body, port }, at);
      return { owner, port: name, at: [x, y], angle: body === null ? 0 : at.poses[3 * body + 2] };
    };
    const places = [
      ...mechanism.ground.map(({ name }, port) => place(null, "ground", name, port)),
      ...mechanism.bodies.flatMap((body, index) => body.ports.map(({ name }, port) => place(index, body.name, name, port))),
    ];
    this.start = { of: live, era: live.states.era, places };
    return places;
  }

  /** Where all ports stand at the start: as they are assembled, and what is not yet, as the text tells. @returns {PlacedPort[]} */
  places() {
    const assembled = this.app.run === null ? null : this.assembled();
    if (assembled === null) return this.sheet.places;
    if (this.held !== null || this.isCurrent) return assembled;
    const known = new Map(assembled.map((place) => [portKey(place), place]));
    return this.sheet.places.map((place) => (place.guessed ? (known.get(portKey(place)) ?? place) : place));
  }

  /** Draws, or leaves off. */
  toggle() {
    if (this.isOn) this.leave();
    else this.enter();
  }

  enter() {
    const { app } = this;
    const { live } = app;
    const isFitted = app.isFitted;
    app.mode = "draw";
    app.window = null;
    // The tools stand over the picture now.
    if (isFitted || app.view.azimuth !== 0 || app.view.elevation !== 0) app.lookFrom("front");
    this.stand();
    if (live === null || app.run === null) this.emptyView();
    this.changed();
  }

  leave() {
    this.cancel();
    this.chosen = null;
    this.app.mode = this.app.live?.usualMode ?? "pan";
    this.changed();
  }

  /** What moves stands at its start, as the text says. */
  stand() {
    const { live, run, player } = this.app;
    if (live === null || run !== live.run) return;
    const { isMoving } = this;
    player.stop();
    if (live.isRunning) live.pause();
    if (isMoving) live.send({ kind: "restart" });
    player.isFollowing = true;
  }

  /** Whether it moves, so that what is drawn would stand elsewhere. */
  get isMoving() {
    const { live, run } = this.app;
    return live !== null && run === live.run && (live.isRunning || run.rows > 1);
  }

  /** The view of a sheet on which nothing is yet. */
  emptyView() {
    const { app } = this;
    if (this.sheet.places.length > 0) return;
    app.view.lookFrom("front");
    app.view.fit(EMPTY_SHEET, app.area);
  }

  /** A new sheet. */
  begin() {
    this.cancel();
    this.chosen = null;
    this.pane?.step("new sheet", (editor) => editor.replace(""));
    this.exchange.clear();
    this.app.mode = "draw";
    this.tool = "bar";
    this.emptyView();
    this.changed();
  }

  /** @param {SketchTool} tool */
  take(tool) {
    this.cancel();
    this.tool = tool;
    if (tool === "move") this.cursor = null;
    if (!this.isOn) this.enter();
    this.changed();
  }

  changed() {
    this.onChange();
    this.app.change();
  }

  /** Tells why something cannot be drawn. @param {string} why */
  tell(why) {
    say(this.app, `${why.charAt(0).toUpperCase()}${why.slice(1)}.`);
  }

  /**
   * What a gesture is becomes one step of the text.
   * @param {string} name
   * @param {Gesture} gesture
   * @param {PlacedPort[]} [places]
   * @returns {Drawn | null}
   */
  make(name, gesture, places = this.places()) {
    const drawn = /** @type {Drawn} */ (this.pencil.ask(this.text, gesture, places));
    if (drawn.why !== undefined) {
      this.tell(drawn.why);
      return null;
    }
    this.pane?.step(name, (editor) => editor.gesture(drawn.edits ?? []));
    this.changed();
    return drawn;
  }

  /**
   * A press; false where there is nothing to draw, so that it selects or moves the view.
   * @param {Projection} projection
   * @param {number} x
   * @param {number} y
   * @param {Press} how
   */
  press(projection, x, y, how) {
    if (this.isMoving) {
      this.stand();
      return true;
    }
    if (this.tool === "move") {
      const port = nearestPort(this.places(), projection, x, y, how);
      if (port === null) {
        this.choose(null);
        return false;
      }
      this.held = new HeldPin(this, port, how.isAlt === true);
      return true;
    }
    this.isBegun = this.from === null;
    if (this.isBegun && this.tool !== "motor" && this.tool !== "ground") beginStroke(this, projection, x, y, how);
    return true;
  }

  /**
   * The end of a press.
   * @param {Projection} projection
   * @param {number} x
   * @param {number} y
   * @param {Press & {hasMoved: boolean}} how
   */
  release(projection, x, y, how) {
    if (this.held !== null) this.drop(this.held, how.hasMoved);
    else if (this.tool === "ground") groundAt(this, projection, x, y, how);
    else if (this.tool === "motor") motorAt(this, projection, x, y, how);
    else if (this.from !== null && !(this.isBegun && !how.hasMoved)) endStroke(this, projection, x, y, how);
    this.app.touch();
  }

  /** A pin that is let go: one step of the text. @param {HeldPin} held @param {boolean} hasMoved */
  drop(held, hasMoved) {
    this.held = null;
    if (!hasMoved) {
      this.choose(held.name);
      return;
    }
    const name = `move ${portKey(held.port)}`;
    const { snapped: place, grid, isFree: free } = held;
    const isOwn = this.text === held.text;
    if (held.why !== "") this.tell(held.why);
    else if (place !== null && isOwn) {
      const gesture = { port: held.name, to: place.at, grid, free };
      const onto = place.onto === null ? undefined : { owner: place.onto.owner, port: place.onto.port };
      const drawn = this.make(onto === undefined ? name : `join ${portKey(held.port)}`, { kind: onto === undefined ? "drag" : "merge", ...gesture, onto }, held.places);
      if (drawn !== null && (drawn.edits ?? []).length > 0) return;
    }
    this.comeBack(held);
  }

  /** What is under the hand is taken back: the text itself moves again. @param {HeldPin} held */
  comeBack(held) {
    if (held.isLifted) void this.exchange.declare(this.text);
    this.app.touch();
  }

  /** Nothing is held or begun any more; whether something was. */
  cancel() {
    const { held, from } = this;
    [this.held, this.from, this.isBegun] = [null, null, false];
    if (held !== null) this.comeBack(held);
    if (held !== null || from !== null) this.changed();
    return held !== null || from !== null;
  }

  /** The pose on the screen becomes the start of the text. */
  startHere() {
    const { live, run, scene, player } = this.app;
    if (live === null || run !== live.run || scene === null || run.rows === 0 || !this.isCurrent) {
      this.tell("what is on the screen is not the text that stands here");
      return;
    }
    const { poses } = scene.at(Math.min(Math.max(player.time, run.start), run.end));
    const all = run.mechanism.bodies.map(({ name: body }, index) => {
      const [x, y, angle] = poses.subarray(3 * index, 3 * index + 3);
      return { body, at: [x, y], angle };
    });
    live.pause();
    this.make("this pose as start", { kind: "start", poses: all, grid: sketchStep(this.app.view.scale) }, []);
  }

  /** @param {PortName | null} port */
  choose(port) {
    this.chosen = port;
    if (port !== null) this.app.selected = null;
    this.changed();
  }

  /** The chosen pin goes by so much, once it is known where it stands: assembly may move what the text alone tells. @param {number[]} by */
  nudge(by) {
    const { chosen } = this;
    const is = (/** @type {PlacedPort} */ place) => chosen !== null && portKey(place) === portKey(chosen);
    this.waiting = this.waiting.map((part, axis) => part + by[axis]);
    if (!this.isCurrent && this.sheet.places.find(is)?.guessed !== false) return;
    const at = this.places().find(is)?.at;
    const to = at?.map((part, axis) => Number((part + this.waiting[axis]).toPrecision(12)));
    this.waiting = [0, 0];
    if (chosen === null || to === undefined) return;
    this.make(`move ${portKey(chosen)}`, { kind: "drag", port: chosen, to, grid: sketchStep(this.app.view.scale), free: false });
  }

  /** What is selected again, beside itself. */
  copy() {
    const name = this.chosen !== null && this.chosen.owner !== "ground" ? this.chosen.owner : this.selectedName;
    const { scale } = this.app.view;
    const step = sketchStep(scale, 24);
    if (name === null) this.tell("a bar is wanted, which is selected");
    else this.make(`copy ${name}`, { kind: "copy", body: name, by: [step, -step], grid: sketchStep(scale) });
  }

  /** The pin of two bars goes to its mirror image. */
  mirror() {
    const { chosen } = this;
    if (chosen === null) this.tell("a pin of two bars is wanted, which is chosen");
    else this.make(`mirror ${portKey(chosen)}`, { kind: "mirror", port: chosen, grid: sketchStep(this.app.view.scale) });
  }

  /** Dimensions of the chosen pin that are parameters. @returns {string[]} */
  get locks() {
    const { chosen } = this;
    const place = this.sheet.places.find((each) => chosen !== null && portKey(each) === portKey(chosen));
    return place?.locks ?? [];
  }

  /** A dimension of the chosen pin becomes a parameter, or a number again. @param {string} dimension */
  lock(dimension) {
    const { chosen } = this;
    const kind = this.locks.includes(dimension) ? "unlock" : "lock";
    if (chosen !== null) this.make(`${kind} ${dimension} of ${portKey(chosen)}`, { kind, port: chosen, dimension });
  }

  /** What is selected, by its name. */
  get selectedName() {
    const { selected, run } = this.app;
    if (selected === null || run === null || !this.isCurrent) return null;
    const { bodies, parts } = run.mechanism;
    return selected.kind === "body" ? bodies[selected.index].name : selected.kind === "part" ? parts[selected.index].name : null;
  }

  /** Whether something can be taken away. */
  get canRemove() {
    return this.chosen !== null || this.selectedName !== null;
  }

  /** What is selected goes: a body, a part, or what joins the bars at a pin. */
  remove() {
    const [name, { chosen }] = [this.selectedName, this];
    const isPinned = chosen !== null && pinOf(this.sheet.parts, chosen).size > 1;
    if (isPinned) this.make(`open ${portKey(chosen)}`, { kind: "unpin", port: chosen });
    else if (chosen !== null) this.make(`delete ${portKey(chosen)}`, { kind: "delete", port: chosen });
    else if (name !== null) this.make(`delete ${name}`, { kind: "delete", name });
    this.choose(null);
  }

  /** What is selected has another name. @param {string} to */
  rename(to) {
    const [name, { chosen }] = [this.selectedName, this];
    const drawn =
      chosen !== null
        ? this.make(`rename ${portKey(chosen)}`, { kind: "rename", port: chosen, to })
        : name === null
          ? null
          : this.make(`rename ${name}`, { kind: "rename", name, to });
    if (drawn !== null && chosen !== null) this.choose({ ...chosen, port: to });
    return drawn !== null;
  }

  /** A dimension of the chosen pin, as it is typed. @param {"x" | "y" | "length" | "angle"} dimension @param {string} text */
  type(dimension, text) {
    const { chosen } = this;
    if (chosen === null) return false;
    const grid = sketchStep(this.app.view.scale);
    return this.make(`${dimension} of ${portKey(chosen)}`, { kind: "typed", port: chosen, dimension, text, grid }) !== null;
  }
}
