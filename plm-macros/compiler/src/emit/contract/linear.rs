//! `Linear`: the mechanism and what it holds as constants with derivatives; of a large tree, its linearised equations.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::format_ident;

use super::super::bindings::Origin;
use super::super::function::function;
use super::super::{Emission, Form, Sizes, number, table_compression};
use super::charted::call;
use super::directions::directions;
use super::{contact, pack};
use crate::formulate::{Augmented, Chart, Elimination, Linearised};

/// `Linear`.
pub(crate) fn linear(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let (derivatives, differentiate) = match emission.sparse() {
        Some(augmented) => of_augmented(emission, augmented),
        None => (quote!([[S; #length]; #length]), TokenStream::new()),
    };
    let jacobian = of_charts(emission).or_else(|| directions(emission));
    let constraints = (!emission.is_reduced()).then(|| {
        quote! {
            fn constraints(&self, t: S, x: &[S; #length], row: &mut impl FnMut(S)) {
                absolute::residuals::<S, Self, NQ, NC, #length>(self, t, x, row);
            }
        }
    });
    let held_rows = held_rows(emission);
    let without_time = (!emission.rate_knows_time() && !contact::are_there(emission)).then(|| {
        quote! {
            fn rate_reads_time(&self) -> bool {
                false
            }
        }
    });
    let of_rate = pack::of_rate(emission);
    quote! {
        impl<S: Real> rt::Linear for #name<S> {
            type Lifted<const K: usize> = #name<rt::Dual<S, K>>;
            type In<T: Real> = #name<T>;
            type Derivatives = #derivatives;

            fn lift<const K: usize>(&self, held: &Held<S>) -> (#name<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                self.in_numbers(held, rt::Dual::constant)
            }

            fn in_numbers<T: Real>(&self, held: &Held<S>, number: impl Fn(S) -> T) -> (#name<T>, Held<T>) {
                use rt::lanes::Pack;
                let of_one = |[s]: [S; 1]| number(s);
                (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
            }

            #[inline]
            fn rate_in_numbers<T: Real>(&self, held: &Held<S>, number: impl Fn(S) -> T) -> (#name<T>, Held<T>) {
                #of_rate
            }
            #without_time
            #constraints
            #held_rows
            #differentiate
            #jacobian
        }
    }
}

/// Rows that hold: those of contact, and each discrete state, which keeps its value until the next event.
fn held_rows(emission: &Emission) -> Option<TokenStream> {
    let Sizes { length, second_order, .. } = &emission.sizes;
    let contacts = contact::are_there(emission).then(|| {
        let count = contact::count(emission);
        quote!(rt::contact::held_rows::<Self, #count>(self, t, u, x, row);)
    });
    let states = emission.model.states.iter().enumerate();
    let discrete = states.filter(|(_, state)| state.rate.is_zero()).map(|(k, _)| number(second_order + k));
    let discrete = discrete.collect_vec();
    (contacts.is_some() || !discrete.is_empty()).then(|| {
        quote! {
            fn held_rows(&self, t: S, u: &Held<S>, x: &[S; #length], row: &mut impl FnMut(S)) {
                #contacts
                #(row(x[#discrete]);)*
            }
        }
    })
}

/// The full matrix in the chart that is held, where every chart has it entry by entry.
fn of_charts(emission: &Emission) -> Option<TokenStream> {
    emission.loops().filter(|reduced| reduced.has_jacobian())?;
    let length = &emission.sizes.length;
    let entries = call(emission, "jacobian", &quote!(t, u, m, x, &dx, by_x), &quote!({}));
    Some(quote! {
        fn jacobian(
            &self,
            t: S,
            u: &Self::U,
            x: &[S; #length],
            by_x: &mut [[S; #length]; #length],
            by_t: Option<&mut [S; #length]>,
        ) -> rt::Health<S> {
            let mut dx = [S::lit(0.0); #length];
            let health = rt::Rate::rate(self, t, u, x, &mut dx);
            *by_x = [[S::lit(0.0); #length]; #length];
            #entries;
            if let Some(by_t) = by_t {
                let _ = self.jvp(t, u, x, (S::lit(1.0), &[S::lit(0.0); #length]), by_t);
            }
            rt::linear::finite(health, by_x)
        }
    })
}

/// The linearised equations of a formulation, or of one of its charts.
#[derive(Clone, Copy)]
pub(crate) struct System<'a> {
    /// Origin of the arguments of its functions.
    origin: Origin<'a>,
    /// The equations.
    pub(crate) linearised: &'a Linearised,
}

impl Emission<'_> {
    /// The linearised equations, chart by chart; none where they are not wanted.
    pub(crate) fn systems(&self) -> Vec<System<'_>> {
        fn of_chart(chart: &Chart) -> Option<System<'_>> {
            Some(System { origin: Origin::Chart(chart), linearised: chart.linearised.as_ref()? })
        }
        match self.form {
            Form::Absolute => {
                let linearised = self.program.linearised.as_ref();
                let system = |linearised| System { origin: Origin::Linearised, linearised };
                linearised.map(system).into_iter().collect_vec()
            }
            Form::Tree(chart) => of_chart(chart).into_iter().collect_vec(),
            Form::Loops(reduced) => reduced.charts.iter().filter_map(of_chart).collect_vec(),
        }
    }

    /// The equations that implicit methods solve in place of df/dx.
    pub(super) fn sparse(&self) -> Option<&Augmented> {
        let system = self.systems().into_iter().find(|system| system.linearised.sparse)?;
        Some(&system.linearised.augmented)
    }

    /// The name of a function of the chart with this number: its own where there are several.
    pub(crate) fn in_chart(&self, function: &str, chart: usize) -> Ident {
        match self.form {
            Form::Loops(_) => format_ident!("{function}_{chart}"),
            Form::Tree(_) | Form::Absolute => format_ident!("{function}"),
        }
    }

    /// Numbers that coefficients of linearised equations need.
    pub(crate) fn coefficients(&self) -> Literal {
        let count = |system: &System| system.linearised.augmented.coefficients.results.len();
        number(self.systems().iter().map(count).max().unwrap_or(0))
    }
}

/// The rate `dx` at a state with its `health`, and the coefficients, to `c`, of the equations linearised there.
pub(crate) fn at_state(emission: &Emission, c: &TokenStream) -> (TokenStream, TokenStream) {
    let nc = &emission.sizes.nc;
    let by_rate = quote!(let health = rt::Rate::rate(self, t, u, x, &mut dx););
    match emission.form {
        Form::Absolute => (
            quote! {
                let mut multipliers = [S::lit(0.0); #nc];
                let health = rt::Health(self.dynamics(t, u, x, &mut dx, &mut multipliers));
            },
            quote!(self.linearised(t, u, x, &dx, &multipliers, #c)),
        ),
        Form::Tree(_) | Form::Loops(_) => {
            let [_, m] = emission.memory_argument();
            (by_rate, call(emission, "linearised", &quote!(t, u, #m x, &dx, #c), &quote!({})))
        }
    }
}

/// The type in which implicit methods keep their derivatives, and how these are found.
fn of_augmented(emission: &Emission, augmented: &Augmented) -> (TokenStream, TokenStream) {
    let Sizes { length, .. } = &emission.sizes;
    let pattern = &augmented.pattern;
    let [coefficients, places, pivots] =
        [augmented.coefficients.results.len(), pattern.places.len(), pattern.pivots.len()].map_each(number);
    let sparse = quote!(rt::linalg::Sparse<S, Augmented<S>, #coefficients, #places, #pivots>);
    let (kind, begin, end, c) = if emission.is_reduced() {
        (sparse, None, None, quote!(&mut by_x.coefficients))
    } else {
        // Where elimination is not healthy there is the matrix.
        let begin = quote! {
            let mut sparse = <#sparse as rt::linalg::Derivatives<S, [S; #length]>>::zeros();
        };
        let end = quote!(*by_x = rt::linalg::Mixed::Sparse(sparse););
        let kind = quote!(rt::linalg::Mixed<#sparse, [[S; #length]; #length]>);
        (kind, Some(begin), Some(end), quote!(&mut sparse.coefficients))
    };
    let (rate, linearise) = at_state(emission, &c);
    let differentiate = quote! {
        fn differentiate(
            &self,
            t: S,
            u: &Self::U,
            x: &[S; #length],
            by_x: &mut Self::Derivatives,
            by_t: Option<&mut [S; #length]>,
        ) -> rt::Health<S> {
            let mut dx = [S::lit(0.0); #length];
            #rate
            #begin
            #linearise;
            #end
            match by_t {
                Some(by_t) => self.jvp(t, u, x, (S::lit(1.0), &[S::lit(0.0); #length]), by_t),
                None => health,
            }
        }
    };
    (kind, differentiate)
}

/// The coefficients of linearised equations as functions, and the pattern of those that implicit methods solve as constants.
pub(crate) fn augmented(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { nc, length, .. }, .. } = emission;
    let systems = emission.systems();
    if systems.is_empty() {
        return TokenStream::new();
    }
    let count = emission.coefficients();
    let [memory, _] = emission.memory_argument();
    let multipliers = (!emission.is_reduced()).then(|| quote!(lambda: &[S; #nc],));
    let functions = systems.iter().enumerate().map(|(k, system)| {
        let name = emission.in_chart("linearised", k);
        function(
            emission,
            "The coefficients of the linearised equations before anything is eliminated; `dx` is the rate there.",
            &quote! {
                fn #name(
                    &self, t: S, u: &Held<S>, #memory x: &[S; #length], dx: &[S; #length], #multipliers c: &mut [S; #count]
                )
            },
            (&system.linearised.augmented.coefficients, system.origin),
        )
    });
    let pattern = emission.sparse().map(|augmented| pattern(emission, augmented));
    quote! {
        impl<S: Scalar> #name<S> { #(#functions)* }
        #pattern
    }
}

/// Type `Augmented` of the emitted code: places of the coefficients and order of elimination, as constants.
fn pattern(emission: &Emission, augmented: &Augmented) -> TokenStream {
    let (coordinates, states) = (number(augmented.accelerations.len()), number(augmented.states));
    let Elimination { terms, pivots, below, right, targets } = Elimination::of(augmented);
    let table = |name: &str, numbers: &[u32], width: usize| {
        let (name, count) = (format_ident!("{name}"), number(numbers.len() / width));
        let numbers = table_compression::numbers(emission, numbers);
        quote!(const { &rt::compact::#name::<#count>(&#numbers) })
    };
    let [terms, pivots] = [table("terms", &terms, 5), table("pivots", &pivots, 7)];
    let [below, right] = [table("below", &below, 3), table("pairs", &right, 2)];
    let targets = table_compression::numbers(emission, &targets);
    quote! {
        /// Places of the coefficients of the linearised equations, and the order of their elimination.
        #[doc(hidden)]
        #[derive(Clone, Copy, Debug)]
        pub struct Augmented<S>(core::marker::PhantomData<S>);

        // Generic, so that rustc works the tables out for who reads them alone.
        impl<S: Real> rt::linalg::Patterned for Augmented<S> {
            const PATTERN: rt::linalg::Pattern = rt::linalg::Pattern {
                coordinates: #coordinates,
                states: #states,
                terms: #terms,
                pivots: #pivots,
                below: #below,
                right: #right,
                targets: const { &#targets },
            };
        }
    }
}
