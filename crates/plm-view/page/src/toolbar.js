// Labelled buttons. Each toolbar is one stop of Tab; arrow keys go from button to button.

import { commandsOf, labelledButtons } from "./commands.js";
import { element } from "./dom.js";
import { iconOf } from "./icons.js";

/** @import {App} from "./app.js" */
/** @import {Command, Dialogs} from "./commands.js" */

/** What can be done with nothing on the screen. */
const ALWAYS = new Set(["file", "page"]);

/**
 * Fills the toolbars with the labelled buttons; the function that is returned shows which are on.
 * @param {App} app
 * @param {Dialogs} dialogs
 * @param {{tools: HTMLElement, transport: HTMLElement}} places
 */
export function makeToolbars(app, dialogs, places) {
  const commands = new Map(commandsOf(app).map((command) => [command.id, command]));
  /** @type {{command: Command, button: HTMLButtonElement}[]} */
  const made = [];
  for (const { place, id, label } of labelledButtons(app)) {
    const command = commands.get(id);
    if (command === undefined) continue;
    const button = commandButton(app, dialogs, command, label);
    made.push({ command, button });
    places[place].append(button);
  }
  roveOver(places.tools);
  roveOver(places.transport);
  return () => {
    for (const { command, button } of made) showState(app, command, button);
  };
}

/**
 * Whether a command is on, and whether it is of use.
 * @param {App} app
 * @param {Command} command
 * @param {HTMLButtonElement} button
 * @param {string} [attribute] that tells whether it is on
 */
export function showState(app, command, button, attribute = "aria-pressed") {
  if (command.id === "toggle") showPlaying(button, app.isPlaying);
  else if (command.isOn !== undefined) setAttribute(button, attribute, String(command.isOn(app)));
  const whyNot = command.whyNot?.(app) ?? "";
  if (command.whyNot !== undefined) setAttribute(button, "title", whyNot || titleOf(command));
  const isUseless = whyNot !== "" || (app.run === null && !ALWAYS.has(command.group));
  if (button.disabled !== isUseless) button.disabled = isUseless;
}

/** The button says what it will do. @param {HTMLButtonElement} button @param {boolean} isPlaying */
function showPlaying(button, isPlaying) {
  const label = isPlaying ? "Pause" : "Play";
  const word = button.querySelector("span");
  if (word === null || word.textContent === label) return;
  word.textContent = label;
  button.querySelector("svg")?.replaceWith(iconOf(isPlaying ? "pause" : "play"));
}

/**
 * @param {App} app
 * @param {Dialogs} dialogs
 * @param {Command} command
 * @param {string} label
 */
function commandButton(app, dialogs, command, label) {
  const onclick = () => {
    command.run(app, dialogs);
    app.touch();
  };
  const attributes = { type: "button", id: buttonId(command), title: titleOf(command), "aria-keyshortcuts": ariaKeys(command.keys), onclick };
  return element("button", attributes, iconOf(command.icon ?? ""), element("span", {}, label));
}

/** @param {Command} command */
function titleOf({ name, keys }) {
  return `${name} (${keysText(keys)})`;
}

/** @param {Command} command */
export function buttonId({ id }) {
  return `do-${id.replaceAll(" ", "-")}`;
}

/**
 * One of several buttons is reached by Tab, the others by arrow keys from there.
 * @param {HTMLElement} bar
 */
function roveOver(bar) {
  const buttons = () => [...bar.querySelectorAll("button")].filter((button) => !button.disabled && button.checkVisibility());
  /** @param {HTMLElement | undefined} chosen */
  const choose = (chosen) => {
    for (const button of bar.querySelectorAll("button")) button.tabIndex = button === chosen ? 0 : -1;
  };
  choose(bar.querySelector("button") ?? undefined);
  bar.addEventListener("focusin", ({ target }) => {
    if (target instanceof HTMLElement) choose(target);
  });
  bar.addEventListener("keydown", (event) => {
    if (event.defaultPrevented) return;
    const all = buttons();
    const at = all.findIndex((button) => button === document.activeElement);
    const wanted = nextPlace(event.key, at, all.length);
    if (at < 0 || wanted === null || !isByKeyboard(all[at])) return;
    event.preventDefault();
    event.stopPropagation();
    all[wanted].focus();
  });
}

/**
 * Where an arrow key leads from one of several things; null for another key.
 * @param {string} key
 * @param {number} at
 * @param {number} count
 */
export function nextPlace(key, at, count) {
  if (key === "ArrowRight" || key === "ArrowDown") return (at + 1) % count;
  if (key === "ArrowLeft" || key === "ArrowUp") return (at - 1 + count) % count;
  if (key === "Home") return 0;
  return key === "End" ? count - 1 : null;
}

/** Who pressed a button by mouse goes on to step and to pull by arrow keys. @param {HTMLElement} button */
function isByKeyboard(button) {
  return button.matches(":focus-visible");
}

/** @param {HTMLElement} target @param {string} name @param {string} value */
function setAttribute(target, name, value) {
  if (target.getAttribute(name) !== value) target.setAttribute(name, value);
}

/** @type {{[key: string]: string}} */
const KEY_NAMES = { ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓", PageUp: "Page ↑", PageDown: "Page ↓", Escape: "Esc" };

/** Keys for reading: `Ctrl+O, O`. @param {string[]} keys */
export function keysText(keys) {
  return keys.map((key) => key.replace(/\p{L}{2,}$/u, (name) => KEY_NAMES[name] ?? name)).join(", ");
}

/** @param {string[]} keys */
export function ariaKeys(keys) {
  return keys.map((key) => key.replace("Ctrl", "Control").replace(/\+$/, "Plus")).join(" ");
}
