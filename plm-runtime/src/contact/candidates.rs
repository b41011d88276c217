//! Next modes of the rows by enumeration: multipliers and accelerations (or impulses and rates) of every combination, checked against
//! all inequalities (F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, Wiley 1996).

use super::loads::Load;
use super::margins::stick;
use super::modes::Mode;
use super::rows::{Rows, below, indices};
use super::signs::signed;
use super::walk::walk;
use crate::linalg::Lu;
use crate::scalar::Real;
use crate::vector::Vector;

/// Relative size below which an inequality is marginal, and relative difference below which two motions are equal.
pub(super) const MARGINAL: f64 = 1e-9;
/// Error of every acceleration, or rate in an impact, in roundings of the largest one.
const ROUNDING: f64 = 32.0;
/// A row depends on the constraint rows if its own part of D is below this fraction of its diagonal entry.
const DEPENDENT: f64 = 1e-9;
/// Error of the equation of a force, in roundings of its terms.
const ROUNDED: f64 = 4.0;
/// Most combinations that are enumerated; if there are more, they are searched by pivots.
const MOST_CANDIDATES: u32 = 1 << 14;

/// Modes that a row may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Allowed {
    /// This mode only.
    Only(Mode),
    /// A gap without approach: closed or open.
    Touching,
    /// A friction without slip.
    Resting,
}

impl Allowed {
    /// The modes in the order of preference: constraints first.
    fn modes(self) -> &'static [Mode] {
        match self {
            Self::Only(Mode::Open) => &[Mode::Open],
            Self::Only(Mode::Closed) => &[Mode::Closed],
            Self::Only(Mode::Off) => &[Mode::Off],
            Self::Only(Mode::Sticks) => &[Mode::Sticks],
            Self::Only(Mode::Forwards) => &[Mode::Forwards],
            Self::Only(Mode::Backwards) => &[Mode::Backwards],
            Self::Touching => &[Mode::Closed, Mode::Open],
            // Carried by other rows, it may have no force of its own.
            Self::Resting => &[Mode::Sticks, Mode::Off, Mode::Forwards, Mode::Backwards],
        }
    }

    /// True for a friction that may have a force.
    fn is_friction(self) -> bool {
        matches!(self, Self::Resting | Self::Only(Mode::Forwards | Mode::Backwards))
    }
}

/// A combination of modes that satisfies all inequalities.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solution<S, const N: usize> {
    pub(super) modes: [Mode; N],
    /// Rows that are at rest without being constraints: other rows carry them.
    pub(super) carried: [bool; N],
    /// Signs of the reactions that bound frictions: true if negative.
    pub(super) negative: [bool; N],
    pub(super) lambda: [S; N],
    pub(super) determinant: S,
    /// Number of Newton steps.
    pub(super) newton: u32,
    /// Least distance of the constraint rows from their limits, relative to the terms of their forces.
    pub(super) slack: S,
    /// Accelerations of all rows.
    pub(super) acceleration: [S; N],
}

impl<S, const N: usize> Solution<S, N> {
    /// True if the gap is open, and not kept closed by other rows.
    pub(super) fn opens(&self, row: usize) -> bool {
        let row = below::<N>(row);
        self.modes[row] == Mode::Open && !self.carried[row]
    }
}

/// Result of the enumeration.
#[derive(Clone, Copy, Debug)]
pub(super) enum Found<S, const N: usize> {
    /// The solution in which the fewest rows move, of several the one farthest from its limits; true if there are others with other
    /// accelerations.
    Modes(Solution<S, N>, bool),
    /// No combination satisfies all inequalities.
    Nothing,
    /// There are too many combinations, and pivots have led to no solution.
    TooMany,
}

/// The inequalities of a combination.
#[derive(Clone, Copy, Debug)]
pub(super) struct Margins<S, const N: usize> {
    /// Values of the inequalities: forces, distances from limits, accelerations; none may be negative.
    pub(super) value: [S; N],
    /// Sizes of the terms of each value; `None` if the row has no inequality.
    pub(super) size: [Option<S>; N],
}

impl<S: Real, const N: usize> Margins<S, N> {
    /// Inequalities that are violated by more than rounding.
    pub(super) fn broken(&self) -> [bool; N] {
        // True for NaN.
        let is_met = |value: S, size: S| value >= -(S::lit(MARGINAL) * size);
        core::array::from_fn(|i| self.size[i].is_some_and(|size| !is_met(self.value[i], size)))
    }
}

/// Enumerates all combinations, or searches them by pivots if they are too many. `broken` marks the rows of a combination whose
/// inequalities are violated.
pub(super) fn enumerate<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    allowed: &[Allowed; N],
    mut broken: impl FnMut(&Solution<S, N>, &Margins<S, N>) -> [bool; N],
) -> Found<S, N> {
    let allowed = &near(rows, allowed);
    let count = allowed.iter().fold(1_u32, |count, row| count.saturating_mul(row.modes().len() as u32));
    if count > MOST_CANDIDATES {
        return walk(rows, allowed, broken);
    }
    let mut best: Option<(Solution<S, N>, usize)> = None;
    let mut is_ambiguous = false;
    for number in 0..count {
        let Some(modes) = combination(rows, allowed, number) else { continue };
        let Some((solution, margins)) = solve(rows, allowed, modes) else { continue };
        if broken(&solution, &margins).contains(&true) {
            continue;
        }
        let moving = moving(allowed, &solution);
        match &best {
            None => best = Some((solution, moving)),
            Some((known, least)) => {
                is_ambiguous |=
                    !(is_same_motion(rows, known, &solution) || sticks_by_law(rows, known, &solution));
                let is_better = moving == *least && solution.slack > known.slack;
                if moving < *least || is_better {
                    best = Some((solution, moving));
                }
            }
        }
    }
    best.map_or(Found::Nothing, |(solution, _)| Found::Modes(solution, is_ambiguous))
}

/// The combination in which every row that can be a constraint is one.
pub(super) fn most_holding<const N: usize>(allowed: &[Allowed; N]) -> [Mode; N] {
    allowed.map(|row| match row {
        Allowed::Only(mode) => mode,
        Allowed::Touching => Mode::Closed,
        Allowed::Resting => Mode::Sticks,
    })
}

/// Restricts frictions of gaps that must be open to the mode off: distant contacts then cost nothing.
fn near<S: Real, const N: usize>(rows: &Rows<S, N>, allowed: &[Allowed; N]) -> [Allowed; N] {
    let most_closed = most_holding(allowed);
    core::array::from_fn(|i| {
        if allowed[i].is_friction() && is_off(rows, &most_closed, i) {
            Allowed::Only(Mode::Off)
        } else {
            allowed[i]
        }
    })
}

/// The combination with this number; `None` if it repeats another one, since a friction without normal force has one mode.
fn combination<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    allowed: &[Allowed; N],
    mut number: u32,
) -> Option<[Mode; N]> {
    let mut modes = [Mode::Off; N];
    let mut first = [true; N];
    for i in 0..N {
        let choices = allowed[i].modes();
        let count = choices.len() as u32;
        let (rest, place) = (number.checked_div(count)?, number.checked_rem(count)?);
        modes[i] = *choices.get(place as usize)?;
        (first[i], number) = (place == 0, rest);
    }
    let chosen = modes;
    for i in 0..N {
        if allowed[i].is_friction() && is_off(rows, &chosen, i) {
            if !first[i] {
                return None;
            }
            modes[i] = Mode::Off;
        }
    }
    Some(modes)
}

/// True if a friction has no force: its limits depend only on rows that are open or off.
pub(super) fn is_off<S: Real, const N: usize>(rows: &Rows<S, N>, modes: &[Mode; N], row: usize) -> bool {
    let row = below::<N>(row);
    let (kinetic, adhesion) = (&rows.kinetic[row], &rows.adhesion[row]);
    [&kinetic.lower, &kinetic.upper, &adhesion.lower, &adhesion.upper].iter().all(|limit| {
        let is_open = |(by, mode): (&S, &Mode)| *by == S::ZERO || matches!(mode, Mode::Open | Mode::Off);
        !limit.is_own() && limit.by.iter().zip(modes).all(is_open)
    })
}

/// Multipliers and accelerations of a combination, and its inequalities; `None` if it has no solution.
pub(super) fn solve<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    allowed: &[Allowed; N],
    modes: [Mode; N],
) -> Option<(Solution<S, N>, Margins<S, N>)> {
    let mut turned = None;
    let found = signed(rows, &modes, &mut turned)?;
    let rows = turned.as_ref().unwrap_or(rows);
    let lambda = found.lambda;
    // A row without direction, whose D_ii is rounding, would need an unbounded force to be held.
    let has_direction = |i: usize| !modes[i].holds() || rows.delassus[i][i] > S::ZERO;
    if !indices::<N>().all(|i| has_direction(i) && lambda[i].is_finite()) {
        return None;
    }
    let acceleration = Vector::from_fn(|i| rows.acceleration(i, &lambda));
    let (determinant, slack, carried) = (found.determinant, S::lit(1.0), [false; N]);
    let negative = rows.load.map(Load::is_negative);
    let newton = found.newton;
    let mut solution =
        Solution { modes, carried, negative, lambda, determinant, newton, slack, acceleration };
    let mut margins = Margins { value: [S::ZERO; N], size: [None; N] };
    let sizes = sizes(rows, &lambda);
    for i in 0..N {
        let mode = modes[i];
        let rests = !matches!(allowed[i], Allowed::Only(_));
        let (terms, inverse) = (sizes[i], S::lit(1.0) / rows.delassus[i][i]);
        let (value, size) = match mode {
            Mode::Closed => (lambda[i], terms * inverse),
            Mode::Sticks => {
                let [lower, upper] = stick(rows, i, &lambda);
                (lower.min(upper), terms * inverse)
            }
            _ if !rests => continue,
            _ => (acceleration[i], terms),
        };
        if mode.holds() && matches!(allowed[i], Allowed::Only(_)) {
            continue;
        }
        if mode.holds() {
            solution.slack = solution.slack.min(value / size);
        } else if value.abs() <= S::lit(MARGINAL) * size && depends(rows, &modes, i) {
            solution.carried[i] = true;
            continue;
        }
        match mode {
            Mode::Off if !is_off(rows, &modes, i) => return None,
            Mode::Off => continue,
            Mode::Backwards => margins.value[i] = -value,
            _ => margins.value[i] = value,
        }
        margins.size[i] = Some(if mode == Mode::Sticks { held_size(rows, i, (&lambda, size)) } else { size });
    }
    Some((solution, margins))
}

/// Sizes of the terms of all accelerations, at least the rounding of the largest one: divided by sqrt(D_ii) they have one unit.
fn sizes<S: Real, const N: usize>(rows: &Rows<S, N>, lambda: &[S; N]) -> [S; N] {
    let terms: [S; N] = Vector::from_fn(|i| size(rows, i, lambda));
    let roots: [S; N] = Vector::from_fn(|i| rows.delassus[i][i].max(S::ZERO).sqrt());
    let largest =
        indices::<N>().filter(|i| roots[*i] > S::ZERO).fold(S::ZERO, |most, i| most.max(terms[i] / roots[i]));
    let rounding = S::lit(ROUNDING) * S::EPSILON / S::lit(MARGINAL) * largest;
    Vector::from_fn(|i| terms[i].max(rounding * roots[i]))
}

/// Size of the margin of a row that sticks: that of its force and its limits, but not below the rounding of `terms`, those of the
/// equation of its force. For a row with almost no direction these terms are far larger than its force, since others balance them.
fn held_size<S: Real, const N: usize>(rows: &Rows<S, N>, row: usize, (lambda, terms): (&[S; N], S)) -> S {
    let row = below::<N>(row);
    let [lower, upper] = stick(rows, row, lambda);
    let own = lambda[row].abs() + (lower + upper).abs();
    own.max(S::lit(ROUNDED) * S::EPSILON * terms).min(terms)
}

/// Size of the terms of an acceleration.
fn size<S: Real, const N: usize>(rows: &Rows<S, N>, row: usize, lambda: &[S; N]) -> S {
    let row = below::<N>(row);
    let terms = rows.delassus[row].iter().zip(lambda);
    terms.fold(rows.free[row].abs(), |sum, (d, lambda)| sum + (*d * *lambda).abs())
}

/// True if the constraint rows leave the row `i` no freedom: D_ii - D_iH D_HH^-1 D_Hi = 0.
fn depends<S: Real, const N: usize>(rows: &Rows<S, N>, modes: &[Mode; N], i: usize) -> bool {
    let (mut held, mut order) = ([0; N], 0);
    for j in indices::<N>().filter(|j| modes[*j].holds()) {
        held[below::<N>(order)] = j;
        order += 1;
    }
    let entry = |i: usize, j: usize| rows.delassus[below::<N>(i)][below::<N>(j)];
    let mut matrix = [[S::ZERO; N]; N];
    for k in 0..order.min(N) {
        matrix[k] = Vector::from_fn(|l| entry(held[k], held[l]));
    }
    let Some(lu) = Lu::new(matrix, order) else { return false };
    let column: [S; N] = Vector::from_fn(|k| entry(held[k], i));
    let mut y = column;
    lu.solve(&mut y);
    let own = (0..order.min(N)).fold(entry(i, i), |own, k| own - column[k] * y[k]);
    own <= S::lit(DEPENDENT) * entry(i, i)
}

/// Number of rows that move although they could be at rest.
fn moving<S: Real, const N: usize>(allowed: &[Allowed; N], solution: &Solution<S, N>) -> usize {
    let moves = |i: &usize| {
        let rests = matches!(allowed[*i], Allowed::Touching | Allowed::Resting);
        rests && !solution.modes[*i].holds() && !solution.carried[*i] && solution.modes[*i] != Mode::Off
    };
    indices::<N>().filter(moves).count()
}

/// Accelerations of rows are equal if they differ by less than this fraction of the largest terms.
const NO_DIFFERENCE: f64 = 1e-12;

/// True if two combinations differ only in rows that stick in one and slip in the other, under a static bound above the kinetic one. By
/// that law a row at rest sticks, although it could slip.
fn sticks_by_law<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    one: &Solution<S, N>,
    other: &Solution<S, N>,
) -> bool {
    let differs = |i: usize| match (one.modes[i], other.modes[i]) {
        (one, other) if one == other => false,
        (Mode::Sticks, mode) | (mode, Mode::Sticks) => !mode.slips() || rows.adhesion[i] == rows.kinetic[i],
        _ => true,
    };
    !indices::<N>().any(differs)
}

/// True if the accelerations of all rows are equal.
pub(super) fn is_same_motion<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    one: &Solution<S, N>,
    other: &Solution<S, N>,
) -> bool {
    let size = |i: usize| size(rows, i, &one.lambda).max(size(rows, i, &other.lambda));
    // The terms of a row may be nothing but rounding of the others.
    let largest = indices::<N>().fold(S::ZERO, |largest, i| largest.max(size(i)));
    indices::<N>().all(|i| {
        let apart = (one.acceleration[i] - other.acceleration[i]).abs();
        apart <= (S::lit(4.0 * MARGINAL) * size(i)).max(S::lit(NO_DIFFERENCE) * largest)
    })
}
