// Pages of real runs, as Rust writes them: the manual's mechanisms, and what is drawn of them. Places are worked out here from
// the geometry of the declarations, not by the code that draws.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { DARK, LIGHT } from "../src/palette.js";
import { looks } from "../tests/support/scenes.js";
import { BODIES, drawn, madePage, open, openedIn, pieces as allPieces, settle, shot, skip, state, withoutPage, writeRuns } from "./support/browser.js";

const GROUND_PIN = [104, 110, 120];
const PIN = [44, 52, 66];
const CYLINDER = [126, 138, 156];
const ROD = [204, 210, 219];
const GROOVE = [238, 241, 246];
const SPRING = [70, 84, 106];
const SELECTED = [224, 135, 0];

/** Pieces of a colour in the picture, the largest first, but for the arrows of the axes in its corner. */
async function pieces(page, rgb, options) {
  const { height } = await state(page, "app.area");
  const found = await allPieces(page, rgb, options);
  // Edges are mixtures of two colours, which may be near a third.
  const thick = found.filter(({ left, right, top, bottom }) => Math.min(right - left, bottom - top) > 1);
  return thick.filter(({ left, bottom }) => left > 110 || bottom < height - 110).sort((a, b) => b.count - a.count);
}

/** @param {number[]} pose of a body in the shown moment @param {number[]} point from its centre of gravity */
const pointOf = ([x, y, angle], [u, v]) => [x + Math.cos(angle) * u - Math.sin(angle) * v, y + Math.sin(angle) * u + Math.cos(angle) * v];

const poseOf = (page, body) => state(page, `[...app.scene.at(app.player.time).poses.subarray(3 * ${body}, 3 * ${body} + 3)]`);

/** Where places (m) are on the picture, in its pixels; the view is from the front. */
async function onPicture(page, places) {
  const { target, scale } = await state(page, "app.view");
  const { width, height } = await state(page, "app.area");
  return places.map(([x, y]) => [width / 2 + (x - target[0]) * scale, height / 2 - (y - target[1]) * scale]);
}

/** A run is shown at a time: one request, no error, drawn in a second. */
async function opened(name, time) {
  const address = madePage(name);
  const { page, requests, errors } = await open(address, { hash: `#t=${time}&paths=` });
  assert.deepEqual([requests.map((each) => each.replace(/#.*/, "")), errors], [[address], []]);
  const { ink } = await drawn(page);
  assert.ok(ink > 1000, `${name}: ${ink} pixels`);
  await shot(page, `scene-${name}`);
  return page;
}

/** Of each wanted place (pixels) there is a piece, near, and of each piece a place. */
function arePlacedAt(found, wanted, message, near = 3) {
  const distances = wanted.map(([x, y]) => Math.min(...found.map((piece) => Math.hypot(piece.x - x, piece.y - y))));
  assert.ok(found.length === wanted.length && distances.every((distance) => distance < near), `${message}: ${JSON.stringify({ found, wanted })}`);
}

/** Selected one after the other, each body shows its outline, and is named. */
async function bodiesAreDrawn(page, names) {
  await page.focus("#picture");
  for (const name of names) {
    await page.keyboard.press(".");
    await settle(page);
    assert.match(await page.textContent("#spoken"), new RegExp(`: ${name}, body`));
    const { outline } = await drawn(page, "#picture", { outline: SELECTED });
    assert.ok(outline > 60, `${name}: ${outline} pixels of its outline`);
  }
  await page.keyboard.press(".");
  await settle(page);
  assert.equal((await state(page, "app.selected")).kind, "part", "there are no more bodies");
  await page.keyboard.press("Escape");
  await settle(page);
}

for (const name of ["DoublePendulum", "Quadrorhomb", "DoubleArm", "DoubleArm-live"]) {
  test(`${name}: its first frame comes in a second`, { skip: withoutPage(name) }, async () => {
    const ready = await openedIn(madePage(name));
    assert.ok(ready < 1000, `${ready} ms`);
  });
}

test("double pendulum: two bars, a grey pin on the ground, a dark one between them", { skip: withoutPage("DoublePendulum") }, async () => {
  const page = await opened("DoublePendulum", 0);
  // At the start: 1 m at 45 degrees from the pivot; the second bar along x, drawn from its only port to its centre of gravity.
  const elbow = [Math.SQRT1_2, Math.SQRT1_2];
  const [pivot, joint, centre] = await onPicture(page, [[0, 0], elbow, [elbow[0] + 1, elbow[1]]]);
  arePlacedAt(await pieces(page, GROUND_PIN), [pivot], "of the ground");
  arePlacedAt(await pieces(page, PIN), [joint], "between bodies");
  const bars = (await Promise.all(BODIES.slice(0, 2).map((rgb) => pieces(page, rgb, { least: 200 })))).flat().sort((a, b) => a.x - b.x);
  const wanted = [[pivot[0], joint[0]], [joint[0], centre[0]]];
  assert.equal(bars.length, 2);
  wanted.forEach(([from, to], at) => {
    const { left, right } = bars[at];
    assert.ok(Math.abs(left - from) < 12 && Math.abs(right - to) < 12, `${at}: ${left} to ${right} instead of ${from} to ${to}`);
  });
  await bodiesAreDrawn(page, ["arm", "forearm"]);
});

test("Quadrorhomb: thirteen bars, and a pin at each place where some meet", { skip: withoutPage("Quadrorhomb") }, async () => {
  const page = await opened("Quadrorhomb", 0.4);
  const bars = ["crank", "oa", "ob", "ac", "bc", "a1", "b1", "a2", "b2", "a3", "b3", "a4", "b4"];
  const poses = await Promise.all(bars.map((_, body) => poseOf(page, body)));
  const end = (name, along) => pointOf(poses[bars.indexOf(name)], [along, 0]);
  arePlacedAt(await pieces(page, GROUND_PIN), await onPicture(page, [[0, 0], [0.15, 0]]), "of the ground");
  // C, A, B; the middles of the scissors; their ends.
  const meetings = [
    end("crank", 0.075), end("oa", 0.25), end("ob", 0.25), end("a1", 0), end("a2", 0), end("a3", 0),
    end("a1", 0.25), end("b1", 0.25), end("a2", 0.25), end("b2", 0.25), end("a3", 0.25), end("b3", 0.25), end("a4", 0.125),
  ];
  arePlacedAt(await pieces(page, PIN), await onPicture(page, meetings), "between bodies");
  await bodiesAreDrawn(page, bars);
});

test("double arm: two bodies, the jack with its wider side at the arm, the guide along the first arm", { skip: withoutPage("DoubleArm") }, async () => {
  const page = await opened("DoubleArm", 0);
  const [arm, beam] = [await poseOf(page, 0), await poseOf(page, 1)];
  const [foot, eye] = [[0, -0.25], pointOf(arm, [-0.1, 0])];
  const [footAt, eyeAt, rail] = await onPicture(page, [foot, eye, pointOf(arm, [-0.2, 0])]);
  /** How far along the jack something is. */
  const share = ([{ x, y }]) => {
    const [dx, dy] = [eyeAt[0] - footAt[0], eyeAt[1] - footAt[1]];
    return ((x - footAt[0]) * dx + (y - footAt[1]) * dy) / (dx * dx + dy * dy);
  };
  const [cylinder, rod] = [await pieces(page, CYLINDER, { least: 200 }), await pieces(page, ROD, { least: 60 })];
  assert.ok(cylinder.length === 1 && rod.length === 1, JSON.stringify({ cylinder, rod }));
  // The manual's Table 4: a piston of 50 mm at the ground, a rod of 70 mm at the arm; the wider side is the cylinder.
  assert.ok(share(rod) > 0.1 && share(rod) < 0.5 && share(cylinder) > 0.55 && share(cylinder) < 1, `cylinder at ${share(cylinder)}, rod at ${share(rod)}`);
  arePlacedAt(await pieces(page, GROUND_PIN), await onPicture(page, [[0, 0], foot]), "of the ground");
  // The guide: a rail, dark because both are bodies, from where it begins on the arm on.
  // The eye of the jack lies over it.
  const guide = await pieces(page, PIN, { least: 60 });
  assert.ok(guide.some(({ left }) => left < rail[0]) && guide.some(({ right }) => right > eyeAt[0] + 50), JSON.stringify({ guide, rail }));
  assert.ok(beam[0] > arm[0]);
  await bodiesAreDrawn(page, ["arm", "beam"]);
});

test("a jack is as thick as it says, and as long as its rod is out", { skip: withoutPage("Hoist") }, async () => {
  const page = await opened("Hoist", 0);
  const scale = await state(page, "app.view.scale");
  for (const time of [0, 1]) {
    await page.evaluate((to) => (window.plmPage.app.player.seek(to), window.plmPage.app.touch()), time);
    await settle(page);
    const block = await poseOf(page, 0);
    const [foot, eye] = await onPicture(page, [[-0.6, 0], pointOf(block, [-0.4, 0])]);
    const [[cylinder], [rod]] = [await pieces(page, CYLINDER), await pieces(page, ROD)];
    const turn = Math.atan2(eye[1] - foot[1], eye[0] - foot[0]);
    // Of an oblong that is turned, from its box.
    const [sin, cos] = [Math.abs(Math.sin(turn)), Math.abs(Math.cos(turn))];
    const width = ({ left, right, top, bottom }) => ((right - left + 1) * sin - (bottom - top + 1) * cos) / (sin * sin - cos * cos);
    assert.ok(Math.abs(width(cylinder) / scale - 0.16) < 0.025, `${time} s: a cylinder of ${width(cylinder) / scale} m`);
    assert.ok(Math.abs(width(rod) / scale - 0.06) < 0.025, `${time} s: a rod of ${width(rod) / scale} m`);
    const length = Math.hypot(eye[0] - foot[0], eye[1] - foot[1]) / scale;
    const out = (cylinder.top - eye[1]) / scale / sin;
    assert.ok(out > length - 0.62 && out < length - 0.4, `${time} s: ${out} m of the rod at a length of ${length}`);
  }
});

test("a guide stands along its axis, a spring joins its points", { skip: withoutPage("Hoist") }, async () => {
  const page = await opened("Hoist", 0);
  const block = await poseOf(page, 0);
  const [o, beam, right] = await onPicture(page, [[0, 0], [0.6, 2], pointOf(block, [0.4, 0])]);
  // The rail of a guide on the ground is grey, and upright as its axis is.
  const [rail] = await pieces(page, GROUND_PIN);
  assert.ok(Math.abs(rail.x - o[0]) < 2 && rail.bottom - rail.top > 8 * (rail.right - rail.left), JSON.stringify(rail));
  const coil = await pieces(page, SPRING, { least: 30 });
  const [top, bottom] = [Math.min(...coil.map((piece) => piece.top)), Math.max(...coil.map((piece) => piece.bottom))];
  // Beside the pins at its ends.
  assert.ok(Math.abs(top - beam[1]) < 40 && Math.abs(bottom - right[1]) < 40, `${top} ${bottom} ${beam} ${right}`);
  assert.ok(coil.every(({ left, right: end }) => left > Math.min(beam[0], right[0]) - 40 && end < Math.max(beam[0], right[0]) + 40), "beside the line between its points");
});

test("a slot lies along its axis, with its pin in it", { skip: withoutPage("Plmtrpi00") }, async () => {
  const page = await opened("Plmtrpi00", 0.2);
  const bar = await poseOf(page, 0);
  // The pin is 25 mm from the centre of gravity.
  const travel = await state(page, "Array.from({length: app.run.rows}, (_, row) => app.run.poses.at(row, 0) - 0.025 * Math.cos(app.run.poses.at(row, 2)))");
  const [pin, least, most] = await onPicture(page, [pointOf(bar, [-0.025, 0]), [Math.min(...travel), 0], [Math.max(...travel), 0]]);
  // The bar lies over its middle.
  const rims = (await pieces(page, GROUND_PIN, { least: 60 })).filter(({ x }) => Math.abs(x - pin[0]) > 20);
  const [left, right] = [Math.min(...rims.map((rim) => rim.left)), Math.max(...rims.map((rim) => rim.right))];
  const slot = { left, right, top: Math.min(...rims.map((rim) => rim.top)), bottom: Math.max(...rims.map((rim) => rim.bottom)) };
  assert.ok(slot.right - slot.left > 1.5 * (slot.bottom - slot.top) && slot.left < least[0] && slot.right > most[0], JSON.stringify({ slot, least, most }));
  assert.ok(Math.abs((slot.top + slot.bottom) / 2 - least[1]) < 2, "along x");
  assert.ok((await drawn(page, "#picture", { groove: GROOVE })).groove > 20);
});

/** Colours of the picture at places (m), and of its background; the view is from the front. */
async function coloursAt(page, places) {
  const wanted = await onPicture(page, places);
  return page.evaluate((points) => {
    const canvas = document.querySelector("#picture");
    const ratio = canvas.width / canvas.getBoundingClientRect().width;
    const context = canvas.getContext("2d");
    const at = ([x, y]) => [...context.getImageData(Math.round(ratio * x), Math.round(ratio * y), 1, 1).data].slice(0, 3);
    return { found: points.map(at), back: at([2, 2]) };
  }, wanted);
}

const isNear = (a, b, limit = 14) => a.every((part, at) => Math.abs(part - b[at]) <= limit);

for (const [theme, palette] of [["light", LIGHT], ["dark", DARK]]) {
  test(`looks that parts declare, ${theme}: a wheel, its plate with a hole, the steps below, a symbol in front`, { skip }, async () => {
    const { page, errors } = await open(writeRuns(`looks-${theme}`, [looks()]), { theme, hash: "#t=1&paths=" });
    assert.deepEqual(errors, []);
    await shot(page, `looks-${theme}`);
    const radius = await state(page, "app.scene.radius");
    const pose = [0.2, 0.2, -1];
    const on = (point) => pointOf(pose, point);
    const places = [on([0.02, -0.035]), on([0.09, -0.09]), on([-0.06, 0.08]), on([0.1 + 0.3 * radius, 0]), [-0.2, -0.6 * radius], [1.3, 0.1 - 0.6 * radius], [1.3, 0.1 + radius]];
    const { found, back } = await coloursAt(page, places);
    const [hole, plate, rim, mark, low, high, above] = found;
    assert.ok(isNear(hole, back) && isNear(above, back), JSON.stringify({ found, back }));
    for (const colour of [plate, rim]) assert.ok(isNear(colour, palette.bodies[0]), JSON.stringify({ colour }));
    assert.ok(isNear(mark, palette.tones.ground), JSON.stringify({ mark }));
    for (const colour of [low, high]) assert.ok(isNear(colour, palette.tones.mount), JSON.stringify({ colour }));
    // All around the hub the circle is drawn, in the colour of what stands on the ground.
    const rims = Array.from({ length: 12 }, (_, k) => on([0.2 * Math.cos(k / 2), 0.2 * Math.sin(k / 2)]));
    const round = await coloursAt(page, rims);
    for (const colour of round.found) assert.ok(!isNear(colour, back), JSON.stringify(round));
  });
}

test("pages of real runs are small", { skip: withoutPage("DoubleArm") }, () => {
  // 4 s at 200 Hz, all quantities in full precision.
  for (const [name, limit] of [["DoublePendulum", 270_000], ["DoubleArm", 330_000]]) {
    const size = readFileSync(fileURLToPath(madePage(name))).length;
    console.log(`${name}: ${size} bytes`);
    assert.ok(size < limit, `${name}: ${size} bytes`);
  }
});
