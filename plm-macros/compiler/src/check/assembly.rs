//! Assembly of the declared start at compile time (manual, section 4.4), the compiler's twin of the runtime's.
//!
//! Positions: `q <- q - pinv(phi_q) phi` in SI with unit weights from the user's start; a lock takes its column out.
//! Velocities: one step of the same kind from the start velocities.

use plm_cas::{Expr, Tape, algebra};

use super::branch;
use super::pseudo_inverse;
use super::rank::{Rank, Row, rank};
use crate::derive::Equations;
use crate::formulate::Absolute;
use crate::model::{Body, Model};

/// Largest residual of an assembled mechanism: of a row in m as a part of the size of the scene, of one in rad as it is.
const CLOSED: f64 = 1e-10;
/// Newton steps before assembly is given up; a start in reach needs four to eight.
const MOST_STEPS: usize = 100;
/// Below this ratio of pivots the straight-line step is replaced by the rank-revealing one.
const HEALTHY: f64 = 1e-6;

/// What assembly found.
#[derive(Debug)]
pub(crate) struct Assembly {
    /// The start of the user, at G.
    pub(crate) start: Vec<f64>,
    /// The assembled pose.
    pub(crate) q: Vec<f64>,
    /// The velocities that go with it.
    pub(crate) v: Vec<f64>,
    /// Which coordinates are locked.
    pub(crate) locked: Vec<bool>,
    /// Which velocities are locked.
    pub(crate) velocity_locked: Vec<bool>,
    /// Rank of `[phi_q; E]` and its dependent rows; locks come behind the constraints.
    pub(crate) rank: Rank,
    /// Rank with the velocity locks.
    pub(crate) velocity_rank: Rank,
    /// `phi` at the end.
    pub(crate) phi: Vec<f64>,
    /// `phi_q v - nu` at the end, velocity locks behind.
    pub(crate) phi_dot: Vec<f64>,
    /// Largest residual of each row that counts as closed, m or rad.
    pub(super) closed: Vec<f64>,
    /// Newton steps taken.
    pub(crate) steps: usize,
}

impl Assembly {
    /// Do all constraints hold?
    pub(crate) fn is_closed(&self) -> bool {
        are_closed(&self.phi, &self.closed)
    }

    /// Values of all symbols at the assembled pose.
    pub(crate) fn values(&self, equations: &Equations, others: &[(Expr, f64)]) -> Vec<(Expr, f64)> {
        let mut values = others.to_vec();
        values.extend(equations.q.iter().copied().zip(self.q.iter().copied()));
        values.extend(equations.v.iter().copied().zip(self.v.iter().copied()));
        values
    }

    /// Do the velocities obey the constraints?
    pub(crate) fn moves_consistently(&self) -> bool {
        let speed = self.v.iter().fold(1.0_f64, |largest, v| largest.max(v.abs()));
        self.phi_dot.iter().all(|residual| residual.abs() <= 1e-9 * speed)
    }
}

/// Assembles the declared start. `values` binds every symbol but coordinates and velocities.
pub(crate) fn assemble(
    model: &Model,
    equations: &Equations,
    program: &Absolute,
    values: &[(Expr, f64)],
) -> Assembly {
    let scene = Scene::new(equations, program, values);
    let (start, locked) = start_position(model, values);
    let length = crate::report::length(model, values);
    let limits = |q: &[f64]| limits(model, length, q);
    let closed = scene.close(start.clone(), &locked, &limits);
    let asked = branch::asked(model, equations, values);
    let (q, phi, steps) = branch::find(&asked, closed, (&start, &locked), |q| {
        let (q, phi, steps) = scene.close(q, &locked, &limits);
        are_closed(&phi, &limits(&q)).then_some((q, phi, steps))
    });
    let (mut v, velocity_locked) = start_velocity(model, values, &q);
    let residual = scene.phi_dot(&q, &v);
    for (velocity, dv) in v.iter_mut().zip(scene.step(&q, &velocity_locked, &residual)) {
        *velocity -= dv;
    }
    let at_start = rank_with_locks(&scene, &start, &locked);
    let at_end = rank_with_locks(&scene, &q, &locked);
    Assembly {
        // A pose of zeros can look singular: the better of the two ranks is the true one.
        rank: if at_end.value() >= at_start.value() { at_end } else { at_start },
        velocity_rank: rank_with_locks(&scene, &q, &velocity_locked),
        phi_dot: scene.phi_dot(&q, &v),
        closed: limits(&q),
        start,
        q,
        v,
        locked,
        velocity_locked,
        phi,
        steps,
    }
}

/// What the residual of each row may be in a scene of a size that reaches as far as the bodies stand.
fn limits(model: &Model, length: f64, q: &[f64]) -> Vec<f64> {
    let places = q.iter().enumerate().filter(|(k, _)| k % 3 != 2);
    let reach = places.fold(length, |reach, (_, place)| reach.max(place.abs()));
    model.rows.iter().map(|row| CLOSED * if row.is_angular() { 1.0 } else { reach }).collect()
}

pub(super) fn are_closed(phi: &[f64], limits: &[f64]) -> bool {
    phi.iter().zip(limits).all(|(residual, limit)| residual.abs() <= *limit)
}

/// Largest magnitude; infinite if a value is not a number.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, v| if v.is_nan() { f64::INFINITY } else { v.abs().max(largest) })
}

fn rank_with_locks(scene: &Scene, q: &[f64], locked: &[bool]) -> Rank {
    let mut rows = scene.phi_q(q);
    rows.extend(locked.iter().enumerate().filter(|(_, lock)| **lock).map(|(k, _)| vec![(k, 1.0)]));
    rank(&rows)
}

/// The constraints as numeric functions of the pose.
pub(super) struct Scene<'a> {
    equations: &'a Equations,
    program: &'a Absolute,
    values: &'a [(Expr, f64)],
    phi: Tape,
    phi_q: Tape,
    phi_dot: Tape,
    min_norm: Tape,
}

impl<'a> Scene<'a> {
    pub(super) fn new(
        equations: &'a Equations,
        program: &'a Absolute,
        values: &'a [(Expr, f64)],
    ) -> Scene<'a> {
        let tape = |function: &crate::formulate::Function| {
            let results: Vec<Expr> = function.results.iter().map(|&(_, value)| value).collect();
            algebra::tape(&results)
        };
        Scene {
            equations,
            program,
            values,
            phi: tape(&program.phi),
            phi_q: tape(&program.phi_q),
            phi_dot: tape(&program.phi_dot),
            min_norm: tape(&program.min_norm),
        }
    }

    /// All symbols at a pose.
    fn at(&self, q: &[f64]) -> Vec<(Expr, f64)> {
        let mut values = self.values.to_vec();
        values.extend(self.equations.q.iter().copied().zip(q.iter().copied()));
        values
    }

    fn phi(&self, q: &[f64]) -> Vec<f64> {
        run(&self.phi, &self.at(q))
    }

    fn phi_dot(&self, q: &[f64], v: &[f64]) -> Vec<f64> {
        let mut values = self.at(q);
        values.extend(self.equations.v.iter().copied().zip(v.iter().copied()));
        run(&self.phi_dot, &values)
    }

    pub(super) fn phi_q(&self, q: &[f64]) -> Vec<Row> {
        let entries = run(&self.phi_q, &self.at(q));
        let mut entries = entries.into_iter();
        let rows = self.equations.phi_q.iter();
        rows.map(|row| row.iter().map(|&(j, _)| j).zip(entries.by_ref()).collect()).collect()
    }

    /// Newton's steps from a pose: where they end, the residuals there, and how many they were.
    pub(super) fn close(
        &self,
        mut q: Vec<f64>,
        locked: &[bool],
        limits: &dyn Fn(&[f64]) -> Vec<f64>,
    ) -> (Vec<f64>, Vec<f64>, usize) {
        let mut phi = self.phi(&q);
        let mut steps = 0;
        let mut best = (q.clone(), phi.clone());
        while !are_closed(&phi, &limits(&q)) && steps < MOST_STEPS {
            let step = self.step(&q, locked, &phi);
            if !step.iter().all(|dq| dq.is_finite()) {
                break;
            }
            for (coordinate, dq) in q.iter_mut().zip(step) {
                *coordinate -= dq;
            }
            phi = self.phi(&q);
            steps += 1;
            if largest(&phi) < largest(&best.1) {
                best = (q.clone(), phi.clone());
            }
        }
        // Joints that do not fit make the steps wander; the pose that is told is the one that fits best.
        if largest(&best.1) < largest(&phi) {
            (q, phi) = best;
        }
        (q, phi, steps)
    }

    /// The minimum-norm step that closes `residual` and leaves what is locked alone.
    fn step(&self, q: &[f64], locked: &[bool], residual: &[f64]) -> Vec<f64> {
        let mut values = self.at(q);
        let weights = locked.iter().map(|&lock| if lock { 0.0 } else { 1.0 });
        values.extend(self.program.weights.iter().copied().zip(weights));
        values.extend(self.program.residual.iter().copied().zip(residual.iter().copied()));
        let mut step = run(&self.min_norm, &values);
        match step.pop() {
            Some(health) if health > HEALTHY && step.iter().all(|dq| dq.is_finite()) => step,
            _ => self.step_by_rank(q, locked, residual),
        }
    }

    fn step_by_rank(&self, q: &[f64], locked: &[bool], residual: &[f64]) -> Vec<f64> {
        let dense = self.phi_q(q).into_iter().map(|row| {
            let mut full = vec![0.0; q.len()];
            for (j, entry) in row {
                full[j] = if locked[j] { 0.0 } else { entry };
            }
            full
        });
        let mut step = pseudo_inverse::solve(dense.collect(), residual.to_vec());
        step.resize(q.len(), 0.0);
        step
    }
}

/// Start of (x, y, theta) of G per body and what is locked: `G = O + R(theta) centre`.
fn start_position(model: &Model, values: &[(Expr, f64)]) -> (Vec<f64>, Vec<bool>) {
    let mut q = Vec::with_capacity(3 * model.bodies.len());
    for body in &model.bodies {
        let [x, y, angle] = body.start.map(|start| value(start.value, values));
        let [dx, dy] = centre(body, values, angle);
        q.extend([x + dx, y + dy, angle]);
    }
    (q, model.bodies.iter().flat_map(|body| body.start.map(|start| start.locked)).collect())
}

/// Start of (vx, vy, omega) of G per body and what is locked: `v_G = v_O + omega x (G - O)`.
fn start_velocity(model: &Model, values: &[(Expr, f64)], q: &[f64]) -> (Vec<f64>, Vec<bool>) {
    let mut v = Vec::with_capacity(q.len());
    for (body, pose) in model.bodies.iter().zip(q.chunks_exact(3)) {
        let [vx, vy, omega] = body.start_velocity.map(|start| value(start.value, values));
        let [dx, dy] = centre(body, values, pose[2]);
        v.extend([vx - omega * dy, vy + omega * dx, omega]);
    }
    (v, model.bodies.iter().flat_map(|body| body.start_velocity.map(|start| start.locked)).collect())
}

/// G from O in absolute axes.
fn centre(body: &Body, values: &[(Expr, f64)], angle: f64) -> [f64; 2] {
    let [x, y] = body.centre.components().map(|component| value(component, values));
    let (sin, cos) = plm_math::f64::sin_cos(angle);
    [cos * x - sin * y, sin * x + cos * y]
}

/// Value of an expression of bound symbols.
pub(crate) fn value(expr: Expr, values: &[(Expr, f64)]) -> f64 {
    match expr.as_number() {
        Some(number) => number.to_f64(),
        None => run(&algebra::tape(&[expr]), values)[0],
    }
}

/// Values of a tape; NaN where it reads a symbol without value.
pub(crate) fn run(tape: &Tape, values: &[(Expr, f64)]) -> Vec<f64> {
    tape.eval(values).unwrap_or_else(|_| vec![f64::NAN; tape.outputs.len()])
}
