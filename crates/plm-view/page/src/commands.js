// All that can be done, once: buttons, the menu, keys and the table of keys are made from this list. A command with an icon that is
// no labelled button stands in the menu, under the title of its group.

import { savePng, saveSvg } from "./picture.js";
import { jumpToEvent } from "./runview.js";
import { say } from "./say.js";
import { TOOL_COMMANDS } from "./toolcommands.js";
import { dropMeasures } from "./toolpick.js";
import { PRESETS } from "./view.js";

/** @import {App, Layout, Mode} from "./app.js" */
/** @import {PresetName} from "./view.js" */

/**
 * @typedef {{openFile: () => void, openOptions: () => void, openHelp: () => void, openMovie: () => void, leave: () => void}} Dialogs what needs elements
 * of the page
 * @typedef {{id: string, name: string, group: string, icon: string | null, keys: string[],
 *   run: (app: App, dialogs: Dialogs) => void, isOn?: (app: App) => boolean, whyNot?: (app: App) => string}} Command with the
 *   reason why it is of no use now, empty where it is of use
 */

/** Groups in the order in which the menu and the table of keys show them. */
export const GROUPS = {
  show: "Show",
  view: "View",
  tools: "Tools",
  edit: "Edit",
  camera: "Dragging",
  animate: "Time",
  live: "Live",
  file: "File",
  page: "Page",
  move: "Move the view by keys",
  panel: "Panel and objects",
};

/**
 * Where the labelled buttons stand, and the word on each.
 * @typedef {{place: "tools" | "transport", id: string, label: string}} Labelled
 */

/** Of a page of results. @type {Labelled[]} */
const LABELLED = [
  { place: "tools", id: "forces", label: "Forces" },
  { place: "tools", id: "velocities", label: "Velocities" },
  { place: "tools", id: "extents", label: "Fit" },
  { place: "tools", id: "png", label: "Save" },
  { place: "tools", id: "panel", label: "Panel" },
  { place: "transport", id: "start", label: "Start" },
  { place: "transport", id: "toggle", label: "Play" },
];

/** Of a page with the mechanism itself, other buttons in some places. @type {{[id: string]: {id: string, label: string}}} */
const LIVE_INSTEAD = { png: { id: "pull", label: "Pull" }, start: { id: "restart", label: "Restart" } };

/** The seven labelled buttons. @param {App} app @returns {Labelled[]} */
export function labelledButtons(app) {
  if (app.live === null) return LABELLED;
  const offered = new Set(commandsOf(app).map(({ id }) => id));
  return LABELLED.map((button) => {
    const instead = LIVE_INSTEAD[button.id];
    return instead !== undefined && offered.has(instead.id) ? { ...button, ...instead } : button;
  });
}

/** @type {(id: string, name: string, keys: string[], run: Command["run"]) => Command} */
const fileCommand = (id, name, keys, run) => ({ id, name, group: "file", icon: id, keys, run });

/** @type {(mode: Mode, name: string, key: string) => Command} */
const cameraCommand = (mode, name, key) => ({
  id: mode,
  name,
  group: "camera",
  icon: mode,
  keys: [key],
  run: (app) => setMode(app, mode),
  isOn: (app) => app.mode === mode,
});

/** @type {(preset: PresetName, name: string, key: string) => Command} */
const viewCommand = (preset, name, key) => ({
  id: preset,
  name,
  group: "view",
  icon: preset,
  keys: [key],
  run: (app) => app.lookFrom(preset),
  isOn: ({ view }) => view.azimuth === PRESETS[preset].azimuth && view.elevation === PRESETS[preset].elevation,
});

/** @type {(id: string, name: string, keys: string[], icon: string | null, run: Command["run"]) => Command} */
const animateCommand = (id, name, keys, icon, run) => ({ id, name, group: "animate", icon, keys, run });

/** @type {(key: string, name: string, run: (app: App) => void) => Command} */
const moveCommand = (key, name, run) => ({ id: `move ${key}`, name, group: "move", icon: null, keys: [key], run });

/** @type {(id: string, name: string, key: string, run: (app: App) => void) => Command} */
const panelCommand = (id, name, key, run) => ({ id, name, group: "panel", icon: null, keys: [key], run });

/** @type {Command[]} */
export const COMMANDS = [
  fileCommand("open", "Open a results file", ["Ctrl+O", "O"], (_, dialogs) => dialogs.openFile()),
  fileCommand("reload", "Show the file anew, from its start", ["Ctrl+R", "R"], (app) => void app.reload()),
  fileCommand("clear", "Clear the window", ["Ctrl+N", "N"], (app) => app.clear()),
  fileCommand("exit", "Close the page", ["Ctrl+Q", "Q"], (_, dialogs) => dialogs.leave()),

  cameraCommand("pan", "Dragging moves", "M"),
  cameraCommand("orbit", "Dragging turns", "T"),
  cameraCommand("zoom", "Dragging zooms", "Z"),
  cameraCommand("window", "Zoom to window", "W"),
  cameraCommand("info", "Object information", "I"),

  { id: "extents", name: "Show everything", group: "view", icon: "extents", keys: ["X", "0"], run: (app) => app.zoomToExtents() },
  viewCommand("isometric", "Isometric", "7"),
  viewCommand("front", "Front", "1"),
  viewCommand("back", "Back", "2"),
  viewCommand("left", "Left", "3"),
  viewCommand("right", "Right", "4"),
  viewCommand("top", "Top", "5"),
  viewCommand("bottom", "Bottom", "6"),

  toggleCommand("wire", "Frames instead of surfaces", "G", "isWire"),
  toggleCommand("forces", "Arrows of forces", "Y", "showsForces"),
  toggleCommand("velocities", "Arrows of velocities", "U", "showsVelocities"),

  pageCommand("png", "Save the picture (PNG)", "Shift+P", (app) => void savePng(app)),
  pageCommand("svg", "Save the picture (SVG)", "Shift+S", (app) => saveSvg(app)),
  { ...pageCommand("theme", "Dark or light", "D", switchTheme), isOn: (app) => app.isDark },
  { ...pageCommand("panel", "Panel beside the picture", "V", switchPanel), isOn: (app) => app.hasPanel },
  pageCommand("options", "Options", "K", (_, dialogs) => dialogs.openOptions()),
  pageCommand("help", "Keys, and about this page", "?", (_, dialogs) => dialogs.openHelp()),

  animateCommand("start", "Jump to start", ["Ctrl+A", "A", "Home"], "start", (app) => app.player.seek(app.player.start)),
  animateCommand("back step", "Step backwards", ["Ctrl+B", "B", "ArrowLeft"], "back1", (app) => app.player.stepBy(-1)),
  {
    ...animateCommand("play", "Play", ["Ctrl+P", "P"], "play", (app) => app.play()),
    isOn: (app) => app.isPlaying,
  },
  animateCommand("stop", "Stop", ["Ctrl+S", "S"], "stop", (app) => app.stop()),
  animateCommand("forward step", "Step forwards", ["Ctrl+F", "F", "ArrowRight"], "forward1", (app) => app.stepForwards()),
  animateCommand("end", "Jump to end", ["Ctrl+E", "E", "End"], "end", jumpToEnd),
  {
    ...animateCommand("loop", "Loop", ["L"], "loop", ({ player }) => (player.isLooping = !player.isLooping)),
    isOn: (app) => app.player.isLooping,
  },
  {
    ...animateCommand("toggle", "Play or pause", ["Space"], "play", (app) => (app.isPlaying ? app.stop() : app.play())),
    isOn: (app) => app.isPlaying,
  },
  animateCommand("slower", "Slower", ["<"], null, (app) => app.player.changeSpeed(-1)),
  animateCommand("faster", "Faster", [">"], null, (app) => app.player.changeSpeed(1)),
  animateCommand("event before", "Jump to the event before", ["["], null, (app) => jumpToEvent(app, -1)),
  animateCommand("event after", "Jump to the next event", ["]"], null, (app) => jumpToEvent(app, 1)),

  moveCommand("Shift+ArrowLeft", "Pan to the left", (app) => nudge(app, -1, 0)),
  moveCommand("Shift+ArrowRight", "Pan to the right", (app) => nudge(app, 1, 0)),
  moveCommand("Shift+ArrowUp", "Pan up", (app) => nudge(app, 0, -1)),
  moveCommand("Shift+ArrowDown", "Pan down", (app) => nudge(app, 0, 1)),
  moveCommand("Ctrl+ArrowLeft", "Orbit to the left", (app) => app.view.orbit(-20, 0)),
  moveCommand("Ctrl+ArrowRight", "Orbit to the right", (app) => app.view.orbit(20, 0)),
  moveCommand("Ctrl+ArrowUp", "Orbit up", (app) => app.view.orbit(0, -20)),
  moveCommand("Ctrl+ArrowDown", "Orbit down", (app) => app.view.orbit(0, 20)),
  moveCommand("+", "Zoom in", (app) => enlarge(app, 1.25)),
  moveCommand("-", "Zoom out", (app) => enlarge(app, 0.8)),
  moveCommand("Enter", "Zoom to the window", applyWindow),
  moveCommand("Escape", "Let go: window, measures, selection", letGo),

  panelCommand("next object", "Next object", ".", (app) => app.selectNext(1)),
  panelCommand("object before", "Object before", ",", (app) => app.selectNext(-1)),
  panelCommand("curves tab", "Curves", "C", (app) => openTab(app, "curves")),
  panelCommand("objects tab", "Objects", "J", (app) => openTab(app, "objects")),
  panelCommand("runs tab", "Runs and events", "Shift+R", (app) => openTab(app, "runs")),
  panelCommand("model tab", "Model", "Shift+M", (app) => openTab(app, "model")),
  panelCommand("log axes", "Logarithmic axes of curves, or linear ones", "Shift+G", switchLogAxes),
  panelCommand("phase plot", "Curves against the first of them, or over the time", "Shift+X", switchAcross),
  panelCommand("run after", "Next run", "PageDown", (app) => app.activate(app.active + 1)),
  panelCommand("run before", "Run before", "PageUp", (app) => app.activate(app.active - 1)),
  ...TOOL_COMMANDS,
];

/** @type {(id: string, name: string, key: string, icon: string | null, run: Command["run"]) => Command} */
const liveCommand = (id, name, key, icon, run) => ({ id, name, group: "live", icon, keys: [key], run });

/** What a page with the mechanism itself has, too. @type {Command[]} */
export const LIVE_COMMANDS = [
  {
    ...liveCommand("pull", "Pull a body", "H", "pull", pull),
    isOn: (app) => app.mode === "pull",
    whyNot: (app) => app.live?.unmoved ?? "",
  },
  { ...liveCommand("place", "Place a body", "Shift+H", "place", (app) => setMode(app, "place")), isOn: (app) => app.mode === "place" },
  liveCommand("restart", "Restart: from the first moment, with the values as they are set", "Shift+B", "restart", (app) => app.live?.restart()),
  liveCommand("reset", "Reset: from the first moment, with the values as declared", "Shift+D", "reload", (app) => app.live?.reset()),
  { ...liveCommand("record", "Record", "Shift+C", "record", (app) => app.live?.record()), isOn: (app) => (app.live?.recordsFrom ?? null) !== null },
  liveCommand("live tab", "Live", "Shift+L", null, (app) => openTab(app, "live")),
];

/** What a page in which a declaration is typed has, too. @type {Command[]} */
export const PLAY_COMMANDS = [
  { ...cameraCommand("draw", "Draw in the picture", "Shift+W"), run: (app) => app.sketch?.toggle() },
  { id: "new sheet", name: "A new sheet", group: "file", icon: "clear", keys: ["Shift+N"], run: (app) => app.sketch?.begin() },
];

/** @param {App} app */
export function commandsOf(app) {
  const { live } = app;
  if (live === null) return COMMANDS;
  const isOffered = (/** @type {Command} */ { id }) => (id !== "pull" && id !== "place") || live.modes.includes(id);
  return [...COMMANDS, ...LIVE_COMMANDS.filter(isOffered), ...(app.sketch === null ? [] : PLAY_COMMANDS)];
}

/**
 * @param {string} id
 * @param {string} name
 * @param {string} key
 * @param {"isWire" | "showsForces" | "showsVelocities"} what
 * @returns {Command}
 */
function toggleCommand(id, name, key, what) {
  const run = (/** @type {App} */ app) => void (app[what] = !app[what]);
  return { id, name, group: "show", icon: id, keys: [key], run, isOn: (app) => app[what] };
}

/**
 * @param {string} id
 * @param {string} name
 * @param {string} key
 * @param {Command["run"]} run
 * @returns {Command}
 */
function pageCommand(id, name, key, run) {
  return { id, name, group: "page", icon: id, keys: [key], run };
}

/** @param {App} app */
function pull(app) {
  const whyNot = app.live?.unmoved ?? "";
  if (whyNot === "") setMode(app, "pull");
  else say(app, whyNot);
}

/** @param {App} app @param {Mode} mode */
export function setMode(app, mode) {
  app.mode = mode;
  // What moves cannot be placed.
  if (mode === "place" && app.live?.isRunning) app.live.pause();
  const { x, y, width, height } = app.area;
  // By keys the window is moved and made smaller; by the mouse it is drawn.
  app.window =
    mode === "window" && app.run !== null
      ? { x: x + 0.25 * width, y: y + 0.25 * height, width: 0.5 * width, height: 0.5 * height }
      : null;
}

/** @param {App} app @param {number} dx @param {number} dy */
function nudge(app, dx, dy) {
  if (app.window !== null) {
    app.window = { ...app.window, x: app.window.x + 15 * dx, y: app.window.y + 15 * dy };
  } else {
    app.view.pan(30 * dx, 30 * dy);
  }
}

/** @param {App} app @param {number} factor */
function enlarge(app, factor) {
  if (app.window === null) {
    app.view.zoom(factor);
    return;
  }
  const { x, y, width, height } = app.window;
  const [w, h] = [width * factor, height * factor];
  app.window = { x: x - 0.5 * (w - width), y: y - 0.5 * (h - height), width: w, height: h };
}

/** @param {App} app */
function applyWindow(app) {
  if (app.window !== null) app.view.zoomTo(app.window, app.area);
  app.window = null;
}

/** @param {App} app */
function letGo(app) {
  if (app.window !== null) app.window = null;
  else if (dropMeasures(app)) return;
  else if (app.selected !== null) app.select(null);
}

/** @param {App} app */
function jumpToEnd(app) {
  app.player.seek(app.player.end);
  app.player.isFollowing = app.run?.isLive ?? false;
}

/** @param {App} app */
function switchTheme(app) {
  app.theme = app.isDark ? "light" : "dark";
  app.change();
}

/** @param {App} app */
function switchPanel(app) {
  app.hasPanel = !app.hasPanel;
  app.change();
}

/** @param {App} app @param {string} tab */
function openTab(app, tab) {
  app.hasPanel = true;
  app.tab = tab;
  app.change();
}

/** All charts become logarithmic; if they are, linear. @param {App} app */
function switchLogAxes(app) {
  const quantities = app.run?.quantities() ?? [];
  const units = [...new Set(quantities.filter(({ name, role }) => app.curves.includes(name) && role !== "residual").map(({ unit }) => unit))];
  app.logUnits = units.every((unit) => app.logUnits.includes(unit)) ? [] : units;
  openTab(app, "curves");
}

/** @param {App} app */
function switchAcross(app) {
  app.across = app.across === null ? (app.curves[0] ?? null) : null;
  openTab(app, "curves");
}

/**
 * The names of layouts, for the panel and the address.
 * @type {{[layout in Layout]: string}}
 */
export const LAYOUTS = { one: "One", overlay: "Overlaid", side: "Side by side" };
