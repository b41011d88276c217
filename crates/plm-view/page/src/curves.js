// The panel of curves: what to draw, charts of one unit each over a common axis, legends with the values now.

import { acrossRange, leftRoom, valueAxis } from "./axes.js";
import { ACROSS_AXIS, chartFrame, drawChart, drawCursor, drawEvents, drawSample, timeAt } from "./chart.js";
import { chartLabel, chartsOf, curvesSvg, missingText } from "./charts.js";
import { element, fitCanvas, saveBlob, setText } from "./dom.js";
import { CanvasPen } from "./pen.js";
import { fileStem } from "./picture.js";
import { PolarPlot } from "./polarpanel.js";
import { quantityText, withUnit } from "./text.js";

/** @import {App} from "./app.js" */
/** @import {Chart, Series} from "./axes.js" */
/** @import {ChartFrame} from "./chart.js" */
/** @import {Run} from "./run.js" */

/**
 * A chart on the page. `still` holds all but the cursor, and is painted when something of it has changed.
 * @typedef {{chart: Chart, canvas: HTMLCanvasElement, still: HTMLCanvasElement, painted: string, frame: ChartFrame | null,
 *   values: HTMLElement[], missing: HTMLElement, hasLabels: boolean}} Plot
 */

/** Height of a chart over the time, without the labels across, and against another quantity. */
const CHART_HEIGHT = 150;
const PHASE_HEIGHT = 240;
/** So many quantities are offered; the filter finds the others. */
const MOST_OFFERED = 150;
/** Curves of a run that grows are painted anew so often, ms. */
const REPAINT_EVERY = 120;

export class Curves {
  /**
   * @param {App} app
   * @param {HTMLElement} root
   */
  constructor(app, root) {
    this.app = app;
    this.revision = -1;
    /** @type {Plot[]} */
    this.plots = [];
    /** What was painted of runs that may grow, and when. */
    this.growth = { version: -1, at: 0, start: 0, end: 0 };
    this.filter = element("input", {
      type: "search",
      placeholder: "Filter, such as angle or force",
      "aria-label": "Filter quantities",
      oninput: () => this.listOffers(),
    });
    this.offers = element("div", { class: "offers", role: "group", "aria-label": "Quantities to draw" });
    this.summary = element("summary", {}, "Quantities");
    this.across = element("select", { id: "across", onchange: () => this.drawAgainst(this.across.value) });
    /** The run whose quantities `across` offers. @type {Run | null} */
    this.offered = null;
    this.charts = element("div", { class: "charts" });
    this.polar = new PolarPlot(app);
    root.append(
      element("details", { class: "picker" }, this.summary, this.filter, this.offers),
      element("label", { class: "across" }, "Against", this.across),
      this.charts,
      element("div", { class: "row" }, element("button", { type: "button", onclick: () => saveCurves(this.app) }, "Save curves (SVG)")),
      this.polar.root,
    );
  }

  update() {
    const { app } = this;
    if (this.revision !== app.revision) {
      this.revision = app.revision;
      this.listOffers();
      this.offerAcross();
      this.build();
    }
    this.watchGrowth();
    const stale = this.plots.filter((plot) => plot.painted !== this.wanted(plot));
    // One range may ask for more room on the left of all.
    if (stale.length > 0) this.paint();
    for (const plot of this.plots) this.draw(plot);
    this.polar.update();
  }

  /** Curves that grow are painted now and then. */
  watchGrowth() {
    const { app } = this;
    const now = performance.now();
    const version = app.visible().reduce((sum, { run }) => sum + run.version, 0);
    if (version !== this.growth.version && now - this.growth.at <= REPAINT_EVERY) {
      // The last rows of a run that stops to grow are painted too.
      setTimeout(() => app.touch(), REPAINT_EVERY);
      return;
    }
    const { start, end } = app.player;
    this.growth = { version, at: version === this.growth.version ? this.growth.at : now, start, end };
  }

  /** What the still part of a plot depends on. @param {Plot} plot */
  wanted({ canvas }) {
    const { palette } = this.app;
    const { version, start, end } = this.growth;
    const colours = `${palette.name}${palette.background}`;
    return [canvas.clientWidth, colours, start, end, version, window.devicePixelRatio].join(" ");
  }

  /** Paints all but the cursors. */
  paint() {
    const { app } = this;
    const { palette, player } = app;
    const axes = this.plots.map(({ chart }) => valueAxis(chart));
    const left = leftRoom(axes);
    const across = acrossRange(this.plots.map(({ chart }) => chart), [player.start, player.end]);
    this.plots.forEach((plot, at) => {
      const { chart, canvas, still, hasLabels } = plot;
      const [width, height] = [canvas.clientWidth, chartHeight(plot)];
      plot.painted = this.wanted(plot);
      if (width === 0) return;
      const context = fitCanvas(still, width, height);
      context.clearRect(0, 0, width, height);
      const pen = new CanvasPen(context);
      const area = { x: 0, y: 0, width, height };
      plot.frame = chartFrame(axes[at], area, { across, hasLabels, left });
      drawChart(pen, chart, plot.frame, palette);
      if (app.run !== null && app.across === null) drawEvents(pen, plot.frame, app.run, palette);
      setText(plot.missing, missingText(chart));
    });
  }

  listOffers() {
    const { app } = this;
    const words = this.filter.value.toLowerCase().split(/\s+/).filter((word) => word !== "");
    const all = app.run?.quantities() ?? [];
    const found = all.filter(({ name }) => words.every((word) => name.toLowerCase().includes(word)));
    const offers = found.slice(0, MOST_OFFERED).map(({ name, unit }) =>
      element(
        "label",
        {},
        element("input", {
          type: "checkbox",
          checked: app.curves.includes(name),
          "data-name": name,
          onchange: () => this.choose(name),
        }),
        withUnit(name, unit),
      ),
    );
    const more = found.length - offers.length;
    this.offers.replaceChildren(...offers, ...(more > 0 ? [element("p", {}, `and ${more} more: type to filter`)] : []));
    setText(this.summary, `Quantities (${app.curves.length} of ${all.length} drawn)`);
  }

  /** What curves can be drawn against. */
  offerAcross() {
    const { app, across } = this;
    if (this.offered !== app.run) {
      this.offered = app.run;
      const names = app.run?.quantities().map(({ name, unit }) => element("option", { value: name }, withUnit(name, unit))) ?? [];
      across.replaceChildren(element("option", { value: "" }, "time (s)"), ...names);
    }
    across.value = app.across ?? "";
    across.disabled = app.run === null;
  }

  /** @param {string} name of a quantity; empty for the time */
  drawAgainst(name) {
    this.app.across = name === "" ? null : name;
    this.app.change();
  }

  /** @param {string} name */
  choose(name) {
    this.app.toggleName(this.app.curves, name);
    // The list has been built anew: the box that was pressed keeps the focus.
    this.update();
    const box = [...this.offers.querySelectorAll("input")].find((input) => input.dataset["name"] === name);
    box?.focus();
  }

  build() {
    const charts = chartsOf(this.app);
    this.plots = charts.map((chart, at) => ({
      chart,
      canvas: element("canvas", { role: "img", "aria-label": chartLabel(chart) }),
      still: document.createElement("canvas"),
      painted: "",
      frame: null,
      values: chart.series.map(() => element("span", { class: "value" })),
      missing: element("p", { class: "hint missing" }),
      hasLabels: at === charts.length - 1,
    }));
    const figures = this.plots.map((plot) => {
      plot.canvas.style.height = `${chartHeight(plot)}px`;
      this.listen(plot);
      return element("figure", {}, this.legend(plot), plot.canvas, plot.missing);
    });
    const hint = this.app.run === null ? "" : "No curve is chosen. Open “Quantities” above.";
    this.charts.replaceChildren(...(figures.length > 0 ? figures : [element("p", { class: "hint" }, hint)]));
  }

  /** @param {Plot} plot */
  legend({ chart, values }) {
    const manyRuns = this.app.visible().length > 1;
    const entries = chart.series.map((series, at) => {
      const { run, quantity } = series;
      const swatch = sampleOf(series);
      const name = manyRuns ? `${quantity.name}, ${run.name}` : quantity.name;
      const remove = element(
        "button",
        { type: "button", class: "plain", title: `Remove ${quantity.name}`, "aria-label": `Remove ${quantity.name}`, onclick: () => this.choose(quantity.name) },
        "×",
      );
      return element("li", {}, swatch, element("span", {}, name), values[at], remove);
    });
    return element("ul", { class: "legend" }, ...entries, element("li", { class: "scale" }, this.scaleButton(chart)));
  }

  /** Switches the axis of a chart. @param {Chart} chart */
  scaleButton({ key, isLog }) {
    const name = `Logarithmic axis${key === "" ? "" : `, ${withUnit("", key)}`}`;
    const act = () => {
      this.app.toggleName(this.app.logUnits, key);
      // The charts have been built anew: the button that was pressed keeps the focus.
      this.update();
      const button = [...this.charts.querySelectorAll("button")].find((candidate) => candidate.dataset["unit"] === key);
      button?.focus();
    };
    const pressed = String(isLog);
    return element("button", { type: "button", "data-unit": key, title: name, "aria-label": name, "aria-pressed": pressed, onclick: act }, "log");
  }

  /** A press goes to its time, and dragging goes along. @param {Plot} plot */
  listen(plot) {
    const { canvas } = plot;
    const go = (/** @type {PointerEvent} */ event) => {
      if (plot.frame === null) return;
      this.app.player.stop();
      const { left, top } = canvas.getBoundingClientRect();
      this.app.player.seek(timeAt(plot.chart, plot.frame, event.clientX - left, event.clientY - top));
      this.app.touch();
    };
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      go(event);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0) go(event);
    });
  }

  /** @param {Plot} plot */
  draw(plot) {
    const { app } = this;
    const { chart, canvas, still } = plot;
    const { clientWidth: width } = canvas;
    const height = chartHeight(plot);
    if (width === 0) return;
    const { palette, player } = app;
    const context = fitCanvas(canvas, width, height);
    context.clearRect(0, 0, width, height);
    context.drawImage(still, 0, 0, width, height);
    if (plot.frame !== null) drawCursor(new CanvasPen(context), chart, plot.frame, palette, player.time);
    chart.series.forEach((series, at) => setText(plot.values[at], valueNow(series, player.time)));
  }
}

/** A piece of a curve, or a mark, for its name. @param {Series} series */
function sampleOf(series) {
  const swatch = element("canvas", { class: "swatch", "aria-hidden": "true" });
  drawSample(new CanvasPen(fitCanvas(swatch, 24, 8)), series, [1, 23], 4);
  return swatch;
}

/** @param {Series} series @param {number} time */
function valueNow({ run, quantity }, time) {
  if (time > run.end) return "–";
  return quantityText(run.valueAt(quantity, run.momentAt(time)), quantity.unit);
}

/** @param {Plot} plot */
function chartHeight({ chart, hasLabels }) {
  const isPhase = chart.series.some(({ across }) => across !== null);
  return (isPhase ? PHASE_HEIGHT : CHART_HEIGHT) + (hasLabels ? ACROSS_AXIS - 8 : 0);
}

/** @param {App} app */
function saveCurves(app) {
  saveBlob(new Blob([curvesSvg(app)], { type: "image/svg+xml" }), `${fileStem(app)}-curves.svg`);
}
