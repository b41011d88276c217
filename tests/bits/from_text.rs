//! The bits of compiled code: the eight mechanisms of `tests/snapshots`, from their declarations and as they are emitted; from the
//! declarations both step by step and as machine code.

use std::fmt::Debug;

use plm::dynamic::{Compiled, Dynamic, Small};
use plm::runtime::described::by_number;
use plm::runtime::{Described, Linear, Mechanism, Ports, Statics};
use plm::{
    Adams, Dop853, Linearisable, Method, RadauIia5, Rk4, Ros34Pw2, Sim, Stabilise, linearise, stabilise,
};

use crate::emitted::{
    arm_on_jack, bouncer, chain, double_pendulum, driven_crank, four_bar, plate_on_three_pins, slider_crank,
};

/// A mechanism from the declaration of another one: evaluated step by step, and by machine code from the first evaluation on.
pub(crate) fn from_text<
    M: Described<S = f64>,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
>(
    _: &M,
) -> Vec<Dynamic<f64, NQ, NC, N, L>> {
    let text = || -> Dynamic<f64, NQ, NC, N, L> {
        Compiled::new("mechanism.plm", M::DECLARATION).unwrap().mechanism().unwrap()
    };
    vec![
        text(),
        #[cfg(feature = "jit")]
        {
            let text = text();
            text.translate_by(std::sync::Arc::new(plm::jit::Host::new().unwrap().after(0)));
            text
        },
    ]
}

/// That of a mechanism of at most 8 bodies.
fn small<M: Described<S = f64>>(mechanism: &M) -> Vec<Small> {
    from_text(mechanism)
}

/// Everything that is compared at a moment: poses and velocities, declared outputs.
fn of_compiled<M: Described<S = f64>>(state: &M::State) -> Vec<u64> {
    let mut all = Vec::new();
    M::poses(state, &mut |body| all.extend(body.components()));
    (0..M::OBSERVED.len()).for_each(|k| all.extend(M::observed(state, k)));
    all.into_iter().map(f64::to_bits).collect()
}

fn of_dynamic(state: &<Small as Mechanism>::State) -> Vec<u64> {
    let mut all = Vec::new();
    (0..).map_while(|k| state.body(k)).for_each(|body| all.extend(body.components()));
    (0..).map_while(|k| state.output(k)).for_each(|output| all.push(output));
    all.into_iter().map(f64::to_bits).collect()
}

fn compared<M: Described<S = f64>, I: Method<M>, J: Method<Small>>(
    (mut compiled, mut dynamic): (Sim<M, I>, Sim<Small, J>),
    (times, by): (u32, f64),
) {
    for k in 0..=times {
        let at = f64::from(k) * by;
        assert_eq!(of_compiled::<M>(compiled.state()), of_dynamic(dynamic.state()), "at {at}");
        let ends = (
            compiled.step(by).map_err(|fault| fault.to_string()),
            dynamic.step(by).map_err(|fault| fault.to_string()),
        );
        assert_eq!(ends.0, ends.1, "after {at}");
        if ends.0.is_err() {
            return;
        }
    }
    let [own, other] = [compiled.stats(), dynamic.stats()];
    assert_eq!((own.steps, own.rejected, own.evaluations), (other.steps, other.rejected, other.evaluations));
}

/// Compares names, units, drawings and the numbers of a moment, as recordings and pages have them.
fn same_description<M: Described<S = f64> + Statics>(mechanism: M, dynamic: &Small) {
    assert_eq!(M::TABLES, dynamic.tables());
    assert_eq!((M::SHAPES, M::HOLES), (dynamic.shapes(), dynamic.holes()));
    assert_eq!((M::OBSERVED, M::DECLARATION), (dynamic.observables(), dynamic.declaration()));
    assert_eq!((M::INPUTS, M::OUTPUTS), (dynamic.input_names(), dynamic.output_names()));
    assert_eq!((M::COORDINATES, M::ROWS), (dynamic.coordinate_names(), dynamic.row_names()));
    assert_eq!(M::STATES, dynamic.state_names());
    let figures = |figure: &dyn Fn(f64, usize) -> Option<f64>| {
        let all = [0.0, 0.3].map(|t| (0..).map_while(|k| figure(t, k)).map(f64::to_bits).collect::<Vec<_>>());
        assert!(!all[0].is_empty());
        all
    };
    assert_eq!(figures(&|t, k| mechanism.figure(t, k)), figures(&|t, k| dynamic.figure(t, k)));
    assert_eq!(shape(&mechanism), shape(dynamic));
    assert_eq!(moment(mechanism), moment(*dynamic));
}

fn shape<M: Described<S = f64>>(of: &M) -> Vec<u64> {
    let mut all = Vec::new();
    by_number::shape(of, &mut |number| all.push(number.to_bits()));
    all
}

fn moment<M: Described<S = f64>>(of: M) -> Vec<u64> {
    let (sim, mut all) = (of.start().unwrap(), Vec::new());
    by_number::moment::<M>(sim.state(), &mut |number| all.push(number.to_bits()));
    M::outputs(sim.state(), &mut |number| all.push(number.to_bits()));
    all
}

/// Static equilibria, and the linear systems around them and around the start.
fn same_analysis<M: Stabilise + Described + Linearisable>(mechanism: M) {
    let own = analysed(mechanism);
    for dynamic in small(&mechanism) {
        assert_eq!(own, analysed(dynamic));
    }
}

/// Equilibria and linear systems as text, which has every bit of every number.
fn analysed<M: Stabilise + Described + Linearisable>(of: M) -> Vec<String> {
    let sim = of.start().unwrap();
    let text = |all: &dyn Debug| format!("{all:?}");
    let mut all = vec![text(&linearise(&sim))];
    for found in [of.stabilise(), stabilise(&sim)] {
        let found = found.unwrap();
        all.push(text(&(&found.residuals, &found.free, &found.values, found.iterations, found.size)));
        all.push(text(&found.start().and_then(|sim| linearise(&sim))));
    }
    all
}

fn same_bits<M: Described<S = f64> + Statics>(mechanism: M) {
    for dynamic in small(&mechanism) {
        same_description(mechanism, &dynamic);
        let by_steps =
            (mechanism.start_with(Rk4::new(1e-3)).unwrap(), dynamic.start_with(Rk4::new(1e-3)).unwrap());
        compared(by_steps, (5, 0.02));
        let by_error = (
            mechanism.start_with(Dop853::new(1e-9)).unwrap(),
            dynamic.start_with(Dop853::new(1e-9)).unwrap(),
        );
        compared(by_error, (10, 0.13));
    }
}

/// The same by a method with a history.
fn same_bits_with_history<M: Described<S = f64>>(mechanism: M) {
    for dynamic in small(&mechanism) {
        let adams =
            (mechanism.start_with(Adams::new(1e-8)).unwrap(), dynamic.start_with(Adams::new(1e-8)).unwrap());
        compared(adams, (5, 0.1));
    }
}

/// The same by methods that solve with derivatives.
fn same_bits_of_implicit<M: Described<S = f64> + Linear>(mechanism: M) {
    for dynamic in small(&mechanism) {
        let stiff = (
            mechanism.start_with(RadauIia5::new(1e-7)).unwrap(),
            dynamic.start_with(RadauIia5::new(1e-7)).unwrap(),
        );
        compared(stiff, (4, 0.1));
        let linearly = (
            mechanism.start_with(Ros34Pw2::new(1e-3)).unwrap(),
            dynamic.start_with(Ros34Pw2::new(1e-3)).unwrap(),
        );
        compared(linearly, (3, 0.02));
    }
}

#[test]
fn analyses() {
    same_analysis(double_pendulum::DoublePendulum::new());
    same_analysis(chain::Chain::new());
    same_analysis(four_bar::FourBar::new());
    same_analysis(slider_crank::SliderCrank::new());
    same_analysis(driven_crank::DrivenCrank::new());
    same_analysis(plate_on_three_pins::PlateOnThreePins::new());
    same_analysis(arm_on_jack::ArmOnJack::new());
}

#[test]
fn trees() {
    same_bits(chain::Chain::new());
    same_bits(double_pendulum::DoublePendulum::new());
    same_bits_with_history(double_pendulum::DoublePendulum::new());
    same_bits_of_implicit(double_pendulum::DoublePendulum::new());
}

#[test]
fn conditions_and_known_times() {
    same_bits(bouncer::Bouncer::new());
}

#[test]
fn loops_in_charts() {
    same_bits(four_bar::FourBar::new());
    same_bits(slider_crank::SliderCrank::new());
    same_bits_with_history(slider_crank::SliderCrank::new());
    same_bits_of_implicit(slider_crank::SliderCrank::new());
}

#[test]
fn absolute_coordinates() {
    same_bits(driven_crank::DrivenCrank::new());
    same_bits_with_history(driven_crank::DrivenCrank::new());
    same_bits_of_implicit(driven_crank::DrivenCrank::new());
    same_bits(plate_on_three_pins::PlateOnThreePins::new());
}

#[test]
fn first_order_states() {
    same_bits(arm_on_jack::ArmOnJack::new());
}
