//! Rung 5: absolute coordinates and multipliers.
//!
//! With `Y = phi_q M^-1` the multipliers solve `(Y phi_q^T) lambda = Y Q - gamma`, and `a = M^-1 Q - Y^T lambda`
//! (J. Garcia de Jalon, E. Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994, section 5.1). Baumgarte's
//! method replaces `gamma` by `gamma - 2 alpha phi_dot - beta^2 phi`
//! (J. Baumgarte, Comput. Methods Appl. Mech. Eng. 1, 1972, eq. (2.7)).

use std::collections::BTreeSet;

use plm_cas::{Expr, algebra};

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
pub(crate) fn formulate(model: &Model, equations: &Equations) -> Absolute {
    let weights: Vec<Expr> = (0..equations.q.len()).map(|k| Expr::symbol(format!("w_{k}"))).collect();
    let residual: Vec<Expr> =
        (0..equations.phi.len()).map(|k| Expr::symbol(format!("residual_{k}"))).collect();
    let stored = |array: &'static str, values: &[Expr]| -> Vec<(Place, Expr)> {
        values.iter().enumerate().map(|(k, &value)| (Place::Element(array, k), value)).collect()
    };
    let entries: Vec<Expr> = equations.phi_q.iter().flatten().map(|&(_, entry)| entry).collect();
    let phi_q = Function::of_results(stored("phi_q", &entries));
    let one = Expr::ONE;
    let inverse_mass: Vec<Expr> = equations.mass.iter().map(|&mass| one / mass).collect();
    let motion = motion(model, equations, &inverse_mass);
    // What the unknowns do to forces and rates elsewhere.
    let read = motion.read.clone();
    let x_dot = algebra::substitute(&equations.x_dot, &read);
    let mut free = stored("force", &equations.force);
    free.extend(stored("gamma", &stabilised(model, equations)));
    // Assembly and projection hold no sides.
    let released = |function: Function| function.substitute(&model.released);
    let functions = Absolute {
        dynamics: dynamics(equations, &x_dot, motion),
        phi: released(Function::of_results(stored("phi", &equations.phi))),
        phi_dot: released(Function::of_results(stored("phi_dot", &equations.phi_dot))),
        phi_q: released(phi_q),
        min_norm: released(min_norm(equations, (&weights, &residual), model.most_growth)),
        jumps: sides::jumps(model),
        inverse_mass: Function::of_results(stored("inverse_mass", &inverse_mass)),
        free: Function::of_results(free),
        x_dot: Function::of_results(stored("x_dot", &x_dot)),
        at_rest: at_rest(equations),
        guards: sides::guards(model, &[]),
        instants: sides::instants(model),
        outputs: outputs::formulate(model, equations, &read),
        weights,
        residual,
    };
    functions.optimise()
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
    fn optimise(self) -> Absolute {
        Absolute {
            dynamics: self.dynamics.optimise(),
            phi: self.phi.optimise(),
            phi_dot: self.phi_dot.optimise(),
            phi_q: self.phi_q.optimise(),
            min_norm: self.min_norm.optimise(),
            inverse_mass: self.inverse_mass.optimise(),
            free: self.free.optimise(),
            x_dot: self.x_dot.optimise(),
            at_rest: self.at_rest.optimise(),
            ..self
        }
    }
}

/// All forces, those that read multipliers included, and the rates, where nothing accelerates.
fn at_rest(equations: &Equations) -> Function {
    let mut force = equations.force.clone();
    for signal in &equations.signals {
        for &(k, gain) in &signal.gain {
            let added = gain * signal.symbol;
            force[k] += added;
        }
    }
    let count = force.len();
    let mut values = force;
    values.extend(&equations.x_dot);
    let zero = Expr::ZERO;
    let rest: Vec<(Expr, Expr)> = equations.a.iter().map(|&a| (a, zero)).collect();
    let values = algebra::substitute(&values, &rest);
    let places = (0..count).map(|k| Place::Element("force", k));
    let places = places.chain((0..equations.x.len()).map(|k| Place::Element("x_dot", k)));
    Function::of_results(places.zip(values).collect())
}

/// `gamma`, with Baumgarte's feedback where the model asks for it.
fn stabilised(model: &Model, equations: &Equations) -> Vec<Expr> {
    let Stabilisation::Baumgarte(tau) = model.stabilisation else { return equations.gamma.clone() };
    let one = Expr::ONE;
    let alpha = one / tau;
    let beta_squared = alpha * alpha;
    let alpha_twice = alpha + alpha;
    let rows = equations.gamma.iter().zip(&equations.phi_dot).zip(&equations.phi);
    let feedback = |((&gamma, &phi_dot), &phi): ((&Expr, &Expr), &Expr)| {
        let damping = alpha_twice * phi_dot;
        let stiffness = beta_squared * phi;
        let sum = damping + stiffness;
        gamma - sum
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
fn motion(model: &Model, equations: &Equations, inverse_mass: &[Expr]) -> Motion {
    let (system, scaled) = normal_matrix(equations, inverse_mass);
    let factor = factorise(equations.phi.len(), &system, Some(model.most_growth));
    let gamma = stabilised(model, equations);
    let solver = Solver { model, equations, scaled: &scaled, factor: &factor };
    let free = equations.force.iter().zip(inverse_mass).map(|(&force, &inverse)| force * inverse);
    let free: Vec<Expr> = free.collect();
    let mut solution = solver.solve(free, Some(&gamma), "");
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
        let loops = solver.close(&mut solution, inverse_mass);
        health = health.min(loops.health);
        sections.push(Section::new("What forces read of the unknowns", loops.trace));
    }
    let mut held = equations.x_dot.clone();
    held.extend(equations.signals.iter().map(|signal| signal.symbol));
    let held = algebra::symbols(&held);
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
    fn solve(&self, free: Vec<Expr>, gamma: Option<&[Expr]>, suffix: &str) -> Solution {
        let named = free.into_iter().enumerate().map(|(k, value)| {
            let name = format!("free_{}{suffix}", coordinate_name(self.model, k));
            value.named(&name)
        });
        let free: Vec<Expr> = named.collect();
        let rhs = self.equations.phi_q.iter().enumerate().map(|(i, row)| {
            let mut terms: Vec<Expr> = row.iter().map(|&(j, entry)| entry * free[j]).collect();
            terms.extend(gamma.map(|gamma| -gamma[i]));
            algebra::sum(&terms)
        });
        let rhs: Vec<Expr> = rhs.collect();
        let names: Vec<String> =
            self.model.rows.iter().map(|row| format!("lambda_{}{suffix}", row.name)).collect();
        let (lambda, trace) = self.factor.solve(&rhs, &names);
        let acceleration = back_substituted(&free, self.scaled, &lambda);
        Solution { free, acceleration, lambda, trace }
    }

    /// Adds what the signals do to a motion without them.
    fn close(&self, motion: &mut Solution, inverse_mass: &[Expr]) -> feedback::Solved {
        let signals = &self.equations.signals;
        let units = signals.iter().enumerate().map(|(k, signal)| {
            let mut free = vec![Expr::ZERO; inverse_mass.len()];
            for &(j, gain) in &signal.gain {
                free[j] = gain * inverse_mass[j];
            }
            self.solve(free, None, &format!("_of_signal_{k}"))
        });
        let units: Vec<Solution> = units.collect();
        let read = |solution: &Solution| -> Vec<Expr> {
            signals.iter().map(|signal| self.value_of(signal.symbol, solution)).collect()
        };
        let columns: Vec<Vec<Expr>> = units.iter().map(read).collect();
        let mut solved = feedback::solve(&read(motion), &columns);
        let mut trace: Vec<Expr> = units.iter().flat_map(|unit| unit.trace.iter().copied()).collect();
        trace.append(&mut solved.trace);
        solved.trace = trace;
        let add = |sum: &mut Vec<Expr>, of: &dyn Fn(&Solution) -> &Vec<Expr>| {
            for (k, value) in sum.iter_mut().enumerate() {
                let mut terms = vec![*value];
                for (unit, &signal) in units.iter().zip(&solved.signals) {
                    terms.push(of(unit)[k] * signal);
                }
                *value = algebra::sum(&terms);
            }
        };
        add(&mut motion.acceleration, &|unit| &unit.acceleration);
        add(&mut motion.lambda, &|unit| &unit.lambda);
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
fn back_substituted(free: &[Expr], scaled: &[SparseRow], lambda: &[Expr]) -> Vec<Expr> {
    let mut terms: Vec<Vec<Expr>> = free.iter().map(|&a| vec![a]).collect();
    for (row, &multiplier) in scaled.iter().zip(lambda) {
        for &(j, entry) in row {
            let product = entry * multiplier;
            terms[j].push(-product);
        }
    }
    terms.iter().map(|sum| algebra::sum(sum)).collect()
}

/// `phi_q diag(scale) phi_q^T` by its lower entries, and `phi_q diag(scale)`.
fn normal_matrix(equations: &Equations, scale: &[Expr]) -> (Symmetric, Vec<SparseRow>) {
    let mut by_column: Vec<Vec<(usize, Expr)>> = vec![Vec::new(); scale.len()];
    let mut scaled: Vec<SparseRow> = Vec::with_capacity(equations.phi_q.len());
    for (i, row) in equations.phi_q.iter().enumerate() {
        let mut scaled_row = SparseRow::with_capacity(row.len());
        for &(j, entry) in row {
            let product = entry * scale[j];
            let product = product.named(format!("y_{i}_{j}"));
            scaled_row.push((j, product));
            by_column[j].push((i, entry));
        }
        scaled.push(scaled_row);
    }
    let mut terms: std::collections::BTreeMap<(usize, usize), Vec<Expr>> = std::collections::BTreeMap::new();
    for (i, row) in scaled.iter().enumerate() {
        for &(j, left) in row {
            for &(k, right) in by_column[j].iter().filter(|&&(k, _)| k <= i) {
                terms.entry((i, k)).or_default().push(left * right);
            }
        }
    }
    let mut system: Symmetric = terms.into_iter().map(|(key, sum)| (key, algebra::sum(&sum))).collect();
    system.retain(|&(i, k), entry| i == k || !(*entry).is_zero());
    for i in 0..equations.phi.len() {
        system.entry((i, i)).or_insert_with(|| Expr::ZERO);
    }
    (system, scaled)
}

/// The weighted minimum-norm step that closes a residual: the Newton step of assembly (weights 0 and 1) and of
/// projection (weights 1 / mass).
fn min_norm(equations: &Equations, (weights, residual): (&[Expr], &[Expr]), most_growth: Expr) -> Function {
    let (system, scaled) = normal_matrix(equations, weights);
    let factor = factorise(equations.phi.len(), &system, Some(most_growth));
    let names: Vec<String> = (0..residual.len()).map(|k| format!("mu_{k}")).collect();
    let (mu, solution) = factor.solve(residual, &names);
    let zero = vec![Expr::ZERO; weights.len()];
    let step = back_substituted(&zero, &scaled, &mu);
    let mut results: Vec<(Place, Expr)> = Vec::with_capacity(step.len() + 1);
    for (k, &value) in step.iter().enumerate() {
        results.push((Place::Element("dq", k), -value));
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
