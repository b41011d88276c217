//! Sides of conditions where a run begins.

use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::contract::{contact, sets};
use super::super::{Emission, number};

/// Takes the sides of all conditions of the state, where no event sets states.
pub(super) fn take_sides(emission: &Emission, held: &TokenStream) -> TokenStream {
    let guards = number(emission.model.guards());
    quote! {
        rt::events::take_sides(self, t, #held, &x, (#guards, |u: &mut Held<S>| &mut u.switches[..]));
    }
}

/// Sets what is set as a run begins, and takes the sides of conditions that apply there. Events that follow conditions do not happen.
pub(super) fn sides(emission: &Emission) -> TokenStream {
    let model = emission.model;
    let start = sets::are_at_start(emission).then(|| quote!(self.set_at_start_(t, &mut held, &mut x)?;));
    let [of_time, of_state] = [model.switches.len() > model.guards(), model.guards() > 0];
    let at_time = || of_time.then(|| quote!(rt::switched::take_sides_at_time(self, t, u);));
    let sides = if sets::are_there(emission) {
        let (count, at_time) = (sets::count(emission), at_time());
        quote! {
            let u = &mut held;
            #at_time
            rt::events::begin::<Self, #count>(self, t, u, &x);
        }
    } else if contact::are_there(emission) {
        // Contacts have their modes when all conditions have their sides, which gaps may read, and all constraints that hold are closed.
        let (at_time, taken) = (at_time(), of_state.then(|| take_sides(emission, &quote!(u))));
        let any = (!model.switches.is_empty()).then(|| quote!(let u = &mut held;));
        quote! {
            #any
            #at_time
            #taken
        }
    } else {
        let pass = (!model.switches.is_empty())
            .then(|| quote!(rt::Events::switch_at_time(self, t, &mut held, &mut x)?;));
        let switch = of_state.then(|| quote!(rt::events::switch_where_due(self, t, &mut held, &mut x)?;));
        quote! {
            #pass
            #switch
        }
    };
    quote! {
        #start
        #sides
    }
}
