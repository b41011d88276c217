//! Dependent states: first-order states that follow the coordinates, and those that nothing reads.
//!
//! States that follow the coordinates: their rate is a multiple of the rate of coordinates, so that at every pose they
//! have the value to which the way there brings them.
//!
//! Examples are the force of a spring that integrates its speed, and the pressure of a closed chamber. The way to an equilibrium
//! is no motion in time, but it is a way all the same: dx/ds = r(q, x) dq/ds is integrated along it.

use nalgebra::{DMatrix, DVector};

use super::Stabilise;
use super::residuals::{Point, Residuals};
use super::scales::Scales;

/// Steps of Runge and Kutta's method along a straight way.
const STEPS: u32 = 32;
/// Departure from proportionality that rounding explains.
const ROUNDING: f64 = 1e-9;
/// Points at which the rates are evaluated: the start, and some beside it.
const PROBES: usize = 3;
/// How far they are apart, in scaled units: 0.1 m, 0.1 rad, 100 bar.
const REACH: f64 = 100.0;

/// Which states follow the coordinates: their rate vanishes at rest whatever coordinates, states and multipliers are, and is
/// linear in the velocities.
pub(super) fn following<M: Stabilise>(residuals: &Residuals<M>, start: &Point, scales: &Scales) -> Vec<bool> {
    let mut follows = vec![true; residuals.nx()];
    let mut moves = vec![false; residuals.nx()];
    let mut fractions = Fractions(0.0);
    for probe in 0..PROBES {
        let reach = if probe == 0 { 0.0 } else { REACH };
        let point = beside(start, scales, reach, &mut fractions);
        let a = DVector::from_fn(residuals.nq(), |_, _| fractions.next());
        let b = DVector::from_fn(residuals.nq(), |_, _| fractions.next());
        let still = residuals.rows(&point).rate;
        let rate = |v: &dyn Fn(usize) -> f64| residuals.moving(&point, v).rate;
        let (of_a, of_b) = (rate(&|i| a[i]), rate(&|i| b[i]));
        let (of_sum, of_back) = (rate(&|i| a[i] + b[i]), rate(&|i| -a[i]));
        for i in 0..follows.len() {
            let size = of_a[i].abs().max(of_b[i].abs());
            let linear = (of_sum[i] - of_a[i] - of_b[i]).abs() <= ROUNDING * size
                && (of_back[i] + of_a[i]).abs() <= ROUNDING * size;
            follows[i] &= still[i] == 0.0 && linear;
            moves[i] |= size > 0.0;
        }
    }
    follows.iter().zip(moves).map(|(follows, moves)| *follows && moves).collect()
}

/// Which states nothing reads, neither forces nor rates: integrals that somebody wants to see.
pub(super) fn unread<M: Stabilise>(residuals: &Residuals<M>, start: &Point, scales: &Scales) -> Vec<bool> {
    let mut unread = vec![true; residuals.nx()];
    let mut fractions = Fractions(0.0);
    for probe in 0..PROBES {
        let reach = if probe == 0 { 0.0 } else { REACH };
        let by_x = residuals.by_x(&beside(start, scales, reach, &mut fractions));
        for (i, unread) in unread.iter_mut().enumerate() {
            *unread &= by_x.force.column(i).iter().chain(by_x.rate.column(i).iter()).all(|of| *of == 0.0);
        }
    }
    unread
}

/// The rates of all states by the velocities along `directions`, in columns.
pub(super) fn rates_along<M: Stabilise>(
    residuals: &Residuals<M>,
    point: &Point,
    directions: &DMatrix<f64>,
) -> DMatrix<f64> {
    let mut rates = DMatrix::zeros(residuals.nx(), directions.ncols());
    for k in 0..directions.ncols() {
        rates.set_column(k, &residuals.moving(point, |i| directions[(i, k)]).rate);
    }
    rates
}

/// Brings the states that follow the coordinates along a straight way from one point to the coordinates of another, by
/// Runge and Kutta's method of order 4; exact but for rounding where the rate is a constant multiple.
pub(super) fn integrate_dependent<M: Stabilise>(
    residuals: &Residuals<M>,
    follows: &[bool],
    from: &Point,
    to: &mut Point,
) {
    if !follows.contains(&true) {
        return;
    }
    let way = &to.q - &from.q;
    let slope = |s: f64, x: &DVector<f64>| {
        let here = Point { q: &from.q + s * &way, x: x.clone(), lambda: from.lambda.clone() };
        let rate = residuals.moving(&here, |i| way[i]).rate;
        DVector::from_fn(rate.len(), |i, _| if follows[i] { rate[i] } else { 0.0 })
    };
    let h = 1.0 / f64::from(STEPS);
    let mut x = DVector::from_fn(to.x.len(), |i, _| if follows[i] { from.x[i] } else { to.x[i] });
    for step in 0..STEPS {
        let s = h * f64::from(step);
        let k1 = slope(s, &x);
        let k2 = slope(s + 0.5 * h, &(&x + 0.5 * h * &k1));
        let k3 = slope(s + 0.5 * h, &(&x + 0.5 * h * &k2));
        let k4 = slope(s + h, &(&x + h * &k3));
        x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    to.x = x;
}

/// A point whose numbers differ by up to half of `reach` scaled units.
fn beside(point: &Point, scales: &Scales, reach: f64, fractions: &mut Fractions) -> Point {
    let mut moved = |values: &DVector<f64>, size: &dyn Fn(usize) -> f64| {
        DVector::from_fn(values.len(), |i, _| values[i] + reach * size(i) * fractions.next())
    };
    let force = scales.force.get(0).copied().unwrap_or(1.0);
    Point {
        q: moved(&point.q, &|i| scales.q[i]),
        x: moved(&point.x, &|i| scales.x[i]),
        lambda: moved(&point.lambda, &|_| force),
    }
}

/// Numbers between -1/2 and 1/2 that are spread evenly and repeat nothing: fractions of multiples of the golden ratio.
struct Fractions(f64);

impl Fractions {
    fn next(&mut self) -> f64 {
        self.0 = (self.0 + 0.618_033_988_749_894_9).fract();
        self.0 - 0.5
    }
}
