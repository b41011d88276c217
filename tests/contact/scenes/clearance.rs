//! Joints with clearance: a pin in a bush, a slider between two guides.

use plm::{Dop853, Mechanism as _, Moment as _};

use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// A rod whose pin has 5 mm of clearance in its bush.
    pub Loose {
        gravity: 9.81 m/s^2;
        body rod { mass: 1.2 kg; inertia: 0.02 kg*m^2; port pin: (0, 0.3) m; start angle: 0.5 rad; start omega: 2 rad/s; }
        unilateral bush: ((5 mm)^2 - dot(rod.pin.position, rod.pin.position))/(10 mm) >= 0 m { restitution: 0.8; }
    }
}

/// G flies on a parabola, and the rod turns evenly; an impact in the pin acts along its way from the middle of the bush.
#[test]
fn a_pin_rattles_in_its_bush() {
    let (mass, inertia, g, clearance) = (1.2, 0.02, 9.81, 0.005_f64);
    let rod = Loose::new();
    let (sin, cos) = 0.5_f64.sin_cos();
    let pin = |x: f64, y: f64, angle: f64| [x - 0.3 * angle.sin(), y + 0.3 * angle.cos()];
    // The pin begins in the middle of the bush.
    let mut q = [0.3 * sin, -0.3 * cos, 0.5];
    let mut v = [0.0, 0.0, 2.0];
    let rod = rod.with_start("rod.x", q[0]).with_start("rod.y", q[1]);
    let mut sim = rod.start_with(Dop853::new(1e-11)).unwrap();
    let mut time = 0.0;
    for _ in 0..12 {
        let place = |s: f64| [q[0] + v[0] * s, q[1] + v[1] * s - 0.5 * g * s * s, q[2] + v[2] * s];
        let is_inside = |s: f64| {
            let [x, y, angle] = place(s);
            let [a, b] = pin(x, y, angle);
            a.hypot(b) < clearance
        };
        let mut low = 1e-6;
        while is_inside(low + 1e-5) {
            low += 1e-5;
        }
        let mut high = low + 1e-5;
        for _ in 0..60 {
            let half = 0.5 * (low + high);
            *(if is_inside(half) { &mut low } else { &mut high }) = half;
        }
        q = place(high);
        v[1] -= g * high;
        time += high;
        let [a, b] = pin(q[0], q[1], q[2]);
        let normal = [-a / clearance, -b / clearance];
        let arm = [a - q[0], b - q[1]];
        let turn = arm[0] * normal[1] - arm[1] * normal[0];
        let rate = normal[0] * v[0] + normal[1] * v[1] + turn * v[2];
        let impulse = -1.8 * rate / (1.0 / mass + turn * turn / inertia);
        v = [
            v[0] + impulse * normal[0] / mass,
            v[1] + impulse * normal[1] / mass,
            v[2] + impulse * turn / inertia,
        ];
        sim.step_to(time + 1e-10).unwrap();
        let rod = sim.state_of("rod");
        near(rod.omega, v[2], 1e-11);
        near(rod.x, q[0], 1e-10);
        near(rod.y, q[1], 1e-10);
    }
    assert_eq!(sim.contact_stats().impacts, 12);
}

scene! {
    /// P. Flores, R. Leine, Ch. Glocker, Multibody Syst. Dyn. 23, 2010, 165-190: table 1, with the law of impact of the paper.
    pub Clearance {
        impacts: newton;
        param friction = 0.01;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body crank {
            mass: 0.038 kg; inertia: 7.4e-5 kg*m^2;
            port o: (-76.5, 0) mm; port a: (76.5, 0) mm;
            start angle: 0 rad, locked;
            start omega: 150 rad/s, locked;
        }
        body rod {
            mass: 0.038 kg; inertia: 5.9e-4 kg*m^2;
            port a: (-153, 0) mm; port b: (153, 0) mm;
            start angle: 0 rad, locked;
            start omega: -75 rad/s, locked;
        }
        body slider {
            mass: 0.076 kg; inertia: 2.7e-6 kg*m^2;
            port b: (0, 0) mm;
            port corner[0]: (-50, 25) mm; port corner[1]: (50, 25) mm;
            port corner[2]: (-50, -25) mm; port corner[3]: (50, -25) mm;
            start angle: 0 rad, locked;
            start omega: 0 rad/s, locked;
        }
        revolute o(ground.o, crank.o);
        revolute a(crank.a, rod.a);
        revolute b(rod.b, slider.b);
        repeat i in 0..2 {
            unilateral upper[i]: slider.corner[i].y <= 26 mm { restitution: 0.4; }
            unilateral lower[i]: slider.corner[i + 2].y >= -26 mm { restitution: 0.4; }
            friction above[i]: rate(slider.corner[i].x) within friction*reaction(upper[i]);
            friction below[i]: rate(slider.corner[i + 2].x) within friction*reaction(lower[i]);
        }
    }
}

/// Places and velocities, or their rates.
type Pair = ([f64; 3], [f64; 3]);

/// The equations of the paper (90) to (96), angles of crank, rod and slider.
pub(super) struct Flores;

impl Flores {
    const L: [f64; 2] = [0.153, 0.306];
    const M: [f64; 3] = [0.038, 0.038, 0.076];
    const J: [f64; 3] = [7.4e-5, 5.9e-4, 2.7e-6];

    fn mass(q: [f64; 3]) -> [f64; 3] {
        let ([l1, l2], [m1, m2, m3]) = (Self::L, Self::M);
        [
            Self::J[0] + (0.25 * m1 + m2 + m3) * l1 * l1,
            (0.5 * m2 + m3) * l1 * l2 * (q[1] - q[0]).cos(),
            Self::J[1] + (0.25 * m2 + m3) * l2 * l2,
        ]
    }

    /// M^-1 times a vector.
    pub(super) fn divided(q: [f64; 3], f: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = Self::mass(q);
        let determinant = a * c - b * b;
        [(c * f[0] - b * f[1]) / determinant, (a * f[1] - b * f[0]) / determinant, f[2] / Self::J[2]]
    }

    pub(super) fn acceleration(q: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        let ([l1, l2], [m1, m2, m3]) = (Self::L, Self::M);
        let factor = (0.5 * m2 + m3) * l1 * l2 * (q[1] - q[0]).sin();
        let h1 = factor * v[1] * v[1] - (0.5 * m1 + m2 + m3) * 9.81 * l1 * q[0].cos();
        let h2 = -factor * v[0] * v[0] - (0.5 * m2 + m3) * 9.81 * l2 * q[1].cos();
        Self::divided(q, [h1, h2, 0.0])
    }

    /// Gaps of the corners, each with its direction.
    pub(super) fn corners(q: [f64; 3]) -> [(f64, [f64; 3]); 4] {
        let ([l1, l2], (sin, cos)) = (Self::L, q[2].sin_cos());
        let y = l1 * q[0].sin() + l2 * q[1].sin();
        [(1.0, -0.05), (1.0, 0.05), (-1.0, -0.05), (-1.0, 0.05)].map(|(side, a): (f64, f64)| {
            let b = 0.025 * side;
            let gap = 0.026 - side * (y + a * sin + b * cos);
            (gap, [-side * l1 * q[0].cos(), -side * l2 * q[1].cos(), -side * (a * cos - b * sin)])
        })
    }

    /// Directions of the corners along the guides.
    pub(super) fn slides(q: [f64; 3]) -> [[f64; 3]; 4] {
        let ([l1, l2], (sin, cos)) = (Self::L, q[2].sin_cos());
        [(1.0, -0.05), (1.0, 0.05), (-1.0, -0.05), (-1.0, 0.05)]
            .map(|(side, a): (f64, f64)| [-l1 * q[0].sin(), -l2 * q[1].sin(), -a * sin - 0.025 * side * cos])
    }

    fn step(q: [f64; 3], v: [f64; 3], h: f64) -> ([f64; 3], [f64; 3]) {
        let add =
            |x: [f64; 3], d: [f64; 3], h: f64| -> [f64; 3] { core::array::from_fn(|i| x[i] + h * d[i]) };
        let a = (v, Self::acceleration(q, v));
        let at = |d: ([f64; 3], [f64; 3]), h: f64| {
            let (q, v) = (add(q, d.0, h), add(v, d.1, h));
            (v, Self::acceleration(q, v))
        };
        let b = at(a, 0.5 * h);
        let c = at(b, 0.5 * h);
        let d = at(c, h);
        let mean = |i: usize, of: fn(&Pair) -> [f64; 3]| {
            (of(&a)[i] + 2.0 * (of(&b)[i] + of(&c)[i]) + of(&d)[i]) / 6.0
        };
        (
            core::array::from_fn(|i| q[i] + h * mean(i, |s| s.0)),
            core::array::from_fn(|i| v[i] + h * mean(i, |s| s.1)),
        )
    }
}

/// The first impacts of a slider that is tilted at first, without friction.
#[test]
fn a_slider_strikes_its_guides() {
    let start = Clearance::new().with("friction", 0.0).with_start("slider.angle", 0.004);
    let mut sim = start.start_with(Dop853::new(1e-11)).unwrap();
    let (mut q, mut v) = ([0.0, 0.0, 0.004], [150.0, -75.0, 0.0]);
    let (mut time, mut impacts) = (0.0, 0);
    while impacts < 12 && time < 0.05 {
        let h = 5e-6;
        let is_free = |q: [f64; 3], v: [f64; 3]| {
            Flores::corners(q)
                .iter()
                .all(|(gap, w)| *gap > 0.0 || w[0] * v[0] + w[1] * v[1] + w[2] * v[2] > 0.0)
        };
        let (next, rates) = Flores::step(q, v, h);
        if is_free(next, rates) {
            (q, v, time) = (next, rates, time + h);
            continue;
        }
        let (mut low, mut high) = (0.0, h);
        for _ in 0..60 {
            let half = 0.5 * (low + high);
            let (next, rates) = Flores::step(q, v, half);
            *(if is_free(next, rates) { &mut low } else { &mut high }) = half;
        }
        (q, v) = Flores::step(q, v, high);
        time += high;
        for (gap, w) in Flores::corners(q) {
            let rate = w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
            if gap <= 0.0 && rate < 0.0 {
                let response = Flores::divided(q, w);
                let impulse = -1.4 * rate / (w[0] * response[0] + w[1] * response[1] + w[2] * response[2]);
                v = core::array::from_fn(|i| v[i] + impulse * response[i]);
                impacts += 1;
                // Between impacts that follow each other ever faster.
                let (_, after) = Flores::step(q, v, 1e-10);
                sim.step_to(time + 1e-10).unwrap();
                near(sim.state_of("crank").omega, after[0], 1e-9);
                near(sim.state_of("rod").omega, after[1], 1e-9);
                near(sim.state_of("slider").omega, after[2], 1e-9);
            }
        }
    }
    assert_eq!(sim.contact_stats().impacts, 12);
}

/// With friction the energy falls, impact by impact, for a turn.
#[test]
fn a_slider_with_clearance_loses_energy() {
    let mut sim = Clearance::new().start_with(Dop853::new(1e-10)).unwrap();
    let energy = |sim: &plm::Sim<Scene>| sim.kinetic_energy() + sim.gravity_energy();
    let mut last = energy(&sim);
    for k in 1..=100 {
        sim.step_to(4e-4 * f64::from(k)).unwrap();
        let now = energy(&sim);
        assert!(now <= last + 1e-9 * last, "{} s: {now} J of {last}", sim.time());
        last = now;
    }
    assert!(sim.contact_stats().impacts > 15, "{:?}", sim.contact_stats());
}
