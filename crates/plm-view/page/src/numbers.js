// Small functions of numbers.

/**
 * @param {number} value
 * @param {number} low
 * @param {number} high
 */
export function clamp(value, low, high) {
  return Math.min(Math.max(value, low), high);
}

/**
 * Whether a number can stand on an axis. The bound keeps differences of such numbers finite.
 * @param {number} value
 */
export function drawable(value) {
  return Math.abs(value) < 1e300;
}

/**
 * The last of the first `count` numbers of a rising list that is not above `value`; -1 if there is none.
 * @param {ArrayLike<number>} rising
 * @param {number} count
 * @param {number} value
 */
export function lastNotAbove(rising, count, value) {
  let [low, high] = [-1, count];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (rising[middle] <= value) low = middle;
    else high = middle;
  }
  return low;
}

/**
 * Where a number between two samples with rates is: Hermite's cubic.
 * @param {number} share of the interval, 0 to 1
 * @param {number} width of the interval
 * @param {number} a value at its beginning
 * @param {number} rateA
 * @param {number} b value at its end
 * @param {number} rateB
 */
export function hermite(share, width, a, rateA, b, rateB) {
  if (share === 0) return a;
  const rest = 1 - share;
  const line = rest * a + share * b;
  const bend = share * rest * (rest * (width * rateA - (b - a)) - share * (width * rateB - (b - a)));
  return Number.isFinite(bend) ? line + bend : line;
}

/**
 * The rate of that cubic; of the straight line where the samples have no rates.
 * @param {number} share of the interval, 0 to 1
 * @param {number} width of the interval
 * @param {number} a value at its beginning
 * @param {number} rateA
 * @param {number} b value at its end
 * @param {number} rateB
 */
export function hermiteRate(share, width, a, rateA, b, rateB) {
  if (share === 0 && Number.isFinite(rateA)) return rateA;
  const slope = (b - a) / width;
  const rest = 1 - share;
  const rate = rest * (1 - 3 * share) * rateA + share * (3 * share - 2) * rateB + 6 * share * rest * slope;
  return Number.isFinite(rate) ? rate : slope;
}

/**
 * The number of the form 1, 2 or 5 times a power of ten that is nearest to `width` > 0.
 * @param {number} width
 */
export function niceNear(width) {
  const { digit, exponent } = niceStep(width);
  return Number(`${digit}e${exponent}`);
}

/**
 * The same, taken apart: digit times ten to the exponent.
 * @param {number} width
 */
export function niceStep(width) {
  const exponent = Math.floor(Math.log10(width));
  const leading = width / Number(`1e${exponent}`);
  if (leading < 1.5) return { digit: 1, exponent };
  if (leading < 3) return { digit: 2, exponent };
  if (leading < 7) return { digit: 5, exponent };
  return { digit: 1, exponent: exponent + 1 };
}

/**
 * A value in a unit as SI: the number that is nearest to it, as a declaration has it, where the unit is a whole part of SI's.
 * 350 times the number next to a thousandth is not the number next to 0.35.
 * @param {number} value
 * @param {number} factor
 */
export function toSi(value, factor) {
  const parts = Math.round(1 / factor);
  return parts > 1 && 1 / parts === factor ? value / parts : value * factor;
}

/**
 * A value of SI in a unit: the shortest decimal that is within the roundings of a few operations, 350 and not 349.99999999999994, so
 * that a decimal of up to 14 digits is shown as it was typed.
 * @param {number} value
 * @param {number} factor
 */
export function fromSi(value, factor) {
  const shown = value / factor;
  for (let digits = 1; digits <= 15 && Number.isFinite(shown); digits++) {
    const short = Number(shown.toPrecision(digits));
    if (Math.abs(short - shown) <= 4 * Number.EPSILON * Math.abs(shown)) return short;
  }
  return Number.isFinite(shown) ? Number(shown.toPrecision(15)) : shown;
}
