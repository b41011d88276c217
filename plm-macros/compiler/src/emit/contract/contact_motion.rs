//! Rate and rows of contact in one pass: straight-line functions, and the rate that adds the forces of contact.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::{joined, quote};
use proc_macro2::{Ident, TokenStream};

use super::super::bindings::Origin;
use super::super::function::function;
use super::super::{Emission, Form, Sizes, memory};
use super::charted::call;
use super::contact::{self, count};
use super::contact_sliding;
use crate::facts::contact as facts;
use crate::formulate::ContactFunctions;
use crate::model::bounding_reactions;

/// Straight-line functions, chart by chart, and what calls them.
pub(super) fn functions(emission: &Emission) -> [TokenStream; 2] {
    [straight_line(emission), rows(emission)]
}

/// The straight-line functions, chart by chart.
fn straight_line(emission: &Emission) -> TokenStream {
    let name = &emission.name;
    let of = of_charts(emission);
    let all = of.into_iter().enumerate().map(|(k, of)| in_chart(emission, k, of)).collect_vec();
    let (all, exist, count) = (joined(all), &emission.program.rows_exist, count(emission));
    let exist = facts::some_may_not_exist(emission.model).then(|| {
        function(
            emission,
            "Does each row of contact exist? 1, or 0.",
            &quote!(fn rows_exist(&self, u: &Held<S>, exist: &mut [S; #count])),
            (exist, Origin::Arguments),
        )
    });
    quote!(impl<S: Scalar> #name<S> { #all #exist })
}

/// Functions of the rows in each chart.
pub(super) fn of_charts<'a>(emission: &Emission<'a>) -> Vec<(&'a ContactFunctions, Origin<'a>)> {
    match emission.form {
        Form::Absolute => {
            emission.program.contact.iter().map(|contact| (contact, Origin::Arguments)).collect_vec()
        }
        Form::Tree(chart) => {
            chart.contact.iter().map(|contact| (contact, Origin::Chart(chart))).collect_vec()
        }
        Form::Loops(reduced) => {
            let charts = reduced.charts.iter();
            charts.filter_map(|chart| Some((chart.contact.as_ref()?, Origin::Chart(chart)))).collect_vec()
        }
    }
}

fn in_chart(emission: &Emission, k: usize, (contact, origin): (&ContactFunctions, Origin)) -> TokenStream {
    let (Sizes { length, .. }, count) = (&emission.sizes, count(emission));
    let memory = emission.loops().map(|reduced| memory(reduced, &quote!(S)));
    let memory = memory.map(|memory| quote!(m: &#memory,));
    let state = quote!(t: S, u: &Held<S>, #memory x: &[S; #length]);
    let [kinematics, motion] =
        ["contact_kinematics", "contact_motion"].map_each(|name| emission.in_chart(name, k));
    let kinematics = function(
        emission,
        "Gaps and rates of the rows of contact.",
        &quote!(fn #kinematics(&self, #state, rows: &mut rt::contact::Kinematics<S, #count>)),
        (&contact.kinematics, origin),
    );
    let health = (!matches!(emission.form, Form::Tree(_))).then(|| quote!(-> S));
    let with_rows = |name: &Ident| {
        quote! {
            fn #name(
                &self,
                #state,
                dx: &mut [S; #length],
                response: &mut [[S; #length]; #count],
                rows: &mut rt::contact::Rows<S, #count>
            ) #health
        }
    };
    let motion = function(
        emission,
        "The rate without contact forces, its responses to multipliers, and of the rows of contact: accelerations without contact forces, Delassus operator, limits of friction.",
        &with_rows(&motion),
        (&contact.motion, origin),
    );
    let together = contact.together.as_ref().map(|together| {
        let name = emission.in_chart("contact_together", k);
        function(
            emission,
            "Rate, responses and rows at once, for steps that need all of them.",
            &with_rows(&name),
            (together, origin),
        )
    });
    quote!(#kinematics #motion #together)
}

/// The call of a function of the charts that gives the rate; binds its health, which is perfect where it gives none.
fn with_health(emission: &Emission, name: &str, arguments: &TokenStream) -> TokenStream {
    if let Form::Tree(_) = emission.form {
        let call = call(emission, name, arguments, &quote!({}));
        quote!(#call; let health = rt::Health::perfect();)
    } else {
        let call = call(emission, name, arguments, &quote!(S::lit(0.0)));
        quote!(let health = rt::Health(#call);)
    }
}

/// The rows at a state, and what is held with the multipliers there.
fn rows(emission: &Emission) -> TokenStream {
    let (Emission { name, sizes: Sizes { length, .. }, .. }, count) = (emission, count(emission));
    let [_, memory] = emission.memory_argument();
    let kinematics = call(emission, "contact_kinematics", &quote!(t, u, #memory x, &mut rows), &quote!({}));
    let arguments = quote!(t, u, #memory x, &mut dx, &mut response, rows);
    let motion = with_health(emission, "contact_motion", &arguments);
    let (loads, of_steps) = (loads(emission), motion_of_steps(emission));
    quote! {
        impl<S: Scalar> #name<S> {
            #of_steps

            #[inline]
            fn contact_kinematics_(
                &self, t: S, u: &Held<S>, x: &[S; #length]
            ) -> rt::contact::Kinematics<S, #count> {
                let mut rows = rt::contact::Kinematics::none();
                #kinematics;
                #loads
                rows
            }

            /// The rate without contact forces, and its responses; completes the rows.
            #[inline]
            fn contact_motion_(
                &self, t: S, u: &Held<S>, x: &[S; #length], rows: &mut rt::contact::Rows<S, #count>
            ) -> ([S; #length], [[S; #length]; #count], rt::Health<S>) {
                let (mut dx, mut response) = ([S::lit(0.0); #length], [[S::lit(0.0); #length]; #count]);
                #motion
                #loads
                (dx, response, health)
            }

            fn contact_rows_(&self, t: S, u: &Held<S>, x: &[S; #length]) -> rt::contact::Rows<S, #count> {
                let mut rows = self.contact_kinematics_(t, u, x).rows();
                let _ = self.contact_motion_(t, u, x, &mut rows);
                rows
            }

            fn contact_response_(
                &self, t: S, u: &Held<S>, x: &[S; #length], lambda: &[S; #count]
            ) -> [S; #length] {
                let (_, response, _) = self.contact_motion_(t, u, x, &mut rt::contact::Rows::none());
                rt::contact::sum_of(&response, lambda)
            }

            /// The discrete state with the multipliers of contact at a state.
            #[inline]
            fn loaded_(&self, t: S, u: &Held<S>, x: &[S; #length]) -> Held<S> {
                let mut held = *u;
                if !u.contact.has_forces() {
                    return held;
                }
                let mut rows = rt::contact::Rows::none();
                let _ = self.contact_motion_(t, u, x, &mut rows);
                held.contact = rt::contact::with_multipliers(&rows, &u.contact);
                held
            }
        }

        impl<S: Real> State<S> {
            /// The discrete state with the multipliers of contact.
            fn loaded_(&self) -> Held<S> {
                self.mechanism.loaded_(self.time, &self.held, &self.x)
            }
        }
    }
}

/// Motion and rows for steps of time, in any numbers: in one pass where such a step is ordered.
fn motion_of_steps(emission: &Emission) -> TokenStream {
    let (Sizes { length, .. }, count) = (&emission.sizes, count(emission));
    let (of, [_, memory]) = (of_charts(emission), emission.memory_argument());
    let is_ordered = of.iter().all(|(contact, _)| contact.together.is_some());
    let body = if is_ordered {
        let arguments = quote!(t, u, #memory x, &mut dx, &mut response, rows);
        let health = with_health(emission, "contact_together", &arguments);
        let loads = loads(emission);
        quote! {
            let mut all = rt::contact::Rows::none();
            let rows = &mut all;
            let (mut dx, mut response) = ([S::lit(0.0); #length], [[S::lit(0.0); #length]; #count]);
            #health
            #loads
            rt::contact::Motion { rate: dx, responses: response, rows: all, health }
        }
    } else {
        quote! {
            let mut rows = self.contact_kinematics_(t, u, x).rows();
            let (rate, responses, health) = self.contact_motion_(t, u, x, &mut rows);
            rt::contact::Motion { rate, responses, rows, health }
        }
    };
    quote! {
        /// Motion and rows for steps of time.
        #[inline]
        fn contact_motion_at_(
            &self, t: S, u: &Held<S>, x: &[S; #length]
        ) -> rt::contact::Motion<S, [S; #length], #count> {
            #body
        }
    }
}

/// A rate of fewer operations is not worth to be computed for several mechanisms at once: what is taken out of lanes costs as many
/// (`benches/lanes.rs`).
const WORTH: u32 = 100;
/// So many operations is a sine with its cosine.
const SINE: u32 = 20;

/// Steps of several mechanisms side by side, of `Pack`, where that pays; else each is made by itself.
pub(super) fn packed_steps(emission: &Emission) -> Option<TokenStream> {
    let (Emission { name, sizes: Sizes { length, .. }, report, .. }, count) = (emission, count(emission));
    let operations = report.rate.operations;
    let pays = operations.total() + SINE * operations.sin_cos >= WORTH;
    let steps = quote! {
        fn packed_steps<T: Scalar, const K: usize>(
            (all, held): (&#name<T>, &Held<T>),
            steps: (&rt::contact::Stride<T>, &[T; #length]),
            proposed: [Option<rt::contact::Proposed<'_, Self>>; K],
            take: impl Fn(&T, usize) -> S,
        ) {
            let motion = |t: T, x: &[T; #length]| all.contact_motion_at_(t, held, x);
            rt::contact::packed_steps::<Self, #name<T>, #count, K>(steps, motion, proposed, take);
        }
    };
    (contact::are_there(emission) && pays).then_some(steps)
}

/// Motion and rows for steps of time, of `Contacts`.
pub(super) fn motion_at(emission: &Emission) -> TokenStream {
    let (Sizes { length, .. }, count) = (&emission.sizes, count(emission));
    let of = of_charts(emission);
    let with_forces = (!of.iter().all(|(contact, _)| contact.is_affine)).then(|| {
        quote! {
            fn rate_with_forces(
                &self, t: S, u: &Held<S>, x: &[S; #length], lambda: &[S; #count]
            ) -> Option<[S; #length]> {
                let (mut held, mut dx) = (*u, [S::lit(0.0); #length]);
                held.contact.lambda = *lambda;
                self.rate_holding_(t, &held, x, &mut dx);
                Some(dx)
            }
        }
    });
    let moves_by_time = of.iter().any(|(contact, _)| contact.moves_by_time);
    let moves_by_time = emission.text(format!("{moves_by_time}"));
    quote! {
        fn moves_by_time(&self) -> bool {
            #moves_by_time
        }

        fn motion_at(
            &self, t: S, u: &Held<S>, x: &[S; #length]
        ) -> rt::contact::Motion<S, [S; #length], #count> {
            self.contact_motion_at_(t, u, x)
        }
        #with_forces
    }
}

/// The rate without contact forces, and those of the rows, from one pass; from two where it is not affine in them.
pub(super) fn rate(emission: &Emission) -> TokenStream {
    let of = of_charts(emission);
    let by_sweeps = contact_sliding::rate(emission);
    if of.iter().all(|(contact, _)| contact.is_affine) {
        return quote! {
            if !u.contact.has_forces() {
                return self.rate_holding_(t, u, x, dx);
            }
            #by_sweeps
            let mut rows = rt::contact::Rows::none();
            let (free, response, health) = self.contact_motion_(t, u, x, &mut rows);
            *dx = free;
            rt::contact::add_forces(dx, &rows, &u.contact, &response);
            health
        };
    }
    quote! {
        let u = &self.loaded_(t, u, x);
        let health = self.rate_holding_(t, u, x, dx);
        rt::contact::settle(dx, &u.contact, |lambda| self.contact_response_(t, u, x, lambda));
        health
    }
}

/// Kinds of the reactions that bound frictions, and of which frictions; the sign of one along a line is held.
fn loads(emission: &Emission) -> TokenStream {
    let contacts = &emission.model.contacts;
    let mut lines = Vec::new();
    let readers = facts::readers(emission.model);
    for (load, (reaction, rows)) in bounding_reactions(contacts).into_iter().zip(readers).enumerate() {
        let kind = match reaction.components.len() {
            1 => format!("Line {{ negative: u.contact.modes.negative[{load}] }}"),
            _ => "Plane".to_owned(),
        };
        lines.push(format!("rows.load[{load}] = rt::contact::Load::{kind};"));
        for row in rows {
            lines.push(format!("rows.read[{row}][{load}] = true;"));
        }
    }
    emission.text(lines.concat())
}
