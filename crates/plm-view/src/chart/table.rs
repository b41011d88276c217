//! The cases of `page/tests/ticks.json`, which hold the script of the page to the same rules.
#![allow(clippy::unwrap_used, reason = "tests")]

use serde::de::DeserializeOwned;
use serde_json::Value;

/// The cases of one section.
pub(super) fn cases<T: DeserializeOwned>(section: &str) -> Vec<T> {
    let table: Value = serde_json::from_str(include_str!("../../page/tests/ticks.json")).unwrap();
    let cases: Vec<T> = serde_json::from_value(table[section].clone()).unwrap();
    assert!(!cases.is_empty(), "{section}");
    cases
}
