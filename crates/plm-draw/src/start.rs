//! Starts: a pose becomes that in which a mechanism begins.
//!
//! Which coordinates say it is not known here: whoever compiles asks how many freedoms there are, and which coordinates have them.

use plm_compiler::syntax::ast::{Body, Expr, ExprKind, ItemKind, Operator};

use crate::edit::Edit;
use crate::lexer::{Kind, tokens};
use crate::names::PortName;
use crate::number::{Change, Literal, degrees, rounded};
use crate::refusal::Refusal;
use crate::remove::statement;
use crate::rules::FINE;
use crate::setting;
use crate::sheet::{Sheet, Turn, unit_named};

/// Angles are written to this, rad.
const ANGLE_STEP: f64 = 1e-3 * std::f64::consts::PI / 180.0;

/// A coordinate of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinate {
    /// The place of its origin along the x axis, m.
    X,
    /// That along the y axis, m.
    Y,
    /// Its angle, rad.
    Angle,
}

/// A coordinate of a body at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct StartAt {
    /// The body.
    pub body: String,
    /// Which one.
    pub coordinate: Coordinate,
    /// Its value, SI.
    pub value: f64,
    /// Is assembly forbidden to move it?
    pub is_locked: bool,
}

/// A body whose angle a constraint prescribes, which begins further on.
#[derive(Clone, Debug, PartialEq)]
pub struct Ahead {
    /// The body.
    pub body: String,
    /// By so much, rad.
    pub by: f64,
}

impl Coordinate {
    /// All of them.
    pub const ALL: [Coordinate; 3] = [Coordinate::X, Coordinate::Y, Coordinate::Angle];

    /// Its word after `start`.
    pub fn word(self) -> &'static str {
        ["x", "y", "angle"][self as usize]
    }

    fn is_of(self, start: &plm_compiler::syntax::ast::Start) -> bool {
        start.coordinate.text == self.word()
    }
}

impl Sheet<'_> {
    /// Coordinates that assembly is forbidden to move, in the order of the text.
    pub fn locked_starts(&self) -> Vec<(String, Coordinate)> {
        let mut locked = Vec::new();
        for body in bodies(self) {
            for start in body.starts.iter().filter(|start| start.locked) {
                let coordinate = Coordinate::ALL.into_iter().find(|of| of.is_of(start));
                locked.extend(coordinate.map(|of| (body.name.ident.text.clone(), of)));
            }
        }
        locked
    }
}

/// Bodies that no repetition makes.
fn bodies<'s>(sheet: &'s Sheet<'_>) -> impl Iterator<Item = &'s Body> {
    sheet.items().iter().filter_map(|item| match &item.kind {
        ItemKind::Body(body) => Some(body),
        _ => None,
    })
}

/// The edits after which bodies begin at these coordinates, and no other coordinate is locked.
///
/// # Errors
/// The text has no such body, a repetition makes it, or its start is a formula.
pub(crate) fn edits(
    sheet: &Sheet<'_>,
    starts: &[StartAt],
    ahead: &[Ahead],
    grid: f64,
) -> Result<Vec<Edit>, Refusal> {
    for of in starts {
        if !bodies(sheet).any(|body| body.name.ident.text == of.body) {
            let is_repeated = of.body.contains('[');
            let name = of.body.clone();
            return Err(if is_repeated { Refusal::Repeated(name) } else { Refusal::Unknown(name) });
        }
    }
    let mut edits = Vec::new();
    for body in bodies(sheet) {
        edits.extend(of_body(sheet, body, starts, grid)?);
    }
    for of in ahead {
        edits.extend(phase(sheet, of)?);
    }
    Ok(edits)
}

fn of_body(sheet: &Sheet<'_>, body: &Body, starts: &[StartAt], grid: f64) -> Result<Vec<Edit>, Refusal> {
    let (mut edits, mut new) = (Vec::new(), Vec::new());
    let name = &body.name.ident.text;
    for coordinate in Coordinate::ALL {
        let wanted = starts.iter().find(|of| of.body == *name && of.coordinate == coordinate);
        let written = body.starts.iter().find(|start| coordinate.is_of(start));
        match (wanted, written) {
            (Some(wanted), Some(start)) => {
                edits.extend(value(sheet, wanted, &start.value, grid)?);
                edits.extend(lock(sheet, start, wanted.is_locked));
            }
            (Some(wanted), None) => {
                let lock = if wanted.is_locked { ", locked" } else { "" };
                new.push(format!(" start {}: {}{lock};", coordinate.word(), written_value(wanted, grid)));
            }
            // More locks than freedoms would be none.
            (None, Some(start)) => edits.extend(lock(sheet, start, false)),
            (None, None) => {}
        }
    }
    if !new.is_empty() {
        edits.push(Edit::insertion(end_of(sheet, body), new.concat()));
    }
    Ok(edits)
}

fn step(coordinate: Coordinate, grid: f64) -> f64 {
    if coordinate == Coordinate::Angle { ANGLE_STEP } else { FINE * grid }
}

/// A value with its unit.
fn written_value(of: &StartAt, grid: f64) -> String {
    match of.coordinate {
        Coordinate::Angle => format!("{} deg", degrees(of.value)),
        _ => format!("{} mm", rounded(1e3 * of.value, 1e3 * FINE * grid)),
    }
}

/// The edit of a value that is written: a number, or the parameter that it is.
fn value(sheet: &Sheet<'_>, of: &StartAt, expr: &Expr, grid: f64) -> Result<Vec<Edit>, Refusal> {
    let zero = if of.coordinate == Coordinate::Angle { "deg" } else { "mm" };
    let formula = || Refusal::Formula(format!("start {} of {}", of.coordinate.word(), of.body));
    let changes = match (sheet.literal(expr, zero), &expr.kind) {
        (Some(literal), _) => vec![Change::new(&literal, of.value, step(of.coordinate, grid))],
        (None, ExprKind::Name(name)) if name.indices.is_empty() => {
            setting::changes(sheet, &name.ident.text, of.value).map_err(|_| formula())?
        }
        _ => return Err(formula()),
    };
    let new = changes.iter().filter(|change| change.is_new());
    Ok(new.map(|change| Edit::new(change.literal.range.clone(), change.text.clone())).collect())
}

/// The edit that locks a start, or does not any more.
fn lock(sheet: &Sheet<'_>, start: &plm_compiler::syntax::ast::Start, is_locked: bool) -> Option<Edit> {
    if start.locked == is_locked {
        return None;
    }
    let from = sheet.range(start.value.span).end;
    if is_locked {
        return Some(Edit::insertion(from, ", locked"));
    }
    let rest = sheet.text.get(from..)?;
    let word = tokens(rest).into_iter().find(|of| of.kind == Kind::Word && of.text(rest) == "locked")?;
    Some(Edit::new(from..from + word.range.end, ""))
}

/// The byte after the last statement of a body that has a place or a start, or after its bracket.
fn end_of(sheet: &Sheet<'_>, body: &Body) -> usize {
    let of_ports = body.ports.iter().map(|port| statement(sheet, port).end);
    let after = |from: usize, mark: char| {
        let rest = sheet.text.get(from..).unwrap_or_default();
        let found = tokens(rest).into_iter().find(|token| token.is_mark(rest, mark));
        found.map_or(from, |token| from + token.range.end)
    };
    let of_starts = body.starts.iter().map(|start| after(sheet.range(start.value.span).end, ';'));
    let of_name = sheet.range(body.name.ident.span).end;
    of_ports.chain(of_starts).max().unwrap_or_else(|| after(of_name, '{'))
}

/// The edits after which a constraint begins further on: the number that it begins with, or one in front of it.
fn phase(sheet: &Sheet<'_>, Ahead { body, by }: &Ahead) -> Result<Vec<Edit>, Refusal> {
    let angle = PortName::new(body.clone(), "angle");
    let is_angle = |expr: &Expr| Turn::default().port(expr).as_ref() == Some(&angle);
    let law = sheet.items().iter().find_map(|item| match &item.kind {
        ItemKind::Constraint(_, left, right, _) if is_angle(left) => Some(right),
        ItemKind::Constraint(_, left, right, _) if is_angle(right) => Some(left),
        _ => None,
    });
    let law = law.ok_or_else(|| Refusal::Repeated(body.clone()))?;
    let is_angle = |of: &Literal| of.unit.dimension.same(unit_named("deg").dimension);
    let first = match &law.kind {
        ExprKind::Chain(first, links) if links.iter().all(|link| is_sum(link.operator)) => first,
        _ => law,
    };
    if let Some(literal) = sheet.literal(first, "deg").filter(is_angle) {
        let change = Change::new(&literal, literal.si() + by, ANGLE_STEP);
        let new = change.is_new().then(|| Edit::new(literal.range, change.text));
        return Ok(new.into_iter().collect());
    }
    let whole = sheet.range(law.span);
    let begin = format!("{} deg + ", degrees(*by));
    Ok(match &law.kind {
        ExprKind::Neg(_) | ExprKind::If(..) => {
            vec![Edit::insertion(whole.start, begin + "("), Edit::insertion(whole.end, ")")]
        }
        _ => vec![Edit::insertion(whole.start, begin)],
    })
}

fn is_sum(operator: Operator) -> bool {
    matches!(operator, Operator::Add | Operator::Sub)
}
