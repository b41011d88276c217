// Unpacks the style and the script of a page, and starts it.

/** @param {string} id */
const unpacked = (id) => {
  const bytes = Uint8Array.from(atob(document.getElementById(id)?.textContent ?? ""), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text();
};
document.querySelector("style")?.replaceChildren(await unpacked("packed-style"));
const script = document.createElement("script");
script.type = "module";
script.textContent = await unpacked("packed");
document.head.append(script);
