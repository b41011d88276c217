// Pictures of pages for the gallery of the book: `node browser/pictures.js FOLDER TARGET`. FOLDER holds pages and pictures.json,
// which `cargo run --example manual -- --gallery FOLDER` writes. `docs/gallery.sh` does both, and makes the pictures of whole pages.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { skip, theBrowser } from "./support/browser.js";
import { galleryPicture, galleryPictures } from "./support/gallery.js";

if (skip) throw new Error(skip);
const [folder, target] = process.argv.slice(2);
if (target === undefined) throw new Error("usage: node browser/pictures.js FOLDER TARGET");
for (const picture of galleryPictures(folder)) {
  writeFileSync(join(target, picture.file), await galleryPicture(folder, picture));
  console.log(picture.file);
}
await (await theBrowser()).close();
