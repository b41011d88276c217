//! The linearly implicit step: the equations linearised where it begins, eliminated entry by entry, solved four times.

use crate::collect::CollectVec;
use crate::emit::template::{joined, quote};
use proc_macro2::{Literal, TokenStream};

use super::super::bindings::Origin;
use super::super::contract::charted::call;
use super::super::contract::linear::at_state;
use super::super::function::function;
use super::super::{Emission, Form, Sizes, number};
use crate::formulate::{Chart, Function, Resolvent};

/// `step_linearly_implicit` and the linear algebra that belongs to it.
pub(crate) fn linearly_implicit(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let systems = emission.systems();
    let resolvents: Vec<&Resolvent> =
        systems.iter().filter_map(|system| system.linearised.resolvent.as_ref()).collect_vec();
    if resolvents.is_empty() {
        return by_matrix(emission);
    }
    let entries = number(resolvents.iter().map(|resolvent| resolvent.e.len()).max().unwrap_or(0));
    let coefficients = emission.coefficients();
    let numbered = resolvents.iter().enumerate();
    let algebra =
        numbered.map(|(k, resolvent)| linear_algebra(emission, (k, resolvent), (&coefficients, &entries)));
    let algebra = joined(algebra.collect_vec());
    let (rate, linearise) = at_state(emission, &quote!(&mut c));
    let (eliminate, solve) = calls(emission);
    let (by_t, slopes) = by_time(emission);
    quote! {
        impl<S: Real> #name<S> {
            /// The equations are linearised once; their elimination serves the four stages.
            fn step_linearly_implicit(
                &self, t: S, u: &Held<S>, x: &mut [S; #length], h: S
            ) -> Result<rt::Health<S>, Fault> {
                use rt::Rate;
                use rt::method::Ros34Pw2Formula as Formula;
                let zero = [S::lit(0.0); #length];
                let mut dx = zero;
                #rate
                let (mut c, mut e) = ([S::lit(0.0); #coefficients], [S::lit(0.0); #entries]);
                let lambda = Formula::lambda(h);
                let inverse = S::lit(1.0) / lambda;
                #linearise;
                let growth = #eliminate;
                rt::step::solvable(t, growth, #length)?;
                #by_t
                let mut worst = health;
                let rates = |stage, t, x: &[S; #length], k: &mut [S; #length]| match stage {
                    0 => *k = dx,
                    _ => worst = worst.worst(self.rate(t, u, x, k)),
                };
                let solve = |r: &[S; #length], k: &mut [S; #length]| #solve;
                let trial = Formula::step((t, h), (x, &by_t), rates, solve);
                rt::step::take(self, (t, h), x, &trial)?;
                Ok(worst)
            }
        }
        impl<S: Scalar> #name<S> { #algebra #slopes }
    }
}

/// How elimination and solution are called.
fn calls(emission: &Emission) -> (TokenStream, TokenStream) {
    let (eliminate, solve) = (quote!(&c, lambda, inverse, &mut e), quote!(&c, &e, inverse, r, k));
    // Without a chart no step is begun.
    let without = quote!(S::lit(f64::NAN));
    (call(emission, "eliminated", &eliminate, &without), call(emission, "solved", &solve, &quote!({})))
}

/// The derivative of the rate by the time, where it depends on it, and the functions that give it.
fn by_time(emission: &Emission) -> (TokenStream, TokenStream) {
    if !emission.rate_knows_time() {
        return (quote!(let by_t = zero;), TokenStream::new());
    }
    let charts: Vec<&Chart> = match emission.form {
        Form::Absolute => Vec::new(),
        Form::Tree(chart) => vec![chart],
        Form::Loops(reduced) => reduced.charts.iter().collect_vec(),
    };
    let found: Option<Vec<&Function>> = charts.iter().map(|chart| chart.by_time.as_ref()).collect();
    let Some(functions) = found.filter(|functions| !functions.is_empty()) else {
        let by_dual_numbers = quote! {
            let mut by_t = zero;
            let _ = rt::Linear::jvp(self, t, u, x, (S::lit(1.0), &zero), &mut by_t);
        };
        return (by_dual_numbers, TokenStream::new());
    };
    let ([memory, m], length) = (emission.memory_argument(), &emission.sizes.length);
    let call = call(emission, "by_time", &quote!(t, u, #m x, &mut by_t), &quote!({}));
    let functions = charts.iter().zip(functions).enumerate().map(|(k, (chart, slopes))| {
        let name = emission.in_chart("by_time", k);
        function(
            emission,
            "The derivative of the rate by the time; zeros are left out.",
            &quote!(fn #name(&self, t: S, u: &Held<S>, #memory x: &[S; #length], by_t: &mut [S; #length])),
            (slopes, Origin::Chart(chart)),
        )
    });
    (quote!(let mut by_t = zero; #call;), joined(functions.collect_vec()))
}

/// Elimination and solution of the linear systems of a chart.
fn linear_algebra(
    emission: &Emission,
    (chart, resolvent): (usize, &Resolvent),
    (coefficients, entries): (&Literal, &Literal),
) -> TokenStream {
    let length = &emission.sizes.length;
    let name = emission.in_chart("eliminated", chart);
    let eliminated = function(
        emission,
        "Eliminates the linearised equations for a lambda; returns the largest growth, by which a product was larger than the\npivot that it was taken from.",
        &quote! {
            fn #name(&self, c: &[S; #coefficients], lambda: S, inverse: S, e: &mut [S; #entries]) -> S
        },
        (&resolvent.eliminate, Origin::Resolvent(resolvent)),
    );
    let name = emission.in_chart("solved", chart);
    let solved = function(
        emission,
        "Solves `(lambda I - df/dx) k = r`.",
        &quote! {
            fn #name(
                &self, c: &[S; #coefficients], e: &[S; #entries], inverse: S, r: &[S; #length], k: &mut [S; #length]
            )
        },
        (&resolvent.solve, Origin::Resolvent(resolvent)),
    );
    quote!(#eliminated #solved)
}

/// The step with the full matrix of derivatives, where the equations are not linearised: forces that read reactions.
fn by_matrix(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    quote! {
        impl<S: Real> #name<S> {
            /// The matrix of derivatives is decomposed once for the four stages.
            fn step_linearly_implicit(
                &self, t: S, u: &Held<S>, x: &mut [S; #length], h: S
            ) -> Result<rt::Health<S>, Fault> {
                use rt::Rate;
                use rt::linalg::Derivatives;
                use rt::method::Ros34Pw2Formula as Formula;
                let (mut by_x, mut by_t) = (<[[S; #length]; #length]>::zeros(), [S::lit(0.0); #length]);
                let mut health = rt::Linear::jacobian(self, t, u, x, &mut by_x, Some(&mut by_t));
                let freedom = <Self as rt::Rate>::NQ;
                let resolvent = by_x.resolvent(Formula::lambda(h), freedom);
                let resolvent = resolvent.ok_or_else(|| rt::step::singular(t, #length))?;
                let rates = |_, t, x: &[S; #length], k: &mut [S; #length]| {
                    health = health.worst(self.rate(t, u, x, k));
                };
                let solve = |r: &[S; #length], k: &mut [S; #length]| {
                    by_x.resolve(&resolvent, freedom, |i| r[i], |i, s| k[i] = s);
                };
                let trial = Formula::step((t, h), (x, &by_t), rates, solve);
                rt::step::take(self, (t, h), x, &trial)?;
                Ok(health)
            }
        }
    }
}
