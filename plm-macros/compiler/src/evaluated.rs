//! Values of expressions of symbols that have values, by the tape's interpreter.

use plm_cas::{Expr, Tape, algebra};

use crate::collect::CollectVec;

/// Value of an expression of bound symbols; NaN where it reads a symbol without value.
pub(crate) fn value(expr: Expr, values: &[(Expr, f64)]) -> f64 {
    match expr.as_number() {
        Some(number) => number.to_f64(),
        None => run(&algebra::tape(&[expr]), values)[0],
    }
}

/// Values of many expressions by one tape: to bind the symbols for each would take time that grows with the square of their
/// number. Each by itself if one of them reads a symbol without value.
pub(crate) fn values(exprs: &[Expr], known: &[(Expr, f64)]) -> Vec<f64> {
    let together = algebra::tape(exprs).eval(known);
    together.unwrap_or_else(|_| exprs.iter().map(|&expr| value(expr, known)).collect_vec())
}

/// Values of a tape's outputs; NaN where it reads a symbol without value.
pub(crate) fn run(tape: &Tape, values: &[(Expr, f64)]) -> Vec<f64> {
    tape.eval(values).unwrap_or_else(|_| vec![f64::NAN; tape.outputs.len()])
}
