// The pictures of the manual's demos in the book are as their pages draw them: `docs/gallery.sh` makes all anew. The pages are written
// by the tests of the example `manual` into the folder that PLM_GALLERY names.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { skip as withoutBrowser } from "./support/browser.js";
import { areAlike, galleryPicture, galleryPictures } from "./support/gallery.js";

const folder = process.env["PLM_GALLERY"];
const isMade = folder !== undefined && existsSync(join(folder, "pictures.json"));
const skip = withoutBrowser || (isMade ? false : "skipped: PLM_GALLERY names no gallery; `cargo test -p plm-planar --example manual program` writes it");
const images = fileURLToPath(new URL("../../../../docs/src/images/manual/", import.meta.url));

test("the pictures of the manual's demos are not stale", { skip }, async () => {
  const stale = [];
  for (const picture of galleryPictures(folder)) {
    const now = await galleryPicture(folder, picture);
    if (!areAlike(readFileSync(join(images, picture.file), "utf8"), now)) stale.push(picture.file);
  }
  assert.deepEqual(stale, [], "run `bash docs/gallery.sh`, and look at what it makes");
});
