//! All of f32 in strides against std's f64 functions, whose error is no part of an f32 unit in the last place, and
//! random f64 against std, whose error is below one unit. The arguments are other ones than those of accuracy.rs.

#![allow(clippy::unwrap_used, reason = "tests")]

#[path = "support/bounds.rs"]
mod bounds;
#[path = "support/random.rs"]
mod random;

use bounds::bounds;
use random::Random;

/// The bound of an f32 function in ulp, the largest one if ranges differ.
fn bound(name: &str) -> f64 {
    let rows = bounds().into_iter().filter(|((function, _), _)| function == name);
    rows.map(|(_, [_, single])| single).fold(0.0, f64::max)
}

/// The distance of a result from the true value, in units in the last place of f32.
fn error(got: f32, exact: f64) -> f64 {
    let nearest = exact as f32;
    if nearest.is_nan() || nearest.is_infinite() {
        return if got.to_bits() == nearest.to_bits() || (got.is_nan() && nearest.is_nan()) {
            0.0
        } else {
            f64::INFINITY
        };
    }
    // The unit in the last place of |exact| rounded towards zero.
    let down = if f64::from(nearest.abs()) > exact.abs() { nearest.abs().next_down() } else { nearest.abs() };
    let unit = f64::from(down.next_up()) - f64::from(down);
    (f64::from(got) - exact).abs() / unit
}

#[test]
fn f32_agrees_with_f64_all_over_its_range() {
    use plm_math::f32 as m;
    /// Name, function, and the same in f64.
    type Case = (&'static str, fn(f32) -> f32, fn(f64) -> f64);
    let cases: [Case; 11] = [
        ("sin", m::sin, f64::sin),
        ("cos", m::cos, f64::cos),
        ("tan", m::tan, f64::tan),
        ("asin", m::asin, f64::asin),
        ("acos", m::acos, f64::acos),
        ("atan", m::atan, f64::atan),
        ("sqrt", m::sqrt, f64::sqrt),
        ("exp", m::exp, f64::exp),
        ("ln", m::ln, f64::ln),
        ("floor", m::floor, f64::floor),
        ("round_ties_even", m::round_ties_even, f64::round_ties_even),
    ];
    // A prime, so that the strides meet all bit patterns of the low digits.
    let stride = std::env::var("PLM_MATH_STRIDE").map_or(10_007, |stride| stride.parse().unwrap());
    let mut failures = Vec::new();
    for (name, f, exact) in cases {
        let mut largest = (0.0, 0.0);
        for bits in (0..=u32::MAX).step_by(stride) {
            let x = f32::from_bits(bits);
            let error = error(f(x), exact(f64::from(x)));
            if error > largest.0 {
                largest = (error, x);
            }
        }
        println!("{name}: {:.4} at {:e} ({:08x})", largest.0, largest.1, largest.1.to_bits());
        if largest.0 > bound(name) {
            failures.push(format!("{name}: {} at {:e}", largest.0, largest.1));
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

#[test]
fn f32_of_two_arguments_agrees_with_f64() {
    use plm_math::f32 as m;
    let mut random = Random(3);
    for _ in 0..20_000 {
        let [y, x] = [(); 2].map(|()| random.number() as f32);
        let (exact_y, exact_x) = (f64::from(y), f64::from(x));
        let atan2 = error(m::atan2(y, x), exact_y.atan2(exact_x));
        assert!(atan2 <= bound("atan2"), "atan2({y:e}, {x:e}): {atan2}");
        let hypot = error(m::hypot(y, x), exact_y.hypot(exact_x));
        assert!(hypot <= bound("hypot"), "hypot({y:e}, {x:e}): {hypot}");
    }
}

#[test]
fn f64_agrees_with_std() {
    use plm_math::f64 as m;
    type Case = (&'static str, fn(f64, f64) -> f64, fn(f64, f64) -> f64);
    let cases: [Case; 13] = [
        ("sin", |x, _| m::sin(x), |x, _| x.sin()),
        ("cos", |x, _| m::cos(x), |x, _| x.cos()),
        ("tan", |x, _| m::tan(x), |x, _| x.tan()),
        ("asin", |x, _| m::asin(x % 1.0), |x, _| (x % 1.0).asin()),
        ("acos", |x, _| m::acos(x % 1.0), |x, _| (x % 1.0).acos()),
        ("atan", |x, _| m::atan(x), |x, _| x.atan()),
        ("sqrt", |x, _| m::sqrt(x), |x, _| x.sqrt()),
        ("exp", |x, _| m::exp(x % 750.0), |x, _| (x % 750.0).exp()),
        ("ln", |x, _| m::ln(x), |x, _| x.ln()),
        ("floor", |x, _| m::floor(x), |x, _| x.floor()),
        ("round_ties_even", |x, _| m::round_ties_even(x), |x, _| x.round_ties_even()),
        ("atan2", m::atan2, f64::atan2),
        ("hypot", m::hypot, f64::hypot),
    ];
    for (name, f, std) in cases {
        let mut random = Random(4);
        for _ in 0..20_000 {
            let (x, y) = (random.number(), random.number());
            let (got, expected) = (f(x, y), std(x, y));
            let close =
                got.to_bits().abs_diff(expected.to_bits()) <= 2 || (got.is_nan() && expected.is_nan());
            assert!(close, "{name}({x:e}, {y:e}): {got:e}, std: {expected:e}");
        }
    }
}
