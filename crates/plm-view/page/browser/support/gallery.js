// A picture of the gallery of the manual's demos, as its page saves it.

import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { open, settle } from "./browser.js";

/** More would be slow to load beside others. */
const MOST_BYTES = 60_000;

/** @typedef {{page: string, file: string, shows: string, size: [number, number]}} Picture */

/** The pictures that `manual --gallery FOLDER` has listed; those of whole pages are `book.js`'s. @returns {Picture[]} */
export function galleryPictures(folder) {
  return JSON.parse(readFileSync(join(folder, "pictures.json"), "utf8")).filter(({ file }) => file.endsWith(".svg"));
}

/** Those that move, of the machines, which `gallery --gallery FOLDER` has listed. @returns {{page: string, file: string, moving: Record<string, string>}[]} */
export function movingPictures(folder) {
  return JSON.parse(readFileSync(join(folder, "pictures.json"), "utf8")).filter(({ moving }) => moving !== undefined);
}

/** The text of a picture as its page saves it now. @param {string} folder @param {Picture} picture @returns {Promise<string>} */
export async function galleryPicture(folder, { page, file, shows, size: [width, height] }) {
  // Paths are drawn where the picture names them alone.
  const hash = `#${shows}&paths=&panel=0&t=0`;
  const { page: tab, errors } = await open(pathToFileURL(resolve(folder, page)).href, { width: width + 20, height: height + 100, hash });
  if (errors.length > 0) throw new Error(`${page}: ${errors.join("\n")}`);
  // Around the picture the page has its buttons and the time line.
  const around = await tab.evaluate(() => {
    const { width, height } = window.plmPage.app.area;
    return [window.innerWidth - width, window.innerHeight - height];
  });
  await tab.setViewportSize({ width: width + around[0], height: height + around[1] });
  await settle(tab);
  const asked = new URLSearchParams(shows);
  await tab.evaluate(
    ([preset, zoom]) => {
      const { app } = window.plmPage;
      app.lookFrom(preset);
      app.view.zoom(zoom);
      app.touch();
    },
    [asked.get("preset") ?? "front", Number(asked.get("zoom") ?? 0.9)],
  );
  await settle(tab);
  const saved = tab.waitForEvent("download");
  await tab.keyboard.press("Shift+S");
  const text = readFileSync(await (await saved).path(), "utf8");
  if (text.length > MOST_BYTES) throw new Error(`${file} has ${text.length} bytes, more than ${MOST_BYTES}`);
  return text;
}

const NUMBER = /-?\d+(\.\d+)?/g;

/** Whether two pictures have the same shapes, their places alike to half a pixel. @param {string} before @param {string} after */
export function areAlike(before, after) {
  const shapes = (/** @type {string} */ text) => text.replace(NUMBER, "#");
  const numbers = (/** @type {string} */ text) => (text.match(NUMBER) ?? []).map(Number);
  const [a, b] = [numbers(before), numbers(after)];
  return shapes(before) === shapes(after) && a.every((value, at) => Math.abs(value - b[at]) <= 0.5);
}
