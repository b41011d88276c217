// Ranges and ticks of axes: the rules of chart/linear_scale.rs and chart/log_scale.rs. tests/ticks.json holds both to them.
//
// Ticks stand at the multiples of 1, 2 or 5 times a power of ten: P. S. Heckbert, "Nice numbers for graph labels",
// Graphics Gems, Academic Press 1990, page 61.

import { niceStep } from "./numbers.js";
import { powerOfTen } from "./text.js";

/** @typedef {{value: number, label: string}} Tick a mark; without a label between the labelled ones */

/** How many steps an axis is cut into, about. */
const STEPS = 6;

/**
 * From the smallest to the largest value, and never an empty range: a constant gets room around it.
 * @param {number} low +∞ where there is no value
 * @param {number} high
 * @returns {[number, number]}
 */
export function linearExtent(low, high) {
  if (low > high) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  // Below that relative width a difference is mostly rounding, and tick labels would need too many digits.
  if (high - low > 1e-12 * size && high - low > 1e-300) return [low, high];
  return size > 1e-300 ? [low - 0.1 * size, high + 0.1 * size] : [-1, 1];
}

/**
 * The ticks in the range, in rising order.
 * @param {number} low
 * @param {number} high
 * @param {number} [steps] wanted, about
 * @returns {Tick[]}
 */
export function linearTicks(low, high, steps = STEPS) {
  const { digit, exponent } = niceStep((high - low) / steps);
  const step = timesPower(digit, exponent);
  // A hair of the step, so that the ends of a tight range keep their ticks in spite of rounding.
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  const largest = Math.max(Math.abs(first), Math.abs(last)) * digit;
  const ticks = [];
  for (let count = first; count <= last; count++) {
    const number = count * digit;
    ticks.push({ value: timesPower(number, exponent), label: linearLabel(number, exponent, largest) });
  }
  return ticks;
}

/**
 * A negative power is divided by, because 10^n is exact and 10^-n is not.
 * @param {number} number whole
 * @param {number} exponent
 */
function timesPower(number, exponent) {
  return exponent < 0 ? number / Number(`1e${-exponent}`) : number * Number(`1e${exponent}`);
}

/**
 * Plain digits, or with a power of ten common to the axis where plain digits would be many.
 * @param {number} number of the tick, times ten to the exponent
 * @param {number} exponent
 * @param {number} largest of the axis
 */
function linearLabel(number, exponent, largest) {
  if (number === 0) return "0";
  const leading = exponent + String(Math.max(largest, 1)).length - 1;
  if (leading < 5 && exponent > -5) return decimalText(number, exponent);
  return `${decimalText(number, exponent - leading)}×${powerOfTen(leading)}`;
}

/**
 * `number` · 10^`exponent` in plain digits, with a minus sign as long as a plus.
 * @param {number} number
 * @param {number} exponent
 */
function decimalText(number, exponent) {
  const sign = number < 0 ? "−" : "";
  const digits = String(Math.abs(number));
  if (exponent >= 0) return sign + digits + "0".repeat(exponent);
  const padded = digits.padStart(1 - exponent, "0");
  return `${sign}${padded.slice(0, exponent)}.${padded.slice(exponent)}`;
}

/** As many labels as a logarithmic axis holds without crowding. */
const MOST_LABELS = 10;

/** A range of at least this width holds two of the numbers 1, 2 and 5 times a power of ten. */
const NARROWEST = 0.7;

/**
 * From the smallest to the largest of some decimal logarithms, and never too narrow for ticks.
 * @param {number} low +∞ where there is no value
 * @param {number} high
 * @returns {[number, number]}
 */
export function decadeExtent(low, high) {
  if (low > high) return [0, 1];
  const missing = Math.max(NARROWEST - (high - low), 0);
  return [low - 0.5 * missing, high + 0.5 * missing];
}

/**
 * Ticks between two decimal logarithms: at decades, labelled as far as there is room; between them at the whole multiples
 * where the range is short, and in a very short one labels at 2 and 5 too.
 * @param {number} low
 * @param {number} high
 * @returns {Tick[]}
 */
export function decadeTicks(low, high) {
  const every = Math.floor(Math.trunc(high - low) / MOST_LABELS) + 1;
  const labelled = high - low < 2 ? [1, 2, 5] : [1];
  const most = high - low <= 6 ? 9 : 1;
  const plain = low > -3.1 && high < 4.1;
  const ticks = [];
  for (let exponent = Math.floor(low - 1e-9); exponent <= Math.ceil(high + 1e-9); exponent++) {
    for (let digit = 1; digit <= most; digit++) {
      const position = exponent + Math.log10(digit);
      const hasLabel = labelled.includes(digit) && exponent % every === 0;
      const isInside = low - 1e-9 <= position && position <= high + 1e-9;
      // So many decades that ticks between the labelled ones would be a grey edge.
      const isCrowded = every > 9 && !hasLabel;
      if (!isInside || isCrowded) continue;
      const label = hasLabel ? decadeLabel(digit, exponent, plain) : "";
      ticks.push({ value: Number(`${digit}e${exponent}`), label });
    }
  }
  return ticks;
}

/**
 * `0.02` or `2×10⁻²`.
 * @param {number} digit
 * @param {number} exponent
 * @param {boolean} plain
 */
function decadeLabel(digit, exponent, plain) {
  if (plain && exponent >= 0) return digit + "0".repeat(exponent);
  if (plain) return `0.${"0".repeat(-exponent - 1)}${digit}`;
  return digit === 1 ? powerOfTen(exponent) : `${digit}×${powerOfTen(exponent)}`;
}
