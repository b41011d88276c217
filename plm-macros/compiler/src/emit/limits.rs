//! What the parameters may be, which of them the mechanism is assembled by, how that is done again, and whether it must be.

use std::fmt::Write;

use plm_cas::{Expr, algebra};

use super::{Emission, defaults, push};
use crate::units::DisplayUnit;

/// `check`, `fingerprint`, `renew` and `opening`, in `Mechanism`.
pub(crate) fn emit(text: &mut String, emission: &Emission) {
    check(text, emission);
    renew(text, emission);
    opening(text, emission);
}

/// A call of `check`, where there are parameters.
pub(crate) fn call(emission: &Emission) -> &'static str {
    if emission.model.params.is_empty() { "" } else { "            rt::Mechanism::check(self, t)?;\n" }
}

/// A limited value: of which part, what, its unit, which least, and what it is.
struct Limited {
    entry: String,
    value: Expr,
}

fn limited(part: &str, what: &str, unit: &str, least: &str, value: Expr) -> Limited {
    let entry =
        format!("rt::Limit {{ part: {part:?}, what: {what:?}, unit: {unit:?}, least: rt::Least::{least} }}");
    Limited { entry, value }
}

/// May a body be without mass, if others carry it? Absolute coordinates divide by each mass.
fn may_be_carried(emission: &Emission) -> bool {
    emission.reduced.is_some() && (emission.reactions().is_some() || !emission.reads_solution())
}

/// Mass and inertia of every body.
fn of_bodies(emission: &Emission) -> Vec<[Limited; 2]> {
    let least = if may_be_carried(emission) { "Carried" } else { "Positive" };
    let bodies = emission.model.bodies.iter().map(|body| {
        let name = &body.name.text;
        [
            limited(name, "mass", "kg", least, body.mass),
            limited(name, "inertia", "kg*m^2", least, body.inertia),
        ]
    });
    bodies.collect()
}

fn check(text: &mut String, emission: &Emission) {
    let Emission { model, fields, .. } = emission;
    if model.params.is_empty() {
        return;
    }
    let bindings = emission.parameters();
    let numbers = model.params.iter().zip(&fields.params).map(|(param, field)| {
        format!("({:?}, {:?}, self.{field})", param.name.text, DisplayUnit::si(param.unit.dimension).text)
    });
    let numbers: Vec<String> = numbers.collect();
    let others = model.limits.iter().map(|limit| {
        let least = if limit.or_zero { "Zero" } else { "Positive" };
        limited(&limit.part, &limit.what, &limit.unit, least, limit.value)
    });
    // Constants have been looked at.
    let varies = |limited: &Limited| limited.value.as_number().is_none();
    let all: Vec<Limited> = of_bodies(emission).into_iter().flatten().chain(others).filter(varies).collect();
    let mut limits = String::new();
    if !all.is_empty() {
        let values: String = all.iter().fold(String::new(), |mut list, limited| {
            let _ =
                writeln!(list, "                {},", defaults::inline(emission, limited.value, &bindings));
            list
        });
        let entries: Vec<&str> = all.iter().map(|limited| limited.entry.as_str()).collect();
        limits = format!(
            "            const LIMITS: [rt::Limit; {count}] = [
                {entries}
            ];
            #[allow(unused_variables)] // where no value is a formula
            let lit = S::lit;
            let values = [
{values}            ];
            rt::limits::check(t, &values, &LIMITS)?;
",
            count = all.len(),
            entries = entries.join(",\n                "),
        );
    }
    push(
        text,
        format_args!(
            "        fn check(&self, t: S) -> Result<(), Fault> {{
            rt::limits::check_numbers(t, [{}])?;
{limits}            Ok(())
        }}

",
            numbers.join(", ")
        ),
    );
}

/// After assembly in `start_state`: bodies without mass must be carried, where parameters can make some.
pub(crate) fn carried(emission: &Emission) -> String {
    let bodies = of_bodies(emission);
    let varies = |limited: &Limited| limited.value.as_number().is_none();
    if !may_be_carried(emission) || !bodies.iter().flatten().any(varies) {
        return String::new();
    }
    let entries = bodies.iter().map(|[mass, inertia]| format!("[{}, {}]", mass.entry, inertia.entry));
    let entries: Vec<String> = entries.collect();
    format!(
        "            const BODIES: [[rt::Limit; 2]; {}] = [
                {}
            ];
            absolute::check_carried::<S, Self, NQ, NC>(self, t, &assembly.q, &BODIES)?;
",
        bodies.len(),
        entries.join(",\n                ")
    )
}

/// Fields of the parameters that joints, masses or known times read.
fn shaping<'a>(emission: &'a Emission) -> Vec<&'a str> {
    let Emission { model, fields, .. } = emission;
    let mut roots: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect();
    roots
        .extend(model.bodies.iter().flat_map(|body| [body.mass, body.inertia, body.centre.x, body.centre.y]));
    roots.extend(model.limits.iter().map(|limit| limit.value));
    roots.extend(model.sides.iter().map(|side| side.difference));
    let read = algebra::symbols(&roots);
    let params = model.params.iter().zip(&fields.params);
    params.filter(|(param, _)| read.contains(&param.symbol)).map(|(_, field)| field.as_str()).collect()
}

fn renew(text: &mut String, emission: &Emission) {
    let shaping = shaping(emission);
    if shaping.is_empty() {
        return;
    }
    let ((length, _), nq, held) = (emission.state_length(), emission.equations.q.len(), emission.held("S"));
    let (pose, back) = match emission.reduced {
        Some(reduced) if reduced.has_loops() => {
            ("rt::charts::pose(self, t, held, x)", "rt::charts::enter(self, t, held, (&q, &v), x)".to_owned())
        }
        Some(_) => (
            "<State<S> as rt::Moment>::new(*self, *held, t, *x).pose_()",
            "self.project(t, &q, &v, x)".to_owned(),
        ),
        None => ("absolute::split(x)", "absolute::join(&q, &v, x)".to_owned()),
    };
    let unused = if emission.reduced.is_none() { "            let _ = held;\n" } else { "" };
    let fields: Vec<String> = shaping.iter().map(|field| format!("self.{field}")).collect();
    push(
        text,
        format_args!(
            "        fn fingerprint(&self) -> u64 {{
            rt::limits::fingerprint([{}])
        }}

        fn renew(&self, t: S, held: &mut {held}, x: &mut [S; {length}]) -> Result<(), Fault> {{
{unused}            let (mut q, mut v): ([S; {nq}], [S; {nq}]) = {pose};
            absolute::renew::<S, Self, NQ, NC>(self, t, &mut q, &mut v)?;
            {back};
            Ok(())
        }}

",
            fields.join(", ")
        ),
    );
}

/// How far joints are open that joint coordinates keep closed.
fn opening(text: &mut String, emission: &Emission) {
    if emission.reduced.is_none() {
        return;
    }
    let ((length, _), held) = (emission.state_length(), emission.held("S"));
    push(
        text,
        format_args!(
            "        fn opening(&self, t: S, held: &{held}, x: &[S; {length}]) -> rt::Drift<S> {{
            let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
            absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
        }}

"
        ),
    );
}
