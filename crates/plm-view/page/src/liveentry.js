// Live entry: starts a page that holds the mechanism itself.

import { embeddedModule } from "./files.js";
import { dragTool, listenToDragKeys } from "./drag.js";
import { Live } from "./live.js";
import { LivePanel } from "./livepanel.js";
import { startPage } from "./main.js";

/** @import {App} from "./app.js" */
/** @import {Panel} from "./panel.js" */

/**
 * Brings the mechanism to life that the first run describes.
 * @param {App} app
 * @returns {Promise<(panel: Panel) => void>}
 */
async function wake(app) {
  const wasm = await embeddedModule();
  const head = app.run?.head;
  if (wasm === null || head === undefined) {
    app.tell("error", "The page holds a module, but no results that tell what it is.");
    return () => {};
  }
  // A file without rows only describes the mechanism.
  if (app.run?.rows === 0) app.runViews = [];
  const live = new Live(app, head, wasm);
  app.live = live;
  app.grip = dragTool(app);
  app.tab = "live";
  app.mode = live.usualMode;
  live.show();
  // Before the other keys: while a body is held, arrows move it.
  listenToDragKeys(app);
  // Who asked for less motion begins it.
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) live.start();
  return (panel) => panel.add("live", "Live", (sheet) => new LivePanel(app, live, sheet));
}

void startPage(wake);
