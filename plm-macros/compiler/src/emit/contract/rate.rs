//! `Rate`: the right-hand side, for any scalar.

use crate::emit::template::quote;
use proc_macro2::TokenStream;
use quote::format_ident;

use super::super::function::is_straight;
use super::super::{Emission, Form, Sizes, number};
use super::charted::in_held;
use super::pairs;
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
    let [pair, parts] = pairs::pairs(emission);
    quote! {
        impl<S: Scalar> rt::lanes::Rate for #name<S> {
            type S = S;
            type X = [S; #length];
            type U = Held<S>;
            const NQ: usize = #freedom;

            #inlined
            fn rate(&self, t: S, u: &Self::U, x: &[S; #length], dx: &mut [S; #length]) -> rt::Health<S> {
                #rate
            }
            #pair
        }

        #parts
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
