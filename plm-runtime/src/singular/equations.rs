//! The equations of motion in absolute coordinates, on states that are led back onto the constraints.

use super::{ExtendedPrecision, size};
use crate::absolute::{Absolute, Layout, nearest, split};
use crate::double_double::DoubleDouble;
use crate::scalar::{Real, Scalar};
use crate::start::Start;
use crate::system::{Constraints, Events, Health, Labels, Rate};
use crate::tolerances::{ANGLE_ROUNDED, POSE_MOVED, VELOCITY_MOVED, half_of_digits};
use crate::vector::Vector;

/// A mechanism in absolute coordinates: x' = f(P(x)), where P leads a state onto the constraints by the shortest way in the
/// metric of the masses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Equations<
    M: ExtendedPrecision<NQ, NC, NX>,
    const NQ: usize,
    const NC: usize,
    const NX: usize,
> {
    pub(super) system: M,
    /// Gaps by which the joints are open, m and rad: less than the rounding of the lengths, so that a singular pose is one exactly.
    pub(super) open: [DoubleDouble<M::S>; NC],
}

/// A mechanism whose joints are open by a given amount.
pub(super) struct Opened<'m, F, S, const NC: usize> {
    of: &'m F,
    open: &'m [DoubleDouble<S>; NC],
}

impl<S: Real, F: Absolute<DoubleDouble<S>, NQ, NC>, const NQ: usize, const NC: usize>
    Absolute<DoubleDouble<S>, NQ, NC> for Opened<'_, F, S, NC>
{
    fn layout(&self) -> &'static Layout {
        self.of.layout()
    }

    fn phi(&self, t: DoubleDouble<S>, q: &[DoubleDouble<S>; NQ]) -> [DoubleDouble<S>; NC] {
        let phi = self.of.phi(t, q);
        Vector::from_fn(|r| phi[r] - self.open[r])
    }
    fn phi_dot(
        &self,
        t: DoubleDouble<S>,
        q: &[DoubleDouble<S>; NQ],
        v: &[DoubleDouble<S>; NQ],
    ) -> [DoubleDouble<S>; NC] {
        self.of.phi_dot(t, q, v)
    }
    fn phi_q(
        &self,
        t: DoubleDouble<S>,
        q: &[DoubleDouble<S>; NQ],
        each: &mut impl FnMut(usize, usize, DoubleDouble<S>),
    ) {
        self.of.phi_q(t, q, each);
    }
    fn min_norm(
        &self,
        t: DoubleDouble<S>,
        q: &[DoubleDouble<S>; NQ],
        w: &[DoubleDouble<S>; NQ],
        r: &[DoubleDouble<S>; NC],
        dq: &mut [DoubleDouble<S>; NQ],
    ) -> Health<DoubleDouble<S>> {
        self.of.min_norm(t, q, w, r, dq)
    }
    fn inverse_mass(&self) -> [DoubleDouble<S>; NQ] {
        self.of.inverse_mass()
    }
    fn start_position(&self) -> [Start<DoubleDouble<S>>; NQ] {
        self.of.start_position()
    }
    fn start_velocity(&self, q: &[DoubleDouble<S>; NQ]) -> [Start<DoubleDouble<S>>; NQ] {
        self.of.start_velocity(q)
    }
    fn length(&self) -> DoubleDouble<S> {
        self.of.length()
    }
}

/// A state led back onto the constraints, and its rate.
pub(super) struct Evaluated<S, const NX: usize> {
    pub(super) x: [S; NX],
    pub(super) dx: [S; NX],
}

impl<S: Real, const NX: usize> Evaluated<DoubleDouble<S>, NX> {
    pub(super) fn rounded(&self) -> Evaluated<S, NX> {
        let rounded = |x: &[DoubleDouble<S>; NX]| Vector::from_fn(|i| x[i].rounded());
        Evaluated { x: rounded(&self.x), dx: rounded(&self.dx) }
    }
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>
    Equations<M, NQ, NC, NX>
{
    /// Of closed joints.
    pub(super) fn of(system: M) -> Self {
        Self { system, open: [DoubleDouble::ZERO; NC] }
    }

    /// The constraints.
    pub(super) fn opened<'m>(&'m self, extended: &'m M::Extended) -> Opened<'m, M::Extended, M::S, NC> {
        Opened { of: extended, open: &self.open }
    }

    /// A state, led back, and its rate; none where the loops cannot be closed.
    pub(super) fn evaluate(&self, t: M::S, held: &M::U, x: &[M::S; NX]) -> Option<Evaluated<M::S, NX>> {
        self.exact(t, held, &Vector::from_fn(|i| DoubleDouble::of(x[i]))).map(|exact| exact.rounded())
    }

    /// A state in numbers of twice the precision, led back, and its rate.
    pub(super) fn exact(
        &self,
        t: M::S,
        held: &M::U,
        x: &[DoubleDouble<M::S>; NX],
    ) -> Option<Evaluated<DoubleDouble<M::S>, NX>> {
        let (extended, inputs) = self.system.extended_with_inputs(held);
        let (t, mut x) = (DoubleDouble::of(t), *x);
        if !nearest::<_, _, NQ, NC, NX>(&self.opened(&extended), t, &mut x) {
            return None;
        }
        let mut dx = x;
        M::accelerate(&extended, t, &inputs, &x, &mut dx);
        let exact = Evaluated { x, dx };
        exact.dx.is_finite().then_some(exact)
    }

    /// Is a state where it was before it was led back? Otherwise the constraints are elsewhere: lengths that repeat each
    /// other disagree.
    pub(super) fn is_beside(&self, x: &[M::S; NX], evaluated: &Evaluated<M::S, NX>) -> bool {
        let moved: [M::S; NX] = Vector::from_fn(|i| evaluated.x.at(i) - x.at(i));
        let beside = half_of_digits::<M::S>(POSE_MOVED);
        let tangent = half_of_digits::<M::S>(VELOCITY_MOVED);
        let allowed = |i: usize| if (NQ..2 * NQ).contains(&i) { tangent } else { beside };
        size(&moved, |i| allowed(i) * (self.typical_of(i) + x.at(i).abs())) < M::S::lit(1.0)
    }

    /// By how much joints are open at a state, all together: what a flat loop lacks is spread over all of them.
    pub(super) fn gap(&self, t: M::S, x: &[M::S; NX]) -> M::S {
        let (q, _) = split::<_, NX, NQ>(x);
        let phi = self.system.phi(t, &q);
        (0..NC).fold(M::S::ZERO, |sum, r| sum + (phi[r] - self.open[r].rounded()).abs())
    }

    /// The largest length of a state, m: an angle of four radians is rounded as its ports' places are.
    pub(super) fn size(&self, x: &[M::S; NX]) -> M::S {
        let length = self.system.length();
        (0..NQ).fold(length, |most: M::S, i| {
            let turned = if i % 3 == 2 { ANGLE_ROUNDED.of::<M::S>() * length } else { M::S::lit(1.0) };
            most.max(turned * x.at(i).abs())
        })
    }

    /// Typical size of each number of a state.
    pub(super) fn typical_of(&self, i: usize) -> M::S {
        match i {
            _ if i >= 2 * NQ => self.system.typical().at(2 * M::NQ + i - 2 * NQ),
            _ if i % NQ.max(1) % 3 == 2 => M::S::lit(1.0),
            _ => self.system.length(),
        }
    }
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> Rate
    for Equations<M, NQ, NC, NX>
{
    type S = M::S;
    type X = [M::S; NX];
    type U = M::U;
    const NQ: usize = NQ;

    fn rate(&self, t: M::S, u: &M::U, x: &[M::S; NX], dx: &mut [M::S; NX]) -> Health<M::S> {
        // NaN means that a step is too long, and a shorter one is tried.
        *dx = self.evaluate(t, u, x).map_or([M::S::lit(f64::NAN); NX], |evaluated| evaluated.dx);
        Health::perfect()
    }

    fn coordinates(&self) -> usize {
        self.system.layout().coordinates.len()
    }

    fn states(&self) -> usize {
        let first_order = self.system.states() - 2 * self.system.coordinates();
        2 * self.coordinates() + first_order
    }

    fn typical(&self) -> [M::S; NX] {
        Vector::from_fn(|i| self.typical_of(i))
    }
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> Constraints
    for Equations<M, NQ, NC, NX>
{
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> Events
    for Equations<M, NQ, NC, NX>
{
    type G = [M::S; 0];
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> Labels
    for Equations<M, NQ, NC, NX>
{
    fn part_of_state(&self, index: usize) -> &'static str {
        let names = self.system.layout().coordinates;
        let name = if index < 2 * NQ { names.get(index % NQ.max(1)) } else { None };
        name.copied().unwrap_or_default()
    }
}
