// The picture on the page: its canvas, what is told over it, what a screen reader hears of it.

import { drawLabel } from "./decor.js";
import { element, fitCanvas, setText } from "./dom.js";
import { itemTitle } from "./objects.js";
import { CanvasPen } from "./pen.js";
import { drawPicture, pickAt } from "./picture.js";

/** @import {App} from "./app.js" */

export class Stage {
  /**
   * @param {App} app
   * @param {{stage: HTMLElement, canvas: HTMLCanvasElement, messages: HTMLElement, empty: HTMLElement, spoken: HTMLElement}} parts
   */
  constructor(app, parts) {
    this.app = app;
    this.parts = parts;
    this.told = -1;
  }

  /** Measures the picture, which the view has to know before it can show everything. */
  measure() {
    const { app } = this;
    const { clientWidth: width, clientHeight: height } = this.parts.stage;
    if (app.area.width === width && app.area.height === height) return;
    app.area = { x: 0, y: 0, width: Math.max(1, width), height: Math.max(1, height) };
    if (app.isFitted) app.zoomToExtents();
  }

  update() {
    const { app, parts } = this;
    this.measure();
    const { width, height } = app.area;
    const context = fitCanvas(parts.canvas, width, height);
    context.fillStyle = app.palette.background;
    context.fillRect(0, 0, width, height);
    const pen = new CanvasPen(context);
    if (app.sketch !== null) app.sketch.drawBelow(pen);
    drawPicture(pen, app);
    if (app.mode !== "draw") this.nameHovered(pen);
    app.sketch?.drawOver(pen);
    parts.canvas.dataset["mode"] = app.mode;
    parts.empty.hidden = app.run !== null;
    if (this.told !== app.revision) {
      this.told = app.revision;
      this.tell();
    }
  }

  /** The name of what is under the mouse. @param {CanvasPen} pen */
  nameHovered(pen) {
    const { app } = this;
    const { pointer, drag } = app;
    const hovered = pointer === null || drag !== null ? null : pickAt(app, pointer.x, pointer.y);
    this.parts.canvas.dataset["over"] = hovered?.item?.kind ?? "";
    if (pointer === null || hovered === null || hovered.item === null) return;
    const { mechanism } = app.runViews[hovered.index].run;
    drawLabel(pen, pointer.x, pointer.y, itemTitle(mechanism, hovered.item), app.area, app.palette);
  }

  tell() {
    const { app, parts } = this;
    const messages = app.messages.map((message) =>
      element(
        "div",
        { class: `message ${message.kind}`, role: message.kind === "error" ? "alert" : "status" },
        element("p", {}, message.text),
        element("button", { type: "button", class: "plain", "aria-label": "Dismiss", onclick: () => dismiss(app, message) }, "×"),
      ),
    );
    parts.messages.replaceChildren(...messages);
    const { run, selected } = app;
    const what = run === null ? "No results" : `Picture of ${run.mechanism.name}, run ${run.name}`;
    parts.canvas.setAttribute("aria-label", what);
    setText(parts.spoken, run !== null && selected !== null ? `Selected: ${itemTitle(run.mechanism, selected)}` : "");
  }
}

/** @param {App} app @param {import("./app.js").Message} message */
function dismiss(app, message) {
  app.messages = app.messages.filter((other) => other !== message);
  app.change();
}
