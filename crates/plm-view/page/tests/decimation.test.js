import assert from "node:assert/strict";
import { test } from "node:test";
import { decimate } from "../src/decimation.js";

test("few points are all kept", () => {
  const heights = [3, 1, 2];
  assert.deepEqual(decimate(3, (row) => row, (row) => heights[row]), [[0, 1, 2]]);
});

test("a curve breaks where it cannot be drawn", () => {
  const heights = [1, NaN, 2, 3, 1e305, 0, Infinity];
  assert.deepEqual(decimate(7, (row) => row, (row) => heights[row]), [[0], [2, 3], [5]]);
});

test("a million rows become at most four a column and keep a single spike", () => {
  const count = 1_000_000;
  const heights = Float64Array.from({ length: count }, (_, row) => Math.sin(row / 3e4));
  heights[500_500] = 99;
  heights[500_501] = -99;
  const started = performance.now();
  const pieces = decimate(count, (row) => Math.floor(row / 1000), (row) => heights[row]);
  const took = performance.now() - started;
  assert.equal(pieces.length, 1);
  const rows = pieces[0];
  assert.ok(rows.length <= 4000, `${rows.length} rows`);
  assert.ok(rows.includes(500_500) && rows.includes(500_501), "the spike is lost");
  assert.deepEqual([rows[0], rows.at(-1)], [0, count - 1]);
  assert.ok(rows.every((row, at) => at === 0 || row > rows[at - 1]), "rows out of order");
  assert.ok(took < 1000, `${took} ms`);
});

test("every column keeps its extremes", () => {
  let seed = 12345;
  const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
  const heights = Array.from({ length: 5000 }, () => random() ** 3);
  const [rows] = decimate(5000, (row) => Math.floor(row / 50), (row) => heights[row]);
  for (let column = 0; column < 100; column++) {
    const all = heights.slice(50 * column, 50 * column + 50);
    const kept = rows.filter((row) => Math.floor(row / 50) === column).map((row) => heights[row]);
    assert.equal(Math.max(...kept), Math.max(...all));
    assert.equal(Math.min(...kept), Math.min(...all));
  }
});

test("a gap ends a column", () => {
  const heights = [1, 5, NaN, 2, 0];
  assert.deepEqual(decimate(5, () => 0, (row) => heights[row]), [[0, 1], [3, 4]]);
});
