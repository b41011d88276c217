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
