//! Inputs on straight lines between readings: the declaration with names for them.

use std::ops::Range;

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::{Item, ItemKind, Value, all_items};
use plm_compiler::syntax::parse;
use plm_compiler::token::{Source, Sources};
use plm_dynamic::{Change, Course, Error, Mechanism};

use super::readings::Signal;
use super::{Driven, Failure, number, times};
use crate::read::File;

/// Names that the declaration gets beside its own.
const CLOCK: &str = "signal_clock_";
const TIME: &str = "signal_time_";
const RATE: &str = "signal_rate_";
/// Suffixes of the two inputs of one that is on straight lines.
const BEFORE: &str = "_before_";
const AFTER: &str = "_after_";

/// A mechanism whose inputs of these names are on straight lines.
pub(super) struct Lines {
    mechanism: Mechanism,
    /// Names of inputs without indices, which are on straight lines.
    names: Vec<String>,
}

/// Inputs over an interval of a run: values at its begin and at its end, SI.
type Piece = Vec<[f64; 2]>;

impl Lines {
    /// Compiles the declaration with names in the places of inputs.
    ///
    /// # Errors
    /// A declaration in which an input is what can be no function of the time.
    pub(super) fn new(file: &File, signals: &[Signal]) -> Result<Lines, Failure> {
        let mut names: Vec<String> = signals.iter().map(|own| family(&own.input).to_owned()).collect();
        names.sort();
        names.dedup();
        let text = with_lines(file, &names).ok_or("the inputs stand nowhere in the declaration")?;
        match Mechanism::from_named_text(&file.name, &text) {
            Ok(mechanism) => Ok(Lines { mechanism, names }),
            Err(Error::Refused(refused)) => Err(format!(
                "`{}` cannot move on straight lines between readings; `--hold` has each reading hold to the next:\n{refused}",
                names.join("`, `")
            )
            .into()),
            Err(error) => Err(error.into()),
        }
    }

    /// The run of these inputs.
    pub(super) fn driven(
        self,
        signals: &[Signal],
        given: Vec<(String, f64)>,
        until: f64,
    ) -> Result<Driven, Failure> {
        let mut begin = Vec::new();
        for (name, value) in given {
            if self.names.iter().any(|own| own == family(&name)) {
                begin.extend(both(&name).map(|name| (name, value)));
            } else {
                begin.push((name, value));
            }
        }
        let inputs: Vec<[String; 2]> = signals.iter().map(|own| both(&own.input)).collect();
        let clock = [TIME, RATE].map(str::to_owned);
        let all: Vec<String> = clock.into_iter().chain(inputs.into_iter().flatten()).collect();
        let numbers: Option<Vec<usize>> = all.iter().map(|name| number(&self.mechanism, name)).collect();
        let numbers = numbers.ok_or("the inputs stand nowhere in the declaration")?;
        let mut changes = Vec::new();
        for (k, (time, length, piece)) in pieces(signals, until).into_iter().enumerate() {
            let values = [time, 1.0 / length].into_iter().chain(piece.into_iter().flatten());
            for ((name, input), value) in all.iter().zip(&numbers).zip(values) {
                if k == 0 {
                    begin.push((name.clone(), value));
                } else {
                    changes.push(Change { time, input: *input, value });
                }
            }
        }
        Ok(Driven { mechanism: self.mechanism, course: Course::new(changes), begin })
    }
}

/// Begin and length, s, of the intervals between readings, with the inputs over each. Intervals over which nothing changes are one.
fn pieces(signals: &[Signal], until: f64) -> Vec<(f64, f64, Piece)> {
    let mut begins = vec![0.0];
    begins.extend(times(signals));
    let mut pieces: Vec<(f64, f64, Piece)> = Vec::new();
    for (k, begin) in begins.iter().enumerate().take_while(|(_, begin)| **begin < until) {
        // After the last reading there is no end that counts.
        let end = begins.get(k + 1).copied().unwrap_or(begin + 1.0);
        let piece: Piece = signals.iter().map(|own| [own.from(*begin), own.up_to(end)]).collect();
        let rests = |piece: &Piece| piece.iter().all(|[a, b]| a.to_bits() == b.to_bits());
        match pieces.last_mut() {
            Some((_, _, last)) if rests(last) && *last == piece => {}
            _ => pieces.push((*begin, end - begin, piece)),
        }
    }
    pieces
}

/// The name without its indices.
fn family(name: &str) -> &str {
    name.split('[').next().unwrap_or(name)
}

/// The two inputs of one that is on straight lines.
fn both(name: &str) -> [String; 2] {
    let (own, indices) = name.split_at(family(name).len());
    [BEFORE, AFTER].map(|tail| format!("{own}{tail}{indices}"))
}

/// The text with names in the places of these inputs; nothing of one in which one of them does not stand.
fn with_lines(file: &File, names: &[String]) -> Option<String> {
    let mut sources = Sources::new();
    let id = sources.add_text(&file.name, &file.text);
    let source = sources.get(id)?;
    let mechanism = parse(source, &mut Diagnostics::new()).mechanism?;
    let mut changes = Vec::new();
    for item in all_items(&mechanism.items) {
        match &item.kind {
            ItemKind::Input(value) if names.contains(&value.name.ident.text) => {
                changes.push(line(source, &file.text, item, value)?);
            }
            _ => {}
        }
    }
    if changes.len() < names.len() {
        return None;
    }
    let first = source.range(mechanism.items.first()?.span)?.start;
    let clock =
        format!("input {TIME}: s = 0; input {RATE}: 1/s = 0; state {CLOCK}: s = 0; rate {CLOCK} = 1; ");
    changes.push((first..first, clock));
    // From the last to the first, so that places stay; what is put in front of the first item is put there last.
    changes.sort_by_key(|(range, _): &(Range<usize>, String)| std::cmp::Reverse((range.start, range.end)));
    let mut text = file.text.clone();
    for (range, own) in changes {
        text.replace_range(range, &own);
    }
    Some(text)
}

/// An input as a name for what is between two inputs, in as many lines.
fn line(source: &Source, text: &str, item: &Item, value: &Value) -> Option<(Range<usize>, String)> {
    let range = source.range(item.span)?;
    let name = source.range(value.name.ident.span)?;
    let behind = text.get(name.end..range.end)?;
    // Comments and line breaks of the second copy are left out.
    let plain: Vec<&str> = behind.lines().map(|line| line.split("//").next().unwrap_or(line)).collect();
    let end = behind.find([':', '=', ';', ','])?;
    let (plain, indices) = (plain.join(" "), behind.get(..end)?.trim());
    let own = &value.name.ident.text;
    let phase = format!("({CLOCK} - {TIME})*{RATE}");
    let [before, after] = [BEFORE, AFTER].map(|tail| format!("{own}{tail}"));
    let head = text.get(range.start..name.start)?;
    Some((
        range.clone(),
        format!(
            "{head}{before}{behind} input {after}{plain} \
             let {}{indices} = {before}{indices} + ({after}{indices} - {before}{indices})*{phase};",
            text.get(name)?
        ),
    ))
}
