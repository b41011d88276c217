// A live mechanism in the page: bodies are pulled and placed, by mouse and by keys.

import assert from "node:assert/strict";
import { test } from "node:test";
import { nativeRows } from "../tests/support/live.js";
import { livePage, FORCE, onScreen, pose, setting, skip } from "./support/livepage.js";
import { drawn, settle, shot, state } from "./support/browser.js";

test("a body is pulled by the mouse", { skip }, async () => {
  const { page, errors } = await livePage({ isRunning: false });
  // What it does by itself in the same time.
  const [x, y] = await onScreen(page, 1, [0.1, 0]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 120, y - 60, { steps: 4 });
  await settle(page);
  assert.ok((await drawn(page, "#picture", { force: FORCE })).force > 30, "the pull is drawn");
  const before = await pose(page, 1);
  await page.evaluate(() => window.plmPage.app.live.step(0.01, 20));
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 21);
  const pulled = await pose(page, 1);
  await shot(page, "live-pull");
  await page.mouse.up();
  const free = nativeRows()[19].subarray(7, 9);
  const went = [pulled[0] - free[0], pulled[1] - free[1]];
  assert.ok(Math.hypot(...went) > 0.005, `${before} ${pulled} without ${free}`);
  assert.ok(went[0] * 120 + went[1] * 60 > 0, `it goes where it is pulled: ${went}`);
  await settle(page);
  assert.equal((await drawn(page, "#picture", { force: FORCE })).force, 0, "and let go");
  // The force is gone: from the same state the same as without.
  assert.equal(await state(page, "app.drag"), null);
  assert.deepEqual(errors, []);
});

test("a body is pulled by keys", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  await page.click("#drag-pull");
  await page.click("#live-state");
  await page.keyboard.press(".");
  assert.deepEqual(await state(page, "app.selected"), { kind: "body", index: 0 });
  await page.keyboard.down("ArrowUp");
  await settle(page);
  assert.ok((await drawn(page, "#picture", { force: FORCE })).force > 20, "the pull is drawn");
  await page.evaluate(() => window.plmPage.app.live.step(0.01, 20));
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 21);
  const [, , pulled] = await pose(page, 0);
  await page.keyboard.up("ArrowUp");
  const free = nativeRows()[19][3];
  assert.ok(pulled > free + 0.05, `${pulled} ${free}`);
  await settle(page);
  assert.equal((await drawn(page, "#picture", { force: FORCE })).force, 0);
});

test("where there is no body, dragging moves the view", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  const before = await state(page, "app.view.target");
  await page.mouse.move(60, 120);
  await page.mouse.down();
  await page.mouse.move(100, 150, { steps: 3 });
  await page.mouse.up();
  assert.notDeepEqual(await state(page, "app.view.target"), before);
});

test("a body is placed by mouse and by keys, and the joints close", { skip }, async () => {
  const { page } = await livePage();
  await page.focus("#picture");
  await page.keyboard.press("Shift+H");
  await settle(page);
  assert.ok(await page.isChecked("#drag-place"));
  assert.ok(!(await state(page, "app.live.isRunning")), "it pauses");
  await page.keyboard.press("Shift+D");
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 1);
  await settle(page);
  const [x, y] = await onScreen(page, 0, [0.4, 0]);
  const before = await pose(page, 0);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 10, y + 30, { steps: 5 });
  await page.waitForFunction((angle) => Math.abs(window.plmPage.app.live.run.poses.at(0, 2) - angle) > 0.02, before[2]);
  await shot(page, "live-place");
  await page.mouse.up();
  const gap = async () => {
    const [a, c] = [await pose(page, 0), await pose(page, 1)];
    const reach = await setting(page, "parameter", 0);
    const end = [a[0] + 0.5 * Math.cos(a[2]), a[1] + 0.5 * Math.sin(a[2])];
    return Math.hypot(end[0] - c[0] + 0.5 * reach * Math.cos(c[2]), end[1] - c[1] + 0.5 * reach * Math.sin(c[2]));
  };
  assert.ok((await gap()) < 1e-9, `${await gap()}`);
  await page.waitForFunction(() => !window.plmPage.app.live.placing.isAsked);
  const placed = await pose(page, 0);
  await page.focus("#picture");
  for (const key of ["PageUp", "ArrowLeft"]) {
    await page.keyboard.press(key);
    await page.waitForFunction(() => !window.plmPage.app.live.placing.isAsked);
  }
  const moved = await pose(page, 0);
  assert.ok(moved[2] > placed[2] + 1e-3, `${placed} ${moved}`);
  assert.ok((await gap()) < 1e-9);
});
