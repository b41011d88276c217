//! Names of tolerances, and changes of their factors, for sweeps that show their effect on results.

use super::factor::Factor;
use super::{charts, closing, contact, drift, events, singular};

fn of(files: &'static [&'static [fn() -> &'static Factor]]) -> impl Iterator<Item = &'static Factor> {
    files.iter().copied().flatten().map(|factor| factor())
}

fn of_poses() -> impl Iterator<Item = &'static Factor> {
    of(&[charts::FACTORS, singular::FACTORS, closing::FACTORS])
}

fn all() -> impl Iterator<Item = &'static Factor> {
    of_poses().chain(of(&[drift::FACTORS, contact::FACTORS, events::FACTORS]))
}

/// The names of all tolerances.
pub fn names() -> impl Iterator<Item = &'static str> {
    all().map(|factor| factor.name)
}

/// The names of the tolerances of charts, of the near-singular method and of closed joints, which every linkage has.
pub fn names_of_poses() -> impl Iterator<Item = &'static str> {
    of_poses().map(|factor| factor.name)
}

/// Multiplies a tolerance by a factor, in all runs of the process. Returns false if no tolerance has that
/// name.
pub fn set_factor(name: &str, factor: f64) -> bool {
    let found = all().find(|of| of.name == name);
    if let Some(of) = found {
        of.set(factor);
    }
    found.is_some()
}
