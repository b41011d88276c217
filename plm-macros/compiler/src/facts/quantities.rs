//! Quantities that a mechanism names, with unit, documentation and declared value.

use crate::collect::{CollectVec, PushAll};
use plm_cas::Expr;

use crate::model::{Model, Name};
use crate::numeric::value;
use crate::tables::{declared_values, exponents};
use crate::units::DisplayUnit;

/// A quantity with its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Its name in the declaration.
    pub name: String,
    /// Its documentation, line by line.
    pub docs: String,
    /// The unit that it was declared in; empty for a pure number.
    pub unit: String,
    /// A value in SI is one in this unit times the factor.
    pub factor: f64,
    /// Exponents of its base units: m, kg, s, K, A, mol, rad.
    pub exponents: [i8; 7],
    /// Its value as declared, SI, where parameters without default do not decide it.
    pub default: Option<f64>,
}

/// All quantities of a mechanism that have names.
#[derive(Clone, Debug)]
pub struct Quantities {
    /// The parameters.
    pub parameters: Vec<Quantity>,
    /// The inputs.
    pub inputs: Vec<Quantity>,
    /// The first-order states.
    pub states: Vec<Quantity>,
    /// The declared outputs, a vector as two.
    pub outputs: Vec<Quantity>,
}

impl Quantity {
    fn new(name: &str, docs: &[String], unit: &DisplayUnit, default: Option<f64>) -> Quantity {
        Quantity {
            name: name.to_owned(),
            docs: trimmed(docs),
            unit: unit.text.clone(),
            factor: unit.factor.to_f64(),
            exponents: exponents(unit),
            default,
        }
    }
}

impl Quantities {
    /// The quantities of a model.
    pub(crate) fn of(model: &Model) -> Quantities {
        let known = declared_values(model);
        let declared = |expr: Expr| Some(value(expr, &known)).filter(|value| !value.is_nan());
        let of = |name: &Name, docs: &[String], unit, default| Quantity::new(&name.text, docs, unit, default);
        let parameters = model.params.iter().map(|param| {
            let default = known.iter().find(|(symbol, _)| *symbol == param.symbol);
            of(&param.name, &param.docs, &param.unit, default.map(|(_, value)| *value))
        });
        let inputs = model.inputs.iter();
        let inputs = inputs.map(|input| of(&input.name, &input.docs, &input.unit, declared(input.default)));
        let states = model.states.iter();
        let states = states.map(|state| of(&state.name, &[], &state.unit, declared(state.start)));
        Quantities {
            parameters: parameters.collect_vec(),
            inputs: inputs.collect_vec(),
            states: states.collect_vec(),
            outputs: outputs(model),
        }
    }
}

fn outputs(model: &Model) -> Vec<Quantity> {
    let mut all = Vec::new();
    for output in model.outputs.iter().filter(|output| output.declared) {
        all.push_all(axes(output.components.len()).iter().map(|axis| {
            let name = format!("{}{axis}", output.name.text);
            Quantity::new(&name, std::slice::from_ref(&output.docs), &output.unit, None)
        }));
    }
    all
}

/// The axes of a quantity with so many components.
pub(crate) fn axes(components: usize) -> &'static [&'static str] {
    if components == 1 { &[""] } else { &[".x", ".y"] }
}

/// Documentation of the user, line by line.
pub(crate) fn trimmed(own: &[String]) -> String {
    own.iter().map(|line| line.trim()).collect_vec().join("\n")
}
