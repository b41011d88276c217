//! Method of Levenberg and Marquardt with bounds, from many starts, with an angle of each row eliminated.
//!
//! A row is a residual of the plane, as the distance of a point from its target. Angles that are free belong to the unknowns; each
//! appears in one row alone and is eliminated from the normal equations (Schur complement).

use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;

use crate::synthesis::four_bar::Vector;

/// Place of a search: unknowns and free angles, on an image.
#[derive(Clone, Debug)]
pub(crate) struct Place<const N: usize, I> {
    pub(crate) unknowns: [f64; N],
    /// An angle of each row: where angles are not free, the known part.
    pub(crate) angles: Vec<f64>,
    pub(crate) image: I,
}

/// When the iteration ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    pub(crate) iterations: usize,
    /// Relative decrease of the error below which a step is the last one.
    pub(crate) decrease: f64,
    /// Weight of squared violations of constraints.
    pub(crate) weight: f64,
}

/// Effort of each start.
const SEARCH: Effort = Effort { iterations: 40, decrease: 1e-3, weight: 1.0 };

/// Efforts of each selected start: constraints become exact by a growing weight.
const POLISH: [Effort; 4] = [
    Effort { iterations: 500, decrease: 1e-9, weight: 1.0 },
    Effort { iterations: 300, decrease: 1e-9, weight: 1e2 },
    Effort { iterations: 300, decrease: 1e-10, weight: 1e5 },
    Effort { iterations: 300, decrease: 1e-12, weight: 1e8 },
];

/// Residual of a row with its derivatives by the unknowns and by the row's angle.
pub(crate) struct Row<const N: usize> {
    pub(crate) residual: Vector,
    pub(crate) by_unknowns: [Vector; N],
    pub(crate) by_angle: Vector,
}

/// Demand on a row that is not met: by how much, with its derivatives by the unknowns and by the row's angle.
pub(crate) struct Lack<const N: usize> {
    pub(crate) row: usize,
    pub(crate) value: f64,
    pub(crate) by_unknowns: [f64; N],
    pub(crate) by_angle: f64,
}

/// Problem of least squares.
pub(crate) trait Problem<const N: usize>: Sync {
    /// Images on which a start stays.
    type Image: Copy + Send + Sync;

    /// Rows with their derivatives. `None` where one has no value, as where a loop is open.
    fn rows(&self, place: &Place<N, Self::Image>) -> Option<Vec<Row<N>>>;

    /// Sum of the squared residuals; infinite where one has no value.
    fn error(&self, place: &Place<N, Self::Image>) -> f64;

    /// Violations of constraints, each with its derivatives by the unknowns; zero ones may be left out.
    fn violations(&self, unknowns: &[f64; N]) -> Vec<(f64, [f64; N])>;

    /// Demands on rows that are not met.
    fn lacks(&self, place: &Place<N, Self::Image>) -> Vec<Lack<N>> {
        let _ = place;
        Vec::new()
    }

    /// Sum of the squares of the lacks.
    fn lack(&self, place: &Place<N, Self::Image>) -> f64 {
        let _ = place;
        0.0
    }

    /// Least and greatest values; equal ones fix an unknown.
    fn bounds(&self) -> &[[f64; 2]; N];

    /// True if the angles are unknowns.
    fn angles_are_free(&self) -> bool;
}

/// Normal equations of a place.
struct Normal<const N: usize> {
    rows: Vec<Row<N>>,
    /// Lacks, each times the root of its weight.
    lacks: Vec<Lack<N>>,
    matrix: SMatrix<f64, N, N>,
    gradient: SVector<f64, N>,
}

/// Terms that the elimination of a row's angle subtracts from the equations.
struct Eliminated<const N: usize> {
    along: [f64; N],
    slope: f64,
    curvature: f64,
}

impl<const N: usize> Normal<N> {
    fn add(&mut self, violation: f64, by_unknowns: &[f64; N], weight: f64) {
        for i in (0..N).filter(|i| by_unknowns[*i] != 0.0) {
            self.gradient[i] += weight * violation * by_unknowns[i];
            for j in 0..=i {
                self.matrix[(i, j)] += weight * by_unknowns[i] * by_unknowns[j];
            }
        }
    }

    fn eliminated(&self, number: usize, row: &Row<N>, damping: f64) -> Eliminated<N> {
        let mut along = row.by_unknowns.map(|by| dot(by, row.by_angle));
        let (mut slope, mut curvature) = (dot(row.by_angle, row.residual), row.by_angle.norm_sqr());
        for lack in self.lacks.iter().filter(|lack| lack.row == number) {
            for (along, by) in along.iter_mut().zip(lack.by_unknowns) {
                *along += by * lack.by_angle;
            }
            slope += lack.value * lack.by_angle;
            curvature += lack.by_angle * lack.by_angle;
        }
        Eliminated { along, slope, curvature: curvature * (1.0 + damping) + f64::MIN_POSITIVE }
    }
}

/// Scalar product of vectors of the plane.
fn dot(a: Vector, b: Vector) -> f64 {
    a.re * b.re + a.im * b.im
}

/// Brings unknowns inside their bounds.
pub(crate) fn clamp<const N: usize>(unknowns: &mut [f64; N], bounds: &[[f64; 2]; N]) {
    for (value, [least, most]) in unknowns.iter_mut().zip(bounds) {
        *value = value.clamp(*least, *most);
    }
}

/// Error with weighted violations; infinite where a residual has no value.
pub(crate) fn cost<const N: usize, P: Problem<N>>(
    problem: &P,
    place: &Place<N, P::Image>,
    weight: f64,
) -> f64 {
    let error = problem.error(place);
    if error.is_infinite() {
        return error;
    }
    let violations = problem.violations(&place.unknowns).iter().map(|(v, _)| v * v).sum::<f64>();
    error + weight * (violations + problem.lack(place))
}

/// Iterates from a place; gives the cost that is reached.
fn descend<const N: usize, P: Problem<N>>(
    problem: &P,
    place: &mut Place<N, P::Image>,
    effort: &Effort,
) -> f64 {
    let mut reached = cost(problem, place, effort.weight);
    let (mut damping, mut growth) = (1e-2, 2.0);
    let Some(mut normal) = normal(problem, place, effort.weight) else { return reached };
    for _ in 0..effort.iterations {
        let tried = step(problem, &normal, place, damping);
        let next = tried.as_ref().map_or(f64::INFINITY, |tried| cost(problem, tried, effort.weight));
        match tried {
            Some(tried) if next < reached => {
                let is_last = reached - next <= effort.decrease * reached;
                (*place, reached) = (tried, next);
                (damping, growth) = ((damping * 0.2).max(1e-14), 2.0);
                if is_last || reached <= 1e-30 {
                    break;
                }
                let Some(there) = self::normal(problem, place, effort.weight) else { break };
                normal = there;
            }
            _ => {
                damping *= growth;
                growth *= 2.0;
                if damping > 1e10 {
                    break;
                }
            }
        }
    }
    reached
}

fn normal<const N: usize, P: Problem<N>>(
    problem: &P,
    place: &Place<N, P::Image>,
    weight: f64,
) -> Option<Normal<N>> {
    let mut matrix = SMatrix::zeros();
    let mut gradient = SVector::zeros();
    let rows = problem.rows(place)?;
    for Row { residual, by_unknowns: by, .. } in &rows {
        for i in 0..N {
            gradient[i] += dot(by[i], *residual);
            for j in 0..=i {
                matrix[(i, j)] += dot(by[i], by[j]);
            }
        }
    }
    let mut normal = Normal { rows, lacks: problem.lacks(place), matrix, gradient };
    for (violation, by_unknowns) in problem.violations(&place.unknowns) {
        normal.add(violation, &by_unknowns, weight);
    }
    let mut lacks = std::mem::take(&mut normal.lacks);
    for lack in &mut lacks {
        normal.add(lack.value, &lack.by_unknowns, weight);
        let root = weight.sqrt();
        lack.value *= root;
        lack.by_angle *= root;
        lack.by_unknowns = lack.by_unknowns.map(|by| by * root);
    }
    normal.lacks = lacks;
    Some(normal)
}

/// Place after a damped step inside the bounds. `None` where the equations have no solution.
fn step<const N: usize, P: Problem<N>>(
    problem: &P,
    normal: &Normal<N>,
    place: &Place<N, P::Image>,
    damping: f64,
) -> Option<Place<N, P::Image>> {
    let (mut matrix, mut gradient) = (normal.matrix, normal.gradient);
    for i in 0..N {
        matrix[(i, i)] += damping * (matrix[(i, i)] + 1e-12);
    }
    let angles: Vec<Eliminated<N>> = if problem.angles_are_free() {
        normal.rows.iter().enumerate().map(|(k, row)| normal.eliminated(k, row, damping)).collect()
    } else {
        Vec::new()
    };
    for Eliminated { along, slope, curvature } in &angles {
        let inverse = 1.0 / curvature;
        for i in 0..N {
            gradient[i] -= along[i] * slope * inverse;
            for j in 0..=i {
                matrix[(i, j)] -= along[i] * along[j] * inverse;
            }
        }
    }
    // A bound holds what would leave it.
    for (k, [least, most]) in problem.bounds().iter().enumerate() {
        let (value, slope) = (place.unknowns[k], gradient[k]);
        if (value <= *least && slope >= 0.0) || (value >= *most && slope <= 0.0) {
            for other in 0..N {
                matrix[(k, other)] = 0.0;
                matrix[(other, k)] = 0.0;
            }
            matrix[(k, k)] = 1.0;
            gradient[k] = 0.0;
        }
    }
    // The lower triangle alone is read.
    let step = matrix.cholesky()?.solve(&-gradient);
    let mut next = place.clone();
    for k in 0..N {
        next.unknowns[k] += step[k];
    }
    for (angle, Eliminated { along, slope, curvature }) in next.angles.iter_mut().zip(&angles) {
        let moved = (0..N).map(|k| along[k] * step[k]).sum::<f64>();
        *angle -= (slope + moved) / curvature;
    }
    clamp(&mut next.unknowns, problem.bounds());
    Some(next)
}

/// Outcome of a start: its cost and its number decide the order.
pub(crate) struct Outcome<const N: usize, I> {
    cost: f64,
    pub(crate) number: u64,
    pub(crate) place: Place<N, I>,
}

/// Outcomes in order, as many as are of use. The best of two lists are the best of both, in whatever order lists are joined.
fn best_of<const N: usize, I>(
    mut one: Vec<Outcome<N, I>>,
    other: Vec<Outcome<N, I>>,
    count: usize,
) -> Vec<Outcome<N, I>> {
    one.extend(other);
    one.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.number.cmp(&b.number)));
    one.truncate(count);
    one
}

/// The best places of so many starts, iterated to the end, as results; on all threads, with results that do not depend on them.
pub(crate) fn search<const N: usize, P: Problem<N>, R: Send>(
    problem: &P,
    starts: u64,
    count: usize,
    start: impl Fn(u64) -> Option<Place<N, P::Image>> + Sync,
    result: impl Fn(&Outcome<N, P::Image>) -> Option<R> + Sync,
) -> Vec<R> {
    let outcome = |number: u64| {
        let mut place = start(number)?;
        let cost = descend(problem, &mut place, &SEARCH);
        cost.is_finite().then_some(Outcome { cost, number, place })
    };
    let best = (0..starts)
        .into_par_iter()
        .filter_map(outcome)
        .fold(Vec::new, |mut list, outcome| {
            list.push(outcome);
            if list.len() < 4 * count { list } else { best_of(list, Vec::new(), count) }
        })
        .reduce(Vec::new, |one, other| best_of(one, other, count));
    let polished = best_of(best, Vec::new(), count).into_par_iter().filter_map(|mut outcome| {
        for effort in &POLISH {
            descend(problem, &mut outcome.place, effort);
        }
        result(&outcome)
    });
    polished.collect()
}
