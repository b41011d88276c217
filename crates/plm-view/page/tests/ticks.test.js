// One table of cases holds these rules and those of chart/*.rs.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { DARK, LIGHT } from "../src/palette.js";
import { FONT } from "../src/pen.js";
import { commonQuantity, powerOfTen, quantityText, shortNumber, timeText, typeset, withUnit } from "../src/text.js";
import { decadeExtent, decadeTicks, linearExtent, linearTicks } from "../src/ticks.js";

const table = JSON.parse(readFileSync(new URL("ticks.json", import.meta.url), "utf8"));

const labels = (ticks) => ticks.map(({ label }) => label).filter((label) => label !== "").join(" ");

test("linear ticks stand at nice numbers", () => {
  for (const [low, high, expected] of table.linear) assert.equal(labels(linearTicks(low, high)), expected);
});

test("linear ticks are the numbers that their labels say", () => {
  for (const [low, high] of [[0, 1], [-0.7, 0.2], [3, 3.001], [-4e4, 9e4]]) {
    for (const { value, label } of linearTicks(low, high)) assert.ok(Number(label.replace("−", "-")) === value, label);
  }
});

test("a constant gets room around it", () => {
  for (const [low, high, least, most] of table.linear_extents) {
    const found = linearExtent(low, high);
    [least, most].forEach((value, at) => {
      // The table has decimal fractions: one rounding of each product and sum.
      assert.ok(Math.abs(found[at] - value) <= 4 * Number.EPSILON * Math.abs(value), `${low} ${high}: ${found}`);
    });
  }
  assert.deepEqual(linearExtent(Infinity, -Infinity), [0, 1]);
});

test("logarithmic labels stand at decades", () => {
  for (const [low, high, expected] of table.decades) {
    assert.equal(labels(decadeTicks(Math.log10(low), Math.log10(high))), expected);
  }
  for (const [low, high, expected] of table.between) {
    const ticks = decadeTicks(Math.log10(low), Math.log10(high));
    assert.equal(ticks.map(({ value }) => value).join(" "), expected);
  }
});

test("one value on a logarithmic axis gets room for two ticks", () => {
  const [low, high] = decadeExtent(3, 3);
  assert.ok(Math.abs(high - low - 0.7) < 1e-12);
  assert.ok(labels(decadeTicks(low, high)).split(" ").length >= 2);
});

test("units and names are written as in charts", () => {
  for (const [unit, expected] of table.units) assert.equal(typeset(unit), expected);
  for (const [names, expected] of table.common) assert.equal(commonQuantity(names.split(" ")), expected);
  for (const [quantity, unit, expected] of table.axes) assert.equal(withUnit(quantity, unit), expected);
  for (const [exponent, expected] of table.powers) assert.equal(powerOfTen(exponent), expected);
});

test("charts in the book look as curves in the page", () => {
  for (const [name, expected] of table.look) assert.equal(name === "font" ? FONT : LIGHT[name], expected, name);
  assert.deepEqual(LIGHT.curves, table.curves);
  assert.deepEqual([DARK.background, DARK.ink, DARK.faint, DARK.grid, ...DARK.curves], table.dark);
});

test("numbers are short and readable", () => {
  for (const [value, expected] of [
    [0, "0"],
    [-1.5, "−1.5"],
    [123456.7, "123460"],
    [1234567, "1.2346×10⁶"],
    [0.000012345, "1.2345×10⁻⁵"],
    [0.1 + 0.2, "0.3"],
    [NaN, "–"],
    [-Infinity, "−∞"],
  ]) {
    assert.equal(shortNumber(value), expected);
  }
  assert.equal(quantityText(2, "kg*m^2"), "2 kg·m²");
  assert.equal(timeText(1.25, 4), "1.250 s");
  assert.equal(timeText(0.00125, 0.002), "0.001250 s");
});
