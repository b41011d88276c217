//! `plm expand` and `plm report`: the code that the macro emits, and what the compiler found and chose.

use plm_compiler::AssembledBody;
use serde_json::json;

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::checked::{Checked, Declarations};
use crate::{equations, read};

pub(super) const EXPAND: Command = Command {
    name: "expand",
    usage: "FILE",
    title: "shows the Rust code that the macro emits",
    options: &[],
    run: |words, streams| {
        run(words, streams, |checked| checked.expansion.code.as_ref().map(plm_compiler::Code::text))
    },
};

pub(super) const REPORT: Command = Command {
    name: "report",
    usage: "FILE",
    title: "tells bodies, rows, formulation, operations and assembly",
    options: &[
        ("--json", "an object of JSON a line, with freedoms, redundant parts and the assembled poses"),
        ("--equations", "the equations of motion as in a textbook, as LaTeX"),
        ("--mathml", "the equations of motion as MathML, in a page"),
    ],
    run: |mut words, streams| {
        let wanted = ["--json", "--equations", "--mathml"].map(|option| words.takes(option));
        let of = match wanted {
            [false, false, false] => text,
            [true, false, false] => json,
            [false, true, false] => latex,
            [false, false, true] => mathml,
            _ => return Err("a report is one of --json, --equations and --mathml".into()),
        };
        run(words, streams, of)
    },
};

/// The equations of motion as LaTeX, for a document with amsmath.
fn latex(checked: &Checked) -> Option<String> {
    Some(equations::latex(&checked.expansion.oracle.as_ref()?.written()))
}

/// The equations of motion as MathML, in a page that a browser shows.
fn mathml(checked: &Checked) -> Option<String> {
    Some(equations::page(&checked.expansion.oracle.as_ref()?.written()))
}

fn text(checked: &Checked) -> Option<String> {
    checked.expansion.report.as_ref().map(ToString::to_string)
}

/// The report in numbers, and the start as it is assembled.
fn json(checked: &Checked) -> Option<String> {
    let report = checked.expansion.report.as_ref()?;
    let start = checked.expansion.oracle.as_ref()?.assembled();
    let body = |body: &AssembledBody| {
        let ([x, y, angle], [vx, vy, omega]) = (body.pose, body.velocity);
        json!({
            "name": body.name, "x_m": x, "y_m": y, "angle_rad": angle,
            "vx_m_per_s": vx, "vy_m_per_s": vy, "omega_rad_per_s": omega,
        })
    };
    let all = json!({
        "name": report.name,
        "bodies": start.bodies.iter().map(body).collect::<Vec<_>>(),
        "parts": report.parts,
        "constraint_rows": report.constraints,
        "freedoms_by_count": report.freedom,
        "freedoms": start.freedom,
        "redundant_parts": start.redundant,
        "first_order_states": report.states,
        "formulation": {
            "number": report.taken.number, "unknowns": report.taken.formulation, "reason": report.taken.reason,
        },
        "operations_of_a_rate": report.rate.total(),
        "assembly": report.assembly,
    });
    Some(all.to_string())
}

/// Writes something of every declaration of a file without errors; diagnostics go to the messages.
fn run(words: Words, streams: &mut Streams, of: fn(&Checked) -> Option<String>) -> Result<Outcome, Failure> {
    let file = read::file(&words.file()?, streams.input)?;
    let found = Declarations::new(&file.name, &file.text);
    if found.is_empty() {
        return Err(format!("{}: there is no `mechanism!` in it", file.name).into());
    }
    let mut outcome = Outcome::Good;
    for declaration in found.compiled() {
        let declaration = declaration?;
        let diagnostics = &declaration.expansion.diagnostics;
        for diagnostic in diagnostics.sorted() {
            writeln!(streams.errors, "{}", diagnostic.render(&declaration.sources))?;
        }
        match of(&declaration).filter(|_| !diagnostics.has_errors()) {
            Some(text) => writeln!(streams.output, "{text}")?,
            None => outcome = Outcome::Wrong,
        }
    }
    for what in &found.left_out {
        writeln!(streams.errors, "plm: {what}")?;
    }
    Ok(outcome)
}
