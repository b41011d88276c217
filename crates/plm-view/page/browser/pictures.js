// Pictures of pages for the gallery of the book: `node browser/pictures.js FOLDER TARGET`. FOLDER holds pages and pictures.json,
// which `cargo run --example manual -- --gallery FOLDER` writes, and the example gallery, whose pictures move. `docs/gallery.sh` does both.

import { writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { movingPicture } from "./moving.js";
import { skip, theBrowser } from "./support/browser.js";
import { galleryPicture, galleryPictures, movingPictures } from "./support/gallery.js";

/** A page of the book has all of them. */
const MOST_MOVING = 180_000;

if (skip) throw new Error(skip);
const [folder, target] = process.argv.slice(2);
if (target === undefined) throw new Error("usage: node browser/pictures.js FOLDER TARGET");
for (const picture of galleryPictures(folder)) {
  writeFileSync(join(target, picture.file), await galleryPicture(folder, picture));
  console.log(picture.file);
}
for (const { page, file, moving } of movingPictures(folder)) {
  const made = await movingPicture(pathToFileURL(resolve(folder, page)).href, moving);
  if (made.file.length > MOST_MOVING) throw new Error(`${file} has ${made.file.length} bytes, more than ${MOST_MOVING}`);
  writeFileSync(join(target, file), made.file);
  console.log(file);
}
await (await theBrowser()).close();
