//! Damped steps towards a closed pose, the compiler's twin of the runtime's `absolute/damped.rs`.
//!
//! Levenberg's and Marquardt's method by conjugate gradients, in numbers without unit: rows and columns in m are measured by the
//! size of the scene, those in rad by the radian.

use crate::collect::CollectVec;

use super::constraints::{Constraints, largest};
use super::rank::Row;

/// Damping at the first step, in units of `A^T A`.
const DAMPING: f64 = 1e-2;
/// Damping with which nothing moves any more.
const MOST_DAMPING: f64 = 1e8;
/// Conjugate gradients end at this part of the first residual, squared.
const SOLVED: f64 = 1e-10;

/// A violation in numbers without unit: of each row its weight times `phi`.
pub(super) struct Measure<'a> {
    constraints: &'a Constraints<'a>,
    /// Of each coordinate what a unit of it is; 0 where it is locked.
    columns: Vec<f64>,
    /// Of each row the weight.
    pub(super) rows: Vec<f64>,
    /// Products with the matrix.
    pub(super) work: usize,
}

impl<'a> Measure<'a> {
    pub(super) fn new(constraints: &'a Constraints<'a>, locked: &[bool]) -> Measure<'a> {
        let scene = constraints.scene;
        let unit = |(k, &locked): (usize, &bool)| match (locked, k % 3) {
            (true, _) => 0.0,
            (false, 2) => 1.0,
            (false, _) => scene.length,
        };
        let columns = locked.iter().enumerate().map(unit).collect_vec();
        let rows = scene.model.rows.iter().map(|row| if row.is_angular() { 1.0 } else { 1.0 / scene.length });
        Measure { constraints, columns, rows: rows.collect_vec(), work: 0 }
    }

    pub(super) fn violation(&self, q: &[f64]) -> Vec<f64> {
        self.rows.iter().zip(self.constraints.phi(q)).map(|(weight, phi)| weight * phi).collect_vec()
    }

    /// The matrix `A` at a pose.
    fn matrix(&self, q: &[f64]) -> Vec<Row> {
        let mut rows = self.constraints.phi_q(q);
        for (row, weight) in rows.iter_mut().zip(&self.rows) {
            for (column, entry) in row {
                *entry *= weight * self.columns[*column];
            }
        }
        rows
    }

    /// The damped step at a pose with a violation.
    fn step(&mut self, q: &[f64], f: &[f64], damping: f64) -> Vec<f64> {
        let matrix = self.matrix(q);
        let mut d = vec![0.0; q.len()];
        let mut left = back(&matrix, f, q.len());
        let (mut p, mut square) = (left.clone(), dot(&left, &left));
        let least = SOLVED * square;
        self.work += 1;
        for _ in 0..2 * q.len() {
            let is_left = square > least;
            if !is_left {
                break;
            }
            let forth = forth(&matrix, &p);
            let returned = back(&matrix, &forth, q.len());
            self.work += 2;
            let by = square / (dot(&forth, &forth) + damping * dot(&p, &p));
            for k in 0..q.len() {
                d[k] += by * p[k];
                left[k] -= by * (returned[k] + damping * p[k]);
            }
            let before = square;
            square = dot(&left, &left);
            for (p, left) in p.iter_mut().zip(&left) {
                *p = left + square / before * *p;
            }
        }
        d.iter().zip(&self.columns).map(|(d, unit)| d * unit).collect_vec()
    }

    /// Goes down to where the violation is smallest in the mean of squares, in at most so many steps; one that takes away less
    /// than this part of it is the last one.
    pub(super) fn descend(&mut self, q: &mut Vec<f64>, (steps, least): (usize, f64)) {
        let mut f = self.violation(q);
        let mut damping = DAMPING;
        for _ in 0..steps {
            let size = dot(&f, &f);
            if largest(&f) <= 16.0 * f64::EPSILON || !size.is_finite() {
                return;
            }
            let d = self.step(q, &f, damping);
            let next = q.iter().zip(&d).map(|(q, d)| q - d).collect_vec();
            let after = self.violation(&next);
            let left = plm_math::f64::sqrt(dot(&after, &after) / size);
            if left < 1.0 {
                (*q, f) = (next, after);
                damping *= if left < 0.5 { 0.1 } else { 0.5 };
                if left > 1.0 - least {
                    return;
                }
            } else {
                damping *= 4.0;
                if damping > MOST_DAMPING {
                    return;
                }
            }
        }
    }
}

/// `A p`.
fn forth(matrix: &[Row], p: &[f64]) -> Vec<f64> {
    let entries = |row: &Row| row.iter().fold(0.0, |sum, &(column, entry)| sum + entry * p[column]);
    matrix.iter().map(entries).collect_vec()
}

/// `A^T u`.
fn back(matrix: &[Row], u: &[f64], columns: usize) -> Vec<f64> {
    let mut product = vec![0.0; columns];
    for (row, u) in matrix.iter().zip(u) {
        for &(column, entry) in row {
            product[column] += entry * u;
        }
    }
    product
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}
