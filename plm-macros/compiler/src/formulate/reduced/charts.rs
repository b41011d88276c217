//! From which coordinates the loops are solved: every choice that leaves dyads alone is a chart.

use std::cell::RefCell;

use plm_cas::Graph;

use super::coordinates::{Coordinates, Unknown};
use super::dyad::Dyad;
use crate::model::{Model, Rung};
use crate::topology::{Block, Equation, drivers};

/// Charts beyond the degrees of freedom; more would be code that hardly ever runs.
const SPARE_CHARTS: usize = 3;

/// Coordinates, and how everything else follows from them.
#[derive(Clone, Debug)]
pub(crate) struct Scheme {
    /// The unknowns that are coordinates.
    pub(crate) drivers: Vec<usize>,
    /// The dyads in the order of solution.
    pub(crate) dyads: Vec<Dyad>,
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
    if coordinates.closures.is_empty() {
        return Ok(vec![Scheme { drivers: (0..n).collect(), dyads: Vec::new() }]);
    }
    if let (Some((Rung::Tree, _)), Some(&chord)) = (model.rung, coordinates.chords.first()) {
        return Err(format!("`{}` closes a loop", model.parts[coordinates.joints[chord].part].name.text));
    }
    let equations: Vec<Equation> =
        (0..coordinates.closures.len()).map(|k| equation(coordinates, k)).collect();
    let freedom = match n.checked_sub(2 * equations.len()) {
        None | Some(0) => return Err("nothing can move, or constraints are redundant".to_owned()),
        Some(freedom) => freedom,
    };
    let candidates = candidates(model, coordinates);
    let graph = RefCell::new(graph);
    let dyad = |block: &Block| match (block.equations.as_slice(), block.unknowns.as_slice()) {
        (&[closure], &[first, second]) => {
            Dyad::of(coordinates, closure, [first, second], &mut graph.borrow_mut())
        }
        _ => None,
    };
    let choices = drivers(n, &equations, freedom, &candidates, &|block| dyad(block).map(|dyad| dyad.cost()));
    if choices.is_empty() {
        return Err("its constraints are redundant".to_owned());
    }
    let closed = choices.into_iter().filter(|choice| choice.closed).take(freedom + SPARE_CHARTS);
    let schemes: Vec<Scheme> = closed
        .map(|choice| Scheme {
            drivers: choice.drivers,
            dyads: choice.blocks.iter().filter_map(dyad).collect(),
        })
        .collect();
    if schemes.is_empty() {
        Err("no choice of coordinates splits its loops into dyads".to_owned())
    } else {
        Ok(schemes)
    }
}

/// The unknowns of a loop.
fn equation(coordinates: &Coordinates, closure: usize) -> Equation {
    let mut unknowns = Vec::new();
    for (class, slide, _) in coordinates.closures[closure].terms() {
        unknowns.extend(coordinates.angle_of_class[class]);
        unknowns.extend(slide);
    }
    unknowns.sort_unstable();
    unknowns.dedup();
    Equation { unknowns, rows: 2 }
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
