//! Linear systems and studies with hostile numbers.

use std::hint::black_box;

use plm_dynamic::{Dynamic, Mechanism};
use plm_runtime::Mechanism as _;
use plm_studies::analysis::control::{Cost, continuous_riccati, discrete_riccati, frequencies, root_locus};
use plm_studies::analysis::{DMatrix, Linearisation, linearise, stabilise};
use plm_studies::study::{Points, Spread, linear};

use super::{Call, Hostile, Outcome, ended};

pub(super) const CALLS: &[Call] = &[
    Call { name: "analysis::linearise", call: linearised },
    Call { name: "analysis::control", call: controlled },
    Call { name: "analysis::riccati", call: riccati },
    Call { name: "analysis::stabilise", call: stabilised },
    Call { name: "study", call: study },
];

type Small = Dynamic<f64, 24, 32, 64, 24>;

/// A mass on a spring, whose numbers are set.
fn mechanism(h: &mut Hostile) -> Result<Small, plm_dynamic::Error> {
    let mut own = Mechanism::from_text(super::runs::OSCILLATOR)?;
    for name in ["k", "c", "load"] {
        own.set_parameter(name, h.within(0.1, 5.0))?;
    }
    own.small()
}

fn system(h: &mut Hostile) -> Result<Linearisation, String> {
    let sim = mechanism(h).map_err(|error| error.to_string())?.start().map_err(|fault| fault.to_string())?;
    linearise(&sim).map_err(|fault| fault.to_string())
}

fn linearised(h: &mut Hostile) -> Outcome {
    let own = system(h);
    if let Ok(own) = &own {
        black_box((own.modes(), own.to_string(), own.shapes()));
    }
    ended(own)
}

fn controlled(h: &mut Hostile) -> Outcome {
    let own = match system(h) {
        Ok(own) => own,
        Err(why) => return Outcome::Refused(why),
    };
    let sampled = own.sampled(h.within(0.01, 0.5));
    black_box((own.poles(), own.not_reached(), own.not_shown()));
    black_box((sampled.poles(), sampled.modes(), sampled.not_reached(), sampled.not_shown()));
    let _ = black_box(own.regulator(&[("b.x", h.number())], &[("push", h.number())]));
    let _ = black_box(own.estimator(&[("push", h.number())], &[("b.x", h.number())]));
    let _ = black_box(sampled.regulator(&[("b.x", h.number())], &[("push", h.number())]));
    let _ = black_box(sampled.estimator(&[("push", h.number())], &[("b.x", h.number())]));
    let over = frequencies(h.within(0.1, 1.0), h.within(1.0, 100.0), 5);
    let _ = black_box(own.bode("push", "b.x", &over));
    let _ = black_box((own.response("push", "b.x", h.number()), own.zeros("push", "b.x")));
    let values = h.list(4);
    let locus = root_locus(values, |value| {
        let mut own = own.clone();
        own.a[(0, 0)] = value;
        Ok::<_, String>(own)
    });
    ended(locus)
}

fn riccati(h: &mut Hostile) -> Outcome {
    let mut square = |n: usize, m: usize| DMatrix::from_fn(n, m, |_, _| h.number());
    let (a, b, q, r) = (square(3, 3), square(3, 1), square(3, 3), square(1, 1));
    let cost = Cost::new(q, r);
    black_box((continuous_riccati(&a, &b, &cost), discrete_riccati(&a, &b, &cost)));
    Outcome::Done
}

fn stabilised(h: &mut Hostile) -> Outcome {
    let sim = mechanism(h)
        .map_err(|error| error.to_string())
        .and_then(|own| own.start().map_err(|fault| fault.to_string()));
    match sim {
        Ok(sim) => ended(stabilise(&sim).map(|own| own.balanced().is_ok())),
        Err(why) => Outcome::Refused(why),
    }
}

fn study(h: &mut Hostile) -> Outcome {
    black_box(linear(h.number(), h.number(), 5));
    let spread = Spread::Uniform { from: h.number(), to: h.number() };
    let normal = Spread::Normal { mean: h.number(), deviation: h.number() };
    let drawn = Points::monte_carlo(1, 5, [("a", "", spread), ("b", "", normal)]);
    let grid = Points::grid([("a", "", h.list(3)), ("b", "", h.list(3))]);
    black_box((0..10).map(|k| (drawn.at(k), grid.at(k))).collect::<Vec<_>>());
    Outcome::Done
}
