// The pictures of the manual's demos in the book are as their pages draw them: `docs/gallery.sh` makes all anew. Their runs are made
// by the example `manual`, which PLM_MANUAL names.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { skip as withoutBrowser } from "./support/browser.js";
import { areAlike, galleryPicture, galleryPictures } from "./support/gallery.js";

const program = process.env["PLM_MANUAL"];
const skip = withoutBrowser || (program !== undefined && existsSync(program) ? false : "skipped: PLM_MANUAL names no program; `cargo build --example manual` builds it");
const images = fileURLToPath(new URL("../../../docs/src/images/manual/", import.meta.url));

test("the pictures of the manual's demos are not stale", { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "plm-gallery-"));
  execFileSync(program, ["--gallery", folder]);
  const stale = [];
  for (const picture of galleryPictures(folder)) {
    const now = await galleryPicture(folder, picture);
    if (!areAlike(readFileSync(join(images, picture.file), "utf8"), now)) stale.push(picture.file);
  }
  assert.deepEqual(stale, [], "run `bash docs/gallery.sh`, and look at what it makes");
});
