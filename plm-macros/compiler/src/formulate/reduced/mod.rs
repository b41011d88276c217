//! Rung 2: a tree in joint coordinates. No constraint is left, so nothing can drift.

mod chain;
mod coordinates;
mod inertia;
mod motion;
mod plane;

use plm_cas::{Expr, Graph};

use self::coordinates::{Coordinates, Unknown};
use self::inertia::Dense;
use self::motion::Motion;
use super::function::{Function, Place, Section};
use super::ldl::factorise;
use crate::derive::Equations;
use crate::model::Model;

/// Coordinates up to which the dense mass matrix is set up; beyond, elimination in absolute coordinates is cheaper.
const MOST_DENSE: usize = 12;

/// Everything that a rung above 5 computes.
#[derive(Debug)]
pub(crate) struct Reduced {
    /// Name of each coordinate, as a path of the model.
    pub(crate) names: Vec<String>,
    /// Is the coordinate an angle?
    pub(crate) angles: Vec<bool>,
    /// The part or body that each coordinate belongs to.
    pub(crate) parts: Vec<String>,
    /// Symbols of the coordinates.
    pub(crate) y: Vec<Expr>,
    /// Symbols of their rates.
    pub(crate) y_dot: Vec<Expr>,
    /// `dx`.
    pub(crate) rate: Function,
    /// `q`, `v` of all bodies.
    pub(crate) pose: Function,
    /// `x` of a state in absolute coordinates.
    pub(crate) project: Function,
}

/// Lays out rung 2.
///
/// # Errors
/// Why the mechanism is no tree of joints: words that go on "rung 5 because …".
pub(crate) fn formulate(model: &Model, equations: &Equations, graph: &mut Graph) -> Result<Reduced, String> {
    let coordinates = Coordinates::of_tree(model, graph)?;
    if coordinates.unknowns.len() > MOST_DENSE {
        return Err(format!("it has {} degrees of freedom", coordinates.unknowns.len()));
    }
    let motion = Motion::new(model, &coordinates, graph);
    let force = loads(model, &motion, graph);
    let dense = inertia::dense(model, &coordinates, &motion, &force, graph);
    let (acceleration, section) = accelerations(model, &coordinates, &dense, graph);
    let x_dot = graph.substitute(&equations.x_dot, &motion.substitution);
    let values = motion.rate.iter().chain(&acceleration).chain(&x_dot);
    let rate = Function { sections: vec![section], results: stored("dx", values) };
    let names: Vec<String> =
        coordinates.unknowns.iter().map(|&unknown| inertia::name(model, unknown)).collect();
    let parts =
        names.iter().map(|name| name.rsplit_once('.').map_or(name.as_str(), |split| split.0).to_owned());
    Ok(Reduced {
        parts: parts.collect(),
        names,
        angles: coordinates.unknowns.iter().map(|unknown| matches!(unknown, Unknown::Angle { .. })).collect(),
        rate: rate.optimise(graph),
        pose: pose(model, &coordinates, &motion, graph).optimise(graph),
        project: project(model, equations, &coordinates, graph).optimise(graph),
        y: motion.value,
        y_dot: motion.rate,
    })
}

fn stored<'a>(array: &'static str, values: impl Iterator<Item = &'a Expr>) -> Vec<(Place, Expr)> {
    values.enumerate().map(|(k, &value)| (Place::Element(array, k), value)).collect()
}

/// Applied forces and torques at each G, without gravity, as functions of the coordinates.
fn loads(model: &Model, motion: &Motion, graph: &mut Graph) -> Vec<[Expr; 3]> {
    let mut terms: Vec<[Vec<Expr>; 3]> = vec![Default::default(); model.bodies.len()];
    for load in &model.loads {
        for (sum, &component) in terms[load.body].iter_mut().zip(&load.force) {
            sum.push(component);
        }
    }
    let sums: Vec<Expr> = terms.iter().flatten().map(|sum| graph.sum(sum)).collect();
    let sums = graph.substitute(&sums, &motion.substitution);
    sums.chunks_exact(3).map(|sum| [sum[0], sum[1], sum[2]]).collect()
}

/// Solves `M a = Q`, and how a person would write that down.
fn accelerations(
    model: &Model,
    coordinates: &Coordinates,
    dense: &Dense,
    graph: &mut Graph,
) -> (Vec<Expr>, Section) {
    let names: Vec<String> = coordinates
        .unknowns
        .iter()
        .map(|&unknown| format!("{}_acceleration", inertia::name(model, unknown)))
        .collect();
    let mut mass = dense.mass.clone();
    for (&(i, j), entry) in &mut mass {
        *entry = graph.define(&format!("m_{i}_{j}"), *entry);
    }
    let force: Vec<Expr> = dense
        .force
        .iter()
        .enumerate()
        .map(|(i, &force)| graph.define(&format!("force_{i}"), force))
        .collect();
    let mut roots: Vec<Expr> = mass.values().copied().chain(force.iter().copied()).collect();
    let at = |key| mass.get(&key).copied();
    let solution = match (force.as_slice(), at((1, 0))) {
        (&[], _) => Vec::new(),
        (&[one], _) => vec![graph.div(one, mass[&(0, 0)])],
        // One division instead of two in a row.
        (&[first, second], Some(coupling)) => {
            let (m00, m11) = (mass[&(0, 0)], mass[&(1, 1)]);
            let numerators = [
                minor(graph, [first, coupling], [second, m11]),
                minor(graph, [m00, first], [coupling, second]),
            ];
            let determinant = minor(graph, [m00, coupling], [coupling, m11]);
            let one = graph.one();
            let reciprocal = graph.div(one, determinant);
            let reciprocal = graph.define("reciprocal", reciprocal);
            numerators.iter().map(|&numerator| graph.mul(numerator, reciprocal)).collect()
        }
        _ => {
            let factor = factorise(graph, force.len(), &mass);
            let (solution, trace) = factor.solve(graph, &force, &names);
            roots.extend(factor.trace);
            roots.extend(trace);
            solution
        }
    };
    let named = solution.iter().zip(&names).map(|(&value, name)| graph.define(name, value));
    (named.collect(), Section::new("Masses and forces along the coordinates: M a = Q", roots))
}

/// Determinant of two rows.
fn minor(graph: &mut Graph, a: [Expr; 2], b: [Expr; 2]) -> Expr {
    plane::cross(graph, a, b)
}

/// Pose and velocity of every body.
fn pose(model: &Model, coordinates: &Coordinates, motion: &Motion, graph: &mut Graph) -> Function {
    let (mut q, mut v) = (Vec::new(), Vec::new());
    for body in 0..model.bodies.len() {
        let heading = coordinates.headings[body];
        q.extend(motion.position[body]);
        q.push(motion.angle(coordinates, graph, heading));
        v.extend(motion.velocity[body]);
        v.push(motion.omega[heading.class]);
    }
    let mut results = stored("q", q.iter());
    results.extend(stored("v", v.iter()));
    Function::of_results(results)
}

/// The coordinates and their rates at a pose.
fn project(model: &Model, equations: &Equations, coordinates: &Coordinates, graph: &mut Graph) -> Function {
    let values: Vec<Expr> = coordinates
        .unknowns
        .iter()
        .map(|&unknown| motion::of_pose(model, coordinates, graph, unknown))
        .collect();
    let mut flow: Vec<(Expr, Expr)> = equations.q.iter().copied().zip(equations.v.iter().copied()).collect();
    flow.push((model.time, graph.one()));
    let rates = graph.directionals(&values, &flow);
    Function::of_results(stored("x", values.iter().chain(&rates)))
}
