//! A function in two parts: what some of its symbols do not enter, and the rest.
//!
//! Both have the operations of the whole, fused where the whole has them fused, so that the bits stay.

use crate::collect::CollectVec;
use plm_cas::{Count, Expr, Op, Tape};

use super::{Around, Bindings, Lowering, blocks, uses};
use crate::formulate::Function;

/// The array in which values go from the first part to the second.
const SHARED: &str = "shared";

/// A function in two parts.
pub(in super::super) struct Parts {
    /// The part that the moving symbols do not enter; its value is the array `shared`.
    pub(in super::super) still: Part,
    /// The rest, which reads `shared`.
    pub(in super::super) moving: Part,
    /// Length of `shared`.
    pub(in super::super) shared: usize,
}

/// A part of a function.
pub(in super::super) struct Part {
    /// Its statements.
    pub(in super::super) text: String,
    /// Its operations.
    pub(in super::super) count: Count,
    /// Source text of the symbols that it reads.
    pub(in super::super) symbols: Vec<String>,
}

/// Surroundings of a part, and where its symbols are found.
pub(in super::super) type Surroundings<'a> = (&'a Bindings, &'a Around<'a>);

/// Parts a function. `moving` are the symbols that enter the second part alone, where an element of `shared` is read by
/// `read`.
pub(in super::super) fn parts(
    function: &Function,
    (moving, read): (&[Expr], &str),
    first: Surroundings,
    second: Surroundings,
) -> Parts {
    let tape = function.tape();
    let first_result = tape.outputs.len() - function.results.len();
    let results: Vec<usize> = tape.outputs[first_result..].iter().map(|result| result.index()).collect_vec();
    let mut whole = Lowering::new(&tape, &results, second.0, second.1);
    whole.lower_until(tape.ops.len());
    let named = whole.named;
    let cuts = cuts(&tape, &whole.uses, &named, (&results, moving));

    let mut still = Lowering::new(&tape, &cuts, first.0, first.1);
    still.known_names = Some(&named);
    still.lower_until(tape.ops.len());
    still.list(&cuts);
    let mut rest = Lowering::new(&tape, &[], second.0, second.1);
    rest.known_names = Some(&named);
    rest.known = cuts.iter().enumerate().map(|(k, &cut)| (cut, format!("{SHARED}[{k}]{read}"))).collect();
    rest.uses = uses(&tape, &results, &rest.known);
    rest.lower_until(tape.ops.len());
    for ((place, _), &result) in function.results.iter().zip(&results) {
        rest.store(place, result);
    }
    Parts { still: part(still, first), moving: part(rest, second), shared: cuts.len() }
}

fn part(lowering: Lowering, (bindings, around): Surroundings) -> Part {
    let used = lowering.tape.ops.iter().zip(&lowering.uses).enumerate();
    let made = used.filter(|(index, (_, uses))| **uses > 0 && !lowering.known.contains_key(index));
    let made: Vec<_> = made.map(|(_, (instruction, _))| instruction).collect_vec();
    let symbols = made.iter().filter_map(|instruction| match instruction.op {
        Op::Symbol(symbol) => bindings.get(&symbol).cloned(),
        _ => None,
    });
    let (count, symbols) = (Count::of(made.iter().copied()), symbols.collect());
    Part { text: blocks::with_literals(lowering.finish(), around), count, symbols }
}

/// Values that the first part gives to the second: no moving symbol enters them, and the second part reads them.
///
/// Values within an operation of the second part at no cost stay there: factors of a product that its sum fuses, negations.
/// So do conditions, which are no numbers.
fn cuts(tape: &Tape, uses: &[u32], named: &[bool], (results, moving): (&[usize], &[Expr])) -> Vec<usize> {
    let mut is_still: Vec<bool> = Vec::with_capacity(tape.ops.len());
    for instruction in &tape.ops {
        is_still.push(match instruction.op {
            Op::Symbol(symbol) => !moving.contains(&symbol),
            op => op.operands().all(|operand| is_still[operand.index()]),
        });
    }
    let mut is_read = vec![false; tape.ops.len()];
    let mut is_summed = vec![false; tape.ops.len()];
    for &result in results {
        is_read[result] = true;
    }
    let mut cuts = Vec::new();
    for (index, instruction) in tape.ops.iter().enumerate().rev() {
        let op = instruction.op;
        let is_within = match op {
            Op::Mul(..) => !named[index] && is_summed[index],
            Op::Neg(_) => !named[index],
            Op::Less(..) => true,
            _ => false,
        };
        match op {
            _ if uses[index] == 0 => {}
            Op::Number(_) | Op::Symbol(_) => {}
            _ if is_still[index] && !(is_within && is_read[index]) => {
                if is_read[index] {
                    cuts.push(index);
                }
            }
            _ => {
                let is_sum = matches!(op, Op::Add(..) | Op::Sub(..));
                for operand in op.operands() {
                    is_read[operand.index()] = true;
                    is_summed[operand.index()] |= is_sum;
                }
            }
        }
    }
    cuts.reverse();
    cuts
}
