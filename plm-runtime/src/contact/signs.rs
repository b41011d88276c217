//! Signs of the reactions along lines that bound frictions: each |R| is replaced by R or by -R, and R must have that sign.

use super::candidates::MARGINAL;
use super::loads::Load;
use super::modes::Mode;
use super::multipliers::{Multipliers, multipliers};
use super::rows::{Rows, indices};
use crate::scalar::Real;

/// Most changes of single signs, for each reaction along a line.
const MOST_TURNS: usize = 2;
/// Most reactions along lines for which all combinations of signs are tried.
const MOST_SIGNS: usize = 10;

/// Multipliers of a combination. If the reactions then have other signs than the assumed ones, `turned` becomes the rows with these: in
/// the caller's place, since rows are large and a returned value is copied.
pub(super) fn signed<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    modes: &[Mode; N],
    turned: &mut Option<Rows<S, N>>,
) -> Option<Multipliers<S, N>> {
    for _ in 0..=MOST_TURNS * lines(rows) {
        let present = turned.as_ref().unwrap_or(rows);
        let found = multipliers(present, modes)?;
        let Some(load) = wrong_sign(present, &found) else { return Some(found) };
        if let Some(Load::Line { negative }) = turned.get_or_insert_with(|| *rows).load.get_mut(load) {
            *negative = !*negative;
        }
    }
    by_all_signs(rows, modes, turned.get_or_insert_with(|| *rows))
}

/// Number of reactions along lines.
fn lines<S, const N: usize>(rows: &Rows<S, N>) -> usize {
    rows.load.iter().filter(|load| matches!(load, Load::Line { .. })).count()
}

/// First reaction along a line whose sign is not the assumed one.
fn wrong_sign<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    Multipliers { lambda, .. }: &Multipliers<S, N>,
) -> Option<usize> {
    indices::<N>().find(|load| {
        let none = S::lit(MARGINAL) * rows.terms(*load, lambda);
        matches!(rows.load[*load], Load::Line { .. }) && rows.size(*load, lambda) < -none
    })
}

/// Multipliers as by [`signed`], from all combinations of signs, if changes of single signs do not end. `None` if no combination is
/// consistent, so that these modes have no forces. Of more than [`MOST_SIGNS`] reactions only the first ones get both signs.
fn by_all_signs<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    modes: &[Mode; N],
    turned: &mut Rows<S, N>,
) -> Option<Multipliers<S, N>> {
    (0..1_u32 << lines(rows).min(MOST_SIGNS)).find_map(|number| {
        let mut left = number;
        turned.load = rows.load;
        for load in &mut turned.load {
            if let Load::Line { negative } = load {
                (*negative, left) = (left % 2 == 1, left / 2);
            }
        }
        let found = multipliers(turned, modes)?;
        wrong_sign(turned, &found).is_none().then_some(found)
    })
}

#[cfg(test)]
mod tests {
    use super::super::random::{bits, filled, number, with_room};
    use super::super::rows::{Friction, Limit};
    use super::*;

    /// Two frictions that slip, each bounded by all three reactions; a third place is for the third reaction alone.
    fn random(state: &mut u64) -> Rows<f64, 3> {
        let mut rows = Rows::none();
        for load in 0..3 {
            let by = [2.0 * number(state), 2.0 * number(state), 0.0];
            rows.reaction[load][0] = super::super::Affine { own: number(state), by };
            rows.load[load] = Load::Line { negative: false };
        }
        for row in 0..2 {
            rows.read[row] = [true; 3];
            let share = core::array::from_fn(|_| number(state).abs());
            rows.kinetic[row] = Friction::both(Limit { share, ..Limit::none() });
            rows.adhesion[row] = rows.kinetic[row];
        }
        rows
    }

    /// Compares with lambda_i = -sum of s_k |R_k(lambda)| for each combination of signs: is one of them consistent?
    #[test]
    fn signs_are_found_where_there_are_some() {
        let (mut state, mut counts) = (7, [0; 2]);
        let modes = [Mode::Forwards, Mode::Forwards, Mode::Off];
        for _ in 0..3000 {
            let rows = random(&mut state);
            let any = (0..8).any(|number: u32| {
                let mut turned = rows;
                turned.load = core::array::from_fn(|load| Load::Line { negative: number >> load & 1 == 1 });
                multipliers(&turned, &modes).is_some_and(|found| wrong_sign(&turned, &found).is_none())
            });
            let mut turned = None;
            let found = signed(&rows, &modes, &mut turned);
            assert_eq!(found.is_some(), any);
            counts[usize::from(any)] += 1;
            let Some(found) = found else { continue };
            let sizes: [f64; 3] = core::array::from_fn(|load| rows.reaction_at(load, &found.lambda)[0].abs());
            let limit = |row: usize| -> f64 {
                rows.kinetic[row].lower.share.iter().zip(sizes).map(|(s, r)| s * r).sum()
            };
            let largest = sizes.iter().fold(1.0, |most: f64, size| most.max(*size));
            assert!((0..2).all(|row| (found.lambda[row] + limit(row)).abs() < 1e-6 * largest), "{turned:?}");
        }
        assert!(counts.iter().all(|count| *count > 100), "{counts:?}");
    }

    /// The number of changes of signs does not depend on the size of arrays.
    #[test]
    fn room_for_more_rows_changes_no_bit() {
        let (mut state, modes) = (9, [Mode::Forwards, Mode::Forwards, Mode::Off]);
        for _ in 0..3000 {
            let rows = random(&mut state);
            let wide: Rows<f64, 6> = with_room(&rows);
            let found = signed(&rows, &modes, &mut None).map(|found| found.lambda);
            let other = signed(&wide, &filled(&modes, Mode::Off), &mut None).map(|found| found.lambda);
            assert_eq!(found.is_some(), other.is_some());
            let Some((found, other)) = found.zip(other) else { continue };
            assert!(bits(&found, 3).eq(bits(&other, 3)), "{found:?} {other:?}");
        }
    }
}
