// The functions of the page, once by mouse and once by key; what each does is looked for in what is drawn. Views have a file
// of their own, and curves.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { COMMANDS } from "../src/commands.js";
import { doublePendulum, workshop } from "../tests/support/scenes.js";
import { drawn, frames, open, settle, skip, state, writeRuns } from "./support/browser.js";
import { changes, everyWay as everyWayOf, isOn, press, pressKey, time } from "./support/commands.js";


const addresses = skip ? {} : {
  workshop: writeRuns("workshop", [workshop()]),
  batch: writeRuns("batch", [5, 10, 20].map((mass) => doublePendulum({ name: `${mass} kg`, mass, end: 2 }))),
};
const everyWay = (id, check, how = {}) => everyWayOf(id, check, { address: addresses.workshop, ...how });

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
      await page.waitForFunction(() => window.plmPage.app.player.time > 0.05);
      await settle(page);
    }, message);
    assert.ok(await isOn(page, "play"), message);
  });
  for (const id of ["stop", "toggle"]) {
    await everyWay(id, async (page, act, message) => {
      await press(page, "play");
      await page.waitForFunction(() => window.plmPage.app.player.time > 0);
      await page.focus("#picture");
      await act();
      const stopped = await time(page);
      await frames(page);
      assert.ok(stopped > 0 && (await time(page)) === stopped, `${message}: ${stopped}`);
    });
  }
});

test("loop begins anew, and without it the end is the end", { skip }, async () => {
  await everyWay("loop", async (page, act, message) => {
    await act();
    await press(page, "play");
    await page.waitForFunction(() => window.plmPage.app.player.time < 3.5);
    assert.ok(await state(page, "app.player.isPlaying"), message);
  }, { hash: "#t=3.8" });
  const { page } = await open(addresses.workshop, { hash: "#t=3.8" });
  await press(page, "play");
  await page.waitForFunction(() => !window.plmPage.app.player.isPlaying);
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
  const began = await page.evaluate(() => performance.now());
  await press(page, "play");
  await page.waitForFunction(() => window.plmPage.app.player.time > 0.01);
  const [shown, passed] = await page.evaluate((from) => [window.plmPage.app.player.time, performance.now() - from], began);
  assert.ok(shown <= 0.1e-3 * passed, `a tenth of the time that passed: ${shown} s in ${passed} ms`);
});

test("clear, reload, open, exit", { skip }, async () => {
  await everyWay("clear", async (page, act, message) => {
    await act();
    const { ink } = await drawn(page);
    assert.equal(ink, 0, `${message}: ${ink} pixels are left`);
    assert.ok(await page.isVisible("#empty"), message);
    assert.ok(await page.isDisabled("#do-toggle"), message);
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
    await page.waitForFunction(() => window.plmPage.app.runViews.length === 3);
    await settle(page);
    assert.ok((await drawn(page)).ink > 3000, message);
  });
  await everyWay("exit", async (page, act, message) => {
    await act();
    const closed = await Promise.race([
      page.waitForEvent("close", { timeout: 20000 }).then(() => true).catch(() => false),
      page.waitForSelector(".message.note", { timeout: 20000 }).then(() => true).catch(() => false),
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
    await settle(page);
    const { back, ink } = await drawn(page);
    assert.ok(Math.abs(back[0] - 0x20) < 3 && Math.abs(back[2] - 0x60) < 3 && ink > 5000, `${message}: ${back}`);
    await page.focus("#picture");
    await pressKey(page, "F");
    assert.equal(await time(page), 0.25, message);
    const passed = await page.evaluate(async () => {
      const { app, frames } = window.plmPage;
      app.player.play();
      app.touch();
      const [from, began] = [frames.drawn, performance.now()];
      while (frames.drawn < from + 6) await new Promise(requestAnimationFrame);
      return performance.now() - began;
    });
    // From the first to the sixth.
    assert.ok(passed > 480, `${message}: six frames in ${passed} ms at a rate of 10 in a second`);
  });
  const { page } = await open(addresses.workshop);
  await press(page, "options");
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

test("every command is used here or in another file", { skip }, () => {
  const folder = new URL(".", import.meta.url);
  const source = readdirSync(folder).filter((name) => name.endsWith(".test.js")).map((name) => readFileSync(new URL(name, folder), "utf8")).join();
  const missing = COMMANDS.filter(({ id, group }) => group !== "move" && !id.endsWith("tab") && !source.includes(`"${id}"`));
  assert.deepEqual(missing.map(({ id }) => id), []);
});
