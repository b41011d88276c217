//! The state over the last step, as polynomials.

use core::ops::Range;

use crate::enclosure::{Enclosed, Interval};
use crate::scalar::Real;
use crate::system::{value, values};
use crate::vector::Vector;

/// Number of powers of a dense output, whose highest degree is 8.
pub(super) const POWERS: usize = 9;

/// Dense output up to this degree has an enclosure of its own, in a third of the operations.
const LOW: usize = 4;

/// State over a step, as polynomials of the fraction of it that has passed.
#[derive(Clone, Copy, Debug)]
pub struct Path<S, X> {
    /// Time at the beginning, s.
    pub start: S,
    /// Length of the step, s.
    pub h: S,
    /// Coefficients of the powers of the fraction from 0 up; no method has a higher degree.
    pub coefficients: [X; POWERS],
}

impl<S: Real, X: Vector<S>> Path<S, X> {
    /// This path in another type of numbers, without derivatives.
    pub(crate) fn in_values<T: Real<Plain = S::Plain>, Y: Vector<T>>(&self) -> Path<T, Y> {
        let coefficients = core::array::from_fn(|k| values(&self.coefficients[k]));
        Path { start: value(self.start), h: value(self.h), coefficients }
    }

    /// Path from functions that give the coefficients of each component.
    #[inline]
    pub(crate) fn new(start: S, h: S, mut component: impl FnMut(usize) -> [S; POWERS]) -> Self {
        let mut coefficients = [X::fill(S::ZERO); POWERS];
        for i in 0..X::LEN {
            for (power, coefficient) in coefficients.iter_mut().zip(component(i)) {
                power.set(i, coefficient);
            }
        }
        Self { start, h, coefficients }
    }

    /// Path from the ends of a step, if a method has no dense output: coordinates by the cubic of C. Hermite with the velocities at both
    /// ends, velocities as its derivative, first-order states by a line. It takes no evaluation.
    pub(crate) fn between(from: (S, &X), to: (S, &X), coordinates: usize) -> Self {
        let ((start, from), (end, to)) = (from, to);
        let h = end - start;
        let (zero, two, three) = (S::ZERO, S::lit(2.0), S::lit(3.0));
        // c + b theta + (3 d - 2 b - e) theta^2 + (b + e - 2 d) theta^3, d the change, b and e the slopes at both ends.
        let cubic = |i: usize| {
            let (b, e) = (h * from.at(coordinates + i), h * to.at(coordinates + i));
            let change = to.at(i) - from.at(i);
            [from.at(i), b, three * change - two * b - e, b + e - two * change]
        };
        Self::new(start, h, |i| {
            let [a, b, c, d] = if i < coordinates {
                cubic(i)
            } else if i < 2 * coordinates {
                let [_, b, c, d] = cubic(i - coordinates);
                [b / h, two * c / h, three * d / h, zero]
            } else {
                [from.at(i), to.at(i) - from.at(i), zero, zero]
            };
            [a, b, c, d, zero, zero, zero, zero, zero]
        })
    }

    /// True if all of the path of [`between`](Self::between) is `within` bounds: the first `coordinates`, whose velocities begin at the
    /// index `velocity`, and the numbers in the ranges `all`. The hull of its control points encloses it (S. Bernstein's form of a
    /// polynomial; G. Farin, Curves and Surfaces for CAGD, 5th edition, 4.3); its beginning is known to be within them.
    #[inline]
    pub(crate) fn between_stays(
        from: (S, &X),
        to: (S, &X),
        (velocity, coordinates, all): (usize, usize, [Range<usize>; 3]),
        within: impl Fn(usize, S) -> bool,
    ) -> bool {
        let ((start, from), (end, to)) = (from, to);
        let (h, three) = (end - start, S::lit(3.0));
        let third = h * S::lit(1.0 / 3.0);
        let moves = |i: usize| {
            let (q, v) = ((from.at(i), to.at(i)), (from.at(velocity + i), to.at(velocity + i)));
            let between = three * (q.1 - q.0) / h - (v.0 + v.1);
            within(i, q.0 + third * v.0) && within(i, q.1 - third * v.1) && within(velocity + i, between)
        };
        // Range by range: an iterator over all of them would not become a loop.
        (0..coordinates).all(moves) && all.into_iter().all(|mut range| range.all(|i| within(i, to.at(i))))
    }

    /// Time at a fraction of the step, s.
    pub(crate) fn time(&self, theta: S) -> S {
        self.start + theta * self.h
    }

    /// State at a fraction of the step.
    pub(crate) fn at(&self, theta: S) -> X {
        X::from_fn(|i| {
            let powers = self.coefficients.iter().rev();
            powers.fold(S::ZERO, |sum, power| sum.mul_add(theta, power.at(i)))
        })
    }

    /// Derivative of the state, per step.
    pub(crate) fn slope(&self, theta: S) -> X {
        X::from_fn(|i| {
            let powers = self.coefficients.iter().enumerate().skip(1).rev();
            powers.fold(S::ZERO, |sum, (k, power)| sum.mul_add(theta, S::lit(k as f64) * power.at(i)))
        })
    }

    /// Time and state from `radius` before to `radius` after a fraction of the step; slopes are per step.
    pub(crate) fn around(&self, middle: S, radius: S) -> (Enclosed<S>, impl Fn(usize) -> Enclosed<S>) {
        let (from, to) = (self.time(middle - radius), self.time(middle + radius));
        let time = Enclosed {
            middle: self.time(middle),
            value: Interval::between(from, to),
            slope: Interval::point(self.h),
        };
        (time, move |i| {
            // By reference: the map of an array copies it, for every component.
            let c = self.coefficients.each_ref().map(|power| power.at(i));
            if c.iter().skip(LOW + 1).all(|c| *c == S::ZERO) {
                enclose::<S, LOW>(c, (middle, radius))
            } else {
                enclose::<S, { POWERS - 1 }>(c, (middle, radius))
            }
        })
    }
}

/// Coefficients of a polynomial of this degree about another fraction of the step, by repeated synthetic division (D. E. Knuth, The Art of
/// Computer Programming 2, 4.6.4, "shifting").
#[inline]
fn shifted<S: Real, const DEGREE: usize>(mut c: [S; POWERS], middle: S) -> [S; POWERS] {
    for first in 0..DEGREE {
        for k in (first..DEGREE).rev() {
            c[k] = c[k + 1].mul_add(middle, c[k]);
        }
    }
    c
}

/// Ranges of a polynomial of this degree and of its derivative up to `radius` from `middle`, term by term.
#[inline]
fn enclose<S: Real, const DEGREE: usize>(c: [S; POWERS], (middle, radius): (S, S)) -> Enclosed<S> {
    let c = shifted::<S, DEGREE>(c, middle);
    let (mut value, mut slope) = (Terms::NONE, Terms::NONE);
    let mut power = radius;
    for k in 1..=DEGREE {
        value.reach(c[k] * power, k % 2 == 0);
        if k < DEGREE {
            slope.reach(S::lit((k + 1) as f64) * c[k + 1] * power, k % 2 == 0);
        }
        power = power * radius;
    }
    Enclosed { middle: c[0], value: value.around(c[0]), slope: slope.around(c[1]) }
}

/// Distances that the terms of a polynomial reach down and up, both as sums of sizes.
struct Terms<S> {
    down: S,
    up: S,
}

impl<S: Real> Terms<S> {
    const NONE: Self = Self { down: S::ZERO, up: S::ZERO };

    /// Adds a term that reaches from zero to `size`, an even power, or to both sides; NaN stays NaN.
    #[inline]
    fn reach(&mut self, size: S, is_even: bool) {
        let (half, both) = (S::lit(0.5), size.abs());
        let (down, up) = if is_even { (half * (both - size), half * (both + size)) } else { (both, both) };
        (self.down, self.up) = (self.down + down, self.up + up);
    }

    /// Range about the constant term; zero is not rounded outwards. A term is a product of at most nine factors, and sums of eight sizes
    /// lose no digits: both together have an error of eight epsilons (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd
    /// edition, lemma 3.1).
    #[inline]
    fn around(self, middle: S) -> Interval<S> {
        let slack = S::lit(1.0) + S::lit(POWERS as f64) * S::EPSILON;
        let [down, up] = [self.down, self.up].map(|sum| slack * sum);
        if down == S::ZERO && up == S::ZERO {
            return Interval::point(middle);
        }
        Interval::point(middle) + Interval::between(-down, up)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACES: [f64; 5] = [0.0, 0.25, 0.4, 0.9, 1.0];

    /// 1 + 2 t - 3 t^2 + 0.5 t^3 and its derivative.
    fn cubic(t: f64) -> [f64; 2] {
        [1.0 + t * (2.0 + t * (-3.0 + t * 0.5)), 2.0 + t * (-6.0 + t * 1.5)]
    }

    #[test]
    fn a_cubic_motion_is_met_between_its_ends() {
        let state = |t: f64, level: f64| [cubic(t)[0], cubic(t)[1], level];
        let path = Path::between((2.0, &state(2.0, 5.0)), (2.5, &state(2.5, 7.0)), 1);
        for theta in PLACES {
            let t = path.time(theta);
            let (found, known) = (path.at(theta), state(2.0 + 0.5 * theta, 5.0 + 2.0 * theta));
            let bend = -6.0 + 3.0 * t;
            for i in 0..3 {
                let slope = 0.5 * [known[1], bend, 4.0][i];
                assert!((found[i] - known[i]).abs() < 1e-14, "{i} at {theta}: {found:?} {known:?}");
                assert!(
                    (path.slope(theta)[i] - slope).abs() < 1e-13,
                    "{i} at {theta}: {:?}",
                    path.slope(theta)
                );
            }
        }
    }

    #[test]
    fn a_motion_stays_within_the_hull_of_its_control_points() {
        for k in 0..40 {
            let number = |i: u32| f64::sin(f64::from(7 * k + i) * 1.7) * 3.0;
            let (from, to) = ([0, 1, 2].map(number), [3, 4, 5].map(number));
            let ends = ((1.0, &from), (1.0 + 0.01 * f64::from(k + 1), &to));
            let hull = core::cell::RefCell::new(from.map(|s| (s, s)));
            let grow = |i: usize, s: f64| {
                let (low, high) = hull.borrow()[i];
                hull.borrow_mut()[i] = (low.min(s), high.max(s));
                true
            };
            assert!(Path::between_stays(ends.0, ends.1, (1, 1, [0..3, 0..0, 0..0]), grow));
            let path = Path::between(ends.0, ends.1, 1);
            for part in 0..=100 {
                let x: [f64; 3] = path.at(0.01 * f64::from(part));
                for (i, (low, high)) in hull.borrow().iter().enumerate() {
                    let rounding = 1e-13 * (low.abs() + high.abs());
                    assert!(low - rounding <= x[i] && x[i] <= high + rounding, "{k}, {i} at {part}: {x:?}");
                }
            }
            // A bound within the hull is noticed for each component.
            for bound in 0..3 {
                let high = hull.borrow()[bound].1;
                let inside = |i: usize, s: f64| i != bound || s < high;
                assert!(
                    from[bound] == high
                        || !Path::between_stays(ends.0, ends.1, (1, 1, [0..3, 0..0, 0..0]), inside),
                    "{k}, {bound}"
                );
            }
        }
    }

    #[test]
    fn what_is_around_a_place_is_enclosed() {
        let path = Path::new(3.0, 0.2, |_: usize| [1.0, -2.0, 0.7, 1.5, -0.3, 0.9, -1.1, 0.4, -0.2]);
        for (middle, radius) in [(0.5, 0.5), (0.25, 0.125), (0.9, 0.01)] {
            let (time, x) = path.around(middle, radius);
            let enclosed = x(0);
            assert!(f64::abs(time.middle - 3.0 - 0.2 * middle) < 1e-15 && time.slope.contains(0.2));
            for part in [-1.0, -0.6, 0.0, 0.3, 1.0] {
                let theta = middle + part * radius;
                let [value, slope] = [path.at(theta), path.slope(theta)].map(|[of]: [f64; 1]| of);
                let widest = 1e-14;
                assert!(
                    time.value.low - widest < path.time(theta) && path.time(theta) < time.value.high + widest
                );
                assert!(
                    enclosed.value.low - widest < value && value < enclosed.value.high + widest,
                    "{theta}: {enclosed:?}"
                );
                assert!(
                    enclosed.slope.low - widest < slope && slope < enclosed.slope.high + widest,
                    "{theta}: {enclosed:?}"
                );
            }
        }
    }

    #[test]
    fn of_what_is_not_a_number_nothing_is_known() {
        for k in 0..POWERS {
            for (odd, radius) in [(f64::NAN, 0.5), (f64::INFINITY, 0.5)] {
                let mut c = [1.0; POWERS];
                c[k] = odd;
                let Interval { low, high } = enclose::<_, { POWERS - 1 }>(c, (0.0, radius)).value;
                assert!(
                    low == f64::NEG_INFINITY || high == f64::INFINITY,
                    "{k}: {odd} gives {low} to {high}"
                );
            }
        }
    }

    /// A single power is enclosed exactly, apart from the sums that are rounded outwards.
    #[test]
    fn powers_are_enclosed_exactly() {
        for k in 1..POWERS {
            let mut c = [0.0; POWERS];
            c[k] = -3.0;
            let (enclosed, radius) = (enclose::<_, { POWERS - 1 }>(c, (0.0, 0.5)), 0.5_f64);
            let (size, steepest) = (3.0 * radius.powi(k as i32), 3.0 * k as f64 * radius.powi(k as i32 - 1));
            let value = [-size, if k % 2 == 0 { 0.0 } else { size }];
            let slope = match k {
                1 => [-3.0, -3.0],
                _ => [-steepest, if k % 2 == 0 { steepest } else { 0.0 }],
            };
            let found = [enclosed.value.low, enclosed.value.high, enclosed.slope.low, enclosed.slope.high];
            for (found, known) in found.into_iter().zip([value, slope].concat()) {
                assert!((found - known).abs() < 1e-14, "{k}: {enclosed:?}");
            }
        }
    }
}
