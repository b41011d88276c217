// The panel beside the picture: tabs.

import { Curves } from "./curves.js";
import { element } from "./dom.js";
import { Model } from "./model.js";
import { Objects } from "./objects.js";
import { Runs } from "./runs.js";

/** @import {App} from "./app.js" */

/** @typedef {{update: () => void}} Tab what a tab shows, brought up to date in every frame in which it is seen */

export class Panel {
  /**
   * @param {App} app
   * @param {HTMLElement} root
   */
  constructor(app, root) {
    this.app = app;
    this.root = root;
    this.buttons = element("div", { role: "tablist", "aria-label": "Panel" });
    /** @type {Map<string, {button: HTMLButtonElement, sheet: HTMLElement, tab: Tab}>} */
    this.tabs = new Map();
    root.append(this.buttons);
    this.add("curves", "Curves", (sheet) => new Curves(app, sheet));
    this.add("objects", "Objects", (sheet) => new Objects(app, sheet));
    this.add("runs", "Runs", (sheet) => new Runs(app, sheet));
    this.add("model", "Model", (sheet) => new Model(app, sheet));
  }

  /**
   * A further tab. A live source adds its own.
   * @param {string} id
   * @param {string} name
   * @param {(sheet: HTMLElement) => Tab} make
   */
  add(id, name, make) {
    const sheet = element("div", { role: "tabpanel", id: `sheet-${id}`, "aria-labelledby": `tab-${id}` });
    const open = () => this.open(id);
    const button = element(
      "button",
      { type: "button", role: "tab", id: `tab-${id}`, "aria-controls": `sheet-${id}`, onclick: open, onkeydown: (event) => this.move(event) },
      name,
    );
    this.buttons.append(button);
    this.root.append(sheet);
    this.tabs.set(id, { button, sheet, tab: make(sheet) });
  }

  /** Shows a tab at once: the next key may come before the next frame. @param {string} id */
  open(id) {
    this.app.tab = id;
    this.update();
    this.app.touch();
  }

  /** Arrow keys go from tab to tab. @param {KeyboardEvent} event */
  move(event) {
    const ids = [...this.tabs.keys()];
    const steps = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (steps === undefined) return;
    event.preventDefault();
    const next = ids[(ids.indexOf(this.app.tab) + steps + ids.length) % ids.length];
    this.open(next);
    this.tabs.get(next)?.button.focus();
  }

  update() {
    const { app } = this;
    this.root.hidden = !app.hasPanel;
    if (!this.tabs.has(app.tab)) app.tab = "curves";
    for (const [id, { button, sheet, tab }] of this.tabs) {
      const isOpen = id === app.tab;
      button.setAttribute("aria-selected", String(isOpen));
      button.tabIndex = isOpen ? 0 : -1;
      sheet.hidden = !isOpen;
      if (isOpen && app.hasPanel) tab.update();
    }
  }
}
