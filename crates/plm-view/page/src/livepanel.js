// The panel of the mechanism itself: parameters, inputs, start and pause, recordings.

import { setMode } from "./commands.js";
import { element, saveBlob, setText } from "./dom.js";
import { LIVE_WINDOW } from "./live.js";
import { fromSi, niceNear } from "./numbers.js";
import { fileStem } from "./picture.js";
import { valueOf } from "./settings.js";
import { timeText, typeset } from "./text.js";
import { csvText, resultsFile } from "./write.js";

/** @import {App} from "./app.js" */
/** @import {Input, Parameter} from "./format.js" */
/** @import {Live} from "./live.js" */
/** @import {Contact} from "./worker.js" */

/**
 * A quantity that is set by a slider and by a number, in its declared unit.
 * @typedef {{kind: "parameter" | "input", index: number, factor: number, slider: HTMLInputElement, field: HTMLInputElement, write: HTMLButtonElement, usual: number | null}} Dial
 */

export class LivePanel {
  /**
   * @param {App} app
   * @param {Live} live
   * @param {HTMLElement} root
   */
  constructor(app, live, root) {
    this.app = app;
    this.live = live;
    this.revision = -1;
    this.go = actButton("live-go", "Run", () => (live.isRunning ? live.pause() : live.start()));
    this.record = actButton("live-record", "Record", () => live.record());
    this.state = element("p", { id: "live-state", class: "hint" });
    this.tape = element("p", { id: "live-tape", class: "hint" });
    this.contacts = element("dl", { id: "live-contacts" });
    /** @type {Contact[] | null} */
    this.shownContacts = null;
    this.contactsTitle = element("h2", {}, "Contact");
    /** @type {Dial[]} */
    this.dials = [];
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
      ...this.dialGroup("Parameters", "parameter", live.mechanism.parameters),
      ...this.dialGroup("Inputs", "input", live.mechanism.inputs),
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
    return element("fieldset", { class: "row drag" }, element("legend", {}, "By mouse and arrow keys"), ...this.modes, this.hint);
  }

  /** @param {"pull" | "place" | "pan"} mode */
  choose(mode) {
    setMode(this.app, mode);
    this.app.touch();
  }

  /**
   * @param {string} title
   * @param {"parameter" | "input"} kind
   * @param {(Parameter | Input)[]} quantities
   */
  dialGroup(title, kind, quantities) {
    const rows = quantities.flatMap((quantity, index) =>
      // The page's own pulls are no inputs of the user's.
      quantity.name.startsWith("plm_pull_") ? [] : [this.dial(kind, index, quantity)],
    );
    return rows.length === 0 ? [] : [element("h2", {}, title), element("div", { class: "dials" }, ...rows)];
  }

  /**
   * @param {"parameter" | "input"} kind
   * @param {number} index
   * @param {Parameter | Input} quantity
   */
  dial(kind, index, { name, unit, factor, default: usual, exponents }) {
    const { live } = this;
    const span = usualSpan(live, exponents ?? []) / factor;
    const set = (/** @type {HTMLInputElement} */ { value }) => {
      if (value.trim() !== "") live.set(kind, index, valueOf(Number(value), factor, usual ?? 0));
    };
    const { low, high, step } = rangeAround(fromSi(usual ?? 0, factor), span);
    const id = `${kind}-${index}`;
    const slider = element("input", { type: "range", id: `${id}-slider`, "aria-label": `${name}, slider`, min: low, max: high, step, oninput: () => set(slider) });
    const field = element("input", { type: "number", id, step: "any", onchange: () => set(field) });
    field.addEventListener("input", () => field.setAttribute("data-typed", ""));
    for (const end of ["change", "blur"]) field.addEventListener(end, () => field.removeAttribute("data-typed"));
    const label = element("label", { for: id }, name);
    // In a page with the text of the mechanism the value is written there.
    const write = element("button", { type: "button", class: "write", id: `${id}-write`, hidden: true, title: `${name} has this value in the text` }, "Write into the text");
    write.addEventListener("click", () => this.app.sketch?.make(`write ${name}`, { kind: "set", name, value: live.settings[kind][index] }));
    this.dials.push({ kind, index, factor, slider, field, write, usual: usual ?? null });
    return element("div", { class: "dial" }, label, slider, field, element("span", { class: "faint" }, typeset(unit)), write);
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
    if (this.hint !== undefined) setText(this.hint, handHint(app));
    if (this.revision !== live.revision) {
      this.revision = live.revision;
      for (const dial of this.dials) this.turn(dial);
    }
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

  /** Shows a value, with its slider made longer where it stands outside. @param {Dial} dial */
  turn({ kind, index, factor, slider, field, write, usual }) {
    const value = this.live.settings[kind][index];
    const shown = fromSi(value ?? NaN, factor);
    write.hidden = this.app.sketch === null || usual === null || value === usual;
    if (!Number.isFinite(shown)) return;
    showIn(field, String(shown));
    if (document.activeElement === slider && Math.abs(Number(slider.value) - shown) <= 0.51 * Number(slider.step)) return;
    if (shown > Number(slider.max)) slider.max = String(shown);
    if (shown < Number(slider.min)) slider.min = String(shown);
    slider.value = String(shown);
  }
}

/**
 * Shows a value in a field, but never over what is being typed. In a field with the focus it stands selected, so that typing
 * replaces it: a field with another text loses its selection, and what is typed would be added.
 * @param {HTMLInputElement} field
 * @param {string} text
 */
function showIn(field, text) {
  const hasFocus = document.activeElement === field;
  if (field.value === text || (hasFocus && field.dataset["typed"] !== undefined)) return;
  field.value = text;
  if (hasFocus) field.select();
}

/** From 0 to twice the usual value, in a hundred steps to each side; around 0 by a span. @param {number} usual @param {number} span */
export function rangeAround(usual, span) {
  if (usual === 0 || !Number.isFinite(usual)) return { low: -span, high: span, step: span / 100 };
  const step = Number((Math.abs(usual) / 100).toPrecision(12));
  const far = Number((200 * step).toPrecision(12));
  return usual > 0 ? { low: 0, high: far, step } : { low: -far, high: 0, step };
}

/**
 * Half the range of a slider for a quantity that is usually 0, SI: the weight of all for a force, that at an arm as long as a
 * body for a torque.
 * @param {Live} live
 * @param {number[]} exponents of m, kg, s, …
 */
function usualSpan(live, [metre, kilogram, second]) {
  const weight = 9.81 * live.mechanism.bodies.reduce((sum, { mass }) => sum + mass, 0);
  const isForce = kilogram === 1 && second === -2 && (metre === 1 || metre === 2);
  return isForce && weight > 0 ? niceNear(weight * live.size() ** (metre - 1)) : 1;
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
