//! Constructors: declared parameters, starts and inputs as values, and the way into a run.

use plm_cas::Expr;

use super::lines::{self, Bindings};
use super::{Emission, blocks, docs, limits, piece, push};
use crate::formulate::{Function, Place};
use crate::model::{Body, Start};

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    constructors(&mut text, emission);
    start_input(&mut text, emission);
    text
}

fn constructors(text: &mut String, emission: &Emission) {
    let Emission { name, shown, .. } = emission;
    let required = Required::of(emission);
    let [of_f64, of_any] = ["f64", "S"].map(|scalar| required.signature(scalar));
    let (docs, names) = (&required.docs, required.fields.join(", "));
    push(
        text,
        format_args!(
            "    impl {name}<f64> {{
        /// The mechanism as declared, in `f64`; `{shown} {{ field: value, ..{shown}::new({names}) }}` changes some.
{docs}        pub fn new({of_f64}) -> Self {{
            Self::of({names})
        }}
    }}

"
        ),
    );
    if names.is_empty() {
        push(
            text,
            format_args!(
                "    impl Default for {name}<f64> {{
        fn default() -> Self {{
            Self::of()
        }}
    }}

"
            ),
        );
    }
    push(
        text,
        format_args!(
            "    impl<S: Scalar> {name}<S> {{
        /// The mechanism as declared, for any scalar.
{docs}        pub fn of({of_any}) -> Self {{
"
        ),
    );
    parameters(text, emission);
    text.push_str("        }\n    }\n\n");
    push(
        text,
        format_args!(
            "    impl<S: Real> {name}<S> {{
        /// Closes the joints from the start values, as the manual's assembly does (section 4.4).
        ///
        /// # Errors
        /// Redundant locks, or joints that stay open: the part and by how much; a parameter that cannot have its value.
        pub fn assemble(&self) -> Result<Assembly<S>, Fault> {{
            let t = S::lit(0.0);
{check}            let assembly = absolute::assemble(self, t)?;
{carried}            Ok(assembly)
        }}

        /// Assembles, and gives a run by Dormand and Prince's method.
        ///
        /// # Errors
        /// As [`Self::assemble`].
        pub fn start(self) -> Result<Sim<Self>, Fault> {{
            rt::Mechanism::start(self)
        }}

        /// Assembles, and gives a run by a method of choice.
        ///
        /// # Errors
        /// As [`Self::assemble`].
        pub fn start_with<I: Method<Self>>(self, method: I) -> Result<Sim<Self, I>, Fault> {{
            rt::Mechanism::start_with(self, method)
        }}
    }}

",
            check = limits::call(emission),
            carried = limits::carried(emission),
        ),
    );
}

/// The parameters without a default, which the constructors take.
struct Required {
    docs: String,
    fields: Vec<String>,
}

impl Required {
    fn of(emission: &Emission) -> Required {
        let Emission { model, fields, .. } = emission;
        let all = model.params.iter().zip(&fields.params).filter(|(param, _)| param.required);
        let mut docs = String::new();
        let mut fields_taken = Vec::new();
        for (param, field) in all {
            let (own, unit) = (&param.name.text, docs::si(&param.unit));
            push(
                &mut docs,
                format_args!(
                    "        ///\n        /// `{field}`: parameter `{own}`, {unit}; it has no default.\n"
                ),
            );
            fields_taken.push(field.clone());
        }
        if fields_taken.len() > 7 {
            docs.push_str("        #[allow(clippy::too_many_arguments)] // As many as were declared without a default.\n");
        }
        Required { docs, fields: fields_taken }
    }

    fn signature(&self, scalar: &str) -> String {
        let all: Vec<String> = self.fields.iter().map(|field| format!("{field}: {scalar}")).collect();
        all.join(", ")
    }
}

/// The body of `of`: parameters in order, since a default may read earlier ones, then the starts.
fn parameters(text: &mut String, emission: &Emission) {
    let Emission { model, fields, name, .. } = emission;
    let mut bindings = Bindings::new();
    text.push_str("            let lit = S::lit;\n");
    for (param, field) in model.params.iter().zip(&fields.params) {
        if !param.required {
            let value = inline(emission, param.default, &bindings);
            push(text, format_args!("            let {field} = {value};\n"));
        }
        bindings.insert(param.symbol, field.clone());
    }
    text.push_str("            let start = Starts {\n");
    for (body, field) in model.bodies.iter().zip(&fields.bodies) {
        push(text, format_args!("                {field}: {},\n", body_start(emission, body, &bindings)));
    }
    for (state, field) in model.states.iter().zip(&fields.states) {
        let kind = if state.locked { "locked" } else { "free" };
        let value = inline(emission, state.start, &bindings);
        push(text, format_args!("                {field}: Start::{kind}({value}),\n"));
    }
    text.push_str("            };\n");
    let mut list = fields.params.clone();
    list.push("start".to_owned());
    push(text, format_args!("            {name} {{ {} }}\n", list.join(", ")));
}

fn body_start(emission: &Emission, body: &Body, bindings: &Bindings) -> String {
    let names = ["x", "y", "angle", "vx", "vy", "omega"];
    let starts = body.start.iter().chain(&body.start_velocity);
    let entry = |(name, start): (&str, &Start)| {
        let kind = if start.locked { "locked" } else { "free" };
        format!("{name}: Start::{kind}({})", inline(emission, start.value, bindings))
    };
    let entries: Vec<String> = names.into_iter().zip(starts).map(entry).collect();
    format!("BodyStart {{ {} }}", entries.join(", "))
}

/// An expression of parameters as one Rust expression; a block where it needs locals.
pub(crate) fn inline(_emission: &Emission, expr: Expr, bindings: &Bindings) -> String {
    if let Some(number) = expr.as_number() {
        return piece::literal(number.to_f64());
    }
    let function = Function::of_results(vec![(Place::Value, expr)]);
    let reserved: Vec<&str> = bindings.values().map(String::as_str).chain(["lit"]).collect();
    let lines = lines::lower(&function, bindings, &reserved);
    match (&lines.value, lines.statements.is_empty()) {
        (Some((value, _)), true) => value.clone(),
        _ => format!("{{\n{}            }}", blocks::body(&lines, 16)),
    }
}

fn start_input(text: &mut String, emission: &Emission) {
    let Emission { model, fields, name, .. } = emission;
    let inputs = emission.inputs("S");
    push(
        text,
        format_args!(
            "    impl<S: Scalar> {name}<S> {{
        /// The inputs as declared.
        fn declared_input(&self) -> {inputs} {{
            let lit = S::lit;
"
        ),
    );
    let bindings = emission.parameters();
    let mut entries: Vec<String> = Vec::new();
    for (input, field) in model.inputs.iter().zip(&fields.inputs) {
        entries.push(format!("{field}: {}", inline(emission, input.default, &bindings)));
    }
    if entries.is_empty() {
        entries.push("none: core::marker::PhantomData".to_owned());
    }
    let mut value = format!("Input {{ {} }}", entries.join(", "));
    if emission.has_sides() {
        value = format!("Held {{ input: {value}, sides: [S::lit(1.0); {}] }}", model.sides.len());
    }
    push(text, format_args!("            {value}\n        }}\n    }}\n\n"));
}
