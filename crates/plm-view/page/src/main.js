// Puts the page together and draws its frames.

import { addressKeeper, showAddress } from "./address.js";
import { App } from "./app.js";
import { openHelp, openOptions } from "./dialogs.js";
import { byId } from "./dom.js";
import { chooseFile, embeddedResults, listenToDrops } from "./files.js";
import { runFrames } from "./frames.js";
import { listenToDeeds } from "./history.js";
import { listenToKeys } from "./keys.js";
import { makeMenu } from "./menu.js";
import { playByItself } from "./opening.js";
import { openMovie } from "./moviedialog.js";
import { Panel } from "./panel.js";
import { listenToPointers } from "./pointer.js";
import { Stage } from "./stage.js";
import { Timeline } from "./timeline.js";
import { ToolPanel } from "./toolpanel.js";
import { makeToolbars } from "./toolbar.js";

/** @import {Dialogs} from "./commands.js" */

/**
 * The whole page, with everything that draws.
 * @param {App} app
 */
function assemblePage(app) {
  /** @type {Dialogs} */
  const dialogs = {
    openFile: () => chooseFile(app),
    openOptions: () => openOptions(app),
    openHelp: () => openHelp(app),
    openMovie: () => openMovie(app),
    leave: () => {
      window.close();
      // A page that was opened by hand may not close itself.
      setTimeout(() => app.tell("note", "The browser alone can close this page (Ctrl+W)."), 100);
    },
  };
  const canvas = byId("picture", HTMLCanvasElement);
  const stage = new Stage(app, {
    stage: byId("stage", HTMLElement),
    canvas,
    messages: byId("messages", HTMLElement),
    empty: byId("empty", HTMLElement),
    spoken: byId("spoken", HTMLElement),
  });
  const timeline = new Timeline(app, {
    slider: byId("time", HTMLInputElement),
    marks: byId("marks", HTMLCanvasElement),
    now: byId("now", HTMLElement),
    end: byId("end", HTMLElement),
    speed: byId("speed", HTMLSelectElement),
  });
  const panel = new Panel(app, byId("panel", HTMLElement));
  panel.add("tools", "Tools", (sheet) => new ToolPanel(app, sheet, dialogs.openMovie));
  listenToDeeds(app.history);
  const [tools, transport] = [byId("tools", HTMLElement), byId("transport", HTMLElement)];
  const showButtons = makeToolbars(app, dialogs, { tools, transport });
  const showMenu = makeMenu(app, dialogs, tools);
  listenToKeys(app, dialogs);
  listenToPointers(app, canvas);
  listenToDrops(app);
  return { stage, panel, parts: [app.history, { update: () => app.live?.update() }, { update: showButtons }, { update: showMenu }, panel, stage, timeline] };
}

/** @param {App} app */
function followSystem(app) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  app.prefersDark = dark.matches;
  dark.addEventListener("change", () => {
    app.prefersDark = dark.matches;
    app.change();
  });
  window.addEventListener("resize", () => app.touch());
}

/**
 * @param {((app: App) => Promise<(panel: Panel) => void>) | null} wake brings the mechanism itself to life, and then adds to
 *   the panel; null in a page that has none
 */
export async function startPage(wake) {
  const app = new App();
  followSystem(app);
  const bytes = embeddedResults();
  if (bytes !== null) await app.load(bytes);
  const join = (await wake?.(app)) ?? null;
  const { stage, panel, parts } = assemblePage(app);
  join?.(panel);
  const keepAddress = addressKeeper(app);
  const draw = () => {
    document.documentElement.dataset["theme"] = app.isDark ? "dark" : "light";
    for (const part of parts) part.update();
    keepAddress();
  };
  const address = location.hash;
  window.addEventListener("hashchange", () => showAddress(app, location.hash));
  stage.measure();
  app.zoomToExtents();
  app.live?.followCamera.choose();
  if (address.length > 1) showAddress(app, address);
  playByItself(app, address);
  const frames = runFrames(app, draw);
  // For tests, and for who wants more.
  Object.assign(window, { plmPage: { app, panel, frames } });
}
