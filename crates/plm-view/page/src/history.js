// History: what was set, placed and shown, as values, so that it can be undone and done again.

import { say } from "./say.js";

/** @import {App} from "./app.js" */

/** What is shown and can be undone, and how it is called. The view, the time and the colours are left alone. */
const SHOWN = /** @type {const} */ ({
  curves: "curves",
  across: "what curves are drawn against",
  logUnits: "axes of curves",
  traces: "paths",
  isWire: "surfaces",
  showsForces: "arrows of forces",
  showsVelocities: "arrows of velocities",
  arrowFactor: "length of arrows",
  layout: "layout of runs",
  ghosts: "ghost poses",
  centres: "instant centres",
  centrodes: "centrodes",
  pair: "pair of bodies",
  measures: "measures",
  force: "polar plot",
  around: "polar plot",
});

/** What is set by sliders. @type {string[]} */
const SLID = [SHOWN.arrowFactor, SHOWN.ghosts];

/**
 * Something that was done. `show`: members of the app before and after it. `set`: a parameter or an input, SI. `state`: the mechanism as
 * a whole, by the numbers under which its states are kept. `text`: a step of the text that is typed, which the editor keeps.
 * @typedef {{kind: "show", name: string, from: {[member: string]: any}, to: {[member: string]: any}}
 *   | {kind: "set", name: string, of: "parameter" | "input", index: number, from: number, to: number}
 *   | {kind: "state", name: string, from: number, to: number} | {kind: "text", name: string}} Deed
 */

/** Deeds that are kept. */
const MOST_DEEDS = 100;
/** Changes of one thing that follow one another as fast as that, ms, are one deed. */
const ONE_DEED = 1000;

export class History {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {Deed[]} */
    this.done = [];
    /** @type {Deed[]} */
    this.undone = [];
    /** What was shown in the last frame. @type {{[member: string]: any} | null} */
    this.shown = null;
    /** Whether somebody has pressed or typed anything since: what is shown may change by itself, too. */
    this.hasActed = false;
    this.isBusy = false;
    this.states = 0;
    /** Takes steps of the text back, and does them again. @type {{undo: () => void, redo: () => void} | null} */
    this.text = null;
    /** The drag that was kept last: all of it is one deed. @type {import("./app.js").Drag | null} */
    this.drag = null;
    this.lastAt = -Infinity;
    /** @type {unknown} */
    this.of = null;
  }

  /** What was done to another mechanism cannot be undone on this one; steps of the text can. */
  watchMechanism() {
    const of = this.app.live ?? this.app.bytes;
    if (of === this.of) return;
    const ofText = (/** @type {Deed[]} */ deeds) => deeds.filter(({ kind }) => kind === "text");
    [this.of, this.done, this.undone] = [of, ofText(this.done), ofText(this.undone)];
  }

  /** What is shown now. @returns {{[member: string]: any}} */
  look() {
    return structuredClone(Object.fromEntries(Object.keys(SHOWN).map((member) => [member, ownerOf(this.app, member)[member]])));
  }

  /** Sees what has changed of what is shown; called in every frame. */
  update() {
    this.watchMechanism();
    const now = this.look();
    const before = this.shown;
    const changed = before === null ? [] : Object.keys(now).filter((member) => JSON.stringify(now[member]) !== JSON.stringify(before[member]));
    if (before !== null && changed.length === 0) {
      this.hasActed = false;
      return;
    }
    this.shown = now;
    const hasActed = this.hasActed;
    this.hasActed = false;
    if (before === null || !hasActed) return;
    const some = (/** @type {{[member: string]: any}} */ all) => Object.fromEntries(changed.map((member) => [member, all[member]]));
    const name = [...new Set(changed.map((member) => SHOWN[/** @type {keyof typeof SHOWN} */ (member)]))].join(", ");
    this.add({ kind: "show", name, from: some(before), to: some(now) });
  }

  /** @param {Deed} deed */
  add(deed) {
    if (this.isBusy) return;
    this.watchMechanism();
    const now = performance.now();
    const last = this.done[this.done.length - 1];
    const isSame = last !== undefined && this.undone.length === 0 && now - this.lastAt < ONE_DEED && isOneThing(last, deed);
    this.lastAt = now;
    this.undone = [];
    if (isSame) {
      // Its state before stays; that after it is taken when it is undone.
      if (last.kind !== "state" && last.kind !== "text" && deed.kind !== "text") last.to = deed.to;
      return;
    }
    this.done.push(deed);
    if (this.done.length > MOST_DEEDS) this.done.shift();
  }

  /** The mechanism is about to be placed, pulled or begun again: its state before is kept. @param {string} name */
  keepState(name) {
    const { live, drag } = this.app;
    if (live === null || !live.isInPage || this.isBusy) return;
    if (drag !== null && drag === this.drag) return;
    if (drag !== null) this.lastAt = -Infinity;
    this.drag = drag;
    const last = this.done[this.done.length - 1];
    const [from, to] = [this.states, this.states + 1];
    this.add({ kind: "state", name, from, to });
    if (this.done[this.done.length - 1] === last) return;
    this.states += 2;
    live.states.keep(from);
  }

  undo() {
    this.update();
    this.go(this.done, this.undone, "from");
  }

  redo() {
    this.update();
    this.go(this.undone, this.done, "to");
  }

  /** @param {Deed[]} source @param {Deed[]} target @param {"from" | "to"} side */
  go(source, target, side) {
    const { app } = this;
    const deed = source.pop();
    say(app, deed === undefined ? `Nothing to ${side === "from" ? "undo" : "do again"}` : `${side === "from" ? "Undone" : "Done again"}: ${deed.name}`);
    if (deed === undefined) return;
    this.isBusy = true;
    if (deed.kind === "text") this.text?.[side === "from" ? "undo" : "redo"]();
    else if (deed.kind === "set") app.live?.set(deed.of, deed.index, deed[side]);
    else if (deed.kind === "show") for (const [member, value] of Object.entries(deed[side])) ownerOf(app, member)[member] = structuredClone(value);
    else app.live?.states.comeBack(deed[side], deed[side === "from" ? "to" : "from"]);
    this.isBusy = false;
    target.push(deed);
    this.lastAt = -Infinity;
    this.shown = this.look();
    app.updateBounds();
    app.change();
  }
}

/** What a member belongs to: the tools, or the app itself. @param {App} app @param {string} member @returns {{[member: string]: any}} */
function ownerOf(app, member) {
  return member in app.tools ? app.tools : app;
}

/** Whether two deeds change one and the same thing. @param {Deed} a @param {Deed} b */
function isOneThing(a, b) {
  if (a.kind === "set" && b.kind === "set") return a.of === b.of && a.index === b.index;
  if (a.kind === "show" && b.kind === "show") return SLID.includes(a.name) && b.name === a.name;
  return a.kind === "state" && b.kind === "state" && a.name === b.name && a.name.startsWith("place ");
}

/** Who presses or types does something. @param {History} history */
export function listenToDeeds(history) {
  const act = () => {
    history.hasActed = true;
  };
  for (const kind of ["pointerdown", "pointerup", "click", "keydown", "input", "change"]) window.addEventListener(kind, act, true);
}
