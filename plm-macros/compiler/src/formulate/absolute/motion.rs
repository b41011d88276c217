//! Accelerations and multipliers at a state, forces that read them included.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use super::feedback;
use super::normal::Normal;
use super::{coordinate_name, stabilised};
use crate::derive::Equations;
use crate::formulate::contact::{Accelerated, ContactFunctions, functions};
use crate::formulate::function::{Function, Place, Section, stored};
use crate::formulate::ldl::{Factor, factorise};
use crate::model::Model;

/// Accelerations and multipliers at a state.
pub(super) struct Motion {
    acceleration: Vec<Expr>,
    lambda: Vec<Expr>,
    /// Unknowns that forces and rates read, and their values.
    pub(super) read: Vec<(Expr, Expr)>,
    health: Expr,
    /// The order in which a person would write it down.
    sections: Vec<Section>,
}

/// Solves the equations of motion; forces that read the unknowns are solved along with them.
pub(super) fn motion(model: &Model, equations: &Equations, inverse_mass: &[Expr]) -> Motion {
    let normal = Normal::new(&equations.phi_q, inverse_mass);
    let factor = factorise(equations.phi.len(), &normal.s, Some(model.most_growth));
    let gamma = stabilised(model, equations);
    let solver = Solver { model, equations, normal: &normal, factor: &factor };
    let free = equations.force.iter().zip(inverse_mass).map(|(&force, &inverse)| force * inverse);
    let mut solution = solver.solve(free.collect_vec(), &gamma, "");
    let arms = equations.phi_q.iter().flatten().chain(normal.y.iter().flatten());
    let mut sections = vec![
        Section::new(
            "Arms from G to each port: the entries of phi_q, and of phi_q M^-1",
            arms.map(|&(_, entry)| entry).collect_vec(),
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
        let solved = solver.close(&mut solution, inverse_mass);
        health = health.min(solved.health);
        sections.push(Section::new("What forces read of the unknowns", solved.trace));
    }
    let mut readers = equations.x_dot.clone();
    readers.push_all(equations.signals.iter().map(|signal| signal.symbol));
    let held = algebra::symbols(&readers);
    let read = solution.unknowns(equations).filter(|(symbol, _)| held.contains(symbol)).collect_vec();
    Motion { acceleration: solution.acceleration, lambda: solution.lambda, read, health, sections }
}

impl Motion {
    /// The rows of contact.
    pub(super) fn contact(
        &self,
        model: &Model,
        equations: &Equations,
        x_dot: &[Expr],
    ) -> Option<ContactFunctions> {
        let mut rate = self.rate(equations, x_dot);
        rate.push((Place::Value, self.health));
        let (bodies, coordinates) = (&self.acceleration, self.acceleration.len());
        let (substitution, reactions, rate) = (&self.read, &self.lambda, &rate);
        let second = (0..coordinates).map(|k| Expr::symbol(format!("second_{k}"))).collect_vec();
        let (second, by_second) = (&second, reactions);
        let motion = Accelerated { bodies, rate, coordinates, substitution, reactions, second, by_second };
        functions(model, equations, &motion)
    }

    /// `dx = [v, a, x_dot]`.
    fn rate(&self, equations: &Equations, x_dot: &[Expr]) -> Vec<(Place, Expr)> {
        stored("dx", equations.v.iter().chain(&self.acceleration).chain(x_dot))
    }

    /// The right-hand side: `dx = [v, a, x_dot]` and `lambda`, returning Health.
    pub(super) fn dynamics(self, equations: &Equations, x_dot: &[Expr]) -> Function {
        let mut results = self.rate(equations, x_dot);
        results.extend(stored("lambda", self.lambda.iter()));
        results.push((Place::Value, self.health));
        Function { sections: self.sections, results }
    }
}

/// The factors of the equations of motion.
struct Solver<'a> {
    model: &'a Model,
    equations: &'a Equations,
    normal: &'a Normal,
    factor: &'a Factor,
}

/// Accelerations and multipliers of one right-hand side.
struct Solution {
    /// `M^-1 Q`
    free: Vec<Expr>,
    acceleration: Vec<Expr>,
    lambda: Vec<Expr>,
    /// Every step on the way to `lambda`.
    trace: Vec<Expr>,
}

impl Solution {
    /// The symbols of accelerations and multipliers, and their values.
    fn unknowns(&self, equations: &Equations) -> impl Iterator<Item = (Expr, Expr)> {
        let symbols = equations.a.iter().chain(&equations.lambda);
        symbols.copied().zip(self.acceleration.iter().chain(&self.lambda).copied())
    }

    /// Adds a multiple of another solution.
    fn add(&mut self, factor: Expr, other: &Solution) {
        let own = self.acceleration.iter_mut().chain(&mut self.lambda);
        for (own, &value) in own.zip(other.acceleration.iter().chain(&other.lambda)) {
            *own += value * factor;
        }
    }
}

impl Solver<'_> {
    /// The motion under accelerations `free = M^-1 Q` that forces give without constraints.
    fn solve(&self, free: Vec<Expr>, gamma: &[Expr], suffix: &str) -> Solution {
        let named = free.into_iter().enumerate().map(|(k, value)| {
            let coordinate = coordinate_name(self.model, k);
            value.named(format!("free_{coordinate}{suffix}"))
        });
        let free: Vec<Expr> = named.collect_vec();
        let rhs = self.equations.phi_q.iter().zip(gamma).map(|(row, &gamma)| {
            let of_free: Expr = row.iter().map(|&(j, entry)| entry * free[j]).sum();
            of_free - gamma // (2)
        });
        let rhs: Vec<Expr> = rhs.collect_vec();
        let rows = self.model.rows.iter();
        let names: Vec<String> = rows.map(|row| format!("lambda_{}{suffix}", row.name)).collect_vec();
        let (lambda, trace) = self.factor.solve(&rhs, &names);
        let held = self.normal.transposed(&lambda, free.len());
        let acceleration = free.iter().zip(held).map(|(&free, held)| free - held).collect_vec(); // (3)
        Solution { free, acceleration, lambda, trace }
    }

    /// Adds what the signals do to a motion without them.
    fn close(&self, motion: &mut Solution, inverse_mass: &[Expr]) -> feedback::Solved {
        let Equations { signals, phi, .. } = self.equations;
        let still = vec![Expr::ZERO; phi.len()];
        let units = signals.iter().enumerate().map(|(k, signal)| {
            let mut free = vec![Expr::ZERO; inverse_mass.len()];
            for &(j, gain) in &signal.gain {
                free[j] = gain * inverse_mass[j];
            }
            self.solve(free, &still, &format!("_of_signal_{k}"))
        });
        let units: Vec<Solution> = units.collect_vec();
        let read = |solution: &Solution| -> Vec<Expr> {
            let value = |symbol: Expr| solution.unknowns(self.equations).find(|of| of.0 == symbol);
            signals.iter().map(|signal| value(signal.symbol).map_or(signal.symbol, |of| of.1)).collect_vec()
        };
        let columns: Vec<Vec<Expr>> = units.iter().map(read).collect_vec();
        let mut solved = feedback::solve(read(motion), &columns);
        for (unit, &signal) in units.iter().zip(&solved.signals) {
            motion.add(signal, unit);
        }
        let of_units = units.into_iter().flat_map(|unit| unit.trace);
        solved.trace = of_units.chain(solved.trace).collect_vec();
        solved
    }
}
