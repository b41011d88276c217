//! Derivatives against differences: every function, every kind of node, random expressions, gradients and total
//! time derivatives.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod support;

use plm_cas::{Expr, Function, Graph, Number};
use support::random::{Random, grow};
use support::{close, direct};

/// Central difference of fourth order: (8(f(h) - f(-h)) - (f(2h) - f(-2h))) / 12h. Truncation h^4 f'''''/30, rounding
/// 1.5 eps f/h: with h = 1e-3 both are near 1e-12 times the scale of f.
fn difference(f: impl Fn(f64) -> f64) -> f64 {
    const H: f64 = 1e-3;
    (8.0 * (f(H) - f(-H)) - (f(2.0 * H) - f(-2.0 * H))) / (12.0 * H)
}

const TOLERANCE: f64 = 1e-9;

/// The slope of `e` in the direction `step` at `point`, by differences.
fn slope(g: &Graph, e: Expr, symbols: &[Expr], point: &[f64], step: &[f64]) -> f64 {
    difference(|h| {
        let moved = symbols.iter().zip(point.iter().zip(step)).map(|(&s, (x, d))| (s, x + h * d));
        direct::nodes(g, &[e], &moved.collect::<Vec<_>>())[0]
    })
}

fn value(g: &Graph, e: Expr, symbols: &[Expr], point: &[f64]) -> f64 {
    let bound: Vec<_> = symbols.iter().copied().zip(point.iter().copied()).collect();
    direct::nodes(g, &[e], &bound)[0]
}

#[test]
fn every_function_has_the_slope_of_its_differences() {
    for function in Function::ALL {
        let mut g = Graph::new();
        let symbols = [g.symbol("x"), g.symbol("y")];
        let e = g.call(function, &symbols[..function.arity()]);
        for point in [[0.3, 0.7], [0.6, 0.2], [0.15, 0.95]] {
            for (i, step) in [[1.0, 0.0], [0.0, 1.0]].iter().enumerate() {
                let derivative = g.diff(e, symbols[i]);
                let (found, expected) =
                    (value(&g, derivative, &symbols, &point), slope(&g, e, &symbols, &point, step));
                // At 0.15 the logarithm's fifth derivative is 24/0.15^5 = 3e5.
                assert!(close(found, expected, 1e-8), "{function} at {point:?}: {found} {expected}");
            }
        }
    }
}

#[test]
fn negative_arguments_too() {
    for function in
        [Function::Sin, Function::Cos, Function::Asin, Function::Acos, Function::Exp, Function::Abs]
    {
        let mut g = Graph::new();
        let x = g.symbol("x");
        let e = g.call(function, &[x]);
        let derivative = g.diff(e, x);
        let (found, expected) = (value(&g, derivative, &[x], &[-0.4]), slope(&g, e, &[x], &[-0.4], &[1.0]));
        assert!(close(found, expected, TOLERANCE), "{function}: {found} {expected}");
    }
    let mut g = Graph::new();
    let (y, x) = (g.symbol("y"), g.symbol("x"));
    let e = g.atan2(y, x);
    for point in [[0.5, -0.8], [-0.5, -0.8], [-0.5, 0.8]] {
        let derivative = g.diff(e, x);
        let expected = slope(&g, e, &[y, x], &point, &[0.0, 1.0]);
        assert!(close(value(&g, derivative, &[y, x], &point), expected, TOLERANCE));
    }
}

#[test]
fn random_expressions_have_the_slopes_of_their_differences() {
    let mut compared = 0;
    for seed in 0..150 {
        let mut random = Random(seed);
        let mut g = Graph::new();
        let symbols: Vec<Expr> = ["a", "b", "c"].iter().map(|name| g.symbol(name)).collect();
        let pool = grow(&mut g, &mut random, &symbols, 12);
        let e = *pool.last().unwrap();
        let point: Vec<f64> = symbols.iter().map(|_| random.between(-1.2, 1.2)).collect();
        for i in 0..symbols.len() {
            let mut step = vec![0.0; symbols.len()];
            step[i] = 1.0;
            let derivative = g.diff(e, symbols[i]);
            let found = value(&g, derivative, &symbols, &point);
            // A kink within the stencil shows as disagreement between two stencils: skip it there.
            let (wide, shifted) = (slope(&g, e, &symbols, &point, &step), {
                let nudged: Vec<f64> = point.iter().zip(&step).map(|(x, d)| x + 1e-5 * d).collect();
                slope(&g, e, &symbols, &nudged, &step)
            });
            if (wide - shifted).abs() > 1e-2 * wide.abs().max(1.0) {
                continue;
            }
            compared += 1;
            assert!(close(found, wide, 1e-6), "seed {seed}, symbol {i}: {found} {wide}\n{}", g.sexpr(e));
        }
    }
    println!("{compared} slopes compared");
    assert!(compared > 400);
}

#[test]
fn the_gradient_is_sparse_and_in_order() {
    let mut g = Graph::new();
    let s: Vec<Expr> = (0..200).map(|i| g.symbol(&format!("q{i}"))).collect();
    // q3*q180 - sin(q67) + (q5 - q5): 67 and 3 share a bit of the 64-bit dependency mask.
    let product = g.mul(s[3], s[180]);
    let sine = g.sin(s[67]);
    let rest = g.sub(s[5], s[5]);
    let difference = g.sub(product, sine);
    let e = g.add(difference, rest);
    let gradient = g.gradient(e, &s);
    let text: Vec<_> = gradient.iter().map(|&(i, d)| format!("{i}: {}", g.display(d))).collect();
    assert_eq!(text, ["3: q180", "67: -cos(q67)", "180: q3"]);
}

#[test]
fn derivatives_go_through_defined_atoms() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol("x"), g.symbol("y"));
    let square = g.mul(x, x);
    let inertia = g.define("inertia", square);
    let e = g.div(y, inertia);
    let derivative = g.diff(e, x);
    assert_eq!(g.display(derivative).to_string(), "-2*x*y/inertia^2");
    let by_atom = g.diff(e, inertia);
    assert_eq!(g.display(by_atom).to_string(), "-y/inertia^2");
}

#[test]
fn the_total_time_derivative_of_a_row() {
    let mut g = Graph::new();
    let (x, angle, t) = (g.symbol("x"), g.symbol("angle"), g.symbol("t"));
    let (vx, w) = (g.symbol("vx"), g.symbol("w"));
    // phi = x - 0.15*cos(angle) - t^2
    let cosine = g.cos(angle);
    let square = g.powi(t, 2);
    let length = Number::parse_decimal("-0.15").unwrap();
    let phi = g.linear(Number::ZERO, &[(Number::ONE, x), (length, cosine), (Number::MINUS_ONE, square)]);
    let one = g.one();
    let along = [(x, vx), (angle, w), (t, one)];
    let rate = g.directional(phi, &along);
    assert_eq!(g.display(rate).to_string(), "vx - 2*t + 0.15*w*sin(angle)");
    let second = g.directional(rate, &along);
    assert_eq!(g.display(second).to_string(), "0.15*w^2*cos(angle) - 2");
    assert_eq!(g.directionals(&[phi, rate], &along), [rate, second]);
}

#[test]
fn the_directional_derivative_is_the_gradient_times_the_direction() {
    for seed in 0..60 {
        let mut random = Random(seed);
        let mut g = Graph::new();
        let symbols: Vec<Expr> = ["a", "b", "c"].iter().map(|name| g.symbol(name)).collect();
        let pool = grow(&mut g, &mut random, &symbols, 12);
        let e = *pool.last().unwrap();
        let directions: Vec<Expr> = ["u", "v", "w"].iter().map(|name| g.symbol(name)).collect();
        let along: Vec<_> = symbols.iter().copied().zip(directions.iter().copied()).collect();
        let rate = g.directional(e, &along);
        let mut expected = g.zero();
        for (i, derivative) in g.gradient(e, &symbols) {
            let term = g.mul(derivative, directions[i]);
            expected = g.add(expected, term);
        }
        let all: Vec<Expr> = symbols.iter().chain(&directions).copied().collect();
        let point: Vec<f64> = all.iter().map(|_| random.between(-1.2, 1.2)).collect();
        let (a, b) = (value(&g, rate, &all, &point), value(&g, expected, &all, &point));
        assert!(close(a, b, 1e-10), "seed {seed}: {a} {b}");
    }
}

#[test]
fn slopes_at_kinks_are_those_of_one_side() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol("x"), g.symbol("y"));
    let magnitude = g.abs(x);
    let least = g.min(x, y);
    let (a, b) = (g.diff(magnitude, x), g.diff(least, x));
    assert_eq!(value(&g, a, &[x, y], &[0.0, 0.0]), 0.0);
    assert_eq!(value(&g, b, &[x, y], &[0.0, 0.0]), 0.0);
}
