//! A tape as text, one line for each operation.

use core::fmt::Write;

use super::{Op, Ref, Tape};
use crate::graph::Graph;

impl Tape {
    /// The operations, one a line: `reach = 0.15*t2`. Steps without a name are t1, t2 … in order; constants and
    /// symbols stand where they are used; the last lines name the outputs.
    pub fn listing(&self, graph: &Graph) -> String {
        let names = self.names(graph);
        let mut text = String::new();
        for (instr, name) in self.ops.iter().zip(&names) {
            if !matches!(instr.op, Op::Number(_) | Op::Symbol(_)) {
                // Writing to a string cannot fail.
                let _ = writeln!(text, "{name} = {}", operation(instr.op, &names));
            }
        }
        for (i, output) in self.outputs.iter().enumerate() {
            let _ = writeln!(text, "out{i} = {}", names[output.index()]);
        }
        text
    }

    fn names(&self, graph: &Graph) -> Vec<String> {
        let mut steps = 0;
        let mut names = Vec::with_capacity(self.ops.len());
        for instr in &self.ops {
            names.push(match (instr.op, instr.expr.and_then(|e| graph.name(e))) {
                (Op::Number(value), _) => value.to_string(),
                (_, Some(name)) => name.to_owned(),
                (_, None) => {
                    steps += 1;
                    format!("t{steps}")
                }
            });
        }
        names
    }
}

fn operation(op: Op, names: &[String]) -> String {
    let name = |at: Ref| names[at.index()].clone();
    let call = |function: &str| {
        let operands: Vec<String> = op.operands().map(name).collect();
        format!("{function}({})", operands.join(", "))
    };
    match op {
        Op::Number(_) | Op::Symbol(_) => String::new(),
        Op::Add(a, b) => format!("{} + {}", name(a), name(b)),
        Op::Sub(a, b) => format!("{} - {}", name(a), name(b)),
        Op::Mul(a, b) => format!("{}*{}", name(a), name(b)),
        Op::Div(a, b) => format!("{}/{}", name(a), name(b)),
        Op::Neg(a) => format!("-{}", name(a)),
        Op::Less(a, b) => format!("{} < {}", name(a), name(b)),
        Op::Select(c, a, b) => format!("if {} then {} else {}", name(c), name(a), name(b)),
        Op::Sqrt(_) => call("sqrt"),
        Op::Sin(_) => call("sin"),
        Op::Cos(_) => call("cos"),
        Op::Asin(_) => call("asin"),
        Op::Acos(_) => call("acos"),
        Op::Atan2(..) => call("atan2"),
        Op::Exp(_) => call("exp"),
        Op::Ln(_) => call("ln"),
        Op::Abs(_) => call("abs"),
        Op::Sign(_) => call("sign"),
        Op::Floor(_) => call("floor"),
        Op::Min(..) => call("min"),
        Op::Max(..) => call("max"),
    }
}
