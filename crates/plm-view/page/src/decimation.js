// Decimation of curves: fewer points, the same picture, by the rules of chart/decimation.rs.

import { drawable } from "./numbers.js";

/**
 * The rows of a curve that can be seen, in unbroken pieces: of consecutive rows in one pixel column the first, the lowest,
 * the highest and the last are kept, in their order. No peak is lost, however short; a row that has no place (NaN) breaks
 * the curve.
 * @param {number} count of rows
 * @param {(row: number) => number} columnOf pixel column of a row; rows rise or fall as they like
 * @param {(row: number) => number} heightOf
 * @returns {number[][]} rows
 */
export function decimate(count, columnOf, heightOf) {
  /** @type {number[][]} */
  const pieces = [];
  /** @type {number[]} */
  let piece = [];
  let [first, lowest, highest, last, column] = [-1, -1, -1, -1, NaN];
  let [low, high] = [0, 0];
  const finish = () => {
    if (first < 0) return;
    const [a, b] = lowest < highest ? [lowest, highest] : [highest, lowest];
    piece.push(first);
    if (a !== first) piece.push(a);
    if (b !== a && b !== first) piece.push(b);
    if (last !== b && last !== first) piece.push(last);
    first = -1;
  };
  for (let row = 0; row < count; row++) {
    const height = heightOf(row);
    const place = columnOf(row);
    if (!drawable(height) || !drawable(place)) {
      finish();
      if (piece.length > 0) pieces.push(piece);
      piece = [];
      continue;
    }
    if (first < 0 || place !== column) {
      finish();
      [first, lowest, highest, column] = [row, row, row, place];
      [low, high] = [height, height];
    } else if (height < low) {
      [low, lowest] = [height, row];
    } else if (height > high) {
      [high, highest] = [height, row];
    }
    last = row;
  }
  finish();
  if (piece.length > 0) pieces.push(piece);
  return pieces;
}
