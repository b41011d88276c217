//! Scales of residuals: rows in m by the size and the reach of the scene, rows in rad by the radian.

use super::Absolute;
use crate::linalg::largest;
use crate::scalar::Real;
use crate::tolerances::closed;

/// A joint of two bars whose angles are rounded is open by so many units in the last place of the angles, times the lengths.
const ROUNDINGS: f64 = 4.0;

/// The sizes of residuals: m and rad, or m/s and rad/s.
#[derive(Clone, Copy)]
pub(super) struct Scale<S> {
    length: S,
    angle: S,
}

impl<S: Real> Scale<S> {
    /// Of positions at `q`. A scene far from the origin has the rounding of its place, and bars that have turned many times that
    /// of their angles.
    pub(super) fn of_position<M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
        m: &M,
        q: &[S; NQ],
    ) -> Self {
        let (place, turn) = apart(q);
        let rounding = S::lit(ROUNDINGS) * S::EPSILON / Self::closed() * turn * m.length();
        Self { length: m.length().max(place).max(rounding), angle: turn.max(S::lit(1.0)) }
    }

    /// Of velocities `v` at `q`: rest is measured by 1 rad/s, and by 1 m/s or by a scene of less than 1 m turning so.
    pub(super) fn of_velocity<M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
        m: &M,
        q: &[S; NQ],
        v: &[S; NQ],
    ) -> Self {
        let reach = Self::of_position(m, q).length;
        let (speed, turn) = apart(v);
        let rest = m.length().min(S::lit(1.0));
        Self { length: speed.max(turn * reach).max(rest), angle: turn.max(S::lit(1.0)) }
    }

    /// The size of a row in rad, or in m.
    pub(super) fn size(&self, angular: bool) -> S {
        if angular { self.angle } else { self.length }
    }

    /// The largest violation over its size; NaN if one is not a number.
    pub(super) fn worst<M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
        &self,
        m: &M,
        violation: &[S; NC],
    ) -> S {
        let (mut scaled, layout) = (*violation, m.layout());
        for (row, r) in scaled.iter_mut().enumerate() {
            *r = *r / self.size(layout.is_angular(row));
        }
        largest(&scaled)
    }

    /// Is the violation small enough for joints to count as closed?
    pub(super) fn is_closed<M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
        &self,
        m: &M,
        violation: &[S; NC],
    ) -> bool {
        self.worst(m, violation) <= Self::closed()
    }

    /// The fraction of the size up to which joints count as closed.
    fn closed() -> S {
        closed()
    }
}

/// The largest of places (or speeds), and of angles (or angular velocities).
fn apart<S: Real, const NQ: usize>(q: &[S; NQ]) -> (S, S) {
    let (mut place, mut turn) = (S::lit(0.0), S::lit(0.0));
    for (k, value) in q.iter().enumerate() {
        let size = if k % 3 == 2 { &mut turn } else { &mut place };
        *size = size.max(value.abs());
    }
    (place, turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_third_coordinate_is_an_angle() {
        assert_eq!(apart(&[1.0, -2.0, 3.0, 4.0, 5.0, -6.0, 0.5, -7.0, 0.25]), (7.0, 6.0));
        assert_eq!(apart(&[0.0, 0.0, -9.0]), (0.0, 9.0));
    }
}
