//! The mechanism: parameters, constructors, the way into a run.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use proc_macro2::{Ident, TokenStream};

use super::super::lower::{Bindings, inline};
use super::super::{Emission, docs};
use super::start::declared_values;
use crate::model::Param;

/// The type itself; its name is the only one beside it that it must not meet.
pub(crate) fn definition(emission: &Emission) -> TokenStream {
    let Emission { model, fields, shown, .. } = emission;
    let scalar = if shown == "S" { quote!(T) } else { quote!(S) };
    let docs = match docs::trimmed(&model.docs) {
        own if own.is_empty() => "A mechanism with its parameters and start values.".to_owned(),
        own => own,
    };
    let docs = docs::docs(emission, &docs);
    let params = model.params.iter().zip(&fields.params).map(|(param, field)| {
        let default = if param.required {
            "; it has no default".to_owned()
        } else {
            docs::by_default(param.default, &param.unit)
        };
        let what = format!("Parameter `{}`", param.name.text);
        let docs = emission.text(docs::field(&param.docs, &what, &param.unit, &default));
        quote!(#docs pub #field: #scalar,)
    });
    quote! {
        #docs
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #shown<#scalar = ::core::primitive::f64> {
            #(#params)*
            /// Start values of the bodies, and which of them assembly keeps.
            pub start: super::code_::Starts<#scalar>,
        }
    }
}

/// The mechanism as declared.
pub(crate) fn constructors(emission: &Emission) -> TokenStream {
    let Emission { model, fields, name, shown, .. } = emission;
    let required: Vec<(&Param, &Ident)> =
        model.params.iter().zip(&fields.params).filter(|(param, _)| param.required).collect_vec();
    let taken: Vec<&Ident> = required.iter().map(|(_, field)| *field).collect_vec();
    let names = taken.iter().map(ToString::to_string).collect_vec().join(", ");
    let documented = |first: String| {
        let more = required.iter().map(|(param, field)| {
            let (own, unit) = (&param.name.text, docs::si(&param.unit));
            format!("\n\n`{field}`: parameter `{own}`, {unit}; it has no default.")
        });
        docs::docs(emission, &(first + &more.collect::<String>()))
    };
    let of_f64 = documented(format!(
        "The mechanism as declared, in `f64`; `{shown} {{ field: value, ..{shown}::new({names}) }}` changes some."
    ));
    let of_any = documented("The mechanism as declared, for any scalar.".to_owned());
    // As many as were declared without a default.
    let many = (required.len() > 7).then(|| quote!(#[allow(clippy::too_many_arguments)]));
    let default = required.is_empty().then(|| {
        quote! {
            impl Default for #name<f64> {
                fn default() -> Self {
                    Self::of()
                }
            }
        }
    });
    let declared = declared(emission);
    quote! {
        impl #name<f64> {
            #of_f64
            #many
            pub fn new(#(#taken: f64),*) -> Self {
                Self::of(#(#taken),*)
            }
        }
        #default
        impl<S: Scalar> #name<S> {
            #of_any
            #many
            pub fn of(#(#taken: S),*) -> Self {
                #declared
            }
        }
    }
}

/// Parameters in order, since a default may read earlier ones, then the starts.
fn declared(emission: &Emission) -> TokenStream {
    let Emission { model, fields, name, .. } = emission;
    let mut bindings = Bindings::new();
    let mut defaults = Vec::new();
    for (param, field) in model.params.iter().zip(&fields.params) {
        if !param.required {
            defaults.push(format!("let {field} = {};\n", inline(param.default, &bindings)));
        }
        bindings.insert(param.symbol, field.to_string());
    }
    let (defaults, starts) = (emission.text(defaults.concat()), declared_values(emission, &bindings));
    let params = &fields.params;
    quote! {
        let lit = S::lit;
        #defaults
        let start = #starts;
        #name { #(#params,)* start }
    }
}

/// Assembly, and runs.
pub(crate) fn runs(emission: &Emission) -> TokenStream {
    let name = &emission.name;
    let (check, carried) = (super::start::check(emission), super::start::carried(emission));
    let follows = super::start::reads_parameters(emission.model);
    let of = if follows { quote!(&self.following_()) } else { quote!(self) };
    quote! {
        impl<S: Real> #name<S> {
            /// Closes the joints from the start values, as the manual's assembly does (section 4.4).
            ///
            /// # Errors
            /// Redundant locks, or joints that stay open: the part and by how much; a parameter that cannot have its value.
            pub fn assemble(&self) -> Result<Assembly<S>, Fault> {
                let t = S::lit(0.0);
                #check
                let assembly = absolute::assemble(#of, t)?;
                #carried
                Ok(assembly)
            }

            /// Assembles, and gives a run by Dormand and Prince's method.
            ///
            /// # Errors
            /// As [`Self::assemble`].
            pub fn start(self) -> Result<Sim<Self>, Fault> {
                rt::Mechanism::start(self)
            }

            /// Assembles, and gives a run by a method of choice.
            ///
            /// # Errors
            /// As [`Self::assemble`].
            pub fn start_with<I: Method<Self>>(self, method: I) -> Result<Sim<Self, I>, Fault> {
                rt::Mechanism::start_with(self, method)
            }
        }
    }
}
