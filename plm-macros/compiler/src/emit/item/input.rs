//! Inputs, and what is held over a step beside them.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::contract::contact;
use super::super::lower::inline;
use super::super::{Emission, Sizes, docs, memory, number};

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

/// The type of what is held of loops.
pub(super) fn of_loops(emission: &Emission) -> TokenStream {
    let nq = &emission.sizes.nq;
    emission.loops().map_or(quote!(()), |reduced| {
        let memory = memory(reduced, &quote!(S));
        quote!(rt::charts::OfLoops<#memory, [S; #nq]>)
    })
}

/// The type of what is held of contact, after a comma, where there is contact.
pub(super) fn of_contact(emission: &Emission) -> Option<TokenStream> {
    let held = contact::held(emission);
    contact::are_there(emission).then(|| quote!(, #held))
}

/// `Held`.
pub(crate) fn held(emission: &Emission) -> TokenStream {
    let (of_loops, of_contact) = (of_loops(emission), of_contact(emission));
    let [switches, turns] = [emission.model.switches.len(), emission.model.turns.len()].map_each(number);
    let Sizes { nq, nc, .. } = &emission.sizes;
    quote! {
        /// Discrete state: constant during a step.
        type Held<S> = rt::Held<Input<S>, [S; #switches], [<S as Scalar>::Turns; #turns], #of_loops #of_contact>;

        /// Pose, accelerations and a vector, which outputs have in common.
        type Common<S> = rt::Common<([S; #nq], [S; #nq]), Held<S>, ([S; #nq], [S; #nc]), [S; 2]>;
    }
}

/// The inputs as declared.
pub(crate) fn declared(emission: &Emission) -> TokenStream {
    let Emission { model, fields, name, .. } = emission;
    let bindings = emission.parameters();
    let values = model.inputs.iter().zip(&fields.inputs);
    let values = values.map(|(input, field)| format!("{field}: {}", inline(input.default, &bindings)));
    let (literals, values) = emission.values(values.collect_vec());
    let none = model.inputs.is_empty().then(|| quote!(none: core::marker::PhantomData));
    quote! {
        impl<S: Scalar> #name<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> Input<S> {
                #literals
                Input { #values #none }
            }
        }
    }
}
