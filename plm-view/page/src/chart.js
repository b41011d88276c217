// One frame with axes and curves over time.

import { lastNotAbove } from "./numbers.js";
import { commonQuantity, withUnit } from "./text.js";
import { thinPieces } from "./thin.js";
import { linearExtent, linearTicks } from "./ticks.js";

/** @import {Palette} from "./palette.js" */
/** @import {Pen} from "./pen.js" */
/** @import {Quantity, Run} from "./run.js" */
/** @import {Area} from "./view.js" */

/** @typedef {{run: Run, quantity: Quantity, colour: string, dash: number[]}} Series */
/** @typedef {{unit: string, series: Series[]}} Chart */
/** @typedef {{frame: Area, from: number, to: number, low: number, high: number}} ChartFrame pixels, times, values */

/** Room for labels under the last frame. */
export const TIME_AXIS = 34;
/** Room beyond the values, as a share of their range: that of chart/axis.rs. */
const CHART_PADDING = 0.06;
const LABEL_SIZE = 11;

/**
 * What a chart shows of its quantity, with a little room so that no curve runs along the frame.
 * @param {Chart} chart
 * @returns {[number, number]}
 */
export function chartRange(chart) {
  const [least, most] = linearExtent(...valueRange(chart));
  const padding = CHART_PADDING * (most - least);
  return [least - padding, most + padding];
}

/**
 * Room on the left of the frames of some charts: for the longest label of all, so that their times stand one above another.
 * @param {[number, number][]} ranges
 */
export function leftRoom(ranges) {
  return 12 + Math.max(...ranges.map(([low, high]) => labelRoom(low, high)));
}

/**
 * Where everything of a chart goes.
 * @param {[number, number]} range
 * @param {Area} area with the labels
 * @param {{from: number, to: number, hasTimes: boolean, left: number}} layout
 * @returns {ChartFrame}
 */
export function chartFrame([low, high], area, { from, to, hasTimes, left }) {
  const bottom = hasTimes ? TIME_AXIS : 8;
  return {
    frame: { x: area.x + left, y: area.y + 8, width: area.width - left - 14, height: area.height - 8 - bottom },
    from,
    to: to > from ? to : from + 1,
    low,
    high,
  };
}

/** @param {Chart} chart @returns {[number, number]} */
function valueRange(chart) {
  let [low, high] = [Infinity, -Infinity];
  for (const { run, quantity } of chart.series) {
    for (let row = 0; row < run.rows; row++) {
      const value = quantity.read(row);
      if (value < low && value > -1e300) low = value;
      if (value > high && value < 1e300) high = value;
    }
  }
  return [low, high];
}

/**
 * @param {Pen} pen
 * @param {Chart} chart
 * @param {ChartFrame} at
 * @param {Palette} palette
 * @param {boolean} hasTimes whether times are written under the frame
 */
export function drawChart(pen, chart, at, palette, hasTimes) {
  drawGrid(pen, chart, at, palette, hasTimes);
  const { frame, from, to, low, high } = at;
  const xOf = frame.width / (to - from);
  const yOf = frame.height / (high - low);
  pen.within(frame, () => {
    for (const { run, quantity, colour, dash } of chart.series) {
      const times = run.time.data;
      const column = (/** @type {number} */ row) => Math.round((times[row] - from) * xOf);
      for (const piece of thinPieces(run.rows, column, quantity.read)) {
        const points = [];
        for (const row of piece) {
          points.push(frame.x + (times[row] - from) * xOf, frame.y + (high - quantity.read(row)) * yOf);
        }
        // A single row between gaps is a dot.
        if (points.length === 2) points.push(points[0] + 0.01, points[1]);
        pen.line(points, { stroke: colour, width: 1.5, dash });
      }
    }
  });
}

/**
 * @param {Pen} pen
 * @param {Chart} chart
 * @param {ChartFrame} at
 * @param {Palette} palette
 * @param {boolean} hasTimes
 */
function drawGrid(pen, chart, { frame, from, to, low, high }, palette, hasTimes) {
  const { x, y, width, height } = frame;
  const lettering = { colour: palette.faint, size: LABEL_SIZE };
  for (const { value, label } of linearTicks(low, high, height < 90 ? 3 : 6)) {
    const place = y + ((high - value) / (high - low)) * height;
    pen.line([x, place, x + width, place], { stroke: value === 0 ? palette.faint : palette.grid, width: value === 0 ? 1.2 : 1 });
    pen.text(x - 6, place, label, { ...lettering, align: "end" });
  }
  const steps = Math.max(2, Math.min(6, Math.floor(width / 60)));
  for (const { value, label } of linearTicks(from, to, steps)) {
    const place = x + ((value - from) / (to - from)) * width;
    pen.line([place, y, place, y + height], { stroke: palette.grid, width: 1 });
    if (hasTimes) pen.text(place, y + height + 11, label, { ...lettering, align: "middle" });
  }
  if (hasTimes) pen.text(x + 0.5 * width, y + height + 26, "time (s)", { ...lettering, align: "middle" });
  const names = [...new Set(chart.series.map(({ quantity }) => quantity.name))];
  const title = withUnit(commonQuantity(names), chart.unit);
  pen.text(frame.x - labelRoom(low, high), y + 0.5 * height, title, { ...lettering, align: "middle", turned: true });
  const corners = [x, y, x + width, y, x + width, y + height, x, y + height];
  pen.polygon(corners, { stroke: palette.grid, width: 1 });
}

/** From the frame to the middle of the axis' name. @param {number} low @param {number} high */
function labelRoom(low, high) {
  return 20 + 6.4 * Math.max(...linearTicks(low, high).map(({ label }) => label.length));
}

/**
 * The time under a pixel.
 * @param {ChartFrame} at
 * @param {number} x
 */
export function timeAt({ frame, from, to }, x) {
  return from + ((x - frame.x) / frame.width) * (to - from);
}

/**
 * A line at a time, and dots where it cuts the curves.
 * @param {Pen} pen
 * @param {Chart} chart
 * @param {ChartFrame} at
 * @param {Palette} palette
 * @param {number} time
 */
export function drawCursor(pen, chart, { frame, from, to, low, high }, palette, time) {
  const x = frame.x + ((time - from) / (to - from)) * frame.width;
  pen.line([x, frame.y, x, frame.y + frame.height], { stroke: palette.ink, width: 1 });
  for (const { run, quantity, colour } of chart.series) {
    if (run.rows === 0 || time > run.end) continue;
    const value = run.valueAt(quantity, run.momentAt(time));
    if (!Number.isFinite(value)) continue;
    const y = frame.y + ((high - value) / (high - low)) * frame.height;
    pen.polygon([x - 3, y, x, y - 3, x + 3, y, x, y + 3], { fill: colour });
  }
}

/**
 * Vertical lines at events, and at the fault.
 * @param {Pen} pen
 * @param {ChartFrame} at
 * @param {Run} run
 * @param {Palette} palette
 */
export function drawEvents(pen, { frame, from, to }, run, palette) {
  const place = (/** @type {number} */ time) => frame.x + ((time - from) / (to - from)) * frame.width;
  const line = (/** @type {number} */ time, /** @type {string} */ stroke, /** @type {number} */ width) =>
    pen.line([place(time), frame.y, place(time), frame.y + frame.height], { stroke, width, dash: [3, 3] });
  const first = lastNotAbove(run.events.map(({ time }) => time), run.events.length, from);
  // So many that they would be a grey face tell nothing.
  if (run.events.length - first < 0.25 * frame.width) {
    for (const { time } of run.events) line(time, palette.faint, 0.7);
  }
  if (run.fault !== null) line(run.fault.time, palette.fault, 1.5);
}
