//! Tolerances for closed joints, and for lengths that repeat each other and disagree.

use crate::scalar::Real;

super::tolerances! {
    /// Units in the last place of numbers of twice the precision, of the mechanism's size. A pose is closed up to it: 1e-28 of the size,
    /// less than the twelfth digit of the rounding of lengths.
    CLOSED_EXACTLY: f64 = 1e4;
    /// A part of the mechanism's length. Lengths that repeat each other may leave gaps up to it:
    /// [`Scalar::AGREEMENT`](crate::Scalar::AGREEMENT) of `f64`.
    DISAGREEMENT: f64 = 1e-9;
    /// A ratio of singular values. Rows with a combination below it depend on each other while the mechanism moves: stages are off the
    /// constraints by the square of a step, and dividing that by less would throw the mechanism onto another branch.
    DEPENDENT: f64 = 1e-4;
    /// Units in the last place of the size. A gap of lengths that disagree is larger, ...
    OPEN_BY_ROUNDING: f64 = 64.0;
    /// ... and smaller than this part of the length: a larger gap does not come from lengths that repeat each other.
    REPEATS: f64 = 1e-5;
    /// A part of the mechanism's size (and speed). Joints count as closed up to it, ...
    CLOSED: f64 = 1e-10;
    /// ... or up to so many units in the last place for numbers with fewer digits: the rounding of a residual, which is a sum of about
    /// eight products.
    CLOSED_ROUNDED: f64 = 16.0;
}

/// The fraction of the size up to which joints count as closed.
#[inline]
pub(crate) fn closed<S: Real>() -> S {
    CLOSED.of::<S>().max(CLOSED_ROUNDED.of::<S>() * S::EPSILON)
}

/// The ratio of singular values below which rows depend on each other while the mechanism moves.
#[inline]
pub(crate) fn dependent<S: Real>() -> S {
    DEPENDENT.of::<S>().max(S::RANK_TOLERANCE)
}
