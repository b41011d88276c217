//! Numbers that can be read of a run.

use plm_compiler::lowered::Output;

/// A number that can be read of a run: an output, of a vector one of two.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its name: `hinge.force.x`.
    pub name: String,
    /// Its unit: of a declared output the one that it has in the declaration, else that of SI; empty for a pure number.
    pub unit: String,
    /// Is it declared as an output? Else it is a quantity that can be observed.
    pub declared: bool,
    /// Its value in SI over that in the unit.
    pub(crate) factor: f64,
}

impl Column {
    pub(crate) fn of(output: &Output) -> Column {
        let Output { name, declared, .. } = output;
        let (unit, factor) = if *declared { (&output.unit, output.factor) } else { (&output.si, 1.0) };
        Column { name: name.clone(), unit: unit.clone(), declared: *declared, factor }
    }
}
