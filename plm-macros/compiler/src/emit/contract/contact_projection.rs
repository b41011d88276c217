//! Projection of a mechanism with contact.

use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::{Emission, Sizes};
use super::{contact, system};
use crate::model::Stabilisation;

/// Projection on the constraints, then of the rows that hold.
pub(super) fn project(emission: &Emission) -> TokenStream {
    let (Sizes { length, .. }, rows) = (&emission.sizes, contact::count(emission));
    let is_projected = matches!(emission.model.stabilisation, Stabilisation::Projection);
    let baumgarte = (!is_projected).then(|| system::stabilisation(emission));
    quote! {
        fn project(&self, t: S, u: &Self::U, x: &mut [S; #length]) -> Result<(), Fault> {
            rt::contact::project::<Self, #rows>(self, t, u, x)
        }

        fn drift(&self, t: S, u: &Self::U, x: &[S; #length]) -> rt::Drift<S> {
            rt::contact::drift::<Self, #rows>(self, t, u, x)
        }
        #baumgarte
    }
}
