//! `Rate`: the right-hand side, for any scalar.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use proc_macro2::TokenStream;
use quote::format_ident;

use super::super::function::is_straight;
use super::super::{Emission, Form, Sizes, number};
use super::charted::in_held;
use super::{contact, contact_motion, pairs};
use crate::facts;
use crate::formulate::Reduced;

/// Operations up to which a rate is copied into every stage of a method: a dozen stages then stay in a processor's cache for
/// instructions.
const SHORT: usize = 300;

/// Is the rate copied into every stage?
pub(in super::super) fn is_short(emission: &Emission) -> bool {
    emission.report.rate.total() <= SHORT
}

/// How it is inlined.
pub(super) fn inlined(emission: &Emission) -> TokenStream {
    if is_short(emission) { quote!(#[inline(always)]) } else { quote!(#[inline]) }
}

/// `Rate`.
pub(crate) fn rate(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { nc, length, second_order, .. }, .. } = emission;
    let (inlined, freedom) = (inlined(emission), number(second_order / 2));
    let direct = is_straight(emission).then(|| quote!(::<false>));
    let rate = match emission.form {
        Form::Absolute => quote! {
            let mut lambda = [S::lit(0.0); #nc];
            rt::Health(self.dynamics(t, u, x, dx, &mut lambda))
        },
        Form::Tree(_) => quote! {
            self.motion #direct(t, u, x, dx);
            rt::Health::perfect()
        },
        Form::Loops(reduced) => in_chart(reduced, direct.as_ref()),
    };
    if contact::are_there(emission) {
        return with_contact(emission, &rate);
    }
    let [pair, parts] = pairs::pairs(emission);
    let short = is_short(emission).then(|| {
        quote!(
            const SHORT: bool = !S::REGISTERS.are_filled();
        )
    });
    let typical = typical(emission);
    quote! {
        impl<S: Scalar> rt::Rate for #name<S> {
            type S = S;
            type X = [S; #length];
            type U = Held<S>;
            const NQ: usize = #freedom;
            #short

            #inlined
            fn rate(&self, t: S, u: &Self::U, x: &[S; #length], dx: &mut [S; #length]) -> rt::Health<S> {
                #rate
            }
            #pair

            #[inline]
            fn typical(&self) -> [S; #length] {
                #typical.map(S::lit)
            }
        }

        #parts
    }
}

/// The rate with the contact forces of the modes that are held.
fn with_contact(emission: &Emission, rate: &TokenStream) -> TokenStream {
    let Emission { name, sizes: Sizes { length, second_order, .. }, .. } = emission;
    let (typical, freedom) = (typical(emission), number(second_order / 2));
    let with_forces = contact_motion::rate(emission);
    quote! {
        impl<S: Scalar> rt::Rate for #name<S> {
            type S = S;
            type X = [S; #length];
            type U = Held<S>;
            const NQ: usize = #freedom;

            fn rate(&self, t: S, u: &Self::U, x: &[S; #length], dx: &mut [S; #length]) -> rt::Health<S> {
                #with_forces
            }

            #[inline]
            fn typical(&self) -> [S; #length] {
                #typical.map(S::lit)
            }
        }

        impl<S: Scalar> #name<S> {
            /// The rate with the multipliers of contact that are held.
            #[inline]
            fn rate_holding_(&self, t: S, u: &Held<S>, x: &[S; #length], dx: &mut [S; #length]) -> rt::Health<S> {
                #rate
            }
        }
    }
}

/// The rate in the chart that is held; without one there is none.
fn in_chart(reduced: &Reduced, direct: Option<&TokenStream>) -> TokenStream {
    let rate = in_held(reduced, &quote!(u), &quote!(S::lit(0.0)), |k| {
        if k == 0 {
            return quote!(self.motion_0 #direct(t, u, m, x, dx));
        }
        // A copy goes through memory, so that the arrays of the first chart stay in registers.
        let motion = format_ident!("motion_{k}");
        quote!({
            let (at, mut out) = (*x, *dx);
            let measure = self.#motion(t, u, m, &at, &mut out);
            *dx = out;
            measure
        })
    });
    quote!(rt::Health(#rate))
}

/// Typical sizes of the numbers of the state.
fn typical(emission: &Emission) -> TokenStream {
    let Emission { equations, model, report, reduced, .. } = emission;
    let sizes = facts::state::typical(model, equations, *reduced, report.length);
    let sizes: Vec<String> = sizes.into_iter().map(|size| format!("{size:?}")).collect_vec();
    match sizes.as_slice() {
        [first, .., _] if sizes.iter().all(|size| size == first) => {
            let (first, count) = (emission.text(first), number(sizes.len()));
            quote!([#first; #count])
        }
        _ => {
            let sizes = emission.list(sizes);
            quote!([#sizes])
        }
    }
}
