//! Checks of the whole mechanism: reach, mobility, assembly, the first evaluation.

mod assembly;
mod branch;
mod jumps;
mod names;
mod pairs;
mod pseudo_inverse;
mod random;
mod rank;
mod regular;
mod size;
mod start;
mod verdict;

use std::collections::BTreeSet;

use plm_cas::{Expr, algebra};

pub(crate) use assembly::{Assembly, assemble, run, value};
pub(crate) use branch::check_branches;
pub(crate) use jumps::check_jumps;
pub(crate) use names::check_names;
pub(crate) use pairs::check_pairs;
pub(crate) use random::Random;
pub(crate) use regular::freedom;
pub(crate) use size::check_size;

use crate::derive::Equations;
use crate::diag::{Code, Diagnostics};
use crate::formulate::{Absolute, Reduced};
use crate::model::{Model, Port};
use crate::report::Report;
use verdict::{Locks, contradiction, not_closed, redundant_joints, strained, too_many_locks};

/// Is there a mechanism at all, and is every body part of it?
pub(crate) fn check_reach(model: &Model, diagnostics: &mut Diagnostics) {
    if model.bodies.is_empty() {
        diagnostics
            .error(Code::NoBody, model.name.span, format!("`{}` has no body", model.name.text))
            .help("declare one: `body arm { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; }`");
    }
    let mut reached = vec![false; model.bodies.len()];
    let frames = model.parts.iter().flat_map(|part| &part.frames);
    for body in frames.filter_map(|frame| frame.body) {
        reached[body] = true;
    }
    for load in &model.loads {
        reached[load.body] = true;
    }
    // A constraint of its own joins no frames.
    let rows: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect();
    let held: BTreeSet<Expr> = algebra::symbols(&rows).into_iter().collect();
    for (reached, body) in reached.iter_mut().zip(&model.bodies) {
        *reached |= body.q.iter().any(|coordinate| held.contains(coordinate));
    }
    for (body, _) in model.bodies.iter().zip(&reached).filter(|(_, reached)| !**reached) {
        let name = &body.name.text;
        let port = |ports: &[Port], default| ports.first().map_or(default, |port| port.name.text.clone());
        let joint = format!(
            "revolute pin(ground.{}, {name}.{});",
            port(&model.ground, "o".to_owned()),
            port(&body.ports, "a".to_owned())
        );
        diagnostics
            .warning(
                Code::Unreached,
                body.name.span,
                format!("nothing holds or reaches body `{name}`: it moves freely"),
            )
            .help(format!("join it: `{joint}`, or `allow({})` if this is meant", Code::Unreached));
    }
}

/// Default values of all symbols but coordinates and velocities, at time zero.
pub(crate) fn defaults(model: &Model) -> Vec<(Expr, f64)> {
    // f64's `Scalar::AGREEMENT`.
    let agreement = 1e9;
    let mut values =
        vec![(model.time, 0.0), (model.most_growth, f64::INFINITY), (model.agreement, agreement)];
    for param in &model.params {
        values.push((param.symbol, value(param.default, &values)));
    }
    for input in &model.inputs {
        values.push((input.symbol, value(input.default, &values)));
    }
    for state in &model.states {
        values.push((state.symbol, value(state.start, &values)));
    }
    values
}

/// Values of parameters, inputs and states where those parameters that have dimensions of a mechanism are others than declared;
/// none without parameters.
pub(crate) fn varied(model: &Model, seed: u64) -> Option<Vec<(Expr, f64)>> {
    let mut random = Random(seed);
    let mut values = defaults(model);
    for param in &model.params {
        let (_, value) = values.iter_mut().find(|(symbol, _)| *symbol == param.symbol)?;
        *value += (0.3 + 0.2 * value.abs()) * random.unit();
    }
    (!model.params.is_empty()).then_some(values)
}

/// Adds the sides of the conditions at a state whose other symbols have values.
pub(crate) fn add_sides(model: &Model, values: &mut Vec<(Expr, f64)>) {
    for side in &model.sides {
        let difference = value(side.difference, values);
        values.push((side.symbol, if difference < 0.0 { -1.0 } else { 1.0 }));
    }
}

/// Compliances that are known to be wrong only with the defaults of the parameters that they read; false if there are some.
fn check_limits(model: &Model, values: &[(Expr, f64)], diagnostics: &mut Diagnostics) -> bool {
    let mut are_kept = true;
    for limit in &model.limits {
        let found = value(limit.value, values);
        if found.is_finite() && (found > 0.0 || (limit.or_zero && found == 0.0)) {
            continue;
        }
        are_kept = false;
        let wanted = if limit.or_zero { "finite and not negative" } else { "positive and finite" };
        let (what, part, unit) = (&limit.what, &limit.part, &limit.unit);
        let message = format!("the {what} of `{part}` must be {wanted}, found {found} {unit}");
        diagnostics
            .error(Code::NotPositive, limit.span, message)
            .note("this is its value with the defaults of the parameters");
    }
    are_kept
}

/// Masses and inertias that are known to be wrong only with the defaults of the parameters that they read.
fn check_masses(model: &Model, values: &[(Expr, f64)], diagnostics: &mut Diagnostics) {
    for body in &model.bodies {
        let mass = ("mass", body.mass, body.mass_span, "kg");
        let inertia = ("inertia", body.inertia, body.inertia_span, "kg*m^2");
        for (what, expr, span, unit) in [mass, inertia] {
            let found = value(expr, values);
            if model.reads_required(expr) {
                continue;
            }
            if !(found > 0.0 && found.is_finite()) {
                let name = &body.name.text;
                let message =
                    format!("the {what} of `{name}` must be positive and finite, found {found} {unit}");
                let diagnostic = diagnostics.error(Code::NotPositive, span, message);
                if expr.as_number().is_none() {
                    diagnostic.note("this is its value with the defaults of the parameters");
                }
            }
        }
    }
}

/// Reports what is wrong with the start as it was assembled.
///
/// Where a dimension is a parameter the run can change it, so that only the run can judge; the report tells what the
/// defaults give.
pub(crate) fn check_assembly(
    model: &Model,
    equations: &Equations,
    (program, reduced): (&Absolute, Option<&Reduced>),
    found: &Assembly,
    report: &mut Report,
    diagnostics: &mut Diagnostics,
) {
    let values = defaults(model);
    check_masses(model, &values, diagnostics);
    let limits_are_kept = check_limits(model, &values, diagnostics);
    let turns: Vec<Expr> = equations.branches.iter().map(|branch| branch.turn).collect();
    let mut assembled = found.values(equations, &values);
    add_sides(model, &mut assembled);
    let turns = run(&algebra::tape(&turns), &assembled);
    report.add_assembly(model, equations, found, &turns);
    report.add_measures(&measures(reduced, &assembled), reduced);
    if has_parameters(model) {
        return;
    }
    let rows = equations.phi.len();
    let (locks, joints): (Vec<_>, Vec<_>) = found.rank.dependent.iter().partition(|(row, _)| *row >= rows);
    if !locks.is_empty() {
        let positions = Locks { locked: &found.locked, what: "position" };
        too_many_locks(model, &positions, &locks, diagnostics);
    } else if found.phi.iter().any(|residual| !residual.is_finite()) {
        start::check_rows(model, equations, &values, found, diagnostics);
    } else if !found.is_closed() {
        not_closed(model, found, report.length, diagnostics);
    } else {
        branch::not_found(&branch::asked(model, equations, &values), &found.q, model, diagnostics);
        redundant_joints(model, &joints, diagnostics);
        check_velocities(model, found, diagnostics);
        let compliant: Vec<Expr> = model.compliant.iter().map(|row| row.phi).collect();
        let open = run(&algebra::tape(&compliant), &found.values(equations, &values));
        strained(model, &open, report.length, diagnostics);
        // What divides by such a compliance has been told of it.
        if limits_are_kept {
            start::check_start(model, equations, (program, &values), found, diagnostics);
        }
    }
}

/// How far each chart is from flat at the start: 1 at best, 0 where a loop lies in one line.
fn measures(reduced: Option<&Reduced>, values: &[(Expr, f64)]) -> Vec<f64> {
    let surveys =
        reduced.into_iter().flat_map(|reduced| &reduced.charts).filter_map(|chart| chart.survey.as_ref());
    let squares = surveys.filter_map(|survey| survey.results.last());
    squares.map(|&(_, square)| value(square, values).max(0.0).sqrt()).collect()
}

/// Do constraints or starts depend on parameters?
fn has_parameters(model: &Model) -> bool {
    let starts = model.bodies.iter().flat_map(|body| body.start.iter().chain(&body.start_velocity));
    let mut roots: Vec<Expr> = starts.map(|start| start.value).collect();
    roots.extend(model.rows.iter().map(|row| row.phi));
    roots.extend(model.bodies.iter().flat_map(|body| body.centre.components()));
    roots.extend(model.sides.iter().filter(|side| !side.must_hold).map(|side| side.difference));
    let held = algebra::symbols(&roots);
    model.params.iter().any(|param| held.contains(&param.symbol))
}

fn check_velocities(model: &Model, found: &Assembly, diagnostics: &mut Diagnostics) {
    let rows = model.rows.len();
    let locks: Vec<_> = found.velocity_rank.dependent.iter().filter(|(row, _)| *row >= rows).collect();
    if !locks.is_empty() {
        let velocities = Locks { locked: &found.velocity_locked, what: "velocity" };
        too_many_locks(model, &velocities, &locks, diagnostics);
    } else if !found.moves_consistently() {
        contradiction(model, found, diagnostics);
    }
}
