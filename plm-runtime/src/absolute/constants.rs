//! The tolerances of a step by itself in absolute coordinates, for who writes that step in another language.

use super::project::ITERATIONS;
use super::redundancy::fractions;
use crate::scalar::Real;
use crate::tolerances::{
    DESCENTS, LOOKS, LOW, MOST_LOOKS, REFERENCE_POSES, closed, compared_apart, ill_conditioned, long_step,
};

/// Tolerances of projection and of singular poses in a scalar type.
#[derive(Clone, Copy, Debug)]
pub struct Constants<S> {
    /// Residual of joints that count as closed, as a fraction of the size.
    pub closed: S,
    /// Most corrections of a projection.
    pub iterations: u32,
    /// Pivot ratio below which a step is compared with other poses.
    pub low: S,
    /// Length of a step, rad, above which it is.
    pub long_step: S,
    /// Pivot ratio beside that of other poses below which a pose is nearly singular.
    pub ill_conditioned: S,
    /// Distance of the poses along a step, rad, and the bounds of their number.
    pub apart: S,
    /// Least and largest number of these poses.
    pub looks: [usize; 2],
    /// Parabolas that follow a low pivot.
    pub descents: usize,
}

impl<S: Real> Constants<S> {
    /// Those of the type.
    pub fn new() -> Self {
        Self {
            closed: closed(),
            iterations: ITERATIONS,
            low: LOW.of(),
            long_step: S::lit(long_step()),
            ill_conditioned: S::lit(ill_conditioned()),
            apart: S::lit(compared_apart()),
            looks: [LOOKS, MOST_LOOKS],
            descents: DESCENTS,
        }
    }

    /// Distances of the poses that a step is compared with, over the fractions of [`fractions`](Self::fractions), for a mechanism of a
    /// length, m.
    pub fn reaches(length: S) -> [S; 4] {
        let reach = S::lit(0.2) * length.min(S::lit(1.0));
        REFERENCE_POSES.all().map(|turns| S::lit(turns) * reach)
    }

    /// Fractions of these distances by which the coordinates of such a pose are apart, one after the other.
    pub fn fractions() -> impl Iterator<Item = f64> {
        fractions()
    }
}

impl<S: Real> Default for Constants<S> {
    fn default() -> Self {
        Self::new()
    }
}
