//! Declarations in, numbers out.

use std::collections::BTreeMap;

use plm_cas::{Expr, Tape};
use plm_compiler::diag::Diagnostics;
use plm_compiler::front::parse_and_resolve;
use plm_compiler::model::Model;
use plm_compiler::token::Sources;

use crate::random::Random;

/// The model of a declaration that has no mistake.
pub(crate) fn resolve(text: &str) -> Model {
    let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
    sources.add_text("declaration", text);
    let model = parse_and_resolve(&mut sources, &mut sink);
    // What is declared here is looked at by the test, and need not be read.
    sink.drop_hints();
    let messages: Vec<String> = sink.sorted().iter().map(|diagnostic| diagnostic.render(&sources)).collect();
    assert!(messages.is_empty(), "{}", messages.join("\n"));
    model.unwrap()
}

/// Values of symbols. Unknown ones are asked for by name, so that a test says only what matters.
#[derive(Clone, Default)]
pub(crate) struct Values {
    of: BTreeMap<Expr, f64>,
}

impl Values {
    /// Parameters and inputs at their defaults, everything else zero.
    pub(crate) fn of(model: &Model) -> Values {
        let mut values = Values::default();
        let motion = model.bodies.iter().flat_map(|body| [body.q, body.v, body.a]).flatten();
        let unknown = motion.chain(model.rows.iter().map(|row| row.lambda)).chain([model.time]);
        values.of.extend(unknown.map(|symbol| (symbol, 0.0)));
        let defaults = model.params.iter().map(|param| (param.symbol, param.default));
        let defaults = defaults.chain(model.inputs.iter().map(|input| (input.symbol, input.default)));
        for (symbol, default) in defaults.chain(model.states.iter().map(|state| (state.symbol, state.start)))
        {
            let value = values.at(model, default);
            values.of.insert(symbol, value);
        }
        values
    }

    pub(crate) fn set(&mut self, symbol: Expr, value: f64) {
        self.of.insert(symbol, value);
    }

    pub(crate) fn get(&self, symbol: Expr) -> f64 {
        self.of[&symbol]
    }

    /// Pose of a body: x, y, theta.
    pub(crate) fn pose(&mut self, model: &Model, body: &str, pose: [f64; 3]) {
        let body = model.bodies.iter().find(|of| of.name.text == body).unwrap();
        (0..3).for_each(|i| self.set(body.q[i], pose[i]));
    }

    /// All poses, velocities and accelerations at random within 1, by a seed.
    pub(crate) fn scatter(&mut self, model: &Model, seed: u64) {
        let mut random = Random(seed);
        for body in &model.bodies {
            for symbol in [body.q, body.v, body.a].into_iter().flatten() {
                self.set(symbol, random.unit());
            }
        }
    }

    /// The value of an expression.
    pub(crate) fn at(&self, model: &Model, expr: Expr) -> f64 {
        let bindings: Vec<(Expr, f64)> = self.of.iter().map(|(symbol, value)| (*symbol, *value)).collect();
        let tape = Tape::new(&model.graph, &[expr]);
        let name = |symbol: Expr| model.graph.name(symbol).unwrap_or("?").to_string();
        tape.eval(&bindings).unwrap_or_else(|missing| panic!("no value of {}", name(missing)))[0]
    }
}

/// Components of an output.
pub(crate) fn output(model: &Model, values: &Values, name: &str) -> Vec<f64> {
    let output =
        model.outputs.iter().find(|output| output.name.text == name).unwrap_or_else(|| panic!("{name}"));
    output.components.iter().map(|component| values.at(model, *component)).collect()
}

/// A single output of a declaration, at the defaults.
pub(crate) fn value_of(text: &str) -> f64 {
    let model = resolve(text);
    values_of_first(&model)
}

fn values_of_first(model: &Model) -> f64 {
    Values::of(model).at(model, model.outputs[0].components[0])
}

/// The value of an expression with nothing around it.
pub(crate) fn evaluate(expr: &str) -> f64 {
    value_of(&format!(
        "pub P {{ param a: m = 3 m; param b: m = 4 m; param n: 1 = 5; output value = {expr}; }}"
    ))
}

pub(crate) fn assert_near(found: f64, expected: f64, what: &str) {
    let tolerance = 1e-12 * expected.abs().max(1.0);
    assert!((found - expected).abs() <= tolerance, "{what}: found {found}, expected {expected}");
}
