//! Reactions of joints that bound frictions: forces R that are affine in the multipliers, whose size |R| is not.
//!
//! Newton's method on |R| replaces it by e . R with the unit vector e of the last R, since |R| + e . dR = e . (R + dR). For a reaction
//! along one line e is a sign, which is constant during a step; the rate has a kink where it changes.

use super::rows::{Limit, Rows, below, indices};
use crate::scalar::Scalar;
use crate::vector::Vector;

/// An affine function of the multipliers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine<T, const N: usize> {
    /// Value without contact forces.
    pub own: T,
    /// Factors of the multipliers.
    pub by: [T; N],
}

impl<T: Scalar, const N: usize> Affine<T, N> {
    /// Zero.
    pub(super) fn zero() -> Self {
        Self { own: T::ZERO, by: [T::ZERO; N] }
    }

    /// Its value.
    pub(super) fn at(&self, lambda: &[T; N]) -> T {
        self.by.iter().zip(lambda).fold(self.own, |sum, (by, lambda)| by.mul_add(*lambda, sum))
    }
}

/// The kind of a reaction that bounds frictions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Load {
    /// There is none.
    Nothing,
    /// A force along a line; its sign is constant during a step.
    Line {
        /// True if it is negative.
        negative: bool,
    },
    /// A force along a line that is zero at an event, which has decided its sign.
    Turned {
        /// True if it becomes negative.
        negative: bool,
    },
    /// A force in the plane.
    Plane,
}

impl Load {
    /// True if the sign stored for the step is negative.
    pub(super) fn is_negative(self) -> bool {
        matches!(self, Self::Line { negative: true } | Self::Turned { negative: true })
    }
}

impl<T: Scalar, const N: usize> Rows<T, N> {
    /// Reactions that the limits of a row read.
    pub(super) fn loads_of(&self, row: usize) -> impl Iterator<Item = usize> + '_ {
        let read = &self.read[below::<N>(row)];
        indices::<N>().filter(|load| read[*load])
    }

    /// First row whose limits read a reaction.
    pub(super) fn reader(&self, load: usize) -> Option<usize> {
        let load = below::<N>(load);
        self.read.iter().position(|read| read[load])
    }

    /// Components of a reaction.
    pub(super) fn reaction_at(&self, load: usize, lambda: &[T; N]) -> [T; 2] {
        let [x, y] = &self.reaction[below::<N>(load)];
        [x.at(lambda), y.at(lambda)]
    }

    /// Unit vectors e with |R| = e . R of the reactions that a row with `asked` reads; zero for the others.
    pub(super) fn directions(&self, lambda: &[T; N], asked: impl Fn(usize) -> bool) -> [[T; 2]; N] {
        core::array::from_fn(|load| {
            let is_read = indices::<N>().any(|row| self.read[row][load] && asked(row));
            if is_read { self.direction(load, lambda) } else { [T::ZERO; 2] }
        })
    }

    /// Unit vector e with |R| = e . R; zero if there is no reaction.
    pub(super) fn direction(&self, load: usize, lambda: &[T; N]) -> [T; 2] {
        match self.load[below::<N>(load)] {
            Load::Nothing => [T::ZERO; 2],
            Load::Line { negative } | Load::Turned { negative } => {
                [T::lit(if negative { -1.0 } else { 1.0 }), T::ZERO]
            }
            Load::Plane => {
                let [x, y] = self.reaction_at(load, lambda);
                let size = (x * x + y * y).sqrt();
                if size.to_f64() > 0.0 {
                    let inverse = T::lit(1.0) / size;
                    [x * inverse, y * inverse]
                } else {
                    [T::ZERO; 2]
                }
            }
        }
    }

    /// Size |R| of a reaction; negative if its sign is not that stored for the step.
    pub(super) fn size(&self, load: usize, lambda: &[T; N]) -> T {
        let kind = self.load[below::<N>(load)];
        if kind == Load::Nothing {
            return T::ZERO;
        }
        let [x, y] = self.reaction_at(load, lambda);
        if kind == Load::Plane {
            let square = x * x + y * y;
            return if square.to_f64() > 0.0 { square.sqrt() } else { T::ZERO };
        }
        let [along, across] = self.direction(load, lambda);
        x * along + y * across
    }

    /// Size of the terms of a reaction.
    pub(super) fn terms(&self, load: usize, lambda: &[T; N]) -> T {
        let of = |component: &Affine<T, N>| {
            let terms = component.by.iter().zip(lambda);
            terms.fold(component.own.abs(), |sum, (by, lambda)| sum + (*by * *lambda).abs())
        };
        let [x, y] = &self.reaction[below::<N>(load)];
        of(x) + of(y)
    }

    /// A limit of the friction `row` with these multipliers.
    pub(super) fn limit(&self, row: usize, limit: &Limit<T, N>, lambda: &[T; N]) -> T {
        let add = |sum, load: usize| limit.share[below::<N>(load)].mul_add(self.size(load, lambda), sum);
        self.loads_of(row).fold(limit.at(lambda), add)
    }

    /// A limit with e . R in place of each |R|: own part, and factors of the multipliers.
    pub(super) fn along(&self, row: usize, limit: &Limit<T, N>, directions: &[[T; 2]; N]) -> Affine<T, N> {
        let mut found = Affine { own: limit.own, by: limit.by };
        for load in self.loads_of(row).map(below::<N>) {
            let ([x, y], share, [along, across]) =
                (&self.reaction[load], limit.share[load], directions[load]);
            let add = |own: T, x: T, y: T| own + share * (along * x + across * y);
            found.own = add(found.own, x.own, y.own);
            found.by = Vector::from_fn(|j| add(found.by[j], x.by[j], y.by[j]));
        }
        found
    }

    /// The rows with the own parts of the limits and of the reactions of one row times `factor`, for multipliers times `factor`.
    pub(super) fn times(&self, row: usize, factor: T) -> Self {
        let (mut rows, row) = (*self, below::<N>(row));
        for friction in [&mut rows.kinetic[row], &mut rows.adhesion[row]] {
            for limit in [&mut friction.lower, &mut friction.upper] {
                limit.own = limit.own * factor;
            }
        }
        for load in self.loads_of(row).map(below::<N>) {
            for reaction in &mut rows.reaction[load] {
                reaction.own = reaction.own * factor;
            }
        }
        rows
    }
}
