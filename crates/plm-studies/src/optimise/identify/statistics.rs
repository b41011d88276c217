//! Covariance of estimates, and combinations that no reading determines, by the singular values of the Jacobian (G. A. F. Seber, C. J.
//! Wild, Nonlinear Regression, 1989, 2.1 and 3.4).

use nalgebra::{DMatrix, DVector};

use super::fit::{Combination, Estimate, Fit, Residuals};
use super::loss::Loss;
use super::problem::Readings;
use super::recording::Motion;
use super::segments::Segment;
use crate::optimise::least_squares::{Evaluation, Found, Problem};
use crate::optimise::mechanism::{Integration, Optimisable};
use crate::optimise::unknown::Place;

/// Singular values below this fraction of the largest count as zero: derivatives of runs are exact to their tolerance.
const RANK_TOLERANCE: f64 = 1e-8;

/// Iterations of a decomposition at most; some for each value do.
const ITERATIONS: usize = 10_000;
/// A change of an unknown by its size that changes residuals by less than this, in deviations, is one of rounding.
pub(super) const NO_EFFECT: f64 = 1e-12;

/// The result of a search.
pub(super) fn fit<M: Optimisable, D: Integration<M>>(problem: &Readings<M, D>, found: &Found) -> Fit<M> {
    let places = &problem.places;
    let at_bound: Vec<Option<f64>> =
        (0..places.len()).map(|k| places[k].bounds.into_iter().find(|bound| *bound == found.z[k])).collect();
    let Evaluation { residuals, .. } = &found.at;
    let sizes: Vec<f64> = (0..found.z.len()).map(|k| problem.scale(k).max(found.z[k].abs())).collect();
    let Told { covariance, undetermined, rank } = told(&found.at, places, &sizes, &at_bound);
    let chi_squared = residuals.norm_squared();
    let freedoms = residuals.len().saturating_sub(rank);
    let are_given =
        problem.experiments.iter().flat_map(|experiment| &experiment.outputs).all(|output| output.is_given);
    let variance = match problem.loss {
        Loss::Squares if are_given => 1.0,
        loss => loss.variance(residuals, freedoms),
    };
    let covariance = covariance.map(|entry| if entry == 0.0 { 0.0 } else { entry * variance });
    let owners = owners(problem);
    let estimate = |k: usize| Estimate {
        name: places[k].name.clone(),
        experiment: owners[k],
        value: found.z[k],
        standard_error: covariance[(k, k)].sqrt(),
        unit: places[k].unit,
        factor: places[k].factor,
        bound: at_bound[k],
    };
    Fit {
        estimates: (0..places.len()).map(estimate).collect(),
        undetermined,
        residuals: of_readings(problem, residuals),
        chi_squared,
        freedoms,
        iterations: found.iterations,
        runs: problem.runs,
        mechanism: problem.mechanism(0, &found.z),
        places: places.clone(),
        motions: (0..problem.experiments.len())
            .map(|number| Motion::new(problem, number, &found.z))
            .collect(),
        covariance,
    }
}

/// The experiment that each unknown belongs to.
fn owners<M: Optimisable, D>(problem: &Readings<M, D>) -> Vec<Option<usize>> {
    let own: usize = problem.experiments.iter().map(|experiment| experiment.unknowns.len()).sum();
    let mut owners = vec![None; problem.places.len() - own];
    for (number, experiment) in problem.experiments.iter().enumerate() {
        owners.extend(experiment.unknowns.iter().map(|_| Some(number)));
    }
    owners
}

/// Accuracy of the unknowns by the readings.
struct Told {
    /// With residuals of deviation 1.
    covariance: DMatrix<f64>,
    undetermined: Vec<Combination>,
    rank: usize,
}

/// Covariance and undetermined combinations of the unknowns, which are the first variables, along the constraints.
fn told(at: &Evaluation, places: &[Place], sizes: &[f64], at_bound: &[Option<f64>]) -> Told {
    let free: Vec<usize> =
        (0..sizes.len()).filter(|k| at_bound.get(*k).is_none_or(Option::is_none)).collect();
    // Columns count by their directions, whatever the sizes of the unknowns are taken to be: those of a guess of zero are unknown.
    let largest = at.residuals.amax().max(1.0);
    let units: Vec<f64> = (0..sizes.len())
        .map(|k| {
            let norm = at.jacobian.column(k).norm();
            if norm * sizes[k] > NO_EFFECT * largest { 1.0 / norm } else { sizes[k] }
        })
        .collect();
    let scaled = |matrix: &DMatrix<f64>| {
        DMatrix::from_fn(matrix.nrows(), free.len(), |i, k| matrix[(i, free[k])] * units[free[k]])
    };
    let mut covariance = DMatrix::zeros(places.len(), places.len());
    if free.is_empty() {
        return Told { covariance, undetermined: Vec::new(), rank: 0 };
    }
    let along = complement(&scaled(&at.constraints_by));
    let reduced = scaled(&at.jacobian) * &along;
    // With as many rows as columns at least, all singular vectors are given.
    let rows = reduced.nrows().max(reduced.ncols());
    let square = reduced.resize_vertically(rows, 0.0);
    // Of what is no number the decomposition does not end.
    let is_finite = square.iter().all(|entry| entry.is_finite());
    let svd = is_finite.then(|| square.try_svd(false, true, f64::EPSILON, ITERATIONS)).flatten();
    let Some((right, values)) = svd.and_then(|svd| Some((svd.v_t?, svd.singular_values))) else {
        covariance.fill_diagonal(f64::INFINITY);
        return Told { covariance, undetermined: Vec::new(), rank: 0 };
    };
    let vectors = along * right.transpose();
    let own: Vec<usize> = (0..free.len()).filter(|a| free[*a] < places.len()).collect();
    let is_told = |k: usize| values[k] > RANK_TOLERANCE * values.amax();
    for k in (0..values.len()).filter(|k| is_told(*k)) {
        for (a, b) in own.iter().flat_map(|a| own.iter().map(move |b| (*a, *b))) {
            let entry = vectors[(a, k)] * vectors[(b, k)] / values[k].powi(2);
            covariance[(free[a], free[b])] += entry * units[free[a]] * units[free[b]];
        }
    }
    let untold = (0..values.len()).filter(|k| !is_told(*k));
    let in_sizes = |a: usize, k: usize| vectors[(a, k)] * units[free[a]] / sizes[free[a]];
    let mut null: Vec<DVector<f64>> =
        untold.map(|k| DVector::from_iterator(own.len(), own.iter().map(|a| in_sizes(*a, k)))).collect();
    let rank = values.len() - null.len();
    reduce(&mut null);
    for vector in &null {
        for a in own.iter().filter(|a| vector[**a].abs() > SMALL) {
            covariance[(free[*a], free[*a])] = f64::INFINITY;
        }
    }
    let undetermined = null.iter().map(|vector| combination(vector, (&free, sizes), places)).collect();
    Told { covariance, undetermined, rank }
}

/// An orthonormal basis of the directions along which no row changes, the rows being independent.
fn complement(rows: &DMatrix<f64>) -> DMatrix<f64> {
    let (count, size) = rows.shape();
    if count == 0 {
        return DMatrix::identity(size, size);
    }
    let q = rows.transpose().resize_horizontally(size, 0.0).qr().q();
    q.columns(count.min(size), size.saturating_sub(count)).into_owned()
}

/// Parts of a combination below this fraction of the largest are rounding.
const SMALL: f64 = 1e-5;

/// Combinations of the same span with as few unknowns as elimination gives (Gauss and Jordan), the largest part of each 1.
fn reduce(vectors: &mut [DVector<f64>]) {
    for k in 0..vectors.len() {
        let pivot = vectors[k].iamax();
        let own = &vectors[k] / vectors[k][pivot];
        for (other, vector) in vectors.iter_mut().enumerate() {
            if other == k {
                vector.copy_from(&own);
            } else {
                let factor = vector[pivot];
                vector.axpy(-factor, &own, 1.0);
            }
        }
    }
}

fn combination(vector: &DVector<f64>, (free, sizes): (&[usize], &[f64]), places: &[Place]) -> Combination {
    // After the unknowns stand the states in which segments begin.
    let own = free.iter().enumerate().take(vector.len());
    let parts = own.filter(|(a, _)| vector[*a].abs() > SMALL * vector.amax());
    let (mut changes, mut fractions) = (Vec::new(), Vec::new());
    for (a, i) in parts {
        changes.push((places[*i].name.clone(), vector[a] * sizes[*i]));
        fractions.push(vector[a]);
    }
    Combination { changes, fractions }
}

/// The residuals of each output of each experiment, from their rows.
fn of_readings<M: Optimisable, D: Integration<M>>(
    problem: &Readings<M, D>,
    rows: &DVector<f64>,
) -> Vec<Residuals> {
    let (mut all, mut row) = (Vec::new(), 0);
    for (number, experiment) in problem.experiments.iter().enumerate() {
        let first = all.len();
        for output in &experiment.outputs {
            all.push(Residuals {
                experiment: number,
                output: output.name.clone(),
                unit: output.unit.clone(),
                times: experiment.times.clone(),
                readings: output.values.iter().map(|value| value / output.factor).collect(),
                model: vec![f64::NAN; experiment.times.len()],
            });
        }
        for sample in problem.segments[number].iter().flat_map(Segment::samples) {
            for (k, output) in experiment.outputs.iter().enumerate() {
                if output.values[sample].is_finite() {
                    let model = output.values[sample] + rows[row] * output.deviation;
                    all[first + k].model[sample] = model / output.factor;
                    row += 1;
                }
            }
        }
    }
    all
}
