// Frames a second while a run plays, for chains of bars: `node browser/speed.js`, with CHROMIUM and PLM_PAGE as in the tests.

import { chain } from "../tests/support/scenes.js";
import { open, theBrowser, writeRuns } from "./support/browser.js";

const SECONDS = 4;

for (const count of [13, 40, 120, 200]) {
  const address = writeRuns(`chain${count}`, [chain(count, { end: 10, rate: 50 })]);
  for (const [name, view] of [["front", ""], ["isometric", "isometric"]]) {
    const { page } = await open(address);
    if (view !== "") await page.click(`#do-${view}`);
    const { frames, script } = await page.evaluate(async (seconds) => {
      const { app } = window.plmPage;
      app.player.isLooping = true;
      let [frames, script] = [0, 0];
      const tick = app.player.tick.bind(app.player);
      app.player.tick = (now) => {
        frames++;
        const started = performance.now();
        // A task behind the frame: everything of it has been drawn by then.
        queueMicrotask(() => (script += performance.now() - started));
        return tick(now);
      };
      app.player.play();
      app.touch();
      await new Promise((done) => setTimeout(done, 1000 * seconds));
      return { frames, script };
    }, SECONDS);
    console.log(`${count} bodies, ${name}: ${(frames / SECONDS).toFixed(1)} frames a second, ${(script / frames).toFixed(1)} ms of script each`);
  }
}
await (await theBrowser()).close();
