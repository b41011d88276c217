// The panel of runs and events.

import { LAYOUTS } from "./commands.js";
import { element } from "./dom.js";
import { ghostColour } from "./picture.js";
import { timeText } from "./text.js";

/** @import {App, Layout} from "./app.js" */

/** Events listed at most; the time line has all. */
const MOST_EVENTS = 300;

export class Runs {
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
    const { run } = this.app;
    // What has the focus is found again by its id.
    const focus = document.activeElement?.id ?? "";
    this.root.replaceChildren(
      ...(this.app.runViews.length > 1 ? [this.layouts(), this.list()] : []),
      ...(run?.fault ? [this.fault(run.fault)] : []),
      ...(run?.notices ?? []).map((notice) => element("div", { class: "message warning" }, element("p", {}, notice))),
      element("h2", {}, "Events"),
      this.events(),
    );
    if (focus !== "" && document.activeElement === document.body) document.getElementById(focus)?.focus();
  }

  layouts() {
    const choices = Object.entries(LAYOUTS).map(([layout, name]) =>
      element(
        "label",
        {},
        element("input", {
          type: "radio",
          name: "layout",
          id: `layout-${layout}`,
          value: layout,
          checked: this.app.layout === layout,
          onchange: () => this.app.setLayout(/** @type {Layout} */ (layout)),
        }),
        name,
      ),
    );
    return element("fieldset", { class: "row" }, element("legend", {}, "Show runs"), ...choices);
  }

  list() {
    const { app } = this;
    const rows = app.runViews.map((shown, index) => {
      const { run } = shown;
      const swatch = element("span", { class: "dot", "aria-hidden": "true" });
      const rgb = index === app.active ? app.palette.tones.body : ghostColour(app, run);
      swatch.style.background = `rgb(${rgb.join(",")})`;
      const radio = element("input", {
        type: "radio",
        name: "run",
        id: `run-${index}`,
        checked: index === app.active,
        onchange: () => app.activate(index),
      });
      const box = element("input", {
        type: "checkbox",
        id: `show-${index}`,
        "aria-label": `Show ${run.name}`,
        checked: shown.isShown,
        disabled: app.layout === "one" || index === app.active,
        onchange: () => {
          shown.isShown = !shown.isShown;
          app.updateBounds();
          app.change();
        },
      });
      const end = run.fault === null ? timeText(run.end, run.end - run.start) : `fault at ${timeText(run.fault.time, run.end)}`;
      return element("li", {}, box, element("label", {}, radio, swatch, run.name), element("span", { class: "faint" }, end));
    });
    return element("ul", { class: "runs", "aria-label": "Runs" }, ...rows);
  }

  /** @param {import("./format.js").RunFault} fault */
  fault(fault) {
    return element(
      "div",
      { class: "message error" },
      element("p", {}, `The run ended at ${timeText(fault.time, this.app.player.duration)}: `, element("strong", {}, fault.part), `: ${fault.text}`),
      element("button", { type: "button", onclick: () => this.go(fault.time) }, "Go there"),
    );
  }

  events() {
    const events = this.app.run?.events ?? [];
    if (events.length === 0) return element("p", { class: "hint" }, "Nothing switched in this run.");
    const { duration } = this.app.player;
    const rows = events.slice(0, MOST_EVENTS).map(({ time, what }) =>
      element("li", {}, element("button", { type: "button", class: "plain", onclick: () => this.go(time) }, timeText(time, duration)), ` ${what}`),
    );
    const more = events.length - rows.length;
    return element("ol", { class: "events" }, ...rows, ...(more > 0 ? [element("li", {}, `and ${more} more`)] : []));
  }

  /** @param {number} time */
  go(time) {
    this.app.player.stop();
    this.app.player.seek(time);
    this.app.touch();
  }
}
