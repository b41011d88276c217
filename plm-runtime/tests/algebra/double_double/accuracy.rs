//! Errors against the reference values.

use std::fmt::Write;

use plm_runtime::{DoubleDouble, Real, Scalar};

use super::{call, from_words};

/// Largest errors allowed, in EPSILON times the result. The operators' are those that are proved (src/double_double/mod.rs),
/// floor is exact; the others are measured on 20 000 arguments each, with a margin of a half.
const BOUNDS: [(&str, f64); 14] = [
    ("add", 0.75),
    ("sub", 0.75),
    ("mul", 1.25),
    ("div", 3.75),
    ("sqrt", 0.79),
    ("floor", 0.0),
    ("sin", 0.9),
    ("cos", 0.9),
    ("tan", 2.0),
    ("asin", 1.2),
    ("acos", 1.4),
    ("atan2", 1.3),
    ("exp", 0.4),
    ("ln", 1.1),
];

/// The committed reference values, or larger ones from the folder `PLM_TWOFOLD_REFERENCE`.
fn reference(file: &str, committed: &str) -> String {
    match std::env::var_os("PLM_TWOFOLD_REFERENCE") {
        Some(folder) => std::fs::read_to_string(std::path::Path::new(&folder).join(file)).unwrap(),
        None => committed.into(),
    }
}

/// What the four words of pi/2 leave open in the result of an angle of k quarter turns: an angle of k 2^-212, or k 2^-96.
fn turns<S: Real>(name: &str, angle: DoubleDouble<S>, result: f64) -> f64 {
    let slope = match name {
        "sin" | "cos" => 1.0,
        "tan" => result.mul_add(result, 1.0),
        _ => return 0.0,
    };
    let quarters = (angle.to_f64().abs() * std::f64::consts::FRAC_2_PI).round();
    slope * quarters * 0.5_f64.powi(4 * S::DIGITS as i32)
}

/// Largest error by function beyond that, in EPSILON times the result, and where. The words' differences are exact or of a size at
/// which the rounding of f64 does not matter.
fn errors<S: Real>(reference: &str, word: impl Fn(&str) -> S) -> Vec<(String, f64, String)> {
    let mut sections: Vec<(String, f64, String)> = Vec::new();
    for line in reference.lines() {
        if let Some((name, _)) = line.strip_prefix("= ").and_then(|section| section.split_once(' ')) {
            sections.push((name.into(), 0.0, String::new()));
            continue;
        }
        let words: Vec<S> = line.split(' ').map(&word).collect();
        let [arguments @ .., high, middle, low] = &words[..] else { panic!("{line}") };
        let pairs = arguments.chunks(2).map(|pair| from_words(pair[0], pair[1]));
        let arguments: Vec<DoubleDouble<S>> = pairs.collect();
        let (name, largest, place) = sections.last_mut().unwrap();
        let got = call(name, &arguments).unwrap_or_else(|| panic!("no function {name}"));
        let difference = (got.high() - *high).to_f64() + (got.low() - *middle).to_f64() - low.to_f64();
        let unit = high.to_f64().abs() * DoubleDouble::<S>::EPSILON.to_f64();
        let beyond = difference.abs() - turns(name, arguments[0], high.to_f64());
        // What is not a number is worst.
        let error = if beyond.is_nan() { f64::INFINITY } else { (beyond / unit).max(0.0) };
        if error > *largest {
            (*largest, *place) = (error, format!("{line}, got {got:?}"));
        }
    }
    sections
}

#[test]
fn errors_stay_below_their_bounds() {
    let double = reference("double_double_f64.txt", include_str!("../../reference/double_double_f64.txt"));
    let double = errors(&double, |word| f64::from_bits(u64::from_str_radix(word, 16).unwrap()));
    let single = reference("double_double_f32.txt", include_str!("../../reference/double_double_f32.txt"));
    let single = errors(&single, |word| f32::from_bits(u32::from_str_radix(word, 16).unwrap()));
    let mut failures = String::new();
    for (k, (name, bound)) in BOUNDS.into_iter().enumerate() {
        println!("/// | {name} | {:.2} | {:.2} | {bound} |", double[k].1, single[k].1);
        for (section, error, place) in [&double[k], &single[k]] {
            assert_eq!(section, name, "sections stand in the order of the bounds");
            if *error > bound {
                writeln!(failures, "{name}: {error:.3} > {bound}: {place}").unwrap();
            }
        }
    }
    assert_eq!((double.len(), single.len()), (BOUNDS.len(), BOUNDS.len()));
    assert!(failures.is_empty(), "{failures}");
}
