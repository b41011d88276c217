//! Impacts: bouncing balls, a cradle, an oblique impact, a pendulum at a wall.

use plm_runtime::contact::{ImpactLaw, Law, Limit, Mode, Rows};
use plm_runtime::{Dop853, Mechanism, Scalar};

use crate::support::{Row, Scene, system};

const GRAVITY: f64 = 9.81;

/// A ball that falls from `height` on ground that is inclined by `angle`: along the slope, and away from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    pub(crate) height: f64,
    pub(crate) angle: f64,
    pub(crate) restitution: f64,
}

impl Scene<2, 1> for Ball {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Unilateral { restitution: self.restitution }]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2]) -> [T; 2] {
        [T::lit(GRAVITY * self.angle.sin()), T::lit(-GRAVITY * self.angle.cos())]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 2], _v: [T; 2]) -> [Row<T, 2>; 1] {
        [Row::fixed(q[1], [T::ZERO, T::lit(1.0)])]
    }
    fn start(&self) -> ([f64; 2], [f64; 2]) {
        ([0.0, self.height * self.angle.cos()], [0.0, 0.0])
    }
}

system!(Ball, 2, 1);

/// Case C01: a ball comes to rest in finite time, after infinitely many bounces.
#[test]
fn a_bouncing_ball_comes_to_rest() {
    let mut sim = Ball { height: 1.0, angle: 0.0, restitution: 0.5 }.start_with(Dop853::new(1e-12)).unwrap();
    let fall = (2.0 / GRAVITY).sqrt();
    sim.step_to(1.5 * fall).unwrap();
    assert!((sim.x[1] - 0.25).abs() < 1e-12, "{:?}", sim.x);
    let rest = 3.0 * fall;
    sim.step_to(rest).unwrap();
    assert!(sim.x[1].abs() < 1e-12 && sim.x[3].abs() < 1e-12, "{:?}", sim.x);
    let before = sim.stats();
    sim.step(3600.0).unwrap();
    assert_eq!((sim.x[1], sim.x[3], sim.held.of[0]), (sim.x[1], 0.0, Mode::Closed));
    assert!(sim.x[1].abs() < 1e-12);
    assert!(sim.stats().steps - before.steps < 20, "{:?}", sim.stats());
}

/// Case C03: it goes on sliding down.
#[test]
fn a_ball_on_a_smooth_incline_slides_at_last() {
    let ball = Ball { height: 1.0, angle: 30.0_f64.to_radians(), restitution: 0.6 };
    let mut sim = ball.start_with(Dop853::new(1e-12)).unwrap();
    let first = 0.451_523_640_985_730_9;
    sim.step_to(first).unwrap();
    let (begun, along) = (sim.x[0], GRAVITY * 0.5);
    sim.step_to(1.806_094_563_943_0).unwrap();
    assert!((sim.x[0] - begun - 7.5).abs() < 1e-9, "{:?}", sim.x);
    assert!((sim.x[2] - 8.858_893_836_140_041).abs() < 1e-9, "{:?}", sim.x);
    sim.step_to(2.0).unwrap();
    assert_eq!(sim.held.of[0], Mode::Closed);
    assert!((sim.x[0] - 0.5 * along * 4.0).abs() < 1e-11, "{:?}", sim.x);
    assert!(sim.x[1].abs() < 1e-11);
}

/// Balls in a row, with a gap between each two.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cradle {
    pub(crate) gap: f64,
    pub(crate) restitution: f64,
    pub(crate) law: ImpactLaw,
}

impl Scene<3, 2> for Cradle {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Unilateral { restitution: self.restitution }; 2]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        [T::ZERO; 3]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], _v: [T; 3]) -> [Row<T, 3>; 2] {
        let (one, none) = (T::lit(1.0), T::ZERO);
        [Row::fixed(q[1] - q[0], [-one, one, none]), Row::fixed(q[2] - q[1], [none, -one, one])]
    }
    fn impacts(&self) -> ImpactLaw {
        self.law
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        ([-0.1, 0.0, self.gap], [1.0, 0.0, 0.0])
    }
}

system!(Cradle, 3, 2);

/// Case C15: three balls; touching ones by each law.
#[test]
fn a_cradle_by_each_law() {
    let third = 1.0 / 3.0;
    for (gap, restitution, law, after) in [
        (0.01, 1.0, ImpactLaw::Poisson, [0.0, 0.0, 1.0]),
        (0.01, 1.0, ImpactLaw::Newton, [0.0, 0.0, 1.0]),
        (0.01, 0.9, ImpactLaw::Poisson, [0.05, 0.0475, 0.9025]),
        (0.0, 1.0, ImpactLaw::Sequential, [0.0, 0.0, 1.0]),
        (0.0, 1.0, ImpactLaw::Newton, [-third, 2.0 * third, 2.0 * third]),
        (0.0, 1.0, ImpactLaw::Poisson, [-third, 2.0 * third, 2.0 * third]),
        (0.0, 0.0, ImpactLaw::Poisson, [third; 3]),
    ] {
        let mut sim = Cradle { gap, restitution, law }.start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(0.2).unwrap();
        for i in 0..3 {
            assert!((sim.x[3 + i] - after[i]).abs() < 1e-12, "{law:?} {gap} {restitution}: {:?}", sim.x);
        }
    }
}

/// A disc of radius 0.1 m over a rough floor: x, height of its lowest point, angle.
#[derive(Clone, Copy, Debug)]
struct Disc {
    friction: f64,
    law: ImpactLaw,
}

impl Scene<3, 2> for Disc {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Unilateral { restitution: 0.8 }, Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        [T::ZERO; 3]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        let (one, none) = (T::lit(1.0), T::ZERO);
        [[one, none, none], [none, one, none], [none, none, T::lit(200.0)]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], _v: [T; 3]) -> [Row<T, 3>; 2] {
        let (one, none) = (T::lit(1.0), T::ZERO);
        [Row::fixed(q[1], [none, one, none]), Row::fixed(none, [one, none, T::lit(0.1)])]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3], rows: &mut Rows<T, 2>) {
        rows.set_friction(1, Limit::of(0, T::lit(self.friction)));
    }
    fn impacts(&self) -> ImpactLaw {
        self.law
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        ([0.0, 0.2, 0.0], [3.0, -2.0, 0.0])
    }
}

system!(Disc, 3, 2);

/// Case C29: a disc strikes a rough floor. Its slip ends within the impact from mu = 0.2778 on.
#[test]
fn an_oblique_impact_slips_or_sticks() {
    for law in [ImpactLaw::Newton, ImpactLaw::Poisson] {
        for (friction, after) in [(0.05, [2.82, 1.6, -3.6]), (0.3, [2.0, 1.6, -20.0])] {
            let mut sim = Disc { friction, law }.start_with(Dop853::new(1e-12)).unwrap();
            sim.step_to(0.15).unwrap();
            for i in 0..3 {
                assert!((sim.x[3 + i] - after[i]).abs() < 1e-12, "{law:?} {friction}: {:?}", sim.x);
            }
        }
    }
}

/// A pendulum of a point mass, 1 m long, with a wall at its lowest point.
#[derive(Clone, Copy, Debug)]
struct Pendulum;

impl Scene<1, 1> for Pendulum {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Unilateral { restitution: 0.7 }]
    }
    fn free<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [-(T::lit(GRAVITY) * q[0].sin())]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        [Row::fixed(q[0], [T::lit(1.0)])]
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([core::f64::consts::FRAC_PI_3], [0.0])
    }
}

system!(Pendulum, 1, 1);

/// Case C26: it strikes the wall at these times, with these amplitudes between.
#[test]
fn a_pendulum_strikes_a_wall() {
    let times =
        [0.538_218_666_720_129, 1.574_285_377_335_238_3, 2.592_900_903_225_063_4, 3.603_434_181_165_172_2];
    let amplitudes = [0.715_142_207_291_020_5, 0.495_039_385_067_631_84, 0.344_704_052_068_480_26];
    let mut sim = Pendulum.start_with(Dop853::new(1e-12)).unwrap();
    for k in 0..3 {
        sim.step_to(times[k] - 1e-10).unwrap();
        assert!(sim.x[1] < 0.0, "{k}: {:?}", sim.x);
        sim.step_to(times[k] + 1e-10).unwrap();
        assert!(sim.x[1] > 0.0, "{k}: {:?}", sim.x);
        sim.step_to(0.5 * (times[k] + times[k + 1])).unwrap();
        assert!((sim.x[0] - amplitudes[k]).abs() < 1e-9, "{k}: {:?}", sim.x);
        assert!(sim.x[1].abs() < 1e-9, "{k}: {:?}", sim.x);
    }
}
