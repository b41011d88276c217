// What needs no browser: keys, commands, addresses, pictures as SVG.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addressOf, showAddress } from "../src/address.js";
import { App } from "../src/app.js";
import { COMMANDS, GROUPS } from "../src/commands.js";
import { curvesSvg } from "../src/charts.js";
import { keyName } from "../src/keys.js";
import { luminance, DARK, LIGHT } from "../src/palette.js";
import { pickAt, pictureSvg } from "../src/picture.js";
import { makeNpz } from "./support/npz.js";
import { doublePendulum, workshop } from "./support/scenes.js";

async function appOf(...made) {
  const app = new App();
  await app.load(new Uint8Array(makeNpz(made)));
  return app;
}

/** Whether pictures differ by no more than rounding of the address moves them. */
function samePicture(a, b) {
  const [first, second] = [a, b].map((text) => text.match(/-?\d+(\.\d+)?/g).map(Number));
  return first.length === second.length && first.every((value, at) => Math.abs(value - second[at]) < 0.03);
}

const count = (text, word) => text.split(word).length - 1;

test("no key has two meanings, and every command has one", () => {
  const keys = COMMANDS.flatMap((command) => command.keys);
  assert.equal(new Set(keys).size, keys.length, keys.sort().join(" "));
  for (const { name, keys: own, group } of COMMANDS) {
    assert.ok(own.length > 0, name);
    assert.ok(group in GROUPS, name);
  }
  assert.equal(new Set(COMMANDS.map(({ id }) => id)).size, COMMANDS.length);
});

test("the manual's shortcuts are there, each with a key that no browser keeps", () => {
  for (const key of "NORQABPSFE") {
    const command = COMMANDS.find(({ keys }) => keys.includes(`Ctrl+${key}`));
    assert.ok(command, key);
    assert.ok(command.keys.some((other) => !other.startsWith("Ctrl+")), command.name);
  }
});

test("keys are named as they are written", () => {
  const plain = { ctrlKey: false, metaKey: false, altKey: false, shiftKey: false };
  assert.equal(keyName({ ...plain, key: "o", ctrlKey: true }), "Ctrl+O");
  assert.equal(keyName({ ...plain, key: "O", shiftKey: true }), "Shift+O");
  assert.equal(keyName({ ...plain, key: "?", shiftKey: true }), "?");
  assert.equal(keyName({ ...plain, key: " " }), "Space");
  assert.equal(keyName({ ...plain, key: "ArrowLeft", shiftKey: true }), "Shift+ArrowLeft");
});

test("an address shows the same again", async () => {
  const made = () => [doublePendulum({ name: "a & b", end: 1 }), doublePendulum({ name: "two", end: 1 })];
  const app = await appOf(...made());
  app.activate(1);
  app.setLayout("overlay");
  app.player.seek(0.3125);
  app.player.speed = 0.2;
  app.player.isLooping = true;
  app.lookFrom("isometric");
  app.view.zoom(1.5);
  app.mode = "orbit";
  app.isWire = true;
  app.showsForces = true;
  app.curves = ["forearm.angle", "arm.x"];
  app.traces = ["forearm.tip"];
  app.selected = { kind: "part", index: 1 };
  app.background = "#102030";
  app.tab = "objects";
  const other = await appOf(...made());
  showAddress(other, `#${addressOf(app)}`);
  assert.equal(addressOf(other), addressOf(app));
  assert.deepEqual(
    [other.active, other.layout, other.player.time, other.isWire, other.curves, other.traces, other.selected, other.background],
    [1, "overlay", 0.3125, true, app.curves, app.traces, app.selected, "#102030"],
  );
  assert.ok(samePicture(pictureSvg(other), pictureSvg(app)), "the picture differs");
});

test("a foreign address does no harm", async () => {
  const app = await appOf(doublePendulum({ end: 1 }));
  const before = pictureSvg(app);
  showAddress(app, "#t=x&view=1,2&run=none&layout=what&select=body:99&curves=no|way&speed=-3&back=red&tab=&rate=0");
  assert.ok(pictureSvg(app) === before, "the picture differs");
  assert.deepEqual([app.curves, app.selected, app.player.speed, app.background], [[], null, 1, null]);
});

test("a picture has every body, and names in it are escaped", async () => {
  const made = workshop();
  made.head.mechanism.name = "<b>&";
  made.head.mechanism.bodies[1].ports[2].name = "<i>";
  const app = await appOf(made);
  app.select({ kind: "body", index: 1 });
  const svg = pictureSvg(app);
  assert.ok(count(svg, "<polygon") > 30 && count(svg, "<polyline") > 3, svg.slice(0, 300));
  assert.ok(!svg.includes("<i>") && svg.includes("&#60;i&#62;") && svg.includes("<title>&#60;b&#62;&#38;</title>"));
  assert.ok(!svg.includes("NaN") && !svg.includes("undefined"));
});

test("a saved picture has the colours of the dark theme where a reader prefers them", async () => {
  const app = await appOf(workshop());
  app.showsForces = true;
  const svg = pictureSvg(app);
  const style = svg.match(/<style>@media\(prefers-color-scheme:dark\){(.*)}<\/style>/)?.[1] ?? "";
  for (const [light, dark] of [[LIGHT.background, DARK.background], [LIGHT.ink, DARK.ink], [LIGHT.force, DARK.force]]) {
    assert.ok(style.includes(`[fill="${light}"]{fill:${dark}}[stroke="${light}"]{stroke:${dark}}`), `${light}: ${style}`);
  }
  assert.ok(!style.includes(LIGHT.velocity), "colours that are not drawn have no rule");
  app.theme = "dark";
  assert.ok(!pictureSvg(app).includes("<style>"), "a picture in the dark theme stays dark");
});

test("a run that faulted shows everything up to the fault, and the fault", async () => {
  const fault = { time: 2, part: "rocker_pin", text: "cannot be assembled" };
  const app = await appOf(workshop({ end: 2, fault }));
  assert.deepEqual(app.messages, [{ kind: "fault", text: "The run ended at 2.000 s: rocker_pin: cannot be assembled" }]);
  assert.equal(app.player.end, 2);
  const dashed = 'stroke-dasharray="6 5"';
  assert.equal(count(pictureSvg(app), dashed), 0);
  app.player.seek(2);
  assert.equal(count(pictureSvg(app), dashed), 1);
});

test("gaps stay gaps in the curves", async () => {
  const whole = await appOf(workshop({ end: 2 }));
  const gap = await appOf(workshop({ end: 2, gap: true }));
  for (const app of [whole, gap]) app.curves = ["rocker.angle"];
  const lines = (app) => count(curvesSvg(app), 'stroke-width="1.5"');
  assert.deepEqual([lines(whole), lines(gap)], [1, 2]);
});

test("runs overlaid are drawn over one another, side by side each in its place", async () => {
  const app = await appOf(...[5, 10, 20].map((mass) => doublePendulum({ name: `${mass} kg`, mass, end: 1 })));
  app.player.seek(1);
  const one = count(pictureSvg(app), "<polygon");
  app.setLayout("overlay");
  assert.ok(count(pictureSvg(app), "<polygon") > 2 * one);
  assert.equal(new Set(app.areas()).size, 1);
  app.setLayout("side");
  assert.equal(new Set(app.areas().map(({ x, y }) => `${x} ${y}`)).size, 3);
  const { x, y, width, height } = app.areas()[2];
  assert.equal(pickAt(app, x + width / 2, y + height / 2).index, 2);
  app.curves = ["arm.angle"];
  assert.equal(count(curvesSvg(app), 'stroke-width="1.5"'), 3);
});

test("a live run is followed as it grows", async () => {
  const app = await appOf(doublePendulum({ end: 1 }));
  const { run } = app;
  app.player.isFollowing = true;
  const last = [...run.poses.data.subarray(12 * 200, 12 * 201)];
  run.append(1.5, last, [0, 0, 0, 5000]);
  app.rowsAppended(run);
  assert.deepEqual([app.player.end, app.player.time], [1.5, 1.5]);
  assert.equal(app.runViews[0].forces.largest, 5000);
});

test("what cannot be read is told, and what was shown stays", async () => {
  const app = await appOf(doublePendulum({ end: 1 }));
  await app.load(new TextEncoder().encode("hello"));
  assert.equal(app.messages[0].kind, "error");
  assert.equal(app.run?.rows, 201);
});

test("texts can be read on every background", () => {
  const contrast = (a, b) => {
    const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (light + 0.05) / (dark + 0.05);
  };
  // WCAG 2.2: 4.5 for text, 3 for graphical objects.
  for (const palette of [LIGHT, DARK]) {
    for (const text of [palette.ink, palette.faint]) assert.ok(contrast(text, palette.background) >= 4.5, `${palette.name} ${text}`);
    for (const line of [...palette.curves, ...palette.trace, palette.force, palette.velocity, palette.fault]) {
      assert.ok(contrast(line, palette.background) >= 3, `${palette.name} ${line} ${contrast(line, palette.background)}`);
    }
  }
});
