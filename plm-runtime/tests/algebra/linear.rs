//! Elimination against an independent linear algebra, derivatives against difference quotients.

use nalgebra::{Complex as C, DMatrix, DVector};
use plm_runtime::linalg::{Complex, Dense, Derivatives, Lu};
use plm_runtime::linear::{Colours, by_directions};
use plm_runtime::{Constraints, Events, Labels, Linear, Mechanism, Rate, Real};

use crate::mechanisms::{double_pendulum, four_bar};
use crate::oscillator::oscillator;
use crate::random::Random;
use crate::smooth::DoublePendulum;

#[test]
fn elimination_agrees_with_nalgebra() {
    const N: usize = 7;
    let mut random = Random(17);
    for order in 1..=N {
        for _ in 0..30 {
            let rows: [[f64; N]; N] = core::array::from_fn(|_| core::array::from_fn(|_| random.unit()));
            let mut b: [f64; N] = core::array::from_fn(|_| random.unit());
            let oracle = DMatrix::from_fn(order, order, |i, j| rows[i][j]);
            let expected = oracle.clone().lu().solve(&DVector::from_fn(order, |i, _| b[i])).unwrap();
            let rest = b;
            Lu::new(rows, order).unwrap().solve(&mut b);
            let condition = oracle.clone().norm() * oracle.try_inverse().unwrap().norm();
            for i in 0..order {
                assert!((b[i] - expected[i]).abs() < 1e-14 * condition * expected.norm(), "{b:?} {expected}");
            }
            assert_eq!(b[order..], rest[order..], "what stands beyond the order is left alone");
        }
    }
}

#[test]
fn complex_elimination_agrees_with_nalgebra() {
    const N: usize = 5;
    let mut random = Random(23);
    for _ in 0..100 {
        let mut entry = || Complex { re: random.unit(), im: random.unit() };
        let rows: [[Complex<f64>; N]; N] = core::array::from_fn(|_| core::array::from_fn(|_| entry()));
        let mut b: [Complex<f64>; N] = core::array::from_fn(|_| entry());
        let convert = |c: Complex<f64>| C::new(c.re, c.im);
        let oracle = DMatrix::from_fn(N, N, |i, j| convert(rows[i][j]));
        let expected = oracle.lu().solve(&DVector::from_fn(N, |i, _| convert(b[i]))).unwrap();
        Lu::new(rows, N).unwrap().solve(&mut b);
        for i in 0..N {
            assert!((convert(b[i]) - expected[i]).norm() < 1e-12 * expected.norm(), "{b:?}");
        }
    }
}

#[test]
fn singular_matrices_are_refused() {
    assert!(Lu::new([[1.0, 2.0], [2.0, 4.0]], 2).is_none());
    assert!(Lu::new([[0.0_f64; 3]; 3], 3).is_none());
    assert!(Lu::new([[1.0, f64::NAN], [0.0, 1.0]], 2).is_none());
    assert!(Lu::new([[f64::INFINITY, 1.0], [0.0, 1.0]], 2).is_none());
    // Without pivoting the first would fail and the second lose all digits.
    for small in [0.0, 1e-20] {
        let mut b = [1.0, 2.0];
        Lu::new([[small, 1.0], [1.0, 1.0]], 2).unwrap().solve(&mut b);
        assert_eq!(b, [1.0, 1.0]);
    }
}

#[test]
fn elimination_of_the_coordinates_solves_the_whole_system() {
    const N: usize = 7;
    let mut random = Random(29);
    for nq in 0..=3 {
        for _ in 0..30 {
            // The first rows say q' = v.
            let mut jacobian: [[f64; N]; N] =
                core::array::from_fn(|_| core::array::from_fn(|_| random.unit()));
            for (i, row) in jacobian.iter_mut().enumerate().take(nq) {
                *row = core::array::from_fn(|j| f64::from(u8::from(j == nq + i)));
            }
            let lambda = Complex { re: 3.0 + random.unit(), im: 2.0 * random.unit() };
            let r: [Complex<f64>; N] =
                core::array::from_fn(|_| Complex { re: random.unit(), im: random.unit() });
            let convert = |c: Complex<f64>| C::new(c.re, c.im);
            let oracle = DMatrix::from_fn(N, N, |i, j| {
                let diagonal = if i == j { convert(lambda) } else { C::new(0.0, 0.0) };
                diagonal - jacobian[i][j]
            });
            let expected = oracle.lu().solve(&DVector::from_fn(N, |i, _| convert(r[i]))).unwrap();
            let resolvent = jacobian.resolvent(lambda, nq).unwrap();
            let mut k = r;
            jacobian.resolve(&resolvent, nq, |i| r[i], |i, value| k[i] = value);
            for i in 0..N {
                assert!((convert(k[i]) - expected[i]).norm() < 1e-12 * expected.norm(), "{nq}: {k:?}");
            }
        }
    }
}

/// Largest difference of the derivatives to central difference quotients, over the largest derivative.
fn difference<M: Linear<S = f64, X = [f64; N]>, const N: usize>(m: &M, t: f64, u: &M::U, x: &[f64; N]) -> f64
where
    [f64; N]: Dense<f64>,
{
    let (mut by_x, mut by_t) = (<[f64; N] as Dense<f64>>::zeros(), [0.0; N]);
    assert!(m.jacobian(t, u, x, &mut by_x, Some(&mut by_t)).is_good());
    let (mut worst, mut size) = (0.0_f64, 0.0_f64);
    for j in 0..=N {
        let h = 1e-6;
        let rate = |sign: f64| {
            let (mut moved, mut dx) = (*x, [0.0; N]);
            if j < N {
                moved[j] += sign * h;
            }
            let t = if j == N { t + sign * h } else { t };
            m.rate(t, u, &moved, &mut dx);
            dx
        };
        let (after, before) = (rate(1.0), rate(-1.0));
        // The product with the unit vector is the column.
        let mut product = [0.0; N];
        let unit = core::array::from_fn(|i| f64::from(u8::from(i == j)));
        m.jvp(t, u, x, (f64::from(u8::from(j == N)), &unit), &mut product);
        for i in 0..N {
            let quotient = (after[i] - before[i]) / (2.0 * h);
            let exact = if j == N { by_t[i] } else { <[f64; N]>::entry(&by_x, i, j) };
            assert!((product[i] - exact).abs() <= 1e-14 * exact.abs(), "{i} {j}: {} {exact}", product[i]);
            worst = worst.max((quotient - exact).abs());
            size = size.max(exact.abs());
        }
    }
    worst / size
}

#[test]
fn derivatives_agree_with_difference_quotients() {
    let x = [0.3, -0.4, 1.1, 0.7];
    let plain = DoublePendulum { gravity: 9.81, first: 0.0, second: 0.0 };
    assert!(difference(&plain, 0.0, &(), &x) < 1e-9);
    assert!(difference(&oscillator(), 0.8, &0.5, &[0.2, 0.3, 0.4]) < 1e-9);
    // Through the elimination of the multipliers, in motion.
    let mut sim = double_pendulum::<f64>().start().unwrap();
    sim.step(0.3).unwrap();
    assert!(difference(&sim.mechanism, 0.3, &(), &sim.x) < 1e-8);
    let mut sim = four_bar().start().unwrap();
    sim.step(0.3).unwrap();
    assert!(difference(&sim.mechanism, 0.3, &(), &sim.x) < 1e-8);
}

/// Pole of the derivative at zero, where the rate is finite.
#[derive(Clone, Copy, Debug)]
struct Root<S>(S);

impl<S: Real> Rate for Root<S> {
    type S = S;
    type X = [S; 1];
    type U = ();
    const NQ: usize = 0;

    fn rate(&self, _t: S, (): &(), x: &[S; 1], dx: &mut [S; 1]) -> plm_runtime::Health<S> {
        *dx = [x[0].sqrt()];
        plm_runtime::Health::perfect()
    }
}

impl<S: Real> Constraints for Root<S> {}

impl<S: Real> Events for Root<S> {
    type G = [S; 0];
}

impl<S: Real> Labels for Root<S> {}

impl<S: Real> Linear for Root<S> {
    type Lifted<const K: usize> = Root<plm_runtime::Dual<S, K>>;
    type In<T: Real> = Root<T>;
    type Derivatives = [[S; 1]; 1];

    fn lift<const K: usize>(&self, (): &()) -> (Self::Lifted<K>, ()) {
        self.in_numbers(&(), plm_runtime::Dual::constant)
    }

    fn in_numbers<T: Real>(&self, (): &(), number: impl Fn(S) -> T) -> (Root<T>, ()) {
        (Root(number(self.0)), ())
    }
}

#[test]
fn derivatives_that_are_not_finite_are_unhealthy() {
    let mut by_x = [[0.0]];
    assert!(Root(0.0).jacobian(0.0, &(), &[0.25], &mut by_x, None).is_good());
    assert_eq!(by_x, [[1.0]]);
    assert!(!Root(0.0).jacobian(0.0, &(), &[0.0], &mut by_x, None).is_good());
}

#[test]
fn constraints_and_their_derivatives() {
    // Along the motion phi and phi_dot stay zero: their derivative along (1, rate) vanishes.
    let mut sim = four_bar().start().unwrap();
    sim.step(0.3).unwrap();
    let mut rows = Vec::new();
    sim.mechanism.constraints(sim.time, &sim.x, &mut |row: f64| rows.push(row));
    assert_eq!(rows.len(), 16);
    assert!(rows.iter().all(|row| row.abs() < 1e-8), "{rows:?}");

    let (lifted, ()) = sim.mechanism.lift::<1>(&());
    let mut rate = [0.0; 18];
    sim.mechanism.rate(sim.time, &(), &sim.x, &mut rate);
    let x = core::array::from_fn(|i| plm_runtime::Dual { value: sim.x[i], tangents: [rate[i]] });
    let t = plm_runtime::Dual { value: sim.time, tangents: [1.0] };
    let mut slopes = Vec::new();
    lifted.constraints(t, &x, &mut |row| slopes.push(row.tangents[0]));
    assert!(slopes.iter().all(|slope| slope.abs() < 1e-7), "{slopes:?}");
}

/// Two numbers that know nothing of two others, one that reads both, and one that nothing reads.
struct Apart<S>(S);

impl<S: Real> Rate for Apart<S> {
    type S = S;
    type X = [S; 6];
    type U = ();
    const NQ: usize = 1;

    fn rate(&self, t: S, (): &(), x: &[S; 6], dx: &mut [S; 6]) -> plm_runtime::Health<S> {
        let [a, b, c, d, e, _] = *x;
        *dx = [b, self.0 * a.sin_cos().0 - b * b, c * d, d.exp() - t, b * e, c * e];
        plm_runtime::Health::perfect()
    }
}

impl<S: Real> Constraints for Apart<S> {}

impl<S: Real> Events for Apart<S> {
    type G = [S; 0];
}

impl<S: Real> Labels for Apart<S> {}

impl<S: Real> Linear for Apart<S> {
    type Lifted<const K: usize> = Apart<plm_runtime::Dual<S, K>>;
    type In<T: Real> = Apart<T>;
    type Derivatives = [[S; 6]; 6];

    fn lift<const K: usize>(&self, (): &()) -> (Self::Lifted<K>, ()) {
        self.in_numbers(&(), plm_runtime::Dual::constant)
    }

    fn in_numbers<T: Real>(&self, (): &(), number: impl Fn(S) -> T) -> (Apart<T>, ()) {
        (Apart(number(self.0)), ())
    }
}

#[test]
fn columns_that_share_no_row_share_a_direction() {
    const NONE: usize = 6;
    let colours = Colours::<6, 3> {
        of_columns: [0, 1, 0, 1, 2, 3],
        columns: [[NONE, 0, 2, NONE, NONE, 2], [NONE, 1, 3, 3, 1, NONE], [NONE, NONE, NONE, NONE, 4, 4]],
        knows_time: true,
    };
    let (system, x) = (Apart(1.3), [0.3, -0.7, 1.1, 0.4, -2.0, 5.0]);
    let (mut alone, mut alone_by_t) = ([[0.0; 6]; 6], [0.0; 6]);
    assert!(system.jacobian(0.2, &(), &x, &mut alone, Some(&mut alone_by_t)).is_good());
    assert_eq!((alone[1][1], alone[3][3]), (1.4, 0.4_f64.exp()));
    assert_eq!(alone_by_t, [0.0, 0.0, 0.0, -1.0, 0.0, 0.0]);
    // In passes of one, two and four directions.
    let at = (0.2, &(), &x);
    for passes in 0..3 {
        let (mut by_x, mut by_t) = ([[7.0; 6]; 6], [7.0; 6]);
        let out = (&mut by_x, Some(&mut by_t));
        let health = match passes {
            0 => by_directions::<_, 1, 6, 3>(&system, at, &colours, out.0, out.1),
            1 => by_directions::<_, 2, 6, 3>(&system, at, &colours, out.0, out.1),
            _ => by_directions::<_, 4, 6, 3>(&system, at, &colours, out.0, out.1),
        };
        assert!(health.is_good());
        assert_eq!((by_x, by_t), (alone, alone_by_t), "{passes}");
    }
    // What is known not to move by the time is not differentiated.
    let (mut by_x, mut by_t) = ([[7.0; 6]; 6], [7.0; 6]);
    let colours = Colours { knows_time: false, ..colours };
    assert!(by_directions::<_, 4, 6, 3>(&system, at, &colours, &mut by_x, Some(&mut by_t)).is_good());
    assert_eq!((by_x, by_t), (alone, [0.0; 6]));
}
