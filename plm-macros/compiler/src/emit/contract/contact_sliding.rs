//! Rows of contact that all slip, where reactions bound them: what is known of a state, and sweeps over the forces.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::{joined, quote};
use plm_cas::Expr;
use proc_macro2::{Ident, TokenStream};

use super::super::bindings::Origin;
use super::super::function::function;
use super::super::{Emission, Form, Sizes, memory, number};
use super::charted::call;
use super::contact::count;
use super::contact_motion::of_charts;
use crate::formulate::Sliding;

/// The functions of a chart with their origin.
type Of<'a> = (&'a Sliding, Origin<'a>);

/// Is a friction bounded by reactions, in a rate that is affine in its force?
pub(super) fn are_there(emission: &Emission) -> bool {
    !emission.model.contacts.is_empty() && !in_charts(emission).is_empty()
}

fn in_charts<'a>(emission: &Emission<'a>) -> Vec<Of<'a>> {
    let charts = of_charts(emission).into_iter();
    let all: Option<Vec<Of>> =
        charts.map(|(contact, origin)| Some((contact.sliding.as_ref()?, origin))).collect();
    all.unwrap_or_default()
}

/// The symbols of these functions, and where they stand.
pub(in super::super) fn symbols<'a>(emission: &Emission<'a>) -> Vec<(&'a [Expr], &'static str)> {
    let of = |(sliding, _): Of<'a>| {
        let Sliding { slip, line, force, second, known, .. } = sliding;
        let signs = [(&slip[..], "slip"), (&line[..], "line")];
        let numbers = [(&force[..], "force"), (&second[..], "second"), (&known[..], "known")];
        signs.into_iter().chain(numbers).collect_vec()
    };
    in_charts(emission).into_iter().flat_map(of).collect_vec()
}

/// The functions, chart by chart, and what calls them; nothing without such a friction.
pub(super) fn functions(emission: &Emission) -> TokenStream {
    if !are_there(emission) {
        return TokenStream::new();
    }
    let (Emission { name, sizes: Sizes { length, .. }, .. }, count) = (emission, count(emission));
    let all = in_charts(emission).into_iter().enumerate().map(|(k, of)| in_chart(emission, k, of));
    let all = joined(all.collect_vec());
    let [_, memory] = emission.memory_argument();
    let slide = call(emission, "contact_slide", &quote!(t, u, #memory x, signs, dx, sizes), &quote!(None));
    quote! {
        impl<S: Scalar> #name<S> {
            #all

            /// The rate where all rows that have a force slip, and the sizes of reactions along a line; nothing where sweeps do not converge.
            #[inline]
            fn contact_sliding_(
                &self, t: S, u: &Held<S>, x: &[S; #length], dx: &mut [S; #length], sizes: Option<&mut [S; #count]>
            ) -> Option<rt::Health<S>> {
                let signs = &rt::contact::slipping(&u.contact.modes)?;
                #slide.map(rt::Health)
            }
        }
    }
}

fn in_chart(emission: &Emission, k: usize, (sliding, origin): Of) -> TokenStream {
    let [known, sweep, sizes] = straight_line(emission, k, (sliding, origin));
    let (Sizes { length, .. }, count) = (&emission.sizes, count(emission));
    let [know, sweeps, size] = names(emission, k);
    let slide = emission.in_chart("contact_slide", k);
    let [state, memory] = state(emission);
    let (freedom, after) = (number(sliding.second.len()), number(2 * sliding.second.len()));
    let weights = weights(emission, k);
    let (numbers, is_explicit) = (number(sliding.known.len()), sliding.is_explicit);
    let motion = quote!(self.#know(t, u, #memory x, slip, line, dx, &mut free, &mut known, &mut slope));
    let motion = if let Form::Tree(_) = emission.form {
        quote!(#motion; let health = S::lit(1.0);)
    } else {
        quote!(let health = #motion;)
    };
    quote! {
        #known
        #sweep
        #sizes

        #[inline]
        fn #slide(
            &self,
            #state
            [slip, line]: &[[S; #count]; 2],
            dx: &mut [S; #length],
            sizes: Option<&mut [S; #count]>
        ) -> Option<S> {
            let (mut known, mut slope) = ([S::lit(0.0); #numbers], [S::lit(1.0); #count]);
            let mut free = [S::lit(0.0); #freedom];
            #motion
            let (force, second) = rt::contact::slide(
                (&slope, &#weights),
                #is_explicit,
                free,
                |force, second, next, changed| self.#sweeps(&known, force, second, next, changed)
            )?;
            dx[#freedom..#after].copy_from_slice(&second);
            if let Some(sizes) = sizes {
                self.#size(line, &known, &force, &second, sizes);
            }
            Some(health)
        }
    }
}

/// Names of the functions that compute.
fn names(emission: &Emission, k: usize) -> [Ident; 3] {
    ["contact_known", "contact_sweep", "contact_sizes"].map_each(|name| emission.in_chart(name, k))
}

/// By coordinate, what makes its acceleration one of an angle: over the length of the scene where it is a length.
fn weights(emission: &Emission, k: usize) -> TokenStream {
    let inverse = 1.0 / emission.report.length;
    let is_angle: Vec<bool> = match emission.form {
        Form::Absolute => (0..emission.equations.q.len()).map(|k| k % 3 == 2).collect_vec(),
        Form::Tree(chart) => chart.turning.iter().map(Option::is_some).collect_vec(),
        Form::Loops(reduced) => reduced.charts[k].turning.iter().map(Option::is_some).collect_vec(),
    };
    let weights = is_angle.into_iter().map(|angle| format!("{:?}", if angle { 1.0 } else { inverse }));
    let weights = emission.list(weights);
    quote!([#weights])
}

/// Arguments of a state, as they are declared, and what is remembered as it is handed on.
fn state(emission: &Emission) -> [TokenStream; 2] {
    let length = &emission.sizes.length;
    let memory = emission.loops().map(|reduced| memory(reduced, &quote!(S)));
    let memory = memory.map(|memory| quote!(m: &#memory,));
    let [_, handed] = emission.memory_argument();
    let handed = quote!(#handed);
    [quote!(t: S, u: &Held<S>, #memory x: &[S; #length],), handed]
}

/// The functions that compute.
fn straight_line(emission: &Emission, k: usize, (sliding, origin): Of) -> [TokenStream; 3] {
    let (Sizes { length, .. }, count) = (&emission.sizes, count(emission));
    let [know, sweep, size] = names(emission, k);
    let [state, _] = state(emission);
    let [numbers, freedom] = [sliding.known.len(), sliding.second.len()].map_each(number);
    let health = (!matches!(emission.form, Form::Tree(_))).then(|| quote!(-> S));
    let forces = quote!(known: &[S; #numbers], force: &[S; #count], second: &[S; #freedom]);
    let known = function(
        emission,
        "Where all rows slip, what does not depend on their forces: rates but accelerations, `known`, and slopes of the sweeps.",
        &quote! {
            #[inline]
            fn #know(
                &self,
                #state
                slip: &[S; #count],
                line: &[S; #count],
                dx: &mut [S; #length],
                free: &mut [S; #freedom],
                known: &mut [S; #numbers],
                slope: &mut [S; #count]
            ) #health
        },
        (&sliding.motion, origin),
    );
    let sweep = function(
        emission,
        "Forces and accelerations after a sweep.",
        &quote! {
            #[inline(always)]
            fn #sweep(&self, #forces, next: &mut [S; #count], changed: &mut [S; #freedom])
        },
        (&sliding.sweep, origin),
    );
    let size = function(
        emission,
        "Sizes of reactions along a line, by the signs that are held.",
        &quote!(#[inline] fn #size(&self, line: &[S; #count], #forces, sizes: &mut [S; #count])),
        (&sliding.sizes, origin),
    );
    [known, sweep, size]
}

/// Branch of the rate for states in which all rows slip: it solves by sweeps, and returns if these converge. `None` without such rows.
pub(super) fn rate(emission: &Emission) -> Option<TokenStream> {
    are_there(emission).then(|| {
        quote! {
            if let Some(health) = self.contact_sliding_(t, u, x, dx, None) {
                return health;
            }
        }
    })
}

/// `Contacts::sliding`.
pub(super) fn contract(emission: &Emission) -> Option<TokenStream> {
    let (Sizes { length, .. }, count) = (&emission.sizes, count(emission));
    are_there(emission).then(|| {
        quote! {
            fn sliding(&self, t: S, u: &Held<S>, x: &[S; #length]) -> Option<[S; #count]> {
                let (mut dx, mut sizes) = ([S::lit(0.0); #length], [S::lit(0.0); #count]);
                self.contact_sliding_(t, u, x, &mut dx, Some(&mut sizes)).map(|_| sizes)
            }
        }
    })
}
