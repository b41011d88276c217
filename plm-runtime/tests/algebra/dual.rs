//! Derivatives by dual numbers against derivatives that are known, and against difference quotients.

use plm_runtime::{Dual, Real, Scalar};

use crate::random::Random;

type D = Dual<f64, 2>;

/// A function, its derivative, and the interval to try it in.
type Case = (&'static str, fn(D) -> D, fn(f64) -> f64, [f64; 2]);

const CASES: [Case; 17] = [
    ("sin", |x| x.sin(), f64::cos, [-9.0, 9.0]),
    ("cos", |x| x.cos(), |x| -x.sin(), [-9.0, 9.0]),
    ("tan", |x| x.tan(), |x| 1.0 / x.cos().powi(2), [-1.4, 1.4]),
    ("asin", |x| x.asin(), |x| 1.0 / (1.0 - x * x).sqrt(), [-0.99, 0.99]),
    ("acos", |x| x.acos(), |x| -1.0 / (1.0 - x * x).sqrt(), [-0.99, 0.99]),
    ("exp", |x| x.exp(), f64::exp, [-5.0, 5.0]),
    ("ln", |x| x.ln(), |x| 1.0 / x, [0.01, 9.0]),
    ("sqrt", |x| x.sqrt(), |x| 0.5 / x.sqrt(), [0.01, 9.0]),
    ("abs", |x| x.abs(), f64::signum, [-3.0, 3.0]),
    ("x^5", |x| x.powi(5), |x| 5.0 * x.powi(4), [-3.0, 3.0]),
    ("x^-3", |x| x.powi(-3), |x| -3.0 * x.powi(-4), [0.1, 3.0]),
    ("x^0", |x| x.powi(0), |_| 0.0, [-3.0, 3.0]),
    ("1/x", |x| D::lit(1.0) / x, |x| -1.0 / (x * x), [0.1, 9.0]),
    ("x sin x", |x| x * x.sin(), |x| x.sin() + x * x.cos(), [-5.0, 5.0]),
    ("fused", |x| x.mul_add(x.exp(), x), |x| (1.0 + x) * x.exp() + 1.0, [-2.0, 2.0]),
    ("y of the circle", |x| x.sin().atan2(x.cos()), |_| 1.0, [-3.0, 3.0]),
    ("the other way", |x| x.atan2(D::lit(2.0)), |x| 2.0 / (4.0 + x * x), [-5.0, 5.0]),
];

fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * 0.5 * (1.0 + random.unit())
}

#[test]
fn known_derivatives() {
    let mut random = Random(7);
    for (name, f, derivative, [low, high]) in CASES {
        for _ in 0..200 {
            let x = between(&mut random, low, high);
            // The second direction runs three times as fast, backwards.
            let y = f(Dual { value: x, tangents: [1.0, -3.0] });
            let expected = derivative(x);
            let close = |got: f64, want: f64| (got - want).abs() <= 1e-13 * want.abs().max(1.0);
            assert!(close(y.tangents[0], expected), "{name} at {x}: {y:?}, {expected}");
            assert!(close(y.tangents[1], -3.0 * expected), "{name} at {x}: {y:?}, {expected}");
        }
    }
}

/// Something of everything, with branches.
fn mixture<S: Real>(x: S, y: S) -> S {
    let lit = S::lit;
    let ([s1, s2, s3], [c1, c2, c3]) = S::sin_cos_all([x, y, x * y]);
    let bounded = (x - y).max(lit(-0.5)).min(s1 * c2 + lit(2.0));
    let chosen = S::select(x.lt(y), s3 * x, c3 / (y + lit(4.0)));
    let radius = (x * x + y * y).sqrt();
    bounded * chosen + radius.ln() * c1 - s2.atan2(radius + lit(1.0)) + x.floor() * y + (x - y).signum0() * x
}

#[test]
fn directions_agree_with_difference_quotients() {
    let mut random = Random(11);
    for _ in 0..500 {
        let [x, y] = [2.7, 1.9].map(|size| size * random.unit());
        let dual = mixture::<D>(Dual::variable(x, 0), Dual::variable(y, 1));
        assert_eq!(dual.value.to_bits(), mixture(x, y).to_bits(), "the value has the same bits");
        let h = 1e-6;
        // Branches that lie between the two points make the quotient meaningless.
        let near_a_kink = (x - y).abs() < 1e-5 || (x - x.round()).abs() < 1e-5 || (x - y + 0.5).abs() < 1e-5;
        if near_a_kink {
            continue;
        }
        let by_x = (mixture(x + h, y) - mixture(x - h, y)) / (2.0 * h);
        let by_y = (mixture(x, y + h) - mixture(x, y - h)) / (2.0 * h);
        for (tangent, quotient) in dual.tangents.into_iter().zip([by_x, by_y]) {
            assert!(
                (tangent - quotient).abs() < 1e-7 * quotient.abs().max(1.0),
                "{x} {y}: {tangent} {quotient}"
            );
        }
    }
}

#[test]
fn values_have_the_bits_of_the_scalar() {
    let mut random = Random(3);
    for (name, f, _, [low, high]) in CASES {
        for _ in 0..50 {
            let x = between(&mut random, low, high);
            let [a, b] = [f(Dual::constant(x)), f(Dual::variable(x, 1))];
            assert_eq!((a.value.to_bits(), a.tangents), (b.value.to_bits(), [0.0; 2]), "{name}");
        }
    }
    let angle = 1.234_567;
    assert_eq!(D::constant(angle).tan().value.to_bits(), Scalar::tan(angle).to_bits());
    assert_eq!(D::constant(angle).powi(7).value.to_bits(), Scalar::powi(angle, 7).to_bits());
    assert_eq!(D::constant(0.3).asin().value.to_bits(), Scalar::asin(0.3_f64).to_bits());
}

#[test]
fn what_does_not_move_stays_at_singular_points() {
    let zero = D::constant(0.0);
    for y in [zero.sqrt(), zero.ln(), zero.atan2(zero), D::lit(1.0).asin(), D::lit(-1.0).acos()] {
        assert_eq!(y.tangents, [0.0; 2]);
    }
    // The length of a vector at its smallest: the square does not move to first order.
    let length = (Dual::variable(0.0, 0).powi(2) + Dual::<f64, 2>::variable(0.0, 1).powi(2)).sqrt();
    assert_eq!((length.value, length.tangents), (0.0, [0.0; 2]));
    // What does move is not made up.
    let root = D::variable(0.0, 0).sqrt();
    assert_eq!((root.value, root.tangents), (0.0, [f64::INFINITY, 0.0]));
}

#[test]
fn kinks_take_the_side_of_the_value() {
    let (x, y) = (D::variable(1.0, 0), D::variable(2.0, 1));
    assert_eq!(x.min(y).tangents, [1.0, 0.0]);
    assert_eq!(x.max(y).tangents, [0.0, 1.0]);
    assert_eq!(D::variable(0.0, 0).abs().tangents, [0.0; 2]);
    assert_eq!(D::variable(2.7, 0).floor(), D::lit(2.0));
    assert_eq!(D::variable(2.7, 0).floor().tangents, [0.0; 2]);
    // Equality and order are those of the values.
    assert!(x < y && x == D::lit(1.0) && x.is_finite());
}

#[test]
fn second_derivatives_by_duals_of_duals() {
    type Second = Dual<Dual<f64, 1>, 1>;
    let x = Second { value: Dual::variable(0.7, 0), tangents: [Dual::constant(1.0)] };
    let y = x.sin() * x.exp();
    // (sin x exp x)'' = 2 cos x exp x.
    let expected = 2.0 * 0.7_f64.cos() * 0.7_f64.exp();
    assert!((y.tangents[0].tangents[0] - expected).abs() < 1e-14);
}

#[test]
fn conditions_are_those_of_the_values() {
    let [low, high] = [1.0, 2.0].map(|value| D::variable(value, 0));
    for (a, b, less) in [(low, high, true), (high, low, false), (low, low, false)] {
        let mask = a.lt(b);
        assert_eq!((D::any(mask), D::all(mask)), (less, less), "{a:?} < {b:?}");
        assert_eq!(D::select(mask, a, b).value, if less { a.value } else { b.value });
    }
}
