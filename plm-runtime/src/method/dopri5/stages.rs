//! The stages of one trial step, and the polynomial between its ends.

use super::tableau::{
    A21, A31, A32, A41, A42, A43, A51, A52, A53, A54, A61, A62, A63, A64, A65, A71, A73, A74, A75, A76, C2,
    C3, C4, C5, D1, D3, D4, D5, D6, D7, E1, E3, E4, E5, E6, E7,
};
use crate::fault::Fault;
use crate::method::Course;
use crate::scalar::Scalar;
use crate::system::System;
use crate::vector::Vector;

/// A step that may be accepted.
pub(super) struct Trial<X> {
    /// The state at its end, of order 5.
    pub(super) x: X,
    /// The rate there.
    pub(super) rate: X,
    /// Estimate of the error of order 4.
    pub(super) error: X,
    /// The part of the dense output that the ends do not determine.
    pub(super) bend: X,
}

/// The seven stages from `(course.time, course.x)` with the rate `k1` there.
pub(super) fn trial<M: System>(course: &mut Course<'_, M>, k1: &M::X, h: M::S) -> Result<Trial<M::X>, Fault> {
    let (t, x) = (course.time, course.x);
    let c = |c: f64| t + M::S::lit(c) * h;
    let a = |a: f64| M::S::lit(a) * h;
    let mut stage = x;
    let [mut k2, mut k3, mut k4, mut k5, mut k6, mut k7] = [*k1; 6];
    stage.combine(&x, [(a(A21), k1)]);
    course.rate(c(C2), &stage, &mut k2)?;
    stage.combine(&x, [(a(A31), k1), (a(A32), &k2)]);
    course.rate(c(C3), &stage, &mut k3)?;
    stage.combine(&x, [(a(A41), k1), (a(A42), &k2), (a(A43), &k3)]);
    course.rate(c(C4), &stage, &mut k4)?;
    stage.combine(&x, [(a(A51), k1), (a(A52), &k2), (a(A53), &k3), (a(A54), &k4)]);
    course.rate(c(C5), &stage, &mut k5)?;
    stage.combine(&x, [(a(A61), k1), (a(A62), &k2), (a(A63), &k3), (a(A64), &k4), (a(A65), &k5)]);
    course.rate(t + h, &stage, &mut k6)?;
    stage.combine(&x, [(a(A71), k1), (a(A73), &k3), (a(A74), &k4), (a(A75), &k5), (a(A76), &k6)]);
    course.rate(t + h, &stage, &mut k7)?;
    let sum = |weights: [f64; 6]| {
        let [w1, w3, w4, w5, w6, w7] = weights.map(a);
        let mut sum = M::X::fill(M::S::lit(0.0));
        sum.add([(w1, k1), (w3, &k3), (w4, &k4), (w5, &k5), (w6, &k6), (w7, &k7)]);
        sum
    };
    let (error, bend) = (sum([E1, E3, E4, E5, E6, E7]), sum([D1, D3, D4, D5, D6, D7]));
    Ok(Trial { x: stage, rate: k7, error, bend })
}

/// The polynomial of degree 4 between the ends of a step: through both states with their rates, and of order 4 within
/// (Hairer, Nørsett, Wanner I, II.6; CONTD5 of their program DOPRI5).
#[derive(Clone, Copy, Debug)]
pub(super) struct Dense<S, X> {
    pub(super) time: S,
    pub(super) h: S,
    pub(super) from: X,
    pub(super) to: X,
    pub(super) rate_from: X,
    pub(super) rate_to: X,
    pub(super) bend: X,
}

impl<S: Scalar, X: Vector<S>> Dense<S, X> {
    /// The state at `time`.
    pub(super) fn at(&self, time: S) -> X {
        let theta = (time - self.time) / self.h;
        let rest = S::lit(1.0) - theta;
        X::from_fn(|i| {
            let change = self.to.at(i) - self.from.at(i);
            let start_slope = self.h * self.rate_from.at(i) - change;
            let end_slope = change - self.h * self.rate_to.at(i) - start_slope;
            self.from.at(i)
                + theta * (change + rest * (start_slope + theta * (end_slope + rest * self.bend.at(i))))
        })
    }
}
