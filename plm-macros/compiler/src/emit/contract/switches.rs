//! Methods of `Events` for switches, whose sides are held over a step: guards, switches, known times, jumps of rows.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use proc_macro2::TokenStream;
use quote::format_ident;

use super::super::bindings::Origin;
use super::super::function::body;
use super::super::{Emission, Sizes, number, pose_at, quoted};
use super::charted::in_held;
use super::contact;
use super::contact_events::Beside;
use super::sets;
use crate::facts::contact::are_read_by_conditions as reads_contact;
use crate::facts::{self, conditions};
use crate::model::{Decisions, End};

/// Guards and kinks, which every step evaluates, at a time and over an interval.
pub(super) fn watched(emission: &Emission) -> TokenStream {
    let (model, Sizes { length, .. }) = (emission.model, &emission.sizes);
    let Beside { take, guards: contact_guards, .. } = Beside::new(emission);
    let total = number(model.guards() + Beside::guards_of(emission));
    let [guards, kinks, all] = [model.guards(), model.kinks.len(), model.watched()].map_each(number);
    let solution = emission.events_read_solution().then(|| quote!(&a, &lambda,));
    let full = quote!(self.switching(t, u, &rt::charts::full(self, t, u, x), #solution g));
    let solved = emission
        .events_read_solution()
        .then(|| quote!(let (a, lambda) = <State<S> as rt::Moment>::new(*self, *u, t, *x).solved_();));
    let loaded = reads_contact(model).then(|| quote!(let u = &self.loaded_(t, u, x);));
    let here = switching(emission, &quote!(self), (&solution, &quote!({ #full })));
    let within = guards_within(emission);
    quote! {
        const KINKS: usize = #kinks;

        fn guards(&self, t: S, u: &Self::U, x: &[S; #length], g: &mut [S; #total]) {
            let mut all = [S::lit(0.0); #all];
            let out = g;
            let g = &mut all;
            #solved
            #loaded
            #here;
            for (guard, value) in out.iter_mut().zip(all)#take {
                *guard = value;
            }
            #contact_guards
        }

        fn kinks(&self, t: S, u: &Self::U, x: &[S; #length], each: &mut impl FnMut(usize, S)) {
            let mut all = [S::lit(0.0); #all];
            let g = &mut all;
            #solved
            #loaded
            #here;
            for (index, value) in all.into_iter().skip(#guards).enumerate() {
                each(index, value);
            }
        }

        #within
    }
}

/// Guards and kinks over an interval of time. Enclosures of accelerations and multipliers are wide: where events read some, all are
/// looked for by samples.
fn guards_within(emission: &Emission) -> TokenStream {
    let (model, Sizes { length, .. }) = (emission.model, &emission.sizes);
    let head = quote! {
        fn guards_within(
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
    let Beside { index: place, within: contact_within, .. } = Beside::new(emission);
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
            let mut guards = [rt::Enclosed::constant(S::lit(0.0)); #all];
            let within = |u: &Held<rt::Enclosed<S>>, x: &[rt::Enclosed<S>; #length], g: &mut [rt::Enclosed<S>; #all]| #within;
            within(&held, &rt::Vector::from_fn(x), &mut guards);
            for (index, guard) in guards.into_iter().enumerate() {
                each(#place, guard);
            }
            #contact_within
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

/// Events of the switches that depend on the state. One that must hold does not change: it ends the run.
pub(super) fn switch(emission: &Emission) -> TokenStream {
    let model = emission.model;
    let of_state = model.switches.iter().filter(|switch| switch.instant.is_none());
    let required: Vec<_> = of_state
        .enumerate()
        .filter(|(_, switch)| switch.must_hold)
        .map(|(index, _)| number(index))
        .collect_vec();
    let is_required = !required.is_empty();
    let must_hold = is_required.then(|| {
        quote! {
            fn must_hold(&self, index: usize) -> bool {
                matches!(index, #(#required)|*)
            }
        }
    });
    let only = is_required.then(|| {
        quote! {
            if self.must_hold(index) {
                return Ok(());
            }
        }
    });
    let ends = model.switches.iter().take(model.guards()).enumerate().filter_map(|(index, switch)| {
        Some(match switch.end.as_ref()? {
            End::Pole(by) => format!("{index} => Some(rt::Cause::Pole {{ by: {by:?} }}),"),
            End::Domain(of) => format!("{index} => Some(rt::Cause::Domain {{ of: {of:?} }}),"),
        })
    });
    let ends: Vec<String> = ends.collect_vec();
    let Beside { head, switch: next, appearance: [exist, appear], .. } = Beside::new(emission);
    let end = (!ends.is_empty()).then(|| {
        let ends = emission.text(ends.join(" "));
        quote! {
            fn end(&self, index: usize) -> Option<rt::Cause> {
                match index {
                    #ends
                    _ => None,
                }
            }
        }
    });
    // Behind the guards of conditions stand those of contact; behind sides of conditions of the state those of the time.
    let own = contact::are_there(emission).then(|| {
        let own = number(model.guards());
        quote!(.filter(|_| index < #own))
    });
    let changes = quote! {
        #exist
        if let Some(side) = u.switches.get_mut(index)#own {
            *side = -*side;
        }
        #appear
        #next
    };
    let changes = sets::followed(emission, changes);
    quote! {
        #must_hold
        #end
        #head {
            #only
            #changes
        }
    }
}

/// Names of the conditions of the state, and their texts.
pub(super) fn names(emission: &Emission) -> TokenStream {
    let model = emission.model;
    let of_contact = facts::contact::names_of_guards(model);
    let names = model.switches.iter().take(model.guards()).map(|switch| &switch.name);
    let names = emission.text(quoted(names.chain(of_contact.iter().copied())));
    let texts = emission.text(quoted(conditions::texts(model).chain(of_contact.into_iter().cloned())));
    let guards = number(model.guards() + Beside::guards_of(emission));
    quote! {
        fn guard_name(&self, index: usize) -> &'static str {
            const NAMES: [&str; #guards] = [#names];
            NAMES.get(index).copied().unwrap_or_default()
        }

        fn conditions(&self) -> &'static [&'static str] {
            &[#texts]
        }
    }
}

/// Which conditions and kinks matter, given the sides that are held.
pub(super) fn matters(emission: &Emission) -> TokenStream {
    let Decisions { nodes, roots } = &emission.model.decisions;
    let contact = Beside::new(emission).matters;
    let [watched, count] = [roots.len(), nodes.len()].map_each(number);
    let roots = emission.list(roots.iter().map(usize::to_string));
    let nodes = emission.list(nodes.iter().map(|(side, yes, no)| format!("({side}, {yes}, {no})")));
    quote! {
        const SELECTIVE: bool = true;

        fn matters(&self, u: &Self::U, index: usize, unknown: u64) -> bool {
            const ROOTS: [u16; #watched] = [#roots];
            const NODES: [(u8, u16, u16); #count] = [#nodes];
            #contact
            let root = ROOTS.get(index).copied().unwrap_or(1);
            rt::events::holds(&NODES, root, &u.switches, unknown)
        }
    }
}

/// When switches of the time alone change, and which sides of them apply.
pub(super) fn known_times(emission: &Emission) -> TokenStream {
    let (guards, Sizes { length, .. }) = (emission.model.guards(), &emission.sizes);
    let Beside { switch_at_time: next, appearance: [exist, appear], .. } = Beside::new(emission);
    let reads_state = contact::are_there(emission) || sets::are_there(emission);
    let state = if reads_state { quote!(x) } else { quote!(_x) };
    let count = number(emission.model.switches.len() - guards);
    let sides = sides_at_time(emission);
    let changes = quote! {
        #exist
        #sides
        #appear
        #next
        Ok(())
    };
    let changes = sets::followed(emission, changes);
    quote! {
        fn next_time_event(&self, t: S, u: &Self::U) -> Option<S> {
            let (mut at, mut slope) = ([S::lit(0.0); #count], [S::lit(0.0); #count]);
            self.instants(u, &mut at, &mut slope);
            at.into_iter().filter(|at| *at > t).reduce(S::min)
        }

        fn switch_at_time(&self, t: S, u: &mut Self::U, #state: &mut [S; #length]) -> Result<(), Fault> {
            #changes
        }
    }
}

/// The sides of conditions on the time alone, at the time `t`.
pub(in super::super) fn sides_at_time(emission: &Emission) -> TokenStream {
    let guards = emission.model.guards();
    let [count, guards] = [emission.model.switches.len() - guards, guards].map_each(number);
    quote! {
        let (mut at, mut slope) = ([S::lit(0.0); #count], [S::lit(0.0); #count]);
        self.instants(u, &mut at, &mut slope);
        for ((side, at), slope) in u.switches.iter_mut().skip(#guards).zip(at).zip(slope) {
            *side = if (at <= t) == (slope > S::lit(0.0)) { S::lit(1.0) } else { S::lit(-1.0) };
        }
    }
}

/// Rows that may jump; those that are known to are errors.
pub(super) fn jump(emission: &Emission) -> TokenStream {
    let (jumps, Sizes { nq, length, .. }) = (&emission.model.jumps, &emission.sizes);
    let [count, terms] = [jumps.len(), 5 * jumps.len()].map_each(number);
    let places = emission.list(jumps.iter().map(|jump| format!("({}, {})", jump.row, jump.switch)));
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
        fn jump(&self, t: S, u: &Self::U, x: &[S; #length], after: Option<&Self::U>) -> Option<Fault> {
            const JUMPS: [(usize, usize); #count] = [#places];
            let (q, v): ([S; #nq], [S; #nq]) = #pose;
            let (q, v) = (&q, &v);
            let mut jump = [S::lit(0.0); #terms];
            #jump
            let (terms, _) = jump.as_chunks::<5>();
            let crossings = JUMPS.iter().zip(terms).filter_map(|(&(row, switch), &terms)| {
                let changes = after.is_some_and(|after| after.switches[switch] != u.switches[switch]);
                (changes || after.is_none()).then_some(absolute::Crossing { row, terms, changes })
            });
            absolute::jump::<S, Self, NQ, NC>(self, t, (q, v), crossings)
        }
    }
}
