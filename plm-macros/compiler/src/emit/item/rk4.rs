//! W. Kutta's step by itself: a straight line where the rate is short.
//!
//! The state is moved on where it stands. The general code makes the step again where angles have many turns, in other charts than
//! the first, and where a loop is open.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use proc_macro2::{Ident, TokenStream};

use super::super::function::{direct_angles, is_straight};
use super::super::{Emission, Form, Sizes};
use super::step::locals;

/// The stages: time, state and rate of each, and the state by its name.
const STAGES: [[&str; 4]; 4] = [
    ["t", "x", "k1", "x"],
    ["t + half", "&x2", "k2", "x2"],
    ["t + half", "&x3", "k3", "x3"],
    ["t + h", "&x4", "k4", "x4"],
];

/// The step as a function of the mechanism.
pub(super) fn rk4(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let straight = is_straight(emission).then(|| straight(emission));
    let body = if straight.is_some() {
        quote! {
            let (end, health) = match self.straight_rk4(t, u, x, h) {
                Some(made) => made,
                None => rt::step::rk4(self, t, u, *x, h),
            };
        }
    } else {
        let formula = formula(emission, |[t, x, k, _]| format!("self.rate({t}, u, {x}, &mut {k})"));
        quote! {
            use rt::Rate;
            #formula
        }
    };
    quote! {
        impl<S: Real> #name<S> {
            /// The formula of W. Kutta.
            #[inline]
            fn step_rk4(&self, t: S, u: &Held<S>, x: &mut [S; #length], h: S) -> rt::Health<S> {
                #body
                *x = end;
                health
            }
            #straight
        }
    }
}

/// The step in the first chart, with angles whose sines and cosines need no branch.
fn straight(emission: &Emission) -> TokenStream {
    let length = &emission.sizes.length;
    let (chart, rate) = match emission.form {
        Form::Loops(reduced) => (reduced.charts.first(), "self.motion_0::<true>"),
        Form::Tree(chart) => (Some(chart), "self.motion::<true>"),
        Form::Absolute => (None, ""),
    };
    let angles: Vec<usize> = chart.into_iter().flat_map(direct_angles).map(|(place, _)| place).collect_vec();
    let of_stage = |x: &str| angles.iter().map(|k| format!("{x}[{k}]")).collect_vec().join(", ");
    let is_loop = emission.loops().is_some();
    // Each look is a branch. Without any, compilers mix the stages, and run out of registers where there are several angles.
    let looks_each = angles.len() > 1;
    let formula = formula(emission, |[t, x, k, name]| {
        let health = if is_loop {
            format!("rt::Health({rate}({t}, u, m, {x}, &mut {k}))")
        } else {
            format!("{rate}({t}, u, {x}, &mut {k}); rt::Health::perfect()")
        };
        let look = format!("if !S::are_direct([{}]) {{ return None; }}", of_stage(name));
        format!("{{ {} {health} }}", if looks_each { look } else { String::new() })
    });
    let in_first = is_loop.then(|| {
        quote!(let rt::charts::OfLoops::InChart { chart: 0, continuation: m } = &u.of_loops else { return None };)
    });
    let all = emission.list(STAGES.map_each(|[_, _, _, name]| of_stage(name)));
    let direct = (!looks_each && !angles.is_empty()).then(|| quote!(&& S::are_direct([#all])));
    quote! {
        /// The step without branches; none where it needs one.
        #[inline(always)]
        fn straight_rk4(
            &self, t: S, u: &Held<S>, x: &[S; #length], h: S
        ) -> Option<([S; #length], rt::Health<S>)> {
            #in_first
            #formula
            (health.is_good() #direct).then_some((end, health))
        }
    }
}

/// W. Kutta's formula from `x` to `end`, to the bit that of `plm_runtime::Rk4Formula`, with `rate` as an expression for each
/// stage. The rates of positions are the velocities of the stages, whose sum is 6 v + h (k1 + k2 + k3).
fn formula(emission: &Emission, rate: impl Fn([&str; 4]) -> String) -> TokenStream {
    let Sizes { length, second_order, .. } = &emission.sizes;
    let names = locals(emission);
    let n = second_order / 2;
    let stage = |factor: &str, k: &str| {
        let entry = |(i, x): (usize, &Ident)| format!("{factor}.mul_add({k}[{i}], {x})");
        emission.lines(names.iter().enumerate().map(entry))
    };
    let [second, third, fourth] =
        [("half", "k1"), ("half", "k2"), ("h", "k3")].map_each(|(factor, k)| stage(factor, k));
    let end = names.iter().enumerate().map(|(i, x)| match names.get(n + i) {
        Some(v) if i < n => {
            let k = n + i;
            format!("h.mul_add(sixth.mul_add(k1[{k}] + (k2[{k}] + k3[{k}]), {v}), {x})")
        }
        _ => format!("sixth.mul_add(two.mul_add(k2[{i}] + k3[{i}], k1[{i}] + k4[{i}]), {x})"),
    });
    let end = emission.lines(end);
    let [r1, r2, r3, r4] = STAGES.map_each(|stage| emission.text(rate(stage)));
    quote! {
        let (half, two, sixth) = (S::lit(0.5) * h, S::lit(2.0), S::lit(1.0 / 6.0) * h);
        let [#(#names),*] = *x;
        let zero = [S::lit(0.0); #length];
        let (mut k1, mut k2, mut k3, mut k4) = (zero, zero, zero, zero);
        let health = #r1;
        let x2 = [#second];
        let health = health.worst(#r2);
        let x3 = [#third];
        let health = health.worst(#r3);
        let x4 = [#fourth];
        let health = health.worst(#r4);
        let end = [#end];
    }
}
