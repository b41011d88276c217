//! Functions that jump or grow without bound where nobody has written a condition: `atan2` on its cut, quotients at their poles, ends
//! of domains.
#![allow(
    clippy::large_types_passed_by_value,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    unreachable_pub,
    reason = "tests"
)]

#[path = "support/random.rs"]
mod random;
#[macro_use]
#[path = "support/scene.rs"]
mod scene;

use plm::{Cause, Dop853, Dopri5, Fault, Mechanism as _, Moment as _, RadauIia5, Rk4};
use std::f64::consts::{PI, TAU};

use random::Random;
use scene::{Given as _, Named as _, Scene};

/// A wheel that follows a drive which turns freely, by a row of the drive's angle.
macro_rules! follower {
    ($name:ident, { $($formulation:tt)* }, { $($row:tt)* }) => {
        scene! {
            pub $name {
                $($formulation)*
                allow(W0007);
                param gain: 1 = 0.5;
                param from: rad = 0;
                ground { port w: (0, 0) m; port v: (1, 0) m; }
                body drive { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; }
                body wheel { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; start x: 1 m; }
                revolute a(ground.w, drive.o);
                revolute b(ground.v, wheel.o);
                constraint index: $($row)*;
            }
        }
    };
}
follower!(Geared, {}, { wheel.angle = gain * atan2(sin(drive.angle - from), cos(drive.angle - from)) });
follower!(GearedAbsolute, { formulation: absolute; }, { wheel.angle = gain*atan2(sin(drive.angle - from), cos(drive.angle - from)) });
follower!(Turned, {}, { wheel.angle = atan2(sin(drive.angle - from), cos(drive.angle - from)) });
follower!(TurnedAbsolute, { formulation: absolute; }, { wheel.angle = atan2(sin(drive.angle - from), cos(drive.angle - from)) });
follower!(Seen, {}, { wheel.angle = gain*1 rad*sin(2*atan2(sin(drive.angle - from), cos(drive.angle - from))) });

/// A follower whose drive begins with a speed.
fn start(follower: Scene, gain: f64, from: f64, speed: f64) -> Scene {
    follower.with("gain", gain).with("from", from).with_lock("drive.omega", speed)
}

macro_rules! jumps {
    ($name:ident, $follower:ident, $seed:expr) => {
        #[test]
        fn $name() {
            let mut random = Random($seed);
            for case in 0..30 {
                let (gain, from) = (random.between(0.1, 0.9), random.between(-3.0, 3.0));
                let speed = random.between(0.3, 4.0) * if case % 2 == 0 { 1.0 } else { -1.0 };
                let follower = start($follower::new(), gain, from, speed).with_lock("drive.angle", 0.0);
                // The drive keeps its speed until its angle is `from` and half a turn.
                let first = if speed > 0.0 { from + PI } else { from - PI };
                let known = (first * speed.signum()).rem_euclid(TAU) / speed.abs();
                let check = |method: &str, outcome: Result<(), Fault>, off: f64| {
                    let what = format!(
                        "seed {}, case {case}, {method}: gain {gain}, from {from}, speed {speed}",
                        $seed
                    );
                    let fault = outcome.unwrap_err();
                    let Cause::Jump { by, angular: true, speed: false } = fault.cause else {
                        panic!("{what}: {fault}")
                    };
                    assert_eq!(fault.part, "index", "{what}");
                    assert!((by - TAU * gain).abs() < 1e-6, "{what}: {by}");
                    assert!((fault.time - known).abs() < off, "{what}: {} for {known}", fault.time);
                };
                check("Dop853", follower.start().unwrap().step(30.0), 1e-6);
                check("Dop853, run", follower.start().unwrap().run(30.0, 0.1, |_| ()), 1e-6);
                check("Dopri5", follower.start_with(Dopri5::new(1e-7)).unwrap().step(30.0), 1e-6);
                check("Radau", follower.start_with(RadauIia5::new(1e-7)).unwrap().step(30.0), 1e-5);
                check("Rk4", follower.start_with(Rk4::new(0.01)).unwrap().step(30.0), 0.011);
            }
        }
    };
}
jumps!(a_row_that_jumps_at_a_cut_ends_the_run, Geared, 20_261_111);
jumps!(a_row_that_jumps_at_a_cut_ends_the_run_in_absolute_coordinates, GearedAbsolute, 20_261_112);

macro_rules! turns {
    ($name:ident, $follower:ident) => {
        #[test]
        fn $name() {
            for speed in [2.0, -1.3] {
                for from in [0.0, 1.0, -2.0] {
                    let follower = start($follower::new(), 1.0, from, speed).with_lock("drive.angle", 0.0);
                    let off = |angle: f64, time: f64| (0.5 * (angle - speed * time + from)).sin().abs();
                    let mut sim = follower.start().unwrap();
                    sim.run(20.0, 0.3, |state| {
                        let off = off(state.state_of("wheel").angle, state.time());
                        assert!(off < 1e-6, "{speed} {from} at {}: {off:e}", state.time());
                    })
                    .unwrap();
                    let mut sim = follower.start_with(Rk4::new(0.01)).unwrap();
                    sim.step(20.0).unwrap();
                    assert!(
                        (sim.state_of("drive").omega - speed).abs() < 1e-9,
                        "{}",
                        sim.state_of("drive").omega
                    );
                    assert!(off(sim.state_of("wheel").angle, 20.0) < 1e-9, "{speed} {from}");
                }
            }
        }
    };
}
turns!(whole_turns_of_a_body_are_no_jump, Turned);
turns!(whole_turns_of_a_body_are_no_jump_in_absolute_coordinates, TurnedAbsolute);

/// What is the same on both sides of a cut is not looked at.
#[test]
fn a_cut_that_nothing_sees_is_none() {
    let mut sim = start(Seen::new(), 0.3, 0.4, 1.0).start().unwrap();
    sim.step(20.0).unwrap();
    assert_eq!(sim.stats().switches, 0);
}

scene! {
    pub Saw {
        param stiffness: N*m = 1 N*m;
        ground { port o: (0, 0) m; }
        body rotor { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
        revolute hinge(ground.o, rotor.o) { drive: -stiffness*atan2(sin(rotor.angle), cos(rotor.angle))/1 rad; }
        output wound = atan2(sin(rotor.angle), cos(rotor.angle)) in deg;
    }
}

/// A spring that is wound at most half a turn: its torque jumps on the cut, its energy does not.
#[test]
fn a_force_that_jumps_at_a_cut_is_switched_there() {
    let seed = 20_261_113;
    let mut random = Random(seed);
    for case in 0..20 {
        let stiffness = random.between(0.1, 3.0);
        // Enough to go over the top, where half a turn is wound.
        let speed =
            (stiffness * PI * PI).sqrt() * random.between(1.05, 3.0) * if case % 2 == 0 { 1.0 } else { -1.0 };
        let saw = Saw::new().with("stiffness", stiffness).with_start("rotor.omega", speed);
        let mut sim = saw.start_with(Dop853::new(1e-10)).unwrap();
        sim.step(30.0).unwrap();
        let what = format!("seed {seed}, case {case}: stiffness {stiffness}, speed {speed}");
        let angle = sim.state_of("rotor").angle;
        let wound = angle - TAU * (angle / TAU).round();
        let energy = |wound: f64, omega: f64| 0.5 * (stiffness * wound * wound + omega * omega);
        let off = energy(wound, sim.state_of("rotor").omega) / energy(0.0, speed) - 1.0;
        assert!(off.abs() < 1e-7, "{what}: {off:e}");
        assert!((sim.value_of("wound") - wound).abs() < 1e-9, "{what}: {} {wound}", sim.value_of("wound"));
        // Once at the cut of each turn, and once on the way to the next.
        let cuts = (angle.abs() / TAU + 0.5).floor() as u64;
        let switches = sim.stats().switches;
        assert!((cuts..=2 * cuts + 1).contains(&switches), "{what}: {switches} for {cuts} cuts");
    }
}

/// A body on a rail that is led to a place.
macro_rules! led {
    ($name:ident, { $($item:tt)* }) => {
        scene! {
            pub $name {
                allow(W0007);
                param at: s = 1 s;
                param strength: 1 = 1;
                ground { port o: (0, 0) m; }
                body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start vx: 1 m/s; }
                prismatic rail(ground.o, b.o);
                $($item)*
            }
        }
    };
}
led!(Over, { constraint drive: b.x = strength*1 m*s/(t + 0.3 s - at - 0.3 s); });
led!(Tangent, { constraint drive: b.x = strength*1 m*tan((t - at)*1 rad/s + 90 deg); });
led!(Square, { constraint drive: b.x = strength*1 m*s^2/((t - at)*(t - at + 3 s)); });
led!(Pushed, { force push(b.o) { x: strength*1e-9 N*m/(b.x - at*1 m/s); } });
led!(Bounded, { force push(b.o) { x: strength*1 N*sin((b.x - at*1 m/s)*1 rad/m)*1 m/(b.x - at*1 m/s); } });
led!(Avoided, { force push(b.o) { x: strength*(if abs(b.x - at*1 m/s) < 0.1 m then 10 N else 1 N*m/max(abs(b.x - at*1 m/s), 0.1 m)); } });
led!(Chosen, { force push(b.o) { x: strength*(if b.x < at*1 m/s + 0.1 m then 0 N else 1 N*m/(b.x - at*1 m/s)); } });
led!(Root, { constraint drive: b.x = strength*1 m*sqrt(at/(1 s) - t/(1 s)); });
led!(Arc, { constraint drive: b.x = strength*1 m*asin(t/at)/(1 rad); });
led!(Log, { force push(b.o) { x: strength*1 N*ln(at/(1 s) - b.x/(1 m)); } });

fn outcomes(led: Scene, at: f64, strength: f64) -> [Result<(), Fault>; 3] {
    let led = led.with("at", at).with("strength", strength);
    [
        led.start().and_then(|mut sim| sim.step(2.0)),
        led.start_with(Dopri5::new(1e-6)).and_then(|mut sim| sim.run(2.0, 0.7, |_| ())),
        led.start_with(Rk4::new(0.01)).and_then(|mut sim| sim.step(2.0)),
    ]
}

#[test]
fn poles_end_the_run_and_say_what_vanishes() {
    let seed = 20_261_114;
    let mut random = Random(seed);
    for case in 0..20 {
        let (at, strength) = (random.between(0.3, 1.5), random.between(-2.0, 2.0));
        for (part, outcomes) in [
            ("drive", outcomes(Over::new(), at, strength)),
            ("drive", outcomes(Tangent::new(), at, strength)),
            ("drive", outcomes(Square::new(), at, strength)),
            ("push", outcomes(Pushed::new(), at, strength)),
        ] {
            for (outcome, off) in outcomes.into_iter().zip([1e-5, 1e-5, 0.011]) {
                let what = format!("seed {seed}, case {case}: {part} at {at} by {strength}");
                let fault = outcome.unwrap_err();
                assert!(matches!(fault.cause, Cause::Pole { .. }) && fault.part == part, "{what}: {fault}");
                assert!((fault.time - at).abs() < off, "{what}: {fault}");
            }
        }
        // What stays bounded, or is not read there, is none.
        for outcomes in [
            outcomes(Bounded::new(), at, strength),
            outcomes(Avoided::new(), at, strength),
            outcomes(Chosen::new(), at, strength),
        ] {
            for outcome in outcomes {
                outcome.unwrap();
            }
        }
    }
}

#[test]
fn nothing_goes_beyond_the_end_of_a_domain() {
    for at in [0.4, 0.9, 1.3] {
        for outcomes in
            [outcomes(Root::new(), at, 1.0), outcomes(Arc::new(), at, 1.0), outcomes(Log::new(), at, 0.1)]
        {
            for outcome in outcomes {
                let fault = outcome.unwrap_err();
                // A step of fixed length has been beyond, where nothing is a number.
                assert!(matches!(fault.cause, Cause::Domain { .. } | Cause::NotFinite), "{at}: {fault}");
                assert!((fault.time - at).abs() < 0.2, "{at}: {fault}");
            }
        }
    }
}
