//! Steps that the user ordered: a method of the state, and the formula as a function of the mechanism.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::super::contract::rate;
use super::super::lower::names::Names;
use super::super::{Emission, Form, Sizes, docs};
use super::implicit;
use crate::model::Step;

/// The ordered steps.
pub(crate) fn steps(emission: &Emission) -> TokenStream {
    emission.model.steps.iter().map(|&step| one(emission, step)).collect()
}

/// What a step says of itself, and its formula.
fn one(emission: &Emission, step: Step) -> TokenStream {
    let (method, source, formula) = match step {
        Step::Rk4 => ("step_rk4", "the classical Runge-Kutta method of order 4", rk4(emission)),
        Step::SemiImplicitEuler => (
            "step_semi_implicit_euler",
            "the semi-implicit Euler method, of order 1",
            semi_implicit_euler(emission),
        ),
        Step::LinearlyImplicit => (
            "step_linearly_implicit",
            "ROS34PW2, a linearly implicit method of order 3 for stiff equations",
            implicit::linearly_implicit(emission),
        ),
    };
    let (name, docs) = (&emission.name, docs::docs(emission, &format!("One step of `h`, s, by {source}.")));
    let method = Ident::new(method, proc_macro2::Span::call_site());
    let result = if step == Step::LinearlyImplicit {
        quote!(mechanism.#method(t, u, x, h))
    } else {
        quote!(Ok(mechanism.#method(t, u, x, h)))
    };
    quote! {
        impl<S: Real> State<S> {
            #docs
            ///
            /// Conditions switch at the end of the step; what is past a singular pose is left to [`Sim`].
            ///
            /// # Errors
            /// When the step cannot be made; the state then stays as it was.
            pub fn #method(&mut self, h: S) -> Result<(), Fault> {
                rt::step::step(self, h, |mechanism: &#name<S>, t, u, x| #result)
            }
        }
        #formula
    }
}

/// W. Kutta's formula, to the bit that of `plm_runtime::Rk4Formula`. The rates of positions are the velocities of the stages,
/// whose sum is 6 v + h (k1 + k2 + k3).
fn rk4(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, second_order, .. }, .. } = emission;
    let names = locals(emission);
    let n = second_order / 2;
    let stage = |factor: &str, k: &str| {
        let entry = |(i, x): (usize, &Ident)| format!("{factor}.mul_add({k}[{i}], {x})");
        emission.lines(names.iter().enumerate().map(entry))
    };
    let [second, third, fourth] =
        [("half", "k1"), ("half", "k2"), ("h", "k3")].map(|(factor, k)| stage(factor, k));
    let end = names.iter().enumerate().map(|(i, x)| match names.get(n + i) {
        Some(v) if i < n => {
            let k = n + i;
            format!("h.mul_add(sixth.mul_add(k1[{k}] + (k2[{k}] + k3[{k}]), {v}), {x})")
        }
        _ => format!("sixth.mul_add(two.mul_add(k2[{i}] + k3[{i}], k1[{i}] + k4[{i}]), {x})"),
    });
    let end = emission.lines(end);
    let [guard, of_stage] = ["x", "stage"].map(|state| guard(emission, state));
    let in_first = in_first_chart(emission);
    quote! {
        impl<S: Real> #name<S> {
            /// The formula of W. Kutta.
            #[inline]
            fn step_rk4(&self, t: S, u: &Held<S>, x: &mut [S; #length], h: S) -> rt::Health<S> {
                let (next, health) = match self.straight_rk4(t, u, x, h) {
                    Some(made) => made,
                    None => rt::step::rk4(self, t, u, *x, h),
                };
                *x = next;
                health
            }

            /// The same as a straight line; none where it is no such line.
            #[inline(always)]
            fn straight_rk4(
                &self, t: S, u: &Held<S>, x: &[S; #length], h: S
            ) -> Option<([S; #length], rt::Health<S>)> {
                use rt::lanes::Rate;
                #in_first
                #guard
                let (half, two, sixth) = (S::lit(0.5) * h, S::lit(2.0), S::lit(1.0 / 6.0) * h);
                let [#(#names),*] = *x;
                let zero = [S::lit(0.0); #length];
                let (mut k1, mut k2, mut k3, mut k4) = (zero, zero, zero, zero);
                let health = self.rate(t, u, x, &mut k1);
                let stage = [#second];
                #of_stage
                let health = health.worst(self.rate(t + half, u, &stage, &mut k2));
                let stage = [#third];
                #of_stage
                let health = health.worst(self.rate(t + half, u, &stage, &mut k3));
                let stage = [#fourth];
                #of_stage
                let health = health.worst(self.rate(t + h, u, &stage, &mut k4));
                Some(([#end], health))
            }
        }
    }
}

/// Leaves the straight line in other charts than the first, whose rate is a call.
fn in_first_chart(emission: &Emission) -> Option<TokenStream> {
    let leaves = emission.loops().is_some() && rate::is_short(emission);
    leaves
        .then(|| quote!(let rt::charts::OfLoops::InChart { chart: 0, .. } = u.of_loops else { return None };))
}

/// Leaves the straight line where an angle of a state has many turns: behind that, rustc knows that sine and cosine take no
/// branch. Only where the rate is a part of each stage.
fn guard(emission: &Emission, state: &str) -> Option<TokenStream> {
    let turning = match emission.form {
        Form::Tree(chart) => &chart.turning,
        Form::Loops(reduced) => &reduced.first()?.turning,
        Form::Absolute => return None,
    };
    let angles = turning.iter().enumerate().filter(|(_, body)| body.is_some());
    let angles: Vec<String> = angles.map(|(k, _)| format!("{state}[{k}].is_direct()")).collect();
    let guards = rate::is_short(emission) && !angles.is_empty();
    let are_direct = emission.text(angles.join(" && "));
    guards.then(|| quote!(if !(#are_direct) { return None; }))
}

/// v by its rate, q by the new v, first-order states by their rate.
fn semi_implicit_euler(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, second_order, .. }, .. } = emission;
    let names = locals(emission);
    let n = second_order / 2;
    let moved = |(i, x): (usize, &Ident)| format!("h.mul_add(k[{i}], {x})");
    let rest = emission.lines(names.iter().enumerate().skip(n).map(moved));
    let velocities = &names[n..2 * n];
    let behind = &names[n..];
    let positions = names.iter().zip(velocities).map(|(q, v)| format!("h.mul_add({v}, {q})"));
    let positions = emission.lines(positions);
    quote! {
        impl<S: Scalar> #name<S> {
            /// Velocities by their rates, positions by the new velocities.
            fn step_semi_implicit_euler(
                &self, t: S, u: &Held<S>, x: &mut [S; #length], h: S
            ) -> rt::Health<S> {
                use rt::lanes::Rate;
                let [#(#names),*] = *x;
                let mut k = [S::lit(0.0); #length];
                let health = self.rate(t, u, x, &mut k);
                let [#(#behind),*] = [#rest];
                *x = [#positions #(#behind),*];
                health
            }
        }
    }
}

/// Names for the numbers of the state.
fn locals(emission: &Emission) -> Vec<Ident> {
    let reserved = ["t", "u", "x", "h", "k", "k1", "k2", "k3", "k4", "half", "two", "sixth", "zero", "stage"];
    let mut names = Names::with_reserved(&reserved);
    let is_one_chart = !matches!(emission.form, Form::Loops(reduced) if reduced.charts.len() > 1);
    let of_state = super::super::contract::system::names_of_state(emission).into_iter();
    let text = of_state.map(|name| if is_one_chart { name } else { "y".to_owned() });
    text.map(|name| names.unique(&name)).map(|name| format_ident!("{name}")).collect()
}
