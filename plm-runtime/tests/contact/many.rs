//! Bodies with so many contacts that their combinations of modes are not enumerated.

use plm_runtime::contact::{self, Law, Limit, Mode, Rows};
use plm_runtime::{Dop853, Mechanism, Scalar};

use crate::bodies::{GRAVITY, inverse_mass, point};
use crate::support::{Row, Scene, system};

/// A body of 1 kg on six feet in a line, with friction: along an incline, away from it, angle.
#[derive(Clone, Copy, Debug)]
struct Feet {
    incline: f64,
    friction: f64,
    /// Its centre over the line of the feet, m.
    height: f64,
    restitution: f64,
    start: ([f64; 3], [f64; 3]),
}

const FEET: [f64; 6] = [-0.5, -0.3, -0.1, 0.1, 0.3, 0.5];

impl Scene<3, 12> for Feet {
    fn laws(&self) -> [Law<f64>; 12] {
        core::array::from_fn(|i| {
            if i % 2 == 0 { Law::Unilateral { restitution: self.restitution } } else { Law::Friction }
        })
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        let (sin, cos) = self.incline.sin_cos();
        [T::lit(GRAVITY * sin), T::lit(-GRAVITY * cos), T::ZERO]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        inverse_mass(0.1)
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], v: [T; 3]) -> [Row<T, 3>; 12] {
        core::array::from_fn(|i| point(q, v, [FEET[i / 2], -self.height], [0.0, 1.0])[i % 2])
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3], rows: &mut Rows<T, 12>) {
        for normal in (0..12).step_by(2) {
            rows.set_friction(normal + 1, Limit::of(normal, T::lit(self.friction)));
        }
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        self.start
    }
}

system!(Feet, 3, 12);

fn feet(incline: f64, friction: f64, height: f64) -> Feet {
    Feet { incline, friction, height, restitution: 0.0, start: ([0.0, height, 0.0], [0.0; 3]) }
}

/// On an incline: it rests where tan a <= mu, and slides with g (sin a - mu cos a) beyond.
#[test]
fn a_body_on_six_feet_rests_or_slides() {
    for (incline, friction) in
        [(0.0, 0.3_f64), (0.1, 0.3), (0.299_f64.atan(), 0.3), (0.301_f64.atan(), 0.3), (0.5, 0.2)]
    {
        let mut sim = feet(incline, friction, 0.1).start_with(Dop853::new(1e-10)).unwrap();
        if incline.tan() <= friction {
            let place = sim.x;
            sim.step(3600.0).unwrap();
            assert_eq!(sim.x, place, "{incline}");
            assert!(sim.held.are_undetermined() && sim.stats().steps < 20, "{:?}", sim.stats());
            // Their sum is unique: the weight, and the force down the incline.
            let lambda = contact::reactions(&sim.mechanism, 0.0, &sim.held, &sim.x);
            let sum = |from: usize| lambda.iter().skip(from).step_by(2).sum::<f64>();
            assert!((sum(0) - GRAVITY * incline.cos()).abs() < 1e-12, "{lambda:?}");
            assert!((sum(1).abs() - GRAVITY * incline.sin()).abs() < 1e-12, "{lambda:?}");
        } else {
            sim.step(1.0).unwrap();
            let acceleration = GRAVITY * (incline.sin() - friction * incline.cos());
            assert!((sim.x[0] - 0.5 * acceleration).abs() < 1e-9, "{incline} {:?}", sim.x);
            assert!(sim.x[2].abs() < 1e-12 && (sim.x[1] - 0.1).abs() < 1e-12, "{:?}", sim.x);
        }
    }
}

/// It tips over its first foot where its weight points beyond that, tan a > 0.5/h, and stands before.
#[test]
fn a_body_on_six_feet_tips() {
    for (tangent, tips) in [(0.49, false), (0.51, true)] {
        let mut sim = feet(f64::atan(tangent), 2.0, 1.0).start_with(Dop853::new(1e-10)).unwrap();
        assert_eq!(sim.held.of[10], Mode::Closed);
        assert_eq!((0..5).all(|foot| sim.held.is_open(2 * foot)), tips, "{:?}", sim.held);
        sim.step(0.1).unwrap();
        assert_eq!(sim.x[2] < -1e-4, tips, "{:?}", sim.x);
    }
}

/// Dropped at an angle it rocks until all feet stand, and has slid by its friction on the way.
#[test]
fn a_body_that_falls_on_six_feet_comes_to_rest() {
    for friction in [0.0, 0.2, 0.8] {
        let mut scene = feet(0.0, friction, 0.2);
        scene.start = ([0.0, 0.5, 0.1], [1.0, 0.0, 0.0]);
        let mut sim = scene.start_with(Dop853::new(1e-9)).unwrap();
        sim.step(4.0).unwrap();
        assert!(sim.x[2].abs() < 1e-9 && (sim.x[1] - 0.2).abs() < 1e-9, "{friction} {:?}", sim.x);
        assert!((0..6).all(|foot| !sim.held.is_open(2 * foot)), "{:?}", sim.held);
        assert_eq!(sim.x[3].abs() < 1e-15, friction > 0.0, "{:?}", sim.x);
    }
}

/// It bounces on its feet, one after the other and several at once, until it rests: nothing sinks in, energy is not gained.
#[test]
fn a_body_bounces_on_six_feet() {
    // These lead to gaps and rates of the size of rounding on several feet at once.
    for (incline, friction, angle, [vx, vy, spin]) in [
        (0.058_113, 0.256_829, -0.149_593, [-0.865_222, 0.597_787, 2.318_997]),
        (-0.101_144, 0.178_620, 0.244_368, [0.828_393, -0.120_367, -0.231_963]),
        (0.150_729, 0.436_869, -0.176_263, [-0.089_305, -0.051_222, -2.636_492]),
    ] {
        for restitution in [0.0, 0.3, 0.5] {
            let mut scene = Feet { restitution, ..feet(incline, friction, 0.2) };
            scene.start = ([0.0, 0.6, angle], [vx, vy, spin]);
            let mut sim = scene.start_with(Dop853::new(1e-9)).unwrap();
            let energy = |x: &[f64; 6]| {
                let height = x[1] * incline.cos() - x[0] * incline.sin();
                0.5 * (x[3] * x[3] + x[4] * x[4] + 0.1 * x[5] * x[5]) + GRAVITY * height
            };
            let mut last = energy(&sim.x);
            for _ in 0..30 {
                sim.step(0.1).unwrap();
                let (sin, cos) = sim.x[2].sin_cos();
                assert!(FEET.iter().all(|foot| sim.x[1] + foot * sin - 0.2 * cos > -1e-9), "{:?}", sim.x);
                let now = energy(&sim.x);
                assert!(now < last + 1e-7, "{restitution} {} {}", now - last, sim.time);
                last = now;
            }
            assert!(sim.x[2].abs() < 1e-9 && sim.x[5].abs() < 1e-9, "{restitution} {:?}", sim.x);
        }
    }
}

/// Three blocks of 0.2 m by 0.2 m on each other and on an incline, with two corners each, for small angles: x, y, angle of each.
#[derive(Clone, Copy, Debug)]
struct Stack {
    masses: [f64; 3],
    friction: [f64; 3],
    incline: f64,
}

const HALF: f64 = 0.1;

impl Scene<9, 12> for Stack {
    fn laws(&self) -> [Law<f64>; 12] {
        core::array::from_fn(
            |i| if i % 2 == 0 { Law::Unilateral { restitution: 0.0 } } else { Law::Friction },
        )
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 9], _v: [T; 9]) -> [T; 9] {
        let (sin, cos) = self.incline.sin_cos();
        core::array::from_fn(|k| T::lit([GRAVITY * sin, -GRAVITY * cos, 0.0][k % 3]))
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 9]) -> [[T; 9]; 9] {
        core::array::from_fn(|i| {
            let mass = self.masses[i / 3] * [1.0, 1.0, 2.0 * HALF * HALF / 3.0][i % 3];
            core::array::from_fn(|j| if i == j { T::lit(1.0 / mass) } else { T::ZERO })
        })
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 9], _v: [T; 9]) -> [Row<T, 9>; 12] {
        core::array::from_fn(|i| {
            let (block, corner) = (i / 4, [-HALF, HALF][i / 2 % 2]);
            let mut direction = [0.0; 9];
            let upper = 3 * block;
            // The corner of this block, less the place under it on the one below.
            if i % 2 == 0 {
                (direction[upper + 1], direction[upper + 2]) = (1.0, corner);
            } else {
                (direction[upper], direction[upper + 2]) = (1.0, HALF);
            }
            if block > 0 && i % 2 == 0 {
                (direction[upper - 2], direction[upper - 1]) = (-1.0, -corner);
            } else if block > 0 {
                (direction[upper - 3], direction[upper - 1]) = (-1.0, HALF);
            }
            let rest = if i % 2 == 1 {
                0.0
            } else if block == 0 {
                HALF
            } else {
                2.0 * HALF
            };
            let direction = direction.map(T::lit);
            Row::fixed(crate::support::dot(&direction, &q) - T::lit(rest), direction)
        })
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 9], _v: [T; 9], rows: &mut Rows<T, 12>) {
        for normal in (0..12).step_by(2) {
            rows.set_friction(normal + 1, Limit::of(normal, T::lit(self.friction[normal / 4])));
        }
    }
    fn start(&self) -> ([f64; 9], [f64; 9]) {
        let height = |block: usize| HALF * (1.0 + 2.0 * block as f64);
        (core::array::from_fn(|k| if k % 3 == 1 { height(k / 3) } else { 0.0 }), [0.0; 9])
    }
}

system!(Stack, 9, 12);

/// Statics of what stands above each interface: weight, force down the incline, and the moment about its middle.
#[test]
fn a_stack_of_blocks_stands_on_an_incline() {
    let stack = Stack { masses: [3.0, 2.0, 0.5], friction: [0.4, 0.5, 0.6], incline: 0.2 };
    let mut sim = stack.start_with(Dop853::new(1e-10)).unwrap();
    let place = sim.x;
    sim.step(3600.0).unwrap();
    assert_eq!(sim.x, place);
    assert!(sim.stats().steps < 20, "{:?}", sim.stats());
    let lambda = contact::reactions(&stack, 0.0, &sim.held, &sim.x);
    let (sin, cos) = stack.incline.sin_cos();
    for interface in 0..3 {
        let above = interface..3;
        let weight = GRAVITY * above.clone().map(|block| stack.masses[block]).sum::<f64>();
        let arm = |block: usize| HALF * (1.0 + 2.0 * (block - interface) as f64);
        let moment = GRAVITY * sin * above.map(|block| stack.masses[block] * arm(block)).sum::<f64>();
        let [left, rubs_left, right, rubs_right] = core::array::from_fn(|k| lambda[4 * interface + k]);
        assert!((left + right - weight * cos).abs() < 1e-11, "{interface} {lambda:?}");
        assert!(((right - left) * HALF - moment).abs() < 1e-12, "{interface} {lambda:?}");
        assert!((rubs_left + rubs_right + weight * sin).abs() < 1e-11, "{interface} {lambda:?}");
        assert!(left > 0.0 && right > 0.0);
    }
}

/// What is steeper than one interface alone holds slides there, with what stands above it; below it all rests.
#[test]
fn a_stack_of_blocks_slides_where_it_holds_least() {
    for weakest in 0..3 {
        let mut friction = [0.5; 3];
        friction[weakest] = 0.1;
        let stack = Stack { masses: [3.0, 2.0, 0.5], friction, incline: 0.2 };
        let mut sim = stack.start_with(Dop853::new(1e-10)).unwrap();
        sim.step(0.5).unwrap();
        let acceleration = GRAVITY * (0.2_f64.sin() - 0.1 * 0.2_f64.cos());
        for block in 0..3 {
            let way = if block < weakest { 0.0 } else { 0.125 * acceleration };
            assert!((sim.x[3 * block] - way).abs() < 1e-10, "{weakest} {block}: {:?}", sim.x);
            assert!(sim.x[3 * block + 2].abs() < 1e-12, "{weakest} {block}: {:?}", sim.x);
        }
    }
}
