//! Mechanisms for Python: `run` is what a package of Python has of a mechanism, `wheel` writes the package.
//!
//! `plm::python` is the first, where `plm` has the features `foreign` and `analysis`, and `plm::view::wheel` the second.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![cfg_attr(not(any(feature = "run", feature = "wheel")), no_std)]

#[cfg(feature = "run")]
pub mod run;
#[cfg(feature = "wheel")]
pub mod wheel;
