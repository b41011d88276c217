// The panel of the mechanism itself: parameters, inputs, start and pause, recordings.

import { setMode } from "./commands.js";
import { Dials } from "./dials.js";
import { element, saveBlob, setText } from "./dom.js";
import { LIVE_WINDOW } from "./live.js";
import { fileStem } from "./picture.js";
import { timeText } from "./text.js";
import { csvText, resultsFile } from "./write.js";

/** @import {App} from "./app.js" */
/** @import {Live} from "./live.js" */
/** @import {Contact} from "./worker.js" */

export class LivePanel {
  /**
   * @param {App} app
   * @param {Live} live
   * @param {HTMLElement} root
   */
  constructor(app, live, root) {
    this.app = app;
    this.live = live;
    this.dials = new Dials(live, {
      // In a page with the text of the mechanism values are written there.
      isThere: () => app.sketch !== null,
      write: (name, value) => void app.sketch?.make(`write ${name}`, { kind: "set", name, value }),
    });
    this.go = actButton("live-go", "Run", () => (live.isRunning ? live.pause() : live.start()));
    this.record = actButton("live-record", "Record", () => live.record());
    this.state = element("p", { id: "live-state", class: "hint" });
    this.tape = element("p", { id: "live-tape", class: "hint" });
    this.contacts = element("dl", { id: "live-contacts" });
    /** @type {Contact[] | null} */
    this.shownContacts = null;
    this.contactsTitle = element("h2", {}, "Contact");
    root.append(
      element(
        "div",
        { class: "row" },
        this.go,
        actButton("live-restart", "Restart", () => live.restart(), "From the first moment, with the values as they are set below (Shift+B)"),
        actButton("live-reset", "Reset", () => live.reset(), "From the first moment, with all values as declared (Shift+D)"),
        this.record,
      ),
      this.state,
      element("p", { class: "hint" }, "Restart begins again and keeps the values below; Reset takes back the declared ones."),
      ...(live.modes.length > 0 ? [this.byHand()] : []),
      ...this.dials.elements,
      this.contactsTitle,
      this.contacts,
      element("h2", {}, "Save what was recorded"),
      this.tape,
      element(
        "div",
        { class: "row" },
        actButton("live-npz", "Results file (.npz)", () => void saveResults(app, live)),
        actButton("live-csv", "Table (.csv)", () => saveTables(app, live)),
      ),
    );
  }

  /** Which mode is chosen, and how it is used. */
  byHand() {
    const all = /** @type {const} */ ([["pull", "Pull"], ["place", "Place"], ["pan", "Look"]]);
    const modes = all.filter(([mode]) => mode === "pan" || this.live.modes.includes(mode));
    this.modes = modes.map(([mode, name]) =>
      element(
        "label",
        {},
        element("input", { type: "radio", name: "drag", id: `drag-${mode}`, value: mode, onchange: () => this.choose(mode) }),
        name,
      ),
    );
    this.hint = element("p", { class: "hint" });
    const title = "The text begins in the pose on the screen: as many of its starts are written as there are freedoms";
    this.asStart = actButton("live-as-start", "Pose as start", () => this.app.sketch?.startHere(), title);
    return element("fieldset", { class: "row drag" }, element("legend", {}, "By mouse and arrow keys"), ...this.modes, this.asStart, this.hint);
  }

  /** @param {"pull" | "place" | "pan"} mode */
  choose(mode) {
    setMode(this.app, mode);
    this.app.touch();
  }

  update() {
    const { app, live } = this;
    setText(this.go, live.isRunning ? "Pause" : "Run");
    const isRecording = live.recordsFrom !== null;
    setText(this.record, isRecording ? "Stop recording" : "Record");
    if (this.record.getAttribute("aria-pressed") !== String(isRecording)) this.record.setAttribute("aria-pressed", String(isRecording));
    setText(this.state, stateText(live));
    setText(this.tape, tapeText(live));
    for (const label of this.modes ?? []) {
      const radio = label.querySelector("input");
      if (radio?.value === "pull") radio.disabled = live.unmoved !== "";
      if (radio !== null) radio.checked = radio.value === (app.mode === "pull" || app.mode === "place" ? app.mode : "pan");
    }
    if (this.asStart !== undefined) this.asStart.hidden = app.sketch === null;
    if (this.hint !== undefined) setText(this.hint, handHint(app));
    this.dials.update();
    this.showContacts();
  }

  /** What the rows of contact do, a line each. */
  showContacts() {
    const { contacts } = this.live;
    if (contacts === this.shownContacts) return;
    this.shownContacts = contacts;
    this.contacts.hidden = this.contactsTitle.hidden = contacts.length === 0;
    this.contacts.replaceChildren(...contacts.flatMap(({ name, mode }) => [element("dt", {}, name), element("dd", {}, mode)]));
  }
}

/** @param {string} id @param {string} name @param {() => void} act @param {string} [title] */
function actButton(id, name, act, title) {
  return element("button", { type: "button", id, title: title ?? null, onclick: act }, name);
}

/** @param {Live} live */
function stateText({ gone, isBroken, isRunning, isAssembled, run, app }) {
  if (gone !== "") return gone;
  if (isBroken) return "The module has stopped.";
  if (run.rows === 0) return "Loading …";
  if (run.fault !== null && !isAssembled) return "Not assembled. Change a parameter, or reset.";
  if (run.fault !== null) return "Stopped. Change something, restart or reset.";
  return isRunning ? "Running" : `Paused at ${timeText(run.end, app.player.duration)}`;
}

/** @param {Live} live */
function tapeText(live) {
  const { recordings, recordsFrom } = live;
  const done = recordings.length === 0 ? "" : `${recordings.length} recorded, also among the runs. `;
  if (recordsFrom !== null) return `${done}Recording since ${timeText(recordsFrom, 1)}.`;
  return done || `Nothing is recorded yet: the last ${LIVE_WINDOW} s are kept.`;
}

/** @param {App} app */
function handHint({ mode, selected, live }) {
  const isBody = selected?.kind === "body";
  const name = isBody ? (live?.mechanism.bodies[selected.index].name ?? "") : "a body that you select";
  if (mode === "pull") return `Press on a body and drag: a spring pulls it. Arrow keys pull ${name}.`;
  if (mode === "place") return `Drag a body: joints close by themselves. Arrow keys move ${name}, Page ↑ and Page ↓ turn it.`;
  return `${live?.unmoved ?? ""} Dragging moves the view.`.trimStart();
}

/** @param {App} app @param {Live} live */
async function saveResults(app, live) {
  const bytes = await resultsFile(live.kept(), app.madeBy || "plm");
  saveBlob(new Blob([bytes], { type: "application/zip" }), `${fileStem(app)}-live.npz`);
}

/** A file for each recording. @param {App} app @param {Live} live */
function saveTables(app, live) {
  for (const run of live.kept()) {
    saveBlob(new Blob([csvText(run)], { type: "text/csv" }), `${fileStem(app)}-${run.name.replaceAll(" ", "-")}.csv`);
  }
}
