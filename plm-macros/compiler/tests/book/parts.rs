//! Pages of the parts library: what each part has, and what its example costs.

use std::collections::BTreeSet;
use std::fs;

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::{Definition, ExprKind, ItemKind};
use plm_compiler::syntax::parse_parts;
use plm_compiler::token::Sources;
use plm_compiler::{compile, words};

use super::{EXAMPLE, blocks, book, first_cells, same};

/// Names of parameters, inputs, choices and outputs of a part.
fn names(part: &Definition) -> Vec<&str> {
    let mut names = Vec::new();
    for item in &part.items {
        match &item.kind {
            ItemKind::Param(value) | ItemKind::Input(value) | ItemKind::State(value) => {
                names.push(value.name.ident.text.as_str());
            }
            ItemKind::Node(node) => names.push(node.name.ident.text.as_str()),
            ItemKind::Choice(choice) => names.push(choice.name.text.as_str()),
            ItemKind::Function(function) => names.push(function.name.text.as_str()),
            ItemKind::Points(points) => names.push(points.name.text.as_str()),
            ItemKind::Output(outputs) => {
                let of = outputs.iter().filter_map(|output| match (&output.name, &output.value.kind) {
                    (Some(name), _) | (None, ExprKind::Name(name)) => Some(name.ident.text.as_str()),
                    _ => None,
                });
                names.extend(of);
            }
            _ => {}
        }
    }
    names
}

#[test]
fn the_page_of_a_part_lists_what_it_has() {
    for (name, text) in words::parts() {
        let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
        let id = sources.add_text(name, text);
        for part in parse_parts(sources.get(id).unwrap(), &mut sink).parts {
            let page = book().join(format!("parts/{name}.md"));
            let text = fs::read_to_string(&page).unwrap_or_else(|_| panic!("no page {}", page.display()));
            let known: BTreeSet<&str> = names(&part).into_iter().collect();
            assert_eq!(first_cells(&text), known, "{}", page.display());
        }
    }
}

/// Operations of the rate of a declaration.
fn operations(text: &str) -> i64 {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    compile(&mut sources).report.unwrap().rate.operations.total().into()
}

/// The last section of a page: what its first example costs an evaluation of the rate.
fn cost(page: &str, plain: i64) -> Option<String> {
    let lines: Vec<&str> = page.lines().collect();
    let blocks = blocks(&lines);
    let block = blocks.iter().find(|block| block.words[0] == "plm")?;
    let text = block.text(&lines);
    Some(if block.words.contains(&"items") {
        let with = operations(&format!("pub Example {{ allow(W0007);\n{text}{EXAMPLE}}}"));
        format!(
            "An evaluation of the [two bars](../language/declaration.md) has {with} operations with the first example, and {plain} without."
        )
    } else {
        format!("An evaluation of the first example has {} operations.", operations(&text))
    })
}

#[test]
fn the_page_of_a_part_says_what_its_example_costs() {
    let plain = operations(&format!("pub Example {{{EXAMPLE}}}"));
    for (name, _) in words::parts() {
        let path = book().join(format!("parts/{name}.md"));
        let page = fs::read_to_string(&path).unwrap();
        let body = page.split_once("\n## Cost\n").map_or(page.as_str(), |(body, _)| body).trim_end();
        let cost = cost(body, plain).unwrap_or_else(|| panic!("{name}.md has no example"));
        same(&path, &format!("{body}\n\n## Cost\n\n{cost}\n"));
    }
}
