//! Steps of fixed length that are too long are told or end the run: their estimate against the right motion.
//!
//! A run whose error exceeds the size of what moves is told by `notice()`, or stopped by a fault; one that is right to 1e-3 is
//! silent. Mechanisms, lengths in decimetres, starts and lengths of steps are by chance. The right motion is that of Dormand and
//! Prince's method of order 8 with a tolerance of 1e-11. An estimate of steps knows nothing of what a motion makes of their
//! errors: motions that make more than thirty times of them, by a second right one from beside the start, must not
//! be told, but may. `PLM_LONG_STEPS=20 cargo test --test long_steps -- --nocapture` has more of them, and prints each.
#![allow(
    clippy::large_types_passed_by_value,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests"
)]

#[macro_use]
#[path = "support/scene.rs"]
mod scene;
#[path = "support/random.rs"]
mod random;

use plm::{BodyState, Dop853, Fault, Gauss, Notice, Rk4, Ros34Pw2, SemiImplicitEuler};
use plm_run::AnyMethod;
use random::Random;
use scene::{By as _, Given as _, Named as _, Scene, State};

scene! {
    pub Pendulum {
        gravity: 9.81 m/s^2;
        param l: m = 1 m;
        ground { port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, l) ; start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
        revolute hinge(ground.o, bob.o) { damping: 0.02 N*m*s/rad; }
    }
}
scene! {
    pub Double {
        gravity: 9.81 m/s^2;
        param l: m = 1 m;
        param r: m = 0.7 m;
        ground { port o: (0, 0) m; }
        body one { mass: 2 kg; inertia: 0.05 kg*m^2; port o: (0, l/2); port p: (0, -l/2); start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
        body two { mass: 1 kg; inertia: 0.02 kg*m^2; port p: (0, r); start angle: -60 deg, locked; start omega: 0 rad/s, locked; }
        revolute j(ground.o, one.o);
        revolute k(one.p, two.p);
    }
}
macro_rules! four_bar {
    ($name:ident, $formulation:ident) => {
        scene! {
            pub $name {
                formulation: $formulation;
                gravity: 9.81 m/s^2;
                param span: m = 1 m;
                param l1: m = 0.3 m;
                param l2: m = 0.9 m;
                param l3: m = 0.7 m;
                ground { port o: (0, 0) m; port p: (span, 0 m); }
                body crank { mass: 1 kg; inertia: 0.05 kg*m^2; port o: (-l1/2, 0 m); port b: (l1/2, 0 m); start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
                body coupler { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-l2/2, 0 m); port c: (l2/2, 0 m); start x: 0.6 m; start y: 0.6 m; start angle: 20 deg; }
                body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (l3/2, 0 m); port p: (-l3/2, 0 m); start x: span; start y: 0.3 m; start angle: 90 deg; }
                revolute o(ground.o, crank.o);
                revolute b(crank.b, coupler.b);
                revolute c(coupler.c, rocker.c) { damping: 0.05 N*m*s/rad; }
                revolute p(ground.p, rocker.p);
            }
        }
    };
}
four_bar!(FourBar, loops);
four_bar!(FourBarAbsolute, absolute);
scene! {
    pub SixBar {
        gravity: 9.81 m/s^2;
        param span: m = 1 m;
        param l1: m = 0.3 m;
        param l2: m = 0.9 m;
        param l3: m = 0.7 m;
        param l4: m = 0.9 m;
        param l5: m = 0.8 m;
        ground { port o: (0, 0) m; port p: (span, 0 m); port g: (span + 1 m, 0 m); }
        body crank { mass: 1 kg; inertia: 0.05 kg*m^2; port o: (-l1/2, 0 m); port b: (l1/2, 0 m); start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
        body coupler { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-l2/2, 0 m); port c: (l2/2, 0 m); start x: 0.6 m; start y: 0.6 m; start angle: 20 deg; }
        body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (l3/2, 0 m); port e: (0.2 m, 0.1 m); port p: (-l3/2, 0 m); start x: span; start y: 0.3 m; start angle: 90 deg; }
        body link { mass: 1 kg; inertia: 0.08 kg*m^2; port e: (-l4/2, 0 m); port f: (l4/2, 0 m); start x: span + 0.5 m; start y: 0.7 m; start angle: 10 deg; }
        body arm { mass: 1 kg; inertia: 0.06 kg*m^2; port g: (-l5/2, 0 m); port f: (l5/2, 0 m); start x: span + 1 m; start y: 0.4 m; start angle: 90 deg; }
        revolute o(ground.o, crank.o);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute p(ground.p, rocker.p);
        revolute e(rocker.e, link.e);
        revolute f(link.f, arm.f);
        revolute g(ground.g, arm.g) { damping: 0.05 N*m*s/rad; }
    }
}
scene! {
    pub Chain {
        gravity: 9.81 m/s^2;
        param l: m = 0.5 m;
        ground { port o: (0, 0) m; }
        body one { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0, l/2); port p: (0, -l/2); start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
        body two { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0, l/2); port p: (0, -l/2); start angle: 60 deg, locked; }
        body three { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0, l/2); port p: (0, -l/2); start angle: 20 deg, locked; }
        body four { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0, l/2); port p: (0, -l/2); start angle: 0 deg, locked; }
        revolute j(ground.o, one.o) { damping: 0.2 N*m*s/rad; }
        revolute k(one.p, two.o) { damping: 0.2 N*m*s/rad; }
        revolute m(two.p, three.o) { damping: 0.2 N*m*s/rad; }
        revolute n(three.p, four.o) { damping: 0.2 N*m*s/rad; }
    }
}
scene! {
    /// A slide on a spring, damped, pushed by a lag behind a sine.
    pub Slide {
        param k: N/m = 100 N/m;
        param d: N*s/m = 1 N*s/m;
        param f: N = 30 N;
        param w: rad/s = 6 rad/s;
        param lag: s = 0.1 s;
        ground { port o: (0, 0) m; }
        body mass { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; start x: 0.3 m; start vx: 0.5 m/s; }
        prismatic rail(mass.a, ground.o) { stiffness: k; damping: d; }
        force push(mass.a) { x: pressure; }
        state pressure: N = 0 N;
        rate pressure = (f*sin(w*t) - pressure)/lag;
    }
}

/// Poses and velocities of all bodies, and the states of first order.
type Motion = (Vec<BodyState<f64>>, Vec<f64>);

/// Those of a moment.
fn bodies(state: &State) -> Motion {
    (state.bodies(), state.numbers())
}

/// How far two states are apart, as a share of their sizes: rad, m and their rates, or more where these are larger. What is not
/// a number is as far as can be.
fn apart(found: &Motion, right: &Motion) -> f64 {
    let states =
        found.1.iter().zip(&right.1).map(|(found, right)| (found - right).abs() / right.abs().max(1.0));
    let mut most = states.fold(0.0_f64, f64::max);
    for (found, right) in found.0.iter().zip(&right.0) {
        let turn = found.angle - right.angle;
        let size = |right: f64| right.abs().max(1.0);
        let shares = [
            turn.sin().atan2(turn.cos()),
            (found.x - right.x) / size(right.x),
            (found.y - right.y) / size(right.y),
            (found.omega - right.omega) / size(right.omega),
            (found.vx - right.vx) / size(right.vx),
            (found.vy - right.vy) / size(right.vy),
        ];
        most = shares
            .iter()
            .fold(most, |most, share| if share.is_finite() { most.max(share.abs()) } else { f64::INFINITY });
    }
    most
}

/// What a run came to.
struct Run {
    error: f64,
    told: Vec<Notice>,
    fault: Option<Fault>,
    /// Steps of the interval with most of them, accepted and rejected.
    most_steps: u64,
    near_singular: u64,
}

/// Runs in steps of `h` beside the right motion.
fn run(mechanism: Scene, method: impl Into<AnyMethod<Scene>>, h: f64, right: &[Motion]) -> Run {
    let mut sim = mechanism.by(method).unwrap();
    let (mut error, mut fault, mut most_steps) = (0.0_f64, None, 0);
    for right in right {
        let before = sim.stats();
        let made = sim.step(h);
        let after = sim.stats();
        most_steps = most_steps.max(after.steps + after.rejected - before.steps - before.rejected);
        if let Err(found) = made {
            fault = Some(found);
            break;
        }
        error = error.max(apart(&bodies(&sim), right));
    }
    Run {
        error,
        told: plm::Sim::notices(&sim).collect(),
        fault,
        most_steps,
        near_singular: sim.stats().near_singular,
    }
}

/// The right motion after each step of `h`.
fn right(mechanism: Scene, h: f64, steps: usize) -> Option<Vec<Motion>> {
    let mut sim = mechanism.by(Dop853::new(1e-11).with_most_steps(100_000)).ok()?;
    (0..steps).map(|_| sim.step(h).ok().map(|()| bodies(&sim))).collect()
}

/// What the runs of a mechanism came to.
#[derive(Default)]
struct Count {
    runs: usize,
    wrong: usize,
    right: usize,
    stopped: usize,
    near_singular: usize,
}

impl Count {
    /// Looks at a run of which errors grow by a factor.
    fn see(&mut self, what: &str, run: &Run, grown: f64) {
        let Run { error, told, fault, most_steps, near_singular } = run;
        let tells = told.iter().any(|notice| matches!(notice, Notice::LongSteps { .. }));
        let divides = told.iter().any(|notice| matches!(notice, Notice::DividedSteps { .. }));
        if all_of_them() > 0 {
            println!(
                "{what}: error {error:.1e}, grown {grown:.1e}, {told:?}, {fault:?}, {most_steps} steps, {near_singular} near"
            );
        }
        self.runs += 1;
        self.wrong += usize::from(*error >= 1.0);
        self.right += usize::from(*error <= 1e-3 && fault.is_none());
        self.stopped += usize::from(fault.is_some());
        self.near_singular += usize::from(*near_singular > 0);
        assert!(
            *most_steps <= MOST_PARTS || *near_singular > 0,
            "{what}: {most_steps} steps of one interval"
        );
        if *error >= 1.0 && grown < MOST_GROWN {
            assert!(tells || divides || fault.is_some(), "{what}: off by {error}, which nothing tells");
        }
        if *error <= 1e-3 && fault.is_none() && !divides {
            assert!(!tells, "{what}: right to {error:e}, and yet {told:?}");
        }
    }
}

/// Most steps of an interval: 64 parts, each of which may have as many in a turn near a flat pose, and a second of a fast crank has several.
const MOST_PARTS: u64 = 10_000;
/// Errors may grow by this factor.
const MOST_GROWN: f64 = 30.0;
const SEED: u64 = 30;
const STEPS: [f64; 7] = [0.002, 0.02, 0.05, 0.1, 0.3, 1.0, 3.0];

/// Cases of each mechanism, if more than usual are asked for.
fn all_of_them() -> u64 {
    std::env::var("PLM_LONG_STEPS").ok().and_then(|count| count.parse().ok()).unwrap_or(0)
}

/// Runs of a mechanism by all methods; `build` gives it with a start that is `off` by a little.
fn sweep((name, is_tree): (&str, bool), until: f64, build: impl Fn(&mut Random, f64) -> Scene) {
    let mut count = Count::default();
    for case in 0..all_of_them().max(2) {
        let seed = 1000 * SEED + case;
        let (mechanism, beside) = (build(&mut Random(seed), 0.0), build(&mut Random(seed), 1e-7));
        for h in STEPS {
            let steps = ((until / h).round() as usize).max(4);
            let (Some(exact), Some(beside)) = (right(mechanism, h, steps), right(beside, h, steps)) else {
                continue;
            };
            let grown = exact.iter().zip(&beside).fold(0.0_f64, |most, (a, b)| most.max(apart(b, a))) / 1e-7;
            let what = |method: &str| format!("{name}, seed {seed}, {method} with {h} s");
            count.see(&what("Rk4"), &run(mechanism, Rk4::new(h), h, &exact), grown);
            count.see(&what("Ros34Pw2"), &run(mechanism, Ros34Pw2::new(h), h, &exact), grown);
            // In loops both step over peaks of the motion, of which their few rates tell nothing.
            if is_tree {
                let euler = run(mechanism, SemiImplicitEuler::new(h), h, &exact);
                count.see(&what("SemiImplicitEuler"), &euler, grown);
                count.see(&what("Gauss"), &run(mechanism, Gauss::<Scene, 3>::new(h), h, &exact), grown);
            }
        }
    }
    let Count { runs, wrong, right, stopped, near_singular } = count;
    println!(
        "{name}: {runs} runs, {wrong} wrong, {right} right to 1e-3, {stopped} stopped, {near_singular} near singular poses"
    );
    assert!(wrong + stopped > 2 && right > 0, "{name}: steps of all kinds");
}

/// A whole number of decimetres.
fn decimal(random: &mut Random, low: usize, high: usize) -> f64 {
    (low + random.below(high - low + 1)) as f64 / 10.0
}

/// Angle and speed of a crank.
fn crank(random: &mut Random) -> (f64, f64) {
    (random.between(0.5, 2.0), random.between(-8.0, 8.0))
}

macro_rules! linkages {
    ($test:ident, $mechanism:ident, $until:literal $(, $more:ident)*) => {
        #[test]
        fn $test() {
            sweep((stringify!($mechanism), false), $until, |random, off| {
                #[allow(unused_mut, reason = "of linkages of four bars")]
                let mut linkage = $mechanism::new()
                    .with("span", decimal(random, 8, 12))
                    .with("l1", decimal(random, 1, 4))
                    .with("l2", decimal(random, 6, 12))
                    .with("l3", decimal(random, 5, 9));
                $(linkage = linkage.with(stringify!($more), decimal(random, 7, 9));)*
                let (angle, speed) = crank(random);
                linkage.with_lock("crank.angle", angle).with_lock("crank.omega", speed + off)
            });
        }
    };
}
linkages!(steps_of_four_bars_are_told, FourBar, 2.0);
linkages!(steps_of_four_bars_in_absolute_coordinates_are_told, FourBarAbsolute, 1.0);
linkages!(steps_of_six_bars_are_told, SixBar, 1.0, l4, l5);

#[test]
fn steps_of_pendulums_are_told() {
    sweep(("pendulum", true), 3.0, |random, off| {
        Pendulum::new()
            .with("l", decimal(random, 2, 20))
            .with_lock("bob.angle", random.between(-3.0, 3.0))
            .with_lock("bob.omega", random.between(-5.0, 5.0) + off)
    });
    sweep(("double pendulum", true), 2.0, |random, off| {
        Double::new()
            .with("l", decimal(random, 3, 12))
            .with("r", decimal(random, 2, 9))
            .with_lock("one.angle", random.between(-1.5, 1.5))
            .with_lock("two.angle", random.between(-1.5, 1.5))
            .with_lock("one.omega", random.between(-2.0, 2.0) + off)
            .with_lock("two.omega", random.between(-2.0, 2.0))
    });
}

#[test]
fn steps_of_chains_are_told() {
    sweep(("chain", true), 2.0, |random, off| {
        Chain::new()
            .with("l", decimal(random, 2, 8))
            .with_lock("one.angle", random.between(-1.5, 1.5))
            .with_lock("two.angle", random.between(-1.5, 1.5))
            .with_lock("one.omega", random.between(-3.0, 3.0) + off)
    });
}

#[test]
fn steps_of_slides_after_a_lag_are_told() {
    sweep(("slide", true), 3.0, |random, off| {
        Slide::new()
            .with("k", random.between(10.0, 300.0))
            .with("d", random.between(0.0, 30.0))
            .with("f", random.between(1.0, 100.0))
            .with("w", random.between(1.0, 10.0))
            .with("lag", random.between(0.05, 1.0))
            .with_lock("mass.vx", 0.5 + off)
    });
}
