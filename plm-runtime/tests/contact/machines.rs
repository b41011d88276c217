//! Machines with friction by reactions of their joints: a rope on a drum, a planetary gear, a slider that is driven.

use core::f64::consts::PI;

use plm_runtime::contact::{self, Affine, Friction, Law, Limit, Load, Mode, Rows};
use plm_runtime::{Dop853, Mechanism, Scalar};

use crate::bodies::GRAVITY;
use crate::support::{Row, Scene, system};

/// Two masses on a rope over a rough drum, 1 kg on the other side: how far the first one has sunk.
#[derive(Clone, Copy, Debug)]
struct Capstan {
    first: f64,
}

/// Tensions slip in this ratio, exp(mu beta), half a turn with mu = 0.25.
fn ratio() -> f64 {
    (0.25 * PI).exp()
}

impl Scene<1, 1> for Capstan {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [T::lit(GRAVITY * (self.first - 1.0) / (self.first + 1.0))]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 1]) -> [[T; 1]; 1] {
        [[T::lit(1.0 / (self.first + 1.0))]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        [Row::fixed(q[0], [T::lit(1.0)])]
    }
    fn friction<T: Scalar>(&self, t: T, q: [T; 1], v: [T; 1], rows: &mut Rows<T, 1>) {
        // The tension of the second mass, g + a; that of the first is exp(mu beta) of it, or one over that.
        let free = self.free(t, q, v)[0] + T::lit(GRAVITY);
        rows.reaction[0][0] = Affine { own: free, by: [T::lit(1.0 / (self.first + 1.0))] };
        rows.load[0] = Load::Line { negative: false };
        rows.read[0][0] = true;
        let [lower, upper] = [ratio() - 1.0, 1.0 - 1.0 / ratio()]
            .map(|share| Limit { share: [T::lit(share)], ..Limit::none() });
        rows.kinetic[0] = Friction { lower, upper };
        rows.adhesion[0] = rows.kinetic[0];
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([0.0], [0.0])
    }
}

system!(Capstan, 1, 1);

/// Case C34 (L. Euler, J. A. Eytelwein): it holds up to this ratio of the masses, and slips with a = g (m1 - K m2)/(m1 + K m2).
#[test]
fn a_rope_on_a_drum_holds_or_slips() {
    let holds = 2.193_280_050_738_015_7;
    assert!((ratio() - holds).abs() < 1e-15);
    let inverse = 1.0 / holds;
    for (first, mode) in [
        (2.0, Mode::Sticks),
        (holds * (1.0 - 1e-8), Mode::Sticks),
        (holds * (1.0 + 1e-8), Mode::Forwards),
        (3.0, Mode::Forwards),
        (inverse * (1.0 + 1e-8), Mode::Sticks),
        (inverse * (1.0 - 1e-8), Mode::Backwards),
        (0.2, Mode::Backwards),
    ] {
        let mut sim = Capstan { first }.start_with(Dop853::new(1e-10)).unwrap();
        assert_eq!(sim.held.of[0], mode, "{first}");
        sim.step(1.0).unwrap();
        let slips = |k: f64| GRAVITY * (first - k) / (first + k);
        let acceleration = match mode {
            Mode::Forwards => slips(holds),
            Mode::Backwards => slips(inverse),
            _ => 0.0,
        };
        assert!((sim.x[0] - 0.5 * acceleration).abs() < 1e-12 && (sim.x[1] - acceleration).abs() < 1e-12);
        assert!(first != 3.0 || (acceleration - 1.523_877_515_739_869_2).abs() < 1e-14);
    }
}

/// A planetary gear with the ring held, sun 24, planet 24, ring 72 teeth of 1 mm radius each: the angle of the sun.
#[derive(Clone, Copy, Debug)]
struct Planetary {
    /// What each mesh lets through.
    efficiency: f64,
    /// The torque on the carrier, against its motion, N m.
    load: f64,
}

const SUN: f64 = 0.024;
const TORQUE: f64 = 10.0;
/// Inertias of sun, planet, and carrier with the mass of the planet, kg m^2.
const INERTIA: [f64; 3] = [2e-3, 1e-3, 9e-3];

impl Planetary {
    /// The inertia at the sun: the planet turns by -1/2 of its angle, the carrier by 1/4.
    fn inertia() -> f64 {
        INERTIA[0] + INERTIA[1] / 4.0 + INERTIA[2] / 16.0
    }
}

impl Scene<1, 2> for Planetary {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Friction; 2]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [T::lit((TORQUE - 0.25 * self.load) / Self::inertia())]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 1]) -> [[T; 1]; 1] {
        [[T::lit(1.0 / Self::inertia())]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 2] {
        // Sun and planet beside the carrier.
        [0.75, -0.75].map(|w| Row::fixed(T::lit(w) * q[0], [T::lit(w)]))
    }
    fn friction<T: Scalar>(&self, t: T, q: [T; 1], v: [T; 1], rows: &mut Rows<T, 2>) {
        // Forces of the meshes: J a = T - r F1 + l1 of the sun, -J a/2 = r (F2 - F1) + l2 of the planet.
        let (own, by) = (self.free(t, q, v)[0], [0.75, -0.75].map(|w| w / Self::inertia()));
        let lit = T::lit;
        let first = Affine {
            own: (lit(TORQUE) - lit(INERTIA[0]) * own) / lit(SUN),
            by: [lit((1.0 - INERTIA[0] * by[0]) / SUN), lit(-INERTIA[0] * by[1] / SUN)],
        };
        let planet = |a: f64| -0.5 * INERTIA[1] * a / SUN;
        let second = Affine {
            own: first.own - lit(0.5 * INERTIA[1] / SUN) * own,
            by: [first.by[0] + lit(planet(by[0])), first.by[1] + lit(planet(by[1]) - 1.0 / SUN)],
        };
        let share = lit(SUN * (1.0 / self.efficiency - 1.0));
        for (row, reaction) in [first, second].into_iter().enumerate() {
            rows.reaction[row][0] = reaction;
            rows.load[row] = Load::Line { negative: false };
            rows.read[row][row] = true;
            let share = core::array::from_fn(|load| if load == row { share } else { T::ZERO });
            rows.set_friction(row, Limit { share, ..Limit::none() });
        }
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([0.0], [100.0])
    }
}

system!(Planetary, 1, 2);

/// Case C36 (R. Willis; VDI 2157): at the torque 1 + i0 eta^2 of the sun's on the carrier the speed stays; 40 N m without losses.
#[test]
fn a_planetary_gear_transmits_its_torque() {
    for (efficiency, load) in [(1.0, 40.0), (0.97, 38.227)] {
        let gear = |load: f64| {
            let mut sim = Planetary { efficiency, load }.start_with(Dop853::new(1e-10)).unwrap();
            sim.step(1.0).unwrap();
            sim
        };
        let sim = gear(load);
        assert!((sim.x[1] - 100.0).abs() < 1e-9 && (sim.x[0] - 100.0).abs() < 1e-9, "{:?}", sim.x);
        let (carrier, power) = (0.25 * sim.x[1], TORQUE * sim.x[1]);
        let share = load * carrier / power;
        assert!((share - if efficiency < 1.0 { 0.955_675 } else { 1.0 }).abs() < 1e-11, "{share}");
        // More load slows it down, less makes it faster.
        assert!(gear(load + 0.1).x[1] < 99.0 && gear(load - 0.1).x[1] > 101.0);
    }
}

/// A slider of 2 kg with a friction of 15 N, whose crank of 0.1 m turns with 20 rad/s at a rod of 0.3 m: nothing is free.
#[derive(Clone, Copy, Debug)]
struct Driven;

const SPEED: f64 = 20.0;

/// Place, speed, acceleration of the slider, and its slope over the angle of the crank.
fn slider<T: Scalar>(t: T) -> [T; 4] {
    let (sin, cos) = (T::lit(SPEED) * t).sin_cos();
    let (crank, rod) = (T::lit(0.1), T::lit(0.09));
    let across = crank * sin;
    let along = (rod - across * across).sqrt();
    let (slope, turns) = (-across - across * crank * cos / along, T::lit(SPEED));
    let cos2 = cos * cos - sin * sin;
    let bend = -(crank * cos)
        - crank * crank * (cos2 / along + crank * crank * sin * sin * cos * cos / (along * along * along));
    [crank * cos + along, slope * turns, bend * turns * turns, slope]
}

impl Scene<1, 1> for Driven {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [T::ZERO]
    }
    fn contact<T: Scalar>(&self, t: T, _q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        let [gap, drive, rest, _] = slider(t);
        [Row { gap, direction: [T::ZERO], drive, rest }]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1], rows: &mut Rows<T, 1>) {
        rows.set_friction(0, Limit::own(T::lit(15.0)));
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([0.0], [0.0])
    }
}

system!(Driven, 1, 1);

/// Case C56: the torque of the crank (m x'' + F sign x') dx/dphi; the friction changes its side at each dead centre and does 4 F r a turn.
#[test]
fn a_driven_slider_rubs() {
    let mut sim = Driven.start_with(Dop853::new(1e-10)).unwrap();
    let torque = |sim: &plm_runtime::Sim<Driven>| {
        let [force] = contact::reactions(&Driven, sim.time, &sim.held, &sim.x);
        let [_, _, acceleration, slope] = slider(sim.time);
        (2.0 * acceleration - force) * slope
    };
    assert!((slider(0.0_f64)[2] + 53.333_333_333_333_336).abs() < 1e-12);
    for turn in 0..3 {
        for (degrees, mode, known) in [
            (1e-6, Mode::Backwards, f64::NAN),
            (60.0, Mode::Backwards, 4.240_668_211_784_328),
            (180.0 - 1e-6, Mode::Backwards, f64::NAN),
            (180.0 + 1e-6, Mode::Forwards, f64::NAN),
            (200.0, Mode::Forwards, 1.622_939_676_906_341_3),
            (360.0 - 1e-6, Mode::Forwards, f64::NAN),
        ] {
            let angle = f64::to_radians(degrees) + f64::from(turn) * 2.0 * PI;
            sim.step_to(angle / SPEED).unwrap();
            assert_eq!(sim.held.of[0], mode, "{turn} {degrees}");
            assert!(known.is_nan() || (torque(&sim) - known).abs() < 1e-12, "{degrees}: {}", torque(&sim));
        }
    }
    assert_eq!(sim.stats().switches, 5);
}
