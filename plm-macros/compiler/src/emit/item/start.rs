//! Start values: as they are declared, at a moment, and as they are assembled.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::contract::limits;
use super::super::lower::{Bindings, inline};
use super::super::{Emission, Form, Sizes, docs, number};
use crate::model::{Body, Start, State};

/// `Starts`, and what assembly finds for them.
pub(crate) fn values(emission: &Emission) -> TokenStream {
    let Emission { model, fields, .. } = emission;
    let bodies = model.bodies.iter().zip(&fields.bodies).map(|(body, field)| {
        let docs = docs::docs(emission, &format!("Origin of body `{}`.", body.name.text));
        quote!(#docs pub #field: BodyStart<S>,)
    });
    let states = model.states.iter().zip(&fields.states).map(|(state, field)| {
        let docs = emission.text(docs::field(&[], &format!("State `{}`", state.name.text), &state.unit, ""));
        quote!(#docs pub #field: Start<S>,)
    });
    quote! {
        /// Start values, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Starts<S = f64> {
            #(#bodies)*
            #(#states)*
        }

        /// What assembly found.
        pub type Assembly<S = f64> = rt::Assembly<S, NQ, NC>;
    }
}

/// The declared start of a body.
pub(super) fn body_start(body: &Body, bindings: &Bindings) -> String {
    let names = ["x", "y", "angle", "vx", "vy", "omega"];
    let starts = body.start.iter().chain(&body.start_velocity);
    let entry = |(name, start): (&str, &Start)| {
        let kind = if start.locked { "locked" } else { "free" };
        format!("{name}: Start::{kind}({})", inline(start.value, bindings))
    };
    let entries: Vec<String> = names.into_iter().zip(starts).map(entry).collect_vec();
    format!("BodyStart {{ {} }}", entries.join(", "))
}

/// Start values as declared, with the parameters as they are; nothing where none of them reads a parameter.
pub(crate) fn declared(emission: &Emission) -> Option<TokenStream> {
    let Emission { model, fields, .. } = emission;
    let bindings = emission.parameters();
    let bodies = model.bodies.iter().zip(&fields.bodies);
    let bodies = bodies.map(|(body, field)| format!("{field}: {}", body_start(body, &bindings)));
    let states = model.states.iter().zip(&fields.states);
    let states = states.map(|(state, field)| format!("{field}: {}", state_start(state, &bindings)));
    let entries: Vec<String> = bodies.chain(states).collect_vec();
    let reads_parameters = entries.iter().any(|entry| entry.contains("self."));
    reads_parameters.then(|| {
        let (literals, starts) = emission.values(entries);
        quote! {
            fn declared_starts(&self) -> Starts<S> {
                #literals
                Starts { #starts }
            }
        }
    })
}

/// The declared start of a first-order state.
pub(super) fn state_start(state: &State, bindings: &Bindings) -> String {
    let kind = if state.locked { "locked" } else { "free" };
    format!("Start::{kind}({})", inline(state.start, bindings))
}

/// Start values of a state in absolute coordinates, and of a moment.
pub(crate) fn placed(emission: &Emission) -> TokenStream {
    let Emission { model, fields, name, sizes: Sizes { full, .. }, .. } = emission;
    let (bindings, nq) = (emission.parameters(), emission.equations.q.len());
    let bodies = model.bodies.iter().zip(&fields.bodies).enumerate().map(|(k, (body, field))| {
        let [x, y] = body.centre.components().map(|component| inline(component, &bindings));
        let [q, v] =
            [3 * k, nq + 3 * k].map(|first| format!("[x[{first}], x[{}], x[{}]]", first + 1, first + 2));
        format!("{field}: self.start.{field}.with_centre_at([{x}, {y}], {q}, {v})")
    });
    let states = fields.states.iter().zip(2 * nq..);
    let states = states.map(|(field, k)| format!("{field}: Start {{ value: x[{k}], ..self.start.{field} }}"));
    let (literals, starts) = emission.values(bodies.chain(states).collect_vec());
    quote! {
        impl<S: Real> #name<S> {
            fn placed(&self, x: &[S; #full]) -> Starts<S> {
                #literals
                Starts { #starts }
            }
        }

        impl<S: Real> State<S> {
            /// Poses, velocities and states of this moment as start values, with the locks that are set: to go on from here
            /// later, `mechanism.start = sim.starts()`.
            pub fn starts(&self) -> Starts<S> {
                self.mechanism.placed(&<#name<S> as rt::Statics>::full(self))
            }
        }
    }
}

/// A look at the parameters, where there are any.
pub(super) fn check(emission: &Emission) -> Option<TokenStream> {
    (!emission.model.params.is_empty()).then(|| quote!(rt::Mechanism::check(self, t)?;))
}

/// After assembly: bodies without mass must be carried, where parameters can make some.
pub(super) fn carried(emission: &Emission) -> Option<TokenStream> {
    let bodies = limits::that_may_be_carried(emission)?;
    let count = number(bodies.len());
    let bodies = emission.lines(bodies);
    Some(quote! {
        const BODIES: [[rt::Limit; 2]; #count] = [#bodies];
        absolute::check_carried::<S, Self, NQ, NC>(self, t, &assembly.q, &BODIES)?;
    })
}

/// The assembled state with inputs.
pub(crate) fn assembled(emission: &Emission) -> TokenStream {
    let Emission { fields, name, sizes: Sizes { length, second_order, .. }, .. } = emission;
    let (check, carried) = (check(emission), carried(emission));
    let states = &fields.states;
    let numbers = (*second_order..).take(states.len()).map(number);
    let begin = begin(emission);
    quote! {
        impl<S: Real> #name<S> {
            fn start_holding_(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; #length]), Fault> {
                #check
                let assembly = absolute::assemble(self, t)?;
                #carried
                let mut x = [S::lit(0.0); #length];
                #(x[#numbers] = self.start.#states.value;)*
                #begin
                Ok((held, x))
            }
        }
    }
}

/// From the assembled pose to the state, and the sides of conditions that apply there.
fn begin(emission: &Emission) -> TokenStream {
    let model = emission.model;
    let pass = (!model.switches.is_empty()).then(|| quote!(rt::System::pass(self, t, &mut held);));
    let switch = (model.guards() > 0).then(|| quote!(rt::events::switch_where_due(self, t, &mut held, &x);));
    let (mut of_loops, mut repeats) = (quote!(()), None);
    let enter = match emission.form {
        Form::Loops(reduced) => {
            of_loops = quote! {
                rt::charts::OfLoops::InChart { chart: 0, memory: rt::charts::Remembered::nothing() }
            };
            // Charts count on all rows: where some repeat others they would leave out a freedom.
            repeats = (!reduced.is_redundant()).then(|| {
                quote! {
                    if assembly.redundant.contains(&true) {
                        let joints = rt::Names::marked(
                            &<Self as absolute::Absolute<S, NQ, NC>>::PARTS, &assembly.redundant
                        );
                        return Err(Fault::new(rt::Scalar::to_f64(t), rt::Cause::Repeats { joints }));
                    }
                }
            });
            quote!(rt::charts::enter(self, t, &mut held, (&assembly.q, &assembly.v), &mut x);)
        }
        Form::Tree(_) => quote!(self.project(t, &assembly.q, &assembly.v, &mut x);),
        Form::Absolute => quote!(absolute::join(&assembly.q, &assembly.v, &mut x);),
    };
    let [count, turns] = [model.switches.len(), model.turns.len()].map(number);
    quote! {
        #repeats
        let mut held = rt::Held { input, switches: [S::lit(1.0); #count], turns: [0; #turns], of_loops: #of_loops };
        #enter
        #pass
        #switch
    }
}
