// The README's moving pictures: `node browser/hero.js PAGE TARGET`. PAGE is what the example `four_bar` writes; docs/hero.sh runs both.

import { writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { movingPicture } from "./moving.js";
import { theBrowser } from "./support/browser.js";

const shown = { height: "320", arrows: "0.6", paths: "coupler.tip", forces: "all" };

/** Files with their options. The backgrounds are GitHub's own, so that the picture has no frame there. */
export const HERO = [
  { file: "four-bar-light.webp", options: { ...shown, scheme: "light", back: "#ffffff" } },
  { file: "four-bar-dark.webp", options: { ...shown, scheme: "dark", back: "#0d1117" } },
];

if (process.argv[1]?.endsWith("hero.js")) {
  const [page, target] = process.argv.slice(2);
  if (target === undefined) throw new Error("usage: node browser/hero.js PAGE TARGET");
  for (const { file, options } of HERO) {
    const picture = await movingPicture(pathToFileURL(resolve(page)).href, options);
    writeFileSync(join(target, file), picture.file);
    console.log(`${file}: ${(picture.file.length / 1000).toFixed(0)} kB`);
  }
  await (await theBrowser()).close();
}
