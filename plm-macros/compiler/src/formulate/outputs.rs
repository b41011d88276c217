//! Readable quantities of a state: the user's outputs, energies and power.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, Vec2, algebra};

use super::function::Function;
use crate::derive::Equations;
use crate::model::{self, Body, Load, Model};

/// One output of the user.
pub(crate) struct Output {
    /// Its values, one, or (x, y).
    pub(crate) function: Function,
    /// Does it read accelerations or multipliers, so that the motion must be solved for it?
    pub(crate) solves: bool,
}

/// Everything that can be read from a state.
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
    let turns: Vec<Expr> = equations.branches.iter().map(|branch| branch.turn).collect_vec();
    let branches = Function::of_array("value", &turns).optimise();
    let [kinetic, gravity, power] = [kinetic_energy(equations), gravity_energy(model), load_power(model)];
    let power = algebra::substitute(&[power], signals)[0];
    let [kinetic_energy, gravity_energy, load_power] =
        [kinetic, gravity, power].map_each(|value| Function::of_value(value).optimise());
    Outputs { user, kinetic_energy, gravity_energy, branches, load_power }
}

/// Lays out outputs of the user.
pub(crate) fn user(outputs: &[model::Output], equations: &Equations) -> Vec<Output> {
    let mut solved: Vec<Expr> = equations.a.iter().chain(&equations.lambda).copied().collect_vec();
    solved.sort_unstable();
    let lay_out = |output: &model::Output| {
        let held = algebra::symbols(&output.components);
        let solves = held.iter().any(|symbol| solved.binary_search(symbol).is_ok());
        let function = match output.components.as_slice() {
            &[one] => Function::of_value(one),
            many => Function::of_array("value", many),
        };
        Output { function: function.optimise(), solves }
    };
    outputs.iter().map(lay_out).collect_vec()
}

/// `1/2 v^T M v`.
fn kinetic_energy(equations: &Equations) -> Expr {
    let squares = equations.mass.iter().zip(&equations.v).map(|(&m, &v)| m * v.squared());
    squares.sum::<Expr>() / 2
}

/// `-sum m g . r`.
fn gravity_energy(model: &Model) -> Expr {
    let g = model.gravity;
    let of_body = |body: &Body| (body.mass * g).dot(Vec2::new(body.q[0], body.q[1]));
    -model.bodies.iter().map(of_body).sum::<Expr>()
}

/// `sum F . v` over the loads.
fn load_power(model: &Model) -> Expr {
    let of_load = |load: &Load| {
        let v = model.bodies[load.body].v;
        load.force.into_iter().zip(v).map(|(force, v)| force * v)
    };
    model.loads.iter().flat_map(of_load).sum()
}
