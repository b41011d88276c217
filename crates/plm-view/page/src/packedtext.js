// A declaration in the address of a page: deflated, in the letters that addresses may have.

import { deflated } from "./write.js";
import { inflated } from "./zip.js";

/** A longer one is no link to a declaration: what it unpacks to would fill the memory. */
const LONGEST_LINK = 1 << 16;
/** Bytes that a link may unpack to. */
const LONGEST_TEXT = 1 << 22;

/** @param {string} text */
export async function packText(text) {
  const bytes = await deflated(new TextEncoder().encode(text));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The text of a link; null where it holds none. @param {string} packed */
export async function unpackText(packed) {
  if (packed === "" || packed.length > LONGEST_LINK) return null;
  try {
    const letters = atob(packed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = await inflated(Uint8Array.from(letters, (letter) => letter.charCodeAt(0)), LONGEST_TEXT);
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    return text === "" ? null : text;
  } catch {
    return null;
  }
}
