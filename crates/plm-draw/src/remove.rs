//! Removal: a thing goes with all that names it, and with what names that.

use std::collections::BTreeSet;
use std::ops::Range;

use plm_compiler::syntax::ast::{Contour, Expr, ExprKind, Ident, Item, ItemKind, Port};

use crate::edit::Edit;
use crate::lexer::tokens;
use crate::names::{GROUND, PortName};
use crate::refusal::Refusal;
use crate::sheet::{Joint, Mention, Sheet, mentions, mentions_of_expr};

/// Things that go by name, and ports by owner and name.
#[derive(Debug, Default)]
struct Gone {
    things: BTreeSet<String>,
    ports: BTreeSet<(String, String)>,
}

impl Gone {
    fn has(&self, Mention { name, member }: Mention<'_>) -> bool {
        let of_port = member.map(|member| (name.text.clone(), member.text.clone()));
        self.things.contains(&name.text) || of_port.is_some_and(|port| self.ports.contains(&port))
    }

    fn names(&self, item: &Item) -> bool {
        let mut names = false;
        mentions(item, &mut |mention| names |= self.has(mention));
        names
    }

    fn are_named_in(&self, expr: &Expr) -> bool {
        let mut names = false;
        mentions_of_expr(expr, &mut |mention| names |= self.has(mention));
        names
    }
}

/// The edits that take a thing away: `bar1`, `motor`, `p2`.
///
/// # Errors
/// The text has no such thing.
pub(crate) fn thing(sheet: &Sheet<'_>, name: &str) -> Result<Vec<Edit>, Refusal> {
    // A turn of a repetition goes with all of them.
    let name = name.split('[').next().unwrap_or(name);
    let mut is_there = false;
    every(sheet.items(), &mut |item| is_there |= declared(item).is_some_and(|of| of.text == name));
    if !is_there || name == GROUND {
        return Err(Refusal::Unknown(name.to_owned()));
    }
    Ok(removed(sheet, Gone { things: BTreeSet::from([name.to_owned()]), ports: BTreeSet::new() }))
}

/// The edits that take a port away.
///
/// # Errors
/// The text has no such port.
pub(crate) fn port(sheet: &Sheet<'_>, port: &PortName) -> Result<Vec<Edit>, Refusal> {
    if !sheet.handles().iter().any(|handle| handle.name == *port) {
        return Err(Refusal::Unknown(port.to_string()));
    }
    let base = |name: &str| name.split('[').next().unwrap_or(name).to_owned();
    let ports = BTreeSet::from([(base(&port.owner), base(&port.port))]);
    Ok(removed(sheet, Gone { things: BTreeSet::new(), ports }))
}

/// The edits that take the joints of a pin away; its ports stay.
///
/// # Errors
/// The text has no such port, or no joint holds it.
pub(crate) fn pin(sheet: &Sheet<'_>, port: &PortName) -> Result<Vec<Edit>, Refusal> {
    let pin = sheet.pin(port);
    let holds = |joint: &&Joint| joint.is_pin() && joint.ports.iter().any(|of| pin.contains(of));
    let base = |joint: &Joint| joint.name.split('[').next().unwrap_or(&joint.name).to_owned();
    let things: BTreeSet<String> = sheet.joints().iter().filter(holds).map(base).collect();
    if things.is_empty() {
        return Err(Refusal::Unknown(format!("pin of {port}")));
    }
    Ok(removed(sheet, Gone { things, ports: BTreeSet::new() }))
}

/// The edits that put one point of a drawing in the place of another, which goes.
pub(crate) fn replaced_point(sheet: &Sheet<'_>, from: &str, into: &str) -> Vec<Edit> {
    let mut edits = Vec::new();
    for item in sheet.items() {
        if declared(item).is_some_and(|name| name.text == from) {
            edits.push(Edit::new(with_line(sheet.text, &with_docs(sheet, item)), ""));
        }
        mentions(item, &mut |Mention { name, .. }| {
            if name.text == from {
                edits.push(Edit::new(sheet.range(name.span), into));
            }
        });
    }
    edits
}

/// The name that an item gives to a thing.
pub(crate) fn declared(item: &Item) -> Option<&Ident> {
    let name = match &item.kind {
        ItemKind::Param(of) | ItemKind::Input(of) | ItemKind::State(of) | ItemKind::Discrete(of) => &of.name,
        ItemKind::Let(name, _) | ItemKind::Constraint(name, ..) | ItemKind::Require(name, _) => name,
        ItemKind::Body(body) => &body.name,
        ItemKind::Instance(of) => &of.name,
        ItemKind::Unilateral(of) => &of.name,
        ItemKind::Friction(of) => &of.name,
        ItemKind::Node(of) => &of.name,
        _ => return None,
    };
    Some(&name.ident)
}

/// Items with those of repetitions, which come before the repetition.
fn every<'s>(items: &'s [Item], take: &mut impl FnMut(&'s Item)) {
    for item in items {
        if let ItemKind::Repeat(repeat) = &item.kind {
            every(&repeat.items, take);
        }
        take(item);
    }
}

/// Does an item go as a whole when it names what goes? Lists lose an entry, and blocks what is in them.
fn is_whole(item: &Item) -> bool {
    !matches!(
        item.kind,
        ItemKind::Output(_)
            | ItemKind::Observe(_)
            | ItemKind::Repeat(_)
            | ItemKind::Ground(_)
            | ItemKind::Body(_)
    )
}

fn removed(sheet: &Sheet<'_>, mut gone: Gone) -> Vec<Edit> {
    let mut items: BTreeSet<usize> = BTreeSet::new();
    let mut all = Vec::new();
    every(sheet.items(), &mut |item| all.push(item));
    loop {
        let before = items.len() + gone.ports.len();
        for (k, item) in all.iter().enumerate() {
            if items.contains(&k) {
                continue;
            }
            if goes(item, &mut gone) {
                items.insert(k);
                gone.things.extend(declared(item).map(|name| name.text.clone()));
            }
        }
        if before == items.len() + gone.ports.len() {
            break;
        }
    }
    drop_points(sheet, &all, &mut items, &gone);
    drop_empty(&all, &mut items);
    let mut edits = Vec::new();
    let outermost = |k: &usize| !items.iter().any(|other| other != k && contains(all[*other], all[*k]));
    for k in items.iter().filter(|k| outermost(k)) {
        edits.push(Edit::new(with_line(sheet.text, &with_docs(sheet, all[*k])), ""));
    }
    let kept = all
        .iter()
        .enumerate()
        .filter(|(k, item)| !items.contains(k) && !items.iter().any(|other| contains(all[*other], item)));
    for (_, item) in kept {
        edits.extend(entries(sheet, item, &gone));
    }
    edits
}

fn contains(outer: &Item, inner: &Item) -> bool {
    outer.span != inner.span && outer.span.first <= inner.span.first && inner.span.last <= outer.span.last
}

/// Does an item go? Ports that name what goes are noted.
fn goes(item: &Item, gone: &mut Gone) -> bool {
    let is_named = declared(item).is_some_and(|name| gone.things.contains(&name.text));
    match &item.kind {
        ItemKind::Body(body) => {
            let name = &body.name.ident.text;
            note_ports(name, &body.ports, gone);
            let fields = body.fields.iter().map(|(_, value)| value);
            let corners = body.contour.iter().chain(&body.holes).flat_map(|contour| match contour {
                Contour::Points(points) => &points[..],
                Contour::File(..) => &[],
            });
            let mut others = fields.chain(body.starts.iter().map(|start| &start.value)).chain(corners);
            is_named || others.any(|value| gone.are_named_in(value))
        }
        ItemKind::Ground(ports) => {
            note_ports(GROUND, ports, gone);
            !ports.is_empty() && ports.iter().all(|port| is_port_gone(GROUND, port, gone))
        }
        _ => is_named || is_whole(item) && gone.names(item),
    }
}

fn is_port_gone(owner: &str, port: &Port, gone: &Gone) -> bool {
    gone.ports.contains(&(owner.to_owned(), port.name.ident.text.clone()))
}

/// Ports whose place names what goes, go.
fn note_ports(owner: &str, ports: &[Port], gone: &mut Gone) {
    for port in ports {
        let mut values = std::iter::once(&port.at).chain(&port.angle).chain(&port.depth);
        if values.any(|value| gone.are_named_in(value)) {
            gone.ports.insert((owner.to_owned(), port.name.ident.text.clone()));
        }
    }
}

/// Points of a drawing that only what goes has named go too.
fn drop_points(sheet: &Sheet<'_>, all: &[&Item], items: &mut BTreeSet<usize>, gone: &Gone) {
    let mut freed = BTreeSet::new();
    for k in &*items {
        mentions(all[*k], &mut |mention| {
            freed.insert(mention.name.text.as_str());
        });
    }
    let kept_ports = |item: &Item, take: &mut dyn FnMut(&str)| match &item.kind {
        ItemKind::Ground(ports) => {
            for port in ports.iter().filter(|port| !is_port_gone(GROUND, port, gone)) {
                mentions_of_expr(&port.at, &mut |mention| take(&mention.name.text));
            }
        }
        ItemKind::Repeat(_) => {}
        _ => mentions(item, &mut |mention| take(&mention.name.text)),
    };
    let mut used = BTreeSet::new();
    for (_, item) in all.iter().enumerate().filter(|(k, _)| !items.contains(k)) {
        kept_ports(item, &mut |name| {
            used.insert(name.to_owned());
        });
    }
    for (k, item) in all.iter().enumerate() {
        let ItemKind::Let(name, value) = &item.kind else { continue };
        let is_point = match &value.kind {
            ExprKind::Quantity(pair, _) => matches!(pair.kind, ExprKind::Pair(..)),
            kind => matches!(kind, ExprKind::Pair(..)) || sheet.polar(value).is_some(),
        };
        let name = name.ident.text.as_str();
        if is_point && freed.contains(name) && !used.contains(name) {
            items.insert(k);
        }
    }
}

/// Repetitions whose items are all gone go.
fn drop_empty(all: &[&Item], items: &mut BTreeSet<usize>) {
    for (k, item) in all.iter().enumerate() {
        let ItemKind::Repeat(repeat) = &item.kind else { continue };
        let is_gone = |inner: &Item| items.iter().any(|other| all[*other].span == inner.span);
        if !repeat.items.is_empty() && repeat.items.iter().all(is_gone) {
            items.insert(k);
        }
    }
}

/// The edits of an item that stays: entries of lists, ports and contours that go.
fn entries(sheet: &Sheet<'_>, item: &Item, gone: &Gone) -> Vec<Edit> {
    let range = sheet.range(item.span);
    let list = |word: &str, all: usize, kept: Vec<&str>| {
        if kept.len() == all {
            Vec::new()
        } else if kept.is_empty() {
            vec![Edit::new(with_line(sheet.text, &range), "")]
        } else {
            vec![Edit::new(range.clone(), format!("{word} {};", kept.join(", ")))]
        }
    };
    match &item.kind {
        ItemKind::Output(outputs) => {
            let texts = between_commas(sheet.text, &range, "output");
            let kept = outputs.iter().zip(texts).filter(|(output, _)| !gone.are_named_in(&output.value));
            list("output", outputs.len(), kept.map(|(_, text)| text).collect())
        }
        ItemKind::Observe(all) => {
            let kept = all.iter().filter(|value| !gone.are_named_in(value));
            list("observe", all.len(), kept.map(|value| sheet.text_of(value.span)).collect())
        }
        ItemKind::Ground(ports) => without_ports(sheet, GROUND, ports, gone),
        ItemKind::Body(body) => without_ports(sheet, &body.name.ident.text, &body.ports, gone),
        _ => Vec::new(),
    }
}

fn without_ports(sheet: &Sheet<'_>, owner: &str, ports: &[Port], gone: &Gone) -> Vec<Edit> {
    let of = ports.iter().filter(|port| is_port_gone(owner, port, gone));
    of.map(|port| Edit::new(with_line(sheet.text, &statement(sheet, port)), "")).collect()
}

/// From the word `port` to its semicolon.
pub(crate) fn statement(sheet: &Sheet<'_>, port: &Port) -> Range<usize> {
    let name = sheet.range(port.name.ident.span);
    let start = sheet.text[..name.start].rfind("port").unwrap_or(name.start);
    let rest = &sheet.text[name.end..];
    let end = tokens(rest)
        .iter()
        .find(|token| token.is_mark(rest, ';'))
        .map_or(rest.len(), |token| token.range.end);
    start..name.end + end
}

/// Texts between the commas of a list that begins with a word and ends with a semicolon.
fn between_commas<'t>(text: &'t str, range: &Range<usize>, word: &str) -> Vec<&'t str> {
    let whole = text.get(range.clone()).unwrap_or_default();
    let begin = whole.find(word).map_or(0, |at| at + word.len());
    let list = &whole[begin..];
    let (mut entries, mut depth, mut start) = (Vec::new(), 0_i32, 0);
    for token in tokens(list) {
        let is = |mark: char| token.is_mark(list, mark);
        depth += i32::from(is('(') || is('[')) - i32::from(is(')') || is(']'));
        if depth == 0 && (is(',') || is(';')) {
            entries.push(list[start..token.range.start].trim());
            start = token.range.end;
        }
    }
    entries
}

/// An item with its documentation, which stands in the lines before it.
fn with_docs(sheet: &Sheet<'_>, item: &Item) -> Range<usize> {
    let mut range = sheet.range(item.span);
    let mut begin = range.start;
    for _ in &item.docs {
        let before = sheet.text[..begin].trim_end();
        let line = before.rfind('\n').map_or(0, |at| at + 1);
        let text = before[line..].trim_start();
        if !text.starts_with("///") {
            break;
        }
        begin = before.len() - text.len();
        range.start = begin;
    }
    range
}

/// An item with its documentation and its line.
pub(crate) fn whole_line(sheet: &Sheet<'_>, item: &Item) -> Range<usize> {
    with_line(sheet.text, &with_docs(sheet, item))
}

/// A range with the rest of its line where that is blank, else with the blanks before it.
fn with_line(text: &str, range: &Range<usize>) -> Range<usize> {
    let line = text[..range.start].rfind('\n').map_or(0, |at| at + 1);
    let end = text[range.end..].find('\n').map_or(text.len(), |at| range.end + at + 1);
    let is_alone = text[line..range.start].trim().is_empty() && text[range.end..end].trim().is_empty();
    if is_alone {
        return line..end;
    }
    let blanks = text[line..range.start].len() - text[line..range.start].trim_end_matches(' ').len();
    // At the beginning of a line the blanks after it go, so that the indentation stays.
    if blanks == range.start - line {
        let after = text[range.end..].len() - text[range.end..].trim_start_matches(' ').len();
        return range.start..range.end + after;
    }
    range.start - blanks..range.end
}
