//! Every declaration of the book, of parts, examples and benchmarks as C source: the bits of steps from text, by several compilers' options
//! and lengths of steps.

#[path = "../../../crates/plm-source/tests/support/mod.rs"]
mod support;

use std::env;
use std::fs;

use plm_source::Precision;

use self::support::{Outcome, Ran, STRICT, compared, expected, run};
use crate::declarations::scenes;
use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// Lengths of steps, s: two that are exact, one as people write them, and one that is coarse.
const LENGTHS: [f64; 4] = [1.0 / 1024.0, 1.0 / 256.0, 1e-3, 0.01];
/// Options of the compiler.
const OPTIONS: [&[&str]; 3] = [STRICT, &["-std=c99", "-O0"], &["-std=gnu17", "-O3", "-march=native"]];
/// Steps of a case.
const STEPS: usize = 400;

pub(crate) fn case(draw: &mut Draw) -> Case {
    let scenes = scenes();
    let place = draw.place_in(scenes.len()).unwrap_or_else(|| draw.below(scenes.len()));
    let Some(scene) = scenes.get(place) else {
        return Case {
            family: "-".to_owned(),
            text: String::new(),
            verdict: Verdict::Wrong("no scene".to_owned()),
        };
    };
    let (h, options) = (*draw.one_of(&LENGTHS), *draw.one_of(&OPTIONS));
    let text = format!("{}\n{}\nsteps of {h:e} s, cc {}", scene.place, scene.texts[0], options.join(" "));
    let mechanism = match scene.machine(0) {
        Ok(mechanism) => mechanism,
        Err(error) => {
            let verdict = Verdict::Stopped(error.to_string());
            return Case { family: "no mechanism".to_owned(), text, verdict };
        }
    };
    let folder = env::temp_dir().join(format!("plm-source-{}-{place}", std::process::id()));
    let of = Ran { folder: &folder, compiler: "cc", options, precision: Precision::Double, h, steps: STEPS };
    let (family, verdict) = match run(mechanism, &of) {
        Outcome::Refused(why) => (what(&why), Verdict::Stopped(why)),
        Outcome::Broken(why) => ("printed".to_owned(), Verdict::Wrong(why)),
        Outcome::Lines(own) => ("printed".to_owned(), judged(&own, expected(mechanism, h, STEPS))),
    };
    // Nothing of it is asked for any more.
    let _ = fs::remove_dir_all(&folder);
    Case { family, text, verdict }
}

/// The ability whose lack is told first.
fn what(refusal: &str) -> String {
    let first = refusal.lines().find_map(|line| line.split_once("`: "));
    first.map_or("no start", |(_, what)| what).to_owned()
}

fn judged(own: &[String], text: Result<Vec<String>, String>) -> Verdict {
    match text.and_then(|text| compared(own, &text)) {
        Ok(_) => Verdict::Right(0.0),
        Err(why) => Verdict::Wrong(why),
    }
}
