//! Equations of motion for people: a document in LaTeX, a page in MathML, and both for a page that shows them beside a machine.

use plm_compiler::Written;
use serde_json::{Value, json};

/// A part of a document with amsmath.
pub(crate) fn latex(Written { name, coordinates, latex, notes, .. }: &Written) -> String {
    let mut lines = vec![format!("% {name}")];
    lines.extend(coordinates.iter().map(|[path, symbol, _]| format!("% {path}: ${symbol}$")));
    lines.extend(notes.iter().map(|note| format!("% {note}")));
    lines.extend(latex.iter().map(|equation| format!("\\[ {equation} \\]")));
    lines.join("\n")
}

/// A page that a browser shows.
pub(crate) fn page(Written { name, coordinates, mathml, notes, .. }: &Written) -> String {
    let head =
        format!("<!doctype html>\n<meta charset=\"utf-8\">\n<title>{name}</title>\n<h1>{name}</h1>\n<dl>");
    let mut lines = vec![head];
    let symbol = |[path, _, symbol]: &[String; 3]| format!("<dt><math>{symbol}</math></dt><dd>{path}</dd>");
    lines.extend(coordinates.iter().map(symbol));
    lines.push("</dl>".to_owned());
    lines.extend(notes.iter().map(|note| format!("<p>{note}</p>")));
    lines.extend(mathml.iter().cloned());
    lines.join("\n")
}

/// Coordinates with their symbols and equations as MathML, notes, and the document.
pub(crate) fn json(written: &Written) -> Value {
    let coordinates = written.coordinates.iter().map(|[path, _, symbol]| json!([path, symbol]));
    json!({
        "coordinates": coordinates.collect::<Vec<_>>(),
        "mathml": written.mathml,
        "notes": written.notes,
        "latex": latex(written),
    })
}
