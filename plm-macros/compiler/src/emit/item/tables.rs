//! The tables by which a mechanism describes itself: names, units, who joins whom. Numbers that the rows point at stand in
//! one row by themselves.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use proc_macro2::{Literal, TokenStream};

use super::super::{Emission, docs, number, quoted, table_compression};
use crate::facts::quantities::{Quantities, Quantity};
use crate::model::{FrameRef, Instance, Pair, Shape};
use crate::reads::{Reads, reads};
use crate::sorted::SortedMap;
use crate::tables::NumericTable;

/// A value of the type `Tables`.
pub(crate) fn tables(emission: &Emission, numbers: &NumericTable) -> TokenStream {
    let Emission { model, shown, report, .. } = emission;
    let (name, docs) = (shown.to_string(), docs::trimmed(&model.docs));
    let Quantities { parameters, inputs, states, outputs } = Quantities::of(model);
    let [parameters, inputs, states, outputs] =
        [parameters, inputs, states, outputs].map_each(|rows| emission.lines(rows.iter().map(quantity)));
    let (bodies, ground) = (bodies(emission, numbers), ground(emission, numbers));
    let parts = parts(emission, numbers);
    let reads = emission.lines(reads(model).iter().map(|row| reads_row(row.as_ref())));
    let (number, formulation, reason) =
        (Literal::u8_unsuffixed(report.taken.number), &report.taken.formulation, &report.taken.reason);
    quote! {
        described::Tables {
            name: #name,
            docs: #docs,
            report: described::Report {
                rung: #number,
                formulation: #formulation,
                reason: #reason,
                operations: OPERATIONS,
                degrees_of_freedom: NDOF,
            },
            bodies: #bodies,
            ground: &[#ground],
            parts: #parts,
            parameters: &[#parameters],
            inputs: &[#inputs],
            states: &[#states],
            outputs: &[#outputs],
            reads: &[#reads],
        }
    }
}

fn bodies(emission: &Emission, numbers: &NumericTable) -> TokenStream {
    let (bodies, mut rows) = (&emission.model.bodies, Vec::new());
    let (mut lists, mut known) = (Vec::new(), SortedMap::new());
    for (body, first) in bodies.iter().zip(&numbers.bodies) {
        let ports = quoted(body.ports.iter().map(|port| &port.name.text));
        let list = numbered(&mut lists, &mut known, format!("&[{ports}]"));
        rows.push([list, body.contour.len() as u32, *first as u32]);
    }
    if !table_compression::is_long(bodies.len()) {
        let bodies = bodies.iter().zip(rows).map(|(body, [list, points, first])| {
            let (name, ports) = (&body.name.text, &lists[list as usize]);
            format!("described::Body {{ name: {name:?}, ports: {ports}, contour: {points}, first: {first} }}")
        });
        let bodies = emission.lines(bodies);
        return quote!(&[#bodies]);
    }
    let names = bodies.iter().map(|body| body.name.text.clone()).collect_vec();
    let (count, names, lists) =
        (number(names.len()), table_compression::names(emission, &names), emission.list(lists));
    let rows = table_compression::numbers(emission, &rows.concat());
    quote!(const { &rt::compact::bodies::<#count>(#names, &[#lists], &#rows) })
}

/// The number of a text among those that differ.
fn numbered(texts: &mut Vec<String>, known: &mut SortedMap<String, u32>, text: String) -> u32 {
    let number = *known.or_insert(text.clone(), texts.len() as u32);
    if number as usize == texts.len() {
        texts.push(text);
    }
    number
}

fn ground(emission: &Emission, numbers: &NumericTable) -> TokenStream {
    let ports = emission.model.ground.iter().zip(&numbers.ground);
    emission.lines(ports.map(|(port, place)| {
        let (name, moves, first) = (&port.name.text, place.moves, place.first);
        format!("described::GroundPort {{ name: {name:?}, moves: {moves}, first: {first} }}")
    }))
}

fn parts(emission: &Emission, numbers: &NumericTable) -> TokenStream {
    let instances = &emission.model.instances;
    if !table_compression::is_long(instances.len()) {
        let parts = instances.iter().zip(&numbers.parts).map(|(instance, first)| {
            let frames = instance.frames.iter().map(|(argument, frame)| {
                let (body, port) = (frame.body, frame.port);
                format!("described::Frame {{ argument: {argument:?}, body: {body:?}, port: {port} }}")
            });
            part(instance, &instance.name, &frames.collect_vec().join(", "), *first)
        });
        let parts = emission.lines(parts);
        return quote!(&[#parts]);
    }
    let (mut kinds, mut known_kinds) = (Vec::new(), SortedMap::new());
    let (mut arguments, mut known_arguments) = (Vec::new(), SortedMap::new());
    let (mut rows, mut frames, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for (instance, first) in instances.iter().zip(&numbers.parts) {
        let kind = numbered(&mut kinds, &mut known_kinds, part(instance, "", "", 0));
        rows.extend_from_slice(&[kind, instance.frames.len() as u32, *first as u32]);
        names.push(instance.name.clone());
        for (argument, frame) in &instance.frames {
            let argument = numbered(&mut arguments, &mut known_arguments, format!("{argument:?}"));
            let body = frame.body.map_or(u32::MAX, |body| body as u32);
            frames.extend_from_slice(&[argument, body, frame.port as u32]);
        }
    }
    let [count, of_frames] = [names.len(), frames.len() / 3].map_each(number);
    let [rows, frames] = [rows, frames].map_each(|numbers| table_compression::numbers(emission, &numbers));
    let (names, kinds) = (table_compression::names(emission, &names), emission.list(kinds));
    let arguments = emission.list(arguments);
    quote! {
        const {
            &rt::compact::parts::<#count>(
                #names,
                &[#kinds],
                &#rows,
                const { &rt::compact::frames::<#of_frames>(&[#arguments], &#frames) },
            )
        }
    }
}

/// The shapes of parts, where there are some.
pub(crate) fn shapes(emission: &Emission, numbers: &NumericTable) -> Option<TokenStream> {
    let parts = emission.model.instances.iter().enumerate();
    let shapes = parts.flat_map(|(part, instance)| instance.shapes.iter().map(move |shape| (part, shape)));
    let rows = shapes.zip(&numbers.shapes).map(|((part, shape), first)| {
        let Shape { look, at, towards, is_symbol, points } = shape;
        let place = |of: &FrameRef| format!("({:?}, {})", of.body, of.port);
        let towards = towards.as_ref().map_or("None".to_owned(), |of| format!("Some({})", place(of)));
        format!(
            "described::Shape {{ part: {part}, look: {:?}, at: {}, towards: {towards}, is_symbol: {is_symbol}, \
             points: {}, first: {first} }}",
            look.name(),
            place(at),
            points.len()
        )
    });
    let rows = emission.lines(rows);
    (!numbers.shapes.is_empty()).then(|| quote!(const SHAPES: &'static [described::Shape] = &[#rows];))
}

/// The holes of bodies, where there are some.
pub(crate) fn holes(emission: &Emission, numbers: &NumericTable) -> Option<TokenStream> {
    let bodies = emission.model.bodies.iter().enumerate();
    let holes = bodies.flat_map(|(k, body)| body.holes.iter().map(move |hole| (k, hole.len())));
    let rows = holes.zip(&numbers.holes).map(|((body, points), first)| {
        format!("described::Hole {{ body: {body}, points: {points}, first: {first} }}")
    });
    let rows = emission.lines(rows);
    (!numbers.holes.is_empty()).then(|| quote!(const HOLES: &'static [described::Hole] = &[#rows];))
}

fn part(instance: &Instance, name: &str, frames: &str, first: usize) -> String {
    let Instance { kind, pair, sizes, .. } = instance;
    let (pair, sizes) = (pair.map(Pair::name), quoted(sizes.iter().map(|size| &size.name)));
    format!(
        "described::Part {{ name: {name:?}, kind: {kind:?}, pair: {pair:?}, frames: &[{frames}], sizes: &[{sizes}], \
         first: {first} }}"
    )
}

fn reads_row(reads: Option<&Reads>) -> String {
    let Some(Reads { motion, time, states, inputs }) = reads else { return "None".to_owned() };
    format!(
        "Some(described::Reads {{ motion: described::Motion::{motion:?}, time: {time}, states: &{states:?}, \
         inputs: &{inputs:?} }})"
    )
}

fn quantity(quantity: &Quantity) -> String {
    let Quantity { name, docs, unit, factor, exponents, default } = quantity;
    let default = default.map_or("None".to_owned(), |default| format!("Some({})", literal(default)));
    format!(
        "described::Quantity {{ name: {name:?}, docs: {docs:?}, unit: {unit:?}, factor: {factor:?}, \
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
