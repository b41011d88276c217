//! `Linear`: the mechanism and what it holds as constants with derivatives; of a large tree, its linearised equations.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::bindings::Origin;
use super::super::function::function;
use super::super::{Emission, Form, Sizes, number};
use crate::formulate::{Augmented, Chart, Part, Term};

/// `Linear`.
pub(crate) fn linear(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let (derivatives, differentiate) = match of_tree(emission) {
        Some((_, augmented)) => of_augmented(emission, augmented),
        None => (quote!([[S; #length]; #length]), TokenStream::new()),
    };
    let constraints = (!emission.is_reduced()).then(|| {
        quote! {
            fn constraints(&self, t: S, x: &[S; #length], row: &mut impl FnMut(S)) {
                absolute::residuals::<S, Self, NQ, NC, #length>(self, t, x, row);
            }
        }
    });
    quote! {
        impl<S: Real> rt::Linear for #name<S> {
            type Lifted<const K: usize> = #name<rt::Dual<S, K>>;
            type Derivatives = #derivatives;

            fn lift<const K: usize>(&self, held: &Held<S>) -> (#name<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                use rt::lanes::Pack;
                let constant = |[s]: [S; 1]| rt::Dual::constant(s);
                (self.pack([self], constant), Self::pack_held(held, [held], constant))
            }
            #constraints
            #differentiate
        }
    }
}

/// The linearised equations of a large tree.
fn of_tree<'a>(emission: &Emission<'a>) -> Option<(&'a Chart, &'a Augmented)> {
    match emission.form {
        Form::Tree(chart) => Some((chart, chart.augmented.as_ref()?)),
        _ => None,
    }
}

/// The type in which implicit methods keep their derivatives, and how these are found.
fn of_augmented(emission: &Emission, augmented: &Augmented) -> (TokenStream, TokenStream) {
    let Sizes { length, .. } = &emission.sizes;
    let pattern = &augmented.pattern;
    let [coefficients, places, pivots] =
        [augmented.coefficients.results.len(), pattern.places.len(), pattern.pivots.len()].map(number);
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
            let health = rt::lanes::Rate::rate(self, t, u, x, &mut dx);
            self.linearised(t, u, x, &dx, &mut by_x.coefficients);
            match by_t {
                Some(by_t) => self.jvp(t, u, x, (S::lit(1.0), &[S::lit(0.0); #length]), by_t),
                None => health,
            }
        }
    };
    (quote!(rt::linalg::Sparse<S, Augmented, #coefficients, #places, #pivots>), differentiate)
}

/// The coefficients of the linearised equations of a large tree as a function, their pattern as constants.
pub(crate) fn augmented(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let Some((chart, augmented)) = of_tree(emission) else { return TokenStream::new() };
    let count = number(augmented.coefficients.results.len());
    let linearised = function(
        emission,
        "The coefficients of the linearised equations before anything is eliminated; `dx` is the rate there.",
        &quote! {
            fn linearised(&self, t: S, u: &Held<S>, x: &[S; #length], dx: &[S; #length], c: &mut [S; #count])
        },
        (&augmented.coefficients, Origin::Chart(chart)),
    );
    let (coordinates, states) = (number(chart.y.len()), &emission.sizes.nx);
    let Tables { terms, pivots, below, right, targets } = Tables::of(augmented);
    let [terms, pivots, below, right, targets] =
        [terms, pivots, below, right, targets].map(|entries| emission.text(listed(&entries)));
    quote! {
        impl<S: Scalar> #name<S> { #linearised }

        /// Where the coefficients of the linearised equations stand, and how those are eliminated.
        #[doc(hidden)]
        #[derive(Clone, Copy, Debug)]
        pub struct Augmented;

        impl rt::linalg::Patterned for Augmented {
            const PATTERN: rt::linalg::Pattern = {
                use rt::linalg::Part::{Acceleration as A, Position as P, Rate as R, Value as N, Velocity as V};
                use rt::linalg::{Below, Part, Pattern, Pivot, Term};
                const fn t(coefficient: u32, row: u32, column: u32, entry: u32, part: Part) -> Term {
                    Term { coefficient, row, column, entry, part }
                }
                const fn p(row: u32, entry: u32, below: [u32; 2], right: [u32; 2], targets: u32) -> Pivot {
                    Pivot { row, entry, below, right, targets }
                }
                const fn b(row: u32, entry: u32, across: u32) -> Below {
                    Below { row, entry, across }
                }
                Pattern {
                    coordinates: #coordinates,
                    states: #states,
                    terms: const { &[#terms] },
                    pivots: const { &[#pivots] },
                    below: const { &[#below] },
                    right: &[#right],
                    targets: &[#targets],
                }
            };
        }
    }
}

/// What stands where, and the order of elimination.
#[derive(Default)]
struct Tables {
    terms: Vec<String>,
    pivots: Vec<String>,
    below: Vec<String>,
    right: Vec<String>,
    targets: Vec<String>,
}

impl Tables {
    fn of(augmented: &Augmented) -> Tables {
        let Augmented { terms, pattern, .. } = augmented;
        let place = |row: usize, column: usize| pattern.places.get(&(row, column)).copied();
        let term = |term: &Term| {
            let entry = place(term.row, term.column).unwrap_or_default();
            format!("t({}, {}, {}, {entry}, {})", term.coefficient, term.row, term.column, part(term.part))
        };
        let mut tables = Tables { terms: terms.iter().map(term).collect(), ..Tables::default() };
        let Tables { pivots, below, right, targets, .. } = &mut tables;
        for pivot in &pattern.pivots {
            let (first_below, first_right, first_target) = (below.len(), right.len(), targets.len());
            for &row in &pivot.below {
                let entry = place(row, pivot.row).unwrap_or_default();
                let across = place(pivot.row, row).map_or("u32::MAX".to_owned(), |across| across.to_string());
                below.push(format!("b({row}, {entry}, {across})"));
                let changed = pivot.right.iter().filter_map(|&column| place(row, column));
                targets.extend(changed.map(|target| target.to_string()));
            }
            for &column in &pivot.right {
                right.push(format!("[{column}, {}]", place(pivot.row, column).unwrap_or_default()));
            }
            pivots.push(format!(
                "p({}, {}, [{first_below}, {}], [{first_right}, {}], {first_target})",
                pivot.row,
                place(pivot.row, pivot.row).unwrap_or_default(),
                below.len(),
                right.len()
            ));
        }
        tables
    }
}

fn part(part: Part) -> char {
    match part {
        Part::Value => 'N',
        Part::Rate => 'R',
        Part::Position => 'P',
        Part::Velocity => 'V',
        Part::Acceleration => 'A',
    }
}

/// Entries of an array, some to a line.
fn listed(entries: &[String]) -> String {
    let lines: Vec<String> = entries.chunks(8).map(|chunk| chunk.join(", ")).collect();
    lines.join(",\n")
}
