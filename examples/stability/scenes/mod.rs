//! Scenes where methods were seen to fail, and what is measured on them; tests and example read the same numbers.

pub mod dead;
#[path = "../../../tests/support/standard.rs"]
#[allow(unused_imports, reason = "the tests use more of it")]
pub mod declared;
pub mod dyads;
pub mod flat;
pub mod indices;
pub mod loops;
pub mod near_singular;
pub mod pins;
pub mod run;
pub mod short_events;
pub mod stiff;
pub mod theory;
pub mod trees;
pub mod waiting;
