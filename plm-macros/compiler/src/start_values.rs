//! Values at the start, with parameters as declared: what an editor shows beside a name.

use crate::collect::{CollectVec, PushAll};
use plm_cas::Expr;

use crate::model::Model;
use crate::numeric::{Scene, at_start, values};
use crate::oracle::Oracle;
use crate::units::DisplayUnit;

/// A parameter, an input, a state or an output at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct StartValue {
    /// Its full name.
    pub name: String,
    /// One number or two, in its unit; not finite where the start does not determine it.
    pub values: Vec<f64>,
    /// The unit, as declared; empty for a bare number.
    pub unit: String,
    /// Its documentation.
    pub docs: String,
}

impl Oracle {
    /// Parameters, inputs, states and outputs at the assembled start. Reactions and accelerations are those of the equations in
    /// absolute coordinates; with contact they have no values.
    pub fn start_values(&self) -> Vec<StartValue> {
        self.graph.borrow_mut().enter(|| {
            let model = &self.model;
            let scene = Scene::declared(model, &self.equations, &self.program.absolute);
            let (_, mut known) = at_start(&scene);
            let solved = self.solved(&known);
            known.retain(|(symbol, _)| !self.equations.a.contains(symbol) && !is_multiplier(model, *symbol));
            known.push_all(solved);
            let rows = rows(model);
            let all = rows.iter().flat_map(|(_, exprs, ..)| exprs).copied().collect_vec();
            let mut numbers = values(&all, &known).into_iter();
            let row = |(name, exprs, unit, docs): Row| {
                let factor = unit.factor.to_f64();
                let values = exprs.iter().filter_map(|_| numbers.next()).map(|value| value / factor);
                StartValue { name, values: values.collect_vec(), unit: unit.text, docs }
            };
            rows.into_iter().map(row).collect_vec()
        })
    }

    /// Accelerations and multipliers at the start, where no contact has a part in them.
    fn solved(&self, known: &[(Expr, f64)]) -> Vec<(Expr, f64)> {
        if !self.model.contacts.is_empty() {
            return Vec::new();
        }
        let (equations, coordinates) = (&self.equations, self.equations.q.len());
        let results = self.program.absolute.dynamics.results.iter().map(|&(_, result)| result).collect_vec();
        let results = values(&results, known);
        let accelerations = equations.a.iter().copied().zip(results.iter().skip(coordinates).copied());
        let after = 2 * coordinates + equations.x.len();
        let multipliers = equations.lambda.iter().copied().zip(results.iter().skip(after).copied());
        accelerations.chain(multipliers).collect_vec()
    }
}

fn is_multiplier(model: &Model, symbol: Expr) -> bool {
    let of_rows = model.rows.iter().map(|row| row.lambda);
    of_rows.chain(model.contacts.iter().map(|contact| contact.lambda)).any(|lambda| lambda == symbol)
}

/// Name, expressions in SI, unit, documentation.
type Row = (String, Vec<Expr>, DisplayUnit, String);

fn rows(model: &Model) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for of in &model.params {
        rows.push((of.name.text.clone(), vec![of.symbol], of.unit.clone(), of.docs.join("\n")));
    }
    for of in &model.inputs {
        rows.push((of.name.text.clone(), vec![of.symbol], of.unit.clone(), of.docs.join("\n")));
    }
    for of in &model.states {
        rows.push((of.name.text.clone(), vec![of.symbol], of.unit.clone(), String::new()));
    }
    for of in &model.outputs {
        rows.push((of.name.text.clone(), of.components.clone(), of.unit.clone(), of.docs.clone()));
    }
    rows
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use crate::compile;
    use crate::token::Sources;

    #[test]
    fn a_bar_at_rest_hangs_in_its_pin() {
        let mut sources = Sources::new();
        let text = "pub Bar { gravity: 9.81 m/s^2; param length: cm = 80 cm; ground { port o: (0, 0) m; }
            body bar { mass: 2 kg; inertia: 1 kg*m^2; port top: (0, length/2); start angle: 0 deg, locked; }
            revolute pin(ground.o, bar.top);
            output bar.angle in deg, pin.force, height = bar.y in mm, falls = bar.ay; }";
        sources.add_text("declaration", text);
        let values = compile(&mut sources).oracle.unwrap().start_values();
        let shown = |name: &str| {
            let of = values.iter().find(|value| value.name == name).unwrap();
            (of.values.clone(), of.unit.as_str())
        };
        let is_near = |found: (Vec<f64>, &str), expected: &[f64], unit: &str| {
            let is_near = found.0.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-9);
            assert!(is_near && found.1 == unit, "{found:?}");
        };
        is_near(shown("length"), &[80.0], "cm");
        is_near(shown("height"), &[-400.0], "mm");
        // The joint pulls the ground down by the weight; the bar is in equilibrium.
        is_near(shown("pin.force"), &[0.0, -19.62], "N");
        is_near(shown("falls"), &[0.0], "m/s^2");
    }
}
