//! `Charted`: the runtime's view of charts.

use crate::collect::MapEach;
use crate::emit::template::quote;
use proc_macro2::TokenStream;
use quote::format_ident;

use super::super::{Emission, Form, Sizes, memory, number, quoted};
use super::{contact, turns};
use crate::facts;
use crate::formulate::Reduced;

/// `Charted`, if loops are solved in charts.
pub(crate) fn charted(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { nq, length, .. }, .. } = emission;
    let Some(reduced) = emission.loops() else { return TokenStream::new() };
    let [charts, switches] = [reduced.charts.len(), emission.model.switches.len()].map_each(number);
    let memory = memory(reduced, &quote!(S));
    let contact = contact::held(emission);
    let turning = reduced.turning.iter().map(|&body| &emission.model.bodies[body].name.text);
    let turning = emission.text(quoted(turning));
    let followed = emission.text(quoted(reduced.followed.iter().map(|(name, _)| name)));
    let (turns, is_loose) = (number(emission.model.turns.len()), facts::is_loose(emission.model, reduced));
    let revolutions = turns::of_charts(emission, reduced);
    let remember = remember(emission, reduced);
    let found = emission.list(reduced.charts.iter().map(|chart| format!("&{:?}", chart.found)));
    let closing = emission.list(reduced.charts.iter().map(|chart| format!("&[{}]", quoted(&chart.closing))));
    let of_held = |function: &str, arguments: TokenStream, free: TokenStream| {
        in_held(reduced, &quote!(held), &free, |k| {
            let function = format_ident!("{function}_{k}");
            quote!(self.#function(t, held, m, x, #arguments))
        })
    };
    let zero = quote!(S::lit(0.0));
    let pose = of_held("pose", quote!(&mut q, &mut v), quote!({ (q, v) = (*free_q, *free_v); #zero }));
    let numbered = |function: &str, arguments: TokenStream| {
        by_number(reduced, |k| {
            let function = format_ident!("{function}_{k}");
            quote!(self.#function(t, q, v, #arguments))
        })
    };
    let remember_pose = numbered("remember_pose", quote!(&mut memory));
    let project = numbered("to_chart", quote!(x));
    quote! {
        impl<S: Real> rt::charts::Charted for #name<S> {
            type Input = Input<S>;
            type Switches = [S; #switches];
            type Turns = [i32; #turns];
            type Contact = #contact;
            type Continuation = #memory;
            type Q = [S; #nq];
            const CHARTS: rt::charts::Charts = rt::charts::Charts {
                count: #charts,
                revolutions: &[#revolutions],
                is_loose: #is_loose,
                turning: &[#turning],
                found: &[#found],
                iterated: &[#followed],
                closing: &[#closing],
            };

            fn pose(&self, t: S, held: &Self::U, x: &[S; #length]) -> ([S; #nq], [S; #nq], S) {
                let (mut q, mut v) = ([S::lit(0.0); #nq], [S::lit(0.0); #nq]);
                let measure = #pose;
                (q, v, measure)
            }
            fn continuation(&self, t: S, held: &Self::U, x: &[S; #length]) -> (Self::Continuation, S) {
                self.remember_(t, held, x)
            }
            fn continuation_at(&self, chart: usize, t: S, q: &[S; #nq], v: &[S; #nq]) -> (Self::Continuation, S) {
                let mut memory: Self::Continuation = rt::charts::ContinuationData::nothing();
                let measure = #remember_pose;
                (memory, measure)
            }
            fn to_chart(&self, chart: usize, t: S, q: &[S; #nq], v: &[S; #nq], x: &mut [S; #length]) {
                #project
            }
        }

        #remember
    }
}

/// `Charted::continuation` for numbers of several lanes too.
fn remember(emission: &Emission, reduced: &Reduced) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let memory = memory(reduced, &quote!(S));
    let measure = in_held(reduced, &quote!(held), &quote!(S::lit(0.0)), |k| {
        let function = format_ident!("remember_{k}");
        quote!(self.#function(t, held, m, x, &mut memory))
    });
    quote! {
        impl<S: Scalar> #name<S> {
            fn remember_(&self, t: S, held: &Held<S>, x: &[S; #length]) -> (#memory, S) {
                let mut memory: #memory = rt::charts::ContinuationData::nothing();
                let measure = #measure;
                (memory, measure)
            }
        }
    }
}

/// A call that depends on the chart that `held` holds, where `m` is what is remembered; `free` stands for it without a chart.
pub(crate) fn in_held(
    reduced: &Reduced,
    held: &TokenStream,
    free: &TokenStream,
    call: impl Fn(usize) -> TokenStream,
) -> TokenStream {
    let last = reduced.charts.len() - 1;
    let (numbers, calls) = ((0..last).map(number), (0..last).map(&call));
    let other = call(last);
    quote! {
        match &#held.of_loops {
            #(rt::charts::OfLoops::InChart { chart: #numbers, continuation: m } => #calls,)*
            rt::charts::OfLoops::InChart { continuation: m, .. } => #other,
            rt::charts::OfLoops::Free { q: free_q, v: free_v } => #free,
        }
    }
}

/// How a function is called that each chart has, in the one that is held; `without` stands where there is none.
pub(crate) fn call(
    emission: &Emission,
    function: &str,
    arguments: &TokenStream,
    without: &TokenStream,
) -> TokenStream {
    let of_chart = |k: usize| {
        let function = emission.in_chart(function, k);
        quote!(self.#function(#arguments))
    };
    match emission.form {
        Form::Loops(reduced) => in_held(reduced, &quote!(u), without, of_chart),
        Form::Tree(_) | Form::Absolute => of_chart(0),
    }
}

/// A call that depends on the number of a chart; none to choose from costs nothing.
fn by_number(reduced: &Reduced, call: impl Fn(usize) -> TokenStream) -> TokenStream {
    let last = reduced.charts.len() - 1;
    if last == 0 {
        return call(0);
    }
    let (numbers, calls) = ((0..last).map(number), (0..last).map(&call));
    let other = call(last);
    quote!(match chart { #(#numbers => #calls,)* _ => #other })
}
