//! Runs with derivatives beside runs without: time of each, and what one and eight directions cost; backward, by eight variables, with a
//! trace that holds the whole run, and with one that holds a few steps. Scenes are derived by start values, on which a step depends through
//! its state alone, and one by eight parameters.
//!
//! ```text
//! cargo bench --bench gradients
//! ```
#![allow(clippy::panic, reason = "benches")]

#[path = "scenes/chain.rs"]
mod chain;
#[path = "../tests/support/standard.rs"]
#[allow(dead_code, unused_imports, unreachable_pub)] // The tests use more of it.
mod declared;

use std::hint::black_box;
use std::time::Instant;

use declared::{s1, s2, s6};
use plm::adjoint::{self, Carried, Memory};
use plm::runtime::Vector;
use plm::{
    By, Dop853, Mechanism, Method, Moment, Rk4, Sim, Term, Trace, Traced, with_derivatives, with_trace,
};

chain::chain!(Chain16, 16);

plm::mechanism! {
    /// A pendulum that knocks against a wall.
    pub Knocker {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (-0.5, 0) m; start angle: 0 rad; }
        revolute hinge(ground.o, arm.o);
        unilateral wall: arm.x >= -0.2 m { restitution: 0.7; }
    }
}

plm::mechanism! {
    /// A double pendulum with eight parameters.
    pub Parametric {
        param m1: kg = 1 kg;
        param m2: kg = 1 kg;
        param l1: m = 1 m;
        param l2: m = 1 m;
        param i1: kg*m^2 = 0.1 kg*m^2;
        param i2: kg*m^2 = 0.1 kg*m^2;
        param a1: rad = 1 rad;
        param a2: rad = 1.2 rad;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body one {
            mass: m1; inertia: i1; port a: (0 m, 0.5*l1); port b: (0 m, -0.5*l1);
            start angle: a1, locked;
        }
        body two { mass: m2; inertia: i2; port a: (0 m, 0.5*l2); start angle: a2, locked; }
        revolute shoulder(ground.o, one.a);
        revolute elbow(one.b, two.a);
    }
}

/// Times that every run is made, in turn, so that all see the same machine.
const ROUNDS: u32 = 30;

/// Terms of the trace of a whole run.
const WHOLE: usize = 12_000_000;
/// Saved states.
const SAVED: usize = 400;

/// Memory for the way back.
struct Store {
    terms: Vec<Term>,
    adjoints: Vec<[f64; 1]>,
}

/// Times of runs of a mechanism to a time by a method with its tolerance or step: without derivatives, in one direction, in eight; backward with
/// a trace of all of it, and with one of so many terms.
macro_rules! runs {
    ($name:literal, $mechanism:expr, $until:literal, $by:expr, $method:ident, $setting:literal, $parts:literal) => {{
        let mechanism = $mechanism;
        let by: [By<'_>; 8] = $by;
        let mut best = [f64::INFINITY; 5];
        let mut stores = [WHOLE, $parts]
            .map(|count| Store { terms: vec![Term::EMPTY; count], adjoints: vec![[0.0]; count] });
        for _ in 0..ROUNDS {
            let times = [
                time(|| {
                    let mut sim = black_box(mechanism).start_with($method::new($setting)).expect("it starts");
                    sim.step_to($until).expect("it runs");
                    black_box(&sim);
                }),
                time(|| {
                    let lifted = with_derivatives(black_box(&mechanism), [by[0]]).expect("it is known");
                    let mut sim = lifted.start_with($method::new($setting.into())).expect("it starts");
                    sim.step_to($until.into()).expect("it runs");
                    black_box(&sim);
                }),
                time(|| {
                    let lifted = with_derivatives(black_box(&mechanism), by).expect("it is known");
                    let mut sim = lifted.start_with($method::new($setting.into())).expect("it starts");
                    sim.step_to($until.into()).expect("it runs");
                    black_box(&sim);
                }),
                backward!(mechanism, by, &mut stores[0], $until, $method::new($setting.into())),
                backward!(mechanism, by, &mut stores[1], $until, $method::new($setting.into())),
            ];
            for (best, time) in best.iter_mut().zip(times) {
                *best = best.min(time);
            }
        }
        let [alone, rest @ ..] = best;
        let [one, eight, whole, parts] = rest.map(|time| time / alone);
        println!("{:<10} {:>9.1} {one:>6.2} {eight:>6.2} {whole:>6.2} {parts:>6.2}", $name, 1e6 * alone);
    }};
}

/// The time of the gradient of the first number of the state by eight start values; of its memory, which belongs to the caller, it has nothing.
macro_rules! backward {
    ($mechanism:expr, $by:expr, $store:expr, $until:expr, $method:expr) => {{
        let Store { terms, adjoints } = $store;
        let trace = Trace::new(terms, 8);
        let begin = || {
            let own = with_trace(black_box(&$mechanism), &$by, &trace).expect("they are known");
            own.start_with($method).expect("it starts")
        };
        let (mut carried, mut saved) = memory(&begin);
        let mut gradient = [[0.0]; 8];
        time(|| {
            let memory = Memory { adjoints, carried: &mut carried, saved: &mut saved };
            let until = $until.into();
            adjoint::adjoint(
                &trace,
                begin(),
                |sim| Sim::step_towards(sim, until),
                first,
                memory,
                &mut gradient,
            )
            .expect("it runs");
            black_box(gradient);
        })
    }};
}

fn first<'t, M, I>(sim: &Sim<M, I>) -> [Traced<'t>; 1]
where
    M: Mechanism<S = Traced<'t>>,
    I: Method<M>,
{
    [sim.state().x().at(0)]
}

fn memory<P: Copy>(_begin: &impl Fn() -> P) -> (Vec<Carried<f64, 1>>, Vec<Option<adjoint::Saved<P>>>) {
    (vec![Carried::EMPTY; adjoint::carried::<P, f64>()], vec![None; SAVED])
}

fn time(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64()
}

fn main() {
    println!("{:<10} {:>9} {:>6} {:>6} {:>6} {:>6}", "scene", "run, us", "one", "eight", "whole", "parts");
    let of_two = |a, b| [a, b, a, b, a, b, a, b].map(By::Start);
    runs!("S1", s1::DoublePendulum::new(), 2.0, of_two("arm.angle", "arm.omega"), Dop853, 1e-9, 2_000);
    runs!("S2", s2::FourBar::new(), 2.0, of_two("crank.angle", "crank.omega"), Dop853, 1e-9, 8_000);
    runs!("S6", s6::SliderCrank::new(), 2.0, of_two("crank.angle", "crank.omega"), Dop853, 1e-9, 8_000);
    runs!("knocker", Knocker::new(), 4.0, of_two("arm.angle", "arm.omega"), Dop853, 1e-9, 8_000);
    runs!("chain 16", Chain16::new(), 1.0, of_two("bar[0].angle", "bar[0].omega"), Dop853, 1e-9, 100_000);
    let eight = ["m1", "m2", "l1", "l2", "i1", "i2", "a1", "a2"].map(By::Parameter);
    runs!("parameters", Parametric::new(), 2.0, eight, Dop853, 1e-9, 8_000);
    println!("by Rk4 with 1 ms");
    runs!("S1", s1::DoublePendulum::new(), 2.0, of_two("arm.angle", "arm.omega"), Rk4, 1e-3, 2_000);
    runs!("S2", s2::FourBar::new(), 2.0, of_two("crank.angle", "crank.omega"), Rk4, 1e-3, 8_000);
    runs!("S6", s6::SliderCrank::new(), 2.0, of_two("crank.angle", "crank.omega"), Rk4, 1e-3, 8_000);
    runs!("knocker", Knocker::new(), 4.0, of_two("arm.angle", "arm.omega"), Rk4, 1e-3, 16_000);
}
