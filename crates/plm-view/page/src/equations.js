// The panel of the equations of motion of what moves. They are asked for while it is open, of a worker of their own.

import { element, setText } from "./dom.js";
import { Language } from "./language.js";

/** @import {App} from "./app.js" */
/** @import {Carrier, Exchange} from "./exchange.js" */
/** @import {Written} from "./language.js" */

/** Letters of MathML that are shown at most: more of them take a browser longer than a second. */
const MOST_LETTERS = 400_000;

export class EquationsTab {
  /**
   * @param {App} app
   * @param {Exchange} exchange
   * @param {() => Carrier} start starts a worker that has the module
   * @param {HTMLElement} sheet
   */
  constructor(app, exchange, start, sheet) {
    this.app = app;
    this.exchange = exchange;
    this.start = start;
    /** The text whose equations are shown or were asked for. @type {string | null} */
    this.text = null;
    this.isAsked = false;
    this.latex = "";
    /** Begins with the panel's first opening. @type {Language | null} */
    this.language = null;
    this.copy = element("button", { type: "button", id: "equations-copy", disabled: true, onclick: () => void this.copyLatex() }, "Copy LaTeX");
    this.told = element("p", { id: "equations-told", role: "status" });
    this.place = element("div", { id: "equations" });
    sheet.append(element("div", { class: "row" }, this.copy), this.told, this.place);
  }

  update() {
    const { text } = this.exchange;
    // While a hand holds numbers they are parameters of another text.
    if (text === this.text || this.isAsked || this.app.live?.isLifted === true) return;
    this.text = text;
    if (text === null) this.show({ why: "nothing moves" });
    else void this.ask(text);
  }

  /** @param {string} text */
  async ask(text) {
    this.language ??= new Language(this.start, () => {});
    this.isAsked = true;
    if (this.latex === "") setText(this.told, "They are being written …");
    const found = await this.language.equations(text);
    this.isAsked = false;
    this.show(found);
    // Another text may move by now.
    this.app.touch();
  }

  /** @param {Written | {why: string}} found */
  show(found) {
    const isThere = "latex" in found;
    this.latex = isThere ? found.latex : "";
    this.copy.disabled = !isThere;
    setText(this.told, isThere ? found.notes.join(" ") : `There are none: ${found.why.split("\n")[0]}.`);
    this.place.replaceChildren(...(isThere ? equationElements(found) : []));
  }

  async copyLatex() {
    await navigator.clipboard.writeText(this.latex);
    setText(this.copy, "Copied");
    setTimeout(() => setText(this.copy, "Copy LaTeX"), 1500);
  }
}

/** What the symbols are, and the equations. @param {Written} written */
function equationElements({ coordinates, mathml }) {
  const symbols = coordinates.flatMap(([path, symbol]) => [mathOf("dt", `<math>${symbol}</math>`), element("dd", {}, path)]);
  const shown = mathml.filter((_, at) => mathml.slice(0, at + 1).join("").length <= MOST_LETTERS);
  const left = mathml.length - shown.length;
  return [
    element("dl", {}, ...symbols),
    ...shown.map((equation) => {
      const line = mathOf("p", equation);
      splitTerms(line);
      return line;
    }),
    ...(left === 0 ? [] : [element("p", { class: "hint" }, `${left} more: LaTeX has all of them.`)]),
  ];
}

/** An element with a formula of the compiler. @param {"p" | "dt"} tag @param {string} math */
function mathOf(tag, math) {
  const made = element(tag);
  made.innerHTML = math;
  return made;
}

/** Splits an equation into terms, so that a line can end in front of a sign. @param {HTMLElement} line */
function splitTerms(line) {
  const equation = line.firstElementChild;
  if (equation === null) return;
  /** @type {Element[][]} */
  const terms = [[]];
  for (const part of equation.children) {
    // A sign of its own is one of a number.
    const isSign = part.localName === "mo" && part.getAttribute("form") === null;
    if (isSign) {
      // It stays between what it joins, though it begins a formula now.
      part.setAttribute("form", "infix");
      terms.push([]);
    }
    terms.at(-1)?.push(part);
  }
  equation.setAttribute("display", "inline");
  equation.setAttribute("displaystyle", "true");
  const made = terms.map((parts) => {
    const term = /** @type {Element} */ (equation.cloneNode());
    term.append(...parts);
    return term;
  });
  line.replaceChildren(...made.flatMap((term) => [term, " "]));
}
