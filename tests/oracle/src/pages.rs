//! Every part as its page shows it, turned, with one of its parameters at a special value: the same motion as of the image.

use std::fs;
use std::path::Path;
use std::sync::OnceLock;

use plm_dynamic::{Integrator, Mechanism, Run};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};
use crate::turned::{split, turned};

/// How long a run is, s, and a step.
const RUN: (f64, f64) = (0.05, 1e-3);
/// Numbers agree to this part of their size, which is 1 at least.
const AGREE: f64 = 1e-6;

/// An example of a page.
pub(crate) struct Example {
    pub(crate) page: String,
    pub(crate) text: String,
    /// It stands as items in the mechanism of the book, after this place.
    items: usize,
}

/// The examples of all pages of parts.
pub(crate) fn examples() -> &'static [Example] {
    static EXAMPLES: OnceLock<Vec<Example>> = OnceLock::new();
    EXAMPLES.get_or_init(|| {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let book = fs::read_to_string(root.join("plm-macros/compiler/tests/book.rs")).unwrap_or_default();
        let around = book.split("const EXAMPLE: &str = \"").nth(1).and_then(|rest| rest.split("\";").next());
        let around = around.unwrap_or_default();
        let mut pages: Vec<_> = fs::read_dir(root.join("docs/src/parts"))
            .map(|folder| folder.flatten().map(|entry| entry.path()).collect())
            .unwrap_or_default();
        pages.sort();
        let mut found = Vec::new();
        for path in pages {
            let page = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let text = fs::read_to_string(&path).unwrap_or_default();
            for block in text.split("\n```plm").skip(1) {
                let Some((fence, rest)) = block.split_once('\n') else { continue };
                let inside = rest.split("\n```").next().unwrap_or_default();
                let (text, items) = match fence {
                    "" => (inside.to_owned(), 0),
                    ",items" => {
                        let head = format!("pub Scene {{ allow(W0001, W0002, W0004, W0006, W0007);{around}");
                        (format!("{head}{inside}\n}}"), head.len())
                    }
                    _ => continue,
                };
                found.push(Example { page: page.clone(), text: without_comments(&text), items });
            }
        }
        found
    })
}

fn without_comments(text: &str) -> String {
    text.lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .flat_map(|line| [line, "\n"])
        .collect()
}

/// A page, an angle, and a parameter with a special value half of the time.
pub(crate) fn case(draw: &mut Draw) -> Case {
    let example = draw.one_of(examples());
    let mut text = example.text.clone();
    let is_special = draw.chance(0.5);
    if is_special {
        text = special(draw, &text, example.items).unwrap_or(text);
    }
    let by = draw.number(-180.0, 360.0, &[90.0, 180.0, 37.0, -90.0]);
    let verdict = match turned(&text, by) {
        Some(image) => match compared(&text, &image, by) {
            Verdict::Stopped(said) if !is_special && !said.contains("shorter steps") => {
                Verdict::Wrong(format!("the page does not run: {said}"))
            }
            verdict => verdict,
        },
        None => Verdict::Undecided("it is said in absolute axes".to_owned()),
    };
    Case { family: example.page.clone(), text: format!("{text}\nturned by {by:?} deg"), verdict }
}

/// The declaration with one field of a part at a special value.
fn special(draw: &mut Draw, text: &str, from: usize) -> Option<String> {
    let fields: Vec<(usize, usize)> = text[from.min(text.len())..]
        .match_indices(") {")
        .filter_map(|(at, _)| {
            let open = from + at + 3;
            Some((open, open + text[open..].find('}')?))
        })
        .collect();
    if fields.is_empty() {
        return None;
    }
    let (open, close) = *draw.one_of(&fields);
    let mut items: Vec<String> = split(&text[open..close], ';').into_iter().map(ToOwned::to_owned).collect();
    let k = draw.below(items.len());
    let (key, value) = items[k].split_once(':')?;
    let value = value.trim();
    let by = *draw.one_of(&["0*", "-1*", "1e-9*", "2*"]);
    items[k] = format!("{key}: {by}({value})");
    Some(format!("{}{}{}", &text[..open], items.join(";"), &text[close..]))
}

fn compared(text: &str, image: &str, by: f64) -> Verdict {
    let own = run(text);
    let other = run(image);
    match (own, other) {
        (Ok(own), Ok(other)) => same(&own, &other, by),
        (Err(own), Err(other)) => {
            if is_cause(&own) && is_cause(&other) {
                Verdict::Stopped(own)
            } else {
                Verdict::Wrong(format!("no cause: {own}; {other}"))
            }
        }
        // A step at the edge of what is too long.
        (Ok(_), Err(said)) | (Err(said), Ok(_)) if said.contains("shorter steps") => Verdict::Undecided(said),
        (Ok(_), Err(other)) => Verdict::Wrong(format!("it runs, its image does not: {other}\n{image}")),
        (Err(own), Ok(_)) => Verdict::Wrong(format!("its image runs, it does not: {own}\n{image}")),
    }
}

/// Does a message say what is wrong?
fn is_cause(message: &str) -> bool {
    !["infinite or not a number", "stays above the tolerance", "steps in one interval"]
        .iter()
        .any(|text| message.contains(text))
}

fn run(text: &str) -> Result<Run, String> {
    let (until, step) = RUN;
    let mechanism = Mechanism::from_text(text).map_err(|error| error.to_string())?;
    let mut run = mechanism.start_with(Integrator::Rk4(step)).map_err(|error| error.to_string())?;
    run.step_to(until).map_err(|error| error.to_string())?;
    Ok(run)
}

/// Are bodies where the image has them, and outputs that know no axes the same?
fn same(own: &Run, other: &Run, by: f64) -> Verdict {
    let (sin, cos) = by.to_radians().sin_cos();
    let mut worst = 0.0_f64;
    let mut said = String::new();
    let mut differ = |name: &str, expected: f64, found: f64| {
        let off = (expected - found).abs() / AGREE / expected.abs().max(1.0);
        let off = if off.is_nan() && expected.is_nan() && found.is_nan() { 0.0 } else { off };
        if off.is_nan() || off > worst {
            worst = if off.is_nan() { f64::INFINITY } else { off };
            said = format!("{name}: {found}, of the image {expected}");
        }
    };
    // Rotors of parts turn about an axis of their own, whatever way the mechanism lies.
    for name in own.bodies().filter(|name| !name.contains('.')) {
        let (Ok(a), Ok(b)) = (own.body(name), other.body(name)) else { continue };
        differ(&format!("{name}.x"), cos * a.x - sin * a.y, b.x);
        differ(&format!("{name}.y"), sin * a.x + cos * a.y, b.y);
        let turned = a.angle + by.to_radians() - b.angle;
        differ(&format!("{name}.angle"), 0.0, turned.sin());
        differ(&format!("{name}.omega"), a.omega, b.omega);
    }
    for ((name, _), (a, b)) in own.columns().zip(own.row().into_iter().zip(other.row())) {
        let axes = [".x", ".y", ".vx", ".vy", ".ax", ".ay", ".angle", "angle"];
        if !axes.iter().any(|end| name.ends_with(end)) {
            differ(name, a, b);
        }
    }
    if worst <= 1.0 { Verdict::Right(worst) } else { Verdict::Wrong(said) }
}
