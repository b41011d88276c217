//! Values of symbols, and of expressions of them.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use super::random::Random;
use crate::evaluated::value;
use crate::model::{Contact, ContactMode, Model, bounding_reactions};

/// f64's `Scalar::AGREEMENT`.
const AGREEMENT: f64 = 1e9;

/// Default values of all symbols but coordinates and velocities, at time zero.
pub(crate) fn defaults(model: &Model) -> Vec<(Expr, f64)> {
    let mut values = vec![
        (model.time, 0.0),
        (model.most_growth, f64::INFINITY),
        (model.agreement, AGREEMENT),
        (model.precision, f64::EPSILON),
    ];
    values.push_all(model.turns.iter().map(|counted| (counted.symbol, 0.0)));
    for param in &model.params {
        values.push((param.symbol, value(param.default, &values)));
    }
    for input in &model.inputs {
        values.push((input.symbol, value(input.default, &values)));
    }
    for state in &model.states {
        values.push((state.symbol, value(state.start, &values)));
    }
    values
}

/// Values of parameters, inputs and states where those parameters that have dimensions of a mechanism are others than declared;
/// none without parameters.
pub(crate) fn varied(model: &Model, seed: u64) -> Option<Vec<(Expr, f64)>> {
    let mut random = Random(seed);
    let mut values = defaults(model);
    for param in &model.params {
        let (_, value) = values.iter_mut().find(|(symbol, _)| *symbol == param.symbol)?;
        *value += (0.3 + 0.2 * value.abs()) * random.unit();
    }
    (!model.params.is_empty()).then_some(values)
}

/// Adds what is held over a step, at a state whose other symbols have values: the sides of the switches, and no contact forces,
/// reactions and accelerations.
pub(crate) fn add_switches(model: &Model, values: &mut Vec<(Expr, f64)>) {
    let sizes = bounding_reactions(&model.contacts).into_iter().map(|reaction| reaction.size);
    let of_joints = model.rows.iter().map(|row| row.lambda);
    let lambda = model.contacts.iter().map(|contact| contact.lambda).chain(of_joints);
    let accelerations = model.bodies.iter().flat_map(|body| body.a);
    values.push_all(lambda.chain(sizes).chain(accelerations).map(|symbol| (symbol, 0.0)));
    let is_open = |contact: &Contact| contact.kind_of_mode() == ContactMode::Open;
    values.push_all(model.contacts.iter().map(|contact| (contact.mode, f64::from(is_open(contact)))));
    let differences: Vec<Expr> = model.switches.iter().map(|switch| switch.difference).collect_vec();
    // All by one tape, unless one reads the side of another.
    let together = algebra::tape(&differences).eval(values).ok();
    for (k, switch) in model.switches.iter().enumerate() {
        let difference = together.as_ref().map_or_else(|| value(switch.difference, values), |all| all[k]);
        values.push((switch.symbol, if difference < 0.0 { -1.0 } else { 1.0 }));
    }
}
