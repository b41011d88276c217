//! Pages of the parts library: what each part has, and what its example costs.

use std::collections::BTreeSet;
use std::fs;

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::{Definition, ExprKind, ItemKind, all_items};
use plm_compiler::syntax::parse_parts;
use plm_compiler::token::Sources;
use plm_compiler::{compile, words};

use super::{EXAMPLE, blocks, book, first_cells, same};

/// Names of parameters, inputs, choices and outputs of a part.
fn names(part: &Definition) -> Vec<&str> {
    let mut names = Vec::new();
    for item in all_items(&part.items) {
        match &item.kind {
            ItemKind::Param(value)
            | ItemKind::Input(value)
            | ItemKind::State(value)
            | ItemKind::Discrete(value) => {
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
            // Each row says what it is in its last cell.
            let empty =
                text.lines().find(|line| line.starts_with("| `") && line.replace(' ', "").ends_with("||"));
            assert_eq!(empty, None, "{}", page.display());
        }
    }
}

/// Names of parameters that have a range wherever they stand: sizes, ratios of parts of a whole, times. Not those of oil and orifices, of
/// which a machine has many: a requirement on a parameter that may change is a guard of each step.
const RANGED: [&str; 35] = [
    "radius",
    "radius_a",
    "radius_b",
    "worm_radius",
    "wheel_radius",
    "base_radius",
    "roller_radius",
    "pivot_radius",
    "rolling_radius",
    "diameter",
    "rod_diameter",
    "piston_diameter",
    "pin_diameter",
    "collar_diameter",
    "thickness",
    "stroke",
    "volume",
    "dead_volume",
    "pressure_angle",
    "efficiency",
    "teeth_sun",
    "teeth_ring",
    "density",
    "bulk_modulus",
    "viscosity",
    "frequency",
    "damping_ratio",
    "time_constant",
    "period",
    "filter",
    "temperature",
    "ramp",
    "guide_length",
    "limit_stiffness",
    "static_ratio",
];

/// Statements of the language that say what a parameter may be, and fields that hand it to a part inside or to a body, which say it.
fn says_a_range(statement: &str) -> bool {
    let head = statement.split([':', ' ', '{']).find(|word| !word.is_empty()).unwrap_or_default();
    let others = [
        "param",
        "let",
        "input",
        "output",
        "state",
        "node",
        "picture",
        "constraint",
        "unilateral",
        "friction",
        "points",
    ];
    head == "require" || statement.contains(':') && !others.contains(&head)
}

/// A value that cannot be is told at once, and not by what a run makes of it.
#[test]
fn a_parameter_with_a_range_is_required_to_be_in_it() {
    for (name, text) in words::parts() {
        let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
        let id = sources.add_text(name, text);
        let code: Vec<&str> = text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect();
        let code = code.join(" ");
        let statements: Vec<&str> =
            code.split([';', '{', '}']).map(str::trim).filter(|of| says_a_range(of)).collect();
        let has = |statement: &str, word: &str| {
            statement.split(|of: char| !of.is_alphanumeric() && of != '_').skip(1).any(|part| part == word)
        };
        for part in parse_parts(sources.get(id).unwrap(), &mut sink).parts {
            for item in all_items(&part.items) {
                let ItemKind::Param(value) = &item.kind else { continue };
                let of = value.name.ident.text.as_str();
                let is_said = statements.iter().any(|statement| has(statement, of));
                assert!(!RANGED.contains(&of) || is_said, "`{of}` of `{name}` needs a `require`");
            }
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
