//! Search through combinations of modes: a start by pivots, then other modes for the rows whose inequalities are violated.

use super::candidates::{Allowed, Found, Margins, Solution, is_off, solve};
use super::margins::stick;
use super::modes::Mode;
use super::pivots::pivoted;
use super::rows::Rows;
use crate::scalar::Real;

/// Most combinations, for each row that may have several modes.
const MOST_STEPS: usize = 3;

/// Most starts by pivots.
const MOST_ATTEMPTS: u32 = 5;

/// A combination that violates no inequality, from one of several starts.
#[inline(never)]
pub(super) fn walk<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    allowed: &[Allowed; N],
    mut broken: impl FnMut(&Solution<S, N>, &Margins<S, N>) -> [bool; N],
) -> Found<S, N> {
    let found = (0..MOST_ATTEMPTS).find_map(|attempt| walked(rows, allowed, (attempt, &mut broken)));
    found.map_or(Found::TooMany, |solution| Found::Modes(solution, false))
}

/// A combination that violates no inequality, from the start of this `attempt`.
fn walked<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    allowed: &[Allowed; N],
    (attempt, broken): (u32, &mut impl FnMut(&Solution<S, N>, &Margins<S, N>) -> [bool; N]),
) -> Option<Solution<S, N>> {
    let modes = pivoted(rows, allowed, attempt)?;
    let mut next = solve(rows, allowed, settled(rows, allowed, modes));
    let free = allowed.iter().filter(|row| !matches!(row, Allowed::Only(_))).count();
    for _ in 0..MOST_STEPS * free {
        let (solution, margins) = next?;
        let broken = broken(&solution, &margins);
        let Some(first) = broken.iter().position(|is_broken| *is_broken) else {
            return Some(solution);
        };
        // All rows at once; if rows depend on each other then, the first alone.
        next = solve(rows, allowed, changed(rows, allowed, &solution, &broken)).or_else(|| {
            let one = core::array::from_fn(|i| i == first);
            solve(rows, allowed, changed(rows, allowed, &solution, &one))
        });
    }
    None
}

/// The modes with others for the marked rows.
fn changed<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    allowed: &[Allowed; N],
    solution: &Solution<S, N>,
    marked: &[bool; N],
) -> [Mode; N] {
    let modes = core::array::from_fn(|i| match (solution.modes[i], allowed[i]) {
        (mode, Allowed::Only(_)) => mode,
        (mode, _) if !marked[i] => mode,
        (Mode::Closed, _) => Mode::Open,
        (Mode::Open, _) => Mode::Closed,
        (Mode::Sticks, _) => {
            let [lower, upper] = stick(rows, i, &solution.lambda);
            if lower < upper { Mode::Forwards } else { Mode::Backwards }
        }
        (Mode::Off | Mode::Forwards | Mode::Backwards, _) => Mode::Sticks,
    });
    settled(rows, allowed, modes)
}

/// Sets frictions without normal force to off, and those that have got one to sticking.
fn settled<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    allowed: &[Allowed; N],
    modes: [Mode; N],
) -> [Mode; N] {
    core::array::from_fn(|i| match (allowed[i], modes[i]) {
        (Allowed::Touching | Allowed::Only(Mode::Open | Mode::Closed), mode) => mode,
        _ if is_off(rows, &modes, i) => Mode::Off,
        (Allowed::Resting, Mode::Off) => Mode::Sticks,
        (Allowed::Only(mode), _) | (Allowed::Resting, mode) => mode,
    })
}

#[cfg(test)]
mod tests {
    use super::super::candidates::{Found, enumerate};
    use super::super::random::{bits, contacts, filled, number, with_room};
    use super::super::rows::Rows;
    use super::*;

    /// Three contacts with friction, and the modes that they may have.
    fn random<const M: usize>(state: &mut u64, friction: f64) -> (Rows<f64, 6>, [Allowed; 6]) {
        let rows = contacts::<M>(state, friction);
        let allowed = core::array::from_fn(|i| match (i % 2, i) {
            (0, _) => Allowed::Touching,
            (_, 5) if number(state) > 0.0 => Allowed::Only(Mode::Forwards),
            _ => Allowed::Resting,
        });
        (rows, allowed)
    }

    /// Counts: solved by both; of these, with another motion although it is unique; solved by enumeration alone; other cases.
    fn compare<const M: usize>(friction: f64) -> [usize; 4] {
        let (mut state, mut counts) = (33, [0; 4]);
        for _ in 0..1500 {
            let (rows, allowed) = random::<M>(&mut state, friction);
            let all = enumerate(&rows, &allowed, |_, margins| margins.broken());
            let one = walk(&rows, &allowed, |_, margins| margins.broken());
            match (all, one) {
                (Found::Modes(best, is_ambiguous), Found::Modes(found, _)) => {
                    counts[0] += 1;
                    let apart = |i: usize| (best.acceleration[i] - found.acceleration[i]).abs();
                    let is_same = (0..6).all(|i| apart(i) < 1e-7 * (1.0 + best.acceleration[i].abs()));
                    counts[1] += usize::from(!is_same && !is_ambiguous);
                }
                (Found::Modes(..), _) => counts[2] += 1,
                _ => counts[3] += 1,
            }
        }
        counts
    }

    #[test]
    fn pivots_find_what_enumeration_finds() {
        for friction in [0.0, 0.3, 0.8] {
            let counts = [compare::<6>(friction), compare::<4>(friction), compare::<3>(friction)];
            for [found, other, missed, _] in counts {
                assert!(found > 1000 && other == 0 && missed * 100 <= found, "{friction}: {counts:?}");
            }
        }
    }

    /// The end of a search does not depend on the size of arrays.
    #[test]
    fn room_for_more_rows_changes_no_bit() {
        let (mut state, mut counts) = (5, [0; 2]);
        for _ in 0..4000 {
            let (rows, allowed) = random::<3>(&mut state, 0.8);
            let wide: Rows<f64, 9> = with_room(&rows);
            let wide_allowed: [Allowed; 9] = filled(&allowed, Allowed::Only(Mode::Off));
            let found = walked(&rows, &allowed, (0, &mut |_, margins| margins.broken()));
            let other = walked(&wide, &wide_allowed, (0, &mut |_, margins| margins.broken()));
            assert_eq!(found.is_some(), other.is_some());
            counts[usize::from(found.is_some())] += 1;
            if let Some((found, other)) = found.zip(other) {
                assert_eq!(found.modes, other.modes[..6]);
                assert!(bits(&found.lambda, 6).eq(bits(&other.lambda, 6)), "{found:?} {other:?}");
            }
        }
        assert!(counts.iter().all(|count| *count > 50), "{counts:?}");
    }
}
