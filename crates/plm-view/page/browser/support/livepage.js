// The page with the mechanism itself, a four-bar.

import { makeNpz } from "../../tests/support/npz.js";
import { fourBarHead, modulePath, nativeRows, runOfRows, withoutModule } from "../../tests/support/live.js";
import { open, settle, skip as withoutBrowser, state, writePage } from "./browser.js";

export const skip = withoutBrowser || withoutModule;

export const FORCE = [194, 24, 91];
export const RED = [198, 40, 40];

export const address = skip
  ? ""
  : writePage("live", makeNpz([runOfRows(fourBarHead(), nativeRows().slice(0, 1))], { how: "deflated" }), "Four-bar", modulePath());

/** The page when it runs, or when it stands at its start. */
export async function livePage({ isRunning = true, ...how } = {}) {
  const { page, requests, errors } = await open(address, { plays: true, ...how });
  await page.waitForFunction(() => window.plmPage.app.live.run.rows > 3);
  if (!isRunning) {
    await page.click("#live-go");
    await page.click("#live-reset");
    await page.waitForFunction(() => window.plmPage.app.live.run.rows === 1);
    await settle(page);
  }
  return { page, requests, errors };
}

export const now = (page) => state(page, "app.live.run.end");
/** x y θ of a body in the last row. */
export const pose = (page, body) => state(page, `[0, 1, 2].map((axis) => app.live.run.poses.at(app.live.run.rows - 1, 6 * ${body} + axis))`);
export const setting = (page, kind, index) => state(page, `app.live.settings.${kind}[${index}]`);

/** Until the mechanism stands with a parameter as it was turned: the panel shows the setting before that. */
export const answered = (page, index, holds) =>
  page.waitForFunction(`((value) => ${holds})(window.plmPage.app.live.mechanism.parameters[${index}].value)`);

/** Where a point of a body is on the screen, in pixels of the page. */
export async function onScreen(page, body, point = [0, 0]) {
  const [x, y] = await page.evaluate(
    ([index, [u, v]]) => {
      const { app } = window.plmPage;
      const [gx, gy, angle] = app.scene.at(app.player.time).poses.subarray(3 * index, 3 * index + 3);
      const at = [gx + Math.cos(angle) * u - Math.sin(angle) * v, gy + Math.sin(angle) * u + Math.cos(angle) * v];
      return app.view.projection(app.area).point(...at, app.scene.levels.bodies[index]);
    },
    [body, point],
  );
  const box = await page.locator("#picture").boundingBox();
  return [box.x + x, box.y + y];
}
