//! A dyad at its own limit.

use plm_runtime::method::RadauIia5;
use plm_runtime::{Dopri5, Rk4};

use crate::scenes::dyads::{apart, leading, stephenson};
use crate::scenes::theory::stephenson_limits;
use crate::text::{By as _, Named as _};

#[test]
fn a_six_bar_turns_back_where_its_second_dyad_stretches() {
    let [low, high] = stephenson_limits();
    let mut sim = stephenson().begin().unwrap();
    let trace = leading(&mut sim, 1.0);
    assert!(trace.survived() && trace.largest(0) < 5e-8, "{:?} {:e}", trace.end, trace.largest(0));
    let (least, most) = trace
        .rows
        .iter()
        .fold((f64::MAX, f64::MIN), |(low, high), (_, [_, crank, ..])| (low.min(*crank), high.max(*crank)));
    // Samples stand 0.2 ms apart at up to 1e3 rad/s^2: within 1e-5 of the peaks.
    assert!((-1e-5..1e-7).contains(&(most - high)), "{most} {high}");
    assert!((-1e-5..1e-7).contains(&(low - least)), "{least} {low}");
    let stretched = trace.rows.windows(2).filter(|pair| pair[0].1[3] * pair[1].1[3] < 0.0).count();
    assert_eq!(stretched, 7);
    assert!(sim.stats().charts >= 7, "{:?}", sim.stats());
}

#[test]
fn absolute_coordinates_know_no_such_limit_and_agree() {
    // Errors of 1e-11 a step grow a hundredfold in 1 s.
    let off = apart(1.0).unwrap();
    assert!(off < 3e-9, "{off:e} rad");
}

/// What was a million steps, or a mechanism that locks up, is as long a run as any.
#[test]
fn other_methods_pass_the_limit_too() {
    let mut exact = stephenson().begin().unwrap();
    exact.step(0.4).unwrap();
    macro_rules! passes {
        ($method:expr, $tolerance:expr) => {{
            let mut sim = stephenson().by($method).unwrap();
            sim.step(0.4).unwrap();
            let off = (sim.body_of("arm").angle - exact.body_of("arm").angle).abs();
            assert!(off < $tolerance, "{}: {off:e}, {:?}", stringify!($method), sim.stats());
            assert!(sim.stats().evaluations < 20_000, "{}: {:?}", stringify!($method), sim.stats());
        }};
    }
    passes!(Rk4::new(1e-4), 5e-5);
    passes!(Dopri5::new(1e-6), 2e-4);
    passes!(RadauIia5::new(1e-6), 2e-5);
}
