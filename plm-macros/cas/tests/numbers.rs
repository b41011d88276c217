//! Numbers against std: decimal literals and rounding against the parser of std, powers of pi against its constants.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod support;

use std::f64::consts;

use plm_cas::{Function, Graph, Number};
use support::random::Random;
use support::{close, direct};

fn rational(num: i128, den: i128) -> Number {
    Number::rational(num, den).unwrap()
}

#[test]
fn decimal_literals_are_exact_and_round_as_std_reads_them() {
    let texts = [
        "0",
        "1",
        "9.80665",
        "0.15",
        "1e-3",
        "1_000",
        "1_000.000_1",
        "6.02214076e23",
        "1.7e-20",
        "0.1",
        ".5",
        "5.",
        "-2.5",
        "+3e2",
        "123456789012345678901234567890",
        "0.3333333333333333333333333",
        "1e22",
        "1e23",
        "9007199254740993",
        "0.000000000000000000000000000001",
        "4.35",
        "1.005",
        "179769313486231.57e10",
    ];
    for text in texts {
        let number = Number::parse_decimal(text).unwrap();
        let expected: f64 = text.replace('_', "").parse().unwrap();
        assert!(matches!(number, Number::Exact { .. }), "{text}");
        assert_eq!(number.to_f64().to_bits(), expected.to_bits(), "{text}");
    }
}

#[test]
fn random_decimals_round_as_std_reads_them() {
    let mut random = Random(1);
    for _ in 0..20_000 {
        let digits = u128::from(random.bits()) * random.below(1_000_000) as u128;
        let text = format!("{digits}e{}", random.below(30) as i32 - 30);
        let number = Number::parse_decimal(&text).unwrap();
        let expected: f64 = text.parse().unwrap();
        assert_eq!(number.to_f64().to_bits(), expected.to_bits(), "{text}");
    }
}

/// The nearest float is at most half a unit away: compared exactly, in integers.
#[test]
fn random_quotients_round_to_the_nearest() {
    let mut random = Random(2);
    for _ in 0..20_000 {
        let num = i128::from(random.bits()) >> random.below(40);
        let den = (i128::from(random.bits()) >> random.below(60)).max(1);
        let value = rational(num, den).to_f64();
        for other in [value.next_up(), value.next_down()] {
            // |num/den - value| <= |num/den - other|, doubled: the middle of value and other is not passed.
            let middle = exact(value).zip(exact(other)).map(|(a, b)| (a + b) * rational(1, 2));
            let Some(middle) = middle else { continue };
            let on_this_side =
                if other > value { rational(num, den) <= middle } else { rational(num, den) >= middle };
            assert!(on_this_side, "{num}/{den} -> {value:e}, {other:e}");
        }
    }
}

/// A float as a rational, if it fits.
fn exact(value: f64) -> Option<Number> {
    let (bits, exponent) =
        (value.to_bits() & ((1 << 52) - 1) | (1 << 52), ((value.to_bits() >> 52) & 0x7ff) as i32 - 1075);
    let power = 1_i128.checked_shl(exponent.unsigned_abs()).filter(|_| exponent.abs() < 72)?;
    if exponent < 0 {
        Number::rational(i128::from(bits), power)
    } else {
        Number::rational(i128::from(bits) * power, 1)
    }
}

#[test]
fn literals_that_do_not_fit_are_floats() {
    for text in [
        "1e40",
        "1e300",
        "1e-200",
        "1234567890123456789012345678901234567890.5",
        "5e-324",
        "2.2250738585072014e-30",
    ] {
        let number = Number::parse_decimal(text).unwrap();
        assert_eq!(number, Number::Float(text.parse().unwrap()), "{text}");
    }
}

#[test]
fn what_is_no_literal_is_none() {
    for text in
        ["", ".", "-", "e5", "1e", "1.2.3", "0x10", "inf", "nan", "1 2", "--1", "1e999", "1e99999999999", "_"]
    {
        assert_eq!(Number::parse_decimal(text), None, "{text}");
    }
}

#[test]
fn parts_of_pi_are_the_constants_of_std() {
    let pi = Number::pi();
    let cases = [
        (pi, consts::PI),
        (pi * rational(1, 2), consts::FRAC_PI_2),
        (pi * rational(1, 3), consts::FRAC_PI_3),
        (pi * rational(45, 180), consts::FRAC_PI_4),
        (pi * rational(1, 6), consts::FRAC_PI_6),
        (pi * rational(1, 8), consts::FRAC_PI_8),
        (pi * rational(2, 1), consts::TAU),
        (pi.recip().unwrap(), consts::FRAC_1_PI),
        (pi.recip().unwrap() * rational(2, 1), consts::FRAC_2_PI),
        (-pi, -consts::PI),
        // Computed to 60 digits with Python's decimal module and the digits of pi of OEIS A000796.
        (pi * rational(1, 180), 0.017_453_292_519_943_295),
        (pi * pi, 9.869_604_401_089_358),
        (pi * pi * pi, 31.006_276_680_299_82),
        (pi.recip().unwrap() * rational(180, 1), 57.295_779_513_082_32),
        (pi * rational(2, 60), 0.104_719_755_119_659_78),
        (pi * rational(355, 113) * rational(1_000_000_007, 999_999_937), 9.869_605_930_026_186),
    ];
    for (number, expected) in cases {
        assert_eq!(number.to_f64().to_bits(), f64::to_bits(expected), "{number}");
    }
}

#[test]
fn arithmetic_stays_exact_until_it_cannot() {
    assert_eq!(rational(1, 3) + rational(1, 6), rational(1, 2));
    assert_eq!(rational(2, 3) * rational(9, 4), rational(3, 2));
    assert_eq!(rational(1, 3) - rational(1, 3), Number::ZERO);
    assert_eq!(rational(-4, -6), rational(2, 3));
    assert_eq!(rational(2, -4), rational(-1, 2));
    assert_eq!(rational(2, 3).powi(-3), Some(rational(27, 8)));
    assert_eq!(Number::pi().div(Number::pi()), Some(Number::ONE));
    assert_eq!(Number::pi() - Number::pi(), Number::ZERO);
    assert_eq!(rational(1, 2).div(Number::ZERO), None);
    assert_eq!(Number::ZERO.powi(-1), None);
    assert_eq!(Number::ZERO.powi(0), Some(Number::ONE));
    assert_eq!(Number::rational(1, 0), None);
    assert_eq!(Number::rational(i128::MIN, 3), None);
    assert_eq!(Number::ONE + Number::pi(), Number::Float(1.0 + consts::PI));
    let large = rational(i128::MAX, 1);
    assert_eq!(large + Number::ONE, Number::Float(i128::MAX as f64));
    assert_eq!(large * rational(1, i128::MAX), Number::ONE);
    assert_eq!(large * large, Number::Float((i128::MAX as f64) * (i128::MAX as f64)));
    assert_eq!(Number::from_f64(0.5) + Number::from_f64(0.5), Number::ONE);
    assert_eq!(Number::from_f64(-0.0), Number::ZERO);
    assert_eq!(Number::from_int(10).powi(60).unwrap().to_f64(), 1e60);
    // The one exponent of pi that has no opposite.
    let least = Number::pi().recip().unwrap().powi(128).unwrap();
    assert!(matches!(least, Number::Exact { pi: i8::MIN, .. }), "{least}");
    let inverse = least.recip().unwrap();
    assert!(close(inverse.to_f64() / consts::PI.powi(128), 1.0, 1e-13), "{inverse}");
}

#[test]
fn order_is_that_of_the_values() {
    let ascending = [
        Number::from_f64(f64::NEG_INFINITY),
        rational(-7, 2),
        -Number::pi(),
        rational(-1, 3),
        Number::ZERO,
        rational(1, i128::MAX),
        rational(1, i128::MAX - 1),
        rational(1, 3),
        Number::from_f64(0.34),
        rational(i128::MAX - 1, i128::MAX),
        Number::ONE,
        Number::pi(),
        rational(22, 7),
        Number::from_f64(1e300),
    ];
    for pair in ascending.windows(2) {
        assert!(pair[0] < pair[1], "{} {}", pair[0], pair[1]);
    }
}

#[test]
fn numbers_print_in_their_shortest_exact_form() {
    let number = |text: &str| Number::parse_decimal(text).unwrap().to_string();
    assert_eq!(number("0.15"), "0.15");
    assert_eq!(number("-9.80665"), "-9.80665");
    assert_eq!(number("210000000000"), "2.1e11");
    assert_eq!(number("1000"), "1000");
    assert_eq!(number("0.0000001"), "0.0000001");
    assert_eq!(rational(1, 3).to_string(), "1/3");
    assert_eq!(rational(-5, 6).to_string(), "-5/6");
    assert_eq!((Number::pi() * rational(3, 4)).to_string(), "3*pi/4");
    assert_eq!((Number::pi() * Number::pi()).to_string(), "pi^2");
    assert_eq!(Number::pi().recip().unwrap().to_string(), "1/pi");
    assert_eq!((Number::pi().recip().unwrap() * rational(2, 3)).to_string(), "2/(3*pi)");
    assert_eq!(Number::from_f64(0.1).to_string(), "0.1");
    assert_eq!(Number::from_f64(1.5e-300).to_string(), "1.5e-300");
}

#[test]
fn zero_and_one_are_always_there() {
    let mut g = Graph::new();
    let length = g.len();
    assert!(!g.is_empty() && length == 2);
    assert_eq!((g.int(0), g.int(1)), (g.zero(), g.one()));
    assert_eq!(g.len(), length);
}

#[test]
fn functions_of_constants_are_exact_where_they_can_be() {
    let mut g = Graph::new();
    for twelfths in -36..=36_i64 {
        let angle = Number::pi() * rational(i128::from(twelfths), 12);
        let angle = g.number(angle);
        let (sine, cosine) = (g.sin(angle), g.cos(angle));
        let (s, c) = (g.as_number(sine).unwrap(), g.as_number(cosine).unwrap());
        let expected = twelfths as f64 * 15.0_f64.to_radians();
        // std's value of a rounded angle: one rounding of an angle up to 3 pi.
        assert!((s.to_f64() - expected.sin()).abs() < 2e-15 && (c.to_f64() - expected.cos()).abs() < 2e-15);
        let thirds_or_quarters = |n: i64| n.rem_euclid(12) % 6 == 0 || matches!(n.rem_euclid(12), 2 | 10);
        assert_eq!(matches!(s, Number::Exact { .. }), thirds_or_quarters(twelfths), "sin {twelfths}");
        assert_eq!(matches!(c, Number::Exact { .. }), thirds_or_quarters(twelfths + 6), "cos {twelfths}");
    }
}

/// Every function of every pair of these, those of one argument of the first.
#[test]
fn functions_of_constants_have_the_values_of_std() {
    let one = Number::ONE;
    let sizes = [
        rational(1, 2),
        one,
        rational(1, 3),
        rational(2, 1),
        rational(7, 3),
        Number::pi(),
        Number::Float(0.1),
    ];
    let constants: Vec<Number> = sizes.iter().flat_map(|&size| [size, -size]).chain([Number::ZERO]).collect();
    let mut g = Graph::new();
    for function in Function::ALL {
        for (&a, &b) in constants.iter().flat_map(|a| constants.iter().map(move |b| (a, b))) {
            let arguments = &[a, b][..function.arity()];
            let nodes: Vec<_> = arguments.iter().map(|&number| g.number(number)).collect();
            let values: Vec<f64> = arguments.iter().map(|number| number.to_f64()).collect();
            let expected = direct::function(function, &values);
            let folded = g.call(function, &nodes);
            let found = g.as_number(folded).map_or(f64::NAN, Number::to_f64);
            // A function that has no finite value stays as it is written. Both are within a unit in the last place; sin(pi)
            // is 0 here and 1.2e-16 there.
            let expected = if expected.is_finite() { expected } else { f64::NAN };
            assert!(
                close(found, expected, 4e-16),
                "{} of {arguments:?}: {found} {expected}",
                function.name()
            );
        }
    }
}
