//! The pendulum as a differential-algebraic system: what a joint does to the order of a method that is handed the
//! constraint itself, or its first or second derivative.

use plm_runtime::linalg::Lu;

use super::theory::{G, pendulum_angle};

/// Which equation holds the point of 1 kg on the circle of 1 m; the number is the index of the whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Index {
    /// v . v + q . v' = 0.
    One = 1,
    /// q . v = 0.
    Two = 2,
    /// (q . q - 1) / 2 = 0.
    Three = 3,
}

/// x, y, their rates, and the multiplier lambda of q'' = (0, -g) - lambda q.
pub type Point = [f64; 5];

pub const STAGES: usize = 3;
/// Unknowns of a step: a point for every stage.
const SIZE: usize = 5 * STAGES;

const ROOT_6: f64 = 2.449_489_742_783_178;
/// Radau IIA with three stages (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, table IV.5.6).
pub const A: [[f64; STAGES]; STAGES] = [
    [(88.0 - 7.0 * ROOT_6) / 360.0, (296.0 - 169.0 * ROOT_6) / 1800.0, (-2.0 + 3.0 * ROOT_6) / 225.0],
    [(296.0 + 169.0 * ROOT_6) / 1800.0, (88.0 + 7.0 * ROOT_6) / 360.0, (-2.0 - 3.0 * ROOT_6) / 225.0],
    [(16.0 - ROOT_6) / 36.0, (16.0 + ROOT_6) / 36.0, 1.0 / 9.0],
];

/// The known motion from 60 deg at rest, before it turns back.
pub fn exact(time: f64) -> Point {
    let (w, amplitude) = (G.sqrt(), 60_f64.to_radians());
    let angle = pendulum_angle(w, amplitude, time);
    let speed = -(2.0 * G * (angle.cos() - amplitude.cos())).max(0.0).sqrt();
    let (sin, cos) = angle.sin_cos();
    [sin, -cos, speed * cos, speed * sin, speed * speed + G * cos]
}

/// The point after 1 s in so many steps.
pub fn moved(index: Index, steps: u32) -> Option<Point> {
    let h = 1.0 / f64::from(steps);
    (0..steps).try_fold(exact(0.0), |point, _| step(index, &point, h))
}

/// One step: collocation with the constraint at every stage, the last of which is the end (the same, VI.1 and VII.4).
fn step(index: Index, start: &Point, h: f64) -> Option<Point> {
    let mut stages = [*start; STAGES];
    for _ in 0..20 {
        let (matrix, mut rest) = linearised(index, start, h, &stages);
        Lu::new(matrix, SIZE)?.solve(&mut rest);
        let mut change = 0.0_f64;
        for (value, rest) in stages.iter_mut().flatten().zip(rest) {
            *value -= rest;
            change = change.max(rest.abs());
        }
        if change < 1e-13 {
            return Some(stages[STAGES - 1]);
        }
    }
    // Rounding of the multiplier over h^2 keeps the last corrections from getting smaller.
    Some(stages[STAGES - 1])
}

/// Residuals of a step and their derivatives.
fn linearised(
    index: Index,
    start: &Point,
    h: f64,
    stages: &[Point; STAGES],
) -> ([[f64; SIZE]; SIZE], [f64; SIZE]) {
    let (mut matrix, mut rest) = ([[0.0; SIZE]; SIZE], [0.0; SIZE]);
    for i in 0..STAGES {
        let [x, y, vx, vy, lambda] = stages[i];
        for k in 0..4 {
            let row = 5 * i + k;
            rest[row] = stages[i][k] - start[k];
            matrix[row][row] += 1.0;
            for j in 0..STAGES {
                let (weight, other, first) = (h * A[i][j], stages[j], 5 * j);
                if k < 2 {
                    rest[row] -= weight * other[2 + k];
                    matrix[row][first + 2 + k] -= weight;
                } else {
                    let gravity = if k == 3 { G } else { 0.0 };
                    rest[row] += weight * (gravity + other[4] * other[k - 2]);
                    matrix[row][first + k - 2] += weight * other[4];
                    matrix[row][first + 4] += weight * other[k - 2];
                }
            }
        }
        let (residual, by) = match index {
            Index::Three => (0.5 * (x * x + y * y - 1.0), [x, y, 0.0, 0.0, 0.0]),
            Index::Two => (x * vx + y * vy, [vx, vy, x, y, 0.0]),
            Index::One => (
                vx * vx + vy * vy - G * y - lambda * (x * x + y * y),
                [-2.0 * lambda * x, -G - 2.0 * lambda * y, 2.0 * vx, 2.0 * vy, -(x * x + y * y)],
            ),
        };
        rest[5 * i + 4] = residual;
        matrix[5 * i + 4][5 * i..5 * i + 5].copy_from_slice(&by);
    }
    (matrix, rest)
}

/// Orders of position, velocity and multiplier: 2s - 1 at all where the constraint gives the multiplier, less where it has
/// to be differentiated: s (index 2), s and s - 1 (index 3) with s = 3 (E. Hairer, C. Lubich, M. Roche, The Numerical Solution
/// of Differential-Algebraic Systems by Runge-Kutta Methods, 1989; for index 3 as a conjecture, proved in part by L. Jay,
/// Numer. Math. 65, 1993).
pub fn orders(index: Index) -> [f64; 3] {
    match index {
        Index::One => [5.0, 5.0, 5.0],
        Index::Two => [5.0, 5.0, 3.0],
        Index::Three => [5.0, 3.0, 2.0],
    }
}

/// The orders that 40 and 80 steps show.
pub fn found_orders(index: Index) -> Option<[f64; 3]> {
    let (coarse, fine) = (errors(index, 40)?, errors(index, 80)?);
    Some([0, 1, 2].map(|k| (coarse[k] / fine[k]).log2()))
}

/// Errors of position, velocity and multiplier after 1 s.
pub fn errors(index: Index, steps: u32) -> Option<[f64; 3]> {
    let (found, known) = (moved(index, steps)?, exact(1.0));
    let off = |k: usize| found[k] - known[k];
    Some([off(0).hypot(off(1)), off(2).hypot(off(3)), off(4).abs()])
}
