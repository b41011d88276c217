//! Limits of friction that are numbers, and that depend on the motion; gaps along curves.

use plm_runtime::contact::{self, Law, Limit, Mode, Rows};
use plm_runtime::{Dop853, Mechanism, Scalar};

use crate::support::{Row, Scene, system};

const GRAVITY: f64 = 9.81;

/// Two shafts, 0.2 and 0.5 kg m^2, and a clutch of 50 N m between them; a torque on the first.
#[derive(Clone, Copy, Debug)]
struct Clutch {
    engine: f64,
}

impl Scene<2, 1> for Clutch {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2]) -> [T; 2] {
        [T::lit(5.0 * self.engine), T::ZERO]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 2]) -> [[T; 2]; 2] {
        [[T::lit(5.0), T::ZERO], [T::ZERO, T::lit(2.0)]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 2], _v: [T; 2]) -> [Row<T, 2>; 1] {
        [Row::fixed(q[0] - q[1], [T::lit(1.0), T::lit(-1.0)])]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2], rows: &mut Rows<T, 1>) {
        rows.set_friction(0, Limit::own(T::lit(50.0)));
    }
    fn start(&self) -> ([f64; 2], [f64; 2]) {
        ([0.0; 2], [200.0, 20.0])
    }
}

system!(Clutch, 2, 1);

/// Case C38: when it locks, at which speed, with which heat; what it carries then.
#[test]
fn a_clutch_locks() {
    let mut sim = Clutch { engine: 0.0 }.start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(0.514_285_714_285_714_2).unwrap();
    let heat = 50.0 * (sim.x[0] - sim.x[1]);
    assert!((heat - 2_314.285_714_285_714).abs() < 1e-7, "{heat}");
    sim.step(1.0).unwrap();
    assert_eq!(sim.held.of[0], Mode::Sticks);
    assert!((sim.x[2] - 71.428_571_428_571_43).abs() < 1e-10 && sim.x[2] == sim.x[3], "{:?}", sim.x);
    let scene = Clutch { engine: 30.0 };
    let mut sim = scene.start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(0.9 - 1e-10).unwrap();
    assert_eq!(sim.held.of[0], Mode::Forwards);
    sim.step_to(0.9 + 1e-10).unwrap();
    assert_eq!(sim.held.of[0], Mode::Sticks);
    assert!((sim.x[2] - 110.0).abs() < 1e-8, "{:?}", sim.x);
    let [torque] = contact::reactions(&scene, 0.0, &sim.held, &sim.x);
    assert!((torque + 21.428_571_428_571_43).abs() < 1e-12, "{torque}");
}

/// A block of 2 kg on one of 3 kg, which is pulled along a floor by a force.
#[derive(Clone, Copy, Debug)]
struct Stack {
    force: f64,
}

impl Scene<2, 2> for Stack {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Friction; 2]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2]) -> [T; 2] {
        [T::ZERO, T::lit(self.force / 3.0)]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 2]) -> [[T; 2]; 2] {
        [[T::lit(0.5), T::ZERO], [T::ZERO, T::lit(1.0 / 3.0)]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 2], _v: [T; 2]) -> [Row<T, 2>; 2] {
        let one = T::lit(1.0);
        [Row::fixed(q[0] - q[1], [one, -one]), Row::fixed(q[1], [T::ZERO, one])]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2], rows: &mut Rows<T, 2>) {
        rows.set_friction(0, Limit::own(T::lit(0.4 * 2.0 * GRAVITY)));
        rows.set_friction(1, Limit::own(T::lit(0.1 * 5.0 * GRAVITY)));
    }
    fn start(&self) -> ([f64; 2], [f64; 2]) {
        ([0.0; 2], [0.0; 2])
    }
}

system!(Stack, 2, 2);

/// Case C42: the lower block is pulled: nothing moves, both move, the upper one slips.
#[test]
fn two_blocks_on_each_other() {
    for (force, modes, [upper, lower]) in [
        (4.9, [Mode::Sticks, Mode::Sticks], [0.0, 0.0]),
        (4.91, [Mode::Sticks, Mode::Forwards], [0.001, 0.001]),
        (20.0, [Mode::Sticks, Mode::Forwards], [3.019, 3.019]),
        (24.52, [Mode::Sticks, Mode::Forwards], [3.923, 3.923]),
        (24.53, [Mode::Backwards, Mode::Forwards], [3.924, 3.925_666_666_666_667]),
        (40.0, [Mode::Backwards, Mode::Forwards], [3.924, 9.082_333_333_333_333]),
    ] {
        let mut sim = Stack { force }.start_with(Dop853::new(1e-12)).unwrap();
        sim.step(1.0).unwrap();
        assert_eq!(sim.held.of, modes, "{force}");
        assert!((sim.x[2] - upper).abs() < 1e-11 && (sim.x[3] - lower).abs() < 1e-11, "{force}: {:?}", sim.x);
    }
}

/// One angle: a pendulum, or a bead on a circle of 1 m, 1 kg, from below.
#[derive(Clone, Copy, Debug)]
struct Angle {
    gravity: f64,
    /// A torque of friction, N m.
    torque: f64,
    /// A coefficient of friction on the reaction of the circle.
    coefficient: f64,
    start: [f64; 2],
}

impl Scene<1, 1> for Angle {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [-(T::lit(self.gravity) * q[0].sin())]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        [Row::fixed(q[0], [T::lit(1.0)])]
    }
    fn friction<T: Scalar>(&self, _t: T, q: [T; 1], v: [T; 1], rows: &mut Rows<T, 1>) {
        let reaction = v[0] * v[0] + T::lit(self.gravity) * q[0].cos();
        let own = T::lit(self.torque) + T::lit(self.coefficient) * reaction.abs();
        rows.set_friction(0, Limit::own(own));
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([self.start[0]], [self.start[1]])
    }
}

system!(Angle, 1, 1);

/// Case C44: amplitudes of a pendulum with a constant torque of friction, until it rests.
#[test]
fn a_pendulum_with_friction_in_its_hinge() {
    let start = [core::f64::consts::FRAC_PI_3, 0.0];
    let scene = Angle { gravity: GRAVITY, torque: 0.2, coefficient: 0.0, start };
    let mut sim = scene.start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(0.546_000_293_457_115_3).unwrap();
    assert!(sim.x[0].abs() < 1e-10, "{:?}", sim.x);
    let mut turns = vec![];
    let (mut last, mut time) = (sim.x[1], 0.546);
    while turns.len() < 3 {
        time += 1e-3;
        sim.step_to(time).unwrap();
        if last * sim.x[1] < 0.0 || sim.x[1] == 0.0 {
            turns.push(sim.x[0]);
        }
        last = sim.x[1];
    }
    // A millisecond after a turn it has come back by less than 5e-6 rad.
    for (found, exact) in
        turns.iter().zip([-0.998_334_532_278_349_8, 0.950_310_223_978_209_7, -0.903_052_596_006_498_3])
    {
        assert!((found - exact).abs() < 5e-6, "{found} {exact}");
    }
    sim.step_to(100.0).unwrap();
    assert_eq!(sim.held.of[0], Mode::Sticks);
    assert!(sim.x[0].abs() < 0.020_388_772_416_590_196);
    let place = sim.x;
    sim.step(3600.0).unwrap();
    assert_eq!(sim.x, place);
}

/// Cases C47 and C48: friction on the reaction of a ring, without gravity and with it.
#[test]
fn a_bead_on_a_ring_with_friction() {
    let mut sim = Angle { gravity: 0.0, torque: 0.0, coefficient: 0.2, start: [0.0, 3.0] }
        .start_with(Dop853::new(1e-12))
        .unwrap();
    sim.step_to(4.189_309_373_809_556).unwrap();
    assert!((sim.x[1] - 0.853_828_630_008_087_8).abs() < 1e-10, "{:?}", sim.x);
    sim.step_to(5.0).unwrap();
    assert!((sim.x[0] - 6.931_471_805_599_453).abs() < 1e-10, "{:?}", sim.x);
    assert!((sim.x[1] - 0.75).abs() < 1e-10, "{:?}", sim.x);
    let level = Angle {
        gravity: GRAVITY,
        torque: 0.0,
        coefficient: 0.2,
        start: [-core::f64::consts::FRAC_PI_2, 0.0],
    };
    let mut sim = level.start_with(Dop853::new(1e-12)).unwrap();
    let mut bottom = 0.0;
    for k in 1..2000 {
        let before = sim.x;
        sim.step_to(1e-3 * f64::from(k)).unwrap();
        if sim.x[0] > 0.0 {
            // v^2 changes by 2 (free - friction) dq.
            let slope = -0.2 * (before[1] * before[1] + GRAVITY);
            bottom = (before[1] * before[1] - 2.0 * slope * before[0]).sqrt();
            break;
        }
    }
    assert!((bottom - 3.185_389_354_168_705_3).abs() < 1e-4, "{bottom}");
}

/// A particle on a sphere of 1 m: x and y.
#[derive(Clone, Copy, Debug)]
struct Particle;

impl Scene<2, 1> for Particle {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Unilateral { restitution: 0.0 }]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2]) -> [T; 2] {
        [T::ZERO, T::lit(-GRAVITY)]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 2], v: [T; 2]) -> [Row<T, 2>; 1] {
        // z = (q.q - 1)/2, so that z'' = q.a + v.v
        let half = T::lit(0.5);
        let gap = half * (q[0] * q[0] + q[1] * q[1] - T::lit(1.0));
        [Row { rest: v[0] * v[0] + v[1] * v[1], ..Row::fixed(gap, q) }]
    }
    fn start(&self) -> ([f64; 2], [f64; 2]) {
        ([0.0, 1.0], [0.1, 0.0])
    }
}

system!(Particle, 2, 1);

/// Case C17: it leaves the sphere where the push is zero.
#[test]
fn a_particle_leaves_a_sphere() {
    let mut sim = Particle.start_with(Dop853::new(1e-12)).unwrap();
    let time = 1.270_346_989_271_610_4;
    sim.step_to(time - 1e-10).unwrap();
    assert_eq!(sim.held.of[0], Mode::Closed);
    assert!((sim.x[1] - 0.667_006_455_997_281_7).abs() < 1e-9, "{:?}", sim.x);
    assert!((sim.x[0].hypot(sim.x[1]) - 1.0).abs() < 1e-12);
    sim.step_to(time + 1e-10).unwrap();
    assert_eq!(sim.held.of[0], Mode::Open);
}
