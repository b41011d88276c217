//! Checks of the whole mechanism: reach, mobility, assembly, the first evaluation.

mod assembly;
mod branch;
mod pseudo_inverse;
mod rank;
mod start;

use plm_cas::{Expr, Graph};

pub(crate) use assembly::{Assembly, run, value};
pub(crate) use branch::branches;

use crate::derive::Equations;
use crate::diag::{Code, Diagnostics};
use crate::formulate::Absolute;
use crate::model::Model;
use crate::report::Report;

/// Names that one message lists.
const MOST_NAMES: usize = 8;

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
    for (body, _) in model.bodies.iter().zip(&reached).filter(|(_, reached)| !**reached) {
        let name = &body.name.text;
        diagnostics
            .warning(Code::Unreached, body.name.span, format!("nothing holds or reaches body `{name}`: it moves freely"))
            .help(format!("join it: `revolute pin(ground.o, {name}.a);`, or `allow({})` if this is meant", Code::Unreached));
    }
}

/// Default values of all symbols but coordinates and velocities, at time zero.
pub(crate) fn defaults(model: &Model, graph: &Graph) -> Vec<(Expr, f64)> {
    let mut values = vec![(model.time, 0.0)];
    for param in &model.params {
        values.push((param.symbol, value(graph, param.default, &values)));
    }
    for input in &model.inputs {
        values.push((input.symbol, value(graph, input.default, &values)));
    }
    for state in &model.states {
        values.push((state.symbol, value(graph, state.start, &values)));
    }
    values
}

/// Assembles the declared start and reports what is wrong with it.
///
/// Where a dimension is a parameter the run can change it, so that only the run can judge; the report tells what the
/// defaults give.
pub(crate) fn check_assembly(
    model: &Model,
    equations: &Equations,
    program: &Absolute,
    graph: &Graph,
    report: &mut Report,
    diagnostics: &mut Diagnostics,
) {
    let values = defaults(model, graph);
    let found = assembly::assemble(model, equations, program, graph, &values);
    report.add_assembly(model, &found, &|expr| value(graph, expr, &values));
    if has_parameters(model, graph) {
        return;
    }
    let rows = equations.phi.len();
    let (locks, joints): (Vec<_>, Vec<_>) = found.rank.dependent.iter().partition(|(row, _)| *row >= rows);
    if !locks.is_empty() {
        too_many_locks(model, &found.locked, &locks, rows, "position", diagnostics);
    } else if !found.is_closed() {
        not_closed(model, &found, diagnostics);
    } else {
        redundant_joints(model, &joints, diagnostics);
        velocities(model, &found, rows, diagnostics);
        start::check_start(model, equations, graph, &values, &found, diagnostics);
    }
}

/// Do constraints or starts depend on parameters?
fn has_parameters(model: &Model, graph: &Graph) -> bool {
    let starts = model.bodies.iter().flat_map(|body| body.start.iter().chain(&body.start_velocity));
    let mut roots: Vec<Expr> = starts.map(|start| start.value).collect();
    roots.extend(model.rows.iter().map(|row| row.phi));
    roots.extend(model.bodies.iter().flat_map(|body| body.centre));
    let held = graph.symbols(&roots);
    model.params.iter().any(|param| held.contains(&param.symbol))
}

/// Locks that depend on the joints and on each other.
fn too_many_locks(
    model: &Model,
    locked: &[bool],
    dependent: &[&(usize, Vec<usize>)],
    rows: usize,
    what: &str,
    diagnostics: &mut Diagnostics,
) {
    let coordinates: Vec<usize> = (0..locked.len()).filter(|&k| locked[k]).collect();
    let names = |row: &usize| match row.checked_sub(rows) {
        Some(lock) => format!("`{}` (locked)", lock_name(model, coordinates[lock], what)),
        None => format!("`{}`", model.rows[*row].name),
    };
    let mut members: Vec<usize> = dependent.iter().flat_map(|(_, rows)| rows.iter().copied()).collect();
    members.sort_unstable();
    members.dedup();
    let listed: Vec<String> = members.iter().take(MOST_NAMES).map(names).collect();
    let count = dependent.len();
    let first = coordinates[dependent[0].0 - rows];
    let body = &model.bodies[first / 3];
    let start = if what == "position" { &body.start } else { &body.start_velocity };
    let (verb, plural) = if count == 1 { ("is", "constraint") } else { ("are", "constraints") };
    diagnostics
        .error(
            Code::TooManyLocks,
            start[first % 3].span,
            format!("there {verb} {count} redundant {plural} among the {what} locks"),
        )
        .note(format!("these say the same: {}", listed.join(", ")))
        .note(format!(
            "F = 3 N - M = {} with {} locked",
            3 * model.bodies.len() as isize - rows as isize,
            coordinates.len()
        ))
        .help(format!("take away {count} of the locks"));
}

fn lock_name(model: &Model, k: usize, what: &str) -> String {
    let body = &model.bodies[k / 3].name.text;
    let names = if what == "position" { ["x", "y", "angle"] } else { ["vx", "vy", "omega"] };
    format!("{body}.{}", names[k % 3])
}

fn not_closed(model: &Model, found: &Assembly, diagnostics: &mut Diagnostics) {
    let size = |residual: &f64| if residual.is_finite() { residual.abs() } else { f64::INFINITY };
    let widest = (0..found.phi.len()).max_by(|&a, &b| size(&found.phi[a]).total_cmp(&size(&found.phi[b])));
    let Some(widest) = widest else { return };
    let row = &model.rows[widest];
    let part = &model.parts[row.part];
    let gap = found.phi[widest].abs();
    diagnostics
        .error(
            Code::NotAssembled,
            row.span,
            format!("the mechanism cannot be assembled: `{}` stays open by {gap:.3e} {}", part.name.text, row.unit.text),
        )
        .note(format!("row `{}` after {} Newton steps from the declared start", row.name, found.steps))
        .help("check the dimensions of the loop, or start its bodies closer to where they should be");
}

/// Joints that say what others say already, and agree with them.
fn redundant_joints(model: &Model, dependent: &[&(usize, Vec<usize>)], diagnostics: &mut Diagnostics) {
    for (row, members) in dependent {
        let listed: Vec<String> = members.iter().take(MOST_NAMES).map(|&k| format!("`{}`", model.rows[k].name)).collect();
        let name = &model.rows[*row].name;
        diagnostics
            .warning(Code::RedundantConstraint, model.rows[*row].span, format!("constraint `{name}` is redundant"))
            .note(format!("these depend on each other: {}", listed.join(", ")))
            .note("it runs by the rank-revealing solution; reactions that redundancy leaves open get their minimum norm");
    }
}

fn velocities(model: &Model, found: &Assembly, rows: usize, diagnostics: &mut Diagnostics) {
    let locks: Vec<_> = found.velocity_rank.dependent.iter().filter(|(row, _)| *row >= rows).collect();
    if !locks.is_empty() {
        too_many_locks(model, &found.velocity_locked, &locks, rows, "velocity", diagnostics);
        return;
    }
    if found.moves_consistently() {
        return;
    }
    let widest = (0..rows).max_by(|&a, &b| found.phi_dot[a].abs().total_cmp(&found.phi_dot[b].abs()));
    if let Some(row) = widest.map(|row| &model.rows[row]) {
        diagnostics.error(
            Code::NotAssembled,
            row.span,
            format!("the start velocities contradict `{}`", model.parts[row.part].name.text),
        );
    }
}
