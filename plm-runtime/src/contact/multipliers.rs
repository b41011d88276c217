//! Multipliers of the contact rows in given modes: one small linear system.
//!
//! Constraint rows have no acceleration, D_i lambda = -c_i; slipping rows have the limit of their friction,
//! lambda_i = -sigma (own + by . lambda). The system is not symmetric; it is solved with partial pivoting (G. H. Golub, C. F. Van Loan,
//! Matrix Computations, 4th ed., algorithm 3.4.1). Pivots are chosen by values, so that numbers with derivatives, and enclosures, are
//! eliminated in the order of the values. Limits that are shares of a reaction in the plane need Newton's method.

use super::loads::Load;
use super::modes::Mode;
use super::rows::{Limit, Rows, below, indices};
use crate::scalar::Scalar;
use crate::vector::Vector;

/// A row depends on others if its pivot is below this fraction of its largest entry.
const DEPENDENT: f64 = 1e-10;
/// Most steps of Newton's method; from a cold start it takes three or four.
const MOST_STEPS: u32 = 12;
/// Change of the unit vectors below which multipliers have converged, since the error of a size is of second order in that of its unit
/// vector. Derivatives converge a few steps later.
const NEAR: f64 = 1e-8;
/// Newton steps after that, for derivatives.
const BEHIND: u32 = 2;
/// Sweeps before the Newton steps: with a friction of a hundredth of that which would lock a joint, one Newton step is left.
const SWEEPS: u32 = 4;
/// Change of the forces, in roundings of the largest one, at which sweeps end.
pub(super) const ROUNDED: f64 = 2.0;
/// Largest ratio of the changes of two successive sweeps.
const SWEPT: f64 = 0.5;
/// A diagonal entry of at least this fraction of the largest entry of its row is a pivot without a search for a larger one.
const PIVOT: f64 = 0.5;

/// Multipliers, and the determinant of their system; that of no row is 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Multipliers<T, const N: usize> {
    pub(super) lambda: [T; N],
    /// Determinant of the system with its constraint rows divided by the diagonal entries of D.
    pub(super) determinant: T,
    /// Steps of Newton's method after the first solution.
    pub(super) newton: u32,
}

/// The system of the active rows.
struct System<T, const N: usize> {
    rows: [[T; N]; N],
    right: [T; N],
    /// Contact row of each unknown.
    unknown: [usize; N],
    order: usize,
}

/// Multipliers in these modes; `None` if active rows depend on each other.
pub(super) fn multipliers<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    modes: &[Mode; N],
) -> Option<Multipliers<T, N>> {
    multipliers_above(rows, modes, DEPENDENT)
}

/// Multipliers for a rate. If a slip takes the determinant to zero they are large, but numbers: a guard ends the step there.
pub(super) fn multipliers_of_rate<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    modes: &[Mode; N],
) -> Option<Multipliers<T, N>> {
    let slips = modes.iter().any(|mode| mode.slips());
    multipliers_above(rows, modes, if slips { 0.0 } else { DEPENDENT })
}

/// Multipliers, if every pivot is above the fraction `least` of its row.
fn multipliers_above<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    modes: &[Mode; N],
    least: f64,
) -> Option<Multipliers<T, N>> {
    let mut directions = directions(rows, modes, &first(rows, modes));
    let slide = !modes.iter().any(|mode| mode.holds());
    let (mut left, mut newton) = (MOST_STEPS, 0);
    while left > 0 {
        left -= 1;
        let mut system = System::of(rows, (modes, &directions));
        let determinant = system.eliminate((slide, least))?;
        let found = Multipliers { lambda: system.substitute(), determinant, newton };
        let next = self::directions(rows, modes, &found.lambda);
        let apart = |(one, other): (&T, &T)| (one.to_f64() - other.to_f64()).abs();
        let changes = directions.as_flattened().iter().zip(next.as_flattened()).map(apart);
        let change = changes.fold(0.0, f64::max);
        if change == 0.0 || change <= NEAR && (left == 0 || !T::HAS_DERIVATIVES) {
            return Some(found);
        }
        if change <= NEAR {
            left = left.min(BEHIND);
        }
        directions = next;
        newton += 1;
    }
    None
}

/// Multipliers with these unit vectors of the reactions that bound slipping rows.
pub(super) fn multipliers_along<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    modes: &[Mode; N],
    directions: &[[T; 2]; N],
) -> Option<Multipliers<T, N>> {
    let slide = !modes.iter().any(|mode| mode.holds());
    let mut system = System::of(rows, (modes, directions));
    let determinant = system.eliminate((slide, DEPENDENT))?;
    Some(Multipliers { lambda: system.substitute(), determinant, newton: 0 })
}

/// Multipliers at which Newton's method begins: those of slipping rows by sweeps of C. F. Gauss and L. Seidel, which cost a fraction of a
/// step. A friction changes the reactions that bound it little.
fn first<T: Scalar, const N: usize>(rows: &Rows<T, N>, modes: &[Mode; N]) -> [T; N] {
    swept(rows, modes, SWEEPS).unwrap_or([T::ZERO; N])
}

/// Forces of rows if every row with a force slips, by sweeps until only rounding changes; `None` if sweeps do not apply or converge
/// slowly.
pub(super) fn sliding<T: Scalar, const N: usize>(rows: &Rows<T, N>, modes: &[Mode; N]) -> Option<[T; N]> {
    swept(rows, modes, u32::MAX)
}

/// Forces after so many sweeps, or fewer if nothing changes any more; `None` if sweeps do not apply or do not converge.
fn swept<T: Scalar, const N: usize>(rows: &Rows<T, N>, modes: &[Mode; N], sweeps: u32) -> Option<[T; N]> {
    if T::HAS_DERIVATIVES || !rows.load.contains(&Load::Plane) {
        return None;
    }
    let (mut lambda, mut before) = ([T::ZERO; N], f64::INFINITY);
    for _ in 0..sweeps {
        let (mut change, mut size) = (0.0_f64, 0.0_f64);
        for i in 0..N {
            if let Some(limit) = slip_limit(rows, modes[i], i) {
                let force = -(modes[i].sign::<T>() * rows.limit(i, limit, &lambda));
                change = change.max((force - lambda[i]).to_f64().abs());
                size = size.max(force.to_f64().abs());
                lambda[i] = force;
            }
        }
        if change <= ROUNDED * T::PRECISION * size {
            break;
        }
        // Sweeps do not converge if frictions lock each other. False for NaN.
        let converges = change <= SWEPT * before;
        if !converges {
            return None;
        }
        before = change;
    }
    Some(lambda)
}

/// Limit of a row that slips.
fn slip_limit<T, const N: usize>(rows: &Rows<T, N>, mode: Mode, row: usize) -> Option<&Limit<T, N>> {
    let kinetic = &rows.kinetic[below::<N>(row)];
    match mode {
        Mode::Forwards => Some(&kinetic.lower),
        Mode::Backwards => Some(&kinetic.upper),
        _ => None,
    }
}

/// Unit vectors of the reactions that bound slipping rows.
fn directions<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    modes: &[Mode; N],
    lambda: &[T; N],
) -> [[T; 2]; N] {
    rows.directions(lambda, |row| modes[below::<N>(row)].slips())
}

impl<T: Scalar, const N: usize> System<T, N> {
    fn of(rows: &Rows<T, N>, (modes, directions): (&[Mode; N], &[[T; 2]; N])) -> Self {
        let mut system = Self { rows: [[T::ZERO; N]; N], right: [T::ZERO; N], unknown: [0; N], order: 0 };
        for i in indices::<N>().filter(|i| modes[*i].holds() || modes[*i].slips()) {
            system.unknown[below::<N>(system.order)] = i;
            system.order += 1;
        }
        for k in 0..system.order.min(N) {
            let i = below::<N>(system.unknown[k]);
            let (row, right) = equation(rows, (modes[i], directions), i);
            system.rows[k] =
                Vector::from_fn(
                    |l| {
                        if l < system.order { row[below::<N>(system.unknown[l])] } else { T::ZERO }
                    },
                );
            system.right[k] = right;
        }
        system
    }

    /// Gaussian elimination; returns the determinant, or `None` if a pivot is not above the fraction `least` of its row. If all rows
    /// `slide` they hardly depend on each other, so that a large diagonal entry is a pivot without a search.
    fn eliminate(&mut self, (slide, least): (bool, f64)) -> Option<T> {
        let order = self.order.min(N);
        let mut determinant = T::lit(1.0);
        let mut sizes = [0.0_f64; N];
        for k in 0..order {
            sizes[k] =
                self.rows[k].iter().take(order).fold(0.0, |size, entry| size.max(entry.to_f64().abs()));
        }
        for k in 0..order {
            let mut pivot = k;
            // False for NaN.
            let is_large = slide && self.rows[k][k].to_f64().abs() >= PIVOT * sizes[k] && sizes[k] > 0.0;
            if !is_large {
                let mut largest = ratio(self.rows[k][k], sizes[k]);
                for i in k + 1..order {
                    let found = ratio(self.rows[i][k], sizes[i]);
                    if found > largest {
                        (pivot, largest) = (i, found);
                    }
                }
                let is_regular = largest > least;
                if !is_regular {
                    return None;
                }
            }
            if pivot != k {
                let pivot = below::<N>(pivot);
                for j in k..order {
                    let entries = (self.rows[k][j], self.rows[pivot][j]);
                    (self.rows[pivot][j], self.rows[k][j]) = entries;
                }
                self.right.swap(k, pivot);
                sizes.swap(k, pivot);
                determinant = -determinant;
            }
            let row = self.rows[k];
            determinant = determinant * row[k];
            for i in k + 1..order {
                let factor = self.rows[i][k] / row[k];
                for j in k + 1..order {
                    self.rows[i][j] = self.rows[i][j] - factor * row[j];
                }
                self.right[i] = self.right[i] - factor * self.right[k];
            }
        }
        Some(determinant)
    }

    /// Multipliers of all contact rows after the elimination.
    fn substitute(&self) -> [T; N] {
        let (mut solution, mut lambda) = ([T::ZERO; N], [T::ZERO; N]);
        let order = self.order.min(N);
        for k in (0..order).rev() {
            let mut rest = self.right[k];
            for j in k + 1..order {
                rest = rest - self.rows[k][j] * solution[j];
            }
            solution[k] = rest / self.rows[k][k];
            lambda[below::<N>(self.unknown[k])] = solution[k];
        }
        lambda
    }
}

/// Size of an entry relative to the largest one of its row.
fn ratio<T: Scalar>(entry: T, size: f64) -> f64 {
    entry.to_f64().abs() / size
}

/// Equation of the row `i`, and its right side. Constraint rows are divided by their diagonal entry.
#[inline]
pub(super) fn equation<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    (mode, directions): (Mode, &[[T; 2]; N]),
    i: usize,
) -> ([T; N], T) {
    let (one, i) = (T::lit(1.0), below::<N>(i));
    let Some(limit) = slip_limit(rows, mode, i) else {
        let row = rows.delassus[i];
        return (row.map(|d| d / row[i]), -rows.free[i] / row[i]);
    };
    // lambda_i + sigma by . lambda = -sigma own
    let limit = rows.along(i, limit, directions);
    let sigma: T = mode.sign();
    let mut row = limit.by.map(|by| sigma * by);
    row[i] = row[i] + one;
    (row, -(sigma * limit.own))
}
