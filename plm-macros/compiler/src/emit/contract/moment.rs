//! `Moment` for the state, `Mechanism` for the mechanism.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::{Emission, Sizes};
use super::{limits, singular};

/// `Moment`.
pub(crate) fn moment(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let (is_charted, held_type) = (emission.loops().is_some(), emission.held(&quote!(S)));
    let inputs = emission.inputs_of_state();
    let held = if is_charted {
        quote!(rt::charts::Held { input: #inputs, chart: self.chart, memory: self.memory })
    } else {
        inputs
    };
    // What the state keeps of what is held, field by field.
    let mut kept = vec![(quote!(input), emission.input_of("held"))];
    if emission.has_switches() {
        let inputs = emission.inputs_of("held");
        kept.push((quote!(switches), quote!(#inputs.switches)));
    }
    if is_charted {
        kept.extend([(quote!(chart), quote!(held.chart)), (quote!(memory), quote!(held.memory))]);
    }
    let (fields, values): (Vec<TokenStream>, Vec<TokenStream>) = kept.into_iter().unzip();
    quote! {
        impl<S: Real> rt::Moment for State<S> {
            type M = #name<S>;

            fn new(mechanism: #name<S>, held: #held_type, time: S, x: [S; #length]) -> Self {
                State { mechanism, time, x, #(#fields: #values),* }
            }
            fn mechanism(&self) -> &#name<S> {
                &self.mechanism
            }
            fn held(&self) -> #held_type {
                #held
            }
            fn time(&self) -> S {
                self.time
            }
            fn x(&self) -> &[S; #length] {
                &self.x
            }
            fn set(&mut self, time: S, held: &#held_type, x: &[S; #length]) {
                let held = *held;
                self.time = time;
                #(self.#fields = #values;)*
                self.x = *x;
            }
        }
    }
}

/// `Mechanism`.
pub(crate) fn mechanism(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let (held, rescue) = (emission.held(&quote!(S)), singular::rescue(emission));
    let check = (!emission.model.params.is_empty()).then(|| limits::check(emission));
    let renew = limits::renew(emission);
    let opening = emission.is_reduced().then(|| {
        quote! {
            fn opening(&self, t: S, held: &#held, x: &[S; #length]) -> rt::Drift<S> {
                let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
            }
        }
    });
    quote! {
        impl<S: Real> rt::Mechanism for #name<S> {
            type State = State<S>;
            type Rescue = #rescue;
            const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();

            fn start_state(&self, t: S) -> Result<(#held, [S; #length]), Fault> {
                self.start_holding_(t, self.declared_input())
            }
            #check
            #renew
            #opening
        }
    }
}
