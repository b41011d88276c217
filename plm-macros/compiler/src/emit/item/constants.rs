//! Sizes as constants, and the files that are read.

use crate::emit::template::quote;
use proc_macro2::{Literal, TokenStream};

use super::super::{Emission, Sizes, docs};

/// `NQ`, `NC`, `NX`, `NDOF` and `OPERATIONS`.
pub(crate) fn sizes(emission: &Emission) -> TokenStream {
    let Emission { report, sizes: Sizes { nq, nc, nx, .. }, .. } = emission;
    let freedom = Literal::isize_unsuffixed(report.freedom);
    let operations = emission.text(docs::operations(&report.rate));
    quote! {
        /// Coordinates: (x, y, theta) of each body.
        pub const NQ: usize = #nq;
        /// Constraint rows.
        pub const NC: usize = #nc;
        /// First-order states.
        pub const NX: usize = #nx;
        /// Degrees of freedom, `3 N - M`.
        pub const NDOF: isize = #freedom;
        /// Operations of one evaluation of the right-hand side.
        pub const OPERATIONS: Operations = #operations;
    }
}

/// The files that the declaration names: they are read while it is expanded, and rustc is told that they matter.
pub(crate) fn files(emission: &Emission) -> TokenStream {
    let files = &emission.model.files;
    quote! {
        #(const _: &[u8] = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/", #files));)*
    }
}
