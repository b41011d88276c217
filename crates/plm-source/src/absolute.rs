//! Absolute coordinates: the rate, the pose, projection onto the joints, and poses that are nearly singular.

use plm_runtime::absolute::Constants;
use plm_runtime::{Real, step};

use crate::Precision;
use crate::dialect::Dialect as _;
use crate::function::Signature;
use crate::plan::Plan;
use crate::source::{GUARDS, RATE};

const PROJECTION: &str = include_str!("c/absolute.c.txt");
const CONDITIONING: &str = include_str!("c/conditioning.c.txt");
/// The work between steps.
pub(crate) const BETWEEN: &str = include_str!("c/joints.c.txt");

const PHI: Signature = Signature { reads: &["q"], writes: &["phi"], returns: false, is_forced: false };
const PHI_DOT: Signature =
    Signature { reads: &["q", "v"], writes: &["phi_dot"], returns: false, is_forced: false };
const MIN_NORM: Signature =
    Signature { reads: &["q", "w", "r"], writes: &["dq"], returns: true, is_forced: false };
const INVERSE_MASS: Signature =
    Signature { reads: &[], writes: &["inverse_mass"], returns: false, is_forced: false };

/// The pose is the beginning of the state.
const POSE: &str = "static plm_real @p@_pose_in(const @p@ *self, plm_real t, const plm_real x[@states@], plm_real q[@of_bodies@], plm_real v[@of_bodies@])
{
    int k;
    (void)self;
    (void)t;
    for (k = 0; k < @nq@; k++) {
        q[k] = x[k];
        v[k] = x[@nq@ + k];
    }
    return PLM_C(1.0);
}

";

/// Routines of a mechanism in absolute coordinates, and what is made of them.
pub(crate) fn functions(plan: &Plan) -> String {
    let equations = &plan.lowered.absolute;
    let mut text = String::new();
    if plan.has_rate() {
        text.push_str(&plan.of_routine("rate_in", &equations.dynamics, RATE));
    }
    text.push_str(&plan.filled(POSE));
    if plan.counts.guards > 0 {
        text.push_str(&plan.of_routine("guards_in", &equations.guards, GUARDS));
    }
    if plan.projects() || plan.lowered.may_be_singular {
        text.push_str(&plan.of_routine("min_norm", &equations.min_norm, MIN_NORM));
    }
    if plan.projects() {
        text.push_str(&plan.of_routine("phi", &equations.phi, PHI));
        text.push_str(&plan.of_routine("phi_dot", &equations.phi_dot, PHI_DOT));
        text.push_str(&plan.of_routine("inverse_mass", &equations.inverse_mass, INVERSE_MASS));
    }
    text
}

/// Functions that a step calls.
pub(crate) fn of_step(plan: &Plan) -> String {
    let mut text = String::new();
    if plan.projects() {
        text.push_str(PROJECTION);
    }
    if plan.lowered.may_be_singular {
        text.push_str(CONDITIONING);
    }
    text
}

/// The words of these.
pub(crate) fn words(plan: &Plan) -> Vec<(&'static str, String)> {
    if !plan.is_absolute() {
        return [("health_given", ""), ("health_taken", ""), ("projected", ""), ("undrifted", "")]
            .map(|(word, text)| (word, text.to_owned()))
            .into();
    }
    match plan.precision {
        Precision::Double => words_of::<f64>(plan),
        Precision::Single => words_of::<f32>(plan),
    }
}

fn words_of<S: Real>(plan: &Plan) -> Vec<(&'static str, String)> {
    let (c, counts, constants) = (plan.c(), &plan.counts, Constants::<S>::new());
    let number = |value: S| c.number(value.to_f64());
    let length = S::lit(plan.lowered.length);
    let nq = counts.coordinates;
    let drift = S::lit(step::DRIFT).max(S::lit(64.0) * S::EPSILON);
    let typical = |k: usize| S::lit(plan.lowered.typical.get(k).copied().unwrap_or(1.0));
    let largest = |from: usize| (from..from + nq).fold(S::ZERO, |most, k| typical(k).max(most));
    let list = |numbers: &mut dyn Iterator<Item = S>| numbers.map(number).collect::<Vec<_>>().join(", ");
    // A step with rows of contact has projected its joints itself.
    let drifts = plan.projects() && counts.contacts == 0;
    let wanted = |is_wanted: bool, text: &str| if is_wanted { text.to_owned() } else { String::new() };
    let project = "    if (@p@_drifts(self, end, next)) {\n        const int status = @p@_project(self, end, next);\n        \
        if (status != PLM_OK) {\n            return @p@_fail(self, status, @part_open@);\n        }\n    }\n";
    let [least_looks, most_looks] = constants.looks.map(|looks| c.number(looks as f64));
    vec![
        ("health_given", wanted(plan.lowered.may_be_singular, "health, ")),
        ("health_taken", wanted(plan.lowered.may_be_singular, "plm_real health, ")),
        ("projected", wanted(drifts, project)),
        ("undrifted", wanted(drifts, " && !@p@_drifts(self, t, x)")),
        ("drift", number(drift * largest(0))),
        ("drift_of_rates", number(drift * largest(nq))),
        ("iterations", constants.iterations.to_string()),
        ("length", number(length)),
        ("epsilon", number(S::EPSILON)),
        ("joints_closed", number(constants.closed)),
        ("area", number(length * length)),
        ("apart", number(constants.apart)),
        ("least_looks", least_looks),
        ("most_looks", most_looks),
        ("descents", constants.descents.to_string()),
        ("typical", list(&mut (0..nq).map(typical))),
        ("fractions", list(&mut Constants::<S>::fractions().take(nq).map(S::lit))),
        ("reaches", list(&mut Constants::<S>::reaches(length).into_iter())),
        ("low", number(constants.low)),
        ("long_step", number(constants.long_step)),
        ("ill_conditioned", number(constants.ill_conditioned)),
        ("joints", counts.rows.to_string()),
        ("joint_rows", counts.rows.max(1).to_string()),
    ]
}
