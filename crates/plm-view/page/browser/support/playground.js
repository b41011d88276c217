// The playground that a test opens, and what is typed in it.

import { existsSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { packText } from "../../src/packedtext.js";
import { open, skip as withoutBrowser } from "./browser.js";

export const file = process.env["PLM_PLAYGROUND"] ?? "";
export const skip =
  withoutBrowser || (existsSync(file) ? false : "skipped: there is no playground; `bash examples/playground/build.sh` makes it, and PLM_PLAYGROUND names it");
export const address = skip ? "" : pathToFileURL(file).href;

export const PENDULUM = `pub Pendulum {
    param length: m = 1 m;
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0 m, length); start angle: 30 deg, locked; }
    revolute hinge(ground.o, bob.pivot);
    output hinge.force;
}
`;

/** The playground with a text. */
export async function playground(text = null, how = {}) {
  const hash = text === null ? "" : `#text=${await packText(text)}`;
  const opened = await open(address, { plays: true, hash, ...how });
  await opened.page.waitForFunction(() => window.plmPage.app.live.run.rows > 3);
  return opened;
}

export const typed = (page) => page.evaluate(() => window.plmPlay.pane.editor.text());
export const type = (page, text) => page.evaluate((to) => window.plmPlay.pane.editor.replace(to), text);
export const problems = (page) => page.locator("#problems li").allTextContents();
