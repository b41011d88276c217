//! Rung 5: absolute coordinates and multipliers.
//!
//! With `Y = phi_q M^-1` the multipliers solve `(Y phi_q^T) lambda = Y Q - gamma`, and `a = M^-1 Q - Y^T lambda`
//! (J. Garcia de Jalon, E. Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994, section 5.1). Baumgarte's
//! method replaces `gamma` by `gamma - 2 alpha phi_dot - beta^2 phi`
//! (J. Baumgarte, Comput. Methods Appl. Mech. Eng. 1, 1972, eq. (2.7)).

use plm_cas::{Expr, Graph};

use super::function::{Function, Place, Section};
use super::ldl::{Factor, Symmetric, factorise};
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
    /// Non-zero entries of `phi_q`.
    pub(crate) phi_q: Function,
    /// `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`, returning Health.
    pub(crate) min_norm: Function,
    /// `inverse_mass`.
    pub(crate) inverse_mass: Function,
    /// `force` and `gamma`, for the rank-revealing fallback.
    pub(crate) free: Function,
    /// Rates of the first-order states alone, for the fallback.
    pub(crate) x_dot: Function,
    /// `g`, the guards of conditions.
    pub(crate) guards: Function,
    /// `at` and `slope` of conditions that depend on the time alone.
    pub(crate) instants: Function,
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
    let entries = equations.phi_q.iter().enumerate();
    let entries =
        entries.flat_map(|(i, row)| row.iter().map(move |&(j, e)| (Place::Entry("phi_q", i, j), e)));
    let phi_q = Function::of_results(entries.collect());
    let one = graph.one();
    let inverse_mass: Vec<Expr> = equations.mass.iter().map(|&mass| graph.div(one, mass)).collect();
    let mut free = stored("force", &equations.force);
    free.extend(stored("gamma", &stabilised(model, equations, graph)));
    let functions = Absolute {
        dynamics: dynamics(model, equations, &inverse_mass, graph),
        phi: Function::of_results(stored("phi", &equations.phi)),
        phi_dot: Function::of_results(stored("phi_dot", &equations.phi_dot)),
        phi_q,
        min_norm: min_norm(equations, &weights, &residual, graph),
        inverse_mass: Function::of_results(stored("inverse_mass", &inverse_mass)),
        free: Function::of_results(free),
        x_dot: Function::of_results(stored("x_dot", &equations.x_dot)),
        guards: sides::guards(model, &[], graph),
        instants: sides::instants(model, graph),
        outputs: outputs::formulate(model, equations, graph),
        weights,
        residual,
    };
    functions.optimise(graph)
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
            ..self
        }
    }
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

/// The right-hand side: accelerations and multipliers at a state.
fn dynamics(model: &Model, equations: &Equations, inverse_mass: &[Expr], graph: &mut Graph) -> Function {
    let nq = equations.q.len();
    let free = equations.force.iter().zip(inverse_mass).enumerate().map(|(k, (&force, &inverse))| {
        let value = graph.mul(force, inverse);
        let name = format!("free_{}", coordinate_name(model, k));
        graph.define(&name, value)
    });
    let free: Vec<Expr> = free.collect();
    let (system, scaled) = normal_matrix(equations, inverse_mass, graph);
    let factor = factorise(graph, equations.phi.len(), &system);
    let gamma = stabilised(model, equations, graph);
    let rhs = equations.phi_q.iter().zip(&gamma).map(|(row, &gamma)| {
        let mut terms: Vec<Expr> = row.iter().map(|&(j, entry)| graph.mul(entry, free[j])).collect();
        terms.push(graph.neg(gamma));
        graph.sum(&terms)
    });
    let rhs: Vec<Expr> = rhs.collect();
    let names: Vec<String> = model.rows.iter().map(|row| format!("lambda_{}", row.name)).collect();
    let (lambda, solution) = factor.solve(graph, &rhs, &names);
    let acceleration = back_substituted(&free, &scaled, &lambda, graph);

    let mut results: Vec<(Place, Expr)> = Vec::new();
    results.extend(equations.v.iter().enumerate().map(|(k, &v)| (Place::Element("dx", k), v)));
    results.extend(acceleration.iter().enumerate().map(|(k, &a)| (Place::Element("dx", nq + k), a)));
    results.extend(
        equations.x_dot.iter().enumerate().map(|(k, &rate)| (Place::Element("dx", 2 * nq + k), rate)),
    );
    results.extend(lambda.iter().enumerate().map(|(k, &value)| (Place::Element("lambda", k), value)));
    results.push((Place::Value, factor.health));
    let sections = sections_of(equations, free, &scaled, &factor, solution);
    Function { sections, results }
}

/// The order in which a person would write the right-hand side down.
fn sections_of(
    equations: &Equations,
    free: Vec<Expr>,
    scaled: &[SparseRow],
    factor: &Factor,
    solution: Vec<Expr>,
) -> Vec<Section> {
    let jacobian = equations.phi_q.iter().flatten().chain(scaled.iter().flatten());
    vec![
        Section::new(
            "Arms from G to each port: the entries of phi_q, and of phi_q M^-1",
            jacobian.map(|&(_, e)| e).collect(),
        ),
        Section::new("Accelerations without constraints, M^-1 Q", free),
        Section::new("phi_q M^-1 phi_q^T = L D L^T", factor.trace.clone()),
        Section::new("Multipliers: (phi_q M^-1 phi_q^T) lambda = phi_q M^-1 Q - gamma", solution),
    ]
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
fn min_norm(equations: &Equations, weights: &[Expr], residual: &[Expr], graph: &mut Graph) -> Function {
    let (system, scaled) = normal_matrix(equations, weights, graph);
    let factor = factorise(graph, equations.phi.len(), &system);
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
