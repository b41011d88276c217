// Reads zip archives. Of a truncated one, what is whole is still given.

/** @typedef {{name: string, bytes: Uint8Array, whole: boolean}} ZipEntry */
/** @typedef {{name: string, method: number, start: number, size: number, full: number, crc: number}} ZipPlace */

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const DESCRIPTOR = 0x08074b50;
/** What stands in the place of a size that needs 64 bits. */
const LARGE = 0xffffffff;
/** Bytes that an archive may unpack to: a few packed ones can stand for more than a page has memory for. */
const MOST_UNPACKED = 2 ** 30;

/**
 * @param {Uint8Array} bytes
 * @returns {Promise<{entries: ZipEntry[], warnings: string[]}>}
 * @throws {Error} if the bytes are no zip archive, or of one that unpacks to more than there may be
 */
export async function readZip(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 4 || (view.getUint32(0, true) !== LOCAL && view.getUint32(0, true) !== END)) {
    throw new Error(
      "this is not a results file: it does not begin like a zip archive (.npz). Results files are written by plm-view.",
    );
  }
  const warnings = [];
  let places = centralPlaces(view);
  if (places === null) {
    warnings.push("The file is truncated: its table of contents is missing. What is whole is shown.");
    places = localPlaces(view);
  }
  const entries = [];
  let left = MOST_UNPACKED;
  for (const place of places) {
    const entry = await entryAt(bytes, place, left);
    left -= entry.bytes.length;
    if (!entry.whole) warnings.push(`${place.name} is damaged or cut off.`);
    entries.push(entry);
  }
  return { entries, warnings };
}

/**
 * The entries as the table of contents at the end of the archive names them; null where there is none.
 * @param {DataView} view
 * @returns {ZipPlace[] | null}
 */
function centralPlaces(view) {
  let end = view.byteLength - 22;
  const lowest = Math.max(0, end - 0xffff);
  while (end >= lowest && view.getUint32(end, true) !== END) end--;
  if (end < lowest) return null;
  const places = [];
  let at = view.getUint32(end + 16, true);
  for (let left = view.getUint16(end + 10, true); left > 0; left--) {
    if (at + 46 > view.byteLength || view.getUint32(at, true) !== CENTRAL) return null;
    const place = placeOf(view, at + 10, at + 28, at + 46);
    const local = view.getUint32(at + 42, true);
    if (local + 30 > view.byteLength) return null;
    place.start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    places.push(place);
    at += 46 + view.getUint16(at + 28, true) + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
  }
  return places;
}

/**
 * The entries as they follow one another, for an archive that was cut off.
 * @param {DataView} view
 * @returns {ZipPlace[]}
 */
function localPlaces(view) {
  const places = [];
  let at = 0;
  while (at + 30 <= view.byteLength && view.getUint32(at, true) === LOCAL) {
    const nameAt = at + 30;
    const extraAt = nameAt + view.getUint16(at + 26, true);
    const start = extraAt + view.getUint16(at + 28, true);
    if (start > view.byteLength) break;
    const place = placeOf(view, at + 8, at + 26, nameAt);
    place.start = start;
    const isStreamed = (view.getUint16(at + 6, true) & 8) !== 0;
    if (isStreamed) {
      [place.size, place.full, place.crc] = [nextSignature(view, start) - start, -1, -1];
    }
    places.push(place);
    at = isStreamed ? nextLocal(view, start + place.size) : start + place.size;
  }
  return places;
}

/**
 * What a header says, wherever it stands: method, check sum and sizes; then lengths of name and extra field; then these.
 * @param {DataView} view
 * @param {number} methodAt
 * @param {number} lengthsAt
 * @param {number} nameAt
 * @returns {ZipPlace}
 */
function placeOf(view, methodAt, lengthsAt, nameAt) {
  const length = view.getUint16(lengthsAt, true);
  const name = new TextDecoder().decode(new Uint8Array(view.buffer, view.byteOffset + nameAt, length));
  const place = {
    name,
    method: view.getUint16(methodAt, true),
    start: 0,
    crc: view.getUint32(methodAt + 6, true),
    size: view.getUint32(methodAt + 10, true),
    full: view.getUint32(methodAt + 14, true),
  };
  readLargeSizes(view, nameAt + length, view.getUint16(lengthsAt + 2, true), place);
  return place;
}

/**
 * Sizes of 64 bits stand in an extra field of number 1, the full size first, each only if it is marked.
 * @param {DataView} view
 * @param {number} at
 * @param {number} length
 * @param {ZipPlace} place
 */
function readLargeSizes(view, at, length, place) {
  const end = Math.min(at + length, view.byteLength);
  for (let field = at; field + 4 <= end; field += 4 + view.getUint16(field + 2, true)) {
    if (view.getUint16(field, true) !== 1) continue;
    let value = field + 4;
    for (const size of /** @type {const} */ (["full", "size"])) {
      if (place[size] === LARGE && value + 8 <= end) {
        place[size] = Number(view.getBigUint64(value, true));
        value += 8;
      }
    }
  }
}

/**
 * @param {DataView} view
 * @param {number} from
 */
function nextSignature(view, from) {
  for (let at = from; at + 4 <= view.byteLength; at++) {
    if (view.getUint8(at) !== 0x50) continue;
    const word = view.getUint32(at, true);
    if (word === LOCAL || word === DESCRIPTOR || word === CENTRAL) return at;
  }
  return view.byteLength;
}

/**
 * @param {DataView} view
 * @param {number} from
 */
function nextLocal(view, from) {
  let at = nextSignature(view, from);
  while (at + 4 <= view.byteLength && view.getUint32(at, true) === DESCRIPTOR) at = nextSignature(view, at + 4);
  return at;
}

/**
 * @param {Uint8Array} bytes
 * @param {ZipPlace} place
 * @param {number} most bytes that it may unpack to
 * @returns {Promise<ZipEntry>}
 */
async function entryAt(bytes, place, most) {
  const packed = bytes.subarray(place.start, place.start + place.size);
  const { name } = place;
  if (place.method !== 0 && place.method !== 8) return { name, bytes: new Uint8Array(0), whole: false };
  if (place.full > most) throw new Error(TOO_LARGE_UNPACKED);
  const unpacked = place.method === 8 ? await inflated(packed, most) : packed;
  const isComplete = place.full < 0 || unpacked.length === place.full;
  const whole = isComplete && (place.crc < 0 || checkSum(unpacked) === place.crc);
  return { name, bytes: unpacked, whole };
}

const TOO_LARGE_UNPACKED = "the file unpacks to more than 1 GB, for which a page has no memory";

/**
 * All that can be unpacked; a stream that is cut off gives its beginning.
 * @param {Uint8Array} packed
 * @param {number} [most] bytes that it may unpack to
 * @throws {Error} where it unpacks to more
 */
export async function inflated(packed, most = MOST_UNPACKED) {
  const stream = new Blob([/** @type {Uint8Array<ArrayBuffer>} */ (packed)])
    .stream()
    .pipeThrough(new DecompressionStream("deflate-raw"));
  const reader = stream.getReader();
  const chunks = [];
  let length = 0;
  try {
    for (let part = await reader.read(); !part.done && length <= most; part = await reader.read()) {
      chunks.push(part.value);
      length += part.value.length;
    }
  } catch {
    // What came before is kept, and the length tells that something is missing.
  }
  if (length > most) {
    await reader.cancel();
    throw new Error(TOO_LARGE_UNPACKED);
  }
  const out = new Uint8Array(length);
  let at = 0;
  for (const chunk of chunks) {
    out.set(chunk, at);
    at += chunk.length;
  }
  return out;
}

/** @type {Uint32Array | null} */
let checkTable = null;

/**
 * CRC-32 of ISO-HDLC, as zip has it.
 * @param {Uint8Array} bytes
 */
export function checkSum(bytes) {
  if (checkTable === null) {
    checkTable = new Uint32Array(256);
    for (let byte = 0; byte < 256; byte++) {
      let value = byte;
      for (let bit = 0; bit < 8; bit++) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
      checkTable[byte] = value;
    }
  }
  let sum = 0xffffffff;
  for (let at = 0; at < bytes.length; at++) sum = (sum >>> 8) ^ checkTable[(sum ^ bytes[at]) & 255];
  return (sum ^ 0xffffffff) >>> 0;
}
