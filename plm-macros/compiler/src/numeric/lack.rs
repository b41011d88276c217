//! Gap of a mechanism that no pose closes, the compiler's twin of the runtime's `absolute/lack.rs`: how far it stays open at
//! one joint where all others are closed.

use crate::collect::CollectVec;

use super::constraints::{Closed, Constraints};
use super::damped::Measure;
use crate::model::Model;

/// Weights of a joint that is to take all that others cannot give, one after the other.
const YIELDING: [f64; 3] = [0.1, 0.3, 0.3];
/// Damped steps with each, and the part of the violation that each takes away.
const STEPS: (usize, f64) = (300, 1e-8);
/// Others are open by less than this part of it, both as they were weighed.
const ALIKE: f64 = 0.1;
/// Joints that are open by as much share one tension.
const AS_MUCH: f64 = 0.99;
/// Pins are told rather than what guides or drives, where they are open by this part of it.
const PIN: f64 = 0.1;

/// From the pose `q` at which joints are open least one at which one alone is open; of the others `phi` is taken as zero where it
/// goes with that one.
pub(super) fn lack(constraints: &Constraints, mut q: Vec<f64>, locked: &[bool], steps: usize) -> Closed {
    let model = constraints.scene.model;
    let mut measure = Measure::new(constraints, locked);
    let open = widest(model, &measure.violation(&q));
    let is_open = |row: usize| same(model, row, open);
    for by in YIELDING {
        for (_, weight) in measure.rows.iter_mut().enumerate().filter(|(row, _)| is_open(*row)) {
            *weight *= by;
        }
        measure.descend(&mut q, STEPS);
    }
    let violation = measure.violation(&q);
    let own = size(model, &violation, open);
    let goes_with = |(row, v): (usize, &f64)| !is_open(row) && v.abs() <= ALIKE * own;
    // Others are still open a little. What closes them costs the joint their violation over its own, both as they were
    // weighed: it is the duality of least squares, exact but for the bend over that little.
    let sum = violation.iter().enumerate().filter(|row| goes_with(*row)).fold(0.0, |sum, (_, v)| sum + v * v);
    let phi = constraints.phi(&q).into_iter().enumerate().map(|(row, phi)| match () {
        () if is_open(row) && own > 0.0 => phi * (1.0 + sum / (own * own)),
        () if goes_with((row, &violation[row])) => 0.0,
        () => phi,
    });
    Closed { phi: phi.collect_vec(), q, steps }
}

/// Do two rows belong to one joint, in one unit?
fn same(model: &Model, a: usize, b: usize) -> bool {
    let (a, b) = (&model.rows[a], &model.rows[b]);
    a.part == b.part && a.is_angular() == b.is_angular()
}

/// By how much the joint of a row is open in its unit.
fn size(model: &Model, phi: &[f64], row: usize) -> f64 {
    let rows = phi.iter().enumerate().filter(|(other, _)| same(model, *other, row));
    plm_math::f64::sqrt(rows.fold(0.0, |sum, (_, phi)| sum + phi * phi))
}

/// A row of the joint that is open widest. A tension opens all joints of a loop alike: the last of them is the one that closes
/// it, and a pin is where it is seen.
fn widest(model: &Model, violation: &[f64]) -> usize {
    let rows = model.rows.len();
    let is_pin = |row: usize| {
        !model.rows[row].is_angular() && (0..rows).filter(|other| same(model, *other, row)).count() > 1
    };
    let widest_of = |pins: bool| {
        let (mut widest, mut found) = (0.0_f64, 0);
        for row in (0..rows).filter(|row| !pins || is_pin(*row)) {
            let size = size(model, violation, row);
            if size >= AS_MUCH * widest {
                (widest, found) = (size.max(widest), row);
            }
        }
        (widest, found)
    };
    let ((any, row), (pin, row_of_pin)) = (widest_of(false), widest_of(true));
    if pin > 0.0 && pin >= PIN * any { row_of_pin } else { row }
}
