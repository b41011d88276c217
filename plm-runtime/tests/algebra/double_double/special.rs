//! Infinities, NaN, zeros, conversions, and other numbers than f32 and f64 as words.

use plm_runtime::{DoubleDouble, Dual, Real, Scalar};

use super::{FUNCTIONS, call};
use crate::random::Random;

/// The same number, with the same sign of zero; any two NaNs.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

const SPECIAL: [f64; 15] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -2.0,
    3e5,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    1e-200,
];

#[test]
fn special_cases_are_those_of_one_word() {
    for (name, arity) in FUNCTIONS {
        for a in SPECIAL {
            for b in SPECIAL {
                let plain = call(name, &[a, b][..arity]).unwrap();
                let got = call(name, &[DoubleDouble::of(a), DoubleDouble::of(b)][..arity]).unwrap();
                let case = format!("{name} {a:e} {b:e}: {got:?}, of one word {plain:e}");
                if ["sin", "cos", "tan"].contains(&name) && a.abs() > 1e16 {
                    assert!(got.high().is_nan(), "{case}");
                } else if !plain.is_finite() || plain == 0.0 {
                    assert!(same(got.high(), plain), "{case}");
                    assert_eq!(got.is_finite(), plain.is_finite(), "{case}");
                    assert!(got.low() == 0.0, "{case}");
                } else {
                    // One word is off by two units in its last place at most.
                    let close = (got.high() - plain).abs() <= 4.0 * f64::EPSILON * plain.abs() + 1e-323;
                    assert!(got.is_finite() && close, "{case}");
                }
            }
        }
    }
}

#[test]
fn nothing_compares_with_what_is_not_a_number() {
    let (nan, one) = (DoubleDouble::lit(f64::NAN), DoubleDouble::<f64>::lit(1.0));
    for other in [nan, one, DoubleDouble::INFINITY] {
        assert!(!nan.lt(other) && !other.lt(nan) && nan != other && other.partial_cmp(&nan).is_none());
    }
    assert!(
        one < DoubleDouble::INFINITY
            && -DoubleDouble::INFINITY < one
            && !DoubleDouble::<f64>::INFINITY.is_finite()
    );
    assert_eq!(one / DoubleDouble::ZERO, DoubleDouble::INFINITY);
    assert_eq!(DoubleDouble::INFINITY + one, DoubleDouble::INFINITY);
}

#[test]
fn low_words_decide_where_high_words_are_equal() {
    let one = DoubleDouble::<f64>::lit(1.0);
    let above = one + DoubleDouble::of(1e-25);
    assert_eq!((above.high(), above.low(), above.rounded()), (1.0, 1e-25, 1.0));
    assert!(one < above && !above.lt(one) && one != above && -above < -one);
    assert_eq!((one - above).abs(), DoubleDouble::of(1e-25));
    assert_eq!((-above).abs(), above);
    assert_eq!((above.min(one), above.max(one)), (one, above));
    assert_eq!((one - above).signum0(), -one);
    assert_eq!(Scalar::floor(one - DoubleDouble::of(1e-25)), DoubleDouble::ZERO);
    assert_eq!(Scalar::floor(above), one);
}

#[test]
fn literals_keep_their_digits() {
    let mut random = Random(1);
    for _ in 0..1000 {
        let x = random.unit();
        // A decimal of few digits by chance is within its rounding.
        let double = DoubleDouble::<f64>::lit(x);
        assert!(double.high() == x && double.low().abs() <= 0.5 * f64::EPSILON * x.abs(), "{x}: {double:?}");
        let single = DoubleDouble::<f32>::lit(x);
        assert_eq!(single.high(), x as f32);
        assert!((single.to_f64() - x).abs() <= x.abs() * 2.0_f64.powi(-48), "{x}: {single:?}");
    }
    assert_eq!(DoubleDouble::<f32>::lit(1e300), DoubleDouble::INFINITY);
}

/// n / 10^k times 10^k is n, of every decimal that people write.
#[test]
fn decimals_are_what_was_written() {
    let mut random = Random(2);
    for _ in 0..1000 {
        let (digits, whole) = (random.below(7) as i32, random.below(10_000_000) as f64);
        let power = 10_f64.powi(digits);
        let found = DoubleDouble::written(whole / power) * DoubleDouble::of(power) - DoubleDouble::of(whole);
        assert!(found.rounded().abs() <= 1e-30 * whole, "{whole} / {power}: {found:?}");
        // Between two of them in the last place is none.
        let beside = (whole / power).next_up();
        assert!(whole == 0.0 || DoubleDouble::written(beside).low() == 0.0, "{beside:e}");
    }
}

#[test]
fn constants_are_those_of_the_precision() {
    assert_eq!(DoubleDouble::<f64>::EPSILON.to_f64(), 2.0_f64.powi(-104));
    assert_eq!(DoubleDouble::<f32>::EPSILON.to_f64(), 2.0_f64.powi(-46));
    // Lengths are known as exactly as in the words: so far rows can repeat each other.
    assert_eq!(DoubleDouble::<f64>::RANK_TOLERANCE, DoubleDouble::of(f64::RANK_TOLERANCE));
    assert_eq!(DoubleDouble::<f32>::RANK_TOLERANCE, DoubleDouble::of(f32::RANK_TOLERANCE));
    // A pivot of rows that repeat each other but for rounding of lengths is the square of that.
    let repeated = [f64::EPSILON, f64::from(f32::EPSILON)].map(|rounding| rounding * rounding);
    let healthy = [DoubleDouble::<f64>::HEALTHY, DoubleDouble::<f32>::HEALTHY];
    let of_words = [f64::HEALTHY, f32::HEALTHY];
    for k in 0..2 {
        assert!(1e4 * repeated[k] < healthy[k] && healthy[k] < 1e-4 * of_words[k] * of_words[k]);
    }
}

#[test]
fn exact_sums_and_products_lose_nothing() {
    let mut random = Random(2);
    for _ in 0..1000 {
        let (a, b) = (random.unit(), random.unit() * 1e-9);
        // (a + b) - a leaves b itself, (a b) / a is b to a rounding.
        assert_eq!(DoubleDouble::sum(a, b) - DoubleDouble::of(a), DoubleDouble::of(b));
        assert_eq!(DoubleDouble::product(a, b), DoubleDouble::of(a) * DoubleDouble::of(b));
        let back = DoubleDouble::product(a, b) / DoubleDouble::of(a) - DoubleDouble::of(b);
        assert!(back.high().abs() <= 4.0 * b.abs() * 2.0_f64.powi(-104), "{a} {b}: {back:?}");
    }
}

/// Something of every function.
fn mixture<S: Real>(x: S, y: S) -> S {
    let lit = S::lit;
    let ([s1, s2], [c1, c2]) = S::sin_cos_all([x, y]);
    let root = (x * x + y * y + lit(1.0)).sqrt();
    let angles =
        s1.atan2(c2 + lit(2.0)) + (s2 * lit(0.9)).asin() - (c1 * lit(0.9)).acos() + (x * lit(0.1)).tan();
    root.ln() * angles.exp() / (lit(3.0) + s1 * s2) + (x - y).abs() + root.mul_add(s1, c1) + y.powi(3)
}

#[test]
fn derivatives_of_double_double_numbers_are_those_of_their_words() {
    let mut random = Random(3);
    for _ in 0..200 {
        let [x, y] = [(), ()].map(|()| random.unit() * 1.4);
        let plain = mixture(Dual::<f64, 2>::variable(x, 0), Dual::variable(y, 1));
        // Double-double numbers with derivatives: these are as precise as the numbers.
        let outer = mixture(
            Dual::<DoubleDouble<f64>, 2>::variable(DoubleDouble::of(x), 0),
            Dual::variable(DoubleDouble::of(y), 1),
        );
        // Numbers with derivatives as words: values have the bits of double-double numbers, derivatives the digits of f64.
        let inner =
            mixture(DoubleDouble::of(Dual::<f64, 2>::variable(x, 0)), DoubleDouble::of(Dual::variable(y, 1)));
        let double_double = mixture(DoubleDouble::of(x), DoubleDouble::of(y));
        assert_eq!(outer.value, double_double);
        assert_eq!((inner.high().value, inner.low().value), (double_double.high(), double_double.low()));
        for k in 0..2 {
            let outer = outer.tangents[k].to_f64();
            let inner = inner.high().tangents[k] + inner.low().tangents[k];
            let scale = outer.abs().max(1.0);
            assert!((outer - plain.tangents[k]).abs() < 1e-13 * scale, "{x} {y}: {outer} {plain:?}");
            assert!((outer - inner).abs() < 1e-13 * scale, "{x} {y}: {outer} {inner}");
        }
    }
}

/// Names of a known identity and its two sides in double-double numbers; independent of the reference values.
#[test]
fn identities_hold_to_the_last_digits() {
    fn sweep<S: Real>(seed: u64) {
        let mut random = Random(seed);
        let epsilon = DoubleDouble::<S>::EPSILON;
        let one = DoubleDouble::lit(1.0);
        for _ in 0..500 {
            let mut any = || DoubleDouble::sum(S::lit(random.unit()), S::lit(random.unit()) * S::EPSILON);
            let (x, y) = (any(), any());
            let (sin, cos) = (x * DoubleDouble::lit(50.0)).sin_cos();
            let checks = [
                (sin * sin + cos * cos, one, one),
                (x.exp() * (-x).exp(), one, one),
                (x.exp().ln(), x, one),
                (x.asin() + x.acos(), one.atan2(DoubleDouble::ZERO), one),
                (y.atan2(x).sin() * (x * x + y * y).sqrt(), y, one),
                ((x + y) * (x - y), x * x - y * y, one),
                (x * x.abs().sqrt(), x.abs().sqrt() * x, one),
            ];
            for (k, (left, right, scale)) in checks.into_iter().enumerate() {
                let difference = (left - right).abs();
                assert!(
                    difference < epsilon * scale * DoubleDouble::lit(8.0),
                    "{k} at {x:?} {y:?}: {left:?} {right:?}"
                );
            }
        }
    }
    sweep::<f64>(8);
    sweep::<f32>(9);
}
