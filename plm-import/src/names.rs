//! Names of the language for names of files.

use std::collections::BTreeSet;

/// Names that the language has for itself: units and words.
const TAKEN: &[&str] = &[
    "m",
    "mm",
    "cm",
    "km",
    "um",
    "L",
    "kg",
    "gram",
    "tonne",
    "s",
    "ms",
    "min",
    "h",
    "Hz",
    "rad",
    "deg",
    "degree",
    "rev",
    "N",
    "kN",
    "J",
    "W",
    "kW",
    "Pa",
    "kPa",
    "MPa",
    "GPa",
    "bar",
    "cP",
    "K",
    "ampere",
    "volt",
    "ohm",
    "henry",
    "t",
    "pi",
    "gravity",
    "ground",
    "if",
    "then",
    "else",
    "and",
    "or",
    "not",
    "in",
    "for",
    "self",
    "Self",
    "super",
    "crate",
    "_",
    "plate",
    "round",
    "free_slide",
    "halfway_bushing",
];

/// Methods of emitted states and runs (`METHODS` of the compiler), which no body can be called, in whatever case.
const METHODS: &[&str] = &[
    "time",
    "kinetic_energy",
    "gravity_energy",
    "load_power",
    "outputs",
    "undetermined",
    "branches",
    "starts",
    "find",
    "observed",
    "step",
    "step_to",
    "step_rk4",
    "step_semi_implicit_euler",
    "step_linearly_implicit",
    "at",
    "reset",
    "run",
    "project",
    "drift",
    "state",
    "method",
    "method_mut",
    "stats",
    "notice",
    "stop_at_change_points",
    "watch_energy",
    "count_states",
    "state_count",
    "save",
    "resume",
    "clone",
    "clone_from",
    "into",
    "try_into",
    "to_owned",
    "start",
];

/// Members of a body, which no port can be called.
const MEMBERS: &[&str] = &[
    "x",
    "y",
    "position",
    "angle",
    "axis",
    "normal",
    "velocity",
    "omega",
    "acceleration",
    "alpha",
    "vx",
    "vy",
    "ax",
    "ay",
    "body",
    "mass",
    "inertia",
    "centre",
];

/// Names that are given once, whatever their case: code has some of them in small letters.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names(BTreeSet<String>);

impl Names {
    /// Names of ports.
    pub(crate) fn of_ports() -> Names {
        Names(MEMBERS.iter().map(|&name| name.to_owned()).collect())
    }

    /// A name that nothing else has, as near to `wanted` as it can be; `kind` is put behind one that is taken.
    pub(crate) fn give(&mut self, wanted: &str, kind: &str) -> String {
        let plain = identifier(wanted);
        let is_free = |names: &BTreeSet<String>, name: &str| {
            let small = name.to_ascii_lowercase();
            !TAKEN.contains(&name) && !METHODS.contains(&small.as_str()) && !names.contains(&small)
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
