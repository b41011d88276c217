//! Runs near poses where elimination without pivoting loses digits, resumed runs, faults, single precision.

use plm::{Cause, Constraints, Dop853, Mechanism as _, Moment as _, Rate, Rk4, Start};

use crate::scene::{Given as _, Named as _, Scene};
use crate::scenes::{s2, s2_compiled};

scene! {
    /// A parallelogram: at the flat pose the rank of phi_q falls from 8 to 7.
    pub Parallelogram {
        formulation: absolute;
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body left  { mass: 1 kg; inertia: 1 kg*m^2/12; port low: (-0.5, 0) m; port high: (0.5, 0) m; start angle: 90 deg, locked; start omega: 1 rad/s, locked; }
        body top   { mass: 1 kg; inertia: 1 kg*m^2/12; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 0.5 m; start y: 1 m; }
        body right { mass: 1 kg; inertia: 1 kg*m^2/12; port low: (-0.5, 0) m; port high: (0.5, 0) m; start x: 1 m; start angle: 90 deg; }
        revolute a(ground.a, left.low);
        revolute b(left.high, top.a);
        revolute c(top.b, right.high);
        revolute d(ground.d, right.low);
    }
}

#[test]
fn near_the_flat_pose_the_rank_revealing_solution_keeps_the_digits() {
    let (mut lost, mut kept) = (0.0_f64, 0.0_f64);
    for distance in [1e-1, 1e-2, 1e-3, 1e-5, 1e-7] {
        let mechanism = Parallelogram::new()
            .with_lock("left.angle", distance)
            .with_start("top.y", distance)
            .with_start("right.angle", distance);
        let (held, x) = mechanism.start_state(0.0).unwrap();
        let (mut straight, mut by_rank) = (x, x);
        let health = mechanism.rate(0.0, &held, &x, &mut straight);
        mechanism.rate_by_rank(0.0, &held, &x, &mut by_rank).unwrap();
        // It turns at constant speed; what is left of 1 rad/s^2 is the rounding of the pose over the distance.
        let [left, top, right] = [2, 5, 8].map(|angle| Scene::NQ + angle);
        let angular = [by_rank[left], by_rank[top], by_rank[right]];
        assert!(angular.iter().all(|alpha| alpha.abs() < 1e-6), "{distance}: {angular:?}");
        let difference = (straight[left] - by_rank[left]).abs();
        if health.is_good() {
            assert!(difference < 1e-9, "{distance}: {difference:e} at {health:?}");
        } else {
            // Known: none of it accelerates.
            lost = [left, top, right].iter().fold(lost, |lost, i| lost.max(straight[*i].abs()));
            kept = angular.iter().fold(kept, |kept, alpha| kept.max(alpha.abs()));
        }
    }
    // Where health says no, the straight-line solution has indeed lost digits that the other keeps.
    assert!(lost > 10.0 * kept, "{lost:e}, {kept:e}");
}

#[test]
fn a_run_resumes_to_the_bit() {
    let mut sim = s2::FourBar::new().start().unwrap();
    sim.step(0.37).unwrap();
    let saved = sim.save();
    sim.step(0.5).unwrap();
    let first = sim.state_of("coupler");
    let mut other = s2::FourBar::new().start().unwrap();
    other.resume(&saved);
    other.step(0.5).unwrap();
    assert_eq!(first, other.state_of("coupler"));
    assert_eq!(sim.stats().steps, other.stats().steps);
}

#[test]
fn what_is_not_a_number_ends_the_run_with_its_part_and_time() {
    let mut sim = s2_compiled::FourBar::new().start_with(Rk4::new(1e-3)).unwrap();
    sim.step(0.1).unwrap();
    sim.mechanism.start.crank.x = Start::free(0.0);
    let mut poisoned = Driven::new().start_with(Rk4::new(1e-3)).unwrap();
    poisoned.set_input("torque", f64::NAN);
    let fault = poisoned.step(0.1).err().unwrap();
    assert_eq!(fault.cause, Cause::NotFinite);
    assert_eq!(fault.part, "bar");
    assert!(fault.time <= 0.1);
}

scene! {
    pub Driven {
        input torque: N*m = 0;
        ground { port o: (0, 0) m; }
        body bar { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; start angle: 0, locked; }
        revolute hinge(ground.o, bar.o) { drive: torque; }
    }
}

#[test]
fn inputs_act_from_the_next_step_on() {
    let mut sim = Driven::new().start_with(Dop853::new(1e-10)).unwrap();
    sim.step(0.2).unwrap();
    assert_eq!(sim.state_of("bar").omega, 0.0);
    sim.set_input("torque", 0.35);
    sim.step(0.5).unwrap();
    // J about the hinge is 0.1 + 0.25 kg m^2: 1 rad/s^2.
    assert!(
        (sim.state_of("bar").omega - 0.5).abs() < 1e-10 && (sim.state_of("bar").angle - 0.125).abs() < 1e-10,
        "{:?}",
        sim.state_of("bar")
    );
}

#[test]
fn single_precision_follows_double_precision() {
    let mut double = s2_compiled::FourBar::new().start_with(Rk4::new(1e-3)).unwrap();
    let mut single = s2_compiled::FourBar::<f32>::of().start_with(Rk4::new(1e-3)).unwrap();
    double.step(0.5).unwrap();
    single.step(0.5).unwrap();
    assert!((double.coupler().angle - f64::from(single.coupler().angle)).abs() < 1e-4);
    assert!(f64::from(single.drift().phi) < 1e-5, "{:?}", single.drift());
}

#[test]
fn sampling_gives_what_was_before_a_failure() {
    let mut sim = Driven::new().start().unwrap();
    sim.set_input("torque", f64::NAN);
    let mut samples = Vec::new();
    let result = sim.run(1.0, 0.1, |state| samples.push(state.time()));
    assert!(result.is_err());
    assert_eq!(samples, [0.0]);
}
