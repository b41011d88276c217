//! The gap of a mechanism that no pose closes: how far it stays open at one joint if all others are closed.

use super::damped::Measure;
use super::newton::refused;
use super::{Absolute, Layout};
use crate::fault::{Cause, Fault};
use crate::linalg::largest;
use crate::scalar::Real;

/// Factors of the weights of the joint that is to take the whole gap, one after the other.
const YIELDING: [f64; 3] = [0.1, 0.3, 0.3];
/// Damped steps with each, and the part of the violation that each takes away.
const STEPS: (u32, f64) = (300, 1e-8);
/// Others are open by less than this part of it, both as they were weighed.
const ALIKE: f64 = 0.1;
/// Joints that are open by as much share one tension.
const AS_MUCH: f64 = 0.99;
/// A pin is reported rather than a guide or a drive if it is open by at least this part of that one's gap.
const PIN: f64 = 0.1;

/// The fault of joints that cannot be closed, from the pose `q` at which they are open least; the joint is the one that is
/// open widest in the pose where it was seen.
#[cold]
#[inline(never)]
pub(super) fn lack<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    (t, mut q): (S, [S; NQ]),
    free: &[S; NQ],
    seen: &[S; NQ],
) -> Fault {
    if let Some(fault) = refused(m, (t, &q), free) {
        return fault;
    }
    let mut measure = Measure::new(m, free);
    let open = widest(m.layout(), &measure.violation(m, t, seen));
    let is_open = |row: usize| same(m.layout(), row, open);
    for by in YIELDING {
        for (_, weight) in measure.rows.iter_mut().enumerate().filter(|(row, _)| is_open(*row)) {
            *weight = *weight * S::lit(by);
        }
        measure.descend(m, t, &mut q, STEPS);
    }
    let (phi, violation) = (m.phi(t, &q), measure.violation(m, t, &q));
    let open_by = size(m.layout(), &phi, open);
    // Others are still open a little. What closes them costs the joint their violation over its own, both as they were
    // weighed: it is the duality of least squares, exact but for the bend over that little. What is open by more is open by
    // itself.
    let own = size(m.layout(), &violation, open);
    let sum = violation.iter().enumerate().fold(own * own, |sum, (row, v)| {
        let counts = !is_open(row) && v.abs() <= S::lit(ALIKE) * own;
        if counts { v.mul_add(*v, sum) } else { sum }
    });
    let gap = if own > S::ZERO { open_by * (sum / (own * own)) } else { open_by }.to_f64();
    let cause = if largest(&phi).is_finite() { Cause::Open { gap } } else { Cause::NotFinite };
    Fault::of_part(t.to_f64(), m.layout().part(open), cause)
}

/// Do two rows belong to one joint, in one unit?
fn same(layout: &Layout, a: usize, b: usize) -> bool {
    layout.parts.get(a) == layout.parts.get(b) && layout.angular.get(a) == layout.angular.get(b)
}

/// By how much the joint of a row is open in its unit.
fn size<S: Real, const NC: usize>(layout: &Layout, phi: &[S; NC], row: usize) -> S {
    let rows = phi.iter().enumerate().filter(|(other, _)| same(layout, *other, row));
    rows.fold(S::ZERO, |sum, (_, phi)| phi.mul_add(*phi, sum)).sqrt()
}

/// A row of the joint that is open widest. A tension opens all joints of a loop alike: the last of them is the one that closes
/// it, and a pin is where it is seen.
fn widest<S: Real, const NC: usize>(layout: &Layout, violation: &[S; NC]) -> usize {
    let is_pin = |row: usize| {
        let rows = (0..layout.rows.len()).filter(|other| same(layout, *other, row)).count();
        layout.angular.get(row) == Some(&false) && rows > 1
    };
    let widest_of = |pins: bool| {
        let rows = (0..layout.rows.len()).filter(|row| !pins || is_pin(*row));
        rows.fold((S::ZERO, 0), |(widest, found), row| {
            let size = size(layout, violation, row);
            if size >= S::lit(AS_MUCH) * widest { (size.max(widest), row) } else { (widest, found) }
        })
    };
    let ((any, row), (pin, row_of_pin)) = (widest_of(false), widest_of(true));
    if pin > S::ZERO && pin >= S::lit(PIN) * any { row_of_pin } else { row }
}
