// How long frames take while a run plays, for chains of bars. What is drawn in a second is printed: it is the machine's.

import assert from "node:assert/strict";
import { test } from "node:test";
import { chain } from "../tests/support/scenes.js";
import { open, skip, state, writeRuns } from "./support/browser.js";
import { press } from "./support/commands.js";

/** Frames of which the middle one counts. */
const FRAMES = 40;
const LIMITS = { 40: 16, 200: 33 };

/** Script of the frames of a page that plays, ms, and how many there were in a second. */
const measure = (page) =>
  page.evaluate(async (count) => {
    const { app } = window.plmPage;
    app.player.isLooping = true;
    const scripts = [];
    const tick = app.player.tick.bind(app.player);
    app.player.tick = (now) => {
      const started = performance.now();
      // A task behind the frame: everything of it has been drawn by then.
      queueMicrotask(() => scripts.push(performance.now() - started));
      return tick(now);
    };
    app.player.play();
    app.touch();
    const began = performance.now();
    while (scripts.length < count) await new Promise(requestAnimationFrame);
    app.player.stop();
    app.player.tick = tick;
    const rate = (1000 * count) / (performance.now() - began);
    return { script: scripts.sort((a, b) => a - b)[count >> 1], rate };
  }, FRAMES);

test("60 frames a second with three paths and all arrows", { skip }, async () => {
  const { page } = await open(writeRuns("arrows40", [chain(40, { end: 20, rate: 200 })]), { hash: "#paths=bar0.b|bar20.b|bar39.b&forces=1&velocities=1" });
  assert.equal(await state(page, "app.traces.length"), 3);
  let best = { script: Infinity, rate: 0 };
  for (let attempt = 0; attempt < 4 && best.rate < 57; attempt++) {
    const found = await measure(page);
    if (found.rate > best.rate) best = found;
  }
  console.log(`40 bodies, three paths, all arrows: ${best.script.toFixed(1)} ms of script a frame, ${best.rate.toFixed(0)} frames a second`);
  // The rate is the machine's while others use it; what the page takes of a frame is its own.
  assert.ok(best.script < 8, `${best.script} ms`);
});

for (const [count, limit] of Object.entries(LIMITS)) {
  test(`a frame of ${count} bodies takes less than ${limit} ms of script`, { skip }, async () => {
    const address = writeRuns(`chain${count}`, [chain(Number(count), { end: 4, rate: 50 })]);
    for (const view of ["front", "isometric"]) {
      const { page } = await open(address);
      await press(page, view);
      let best = { script: Infinity, rate: 0 };
      // Other programs may keep the machine busy.
      for (let attempt = 0; attempt < 4 && best.script > limit; attempt++) {
        const found = await measure(page);
        if (found.script < best.script) best = found;
      }
      console.log(`${count} bodies, ${view}: ${best.script.toFixed(1)} ms of script a frame, ${best.rate.toFixed(0)} frames a second`);
      assert.ok(best.script < limit, `${view}: ${best.script} ms`);
    }
  });
}
