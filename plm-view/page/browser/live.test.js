// The mechanism alive in the page, with a real module.

import assert from "node:assert/strict";
import { test } from "node:test";
import { makeNpz } from "../tests/support/npz.js";
import { fourBarHead, modulePath, nativeRows, runOfRows, withoutModule } from "../tests/support/live.js";
import { drawn, open, settle, shot, skip as withoutBrowser, state, writePage } from "./support/browser.js";

const skip = withoutBrowser || withoutModule;

const address = skip ? "" : writePage("live", makeNpz([runOfRows(fourBarHead(), nativeRows())], { how: "deflated" }), "Four-bar", modulePath());

test("it moves by itself", { skip }, async () => {
  const { page, requests, errors } = await open(address);
  await page.waitForFunction(() => window.plmPage.app.live.run.rows > 20);
  const before = await drawn(page);
  await page.waitForTimeout(300);
  const after = await drawn(page);
  assert.deepEqual(errors, []);
  assert.notEqual(before.hash, after.hash);
  console.log(requests, before, after, await state(page, "[app.player.time, app.player.end]"));
  await shot(page, "live");
});
