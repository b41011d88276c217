//! The declared start: locks, joints that do not close, branches, velocities, the first evaluation.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use super::branch::not_found;
use super::finite::{check_forces, check_rows};
use super::positive::{check_limits, check_masses};
use super::verdict::{
    Locks, change_point, contradiction, far, not_closed, redundant_joints, strained, too_many_locks,
};
use crate::diag::{Diagnostics, Severity};
use crate::model::Model;
use crate::numeric::{Assembly, Scene, run};

/// Reports what is wrong with the start as it was assembled.
///
/// If the assembly depends on parameters, only the run knows the dimensions. Excess locks, and joints that do not close with the defaults,
/// are then warnings, and the checks that follow are left out.
pub(crate) fn check_start(scene: &Scene, found: &Assembly, diagnostics: &mut Diagnostics) {
    check_masses(scene, diagnostics);
    let limits_are_kept = check_limits(scene, diagnostics);
    let model = scene.model;
    let rows = model.rows.len();
    let (locks, joints): (Vec<_>, Vec<_>) = found.rank.dependent.iter().partition(|(row, _)| *row >= rows);
    let positions = Locks { locked: &found.locked, what: "position" };
    if has_parameters(model) {
        let is_known = !model.params.iter().any(|param| param.required);
        if diagnostics.has_errors() || !is_known || found.phi.iter().any(|phi| !phi.is_finite()) {
            return;
        }
        if !locks.is_empty() {
            too_many_locks(model, (&positions, Severity::Warning), &locks, diagnostics);
        } else if !found.is_closed() {
            not_closed(model, found, (scene.length, Severity::Warning), diagnostics);
        }
        return;
    }
    if !locks.is_empty() {
        too_many_locks(model, (&positions, Severity::Error), &locks, diagnostics);
    } else if found.phi.iter().any(|phi| !phi.is_finite()) {
        check_rows(scene, found, diagnostics);
    } else if !found.is_closed() {
        not_closed(model, found, (scene.length, Severity::Error), diagnostics);
    } else {
        not_found(scene, found, diagnostics);
        redundant_joints(model, &joints, diagnostics);
        far(model, found, diagnostics);
        change_point(model, found, diagnostics);
        check_velocities(model, found, diagnostics);
        let compliant: Vec<Expr> = model.compliant.iter().map(|row| row.phi).collect_vec();
        let open = run(&algebra::tape(&compliant), &scene.moving(&found.q, &found.v));
        strained(model, &open, scene.length, diagnostics);
        // What divides by such a compliance has been told of it.
        if limits_are_kept {
            check_forces(scene, found, diagnostics);
        }
    }
}

/// Do constraints or starts depend on parameters?
fn has_parameters(model: &Model) -> bool {
    let starts = model.bodies.iter().flat_map(|body| body.start.iter().chain(&body.start_velocity));
    let mut roots: Vec<Expr> = starts.map(|start| start.value).collect_vec();
    roots.push_all(model.rows.iter().map(|row| row.phi));
    roots.push_all(model.bodies.iter().flat_map(|body| body.centre.components()));
    roots.push_all(model.switches.iter().filter(|switch| !switch.must_hold).map(|switch| switch.difference));
    let held = algebra::symbols(&roots);
    model.params.iter().any(|param| held.contains(&param.symbol))
}

/// Reports velocity locks that are too many, or start velocities that the joints do not allow.
fn check_velocities(model: &Model, found: &Assembly, diagnostics: &mut Diagnostics) {
    let rows = model.rows.len();
    let locks: Vec<_> = found.velocity_rank.dependent.iter().filter(|(row, _)| *row >= rows).collect_vec();
    if !locks.is_empty() {
        let velocities = Locks { locked: &found.velocity_locked, what: "velocity" };
        too_many_locks(model, (&velocities, Severity::Error), &locks, diagnostics);
    } else if !found.moves_consistently() {
        contradiction(model, found, diagnostics);
    }
}
