//! `Moment` for the state, `Mechanism` for the mechanism.

use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::{Emission, Sizes};
use super::{limits, singular};

/// `Moment`.
pub(crate) fn moment(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let is_stepped = !emission.model.steps.is_empty();
    let none = is_stepped.then(|| quote!(, remainder: rt::step::Remainder::none()));
    let forget = is_stepped.then(|| quote!(self.remainder = rt::step::Remainder::none();));
    let rest = is_stepped.then(|| quote!(, ..));
    let stepped = is_stepped.then(|| {
        quote! {
            impl<S: Real> rt::step::Stepped for State<S> {
                #[inline]
                fn stepped(&mut self) -> (rt::InPlace<'_, #name<S>>, &mut rt::step::Remainder<S>) {
                    let Self { mechanism, held, time, x, remainder } = self;
                    (rt::InPlace { system: mechanism, held, time, x }, remainder)
                }
            }
        }
    });
    quote! {
        impl<S: Real> rt::Moment for State<S> {
            type M = #name<S>;

            fn new(mechanism: #name<S>, held: Held<S>, time: S, x: [S; #length]) -> Self {
                State { mechanism, held, time, x #none }
            }
            fn mechanism(&self) -> &#name<S> {
                &self.mechanism
            }
            fn held(&self) -> Held<S> {
                self.held
            }
            fn time(&self) -> S {
                self.time
            }
            fn x(&self) -> &[S; #length] {
                &self.x
            }
            fn set(&mut self, time: S, held: &Held<S>, x: &[S; #length]) {
                self.time = time;
                self.held = *held;
                self.x = *x;
                #forget
            }
            fn in_place(&mut self) -> rt::InPlace<'_, #name<S>> {
                #forget
                let Self { mechanism, held, time, x #rest } = self;
                rt::InPlace { system: mechanism, held, time, x }
            }
        }
        #stepped
    }
}

/// `Mechanism`.
pub(crate) fn mechanism(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let rescue = singular::rescue(emission);
    let check = (!emission.model.params.is_empty()).then(|| limits::check(emission));
    let renew = limits::renew(emission);
    let opening = emission.is_reduced().then(|| {
        quote! {
            fn opening(&self, t: S, held: &Held<S>, x: &[S; #length]) -> rt::Drift<S> {
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

            fn start_state(&self, t: S) -> Result<(Held<S>, [S; #length]), Fault> {
                self.start_holding_(t, self.declared_input())
            }
            #check
            #renew
            #opening
        }
    }
}
