//! Algebraic Riccati equations by structure-preserving doubling, polished by Newton's method.

use nalgebra::DMatrix;

use super::Time;
use super::lyapunov::lyapunov;

/// Doublings: 2^60 periods are more than any slow mode needs.
const DOUBLINGS: usize = 60;
/// Steps of Newton's method after them; two are usual.
const POLISHED: usize = 6;

/// Quadratic cost to be minimised: the sum, or the integral, of x^T Q x + 2 x^T N u + u^T R u.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// Of the state, positive semidefinite.
    pub q: DMatrix<f64>,
    /// Of the inputs, positive definite.
    pub r: DMatrix<f64>,
    /// Of state and inputs together.
    pub n: DMatrix<f64>,
}

impl Cost {
    /// Without a mixed term.
    pub fn new(q: DMatrix<f64>, r: DMatrix<f64>) -> Self {
        let n = DMatrix::zeros(q.nrows(), r.nrows());
        Self { q, r, n }
    }
}

/// The stabilising X of A^T X + X A - (X B + N) R^-1 (B^T X + N^T) + Q = 0; none where there is none.
///
/// By doubling (E. K.-W. Chu, H.-Y. Fan, W.-W. Lin, Linear Algebra and its Applications 396, 2005) and Newton's method (D. L. Kleinman, IEEE
/// Trans. Automatic Control 13, 1968).
pub fn continuous_riccati(a: &DMatrix<f64>, b: &DMatrix<f64>, cost: &Cost) -> Option<DMatrix<f64>> {
    let (a, g, h) = without_mixed_term(a, b, cost)?;
    let size = a.nrows();
    let one = DMatrix::identity(size, size);
    let gamma = a.norm() + (g.norm() * h.norm()).sqrt();
    if gamma == 0.0 {
        return Some(h);
    }
    let shifted = &a - &one * gamma;
    let inverse = shifted.clone().try_inverse()?;
    let w = (&shifted + &g * inverse.transpose() * &h).try_inverse()?;
    let start = [
        &one + &w * (2.0 * gamma),
        &inverse * &g * w.transpose() * (2.0 * gamma),
        w.transpose() * &h * &inverse * (2.0 * gamma),
    ];
    let x = doubled(start)?;
    let step = |x: &DMatrix<f64>| {
        let closed = &a - &g * x;
        lyapunov(Time::Continuous, &closed, &(&h + x * &g * x))
    };
    Some(polished(x, step))
}

/// The stabilising X of A^T X A - X - (A^T X B + N) (R + B^T X B)^-1 (B^T X A + N^T) + Q = 0; none where there is none.
///
/// By doubling (E. K.-W. Chu, H.-Y. Fan, W.-W. Lin, C.-S. Wang, Int. J. Control 77, 2004) and Newton's method (G. A. Hewer, IEEE Trans. Automatic
/// Control 16, 1971).
pub fn discrete_riccati(a: &DMatrix<f64>, b: &DMatrix<f64>, cost: &Cost) -> Option<DMatrix<f64>> {
    let (own, g, h) = without_mixed_term(a, b, cost)?;
    let x = doubled([own.clone(), g, h.clone()])?;
    let step = |x: &DMatrix<f64>| {
        let bx = b.transpose() * x;
        let gain = (&cost.r + &bx * b).lu().solve(&(bx * &own))?;
        let closed = &own - b * &gain;
        lyapunov(Time::Sampled(0.0), &closed, &(&h + gain.transpose() * &cost.r * &gain))
    };
    Some(polished(x, step))
}

/// A, B R^-1 B^T and Q of the same equation without a mixed term: u is counted from -R^-1 N^T x.
fn without_mixed_term(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    cost: &Cost,
) -> Option<(DMatrix<f64>, DMatrix<f64>, DMatrix<f64>)> {
    let decomposed = cost.r.clone().cholesky()?;
    let own = a - b * decomposed.solve(&cost.n.transpose());
    let g = b * decomposed.solve(&b.transpose());
    let h = &cost.q - &cost.n * decomposed.solve(&cost.n.transpose());
    Some((own, g, h))
}

/// The limit of H under A <- A W A, G <- G + A W G A^T, H <- H + A^T H W A with W = (I + G H)^-1, that starts with (A, G, H).
fn doubled([mut a, mut g, mut h]: [DMatrix<f64>; 3]) -> Option<DMatrix<f64>> {
    let one = DMatrix::identity(a.nrows(), a.nrows());
    for _ in 0..DOUBLINGS {
        let w = (&one + &g * &h).try_inverse()?;
        let aw = &a * &w;
        let change = a.transpose() * &h * &w * &a;
        g += &aw * &g * a.transpose();
        a = &aw * &a;
        let size = h.norm();
        h += symmetric(&change);
        g = symmetric(&g);
        if !(h.norm() + g.norm()).is_finite() {
            return None;
        }
        if change.norm() <= f64::EPSILON * size {
            return Some(h);
        }
    }
    None
}

fn symmetric(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    (matrix + matrix.transpose()) * 0.5
}

/// Steps of Newton's method as long as they become shorter.
fn polished(mut x: DMatrix<f64>, step: impl Fn(&DMatrix<f64>) -> Option<DMatrix<f64>>) -> DMatrix<f64> {
    let mut last = f64::INFINITY;
    for _ in 0..POLISHED {
        let Some(next) = step(&x) else { break };
        let change = (&next - &x).norm();
        if change >= 0.5 * last {
            break;
        }
        (x, last) = (next, change);
    }
    x
}
