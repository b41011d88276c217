// Unpacks the style and the script of a page, and starts it.

import { undense } from "./src/dense.js";

/** @param {string} id */
const unpacked = (id) => {
  const bytes = undense(document.getElementById(id)?.textContent ?? "");
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text();
};
document.querySelector("style")?.replaceChildren(await unpacked("packed-style"));
const script = document.createElement("script");
script.type = "module";
script.textContent = await unpacked("packed");
document.head.append(script);
