//! Coordinates of a state next to a singular pose: those of a chart, or absolute ones.

use super::ExtendedPrecision;
use crate::absolute;
use crate::charts::{self, Charted};
use crate::scalar::Scalar;
use crate::system::{Rate, Step};

/// Coordinates of a mechanism that has singular poses: a type without values, chosen with the formulation.
pub trait Coordinates<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> {
    /// As [`ExtendedPrecision::is_charted`].
    fn is_charted(system: &M) -> bool;

    /// As [`ExtendedPrecision::crossed`].
    fn crossed(step: &Step<'_, M>) -> M::S;

    /// As [`ExtendedPrecision::is_near`].
    fn is_near(held: &M::U) -> bool;

    /// As [`ExtendedPrecision::full`].
    fn full(system: &M, t: M::S, held: &M::U, x: &M::X) -> [M::S; NX];

    /// As [`ExtendedPrecision::hold`].
    fn hold(system: &M, held: &mut M::U, x: &mut M::X, full: &[M::S; NX]);

    /// As [`ExtendedPrecision::flat_part`].
    fn flat_part(system: &M, t: M::S, full: &[M::S; NX]) -> &'static str;
}

/// Joint coordinates in charts.
#[derive(Clone, Copy, Debug)]
pub struct InCharts;

/// Absolute coordinates.
#[derive(Clone, Copy, Debug)]
pub struct InAbsolute;

/// Coordinates that the mechanism chooses by [`Charted::has_charts`], as one from text does.
#[derive(Clone, Copy, Debug)]
pub struct ByMechanism;

impl<M, const NQ: usize, const NC: usize, const NX: usize> Coordinates<M, NQ, NC, NX> for InCharts
where
    M: ExtendedPrecision<NQ, NC, NX> + Charted<Q = [<M as Rate>::S; NQ]>,
{
    #[inline]
    fn is_charted(_system: &M) -> bool {
        true
    }

    #[inline]
    fn crossed(step: &Step<'_, M>) -> M::S {
        charts::crossed(step)
    }

    fn is_near(held: &M::U) -> bool {
        charts::is_free::<M>(held)
    }

    fn full(system: &M, t: M::S, held: &M::U, x: &M::X) -> [M::S; NX] {
        charts::full(system, t, held, x)
    }

    fn hold(_system: &M, held: &mut M::U, x: &mut M::X, full: &[M::S; NX]) {
        charts::hold::<M, NX>(held, x, full);
    }

    fn flat_part(system: &M, t: M::S, full: &[M::S; NX]) -> &'static str {
        let (q, v): ([M::S; NQ], [M::S; NQ]) = absolute::split(full);
        charts::flat_part(system, t, &q, &v)
    }
}

impl<M, const NQ: usize, const NC: usize, const NX: usize> Coordinates<M, NQ, NC, NX> for InAbsolute
where
    M: ExtendedPrecision<NQ, NC, NX> + Rate<X = [<M as Rate>::S; NX]>,
{
    #[inline]
    fn is_charted(_system: &M) -> bool {
        false
    }

    #[inline]
    fn crossed(_step: &Step<'_, M>) -> M::S {
        M::S::lit(0.0)
    }

    fn is_near(_held: &M::U) -> bool {
        false
    }

    fn full(_system: &M, _t: M::S, _held: &M::U, x: &M::X) -> [M::S; NX] {
        *x
    }

    fn hold(_system: &M, _held: &mut M::U, x: &mut M::X, full: &[M::S; NX]) {
        *x = *full;
    }

    fn flat_part(system: &M, t: M::S, full: &[M::S; NX]) -> &'static str {
        absolute::flat_part::<_, _, NQ, NC>(system, t, &absolute::split(full).0)
    }
}

impl<M, const NQ: usize, const NC: usize, const NX: usize> Coordinates<M, NQ, NC, NX> for ByMechanism
where
    M: ExtendedPrecision<NQ, NC, NX> + Charted<Q = [<M as Rate>::S; NQ]> + Rate<X = [<M as Rate>::S; NX]>,
{
    fn is_charted(system: &M) -> bool {
        system.has_charts()
    }

    fn crossed(step: &Step<'_, M>) -> M::S {
        if step.system.has_charts() { InCharts::crossed(step) } else { InAbsolute::crossed(step) }
    }

    fn is_near(held: &M::U) -> bool {
        // Without charts the loops of a discrete state are not free.
        charts::is_free::<M>(held)
    }

    fn full(system: &M, t: M::S, held: &M::U, x: &M::X) -> [M::S; NX] {
        if system.has_charts() {
            InCharts::full(system, t, held, x)
        } else {
            InAbsolute::full(system, t, held, x)
        }
    }

    fn hold(system: &M, held: &mut M::U, x: &mut M::X, full: &[M::S; NX]) {
        if system.has_charts() {
            InCharts::hold(system, held, x, full);
        } else {
            InAbsolute::hold(system, held, x, full);
        }
    }

    fn flat_part(system: &M, t: M::S, full: &[M::S; NX]) -> &'static str {
        if system.has_charts() {
            InCharts::flat_part(system, t, full)
        } else {
            InAbsolute::flat_part(system, t, full)
        }
    }
}
