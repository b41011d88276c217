// The pictures of the page in the book are as the page is. Where one is not, `bash crates/plm-view/page/check.sh --book` makes all anew.

import assert from "node:assert/strict";
import { test } from "node:test";
import { open, withoutPage, madePage } from "./support/browser.js";
import { BOOK, distanceOf, pictureOf, readPicture } from "./support/book.js";

/** Letters of fixed width are nearer (0.7 and 0.3 %), a page with one button less is farther (0.4 % of its squares). */
const MOST = { mean: 1, share: 0.004 };

for (const picture of BOOK) {
  test(`${picture.file} is not stale`, { skip: withoutPage(picture.page) }, async () => {
    const now = await pictureOf(picture);
    const { page } = await open(madePage(picture.page));
    const { mean, share } = await distanceOf(page, readPicture(picture), now);
    console.log(`${picture.file}: squares differ by ${mean.toFixed(2)} of 255, ${(100 * share).toFixed(1)} % of them clearly`);
    assert.ok(mean < MOST.mean && share < MOST.share, "run `bash crates/plm-view/page/check.sh --book`, and look at what it makes");
  });
}
