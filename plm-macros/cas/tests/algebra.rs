//! Operators of expressions: the constructors of the graph by other names.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use plm_cas::{Expr, Graph, Rotation, Tape, Vec2};

#[test]
fn operators_are_the_constructors() {
    let mut written = Graph::new();
    let (x, y) = (written.symbol("x"), written.symbol("y"));
    let two = written.int(2);
    let sum = written.add(x, y);
    let product = written.mul(two, sum);
    let difference = written.sub(product, x);
    let quotient = written.div(difference, y);
    let square = written.powi(quotient, 2);
    let zero = written.zero();
    let positive = written.less(zero, square);
    let negated = written.neg(x);
    let chosen = written.select(positive, negated, y);
    let expected = written.define("chosen", chosen);

    let mut entered = Graph::new();
    let found = entered.enter(|| {
        let (x, y) = (Expr::symbol("x"), Expr::symbol("y"));
        let square = ((2 * (x + y) - x) / y).squared();
        Expr::ZERO.less(square).select(-x, y).named("chosen")
    });
    assert_eq!(entered.sexpr(found), written.sexpr(expected));
    // Node by node, so that the order of terms, and with it the bits, are the same.
    assert_eq!((found, entered.len()), (expected, written.len()));
}

#[test]
fn a_graph_that_was_entered_is_left_again() {
    let (mut outer, mut inner) = (Graph::new(), Graph::new());
    let name = outer.enter(|| {
        let x = Expr::symbol("outer");
        let y = inner.enter(|| Expr::symbol("inner"));
        assert_eq!(x, y, "two graphs count by themselves");
        let fails = std::panic::catch_unwind(core::panic::AssertUnwindSafe(|| {
            inner.enter(|| -> Expr { std::panic::panic_any("a bug") })
        }));
        assert!(fails.is_err());
        x.name()
    });
    assert_eq!(name.as_deref(), Some("outer"));
    assert_eq!(inner.find_name("inner").and_then(|e| inner.name(e)), Some("inner"));
}

#[test]
fn vectors_turn_as_numbers_do() {
    let mut graph = Graph::new();
    let mut symbols = Vec::new();
    let roots = graph.enter(|| {
        symbols = ["a", "b", "c", "d", "angle"].map(Expr::symbol).to_vec();
        let [u, w] = [Vec2::new(symbols[0], symbols[1]), Vec2::new(symbols[2], symbols[3])];
        let turn = Rotation::by(symbols[4]);
        let both = Rotation::between(u, w);
        let there_and_back = turn.inverse() * (turn * u);
        let twice = (turn * turn) * w - turn * (turn * w);
        let taken = both * u - u.squared() * w;
        let quarter = u.left().dot(w) - u.cross(w);
        [there_and_back - u, twice, taken]
            .map(Vec2::components)
            .concat()
            .into_iter()
            .chain([quarter])
            .collect::<Vec<_>>()
    });
    let values = [0.3, -1.7, 2.1, 0.9, 0.7];
    let bindings: Vec<(Expr, f64)> = symbols.into_iter().zip(values).collect();
    for (k, value) in Tape::new(&graph, &roots).eval(&bindings).unwrap().into_iter().enumerate() {
        assert!(value.abs() < 1e-14, "{k}: {value:e}");
    }
}
