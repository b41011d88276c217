// The menu: all commands with an icon that are no labelled buttons, under the titles of their groups.

import { commandsOf, GROUPS, labelledButtons } from "./commands.js";
import { element } from "./dom.js";
import { iconOf } from "./icons.js";
import { ariaKeys, buttonId, keysText, nextPlace, showState } from "./toolbar.js";

/** @import {App} from "./app.js" */
/** @import {Command, Dialogs} from "./commands.js" */

/**
 * Adds the button of the menu to a toolbar, and the menu to the page; the function that is returned shows what is on.
 * @param {App} app
 * @param {Dialogs} dialogs
 * @param {HTMLElement} tools
 */
export function makeMenu(app, dialogs, tools) {
  const menu = new Menu(app, dialogs);
  tools.append(menu.opener);
  document.body.append(menu.sheet);
  return () => menu.update();
}

class Menu {
  /** @param {App} app @param {Dialogs} dialogs */
  constructor(app, dialogs) {
    this.app = app;
    this.dialogs = dialogs;
    /** @type {{command: Command, item: HTMLButtonElement}[]} */
    this.items = [];
    this.isByKeyboard = false;
    const title = "Everything else that can be done";
    const words = { title, "aria-haspopup": "menu", "aria-expanded": "false", "aria-controls": "menu" };
    this.opener = element("button", { type: "button", id: "do-menu", ...words, tabindex: -1, onclick: () => this.show(!this.isOpen()) }, iconOf("menu"), element("span", {}, "Menu"));
    this.sheet = element("div", { id: "menu", role: "menu", "aria-label": "Menu", hidden: true, onkeydown: (event) => this.move(event) }, ...this.groups());
    document.addEventListener("pointerdown", ({ target }) => {
      if (target instanceof Node && !this.sheet.contains(target) && !this.opener.contains(target)) this.show(false);
    });
  }

  groups() {
    const { app } = this;
    const labelled = new Set(labelledButtons(app).map(({ id }) => id));
    const rest = commandsOf(app).filter(({ id, icon }) => icon !== null && !labelled.has(id));
    const present = Object.entries(GROUPS).filter(([group]) => rest.some((command) => command.group === group));
    return present.map(([group, title]) => {
      const items = rest.filter((command) => command.group === group).map((command) => this.item(command));
      return element("div", { role: "group", "aria-label": title }, element("h3", { role: "presentation" }, title), ...items);
    });
  }

  /** @param {Command} command */
  item(command) {
    const act = () => {
      this.show(false);
      this.letGo();
      command.run(this.app, this.dialogs);
      this.app.touch();
    };
    const role = command.isOn === undefined ? "menuitem" : "menuitemcheckbox";
    const attributes = { type: "button", role, id: buttonId(command), tabindex: -1, "aria-keyshortcuts": ariaKeys(command.keys), onclick: act };
    const item = element(
      "button",
      attributes,
      iconOf(command.icon ?? ""),
      element("span", {}, command.name),
      element("kbd", { "aria-hidden": "true" }, keysText(command.keys.slice(-1))),
    );
    this.items.push({ command, item });
    return item;
  }

  isOpen() {
    return !this.sheet.hidden;
  }

  /** @param {boolean} isOpen */
  show(isOpen) {
    if (this.isOpen() === isOpen) return;
    this.sheet.hidden = !isOpen;
    this.opener.setAttribute("aria-expanded", String(isOpen));
    if (!isOpen) return;
    this.isByKeyboard = this.opener.matches(":focus-visible");
    this.update();
    this.items.find(({ item }) => !item.disabled)?.item.focus();
  }

  /** Where the focus goes when the menu closes: who uses the mouse goes on with keys of the picture. */
  letGo() {
    (this.isByKeyboard ? this.opener : document.getElementById("picture"))?.focus();
  }

  /** Arrow keys go from item to item, a letter to the next one that begins with it. @param {KeyboardEvent} event */
  move(event) {
    const items = this.items.map(({ item }) => item).filter((item) => !item.disabled);
    const at = items.findIndex((item) => item === document.activeElement);
    if (event.key === "Escape" || event.key === "Tab") {
      this.show(false);
      this.letGo();
      if (event.key === "Escape") event.preventDefault();
    } else {
      const wanted = nextPlace(event.key, at, items.length) ?? letterPlace(items, at, event.key);
      if (wanted === null) return;
      event.preventDefault();
      items[wanted].focus();
    }
  }

  update() {
    if (!this.isOpen()) return;
    for (const { command, item } of this.items) showState(this.app, command, item, "aria-checked");
  }
}

/** @param {HTMLElement[]} items @param {number} at @param {string} key */
function letterPlace(items, at, key) {
  if (!/^\p{L}$/u.test(key)) return null;
  const order = items.map((_, step) => (at + 1 + step) % items.length);
  return order.find((place) => items[place].querySelector("span")?.textContent?.toLowerCase().startsWith(key.toLowerCase())) ?? null;
}
