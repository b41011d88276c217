//! Roots of polynomials, and of trigonometric polynomials, as eigenvalues of the companion matrix.

use nalgebra::linalg::Schur;
use nalgebra::{Complex, DMatrix};

/// All roots of a polynomial by its coefficients, from the constant one on. Leading coefficients below the rounding of the largest one
/// are left out: their roots are at infinity.
pub(crate) fn roots(coefficients: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let largest = coefficients.iter().map(|c| c.norm()).fold(0.0, f64::max);
    let is_there = |c: &Complex<f64>| c.norm() > 1e-13 * largest;
    let Some(degree) = coefficients.iter().rposition(is_there).filter(|&degree| degree > 0) else {
        return Vec::new();
    };
    let leading = coefficients[degree];
    let companion = DMatrix::from_fn(degree, degree, |row, column| {
        if column + 1 == degree {
            -coefficients[row] / leading
        } else {
            Complex::from(if row == column + 1 { 1.0 } else { 0.0 })
        }
    });
    // The triangular factor has the eigenvalues on its diagonal.
    let Some(decomposed) = Schur::try_new(companion, f64::EPSILON, 1000) else { return Vec::new() };
    let (_, triangular) = decomposed.unpack();
    triangular.diagonal().iter().map(|&root| polish(&coefficients[..=degree], root)).collect()
}

/// Newton's iteration at a root, as long as the value falls.
fn polish(coefficients: &[Complex<f64>], root: Complex<f64>) -> Complex<f64> {
    let zero = Complex::from(0.0);
    let horner = |z: Complex<f64>| {
        let step = |(value, slope): (Complex<f64>, Complex<f64>), c: &Complex<f64>| {
            (value * z + c, slope * z + value)
        };
        coefficients.iter().rev().fold((zero, zero), step)
    };
    let mut root = root;
    let (mut value, mut slope) = horner(root);
    for _ in 0..8 {
        let next = root - value / slope;
        let (at_next, slope_there) = horner(next);
        if at_next.norm() >= value.norm() || !at_next.is_finite() {
            break;
        }
        (root, value, slope) = (next, at_next, slope_there);
    }
    root
}

/// Real roots, with a tolerance on the imaginary part relative to the root.
pub(crate) fn real_roots(coefficients: &[f64]) -> Vec<f64> {
    let coefficients: Vec<Complex<f64>> = coefficients.iter().map(|&c| Complex::from(c)).collect();
    let found = roots(&coefficients).into_iter();
    found.filter(|root| root.im.abs() <= 1e-6 * root.norm().max(1.0)).map(|root| root.re).collect()
}

/// Angles in (-pi, pi] at which a trigonometric polynomial of a degree is zero. It is known by its values at equally spaced angles, which
/// determine its coefficients; z = e^(i angle) makes it an algebraic one, whose roots on the unit circle are the real ones.
pub(crate) fn trigonometric_roots(degree: usize, value: impl Fn(f64) -> f64) -> Vec<f64> {
    let count = 2 * degree + 1;
    let turn = std::f64::consts::TAU / count as f64;
    let values: Vec<f64> = (0..count).map(|k| value(turn * k as f64)).collect();
    let coefficient = |power: usize| {
        let order = power as f64 - degree as f64;
        let terms = values.iter().enumerate().map(|(k, &v)| Complex::from_polar(v, -order * turn * k as f64));
        terms.sum::<Complex<f64>>() / count as f64
    };
    let coefficients: Vec<Complex<f64>> = (0..count).map(coefficient).collect();
    let found = roots(&coefficients).into_iter();
    found.filter(|root| (root.norm() - 1.0).abs() <= 1e-6).map(Complex::arg).collect()
}
