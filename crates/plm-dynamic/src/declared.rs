//! Parameters and inputs in their declared units.

use crate::run::Mechanism;

/// A parameter or an input as it is declared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Declared<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its SI unit.
    pub si: &'a str,
    /// Its unit in the declaration; empty for a pure number.
    pub unit: &'a str,
    /// A value in SI is one in the declared unit times the factor.
    pub factor: f64,
}

impl Mechanism {
    /// Name, SI unit and declared unit of each parameter; a value in SI is one in the declared unit times the factor.
    pub fn declared_parameters(&self) -> impl Iterator<Item = Declared<'_>> + Clone {
        let description = &self.lowered().description.quantities.parameters;
        self.parameters().zip(description).map(|((name, si), own)| Declared {
            name,
            si,
            unit: &own.unit,
            factor: own.factor,
        })
    }

    /// Name, SI unit and declared unit of each input; a value in SI is one in the declared unit times the factor.
    pub fn declared_inputs(&self) -> impl Iterator<Item = Declared<'_>> + Clone {
        let description = &self.lowered().description.quantities.inputs;
        self.inputs().zip(description).map(|((name, si), own)| Declared {
            name,
            si,
            unit: &own.unit,
            factor: own.factor,
        })
    }
}
