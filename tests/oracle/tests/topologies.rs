//! The study of random six-bars, some of them.
#![allow(clippy::unwrap_used, unreachable_pub, reason = "tests")]

#[allow(dead_code, reason = "the program prints more")]
#[path = "../src/topologies/study/mod.rs"]
mod study;

use plm_dynamic::Mechanism;

use self::study::chains::SixBar;
use self::study::search::{Outcome, STRAIGHT, outcome, search};
use self::study::{known, trace};

#[test]
fn linkages_of_known_straightness_are_rated_rightly() {
    for known in known::all().unwrap() {
        assert!(known.holds(), "{known:?}");
    }
}

#[test]
fn the_best_of_random_six_bars_runs_from_its_declaration() {
    let seed = 7;
    let found = search(seed, 24, 2);
    assert!(found.outcomes[..2] == [0, 1].map(|number| outcome(seed, number)));
    assert!(!found.outcomes.iter().any(|outcome| matches!(outcome, Outcome::Refused(_))), "{found:?}");
    let best = found.best().unwrap();
    assert!(best.portion.deviation <= STRAIGHT * best.portion.length);

    // The declaration that is printed has the path that was rated.
    let six_bar = SixBar::random(seed, best.number);
    let rated = trace::path(&trace::trace(&six_bar.declaration(None)).unwrap(), best.point);
    let mut run = Mechanism::from_text(&six_bar.declaration(Some(best.point))).unwrap().start().unwrap();
    for (k, [x, y]) in rated.iter().enumerate().step_by(trace::SAMPLES / 9) {
        run.step_to(k as f64 / trace::SAMPLES as f64).unwrap();
        let off = (run.row()[0] - 1e3 * x).hypot(run.row()[1] - 1e3 * y);
        assert!(off < 1e-6, "{off} mm at sample {k}");
    }
}
