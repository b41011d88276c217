//! Absolute coordinates and outputs as data.

use super::routine::{Routine, Target};
use super::{Parts, si};
use crate::collect::{CollectVec, PushAll};
use crate::facts::quantities::axes;
use crate::formulate::{Function, UserOutput};
use crate::model;
use crate::source::Origin;

/// A constraint row.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its name, `shoulder.x`.
    pub name: String,
    /// The part that it belongs to.
    pub part: String,
    /// Is its residual an angle? Else it is a length.
    pub is_angular: bool,
}

/// Routines in absolute coordinates.
#[derive(Clone, Debug)]
pub struct AbsoluteEquations {
    /// `dx` and `lambda`, returning Health.
    pub dynamics: Routine,
    /// `force` and `gamma`, for the solution by rank.
    pub free: Routine,
    /// `x_dot`, rates of the first-order states.
    pub x_dot: Routine,
    /// `force` and `x_dot` without accelerations.
    pub at_rest: Routine,
    /// `g`, the guards of conditions, then kinks.
    pub guards: Routine,
    /// `phi`, of a pose.
    pub phi: Routine,
    /// `phi_dot`, of a pose and velocity.
    pub phi_dot: Routine,
    /// `phi_q`, the entries of the Jacobian that are not zero.
    pub phi_q: Routine,
    /// Row and column of each of these entries.
    pub places: Vec<(usize, usize)>,
    /// `dq`, returning Health, of `q`, `w`, `r`.
    pub min_norm: Routine,
    /// `inverse_mass`.
    pub inverse_mass: Routine,
    /// Kinetic energy, J.
    pub kinetic_energy: Routine,
    /// Potential energy of gravity above the origin, J.
    pub gravity_energy: Routine,
    /// Power of all loads but gravity, W.
    pub load_power: Routine,
    /// `value`: the turns at the revolutes between bodies.
    pub branches: Routine,
    /// Names of these revolutes.
    pub joints: Vec<String>,
}

/// A number that can be read of a state.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name; of a vector with its axis.
    pub name: String,
    /// The unit in which tables show it.
    pub unit: String,
    /// Its value in SI over that in the unit.
    pub factor: f64,
    /// The SI unit.
    pub si: String,
    /// Is it declared, so that it stands in recordings? Else it is observed.
    pub declared: bool,
    /// The number of its value among [`Lowered::values`](super::Lowered::values).
    pub value: usize,
    /// The number of the component of a vector; 0 of a scalar.
    pub component: usize,
}

/// A scalar, or a vector of which several outputs are components.
#[derive(Clone, Debug)]
pub struct OutputValue {
    /// Must the motion be solved for it: does it read accelerations or multipliers?
    pub solves: bool,
    /// Its value, SI, which the routine returns; of a vector the array `value`.
    pub value: Routine,
}

impl OutputValue {
    /// Is a result of its routine this component?
    pub fn is_component(target: Target, component: usize) -> bool {
        match target {
            Target::Value => component == 0,
            Target::Element(_, k) => component == k,
            _ => false,
        }
    }
}

pub(super) fn rows(parts: &Parts) -> Vec<Row> {
    let model = parts.model;
    let row = |row: &model::Row| Row {
        name: row.name.clone(),
        part: model.parts[row.part].name.text.clone(),
        is_angular: row.is_angular(),
    };
    model.rows.iter().map(row).collect_vec()
}

impl AbsoluteEquations {
    pub(super) fn new(parts: &Parts) -> AbsoluteEquations {
        let Parts { model, equations, program, .. } = parts;
        let absolute = &program.absolute;
        let of_state = |function: &Function| parts.routine(function, Origin::Arguments);
        let of_pose = |function: &Function| parts.routine(function, Origin::Pose);
        let of_moment = |function: &Function| parts.routine(function, Origin::State);
        let places = equations.phi_q.iter().enumerate();
        let places = places.flat_map(|(row, entries)| entries.iter().map(move |(column, _)| (row, *column)));
        let joints = equations.branches.iter().map(|branch| model.parts[branch.part].name.text.clone());
        AbsoluteEquations {
            dynamics: of_state(&absolute.dynamics),
            free: of_state(&absolute.free),
            x_dot: of_state(&absolute.x_dot),
            at_rest: of_state(&absolute.at_rest),
            guards: of_state(&absolute.guards),
            phi: of_pose(&absolute.phi),
            phi_dot: of_pose(&absolute.phi_dot),
            phi_q: of_pose(&absolute.phi_q),
            places: places.collect_vec(),
            min_norm: of_pose(&absolute.min_norm),
            inverse_mass: of_pose(&absolute.inverse_mass),
            kinetic_energy: of_moment(&absolute.outputs.kinetic_energy),
            gravity_energy: of_moment(&absolute.outputs.gravity_energy),
            load_power: of_moment(&absolute.outputs.load_power),
            branches: of_moment(&absolute.outputs.branches),
            joints: joints.collect_vec(),
        }
    }
}

/// The numbers of the outputs, a vector as two.
pub(super) fn outputs(parts: &Parts) -> Vec<Output> {
    let mut all = Vec::new();
    for (value, output) in parts.model.outputs.iter().enumerate() {
        let axes = axes(output.components.len());
        all.push_all(axes.iter().enumerate().map(|(component, axis)| Output {
            name: format!("{}{axis}", output.name.text),
            unit: output.unit.text.clone(),
            factor: output.unit.factor.to_f64(),
            si: si(&output.unit),
            declared: output.declared,
            value,
            component,
        }));
    }
    all
}

/// The scalars and vectors of the outputs.
pub(super) fn values(parts: &Parts) -> Vec<OutputValue> {
    let laid_out = parts.program.absolute.outputs.user.iter();
    let value = |output: &UserOutput| OutputValue {
        solves: output.solves,
        value: parts.routine(&output.function, Origin::State),
    };
    laid_out.map(value).collect_vec()
}
