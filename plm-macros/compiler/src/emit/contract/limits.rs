//! Methods of `Mechanism` for parameters: what they may be, and what is assembled anew when one changes.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use plm_cas::algebra;
use proc_macro2::{Ident, TokenStream};

use super::super::lower::inline;
use super::super::{Emission, Form, Sizes, number, pose_at};
use crate::facts::limits::{self, Limit};
use crate::units::DisplayUnit;

/// The row of a limit.
fn row(limit: &Limit) -> String {
    let Limit { part, what, unit, least, .. } = limit;
    format!("rt::Limit {{ part: {part:?}, what: {what:?}, unit: {unit:?}, least: rt::Least::{least:?} }}")
}

/// May a body be without mass, if others carry it? Absolute coordinates divide by each mass.
fn may_be_carried(emission: &Emission) -> bool {
    emission.is_reduced() && (emission.reactions().is_some() || !emission.reads_solution())
}

/// Limits of mass and inertia of every body, if others may carry some that parameters make massless.
pub(in super::super) fn that_may_be_carried(emission: &Emission) -> Option<Vec<String>> {
    let bodies = limits::that_may_be_carried(emission.model, may_be_carried(emission))?;
    let rows = bodies.iter().map(|[mass, inertia]| format!("[{}, {}]", row(mass), row(inertia)));
    Some(rows.collect_vec())
}

/// `check`.
pub(super) fn check(emission: &Emission) -> TokenStream {
    let Emission { model, fields, .. } = emission;
    let numbers = emission.list(model.params.iter().zip(&fields.params).map(|(param, field)| {
        format!("({:?}, {:?}, self.{field})", param.name.text, DisplayUnit::si(param.unit.dimension).text)
    }));
    let all = limits::varying(model, may_be_carried(emission));
    let bindings = emission.parameters();
    let (entries, values): (Vec<String>, Vec<String>) =
        all.iter().map(|limit| (row(limit), inline(limit.value, &bindings))).unzip();
    let limits = (!entries.is_empty()).then(|| {
        let (count, entries) = (number(entries.len()), emission.lines(entries));
        let (literals, values) = emission.values(values);
        quote! {
            const LIMITS: [rt::Limit; #count] = [#entries];
            #literals
            let values = [#values];
            rt::limits::check(t, &values, &LIMITS)?;
        }
    });
    quote! {
        fn check(&self, t: S) -> Result<(), Fault> {
            rt::limits::check_numbers(t, [#numbers])?;
            #limits
            Ok(())
        }
    }
}

/// Fields of the parameters that joints, masses or known times read.
fn shaping<'a>(emission: &'a Emission) -> Vec<&'a Ident> {
    let Emission { model, fields, .. } = emission;
    let read = algebra::symbols(&limits::shaping(model));
    let params = model.params.iter().zip(&fields.params);
    params.filter(|(param, _)| read.contains(&param.symbol)).map(|(_, field)| field).collect_vec()
}

/// From the pose `q` and velocity `v` to the state `x`.
pub(super) fn into_state(emission: &Emission, held: &TokenStream) -> TokenStream {
    match emission.form {
        Form::Loops(_) => quote!(rt::charts::enter(self, t, #held, (&q, &v), x)),
        Form::Tree(_) => quote!(self.to_chart(t, &q, &v, x)),
        Form::Absolute => quote!(absolute::join(&q, &v, x)),
    }
}

/// `fingerprint` and `renew`, where parameters shape the mechanism.
pub(super) fn renew(emission: &Emission) -> Option<TokenStream> {
    let Sizes { nq, length, .. } = &emission.sizes;
    let (shaping, pose) = (shaping(emission), pose_at("held"));
    let back = into_state(emission, &quote!(held));
    (!shaping.is_empty()).then(|| {
        quote! {
            fn fingerprint(&self) -> u64 {
                rt::limits::fingerprint([#(self.#shaping),*])
            }

            fn renew(&self, t: S, held: &mut Held<S>, x: &mut [S; #length]) -> Result<(), Fault> {
                let (mut q, mut v): ([S; #nq], [S; #nq]) = #pose;
                absolute::renew::<S, Self, NQ, NC>(self, t, &mut q, &mut v)?;
                #back;
                Ok(())
            }
        }
    })
}
