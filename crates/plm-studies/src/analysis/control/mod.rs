//! Linear control of a mechanism near a state: sampling, regulators, estimators, frequency response, zeros, root locus.
//!
//! All of it takes a [`Linearisation`](crate::analysis::Linearisation) and keeps its names. Of a mechanism with contact that is the system of the modes
//! held; where these end, so does what is said here.

mod gains;
mod lacking;
mod lyapunov;
mod response;
mod riccati;
mod root_locus;
mod sampled;
mod zeros;

pub use gains::{Estimator, NoGain, Regulator};
pub use lacking::Lacking;
pub use response::{Bode, NoResponse, frequencies};
pub use riccati::{Cost, continuous_riccati, discrete_riccati};
pub use root_locus::{RootLocus, root_locus};
pub use sampled::Sampled;

use nalgebra::linalg::Schur;
use nalgebra::{Complex, DMatrix};

/// How a linear system goes on in time.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Time {
    /// x' = A x + B u.
    Continuous,
    /// x becomes A x + B u after a period, s.
    Sampled(f64),
}

impl Time {
    /// The mode belongs to a motion that does not decay, but for rounding of numbers of this size.
    fn stays(self, eigenvalue: Complex<f64>, size: f64) -> bool {
        let margin = UNDECIDED * size;
        match self {
            Self::Continuous => eigenvalue.re >= -margin,
            Self::Sampled(_) => eigenvalue.norm() >= 1.0 - UNDECIDED,
        }
    }

    /// The mode neither decays nor grows, but for that rounding.
    fn is_marginal(self, eigenvalue: Complex<f64>, size: f64) -> bool {
        let margin = UNDECIDED * size;
        match self {
            Self::Continuous => eigenvalue.re.abs() <= margin,
            Self::Sampled(_) => (eigenvalue.norm() - 1.0).abs() <= UNDECIDED,
        }
    }
}

/// The square root of the precision: a double eigenvalue is known to so much of the size of its matrix.
const UNDECIDED: f64 = 1.5e-8;

/// A linear system as the functions of this module take it.
#[derive(Clone, Copy)]
struct System<'a> {
    time: Time,
    a: &'a DMatrix<f64>,
    b: &'a DMatrix<f64>,
    c: &'a DMatrix<f64>,
    d: &'a DMatrix<f64>,
    basis: &'a DMatrix<f64>,
    states: &'a [&'static str],
    point: &'a [f64],
    inputs: &'static [(&'static str, &'static str)],
    outputs: &'static [(&'static str, &'static str)],
}

/// The number of a name among names with units.
fn index_of(name: &str, among: &[(&'static str, &'static str)]) -> Option<usize> {
    among.iter().position(|(own, _)| *own == name)
}

/// Eigenvalues of a matrix that is balanced first (B. N. Parlett, C. Reinsch, Numer. Math. 13, 1969): pressures beside angles, where
/// rounding in the largest entries would bury the slow modes otherwise. Of a matrix with an entry that is no finite number they are no
/// numbers.
pub(crate) fn eigenvalues(matrix: &DMatrix<f64>) -> Vec<Complex<f64>> {
    if matrix.is_empty() {
        return Vec::new();
    }
    // Iterations on what is no number do not end.
    let none = || vec![Complex::new(f64::NAN, f64::NAN); matrix.nrows()];
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return none();
    }
    // Norms of balancing are sums, and their squares are to stay in the range of numbers.
    let scale = if matrix.amax() > LARGE { matrix.amax() } else { 1.0 };
    let mut balanced = matrix / scale;
    nalgebra::linalg::balancing::balance_parlett_reinsch(&mut balanced);
    let Some(schur) = Schur::try_new(balanced, f64::EPSILON, 1000 * matrix.nrows()) else { return none() };
    let mut all: Vec<_> = schur.complex_eigenvalues().iter().map(|own| own * scale).collect();
    all.sort_by(|a, b| a.norm().total_cmp(&b.norm()).then(a.im.total_cmp(&b.im)));
    all
}

/// Matrices with larger entries are scaled.
const LARGE: f64 = 1e100;

/// A real matrix as a complex one.
fn complex(matrix: &DMatrix<f64>) -> DMatrix<Complex<f64>> {
    matrix.map(|number| Complex::new(number, 0.0))
}
