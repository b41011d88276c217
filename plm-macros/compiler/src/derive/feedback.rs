//! Forces that read accelerations and reactions, the unknowns of the equations of motion.
//!
//! Each unknown that is read is a signal. Where the forces are affine in the signals, `Q = Q_0 + sum_j G_j s_j`, the
//! signals enter the linear system that gives the unknowns, and the solution is exact.

use plm_cas::{Expr, algebra};

use super::SparseRow;
use crate::diag::{Code, Diagnostics};
use crate::model::{Model, Name};

/// An unknown that forces read.
#[derive(Clone, Debug)]
pub(crate) struct Signal {
    /// Its symbol.
    pub(crate) symbol: Expr,
    /// What one of it adds to `Q`: (coordinate, gain).
    pub(crate) gain: SparseRow,
}

/// Takes the signals out of the applied forces: `G_j = dQ/ds_j`, and `force` becomes `Q_0`, which is `Q` at `s = 0`.
pub(super) fn signals(model: &Model, force: &mut [Expr]) -> Vec<Signal> {
    let unknowns = unknowns(model);
    let held = algebra::symbols(force);
    let symbols = held.into_iter().filter(|symbol| unknowns.iter().any(|(of, _)| of == symbol));
    let symbols: Vec<Expr> = symbols.collect();
    let gain = |symbol: Expr| -> SparseRow {
        let entries: Vec<Expr> = force.iter().map(|of| of.diff(symbol)).collect();
        entries.into_iter().enumerate().filter(|(_, entry)| !entry.is_zero()).collect()
    };
    let signals = symbols.iter().map(|&symbol| Signal { symbol, gain: gain(symbol) }).collect();
    let without: Vec<(Expr, Expr)> = symbols.into_iter().map(|symbol| (symbol, Expr::ZERO)).collect();
    if !without.is_empty() {
        force.copy_from_slice(&algebra::substitute(force, &without));
    }
    signals
}

/// Does a force or a rate read an acceleration or a reaction?
pub(crate) fn feeds_back(model: &Model) -> bool {
    let roots: Vec<Expr> = causes(model).into_iter().map(|cause| cause.value).collect();
    let held = algebra::symbols(&roots);
    unknowns(model).iter().any(|(symbol, _)| held.contains(symbol))
}

/// Reports forces that are not affine in what they read of the unknowns, and conditions that read them.
pub(crate) fn check(model: &Model, sink: &mut Diagnostics) {
    let unknowns = unknowns(model);
    // Whose force, and what it reads.
    let mut cycles: Vec<(Name, Vec<&str>)> = Vec::new();
    for cause in causes(model).into_iter().filter(|cause| cause.is_force) {
        let held = algebra::symbols(&[cause.value]);
        for (symbol, name) in unknowns.iter().filter(|(symbol, _)| held.contains(symbol)) {
            let gain = cause.value.diff(*symbol);
            let left = algebra::symbols(&[gain]);
            if !unknowns.iter().any(|(of, _)| left.contains(of)) {
                continue;
            }
            match cycles.iter_mut().find(|(of, _)| *of == cause.name) {
                Some((_, read)) if read.contains(&name.as_str()) => {}
                Some((_, read)) => read.push(name),
                None => cycles.push((cause.name.clone(), vec![name])),
            }
        }
    }
    for (part, read) in cycles {
        let message = format!(
            "the force of `{}` depends on {}, which it acts on, and not in proportion",
            part.text,
            read.join(" and ")
        );
        sink.error(Code::Feedback, part.span, message)
            .help("feed it back in proportion, or through a `state` that follows it with a lag");
    }
    for side in &model.sides {
        let held = algebra::symbols(&[side.difference]);
        if let Some((_, name)) = unknowns.iter().find(|(symbol, _)| held.contains(symbol)) {
            let message = format!("`{}` jumps on a condition that reads {name}", side.name);
            sink.error(Code::Feedback, model.name.span, message)
                .help("let the condition read a `state` that follows it with a lag");
        }
    }
}

/// A force or a rate, and whose it is.
struct Cause {
    name: Name,
    is_force: bool,
    value: Expr,
}

fn causes(model: &Model) -> Vec<Cause> {
    let loads = model.loads.iter().flat_map(|load| {
        let part = &model.parts[load.part].name;
        load.force.map(|value| Cause { name: part.clone(), is_force: true, value })
    });
    let rates = model.states.iter();
    let rates = rates.map(|state| Cause { name: state.name.clone(), is_force: false, value: state.rate });
    loads.chain(rates).collect()
}

/// Symbols of the unknowns of the equations of motion, and how to speak of them.
fn unknowns(model: &Model) -> Vec<(Expr, String)> {
    let accelerations = model.bodies.iter().flat_map(|body| {
        let names = ["ax", "ay", "alpha"].map(|of| format!("`{}.{of}`", body.name.text));
        body.a.into_iter().zip(names)
    });
    let reactions = model.rows.iter().map(|row| (row.lambda, format!("the reaction of `{}`", row.name)));
    accelerations.chain(reactions).collect()
}
