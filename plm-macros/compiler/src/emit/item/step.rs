//! Steps that the user ordered: a method of the state, and the formula as a function of the mechanism.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::{joined, quote};
use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

use super::super::lower::names::Names;
use super::super::{Emission, Form, Sizes, docs, number};
use super::{implicit, rk4};
use crate::model::Step;

/// The ordered steps.
pub(crate) fn steps(emission: &Emission) -> TokenStream {
    joined(emission.model.steps.iter().map(|&step| one(emission, step)).collect_vec())
}

/// A step: its documentation and its formula.
fn one(emission: &Emission, step: Step) -> TokenStream {
    let (method, source, formula) = match step {
        Step::Rk4 => ("step_rk4", "the classical Runge-Kutta method of order 4", rk4::rk4(emission)),
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
        Step::MoreauJean => return moreau_jean(emission),
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

/// The step of the runtime: rows of contact are rows of arrays.
fn moreau_jean(emission: &Emission) -> TokenStream {
    let [docs, with_theta, evaluated] = [
        "by the time stepping of Moreau and Jean with theta = 1/2.",
        "by that with `theta`, 1/2 to 1.",
        "by that with `theta` and so many evaluations of the equations of motion, one or more.",
    ]
    .map_each(|by| docs::docs(emission, &format!("One step of `h`, s, {by}")));
    quote! {
        impl<S: Real> State<S> {
            #docs
            ///
            /// Contact needs no event; the result says by how much its laws are not met. Conditions switch at the end of the step; what
            /// is past a singular pose is left to [`Sim`].
            ///
            /// # Errors
            /// When the step cannot be made; the state then stays as it was.
            pub fn step_moreau_jean(&mut self, h: S) -> Result<rt::contact::Solution<S>, Fault> {
                rt::step::moreau_jean::<_, _, 1>(self, h, S::lit(0.5))
            }

            #with_theta
            ///
            /// # Errors
            /// When the step cannot be made; the state then stays as it was.
            pub fn step_moreau_jean_with(&mut self, h: S, theta: S) -> Result<rt::contact::Solution<S>, Fault> {
                rt::step::moreau_jean::<_, _, 1>(self, h, theta)
            }

            #evaluated
            ///
            /// # Errors
            /// When the step cannot be made; the state then stays as it was.
            pub fn step_moreau_jean_evaluated<const EVALUATIONS: usize>(
                &mut self, h: S, theta: S
            ) -> Result<rt::contact::Solution<S>, Fault> {
                rt::step::moreau_jean::<_, _, EVALUATIONS>(self, h, theta)
            }
        }
    }
}

/// v by its rate, q by the new v, first-order states by their rate.
fn semi_implicit_euler(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, second_order, .. }, .. } = emission;
    let names = locals(emission);
    let n = second_order / 2;
    // The type is written out: nothing else tells that of no numbers at all.
    let count = number(names.len() - n);
    let moved = |(i, x): (usize, &Ident)| format!("h.mul_add(k[{i}], {x})");
    let rest = emission.lines(names.iter().enumerate().skip(n).map(moved));
    let velocities = &names[n..2 * n];
    let after = &names[n..];
    let positions = names.iter().zip(velocities).map(|(q, v)| format!("h.mul_add({v}, {q})"));
    let positions = emission.lines(positions);
    quote! {
        impl<S: Scalar> #name<S> {
            /// Velocities by their rates, positions by the new velocities.
            fn step_semi_implicit_euler(
                &self, t: S, u: &Held<S>, x: &mut [S; #length], h: S
            ) -> rt::Health<S> {
                use rt::Rate;
                let [#(#names),*] = *x;
                let mut k = [S::lit(0.0); #length];
                let health = self.rate(t, u, x, &mut k);
                let [#(#after),*]: [S; #count] = [#rest];
                *x = [#positions #(#after),*];
                health
            }
        }
    }
}

/// Names for the numbers of the state.
pub(super) fn locals(emission: &Emission) -> Vec<Ident> {
    let reserved = [
        "t", "u", "x", "h", "k", "k1", "k2", "k3", "k4", "half", "two", "sixth", "zero", "x2", "x3", "x4",
        "m", "end", "health",
    ];
    let mut names = Names::with_reserved(&reserved);
    let is_one_chart = !matches!(emission.form, Form::Loops(reduced) if reduced.charts.len() > 1);
    let of_state =
        crate::facts::state::names(emission.model, emission.equations, emission.reduced).into_iter();
    let text = of_state.map(|name| if is_one_chart { name } else { "y".to_owned() });
    text.map(|name| names.unique(&name)).map(|name| format_ident!("{name}")).collect_vec()
}
