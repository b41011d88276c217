//! Parameters and start values as data.

use plm_cas::Expr;

use super::routine::Routine;
use super::{Parts, read_parameters, si};
use crate::collect::{CollectVec, MapEach};
use crate::facts::limits;
pub use crate::facts::limits::{Least, Limit};
use crate::facts::state::OF_BODY;
use crate::model::Turn;

/// A parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// The SI unit.
    pub unit: String,
    /// Its default, of earlier parameters; none where whoever makes the mechanism must say it.
    pub default: Option<Routine>,
}

/// Start values, and what a start is made of.
#[derive(Clone, Debug)]
pub struct Starts {
    /// Name of each start value: x, y, angle, vx, vy, omega of each body, then first-order states.
    pub names: Vec<String>,
    /// Their values, of parameters.
    pub values: Routine,
    /// Of each: is assembly forbidden to move it?
    pub locked: Vec<bool>,
    /// Of each: does it read parameters, so that it follows them?
    pub follows: Vec<bool>,
    /// x, y of G from O in the axes of each body, m; of parameters.
    pub centres: Routine,
    /// Of each body: is its start angle given by the declaration?
    pub given_angles: Vec<bool>,
    /// Values of the inputs at the start; of parameters.
    pub inputs: Routine,
    /// The values of [`limits`](Self::limits); of parameters.
    pub limited: Routine,
    /// Ranges of values that parameters give.
    pub limits: Vec<Limit>,
    /// Limits of mass and inertia of every body, if others may carry some that parameters make massless.
    pub carried: Option<Vec<[Limit; 2]>>,
    /// Numbers of the parameters that joints, masses or known times read.
    pub shaping: Vec<usize>,
    /// Mirror images that joints ask for.
    pub branches: Vec<Branch>,
    /// Ends of those, four numbers for each: from the joint to the neighbours, of parameters.
    pub ends: Routine,
}

/// A mirror image that a joint asks for.
#[derive(Clone, Debug)]
pub struct Branch {
    /// The joint.
    pub part: String,
    /// The two bodies.
    pub bodies: [usize; 2],
    /// Their names.
    pub names: [String; 2],
    /// Is the turn to the left?
    pub left: bool,
}

pub(super) fn parameters(parts: &Parts) -> Vec<Parameter> {
    let params = parts.model.params.iter().map(|param| Parameter {
        name: param.name.text.clone(),
        unit: si(&param.unit),
        default: (!param.required).then(|| parts.values(&[param.default])),
    });
    params.collect_vec()
}

impl Starts {
    pub(super) fn new(parts: &Parts) -> Starts {
        let model = parts.model;
        let (mut names, mut starts) = (Vec::new(), Vec::new());
        for body in &model.bodies {
            for (value, start) in OF_BODY.into_iter().zip(body.start.iter().chain(&body.start_velocity)) {
                names.push(format!("{}.{value}", body.name.text));
                starts.push((start.value, start.locked));
            }
        }
        for state in &model.states {
            names.push(state.name.text.clone());
            starts.push((state.start, state.locked));
        }
        let values: Vec<Expr> = starts.iter().map(|(value, _)| *value).collect_vec();
        let centres = model.bodies.iter().flat_map(|body| body.centre.components()).collect_vec();
        let may_be_carried = parts.may_be_carried();
        let limits = limits::varying(model, may_be_carried);
        let limited = limits.iter().map(|limit| limit.value).collect_vec();
        let (branches, ends) = branches(parts);
        let inputs = model.inputs.iter().map(|input| input.default).collect_vec();
        Starts {
            names,
            values: parts.values(&values),
            locked: starts.iter().map(|(_, locked)| *locked).collect_vec(),
            follows: values.iter().map(|value| !read_parameters(model, &[*value]).is_empty()).collect_vec(),
            centres: parts.values(&centres),
            given_angles: model.bodies.iter().map(|body| body.start[2].given).collect_vec(),
            inputs: parts.values(&inputs),
            limited: parts.values(&limited),
            limits,
            carried: limits::that_may_be_carried(model, may_be_carried),
            shaping: read_parameters(model, &limits::shaping(model)),
            branches,
            ends: parts.values(&ends),
        }
    }
}

fn branches(parts: &Parts) -> (Vec<Branch>, Vec<Expr>) {
    let Parts { model, equations, .. } = parts;
    let (mut branches, mut ends) = (Vec::new(), Vec::new());
    for branch in &equations.branches {
        let Some((turn, _)) = model.parts[branch.part].branch else { continue };
        branches.push(Branch {
            part: model.parts[branch.part].name.text.clone(),
            bodies: branch.bodies,
            names: branch.bodies.map_each(|body| model.bodies[body].name.text.clone()),
            left: turn == Turn::Left,
        });
        for end in branch.ends.iter().flatten() {
            ends.extend(end.components());
        }
    }
    (branches, ends)
}
