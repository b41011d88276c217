//! Assembly (manual, section 4.4): where it lands, what it refuses, what it says.

use plm::{Cause, Fault, Mechanism as _, Start};

use crate::scene::{Given as _, Named as _, Scene};
use crate::scenes::{s1, s2, s2_compiled};

scene! {
    /// The pendulum of PLMASSEMBLY: the length is a parameter, so that only the run can judge its locks.
    pub Pendulum {
        param length: m = 0.5 m;
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port o: (-length, 0);
            start angle: 30 deg;
        }
        revolute hinge(ground.o, bob.o);
    }
}

scene! {
    /// Two bars of 1 m between bearings that stand apart by a parameter.
    pub ShortLoop {
        param span: m = 1.5 m;
        ground { port a: (0, 0) m; port b: (span, 0); }
        body one { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 40 deg; }
        body two { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 1 m; start angle: -40 deg; }
        revolute left(ground.a, one.a);
        revolute middle(one.b, two.a);
        revolute right(two.b, ground.b);
    }
}

scene! {
    /// Three parallel cranks: the third says what the first two say.
    pub ParallelCranks {
        allow(W0001);
        gravity: 9.81 m/s^2;
        /// How far the third foot stands off, at right angles to its crank at the start.
        param slip: m = 0 m;
        ground { port a: (0, 0) m; port b: (1, 0) m; port c: (2 m - slip*sin(60 deg), slip*cos(60 deg)); }
        body one   { mass: 1 kg; inertia: 0.02 kg*m^2; port low: (-0.25, 0) m; port high: (0.25, 0) m; start angle: 60 deg, locked; }
        body two   { mass: 1 kg; inertia: 0.02 kg*m^2; port low: (-0.25, 0) m; port high: (0.25, 0) m; start x: 1 m; start angle: 60 deg; }
        body three { mass: 1 kg; inertia: 0.02 kg*m^2; port low: (-0.25, 0) m; port high: (0.25, 0) m; start x: 2 m; start angle: 60 deg; }
        body beam  { mass: 2 kg; inertia: 0.6 kg*m^2; port a: (-1, 0) m; port b: (0, 0) m; port c: (1, 0) m; start x: 1 m; start y: 0.4 m; }
        revolute a(ground.a, one.low);
        revolute b(ground.b, two.low);
        revolute c(ground.c, three.low);
        revolute d(one.high, beam.a);
        revolute e(two.high, beam.b);
        revolute f(three.high, beam.c);
        output a.force, f.force;
    }
}

#[test]
fn the_manuals_unlocked_pendulum_lands_where_the_manual_says() {
    let pendulum = s1::DoublePendulum::new().released("arm.angle").released("forearm.angle");
    let found = pendulum.assemble().unwrap();
    assert!((found.q[2].to_degrees() - 68.193_440_038_797_87).abs() < 1e-9);
    assert!((found.q[5].to_degrees() + 25.758_589_765_783_96).abs() < 1e-9);
    assert_eq!((found.freedom, found.rank, found.rows, found.locks), (2, 4, 4, 0));
}

#[test]
fn locks_hold_and_the_rest_follows() {
    let found = s1::DoublePendulum::new().assemble().unwrap();
    assert!((found.q[2] - std::f64::consts::FRAC_PI_4).abs() == 0.0 && found.q[5] == 0.0);
    assert!(found.gap <= 1e-15);
    assert_eq!((found.freedom, found.rank, found.rows, found.locks), (2, 6, 6, 2));
}

#[test]
fn three_locks_on_a_pendulum_are_two_too_many() {
    let pendulum = Pendulum::new().locked("bob.x").locked("bob.y").locked("bob.angle");
    let fault = pendulum.start().err().unwrap();
    let Cause::Redundant { count, .. } = fault.cause else { panic!("{fault}") };
    assert_eq!(count, 2);
    let text = fault.to_string();
    assert!(text.contains("2 redundant") && text.contains("bob.x") && text.contains("bob.y"), "{text}");
}

#[test]
fn a_loop_that_is_too_short_stays_open_at_a_named_joint() {
    let fault = ShortLoop::new().with("span", 3.0).start().err().unwrap();
    let Cause::Open { gap } = fault.cause else { panic!("{fault}") };
    // Two bars of 1 m cannot span 3 m: 1 m is missing where the loop is closed last.
    assert!((gap - 1.0).abs() < 1e-6 && fault.part == "right", "{fault}");
}

#[test]
fn velocities_follow_the_locked_one() {
    let four_bar = s2::FourBar::new().with_lock("crank.omega", 2.0);
    let sim = four_bar.start().unwrap();
    assert_eq!(sim.state_of("crank").omega, 2.0);
    assert!(sim.drift().phi_dot < 1e-14, "{:?}", sim.drift());
    // Freudenstein's relation differentiated: the coupler's end moves across the rocker.
    let (crank, coupler, rocker) = (sim.state_of("crank"), sim.state_of("coupler"), sim.state_of("rocker"));
    let expected =
        0.3 * 2.0 * (coupler.angle - crank.angle).sin() / (0.7 * (coupler.angle - rocker.angle).sin());
    assert!((rocker.omega - expected).abs() < 1e-13, "{} {expected}", rocker.omega);
}

#[test]
fn redundant_joints_that_agree_run_without_their_second_say() {
    let cranks = ParallelCranks::new();
    let found = cranks.assemble().unwrap();
    assert_eq!(found.freedom, 0);
    assert_eq!((found.rows, found.rank), (13, 12));
    assert!(found.redundant.contains(&true));
    let mut sim = cranks.start().unwrap();
    let energy = |sim: &plm::Sim<Scene>| sim.kinetic_energy() + sim.gravity_energy();
    let before = energy(&sim);
    sim.step(0.5).unwrap();
    assert!((energy(&sim) - before).abs() < 1e-7 * before.abs(), "{}", energy(&sim) - before);
    assert_eq!(sim.stats().by_rank, 0);
    assert!(sim.undetermined().contains(&true));
    assert!((sim.state_of("one").angle - sim.state_of("three").angle).abs() < 1e-12);
}

#[test]
fn redundant_joints_that_disagree_end_the_run_by_name() {
    // They close at the start, where the third foot's slip only turns its crank. So much of it locks the crank that is
    // locked already:
    let cranks = ParallelCranks::new().with("slip", 1e-6);
    let Err(Fault { cause: Cause::Redundant { .. }, .. }) = cranks.start() else { panic!("it starts") };
    // So little is seen when it has moved: 0.1 rad on, they are a tenth of it apart.
    let cranks = cranks.with("slip", 1e-8);
    let mut sim = cranks.start().unwrap();
    let fault = sim.step(0.5).unwrap_err();
    assert!(fault.cause == Cause::Locked && ["c", "f"].contains(&fault.part), "{fault}");
    assert!((sim.state_of("one").angle - 60_f64.to_radians()).abs() < 0.1, "{}", sim.state_of("one").angle);
    // Less than a billionth of the length is rounding, but where the cranks lie flat, at 0.385 s: there it is told.
    let cranks = cranks.with("slip", 1e-11);
    let mut sim = cranks.start().unwrap();
    sim.step(0.37).unwrap();
    let fault = sim.step(0.13).unwrap_err();
    assert!(matches!(fault.cause, Cause::Disagree { gap, .. } if gap < 1e-11), "{fault}");
    let cranks = cranks.with("slip", 1e-15);
    cranks.start().unwrap().step(0.5).unwrap();
}

#[test]
fn the_branch_that_was_taken_is_told() {
    let turn = |coupler: f64, rocker: f64| {
        let mut four_bar = s2_compiled::FourBar::new();
        four_bar.start.coupler.angle = Start::free(coupler.to_radians());
        four_bar.start.rocker.angle = Start::free(rocker.to_radians());
        let sim = four_bar.start().unwrap();
        let [(_, _), (joint, turn)] = sim.branches();
        assert_eq!(joint, "coupler_rocker");
        (turn, sim.coupler().angle, sim.rocker().angle)
    };
    let (up, coupler, rocker) = turn(30.0, 95.0);
    // From the coupler's direction to the way back along the rocker.
    let expected = rocker + std::f64::consts::PI - coupler - 2.0 * std::f64::consts::PI;
    assert!((up - expected).abs() < 1e-12, "{up} {expected}");
    let (down, ..) = turn(-50.0, -120.0);
    assert!(up < 0.0 && down > 0.0, "{up} {down}");
}
