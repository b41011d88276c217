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
    let between = if emission.loops().is_some() { charted(emission) } else { alone() };
    // rustdoc shows a constant argument by its source, which is the whole declaration.
    quote! {
        #[doc(hidden)]
        impl<S: Real> rt::singular::ExtendedPrecision<#nq, #nc, #full> for #name<S> {
            type Extended = #name<rt::DoubleDouble<S>>;
            type Inputs = Held<rt::DoubleDouble<S>>;

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
            #between
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

/// Implementation of `ExtendedPrecision` for a mechanism that is in absolute coordinates anyway.
fn alone() -> TokenStream {
    quote! {
        #[inline]
        fn is_charted(&self) -> bool {
            false
        }
        fn crossed(_step: &rt::Step<'_, Self>) -> S {
            S::lit(0.0)
        }
        fn is_near(_held: &Self::U) -> bool {
            false
        }
        fn full(&self, _t: S, _held: &Self::U, x: &Self::X) -> Self::X {
            *x
        }
        fn hold(&self, _held: &mut Self::U, x: &mut Self::X, full: &Self::X) {
            *x = *full;
        }
        fn flat_part(&self, t: S, full: &Self::X) -> &'static str {
            absolute::flat_part::<_, _, NQ, NC>(self, t, &absolute::split(full).0)
        }
    }
}

/// Implementation of `Fine` for a mechanism with charts.
fn charted(emission: &Emission) -> TokenStream {
    let Sizes { nq, full, .. } = &emission.sizes;
    quote! {
        #[inline]
        fn is_charted(&self) -> bool {
            true
        }
        #[inline]
        fn crossed(step: &rt::Step<'_, Self>) -> S {
            rt::charts::crossed(step)
        }
        fn is_near(held: &Self::U) -> bool {
            rt::charts::is_free::<Self>(held)
        }
        fn full(&self, t: S, held: &Self::U, x: &Self::X) -> [S; #full] {
            rt::charts::full(self, t, held, x)
        }
        fn hold(&self, held: &mut Self::U, x: &mut Self::X, full: &[S; #full]) {
            rt::charts::hold::<Self, #full>(held, x, full);
        }
        fn flat_part(&self, t: S, full: &[S; #full]) -> &'static str {
            let (q, v): ([S; #nq], [S; #nq]) = absolute::split(full);
            rt::charts::flat_part(self, t, &q, &v)
        }
    }
}
