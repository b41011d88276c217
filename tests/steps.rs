//! Steps that a declaration orders, `emit: step(…)`: by themselves they do what a run does.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use plm::runtime::held::Loops;
use plm::runtime::{Constraints, Moment, Vector};
use plm::{Cause, Dop853, Fault, Mechanism, Method, Rk4, Ros34Pw2, SemiImplicitEuler, Sim};

plm::mechanism! {
    /// Two links that swing.
    Pendulum {
        gravity: 9.81 m/s^2;
        emit: step(rk4, semi_implicit_euler, linearly_implicit);
        ground { port o: (0, 0) m; }
        body arm { mass: 10 kg; inertia: 0.01 kg*m^2; port o: (-0.5, 0) m; port p: (0.5, 0) m; start angle: 45 deg, locked; }
        body forearm { mass: 10 kg; inertia: 0.01 kg*m^2; port p: (-1, 0) m; start angle: 0 deg, locked; }
        revolute shoulder(ground.o, arm.o) { damping: 3 N*m*s/rad; }
        revolute elbow(arm.p, forearm.p) { damping: 3 N*m*s/rad; }
    }
}

plm::mechanism! {
    /// A crank-rocker with a spring, a lag and a drive by the time.
    FourBar {
        gravity: 9.81 m/s^2;
        emit: step(rk4, semi_implicit_euler, linearly_implicit);
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 5 rad/s, locked; }
        body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; }
        body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.4, 0) m; port p: (-0.4, 0) m; start angle: 100 deg; }
        revolute o(ground.o, crank.a) { drive: lagging; }
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
        revolute p(ground.p, rocker.p) { stiffness: 2 N*m/rad; }
        state lagging: N*m = 0.5 N*m;
        rate lagging = (1 N*m*cos(3 rad/s*t) - lagging)/0.01 s;
    }
}

plm::mechanism! {
    /// The same loop in absolute coordinates.
    Absolute {
        gravity: 9.81 m/s^2;
        formulation: absolute;
        emit: step(rk4, semi_implicit_euler, linearly_implicit);
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 5 rad/s, locked; }
        body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; }
        body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.4, 0) m; port p: (-0.4, 0) m; start angle: 100 deg; }
        revolute o(ground.o, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
        revolute p(ground.p, rocker.p) { stiffness: 2 N*m/rad; }
    }
}

plm::mechanism! {
    /// Its crank is at its dead points at 78 deg.
    TripleRocker {
        emit: step(rk4);
        ground { port o: (0, 0) m; port p: (0.8, 0) m; }
        body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 40 deg, locked; start omega: 3 rad/s, locked; }
        body coupler { mass: 1 kg; inertia: 0.02 kg*m^2; port b: (-0.2, 0) m; port c: (0.2, 0) m; }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0.45, 0) m; port p: (-0.45, 0) m; start angle: 120 deg; }
        revolute o(ground.o, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute p(ground.p, rocker.p);
    }
}

plm::mechanism! {
    /// A mass between a spring and a stop, on a stiff lag; a relay, a requirement, and a switch by the time.
    Bench {
        emit: step(rk4, linearly_implicit);
        param bound: m = 1 m;
        ground { port o: (0, 0) m; }
        body mass { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; start x: 0.3 m; start vx: 0.5 m/s; }
        prismatic rail(mass.a, ground.o) { stiffness: 40 N/m; }
        force push(mass.a) { x: pressure - (if mass.x > 0.1 m then 3 N else 0 N) + (if t > 0.55 s then 2 N else 0 N); }
        state pressure: N = -10 N;
        rate pressure = (-20 N*s/m*mass.vx - pressure)/1e-5 s;
        require within: mass.x < bound;
    }
}

plm::mechanism! {
    /// Half a million radians in half a step: no straight line is made for that.
    Spun {
        gravity: 9.81 m/s^2;
        emit: step(rk4);
        ground { port o: (0, 0) m; }
        body wheel { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-0.1, 0) m; start omega: 1e9 rad/s, locked; start angle: 0 deg, locked; }
        revolute axle(ground.o, wheel.o);
    }
}

plm::mechanism! {
    /// The same beside another wheel, so that angles are looked at in each stage.
    SpunTwo {
        gravity: 9.81 m/s^2;
        emit: step(rk4);
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body slow { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-0.1, 0) m; start omega: 1 rad/s, locked; start angle: 0 deg, locked; }
        body fast { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (-0.1, 0) m; start omega: 1e9 rad/s, locked; start angle: 0 deg, locked; }
        revolute axle(ground.o, slow.o);
        revolute other(ground.p, fast.p);
    }
}

/// The states of a run after `count` intervals of `h`.
fn run<M: Mechanism<S = f64>>(method: impl Method<M>, mechanism: M, h: f64, count: usize) -> M::X {
    let mut sim = mechanism.start_with(method).unwrap();
    for _ in 0..count {
        sim.step(h).unwrap();
    }
    *sim.state().x()
}

/// The states after as many steps by themselves.
fn alone<M: Mechanism<S = f64>>(
    mechanism: M,
    count: usize,
    mut step: impl FnMut(&mut M::State) -> Result<(), Fault>,
) -> Result<M::X, Fault> {
    let mut state = *mechanism.start_with(Rk4::new(1e-3))?.state();
    for _ in 0..count {
        step(&mut state)?;
    }
    Ok(*state.x())
}

fn bits<X: Vector<f64>>(x: &X) -> Vec<u64> {
    (0..X::LEN).map(|i| x.at(i).to_bits()).collect()
}

fn gap<X: Vector<f64>>(a: &X, b: &X) -> f64 {
    (0..X::LEN).fold(0.0, |gap, i| (a.at(i) - b.at(i)).abs().max(gap))
}

/// The formulas are those of the runtime's methods, operation by operation; what looks at a step changes nothing here.
#[test]
fn explicit_steps_have_the_bits_of_a_run() {
    let h = 1.0 / 1024.0;
    macro_rules! same {
        ($mechanism:ident, $count:literal) => {
            let run_by_rk4 = run(Rk4::new(h), $mechanism::new(), h, $count);
            let by_rk4 = alone($mechanism::new(), $count, |state| state.step_rk4(h)).unwrap();
            assert_eq!(bits(&run_by_rk4), bits(&by_rk4), stringify!($mechanism));
            let run_by_euler = run(SemiImplicitEuler::new(h), $mechanism::new(), h, $count);
            let by_euler =
                alone($mechanism::new(), $count, |state| state.step_semi_implicit_euler(h)).unwrap();
            assert_eq!(bits(&run_by_euler), bits(&by_euler), stringify!($mechanism));
        };
    }
    same!(Pendulum, 3000);
    // Charts change on the way; the times are multiples of 2^-10, so that they are exact in both.
    same!(FourBar, 3000);
    // A run looks at the drift every eighth step.
    same!(Absolute, 8);
}

/// Where a step is no straight line, in another chart and with angles of many turns, it is the formula all the same.
#[test]
fn steps_that_leave_the_straight_line_have_the_bits_of_a_run() {
    let h = 1.0 / 1024.0;
    for count in [1, 2, 100] {
        let by_run = run(Rk4::new(h), Spun::new(), h, count);
        let by_step = alone(Spun::new(), count, |state| state.step_rk4(h)).unwrap();
        assert_eq!(bits(&by_run), bits(&by_step), "{count} steps of a wheel");
        let by_run = run(Rk4::new(h), SpunTwo::new(), h, count);
        let by_step = alone(SpunTwo::new(), count, |state| state.step_rk4(h)).unwrap();
        assert_eq!(bits(&by_run), bits(&by_step), "{count} steps of two wheels");
    }
    // The crank comes to a dead point, so that the chart changes, and comes back.
    // A run divides steps that are long beside the turn there; these are not.
    let h = h / 8.0;
    let mut charts = [0; 2];
    let mut sim = TripleRocker::new().start_with(Rk4::new(h)).unwrap();
    let mut state = *sim.state();
    for count in 0..24_000 {
        sim.step(h).unwrap();
        state.step_rk4(h).unwrap();
        assert_eq!(bits(sim.state().x()), bits(state.x()), "step {count} of a triple rocker");
        let chart = state.of_loops.chart().unwrap();
        charts[usize::from(chart > 0)] += 1;
    }
    assert!(charts.iter().all(|steps| *steps > 100), "{charts:?}");
}

/// An interval that is one step is made without ado; a run that is watched makes all steps one way.
#[test]
fn intervals_of_one_step_have_the_bits_and_the_counts_of_a_run() {
    macro_rules! same {
        ($mechanism:expr, $h:expr, $count:literal) => {
            let mut alone = $mechanism.start_with(Rk4::new($h)).unwrap();
            let mut watched = $mechanism.start_with(Rk4::new($h)).unwrap();
            let made = (1..=$count).try_for_each(|k| alone.step_to(f64::from(k) * $h));
            let seen = Sim::watch(&mut watched, f64::from($count) * $h, $h, |_| ());
            let what = stringify!($mechanism);
            assert_eq!(made, seen, "{what}");
            assert_eq!(alone.state().time().to_bits(), watched.state().time().to_bits(), "{what}");
            assert_eq!(bits(alone.state().x()), bits(watched.state().x()), "{what}");
            assert_eq!(alone.stats(), watched.stats(), "{what}");
            assert_eq!(alone.state().held(), watched.state().held(), "{what}");
        };
    }
    same!(Pendulum::new(), 1e-3, 6000);
    same!(FourBar::new(), 1e-3, 6000);
    same!(Absolute::new(), 1e-3, 2000);
    same!(TripleRocker::new(), 1e-3, 4000);
    // A relay that switches every half second, a switch by the time, and a requirement that ends the run.
    same!(Bench::new(), 5e-6, 200_000);
    same!(Bench { bound: 0.304, ..Bench::new() }, 5e-6, 200_000);
}

#[test]
fn linearly_implicit_steps_are_those_of_a_run() {
    let h = 1.0 / 1024.0;
    macro_rules! same {
        ($mechanism:ident, $count:literal, $bound:literal) => {
            let expected = run(Ros34Pw2::new(h), $mechanism::new(), h, $count);
            let found = alone($mechanism::new(), $count, |state| state.step_linearly_implicit(h)).unwrap();
            let gap = gap(&expected, &found);
            assert!(gap < $bound, "{}: {gap:e}", stringify!($mechanism));
        };
    }
    same!(Pendulum, 1000, 1e-10);
    same!(FourBar, 1000, 1e-10);
    same!(Absolute, 1000, 1e-10);
    same!(Bench, 500, 1e-11);
}

/// Of order 3, and stable where an explicit step of that length is not.
#[test]
fn linearly_implicit_steps_converge_where_explicit_ones_explode() {
    let known = run(Dop853::new(1e-12), FourBar::new(), 0.5, 1);
    let [coarse, fine] = [128, 256].map(|count| {
        let h = 0.5 / f64::from(count);
        let found = alone(FourBar::new(), count as usize, |state| state.step_linearly_implicit(h)).unwrap();
        gap(&known, &found)
    });
    assert!((5.0..12.0).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
    let explicit = alone(Bench::new(), 1000, |state| state.step_rk4(1e-3));
    assert!(explicit.is_err(), "{explicit:?}");
    let implicit = alone(Bench::new(), 1000, |state| state.step_linearly_implicit(1e-3));
    assert!(implicit.is_ok(), "{implicit:?}");
}

/// What changes within a step acts from its end: against a run that finds the moments, of first order.
#[test]
fn conditions_switch_at_the_ends_of_steps() {
    let known = run(plm::RadauIia5::new(1e-10), Bench::new(), 1.0, 1);
    // A step may end where something changes: the worst of some counts says what a step is worth.
    let [coarse, fine] = [1, 16].map(|finer| {
        let counts = [2_000, 2_090, 2_310, 2_730].map(|count| count * finer);
        counts.into_iter().fold(0.0_f64, |worst, count| {
            let h = 1.0 / f64::from(count);
            let found = alone(Bench::new(), count as usize, |state| state.step_linearly_implicit(h)).unwrap();
            worst.max(gap(&known, &found))
        })
    });
    assert!(fine < 0.25 * coarse && coarse < 2e-2, "{coarse:e} {fine:e}");
}

#[test]
fn a_step_that_cannot_be_made_says_why_and_leaves_the_state() {
    let mut mechanism = Bench::new();
    mechanism.bound = 0.304;
    let fault = alone(mechanism, 1000, |state| state.step_linearly_implicit(1e-3)).unwrap_err();
    assert_eq!((fault.part, fault.cause), ("within", Cause::Required));

    let mut state = *Pendulum::new().start().unwrap().state();
    for h in [0.0, -1.0, f64::NAN] {
        let before = bits(Moment::x(&state));
        assert!(matches!(state.step_rk4(h).unwrap_err().cause, Cause::StepTooSmall { .. }));
        assert_eq!(bits(Moment::x(&state)), before);
    }
    assert!(state.step_linearly_implicit(50.0).is_err());
    assert_eq!(state.time(), 0.0);
}

/// A loop near its dead points goes on in another chart, as in a run, which divides the longest steps there.
#[test]
fn a_loop_changes_its_chart_between_steps() {
    let mut sim: Sim<TripleRocker, Rk4<f64>> = TripleRocker::new().start_with(Rk4::new(1e-3)).unwrap();
    let mut state = *sim.state();
    let mut worst = 0.0_f64;
    for _ in 0..4000 {
        sim.step(1e-3).unwrap();
        state.step_rk4(1e-3).unwrap();
        let [one, other] = [sim.state().rocker(), state.rocker()];
        worst = worst.max((one.angle - other.angle).abs());
    }
    assert!(sim.stats().charts > 0, "{:?}", sim.stats());
    assert!(worst < 1e-4, "{worst:e}");
    assert!(state.mechanism.is_regular(&state.held()));
}

/// Steps of a mechanism from text by themselves have the bits of those that code was made for: in the first chart and in others, over whole
/// revolutions, and where conditions of the state and of the time change.
#[test]
fn steps_from_text_have_the_bits_of_code() {
    macro_rules! same {
        ($mechanism:ident, $h:expr, $count:expr) => {{
            let text =
                plm::dynamic::Mechanism::from_text(<$mechanism as plm::Described>::DECLARATION).unwrap();
            let (mut steps, mut state) = (text.steps().unwrap(), *$mechanism::new().start().unwrap().state());
            for k in 0..$count {
                let (own, text) = (state.step_rk4($h), steps.step($h));
                assert_eq!(own, text, "{} {k}", stringify!($mechanism));
                let of_text: Vec<u64> = steps.numbers().x.iter().map(|number| number.to_bits()).collect();
                assert_eq!(bits(Moment::x(&state)), of_text, "{} {k}", stringify!($mechanism));
                assert_eq!(state.time().to_bits(), steps.numbers().time.to_bits());
            }
        }};
    }
    same!(Pendulum, 1e-3, 2000);
    same!(FourBar, 1e-3, 2000);
    same!(TripleRocker, 1e-3, 4000);
    same!(Absolute, 1e-3, 1000);
    same!(Bench, 1e-6, 4000);
    same!(Spun, 1e-3, 10);
    same!(SpunTwo, 1e-3, 10);
}
