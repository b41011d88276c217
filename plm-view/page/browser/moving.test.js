// Moving pictures of pages: what the browser decodes is what the page shows, nothing is cut off, and the loop has no seam.

import assert from "node:assert/strict";
import { test } from "node:test";
import { workshop } from "../tests/support/scenes.js";
import { movingPicture } from "./moving.js";
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
