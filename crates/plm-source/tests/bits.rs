//! C sources beside steps from text: the same bits, step by step; and CUDA C, as a loop and thread by thread.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test ends where something is missing")]

#[path = "support/cuda.rs"]
mod cuda;
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

/// Three of each side by side, after their last good step.
#[test]
fn mechanisms_side_by_side_have_the_bits_of_one() {
    for name in SNAPSHOTS {
        let mechanism = snapshot(name);
        let lines = expected(&mechanism, 1.0 / 1024.0, 1000).unwrap();
        let good: Vec<&String> = lines.iter().filter(|line| !line.starts_with("failed")).collect();
        let last = cuda::numbers(good.last().unwrap());
        for way in cuda::WAYS {
            let all = cuda::said(name, &mechanism, Precision::Double, way, &["3", "1000", "0.0009765625"]);
            assert_eq!(all.len(), 3);
            for own in all {
                assert_eq!(own.status == 0, good.len() == 1001, "{name} {way}: {own:?}");
                assert_eq!(own.numbers, last, "{name} {way}");
            }
        }
    }
}

/// A bar with a parameter of its own in each place of a batch, and a mass that may not be negative.
#[test]
fn each_mechanism_has_its_parameters_and_its_error() {
    let text = "pub Swings { gravity: 9.81 m/s^2; param mass: kg = 2 kg; param begins: deg = 30 deg; input drive: N*m = 0.25 N*m; \
        ground { port o: (0, 0) m; } body bar { mass: mass; inertia: 0.1 kg*m^2; port pivot: (0, 0.4) m; start angle: begins, locked; } \
        revolute hinge(ground.o, bar.pivot) { damping: 0.1 N*m*s/rad; drive: drive; } output bar.angle, hinge.force; }";
    let mut mechanism = Mechanism::from_text(text).unwrap();
    let step = ["5", "300", "0.0009765625"];
    for way in cuda::WAYS {
        let said = |words: &[&str]| {
            let words = [step.as_slice(), words].concat();
            cuda::said("swings", &Mechanism::from_text(text).unwrap(), Precision::Double, way, &words)
        };
        let all = said(&["0", "1", "3"]);
        for (own, mass) in all.iter().zip([1.0, 1.5, 2.0, 2.5, 3.0]) {
            mechanism.set_parameter("mass", mass).unwrap();
            let lines = expected(&mechanism, 1.0 / 1024.0, 300).unwrap();
            assert_eq!(
                (own.status, &own.numbers),
                (0, &cuda::numbers(lines.last().unwrap())),
                "{way} {mass} kg"
            );
        }
        assert!(all[0].numbers != all[4].numbers);
        // PLM_PARAMETER_VALUE, PLM_NOT_FINITE, and PLM_READ_ONLY where the start depends on it; the others go on.
        let status = |words: &[&str]| said(words).iter().map(|own| own.status).collect::<Vec<_>>();
        assert_eq!(status(&["0", "-2", "2"]), [10, 10, 10, 0, 0], "{way}");
        assert_eq!(status(&["0", "inf", "1"])[..1], [5], "{way}");
        let begins = mechanism.steps().unwrap().numbers().parameters[1].to_string();
        assert_eq!(status(&["1", &begins, "1"]), [0, 6, 6, 6, 6], "{way}");
    }
}

/// A requirement ends the mechanism that it belongs to, with its number.
#[test]
fn a_mechanism_that_ends_keeps_its_last_state() {
    let text = "pub Falls { gravity: 9.81 m/s^2; param least: m = 0.9 m; ground { port o: (0, 0) m; } body stone { mass: 1 kg; inertia: 1 kg*m^2; \
        port o: (0, 0) m; start y: 1 m; } require high: stone.y > least; output stone.y; }";
    let mechanism = Mechanism::from_text(text).unwrap();
    for way in cuda::WAYS {
        let words = ["2", "300", "0.0009765625", "0", "0.9", "0.5"];
        let all = cuda::said("falls", &mechanism, Precision::Double, way, &words);
        assert_eq!(all.iter().map(|own| own.status).collect::<Vec<_>>(), [12, 0], "{way}");
        let height = |own: &cuda::Said| f64::from_bits(*own.numbers.last().unwrap());
        assert!((height(&all[0]) - 0.9).abs() < 2e-3 && height(&all[0]) > 0.9, "{way}: {}", height(&all[0]));
        let fallen = 1.0 - 0.5 * 9.81 * (300.0f64 / 1024.0).powi(2);
        assert!((height(&all[1]) - fallen).abs() < 1e-12, "{way}");
    }
}
