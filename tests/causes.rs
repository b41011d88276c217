//! What a fault says is why: lengths that disagree, angles of many turns, times without digits, pins that coincide.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use std::f64::consts::{PI, TAU};

use plm::{Cause, Fault};

/// Three parallel cranks of 0.5 m with a bar of 2 m, the third longer by `off`.
macro_rules! cranks {
    ($module:ident, { $($formulation:tt)* }) => {
        mod $module {
            plm::mechanism! {
                pub Cranks {
                    $($formulation)*
                    gravity: 9.81 m/s^2;
                    param off: m = 0 m;
                    ground { port a: (0, 0) m; port b: (1, 0) m; port c: (2, 0) m; }
                    body one { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port p: (0.5, 0) m; start angle: 60 deg, locked; }
                    body two { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port p: (0.5, 0) m; start x: 1 m; start angle: 60 deg; }
                    body three { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port p: (0.5 m + off, 0 m); start x: 2 m; start angle: 60 deg; }
                    body bar { mass: 2 kg; inertia: 0.5 kg*m^2; port p: (0, 0) m; port q: (1, 0) m; port r: (2, 0) m; start x: 0.25 m; start y: 0.433 m; }
                    revolute p1(ground.a, one.a);
                    revolute p2(ground.b, two.a);
                    revolute p3(ground.c, three.a);
                    revolute p4(one.p, bar.p);
                    revolute p5(two.p, bar.q);
                    revolute p6(three.p, bar.r);
                }
            }
        }
    };
}
cranks!(in_joints, {});
cranks!(absolute, { formulation: absolute; });

/// The third crank is longer by so much: at the start where that opens the joints by more than closes them, else on the way.
#[test]
fn lengths_that_disagree_are_told_with_how_much() {
    let told = |fault: Fault, off: f64| {
        let Cause::Disagree { gap, joints } = fault.cause else { return Err(fault) };
        assert!(gap < off && gap > 0.05 * off, "{off:e}: {fault}");
        assert!(["p1", "p2", "p3", "p4", "p5", "p6"].contains(&fault.part), "{fault}");
        assert!(joints.iter().eq(["p1", "p2", "p3", "p4", "p5", "p6"]), "{fault}");
        Ok(())
    };
    for off in [1e-12, 3e-11, 1e-9, 1e-8, 3e-7, 1e-6] {
        let cranks = absolute::Cranks { off, ..absolute::Cranks::new() };
        let fault = cranks.start().and_then(|mut sim| sim.step(2.0)).unwrap_err();
        told(fault, off).unwrap();
        let at_start = off > 5e-9;
        assert_eq!(fault.time == 0.0, at_start, "{off:e}: {fault}");
        if at_start {
            told((in_joints::Cranks { off, ..in_joints::Cranks::new() }).start().err().unwrap(), off)
                .unwrap();
        }
    }
    // Equal lengths run, and what is open by a millimetre repeats nothing.
    absolute::Cranks::new().start().unwrap().step(2.0).unwrap();
    let fault = (absolute::Cranks { off: 1e-3, ..absolute::Cranks::new() }).start().err().unwrap();
    assert!(matches!(fault.cause, Cause::Open { .. }), "{fault}");
}

macro_rules! four_bar {
    ($module:ident, $turned:literal) => {
        mod $module {
            plm::mechanism! {
                pub FourBar {
                    gravity: 9.81 m/s^2;
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg + $turned rev; }
                    body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; start angle: $turned rev; }
                    body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0) m; start x: 1 m; start angle: 95 deg; }
                    revolute drive(ground.a, crank.a);
                    revolute pin(crank.b, coupler.b);
                    revolute wrist(coupler.c, rocker.c);
                    revolute pivot(ground.d, rocker.d);
                }
            }
        }
    };
}
four_bar!(straight, 0);
four_bar!(turned, 1e6);

/// Joints close to the rounding of the angles, at the start and at compile time.
#[test]
fn bars_that_have_turned_many_times_are_assembled() {
    let here = straight::FourBar::new().start().unwrap().rocker();
    for turns in [1e3, 1e5, 1e6, 1e7, 1e8] {
        for body in 0..3 {
            let mut four_bar = straight::FourBar::new();
            let start = &mut four_bar.start;
            let angles = [&mut start.crank.angle, &mut start.coupler.angle, &mut start.rocker.angle];
            angles.into_iter().nth(body).unwrap().value += turns * TAU;
            let sim = four_bar.start().map_err(|fault| format!("{turns:e} turns of body {body}: {fault}"));
            let there = sim.unwrap().rocker();
            // Half a unit in the last place of the angle that was written, and as much of those that are found.
            let rounding = 8.0 * f64::EPSILON * turns * TAU;
            assert!((there.x - here.x).abs() < 1e-12 + rounding, "{turns:e} {body}: {}", there.x - here.x);
        }
    }
    assert!((turned::FourBar::new().start().unwrap().rocker().x - here.x).abs() < 1e-8);
}

/// What is open is still told, however often bars have turned.
#[test]
fn bars_that_are_too_short_stay_open_after_many_turns() {
    let mut four_bar = straight::FourBar::new();
    four_bar.start.crank.angle.value += 1e6 * TAU;
    four_bar.start.rocker.x.value = 5.0;
    four_bar.start.rocker.x.locked = true;
    let fault = four_bar.start().err().unwrap();
    assert!(matches!(fault.cause, Cause::Open { gap } if gap > 0.1), "{fault}");
}

/// In single precision the times of a million seconds are 0.12 s apart, as 24 bits are.
#[test]
fn an_interval_without_digits_is_told() {
    let mut sim = straight::FourBar::<f32>::of().start().unwrap();
    let fault = sim.step(1e6).unwrap_err();
    let Cause::TimeTooCoarse { step, spacing } = fault.cause else { panic!("{fault}") };
    assert!((spacing - 1e6 * f64::from(f32::EPSILON)).abs() < 1e-3, "{spacing}");
    assert!(step < 16.0 * spacing, "{step}");
    // The state stays as it was.
    sim.step(0.5).unwrap();
    straight::FourBar::new().start().unwrap().step(1.0).unwrap();
}

mod five_bar {
    plm::mechanism! {
        /// Its elbows coincide where the angles are equal and opposite.
        pub FiveBar {
            param q1: rad = 24 deg;
            param q2: rad = 120 deg;
            ground { port a: (-0.1, 0) m; port b: (0.1, 0) m; }
            body left { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port c: (0.2, 0) m; start x: -0.1 m; start angle: q1; }
            body right { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port d: (0.2, 0) m; start x: 0.1 m; start angle: q2; }
            body l2 { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; port p: (0.25, 0) m; start angle: 45 deg; }
            body r2 { mass: 1 kg; inertia: 1 kg*m^2; port d: (0, 0) m; port p: (0.25, 0) m; start angle: 135 deg; }
            revolute ja(ground.a, left.a);
            revolute jb(ground.b, right.b);
            revolute jc(left.c, l2.c);
            revolute jd(right.d, r2.d);
            revolute tip(l2.p, r2.p);
            constraint m1: left.angle = q1;
            constraint m2: right.angle = q2;
        }
    }
}

#[test]
fn elbows_that_coincide_are_told() {
    let q1 = 0.5_f64.acos();
    let fault = (five_bar::FiveBar { q1, q2: PI - q1, ..five_bar::FiveBar::new() }).start().err().unwrap();
    assert!(matches!(fault.cause, Cause::Repeats { .. }), "{fault}");
    assert!(fault.to_string().contains("pins of a loop coincide"), "{fault}");
}
