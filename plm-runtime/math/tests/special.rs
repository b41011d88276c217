//! Special values: C99, Annex F, section 9, and what the documentation of each function states.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

macro_rules! special {
    ($float:ident, $signalling:literal) => {
        mod $float {
            use core::$float::consts::{FRAC_PI_2, FRAC_PI_4, LN_2, PI};
            use plm_math::$float as m;

            const INF: $float = $float::INFINITY;
            const NAN: $float = $float::NAN;
            const TINY: $float = $float::from_bits(1);
            const MAX: $float = $float::MAX;

            /// Equal to the bit, so that the sign of a zero counts, or both NaN.
            fn same(what: &str, got: $float, expected: $float) {
                let same = got.to_bits() == expected.to_bits() || (got.is_nan() && expected.is_nan());
                assert!(same, "{what}: {got:e} instead of {expected:e}");
            }

            #[test]
            fn odd_functions_keep_zeros_and_the_smallest_numbers() {
                let odd: [(&str, fn($float) -> $float); 5] = [
                    ("sin", m::sin),
                    ("tan", m::tan),
                    ("asin", m::asin),
                    ("atan", m::atan),
                    ("atan2", |y| m::atan2(y, 1.0)),
                ];
                for (name, f) in odd {
                    for x in [0.0, TINY, 3.0 * TINY, $float::MIN_POSITIVE, $float::MIN_POSITIVE * 1.5] {
                        same(name, f(x), x);
                        same(name, f(-x), -x);
                    }
                }
            }

            #[test]
            fn what_has_no_value_is_nan() {
                let unary: [(&str, fn($float) -> $float, &[$float]); 9] = [
                    ("sin", m::sin, &[INF, -INF]),
                    ("cos", m::cos, &[INF, -INF]),
                    ("tan", m::tan, &[INF, -INF]),
                    ("asin", m::asin, &[1.0 + $float::EPSILON, -1.5, INF, -INF]),
                    ("acos", m::acos, &[1.0 + $float::EPSILON, -1.5, INF, -INF]),
                    ("atan", m::atan, &[]),
                    ("sqrt", m::sqrt, &[-TINY, -1.0, -INF]),
                    ("exp", m::exp, &[]),
                    ("ln", m::ln, &[-TINY, -1.0, -INF]),
                ];
                for (name, f, outside) in unary {
                    for x in [NAN, -NAN, $float::from_bits($signalling)].iter().chain(outside) {
                        same(name, f(*x), NAN);
                    }
                }
                for x in [0.0, -0.0, 1.0, -TINY, MAX, INF, -INF, NAN, -NAN] {
                    same("atan2", m::atan2(-NAN, x), NAN);
                    same("atan2", m::atan2(x, -NAN), NAN);
                    let hypot = if x.abs() == INF { INF } else { NAN };
                    same("hypot", m::hypot(-NAN, x), hypot);
                    same("hypot", m::hypot(x, -NAN), hypot);
                }
                same("powi", m::powi(-NAN, 3), NAN);
                same("powi", m::powi(-NAN, -2), NAN);
                same("round_ties_even", m::round_ties_even(-NAN), NAN);
                same("floor", m::floor(-NAN), NAN);
            }

            #[test]
            fn limits_are_exact() {
                same("cos", m::cos(0.0), 1.0);
                same("cos", m::cos(-0.0), 1.0);
                same("acos", m::acos(1.0), 0.0);
                same("acos", m::acos(-1.0), PI);
                same("acos", m::acos(0.0), FRAC_PI_2);
                same("asin", m::asin(1.0), FRAC_PI_2);
                same("asin", m::asin(-1.0), -FRAC_PI_2);
                same("atan", m::atan(INF), FRAC_PI_2);
                same("atan", m::atan(-INF), -FRAC_PI_2);
                same("atan", m::atan(MAX), FRAC_PI_2);
                same("atan", m::atan(1.0), FRAC_PI_4);
                same("exp", m::exp(0.0), 1.0);
                same("exp", m::exp(-0.0), 1.0);
                same("exp", m::exp(TINY), 1.0);
                same("exp", m::exp(INF), INF);
                same("exp", m::exp(MAX), INF);
                same("exp", m::exp(-INF), 0.0);
                same("exp", m::exp(-MAX), 0.0);
                same("ln", m::ln(1.0), 0.0);
                same("ln", m::ln(2.0), LN_2);
                same("ln", m::ln(0.0), -INF);
                same("ln", m::ln(-0.0), -INF);
                same("ln", m::ln(INF), INF);
                same("sqrt", m::sqrt(0.0), 0.0);
                same("sqrt", m::sqrt(-0.0), -0.0);
                same("sqrt", m::sqrt(INF), INF);
                same("sqrt", m::sqrt(1e10), 1e5);
            }

            #[test]
            fn atan2_follows_the_axes() {
                for sign in [1.0, -1.0] {
                    for (y, x, angle) in [
                        (0.0, 0.0, 0.0),
                        (0.0, -0.0, PI),
                        (0.0, TINY, 0.0),
                        (0.0, INF, 0.0),
                        (0.0, -TINY, PI),
                        (0.0, -INF, PI),
                        (TINY, 0.0, FRAC_PI_2),
                        (TINY, -0.0, FRAC_PI_2),
                        (MAX, 0.0, FRAC_PI_2),
                        (INF, 1.0, FRAC_PI_2),
                        (INF, -MAX, FRAC_PI_2),
                        (1.0, INF, 0.0),
                        (1.0, -INF, PI),
                        (INF, INF, FRAC_PI_4),
                        (INF, -INF, 3.0 * FRAC_PI_4),
                        (TINY, TINY, FRAC_PI_4),
                        (MAX, MAX, FRAC_PI_4),
                        (TINY, MAX, 0.0),
                        (TINY, -MAX, PI),
                        (MAX, TINY, FRAC_PI_2),
                    ] {
                        same(&format!("atan2({sign} {y:e}, {x:e})"), m::atan2(sign * y, x), sign * angle);
                    }
                }
            }

            #[test]
            fn hypot_neither_overflows_nor_vanishes_on_the_way() {
                for (x, y, length) in [
                    (0.0, -0.0, 0.0),
                    (-0.0, -0.0, 0.0),
                    (3.0, -4.0, 5.0),
                    (TINY, 0.0, TINY),
                    (3.0 * TINY, 4.0 * TINY, 5.0 * TINY),
                    (MAX, 1.0, MAX),
                    (MAX, MAX, INF),
                    (MAX / 5.0 * 3.0, MAX / 5.0 * 4.0, MAX),
                    (INF, 0.0, INF),
                    (1.0, -INF, INF),
                ] {
                    same("hypot", m::hypot(x, y), length);
                    same("hypot", m::hypot(y, x), length);
                }
            }

            #[test]
            fn powi_has_the_signs_of_its_factors() {
                for (x, n, power) in [
                    (0.0, 0, 1.0),
                    (NAN, 0, 1.0),
                    (INF, 0, 1.0),
                    (-0.0, 3, -0.0),
                    (-0.0, 2, 0.0),
                    (-0.0, -3, -INF),
                    (-0.0, -2, INF),
                    (-INF, 3, -INF),
                    (-INF, -3, -0.0),
                    (-INF, -2, 0.0),
                    (-2.0, 5, -32.0),
                    (-2.0, -2, 0.25),
                    (2.0, 1 - $float::MAX_EXP - $float::MANTISSA_DIGITS as i32 + 2, TINY),
                    (1.0, i32::MIN, 1.0),
                    (-1.0, i32::MAX, -1.0),
                    (2.0, i32::MIN, 0.0),
                    (0.5, i32::MIN, INF),
                ] {
                    same(&format!("powi({x:e}, {n})"), m::powi(x, n), power);
                }
            }

            #[test]
            fn minimum_and_maximum_return_the_second_of_incomparable_arguments() {
                same("min", m::min(NAN, 1.0), 1.0);
                same("max", m::max(NAN, 1.0), 1.0);
                same("min", m::min(1.0, NAN), NAN);
                same("max", m::max(1.0, NAN), NAN);
                for (a, b) in [(0.0, -0.0), (-0.0, 0.0)] {
                    same("min", m::min(a, b), b);
                    same("max", m::max(a, b), b);
                }
                same("min", m::min(-INF, MAX), -INF);
                same("max", m::max(-INF, MAX), MAX);
            }

            #[test]
            fn rounding_keeps_signs_and_large_numbers() {
                for (x, floor, round) in [
                    (0.0, 0.0, 0.0),
                    (-0.0, -0.0, -0.0),
                    (TINY, 0.0, 0.0),
                    (-TINY, -1.0, -0.0),
                    (0.5, 0.0, 0.0),
                    (-0.5, -1.0, -0.0),
                    (1.5, 1.0, 2.0),
                    (2.5, 2.0, 2.0),
                    (-2.5, -3.0, -2.0),
                    (1.0 - $float::EPSILON, 0.0, 1.0),
                    (MAX, MAX, MAX),
                    (-MAX, -MAX, -MAX),
                    (INF, INF, INF),
                    (-INF, -INF, -INF),
                ] {
                    same("floor", m::floor(x), floor);
                    same("round_ties_even", m::round_ties_even(x), round);
                }
            }

            #[test]
            fn magnitude_and_sign_also_of_zeros() {
                same("abs", m::abs(-0.0), 0.0);
                same("abs", m::abs(-INF), INF);
                same("copysign", m::copysign(0.0, -1.0), -0.0);
                same("copysign", m::copysign(-2.0, 0.0), 2.0);
            }
        }
    };
}

special!(f64, 0xfff4_0000_0000_0001);
special!(f32, 0xffa0_0001);
