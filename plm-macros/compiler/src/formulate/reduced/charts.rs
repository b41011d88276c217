//! From which coordinates the loops are solved: every choice that leaves dyads alone is a chart.

use std::cell::RefCell;

use plm_cas::Graph;

use super::coordinates::{Coordinates, Unknown};
use super::groups::Group;
use crate::model::{Model, Rung};
use crate::topology::{Block, Equation, drivers};

/// Charts beyond the degrees of freedom; more would be code that hardly ever runs.
const SPARE_CHARTS: usize = 3;

/// Coordinates, and how everything else follows from them.
#[derive(Clone, Debug)]
pub(crate) struct Scheme {
    /// The unknowns that are coordinates.
    pub(crate) drivers: Vec<usize>,
    /// The groups in the order of solution.
    pub(crate) groups: Vec<Group>,
}

impl Scheme {
    /// The groups that are loops, in the order of solution.
    pub(crate) fn loops(&self) -> impl Iterator<Item = &Group> {
        self.groups.iter().filter(|group| group.is_loop())
    }
}

/// The charts of a mechanism, the best first; a tree has one, of all its unknowns.
///
/// # Errors
/// Why there is none: words that go on "rung 5 because …".
pub(crate) fn schemes(
    model: &Model,
    coordinates: &Coordinates,
    graph: &mut Graph,
) -> Result<Vec<Scheme>, String> {
    let n = coordinates.unknowns.len();
    if let (Some((Rung::Tree, _)), Some(&chord)) = (model.rung, coordinates.chords.first()) {
        return Err(format!("`{}` closes a loop", model.parts[coordinates.joints[chord].part].name.text));
    }
    let equations = equations(coordinates);
    if equations.is_empty() {
        return Ok(vec![Scheme { drivers: (0..n).collect(), groups: Vec::new() }]);
    }
    let rows: usize = equations.iter().map(|equation| equation.rows).sum();
    let freedom = match n.checked_sub(rows) {
        Some(freedom) if freedom > 0 || !coordinates.rows.is_empty() => freedom,
        _ => return Err("nothing can move, or constraints are redundant".to_owned()),
    };
    split(model, coordinates, &equations, freedom, graph)
}

/// The charts of some equations that leave so much freedom.
///
/// # Errors
/// As [`schemes`].
pub(crate) fn split(
    model: &Model,
    coordinates: &Coordinates,
    equations: &[Equation],
    freedom: usize,
    graph: &mut Graph,
) -> Result<Vec<Scheme>, String> {
    let candidates = candidates(model, coordinates);
    let graph = RefCell::new(graph);
    let group = |block: &Block| Group::of(coordinates, block, &mut graph.borrow_mut());
    let cost = |block: &Block| group(block).map(|group| group.cost());
    let choices = drivers(coordinates.unknowns.len(), equations, freedom, &candidates, &cost);
    if choices.is_empty() {
        return Err("its constraints are redundant".to_owned());
    }
    let closed = choices.into_iter().filter(|choice| choice.closed).take(freedom + SPARE_CHARTS);
    let schemes: Vec<Scheme> = closed
        .map(|choice| Scheme {
            groups: choice.blocks.iter().filter_map(group).collect(),
            drivers: choice.drivers,
        })
        .collect();
    if schemes.is_empty() {
        return Err("no choice of coordinates splits its loops into dyads".to_owned());
    }
    Ok(schemes)
}

/// The unknowns of the loops, then those of the rows.
pub(crate) fn equations(coordinates: &Coordinates) -> Vec<Equation> {
    let loops = coordinates.closures.iter().map(|closure| {
        let mut unknowns = Vec::new();
        for (class, slide, _) in closure.terms() {
            unknowns.extend(coordinates.angle_of_class[class]);
            unknowns.extend(slide);
        }
        unknowns.sort_unstable();
        unknowns.dedup();
        Equation { unknowns, rows: 2 }
    });
    let rows = coordinates
        .rows
        .iter()
        .map(|row| Equation { unknowns: row.terms.iter().map(|term| term.0).collect(), rows: 1 });
    loops.chain(rows).collect()
}

/// Coordinates in the order in which a person would choose them: what turns or slides on the ground first.
fn candidates(model: &Model, coordinates: &Coordinates) -> Vec<usize> {
    let grounded = |unknown: usize| match coordinates.unknowns[unknown] {
        Unknown::Angle { class, .. } => coordinates.joints.iter().any(|joint| {
            let of_class = |body: usize| coordinates.headings[body].class == class;
            matches!((joint.a.body, joint.b.body), (None, Some(body)) | (Some(body), None) if of_class(body))
        }),
        Unknown::Slide { part } => model.parts[part].frames.iter().any(|frame| frame.body.is_none()),
        Unknown::Centre { .. } => false,
    };
    let mut candidates: Vec<usize> = (0..coordinates.unknowns.len()).collect();
    candidates.sort_by_key(|&unknown| !grounded(unknown));
    candidates
}
