// Panel of the tools: what is measured, ghost poses, instant centres, moving pictures.

import { element, setText } from "./dom.js";
import { MOST_GHOSTS } from "./ghosts.js";
import { bodyMark, isWhole, measured, measureName, measureOf, namedMarks, unitOf } from "./measure.js";
import { say } from "./say.js";
import { quantityText } from "./text.js";
import { setGhosts, startMeasure } from "./toolcommands.js";
import { removeMeasure } from "./toolpick.js";

/** @import {App} from "./app.js" */
/** @import {Mark, MeasureKind} from "./measure.js" */

export class ToolPanel {
  /**
   * @param {App} app
   * @param {HTMLElement} root
   * @param {() => void} openMovie
   */
  constructor(app, root, openMovie) {
    this.app = app;
    this.revision = -1;
    /** @type {{cell: HTMLElement, text: () => string}[]} */
    this.values = [];
    const press = (/** @type {MeasureKind} */ kind, /** @type {string} */ name) =>
      element("button", { type: "button", id: `measure-${kind}`, onclick: () => startMeasure(app, kind) }, name);
    this.modes = { distance: press("distance", "Distance"), angle: press("angle", "Angle") };
    this.chosen = [0, 1, 2].map((at) => element("select", { id: `mark-${at}`, "aria-label": ["From", "to", "and to"][at] }));
    const heads = ["measure", "now", "curve", ""].map((text) => element("th", { scope: "col" }, text));
    this.list = element("table", { class: "measures" }, element("thead", {}, element("tr", {}, ...heads)), element("tbody", {}));
    this.ghosts = element("input", { type: "range", id: "ghosts", min: 0, max: MOST_GHOSTS, oninput: () => setGhosts(app, Number(this.ghosts.value)) });
    this.ghostsText = element("output", { for: "ghosts" });
    this.pair = [0, 1].map((at) => element("select", { "aria-label": `Body ${at + 1} of a pair`, onchange: () => this.choosePair() }));
    this.boxes = { centres: this.box("centres", "of each body against the ground"), centrodes: this.box("centrodes", "with the centrodes of the selected body") };
    root.append(
      element("h2", {}, "Measure in the picture"),
      element("div", { class: "row" }, this.modes.distance, this.modes.angle),
      element("p", { class: "hint" }, "A distance is between two points, an angle between two bodies, or at the second of three points. Escape clears."),
      element("details", { class: "picker" }, element("summary", {}, "Choose by name"), ...this.chosen, element("button", { type: "button", id: "mark-add", onclick: () => this.add() }, "Measure")),
      this.list,
      element("h2", {}, "Ghost poses"),
      element("div", { class: "row" }, element("label", { for: "ghosts" }, "Number"), this.ghosts, this.ghostsText),
      element("h2", {}, "Instant centres"),
      this.boxes.centres,
      this.boxes.centrodes,
      element("div", { class: "across" }, element("span", {}, "Of two bodies"), ...this.pair),
      element("h2", {}, "Moving picture"),
      element("div", { class: "row" }, element("button", { type: "button", id: "open-movie", onclick: openMovie }, "Save as GIF or video …")),
    );
  }

  /** @param {"centres" | "centrodes"} what @param {string} name */
  box(what, name) {
    const input = element("input", {
      type: "checkbox",
      id: `show-${what}`,
      onchange: () => {
        this.app.tools[what] = input.checked;
        this.app.change();
      },
    });
    return element("label", { class: "row" }, input, name);
  }

  choosePair() {
    const { tools } = this.app;
    const names = this.pair.map(({ value }) => value);
    tools.pair = names[0] !== "" && names[1] !== "" && names[0] !== names[1] ? names : [];
    if (tools.pair.length > 0) tools.centres = true;
    this.app.change();
  }

  /** Marks that can be chosen by name. @returns {Mark[]} */
  marks() {
    const mechanism = this.app.run?.mechanism;
    return mechanism === undefined ? [] : [...namedMarks(mechanism), ...mechanism.bodies.map((_, body) => bodyMark(mechanism, body))];
  }

  /** What is chosen by name: two points, three points, or two bodies. */
  add() {
    const { app } = this;
    const all = this.marks();
    const marks = this.chosen.flatMap(({ value }) => (value === "" ? [] : [all[Number(value)]]));
    /** @type {MeasureKind} */
    const kind = marks.length === 3 || marks.some(({ point }) => point === null) ? "angle" : "distance";
    const isOneSort = new Set(marks.map(({ point }) => point === null)).size === 1 && new Set(marks).size === marks.length;
    if (!isOneSort || !isWhole(kind, marks)) {
      say(app, "Choose two or three points, or two bodies.");
      return;
    }
    const name = measureName({ kind, marks });
    if (!app.tools.measures.includes(name)) app.tools.measures.push(name);
    app.change();
  }

  update() {
    const { app, modes } = this;
    if (this.revision !== app.revision) {
      this.revision = app.revision;
      this.build();
    }
    for (const kind of /** @type {const} */ (["distance", "angle"])) {
      const isOn = String(app.mode === kind);
      if (modes[kind].getAttribute("aria-pressed") !== isOn) modes[kind].setAttribute("aria-pressed", isOn);
    }
    for (const { cell, text } of this.values) setText(cell, text());
  }

  build() {
    const { app } = this;
    const { tools, run } = app;
    const option = (/** @type {string} */ value, /** @type {string} */ name) => element("option", { value }, name);
    const marks = this.marks();
    for (const select of this.chosen) {
      const before = select.value;
      select.replaceChildren(option("", "–"), ...marks.map((mark, at) => option(String(at), mark.point === null ? `${mark.name} (body)` : mark.name)));
      select.value = before;
    }
    this.pair.forEach((select, at) => {
      select.replaceChildren(option("", "–"), ...(run?.mechanism.bodies ?? []).map(({ name }) => option(name, name)));
      select.value = tools.pair[at] ?? "";
    });
    for (const what of /** @type {const} */ (["centres", "centrodes"])) {
      const input = this.boxes[what].querySelector("input");
      if (input !== null) input.checked = tools[what];
    }
    if (Number(this.ghosts.value) !== tools.ghosts) this.ghosts.value = String(tools.ghosts);
    setText(this.ghostsText, tools.ghosts === 0 ? "none" : String(tools.ghosts));
    this.values = [];
    this.list.hidden = tools.measures.length === 0;
    this.list.tBodies[0].replaceChildren(...tools.measures.flatMap((name) => this.measureRow(name)));
  }

  /** @param {string} name */
  measureRow(name) {
    const { app } = this;
    const measure = app.run === null ? null : measureOf(app.run.mechanism, name);
    if (measure === null) return [];
    const cell = element("td", {});
    this.values.push({ cell, text: () => this.valueNow(name) });
    const box = element("input", { type: "checkbox", "aria-label": `Curve of ${name}`, checked: app.curves.includes(name), onchange: () => app.toggleName(app.curves, name) });
    const remove = element("button", { type: "button", class: "plain", title: `Remove ${name}`, "aria-label": `Remove ${name}`, onclick: () => removeMeasure(app, name) }, "×");
    const title = `${measure.kind} ${measure.marks.map((mark) => mark.name).join(", ")}`;
    return [element("tr", {}, element("th", { scope: "row" }, title), cell, element("td", {}, box), element("td", {}, remove))];
  }

  /** @param {string} name */
  valueNow(name) {
    const { run, scene, player } = this.app;
    const measure = run === null ? null : measureOf(run.mechanism, name);
    if (run === null || scene === null || measure === null || run.rows === 0) return "–";
    const { unit, factor } = unitOf(run, measure.kind);
    return quantityText(measured(measure, scene.at(Math.min(player.time, run.end)), run.mechanism) / factor, unit);
  }
}
