//! Derivatives forward, backward, and by differences of runs.

use plm_dynamic::{Dynamic, Small};
use plm_runtime::adjoint::{self, Carried, Memory, NoGradient};
use plm_runtime::described::by_number::set_parameter;
use plm_runtime::gradient::By;
use plm_runtime::{
    Cause, Described, Dop853, Dual, Fault, Mechanism, Moment, Real, Scalar, Sim, StartValues, Statics, Term,
    Trace, Traced, with_derivatives, with_trace,
};

/// Outputs of a machine at most.
pub(super) const OUTPUTS: usize = 4;
/// The tolerance of all runs.
const TOLERANCE: f64 = 1e-12;
/// Terms of the trace.
const TERMS: usize = 1_000_000;
/// Saved states.
const SAVED: usize = 24;
/// A difference reaches so far, times 1, 2 and 4, over the size of a number.
const REACH: f64 = 2e-4;
/// Two differences that agree to so much of their size are believed.
const BELIEVED: f64 = 1e-6;
/// Derivatives may differ from what is believed by so many times what the two differences are apart, ...
const FACTOR: f64 = 20.0;
/// ... and by this part of their size: the error of the runs.
const LEAST: f64 = 1e-7;

/// Verdict of a comparison.
pub(super) enum Beside {
    /// So much of what is allowed.
    Right(f64),
    /// The differences do not agree with each other.
    Nothing,
    Wrong(String),
}

/// The outputs with their derivatives.
pub(super) fn forward(own: &Small, by: By<'_>, until: f64) -> Result<Vec<Dual<f64, 1>>, Cause> {
    let lifted = with_derivatives(own, [by]).map_err(|_| Cause::NotFinite)?;
    outputs(lifted, until).map_err(|fault| fault.cause)
}

/// The derivatives of the outputs, a row of each variable.
pub(super) fn backward(own: &Small, by: &[By<'_>], until: f64) -> Result<Vec<[f64; OUTPUTS]>, NoGradient> {
    let mut terms = vec![Term::EMPTY; TERMS];
    let trace = Trace::new(&mut terms, by.len());
    let mut gradient = vec![[0.0; OUTPUTS]; by.len()];
    found(own, by, (until, &trace), &mut gradient)?;
    Ok(gradient)
}

fn found<'t>(
    own: &Small,
    by: &[By<'_>],
    (until, trace): (f64, &'t Trace<'t>),
    gradient: &mut [[f64; OUTPUTS]],
) -> Result<(), NoGradient> {
    let Ok(recorded) = with_trace(own, by, trace) else {
        return Err(NoGradient::Fault(Fault::new(0.0, Cause::NotFinite)));
    };
    let start = recorded.start_with(Dop853::new(TOLERANCE.into()))?;
    let mut adjoints = vec![[0.0; OUTPUTS]; TERMS];
    let mut carried = carried_of(&start);
    let mut saved = vec![None; SAVED];
    let memory = Memory { adjoints: &mut adjoints, carried: &mut carried, saved: &mut saved };
    adjoint::adjoint(
        trace,
        start,
        |sim| Sim::step_towards(sim, until.into()),
        |sim| core::array::from_fn(|k| observed::<Dynamic<Traced<'t>, 24, 32, 64, 24>>(sim.state(), k)),
        memory,
        gradient,
    )?;
    Ok(())
}

fn observed<'t, M: Described<S = Traced<'t>>>(state: &M::State, k: usize) -> Traced<'t> {
    let declared = declared(state.mechanism()).nth(k);
    declared.and_then(|k| M::observed(state, k)).unwrap_or(Traced::constant(0.0))
}

fn carried_of<P>(_start: &P) -> Vec<Carried<f64, OUTPUTS>> {
    vec![Carried::EMPTY; adjoint::carried::<P, f64>()]
}

/// Compares derivatives forward and backward with differences.
pub(super) fn beside_differences(
    own: &Small,
    by: By<'_>,
    until: f64,
    (ahead, back): (&[Dual<f64, 1>], Option<&[f64; OUTPUTS]>),
) -> Beside {
    let value = number(own, by);
    let step = REACH * value.abs().max(0.1);
    let Some([near, far]) = differences(own, by, until, step) else { return Beside::Nothing };
    let (mut worst, mut decided) = (0.0_f64, false);
    for (k, Dual { value, tangents: [slope] }) in ahead.iter().enumerate() {
        let size = near[k].abs().max(value.abs()).max(1.0);
        let apart = (near[k] - far[k]).abs() / size;
        let is_believed = apart <= BELIEVED;
        if !is_believed {
            continue;
        }
        decided = true;
        for (way, slope) in [("forward", Some(*slope)), ("backward", back.map(|back| back[k]))] {
            let Some(slope) = slope else { continue };
            let error = (slope - near[k]).abs() / size / (FACTOR * apart + LEAST);
            let is_right = error <= 1.0;
            if !is_right {
                let [near, far] = [near[k], far[k]];
                return Beside::Wrong(format!(
                    "output {k} {way} {slope:e}, by differences {near:e} and {far:e}"
                ));
            }
            worst = worst.max(error);
        }
    }
    if decided { Beside::Right(worst) } else { Beside::Nothing }
}

/// Differences of order 4 over one step and over twice the step; none where a run fails.
fn differences(own: &Small, by: By<'_>, until: f64, step: f64) -> Option<[Vec<f64>; 2]> {
    let at = |away: f64| outputs(moved(own, by, away), until).ok();
    let pair = |away: f64| {
        let (above, below) = (at(away)?, at(-away)?);
        Some(
            above
                .into_iter()
                .zip(below)
                .map(|(above, below)| (above - below) / (2.0 * away))
                .collect::<Vec<f64>>(),
        )
    };
    let [one, two, four] = [pair(step)?, pair(2.0 * step)?, pair(4.0 * step)?];
    let fourth = |near: &[f64], far: &[f64]| {
        near.iter().zip(far).map(|(near, far)| (4.0 * near - far) / 3.0).collect()
    };
    Some([fourth(&one, &two), fourth(&two, &four)])
}

/// A number by which a machine is derived.
fn number(own: &Small, by: By<'_>) -> f64 {
    let mut own = *own;
    let mut value = 0.0;
    if let By::Parameter(name) = by {
        let index = own.tables().parameters.iter().position(|parameter| parameter.name == name);
        return index.and_then(|index| own.parameter(index)).unwrap_or(0.0);
    }
    own.starts_mut().each(&mut |known, start| {
        if known == by.name() {
            value = start.value;
        }
    });
    value
}

/// The machine with another number.
fn moved(own: &Small, by: By<'_>, away: f64) -> Small {
    let (mut own, value) = (*own, number(own, by) + away);
    if let By::Parameter(name) = by {
        let index = own.tables().parameters.iter().position(|parameter| parameter.name == name);
        set_parameter(&mut own, index.unwrap_or(usize::MAX), value);
        return own;
    }
    own.starts_mut().each(&mut |known, start| {
        if known == by.name() {
            *start = start.at(value);
        }
    });
    own
}

/// The declared outputs at a time.
fn outputs<M: Mechanism<S: Real> + Described>(mechanism: M, until: f64) -> Result<Vec<M::S>, Fault> {
    let mut sim = mechanism.start_with(Dop853::new(M::S::lit(TOLERANCE)))?;
    sim.step_to(M::S::lit(until))?;
    let declared: Vec<usize> = declared(sim.state().mechanism()).collect();
    Ok(declared.into_iter().take(OUTPUTS).filter_map(|k| M::observed(sim.state(), k)).collect())
}

/// Numbers of the declared outputs among all that can be read.
fn declared<M: Described>(mechanism: &M) -> impl Iterator<Item = usize> {
    let all = mechanism.observables();
    let place = move |name: &str| all.iter().position(|(known, _)| *known == name);
    mechanism.tables().outputs.iter().filter_map(move |output| place(output.name))
}
