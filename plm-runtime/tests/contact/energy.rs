//! Impacts of random systems: no law may gain energy, no row that touches may approach, frictions stay in their limits.

use plm_runtime::contact::{self, Held, ImpactLaw, Law, Limit, Rows};
use plm_runtime::{Cause, Scalar};

use crate::support::{Row, Scene, dot, system};

/// Two contacts with friction between bodies with three coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Random {
    pub(crate) inverse: [[f64; 3]; 3],
    pub(crate) directions: [[f64; 3]; 4],
    pub(crate) friction: f64,
    pub(crate) restitution: f64,
    pub(crate) law: ImpactLaw,
    /// How fast the contacts are moved.
    pub(crate) drive: [f64; 4],
    pub(crate) speed: [f64; 3],
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
            Row { drive: T::lit(self.drive[i]), ..Row::fixed(dot(&direction, &q), direction) }
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

system!(Random, 3, 4, Held<f64, 4>);

/// Numbers in -1..1 without a pattern: splitmix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014).
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    pub(crate) fn next(&mut self) -> f64 {
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

pub(crate) fn energy(mass: &[[f64; 3]; 3], v: &[f64; 3]) -> f64 {
    0.5 * (0..3).fold(0.0, |sum, i| sum + v[i] * dot(&mass[i], v))
}

/// A random system, with its mass matrix.
pub(crate) fn random(numbers: &mut Numbers, law: ImpactLaw) -> (Random, [[f64; 3]; 3]) {
    let (mass, inverse) = masses(numbers);
    let directions = core::array::from_fn(|_| core::array::from_fn(|_| numbers.next()));
    let (friction, restitution) = (0.5 * (1.0 + numbers.next()), 0.5 * (1.0 + numbers.next()));
    let speed = core::array::from_fn(|_| numbers.next());
    (Random { inverse, directions, friction, restitution, law, drive: [0.0; 4], speed }, mass)
}

/// The start of a run: discrete state, and velocities after the impacts, whether there is a fault or none.
pub(crate) fn begin(scene: &Random) -> (Held<f64, 4>, [f64; 3], Result<(), Cause>) {
    let speed = scene.speed;
    let (mut u, mut x) = (Held::open(), [0.0, 0.0, 0.0, speed[0], speed[1], speed[2]]);
    let found = contact::begin::<_, 4>(scene, 0.0, &mut u, &mut x);
    (u, [x[3], x[4], x[5]], found.map(|_| ()).map_err(|fault| fault.cause))
}

/// Poisson's law never gains energy; Newton's would in some cases, and says how much.
#[test]
fn impacts_of_random_systems() {
    let mut numbers = Numbers(33);
    let (mut unsolved, mut gains) = ([0; 2], 0);
    for case in 0..3000 {
        let (scene, mass) = random(&mut numbers, ImpactLaw::Poisson);
        for law in [ImpactLaw::Poisson, ImpactLaw::Newton] {
            let scene = Random { law, ..scene };
            let (_, after, found) = begin(&scene);
            let gain = energy(&mass, &after) - energy(&mass, &scene.speed);
            match found {
                Ok(()) => {}
                Err(Cause::ImpactGains { by, of }) => {
                    assert!(law == ImpactLaw::Newton && by > 0.0 && by < of, "{case}: {by} {of}");
                    assert!((by - gain).abs() < 1e-12 * of, "{case}: {by} {gain}");
                    gains += 1;
                    continue;
                }
                Err(cause) => {
                    let is_unsolved = matches!(cause, Cause::Impact { .. } | Cause::NoMode { .. });
                    assert!(is_unsolved, "{case}: {cause}");
                    unsolved[usize::from(law == ImpactLaw::Newton)] += 1;
                    continue;
                }
            }
            assert!(gain < 1e-12 * energy(&mass, &scene.speed), "{case} {law:?}: {gain}");
            for normal in [0, 2] {
                assert!(dot(&scene.directions[normal], &after) > -1e-12, "{case}: {after:?}");
            }
        }
    }
    println!(
        "unsolved by Poisson's law and by Newton's: {unsolved:?} of 3000; Newton's law gains energy in {gains}"
    );
    assert!(gains > 0, "Newton's law gains energy in none");
    assert_eq!(unsolved[0], 0);
}

/// The kinetic energy changes by the work of moved contacts less what is lost, and momentum by what the impulses give; nothing is gained.
#[test]
fn energy_and_impulses_of_impacts_are_booked() {
    let mut numbers = Numbers(7);
    let mut solved = 0;
    for case in 0..2000 {
        let (mut scene, mass) = random(&mut numbers, ImpactLaw::Poisson);
        scene.drive = core::array::from_fn(|_| if case % 2 == 0 { 0.0 } else { numbers.next() });
        let (u, after, found) = begin(&scene);
        if found.is_err() {
            continue;
        }
        let (before, status) = (scene.speed, u.status());
        let booked = status.energy();
        let change = energy(&mass, &after) - energy(&mass, &before);
        let size = energy(&mass, &after) + energy(&mass, &before) + booked.work.abs();
        assert!((change - booked.work + booked.lost).abs() < 1e-12 * size, "{case}: {change} {booked:?}");
        assert!(booked.lost > -1e-12 * size && booked.last == booked.lost, "{case}: {booked:?}");
        assert!(scene.drive != [0.0; 4] || booked.work == 0.0, "{case}: {booked:?}");
        let impulses: [f64; 4] = core::array::from_fn(|row| {
            status.impulse(row).map_or(0.0, |impulse| {
                assert_eq!(impulse.time, 0.0);
                impulse.size
            })
        });
        let turned = core::array::from_fn(|k| after[k] - before[k]);
        for k in 0..3 {
            let given = (0..4).fold(0.0, |sum, row| sum + impulses[row] * scene.directions[row][k]);
            assert!((dot(&mass[k], &turned) - given).abs() < 1e-11, "{case}: {impulses:?}");
        }
        for normal in [0, 2] {
            let most = scene.friction * impulses[normal] + 1e-12;
            assert!(impulses[normal] >= 0.0 && impulses[normal + 1].abs() <= most, "{case}: {impulses:?}");
        }
        solved += usize::from(status.counts().impacts > 0);
    }
    assert!(solved > 1000, "{solved}");
}
