//! Forces and conditions that read accelerations or reactions in a way that no linear system solves.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, algebra};

use crate::derive::{ForcingTerm, forcing_terms};
use crate::diag::{Code, Diagnostics};
use crate::model::{Model, Name};

/// Reports forces that are not affine in what they read of the unknowns, and those that jump on conditions which read them.
pub(crate) fn check_feedback(model: &Model, diagnostics: &mut Diagnostics) {
    let unknowns = unknowns(model);
    for (part, read) in cycles(model, &unknowns) {
        let message = format!(
            "the force of `{}` depends on {}, which it acts on, and not in proportion",
            part.text,
            read.join(" and ")
        );
        diagnostics
            .error(Code::Feedback, part.span, message)
            .help("feed it back in proportion, or through a `state` that follows it with a lag");
    }
    for switch in &model.switches {
        let held = algebra::symbols(&[switch.difference]);
        let Some((_, name)) = unknowns.iter().find(|(symbol, _)| held.contains(symbol)) else { continue };
        // Events read them; what jumps with their conditions would change what these read.
        let jumps = |term: &ForcingTerm| algebra::symbols(&[term.value]).contains(&switch.symbol);
        if let Some(term) = forcing_terms(model).find(jumps) {
            let message = format!("`{}` jumps on a condition that reads {name}", term.name.text);
            diagnostics
                .error(Code::Feedback, term.name.span, message)
                .help("let the condition read a `state` that follows it with a lag");
        }
    }
}

/// Whose forces are not affine in unknowns, and in which.
fn cycles<'a>(model: &'a Model, unknowns: &'a [(Expr, String)]) -> Vec<(&'a Name, Vec<&'a str>)> {
    let mut cycles: Vec<(&Name, Vec<&str>)> = Vec::new();
    for term in forcing_terms(model).filter(|term| term.is_force) {
        let held = algebra::symbols(&[term.value]);
        for (symbol, name) in unknowns.iter().filter(|(symbol, _)| held.contains(symbol)) {
            let left = algebra::symbols(&[term.value.diff(*symbol)]);
            if !unknowns.iter().any(|(of, _)| left.contains(of)) {
                continue;
            }
            match cycles.iter_mut().find(|(of, _)| *of == term.name) {
                Some((_, read)) if read.contains(&name.as_str()) => {}
                Some((_, read)) => read.push(name),
                None => cycles.push((term.name, vec![name])),
            }
        }
    }
    cycles
}

/// Symbols of the unknowns of the equations of motion, and how to speak of them.
fn unknowns(model: &Model) -> Vec<(Expr, String)> {
    let accelerations = model.bodies.iter().flat_map(|body| {
        let names = ["ax", "ay", "alpha"].map_each(|of| format!("`{}.{of}`", body.name.text));
        body.a.into_iter().zip(names)
    });
    let reactions = model.rows.iter().map(|row| (row.lambda, format!("the reaction of `{}`", row.name)));
    accelerations.chain(reactions).collect_vec()
}
