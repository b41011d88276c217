//! What derivatives need of a mechanism: itself in dual numbers, its inputs and outputs by number.
//!
//! All of it is generic: nothing is compiled where nobody differentiates.

use super::{Emission, docs, push};

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    lift(&mut text, emission);
    ports(&mut text, emission);
    text
}

/// `Linear`: every number of the mechanism and of what it holds becomes a constant with derivatives.
fn lift(text: &mut String, emission: &Emission) {
    let Emission { model, fields, name, .. } = emission;
    let (length, _) = emission.state_length();
    let list = |fields: &[String], from: &str| {
        each(fields, |_, field| format!("                {field}: lift({from}.{field}),\n"))
    };
    let bodies =
        each(&fields.bodies, |_, field| format!("                {field}: self.start.{field}.map(lift),\n"));
    let inputs = if model.inputs.is_empty() {
        "                none: core::marker::PhantomData,\n".to_owned()
    } else {
        list(&fields.inputs, if emission.loops().is_some() { "held.input" } else { "held" })
    };
    let source = if emission.loops().is_some() { "held.input" } else { "held" };
    let inputs = if model.sides.is_empty() {
        inputs
    } else {
        format!("{inputs}                side: {source}.side.map(lift),\n")
    };
    let (held, lifted) = (emission.held("S"), emission.held("rt::Dual<S, K>"));
    let wrapped = if emission.loops().is_some() {
        "rt::charts::Held { input, chart: held.chart, memory: held.memory.map(lift) }"
    } else {
        "input"
    };
    let constraints = if emission.reduced.is_some() {
        String::new()
    } else {
        format!(
            "
        fn constraints(&self, t: S, x: &[S; {length}], row: &mut impl FnMut(S)) {{
            absolute::residuals::<S, Self, NQ, NC, {length}>(self, t, x, row);
        }}
"
        )
    };
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::Linear for {name}<S> {{
        type Lifted<const K: usize> = {name}<rt::Dual<S, K>>;

        fn lift<const K: usize>(&self, held: &{held}) -> ({name}<rt::Dual<S, K>>, {lifted}) {{
            let lift = rt::Dual::constant;
            let start = Starts {{
{bodies}{states}            }};
            let mechanism = {name} {{
                start,
{params}            }};
            let input = Input {{
{inputs}            }};
            (mechanism, {wrapped})
        }}
{constraints}    }}

",
            states = list(&fields.states, "self.start"),
            params = list(&fields.params, "self"),
        ),
    );
}

/// `Ports`: inputs and outputs in the order of the declaration.
fn ports(text: &mut String, emission: &Emission) {
    let Emission { model, fields, name, .. } = emission;
    let names =
        model.inputs.iter().map(|input| format!("({:?}, {:?})", input.name.text, docs::si(&input.unit)));
    let names: Vec<String> = names.collect();
    let input = if emission.loops().is_some() { "held.input" } else { "held" };
    let held = emission.held("S");
    let arms =
        each(&fields.inputs, |k, field| format!("                {k} => Some(&mut {input}.{field}),\n"));
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::Ports for {name}<S> {{
        const INPUTS: &'static [(&'static str, &'static str)] = &[{}];
        const OUTPUTS: &'static [(&'static str, &'static str)] = &State::<S>::OUTPUTS;

        fn input(held: &mut {held}, index: usize) -> Option<&mut S> {{
            match index {{
{arms}                _ => None,
            }}
        }}

        fn outputs(state: &State<S>, each: &mut impl FnMut(S)) {{
            for output in state.outputs() {{
                each(output);
            }}
        }}
    }}

",
            names.join(", ")
        ),
    );
}

/// A line for every field.
fn each(fields: &[String], line: impl Fn(usize, &str) -> String) -> String {
    let lines: Vec<String> = fields.iter().enumerate().map(|(k, field)| line(k, field)).collect();
    lines.concat()
}
