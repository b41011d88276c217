//! Sources of mechanisms, compiled and run, beside steps from text.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use plm_dynamic::Mechanism;
use plm_source::{Failure, Precision};

/// A run of a source: who compiles it, in what numbers, and its steps.
#[derive(Clone, Debug)]
pub(crate) struct Ran<'a> {
    /// Where its files are written.
    pub(crate) folder: &'a Path,
    pub(crate) compiler: &'a str,
    pub(crate) options: &'a [&'a str],
    pub(crate) precision: Precision,
    /// The length of a step, s.
    pub(crate) h: f64,
    pub(crate) steps: usize,
}

/// Options with which every warning is an error.
pub(crate) const STRICT: &[&str] =
    &["-std=c99", "-O2", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"];

/// What is printed of a run, step by step: the bits of every number of the state, then those of the outputs.
const MAIN: &str = r#"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "NAME.h"

static void show(const NAME *self)
{
    size_t k;
    for (k = 0; k + 1 < COUNT + 1; k++) {
        BITS bits;
        memcpy(&bits, &self->x[k], sizeof bits);
        printf("%" PRIx64 " ", (uint64_t)bits);
    }
    for (k = 0; k + 1 < OUTPUTS + 1; k++) {
        REAL value;
        BITS bits;
        if (NAME_get(self, PLM_OUTPUT, k, &value) != PLM_OK) {
            printf("none ");
            continue;
        }
        memcpy(&bits, &value, sizeof bits);
        printf("%" PRIx64 " ", (uint64_t)bits);
    }
    printf("\n");
}

int main(void)
{
    NAME self;
    int k;
    const int wrong = NAME_check();
    if (wrong != 0) {
        printf("check %d\n", wrong);
        return 0;
    }
    NAME_init(&self);
    show(&self);
    for (k = 0; k < STEPS; k++) {
        if (NAME_step(&self, (REAL)LENGTH) != PLM_OK) {
            printf("failed %s\n", NAME_text(&self));
            return 0;
        }
        show(&self);
    }
    return 0;
}
"#;

/// Outcome of a source.
#[derive(Debug)]
pub(crate) enum Outcome {
    /// The bits of the states and of the outputs, a line for the start and for each step; the last line may say why it failed.
    Lines(Vec<String>),
    /// There is no source.
    Refused(String),
    /// It does not compile, or cannot be run.
    Broken(String),
}

/// Writes, compiles and runs a source.
pub(crate) fn run(mechanism: &Mechanism, of: &Ran<'_>) -> Outcome {
    let files = match plm_source::c(mechanism, of.precision) {
        Ok(files) => files,
        Err(failure @ (Failure::Refused(_) | Failure::Start(_))) => {
            return Outcome::Refused(failure.to_string());
        }
    };
    ran(mechanism, of, &files).map_or_else(Outcome::Broken, Outcome::Lines)
}

fn ran(mechanism: &Mechanism, of: &Ran<'_>, files: &[plm_source::File]) -> Result<Vec<String>, String> {
    let said = |why: std::io::Error| why.to_string();
    fs::create_dir_all(of.folder).map_err(said)?;
    for file in files {
        fs::write(of.folder.join(&file.name), &file.text).map_err(said)?;
    }
    let name = files.first().map_or("", |file| file.name.as_str()).trim_end_matches(".h");
    let outputs = mechanism.lowered().outputs.iter().filter(|output| output.declared).count();
    let states = mechanism.steps().map_err(|error| error.to_string())?.numbers().x.len();
    let (bits, real) = match of.precision {
        Precision::Double => ("uint64_t", "double"),
        Precision::Single => ("uint32_t", "float"),
    };
    let words = [
        ("BITS", bits.to_owned()),
        ("REAL", real.to_owned()),
        ("OUTPUTS", format!("{outputs}u")),
        ("STEPS", of.steps.to_string()),
        ("COUNT", format!("{states}u")),
        ("LENGTH", format!("{:e}", of.h)),
        ("NAME", name.to_owned()),
    ];
    let main = words.iter().fold(MAIN.to_owned(), |text, (word, value)| text.replace(word, value));
    fs::write(of.folder.join("main.c"), main).map_err(said)?;
    let source = format!("{name}.c");
    let made = Command::new(of.compiler)
        .args(of.options)
        .args(["-o", "run", "main.c", &source])
        .current_dir(of.folder)
        .output()
        .map_err(said)?;
    if !made.status.success() {
        return Err(format!("does not compile:\n{}", String::from_utf8_lossy(&made.stderr)));
    }
    let ran = Command::new(of.folder.join("run")).output().map_err(said)?;
    Ok(String::from_utf8_lossy(&ran.stdout).lines().map(|line| line.trim_end().to_owned()).collect())
}

/// The lines that steps by themselves give from text.
pub(crate) fn expected(mechanism: &Mechanism, h: f64, count: usize) -> Result<Vec<String>, String> {
    let mut run = mechanism.steps().map_err(|error| error.to_string())?;
    let outputs = mechanism.lowered().outputs.iter().enumerate().filter(|(_, output)| output.declared);
    let outputs: Vec<usize> = outputs.map(|(k, _)| k).collect();
    let mut lines = Vec::new();
    for k in 0..=count {
        if k > 0
            && let Err(fault) = plm_source::step(&mut run, mechanism, h)
        {
            lines.push(format!("failed {fault}"));
            break;
        }
        let mut line = String::new();
        for number in run.numbers().x {
            let _ = write!(line, "{:x} ", number.to_bits());
        }
        for output in &outputs {
            let _ = write!(line, "{:x} ", run.output(*output).unwrap_or(f64::NAN).to_bits());
        }
        lines.push(line.trim_end().to_owned());
    }
    Ok(lines)
}

/// Compares lines of a source with those of text: how many steps are the same to the end of both, or where they differ. What C leaves
/// undetermined (`none`) is not compared, nor the sign and the digits of what is not a number.
pub(crate) fn compared(own: &[String], text: &[String]) -> Result<usize, String> {
    for (k, (own, text)) in own.iter().zip(text).enumerate() {
        let both_failed = own.starts_with("failed") && text.starts_with("failed");
        let words = own.split(' ').zip(text.split(' '));
        let is_same = |(own, text): (&str, &str)| own == text || own == "none" || is_nan(own) && is_nan(text);
        if !both_failed
            && (own.split(' ').count() != text.split(' ').count() || !words.into_iter().all(is_same))
        {
            return Err(format!("step {k}:\n  C    {own}\n  text {text}"));
        }
    }
    if own.len() == text.len() {
        Ok(own.len() - 1)
    } else {
        Err(format!("{} lines of {}", own.len(), text.len()))
    }
}

fn is_nan(word: &str) -> bool {
    u64::from_str_radix(word, 16).is_ok_and(|bits| f64::from_bits(bits).is_nan())
}
