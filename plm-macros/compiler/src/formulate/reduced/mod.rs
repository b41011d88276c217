//! Joint coordinates: formulations 1 to 4. A tree needs nothing else; the loops of other mechanisms are solved in closed form,
//! dyad by dyad, or by Newton's iteration where they do not split, so that no constraint is left that could drift.

mod bodies;
mod charts;
mod contact;
mod dense;
mod forces;
#[cfg(test)]
mod forms;
mod groups;
mod inertia;
mod jacobian;
mod joints;
mod layout;
mod linearised;
mod motion;
mod pose;
#[cfg(feature = "lowered")]
pub(crate) mod textbook;
mod tree;

use crate::collect::CollectVec;
use plm_cas::{Expr, algebra};

use self::charts::Scheme;
use self::charts::kinematics::kinematics;
pub(crate) use self::charts::redundant::{Assembled, Known};
use self::groups::Group;
use self::inertia::Dense;
use self::jacobian::Jacobian;
use self::joints::coordinates::Coordinates;
pub(crate) use self::joints::coordinates::is_tree;
use self::layout::{Layout, loads};
use self::motion::Motion;
use self::motion::memory::Memory;
use self::motion::solution::measure;
use self::pose::{from_pose, pose};
use self::tree::augmented::augmented;
use super::contact::ContactFunctions;
use super::function::{Function, Place, Section, stored};
use super::linearised::{Linearised, by_time, orders_step};
use super::switches;
use crate::derive::Equations;
use crate::model::Model;

/// Coordinates up to which the dense mass matrix is set up. Of a tree with more, elimination body by body is cheaper by
/// far; with loops, that in absolute coordinates.
const MOST_DENSE: usize = 12;
/// Sums over pairs of unknowns are the least work where a body has fewer on the average, ...
const FEW_PAIRS: usize = 4;
/// ... and partial velocities where it has more; between them both are tried.
const MANY_PAIRS: usize = 12;

/// All functions of a formulation in joint coordinates.
pub(crate) struct Reduced {
    /// Choices of coordinates, the best first; a tree has one.
    pub(crate) charts: Vec<Chart>,
    /// Symbols of what is remembered from the last state that was looked at, and where each stands; a tree remembers nothing.
    pub(crate) memory: Vec<(Expr, String)>,
    /// The bodies whose angles are remembered, in that order: indices into the model's.
    pub(crate) turning: Vec<usize>,
    /// How many determinants are remembered.
    pub(crate) areas: usize,
    /// Bodies and joints that the unknowns belong to which Newton's iteration starts from, and of angles the body's index.
    pub(crate) followed: Vec<(String, Option<usize>)>,
}

impl Reduced {
    /// Number of coordinates.
    pub(crate) fn freedom(&self) -> usize {
        self.charts.first().map_or(0, |chart| chart.y.len())
    }

    /// True for joint coordinates with loops.
    pub(crate) fn has_loops(&self) -> bool {
        !self.memory.is_empty()
    }

    /// Are there more rows than its coordinates leave, so that some say what others say? Of two rails the second one keeps an angle that
    /// the first one keeps.
    pub(crate) fn is_redundant(&self, model: &Model) -> bool {
        self.freedom() + model.rows.len() > 3 * model.bodies.len()
    }

    /// Has every chart df/dx entry by entry?
    pub(crate) fn has_jacobian(&self) -> bool {
        self.charts.iter().all(|chart| chart.jacobian.is_some())
    }

    /// True if loops are solved by Newton's iteration.
    pub(crate) fn iterates(&self) -> bool {
        !self.followed.is_empty()
    }

    /// The chart that is taken first.
    pub(crate) fn first(&self) -> Option<&Chart> {
        self.charts.first()
    }
}

/// A choice of coordinates.
pub(crate) struct Chart {
    /// Name of each coordinate, as a path of the model.
    pub(crate) names: Vec<String>,
    /// The body whose angle the coordinate is, if it is one.
    pub(crate) turning: Vec<Option<usize>>,
    /// True for free coordinates: those that move no loop.
    pub(crate) free: Vec<bool>,
    /// The angles that its loops give: places in [`Reduced::turning`].
    pub(crate) found: Vec<usize>,
    /// The part or body that each coordinate belongs to.
    pub(crate) parts: Vec<String>,
    /// Symbols of the coordinates.
    pub(crate) y: Vec<Expr>,
    /// Symbols of their rates.
    pub(crate) y_dot: Vec<Expr>,
    /// How the accelerations are found.
    pub(crate) method: &'static str,
    /// `dx`; with loops, returning Health: the smallest square of a dyad's measure.
    pub(crate) rate: Function,
    /// The linearised equations, where they are wanted.
    pub(crate) linearised: Option<Linearised>,
    /// `by_t`, the derivative of `dx` by the time; where a linearly implicit step asks for it.
    pub(crate) by_time: Option<Function>,
    /// df/dx, where it takes fewer operations than dual numbers; of loops alone.
    pub(crate) jacobian: Option<Jacobian>,
    /// `g`, the guards of conditions.
    pub(crate) guards: Function,
    /// `q`, `v` of all bodies; with loops, returning the same.
    pub(crate) pose: Function,
    /// Rows of contact, if there are any.
    pub(crate) contact: Option<ContactFunctions>,
    /// `a` of all bodies and `lambda` of all rows; of trees alone.
    pub(crate) reactions: Option<Function>,
    /// `x` of a state in absolute coordinates.
    pub(crate) from_pose: Function,
    /// `memory` of a state, returning the same as `rate`; of loops alone.
    pub(crate) remember: Option<Function>,
    /// `memory` of a pose and velocity in this chart, returning the square of the measure; of loops alone.
    pub(crate) remember_pose: Option<Function>,
    /// The groups in the order of solution: kind and unknowns.
    pub(crate) groups: Vec<String>,
    /// The parts that close the loops, in the order of solution.
    pub(crate) closing: Vec<String>,
}

/// A way to the accelerations.
struct Form {
    method: &'static str,
    /// The equations of the coordinates, if it sets them up.
    dense: Option<Dense>,
    rate: Function,
}

/// Lays out a formulation in joint coordinates.
///
/// # Errors
/// Why the mechanism has neither: words that go on "absolute coordinates because …".
pub(crate) fn formulate(model: &Model, equations: &Equations, known: Known) -> Result<Reduced, String> {
    let coordinates = Coordinates::new(model)?;
    let schemes = schemes(model, equations, &coordinates, &known)?;
    let freedom = schemes.first().map_or(0, |scheme| scheme.independent.len());
    if freedom > MOST_DENSE && schemes.iter().any(|scheme| !scheme.groups.is_empty()) {
        return Err(format!("it has {freedom} degrees of freedom"));
    }
    let dyads = schemes.iter().map(|scheme| scheme.loops().count()).max().unwrap_or(0);
    let mut iterated: Vec<usize> = schemes.iter().flat_map(Scheme::iterated).collect_vec();
    iterated.sort_unstable();
    iterated.dedup();
    let memory = Memory::new(&coordinates, (freedom, dyads), &iterated);
    let length = Expr::from(plm_cas::Number::from_f64(known.length));
    let lambda = known.lambda;
    let mut layout = Layout { model, equations, coordinates: &coordinates, memory: &memory, length, lambda };
    let charts = schemes.iter().map(|scheme| layout.chart(scheme)).collect_vec();
    let turning = coordinates.unknowns.iter().filter_map(|unknown| unknown.turning_body()).collect_vec();
    let owner = |unknown: usize| {
        let unknown = &coordinates.unknowns[unknown];
        (owner(&unknown.name(model)).to_owned(), unknown.turning_body())
    };
    Ok(Reduced {
        turning,
        charts,
        memory: memory.symbols().into_iter().zip(memory.paths()).collect_vec(),
        areas: memory.areas(),
        followed: memory.followed().map(owner).collect_vec(),
    })
}

/// The charts of a mechanism, with as many coordinates as it has freedoms.
///
/// # Errors
/// As [`formulate`].
fn schemes(
    model: &Model,
    equations: &Equations,
    coordinates: &Coordinates,
    Known { assembled, freedom_elsewhere, .. }: &Known,
) -> Result<Vec<Scheme>, String> {
    let counted = charts::schemes(model, coordinates);
    if coordinates.is_tree() {
        return counted;
    }
    let assembled = assembled();
    let reason = match (&counted, &assembled) {
        (Ok(schemes), Some(assembled)) => {
            let by_count = schemes.first().map_or(0, |scheme| scheme.independent.len());
            if by_count == assembled.freedom {
                return counted;
            }
            // A row that says what others say is counted in the place of a freedom.
            format!(
                "some of its constraints are redundant: it has {} degrees of freedom, not {by_count}",
                assembled.freedom
            )
        }
        // A start that cannot be assembled is reported; one that parameters decide is as structure counts it.
        (Ok(_), None) => return counted,
        (Err(reason), _) => reason.clone(),
    };
    let assembled = assembled.as_ref().ok_or_else(|| reason.clone())?;
    // Defaults of parameters may be such as no mechanism has: lengths of zero. What is redundant at a start is found there.
    if let Ok(counted) = counted
        && freedom_elsewhere() == counted.first().map(|scheme| scheme.independent.len())
    {
        return Ok(counted);
    }
    charts::redundant::schemes(model, equations, coordinates, assembled).ok_or(reason)
}

/// The body or part of a coordinate's name.
fn owner(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |split| split.0)
}

impl Layout<'_> {
    fn chart(&mut self, scheme: &Scheme) -> Chart {
        let Layout { model, coordinates, equations, .. } = *self;
        let motion = kinematics(model, coordinates, scheme, self.memory, self.length);
        let loops = scheme.loops().next().is_some();
        let mut forms = self.forms(&motion, scheme);
        forms.sort_by_cached_key(|form| form.rate.tape().count().total());
        let dense = forms.iter_mut().find_map(|form| form.dense.take()).filter(|_| model.contacts.is_empty());
        let Form { method, rate, .. } = forms.swap_remove(0);
        let tree = scheme.groups.is_empty();
        // What solves for contact forces is differentiated by dual numbers.
        let differentiated = model.contacts.is_empty();
        let large = (tree && differentiated).then(|| augmented(model, equations, &motion)).flatten();
        let names: Vec<String> =
            motion.independent.iter().map(|&unknown| motion.names[unknown].clone()).collect_vec();
        let parts = names.iter().map(|name| owner(name).to_owned());
        let turning = |&unknown: &usize| coordinates.unknowns[unknown].turning_body();
        let in_loops: Vec<usize> = scheme.loops().flat_map(Group::unknowns).collect_vec();
        let is_free = |k: usize| in_loops.iter().all(|&unknown| motion.coefficient[unknown][k].is_zero());
        let remember = loops.then(|| self.remember(scheme, &motion));
        // Where a pose is read nothing is held.
        let remember_pose = loops.then(|| self.remember_pose(scheme).substitute(&model.released));
        let reactions = if loops { None } else { self.reactions(&motion, &rate) };
        let contact = self.contact(&motion, scheme, &rate);
        let described = |group: &Group| {
            let names: Vec<&str> =
                group.unknowns().into_iter().map(|unknown| motion.names[unknown].as_str()).collect_vec();
            format!("{} {}", group.name(), names.join(", "))
        };
        let closing = |group: &Group| {
            let part = coordinates.joints[group.closing(coordinates)?].part;
            Some(model.parts[part].name.text.clone())
        };
        let guards = switches::guards(model, &motion.substitution);
        let pose = pose(model, &motion).optimise();
        let from_pose = from_pose(model, equations, coordinates, &motion.independent)
            .substitute(&model.released)
            .optimise();
        let linearised = match large {
            Some(augmented) => Linearised::wanted(model, augmented, true),
            None => dense.as_ref().and_then(|dense| self.linearised(&motion, (dense, &rate), loops)),
        };
        let by_time = orders_step(model).then(|| by_time(&rate, model.time)).flatten();
        let jacobian = dense.filter(|_| loops).and_then(|dense| self.by_state(&motion, &dense, &rate));
        Chart {
            parts: parts.collect_vec(),
            names,
            turning: motion.independent.iter().map(turning).collect_vec(),
            found: coordinates.places_of_angles(&in_loops),
            free: (0..motion.independent.len()).map(is_free).collect_vec(),
            y: motion.of_independent(&motion.value),
            y_dot: motion.of_independent(&motion.rate),
            method,
            rate,
            contact,
            reactions,
            linearised,
            by_time,
            jacobian,
            guards,
            pose,
            from_pose,
            remember,
            remember_pose,
            groups: scheme.groups.iter().map(described).collect_vec(),
            closing: scheme.loops().filter_map(closing).collect_vec(),
        }
    }

    /// The linearised equations of a mechanism whose mass matrix is set up. Where loops may come to a singular pose, implicit
    /// methods take the full matrix: it can be had by rank.
    fn linearised(
        &self,
        motion: &Motion,
        (dense, rate): (&Dense, &Function),
        loops: bool,
    ) -> Option<Linearised> {
        if motion.independent.len() > MOST_DENSE || loops && !orders_step(self.model) {
            return None;
        }
        let x_dot = algebra::substitute(&self.equations.x_dot, &motion.substitution);
        let found = linearised::laid_out(motion, dense, &self.equations.x, &x_dot);
        let sparse = !loops && found.is_cheaper(self.reads(motion, rate).operations(rate));
        Linearised::wanted(self.model, found, sparse)
    }

    /// df/dx, entry by entry, if dual numbers take more. Of two states they do not: a derivative of the rate by the pose takes about as
    /// many operations as the rate.
    fn by_state(&self, motion: &Motion, dense: &Dense, rate: &Function) -> Option<Jacobian> {
        if 2 * motion.independent.len() + self.equations.x.len() <= 2 {
            return None;
        }
        let x_dot = algebra::substitute(&self.equations.x_dot, &motion.substitution);
        let found = jacobian::jacobian(motion, dense, &self.equations.x, &x_dot);
        let by_dual_numbers = self.reads(motion, rate).operations(rate);
        found.is_cheaper(rate.tape().count().total(), by_dual_numbers).then_some(found)
    }

    /// The ways to `M a = Q` along the coordinates.
    fn equations_along(&self, motion: &Motion, force: &[[Expr; 3]]) -> Vec<(&'static str, Dense)> {
        let model = self.model;
        let mut ways = Vec::new();
        let explicit = motion.independent.len() == motion.value.len();
        let pairs = inertia::pairs(motion) / model.bodies.len().max(1);
        if explicit || pairs < MANY_PAIRS {
            let dense = inertia::dense(model, motion, force);
            let along = if explicit { dense } else { inertia::along_independent(&dense, motion) };
            ways.push(("a dense mass matrix", along));
        }
        if !explicit && pairs >= FEW_PAIRS {
            ways.push(("partial velocities", bodies::dense(model, motion, force)));
        }
        ways
    }

    /// The ways to the accelerations: from the equations along the coordinates, and elimination body by body of a tree.
    fn forms(&mut self, motion: &Motion, scheme: &Scheme) -> Vec<Form> {
        let tree = scheme.groups.is_empty();
        let loops = scheme.loops().next().is_some();
        let Layout { model, .. } = *self;
        let force = loads(model, motion);
        let mut forms = Vec::new();
        if !tree || motion.independent.len() <= MOST_DENSE {
            for (method, dense) in self.equations_along(motion, &force) {
                let rate = self.right_hand_side(motion, dense::accelerations(motion, &dense), loops);
                forms.push(Form { method, dense: Some(dense), rate });
            }
        }
        if tree {
            let solution = tree::articulated::accelerations(model, motion, &force);
            let rate = self.right_hand_side(motion, solution, loops);
            forms.push(Form { method: "elimination body by body", dense: None, rate });
        }
        forms
    }

    fn right_hand_side(
        &mut self,
        motion: &Motion,
        (acceleration, sections): (Vec<Expr>, Vec<Section>),
        loops: bool,
    ) -> Function {
        let x_dot = algebra::substitute(&self.equations.x_dot, &motion.substitution);
        let rates: Vec<Expr> = motion.independent.iter().map(|&unknown| motion.rate[unknown]).collect_vec();
        let mut results = stored("dx", rates.iter().chain(&acceleration).chain(&x_dot));
        if loops {
            results.push((Place::Value, measure(&motion.solutions)));
        }
        Function { sections, results }.optimise()
    }
}
