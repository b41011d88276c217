//! Runs by embedded pairs side by side have the bits of runs alone, each with steps of its own: states, discrete states, counts, faults,
//! all that the method stores, and states within the last step.

#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(clippy::excessive_precision, reason = "the scenes' numbers are written as they were published")]

#[path = "../support/random.rs"]
mod random;
#[path = "../lanes/scenes.rs"]
#[allow(dead_code, unused_imports)] // Other tests use more of it.
mod scenes;
#[path = "../support/standard.rs"]
#[allow(dead_code, unused_imports)] // Other tests use more of it.
mod standard;

use std::fmt::Debug;

use plm::runtime::lanes::{Pack, run_all};
use plm::runtime::method::{DormandPrince5, DormandPrince853, Embedded, Pair, Verner98};
use plm::{Batch, Cause, F64x8, Moment, Sim};

use random::Random;
use scenes::{Driven, Pulsed, Struck, parallelogram_in_loops, triple_rocker, triple_rocker_absolute};
use standard::{s1, s2, s5, s6};

/// Eight numbers around zero.
const AROUND: [f64; 8] = [0.0, 0.3, -0.2, 0.45, -0.4, 0.1, -0.05, 0.22];

type Run<M, P> = Sim<M, Embedded<M, P>>;

/// Two runs of which one was made in lanes.
fn same<M: Pack<S = f64> + Debug, P: Pair>(one: &Run<M, P>, other: &Run<M, P>, words: &str)
where
    M::U: Debug + PartialEq,
    M::X: PartialEq,
{
    let moment = |sim: &Run<M, P>| (sim.state().time(), *sim.state().x(), sim.state().held());
    assert_eq!(moment(one), moment(other), "{words}");
    assert_eq!(one.stats(), other.stats(), "{words}");
    assert_eq!(format!("{:?}", one.method()), format!("{:?}", other.method()), "{words}");
    let within = |sim: &Run<M, P>| {
        let time = sim.state().time();
        let state = sim.at(time - 1e-9).map_err(|fault| fault.cause);
        state.map(|state| (state.time(), *state.x(), state.held()))
    };
    assert_eq!(within(one), within(other), "{words}");
}

/// Steps eight runs through intervals, in a batch and alone; `before` may change each before each interval.
fn agree<M: Pack<S = f64> + Debug, P: Pair>(
    mut alone: [Run<M, P>; 8],
    intervals: &[f64],
    before: impl Fn(usize, usize, &mut Run<M, P>),
) -> [Run<M, P>; 8]
where
    M::U: Debug + PartialEq,
    M::X: PartialEq,
{
    let mut batch = Batch::new(alone);
    for (interval, dt) in intervals.iter().enumerate() {
        for lane in 0..8 {
            before(interval, lane, &mut batch[lane]);
            before(interval, lane, &mut alone[lane]);
        }
        // To look at a run through a changeable place is a change.
        let mut whole: Batch<M, _> = batch;
        let expected = alone.each_mut().map(|sim| sim.step(*dt));
        // As texts: a length that is no number is not equal to itself.
        assert_eq!(format!("{:?}", whole.step(*dt)), format!("{expected:?}"), "interval {interval}");
        for (lane, (one, other)) in whole.iter().zip(&alone).enumerate() {
            same(one, other, &format!("lane {lane}, interval {interval}"));
        }
        batch = whole;
    }
    alone
}

fn unchanged<M: Pack<S = f64>, P: Pair>(_interval: usize, _lane: usize, _sim: &mut Run<M, P>) {}

/// Runs of eight mechanisms by a pair.
fn runs<M: Pack<S = f64>, P: Pair>(mechanisms: [M; 8], rtol: f64) -> [Run<M, P>; 8] {
    mechanisms.map(|mechanism| mechanism.start_with(Embedded::new(rtol)).unwrap())
}

fn pendulums() -> [s1::DoublePendulum; 8] {
    AROUND.map(|turn| {
        let mut mechanism = s1::DoublePendulum::new();
        mechanism.start.arm.angle.value += turn;
        mechanism.start.forearm.angle.value -= 0.5 * turn;
        mechanism
    })
}

fn cranks() -> [s6::SliderCrank; 8] {
    AROUND.map(|turn| {
        let mut mechanism = s6::SliderCrank::new();
        mechanism.start.crank.angle.value += turn;
        mechanism
    })
}

#[test]
fn trees_and_loops_by_each_pair() {
    fn by<P: Pair>() {
        for rtol in [1e-4, 1e-8, 1e-12] {
            agree(runs::<_, P>(pendulums(), rtol), &[0.4, 0.35, 0.003], unchanged);
            let stats = agree(runs::<_, P>(cranks(), rtol), &[0.5, 0.2], unchanged).map(|run| run.stats());
            assert!(stats.iter().any(|own| own.steps != stats[0].steps), "{stats:?}");
        }
    }
    by::<DormandPrince853>();
    by::<Verner98>();
    by::<DormandPrince5>();
}

#[test]
fn loops_of_two_and_of_seven_bodies() {
    let bars = AROUND.map(|turn| {
        let mut mechanism = s2::FourBar::new();
        mechanism.start.crank.angle.value += turn;
        mechanism
    });
    agree(runs::<_, DormandPrince853>(bars, 1e-9), &[0.5, 1.5], unchanged);
    let andrews = AROUND.map(|turn| {
        let mut mechanism = s5::Andrews::new();
        mechanism.start.k1.angle.value += 0.1 * turn;
        mechanism
    });
    agree(runs::<_, DormandPrince853>(andrews, 1e-7), &[0.01, 0.01], unchanged);
}

/// Every lane changes its chart at times of its own; a few go fast.
#[test]
fn loops_in_several_charts() {
    let mechanisms = AROUND.map(|s| {
        let mut mechanism = triple_rocker::FourBars::new();
        mechanism.start.crank.omega.value = if s == 0.1 { 300.0 } else { 3.0 + 4.0 * s };
        mechanism
    });
    let runs = agree(runs::<_, DormandPrince853>(mechanisms, 1e-8), &[1.0, 1.0], unchanged);
    assert!(runs.iter().all(|run| run.stats().charts >= 2));
}

/// Each passes its flat poses without the others; one of two ends there.
#[test]
fn lanes_near_flat_poses_go_alone() {
    let mechanisms = AROUND.map(|s| {
        let mut mechanism = parallelogram_in_loops::FourBars::new();
        mechanism.start.crank.omega.value = 2.0 + s;
        mechanism
    });
    let before = |_, lane, sim: &mut Run<parallelogram_in_loops::FourBars, DormandPrince853>| {
        sim.stop_at_change_points(lane % 2 == 0);
    };
    let runs = agree(runs::<_, DormandPrince853>(mechanisms, 1e-8), &[1.0, 0.5, 0.5], before);
    let ended = runs.each_ref().map(|run| run.state().time() < 1.99);
    assert!(ended.contains(&true) && ended.contains(&false), "{ended:?}");
}

/// Conditions, times at which forces jump, and constraints that are projected are treated by each run alone.
#[test]
fn what_has_to_be_watched_is_made_alone() {
    let pulsed = AROUND.map(|s| Pulsed { from: 0.1 + 0.1 * s, until: 0.2 + 0.2 * s, ..Pulsed::new() });
    agree(runs::<_, DormandPrince853>(pulsed, 1e-8), &[0.05, 0.1, 0.2, 0.1], unchanged);
    let struck = AROUND.map(|s| Struck { stop: -1.9 + s, ..Struck::new() });
    agree(runs::<_, DormandPrince853>(struck, 1e-8), &[0.05, 0.6], unchanged);
    let absolute = AROUND.map(|s| {
        let mut mechanism = triple_rocker_absolute::FourBars::new();
        mechanism.start.crank.omega.value = 10.0 + 10.0 * s;
        mechanism
    });
    agree(runs::<_, DormandPrince853>(absolute, 1e-8), &[0.3], unchanged);
}

#[test]
fn inputs_parameters_and_options_are_those_of_each_lane() {
    let mechanisms = AROUND.map(|s| Driven { mass: 1.0 + s, damping: 0.5 * s * s, ..Driven::new() });
    let mut runs = runs::<_, DormandPrince853>(mechanisms, 1e-9);
    for (lane, run) in runs.iter_mut().enumerate() {
        let method = run.method_mut();
        method.rtol = [1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-5, 0.0][lane];
        method.longest_step = if lane % 3 == 0 { 0.02 } else { f64::INFINITY };
        method.most_steps = [1_000_000, 1_000_000, 3, 1_000_000, 1_000_000, 1_000_000, 1, 1_000_000][lane];
    }
    agree(runs, &[0.3, 0.3, 0.4], |interval, lane, sim| {
        sim.input.torque = if (interval, lane) == (1, 4) { f64::INFINITY } else { AROUND[lane] };
    });
}

/// At rest, in equal states, with a longest step of nothing or no number, and through intervals of no length, backwards, or without end.
#[test]
fn special_runs() {
    let mut still = s1::DoublePendulum::new();
    still.start.arm.angle.value = -std::f64::consts::FRAC_PI_2;
    still.start.forearm.angle.value = -std::f64::consts::FRAC_PI_2;
    let mut mechanisms = pendulums();
    mechanisms[2] = still;
    mechanisms[5] = mechanisms[4];
    let mut runs = runs::<_, DormandPrince853>(mechanisms, 1e-8);
    runs[6].method_mut().longest_step = f64::NAN;
    runs[7].method_mut().longest_step = 0.0;
    runs[1].step(0.1).unwrap();
    agree(runs, &[0.2, 0.0, -1.0, 1e-30, f64::NAN, f64::INFINITY, 1e-12, 0.3], |interval, lane, sim| {
        if interval > 0 && lane == 3 {
            sim.watch_energy(Some(0.1));
        }
    });
}

/// Makes lists of runs in lanes and alone.
fn agree_in_lists<M: Pack<S = f64> + Debug>(mut one: impl FnMut(usize) -> (Run<M, DormandPrince853>, f64))
where
    M::U: Debug + PartialEq,
    M::X: PartialEq,
{
    for count in [0, 1, 3, 8, 50] {
        let list: Vec<_> = (0..count).map(&mut one).collect();
        let mut done = vec![None; count];
        run_all::<_, F64x8, _, _>(list.clone(), |number, run, outcome| done[number] = Some((run, outcome)));
        for (number, ((mut alone, dt), done)) in list.into_iter().zip(done).enumerate() {
            let (run, outcome) = done.expect("each run is handed back");
            assert_eq!(format!("{outcome:?}"), format!("{:?}", alone.step(dt)), "run {number} of {count}");
            assert!(outcome.is_ok() || matches!(outcome.unwrap_err().cause, Cause::Interval { .. }));
            same(&run, &alone, &format!("run {number} of {count}"));
        }
    }
}

/// Parameters and inputs stay with their runs while others come and go, and while some change their charts alone.
#[test]
fn lists_of_runs_with_parameters_inputs_and_charts() {
    let (seed, mut random) = (52, Random(52));
    println!("seed {seed}");
    agree_in_lists(|_| {
        let mass = random.between(0.5, 2.0);
        let mechanism = Driven { mass, damping: random.between(0.0, 1.0), ..Driven::new() };
        let mut run = mechanism.start_with(Embedded::new(1e-8)).unwrap();
        run.input.torque = random.between(-20.0, 20.0);
        (run, random.between(0.0, 3.0))
    });
    agree_in_lists(|_| {
        let mut mechanism = triple_rocker::FourBars::new();
        mechanism.start.crank.omega.value = random.between(-20.0, 20.0);
        let rtol = 10.0_f64.powf(random.between(-12.0, -3.0));
        (mechanism.start_with(Embedded::new(rtol)).unwrap(), random.between(0.0, 2.0))
    });
}

/// A list of random runs with lengths and tolerances of their own: a lane takes the next run when its own has ended.
#[test]
fn a_list_of_runs() {
    let (seed, mut random) = (51, Random(51));
    println!("seed {seed}");
    agree_in_lists(|k| {
        let mut mechanism = s6::SliderCrank::new();
        mechanism.start.crank.angle.value += random.between(-3.0, 3.0);
        mechanism.start.crank.omega.value = if k % 7 == 0 { 0.0 } else { random.between(-60.0, 60.0) };
        let rtol = 10.0_f64.powf(random.between(-12.0, -3.0));
        let dt = if k % 11 == 0 { 0.0 } else { random.between(0.0, 0.4) };
        let run = mechanism.start_with(Embedded::new(rtol)).unwrap();
        (run, if k == 17 { f64::NAN } else { dt })
    });
}
