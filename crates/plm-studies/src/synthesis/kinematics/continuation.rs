//! Curves of poses by arc length: predictor along the tangent, corrector by least squares, which passes dead points.

use nalgebra::{DMatrix, DVector};

use crate::synthesis::numbers::decomposed;

/// A curve: equations with one unknown more than they have rank.
pub(super) trait Curve {
    /// Residuals at a point, and their derivatives.
    fn equations(&self, x: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>);
}

/// Point of a curve with the unit vector of its way.
#[derive(Clone, Debug)]
pub(super) struct OnCurve {
    pub(super) x: DVector<f64>,
    pub(super) way: DVector<f64>,
}

/// Longest and shortest step, in the unit of the unknowns.
const LONGEST: f64 = 0.05;
const SHORTEST: f64 = 1e-9;
/// Least cosine of the turn of the way over a step.
const STRAIGHT: f64 = 0.95;
/// Singular values below this part of the greatest one are none.
const RANK: f64 = 1e-9;
/// Size of the last correction.
const CORRECTED: f64 = 1e-13;

/// Unit vector that the derivatives leave free. `None` where they leave none or several: at a branch point.
fn way<C: Curve>(curve: &C, x: &DVector<f64>, like: &DVector<f64>) -> Option<DVector<f64>> {
    let (_, by) = curve.equations(x);
    let count = by.ncols();
    let rows = by.nrows().max(count);
    let square = by.resize_vertically(rows, 0.0);
    let svd = decomposed(square)?;
    let (values, vectors) = (&svd.singular_values, svd.v_t.as_ref()?);
    let greatest = values.max();
    let free: Vec<usize> = (0..count).filter(|k| values[*k] <= RANK * greatest).collect();
    let [only] = free[..] else { return None };
    let way: DVector<f64> = vectors.row(only).transpose();
    Some(if way.dot(like) < 0.0 { -way } else { way })
}

/// Point of the curve near another one. `None` where the iteration does not end soon.
pub(super) fn corrected<C: Curve>(curve: &C, mut x: DVector<f64>) -> Option<DVector<f64>> {
    let mut before = f64::INFINITY;
    for _ in 0..12 {
        let (residual, by) = curve.equations(&x);
        let svd = decomposed(by)?;
        let step = svd.solve(&residual, RANK * svd.singular_values.max()).ok()?;
        x -= &step;
        let size = step.amax();
        // Rounding ends the decrease.
        if size <= CORRECTED || (size < 1e-9 && size >= 0.5 * before) {
            return Some(x);
        }
        before = size;
    }
    None
}

impl OnCurve {
    /// Begins at a point near the curve, in the direction that is most like another one.
    pub(super) fn new<C: Curve>(curve: &C, near: DVector<f64>, like: &DVector<f64>) -> Option<Self> {
        let x = corrected(curve, near)?;
        let way = way(curve, &x, like)?;
        Some(Self { x, way })
    }

    /// Point after a step of this length.
    pub(super) fn after<C: Curve>(&self, curve: &C, length: f64) -> Option<Self> {
        let x = corrected(curve, &self.x + &self.way * length)?;
        let moved = &x - &self.x;
        let way = way(curve, &x, &self.way)?;
        let is_near = moved.norm() <= 1.5 * length && moved.dot(&self.way) >= STRAIGHT * moved.norm();
        (is_near && way.dot(&self.way) >= STRAIGHT).then_some(Self { x, way })
    }

    /// Point after the longest step that is straight enough. `None` at a branch point.
    pub(super) fn next<C: Curve>(&self, curve: &C) -> Option<(Self, f64)> {
        let mut length = LONGEST;
        while length >= SHORTEST {
            if let Some(next) = self.after(curve, length) {
                return Some((next, length));
            }
            length *= 0.5;
        }
        None
    }

    /// Point within a step at which this unknown reverses: its component of the tangent is zero there.
    pub(super) fn turn<C: Curve>(&self, curve: &C, length: f64, unknown: usize) -> Option<Self> {
        let (mut from, mut to) = (0.0, length);
        let sign = self.way[unknown].signum();
        for _ in 0..60 {
            let middle = 0.5 * (from + to);
            if middle <= from || middle >= to {
                break;
            }
            if self.after(curve, middle)?.way[unknown] * sign > 0.0 {
                from = middle;
            } else {
                to = middle;
            }
        }
        self.after(curve, to)
    }
}
