// The panel of the model: what it is, how it is computed, its parameters.

import { element } from "./dom.js";
import { factRow } from "./objects.js";
import { fromSi } from "./numbers.js";
import { typeset } from "./text.js";

/** @import {App} from "./app.js" */
/** @import {Parameter, Report} from "./format.js" */

export class Model {
  /**
   * @param {App} app
   * @param {HTMLElement} root
   */
  constructor(app, root) {
    this.app = app;
    this.root = root;
    this.revision = -1;
  }

  update() {
    if (this.revision === this.app.revision) return;
    this.revision = this.app.revision;
    const { run, madeBy } = this.app;
    if (run === null) {
      this.root.replaceChildren();
      return;
    }
    const { mechanism } = run;
    const facts = [
      ...(mechanism.report === null ? [] : reportRows(mechanism.report)),
      factRow("method", run.head.method || "not recorded"),
      factRow("moments", `${run.rows} recorded`),
      factRow("made by", madeBy || "not recorded"),
    ];
    this.root.replaceChildren(
      element("h2", {}, mechanism.name),
      ...(mechanism.doc === "" ? [] : [element("p", { class: "doc" }, mechanism.doc)]),
      element("table", {}, element("tbody", {}, ...facts)),
      element("h2", {}, "Parameters"),
      parameterTable(mechanism.parameters),
    );
  }
}

/** @param {Report} report */
function reportRows(report) {
  return [
    factRow("degrees of freedom", String(report.degrees_of_freedom)),
    factRow("formulation", report.formulation),
    factRow("because", report.reason),
    factRow("to evaluate the equations once", operationsText(report.operations ?? {})),
  ];
}

/** What operations are called, one and several. @type {{[name: string]: [string, string]}} */
const OPERATIONS = {
  add: ["addition", "additions"],
  mul: ["multiplication", "multiplications"],
  div: ["division", "divisions"],
  sqrt: ["square root", "square roots"],
  sin_cos: ["sine with its cosine", "sines with their cosines"],
  other: ["other operation", "other operations"],
};

/** @param {{[name: string]: number}} operations */
function operationsText(operations) {
  const counted = Object.entries(operations).filter(([, count]) => count > 0);
  return counted.map(([name, count]) => `${count} ${OPERATIONS[name]?.[count === 1 ? 0 : 1] ?? name}`).join(", ");
}

/** A value as it would be typed. @param {number} value SI @param {number} factor @param {string} unit */
function exactText(value, factor, unit) {
  return `${String(fromSi(value, factor)).replace("-", "−")} ${typeset(unit)}`.trim();
}

/** @param {Parameter[]} parameters */
function parameterTable(parameters) {
  if (parameters.length === 0) return element("p", { class: "hint" }, "None.");
  const rows = parameters.map(({ name, unit, factor, value, default: usual }) => {
    const isChanged = value !== usual;
    const text = exactText(value, factor, unit);
    const note = isChanged ? ` (declared: ${exactText(usual, factor, unit)})` : "";
    return element("tr", { class: isChanged ? "changed" : null }, element("th", { scope: "row" }, name), element("td", {}, text + note));
  });
  return element("table", {}, element("tbody", {}, ...rows));
}
