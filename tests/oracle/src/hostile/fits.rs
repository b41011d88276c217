//! `plm::optimise` with hostile numbers.

use plm_dynamic::Mechanism;
use plm_studies::optimise::{ByDop853, Control, Experiment, Identification, Loss, Unknown, base_parameters};

use super::{Call, Hostile, Outcome, ended};

pub(super) const CALLS: &[Call] = &[
    Call { name: "optimise::identify", call: identified },
    Call { name: "optimise::control", call: controlled },
    Call { name: "optimise::base_parameters", call: base },
];

fn unknown(h: &mut Hostile) -> Unknown {
    let mut own = Unknown::parameter(*h.draw.one_of(&["k", "c", "load"]));
    if h.draw.chance(0.4) {
        own = own.from(h.within(0.5, 50.0));
    }
    if h.draw.chance(0.4) {
        own = own.within(h.within(0.0, 1.0), h.within(2.0, 90.0));
    }
    if h.draw.chance(0.2) {
        own = own.expected(h.within(0.0, 1.0), h.within(0.1, 2.0));
    }
    if h.draw.chance(0.2) {
        own = own.of_size(h.within(0.1, 2.0));
    }
    own
}

fn identified(h: &mut Hostile) -> Outcome {
    let own = match Mechanism::from_text(super::runs::OSCILLATOR).and_then(|own| own.small()) {
        Ok(own) => own,
        Err(why) => return Outcome::Refused(why.to_string()),
    };
    let mut times: Vec<f64> = (1..8).map(|k| 0.05 * f64::from(k)).collect();
    if h.draw.chance(0.2) {
        let at = h.draw.below(times.len());
        times[at] = h.within(0.0, 0.3);
        // A reading in a thousand years needs a run of a thousand years.
        times[at] = if times[at].is_finite() { times[at].min(0.3) } else { times[at] };
    }
    let readings: Vec<f64> = times.iter().map(|_| h.within(-0.1, 0.1)).collect();
    let mut experiment = Experiment::new(times).measured("b.x", "m", readings);
    if h.draw.chance(0.2) {
        experiment = experiment.deviation("b.x", h.within(1e-3, 1e-2));
    }
    if h.draw.chance(0.2) {
        experiment = experiment.input("push", "N", [0.0, h.within(0.1, 0.2)], [h.number(), h.number()]);
    }
    if h.draw.chance(0.1) {
        experiment = experiment.beginning_at(h.within(0.0, 0.2));
    }
    let mut problem = Identification::new(own).experiment(experiment).find(unknown(h)).iterations(20);
    if h.draw.chance(0.1) {
        problem = problem.loss(Loss::Huber(h.within(0.5, 2.0)));
    }
    ended(problem.run_by(ByDop853(1e-6)).map(|fit| (fit.to_string(), fit.table(), fit.notices())))
}

fn controlled(h: &mut Hostile) -> Outcome {
    let own = match Mechanism::from_text(super::runs::OSCILLATOR).and_then(|own| own.small()) {
        Ok(own) => own,
        Err(why) => return Outcome::Refused(why.to_string()),
    };
    let mut problem = Control::new(own, 3).duration(0.3).input("push", -5.0, 5.0).iterations(10);
    for _ in 0..=h.draw.below(2) {
        problem = match h.draw.below(7) {
            0 => problem.duration(h.within(0.1, 0.5)),
            1 => problem.input("push", h.within(-5.0, 0.0), h.within(0.0, 5.0)),
            2 => problem.from(h.list(3)),
            3 => problem.at_end("b.x", h.within(-0.1, 0.1)),
            4 => problem.within("b.x", h.within(-1.0, -0.5), h.within(0.5, 1.0)),
            5 => problem.effort("push", h.within(0.1, 1.0)),
            _ => problem.deviation("b.x", h.within(-0.1, 0.1), h.within(0.1, 1.0)),
        };
    }
    ended(problem.effort("push", 1.0).run_by(ByDop853(1e-6)))
}

fn base(h: &mut Hostile) -> Outcome {
    let own = Mechanism::from_text(super::runs::OSCILLATOR).and_then(|own| own.small());
    match own {
        Ok(own) => ended(base_parameters(&own, h.numbers())),
        Err(why) => Outcome::Refused(why.to_string()),
    }
}
