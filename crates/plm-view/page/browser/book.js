// Makes the pictures of whole pages in the book: `node browser/book.js`, with PLM_PAGES as check.sh sets it (`check.sh --book`).
// `book.test.js` tells when they are stale.

import { writeFileSync } from "node:fs";
import { skip, theBrowser, withoutPage } from "./support/browser.js";
import { BOOK, pathOf, pictureOf } from "./support/book.js";

if (skip) throw new Error(skip);
for (const picture of BOOK) {
  const why = withoutPage(picture.page);
  if (why) throw new Error(why);
  writeFileSync(pathOf(picture), await pictureOf(picture));
  console.log(picture.file);
}
await (await theBrowser()).close();
