//! Contact rows at a state: gaps, rates, free accelerations, Delassus operator, limits of friction.

use super::loads::{Affine, Load};
use super::modes::Mode;
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Index of a row or of a reaction, visibly below `N` for the compiler too: an array that it indexes needs no check.
pub(super) fn below<const N: usize>(index: usize) -> usize {
    debug_assert!(index < N, "{index} of {N}");
    index.min(N.saturating_sub(1))
}

/// Indices of all rows, or of all reactions, each [`below`] `N`.
pub(super) fn indices<const N: usize>() -> impl Iterator<Item = usize> {
    (0..N).map(below::<N>)
}

/// Law of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law<S> {
    /// Neither the gap nor the contact force is negative; one of the two is zero.
    Unilateral {
        /// The coefficient of restitution, 0 to 1.
        restitution: S,
    },
    /// A force against a slip, within limits.
    Friction,
    /// A constraint while the row exists: closed, with a force of either sign.
    Constraint,
}

impl<S> Law<S> {
    /// True if the row is a constraint while it exists.
    pub fn is_constraint(&self) -> bool {
        matches!(self, Self::Constraint)
    }

    /// Mode of a row that does not exist, and of a constraint that does; `None` for other rows.
    pub(super) fn fixed(&self, exists: bool) -> Option<Mode> {
        match (self, exists) {
            (Self::Constraint, true) => Some(Mode::Closed),
            (Self::Unilateral { .. } | Self::Constraint, false) => Some(Mode::Open),
            (Self::Friction, false) => Some(Mode::Off),
            _ => None,
        }
    }

    /// True if the row has a gap.
    pub fn is_unilateral(&self) -> bool {
        matches!(self, Self::Unilateral { .. })
    }
}

/// Largest force of friction to one side: `own + by . lambda + sum over k of share_k |R_k|`, R_k being reactions of joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit<T, const N: usize> {
    /// Part that does not depend on contact forces, N or N m. It carries no impulse.
    pub own: T,
    /// Factors of the multipliers: a coefficient of friction at the row of its normal force.
    pub by: [T; N],
    /// Coefficients of friction at the reactions.
    pub share: [T; N],
}

impl<T: Scalar, const N: usize> Limit<T, N> {
    /// Limit zero.
    #[must_use]
    pub fn none() -> Self {
        Self::own(T::ZERO)
    }

    /// A limit that does not depend on other forces.
    #[must_use]
    pub fn own(own: T) -> Self {
        Self { own, by: [T::ZERO; N], share: [T::ZERO; N] }
    }

    /// `coefficient` times the multiplier of the row `normal`.
    #[must_use]
    pub fn of(normal: usize, coefficient: T) -> Self {
        let by = Vector::from_fn(|row| if row == normal { coefficient } else { T::ZERO });
        Self { own: T::ZERO, by, share: [T::ZERO; N] }
    }

    /// The part of the limit that is affine in the multipliers.
    pub(super) fn at(&self, lambda: &[T; N]) -> T {
        self.by.iter().zip(lambda).fold(self.own, |sum, (by, lambda)| by.mul_add(*lambda, sum))
    }

    /// True if the limit can be nonzero without the forces of other rows.
    pub(super) fn is_own(&self) -> bool {
        self.own != T::ZERO || self.share.iter().any(|share| *share != T::ZERO)
    }
}

/// The limits of a friction: its force is between `-lower` and `upper`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction<T, const N: usize> {
    /// Limit of the force against a slip forwards, as a positive number.
    pub lower: Limit<T, N>,
    /// Limit of the force against a slip backwards.
    pub upper: Limit<T, N>,
}

impl<T: Scalar, const N: usize> Friction<T, N> {
    /// Converts the limits to other numbers.
    fn in_numbers<U: Scalar>(&self, number: &impl Fn(&T) -> U) -> Friction<U, N> {
        let limit = |limit: &Limit<T, N>| Limit {
            own: number(&limit.own),
            by: limit.by.each_ref().map(number),
            share: limit.share.each_ref().map(number),
        };
        Friction { lower: limit(&self.lower), upper: limit(&self.upper) }
    }

    /// One limit for both sides.
    #[must_use]
    pub fn both(limit: Limit<T, N>) -> Self {
        Self { lower: limit, upper: limit }
    }
}

/// All rows at a state. Row i has the gap or displacement z_i, its rate w_i v + r_i, and the acceleration c_i + D_ij lambda_j. Reactions
/// that bound frictions have indices of their own; several rows may read one of them.
#[derive(Clone, Copy, Debug)]
pub struct Rows<T, const N: usize> {
    /// Gaps of unilateral rows, displacements of frictions, m or rad; zero for a friction without a given displacement.
    pub gap: [T; N],
    /// Their rates, m/s or rad/s.
    pub rate: [T; N],
    /// Accelerations c without contact forces, m/s^2 or rad/s^2.
    pub free: [T; N],
    /// Accelerations zeta of the rows if no coordinate has an acceleration, m/s^2 or rad/s^2; a part of c.
    pub bias: [T; N],
    /// The Delassus operator D = W M^-1 W^T, 1/kg or 1/(kg m^2).
    pub delassus: [[T; N]; N],
    /// Limits while a row slips; without meaning for unilateral rows.
    pub kinetic: [Friction<T, N>; N],
    /// Limits while it sticks.
    pub adhesion: [Friction<T, N>; N],
    /// Reactions of joints that bound frictions, N or N m: one component along a line, or two.
    pub reaction: [[Affine<T, N>; 2]; N],
    /// The kind of each of these reactions.
    pub load: [Load; N],
    /// By row, the reactions that its limits read.
    pub read: [[bool; N]; N],
}

/// A row at rest is slower than this fraction of the fastest one.
const SLOW: f64 = 1e-3;
/// A diagonal entry of D is rounding of terms that cancel below this fraction of the largest one, for a length of at least 1 m.
const CANCELLED: f64 = 1e-13;

impl<T: Real, const N: usize> Rows<T, N> {
    /// True if the rate w v of a row is zero because its direction w is, as that of a slider in its dead centre, while others slip faster
    /// than `none`. The speed along w, |w v|/sqrt(w M^-1 w^T), is then comparable with theirs, unless D is rounding alone. Contact forces
    /// do not accelerate such a row: it continues to slip to the side of its free acceleration. `length` is that of the mechanism.
    pub(super) fn turns(&self, row: usize, none: T, length: T) -> bool {
        let row = below::<N>(row);
        let own = |i: usize| self.delassus[i][i];
        let speed = |i: usize| self.rate[i].abs() / own(i).sqrt();
        let slips = |i: &usize| self.rate[*i].abs() > none;
        let largest = indices::<N>().filter(slips).fold(T::ZERO, |largest, i| largest.max(own(i)));
        let cancelled = T::lit(CANCELLED) * largest * (length * length).min(T::lit(1.0));
        // A driven row has nothing but rounding there, of either sign.
        let moves = |i: &usize| slips(i) && own(*i) > cancelled;
        let fastest = indices::<N>().filter(moves).fold(T::ZERO, |fastest, i| fastest.max(speed(i)));
        let slides = indices::<N>().any(|i| slips(&i));
        slides && own(row) <= cancelled || fastest > T::ZERO && speed(row) > T::lit(SLOW) * fastest
    }
}

impl<T: Scalar, const N: usize> Rows<T, N> {
    /// Rows without data: no friction.
    #[must_use]
    pub fn none() -> Self {
        let nothing = Friction::both(Limit::none());
        Self {
            gap: [T::ZERO; N],
            rate: [T::ZERO; N],
            free: [T::ZERO; N],
            bias: [T::ZERO; N],
            delassus: [[T::ZERO; N]; N],
            kinetic: [nothing; N],
            adhesion: [nothing; N],
            reaction: [[Affine::zero(); 2]; N],
            load: [Load::Nothing; N],
            read: [[false; N]; N],
        }
    }

    /// Copies rows in other numbers, with limits for frictions alone. It writes in place, since a second copy would wait for the first.
    #[allow(clippy::inline_always, reason = "as above")]
    #[inline(always)]
    pub(super) fn take<U: Scalar>(
        &mut self,
        rows: &Rows<U, N>,
        number: &impl Fn(&U) -> T,
        is_friction: impl Fn(usize) -> bool,
    ) {
        (self.load, self.read) = (rows.load, rows.read);
        for row in indices::<N>() {
            self.gap[row] = number(&rows.gap[row]);
            self.rate[row] = number(&rows.rate[row]);
            self.free[row] = number(&rows.free[row]);
            self.bias[row] = number(&rows.bias[row]);
            for other in indices::<N>() {
                self.delassus[row][other] = number(&rows.delassus[row][other]);
            }
            if is_friction(row) {
                self.kinetic[row] = rows.kinetic[row].in_numbers(number);
                self.adhesion[row] = rows.adhesion[row].in_numbers(number);
            }
            // Reactions are stored at the indices of rows.
            if rows.load[row] != Load::Nothing {
                let affine = |part: &Affine<U, N>| Affine {
                    own: number(&part.own),
                    by: part.by.each_ref().map(number),
                };
                self.reaction[row] = rows.reaction[row].each_ref().map(affine);
            }
        }
    }

    /// Gives the friction `row` one limit for slipping and for sticking.
    pub fn set_friction(&mut self, row: usize, limit: Limit<T, N>) {
        self.set_adhesion(row, limit, limit);
    }

    /// Gives the friction `row` a limit while it slips and another one while it sticks.
    pub fn set_adhesion(&mut self, row: usize, kinetic: Limit<T, N>, adhesion: Limit<T, N>) {
        if let (Some(slips), Some(sticks)) = (self.kinetic.get_mut(row), self.adhesion.get_mut(row)) {
            (*slips, *sticks) = (Friction::both(kinetic), Friction::both(adhesion));
        }
    }

    /// True if D_ii is zero, or rounding of terms that cancel: no contact force changes the rate of the row. `length` is that of the
    /// mechanism, m.
    pub(super) fn is_cancelled(&self, row: usize, length: f64) -> bool {
        let own = |i: usize| self.delassus[i][i].to_f64();
        let largest = indices::<N>().fold(0.0, |largest: f64, i| largest.max(own(i)));
        own(below::<N>(row)) <= CANCELLED * largest * (length * length).min(1.0)
    }

    /// Acceleration of a row with these multipliers.
    pub(in crate::contact) fn acceleration(&self, row: usize, lambda: &[T; N]) -> T {
        let row = below::<N>(row);
        self.delassus[row].iter().zip(lambda).fold(self.free[row], |sum, (d, lambda)| d.mul_add(*lambda, sum))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slider in its dead centre continues to slip beside a crank, and beside a driven row, whose D is rounding of either sign. A row
    /// that comes to rest while it has a direction does not.
    #[test]
    fn a_row_without_direction_turns_beside_one_that_is_driven() {
        for driven in [0.0, 1e-16, -1e-16] {
            let mut rows = Rows::<f64, 3>::none();
            rows.rate = [-2.8, -7e-15, 0.1];
            for (i, own) in [27.0, -0.0, driven].into_iter().enumerate() {
                rows.delassus[i][i] = own;
            }
            assert!(rows.turns(1, 1e-12, 0.4), "{driven:e}");
            rows.delassus[1][1] = 0.3;
            assert!(!rows.turns(1, 1e-12, 0.4), "{driven:e}");
        }
    }
}
