//! Differences of runs, and what they say of derivatives.

use plm::dynamic::{Compiled, Small};
use plm::runtime::described::by_number::set_parameter;
use plm::runtime::{Described, Dual, Moment, Real, Scalar};
use plm::{By, Cause, Dop853, Fault, Mechanism, with_derivatives};

use super::backward::{Backward, backward};
use super::cases::Case;

/// Outcome of a case.
pub enum Verdict {
    /// All derivatives are those of the differences, but for a part of their size.
    Right { apart: f64 },
    /// Some are not.
    Wrong { why: String },
    /// The differences do not agree with each other.
    NoDifference,
    /// The run says that it has no derivatives.
    NoDerivative(Fault),
}

/// Weights of a central difference of order 8 (B. Fornberg, Generation of finite difference formulas on arbitrarily spaced grids, Math.
/// Comp. 51, 1988).
const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
/// The nearer differences reach over four times this share of a value.
const REACH: f64 = 1e-4;
/// Two differences that agree to so much of their size are believed.
const BELIEVED: f64 = 1e-7;
/// Derivatives may differ from what is believed by so many times what the two differences are apart, ...
const FACTOR: f64 = 20.0;
/// ... and by this part of their size: the error of the runs.
const LEAST: f64 = 1e-8;
/// Of the runs.
const TOLERANCE: f64 = 1e-13;

/// Derives the outputs of a case, and compares.
///
/// # Errors
/// The text is refused, a run fails for another reason than that it has no derivatives, or those backward are not those forward.
pub fn judge(case: &Case) -> Result<(Verdict, Option<Backward>), String> {
    let compiled = Compiled::new("case", &case.text).map_err(|error| error.to_string())?;
    let mechanism = compiled.mechanism::<24, 32, 64, 24, 64>().map_err(|error| error.to_string())?;
    let lifted = with_derivatives(&mechanism, case.by.map(|(name, _)| By::Parameter(name)))
        .map_err(|error| error.to_string())?;
    let derived = match outputs(lifted, case.time) {
        Ok(derived) => derived,
        Err(fault @ Fault { cause: Cause::Grazes | Cause::AtLimit | Cause::AtOnce { .. }, .. }) => {
            return Ok((Verdict::NoDerivative(fault), None));
        }
        Err(fault) => return Err(fault.to_string()),
    };
    let backward = backward(&mechanism, case, TOLERANCE, &derived)?;
    Ok((beside_differences(&mechanism, case, &derived), Some(backward)))
}

/// Compares derivatives with differences.
fn beside_differences(mechanism: &Small, case: &Case, derived: &[Dual<f64, 3>]) -> Verdict {
    let mut largest = 0.0_f64;
    let mut decided = false;
    for (direction, (name, value)) in case.by.into_iter().enumerate() {
        let step = REACH * value.abs().max(0.1);
        let (Ok(near), Ok(far)) = (
            difference(mechanism, case, (name, value), step),
            difference(mechanism, case, (name, value), 2.0 * step),
        ) else {
            continue;
        };
        for (k, (near, far)) in near.into_iter().zip(far).enumerate() {
            let Dual { value: output, tangents } = derived[k];
            let size = near.abs().max(output.abs()).max(1.0);
            let apart = (near - far).abs() / size;
            if apart > BELIEVED {
                continue;
            }
            decided = true;
            let error = (tangents[direction] - near).abs() / size;
            if error > FACTOR * apart + LEAST {
                let found = tangents[direction];
                let why = format!(
                    "output {k} by {name} at {} s: {found:e}, by differences {near:e} and {far:e}",
                    case.time
                );
                return Verdict::Wrong { why };
            }
            largest = largest.max(error);
        }
    }
    if decided { Verdict::Right { apart: largest } } else { Verdict::NoDifference }
}

/// The derivatives of all outputs by a parameter, by runs about its value.
fn difference(
    mechanism: &Small,
    case: &Case,
    (name, value): (&str, f64),
    step: f64,
) -> Result<Vec<f64>, Fault> {
    let index = mechanism.tables().parameters.iter().position(|parameter| parameter.name == name);
    let at = |value: f64| {
        let mut other = *mechanism;
        set_parameter(&mut other, index.unwrap_or(usize::MAX), value);
        outputs(other, case.time)
    };
    let mut sums: Vec<f64> = Vec::new();
    for (k, weight) in (1..).zip(WEIGHTS) {
        let away = f64::from(k) * step;
        let [above, below] = [at(value + away)?, at(value - away)?];
        sums.resize(above.len(), 0.0);
        for ((sum, above), below) in sums.iter_mut().zip(above).zip(below) {
            *sum += weight * (above - below) / step;
        }
    }
    Ok(sums)
}

/// All outputs at a time.
fn outputs<M: Mechanism<S: Real> + Described>(mechanism: M, time: f64) -> Result<Vec<M::S>, Fault> {
    let mut sim = mechanism.start_with(Dop853::new(M::S::lit(TOLERANCE)))?;
    sim.step_to(M::S::lit(time))?;
    let count = sim.state().mechanism().observables().len();
    Ok((0..count).filter_map(|k| M::observed(sim.state(), k)).collect())
}
