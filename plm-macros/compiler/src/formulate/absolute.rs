//! Rung 5: absolute coordinates and multipliers.
//!
//! With `Y = phi_q M^-1` the multipliers solve `(Y phi_q^T) lambda = Y Q - gamma`, and `a = M^-1 Q - Y^T lambda`
//! (J. Garcia de Jalon, E. Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994, section 5.1). Baumgarte's
//! method replaces `gamma` by `gamma - 2 alpha phi_dot - beta^2 phi`
//! (J. Baumgarte, Comput. Methods Appl. Mech. Eng. 1, 1972, eq. (2.7)).

use std::collections::BTreeSet;

use plm_cas::{Expr, Graph};

use super::feedback;
use super::function::{Function, Place, Section};
use super::ldl::{Factor, Symmetric, factorise};
use super::order::minimum_degree;
use super::outputs::{self, Outputs};
use super::sides;
use crate::derive::{Equations, SparseRow};
use crate::model::{Model, Stabilisation};

/// Everything that rung 5 computes.
#[derive(Debug)]
pub(crate) struct Absolute {
    /// `dx` and `lambda`, returning Health: the right-hand side.
    pub(crate) dynamics: Function,
    /// `phi`.
    pub(crate) phi: Function,
    /// `phi_dot`.
    pub(crate) phi_dot: Function,
    /// Non-zero entries of `phi_q`, row by row.
    pub(crate) phi_q: Function,
    /// `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`, returning Health.
    pub(crate) min_norm: Function,
    /// `inverse_mass`.
    pub(crate) inverse_mass: Function,
    /// `force` and `gamma`, for the rank-revealing fallback.
    pub(crate) free: Function,
    /// Rates of the first-order states alone, for the fallback.
    pub(crate) x_dot: Function,
    /// `force` and `x_dot` without accelerations, in which multipliers are unknowns: for equilibria.
    pub(crate) at_rest: Function,
    /// `g`, the guards of conditions.
    pub(crate) guards: Function,
    /// `at` and `slope` of conditions that depend on the time alone.
    pub(crate) instants: Function,
    /// `jump`: what rows do where conditions change, five terms each.
    pub(crate) jumps: Function,
    /// What the user reads.
    pub(crate) outputs: Outputs,
    /// Symbols of the weights of [`Absolute::min_norm`].
    pub(crate) weights: Vec<Expr>,
    /// Symbols of its residual.
    pub(crate) residual: Vec<Expr>,
}

/// Lays out rung 5.
pub(crate) fn formulate(model: &Model, equations: &Equations, graph: &mut Graph) -> Absolute {
    let weights: Vec<Expr> = (0..equations.q.len()).map(|k| graph.symbol(&format!("w_{k}"))).collect();
    let residual: Vec<Expr> =
        (0..equations.phi.len()).map(|k| graph.symbol(&format!("residual_{k}"))).collect();
    let stored = |array: &'static str, values: &[Expr]| -> Vec<(Place, Expr)> {
        values.iter().enumerate().map(|(k, &value)| (Place::Element(array, k), value)).collect()
    };
    let entries: Vec<Expr> = equations.phi_q.iter().flatten().map(|&(_, entry)| entry).collect();
    let phi_q = Function::of_results(stored("phi_q", &entries));
    let one = graph.one();
    let inverse_mass: Vec<Expr> = equations.mass.iter().map(|&mass| graph.div(one, mass)).collect();
    let motion = motion(model, equations, &inverse_mass, graph);
    // What the unknowns do to forces and rates elsewhere.
    let read = motion.read.clone();
    let x_dot = graph.substitute(&equations.x_dot, &read);
    let mut free = stored("force", &equations.force);
    free.extend(stored("gamma", &stabilised(model, equations, graph)));
    // Assembly and projection hold no sides.
    let released = |function: Function, graph: &mut Graph| function.substitute(&model.released, graph);
    let functions = Absolute {
        dynamics: dynamics(equations, &x_dot, motion),
        phi: released(Function::of_results(stored("phi", &equations.phi)), graph),
        phi_dot: released(Function::of_results(stored("phi_dot", &equations.phi_dot)), graph),
        phi_q: released(phi_q, graph),
        min_norm: released(min_norm(equations, (&weights, &residual), model.most_growth, graph), graph),
        jumps: sides::jumps(model, graph),
        inverse_mass: Function::of_results(stored("inverse_mass", &inverse_mass)),
        free: Function::of_results(free),
        x_dot: Function::of_results(stored("x_dot", &x_dot)),
        at_rest: at_rest(equations, graph),
        guards: sides::guards(model, &[], graph),
        instants: sides::instants(model, graph),
        outputs: outputs::formulate(model, equations, &read, graph),
        weights,
        residual,
    };
    functions.optimise(graph)
}

/// Does the elimination of `phi_q W phi_q^T` take more products than `most`? Two rows meet where both hold a coordinate.
pub(crate) fn eliminates_beyond(most: usize, equations: &Equations) -> bool {
    let mut holding = vec![Vec::new(); equations.q.len()];
    for (row, entries) in equations.phi_q.iter().enumerate() {
        for &(column, _) in entries {
            holding[column].push(row);
        }
    }
    let mut near = vec![BTreeSet::new(); equations.phi_q.len()];
    for rows in &holding {
        for &row in rows {
            near[row].extend(rows.iter().copied().filter(|&other| other != row));
        }
    }
    let mut products = 0;
    minimum_degree(near).any(|(_, below)| {
        products += below.len() * (below.len() + 1) / 2;
        products > most
    })
}

impl Absolute {
    fn optimise(self, graph: &mut Graph) -> Absolute {
        Absolute {
            dynamics: self.dynamics.optimise(graph),
            phi: self.phi.optimise(graph),
            phi_dot: self.phi_dot.optimise(graph),
            phi_q: self.phi_q.optimise(graph),
            min_norm: self.min_norm.optimise(graph),
            inverse_mass: self.inverse_mass.optimise(graph),
            free: self.free.optimise(graph),
            x_dot: self.x_dot.optimise(graph),
            at_rest: self.at_rest.optimise(graph),
            ..self
        }
    }
}

/// All forces, those that read multipliers included, and the rates, where nothing accelerates.
fn at_rest(equations: &Equations, graph: &mut Graph) -> Function {
    let mut force = equations.force.clone();
    for signal in &equations.signals {
        for &(k, gain) in &signal.gain {
            let added = graph.mul(gain, signal.symbol);
            force[k] = graph.add(force[k], added);
        }
    }
    let count = force.len();
    let mut values = force;
    values.extend(&equations.x_dot);
    let zero = graph.zero();
    let rest: Vec<(Expr, Expr)> = equations.a.iter().map(|&a| (a, zero)).collect();
    let values = graph.substitute(&values, &rest);
    let places = (0..count).map(|k| Place::Element("force", k));
    let places = places.chain((0..equations.x.len()).map(|k| Place::Element("x_dot", k)));
    Function::of_results(places.zip(values).collect())
}

/// `gamma`, with Baumgarte's feedback where the model asks for it.
fn stabilised(model: &Model, equations: &Equations, graph: &mut Graph) -> Vec<Expr> {
    let Stabilisation::Baumgarte(tau) = model.stabilisation else { return equations.gamma.clone() };
    let one = graph.one();
    let alpha = graph.div(one, tau);
    let beta_squared = graph.mul(alpha, alpha);
    let alpha_twice = graph.add(alpha, alpha);
    let rows = equations.gamma.iter().zip(&equations.phi_dot).zip(&equations.phi);
    let feedback = |((&gamma, &phi_dot), &phi): ((&Expr, &Expr), &Expr)| {
        let damping = graph.mul(alpha_twice, phi_dot);
        let stiffness = graph.mul(beta_squared, phi);
        let sum = graph.add(damping, stiffness);
        graph.sub(gamma, sum)
    };
    rows.map(feedback).collect()
}

/// Accelerations and multipliers at a state.
struct Motion {
    acceleration: Vec<Expr>,
    lambda: Vec<Expr>,
    /// Unknowns that forces and rates read, and their values.
    read: Vec<(Expr, Expr)>,
    health: Expr,
    /// The order in which a person would write it down.
    sections: Vec<Section>,
}

/// Solves the equations of motion; forces that read the unknowns are solved along with them.
fn motion(model: &Model, equations: &Equations, inverse_mass: &[Expr], graph: &mut Graph) -> Motion {
    let (system, scaled) = normal_matrix(equations, inverse_mass, graph);
    let factor = factorise(graph, equations.phi.len(), &system, Some(model.most_growth));
    let gamma = stabilised(model, equations, graph);
    let solver = Solver { model, equations, scaled: &scaled, factor: &factor };
    let free = equations.force.iter().zip(inverse_mass).map(|(&force, &inverse)| graph.mul(force, inverse));
    let free: Vec<Expr> = free.collect();
    let mut solution = solver.solve(free, Some(&gamma), "", graph);
    let jacobian = equations.phi_q.iter().flatten().chain(scaled.iter().flatten());
    let mut sections = vec![
        Section::new(
            "Arms from G to each port: the entries of phi_q, and of phi_q M^-1",
            jacobian.map(|&(_, e)| e).collect(),
        ),
        Section::new("Accelerations without constraints, M^-1 Q", solution.free.clone()),
        Section::new("phi_q M^-1 phi_q^T = L D L^T", factor.trace.clone()),
        Section::new(
            "Multipliers: (phi_q M^-1 phi_q^T) lambda = phi_q M^-1 Q - gamma",
            std::mem::take(&mut solution.trace),
        ),
    ];
    let mut health = factor.health;
    if !equations.signals.is_empty() {
        let loops = solver.close(&mut solution, inverse_mass, graph);
        health = graph.min(health, loops.health);
        sections.push(Section::new("What forces read of the unknowns", loops.trace));
    }
    let mut held = equations.x_dot.clone();
    held.extend(equations.signals.iter().map(|signal| signal.symbol));
    let held = graph.symbols(&held);
    let unknowns = equations.a.iter().zip(&solution.acceleration);
    let unknowns = unknowns.chain(equations.lambda.iter().zip(&solution.lambda));
    let read =
        unknowns.filter(|(symbol, _)| held.contains(symbol)).map(|(&of, &value)| (of, value)).collect();
    Motion { acceleration: solution.acceleration, lambda: solution.lambda, read, health, sections }
}

/// The factors of the equations of motion.
struct Solver<'a> {
    model: &'a Model,
    equations: &'a Equations,
    /// `phi_q M^-1`
    scaled: &'a [SparseRow],
    factor: &'a Factor,
}

/// Accelerations and multipliers of one right-hand side.
struct Solution {
    free: Vec<Expr>,
    acceleration: Vec<Expr>,
    lambda: Vec<Expr>,
    trace: Vec<Expr>,
}

impl Solver<'_> {
    /// The motion under accelerations `free` that forces give without constraints.
    fn solve(&self, free: Vec<Expr>, gamma: Option<&[Expr]>, suffix: &str, graph: &mut Graph) -> Solution {
        let named = free.into_iter().enumerate().map(|(k, value)| {
            let name = format!("free_{}{suffix}", coordinate_name(self.model, k));
            graph.define(&name, value)
        });
        let free: Vec<Expr> = named.collect();
        let rhs = self.equations.phi_q.iter().enumerate().map(|(i, row)| {
            let mut terms: Vec<Expr> = row.iter().map(|&(j, entry)| graph.mul(entry, free[j])).collect();
            terms.extend(gamma.map(|gamma| graph.neg(gamma[i])));
            graph.sum(&terms)
        });
        let rhs: Vec<Expr> = rhs.collect();
        let names: Vec<String> =
            self.model.rows.iter().map(|row| format!("lambda_{}{suffix}", row.name)).collect();
        let (lambda, trace) = self.factor.solve(graph, &rhs, &names);
        let acceleration = back_substituted(&free, self.scaled, &lambda, graph);
        Solution { free, acceleration, lambda, trace }
    }

    /// Adds what the signals do to a motion without them.
    fn close(&self, motion: &mut Solution, inverse_mass: &[Expr], graph: &mut Graph) -> feedback::Solved {
        let signals = &self.equations.signals;
        let units = signals.iter().enumerate().map(|(k, signal)| {
            let mut free = vec![graph.zero(); inverse_mass.len()];
            for &(j, gain) in &signal.gain {
                free[j] = graph.mul(gain, inverse_mass[j]);
            }
            self.solve(free, None, &format!("_of_signal_{k}"), graph)
        });
        let units: Vec<Solution> = units.collect();
        let read = |solution: &Solution| -> Vec<Expr> {
            signals.iter().map(|signal| self.value_of(signal.symbol, solution)).collect()
        };
        let columns: Vec<Vec<Expr>> = units.iter().map(read).collect();
        let mut solved = feedback::solve(&read(motion), &columns, graph);
        let mut trace: Vec<Expr> = units.iter().flat_map(|unit| unit.trace.iter().copied()).collect();
        trace.append(&mut solved.trace);
        solved.trace = trace;
        let add = |sum: &mut Vec<Expr>, of: &dyn Fn(&Solution) -> &Vec<Expr>, graph: &mut Graph| {
            for (k, value) in sum.iter_mut().enumerate() {
                let mut terms = vec![*value];
                for (unit, &signal) in units.iter().zip(&solved.signals) {
                    terms.push(graph.mul(of(unit)[k], signal));
                }
                *value = graph.sum(&terms);
            }
        };
        add(&mut motion.acceleration, &|unit| &unit.acceleration, graph);
        add(&mut motion.lambda, &|unit| &unit.lambda, graph);
        solved
    }

    /// The value of an unknown in a solution.
    fn value_of(&self, symbol: Expr, solution: &Solution) -> Expr {
        let Equations { a, lambda, .. } = self.equations;
        let accelerations = a.iter().zip(&solution.acceleration);
        let mut pairs = accelerations.chain(lambda.iter().zip(&solution.lambda));
        pairs.find(|(of, _)| **of == symbol).map_or(symbol, |(_, value)| *value)
    }
}

/// The right-hand side.
fn dynamics(equations: &Equations, x_dot: &[Expr], motion: Motion) -> Function {
    let nq = equations.q.len();
    let mut results: Vec<(Place, Expr)> = Vec::new();
    let mut put = |array: &'static str, from: usize, values: &[Expr]| {
        results.extend(values.iter().enumerate().map(|(k, &value)| (Place::Element(array, from + k), value)));
    };
    put("dx", 0, &equations.v);
    put("dx", nq, &motion.acceleration);
    put("dx", 2 * nq, x_dot);
    put("lambda", 0, &motion.lambda);
    results.push((Place::Value, motion.health));
    Function { sections: motion.sections, results }
}

/// `a = M^-1 Q - Y^T lambda`.
fn back_substituted(free: &[Expr], scaled: &[SparseRow], lambda: &[Expr], graph: &mut Graph) -> Vec<Expr> {
    let mut terms: Vec<Vec<Expr>> = free.iter().map(|&a| vec![a]).collect();
    for (row, &multiplier) in scaled.iter().zip(lambda) {
        for &(j, entry) in row {
            let product = graph.mul(entry, multiplier);
            terms[j].push(graph.neg(product));
        }
    }
    terms.iter().map(|sum| graph.sum(sum)).collect()
}

/// `phi_q diag(scale) phi_q^T` by its lower entries, and `phi_q diag(scale)`.
fn normal_matrix(equations: &Equations, scale: &[Expr], graph: &mut Graph) -> (Symmetric, Vec<SparseRow>) {
    let mut by_column: Vec<Vec<(usize, Expr)>> = vec![Vec::new(); scale.len()];
    let mut scaled: Vec<SparseRow> = Vec::with_capacity(equations.phi_q.len());
    for (i, row) in equations.phi_q.iter().enumerate() {
        let mut scaled_row = SparseRow::with_capacity(row.len());
        for &(j, entry) in row {
            let product = graph.mul(entry, scale[j]);
            let product = graph.define(&format!("y_{i}_{j}"), product);
            scaled_row.push((j, product));
            by_column[j].push((i, entry));
        }
        scaled.push(scaled_row);
    }
    let mut terms: std::collections::BTreeMap<(usize, usize), Vec<Expr>> = std::collections::BTreeMap::new();
    for (i, row) in scaled.iter().enumerate() {
        for &(j, left) in row {
            for &(k, right) in by_column[j].iter().filter(|&&(k, _)| k <= i) {
                terms.entry((i, k)).or_default().push(graph.mul(left, right));
            }
        }
    }
    let mut system: Symmetric = terms.into_iter().map(|(key, sum)| (key, graph.sum(&sum))).collect();
    system.retain(|&(i, k), entry| i == k || !graph.is_zero(*entry));
    for i in 0..equations.phi.len() {
        system.entry((i, i)).or_insert_with(|| graph.zero());
    }
    (system, scaled)
}

/// The weighted minimum-norm step that closes a residual: the Newton step of assembly (weights 0 and 1) and of
/// projection (weights 1 / mass).
fn min_norm(
    equations: &Equations,
    (weights, residual): (&[Expr], &[Expr]),
    most_growth: Expr,
    graph: &mut Graph,
) -> Function {
    let (system, scaled) = normal_matrix(equations, weights, graph);
    let factor = factorise(graph, equations.phi.len(), &system, Some(most_growth));
    let names: Vec<String> = (0..residual.len()).map(|k| format!("mu_{k}")).collect();
    let (mu, solution) = factor.solve(graph, residual, &names);
    let zero = vec![graph.zero(); weights.len()];
    let step = back_substituted(&zero, &scaled, &mu, graph);
    let mut results: Vec<(Place, Expr)> = Vec::with_capacity(step.len() + 1);
    for (k, &value) in step.iter().enumerate() {
        results.push((Place::Element("dq", k), graph.neg(value)));
    }
    results.push((Place::Value, factor.health));
    let sections = vec![
        Section::new("phi_q W phi_q^T = L D L^T", factor.trace.clone()),
        Section::new("(phi_q W phi_q^T) mu = r", solution),
    ];
    Function { sections, results }
}

/// `arm_x`, `arm_y`, `arm_angle` for the three coordinates of a body.
pub(crate) fn coordinate_name(model: &Model, k: usize) -> String {
    format!("{}.{}", model.bodies[k / 3].name.text, ["x", "y", "angle"][k % 3])
}
