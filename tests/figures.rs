//! The drawn figures of the book, made anew.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

#[path = "../examples/figures/blocks/mod.rs"]
mod blocks;
#[path = "../examples/figures/draw.rs"]
mod draw;
#[path = "support/readme.rs"]
mod readme;
#[path = "../examples/synthesis/figures.rs"]
mod synthesis;

use std::fs;
use std::path::Path;

use plm::Described;
use plm_compiler::words;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// `PLM_BLESS=1` writes them, or `cargo run --example figures` and `--example synthesis`.
#[test]
fn figures_of_the_book_are_those_that_are_drawn() {
    let mut wrong = Vec::new();
    for (path, svg) in draw::all(root()).unwrap().into_iter().chain(synthesis::all().unwrap()) {
        let file = root().join(&path);
        if std::env::var_os("PLM_BLESS").is_some() {
            fs::write(&file, &svg).unwrap();
        }
        if fs::read_to_string(&file).ok() != Some(svg) {
            wrong.push(path);
        }
    }
    assert!(
        wrong.is_empty(),
        "figures that are missing or differ from what is drawn: {wrong:?}; `cargo run --example figures` and `--example synthesis` write them"
    );
}

/// Drawings below `docs/src/images`, with their texts.
fn drawings(folder: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            found.extend(drawings(&path));
        } else if path.extension().is_some_and(|extension| extension == "svg") {
            found.push((path.display().to_string(), fs::read_to_string(&path).unwrap()));
        }
    }
    found
}

/// A drawing without colours of its own for a dark scheme is a white slab there; a chart has the style of all charts.
#[test]
fn every_drawing_has_colours_for_a_dark_scheme() {
    let (chart, style) = ("<rect width=\"800\"", plm_view::svg::dark_style());
    let drawings = drawings(&root().join("docs/src/images"));
    assert!(drawings.len() > 100, "the reader of drawings found only {}", drawings.len());
    for (file, svg) in drawings {
        let Some((_, dark)) =
            svg.split_once("prefers-color-scheme:").or_else(|| svg.split_once("prefers-color-scheme: "))
        else {
            panic!("{file} has no style for a dark scheme");
        };
        assert!(dark.trim_start().starts_with("dark"), "{file}");
        let is_chart = svg.lines().nth(2).is_some_and(|line| line.starts_with(chart));
        assert!(!is_chart || svg.contains(&style), "{file} has not the dark colours of charts");
    }
}

#[test]
fn every_part_has_a_figure() {
    let missing = draw::missing();
    assert!(missing.is_none(), "{}", missing.unwrap_or_default());
}

/// Ports, signals and senses of each box are those of the part in the library.
#[test]
fn boxes_have_the_ports_of_their_parts() {
    for block in blocks::blocks() {
        let name = block.name();
        let (_, part) = words::parts().iter().find(|(part, _)| *part == name).unwrap();
        let has = |kinds: &[&str], wanted: &str| {
            let starts = |line: &str, kind: &str| {
                let rest = line.trim_start().strip_prefix(kind);
                rest.is_some_and(|rest| {
                    rest.strip_prefix(wanted).is_some_and(|rest| rest.starts_with([':', ' ', ';']))
                })
            };
            part.lines().any(|line| kinds.iter().any(|kind| starts(line, kind)))
        };
        let (_, arguments) = part.split_once(&format!(" {name}(")).unwrap();
        let arguments = arguments.split_once(')').unwrap().0;
        for pin in block.names() {
            let is_argument = arguments.split(", ").any(|argument| argument.starts_with(&format!("{pin}:")));
            let is_known = is_argument || has(&["node ", "input ", "output "], pin);
            assert!(is_known, "{name} has no {pin}");
        }
        for sense in block.senses() {
            assert!(has(&["output "], sense), "{name} gives no {sense}");
        }
    }
}

#[test]
fn every_page_of_a_part_shows_its_figure() {
    let pages = fs::read_dir(root().join("docs/src/parts")).unwrap().map(|page| page.unwrap().path());
    let names: Vec<String> =
        pages.map(|page| page.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    assert!(names.len() > 30, "{names:?}");
    for name in names {
        let text = fs::read_to_string(root().join(format!("docs/src/parts/{name}.md"))).unwrap();
        let image = format!("images/parts/{name}.svg");
        assert!(
            text.contains(&format!("](../{image})")),
            "docs/src/parts/{name}.md has no `![{name}](../{image})`"
        );
        assert!(
            root().join("docs/src").join(&image).exists(),
            "no docs/src/{image}: `cargo run --example figures`"
        );
    }
}

plm::mechanism! {
    pub Crank {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; port rail: (0, -0.1) m, axis: 10 deg; }
        body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port pin: (0.2, 0) m; start angle: 70 deg, locked; }
        body rod { mass: 1 kg; inertia: 0.1 kg*m^2; port pin: (-0.4, 0) m; port end: (0.4, 0.1) m; }
        body ram { mass: 1 kg; inertia: 0.1 kg*m^2; port end: (0, 0) m; start x: 0.8 m; }
        revolute main(ground.o, crank.o);
        revolute big_end(crank.pin, rod.pin);
        revolute small_end(rod.end, ram.end);
        prismatic guide(ground.rail, ram.end);
    }
}

/// Assembled by the runtime, or by the compiler from the text that the mechanism tells of itself.
#[test]
fn both_ways_to_a_drawing_agree() {
    let sim = Crank::new().start().unwrap();
    let of_run = plm::view::sketch(&sim).with_gravity([0.0, -9.81]).to_svg();
    let of_text = draw::sketch(&draw::picture(Crank::<f64>::DECLARATION).unwrap()).to_svg();
    assert_eq!(of_run, of_text);
    assert!(of_run.contains(">big_end</text>"), "{of_run}");
}
