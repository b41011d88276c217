//! The method of co-simulation: the numbers are those of `Sim` with it, or of the steps that a declaration has emitted.
#![cfg(feature = "fmi")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use plm::runtime::Mechanism;
use plm::{Method, Moment, RadauIia5, Rk4, Ros34Pw2, SemiImplicitEuler, Sim};
use plm_foreign::fmi::{Call, Choice, Emitted as _, Instance, Interface, Steps, Variable};

plm::mechanism! {
    /// An arm whose hinge is driven through a lag, with steps of its own, and a stop that pushes at once.
    Arm {
        gravity: 9.81 m/s^2;
        emit: step(rk4, linearly_implicit);
        input wanted: N*m = 3 N*m;
        param mass: kg = 2 kg;
        ground { port o: (0, 0) m; }
        body link { mass: mass; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; start angle: -90 deg; }
        revolute hinge(ground.o, link.o) { drive: torque; damping: 0.5 N*m*s/rad; }
        state torque: N*m = 0;
        rate torque = (wanted - torque)/0.05 s;
        force stop(link.o) { torque: if link.angle > -1.3 rad then -5 N*m else 0 N*m; }
        output link.angle, link.omega, torque;
    }
}

type State = <Arm as Mechanism>::State;
type Run = Instance<Arm>;
const CO_SIMULATION: Interface = Interface::CoSimulation { has_events: false };

fn steps() -> Steps<Arm> {
    Steps::new(State::step_rk4, State::step_semi_implicit_euler, State::step_linearly_implicit)
}

/// An instance that runs by a method, with its step and tolerance.
fn started(choice: Choice, step: f64, tolerance: f64) -> Run {
    let mut run = Instance::with_steps(Arm::new(), steps(), CO_SIMULATION);
    run.set_method(choice.number()).unwrap();
    run.set(Variable::Step, step).unwrap();
    run.begin_at(0.0, Some(tolerance)).unwrap();
    run.pass(Call::EnterInitializationMode);
    run.renew().unwrap();
    run.pass(Call::ExitInitializationMode);
    run
}

/// Communication steps of 10 ms; an input and a parameter change.
const STEPS: u32 = 100;

fn changed(k: u32) -> (f64, f64) {
    (if k < 30 { 3.0 } else { -4.0 }, if k < 60 { 2.0 } else { 2.5 })
}

fn bits(state: &State) -> Vec<u64> {
    state.x().iter().map(|number| number.to_bits()).collect()
}

/// What an instance does, beside what `next` does with a state and the end of a communication step.
fn same(mut run: Run, mut next: impl FnMut(&mut State, f64)) {
    let mut state = *Arm::new().start().unwrap().state();
    for k in 0..STEPS {
        let ((wanted, mass), end) = (changed(k), f64::from(k + 1) * 0.01);
        run.set(Variable::Input(0), wanted).unwrap();
        run.set(Variable::Parameter(0), mass).unwrap();
        state.input.wanted = wanted;
        state.mechanism.mass = mass;
        run.step_to(end, false).unwrap();
        next(&mut state, end);
        assert_eq!(bits(run.state().unwrap()), bits(&state), "{:?}, step {k}", run.method());
        assert_eq!(run.get(Variable::Time).unwrap(), end);
    }
}

/// By a method that begins with every communication step.
fn by<I: Method<Arm>>(method: I) -> impl FnMut(&mut State, f64) {
    move |state, end| {
        let mut sim = Sim::new(*state, method.fresh());
        sim.step_to(end).unwrap();
        *state = *sim.state();
    }
}

#[test]
fn methods_have_the_bits_of_sim() {
    same(started(Choice::Rk4, 3e-3, 1e-6), by(Rk4::new(3e-3)));
    same(started(Choice::SemiImplicitEuler, 1e-3, 1e-6), by(SemiImplicitEuler::new(1e-3)));
    same(started(Choice::Ros34Pw2, 5e-3, 1e-6), by(Ros34Pw2::new(5e-3)));
    same(started(Choice::RadauIia5, 1.0, 1e-6), by(RadauIia5::new(1e-6)));
    // The one by default remembers what it knows of a step.
    let mut sim = Arm::new().start_with(plm::Dop853::new(1e-6)).unwrap();
    same(started(Choice::Dop853, 1.0, 1e-6), |state, end| {
        (sim.input.wanted, sim.mechanism.mass) = (state.input.wanted, state.mechanism.mass);
        sim.step_to(end).unwrap();
        *state = *sim.state();
    });
}

#[test]
fn emitted_steps_are_those_of_the_state() {
    let by = |step: fn(&mut State, f64) -> Result<(), plm::Fault>| {
        move |state: &mut State, end: f64| {
            // Four steps of 2.5 ms, of at most 3 ms.
            let start = state.time();
            for k in 1..=4 {
                let end = if k < 4 { start + (end - start) * (f64::from(k) / 4.0) } else { end };
                step(state, end - state.time()).unwrap();
            }
            let (held, x) = (state.held(), *state.x());
            state.set(end, &held, &x);
        }
    };
    same(started(Choice::StepRk4, 3e-3, 1e-6), by(State::step_rk4));
    same(started(Choice::StepLinearlyImplicit, 3e-3, 1e-6), by(State::step_linearly_implicit));
}

/// Half the step of a method of order 4 leaves about a sixteenth; where nothing jumps.
#[test]
fn a_step_bounds_the_error_of_its_method() {
    let angle = |mut run: Run| {
        run.step_to(0.2, false).unwrap();
        run.get(Variable::Output(0)).unwrap()
    };
    let exact = angle(started(Choice::Dop853, 1.0, 1e-13));
    let errors = [0.02, 0.01].map(|step| (angle(started(Choice::Rk4, step, 1e-6)) - exact).abs());
    assert!(errors[0] < 1e-5 && errors[0] / errors[1] > 10.0, "{errors:?}");
    let errors = [1e-3, 1e-9].map(|rtol| (angle(started(Choice::Dop853, 1.0, rtol)) - exact).abs());
    assert!(errors[0] > 1e-9 && errors[1] < 1e-11, "{errors:?}");
}

/// A saved run has its method, and goes on with the same bits.
#[test]
fn a_saved_run_keeps_its_method() {
    let mut run = started(Choice::StepRk4, 3e-3, 1e-6);
    run.step_to(0.5, false).unwrap();
    let mut bytes = vec![0; run.saved_size()];
    run.save(&mut bytes).unwrap();
    let fresh = Instance::with_steps(Arm::new(), steps(), CO_SIMULATION);
    let mut other = fresh.saved(&bytes).unwrap();
    for run in [&mut run, &mut other] {
        run.step_to(0.7, false).unwrap();
    }
    assert_eq!(other.method(), Choice::StepRk4);
    assert_eq!(bits(other.state().unwrap()), bits(run.state().unwrap()));
}

#[test]
fn what_cannot_be_is_refused() {
    let mut run = Instance::with_steps(Arm::new(), steps(), CO_SIMULATION);
    let number = Choice::StepSemiImplicitEuler.number();
    let said = run.set_method(number).unwrap_err().to_string();
    assert!(said.contains("emit: step(semi_implicit_euler), which the declaration does not have"), "{said}");
    for number in [0, 9, -1, i64::MIN] {
        assert!(run.set_method(number).unwrap_err().to_string().contains("from 1 to 8"));
    }
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(run.set(Variable::Step, step).is_err(), "{step}");
    }
    for tolerance in [0.0, -1.0, f64::NAN, 0.2] {
        assert!(run.begin_at(0.0, Some(tolerance)).is_err(), "{tolerance}");
    }
    assert_eq!(run.method(), Choice::Dop853);
    assert!(run.set(Variable::Method, 3.0).is_err() && run.get(Variable::Method).is_err());
    let mut run = started(Choice::Rk4, 1e-3, 1e-6);
    assert!(run.set_method(1).unwrap_err().to_string().contains("once the mechanism has started"));
    assert!(run.set(Variable::Step, 1e-2).is_err());
    for until in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(run.step_to(until, false).is_err(), "{until}");
    }
    assert!(!run.step_to(0.0, false).unwrap());
}
