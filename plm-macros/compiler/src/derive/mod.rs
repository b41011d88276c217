//! From the model to its equations of motion in absolute coordinates.
//!
//! With `q = (x, y, theta)` of G per body, constraints `phi(q, t) = 0` and multipliers `lambda` the motion obeys
//!
//! ```text
//! (1)  phi_dot               = phi_q v + phi_t
//! (2)  phi_q a               = gamma
//! (3)  gamma                 = -((phi_q v)_q v + 2 phi_qt v + phi_tt)
//! (4)  M a + phi_q^T lambda  = Q
//! ```
//!
//! (E. J. Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, 1989, sections 3.6 and 6.3). `M` is diagonal
//! because the coordinates stand at G. Along the flow `q' = v`, `v' = 0`, `t' = 1` the right-hand side of (1) is the first
//! derivative of `phi`, and the bracket of (3) is the second.

mod branch;
mod contact;
mod cuts;
mod decisions;
mod feedback;
mod forcing;
mod kinks;
mod massless;
mod poles;
mod range;
mod switches;
mod turns;

use crate::collect::CollectVec;
use plm_cas::{Expr, algebra};

pub(crate) use branch::Branch;
pub(crate) use contact::ContactRow;
pub(crate) use feedback::{Signal, feeds_back};
pub(crate) use forcing::{ForcingTerm, forcing_terms};
pub(crate) use massless::Massless;
pub(crate) use range::range;
pub(crate) use switches::hold_switches;
pub(crate) use turns::{count_turns, with_turns};

use crate::model::Model;

/// One row of a sparse matrix: (column, entry), columns ascending.
pub(crate) type SparseRow = Vec<(usize, Expr)>;

/// The equations of motion, all in one graph.
pub(crate) struct Equations {
    /// Symbols of the coordinates, `NQ`.
    pub(crate) q: Vec<Expr>,
    /// Symbols of the velocities, `NQ`.
    pub(crate) v: Vec<Expr>,
    /// Symbols of the accelerations, `NQ`; they stand in outputs only.
    pub(crate) a: Vec<Expr>,
    /// Symbols of the multipliers, `NC`; they stand in outputs only.
    pub(crate) lambda: Vec<Expr>,
    /// Symbols of the first-order states, `NX`.
    pub(crate) x: Vec<Expr>,
    /// Diagonal of the mass matrix, `NQ`: kg, kg, kg m^2 per body.
    pub(crate) mass: Vec<Expr>,
    /// Applied force `Q`, gravity included, `NQ`: N, N, N m per body; without what the signals add.
    pub(crate) force: Vec<Expr>,
    /// Accelerations and multipliers that forces read.
    pub(crate) signals: Vec<Signal>,
    /// Constraints `phi`, `NC`: m or rad.
    pub(crate) phi: Vec<Expr>,
    /// Derivative of `phi` with respect to `q`, `NC` sparse rows.
    pub(crate) phi_q: Vec<SparseRow>,
    /// `phi_q v - nu` with `nu = -phi_t`, `NC`: m/s or rad/s.
    pub(crate) phi_dot: Vec<Expr>,
    /// Right-hand side of `phi_q a = gamma`, `NC`: m/s^2 or rad/s^2.
    pub(crate) gamma: Vec<Expr>,
    /// Rates of the first-order states, `NX`.
    pub(crate) x_dot: Vec<Expr>,
    /// Which mirror image a pose is, joint by joint.
    pub(crate) branches: Vec<Branch>,
    /// Rows of contact, in the order of the model.
    pub(crate) contacts: Vec<ContactRow>,
}

/// Derives the equations of motion of a model.
pub(crate) fn derive(model: &Model) -> Equations {
    let q: Vec<Expr> = model.bodies.iter().flat_map(|body| body.q).collect_vec();
    let v: Vec<Expr> = model.bodies.iter().flat_map(|body| body.v).collect_vec();
    let phi: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect_vec();
    let mut phi_q = Vec::with_capacity(phi.len());
    let mut phi_dot = Vec::with_capacity(phi.len());
    let mut gamma = Vec::with_capacity(phi.len());
    let columns = Columns::new(model);
    for &phi in &phi {
        let (entries, rate, second) = along_motion(model, (&q, &v), &columns, phi);
        phi_q.push(entries);
        phi_dot.push(rate);
        gamma.push(-second);
    }
    let contacts = contact::rows(model, (&q, &v), &columns);
    let mut force = applied_force(model);
    let signals = feedback::signals(model, &mut force);
    Equations {
        a: model.bodies.iter().flat_map(|body| body.a).collect_vec(),
        lambda: model.rows.iter().map(|row| row.lambda).collect_vec(),
        x: model.states.iter().map(|state| state.symbol).collect_vec(),
        mass: model.bodies.iter().flat_map(|body| [body.mass, body.mass, body.inertia]).collect_vec(),
        force,
        signals,
        branches: branch::branches(model),
        x_dot: model.states.iter().map(|state| state.rate).collect_vec(),
        q,
        v,
        phi,
        phi_q,
        phi_dot,
        gamma,
        contacts,
    }
}

/// The derivatives of a function of pose and time by the coordinates, its rate (1), and what its second derivative (3) has
/// beside the accelerations.
fn along_motion(
    model: &Model,
    (q, v): (&[Expr], &[Expr]),
    columns: &Columns,
    phi: Expr,
) -> (SparseRow, Expr, Expr) {
    let held = columns.of(phi);
    let coordinates: Vec<Expr> = held.iter().map(|&column| q[column]).collect_vec();
    let entries = algebra::gradient(phi, &coordinates).into_iter();
    let entries = entries.map(|(k, entry)| (held[k], entry)).collect_vec();
    let mut flow: Vec<(Expr, Expr)> = held.iter().map(|&column| (q[column], v[column])).collect_vec();
    flow.push((model.time, Expr::ONE));
    let rate = phi.directional(&flow);
    (entries, rate, rate.directional(&flow))
}

/// `Q` of (4): gravity, `m g` at the G of each body with a mass, and the loads of all parts.
fn applied_force(model: &Model) -> Vec<Expr> {
    let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); 3 * model.bodies.len()];
    for (i, body) in model.bodies.iter().enumerate().filter(|(_, body)| body.has_mass) {
        for (k, gravity) in model.gravity.components().into_iter().enumerate() {
            terms[3 * i + k].push(body.mass * gravity);
        }
    }
    for load in &model.loads {
        for (k, &component) in load.force.iter().enumerate() {
            terms[3 * load.body + k].push(component);
        }
    }
    terms.iter().map(|terms| terms.iter().sum()).collect_vec()
}

/// Finds the coordinates that an expression holds.
struct Columns {
    /// (symbol, column), ascending by symbol.
    sorted: Vec<(Expr, usize)>,
}

impl Columns {
    fn new(model: &Model) -> Columns {
        let coordinates = model.bodies.iter().flat_map(|body| body.q);
        let mut sorted: Vec<(Expr, usize)> =
            coordinates.enumerate().map(|(column, symbol)| (symbol, column)).collect_vec();
        sorted.sort_unstable();
        Columns { sorted }
    }

    /// Columns of the coordinates in `expr`, ascending.
    fn of(&self, expr: Expr) -> Vec<usize> {
        let held = algebra::symbols(&[expr]);
        let column = |symbol: &Expr| {
            self.sorted.binary_search_by_key(symbol, |&(s, _)| s).ok().map(|k| self.sorted[k].1)
        };
        let mut columns: Vec<usize> = held.iter().filter_map(column).collect_vec();
        columns.sort_unstable();
        columns
    }
}
