//! Bodies with several contacts: a rocking block, a cube, a ladder, a rod, a rimless wheel, blocks on each other.

use plm_runtime::contact::{Law, Limit, Mode, Rows};
use plm_runtime::{Dop853, Mechanism, Scalar};

use crate::support::{Row, Scene, system};

pub(crate) const GRAVITY: f64 = 9.81;

/// A body of mass 1 kg over a floor: x and y of its centre, its angle. Two of its points touch, each with friction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Body {
    pub(crate) inertia: f64,
    pub(crate) points: [[f64; 2]; 2],
    pub(crate) friction: f64,
    pub(crate) restitution: f64,
    pub(crate) start: ([f64; 3], [f64; 3]),
}

/// A point of a body over the line that is normal to `normal`: its gap and its way along.
pub(crate) fn point<T: Scalar>(q: [T; 3], v: [T; 3], point: [f64; 2], normal: [f64; 2]) -> [Row<T, 3>; 2] {
    let (sin, cos) = q[2].sin_cos();
    let [a, b] = point.map(T::lit);
    let arm = [a * cos - b * sin, a * sin + b * cos];
    let omega2 = v[2] * v[2];
    let along = |direction: [f64; 2]| {
        let [x, y] = direction.map(T::lit);
        Row {
            gap: x * (q[0] + arm[0]) + y * (q[1] + arm[1]),
            direction: [x, y, y * arm[0] - x * arm[1]],
            drive: T::ZERO,
            rest: -(omega2 * (x * arm[0] + y * arm[1])),
        }
    };
    [along(normal), along([normal[1], -normal[0]])]
}

pub(crate) fn inverse_mass<T: Scalar>(inertia: f64) -> [[T; 3]; 3] {
    let (one, none) = (T::lit(1.0), T::ZERO);
    [[one, none, none], [none, one, none], [none, none, T::lit(1.0 / inertia)]]
}

impl Scene<3, 4> for Body {
    fn laws(&self) -> [Law<f64>; 4] {
        let normal = Law::Unilateral { restitution: self.restitution };
        [normal, Law::Friction, normal, Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        [T::ZERO, T::lit(-GRAVITY), T::ZERO]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        inverse_mass(self.inertia)
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], v: [T; 3]) -> [Row<T, 3>; 4] {
        let [a, b] = self.points.map(|at| point(q, v, at, [0.0, 1.0]));
        [a[0], a[1], b[0], b[1]]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3], rows: &mut Rows<T, 4>) {
        rows.set_friction(1, Limit::of(0, T::lit(self.friction)));
        rows.set_friction(3, Limit::of(2, T::lit(self.friction)));
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        self.start
    }
}

system!(Body, 3, 4);

/// A block of half width 0.1 m and half height 0.5 m that stands on its right corner, turned by `angle` to the right.
pub(crate) fn rocking(angle: f64) -> Body {
    let (b, h) = (0.1_f64, 0.5_f64);
    let (sin, cos) = angle.sin_cos();
    // The right corner is in the origin, and turns by -angle.
    Body {
        inertia: (b * b + h * h) / 3.0,
        points: [[-b, -h], [b, -h]],
        friction: 10.0,
        restitution: 0.0,
        start: ([-b * cos + h * sin, b * sin + h * cos, -angle], [0.0; 3]),
    }
}

/// Case C13: a rocking block (Housner 1963): times of its impacts and the amplitudes between, until it stands.
#[test]
fn a_rocking_block_comes_to_rest() {
    let alpha = 0.2_f64.atan();
    let mut sim = rocking(0.5 * alpha).start_with(Dop853::new(1e-12)).unwrap();
    let times =
        [0.347_093_586_788_881_3, 0.950_920_536_477_668_3, 1.487_939_643_105_267, 1.972_072_334_511_498];
    let amplitudes = [0.083_339_113_164_354_69, 0.071_253_454_724_768_92, 0.061_415_146_055_206_21];
    for k in 0..3 {
        // It turns over the other corner from here on.
        let corner = |modes: [Mode; 4]| modes[0] == Mode::Closed;
        sim.step_to(times[k] - 1e-10).unwrap();
        assert_eq!(corner(sim.held.of), k % 2 == 1, "{k}");
        assert!(k > 0 || (sim.x[5] - 0.648_049_012_267_532_3).abs() < 1e-9, "{:?}", sim.x);
        sim.step_to(times[k] + 1e-10).unwrap();
        assert_eq!(corner(sim.held.of), k % 2 == 0, "{k}");
        sim.step_to(0.5 * (times[k] + times[k + 1])).unwrap();
        assert!((sim.x[2].abs() - amplitudes[k]).abs() < 1e-9, "{k}: {:?}", sim.x);
        assert!(sim.x[5].abs() < 1e-8, "{k}: {:?}", sim.x);
    }
    sim.step_to(8.66).unwrap();
    assert!(sim.x[2].abs() < 1e-9 && sim.held.is_sticking(1) && sim.held.is_sticking(3), "{:?}", sim.held);
    assert!(sim.held.are_undetermined());
    let (place, steps) = (sim.x, sim.stats().steps);
    sim.step(3600.0).unwrap();
    for i in 0..6 {
        assert!((sim.x[i] - place[i]).abs() < 1e-12, "{:?}", sim.x);
    }
    assert!(sim.stats().steps - steps < 100, "{steps} {:?}", sim.stats());
}

/// Case C53: a cube that slides does not lift; three quarters of its weight are on the front edge. From mu = 1 on it tips.
#[test]
fn a_cube_slides_without_lifting() {
    let cube = |friction: f64| Body {
        inertia: 0.01 / 6.0,
        points: [[-0.05, -0.05], [0.05, -0.05]],
        friction,
        restitution: 0.0,
        start: ([0.0, 0.05, 0.0], [6.0, 0.0, 0.0]),
    };
    let mut sim = cube(0.5).start_with(Dop853::new(1e-12)).unwrap();
    let [rear, _, front, _] =
        plm_runtime::contact::reactions(&cube(0.5), 0.0, &sim.held, &sim.x).map(|force| force / GRAVITY);
    assert!((rear - 0.25).abs() < 1e-12 && (front - 0.75).abs() < 1e-12);
    sim.step(3.0).unwrap();
    assert!((sim.x[0] - 3.669_724_770_642_201_6).abs() < 1e-11, "{:?}", sim.x);
    assert!(sim.x[2].abs() < 1e-12 && (sim.x[1] - 0.05).abs() < 1e-12, "{:?}", sim.x);
    let tips = cube(1.01).start_with(Dop853::new(1e-12)).unwrap();
    assert_eq!(tips.held.of[0], Mode::Open);
}

/// A body that is thrown on its centre bounces and slides to rest: all impulses of the floor together are m (g t + v), and friction takes
/// its share of them, those of the flights too that are too low to be followed.
#[test]
fn a_thrown_body_loses_its_speed_to_all_impulses() {
    for restitution in [0.0, 0.3, 0.8] {
        let thrown = Body {
            inertia: 1.0,
            points: [[0.0, 0.0], [0.0, 1.0]],
            friction: 0.2,
            restitution,
            start: ([0.0, 0.05, 0.0], [5.0, -0.5, 0.0]),
        };
        let mut sim = thrown.start_with(Dop853::new(1e-12)).unwrap();
        sim.step(2.0).unwrap();
        assert_eq!((sim.held.of[0], sim.x[4]), (Mode::Closed, 0.0));
        let speed = 5.0 - 0.2 * (GRAVITY * 2.0 + 0.5);
        assert!((sim.x[3] - speed).abs() < 1e-11, "{restitution}: {:e}", sim.x[3] - speed);
    }
}

/// A rod of 1 m that falls flat but for `slope` has D = [4, -2; -2, 4]/kg at its ends. With e = 1/2 the lower end throws the other one down
/// with 7/4 of the speed of the fall, which throws the lower one down again with 13/16: they leave with 13/32 and 17/64. Within
/// rounding they strike at once, and leave with 1/2.
#[test]
fn a_rod_lands_on_one_end_and_then_on_the_other() {
    let (height, after) = (0.1, 0.01);
    for (slope, left, right) in [
        (1e-9, 13.0 / 32.0, 17.0 / 64.0),
        (-1e-11, 17.0 / 64.0, 13.0 / 32.0),
        (1e-12, 13.0 / 32.0, 17.0 / 64.0),
        (4e-15, 0.5, 0.5),
        (0.0, 0.5, 0.5),
    ] {
        let rod = Body {
            inertia: 1.0 / 12.0,
            points: [[-0.5, 0.0], [0.5, 0.0]],
            friction: 0.0,
            restitution: 0.5,
            start: ([0.0, height, slope], [0.0; 3]),
        };
        let fallen = height - 0.5 * f64::abs(slope);
        let (time, speed) = ((2.0 * fallen / GRAVITY).sqrt(), (2.0 * GRAVITY * fallen).sqrt());
        let mut sim = rod.start_with(Dop853::new(1e-10)).unwrap();
        sim.step_to(time + after).unwrap();
        let known = [0.5 * (left + right) * speed - GRAVITY * after, (right - left) * speed];
        // Gravity acts between the impacts: for 4/7 and 32/91 of the slope over the speed, and each one passes that on.
        let most = 1e-11 + 2.0 * GRAVITY * f64::abs(slope) / speed;
        for (found, known) in sim.x[4..].iter().zip(known) {
            assert!((found - known).abs() < most, "{slope}: {found} {known}");
        }
    }
}

/// A ladder of 2 m, 1 kg, against a smooth wall on a smooth floor.
#[derive(Clone, Copy, Debug)]
struct Ladder;

impl Scene<3, 2> for Ladder {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Unilateral { restitution: 0.0 }; 2]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        [T::ZERO, T::lit(-GRAVITY), T::ZERO]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        inverse_mass(1.0 / 3.0)
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], v: [T; 3]) -> [Row<T, 3>; 2] {
        let top = point(q, v, [0.0, 1.0], [1.0, 0.0]);
        let foot = point(q, v, [0.0, -1.0], [0.0, 1.0]);
        [top[0], foot[0]]
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        let angle = 15.0_f64.to_radians();
        ([angle.sin(), angle.cos(), angle], [0.0; 3])
    }
}

system!(Ladder, 3, 2);

/// Case C18: it leaves the wall at cos th = 2/3 cos th0.
#[test]
fn a_ladder_leaves_the_wall() {
    let mut sim = Ladder.start_with(Dop853::new(1e-12)).unwrap();
    let leaves = 0.698_777_341_146_781_6;
    sim.step_to(leaves - 1e-10).unwrap();
    assert_eq!(sim.held.of, [Mode::Closed; 2]);
    sim.step_to(leaves + 1e-10).unwrap();
    assert_eq!(sim.held.of, [Mode::Open, Mode::Closed]);
    assert!((sim.x[2].to_degrees() - 49.912_963_091_516_716).abs() < 1e-7, "{:?}", sim.x);
    sim.step(0.05).unwrap();
    assert!((sim.x[3] - 1.401_663_983_174_746_2).abs() < 1e-9, "{:?}", sim.x);
}

/// It rests on two corners and both frictions, one of which the others carry: nothing moves, at any tolerance, and steps grow without
/// end.
#[test]
fn a_block_on_two_corners_rests_for_an_hour() {
    for tolerance in [1e-4, 1e-8, 1e-12] {
        for (friction, x) in [(0.2, 0.0), (0.7, 12.3), (10.0, 0.37)] {
            let mut block = rocking(0.0);
            block.friction = friction;
            block.start.0[0] += x;
            let mut sim = block.start_with(Dop853::new(tolerance)).unwrap();
            sim.step(3600.0).unwrap();
            assert_eq!(sim.x, [-0.1 + x, 0.5, 0.0, 0.0, 0.0, 0.0], "{tolerance} {friction}");
            assert!(sim.stats().steps < 20, "{tolerance} {friction}: {:?}", sim.stats());
        }
    }
}

/// A rimless wheel with eight spokes of 1 m, its mass of 1 kg at the hub, on a slope of 0.08 rad: along it, away from it, angle.
#[derive(Clone, Copy, Debug)]
struct Wheel {
    inertia: f64,
    spin: f64,
}

const SPOKE: f64 = core::f64::consts::FRAC_PI_8;
const SLOPE: f64 = 0.08;

impl Scene<3, 16> for Wheel {
    fn laws(&self) -> [Law<f64>; 16] {
        core::array::from_fn(
            |i| if i % 2 == 0 { Law::Unilateral { restitution: 0.0 } } else { Law::Friction },
        )
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        let (sin, cos) = SLOPE.sin_cos();
        [T::lit(GRAVITY * sin), T::lit(-GRAVITY * cos), T::ZERO]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        inverse_mass(self.inertia)
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], v: [T; 3]) -> [Row<T, 3>; 16] {
        core::array::from_fn(|i| {
            let (sin, cos) = (SPOKE * (i / 2 * 2) as f64).sin_cos();
            point(q, v, [sin, -cos], [0.0, 1.0])[i % 2]
        })
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3], rows: &mut Rows<T, 16>) {
        for normal in (0..16).step_by(2) {
            rows.set_friction(normal + 1, Limit::of(normal, T::lit(100.0)));
        }
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        // Just after an impact: the spoke before it stands, leaning back by half the angle between two.
        let (sin, cos) = SPOKE.sin_cos();
        ([-sin, cos, SPOKE], [self.spin * cos, self.spin * sin, -self.spin])
    }
}

system!(Wheel, 3, 16);

impl Wheel {
    /// The rate just after the last impact, from the energy: 1 kg.
    fn after_impact(&self, modes: [Mode; 16], x: [f64; 6]) -> f64 {
        let stands = modes.iter().position(|mode| *mode == Mode::Closed).unwrap() / 2;
        let lean = SPOKE * (stands * 2) as f64 + x[2];
        // The hub from its foot, now and at the impact.
        let now = [-lean.sin(), lean.cos()];
        let then = [-SPOKE.sin(), SPOKE.cos()];
        let fall = GRAVITY * (SLOPE.sin() * (now[0] - then[0]) - SLOPE.cos() * (now[1] - then[1]));
        let energy = 0.5 * (x[3] * x[3] + x[4] * x[4] + self.inertia * x[5] * x[5]);
        (2.0 * (energy - fall) / (1.0 + self.inertia)).sqrt()
    }
}

/// Case C25, with an inertia: omega+ = k omega-, k = (I + cos 2a)/(I + 1). The deviation from its limit falls by k^2 a step.
#[test]
fn a_rimless_wheel_walks() {
    let massless = (2.0 * SPOKE).cos();
    let limit = massless * (4.0 * GRAVITY * SPOKE.sin() * SLOPE.sin() / (1.0 - massless * massless)).sqrt();
    assert!((limit - 1.095_462_839_647_657).abs() < 1e-12, "{limit}");
    for inertia in [0.1, 0.5] {
        let k = (inertia + (2.0 * SPOKE).cos()) / (inertia + 1.0);
        let gain = 4.0 * GRAVITY * SPOKE.sin() * SLOPE.sin() / (1.0 + inertia);
        let limit = k * (gain / (1.0 - k * k)).sqrt();
        let mut expected = 1.1 * limit;
        let mut sim = Wheel { inertia, spin: expected }.start_with(Dop853::new(1e-12)).unwrap();
        let mut stands = sim.held.of;
        for _ in 0..100 {
            sim.step(0.05).unwrap();
            if sim.held.of != stands {
                stands = sim.held.of;
                expected = k * (expected * expected + gain).sqrt();
            }
            let found = sim.mechanism.after_impact(sim.held.of, sim.x);
            assert!((found - expected).abs() < 1e-9, "{inertia} after {} s: {found} {expected}", sim.time);
        }
        assert!((expected - limit).abs() < 0.01 * limit, "{:?}", sim.stats());
    }
}
