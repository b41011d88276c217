//! `Pack`: every number of a mechanism and of what it holds, made of those of several. It is generic: nothing is compiled
//! where nobody asks for it.

use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::{Emission, number};
use super::{contact, contact_motion, turns};

/// `Pack`.
pub(crate) fn pack(emission: &Emission) -> TokenStream {
    let Emission { fields, name, .. } = emission;
    let starts = starts(emission);
    let params = fields.params.iter();
    let params = params.map(|field| format!("{field}: number(rt::Vector::from_fn(|i| all[i].{field}))"));
    let (params, inputs) = (emission.lines(params), &fields.inputs);
    let none = inputs.is_empty().then(|| quote!(none: core::marker::PhantomData,));
    let Lanes { watched, are_calm, are_short, look } = lanes(emission);
    let length = &emission.sizes.length;
    let [switches, of_loops, turns] = discrete(emission);
    let contact = if contact::are_there(emission) {
        quote! {
            let mut contacts = [&first.contact; N];
            for i in 0..N {
                contacts[i] = &all[i].contact;
            }
            let contact = rt::contact::Held::packed(&first.contact, contacts, &number);
        }
    } else {
        quote!(let contact = ();)
    };
    let packed_steps = contact_motion::packed_steps(emission);
    let modes = (emission.model.guards() > 0).then(|| {
        quote! {
            for (wide, &one) in wide.switches.iter_mut().zip(&one.switches) {
                put(wide, one);
            }
        }
    });
    quote! {
        impl<S: Real> rt::lanes::Pack for #name<S> {
            type Packed<T: Scalar> = #name<T>;

            #[allow(unused_variables)] // where there are no parameters
            fn pack<T: Scalar, const N: usize>(&self, all: [&Self; N], number: impl Fn([S; N]) -> T) -> #name<T> {
                let same = |s| number([s; N]);
                let start = #starts;
                #name { start, #params }
            }

            #[allow(unused_variables)] // where there are no inputs
            fn pack_held<T: Scalar, const N: usize>(
                first: &Held<S>, all: [&Held<S>; N], number: impl Fn([S; N]) -> T
            ) -> Held<T> {
                let input = Input { #(#inputs: number(rt::Vector::from_fn(|i| all[i].input.#inputs)),)* #none };
                #switches
                #of_loops
                #turns
                #contact
                rt::Held { input, switches, turns, of_loops, contact }
            }

            const WATCHED: bool = #watched;

            #[inline]
            fn are_calm<T: Scalar>(typical: &[T; #length], t: T, held: &Held<T>, x: &[T; #length]) -> T {
                #are_calm
            }

            #[inline]
            fn are_short<T: Scalar>(typical: &[T; #length], held: &Held<T>, legs: [&[T; #length]; 2]) -> T {
                #are_short
            }

            #[inline(never)]
            fn look<T: Scalar>(all: &#name<T>, t: T, held: &mut Held<T>, x: &[T; #length], due: T) -> T {
                #look
            }

            #[inline]
            fn put_held<T: Scalar>(wide: &mut Held<T>, one: &Held<S>, put: impl Fn(&mut T, S)) {
                rt::held::Loops::<S>::put(&mut wide.of_loops, &one.of_loops, &put);
                #modes
                for (wide, &one) in wide.turns.iter_mut().zip(&one.turns) {
                    let mut turns = T::of_turns(*wide);
                    put(&mut turns, S::of_turns(one));
                    *wide = turns.to_turns();
                }
            }

            fn take_held<T: Scalar>(one: &mut Held<S>, wide: &Held<T>, take: impl Fn(T) -> S) {
                rt::held::Loops::<S>::take(&mut one.of_loops, &wide.of_loops, &take);
            }

            fn chart(held: &Held<S>) -> Option<usize> {
                rt::held::Loops::<S>::chart(&held.of_loops)
            }
            #packed_steps
        }
    }
}

/// The mechanism and what it holds in numbers for the rate. It does not depend on start values, which are zero, and has no derivatives
/// by continuation data of loops, which decide for a solution and lead to it.
pub(super) fn of_rate(emission: &Emission) -> TokenStream {
    let Emission { name, fields, .. } = emission;
    let start = if emission.rerolled {
        quote!(let start = Starts::<T>::ZERO_;)
    } else {
        let bodies = fields.bodies.iter().map(|field| format!("{field}: zero"));
        let states = fields.states.iter().map(|field| format!("{field}: value"));
        let starts = emission.lines(bodies.chain(states));
        quote! {
            let value = Start::free(T::ZERO);
            let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
            let start = Starts { #starts };
        }
    };
    let params = fields.params.iter().map(|field| format!("{field}: number(self.{field})"));
    let params = emission.lines(params);
    let held = emission.loops().is_some().then(|| {
        quote! {
            let same = |[s]: [S; 1]| S::of_plain(s.plain());
            let of_loops = rt::held::Loops::<S>::packed(&held.of_loops, [&held.of_loops], &same);
            let held = &rt::Held { of_loops, ..*held };
        }
    });
    quote! {
        #start
        let own = #name { start, #params };
        #held
        (own, <Self as rt::lanes::Pack>::pack_held(held, [held], |[s]: [S; 1]| number(s)))
    }
}

/// Switches, continuation data and turns, as `let` statements. Not by `core::array`'s `map` and `from_fn`, of which a compiler
/// translates ten functions for every closure.
fn discrete(emission: &Emission) -> [TokenStream; 3] {
    let model = emission.model;
    let switches = if model.switches.is_empty() {
        quote!(let switches = [];)
    } else {
        quote! {
            let switches = rt::Vector::from_fn(|k| number(rt::Vector::from_fn(|i| all[i].switches[k])));
        }
    };
    let of_loops = if emission.loops().is_some() {
        quote! {
            let mut of_loops = [&first.of_loops; N];
            for i in 0..N {
                of_loops[i] = &all[i].of_loops;
            }
            let of_loops = rt::held::Loops::<S>::packed(&first.of_loops, of_loops, &number);
        }
    } else {
        quote!(let of_loops = ();)
    };
    let count = number(model.turns.len());
    let turns = if model.turns.is_empty() {
        quote!(let turns = [];)
    } else {
        quote! {
            let mut turns = [T::ZERO.to_turns(); #count];
            for k in 0..#count {
                turns[k] = number(rt::Vector::from_fn(|i| S::of_turns(all[i].turns[k]))).to_turns();
            }
        }
    };
    [switches, of_loops, turns]
}

/// Checks of steps of several mechanisms side by side.
struct Lanes {
    watched: bool,
    are_calm: TokenStream,
    are_short: TokenStream,
    look: TokenStream,
}

fn lanes(emission: &Emission) -> Lanes {
    let has_guards = emission.model.guards() > 0;
    let Some(reduced) = emission.loops() else {
        return Lanes {
            watched: !emission.is_reduced() || has_guards,
            are_calm: turns::are_near(emission),
            are_short: quote!(T::lit(1.0)),
            look: quote!(T::lit(0.0)),
        };
    };
    let look = quote! {
        let (memory, measure) = all.remember_(t, held, x);
        rt::charts::look::<Self, T, _>(&mut held.of_loops, x, (&memory, measure), due)
    };
    Lanes {
        watched: has_guards,
        are_calm: quote!(rt::charts::are_calm::<Self, T, _>(typical, t, &held.of_loops, x)),
        are_short: quote!(rt::charts::are_short::<Self, T, _>(typical, &held.of_loops, legs)),
        // The unknowns of iterations are followed one by one.
        look: if reduced.followed.is_empty() { look } else { quote!(T::lit(0.0)) },
    }
}

/// Start values in the other numbers, of many bodies in a loop.
fn starts(emission: &Emission) -> TokenStream {
    let fields = &emission.fields;
    if !emission.rerolled {
        let starts = fields.bodies.iter().chain(&fields.states);
        let starts = starts.map(|field| format!("{field}: self.start.{field}.map(same)"));
        let starts = emission.lines(starts);
        return quote!(Starts { #starts });
    }
    let (states, count) = (&fields.states, number(fields.bodies.len()));
    quote! {{
        let (mut start, mut own) = (Starts::<T>::ZERO_, self.start);
        let mut packed = [None; #count];
        own.each_body_(&mut |k, body| {
            if let Some(packed) = packed.get_mut(k) {
                *packed = Some(body.map(same));
            }
        });
        start.each_body_(&mut |k, body| {
            if let Some(Some(packed)) = packed.get(k) {
                *body = *packed;
            }
        });
        #(start.#states = self.start.#states.map(same);)*
        start
    }}
}
