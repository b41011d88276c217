//! Joint coordinates as data.

use super::routine::Routine;
use super::{Parts, names};
use crate::collect::{CollectVec, MapEach};
use crate::facts::state;
use crate::formulate::{self, Reduced};
use crate::model::Model;
use crate::source::Origin;

/// A choice of coordinates.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Names of the coordinates.
    pub names: Vec<String>,
    /// Names of their rates.
    pub rates: Vec<String>,
    /// `dx`; of loops, returning the smallest square of a dyad's measure.
    pub rate: Routine,
    /// `q`, `v` of all bodies; of loops, returning the same.
    pub pose: Routine,
    /// `x` of a state in absolute coordinates.
    pub from_pose: Routine,
    /// `g`, the guards of conditions, then kinks.
    pub guards: Routine,
    /// `a` of all bodies and `lambda` of all rows; of trees alone.
    pub reactions: Option<Routine>,
    /// The numbers to be remembered of a state, returning the square of the measure; of loops alone.
    pub remember: Option<Routine>,
    /// The numbers to be remembered of a pose and velocity.
    pub remember_pose: Option<Routine>,
    /// `by_x`, the entries of df/dx that are not zero; `dx` is the rate there. Where every chart of loops has them.
    pub jacobian: Option<Routine>,
    /// Places among the remembered angles that loops give.
    pub found: Vec<usize>,
    /// The parts that close the loops, in the order of solution.
    pub closing: Vec<String>,
}

/// The memory of loops: how many numbers of each kind, and whose they are.
#[derive(Clone, Debug)]
pub struct Loops {
    /// Number of coordinates of a chart.
    pub coordinates: usize,
    /// Names of the bodies whose angles are remembered.
    pub turning: Vec<String>,
    /// Number of determinants.
    pub determinants: usize,
    /// Bodies and joints of the unknowns that Newton's iteration starts from.
    pub iterated: Vec<String>,
    /// A coordinate whose turns are counted moves no loop.
    pub is_loose: bool,
    /// Are rows left out that say what others say?
    pub is_redundant: bool,
}

/// An angle whose whole turns are counted: where it stands.
#[derive(Clone, Debug, Default)]
pub struct Turns {
    /// Places in the pose of all bodies.
    pub in_pose: Vec<usize>,
    /// By chart, places in the state; of absolute coordinates those of the pose.
    pub in_state: Vec<Vec<usize>>,
    /// Places among the remembered angles.
    pub remembered: Vec<usize>,
    /// Places among the unknowns of iterations.
    pub iterated: Vec<usize>,
}

/// The charts, if joint coordinates are taken.
pub(super) fn charts(parts: &Parts) -> Vec<Chart> {
    let all = parts.reduced.iter().flat_map(|reduced| &reduced.charts);
    all.map(|chart| lowered(parts, chart)).collect_vec()
}

fn lowered(parts: &Parts, chart: &formulate::Chart) -> Chart {
    let origin = Origin::Chart(chart);
    Chart {
        names: chart.names.clone(),
        rates: chart.names.iter().map(|name| state::rate_of(name)).collect(),
        rate: parts.routine(&chart.rate, origin),
        pose: parts.routine(&chart.pose, origin),
        from_pose: parts.routine(&chart.from_pose, Origin::Pose),
        guards: parts.routine(&chart.guards, origin),
        reactions: chart.reactions.as_ref().map(|reactions| parts.routine(reactions, origin)),
        remember: chart.remember.as_ref().map(|remember| parts.routine(remember, origin)),
        remember_pose: chart.remember_pose.as_ref().map(|of_pose| parts.routine(of_pose, Origin::Pose)),
        jacobian: chart
            .jacobian
            .as_ref()
            .filter(|_| parts.reduced.is_some_and(Reduced::has_jacobian))
            .map(|jacobian| parts.routine(&jacobian.entries, origin)),
        found: chart.found.clone(),
        closing: chart.closing.clone(),
    }
}

impl Loops {
    pub(super) fn new(model: &Model, reduced: &Reduced) -> Loops {
        Loops {
            coordinates: reduced.freedom(),
            turning: names(reduced.turning.iter().map(|&body| &model.bodies[body].name.text)),
            determinants: reduced.areas,
            iterated: names(reduced.followed.iter().map(|(name, _)| name)),
            is_loose: crate::facts::is_loose(model, reduced),
            is_redundant: reduced.is_redundant(model),
        }
    }
}

/// By count, where its angles stand.
pub(super) fn turns(parts: &Parts) -> Vec<Turns> {
    let Parts { model, equations, reduced, .. } = parts;
    let in_pose = (0..equations.q.len()).map(|k| (k % 3 == 2).then_some(k / 3)).collect_vec();
    let lists: Vec<Vec<Option<usize>>> = match reduced {
        None => vec![in_pose.clone()],
        Some(reduced) => reduced.charts.iter().map(|chart| chart.turning.clone()).collect_vec(),
    };
    let remembered = reduced.iter().flat_map(|reduced| &reduced.turning).copied().map(Some).collect_vec();
    let iterated = reduced.iter().flat_map(|reduced| &reduced.followed).map(|(_, body)| *body).collect_vec();
    let of_count = |counted: &crate::model::Counted| {
        let places = |list: &[Option<usize>]| {
            let own = |body: &Option<usize>| body.is_some_and(|body| counted.bodies.contains(&body));
            list.iter().enumerate().filter(|(_, body)| own(body)).map(|(place, _)| place).collect_vec()
        };
        let [in_pose, remembered, iterated] =
            [&in_pose, &remembered, &iterated].map_each(|list| places(list));
        Turns { in_pose, in_state: lists.iter().map(|list| places(list)).collect_vec(), remembered, iterated }
    };
    model.turns.iter().map(of_count).collect_vec()
}
