//! Every declaration of the book, of parts, examples and benchmarks as C source, in both formulations, and random scenes of contact: the bits of steps from text,
//! by several compilers' options and lengths of steps.

mod rubbing;

#[path = "../../../crates/plm-source/tests/support/mod.rs"]
mod support;

use std::env;
use std::{fs, thread};

use plm_dynamic::Mechanism;
use plm_source::Precision;

use self::support::{Outcome, Ran, STRICT, compared, expected, run};
use crate::declarations::{Scene, scenes};
use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// Lengths of steps, s: two that are exact, one as people write them, and one that is coarse.
const LENGTHS: [f64; 4] = [1.0 / 1024.0, 1.0 / 256.0, 1e-3, 0.01];
/// Options of the compiler.
const OPTIONS: [&[&str]; 3] = [STRICT, &["-std=c99", "-O0"], &["-std=gnu17", "-O3", "-march=native"]];
/// Steps of a case.
const STEPS: usize = 400;

pub(crate) fn case(draw: &mut Draw) -> Case {
    let subject = subject(draw);
    let (h, options) = (*draw.one_of(&LENGTHS), *draw.one_of(&OPTIONS));
    let (name, declared) = subject.named();
    let text = format!("{name}\n{declared}\nsteps of {h:e} s, cc {}", options.join(" "));
    let made;
    let mechanism = match &subject {
        Subject::Declared(scene, formulation) => scene.machine(*formulation),
        Subject::Drawn(text) => {
            made = Mechanism::from_text(text);
            made.as_ref().map_err(Clone::clone)
        }
    };
    let mechanism = match mechanism {
        Ok(mechanism) => mechanism,
        Err(error) => {
            let verdict = Verdict::Stopped(error.to_string());
            return Case { family: "no mechanism".to_owned(), text, verdict };
        }
    };
    let folder =
        env::temp_dir().join(format!("plm-source-{}-{:?}", std::process::id(), thread::current().id()));
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

/// A declaration of the repository, or one that was drawn.
enum Subject {
    /// With the number of its formulation.
    Declared(&'static Scene, usize),
    Drawn(String),
}

impl Subject {
    /// Its place, and its text.
    fn named(&self) -> (&str, &str) {
        match self {
            Self::Declared(scene, formulation) => (&scene.place, &scene.texts[*formulation]),
            Self::Drawn(text) => ("drawn", text),
        }
    }
}

fn subject(draw: &mut Draw) -> Subject {
    let scenes = scenes();
    if draw.chance(0.5) || scenes.is_empty() {
        return Subject::Drawn(rubbing::scene(draw));
    }
    let place = draw.place_in(scenes.len()).unwrap_or_else(|| draw.below(scenes.len()));
    Subject::Declared(&scenes[place], draw.below(scenes[place].texts.len()))
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
