// Starts a page that a running program serves.

import { dragTool, listenToDragKeys } from "./drag.js";
import { LivePanel } from "./livepanel.js";
import { startPage } from "./main.js";
import { Program } from "./program.js";
import { ServedLive } from "./servedlive.js";

/** @import {App} from "./app.js" */
/** @import {Panel} from "./panel.js" */

/**
 * Listens to the program.
 * @param {App} app
 * @returns {Promise<(panel: Panel) => void>}
 */
async function listen(app) {
  const head = app.run?.head;
  if (head === undefined) {
    app.tell("error", "The program does not tell what it runs.");
    return () => {};
  }
  const program = new Program(
    () => new EventSource("events"),
    (body) => fetch("message", { method: "POST", body }),
  );
  const hello = await program.open();
  app.runViews = [];
  const live = new ServedLive(app, head, program, hello?.pulls ?? false);
  app.live = live;
  app.grip = dragTool(app);
  app.tab = "live";
  app.mode = live.usualMode;
  live.show();
  listenToDragKeys(app);
  return (panel) => panel.add("live", "Live", (sheet) => new LivePanel(app, live, sheet));
}

void startPage(listen);
