// Mechanisms for tests: their motion is known in closed form, or integrated here.

/** A port from G. */
const port = (name, x, y, angle = 0) => ({ name, x, y, angle });
const body = (name, ports, more = {}) => ({ name, mass: 1, inertia: 0.01, depth: 0, ports, contour: null, ...more });
const ground = (name, x, y, angle = 0, depth = 0) => ({ name, x, y, angle, depth });
/** Frames are written `[body, port]`; body null is the ground. */
const part = (name, kind, frames, more = {}) => ({
  name,
  kind,
  pair: ["revolute", "prismatic", "pin_slot", "weld"].includes(kind) ? kind : null,
  frames: frames.map(([of, at], index) => ({ argument: "ab"[index], body: of, port: at })),
  sizes: {},
  ...more,
});

/** @param {any} mechanism */
export function headOf(mechanism, more = {}) {
  const [bodies, parts] = [mechanism.bodies.map((each) => ({ holes: [], ...each })), (mechanism.parts ?? []).map((each) => ({ shapes: [], ...each }))];
  return {
    name: "run",
    mechanism: { doc: "", report: null, ground: [], parameters: [], inputs: [], states: [], ...mechanism, bodies, parts },
    method: "closed form",
    columns: [],
    events: [],
    fault: null,
    ...more,
  };
}

/**
 * Rows of a motion in closed form; rates by central differences.
 * @param {(t: number) => number[][]} poses x y θ of each body
 */
export function sampled(head, times, poses, values = () => []) {
  const run = { head, time: times, poses: [], values: [] };
  const h = 1e-6;
  for (const t of times) {
    const [before, now, after] = [t - h, t, t + h].map(poses);
    now.forEach((pose, index) => {
      run.poses.push(...pose, ...pose.map((_, axis) => (after[index][axis] - before[index][axis]) / (2 * h)));
    });
    run.values.push(...values(t));
  }
  return run;
}

export function timesTo(end, step) {
  return Array.from({ length: Math.round(end / step) + 1 }, (_, row) => row * step);
}

/**
 * The manual's double pendulum: bars of 1 m, angles from the x axis, integrated by RK4.
 */
export function doublePendulum({ name = "run", mass = 10, end = 4, rate = 200 } = {}) {
  const mechanism = {
    name: "DoublePendulum",
    doc: "The double pendulum of the manual, section 2.2.",
    report: {
      formulation: "joint coordinates",
      reason: "the joints make a tree",
      degrees_of_freedom: 2,
      operations: { add: 11, mul: 22, div: 1, sqrt: 0, sin_cos: 2, other: 0 },
    },
    bodies: [
      body("arm", [port("o0", -0.5, 0), port("p12", 0.5, 0)], { mass: 10 }),
      body("forearm", [port("p12", -0.5, 0), port("tip", 0.5, 0)], { mass }),
    ],
    ground: [ground("o0", 0, 0)],
    parts: [part("shoulder", "revolute", [[null, 0], [0, 0]]), part("elbow", "revolute", [[0, 1], [1, 0]])],
    parameters: [
      { name: "forearm.mass", unit: "kg", factor: 1, exponents: [0, 1, 0, 0, 0, 0, 0], default: 10, value: mass },
      { name: "arm.length", unit: "mm", factor: 0.001, exponents: [1, 0, 0, 0, 0, 0, 0], default: 1, value: 1 },
    ],
    states: [{ name: "arm.angle", unit: "rad" }, { name: "forearm.angle", unit: "rad" }],
  };
  const columns = [
    { name: "arm.angle", unit: "deg" },
    { name: "forearm.angle", unit: "deg" },
    { name: "shoulder.force.x", unit: "N" },
    { name: "shoulder.force.y", unit: "N" },
  ];
  const run = { head: headOf(mechanism, { name, columns, method: "RK4, step 1 ms" }), time: [], poses: [], values: [] };
  const rates = pendulumRates(10, mass);
  let x = [Math.PI / 4, 0, 0, 0];
  const stride = Math.round(1000 / rate);
  for (let step = 0; step <= end * 1000; step++) {
    if (step % stride === 0) addPendulumRow(run, step / 1000, x, rates(x), mass);
    x = rk4(rates, x, 1e-3);
  }
  return run;
}

/** Equations of two bars of 1 m under gravity: M(θ) a = f. */
function pendulumRates(m1, m2) {
  const [i1, i2, g] = [0.01, 0.01, 9.81];
  return ([a, b, u, v]) => {
    const c = 0.5 * m2 * Math.cos(a - b);
    const s = 0.5 * m2 * Math.sin(a - b);
    const [m11, m22] = [0.25 * m1 + i1 + m2, 0.25 * m2 + i2];
    const f1 = -s * v * v - (0.5 * m1 + m2) * g * Math.cos(a);
    const f2 = s * u * u - 0.5 * m2 * g * Math.cos(b);
    const det = m11 * m22 - c * c;
    return [u, v, (m22 * f1 - c * f2) / det, (m11 * f2 - c * f1) / det];
  };
}

function addPendulumRow(run, time, [a, b, u, v], [, , p, q], m2) {
  const polar = (angle, rate, acc) => ({
    x: Math.cos(angle),
    y: Math.sin(angle),
    vx: -Math.sin(angle) * rate,
    vy: Math.cos(angle) * rate,
    ax: -Math.sin(angle) * acc - Math.cos(angle) * rate * rate,
    ay: Math.cos(angle) * acc - Math.sin(angle) * rate * rate,
  });
  const [first, second] = [polar(a, u, p), polar(b, v, q)];
  const at = (share1, share2, key) => share1 * first[key] + share2 * second[key];
  run.time.push(time);
  run.poses.push(at(0.5, 0, "x"), at(0.5, 0, "y"), a, at(0.5, 0, "vx"), at(0.5, 0, "vy"), u);
  run.poses.push(at(1, 0.5, "x"), at(1, 0.5, "y"), b, at(1, 0.5, "vx"), at(1, 0.5, "vy"), v);
  // What the shoulder does to the ground: weights less inertial forces of both bars.
  const fx = -(10 * at(0.5, 0, "ax") + m2 * at(1, 0.5, "ax"));
  const fy = -(10 * (at(0.5, 0, "ay") + 9.81) + m2 * (at(1, 0.5, "ay") + 9.81));
  run.values.push((a * 180) / Math.PI, (b * 180) / Math.PI, fx, fy);
}

function rk4(rates, x, h) {
  const add = (a, s, b) => a.map((value, at) => value + s * b[at]);
  const k1 = rates(x);
  const k2 = rates(add(x, h / 2, k1));
  const k3 = rates(add(x, h / 2, k2));
  const k4 = rates(add(x, h, k3));
  return x.map((value, at) => value + (h / 6) * (k1[at] + 2 * k2[at] + 2 * k3[at] + k4[at]));
}

/**
 * One of everything that is drawn: crank, coupler and rocker on pins, a carriage on a rail, an arm with a slot, a jack, a
 * spring, a plate with a contour at a depth of its own. The crank turns once in 2 s.
 */
export function workshop({ end = 4, rate = 100, fault = null, gap = false } = {}) {
  const plate = [[-0.09, -0.06], [0.09, -0.06], [0.09, 0.02], [0.03, 0.02], [0.03, 0.07], [-0.03, 0.07], [-0.03, 0.02], [-0.09, 0.02]];
  const mechanism = {
    name: "Workshop",
    doc: "One of everything that is drawn.",
    bodies: [
      body("crank", [port("a", -0.15, 0), port("b", 0.15, 0)]),
      body("coupler", [port("b", -0.45, 0), port("c", 0.45, 0), port("eye", 0, 0.25)]),
      body("rocker", [port("d", -0.35, 0), port("c", 0.25, 0), port("tip", 0.45, 0)]),
      body("rod", [port("tip", -0.4, 0), port("pin", 0.4, 0)]),
      body("carriage", [port("pin", 0, 0)], { contour: plate, depth: 0.12 }),
      body("arm", [port("e", -0.3, 0), port("slot", 0, 0)]),
    ],
    ground: [ground("a", 0, 0), ground("d", 1, -0.1), ground("rail", 1.7, 0.75), ground("e", 0, -0.55), ground("f", 1.45, -0.35), ground("s", 0.45, 1.25)],
    parts: [
      part("crank_pin", "revolute", [[null, 0], [0, 0]], { sizes: { pin: 0.05 } }),
      part("crank_coupler", "revolute", [[0, 1], [1, 0]], { sizes: { pin: 0.04 } }),
      part("coupler_rocker", "revolute", [[1, 1], [2, 1]], { sizes: { pin: 0.04 } }),
      part("rocker_pin", "revolute", [[null, 1], [2, 0]], { sizes: { pin: 0.05 } }),
      part("rocker_rod", "revolute", [[2, 2], [3, 0]]),
      part("rod_carriage", "revolute", [[3, 1], [4, 0]]),
      part("rail", "prismatic", [[null, 2], [4, 0]]),
      part("arm_pin", "revolute", [[null, 3], [5, 0]]),
      part("slot", "pin_slot", [[5, 1], [0, 1]]),
      part("ram", "jack", [[null, 4], [2, 2]], { sizes: { piston: 0.09, rod: 0.04, free_length: 0.55 } }),
      part("strut", "spring", [[null, 5], [1, 2]], { sizes: { free_length: 0.7 } }),
      part("drive", "force", [[0, 0], [null, null]]),
    ],
    parameters: [{ name: "crank.speed", unit: "rev/min", factor: Math.PI / 30, exponents: [0, 0, -1, 0, 0, 0, 1], default: Math.PI, value: Math.PI }],
  };
  const columns = [
    { name: "rocker.angle", unit: "deg" },
    { name: "rail.displacement", unit: "m" },
    { name: "crank_coupler.force.x", unit: "N" },
    { name: "crank_coupler.force.y", unit: "N" },
    { name: "slot.force.x", unit: "N" },
    { name: "slot.force.y", unit: "N" },
  ];
  const events = [{ time: 1.25, what: "stop.touches", row: 126 }, { time: 2.5, what: "stop.leaves", row: 251 }];
  const head = headOf(mechanism, { columns, events, fault });
  return sampled(head, timesTo(end, 1 / rate), workshopPoses, (t) => {
    const poses = workshopPoses(t);
    const angle = gap && t > 0.5 && t < 0.8 ? NaN : (poses[2][2] * 180) / Math.PI;
    const turn = poses[0][2];
    return [angle, poses[4][0] - 1.7, 40 * Math.cos(turn), 25 * Math.sin(2 * turn), 12 * Math.sin(turn), -18 * Math.cos(turn)];
  });
}

/**
 * What declarations say of the looks of their parts: a wheel on a plate with a hole, which rolls on steps, and a strut.
 * The wheel rolls to the right at 0.2 m/s and touches the ground at y = 0.
 */
export function looks() {
  const shape = (look, [of, at], points, more = {}) => ({ look, body: of, port: at, towards: null, symbol: false, points, ...more });
  const plate = { contour: [[-0.1, -0.1], [-0.1, 0.1], [0.1, 0.1], [0.1, -0.1]], holes: [[[-0.05, -0.05], [0.05, -0.05], [0, 0.05]]] };
  const shapes = [
    shape("circle", [0, 0], [[0, 0], [0.2, 0]]),
    shape("outline", [0, 0], [[0, 0], [0, 0.15], [0.15, 0]]),
    shape("mark", [0, 0], [[0.1, 0], [1, 0], [0, 1], [0, -1]], { symbol: true }),
    shape("line", [null, 0], [[0, 0], [0, 0], [0.5, 1], [1, 0]], { towards: [0, 0], symbol: true }),
    shape("surface", [null, 0], [[-0.3, 0], [1, 0], [1, 0.1], [1.4, 0.1]]),
    shape("surface", [null, 1], []),
  ];
  const mechanism = {
    name: "Looks",
    bodies: [body("wheel", [port("hub", 0, 0)], plate)],
    ground: [ground("o", 0, 0), ground("level", 0, -0.2, 0)],
    parts: [part("tread", "tread", [[null, 0], [0, 0]], { shapes })],
  };
  return sampled(headOf(mechanism), timesTo(2, 0.05), (t) => [[0.2 * t, 0.2, -t]]);
}

function workshopPoses(t) {
  const crank = 0.4 + Math.PI * t;
  const b = [0.3 * Math.cos(crank), 0.3 * Math.sin(crank)];
  const d = [1, -0.1];
  // The upper one of the two points at 0.9 from b and at 0.6 from d.
  const [dx, dy] = [d[0] - b[0], d[1] - b[1]];
  const distance = Math.hypot(dx, dy);
  const along = (distance ** 2 + 0.9 ** 2 - 0.6 ** 2) / (2 * distance);
  const across = Math.sqrt(0.9 ** 2 - along ** 2);
  const c = [b[0] + (along * dx - across * dy) / distance, b[1] + (along * dy + across * dx) / distance];
  const coupler = Math.atan2(c[1] - b[1], c[0] - b[0]);
  const rocker = Math.atan2(c[1] - d[1], c[0] - d[0]);
  const tip = [d[0] + 0.8 * Math.cos(rocker), d[1] + 0.8 * Math.sin(rocker)];
  const x = tip[0] + Math.sqrt(0.8 ** 2 - (0.75 - tip[1]) ** 2);
  const rod = Math.atan2(0.75 - tip[1], x - tip[0]);
  const arm = Math.atan2(b[1] + 0.55, b[0]);
  return [
    [b[0] / 2, b[1] / 2, crank],
    [(b[0] + c[0]) / 2, (b[1] + c[1]) / 2, coupler],
    [d[0] + 0.35 * Math.cos(rocker), d[1] + 0.35 * Math.sin(rocker), rocker],
    [(tip[0] + x) / 2, (tip[1] + 0.75) / 2, rod],
    [x, 0.75, 0],
    [0.3 * Math.cos(arm), -0.55 + 0.3 * Math.sin(arm), arm],
  ];
}

/** A chain of bars that swings as a wave: as many bodies as are asked for. */
export function chain(count, { end = 4, rate = 100 } = {}) {
  const bodies = Array.from({ length: count }, (_, index) => body(`bar${index}`, [port("a", -0.5, 0), port("b", 0.5, 0)]));
  const parts = bodies.map((_, index) => part(`pin${index}`, "revolute", [index === 0 ? [null, 0] : [index - 1, 1], [index, 0]]));
  const head = headOf({ name: "Chain", bodies, ground: [ground("o", 0, 0)], parts });
  return sampled(head, timesTo(end, 1 / rate), (t) => {
    let [x, y] = [0, 0];
    return bodies.map((_, index) => {
      const angle = Math.sin(2 * t + 0.35 * index) + (index % 12 < 6 ? 0.4 : Math.PI - 0.4);
      const pose = [x + 0.5 * Math.cos(angle), y + 0.5 * Math.sin(angle), angle];
      [x, y] = [x + Math.cos(angle), y + Math.sin(angle)];
      return pose;
    });
  });
}
