// Unpacks the style and the script of a page with an editor, and starts it.

import { undense } from "./src/dense.js";
import { unlzma } from "./src/lzma.js";

/** @param {string} id */
const bytesOf = (id) => undense(document.getElementById(id)?.textContent ?? "");
const style = new Blob([bytesOf("packed-style")]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
document.querySelector("style")?.replaceChildren(await new Response(style).text());
const script = document.createElement("script");
script.type = "module";
script.textContent = new TextDecoder().decode(unlzma(bytesOf("packed")));
document.head.append(script);
