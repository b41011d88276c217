//! A unit as the user wrote it: text, factor, dimension.

use plm_cas::Number;

use super::dimension::Dimension;
use super::table::Unit;

/// A unit for display: `value in SI = value in this unit * factor`.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplayUnit {
    /// As it is printed, e.g. `N*m/(rev/min)`; empty for a bare number.
    pub text: String,
    /// Exact factor to SI.
    pub factor: Number,
    /// Its dimension.
    pub dimension: Dimension,
}

/// One factor of a unit: a named unit to a whole power.
#[derive(Clone, Copy, Debug)]
pub struct UnitFactor {
    /// The unit.
    pub unit: &'static Unit,
    /// Its exponent.
    pub exponent: i32,
}

impl DisplayUnit {
    /// The SI unit of a dimension.
    pub fn si(dimension: Dimension) -> DisplayUnit {
        let text = if dimension == Dimension::NUMBER { String::new() } else { dimension.si_unit() };
        DisplayUnit { text, factor: Number::ONE, dimension }
    }

    /// A product of factors, printed as `text`.
    pub fn product(text: String, factors: &[UnitFactor]) -> DisplayUnit {
        let mut product = DisplayUnit { text, factor: Number::ONE, dimension: Dimension::NUMBER };
        for UnitFactor { unit, exponent } in factors {
            product.dimension = product.dimension.times(unit.dimension.power(*exponent));
            for _ in 0..exponent.unsigned_abs() {
                let factor = unit.factor();
                let next =
                    if *exponent > 0 { Some(product.factor * factor) } else { product.factor.div(factor) };
                product.factor = next.unwrap_or(product.factor);
            }
        }
        product
    }
}
