// The built book: its links lead somewhere, nothing of it is fetched from elsewhere, and it holds at the widths of a phone, a
// tablet and a screen.

import assert from "node:assert/strict";
import fs from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import path from "node:path";
import test, { after } from "node:test";
import { unpackText } from "../../crates/plm-view/page/src/packedtext.js";

const root = path.join(import.meta.dirname, "../..");
const book = path.resolve(process.env.PLM_BOOK ?? path.join(root, "target/book"));
const files = fs.readdirSync(book, { recursive: true }).map((file) => file.replaceAll("\\", "/"));
const pages = files.filter((file) => file.endsWith(".html") && !["404.html", "toc.html"].includes(file));
const text = (file) => fs.readFileSync(path.join(book, file), "utf8");

/** Values of an attribute in the tags of a page; a listing of HTML has none. */
const values = (html, name) =>
  [...html.matchAll(/<[a-z][^<>]*>/gi)].flatMap(([tag]) => [...tag.matchAll(new RegExp(`\\s${name}="([^"]*)"`, "g"))].map((found) => found[1]));

test("every link of every page leads to a page and a place in it", () => {
  const ids = new Map(pages.map((page) => [page, new Set(values(text(page), "id"))]));
  const wrong = [];
  for (const page of pages.filter((page) => page !== "print.html")) {
    const html = text(page);
    for (const target of ["href", "src", "srcset"].flatMap((name) => values(html, name))) {
      if (/^(https?|mailto|data):/.test(target)) continue;
      const [file, place] = decodeURIComponent(target).split("#");
      const aim = file === "" ? page : path.posix.join(path.posix.dirname(page), file);
      const isThere = fs.existsSync(path.join(book, aim)) && (!place || ids.get(aim)?.has(place));
      if (!isThere) wrong.push(`${page}: ${target}`);
    }
  }
  assert.deepEqual([...new Set(wrong)], []);
});

test("the language in short names pages that are there", () => {
  const targets = [...text("llms.txt").matchAll(/\]\(([^)]*)\)/g)].map((found) => found[1]);
  assert.ok(targets.length > 80, `${targets.length} pages`);
  assert.deepEqual(targets.filter((target) => !fs.existsSync(path.join(book, target))), []);
});

test("no page, style or script of the book names another server to fetch from", () => {
  const wrong = [];
  for (const file of files.filter((file) => /\.(html|css)$/.test(file))) {
    const fetched = [...text(file).matchAll(/(?:\ssrc=|<link[^>]*href=|url\(|@import\s*)["']?(?:https?:)?\/\/[^"')\s]*/g)];
    wrong.push(...fetched.map((found) => `${file}: ${found[0]}`));
  }
  assert.deepEqual(wrong, []);
  assert.ok(!/class="[^"]*playground/.test(text("getting-started.html")), "a button would run code elsewhere");
});

test("every formula is MathML, and no page shows a dollar sign of one", () => {
  const math = pages.filter((page) => text(page).includes("<math"));
  assert.ok(math.length > 20, `${math.length} pages have formulas`);
  for (const page of pages) {
    const prose = text(page).replaceAll(/<(code|pre|script|style)[\s>][\s\S]*?<\/\1>/g, "");
    assert.ok(!/\$[^$\n]+\$/.test(prose), `${page} shows a formula as text`);
    assert.ok(!prose.includes("<merror"), page);
  }
});

const require = createRequire(path.join(root, "crates/plm-view/page/package.json"));
const library = (() => {
  try {
    return require("playwright-core");
  } catch {
    return null;
  }
})();
const known = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
const executablePath = known.find((file) => file !== undefined && fs.existsSync(file));
const skip = library === null || executablePath === undefined ? "playwright-core or Chromium is missing" : false;

const types = { html: "text/html", css: "text/css", js: "text/javascript", svg: "image/svg+xml", png: "image/png" };
const server = http.createServer((request, response) => {
  const name = path.join(book, decodeURIComponent(new URL(request.url, "http://book").pathname));
  fs.readFile(name, (why, bytes) => {
    response.writeHead(why ? 404 : 200, { "content-type": types[name.split(".").pop()] ?? "application/octet-stream" });
    response.end(bytes);
  });
});
let browser = null;
after(async () => {
  await browser?.close();
  server.close();
});

/** Widths of a phone, a tablet and a screen, the system's theme, and pages that are looked at there. */
const looks = [
  [390, "dark", ["getting-started", "parts/fluid", "theory/near-singular", "running/modes"]],
  [820, "light", ["parts/fluid", "theory/equations"]],
  [1200, "dark", ["parts/fluid", "theory/equations"]],
];

test("in a browser", { skip }, async (t) => {
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  const here = `http://127.0.0.1:${server.address().port}/`;
  // Chromium as root runs without its sandbox alone.
  const args = process.getuid?.() === 0 ? ["--no-sandbox"] : [];
  browser = await library.chromium.launch({ executablePath, args });

  /** A page with what went wrong on it: requests of other servers, and errors. */
  const open = async (name, width, colorScheme) => {
    const context = await browser.newContext({ viewport: { width, height: 844 }, colorScheme });
    const [page, wrong] = [await context.newPage(), []];
    page.on("request", (of) => /^(data:|blob:)/.test(of.url()) || of.url().startsWith(here) || wrong.push(of.url()));
    page.on("response", (of) => of.status() < 400 || wrong.push(`${of.status()} ${of.url()}`));
    page.on("pageerror", (why) => wrong.push(String(why)));
    await page.goto(`${here}${name}.html`, { waitUntil: "load" });
    return { page, wrong, close: () => context.close() };
  };

  for (const [width, scheme, names] of looks) {
    await t.test(`${width} px, ${scheme}: nothing is wider than the page, and nothing comes from elsewhere`, async () => {
      for (const name of names) {
        const { page, wrong, close } = await open(name, width, scheme);
        const found = await page.evaluate(() => ({
          wide: document.documentElement.scrollWidth - innerWidth,
          isDark: getComputedStyle(document.documentElement).colorScheme.includes("dark"),
          isColoured: document.querySelector("code.language-plm .hljs-keyword, code.language-rust .hljs-keyword") !== null,
          heights: [...document.querySelectorAll("div.math math")].map((of) => of.getBoundingClientRect().height),
        }));
        assert.ok(found.wide <= 0, `${name}: ${found.wide} px too wide`);
        assert.equal(found.isDark, scheme === "dark", `${name}: the theme is not the system's`);
        assert.ok(found.isColoured || name === "theory/near-singular", `${name}: no code has colours`);
        assert.ok(found.heights.length > 0 || !/parts|equations/.test(name), `${name}: no formulas`);
        assert.ok(found.heights.every((height) => height > 15), `${name}: ${found.heights}`);
        assert.deepEqual(wrong, [], name);
        await close();
      }
    });
  }

  await t.test("pictures follow the theme that the reader picks", async () => {
    const { page, close } = await open("getting-started", 820, "light");
    // A page of its own: pictures of the book may have one colour alone.
    const shown = await page.evaluate(async (script) => {
      document.querySelector("main").insertAdjacentHTML("beforeend", `<picture><source media="(prefers-color-scheme: dark)"
        srcset="favicon-dark.svg"><img src="favicon.svg"></picture>`);
      (0, eval)(script);
      const image = document.querySelector("main > picture img");
      const names = [];
      for (const [theme, name] of [["navy", "favicon-dark.svg"], ["light", "favicon.svg"]]) {
        document.getElementById(`mdbook-theme-${theme}`).click();
        const shown = () => image.currentSrc.split("/").pop();
        // A browser picks a source when it gets to it.
        for (let tries = 0; tries < 50 && shown() !== name; tries++) {
          await new Promise((later) => setTimeout(later, 100));
        }
        names.push(shown());
      }
      return names;
    }, fs.readFileSync(path.join(root, "docs/theme/pictures.js"), "utf8"));
    assert.deepEqual(shown, ["favicon-dark.svg", "favicon.svg"]);
    await close();
  });

  await t.test("declarations have a link where there is a playground, and none where there is none", async () => {
    const { page, wrong, close } = await open("getting-started", 1200, "light");
    const links = () => page.locator(".open-declaration a").evaluateAll((all) => all.map((link) => link.getAttribute("href")));
    assert.deepEqual(await links(), []);
    await page.evaluate(() => plmLink("playground.html"));
    const [first] = await links();
    const text = await unpackText(new URLSearchParams(first.slice("playground.html#".length)).get("text"));
    assert.match(text, /^\/\/\/ The double pendulum[^]*^pub DoublePendulum \{$/m);
    assert.deepEqual(wrong, []);
    await close();
  });

  await t.test("the search finds a page by its word", async () => {
    const { page, wrong, close } = await open("introduction", 1200, "light");
    await page.keyboard.press("s");
    await page.waitForSelector("#mdbook-searchbar:focus, #searchbar:focus");
    await page.keyboard.type("revolute");
    await page.waitForSelector("ul[id$=searchresults] li a[href*='parts/revolute']");
    assert.deepEqual(wrong, []);
    await close();
  });
});
