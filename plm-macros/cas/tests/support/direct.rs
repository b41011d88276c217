//! Evaluation by the definitions, with the functions of std: of a text in prefix form, which no constructor has
//! touched, and of nodes one by one, which no lowering has touched.

use std::collections::BTreeMap;

use plm_cas::{Expr, Function, Graph, Node};

pub(crate) fn function(function: Function, a: &[f64]) -> f64 {
    match function {
        Function::Sin => a[0].sin(),
        Function::Cos => a[0].cos(),
        Function::Asin => a[0].asin(),
        Function::Acos => a[0].acos(),
        Function::Atan2 => a[0].atan2(a[1]),
        Function::Sqrt => a[0].sqrt(),
        Function::Exp => a[0].exp(),
        Function::Ln => a[0].ln(),
        Function::Abs => a[0].abs(),
        Function::Sign if a[0] > 0.0 => 1.0,
        Function::Sign if a[0] < 0.0 => -1.0,
        Function::Sign => a[0],
        Function::Floor => a[0].floor() + 0.0,
        Function::Min => {
            if a[0] < a[1] {
                a[0]
            } else {
                a[1]
            }
        }
        Function::Max => {
            if a[0] > a[1] {
                a[0]
            } else {
                a[1]
            }
        }
    }
}

/// Evaluates a text with the variables x, y, z.
pub(crate) fn text(text: &str, xyz: [f64; 3]) -> f64 {
    let spaced = text.replace('(', " ( ").replace(')', " ) ");
    let mut tokens = spaced.split_whitespace().peekable();
    read(&mut tokens, xyz)
}

fn read<'a>(tokens: &mut std::iter::Peekable<impl Iterator<Item = &'a str>>, xyz: [f64; 3]) -> f64 {
    let token = tokens.next().unwrap();
    if token != "(" {
        return atom(token, xyz);
    }
    let head = tokens.next().unwrap();
    let mut operands = Vec::new();
    while *tokens.peek().unwrap() != ")" {
        operands.push(read(tokens, xyz));
    }
    tokens.next();
    apply(head, &operands)
}

fn atom(token: &str, xyz: [f64; 3]) -> f64 {
    match token {
        "x" => xyz[0],
        "y" => xyz[1],
        "z" => xyz[2],
        "pi" => std::f64::consts::PI,
        _ => match token.split_once('/') {
            Some((above, below)) => above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap(),
            None => token.parse().unwrap(),
        },
    }
}

fn apply(head: &str, a: &[f64]) -> f64 {
    match (head, a) {
        ("+", _) => a.iter().sum(),
        ("*", _) => a.iter().product(),
        ("-", [x]) => -x,
        ("-", [x, y]) => x - y,
        ("/", [x, y]) => x / y,
        ("^", [x, n]) => x.powi(*n as i32),
        ("tan", [x]) => x.tan(),
        ("<", [x, y]) => f64::from(u8::from(x < y)),
        ("if", [condition, x, y]) => {
            if *condition > 0.0 {
                *x
            } else {
                *y
            }
        }
        _ => function(Function::ALL.into_iter().find(|f| f.name() == head).unwrap(), a),
    }
}

/// Evaluates expressions by their nodes.
pub(crate) fn nodes(graph: &Graph, roots: &[Expr], bindings: &[(Expr, f64)]) -> Vec<f64> {
    let mut known: BTreeMap<Expr, f64> = bindings.iter().copied().collect();
    let mut open: Vec<Expr> = roots.to_vec();
    while let Some(&e) = open.last() {
        let missing: Vec<Expr> =
            operands(graph.node(e)).into_iter().filter(|o| !known.contains_key(o)).collect();
        if known.contains_key(&e) {
            open.pop();
        } else if missing.is_empty() {
            open.pop();
            let value = node(graph.node(e), &known);
            known.insert(e, value);
        } else {
            open.extend(missing);
        }
    }
    roots.iter().map(|root| known[root]).collect()
}

fn operands(node: &Node) -> Vec<Expr> {
    match node {
        Node::Number(_) | Node::Symbol => vec![],
        Node::Defined(value) => vec![*value],
        Node::Sum { terms, .. } => terms.iter().map(|t| t.1).collect(),
        Node::Product(factors) => factors.iter().map(|f| f.0).collect(),
        Node::Call(_, arguments) => arguments.to_vec(),
        Node::Less(a, b) => vec![*a, *b],
        Node::Select(c, a, b) => vec![*c, *a, *b],
    }
}

fn node(node: &Node, known: &BTreeMap<Expr, f64>) -> f64 {
    let at = |e: &Expr| known[e];
    match node {
        Node::Number(number) => number.to_f64(),
        Node::Symbol => panic!("a symbol without a value"),
        Node::Defined(value) => at(value),
        Node::Sum { constant, terms } => {
            terms.iter().fold(constant.to_f64(), |sum, (c, e)| sum + c.to_f64() * at(e))
        }
        Node::Product(factors) => factors.iter().map(|(e, n)| at(e).powi(*n)).product(),
        Node::Call(f, arguments) => function(*f, &arguments.iter().map(at).collect::<Vec<_>>()),
        Node::Less(a, b) => f64::from(u8::from(at(a) < at(b))),
        Node::Select(c, a, b) => {
            if at(c) == 0.0 {
                at(b)
            } else {
                at(a)
            }
        }
    }
}
