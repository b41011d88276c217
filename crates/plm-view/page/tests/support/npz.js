// Writes results files as the format is documented, for tests: nothing of the page is used.

import { crc32, deflateRawSync } from "node:zlib";

/**
 * A zip archive. `how`: "stored" or "deflated"; `streamed` leaves sizes to descriptors after the data; `large` marks
 * sizes as of 64 bits in the local headers, as NumPy does.
 * @param {[string, Uint8Array][]} files
 */
export function makeZip(files, { how = "stored", streamed = false, large = false } = {}) {
  const parts = [];
  const directory = [];
  let at = 0;
  const add = (bytes) => {
    parts.push(bytes);
    at += bytes.length;
  };
  for (const [name, bytes] of files) {
    const title = Buffer.from(name);
    const data = how === "deflated" ? deflateRawSync(bytes) : Buffer.from(bytes);
    const [method, flags, sum] = [how === "deflated" ? 8 : 0, streamed ? 8 : 0, crc32(bytes)];
    const start = at;
    const extra = large ? Buffer.concat([u16(1, 16), u64(bytes.length, data.length)]) : Buffer.alloc(0);
    const sizes = streamed ? [0, 0, 0] : large ? [sum, 0xffffffff, 0xffffffff] : [sum, data.length, bytes.length];
    add(Buffer.concat([u32(0x04034b50), u16(45, flags, method, 0, 0), u32(...sizes), u16(title.length, extra.length), title, extra]));
    add(data);
    if (streamed) add(u32(0x08074b50, sum, data.length, bytes.length));
    directory.push(
      Buffer.concat([
        u32(0x02014b50),
        u16(45, 45, flags, method, 0, 0),
        u32(sum, data.length, bytes.length),
        u16(title.length, 0, 0, 0, 0),
        u32(0, start),
        title,
      ]),
    );
  }
  const central = Buffer.concat(directory);
  const end = Buffer.concat([u32(0x06054b50), u16(0, 0, files.length, files.length), u32(central.length, at), u16(0)]);
  return Buffer.concat([...parts, central, end]);
}

/** An array of NumPy, `<f8` or `<f4`. */
export function makeNpy(shape, numbers, type = "<f8") {
  const text = `{'descr': '${type}', 'fortran_order': False, 'shape': (${shape.join(", ")}${shape.length === 1 ? "," : ""}), }`;
  const header = text.padEnd(128 - 10 - 1 + 64 * Math.ceil(Math.max(0, text.length - 117) / 64)) + "\n";
  const data = type === "<f4" ? Float32Array.from(numbers) : Float64Array.from(numbers);
  return Buffer.concat([
    Buffer.from([0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59, 1, 0]),
    u16(header.length),
    Buffer.from(header),
    Buffer.from(data.buffer),
  ]);
}

/**
 * A results file of runs as `scenes.js` makes them.
 * @param {{head: any, time: number[], poses: number[], values: number[], ground?: number[]}[]} runs
 */
export function makeNpz(runs, options = {}) {
  return makeZip(resultsFiles(runs, options), options);
}

export function resultsFiles(runs, { type = "<f8" } = {}) {
  const contents = { format: "plm results", version: 1, made_by: "plm test", runs: runs.map(({ head }) => head) };
  const files = [["plm.json", Buffer.from(JSON.stringify(contents))]];
  runs.forEach(({ head, time, poses, values, ground }, index) => {
    const rows = time.length;
    files.push([`${index}/time.npy`, makeNpy([rows], time, type)]);
    files.push([`${index}/poses.npy`, makeNpy([rows, head.mechanism.bodies.length, 6], poses, type)]);
    files.push([`${index}/values.npy`, makeNpy([rows, head.columns.length], values, type)]);
    if (ground !== undefined) files.push([`${index}/ground.npy`, makeNpy([rows, head.mechanism.ground.length, 3], ground, type)]);
  });
  return files;
}

function u16(...numbers) {
  const bytes = Buffer.alloc(2 * numbers.length);
  numbers.forEach((number, at) => bytes.writeUInt16LE(number, 2 * at));
  return bytes;
}

function u32(...numbers) {
  const bytes = Buffer.alloc(4 * numbers.length);
  numbers.forEach((number, at) => bytes.writeUInt32LE(number >>> 0, 4 * at));
  return bytes;
}

function u64(...numbers) {
  const bytes = Buffer.alloc(8 * numbers.length);
  numbers.forEach((number, at) => bytes.writeBigUInt64LE(BigInt(number), 8 * at));
  return bytes;
}
