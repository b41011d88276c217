// Unpacks the script of a page and starts it.

const packed = Uint8Array.from(atob(document.getElementById("packed")?.textContent ?? ""), (letter) => letter.charCodeAt(0));
const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
const script = document.createElement("script");
script.type = "module";
script.textContent = await new Response(stream).text();
document.head.append(script);
