// The axes of charts: values up, linear or logarithmic; the time across, or another quantity.

import { drawable } from "./numbers.js";
import { decadeExtent, decadeTicks, linearExtent, linearTicks } from "./ticks.js";

/** @import {Quantity, Run} from "./run.js" */

/** @typedef {{run: Run, quantity: Quantity, across: Quantity | null, colour: string, dash: number[]}} Series across null: the time */
/** @typedef {{key: string, unit: string, series: Series[], isLog: boolean}} Chart the key tells charts apart */
/** @typedef {{low: number, high: number, isLog: boolean}} ValueAxis values, or their decimal logarithms */

/** Room beyond the values, as a share of their range: that of chart/axis.rs. */
const CHART_PADDING = 0.06;

/**
 * Where a value stands on its axis. Numbers at or below zero have no place on a logarithmic one.
 * @param {{isLog: boolean}} axis
 * @param {number} value
 */
export function levelOf({ isLog }, value) {
  return isLog ? Math.log10(value) : value;
}

/**
 * What a chart shows of its quantity, with a little room so that no curve runs along the frame.
 * @param {Chart} chart
 * @returns {ValueAxis}
 */
export function valueAxis(chart) {
  const range = new Extent();
  for (const { run, quantity } of chart.series) {
    for (let row = 0; row < run.rows; row++) range.add(levelOf(chart, quantity.read(row)));
  }
  const [low, high] = padded((chart.isLog ? decadeExtent : linearExtent)(range.low, range.high));
  return { low, high, isLog: chart.isLog };
}

/**
 * What charts show across: all of them the same.
 * @param {Chart[]} charts
 * @param {[number, number]} times those that are shown
 * @returns {[number, number]}
 */
export function acrossRange(charts, times) {
  // All curves of a run are drawn against the same quantity.
  const quantities = new Map(charts.flatMap(({ series }) => series.map(({ run, across }) => [run, across])));
  if ([...quantities.values()].every((across) => across === null)) return times;
  const range = new Extent();
  for (const [run, across] of quantities) {
    for (let row = 0; across !== null && row < run.rows; row++) range.add(across.read(row));
  }
  return padded(linearExtent(range.low, range.high));
}

/**
 * How many numbers a chart does not show, because they are at or below zero.
 * @param {Chart} chart
 */
export function countBelow({ series, isLog }) {
  let count = 0;
  for (const { run, quantity } of isLog ? series : []) {
    for (let row = 0; row < run.rows; row++) count += Number(quantity.read(row) <= 0);
  }
  return count;
}

/**
 * Marks of an axis.
 * @param {ValueAxis} axis
 * @param {number} [steps] wanted, about
 */
export function axisTicks({ low, high, isLog }, steps) {
  return isLog ? decadeTicks(low, high) : linearTicks(low, high, steps);
}

/** From the frame to the middle of the axis' name. @param {ValueAxis} axis */
export function labelRoom(axis) {
  return 20 + 6.4 * Math.max(0, ...axisTicks(axis).map(({ label }) => label.length));
}

/**
 * Room on the left of the frames of some charts: for the longest label of all, so that they stand one above another.
 * @param {ValueAxis[]} axes
 */
export function leftRoom(axes) {
  return 12 + Math.max(...axes.map(labelRoom));
}

class Extent {
  constructor() {
    this.low = Infinity;
    this.high = -Infinity;
  }

  /** @param {number} value */
  add(value) {
    if (!drawable(value)) return;
    if (value < this.low) this.low = value;
    if (value > this.high) this.high = value;
  }
}

/** @param {[number, number]} range @returns {[number, number]} */
function padded([low, high]) {
  const padding = CHART_PADDING * (high - low);
  return [low - padding, high + padding];
}
