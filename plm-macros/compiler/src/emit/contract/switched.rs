//! `Switched`: tables of conditions and of contact, and the routines that they name; the runtime makes `Events` of it.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use proc_macro2::TokenStream;
use quote::format_ident;

use super::super::bindings::Origin;
use super::super::function::body;
use super::super::{Emission, Sizes, number, pose_at, quoted};
use super::charted::in_held;
use super::contact;
use super::sets;
use crate::facts::contact::are_read_by_conditions as reads_contact;
use crate::facts::{self, conditions};
use crate::model::{Decisions, End, Switch, bounding_reactions};

/// `Switched`.
pub(super) fn switched(emission: &Emission) -> TokenStream {
    let Emission { model, name, .. } = emission;
    let all = number(model.guards() + facts::contact::guards(model));
    let contact = if contact::are_there(emission) {
        let places = contact::count(emission);
        quote!(rt::switched::WithContact<#places>)
    } else {
        quote!(rt::switched::NoContact)
    };
    let (table, ends) = (table(emission), ends(emission));
    let watch = (model.watched() > 0).then(|| watch(emission));
    let times = (model.switches.len() > model.guards()).then(|| known_times(emission));
    let change = sets::are_there(emission).then(|| change(emission));
    let jump = (!model.jumps.is_empty()).then(|| jump(emission));
    let appear = facts::contact::some_may_not_exist(model).then(|| {
        quote! {
            fn may_appear(&self) -> bool {
                true
            }
        }
    });
    quote! {
        impl<S: Real> rt::Switched for #name<S> {
            type Guards = [S; #all];
            type Contact = #contact;
            const SWITCHES: rt::Switches = #table;
            #watch
            #times
            #change
            #jump
            #appear
            #ends
        }
    }
}

/// Conditions that must hold, and guards at whose zeros a run ends.
fn ends(emission: &Emission) -> TokenStream {
    let switches = &emission.model.switches;
    let is_required = |switch: &Switch| switch.must_hold && switch.instant.is_none();
    let required = switches.iter().enumerate().filter(|(_, switch)| is_required(switch));
    let required: Vec<_> = required.map(|(index, _)| number(index)).collect_vec();
    let is_required = (!required.is_empty()).then(|| {
        quote! {
            #[inline]
            fn is_required(&self, index: usize) -> bool {
                matches!(index, #(#required)|*)
            }
        }
    });
    let ends = switches.iter().take(emission.model.guards()).enumerate().filter_map(|(index, switch)| {
        Some(match switch.end.as_ref()? {
            End::Pole(by) => format!("{index} => Some(rt::Cause::Pole {{ by: {by:?} }}),"),
            End::Domain(of) => format!("{index} => Some(rt::Cause::Domain {{ of: {of:?} }}),"),
        })
    });
    let ends: Vec<String> = ends.collect_vec();
    let end_at = (!ends.is_empty()).then(|| {
        let ends = emission.text(ends.join(" "));
        quote! {
            fn end_at(&self, index: usize) -> Option<rt::Cause> {
                match index {
                    #ends
                    _ => None,
                }
            }
        }
    });
    quote!(#is_required #end_at)
}

/// The tables; what is nothing is left out.
fn table(emission: &Emission) -> TokenStream {
    let model = emission.model;
    let Decisions { nodes, roots } = &model.decisions;
    let in_plane = bounding_reactions(&model.contacts).iter().any(|reaction| reaction.components.len() > 1);
    let counts = [
        ("guards", model.guards()),
        ("kinks", model.kinks.len()),
        ("times", model.switches.len() - model.guards()),
        ("rows", model.contacts.len()),
        ("contact_guards", facts::contact::guards(model)),
    ];
    let mut fields: Vec<String> = counts
        .into_iter()
        .filter(|(_, count)| *count > 0)
        .map(|(name, count)| format!("{name}: {count}"))
        .collect_vec();
    let lists = [
        ("roots", roots.iter().map(usize::to_string).collect_vec()),
        ("nodes", nodes.iter().map(|(side, yes, no)| format!("({side}, {yes}, {no})")).collect_vec()),
        ("jumps", model.jumps.iter().map(|jump| format!("({}, {})", jump.row, jump.switch)).collect_vec()),
    ];
    let lists = lists.into_iter().filter(|(_, items)| !items.is_empty());
    fields.extend(lists.map(|(name, items)| format!("{name}: &[{}]", items.join(", "))));
    let is_so = [("selective", !roots.is_empty()), ("bends", in_plane)];
    fields.extend(is_so.into_iter().filter(|(_, is_so)| *is_so).map(|(name, _)| format!("{name}: true")));
    if fields.is_empty() {
        return quote!(rt::Switches::NONE);
    }
    let fields = emission.text(fields.join(", "));
    quote!(rt::Switches { #fields, ..rt::Switches::NONE })
}

/// Guards and kinks, which every step evaluates, at a time and over an interval.
fn watch(emission: &Emission) -> TokenStream {
    let (model, Sizes { length, .. }) = (emission.model, &emission.sizes);
    let all = number(model.watched());
    let solution = emission.events_read_solution().then(|| quote!(&a, &lambda,));
    let full = quote!(self.switching(t, u, &rt::charts::full(self, t, u, x), #solution g));
    let solved = emission
        .events_read_solution()
        .then(|| quote!(let (a, lambda) = <State<S> as rt::Moment>::new(*self, *u, t, *x).solved_(&Common::<S>::new());));
    let loaded = reads_contact(model).then(|| quote!(let u = &self.loaded_(t, u, x);));
    let here = switching(emission, &quote!(self), (&solution, &quote!({ #full })));
    let within = watch_within(emission);
    quote! {
        #[inline]
        fn watch<T>(&self, t: S, u: &Self::U, x: &[S; #length], see: impl FnOnce(&[S]) -> T) -> T {
            let mut all = [S::lit(0.0); #all];
            let g = &mut all;
            #solved
            #loaded
            #here;
            see(&all)
        }

        #within
    }
}

/// Guards and kinks over an interval of time. Enclosures of accelerations and multipliers are wide: where events read some, all are
/// looked for by samples.
fn watch_within(emission: &Emission) -> TokenStream {
    let (model, Sizes { length, .. }) = (emission.model, &emission.sizes);
    let head = quote! {
        fn watch_within(
            &self,
            t: rt::Enclosed<S>,
            u: &Self::U,
            x: &impl Fn(usize) -> rt::Enclosed<S>,
            each: &mut impl FnMut(usize, rt::Enclosed<S>),
        ) -> bool
    };
    if reads_contact(model) || emission.events_read_solution() {
        return quote! {
            #head {
                let _ = (t, u, x, each);
                false
            }
        };
    }
    let all = number(model.watched());
    let within = switching(emission, &quote!(mechanism), (&None, &quote!({})));
    // Without a chart the state stands in what is held, and does not move with `x`.
    let only = emission.loops().is_some().then(|| {
        quote! {
            if rt::charts::is_free::<Self>(u) {
                return false;
            }
        }
    });
    quote! {
        #head {
            #only
            use rt::lanes::Pack;
            let constant = |[s]: [S; 1]| rt::Enclosed::constant(s);
            let (mechanism, held) = (self.pack([self], constant), Self::pack_held(u, [u], constant));
            let mut all = [rt::Enclosed::constant(S::lit(0.0)); #all];
            let within = |u: &Held<rt::Enclosed<S>>, x: &[rt::Enclosed<S>; #length], g: &mut [rt::Enclosed<S>; #all]| #within;
            within(&held, &rt::Vector::from_fn(x), &mut all);
            for (number, value) in all.into_iter().enumerate() {
                each(number, value);
            }
            true
        }
    }
}

/// Does a condition of the state read what contacts do, or forces?
pub(in super::super) fn read_forces(emission: &Emission) -> bool {
    let model = emission.model;
    let of_contact = facts::contact::modes_are_read_by_conditions(model) || reads_contact(model);
    of_contact || emission.events_read_solution()
}

/// The call of the guards' function of a mechanism that is called so, with accelerations and multipliers if events read some, and `g` as its last
/// argument; `free` stands for it where loops have no chart.
fn switching(
    emission: &Emission,
    mechanism: &TokenStream,
    (solution, free): (&Option<TokenStream>, &TokenStream),
) -> TokenStream {
    let Some(reduced) = emission.loops() else { return quote!(#mechanism.switching(t, u, x, #solution g)) };
    in_held(reduced, &quote!(u), free, |k| {
        let switching = format_ident!("switching_{k}");
        quote!(#mechanism.#switching(t, u, m, x, #solution g))
    })
}

/// Names of the conditions of the state and of contact, and their texts: fields of a table.
pub(super) fn names(emission: &Emission) -> TokenStream {
    let model = emission.model;
    let of_contact = facts::contact::names_of_guards(model);
    let names = model.switches.iter().take(model.guards()).map(|switch| &switch.name);
    let names = emission.text(quoted(names.chain(of_contact.iter().copied())));
    let texts = emission.text(quoted(conditions::texts(model).chain(of_contact.into_iter().cloned())));
    quote!(guards: &[#names], conditions: &[#texts],)
}

/// When conditions of the time alone change.
fn known_times(emission: &Emission) -> TokenStream {
    let count = number(emission.model.switches.len() - emission.model.guards());
    quote! {
        #[inline]
        fn known_times<T>(&self, u: &Self::U, see: impl FnOnce(&[S], &[S]) -> T) -> T {
            let (mut at, mut slope) = ([S::lit(0.0); #count], [S::lit(0.0); #count]);
            self.instants(u, &mut at, &mut slope);
            see(&at, &slope)
        }
    }
}

/// Changes, and the events that set states after them.
fn change(emission: &Emission) -> TokenStream {
    let (count, Sizes { length, .. }) = (sets::count(emission), &emission.sizes);
    quote! {
        fn change(
            &self,
            t: S,
            u: &mut Self::U,
            x: &mut [S; #length],
            changes: impl FnOnce(&mut Self::U, &mut [S; #length]) -> Result<(), Fault>,
        ) -> Result<(), Fault> {
            rt::events::change::<Self, #count>(self, t, u, x, changes)
        }
    }
}

/// Rows that may jump; those that are known to are errors.
fn jump(emission: &Emission) -> TokenStream {
    let (jumps, Sizes { nq, length, .. }) = (&emission.model.jumps, &emission.sizes);
    let terms = number(5 * jumps.len());
    let pose = pose_at("u");
    let (jump_docs, jump) = body(
        emission,
        "How rows differ on both sides of conditions: phi, its rate, the rate of that; the distance, its rate.",
        &["t", "u", "x", "after", "q", "v", "jump"],
        (&emission.program.jumps, Origin::Pose),
    );
    quote! {
        #jump_docs
        #[cold]
        fn jump_of_rows(&self, t: S, u: &Self::U, x: &[S; #length], after: Option<&Self::U>) -> Option<Fault> {
            let (q, v): ([S; #nq], [S; #nq]) = #pose;
            let (q, v) = (&q, &v);
            let mut jump = [S::lit(0.0); #terms];
            #jump
            rt::switched::jump::<Self, NQ, NC>(self, t, (q, v), (u, after), &jump)
        }
    }
}
