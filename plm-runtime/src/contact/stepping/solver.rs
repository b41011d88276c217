//! Solver of the contact problem of a time step: forces complementary to accelerations, by a bounded number of rounds.
//!
//! A round solves the linear system of the rows that are active in given modes, and checks every row: its force less its acceleration,
//! `lambda D_ii - a_i`, determines its mode in the next round. This is a semismooth Newton method on the natural map of the problem
//! (M. Hintermüller, K. Ito, K. Kunisch, The primal-dual active set strategy as a semismooth Newton method, SIAM Journal on Optimization
//! 13, 2002). From the modes of the last step it mostly takes one round. If rounds do not converge, sweeps of projected Gauss-Seidel
//! (V. Acary, B. Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 2008, section 13.7) give modes and forces.

use crate::contact::candidates::is_off;
use crate::contact::loads::Load;
use crate::contact::modes::Mode;
use crate::contact::multipliers::equation;
use crate::contact::rows::{Law, Limit, Rows, below, indices};
use crate::scalar::Real;
use crate::vector::Vector;

/// Number of rounds in which every row may change its mode, and of rounds after these in which one row alone may: by the rows that exist,
/// since arrays may have room for more.
#[inline]
fn rounds<const N: usize>(rules: &[Rule; N]) -> [u32; 2] {
    let rows = rules.iter().filter(|rule| !matches!(rule, Rule::Absent(_))).count() as u32;
    [2 * rows + 2, 2 * rows]
}

/// Sweeps after these rounds.
const SWEEPS: u32 = 32;
/// Error of a law, in roundings of the terms of the acceleration, below which it is satisfied.
pub(in crate::contact) const ROUNDING: f64 = 64.0;
/// Pivot below which a row depends on others, relative to a diagonal of one.
pub(in crate::contact) const DEPENDENT: f64 = 1e-9;

/// Relative error of a row that others carry: its rate follows from theirs to the accuracy of its dependence.
pub(in crate::contact) const CARRIED: f64 = 1e-6;

/// The law of a row in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rule {
    /// The row does not exist, or is out of reach.
    Absent(Mode),
    /// A gap and its contact force.
    Gap,
    /// A friction.
    Friction,
    /// A constraint, with a force of either sign.
    Constraint,
}

impl Rule {
    /// Rule of a row.
    pub(super) fn of<S>(law: &Law<S>, exists: bool) -> Self {
        match (law, exists) {
            (Law::Unilateral { .. }, true) => Self::Gap,
            (Law::Friction, true) => Self::Friction,
            (Law::Constraint, true) => Self::Constraint,
            (Law::Friction, false) => Self::Absent(Mode::Off),
            (_, false) => Self::Absent(Mode::Open),
        }
    }
}

/// Forces and accelerations of all rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solved<S, const N: usize> {
    pub(super) rules: [Rule; N],
    pub(super) modes: [Mode; N],
    /// True for rows that others carry.
    pub(super) carried: [bool; N],
    /// By reaction that bounds frictions: true if it is negative.
    pub(super) negative: [bool; N],
    pub(super) lambda: [S; N],
    pub(super) acceleration: [S; N],
    /// Largest acceleration by which a law is violated.
    pub(super) residual: S,
    pub(super) rounds: u32,
}

/// Result of a round.
struct Seen<S, const N: usize> {
    solved: Solved<S, N>,
    next: [Mode; N],
    /// True if every law is satisfied.
    is_met: bool,
}

/// Forces and accelerations, from a guess of the modes.
pub(super) fn solve<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    rules: &[Rule; N],
    guess: [Mode; N],
) -> Solved<S, N> {
    let (mut modes, mut lambda) = (without_force(rows, rules, guess), [S::ZERO; N]);
    if modes.iter().all(|mode| !(mode.holds() || mode.slips())) {
        // A gap whose free acceleration closes it would not have the mode open.
        let (carried, negative) = ([false; N], [false; N]);
        let (acceleration, residual, rounds) = (rows.free, S::ZERO, 0);
        return Solved { rules: *rules, modes, carried, negative, lambda, acceleration, residual, rounds };
    }
    let mut best: Option<Solved<S, N>> = None;
    let [all, single] = rounds(rules);
    for round in 1..=all + single {
        let Seen { solved, next, is_met } = self::round(rows, rules, (modes, round), &lambda);
        if is_met {
            return solved;
        }
        lambda = solved.lambda;
        let is_better = best.as_ref().is_none_or(|best| solved.residual < best.residual);
        if is_better {
            best = Some(solved);
        }
        if round < all {
            modes = without_force(rows, rules, next);
        } else if let Some(row) = indices::<N>().find(|row| next[*row] != modes[*row]).map(below::<N>) {
            modes[row] = next[row];
            modes = without_force(rows, rules, modes);
        } else if rows.load.iter().all(|load| *load == Load::Nothing) {
            break;
        }
    }
    swept(rows, rules, best, &lambda)
}

/// Sweeps, and a round with the modes that they lead to; returns the best of all results.
#[cold]
#[inline(never)]
fn swept<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    rules: &[Rule; N],
    best: Option<Solved<S, N>>,
    from: &[S; N],
) -> Solved<S, N> {
    let modes = best.as_ref().map_or([Mode::Open; N], |best| best.modes);
    let mut lambda = *from;
    for _ in 0..SWEEPS {
        for i in 0..N {
            let own = rows.delassus[i][i];
            // False for NaN.
            let has_direction = own > S::ZERO;
            if matches!(rules[i], Rule::Absent(_)) || !has_direction {
                lambda[i] = S::ZERO;
                continue;
            }
            let force = lambda[i] - rows.acceleration(i, &lambda) / own;
            lambda[i] = S::ZERO;
            lambda[i] = match rules[i] {
                Rule::Gap => force.max(S::ZERO),
                Rule::Friction => {
                    let [lower, upper] = limits(rows, (modes[i], i), &lambda);
                    force.max(-lower).min(upper)
                }
                _ => force,
            };
        }
    }
    let [all, single] = rounds(rules);
    let round = all + single + 1;
    let by_sweeps = look(rows, rules, (modes, round), lambda, &[false; N]);
    let next = without_force(rows, rules, by_sweeps.next);
    let by_modes = self::round(rows, rules, (next, round), &lambda);
    let mut least = Solved { modes: next, ..by_sweeps.solved };
    for other in [Some(by_modes.solved), best].into_iter().flatten() {
        if other.residual < least.residual {
            least = Solved { rounds: round, ..other };
        }
    }
    least
}

/// Solves the system of the active rows in these modes, and checks every row.
fn round<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    rules: &[Rule; N],
    (modes, number): ([Mode; N], u32),
    last: &[S; N],
) -> Seen<S, N> {
    let directions = core::array::from_fn(|load| direction(rows, load, last));
    let (lambda, dropped) = eliminate(rows, &modes, &directions);
    let mut seen = look(rows, rules, (modes, number), lambda, &dropped);
    for i in 0..N {
        if dropped[i] {
            // The row is at rest, and has no force of its own.
            seen.solved.modes[i] = if rules[i] == Rule::Gap { Mode::Open } else { Mode::Off };
        }
    }
    seen
}

/// Checks every row.
fn look<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    rules: &[Rule; N],
    (modes, rounds): ([Mode; N], u32),
    lambda: [S; N],
    dropped: &[bool; N],
) -> Seen<S, N> {
    let acceleration: [S; N] = Vector::from_fn(|i| rows.acceleration(i, &lambda));
    let (mut next, mut is_met, mut residual) = (modes, true, S::ZERO);
    let negative = core::array::from_fn(|load| is_negative(rows, load, &lambda));
    for i in 0..N {
        let own = rows.delassus[i][i];
        let (force, rest) = (lambda[i] * own, acceleration[i]);
        let wanted = force - rest;
        let within = match rules[i] {
            Rule::Absent(_) => continue,
            Rule::Constraint => wanted,
            Rule::Gap => {
                next[i] = if wanted > S::ZERO { Mode::Closed } else { Mode::Open };
                wanted.max(S::ZERO)
            }
            Rule::Friction => {
                let [lower, upper] = limits(rows, (modes[i], i), &lambda).map(|limit| limit * own);
                next[i] = match modes[i] {
                    _ if wanted > upper => Mode::Backwards,
                    _ if wanted < -lower => Mode::Forwards,
                    _ => Mode::Sticks,
                };
                wanted.max(-lower).min(upper)
            }
        };
        let off = (force - within).abs();
        // False for NaN.
        let none = if dropped[i] { S::lit(CARRIED) } else { S::lit(ROUNDING) * S::EPSILON };
        let is_rounding = off <= none * size(rows, i, &lambda);
        is_met &= is_rounding;
        residual = residual.max(if is_rounding || off > S::ZERO { off } else { S::INFINITY });
    }
    let solved =
        Solved { rules: *rules, modes, carried: *dropped, negative, lambda, acceleration, residual, rounds };
    Seen { solved, next, is_met }
}

/// Size of the terms of an acceleration.
fn size<S: Real, const N: usize>(rows: &Rows<S, N>, i: usize, lambda: &[S; N]) -> S {
    let i = below::<N>(i);
    let terms = rows.delassus[i].iter().zip(lambda);
    terms.fold(rows.free[i].abs(), |sum, (d, lambda)| (*d * *lambda).abs() + sum)
}

/// Sets frictions to off that cannot have a force in these modes, and the others to another mode.
fn without_force<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    rules: &[Rule; N],
    mut modes: [Mode; N],
) -> [Mode; N] {
    for i in 0..N {
        if rules[i] == Rule::Friction {
            let off = is_off(rows, &modes, i);
            modes[i] = match modes[i] {
                _ if off => Mode::Off,
                Mode::Off => Mode::Sticks,
                mode => mode,
            };
        }
    }
    modes
}

/// Unit vector e with |R| = e . R of a reaction that bounds frictions.
fn direction<S: Real, const N: usize>(rows: &Rows<S, N>, load: usize, lambda: &[S; N]) -> [S; 2] {
    match rows.load[below::<N>(load)] {
        Load::Nothing => [S::ZERO; 2],
        Load::Plane => rows.direction(load, lambda),
        Load::Line { .. } | Load::Turned { .. } => {
            [S::lit(if is_negative(rows, load, lambda) { -1.0 } else { 1.0 }), S::ZERO]
        }
    }
}

/// True if a reaction is negative along its line, or in its first component.
fn is_negative<S: Real, const N: usize>(rows: &Rows<S, N>, load: usize, lambda: &[S; N]) -> bool {
    let load = below::<N>(load);
    rows.load[load] != Load::Nothing && rows.reaction[load][0].at(lambda) < S::ZERO
}

/// Size |R| of a reaction that bounds frictions.
fn size_of_reaction<S: Real, const N: usize>(rows: &Rows<S, N>, load: usize, lambda: &[S; N]) -> S {
    let ([x, y], [along, across]) = (rows.reaction_at(load, lambda), direction(rows, load, lambda));
    x * along + y * across
}

/// Largest forces of a friction backwards and forwards: static on the sides to which it does not slip.
fn limits<S: Real, const N: usize>(rows: &Rows<S, N>, (mode, i): (Mode, usize), lambda: &[S; N]) -> [S; 2] {
    let i = below::<N>(i);
    let (kinetic, adhesion) = (&rows.kinetic[i], &rows.adhesion[i]);
    let lower = if mode == Mode::Forwards { &kinetic.lower } else { &adhesion.lower };
    let upper = if mode == Mode::Backwards { &kinetic.upper } else { &adhesion.upper };
    let limit = |limit: &Limit<S, N>| {
        let add = |sum, load: usize| {
            limit.share[below::<N>(load)].mul_add(size_of_reaction(rows, load, lambda), sum)
        };
        rows.loads_of(i).fold(limit.at(lambda), add).max(S::ZERO)
    };
    [limit(lower), limit(upper)]
}

/// Gaussian elimination of the active rows, in their order, without those that depend on others; returns the forces, and marks these
/// rows.
pub(super) fn eliminate<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    modes: &[Mode; N],
    directions: &[[S; 2]; N],
) -> ([S; N], [bool; N]) {
    let (mut matrix, mut right, mut inverse) = ([[S::ZERO; N]; N], [S::ZERO; N], [S::ZERO; N]);
    let active: [bool; N] = core::array::from_fn(|i| modes[i].holds() || modes[i].slips());
    for i in 0..N {
        if active[i] {
            (matrix[i], right[i]) = equation(rows, (modes[i], directions), i);
        }
    }
    let least = S::lit(DEPENDENT).max(S::lit(ROUNDING) * S::EPSILON);
    let mut used = active;
    for k in 0..N {
        // False for NaN, as for a row without direction.
        used[k] &= matrix[k][k].abs() > least;
        if !used[k] {
            continue;
        }
        inverse[k] = S::lit(1.0) / matrix[k][k];
        for i in k + 1..N {
            if !active[i] {
                continue;
            }
            let factor = matrix[i][k] * inverse[k];
            for j in k + 1..N {
                matrix[i][j] = matrix[i][j] - factor * matrix[k][j];
            }
            right[i] = right[i] - factor * right[k];
        }
    }
    let mut lambda = [S::ZERO; N];
    for k in (0..N).rev() {
        if used[k] {
            let terms = (k + 1..N).map(|j| matrix[k][j] * lambda[j]);
            lambda[k] = inverse[k] * terms.fold(right[k], |rest, term| rest - term);
        }
    }
    (lambda, core::array::from_fn(|i| active[i] && !used[i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::random::{bits, contacts, filled, number, with_room};

    /// The number of rounds for dependent rows is bounded, and does not depend on the size of arrays.
    #[test]
    fn room_for_more_rows_changes_no_bit() {
        let (mut state, mut repeated) = (114, 0);
        for _ in 0..4000 {
            let rows = contacts::<2>(&mut state, 0.8);
            let rules: [Rule; 6] = core::array::from_fn(|i| match (number(&mut state) < -0.8, i % 2) {
                (true, 0) => Rule::Absent(Mode::Open),
                (true, _) => Rule::Absent(Mode::Off),
                (false, 0) => Rule::Gap,
                (false, _) => Rule::Friction,
            });
            let guess = rules.map(|rule| match rule {
                Rule::Absent(mode) => mode,
                Rule::Gap | Rule::Constraint => Mode::Closed,
                Rule::Friction => Mode::Sticks,
            });
            let wide: Rows<f64, 9> = with_room(&rows);
            let wide_rules: [Rule; 9] = filled(&rules, Rule::Absent(Mode::Off));
            let solved = solve(&rows, &rules, guess);
            let other = solve(&wide, &wide_rules, filled(&guess, Mode::Off));
            assert_eq!((solved.rounds, &solved.modes[..]), (other.rounds, &other.modes[..6]));
            assert!(bits(&solved.lambda, 6).eq(bits(&other.lambda, 6)), "{solved:?} {other:?}");
            assert_eq!(solved.residual.to_bits(), other.residual.to_bits());
            repeated += u32::from(solved.rounds > 12);
        }
        assert!(repeated > 20, "{repeated}");
    }
}
