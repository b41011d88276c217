//! Removal of violations that are rounding: the last digits of the constraints.
//!
//! Near a minimum the quadratic program of a step is known to the rounding of its solver, which large sizes of states and large weights
//! make more than what may be violated. Newton's steps of least size on the rows alone take that away (J. Nocedal, S. J. Wright, Numerical
//! Optimization, 2nd ed., 2006, 15.4).

use nalgebra::{DMatrix, DVector};

use super::problem::Transcription;
use super::values::Values;
use crate::optimise::mechanism::{Integration, Optimisable};

/// Newton's steps at most; two do.
const STEPS: usize = 4;
/// Iterations of a decomposition at most; some for each value do.
const ITERATIONS: usize = 10_000;
/// Singular values below this fraction of the largest count as zero.
const RANK: f64 = 1e-12;

/// A point beside another one at which constraints are violated by less, with its values; `None` if there is none so near.
pub(super) fn restored<M: Optimisable, D: Integration<M>>(
    program: &mut Transcription<M, D>,
    (z, values): (&DVector<f64>, &Values),
    sizes: &[f64],
    enough: impl Fn(&Values) -> bool,
) -> Option<(DVector<f64>, Values)> {
    let (mut z, mut values) = (z.clone(), values.clone());
    for _ in 0..STEPS {
        let d = step(program, (&z, &values), sizes)?;
        z += d;
        values = program.evaluate(&z).ok()?;
        if enough(&values) {
            return Some((z, values));
        }
    }
    None
}

/// The least step that closes the rows to first order; a variable that would leave its bounds is fixed.
fn step<M: Optimisable, D: Integration<M>>(
    program: &Transcription<M, D>,
    (z, values): (&DVector<f64>, &Values),
    sizes: &[f64],
) -> Option<DVector<f64>> {
    let (matrix, open) = rows(values, sizes);
    let mut free = vec![true; z.len()];
    for _ in 0..z.len() {
        let own =
            DMatrix::from_fn(matrix.nrows(), z.len(), |i, k| if free[k] { matrix[(i, k)] } else { 0.0 });
        if !own.iter().chain(open.iter()).all(|number| number.is_finite()) {
            return None;
        }
        let svd = own.try_svd(true, true, f64::EPSILON, ITERATIONS)?;
        let scaled = svd.solve(&-&open, RANK * svd.singular_values.max()).ok()?;
        let d = DVector::from_fn(z.len(), |k, _| scaled[k] * sizes[k]);
        let outside = |k: &usize| {
            let [least, most] = program.bounds(*k);
            free[*k] && !(least..=most).contains(&(z[*k] + d[*k]))
        };
        let outside: Vec<usize> = (0..z.len()).filter(outside).collect();
        if outside.is_empty() {
            return Some(d);
        }
        for k in outside {
            free[k] = false;
        }
    }
    None
}

/// Equality constraints, and violated inequality constraints, with derivatives by the scaled variables.
fn rows(values: &Values, sizes: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
    let Values { equal, equal_by, within, within_by, limits, .. } = values;
    let outside = |row: &usize| {
        let ([least, most], own) = (limits[*row], within[*row]);
        own < least || own > most
    };
    let outside: Vec<usize> = (0..within.len()).filter(outside).collect();
    let count = equal.len() + outside.len();
    let entry = |i: usize, k: usize| match i.checked_sub(equal.len()) {
        None => equal_by[(i, k)] * sizes[k],
        Some(of) => within_by[(outside[of], k)] * sizes[k],
    };
    let open = |i: usize| match i.checked_sub(equal.len()) {
        None => equal[i],
        Some(of) => {
            let ([least, most], own) = (limits[outside[of]], within[outside[of]]);
            own - own.max(least).min(most)
        }
    };
    (DMatrix::from_fn(count, sizes.len(), entry), DVector::from_fn(count, |i, _| open(i)))
}
