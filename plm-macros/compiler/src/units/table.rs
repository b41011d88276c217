//! The closed table of units. Their names are reserved as bare names, so the table holds what the manual prints and
//! little more; V, A, T, P, t, g and `in` stay free for the user. What has such a letter is written out: `volt`, `gram`, `tonne`.

use plm_cas::Number;

use super::dimension::Dimension;

/// A named unit: `value in SI = value * numerator / denominator * pi^pi`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// As it is written.
    pub name: &'static str,
    /// As it is called.
    pub word: &'static str,
    numerator: i64,
    denominator: i64,
    pi: bool,
    /// Its dimension.
    pub dimension: Dimension,
}

impl Unit {
    /// Its factor to SI, exact.
    pub fn factor(&self) -> Number {
        let rational = Number::rational(i128::from(self.numerator), i128::from(self.denominator));
        let rational = rational.unwrap_or(Number::ONE);
        if self.pi { rational * Number::pi() } else { rational }
    }
}

const fn row(name: &'static str, word: &'static str, factor: (i64, i64), dimension: Dimension) -> Unit {
    Unit { name, word, numerator: factor.0, denominator: factor.1, pi: false, dimension }
}

const fn angle(name: &'static str, word: &'static str, factor: (i64, i64)) -> Unit {
    Unit { name, word, numerator: factor.0, denominator: factor.1, pi: true, dimension: Dimension::ANGLE }
}

const PRESSURE: Dimension = Dimension { m: -1, kg: 1, s: -2, a: 0, k: 0, rad: 0 };
const POWER: Dimension = Dimension { m: 2, kg: 1, s: -3, a: 0, k: 0, rad: 0 };
const FREQUENCY: Dimension = Dimension { m: 0, kg: 0, s: -1, a: 0, k: 0, rad: 0 };
const VISCOSITY: Dimension = Dimension { m: -1, kg: 1, s: -1, a: 0, k: 0, rad: 0 };
const VOLUME: Dimension = Dimension { m: 3, kg: 0, s: 0, a: 0, k: 0, rad: 0 };
const TEMPERATURE: Dimension = Dimension { m: 0, kg: 0, s: 0, a: 0, k: 1, rad: 0 };

// Written out, so that V and A stay free.
const CURRENT: Dimension = Dimension { m: 0, kg: 0, s: 0, a: 1, k: 0, rad: 0 };
const VOLTAGE: Dimension = Dimension { m: 2, kg: 1, s: -3, a: -1, k: 0, rad: 0 };
const RESISTANCE: Dimension = Dimension { m: 2, kg: 1, s: -3, a: -2, k: 0, rad: 0 };
const INDUCTANCE: Dimension = Dimension { m: 2, kg: 1, s: -2, a: -2, k: 0, rad: 0 };

const TABLE: &[Unit] = &[
    row("m", "the metre", (1, 1), Dimension::LENGTH),
    row("mm", "the millimetre", (1, 1000), Dimension::LENGTH),
    row("cm", "the centimetre", (1, 100), Dimension::LENGTH),
    row("km", "the kilometre", (1000, 1), Dimension::LENGTH),
    row("um", "the micrometre", (1, 1_000_000), Dimension::LENGTH),
    row("L", "the litre", (1, 1000), VOLUME),
    row("kg", "the kilogram", (1, 1), Dimension::MASS),
    row("gram", "the gram", (1, 1000), Dimension::MASS),
    row("tonne", "the tonne", (1000, 1), Dimension::MASS),
    row("s", "the second", (1, 1), Dimension::TIME),
    row("ms", "the millisecond", (1, 1000), Dimension::TIME),
    row("min", "the minute", (60, 1), Dimension::TIME),
    row("h", "the hour", (3600, 1), Dimension::TIME),
    row("Hz", "the hertz", (1, 1), FREQUENCY),
    row("rad", "the radian", (1, 1), Dimension::ANGLE),
    angle("deg", "the degree", (1, 180)),
    angle("degree", "the degree", (1, 180)),
    angle("rev", "the revolution", (2, 1)),
    row("N", "the newton", (1, 1), Dimension::FORCE),
    row("kN", "the kilonewton", (1000, 1), Dimension::FORCE),
    row("J", "the joule", (1, 1), Dimension::TORQUE),
    row("W", "the watt", (1, 1), POWER),
    row("kW", "the kilowatt", (1000, 1), POWER),
    row("Pa", "the pascal", (1, 1), PRESSURE),
    row("kPa", "the kilopascal", (1000, 1), PRESSURE),
    row("MPa", "the megapascal", (1_000_000, 1), PRESSURE),
    row("GPa", "the gigapascal", (1_000_000_000, 1), PRESSURE),
    row("bar", "the bar", (100_000, 1), PRESSURE),
    row("cP", "the centipoise", (1, 1000), VISCOSITY),
    row("K", "the kelvin", (1, 1), TEMPERATURE),
    row("ampere", "the ampere", (1, 1), CURRENT),
    row("volt", "the volt", (1, 1), VOLTAGE),
    row("ohm", "the ohm", (1, 1), RESISTANCE),
    row("henry", "the henry", (1, 1), INDUCTANCE),
];

/// Units whose names may be those of values too: the commonest name of a length is L. After a number it is the unit.
pub const MAY_BE_NAMES: [&str; 1] = ["L"];

/// The unit of a name.
pub fn unit(name: &str) -> Option<&'static Unit> {
    TABLE.iter().find(|unit| unit.name == name)
}

/// Is it the name of a unit?
pub fn is_unit(name: &str) -> bool {
    unit(name).is_some()
}

/// All names, for help.
pub fn names() -> impl Iterator<Item = &'static str> {
    TABLE.iter().map(|unit| unit.name)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use core::f64::consts::{PI, TAU};

    use super::{Dimension, TABLE, unit};

    /// Every unit in SI, and its dimension in metre, kilogram, second, ampere, kelvin and radian: BIPM, The International
    /// System of Units, 9th edition, tables 2, 4, 5 and 8. The bar and the centipoise are 1e5 Pa and 1e-3 Pa s there.
    const DEFINED: [(&str, f64, [i8; 6]); 34] = [
        ("m", 1.0, [1, 0, 0, 0, 0, 0]),
        ("mm", 1e-3, [1, 0, 0, 0, 0, 0]),
        ("cm", 1e-2, [1, 0, 0, 0, 0, 0]),
        ("km", 1e3, [1, 0, 0, 0, 0, 0]),
        ("um", 1e-6, [1, 0, 0, 0, 0, 0]),
        ("L", 1e-3, [3, 0, 0, 0, 0, 0]),
        ("kg", 1.0, [0, 1, 0, 0, 0, 0]),
        ("gram", 1e-3, [0, 1, 0, 0, 0, 0]),
        ("tonne", 1e3, [0, 1, 0, 0, 0, 0]),
        ("s", 1.0, [0, 0, 1, 0, 0, 0]),
        ("ms", 1e-3, [0, 0, 1, 0, 0, 0]),
        ("min", 60.0, [0, 0, 1, 0, 0, 0]),
        ("h", 3600.0, [0, 0, 1, 0, 0, 0]),
        ("Hz", 1.0, [0, 0, -1, 0, 0, 0]),
        ("rad", 1.0, [0, 0, 0, 0, 0, 1]),
        ("deg", PI / 180.0, [0, 0, 0, 0, 0, 1]),
        ("degree", PI / 180.0, [0, 0, 0, 0, 0, 1]),
        ("rev", TAU, [0, 0, 0, 0, 0, 1]),
        ("N", 1.0, [1, 1, -2, 0, 0, 0]),
        ("kN", 1e3, [1, 1, -2, 0, 0, 0]),
        ("J", 1.0, [2, 1, -2, 0, 0, 0]),
        ("W", 1.0, [2, 1, -3, 0, 0, 0]),
        ("kW", 1e3, [2, 1, -3, 0, 0, 0]),
        ("Pa", 1.0, [-1, 1, -2, 0, 0, 0]),
        ("kPa", 1e3, [-1, 1, -2, 0, 0, 0]),
        ("MPa", 1e6, [-1, 1, -2, 0, 0, 0]),
        ("GPa", 1e9, [-1, 1, -2, 0, 0, 0]),
        ("bar", 1e5, [-1, 1, -2, 0, 0, 0]),
        ("cP", 1e-3, [-1, 1, -1, 0, 0, 0]),
        ("K", 1.0, [0, 0, 0, 0, 1, 0]),
        ("ampere", 1.0, [0, 0, 0, 1, 0, 0]),
        ("volt", 1.0, [2, 1, -3, -1, 0, 0]),
        ("ohm", 1.0, [2, 1, -3, -2, 0, 0]),
        ("henry", 1.0, [2, 1, -2, -2, 0, 0]),
    ];

    #[test]
    fn every_unit_is_the_defined_one() {
        for (name, factor, [m, kg, s, a, k, rad]) in DEFINED {
            let found = unit(name).unwrap();
            assert_eq!(found.factor().to_f64(), factor, "{name}");
            assert_eq!(found.dimension, Dimension { m, kg, s, a, k, rad }, "{name}");
        }
        // None is without its line.
        for unit in TABLE {
            assert!(DEFINED.iter().any(|defined| defined.0 == unit.name), "{}", unit.name);
        }
    }
}
