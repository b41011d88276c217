// The panel of the equations: those of what moves, which cost nothing until they are asked for.

import assert from "node:assert/strict";
import { test } from "node:test";
import { shot, until } from "./support/browser.js";
import { PENDULUM, playground, skip, type } from "./support/playground.js";

/** The text of each equation, as a reader of the screen has it. */
const equations = (page) =>
  page.evaluate(() => [...document.querySelectorAll("#equations p")].map((line) => line.textContent.replaceAll(/\s/g, "")));
const open = async (page) => {
  await page.click("#tab-equations");
  await page.waitForFunction(() => document.querySelectorAll("#equations p math").length > 0);
};

/** A physical pendulum: of the books, `(I + m l^2) w' + m g l sin = 0`; the angle of a bar is from the horizontal here. */
const ROD = `pub Rod {
    param m_1: kg = 2 kg;
    param I: kg*m^2 = 0.5 kg*m^2;
    param l: m = 1 m;
    param g: m/s^2 = 9.81 m/s^2;
    gravity: g;
    ground { port o: (0, 0) m; }
    body rod { mass: m_1; inertia: I; port pivot: (-l, 0 m); start angle: 30 deg, locked; }
    revolute hinge(ground.o, rod.pivot);
}
`;

test("the equation of a pendulum is that of the books", { skip }, async () => {
  const { page, errors } = await playground(ROD);
  await open(page);
  assert.deepEqual(await equations(page), ["(I+m1l2)φ¨rod+m1lgcosφrod=0"]);
  assert.equal(await page.locator("#equations dd").textContent(), "rod.angle");
  assert.deepEqual(errors, []);
});

test("no worker is there for it until it is opened", { skip }, async () => {
  const { page } = await playground(PENDULUM);
  // What is typed first starts the workers that wait for texts.
  await type(page, PENDULUM.replace("= 1 m", "= 2 m"));
  await page.waitForFunction(() => window.plmPage.app.live.mechanism.parameters[0].default === 2);
  // Of what moves, of the language, and one that waits.
  await until(page, () => page.workers().length === 3, "three workers are there");
  assert.equal(await page.locator("#equations p").count(), 0);
  await open(page);
  assert.equal(page.workers().length, 4);
});

test("they follow the text, and stay where it has an error", { skip }, async () => {
  const { page } = await playground(PENDULUM);
  await open(page);
  const [first] = await equations(page);
  assert.match(first, /length2/);
  await type(page, PENDULUM.replaceAll("length", "reach"));
  await until(page, async () => (await equations(page))[0] === first.replaceAll("length", "reach"), "the name is the new one");
  await type(page, PENDULUM.replace("revolute", "revolut"));
  await page.waitForFunction(() => document.querySelector("#editor").dataset.state === "errors");
  assert.deepEqual(await equations(page), [first.replaceAll("length", "reach")]);
  // Nothing is left of them on an empty sheet.
  await type(page, "");
  await until(page, async () => (await page.locator("#equations p").count()) === 0, "they are gone");
  assert.match(await page.textContent("#equations-told"), /There are none/);
  assert.ok(await page.isDisabled("#equations-copy"));
});

test("LaTeX is copied as a whole", { skip }, async () => {
  const { page } = await playground(ROD);
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await open(page);
  await page.click("#equations-copy");
  await page.waitForFunction(() => document.querySelector("#equations-copy").textContent === "Copied");
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(
    copied,
    "% Rod\n% rod.angle: $\\varphi_{\\mathrm{rod}}$\n\\[ \\left(I + m_{1} l^{2}\\right) \\ddot{\\varphi}_{\\mathrm{rod}} + m_{1} l g \\cos \\varphi_{\\mathrm{rod}} = 0 \\]",
  );
});

for (const [width, theme] of [[1200, "light"], [1200, "dark"], [390, "light"], [390, "dark"]]) {
  test(`lines end in front of signs, and nothing is wider than the panel, at ${width} px, ${theme}`, { skip }, async () => {
    const { page } = await playground(null, { width, theme });
    await open(page);
    // Each is drawn as a formula: a fraction is higher than its line of text.
    const seen = await page.evaluate(() => {
      const sheet = document.querySelector("#sheet-equations").getBoundingClientRect();
      const lines = [...document.querySelectorAll("#equations p")];
      const tops = lines.map((line) => new Set([...line.querySelectorAll("math")].map((term) => Math.round(term.getBoundingClientRect().bottom))).size);
      const [math, panel] = [getComputedStyle(lines[0].firstElementChild).color, getComputedStyle(document.body).color];
      const tabs = document.querySelector("#panel [role=tablist]");
      return { wide: lines.filter((line) => line.getBoundingClientRect().right > sheet.right + 1).length, tops, math, panel, tabs: tabs.scrollWidth - tabs.clientWidth };
    });
    assert.equal(seen.wide, 0);
    assert.ok(seen.tops.some((count) => count > 1), `an equation goes over lines: ${seen.tops}`);
    assert.equal(seen.math, seen.panel);
    assert.ok(seen.tabs <= 0, `tabs are ${seen.tabs} px too wide`);
    await shot(page, `equations-${width}-${theme}`);
  });
}
