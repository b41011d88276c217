//! The types that users see: the mechanism with its parameters, starts, inputs, and a state that can be read.

use super::{Emission, docs, push};

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    let path = &emission.model.crate_path;
    push(
        &mut text,
        format_args!(
            "    use {path}::runtime::{{BodyStart, BodyState, Fault, Method, Operations, Real, Scalar, Sim, Start}};\n\n"
        ),
    );
    starts(&mut text, emission);
    inputs(&mut text, emission);
    state(&mut text, emission);
    sizes(&mut text, emission);
    text
}

/// The mechanism itself; its name is the only one beside it that it must not meet.
pub(crate) fn mechanism(emission: &Emission) -> String {
    let Emission { model, fields, shown, .. } = emission;
    let scalar = if shown == "S" { "T" } else { "S" };
    let mut text = String::new();
    docs::lines(&mut text, 4, &model.docs);
    if model.docs.is_empty() {
        docs::lines(&mut text, 4, &["A mechanism with its parameters and start values.".to_owned()]);
    }
    push(
        &mut text,
        format_args!(
            "    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct {shown}<{scalar} = ::core::primitive::f64> {{\n"
        ),
    );
    for (param, field) in model.params.iter().zip(&fields.params) {
        let default = if param.required {
            "; it has no default".to_owned()
        } else {
            docs::by_default(param.default, &param.unit)
        };
        let what = format!("Parameter `{}`", param.name.text);
        docs::field(&mut text, &param.docs, &what, &param.unit, &default);
        push(&mut text, format_args!("        pub {field}: {scalar},\n"));
    }
    push(
        &mut text,
        format_args!(
            "        /// Where the bodies start, and what assembly must keep.
        pub start: super::code_::Starts<{scalar}>,
    }}
"
        ),
    );
    text
}

fn starts(text: &mut String, emission: &Emission) {
    let Emission { model, fields, .. } = emission;
    text.push_str("    /// Start values, SI units.\n    #[derive(Clone, Copy, Debug, PartialEq)]\n");
    text.push_str("    pub struct Starts<S = f64> {\n");
    for (body, field) in model.bodies.iter().zip(&fields.bodies) {
        push(text, format_args!("        /// Origin of body `{}`.\n", body.name.text));
        push(text, format_args!("        pub {field}: BodyStart<S>,\n"));
    }
    for (state, field) in model.states.iter().zip(&fields.states) {
        docs::field(text, &[], &format!("State `{}`", state.name.text), &state.unit, "");
        push(text, format_args!("        pub {field}: Start<S>,\n"));
    }
    text.push_str("    }\n\n");
}

fn inputs(text: &mut String, emission: &Emission) {
    let Emission { model, fields, .. } = emission;
    text.push_str(
        "    /// Inputs, held over a step, SI units.\n    #[derive(Clone, Copy, Debug, PartialEq)]\n",
    );
    text.push_str("    pub struct Input<S = f64> {\n");
    for (input, field) in model.inputs.iter().zip(&fields.inputs) {
        let default = docs::by_default(input.default, &input.unit);
        docs::field(text, &input.docs, &format!("Input `{}`", input.name.text), &input.unit, &default);
        push(text, format_args!("        pub {field}: S,\n"));
    }
    if model.inputs.is_empty() {
        text.push_str("        #[doc(hidden)]\n        pub none: core::marker::PhantomData<S>,\n");
    }
    text.push_str("    }\n\n");
    if emission.has_sides() {
        push(
            text,
            format_args!(
                "    /// What is held over a step: the inputs, and on which side of each condition the mechanism is.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Held<S = f64> {{
        /// The inputs.
        pub input: Input<S>,
        sides: [S; {}],
    }}

",
                model.sides.len()
            ),
        );
    }
}

fn state(text: &mut String, emission: &Emission) {
    let Emission { name, .. } = emission;
    let (length, _) = emission.state_length();
    let memory = emission.loops().map_or_else(String::new, |reduced| {
        format!("        chart: usize,\n        memory: [S; {}],\n", reduced.memory_length)
    });
    let sides = match emission.model.sides.len() {
        0 => String::new(),
        count => format!("        sides: [S; {count}],\n"),
    };
    push(
        text,
        format_args!(
            "    /// The mechanism at one moment; its methods read poses and outputs.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct State<S = f64> {{
        /// The mechanism with its parameters.
        pub mechanism: {name}<S>,
        /// The inputs.
        pub input: Input<S>,
        time: S,
        x: [S; {length}],
{sides}{memory}    }}

"
        ),
    );
}

fn sizes(text: &mut String, emission: &Emission) {
    let Emission { equations, report, .. } = emission;
    let constants = [
        ("NQ", equations.q.len(), "Coordinates: (x, y, theta) of each body."),
        ("NC", equations.phi.len(), "Constraint rows."),
        ("NX", equations.x.len(), "First-order states."),
    ];
    for (constant, value, doc) in constants {
        push(text, format_args!("    /// {doc}\n    pub const {constant}: usize = {value};\n"));
    }
    push(
        text,
        format_args!(
            "    /// Degrees of freedom, `3 N - M`.\n    pub const NDOF: isize = {};\n",
            report.freedom
        ),
    );
    let count = &report.rate;
    push(
        text,
        format_args!(
            "    /// Operations of one evaluation of the right-hand side.\n    pub const OPERATIONS: Operations = {};\n",
            docs::operations(count)
        ),
    );
}
