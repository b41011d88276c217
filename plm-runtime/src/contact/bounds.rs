//! Bounds of frictions that are negative.

use super::rows::Rows;
use super::{Contacts, Limit};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};

/// A bound is rounding below this fraction of the force that would hold the row.
const ROUNDING: f64 = 1e-9;

/// Looks at the bounds that no force of contact decides: each must not be negative.
///
/// # Errors
/// [`Cause::NotAllowed`] with the row and its bound.
pub(super) fn look_at_bounds<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    rows: &Rows<M::S, N>,
) -> Result<(), Fault> {
    for row in (0..N).filter(|row| system.exists(u, *row) && !system.law(*row).is_unilateral()) {
        if let Some(found) = negative(rows, row) {
            let cause = Cause::NotAllowed {
                what: "bound of friction",
                wanted: "finite and not negative",
                found: found.to_f64(),
                unit: "N or N m",
            };
            return Err(Fault::of_part(t.to_f64(), system.contact_name(row), cause));
        }
    }
    Ok(())
}

/// A limit of the row that no force of contact decides, and that is negative by more than rounding.
fn negative<S: Real, const N: usize>(rows: &Rows<S, N>, row: usize) -> Option<S> {
    let is_known = |limit: &&Limit<S, N>| limit.share == S::ZERO && limit.by.iter().all(|by| *by == S::ZERO);
    let bounds = [&rows.kinetic[row], &rows.adhesion[row]];
    let limits = bounds.into_iter().flat_map(|bound| [&bound.lower, &bound.upper]);
    // Large, infinite, or not a number where the row has no direction: D is zero there, or rounding of either sign.
    let none = (S::lit(ROUNDING) * rows.free[row] / rows.delassus[row][row]).abs();
    limits.filter(is_known).map(|limit| limit.own).find(|own| *own < -none)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slider in its dead centre: D is what rounding has left of zero.
    #[test]
    fn a_row_without_direction_has_no_negative_bound() {
        for own in [1e-17, 0.0, -1e-17] {
            let mut rows = Rows::<f64, 1>::none();
            (rows.free[0], rows.delassus[0][0]) = (5.0, own);
            rows.set_friction(0, Limit::own(0.9));
            assert_eq!(negative(&rows, 0), None, "{own}");
        }
        let mut rows = Rows::<f64, 1>::none();
        (rows.free[0], rows.delassus[0][0]) = (5.0, 2.0);
        rows.set_friction(0, Limit::own(-0.1));
        assert_eq!(negative(&rows, 0), Some(-0.1));
    }
}
