//! Rows of a pose, combined: which of them depend on each other.

use crate::linalg::{add, dot, largest};
use crate::scalar::Real;
use crate::tolerances::{REPEATED, SMALL, vanished};

/// The rows of a pose by how they depend on each other: combinations of them that are orthogonal.
pub(super) struct Combined<S, const NQ: usize, const NC: usize> {
    /// Orthogonal rows.
    pub(super) rows: [[S; NQ]; NC],
    /// How they are made.
    pub(super) of: [[S; NC]; NC],
    /// Their norms.
    pub(super) sizes: [S; NC],
    /// Combinations up to this size vanish at the singular pose.
    pub(super) small: S,
    /// True for combinations of rows that are not redundant.
    pub(super) kept: [bool; NC],
}

impl<S: Real, const NQ: usize, const NC: usize> Combined<S, NQ, NC> {
    pub(super) fn nothing() -> Self {
        let zero = S::ZERO;
        Self {
            rows: [[zero; NQ]; NC],
            of: [[zero; NC]; NC],
            sizes: [zero; NC],
            small: zero,
            kept: [true; NC],
        }
    }

    /// Marks the combinations that vanish at the singular pose: those up to `together` times the smallest.
    pub(super) fn part(&mut self, together: S) {
        let small = if together > S::lit(1.0) { SMALL.of::<S>() * largest(&self.sizes) } else { S::ZERO };
        self.small = (together * self.least()).max(small);
    }

    /// Have they vanished?
    pub(super) fn has_vanished(&self) -> bool {
        let vanished = S::lit(vanished()).max(REPEATED.of::<S>() * S::EPSILON) * largest(&self.sizes);
        self.of_vanishing().all(|(size, _)| size <= vanished)
    }

    /// The combinations that do not: their sizes, of which residuals they are, and their rows.
    pub(super) fn regular(&self) -> impl Iterator<Item = (S, (&[S; NC], &[S; NQ]))> {
        let combinations = self.of.iter().zip(&self.rows);
        let all = self.sizes.iter().zip(&self.kept).zip(combinations);
        let regular = all.filter(|((size, kept), _)| **kept && **size > self.small);
        regular.map(|((size, _), combination)| (*size, combination))
    }

    /// The combinations that vanish there: of which residuals, and the rest of their rows.
    pub(super) fn vanishing(&self) -> impl Iterator<Item = (&[S; NC], &[S; NQ])> {
        self.of_vanishing().map(|(_, combination)| combination)
    }

    /// The combinations that vanish there, with their sizes.
    fn of_vanishing(&self) -> impl Iterator<Item = (S, (&[S; NC], &[S; NQ]))> {
        let combinations = self.of.iter().zip(&self.rows);
        let all = self.sizes.iter().zip(&self.kept).zip(combinations);
        let vanishing = all.filter(|((size, kept), _)| **kept && **size <= self.small);
        vanishing.map(|((size, _), combination)| (*size, combination))
    }

    /// Do rows repeat others? The pose is not to be singular.
    pub(super) fn repeats(&self) -> bool {
        self.least() < REPEATED.of::<S>() * S::EPSILON * largest(&self.sizes)
    }

    /// The size of the smallest combination.
    pub(super) fn least(&self) -> S {
        let kept = self.sizes.iter().zip(&self.kept).filter(|(_, kept)| **kept);
        kept.fold(S::INFINITY, |least, (size, _)| least.min(*size))
    }

    /// Takes away of a direction what the regular combinations do not allow.
    #[inline(never)]
    pub(super) fn leave(&self, along: &mut [S; NQ]) {
        for (size, (_, row)) in self.regular() {
            let factor = -dot(row, along) / (size * size);
            add(along, factor, row);
        }
    }
}
