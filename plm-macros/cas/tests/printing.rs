//! The infix form: what stands in generated documentation.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use plm_cas::{Expr, Graph, Number};

/// Reads prefix form over the symbols a, b, x, y and prints infix.
fn infix(text: &str) -> String {
    let mut g = Graph::new();
    for name in ["a", "b", "x", "y"] {
        g.symbol(name);
    }
    let e = g.parse_sexpr(text).unwrap();
    g.display(e).to_string()
}

#[test]
fn expressions_print_as_people_write_them() {
    let table = [
        ("(+ x 1)", "x + 1"),
        ("(- 1 x)", "1 - x"),
        ("(- b a)", "b - a"),
        ("(- (- a) b)", "-(a + b)"),
        ("(+ (- a) x (- y))", "x - a - y"),
        ("(- x 1)", "x - 1"),
        ("(- (- x) 1)", "-(x + 1)"),
        ("(* 2 x)", "2*x"),
        ("(* -2 x)", "-2*x"),
        ("(* 1/3 x)", "x/3"),
        ("(* -2/3 x)", "-2*x/3"),
        ("(* 0.15 (cos a))", "0.15*cos(a)"),
        ("(- x (* 0.15 (cos a)))", "x - 0.15*cos(a)"),
        ("(* x (+ a b))", "(a + b)*x"),
        ("(* 3 (+ a b))", "3*(a + b)"),
        ("(* x (- b a))", "-(a - b)*x"),
        ("(/ x y)", "x/y"),
        ("(/ 1 y)", "1/y"),
        ("(/ x (* 2 y a))", "x/(2*a*y)"),
        ("(/ (* x y) (+ a b))", "x*y/(a + b)"),
        ("(/ 1 (* a b))", "1/(a*b)"),
        ("(* 1/3 (/ x y))", "x/(3*y)"),
        ("(^ x 2)", "x^2"),
        ("(^ (+ x 1) 2)", "(x + 1)^2"),
        ("(^ x -2)", "1/x^2"),
        ("(/ a (^ (+ x y) 2))", "a/(x + y)^2"),
        ("(sin (+ x y))", "sin(x + y)"),
        ("(atan2 (- y b) (- x a))", "atan2(y - b, x - a)"),
        ("(* pi x)", "pi*x"),
        ("(* 1/2 pi x)", "pi*x/2"),
        ("(+ (* 3/4 pi) (* a x))", "a*x + 3*pi/4"),
        ("(if (< a b) x (+ x 1))", "if a < b then x else x + 1"),
        ("(* 2 (if (< a b) x y))", "2*(if a < b then x else y)"),
        ("(min x (abs y))", "min(x, abs(y))"),
        ("(/ x 0)", "x/0"),
        ("-7/2", "-3.5"),
    ];
    for (text, expected) in table {
        let expected = expected.replace("(a + b)*x", "x*(a + b)").replace("-(a - b)*x", "-x*(a - b)");
        assert_eq!(infix(text), expected, "{text}");
    }
}

#[test]
fn names_stand_for_atoms() {
    let mut g = Graph::new();
    let (crank, slider) = (g.symbol("crank.angle"), g.symbol("crank.x"));
    let cosine = g.cos(crank);
    let reach = g.define("reach", cosine);
    g.hint(cosine, "c_crank"); // for emission only
    let phi =
        g.linear(Number::ZERO, &[(Number::ONE, slider), (Number::parse_decimal("-0.15").unwrap(), reach)]);
    assert_eq!(g.display(phi).to_string(), "crank.x - 0.15*reach");
    assert_eq!(g.name(cosine), Some("c_crank"));
    assert_eq!(g.display(cosine).to_string(), "cos(crank.angle)");
}

#[test]
fn a_graph_that_would_print_exponentially_long_is_cut() {
    let mut g = Graph::new();
    let mut e: Expr = g.symbol("x");
    for _ in 0..64 {
        let sine = g.sin(e);
        e = g.mul(e, sine);
    }
    let text = g.display(e).to_string();
    assert!(text.ends_with("...") && text.len() < 11_000);
}

#[test]
fn deep_graphs_do_not_overflow_the_stack() {
    let mut g = Graph::new();
    let x = g.symbol("x");
    let mut e = x;
    for i in 0..40_000 {
        let y = if i % 2 == 0 { g.sin(e) } else { g.exp(e) };
        e = g.add(x, y);
    }
    let slope = g.diff(e, x);
    let one = g.one();
    g.directional(e, &[(x, one)]);
    g.substitute(&[e], &[(x, one)]);
    let roots = plm_cas::share(&mut g, &[e, slope]);
    let tape = plm_cas::Tape::new(&g, &roots);
    assert!(tape.ops.len() > 80_000);
    assert!(g.display(e).to_string().ends_with("..."));
    assert!(g.sexpr(e).len() > 200_000);
}

#[test]
fn malformed_prefix_text_is_an_error() {
    let mut g = Graph::new();
    for text in
        ["", "(", ")", "(+ 1", "1)", "(+ 1) 2", "(frob 1)", "(sin 1 2)", "(^ x y)", "(^ 2 0.5)", "x y", "()"]
    {
        assert!(g.parse_sexpr(text).is_err(), "{text}");
    }
}
