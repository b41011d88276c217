// *Open* at each declaration of a page: a link to the playground that holds the text, where the book has a playground beside it
// (playground-page.js).

/** The declarations of a text of this language: all of a `plm` text that has a mechanism, and each `mechanism! { … }` of Rust. */
function plmDeclarations(text, isRust) {
  if (!isRust) return plmHasMechanism(text) ? [text] : [];
  const found = [];
  const call = /\bmechanism!\s*\{/g;
  // Comments and strings are blanks of the same length, so that brackets in them do not count.
  const code = text.replace(/\/\/.*|\/\*[^]*?\*\/|"(?:[^"\\]|\\[^])*"/g, all => " ".repeat(all.length));
  for (let head = call.exec(code); head !== null; head = call.exec(code)) {
    let [depth, at] = [1, call.lastIndex];
    for (; depth > 0 && at < code.length; at++) depth += { "{": 1, "}": -1 }[code[at]] ?? 0;
    const inside = plmFromMargin(text.slice(call.lastIndex, at - 1));
    if (depth === 0 && plmHasMechanism(inside)) found.push(inside);
  }
  return found;
}

/** Has a text a mechanism, and not parts or items alone? What it takes from other files, or from a macro around it, is not there. */
function plmHasMechanism(text) {
  const code = text.replace(/\/\/.*|\/\*[^]*?\*\//g, " ");
  return /^(?:pub\s+)?[A-Z]\w*\s*\{/m.test(code.replace(/^\s+/, "")) && !/^\s*use\b|\$\w|…/.test(code);
}

/** Lines without the blanks that all of them begin with. */
function plmFromMargin(text) {
  const lines = text.split("\n").map(line => line.trimEnd());
  const margin = Math.min(...lines.filter(line => line !== "").map(line => line.length - line.trimStart().length));
  return `${lines.map(line => line.slice(margin)).join("\n").trim()}\n`;
}

/** The part of an address after `#` that holds a text: deflated, in base 64 for addresses, as the playground reads it. */
async function plmFragment(text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const letters = Array.from(bytes, byte => String.fromCharCode(byte)).join("");
  return `#text=${btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** Puts the links after the blocks of the page. */
async function plmLink(address) {
  for (const block of document.querySelectorAll("pre > code.language-plm, pre > code.language-rust")) {
    const texts = plmDeclarations(block.textContent, block.matches(".language-rust"));
    const links = await Promise.all(texts.map(async text => {
      const name = /\b([A-Z]\w*)\s*\{/.exec(text)?.[1] ?? "it";
      const link = document.createElement("a");
      link.href = address + await plmFragment(text);
      link.textContent = `Open ${name} in the playground`;
      return link;
    }));
    if (links.length === 0) continue;
    const line = document.createElement("p");
    line.className = "open-declaration";
    links.forEach((link, at) => line.append(...(at > 0 ? [" · "] : []), link));
    block.parentElement.after(line);
  }
}

if (typeof document !== "undefined") {
  const script = document.createElement("script");
  script.src = `${path_to_root}playground-page.js`;
  script.onload = () => plmPlayground !== null && plmLink(path_to_root + plmPlayground);
  document.head.append(script);
}
