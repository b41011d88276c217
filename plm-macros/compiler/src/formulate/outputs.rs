//! What can be read from a state: the user's outputs, energies and power.

use plm_cas::{Expr, algebra};

use super::function::{Function, Place};
use crate::derive::Equations;
use crate::model::{self, Model};

/// One output of the user.
#[derive(Debug)]
pub(crate) struct Output {
    /// Its values, one, or (x, y).
    pub(crate) function: Function,
    /// Does it read accelerations or multipliers, so that the motion must be solved for it?
    pub(crate) solves: bool,
}

/// Everything that can be read from a state.
#[derive(Debug)]
pub(crate) struct Outputs {
    /// The user's outputs, in the order of the model.
    pub(crate) user: Vec<Output>,
    /// Kinetic energy, J.
    pub(crate) kinetic_energy: Function,
    /// Potential energy of gravity above the origin, J.
    pub(crate) gravity_energy: Function,
    /// Turns at the revolutes between bodies, rad.
    pub(crate) branches: Function,
    /// Power of all loads but gravity, W.
    pub(crate) load_power: Function,
}

/// Lays out the outputs; `signals` are the unknowns that forces read, and their values.
pub(crate) fn formulate(model: &Model, equations: &Equations, signals: &[(Expr, Expr)]) -> Outputs {
    let user = user(&model.outputs, equations);
    let turns =
        equations.branches.iter().enumerate().map(|(k, branch)| (Place::Element("value", k), branch.turn));
    let branches = Function::of_results(turns.collect()).optimise();
    let kinetic = kinetic_energy(equations);
    let gravity = gravity_energy(model);
    let power = load_power(model);
    let power = algebra::substitute(&[power], signals)[0];
    let scalar = |value: Expr| Function::of_results(vec![(Place::Value, value)]).optimise();
    Outputs {
        user,
        kinetic_energy: scalar(kinetic),
        gravity_energy: scalar(gravity),
        load_power: scalar(power),
        branches,
    }
}

/// Lays out outputs of the user.
pub(crate) fn user(outputs: &[model::Output], equations: &Equations) -> Vec<Output> {
    let mut solved: Vec<Expr> = equations.a.iter().chain(&equations.lambda).copied().collect();
    solved.sort_unstable();
    let lay_out = |output: &model::Output| {
        let held = algebra::symbols(&output.components);
        let solves = held.iter().any(|symbol| solved.binary_search(symbol).is_ok());
        let results = match output.components.as_slice() {
            &[one] => vec![(Place::Value, one)],
            many => many.iter().enumerate().map(|(k, &value)| (Place::Element("value", k), value)).collect(),
        };
        Output { function: Function::of_results(results).optimise(), solves }
    };
    outputs.iter().map(lay_out).collect()
}

/// `1/2 v^T M v`.
fn kinetic_energy(equations: &Equations) -> Expr {
    let terms = equations.mass.iter().zip(&equations.v).map(|(&mass, &v)| {
        let square = v.powi(2);
        mass * square
    });
    let terms: Vec<Expr> = terms.collect();
    let two = Expr::from(2);
    let sum = algebra::sum(&terms);
    sum / two
}

/// `-sum m g . r`.
fn gravity_energy(model: &Model) -> Expr {
    let mut terms = Vec::new();
    for body in &model.bodies {
        for (gravity, &place) in model.gravity.components().into_iter().zip(&body.q) {
            let weight = body.mass * gravity;
            let against = -weight;
            terms.push(against * place);
        }
    }
    algebra::sum(&terms)
}

/// `sum F . v` over the loads.
fn load_power(model: &Model) -> Expr {
    let mut terms = Vec::new();
    for load in &model.loads {
        let v = model.bodies[load.body].v;
        for (&force, v) in load.force.iter().zip(v) {
            terms.push(force * v);
        }
    }
    algebra::sum(&terms)
}
