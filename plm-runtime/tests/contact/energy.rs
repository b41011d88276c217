//! Impacts of random systems: no law may gain energy, no row that touches may approach, frictions stay in their limits.

use plm_runtime::contact::{self, ImpactLaw, Law, Limit, Modes, Rows};
use plm_runtime::{Cause, Scalar};

use crate::support::{Row, Scene, dot, system};

/// Two contacts with friction between bodies with three coordinates.
#[derive(Clone, Copy, Debug)]
struct Random {
    inverse: [[f64; 3]; 3],
    directions: [[f64; 3]; 4],
    friction: f64,
    restitution: f64,
    law: ImpactLaw,
    speed: [f64; 3],
}

impl Scene<3, 4> for Random {
    fn laws(&self) -> [Law<f64>; 4] {
        let normal = Law::Unilateral { restitution: self.restitution };
        [normal, Law::Friction, normal, Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        [T::ZERO; 3]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        self.inverse.map(|row| row.map(T::lit))
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], _v: [T; 3]) -> [Row<T, 3>; 4] {
        core::array::from_fn(|i| {
            let direction = self.directions[i].map(T::lit);
            Row::fixed(dot(&direction, &q), direction)
        })
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3], rows: &mut Rows<T, 4>) {
        rows.set_friction(1, Limit::of(0, T::lit(self.friction)));
        rows.set_friction(3, Limit::of(2, T::lit(self.friction)));
    }
    fn impacts(&self) -> ImpactLaw {
        self.law
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        ([0.0; 3], self.speed)
    }
}

system!(Random, 3, 4);

/// Numbers in -1..1 without a pattern: splitmix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A positive definite matrix and its inverse, by factors.
fn masses(numbers: &mut Numbers) -> ([[f64; 3]; 3], [[f64; 3]; 3]) {
    let factor: [[f64; 3]; 3] = core::array::from_fn(|i| {
        core::array::from_fn(|j| numbers.next() * 0.5 + if i == j { 1.0 } else { 0.0 })
    });
    let mass: [[f64; 3]; 3] = core::array::from_fn(|i| core::array::from_fn(|j| dot(&factor[i], &factor[j])));
    let cofactor = |i: usize, j: usize| {
        let [a, b] = [1, 2].map(|k| (i + k) % 3);
        let [c, d] = [1, 2].map(|k| (j + k) % 3);
        mass[a][c] * mass[b][d] - mass[a][d] * mass[b][c]
    };
    let determinant = (0..3).fold(0.0, |sum, j| sum + mass[0][j] * cofactor(0, j));
    (mass, core::array::from_fn(|i| core::array::from_fn(|j| cofactor(j, i) / determinant)))
}

fn energy(mass: &[[f64; 3]; 3], v: &[f64; 3]) -> f64 {
    0.5 * (0..3).fold(0.0, |sum, i| sum + v[i] * dot(&mass[i], v))
}

/// Poisson's law never gains energy; Newton's does in some cases, which is why it is not the default.
#[test]
fn impacts_of_random_systems() {
    let mut numbers = Numbers(33);
    let (mut unsolved, mut gains) = ([0; 2], 0);
    for case in 0..3000 {
        let (mass, inverse) = masses(&mut numbers);
        let directions = core::array::from_fn(|_| core::array::from_fn(|_| numbers.next()));
        let (friction, restitution) = (0.5 * (1.0 + numbers.next()), 0.5 * (1.0 + numbers.next()));
        let speed = core::array::from_fn(|_| numbers.next());
        for law in [ImpactLaw::Poisson, ImpactLaw::Newton] {
            let scene = Random { inverse, directions, friction, restitution, law, speed };
            let (mut u, mut x) = (Modes::open(), [0.0, 0.0, 0.0, speed[0], speed[1], speed[2]]);
            match contact::begin::<_, 4>(&scene, 0.0, &mut u, &mut x) {
                Ok(_) => {}
                Err(fault) => {
                    assert!(
                        matches!(fault.cause, Cause::Impact { .. } | Cause::NoMode { .. }),
                        "{case}: {fault}"
                    );
                    unsolved[usize::from(law == ImpactLaw::Newton)] += 1;
                    continue;
                }
            }
            let after = [x[3], x[4], x[5]];
            let gain = energy(&mass, &after) / energy(&mass, &speed) - 1.0;
            match law {
                ImpactLaw::Newton => gains += u32::from(gain > 1e-9),
                _ => assert!(gain < 1e-12, "{case}: {gain}"),
            }
            for normal in [0, 2] {
                assert!(dot(&directions[normal], &after) > -1e-12, "{case}: {after:?}");
            }
        }
    }
    println!(
        "unsolved by Poisson's law and by Newton's: {unsolved:?} of 3000; Newton's law gained energy in {gains}"
    );
    assert!(gains > 0, "Newton's law gained energy in none");
    assert_eq!(unsolved[0], 0);
}
