// *Open* at the declarations of the book: the link of each holds its text, as the playground reads it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import test from "node:test";
import vm from "node:vm";
import { unpackText } from "../../crates/plm-view/page/src/packedtext.js";

const root = path.join(import.meta.dirname, "../..");
const source = path.join(root, "docs/src");
const context = vm.createContext({ Blob, Response, CompressionStream, Uint8Array, btoa });
vm.runInContext(fs.readFileSync(path.join(root, "docs/theme/open.js"), "utf8"), context);

/** Blocks of code of the pages, as the book shows them: page, language and marks, text. */
const blocks = fs.readdirSync(source, { recursive: true }).filter((file) => file.endsWith(".md")).flatMap((page) => {
  const text = fs.readFileSync(path.join(source, page), "utf8");
  const fences = text.matchAll(/^```(plm|rust)([^\n]*)\n([^]*?)^```/gm);
  // Lines that are hidden at first are part of the block.
  return [...fences].map(([, language, marks, code]) => ({ page, language, marks, text: code.replace(/^# /gm, "") }));
});

const declared = blocks.flatMap((block) => context.plmDeclarations(block.text, block.language === "rust").map((text) => ({ ...block, text })));

test("each declaration of the book has a link that holds its text", async () => {
  for (const { page, text } of declared) {
    const fragment = await context.plmFragment(text);
    assert.equal(await unpackText(new URLSearchParams(fragment.slice(1)).get("text")), text, page);
  }
  assert.ok(declared.length > 80, `${declared.length} declarations`);
});

test("no block with a mechanism is forgotten", () => {
  const isWhole = ({ language, text }) => (language === "plm" ? /^(pub )?[A-Z]\w* \{$/m.test(text) : /\bmechanism! \{$/m.test(text) && !text.includes("$"));
  const pages = new Set(declared.map(({ page }) => page));
  const forgotten = blocks.filter(isWhole).filter(({ page }) => !pages.has(page)).map(({ page }) => page);
  assert.deepEqual([...new Set(forgotten)], []);
});

const plm = process.env.PLM ?? path.join(root, "target/debug/plm");

test("what a link holds is a declaration", { skip: fs.existsSync(plm) ? false : "skipped: there is no `plm`; `cargo build -p plm-cli`" }, () => {
  const wrong = [];
  for (const { page, marks, text } of declared) {
    // Pages of diagnostics show mistakes, and some declarations read files.
    if (/E\d{4}|W\d{4}|compile_fail|ignore/.test(marks) || page.startsWith("diagnostics") || /(contour|hole): "/.test(text)) continue;
    try {
      execFileSync(plm, ["check", "-"], { input: text, stdio: ["pipe", "pipe", "pipe"] });
    } catch (why) {
      wrong.push(`${page}: ${why.stderr}`);
    }
  }
  assert.deepEqual(wrong, []);
});
