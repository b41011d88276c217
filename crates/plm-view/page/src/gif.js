// GIF: pictures of few colours, packed by LZW, one after another. Of each the part alone is written that differs from the one before.

/** Colours of a palette; the last one stands for pixels that stay as they are. */
const COLOURS = 256;
const UNCHANGED = COLOURS - 1;
/** Codes have 12 bits at most. */
const MOST_CODES = 4096;
/** So many of the most frequent colours are kept as they are, however near they are to one another. */
const EXACT = 64;
const GIF_CLEAR = COLOURS;
const GIF_END = COLOURS + 1;

/** Bytes that become more. */
class ByteList {
  constructor() {
    this.bytes = new Uint8Array(1 << 16);
    this.length = 0;
  }

  /** @param {...number} bytes */
  push(...bytes) {
    if (this.length + bytes.length > this.bytes.length) {
      const larger = new Uint8Array(2 * this.bytes.length);
      larger.set(this.bytes);
      this.bytes = larger;
    }
    for (const byte of bytes) this.bytes[this.length++] = byte;
  }

  /** Numbers of 16 bits, the low byte first. @param {...number} words */
  words(...words) {
    for (const word of words) this.push(word & 255, word >> 8);
  }
}

/** The colours that pictures have most of: at most 255, each `0xBBGGRR`. */
export class PaletteMaker {
  constructor() {
    /** How often each colour occurs. @type {Map<number, number>} */
    this.counts = new Map();
  }

  /** @param {Uint32Array} pixels as ImageData has them */
  add(pixels) {
    let [last, run] = [-1, 0];
    const count = () => this.counts.set(last, (this.counts.get(last) ?? 0) + run);
    for (let at = 0; at < pixels.length; at++) {
      const colour = pixels[at] & 0xffffff;
      if (colour !== last) {
        if (run > 0) count();
        [last, run] = [colour, 0];
      }
      run += 1;
    }
    if (run > 0) count();
  }

  /** After the first ones, the most frequent of colours that are hardly different stands for all. @returns {number[]} */
  finish() {
    const falling = [...this.counts].sort((a, b) => b[1] - a[1]);
    // Coarser steps until they are few enough.
    for (let step = 1; ; step *= 2) {
      /** @type {Map<number, number>} */
      const kept = new Map();
      falling.forEach(([colour], rank) => {
        const cell = ((colour & 255) / step) | ((((colour >> 8) & 255) / step) << 8) | (((colour >> 16) / step) << 16);
        if (rank < EXACT) kept.set(-1 - colour, colour);
        else if (!kept.has(cell)) kept.set(cell, colour);
      });
      if (kept.size <= UNCHANGED) return [...kept.values()];
    }
  }
}

export class GifEncoder {
  /**
   * @param {number} width
   * @param {number} height
   * @param {number[]} palette as `PaletteMaker` gives it
   */
  constructor(width, height, palette) {
    this.width = width;
    this.height = height;
    this.palette = palette;
    this.out = new ByteList();
    /** The nearest colour of the palette. @type {Map<number, number>} */
    this.nearest = new Map(palette.map((colour, at) => [colour, at]));
    this.before = new Uint8Array(0);
    this.out.push(...new TextEncoder().encode("GIF89a"));
    this.out.words(width, height);
    this.out.push(0xf7, 0, 0);
    for (let at = 0; at < COLOURS; at++) {
      const colour = palette[at] ?? 0;
      this.out.push(colour & 255, (colour >> 8) & 255, colour >> 16);
    }
    // It is shown again and again.
    this.out.push(0x21, 0xff, 11, ...new TextEncoder().encode("NETSCAPE2.0"), 3, 1, 0, 0, 0);
  }

  /** Bytes up to now. */
  get length() {
    return this.out.length;
  }

  /**
   * @param {Uint32Array} pixels as ImageData has them
   * @param {number} delay hundredths of a second
   */
  addFrame(pixels, delay) {
    const { width, height, before, out } = this;
    const now = new Uint8Array(width * height);
    let [last, index] = [-1, 0];
    for (let at = 0; at < now.length; at++) {
      if (pixels[at] !== last) {
        last = pixels[at];
        index = this.indexOf(last & 0xffffff);
      }
      now[at] = index;
    }
    const box = changedBox(before, now, width, height);
    const part = new Uint8Array(box.width * box.height);
    for (let row = 0; row < box.height; row++) {
      for (let column = 0; column < box.width; column++) {
        const at = (box.y + row) * width + box.x + column;
        part[row * box.width + column] = before.length > 0 && before[at] === now[at] ? UNCHANGED : now[at];
      }
    }
    this.before = now;
    out.push(0x21, 0xf9, 4, 5);
    out.words(delay);
    out.push(UNCHANGED, 0, 0x2c);
    out.words(box.x, box.y, box.width, box.height);
    out.push(0, 8);
    packLzw(part, out);
  }

  /** @param {number} colour */
  indexOf(colour) {
    const known = this.nearest.get(colour);
    if (known !== undefined) return known;
    const part = (/** @type {number} */ of, /** @type {number} */ shift) => (of >> shift) & 255;
    const distance = (/** @type {number} */ other) =>
      [0, 8, 16].reduce((sum, shift) => sum + (part(colour, shift) - part(other, shift)) ** 2, 0);
    let [best, least] = [0, Infinity];
    this.palette.forEach((other, at) => {
      const size = distance(other);
      if (size < least) [best, least] = [at, size];
    });
    this.nearest.set(colour, best);
    return best;
  }

  finish() {
    this.out.push(0x3b);
    return this.out.bytes.slice(0, this.out.length);
  }
}

/**
 * What holds all pixels that differ; one pixel where none does.
 * @param {Uint8Array} before
 * @param {Uint8Array} now
 * @param {number} width
 * @param {number} height
 */
function changedBox(before, now, width, height) {
  if (before.length === 0) return { x: 0, y: 0, width, height };
  let [left, right, top, bottom] = [width, -1, height, -1];
  for (let at = 0; at < now.length; at++) {
    if (before[at] === now[at]) continue;
    const [x, y] = [at % width, (at / width) | 0];
    if (x < left) left = x;
    if (x > right) right = x;
    if (y < top) top = y;
    bottom = y;
  }
  if (right < 0) return { x: 0, y: 0, width: 1, height: 1 };
  return { x: left, y: top, width: right - left + 1, height: bottom - top + 1 };
}

/**
 * LZW with codes of 9 to 12 bits, in blocks of up to 255 bytes.
 * @param {Uint8Array} data
 * @param {ByteList} out
 */
function packLzw(data, out) {
  /** The code of a known sequence and one byte more; 0: none. */
  const codes = new Uint16Array(MOST_CODES * COLOURS);
  let [next, size, bits, waiting] = [GIF_END + 1, 9, 0, 0];
  /** @type {number[]} */
  let block = [];
  const flush = () => {
    if (block.length > 0) out.push(block.length, ...block);
    block = [];
  };
  const put = (/** @type {number} */ code) => {
    waiting |= code << bits;
    bits += size;
    while (bits >= 8) {
      block.push(waiting & 255);
      if (block.length === 255) flush();
      waiting >>>= 8;
      bits -= 8;
    }
  };
  put(GIF_CLEAR);
  let prefix = data[0];
  for (let at = 1; at < data.length; at++) {
    const entry = prefix * COLOURS + data[at];
    if (codes[entry] !== 0) {
      prefix = codes[entry];
      continue;
    }
    put(prefix);
    prefix = data[at];
    if (next < MOST_CODES) {
      // The reader knows a code one step later than the writer.
      if (next === 1 << size) size += 1;
      codes[entry] = next++;
    } else {
      put(GIF_CLEAR);
      codes.fill(0);
      [next, size] = [GIF_END + 1, 9];
    }
  }
  put(prefix);
  if (next === 1 << size && size < 12) size += 1;
  put(GIF_END);
  if (bits > 0) block.push(waiting & 255);
  flush();
  out.push(0);
}
