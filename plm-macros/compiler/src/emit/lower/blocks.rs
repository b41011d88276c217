//! Statements as text, cut in blocks that rustc can digest.
//!
//! rustc recurses over the statements of a block and overflows its stack on some thousands with debug information. So a
//! long function is a row of blocks, and what later blocks need leaves each as a tuple; optimised code is the same.

use crate::collect::CollectVec;
use crate::sorted::{SortedMap, SortedSet};
use std::fmt::Write;

use super::Around;
use super::statement::{Lines, Statement};

/// Statements that can be seen at once.
const SCREEN: usize = 40;
/// Statements in one block.
const BLOCK: usize = 160;

/// The body of a function without its braces, indented by `indent` spaces; ends with the returned value if there is one.
pub(super) fn body(lines: &Lines, indent: usize) -> String {
    let count = lines.statements.len();
    let mut text = String::new();
    if count <= BLOCK + BLOCK / 2 {
        write_statements(&mut text, lines, &lines.statements, indent);
    } else {
        let mut start = 0;
        let live_after = live_after(lines);
        while start < count {
            let end = (start + BLOCK).min(count);
            write_block(&mut text, lines, start..end, &live_after[end], indent);
            start = end;
        }
    }
    if let Some((value, _)) = &lines.value {
        line(&mut text, indent, value);
    }
    text
}

/// [`body`] with `lit` and `by` in front if it holds constants. What is read of arrays stands at the top of what can be seen at once;
/// in longer code where it is used first, which is near, and takes fewer registers.
pub(super) fn with_literals(mut lines: Lines, around: &Around) -> String {
    let mut text = String::new();
    if lines.statements.len() <= SCREEN {
        let mut read: SortedMap<String, SortedMap<usize, usize>> = SortedMap::new();
        lines.statements.retain(|statement| match statement {
            Statement::Read { local, array, element } => {
                read.or_insert(array.clone(), SortedMap::new()).insert(*element, *local);
                false
            }
            _ => true,
        });
        for (array, elements) in &read {
            destructure(&mut text, &lines, (array, elements), around.by_reference);
        }
    }
    let mut arrays = String::new();
    for (name, length) in &lines.arrays {
        line(&mut arrays, 0, &format!("let mut {name} = [lit(0.0); {length}];"));
    }
    let body = arrays + &body(&lines, 0);
    if calls(&body, "lit") {
        line(&mut text, 0, &format!("let lit = {}::lit;", around.scalar));
    }
    if calls(&body, "by") {
        line(&mut text, 0, "let by = rt::Factor;");
    }
    text + &body
}

/// Does a text call the function of this name?
fn calls(text: &str, name: &str) -> bool {
    let is_whole =
        |at: usize| !text[..at].ends_with(|last: char| last.is_alphanumeric() || "_.:".contains(last));
    text.match_indices(&format!("{name}(")).any(|(at, _)| is_whole(at))
}

/// `let [arm_x, _, arm_angle, ..] = *q;`, or a line for each where few of many are read.
fn destructure(
    text: &mut String,
    lines: &Lines,
    (array, read): (&str, &SortedMap<usize, usize>),
    by_reference: bool,
) {
    let name = |local: &usize| lines.locals[*local].as_str();
    let end = read.keys().last().map_or(0, |last| last + 1);
    if end > 2 * read.len() + 2 {
        for (element, local) in read {
            line(text, 0, &format!("let {} = {array}[{element}];", name(local)));
        }
        return;
    }
    let names: Vec<&str> = (0..end).map(|element| read.get(&element).map_or("_", name)).collect_vec();
    let star = if by_reference && !array.contains('.') { "*" } else { "" };
    line(text, 0, &format!("let [{}, ..] = {star}{array};", names.join(", ")));
}

/// `live_after[k]`: the locals that statements from `k` on (or the result) read.
fn live_after(lines: &Lines) -> Vec<SortedSet<usize>> {
    let mut live: SortedSet<usize> =
        lines.value.iter().flat_map(|(_, reads)| reads.iter().copied()).collect();
    let mut all = vec![SortedSet::new(); lines.statements.len() + 1];
    all[lines.statements.len()].clone_from(&live);
    for (k, statement) in lines.statements.iter().enumerate().rev() {
        live.extend(statement.reads());
        // Sets are needed where blocks end only.
        if k % BLOCK == 0 {
            all[k].clone_from(&live);
        }
    }
    all
}

fn write_block(
    text: &mut String,
    lines: &Lines,
    range: std::ops::Range<usize>,
    live: &SortedSet<usize>,
    indent: usize,
) {
    let statements = &lines.statements[range];
    let made = statements.iter().flat_map(Statement::makes).filter(|local| live.contains(local));
    let names: Vec<&str> = made.map(|local| lines.locals[local].as_str()).collect_vec();
    let tuple = match names.as_slice() {
        [] => None,
        [one] => Some((*one).to_owned()),
        many => Some(format!("({})", many.join(", "))),
    };
    match &tuple {
        Some(tuple) => line(text, indent, &format!("let {tuple} = {{")),
        None => line(text, indent, "{"),
    }
    write_statements(text, lines, statements, indent + 4);
    match &tuple {
        Some(tuple) => {
            line(text, indent + 4, tuple);
            line(text, indent, "};");
        }
        None => line(text, indent, "}"),
    }
}

fn write_statements(text: &mut String, lines: &Lines, statements: &[Statement], indent: usize) {
    for statement in statements {
        match statement {
            Statement::Title(title) => line(text, indent, &format!("// {title}")),
            Statement::Read { local, array, element } => {
                line(text, indent, &format!("let {} = {array}[{element}];", lines.locals[*local]));
            }
            Statement::Let { pattern, value, .. } => line(text, indent, &format!("let {pattern} = {value};")),
            Statement::Store { place, value, .. } => line(text, indent, &format!("{place} = {value};")),
            Statement::Block { text: block, .. } => block.lines().for_each(|of| line(text, indent, of)),
        }
    }
}

fn line(text: &mut String, indent: usize, content: &str) {
    let _ = writeln!(text, "{:indent$}{content}", "");
}
