//! Rates of two stages in a row, whose positions are known before: what depends on these alone is computed side by side, in
//! vectors of two. Bits are those of two single rates.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use plm_cas::Expr;
use proc_macro2::TokenStream;
use quote::format_ident;

use super::super::bindings::Origin;
use super::super::lower::{Around, Part, Parts, parts};
use super::super::{Emission, Form, Sizes, number};
use super::rate;
use crate::formulate::{Chart, Function, Place};

/// Operations side by side that a value must save which goes from there to the rates: it is stored and read twice, and what
/// reads it waits. Instructions of a step in pairs over those without (x86-64-v3 with `fma`): Andrews' mechanism (63
/// operations a value) 0.55, four-bar linkage (20) 0.63, slider-crank (13) 0.67; but chains of 4 bars (3.9) 1.08, of 16
/// (5.0) 0.94, of 64 (5.1) 1.29.
const LEAST: usize = 6;
/// Operations that a function by itself costs.
const CALL: usize = 20;

/// Operations up to which pairs pay in numbers of eight lanes: what waits for a root or a quotient is done beside that of the
/// other stage, but all of it goes through memory. Time of a step in pairs over that without: four-bar linkage (80 operations)
/// 0.93, slider-crank 0.92, Andrews' mechanism 1.06.
const MOST_IN_LANES: usize = 150;

/// Coordinates whose values in two stages are handed over one by one.
const FEW: usize = 2;

/// The two parts of the rate in the first chart, if it pays to have them.
fn of_rate(emission: &Emission) -> Option<Parts> {
    let Emission { equations, program, .. } = emission;
    if emission.rerolled {
        return None;
    }
    let (rate, origin, velocities): (&Function, Origin, &[Expr]) = match emission.form {
        Form::Absolute => (&program.dynamics, Origin::Arguments, &equations.v),
        Form::Tree(chart) => in_chart(chart),
        Form::Loops(reduced) => in_chart(reduced.charts.first()?),
    };
    let is_rate = |(place, _): &&(Place, Expr)| matches!(place, Place::Element("dx", _) | Place::Value);
    let rate = Function::of_results(rate.results.iter().filter(is_rate).cloned().collect_vec());
    let moving: Vec<Expr> = velocities.iter().chain(&equations.x).copied().collect_vec();
    let bindings = emission.bindings(origin);
    let of_two = bindings.iter().map(|(&symbol, text)| (symbol, in_both(text))).collect();
    let reserved = ["t", "u", "m", "x", "dx", "shared", "lit", "by"];
    let around =
        |scalar| Around { reserved: &reserved, by_reference: true, scalar, direct: None, rerolled: false };
    let parts =
        parts(&rate, (&moving, ".of::<SECOND>()"), (&of_two, &around("Two::<S>")), (&bindings, &around("S")));
    let pays = parts.still.count.total() > CALL + LEAST * parts.shared;
    pays.then_some(parts)
}

fn in_chart(chart: &Chart) -> (&Function, Origin<'_>, &[Expr]) {
    (&chart.rate, Origin::Chart(chart), &chart.y_dot)
}

/// Prefixes of the values that both stages share.
const HELD: [&str; 4] = ["self.", "u.", "m.", "S::"];

/// Text of a symbol in two stages; time and state differ.
fn in_both(text: &str) -> String {
    let is_held = HELD.iter().any(|start| text.starts_with(start));
    if is_held { format!("Two::both({text})") } else { text.to_owned() }
}

/// The part of `Rate` for pairs of stages, and the functions after it.
pub(super) fn pairs(emission: &Emission) -> [TokenStream; 2] {
    let Some(parts) = of_rate(emission) else { return Default::default() };
    [rate_pair(emission, &parts), functions(emission, &parts)]
}

fn rate_pair(emission: &Emission, parts: &Parts) -> TokenStream {
    let Sizes { length, .. } = &emission.sizes;
    let inlined = rate::inlined(emission);
    let in_first = emission.loops().map(|_| {
        quote! {
            let rt::charts::OfLoops::InChart { chart: 0, continuation: m } = &u.of_loops else {
                let (k, health) = rt::system::rate_aside(self, t[0], u, *x[0]);
                dx[0] = k;
                let (k, other) = rt::system::rate_aside(self, t[1], u, second(&k));
                dx[1] = k;
                return health.worst(other);
            };
        }
    });
    let still = reads(emission, &parts.still);
    let given = still.iter().map(|[_, given]| given);
    let ([_, memory], [.., positions]) = (emission.memory_argument(), positions(emission));
    let [one, other] = [
        quote!(self.rate_at_pose::<false>(t[0], u, #memory x[0], &shared, &mut dx[0])),
        quote!(self.rate_at_pose::<true>(t[1], u, #memory &next, &shared, &mut dx[1])),
    ];
    let in_lanes = parts.still.count.total() <= MOST_IN_LANES;
    quote! {
        const PAIRED: bool = S::REGISTERS.pays_in_pairs(#in_lanes);

        #inlined
        fn rate_pair(
            &self, t: [S; 2], u: &Self::U, x: [&[S; #length]; 2], dx: &mut [[S; #length]; 2],
            second: impl FnOnce(&[S; #length]) -> [S; #length]
        ) -> rt::Health<S> {
            #in_first
            let shared = Self::of_two_poses(#(#given)* #positions);
            let health = #one;
            let next = second(&dx[0]);
            health.worst(#other)
        }
    }
}

fn functions(emission: &Emission, parts: &Parts) -> TokenStream {
    let Emission { name, sizes: Sizes { length, second_order, .. }, .. } = emission;
    let (shared, freedom) = (number(parts.shared), number(second_order / 2));
    let [still, moving] = [&parts.still, &parts.moving].map_each(|part| emission.text(part.text.clone()));
    let arguments = reads(emission, &parts.still);
    let declared = arguments.iter().map(|[declared, _]| declared);
    let [positions, x, _] = positions(emission);
    let ([memory, _], inlined) = (emission.memory_argument(), rate::inlined(emission));
    let health = if matches!(emission.form, Form::Tree(_)) {
        quote!({ #moving } rt::Health::perfect())
    } else {
        quote!(rt::Health({ #moving }))
    };
    quote! {
        impl<S: Scalar> #name<S> {
            /// Values of the poses of two stages that their rates share. Compilers begin to build vectors where results are stored: a
            /// function of its own.
            #[inline(never)]
            fn of_two_poses(#(#declared)* #positions) -> [Two<S>; #shared] {
                let x: &[Two<S>; #freedom] = &#x;
                #still
            }

            /// The rate in one of two stages, at its pose.
            #inlined
            fn rate_at_pose<const SECOND: bool>(
                &self, t: S, u: &Held<S>, #memory x: &[S; #length], shared: &[Two<S>; #shared], dx: &mut [S; #length]
            ) -> rt::Health<S> {
                #health
            }
        }
    }
}

/// Arguments of the first part beside the positions, as declared and as handed over: unread ones would be handed over all
/// the same, by a function that is not inlined.
fn reads(emission: &Emission, still: &Part) -> Vec<[TokenStream; 2]> {
    let reads = |start: &str| still.symbols.iter().any(|text| text.contains(start));
    let [memory, remembered] = emission.memory_argument();
    let all = [
        (reads("self."), quote!(&self,), quote!(self,)),
        (reads("u."), quote!(u: &Held<S>,), quote!(u,)),
        (reads("(m."), quote!(#memory), quote!(#remembered)),
        (still.symbols.iter().any(|text| text == "t"), quote!(t: Two<S>,), quote!(Two(t),)),
    ];
    all.into_iter().filter(|argument| argument.0).map(|(_, declared, given)| [declared, given]).collect()
}

/// The positions in two stages: as declared, as an array of both, and as handed over. Few numbers go in registers.
fn positions(emission: &Emission) -> [TokenStream; 3] {
    let Sizes { length, second_order, .. } = &emission.sizes;
    if second_order / 2 > FEW {
        let declared = quote!(first: &[S; #length], second: &[S; #length]);
        return [declared, quote!(Two::beginning([first, second])), quote!(x[0], x[1])];
    }
    let places: Vec<_> = (0..second_order / 2).map(number).collect_vec();
    let [first, second] = ["first", "second"].map_each(|stage| {
        places.iter().map(|place| format_ident!("{stage}_{}", place.to_string())).collect_vec()
    });
    let declared = quote!(#(#first: S, #second: S),*);
    [declared, quote!([#(Two([#first, #second])),*]), quote!(#(x[0][#places], x[1][#places]),*)]
}
