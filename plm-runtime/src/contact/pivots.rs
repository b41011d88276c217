//! Modes of many rows, if there are too many combinations to enumerate: Lemke's method.
//!
//! The laws are a linear complementarity problem, w = M z + q >= 0, z >= 0, w.z = 0. A gap has the pair (acceleration, contact force); a
//! friction has two: with the bounds l and u and a = a+ - a-, the pairs (a+, lambda + l) and (a-, u - lambda). The method starts at
//! z = 0 and follows w = M z + q + d s, while s falls to zero from a value at which all inequalities are satisfied, by exchange of one
//! variable at a time (C. E. Lemke, Management Science 11, 1965). Ties are decided lexicographically, which excludes cycles
//! (R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity Problem, 1992, section 4.4; F. Pfeiffer, Ch. Glocker, Multibody
//! Dynamics with Unilateral Contacts, 1996, chapter 6). The result is one solution, if there is one; others may exist.

use super::apart;
use super::candidates::Allowed;
use super::loads::{Affine, Load};
use super::modes::Mode;
use super::rows::{Rows, below, indices};
use crate::linalg::Lu;
use crate::scalar::Real;

/// Difference, relative to the largest number, below which numbers are equal; pivots are larger.
const EQUAL: f64 = 1e-11;
/// Most exchanges for each pair.
const MOST_EXCHANGES: usize = 20;
/// Most corrections of the directions of reactions in the plane.
const MOST_DIRECTIONS: u32 = 4;

/// The modes that the method finds; `None` if it ends without a solution. Each `attempt` has another d, and so another path.
pub(super) fn pivoted<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    allowed: &[Allowed; N],
    attempt: u32,
) -> Option<[Mode; N]> {
    let is_curved = |i: usize| rows.loads_of(i).any(|load| rows.load[below::<N>(load)] == Load::Plane);
    let is_curved = indices::<N>().any(|i| allowed[i] == Allowed::Resting && is_curved(i));
    let mut forces = [S::ZERO; N];
    let mut modes = None;
    for _ in 0..if is_curved { MOST_DIRECTIONS } else { 1 } {
        let problem = Problem::new(rows, allowed, &forces)?;
        let mut tableau = Tableau::new(&problem, allowed, attempt);
        tableau.solve()?;
        forces = problem.forces(&tableau);
        modes = Some(tableau.modes(allowed));
    }
    modes
}

/// Forces as functions of the force variables of the pairs: `lambda = sum of z by column + constant`.
struct Problem<'a, S, const N: usize> {
    rows: &'a Rows<S, N>,
    columns: [[S; N]; N],
    constant: [S; N],
    /// Upper bounds of frictions.
    upper: [Affine<S, N>; N],
    /// Factors that give forces one unit in all rows.
    scale: [S; N],
}

impl<'a, S: Real, const N: usize> Problem<'a, S, N> {
    /// Problem with the directions of reactions in the plane at `forces`, those of the last solution.
    fn new(rows: &'a Rows<S, N>, allowed: &[Allowed; N], forces: &[S; N]) -> Option<Self> {
        let (one, zero) = (S::lit(1.0), S::ZERO);
        let mut matrix: [[S; N]; N] =
            core::array::from_fn(|i| core::array::from_fn(|j| if i == j { one } else { zero }));
        let mut constant = [zero; N];
        let mut upper = [Affine::zero(); N];
        let directions = &rows.directions(forces, |_| true);
        for i in 0..N {
            let (lower, sign) = match allowed[i] {
                // z = lambda + l.
                Allowed::Resting => (rows.along(i, &rows.adhesion[i].lower, directions), one),
                Allowed::Only(Mode::Forwards) => (rows.along(i, &rows.kinetic[i].lower, directions), one),
                Allowed::Only(Mode::Backwards) => (rows.along(i, &rows.kinetic[i].upper, directions), -one),
                _ => continue,
            };
            upper[i] = rows.along(i, &rows.adhesion[i].upper, directions);
            for j in 0..N {
                matrix[i][j] = matrix[i][j] + sign * lower.by[j];
            }
            constant[i] = -(sign * lower.own);
        }
        let lu = Lu::new(matrix, N)?;
        lu.solve(&mut constant);
        let columns = core::array::from_fn(|j| {
            let mut column = core::array::from_fn(|i| if i == j { one } else { zero });
            lu.solve(&mut column);
            column
        });
        let scale = core::array::from_fn(|i| {
            let own = rows.delassus[i][i];
            if own > zero { own.sqrt() } else { one }
        });
        Some(Self { rows, columns, constant, upper, scale })
    }

    /// Forces of a solution.
    fn forces(&self, tableau: &Tableau<S, N>) -> [S; N] {
        let mut forces = self.constant;
        for j in 0..N {
            let z = tableau.value(Variable::force(j, 0)) / self.scale[j];
            for (force, column) in forces.iter_mut().zip(&self.columns[j]) {
                *force = column.mul_add(z, *force);
            }
        }
        forces
    }
}

/// A variable: s, or one of a pair of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Variable {
    Cover,
    Of { row: usize, pair: usize, is_force: bool },
}

impl Variable {
    /// Variable z.
    fn force(row: usize, pair: usize) -> Self {
        Self::Of { row, pair, is_force: true }
    }

    /// Variable w.
    fn rate(row: usize, pair: usize) -> Self {
        Self::Of { row, pair, is_force: false }
    }

    /// The other variable of its pair.
    fn complement(self) -> Self {
        match self {
            Self::Cover => Self::Cover,
            Self::Of { row, pair, is_force } => Self::Of { row, pair, is_force: !is_force },
        }
    }
}

/// A basic variable as a function of those that are zero: `right + by . variables + cover times the last of them`.
#[derive(Clone, Copy)]
struct Line<S, const N: usize> {
    basic: Variable,
    by: [[S; 2]; N],
    cover: S,
    right: S,
    /// True if the pair exists: rows that can rest have one, frictions two.
    is_there: bool,
}

/// All basic variables, and the variables that are zero.
struct Tableau<S, const N: usize> {
    lines: [[Line<S, N>; 2]; N],
    /// The variables that are zero, by their columns.
    zero: [[Variable; 2]; N],
    last: Variable,
}

/// Index of a column.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Column {
    Of(usize, usize),
    Last,
}

impl<S: Real, const N: usize> Line<S, N> {
    fn at(&self, column: Column) -> S {
        match column {
            Column::Of(row, pair) => self.by[below::<N>(row)][below::<2>(pair)],
            Column::Last => self.cover,
        }
    }

    fn set(&mut self, column: Column, value: S) {
        match column {
            Column::Of(row, pair) => self.by[below::<N>(row)][below::<2>(pair)] = value,
            Column::Last => self.cover = value,
        }
    }
}

impl<S: Real, const N: usize> Tableau<S, N> {
    fn new(problem: &Problem<'_, S, N>, allowed: &[Allowed; N], attempt: u32) -> Self {
        let Problem { rows, columns, constant, upper, scale } = problem;
        let (one, zero) = (S::lit(1.0), S::ZERO);
        let dot = |a: &[S; N], b: &[S; N]| a.iter().zip(b).fold(zero, |sum, (a, b)| a.mul_add(*b, sum));
        let rests = |i: usize, pair: usize| match allowed[below::<N>(i)] {
            Allowed::Touching => pair == 0,
            Allowed::Resting => true,
            Allowed::Only(_) => false,
        };
        let line = |i: usize, pair: usize| {
            let i = below::<N>(i);
            let basic = Variable::rate(i, pair);
            let cover = 1.0 + f64::from(attempt) * apart(2 * i + pair);
            let (by, cover) = ([[zero; 2]; N], S::lit(cover));
            let mut line = Line { basic, by, cover, right: zero, is_there: rests(i, pair) };
            if !line.is_there {
                return line;
            }
            for j in indices::<N>().filter(|j| rests(*j, 0)).map(below::<N>) {
                let column = &columns[j];
                line.by[j][0] = if pair == 0 {
                    dot(&rows.delassus[i], column) / (scale[i] * scale[j])
                } else {
                    (dot(&upper[i].by, column) - column[i]) * scale[i] / scale[j]
                };
            }
            if pair == 0 {
                line.right = (rows.free[i] + dot(&rows.delassus[i], constant)) / scale[i];
                line.by[i][1] = if rests(i, 1) { one } else { zero };
            } else {
                line.right = (upper[i].own + dot(&upper[i].by, constant) - constant[i]) * scale[i];
            }
            line
        };
        Self {
            lines: core::array::from_fn(|i| core::array::from_fn(|pair| line(i, pair))),
            zero: core::array::from_fn(|i| core::array::from_fn(|pair| Variable::force(i, pair))),
            last: Variable::Cover,
        }
    }

    /// Exchanges variables until s is zero; `None` if that does not end, or ends on a ray.
    fn solve(&mut self) -> Option<()> {
        let size = self.lines().fold(S::ZERO, |size, line| size.max(line.right.abs()));
        let none = S::lit(EQUAL) * size;
        if self.lines().all(|line| line.right >= -none) {
            return Some(());
        }
        let lowest = self.places().reduce(|least, next| {
            let of = |place| self.line(place).right / self.line(place).cover;
            // Among equal ones the last is the least lexicographically.
            if of(next) <= of(least) + none { next } else { least }
        })?;
        let mut entering = self.exchange(lowest, Column::Last).complement();
        for _ in 0..MOST_EXCHANGES * self.places().count() {
            let column = self.column(entering)?;
            let place = self.leaving(column, none)?;
            let left = self.exchange(place, column);
            if left == Variable::Cover {
                return Some(());
            }
            entering = left.complement();
        }
        None
    }

    /// The line whose variable falls to zero first while that of a column grows.
    fn leaving(&self, column: Column, none: S) -> Option<(usize, usize)> {
        let falls = |place: &(usize, usize)| self.line(*place).at(column) < -S::lit(EQUAL);
        self.places().filter(falls).reduce(|first, next| {
            let (a, b) = (self.line(first), self.line(next));
            let (slope, other) = (-a.at(column), -b.at(column));
            let apart = b.right / other - a.right / slope;
            if apart.abs() > none {
                return if apart < S::ZERO { next } else { first };
            }
            match (a.basic, b.basic) {
                (Variable::Cover, _) => first,
                (_, Variable::Cover) => next,
                _ if self.is_less(b, other, a, slope) => next,
                _ => first,
            }
        })
    }

    /// True if a line over its slope is lexicographically less than another one, by the effect of small changes of q.
    fn is_less(&self, one: &Line<S, N>, slope: S, than: &Line<S, N>, other: S) -> bool {
        for (row, pair) in self.places() {
            let rate = Variable::rate(row, pair);
            let column = self.column(rate);
            let of = |line: &Line<S, N>| match column {
                Some(column) => -line.at(column),
                None if line.basic == rate => S::lit(1.0),
                None => S::ZERO,
            };
            let apart = of(one) / slope - of(than) / other;
            if apart.abs() > S::lit(EQUAL) {
                return apart < S::ZERO;
            }
        }
        false
    }

    /// Exchanges the basic variable of a line with the zero variable of a column; returns the one that was basic.
    fn exchange(&mut self, (i, pair): (usize, usize), column: Column) -> Variable {
        let (one, i, pair) = (S::lit(1.0), below::<N>(i), below::<2>(pair));
        let mut line = self.lines[i][pair];
        let pivot = one / line.at(column);
        // basic = right + by . zero, solved for the variable of the column.
        for entry in line.by.as_flattened_mut().iter_mut().chain([&mut line.cover, &mut line.right]) {
            *entry = -(*entry * pivot);
        }
        line.set(column, pivot);
        for (k, other) in self.lines.as_flattened_mut().iter_mut().enumerate() {
            let factor = other.at(column);
            if k == 2 * i + pair || !other.is_there || factor == S::ZERO {
                continue;
            }
            other.set(column, S::ZERO);
            for (entry, of) in other.by.as_flattened_mut().iter_mut().zip(line.by.as_flattened()) {
                *entry = factor.mul_add(*of, *entry);
            }
            other.cover = factor.mul_add(line.cover, other.cover);
            other.right = factor.mul_add(line.right, other.right);
        }
        let zero = match column {
            Column::Of(row, pair) => &mut self.zero[below::<N>(row)][below::<2>(pair)],
            Column::Last => &mut self.last,
        };
        let left = core::mem::replace(zero, line.basic);
        let left = core::mem::replace(&mut line.basic, left);
        self.lines[i][pair] = line;
        left
    }

    /// Modes of a solution.
    fn modes(&self, allowed: &[Allowed; N]) -> [Mode; N] {
        let is_basic = |variable: Variable| self.lines().any(|line| line.basic == variable);
        core::array::from_fn(|i| match allowed[i] {
            Allowed::Only(mode) => mode,
            Allowed::Touching if is_basic(Variable::force(i, 0)) => Mode::Closed,
            Allowed::Touching => Mode::Open,
            Allowed::Resting => match [0, 1].map(|pair| is_basic(Variable::rate(i, pair))) {
                [false, true] => Mode::Sticks,
                [true, true] => Mode::Forwards,
                // Both bounds are zero.
                [true, false] if self.value(Variable::rate(i, 0)) >= self.value(Variable::force(i, 1)) => {
                    Mode::Forwards
                }
                [_, false] => Mode::Backwards,
            },
        })
    }

    /// Value of a variable.
    fn value(&self, variable: Variable) -> S {
        self.lines().find(|line| line.basic == variable).map_or(S::ZERO, |line| line.right)
    }

    fn lines(&self) -> impl Iterator<Item = &Line<S, N>> {
        self.lines.as_flattened().iter().filter(|line| line.is_there)
    }

    fn line(&self, (row, pair): (usize, usize)) -> &Line<S, N> {
        &self.lines[below::<N>(row)][below::<2>(pair)]
    }

    /// Indices of the pairs that exist.
    fn places(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..2 * N).map(|k| (k / 2, k % 2)).filter(|place| self.line(*place).is_there)
    }

    /// Column of a variable that is zero.
    fn column(&self, variable: Variable) -> Option<Column> {
        if self.last == variable {
            return Some(Column::Last);
        }
        let zero = |(row, pair): &(usize, usize)| self.zero[below::<N>(*row)][below::<2>(*pair)];
        let place = self.places().find(|place| zero(place) == variable)?;
        Some(Column::Of(place.0, place.1))
    }
}
