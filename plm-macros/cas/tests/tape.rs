//! The order and the form of the operations.
#![allow(clippy::unwrap_used, clippy::panic)]

use plm_cas::{Graph, Op, Tape, share};

/// Reads prefix expressions over a, b, x, y, lowers them as they are, and lists the operations.
fn lowered(texts: &[&str]) -> Vec<String> {
    list(texts, false)
}

fn shared(texts: &[&str]) -> Vec<String> {
    list(texts, true)
}

fn list(texts: &[&str], sharing: bool) -> Vec<String> {
    let mut g = Graph::new();
    for name in ["a", "b", "x", "y"] {
        g.symbol(name);
    }
    let mut roots: Vec<_> = texts.iter().map(|text| g.parse_sexpr(text).unwrap()).collect();
    if sharing {
        roots = share(&mut g, &roots);
    }
    let tape = Tape::new(&g, &roots);
    // The positions of inputs and constants are no concern here: number the steps.
    let mut listing = tape.listing(&g);
    let mut step = 0;
    for i in 0..tape.ops.len() {
        if listing.contains(&format!("t{i} =")) {
            step += 1;
            for end in [" ", "\n", ",", ")", "*", "/"] {
                listing = listing.replace(&format!("t{i}{end}"), &format!("s{step}{end}"));
            }
        }
    }
    listing.lines().map(str::to_owned).collect()
}

#[test]
fn sums_run_left_to_right_with_a_positive_term_first() {
    assert_eq!(lowered(&["(- b a)"]), ["s1 = b - a", "out0 = s1"]);
    assert_eq!(lowered(&["(+ (- a) x (- y))"]), ["s1 = x - a", "s2 = s1 - y", "out0 = s2"]);
    assert_eq!(lowered(&["(- 1 x)"]), ["s1 = 1 - x", "out0 = s1"]);
    assert_eq!(lowered(&["(- (- a) b)"]), ["s1 = a + b", "s2 = -s1", "out0 = s2"]);
    assert_eq!(lowered(&["(- (* -2 a) b)"]), ["s1 = -2*a", "s2 = s1 - b", "out0 = s2"]);
    assert_eq!(lowered(&["(- (* a x) (* b y))"]), ["s1 = a*x", "s2 = b*y", "s3 = s1 - s2", "out0 = s3"]);
}

#[test]
fn a_row_and_its_negative_share_what_they_can() {
    assert_eq!(lowered(&["(- a b)", "(- b a)"]), ["s1 = a - b", "s2 = -s1", "out0 = s1", "out1 = s2"]);
    // Within another sum a sign costs nothing.
    assert_eq!(
        lowered(&["(* 3 a)", "(- x (* 3 a))", "(+ x (* -3 a))"]),
        ["s1 = 3*a", "s2 = x - s1", "out0 = s1", "out1 = s2", "out2 = s2"]
    );
    assert_eq!(
        lowered(&["(* -3 a)", "(- x (* 3 a))"]),
        ["s1 = -3*a", "s2 = x + s1", "out0 = s1", "out1 = s2"]
    );
}

#[test]
fn a_sign_goes_into_a_factor_that_turns_for_nothing() {
    assert_eq!(lowered(&["(* -1 x (- a b))"]), ["s1 = b - a", "s2 = x*s1", "out0 = s2"]);
    assert_eq!(lowered(&["(* -1 (/ x (- a b)))"]), ["s1 = b - a", "s2 = x/s1", "out0 = s2"]);
    assert_eq!(lowered(&["(- (/ 1 x))"]), ["s1 = -1/x", "out0 = s1"]);
    // Not if the difference is wanted for itself.
    assert_eq!(
        lowered(&["(- a b)", "(* -1 x (- a b))"]),
        ["s1 = a - b", "s2 = x*s1", "s3 = -s2", "out0 = s1", "out1 = s3"]
    );
}

#[test]
fn coefficients_stand_before_their_product() {
    assert_eq!(lowered(&["(* 100 x y)"]), ["s1 = 100*x", "s2 = s1*y", "out0 = s2"]);
    assert_eq!(lowered(&["(* -100 x y)"]), ["s1 = -100*x", "s2 = s1*y", "out0 = s2"]);
    assert_eq!(lowered(&["(- a (* 100 x y))"]), ["s1 = 100*x", "s2 = s1*y", "s3 = a - s2", "out0 = s3"]);
    // A product that is wanted for itself is multiplied as it stands.
    assert_eq!(lowered(&["(* x y)", "(* 3 x y)"]), ["s1 = x*y", "s2 = 3*s1", "out0 = s1", "out1 = s2"]);
}

#[test]
fn quotients_have_one_division() {
    assert_eq!(
        lowered(&["(/ (* 3 a b) (* x y))"]),
        ["s1 = 3*a", "s2 = s1*b", "s3 = x*y", "s4 = s2/s3", "out0 = s4"]
    );
    assert_eq!(lowered(&["(/ 1 x)"]), ["s1 = 1/x", "out0 = s1"]);
    assert_eq!(lowered(&["(/ 2 x)"]), ["s1 = 2/x", "out0 = s1"]);
    assert_eq!(lowered(&["(- a (/ 1 (^ x 2)))"]), ["s1 = x*x", "s2 = 1/s1", "s3 = a - s2", "out0 = s3"]);
}

#[test]
fn powers_are_multiplied_out() {
    assert_eq!(lowered(&["(^ x 2)"]), ["s1 = x*x", "out0 = s1"]);
    assert_eq!(lowered(&["(* a (^ x 2))"]), ["s1 = a*x", "s2 = s1*x", "out0 = s2"]);
    assert_eq!(lowered(&["(^ x 4)"]), ["s1 = x*x", "s2 = s1*s1", "out0 = s2"]);
    assert_eq!(lowered(&["(^ x 7)"]), ["s1 = x*x", "s2 = x*s1", "s3 = s1*s1", "s4 = s2*s3", "out0 = s4"]);
    assert_eq!(lowered(&["(* (^ x 2) (^ y 2))"]), ["s1 = x*y", "s2 = s1*s1", "out0 = s2"]);
    let g = Graph::new();
    assert_eq!(Tape::new(&g, &[g.one()]).count().total(), 0);
}

#[test]
fn sine_and_cosine_stand_side_by_side_and_count_once() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol("x"), g.symbol("y"));
    let cosine = g.cos(x);
    let product = g.mul(cosine, y);
    let sine = g.sin(x);
    let lonely = g.cos(y);
    let tape = Tape::new(&g, &[product, lonely, sine]);
    let at = tape.ops.iter().position(|instr| matches!(instr.op, Op::Sin(_))).unwrap();
    let Op::Sin(angle) = tape.ops[at].op else { panic!() };
    assert_eq!(tape.ops[at + 1].op, Op::Cos(angle));
    assert_eq!(tape.count().sin_cos, 2);
    assert_eq!(tape.count().to_string(), "1 mul, 2 sin_cos");
}

#[test]
fn instructions_know_what_they_compute_and_for_how_many() {
    let mut g = Graph::new();
    let (a, x) = (g.symbol("a"), g.symbol("x"));
    let square = g.powi(x, 2);
    g.hint(square, "x_squared");
    let product = g.mul(a, square);
    let atom = g.define("force", product);
    let sum = g.add(atom, square);
    let tape = Tape::new(&g, &[sum, atom]);
    assert_eq!(tape.listing(&g).lines().next().unwrap(), "x_squared = x*x");
    let force = &tape.ops[tape.outputs[1].index()];
    assert_eq!((force.expr, force.uses), (Some(atom), 2));
    assert_eq!(tape.inputs(), [a, x]);
    assert_eq!(tape.eval(&[(a, 2.0), (x, 3.0)]), Ok(vec![27.0, 18.0]));
    assert_eq!(tape.eval(&[(x, 3.0)]), Err(a));
}

#[test]
fn sub_sums_are_shared_up_to_sign_and_scale() {
    assert_eq!(
        shared(&["(+ a x (- b))", "(+ y (- x) b)"]),
        ["s1 = b - x", "s2 = a - s1", "s3 = y + s1", "out0 = s2", "out1 = s3"]
    );
    assert_eq!(
        shared(&["(+ a (* 2 x) (* 6 y))", "(+ b x (* 3 y))"]).len(),
        // 3*y, x + 3*y, twice it, two sums, two outputs
        7
    );
    // The pair that is an expression of its own keeps its node.
    assert_eq!(
        shared(&["(- x y)", "(+ a (- x y))"]),
        ["s1 = x - y", "s2 = a + s1", "out0 = s1", "out1 = s2"]
    );
}

#[test]
fn sub_products_are_shared() {
    assert_eq!(
        shared(&["(* a x y)", "(* b x y)"]),
        ["s1 = x*y", "s2 = a*s1", "s3 = b*s1", "out0 = s2", "out1 = s3"]
    );
    assert_eq!(
        shared(&["(* a (^ x 2))", "(* b (^ x 2))"]),
        ["s1 = x*x", "s2 = a*s1", "s3 = b*s1", "out0 = s2", "out1 = s3"]
    );
}

#[test]
fn common_factors_leave_sums() {
    assert_eq!(shared(&["(+ (* a x) (* b x))"]), ["s1 = a + b", "s2 = x*s1", "out0 = s2"]);
    assert_eq!(shared(&["(+ (* 2 a) (* -2 b) x)"]), ["s1 = a - b", "s2 = 2*s1", "s3 = x + s2", "out0 = s3"]);
    assert_eq!(shared(&["(+ (/ a x) (/ b x))"]), ["s1 = a + b", "s2 = s1/x", "out0 = s2"]);
    // Not out of a product that is wanted for itself.
    assert_eq!(shared(&["(* a x)", "(* b x)", "(+ (* a x) (* b x))"]).len(), 6);
}

#[test]
fn a_divisor_of_several_quotients_is_inverted_once() {
    assert_eq!(
        shared(&["(/ a x)", "(/ b x)"]),
        ["s1 = 1/x", "s2 = a*s1", "s3 = b*s1", "out0 = s2", "out1 = s3"]
    );
    assert_eq!(shared(&["(/ a x)"]), ["s1 = a/x", "out0 = s1"]);
}

#[test]
fn defined_atoms_keep_their_names_through_sharing() {
    let mut g = Graph::new();
    let (a, b, x) = (g.symbol("a"), g.symbol("b"), g.symbol("x"));
    let sum = g.sum(&[a, b, x]);
    let pivot = g.define("pivot", sum);
    let quotient = g.div(a, pivot);
    let part = g.add(a, x);
    g.hint(part, "part");
    let roots = share(&mut g, &[quotient, part]);
    let tape = Tape::new(&g, &roots);
    let names: Vec<_> = tape.ops.iter().filter_map(|i| g.name(i.expr?)).collect();
    assert_eq!(names, ["a", "x", "part", "b", "pivot"]);
}
