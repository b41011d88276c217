//! Many runs of a mechanism: over lists and grids of parameters on all cores ([`batch`]), and as studies in shards, processes that
//! run on one machine or on many ([`study`]).
//!
//! `plm::batch` and `plm::study` are these modules.

pub mod batch;
pub mod study;
