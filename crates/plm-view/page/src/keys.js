// Keys.

import { commandsOf } from "./commands.js";

/** @import {App} from "./app.js" */
/** @import {Command, Dialogs} from "./commands.js" */

/**
 * The name of what is pressed: `Ctrl+O`, `Shift+ArrowLeft`, `Space`, `?`. Shift is named where the key is the same without.
 * @param {{key: string, ctrlKey: boolean, metaKey: boolean, altKey: boolean, shiftKey: boolean}} event
 */
export function keyName({ key, ctrlKey, metaKey, altKey, shiftKey }) {
  const isLetter = /^\p{L}$/u.test(key);
  const name = key === " " ? "Space" : isLetter ? key.toUpperCase() : key;
  const isNamed = name.length > 1;
  const shift = shiftKey && (isLetter || isNamed) ? "Shift+" : "";
  return `${ctrlKey || metaKey ? "Ctrl+" : ""}${altKey ? "Alt+" : ""}${shift}${name}`;
}

/**
 * @param {App} app
 * @param {Dialogs} dialogs
 */
export function listenToKeys(app, dialogs) {
  document.addEventListener("input", ({ target }) => {
    if (target instanceof HTMLInputElement) target.dataset["typed"] = "";
  });
  document.addEventListener("change", ({ target }) => {
    if (target instanceof HTMLInputElement) delete target.dataset["typed"];
  });
  /** @type {Map<string, Command>} */
  const commandOfKey = new Map(commandsOf(app).flatMap((command) => command.keys.map((key) => [key, command])));
  document.addEventListener("keydown", (event) => {
    const target = event.target instanceof HTMLElement ? event.target : document.body;
    if (event.defaultPrevented || document.querySelector("dialog[open]") !== null) return;
    const name = keyName(event);
    const command = commandOfKey.get(name);
    if (command === undefined || belongsTo(target, name)) return;
    if (!app.hasPlainKeys && Array.from(name).length === 1) return;
    event.preventDefault();
    command.run(app, dialogs);
    app.touch();
  });
}

/**
 * Whether a key means something to the element that has the focus.
 * @param {HTMLElement} target
 * @param {string} name
 */
export function belongsTo(target, name) {
  // A declaration is typed there.
  if (target.isContentEditable) return true;
  if (target instanceof HTMLInputElement && target.type === "range") {
    // The time line moves by steps; other sliders by themselves.
    return target.id !== "time" && /^(Arrow|Home|End|Page)/.test(name);
  }
  if (target instanceof HTMLInputElement && target.type !== "checkbox" && target.type !== "radio") {
    // Undoing belongs to a field while something is typed into it.
    if (/^Ctrl\+(Z|Y|Shift\+Z)$/.test(name)) return target.dataset["typed"] !== undefined;
    return !name.startsWith("Ctrl+") || /^Ctrl\+(A|C|V|X|Arrow)/.test(name);
  }
  if (target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement) return !name.startsWith("Ctrl+");
  if (/^menuitem/.test(target.getAttribute("role") ?? "")) return !name.startsWith("Ctrl+");
  if (target.getAttribute("role") === "tab" || target instanceof HTMLInputElement) return /^(Arrow|Home|End|Space)/.test(name);
  const isPressed = target instanceof HTMLButtonElement || target instanceof HTMLAnchorElement || target.tagName === "SUMMARY";
  return isPressed && (name === "Space" || name === "Enter");
}
