// Pictures of pages for the galleries of the book: `node browser/pictures.js FOLDER TARGET`. FOLDER holds pages and pictures.json,
// which `cargo run --example manual -- --gallery FOLDER` writes, and the example gallery. SVG files are what the page itself saves,
// WebP files move. Pictures of whole pages are `book.js`'s.

import { writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { movingPicture } from "./moving.js";
import { skip, theBrowser } from "./support/browser.js";
import { galleryPicture, galleryPictures } from "./support/gallery.js";

/** The gallery of machines has 28 of them. */
const MOST_MOVING = 180_000;

if (skip) throw new Error(skip);
const [folder, target] = process.argv.slice(2);
if (target === undefined) throw new Error("usage: node browser/pictures.js FOLDER TARGET");
for (const picture of galleryPictures(folder)) {
  writeFileSync(join(target, picture.file), await (picture.moving ? moving(picture) : galleryPicture(folder, picture)));
  console.log(picture.file);
}
await (await theBrowser()).close();

/** @param {import("./support/gallery.js").Picture} picture */
async function moving({ page, file, moving }) {
  const made = await movingPicture(pathToFileURL(resolve(folder, page)).href, moving);
  if (made.file.length > MOST_MOVING) throw new Error(`${file} has ${made.file.length} bytes, more than ${MOST_MOVING}`);
  return made.file;
}
