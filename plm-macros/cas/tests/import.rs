//! Expressions of one graph in another.
#![allow(clippy::unwrap_used, reason = "tests")]

use plm_cas::{Expr, Graph, Number, Tape};

fn started() -> (Graph, [Expr; 3]) {
    let mut g = Graph::new();
    let symbols = ["x", "y", "x"].map(|name| g.symbol(name));
    (g, symbols)
}

/// Every kind of node, with two symbols of one name.
fn worked_out(g: &mut Graph, [x, y, z]: [Expr; 3]) -> [Expr; 2] {
    let (c, s, root) = (g.cos(x), g.sin(y), g.sqrt(z));
    let half = g.number(Number::rational(1, 2).unwrap());
    let (product, zero) = (g.mul(c, s), g.zero());
    let named = g.define("named", product);
    let sum = g.sum(&[product, root, half, named]);
    let less = g.less(x, zero);
    let chosen = g.select(less, sum, root);
    let quotient = g.div(chosen, z);
    [sum, quotient]
}

#[test]
fn imported_expressions_have_the_same_values() {
    let (mut theirs, symbols) = started();
    let roots = worked_out(&mut theirs, symbols);
    let (mut ours, own) = started();
    // This graph has gone on by itself.
    let w = ours.symbol("w");
    let other = ours.sin(w);
    ours.mul(other, own[1]);
    let copies = ours.import(&theirs, &roots);
    for x in [-0.7, 0.4] {
        let values = |symbols: [Expr; 3]| symbols.into_iter().zip([x, 1.3, 2.5]).collect::<Vec<_>>();
        let expected = Tape::new(&theirs, &roots).eval(&values(symbols)).unwrap();
        assert_eq!(Tape::new(&ours, &copies).eval(&values(own)).unwrap(), expected);
    }
    for (root, copy) in roots.into_iter().zip(&copies) {
        assert_eq!(theirs.display(root).to_string(), ours.display(*copy).to_string());
    }
}

/// What a graph has already is found and not made again.
#[test]
fn what_is_known_is_found() {
    let (mut theirs, symbols) = started();
    let (mut ours, own) = started();
    let product = theirs.mul(symbols[0], symbols[2]);
    let known = ours.mul(own[0], own[2]);
    let length = ours.len();
    assert_eq!(ours.import(&theirs, &[product]), [known]);
    assert_eq!(ours.len(), length);
}
