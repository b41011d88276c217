// How a page opens: it plays, shows the whole motion and one path, names what is under the mouse; and what its address keeps.

import assert from "node:assert/strict";
import { test } from "node:test";
import { doublePendulum, workshop } from "../tests/support/scenes.js";
import { drawn, frames, open, settle, skip, state, until, writeRuns } from "./support/browser.js";
import { press } from "./support/commands.js";
import { answered, livePage, onScreen, setting, skip as withoutModule } from "./support/livepage.js";

const addresses = skip ? {} : {
  pendulum: writeRuns("opening", [doublePendulum()]),
  short: writeRuns("short", [doublePendulum({ end: 0.5 })]),
  workshop: writeRuns("opened", [workshop()]),
};

/** Whether nothing touches the border of the picture. */
const isWhole = (page) =>
  page.evaluate(() => {
    const canvas = document.querySelector("#picture");
    const { width, height } = canvas;
    const context = canvas.getContext("2d");
    const sides = [[0, 0, width, 1], [0, 0, 1, height], [width - 1, 0, 1, height], [0, height - 1, width, 1]];
    return sides.every((side) => [...context.getImageData(...side).data].every((part, at, all) => part === all[at % 4]));
  });

test("a recorded page plays by itself, over and over, all of it in sight, with one path", { skip }, async () => {
  const { page, errors } = await open(addresses.pendulum, { plays: true });
  assert.deepEqual(await state(page, "[app.player.isPlaying, app.player.isLooping, app.traces]"), [true, true, ["forearm.tip"]]);
  await until(page, async () => (await state(page, "app.player.time")) > 0.1, "it moves");
  await page.click("#do-toggle");
  const view = await state(page, "JSON.stringify(app.view)");
  for (let at = 0; at <= 20; at++) {
    await page.evaluate((time) => (window.plmPage.app.player.seek(time), window.plmPage.app.touch()), 0.2 * at);
    await settle(page);
    assert.ok(await isWhole(page), `at ${0.2 * at} s`);
  }
  assert.equal(await state(page, "JSON.stringify(app.view)"), view);
  assert.deepEqual(errors, []);
});

test("a short run is slowed down", { skip }, async () => {
  const { page } = await open(addresses.short, { plays: true });
  assert.equal(await state(page, "app.player.speed"), 0.2);
});

test("who asks for less motion starts it, and a link to a moment shows that", { skip }, async () => {
  for (const how of [{ plays: false }, { plays: true, hash: "#t=1.5" }]) {
    const { page } = await open(addresses.pendulum, how);
    await frames(page);
    assert.deepEqual(await state(page, "[app.player.isPlaying, app.player.time]"), [false, how.hash === undefined ? 0 : 1.5]);
  }
});

test("the address names what was changed alone", { skip }, async () => {
  const { page } = await open(addresses.pendulum);
  await page.waitForFunction(() => location.hash === "#t=0");
  await press(page, "forces");
  await page.waitForFunction(() => location.hash === "#t=0&forces=1");
});

test("a name follows the mouse", { skip }, async () => {
  const { page } = await open(addresses.workshop, { hash: "#t=0.5&paths=" });
  const before = await drawn(page);
  const [x, y] = await page.evaluate(() => {
    const { app } = window.plmPage;
    const [gx, gy] = app.scene.at(app.player.time).poses.subarray(3, 5);
    const box = document.querySelector("#picture").getBoundingClientRect();
    const [px, py] = app.view.projection(app.area).point(gx, gy, app.scene.levels.bodies[1]);
    return [px + box.left, py + box.top];
  });
  await page.mouse.move(x, y);
  await settle(page);
  assert.equal(await page.getAttribute("#picture", "data-over"), "body");
  assert.notEqual((await drawn(page)).hash, before.hash);
  await page.mouse.move(5, 400);
  await page.mouse.move(1000, 300);
  await settle(page);
  assert.equal((await drawn(page)).hash, before.hash, "and goes with it");
});

test("a live page shows from its first second what it will do in six", { skip: withoutModule }, async () => {
  const { page, errors } = await livePage();
  await page.waitForFunction(() => window.plmPage.app.runViews.some(({ ahead }) => ahead !== null));
  await settle(page);
  const { scale } = await state(page, "app.view");
  assert.deepEqual(await state(page, "app.traces"), ["coupler.b"]);
  await page.evaluate(() => {
    const { live } = window.plmPage.app;
    live.pause();
    live.reset();
    live.step(0.01, 550);
  });
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 551);
  for (const time of [0, 1.3, 2.6, 4.1, 5.5]) {
    await page.evaluate((at) => (window.plmPage.app.player.seek(at), window.plmPage.app.touch()), time);
    await settle(page);
    assert.ok(await isWhole(page), `at ${time} s`);
  }
  assert.ok(Math.abs((await state(page, "app.view.scale")) / scale - 1) < 1e-3, "the view has not jumped");
  assert.deepEqual(errors, []);
});

test("an address keeps parameters and inputs that were changed", { skip: withoutModule }, async () => {
  const { page } = await livePage({ isRunning: false });
  await page.fill("#parameter-0", "350");
  await page.keyboard.press("Enter");
  await answered(page, 0, "value === 0.35");
  await page.fill("#input-0", "-2.5");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => location.hash.includes("p.reach=350") && location.hash.includes("i.torque=-2.5"));
  const hash = await page.evaluate(() => location.hash);
  assert.ok(!hash.includes("friction"), "what is as declared is not in it");
  const { page: again } = await livePage({ hash });
  assert.deepEqual([await setting(again, "parameter", 0), await setting(again, "input", 0)], [0.35, -2.5]);
  assert.equal(await again.inputValue("#parameter-0"), "350");
  await again.click("#live-reset");
  await again.waitForFunction(() => !location.hash.includes("p.reach") && !location.hash.includes("i.torque"));
});

test("a finger takes hold of what is near it", { skip: withoutModule }, async () => {
  const { page } = await livePage({ isRunning: false });
  const [x, y] = await onScreen(page, 0, [0, 0]);
  const radius = await state(page, "app.scene.radius * app.view.scale");
  // Beside the bar, across its direction.
  const [ex, ey] = await onScreen(page, 0, [0.5, 0]);
  const [dx, dy] = [ex - x, ey - y].map((part) => part / Math.hypot(ex - x, ey - y));
  const spot = { x: x - dy * (radius + 15), y: y + dx * (radius + 15) };
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.down();
  assert.equal(await state(page, "app.drag"), null, "a mouse does not");
  await page.mouse.up();
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setTouchEmulationEnabled", { enabled: true });
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [spot] });
  await page.waitForFunction(() => window.plmPage.app.drag !== null);
  assert.deepEqual(await state(page, "[app.drag.kind, app.drag.body]"), ["pull", 0]);
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await session.send("Emulation.setTouchEmulationEnabled", { enabled: false });
  await page.waitForFunction(() => window.plmPage.app.drag === null);
});
