//! `llms.txt`: the language in short, for language models and tools, from the compiler's tables and the pages of the book.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use plm_compiler::diag::{Code, Diagnostics};
use plm_compiler::syntax::ast::{Definition, ExprKind, Item, ItemKind};
use plm_compiler::syntax::parse_parts;
use plm_compiler::token::{Source, Sources};
use plm_compiler::{units, words};

use super::{book, same};

const HEAD: &str = "\
# plm

> Planar mechanisms (rigid bodies in a plane, joints, springs, hydraulics), declared in Rust source by `plm::mechanism!`. The
> equations of motion are derived while rustc compiles, and a runtime without allocation steps them.

The package is `plm-planar`, the library `plm`. Written by `cargo xtask bless book`.

Rules that are easily missed:

* Every quantity has a unit after its number, with a blank between: `10 kg`, `(0.5, 0) m`, `9.81 m/s^2`, `30 deg`. 0 needs none.
* A joint joins ports, not bodies: `revolute pin(ground.o, arm.a);`. Ports are declared in bodies and in the ground.
* `locked` stands after a value at the start that assembly must not move.
* The order of items is free. Names are of snake case; that of the mechanism is of a type.
* What is read outside of the declaration must be an `output` or be named in `observe`.
* A stop, a floor, a belt is a row: `unilateral tip: rod.b.y >= 0;` pushes, `friction slip: rate(rod.b.x) within 0.3*reaction(tip);`
  sticks and slips.
* `param` is a field of the mechanism, `input` a field of `sim.input`; both in SI units.
";

/// The rules of a grammar as the documentation of a parser's file has them.
fn grammar(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/syntax").join(file);
    let text = fs::read_to_string(path).unwrap();
    let docs = text.lines().map_while(|line| line.strip_prefix("//!"));
    let inside =
        docs.skip_while(|line| line.trim() != "```text").skip(1).take_while(|line| line.trim() != "```");
    inside.flat_map(|line| [line.strip_prefix(' ').unwrap_or(line), "\n"]).collect()
}

/// The first program of the book.
fn example() -> String {
    let page = fs::read_to_string(book().join("getting-started.md")).unwrap();
    let (_, rest) = page.split_once("```rust\n").unwrap();
    rest.split_once("```").unwrap().0.to_owned()
}

/// What a running simulation gives, as the book has it.
fn methods() -> String {
    let page = fs::read_to_string(book().join("getting-started.md")).unwrap();
    let (_, rest) = page.split_once("## Read results\n").unwrap();
    let table =
        rest.lines().skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
    table.flat_map(|line| [line, "\n"]).collect()
}

/// The features of the package that users name, with the comments above them.
fn features() -> String {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../Cargo.toml");
    let manifest = fs::read_to_string(manifest).unwrap();
    let (_, section) = manifest.split_once("\n[features]\n").unwrap();
    let (mut text, mut comment) = (String::new(), String::new());
    for line in section.lines().take_while(|line| !line.starts_with('[')) {
        if let Some(words) = line.strip_prefix("# ") {
            comment = [&comment, words, " "].concat();
        } else if let Some((name, _)) = line.split_once(" = ").filter(|_| !comment.is_empty()) {
            let _ = writeln!(text, "- `{name}`: {}", std::mem::take(&mut comment).trim_end());
        }
    }
    text
}

/// The first sentence of a documentation.
fn sentence(docs: &[String]) -> String {
    let paragraph: Vec<&str> =
        docs.iter().map(|line| line.trim()).take_while(|line| !line.is_empty()).collect();
    let paragraph = paragraph.join(" ");
    paragraph.split_once(". ").map_or(paragraph.clone(), |(first, _)| format!("{first}."))
}

/// What a use of a part can set or read, as it is declared.
fn shown(item: &Item, source: &Source) -> Option<String> {
    let written = || source.text(item.span).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    match &item.kind {
        ItemKind::Param(_)
        | ItemKind::Input(_)
        | ItemKind::State(_)
        | ItemKind::Choice(_)
        | ItemKind::Function(_)
        | ItemKind::Points(_) => Some(written()),
        ItemKind::Node(node) => Some(format!("node {}: {};", node.name.ident.text, node.kind.text)),
        ItemKind::Output(outputs) => {
            let name = |of: &plm_compiler::syntax::ast::Output| match (&of.name, &of.value.kind) {
                (Some(name), _) | (None, ExprKind::Name(name)) => Some(name.ident.text.clone()),
                _ => None,
            };
            let names: Vec<String> = outputs.iter().filter_map(name).collect();
            Some(format!("output {};", names.join(", ")))
        }
        _ => None,
    }
}

fn part(text: &mut String, part: &Definition, source: &Source) {
    let arguments: Vec<String> =
        part.arguments.iter().map(|of| format!("{}: {}", of.name.text, of.kind.text)).collect();
    let kind = if part.is_joint { "joint" } else { "part" };
    let _ = writeln!(text, "\n### {kind} {}({})\n", part.name.text, arguments.join(", "));
    let _ = writeln!(text, "{}\n", sentence(&part.docs));
    for item in &part.items {
        if let Some(shown) = shown(item, source) {
            let says = sentence(&item.docs);
            let says = if says.is_empty() { says } else { format!("  // {says}") };
            let _ = writeln!(text, "    {shown}{says}");
        }
    }
}

/// Parts and domains of the library.
fn library(text: &mut String) {
    text.push_str("\n## Parts of the library\n\nUsed as `kind name(ports) { parameter: value; }`.\n");
    for (name, file) in words::parts().iter().chain(words::domains()) {
        let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
        let id = sources.add_text(name, file);
        let source = sources.get(id).unwrap();
        let shared = parse_parts(source, &mut sink);
        shared.parts.iter().for_each(|of| part(text, of, source));
        for domain in &shared.domains {
            let through: Vec<&str> = domain.through.iter().map(|of| of.name.text.as_str()).collect();
            let across = &domain.across.name.text;
            let _ = writeln!(
                text,
                "\n### domain {name}\n\n{}\n\n    across {across}; through {};",
                sentence(&domain.docs),
                through.join(", ")
            );
        }
    }
}

/// The pages of the book, as its summary lists them; those of diagnostics stand with their codes.
fn pages(text: &mut String) {
    text.push_str("\n## Pages of the book\n\nPaths from this file; in the repository from `docs/src/`, with the ending `.md`.\n");
    let summary = fs::read_to_string(book().join("SUMMARY.md")).unwrap();
    for line in summary.lines() {
        let link = line.trim_start_matches("- ").strip_prefix('[').and_then(|link| link.split_once("]("));
        if let Some((title, target)) = link.filter(|(_, target)| !target.starts_with("diagnostics/")) {
            let _ = writeln!(text, "- [{title}]({}.html)", target.trim_end_matches(".md)"));
        } else if let Some(title) =
            line.strip_prefix("# ").filter(|title| !["Summary", "Diagnostics"].contains(title))
        {
            let _ = writeln!(text, "\n### {title}\n");
        }
    }
}

fn made() -> String {
    let mut text = format!("{HEAD}\n## A program\n\n```rust\n{}```\n", example());
    let _ = write!(text, "\n## What a running simulation gives\n\n{}", methods());
    let _ = write!(text, "\n## Features of the package\n\n{}", features());
    let _ = write!(text, "\n## Grammar\n\n```text\n{}\n", grammar("mod.rs"));
    let _ = write!(text, "{}\n{}```\n", grammar("expr.rs"), grammar("unit.rs"));
    let _ = writeln!(text, "\n## Words\n\n* functions: {}", words::functions().join(", "));
    let _ = writeln!(text, "* members of bodies: {}", words::members_of_bodies().join(", "));
    let _ = writeln!(text, "* members of ports: {}", words::members_of_frames().join(", "));
    let _ = writeln!(text, "* constants: {}", words::constants().join(", "));
    let named = |name: &'static str| format!("{name} ({})", units::unit(name).unwrap().word);
    let _ =
        writeln!(text, "* units: {}", words::units().into_iter().map(named).collect::<Vec<_>>().join(", "));
    let _ = writeln!(
        text,
        "* options of `formulation`, `code`, `emit: step(…)` and `impacts`: {}",
        words::options().join(", ")
    );
    library(&mut text);
    text.push_str("\n## Codes of diagnostics\n\nEach has a page, `diagnostics/E0101.html`.\n\n");
    for code in Code::ALL {
        let _ = writeln!(text, "- {code}: {}", code.title());
    }
    pages(&mut text);
    text
}

#[test]
fn the_language_in_short_is_that_of_the_compiler() {
    let made = made();
    assert!(words::parts().iter().all(|(name, _)| made.contains(&format!(" {name}("))));
    same(&book().join("llms.txt"), &made);
}

/// The texts in brackets after `mechanism!`, and those that are fenced as `plm`.
fn declarations(text: &str) -> Vec<String> {
    let inside = |rest: &str| {
        let mut depth = 0;
        let end = rest.char_indices().find(|(_, letter)| {
            depth += i32::from(*letter == '{') - i32::from(*letter == '}');
            depth < 0
        });
        rest[..end.unwrap().0].to_owned()
    };
    let called = text.split("plm::mechanism! {").skip(1).map(inside);
    let fenced = text.split("```plm\n").skip(1).map(|rest| rest.split("```").next().unwrap().to_owned());
    called.chain(fenced).collect()
}

#[test]
fn every_declaration_of_the_language_in_short_compiles() {
    let text = fs::read_to_string(book().join("llms.txt")).unwrap();
    let all = declarations(&text);
    assert!(!all.is_empty());
    for declaration in all {
        let mut sources = Sources::new();
        sources.add_text("llms.txt", &declaration);
        let said = plm_compiler::compile(&mut sources).diagnostics;
        let said: Vec<String> = said.sorted().iter().map(|one| one.render(&sources)).collect();
        assert!(said.is_empty(), "{declaration}\n{}", said.join("\n"));
    }
}
