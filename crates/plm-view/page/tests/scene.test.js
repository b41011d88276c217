import assert from "node:assert/strict";
import { test } from "node:test";
import { areaOf, convexHull, isInside, roundedHull } from "../src/outline.js";
import { readResults } from "../src/results.js";
import { SvgPen } from "../src/pen.js";
import { pickItem } from "../src/pick.js";
import { placePieces } from "../src/place.js";
import { Scene } from "../src/scene.js";
import { framePose, outlineAt } from "../src/solid.js";
import { PRESETS, View } from "../src/view.js";
import { makeNpz } from "./support/npz.js";
import { chain, doublePendulum, headOf, looks, sampled, workshop } from "./support/scenes.js";

const AREA = { x: 0, y: 0, width: 800, height: 600 };

async function sceneOf(made) {
  const { runs } = await readResults(new Uint8Array(makeNpz([made])));
  const scene = new Scene(runs[0]);
  scene.extents();
  return scene;
}

const piecesOf = (scene, name) => {
  const index = scene.mechanism.parts.findIndex((part) => part.name === name);
  return scene.pieces.filter(({ item }) => item.kind === "part" && item.index === index);
};

test("a rounded hull keeps its distance", () => {
  for (const points of [[[1, 2]], [[0, 0], [3, 1]], [[0, 0], [4, 0], [4, 3], [1, 1]]]) {
    const outline = roundedHull(points, 0.5);
    assert.ok(areaOf(outline) > 0, "its inside is on the left");
    for (let at = 0; at < outline.length; at += 2) {
      const nearest = Math.min(...points.map(([x, y]) => Math.hypot(outline[at] - x, outline[at + 1] - y)));
      assert.ok(Math.abs(nearest - 0.5) < 1e-12, `${nearest}`);
    }
    for (const [x, y] of points) assert.ok(isInside(outline, x, y));
  }
});

test("a hull has corners alone", () => {
  const hull = convexHull([[0, 0], [1, 0], [2, 0], [2, 2], [0, 2], [1, 1], [0, 0]]);
  assert.deepEqual(hull, [[0, 0], [2, 0], [2, 2], [0, 2]]);
});

test("joints to the ground are of its tone, others of another", async () => {
  const scene = await sceneOf(workshop());
  const tones = (name) => [...new Set(piecesOf(scene, name).map(({ tone }) => tone))].sort();
  assert.deepEqual(tones("crank_pin"), ["ground", "mount"]);
  assert.deepEqual(tones("crank_coupler"), ["joint"]);
  assert.deepEqual(tones("rail"), ["body", "ground"]);
  assert.deepEqual(tones("slot"), ["groove", "joint"]);
  assert.deepEqual(tones("ram"), ["cylinder", "ground", "joint", "mount", "rod"]);
  assert.deepEqual(tones("strut"), ["ground", "joint", "mount", "spring"]);
});

test("a pin has its diameter and stands in its joint", async () => {
  const scene = await sceneOf(workshop());
  const places = scene.at(0.7);
  const pin = piecesOf(scene, "crank_coupler").find(({ side }) => side === 1);
  const [x, y] = framePose(scene.mechanism, scene.mechanism.parts[1].frames[0], places);
  const outline = outlineAt(pin, places);
  for (let at = 0; at < outline.length; at += 2) {
    assert.ok(Math.abs(Math.hypot(outline[at] - x, outline[at + 1] - y) - 0.02) < 1e-12);
  }
});

test("the wider side of a jack is its cylinder, the other its rod: piston at the first frame, rod at the second", async () => {
  for (const [sizes, cylinderAt] of [[{ piston: 0.09, rod: 0.04 }, 0], [{ piston: 0.04, rod: 0.09 }, 1]]) {
    const made = workshop();
    const ram = made.head.mechanism.parts.find(({ name }) => name === "ram");
    Object.assign(ram.sizes, sizes);
    const scene = await sceneOf(made);
    const places = scene.at(0.7);
    const ends = ram.frames.map((frame) => framePose(scene.mechanism, frame, places));
    const [cylinder, rod] = ["cylinder", "rod"].map((tone) =>
      outlineAt(piecesOf(scene, "ram").find((piece) => piece.tone === tone), places),
    );
    const width = (outline) => Math.hypot(outline[0] - outline[6], outline[1] - outline[7]);
    assert.ok(Math.abs(width(cylinder) - 0.09) < 1e-12 && Math.abs(width(rod) - 0.04) < 1e-12);
    const [a, b] = [ends[cylinderAt], ends[1 - cylinderAt]];
    const near = (outline, [x, y]) => isInside(outline, x, y) || Math.hypot(outline[2] - x, outline[3] - y) < 0.03;
    assert.ok(near(cylinder, a) && !isInside(cylinder, b[0], b[1]), "cylinder");
    assert.ok(near(rod, b) && !isInside(rod, a[0], a[1]), "rod");
  }
});

test("shapes stand where the declaration of their part puts them", async () => {
  const scene = await sceneOf(looks());
  const places = scene.at(1);
  const [circle, outline, mark, line, steps, level] = piecesOf(scene, "tread");
  const near = (found, wanted) => wanted.forEach((value, at) => assert.ok(Math.abs(found[at] - value) < 1e-12, `${found} is not ${wanted}`));
  const points = (piece) => outlineAt(piece, places);
  const [x, y, angle] = [0.2, 0.2, -1];
  const moved = ([u, v]) => [x + Math.cos(angle) * u - Math.sin(angle) * v, y + Math.sin(angle) * u + Math.cos(angle) * v];
  // The radius that shows how it turns, from 0.8 of it on.
  near(points(circle), moved([0.16, 0]));
  for (let at = 2; at < points(circle).length; at += 2) assert.ok(Math.abs(Math.hypot(points(circle)[at] - x, points(circle)[at + 1] - y) - 0.2) < 1e-12);
  // Its inside is on the left, however it was written.
  near(points(outline), [[0.15, 0], [0, 0.15], [0, 0]].flatMap(moved));
  assert.deepEqual([outline.tone, outline.body], ["body", 0]);
  // In half widths of a bar, from 0.1 m along the axis on.
  near(points(mark), [[0.1 + scene.radius, 0], [0.1, scene.radius], [0.1, -scene.radius]].flatMap(moved));
  // To the hub: shares of the way along it, half a bar's width across.
  const way = Math.hypot(x, y);
  near(points(line), [0, 0, x / 2 - (scene.radius * y) / way, y / 2 + (scene.radius * x) / way, x, y]);
  // The solid is on the right of the steps.
  near(points(steps).slice(8), [1.4, 0.1, 1, 0.1, 1, 0, -0.3, 0]);
  assert.ok(isInside(points(steps), 0.5, -0.5 * scene.radius) && !isInside(points(steps), 0.5, 0.5 * scene.radius));
  // The axis goes as far as the wheel has been seen, 0.4 m, and 4 half widths on.
  const ends = points(level).filter((_, at) => at % 2 === 0);
  near([Math.min(...ends), Math.max(...ends)], [-4 * scene.radius, 0.4 + 4 * scene.radius]);
});

test("a hole of a contour is open: not filled, not picked, and it widens nothing", async () => {
  const scene = await sceneOf(looks());
  const places = scene.at(0);
  const plate = outlineAt(scene.pieces.find(({ item }) => item.kind === "body"), places);
  assert.ok(isInside(plate, 0.08, 0.2) && isInside(plate, 0, 0.27) && !isInside(plate, 0, 0.2));
  const { low, high } = scene.extents();
  assert.ok([...low, ...high].every(Number.isFinite));
  // The rings go round in opposite senses, so that both rules of filling leave the hole open.
  const ends = plate.findIndex(Number.isNaN);
  assert.ok(areaOf(plate.slice(0, ends)) > 0 && areaOf(plate.slice(ends + 2, -2)) < 0);
  const pen = new SvgPen();
  pen.polygon(plate, { fill: "#000" });
  assert.match(pen.parts[0], /^<path d="M[^MZ]+ZM[^MZ]+Z" fill/);
  assert.ok(!pen.parts[0].includes("NaN"));
});

test("a rail reaches as far as its carriage goes", async () => {
  const scene = await sceneOf(workshop());
  const { run } = scene;
  const rail = piecesOf(scene, "rail")[0];
  for (let t = 0; t <= 4; t += 0.1) {
    const places = scene.at(t);
    assert.ok(isInside(outlineAt(rail, places), places.poses[3 * 4], places.poses[3 * 4 + 1]), `${t}`);
  }
  assert.equal(run.mechanism.bodies[4].name, "carriage");
});

test("a port of the ground that moves takes its bearing along", async () => {
  const made = workshop({ end: 1 });
  const ports = made.head.mechanism.ground;
  made.ground = made.time.flatMap((t) => ports.flatMap(({ x, y, angle }, index) => (index === 0 ? [x + t, y, angle] : [x, y, angle])));
  const scene = await sceneOf(made);
  const mount = piecesOf(scene, "crank_pin").find(({ tone }) => tone === "mount");
  const lefts = [0, 0.505, 1].map((t) => Math.min(...outlineAt(mount, scene.at(t)).filter((_, at) => at % 2 === 0)));
  assert.ok(Math.abs(lefts[1] - lefts[0] - 0.505) < 1e-12 && Math.abs(lefts[2] - lefts[0] - 1) < 1e-12, `${lefts}`);
});

test("a part of the user's own with a rod is a jack, one with a pair is that pair", async () => {
  const made = workshop();
  const part = (name) => made.head.mechanism.parts.find((each) => each.name === name);
  part("ram").kind = "my_cylinder";
  part("crank_pin").kind = "my_bearing";
  const scene = await sceneOf(made);
  assert.ok(piecesOf(scene, "ram").some(({ tone }) => tone === "rod"));
  assert.ok(piecesOf(scene, "crank_pin").some(({ tone }) => tone === "mount"));
});

test("joined bodies of one depth lie side by side, and declared depths keep their order", async () => {
  const scene = await sceneOf(workshop());
  const { bodies, thickness } = scene.levels;
  for (const part of scene.mechanism.parts.filter(({ pair }) => pair !== null)) {
    const [a, b] = part.frames.map((frame) => scene.slabOf(frame)[0]);
    assert.ok(Math.abs(a - b) > 0.99 * thickness, part.name);
  }
  assert.ok(bodies[4] > Math.max(...bodies.filter((_, index) => index !== 4)), "the carriage is declared in front");
  assert.ok(Math.max(...bodies.filter((_, index) => index !== 4)) + thickness / 2 < bodies[4] - thickness / 2);
});

test("views show the sides that their names say", () => {
  const view = new View();
  const expected = {
    front: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    back: [[-1, 0, 0], [0, 1, 0], [0, 0, -1]],
    left: [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
    right: [[0, 0, -1], [0, 1, 0], [1, 0, 0]],
    top: [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
    bottom: [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
  };
  for (const [name, axes] of Object.entries(expected)) {
    view.lookFrom(name);
    view.axes().flat().forEach((value, at) => assert.ok(Math.abs(value - axes.flat()[at]) < 1e-15, `${name} ${view.axes()}`));
  }
  view.lookFrom("isometric");
  for (const part of view.axes()[2]) assert.ok(Math.abs(part - Math.sqrt(1 / 3)) < 1e-12, "three faces alike");
  assert.equal(Object.keys(PRESETS).length, 7);
});

test("zooming keeps the point under the pointer", () => {
  const view = new View();
  Object.assign(view, { azimuth: 30, elevation: 20, scale: 80, target: [1, 2, 3] });
  // The point under a pixel is known on the plane through the target.
  const [right, up] = view.axes();
  const point = [0, 1, 2].map((axis) => view.target[axis] + (120 * right[axis] - 70 * up[axis]) / view.scale);
  const where = () => view.projection(AREA).point(point[0], point[1], point[2]);
  const before = where();
  assert.ok(Math.hypot(before[0] - 520, before[1] - 370) < 1e-9, `${before}`);
  view.zoom(1.7, 120, 70);
  const after = where();
  assert.ok(Math.hypot(after[0] - before[0], after[1] - before[1]) < 1e-9);
  assert.equal(view.scale, 80 * 1.7);
});

test("a window becomes the whole picture", () => {
  const view = new View();
  view.zoomTo({ x: 100, y: 100, width: 200, height: 150 }, AREA);
  const corner = view.projection(AREA).point(-3, 2, 0);
  assert.ok(Math.hypot(corner[0], corner[1]) < 1e-9, `${corner}: it stood at 100 100`);
});

test("the extents hold every pose of the run", async () => {
  const scene = await sceneOf(doublePendulum());
  const view = new View();
  view.fit(scene.extents(), AREA);
  const projection = view.projection(AREA);
  for (let t = 0; t <= 4; t += 0.37) {
    for (const { near } of placePieces(scene, scene.at(t), projection)) {
      for (let at = 0; at < near.length; at += 2) {
        // Between the rows that are sampled a bar may stand out by little.
        assert.ok(near[at] > -10 && near[at] < 810 && near[at + 1] > -10 && near[at + 1] < 610, `${t}`);
      }
    }
  }
});

test("what is nearer hides what is behind: picking finds the upper body, from the back the lower one", async () => {
  const scene = await sceneOf(doublePendulum());
  const view = new View();
  const pickFrom = (name, offset) => {
    view.lookFrom(name);
    view.fit(scene.extents(), AREA);
    const places = scene.at(0);
    const [x, y] = framePose(scene.mechanism, { argument: "", body: 0, port: 1 }, places);
    const projection = view.projection(AREA);
    const [px, py] = projection.point(x, y, 0);
    return pickItem(scene, places, projection, px + offset, py);
  };
  assert.deepEqual(pickFrom("front", 0), { kind: "part", index: 1 });
  // Beside the pin, where both bars overlap.
  const [arm, forearm] = scene.levels.bodies;
  const upper = arm > forearm ? 0 : 1;
  assert.deepEqual(pickFrom("front", 7), { kind: "body", index: upper });
  assert.deepEqual(pickFrom("back", 7), { kind: "body", index: 1 - upper });
  assert.equal(pickFrom("front", 300), null);
});

test("poses that are no numbers are left out", async () => {
  const made = doublePendulum({ end: 0.1 });
  made.poses.fill(NaN, 6, 12);
  const scene = await sceneOf(made);
  const placed = placePieces(scene, scene.at(0), new View().projection(AREA));
  assert.ok(placed.length > 0);
  assert.ok(placed.every(({ near }) => near.every(Number.isFinite)));
  assert.ok(!placed.some(({ piece }) => piece.item.kind === "body" && piece.item.index === 1));
});

test("a body without ports, one with a single port, and a mechanism of points can be drawn", async () => {
  const body = (name, ports) => ({ name, mass: 1, inertia: 1, depth: 0, ports, contour: null });
  const head = headOf({ name: "Points", bodies: [body("a", []), body("b", [{ name: "p", x: 0, y: 0, angle: 0 }])] });
  const scene = await sceneOf(sampled(head, [0, 1], (t) => [[0, 0, 0], [1 + t, 0, 0]]));
  assert.ok(scene.radius > 0);
  assert.equal(placePieces(scene, scene.at(0.5), new View().projection(AREA)).length, 2);
});

test("a chain of 200 is placed quickly", async () => {
  const scene = await sceneOf(chain(200, { end: 0.2 }));
  const view = new View();
  view.lookFrom("isometric");
  // The best frame: in the others the machine may have been busy.
  let best = Infinity;
  for (let frame = 0; frame < 30; frame++) {
    const started = performance.now();
    placePieces(scene, scene.at(0.1), view.projection(AREA));
    best = Math.min(best, performance.now() - started);
  }
  assert.ok(best < 15, `${best} ms a frame`);
});
