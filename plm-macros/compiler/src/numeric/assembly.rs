//! Assembly of the declared start at compile time (manual, section 4.4), the compiler's twin of the runtime's.
//!
//! Positions: `q <- q - pinv(phi_q) phi` in SI with unit weights from the user's start; a lock takes its column out.
//! Velocities: one step of the same kind, `v <- v - pinv(phi_q) (phi_q v - nu)`, from the start velocities.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::Expr;

use super::branch;
use super::change_point::{ChangePoint, change_point};
use super::constraints::{Closed, Constraints, are_closed};
use super::damped::Measure;
use super::far::{Far, far, look_nearer};
use super::lack::lack;
use super::placed::{nearer, unwind};
use super::rank::Rank;
use super::scene::Scene;
use super::search::{Search, Searched, search};
use super::values::add_switches;
use crate::evaluated::value;
use crate::model::{Body, Model};

/// Largest `phi` of an assembled mechanism: of a row in m as a part of the size of the scene, of one in rad as it is.
const CLOSED: f64 = 1e-10;
/// A joint of two bars whose angles are rounded is open by so many units in the last place of the angles, times the lengths.
const ROUNDINGS: f64 = 4.0;
/// Damped steps to a pose without locks, and the part of the violation that each takes away.
const UNLOCKED: (usize, f64) = (60, 1e-3);

/// Result of assembly.
pub(crate) struct Assembly {
    /// The pose that the user declared, at G: m, m, rad per body.
    pub(crate) start: Vec<f64>,
    /// The assembled pose, m, m, rad per body.
    pub(crate) q: Vec<f64>,
    /// Velocities at the assembled pose that obey the constraints: m/s, m/s, rad/s per body.
    pub(crate) v: Vec<f64>,
    /// Which coordinates are locked.
    pub(crate) locked: Vec<bool>,
    /// Which velocities are locked.
    pub(crate) velocity_locked: Vec<bool>,
    /// Rank of `[phi_q; E]` and its dependent rows; `E` has a row for each locked coordinate.
    pub(crate) rank: Rank,
    /// Rank of `[phi_q; E]` where `E` has a row for each locked velocity.
    pub(crate) velocity_rank: Rank,
    /// `phi` at the assembled pose, m or rad by row.
    pub(crate) phi: Vec<f64>,
    /// `phi_q v - nu` at the assembled pose, m/s or rad/s by row.
    pub(crate) phi_dot: Vec<f64>,
    /// Largest `phi` of each row that counts as closed, m or rad.
    pub(crate) closed: Vec<f64>,
    /// Newton steps taken.
    pub(crate) steps: usize,
    /// The search that followed where Newton's steps from the declared start closed nothing.
    pub(crate) searched: Option<Searched>,
    /// The pose is further from the start than what was missing there explains.
    pub(crate) far: Option<Far>,
    /// The pose is a change point; ranks are those beside it.
    pub(crate) change_point: Option<ChangePoint>,
}

impl Assembly {
    /// Do all constraints hold?
    pub(crate) fn is_closed(&self) -> bool {
        are_closed(&self.phi, &self.closed)
    }

    /// Do the velocities obey the constraints?
    pub(crate) fn moves_consistently(&self) -> bool {
        let speed = self.v.iter().fold(1.0_f64, |largest, v| largest.max(v.abs()));
        self.phi_dot.iter().all(|phi_dot| phi_dot.abs() <= 1e-9 * speed)
    }
}

/// Coordinates or velocities of a start, and which of them are locked.
pub(super) struct Start {
    pub(super) values: Vec<f64>,
    pub(super) locked: Vec<bool>,
    /// Which of them are angles that were given.
    pub(super) given: Vec<bool>,
}

/// How far assembly goes for a pose.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Reach {
    /// As the runtime does: where Newton's steps from the declared start close nothing, others are tried.
    Full,
    /// Newton's steps alone: one scene of several that are tried.
    Near,
}

/// The assembled start of a scene, with the values that all symbols have there; multipliers and accelerations are zero.
pub(crate) fn at_start(scene: &Scene) -> (Assembly, Vec<(Expr, f64)>) {
    let start = assemble(scene, Reach::Full);
    let mut values = scene.moving(&start.q, &start.v);
    add_switches(scene.model, &mut values);
    (start, values)
}

/// Assembles the declared start of a scene.
pub(crate) fn assemble(scene: &Scene, reach: Reach) -> Assembly {
    let constraints = Constraints::new(scene);
    let start = start_position(scene);
    let limits = |q: &[f64]| limits(scene.model, scene.length, q);
    let by = Search { constraints: &constraints, start: &start, limits: &limits };
    let asked = branch::asked(scene);
    let missed = |q: &[f64]| branch::missed(&asked, q);
    let is_closed = |closed: &Closed| by.is_closed(closed);
    let (rows, mut searched) = (scene.model.rows.len(), None);
    let mut others = || {
        let (found, tried) = search(by, &missed);
        searched = Some(tried);
        found
    };
    let mut nearest = by.close(start.values.clone());
    // Locks that are too many are the likelier mistake than joints that do not fit. A pose that closes without them tells.
    let unlocked =
        if is_closed(&nearest) { None } else { unlocked(&by).map(|q| constraints.rank(&q, &start.locked)) };
    let ties_locks = unlocked.as_ref().is_some_and(|rank| rank.dependent.iter().any(|(row, _)| *row >= rows));
    if reach == Reach::Full {
        if is_closed(&nearest) {
            nearest = look_nearer(&by, nearer(&by, nearest), &mut others);
        } else if nearest.phi.iter().all(|phi| phi.is_finite()) && !ties_locks {
            let steps = nearest.steps;
            let open = |q| lack(&constraints, q, &start.locked, steps);
            nearest = others().map_or_else(open, |pose| nearer(&by, pose));
        }
    }
    let by_search = |before: usize| {
        let found = (reach == Reach::Full).then(&mut others)?.ok();
        found.filter(|found| missed(&found.q) < before)
    };
    let near = |q: Vec<f64>| Some(by.close(q)).filter(is_closed);
    if is_closed(&nearest) {
        nearest = branch::find(&asked, nearest, &start, near, by_search);
        // Mirrored bodies may have turned further than half a turn.
        unwind(&by, &mut nearest);
    }
    let Closed { q, phi, steps } = nearest;
    let (mut v, velocity_locked) = start_velocity(scene, &q);
    let phi_dot = constraints.phi_dot(&q, &v);
    for (velocity, dv) in v.iter_mut().zip(constraints.step(&q, &velocity_locked, &phi_dot)) {
        *velocity -= dv;
    }
    let is_closed = are_closed(&phi, &limits(&q));
    let at_start = constraints.rank(&start.values, &start.locked);
    let at_end = constraints.rank(&q, &start.locked);
    let change = if is_closed { change_point(&constraints, &start, &limits, (&q, &v)) } else { None };
    let (change_point, beside) = change.unzip();
    // A pose of zeros can look singular: the better of the two ranks is the true one.
    let rank = if at_end.value() >= at_start.value() { at_end } else { at_start };
    let far = if is_closed && asked.is_empty() { far(&by, &q) } else { None };
    Assembly {
        far,
        change_point,
        rank: match (beside, unlocked) {
            (Some(rank), _) => rank,
            (None, _) if is_closed => rank,
            (None, Some(unlocked)) => unlocked,
            (None, None) => rank.of_rows(rows),
        },
        velocity_rank: constraints.rank(&q, &velocity_locked),
        phi_dot: constraints.phi_dot(&q, &v),
        closed: limits(&q),
        start: start.values,
        q,
        v,
        locked: start.locked,
        velocity_locked,
        phi,
        steps,
        searched,
    }
}

/// A closed pose beside the start in which nothing is locked, where something is and such a pose is found.
fn unlocked(by: &Search) -> Option<Vec<f64>> {
    let Search { constraints, start, .. } = *by;
    if !start.locked.contains(&true) {
        return None;
    }
    let free = vec![false; start.locked.len()];
    let close = |q: Vec<f64>| {
        let closed = constraints.close(q, &free, by.limits);
        by.is_closed(&closed).then_some(closed.q)
    };
    close(start.values.clone()).or_else(|| {
        let mut q = start.values.clone();
        Measure::new(constraints, &free).descend(&mut q, UNLOCKED);
        close(q)
    })
}

/// Bounds of `phi` of each row in a scene of a size that reaches as far as the bodies stand, and as far as the rounding of angles
/// moves the ends of its bars.
fn limits(model: &Model, length: f64, q: &[f64]) -> Vec<f64> {
    let rounding = ROUNDINGS * f64::EPSILON / CLOSED * length;
    let reach = q.iter().enumerate().fold(length, |reach, (k, value)| {
        reach.max(if k % 3 == 2 { rounding * value.abs() } else { value.abs() })
    });
    model.rows.iter().map(|row| CLOSED * if row.is_angular() { 1.0 } else { reach }).collect_vec()
}

/// Start of (x, y, theta) of G per body: `G = O + R(theta) centre`.
fn start_position(scene: &Scene) -> Start {
    let bodies = &scene.model.bodies;
    let mut q = Vec::with_capacity(3 * bodies.len());
    for body in bodies {
        let [x, y, angle] = body.start.map_each(|start| value(start.value, &scene.values));
        let [dx, dy] = centre(body, &scene.values, angle);
        q.push_all([x + dx, y + dy, angle]);
    }
    let locked = bodies.iter().flat_map(|body| body.start.map_each(|start| start.locked));
    let given = bodies.iter().flat_map(|body| [false, false, body.start[2].given]);
    Start { values: q, locked: locked.collect_vec(), given: given.collect_vec() }
}

/// Start of (vx, vy, omega) of G per body at a pose, `v_G = v_O + omega x (G - O)`, and which are locked.
fn start_velocity(scene: &Scene, q: &[f64]) -> (Vec<f64>, Vec<bool>) {
    let bodies = &scene.model.bodies;
    let mut v = Vec::with_capacity(q.len());
    for (body, pose) in bodies.iter().zip(q.chunks_exact(3)) {
        let [vx, vy, omega] = body.start_velocity.map_each(|start| value(start.value, &scene.values));
        let [dx, dy] = centre(body, &scene.values, pose[2]);
        v.push_all([vx - omega * dy, vy + omega * dx, omega]);
    }
    let locked = bodies.iter().flat_map(|body| body.start_velocity.map_each(|start| start.locked));
    (v, locked.collect_vec())
}

/// G from O in absolute axes.
fn centre(body: &Body, values: &[(Expr, f64)], angle: f64) -> [f64; 2] {
    let [x, y] = body.centre.components().map_each(|component| value(component, values));
    let (sin, cos) = plm_math::f64::sin_cos(angle);
    [cos * x - sin * y, sin * x + cos * y]
}
