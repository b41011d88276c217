//! Starts next to singular poses.

use super::conditioning::is_near;
use super::critical::{Critical, Rows};
use super::equations::Equations;
use super::{ExtendedPrecision, size};
use crate::absolute::{Absolute, close, lead};
use crate::double_double::DoubleDouble;
use crate::scalar::{Real, Scalar};
use crate::start::Start;
use crate::tolerances::{NEARBY, STARTS_NEAR};
use crate::vector::Vector;

/// Pose and velocity.
type Closed<S, const NQ: usize> = ([S; NQ], [S; NQ]);

/// An assembled pose next to a singular one, closed as exactly as its locks allow, and the start velocity there; none elsewhere, and
/// where the joints cannot be closed so near to it.
pub fn refine<M, const NQ: usize, const NC: usize, const NX: usize>(
    system: &M,
    t: M::S,
    q: &[M::S; NQ],
) -> Option<Closed<M::S, NQ>>
where
    M: ExtendedPrecision<NQ, NC, NX>,
{
    if !is_near::<M, NQ, NC, NX>(system, t, q, STARTS_NEAR.of::<M::S>()) {
        return None;
    }
    Equations::closed(system, t, q)
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>
    Equations<M, NQ, NC, NX>
{
    /// A pose next to a singular one, closed as exactly as its locks allow, and the start velocity there. It is a call, so that starts
    /// elsewhere take no stack for its numbers.
    #[cold]
    #[inline(never)]
    fn closed(system: &M, t: M::S, q: &[M::S; NQ]) -> Option<Closed<M::S, NQ>> {
        let mut equations = Self::of(*system);
        let extended = system.extended();
        let wide =
            |of: &[M::S; NQ]| -> [DoubleDouble<M::S>; NQ] { Vector::from_fn(|i| DoubleDouble::of(of[i])) };
        let rounded = |of: &[DoubleDouble<M::S>; NQ]| -> [M::S; NQ] { Vector::from_fn(|i| of[i].rounded()) };
        let rows = Rows::<M, NQ, NC, NX>::at(system, &extended, t, &wide(q));
        let critical = rows.and_then(|rows| rows.critical(t, &wide(q)));
        if let Some(critical) = critical.filter(Critical::is_reached) {
            equations.open = critical.open;
        }
        let (t, opened) = (DoubleDouble::of(t), equations.opened(&extended));
        let mut exact = wide(q);
        if !close(&opened, t, &mut exact, &weights_of(&Absolute::start_position(system))) {
            return None;
        }
        let pose = rounded(&exact);
        let start = Absolute::start_velocity(system, &pose);
        let mut v = wide(&Vector::from_fn(|i| start[i].value));
        if !lead(&opened, (t, &exact), &mut v, &weights_of(&start)) {
            return None;
        }
        let v = rounded(&v);
        let moved: [M::S; NQ] = Vector::from_fn(|i| pose[i] - q[i]);
        let beside = size(&moved, |i| equations.typical_of(i) + q[i].abs()) < NEARBY.of::<M::S>();
        (beside && v.is_finite()).then_some((pose, v))
    }
}

/// The metric in which locks stay.
fn weights_of<S: Real, const NQ: usize>(start: &[Start<S>; NQ]) -> [DoubleDouble<S>; NQ] {
    Vector::from_fn(|i| DoubleDouble::lit(if start[i].locked { 0.0 } else { 1.0 }))
}
