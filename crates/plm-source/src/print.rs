//! Blocks as statements of a language.

use crate::block::{Argument, Block, Node, Value};
use crate::dialect::Dialect;

/// Statements, one a line.
#[derive(Debug)]
pub(crate) struct Printed {
    pub(crate) lines: Vec<String>,
    /// The arguments that they read.
    pub(crate) reads: Vec<Argument>,
}

/// Statements that compute what results need, store these in their places, and return a value.
pub(crate) fn statements(
    block: &Block,
    dialect: &impl Dialect,
    results: &[(String, Value)],
    returned: Option<Value>,
) -> Printed {
    let is_needed = block.needed(results.iter().map(|(_, value)| *value).chain(returned));
    let mut texts: Vec<String> = vec![String::new(); block.nodes().len()];
    let mut printed = Printed { lines: Vec::new(), reads: Vec::new() };
    for (k, node) in block.nodes().iter().enumerate().filter(|(k, _)| is_needed[*k]) {
        let of = |value: Value| texts[value.index()].as_str();
        let value = match *node {
            Node::Number(bits) => {
                texts[k] = dialect.number(f64::from_bits(bits));
                continue;
            }
            Node::Argument(argument) => {
                printed.reads.push(argument);
                texts[k] = dialect.argument(argument);
                continue;
            }
            Node::Pair(angle) => {
                let name = format!("w{k}");
                printed.lines.push(dialect.declare_pair(&name, of(angle)));
                texts[k] = name;
                continue;
            }
            Node::Sine(pair) => {
                let [sine, _] = dialect.of_pair(of(pair));
                texts[k] = sine;
                continue;
            }
            Node::Cosine(pair) => {
                let [_, cosine] = dialect.of_pair(of(pair));
                texts[k] = cosine;
                continue;
            }
            Node::One(one, a) => dialect.one(one, of(a)),
            Node::Two(two, a, b) => dialect.two(two, of(a), of(b)),
            Node::Select([a, b, c, d]) => dialect.select([of(a), of(b), of(c), of(d)]),
        };
        let name = format!("v{k}");
        printed.lines.push(dialect.declare(&name, &value));
        texts[k] = name;
    }
    for (place, value) in results {
        printed.lines.push(dialect.store(place, &texts[value.index()]));
    }
    printed.lines.extend(returned.map(|value| dialect.give_back(&texts[value.index()])));
    printed
}
