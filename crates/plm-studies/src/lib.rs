//! Work on mechanisms beyond one run, each kind behind a feature, with the dependencies that it alone needs:
//!
//! * `analysis`: equations near a state, as linear systems, and equilibria ([`analysis`]);
//! * `batch`: runs over many parameter values, on all cores ([`batch`]) and on many machines ([`study`]);
//! * `lanes`: eight simulations side by side in vector registers ([`lanes`]), and in `batch`;
//! * `optimise`: parameters and starts from measurements ([`optimise`]), with `optimal-control` also inputs of least cost;
//! * `synthesis`: dimensions from what a mechanism has to do ([`synthesis`]).
//!
//! `plm` has all of it, behind features of the same names; `optimise` has optimal control there.
#![cfg_attr(
    not(all(
        feature = "analysis",
        feature = "batch",
        feature = "lanes",
        feature = "optimise",
        feature = "synthesis"
    )),
    allow(rustdoc::broken_intra_doc_links, reason = "the list of features")
)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "analysis")]
pub mod analysis;
#[cfg(feature = "batch")]
pub mod batch;
#[cfg(feature = "lanes")]
pub mod lanes;
#[cfg(feature = "optimise")]
pub mod optimise;
#[cfg(feature = "batch")]
pub mod study;
#[cfg(feature = "synthesis")]
pub mod synthesis;
#[cfg(feature = "batch")]
mod together;
