//! Mechanisms side by side from CUDA C: as C on this machine, and its kernels thread by thread, with what stands in for CUDA.

use std::fs;
use std::path::Path;
use std::process::Command;

use plm_dynamic::Mechanism;
use plm_source::Precision;

use crate::support::STRICT;

/// A line of a program of CUDA C, of one mechanism: its status and part, then states and outputs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Said {
    pub(crate) status: i32,
    pub(crate) part: i32,
    pub(crate) numbers: Vec<u64>,
}

/// The two ways in which it is compiled.
pub(crate) const WAYS: [&str; 2] = ["loop", "kernel"];

/// The lines of the mechanisms side by side.
pub(crate) fn said(
    name: &str,
    mechanism: &Mechanism,
    precision: Precision,
    way: &str,
    words: &[&str],
) -> Vec<Said> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cuda-{name}"));
    fs::create_dir_all(&folder).unwrap();
    let files = plm_source::cuda(mechanism, precision).unwrap();
    for file in &files {
        fs::write(folder.join(&file.name), &file.text).unwrap();
    }
    let p = files[0].name.trim_end_matches(".h");
    let mut command = Command::new(if way == "loop" { "cc" } else { "c++" });
    if way == "loop" {
        command.args(STRICT).args([format!("{p}_run.c"), format!("{p}_batch.c"), format!("{p}.c")]);
    } else {
        let stand_in = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/support/cuda.h");
        command.args(["-std=c++17", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-include"]);
        command.arg(stand_in).args(["-x", "c++", &format!("{p}_run.c")]);
    }
    let made = command.args(["-o", way]).current_dir(&folder).output().unwrap();
    assert!(made.status.success(), "{name} {way}:\n{}", String::from_utf8_lossy(&made.stderr));
    let ran = Command::new(folder.join(way)).args(words).output().unwrap();
    assert!(ran.status.success(), "{name} {way}:\n{}", String::from_utf8_lossy(&ran.stderr));
    String::from_utf8(ran.stdout).unwrap().lines().map(of_line).collect()
}

fn of_line(line: &str) -> Said {
    let mut words = line.split(' ');
    let mut integer = || words.next().unwrap().parse().unwrap();
    let [status, part] = [integer(), integer()];
    Said { status, part, numbers: words.map(bits).collect() }
}

/// The bits of a number as C's `%a` writes it; those of what is not a number are one.
fn bits(text: &str) -> u64 {
    let (sign, rest) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let number = match rest {
        "nan" => return f64::NAN.to_bits(),
        "inf" => f64::INFINITY,
        rest => {
            let (digits, exponent) = rest.strip_prefix("0x").unwrap().split_once('p').unwrap();
            let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
            let mantissa = u64::from_str_radix(&format!("{whole}{fraction}"), 16).unwrap();
            let exponent: i32 = exponent.parse().unwrap();
            mantissa as f64 * 2f64.powi(exponent - 4 * fraction.len() as i32)
        }
    };
    (sign * number).to_bits()
}

/// Numbers in a line of [`expected`](crate::support::expected).
pub(crate) fn numbers(line: &str) -> Vec<u64> {
    let number = |word| f64::from_bits(u64::from_str_radix(word, 16).unwrap());
    line.split(' ')
        .map(number)
        .map(|number| if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() })
        .collect()
}
