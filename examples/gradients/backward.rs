//! Derivatives backward along the run, beside those forward.

use plm::adjoint::{self, Carried, Memory, NoGradient};
use plm::dynamic::{Dynamic, Small};
use plm::runtime::Described;
use plm::{By, Cause, Dop853, Dual, Mechanism, Sim, Term, Trace, Traced, with_trace};

use super::cases::Case;

/// Outputs of a case at most.
const MOST: usize = 4;
/// Terms of the trace: less than those of a run, so that states are saved and segments made again.
const TERMS: usize = 1_000_000;
/// The part of its size by which a derivative may differ from that forward.
const MOST_APART: f64 = 1e-11;
/// Saved states.
const SAVED: usize = 24;

/// The mechanism of a case in recorded numbers.
type Recorded<'t> = Dynamic<Traced<'t>, 24, 32, 64, 24>;

/// Comparison of derivatives backward with those forward.
pub enum Backward {
    /// The same, but for a part of their size.
    Same { apart: f64 },
    /// The run says that it has none, since two events happen at one time.
    AtOnce,
}

/// Derives the outputs of a case backward, and compares.
///
/// # Errors
/// They are others than those forward, or the run fails.
pub fn backward(
    mechanism: &Small,
    case: &Case,
    tolerance: f64,
    forward: &[Dual<f64, 3>],
) -> Result<Backward, String> {
    let mut terms = vec![Term::EMPTY; TERMS];
    let trace = Trace::new(&mut terms, 3);
    let found = match gradient(mechanism, case, tolerance, &trace) {
        Ok(found) => found,
        Err(NoGradient::Fault(fault)) if matches!(fault.cause, Cause::AtOnce { .. }) => {
            return Ok(Backward::AtOnce);
        }
        Err(error) => return Err(error.to_string()),
    };
    let mut apart = 0.0_f64;
    for (k, Dual { value, tangents }) in forward.iter().enumerate() {
        for (direction, forward) in tangents.iter().enumerate() {
            let backward = found[direction][k];
            let size = forward.abs().max(value.abs()).max(1.0);
            let error = (backward - forward).abs() / size;
            if error > MOST_APART || !error.is_finite() {
                return Err(format!(
                    "output {k} by {}: backward {backward:e}, forward {forward:e}",
                    case.by[direction].0
                ));
            }
            apart = apart.max(error);
        }
    }
    Ok(Backward::Same { apart })
}

/// The derivatives of the outputs, a row of each parameter.
fn gradient<'t>(
    mechanism: &Small,
    case: &Case,
    tolerance: f64,
    trace: &'t Trace<'t>,
) -> Result<[[f64; MOST]; 3], NoGradient> {
    let by = case.by.map(|(name, _)| By::Parameter(name));
    let own = with_trace(mechanism, &by, trace).expect("the run forward has the same names");
    let start = own.start_with(Dop853::new(tolerance.into()))?;
    let mut adjoints = vec![[0.0; MOST]; TERMS];
    let mut carried = carried_of(&start);
    let mut saved = vec![None; SAVED];
    let memory = Memory { adjoints: &mut adjoints, carried: &mut carried, saved: &mut saved };
    let mut gradient = [[0.0; MOST]; 3];
    adjoint::adjoint(
        trace,
        start,
        |sim| Sim::step_towards(sim, case.time.into()),
        |sim| core::array::from_fn(|k| observed::<Recorded<'_>>(sim.state(), k)),
        memory,
        &mut gradient,
    )?;
    Ok(gradient)
}

fn observed<'t, M: Described<S = Traced<'t>>>(state: &M::State, k: usize) -> Traced<'t> {
    M::observed(state, k).unwrap_or(Traced::constant(0.0))
}

fn carried_of<P>(_start: &P) -> Vec<Carried<f64, MOST>> {
    vec![Carried::EMPTY; adjoint::carried::<P, f64>()]
}
