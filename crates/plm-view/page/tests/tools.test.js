// Tools without a browser: instant centres, measures, ghost poses, stretches, polar plots, each against a closed form; the history.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addressOf, showAddress } from "../src/address.js";
import { App } from "../src/app.js";
import { centrodes, inBody, instantCentre, motionOf } from "../src/centres.js";
import { ghostTimes } from "../src/ghosts.js";
import { measured, measureName, measureOf, measureQuantity, namedMarks, unitOf, withMark } from "../src/measure.js";
import { hermite, hermiteRate } from "../src/numbers.js";
import { pictureSvg } from "../src/picture.js";
import { polarCurve, polarPoints } from "../src/polar.js";
import { readResults } from "../src/results.js";
import { loopOf, turningBody, turnOf } from "../src/stretch.js";
import { makeNpz } from "./support/npz.js";
import { headOf, sampled, timesTo, workshop } from "./support/scenes.js";

const read = async (made) => (await readResults(new Uint8Array(makeNpz([made])))).runs[0];
const bar = (name, ports = []) => ({ name, mass: 1, inertia: 0.01, depth: 0, contour: null, ports });
const port = (name, x, y) => ({ name, x, y, angle: 0 });

async function appOf(made) {
  const app = new App();
  await app.load(new Uint8Array(makeNpz([made])));
  return app;
}

/** Motions of all bodies at a time. */
function motionsAt(run, time) {
  const [moment, poses] = [run.momentAt(time), new Float64Array(3 * run.mechanism.bodies.length)];
  run.posesAt(moment, poses);
  return run.mechanism.bodies.map((_, body) => motionOf(run, moment, body, poses));
}

const near = (a, b, most, what = "") => assert.ok(Math.hypot(...a.map((value, at) => value - b[at])) < most, `${what} ${a} is ${b}`);

const LADDER = 2;
/** A ladder slides down a wall: its foot at (L sin φ, 0), its head at (0, L cos φ). */
const ladder = (rate = 50) =>
  sampled(headOf({ name: "Ladder", bodies: [bar("ladder", [port("foot", 1, 0), port("head", -1, 0)])] }), timesTo(1, 1 / rate), (t) => {
    const phi = 0.3 + 0.8 * t;
    return [[0.5 * LADDER * Math.sin(phi), 0.5 * LADDER * Math.cos(phi), phi - Math.PI / 2]];
  });

test("the centre of a sliding ladder is where the normals at its ends meet", async () => {
  const run = await read(ladder());
  // On rows, and between them.
  for (const time of [0, 0.02, 0.5, 0.513, 0.9999, 1]) {
    const phi = 0.3 + 0.8 * time;
    near(instantCentre(motionsAt(run, time)[0]), [LADDER * Math.sin(phi), LADDER * Math.cos(phi)], 2e-5, `at ${time}`);
  }
  // Cardan's circles: the fixed one of radius L around the corner, the moving one of half that around the middle.
  const { fixed, moving } = centrodes(run, 0, 10);
  assert.equal(fixed.length, 1);
  for (let at = 0; at < fixed[0].length; at += 2) {
    assert.ok(Math.abs(Math.hypot(fixed[0][at], fixed[0][at + 1]) - LADDER) < 1e-9);
    assert.ok(Math.abs(Math.hypot(moving[0][at], moving[0][at + 1]) - LADDER / 2) < 1e-9);
  }
  // One rolls on the other: both are as long.
  const length = (line) => line.slice(2).reduce((sum, _, at) => (at % 2 === 0 ? sum + Math.hypot(line[at + 2] - line[at], line[at + 3] - line[at + 1]) : sum), 0);
  assert.ok(Math.abs(length(fixed[0]) - length(moving[0])) < 1e-3);
});

test("a wheel that rolls has its centre on the ground, and one that slides has none", async () => {
  const radius = 0.35;
  const run = await read(
    sampled(headOf({ name: "Wheels", bodies: [bar("rolling"), bar("sliding")] }), timesTo(2, 0.1), (t) => [[radius * 2 * t, radius, -2 * t], [t, 1, 0.3]]),
  );
  for (const time of [0, 0.55, 2]) {
    const [rolling, sliding] = motionsAt(run, time);
    near(instantCentre(rolling), [radius * 2 * time, 0], 1e-7);
    near(inBody(rolling, instantCentre(rolling)), [radius * Math.sin(2 * time), -radius * Math.cos(2 * time)], 1e-6, "on the rim");
    const centre = instantCentre(sliding);
    assert.ok(centre === null || Math.hypot(...centre) > 1e6, `${centre}`);
  }
  assert.deepEqual(centrodes(run, 1, 100).fixed, []);
});

test("a recording without rates has those of its differences", async () => {
  const made = ladder();
  made.poses = made.poses.map((value, at) => (at % 6 < 3 ? value : NaN));
  const run = await read(made);
  const phi = 0.3 + 0.8 * 0.51;
  near(instantCentre(motionsAt(run, 0.51)[0]), [LADDER * Math.sin(phi), LADDER * Math.cos(phi)], 1e-3);
  // The rate is the derivative of what is drawn.
  const [cubic, step] = [(share) => hermite(share, 0.2, 1, 3, 1.4, -2), 1e-6];
  for (const share of [0, 0.3, 0.8, 1]) {
    const slope = (cubic(share + step) - cubic(share - step)) / (2 * step * 0.2);
    assert.ok(Math.abs(hermiteRate(share, 0.2, 1, 3, 1.4, -2) - slope) < 1e-6, `${share}`);
  }
});

test("three centres of a four-bar are on one line, and two of them are its pins", async () => {
  const run = await read(workshop());
  const [crank, coupler, rocker] = [0, 1, 2];
  for (const time of [0.3, 1.237, 2.9]) {
    const motions = motionsAt(run, time);
    near(instantCentre(motions[crank]), [0, 0], 1e-6, "the crank turns around its pin");
    near(instantCentre(motions[rocker]), [1, -0.1], 1e-5, "the rocker turns around its pin");
    const pin = [0.3 * Math.cos(0.4 + Math.PI * time), 0.3 * Math.sin(0.4 + Math.PI * time)];
    near(instantCentre(motions[crank], motions[coupler]), pin, 1e-5, "crank and coupler turn around theirs");
    // Kennedy: of each three bodies, the three centres are on one line.
    for (const [a, b] of [[crank, rocker], [crank, coupler], [coupler, rocker]]) {
      const [p, q, r] = [instantCentre(motions[a]), instantCentre(motions[b]), instantCentre(motions[a], motions[b])];
      const area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
      const sizes = Math.hypot(q[0] - p[0], q[1] - p[1]) * Math.hypot(r[0] - p[0], r[1] - p[1]);
      assert.ok(Math.abs(area) < 1e-5 * Math.max(1, sizes), `${a} ${b} at ${time}: ${area}`);
    }
    // The centre of crank and rocker divides the line of their pins by their speeds.
    const [x] = instantCentre(motions[crank], motions[rocker]);
    assert.ok(Math.abs(motions[crank].omega * x - motions[rocker].omega * (x - 1)) < 1e-4);
  }
});

/** A parallelogram with cranks of 0.5: its coupler stays level. */
const parallelogram = (more = {}) =>
  sampled(
    headOf({
      name: "Parallelogram",
      bodies: [bar("left", [port("foot", -0.25, 0), port("pin", 0.25, 0)]), bar("right", [port("foot", -0.25, 0), port("pin", 0.25, 0)]), bar("coupler", [port("a", -0.6, 0), port("b", 0.6, 0)])],
      ground: [{ ...port("o", 0, 0), depth: 0 }, { ...port("p", 1.2, 0), depth: 0 }],
      ...more,
    }),
    timesTo(2, 0.05),
    (t) => {
      const [c, s] = [Math.cos(Math.PI * t), Math.sin(Math.PI * t)];
      return [[0.25 * c, 0.25 * s, Math.PI * t], [1.2 + 0.25 * c, 0.25 * s, Math.PI * t], [0.6 + 0.5 * c, 0.5 * s, 0]];
    },
  );

test("a distance across a parallelogram stays, another follows the cosine law", async () => {
  const run = await read(parallelogram());
  const quantity = (name) => measureQuantity(run, measureOf(run.mechanism, name));
  const [between, diagonal, turn] = ["distance(left.pin,right.pin)", "distance(left.pin,ground.p)", "angle(left,right)"].map(quantity);
  const corner = quantity("angle(right.pin,left.pin,left.foot)");
  for (let row = 0; row < run.rows; row++) {
    const angle = Math.PI * run.time.data[row];
    assert.ok(Math.abs(between.read(row) - 1.2) < 1e-12);
    assert.ok(Math.abs(diagonal.read(row) - Math.sqrt(0.25 + 1.44 - 1.2 * Math.cos(angle))) < 1e-12);
    assert.ok(Math.abs(turn.read(row)) < 1e-9);
    // From the level coupler to the crank seen from its pin.
    const expected = ((((angle * 180) / Math.PI + 180) % 360) + 360) % 360;
    const found = ((corner.read(row) % 360) + 360) % 360;
    assert.ok(Math.min(Math.abs(found - expected), 360 - Math.abs(found - expected)) < 1e-9, `${found} is ${expected}`);
  }
  assert.deepEqual([between.unit, corner.unit], ["m", "deg"]);
});

test("measures have declared units, and names that an address can hold", async () => {
  const reach = { name: "reach", unit: "mm", factor: 1e-3, exponents: [1, 0, 0, 0, 0, 0, 0], default: 1, value: 1 };
  const run = await read(parallelogram({ parameters: [{ ...reach, name: "speed", unit: "m/s", factor: 1, exponents: [1, 0, -1, 0, 0, 0, 0] }, reach] }));
  assert.deepEqual(unitOf(run, "distance"), { unit: "mm", factor: 1e-3 });
  const { mechanism } = run;
  for (const name of ["distance(left.pin,ground.p)", "angle(left,coupler)", "distance(left(0.1;-0.02),right.G)", "angle(left.pin,ground.o,right.pin)"]) {
    assert.equal(measureName(measureOf(mechanism, name)), name);
  }
  for (const name of ["distance(left.pin)", "distance(left,right)", "angle(left.pin,right)", "distance(left.pin,nothing.at)", "x", "angle(left.pin,ground.o)"]) {
    const measure = measureOf(mechanism, name);
    assert.ok(measure === null, `${name}: ${JSON.stringify(measure)}`);
  }
  assert.ok(Math.abs(measureQuantity(run, measureOf(mechanism, "distance(left.foot,left.pin)")).read(3) - 500) < 1e-9);
  const [a, b, c] = namedMarks(mechanism);
  assert.deepEqual(withMark("distance", withMark("distance", [], a), b), [a, b]);
  assert.deepEqual(withMark("distance", [a, b], c), [c], "a third point begins anew");
  assert.deepEqual(withMark("distance", [a], a), [a], "one point is no distance");
  const places = { poses: new Float64Array([0, 0, 3, 0, 0, -3, 0, 0, 0]), ground: new Float64Array(6) };
  assert.ok(Math.abs(measured(measureOf(mechanism, "angle(left,right)"), places, mechanism) - (2 * Math.PI - 6)) < 1e-12);
});

test("ghost poses are at equal intervals; of a live run the last ones, which stand still", async () => {
  const run = await read(workshop());
  assert.deepEqual(ghostTimes(run, 5), [0, 1, 2, 3, 4]);
  assert.deepEqual(ghostTimes(run, 1), [4]);
  run.isLive = true;
  const last = ghostTimes(run, 3);
  assert.ok(last.length === 3 && last.every((time) => Math.abs(10 * time - Math.round(10 * time)) < 1e-9 && time <= run.end), `${last}`);
});

test("one turn of a crank and the loop of a mechanism have its period", async () => {
  const run = await read(workshop());
  for (const from of [0, 0.37, 1.9]) {
    const turn = turnOf(run, 0, from);
    assert.ok(Math.abs(turn.to - turn.from - 2) < 1e-9, `${turn.from} to ${turn.to}`);
    const loop = loopOf(run, from);
    assert.ok(Math.abs(loop.to - loop.from - 2) < 1e-9, `${loop.from} to ${loop.to}`);
  }
  // Near the end the turn before is shown.
  assert.ok(Math.abs(turnOf(run, 0, 3.5).from - 2) < 1e-9);
  assert.equal(turnOf(run, 2, 0), null, "a rocker makes no turn");
  assert.equal(turningBody(run, 2, 0), 0);
  // Rows with angles between -π and π, of a crank that turns backwards.
  const back = await read(
    sampled(headOf({ name: "Back", bodies: [bar("crank")] }), timesTo(3, 0.1), (t) => [[0, 0, -2.5 * t]]),
  );
  back.poses.data.forEach((value, at) => {
    if (at % 6 === 2) back.poses.data[at] = Math.atan2(Math.sin(value), Math.cos(value));
  });
  const reversed = turnOf(back, 0, 0.2);
  assert.ok(Math.abs(reversed.to - reversed.from - (2 * Math.PI) / 2.5) < 1e-9, `${reversed.to}`);
  assert.equal(turningBody(await read(ladder()), null, 0), null);
  assert.equal(loopOf(await read(ladder()), 0), null);
});

test("a hodograph has the recorded vectors, and a polar plot their sizes", async () => {
  const run = await read(workshop());
  // A force of 40 cos α and 25 sin 2α.
  const vector = polarPoints(run, polarCurve(run, { joint: "crank_coupler", body: null }));
  assert.equal(vector.pieces.length, 1);
  vector.pieces[0].forEach((value, at) => {
    const turn = 0.4 + Math.PI * run.time.data[at >> 1];
    assert.ok(Math.abs(value - (at % 2 === 0 ? 40 * Math.cos(turn) : 25 * Math.sin(2 * turn))) < 1e-9);
  });
  const { pieces, largest } = polarPoints(run, polarCurve(run, { joint: "slot", body: "crank" }));
  for (let at = 0; at < pieces[0].length; at += 2) {
    const turn = 0.4 + Math.PI * run.time.data[at >> 1];
    near(pieces[0].slice(at, at + 2).map((value) => value / Math.hypot(12 * Math.sin(turn), 18 * Math.cos(turn))), [Math.cos(turn), Math.sin(turn)], 1e-9);
  }
  assert.ok(largest > 17.9 && largest <= 18);
  assert.equal(polarCurve(run, { joint: "rail", body: null }), null);
});

test("tools are in the address, and in the picture", async () => {
  const app = await appOf(workshop());
  const plain = pictureSvg(app);
  assert.ok(!/ghosts|centre|measure|polar/.test(addressOf(app)));
  app.tools = { ghosts: 7, centres: true, centrodes: true, pair: ["crank", "rocker"], measures: ["distance(crank.b,rocker.tip)", "angle(crank,rocker)"], force: "slot", around: "crank" };
  app.change();
  app.curves = ["distance(crank.b,rocker.tip)"];
  const picture = pictureSvg(app);
  for (const text of ["crank–rocker", "°", " m<"]) assert.ok(text === "°" ? / deg</.test(picture) : picture.includes(text), text);
  assert.ok(picture.length > 2 * plain.length);
  const other = await appOf(workshop());
  showAddress(other, addressOf(app));
  assert.deepEqual([other.tools, other.curves], [app.tools, app.curves]);
  assert.equal(pictureSvg(other).length, picture.length);
  showAddress(other, "#ghosts=1e9&pair=crank|nobody&measures=distance(x,y)&polar=nothing&around=nobody&mode=angle");
  assert.deepEqual(other.tools, { ghosts: 60, centres: false, centrodes: false, pair: [], measures: [], force: "", around: "" });
  assert.equal(other.mode, "angle");
});

test("what was shown is undone and done again, and what changed by itself is not", async (t) => {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const app = await appOf(workshop());
  const { history } = app;
  const act = (change) => {
    history.hasActed = true;
    change();
    app.change();
    history.update();
  };
  history.update();
  const before = [...app.curves];
  act(() => app.toggleName(app.curves, "rail.displacement"));
  act(() => (app.tools.centres = true));
  // Nobody has asked for this.
  app.showsForces = true;
  history.update();
  act(() => (app.tools.measures = ["angle(crank,rocker)"]));
  assert.deepEqual(history.done.map(({ name }) => name), ["curves", "instant centres", "measures"]);
  assert.deepEqual(history.done, JSON.parse(JSON.stringify(history.done)), "deeds are values");
  history.undo();
  assert.deepEqual([app.tools.measures, app.tools.centres], [[], true]);
  history.update();
  history.undo();
  history.undo();
  assert.deepEqual([app.curves, app.tools.centres, app.showsForces], [before, false, true]);
  history.redo();
  history.redo();
  history.redo();
  assert.deepEqual([app.tools.centres, app.tools.measures], [true, ["angle(crank,rocker)"]]);
  history.redo();
  assert.match(app.messages.at(-1).text, /Nothing/);
  history.undo();
  act(() => (app.isWire = true));
  assert.equal(history.undone.length, 0, "what is done anew ends what was undone");
  // A slider that is drawn is one deed.
  for (let count = 1; count < 9; count++) act(() => (app.tools.ghosts = count));
  history.undo();
  assert.equal(app.tools.ghosts, 0);
  assert.equal(app.isWire, true);
});
