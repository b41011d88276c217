// Bytes that were compressed by LZMA, and text that holds bytes densely.
//
// After the "LZMA specification" of Igor Pavlov (7-zip.org/sdk.html, 2015), which is in the public domain; names are those of it.

/** A probability of one half, of 2048. */
const HALF = 1024;
const POSITION_BITS_MAX = 4;
const LENGTH_STATES = 4;
const END_POSITION_MODEL = 14;
const FULL_DISTANCES = 128;
const ALIGN_BITS = 4;
const MATCH_MIN = 2;
/** Of the sizes of a text: properties, dictionary, length. */
const HEADER = 13;

/** @param {number} count */
const probabilities = (count) => new Uint16Array(count).fill(HALF);

/** The range decoder: range and code are numbers of 32 bits. */
class RangeDecoder {
  /** @param {Uint8Array} input @param {number} at */
  constructor(input, at) {
    this.input = input;
    this.at = at + 5;
    // In an array of its own, so that a browser keeps both as plain numbers of 32 bits.
    this.state = new Uint32Array([0xffffffff, (input[at + 1] << 24) | (input[at + 2] << 16) | (input[at + 3] << 8) | input[at + 4]]);
  }

  /** @param {Uint16Array} probs @param {number} index */
  bit(probs, index) {
    const { state } = this;
    const prob = probs[index];
    const bound = Math.imul(state[0] >>> 11, prob) >>> 0;
    let bit = 0;
    if (state[1] < bound) {
      state[0] = bound;
      probs[index] = prob + ((2048 - prob) >>> 5);
    } else {
      state[0] -= bound;
      state[1] -= bound;
      probs[index] = prob - (prob >>> 5);
      bit = 1;
    }
    if (state[0] < 0x1000000) {
      state[0] <<= 8;
      state[1] = (state[1] << 8) | this.input[this.at++];
    }
    return bit;
  }

  /** Bits of equal probability. @param {number} count */
  direct(count) {
    const { state } = this;
    let result = 0;
    for (let k = 0; k < count; k++) {
      state[0] >>>= 1;
      const bit = state[1] >= state[0] ? 1 : 0;
      if (bit === 1) state[1] -= state[0];
      if (state[0] < 0x1000000) {
        state[0] <<= 8;
        state[1] = (state[1] << 8) | this.input[this.at++];
      }
      result = result * 2 + bit;
    }
    return result;
  }

  /** @param {Uint16Array} probs @param {number} from @param {number} bits */
  tree(probs, from, bits) {
    let m = 1;
    for (let k = 0; k < bits; k++) m = (m << 1) | this.bit(probs, from + m);
    return m - (1 << bits);
  }

  /** The lowest bit first. @param {Uint16Array} probs @param {number} from @param {number} bits */
  reverseTree(probs, from, bits) {
    let m = 1;
    let symbol = 0;
    for (let k = 0; k < bits; k++) {
      const bit = this.bit(probs, from + m);
      m = (m << 1) | bit;
      symbol |= bit << k;
    }
    return symbol;
  }
}

/** Lengths of matches. */
class LengthDecoder {
  constructor() {
    this.choice = probabilities(2);
    this.low = probabilities(8 << POSITION_BITS_MAX);
    this.mid = probabilities(8 << POSITION_BITS_MAX);
    this.high = probabilities(256);
  }

  /** @param {RangeDecoder} decoder @param {number} position */
  decode(decoder, position) {
    if (decoder.bit(this.choice, 0) === 0) return decoder.tree(this.low, position << 3, 3);
    if (decoder.bit(this.choice, 1) === 0) return 8 + decoder.tree(this.mid, position << 3, 3);
    return 16 + decoder.tree(this.high, 0, 8);
  }
}

/** The probabilities of a stream, its state, and the bytes that it has made. */
class LzmaDecoder {
  /** @param {Uint8Array} input a file `.lzma` */
  constructor(input) {
    const properties = input[0];
    this.lc = properties % 9;
    this.literalMask = (1 << (Math.floor(properties / 9) % 5)) - 1;
    this.positionMask = (1 << Math.floor(properties / 45)) - 1;
    this.decoder = new RangeDecoder(input, HEADER);
    this.literals = probabilities(0x300 * (this.literalMask + 1) << this.lc);
    this.isMatch = probabilities(12 << POSITION_BITS_MAX);
    this.isRep = probabilities(12);
    this.isRepG0 = probabilities(12);
    this.isRepG1 = probabilities(12);
    this.isRepG2 = probabilities(12);
    this.isRep0Long = probabilities(12 << POSITION_BITS_MAX);
    this.positionSlot = probabilities(LENGTH_STATES << 6);
    this.positions = probabilities(1 + FULL_DISTANCES - END_POSITION_MODEL);
    this.align = probabilities(1 << ALIGN_BITS);
    this.length = new LengthDecoder();
    this.repLength = new LengthDecoder();
    this.made = new Uint8Array(input.length * 5);
    this.count = 0;
    this.state = 0;
    this.reps = [0, 0, 0, 0];
  }

  /** @param {number} more */
  reserve(more) {
    if (this.count + more <= this.made.length) return;
    const larger = new Uint8Array(2 * this.made.length + more);
    larger.set(this.made);
    this.made = larger;
  }

  literal() {
    const { decoder, made, count, literals, state } = this;
    const before = count > 0 ? made[count - 1] : 0;
    const from = 0x300 * (((count & this.literalMask) << this.lc) + (before >>> (8 - this.lc)));
    let symbol = 1;
    if (state >= 7) {
      let match = made[count - this.reps[0] - 1];
      while (symbol < 0x100) {
        const matchBit = (match >>> 7) & 1;
        match <<= 1;
        const bit = decoder.bit(literals, from + ((1 + matchBit) << 8) + symbol);
        symbol = (symbol << 1) | bit;
        if (matchBit !== bit) break;
      }
    }
    while (symbol < 0x100) symbol = (symbol << 1) | decoder.bit(literals, from + symbol);
    made[this.count++] = symbol;
    this.state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
  }

  /** @param {number} length */
  distance(length) {
    const { decoder } = this;
    const slot = decoder.tree(this.positionSlot, Math.min(length, LENGTH_STATES - 1) << 6, 6);
    if (slot < 4) return slot;
    const bits = (slot >>> 1) - 1;
    const base = (2 | (slot & 1)) * 2 ** bits;
    if (slot < END_POSITION_MODEL) return base + decoder.reverseTree(this.positions, base - slot, bits);
    return base + decoder.direct(bits - ALIGN_BITS) * (1 << ALIGN_BITS) + decoder.reverseTree(this.align, 0, ALIGN_BITS);
  }

  /** A distance that was used before moves to the front. */
  repeated() {
    const { decoder, state, reps } = this;
    if (decoder.bit(this.isRepG1, state) === 0) this.reps = [reps[1], reps[0], reps[2], reps[3]];
    else if (decoder.bit(this.isRepG2, state) === 0) this.reps = [reps[2], reps[0], reps[1], reps[3]];
    else this.reps = [reps[3], reps[0], reps[1], reps[2]];
  }

  /** A match: its length; 0 at the end of the stream. @param {number} position */
  match(position) {
    const { decoder, state, reps } = this;
    if (decoder.bit(this.isRep, state) === 0) {
      const length = this.length.decode(decoder, position);
      this.state = state < 7 ? 7 : 10;
      const distance = this.distance(length);
      if (distance === 0xffffffff) return 0;
      this.reps = [distance, reps[0], reps[1], reps[2]];
      return length + MATCH_MIN;
    }
    if (decoder.bit(this.isRepG0, state) === 1) this.repeated();
    else if (decoder.bit(this.isRep0Long, (state << POSITION_BITS_MAX) + position) === 0) {
      this.state = state < 7 ? 9 : 11;
      return 1;
    }
    const length = this.repLength.decode(decoder, position);
    this.state = state < 7 ? 8 : 11;
    return length + MATCH_MIN;
  }

  /** All bytes, up to the mark of the end. */
  all() {
    for (;;) {
      const position = this.count & this.positionMask;
      this.reserve(273 + MATCH_MIN);
      if (this.decoder.at > this.decoder.input.length) throw new Error("the bytes are no LZMA");
      if (this.decoder.bit(this.isMatch, (this.state << POSITION_BITS_MAX) + position) === 0) {
        this.literal();
        continue;
      }
      const length = this.match(position);
      if (length === 0) return this.made.subarray(0, this.count);
      const from = this.count - this.reps[0] - 1;
      if (from < 0) throw new Error("the bytes are no LZMA");
      for (let k = 0; k < length; k++) this.made[this.count + k] = this.made[from + k];
      this.count += length;
    }
  }
}

/** The bytes of a file `.lzma` that ends with the mark of the end. @param {Uint8Array} bytes */
export function unlzma(bytes) {
  return new LzmaDecoder(bytes).all();
}
