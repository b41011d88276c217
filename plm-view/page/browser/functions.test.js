// Every function of the page, once by mouse and once by key; what it does is looked for in what is drawn.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { COMMANDS } from "../src/commands.js";
import { doublePendulum, workshop } from "../tests/support/scenes.js";
import { drawn, middleOf, open, settle, skip, state, writeRuns } from "./support/browser.js";

const BLUE = [108, 158, 224];

const addresses = skip ? {} : {
  workshop: writeRuns("workshop", [workshop()]),
  batch: writeRuns("batch", [5, 10, 20].map((mass) => doublePendulum({ name: `${mass} kg`, mass, end: 2 }))),
};

const button = (id) => `#do-${id.replace(" ", "-")}`;

/** How each command is used: by its button and by each of its keys that reaches a page. */
const waysOf = (command) => [
  ...(command.icon === null ? [] : [{ how: "mouse", use: (page) => page.click(button(command.id)) }]),
  ...command.keys
    // These the browser keeps for itself; the second key does the same.
    .filter((key) => !["Ctrl+N", "Ctrl+Q"].includes(key))
    .map((key) => ({ how: key, use: (page) => pressKey(page, key) })),
];

const pressKey = (page, key) =>
  page.keyboard.press(key.replace("Ctrl", "Control").replace(/(^|\+)([A-Z])$/, (_, before, letter) => before + `Key${letter}`));

/** Runs a check for each way of using a command, each on a page as it opens. */
async function everyWay(id, check, { address = addresses.workshop, hash = "" } = {}) {
  const command = COMMANDS.find((candidate) => candidate.id === id);
  assert.ok(command, id);
  for (const { how, use } of waysOf(command)) {
    const { page, errors } = await open(address, { hash });
    const act = async () => {
      await use(page);
      await settle(page);
    };
    await check(page, act, `${id} by ${how}`);
    assert.deepEqual(errors, [], `${id} by ${how}`);
  }
}

/** The picture changes, and something is still drawn. */
async function changes(page, act, message, least = 5000) {
  const before = await drawn(page);
  await act();
  const after = await drawn(page);
  assert.ok(Math.min(before.ink, after.ink) > least, `${message}: ${before.ink}, then ${after.ink} pixels are drawn`);
  assert.notEqual(after.hash, before.hash, `${message} changes the picture`);
}

const time = (page) => state(page, "app.player.time");

test("jumps and steps", { skip }, async () => {
  const hash = "#t=1.3";
  for (const [id, expected] of [["start", 0], ["end", 4], ["back step", 1.25], ["forward step", 1.35]]) {
    await everyWay(id, async (page, act, message) => {
      await changes(page, act, message);
      assert.ok(Math.abs((await time(page)) - expected) < 1e-9, `${message}: ${await time(page)}`);
      assert.match(await page.textContent("#now"), new RegExp(expected.toFixed(3)));
      const slider = Number(await page.inputValue("#time"));
      assert.ok(Math.abs(slider - expected / 4) < 1e-6, `${message}: the slider is at ${slider}`);
    }, { hash });
  }
});

test("play and stop", { skip }, async () => {
  await everyWay("play", async (page, act, message) => {
    await changes(page, async () => {
      await act();
      await page.waitForTimeout(400);
    }, message);
    assert.ok((await time(page)) > 0.05, message);
    assert.equal(await page.getAttribute("#do-play", "aria-pressed"), "true");
  });
  for (const id of ["stop", "toggle"]) {
    await everyWay(id, async (page, act, message) => {
      await page.click("#do-play");
      await page.waitForTimeout(200);
      await page.focus("#picture");
      await act();
      const stopped = await time(page);
      await page.waitForTimeout(200);
      assert.ok(stopped > 0 && (await time(page)) === stopped, `${message}: ${stopped}`);
    });
  }
});

test("loop begins anew, and without it the end is the end", { skip }, async () => {
  await everyWay("loop", async (page, act, message) => {
    await act();
    await page.click("#do-play");
    await page.waitForFunction(() => window.plmPage.app.player.time < 3.5, null, { timeout: 5000 });
    assert.ok(await state(page, "app.player.isPlaying"), message);
  }, { hash: "#t=3.8" });
  const { page } = await open(addresses.workshop, { hash: "#t=3.8" });
  await page.click("#do-play");
  await page.waitForFunction(() => !window.plmPage.app.player.isPlaying, null, { timeout: 5000 });
  assert.equal(await time(page), 4);
});

test("speed", { skip }, async () => {
  for (const [id, expected] of [["slower", 0.5], ["faster", 2]]) {
    await everyWay(id, async (page, act, message) => {
      await act();
      assert.equal(await page.inputValue("#speed"), String(expected), message);
    });
  }
  const { page } = await open(addresses.workshop);
  await page.selectOption("#speed", "0.1");
  await page.click("#do-play");
  await page.waitForTimeout(500);
  assert.ok((await time(page)) < 0.1, "a tenth of the time that passed");
});

test("views", { skip }, async () => {
  const pictures = new Map();
  for (const id of ["isometric", "back", "left", "right", "top", "bottom"]) {
    await everyWay(id, async (page, act, message) => {
      await changes(page, act, message);
      assert.equal(await page.getAttribute(button(id), "aria-pressed"), "true", message);
      pictures.set(id, (await drawn(page)).hash);
    });
  }
  assert.equal(new Set(pictures.values()).size, pictures.size, "each view shows something else");
  await everyWay("front", changes, { hash: "#view=30,20,200,0.8,0.3,0" });
  await everyWay("extents", async (page, act, message) => {
    await changes(page, act, message, 1000);
    const { x, y, count } = await middleOf(page, BLUE);
    assert.ok(count > 3000 && x > 100 && x < 700 && y > 100 && y < 700, `${message}: bodies at ${x} ${y}`);
  }, { hash: "#view=0,0,40,6,0.3,0" });
});

test("frames instead of surfaces", { skip }, async () => {
  await everyWay("wire", async (page, act, message) => {
    const before = await drawn(page, "#picture", { blue: BLUE });
    await act();
    const after = await drawn(page, "#picture", { blue: BLUE });
    assert.ok(before.blue > 5000 && after.blue < 0.2 * before.blue && after.ink > 2000, `${message} ${after.blue}`);
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
    await page.click("#do-orbit");
    await act();
    const before = await middleOf(page, BLUE);
    await changes(page, () => drag(page, 60, 30), message);
    const after = await middleOf(page, BLUE);
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
  const { page } = await open(addresses.workshop);
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
  const { page } = await open(addresses.workshop);
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

test("clear, reload, open, exit", { skip }, async () => {
  await everyWay("clear", async (page, act, message) => {
    await act();
    const { ink } = await drawn(page);
    assert.equal(ink, 0, `${message}: ${ink} pixels are left`);
    assert.ok(await page.isVisible("#empty"), message);
    assert.ok(await page.isDisabled("#do-play"), message);
  });
  await everyWay("reload", async (page, act, message) => {
    const before = await drawn(page);
    await pressKey(page, "F");
    await pressKey(page, "N");
    await act();
    await page.waitForFunction(() => window.plmPage.app.run !== null);
    await settle(page);
    assert.equal((await drawn(page)).hash, before.hash, `${message}: as it was at the start`);
  });
  await everyWay("open", async (page, act, message) => {
    const chooser = page.waitForEvent("filechooser");
    await act();
    const npz = addresses.batch.replace("file://", "").replace(".html", ".npz");
    await (await chooser).setFiles(npz);
    await page.waitForFunction(() => window.plmPage.app.shown.length === 3);
    await settle(page);
    assert.ok((await drawn(page)).ink > 3000, message);
  });
  await everyWay("exit", async (page, act, message) => {
    await act();
    const closed = await Promise.race([
      page.waitForEvent("close", { timeout: 3000 }).then(() => true).catch(() => false),
      page.waitForSelector(".message.note", { timeout: 3000 }).then(() => true).catch(() => false),
    ]);
    assert.ok(closed, `${message}: the page closes, or says who can close it`);
  });
});

test("save the picture", { skip }, async () => {
  await everyWay("png", async (page, act, message) => {
    const download = page.waitForEvent("download");
    await act();
    const file = await download;
    assert.equal(file.suggestedFilename(), "Workshop.png");
    const bytes = readFileSync(await file.path());
    assert.equal(bytes.toString("latin1", 1, 4), "PNG", message);
    assert.equal(bytes.readUInt32BE(16), 2 * (await state(page, "app.area.width")), `${message}: twice as wide`);
    assert.ok(bytes.length > 10000, message);
  });
  await everyWay("svg", async (page, act, message) => {
    const download = page.waitForEvent("download");
    await act();
    const text = readFileSync(await (await download).path(), "utf8");
    // The browser's own reader of XML finds it well formed, and it draws.
    const { shapes, broken } = await page.evaluate((svg) => {
      const read = new DOMParser().parseFromString(svg, "image/svg+xml");
      return { shapes: read.querySelectorAll("polygon").length, broken: read.querySelector("parsererror") !== null };
    }, text);
    assert.ok(!broken && shapes > 30, `${message}: ${shapes} polygons`);
  });
  const { page } = await open(addresses.workshop);
  const download = page.waitForEvent("download");
  await page.click("text=Save curves (SVG)");
  assert.equal((await download).suggestedFilename(), "Workshop-curves.svg");
});

test("theme, panel, options, help", { skip }, async () => {
  await everyWay("theme", async (page, act, message) => {
    const { back } = await drawn(page);
    await act();
    const dark = await drawn(page);
    assert.ok(back[0] > 200 && dark.back[0] < 60 && dark.ink > 5000, `${message}: ${back} ${dark.back}`);
  });
  await everyWay("panel", async (page, act, message) => {
    const before = await page.evaluate(() => document.querySelector("#picture").clientWidth);
    await act();
    assert.ok((await page.evaluate(() => document.querySelector("#picture").width)) > before + 200, message);
    assert.ok(!(await page.isVisible("#panel")), message);
  });
  await everyWay("options", async (page, act, message) => {
    await act();
    await page.fill("#background", "#204060");
    await page.fill("#rate", "10");
    await page.fill("#step", "0.25");
    await page.keyboard.press("Escape");
    // A frame is 0.1 s now.
    await page.waitForTimeout(300);
    await settle(page);
    const { back, ink } = await drawn(page);
    assert.ok(Math.abs(back[0] - 0x20) < 3 && Math.abs(back[2] - 0x60) < 3 && ink > 5000, `${message}: ${back}`);
    await page.focus("#picture");
    await pressKey(page, "F");
    assert.equal(await time(page), 0.25, message);
    const frames = await page.evaluate(async () => {
      const { app } = window.plmPage;
      let frames = 0;
      const tick = app.player.tick.bind(app.player);
      app.player.tick = (now) => (frames++, tick(now));
      app.player.play();
      app.touch();
      await new Promise((done) => setTimeout(done, 1000));
      return frames;
    });
    assert.ok(frames >= 5 && frames <= 11, `${message}: ${frames} frames in a second at a rate of 10`);
  });
  const { page } = await open(addresses.workshop);
  await page.click("#do-options");
  await page.uncheck("#plain-keys");
  await page.keyboard.press("Escape");
  await page.focus("#picture");
  await pressKey(page, "F");
  assert.equal(await time(page), 0, "keys of one letter are switched off");
  await pressKey(page, "Ctrl+F");
  assert.equal(await time(page), 0.05);
  await everyWay("help", async (page, act, message) => {
    await act();
    const text = await page.textContent("dialog[open]");
    for (const command of COMMANDS) assert.ok(text.includes(command.name), `${message}: ${command.name}`);
    await page.keyboard.press("Escape");
    await page.waitForSelector("dialog", { state: "detached" });
  });
});

test("events are jumped to", { skip }, async () => {
  for (const [id, expected] of [["event after", 2.5], ["event before", 1.25]]) {
    await everyWay(id, async (page, act, message) => {
      await changes(page, act, message);
      assert.equal(await time(page), expected, message);
    }, { hash: "#t=2" });
  }
  const { page } = await open(addresses.workshop);
  await page.click("#tab-runs");
  await page.click("text=2.500 s");
  assert.equal(await time(page), 2.5);
  const { ink } = await drawn(page, "#marks");
  assert.ok(ink > 10, "events on the time line");
});

test("tabs", { skip }, async () => {
  for (const tab of ["curves", "objects", "runs", "model"]) {
    const from = tab === "curves" ? "#tab=model" : "";
    await everyWay(`${tab} tab`, async (page, act, message) => {
      await act();
      assert.ok(await page.isVisible(`#sheet-${tab}`), message);
    }, { hash: from });
    const { page } = await open(addresses.workshop, { hash: from });
    await page.click(`#tab-${tab}`);
    await settle(page);
    assert.ok(await page.isVisible(`#sheet-${tab}`));
    assert.ok((await page.textContent(`#sheet-${tab}`)).length > 10);
  }
});

test("runs: one, overlaid, side by side; the next and the one before", { skip }, async () => {
  const { page } = await open(addresses.batch, { hash: "#t=1&tab=runs" });
  const one = await drawn(page);
  await page.click("#layout-overlay");
  await settle(page);
  const overlay = await drawn(page);
  assert.ok(overlay.ink > 1.3 * one.ink, `${one.ink} ${overlay.ink}`);
  await page.click("#show-2");
  await settle(page);
  const two = await drawn(page);
  assert.ok(two.ink < overlay.ink && two.ink > one.ink, "a run is hidden");
  await page.click("#layout-side");
  await settle(page);
  const side = await drawn(page);
  assert.ok(side.hash !== two.hash && side.ink > 2000);
  await page.focus("#layout-side");
  await page.keyboard.press("ArrowLeft");
  await settle(page);
  assert.equal(await state(page, "app.layout"), "overlay", "by key");
  for (const [id, expected] of [["run after", "10 kg"], ["run before", "5 kg"]]) {
    await everyWay(id, async (each, act, message) => {
      await act();
      assert.equal(await state(each, "app.run.name"), expected, message);
      assert.ok((await drawn(each)).ink > 3000, message);
    }, { address: addresses.batch, hash: id === "run before" ? "#run=10 kg" : "" });
  }
});

test("every command is used above", { skip }, () => {
  const source = readFileSync(new URL(import.meta.url), "utf8");
  const missing = COMMANDS.filter(({ id, group }) => group !== "move" && !id.endsWith("tab") && !source.includes(`"${id}"`));
  assert.deepEqual(missing.map(({ id }) => id), []);
});
