//! Index of source files by their first sentences, and the picture of the crates.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// The page of the book that the index is written to, from the root.
pub(crate) const PAGE: &str = "docs/src/internals/files.md";
/// The picture of the crates.
pub(crate) const PICTURE: &str = "docs/src/images/architecture.svg";

/// Crates in layers, from those that users name to those that stand alone: folder, and what it is in two or three words.
const LAYERS: [&[(&str, &str)]; 5] = [
    &[(".", "what users name")],
    &[
        ("plm-study", "studies, batches"),
        ("plm-program", "programs, options"),
        ("plm-python", "Python"),
        ("plm-analysis", "linear, statics"),
    ],
    &[
        ("plm-sketch", "drawings"),
        ("plm-view", "page, charts, files"),
        ("plm-run", "methods by name"),
        ("plm-foreign", "C, FMI"),
    ],
    &[("plm-macros", "the macro"), ("plm-runtime", "contracts, methods")],
    &[
        ("plm-macros/compiler", "the compiler"),
        ("plm-macros/cas", "algebra"),
        ("plm-runtime/math", "sin, cos, sqrt"),
    ],
];
/// Rows below the crates: passes of the compiler, and what a step goes through.
const ROWS: [(&str, &[&str]); 2] = [
    ("compiler", &["tokens", "parse", "resolve", "check", "derive", "formulate", "optimise", "emit"]),
    ("step", &["propose", "judge", "commit", "events"]),
];

/// The index: a heading a crate, a line a file.
pub(crate) fn page(root: &Path) -> Result<String, String> {
    let mut text = String::from(
        "# Files\n\nEvery source file with the first sentence of its documentation, written by `cargo xtask index`.\n",
    );
    for source in sources(root)? {
        let mut files = Vec::new();
        collect(&source, &mut files)?;
        files.sort();
        let shown =
            |path: &Path| path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
        write!(text, "\n## {}\n\n", shown(&source)).map_err(|why| why.to_string())?;
        for file in files {
            let code = fs::read_to_string(&file).map_err(|why| format!("{}: {why}", file.display()))?;
            let sentence =
                first_sentence(&code).ok_or_else(|| format!("{} says nothing of itself", shown(&file)))?;
            writeln!(text, "* `{}`: {sentence}", shown(&file)).map_err(|why| why.to_string())?;
        }
    }
    Ok(text)
}

/// Folders of sources: of the packages of the workspace that are not tests.
fn sources(root: &Path) -> Result<Vec<PathBuf>, String> {
    let crates =
        LAYERS.iter().flat_map(|layer| layer.iter()).map(|(folder, _)| root.join(folder).join("src"));
    let others = ["plm-runtime/math/processor/src", "xtask/src"].map(|folder| root.join(folder));
    let all: Vec<PathBuf> = crates.chain(others).collect();
    match all.iter().find(|folder| !folder.is_dir()) {
        Some(missing) => Err(format!("{} is no folder", missing.display())),
        None => Ok(all),
    }
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> Result<(), String> {
    for entry in fs::read_dir(folder).map_err(|why| format!("{}: {why}", folder.display()))? {
        let path = entry.map_err(|why| why.to_string())?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

/// The first sentence of the documentation of a file.
fn first_sentence(code: &str) -> Option<String> {
    let lines =
        code.lines().skip_while(|line| !line.starts_with("//!")).map_while(|line| line.strip_prefix("//!"));
    let lines: Vec<&str> = lines.map(str::trim).take_while(|line| !line.is_empty()).collect();
    let text = lines.join(" ").replace("[`", "`").replace("`]", "`");
    // The point behind an initial ends no sentence.
    let ends = text.match_indices(". ").map(|(at, _)| at);
    let end =
        ends.into_iter().find(|at| text[..*at].rsplit([' ', '(']).next().is_some_and(|word| word.len() > 1));
    let end = end.map_or(text.len(), |at| at + 1);
    (!text.is_empty()).then(|| text[..end].to_owned())
}

/// What a crate of ours depends on among ours, by the names of packages; true where that is optional.
fn dependencies(root: &Path, folder: &str) -> Result<Vec<(String, bool)>, String> {
    let path = root.join(folder).join("Cargo.toml");
    let text = fs::read_to_string(&path).map_err(|why| format!("{}: {why}", path.display()))?;
    let section = text.split("\n[dependencies]\n").nth(1).unwrap_or_default();
    let lines = section.lines().take_while(|line| !line.starts_with('['));
    let ours = lines.filter(|line| line.starts_with("plm-"));
    let name = |line: &str| line.split(['.', ' ', '=']).next().unwrap_or_default().to_owned();
    Ok(ours.map(|line| (name(line), line.contains("optional = true"))).collect())
}

/// Crates with what they depend on.
type Edges = BTreeMap<String, Vec<(String, bool)>>;

fn edges(root: &Path) -> Result<Edges, String> {
    let folders = LAYERS.iter().flat_map(|layer| layer.iter()).map(|(folder, _)| folder);
    folders.map(|folder| Ok((package(folder), dependencies(root, folder)?))).collect()
}

/// Whether one crate cannot be without another.
fn reaches(edges: &Edges, from: &str, to: &str) -> bool {
    let needed = edges.get(from).into_iter().flatten().filter(|(_, is_optional)| !is_optional);
    needed.into_iter().any(|(other, _)| other == to || reaches(edges, other, to))
}

/// Middle and half of the width of a box.
struct Place {
    x: f64,
    y: f64,
    half: f64,
}

const WIDTH: f64 = 960.0;
const LAYER: f64 = 96.0;
const HIGH: f64 = 46.0;

fn places() -> BTreeMap<String, Place> {
    let mut places = BTreeMap::new();
    for (row, layer) in LAYERS.iter().enumerate() {
        let pitch = WIDTH / layer.len() as f64;
        for (column, (folder, _)) in layer.iter().enumerate() {
            let (x, y) = (pitch * (column as f64 + 0.5), 40.0 + LAYER * row as f64);
            places.insert(package(folder), Place { x, y, half: 92.0 });
        }
    }
    places
}

/// The name of the package in a folder.
fn package(folder: &str) -> String {
    match folder {
        "." => "plm".to_owned(),
        "plm-macros/compiler" => "plm-compiler".to_owned(),
        "plm-macros/cas" => "plm-cas".to_owned(),
        "plm-runtime/math" => "plm-math".to_owned(),
        other => other.to_owned(),
    }
}

/// The picture: crates in layers with their dependencies, the passes, the step.
pub(crate) fn picture(root: &Path) -> Result<String, String> {
    let places = places();
    let mut svg = String::from(HEAD);
    let fail = |why: std::fmt::Error| why.to_string();
    let edges = edges(root)?;
    for (name, others) in &edges {
        for (other, is_optional) in others {
            let is_implied = others.iter().any(|(between, optional)| {
                (*is_optional || !optional) && between != other && reaches(&edges, between, other)
            });
            let (Some(from), Some(to), false) = (places.get(name), places.get(other), is_implied) else {
                continue;
            };
            let (above, below) = (from.y + HIGH / 2.0, to.y - HIGH / 2.0);
            let class = if *is_optional { "arrow dashed" } else { "arrow" };
            let path = if above < below {
                let bend = (below - above) / 2.0;
                format!(
                    "M{:.0} {above:.0} C{:.0} {:.0} {:.0} {:.0} {:.0} {:.0}",
                    from.x,
                    from.x,
                    above + bend,
                    to.x,
                    below - bend,
                    to.x,
                    below - 3.0
                )
            } else {
                let side = if to.x > from.x { 1.0 } else { -1.0 };
                let (start, end) = (from.x + side * from.half, to.x - side * (to.half + 3.0));
                format!(
                    "M{start:.0} {:.0} C{:.0} {:.0} {:.0} {:.0} {end:.0} {:.0}",
                    from.y,
                    start,
                    from.y + 40.0,
                    end,
                    to.y + 40.0,
                    to.y
                )
            };
            writeln!(svg, "<path class=\"{class}\" d=\"{path}\"/>").map_err(fail)?;
        }
    }
    for (folder, what) in LAYERS.iter().flat_map(|layer| layer.iter()) {
        let name = package(folder);
        let Place { x, y, half } = &places[&name];
        writeln!(
            svg,
            "<rect x=\"{:.0}\" y=\"{:.0}\" width=\"{:.0}\" height=\"{HIGH}\" rx=\"6\"/>\
             <text class=\"name\" x=\"{x:.0}\" y=\"{:.0}\">{name}</text><text x=\"{x:.0}\" y=\"{:.0}\">{what}</text>",
            x - half, y - HIGH / 2.0, 2.0 * half, y - 4.0, y + 14.0
        )
        .map_err(fail)?;
    }
    for (row, (title, words)) in ROWS.iter().enumerate() {
        let y = 40.0 + LAYER * LAYERS.len() as f64 + 52.0 * row as f64;
        writeln!(svg, "<text class=\"title\" x=\"12\" y=\"{:.0}\">{title}</text>", y + 4.0).map_err(fail)?;
        for (column, word) in words.iter().enumerate() {
            let x = 140.0 + 104.0 * column as f64;
            writeln!(svg, "<rect class=\"pass\" x=\"{:.0}\" y=\"{:.0}\" width=\"84\" height=\"30\" rx=\"15\"/><text x=\"{x:.0}\" y=\"{:.0}\">{word}</text>", x - 42.0, y - 15.0, y + 4.0).map_err(fail)?;
            if column > 0 {
                writeln!(svg, "<path class=\"arrow\" d=\"M{:.0} {y:.0} h17\"/>", x - 62.0).map_err(fail)?;
            }
        }
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

const HEAD: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 960 610" width="960" height="610" font-family="system-ui, sans-serif" font-size="13" text-anchor="middle">
<style>
rect { fill: #f4f6f8; stroke: #5a6b7b; }
.pass { fill: #eaf2ea; }
text { fill: #24303a; }
.name { font-weight: 600; }
.title { text-anchor: start; font-weight: 600; }
.arrow { fill: none; stroke: #8a97a3; marker-end: url(#tip); }
.dashed { stroke-dasharray: 5 4; }
#tip path { fill: #8a97a3; }
@media (prefers-color-scheme: dark) {
rect { fill: #25303a; stroke: #8fa1b2; }
.pass { fill: #24352a; }
text { fill: #e6ebf0; }
}
</style>
<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto"><path d="M0 0L8 4L0 8z"/></marker></defs>
"#;
