// A command used in every way that it has: by its button, and by each of its keys.

import assert from "node:assert/strict";
import { COMMANDS } from "../../src/commands.js";
import { drawn, open, settle, state } from "./browser.js";

export const button = (id) => `#do-${id.replace(" ", "-")}`;

/** Presses the button of a command; where it has none, the menu has its item. */
export async function press(page, id) {
  if (!(await page.locator(button(id)).isVisible())) await page.click("#do-menu");
  await page.click(button(id));
}

/** Whether a command is shown to be on, by its button or in the menu. */
export async function isOn(page, id) {
  if (await page.locator(button(id)).isVisible()) return (await page.getAttribute(button(id), "aria-pressed")) === "true";
  await page.click("#do-menu");
  const checked = await page.getAttribute(button(id), "aria-checked");
  await page.keyboard.press("Escape");
  return checked === "true";
}

/** How each command is used: by its button and by each of its keys that reaches a page. */
const waysOf = (command) => [
  ...(command.icon === null ? [] : [{ how: "mouse", use: (page) => press(page, command.id) }]),
  ...command.keys
    // These the browser keeps for itself; the second key does the same.
    .filter((key) => !["Ctrl+N", "Ctrl+Q"].includes(key))
    .map((key) => ({ how: key, use: (page) => pressKey(page, key) })),
];

export const pressKey = (page, key) =>
  page.keyboard.press(key.replace("Ctrl", "Control").replace(/(^|\+)([A-Z])$/, (_, before, letter) => before + `Key${letter}`));

/** Runs a check for each way of using a command, each on a page as it opens. */
export async function everyWay(id, check, { address, hash = "" }) {
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
export async function changes(page, act, message, least = 5000) {
  const before = await drawn(page);
  await act();
  const after = await drawn(page);
  assert.ok(Math.min(before.ink, after.ink) > least, `${message}: ${before.ink}, then ${after.ink} pixels are drawn`);
  assert.notEqual(after.hash, before.hash, `${message} changes the picture`);
}

export const time = (page) => state(page, "app.player.time");
