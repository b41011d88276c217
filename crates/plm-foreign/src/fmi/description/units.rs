//! Units: what variables have, and what all of them come from.

use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::{String, ToString};
use core::fmt::{self, Write};

use plm_runtime::described::Quantity;

use super::Xml;
use crate::Si;

/// Exponents of m, kg, s, K, A, mol, rad, as [`Quantity`] has them.
type Exponents = [i8; 7];

/// SI units with a name of their own.
const NAMED: [(&str, Exponents); 20] = [
    ("m", [1, 0, 0, 0, 0, 0, 0]),
    ("kg", [0, 1, 0, 0, 0, 0, 0]),
    ("s", [0, 0, 1, 0, 0, 0, 0]),
    ("K", [0, 0, 0, 1, 0, 0, 0]),
    ("A", [0, 0, 0, 0, 1, 0, 0]),
    ("mol", [0, 0, 0, 0, 0, 1, 0]),
    ("rad", [0, 0, 0, 0, 0, 0, 1]),
    ("N", [1, 1, -2, 0, 0, 0, 0]),
    ("Pa", [-1, 1, -2, 0, 0, 0, 0]),
    ("J", [2, 1, -2, 0, 0, 0, 0]),
    ("W", [2, 1, -3, 0, 0, 0, 0]),
    ("Hz", [0, 0, -1, 0, 0, 0, 0]),
    ("C", [0, 0, 1, 0, 1, 0, 0]),
    ("V", [2, 1, -3, 0, -1, 0, 0]),
    ("ohm", [2, 1, -3, 0, -2, 0, 0]),
    ("F", [-2, -1, 4, 0, 2, 0, 0]),
    ("H", [2, 1, -2, 0, -2, 0, 0]),
    ("Wb", [2, 1, -2, 0, -1, 0, 0]),
    ("T", [0, 1, -2, 0, -1, 0, 0]),
    ("1", [0; 7]),
];

/// Units by name: their exponents, and the units for display with their factors.
#[derive(Default)]
pub(super) struct Units(BTreeMap<String, (Exponents, BTreeMap<String, f64>)>);

/// The unit of a variable and the one for display; none is empty.
#[derive(Default)]
pub(super) struct Unit {
    pub(super) si: String,
    pub(super) display: String,
}

impl Units {
    /// Those of a quantity.
    pub(super) fn of(&mut self, row: &Quantity) -> Unit {
        let si = Si(row).to_string();
        if row.unit.is_empty() || si.is_empty() {
            return Unit::default();
        }
        let (_, display) = self.0.entry(si.clone()).or_insert((row.exponents, BTreeMap::new()));
        if row.unit == si {
            return Unit { si, display: String::new() };
        }
        display.insert(row.unit.to_string(), 1.0 / row.factor);
        Unit { si, display: row.unit.to_string() }
    }

    /// One of SI by its name; none where it is not known.
    pub(super) fn named(&mut self, unit: &str) -> Unit {
        let Some(exponents) = exponents(unit) else { return Unit::default() };
        self.0.entry(unit.to_string()).or_insert((exponents, BTreeMap::new()));
        Unit { si: unit.to_string(), display: String::new() }
    }

    /// That of the rate of what has a unit.
    pub(super) fn rate_of(&mut self, unit: &str) -> Unit {
        match unit.strip_suffix("/s") {
            Some(unit) => self.named(&format!("{unit}/s^2")),
            None => self.named(&format!("{unit}/s")),
        }
    }

    /// Is there none?
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Writes all of them; both versions use equal text.
    pub(super) fn write(&self, to: &mut impl Write) -> fmt::Result {
        self.0.iter().try_for_each(|(name, unit)| line(name, unit, to))
    }
}

/// The exponents of a product of SI units, `kg*m^2/s`.
fn exponents(unit: &str) -> Option<Exponents> {
    let (mut sum, mut sign, mut rest) = ([0; 7], 1, unit);
    while !rest.is_empty() {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let (factor, after) = rest.split_at(end);
        let (name, power) =
            factor.split_once('^').map_or((factor, Ok(1)), |(name, power)| (name, power.parse::<i8>()));
        let (_, own) = NAMED.iter().find(|(own, _)| *own == name)?;
        let power = sign * power.ok()?;
        sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += power * own);
        sign = if after.starts_with('/') { -1 } else { 1 };
        rest = after.get(1..).unwrap_or_default();
    }
    (!unit.is_empty()).then_some(sum)
}

fn line(
    name: &str,
    (exponents, display): &(Exponents, BTreeMap<String, f64>),
    to: &mut impl Write,
) -> fmt::Result {
    write!(to, "    <Unit name=\"{}\">\n      <BaseUnit", Xml(name))?;
    for (base, exponent) in ["m", "kg", "s", "K", "A", "mol", "rad"].iter().zip(exponents) {
        if *exponent != 0 {
            write!(to, " {base}=\"{exponent}\"")?;
        }
    }
    writeln!(to, "/>")?;
    for (name, factor) in display {
        writeln!(to, "      <DisplayUnit name=\"{}\" factor=\"{factor:?}\"/>", Xml(name))?;
    }
    writeln!(to, "    </Unit>")
}
