//! The equations of motion in absolute coordinates, on states that are led back onto the constraints.

use super::{Fine, size};
use crate::absolute::{Absolute, nearest, split};
use crate::scalar::{Real, Scalar};
use crate::system::{Health, System};
use crate::twofold::Twofold;
use crate::vector::Vector;

/// An accepted state is this near to the constraints, as a part of typical sizes.
const BESIDE: f64 = 1e-6;

/// A mechanism in absolute coordinates: x' = f(P(x)), where P leads a state onto the constraints by the shortest way in the
/// metric of the masses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Equations<M, const NQ: usize, const NC: usize, const NX: usize>(pub(super) M);

/// A state led back onto the constraints, and its rate.
pub(super) struct Evaluated<S, const NX: usize> {
    pub(super) x: [S; NX],
    pub(super) dx: [S; NX],
}

impl<M: Fine<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> Equations<M, NQ, NC, NX> {
    /// A state, led back, and its rate; none where the loops cannot be closed.
    pub(super) fn evaluate(&self, t: M::S, held: &M::U, x: &[M::S; NX]) -> Option<Evaluated<M::S, NX>> {
        let (fine, inputs) = self.0.twofold(held);
        let (t, mut x) = (Twofold::of(t), Vector::from_fn(|i| Twofold::of(x[i])));
        if !nearest::<_, _, NQ, NC, NX>(&fine, t, &mut x) {
            return None;
        }
        let mut dx = x;
        M::accelerate(&fine, t, &inputs, &x, &mut dx);
        let rounded = |x: [Twofold<M::S>; NX]| Vector::from_fn(|i| x[i].rounded());
        let evaluated = Evaluated { x: rounded(x), dx: rounded(dx) };
        evaluated.dx.is_finite().then_some(evaluated)
    }

    /// Is a state where it was before it was led back? Otherwise the constraints are elsewhere: lengths that repeat each
    /// other disagree.
    pub(super) fn is_beside(&self, x: &[M::S; NX], evaluated: &Evaluated<M::S, NX>) -> bool {
        let moved: [M::S; NX] = Vector::from_fn(|i| evaluated.x.at(i) - x.at(i));
        let beside = M::S::lit(BESIDE).max(M::S::EPSILON.sqrt());
        size(&moved, |i| self.typical_of(i) + x.at(i).abs()) < beside
    }

    /// By how much joints are open at a state, all together: what a flat loop lacks is spread over all of them.
    pub(super) fn gap(&self, t: M::S, x: &[M::S; NX]) -> M::S {
        let (q, _) = split::<_, NX, NQ>(x);
        Absolute::phi(&self.0, t, &q).fold(M::S::ZERO, |sum, gap| sum + gap.abs())
    }

    /// The largest length of a state, m: an angle of four radians is rounded as its ports' places are.
    pub(super) fn size(&self, x: &[M::S; NX]) -> M::S {
        let length = self.0.length();
        (0..NQ).fold(length, |most: M::S, i| {
            let turned = if i % 3 == 2 { M::S::lit(0.25) * length } else { M::S::lit(1.0) };
            most.max(turned * x.at(i).abs())
        })
    }

    /// Typical size of each number of a state.
    pub(super) fn typical_of(&self, i: usize) -> M::S {
        match i {
            _ if i >= 2 * NQ => self.0.typical().at(2 * M::NQ + i - 2 * NQ),
            _ if i % NQ.max(1) % 3 == 2 => M::S::lit(1.0),
            _ => self.0.length(),
        }
    }
}

impl<M: Fine<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> System
    for Equations<M, NQ, NC, NX>
{
    type S = M::S;
    type X = [M::S; NX];
    type U = M::U;
    type G = [M::S; 0];
    const NQ: usize = NQ;

    fn rate(&self, t: M::S, u: &M::U, x: &[M::S; NX], dx: &mut [M::S; NX]) -> Health<M::S> {
        // What is not a number makes a step too long, and a shorter one is tried.
        *dx = self.evaluate(t, u, x).map_or([M::S::lit(f64::NAN); NX], |evaluated| evaluated.dx);
        Health::perfect()
    }

    fn typical(&self) -> [M::S; NX] {
        Vector::from_fn(|i| self.typical_of(i))
    }

    fn part_of_state(&self, index: usize) -> &'static str {
        let name = if index < 2 * NQ { M::COORDINATES.get(index % NQ.max(1)) } else { None };
        name.copied().unwrap_or_default()
    }
}
