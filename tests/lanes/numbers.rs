//! Every operation on eight lanes has the bits of `f64`, in every lane.

use plm::runtime::lanes::Lanes;
use plm::{F64x8, Scalar};

/// Zeros, infinities, NaN, small and large numbers of both signs, angles far beyond the direct path of the sine.
fn samples() -> Vec<f64> {
    let mut samples =
        vec![0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, f64::MIN_POSITIVE, 1e-310, 1e300];
    // Low-discrepancy numbers in (-10, 10), (-1, 1) and (-1e9, 1e9).
    for k in 1..=40 {
        let x = 2.0 * (f64::from(k) * 0.618_033_988_749_894_9).fract() - 1.0;
        samples.extend([10.0 * x, x, 1e9 * x]);
    }
    samples
}

fn same(name: &str, found: F64x8, expected: [f64; 8]) {
    for (found, expected) in found.values().into_iter().zip(expected) {
        let same = found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan());
        assert!(same, "{name}: {found:e} instead of {expected:e}");
    }
}

#[test]
fn functions_of_one_number() {
    macro_rules! check {
        ($x:ident: $($function:ident),+) => {
            $(same(stringify!($function), Scalar::$function(F64x8::of($x)), $x.map(Scalar::$function));)+
        };
    }
    for x in samples().as_chunks::<8>().0 {
        let x = *x;
        check!(x: sin, cos, sqrt, tan, asin, acos, exp, ln, abs, floor, signum0);
        same("-", -F64x8::of(x), x.map(|x| -x));
        same("powi", F64x8::of(x).powi(-3), x.map(|x| Scalar::powi(x, -3)));
        let ([first, second], [c, _]) = F64x8::sin_cos_all([F64x8::of(x), -F64x8::of(x)]);
        same("sin_cos_all", first, x.map(Scalar::sin));
        same("sin_cos_all", second, x.map(|x| Scalar::sin(-x)));
        same("sin_cos_all", c, x.map(Scalar::cos));
        assert_eq!(F64x8::of(x).is_finite(), x.iter().all(|x| x.is_finite()));
    }
}

#[test]
fn functions_of_several_numbers() {
    let samples = samples();
    for shift in 0..samples.len() {
        let other: Vec<f64> = samples.iter().cycle().skip(shift).take(samples.len()).copied().collect();
        for (a, b) in samples.as_chunks::<8>().0.iter().zip(other.as_chunks::<8>().0) {
            let (x, y) = (F64x8::of(*a), F64x8::of(*b));
            let each = |f: fn(f64, f64) -> f64| std::array::from_fn(|i| f(a[i], b[i]));
            same("+", x + y, each(|a, b| a + b));
            same("-", x - y, each(|a, b| a - b));
            same("*", x * y, each(|a, b| a * b));
            same("/", x / y, each(|a, b| a / b));
            same("min", Scalar::min(x, y), each(<f64 as Scalar>::min));
            same("max", Scalar::max(x, y), each(<f64 as Scalar>::max));
            same("atan2", Scalar::atan2(x, y), each(<f64 as Scalar>::atan2));
            same("mul_add", Scalar::mul_add(x, y, y), each(|a, b| Scalar::mul_add(a, b, b)));
            let less = x.lt(y);
            same("select", F64x8::select(less, x, F64x8::lit(2.0)), each(|a, b| if a < b { a } else { 2.0 }));
            assert_eq!(F64x8::any(less), (0..8).any(|i| a[i] < b[i]));
            assert_eq!(F64x8::all(less), (0..8).all(|i| a[i] < b[i]));
        }
    }
}
