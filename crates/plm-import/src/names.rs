//! Names of the language for names of files.

use std::collections::BTreeSet;

use plm_compiler::words;

/// Keywords of Rust that no raw identifier can be.
const OF_RUST: [&str; 5] = ["self", "Self", "super", "crate", "_"];

/// Names of shapes and choices of the library, which would be read as those.
const CHOICES: [&str; 4] = ["plate", "round", "free_slide", "halfway_bushing"];

/// Numbers of a body beside its members, which no port can be called either.
const OF_BODIES: [&str; 3] = ["mass", "inertia", "centre"];

/// Names that are given once, whatever their case: code has some of them in small letters.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names(BTreeSet<String>);

impl Names {
    /// Names of ports.
    pub(crate) fn of_ports() -> Names {
        let members = [words::members_of_bodies(), words::members_of_frames(), OF_BODIES.to_vec()].concat();
        Names(members.into_iter().map(str::to_owned).collect())
    }

    /// A name that nothing else has, as near to `wanted` as it can be; `kind` is put after one that is taken.
    pub(crate) fn give(&mut self, wanted: &str, kind: &str) -> String {
        let plain = identifier(wanted);
        let is_free = |names: &BTreeSet<String>, name: &str| {
            let small = name.to_ascii_lowercase();
            !is_word(name) && !is_method(&small) && !names.contains(&small)
        };
        let mut name = plain.clone();
        if !is_free(&self.0, &name) {
            name = format!("{plain}_{kind}");
        }
        let mut number = 2;
        while !is_free(&self.0, &name) {
            name = format!("{plain}_{kind}_{number}");
            number += 1;
        }
        self.0.insert(name.to_ascii_lowercase());
        name
    }
}

/// Does the language have it for itself, or would it be read as a unit?
fn is_word(name: &str) -> bool {
    words::is_taken(name)
        || words::units().contains(&name)
        || OF_RUST.contains(&name)
        || CHOICES.contains(&name)
}

/// Is it a method of emitted states and runs, or `start` of a mechanism? No body can be called so, in whatever case.
fn is_method(small: &str) -> bool {
    small == "start" || words::methods().contains(&small)
}

/// The letters, digits and underscores of a name, which does not begin with a digit.
fn identifier(name: &str) -> String {
    let mut made: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if !made.starts_with(|c: char| c.is_ascii_alphabetic()) {
        made.insert_str(0, "n_");
    }
    made
}

/// The name of a mechanism, with capitals: `four_bar loop` is `FourBarLoop`.
pub(crate) fn mechanism(name: &str) -> String {
    let mut made = String::new();
    for word in name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()) {
        made.push_str(&word[..1].to_ascii_uppercase());
        made.push_str(&word[1..]);
    }
    let is_name = made.starts_with(|c: char| c.is_ascii_alphabetic()) && made != "Self";
    if is_name { made } else { format!("Model{made}") }
}
