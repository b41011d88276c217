// Sliders and fields of the parameters and inputs of a live mechanism.

import { element } from "./dom.js";
import { fromSi, niceNear } from "./numbers.js";
import { valueOf } from "./settings.js";
import { typeset } from "./text.js";

/** @import {Input, Parameter} from "./format.js" */
/** @import {Live} from "./live.js" */

/**
 * A quantity that is set by a slider and by a number, in its declared unit.
 * @typedef {{kind: "parameter" | "input", index: number, factor: number, slider: HTMLInputElement, field: HTMLInputElement, write: HTMLButtonElement | null, usual: number | null}} Dial
 */

/**
 * The text of the mechanism, where the page has it.
 * @typedef {{isThere: () => boolean, write: (name: string, value: number) => void}} Text
 */

export class Dials {
  /** @param {Live} live @param {Text | null} [text] */
  constructor(live, text = null) {
    this.live = live;
    this.text = text;
    this.revision = -1;
    /** @type {Dial[]} */
    this.dials = [];
    const { parameters, inputs } = live.mechanism;
    /** @type {HTMLElement[]} */
    this.elements = [...this.dialGroup("Parameters", "parameter", parameters), ...this.dialGroup("Inputs", "input", inputs)];
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
    const write = this.text === null ? null : this.writer(this.text, kind, index, name);
    this.dials.push({ kind, index, factor, slider, field, write, usual: usual ?? null });
    return element("div", { class: "dial" }, label, slider, field, element("span", { class: "faint" }, typeset(unit)), ...(write === null ? [] : [write]));
  }

  /** @param {Text} text @param {"parameter" | "input"} kind @param {number} index @param {string} name */
  writer(text, kind, index, name) {
    const button = element("button", { type: "button", class: "write", id: `write-${kind}-${index}`, hidden: true, title: `${name} has this value in the text` }, "Write into the text");
    button.addEventListener("click", () => {
      const value = this.live.settings[kind][index];
      if (value !== undefined && value !== null) text.write(name, value);
    });
    return button;
  }

  update() {
    if (this.revision === this.live.revision) return;
    this.revision = this.live.revision;
    for (const dial of this.dials) this.turn(dial);
  }

  /** Shows a value, with its slider made longer where it stands outside. @param {Dial} dial */
  turn({ kind, index, factor, slider, field, write, usual }) {
    const value = this.live.settings[kind][index];
    const shown = fromSi(value ?? NaN, factor);
    if (write !== null) write.hidden = this.text?.isThere() !== true || usual === null || value === usual;
    if (!Number.isFinite(shown)) return;
    showIn(field, String(shown));
    if (slider.matches(":focus") && Math.abs(Number(slider.value) - shown) <= 0.51 * Number(slider.step)) return;
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
  const hasFocus = field.matches(":focus");
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
