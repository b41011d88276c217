// The tools of drawing over the picture, and the dimensions of the pin that is chosen.

import { element, setText } from "./dom.js";
import { belongsTo, keyName } from "./keys.js";
import { drawingKeyWords, obeyDrawingKey } from "./sketchkeys.js";
import { millimetres, portKey } from "./snap.js";

/** @import {PlacedPort} from "./pencil.js" */
/** @import {Sketch, SketchTool} from "./sketch.js" */

/**
 * @typedef {{tool: SketchTool, label: string, title: string, key: string}} ToolRow
 * @typedef {"x" | "y" | "length" | "angle"} Dimension
 */

/** Tools that have a button, and the key of each while somebody draws. @type {ToolRow[]} */
const SKETCH_TOOLS = [
  { tool: "move", label: "Move", title: "Drag a pin; onto another one, and they are joined. Alt: bars keep their poses", key: "V" },
  { tool: "bar", label: "Bar", title: "Two places make a bar. Shift: an end on the ground", key: "B" },
  { tool: "point", label: "Point", title: "A bar, then where it gets another pin; on a pin, they are joined. Shift: on the ground", key: "P" },
  { tool: "ground", label: "Ground", title: "A pin becomes one of the ground", key: "G" },
  { tool: "slide", label: "Slider", title: "A pin, then the direction in which it slides, or the bar along which it slides", key: "L" },
  { tool: "motor", label: "Motor", title: "A bar that turns", key: "M" },
];

/**
 * The dimensions of a pin, for reading: its place, and of the end of a bar its length and its direction.
 * @param {PlacedPort} place
 * @param {PlacedPort[]} places
 * @returns {{[dimension in Dimension]?: string}}
 */
function dimensionsOf(place, places) {
  const values = { x: millimetres(place.at[0]), y: millimetres(place.at[1]) };
  const others = places.filter((each) => each.owner === place.owner && each.owner !== "ground" && each.port !== place.port);
  if (others.length !== 1) return values;
  const [dx, dy] = [place.at[0] - others[0].at[0], place.at[1] - others[0].at[1]];
  return { ...values, length: millimetres(Math.hypot(dx, dy)), angle: String(Number(((Math.atan2(dy, dx) * 180) / Math.PI).toFixed(3)) + 0) };
}

export class SketchBar {
  /** @param {Sketch} sketch @param {HTMLElement} stage */
  constructor(sketch, stage) {
    this.sketch = sketch;
    const { app } = sketch;
    /** @type {{tool: SketchTool, button: HTMLButtonElement}[]} */
    this.tools = SKETCH_TOOLS.map(({ tool, label, title, key }) => ({ tool, button: this.button(label, `${title} (${key})`, () => sketch.take(tool), `sketch-${tool}`) }));
    this.draw = this.button("Draw", "Draw in the picture: what is drawn is written (Shift+W)", () => sketch.toggle(), "sketch-draw");
    this.remove = this.button("Delete", "Take away what is selected (Delete)", () => sketch.remove(), "sketch-delete");
    this.name = this.button("Rename", "Another name for what is selected (F2)", () => this.askName(), "sketch-rename");
    this.more = element("select", { id: "sketch-more", "aria-label": "Parts between two pins", onchange: () => this.takeMore() }, element("option", { value: "" }, "Part …"));
    this.copy = this.button("Copy", "What is selected again, beside itself (Ctrl+D)", () => sketch.copy(), "sketch-copy");
    this.mirror = this.button("Mirror", "The chosen pin of two bars on the other side (I)", () => sketch.mirror(), "sketch-mirror");
    const undo = this.button("Undo", "Undo (Ctrl+Z)", () => app.history.undo(), "sketch-undo");
    this.only = element("span", { class: "only" }, ...this.tools.map(({ button }) => button), this.more, this.remove, this.name, this.copy, this.mirror, undo);
    this.hint = element("p", { id: "sketch-hint", role: "status" });
    this.fields = element("form", { id: "sketch-fields", hidden: true, "aria-label": "Dimensions", onsubmit: (/** @type {Event} */ event) => event.preventDefault() });
    this.fieldsOf = "";
    /** @type {Map<Dimension, HTMLInputElement>} */
    this.inputs = new Map();
    stage.append(element("div", { id: "sketch", role: "toolbar", "aria-label": "Drawing" }, this.draw, this.only), this.hint, this.fields);
    sketch.onChange = () => this.update();
    this.listen();
    this.update();
  }

  /** @param {string} label @param {string} title @param {() => void} act @param {string} id */
  button(label, title, act, id) {
    const onclick = () => {
      act();
      this.update();
      this.sketch.app.touch();
    };
    return element("button", { type: "button", id, title, onclick }, label);
  }

  /** Parts that join two pins are rows of a table of the compiler, which is asked once somebody draws. */
  fillParts() {
    if (this.more.options.length > 1) return;
    const known = this.sketch.pencil.ask("", { kind: "tools" });
    if (Array.isArray(known)) for (const { tool, title } of known) this.more.append(element("option", { value: tool }, title));
  }

  takeMore() {
    if (this.more.value !== "") this.sketch.take(this.more.value);
    else this.sketch.take("move");
  }

  /** Brought up to date in every frame. */
  update() {
    const { sketch } = this;
    const { isOn, tool } = sketch;
    this.draw.setAttribute("aria-pressed", String(isOn));
    this.only.hidden = !isOn;
    if (isOn) this.fillParts();
    for (const each of this.tools) each.button.setAttribute("aria-pressed", String(each.tool === tool));
    const row = this.tools.some((each) => each.tool === tool);
    if (row !== (this.more.value === "")) this.more.value = row ? "" : tool;
    this.remove.disabled = this.name.disabled = this.copy.disabled = !sketch.canRemove;
    this.mirror.disabled = sketch.chosen === null;
    if (sketch.isCurrent && sketch.waiting.some((part) => part !== 0)) sketch.nudge([0, 0]);
    setText(this.hint, isOn ? this.words() : "");
    this.hint.hidden = !isOn || this.hint.textContent === "";
    this.updateFields();
  }

  /** What a press does now, and a key. */
  words() {
    return `${this.pressWords()}${drawingKeyWords(this.sketch)}`;
  }

  pressWords() {
    const { sketch } = this;
    const { tool, from, app } = sketch;
    if (sketch.isMoving && sketch.held === null) return "It moves: a press brings it back to its start.";
    if (tool === "bar") return from === null ? "Press where a bar begins: on a pin, or anywhere. Shift: on the ground." : "Press where it ends.";
    if (tool === "point") return from === null ? "Press the bar that gets another pin." : "Press where its pin is.";
    if (tool === "ground") return "Press a pin: the ground holds it. Elsewhere: a place of the ground, for springs.";
    if (tool === "motor") return "Press a bar, or its pin: it turns.";
    if (tool === "slide") return from === null ? "Press the pin that slides." : "Press in the direction in which it slides, or a bar: along it.";
    if (tool !== "move") return from === null ? "Press one pin." : "Press the other pin.";
    return app.run === null ? "Nothing is drawn yet: take Bar." : "";
  }

  /** Dimensions stand beside the pin. */
  updateFields() {
    const { sketch, fields } = this;
    const { chosen, app } = sketch;
    const places = sketch.isOn && chosen !== null && sketch.held === null ? sketch.places() : [];
    const place = places.find((each) => chosen !== null && portKey(each) === portKey(chosen));
    fields.hidden = place === undefined;
    if (place === undefined) {
      this.fieldsOf = "";
      return;
    }
    const [x, y] = app.view.projection(app.area).point(place.at[0], place.at[1], 0);
    const [width, height] = [fields.offsetWidth || 180, fields.offsetHeight || 120];
    fields.style.left = `${Math.max(4, Math.min(x + 16, app.area.width - width - 4))}px`;
    fields.style.top = `${Math.max(48, Math.min(y + 12, app.area.height - height - 4))}px`;
    const values = dimensionsOf(place, places);
    const { locks } = sketch;
    const of = `${portKey(place)} ${Object.keys(values)} ${locks}`;
    if (this.fieldsOf !== of) {
      this.fieldsOf = of;
      this.inputs = new Map();
      fields.replaceChildren(element("b", {}, portKey(place)), ...Object.keys(values).map((dimension) => this.field(/** @type {Dimension} */ (dimension))), this.locks(Object.keys(values), locks));
    }
    for (const [dimension, input] of this.inputs) {
      const value = values[dimension] ?? "";
      // What is typed stays until it is entered.
      if (input.dataset["value"] === value || input === document.activeElement) continue;
      input.dataset["value"] = value;
      input.value = value;
    }
  }

  /** Padlocks come behind all fields, so that Tab goes from number to number. @param {string[]} dimensions @param {string[]} locked */
  locks(dimensions, locked) {
    const lock = (/** @type {string} */ dimension) => {
      const name = dimension.length === 1 ? dimension.toUpperCase() : dimension;
      const isLocked = locked.includes(dimension);
      const title = isLocked ? `Unlock ${name}: it becomes a number again, which a hand moves` : `Lock ${name}: it becomes a parameter, with a slider; a hand keeps it then`;
      const button = this.button(name, title, () => this.sketch.lock(dimension), `sketch-lock-${dimension}`);
      button.setAttribute("aria-label", `${isLocked ? "Unlock" : "Lock"} ${name}`);
      button.setAttribute("aria-pressed", String(isLocked));
      return button;
    };
    return element("div", { class: "locks" }, element("span", {}, "Lock"), ...dimensions.map(lock));
  }

  /** @param {Dimension} dimension */
  field(dimension) {
    const unit = dimension === "angle" ? "deg" : "mm";
    const input = element("input", { type: "text", inputmode: "decimal", autocomplete: "off", "data-dimension": dimension });
    this.inputs.set(dimension, input);
    const apply = () => {
      if (input.value === input.dataset["value"]) return;
      // A number alone is one of the unit that stands here.
      const typed = /^[-+.\deE]+$/.test(input.value.trim()) ? `${input.value.trim()} ${unit}` : input.value;
      if (this.sketch.type(dimension, typed)) input.dataset["value"] = input.value;
    };
    input.addEventListener("change", apply);
    input.addEventListener("keydown", (event) => {
      if (event.key === "Escape") input.value = input.dataset["value"] ?? "";
      if (event.key !== "Enter" && event.key !== "Escape") return;
      event.stopPropagation();
      apply();
      input.blur();
      this.sketch.app.touch();
    });
    const label = dimension === "length" || dimension === "angle" ? dimension : dimension.toUpperCase();
    return element("label", {}, element("span", {}, label), input, element("span", { class: "faint" }, unit));
  }

  /** A field for the name of what is selected. */
  askName() {
    const { sketch } = this;
    const name = sketch.chosen?.port ?? sketch.selectedName;
    if (name === null) return;
    const input = element("input", { type: "text", value: name, "aria-label": "Name", autocomplete: "off" });
    const form = element("form", { id: "sketch-name" }, input);
    let isOver = false;
    const end = () => {
      if (isOver) return;
      isOver = true;
      form.remove();
    };
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (input.value === name || sketch.rename(input.value)) end();
    });
    input.addEventListener("keydown", (event) => event.key === "Escape" && end());
    input.addEventListener("blur", end);
    this.hint.before(form);
    input.select();
  }

  /** Keys of drawing come before the other ones. */
  listen() {
    const { sketch } = this;
    // Whoever takes the pointer again leaves the keyboard.
    document.addEventListener("pointermove", () => {
      if (!sketch.isByKeys) return;
      [sketch.isByKeys, sketch.cursor] = [false, null];
      this.update();
    });
    document.addEventListener("keydown", (event) => {
      const target = event.target instanceof HTMLElement ? event.target : document.body;
      const name = keyName(event);
      if (!sketch.isOn || event.defaultPrevented || document.querySelector("dialog[open]") !== null || belongsTo(target, name)) return;
      if (!this.obey(name, target !== document.body && target.id !== "picture")) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      this.update();
      sketch.app.touch();
    });
  }

  /** Whether a key means something here. @param {string} name @param {boolean} isButton whether something else has the focus than the picture */
  obey(name, isButton) {
    const { sketch } = this;
    const row = SKETCH_TOOLS.find(({ key }) => key === name);
    if (name === "Escape") return this.letGo();
    if (!isButton && obeyDrawingKey(sketch, name)) return true;
    if (name === "Enter" && !isButton && sketch.chosen !== null) {
      const first = this.fields.querySelector("input");
      first?.focus();
      first?.select();
      return true;
    }
    if (name === "Ctrl+D" || name === "I") {
      if (name === "I" && (sketch.chosen === null || !sketch.app.hasPlainKeys)) return false;
      if (name === "I") sketch.mirror();
      else sketch.copy();
      return true;
    }
    if (name === "Delete" || name === "Backspace") {
      if (!sketch.canRemove) return false;
      sketch.remove();
    } else if (name === "F2") this.askName();
    else if (/^[-.\d]$/.test(name) && sketch.chosen !== null) this.begin(name);
    else if (row !== undefined && sketch.app.hasPlainKeys) sketch.take(row.tool);
    else return false;
    return true;
  }

  /** What is begun, else the tool, else the chosen pin. */
  letGo() {
    const { sketch } = this;
    if (sketch.cancel()) return true;
    if (sketch.tool !== "move") sketch.take("move");
    else if (sketch.chosen !== null) sketch.choose(null);
    else return false;
    return true;
  }

  /** A digit begins the first dimension. @param {string} digit */
  begin(digit) {
    const input = this.fields.querySelector("input");
    if (input === null) return;
    input.focus();
    input.value = digit;
  }
}
