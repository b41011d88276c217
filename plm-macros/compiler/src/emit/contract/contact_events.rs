//! `Events` and projection of a mechanism with contact: its guards stand behind those of its conditions, before the kinks.

use crate::emit::template::quote;
use proc_macro2::{Literal, TokenStream};

use super::super::{Emission, Sizes, number};
use super::{contact, sets, switches, system};
use crate::facts::contact as facts;
use crate::model::{Stabilisation, bounding_reactions};

/// Guards of the conditions, and of contact.
struct Counts {
    /// Of conditions.
    own: Literal,
    /// Of contact.
    contact: Literal,
    /// Places for rows of contact.
    rows: Literal,
}

impl Counts {
    fn of(emission: &Emission) -> Counts {
        let contact = number(Beside::guards_of(emission));
        Counts { own: number(emission.model.guards()), contact, rows: contact::count(emission) }
    }
}

/// `Events`.
pub(super) fn events(emission: &Emission) -> TokenStream {
    let Emission { model, name, .. } = emission;
    let all = number(model.guards() + Beside::guards_of(emission));
    let (watched, rows, length) = (watched(emission), contact::count(emission), &emission.sizes.length);
    let matters = (!model.decisions.roots.is_empty()).then(|| switches::matters(emission));
    let known_times = (model.switches.len() > model.guards()).then(|| switches::known_times(emission));
    let jump = (!model.jumps.is_empty()).then(|| switches::jump(emission));
    let switch = switches::switch(emission);
    let contacts = number(model.contacts.len());
    let in_plane = bounding_reactions(&model.contacts).iter().any(|reaction| reaction.components.len() > 1);
    let bends = in_plane.then(|| {
        quote!(
            const BENDS: bool = true;
        )
    });
    quote! {
        impl<S: Real> rt::Events for #name<S> {
            type G = [S; #all];
            const CONTACTS: usize = #contacts;
            #bends
            #watched
            #matters
            #switch
            #known_times
            #jump

            fn state_was_set(&self, t: S, u: &mut Self::U, x: &mut [S; #length]) -> Result<(), Fault> {
                rt::contact::state_was_set::<Self, #rows>(self, t, u, x)
            }

            fn contacts(u: &Self::U) -> rt::contact::Status<'_> {
                u.contact.status()
            }

            fn change_contact(u: &mut Self::U, change: rt::contact::Change) {
                u.contact.modes.change = change;
            }

            fn stride<const EVALUATIONS: usize>(
                &self,
                stride: &rt::contact::Stride<S>,
                u: &mut Self::U,
                x: &mut [S; #length],
                behind: impl FnOnce(&mut Self::U, &mut [S; #length], &rt::contact::Solution<S>) -> Result<(), Fault>,
            ) -> Result<rt::contact::Solution<S>, Fault> {
                rt::contact::step::<Self, #rows, EVALUATIONS>(self, stride, u, x, behind)
            }
        }
    }
}

/// Guards and kinks, at a time and over an interval.
fn watched(emission: &Emission) -> TokenStream {
    let (Sizes { length, .. }, Counts { rows, .. }) = (&emission.sizes, Counts::of(emission));
    if emission.model.watched() > 0 {
        return switches::watched(emission);
    }
    quote! {
        fn guards(&self, t: S, u: &Self::U, x: &[S; #length], g: &mut Self::G) {
            rt::contact::guards::<Self, #rows>(self, t, u, x, &mut |index, guard| g[index] = guard);
        }

        fn guards_within(
            &self,
            t: rt::Enclosed<S>,
            u: &Self::U,
            x: &impl Fn(usize) -> rt::Enclosed<S>,
            each: &mut impl FnMut(usize, rt::Enclosed<S>),
        ) -> bool {
            rt::contact::guards_within::<Self, #rows>(self, t, u, x, each)
        }

        fn stay(
            &self,
            u: &Self::U,
            places: [(S, &[S; #length]); 2],
            within: (rt::Enclosed<S>, &impl Fn(usize) -> rt::Enclosed<S>),
            end: &Self::G,
        ) -> bool {
            rt::contact::stay::<Self, #rows>(self, u, places, within, |index| end[index])
        }
    }
}

/// Parts of `Events` for contact, beside those of conditions; nothing without contact.
#[derive(Default)]
pub(super) struct Beside {
    /// Of the guards in `all`, only those of conditions are handed over.
    pub(super) take: TokenStream,
    /// Guards of contact, behind those.
    pub(super) guards: TokenStream,
    /// The index of a condition or kink among all guards.
    pub(super) index: TokenStream,
    /// Guards of contact over an interval.
    pub(super) within: TokenStream,
    /// Which rows exist, before the sides of conditions change, and a look at those that do not behind that.
    pub(super) appearance: [TokenStream; 2],
    /// The signature of the event of a guard.
    pub(super) head: TokenStream,
    /// The next modes, after the event of the guard `index`.
    pub(super) switch: TokenStream,
    /// The next modes, after an event of the time.
    pub(super) switch_at_time: TokenStream,
    /// The index among conditions and kinks; guards of contact always matter.
    pub(super) matters: TokenStream,
}

impl Beside {
    /// Guards of contact.
    pub(super) fn guards_of(emission: &Emission) -> usize {
        facts::guards(emission.model)
    }

    pub(super) fn new(emission: &Emission) -> Beside {
        let length = &emission.sizes.length;
        if !contact::are_there(emission) {
            let [t, x] =
                if sets::are_there(emission) { [quote!(t), quote!(x)] } else { [quote!(_t), quote!(_x)] };
            let head = quote! {
                fn switch(
                    &self, #t: S, u: &mut Self::U, #x: &mut [S; #length], index: usize
                ) -> Result<(), Fault>
            };
            let (index, within, switch) = (quote!(index), quote!(true), quote!(Ok(())));
            return Beside { index, within, head, switch, ..Beside::default() };
        }
        let Counts { own, contact, rows } = Counts::of(emission);
        Beside {
            take: quote!(.take(#own)),
            guards: quote! {
                rt::contact::guards::<Self, #rows>(
                    self, t, u, x, &mut |index, guard| out[#own + index] = guard
                );
            },
            index: quote!(if index < #own { index } else { index + #contact }),
            within: quote! {
                rt::contact::guards_within::<Self, #rows>(
                    self, t, u, x, &mut |index, guard| each(#own + index, guard)
                )
            },
            head: quote! {
                fn switch(
                    &self, t: S, u: &mut Self::U, x: &mut [S; #length], index: usize
                ) -> Result<(), Fault> {
                    self.switch_behind(t, u, x, (index, S::lit(0.0)))
                }

                fn switch_behind(
                    &self, t: S, u: &mut Self::U, x: &mut [S; #length], (index, step): (usize, S)
                ) -> Result<(), Fault>
            },
            appearance: appearance(emission),
            switch: switch(emission),
            switch_at_time: quote!(rt::contact::update::<Self, #rows>(self, t, u, x)?;),
            matters: quote! {
                if (#own..#own + #contact).contains(&index) {
                    return true;
                }
                let index = if index < #own { index } else { index - #contact };
            },
        }
    }
}

fn appearance(emission: &Emission) -> [TokenStream; 2] {
    if !facts::some_may_not_exist(emission.model) {
        return Default::default();
    }
    let Counts { rows, .. } = Counts::of(emission);
    let exist = quote! {
        let existed: [bool; #rows] =
            core::array::from_fn(|row| rt::contact::Contacts::<#rows>::exists(self, u, row));
    };
    [exist, quote!(rt::contact::appear::<Self, #rows>(self, t, (u, x), existed)?;)]
}

/// The next modes after the event of a guard; those of a condition change forces alone.
fn switch(emission: &Emission) -> TokenStream {
    let Counts { own, rows, .. } = Counts::of(emission);
    if emission.model.guards() == 0 {
        return quote!(rt::contact::switch_behind::<Self, #rows>(self, t, u, x, (index, step)).map(|_| ()));
    }
    quote! {
        let _ = match index.checked_sub(#own) {
            Some(index) => rt::contact::switch_behind::<Self, #rows>(self, t, u, x, (index, step)),
            None => rt::contact::update_behind::<Self, #rows>(self, t, u, x, step),
        }?;
        Ok(())
    }
}

/// Projection on the constraints, then of the rows that hold.
pub(super) fn project(emission: &Emission) -> TokenStream {
    let (Sizes { length, .. }, Counts { rows, .. }) = (&emission.sizes, Counts::of(emission));
    let is_projected = matches!(emission.model.stabilisation, Stabilisation::Projection);
    let baumgarte = (!is_projected).then(|| system::stabilisation(emission));
    quote! {
        fn project(&self, t: S, u: &Self::U, x: &mut [S; #length]) -> Result<(), Fault> {
            rt::contact::project::<Self, #rows>(self, t, u, x)
        }

        fn drift(&self, t: S, u: &Self::U, x: &[S; #length]) -> rt::Drift<S> {
            rt::contact::drift::<Self, #rows>(self, t, u, x)
        }
        #baumgarte
    }
}
