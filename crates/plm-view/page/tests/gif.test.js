// GIF files, read by a decoder of the tests' own.

import assert from "node:assert/strict";
import { test } from "node:test";
import { GifEncoder, PaletteMaker } from "../src/gif.js";
import { filmOf } from "../src/movie.js";
import { readGif } from "./support/gif.js";

/** Numbers that come back, without a pattern. */
function noise(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state >>> 8;
  };
}

/** `0xRRGGBB` of a pixel as ImageData has it. */
const seen = (pixel) => ((pixel & 255) << 16) | (pixel & 0xff00) | ((pixel >> 16) & 255);

const encode = (width, height, frames, delays = frames.map(() => 4)) => {
  const maker = new PaletteMaker();
  for (const frame of frames) maker.add(frame);
  const gif = new GifEncoder(width, height, maker.finish());
  frames.forEach((frame, at) => gif.addFrame(frame, delays[at]));
  return readGif(gif.finish());
};

test("pictures of up to 255 colours come back pixel by pixel", () => {
  const next = noise(7);
  const colours = Array.from({ length: 255 }, () => 0xff000000 + next() * 1);
  // Noise fills the table of codes many times over; flat pictures and small ones end it early.
  for (const [width, height, pick] of [
    [200, 150, () => colours[next() % 255]],
    [200, 150, () => colours[next() % 3]],
    [64, 64, () => colours[0]],
    [1, 1, () => colours[1]],
    [3, 1, () => colours[next() % 255]],
  ]) {
    const frames = Array.from({ length: 3 }, () => Uint32Array.from({ length: width * height }, pick));
    const gif = encode(width, height, frames);
    assert.deepEqual([gif.signature, gif.width, gif.height, gif.repeats], ["GIF89a", width, height, 0]);
    assert.equal(gif.frames.length, 3);
    gif.frames.forEach(({ pixels }, at) => assert.deepEqual(pixels, Array.from(frames[at], seen)));
  }
});

test("every length of data ends where it should", () => {
  // The size of codes changes at 512, 1024 and 2048 codes, and the table begins anew at 4096.
  const next = noise(3);
  const data = Uint32Array.from({ length: 4200 }, () => 0xff000000 + (next() % 255));
  for (let length = 240; length < 4200; length += length % 250 < 240 && length % 250 > 20 ? 97 : 1) {
    const gif = encode(length, 1, [data.subarray(0, length)]);
    assert.deepEqual(gif.frames[0].pixels, Array.from(data.subarray(0, length), seen), `${length} pixels`);
  }
});

test("what does not change is not written again", () => {
  const still = new Uint32Array(60 * 40).fill(0xff332211);
  const moved = still.slice();
  for (let at = 0; at < 5; at++) moved[20 * 60 + 10 + at] = 0xff0000ff;
  const gif = encode(60, 40, [still, moved, moved], [4, 5, 4]);
  assert.deepEqual(gif.frames.map(({ box }) => box), [[0, 0, 60, 40], [10, 20, 5, 1], [0, 0, 1, 1]]);
  assert.deepEqual(gif.frames.map(({ delay }) => delay), [4, 5, 4]);
  assert.deepEqual(gif.frames[2].pixels, Array.from(moved, seen));
});

test("of too many colours the frequent ones stay, and the others are near", () => {
  const shades = Uint32Array.from({ length: 256 * 64 }, (_, at) => 0xff000000 + (at % 256) * 0x10000 + ((at >> 8) * 4) * 0x100);
  const flat = new Uint32Array(shades.length).fill(0xff123456);
  const gif = encode(256, 64, [flat, shades]);
  assert.ok(gif.frames[0].pixels.every((colour) => colour === 0x563412));
  gif.frames[1].pixels.forEach((colour, at) => {
    const far = [0, 8, 16].map((shift) => Math.abs(((colour >> shift) & 255) - ((seen(shades[at]) >> shift) & 255)));
    assert.ok(Math.max(...far) <= 32, `${at}: ${far}`);
  });
});

test("a film has the frames of its stretch, at the speed of the page", () => {
  const turn = filmOf({ from: 1, to: 3 }, 0.5, 25, true);
  assert.equal(turn.times.length, 100);
  assert.deepEqual([turn.times[0], turn.times[50], turn.rate], [1, 2, 25]);
  const run = filmOf({ from: 0, to: 4 }, 1, 25, false);
  assert.deepEqual([run.times.length, run.times.at(-1)], [101, 4]);
  // An hour is no film of 90000 frames; it lasts as long.
  const long = filmOf({ from: 0, to: 3600 }, 1, 25, false);
  assert.equal(long.times.length, 901);
  assert.ok(Math.abs(long.rate - 0.25) < 1e-12);
});
