//! Inputs, and what is held over a step beside them.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::lower::inline;
use super::super::{Emission, docs, number};

/// `Input`.
pub(crate) fn inputs(emission: &Emission) -> TokenStream {
    let Emission { model, fields, .. } = emission;
    let inputs = model.inputs.iter().zip(&fields.inputs).map(|(input, field)| {
        let default = docs::by_default(input.default, &input.unit);
        let what = format!("Input `{}`", input.name.text);
        let docs = emission.text(docs::field(&input.docs, &what, &input.unit, &default));
        quote!(#docs pub #field: S,)
    });
    let none =
        model.inputs.is_empty().then(|| quote!(#[doc(hidden)] pub none: core::marker::PhantomData<S>,));
    quote! {
        /// Inputs, held over a step, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Input<S = f64> {
            #(#inputs)*
            #none
        }
    }
}

/// `Held`, where there are conditions.
pub(crate) fn held(emission: &Emission) -> TokenStream {
    if !emission.has_switches() {
        return TokenStream::new();
    }
    let count = number(emission.model.switches.len());
    quote! {
        /// What is held over a step: the inputs, and on which side of each condition the mechanism is.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Held<S = f64> {
            /// The inputs.
            pub input: Input<S>,
            switches: [S; #count],
        }
    }
}

/// The inputs as declared.
pub(crate) fn declared(emission: &Emission) -> TokenStream {
    let Emission { model, fields, name, .. } = emission;
    let (inputs, bindings) = (emission.inputs(&quote!(S)), emission.parameters());
    let values = model.inputs.iter().zip(&fields.inputs);
    let values = values.map(|(input, field)| format!("{field}: {}", inline(input.default, &bindings)));
    let (literals, values) = emission.values(values.collect());
    let none = model.inputs.is_empty().then(|| quote!(none: core::marker::PhantomData));
    let mut value = quote!(Input { #values #none });
    if emission.has_switches() {
        let count = number(model.switches.len());
        value = quote!(Held { input: #value, switches: [S::lit(1.0); #count] });
    }
    quote! {
        impl<S: Scalar> #name<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> #inputs {
                #literals
                #value
            }
        }
    }
}
