import assert from "node:assert/strict";
import { test } from "node:test";
import { Player, LONGEST_FRAME } from "../src/player.js";
import { Run, Table } from "../src/run.js";
import { headOf } from "./support/scenes.js";

const body = (name) => ({ name, mass: 1, inertia: 1, depth: 0, ports: [], contour: null });

/** One body whose pose is `f(t)` with rates `g(t)`. */
function runOf(times, f, g, columns = []) {
  const run = Run.empty(headOf({ name: "M", bodies: [body("b")] }, { columns }));
  for (const t of times) run.append(t, [...f(t), ...g(t)], columns.map(() => t));
  return run;
}

test("between rows poses follow a cubic exactly", () => {
  const f = (t) => [t ** 3 - t, 2 - t ** 2, 0.5 * t ** 3];
  const g = (t) => [3 * t ** 2 - 1, -2 * t, 1.5 * t ** 2];
  const run = runOf([0, 1, 3], f, g);
  const out = new Float64Array(3);
  for (const t of [0, 0.3, 1, 1.7, 2.9, 3]) {
    run.posesAt(run.momentAt(t), out);
    // Rounding of a few sums of numbers up to 27.
    f(t).forEach((value, axis) => assert.ok(Math.abs(out[axis] - value) < 1e-13 * 27, `${t} ${axis}`));
  }
});

test("an angle that loses a turn between rows goes on smoothly", () => {
  const turn = (t) => ((3 * t + Math.PI) % (2 * Math.PI)) - Math.PI;
  const run = runOf([1, 1.1], (t) => [0, 0, turn(t)], () => [0, 0, 3]);
  assert.ok(turn(1.1) < turn(1), "the case has a jump");
  const out = new Float64Array(3);
  run.posesAt(run.momentAt(1.05), out);
  assert.ok(Math.abs(out[2] - 3.15) < 1e-12, `${out[2]}`);
});

test("at a time of two rows the second holds", () => {
  const run = runOf([0, 1, 1, 2], () => [0, 0, 0], () => [0, 0, 0]);
  assert.deepEqual(run.momentAt(1), { row: 2, share: 0 });
  assert.deepEqual(run.momentAt(0.5), { row: 0, share: 0.5 });
  assert.deepEqual(run.momentAt(-5), { row: 0, share: 0 });
  assert.deepEqual(run.momentAt(9), { row: 3, share: 0 });
});

test("quantities are the columns, then poses that no column has", () => {
  const run = runOf([0, 2], (t) => [t, 0, 0], () => [1, 0, 0], [{ name: "b.angle", unit: "deg" }]);
  const names = run.quantities().map(({ name, unit }) => `${name} ${unit}`);
  assert.deepEqual(names, ["b.angle deg", "b.x m", "b.y m", "b.velocity.x m/s", "b.velocity.y m/s", "b.omega deg/s"]);
  assert.equal(run.valueAt(run.quantities()[1], run.momentAt(0.5)), 0.5);
});

test("rows may be appended while it is shown", () => {
  const run = Run.empty(headOf({ name: "M", bodies: [body("b")] }));
  for (let row = 0; row < 5000; row++) run.append(row / 100, [row, 0, 0, 100, 0, 0], []);
  assert.deepEqual([run.rows, run.end], [5000, 49.99]);
  assert.equal(run.poses.at(4999, 0), 4999);
  run.clear();
  assert.deepEqual([run.rows, run.start, run.end], [0, 0, 0]);
});

test("a table without columns has rows all the same", () => {
  const table = new Table(0);
  table.append([]);
  assert.equal(table.rows, 1);
});

test("the player plays, stops at the end, and loops", () => {
  const player = new Player();
  player.setBounds(1, 2);
  assert.equal(player.time, 1);
  player.play();
  for (let now = 0; now <= 500; now += 20) player.tick(now);
  assert.ok(Math.abs(player.time - 1.5) < 1e-12, `${player.time}`);
  for (let now = 520; now <= 1200; now += 20) player.tick(now);
  assert.deepEqual([player.time, player.isPlaying], [2, false]);
  player.isLooping = true;
  player.play();
  assert.equal(player.time, 1, "play at the end begins anew");
  for (let now = 0; now <= 1200; now += 20) player.tick(now);
  assert.ok(player.isPlaying && Math.abs(player.time - 1.2) < 1e-9, `${player.time}`);
});

test("a late frame moves no further than the longest", () => {
  const player = new Player();
  player.setBounds(0, 100);
  player.speed = 2;
  player.play();
  player.tick(0);
  player.tick(5000);
  assert.equal(player.time, 2 * LONGEST_FRAME);
});

test("steps, speeds and bounds", () => {
  const player = new Player();
  player.setBounds(0, 4);
  assert.equal(player.step, 0.05);
  player.chosenStep = 0.3;
  player.stepBy(2);
  assert.ok(Math.abs(player.time - 0.6) < 1e-15);
  player.stepBy(-9);
  assert.equal(player.time, 0);
  player.speed = 0.9;
  player.changeSpeed(1);
  assert.equal(player.speed, 2);
  player.seek(3);
  player.setBounds(0, 2);
  assert.equal(player.time, 2);
  player.isFollowing = true;
  player.setBounds(0, 7);
  assert.equal(player.time, 7);
  player.setBounds(0, 0);
  player.play();
  assert.equal(player.isPlaying, false, "nothing to play");
});
