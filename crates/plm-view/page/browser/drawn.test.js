// Mechanisms of textbooks, drawn in the playground from an empty page by pointer alone; each moves as its geometry says.

import assert from "node:assert/strict";
import { test } from "node:test";
import { shot, state, until } from "./support/browser.js";
import { handOn, isWhole, turnsOn } from "./support/hand.js";
import { playground, skip } from "./support/playground.js";

/** A turn of the wrist: tools by their words, and what is pressed with each. @param {any} page @param {[string, number[][]][]} strokes */
async function draws(page, strokes) {
  const hand = handOn(page);
  await hand.take("editor-new");
  for (const [tool, places] of strokes) {
    const isPart = (await page.locator(`#sketch-${tool}`).count()) === 0;
    if (isPart) {
      await page.selectOption("#sketch-more", tool);
      await page.waitForTimeout(300);
    } else await hand.take(`sketch-${tool}`);
    for (const [x, y, shift] of places) {
      if (shift === 1) await page.keyboard.down("Shift");
      await hand.press(x, y);
      if (shift === 1) await page.keyboard.up("Shift");
    }
  }
  return isWhole(page);
}

/** A mechanism that is drawn in less than a minute. @param {string} name @param {[string, number[][]][]} strokes @param {(page: any, text: string) => Promise<void>} look */
const drawn = (name, strokes, look) =>
  test(`${name} is drawn from an empty page by pointer alone`, { skip }, async () => {
    const { page, errors } = await playground();
    const began = Date.now();
    const text = await draws(page, strokes);
    console.log(`${name} in ${((Date.now() - began) / 1000).toFixed(1)} s\n${text}`);
    assert.ok(Date.now() - began < 60_000);
    await page.evaluate(() => window.plmPage.app.zoomToExtents());
    await shot(page, `draw-${name.toLowerCase().replace(/\W+/g, "-")}`);
    await look(page, text);
    assert.deepEqual(errors, []);
  });

/** The places of a port in all rows of the run, m. @returns {Promise<number[][]>} */
const pathOf = (page, body, port) =>
  page.evaluate(
    ([owner, name]) => {
      const { run } = window.plmPage.app.live;
      const index = run.mechanism.bodies.findIndex((each) => each.name === owner);
      const at = run.mechanism.bodies[index].ports.find((each) => each.name === name);
      return Array.from({ length: run.rows }, (_, row) => {
        const [x, y, turn] = [0, 1, 2].map((axis) => run.poses.at(row, 6 * index + axis));
        return [x + Math.cos(turn) * at.x - Math.sin(turn) * at.y, y + Math.sin(turn) * at.x + Math.cos(turn) * at.y];
      });
    },
    [body, port],
  );

/** How far places are apart at most from what they are said to be. @param {number[][]} path @param {(place: number[]) => number} error */
const largest = (path, error) => Math.max(...path.map((place) => Math.abs(error(place))));

/** It runs until a bar has turned by so much, or until nothing goes on. */
async function runs(page, seconds) {
  await page.click("#do-toggle");
  await until(page, async () => (await state(page, "app.live.run.fault !== null")) || (await state(page, "app.live.run.end")) > seconds, `${seconds} s have passed`);
}

drawn(
  "Watt's six-bar",
  [
    ["bar", [[0, 0], [40, 60], [40, 60], [240, 140], [240, 140], [200, 0]]],
    ["point", [[140, 100], [180, 220], [220, 70], [300, 60]]],
    ["bar", [[180, 220], [330, 190], [330, 190], [300, 60]]],
    ["ground", [[0, 0], [200, 0]]],
    ["motor", [[0, 0]]],
  ],
  async (page, text) => {
    assert.equal((text.match(/port c: /g) ?? []).length, 2);
    assert.equal((text.match(/body /g) ?? []).length, 5);
    await turnsOn(page, "bar1");
    // The length of the fifth bar ties two points of ternary links.
    const [one, other] = [await pathOf(page, "bar2", "c"), await pathOf(page, "bar5", "a")];
    const length = Math.hypot(0.15, 0.03);
    assert.ok(largest(one, (at) => Math.hypot(at[0] - other[one.indexOf(at)][0], at[1] - other[one.indexOf(at)][1]) - length) < 1e-9);
  },
);

drawn(
  "Whitworth's quick return",
  [
    ["bar", [[0, 0], [50, 40], [0, -20], [100, 100], [100, 100], [300, -20]]],
    ["ground", [[0, 0], [0, -20]]],
    ["slide", [[50, 40], [80, 76], [300, -20], [400, -20]]],
    ["motor", [[0, 0]]],
  ],
  async (page, text) => {
    assert.match(text, /port s: p3, axis: p4 - p3;/);
    assert.match(text, /pin_slot slide1\(bar2\.s, bar1\.b\);/);
    await turnsOn(page, "bar1");
    // The lever points from its pivot to the pin of the crank.
    const [pins, levers] = [await pathOf(page, "bar1", "b"), await pathOf(page, "bar2", "b")];
    const off = largest(pins, (pin) => {
      const lever = levers[pins.indexOf(pin)];
      return (lever[0] * (pin[1] + 0.02) - (lever[1] + 0.02) * pin[0]) / Math.hypot(lever[0], lever[1] + 0.02);
    });
    assert.ok(off < 1e-9, String(off));
    assert.ok(largest(await pathOf(page, "bar3", "b"), (at) => at[1] + 0.02) < 1e-9);
  },
);

drawn(
  "Peaucellier's inversor",
  [
    ["bar", [[0, 0], [80, 140], [0, 0], [160, -20], [80, 140], [80, 40], [80, 40], [160, -20], [160, -20], [160, 80], [160, 80], [80, 140], [50, 0], [80, 40]]],
    ["ground", [[0, 0], [50, 0]]],
    ["motor", [[50, 0]]],
  ],
  async (page) => {
    // Its pen stands on the line on which it moves, x = (L^2 - s^2)/2r.
    const x = (0.08 ** 2 + 0.14 ** 2 - 0.1 ** 2) / 0.1;
    assert.ok(largest((await pathOf(page, "bar5", "b")).slice(0, 1), (at) => at[0] - x) < 1e-9);
  },
);

drawn(
  "Pumpjack",
  [
    ["bar", [[60, 20], [80, 40], [80, 40], [60, 160], [60, 160], [260, 160]]],
    ["point", [[110, 160], [150, 160, 1]]],
    ["bar", [[260, 160], [260, 40]]],
    ["ground", [[60, 20]]],
    ["slide", [[260, 40], [260, -40]]],
    ["motor", [[60, 20]]],
  ],
  async (page, text) => {
    assert.match(text, /port c: p5; \}/);
    assert.match(text, /axis: 90 deg/);
    await turnsOn(page, "bar1");
    const rod = await pathOf(page, "bar4", "b");
    assert.ok(largest(rod, (at) => at[0] - 0.26) < 1e-9);
    assert.ok(Math.max(...rod.map((at) => at[1])) - Math.min(...rod.map((at) => at[1])) > 0.01);
  },
);

drawn(
  "Scissor lift",
  [
    ["bar", [[0, 0], [200, 120], [0, 120], [200, 0], [0, 120], [260, 120]]],
    ["point", [[50, 30], [100, 60], [50, 90], [100, 60]]],
    ["ground", [[0, 0]]],
    ["slide", [[200, 0], [300, 0], [200, 120], [240, 120]]],
    ["spring", [[0, 0], [200, 0]]],
  ],
  async (page, text) => {
    assert.match(text, /revolute pin\d+\(bar1\.c, bar2\.c\);/);
    await runs(page, 0.5);
    assert.equal(await state(page, "app.live.run.fault"), null);
    const [left, right] = [await pathOf(page, "bar3", "a"), await pathOf(page, "bar3", "b")];
    // The platform stays level while it sinks.
    assert.ok(largest(left, (at) => at[1] - right[left.indexOf(at)][1]) < 1e-9);
    assert.ok(left[0][1] - Math.min(...left.map((at) => at[1])) > 1e-3);
    assert.ok(largest(left, (at) => at[0]) < 1e-9);
  },
);

drawn(
  "Klann's leg",
  [
    ["bar", [[180, 40], [220, 40], [220, 40], [132, 40], [92, 14], [132, 40], [145, 132], [90, 187], [90, 187], [55, 57]]],
    ["point", [[150, 40], [55, 57], [72, 122], [90, -72]]],
    ["ground", [[180, 40], [92, 14], [145, 132]]],
    ["motor", [[180, 40]]],
  ],
  async (page) => {
    await turnsOn(page, "bar1");
    await until(page, async () => (await state(page, "app.live.run.end")) > 1, "a turn");
    assert.equal(await state(page, "app.live.run.fault"), null);
    // A foot goes far along the ground, and is lifted.
    const foot = await pathOf(page, "bar5", "c");
    const range = (axis) => Math.max(...foot.map((at) => at[axis])) - Math.min(...foot.map((at) => at[axis]));
    assert.ok(range(0) > 0.1 && range(1) > 0.03, `${range(0)} ${range(1)}`);
  },
);
