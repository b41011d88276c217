import assert from "node:assert/strict";
import { test } from "node:test";
import { valueAxis } from "../src/axes.js";
import { chartFrame, chartTitle, drawChart } from "../src/chart.js";
import { chartsOf } from "../src/charts.js";
import { LIGHT } from "../src/palette.js";
import { Run } from "../src/run.js";
import { usualCurves } from "../src/runview.js";
import { headOf } from "./support/scenes.js";

/** A curve of 101 rows with readings in every tenth, which are off by 0.01. */
function fitted() {
  const columns = [
    { name: "rod.omega", unit: "rad/s" },
    { name: "rod.angle", unit: "deg" },
    { name: "rod.angle measured", unit: "deg", role: "reading" },
    { name: "rod.angle residual", unit: "deg", role: "residual" },
  ];
  const run = Run.empty(headOf({ name: "M", bodies: [] }, { columns }));
  for (let row = 0; row <= 100; row++) {
    const angle = 50 * Math.cos(row / 10);
    const off = row % 10 === 0 ? 0.01 : NaN;
    run.append(row / 100, [], [0, angle, angle - off, off]);
  }
  return run;
}

const appOf = (run) => ({
  palette: LIGHT,
  run,
  visible: () => [{ run }],
  curves: usualCurves(run),
  across: null,
  logUnits: [],
});

test("what was measured is drawn first, and residuals have a chart with an axis of their own", () => {
  const run = fitted();
  const app = appOf(run);
  assert.deepEqual(app.curves, ["rod.angle", "rod.angle measured", "rod.angle residual"]);
  const charts = chartsOf(app);
  assert.deepEqual(charts.map(({ series }) => series.map(({ quantity }) => quantity.name)), [
    ["rod.angle", "rod.angle measured"],
    ["rod.angle residual"],
  ]);
  assert.deepEqual(charts.map(chartTitle), ["angle (deg)", "angle residual (deg)"]);
  const [angles, residuals] = charts.map(valueAxis);
  assert.ok(angles.low < -49 && angles.high > 49, `${angles.low} ${angles.high}`);
  assert.ok(residuals.high - residuals.low < 0.1, `${residuals.low} ${residuals.high}`);
  // An axis that is made logarithmic is one of both.
  const logs = chartsOf({ ...app, logUnits: ["deg"] });
  assert.deepEqual(logs.map(({ isLog }) => isLog), [true, false]);
});

test("a motion is a line, readings and residuals are a mark each", () => {
  const run = fitted();
  const [angles, residuals] = chartsOf(appOf(run)).map((chart) => {
    const drawn = { lines: [], marks: 0 };
    const pen = {
      line: (points, { width }) => width === 1.5 && drawn.lines.push(points.length / 2),
      polygon: (points, { fill }) => (drawn.marks += fill === undefined ? 0 : 1),
      text: () => {},
      within: (_, draw) => draw(),
    };
    const area = { x: 0, y: 0, width: 800, height: 200 };
    const frame = chartFrame(valueAxis(chart), area, { across: [0, 1], hasLabels: true, left: 60 });
    drawChart(pen, chart, frame, LIGHT);
    return drawn;
  });
  assert.deepEqual(angles, { lines: [101], marks: 11 });
  assert.deepEqual(residuals, { lines: [], marks: 11 });
});
