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

use plm_cas::{Expr, Graph};

use crate::derive::Equations;
use crate::formulate::{Absolute, Function, Reduced};
use crate::model::Model;
use crate::report::Report;
use crate::span::Span;

/// Emitted source.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Code {
    /// Items in front of the module: the re-export of the type.
    pub before: String,
    /// The module's documentation, attributes, visibility and name, without its braces.
    pub module: String,
    /// Types and signatures that users see.
    pub public: String,
    /// What stands behind them.
    pub implementation: String,
    /// Identifiers of the public part and where the user wrote them.
    pub names: Vec<(String, Span)>,
}

impl Code {
    /// The whole source as one text.
    pub fn text(&self) -> String {
        let Code { before, module, public, implementation, .. } = self;
        format!("{before}{module} {{\n{public}\n{implementation}}}\n")
    }
}

/// Everything that emission reads.
pub(crate) struct Emission<'a> {
    pub(crate) model: &'a Model,
    pub(crate) graph: &'a Graph,
    pub(crate) equations: &'a Equations,
    pub(crate) program: &'a Absolute,
    /// The rung above 5 that was taken.
    pub(crate) reduced: Option<&'a Reduced>,
    pub(crate) report: &'a Report,
    /// Name of the type.
    pub(crate) name: String,
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
        Fields {
            params: model.params.iter().map(|param| params.unique(&param.name.text)).collect(),
            inputs: model.inputs.iter().map(|input| inputs.unique(&input.name.text)).collect(),
            states: model.states.iter().map(|state| starts.unique(&state.name.text)).collect(),
            outputs: model.outputs.iter().map(|output| accessors.unique(&output.name.text)).collect(),
            bodies,
        }
    }
}

/// Emits a mechanism on rung 5, or on the one above that is given.
pub(crate) fn emit(
    model: &Model,
    graph: &Graph,
    equations: &Equations,
    program: &Absolute,
    reduced: Option<&Reduced>,
    report: &Report,
) -> Code {
    let emission = Emission {
        model,
        graph,
        equations,
        program,
        reduced,
        report,
        name: names::ident(&model.name.text),
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
    Code {
        before: before(model),
        module: docs::module(&emission),
        public,
        implementation,
        names: respanned(&emission),
    }
}

/// `pub use self::double_pendulum::DoublePendulum;`
pub(crate) fn before(model: &Model) -> String {
    let name = names::ident(&model.name.text);
    let module = names::snake_case(&model.name.text);
    let visibility = &model.visibility;
    format!("#[doc(inline)]\n{visibility} use self::{module}::{name};\n")
}

/// Names of the public part whose declarations an editor should find.
fn respanned(emission: &Emission) -> Vec<(String, Span)> {
    let Emission { model, fields, .. } = emission;
    let mut names = vec![(emission.name.clone(), model.name.span)];
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

    /// The inputs, where `u` is what is held over a step.
    pub(crate) fn input(&self) -> &'static str {
        if self.loops().is_some() { "u.input" } else { "u" }
    }

    /// The type of what is held over a step, of numbers `scalar`.
    pub(crate) fn held(&self, scalar: &str) -> String {
        match self.loops() {
            Some(reduced) => {
                format!("rt::charts::Held<Input<{scalar}>, [{scalar}; {}]>", reduced.memory_length)
            }
            None => format!("Input<{scalar}>"),
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
        let (mechanism, input, state, time) = match origin {
            Origin::Arguments | Origin::Pose | Origin::Chart(_) => ("self", "u", "x", "t"),
            Origin::State => ("self.mechanism", "self.input", "self.x", "self.time"),
        };
        for (param, field) in model.params.iter().zip(&fields.params) {
            bindings.insert(param.symbol, format!("{mechanism}.{field}"));
        }
        for (declared, field) in model.inputs.iter().zip(&fields.inputs) {
            bindings.insert(declared.symbol, format!("{input}.{field}"));
        }
        for (k, side) in model.sides.iter().enumerate() {
            bindings.insert(side.symbol, format!("{input}.side_[{k}]"));
        }
        bindings.insert(model.time, time.to_owned());
        bindings.insert(model.most_growth, "lit(S::MOST_GROWTH)".to_owned());
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
