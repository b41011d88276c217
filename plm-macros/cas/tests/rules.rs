//! The table of rules, applied: each pattern becomes its result, and both have the same value wherever the
//! condition of the rule holds, 0, -0, infinities and NaN included.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod support;

use plm_cas::{Condition, Graph, RULES, Tape, share};
use support::{close, direct};

const POINTS: [f64; 11] =
    [0.0, -0.0, 1.0, -1.0, 0.5, -0.75, 2.0, -3.25, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

fn xyz() -> Graph {
    let mut graph = Graph::new();
    for name in ["x", "y", "z"] {
        graph.symbol(name);
    }
    graph
}

#[test]
fn every_pattern_becomes_its_result() {
    for rule in RULES {
        let mut g = xyz();
        let result = g.parse_sexpr(rule.result).unwrap();
        let pattern = g.parse_sexpr(rule.pattern).unwrap();
        assert_eq!(g.sexpr(pattern), g.sexpr(result), "{}", rule.name);
        assert_eq!(pattern, result, "{}", rule.name);
    }
}

#[test]
fn every_rule_keeps_the_value_where_its_condition_holds() {
    for rule in RULES {
        let mut tried = 0;
        for x in POINTS {
            for y in POINTS {
                for z in [POINTS[4], POINTS[0], POINTS[7], POINTS[8], POINTS[10]] {
                    if !rule.condition.holds(&[x, y, z]) {
                        continue;
                    }
                    tried += 1;
                    let (before, after) =
                        (direct::text(rule.pattern, [x, y, z]), direct::text(rule.result, [x, y, z]));
                    // Some ten roundings each.
                    assert!(close(before, after, 1e-14), "{} at {x}, {y}, {z}: {before} {after}", rule.name);
                }
            }
        }
        assert!(tried > 0, "{}", rule.name);
    }
}

/// The other half of the comparison: what the constructors made, lowered and run, at the same points.
#[test]
fn the_tape_of_every_result_has_its_value() {
    for rule in RULES {
        let mut g = xyz();
        let result = g.parse_sexpr(rule.pattern).unwrap();
        let tape = Tape::new(&g, &[result]);
        let symbols = ["x", "y", "z"].map(|name| g.find_name(name).unwrap());
        for x in POINTS {
            for y in POINTS {
                let point = [x, y, 0.25];
                let bindings: Vec<_> = symbols.iter().copied().zip(point).collect();
                let (expected, found) = (direct::text(rule.result, point), tape.eval(&bindings).unwrap()[0]);
                assert!(close(expected, found, 1e-14), "{} at {x}, {y}: {expected} {found}", rule.name);
            }
        }
    }
}

/// A condition stands there because the rule fails without it.
#[test]
fn every_condition_is_needed() {
    let exceptions = ["inverse of an inverse"]; // 1/(1/0) happens to be 0
    for rule in RULES.iter().filter(|rule| rule.condition != Condition::Always) {
        let fails = |x: f64, y: f64, z: f64| {
            !rule.condition.holds(&[x, y, z])
                && !close(direct::text(rule.pattern, [x, y, z]), direct::text(rule.result, [x, y, z]), 1e-14)
        };
        let found = POINTS.iter().any(|&x| POINTS.iter().any(|&y| POINTS.iter().any(|&z| fails(x, y, z))));
        assert!(found || exceptions.contains(&rule.name), "{}", rule.name);
    }
}

/// Expressions that look like the pattern of a rule and are none: whatever the constructors make of them, it has their value.
const BESIDE: [&str; 30] = [
    // Pythagoras asks for one coefficient, one factor, one angle, one sign and squares.
    "(+ (* 2 (^ (sin x) 2)) (* 3 (^ (cos x) 2)))",
    "(+ (* 2 y (^ (sin x) 2)) (* 3 y (^ (cos x) 2)))",
    "(+ (* y (^ (sin x) 2)) (* z (^ (cos x) 2)))",
    "(+ (^ (sin x) 2) (^ (cos y) 2))",
    "(- (^ (sin x) 2) (^ (cos x) 2))",
    "(+ (^ (sin x) 2) (^ (cos x) 4))",
    "(+ (sin x) (cos x))",
    // Constant angles.
    "(sin (+ (* 2 x) 1/3))",
    "(cos (+ x y pi))",
    "(sin (+ x y (* 1/3 pi)))",
    // Functions of both signs keep their magnitude.
    "(abs (asin x))",
    "(abs (sin x))",
    "(abs (ln (+ 4 x)))",
    "(abs (atan2 (+ x 1/8) 2))",
    "(abs (^ x 3))",
    "(abs (* x (sin y)))",
    "(abs (* x (asin (* 1/4 y)) (exp z)))",
    // Powers that are negative, odd, or of a root.
    "(^ (abs x) -2)",
    "(^ (abs x) -3)",
    "(^ (sqrt (+ 4 x)) -4)",
    "(sqrt (^ x 6))",
    "(sqrt (* x x y))",
    "(^ (* x y) -2)",
    // What is divided by a product, or by a quotient.
    "(/ x (* y z))",
    "(/ 2 (* 3 x y))",
    "(/ x (/ y z))",
    "(- x (/ y (* 5 z)))",
    // An inverse in one direction only.
    "(asin (sin (* 3 x)))",
    "(acos (cos (* 3 x)))",
    "(sign (+ x (* 2 y)))",
];

#[test]
fn what_resembles_a_pattern_keeps_its_value() {
    let points = POINTS.into_iter().filter(|point| point.is_finite());
    for text in BESIDE {
        let mut g = xyz();
        let made = g.parse_sexpr(text).unwrap();
        let shared = share(&mut g, &[made]);
        let tapes = [Tape::new(&g, &[made]), Tape::new(&g, &shared)];
        let symbols = ["x", "y", "z"].map(|name| g.find_name(name).unwrap());
        for x in points.clone() {
            for y in points.clone() {
                let point = [x, y, 0.25];
                let bindings: Vec<_> = symbols.into_iter().zip(point).collect();
                let expected = direct::text(text, point);
                for tape in &tapes {
                    let found = tape.eval(&bindings).unwrap()[0];
                    // Some ten roundings each.
                    assert!(close(expected, found, 1e-13), "{text} at {point:?}: {expected} {found}");
                }
            }
        }
    }
}

#[test]
fn what_is_printed_reads_back() {
    for rule in RULES {
        let mut g = xyz();
        for text in [rule.pattern, rule.result] {
            let e = g.parse_sexpr(text).unwrap();
            let printed = g.sexpr(e);
            assert_eq!(g.parse_sexpr(&printed).unwrap(), e, "{text} {printed}");
        }
    }
}

#[test]
fn rules_have_different_names() {
    let mut names: Vec<_> = RULES.iter().map(|rule| rule.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), RULES.len());
}
