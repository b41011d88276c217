//! Why there is no run, or why it has ended: the fault, the place of its part in the declaration, and what to do.

use std::io::{self, Write};

use plm_compiler::diag::{Code, Diagnostics};
use plm_compiler::syntax::ast::{Item, ItemKind, Value};
use plm_compiler::syntax::parse;
use plm_compiler::token::{Source, Sources};
use plm_runtime::Fault;

use crate::checked::{Checked, checked};
use crate::quote::quote;
use crate::read::File;

/// Reports a run that has ended.
pub(super) fn ended(fault: &Fault, file: &File, to: &mut dyn Write) -> io::Result<()> {
    let text = in_unit(&rounded(fault), fault.part, file);
    writeln!(to, "plm: {text}")?;
    quote(fault.part, file).map_or(Ok(()), |quote| write!(to, "{quote}"))
}

/// The text of a fault, its time with nine digits, which are enough to find the event; the results have all digits.
fn rounded(fault: &Fault) -> String {
    let text = fault.to_string();
    let short = format!("{:.8e}", fault.time).parse().unwrap_or(fault.time);
    text.strip_prefix(&format!("t = {} s", fault.time))
        .map_or(text.clone(), |rest| format!("t = {short} s{rest}"))
}

/// Reports a start that fails, by the compiler's diagnostics of a declaration in which these values of parameters, and the defaults of all
/// others, are known lengths.
pub(super) fn at_start(fault: &Fault, file: &File, set: &[String], to: &mut dyn Write) -> io::Result<()> {
    let told = diagnosed(file, set);
    if told.is_empty() {
        return ended(fault, file, to);
    }
    for text in told {
        writeln!(to, "{text}")?;
    }
    if !set.is_empty() {
        writeln!(to, "plm: with {}", set.join(", "))?;
    }
    Ok(())
}

/// The compiler's diagnostics of the start; empty if it has no objection.
fn diagnosed(file: &File, set: &[String]) -> Vec<String> {
    let Some(text) = with_known_values(file, set) else { return Vec::new() };
    let Checked { sources, expansion } = checked(&file.name, &text, None);
    let of_start = |code: Code| matches!(code, Code::NotAssembled | Code::TooManyLocks);
    let own = expansion.diagnostics.sorted();
    own.into_iter().filter(|own| of_start(own.code)).map(|own| own.render(&sources)).collect()
}

/// The declaration with each parameter as a name of its value, `let length = 20cm;`, at its place.
fn with_known_values(file: &File, set: &[String]) -> Option<String> {
    let mut text = file.text.clone();
    let mut sources = Sources::new();
    let id = sources.add_text(&file.name, &file.text);
    let source = sources.get(id)?;
    let mechanism = parse(source, &mut Diagnostics::new()).mechanism?;
    let params = mechanism.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Param(value) => Some((item, value)),
        _ => None,
    });
    let mut changes = params
        .map(|(item, value)| Some((source.range(item.span)?, known(source, &file.text, item, value, set)?)))
        .collect::<Option<Vec<_>>>()?;
    // From the last to the first, so that places stay.
    changes.sort_by_key(|(range, _)| std::cmp::Reverse(range.start));
    for (range, own) in changes {
        let lines = file.text[range.clone()].matches('\n').count();
        text.replace_range(range, &(own + &"\n".repeat(lines)));
    }
    Some(text)
}

/// A parameter as a name of its value.
fn known(source: &Source, text: &str, item: &Item, value: &Value, set: &[String]) -> Option<String> {
    let name = value.name.ident.text.as_str();
    let range = source.range(item.span)?;
    let unit = text.get(range)?.split_once(':').map(|(_, after)| after);
    let unit = unit.and_then(|after| after.split(['=', ';', ',']).next()).map_or("", str::trim);
    let given = set.iter().rev().filter_map(|text| text.split_once('=')).find(|(own, _)| own.trim() == name);
    let default = || text.get(source.range(value.value.as_ref()?.span)?).map(str::to_owned);
    let own = match given {
        Some((_, given)) if given.trim().parse::<f64>().is_ok() && unit != "1" => {
            format!("{} {unit}", given.trim())
        }
        Some((_, given)) => given.trim().to_owned(),
        None => default()?,
    };
    Some(format!("let {name} = {own};"))
}

/// A text that leaves the unit open, in that of the rows of the part where all of them have one.
fn in_unit(text: &str, part: &str, file: &File) -> String {
    if !text.contains(" m or rad") && !text.contains(" m/s or rad/s") {
        return text.to_owned();
    }
    let lowered = checked(&file.name, &file.text, None).expansion.lower();
    let rows = lowered.iter().flat_map(|lowered| &lowered.rows);
    let kinds: Vec<bool> = rows.filter(|row| row.part == part).map(|row| row.is_angular).collect();
    let unit = match &kinds[..] {
        [] => return text.to_owned(),
        all if all.iter().all(|is_angular| *is_angular) => "rad",
        all if all.iter().all(|is_angular| !is_angular) => "m",
        _ => return text.to_owned(),
    };
    text.replace("m or rad", unit).replace("m/s or rad/s", &format!("{unit}/s"))
}
