//! The tables by which a mechanism describes itself: names, units, who joins whom. Numbers that the rows point at stand in
//! one row by themselves.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use plm_cas::Expr;
use proc_macro2::{Literal, TokenStream};

use super::super::{Emission, docs, quoted};
use crate::model::{Instance, Name, Pair};
use crate::numeric::value;
use crate::reads::{Reads, reads};
use crate::tables::{Figures, declared_values, exponents};
use crate::units::DisplayUnit;

/// A value of the type `Tables`.
pub(crate) fn tables(emission: &Emission, figures: &Figures) -> TokenStream {
    let Emission { model, shown, report, .. } = emission;
    let (name, docs) = (shown.to_string(), docs::trimmed(&model.docs));
    let known = declared_values(model);
    let declared = |expr: Expr| Some(value(expr, &known)).filter(|value| !value.is_nan());
    let parameters = model.params.iter().map(|param| {
        let default = known.iter().find(|(symbol, _)| *symbol == param.symbol);
        quantity(&param.name, &param.docs, &param.unit, default.map(|(_, value)| *value))
    });
    let inputs = model
        .inputs
        .iter()
        .map(|input| quantity(&input.name, &input.docs, &input.unit, declared(input.default)));
    let states =
        model.states.iter().map(|state| quantity(&state.name, &[], &state.unit, declared(state.start)));
    let [parameters, inputs, states] = [parameters.collect_vec(), inputs.collect_vec(), states.collect_vec()]
        .map(|rows| emission.lines(rows));
    let (bodies, ground) = (bodies(emission, figures), ground(emission, figures));
    let parts = model.instances.iter().zip(&figures.parts).map(|(instance, first)| part(instance, *first));
    let (parts, outputs) = (emission.lines(parts), emission.lines(outputs(emission)));
    let reads = emission.lines(reads(model).iter().map(|row| reads_row(row.as_ref())));
    let (rung, formulation, reason) =
        (Literal::u8_unsuffixed(report.taken.rung), &report.taken.formulation, &report.taken.reason);
    quote! {
        described::Tables {
            name: #name,
            docs: #docs,
            report: described::Report {
                rung: #rung,
                formulation: #formulation,
                reason: #reason,
                operations: OPERATIONS,
                degrees_of_freedom: NDOF,
            },
            bodies: &[#bodies],
            ground: &[#ground],
            parts: &[#parts],
            parameters: &[#parameters],
            inputs: &[#inputs],
            states: &[#states],
            outputs: &[#outputs],
            reads: &[#reads],
        }
    }
}

fn bodies(emission: &Emission, figures: &Figures) -> TokenStream {
    let bodies = emission.model.bodies.iter().zip(&figures.bodies);
    emission.lines(bodies.map(|(body, first)| {
        let ports = quoted(body.ports.iter().map(|port| &port.name.text));
        let (name, points) = (&body.name.text, body.contour.len());
        format!("described::Body {{ name: {name:?}, ports: &[{ports}], contour: {points}, first: {first} }}")
    }))
}

fn ground(emission: &Emission, figures: &Figures) -> TokenStream {
    let ports = emission.model.ground.iter().zip(&figures.ground);
    emission.lines(ports.map(|(port, place)| {
        let (name, moves, first) = (&port.name.text, place.moves, place.first);
        format!("described::GroundPort {{ name: {name:?}, moves: {moves}, first: {first} }}")
    }))
}

fn part(instance: &Instance, first: usize) -> String {
    let Instance { name, kind, pair, frames, sizes } = instance;
    let frames = frames.iter().map(|(argument, frame)| {
        let (body, port) = (frame.body, frame.port);
        format!("described::Frame {{ argument: {argument:?}, body: {body:?}, port: {port} }}")
    });
    let frames = frames.collect_vec().join(", ");
    let (pair, sizes) = (pair.map(Pair::name), quoted(sizes.iter().map(|size| &size.name)));
    format!(
        "described::Part {{ name: {name:?}, kind: {kind:?}, pair: {pair:?}, frames: &[{frames}], sizes: &[{sizes}], \
         first: {first} }}"
    )
}

/// The declared outputs, a vector as two.
fn outputs(emission: &Emission) -> Vec<String> {
    let declared = emission.model.outputs.iter().filter(|output| output.declared);
    let rows = declared.flat_map(|output| {
        let axes: &[&str] = if output.components.len() == 1 { &[""] } else { &[".x", ".y"] };
        axes.iter().map(|axis| {
            let name = Name { text: format!("{}{axis}", output.name.text), span: output.name.span };
            quantity(&name, std::slice::from_ref(&output.docs), &output.unit, None)
        })
    });
    rows.collect_vec()
}

fn reads_row(reads: Option<&Reads>) -> String {
    let Some(Reads { motion, time, states, inputs }) = reads else { return "None".to_owned() };
    format!(
        "Some(described::Reads {{ motion: described::Motion::{motion:?}, time: {time}, states: &{states:?}, \
         inputs: &{inputs:?} }})"
    )
}

fn quantity(name: &Name, docs: &[String], unit: &DisplayUnit, default: Option<f64>) -> String {
    let (name, docs, text, factor) = (&name.text, docs::trimmed(docs), &unit.text, unit.factor.to_f64());
    let (exponents, default) = (exponents(unit), default.map(literal));
    let default = default.map_or("None".to_owned(), |default| format!("Some({default})"));
    format!(
        "described::Quantity {{ name: {name:?}, docs: {docs:?}, unit: {text:?}, factor: {factor:?}, \
         exponents: {exponents:?}, default: {default} }}"
    )
}

/// A number of f64.
pub(crate) fn literal(value: f64) -> String {
    match (value.is_nan(), value.is_finite()) {
        (true, _) => "f64::NAN".to_owned(),
        (_, true) => format!("{value:?}"),
        _ => format!("{}f64::INFINITY", if value < 0.0 { "-" } else { "" }),
    }
}
