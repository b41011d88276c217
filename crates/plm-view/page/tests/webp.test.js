// Animated WebP without a browser: palette, what changed, and the container.

import assert from "node:assert/strict";
import { test } from "node:test";
import { changedPatch, chunksOf, inPalette, muxWebp, paletteOf } from "../browser/support/webp.js";

/** Pixels of a picture of letters, each a colour. */
const INKS = { ".": [255, 255, 255], a: [200, 30, 30], b: [30, 30, 200], n: [200, 36, 30] };
const picture = (...lines) => ({
  width: lines[0].length,
  height: lines.length,
  data: new Uint8ClampedArray(lines.flatMap((line) => [...line].flatMap((letter) => [...INKS[letter], 255]))),
});

test("colours that are nearly the same become one", () => {
  const frames = [picture("..aa", "..an", "bb..")];
  const palette = paletteOf(frames);
  assert.deepEqual(palette, [INKS["."], INKS.a, INKS.b]);
  assert.deepEqual(inPalette(frames, palette)[0].data, picture("..aa", "..aa", "bb..").data);
});

test("a patch is what changed, at even places", () => {
  const [before, now] = [picture("......", "......", "......", "......"), picture("......", "......", "......", "...a..")];
  const patch = changedPatch(before, now);
  assert.deepEqual([patch.x, patch.y, patch.width, patch.height], [2, 2, 2, 2]);
  assert.deepEqual([...patch.data], [...Array(12).fill(0), ...INKS.a, 255]);
  assert.deepEqual(changedPatch(null, now), { ...now, x: 0, y: 0 });
  const same = changedPatch(now, now);
  assert.deepEqual([same.x, same.y, same.width, same.height, ...same.data], [0, 0, 1, 1, 0, 0, 0, 0]);
});

test("the container holds size, times, places and the coded images", () => {
  const still = (text) => {
    const data = Buffer.from(text);
    const chunk = Buffer.concat([Buffer.from("VP8L"), Buffer.from([data.length, 0, 0, 0]), data, Buffer.alloc(data.length % 2)]);
    return Buffer.concat([Buffer.from("RIFF"), Buffer.from([chunk.length + 4, 0, 0, 0]), Buffer.from("WEBP"), chunk]);
  };
  const file = muxWebp({ width: 300, height: 20 }, [
    { x: 0, y: 0, width: 300, height: 20, ms: 50, webp: still("whole") },
    { x: 258, y: 4, width: 7, height: 9, ms: 300, webp: still("part") },
  ]);
  assert.equal(file.readUInt32LE(4), file.length - 8);
  const [head, animation, ...frames] = chunksOf(file);
  assert.deepEqual([head.name, ...head.data], ["VP8X", 0x12, 0, 0, 0, 43, 1, 0, 19, 0, 0]);
  assert.deepEqual([animation.name, ...animation.data], ["ANIM", 0, 0, 0, 0, 0, 0], "it repeats for ever");
  assert.deepEqual(frames.map(({ name }) => name), ["ANMF", "ANMF"]);
  assert.deepEqual([...frames[1].data.subarray(0, 16)], [129, 0, 0, 2, 0, 0, 6, 0, 0, 8, 0, 0, 44, 1, 0, 0]);
  assert.deepEqual(frames.map(({ data }) => chunksOf(data, 16).map(({ name, data: coded }) => [name, coded.toString()])), [
    [["VP8L", "whole"]],
    [["VP8L", "part"]],
  ]);
  const odd = { x: 1, y: 0, width: 1, height: 1, ms: 50, webp: still("x") };
  assert.throws(() => muxWebp({ width: 9, height: 9 }, [odd]), /even/);
});
