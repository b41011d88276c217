//! Rows of contact as data.

use plm_cas::Expr;

use super::routine::Routine;
use super::{Parts, names};
use crate::collect::{CollectVec, PushAll};
use crate::facts::{conditions, contact};
use crate::formulate::{self, ContactFunctions, Function};
use crate::model::{ContactLaw, bounding_reactions};
use crate::source::{Origin, Source};

pub use crate::formulate::{OfRows, RowTerm};
pub use crate::model::Impacts;

/// Rows of contact.
#[derive(Clone, Debug)]
pub struct Contacts {
    /// The rows.
    pub rows: Vec<ContactRow>,
    /// Places for rows and for reactions: those after the last row never exist.
    pub places: usize,
    /// `exist`: 1 for each row that exists, or 0; where that is a question.
    pub exist: Option<Routine>,
    /// Reactions of joints that bound frictions.
    pub reactions: Vec<BoundingReaction>,
    /// By guard, the name of its row.
    pub guard_names: Vec<String>,
    /// The law of impact.
    pub impacts: Impacts,
    /// Rates are not zero where velocities are.
    pub moves_by_time: bool,
    /// The rate is affine in the multipliers.
    pub is_affine: bool,
    /// The numbers of contact that conditions of the state read.
    pub read: ReadByConditions,
    /// Functions chart by chart; of trees and absolute coordinates those of one.
    pub charts: Vec<ContactChart>,
    /// Constraints with a condition.
    pub conditional: Option<Conditional>,
}

/// The numbers of contact that conditions of the state read. Where they read some, their sides are known after the modes of the rows
/// where a run begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadByConditions {
    /// Neither modes nor forces.
    Nothing,
    /// Modes, or reactions of joints.
    Modes,
    /// Multipliers.
    Multipliers,
}

/// A row of contact.
#[derive(Clone, Debug)]
pub struct ContactRow {
    /// Its name, `foot.tip`.
    pub name: String,
    /// The kind of its law.
    pub kind: ContactKind,
    /// The coefficient of restitution, zero where it has none; of parameters.
    pub restitution: Routine,
    /// A friction that is off without a push.
    pub bounded_by_pushes: bool,
    /// A friction whose bound may become negative.
    pub bound_may_fall: bool,
    /// Its gap reads discrete states.
    pub moved_by_states: bool,
}

/// The kind of the law of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactKind {
    /// A gap that pushes.
    Unilateral,
    /// A friction.
    Friction,
    /// A constraint while it exists.
    Constraint,
}

/// A reaction of joints that bounds frictions.
#[derive(Clone, Debug)]
pub struct BoundingReaction {
    /// Has it two components? Else it acts along a line.
    pub in_plane: bool,
    /// The rows whose limits read it.
    pub rows: Vec<usize>,
}

/// Functions of the rows in a chart.
#[derive(Clone, Debug)]
pub struct ContactChart {
    /// Gaps and rates.
    pub kinematics: Routine,
    /// `dx` without contact forces, `response`, the rest of the rows; it returns what the rate returns.
    pub motion: Routine,
    /// Both in one, where steps of Moreau and Jean are ordered.
    pub together: Option<Routine>,
    /// Frictions that all slip, in every chart or in none.
    pub sliding: Option<Sliding>,
}

/// Functions of rows that all slip.
#[derive(Clone, Debug)]
pub struct Sliding {
    /// `dx` but for accelerations, `free`, `known`, `slope`, of `slip` and `line`; it returns what the rate returns.
    pub motion: Routine,
    /// `next` and `changed` of `known`, `force`, `second`.
    pub sweep: Routine,
    /// `sizes` of reactions along a line.
    pub sizes: Routine,
    /// One sweep finds the forces.
    pub is_explicit: bool,
    /// Number of the known numbers.
    pub known: usize,
    /// Of each coordinate: is it an angle?
    pub angles: Vec<bool>,
}

/// Constraints with a condition, which assembly closes where they hold at the start.
#[derive(Clone, Debug)]
pub struct Conditional {
    /// Their places among the rows of contact.
    pub rows: Vec<usize>,
    /// Their names.
    pub names: Vec<String>,
    /// The parts that they belong to.
    pub parts: Vec<String>,
    /// Of each: is its residual an angle?
    pub angular: Vec<bool>,
    /// `phi`, of a pose.
    pub phi: Routine,
    /// `phi_dot`, of a pose and velocity.
    pub phi_dot: Routine,
    /// `phi_q`, the entries of the Jacobian that are not zero.
    pub phi_q: Routine,
    /// Row and column of each of these entries.
    pub places: Vec<[usize; 2]>,
}

impl Contacts {
    /// The rows of contact, if there are any.
    pub(super) fn new(parts: &Parts) -> Option<Contacts> {
        let Parts { model, equations, program, .. } = parts;
        if model.contacts.is_empty() {
            return None;
        }
        let (charts, absolute) = (charts(parts), &program.absolute);
        let reactions = bounding_reactions(&model.contacts).into_iter().zip(contact::readers(model));
        let read = if contact::are_read_by_conditions(model) {
            ReadByConditions::Multipliers
        } else if contact::modes_are_read_by_conditions(model) || conditions::read_solution(model, equations)
        {
            ReadByConditions::Modes
        } else {
            ReadByConditions::Nothing
        };
        Some(Contacts {
            rows: rows(parts),
            places: contact::places(model),
            exist: contact::some_may_not_exist(model)
                .then(|| parts.routine(&absolute.rows_exist, Origin::Arguments)),
            reactions: reactions
                .map(|(reaction, rows)| BoundingReaction { in_plane: reaction.components.len() > 1, rows })
                .collect_vec(),
            guard_names: names(contact::names_of_guards(model).into_iter()),
            impacts: model.impacts,
            moves_by_time: charts.iter().any(|(contact, _)| contact.moves_by_time),
            is_affine: charts.iter().all(|(contact, _)| contact.is_affine),
            read,
            charts: lowered(parts, &charts),
            conditional: absolute.conditional.as_ref().map(|own| Conditional::new(parts, own)),
        })
    }
}

fn rows(parts: &Parts) -> Vec<ContactRow> {
    let model = parts.model;
    let [by_pushes, falling, moved] = [
        contact::bounded_by_pushes(model),
        contact::bounds_that_may_fall(model),
        contact::moved_by_states(model),
    ];
    let rows = model.contacts.iter().enumerate().map(|(k, row)| ContactRow {
        name: row.name.clone(),
        kind: match row.law {
            ContactLaw::Unilateral { .. } => ContactKind::Unilateral,
            ContactLaw::Friction { .. } => ContactKind::Friction,
            ContactLaw::Constraint => ContactKind::Constraint,
        },
        restitution: match row.law {
            ContactLaw::Unilateral { restitution } => parts.values(&[restitution]),
            ContactLaw::Friction { .. } | ContactLaw::Constraint => parts.values(&[Expr::ZERO]),
        },
        bounded_by_pushes: by_pushes.contains(&k),
        bound_may_fall: falling.contains(&k),
        moved_by_states: moved.contains(&k),
    });
    rows.collect_vec()
}

/// Functions of the rows with their origins, chart by chart.
type InCharts<'a> = Vec<(&'a ContactFunctions, Origin<'a>)>;

fn charts<'a>(parts: &Parts<'a>) -> InCharts<'a> {
    match parts.reduced {
        None => {
            let contact = parts.program.absolute.contact.iter();
            contact.map(|contact| (contact, Origin::Arguments)).collect_vec()
        }
        Some(reduced) => {
            let charts = reduced.charts.iter();
            charts.filter_map(|chart| Some((chart.contact.as_ref()?, Origin::Chart(chart)))).collect_vec()
        }
    }
}

fn lowered(parts: &Parts, charts: &InCharts) -> Vec<ContactChart> {
    let all_slide = charts.iter().all(|(contact, _)| contact.sliding.is_some());
    let of_chart = |&(contact, origin): &(&ContactFunctions, Origin)| ContactChart {
        kinematics: parts.routine(&contact.kinematics, origin),
        motion: parts.routine(&contact.motion, origin),
        together: contact.together.as_ref().map(|together| parts.routine(together, origin)),
        sliding: contact
            .sliding
            .as_ref()
            .filter(|_| all_slide)
            .map(|sliding| Sliding::new(parts, sliding, origin)),
    };
    charts.iter().map(of_chart).collect_vec()
}

impl Sliding {
    fn new(parts: &Parts, sliding: &formulate::Sliding, origin: Origin) -> Sliding {
        let formulate::Sliding { slip, line, force, second, known, .. } = sliding;
        let arrays = [(slip, "slip"), (line, "line"), (force, "force"), (second, "second"), (known, "known")];
        let mut places: Vec<(Expr, Source)> = Vec::new();
        for (symbols, array) in arrays {
            places
                .push_all(symbols.iter().enumerate().map(|(k, &symbol)| (symbol, Source::Element(array, k))));
        }
        let routine = |function: &Function| parts.routine_with(function, origin, &places);
        let turning = match origin {
            Origin::Chart(chart) => chart.turning.iter().map(Option::is_some).collect_vec(),
            _ => (0..parts.equations.q.len()).map(|k| k % 3 == 2).collect_vec(),
        };
        Sliding {
            motion: routine(&sliding.motion),
            sweep: routine(&sliding.sweep),
            sizes: routine(&sliding.sizes),
            is_explicit: sliding.is_explicit,
            known: known.len(),
            angles: turning,
        }
    }
}

impl Conditional {
    fn new(parts: &Parts, own: &formulate::Conditional) -> Conditional {
        let model = parts.model;
        let rows = || own.rows.iter().map(|row| &model.contacts[*row]);
        let of_pose = |function: &Function| parts.routine(function, Origin::Pose);
        Conditional {
            rows: own.rows.clone(),
            names: names(rows().map(|row| &row.name)),
            parts: names(rows().map(|row| &model.parts[row.part].name.text)),
            angular: rows().map(|row| row.unit.text == "rad").collect_vec(),
            phi: of_pose(&own.phi),
            phi_dot: of_pose(&own.phi_dot),
            phi_q: of_pose(&own.phi_q),
            places: own.places.clone(),
        }
    }
}
