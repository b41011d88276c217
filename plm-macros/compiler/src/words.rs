//! The words of the language, from the tables that the passes read: for highlighters and for short descriptions.

use crate::collect::CollectVec;
use crate::emit::METHODS;
use crate::library::{DOMAINS, PARTS};
use crate::model::{Formulation, Impacts, Repetitions, Step};
use crate::resolve::{FUNCTIONS, Member, Owner, RESERVED};
use crate::sorted::SortedSet;
use crate::syntax::{BODY_WORDS, INNER_WORDS, item_words};
use crate::units::{self, MAY_BE_NAMES, is_unit};

/// Words that begin an item of a mechanism or of a part.
pub fn items() -> Vec<&'static str> {
    item_words()
}

/// Words that begin an item of a body.
pub fn of_bodies() -> Vec<&'static str> {
    BODY_WORDS.to_vec()
}

/// Words that stand inside of items and expressions: `locked`, `from`, `if`.
pub fn inner() -> Vec<&'static str> {
    let items = items();
    let all = INNER_WORDS.iter().chain(RESERVED).filter(|word| !items.contains(word));
    let words: SortedSet<&'static str> = all.copied().filter(|word| !constants().contains(word)).collect();
    words.into_iter().collect_vec()
}

/// May nothing be called so? A word of the language, or the name of a unit.
pub fn is_taken(name: &str) -> bool {
    RESERVED.contains(&name) || is_unit(name) && !MAY_BE_NAMES.contains(&name)
}

/// Methods of an emitted state and of its runs, which no body and no output can be called.
pub fn methods() -> &'static [&'static str] {
    METHODS
}

/// Names that always have a value.
pub fn constants() -> [&'static str; 2] {
    ["t", "pi"]
}

/// Options of the items that set something for the whole mechanism.
pub fn options() -> Vec<&'static str> {
    let formulations = Formulation::NAMES.iter().map(|(name, _)| *name);
    let repetitions = Repetitions::NAMES.iter().map(|(name, _)| *name);
    let steps = Step::NAMES.iter().map(|(name, _)| *name);
    let impacts = Impacts::NAMES.iter().map(|(name, _)| *name);
    formulations.chain(repetitions).chain(steps).chain(impacts).collect_vec()
}

/// Names of the functions, in the order of their table.
pub fn functions() -> Vec<&'static str> {
    FUNCTIONS.iter().map(|function| function.name).collect_vec()
}

/// Members of a body: `arm.angle`.
pub fn members_of_bodies() -> Vec<&'static str> {
    Member::names(Owner::Body)
}

/// Members of a port or of another frame: `arm.tip.velocity`.
pub fn members_of_frames() -> Vec<&'static str> {
    Member::names(Owner::Frame)
}

/// Names of the units, in the order of their table.
pub fn units() -> Vec<&'static str> {
    units::names().collect_vec()
}

/// Names of the parts of the library, with the files that define them.
pub fn parts() -> &'static [(&'static str, &'static str)] {
    PARTS
}

/// Names of the domains of the library, with the files that define them.
pub fn domains() -> &'static [(&'static str, &'static str)] {
    DOMAINS
}
