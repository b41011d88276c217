// A hand that draws in the playground, and what it sees there.

import assert from "node:assert/strict";
import { state, until } from "./browser.js";
import { playground, problems, typed } from "./playground.js";

/** Between two actions of a hand, ms. */
const PAUSE = 300;

export const isCurrent = (page) => page.waitForFunction(() => window.plmPlay.sketch.isCurrent && window.plmPage.app.live.run.rows > 0);

/** Where a place of the sheet, mm, is on the page. */
export const onScreen = (page, x, y) =>
  page.evaluate(
    ([px, py]) => {
      const { app } = window.plmPage;
      const { left, top } = document.querySelector("#picture").getBoundingClientRect();
      const [sx, sy] = app.view.projection(app.area).point(px / 1000, py / 1000, 0);
      return [left + sx, top + sy];
    },
    [x, y],
  );

/** A hand with a pointer alone. */
export function handOn(page) {
  const rest = () => page.waitForTimeout(PAUSE);
  const at = async (x, y) => page.mouse.move(...(await onScreen(page, x, y)), { steps: 4 });
  return {
    press: async (x, y) => {
      await at(x, y);
      await page.mouse.down();
      await page.mouse.up();
      await rest();
    },
    take: async (id) => {
      await page.click(`#${id}`);
      await rest();
    },
    drag: async (from, to, meanwhile = async () => {}) => {
      await at(...from);
      await page.mouse.down();
      const [[x0, y0], [x1, y1]] = [await onScreen(page, ...from), await onScreen(page, ...to)];
      for (let k = 1; k <= 10; k++) {
        await page.mouse.move(x0 + ((x1 - x0) * k) / 10, y0 + ((y1 - y0) * k) / 10);
        await page.waitForTimeout(20);
      }
      await meanwhile();
      await page.mouse.up();
      await rest();
    },
  };
}

/** What is drawn is a text in its layout, without diagnostics, and moves. */
export async function isWhole(page) {
  await isCurrent(page);
  await until(page, async () => (await page.locator("#editor-state").textContent()) === "Nothing is wrong.", "nothing is wrong");
  assert.deepEqual(await problems(page), []);
  const text = await typed(page);
  assert.deepEqual(await page.evaluate(() => window.plmPlay.pane.language.layout()), []);
  return text;
}

/** How far the bars turn in the next second. */
export async function turnsOn(page, body) {
  const angle = () => page.evaluate((name) => {
    const { run } = window.plmPage.app.live;
    const index = run.mechanism.bodies.findIndex((each) => each.name === name);
    return run.poses.at(run.rows - 1, 6 * index + 2);
  }, body);
  const before = await angle();
  await page.click("#do-toggle");
  await until(page, async () => Math.abs((await angle()) - before) > 1, `${body} turns`);
  assert.equal(await state(page, "app.live.run.fault"), null);
}

/** A four-bar that was drawn, as a text. */
export const FOUR_BAR = `pub Drawing {
    gravity: 9.81 m/s^2;
    let steel = 7850 kg/m^3;
    let p1 = (0, 0) mm;
    let p2 = (40, 60) mm;
    body bar1 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: steel; port a: p1; port b: p2; }
    let p3 = (240, 140) mm;
    body bar2 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: steel; port a: p2; port b: p3; }
    let p4 = (200, 0) mm;
    body bar3 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: steel; port a: p3; port b: p4; }
    ground { port g1: p1; }
    ground { port g2: p4; }
    revolute pin1(bar1.b, bar2.a);
    revolute pin2(bar2.b, bar3.a);
    revolute pin3(ground.g1, bar1.a);
    revolute pin4(ground.g2, bar3.b);
    constraint motor1: bar1.angle = 60 rev/min*t;
}
`;

/** The playground with a text on which somebody draws. */
export async function drawing(text = FOUR_BAR, how = {}) {
  const opened = await playground(text, how);
  await opened.page.click("#sketch-draw");
  await opened.page.click("#sketch-move");
  await isCurrent(opened.page);
  await opened.page.waitForFunction(() => window.plmPage.app.live.run.rows === 1);
  return { ...opened, hand: handOn(opened.page) };
}

/** Where a port stands in the picture, mm. */
export const portAt = (page, owner, port) =>
  page.evaluate(
    ([body, name]) => window.plmPlay.sketch.places().find((place) => place.owner === body && place.port === name)?.at.map((part) => 1000 * part),
    [owner, port],
  );

export const isNear = ([x, y], [a, b], within = 1e-9) => Math.hypot(x - a, y - b) < within;
