// The panel of the model: what it is, how it is computed, its parameters.

import { element } from "./dom.js";
import { factRow } from "./objects.js";
import { quantityText } from "./text.js";

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
      factRow("rows", String(run.rows)),
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
  const operations = Object.entries(report.operations ?? {}).filter(([, count]) => count > 0);
  return [
    factRow("degrees of freedom", String(report.degrees_of_freedom)),
    factRow("formulation", report.formulation),
    factRow("because", report.reason),
    factRow("operations a rate", operations.map(([name, count]) => `${count} ${name}`).join(", ")),
  ];
}

/** @param {Parameter[]} parameters */
function parameterTable(parameters) {
  if (parameters.length === 0) return element("p", { class: "hint" }, "None.");
  const rows = parameters.map(({ name, unit, factor, value, default: usual }) => {
    const isChanged = value !== usual;
    const text = quantityText(value / factor, unit);
    const note = isChanged ? ` (usually ${quantityText(usual / factor, unit)})` : "";
    return element("tr", { class: isChanged ? "changed" : null }, element("th", { scope: "row" }, name), element("td", {}, text + note));
  });
  return element("table", {}, element("tbody", {}, ...rows));
}
