// Moving pictures of pages: what the browser decodes is what the page shows, nothing is cut off, and the loop has no seam.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { workshop } from "../tests/support/scenes.js";
import { HERO } from "./hero.js";
import { framesOf, movingPicture } from "./moving.js";
import { open, skip, writeRuns } from "./support/browser.js";
import { address as live, skip as withoutLive } from "./support/livepage.js";

const address = skip ? "" : writeRuns("moving", [workshop()]);
const PURPLE = [123, 31, 162];
const FORCE = [194, 24, 91];

/** What the browser makes of a file: times, the rim of each frame, and how many pixels are near some colours. */
async function decoded(file, colours) {
  const { page } = await open(address);
  return page.evaluate(
    async ([text, wanted]) => {
      const data = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
      const decoder = new ImageDecoder({ data, type: "image/webp" });
      await decoder.tracks.ready;
      await decoder.completed;
      const { frameCount, repetitionCount } = decoder.tracks.selectedTrack;
      const frames = [];
      for (let frameIndex = 0; frameIndex < frameCount; frameIndex++) {
        const { image } = await decoder.decode({ frameIndex });
        const [width, height] = [image.displayWidth, image.displayHeight];
        const context = new OffscreenCanvas(width, height).getContext("2d");
        context.drawImage(image, 0, 0);
        const pixels = context.getImageData(0, 0, width, height).data;
        const words = new Uint32Array(pixels.buffer);
        const isRim = (_, at) => at < width || at >= width * (height - 1) || at % width === 0 || at % width === width - 1;
        const counts = wanted.map((rgb) => words.reduce((sum, _, at) => sum + rgb.every((part, index) => Math.abs(pixels[4 * at + index] - part) < 12), 0));
        frames.push({ width, height, ms: image.duration / 1000, rim: new Set(words.filter(isRim)).size, counts, pixels: [...words] });
      }
      return { loops: repetitionCount, frames };
    },
    [Buffer.from(file).toString("base64"), colours],
  );
}

/** Pixels of some frames of a file, RGBA. */
async function pixelsOf(file, wanted) {
  const { page } = await open(address);
  const texts = await page.evaluate(
    async ([text, indices]) => {
      const data = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
      const decoder = new ImageDecoder({ data, type: "image/webp" });
      await decoder.tracks.ready;
      await decoder.completed;
      const found = [];
      for (const frameIndex of indices) {
        const { image } = await decoder.decode({ frameIndex });
        const context = new OffscreenCanvas(image.displayWidth, image.displayHeight).getContext("2d");
        context.drawImage(image, 0, 0);
        const pixels = context.getImageData(0, 0, image.displayWidth, image.displayHeight).data;
        let bytes = "";
        for (let at = 0; at < pixels.length; at += 0x8000) bytes += String.fromCharCode(...pixels.subarray(at, at + 0x8000));
        found.push(btoa(bytes));
      }
      return found;
    },
    [Buffer.from(file).toString("base64"), wanted],
  );
  return texts.map((text) => Buffer.from(text, "base64"));
}

const differing = (a, b) => a.pixels.reduce((sum, word, at) => sum + Number(word !== b.pixels[at]), 0);

test("a moving picture holds the motion, whole and without a seam", { skip }, async () => {
  const how = { width: "200", frames: "16", fps: "20", paths: "coupler.eye", forces: "slot" };
  const { file, period } = await movingPicture(address, how);
  assert.ok(Math.abs(period - 2) < 0.02, `the crank turns once in 2 s, and not in ${period}`);
  const { loops, frames } = await decoded(file, [PURPLE, FORCE]);
  assert.equal(loops, Infinity);
  assert.equal(frames.length, 16);
  for (const [at, { width, height, ms, rim, counts }] of frames.entries()) {
    assert.deepEqual([width, height, ms, rim], [200, 126, 50, 1], `frame ${at}: its size, time, and a rim of one colour`);
    assert.ok(counts[0] > 20, `frame ${at}: the path is drawn`);
  }
  assert.ok(frames.some(({ counts }) => counts[1] > 20), "the arrow of the slot's force is drawn");
  const steps = frames.map((frame, at) => differing(frame, frames[(at + 1) % frames.length]));
  assert.ok(Math.min(...steps) > 20, "each frame differs from the next");
  assert.ok(steps.at(-1) < 2 * Math.max(...steps.slice(0, -1)), `from the last to the first is a step as others are: ${steps}`);
});

test("names that are not there are told, with those that are", { skip }, async () => {
  await assert.rejects(movingPicture(address, { paths: "coupler.nose" }), /no points coupler\.nose; there are .*coupler\.eye/);
  await assert.rejects(movingPicture(address, { forces: "knee" }), /no joints knee; there are .*slot/);
});

test("a page that computes is run as far as it is shown", { skip: skip || withoutLive }, async () => {
  const { file, from, period } = await movingPicture(live, { width: "120", frames: "5", from: "0.5", period: "0.5", scheme: "dark" });
  assert.ok(Math.abs(from - 0.5) < 1e-9 && Math.abs(period - 0.5) < 1e-9, `${from} ${period}`);
  const { frames } = await decoded(file, []);
  assert.ok(differing(frames[0], frames[4]) > 20, "it moves");
});

const program = process.env["PLM_FOUR_BAR"];
const withoutFourBar =
  program !== undefined && existsSync(program) ? false : "skipped: PLM_FOUR_BAR names no program; `cargo build -p plm-program --example four_bar` builds it";

/** Share of the pixels that differ clearly. */
const MOST_DIFFERENT = 0.01;
const EVERY = 23;

for (const { file, options } of HERO) {
  test(`${file} of the README is not stale`, { skip: skip || withoutFourBar }, async () => {
    const folder = mkdtempSync(join(tmpdir(), "plm-hero-"));
    const html = join(folder, "four_bar.html");
    execFileSync(program, ["--view", html]);
    const { raw, tab } = await framesOf(pathToFileURL(html).href, options, EVERY);
    await tab.close();
    const stored = readFileSync(fileURLToPath(new URL(`../../../../docs/src/images/${file}`, import.meta.url)));
    const kept = await pixelsOf(stored, raw.map((_, at) => EVERY * at));
    for (const [at, { data }] of raw.entries()) {
      const before = kept[at];
      assert.equal(before.length, data.length);
      let different = 0;
      for (let k = 0; k < data.length; k += 4) different += Number([0, 1, 2].some((part) => Math.abs(data[k + part] - before[k + part]) > 48));
      assert.ok(different < (MOST_DIFFERENT * data.length) / 4, `frame ${EVERY * at}: ${different} pixels; run \`bash docs/hero.sh\`, and look at what it makes`);
    }
  });
}
