// Polar plot under the curves: which force, how, and the plot.

import { element, fitCanvas, saveBlob } from "./dom.js";
import { CanvasPen, SvgPen } from "./pen.js";
import { fileStem } from "./picture.js";
import { drawPolar, forceJoints, polarCurve, polarPoints, polarText } from "./polar.js";

/** @import {App} from "./app.js" */
/** @import {Pen} from "./pen.js" */
/** @import {PolarCurve} from "./polar.js" */

const POLAR_HEIGHT = 280;
/** Points of a run that grows are read anew so often, ms. */
const REREAD_EVERY = 120;

export class PolarPlot {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.revision = -1;
    this.joint = element("select", { id: "polar-joint", onchange: () => this.choose() });
    this.around = element("select", { id: "polar-around", "aria-label": "How the force is drawn", onchange: () => this.choose() });
    this.canvas = element("canvas", { id: "polar", role: "img" });
    this.figure = element("div", { class: "polar" }, this.canvas, element("button", { type: "button", onclick: () => this.save() }, "Save polar plot (SVG)"));
    this.row = element("label", { class: "across" }, element("span", {}, "Force in the plane"), this.joint);
    this.root = element("div", {}, this.row, this.around, this.figure);
    this.canvas.style.height = `${POLAR_HEIGHT}px`;
    /** @type {PolarCurve | null} */
    this.curve = null;
    this.read = { version: -1, at: 0, points: { largest: 0, pieces: /** @type {number[][]} */ ([]) } };
  }

  choose() {
    const { tools } = this.app;
    [tools.force, tools.around] = [this.joint.value, this.around.value];
    this.app.change();
  }

  update() {
    const { app } = this;
    if (this.revision !== app.revision) {
      this.revision = app.revision;
      this.build();
    }
    if (this.curve !== null) this.draw();
  }

  build() {
    const { run, tools } = this.app;
    const joints = run === null ? [] : forceJoints(run);
    this.row.hidden = joints.length === 0;
    const option = (/** @type {string} */ value, /** @type {string} */ name) => element("option", { value }, name);
    this.joint.replaceChildren(option("", "not drawn"), ...joints.map((name) => option(name, name)));
    const bodies = run?.mechanism.bodies ?? [];
    this.around.replaceChildren(option("", "its vector (hodograph)"), ...bodies.map(({ name }) => option(name, `its magnitude around ${name}.angle`)));
    const isNew = this.curve === null;
    this.curve = run === null || !joints.includes(tools.force) ? null : polarCurve(run, { joint: tools.force, body: tools.around || null });
    [this.joint.value, this.around.value] = [this.curve === null ? "" : tools.force, tools.around];
    this.around.hidden = this.curve === null;
    this.figure.hidden = this.curve === null;
    this.read.version = -1;
    if (isNew && this.curve !== null) this.figure.scrollIntoView({ block: "nearest" });
  }

  draw() {
    const { app, canvas } = this;
    const width = canvas.clientWidth;
    if (width === 0) return;
    const context = fitCanvas(canvas, width, POLAR_HEIGHT);
    context.clearRect(0, 0, width, POLAR_HEIGHT);
    this.paint(new CanvasPen(context), width, true);
    const { run, player } = app;
    if (run === null || this.curve === null || app.isPlaying) return;
    const text = polarText(this.curve.read(run.momentAt(player.time)), this.curve);
    if (canvas.getAttribute("aria-label") !== text) canvas.setAttribute("aria-label", text);
  }

  /** @param {Pen} pen @param {number} width @param {boolean} hasNow */
  paint(pen, width, hasNow) {
    const { curve, read } = this;
    const { run, player, palette, tools } = this.app;
    if (run === null || curve === null || run.rows === 0) return;
    const clock = performance.now();
    if (read.version !== run.version && (read.version < 0 || clock - read.at > REREAD_EVERY)) {
      this.read = { version: run.version, at: clock, points: polarPoints(run, curve) };
    }
    const now = hasNow && player.time <= run.end ? curve.read(run.momentAt(player.time)) : null;
    drawPolar(pen, { x: 0, y: 0, width, height: POLAR_HEIGHT }, this.read.points, { palette, curve, isAngular: tools.around !== "", now });
  }

  save() {
    const { app } = this;
    const pen = new SvgPen();
    this.paint(pen, POLAR_HEIGHT + 60, false);
    const text = pen.finish(POLAR_HEIGHT + 60, POLAR_HEIGHT, app.palette.background, this.curve?.title ?? "");
    saveBlob(new Blob([text], { type: "image/svg+xml" }), `${fileStem(app)}-polar.svg`);
  }
}
