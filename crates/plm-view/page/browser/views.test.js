// What is looked at, and from where: views, arrows, the mouse, the window, objects; each function by mouse and by key.

import assert from "node:assert/strict";
import { test } from "node:test";
import { COMMANDS } from "../src/commands.js";
import { workshop } from "../tests/support/scenes.js";
import { BODIES, drawn, middleOf, open, settle, skip, state, writeRuns } from "./support/browser.js";
import { changes, everyWay as everyWayOf, isOn, press, pressKey } from "./support/commands.js";


const address = skip ? "" : writeRuns("views", [workshop()]);
const everyWay = (id, check, how = {}) => everyWayOf(id, check, { address, ...how });

test("views", { skip }, async () => {
  const pictures = new Map();
  for (const id of ["isometric", "back", "left", "right", "top", "bottom"]) {
    await everyWay(id, async (page, act, message) => {
      await changes(page, act, message);
      assert.ok(await isOn(page, id), message);
      pictures.set(id, (await drawn(page)).hash);
    });
  }
  assert.equal(new Set(pictures.values()).size, pictures.size, "each view shows something else");
  await everyWay("front", changes, { hash: "#view=30,20,200,0.8,0.3,0" });
  await everyWay("extents", async (page, act, message) => {
    await changes(page, act, message, 1000);
    const { x, y, count } = await middleOf(page, BODIES);
    assert.ok(count > 3000 && x > 100 && x < 700 && y > 100 && y < 700, `${message}: bodies at ${x} ${y}`);
  }, { hash: "#view=0,0,40,6,0.3,0" });
});

test("frames instead of surfaces", { skip }, async () => {
  await everyWay("wire", async (page, act, message) => {
    const before = await drawn(page, "#picture", { bodies: BODIES });
    await act();
    const after = await drawn(page, "#picture", { bodies: BODIES });
    assert.ok(before.bodies > 5000 && after.bodies < 0.2 * before.bodies && after.ink > 2000, `${message} ${after.bodies}`);
  });
});

test("arrows of forces and velocities, and their length", { skip }, async () => {
  for (const [id, colour] of [["forces", [194, 24, 91]], ["velocities", [0, 121, 107]]]) {
    await everyWay(id, async (page, act, message) => {
      const before = await drawn(page, "#picture", { arrow: colour });
      await act();
      const after = await drawn(page, "#picture", { arrow: colour });
      assert.ok(before.arrow < 20 && after.arrow > 100, `${message}: ${before.arrow}, ${after.arrow}`);
      await pressKey(page, "J");
      await settle(page);
      await page.focus("#arrows");
      for (let press = 0; press < 5; press++) await page.keyboard.press("ArrowRight");
      await settle(page);
      const longer = await drawn(page, "#picture", { arrow: colour });
      assert.ok(longer.arrow > after.arrow, `${message}: longer arrows`);
    }, { hash: "#t=0.6" });
  }
});

test("dragging pans, orbits, zooms", { skip }, async () => {
  const drag = async (page, dx, dy, options) => {
    await page.mouse.move(380, 400);
    await page.mouse.down(options);
    await page.mouse.move(380 + dx / 2, 400 + dy / 2);
    await page.mouse.move(380 + dx, 400 + dy);
    await page.mouse.up(options);
    await settle(page);
  };
  await everyWay("pan", async (page, act, message) => {
    await press(page, "orbit");
    await act();
    const before = await middleOf(page, BODIES);
    await changes(page, () => drag(page, 60, 30), message);
    const after = await middleOf(page, BODIES);
    assert.ok(Math.hypot(after.x - before.x - 60, after.y - before.y - 30) < 2, `${message} ${after.x - before.x}`);
  });
  await everyWay("orbit", async (page, act, message) => {
    await act();
    await changes(page, () => drag(page, 80, 40), message);
    const [azimuth, elevation] = [await state(page, "app.view.azimuth"), await state(page, "app.view.elevation")];
    assert.ok(azimuth === 40 && elevation === 20, `${message} ${azimuth} ${elevation}`);
  });
  await everyWay("zoom", async (page, act, message) => {
    await act();
    const before = await drawn(page);
    await drag(page, 0, 60);
    const smaller = await drawn(page);
    assert.ok(smaller.ink < 0.6 * before.ink && smaller.ink > 1000, `${message}: downwards reduces`);
    await drag(page, 0, -60);
    assert.ok((await drawn(page)).ink > 0.9 * before.ink, `${message}: upwards enlarges`);
  });
  const { page } = await open(address);
  await changes(page, () => drag(page, 50, 0, { button: "right" }), "the right button orbits");
  assert.equal(await state(page, "app.view.azimuth"), 25);
  await changes(page, async () => {
    await page.mouse.wheel(0, -300);
    await settle(page);
  }, "the wheel zooms");
  await changes(page, async () => {
    await page.mouse.dblclick(380, 700);
    await settle(page);
  }, "a double click shows everything");
});

test("zoom to window", { skip }, async () => {
  await everyWay("window", async (page, act, message) => {
    await act();
    const scale = await state(page, "app.view.scale");
    await page.mouse.move(200, 200);
    await page.mouse.down();
    await page.mouse.move(300, 250);
    await page.mouse.move(400, 350);
    await settle(page);
    assert.ok((await drawn(page, "#picture", { frame: [224, 135, 0] })).frame > 100, `${message}: the window is drawn`);
    await page.mouse.up();
    await settle(page);
    assert.ok((await state(page, "app.view.scale")) > 2 * scale, message);
    assert.ok((await drawn(page)).ink > 5000, message);
  });
  // By keys alone: the window is moved, made smaller and applied.
  const { page } = await open(address);
  const scale = await state(page, "app.view.scale");
  for (const key of ["W", "Shift+ArrowLeft", "Shift+ArrowUp", "-", "Enter"]) {
    await pressKey(page, key);
    await settle(page);
  }
  assert.ok(Math.abs((await state(page, "app.view.scale")) / scale - 2.5) < 0.01);
  await pressKey(page, "W");
  await pressKey(page, "Escape");
  assert.equal(await state(page, "app.window"), null);
});

test("keys move the view", { skip }, async () => {
  for (const { id } of COMMANDS.filter(({ group, id }) => group === "move" && !/Enter|Escape/.test(id))) {
    await everyWay(id, changes);
  }
});

test("object information", { skip }, async () => {
  await everyWay("info", async (page, act, message) => {
    await act();
    // The middle of all that is red is no object; a body is where it is known to be.
    const at = await page.evaluate(() => {
      const { app } = window.plmPage;
      const [x, y] = app.view.projection(app.area).point(app.scene.at(0).poses[3], app.scene.at(0).poses[4], 0);
      const box = document.querySelector("#picture").getBoundingClientRect();
      return { x: box.left + x, y: box.top + y };
    });
    await changes(page, async () => {
      await page.mouse.click(at.x, at.y);
      await settle(page);
    }, message);
    const facts = await page.textContent("#sheet-objects .facts");
    for (const word of ["coupler, body", "mass", "1 kg", "moment of inertia", "angular velocity", "velocity.x", "Points", "eye"]) {
      assert.ok(facts.includes(word), `${message}: ${word} in ${facts}`);
    }
    assert.match(await page.textContent("#spoken"), /coupler/);
  });
  for (const [id, expected] of [["next object", "crank, body"], ["object before", "ground.s"]]) {
    await everyWay(id, async (page, act, message) => {
      await changes(page, act, message);
      assert.match(await page.textContent("#spoken"), new RegExp(expected.replace(".", "\\.")), message);
      await pressKey(page, "Escape");
      await settle(page);
      assert.equal(await state(page, "app.selected"), null, message);
    });
  }
});
