//! Which states limit the steps: those whose error decides a length, and none where a length is given.

use plm_runtime::method::{Method, RadauIia5};
use plm_runtime::{Adams, Dop853, Dopri5, Mechanism, Vern9};

use crate::oscillator::{Oscillator, oscillator};

/// Steps, and how many of them the coordinate with its velocity and the filter have limited.
fn limited<I: Method<Oscillator<f64>>>(method: I) -> (u64, u64) {
    let mut sim = oscillator::<f64>().start_with(method).unwrap();
    sim.count_states(true);
    sim.step(10.0).unwrap();
    (sim.stats().steps, sim.state_count().map(|(_, count)| count).sum())
}

#[test]
fn steps_are_limited_by_states_or_by_their_longest() {
    // The first step is a guess, the last ends with the interval.
    for (name, (steps, counted)) in [
        ("dopri5", limited(Dopri5::new(1e-8))),
        ("dop853", limited(Dop853::new(1e-8))),
        ("vern9", limited(Vern9::new(1e-8))),
        ("adams", limited(Adams::new(1e-8))),
        ("radau", limited(RadauIia5::new(1e-8))),
    ] {
        assert!(counted < steps && 10 * counted > 7 * steps, "{name}: {counted} of {steps}");
    }
    for (name, (steps, counted)) in [
        ("dopri5", limited(Dopri5::new(1e-4).with_longest_step(0.01))),
        ("dop853", limited(Dop853::new(1e-4).with_longest_step(0.01))),
        ("vern9", limited(Vern9::new(1e-4).with_longest_step(0.01))),
        ("adams", limited(Adams::new(1e-4).with_longest_step(0.01))),
        ("radau", limited(RadauIia5::new(1e-4).with_longest_step(0.01))),
    ] {
        // But for a few while the length grows.
        assert!(steps >= 1000 && counted < 10, "{name}: {counted} of {steps}");
    }
}
