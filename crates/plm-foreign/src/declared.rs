//! A mechanism as its declaration has it.

use plm_runtime::Scalar;

use crate::Foreign;

/// A mechanism with its parameters, and the starts that are made of them, as declared; a parameter without default is no number.
pub fn declared<M: Foreign>(mechanism: &M) -> M {
    let mut own = *mechanism;
    for (index, parameter) in M::TABLES.parameters.iter().enumerate() {
        own.set_parameter(index, Scalar::lit(parameter.default.unwrap_or(f64::NAN)));
    }
    *own.starts_mut() = own.declared_starts();
    own
}
