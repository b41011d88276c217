// Animated WebP: frames are reduced to a common palette, each to what changed since the one before, and muxed.
//
// The coding of a single frame is the browser's (`canvas.toBlob`); this writes the container around it.

/** @typedef {{width: number, height: number, data: Uint8ClampedArray | Uint8Array}} Pixels RGBA, row by row */
/** @typedef {Pixels & {x: number, y: number}} Patch */

/** Colours of an animation at most: a palette of them leaves one for "unchanged". */
const MOST_COLOURS = 200;
/** Colours nearer than this (a sum over the channels) are merged. */
const MERGED = 18;

/**
 * The most frequent colours of all frames, none near another.
 * @param {Pixels[]} frames
 * @returns {number[][]}
 */
export function paletteOf(frames) {
  /** @type {Map<number, number>} */
  const counts = new Map();
  for (const { data } of frames) {
    for (let at = 0; at < data.length; at += 4) {
      const key = (data[at] << 16) | (data[at + 1] << 8) | data[at + 2];
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
  }
  /** @type {number[][]} */
  const chosen = [];
  for (const [key] of [...counts].sort((a, b) => b[1] - a[1])) {
    const rgb = [key >> 16, (key >> 8) & 255, key & 255];
    if (chosen.every((other) => distance(other, rgb) > MERGED)) chosen.push(rgb);
    if (chosen.length === MOST_COLOURS) break;
  }
  return chosen;
}

const distance = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
  Math.abs(a[0] - b[0]) + Math.abs(a[1] - b[1]) + Math.abs(a[2] - b[2]);

/**
 * Frames in the colours of a palette alone, opaque.
 * @param {Pixels[]} frames
 * @param {number[][]} palette
 * @returns {Pixels[]}
 */
export function inPalette(frames, palette) {
  /** @type {Map<number, number[]>} */
  const nearest = new Map();
  const find = (/** @type {number} */ key) => {
    const rgb = [key >> 16, (key >> 8) & 255, key & 255];
    return palette.reduce((best, other) => (distance(other, rgb) < distance(best, rgb) ? other : best));
  };
  return frames.map(({ width, height, data }) => {
    const out = new Uint8ClampedArray(data.length);
    for (let at = 0; at < data.length; at += 4) {
      const key = (data[at] << 16) | (data[at + 1] << 8) | data[at + 2];
      let rgb = nearest.get(key);
      if (rgb === undefined) nearest.set(key, (rgb = find(key)));
      [out[at], out[at + 1], out[at + 2], out[at + 3]] = [rgb[0], rgb[1], rgb[2], 255];
    }
    return { width, height, data: out };
  });
}

/**
 * What changed since the frame before, as the smallest rectangle at even places; what did not change is transparent in it.
 * @param {Pixels | null} before null for the first frame, which is whole
 * @param {Pixels} now
 * @returns {Patch}
 */
export function changedPatch(before, now) {
  const { width, height, data } = now;
  if (before === null) return { ...now, x: 0, y: 0 };
  let [left, right, top, bottom] = [width, -1, height, -1];
  const isSame = (/** @type {number} */ at) =>
    data[at] === before.data[at] && data[at + 1] === before.data[at + 1] && data[at + 2] === before.data[at + 2];
  for (let y = 0, at = 0; y < height; y++) {
    for (let x = 0; x < width; x++, at += 4) {
      if (isSame(at)) continue;
      [left, right] = [Math.min(left, x), Math.max(right, x)];
      [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
    }
  }
  // A frame has at least one pixel, and the format counts places by twos.
  if (right < 0) [left, right, top, bottom] = [0, 0, 0, 0];
  [left, top] = [left & ~1, top & ~1];
  const [w, h] = [right - left + 1, bottom - top + 1];
  const out = new Uint8ClampedArray(4 * w * h);
  for (let y = 0; y < h; y++) {
    for (let x = 0; x < w; x++) {
      const from = 4 * ((top + y) * width + left + x);
      if (!isSame(from)) out.set(data.subarray(from, from + 4), 4 * (y * w + x));
    }
  }
  return { x: left, y: top, width: w, height: h, data: out };
}

/**
 * The file of an animation that repeats for ever.
 * @param {{width: number, height: number}} size
 * @param {{x: number, y: number, width: number, height: number, ms: number, webp: Uint8Array}[]} frames each over the one
 *   before, as a WebP file of its own
 */
export function muxWebp({ width, height }, frames) {
  // Flags: animation, alpha.
  const head = Buffer.concat([Buffer.from([0x12, 0, 0, 0]), u24(width - 1), u24(height - 1)]);
  const animation = Buffer.from([0, 0, 0, 0, 0, 0]);
  const body = frames.map((frame) => {
    if (frame.x % 2 !== 0 || frame.y % 2 !== 0) throw new Error("frames begin at even places");
    const place = [u24(frame.x / 2), u24(frame.y / 2), u24(frame.width - 1), u24(frame.height - 1), u24(frame.ms)];
    return chunk("ANMF", Buffer.concat([...place, Buffer.from([0]), ...imageChunks(frame.webp)]));
  });
  const content = Buffer.concat([Buffer.from("WEBP"), chunk("VP8X", head), chunk("ANIM", animation), ...body]);
  return chunk("RIFF", content);
}

/** What codes the image of a still WebP file: `VP8L`, or `VP8 ` after its `ALPH`. @param {Uint8Array} webp */
function imageChunks(webp) {
  const found = chunksOf(webp).filter(({ name }) => ["ALPH", "VP8 ", "VP8L"].includes(name));
  if (found.length === 0) throw new Error("no WebP image");
  return found.map(({ name, data }) => chunk(name, data));
}

/**
 * The chunks of a WebP file, or those within one.
 * @param {Uint8Array} bytes
 * @param {number} [at] after the header
 */
export function chunksOf(bytes, at = 12) {
  const all = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const found = [];
  while (at + 8 <= all.length) {
    const length = all.readUInt32LE(at + 4);
    found.push({ name: all.toString("latin1", at, at + 4), data: all.subarray(at + 8, at + 8 + length) });
    at += 8 + length + (length % 2);
  }
  return found;
}

/** @param {string} name @param {Uint8Array} data */
function chunk(name, data) {
  const head = Buffer.alloc(8);
  head.write(name, "latin1");
  head.writeUInt32LE(data.length, 4);
  return Buffer.concat([head, data, Buffer.alloc(data.length % 2)]);
}

/** @param {number} value */
function u24(value) {
  return Buffer.from([value & 255, (value >> 8) & 255, (value >> 16) & 255]);
}
