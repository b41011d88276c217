// Buttons.

import { commandsOf, GROUPS } from "./commands.js";
import { element } from "./dom.js";
import { iconOf } from "./icons.js";

/** @import {App} from "./app.js" */
/** @import {Command, Dialogs} from "./commands.js" */

/** What can be done with nothing on the screen. */
const ALWAYS = new Set(["file", "page"]);

/**
 * Fills toolbars with the buttons of groups; the function that is returned shows which are on.
 * @param {App} app
 * @param {Dialogs} dialogs
 * @param {[HTMLElement, (keyof typeof GROUPS)[]][]} places
 */
export function makeToolbars(app, dialogs, places) {
  /** @type {{command: Command, button: HTMLButtonElement}[]} */
  const made = [];
  for (const [place, groups] of places) {
    for (const group of groups) {
      const commands = commandsOf(app).filter((command) => command.group === group && command.icon !== null);
      if (commands.length === 0) continue;
      const buttons = commands.map((command) => {
        const button = commandButton(app, dialogs, command);
        made.push({ command, button });
        return button;
      });
      place.append(element("div", { role: "toolbar", "aria-label": GROUPS[group] }, ...buttons));
    }
  }
  return () => {
    for (const { command, button } of made) {
      if (command.isOn !== undefined) setPressed(button, command.isOn(app));
      const isUseless = app.run === null && !ALWAYS.has(command.group);
      if (button.disabled !== isUseless) button.disabled = isUseless;
    }
  };
}

/**
 * @param {App} app
 * @param {Dialogs} dialogs
 * @param {Command} command
 */
function commandButton(app, dialogs, command) {
  const onclick = () => {
    command.run(app, dialogs);
    app.touch();
  };
  const title = `${command.name} (${keysText(command.keys)})`;
  const attributes = { type: "button", id: `do-${command.id.replace(" ", "-")}`, title, "aria-label": command.name, "aria-keyshortcuts": ariaKeys(command.keys), onclick };
  const button = element("button", attributes);
  button.append(iconOf(command.icon ?? ""));
  return button;
}

/** @param {HTMLButtonElement} button @param {boolean} isOn */
function setPressed(button, isOn) {
  const wanted = String(isOn);
  if (button.getAttribute("aria-pressed") !== wanted) button.setAttribute("aria-pressed", wanted);
}

/** @type {{[key: string]: string}} */
const KEY_NAMES = { ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓", PageUp: "Page ↑", PageDown: "Page ↓", Escape: "Esc" };

/** Keys for reading: `Ctrl+O, O`. @param {string[]} keys */
export function keysText(keys) {
  return keys.map((key) => key.replace(/\p{L}{2,}$/u, (name) => KEY_NAMES[name] ?? name)).join(", ");
}

/** @param {string[]} keys */
function ariaKeys(keys) {
  return keys.map((key) => key.replace("Ctrl", "Control").replace(/\+$/, "Plus")).join(" ");
}
