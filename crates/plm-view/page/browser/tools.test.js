// Tools in a browser: each by the menu and by its keys; what is drawn, said and saved.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { workshop } from "../tests/support/scenes.js";
import { readGif } from "../tests/support/gif.js";
import { drawn, open, settle, skip, state, until, writeRuns } from "./support/browser.js";
import { changes, everyWay as everyWayOf, isOn, press, pressKey } from "./support/commands.js";
import { livePage, onScreen as onLiveScreen, pose, setting, skip as skipLive } from "./support/livepage.js";

const address = skip ? "" : writeRuns("tools", [workshop()]);
const still = "#t=0.7";
const everyWay = (id, check, hash = still) => everyWayOf(id, check, { address, hash });
const GREEN = [0, 121, 107];

/** Where a point of a body is in the window. */
const onScreen = (page, body, u, v) =>
  page.evaluate(
    ([index, x, y]) => {
      const { app } = window.plmPage;
      const [gx, gy, angle] = app.scene.at(app.player.time).poses.subarray(3 * index, 3 * index + 3);
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      const [px, py] = app.view.projection(app.area).point(gx + cos * x - sin * y, gy + sin * x + cos * y, app.scene.levels.bodies[index]);
      const { left, top } = document.querySelector("#picture").getBoundingClientRect();
      return [left + px, top + py];
    },
    [body, u, v],
  );

async function clickOn(page, ...point) {
  await page.mouse.click(...(await onScreen(page, ...point)));
  await settle(page);
}

test("a distance between points that are pressed follows the motion; Escape clears it", { skip }, async () => {
  await everyWay("distance", async (page, act, message) => {
    await act();
    assert.ok(await isOn(page, "distance"), message);
    await clickOn(page, 0, 0.15, 0);
    assert.equal(await state(page, "app.marks[0].name"), "crank.b", message);
    await changes(page, () => clickOn(page, 4, 0, 0), message);
    assert.deepEqual(await state(page, "app.tools.measures"), ["distance(crank.b,rod.pin)"], message);
    await pressKey(page, "Shift+T");
    await settle(page);
    const value = async () => Number((await page.textContent(".measures tbody td")).replace(" m", ""));
    const before = await value();
    await changes(page, () => pressKey(page, "ArrowRight").then(() => settle(page)), message);
    assert.notEqual(await value(), before, message);
    await page.check(".measures tbody input");
    assert.ok(await state(page, 'app.curves.includes("distance(crank.b,rod.pin)")'), message);
    await page.focus("#picture");
    for (const measures of [[], []]) {
      await pressKey(page, "Escape");
      assert.deepEqual(await state(page, "app.tools.measures"), measures, message);
    }
    assert.deepEqual([await state(page, "app.mode"), await state(page, "app.selected")], ["pan", null], message);
  });
});

test("an angle between bodies, and by names alone at the second of three points", { skip }, async () => {
  await everyWay("angle", async (page, act, message) => {
    await act();
    await clickOn(page, 0, 0, 0.02);
    await clickOn(page, 1, 0.15, 0.06);
    assert.deepEqual(await state(page, "app.tools.measures"), ["angle(crank,coupler)"], message);
  });
  const { page } = await open(address, { hash: `${still}&tab=tools` });
  await page.click(".picker summary >> text=Choose by name");
  for (const [at, name] of ["coupler.b", "coupler.c", "rocker.d"].entries()) await page.selectOption(`#mark-${at}`, { label: name });
  await page.focus("#mark-add");
  await page.keyboard.press("Enter");
  assert.deepEqual(await state(page, "app.tools.measures"), ["angle(coupler.b,coupler.c,rocker.d)"]);
});

test("instant centres and centrodes", { skip }, async () => {
  for (const id of ["centres", "centrodes"]) {
    await everyWay(id, async (page, act, message) => {
      const before = await drawn(page, "#picture", { green: GREEN });
      await act();
      assert.ok(await isOn(page, id), message);
      const after = await drawn(page, "#picture", { green: GREEN });
      assert.ok(before.green < 20 && after.green > 60, `${message}: ${before.green}, ${after.green}`);
    }, `${still}&select=body:1`);
  }
  // Two bodies pressed one after the other are a pair.
  const { page } = await open(address, { hash: `${still}&centres=1` });
  await clickOn(page, 0, 0, 0.02);
  await clickOn(page, 2, 0, 0);
  assert.deepEqual(await state(page, "app.tools.pair"), ["crank", "rocker"]);
});

test("ghost poses, and how many", { skip }, async () => {
  await everyWay("ghosts", async (page, act, message) => {
    await changes(page, act, message);
    assert.equal(await state(page, "app.tools.ghosts"), 12, message);
  });
  for (const [id, count] of [["fewer ghosts", 7], ["more ghosts", 9]]) {
    await everyWay(id, async (page, act, message) => {
      await changes(page, act, message);
      assert.equal(await state(page, "app.tools.ghosts"), count, message);
    }, `${still}&ghosts=8`);
  }
});

test("a polar plot of a force", { skip }, async () => {
  await everyWay("polar", async (page, act, message) => {
    await act();
    const vector = await drawn(page, "#polar", { force: [194, 24, 91] });
    assert.ok(vector.force > 200, `${message}: ${vector.force}`);
    assert.match(await page.getAttribute("#polar", "aria-label"), /crank_coupler\.force: .* \(N\)/, message);
    await page.selectOption("#polar-around", "crank");
    await settle(page);
    const around = await drawn(page, "#polar", { force: [194, 24, 91] });
    assert.ok(around.force > 200 && around.hash !== vector.hash, message);
    assert.ok((await state(page, "new URLSearchParams(location.hash.slice(1)).get('polar') ?? app.tools.force")) === "crank_coupler");
  });
});

test("what was shown is undone and done again", { skip }, async () => {
  const doSome = async (page) => {
    await pressKey(page, "Y");
    await settle(page);
    await pressKey(page, "Shift+I");
    await settle(page);
    return [await state(page, "app.showsForces"), await state(page, "app.tools.centres")];
  };
  await everyWay("undo", async (page, act, message) => {
    assert.deepEqual(await doSome(page), [true, true]);
    await act();
    assert.deepEqual([await state(page, "app.showsForces"), await state(page, "app.tools.centres")], [true, false], message);
    assert.match(await page.textContent("#messages"), /Undone: instant centres/, message);
  });
  await everyWay("redo", async (page, act, message) => {
    await doSome(page);
    await pressKey(page, "Ctrl+Z");
    await settle(page);
    await act();
    assert.equal(await state(page, "app.tools.centres"), true, message);
  });
});

test("a turn is saved as GIF, which another decoder reads", { skip }, async () => {
  await everyWay("movie", async (page, act, message) => {
    await act();
    await page.fill("#movie-width", "200");
    assert.match(await page.textContent("#movie-state"), /50 frames, 2 s, 200 × \d+ pixels/, message);
    if (message.endsWith("mouse")) return;
    const saved = page.waitForEvent("download");
    await page.click("#movie-go");
    const path = await (await saved).path();
    const bytes = readFileSync(path);
    const gif = readGif(bytes);
    assert.equal(gif.frames.length, 50);
    assert.equal(gif.frames.reduce((sum, { delay }) => sum + delay, 0), 200, "two seconds");
    assert.match(await page.textContent("#movie-state"), /Saved: 50 frames, 200 × \d+ pixels, \d+ kB/);
    console.log(`a turn in 50 frames of 200 × ${gif.height}: ${bytes.length} bytes`);
    // The browser's own decoder sees the same.
    const first = await page.evaluate(async (url) => {
      const image = new Image();
      image.src = url;
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [image.width, image.height];
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      return Array.from({ length: data.length / 4 }, (_, at) => (data[4 * at] << 16) | (data[4 * at + 1] << 8) | data[4 * at + 2]);
    }, `data:image/gif;base64,${bytes.toString("base64")}`);
    assert.deepEqual(first, gif.frames[0].pixels);
  });
});

test("a video is recorded, and either can be cancelled", { skip }, async () => {
  const { page } = await open(address, { hash: `${still}&speed=5` });
  await press(page, "movie");
  await page.selectOption("#movie-kind", "video");
  await page.fill("#movie-width", "201");
  const saved = page.waitForEvent("download");
  await page.click("#movie-go");
  const bytes = readFileSync(await (await saved).path());
  const isVideo = bytes.includes("ftyp") || bytes.readUInt32BE(0) === 0x1a45dfa3;
  assert.ok(isVideo && bytes.length > 2000, `${bytes.length} bytes`);
  console.log(`${await page.textContent("#movie-state")}`);
  await page.selectOption("#movie-kind", "gif");
  await page.fill("#movie-width", "1900");
  await page.click("#movie-go");
  await page.click("#movie-cancel");
  await until(page, async () => /Cancelled/.test(await page.textContent("#movie-state")), "it is cancelled");
  assert.ok(await page.isEnabled("#movie-go"));
});

test("at every width, light and dark, nothing stands outside, and everything has a name", { skip }, async () => {
  const shown = `${still}&ghosts=6&centres=1&pair=crank|rocker&centrodes=1&select=body:1&polar=slot&around=crank&measures=distance(crank.b,rod.pin)|angle(coupler.b,coupler.c,rocker.d)`;
  for (const [width, height] of [[390, 844], [820, 1180], [1200, 800]]) {
    for (const theme of ["light", "dark"]) {
      for (const tab of ["tools", "curves"]) {
        const { page, errors } = await open(address, { width, height, theme, hash: `${shown}&tab=${tab}` });
        const where = `${tab} ${width} ${theme}`;
        const wrong = await page.evaluate(() => {
          const limit = document.documentElement.clientWidth;
          const seen = [...document.querySelectorAll("#panel :is(button, select, input, canvas, td, p, summary)")].filter((each) => each.checkVisibility() && each.ariaHidden === null);
          const isOutside = (each) => each.getBoundingClientRect().right > limit + 0.5 || each.getBoundingClientRect().left < -0.5;
          const isNameless = (each) => !each.matches("td, p") && !(each.getAttribute("aria-label") || each.labels?.length || each.textContent.trim());
          return seen.filter((each) => isOutside(each) || isNameless(each)).map((each) => each.outerHTML.slice(0, 90));
        });
        assert.deepEqual([wrong, errors], [[], []], where);
        const { words } = await drawn(page, "#picture", { words: theme === "light" ? GREEN : [77, 208, 184] });
        assert.ok(words > 60, `${where}: ${words}`);
      }
    }
  }
});

test("what was pulled and set of a live mechanism is undone", { skip: skipLive }, async () => {
  const { page, errors } = await livePage({ isRunning: false });
  const before = await pose(page, 0);
  // Pulled while it runs.
  const [x, y] = await onLiveScreen(page, 0, [0.3, 0]);
  await page.mouse.move(x, y);
  // Not by its button: on the way from there the body moves on.
  await page.evaluate(() => window.plmPage.app.live.start());
  await page.mouse.down();
  await page.mouse.move(x + 60, y - 80, { steps: 4 });
  await until(page, async () => (await state(page, "app.live.run.end")) > 0.3, "it runs");
  await page.mouse.up();
  await page.click("#live-go");
  await settle(page);
  assert.match(await state(page, "app.history.done.at(-1).name"), /^pull /);
  const at = await state(page, "app.live.run.rows");
  await pressKey(page, "Ctrl+Z");
  await until(page, async () => (await state(page, "app.live.run.rows")) < at, "the rows of the pull are gone");
  // A number is typed, and undone in the field itself.
  const usual = await setting(page, "parameter", 0);
  await page.fill("#parameter-0", String(1.03 * Number(await page.inputValue("#parameter-0"))));
  await page.keyboard.press("Enter");
  await settle(page);
  assert.notEqual(await setting(page, "parameter", 0), usual);
  await page.keyboard.press("Control+KeyZ");
  await settle(page);
  assert.equal(await setting(page, "parameter", 0), usual);
  await until(page, async () => Number(await page.inputValue("#parameter-0")) === 1000 * usual, "the field has it again");
  await pressKey(page, "Shift+O");
  await pressKey(page, "Shift+I");
  await settle(page);
  assert.deepEqual([before.length, errors], [3, []]);
});
