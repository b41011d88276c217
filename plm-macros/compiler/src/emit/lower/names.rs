//! Identifiers of the emitted code.

use crate::sorted::{SortedMap, SortedSet};

/// Is it one of these words?
fn is_among(words: &str, word: &str) -> bool {
    words.split(' ').any(|of| of == word)
}

/// Words that cannot be identifiers in Rust 2024 without `r#`.
const KEYWORDS: &str = "abstract as async await become box break const continue do dyn else enum extern false final fn for \
    gen if impl in let loop macro match mod move mut override priv pub ref return static struct trait \
    true try type typeof unsized use virtual where while yield unsafe";
/// Words that not even `r#` makes an identifier.
const PATHS: &str = "crate self super Self _";

/// Names of crates and of primitive types: a module by such a name would stand before them where the user names them.
const TAKEN: &str = "plm core std alloc proc_macro test bool char str f16 f32 f64 f128 i8 i16 i32 i64 i128 isize u8 u16 \
    u32 u64 u128 usize";

/// Types, traits and arguments of generics that emitted code names without a path: the mechanism's type has another name in
/// it where the user took one of these.
const IN_USE: &str = "Assembly Augmented BodyStart BodyState Default Err Fault Fn FnMut Held I Input K Method N NC NQ None \
    Ok Operations Option Real Result S Scalar Sim Some Start Starts State T Two";

/// The name by which emitted code has the mechanism's type: the user's, unless the code has another thing of that name.
pub(crate) fn free(name: &str) -> &str {
    if is_among(IN_USE, name) { "Mechanism_" } else { name }
}

/// An identifier as a token.
pub(crate) fn token(text: &str, span: proc_macro2::Span) -> proc_macro2::Ident {
    match text.strip_prefix("r#") {
        Some(word) => proc_macro2::Ident::new_raw(word, span),
        None => proc_macro2::Ident::new(text, span),
    }
}

/// The name of the mechanism as that of a type; one that cannot be has been reported.
pub(crate) fn type_name(name: &str) -> String {
    let is_name = !is_among(KEYWORDS, name) && !is_among(PATHS, name);
    if is_name { name.to_owned() } else { ident(name) }
}

/// Letters of a type: is there a capital, or none that could be one?
pub(crate) fn is_type_name(name: &str) -> bool {
    let has_case = name.chars().any(char::is_lowercase);
    !is_among(PATHS, name) && (name.chars().any(char::is_uppercase) || !has_case)
}

/// `double_pendulum` becomes `DoublePendulum`.
pub(crate) fn camel_case(name: &str) -> String {
    let word = |word: &str| {
        let mut letters = word.chars();
        let first = letters.next().map(char::to_uppercase);
        first.into_iter().flatten().chain(letters).collect::<String>()
    };
    name.split('_').map(word).collect()
}

/// A path of the language as an identifier: `bar[3].angle` becomes `bar_3_angle`.
pub(crate) fn ident(path: &str) -> String {
    raw(&plain(path))
}

/// A word that Rust has taken with `r#`, or with `_` where that does not help.
fn raw(text: &str) -> String {
    if is_among(KEYWORDS, text) {
        format!("r#{text}")
    } else if is_among(PATHS, text) {
        format!("{text}_")
    } else {
        text.to_owned()
    }
}

/// Letters, digits and `_`, with a letter or `_` in front.
fn plain(path: &str) -> String {
    let mut text = String::with_capacity(path.len());
    for character in path.chars() {
        if character.is_alphanumeric() || character == '_' {
            text.push(character);
        } else if !text.ends_with('_') && character != ']' {
            text.push('_');
        }
    }
    let text = text.trim_end_matches('_');
    if text.is_empty() || text.starts_with(|c: char| c.is_ascii_digit()) {
        format!("n{text}")
    } else {
        text.to_owned()
    }
}

/// The module of a mechanism: `DoublePendulum` becomes `double_pendulum`; digits stay with the word before them.
pub(crate) fn module_name(name: &str) -> String {
    let mut text = String::with_capacity(name.len() + 4);
    let mut previous = '_';
    for character in name.chars() {
        if character.is_uppercase() && previous != '_' && !previous.is_uppercase() {
            text.push('_');
        }
        text.extend(character.to_lowercase());
        previous = character;
    }
    let is_taken = [KEYWORDS, PATHS, TAKEN].iter().any(|words| is_among(words, &text));
    if is_taken || text == name { text + "_mechanism" } else { text }
}

/// Names of one scope, none twice.
#[derive(Clone, Default)]
pub(crate) struct Names {
    taken: SortedSet<String>,
    numbered: usize,
    /// The next number after a name that was taken.
    next: SortedMap<String, usize>,
}

impl Names {
    /// A scope in which some names are taken already.
    pub(crate) fn with_reserved(reserved: &[&str]) -> Names {
        Names {
            taken: reserved.iter().map(|&name| name.to_owned()).collect(),
            numbered: 0,
            next: SortedMap::new(),
        }
    }

    /// The identifier of a path, with a number after it if it is taken.
    pub(crate) fn unique(&mut self, path: &str) -> String {
        let base = plain(path).to_lowercase();
        let mut name = raw(&base);
        if self.taken.insert(name.clone()) {
            return name;
        }
        let number = self.next.or_insert(base.clone(), 2);
        loop {
            name = format!("{base}_{number}");
            *number += 1;
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
    }

    /// The identifier of a path, if nothing else has it.
    pub(crate) fn free(&mut self, path: &str) -> Option<String> {
        let name = raw(&plain(path).to_lowercase());
        self.taken.insert(name.clone()).then_some(name)
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
        assert_eq!(module_name("DoublePendulum"), "double_pendulum");
        assert_eq!(module_name("S5"), "s5");
        assert_eq!(module_name("FourBarABC"), "four_bar_abc");
        assert_eq!(module_name("Loop"), "loop_mechanism");
        assert_eq!(module_name("Plm"), "plm_mechanism");
        assert_eq!(module_name("日本"), "日本_mechanism");
    }

    #[test]
    fn types_have_capitals_where_letters_have_two_forms() {
        assert!(["Arm", "S5", "_Arm", "iRobot", "日本"].iter().all(|name| is_type_name(name)));
        assert!(!["arm", "f64", "r2_d2", "Self", "self"].iter().any(|name| is_type_name(name)));
        assert_eq!(camel_case("double_pendulum"), "DoublePendulum");
    }

    #[test]
    fn names_do_not_meet() {
        let mut names = Names::with_reserved(&["x"]);
        assert_eq!(names.unique("x"), "x_2");
        assert_eq!(names.unique("arm.x"), "arm_x");
        assert_eq!(names.unique("arm_x"), "arm_x_2");
        assert_eq!(names.unique("Type"), "r#type");
        assert_eq!(names.unique("type"), "type_2");
        assert_eq!(names.numbered("t"), "t1");
    }
}
