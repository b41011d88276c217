// Which charts there are, and all of them as one SVG file.

import { acrossRange, countBelow, leftRoom, valueAxis } from "./axes.js";
import { ACROSS_AXIS, acrossTitle, chartFrame, chartTitle, drawChart, drawSample } from "./chart.js";
import { SvgPen } from "./pen.js";

/** @import {App} from "./app.js" */
/** @import {Chart, Series} from "./axes.js" */

/** Dashes tell runs apart; the active one is solid. */
const DASHES = [[6, 4], [2, 3], [9, 3, 2, 3], [12, 4]];

/**
 * One chart for each unit, in the order in which they were chosen; every visible run has its curve. Residuals have charts of their own,
 * since they are small beside what they are residuals of.
 * @param {App} app
 * @returns {Chart[]}
 */
export function chartsOf(app) {
  /** @type {Map<string, Series[]>} */
  const byKey = new Map();
  const { curves } = app.palette;
  const runs = app.visible().map(({ run }) => ({
    run,
    quantities: new Map(run.quantities().map((quantity) => [quantity.name, quantity])),
  }));
  let others = 0;
  for (const { run, quantities } of runs) {
    const dash = run === app.run ? [] : DASHES[others++ % DASHES.length];
    const across = app.across === null ? null : quantities.get(app.across);
    if (across === undefined) continue;
    app.curves.forEach((name, at) => {
      const quantity = quantities.get(name);
      if (quantity === undefined) return;
      const key = quantity.role === "residual" ? `residual ${quantity.unit}` : quantity.unit;
      const list = byKey.get(key) ?? [];
      byKey.set(key, list);
      list.push({ run, quantity, across, colour: curves[at % curves.length], dash });
    });
  }
  return [...byKey].map(([key, series]) => ({ key, unit: series[0].quantity.unit, series, isLog: app.logUnits.includes(key) }));
}

/** The name of a chart for who does not see it. @param {Chart} chart */
export function chartLabel(chart) {
  const names = [...new Set(chart.series.map(({ quantity }) => quantity.name))];
  const across = chart.series[0]?.across ?? null;
  const against = across === null ? "over time" : `against ${acrossTitle(chart)}`;
  const scale = chart.isLog ? ", logarithmic" : "";
  return `${chartTitle(chart)} ${against}${scale}: ${names.join(", ")}`;
}

/** What a logarithmic axis cannot show, in words; nothing where there is nothing. @param {Chart} chart */
export function missingText(chart) {
  const count = countBelow(chart);
  if (count === 0) return "";
  return count === 1 ? "1 value at or below zero is not shown." : `${count} values at or below zero are not shown.`;
}

/**
 * All charts in one SVG file, without the cursor.
 * @param {App} app
 */
export function curvesSvg(app) {
  const charts = chartsOf(app);
  const { palette, player } = app;
  const pen = new SvgPen();
  const width = 800;
  const axes = charts.map(valueAxis);
  const left = leftRoom(axes);
  const across = acrossRange(charts, [player.start, player.end]);
  let y = 0;
  charts.forEach((chart, at) => {
    const hasLabels = at === charts.length - 1;
    const lines = chart.series.map((series) => {
      const { run, quantity } = series;
      const name = app.visible().length > 1 ? `${quantity.name}, ${run.name}` : quantity.name;
      return { name, draw: (/** @type {number} */ middle) => drawSample(pen, series, [70, 94], middle) };
    });
    const missing = missingText(chart);
    if (missing !== "") lines.push({ name: missing, draw: () => {} });
    lines.forEach(({ name, draw }, index) => {
      const middle = y + 18 + 18 * index;
      draw(middle);
      pen.text(102, middle, name, { colour: palette.ink, size: 12 });
    });
    y += 14 + 18 * lines.length;
    const area = { x: 0, y, width, height: 190 + (hasLabels ? ACROSS_AXIS : 8) };
    drawChart(pen, chart, chartFrame(axes[at], area, { across, hasLabels, left }), palette);
    y += area.height;
  });
  return pen.finish(width, Math.max(y + 8, 40), palette.background, `${app.run?.mechanism.name ?? ""}: curves`);
}
