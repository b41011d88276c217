// Curves: which are drawn, over the time or against another quantity, on linear and logarithmic axes.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { headOf, sampled, timesTo, workshop } from "../tests/support/scenes.js";
import { drawn, open, settle, skip, state, writeRuns } from "./support/browser.js";
import { everyWay as everyWayOf } from "./support/commands.js";

const CHART = ".charts figure > canvas";
/** The colours of the first two curves. */
const [FIRST, SECOND] = [[0, 103, 177], [213, 94, 0]];

/** A point on a circle of 2 m, once around in 4 s; columns that a logarithmic axis has to do with. */
function circle() {
  const body = { name: "stone", mass: 1, inertia: 1, depth: 0, ports: [{ name: "a", x: -0.2, y: 0, angle: 0 }, { name: "b", x: 0.2, y: 0, angle: 0 }], contour: null };
  const columns = [["across", "m"], ["up", "m"], ["decay", "Pa"], ["swing", "N"]].map(([name, unit]) => ({ name, unit }));
  const angle = (t) => (Math.PI / 2) * t;
  const head = headOf({ name: "Circle", bodies: [body] }, { columns });
  return sampled(
    head,
    timesTo(4, 0.01),
    (t) => [[2 * Math.cos(angle(t)), 2 * Math.sin(angle(t)), 0]],
    // From 1e6 to 1 Pa in 4 s; a sine, which is at or below zero in the second half.
    (t) => [2 * Math.cos(angle(t)), 2 * Math.sin(angle(t)), 10 ** (6 - 1.5 * t), Math.round(1e6 * Math.sin(angle(t))) / 1e6],
  );
}

const addresses = skip ? {} : { workshop: writeRuns("curves", [workshop()]), circle: writeRuns("circle", [circle()]), gap: writeRuns("gap", [workshop({ end: 2, gap: true })]) };
const everyWay = (id, check, how = {}) => everyWayOf(id, check, { address: addresses.circle, ...how });

const plot = (page, read) => page.evaluate(`((plot) => ${read})(window.plmPage.panel.tabs.get("curves").tab.plots[0])`);

/** The pixels of a chart that have the colour of a curve: their box, in shares of the frame, from the left and from below. */
async function boxOf(page, rgb) {
  const { frame } = await plot(page, "plot.frame");
  return page.evaluate(
    ([wanted, { x, y, width, height }]) => {
      const canvas = document.querySelector(".charts figure > canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const box = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity, count: 0 };
      for (let at = 0; at < data.length; at += 4) {
        if (data[at + 3] < 200 || wanted.some((part, index) => Math.abs(part - data[at + index]) > 12)) continue;
        const [u, v] = [(((at / 4) % canvas.width) - x) / width, 1 - (Math.floor(at / 4 / canvas.width) - y) / height];
        Object.assign(box, { left: Math.min(box.left, u), right: Math.max(box.right, u), low: Math.min(box.low, v), high: Math.max(box.high, v) });
        box.count++;
      }
      return box;
    },
    [rgb, frame],
  );
}

test("curves: chosen, read at the cursor, clicked to go there", { skip }, async () => {
  const { page } = await open(addresses.workshop);
  const one = await drawn(page, ".charts figure > canvas");
  assert.ok(one.ink > 500, `${one.ink}`);
  await page.click(".picker summary");
  await page.fill("input[type=search]", "force.y");
  assert.equal(await page.locator(".offers label").count(), 2);
  await page.check("[data-name='slot.force.y']");
  await settle(page);
  assert.equal(await page.locator(".charts figure").count(), 2, "a chart for each unit");
  assert.ok(await page.evaluate(() => document.activeElement.dataset.name === "slot.force.y"), "the focus stays");
  const canvas = page.locator(".charts figure > canvas").first();
  const before = await drawn(page);
  const box = await canvas.boundingBox();
  await page.mouse.click(box.x + 0.6 * box.width, box.y + 0.5 * box.height);
  await settle(page);
  const time = await state(page, "app.player.time");
  assert.ok(time > 1.5 && time < 2.7, `${time}`);
  assert.notEqual((await drawn(page)).hash, before.hash, "the picture goes along");
  const shown = await page.textContent(".legend .value");
  const value = await state(page, "app.run.valueAt(app.run.quantities()[0], app.run.momentAt(app.player.time))");
  assert.ok(Math.abs(Number(shown.replace("−", "-").split(" ")[0]) - value) < 0.01, `${shown} ${value}`);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.9 * box.width, box.y + 10);
  await page.mouse.up();
  assert.ok((await state(page, "app.player.time")) > time, "dragging goes along");
  // All that the first chart draws: those of one unit.
  for (let left = await page.locator(".charts figure >> nth=0 >> .legend .plain").count(); left > 0; left--) {
    await page.click(".charts figure >> nth=0 >> .legend .plain >> nth=0");
    await settle(page);
  }
  assert.equal(await page.locator(".charts figure").count(), 1);
});


test("a logarithmic axis: a line for what decays, by mouse and by keys, and in the address", { skip }, async () => {
  const linear = "#curves=decay";
  const isLogarithmic = async (page, message) => {
    const { low, high, isLog } = await plot(page, "plot.frame");
    assert.ok(isLog && low < 0 && low > -1 && high > 6 && high < 7, `${message}: ${low} to ${high} decades`);
    const label = await page.getAttribute(CHART, "aria-label");
    assert.match(label, /logarithmic/, message);
    // In the middle of the run the curve is in the middle: a line from corner to corner.
    const whole = await boxOf(page, FIRST);
    assert.ok(whole.left < 0.02 && whole.right > 0.98 && whole.low < 0.08 && whole.high > 0.92, `${message}: ${JSON.stringify(whole)}`);
    const at = await page.evaluate(() => {
      const [{ run, quantity }] = window.plmPage.panel.tabs.get("curves").tab.plots[0].chart.series;
      return Math.log10(run.valueAt(quantity, run.momentAt(2)));
    });
    assert.ok(Math.abs(at - 3) < 1e-9);
    assert.equal(await page.textContent(".missing"), "");
  };
  const { page } = await open(addresses.circle, { hash: linear });
  const before = await drawn(page, CHART);
  await page.click("button[data-unit=Pa]");
  await settle(page);
  await isLogarithmic(page, "by mouse");
  assert.notEqual((await drawn(page, CHART)).hash, before.hash);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.unit), "Pa", "the focus stays");
  assert.equal(await page.getAttribute("button[data-unit=Pa]", "aria-pressed"), "true");
  await page.waitForFunction(() => location.hash.includes("log=Pa"));
  const hash = await page.evaluate(() => location.hash);
  await isLogarithmic((await open(addresses.circle, { hash })).page, "by its address");
  await everyWay("log axes", async (each, act, message) => {
    await act();
    await isLogarithmic(each, message);
    await act();
    assert.ok(!(await plot(each, "plot.frame.isLog")), `${message}: and back`);
  }, { hash: linear });
});

test("values at or below zero are gaps of a logarithmic axis, and told", { skip }, async () => {
  const { page, errors } = await open(addresses.circle, { hash: "#curves=swing&log=N" });
  // A sine over one turn: zero at the beginning, in the middle and at the end, and below in the second half.
  assert.match(await page.textContent(".missing"), /^20[12] values at or below zero are not shown\.$/);
  const box = await boxOf(page, FIRST);
  assert.ok(box.count > 100 && box.left < 0.03 && box.right > 0.47 && box.right < 0.52, JSON.stringify(box));
  // There the cursor has no dot, and the legend says the value all the same.
  await page.evaluate(() => (window.plmPage.app.player.seek(3), window.plmPage.app.touch()));
  await settle(page);
  assert.equal((await boxOf(page, FIRST)).count, box.count);
  assert.match(await page.textContent(".legend .value"), /^−1 N$/);
  assert.deepEqual(errors, []);
});

test("a phase plot: a circle is round, and its point goes around with the time", { skip }, async () => {
  const isCircle = async (page, message) => {
    assert.equal(await plot(page, "plot.chart.series[0].across.name"), "across", message);
    const { from, to, low, high } = await plot(page, "plot.frame");
    // 2 m to each side, and 6 % of the range beyond.
    for (const [found, expected] of [[from, -2.24], [to, 2.24], [low, -2.24], [high, 2.24]]) {
      assert.ok(Math.abs(found - expected) < 1e-9, `${message}: ${from} ${to} ${low} ${high}`);
    }
    const { left, right, low: bottom, high: top } = await boxOf(page, FIRST);
    const margin = 0.06 / 1.12;
    for (const [found, expected] of [[left, margin], [right, 1 - margin], [bottom, margin], [top, 1 - margin]]) {
      assert.ok(Math.abs(found - expected) < 0.03, `${message}: ${left} ${right} ${bottom} ${top}`);
    }
    assert.match(await page.getAttribute(CHART, "aria-label"), /against across \(m\)/);
  };
  const { page, errors } = await open(addresses.circle, { hash: "#curves=up" });
  await page.selectOption("#across", "across");
  await settle(page);
  await isCircle(page, "by mouse");
  await page.waitForFunction(() => location.hash.includes("against=across"));
  const hash = await page.evaluate(() => location.hash);
  await isCircle((await open(addresses.circle, { hash })).page, "by its address");
  // A press near the top goes to the time at which the point is there: a quarter of the turn.
  const { frame } = await plot(page, "plot.frame");
  const canvas = await page.locator(CHART).boundingBox();
  const press = (u, v) => page.mouse.click(canvas.x + frame.x + u * frame.width, canvas.y + frame.y + (1 - v) * frame.height);
  for (const [u, v, expected] of [[0.5, 0.97, 1], [0.03, 0.5, 2], [0.5, 0.03, 3]]) {
    await press(u, v);
    await settle(page);
    const found = await state(page, "app.player.time");
    assert.ok(Math.abs(found - expected) < 0.06, `${found} instead of ${expected}`);
    // The cursor's point is drawn there, over the curve.
    const ink = await page.evaluate(([x, y]) => {
      const { data } = document.querySelector(".charts figure > canvas").getContext("2d").getImageData(x - 3, y - 3, 7, 7);
      return Array.from({ length: 49 }, (_, at) => data[4 * at + 2]).filter((part) => part === 177).length;
    }, [frame.x + (0.5 + (Math.cos((found * Math.PI) / 2) * 2) / 4.48) * frame.width, frame.y + (0.5 - (Math.sin((found * Math.PI) / 2) * 2) / 4.48) * frame.height].map(Math.round));
    assert.ok(ink > 25, `a point at ${found} s: ${ink} pixels`);
  }
  await page.selectOption("#across", "");
  await settle(page);
  assert.deepEqual([await plot(page, "plot.frame.from"), await plot(page, "plot.frame.to")], [0, 4], "and over the time again");
  await everyWay("phase plot", async (each, act, message) => {
    await act();
    await isCircle(each, message);
    await act();
    assert.equal(await state(each, "app.across"), null, `${message}: and back`);
  }, { hash: "#curves=across|up" });
  assert.deepEqual(errors, []);
});

test("a phase plot by the keys of its list", { skip }, async () => {
  const { page } = await open(addresses.circle, { hash: "#curves=up|across" });
  await page.focus("#across");
  await page.keyboard.press("ArrowDown");
  await settle(page);
  assert.equal(await state(page, "app.across"), "across");
  assert.ok((await boxOf(page, FIRST)).count > 300 && (await boxOf(page, SECOND)).count > 100, "a circle, and a line");
  const download = page.waitForEvent("download");
  await page.click("text=Save curves (SVG)");
  assert.match(readFileSync(await (await download).path(), "utf8"), />across \(m\)</);
});

test("of a million rows no peak is lost, however short", { skip }, async () => {
  const { page, errors } = await open(addresses.circle, { hash: "#curves=up" });
  const took = await page.evaluate(() => {
    const { app, panel } = window.plmPage;
    const { constructor: Run, head } = app.run;
    const run = Run.empty({ ...head, name: "long", events: [] });
    const [pose, values] = [[0, 0, 0, 0, 0, 0], [0, 0, 1, 0]];
    for (let row = 0; row < 1e6; row++) {
      // Each of these stands in one row alone.
      values[1] = row === 300_000 ? 5 : row === 700_001 ? -5 : Math.sin(row);
      run.append(row * 1e-6, pose, values);
    }
    app.showRuns([run]);
    app.curves = ["up"];
    app.change();
    const started = performance.now();
    panel.update();
    return performance.now() - started;
  });
  await settle(page);
  console.log(`1e6 rows: painted in ${Math.round(took)} ms`);
  // -5 to 5, and 6 % of the range beyond.
  const margin = 0.06 / 1.12;
  const { low, high } = await boxOf(page, FIRST);
  assert.ok(Math.abs(low - margin) < 0.02 && Math.abs(high - 1 + margin) < 0.02, `${low} ${high}`);
  for (const [time, share] of [[0.3, 0.97], [0.700001, 0.03]]) {
    const at = await page.evaluate(([t, v]) => {
      const { frame } = window.plmPage.panel.tabs.get("curves").tab.plots[0];
      const [x, y] = [frame.frame.x + t * frame.frame.width, frame.frame.y + (1 - v) * frame.frame.height];
      const { data } = document.querySelector(".charts figure > canvas").getContext("2d").getImageData(Math.round(x) - 2, Math.round(y) - 8, 5, 17);
      return data.filter((part, index) => index % 4 === 3 && part > 60 && data[index - 1] - data[index - 3] > 60).length;
    }, [time, share < 0.5 ? 0.1 : 0.9]);
    assert.ok(at > 8, `a peak at ${time} s: ${at} pixels`);
  }
  assert.deepEqual(errors, []);
});

test("what is no number is a gap", { skip }, async () => {
  const { page } = await open(addresses.gap, { hash: "#curves=rocker.angle&t=2" });
  // From 0.5 s to 0.8 s of 2 s.
  const columns = await page.evaluate(() => {
    const { frame } = window.plmPage.panel.tabs.get("curves").tab.plots[0].frame;
    const { data, width } = document.querySelector(".charts figure > canvas").getContext("2d").getImageData(frame.x, frame.y, frame.width, frame.height);
    const isOf = (at) => [0, 103, 177].every((part, index) => Math.abs(part - data[at + index]) < 30) && data[at + 3] > 150;
    const drawn = new Set();
    for (let at = 0; at < data.length; at += 4) if (isOf(at)) drawn.add((at / 4) % width);
    return Array.from({ length: width }, (_, x) => drawn.has(x));
  });
  const share = (from, to) => columns.slice(Math.ceil(from * columns.length), Math.floor(to * columns.length)).filter(Boolean).length;
  assert.equal(share(0.256, 0.394), 0, "nothing in the gap");
  assert.ok(share(0.02, 0.245) > 0.2 * columns.length && share(0.41, 0.98) > 0.5 * columns.length, "all before and after it");
});
