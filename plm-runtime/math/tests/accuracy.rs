//! Largest errors against mpmath (tools/reference.py), and the bounds of ERRORS.md.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
#![allow(clippy::cast_lossless)] // lossless for one of both types

#[path = "support/bounds.rs"]
mod bounds;

use std::fmt::Write;

use bounds::bounds;

/// The committed reference values, or larger ones from the folder `PLM_MATH_REFERENCE`.
fn reference(file: &str, committed: &str) -> String {
    match std::env::var_os("PLM_MATH_REFERENCE") {
        Some(folder) => std::fs::read_to_string(std::path::Path::new(&folder).join(file)).unwrap(),
        None => committed.into(),
    }
}

macro_rules! accuracy {
    ($float:ident, $bits:ident) => {
        mod $float {
            use plm_math::$float as m;

            pub(crate) fn call(name: &str, x: &[$float]) -> Option<$float> {
                Some(match (name, x) {
                    ("sin", &[x]) => m::sin(x),
                    ("cos", &[x]) => m::cos(x),
                    ("tan", &[x]) => m::tan(x),
                    ("asin", &[x]) => m::asin(x),
                    ("acos", &[x]) => m::acos(x),
                    ("atan", &[x]) => m::atan(x),
                    ("atan2", &[y, x]) => m::atan2(y, x),
                    ("sqrt", &[x]) => m::sqrt(x),
                    ("exp", &[x]) => m::exp(x),
                    ("ln", &[x]) => m::ln(x),
                    ("hypot", &[x, y]) => m::hypot(x, y),
                    ("powi", &[x, n]) => m::powi(x, n as i32),
                    ("abs", &[x]) => m::abs(x),
                    ("copysign", &[x, s]) => m::copysign(x, s),
                    ("min", &[a, b]) => m::min(a, b),
                    ("max", &[a, b]) => m::max(a, b),
                    ("floor", &[x]) => m::floor(x),
                    ("round_ties_even", &[x]) => m::round_ties_even(x),
                    _ => return None,
                })
            }

            /// Distance of a result from the reference, whose magnitude is `rest` units larger than `result`.
            fn error(got: $float, result: $float, rest: f64) -> f64 {
                let (got_place, place) = (got.abs().to_bits(), result.abs().to_bits());
                let distance = got_place.abs_diff(place) as f64;
                if got.is_sign_negative() != result.is_sign_negative() {
                    got_place as f64 + place as f64 + rest
                } else if got_place > place {
                    distance - rest
                } else {
                    distance + rest
                }
            }

            /// Largest error by section, in units in the last place, and where.
            pub(crate) fn errors(reference: &str) -> Vec<(String, String, f64, String)> {
                let mut sections: Vec<(String, String, f64, String)> = Vec::new();
                for line in reference.lines() {
                    if let Some((name, range)) = line.strip_prefix("= ").and_then(|l| l.split_once(' ')) {
                        sections.push((name.into(), range.into(), 0.0, String::new()));
                        continue;
                    }
                    let words: Vec<$bits> =
                        line.split(' ').map(|word| $bits::from_str_radix(word, 16).unwrap()).collect();
                    let [arguments @ .., result, rest] = &words[..] else { panic!("{line}") };
                    let arguments: Vec<$float> = arguments.iter().map(|&b| $float::from_bits(b)).collect();
                    let (name, _, largest, place) = sections.last_mut().unwrap();
                    let got = call(name, &arguments).unwrap_or_else(|| panic!("no function {name}"));
                    let error = error(got, $float::from_bits(*result), *rest as f64 / 4096.0);
                    if error > *largest {
                        (*largest, *place) = (error, format!("{line}, got {:x}", got.to_bits()));
                    }
                }
                sections
            }
        }
    };
}

accuracy!(f64, u64);
accuracy!(f32, u32);

#[test]
fn errors_stay_below_the_table() {
    let bounds = bounds();
    let f64_errors = f64::errors(&reference("f64.txt", include_str!("reference/f64.txt")));
    let f32_errors = f32::errors(&reference("f32.txt", include_str!("reference/f32.txt")));
    let mut failures = String::new();
    for (double, single) in f64_errors.iter().zip(&f32_errors) {
        let (name, range, ..) = double;
        println!("| {name} | {range} | {:.3} | {:.3} |", double.2, single.2);
        let bound = bounds[&(name.clone(), range.clone())];
        for ((_, _, error, place), bound) in [double, single].into_iter().zip(bound) {
            if *error > bound {
                writeln!(failures, "{name} {range}: {error:.3} > {bound}: {place}").unwrap();
            }
        }
    }
    assert_eq!(f64_errors.len(), bounds.len(), "each row of ERRORS.md has reference values");
    assert!(failures.is_empty(), "{failures}");
}

#[test]
fn every_public_function_has_a_bound() {
    let bounds = bounds();
    let lines = include_str!("../src/functions.rs").lines().map(str::trim);
    let names = lines.filter_map(|line| line.strip_prefix("pub fn ").or(line.strip_prefix("pub const fn ")));
    let names: Vec<&str> = names.filter_map(|line| line.split(['(', '<']).next()).collect();
    assert!(names.len() >= 20, "{names:?}");
    for name in names {
        // tests/bits.rs compares these with those of one number, or they only say how they are computed.
        let same_bits = [
            "sin_cos",
            "sin_cos_lanes",
            "sin_cos_direct",
            "sin_cos_lanes_direct",
            "are_direct",
            "atan2_lanes",
            "exp_lanes",
            "ln_lanes",
        ]
        .contains(&name);
        let bound = bounds.keys().any(|(function, _)| function == name);
        assert!(same_bits || bound, "{name} has no row in ERRORS.md");
    }
}
