//! Steps in numbers of any kind.

use std::collections::BTreeMap;

use plm_compiler::lowered::{Operation, Register, Step};
use plm_runtime::Scalar;

/// The constants that steps multiply or divide, as emitted text has them.
pub(crate) fn factors(steps: &[Step]) -> Vec<Option<f64>> {
    use Operation as O;
    let mut constants: BTreeMap<Register, f64> = BTreeMap::new();
    let of_step = |step: &Step| {
        let constant = |register| constants.get(&register).copied();
        let factor = match step.operation {
            O::Mul(a, _) | O::Div(a, _) | O::MulAdd(a, ..) | O::MulSub(a, ..) => constant(a),
            O::NegMulAdd(a, ..) => constant(a).map(|factor| -factor),
            _ => None,
        };
        for register in step.results() {
            constants.remove(&register);
        }
        if let O::Number(value) = step.operation {
            constants.insert(step.to, value);
        }
        factor
    };
    steps.iter().map(of_step).collect()
}

/// The value of a step whose first operand is a constant, in numbers with derivatives.
#[inline]
fn scaled<S: Scalar>(operation: Operation, factor: f64, at: impl Fn(Register) -> S) -> Option<S> {
    use Operation as O;
    match operation {
        O::Mul(_, b) => Some(at(b).scaled(factor)),
        O::Div(_, b) => Some(at(b).dividing(factor)),
        O::MulAdd(_, b, c) | O::NegMulAdd(_, b, c) => Some(at(b).scaled_add(factor, at(c))),
        O::MulSub(_, b, c) => Some(at(b).scaled_add(factor, -at(c))),
        _ => None,
    }
}

/// One step, and the constant that it multiplies or divides. A program has the operations once for each kind of numbers, not once for
/// each way to give arguments.
#[inline]
pub(crate) fn evaluate<S: Scalar>(
    step: (&Step, Option<f64>),
    registers: &mut [S],
    argument: impl Fn(usize) -> S,
) {
    if let Operation::Argument(k) = step.0.operation {
        registers[step.0.to as usize] = argument(k as usize);
    } else {
        operate(step, registers);
    }
}

#[inline(never)]
fn operate<S: Scalar>((step, factor): (&Step, Option<f64>), registers: &mut [S]) {
    use Operation as O;
    let at = |register: u32| registers[register as usize];
    let factor = factor.filter(|_| S::HAS_DERIVATIVES);
    if let Some(value) = factor.and_then(|factor| scaled(step.operation, factor, at)) {
        registers[step.to as usize] = value;
        return;
    }
    let value = match step.operation {
        O::Number(value) => S::lit(value),
        O::Argument(_) => return,
        O::Add(a, b) => at(a) + at(b),
        O::Sub(a, b) => at(a) - at(b),
        O::Mul(a, b) => at(a) * at(b),
        O::Div(a, b) => at(a) / at(b),
        O::Neg(a) => -at(a),
        O::MulAdd(a, b, c) => at(a).mul_add(at(b), at(c)),
        O::NegMulAdd(a, b, c) => (-at(a)).mul_add(at(b), at(c)),
        O::MulSub(a, b, c) => at(a).mul_add(at(b), -at(c)),
        O::Sqrt(a) => at(a).sqrt(),
        O::SinCos(a, cosine) => {
            let (sin, cos) = at(a).sin_cos();
            registers[cosine as usize] = cos;
            sin
        }
        O::Sin(a) => at(a).sin(),
        O::Cos(a) => at(a).cos(),
        O::Asin(a) => at(a).asin(),
        O::Acos(a) => at(a).acos(),
        O::Atan2(y, x) => at(y).atan2(at(x)),
        O::Exp(a) => at(a).exp(),
        O::Ln(a) => at(a).ln(),
        O::Abs(a) => at(a).abs(),
        O::Sign(a) => at(a).signum0(),
        O::Floor(a) => at(a).floor(),
        O::Min(a, b) => at(a).min(at(b)),
        O::Max(a, b) => at(a).max(at(b)),
        O::Select(a, b, c, d) => S::select(at(a).lt(at(b)), at(c), at(d)),
    };
    registers[step.to as usize] = value;
}
