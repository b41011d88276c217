//! Tests of the gallery: every figure of every machine, and the page of the book with its pictures.
#![allow(clippy::panic, reason = "tests")]

use std::fs;
use std::path::Path;
use std::sync::OnceLock;

use crate::beside_text::same;
use crate::book;
use crate::list::{ARM, MACHINES, Machine};
use crate::machines::{
    andrews, excavator, geneva, jansen, klann, lambda, peaucellier, pumpjack, scissor, walschaerts, watt,
    whitworth, wiper,
};
use crate::sheet::Sheet;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The sheets of all machines; each runs once.
fn sheets() -> &'static [Sheet] {
    static SHEETS: OnceLock<Vec<Sheet>> = OnceLock::new();
    SHEETS.get_or_init(|| {
        let run =
            |machine: &Machine| (machine.sheet)().unwrap_or_else(|fault| panic!("{}: {fault}", machine.name));
        MACHINES.iter().map(run).collect()
    })
}

#[test]
fn figures_are_those_that_are_known() {
    for (machine, sheet) in MACHINES.iter().zip(sheets()) {
        assert!(sheet.holds() && sheet.demo == machine.name, "{sheet}");
    }
}

#[test]
fn the_page_is_what_the_program_writes() {
    let page = fs::read_to_string(root().join("docs/src/machines.md")).unwrap_or_default();
    let text = book::text(sheets());
    assert!(page == text, "docs/src/machines.md is out of date: `bash docs/gallery.sh machines` writes it");
}

#[test]
fn every_machine_has_its_pictures() {
    let folder = root().join("docs/src/images/machines");
    let mut wanted: Vec<String> = Vec::new();
    for name in MACHINES.iter().map(|machine| machine.name).chain([ARM.name]) {
        wanted.extend([format!("{name}.webp"), format!("{name}-dark.webp")]);
    }
    let sizes = wanted.iter().map(|file| folder.join(file).metadata().map_or(0, |data| data.len()));
    let missing: Vec<&String> =
        wanted.iter().zip(sizes.clone()).filter(|(_, size)| *size == 0).map(|(file, _)| file).collect();
    assert!(
        missing.is_empty(),
        "no {missing:?} in {}: `bash docs/gallery.sh machines` makes them",
        folder.display()
    );
    let all: u64 = sizes.sum();
    assert!(all < 2_500_000, "the moving pictures have {all} bytes");
    let there = fs::read_dir(&folder).into_iter().flatten().count();
    assert_eq!(there, wanted.len(), "{} holds pictures of no machine", folder.display());
}

#[test]
fn every_machine_is_a_file_to_copy() {
    let folder = root().join("examples/gallery/machines");
    let mut files = 0;
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        let name = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        if name == "mod" {
            continue;
        }
        files += 1;
        assert!(
            MACHINES.iter().any(|machine| machine.name == name),
            "examples/gallery/list.rs does not show {name}"
        );
        let text = fs::read_to_string(&path).unwrap_or_default();
        let lines = text.lines().count();
        assert!(lines < 80, "{} has {lines} lines", path.display());
        assert!(text.contains("//! Source: "), "{} does not say its source", path.display());
    }
    assert_eq!(files, MACHINES.len());
}

/// All of them from text, also those that are larger than 8 bodies.
#[test]
fn machines_from_text_have_the_bits_of_compiled_code() {
    same!(
        andrews::Andrews: 0.004,
        excavator::Excavator: 0.02,
        geneva::Geneva: 0.2,
        jansen::Jansen: 0.02,
        klann::Klann: 0.2,
        lambda::Lambda: 0.2,
        peaucellier::Peaucellier: 0.2,
        pumpjack::Pumpjack: 0.2,
        scissor::Scissor: 0.2,
        walschaerts::Walschaerts: 0.2,
        watt::Watt: 0.2,
        whitworth::Whitworth: 0.2,
        wiper::Wiper: 0.2,
    );
}
