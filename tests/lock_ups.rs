//! Prescribed motions that can go no further: told at once, with the time and the value that a closed form knows.
//!
//! Seeded drives of many lengths stand in `tests/oracle/src/linkages/driven/`; here are other kinds of mechanisms, and every method.

#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

#[macro_use]
#[path = "support/scene.rs"]
mod scene;

use plm::{
    Adams, Cause, Dop853, Dopri5, Fault, Gauss, Mechanism as _, Method, Moment as _, RadauIia5, Rk4,
    Ros34Pw2, SemiImplicitEuler, Sim, Vern9, mechanism,
};

use scene::{Given as _, Named as _, Scene};

/// Evaluations that a lock-up may take after the last step.
const AT_ONCE: u64 = 200;
/// Steps of an interval of ten milliseconds whose last step is divided: up to 64 parts, many after a refused one of twice the length,
/// and those near the lock-up.
const DIVIDED: u64 = 600;

/// Runs to the lock-up of a row at a time and a value; the same with intervals of ten milliseconds.
fn assert_locks<I: Method<Scene>>(
    name: &str,
    start: impl Fn() -> Sim<Scene, I>,
    (row, time, value): (&str, f64, f64),
) {
    let told = |fault: Fault, reached: f64| {
        let name = format!("{name}: {fault}");
        let Cause::LockedAt { row: told, value: at, .. } = fault.cause else { panic!("{name}") };
        assert_eq!(told, row, "{name}");
        assert!((fault.time - time).abs() < 1e-8, "{name}, known {time}");
        assert!((at - value).abs() < 1e-7, "{name}, known {value}");
        assert!(reached < time && time - reached < 0.02, "{name}, reached {reached}");
    };
    let mut sim = start();
    let fault = sim.step_to(time + 1.0).unwrap_err();
    let reached = sim.time();
    told(fault, reached);
    // A step of fixed length that is divided ends where no run to that time has a step.
    if sim.stats().divided == 0 {
        let mut until = start();
        until.step_to(reached).unwrap();
        let after = sim.stats().evaluations - until.stats().evaluations;
        assert!(after < AT_ONCE, "{name}: {after} evaluations");
    }
    assert!(sim.stats().near_singular < 20, "{name}: {:?}", sim.stats());
    let mut paced = start();
    let mut before = 0;
    let fault = loop {
        let made = paced.step(0.01);
        let steps = paced.stats().steps + paced.stats().rejected - before;
        before += steps;
        if let Err(fault) = made {
            println!("{name}: {steps} steps");
            assert!(steps < DIVIDED || paced.stats().divided == 0, "{name}: {steps} steps");
            break fault;
        }
    };
    told(fault, paced.time());
}

/// Declares a four-bar whose crank is driven, by `scene!` or for rustc.
macro_rules! four_bar {
    ($declare:ident, $name:ident, $formulation:ident) => {
        $declare! {
            pub $name {
                formulation: $formulation;
                param rate: rad/s = 1 rad/s;
                ground { port a: (0, 0) m; port d: (0.4, 0) m; }
                body crank { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (0.12, 0) m; start angle: 90 deg; }
                body coupler { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (0.35, 0) m; start y: 0.12 m; start angle: 10 deg; }
                body rocker { mass: 1 kg; inertia: 1 kg*m^2; port d: (0, 0) m; port c: (0.15, 0) m; start x: 0.4 m; start angle: 120 deg; }
                revolute ja(ground.a, crank.a);
                revolute jb(crank.b, coupler.b);
                revolute jc(coupler.c, rocker.c);
                revolute jd(ground.d, rocker.d);
                constraint motor: crank.angle = 90 deg + rate*t;
            }
        }
    };
}

macro_rules! linkages {
    ($module:ident, $formulation:ident) => {
        mod $module {
            four_bar!(scene, FourBar, $formulation);
            scene! {
                /// The same with a pendulum on its coupler: one freedom is left.
                pub WithPendulum {
                    formulation: $formulation;
                    gravity: 9.81 m/s^2;
                    ground { port a: (0, 0) m; port d: (0.4, 0) m; }
                    body crank { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (0.12, 0) m; start angle: 90 deg; }
                    body coupler { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (0.35, 0) m; port p: (0.1, 0.05) m; start y: 0.12 m; start angle: 10 deg; }
                    body rocker { mass: 1 kg; inertia: 1 kg*m^2; port d: (0, 0) m; port c: (0.15, 0) m; start x: 0.4 m; start angle: 120 deg; }
                    body bob { mass: 0.1 kg; inertia: 0.001 kg*m^2; port p: (0, 0.2) m; start x: 0.1 m; }
                    revolute ja(ground.a, crank.a);
                    revolute jb(crank.b, coupler.b);
                    revolute jc(coupler.c, rocker.c);
                    revolute jd(ground.d, rocker.d);
                    revolute pin(coupler.p, bob.p);
                    constraint motor: crank.angle = 90 deg + 1 rad/s*t;
                }
            }
            scene! {
                /// A plate on three cranks, two of which are driven.
                pub FiveBar {
                    formulation: $formulation;
                    ground { port a: (-0.1, 0) m; port b: (0.1, 0) m; }
                    body left { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port c: (0.2, 0) m; start x: -0.1 m; start angle: 120 deg; }
                    body right { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port d: (0.2, 0) m; start x: 0.1 m; start angle: 60 deg; }
                    body l2 { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; port p: (0.25, 0) m; start x: -0.2 m; start y: 0.17 m; start angle: 45 deg; }
                    body r2 { mass: 1 kg; inertia: 1 kg*m^2; port d: (0, 0) m; port p: (0.25, 0) m; start x: 0.2 m; start y: 0.17 m; start angle: 135 deg; }
                    revolute ja(ground.a, left.a);
                    revolute jb(ground.b, right.b);
                    revolute jc(left.c, l2.c);
                    revolute jd(right.d, r2.d);
                    revolute tip(l2.p, r2.p);
                    constraint m1: left.angle = 120 deg + 0.5 rad/s*t;
                    constraint m2: right.angle = 60 deg - 0.5 rad/s*t;
                }
            }
        }
    };
}

linkages!(loops, loops);
linkages!(absolute, absolute);

/// Peaucellier's inversor, whose crank is driven: both arms fold over the rhombus at once.
macro_rules! inversor {
    ($name:ident, $formulation:ident) => {
        scene! {
            pub $name {
                formulation: $formulation;
                gravity: 9.81 m/s^2;
                let steel = 7850 kg/m^3;
                let p1 = (0, 0) mm;
                let p2 = (160, 90) mm;
                let p3 = (160, -90) mm;
                let p4 = (120, 0) mm;
                let p5 = (200, 0) mm;
                let p6 = (60, 0) mm;
                body bar1 { width: 20 mm; thickness: 5 mm; density: steel; port a: p1; port b: p2; }
                body bar2 { width: 20 mm; thickness: 5 mm; density: steel; port a: p1; port b: p3; }
                body bar3 { width: 20 mm; thickness: 5 mm; density: steel; port a: p2; port b: p4; }
                body bar4 { width: 20 mm; thickness: 5 mm; density: steel; port a: p4; port b: p3; }
                body bar5 { width: 20 mm; thickness: 5 mm; density: steel; port a: p3; port b: p5; }
                body bar6 { width: 20 mm; thickness: 5 mm; density: steel; port a: p5; port b: p2; }
                body bar7 { width: 20 mm; thickness: 5 mm; density: steel; port a: p6; port b: p4; }
                ground { port g1: p1; port g2: p6; }
                revolute pin1(bar1.a, bar2.a);
                revolute pin2(bar1.b, bar3.a);
                revolute pin3(bar3.b, bar4.a);
                revolute pin4(bar2.b, bar4.b);
                revolute pin5(bar2.b, bar5.a);
                revolute pin6(bar5.b, bar6.a);
                revolute pin7(bar1.b, bar6.b);
                revolute pin8(bar3.b, bar7.b);
                revolute pin9(ground.g1, bar1.a);
                revolute pin10(ground.g2, bar7.a);
                constraint motor: bar7.angle = 60 rev/min*t;
            }
        }
    };
}
inversor!(Inversor, loops);
inversor!(InversorAbsolute, absolute);

// In single precision there are compiled mechanisms alone.
four_bar!(mechanism, InSingle, loops);

/// Coupler and rocker lie in one line: 0.5^2 = 0.12^2 + 0.4^2 - 2 0.12 0.4 cos(crank).
fn four_bar() -> f64 {
    ((0.12_f64 * 0.12 + 0.4 * 0.4 - 0.25) / (2.0 * 0.12 * 0.4)).acos()
}

#[test]
fn a_driven_crank_stops_where_coupler_and_rocker_lie_in_one_line_by_every_method() {
    let angle = four_bar();
    let known = ("motor", angle - core::f64::consts::FRAC_PI_2, angle);
    macro_rules! by {
        ($($name:literal $method:expr),*) => {
            $(
                assert_locks($name, || loops::FourBar::new().start_with($method).unwrap(), known);
                assert_locks($name, || absolute::FourBar::new().start_with($method).unwrap(), known);
            )*
        };
    }
    by!(
        "Dop853" Dop853::default(), "Dopri5" Dopri5::default(), "Vern9" Vern9::new(1e-9), "Adams" Adams::new(1e-9),
        "Radau" RadauIia5::new(1e-8), "Rk4" Rk4::new(1e-3), "Gauss" Gauss::<_, 3>::new(1e-3),
        "Ros34Pw2" Ros34Pw2::new(1e-3), "Euler" SemiImplicitEuler::new(1e-3)
    );
}

#[test]
fn a_freedom_that_is_left_does_not_hide_it() {
    let angle = four_bar();
    let known = ("motor", angle - core::f64::consts::FRAC_PI_2, angle);
    assert_locks("loops", || loops::WithPendulum::new().start().unwrap(), known);
    assert_locks("absolute", || absolute::WithPendulum::new().start().unwrap(), known);
}

/// Elbows 0.5 m apart: 0.1 + 0.2 sin(30 deg + t/2) = 0.25.
#[test]
fn two_motors_stop_where_their_arms_are_apart() {
    let time = 2.0 * (0.75_f64.asin() - core::f64::consts::FRAC_PI_6);
    let turned = 0.5 * time;
    for (name, fault) in [
        ("loops", loops::FiveBar::new().start().unwrap().step(2.0).unwrap_err()),
        ("absolute", absolute::FiveBar::new().start().unwrap().step(2.0).unwrap_err()),
    ] {
        let Cause::LockedAt { row, value, .. } = fault.cause else { panic!("{name}: {fault}") };
        assert!((fault.time - time).abs() < 1e-8, "{name}: {fault}, known {time}");
        let [m1, m2] = [120_f64, 60.0].map(f64::to_radians);
        let known = if row == "m1" { m1 + turned } else { m2 - turned };
        assert!((value - known).abs() < 1e-7, "{name}: {fault}, known {known}");
    }
}

/// An arm less a side of the rhombus is a chord of the crank's circle: `2 r cos(angle/2)`.
#[test]
fn dyads_that_become_flat_at_once_are_one_lock_up() {
    let fold = 0.16_f64.hypot(0.09) - 0.04_f64.hypot(0.09);
    let angle = 2.0 * (fold / 0.12).acos();
    let known = ("motor", angle / core::f64::consts::TAU, angle);
    macro_rules! by {
        ($($name:literal $method:expr),*) => {
            $(
                assert_locks($name, || Inversor::new().start_with($method).unwrap(), known);
                assert_locks($name, || InversorAbsolute::new().start_with($method).unwrap(), known);
            )*
        };
    }
    by!("Dop853" Dop853::default(), "Radau" RadauIia5::new(1e-8), "Rk4" Rk4::new(1e-3));
}

scene! {
    /// Two dyads that are flat at once but for the rounding of their lengths, and a third one that is flat a nanometre later.
    pub NextToFlat {
        ground { port o: (0, 0) m; port a: (-0.18, -0.189) m; port b: (0.4, 0.3) m; port c: (0.32, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (0.06, 0) m; start angle: 0.5 rad, locked; start omega: 1 rad/s, locked; }
        body l0 { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (0.15178126035776152, 0) m; start x: 0.052654953713422364 m; start y: 0.02876553231625218 m; start angle: -0.3 rad; }
        body r0 { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (0.4553437800732845, 0) m; start x: -0.18 m; start y: -0.189 m; start angle: 0.4 rad; }
        body l1 { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (0.3009649411679327, 0) m; start x: 0.052654953713422364 m; start y: 0.02876553231625218 m; start angle: 0.5 rad; }
        body r1 { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (0.17076694154042577, 0) m; start x: 0.4 m; start y: 0.3 m; start angle: -2.3 rad; }
        body l2 { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (0.1656828112730702, 0) m; start x: 0.052654953713422364 m; start y: 0.02876553231625218 m; start angle: -0.3 rad; }
        body r2 { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (0.1656828112730702, 0) m; start x: 0.32 m; start y: 0 m; start angle: 3.4 rad; }
        revolute jo(ground.o, crank.a);
        revolute jl0(crank.b, l0.a);
        revolute jr0(ground.a, r0.a);
        revolute p0(l0.b, r0.b);
        revolute jl1(crank.b, l1.a);
        revolute jr1(ground.b, r1.a);
        revolute p1(l1.b, r1.b);
        revolute jl2(crank.b, l2.a);
        revolute jr2(ground.c, r2.a);
        revolute p2(l2.b, r2.b);
    }
}

#[test]
fn steps_that_lead_nowhere_end_a_run() {
    let mut sim = NextToFlat::new().start().unwrap();
    let end = sim.step_to(4.0);
    println!("{end:?}, {:?}", sim.stats());
    assert!(sim.stats().near_singular < 2000, "{:?}", sim.stats());
    assert!(matches!(end.map_err(|fault| fault.cause), Ok(()) | Err(Cause::Undecided { .. })));
}

#[test]
fn what_was_reached_before_stays() {
    let mut sim = loops::FourBar::new().start().unwrap();
    sim.step(1.0).unwrap_err();
    assert!((sim.state_of("crank").angle - (core::f64::consts::FRAC_PI_2 + sim.time())).abs() < 1e-9);
    assert!(sim.drift().phi < 1e-9, "{:?}", sim.drift());
    let mut samples = 0;
    let mut sim = loops::FourBar::new().start().unwrap();
    sim.run(2.0, 0.1, |_| samples += 1).unwrap_err();
    assert_eq!(samples, 10);
}

scene! {
    /// Cranks that differ by 1e-10 m: a turn next to flat takes a hundred steps in absolute coordinates.
    pub NearlyParallel {
        ground { port a: (0, 0) m; port d: (2, 0) m; }
        body left { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.5, 0) m; start angle: 1 rad, locked; start omega: -5 rad/s, locked; }
        body top { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (2, 0) m; start x: 0.27 m; start y: 0.42 m; }
        body right { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (0.5000000001, 0) m; start x: 2 m; start angle: 1 rad; }
        revolute ja(ground.a, left.a);
        revolute jb(left.b, top.b);
        revolute jc(top.c, right.c);
        revolute jd(ground.d, right.d);
    }
}

#[test]
fn steps_near_singular_poses_count() {
    let run = |most: u64| {
        let mut sim = NearlyParallel::new().start_with(Dop853::default().with_most_steps(most)).unwrap();
        (sim.step(0.4), sim.stats())
    };
    let (end, stats) = run(1000);
    assert!(end.is_ok() && stats.near_singular > 50, "{end:?}, {stats:?}");
    let (end, stats) = run(50);
    assert_eq!(end.unwrap_err().cause, Cause::TooManySteps { steps: 50 });
    assert_eq!(stats.steps + stats.rejected, 50);
}

#[test]
fn single_precision_tells_it_too() {
    let mut sim = InSingle::<f32>::of().start_with(Rk4::new(1e-3)).unwrap();
    let fault = sim.step(1.0).unwrap_err();
    let Cause::LockedAt { value, .. } = fault.cause else { panic!("{fault}") };
    assert!((value - four_bar()).abs() < 1e-3, "{fault}");
}

#[test]
fn the_message_names_joint_row_and_value() {
    let fault = loops::FourBar::new().start().unwrap().step(1.0).unwrap_err();
    let told = fault.to_string();
    assert_eq!(
        told,
        "t = 0.906742049552128 s: jc: its loop cannot be closed beyond this pose: the mechanism locks up; `motor` can go \
         no further than 2.477538 rad (141.952 deg)"
            .replace("0.906742049552128", &fault.time.to_string())
    );
}

scene! {
    /// A parallelogram whose crank is driven through its flat pose.
    pub DrivenParallelogram {
        param rate: rad/s = -1 rad/s;
        param right_length: m = 0.3 m;
        ground { port a: (0, 0) m; port d: (0.7, 0) m; }
        body left { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.3, 0) m; start angle: 1 rad; }
        body top { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (0.7, 0) m; start x: 0.16 m; start y: 0.25 m; }
        body right { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (right_length, 0 m); start x: 0.7 m; start angle: 1 rad; }
        revolute ja(ground.a, left.a);
        revolute jb(left.b, top.b);
        revolute jc(top.c, right.c);
        revolute jd(ground.d, right.d);
        constraint motor: left.angle = 1 rad + rate*t;
    }
}

#[test]
fn a_drive_passes_a_pose_that_it_touches() {
    for pace in [2.0, 0.1, 1e-2, 1e-3] {
        let mut sim = DrivenParallelogram::new().start().unwrap();
        for k in 1..=(2.0 / pace) as i32 {
            sim.step_to(f64::from(k) * pace).unwrap_or_else(|fault| panic!("{pace} s: {fault}"));
        }
        assert!(
            (sim.state_of("right").angle + 1.0).abs() < 1e-9 && sim.state_of("top").angle.abs() < 1e-9,
            "{pace} s: {:?}",
            sim.state_of("right")
        );
    }
    // A right crank that is shorter by a micrometre has no pose where the left one is level.
    let short = DrivenParallelogram::new().with("right_length", 0.3 - 1e-6);
    let fault = short.start().unwrap().step(2.0).unwrap_err();
    // The bars lie in one line: 1 - 1e-6 = |(0.7 - 0.3 cos, 0.3 sin)| + ... of the ends of the dyad.
    let Cause::LockedAt { value: angle, .. } = fault.cause else { panic!("{fault}") };
    let reach = 0.7 + 0.3 - 1e-6;
    let apart = (0.3 * angle.cos() - 0.7).hypot(0.3 * angle.sin());
    let near = (apart - reach).abs().min((apart - (0.7 - 0.3 + 1e-6)).abs());
    assert!(near < 1e-9, "{fault}");
}
