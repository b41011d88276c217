//! Method of Levenberg and Marquardt with bounds, with free angles eliminated.

use nalgebra::{SMatrix, SVector};

use super::kernel::{COUPLER_POINT, Derivatives, FIRST_ANGLE, Linkage, SHAPE, UNKNOWNS, Unknowns};
use super::{Crank, Path, Timing};
use crate::four_bar::{Image, Vector, vector};

/// Place of a search: unknowns and free angles, on an image.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub(super) unknowns: Unknowns,
    /// Angles of the crank from the line of the pivots where nothing is known of them, else their known parts.
    pub(super) angles: Vec<f64>,
    pub(super) image: Image,
}

/// When the iteration ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    pub(super) iterations: usize,
    /// Relative decrease of the error below which a step is the last one.
    pub(super) decrease: f64,
    /// Weight of squared violations of the bounds of lengths that are sums.
    pub(super) weight: f64,
}

/// Residuals of a point with what the normal equations need of it.
struct Row {
    residual: Vector,
    derivatives: Derivatives,
}

/// Normal equations of a place.
struct Normal {
    rows: Vec<Row>,
    matrix: SMatrix<f64, UNKNOWNS, UNKNOWNS>,
    gradient: SVector<f64, UNKNOWNS>,
}

impl Normal {
    /// Adds a violation by its derivatives by the shape.
    fn add(&mut self, violation: f64, by_shape: &[f64; 4], weight: f64) {
        if violation == 0.0 {
            return;
        }
        for i in 0..4 {
            self.gradient[SHAPE + i] += weight * violation * by_shape[i];
            for j in 0..=i {
                self.matrix[(SHAPE + i, SHAPE + j)] += weight * by_shape[i] * by_shape[j];
            }
        }
    }
}

/// Scalar product of vectors of the plane.
fn dot(a: Vector, b: Vector) -> f64 {
    a.re * b.re + a.im * b.im
}

/// Problem in the form of the solver.
pub(super) struct Solver<'a> {
    path: &'a Path,
    targets: Vec<Vector>,
    /// Greatest distance of a point from the first one: the unit of violations of an angle.
    extent: f64,
    least: Unknowns,
    most: Unknowns,
    angles_are_free: bool,
}

impl<'a> Solver<'a> {
    pub(super) fn new(path: &'a Path) -> Self {
        let mut bounds = [[f64::NEG_INFINITY, f64::INFINITY]; UNKNOWNS];
        let b = &path.bounds;
        bounds[0] = b.pivot[0];
        bounds[1] = b.pivot[1];
        bounds[2] = b.ground_angle;
        let shape = match path.crank {
            Crank::Any => b.lengths,
            Crank::Turns => [b.lengths[1], [0.0, f64::INFINITY], [0.0, f64::INFINITY], [0.0, f64::INFINITY]],
        };
        bounds[SHAPE..COUPLER_POINT].copy_from_slice(&shape);
        bounds[COUPLER_POINT..FIRST_ANGLE].copy_from_slice(&b.point);
        if !matches!(path.timing, Timing::Steps(_)) {
            bounds[FIRST_ANGLE] = [0.0, 0.0];
        }
        let targets: Vec<Vector> = path.points.iter().copied().map(vector).collect();
        let extent = targets.iter().map(|target| (target - targets[0]).norm()).fold(0.0, f64::max);
        Self {
            path,
            targets,
            extent,
            least: bounds.map(|[least, _]| least),
            most: bounds.map(|[_, most]| most),
            angles_are_free: path.timing == Timing::Free,
        }
    }

    /// Brings unknowns inside their bounds.
    pub(super) fn clamp(&self, unknowns: &mut Unknowns) {
        for (k, value) in unknowns.iter_mut().enumerate() {
            *value = value.clamp(self.least[k], self.most[k]);
        }
    }

    pub(super) fn is_fixed(&self, k: usize) -> bool {
        self.least[k] == self.most[k]
    }

    /// Violations of the bounds of lengths that are sums of unknowns.
    fn violations(&self, unknowns: &Unknowns) -> [f64; 4] {
        if self.path.crank == Crank::Any {
            return [0.0; 4];
        }
        let lengths = self.path.crank.lengths(unknowns);
        std::array::from_fn(|k| {
            let [least, most] = self.path.bounds.lengths[k];
            (lengths[k] - most).max(0.0) + (lengths[k] - least).min(0.0)
        })
    }

    /// Violations of the least transmission angle where the crank is in line with the ground, as lengths, with their derivatives by the
    /// lengths: the cosine between coupler and rocker, by the law of cosines in their triangle with the side r1 - r2 or r1 + r2, is
    /// beyond that of the least angle.
    fn transmission(&self, unknowns: &Unknowns) -> [(f64, [f64; 4]); 2] {
        if self.path.crank == Crank::Any || self.path.transmission <= 0.0 {
            return [(0.0, [0.0; 4]); 2];
        }
        let limit = self.path.transmission.cos();
        let [r1, r2, r3, r4] = self.path.crank.lengths(unknowns);
        [-1.0, 1.0].map(|sign| {
            let side = r1 + sign * r2;
            let cosine = (r3 * r3 + r4 * r4 - side * side) / (2.0 * r3 * r4);
            // Near the pivot the cosine is largest, beyond it smallest.
            let excess = (-sign * cosine - limit).max(0.0);
            let by = -side / (r3 * r4);
            let slopes = [by, sign * by, 1.0 / r4 - cosine / r3, 1.0 / r3 - cosine / r4];
            (
                excess * self.extent,
                slopes.map(|slope| if excess > 0.0 { -sign * slope * self.extent } else { 0.0 }),
            )
        })
    }

    /// Error with weighted violations; infinite where the loop does not close.
    pub(super) fn cost(&self, place: &Place, weight: f64) -> f64 {
        let linkage = Linkage::new(self.path.crank, &place.unknowns, place.image);
        let mut sum = 0.0;
        for (angle, target) in place.angles.iter().zip(&self.targets) {
            let Some(point) = linkage.point(angle + place.unknowns[FIRST_ANGLE]) else {
                return f64::INFINITY;
            };
            sum += (point - target).norm_sqr();
        }
        let violations = self.violations(&place.unknowns);
        let angles = self.transmission(&place.unknowns);
        let all = violations.into_iter().chain(angles.map(|(violation, _)| violation));
        sum + weight * all.map(|v| v * v).sum::<f64>()
    }

    /// Iterates from a place; gives the cost that is reached.
    pub(super) fn descend(&self, place: &mut Place, effort: &Effort) -> f64 {
        let mut cost = self.cost(place, effort.weight);
        let (mut damping, mut growth) = (1e-2, 2.0);
        let Some(mut normal) = self.normal(place, effort.weight) else { return cost };
        for _ in 0..effort.iterations {
            let tried = self.step(&normal, place, damping);
            let next = tried.as_ref().map_or(f64::INFINITY, |tried| self.cost(tried, effort.weight));
            match tried {
                Some(tried) if next < cost => {
                    let is_last = cost - next <= effort.decrease * cost;
                    (*place, cost) = (tried, next);
                    (damping, growth) = ((damping * 0.2).max(1e-14), 2.0);
                    if is_last || cost <= 1e-30 {
                        break;
                    }
                    let Some(there) = self.normal(place, effort.weight) else { break };
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
        cost
    }

    fn normal(&self, place: &Place, weight: f64) -> Option<Normal> {
        let linkage = Linkage::new(self.path.crank, &place.unknowns, place.image);
        let mut matrix = SMatrix::zeros();
        let mut gradient = SVector::zeros();
        let mut rows = Vec::with_capacity(self.targets.len());
        for (angle, target) in place.angles.iter().zip(&self.targets) {
            let (point, derivatives) = linkage.differentiated(angle + place.unknowns[FIRST_ANGLE])?;
            let residual = point - target;
            let by = &derivatives.by_unknowns;
            for i in 0..UNKNOWNS {
                gradient[i] += dot(by[i], residual);
                for j in 0..=i {
                    matrix[(i, j)] += dot(by[i], by[j]);
                }
            }
            rows.push(Row { residual, derivatives });
        }
        let mut normal = Normal { rows, matrix, gradient };
        let map = self.path.crank.lengths_by_shape();
        for (k, violation) in self.violations(&place.unknowns).into_iter().enumerate() {
            normal.add(violation, &map[k], weight);
        }
        for (violation, by_lengths) in self.transmission(&place.unknowns) {
            let by_shape = std::array::from_fn(|n| (0..4).map(|k| by_lengths[k] * map[k][n]).sum());
            normal.add(violation, &by_shape, weight);
        }
        Some(normal)
    }

    /// Place after a damped step inside the bounds. `None` where the equations have no solution.
    fn step(&self, normal: &Normal, place: &Place, damping: f64) -> Option<Place> {
        let (mut matrix, mut gradient) = (normal.matrix, normal.gradient);
        for i in 0..UNKNOWNS {
            matrix[(i, i)] += damping * (matrix[(i, i)] + 1e-12);
        }
        let curvature = |row: &Row| row.derivatives.by_angle.norm_sqr() * (1.0 + damping) + f64::MIN_POSITIVE;
        if self.angles_are_free {
            for row in &normal.rows {
                let along = row.derivatives.by_unknowns.map(|by| dot(by, row.derivatives.by_angle));
                let slope = dot(row.derivatives.by_angle, row.residual);
                let inverse = 1.0 / curvature(row);
                for i in 0..UNKNOWNS {
                    gradient[i] -= along[i] * slope * inverse;
                    for j in 0..=i {
                        matrix[(i, j)] -= along[i] * along[j] * inverse;
                    }
                }
            }
        }
        // A bound holds what would leave it.
        for k in 0..UNKNOWNS {
            let (value, slope) = (place.unknowns[k], gradient[k]);
            if (value <= self.least[k] && slope >= 0.0) || (value >= self.most[k] && slope <= 0.0) {
                for other in 0..UNKNOWNS {
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
        for k in 0..UNKNOWNS {
            next.unknowns[k] += step[k];
        }
        if self.angles_are_free {
            for (angle, row) in next.angles.iter_mut().zip(&normal.rows) {
                let moved = (0..UNKNOWNS).map(|k| row.derivatives.by_unknowns[k] * step[k]).sum::<Vector>();
                *angle -= dot(row.derivatives.by_angle, row.residual + moved) / curvature(row);
            }
        }
        self.clamp(&mut next.unknowns);
        Some(next)
    }
}
