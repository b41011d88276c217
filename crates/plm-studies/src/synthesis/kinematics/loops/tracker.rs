//! Paths of a bilinear homotopy in two projective spaces: predictor by Runge and Kutta's fourth order, corrector by Newton.

use nalgebra::{DMatrix, DVector};

use crate::synthesis::four_bar::{Vector, unit};
use crate::synthesis::random::Random;

/// Equations `(A U)(B W) - U_0 W_0 = 0`, one for each row of the forms A, with B their conjugates.
pub(super) struct Bilinear {
    /// A row for each equation, a column for each homogeneous unknown.
    pub(super) forms: DMatrix<Vector>,
}

/// End of a path.
pub(super) enum End {
    /// Values of both kinds of forms at a finite regular solution.
    Regular(DVector<Vector>, DVector<Vector>),
    /// A solution at infinity, or a singular one.
    Singular,
    /// The path could not be followed.
    Lost,
}

/// Seed of the random coefficients. They decide nothing but which paths lead where.
const SEED: u64 = 20;

/// A correction of this size, relative to the point, ends the iteration.
const CORRECTED: f64 = 1e-10;
/// Steps of Newton's iteration before a step of the path is too long.
const CORRECTIONS: usize = 3;
/// Shortest step of a path, and of the last one.
const SHORTEST: f64 = 1e-10;
/// Steps in a row before they are doubled.
const GOOD: usize = 4;
/// A first coordinate of this size stands for infinity.
const INFINITE: f64 = 1e-8;
/// Reciprocal of the condition below which an end is singular.
const REGULAR: f64 = 1e-11;

/// The homotopy `(1 - t) gamma (P U)(Q W) + t ((A U)(B W) - U_0 W_0)` on the patches `a U = 1`, `b W = 1`.
struct Homotopy {
    target: [DMatrix<Vector>; 2],
    start: [DMatrix<Vector>; 2],
    patches: [DVector<Vector>; 2],
    gamma: Vector,
}

/// A point: both kinds of homogeneous unknowns, one after the other.
type At = DVector<Vector>;

impl Homotopy {
    fn new(of: &Bilinear) -> Self {
        let (rows, columns) = of.forms.shape();
        let mut random = Random::new(SEED, rows as u64);
        let mut chance = || unit(random.between(0.0, std::f64::consts::TAU)) * random.between(0.5, 1.5);
        let mut matrix = |rows, columns| DMatrix::from_fn(rows, columns, |_, _| chance());
        let start = [matrix(rows, columns), matrix(rows, columns)];
        let patches = [matrix(columns, 1).column(0).into(), matrix(columns, 1).column(0).into()];
        let gamma = matrix(1, 1)[(0, 0)];
        Self { target: [of.forms.clone(), of.forms.map(|z| z.conj())], start, patches, gamma }
    }

    fn half(&self) -> usize {
        self.patches[0].len()
    }

    /// Both kinds of unknowns.
    fn parts(&self, x: &At) -> [DVector<Vector>; 2] {
        let half = self.half();
        [x.rows(0, half).into(), x.rows(half, half).into()]
    }

    /// Residuals, derivatives by the point, derivatives by t.
    fn values(&self, x: &At, t: f64) -> (At, DMatrix<Vector>, At) {
        let (half, rows) = (self.half(), self.start[0].nrows());
        let [u, w] = self.parts(x);
        let [p, q, a, b] =
            [&self.start[0] * &u, &self.start[1] * &w, &self.target[0] * &u, &self.target[1] * &w];
        let size = 2 * half;
        let mut residual = At::from_element(size, Vector::from(0.0));
        let mut by_t = residual.clone();
        let mut by_x = DMatrix::from_element(size, size, Vector::from(0.0));
        let (from, to) = (self.gamma * (1.0 - t), Vector::from(t));
        for row in 0..rows {
            let start = self.gamma * p[row] * q[row];
            let target = a[row] * b[row] - u[0] * w[0];
            residual[row] = start * (1.0 - t) + target * t;
            by_t[row] = target - start;
            for k in 0..half {
                let one = if k == 0 { 1.0 } else { 0.0 };
                by_x[(row, k)] = from * self.start[0][(row, k)] * q[row]
                    + to * (self.target[0][(row, k)] * b[row] - w[0] * one);
                by_x[(row, half + k)] = from * p[row] * self.start[1][(row, k)]
                    + to * (a[row] * self.target[1][(row, k)] - u[0] * one);
            }
        }
        for (kind, part) in [u, w].iter().enumerate() {
            residual[rows + kind] = self.patches[kind].dot(part) - 1.0;
            for k in 0..half {
                by_x[(rows + kind, kind * half + k)] = self.patches[kind][k];
            }
        }
        (residual, by_x, by_t)
    }

    /// Derivative of the point of a path by t.
    fn tangent(&self, x: &At, t: f64) -> Option<At> {
        let (_, by_x, by_t) = self.values(x, t);
        by_x.lu().solve(&-by_t)
    }

    /// Point of the path near a predicted one. `None` where the iteration does not end soon.
    fn corrected(&self, mut x: At, t: f64, corrections: usize) -> Option<At> {
        for _ in 0..corrections {
            let (residual, by_x, _) = self.values(&x, t);
            let step = by_x.lu().solve(&residual)?;
            x -= &step;
            if step.norm() <= CORRECTED * x.norm() {
                return Some(x);
            }
        }
        None
    }

    fn predicted(&self, x: &At, t: f64, h: f64) -> Option<At> {
        let by = |factor: f64| Vector::from(factor * h);
        let k1 = self.tangent(x, t)?;
        let k2 = self.tangent(&(x + &k1 * by(0.5)), t + 0.5 * h)?;
        let k3 = self.tangent(&(x + &k2 * by(0.5)), t + 0.5 * h)?;
        let k4 = self.tangent(&(x + &k3 * by(1.0)), t + h)?;
        Some(x + (k1 + (k2 + k3) * Vector::from(2.0) + k4) * by(1.0 / 6.0))
    }

    /// Follows a path from its start to its end.
    fn follow(&self, mut x: At, accuracy: f64) -> End {
        let (mut t, mut h, mut good) = (0.0, 0.02 * accuracy, 0);
        while t < 1.0 {
            let step = f64::min(h, 1.0 - t);
            let next = self.predicted(&x, t, step).and_then(|near| {
                let there = self.corrected(near.clone(), t + step, CORRECTIONS)?;
                // A correction that is long beside the step may lead to another path.
                ((&there - near).norm() <= 1e-3 * accuracy * there.norm()).then_some(there)
            });
            if let Some(next) = next {
                (x, t, good) = (next, if step < h { 1.0 } else { t + step }, good + 1);
                if good >= GOOD {
                    (h, good) = ((2.0 * h).min(0.1 * accuracy), 0);
                }
            } else {
                (h, good) = (0.5 * h, 0);
                if h < SHORTEST {
                    // Close to the end it is singular.
                    return if 1.0 - t < 1e-3 { End::Singular } else { End::Lost };
                }
            }
        }
        self.end(&x)
    }

    fn end(&self, x: &At) -> End {
        let [u, w] = self.parts(x);
        if u[0].norm() <= INFINITE * u.norm() || w[0].norm() <= INFINITE * w.norm() {
            return End::Singular;
        }
        let (_, by_x, _) = self.values(x, 1.0);
        if by_x.iter().any(|entry| !entry.is_finite()) {
            return End::Singular;
        }
        let values = by_x.singular_values();
        if values.min() <= REGULAR * values.max() {
            return End::Singular;
        }
        let Some(x) = self.corrected(x.clone(), 1.0, 10) else { return End::Singular };
        let [u, w] = self.parts(&x);
        End::Regular(&self.target[0] * &u / u[0], &self.target[1] * &w / w[0])
    }

    /// Point of the start system where these forms of the first kind are zero, and the others of the second kind.
    fn start(&self, zero: &[bool]) -> Option<At> {
        let half = self.half();
        let mut x = At::from_element(2 * half, Vector::from(0.0));
        for kind in 0..2 {
            let mut matrix = DMatrix::from_element(half, half, Vector::from(0.0));
            let mut right = At::from_element(half, Vector::from(0.0));
            let rows = (0..zero.len()).filter(|row| zero[*row] == (kind == 0));
            for (k, row) in rows.enumerate() {
                matrix.set_row(k, &self.start[kind].row(row));
            }
            matrix.set_row(half - 1, &self.patches[kind].transpose());
            right[half - 1] = Vector::from(1.0);
            x.rows_mut(kind * half, half).copy_from(&matrix.lu().solve(&right)?);
        }
        Some(x)
    }
}

/// Ends of all paths: one for each choice of half of the equations.
pub(super) fn paths(of: &Bilinear, accuracy: f64) -> Vec<End> {
    let homotopy = Homotopy::new(of);
    let rows = of.forms.nrows();
    let choices = (0..1_u32 << rows).filter(|choice| choice.count_ones() as usize == rows / 2);
    let end = |choice: u32| {
        let zero: Vec<bool> = (0..rows).map(|row| choice >> row & 1 == 1).collect();
        homotopy.start(&zero).map_or(End::Lost, |x| homotopy.follow(x, accuracy))
    };
    choices.map(end).collect()
}
