//! Root of a function of one variable.

use crate::scalar::Real;

/// A number, and the value of the function there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<S> {
    pub(super) at: S,
    pub(super) value: S,
}

/// The first number past a root of `f` between `a`, where it is positive, and `b`, where it is not, to `tolerance`.
///
/// The method ITP: interpolation by a secant, moved towards the middle, within the reach in which no more evaluations
/// than one above those of bisection can be needed (I. F. D. Oliveira, R. H. C. Takahashi, An enhancement of the
/// bisection method average performance preserving minmax optimality, ACM Trans. Math. Software 47, 2020; its
/// kappa_1 = 0.2 / (b - a), kappa_2 = 2, n_0 = 1). It is compiled once for each kind of numbers, not for each function.
pub(super) fn root<S: Real>(mut a: Point<S>, mut b: Point<S>, tolerance: S, f: &mut dyn FnMut(S) -> S) -> S {
    let (half, zero) = (S::lit(0.5), S::lit(0.0));
    let kappa = S::lit(0.2) / (b.at - a.at);
    let mut reach = S::lit(2.0) * tolerance;
    while reach < b.at - a.at {
        reach = reach + reach;
    }
    while b.at - a.at > S::lit(2.0) * tolerance {
        let width = b.at - a.at;
        let middle = a.at + half * width;
        let secant = a.at + width * (a.value / (a.value - b.value));
        let towards = (middle - secant).signum0();
        let shift = kappa * width * width;
        let moved = if shift <= (middle - secant).abs() { secant + towards * shift } else { middle };
        let radius = (reach - half * width).max(zero);
        let chosen = if (moved - middle).abs() <= radius { moved } else { middle - towards * radius };
        let next = if chosen > a.at && chosen < b.at { chosen } else { middle };
        if !(next > a.at && next < b.at) {
            break;
        }
        let point = Point { at: next, value: f(next) };
        if point.value > zero {
            a = point;
        } else {
            b = point;
        }
        reach = half * reach;
    }
    b.at
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Root, and number of evaluations.
    fn found(f: impl Fn(f64) -> f64, a: f64, b: f64) -> (f64, u32) {
        let (mut count, point) = (0, |at| Point { at, value: f(at) });
        let root = root(point(a), point(b), 1e-15, &mut |x| {
            count += 1;
            f(x)
        });
        (root, count)
    }

    #[test]
    fn smooth_roots_take_a_third_of_bisection_and_others_at_most_two_more() {
        let (x, count) = found(f64::cos, 0.0, 3.0);
        assert!((x - core::f64::consts::FRAC_PI_2).abs() < 4e-15 && count <= 17, "{x} {count}");
        // Flat, and a jump; bisection needs log2(3 / 2e-15) = 51.
        for f in [(|x| (1.0 - x).powi(9)) as fn(f64) -> f64, |x| if x < 1.0 { 1e-9 } else { -1.0 }] {
            let (x, count) = found(f, 0.0, 3.0);
            assert!((x - 1.0).abs() < 3e-15 && count <= 53, "{x} {count}");
        }
    }
}
