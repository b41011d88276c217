// Reads GIF files as the format is documented, for tests: nothing of the page is used.

/**
 * All frames as they are seen, one colour `0xRRGGBB` a pixel.
 * @param {Uint8Array} bytes
 */
export function readGif(bytes) {
  const word = (at) => bytes[at] | (bytes[at + 1] << 8);
  const [width, height, flags] = [word(6), word(8), bytes[10]];
  const signature = Buffer.from(bytes.subarray(0, 6)).toString("latin1");
  const colours = Array.from({ length: 2 << (flags & 7) }, (_, at) => (bytes[13 + 3 * at] << 16) | (bytes[14 + 3 * at] << 8) | bytes[15 + 3 * at]);
  let at = 13 + 3 * colours.length;
  const screen = new Array(width * height).fill(null);
  const gif = { signature, width, height, repeats: null, frames: [] };
  let control = { delay: 0, transparent: -1 };
  const blocks = () => {
    const data = [];
    while (bytes[at] !== 0) {
      data.push(...bytes.subarray(at + 1, at + 1 + bytes[at]));
      at += bytes[at] + 1;
    }
    at += 1;
    return data;
  };
  while (bytes[at] !== 0x3b) {
    if (bytes[at] === 0x21) {
      const label = bytes[at + 1];
      at += 2;
      const data = blocks();
      if (label === 0xf9) control = { delay: data[1] | (data[2] << 8), transparent: data[0] & 1 ? data[3] : -1 };
      if (label === 0xff) gif.repeats = data[12] | (data[13] << 8);
    } else if (bytes[at] === 0x2c) {
      const [x, y, w, h] = [word(at + 1), word(at + 3), word(at + 5), word(at + 7)];
      if (bytes[at + 9] !== 0) throw new Error("a palette of its own, or interlaced");
      const least = bytes[at + 10];
      at += 11;
      const pixels = unpack(blocks(), least);
      if (pixels.length !== w * h || x + w > width || y + h > height) throw new Error(`${pixels.length} pixels of ${w} by ${h} at ${x} ${y}`);
      pixels.forEach((index, pixel) => {
        if (index !== control.transparent) screen[(y + Math.floor(pixel / w)) * width + x + (pixel % w)] = colours[index];
      });
      gif.frames.push({ delay: control.delay, box: [x, y, w, h], pixels: [...screen] });
    } else throw new Error(`byte ${bytes[at]} at ${at}`);
  }
  if (at !== bytes.length - 1) throw new Error("something stands after the end");
  return gif;
}

/** LZW of the format's appendix F. */
function unpack(data, least) {
  const [clear, end] = [1 << least, (1 << least) + 1];
  let [table, size, bits, waiting, before, at] = [[], least + 1, 0, 0, null, 0];
  const out = [];
  const reset = () => {
    table = Array.from({ length: end + 1 }, (_, code) => (code < clear ? [code] : []));
    [size, before] = [least + 1, null];
  };
  reset();
  for (;;) {
    while (bits < size) {
      if (at >= data.length) throw new Error("the codes end without an end code");
      waiting |= data[at++] << bits;
      bits += 8;
    }
    const code = waiting & ((1 << size) - 1);
    waiting >>>= size;
    bits -= size;
    if (code === end) return out;
    if (code === clear) {
      reset();
      continue;
    }
    if (code > table.length || (code === table.length && before === null)) throw new Error(`code ${code} of ${table.length}`);
    const entry = code < table.length ? table[code] : [...before, before[0]];
    for (const index of entry) out.push(index);
    if (before !== null && table.length < 4096) table.push([...before, entry[0]]);
    if (table.length === 1 << size && size < 12) size += 1;
    before = entry;
  }
}
