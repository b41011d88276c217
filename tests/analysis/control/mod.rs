//! Linear control: against closed forms of mechanisms, and against scipy (`scipy.py` makes `scipy.json`).

mod closed;
mod scipy;

use nalgebra::{Complex, DMatrix};
use plm::Linearisation;

/// A system of matrices, with inputs `u0`, `u1` and outputs `y0`, `y1`, `y2`.
fn system(a: DMatrix<f64>, b: DMatrix<f64>, c: DMatrix<f64>) -> Linearisation {
    const INPUTS: &[(&str, &str)] = &[("u0", "N"), ("u1", "N")];
    const OUTPUTS: &[(&str, &str)] = &[("y0", "m"), ("y1", "m"), ("y2", "m")];
    let (n, inputs, outputs) = (a.nrows(), &INPUTS[..b.ncols()], &OUTPUTS[..c.nrows()]);
    let d = DMatrix::zeros(c.nrows(), b.ncols());
    Linearisation {
        a,
        b,
        c,
        d,
        basis: DMatrix::identity(n, n),
        states: vec!["x"; n],
        coordinates: 0,
        point: vec![0.0; n],
        inputs,
        outputs,
    }
}

#[track_caller]
fn same(found: &DMatrix<f64>, known: &DMatrix<f64>, within: f64) {
    let error = (found - known).norm() / known.norm().max(f64::MIN_POSITIVE);
    assert!(error <= within, "{found}{known}{error:e}");
}

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!(
        (found - known).abs() <= within * known.abs().max(1.0),
        "{found} is not {known}: {:e}",
        found - known
    );
}

/// The same numbers, in any order.
#[track_caller]
fn same_set(found: &[Complex<f64>], known: &[Complex<f64>], within: f64) {
    assert_eq!(found.len(), known.len(), "{found:?} {known:?}");
    for known in known {
        let nearest = found.iter().map(|found| (found - known).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= within * known.norm().max(1.0), "{known} is not in {found:?}: {nearest:e}");
    }
}
