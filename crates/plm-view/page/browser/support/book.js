// Pictures of whole pages in the book: which there are, how they are made, and how far two are from one another.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { madePage, open, settle } from "./browser.js";

/** Of pages that `cargo test -p plm-planar --example manual pages` has written. */
export const BOOK = [
  { file: "page.png", page: "DoublePendulum", size: [1200, 800], theme: "light", hash: "#t=1.3" },
  { file: "manual/figure-115.png", page: "DoublePendulum", size: [960, 600], theme: "light", hash: "#t=0.6&curves=shoulder.force.x|shoulder.force.y" },
];

/** Where a picture of the book stands. */
export const pathOf = ({ file }) => fileURLToPath(new URL(`../../../../../docs/src/images/${file}`, import.meta.url));

/** The picture as the page gives it now, as bytes of a PNG file. */
export async function pictureOf({ page: name, size: [width, height], theme, hash }) {
  const { page, errors } = await open(madePage(name), { width, height, theme, hash });
  if (errors.length > 0) throw new Error(`${name}: ${errors.join("\n")}`);
  await page.mouse.move(0, 0);
  await settle(page);
  return page.screenshot();
}

/** Squares of so many pixels are compared by their mean colour: letters of another font are as dark as those before. */
const SQUARE = 16;

/**
 * How far two PNG files are from one another: the mean difference of squares (of 255), and the share of those that differ clearly.
 * Infinite where the sizes differ.
 */
export async function distanceOf(page, before, after) {
  return page.evaluate(
    async ([files, square]) => {
      const [a, b] = await Promise.all(
        files.map(async (base64) => {
          const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
          const { width, height } = await createImageBitmap(new Blob([bytes]));
          const small = await createImageBitmap(new Blob([bytes]), { resizeWidth: Math.round(width / square), resizeHeight: Math.round(height / square), resizeQuality: "high" });
          const canvas = new OffscreenCanvas(small.width, small.height);
          const context = canvas.getContext("2d");
          context.drawImage(small, 0, 0);
          return { width, height, data: context.getImageData(0, 0, small.width, small.height).data };
        }),
      );
      if (a.width !== b.width || a.height !== b.height) return { mean: Infinity, share: 1 };
      let [sum, clear] = [0, 0];
      for (let at = 0; at < a.data.length; at += 4) {
        const difference = Math.max(...[0, 1, 2].map((part) => Math.abs(a.data[at + part] - b.data[at + part])));
        sum += difference;
        clear += Number(difference > 24);
      }
      return { mean: (4 * sum) / a.data.length, share: (4 * clear) / a.data.length };
    },
    [[before, after].map((bytes) => bytes.toString("base64")), SQUARE],
  );
}

export const readPicture = (picture) => readFileSync(pathOf(picture));
