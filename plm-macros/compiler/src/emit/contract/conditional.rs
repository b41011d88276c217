//! `Conditional`: constraints with a condition, which assembly closes where they hold at the start.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::bindings::Origin;
use super::super::function::body;
use super::super::{Emission, Sizes, number};
use super::absolute::layout;
use super::contact;
use crate::formulate::Conditional;

/// `Conditional`; nothing without such constraints.
pub(crate) fn conditional(emission: &Emission) -> TokenStream {
    let Emission { name, model, program, sizes: Sizes { nq, .. }, .. } = emission;
    let Some(Conditional { rows, phi, phi_dot, phi_q, places }) = &program.conditional else {
        return TokenStream::new();
    };
    let of_rows = rows.iter().map(|row| &model.contacts[*row]).collect_vec();
    let [count, entries] = [rows.len(), places.len()].map_each(number);
    let layout = layout(emission, &of_rows);
    let places = emission.list(places.iter().map(|place| format!("{place:?}")));
    let of_pose = |docs, arguments: &[&str], of| body(emission, docs, arguments, (of, Origin::Pose));
    let (phi_docs, phi) =
        of_pose("Residuals of the constraints with a condition, m or rad.", &["t", "q", "phi"], phi);
    let (dot_docs, phi_dot) = of_pose("Their rates, m/s or rad/s.", &["t", "q", "v", "phi_dot"], phi_dot);
    let (entry_docs, phi_q) =
        of_pose("The derivatives of these residuals by q, row by row.", &["t", "q", "phi_q"], phi_q);
    quote! {
        #[doc(hidden)]
        impl<S: Real> absolute::Conditional<S, NQ, NC, #count> for #name<S> {
            fn layout_with_conditional(&self) -> &'static absolute::Layout {
                const LAYOUT: absolute::Layout = #layout;
                &LAYOUT
            }

            #phi_docs
            #[cold]
            fn conditional(&self, t: S, q: &[S; #nq]) -> [S; #count] {
                let mut phi = [S::lit(0.0); #count];
                #phi
                phi
            }

            #dot_docs
            #[cold]
            fn conditional_dot(&self, t: S, q: &[S; #nq], v: &[S; #nq]) -> [S; #count] {
                let mut phi_dot = [S::lit(0.0); #count];
                #phi_dot
                phi_dot
            }

            #entry_docs
            #[cold]
            fn conditional_q(&self, t: S, q: &[S; #nq], each: &mut impl FnMut(usize, usize, S)) {
                const PLACES: [[usize; 2]; #entries] = [#places];
                let mut phi_q = [S::lit(0.0); #entries];
                #phi_q
                for ([row, column], entry) in PLACES.into_iter().zip(phi_q) {
                    each(row, column, entry);
                }
            }
        }
    }
}

/// Assembles anew with the constraints that hold where a run begins, in `held` and `x`; `arrive` takes the pose (q, v) into both. Which
/// hold may depend on the pose: it is asked again after that, a few times.
pub(in super::super) fn close(emission: &Emission, arrive: &TokenStream) -> Option<TokenStream> {
    let rows = &emission.program.conditional.as_ref()?.rows;
    let (places, count) = (contact::count(emission), number(rows.len()));
    let all = number(emission.model.rows.len() + rows.len());
    let rows = emission.list(rows.iter().map(usize::to_string));
    Some(quote! {
        let mut closed = [false; #count];
        for _ in 0..4 {
            let holds = [#rows].map(|row| rt::contact::Contacts::<#places>::exists(self, &held, row));
            if holds == closed {
                break;
            }
            let (q, v) = absolute::assemble_held::<S, Self, NQ, NC, #count, #all>(self, t, holds)?;
            #arrive
            closed = holds;
        }
    })
}
