// A live mechanism in the page, with a real module; everything by mouse and by key.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { LIVE_COMMANDS } from "../src/commands.js";
import { readResults } from "../src/results.js";
import { modulePath, nativeRows } from "../tests/support/live.js";
import { address, livePage, now, skip } from "./support/livepage.js";
import { drawn, frames, openedIn, settle, shot, state, until } from "./support/browser.js";
import { isOn, press } from "./support/commands.js";

/** The bits of all rows of the live run. */
const rowBits = (page) =>
  page.evaluate(() => {
    const { run } = window.plmPage.app.live;
    const part = ({ data, width }, row) => [...data.subarray(row * width, (row + 1) * width)];
    return Array.from({ length: run.rows }, (_, row) => {
      const numbers = [run.time, run.poses, run.ground, run.values].flatMap((table) => part(table, row));
      return [...new BigUint64Array(Float64Array.from(numbers).buffer)].map((word) => word.toString(16)).join(" ");
    });
  });

const nativeBits = () => nativeRows().map((row) => [...new BigUint64Array(row.buffer, row.byteOffset, row.length)].map((word) => word.toString(16)).join(" "));

test("it opens with no request of a network, and moves by itself", { skip }, async () => {
  const { page, requests, errors } = await livePage();
  assert.deepEqual(requests.filter((each) => each !== address && !each.startsWith("blob:")), []);
  const before = await drawn(page);
  const time = await now(page);
  await page.waitForFunction((at) => window.plmPage.app.live.run.end > at + 0.2, time);
  await settle(page);
  const after = await drawn(page);
  assert.ok(before.ink > 5000 && after.ink > 5000 && before.hash !== after.hash);
  assert.deepEqual(await state(page, "[app.run.name, app.player.isFollowing, app.tab]"), ["live", true, "live"]);
  assert.deepEqual(errors, []);
});

test("the page is small, and its first frame comes in a second", { skip }, async () => {
  const ready = await openedIn(address);
  assert.ok(ready < 1000, `${ready} ms`);
  const size = readFileSync(fileURLToPath(address)).length;
  console.log(`live page of ${size} bytes, module of ${readFileSync(modulePath()).length}`);
  assert.ok(size < 250_000, `${size} bytes`);
});

test("the numbers are those of the native run, to the bit", { skip }, async () => {
  const native = nativeBits();
  // As it runs by itself.
  const { page } = await livePage();
  await page.waitForFunction(() => window.plmPage.app.live.run.rows > 60);
  const free = (await rowBits(page)).slice(1, 60);
  assert.deepEqual(free, native.slice(0, 59));
  // Step by step, with a parameter that is turned.
  const { page: still } = await livePage({ isRunning: false });
  await still.evaluate(() => {
    const { live } = window.plmPage.app;
    live.step(0.01, 150);
    live.set("parameter", 0, 0.41);
    live.step(0.01, 50);
  });
  await still.waitForFunction(() => window.plmPage.app.live.run.rows === 201);
  assert.deepEqual((await rowBits(still)).slice(1), native.slice(0, 200));
});

/** The time at which it stands, after the rows that were under way. */
async function standing(page) {
  const { revision } = await state(page, "app.live");
  // The worker answers what it hears in order: after its answer no row of before comes.
  await page.evaluate(() => window.plmPage.app.live.send({ kind: "input", index: 0, value: 0 }));
  await page.waitForFunction((before) => window.plmPage.app.live.revision > before, revision);
  return now(page);
}

test("pause and run, by mouse and by key", { skip }, async () => {
  const { page } = await livePage();
  const ways = { button: () => page.click("#live-go"), Space: () => page.keyboard.press("Space"), "transport buttons": null };
  for (const [how, use] of Object.entries(ways)) {
    await (use?.() ?? press(page, "stop"));
    const time = await standing(page);
    await frames(page);
    assert.equal(await now(page), time, how);
    assert.match(await page.textContent("#live-state"), /Paused/);
    if (how === "button") await page.focus("#picture");
    await (use?.() ?? press(page, "play"));
    await page.waitForFunction((at) => window.plmPage.app.live.run.end > at + 0.1, time);
    assert.match(await page.textContent("#live-state"), /Running/, how);
    if (how === "button") await page.focus("#picture");
  }
});

test("rows of contact stand in the panel with what they do", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  const shown = () => page.$eval("#live-contacts", (list) => (list.hidden ? "" : list.innerText.replaceAll(/\s+/g, " ").trim()));
  assert.equal(await shown(), "");
  const contacts = [{ name: "floor", mode: "closed" }, { name: "slip", mode: "slips forwards" }];
  await page.evaluate((told) => {
    window.plmPage.app.live.hear({ kind: "contacts", contacts: told });
    window.plmPage.app.touch();
  }, contacts);
  await frames(page);
  assert.equal(await shown(), "floor closed slip slips forwards");
});

test("a step, and what was: the time line shows it, the end goes on", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  await page.focus("#picture");
  await page.keyboard.press("f");
  await press(page, "forward step");
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 3);
  assert.ok(Math.abs((await now(page)) - 0.02) < 1e-12);
  await page.focus("#picture");
  await page.keyboard.press("Home");
  assert.equal(await state(page, "app.player.time"), 0);
  await page.keyboard.press("End");
  await page.keyboard.press("Space");
  await page.waitForFunction(() => window.plmPage.app.live.run.end > 0.1);
  assert.ok(await state(page, "app.player.isFollowing"));
});

test("it stays in view, until another view is chosen", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  const { scale } = await state(page, "app.view");
  const isWhole = () =>
    page.evaluate(() => {
      const canvas = document.querySelector("#picture");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, 1);
      return [...data].every((part, at) => part === data[at % 4]);
    });
  await page.evaluate(() => window.plmPage.app.live.step(0.01, 400));
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 401);
  await until(page, async () => {
    await page.evaluate(() => window.plmPage.app.touch());
    await settle(page);
    return isWhole();
  }, "all of it is in sight");
  await press(page, "isometric");
  const view = await state(page, "JSON.stringify(app.view)");
  await page.evaluate(() => window.plmPage.app.live.step(0.01, 100));
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 501);
  const looked = await state(page, "app.live.followCamera.lookedAt");
  await until(page, async () => {
    await page.evaluate(() => window.plmPage.app.touch());
    return (await state(page, "app.live.followCamera.chosen")) === null || (await state(page, "app.live.followCamera.lookedAt")) > looked;
  }, "it has looked whether all is in sight");
  assert.equal(await state(page, "JSON.stringify(app.view)"), view);
  assert.ok(scale > 0);
});

test("speed", { skip }, async () => {
  const { page } = await livePage({ isRunning: false });
  await page.selectOption("#speed", "0.1");
  const began = await page.evaluate(() => performance.now());
  await page.click("#live-go");
  await page.waitForFunction(() => window.plmPage.app.live.run.end > 0.02);
  const [slow, passed] = await page.evaluate((from) => [window.plmPage.app.live.run.end, performance.now() - from], began);
  assert.ok(slow <= 0.1e-3 * passed, `${slow} s in ${passed} ms`);
  assert.ok(Math.abs((await state(page, "app.live.run.time.data[1]")) - 0.001) < 1e-15, "rows are as near as on the screen");
  await page.selectOption("#speed", "5");
  await page.waitForFunction((at) => window.plmPage.app.live.run.end > at + 1, slow);
});

test("record, and export what was recorded", { skip }, async () => {
  const { page } = await livePage();
  await page.click("#live-record");
  const from = await state(page, "app.live.recordsFrom");
  await page.waitForFunction((at) => window.plmPage.app.live.run.end > at + 0.3, from);
  await page.focus("#picture");
  await page.keyboard.press("Shift+C");
  assert.equal(await state(page, "app.live.recordings.length"), 1);
  await settle(page);
  assert.match(await page.textContent("#live-tape"), /1 recorded/);
  const file = async (button) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  };
  const { name, bytes } = await file("#live-npz");
  assert.equal(name, "FourBar-live.npz");
  const { runs, warnings } = await readResults(new Uint8Array(bytes));
  assert.deepEqual([warnings, runs.map((run) => run.name)], [[], ["recording 1"]]);
  const [run] = runs;
  assert.ok(run.rows >= 30 && run.start === from, `${run.rows} ${run.start}`);
  assert.deepEqual([...run.poses.data], await state(page, "[...app.live.recordings[0].poses.data]"));
  const table = await file("#live-csv");
  assert.equal(table.name, "FourBar-recording-1.csv");
  const lines = table.bytes.toString().trimEnd().split("\n");
  assert.ok(lines[0].startsWith("time (s),") && lines.length === run.rows + 1);
  assert.deepEqual(lines[2].split(",").map(Number), [run.time.data[1], ...run.columns.map((_, at) => run.values.at(1, at))]);
  // It is a run among the others.
  await page.click("#tab-runs");
  await settle(page);
  assert.match(await page.textContent("#sheet-runs"), /recording 1/);
});

test("toolbar and keys of the live page", { skip }, async () => {
  const { page } = await livePage();
  for (const mode of ["place", "pull"]) {
    await press(page, mode);
    assert.equal(await state(page, "app.mode"), mode);
  }
  // To place a body has paused it.
  await page.click("#live-go");
  await page.keyboard.press("m");
  await page.focus("#picture");
  await page.keyboard.press("h");
  assert.equal(await state(page, "app.mode"), "pull");
  await press(page, "record");
  await settle(page);
  assert.ok(await isOn(page, "record"));
  await page.evaluate(() => {
    const { live } = window.plmPage.app;
    const begin = live.begin.bind(live);
    window.starts = [];
    live.begin = (numbers, isAssembled) => (window.starts.push(numbers[0]), begin(numbers, isAssembled));
  });
  for (const [use, starts] of [[() => press(page, "restart"), [0]], [() => page.keyboard.press("Shift+D"), [0, 0]]]) {
    await page.waitForFunction(() => window.plmPage.app.live.run.end > 0.15);
    await use();
    await page.waitForFunction((count) => window.starts.length === count, starts.length);
    assert.deepEqual(await page.evaluate(() => window.starts), starts, "it begins again at the time 0");
  }
  await page.click("#tab-model");
  await page.focus("#picture");
  await page.keyboard.press("Shift+L");
  await settle(page);
  assert.ok(await page.isVisible("#sheet-live"));
  await page.keyboard.press("?");
  const text = await page.textContent("dialog");
  for (const { name } of LIVE_COMMANDS) assert.ok(text.includes(name), name);
});

test("another file takes its place, and it comes back", { skip }, async () => {
  const { page, errors } = await livePage();
  await page.focus("#picture");
  await page.keyboard.press("n");
  await page.waitForFunction(() => !window.plmPage.app.live.isRunning);
  await page.click("#live-go");
  await page.waitForFunction(() => window.plmPage.app.run?.name === "live" && window.plmPage.app.live.isRunning);
  await settle(page);
  assert.ok((await drawn(page)).ink > 3000);
  assert.deepEqual(errors, []);
});

test("who wants less motion begins it", { skip }, async () => {
  const { page } = await livePage();
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.reload();
  await page.waitForFunction(() => window.plmPage?.app.live.run.rows === 1);
  assert.equal(await standing(page), 0);
  await page.emulateMedia({ reducedMotion: null });
});

test("curves grow, and are not painted in every frame", { skip }, async () => {
  const { page } = await livePage({ hash: "#tab=curves" });
  await page.waitForFunction(() => window.plmPage.app.live.run.end > 0.3);
  const before = await drawn(page, "figure > canvas");
  await until(page, async () => (await drawn(page, "figure > canvas")).hash !== before.hash, "the curves have grown");
  assert.ok((await drawn(page, "figure > canvas")).ink > 300);
  await shot(page, "live-curves");
});

test("wide and narrow, light and dark, everything has its place", { skip }, async () => {
  for (const [width, height] of [[1200, 800], [400, 800]]) {
    for (const theme of ["light", "dark"]) {
      const { page, errors } = await livePage({ width, height, theme });
      const where = `${width} ${theme}`;
      assert.ok((await drawn(page)).ink > 1500, where);
      const outside = await page.evaluate(() => {
        const limit = document.documentElement.clientWidth;
        return [...document.querySelectorAll("button, input, label, h2, p, span")]
          .filter((each) => each.checkVisibility() && each.className !== "spoken")
          .filter((each) => each.getBoundingClientRect().right > limit + 0.5 || each.getBoundingClientRect().left < -0.5)
          .map((each) => each.outerHTML.slice(0, 80));
      });
      assert.deepEqual(outside, [], where);
      const nameless = await page.evaluate(() =>
        [...document.querySelectorAll("#sheet-live button, #sheet-live input")]
          .filter((each) => !(each.getAttribute("aria-label") || each.labels?.length || each.textContent.trim()))
          .map((each) => each.outerHTML),
      );
      assert.deepEqual(nameless, [], where);
      assert.deepEqual(errors, [], where);
      await shot(page, `live-${width}-${theme}`);
    }
  }
});
