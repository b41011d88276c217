//! Meanings of names and keywords: contents of a hover, and places of declarations.

use std::ops::Range;

use plm_compiler::{StartValue, units, words};

use super::document::{Declaration, Document, VALUE_OF};
use super::names::{Kind, Name};
use super::parts::{Member, Part};
use super::path::{Word, word};

/// Members of bodies and of frames: of G of a body, of the point of a frame; absolute axes.
const MEMBERS: [(&str, &str); 15] = [
    ("x", "Place along the x axis, m."),
    ("y", "Place along the y axis, m."),
    ("position", "Place, m."),
    ("angle", "Angle of the own x axis from the absolute one, rad, with whole turns."),
    ("axis", "Unit vector along the own x axis."),
    ("normal", "Unit vector along the own y axis."),
    ("vx", "Velocity along the x axis, m/s."),
    ("vy", "Velocity along the y axis, m/s."),
    ("velocity", "Velocity, m/s."),
    ("omega", "Angular velocity, rad/s."),
    ("ax", "Acceleration along the x axis, m/s^2."),
    ("ay", "Acceleration along the y axis, m/s^2."),
    ("acceleration", "Acceleration, m/s^2."),
    ("alpha", "Angular acceleration, rad/s^2."),
    ("body", "The body of the frame."),
];

/// Meaning of a name or a keyword.
#[derive(Debug)]
pub(super) enum Meaning<'a> {
    /// A name of the declaration.
    Name(&'a Name),
    /// A member of a body, of a port or of another frame.
    MemberOfFrame(&'static str),
    /// A name of a part in use.
    MemberOfPart(Member),
    /// A definition of the library.
    Part(Part),
    /// A function, a unit, or a constant.
    Word(String),
}

/// The meaning of the name or keyword at a place, with the token.
pub(super) fn meaning(document: &Document, at: usize) -> Option<(Meaning<'_>, Word, &Declaration)> {
    let declaration = document.declaration(at)?;
    let word = word(&document.text, &declaration.excerpt.range, at)?;
    let found = field(declaration, &word).or_else(|| of_path(declaration, &word.path, word.range.start))?;
    Some((found, word, declaration))
}

/// The parameter of a part in use: `stiffness: 10 N/m;`, `chamber1.pressure: 30 bar;`.
fn field<'a>(declaration: &'a Declaration, word: &Word) -> Option<Meaning<'a>> {
    let names = &declaration.names;
    let instance =
        names.instance_around(word.range.start).filter(|_| word.is_field || word.path.len() > 1)?;
    let Kind::Instance(kind) = &instance.kind else { return None };
    if instance.place == word.range {
        return None;
    }
    member(declaration, &names.part(kind)?, &word.path).map(Meaning::MemberOfPart)
}

/// The member at the end of a path that begins within a part.
fn member(declaration: &Declaration, part: &Part, path: &[String]) -> Option<Member> {
    let (first, rest) = path.split_first()?;
    let found = part.member(first)?.clone();
    match (rest, &found.kind) {
        ([], _) => Some(found),
        (rest, Some(kind)) => member(declaration, &declaration.names.part(kind)?, rest),
        _ => None,
    }
}

fn of_path<'a>(declaration: &'a Declaration, path: &[String], at: usize) -> Option<Meaning<'a>> {
    let names = &declaration.names;
    let (first, rest) = path.split_first()?;
    if rest.is_empty() {
        return names.visible(first, at).map(Meaning::Name).or_else(|| of_word(declaration, first));
    }
    let is_ground = first == "ground";
    let owner = names.visible(first, at);
    match owner.map(|owner| &owner.kind) {
        Some(Kind::Instance(kind)) => {
            member(declaration, &names.part(kind)?, rest).map(Meaning::MemberOfPart)
        }
        Some(Kind::Body) | None if is_ground || owner.is_some() => match rest {
            [port] => names.port(first, port).map(Meaning::Name).or_else(|| of_frame(port)),
            [_, member] => of_frame(member),
            _ => None,
        },
        Some(Kind::Node) => rest.last().and_then(|member| of_frame(member)),
        _ => None,
    }
}

fn of_frame<'a>(member: &str) -> Option<Meaning<'a>> {
    MEMBERS.iter().find(|(name, _)| *name == member).map(|(_, says)| Meaning::MemberOfFrame(says))
}

/// A name or keyword that stands alone and is no name of the declaration.
fn of_word<'a>(declaration: &Declaration, word: &str) -> Option<Meaning<'a>> {
    if let Some(part) = declaration.names.part(word) {
        return Some(Meaning::Part(part));
    }
    if let Some(unit) = units::unit(word) {
        let text = format!(
            "{}, a unit: 1 {word} = {} {}",
            unit.word,
            unit.factor().to_f64(),
            unit.dimension.si_unit()
        );
        return Some(Meaning::Word(text));
    }
    match word {
        "t" => Some(Meaning::Word("the time, s".to_owned())),
        "pi" => Some(Meaning::Word("the number pi".to_owned())),
        _ if words::functions().contains(&word) => Some(Meaning::Word(format!("a function: `{word}(…)`"))),
        _ => None,
    }
}

/// Text of a hover, in Markdown, and the range that it belongs to.
pub(super) fn hover(document: &Document, at: usize) -> Option<(String, Range<usize>)> {
    let (meaning, word, declaration) = meaning(document, at)?;
    let code = |written: &str| format!("```plm\n{written}\n```");
    let mut lines = match &meaning {
        Meaning::Name(name) => vec![code(&name.written), name.docs.clone()],
        Meaning::MemberOfFrame(says) => vec![code(&word.written), (*says).to_owned()],
        Meaning::MemberOfPart(member) => vec![code(&member.written), member.docs.clone()],
        Meaning::Part(part) => vec![code(&part.head), part.docs.clone()],
        Meaning::Word(text) => vec![text.clone()],
    };
    // Within the definition of a part a name has a value for each use.
    let has_value =
        !matches!(meaning, Meaning::Part(_) | Meaning::Word(_)) && !declaration.names.is_in_part(at);
    let full = match &meaning {
        Meaning::Name(Name { owner: Some(owner), text, .. }) => format!("{owner}.{text}.position"),
        // The field of a part in use.
        Meaning::MemberOfPart(_) if word.is_field => {
            let instance = declaration.names.instance_around(at).map_or("", |instance| &instance.text);
            format!("{instance}.{}", word.written)
        }
        _ => word.written.clone(),
    };
    let values = if has_value { document.values(declaration) } else { &[] };
    if let Some(found) = value(values, &full) {
        if !lines.iter().any(|line| !found.docs.is_empty() && line.contains(&found.docs)) {
            lines.push(found.docs.clone());
        }
        lines.push(format!("At the start: `{}`", shown(found)));
    }
    lines.retain(|line| !line.is_empty());
    Some((lines.join("\n\n"), word.range))
}

/// The value of a full name.
pub(super) fn value<'a>(values: &'a [StartValue], name: &str) -> Option<&'a StartValue> {
    let of_let = format!("{VALUE_OF}{name}");
    let found = values.iter().find(|value| value.name == name || value.name == of_let)?;
    found.values.iter().all(|value| value.is_finite()).then_some(found)
}

/// A value with its unit: `(0.5, 0) m`.
pub(super) fn shown(value: &StartValue) -> String {
    let numbers: Vec<String> = value.values.iter().map(|value| rounded(*value)).collect();
    let numbers = if numbers.len() > 1 { format!("({})", numbers.join(", ")) } else { numbers.concat() };
    format!("{numbers} {}", value.unit).trim_end().to_owned()
}

/// Six digits, without zeros at the end; rounding errors of assembly are zero.
fn rounded(value: f64) -> String {
    if value.abs() < 1e-12 {
        return "0".to_owned();
    }
    let text = format!("{value:.5e}");
    let short = text.parse::<f64>().unwrap_or(value);
    if (1e-4..1e7).contains(&short.abs()) { short.to_string() } else { format!("{short:e}") }
}

#[cfg(test)]
mod tests {
    use plm_compiler::words;

    use super::{MEMBERS, rounded};

    #[test]
    fn every_member_of_bodies_and_frames_is_told() {
        let known = [words::members_of_bodies(), words::members_of_frames()].concat();
        assert!(known.iter().all(|name| MEMBERS.iter().any(|(told, _)| told == name)), "{known:?}");
        assert!(MEMBERS.iter().all(|(name, _)| known.contains(name)));
    }

    #[test]
    fn numbers_have_six_digits() {
        let found = [0.1 + 0.2, -19.62, 1e-17, 2.5e9, 1.0 / 3.0].map(rounded);
        assert_eq!(found, ["0.3", "-19.62", "0", "2.5e9", "0.333333"]);
    }
}
