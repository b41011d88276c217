//! Scenes where methods were seen to fail, and what is measured on them; tests and program read the same numbers.

pub mod dead;
pub mod dyads;
pub mod flat;
pub mod indices;
pub mod loops;
pub mod near_singular;
pub mod pins;
pub mod run;
pub mod short_events;
pub mod standard;
pub mod stiff;
pub mod theory;
pub mod trees;
pub mod waiting;
