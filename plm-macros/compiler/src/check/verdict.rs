//! Result of assembly in words: which locks are too many, which joint stays open, which is redundant.

use crate::collect::CollectVec;
use crate::diag::{Code, Diagnostics, Severity};
use crate::model::{Model, Part, Row};
use crate::numeric::{Assembly, ChangePoint, Far};
use crate::sorted::sort_by;
use crate::units::Dimension;

/// Gaps below this, as a fraction of the size of the scene, may be lengths that repeat each other and disagree.
const DISAGREEMENT: f64 = 1e-3;

/// A joint with a compliance that is open by more than this fraction of the size of the scene, or by so many rad, is hardly
/// meant to be.
const STRAIN: f64 = 1e-4;

/// Names that one message lists.
const MOST_NAMES: usize = 8;

/// Rows that depend on others, each with all rows of that dependence.
type Dependent<'a> = [&'a (usize, Vec<usize>)];

/// Locks of positions or of velocities.
pub(super) struct Locks<'a> {
    pub(super) locked: &'a [bool],
    /// The locked quantity: `position` or `velocity`.
    pub(super) what: &'static str,
}

/// Locks that depend on the joints and on each other; a warning where parameters decide it, which are as declared here.
pub(super) fn too_many_locks(
    model: &Model,
    (locks, severity): (&Locks, Severity),
    dependent: &Dependent,
    diagnostics: &mut Diagnostics,
) {
    let rows = model.rows.len();
    let coordinates: Vec<usize> = (0..locks.locked.len()).filter(|&k| locks.locked[k]).collect_vec();
    let mut members: Vec<usize> = dependent.iter().flat_map(|(_, rows)| rows.iter().copied()).collect_vec();
    members.sort_unstable();
    members.dedup();
    let tied = members.iter().filter_map(|row| row.checked_sub(rows));
    let tied: Vec<String> = tied.map(|lock| lock_name(model, coordinates[lock], locks.what)).collect_vec();
    let joints = parts(model, members.iter().filter(|&&row| row < rows));
    let count = dependent.len();
    let first = coordinates[dependent[0].0 - rows];
    let body = &model.bodies[first / 3];
    let start = if locks.what == "position" { &body.start } else { &body.start_velocity };
    let is_one = |count| if count == 1 { "is" } else { "are" };
    let plural = if count == 1 { "" } else { "s" };
    let what =
        format!("{} {count} redundant constraint{plural} among the {} locks", is_one(count), locks.what);
    let span = start[first % 3].span;
    let diagnostic = match severity {
        Severity::Error => diagnostics.error(Code::TooManyLocks, span, format!("there {what}")),
        Severity::Warning => {
            let message = format!("with its parameters as declared there {what}");
            diagnostics.warning(Code::OpenDefaults, span, message)
        }
    };
    diagnostic
        .note(format!("locked, and tied to each other by {}: {}", listed(&joints), listed(&tied)))
        .note(format!(
            "F = 3 N - M = {}, but {} {} locked",
            3 * model.bodies.len() as isize - rows as isize,
            coordinates.len(),
            is_one(coordinates.len())
        ))
        .help(format!("take away {count} of these locks"));
}

fn lock_name(model: &Model, k: usize, what: &str) -> String {
    let body = &model.bodies[k / 3].name.text;
    let names = if what == "position" { ["x", "y", "angle"] } else { ["vx", "vy", "omega"] };
    format!("{body}.{}", names[k % 3])
}

/// Joints that cannot be closed together; a warning where parameters decide it, which are as declared here.
pub(super) fn not_closed(
    model: &Model,
    found: &Assembly,
    (length, severity): (f64, Severity),
    diagnostics: &mut Diagnostics,
) {
    let gaps = gaps(&model.rows, &found.phi, |row| found.closed[row]);
    let Some(widest) = gaps.first() else { return };
    let others: Vec<String> =
        gaps[1..].iter().map(|gap| format!("`{}` by {}", gap.joint(model), gap.text())).collect_vec();
    let open = format!("`{}` stays open by {}", widest.joint(model), widest.text());
    let (span, cannot) = (widest.row.span, "the mechanism cannot be assembled");
    let diagnostic = match severity {
        Severity::Error => diagnostics.error(Code::NotAssembled, span, format!("{cannot}: {open}")),
        Severity::Warning => {
            let message = format!("{cannot} with its parameters as declared: {open}");
            diagnostics.warning(Code::OpenDefaults, span, message)
        }
    };
    if let Some(searched) = found.searched {
        let tried = match searched.starts {
            1 => String::new(),
            starts => format!("no pose was found from {starts} starts; "),
        };
        diagnostic.note(format!("{tried}so much is missing at least, all others closed"));
    }
    if !others.is_empty() {
        diagnostic.note(format!("open too: {}", joined(&others)));
    }
    diagnostic.help("check the dimensions of the loop");
    let example = giving_way(model, widest.row.part, std::iter::once(widest.row));
    if let Some(example) = example.filter(|_| widest.size < DISAGREEMENT * length) {
        diagnostic.help(format!(
            "where lengths that repeat each other may disagree by so little, let a joint give way: `{example}`"
        ));
    }
}

/// How a joint is declared to give way in some of its rows; a constraint of the mechanism itself has no place for that.
fn giving_way<'a>(model: &Model, part: usize, rows: impl Iterator<Item = &'a Row>) -> Option<String> {
    let Part { name, frames, .. } = &model.parts[part];
    let (angles, lengths): (Vec<&Row>, Vec<&Row>) =
        rows.partition(|row| row.unit.dimension.same(Dimension::NUMBER));
    let mut words = Vec::new();
    if !lengths.is_empty() {
        words.push("compliance: 1e-9 m/N;");
    }
    if !angles.is_empty() {
        words.push("rotary_compliance: 1e-9 rad/(N*m);");
    }
    (!frames.is_empty()).then(|| format!("{}(…) {{ {} }}", name.text, words.join(" ")))
}

/// Joints with a compliance that assembly leaves open, and that would begin with a great force.
pub(super) fn strained(model: &Model, phi: &[f64], length: f64, diagnostics: &mut Diagnostics) {
    let limit = |gap: &Gap| STRAIN * if gap.row.unit.dimension == Dimension::LENGTH { length } else { 1.0 };
    for gap in gaps(&model.compliant, phi, |_| 0.0).iter().filter(|gap| gap.size > limit(gap)) {
        let (name, text) = (gap.joint(model), gap.text());
        diagnostics
            .warning(Code::Strained, gap.row.span, format!("`{name}` is open by {text} at the start"))
            .note("a joint with a compliance closes nothing: its force is what pulls it together")
            .help("lock the starts of the bodies that it joins where it is closed");
    }
}

/// How far a joint is open.
struct Gap<'a> {
    row: &'a Row,
    size: f64,
    unit: String,
}

impl Gap<'_> {
    fn joint<'m>(&self, model: &'m Model) -> &'m str {
        &model.parts[self.row.part].name.text
    }

    fn text(&self) -> String {
        format!("{} {}", rounded(self.size), self.unit)
    }
}

/// The open joints by `phi`, the widest first; of the rows of a joint those in one unit count together. A row is open above
/// its limit.
fn gaps<'a>(rows: &'a [Row], phi: &[f64], limit: impl Fn(usize) -> f64) -> Vec<Gap<'a>> {
    let mut gaps: Vec<(Gap, bool)> = Vec::new();
    for (k, (row, gap)) in rows.iter().zip(phi).enumerate() {
        let size = if gap.is_finite() { gap.abs() } else { f64::INFINITY };
        let is_open = size > limit(k);
        let same = |gap: &&mut (Gap, bool)| gap.0.row.part == row.part && gap.0.unit == row.unit.text;
        match gaps.iter_mut().find(same) {
            Some((gap, open)) => {
                gap.size = plm_math::f64::sqrt(gap.size * gap.size + size * size);
                *open |= is_open;
            }
            None => gaps.push((Gap { row, size, unit: row.unit.text.clone() }, is_open)),
        }
    }
    let mut gaps: Vec<Gap> = gaps.into_iter().filter(|(_, open)| *open).map(|(gap, _)| gap).collect_vec();
    sort_by(&mut gaps, |a, b| b.size.total_cmp(&a.size));
    gaps
}

/// Joints that say what others say already, and agree with them.
pub(super) fn redundant_joints(model: &Model, dependent: &Dependent, diagnostics: &mut Diagnostics) {
    let mut judged: Vec<usize> = Vec::new();
    for part in dependent.iter().map(|(row, _)| model.rows[*row].part) {
        if judged.contains(&part) {
            continue;
        }
        judged.push(part);
        let of_part: Vec<_> = dependent.iter().filter(|(row, _)| model.rows[*row].part == part).collect_vec();
        let rows: Vec<String> = of_part.iter().map(|(row, _)| model.rows[*row].name.clone()).collect_vec();
        let members =
            of_part.iter().flat_map(|(_, members)| members).filter(|&&row| model.rows[row].part != part);
        let others = parts(model, members);
        let (count, name) = (rows.len(), &model.parts[part].name.text);
        let (verb, plural) = if count == 1 { ("is", "") } else { ("are", "s") };
        let diagnostic = diagnostics.warning(
            Code::RedundantConstraint,
            model.rows[of_part[0].0].span,
            format!("{count} constraint{plural} of `{name}` {verb} redundant: {}", listed(&rows)),
        );
        if !others.is_empty() {
            diagnostic.note(format!("the same is held by {} already", listed(&others)));
        }
        diagnostic.note("it runs all the same; reactions that are left open get their minimum norm");
        if let Some(example) = giving_way(model, part, of_part.iter().map(|(row, _)| &model.rows[*row])) {
            diagnostic.help(format!("with a compliance they follow from it: `{example}`"));
        }
    }
}

/// A start that closes only far from where it is declared.
pub(super) fn far(model: &Model, found: &Assembly, diagnostics: &mut Diagnostics) {
    let Some(Far { coordinate, turned, missing }) = found.far else { return };
    let body = &model.bodies[coordinate / 3];
    diagnostics
        .warning(
            Code::FarStart,
            body.start[coordinate % 3].span,
            format!(
                "the start closes only far from where it is declared: `{}.angle` is turned by {} deg",
                body.name.text,
                rounded(turned.abs().to_degrees())
            ),
        )
        .note(format!("joints miss each other by {} m alone in the start as declared", rounded(missing)))
        .help(
            "check the dimensions; a pose near to the declared one does not close, or lies on another image",
        );
}

/// A start at which a loop lies in one line, or in another way at a change point.
pub(super) fn change_point(model: &Model, found: &Assembly, diagnostics: &mut Diagnostics) {
    let Some(ChangePoint { dependent, moves }) = &found.change_point else { return };
    if *moves == Some(true) {
        return;
    }
    let members = dependent.iter().flat_map(|(_, rows)| rows);
    let joints = listed(&parts(model, members));
    let span = model.rows[dependent[0].0].span;
    let help = "give the angles of the bodies between, so that the start lies beside the change point; assembly closes the rest";
    let diagnostic = if moves.is_some() {
        let message =
            format!("the start is a change point of {joints}, and its velocities belong to no motion");
        diagnostics.error(Code::NoMotion, span, message)
    } else {
        diagnostics.warning(Code::ChangePoint, span, format!("the start is a change point of {joints}"))
    };
    diagnostic.note("its loop can go on in two ways from there, and nothing says which").help(help);
}

/// Start velocities that the joints do not allow.
pub(super) fn contradiction(model: &Model, found: &Assembly, diagnostics: &mut Diagnostics) {
    if let Some(widest) = gaps(&model.rows, &found.phi_dot, |_| 0.0).first() {
        diagnostics.error(
            Code::NotAssembled,
            widest.row.span,
            format!("the start velocities contradict `{}` by {}/s", widest.joint(model), widest.text()),
        );
    }
}

/// Names of the parts of rows, each once.
fn parts<'a>(model: &Model, rows: impl Iterator<Item = &'a usize>) -> Vec<String> {
    let mut parts: Vec<usize> = rows.map(|&row| model.rows[row].part).collect_vec();
    parts.sort_unstable();
    parts.dedup();
    parts.into_iter().map(|part| model.parts[part].name.text.clone()).collect_vec()
}

/// `a`, `b` and `c` in backticks.
fn listed(names: &[String]) -> String {
    joined(&names.iter().map(|name| format!("`{name}`")).collect_vec())
}

/// With commas, and an `and` before the last; a long list is cut.
fn joined(texts: &[String]) -> String {
    match texts {
        [] => "nothing".to_owned(),
        [one] => one.clone(),
        _ if texts.len() > MOST_NAMES => {
            format!("{} and {} more", texts[..MOST_NAMES].join(", "), texts.len() - MOST_NAMES)
        }
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Three digits are enough to see how wrong it is.
pub(super) fn rounded(value: f64) -> String {
    let digits = format!("{value:.2e}");
    match digits.parse::<f64>() {
        Ok(rounded) if (1e-3..1e4).contains(&rounded) => rounded.to_string(),
        _ => digits,
    }
}

#[cfg(test)]
mod tests {
    use super::{joined, rounded};

    #[test]
    fn amounts_are_short() {
        assert_eq!(rounded(0.1), "0.1");
        assert_eq!(rounded(1.7958), "1.8");
        assert_eq!(rounded(123.456), "123");
        assert_eq!(rounded(0.000_012_345), "1.23e-5");
        assert_eq!(rounded(f64::INFINITY), "inf");
    }

    #[test]
    fn lists_read_like_sentences() {
        let names: Vec<String> = (0..12).map(|k| format!("n{k}")).collect();
        assert_eq!(joined(&names[..1]), "n0");
        assert_eq!(joined(&names[..3]), "n0, n1 and n2");
        assert_eq!(joined(&names), "n0, n1, n2, n3, n4, n5, n6, n7 and 4 more");
    }
}
