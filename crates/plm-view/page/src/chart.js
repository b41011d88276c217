// One frame with axes and curves: over the time, or against another quantity.

import { axisTicks, labelRoom, levelOf } from "./axes.js";
import { drawable, lastNotAbove } from "./numbers.js";
import { isMarked } from "./run.js";
import { commonQuantity, withUnit } from "./text.js";
import { decimate } from "./decimation.js";
import { linearTicks } from "./ticks.js";

/** @import {Chart, Series, ValueAxis} from "./axes.js" */
/** @import {Palette} from "./palette.js" */
/** @import {Pen} from "./pen.js" */
/** @import {Run} from "./run.js" */
/** @import {Area} from "./view.js" */

/** @typedef {ValueAxis & {frame: Area, from: number, to: number, hasLabels: boolean}} ChartFrame pixels; times or values across */

/** Room for labels under the last frame. */
export const ACROSS_AXIS = 34;
const LABEL_SIZE = 11;
const MARK_RADIUS = 2.5;

/**
 * Where everything of a chart goes.
 * @param {ValueAxis} axis
 * @param {Area} area with the labels
 * @param {{across: [number, number], hasLabels: boolean, left: number}} layout what is shown across, whether it is written under
 *   the frame, and the room on its left
 * @returns {ChartFrame}
 */
export function chartFrame(axis, area, { across: [from, to], hasLabels, left }) {
  const bottom = hasLabels ? ACROSS_AXIS : 8;
  return {
    ...axis,
    frame: { x: area.x + left, y: area.y + 8, width: area.width - left - 14, height: area.height - 8 - bottom },
    from,
    to: to > from ? to : from + 1,
    hasLabels,
  };
}

/** @param {ChartFrame} at @param {number} across */
function pixelAcross({ frame, from, to }, across) {
  return frame.x + ((across - from) / (to - from)) * frame.width;
}

/** @param {ChartFrame} at @param {number} level as `levelOf` gives it */
function pixelUp({ frame, low, high }, level) {
  return frame.y + ((high - level) / (high - low)) * frame.height;
}

/** What a curve has across in a row. @param {Series} series @returns {(row: number) => number} */
function acrossOf({ run, across }) {
  return across?.read ?? ((row) => run.time.data[row]);
}

/**
 * @param {Pen} pen
 * @param {Chart} chart
 * @param {ChartFrame} at
 * @param {Palette} palette
 */
export function drawChart(pen, chart, at, palette) {
  drawGrid(pen, chart, at, palette);
  pen.within(at.frame, () => {
    for (const series of chart.series) {
      const across = acrossOf(series);
      const column = (/** @type {number} */ row) => Math.round(pixelAcross(at, across(row)));
      const level = (/** @type {number} */ row) => levelOf(at, series.quantity.read(row));
      if (isMarked(series.quantity)) {
        for (let row = 0; row < series.run.rows; row++) drawDot(pen, series, pixelAcross(at, across(row)), pixelUp(at, level(row)));
        continue;
      }
      for (const piece of decimate(series.run.rows, column, level)) {
        const points = piece.flatMap((row) => [pixelAcross(at, across(row)), pixelUp(at, level(row))]);
        // A single row between gaps is a dot.
        if (points.length === 2) points.push(points[0] + 0.01, points[1]);
        pen.line(points, { stroke: series.colour, width: 1.5, dash: series.dash });
      }
    }
  });
}

/**
 * A disc at a place, if it is one.
 * @param {Pen} pen
 * @param {Series} series
 * @param {number} x pixels
 * @param {number} y
 */
function drawDot(pen, { colour }, x, y) {
  if (!drawable(x) || !drawable(y)) return;
  const angles = [0, 1, 2, 3, 4, 5, 6, 7].map((part) => (Math.PI * part) / 4);
  pen.polygon(angles.flatMap((angle) => [x + MARK_RADIUS * Math.cos(angle), y + MARK_RADIUS * Math.sin(angle)]), { fill: colour });
}

/**
 * A piece of a curve, or a mark, for its name.
 * @param {Pen} pen
 * @param {Series} series
 * @param {[number, number]} across from and to, pixels
 * @param {number} middle
 */
export function drawSample(pen, series, [from, to], middle) {
  if (isMarked(series.quantity)) drawDot(pen, series, 0.5 * (from + to), middle);
  else pen.line([from, middle, to, middle], { stroke: series.colour, width: 2, dash: series.dash });
}

/**
 * What its quantities have in common, with the unit. Readings have the name of what is read, and a word.
 * @param {Chart} chart
 */
export function chartTitle({ series, unit }) {
  const curves = series.filter(({ quantity }) => !isMarked(quantity));
  const named = curves.length > 0 ? curves : series;
  return withUnit(commonQuantity(named.map(({ quantity }) => quantity.name)), unit);
}

/**
 * @param {Pen} pen
 * @param {Chart} chart
 * @param {ChartFrame} at
 * @param {Palette} palette
 */
function drawGrid(pen, chart, at, palette) {
  const { frame, from, to, hasLabels } = at;
  const { x, y, width, height } = frame;
  const lettering = { colour: palette.faint, size: LABEL_SIZE };
  for (const { value, label } of axisTicks(at, height < 90 ? 3 : 6)) {
    const place = pixelUp(at, levelOf(at, value));
    const isZero = value === 0;
    // Marks without a label stand between decades, too near for lines.
    const end = label === "" ? x + 4 : x + width;
    pen.line([x, place, end, place], { stroke: isZero ? palette.faint : palette.grid, width: isZero ? 1.2 : 1 });
    pen.text(x - 6, place, label, { ...lettering, align: "end" });
  }
  const steps = Math.max(2, Math.min(6, Math.floor(width / 60)));
  for (const { value, label } of linearTicks(from, to, steps)) {
    const place = pixelAcross(at, value);
    pen.line([place, y, place, y + height], { stroke: palette.grid, width: 1 });
    if (hasLabels) pen.text(place, y + height + 11, label, { ...lettering, align: "middle" });
  }
  if (hasLabels) pen.text(x + 0.5 * width, y + height + 26, acrossTitle(chart), { ...lettering, align: "middle" });
  pen.text(x - labelRoom(at), y + 0.5 * height, chartTitle(chart), { ...lettering, align: "middle", turned: true });
  const corners = [x, y, x + width, y, x + width, y + height, x, y + height];
  pen.polygon(corners, { stroke: palette.grid, width: 1 });
}

/** What stands across, with its unit. @param {Chart} chart */
export function acrossTitle({ series }) {
  const across = series[0]?.across ?? null;
  return across === null ? "time (s)" : withUnit(across.name, across.unit);
}

/**
 * The time under a place of a chart; against another quantity, that of the nearest row.
 * @param {Chart} chart
 * @param {ChartFrame} at
 * @param {number} x pixels
 * @param {number} y
 */
export function timeAt(chart, at, x, y) {
  const { frame, from, to } = at;
  let time = from + ((x - frame.x) / frame.width) * (to - from);
  let nearest = Infinity;
  for (const series of chart.series) {
    if (series.across === null) return time;
    const across = acrossOf(series);
    for (let row = 0; row < series.run.rows; row++) {
      const [dx, dy] = [pixelAcross(at, across(row)) - x, pixelUp(at, levelOf(at, series.quantity.read(row))) - y];
      const distance = dx * dx + dy * dy;
      if (distance < nearest) [nearest, time] = [distance, series.run.time.data[row]];
    }
  }
  return time;
}

/**
 * Where the curves are at a time: a line with dots over the time, points against another quantity.
 * @param {Pen} pen
 * @param {Chart} chart
 * @param {ChartFrame} at
 * @param {Palette} palette
 * @param {number} time
 */
export function drawCursor(pen, chart, at, palette, time) {
  const { frame } = at;
  if (chart.series.every(({ across }) => across === null)) {
    const x = pixelAcross(at, time);
    pen.line([x, frame.y, x, frame.y + frame.height], { stroke: palette.ink, width: 1 });
  }
  for (const { run, quantity, across, colour } of chart.series) {
    if (run.rows === 0 || time > run.end) continue;
    const moment = run.momentAt(time);
    const x = pixelAcross(at, across === null ? time : run.valueAt(across, moment));
    const y = pixelUp(at, levelOf(at, run.valueAt(quantity, moment)));
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    const size = across === null ? 3 : 5;
    pen.polygon([x - size, y, x, y - size, x + size, y, x, y + size], { fill: colour, stroke: across === null ? null : palette.ink });
  }
}

/**
 * Vertical lines at events, and at the fault; over the time alone.
 * @param {Pen} pen
 * @param {ChartFrame} at
 * @param {Run} run
 * @param {Palette} palette
 */
export function drawEvents(pen, at, run, palette) {
  const { frame, from } = at;
  const line = (/** @type {number} */ time, /** @type {string} */ stroke, /** @type {number} */ width) => {
    const x = pixelAcross(at, time);
    pen.line([x, frame.y, x, frame.y + frame.height], { stroke, width, dash: [3, 3] });
  };
  const first = lastNotAbove(run.events.map(({ time }) => time), run.events.length, from);
  // So many that they would be a grey face tell nothing.
  if (run.events.length - first < 0.25 * frame.width) {
    for (const { time } of run.events) line(time, palette.faint, 0.7);
  }
  if (run.fault !== null) line(run.fault.time, palette.fault, 1.5);
}
