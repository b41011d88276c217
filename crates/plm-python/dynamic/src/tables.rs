//! Tables of a mechanism from text, as values of Python.

use plm_dynamic::Mechanism;
use plm_foreign::Si;
use plm_runtime::described::Quantity;

/// Name, SI unit, declared unit, its factor, documentation, and the declared value.
pub(crate) type Row = (String, String, String, f64, String, Option<f64>);

/// Parameters, inputs, states, outputs, start values; bodies; declared outputs; rows of contact.
pub(crate) type Tables =
    (Vec<Row>, Vec<Row>, Vec<Row>, Vec<Row>, Vec<Row>, Vec<String>, Vec<Row>, Vec<String>);

pub(crate) fn tables(of: &Mechanism) -> Tables {
    let own = of.tables();
    let rows = |list: &[Quantity]| list.iter().map(row).collect::<Vec<Row>>();
    let observed = of.observables().iter().map(|(name, unit)| output(own.outputs, name, unit));
    let starts = of.starts().iter().zip(of.declared_starts()).enumerate();
    (
        rows(own.parameters),
        rows(own.inputs),
        rows(own.states),
        observed.collect(),
        starts.map(|(index, (name, value))| start(of, index, name, value)).collect(),
        own.bodies.iter().map(|body| body.name.to_owned()).collect(),
        rows(own.outputs),
        of.contacts().iter().map(|name| (*name).to_owned()).collect(),
    )
}

fn row(of: &Quantity) -> Row {
    let texts = [of.name, of.unit, of.docs.trim()].map(str::to_owned);
    let [name, unit, docs] = texts;
    (name, Si(of).to_string(), unit, of.factor, docs, of.default)
}

/// A quantity that is observed; what was declared of it, if it was.
fn output(declared: &[Quantity], name: &str, unit: &str) -> Row {
    match declared.iter().find(|row| row.name == name) {
        Some(of) => {
            let (name, _, declared, factor, docs, _) = row(of);
            (name, unit.to_owned(), declared, factor, docs, None)
        }
        None => (name.to_owned(), unit.to_owned(), unit.to_owned(), 1.0, String::new(), None),
    }
}

/// A start value: six of each body, then those of the first-order states.
fn start(of: &Mechanism, index: usize, name: &str, value: f64) -> Row {
    let units = ["m", "m", "rad", "m/s", "m/s", "rad/s"];
    let state = index.checked_sub(units.len() * of.tables().bodies.len());
    let state = state.and_then(|k| of.tables().states.get(k)).map(row);
    let own = units[index % units.len()].to_owned();
    let (_, unit, declared, factor, docs, _) =
        state.unwrap_or((String::new(), own.clone(), own, 1.0, String::new(), None));
    (name.to_owned(), unit, declared, factor, docs, Some(value).filter(|value| value.is_finite()))
}
