//! A tape as text, one line for each operation.

use core::fmt::Write;

use super::{Op, Ref, Tape};
use crate::graph::Graph;

impl Tape {
    /// The operations, one a line: `reach = 0.15*t2`. Steps without a name are t0, t1 … by position; constants and
    /// symbols stand where they are used; the last lines name the outputs.
    pub fn listing(&self, graph: &Graph) -> String {
        let mut text = String::new();
        for (i, instr) in self.ops.iter().enumerate() {
            if !matches!(instr.op, Op::Number(_) | Op::Symbol(_)) {
                // Writing to a string cannot fail.
                let _ = writeln!(
                    text,
                    "{} = {}",
                    self.name(graph, Ref(i as u32)),
                    self.operation(graph, instr.op)
                );
            }
        }
        for (i, &output) in self.outputs.iter().enumerate() {
            let _ = writeln!(text, "out{i} = {}", self.name(graph, output));
        }
        text
    }

    fn name(&self, graph: &Graph, at: Ref) -> String {
        let instr = &self.ops[at.index()];
        match (instr.op, instr.expr.and_then(|e| graph.name(e))) {
            (Op::Number(value), _) => value.to_string(),
            (_, Some(name)) => name.to_owned(),
            _ => format!("t{}", at.0),
        }
    }

    fn operation(&self, graph: &Graph, op: Op) -> String {
        let name = |at: Ref| self.name(graph, at);
        let call = |function: &str| {
            let operands: Vec<String> = op.operands().map(name).collect();
            format!("{function}({})", operands.join(", "))
        };
        match op {
            Op::Number(value) => value.to_string(),
            Op::Symbol(e) => graph.name(e).unwrap_or("_").to_owned(),
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
            Op::Min(..) => call("min"),
            Op::Max(..) => call("max"),
        }
    }
}
