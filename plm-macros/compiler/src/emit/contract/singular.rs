//! `ExtendedPrecision`: how a mechanism goes on near singular poses, by its equations in absolute coordinates in numbers of twice the
//! precision.

use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::{Emission, Sizes};

/// The type that takes over from the method where no chart is regular.
pub(super) fn rescue(emission: &Emission) -> TokenStream {
    let Sizes { nq, nc, full, .. } = &emission.sizes;
    if emission.may_be_singular {
        quote!(rt::singular::NearSingular<Self, #nq, #nc, #full>)
    } else {
        quote!(rt::singular::Never<Self>)
    }
}

/// `ExtendedPrecision`, for mechanisms with singular poses.
pub(crate) fn extended(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { nq, nc, full, .. }, .. } = emission;
    if !emission.may_be_singular {
        return TokenStream::new();
    }
    let coordinates = if emission.loops().is_some() {
        quote!(rt::singular::InCharts)
    } else {
        quote!(rt::singular::InAbsolute)
    };
    // rustdoc shows a constant argument by its source, which is the whole declaration.
    quote! {
        #[doc(hidden)]
        impl<S: Real> rt::singular::ExtendedPrecision<#nq, #nc, #full> for #name<S> {
            type Extended = #name<rt::DoubleDouble<S>>;
            type Inputs = Held<rt::DoubleDouble<S>>;
            type Coordinates = #coordinates;

            fn extended(&self) -> Self::Extended {
                rt::lanes::Pack::pack(self, [self], |[s]: [S; 1]| rt::DoubleDouble::written(s))
            }
            fn extended_with_inputs(&self, held: &Self::U) -> (Self::Extended, Self::Inputs) {
                use rt::lanes::Pack;
                (self.extended(), Self::pack_held(held, [held], |[s]: [S; 1]| rt::DoubleDouble::of(s)))
            }
            #[cold]
            fn accelerate(
                extended: &Self::Extended,
                t: rt::DoubleDouble<S>,
                u: &Self::Inputs,
                x: &[rt::DoubleDouble<S>; #full],
                dx: &mut [rt::DoubleDouble<S>; #full],
            ) {
                let mut lambda = [rt::DoubleDouble::<S>::lit(0.0); #nc];
                extended.dynamics(t, u, x, dx, &mut lambda);
            }
        }
    }
}

/// The start next to a singular pose, for `Absolute`.
pub(crate) fn refine(emission: &Emission) -> Option<TokenStream> {
    let Sizes { nq, nc, full, .. } = &emission.sizes;
    emission.may_be_singular.then(|| {
        quote! {
            fn refine(&self, t: S, q: &[S; #nq]) -> Option<([S; #nq], [S; #nq])> {
                rt::singular::refine::<Self, #nq, #nc, #full>(self, t, q)
            }
        }
    })
}
