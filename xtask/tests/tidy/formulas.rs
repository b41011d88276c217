//! Formulas of the book are typeset: none stands as text in the pages that explain equations.

use std::fs;

use super::{fail_with, files, root, shown};

/// Signs of formulas. Squares and cubes of units may stand in prose.
const SIGNS: &str = "αβγδελμνρτφωθΣ∂∫√⁴⁵⁶⁻⁺ᵀ₀ḟẋφ̇";

#[test]
fn formulas_are_typeset() {
    let mut wrong = Vec::new();
    let book = root().join("docs/src");
    let pages = files(&["md"]).into_iter().filter(|page| page.starts_with(&book));
    for page in pages {
        let explains = ["theory", "parts"].iter().any(|folder| page.starts_with(book.join(folder)));
        let text = fs::read_to_string(&page).unwrap();
        let mut in_block = false;
        for (index, line) in text.lines().enumerate() {
            if line.trim_start().starts_with("```") {
                in_block = !in_block;
                if explains && in_block && line.trim() == "```text" {
                    wrong.push(format!("{}:{}: a block of text", shown(&page), index + 1));
                }
            } else if !in_block {
                let prose = line.split('`').step_by(2).flat_map(|text| text.split('$').step_by(2));
                if prose.into_iter().any(|text| text.contains(|letter| SIGNS.contains(letter))) {
                    wrong.push(format!("{}:{}: {}", shown(&page), index + 1, line.trim()));
                }
            }
        }
    }
    fail_with("formulas that are not typeset (`$…$`, or a block that is fenced as `math`)", &wrong);
}
