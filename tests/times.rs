//! To a time, the state at another one, back to the beginning, and what limits the steps.
#![allow(
    clippy::large_types_passed_by_value,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    unreachable_pub,
    reason = "tests"
)]

#[macro_use]
#[path = "support/scene.rs"]
mod scene;

use plm::{
    Adams, Cause, Dop853, Dopri5, Fault, Gauss, Mechanism as _, Method, Moment as _, RadauIia5, Rk4,
    Ros34Pw2, SemiImplicitEuler, Sim, Vern9,
};
use scene::{Given as _, Named as _, Scene, State};

scene! {
    /// A pendulum with a motor.
    pub Pendulum {
        gravity: 9.81 m/s^2;
        param load: kg = 1 kg;
        input torque: N*m = 0 N*m;
        ground { port o: (0, 0) m; }
        body bob { mass: load; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 30 deg, locked; }
        revolute hinge(ground.o, bob.pivot) { drive: torque; }
    }
}

scene! {
    /// 3 N push a block of 1 kg from 0.3 s to 0.7 s.
    pub Pulse {
        ground { port o: (0, 0) m; }
        body block { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
        prismatic rail(ground.o, block.o);
        force push(block.o) { x: if t < 0.3 s then 0 N else if t < 0.7 s then 3 N else 0 N; }
    }
}

scene! {
    /// A triple rocker: its crank is dead where its rocker is not, so that it changes charts.
    pub Rockers {
        gravity: 9.81 m/s^2;
        ground { port a: (0, 0) m; port d: (3, 0) m; }
        body crank {
            mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-1, 0) m; port b: (1, 0) m;
            start angle: 60 deg, locked;
        }
        body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (-0.5, 0) m; port c: (0.5, 0) m; start x: 1.5 m; start y: 1.7 m; }
        body rocker { mass: 2 kg; inertia: 0.1 kg*m^2; port c: (1, 0) m; port d: (-1, 0) m; start x: 2.5 m; start y: 1 m; start angle: 110 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(ground.d, rocker.d);
    }
}

fn is_interval(fault: &Fault) -> bool {
    matches!(fault.cause, Cause::Interval { .. })
}

#[test]
fn a_time_is_reached_exactly() {
    let mut sim = Pendulum::new().start().unwrap();
    for k in 1..=1000 {
        let time = f64::from(k) * 0.1;
        sim.step_to(time).unwrap();
        assert_eq!(sim.time(), time);
    }
    // So it is after intervals whose sum is rounded, and the next ones count from it.
    for _ in 0..7 {
        sim.step(0.1).unwrap();
    }
    sim.step_to(101.0).unwrap();
    sim.step(0.5).unwrap();
    assert_eq!(sim.time(), 101.5);
    let before = (sim.state_of("bob"), sim.stats());
    sim.step_to(101.5).unwrap();
    assert_eq!((sim.state_of("bob"), sim.stats()), before);
    for wrong in [101.4, f64::NAN, f64::INFINITY] {
        assert!(is_interval(&sim.step_to(wrong).unwrap_err()), "{wrong}");
    }
    assert_eq!((sim.state_of("bob"), sim.stats()), before);
}

/// Within the last step a state is the sample that `run` gave there, to the bit.
fn is_sampled<I: Method<Scene>>(method: I, least: usize) {
    let mut sim = Pendulum::new().start_with(method).unwrap();
    let mut samples = Vec::new();
    sim.run(2.0, 1e-4, |state| samples.push((state.time(), state.state_of("bob")))).unwrap();
    let before = (sim.state_of("bob"), sim.stats());
    let found: Vec<_> = samples.iter().filter_map(|(time, bob)| Some((sim.at(*time).ok()?, bob))).collect();
    assert!(found.len() > least && found.len() < samples.len(), "{} of {}", found.len(), samples.len());
    for (state, bob) in found {
        assert_eq!(state.state_of("bob"), *bob, "{} s", state.time());
    }
    assert!(is_interval(&sim.at(0.5).unwrap_err()));
    assert_eq!((sim.state_of("bob"), sim.stats()), before, "looking moves nothing");
}

#[test]
fn the_last_step_can_be_looked_at() {
    is_sampled(Dop853::new(1e-9), 50);
    is_sampled(Vern9::new(1e-9), 20);
    is_sampled(Adams::new(1e-9), 20);
    is_sampled(Dopri5::new(1e-7), 20);
    is_sampled(RadauIia5::new(1e-7), 20);
}

#[test]
fn a_step_that_ended_at_a_switch_can_be_looked_at() {
    let mut sim = Pulse::new().start().unwrap();
    sim.step_to(0.3).unwrap();
    assert_eq!(sim.at(0.25).unwrap().state_of("block").x, 0.0);
    // Steps are long here: nothing but the known times ends them.
    sim.step_to(0.7).unwrap();
    let block = sim.at(0.65).unwrap().state_of("block");
    assert!((block.x - 1.5 * 0.35_f64.powi(2)).abs() < 1e-12, "{}", block.x);
    assert!((block.vx - 3.0 * 0.35).abs() < 1e-12, "{}", block.vx);
    assert_eq!(sim.state_of("block").vx, sim.at(0.7).unwrap().state_of("block").vx);
    // After it the block goes on as it is, ahead of where the simulation stands.
    let block = sim.at(1.7).unwrap().state_of("block");
    assert!((block.x - (1.5 * 0.16 + 1.2)).abs() < 1e-12, "{}", block.x);
    assert_eq!(sim.time(), 0.7);
}

#[test]
fn steps_between_charts_and_over_flat_poses_can_be_looked_at() {
    let mut sim = Rockers::new().start_with(Dop853::new(1e-9)).unwrap();
    let (mut looked_at, mut changed) = (0, 0);
    for k in 1..=400 {
        let (mut expected, charts, end) = (sim, sim.stats().charts, f64::from(k) * 0.02);
        sim.step_to(end).unwrap();
        let inside = end - 1e-3;
        // Few steps are so short.
        let Ok(found) = sim.at(inside) else { continue };
        expected.step_to(inside).unwrap();
        let poses = |of: &State| [of.state_of("rocker"), of.state_of("coupler"), of.state_of("crank")];
        for (found, expected) in poses(&found).into_iter().zip(poses(expected.state())) {
            let off = (found.x - expected.x).abs().max((found.vy - expected.vy).abs());
            assert!(off < 1e-7, "{off:e} at {inside} s");
        }
        looked_at += 1;
        changed += sim.stats().charts - charts;
    }
    assert!(looked_at > 380 && changed >= 2, "{looked_at} states, {changed} changes of chart");
    assert!(sim.stats().near_singular > 0, "{:?}", sim.stats());
}

#[test]
fn ahead_is_where_a_step_leads() {
    let mut sim = Pendulum::new().start().unwrap();
    sim.step(0.4).unwrap();
    sim.set_input("torque", 2.0);
    let ahead = sim.at(1.0).unwrap();
    assert_eq!(sim.time(), 0.4);
    sim.step_to(1.0).unwrap();
    assert_eq!((ahead.time(), ahead.state_of("bob")), (1.0, sim.state_of("bob")));
    assert_eq!(sim.at(1.0).unwrap().state_of("bob"), sim.state_of("bob"));
    assert!(is_interval(&sim.at(f64::NAN).unwrap_err()));
}

#[test]
fn of_a_past_that_was_changed_nothing_is_known() {
    let mut sim = Pendulum::new().start().unwrap();
    assert!(is_interval(&sim.at(-0.1).unwrap_err()));
    sim.step(0.1).unwrap();
    assert!(sim.at(0.099).is_ok());
    sim.set_parameter("load", 2.0);
    assert!(is_interval(&sim.at(0.099).unwrap_err()));
    assert!(sim.at(0.11).is_ok());
    // Methods without dense output know what is ahead alone.
    let mut sim = Pendulum::new().start_with(Rk4::new(0.01)).unwrap();
    sim.step(0.1).unwrap();
    assert!(is_interval(&sim.at(0.099).unwrap_err()));
    assert!(sim.at(0.11).is_ok());
}

/// Time, state and what is held, with the numbers of the mechanism and the counts of its steps.
fn all_of<I: Method<Scene>>(sim: &Sim<Scene, I>) -> impl PartialEq + core::fmt::Debug {
    let (mechanism, at) = (sim.mechanism(), (sim.time(), *sim.x(), sim.held()));
    (at, mechanism.parameter_of("load"), mechanism.start_of("bob.angle"), sim.stats())
}

/// A run that was changed and begun again has the bits of a fresh one.
fn begins_again<I: Method<Scene>>(method: I) {
    let mechanism = Pendulum::new();
    let mut fresh = mechanism.with("load", 3.0).start_at(5.0, method.clone()).unwrap();
    let mut sim = mechanism.start_at(5.0, method).unwrap();
    sim.step(0.3).unwrap();
    sim.set_input("torque", 7.0);
    sim.set_parameter("load", 3.0);
    sim.step(0.25).unwrap();
    sim.reset().unwrap();
    assert_eq!(all_of(&sim), all_of(&fresh));
    for _ in 0..3 {
        sim.step(0.21).unwrap();
        fresh.step(0.21).unwrap();
        assert_eq!(all_of(&sim), all_of(&fresh));
    }
}

#[test]
fn a_reset_run_has_the_bits_of_a_fresh_one() {
    begins_again(Dop853::new(1e-8).with_longest_step(0.1));
    begins_again(Vern9::new(1e-8));
    begins_again(Adams::new(1e-8));
    begins_again(Dopri5::new(1e-7));
    begins_again(RadauIia5::new(1e-7).with_longest_step(0.1));
    begins_again(Rk4::new(0.01).with_tolerance(1e-8));
    begins_again(SemiImplicitEuler::new(0.001));
    begins_again(Gauss::<_, 2>::new(0.01));
    begins_again(Gauss::<_, 3>::new(0.01));
    begins_again(Ros34Pw2::new(0.01));
}

#[test]
fn a_reset_that_cannot_be_leaves_the_run_as_it_is() {
    let mut sim = Pendulum::new().start().unwrap();
    sim.step(0.3).unwrap();
    let before = sim.state_of("bob");
    sim.set_parameter("load", -1.0);
    assert!(matches!(sim.reset().unwrap_err().cause, Cause::NotAllowed { .. }));
    sim.set_parameter("load", 1.0);
    assert_eq!((sim.time(), sim.state_of("bob")), (0.3, before));
    sim.step(0.1).unwrap();
}

scene! {
    /// Two masses on springs that swing by 1 m with 1 and 20 rad/s, or the other way round.
    pub Swings {
        param left: N/m = 1 N/m;
        param right: N/m = 400 N/m;
        ground { port o: (0, 0) m; }
        body one { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 1 m, locked; }
        body two { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 1 m, locked; }
        prismatic slow(ground.o, one.o) { stiffness: left; }
        prismatic fast(ground.o, two.o) { stiffness: right; }
        state heat: J = 0 J;
        rate heat = 1 W;
    }
}

/// How often each state has limited the steps; the room after them has no names.
fn counted<I: Method<Scene>>(sim: &Sim<Scene, I>) -> Vec<(&'static str, u64)> {
    sim.state_count().filter(|(name, _)| !name.is_empty()).collect()
}

fn counts<I: Method<Scene>>(mechanism: Scene, method: I) -> (Vec<(&'static str, u64)>, u64) {
    let mut sim: Sim<Scene, I> = mechanism.start_with(method).unwrap();
    sim.count_states(true);
    sim.step(10.0).unwrap();
    (counted(&sim), sim.stats().steps)
}

/// The error of a mass that swings by 1 m with w grows with a high power of w (the fifth and more): all steps are limited
/// by the faster one.
#[test]
fn the_state_that_limits_the_steps_is_named() {
    let names = ["fast.displacement", "fast.speed", "heat", "slow.displacement", "slow.speed"];
    let swapped = Swings::new().with("left", 400.0).with("right", 1.0);
    for (mechanism, fast) in [(Swings::new(), "fast."), (swapped, "slow.")] {
        for (counts, steps) in [
            counts(mechanism, Dop853::new(1e-8)),
            counts(mechanism, Dopri5::new(1e-8)),
            counts(mechanism, RadauIia5::new(1e-6)),
        ] {
            let mut found: Vec<&str> = counts.iter().map(|(name, _)| *name).collect();
            found.sort_unstable();
            assert_eq!(found, names);
            let of_fast = counts.iter().filter(|(name, _)| name.starts_with(fast)).map(|(_, count)| count);
            let (of_fast, all) = (of_fast.sum::<u64>(), counts.iter().map(|(_, count)| count).sum::<u64>());
            assert_eq!(of_fast, all, "{counts:?}");
            // All but the last one, which ends where the interval does.
            assert_eq!(all, steps - 1, "{counts:?}");
        }
    }
}

#[test]
fn steps_that_something_else_limits_count_for_no_state() {
    let all = |sim: &Sim<Scene>| sim.state_count().map(|(_, count)| count).sum::<u64>();
    let mut sim = Swings::new().start().unwrap();
    sim.step(1.0).unwrap();
    assert_eq!(all(&sim), 0, "nobody has asked");
    sim.count_states(true);
    for _ in 0..10 {
        sim.step(1e-4).unwrap();
    }
    assert_eq!(all(&sim), 0, "intervals are short");
    sim.step(1.0).unwrap();
    assert!(all(&sim) > 10);
    sim.reset().unwrap();
    assert_eq!(all(&sim), 0);
    sim.method_mut().longest_step = 1e-3;
    sim.step(1.0).unwrap();
    assert_eq!((all(&sim), sim.stats().steps), (0, 1000), "steps may not be longer");
    let equal = counts(Swings::new(), Rk4::new(0.01)).0;
    assert!(equal.iter().all(|(_, count)| *count == 0));
}

#[test]
fn a_coordinate_has_the_names_of_all_charts() {
    let sim = Rockers::new().start().unwrap();
    let names: Vec<&str> = counted(&sim).into_iter().map(|(name, _)| name).collect();
    let [angle, omega] = names[..] else { panic!("{names:?}") };
    let angles: Vec<&str> = angle.split(" or ").collect();
    assert!(
        angles.len() > 1 && angles.iter().all(|name| name.split('.').next_back() == Some("angle")),
        "{names:?}"
    );
    assert_eq!(omega, angle.replace("angle", "omega"));
}

/// A step here takes two evaluations, a beginning some twenty steps.
#[test]
fn whole_turns_are_no_new_beginning_of_adams() {
    let mut sim = Pendulum::new().start_with(Adams::new(1e-9)).unwrap();
    sim.set_input("torque", 100.0);
    sim.step(1.0).unwrap();
    let (before, angle) = (sim.stats(), sim.state_of("bob").angle);
    for _ in 0..1000 {
        sim.step(0.001).unwrap();
    }
    let (after, turns) = (sim.stats(), (sim.state_of("bob").angle - angle) / core::f64::consts::TAU);
    let steps = (after.evaluations - before.evaluations) / 2;
    assert!(turns > 5.0 && steps < 1000 + 5 * turns as u64, "{turns} turns in {steps} steps");
}
