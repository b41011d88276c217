//! The elementary functions in C beside those in Rust: the same bits, in both precisions.

#![allow(clippy::unwrap_used, reason = "a test ends where something is missing")]

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use plm_runtime::{Real, Scalar};

/// Arguments of each function.
const ARGUMENTS: usize = 20_000;

/// The driver: bits of two arguments a line, and the bits of all functions of them.
const MAIN: &str = r#"
#include <inttypes.h>
#include <stdio.h>

#include "plm_math.h"

static void show(plm_real x)
{
    if (x < x || x > x || !(x <= x)) {
        printf(" nan");
    } else {
        printf(" %" PRIx64, (uint64_t)plm_to_bits(x));
    }
}

int main(void)
{
    uint64_t a, b;
    while (scanf("%" SCNx64 " %" SCNx64, &a, &b) == 2) {
        const plm_real x = plm_of_bits((plm_bits)a), y = plm_of_bits((plm_bits)b);
        const plm_pair pair = plm_sin_cos(x);
        show(pair.sine);
        show(pair.cosine);
        show(plm_sqrt(x));
        show(plm_floor(x));
        show(plm_atan2(x, y));
        show(plm_asin(x));
        show(plm_acos(x));
        show(plm_exp(x));
        show(plm_ln(x));
        show(plm_sign(x));
        printf("\n");
    }
    return 0;
}
"#;

/// splitmix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014), of the seed 7.
struct Random(u64);

impl Random {
    fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
}

/// A number: special, of moderate size, or of any bits.
fn number<S: Real>(random: &mut Random, of_bits: impl Fn(u64) -> S) -> S {
    const SPECIAL: [f64; 12] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.5,
        -0.5,
        core::f64::consts::FRAC_PI_2,
        1e-300,
        f64::INFINITY,
        f64::NAN,
        402.0,
        411_774.0,
    ];
    match random.word() % 4 {
        0 => S::lit(SPECIAL[(random.word() % 12) as usize]),
        1 => of_bits(random.word()),
        2 => S::lit((random.word() as f64 / u64::MAX as f64 - 0.5) * 4.0),
        _ => S::lit((random.word() as f64 / u64::MAX as f64 - 0.5) * 2e6),
    }
}

fn compared<S: Real>(name: &str, options: &[&str], of_bits: impl Fn(u64) -> S, bits: impl Fn(S) -> u64) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).unwrap();
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/c/plm_math.h");
    fs::copy(source, folder.join("plm_math.h")).unwrap();
    fs::write(folder.join("main.c"), MAIN).unwrap();
    let (mut random, mut given, mut wanted) = (Random(7), String::new(), Vec::new());
    for _ in 0..ARGUMENTS {
        let [x, y] = [(); 2].map(|()| number(&mut random, &of_bits));
        let _ = writeln!(given, "{:x} {:x}", bits(x), bits(y));
        let (sine, cosine) = Scalar::sin_cos(x);
        let all = [
            sine,
            cosine,
            Scalar::sqrt(x),
            Scalar::floor(x),
            Scalar::atan2(x, y),
            Scalar::asin(x),
            Scalar::acos(x),
            Scalar::exp(x),
            Scalar::ln(x),
            x.signum0(),
        ];
        let mut line = String::new();
        for value in all {
            let _ = if value.partial_cmp(&value).is_none() {
                write!(line, " nan")
            } else {
                write!(line, " {:x}", bits(value))
            };
        }
        wanted.push((x, y, line));
    }
    fs::write(folder.join("given"), given).unwrap();
    let options = [&["-std=c99", "-O2", "-Wall", "-Wextra", "-Wconversion", "-Werror"], options].concat();
    let made = Command::new("cc")
        .args(options)
        .args(["main.c", "-o", "main"])
        .current_dir(&folder)
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let input = fs::File::open(folder.join("given")).unwrap();
    let ran = Command::new(folder.join("main")).stdin(input).output().unwrap();
    let said = String::from_utf8(ran.stdout).unwrap();
    assert_eq!(said.lines().count(), ARGUMENTS);
    for (own, (x, y, wanted)) in said.lines().zip(&wanted) {
        assert_eq!(own, wanted, "{x:?} {y:?}");
    }
}

#[test]
fn functions_have_the_bits_of_rust_in_double_precision() {
    compared::<f64>("math-double", &[], f64::from_bits, f64::to_bits);
}

/// Roots by integers, as on processors that have none.
#[test]
fn roots_by_integers_have_the_bits_of_rust() {
    compared::<f64>("math-root", &["-U__SSE2__"], f64::from_bits, f64::to_bits);
}

#[test]
fn functions_have_the_bits_of_rust_in_single_precision() {
    compared::<f32>(
        "math-single",
        &["-DPLM_SINGLE"],
        |bits| f32::from_bits(bits as u32),
        |x| u64::from(x.to_bits()),
    );
}
