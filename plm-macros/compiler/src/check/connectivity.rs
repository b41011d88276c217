//! Connectivity: there is a mechanism, and every body is part of it.

use crate::collect::CollectVec;
use crate::sorted::SortedSet;

use plm_cas::{Expr, algebra};

use crate::diag::{Code, Diagnostics};
use crate::model::{Model, Port};

/// Reports a mechanism without bodies, and bodies that nothing holds or acts on.
pub(crate) fn check_connectivity(model: &Model, diagnostics: &mut Diagnostics) {
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
    let rows: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect_vec();
    let held: SortedSet<Expr> = algebra::symbols(&rows).into_iter().collect();
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
