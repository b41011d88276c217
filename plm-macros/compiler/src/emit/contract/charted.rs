//! `Charted`: the runtime's view of charts.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::super::{Emission, Sizes, number, quoted};
use crate::formulate::Reduced;

/// `Charted`, if loops are solved in charts.
pub(crate) fn charted(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { nq, length, .. }, .. } = emission;
    let Some(reduced) = emission.loops() else { return TokenStream::new() };
    let [charts, memory, before_areas, before_followed] =
        [reduced.charts.len(), reduced.memory_length, reduced.before_areas, reduced.before_followed]
            .map(number);
    let inputs = emission.inputs(&quote!(S));
    let [turning, followed] = [&reduced.turning, &reduced.followed].map(|names| emission.text(quoted(names)));
    let closing = emission.list(reduced.charts.iter().map(|chart| format!("&[{}]", quoted(&chart.closing))));
    let chart = if reduced.charts.len() == 1 { quote!(_chart) } else { quote!(chart) };
    let of = |chart: TokenStream, function: &str, arguments: TokenStream| {
        chosen(reduced, &chart, |k| {
            let function = format_ident!("{function}_{k}");
            quote!(self.#function(#arguments))
        })
    };
    let held = quote!(t, &held.input, &held.memory, x);
    let pose = of(quote!(held.chart), "pose", quote!(#held, &mut q, &mut v));
    let remember = of(quote!(held.chart), "remember", quote!(#held, &mut memory));
    let remember_pose = of(quote!(chart), "remember_pose", quote!(t, q, v, &mut memory));
    let project = of(quote!(chart), "project", quote!(t, q, v, x));
    quote! {
        impl<S: Real> rt::charts::Charted for #name<S> {
            type Input = #inputs;
            type Memory = [S; #memory];
            type Q = [S; #nq];
            const CHARTS: usize = #charts;
            const BEFORE_AREAS: usize = #before_areas;
            const TURNING: &'static [&'static str] = &[#turning];
            const BEFORE_FOLLOWED: usize = #before_followed;
            const FOLLOWED: &'static [&'static str] = &[#followed];
            const CLOSING: &'static [&'static [&'static str]] = &[#closing];

            fn pose(&self, t: S, held: &Self::U, x: &[S; #length]) -> ([S; #nq], [S; #nq], S) {
                let (mut q, mut v) = ([S::lit(0.0); #nq], [S::lit(0.0); #nq]);
                let measure = #pose;
                (q, v, measure)
            }
            fn remember(&self, t: S, held: &Self::U, x: &[S; #length]) -> ([S; #memory], S) {
                let mut memory = [S::lit(0.0); #memory];
                let measure = #remember;
                (memory, measure)
            }
            fn remember_pose(&self, #chart: usize, t: S, q: &[S; #nq], v: &[S; #nq]) -> ([S; #memory], S) {
                let mut memory = [S::lit(0.0); #memory];
                let measure = #remember_pose;
                (memory, measure)
            }
            fn project(&self, #chart: usize, t: S, q: &[S; #nq], v: &[S; #nq], x: &mut [S; #length]) {
                #project
            }
        }
    }
}

/// A call that depends on the chart; none to choose from costs nothing.
pub(crate) fn chosen(
    reduced: &Reduced,
    chart: &TokenStream,
    call: impl Fn(usize) -> TokenStream,
) -> TokenStream {
    let last = reduced.charts.len() - 1;
    if last == 0 {
        return call(0);
    }
    let (numbers, calls) = ((0..last).map(number), (0..last).map(&call));
    let other = call(last);
    quote!(match #chart { #(#numbers => #calls,)* _ => #other })
}
