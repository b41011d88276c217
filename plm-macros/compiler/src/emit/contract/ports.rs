//! `Ports`: inputs and outputs in the order of the declaration.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::{Emission, docs, number};

/// `Ports`.
pub(crate) fn ports(emission: &Emission) -> TokenStream {
    let Emission { model, fields, name, .. } = emission;
    let names = model.inputs.iter();
    let names =
        emission.list(names.map(|input| format!("({:?}, {:?})", input.name.text, docs::si(&input.unit))));
    let (held, input) = (emission.held(&quote!(S)), emission.input_of("held"));
    let (numbers, inputs) = ((0..fields.inputs.len()).map(number), &fields.inputs);
    let input = if inputs.is_empty() {
        quote! {
            fn input(_held: &mut #held, _index: usize) -> Option<&mut S> {
                None
            }
        }
    } else {
        quote! {
            fn input(held: &mut #held, index: usize) -> Option<&mut S> {
                match index {
                    #(#numbers => Some(&mut #input.#inputs),)*
                    _ => None,
                }
            }
        }
    };
    quote! {
        impl<S: Real> rt::Ports for #name<S> {
            const INPUTS: &'static [(&'static str, &'static str)] = &[#names];
            const OUTPUTS: &'static [(&'static str, &'static str)] = &State::<S>::OUTPUTS;

            #input

            fn outputs(state: &State<S>, each: &mut impl FnMut(S)) {
                for output in state.outputs() {
                    each(output);
                }
            }
        }
    }
}
