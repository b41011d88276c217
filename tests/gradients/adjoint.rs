//! Gradients backward along runs, against closed forms and derivatives forward.

use plm::adjoint::{self, Carried, Lack, Memory, NoGradient};
use plm::runtime::Seen;
use plm::{
    By, Cause, Dop853, Dual, Fault, Mechanism as _, Moment, Reached, Sim, Term, Trace, Traced, mechanism,
    with_derivatives, with_trace,
};

use super::closed::Pendulum;
use super::events::{Thrown, Yard, bounced, stuck};
use super::loops::{FourBar, rocker};
use super::{are_slopes, body};
use crate::scene::Given as _;

/// Values and gradients of results of a run, with memory for so many saved states; a row of each result.
pub(super) fn gradient<'t, P: Copy, const R: usize>(
    trace: &'t Trace<'t>,
    saved: usize,
    start: P,
    advance: impl Fn(&mut P) -> Result<Reached, Fault>,
    results: impl Fn(&P) -> [Traced<'t>; R],
) -> Result<([f64; R], [Vec<f64>; R]), NoGradient> {
    let mut adjoints = vec![[0.0; R]; trace.room()];
    let mut carried = vec![Carried::EMPTY; adjoint::carried::<P, f64>()];
    let mut saved = vec![None; saved];
    let memory = Memory { adjoints: &mut adjoints, carried: &mut carried, saved: &mut saved };
    let mut gradient = vec![[0.0; R]; trace.variables()];
    let values = adjoint::adjoint(trace, start, advance, results, memory, &mut gradient)?;
    Ok((values, core::array::from_fn(|k| gradient.iter().map(|by| by[k]).collect())))
}

fn array<const K: usize>(row: &[f64]) -> [f64; K] {
    row.try_into().unwrap()
}

#[test]
fn of_a_pendulum_after_three_seconds() {
    let by = [By::Parameter("length"), By::Parameter("g")];
    // All of the run at once; in segments whose beginnings are saved; in blocks of segments.
    for (room, saved) in [(2_000_000, 1), (30_000, 500), (30_000, 20)] {
        let mut terms = vec![Term::EMPTY; room];
        let trace = Trace::new(&mut terms, 2);
        let sim =
            with_trace(&Pendulum::new(), &by, &trace).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
        let advance = |sim: &mut _| Sim::step_towards(sim, 3.0.into());
        let ([_, omega], [by_angle, _]) =
            gradient(&trace, saved, sim, advance, |sim| [sim.bob().angle, sim.bob().omega]).unwrap();
        assert!((by_angle[0] + 3.0 * omega / 2.0).abs() < 1e-9, "{by_angle:?}");
        assert!((by_angle[1] - 3.0 * omega / (2.0 * 9.81)).abs() < 1e-10, "{by_angle:?}");
        // Forward the same, to rounding.
        let mut dual =
            with_derivatives(&Pendulum::new(), by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
        dual.step_to(3.0.into()).unwrap();
        assert_eq!(dual.bob().omega.value, omega);
        for (forward, backward) in dual.bob().angle.tangents.into_iter().zip(by_angle) {
            assert!((forward - backward).abs() < 1e-11 * forward.abs(), "{forward} {backward}");
        }
    }
}

#[test]
fn of_a_ball_by_height_restitution_and_gravity() {
    let by = [By::Parameter("height"), By::Parameter("e"), By::Parameter("g")];
    let mut terms = vec![Term::EMPTY; 100_000];
    let trace = Trace::new(&mut terms, 3);
    let sim = with_trace(&Yard::new(), &by, &trace).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    for t in [0.3, 0.6, 1.2, 1.27] {
        let ([y], [found]) =
            gradient(&trace, 100, sim, |sim| Sim::step_towards(sim, t.into()), |sim| [sim.ball().y]).unwrap();
        assert!((y - bounced([1.0, 0.5, 9.81], t)).abs() < 1e-12);
        are_slopes(array(&found), |p| bounced(p, t), [1.0, 0.5, 9.81], 2e-10);
    }
}

#[test]
fn of_stick_and_slip_by_each_coefficient() {
    let by = [By::Parameter("kinetic"), By::Parameter("adhesion"), By::Parameter("belt")];
    let mut terms = vec![Term::EMPTY; 100_000];
    let trace = Trace::new(&mut terms, 3);
    let sim = with_trace(&Yard::new(), &by, &trace).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    let (_, [found]) =
        gradient(&trace, 100, sim, |sim| Sim::step_towards(sim, 2.3.into()), |sim| [sim.mass().x]).unwrap();
    are_slopes(array(&found), |p| stuck(p, 2.3, 3), [2.4525, 3.924, 0.1], 1e-9);
}

/// Where no step is made, the results are those of assembly.
#[test]
fn of_a_rocker_by_all_lengths_and_the_crank() {
    let by = [
        By::Parameter("base"),
        By::Parameter("short"),
        By::Parameter("long"),
        By::Parameter("swing"),
        By::Start("crank.angle"),
    ];
    let mut terms = vec![Term::EMPTY; 100_000];
    let trace = Trace::new(&mut terms, 5);
    let sim = with_trace(&FourBar::new(), &by, &trace).unwrap().start().unwrap();
    let ([angle], [found]) =
        gradient(&trace, 1, sim, |_| Ok(Reached::End), |sim| [sim.rocker().angle]).unwrap();
    let at = [0.4, 0.1, 0.35, 0.25, 0.7];
    assert!((angle - rocker(at)).abs() < 1e-12);
    are_slopes(array(&found), rocker, at, 1e-9);
}

/// x = v t comes to the place where it is thrown back at t = turns/v.
#[test]
fn of_the_time_of_an_event() {
    let thrown = Thrown::new().with("other", 5.0);
    let mut terms = vec![Term::EMPTY; 100_000];
    let trace = Trace::new(&mut terms, 2);
    let own = with_trace(&thrown, &[By::Parameter("turns"), By::Start("a.vx")], &trace).unwrap();
    let sim = own.start_with(Dop853::new(1e-12.into())).unwrap();
    let ([time], [found]) = gradient(
        &trace,
        20,
        (sim, Traced::constant(0.0)),
        |(sim, time)| {
            Sim::watch_towards(sim, 0.6.into(), |seen| {
                if let Seen::Switched(state) = seen {
                    *time = Moment::time(state);
                }
            })
        },
        |(_, time)| [*time],
    )
    .unwrap();
    assert!((time - 0.5).abs() < 1e-13);
    are_slopes(array(&found), |[turns, v]| turns / v, [1.0, 2.0], 1e-11);
}

/// Both are thrown at 0.5 s.
#[test]
fn of_two_events_at_once_there_are_none() {
    let mut terms = vec![Term::EMPTY; 100_000];
    let trace = Trace::new(&mut terms, 1);
    let own = with_trace(&Thrown::new(), &[By::Parameter("turns")], &trace).unwrap();
    let sim = own.start_with(Dop853::new(1e-12.into())).unwrap();
    let outcome =
        gradient(&trace, 20, sim, |sim| Sim::step_towards(sim, 0.9.into()), |sim| [body(sim.state(), "a").x]);
    let NoGradient::Fault(fault) = outcome.unwrap_err() else { panic!("it has memory") };
    assert!(matches!(fault.cause, Cause::AtOnce { .. }), "{fault}");
}

mechanism! {
    /// A cart that is pushed from outside, and the sum of its way over time.
    pub Cart {
        param mass: kg = 2 kg;
        param drag: N*s/m = 0.5 N*s/m;
        input push: N = 0 N;
        ground { port o: (0, 0) m; }
        body cart { mass: mass; inertia: 1 kg*m^2; port o: (0, 0) m; start vx: 1 m/s, locked; }
        prismatic rail(ground.o, cart.o);
        force drive(cart.o) { x: push - drag*cart.vx; }
        state way: m*s = 0;
        rate way = cart.x;
        output way;
    }
}

/// A step of the control grid, s, and the pushes in its intervals, N.
pub const EVERY: f64 = 0.4;
pub const PUSHES: [f64; 5] = [3.0, -1.0, 2.0, 0.5, -4.0];

/// Place of the cart after all intervals, and the integral of the place: v = u/c + (v0 - u/c) exp(-c t/m) in each.
pub fn carted([mass, drag, speed, pushes @ ..]: [f64; 8]) -> [f64; 2] {
    let (mut x, mut v, mut way) = (0.0, speed, 0.0);
    let (t, k) = (EVERY, mass / drag);
    let decay = (-t / k).exp();
    for push in pushes {
        let (last, rest) = (push / drag, v - push / drag);
        way += x * t + last * t * t / 2.0 + rest * k * (t - k * (1.0 - decay));
        x += last * t + rest * k * (1.0 - decay);
        v = last + rest * decay;
    }
    [x, way]
}

/// An integral, by parameters, a start and the inputs of a control grid, one after the other with the same memory.
#[test]
fn of_an_integral_by_a_control_grid() {
    let by = [By::Parameter("mass"), By::Parameter("drag"), By::Start("cart.vx")];
    let mut terms = vec![Term::EMPTY; 8_000];
    let trace = Trace::new(&mut terms, 8);
    let sim = with_trace(&Cart::new(), &by, &trace).unwrap().start_with(Dop853::new(1e-13.into())).unwrap();
    let pushes: [Traced<'_>; 5] = core::array::from_fn(|k| trace.variable(PUSHES[k], 3 + k));
    let ([x, way], [by_x, by_way]) = gradient(
        &trace,
        8,
        (sim, 0),
        |(sim, interval)| {
            sim.input.push = pushes[*interval];
            *interval += 1;
            sim.step(EVERY.into())?;
            Ok(if *interval < pushes.len() { Reached::Step } else { Reached::End })
        },
        |(sim, _)| [sim.cart().x, sim.way()],
    )
    .unwrap();
    let [a, b, c, d, e] = PUSHES;
    let at = [2.0, 0.5, 1.0, a, b, c, d, e];
    assert!((x - carted(at)[0]).abs() < 1e-12 && (way - carted(at)[1]).abs() < 1e-12);
    are_slopes(array(&by_x), |p| carted(p)[0], at, 1e-10);
    are_slopes(array(&by_way), |p| carted(p)[1], at, 1e-10);
}

/// The error says what memory suffices.
#[test]
fn with_too_little_memory() {
    let by = [By::Parameter("length")];
    let run = |room, saved| {
        let mut terms = vec![Term::EMPTY; room];
        let trace = Trace::new(&mut terms, 1);
        let sim =
            with_trace(&Pendulum::new(), &by, &trace).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
        gradient(&trace, saved, sim, |sim| Sim::step_towards(sim, 3.0.into()), |sim| [sim.bob().angle])
            .map(|(_, [found])| found[0])
    };
    let lack = |outcome: Result<f64, NoGradient>| match outcome {
        Err(NoGradient::Short(lack)) => lack,
        other => panic!("{other:?}"),
    };
    let Lack { terms, .. } = lack(run(10, 1000));
    assert!(run(terms - 1, 1000).is_err());
    let all = run(terms, 1000).unwrap();
    let Lack { saved, .. } = lack(run(terms, 1));
    assert!(run(terms, saved - 1).is_err());
    assert_eq!(run(terms, saved).unwrap(), all);
}

/// Second derivatives: duals over the adjoint. angle(t) = f(t sqrt(g/l)), so that d2/dl dg = d(-t w/(2 l))/dg.
#[test]
fn of_a_gradient() {
    let mut terms = vec![Term::EMPTY; 200_000];
    let trace: Trace<'_, Dual<f64, 1>> = Trace::new(&mut terms, 1);
    let t = 1.0;
    let by_g = with_derivatives(&Pendulum::new(), [By::Parameter("g")]).unwrap();
    let own = with_trace(&by_g, &[By::Parameter("length")], &trace).unwrap();
    let sim = own.start_with(Dop853::new(Dual::constant(1e-12).into())).unwrap();
    let (mut adjoints, mut saved) = (vec![[Dual::constant(0.0)]; trace.room()], vec![None; 40]);
    let mut carried = vec![Carried::EMPTY; 4000];
    let memory = Memory { adjoints: &mut adjoints, carried: &mut carried, saved: &mut saved };
    let mut by_length = [[Dual::constant(0.0)]];
    let end = Dual::constant(t).into();
    adjoint::adjoint(
        &trace,
        sim,
        |sim| Sim::step_towards(sim, end),
        |sim| [sim.bob().angle],
        memory,
        &mut by_length,
    )
    .unwrap();
    let omega = |g: f64| {
        let pendulum = Pendulum { g, ..Pendulum::new() };
        let mut sim = pendulum.start_with(Dop853::new(1e-13)).unwrap();
        sim.step_to(t).unwrap();
        sim.bob().omega
    };
    let [[Dual { value, tangents: [second] }]] = by_length;
    assert!((value + t * omega(9.81) / 2.0).abs() < 1e-9);
    are_slopes([second], |[g]| -t * omega(g) / 2.0, [9.81], 1e-9);
}
