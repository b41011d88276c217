// The page of a running program: `PLM_SERVED` is the example `served` of plm-planar, built.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createInterface } from "node:readline";
import { after, test } from "node:test";
import { drawn, open, settle, shot, skip as withoutBrowser, state } from "./support/browser.js";

const program = process.env["PLM_SERVED"];
const skip =
  withoutBrowser ||
  (program === undefined ? "skipped: PLM_SERVED does not name the example `served`; `cargo build --example served` builds it" : false);

/** @type {import("node:child_process").ChildProcess[]} */
const running = [];
after(() => running.forEach((child) => child.kill()));

/** Starts the program; its address. */
async function serve(port = 0) {
  const child = spawn(program, port === 0 ? [] : [`--serve=${port}`], { stdio: ["ignore", "pipe", "inherit"] });
  running.push(child);
  const [line] = await once(createInterface({ input: child.stdout }), "line");
  return { child, address: /http:\S+/.exec(line)[0] };
}

const angle = (page) => state(page, "app.live.run.poses.at(app.live.run.rows - 1, 2)");

test("it shows what a program computes, and its sliders reach it", { skip }, async () => {
  const { child, address } = await serve();
  const { page, requests, errors } = await open(address);
  await page.waitForFunction(() => window.plmPage.app.live.run.rows > 20);
  assert.deepEqual([...new Set(requests)].sort(), [address, `${address}events`]);
  const [before, rows] = [await drawn(page), await state(page, "app.live.run.rows")];
  assert.match(await page.textContent("#live-state"), /Running/);

  // The controller brings the rod to the angle that the slider asks for.
  await page.locator("#input-0").fill("30");
  await page.locator("#input-0").press("Enter");
  await page.waitForFunction(() => {
    const { run } = window.plmPage.app.live;
    return Math.abs(run.poses.at(run.rows - 1, 2) - Math.PI / 6) < 0.1;
  });
  await settle(page);
  const after = await drawn(page);
  assert.ok(before.ink > 3000 && after.ink > 3000 && before.hash !== after.hash);
  assert.ok((await state(page, "app.live.run.rows")) > rows);
  await page.locator("#input-0-slider").focus();
  await page.keyboard.press("Home");
  await page.waitForFunction(() => {
    const { run } = window.plmPage.app.live;
    return run.poses.at(run.rows - 1, 2) < 0;
  });
  await shot(page, "served");

  // Pause stands still.
  await page.click("#live-go");
  await page.waitForFunction(() => /Paused/.test(document.querySelector("#live-state").textContent));
  const still = await state(page, "app.live.run.end");
  await page.waitForTimeout(200);
  assert.equal(await state(page, "app.live.run.end"), still);
  await page.click("#live-reset");
  await page.waitForFunction(() => window.plmPage.app.live.run.rows === 1);
  assert.ok(Math.abs((await angle(page)) - Math.PI / 9) < 1e-12);
  // The output asks for degrees, and is shown in them.
  const output = await state(page, "((run, at) => [run.columns[at].unit, run.values.at(0, at)])(app.live.run, app.live.run.columns.findIndex(({ name }) => name === 'rod.angle'))");
  assert.ok(output[0] === "deg" && Math.abs(output[1] - 20) < 1e-10, `${output}`);

  await page.click("#live-go");
  await page.waitForFunction(() => window.plmPage.app.live.run.rows > 20);
  assert.deepEqual(errors, []);
  // The program ends: the page says so, and keeps what it has.
  child.kill();
  await page.waitForFunction(() => /ended/.test(document.querySelector("#live-state").textContent));
  assert.match(await page.textContent("#messages"), /What it has shown stays/);
  assert.ok((await state(page, "app.live.run.rows")) > 20);
  // It starts anew at the same address: the page shows it by itself.
  await serve(Number(new URL(address).port));
  await page.waitForFunction(() => /Running/.test(document.querySelector("#live-state").textContent));
  const begun = await state(page, "app.live.run.end");
  await page.waitForFunction((at) => window.plmPage.app.live.run.end > at, begun);
  assert.doesNotMatch(await page.textContent("#messages"), /ended/);
});
