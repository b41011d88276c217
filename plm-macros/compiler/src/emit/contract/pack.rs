//! `Pack`: every number of a mechanism and of what it holds, made of those of several. It is generic: nothing is compiled
//! where nobody asks for it.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::Emission;

/// `Pack`.
pub(crate) fn pack(emission: &Emission) -> TokenStream {
    let Emission { fields, name, .. } = emission;
    let [held, packed] = [quote!(S), quote!(T)].map(|scalar| emission.held(&scalar));
    let starts = fields.bodies.iter().chain(&fields.states);
    let starts =
        emission.lines(starts.map(|field| format!("{field}: self.start.{field}.map(|s| number([s; N]))")));
    let params = fields.params.iter();
    let params = emission.lines(params.map(|field| format!("{field}: number(all.map(|one| one.{field}))")));
    let (inputs, input) = (&fields.inputs, emission.input_of("held"));
    let none = inputs.is_empty().then(|| quote!(none: core::marker::PhantomData,));
    let of_held = emission.inputs_of("held");
    let switches = emission.has_switches().then(|| {
        quote! {
            let switches = core::array::from_fn(|k| number(all.map(|held| #of_held.switches[k])));
            let input = Held { input, switches };
        }
    });
    let is_charted = emission.loops().is_some();
    let first = if is_charted { quote!(first) } else { quote!(_) };
    let wrapped = if is_charted {
        quote! {
            let memory = core::array::from_fn(|k| number(all.map(|held| held.memory[k])));
            rt::charts::Held { input, chart: first.chart, memory }
        }
    } else {
        quote!(input)
    };
    let is_calm = if is_charted {
        quote! {
            fn is_calm(t: S, held: &#held, x: &Self::X) -> bool {
                rt::charts::is_calm::<Self>(t, held, x)
            }
        }
    } else {
        quote! {
            fn is_calm(_t: S, _held: &#held, _x: &Self::X) -> bool {
                true
            }
        }
    };
    let chart = is_charted.then(|| {
        quote! {
            fn chart(held: &Self::U) -> usize {
                held.chart
            }
        }
    });
    quote! {
        impl<S: Real> rt::lanes::Pack for #name<S> {
            type Packed<T: Scalar> = #name<T>;

            #[allow(unused_variables)] // where there are no parameters
            fn pack<T: Scalar, const N: usize>(&self, all: [&Self; N], number: impl Fn([S; N]) -> T) -> #name<T> {
                let start = Starts { #starts };
                #name { start, #params }
            }

            #[allow(unused_variables)] // where there are no inputs
            fn pack_held<T: Scalar, const N: usize>(
                #first: &#held, all: [&#held; N], number: impl Fn([S; N]) -> T
            ) -> #packed {
                let input = Input { #(#inputs: number(all.map(|held| #input.#inputs)),)* #none };
                #switches
                #wrapped
            }

            #[inline]
            #is_calm
            #chart
        }
    }
}
