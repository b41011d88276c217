// The panel of objects: a list of all, and what is known of the one that is selected.

import { element, setText } from "./dom.js";
import { sameItem } from "./draw.js";
import { POSE_MEMBERS } from "./run.js";
import { framePose } from "./solid.js";
import { givenText, quantityText } from "./text.js";
import { scaleOf } from "./units.js";

/** @import {App} from "./app.js" */
/** @import {Frame, Mechanism} from "./format.js" */
/** @import {Item} from "./solid.js" */

/** A value that changes with the time. @typedef {{cell: HTMLElement, text: () => string}} LiveValue */

export class Objects {
  /**
   * @param {App} app
   * @param {HTMLElement} root
   */
  constructor(app, root) {
    this.app = app;
    this.revision = -1;
    /** @type {LiveValue[]} */
    this.values = [];
    this.list = element("select", { size: 7, "aria-label": "Objects", onchange: () => this.choose() });
    this.facts = element("div", { class: "facts" });
    root.append(this.list, this.facts, arrowControls(app));
  }

  choose() {
    const item = this.app.items()[Number(this.list.value)];
    this.app.select(item ?? null);
  }

  update() {
    if (this.revision !== this.app.revision) {
      this.revision = this.app.revision;
      this.build();
    }
    for (const { cell, text } of this.values) setText(cell, text());
  }

  build() {
    const { app } = this;
    const mechanism = app.run?.mechanism;
    this.values = [];
    const items = app.items();
    const options = mechanism === undefined ? [] : items.map((item, at) => new Option(itemTitle(mechanism, item), String(at)));
    this.list.replaceChildren(...options);
    this.list.value = String(items.findIndex((item) => sameItem(item, app.selected)));
    if (mechanism === undefined || app.selected === null) {
      const hint = app.run === null ? "" : "Click an object in the picture, or choose one above.";
      this.facts.replaceChildren(element("p", { class: "hint" }, hint));
      return;
    }
    const { kind, index } = app.selected;
    const facts = kind === "body" ? this.bodyFacts(index) : kind === "part" ? this.partFacts(index) : this.portFacts(index);
    this.facts.replaceChildren(element("h2", {}, itemTitle(mechanism, app.selected)), ...facts);
  }

  /** A cell whose text follows the time. @param {() => string} text */
  live(text) {
    const cell = element("td", {});
    this.values.push({ cell, text });
    return cell;
  }

  /** @param {number} index */
  bodyFacts(index) {
    const { app } = this;
    const body = /** @type {Mechanism} */ (app.run?.mechanism).bodies[index];
    const rows = [
      factRow("mass", givenText(body.mass, "kg")),
      factRow("moment of inertia about G", givenText(body.inertia, "kg*m^2")),
      factRow("depth", this.lengthText(body.depth)),
      ...POSE_MEMBERS.flatMap(([member, unit], axis) => {
        // Where G is stands among the points.
        if (axis < 2) return [];
        const text = () => this.shown(`${body.name}.${member}`, unit, this.poseNow(index, axis));
        return [element("tr", {}, element("th", { scope: "row" }, memberName(member)), this.live(text))];
      }),
    ];
    return [
      element("table", {}, element("tbody", {}, ...rows)),
      element("h3", {}, "Points"),
      this.pointTable(index),
    ];
  }

  /** A value in the declared unit. @param {string} name @param {string} si @param {number} value SI */
  shown(name, si, value) {
    const { run } = this.app;
    const { unit, factor } = run === null ? { unit: si, factor: 1 } : scaleOf(run, name, si);
    return quantityText(value / factor, unit);
  }

  /** @param {number} length m */
  lengthText(length) {
    return this.shown("", "m", length);
  }

  /** @param {number} body @param {number} axis */
  poseNow(body, axis) {
    const { run, player } = this.app;
    if (run === null || run.rows === 0) return NaN;
    const moment = run.momentAt(Math.min(player.time, run.end));
    const read = (/** @type {number} */ row) => run.poses.at(row, 6 * body + axis);
    return run.valueAt({ name: "", unit: "", read }, moment);
  }

  /** Ports, where they are now, and whether their path is drawn. @param {number} index of the body */
  pointTable(index) {
    const { app } = this;
    const body = /** @type {Mechanism} */ (app.run?.mechanism).bodies[index];
    const points = [{ name: "G", port: /** @type {number | null} */ (null) }, ...body.ports.map(({ name }, port) => ({ name, port }))];
    const rows = points.map(({ name, port }) => {
      const full = `${body.name}.${name}`;
      const box = element("input", {
        type: "checkbox",
        "aria-label": `Path of ${full}`,
        checked: app.traces.includes(full),
        onchange: () => app.toggleName(app.traces, full),
      });
      const place = (/** @type {number} */ axis) =>
        this.live(() => this.shown(`${full}.${"xy"[axis]}`, "m", this.frameNow({ argument: "", body: index, port })[axis]));
      return element("tr", {}, element("th", { scope: "row" }, name), place(0), place(1), element("td", {}, box));
    });
    const heads = ["point", "x", "y", "path"].map((text) => element("th", { scope: "col" }, text));
    return element("table", {}, element("thead", {}, element("tr", {}, ...heads)), element("tbody", {}, ...rows));
  }

  /** @param {Frame} frame */
  frameNow(frame) {
    const { scene, player } = this.app;
    if (scene === null || scene.run.rows === 0) return [NaN, NaN, NaN];
    const places = scene.at(Math.min(player.time, scene.run.end));
    return framePose(scene.mechanism, frame, places);
  }

  /** @param {number} index */
  partFacts(index) {
    const { app } = this;
    const mechanism = /** @type {Mechanism} */ (app.run?.mechanism);
    const part = mechanism.parts[index];
    const frames = part.frames.map((frame) => factRow(frame.argument, frameName(mechanism, frame)));
    const sizes = Object.entries(part.sizes).map(([name, size]) => factRow(name.replaceAll("_", " "), this.lengthText(size)));
    const own = (app.run?.quantities() ?? []).filter(({ name }) => name.startsWith(`${part.name}.`));
    const values = own.map((quantity) => {
      const text = () => {
        const { run, player } = app;
        if (run === null || run.rows === 0) return "–";
        return quantityText(run.valueAt(quantity, run.momentAt(Math.min(player.time, run.end))), quantity.unit);
      };
      const box = element("input", {
        type: "checkbox",
        "aria-label": `Curve of ${quantity.name}`,
        checked: app.curves.includes(quantity.name),
        onchange: () => app.toggleName(app.curves, quantity.name),
      });
      const name = quantity.name.slice(part.name.length + 1);
      return element("tr", {}, element("th", { scope: "row" }, name), this.live(text), element("td", {}, box));
    });
    const kind = part.pair !== null && part.pair !== part.kind ? `${part.kind} (${part.pair})` : part.kind;
    return [
      element("table", {}, element("tbody", {}, factRow("kind", kind.replaceAll("_", " ")), ...frames, ...sizes)),
      ...(values.length > 0 ? [element("h3", {}, "Quantities and their curves"), element("table", {}, element("tbody", {}, ...values))] : []),
    ];
  }

  /** @param {number} index of a port of the ground */
  portFacts(index) {
    const port = /** @type {Mechanism} */ (this.app.run?.mechanism).ground[index];
    const place = (/** @type {number} */ axis) => () => this.lengthText(this.frameNow({ argument: "", body: null, port: index })[axis]);
    const rows = ["x", "y"].map((name, axis) =>
      element("tr", {}, element("th", { scope: "row" }, name), this.live(place(axis))),
    );
    return [element("table", {}, element("tbody", {}, ...rows, factRow("depth", this.lengthText(port.depth))))];
  }
}

/**
 * `arm, body`, `elbow, revolute`, `ground.o0`.
 * @param {Mechanism} mechanism
 * @param {Item} item
 */
export function itemTitle(mechanism, { kind, index }) {
  if (kind === "body") return `${mechanism.bodies[index].name}, body`;
  if (kind === "part") return `${mechanism.parts[index].name}, ${mechanism.parts[index].kind.replaceAll("_", " ")}`;
  return `ground.${mechanism.ground[index].name}`;
}

/** @param {Mechanism} mechanism @param {Frame} frame */
function frameName(mechanism, { body, port }) {
  const ports = body === null ? mechanism.ground : mechanism.bodies[body].ports;
  const owner = body === null ? "ground" : mechanism.bodies[body].name;
  return port === null ? owner : `${owner}.${ports[port].name}`;
}

/** @param {string} member */
function memberName(member) {
  return { angle: "angle", omega: "angular velocity" }[member] ?? `${member} of G`;
}

/** @param {string} name @param {string} value */
export function factRow(name, value) {
  return element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, value));
}

/** The length of arrows, on a logarithmic slider. @param {App} app */
function arrowControls(app) {
  const slider = element("input", {
    type: "range",
    id: "arrows",
    min: -1.5,
    max: 1.5,
    step: 0.1,
    value: Math.log10(app.arrowFactor),
    oninput: () => {
      app.arrowFactor = 10 ** Number(slider.value);
      app.touch();
    },
  });
  return element("label", { class: "row" }, "Length of arrows", slider);
}
