// The mechanism alive in the page, with a real module; everything by mouse and by key.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { LIVE_COMMANDS } from "../src/commands.js";
import { readResults } from "../src/results.js";
import { makeNpz } from "../tests/support/npz.js";
import { fourBarHead, modulePath, nativeRows, runOfRows, withoutModule } from "../tests/support/live.js";
import { drawn, open, settle, shot, skip as withoutBrowser, state, writePage } from "./support/browser.js";

const skip = withoutBrowser || withoutModule;
const FORCE = [194, 24, 91];
const RED = [198, 40, 40];

const address = skip ? "" : writePage("live", makeNpz([runOfRows(fourBarHead(), nativeRows().slice(0, 1))], { how: "deflated" }), "Four-bar", modulePath());

/** The page when it runs, or when it stands at its start. */
async function alive({ isRunning = true, ...how } = {}) {
  const { page, requests, errors } = await open(address, how);
  await page.waitForFunction(() => window.plmPage.app.live.run.rows > 3);
  if (!isRunning) {
    await page.click("#live-go");
    await page.click("#live-reset");
    await page.waitForFunction(() => window.plmPage.app.live.run.rows === 1);
    await settle(page);
  }
  return { page, requests, errors };
}

const now = (page) => state(page, "app.live.run.end");
/** x y θ of a body in the last row. */
const pose = (page, body) => state(page, `[0, 1, 2].map((axis) => app.live.run.poses.at(app.live.run.rows - 1, 6 * ${body} + axis))`);
const setting = (page, kind, index) => state(page, `app.live.settings.${kind}[${index}]`);

/** Where a point of a body is on the screen, in pixels of the page. */
async function onScreen(page, body, point = [0, 0]) {
  const [x, y] = await page.evaluate(
    ([index, [u, v]]) => {
      const { app } = window.plmPage;
      const [gx, gy, angle] = app.scene.at(app.player.time).poses.subarray(3 * index, 3 * index + 3);
      const at = [gx + Math.cos(angle) * u - Math.sin(angle) * v, gy + Math.sin(angle) * u + Math.cos(angle) * v];
      return app.view.projection(app.area).point(...at, app.scene.levels.bodies[index]);
    },
    [body, point],
  );
  const box = await page.locator("#picture").boundingBox();
  return [box.x + x, box.y + y];
}

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
  const { page, requests, errors } = await alive();
  assert.deepEqual(requests.filter((each) => each !== address && !each.startsWith("blob:")), []);
  const before = await drawn(page);
  const time = await now(page);
  await page.waitForTimeout(400);
  const after = await drawn(page);
  assert.ok(before.ink > 5000 && after.ink > 5000 && before.hash !== after.hash);
  assert.ok((await now(page)) > time + 0.2);
  assert.deepEqual(await state(page, "[app.run.name, app.player.isFollowing, app.tab]"), ["live", true, "live"]);
  assert.deepEqual(errors, []);
});

test("the page is small", { skip }, () => {
  const size = readFileSync(fileURLToPath(address)).length;
  console.log(`live page of ${size} bytes, module of ${readFileSync(modulePath()).length}`);
  assert.ok(size < 250_000, `${size} bytes`);
});

test("the numbers are those of the native run, to the bit", { skip }, async () => {
  const native = nativeBits();
  // As it runs by itself.
  const { page } = await alive();
  await page.waitForFunction(() => window.plmPage.app.live.run.rows > 60);
  const free = (await rowBits(page)).slice(1, 60);
  assert.deepEqual(free, native.slice(0, 59));
  // Step by step, with a parameter that is turned.
  const { page: still } = await alive({ isRunning: false });
  await still.evaluate(() => {
    const { live } = window.plmPage.app;
    live.step(0.01, 150);
    live.set("parameter", 0, 0.41);
    live.step(0.01, 50);
  });
  await still.waitForFunction(() => window.plmPage.app.live.run.rows === 201);
  assert.deepEqual((await rowBits(still)).slice(1), native.slice(0, 200));
});

test("pause and run, by mouse and by key", { skip }, async () => {
  const { page } = await alive();
  const ways = { button: () => page.click("#live-go"), Space: () => page.keyboard.press("Space"), "transport buttons": null };
  for (const [how, use] of Object.entries(ways)) {
    await (use?.() ?? page.click("#do-stop"));
    await page.waitForTimeout(60);
    const time = await now(page);
    await page.waitForTimeout(150);
    assert.equal(await now(page), time, how);
    assert.match(await page.textContent("#live-state"), /Paused/);
    if (how === "button") await page.focus("#picture");
    await (use?.() ?? page.click("#do-play"));
    await page.waitForFunction((at) => window.plmPage.app.live.run.end > at + 0.1, time);
    assert.match(await page.textContent("#live-state"), /Running/, how);
    if (how === "button") await page.focus("#picture");
  }
});

test("a step, and what was: the time line shows it, the end goes on", { skip }, async () => {
  const { page } = await alive({ isRunning: false });
  await page.focus("#picture");
  await page.keyboard.press("f");
  await page.click("#do-forward-step");
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
  const { page } = await alive({ isRunning: false });
  const { scale } = await state(page, "app.view");
  const isWhole = () =>
    page.evaluate(() => {
      const canvas = document.querySelector("#picture");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, 1);
      return [...data].every((part, at) => part === data[at % 4]);
    });
  await page.evaluate(() => window.plmPage.app.live.step(0.01, 400));
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 401);
  await page.waitForTimeout(350);
  await page.evaluate(() => window.plmPage.app.touch());
  await settle(page);
  assert.ok(await isWhole());
  await page.click("#do-isometric");
  const view = await state(page, "JSON.stringify(app.view)");
  await page.evaluate(() => window.plmPage.app.live.step(0.01, 100));
  await page.waitForTimeout(350);
  assert.equal(await state(page, "JSON.stringify(app.view)"), view);
  assert.ok(scale > 0);
});

test("speed", { skip }, async () => {
  const { page } = await alive({ isRunning: false });
  await page.selectOption("#speed", "0.1");
  await page.click("#live-go");
  await page.waitForTimeout(500);
  const slow = await now(page);
  assert.ok(slow > 0.01 && slow < 0.15, `${slow}`);
  assert.ok(Math.abs((await state(page, "app.live.run.time.data[1]")) - 0.001) < 1e-15, "rows are as near as on the screen");
  await page.selectOption("#speed", "5");
  await page.waitForTimeout(500);
  assert.ok((await now(page)) > slow + 1);
});

test("a parameter is turned by slider, by key and by number, in its unit", { skip }, async () => {
  const { page } = await alive({ isRunning: false });
  const slider = page.locator("#parameter-0-slider");
  assert.deepEqual([await page.inputValue("#parameter-0"), await slider.inputValue()], ["400", "400"]);
  const before = await drawn(page);
  const box = await slider.boundingBox();
  await page.mouse.click(box.x + 0.6 * box.width, box.y + 0.5 * box.height);
  await page.waitForFunction(() => window.plmPage.app.live.settings.parameter[0] > 0.401);
  await settle(page);
  const turned = await setting(page, "parameter", 0);
  assert.ok(turned < 0.55, `${turned}`);
  assert.equal(Number(await page.inputValue("#parameter-0")), Math.round(turned * 1e3));
  assert.notEqual((await drawn(page)).hash, before.hash, "the coupler is longer");
  const length = await state(page, "app.live.mechanism.bodies[1].ports.map((port) => port.x)");
  assert.ok(Math.abs(length[1] - length[0] - turned) < 1e-12, `${length}`);
  await slider.press("ArrowRight");
  await page.waitForFunction((at) => Math.abs(window.plmPage.app.live.settings.parameter[0] - at - 0.004) < 1e-9, turned);
  // Beyond the range of the slider, which becomes longer.
  await page.fill("#parameter-1", "2.5");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.plmPage.app.live.settings.parameter[1] === 2.5);
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

test("a body is pulled by the mouse", { skip }, async () => {
  const { page, errors } = await alive({ isRunning: false });
  // What it does by itself in the same time.
  const [x, y] = await onScreen(page, 1, [0.1, 0]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 120, y - 60, { steps: 4 });
  await settle(page);
  assert.ok((await drawn(page, "#picture", { force: FORCE })).force > 30, "the pull is drawn");
  const before = await pose(page, 1);
  await page.evaluate(() => window.plmPage.app.live.step(0.01, 20));
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 21);
  const pulled = await pose(page, 1);
  await shot(page, "live-pull");
  await page.mouse.up();
  const free = nativeRows()[19].subarray(7, 9);
  const went = [pulled[0] - free[0], pulled[1] - free[1]];
  assert.ok(Math.hypot(...went) > 0.005, `${before} ${pulled} without ${free}`);
  assert.ok(went[0] * 120 + went[1] * 60 > 0, `it goes where it is pulled: ${went}`);
  await settle(page);
  assert.equal((await drawn(page, "#picture", { force: FORCE })).force, 0, "and let go");
  // The force is gone: from the same state the same as without.
  assert.equal(await state(page, "app.hand"), null);
  assert.deepEqual(errors, []);
});

test("a body is pulled by keys", { skip }, async () => {
  const { page } = await alive({ isRunning: false });
  await page.click("#hand-pull");
  await page.click("#live-state");
  await page.keyboard.press(".");
  assert.deepEqual(await state(page, "app.selected"), { kind: "body", index: 0 });
  await page.keyboard.down("ArrowUp");
  await settle(page);
  assert.ok((await drawn(page, "#picture", { force: FORCE })).force > 20, "the pull is drawn");
  await page.evaluate(() => window.plmPage.app.live.step(0.01, 20));
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 21);
  const [, , pulled] = await pose(page, 0);
  await page.keyboard.up("ArrowUp");
  const free = nativeRows()[19][3];
  assert.ok(pulled > free + 0.05, `${pulled} ${free}`);
  await settle(page);
  assert.equal((await drawn(page, "#picture", { force: FORCE })).force, 0);
});

test("where there is no body, dragging moves the view", { skip }, async () => {
  const { page } = await alive({ isRunning: false });
  const before = await state(page, "app.view.target");
  await page.mouse.move(60, 120);
  await page.mouse.down();
  await page.mouse.move(100, 150, { steps: 3 });
  await page.mouse.up();
  assert.notDeepEqual(await state(page, "app.view.target"), before);
});

test("a body is placed by mouse and by keys, and the joints close", { skip }, async () => {
  const { page } = await alive();
  await page.focus("#picture");
  await page.keyboard.press("Shift+H");
  await settle(page);
  assert.ok(await page.isChecked("#hand-place"));
  assert.ok(!(await state(page, "app.live.isRunning")), "it pauses");
  await page.keyboard.press("Shift+D");
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 1);
  await settle(page);
  const [x, y] = await onScreen(page, 0, [0.4, 0]);
  const before = await pose(page, 0);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 10, y + 30, { steps: 5 });
  await page.waitForFunction((angle) => Math.abs(window.plmPage.app.live.run.poses.at(0, 2) - angle) > 0.02, before[2]);
  await shot(page, "live-place");
  await page.mouse.up();
  const gap = async () => {
    const [a, c] = [await pose(page, 0), await pose(page, 1)];
    const reach = await setting(page, "parameter", 0);
    const end = [a[0] + 0.5 * Math.cos(a[2]), a[1] + 0.5 * Math.sin(a[2])];
    return Math.hypot(end[0] - c[0] + 0.5 * reach * Math.cos(c[2]), end[1] - c[1] + 0.5 * reach * Math.sin(c[2]));
  };
  assert.ok((await gap()) < 1e-9, `${await gap()}`);
  await page.waitForFunction(() => !window.plmPage.app.live.placing.isAsked);
  const placed = await pose(page, 0);
  await page.focus("#picture");
  for (const key of ["PageUp", "ArrowLeft"]) {
    await page.keyboard.press(key);
    await page.waitForFunction(() => !window.plmPage.app.live.placing.isAsked);
  }
  const moved = await pose(page, 0);
  assert.ok(moved[2] > placed[2] + 1e-3, `${placed} ${moved}`);
  assert.ok((await gap()) < 1e-9);
});

test("what cannot be assembled is told with its part, and mended", { skip }, async () => {
  for (const how of ["field", "key"]) {
    const { page, errors } = await alive();
    assert.equal((await drawn(page, "#picture", { fault: RED })).fault, 0);
    await page.fill("#parameter-0", "9000");
    await page.keyboard.press("Enter");
    if (how === "key") {
      await page.focus("#picture");
      await page.keyboard.press("Shift+B");
    } else {
      await page.click("#live-restart");
    }
    await page.waitForSelector(".message.fault");
    const text = await page.textContent(".message.fault");
    const part = await state(page, "app.run.fault.part");
    assert.ok(part !== "" && text.includes(part) && text.length > 40, text);
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

test("record, and export what was recorded", { skip }, async () => {
  const { page } = await alive();
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
  const { page } = await alive();
  for (const mode of ["place", "pull"]) {
    await page.click(`#do-${mode}`);
    assert.equal(await state(page, "app.mode"), mode);
  }
  // To place a body has paused it.
  await page.click("#live-go");
  await page.keyboard.press("m");
  await page.focus("#picture");
  await page.keyboard.press("h");
  assert.equal(await state(page, "app.mode"), "pull");
  await page.click("#do-record");
  await settle(page);
  assert.equal(await page.getAttribute("#do-record", "aria-pressed"), "true");
  for (const use of [() => page.click("#do-restart"), () => page.keyboard.press("Shift+D")]) {
    await page.waitForFunction(() => window.plmPage.app.live.run.end > 0.15);
    await use();
    await page.waitForFunction(() => window.plmPage.app.live.run.end < 0.15);
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
  const { page, errors } = await alive();
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
  const { page } = await alive();
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.reload();
  await page.waitForFunction(() => window.plmPage?.app.live.run.rows === 1);
  await page.waitForTimeout(150);
  assert.equal(await now(page), 0);
  await page.emulateMedia({ reducedMotion: null });
});

test("curves grow, and are not painted in every frame", { skip }, async () => {
  const { page } = await alive({ hash: "#tab=curves" });
  await page.waitForFunction(() => window.plmPage.app.live.run.end > 0.3);
  const before = await drawn(page, "figure > canvas");
  await page.waitForTimeout(400);
  const after = await drawn(page, "figure > canvas");
  assert.ok(after.ink > 300 && after.hash !== before.hash);
  await shot(page, "live-curves");
});

test("wide and narrow, light and dark, everything has its place", { skip }, async () => {
  for (const [width, height] of [[1200, 800], [400, 800]]) {
    for (const theme of ["light", "dark"]) {
      const { page, errors } = await alive({ width, height, theme });
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
