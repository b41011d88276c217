//! Writes the Rust source of a mechanism. No algebra happens here.
//!
//! The source is text, not token trees: rustc's own lexer reads it in a fraction of the time that building token trees
//! takes in an unoptimised macro, and it can be read as it stands (`cargo run -p plm-compiler --example dump`).

mod augmented;
mod blocks;
mod bodies;
mod charts;
mod defaults;
mod docs;
mod families;
mod limits;
mod linear;
mod lines;
mod mechanism;
pub(crate) mod names;
mod outputs;
mod pictures;
mod piece;
mod reduced;
mod sides;
mod singular;
mod solved;
mod statics;
mod system;
mod types;

use std::fmt::Write;

use plm_cas::Expr;

use crate::derive::Equations;
use crate::formulate::{Absolute, Function, Reduced};
use crate::model::Model;
use crate::report::Report;
use crate::span::Span;

/// Emitted source.
///
/// The one name of the user's own that is a type is that of the mechanism, and it may be any: `Option`, `State`, `S`. So the
/// type is defined in a module by itself, and the code has it under a name that nothing else in it has.
/// The outer module has a name that no crate has, so that the `use` in front of it means the same at module level and within
/// a function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Code {
    /// Items beside the outer module: the names that the user sees.
    pub before: String,
    /// Attributes and name of the outer module, without its braces.
    pub module: String,
    /// First in it: the module that the user sees, and the one that defines the mechanism's type.
    pub face: String,
    /// Name of the module of the code, without its braces.
    pub inner: String,
    /// First in that: types and signatures that users see.
    pub public: String,
    /// What stands behind them.
    pub implementation: String,
    /// Identifiers of the public part and where the user wrote them.
    pub names: Vec<(String, Span)>,
}

impl Code {
    /// The whole source as one text.
    pub fn text(&self) -> String {
        let Code { before, module, face, inner, public, implementation, .. } = self;
        format!("{before}{module} {{\n{face}{inner} {{\n{public}\n{implementation}}}\n}}\n")
    }
}

/// Everything that emission reads.
pub(crate) struct Emission<'a> {
    pub(crate) model: &'a Model,
    pub(crate) equations: &'a Equations,
    pub(crate) program: &'a Absolute,
    /// The rung above 5 that was taken.
    pub(crate) reduced: Option<&'a Reduced>,
    pub(crate) report: &'a Report,
    /// What stands for the name of the type until all is written.
    pub(crate) name: String,
    /// The name of the type as users see it.
    pub(crate) shown: String,
    /// Fields of `params`, `inputs`, starts of bodies and states: identifiers in the order of the model.
    pub(crate) fields: Fields,
}

/// Identifiers of the fields of the emitted types.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fields {
    pub(crate) params: Vec<String>,
    pub(crate) inputs: Vec<String>,
    pub(crate) bodies: Vec<String>,
    pub(crate) states: Vec<String>,
    /// Accessors of the outputs, beside those of the bodies.
    pub(crate) outputs: Vec<String>,
    /// Accessors of both by their indices.
    pub(crate) families: Vec<families::Family>,
}

/// Methods of the emitted state that no body or output may take, then those of a run, which would hide them, and those that
/// every type has. What is not for users ends in `_`, as no name of theirs does.
pub(crate) const METHODS: &[&str] = &[
    "time",
    "kinetic_energy",
    "gravity_energy",
    "load_power",
    "outputs",
    "undetermined",
    "branches",
    "starts",
    "find",
    "observed",
    "step",
    "step_to",
    "at",
    "reset",
    "run",
    "settle",
    "drift",
    "state",
    "method",
    "method_mut",
    "stats",
    "notice",
    "stop_at_change_points",
    "watch_energy",
    "count_states",
    "state_count",
    "save",
    "resume",
    "clone",
    "clone_from",
    "into",
    "try_into",
    "to_owned",
];

impl Fields {
    pub(crate) fn new(model: &Model) -> Fields {
        let mut params = names::Names::with_reserved(&["start"]);
        let mut inputs = names::Names::default();
        let mut accessors = names::Names::with_reserved(METHODS);
        let bodies: Vec<String> = model.bodies.iter().map(|body| accessors.unique(&body.name.text)).collect();
        let taken: Vec<&str> = bodies.iter().map(String::as_str).collect();
        let mut starts = names::Names::with_reserved(&taken);
        let outputs = model.outputs.iter().map(|output| accessors.unique(&output.name.text)).collect();
        Fields {
            params: model.params.iter().map(|param| params.unique(&param.name.text)).collect(),
            inputs: model.inputs.iter().map(|input| inputs.unique(&input.name.text)).collect(),
            states: model.states.iter().map(|state| starts.unique(&state.name.text)).collect(),
            outputs,
            families: families::find(model, &mut accessors),
            bodies,
        }
    }
}

/// Emits a mechanism on rung 5, or on the one above that is given.
pub(crate) fn emit(
    model: &Model,
    equations: &Equations,
    program: &Absolute,
    reduced: Option<&Reduced>,
    report: &Report,
) -> Code {
    let emission = Emission {
        model,
        equations,
        program,
        reduced,
        report,
        name: names::STAND_IN.to_owned(),
        shown: names::type_name(&model.name.text),
        fields: Fields::new(model),
    };
    let mut public = types::emit(&emission);
    pictures::emit(&mut public, &emission);
    public.push_str(&outputs::emit(&emission));
    let mut implementation = defaults::emit(&emission);
    implementation.push_str(&system::emit(&emission));
    implementation.push_str(&linear::emit(&emission));
    implementation.push_str(&statics::emit(&emission));
    implementation.push_str(&bodies::emit(&emission));
    implementation.push_str(&reduced::emit(&emission));
    augmented::emit(&mut implementation, &emission);
    sides::instants(&mut implementation, &emission);
    let known_as = names::free_in(&emission.shown, &[&public, &implementation]);
    let import = if known_as == emission.shown {
        known_as.to_owned()
    } else {
        format!("{} as {known_as}", emission.shown)
    };
    public.insert_str(0, &format!("    use super::type_::{import};\n"));
    let [public, implementation] =
        [public, implementation].map(|text| text.replace(names::STAND_IN, known_as));
    let module = names::module_name(&model.name.text);
    Code {
        before: before(model, &emission.shown, &module),
        module: format!("{} mod plm_{module}_", docs::ALLOWED),
        face: face(&emission, &module),
        inner: "mod code_".to_owned(),
        public,
        implementation,
        names: respanned(&emission),
    }
}

/// `pub use plm_double_pendulum_::double_pendulum::DoublePendulum;`, and the module.
fn before(model: &Model, name: &str, module: &str) -> String {
    let visibility = &model.visibility;
    format!(
        "#[doc(inline)]
#[allow(unreachable_pub)]
{visibility} use plm_{module}_::{module}::{name};
#[doc(inline)]
#[allow(unreachable_pub, unused_imports)]
{visibility} use plm_{module}_::{module};
"
    )
}

/// The module that users see, with its documentation, and the definition of the type.
fn face(emission: &Emission, module: &str) -> String {
    let name = &emission.shown;
    let mut text = docs::module(emission);
    // A name that is imported by itself goes before one of the same kind that comes with all others.
    push(
        &mut text,
        format_args!(
            "pub mod {module} {{
    pub use super::code_::*;
    pub use super::type_::{name};
}}

mod type_ {{
{}}}

",
            types::mechanism(emission)
        ),
    );
    text
}

/// Names of the public part whose declarations an editor should find.
fn respanned(emission: &Emission) -> Vec<(String, Span)> {
    let Emission { model, fields, .. } = emission;
    let mut names = vec![(emission.shown.clone(), model.name.span)];
    names.extend(fields.params.iter().cloned().zip(model.params.iter().map(|param| param.name.span)));
    names.extend(fields.inputs.iter().cloned().zip(model.inputs.iter().map(|input| input.name.span)));
    names.extend(fields.bodies.iter().cloned().zip(model.bodies.iter().map(|body| body.name.span)));
    names.extend(fields.states.iter().cloned().zip(model.states.iter().map(|state| state.name.span)));
    names.retain(|(_, span)| span.source == 0);
    names
}

/// Where the symbols of the model are found in an emitted function.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Origin {
    /// `self` is the mechanism; time, inputs and state are arguments `t`, `u`, `x`.
    Arguments,
    /// `self` is the mechanism; coordinates and velocities are arguments `q`, `v`.
    Pose,
    /// `self` is a `State`; on a rung above 5 the pose is in the locals `q`, `v`.
    State,
    /// `self` is the mechanism; `x` is the state in this chart of a rung above 5, `m` what is remembered.
    Chart(usize),
}

impl Emission<'_> {
    /// Numbers in the state, and how many of them stand before the first-order states.
    pub(crate) fn state_length(&self) -> (usize, usize) {
        let second_order = 2 * self.reduced.map_or(self.equations.q.len(), Reduced::freedom);
        (second_order + self.equations.x.len(), second_order)
    }

    /// The mechanism, if its loops are solved in charts.
    pub(crate) fn loops(&self) -> Option<&Reduced> {
        self.reduced.filter(|reduced| reduced.has_loops())
    }

    /// Accelerations and multipliers of a tree; where there are none, rung 5 gives them.
    pub(crate) fn reactions(&self) -> Option<&Function> {
        self.reduced?.first()?.reactions.as_ref()
    }

    /// Does an output read accelerations or multipliers?
    pub(crate) fn reads_solution(&self) -> bool {
        self.program.outputs.user.iter().any(|output| output.solves)
    }

    /// The inputs with the sides of conditions, where `u` is what is held over a step.
    pub(crate) fn input(&self) -> &'static str {
        if self.loops().is_some() { "u.input" } else { "u" }
    }

    /// Are there sides of conditions beside the inputs? Users make and set values of `Input`, so that they stand apart.
    pub(crate) fn has_sides(&self) -> bool {
        !self.model.sides.is_empty()
    }

    /// The type of the inputs with the sides of conditions, of numbers `scalar`.
    pub(crate) fn inputs(&self, scalar: &str) -> String {
        if self.has_sides() { format!("Held<{scalar}>") } else { format!("Input<{scalar}>") }
    }

    /// Their value, where `self` is a `State`.
    pub(crate) fn inputs_of_state(&self) -> &'static str {
        if self.has_sides() { "Held { input: self.input, sides: self.sides }" } else { "self.input" }
    }

    /// From them to the fields of the inputs.
    pub(crate) fn to_fields(&self) -> &'static str {
        if self.has_sides() { ".input" } else { "" }
    }

    /// The type of what is held over a step, of numbers `scalar`.
    pub(crate) fn held(&self, scalar: &str) -> String {
        let inputs = self.inputs(scalar);
        match self.loops() {
            Some(reduced) => format!("rt::charts::Held<{inputs}, [{scalar}; {}]>", reduced.memory_length),
            None => inputs,
        }
    }

    /// The line that gives an accessor of `State` the pose, where that is not the state itself.
    pub(crate) fn pose_line(&self) -> &'static str {
        if self.reduced.is_some() { "            let (q, v) = self.pose_();\n" } else { "" }
    }

    /// Source text of the parameters, where `self` is the mechanism.
    pub(crate) fn parameters(&self) -> lines::Bindings {
        let params = self.model.params.iter().zip(&self.fields.params);
        params.map(|(param, field)| (param.symbol, format!("self.{field}"))).collect()
    }

    /// Source text of every symbol.
    pub(crate) fn bindings(&self, origin: Origin) -> lines::Bindings {
        let mut bindings = lines::Bindings::new();
        let Emission { model, equations, fields, .. } = self;
        let (mechanism, held, state, time) = match origin {
            Origin::Arguments | Origin::Pose | Origin::Chart(_) => ("self", "u", "x", "t"),
            Origin::State => ("self.mechanism", "self", "self.x", "self.time"),
        };
        let input = if held == "u" { self.to_fields() } else { ".input" };
        for (param, field) in model.params.iter().zip(&fields.params) {
            bindings.insert(param.symbol, format!("{mechanism}.{field}"));
        }
        for (declared, field) in model.inputs.iter().zip(&fields.inputs) {
            bindings.insert(declared.symbol, format!("{held}{input}.{field}"));
        }
        for (k, side) in model.sides.iter().enumerate() {
            bindings.insert(side.symbol, format!("{held}.sides[{k}]"));
        }
        bindings.insert(model.time, time.to_owned());
        bindings.insert(model.most_growth, "lit(S::MOST_GROWTH)".to_owned());
        bindings.insert(model.agreement, "lit(S::AGREEMENT)".to_owned());
        let nq = equations.q.len();
        let mut bind = |symbols: &[Expr], array: &str, offset: usize| {
            for (k, &symbol) in symbols.iter().enumerate() {
                bindings.insert(symbol, format!("{array}[{}]", offset + k));
            }
        };
        match (origin, self.reduced) {
            (Origin::Pose, _) => {
                bind(&equations.q, "q", 0);
                bind(&equations.v, "v", 0);
            }
            (Origin::State, Some(reduced)) => {
                bind(&equations.q, "q", 0);
                bind(&equations.v, "v", 0);
                bind(&equations.x, state, 2 * reduced.freedom());
            }
            (Origin::Chart(index), Some(reduced)) => {
                let chart = &reduced.charts[index];
                bind(&chart.y, state, 0);
                bind(&chart.y_dot, state, chart.y.len());
                bind(&equations.x, state, 2 * chart.y.len());
                bind(&reduced.memory, "m", 0);
                if let Some(augmented) = &chart.augmented {
                    bind(&augmented.accelerations, "dx", chart.y.len());
                }
            }
            _ => {
                bind(&equations.q, state, 0);
                bind(&equations.v, state, nq);
                bind(&equations.x, state, 2 * nq);
            }
        }
        bind(&equations.a, "a", 0);
        bind(&equations.lambda, "lambda", 0);
        bind(&self.program.weights, "w", 0);
        bind(&self.program.residual, "r", 0);
        bindings
    }
}

/// Appends formatted text.
pub(crate) fn push(text: &mut String, content: std::fmt::Arguments) {
    let _ = text.write_fmt(content);
}
