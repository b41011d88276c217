//! Methods of `Mechanism` for parameters: what they may be, and what is assembled anew when one changes.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use plm_cas::{Expr, algebra};
use proc_macro2::{Ident, TokenStream};

use super::super::lower::inline;
use super::super::{Emission, Form, Sizes, number, pose_at};
use crate::model::Range;
use crate::units::DisplayUnit;

/// A limited value: of which part, what, its unit, which least, and what it is.
struct Limited {
    entry: String,
    value: Expr,
}

impl Limited {
    fn new(part: &str, what: &str, unit: &str, least: &str, value: Expr) -> Limited {
        let entry = format!(
            "rt::Limit {{ part: {part:?}, what: {what:?}, unit: {unit:?}, least: rt::Least::{least} }}"
        );
        Limited { entry, value }
    }

    /// Does it depend on parameters? Constants have been looked at.
    fn varies(&self) -> bool {
        self.value.as_number().is_none()
    }
}

/// May a body be without mass, if others carry it? Absolute coordinates divide by each mass.
fn may_be_carried(emission: &Emission) -> bool {
    emission.is_reduced() && (emission.reactions().is_some() || !emission.reads_solution())
}

/// Mass and inertia of every body.
fn of_bodies(emission: &Emission) -> Vec<[Limited; 2]> {
    let least = if may_be_carried(emission) { "Carried" } else { "Positive" };
    let bodies = emission.model.bodies.iter().map(|body| {
        let name = &body.name.text;
        [
            Limited::new(name, "mass", "kg", least, body.mass),
            Limited::new(name, "inertia", "kg*m^2", least, body.inertia),
        ]
    });
    bodies.collect_vec()
}

/// Limits of mass and inertia of every body, if others may carry some that parameters make massless.
pub(in super::super) fn that_may_be_carried(emission: &Emission) -> Option<Vec<String>> {
    let bodies = of_bodies(emission);
    let varies = may_be_carried(emission) && bodies.iter().flatten().any(Limited::varies);
    let entries = bodies.iter().map(|[mass, inertia]| format!("[{}, {}]", mass.entry, inertia.entry));
    varies.then(|| entries.collect_vec())
}

/// `check`.
pub(super) fn check(emission: &Emission) -> TokenStream {
    let Emission { model, fields, .. } = emission;
    let numbers = emission.list(model.params.iter().zip(&fields.params).map(|(param, field)| {
        format!("({:?}, {:?}, self.{field})", param.name.text, DisplayUnit::si(param.unit.dimension).text)
    }));
    let others = model.limits.iter().map(|limit| {
        let least = match limit.range {
            Range::Positive => "Positive",
            Range::NotNegative => "Zero",
            Range::NotPositive => "Negative",
            Range::Share => "Share",
        };
        Limited::new(&limit.part, &limit.what, &limit.unit, least, limit.value)
    });
    let all = of_bodies(emission).into_iter().flatten().chain(others).filter(Limited::varies);
    let bindings = emission.parameters();
    let (entries, values): (Vec<String>, Vec<String>) =
        all.map(|limited| (limited.entry, inline(limited.value, &bindings))).unzip();
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
    let rows = model.rows.iter().map(|row| row.phi);
    let bodies = model.bodies.iter().flat_map(|body| [body.mass, body.inertia, body.centre.x, body.centre.y]);
    let limits = model.limits.iter().map(|limit| limit.value);
    let switches = model.switches.iter().map(|switch| switch.difference);
    let roots: Vec<Expr> = rows.chain(bodies).chain(limits).chain(switches).collect_vec();
    let read = algebra::symbols(&roots);
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
