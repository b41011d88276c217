// Numbers and units as they are shown: the rules of chart/label.rs.

const RAISED = new Map([..."-0123456789"].map((sign, index) => [sign, "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"[index]]));

/** @param {string} sign */
function superscript(sign) {
  return RAISED.get(sign) ?? sign;
}

/**
 * A unit as printed: `N*m/s^2` becomes `N·m/s²`.
 * @param {string} unit
 */
export function typeset(unit) {
  let raised = false;
  let out = "";
  for (const sign of unit) {
    raised = sign === "^" || (raised && /[-0-9]/.test(sign));
    if (sign === "^") continue;
    out += sign === "*" ? "·" : raised ? superscript(sign) : sign;
  }
  return out;
}

/**
 * `10⁻⁶` for -6.
 * @param {number} exponent
 */
export function powerOfTen(exponent) {
  return `10${[...String(exponent)].map(superscript).join("")}`;
}

/**
 * `angle (deg)`; the quantity alone for a pure number, the unit alone where the curves have no common name.
 * @param {string} quantity
 * @param {string} unit
 */
export function withUnit(quantity, unit) {
  if (unit === "") return quantity;
  return quantity === "" ? typeset(unit) : `${quantity} (${typeset(unit)})`;
}

/**
 * The last part of dotted names if all have the same one: `angle` for `arm.angle` and `forearm.angle`.
 * @param {string[]} names
 */
export function commonQuantity(names) {
  const last = new Set(names.map((name) => name.slice(name.lastIndexOf(".") + 1)));
  return last.size === 1 ? [...last][0] : "";
}

/**
 * A number in few digits, with a minus sign as long as a plus.
 * @param {number} value
 * @param {number} [digits] significant ones
 */
export function shortNumber(value, digits = 5) {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const sign = value < 0 ? "−" : "";
  if (size >= 1e-4 && size < 1e6) {
    // Digits after the point that are all 0 say nothing.
    return sign + String(Number(size.toPrecision(digits)));
  }
  const [mantissa, exponent] = size.toExponential(digits - 1).split("e");
  return `${sign}${Number(mantissa)}×${powerOfTen(Number(exponent))}`;
}

/**
 * @param {number} value
 * @param {string} unit
 */
export function quantityText(value, unit) {
  return unit === "" ? shortNumber(value) : `${shortNumber(value)} ${typeset(unit)}`;
}

/**
 * A quantity that a declaration may leave out.
 * @param {number} value NaN where it was left out
 * @param {string} unit
 */
export function givenText(value, unit) {
  return Number.isNaN(value) ? "not given" : quantityText(value, unit);
}

/**
 * A time for reading along: as many decimals as the duration of the run asks for.
 * @param {number} seconds
 * @param {number} duration
 */
export function timeText(seconds, duration) {
  const decimals = duration > 0 ? Math.max(0, Math.min(9, 3 - Math.floor(Math.log10(duration)))) : 3;
  return `${seconds.toFixed(decimals).replace("-", "−")} s`;
}

/** A text in which numbers of many digits are short. @param {string} text */
export function withShortNumbers(text) {
  return text.replace(/-?\d+\.\d{5,}(e-?\d+)?/g, (digits) => shortNumber(Number(digits)));
}
