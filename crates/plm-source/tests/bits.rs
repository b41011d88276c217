//! C sources beside steps from text: the same bits, step by step.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test ends where something is missing")]

mod support;

use std::path::{Path, PathBuf};

use plm_dynamic::Mechanism;
use plm_source::Precision;
use support::{Outcome, Ran, STRICT, compared, expected, run};

/// The declarations of the snapshots.
const SNAPSHOTS: [&str; 8] = [
    "arm_on_jack",
    "bouncer",
    "chain",
    "double_pendulum",
    "driven_crank",
    "four_bar",
    "plate_on_three_pins",
    "slider_crank",
];

fn snapshot(name: &str) -> Mechanism {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/snapshots");
    Mechanism::from_file(root.join(format!("{name}.plm"))).unwrap()
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("source-{name}"))
}

/// How many steps are the same; what is refused.
fn same(name: &str, mechanism: &Mechanism, options: &[&str], h: f64) -> Result<usize, String> {
    let folder = folder(name);
    let of = Ran { folder: &folder, compiler: "cc", options, precision: Precision::Double, h, steps: 1000 };
    match run(mechanism, &of) {
        Outcome::Refused(why) => Err(why),
        Outcome::Broken(why) => panic!("{name}: {why}"),
        Outcome::Lines(own) => {
            let text = expected(mechanism, h, 1000).unwrap();
            Ok(compared(&own, &text).unwrap_or_else(|why| panic!("{name}: {why}")))
        }
    }
}

#[test]
fn snapshots_have_the_bits_of_steps_from_text() {
    for name in SNAPSHOTS {
        let steps = same(name, &snapshot(name), STRICT, 1.0 / 1024.0);
        match name {
            // A vacuum ends it there.
            "arm_on_jack" => assert_eq!(steps, Ok(15), "{name}"),
            _ => assert_eq!(steps, Ok(1000), "{name}"),
        }
    }
}

#[test]
fn no_option_of_a_compiler_changes_a_bit() {
    for (number, options) in [
        ["-std=c99", "-O0"].as_slice(),
        &["-std=gnu99", "-O3", "-march=native"],
        &["-std=gnu17", "-Os", "-ffp-contract=fast", "-march=native"],
        &["-x", "c++", "-std=c++17", "-O2"],
    ]
    .into_iter()
    .enumerate()
    {
        for name in ["four_bar", "chain", "bouncer", "slider_crank"] {
            assert_eq!(
                same(&format!("{name}-{number}"), &snapshot(name), options, 1e-3),
                Ok(1000),
                "{options:?}"
            );
        }
    }
}

/// Numbers of 32 bits: the check of each source holds, whose bits Rust has computed in `f32`.
#[test]
fn single_precision_has_the_bits_of_f32() {
    for name in SNAPSHOTS {
        let (mechanism, folder) = (snapshot(name), folder(&format!("{name}-single")));
        let options = STRICT;
        let of = Ran {
            folder: &folder,
            compiler: "cc",
            options,
            precision: Precision::Single,
            h: 1e-3,
            steps: 10,
        };
        match run(&mechanism, &of) {
            Outcome::Lines(lines) => assert!(lines.len() == 11, "{name}: {:?}", lines.last()),
            Outcome::Refused(why) | Outcome::Broken(why) => panic!("{name}: {why}"),
        }
    }
}
