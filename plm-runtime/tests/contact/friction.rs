//! Friction: oscillators, belts, inclines, discs that begin to roll, blocks on each other.

use core::f64::consts::PI;

use plm_runtime::contact::{Affine, Law, Limit, Load, Mode, Rows};
use plm_runtime::{Dop853, Mechanism, Scalar};

use crate::oscillator::Oscillator;
use crate::support::{Row, Scene, system};

const GRAVITY: f64 = 9.81;

/// Case C04: amplitudes fall by 2 mu N / k, until it rests within mu N / k.
#[test]
fn a_coulomb_oscillator_comes_to_rest() {
    let mut sim = Oscillator::RELEASED.start_with(Dop853::new(1e-12)).unwrap();
    let half = PI / 10.0;
    for (k, turn) in [0.1, -0.08038, 0.06076, -0.04114, 0.02152, -0.0019].into_iter().enumerate() {
        sim.step_to(half * k as f64).unwrap();
        assert!((sim.x[0] - turn).abs() < 1e-10, "{k}: {:?}", sim.x);
    }
    sim.step_to(1.6).unwrap();
    assert_eq!(sim.held.of[0], Mode::Sticks);
    let (place, steps) = (sim.x[0], sim.stats().steps);
    sim.step(3600.0).unwrap();
    assert_eq!(sim.x, [place, 0.0]);
    assert!(sim.stats().steps - steps < 20);
    assert!((place + 0.0019).abs() < 1e-11, "{place}");
}

/// Case C06: static above kinetic friction.
#[test]
fn a_mass_on_a_belt_sticks_and_slips() {
    let mut sim = Oscillator::ON_BELT.start_with(Dop853::new(1e-12)).unwrap();
    let (first, slips, period) = (0.3924, 0.433_536_962_770_418_6, 0.727_836_962_770_418_5);
    for k in 0..10 {
        let begun = first + f64::from(k) * period;
        for (at, before, after) in
            [(begun, Mode::Sticks, Mode::Backwards), (begun + slips, Mode::Backwards, Mode::Sticks)]
        {
            let mut sim = sim;
            sim.step_to(at - 1e-10).unwrap();
            assert_eq!(sim.held.of[0], before, "{k}");
            sim.step_to(at + 1e-10).unwrap();
            assert_eq!(sim.held.of[0], after, "{k}");
        }
        sim.step_to(begun).unwrap();
        assert!((sim.x[0] - 0.03924).abs() < 1e-10, "{k}: {:?}", sim.x);
        sim.step_to(begun + 0.5 * slips).unwrap();
        assert_eq!(sim.held.of[0], Mode::Backwards, "{k}");
        sim.step_to(begun + slips).unwrap();
        assert!((sim.x[0] - 0.00981).abs() < 1e-10, "{k}: {:?}", sim.x);
        sim.step_to(begun + slips + 0.1).unwrap();
        assert_eq!(sim.held.of[0], Mode::Sticks, "{k}");
        assert!((sim.x[0] - 0.01981).abs() < 1e-10, "{k}: {:?}", sim.x);
    }
}

/// A disc, hoop or sphere of radius 1 m and mass 1 kg on a plane that is inclined: along it, away from it, angle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Roller {
    /// Inertia over m r^2.
    pub(crate) inertia: f64,
    pub(crate) friction: f64,
    pub(crate) incline: f64,
    /// Speed along the plane, spin.
    pub(crate) start: [f64; 2],
}

impl Scene<3, 2> for Roller {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Unilateral { restitution: 0.0 }, Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        let (sin, cos) = self.incline.sin_cos();
        [T::lit(GRAVITY * sin), T::lit(-GRAVITY * cos), T::ZERO]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        let (one, none) = (T::lit(1.0), T::ZERO);
        [[one, none, none], [none, one, none], [none, none, T::lit(1.0 / self.inertia)]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], _v: [T; 3]) -> [Row<T, 3>; 2] {
        let (one, none) = (T::lit(1.0), T::ZERO);
        // It rolls forwards with a negative spin.
        [Row::fixed(q[1], [none, one, none]), Row::fixed(q[0] + q[2], [one, none, one])]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3], rows: &mut Rows<T, 2>) {
        rows.set_friction(1, Limit::of(0, T::lit(self.friction)));
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        ([0.0; 3], [self.start[0], 0.0, self.start[1]])
    }
}

system!(Roller, 3, 2);

/// Case C10: what is thrown sliding begins to roll.
#[test]
fn a_thrown_roller_begins_to_roll() {
    for (inertia, time, speed, way) in [
        (1.0, 1.274_209_989_806_320_2, 2.5, 4.778_287_461_773_7),
        (0.5, 0.849_473_326_537_546_7, 3.333_333_333_333_333_3, 3.539_472_193_906_444_6),
        (0.4, 0.728_119_994_175_04, 3.571_428_571_428_571_6, 3.120_514_260_750_171_7),
    ] {
        let scene = Roller { inertia, friction: 0.2, incline: 0.0, start: [5.0, 0.0] };
        let mut sim = scene.start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(time).unwrap();
        assert!((sim.x[0] - way).abs() < 1e-11, "{:?}", sim.x);
        sim.step_to(time + 1.0).unwrap();
        assert_eq!(sim.held.of, [Mode::Closed, Mode::Sticks]);
        assert!((sim.x[3] - speed).abs() < 1e-11, "{:?}", sim.x);
        assert!((sim.x[0] - way - speed).abs() < 1e-11, "{:?}", sim.x);
    }
}

/// Case C11: a disc with backspin comes back.
#[test]
fn a_disc_with_backspin_returns() {
    let scene = Roller { inertia: 0.5, friction: 0.2, incline: 0.0, start: [5.0, 12.0] };
    let mut sim = scene.start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(2.888_209_310_227_659).unwrap();
    assert!((sim.x[0] - 6.257_786_838_826_594).abs() < 1e-11, "{:?}", sim.x);
    sim.step(1.0).unwrap();
    assert!((sim.x[3] + 2.0 / 3.0).abs() < 1e-11, "{:?}", sim.x);
}

/// Case C12: on an incline it rolls up to tan a = mu (1 + 1/c), then it slips.
#[test]
fn a_disc_on_an_incline_rolls_or_slips() {
    for (degrees, mode, acceleration, turning) in [
        (30.0, Mode::Sticks, 3.27, 3.27),
        (35.0, Mode::Forwards, 4.019_608_529_708_76, 3.214_352_621_790_004),
        (30.9637, Mode::Sticks, f64::NAN, f64::NAN),
        (30.9638, Mode::Forwards, f64::NAN, f64::NAN),
    ] {
        let scene =
            Roller { inertia: 0.5, friction: 0.2, incline: f64::to_radians(degrees), start: [0.0, 0.0] };
        let mut sim = scene.start_with(Dop853::new(1e-12)).unwrap();
        sim.step(1.0).unwrap();
        assert_eq!(sim.held.of, [Mode::Closed, mode], "{degrees}");
        if acceleration.is_finite() {
            assert!((sim.x[3] - acceleration).abs() < 1e-11, "{degrees}: {:?}", sim.x);
            assert!((sim.x[5] + turning).abs() < 1e-11, "{degrees}: {:?}", sim.x);
        }
    }
}

/// A block on an incline: along it (up), away from it.
#[derive(Clone, Copy, Debug)]
struct Block {
    friction: f64,
    incline: f64,
    speed: f64,
}

impl Scene<2, 2> for Block {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Unilateral { restitution: 0.0 }, Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2]) -> [T; 2] {
        let (sin, cos) = self.incline.sin_cos();
        [T::lit(-GRAVITY * sin), T::lit(-GRAVITY * cos)]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 2]) -> [[T; 2]; 2] {
        [[T::lit(0.5), T::ZERO], [T::ZERO, T::lit(0.5)]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 2], _v: [T; 2]) -> [Row<T, 2>; 2] {
        let (one, none) = (T::lit(1.0), T::ZERO);
        [Row::fixed(q[1], [none, one]), Row::fixed(q[0], [one, none])]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2], rows: &mut Rows<T, 2>) {
        rows.set_friction(1, Limit::of(0, T::lit(self.friction)));
    }
    fn start(&self) -> ([f64; 2], [f64; 2]) {
        ([0.0; 2], [self.speed, 0.0])
    }
}

system!(Block, 2, 2);

/// Case C08: thrown up an incline, and back; what rests within the angle of friction.
#[test]
fn a_block_on_an_incline() {
    let block = |degrees: f64, speed: f64| Block { friction: 0.3, incline: degrees.to_radians(), speed };
    let mut sim = block(20.0, 3.0).start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(0.490_137_374_950_454_4).unwrap();
    assert!((sim.x[0] - 0.735_206_062_425_681_5).abs() < 1e-11, "{:?}", sim.x);
    let back = (2.0 * 0.735_206_062_425_681_5 / 0.589_702_223_051_881_9_f64).sqrt();
    sim.step(back).unwrap();
    assert!(sim.x[0].abs() < 1e-10, "{:?}", sim.x);
    assert!((sim.x[2] + 0.931_184_889_711_645_9).abs() < 1e-10, "{:?}", sim.x);
    let mut sim = block(10.0, 3.0).start_with(Dop853::new(1e-12)).unwrap();
    sim.step(10.0).unwrap();
    assert!((sim.x[0] - 0.977_882_930_561_700_8).abs() < 1e-11, "{:?}", sim.x);
    assert_eq!((sim.x[2], sim.held.of[1]), (0.0, Mode::Sticks));
    for (degrees, mode) in [(16.6992, Mode::Sticks), (16.6993, Mode::Backwards)] {
        let mut sim = block(degrees, 0.0).start_with(Dop853::new(1e-12)).unwrap();
        sim.step(1.0).unwrap();
        assert_eq!(sim.held.of[1], mode, "{degrees}");
    }
}

/// Case C09: at 99 % of the angle of friction, an hour.
#[test]
fn what_sticks_stays_where_it_is() {
    let scene = Block { friction: 0.3, incline: 16.532_251_791_653_685_f64.to_radians(), speed: 0.0 };
    let mut sim = scene.start_with(Dop853::new(1e-12)).unwrap();
    sim.step(3600.0).unwrap();
    assert_eq!(sim.x, [0.0; 4]);
    assert!(sim.stats().steps < 20, "{:?}", sim.stats());
    let [push, friction] = plm_runtime::contact::reactions(&scene, 0.0, &sim.held, &sim.x);
    assert!((friction / (0.3 * push) - 0.989_419_624_342_013_6).abs() < 1e-12);
}

/// Two blocks of 1 kg in guides, pressed by forces in the plane: one slides, and the other one sticks under a force that swings.
#[derive(Clone, Copy, Debug)]
struct Guides;

/// The force that swings, N, and its frequency, rad/s.
const SWING: [f64; 2] = [5.05, 20.0];

impl Scene<2, 2> for Guides {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Friction; 2]
    }
    fn free<T: Scalar>(&self, t: T, _q: [T; 2], _v: [T; 2]) -> [T; 2] {
        let [size, omega] = SWING.map(T::lit);
        [T::ZERO, size * (omega * t).sin()]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 2], _v: [T; 2]) -> [Row<T, 2>; 2] {
        [0, 1].map(|i| Row::fixed(q[i], core::array::from_fn(|k| T::lit(f64::from(u8::from(k == i))))))
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2], rows: &mut Rows<T, 2>) {
        for (load, force, share, coupling) in [(0, [30.0, 40.0], 0.1, 0.5), (1, [3.0, 4.0], 1.0, 0.0)] {
            let affine = |own: f64, by: f64| {
                let by = core::array::from_fn(|row| T::lit(if row == load { by } else { 0.0 }));
                Affine { own: T::lit(own), by }
            };
            rows.reaction[load] = [affine(force[0], coupling), affine(force[1], 0.0)];
            (rows.load[load], rows.read[load][load]) = (Load::Plane, true);
            let share = core::array::from_fn(|of| T::lit(if of == load { share } else { 0.0 }));
            rows.set_friction(load, Limit { share, ..Limit::none() });
        }
    }
    fn start(&self) -> ([f64; 2], [f64; 2]) {
        ([0.0; 2], [100.0, 0.0])
    }
}

system!(Guides, 2, 2);

/// A force that swings 2.7 times in one step passes the bound of 5 N for a moment in each half of a period. Between these moments nothing
/// but the other block moves, whose force follows from l = -0.1 |(30 + 0.5 l, 40)|.
#[test]
fn a_load_that_swings_within_a_step_breaks_a_friction_away() {
    let [size, omega] = SWING;
    let begin = (5.0 / size).asin() / omega;
    let speed = |t: f64| size / omega * ((omega * begin).cos() - (omega * t).cos()) - 5.0 * (t - begin);
    let (mut low, mut high) = (0.5 * PI / omega, PI / omega);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *if speed(middle) > 0.0 { &mut low } else { &mut high } = middle;
    }
    let along = (omega * begin).cos() * (low - begin) - ((omega * low).sin() - (omega * begin).sin()) / omega;
    let moved = size / omega * along - 2.5 * (low - begin) * (low - begin);
    // (1 - 0.0025) l^2 - 0.3 l - 25 = 0
    let force = (0.3 - (0.09_f64 + 100.0 * 0.9975).sqrt()) / (2.0 * 0.9975);
    for tolerance in [1e-6, 1e-10] {
        let mut sim = Guides.start_with(Dop853::new(tolerance)).unwrap();
        assert_eq!(sim.held.of, [Mode::Forwards, Mode::Sticks]);
        sim.step_to(0.85).unwrap();
        assert_eq!(sim.held.of, [Mode::Forwards, Mode::Sticks]);
        assert!((sim.x[1] / moved - 1.0).abs() < 1e-5, "{tolerance}: {} {moved}", sim.x[1]);
        assert!((sim.x[2] - 100.0 - 0.85 * force).abs() < 1e-12 * 100.0, "{}", sim.x[2]);
    }
}
