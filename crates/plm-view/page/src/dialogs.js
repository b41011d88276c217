// Dialogs: options; keys and the page itself.

import { commandsOf, GROUPS } from "./commands.js";
import { element } from "./dom.js";
import { shortNumber } from "./text.js";
import { keysText } from "./toolbar.js";

/** @import {App} from "./app.js" */

/**
 * The manual's options: background colour, refresh rate, fast-forward step; and the theme.
 * @param {App} app
 */
export function openOptions(app) {
  const colour = element("input", {
    type: "color",
    id: "background",
    value: app.palette.background,
    oninput: () => set(() => (app.background = colour.value)),
  });
  const usual = element("button", { type: "button", onclick: () => set(() => (app.background = null)) }, "Usual");
  const rate = element("input", {
    type: "number",
    id: "rate",
    min: 1,
    max: 240,
    value: app.refreshRate,
    oninput: () => set(() => (app.refreshRate = Math.max(1, Number(rate.value) || 60))),
  });
  const step = element("input", {
    type: "number",
    id: "step",
    min: 0,
    step: "any",
    placeholder: shortNumber(app.player.step),
    value: app.player.chosenStep ?? "",
    oninput: () => set(() => (app.player.chosenStep = Number(step.value) > 0 ? Number(step.value) : null)),
  });
  const theme = element("select", { id: "theme", onchange: () => set(() => (app.theme = /** @type {App["theme"]} */ (theme.value))) });
  for (const [value, name] of [["auto", "as the system"], ["light", "light"], ["dark", "dark"]]) {
    theme.add(new Option(name, value, false, app.theme === value));
  }
  const plain = element("input", {
    type: "checkbox",
    id: "plain-keys",
    checked: app.hasPlainKeys,
    onchange: () => set(() => (app.hasPlainKeys = plain.checked)),
  });
  const set = (/** @type {() => unknown} */ change) => {
    change();
    colour.value = app.palette.background;
    app.change();
  };
  showDialog("Options", [
    optionRow("Background colour", colour, usual),
    optionRow("Refresh rate, frames a second", rate),
    optionRow("Fast-forward step, s", step),
    optionRow("Colours", theme),
    optionRow("Keys of one letter", plain),
  ]);
}

/** @param {string} name @param {HTMLElement} control @param {...HTMLElement} more */
export function optionRow(name, control, ...more) {
  return element("div", { class: "row" }, element("label", { for: control.id }, name), control, ...more);
}

/** @param {App} app */
export function openHelp(app) {
  const all = commandsOf(app);
  const present = Object.entries(GROUPS).filter(([group]) => all.some((command) => command.group === group));
  const groups = present.map(([group, title]) => {
    const rows = all.filter((command) => command.group === group).map((command) =>
      element("tr", {}, element("th", { scope: "row" }, command.name), element("td", {}, element("kbd", {}, keysText(command.keys)))),
    );
    return element("section", {}, element("h3", {}, title), element("table", {}, element("tbody", {}, ...rows)));
  });
  const mouse =
    "The left button does what the camera mode says; the right one orbits, the middle one pans, the wheel zooms; " +
    "a click tells what is under it, a double click shows everything. Two fingers pan and zoom.";
  showDialog("Keys", [
    element("p", {}, mouse),
    element("p", {}, "Where the browser keeps a key with Ctrl for itself, the one after it does the same."),
    element("div", { class: "keys" }, ...groups),
    element("h3", {}, "About"),
    element("p", {}, `This page is one file and asks nothing of any network. ${app.madeBy === "" ? "" : `Results by ${app.madeBy}.`}`),
  ]);
}

/**
 * @param {string} title
 * @param {HTMLElement[]} contents
 */
export function showDialog(title, contents) {
  // At the top: what a dialog opens with is what can be pressed first.
  const close = element("button", { type: "button", onclick: () => dialog.close() }, "Close");
  const head = element("div", { class: "head" }, element("h2", {}, title), close);
  const dialog = element("dialog", { "aria-label": title, onclose: () => dialog.remove() }, head, ...contents);
  document.body.append(dialog);
  dialog.showModal();
}
