//! The parts library as a table: what the builder knows of parts.

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::{Definition, Item, ItemKind, all_items};
use plm_compiler::syntax::parse_parts;
use plm_compiler::token::Sources;
use plm_compiler::words;
use pyo3::prelude::*;

/// Name, kind and documentation of a member that a use can set; of numbers the SI unit, empty of a pure one.
type Setting = (String, &'static str, String, String);
/// Name, documentation, arguments with their kinds, members that a use can set.
type Part = (String, String, Vec<(String, String)>, Vec<Setting>);

/// All parts of the library.
#[pyfunction]
pub(crate) fn parts() -> Vec<Part> {
    words::parts().iter().filter_map(|(name, text)| part(name, text)).collect()
}

fn part(name: &str, text: &str) -> Option<Part> {
    let mut sources = Sources::new();
    let id = sources.add_text(name, text);
    let shared = parse_parts(sources.get(id)?, &mut Diagnostics::new());
    let Definition { docs, arguments, items, .. } =
        shared.parts.iter().find(|part| part.name.text == name)?;
    let arguments = arguments.iter().map(|of| (of.name.text.clone(), of.kind.text.clone()));
    let settings = all_items(items).filter_map(setting);
    Some((name.to_owned(), docs.join("\n"), arguments.collect(), settings.collect()))
}

fn setting(item: &Item) -> Option<Setting> {
    let of = |name: &str, kind, unit| Some((name.to_owned(), kind, item.docs.join("\n"), unit));
    match &item.kind {
        ItemKind::Param(value)
        | ItemKind::Input(value)
        | ItemKind::State(value)
        | ItemKind::Discrete(value) => {
            let unit = value.unit.as_ref().map(|unit| unit.dimension.si_unit());
            of(&value.name.ident.text, "number", unit.filter(|unit| unit != "1").unwrap_or_default())
        }
        ItemKind::Choice(choice) => of(&choice.name.text, "choice", String::new()),
        ItemKind::Function(function) => of(&function.name.text, "function", String::new()),
        ItemKind::Points(points) => of(&points.name.text, "points", points.unit.dimension.si_unit()),
        _ => None,
    }
}
