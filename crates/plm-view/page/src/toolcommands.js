// Tools as rows of the table of commands.

import { forceJoints } from "./polar.js";
import { say } from "./say.js";
import { ghostCount } from "./tools.js";

/** @import {App} from "./app.js" */
/** @import {Command} from "./commands.js" */
/** @import {MeasureKind} from "./measure.js" */

/** So many ghost poses are drawn at first. */
const USUAL_GHOSTS = 12;

/** @type {(kind: MeasureKind, name: string, key: string) => Command} */
const measureCommand = (kind, name, key) => ({
  id: kind,
  name,
  group: "tools",
  icon: kind,
  keys: [key],
  run: (app) => startMeasure(app, kind),
  isOn: (app) => app.mode === kind,
});

/** @type {(id: "centres" | "centrodes", name: string, key: string) => Command} */
const switchCommand = (id, name, key) => ({
  id,
  name,
  group: "tools",
  icon: id,
  keys: [key],
  run: (app) => {
    app.tools[id] = !app.tools[id];
    app.change();
  },
  isOn: (app) => app.tools[id],
});

/** @type {(id: string, name: string, key: string, step: number) => Command} */
const ghostCommand = (id, name, key, step) => ({
  id,
  name,
  group: "tools",
  icon: null,
  keys: [key],
  run: (app) => setGhosts(app, app.tools.ghosts + step),
});

/** @type {Command[]} */
export const TOOL_COMMANDS = [
  { id: "undo", name: "Undo", group: "edit", icon: "undo", keys: ["Ctrl+Z"], run: (app) => app.history.undo() },
  { id: "redo", name: "Do again", group: "edit", icon: "redo", keys: ["Ctrl+Y", "Ctrl+Shift+Z"], run: (app) => app.history.redo() },
  measureCommand("distance", "Measure a distance", "Shift+E"),
  measureCommand("angle", "Measure an angle", "Shift+A"),
  switchCommand("centres", "Instant centres", "Shift+I"),
  switchCommand("centrodes", "Centrodes of the selected body", "Shift+J"),
  {
    id: "ghosts",
    name: "Ghost poses",
    group: "tools",
    icon: "ghosts",
    keys: ["Shift+O"],
    run: (app) => setGhosts(app, app.tools.ghosts > 0 ? 0 : USUAL_GHOSTS),
    isOn: (app) => app.tools.ghosts > 0,
  },
  ghostCommand("fewer ghosts", "Fewer ghost poses", "(", -1),
  ghostCommand("more ghosts", "More ghost poses", ")", 1),
  { id: "polar", name: "Polar plot of a force", group: "tools", icon: "polar", keys: ["Shift+F"], run: switchPolar, isOn: ({ tools }) => tools.force !== "" },
  { id: "movie", name: "Save as moving picture or video", group: "tools", icon: "movie", keys: ["Shift+V"], run: (_, dialogs) => dialogs.openMovie() },
  { id: "tools tab", name: "Tools", group: "panel", icon: null, keys: ["Shift+T"], run: (app) => openSheet(app, "tools") },
];

/** @param {App} app @param {number} count */
export function setGhosts(app, count) {
  app.tools.ghosts = ghostCount(count);
  app.change();
}

/** @param {App} app @param {MeasureKind} kind */
export function startMeasure(app, kind) {
  const isOn = app.mode === kind;
  app.mode = !isOn ? kind : (app.live?.usualMode ?? "pan");
  [app.marks, app.window] = [[], null];
  if (!isOn) say(app, kind === "distance" ? "Press on two points." : "Press on two bodies, or on three points.");
  app.change();
}

/** @param {App} app */
function switchPolar(app) {
  const joints = app.run === null ? [] : forceJoints(app.run);
  if (joints.length === 0) {
    say(app, "No force of a joint is recorded. An output such as hinge.force records it.");
    return;
  }
  const chosen = app.selected?.kind === "part" ? app.run?.mechanism.parts[app.selected.index].name : undefined;
  app.tools.force = app.tools.force !== "" ? "" : (joints.find((name) => name === chosen) ?? joints[0] ?? "");
  openSheet(app, "curves");
}

/** @param {App} app @param {string} tab */
function openSheet(app, tab) {
  app.hasPanel = true;
  app.tab = tab;
  app.change();
}
