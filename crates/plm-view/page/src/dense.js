// Bytes as text of which each letter is seven bits, in one byte of UTF-8: 8/7 of the bytes, where base 64 takes 4/3.
//
// HTML changes or reads three letters: NUL, CR and `<`. Each of them becomes, with the seven bits after it, one letter of two bytes.

/** The letters that may not stand there. */
const BARRED = [0, 13, 60];
/** The first letter of two bytes: after the control characters. */
const FIRST_PAIR = 0xa0;

/** The bytes of a text that `crates/plm-view/src/page/dense.rs` has written. @param {string} text */
export function undense(text) {
  const bytes = new Uint8Array(Math.ceil((text.length * 14) / 8));
  let count = 0;
  let bits = 0;
  let held = 0;
  const put = (/** @type {number} */ seven) => {
    held = ((held << 7) | seven) & 0x7fff;
    bits += 7;
    if (bits < 8) return;
    bits -= 8;
    bytes[count++] = held >>> bits;
  };
  for (let at = 0; at < text.length; at++) {
    const letter = text.charCodeAt(at);
    if (letter < FIRST_PAIR) {
      put(letter);
      continue;
    }
    const pair = letter - FIRST_PAIR;
    put(BARRED[(pair >>> 7) % BARRED.length]);
    // The last letter of a text may have nothing after it.
    if (pair >>> 7 < BARRED.length) put(pair & 127);
  }
  return bytes.slice(0, count);
}
