//! Facts of a mechanism beside its equations, for whoever writes it: as Rust, or as data.

pub(crate) mod conditions;
pub(crate) mod contact;
pub(crate) mod limits;
pub(crate) mod quantities;
pub(crate) mod state;

use plm_cas::{Expr, algebra};

use crate::collect::CollectVec;
use crate::derive::Equations;
use crate::formulate::{Absolute, Reduced, is_tree};
use crate::model::{Model, Stabilisation};

/// Does a constraint know the time? Then it does work that the energy does not count.
pub(crate) fn knows_time(model: &Model) -> bool {
    let rows = model.rows.iter().map(|row| row.phi);
    let switches = model.jumps.iter().map(|jump| model.switches[jump.switch].difference);
    let released = model.released.iter().map(|(_, condition)| *condition);
    let roots: Vec<Expr> = rows.chain(switches).chain(released).collect_vec();
    algebra::symbols(&roots).contains(&model.time)
}

/// Has it loops, or constraints whose rank may drop? That of a tree of joints does not. Where Baumgarte's stabilisation lets states
/// drift from the constraints, there are no poses to come back to. Contact goes on without.
pub(crate) fn may_be_singular(model: &Model, equations: &Equations, reduced: Option<&Reduced>) -> bool {
    let projects = matches!(model.stabilisation, Stabilisation::Projection);
    model.contacts.is_empty()
        && match reduced {
            None => projects && !equations.phi.is_empty() && !is_tree(model),
            Some(reduced) => reduced.has_loops(),
        }
}

/// Is there a coordinate whose turns are counted and that moves no loop?
pub(crate) fn is_loose(model: &Model, reduced: &Reduced) -> bool {
    let is_counted = |body: usize| model.turns.iter().any(|counted| counted.bodies.contains(&body));
    reduced.charts.iter().any(|chart| {
        chart.turning.iter().zip(&chart.free).any(|(body, free)| *free && body.is_some_and(is_counted))
    })
}

/// Does an output or an event read accelerations or multipliers?
pub(crate) fn reads_solution(model: &Model, equations: &Equations, absolute: &Absolute) -> bool {
    absolute.outputs.user.iter().any(|output| output.solves) || conditions::read_solution(model, equations)
}
