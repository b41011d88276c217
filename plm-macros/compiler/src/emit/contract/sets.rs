//! `Sets`: events that set states; and what is set as a run begins.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use proc_macro2::{Literal, TokenStream};
use quote::format_ident;

use super::super::bindings::Origin;
use super::super::function::function;
use super::super::{Emission, Sizes, number};
use super::contact;
use super::limits::into_state;
use crate::facts::contact as facts;
use crate::formulate::Function;
use crate::model::{Target, When};

/// Those that follow conditions.
fn conditional<'m>(emission: &Emission<'m>) -> &'m [When] {
    When::parted(&emission.model.whens).0
}

/// Those that happen as a run begins.
fn at_start<'m>(emission: &Emission<'m>) -> &'m [When] {
    When::parted(&emission.model.whens).1
}

/// Does any event that follows a condition set states?
pub(in super::super) fn are_there(emission: &Emission) -> bool {
    !conditional(emission).is_empty()
}

/// Does any event happen as a run begins?
pub(in super::super) fn are_at_start(emission: &Emission) -> bool {
    !at_start(emission).is_empty()
}

/// Number of the events that follow conditions.
pub(in super::super) fn count(emission: &Emission) -> Literal {
    number(conditional(emission).len())
}

/// The values that are set as a run begins, and `Sets`; nothing where no event sets anything.
pub(crate) fn sets(emission: &Emission) -> TokenStream {
    let start = set_at_start(emission);
    let conditional = are_there(emission).then(|| conditional_sets(emission));
    quote! {
        #start
        #conditional
    }
}

/// `Sets`.
fn conditional_sets(emission: &Emission) -> TokenStream {
    let Emission { name, model, program, sizes: Sizes { length, .. }, .. } = emission;
    let (count, conditions) = (count(emission), number(model.guards()));
    let (events, settle) = (events(emission), settle(emission));
    let holds = function(
        emission,
        "Does the condition of each event hold? 1, or 0.",
        &quote! {
            #[cold]
            fn events_hold(&self, u: &Held<S>, holds: &mut [S; #count])
        },
        (&program.events, Origin::Arguments),
    );
    let values = values(emission, "values_set", (conditional(emission), &program.values_set));
    quote! {
        impl<S: Scalar> #name<S> { #holds }
        #values

        impl<S: Real> rt::events::Sets<#count> for #name<S> {
            const CONDITIONS: usize = #conditions;

            fn sides(u: &mut Held<S>) -> &mut [S] {
                &mut u.switches
            }

            fn holds(&self, u: &Held<S>) -> [bool; #count] {
                let mut holds = [S::lit(0.0); #count];
                self.events_hold(u, &mut holds);
                holds.map(|holds| holds > S::lit(0.5))
            }

            fn set(&self, t: S, u: &mut Held<S>, x: &mut [S; #length], index: usize) -> Result<(), Fault> {
                let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
                let (q, v) = state.pose_();
                let set = state.values_set_(&q, &v);
                #events
            }
            #settle
        }
    }
}

/// Sets what events set as a run begins, each by the state that the one before has left.
fn set_at_start(emission: &Emission) -> Option<TokenStream> {
    let Emission { name, program, sizes: Sizes { length, .. }, .. } = emission;
    let whens = at_start(emission);
    let values = values(emission, "values_at_start", (whens, &program.values_at_start));
    let events = numbered(whens).map(|(when, begins)| event(emission, when, begins)).collect_vec();
    (!whens.is_empty()).then(|| {
        quote! {
            #values

            impl<S: Real> #name<S> {
                #[cold]
                fn set_at_start_(&self, t: S, u: &mut Held<S>, x: &mut [S; #length]) -> Result<(), Fault> {
                    #(
                        let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
                        let (q, v) = state.pose_();
                        let set = state.values_at_start_(&q, &v);
                        #events
                    )*
                    Ok(())
                }
            }
        }
    })
}

/// The function of this name that gives the values that events set.
fn values(emission: &Emission, name: &str, (whens, values): (&[When], &Function)) -> TokenStream {
    let (nq, count) = (&emission.sizes.nq, number(When::values(whens).len()));
    let [fill, give] = [format_ident!("{name}"), format_ident!("{name}_")];
    let fill_values = function(
        emission,
        "The values that events set, one event after the other.",
        &quote! {
            #[cold]
            fn #fill(&self, q: &[S; #nq], v: &[S; #nq], set: &mut [S; #count])
        },
        (values, Origin::State),
    );
    quote! {
        impl<S: Real> State<S> {
            #fill_values

            fn #give(&self, q: &[S; #nq], v: &[S; #nq]) -> [S; #count] {
                let mut set = [S::lit(0.0); #count];
                self.#fill(q, v, &mut set);
                set
            }
        }
    }
}

/// Each event with the number of its first value.
fn numbered(whens: &[When]) -> impl Iterator<Item = (&When, usize)> {
    let begins = whens.iter().scan(0, |next, when| {
        let begins = *next;
        *next += when.set.len();
        Some(begins)
    });
    whens.iter().zip(begins)
}

/// The values of each event where they belong, by its number.
fn events(emission: &Emission) -> TokenStream {
    let arms = numbered(conditional(emission)).enumerate().map(|(k, (when, begins))| {
        let (k, event) = (number(k), event(emission, when, begins));
        quote!(#k => { #event })
    });
    let arms = arms.collect_vec();
    quote! {
        match index {
            #(#arms)*
            _ => {}
        }
        Ok(())
    }
}

/// The next modes of contacts, where there are some, after a look at gaps that begin to exist or that what was set has moved.
fn settle(emission: &Emission) -> Option<TokenStream> {
    let length = &emission.sizes.length;
    let rows = contact::count(emission);
    let moved = facts::moved_by_states(emission.model).into_iter().map(number).collect_vec();
    let appearance = (facts::some_may_not_exist(emission.model) || !moved.is_empty()).then(|| {
        let stays = if moved.is_empty() { quote!(true) } else { quote!(!matches!(row, #(#moved)|*)) };
        quote! {
            let existed: [bool; #rows] = core::array::from_fn(
                |row| #stays && rt::contact::Contacts::<#rows>::exists(self, before, row)
            );
            rt::contact::appear::<Self, #rows>(self, t, (u, x), existed)?;
        }
    });
    contact::are_there(emission).then(|| {
        quote! {
            fn settle(
                &self, t: S, before: &Held<S>, u: &mut Held<S>, x: &mut [S; #length]
            ) -> Result<(), Fault> {
                #appearance
                rt::contact::update::<Self, #rows>(self, t, u, x)?;
                Ok(())
            }
        }
    })
}

fn event(emission: &Emission, when: &When, begins: usize) -> TokenStream {
    let (mut states, mut velocities) = (Vec::new(), Vec::new());
    for (k, (target, _)) in when.set.iter().enumerate() {
        let value = begins + k;
        match target {
            Target::State(state) => {
                states.push(format!("x[{}] = set[{value}];", emission.sizes.second_order + state));
            }
            Target::Velocity(velocity) => velocities.push(format!("({velocity}, set[{value}])")),
        }
    }
    let states = emission.text(states.concat());
    if velocities.is_empty() {
        return states;
    }
    let (velocities, back) = (emission.list(velocities), into_state(emission, &quote!(u)));
    quote! {
        #states
        let v = rt::events::with_velocities::<S, Self, NQ, NC>(self, t, (&q, &v), &[#velocities])?;
        #back;
    }
}
