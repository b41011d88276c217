// Reads arrays of NumPy (.npy), format versions 1 to 3.

/** @typedef {{shape: number[], data: Float64Array | Float32Array, whole: boolean}} NpyArray */

/** How each type of NumPy becomes numbers. */
const NPY_TYPES = /** @type {const} */ ({ "<f8": Float64Array, "<f4": Float32Array });

/**
 * An array of floating-point numbers in C order. If it is cut off, the rows that are whole are given.
 * @param {Uint8Array} bytes
 * @param {string} name for messages
 * @returns {NpyArray}
 * @throws {Error} if it is no such array
 */
export function readNpy(bytes, name) {
  const { header, start } = npyHeader(bytes, name);
  const type = /'descr':\s*'([^']*)'/.exec(header)?.[1] ?? "";
  if (type !== "<f8" && type !== "<f4") {
    throw new Error(`${name} holds numbers of type "${type}"; results hold "<f8" or "<f4"`);
  }
  if (!/'fortran_order':\s*False/.test(header)) throw new Error(`${name} is not in C order`);
  const shape = (/'shape':\s*\(([^)]*)\)/.exec(header)?.[1] ?? "").split(",").map((size) => size.trim());
  const sizes = shape.filter((size) => size !== "").map(Number);
  if (sizes.length === 0 || sizes.some((size) => !Number.isInteger(size) || size < 0)) {
    throw new Error(`${name} has no shape that can be read`);
  }
  const Numbers = NPY_TYPES[type];
  const width = sizes.slice(1).reduce((product, size) => product * size, 1);
  const bytesOfRow = width * Numbers.BYTES_PER_ELEMENT;
  const there = bytesOfRow === 0 ? sizes[0] : Math.floor((bytes.length - start) / bytesOfRow);
  const rows = Math.min(sizes[0], there);
  // A copy, because the numbers of an archive stand at any byte.
  const data = new Numbers(bytes.slice(start, start + rows * bytesOfRow).buffer);
  return { shape: [rows, ...sizes.slice(1)], data, whole: rows === sizes[0] };
}

/**
 * @param {Uint8Array} bytes
 * @param {string} name
 */
function npyHeader(bytes, name) {
  const magic = [0x93, ...[..."NUMPY"].map((letter) => letter.charCodeAt(0))];
  if (bytes.length < 12 || magic.some((byte, at) => bytes[at] !== byte)) {
    throw new Error(`${name} does not begin like an array of NumPy`);
  }
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [at, length] = bytes[6] === 1 ? [10, view.getUint16(8, true)] : [12, view.getUint32(8, true)];
  if (at + length > bytes.length) throw new Error(`${name} is cut off in its header`);
  return { header: new TextDecoder().decode(bytes.subarray(at, at + length)), start: at + length };
}
