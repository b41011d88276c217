//! Sources with contact beside steps of Moreau and Jean from text: the same bits, step by step, by several options, and the check of each in
//! both precisions.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test ends where something is missing")]

#[path = "support/cuda.rs"]
mod cuda;
#[path = "support/scenes.rs"]
mod scenes;
mod support;

use std::path::Path;

use plm_dynamic::Mechanism;
use plm_source::Precision;
use scenes::scenes;
use support::{Outcome, Ran, STRICT, compared, expected, run};

fn lines(name: &str, mechanism: &Mechanism, options: &[&str], precision: Precision) -> Vec<String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("contact-{name}"));
    let of = Ran { folder: &folder, compiler: "cc", options, precision, h: 1e-3, steps: 1000 };
    match run(mechanism, &of) {
        Outcome::Lines(lines) => lines,
        Outcome::Refused(why) | Outcome::Broken(why) => panic!("{name}: {why}"),
    }
}

#[test]
fn steps_over_contact_have_the_bits_of_text() {
    for (name, mechanism) in scenes() {
        let text = expected(&mechanism, 1e-3, 1000).unwrap();
        for options in [STRICT, &["-std=gnu17", "-O3", "-ffp-contract=fast", "-march=native"]] {
            let own = lines(&name, &mechanism, options, Precision::Double);
            assert_eq!(compared(&own, &text), Ok(1000), "{name} {options:?}");
        }
    }
}

#[test]
fn the_check_of_each_holds_in_single_precision() {
    for (name, mechanism) in scenes() {
        let own = lines(&format!("{name}-single"), &mechanism, STRICT, Precision::Single);
        assert_eq!(own.len(), 1001, "{name}: {:?}", own.last());
    }
}

#[test]
fn mechanisms_side_by_side_have_the_bits_of_text() {
    for (name, mechanism) in scenes() {
        let text = expected(&mechanism, 1.0 / 1024.0, 1000).unwrap();
        for way in cuda::WAYS {
            let words = ["2", "1000", "0.0009765625"];
            for own in cuda::said(&name, &mechanism, Precision::Double, way, &words) {
                assert_eq!(
                    (own.status, own.numbers),
                    (0, cuda::numbers(text.last().unwrap())),
                    "{name} {way}"
                );
            }
        }
    }
}
