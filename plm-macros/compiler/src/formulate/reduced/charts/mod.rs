//! From which coordinates the loops are solved: every choice that leaves dyads alone is a chart; where there is none,
//! those that leave the smallest blocks.

pub(crate) mod kinematics;
pub(crate) mod redundant;
pub(crate) mod remember;

use crate::collect::{CollectVec, PushAll};
use crate::formulate::reduced::groups::Group;
use crate::formulate::reduced::groups::newton::MOST_UNKNOWNS;
use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::model::{Formulation, Model};
use crate::sorted::sort_by_key;
use crate::topology::{Block, Choice, Equation, independent_sets};

/// Charts beyond the degrees of freedom; more would be code that hardly ever runs.
const ALTERNATIVE_CHARTS: usize = 3;
/// Charts beyond the degrees of freedom where blocks are solved by Newton's iteration, whose code is long.
const ALTERNATIVE_LONG_CHARTS: usize = 1;

/// Choices that are looked at until those are found.
const MOST_TRIED: usize = 64;

/// Coordinates, and how everything else follows from them.
#[derive(Clone)]
pub(crate) struct Scheme {
    /// The unknowns that are coordinates.
    pub(crate) independent: Vec<usize>,
    /// The groups in the order of solution.
    pub(crate) groups: Vec<Group>,
}

impl Scheme {
    /// The groups that are loops, in the order of solution.
    pub(crate) fn loops(&self) -> impl Iterator<Item = &Group> {
        self.groups.iter().filter(|group| group.is_loop())
    }

    /// The unknowns that are found by iteration.
    pub(crate) fn iterated(&self) -> impl Iterator<Item = usize> {
        let groups = self.groups.iter().filter(|group| matches!(group, Group::Newton(_)));
        groups.flat_map(Group::unknowns)
    }
}

/// The charts of a mechanism, the best first; a tree has one, of all its unknowns.
///
/// # Errors
/// Why there is none: words that go on "absolute coordinates because …".
pub(crate) fn schemes(model: &Model, coordinates: &Coordinates) -> Result<Vec<Scheme>, String> {
    let n = coordinates.unknowns.len();
    if let (Some((Formulation::Tree, _)), Some(&chord)) = (model.formulation, coordinates.chords.first()) {
        return Err(format!("`{}` closes a loop", model.parts[coordinates.joints[chord].part].name.text));
    }
    let equations = equations(coordinates);
    if equations.is_empty() {
        return Ok(vec![Scheme { independent: (0..n).collect_vec(), groups: Vec::new() }]);
    }
    let rows: usize = equations.iter().map(|equation| equation.rows).sum();
    let freedom = match n.checked_sub(rows) {
        Some(freedom) if freedom > 0 || !coordinates.rows.is_empty() => freedom,
        _ => return Err("nothing can move, or constraints are redundant".to_owned()),
    };
    split(model, coordinates, &equations, freedom)
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
) -> Result<Vec<Scheme>, String> {
    let candidates = candidates(model, coordinates);
    let group = |block: &Block| Group::of(coordinates, block);
    // What has a closed form is small: the others are not worth a look here.
    let cost = |block: &Block| if block.unknowns.len() > 2 { None } else { group(block)?.cost() };
    let choices = independent_sets(coordinates.unknowns.len(), equations, freedom, &candidates, &cost);
    let Some(best) = choices.first() else {
        return Err("its constraints are redundant".to_owned());
    };
    let blocks = best.blocks.clone();
    let (closed, alternatives) =
        (best.closed, if best.closed { ALTERNATIVE_CHARTS } else { ALTERNATIVE_LONG_CHARTS });
    let scheme = |choice: Choice| {
        let groups: Option<Vec<Group>> = choice.blocks.iter().map(group).collect();
        groups.map(|groups| Scheme { groups, independent: choice.independent })
    };
    let alike = choices.into_iter().take_while(|choice| choice.closed == closed);
    let schemes: Vec<Scheme> =
        alike.take(MOST_TRIED).filter_map(scheme).take(freedom + alternatives).collect_vec();
    if schemes.is_empty() {
        let unsolved = blocks.iter().find(|block| group(block).is_none());
        return Err(unsolved.map_or_else(String::new, |block| no_form(model, coordinates, block)));
    }
    Ok(schemes)
}

/// Why a block has no form: "… because".
fn no_form(model: &Model, coordinates: &Coordinates, block: &Block) -> String {
    let count = block.unknowns.len();
    let loops = coordinates.closures.len();
    let own: Vec<&str> = model
        .rows
        .iter()
        .filter(|row| model.parts[row.part].pair.is_none())
        .enumerate()
        .filter(|(k, _)| block.equations.contains(&(loops + k)))
        .map(|(_, row)| row.name.as_str())
        .collect_vec();
    if !own.is_empty() {
        let with_loops = block.equations.iter().any(|equation| *equation < loops);
        let with_loops = if with_loops { " and its loops" } else { "" };
        let rows = if own.len() == 1 { "the row" } else { "the rows" };
        return format!(
            "{rows} `{}`{with_loops} must be solved together for {count} unknowns, and there is no form for that",
            own.join("`, `")
        );
    }
    let why = if count > MOST_UNKNOWNS {
        format!("more than the {MOST_UNKNOWNS} that Newton's iteration takes")
    } else {
        "and too few of the bars between them keep their length for Newton's iteration".to_owned()
    };
    format!(
        "its loops do not come apart into pairs of bodies: {count} unknowns must be found together, {why}"
    )
}

/// The unknowns of the loops, then those of the rows.
pub(crate) fn equations(coordinates: &Coordinates) -> Vec<Equation> {
    let loops = coordinates.closures.iter().map(|closure| {
        let mut unknowns = Vec::new();
        for (orientation, displacement, _) in closure.terms() {
            unknowns.push_all(coordinates.angle_of_orientation[orientation]);
            unknowns.push_all(displacement);
        }
        unknowns.sort_unstable();
        unknowns.dedup();
        Equation { unknowns, rows: 2 }
    });
    let rows = coordinates
        .rows
        .iter()
        .map(|row| Equation { unknowns: row.held.iter().map(|held| held.0).collect_vec(), rows: 1 });
    loops.chain(rows).collect_vec()
}

/// Coordinates in the order in which a person would choose them: what turns or slides on the ground first.
fn candidates(model: &Model, coordinates: &Coordinates) -> Vec<usize> {
    let grounded = |unknown: usize| {
        match coordinates.unknowns[unknown] {
        Unknown::Angle { orientation, .. } => coordinates.joints.iter().any(|joint| {
            let of_orientation = |body: usize| coordinates.absolute_angles[body].orientation == orientation;
            matches!((joint.a.body, joint.b.body), (None, Some(body)) | (Some(body), None) if of_orientation(body))
        }),
        Unknown::Displacement { part } => model.parts[part].frames.iter().any(|frame| frame.body.is_none()),
        Unknown::Centre { .. } => false,
    }
    };
    let mut candidates: Vec<usize> = (0..coordinates.unknowns.len()).collect_vec();
    sort_by_key(&mut candidates, |&unknown| !grounded(unknown));
    candidates
}
