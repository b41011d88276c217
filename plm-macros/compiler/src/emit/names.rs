//! Identifiers of the emitted code.

use std::collections::BTreeSet;

/// Words that cannot be identifiers in Rust 2024 without `r#`.
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro",
    "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait",
    "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];
/// Words that not even `r#` makes an identifier.
const PATHS: &[&str] = &["crate", "self", "super", "Self", "_"];

/// A path of the language as an identifier: `bar[3].angle` becomes `bar_3_angle`.
pub(crate) fn ident(path: &str) -> String {
    let mut text = String::with_capacity(path.len());
    for character in path.chars() {
        if character.is_alphanumeric() || character == '_' {
            text.push(character);
        } else if !text.ends_with('_') && character != ']' {
            text.push('_');
        }
    }
    let text = text.trim_end_matches('_');
    if KEYWORDS.contains(&text) {
        format!("r#{text}")
    } else if PATHS.contains(&text) {
        format!("{text}_")
    } else if text.is_empty() || text.starts_with(|c: char| c.is_ascii_digit()) {
        format!("n{text}")
    } else {
        text.to_owned()
    }
}

/// `DoublePendulum` becomes `double_pendulum`; digits stay with the word before them.
pub(crate) fn snake_case(name: &str) -> String {
    let mut text = String::with_capacity(name.len() + 4);
    let mut previous = '_';
    for character in name.chars() {
        if character.is_uppercase() && previous != '_' && !previous.is_uppercase() {
            text.push('_');
        }
        text.extend(character.to_lowercase());
        previous = character;
    }
    if KEYWORDS.contains(&text.as_str()) || PATHS.contains(&text.as_str()) {
        text + "_mechanism"
    } else {
        text
    }
}

/// Names of one scope, none twice.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    taken: BTreeSet<String>,
    numbered: usize,
}

impl Names {
    /// A scope in which some names are taken already.
    pub(crate) fn with_reserved(reserved: &[&str]) -> Names {
        Names { taken: reserved.iter().map(|&name| name.to_owned()).collect(), numbered: 0 }
    }

    /// The identifier of a path, with a number behind it if it is taken.
    pub(crate) fn unique(&mut self, path: &str) -> String {
        let base = ident(path).to_lowercase();
        let mut name = base.clone();
        let mut number = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{}_{number}", base.trim_start_matches("r#"));
            number += 1;
        }
        name
    }

    /// The next of `t1`, `t2`, …
    pub(crate) fn numbered(&mut self, prefix: &str) -> String {
        loop {
            self.numbered += 1;
            let name = format!("{prefix}{}", self.numbered);
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_identifiers() {
        assert_eq!(ident("bar[3].angle"), "bar_3_angle");
        assert_eq!(ident("type"), "r#type");
        assert_eq!(ident("self"), "self_");
        assert_eq!(ident("3d"), "n3d");
    }

    #[test]
    fn type_names_become_module_names() {
        assert_eq!(snake_case("DoublePendulum"), "double_pendulum");
        assert_eq!(snake_case("S5"), "s5");
        assert_eq!(snake_case("FourBarABC"), "four_bar_abc");
        assert_eq!(snake_case("Loop"), "loop_mechanism");
    }

    #[test]
    fn names_do_not_meet() {
        let mut names = Names::with_reserved(&["x"]);
        assert_eq!(names.unique("x"), "x_2");
        assert_eq!(names.unique("arm.x"), "arm_x");
        assert_eq!(names.unique("arm_x"), "arm_x_2");
        assert_eq!(names.numbered("t"), "t1");
    }
}
