//! `Statics`: a mechanism at rest; `StartValues`: names and values one by one, and as text.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::bindings::Origin;
use super::super::function::body;
use super::super::item::{start, state::unwrapped_state};
use super::super::{Emission, Sizes, docs, number, table_compression};
use super::contact;
use crate::facts::state::OF_BODY;
use crate::model::Body;

/// Statements of a block; rustc recurses over longer ones.
pub(crate) const MOST_LINES: usize = 200;

/// `StartValues` and `Display` of the start values.
pub(crate) fn start_values(emission: &Emission) -> TokenStream {
    let Emission { model, fields, .. } = emission;
    let names = |body: &Body| OF_BODY.map_each(|value| format!("{}.{value}", body.name.text));
    let in_a_loop = emission.rerolled.then(|| {
        let names = table_compression::names(emission, &model.bodies.iter().flat_map(names).collect_vec());
        quote! {
            let names: &[&str] = const { &#names };
            let names = names.as_chunks::<6>().0;
            self.each_body_(&mut |k, body| {
                if let Some(names) = names.get(k) {
                    body.each(*names, &mut *each);
                }
            });
        }
    });
    let bodies = model.bodies.iter().zip(&fields.bodies).filter(|_| in_a_loop.is_none());
    let bodies = bodies.map(|(body, field)| format!("self.{field}.each({:?}, &mut *each);\n", names(body)));
    let states = model.states.iter().zip(&fields.states);
    let states = states.map(|(state, field)| format!("each({:?}, &mut self.{field});\n", state.name.text));
    let lines: Vec<String> = bodies.chain(states).collect_vec();
    let blocks: Vec<TokenStream> =
        lines.chunks(MOST_LINES).map(|lines| emission.text(lines.concat())).collect_vec();
    let lines = if let [one] = &blocks[..] { one.clone() } else { quote!(#({ #blocks })*) };
    quote! {
        impl<S: Scalar> rt::StartValues<S> for Starts<S> {
            fn each(&mut self, each: &mut impl FnMut(&'static str, &mut Start<S>)) {
                #in_a_loop
                #lines
            }
        }

        impl<S: Scalar> core::fmt::Display for Starts<S> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                rt::start::write_starts(*self, f)
            }
        }
    }
}

/// `Statics`.
pub(crate) fn statics(emission: &Emission) -> TokenStream {
    let Emission { model, name, program, sizes: Sizes { nq, nc, nx, full, .. }, .. } = emission;
    let (declared, unwrapped) = (start::declared(emission), unwrapped_state(emission, &quote!(state)));
    let states = model.states.iter();
    let states =
        emission.list(states.map(|state| format!("({:?}, {:?})", state.name.text, docs::si(&state.unit))));
    let mut arguments = vec!["t", "u", "x", "lambda", "force", "x_dot", "each", "q", "v"];
    if contact::are_there(emission) {
        arguments.extend(["gap", "limit"]);
    }
    let (at_rest_docs, at_rest) = body(
        emission,
        "What vanishes at rest: applied forces `Q` (N, N, N m per body) that reactions do not balance, residuals of the
constraints, rates of the first-order states, without accelerations.",
        &arguments,
        (&program.at_rest, Origin::Arguments),
    );
    let OfContact { gaps, rates, multipliers } = OfContact::new(emission);
    quote! {
        impl<S: Real> rt::Statics for #name<S> {
            type Full = [S; #full];
            type Rows = [S; #nc];
            type Starts = Starts<S>;
            const COORDINATES: &'static [&'static str] = Self::LAYOUT_.coordinates;
            const ROWS: &'static [&'static str] = Self::LAYOUT_.rows;
            const STATES: &'static [(&'static str, &'static str)] = &[#states];

            fn full(state: &State<S>) -> [S; #full] {
                #unwrapped
            }
            #at_rest_docs
            #[cold]
            fn equations(
                &self, t: S, u: &Self::U, x: &[S; #full], lambda: &[S; #nc], each: &mut impl FnMut(S)
            ) {
                let (mut force, mut x_dot) = ([S::lit(0.0); #nq], [S::lit(0.0); #nx]);
                #gaps
                #at_rest
                let (q, _): ([S; #nq], [S; #nq]) = absolute::split(x);
                absolute::balance::<S, Self, NQ, NC>(self, t, &q, lambda, &force).into_iter().for_each(&mut *each);
                absolute::residuals::<S, Self, NQ, NC, #full>(self, t, x, each);
                #rates
            }
            #multipliers
            fn start_with_inputs(&self, t: S, held: &Self::U) -> Result<(Self::U, Self::X), Fault> {
                self.start_holding_(t, held.input)
            }
            fn unstarted(&self) -> Self::U {
                Self::holding_(self.declared_input())
            }
            fn starts_mut(&mut self) -> &mut Starts<S> {
                &mut self.start
            }
            #declared
            fn starts_at(&self, x: &[S; #full]) -> Starts<S> {
                self.placed(x)
            }
            fn size(&self) -> S {
                absolute::Absolute::<S, NQ, NC>::length(self)
            }
        }
    }
}

/// Parts of `Statics` that differ where there is contact.
struct OfContact {
    /// Room for the gaps, and the limits of frictions.
    gaps: TokenStream,
    /// Gives the rates of the states, and gaps and limits after them.
    rates: TokenStream,
    /// The multipliers of what is held.
    multipliers: TokenStream,
}

impl OfContact {
    fn new(emission: &Emission) -> Self {
        if !contact::are_there(emission) {
            let rates = quote!(x_dot.into_iter().for_each(each););
            return Self { gaps: TokenStream::new(), rates, multipliers: TokenStream::new() };
        }
        let count = number(emission.model.contacts.len());
        Self {
            gaps: quote!(let (mut gap, mut limit) = ([S::lit(0.0); #count], [S::lit(0.0); 2 * #count]);),
            rates: quote!(x_dot.into_iter().chain(gap).chain(limit).for_each(each);),
            multipliers: quote! {
                fn multipliers(held: &mut Self::U) -> &mut [S] {
                    &mut held.contact.lambda
                }
            },
        }
    }
}
