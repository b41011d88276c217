//! The interpreter: the oracle for emitted code.

use super::{Op, Ref, Tape};
use crate::math;
use crate::node::Expr;

/// A tape with its inputs bound to places, to be run many times without allocation.
pub struct Machine<'t> {
    tape: &'t Tape,
    /// One value per instruction. Constants are set once and stay.
    values: Vec<f64>,
    /// Instruction and place in the inputs of each symbol.
    loads: Vec<(usize, usize)>,
}

impl<'t> Machine<'t> {
    /// Binds the symbols of a tape to the places `0..inputs.len()`; of a symbol that stands twice, the first counts.
    ///
    /// # Errors
    /// The first symbol of the tape that is not among `inputs`.
    pub fn new(tape: &'t Tape, inputs: &[Expr]) -> Result<Self, Expr> {
        let mut places: Vec<(Expr, usize)> = inputs.iter().copied().zip(0..).collect();
        places.sort_unstable();
        let mut values = vec![0.0; tape.ops.len()];
        let mut loads = Vec::new();
        for (i, instr) in tape.ops.iter().enumerate() {
            match instr.op {
                Op::Number(number) => values[i] = number,
                Op::Symbol(symbol) => {
                    let first = places.partition_point(|place| place.0 < symbol);
                    match places.get(first) {
                        Some(&(found, place)) if found == symbol => loads.push((i, place)),
                        _ => return Err(symbol),
                    }
                }
                _ => {}
            }
        }
        Ok(Self { tape, values, loads })
    }

    /// Evaluates: `inputs[k]` is the value of the k-th symbol that was bound (NaN if it is missing), `outputs[k]`
    /// becomes the value of the k-th root.
    pub fn run(&mut self, inputs: &[f64], outputs: &mut [f64]) {
        for &(instruction, place) in &self.loads {
            self.values[instruction] = inputs.get(place).copied().unwrap_or(f64::NAN);
        }
        for i in 0..self.tape.ops.len() {
            if let Some(value) = self.step(self.tape.ops[i].op) {
                self.values[i] = value;
            }
        }
        for (output, root) in outputs.iter_mut().zip(&self.tape.outputs) {
            *output = self.values[root.index()];
        }
    }

    /// The value of any instruction in the last run.
    pub fn value(&self, at: Ref) -> f64 {
        self.values[at.index()]
    }

    /// The result of an operation; `None` for what is there already.
    fn step(&self, op: Op) -> Option<f64> {
        let v = |r: Ref| self.values[r.index()];
        Some(match op {
            Op::Number(_) | Op::Symbol(_) => return None,
            Op::Add(a, b) => v(a) + v(b),
            Op::Sub(a, b) => v(a) - v(b),
            Op::Mul(a, b) => v(a) * v(b),
            Op::Div(a, b) => v(a) / v(b),
            Op::Neg(a) => -v(a),
            Op::Sqrt(a) => math::sqrt(v(a)),
            Op::Sin(a) => math::sin(v(a)),
            Op::Cos(a) => math::cos(v(a)),
            Op::Asin(a) => math::asin(v(a)),
            Op::Acos(a) => math::acos(v(a)),
            Op::Atan2(y, x) => math::atan2(v(y), v(x)),
            Op::Exp(a) => math::exp(v(a)),
            Op::Ln(a) => math::ln(v(a)),
            Op::Abs(a) => v(a).abs(),
            Op::Sign(a) => sign(v(a)),
            // Zero has one sign, as of the runtime's scalars.
            Op::Floor(a) => math::floor(v(a)) + 0.0,
            Op::Min(a, b) => math::min(v(a), v(b)),
            Op::Max(a, b) => math::max(v(a), v(b)),
            Op::Less(a, b) => pick(v(a) < v(b), 1.0, 0.0),
            Op::Select(condition, a, b) => pick(v(condition) != 0.0, v(a), v(b)),
        })
    }
}

fn pick(condition: bool, a: f64, b: f64) -> f64 {
    if condition { a } else { b }
}

fn sign(x: f64) -> f64 {
    if 0.0 < x {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}
