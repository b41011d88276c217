//! One real number.

use plm_math::exact::Split;

use super::{Operation, Scalar};

/// One real number: `f32` or `f64`, two of them in one ([`DoubleDouble`](crate::DoubleDouble)), or one with its derivatives
/// ([`Dual`](crate::Dual)).
pub trait Real: Scalar<Mask = bool, Turns = i32> + PartialOrd + Split {
    /// Such numbers without derivatives.
    type Plain: Real<Plain = Self::Plain>;

    /// The number without its derivatives. What only decides how a run goes on, as the length of a step, is computed so.
    fn plain(self) -> Self::Plain;
    /// A number whose derivatives are zero.
    fn of_plain(plain: Self::Plain) -> Self;
    /// This number's derivatives with another value.
    #[must_use]
    fn with_plain(self, plain: Self::Plain) -> Self;
    /// Makes an operation. Numbers that are recorded take the derivatives of all of it at once, where these are few.
    #[allow(clippy::inline_always, reason = "it is the operation")]
    #[inline(always)]
    fn make<O: Operation<Self>>(operation: O) -> O::Output {
        operation.make()
    }

    /// Distance from 1 to the next larger number; of [`DoubleDouble`](crate::DoubleDouble) the unit of its errors.
    const EPSILON: Self;
    /// Singular values below this fraction of the largest count as zero: the square root of [`EPSILON`](Self::EPSILON).
    ///
    /// To keep a direction with the relative singular value s amplifies rounding to eps / s; to drop it leaves an
    /// error of order s. The two are equal at s = sqrt(eps).
    const RANK_TOLERANCE: Self;
    /// Precision of two such numbers in one ([`DoubleDouble`](crate::DoubleDouble)): the square of [`EPSILON`](Self::EPSILON).
    const DOUBLE_DOUBLE_EPSILON: Self;
    /// Larger than every finite number.
    const INFINITY: Self;
    /// Can sine and cosine of these angles be computed without a branch, by [`Scalar::sin_cos_by`]? False if it is not sure.
    #[inline]
    fn are_direct<const N: usize>(angles: [Self; N]) -> bool {
        let _ = angles;
        true
    }
}
