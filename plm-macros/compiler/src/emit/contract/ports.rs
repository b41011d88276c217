//! `Ports`: inputs and outputs in the order of the declaration.

use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::{Emission, docs, number};

/// `Ports`.
pub(crate) fn ports(emission: &Emission) -> TokenStream {
    let Emission { model, fields, name, .. } = emission;
    let names = model.inputs.iter();
    let names =
        emission.list(names.map(|input| format!("({:?}, {:?})", input.name.text, docs::si(&input.unit))));
    let (numbers, inputs) = ((0..fields.inputs.len()).map(number), &fields.inputs);
    quote! {
        impl<S: Real> rt::Ports for #name<S> {
            type Input = Input<S>;
            const INPUTS: &'static [(&'static str, &'static str)] = &[#names];
            const OUTPUTS: &'static [(&'static str, &'static str)] = &State::<S>::OUTPUTS;

            fn inputs(held: &mut Held<S>) -> &mut Input<S> {
                &mut held.input
            }

            fn input(input: &mut Input<S>, index: usize) -> Option<&mut S> {
                match index {
                    #(#numbers => Some(&mut input.#inputs),)*
                    _ => None,
                }
            }

            fn outputs(state: &State<S>, each: &mut impl FnMut(S)) {
                for output in state.outputs() {
                    each(output);
                }
            }
        }
    }
}
