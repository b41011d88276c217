// Chromium without a screen, pages as Rust writes them, and looks at what is drawn.

import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after } from "node:test";
import { LIGHT } from "../../src/palette.js";
import { makeNpz } from "../../tests/support/npz.js";

const CHROMIUM = [process.env["CHROMIUM"], "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
const executablePath = CHROMIUM.find((path) => path !== undefined && existsSync(path));

/** @returns {Promise<any>} */
async function playwright() {
  try {
    return (await import("playwright-core")).default;
  } catch {
    return null;
  }
}

const library = await playwright();

/** Why these tests are skipped; false if they run. */
export const skip =
  library === null
    ? "skipped: playwright-core is missing; `npm ci` in crates/plm-view/page installs it"
    : executablePath === undefined
      ? "skipped: Chromium is missing; `apt-get install chromium` installs it, or CHROMIUM names it"
      : false;

/** @type {any} */
let browser = null;

/** The browser, which is closed after the last test. */
export async function theBrowser() {
  if (browser === null) {
    // Chromium as root runs without its sandbox alone.
    const args = process.getuid?.() === 0 ? ["--no-sandbox"] : [];
    browser = await library.chromium.launch({ executablePath, args });
  }
  return browser;
}

after(async () => {
  await browser?.close();
});

const folder = mkdtempSync(join(tmpdir(), "plm-page-"));

/** A page as Rust writes it: `PLM_PAGE` is the example `page`, built; else cargo builds it. @returns {string} its address */
export function writePage(name, bytes, title = name, module = null) {
  const [results, html] = [join(folder, `${name}.npz`), join(folder, `${name}.html`)];
  writeFileSync(results, bytes);
  const program = process.env["PLM_PAGE"];
  const what = [results, html, title, ...(module === null ? [] : [module])];
  if (program !== undefined) execFileSync(program, what);
  else execFileSync("cargo", ["run", "-q", "-p", "plm-view", "--example", "page", "--", ...what]);
  return pathToFileURL(html).href;
}

/** A page that `cargo test -p plm-planar --example manual pages` has written; `PLM_PAGES` names the folder. */
const made = (name) => join(process.env["PLM_PAGES"] ?? "", `${name}.html`);
export const madePage = (name) => pathToFileURL(made(name)).href;

/** Why tests of such a page are skipped; false if they run. */
export const withoutPage = (name) =>
  skip || (process.env["PLM_PAGES"] !== undefined && existsSync(made(name))
    ? false
    : `skipped: there is no page ${name}; \`cargo test -p plm-planar --example manual pages\` writes it, and PLM_PAGES names its folder`);

export const writeRuns = (name, runs, title) => writePage(name, makeNpz(runs), title);

/**
 * Opens a page, which plays by itself only where that is asked for; every request and every error of it is kept.
 * @returns {Promise<{page: any, requests: string[], errors: string[]}>}
 */
export async function open(address, { width = 1200, height = 800, theme = "light", hash = "", plays = false } = {}) {
  if (used === null || used.isClosed()) used = await newPage();
  const page = used;
  heard = { requests: [], errors: [] };
  await page.setViewportSize({ width, height });
  // Who asks for less motion starts it: most tests look at a moment.
  await page.emulateMedia({ colorScheme: theme, reducedMotion: plays ? "no-preference" : "reduce" });
  // Over another page, so that an address which differs after # alone loads anew.
  await page.goto("about:blank");
  heard.requests.length = 0;
  await page.goto(address + hash);
  await begins(page);
  await settle(page);
  return { page, ...heard };
}

/** Until the page has begun, or its script has ended with an error, after which it never does. */
async function begins(page) {
  const begun = page.waitForFunction(() => "plmPage" in window);
  begun.catch(() => {});
  let fail = () => {};
  const failed = new Promise((_, reject) => (fail = reject));
  page.on("pageerror", fail);
  try {
    await Promise.race([begun, failed]);
  } finally {
    page.off("pageerror", fail);
  }
}

/**
 * From the beginning of opening to the first frame, ms: the best of a few, because other programs keep the machine busy, and the first
 * one warms the browser.
 */
export async function openedIn(address, limit = 1000) {
  let best = Infinity;
  for (let attempt = 0; attempt < 5 && best > limit; attempt++) {
    const { page } = await open(address);
    best = Math.min(best, await page.evaluate(() => performance.getEntriesByName("first frame")[0].startTime));
  }
  console.log(`${address.split("/").at(-1)}: first frame after ${Math.round(best)} ms`);
  return best;
}

/** CPU time of a page until its first frames are drawn, ms: what a machine that does nothing else would take at most. */
export async function workOf(address) {
  const { page } = await open(address);
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const taken = async () => {
    const { metrics } = await session.send("Performance.getMetrics");
    return 1000 * metrics.find(({ name }) => name === "TaskDuration").value;
  };
  const before = await taken();
  await open(address);
  const after = await taken();
  await session.detach();
  // Another process begins at 0.
  return after >= before ? after - before : after;
}

/** A page is used again and again: to make one takes longer than most tests. @type {any} */
let used = null;
/** @type {{requests: string[], errors: string[]}} */
let heard = { requests: [], errors: [] };

async function newPage() {
  const page = await (await theBrowser()).newPage();
  // Choosers are caught from the beginning: to begin when one is awaited may be too late.
  page.on("filechooser", () => {});
  page.on("request", (request) => heard.requests.push(request.url()));
  page.on("pageerror", (error) => heard.errors.push(String(error.stack ?? error)));
  // Chromium's own warnings are no errors of the page.
  page.on("console", (message) => message.type() === "error" && heard.errors.push(message.text()));
  return page;
}

/** Until what was asked for is drawn. */
export async function settle(page) {
  await page.evaluate(async () => {
    const { frames } = window.plmPage;
    const next = () => new Promise(requestAnimationFrame);
    // Events that are under way have been heard by then.
    await next();
    await next();
    const { drawn } = frames;
    // While it plays there is always one that is asked for.
    while (frames.isAsked && frames.drawn < drawn + 2) await next();
  });
}

/** So many frames of the screen, in which something might happen that must not. */
export async function frames(page, count = 10) {
  await page.evaluate(async (left) => {
    while (left-- > 0) await new Promise(requestAnimationFrame);
  }, count);
}

/** Looks again and again until something holds. */
export async function until(page, holds, message) {
  const end = Date.now() + 20_000;
  while (!(await holds())) {
    if (Date.now() > end) throw new Error(`in 20 s it does not hold that ${message}`);
    await frames(page, 2);
  }
}

/** The colours of bodies, on a light page. */
export const BODIES = LIGHT.bodies;

/** What is on a canvas: a number of its pixels, how many differ from the background, and how many have each of some colours, or one
 * of a list of colours. */
export async function drawn(page, selector = "#picture", colours = {}) {
  return page.evaluate(
    ([target, wanted]) => {
      const canvas = document.querySelector(target);
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const words = new Uint32Array(data.buffer);
      const near = (at, [r, g, b], limit) =>
        Math.abs(data[at] - r) < limit && Math.abs(data[at + 1] - g) < limit && Math.abs(data[at + 2] - b) < limit;
      const back = [data[0], data[1], data[2], data[3]];
      let [hash, ink] = [0, 0];
      const counts = Object.fromEntries(Object.keys(wanted).map((name) => [name, 0]));
      const colours = Object.entries(wanted).map(([name, rgb]) => [name, Array.isArray(rgb[0]) ? rgb : [rgb]]);
      for (let pixel = 0; pixel < words.length; pixel++) {
        hash = (Math.imul(hash, 31) + words[pixel]) | 0;
        // Most of a picture is background.
        if (words[pixel] === words[0]) continue;
        const at = 4 * pixel;
        if (!near(at, back, 8) || Math.abs(data[at + 3] - back[3]) > 8) ink++;
        for (const [name, list] of colours) if (list.some((rgb) => near(at, rgb, 12))) counts[name]++;
      }
      return { hash, ink, back, ...counts };
    },
    [selector, colours],
  );
}

/** The middle of what is drawn in a colour, or in one of a list, in pixels of the page. */
export async function middleOf(page, rgb) {
  return page.evaluate((wanted) => {
    const canvas = document.querySelector("#picture");
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    let [x, y, count] = [0, 0, 0];
    for (let at = 0; at < data.length; at += 4) {
      if (wanted.every((rgb) => rgb.some((part, index) => Math.abs(part - data[at + index]) > 12))) continue;
      x += (at / 4) % width;
      y += Math.floor(at / 4 / width);
      count++;
    }
    const box = canvas.getBoundingClientRect();
    const ratio = width / box.width;
    return { x: box.left + x / count / ratio, y: box.top + y / count / ratio, count };
  }, Array.isArray(rgb[0]) ? rgb : [rgb]);
}

/**
 * The connected pieces of a canvas that have a colour, in its pixels: middle, number of pixels, box. Those of a few pixels are
 * corners that were smoothed.
 */
export async function pieces(page, rgb, { selector = "#picture", least = 6 } = {}) {
  return page.evaluate(
    ([target, wanted, fewest]) => {
      const canvas = document.querySelector(target);
      const { width, height } = canvas;
      const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
      const isOf = Array.from({ length: width * height }, (_, at) => wanted.every((part, index) => Math.abs(part - data[4 * at + index]) <= 12));
      const found = [];
      for (let start = 0; start < isOf.length; start++) {
        if (!isOf[start]) continue;
        isOf[start] = false;
        const [waiting, piece] = [[start], { x: 0, y: 0, count: 0, left: width, right: 0, top: height, bottom: 0 }];
        while (waiting.length > 0) {
          const at = waiting.pop();
          const [x, y] = [at % width, Math.floor(at / width)];
          [piece.x, piece.y, piece.count] = [piece.x + x, piece.y + y, piece.count + 1];
          [piece.left, piece.right] = [Math.min(piece.left, x), Math.max(piece.right, x)];
          [piece.top, piece.bottom] = [Math.min(piece.top, y), Math.max(piece.bottom, y)];
          const beside = [x > 0 ? at - 1 : at, x + 1 < width ? at + 1 : at, at - width, at + width];
          for (const next of beside.filter((other) => isOf[other])) {
            isOf[next] = false;
            waiting.push(next);
          }
        }
        if (piece.count >= fewest) found.push({ ...piece, x: piece.x / piece.count, y: piece.y / piece.count });
      }
      return found;
    },
    [selector, rgb, least],
  );
}

/** What a command does to the page. */
export const state = (page, read) => page.evaluate(`(({app}) => (${read}))(window.plmPage)`);

/** Saves a screenshot where `PLM_SHOTS` says, to be looked at. */
export async function shot(page, name) {
  const place = process.env["PLM_SHOTS"];
  if (place === undefined) return;
  mkdirSync(place, { recursive: true });
  await page.screenshot({ path: join(place, `${name}.png`) });
}
