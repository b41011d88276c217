//! Results files that somebody has tampered with: a corpus of files, and files that are made of good ones by random mutations.
//!
//! `PLM_MUTATIONS=300000 PLM_SEED=7 cargo test -p plm-view --test mutated` makes more of them, or others. A case that is wrong
//! is kept as a file and named by its number.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod archive;
mod mutations;
mod random;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use plm_view::{Recording, Results};

use archive::Form;
use random::Random;

fn corpus(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus").join(name)
}

/// Numbers of all runs, times among them.
fn numbers(of: &Results) -> Vec<f64> {
    let of_run = |run: &Recording| {
        let rows = (0..run.len()).flat_map(|row| {
            let poses = run.poses(row).iter().flatten();
            let ground = run.ground(row).iter().flatten();
            poses.chain(ground).copied().collect::<Vec<f64>>()
        });
        rows.chain(run.rows().flatten().copied()).chain(run.times().iter().copied()).collect::<Vec<f64>>()
    };
    of.runs.iter().flat_map(of_run).collect()
}

fn bits(of: &Results) -> Vec<u64> {
    numbers(of).into_iter().map(f64::to_bits).collect()
}

/// The length in the header of an array is anything that a word can be.
#[test]
fn a_length_that_no_array_has_is_told() {
    for (name, rows) in [("panics.npz", "9223372036854775807"), ("wraps_to_0.npz", "4611686018427387904")] {
        let error = Results::read(corpus(name)).unwrap_err();
        assert_eq!(error.problems(), [format!("0/values.npy is cut off after 15 of {rows} rows")], "{name}");
        let run = &error.whole().runs[0];
        assert_eq!((run.len(), run.rows().flatten().filter(|x| x.is_nan()).count()), (15, 0), "{name}");
    }
}

/// Lengths stand after the contents there, and in the directory.
#[test]
fn an_archive_that_was_written_to_a_stream_is_read() {
    let read = Results::read(corpus("streamed.npz")).unwrap();
    let run = &read.runs[0];
    assert_eq!((run.len(), run.columns().len(), run.about.mechanism.bodies.len()), (15, 4, 3));
    assert!(numbers(&read).iter().all(|number| number.is_finite()));
    // The same run as in its sibling, whose poses are whole.
    let sibling = Results::read(corpus("panics.npz")).unwrap_err().into_whole();
    assert_eq!(bits(&read), bits(&sibling));
}

/// One that ends within the last number of a line is no other than one without the last line break.
#[test]
fn a_table_that_ends_within_a_line_is_told() {
    let text = std::fs::read(corpus("cut.csv")).unwrap();
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cut.csv");
    let comma = text.iter().rposition(|byte| *byte == b',').unwrap();
    std::fs::write(&path, &text[..comma]).unwrap();
    let error = Recording::read_csv(path).unwrap_err();
    let problem = "line 16: found 4 fields, expected 5 fields, as in line 1; the file is cut off there";
    assert_eq!(error.problems(), [problem]);
    assert_eq!(error.whole().len(), 14);
    assert_eq!(error.whole().times().last(), Some(&0.285_993_680_741_778_56));
    assert_eq!(Recording::read_csv(corpus("cut.csv")).unwrap().len(), 15);
}

/// What is seen of a results file whatever was done to it.
fn look_at(bytes: &[u8]) -> (Results, Vec<String>) {
    /// What the good files need, some ten times over.
    const MOST: usize = 1 << 18;

    let (read, problems) = Results::from_bytes_within(bytes, MOST);
    let held = size_of::<f64>() * numbers(&read).len();
    assert!(held <= MOST, "{held} bytes of numbers, and {MOST} were allowed");
    if problems.is_empty() {
        let gaps = numbers(&read).iter().filter(|number| number.is_nan()).count();
        assert_eq!(gaps, 0, "numbers are missing, and nothing is said");
        let (again, problems) = Results::from_bytes(&read.to_bytes().unwrap());
        assert_eq!((bits(&again), problems), (bits(&read), vec![]), "it cannot be written and read again");
    }
    (read, problems)
}

/// One random file: entries are changed and put into an archive, which is whole; then its bytes are damaged.
fn case(random: &mut Random, kept: &mut Vec<u8>) -> bool {
    let mut archive = random.of(&archive::seeds());
    for _ in 0..random.below(3) {
        mutations::change(random, &mut archive);
    }
    let form = random.of(&[Form::Stored, Form::Stored, Form::Deflated, Form::Streamed]);
    let whole = archive.to_bytes(form);
    kept.clone_from(&whole);
    let (read, problems) = look_at(&whole);
    let mut damaged = whole;
    for _ in 0..random.below(3) {
        mutations::damage(random, &mut damaged);
    }
    kept.clone_from(&damaged);
    let (read_damaged, problems_damaged) = look_at(&damaged);
    if problems_damaged.is_empty() {
        assert_eq!(problems, problems_damaged, "damage mends what is wrong");
        assert_eq!(bits(&read_damaged), bits(&read), "damage changes numbers, and nothing is said");
    }
    problems.is_empty()
}

fn setting<T: FromStr>(name: &str, usual: T) -> T {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// Never a panic, never more memory than is allowed, and numbers are whole or something is said.
#[test]
fn mutated_files_are_read_or_told() {
    let (count, seed) = (setting("PLM_MUTATIONS", 800_u64), setting("PLM_SEED", 20_261_124_u64));
    println!("seed {seed}");
    let mut good = 0;
    for number in 0..count {
        let mut kept = Vec::new();
        let outcome = catch_unwind(AssertUnwindSafe(|| case(&mut Random::new(seed, number), &mut kept)));
        good += u64::from(outcome.unwrap_or_else(|_| {
            let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("mutated-{seed}-{number}.npz"));
            std::fs::write(&path, kept).unwrap();
            panic!("case {number} of seed {seed}: {}", path.display())
        }));
    }
    // Most mutations are found, and some change nothing that counts.
    println!("{good} of {count} files were good before their bytes were damaged");
    assert!(good > count / 10 && good < count * 9 / 10, "{good} of {count}");
}

/// A table with some of its bytes changed: rows before what is wrong, and no panic.
#[test]
fn mutated_tables_are_read_or_told() {
    let seed = setting("PLM_SEED", 20_261_124_u64);
    println!("seed {seed}");
    let text = std::fs::read(corpus("cut.csv")).unwrap();
    let whole = &text[..=text.iter().rposition(|byte| *byte == b'\n').unwrap()];
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mutated.csv");
    for cut in (1..=whole.len()).rev().step_by(7) {
        std::fs::write(&path, &whole[..cut]).unwrap();
        let read = Recording::read_csv(&path);
        let is_ok = read.is_ok();
        let read = read.unwrap_or_else(plm_view::Unread::into_whole);
        let end = whole[..cut].iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
        let (lines, rest) = whole[..cut].split_at(end);
        let lines = lines.split(|byte| *byte == b'\n').count() - 1;
        // A line of numbers is whole where its last field is one.
        let last = str::from_utf8(rest).unwrap().split(',').nth(4).unwrap_or_default();
        let is_whole = lines > 0 && last.parse::<f64>().is_ok();
        assert!(lines == 0 || is_ok == (rest.is_empty() || is_whole), "cut off after {cut} bytes");
        assert_eq!(read.len(), lines.saturating_sub(1) + usize::from(is_whole), "cut off after {cut} bytes");
    }
    for number in 0..200 {
        let mut random = Random::new(seed, number);
        let mut bytes = whole.to_vec();
        for _ in 0..=random.below(4) {
            mutations::damage(&mut random, &mut bytes);
        }
        std::fs::write(&path, &bytes).unwrap();
        match Recording::read_csv(&path) {
            Ok(read) => assert!(is_read_again(&read), "case {number} of seed {seed}"),
            Err(error) => assert!(!error.problems().is_empty()),
        }
    }
}

/// Is its table the same again?
fn is_read_again(table: &Recording) -> bool {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mutated-again.csv");
    table.write_csv(&path).unwrap();
    let shown = |of: &Recording| format!("{:?} {:?}", of.times(), of.rows().collect::<Vec<_>>());
    Recording::read_csv(&path).is_ok_and(|again| shown(&again) == shown(table))
}
