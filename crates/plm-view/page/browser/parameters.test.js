// Parameters and inputs of a live mechanism in the page, turned by mouse and by key.

import assert from "node:assert/strict";
import { test } from "node:test";
import { answered, livePage, onScreen, pose, RED, setting, skip } from "./support/livepage.js";
import { drawn, pieces, settle, shot, state } from "./support/browser.js";

test("a parameter is turned by slider, by key and by number, in its unit", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  const slider = page.locator("#parameter-0-slider");
  assert.deepEqual([await page.inputValue("#parameter-0"), await slider.inputValue()], ["400", "400"]);
  const before = await drawn(page);
  const box = await slider.boundingBox();
  await page.mouse.click(box.x + 0.6 * box.width, box.y + 0.5 * box.height);
  await answered(page, 0, "value > 0.401");
  await settle(page);
  const turned = await setting(page, "parameter", 0);
  assert.ok(turned < 0.55, `${turned}`);
  assert.equal(Number(await page.inputValue("#parameter-0")), Math.round(turned * 1e3));
  assert.notEqual((await drawn(page)).hash, before.hash, "the coupler is longer");
  const length = await state(page, "app.live.mechanism.bodies[1].ports.map((port) => port.x)");
  assert.ok(Math.abs(length[1] - length[0] - turned) < 1e-12, `${length}`);
  await slider.press("ArrowRight");
  await page.waitForFunction((at) => Math.abs(window.plmPage.app.live.settings.parameter[0] - at - 0.004) < 1e-9, turned);
  // A number that no product with a thousandth gives; and back to that of the declaration.
  for (const [text, expected] of [["350", 0.35], ["400", 0.4]]) {
    await page.fill("#parameter-0", text);
    await page.keyboard.press("Enter");
    await answered(page, 0, `value === ${expected}`);
    await settle(page);
    assert.deepEqual([await page.inputValue("#parameter-0"), await setting(page, "parameter", 0)], [text, expected]);
  }
  // Beyond the range of the slider, which becomes longer.
  await page.fill("#parameter-1", "2.5");
  await page.keyboard.press("Enter");
  await answered(page, 1, "value === 2.5");
  await settle(page);
  assert.equal(await page.getAttribute("#parameter-1-slider", "max"), "2.5");
  assert.equal(await page.locator("[id^=input-]").count(), 2, "the page's own pulls are not shown");
  await page.fill("#input-0", "3");
  await page.keyboard.press("Enter");
  const start = await pose(page, 0);
  await page.click("#live-go");
  await page.waitForFunction(() => window.plmPage.app.live.run.end > 0.3);
  const driven = await pose(page, 0);
  assert.notDeepEqual(driven, start);
  await page.click("#live-reset");
  await page.waitForFunction(() => window.plmPage.app.live.settings.input[0] === 0);
  assert.deepEqual([await setting(page, "parameter", 0), await setting(page, "parameter", 1)], [0.4, 0.5]);
  // The field follows with the next frame.
  await page.waitForFunction(() => document.querySelector("#parameter-0").value === "400");
});

test("a value that changes in a field with the focus is selected, and what is typed replaces it", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  const field = page.locator("#parameter-0");
  await field.focus();
  await field.selectText();
  await page.evaluate(() => window.plmPage.app.live.set("parameter", 0, 0.42));
  await page.waitForFunction(() => document.querySelector("#parameter-0").value === "420");
  await page.keyboard.type("350");
  await page.keyboard.press("Enter");
  await answered(page, 0, "value === 0.35");
  await settle(page);
  assert.equal(await field.inputValue(), "350");
});

test("what cannot be assembled is told with its part, and mended", { skip }, async () => {
  for (const how of ["field", "key"]) {
    const { page, errors } = await livePage();
    assert.equal((await drawn(page, "#picture", { fault: RED })).fault, 0);
    await page.fill("#parameter-0", "9000");
    await page.keyboard.press("Enter");
    if (how === "key") {
      await page.focus("#picture");
      await page.keyboard.press("Shift+B");
    } else {
      await page.click("#live-restart");
    }
    // The length is told as soon as it is set, and again by the restart, which may name another joint.
    await page.waitForFunction(() => {
      const part = window.plmPage.app.run.fault?.part;
      const text = document.querySelector(".message.fault")?.textContent ?? "";
      return part && new RegExp(`^reach 9000 mm: ${part} is [0-9.]+ m open`).test(text);
    });
    await page.waitForFunction(() => !window.plmPage.app.live.isAssembled);
    await settle(page);
    assert.match(await page.textContent("#live-state"), /Not assembled/);
    assert.ok((await drawn(page, "#picture", { fault: RED })).fault > 30, "a ring around the part");
    await shot(page, "live-trouble");
    await page.fill("#parameter-0", "410");
    await page.keyboard.press("Enter");
    await page.click("#live-restart");
    await page.waitForFunction(() => window.plmPage.app.live.run.end > 0.1 && window.plmPage.app.run.fault === null);
    await settle(page);
    assert.equal(await page.locator(".message").count(), 0);
    assert.equal((await drawn(page, "#picture", { fault: RED })).fault, 0);
    assert.deepEqual(errors, []);
  }
});

test("contour and pin follow a parameter that is turned", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  await page.focus("#picture");
  for (const key of [".", "."]) await page.keyboard.press(key);
  const slider = page.locator("#parameter-0-slider");
  for (const turned of [0.4, 0.48]) {
    await slider.fill(String(1e3 * turned));
    await answered(page, 0, `Math.abs(value - ${turned}) < 1e-9`);
    await resting(page);
    await settle(page);
    const scale = await state(page, "app.view.scale");
    // The contour of the coupler is 1.2 of the parameter long and 60 mm high.
    const [, , angle] = await pose(page, 1);
    const [sin, cos] = [Math.abs(Math.sin(angle)), Math.abs(Math.cos(angle))];
    const outline = await pieces(page, [224, 135, 0]);
    const [left, right] = [Math.min(...outline.map((piece) => piece.left)), Math.max(...outline.map((piece) => piece.right))];
    const wide = (1.2 * turned * cos + 0.06 * sin) * scale;
    assert.ok(Math.abs(right - left - wide) < 5, `${turned} m: a contour of ${right - left} pixels instead of ${wide}`);
    // The pin at its end, a fifth of the parameter: much larger than without a size.
    const [crank, box] = [await onScreen(page, 0, [0.5, 0]), await page.locator("#picture").boundingBox()];
    const pins = await pieces(page, [44, 52, 66]);
    const [pin] = pins.sort((a, b) => distance(a, crank, box) - distance(b, crank, box));
    assert.ok(Math.abs(pin.right - pin.left + 1 - 0.2 * turned * scale) < 4, `${turned} m: a pin of ${pin.right - pin.left} pixels instead of ${0.2 * turned * scale}`);
  }
});

/** Waits until the view stays: after a start it is looked ahead, and the view is chosen anew. */
const resting = (page) => page.evaluate(async () => {
  const { view } = window.plmPage.app;
  let [scale, since] = [view.scale, performance.now()];
  while (performance.now() - since < 700) {
    await new Promise((later) => setTimeout(later, 50));
    if (view.scale !== scale) [scale, since] = [view.scale, performance.now()];
  }
});

const distance = ({ x, y }, [u, v], box) => Math.hypot(x + box.x - u, y + box.y - v);
