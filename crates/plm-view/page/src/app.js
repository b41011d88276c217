// What is shown, as plain data, and what can be done with it. It knows nothing of elements of the page.

import { faultWords } from "./fault.js";
import { History } from "./history.js";
import { addMeasures } from "./measure.js";
import { tellingPoint } from "./opening.js";
import { onBackground, DARK, LIGHT } from "./palette.js";
import { Player } from "./player.js";
import { readResults } from "./results.js";
import { growArrows, sceneOf, usualCurves } from "./runview.js";
import { usualTools } from "./tools.js";
import { DRAWING_TOOLS, View } from "./view.js";

/** @import {Run} from "./run.js" */
/** @import {RunView} from "./runview.js" */
/** @import {Item} from "./solid.js" */
/** @import {Area, PresetName, Projection} from "./view.js" */

/** @typedef {"pan" | "orbit" | "zoom" | "window" | "info" | "pull" | "place" | "distance" | "angle" | "draw"} Mode what dragging does */
/** @typedef {"one" | "overlay" | "side"} Layout how several runs are shown */
/**
 * A body that is pulled or placed: a point of it in its axes, and where it is to go, in absolute axes; or how far it is
 * pulled, wherever it is.
 * @typedef {{kind: "pull" | "place", body: number, point: number[], target: number[], reach: number[] | null}} Drag
 */
/**
 * How a body is held by the mouse: taken at a place of the screen (whether it can be), moved, let go.
 * @typedef {{grab: (kind: Drag["kind"], body: number, projection: Projection, x: number, y: number) => boolean,
 *   move: (projection: Projection, x: number, y: number) => void, letGo: () => void}} Grip
 */
/** @typedef {{kind: "error" | "fault" | "warning" | "note", text: string, isBrief?: boolean}} Message */

export class App {
  constructor() {
    /** @type {RunView[]} */
    this.runViews = [];
    this.active = 0;
    /** @type {Layout} */
    this.layout = "one";
    this.view = new View();
    this.player = new Player();
    /** @type {Mode} */
    this.mode = "pan";
    this.isWire = false;
    /** @type {Item | null} */
    this.selected = null;
    /** Names of quantities. @type {string[]} */
    this.curves = [];
    /** The quantity that curves are drawn against; null: the time. @type {string | null} */
    this.across = null;
    /** Units whose charts have a logarithmic axis. @type {string[]} */
    this.logUnits = [];
    /** Names of points whose paths are drawn. @type {string[]} */
    this.traces = [];
    /** The path that is drawn before anybody has chosen one. @type {string[]} */
    this.usualTraces = [];
    this.showsForces = false;
    this.showsVelocities = false;
    /** Joints whose force has an arrow; null: all. @type {string[] | null} */
    this.forcesOf = null;
    /** Axes and scale bar in the corners, and what the length of arrows means: moving pictures leave them out. */
    this.hasAxes = true;
    this.hasArrowKey = true;
    /** Length of arrows against the usual one. */
    this.arrowFactor = 1;
    this.tools = usualTools();
    /** What is picked for a measure that is not whole. @type {import("./measure.js").Mark[]} */
    this.marks = [];
    this.history = new History(this);
    /** @type {"auto" | "light" | "dark"} */
    this.theme = "auto";
    this.prefersDark = false;
    /** @type {string | null} */
    this.background = null;
    /** Frames a second at most. */
    this.refreshRate = 60;
    /** Whether keys without Ctrl do something: who dictates to the computer may not want that. */
    this.hasPlainKeys = true;
    this.tab = "curves";
    this.hasPanel = true;
    /** The window of "zoom to window" while it is chosen, in pixels. @type {Area | null} */
    this.window = null;
    /** @type {Message[]} */
    this.messages = [];
    /** The mechanism itself, if the page holds it. @type {import("./live.js").Live | null} */
    this.live = null;
    /** @type {Drag | null} */
    this.drag = null;
    /** @type {Grip | null} */
    this.grip = null;
    /** What draws, where a declaration is typed. @type {import("./sketch.js").Sketch | null} */
    this.sketch = null;
    /** Hears why the run that is shown stands still; empty words where it does not. @type {(words: string) => void} */
    this.heardFault = () => {};
    /** Where the mouse is over the picture while nothing is held, in pixels. @type {{x: number, y: number} | null} */
    this.pointer = null;
    /** Whether the address told where to look from. */
    this.isViewGiven = false;
    /** Whether it told which paths to draw. */
    this.isPathGiven = false;
    /** The view as it was when it showed everything last. */
    this.fitted = "";
    this.madeBy = "";
    /** The declaration that is typed, as links have it; empty where none is, or the usual one. */
    this.packedText = "";
    /** The file that is shown, or was before it was cleared. @type {Uint8Array | null} */
    this.bytes = null;
    /** Where the scene is drawn. @type {Area} */
    this.area = { x: 0, y: 0, width: 800, height: 600 };
    /** Rises with everything that panels have to be built anew for. */
    this.revision = 0;
    /** Called when something is to be drawn. */
    this.onTouch = () => {};
  }

  get run() {
    return this.runViews[this.active]?.run ?? null;
  }

  get scene() {
    return this.runViews[this.active]?.scene ?? null;
  }

  get isDark() {
    return this.theme === "dark" || (this.theme === "auto" && this.prefersDark);
  }

  get palette() {
    return onBackground(this.isDark ? DARK : LIGHT, this.background);
  }

  /** Something is to be drawn. */
  touch() {
    this.onTouch();
  }

  /** Something is to be drawn, and panels are to be built anew. */
  change() {
    this.revision += 1;
    for (const { run } of this.runViews) addMeasures(run, this.tools.measures);
    this.touch();
  }

  /** @param {Message["kind"]} kind @param {string} text */
  tell(kind, text) {
    if (!this.messages.some((message) => message.text === text)) this.messages.push({ kind, text });
    this.change();
  }

  /**
   * Shows a results file; what cannot be read is told, and what was shown stays.
   * @param {Uint8Array} bytes
   * @returns {Promise<boolean>} whether it is shown
   */
  async load(bytes) {
    this.messages = [];
    try {
      const { runs, madeBy, warnings } = await readResults(bytes);
      this.bytes = bytes;
      this.madeBy = madeBy;
      this.showRuns(runs);
      for (const warning of warnings) this.tell("warning", warning);
      return true;
    } catch (error) {
      this.tell("error", error instanceof Error ? error.message : String(error));
      return false;
    }
  }

  /** @param {Run[]} runs */
  showRuns(runs) {
    this.replaceRuns(runs);
    if (this.curves.length === 0) this.curves = usualCurves(this.run);
    this.player.stop();
    this.player.chosenStep = null;
    this.updateBounds();
    this.player.seek(this.player.start);
    this.lookFrom("front");
    this.tellFault();
  }

  /** Runs in the place of those that are shown; of curves those stay that there still are. @param {Run[]} runs */
  replaceRuns(runs) {
    this.runViews = [];
    for (const run of runs) this.addRun(run);
    this.active = 0;
    this.layout = "one";
    this.selected = null;
    const names = new Set(this.run?.quantities().map(({ name }) => name));
    const hadCurves = this.curves.length > 0;
    this.curves = this.curves.filter((name) => names.has(name));
    // None of another mechanism's: its own usual ones.
    if (hadCurves && this.curves.length === 0) this.curves = usualCurves(this.run);
    if (this.across !== null && !names.has(this.across)) this.across = null;
    [this.traces, this.usualTraces, this.isPathGiven] = [[], [], false];
    this.drawUsualPath(this.run);
  }

  /** Draws the path that tells most of a run. @param {Run | null} run */
  drawUsualPath(run) {
    const point = tellingPoint(run);
    const isUsual = this.traces.join() === this.usualTraces.join();
    this.usualTraces = point === null ? [] : [point];
    if (isUsual && !this.isPathGiven) this.traces = [...this.usualTraces];
  }

  /**
   * A further run, which may be live: its rows may grow, and `rowsAppended` tells that.
   * @param {Run} run
   */
  addRun(run) {
    this.runViews.push({ run, ...sceneOf(run), isShown: true, ahead: null });
    this.updateBounds();
    this.change();
  }

  /** A source has changed the bodies of a run. @param {Run} run */
  shapeChanged(run) {
    const shown = this.runViews.find((candidate) => candidate.run === run);
    if (shown === undefined) return;
    const { forces, velocities } = shown;
    Object.assign(shown, sceneOf(run));
    shown.forces.largest = Math.max(shown.forces.largest, forces.largest);
    shown.velocities.largest = Math.max(shown.velocities.largest, velocities.largest);
    this.change();
  }

  /** A source has appended rows to a run, or has cleared it. @param {Run} run */
  rowsAppended(run) {
    const shown = this.runViews.find((candidate) => candidate.run === run);
    if (shown !== undefined) growArrows(shown);
    this.updateBounds();
    this.touch();
  }

  /** Tells what ended the active run. */
  tellFault() {
    this.messages = this.messages.filter(({ kind }) => kind !== "fault");
    const words = faultWords(this);
    if (words !== "") this.tell("fault", words);
    this.heardFault(words);
  }

  updateBounds() {
    const runs = this.visible().map(({ run }) => run).filter((run) => run.rows > 0);
    if (runs.length === 0) this.player.setBounds(0, 0);
    else this.player.setBounds(Math.min(...runs.map((run) => run.start)), Math.max(...runs.map((run) => run.end)));
  }

  /** The runs that are drawn, the active one last, so that it lies over the others. */
  visible() {
    const active = this.runViews[this.active];
    if (active === undefined) return [];
    if (this.layout === "one") return [active];
    const others = this.runViews.filter((shown) => shown.isShown && shown !== active);
    return this.layout === "overlay" ? [...others, active] : this.runViews.filter((shown) => shown.isShown || shown === active);
  }

  /**
   * Where each visible run is drawn: side by side in rows and columns, or all in one place.
   * @returns {Area[]}
   */
  areas() {
    const count = this.visible().length;
    const { x, y, width, height } = this.area;
    if (this.layout !== "side" || count < 2) return Array.from({ length: count }, () => this.area);
    const columns = Math.min(count, Math.max(1, Math.round(Math.sqrt((count * width) / height))));
    const [w, h] = [width / columns, height / Math.ceil(count / columns)];
    return Array.from({ length: count }, (_, at) => ({
      x: x + (at % columns) * w,
      y: y + Math.floor(at / columns) * h,
      width: w,
      height: h,
    }));
  }

  clear() {
    this.runViews = [];
    this.active = 0;
    this.selected = null;
    this.messages = [];
    this.player.stop();
    this.updateBounds();
    this.change();
  }

  /** The last file again, at its start. */
  async reload() {
    const hasLive = this.live?.isShown;
    if (this.bytes !== null) await this.load(this.bytes);
    if (hasLive) this.live?.reset();
  }

  /** Plays what there is; from the end of a live run on, the mechanism goes on. */
  play() {
    const { live, player } = this;
    if (live !== null && this.run === live.run && (player.isFollowing || player.time >= player.end)) live.start();
    else player.play();
  }

  get isPlaying() {
    return this.player.isPlaying || (this.live?.isRunning ?? false);
  }

  stop() {
    this.player.stop();
    if (this.live?.isRunning) this.live.pause();
  }

  /** A step forwards; from the end of a live run on, the mechanism makes one. */
  stepForwards() {
    const { live, player } = this;
    const isAtEnd = player.time >= player.end;
    if (live !== null && this.run === live.run && isAtEnd && !live.isRunning) live.step(player.chosenStep ?? 0.01);
    else {
      this.stop();
      player.stepBy(1);
    }
  }

  zoomToExtents() {
    const drawn = this.visible().filter(({ run }) => run.rows > 0);
    // A run that is about to begin will be where the others are.
    const known = drawn.length > 0 ? drawn : this.runViews.filter(({ run }) => run.rows > 0);
    const boxes = known.flatMap(({ scene, ahead }) => [scene.extents(), ...(ahead === null ? [] : [ahead])]);
    if (boxes.length > 0) {
      const low = [0, 1, 2].map((axis) => Math.min(...boxes.map((box) => box.low[axis])));
      const high = [0, 1, 2].map((axis) => Math.max(...boxes.map((box) => box.high[axis])));
      this.view.fit({ low, high }, this.areas()[0], this.mode === "draw" ? DRAWING_TOOLS : 0);
      this.fitted = JSON.stringify(this.view);
    }
    this.touch();
  }

  /** Whether the view shows everything, as nobody has moved it. */
  get isFitted() {
    return JSON.stringify(this.view) === this.fitted;
  }

  /** @param {PresetName} name */
  lookFrom(name) {
    this.view.lookFrom(name);
    this.zoomToExtents();
  }

  /** @param {Item | null} item */
  select(item) {
    this.selected = item;
    this.change();
  }

  /** Everything that can be selected, in the order of the declaration. @returns {Item[]} */
  items() {
    const mechanism = this.run?.mechanism;
    if (mechanism === undefined) return [];
    /** @type {(list: unknown[], kind: Item["kind"]) => Item[]} */
    const all = (list, kind) => list.map((_, index) => ({ kind, index }));
    return [...all(mechanism.bodies, "body"), ...all(mechanism.parts, "part"), ...all(mechanism.ground, "port")];
  }

  /** @param {number} steps */
  selectNext(steps) {
    const items = this.items();
    if (items.length === 0) return;
    const { selected } = this;
    const at = items.findIndex((item) => item.kind === selected?.kind && item.index === selected.index);
    const first = steps > 0 ? -1 : items.length;
    this.select(items[((at < 0 ? first : at) + steps + items.length) % items.length]);
  }

  /** @param {number} index */
  activate(index) {
    if (this.runViews[index] === undefined) return;
    this.active = index;
    this.runViews[index].isShown = true;
    if (this.selected !== null && this.items().every((item) => item.kind !== this.selected?.kind || item.index !== this.selected.index)) {
      this.selected = null;
    }
    this.player.isFollowing = this.run?.isLive ?? false;
    this.updateBounds();
    this.tellFault();
    this.change();
  }

  /** @param {Layout} layout */
  setLayout(layout) {
    this.layout = layout;
    this.updateBounds();
    this.zoomToExtents();
    this.change();
  }

  /** @param {string[]} list curves, traces or units @param {string} name */
  toggleName(list, name) {
    const at = list.indexOf(name);
    if (at < 0) list.push(name);
    else list.splice(at, 1);
    this.change();
  }
}
