//! The picture of the architecture: crates with their dependencies, the compiler's passes, and the runtime's step.

use std::path::Path;

use super::workspace::{packages, read};

/// The picture, from the root of the repository.
pub(crate) const PICTURE: &str = "docs/src/images/architecture.svg";

/// Place of a crate in the picture, and its role.
struct Place {
    name: &'static str,
    role: &'static str,
    /// The middle of its box, in pixels.
    x: i32,
    /// Its layer, from the top.
    layer: i32,
}

const fn place(name: &'static str, role: &'static str, x: i32, layer: i32) -> Place {
    Place { name, role, x, layer }
}

/// A crate depends on crates in layers below its own. Columns leave a way for every arrow.
const PLACES: [Place; 19] = [
    place("plm-planar", "plm, the users' crate", 620, 0),
    place("plm-cli", "the command line", 236, 0),
    place("plm-jit", "machine code", 506, 1),
    place("plm-source", "C99", 370, 2),
    place("plm-draw", "gestures as edits", 84, 2),
    place("plm-macros", "the macros", 84, 1),
    place("plm-dynamic", "mechanisms from text", 512, 3),
    place("plm-import", "files of others", 150, 3),
    place("plm-program", "whole programs", 712, 1),
    place("plm-compiler", "declaration to code", 84, 4),
    place("plm-python", "runs for Python", 840, 2),
    place("plm-studies", "fits, dimensions", 234, 4),
    place("plm-cas", "symbolic algebra", 128, 5),
    place("plm-run", "methods by name", 700, 4),
    place("plm-foreign", "C and FMUs", 830, 5),
    place("plm-view", "results, the page", 552, 5),
    place("plm-runtime", "contracts, the step", 622, 6),
    place("plm-math", "sin, sqrt and kin", 400, 7),
    place("plm-processor", "square roots", 400, 8),
];

/// Crates that do chores of the repository.
const LEFT_OUT: [&str; 1] = ["xtask"];

/// Each pass of the compiler, and what it makes.
const PASSES: [(&str, &str); 8] = [
    ("tokens", "numbered"),
    ("parse", "Ast"),
    ("resolve", "Model"),
    ("check", "diagnostics"),
    ("derive", "Equations"),
    ("formulate", "Program"),
    ("optimise", "Program"),
    ("emit", "Code"),
];

/// Each part of a step, and what it does.
const STEP: [(&str, &str); 3] = [
    ("propose", "a method, up to the first event"),
    ("judge", "a verdict that changes nothing"),
    ("commit", "discrete state, charts, turns, events"),
];

const WIDTH: i32 = 960;
const BOX_WIDTH: i32 = 136;
const BOX_HEIGHT: i32 = 46;
/// The top of the first layer, and the distance of layers.
const TOP: i32 = 80;
const PITCH: i32 = 70;
/// The tops of the two rows below the crates.
const PASSES_TOP: i32 = 746;
const STEP_TOP: i32 = 878;
const HEIGHT: i32 = 986;

const STYLE: &str = "\
<style>
svg { color-scheme: light dark; background: #ffffff; }
text { font: 13px system-ui, sans-serif; fill: #1d2430; text-anchor: middle; }
.role { font-size: 11px; fill: #566072; }
.title { font-size: 15px; font-weight: 600; text-anchor: start; }
.note { font-size: 11px; fill: #566072; text-anchor: start; }
rect { fill: #eef3fa; stroke: #7d93b2; }
.pass { fill: #eef7ef; stroke: #7ea786; }
.step { fill: #fbf3e6; stroke: #bd9a5f; }
path { fill: none; stroke: #566072; stroke-width: 1.3; }
.optional { stroke-dasharray: 5 4; }
.head { fill: #566072; stroke: none; }
@media (prefers-color-scheme: dark) {
svg { background: #14181f; }
text { fill: #e4e8ef; }
.role, .note { fill: #a3adbd; }
rect { fill: #1e2a3b; stroke: #5f7da6; }
.pass { fill: #1c2e21; stroke: #5e8f69; }
.step { fill: #33291a; stroke: #a5854f; }
path { stroke: #a3adbd; }
.head { fill: #a3adbd; stroke: none; }
}
</style>
";

/// A dependency, by numbers of places.
#[derive(Clone, Copy)]
struct Arrow {
    from: usize,
    to: usize,
    is_optional: bool,
}

/// The text of the picture.
///
/// # Errors
/// A manifest that cannot be read, a crate without a place, or a dependency on a crate that is not below.
pub(crate) fn picture(root: &Path) -> Result<String, String> {
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" \
         height=\"{HEIGHT}\" role=\"img\" aria-label=\"Crates, passes and the step\">\n{STYLE}<defs><marker id=\"head\" \
         viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">\
         <path class=\"head\" d=\"M0 0L8 4L0 8z\"/></marker></defs>\n"
    );
    let note = |y: i32, title: &str, note: &str| {
        format!(
            "<text class=\"title\" x=\"16\" y=\"{y}\">{title}</text>\n<text class=\"note\" x=\"16\" y=\"{}\">{note}</text>\n",
            y + 17
        )
    };
    svg += &note(26, "Crates", "An arrow leads to a dependency.");
    svg += "<text class=\"note\" x=\"16\" y=\"58\">Dashed: optional. Those that follow from others are left out.</text>\n";
    let arrows = needed(&arrows(root)?);
    svg += &arrows.iter().map(|&arrow| drawn(arrow, &arrows)).collect::<String>();
    for place in &PLACES {
        svg += &labelled("crate", (place.x, top(place.layer), BOX_WIDTH), place.name, place.role);
    }
    svg += &note(PASSES_TOP - 34, "Passes of the compiler", "Below each pass: the value that it makes.");
    svg += &row("pass", (PASSES_TOP, 100), &PASSES);
    svg += &note(
        STEP_TOP - 34,
        "A step of the runtime",
        "A proposal that is not accepted is made again: shorter, split, or by the near-singular method.",
    );
    svg += &row("step", (STEP_TOP, 232), &STEP);
    let (judge, below) = (WIDTH / 2, STEP_TOP + BOX_HEIGHT);
    let propose = 16 + 232 / 2;
    svg += &line(&format!("M{judge} {below}v22H{propose}v-20"), "");
    svg += "</svg>\n";
    Ok(svg)
}

fn top(layer: i32) -> i32 {
    TOP + layer * PITCH
}

/// A box with two lines of text: its middle, its top and its width.
fn labelled(class: &str, (x, y, width): (i32, i32, i32), name: &str, role: &str) -> String {
    format!(
        "<rect class=\"{class}\" x=\"{}\" y=\"{y}\" width=\"{width}\" height=\"{BOX_HEIGHT}\" rx=\"6\"/>\n\
         <text x=\"{x}\" y=\"{}\">{name}</text>\n<text class=\"role\" x=\"{x}\" y=\"{}\">{role}</text>\n",
        x - width / 2,
        y + 20,
        y + 36,
    )
}

/// Boxes over the whole width, each with an arrow to the next.
fn row(class: &str, (y, width): (i32, i32), boxes: &[(&str, &str)]) -> String {
    let gaps = boxes.len() as i32 - 1;
    let distance = (WIDTH - 32 - width) / gaps;
    let middle = |index: usize| 16 + width / 2 + index as i32 * distance;
    let mut svg = String::new();
    for (index, (name, role)) in boxes.iter().enumerate() {
        if index > 0 {
            let (from, to) = (middle(index - 1) + width / 2, middle(index) - width / 2);
            svg += &line(&format!("M{from} {}H{}", y + BOX_HEIGHT / 2, to - 1), "");
        }
        svg += &labelled(class, (middle(index), y, width), name, role);
    }
    svg
}

fn line(path: &str, class: &str) -> String {
    format!("<path{class} marker-end=\"url(#head)\" d=\"{path}\"/>\n")
}

/// All dependencies between crates that have a place.
fn arrows(root: &Path) -> Result<Vec<Arrow>, String> {
    let mut arrows = Vec::new();
    for package in packages(root)?.iter().filter(|package| !LEFT_OUT.contains(&package.name.as_str())) {
        let from =
            number(&package.name).ok_or_else(|| format!("{} has no place in the picture", package.name))?;
        let manifest = read(&root.join(&package.folder).join("Cargo.toml"))?;
        let lines = manifest.lines().skip_while(|line| *line != "[dependencies]").skip(1);
        for line in lines.take_while(|line| !line.starts_with('[')) {
            let Some((to, options)) = line.split_once(" = ") else { continue };
            // A key may go on: `plm-math.workspace = true`.
            let Some(to) = number(to.split('.').next().unwrap_or(to)) else { continue };
            if PLACES[from].layer >= PLACES[to].layer {
                return Err(format!("{} stands below {}", PLACES[from].name, PLACES[to].name));
            }
            arrows.push(Arrow { from, to, is_optional: options.contains("optional = true") });
        }
    }
    Ok(arrows)
}

fn number(name: &str) -> Option<usize> {
    PLACES.iter().position(|place| place.name == name)
}

/// Arrows that do not follow from others. One that always holds follows only from such as always hold.
fn needed(arrows: &[Arrow]) -> Vec<Arrow> {
    let follows = |arrow: &Arrow| {
        let firsts = arrows.iter().filter(|first| first.from == arrow.from && first.to != arrow.to);
        let mut firsts = firsts.filter(|first| arrow.is_optional || !first.is_optional);
        firsts.any(|first| leads(arrows, first.to, arrow))
    };
    arrows.iter().filter(|arrow| !follows(arrow)).copied().collect()
}

/// True if arrows lead from a crate to the end of an arrow. Layers bound the recursion.
fn leads(arrows: &[Arrow], from: usize, arrow: &Arrow) -> bool {
    let mut next = arrows.iter().filter(|next| next.from == from && (arrow.is_optional || !next.is_optional));
    from == arrow.to || next.any(|next| leads(arrows, next.to, arrow))
}

/// An arrow from the lower edge of a box to the upper edge of another; ends at one edge stand apart, in the order of the
/// other ends.
fn drawn(arrow: Arrow, arrows: &[Arrow]) -> String {
    let (from, to) = (&PLACES[arrow.from], &PLACES[arrow.to]);
    let leaving = arrows.iter().filter(|other| other.from == arrow.from).map(|other| PLACES[other.to].x);
    let coming = arrows.iter().filter(|other| other.to == arrow.to).map(|other| PLACES[other.from].x);
    let (start, end) = (from.x + shift(leaving, to.x), to.x + shift(coming, from.x));
    let path = format!("M{start} {}L{end} {}", top(from.layer) + BOX_HEIGHT, top(to.layer) - 1);
    line(&path, if arrow.is_optional { " class=\"optional\"" } else { "" })
}

/// How far from the middle of an edge the end stands whose other end is here.
fn shift(others: impl Iterator<Item = i32>, here: i32) -> i32 {
    let (mut count, mut before) = (0, 0);
    for other in others {
        count += 1;
        before += i32::from(other < here);
    }
    (2 * before - (count - 1)) * 11
}
