//! Absolute coordinates and multipliers, the formulation that holds every mechanism.
//!
//! ```text
//! (1)  Y = phi_q M^-1
//! (2)  (Y phi_q^T) lambda = phi_q M^-1 Q - gamma
//! (3)  a = M^-1 Q - Y^T lambda
//! ```
//!
//! (J. Garcia de Jalon, E. Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994, section 5.1). Baumgarte's
//! method replaces `gamma` by
//!
//! ```text
//! (4)  gamma - (2 alpha phi_dot + beta^2 phi)
//! ```
//!
//! (J. Baumgarte, Comput. Methods Appl. Mech. Eng. 1, 1972, eq. (2.7)).
//!
//! Elimination is a symbolic sparse `L D L^T` in the order of minimum degree.

mod conditional;
mod feedback;
mod linearised;
mod motion;
mod normal;

use crate::collect::CollectVec;
use crate::sorted::SortedSet;

use plm_cas::{Expr, algebra};

pub(crate) use self::conditional::Conditional;
use self::motion::motion;
use self::normal::min_norm;
use super::colours::Reads;
use super::contact::ContactFunctions;
use super::function::{Function, Place, stored};
use super::linearised::{Linearised, orders_step};
use super::order::minimum_degree;
use super::outputs::{self, Outputs};
use super::switches;
use crate::derive::Equations;
use crate::model::{Contact, ContactLaw, Model, Reaction, Stabilisation};

/// Everything that absolute coordinates compute.
pub(crate) struct Absolute {
    /// `dx` and `lambda`, returning Health: the right-hand side.
    pub(crate) dynamics: Function,
    /// Rows of contact, if there are any.
    pub(crate) contact: Option<ContactFunctions>,
    /// `phi`, m or rad by row.
    pub(crate) phi: Function,
    /// `phi_dot = phi_q v - nu`, m/s or rad/s by row.
    pub(crate) phi_dot: Function,
    /// Non-zero entries of `phi_q`, row by row.
    pub(crate) phi_q: Function,
    /// `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`, returning Health: the least step, weighted, by which `phi` changes by `r`.
    pub(crate) min_norm: Function,
    /// `inverse_mass`: the diagonal of `M^-1`, 1/kg or 1/(kg m^2) by coordinate.
    pub(crate) inverse_mass: Function,
    /// `force` and `gamma`: `Q` and the right-hand side of `phi_q a = gamma`, for the solution by rank.
    pub(crate) free: Function,
    /// `x_dot`: rates of the first-order states alone, for the solution by rank.
    pub(crate) x_dot: Function,
    /// `force` and `x_dot` without accelerations, in which multipliers are unknowns: for equilibria.
    pub(crate) at_rest: Function,
    /// `g`, the guards of conditions.
    pub(crate) guards: Function,
    /// `at` and `slope` of conditions that depend on the time alone.
    pub(crate) instants: Function,
    /// `holds` of the conditions of events.
    pub(crate) events: Function,
    /// Constraints with a condition, if there are any.
    pub(crate) conditional: Option<Conditional>,
    /// `exist` of the rows of contact.
    pub(crate) rows_exist: Function,
    /// `set`: the values that events give.
    pub(crate) values_set: Function,
    /// `set` of events that happen as a run begins.
    pub(crate) values_at_start: Function,
    /// `jump`: what rows do where conditions change, five terms each.
    pub(crate) jumps: Function,
    /// Outputs.
    pub(crate) outputs: Outputs,
    /// The linearised equations, where they are wanted.
    pub(crate) linearised: Option<Linearised>,
    /// Symbols of the weights of [`Absolute::min_norm`].
    pub(crate) weights: Vec<Expr>,
    /// Symbols of `r` in [`Absolute::min_norm`].
    pub(crate) r: Vec<Expr>,
}

/// Lays out absolute coordinates.
pub(crate) fn formulate(model: &Model, equations: &Equations) -> Absolute {
    let symbols = |name: &str, count: usize| -> Vec<Expr> {
        (0..count).map(|k| Expr::symbol(format!("{name}_{k}"))).collect_vec()
    };
    let weights = symbols("w", equations.q.len());
    let r = symbols("dphi", equations.phi.len());
    let entries: Vec<Expr> = equations.phi_q.iter().flatten().map(|&(_, entry)| entry).collect_vec();
    let inverse_mass: Vec<Expr> = equations.mass.iter().map(|mass| mass.recip()).collect_vec();
    let motion = motion(model, equations, &inverse_mass);
    // What the unknowns do to forces and rates elsewhere.
    let read = motion.read.clone();
    let x_dot = algebra::substitute(&equations.x_dot, &read);
    let mut free = stored("force", equations.force.iter());
    free.extend(stored("gamma", stabilised(model, equations).iter()));
    // Assembly and projection hold no switches.
    let released = |function: Function| function.substitute(&model.released);
    let contact = motion.contact(model, equations, &x_dot);
    let [values_set, values_at_start] = switches::values_set(model);
    Absolute {
        dynamics: motion.dynamics(equations, &x_dot),
        contact,
        phi: released(Function::of_array("phi", &equations.phi)),
        phi_dot: released(Function::of_array("phi_dot", &equations.phi_dot)),
        phi_q: released(Function::of_array("phi_q", &entries)),
        min_norm: released(min_norm(equations, &weights, &r, model.most_growth)),
        events: switches::events(model),
        conditional: Conditional::new(model, equations),
        rows_exist: switches::rows_exist(model),
        values_set,
        values_at_start,
        jumps: switches::jumps(model),
        inverse_mass: Function::of_array("inverse_mass", &inverse_mass),
        free: Function::of_results(free),
        x_dot: Function::of_array("x_dot", &x_dot),
        at_rest: at_rest(model, equations),
        guards: switches::guards(model, &[]),
        instants: switches::instants(model),
        outputs: outputs::formulate(model, equations, &read),
        linearised: None,
        weights,
        r,
    }
}

/// Does the elimination of `phi_q W phi_q^T` take more products than `most`? Two rows meet where both hold a coordinate.
pub(crate) fn eliminates_beyond(most: usize, equations: &Equations) -> bool {
    let mut holding = vec![Vec::new(); equations.q.len()];
    for (row, entries) in equations.phi_q.iter().enumerate() {
        for &(column, _) in entries {
            holding[column].push(row);
        }
    }
    let mut near = vec![SortedSet::new(); equations.phi_q.len()];
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
    /// Multipliers of the joints at a state.
    pub(super) fn multipliers(&self) -> Vec<Expr> {
        let results = self.dynamics.results.iter();
        results
            .filter_map(|(place, value)| matches!(place, Place::Element("lambda", _)).then_some(*value))
            .collect_vec()
    }

    /// Shares what each function computes more than once. Guards and outputs are small, and share when they are laid out.
    pub(crate) fn optimise(self) -> Absolute {
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

/// States up to which implicit methods take the full matrix of derivatives.
const MOST_FULL: usize = 24;

impl Absolute {
    /// Adds the linearised equations where they are wanted.
    pub(crate) fn linearise(&mut self, model: &Model, equations: &Equations) {
        let large = 2 * equations.q.len() + equations.x.len() > MOST_FULL;
        if !(large || orders_step(model)) || !model.contacts.is_empty() {
            return;
        }
        let Some(augmented) = linearised::linearised(model, equations) else { return };
        let reads = Reads::of(&self.dynamics, [&equations.q, &equations.v, &equations.x]);
        let sparse = large && augmented.is_cheaper(reads.operations(&self.dynamics));
        self.linearised = Linearised::wanted(model, augmented, sparse);
    }
}

/// All forces, those that read multipliers included, and the rates, where nothing accelerates.
fn at_rest(model: &Model, equations: &Equations) -> Function {
    let mut force = equations.force.clone();
    for signal in &equations.signals {
        for &(k, gain) in &signal.gain {
            force[k] += gain * signal.symbol;
        }
    }
    let still: Vec<(Expr, Expr)> = equations.a.iter().map(|&a| (a, Expr::ZERO)).collect_vec();
    let mut results = stored("force", force.iter());
    results.extend(stored("x_dot", equations.x_dot.iter()));
    let gaps: Vec<Expr> = model.contacts.iter().map(displacement_at_rest).collect_vec();
    results.extend(stored("gap", gaps.iter()));
    let limits: Vec<Expr> = model.contacts.iter().flat_map(limits_at_rest).collect_vec();
    results.extend(stored("limit", limits.iter()));
    Function::of_results(results).substitute(&still)
}

/// The displacement of a row; a gap that does not exist is open by 1 m or rad.
fn displacement_at_rest(contact: &Contact) -> Expr {
    let Some(exists) = contact.exists else { return contact.displacement };
    let half = Expr::from(1) / Expr::from(2);
    half.less(exists).select(contact.displacement, Expr::ONE)
}

/// How much a row can give to either side while it holds; nothing is said of a gap, and a constraint gives all.
fn limits_at_rest(contact: &Contact) -> [Expr; 2] {
    let (adhesion, reactions) = match &contact.law {
        ContactLaw::Unilateral { .. } => return [Expr::ZERO; 2],
        ContactLaw::Constraint => return [Expr::from(1_000_000_000) * Expr::from(1_000_000_000); 2],
        ContactLaw::Friction { adhesion, reactions, .. } => (adhesion, reactions),
    };
    let sizes = reactions.iter().map(|Reaction { size, components }| {
        let square: Expr = components.iter().map(|&component| component * component).sum();
        (*size, square.sqrt())
    });
    let limits = algebra::substitute(adhesion, &sizes.collect_vec());
    [limits[0], limits[1]]
}

/// `gamma`, with Baumgarte's feedback (4) where the model asks for it: `alpha = beta = 1 / tau`.
fn stabilised(model: &Model, equations: &Equations) -> Vec<Expr> {
    let Stabilisation::Baumgarte(tau) = model.stabilisation else { return equations.gamma.clone() };
    let alpha = tau.recip();
    let beta = alpha;
    let rows = equations.gamma.iter().zip(&equations.phi_dot).zip(&equations.phi);
    rows.map(|((&gamma, &phi_dot), &phi)| gamma - (2 * alpha * phi_dot + beta * beta * phi)).collect_vec()
}

/// `arm_x`, `arm_y`, `arm_angle` for the three coordinates of a body.
pub(crate) fn coordinate_name(model: &Model, k: usize) -> String {
    format!("{}.{}", model.bodies[k / 3].name.text, ["x", "y", "angle"][k % 3])
}
