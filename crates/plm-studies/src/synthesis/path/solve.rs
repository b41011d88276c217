//! The problem of a path: residuals of the points, bounds, constraints.

use super::kernel::{COUPLER_POINT, FIRST_ANGLE, Linkage, SHAPE, UNKNOWNS, Unknowns};
use super::{Crank, Path, Timing};
use crate::synthesis::descent::{self, Lack, Problem, Row};
use crate::synthesis::four_bar::{Image, Vector, vector};

/// Place of a search. Angles are those of the crank from the line of the pivots where nothing is known of them, else their known parts.
pub(super) type Place = descent::Place<UNKNOWNS, Image>;

/// Problem of a path.
#[derive(Debug)]
pub(super) struct Solver<'a> {
    path: &'a Path,
    targets: Vec<Vector>,
    /// Greatest distance of a point from the first one: the unit of violations of an angle.
    extent: f64,
    bounds: [[f64; 2]; UNKNOWNS],
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
        Self { path, targets, extent, bounds }
    }

    pub(super) fn is_fixed(&self, k: usize) -> bool {
        let [least, most] = self.bounds[k];
        least == most
    }

    /// Violations of the bounds of lengths that are sums of unknowns, with their derivatives by the lengths.
    fn beyond_bounds(&self, unknowns: &Unknowns) -> [(f64, [f64; 4]); 4] {
        let lengths = self.path.crank.lengths(unknowns);
        std::array::from_fn(|k| {
            let [least, most] = self.path.bounds.lengths[k];
            let violation = (lengths[k] - most).max(0.0) + (lengths[k] - least).min(0.0);
            (violation, std::array::from_fn(|n| if n == k { 1.0 } else { 0.0 }))
        })
    }

    /// Violations of the least transmission angle where the crank is in line with the ground, as lengths, with their derivatives by the
    /// lengths: the cosine between coupler and rocker, by the law of cosines in their triangle with the side r1 - r2 or r1 + r2, is
    /// beyond that of the least angle.
    fn transmission(&self, unknowns: &Unknowns) -> [(f64, [f64; 4]); 2] {
        if self.path.transmission <= 0.0 {
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
            (excess * self.extent, slopes.map(|slope| -sign * slope * self.extent))
        })
    }
}

impl Solver<'_> {
    /// By how much the cosine between coupler and rocker is beyond that of the least transmission angle at an angle of the crank from the
    /// line of the pivots, as a length, with its derivatives by the lengths and by the angle; in the triangle of coupler and rocker the
    /// third side is the span between the crank's pin and the rocker's pivot.
    fn excess(&self, lengths: [f64; 4], angle: f64) -> (f64, [f64; 4], f64) {
        let [r1, r2, r3, r4] = lengths;
        let (sin, cos) = angle.sin_cos();
        let square = r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * cos;
        let cosine = (r3 * r3 + r4 * r4 - square) / (2.0 * r3 * r4);
        let scale = cosine.signum() * self.extent;
        let slopes = [
            (r2 * cos - r1) / (r3 * r4),
            (r1 * cos - r2) / (r3 * r4),
            1.0 / r4 - cosine / r3,
            1.0 / r3 - cosine / r4,
        ];
        let excess = (cosine.abs() - self.path.transmission.cos()) * self.extent;
        (excess, slopes.map(|slope| scale * slope), -scale * r1 * r2 * sin / (r3 * r4))
    }

    /// Is the transmission angle bounded at the points, and not over a turn?
    fn has_lacks(&self) -> bool {
        self.path.crank == Crank::Any && self.path.transmission > 0.0
    }
}

impl Problem<UNKNOWNS> for Solver<'_> {
    type Image = Image;

    fn rows(&self, place: &Place) -> Option<Vec<Row<UNKNOWNS>>> {
        let linkage = Linkage::new(self.path.crank, &place.unknowns, place.image);
        let row = |(angle, target): (&f64, &Vector)| {
            let (point, derivatives) = linkage.differentiated(angle + place.unknowns[FIRST_ANGLE])?;
            let (by_unknowns, by_angle) = (derivatives.by_unknowns, derivatives.by_angle);
            Some(Row { residual: point - target, by_unknowns, by_angle })
        };
        place.angles.iter().zip(&self.targets).map(row).collect()
    }

    fn error(&self, place: &Place) -> f64 {
        let linkage = Linkage::new(self.path.crank, &place.unknowns, place.image);
        let mut sum = 0.0;
        for (angle, target) in place.angles.iter().zip(&self.targets) {
            let Some(point) = linkage.point(angle + place.unknowns[FIRST_ANGLE]) else {
                return f64::INFINITY;
            };
            sum += (point - target).norm_sqr();
        }
        sum
    }

    fn violations(&self, unknowns: &Unknowns) -> Vec<(f64, [f64; UNKNOWNS])> {
        if self.path.crank == Crank::Any {
            return Vec::new();
        }
        let map = self.path.crank.lengths_by_shape();
        let all = self.beyond_bounds(unknowns).into_iter().chain(self.transmission(unknowns));
        let violated = all.filter(|(violation, _)| *violation != 0.0);
        let by_unknowns = |(violation, by_lengths): (f64, [f64; 4])| {
            let mut by = [0.0; UNKNOWNS];
            for n in 0..4 {
                by[SHAPE + n] = (0..4).map(|k| by_lengths[k] * map[k][n]).sum();
            }
            (violation, by)
        };
        violated.map(by_unknowns).collect()
    }

    fn lacks(&self, place: &Place) -> Vec<Lack<UNKNOWNS>> {
        if !self.has_lacks() {
            return Vec::new();
        }
        let lengths = self.path.crank.lengths(&place.unknowns);
        let lack = |(row, angle): (usize, &f64)| {
            let (value, by_lengths, by_angle) = self.excess(lengths, angle + place.unknowns[FIRST_ANGLE]);
            let mut by_unknowns = [0.0; UNKNOWNS];
            by_unknowns[SHAPE..COUPLER_POINT].copy_from_slice(&by_lengths);
            by_unknowns[FIRST_ANGLE] = by_angle;
            (value > 0.0).then_some(Lack { row, value, by_unknowns, by_angle })
        };
        place.angles.iter().enumerate().filter_map(lack).collect()
    }

    fn lack(&self, place: &Place) -> f64 {
        if !self.has_lacks() {
            return 0.0;
        }
        let lengths = self.path.crank.lengths(&place.unknowns);
        let excess = |angle: &f64| self.excess(lengths, angle + place.unknowns[FIRST_ANGLE]).0;
        place.angles.iter().map(|angle| excess(angle).max(0.0).powi(2)).sum()
    }

    fn bounds(&self) -> &[[f64; 2]; UNKNOWNS] {
        &self.bounds
    }

    fn angles_are_free(&self) -> bool {
        self.path.timing == Timing::Free
    }
}
