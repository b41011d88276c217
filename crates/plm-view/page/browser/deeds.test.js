// Drawing in the playground by keyboard alone, and what is done to bars that are there.

import assert from "node:assert/strict";
import { test } from "node:test";
import { shot, state, until } from "./support/browser.js";
import { FOUR_BAR, drawing, isCurrent, isNear, isWhole, portAt } from "./support/hand.js";
import { playground, skip, typed } from "./support/playground.js";

test("a four-bar is drawn by keyboard alone", { skip }, async () => {
  const { page, errors } = await playground();
  await page.keyboard.press("Shift+N");
  assert.equal(await typed(page), "");
  const keys = async (...names) => {
    for (const name of names) await page.keyboard.press(name, { delay: 20 });
  };
  const many = (name, count) => Array.from({ length: count }, () => name);
  // A bar from the middle upwards, one to the right, one down again.
  await keys("ArrowUp", "Enter", ...many("ArrowUp", 8), "Enter", "Enter", ...many("ArrowRight", 20), ...many("ArrowUp", 6), "Enter");
  await keys("Enter", ...many("ArrowDown", 16), "Enter");
  assert.equal(((await typed(page)).match(/body bar/g) ?? []).length, 3);
  // Pins of the ground and the motor: Tab goes from pin to pin.
  await keys("Escape", "G", "Tab");
  await keys("Enter", "Tab", "Tab", "Tab", "Enter", "Escape", "M", "Tab", "Enter");
  await isWhole(page);
  // A number is typed for the pin that is chosen.
  await keys("Escape");
  for (let k = 0; k < 5; k++) {
    await keys("Tab");
    if (await page.evaluate(() => window.plmPlay.sketch.chosen?.owner !== "ground" && window.plmPlay.sketch.chosen?.port === "b")) break;
  }
  await keys("Enter");
  await page.keyboard.type("12");
  await keys("Tab", "Enter");
  const text = await isWhole(page);
  console.log(text);
  assert.match(text, /\(12, -?[\d.]+\) mm/);
  await shot(page, "draw-keyboard");
  await page.locator("#picture").focus();
  await page.keyboard.press("Space");
  await until(page, async () => (await state(page, "app.live.run.rows")) > 20, "it moves");
  assert.deepEqual(errors, []);
});

test("a bar is copied, its pin mirrored, a dimension locked, and a slider written into the text", { skip }, async () => {
  const { page, errors, hand } = await drawing();
  await hand.press(240, 140);
  await hand.take("sketch-mirror");
  assert.match(await typed(page), /let p3 = \(138\.08, -131\.78\) mm;/);
  await isWhole(page);
  await page.click("#sketch-undo");
  await isCurrent(page);
  await hand.press(140, 100);
  await hand.take("sketch-copy");
  assert.match(await typed(page), /body bar4 \{/);
  await page.click("#sketch-undo");
  assert.equal(await typed(page), FOUR_BAR);
  await isCurrent(page);
  await hand.press(200, 0);
  await page.click("#sketch-lock-x");
  await isWhole(page);
  assert.match(await typed(page), /param p4_x: mm = 200 mm;\n[^]*let p4 = \(p4_x, 0 mm\);/);
  // It has a slider, whose value goes into the text.
  await page.evaluate(() => window.plmPage.app.live.set("parameter", 0, 0.19));
  await page.waitForFunction(() => !document.querySelector("#write-parameter-0").hidden);
  await page.evaluate(() => document.querySelector("#write-parameter-0").click());
  assert.match(await typed(page), /param p4_x: mm = 190 mm;/);
  await isWhole(page);
  assert.ok(isNear(await portAt(page, "bar3", "b"), [190, 0]));
  for (let k = 0; k < 2; k++) await page.click("#sketch-undo");
  assert.equal(await typed(page), FOUR_BAR);
  assert.deepEqual(errors, []);
});

test("the pose on the screen becomes the start of the text", { skip }, async () => {
  const { page, errors } = await drawing(FOUR_BAR.replace("    constraint motor1: bar1.angle = 60 rev/min*t;\n", ""));
  await page.click("#sketch-draw");
  const angles = () => page.evaluate(() => {
    const { run } = window.plmPage.app.live;
    return run.mechanism.bodies.map((_, body) => run.poses.at(run.rows - 1, 6 * body + 2));
  });
  // It swings for a while, and is stopped.
  await page.click("#do-toggle");
  await until(page, async () => (await state(page, "app.live.run.end")) > 0.3, "it has swung");
  await page.click("#do-toggle");
  await until(page, async () => !(await state(page, "app.live.isRunning")), "it stands");
  await page.waitForTimeout(200);
  const [wanted, shown] = [await angles(), await page.evaluate(() => window.plmPlay.exchange.count)];
  await page.click("#live-as-start");
  const text = await typed(page);
  assert.match(text, /port b: p2; start angle: -?[\d.]+ deg, locked; \}/);
  assert.equal(text.match(/start /g).length, 1);
  await page.waitForFunction((before) => window.plmPlay.exchange.count > before && window.plmPage.app.live.run.rows > 0, shown);
  await isWhole(page);
  assert.equal(await state(page, "app.live.run.end"), 0);
  // Whole turns are left out.
  const away = (await angles()).map((angle, body) => Math.abs(Math.sin((angle - wanted[body]) / 2)));
  assert.ok(Math.max(...away) < 1e-4, String(away));
  await shot(page, "draw-as-start");
  await page.keyboard.press("Control+Z");
  assert.ok(!(await typed(page)).includes("start"));
  assert.deepEqual(errors, []);
});

test("a locked length stays while its bar is dragged, and is opened again", { skip }, async () => {
  const { page, errors, hand } = await drawing();
  await hand.press(240, 140);
  await page.locator("#sketch-lock-x").waitFor();
  // Without a bar of its own length nothing else is there; the pin of two bars has that of the first.
  await page.click("#sketch-lock-length");
  const text = await isWhole(page);
  assert.match(text, /param bar2_length: mm = 215\.407 mm;\n[^]*let p3 = p2 \+ turn\(\(bar2_length, 0 mm\), 21\.8014 deg\);/);
  assert.equal(await page.locator("#sketch-lock-length").getAttribute("aria-label"), "Unlock length");
  assert.equal(await page.locator("#parameter-0").inputValue(), "215.407");
  await hand.drag([240, 140], [200, 200], async () => {
    await page.waitForFunction(() => window.plmPlay.sketch.held?.isReady && !window.plmPlay.sketch.held.isBusy);
    await shot(page, "draw-locked");
  });
  await isWhole(page);
  const [x, y] = await portAt(page, "bar2", "b");
  assert.ok(Math.abs(Math.hypot(x - 40, y - 60) - 215.407) < 1e-6, `${x} ${y}`);
  await page.click("#sketch-undo");
  await isCurrent(page);
  await hand.press(240, 140);
  await page.click("#sketch-lock-length");
  assert.equal(await typed(page), FOUR_BAR);
  assert.deepEqual(errors, []);
});

test("a hand is told of a dead point, and where the assembly flips", { skip }, async () => {
  const { page, errors, hand } = await drawing();
  const words = () => page.evaluate(() => window.plmPlay.sketch.held.words);
  // From (40, 60) to (200, 0) the line passes (120, 30).
  await hand.drag([240, 140], [120, 30], async () => {
    assert.match(await words(), /^120, 30 mm; dead point: bar2 and bar3 are in line/);
    await shot(page, "draw-dead-point");
    await page.keyboard.press("Escape");
  });
  await isCurrent(page);
  await hand.drag([240, 140], [100, -20], async () => {
    assert.match(await words(), /flipped: bar2 and bar3 meet on the other side/);
    await page.keyboard.press("Escape");
  });
  assert.equal(await typed(page), FOUR_BAR);
  assert.deepEqual(errors, []);
});
