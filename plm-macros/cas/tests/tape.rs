//! The order and the form of the operations.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use plm_cas::{Count, Graph, Op, Operations, Tape, share};

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
    tape.listing(&g).lines().map(str::to_owned).collect()
}

#[test]
fn sums_run_left_to_right_with_a_positive_term_first() {
    assert_eq!(lowered(&["(- b a)"]), ["t1 = b - a", "out0 = t1"]);
    assert_eq!(lowered(&["(+ (- a) x (- y))"]), ["t1 = x - a", "t2 = t1 - y", "out0 = t2"]);
    assert_eq!(lowered(&["(- 1 x)"]), ["t1 = 1 - x", "out0 = t1"]);
    assert_eq!(lowered(&["(- (- a) b)"]), ["t1 = a + b", "t2 = -t1", "out0 = t2"]);
    assert_eq!(lowered(&["(- (* -2 a) b)"]), ["t1 = -2*a", "t2 = t1 - b", "out0 = t2"]);
    assert_eq!(lowered(&["(- (* a x) (* b y))"]), ["t1 = a*x", "t2 = b*y", "t3 = t1 - t2", "out0 = t3"]);
}

#[test]
fn a_row_and_its_negative_share_what_they_can() {
    assert_eq!(lowered(&["(- a b)", "(- b a)"]), ["t1 = a - b", "t2 = -t1", "out0 = t1", "out1 = t2"]);
    // Within another sum a sign costs nothing.
    assert_eq!(
        lowered(&["(* 3 a)", "(- x (* 3 a))", "(+ x (* -3 a))"]),
        ["t1 = 3*a", "t2 = x - t1", "out0 = t1", "out1 = t2", "out2 = t2"]
    );
    assert_eq!(
        lowered(&["(* -3 a)", "(- x (* 3 a))"]),
        ["t1 = -3*a", "t2 = x + t1", "out0 = t1", "out1 = t2"]
    );
}

#[test]
fn a_sign_goes_into_a_factor_that_turns_for_nothing() {
    assert_eq!(lowered(&["(* -1 x (- a b))"]), ["t1 = b - a", "t2 = x*t1", "out0 = t2"]);
    assert_eq!(lowered(&["(* -1 (/ x (- a b)))"]), ["t1 = b - a", "t2 = x/t1", "out0 = t2"]);
    assert_eq!(lowered(&["(- (/ 1 x))"]), ["t1 = -1/x", "out0 = t1"]);
    // Not if the difference is wanted for itself.
    assert_eq!(
        lowered(&["(- a b)", "(* -1 x (- a b))"]),
        ["t1 = a - b", "t2 = x*t1", "t3 = -t2", "out0 = t1", "out1 = t3"]
    );
}

#[test]
fn coefficients_stand_before_their_product() {
    assert_eq!(lowered(&["(* 100 x y)"]), ["t1 = 100*x", "t2 = t1*y", "out0 = t2"]);
    assert_eq!(lowered(&["(* -100 x y)"]), ["t1 = -100*x", "t2 = t1*y", "out0 = t2"]);
    assert_eq!(lowered(&["(- a (* 100 x y))"]), ["t1 = 100*x", "t2 = t1*y", "t3 = a - t2", "out0 = t3"]);
    // A product that is wanted for itself is multiplied as it stands.
    assert_eq!(lowered(&["(* x y)", "(* 3 x y)"]), ["t1 = x*y", "t2 = 3*t1", "out0 = t1", "out1 = t2"]);
}

#[test]
fn quotients_have_one_division() {
    assert_eq!(
        lowered(&["(/ (* 3 a b) (* x y))"]),
        ["t1 = 3*a", "t2 = t1*b", "t3 = x*y", "t4 = t2/t3", "out0 = t4"]
    );
    assert_eq!(lowered(&["(/ 1 x)"]), ["t1 = 1/x", "out0 = t1"]);
    assert_eq!(lowered(&["(/ 2 x)"]), ["t1 = 2/x", "out0 = t1"]);
    assert_eq!(lowered(&["(- a (/ 1 (^ x 2)))"]), ["t1 = x*x", "t2 = 1/t1", "t3 = a - t2", "out0 = t3"]);
}

#[test]
fn powers_are_multiplied_out() {
    assert_eq!(lowered(&["(^ x 2)"]), ["t1 = x*x", "out0 = t1"]);
    assert_eq!(lowered(&["(* a (^ x 2))"]), ["t1 = a*x", "t2 = t1*x", "out0 = t2"]);
    assert_eq!(lowered(&["(^ x 4)"]), ["t1 = x*x", "t2 = t1*t1", "out0 = t2"]);
    assert_eq!(lowered(&["(^ x 7)"]), ["t1 = x*x", "t2 = x*t1", "t3 = t1*t1", "t4 = t2*t3", "out0 = t4"]);
    assert_eq!(lowered(&["(* (^ x 2) (^ y 2))"]), ["t1 = x*y", "t2 = t1*t1", "out0 = t2"]);
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
    assert_eq!(tape.count().operations.sin_cos, 2);
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
    assert_eq!(tape.inputs(), [x, a]);
    assert_eq!(tape.eval(&[(a, 2.0), (x, 3.0)]), Ok(vec![27.0, 18.0]));
    assert_eq!(tape.eval(&[(x, 3.0)]), Err(a));
}

#[test]
fn operations_of_all_kinds_add_up() {
    let kinds = |at: [u32; 8]| {
        let [add, mul, div, neg, sqrt, sin_cos, select, other] = at;
        let operations = Operations { add: add + neg, mul, div, sqrt, sin_cos, other: select + other };
        Count { operations, neg, select }
    };
    let (ones, powers) = (kinds([1; 8]), kinds([1, 2, 4, 8, 16, 32, 64, 128]));
    assert_eq!((ones.total(), powers.total()), (8, 255));
    assert_eq!(ones + powers, kinds([2, 3, 5, 9, 17, 33, 65, 129]));
    let told = "1 add, 2 mul, 4 div, 8 neg, 16 sqrt, 32 sin_cos, 64 select, 128 other";
    assert_eq!((powers.to_string().as_str(), Count::default().to_string().as_str()), (told, "none"));
}

#[test]
fn sub_sums_are_shared_up_to_sign_and_scale() {
    assert_eq!(
        shared(&["(+ a x (- b))", "(+ y (- x) b)"]),
        ["t1 = b - x", "t2 = a - t1", "t3 = y + t1", "out0 = t2", "out1 = t3"]
    );
    assert_eq!(
        shared(&["(+ a (* 2 x) (* 6 y))", "(+ b x (* 3 y))"]).len(),
        // 3*y, x + 3*y, twice it, two sums, two outputs
        7
    );
    // Quotients by the smallest numbers are all infinite, and so no scale: these sums are not one.
    let tiny = "5e-324";
    let texts = [format!("(+ {tiny} (* 2 x))"), format!("(+ {tiny} (* 3 x))")];
    assert_eq!(shared(&texts.each_ref().map(String::as_str)).len(), 6);
    // The pair that is an expression of its own keeps its node.
    assert_eq!(
        shared(&["(- x y)", "(+ a (- x y))"]),
        ["t1 = x - y", "t2 = a + t1", "out0 = t1", "out1 = t2"]
    );
}

/// What a pair leaves is paired again, within one pass.
#[test]
fn what_five_terms_have_in_common_is_summed_once() {
    let listing = shared(&["(+ a b x y (sin a) (sin b))", "(+ a b x y (sin a) (sin x))"]);
    assert_eq!(listing.iter().filter(|line| line.contains(" + ")).count(), 4 + 2, "{listing:?}");
}

#[test]
fn sub_products_are_shared() {
    assert_eq!(
        shared(&["(* a x y)", "(* b x y)"]),
        ["t1 = x*y", "t2 = a*t1", "t3 = b*t1", "out0 = t2", "out1 = t3"]
    );
    assert_eq!(
        shared(&["(* a (^ x 2))", "(* b (^ x 2))"]),
        ["t1 = x*x", "t2 = a*t1", "t3 = b*t1", "out0 = t2", "out1 = t3"]
    );
}

#[test]
fn common_factors_leave_sums() {
    assert_eq!(shared(&["(+ (* a x) (* b x))"]), ["t1 = a + b", "t2 = x*t1", "out0 = t2"]);
    assert_eq!(shared(&["(+ (* 2 a) (* -2 b) x)"]), ["t1 = a - b", "t2 = 2*t1", "t3 = x + t2", "out0 = t3"]);
    assert_eq!(shared(&["(+ (/ a x) (/ b x))"]), ["t1 = a + b", "t2 = t1/x", "out0 = t2"]);
    assert_eq!(shared(&["(+ (/ a x) (/ 1 x))"]), ["t1 = a + 1", "t2 = t1/x", "out0 = t2"]);
    // Not out of a product that is wanted for itself.
    assert_eq!(shared(&["(* a x)", "(* b x)", "(+ (* a x) (* b x))"]).len(), 6);
}

#[test]
fn coefficients_go_into_sums_that_have_no_term_without_one() {
    let expected = ["t1 = 200*a", "t2 = 300*b", "t3 = t1 - t2", "out0 = t3"];
    assert_eq!(shared(&["(* 100 (- (* 2 a) (* 3 b)))"]), expected);
    let expected = ["t1 = 200*a", "t2 = 300*b", "t3 = t1 - t2", "t4 = x*t3", "out0 = t4"];
    assert_eq!(shared(&["(* 100 x (- (* 2 a) (* 3 b)))"]), expected);
    assert_eq!(shared(&["(* 100 (+ a (* 3 b)))"]), ["t1 = 3*b", "t2 = a + t1", "t3 = 100*t2", "out0 = t3"]);
}

#[test]
fn a_divisor_of_several_quotients_is_inverted_once() {
    assert_eq!(
        shared(&["(/ a x)", "(/ b x)"]),
        ["t1 = 1/x", "t2 = a*t1", "t3 = b*t1", "out0 = t2", "out1 = t3"]
    );
    assert_eq!(shared(&["(/ a x)"]), ["t1 = a/x", "out0 = t1"]);
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
    assert_eq!(names, ["a", "b", "x", "part", "pivot"]);
}

/// Sums that begin with the sum before, as they are and shared: their operations and values.
fn summed_up(steps: usize) -> (usize, Vec<f64>, Vec<f64>) {
    let mut g = Graph::new();
    let x = g.symbol("x");
    let (mut last, mut roots) = (x, Vec::new());
    for k in 0..steps {
        // Constants and signs differ from sum to sum.
        let (square, constant) = (g.powi(last, 2), g.int(k as i64 % 3 - 1));
        last = g.sum(&[last, square, constant]);
        roots.push(if k % 2 == 0 { last } else { g.neg(last) });
    }
    let plain = Tape::new(&g, &roots);
    let roots = share(&mut g, &roots);
    let shared = Tape::new(&g, &roots);
    let at = [(x, 0.3)];
    (shared.count().total(), plain.eval(&at).unwrap(), shared.eval(&at).unwrap())
}

#[test]
fn sums_of_sums_are_summed_once() {
    let [(some, ..), (twice, ..), (thrice, direct, shared)] = [40, 80, 120].map(summed_up);
    assert!(thrice - twice <= twice - some + 2, "{some}, {twice}, {thrice}");
    for (k, (direct, shared)) in direct.iter().zip(&shared).enumerate().take(12) {
        assert!((direct - shared).abs() <= 1e-12 * direct.abs().max(1.0), "{k}: {direct} and {shared}");
    }
}

#[test]
fn exponents_that_are_too_large_stay_apart() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol("x"), g.symbol("y"));
    let (mut a, mut b) = (x, y);
    let (mut log_a, mut log_b) = (0.999_999_f64.ln(), 1.000_000_5_f64.ln());
    for _ in 0..14 {
        (a, b) = (g.product(&[a, a, b]), g.product(&[b, b, a]));
        (log_a, log_b) = (2.0 * log_a + log_b, 2.0 * log_b + log_a);
    }
    let squared = (0..12).fold(a, |a, _| g.powi(a, 3));
    let before = g.len();
    let most = (0..20).fold(squared, |a, _| g.mul(a, a));
    assert!(g.len() - before < 100, "{}", g.len() - before);
    let tape = Tape::new(&g, &[a, most]);
    let found = tape.eval(&[(x, 0.999_999), (y, 1.000_000_5)]).unwrap();
    assert!((found[0] - log_a.exp()).abs() < 1e-8 * log_a.exp(), "{found:?}");
}
