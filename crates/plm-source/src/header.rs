//! The header: what can be called, and the names of all numbers with their units.

use std::fmt::Write as _;

use plm_foreign::{Names, Si};

use crate::Precision;
use crate::plan::Plan;
use crate::template::fill;

const HEADER: &str = include_str!("c/header.h.txt");

/// A number by name: its kind, its name, its unit, and what is said of it.
struct Row {
    name: String,
    unit: String,
    docs: String,
}

/// The header.
pub(crate) fn header(plan: &Plan) -> String {
    let tables = plan.tables;
    let mut docs = tables.name.to_owned();
    for line in tables.docs.lines() {
        let _ = write!(docs, "\n   {}", comment(line));
    }
    let mut common = String::new();
    // Writing to a text cannot fail.
    let _ = plm_foreign::header::common(&mut common);
    let words = [
        ("docs", docs),
        ("common", common),
        ("fields", fields(plan)),
        ("method", method(plan).to_owned()),
        ("rate", if plan.has_own_rate() { RATE } else { "" }.to_owned()),
        ("energy", energy(plan)),
        ("outputs", outputs(plan)),
        ("kinds", kinds(plan)),
        ("states", plan.length("x").to_string()),
        ("bits", if plan.precision == Precision::Single { "32" } else { "64" }.to_owned()),
        ("real", if plan.precision == Precision::Single { "float" } else { "double" }.to_owned()),
        ("up", plan.upper.clone()),
        ("p", plan.name.clone()),
    ];
    fill(HEADER, &words)
}

/// The rate.
const RATE: &str = "\n/* The rate of the state at a time and a state of one's own, for other methods. */\n\
    int @p@_rate(const @p@ *self, @real@ time, const @real@ x[@up@_STATES], @real@ rates[@up@_STATES]);\n";

/// The method of its steps.
fn method(plan: &Plan) -> &'static str {
    if plan.lowered.contacts.is_some() {
        "the time stepping of Moreau and Jean, over impacts and friction"
    } else {
        "the classical method of Runge and Kutta"
    }
}

/// Text that does not end the comment that it stands in.
fn comment(text: &str) -> String {
    text.replace("*/", "* /")
}

/// The fields of the object; arrays have at least one element.
fn fields(plan: &Plan) -> String {
    let counts = &plan.counts;
    let arrays = [
        ("@real@", "parameter", plan.start.parameters.len(), "by PLM_PARAMETER"),
        ("@real@", "input", plan.start.inputs.len(), "by PLM_INPUT"),
        ("@real@", "side", plan.start.sides.len(), "of each condition: -1 where it holds, else 1"),
        ("@real@", "memory", counts.memory, "of the loops, from the last checked state"),
        ("int32_t", "turns", counts.turns, "whole revolutions of angles"),
        ("int", "mode", counts.places, "of each row of contact (PLM_CONTACT)"),
        ("int", "carried", counts.places, "is the row at rest by others?"),
        ("int", "negative", counts.places, "is a reaction that bounds frictions negative?"),
        ("@real@", "place", counts.places, "at which a friction sticks, m or rad"),
    ];
    let mut text = String::new();
    for (kind, name, count, docs) in arrays.into_iter().filter(|(_, _, count, _)| *count > 0) {
        let _ = writeln!(text, "    {kind} {name}[{count}]; /* {docs} */");
    }
    if plan.is_loops() {
        text.push_str("    int chart; /* the coordinates that are in use, from 0 */\n");
    }
    if counts.places > 0 {
        text.push_str("    @real@ residual; /* the rate by which the last step violates a law of contact, m/s or rad/s */\n");
    }
    text
}

fn energy(plan: &Plan) -> String {
    if plan.lowered.has_energy {
        "\n/* Kinetic energy and the potential energy of gravity, J. */\nvoid @p@_energy(const @p@ *self, @real@ *kinetic, @real@ *gravity);\n"
            .to_owned()
    } else {
        String::new()
    }
}

fn outputs(plan: &Plan) -> String {
    let count = plan.outputs().count();
    if count == 0 {
        return String::new();
    }
    let words = "\n/* The declared outputs, in their order (PLM_OUTPUT). */\nint @p@_outputs(const @p@ *self, @real@ out[COUNT]);\n";
    words.replace("COUNT", &count.to_string())
}

/// The names of all numbers.
fn kinds(plan: &Plan) -> String {
    let tables = plan.tables;
    let of_quantities = |rows: &[plm_runtime::described::Quantity]| -> Vec<Row> {
        rows.iter()
            .map(|row| Row {
                name: row.name.to_owned(),
                unit: Si(row).to_string(),
                docs: row.docs.replace('\n', " "),
            })
            .collect()
    };
    let mut parameters = of_quantities(tables.parameters);
    for (row, _) in parameters.iter_mut().zip(&plan.is_fixed).filter(|(_, fixed)| **fixed) {
        row.docs = format!(
            "{}{}fixed: the start depends on it",
            row.docs,
            if row.docs.is_empty() { "" } else { "; " }
        );
    }
    let outputs = plan.outputs().map(|(_, output)| Row {
        name: output.name.clone(),
        unit: output.si.clone(),
        docs: String::new(),
    });
    let bodies = plan.lowered.bodies.iter();
    let rows = plan.lowered.contacts.iter().flat_map(|contacts| &contacts.rows).map(|row| &row.name);
    let plain = |name: &String| Row { name: name.clone(), unit: String::new(), docs: String::new() };
    let mut text = String::new();
    for (kind, rows) in [
        ("PARAMETER", parameters),
        ("INPUT", of_quantities(tables.inputs)),
        ("STATE", of_quantities(tables.states)),
        ("OUTPUT", outputs.collect()),
        ("BODY", bodies.map(plain).collect()),
        ("CONTACT", rows.map(plain).collect()),
    ] {
        text.push_str(&list(kind, &rows));
    }
    text
}

/// The names of a kind as an enumeration.
fn list(kind: &str, rows: &[Row]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let mut text = format!("\nenum @p@_{} {{\n", kind.to_lowercase());
    let upper = |row: &Row| Names::upper(&row.name).to_string();
    for (k, row) in rows.iter().enumerate() {
        let own = upper(row);
        // Names that differ in other than letters and digits get their number.
        let is_alone = rows.iter().filter(|other| upper(other) == own).count() == 1;
        let number = if is_alone { String::new() } else { format!("_{k}") };
        let comma = if k + 1 < rows.len() { "," } else { "" };
        let unit = if row.unit.is_empty() { String::new() } else { format!(", {}", row.unit) };
        let docs = if row.docs.is_empty() { String::new() } else { format!(": {}", comment(&row.docs)) };
        let _ = writeln!(
            text,
            "    @up@_{kind}_{own}{number} = {k}{comma} /* {}{unit}{docs} */",
            comment(&row.name)
        );
    }
    text.push_str("};\n");
    text
}
