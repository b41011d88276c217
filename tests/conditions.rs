//! Conditions that stand within others: what is looked at, and that nothing that matters is missed.
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
#[path = "support/random.rs"]
mod random;

use plm::{Adams, Cause, Dop853, Dopri5, Mechanism as _, Method, Moment as _, RadauIia5, Rk4, Stats};

use random::Random;
use scene::{Given as _, Named as _, Scene};

/// Four points that swing, each by itself, and a clock that runs as long as a condition of them holds.
macro_rules! clock {
    ($module:ident, |$a:ident, $b:ident, $c:ident, $d:ident| $known:expr, { $($condition:tt)* }) => {
        mod $module {
            use super::{Known, Swing, known};

            scene! {
                pub Clock {
                    allow(W0002, W0007);
                    param ka: 1/s^2 = 1/(1 s)^2; param kb: 1/s^2 = 1/(1 s)^2; param kc: 1/s^2 = 1/(1 s)^2; param kd: 1/s^2 = 1/(1 s)^2;
                    param at_a: 1 = 0; param at_b: 1 = 0; param at_c: 1 = 0; param at_d: 1 = 0;
                    state a: 1 = 1; state b: 1 = 1; state c: 1 = 1; state d: 1 = 1;
                    state va: 1/s = 0; state vb: 1/s = 0; state vc: 1/s = 0; state vd: 1/s = 0;
                    rate a = va; rate b = vb; rate c = vc; rate d = vd;
                    rate va = -ka*a; rate vb = -kb*b; rate vc = -kc*c; rate vd = -kd*d;
                    state seconds: s = 0;
                    rate seconds = if $($condition)* then 1 else 0;
                    body idle { mass: 1 kg; inertia: 1 kg*m^2; }
                    output seconds, a, b, c, d;
                    // What is looked at from outside has its side at every sample.
                    output side_a = if a > at_a then 1 else 0;
                    output side_d = if d > at_d then 1 else 0;
                }
            }

            pub fn expected(swings: &[Swing; 4], until: f64) -> Known {
                known(swings, until, |[$a, $b, $c, $d]| $known)
            }
        }
    };
}

/// A clock with the swings of its points.
fn clock(clock: Scene, swings: &[Swing; 4]) -> Scene {
    ["a", "b", "c", "d"].into_iter().zip(swings).fold(clock, |clock, (point, swing)| {
        clock.with(&format!("k{point}"), swing.w * swing.w).with(&format!("at_{point}"), swing.at)
    })
}

/// The reading of a clock at a time, and the counts of its run.
fn run<I: Method<Scene>>(of: Scene, swings: &[Swing; 4], method: I, until: f64) -> (f64, Stats) {
    let mut sim = clock(of, swings).start_with(method).unwrap();
    sim.run(until, 0.05, |state| {
        let sides = [(swings[0], state.value_of("side_a")), (swings[3], state.value_of("side_d"))];
        for (swing, side) in sides {
            let above = swing.place(state.time()) - swing.at;
            assert!(above.abs() < 1e-5 || (above > 0.0) == (side > 0.5), "{swing:?} at {}", state.time());
        }
    })
    .unwrap();
    (sim.value_of("seconds"), sim.stats())
}

/// `cos(w t)`, and where it is asked whether it is above.
#[derive(Clone, Copy, Debug)]
struct Swing {
    w: f64,
    at: f64,
}

impl Swing {
    fn place(&self, t: f64) -> f64 {
        (self.w * t).cos()
    }

    /// All times up to `until` at which it comes to `at`.
    fn times(&self, until: f64) -> Vec<f64> {
        let (turn, first) = (2.0 * std::f64::consts::PI, self.at.acos());
        let turns = 0..=(self.w * until / turn) as u32 + 1;
        let times = turns.flat_map(|k| [first, turn - first].map(|at| (f64::from(k) * turn + at) / self.w));
        times.filter(|time| *time < until).collect()
    }
}

/// For how long a condition holds, how often it changes, and how often those that it is made of do.
#[derive(Clone, Copy, Debug)]
struct Known {
    seconds: f64,
    changes: u64,
    all: u64,
}

/// By the roots of cosines and a truth table, from one change to the next.
fn known(swings: &[Swing; 4], until: f64, holds: impl Fn([bool; 4]) -> bool) -> Known {
    let mut times: Vec<f64> = swings.iter().flat_map(|swing| swing.times(until)).collect();
    times.sort_by(f64::total_cmp);
    let all = times.len() as u64;
    times.push(until);
    let (mut known, mut from, mut held) = (Known { seconds: 0.0, changes: 0, all }, 0.0, None);
    for to in times {
        let middle = 0.5 * (from + to);
        let now = holds(swings.map(|swing| swing.place(middle) > swing.at));
        known.seconds += if now { to - from } else { 0.0 };
        known.changes += u64::from(held.is_some_and(|held| held != now));
        (from, held) = (to, Some(now));
    }
    known
}

clock!(both, |a, b, _c, _d| a && b, { a > at_a and b > at_b });
clock!(all, |a, b, c, d| a && b && c && d, { a > at_a and b > at_b and c > at_c and d > at_d });
clock!(pairs, |a, b, c, d| a && b || c && d, { (a > at_a and b > at_b) or (c > at_c and d > at_d) });
clock!(shared, |a, b, c, d| a && b || !a && c && !d, {
    (a > at_a and b > at_b) or (a < at_a and c > at_c and d < at_d)
});
clock!(other, |a, b, c, d| (a || b) && !(c && (d || a)), {
    (a > at_a or b > at_b) and not (c > at_c and (d > at_d or a > at_a))
});
clock!(nested, |a, b, c, d| if a { b } else if c { d } else { b && d }, {
    (a > at_a and b > at_b) or (a <= at_a and c > at_c and d > at_d) or (a <= at_a and c <= at_c and b > at_b and d > at_d)
});

/// Runs of a compound condition by every kind of method, against what is known.
macro_rules! found {
    ($name:ident, $module:ident, $seed:expr) => {
        #[test]
        fn $name() {
            let mut random = Random($seed);
            for case in 0..6 {
                let mut swing = || Swing { w: random.between(0.3, 12.0), at: random.between(-0.95, 0.95) };
                let mut swings = [swing(), swing(), swing(), swing()];
                // Two that are hardly ever on the same side.
                if case % 3 == 0 {
                    swings[1] = Swing { w: swings[0].w, at: -swings[0].at + random.between(0.0, 0.02) };
                }
                let until = 5.0;
                let known = $module::expected(&swings, until);
                let check = |method: &str, (seconds, stats): (f64, Stats), off: f64| {
                    let what =
                        format!("seed {}, case {case}, {method}: {swings:?} {known:?} {stats:?}", $seed);
                    assert!((seconds - known.seconds).abs() < off, "{what}: {seconds}");
                    // `a > at_a` and `a < at_a` are two.
                    assert!(known.changes <= stats.switches && stats.switches <= 2 * known.all, "{what}");
                };
                check("Dop853", run($module::Clock::new(), &swings, Dop853::new(1e-10), until), 1e-7);
                check("Dopri5", run($module::Clock::new(), &swings, Dopri5::new(1e-9), until), 1e-6);
                if case < 2 {
                    check("Adams", run($module::Clock::new(), &swings, Adams::new(1e-9), until), 1e-5);
                    check(
                        "RadauIia5",
                        run($module::Clock::new(), &swings, RadauIia5::new(1e-8), until),
                        1e-4,
                    );
                }
            }
        }
    };
}
found!(two_together_are_found, both, 20_261_101);
found!(four_together_are_found, all, 20_261_102);
found!(pairs_are_found, pairs, 20_261_103);
found!(what_stands_in_both_parts_is_found, shared, 20_261_104);
found!(what_is_denied_is_found, other, 20_261_105);
found!(choices_within_choices_are_found, nested, 20_261_106);

/// A ball that must stay above the ground, and one that is blown back while it is below.
macro_rules! ball {
    ($module:ident, $($formulation:tt)*) => {
        mod $module {
            scene! {
                pub Ball {
                    $($formulation)*
                    allow(W0002);
                    param drag: N*s/m = 0.1 N*s/m;
                    param level: m = 0;
                    gravity: 9.81 m/s^2;
                    body ball { mass: 1 kg; inertia: 1e-3 kg*m^2; port c: (0, 0) m; start y: 1 m; start vx: 0.5 m/s; }
                    force air(ball.c) { x: -drag*ball.vx; y: -drag*ball.vy; }
                    require above: ball.y > level;
                }
            }
        }
    };
}
ball!(ball,);
ball!(ball_absolute, formulation: absolute;);

/// What a requirement has ended begins again where it ended, in any direction, and says at once what is wrong with it.
macro_rules! begins_again {
    ($name:ident, $module:ident, $seed:expr) => {
        #[test]
        fn $name() {
            let mut random = Random($seed);
            for case in 0..40 {
                let (drag, level) = (random.between(0.0, 2.0), random.between(-3.0, 0.9));
                let far = 10.0_f64.powf(random.between(0.0, 3.0));
                let level = level * far;
                let mut ball = $module::Ball::new()
                    .with("drag", drag)
                    .with("level", level)
                    .with_start("ball.y", far)
                    .with_start("ball.vy", random.between(-20.0, 5.0));
                let what = format!("seed {}, case {case}: drag {drag}, from {far} to {}", $seed, level);
                let mut sim = ball.start().unwrap();
                let fault = sim.step(1e4).unwrap_err();
                assert_eq!((fault.part, fault.cause), ("above", Cause::Required), "{what}: {fault}");
                // Where it ended is on the boundary but for rounding.
                let off = (sim.state_of("ball").y - level).abs();
                assert!(off <= 1e-13 * far * (1.0 + fault.time), "{what}: {off:e}");
                let (speed, time) = (-sim.state_of("ball").vy, fault.time);
                ball = ball.with_starts(&sim.state().starts());
                // It falls on: at once.
                let mut down = ball.start_at(time, Dop853::default()).unwrap();
                let fault = down.step(0.1).unwrap_err();
                assert!(fault.time <= time * (1.0 + 1e-12) && fault.part == "above", "{what}: {fault}");
                // Upwards it goes on, and comes back.
                ball = ball.with_start("ball.vy", speed);
                let mut up = ball.start_at(time, Dop853::default()).unwrap();
                let fault = up.step(1e4).unwrap_err();
                assert!(
                    fault.time > time + 1e-2 * speed && fault.cause == Cause::Required,
                    "{what}: {fault}"
                );
                let mut up = ball.start_at(time, Rk4::new(1e-3)).unwrap();
                assert!(up.step(1e-3 * speed.min(5.0)).is_ok(), "{what}");
                // Beyond rounding it is on the wrong side, whatever its speed.
                let by = far * 10.0_f64.powf(random.between(-9.0, 0.0));
                ball = ball.with_start("ball.y", level - by);
                for fault in [
                    ball.start_at(time, Dop853::default()).unwrap().step(0.1).unwrap_err(),
                    ball.start_at(time, Rk4::new(1e-3)).unwrap().step(0.1).unwrap_err(),
                ] {
                    let Cause::NotMet { by: found } = fault.cause else { panic!("{what}: {fault}") };
                    assert!((found / by - 1.0).abs() < 1e-5 && fault.time == time, "{what}: {fault}, {by}");
                }
            }
        }
    };
}
begins_again!(what_a_requirement_has_ended_begins_again, ball, 20_261_107);
begins_again!(what_a_requirement_has_ended_begins_again_in_absolute_coordinates, ball_absolute, 20_261_108);

mod gate {
    scene! {
        pub Gate {
            param drive: N = 3 N;
            ground { port o: (0, 0) m; }
            body block { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0.3 m, locked; }
            prismatic rail(ground.o, block.o);
            force push(block.o) { x: if block.x*0.1 - 0.03 m < 0 m then -drive else drive; }
        }
    }
}

/// Steps of fixed length know no better than the side that a step begins with: on the boundary that is where it goes.
#[test]
fn a_start_on_the_boundary_takes_the_side_that_it_goes_to() {
    for speed in [2.0, -2.0] {
        for off in [0.0, 1e-16, -1e-16, 2e-16, -2e-16] {
            let gate = gate::Gate::new().with_start("block.x", 0.3 + off).with_start("block.vx", speed);
            let mut sim = gate.start_with(Rk4::new(0.1)).unwrap();
            sim.step(0.1).unwrap();
            let expected = 0.3 + 0.1 * speed + 0.5 * 3.0 * speed.signum() * 0.01;
            assert!(
                (sim.state_of("block").x - expected).abs() < 1e-14,
                "{speed} {off:e}: {}",
                sim.state_of("block").x
            );
            assert_eq!(sim.stats().switches, 0, "{speed} {off:e}");
        }
    }
}
