//! Eight simulations side by side have the bits of eight that run alone: times, states, memories, counts and faults.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(clippy::excessive_precision, reason = "the scenes' numbers are written as they were published")]

#[path = "../../plm-runtime/tests/contact/block.rs"]
#[allow(dead_code)] // Other tests use more of it.
mod block;
mod numbers;
#[path = "../support/random.rs"]
mod random;
mod scenes;
#[path = "../support/standard.rs"]
#[allow(dead_code, unused_imports)] // Other tests use more of it.
mod standard;
mod step_checks;

use plm::runtime::lanes::Pack;
use plm::runtime::method::{FixedStep, Formula, Rk4Formula};
use plm::{Batch, Cause, Mechanism, Moment, MoreauJean, Rk4, SemiImplicitEuler, Sim, Stats};
use scenes::{
    Driven, Pulsed, Struck, parallelogram, parallelogram_in_loops, struck_absolute, struck_in_loops,
    triple_rocker, triple_rocker_absolute,
};
use standard::{s1, s2, s5, s6};

/// Eight numbers around zero.
const AROUND: [f64; 8] = [0.0, 0.3, -0.2, 0.45, -0.4, 0.1, -0.05, 0.22];

/// One of eight simulations.
type Lane<M, F = Rk4Formula> = Sim<M, FixedStep<f64, F>>;

/// Runs eight mechanisms in a batch and alone; `before` may change each before each interval. What the lanes have done.
fn agree<M, F: Formula>(
    mechanisms: [M; 8],
    method: FixedStep<f64, F>,
    intervals: &[f64],
    before: impl Fn(usize, usize, &mut Lane<M, F>),
) -> [Stats; 8]
where
    M: Pack<S = f64>,
    M::U: std::fmt::Debug + PartialEq,
    M::X: PartialEq,
{
    let batch = Batch::start(&mechanisms, method).unwrap();
    agree_with(mechanisms.map(|mechanism| mechanism.start_with(method).unwrap()), batch, intervals, before)
}

/// The same of simulations with methods of their own.
fn agree_with<M, F: Formula>(
    mut alone: [Lane<M, F>; 8],
    mut batch: Batch<M, FixedStep<f64, F>>,
    intervals: &[f64],
    before: impl Fn(usize, usize, &mut Lane<M, F>),
) -> [Stats; 8]
where
    M: Pack<S = f64>,
    M::U: std::fmt::Debug + PartialEq,
    M::X: PartialEq,
{
    for (interval, dt) in intervals.iter().enumerate() {
        for lane in 0..8 {
            before(interval, lane, &mut batch[lane]);
            before(interval, lane, &mut alone[lane]);
        }
        let expected = alone.each_mut().map(|sim| sim.step(*dt));
        assert_eq!(batch.step(*dt), expected, "interval {interval}");
        for (lane, (one, other)) in batch.iter().zip(&alone).enumerate() {
            let moment = |sim: &Lane<M, F>| (sim.state().time(), *sim.state().x(), sim.state().held());
            assert_eq!(moment(one), moment(other), "lane {lane}, interval {interval}");
            assert_eq!(one.stats(), other.stats(), "lane {lane}, interval {interval}");
        }
    }
    batch.each_ref().map(Sim::stats)
}

fn unchanged<M: Pack<S = f64>, F>(_interval: usize, _lane: usize, _sim: &mut Lane<M, F>) {}

#[test]
fn trees_from_eight_starts() {
    let mechanisms = AROUND.map(|turn| {
        let mut mechanism = s1::DoublePendulum::new();
        mechanism.start.arm.angle.value += turn;
        mechanism.start.forearm.angle.value -= 0.5 * turn;
        mechanism
    });
    let stats = agree(mechanisms, Rk4::new(1e-3), &[0.4, 0.35, 0.25], unchanged);
    assert!(stats.iter().all(|stats| stats.steps == 1000 && stats.evaluations == 4000));
}

#[test]
fn trees_with_eight_parameters_and_inputs() {
    let mechanisms = AROUND.map(|s| Driven { mass: 1.0 + s, damping: 0.5 * s * s, ..Driven::new() });
    agree(mechanisms, Rk4::new(1e-3), &[0.3, 0.3, 0.4], |interval, lane, sim| {
        sim.input.torque = AROUND[lane] * interval as f64;
    });
    agree(mechanisms, SemiImplicitEuler::new(1e-3), &[0.3, 0.3], unchanged);
}

/// Only those that make the same steps go together.
#[test]
fn lanes_with_steps_of_other_lengths_go_alone() {
    let mechanisms = AROUND.map(|s| Driven { mass: 1.0 + s, ..Driven::new() });
    let lengths = [1e-3, 4e-3, 1e-3, 1e-3, 3e-3, 1e-3, 5e-4, 1e-3];
    let alone = std::array::from_fn(|lane| mechanisms[lane].start_with(Rk4::new(lengths[lane])).unwrap());
    let stats = agree_with(alone, Batch::new(alone), &[0.1, 0.02, 0.2], unchanged);
    // No interval is a whole number of steps of 3 ms: it takes one more.
    assert_eq!(stats.map(|stats| stats.steps), [320, 80, 320, 320, 34 + 7 + 67, 320, 640, 320]);
}

#[test]
fn loops_from_eight_starts() {
    let mechanisms = AROUND.map(|turn| {
        let mut mechanism = s2::FourBar::new();
        mechanism.start.crank.angle.value += turn;
        mechanism
    });
    agree(mechanisms, Rk4::new(1e-3), &[0.5, 0.5], unchanged);
    let mechanisms = AROUND.map(|turn| {
        let mut mechanism = s6::SliderCrank::new();
        mechanism.start.crank.angle.value += turn;
        mechanism
    });
    agree(mechanisms, Rk4::new(1e-3), &[0.5, 0.5], unchanged);
    let mechanisms = AROUND.map(|turn| {
        let mut mechanism = s5::Andrews::new();
        mechanism.start.k1.angle.value += 0.1 * turn;
        mechanism
    });
    agree(mechanisms, Rk4::new(1e-5), &[0.01], unchanged);
}

/// Every lane changes its chart at times of its own; one is too fast for its steps and stops.
#[test]
fn loops_in_several_charts() {
    let mechanisms = AROUND.map(|s| {
        let mut mechanism = triple_rocker::FourBars::new();
        mechanism.start.crank.omega.value = if s == 0.1 { 3000.0 } else { 3.0 + 4.0 * s };
        mechanism
    });
    let stats = agree(mechanisms, Rk4::new(1e-3), &[1.0, 1.0], unchanged);
    for (stats, s) in stats.iter().zip(AROUND) {
        assert_eq!(stats.divided > 0, s == 0.1, "{stats:?}");
        assert!(stats.charts >= 2 || s == 0.1, "{stats:?}");
    }
}

#[test]
fn absolute_coordinates_are_projected_lane_by_lane() {
    let mechanisms = AROUND.map(|s| {
        let mut mechanism = triple_rocker_absolute::FourBars::new();
        mechanism.start.crank.omega.value = 10.0 + 10.0 * s;
        mechanism
    });
    let stats = agree(mechanisms, Rk4::new(1e-2), &[0.5, 0.5], unchanged);
    assert!(stats.iter().all(|stats| stats.projected > 0), "{stats:?}");
}

/// Each passes its flat poses without the others.
#[test]
fn lanes_near_singular_poses_go_alone() {
    let mechanisms = AROUND.map(|s| {
        let mut mechanism = parallelogram::FourBars::new();
        mechanism.start.crank.omega.value = 2.0 + s;
        mechanism
    });
    let stats = agree(mechanisms, Rk4::new(1e-3), &[0.7, 1.3], unchanged);
    assert!(stats.iter().all(|stats| stats.near_singular > 0 && stats.change_points == 1), "{stats:?}");
}

/// Times at which forces jump are hit by the lanes that have them.
#[test]
fn known_times_are_hit() {
    let mechanisms = AROUND.map(|s| Pulsed { from: 0.1 + 0.1 * s, until: 0.2 + 0.2 * s, ..Pulsed::new() });
    let stats = agree(mechanisms, Rk4::new(1e-3), &[0.05, 0.1, 0.2, 0.1], unchanged);
    assert!(stats.iter().all(|stats| stats.switches == 2), "{stats:?}");
}

/// A lane in which a condition may switch makes the step alone, and goes on with the others after it; one that does not hold what is
/// required stops.
#[test]
fn conditions_switch_lane_by_lane() {
    let mechanisms = AROUND.map(|s| {
        let mut mechanism = Struck { stop: -1.9 + s, reach: 3.0 + 4.0 * s, ..Struck::new() };
        mechanism.start.bob.angle.value += 0.3 * s;
        mechanism
    });
    let stats = agree(mechanisms, Rk4::new(1e-3), &[0.05, 0.6, 0.001, 1.0], |interval, lane, sim| {
        // A change from outside may switch a condition, too.
        if interval == 2 && lane == 3 {
            sim.mechanism.stop += 0.5;
        }
    });
    let stopped = stats.map(|stats| stats.steps < 1651);
    assert!(stopped.contains(&true) && stopped.contains(&false), "{stats:?}");
    assert!(stats.iter().filter(|stats| stats.switches > 2).count() > 3, "{stats:?}");
}

#[test]
fn conditions_of_loops_switch_lane_by_lane() {
    fn bars<M: Pack<S = f64, X: PartialEq>>(mechanisms: [M; 8])
    where
        M::U: std::fmt::Debug,
    {
        let stats = agree(mechanisms, Rk4::new(1e-3), &[1.0, 1.5], unchanged);
        assert!(stats.iter().all(|stats| stats.switches >= 2), "{stats:?}");
    }
    bars(AROUND.map(|s| struck_in_loops::FourBars { at: 1.6 + s, ..struck_in_loops::FourBars::new() }));
    bars(AROUND.map(|s| struck_absolute::FourBars { at: 1.6 + s, ..struck_absolute::FourBars::new() }));
}

/// Each is in modes of its own, and steps by itself.
#[test]
fn mechanisms_with_contact_step_by_themselves() {
    let mechanisms = AROUND.map(|s| block::Block {
        incline: 0.3 * s,
        mu: 0.3 + 0.5 * s,
        e: 0.5 + s,
        until: 1.0,
        start: [0.0, 0.5 + s, 0.3 - s, 0.0],
    });
    let stats = agree(mechanisms, Rk4::new(1e-3), &[0.1, 0.5, 1.0], unchanged);
    assert!(stats.iter().all(|stats| stats.switches > 0), "{stats:?}");

    // Written by hand it has no motion of eight at once, and none is needed.
    let method = MoreauJean::new(1e-3);
    let mut batch = Batch::start(&mechanisms, method).unwrap();
    let alone = mechanisms.map(|mechanism| {
        let mut sim = mechanism.start_with(method).unwrap();
        sim.step(0.6).unwrap();
        sim
    });
    assert!(batch.step(0.6).iter().all(Result::is_ok));
    for (one, other) in batch.iter().zip(&alone) {
        assert_eq!((one.state().x(), one.state().held()), (other.state().x(), other.state().held()));
    }
}

#[test]
fn what_ends_a_run_ends_its_lane() {
    let mechanisms = AROUND.map(|s| {
        let mut mechanism = parallelogram_in_loops::FourBars::new();
        mechanism.start.crank.omega.value = 2.0 + s;
        mechanism
    });
    let stats = agree(mechanisms, Rk4::new(1e-3), &[1.0, 0.5, 0.5], |_, lane, sim| {
        sim.stop_at_change_points(lane % 2 == 0);
    });
    let stopped = stats.map(|stats| stats.steps < 1900);
    assert!(stopped.contains(&true) && stopped.contains(&false), "{stats:?}");

    // Steps of a fortieth of a second lose some of the energy, and here and there more than is allowed.
    let mechanisms = AROUND.map(|turn| {
        let mut mechanism = s1::DoublePendulum::new();
        mechanism.start.arm.angle.value += turn;
        mechanism
    });
    let stats = agree(mechanisms, Rk4::new(0.025), &[2.0, 2.0], |_, lane, sim| {
        sim.watch_energy((lane % 2 == 0).then_some(1e-4));
    });
    let refused = stats.map(|stats| stats.rejected > 0);
    assert!(refused[0] && !refused[1], "{stats:?}");
}

/// A lane that stops is after the others when it goes on.
#[test]
fn a_fault_stops_its_lane_alone() {
    let mechanisms = AROUND.map(|s| Driven { mass: 1.0 + s, ..Driven::new() });
    let torque = |interval, lane| if (interval, lane) == (1, 3) { f64::INFINITY } else { 0.1 };
    agree(mechanisms, Rk4::new(1e-3), &[0.1, 0.1, 0.1], |interval, lane, sim| {
        sim.input.torque = torque(interval, lane);
    });

    let mut batch = Batch::start(&mechanisms, Rk4::new(1e-3)).unwrap();
    batch[3].input.torque = f64::INFINITY;
    let outcomes = batch.step(0.1);
    assert_eq!(outcomes[3].unwrap_err().cause, Cause::NotFinite);
    assert!(outcomes.iter().enumerate().all(|(lane, outcome)| outcome.is_ok() == (lane != 3)));
    assert!(batch.iter().enumerate().all(|(lane, sim)| (sim.time() == 0.1) == (lane != 3)));
}

#[test]
fn intervals_that_cannot_be_run() {
    let mechanisms = AROUND.map(|_| Driven::new());
    agree(mechanisms, Rk4::new(1e-3), &[0.01, 0.0, -1.0, 1e-30, f64::INFINITY, 0.01], unchanged);
    agree(mechanisms, Rk4::new(0.0), &[0.01], unchanged);
}
