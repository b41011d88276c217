//! Bodies without mass: those that move freely, and what asks for forces that depend on their masses.

use crate::collect::CollectVec;

use crate::derive::{Massless, forcing_terms};
use crate::diag::{Code, Diagnostics};
use crate::model::Model;
use crate::numeric::{Assembly, Scene, moves};
use crate::span::Span;

/// Reports bodies without mass whose motion depends on it, and outputs, forces and rates that do.
pub(crate) fn check_massless(
    scene: &Scene,
    massless: Option<&Massless>,
    found: &Assembly,
    diagnostics: &mut Diagnostics,
) {
    let (model, Some(massless)) = (scene.model, massless) else { return };
    let mut free = massless.free(model);
    if free.is_empty() {
        free = free_at_the_start(scene, massless, found);
    }
    for &body in &free {
        let name = &model.bodies[body].name;
        let message = format!("the body `{}` moves freely and has no mass", name.text);
        diagnostics.error(Code::MissingValue, name.span, message).help(format!(
            "write `width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3;` for a bar of steel, or \
             `mass: 1 kg; inertia: 1 kg*m^2;`, or determine the motion by constraints such as \
             `constraint turns: {}.angle = 1 rad/s*t;`",
            name.text
        ));
    }
    if !free.is_empty() {
        return;
    }
    let outputs = model.outputs.iter().filter(|output| output.declared);
    for output in outputs {
        let needed = massless.needed_by(&output.components);
        let what = format!("the output `{}` depends on", output.name.text);
        report(model, &needed, (&what, "leave the output out"), output.name.span, diagnostics);
    }
    for term in forcing_terms(model) {
        let needed = massless.needed_by(&[term.value]);
        let of = if term.is_force { "force" } else { "rate" };
        let what = format!("the {of} of `{}` reads a reaction that depends on", term.name.text);
        report(model, &needed, (&what, "let it read none"), term.name.span, diagnostics);
    }
}

/// Bodies without mass that are free though structure does not say so: dimensions make rows repeat each other.
fn free_at_the_start(scene: &Scene, massless: &Massless, found: &Assembly) -> Vec<usize> {
    let may_move = |body: &usize| massless.repeats && moves(scene, found, *body);
    massless.bodies.iter().copied().filter(may_move).collect_vec()
}

fn report(
    model: &Model,
    needed: &[usize],
    (what, instead): (&str, &str),
    span: Span,
    diagnostics: &mut Diagnostics,
) {
    let Some(&first) = needed.first() else { return };
    let (masses, have, them) = if needed.len() == 1 {
        ("the mass of", "has none", "the body")
    } else {
        ("the masses of", "have none", "each of them")
    };
    let names = listed(model, needed);
    let first = &model.bodies[first].name;
    diagnostics
        .error(Code::MissingValue, span, format!("{what} {masses} {names}, which {have}"))
        .help(format!("give {them} `mass: …;` and `inertia: …;`, or {instead}"))
        .note_at(first.span, format!("`{}` is declared here", first.text));
}

/// Names of the first bodies, and the number of the others.
fn listed(model: &Model, bodies: &[usize]) -> String {
    const MOST: usize = 4;
    let mut names = bodies.iter().map(|&body| format!("`{}`", model.bodies[body].name.text)).collect_vec();
    if names.len() > MOST {
        names.truncate(MOST - 1);
        names.push(format!("{} others", bodies.len() - names.len()));
    }
    match names.split_last() {
        Some((last, before)) if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => names.concat(),
    }
}
