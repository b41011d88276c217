//! The state over the last step, from the polynomial through the rates that led to it.
//!
//! Its degree is up to 14, that of a [`Path`] is 8. The path is the remainder of a division by a polynomial of degree 9, so
//! that it interpolates at the zeros of the divisor: both ends, twice, so that states and rates there stay, and between
//! them the zeros of Chebyshev's polynomial of the second kind. For x^9 its error is at most 6e-5, for x^14 7e-3. The
//! coefficients themselves are small there: a method of order k has steps over which the derivative of order k changes the
//! rate by about the tolerance, and a term of x^m has the factor 1/m!.

use super::MOST;
use super::coefficients::Coefficients;
use super::differences::Differences;
use crate::method::Path;
use crate::method::embedded::Span;
use crate::method::path::POWERS;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Number of powers of a polynomial that is integrated twice.
const LONG: usize = MOST + 3;

/// Divisor: theta^9 less these powers of theta.
const DIVISOR: [f64; POWERS] = {
    // Zeros 0, 0, 1, 1, 1/2, 1/4, 3/4, and (2 - sqrt(3))/4 with (2 + sqrt(3))/4, whose sum is 1 and whose product is 1/16.
    let (mut p, mut degree) = ([0.0; POWERS + 1], 2);
    (p[2], p[3], p[4]) = (1.0 / 16.0, -1.0, 1.0);
    degree += 2;
    let zeros = [1.0, 1.0, 0.5, 0.25, 0.75];
    let mut z = 0;
    while z < zeros.len() {
        degree += 1;
        let mut k = degree;
        while k > 0 {
            p[k] = p[k - 1] - zeros[z] * p[k];
            k -= 1;
        }
        p[0] *= -zeros[z];
        z += 1;
    }
    let mut less = [0.0; POWERS];
    let mut k = 0;
    while k < POWERS {
        less[k] = -p[k];
        k += 1;
    }
    less
};

/// Path over a step of order k, through both its ends; `differences` has phi_1 to phi_(k+1).
pub(super) fn path<M: System<S: Real>>(
    span: &Span<M::S, M::X>,
    differences: &Differences<M>,
    by: &Coefficients<M::S>,
    order: usize,
) -> Path<M::S, M::X> {
    let (h, zero) = (span.h, M::S::ZERO);
    let mut coefficients = [M::X::fill(zero); POWERS];
    // c_1 = 1, c_(i+1) = c_i (theta + (psi_(i-1) - h) / h) h / psi_i (Shampine and Gordon, chapter 5, eq. (7)).
    let mut basis = [zero; LONG];
    basis[0] = M::S::lit(1.0);
    for i in 1..=order + 1 {
        let row = differences.at(i);
        let once = integral(&basis);
        let twice = reduced(integral(&once)).map(|s| h * h * s);
        let once = reduced(once).map(|s| h * s);
        for (m, power) in coefficients.iter_mut().enumerate() {
            for l in M::NQ..M::X::LEN {
                power.set(l, once[m].mul_add(row.at(l), power.at(l)));
            }
            for q in 0..M::NQ {
                power.set(q, twice[m].mul_add(row.at(M::NQ + q), power.at(q)));
            }
        }
        let before = if i > 1 { by.psi.at(i - 1) } else { zero };
        basis = times(&basis, (before - h) / h, h / by.psi.at(i));
    }
    begin(&mut coefficients, span, M::NQ);
    end(&mut coefficients, span);
    Path { start: span.time, h, coefficients }
}

/// Begins the integrals with the state, and those of coordinates with the velocity too.
fn begin<S: Real, X: Vector<S>>(powers: &mut [X; POWERS], span: &Span<S, X>, coordinates: usize) {
    powers[0] = span.from;
    for q in 0..coordinates {
        powers[1].set(q, span.h.mul_add(span.from.at(coordinates + q), powers[1].at(q)));
    }
}

/// Corrects the path to the state at the end and its rate, by the cubic of C. Hermite for the differences.
fn end<S: Real, X: Vector<S>>(powers: &mut [X; POWERS], span: &Span<S, X>) {
    let (two, three) = (S::lit(2.0), S::lit(3.0));
    for l in 0..X::LEN {
        let (value, slope) =
            powers.iter().enumerate().fold((S::ZERO, S::ZERO), |(value, slope), (m, power)| {
                (value + power.at(l), S::lit(m as f64).mul_add(power.at(l), slope))
            });
        let (place, rate) = (span.to.at(l) - value, span.h * span.rate_to.at(l) - slope);
        powers[2].set(l, powers[2].at(l) + (three * place - rate));
        powers[3].set(l, powers[3].at(l) + (rate - two * place));
    }
}

/// Integral from zero. The highest power must be zero, so that none is lost.
fn integral<S: Real>(p: &[S; LONG]) -> [S; LONG] {
    Vector::from_fn(|m| if m == 0 { S::ZERO } else { p[m - 1] / S::lit(m as f64) })
}

/// A polynomial times (theta + `shift`) `factor`.
fn times<S: Real>(p: &[S; LONG], shift: S, factor: S) -> [S; LONG] {
    Vector::from_fn(|m| {
        let below = if m == 0 { S::ZERO } else { p[m - 1] };
        factor * shift.mul_add(p[m], below)
    })
}

/// Remainder of a division by theta^9 - `DIVISOR`.
fn reduced<S: Real>(mut p: [S; LONG]) -> [S; POWERS] {
    for top in (POWERS..LONG).rev() {
        let highest = p[top];
        for (m, less) in DIVISOR.iter().enumerate() {
            let place = top - POWERS + m;
            p[place] = S::lit(*less).mul_add(highest, p[place]);
        }
    }
    Vector::from_fn(|m| p[m])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The remainder agrees with the power at the zeros of the divisor; at the ends its slope agrees too.
    #[test]
    fn high_powers_are_replaced_by_what_interpolates_them() {
        let root = f64::sqrt(3.0);
        let zeros = [0.0, 1.0, 0.5, 0.25, 0.75, (2.0 - root) / 4.0, (2.0 + root) / 4.0];
        for power in POWERS..LONG {
            let mut p = [0.0; LONG];
            p[power] = 1.0;
            let c = reduced(p);
            let at = |x: f64| c.iter().rev().fold(0.0, |sum, c| sum * x + c);
            for x in zeros {
                assert!((at(x) - x.powi(power as i32)).abs() < 1e-12, "{power} at {x}: {}", at(x));
            }
            let steepest: f64 = c.iter().enumerate().map(|(m, c)| m as f64 * c).sum();
            assert!(c[1] == 0.0 && (steepest - power as f64).abs() < 1e-11, "{power}: {} {steepest}", c[1]);
            let rest = (0..=1000).map(|k| 1e-3 * f64::from(k)).map(|x| (at(x) - x.powi(power as i32)).abs());
            let worst = rest.fold(0.0, f64::max);
            assert!(worst < if power == POWERS { 6e-5 } else { 7e-3 }, "{power}: {worst:e}");
        }
    }
}
