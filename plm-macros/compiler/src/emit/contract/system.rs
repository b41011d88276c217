//! `Constraints`, `Switched`, `Labels`: what integrators and the event detector ask for beside the rate.

use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::lower::inline;
use super::super::{Emission, Form, Sizes, quoted, table_compression};
use super::{contact, contact_projection, switched, turns};
use crate::facts::{self, state};
use crate::model::Stabilisation;

/// Traits of `System` beside the rate.
pub(crate) fn system(emission: &Emission) -> TokenStream {
    let (constraints, events, labels) =
        (constraints(emission), switched::switched(emission), labels(emission));
    quote! {
        #constraints
        #events
        #labels
    }
}

/// `Constraints`.
fn constraints(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let solution = match emission.form {
        Form::Absolute => by_rank(emission),
        Form::Tree(_) => TokenStream::new(),
        Form::Loops(_) => in_charts(emission),
    };
    let update = turns::update(emission);
    let stabilisation = if contact::are_there(emission) {
        Some(contact_projection::project(emission))
    } else {
        (!emission.is_reduced()).then(|| stabilisation(emission))
    };
    let energy = (!facts::knows_time(emission.model) && emission.model.has_masses()).then(|| {
        quote! {
            fn energy(&self, t: S, u: &Self::U, x: &[S; #length]) -> Option<rt::Energy<S>> {
                let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
                let (kinetic, gravity) = (state.kinetic_energy(), state.gravity_energy());
                Some(rt::Energy { kinetic, gravity, power: state.load_power() })
            }
        }
    });
    quote! {
        impl<S: Real> rt::Constraints for #name<S> {
            #[inline(always)]
            fn compute<C: rt::Computation>(
                &self,
                times: (Self::S, Self::S),
                u: &Self::U,
                from: (&Self::X, &Self::X),
            ) -> (C::Made<Self::X>, rt::Health<Self::S>) {
                rt::linear::compute::<Self, C>(self, times, u, from)
            }

            #[inline(always)]
            fn ask<Q: rt::Question<Self::S>>(&self, u: &Self::U, question: Q) -> Q::Answer {
                rt::linear::ask::<Self, Q>(self, u, question)
            }
            #solution
            #update
            #stabilisation
            #energy
        }
    }
}

/// `Labels`: the table of names.
fn labels(emission: &Emission) -> TokenStream {
    let Emission { model, name, .. } = emission;
    let (parts, in_charts) = (part_names(emission), names_in_charts(emission));
    let states =
        table_compression::names(emission, &state::names(model, emission.equations, emission.reduced));
    let conditions = (model.guards() > 0 || contact::are_there(emission)).then(|| switched::names(emission));
    let contacts = contact::are_there(emission).then(|| {
        let names = emission.text(quoted(model.contacts.iter().map(|contact| &contact.name)));
        quote!(contacts: &[#names],)
    });
    let of_time = model.switches.iter().filter(|side| side.instant.is_some());
    let instants = emission.text(quoted(of_time.map(|side| &side.name)));
    let instants = (model.switches.len() > model.guards()).then(|| quote!(instants: &[#instants],));
    let chart = in_charts.is_some().then(|| {
        quote! {
            fn chart_of(&self, u: &Self::U) -> Option<usize> {
                rt::held::Loops::<S>::chart(&u.of_loops)
            }
        }
    });
    quote! {
        impl<S: Real> rt::Labels for #name<S> {
            fn labels(&self) -> &'static rt::LabelTable {
                const {
                    &rt::LabelTable {
                        parts: #parts,
                        states: const { &#states },
                        #in_charts
                        #conditions
                        #instants
                        #contacts
                        ..rt::LabelTable::NONE
                    }
                }
            }
            #chart
        }
    }
}

/// Names of coordinates and their rates chart by chart, where there are several charts.
fn names_in_charts(emission: &Emission) -> Option<TokenStream> {
    let charts = &emission.loops()?.charts;
    let coordinates = charts.first().map_or(0, |chart| chart.names.len());
    if charts.len() < 2 || coordinates == 0 {
        return None;
    }
    let mut all = Vec::new();
    for chart in charts {
        all.extend(chart.names.iter().cloned());
        all.extend(chart.names.iter().map(|name| state::rate_of(name)));
    }
    let names = table_compression::names(emission, &all);
    Some(quote!(in_charts: const { &#names },))
}

/// The rate in absolute coordinates where elimination is unhealthy.
fn by_rank(emission: &Emission) -> TokenStream {
    let Sizes { nq, nx, length, .. } = &emission.sizes;
    let first_order = (!emission.equations.x.is_empty()).then(|| {
        quote! {
            let mut x_dot = [S::lit(0.0); #nx];
            self.x_dot(t, u, x, &mut x_dot);
            for (rate, value) in dx.iter_mut().skip(2 * NQ).zip(x_dot) {
                *rate = value;
            }
        }
    });
    let held = if contact::are_there(emission) { quote!(&self.loaded_(t, u, x)) } else { quote!(u) };
    quote! {
        fn rate_by_rank(
            &self, t: S, u: &Self::U, x: &[S; #length], dx: &mut [S; #length]
        ) -> Result<(), Fault> {
            let solution = self.accelerate(t, #held, x)?;
            let (_, v): ([S; #nq], [S; #nq]) = absolute::split(x);
            absolute::join(&v, &solution.a, dx);
            #first_order
            Ok(())
        }
    }
}

/// A state in a chart, between steps and where the chart is not regular.
fn in_charts(emission: &Emission) -> TokenStream {
    let Sizes { length, .. } = &emission.sizes;
    quote! {
        #[cold]
        fn rate_by_rank(
            &self, t: S, u: &Self::U, x: &[S; #length], dx: &mut [S; #length]
        ) -> Result<(), Fault> {
            if rt::Rate::rate(self, t, u, x, dx).is_good() {
                Ok(())
            } else {
                Err(rt::charts::not_regular(self, t, u, x))
            }
        }

        fn is_regular(&self, u: &Self::U) -> bool {
            !rt::charts::is_free::<Self>(u)
        }

        #[inline]
        fn is_settled(&self, t: S, u: &Self::U, x: &[S; #length]) -> bool {
            rt::charts::is_calm(self, t, u, x)
        }

        #[inline]
        fn update(&self, t: S, u: &mut Self::U, x: &mut [S; #length]) -> Result<rt::Updated, Fault> {
            rt::charts::update(self, t, u, x)
        }
    }
}

/// Stabilisation of the constraints in absolute coordinates.
pub(super) fn stabilisation(emission: &Emission) -> TokenStream {
    let Sizes { length, .. } = &emission.sizes;
    match emission.model.stabilisation {
        Stabilisation::Projection => quote! {
            fn project(&self, t: S, _u: &Self::U, x: &mut [S; #length]) -> Result<(), Fault> {
                absolute::project_state::<S, Self, NQ, NC, #length>(self, t, x)
            }

            fn drift(&self, t: S, _u: &Self::U, x: &[S; #length]) -> rt::Drift<S> {
                absolute::drift::<S, Self, NQ, NC, #length>(self, t, x)
            }
        },
        Stabilisation::Baumgarte(tau) => {
            let tau = emission.text(inline(tau, &emission.parameters()));
            quote! {
                fn baumgarte_rate(&self) -> Option<f64> {
                    let lit = S::lit;
                    let tau: S = #tau;
                    Some(1.0 / rt::Scalar::to_f64(tau))
                }
            }
        }
    }
}

/// Names of the parts that the numbers of the state belong to. Absolute coordinates have them body by body.
fn part_names(emission: &Emission) -> TokenStream {
    let Emission { model, equations, reduced, .. } = emission;
    if reduced.is_some() {
        let parts = table_compression::names(emission, &state::parts(model, equations, *reduced));
        return quote!(rt::PartNames::Numbers(const { &#parts }));
    }
    let states = quoted(model.states.iter().map(|state| &state.name.text));
    let bodies = emission.text(quoted(model.bodies.iter().map(|body| &body.name.text)));
    let states = emission.text(states);
    quote!(rt::PartNames::Bodies { bodies: &[#bodies], states: &[#states] })
}
