// Pictures of pages for the gallery of the book: `node browser/pictures.js FOLDER TARGET`. FOLDER holds pages and pictures.json,
// which `cargo run --example manual -- --gallery FOLDER` writes, and the example gallery. SVG files are what the page itself saves,
// PNG files show all of it, WebP files move.

import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { movingPicture } from "./moving.js";
import { open, settle, skip, theBrowser } from "./support/browser.js";

/** More would be slow to load beside others. */
const MOST_BYTES = 60_000;
/** The gallery of machines has 28 of them. */
const MOST_MOVING = 180_000;

if (skip) throw new Error(skip);
const [folder, target] = process.argv.slice(2);
if (target === undefined) throw new Error("usage: node browser/pictures.js FOLDER TARGET");
for (const picture of JSON.parse(readFileSync(join(folder, "pictures.json"), "utf8"))) {
  await (picture.moving ? moving(picture) : picture.file.endsWith(".png") ? wholePage(picture) : itsPicture(picture));
  console.log(picture.file);
}
await (await theBrowser()).close();

/** @typedef {{page: string, file: string, shows: string, size: [number, number], moving?: Record<string, string>}} Picture */

/** @param {Picture} picture */
async function moving({ page, file, moving }) {
  const made = await movingPicture(pathToFileURL(resolve(folder, page)).href, moving);
  if (made.file.length > MOST_MOVING) throw new Error(`${file} has ${made.file.length} bytes, more than ${MOST_MOVING}`);
  writeFileSync(join(target, file), made.file);
}

/** @param {Picture} picture @param {{width: number, height: number}} size @param {string} more */
async function openPage({ page, shows }, size, more = "") {
  const { page: tab, errors } = await open(pathToFileURL(resolve(folder, page)).href, { ...size, hash: `#${shows}${more}` });
  if (errors.length > 0) throw new Error(`${page}: ${errors.join("\n")}`);
  return tab;
}

/** @param {Picture} picture */
async function wholePage(picture) {
  const [width, height] = picture.size;
  const tab = await openPage(picture, { width, height });
  await tab.screenshot({ path: join(target, picture.file) });
}

/** @param {Picture} picture */
async function itsPicture(picture) {
  const [width, height] = picture.size;
  // Around the picture the page has its buttons and the time line.
  const around = await openPage(picture, { width, height }, "&panel=0").then((tab) =>
    tab.evaluate(() => {
      const { width, height } = window.plmPage.app.area;
      return [window.innerWidth - width, window.innerHeight - height];
    }),
  );
  const tab = await openPage(picture, { width: width + around[0], height: height + around[1] }, "&panel=0");
  const shows = new URLSearchParams(picture.shows);
  await tab.evaluate(
    ([preset, zoom]) => {
      const { app } = window.plmPage;
      app.lookFrom(preset);
      app.view.zoom(zoom);
      app.touch();
    },
    [shows.get("preset") ?? "front", Number(shows.get("zoom") ?? 0.9)],
  );
  await settle(tab);
  const saved = tab.waitForEvent("download");
  await tab.keyboard.press("Shift+S");
  const path = join(target, picture.file);
  await (await saved).saveAs(path);
  const { length } = readFileSync(path);
  if (length > MOST_BYTES) throw new Error(`${picture.file} has ${length} bytes, more than ${MOST_BYTES}`);
}
