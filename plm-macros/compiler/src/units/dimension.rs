//! Dimensions: exponents of the base quantities.

use core::fmt::Write;

/// Exponents of the base units, and of the radian as a kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Dimension {
    /// Metre.
    pub m: i8,
    /// Kilogram.
    pub kg: i8,
    /// Second.
    pub s: i8,
    /// Ampere.
    pub a: i8,
    /// Kelvin.
    pub k: i8,
    /// Radian; compared only where an angle is meant.
    pub rad: i8,
}

/// Shorthand for the tables.
const fn of(m: i8, kg: i8, s: i8, rad: i8) -> Dimension {
    Dimension { m, kg, s, a: 0, k: 0, rad }
}

impl Dimension {
    /// A bare number.
    pub const NUMBER: Dimension = of(0, 0, 0, 0);
    /// m
    pub const LENGTH: Dimension = of(1, 0, 0, 0);
    /// kg
    pub const MASS: Dimension = of(0, 1, 0, 0);
    /// s
    pub const TIME: Dimension = of(0, 0, 1, 0);
    /// rad
    pub const ANGLE: Dimension = of(0, 0, 0, 1);
    /// m/s
    pub const VELOCITY: Dimension = of(1, 0, -1, 0);
    /// rad/s
    pub const ANGULAR_VELOCITY: Dimension = of(0, 0, -1, 1);
    /// m/s^2
    pub const ACCELERATION: Dimension = of(1, 0, -2, 0);
    /// rad/s^2
    pub const ANGULAR_ACCELERATION: Dimension = of(0, 0, -2, 1);
    /// N
    pub const FORCE: Dimension = of(1, 1, -2, 0);
    /// N*m
    pub const TORQUE: Dimension = of(2, 1, -2, 0);
    /// kg*m^2
    pub const INERTIA: Dimension = of(2, 1, 0, 0);
    /// kg/m^3
    pub const DENSITY: Dimension = of(-3, 1, 0, 0);

    /// Of a product.
    #[must_use]
    pub fn times(self, other: Dimension) -> Dimension {
        self.combine(other, 1)
    }

    /// Of a quotient.
    #[must_use]
    pub fn over(self, other: Dimension) -> Dimension {
        self.combine(other, -1)
    }

    /// Of a power with a whole exponent; exponents saturate far outside of anything physical.
    #[must_use]
    pub fn power(self, exponent: i32) -> Dimension {
        let exponent = exponent.clamp(-100, 100) as i8;
        Dimension::NUMBER.combine(self, exponent)
    }

    /// Of a square root; `None` if an exponent is odd. An odd power of the radian cancels.
    pub fn root(self) -> Option<Dimension> {
        let Dimension { m, kg, s, a, k, rad } = self;
        if [m, kg, s, a, k].iter().any(|exponent| exponent % 2 != 0) {
            return None;
        }
        let rad = if rad % 2 == 0 { rad / 2 } else { 0 };
        Some(Dimension { m: m / 2, kg: kg / 2, s: s / 2, a: a / 2, k: k / 2, rad })
    }

    fn combine(self, other: Dimension, times: i8) -> Dimension {
        let add = |x: i8, y: i8| x.saturating_add(y.saturating_mul(times));
        Dimension {
            m: add(self.m, other.m),
            kg: add(self.kg, other.kg),
            s: add(self.s, other.s),
            a: add(self.a, other.a),
            k: add(self.k, other.k),
            rad: add(self.rad, other.rad),
        }
    }

    /// True if both are equal, apart from the radian.
    pub fn same(self, other: Dimension) -> bool {
        self.plain() == other.plain()
    }

    /// Without the radian.
    #[must_use]
    pub fn plain(self) -> Dimension {
        Dimension { rad: 0, ..self }
    }

    /// Is it an angle, or a rate of one: a plane angle alone with time?
    pub fn is_angular(self) -> bool {
        self.rad == 1 && Dimension { s: 0, ..self.plain() } == Dimension::NUMBER
    }

    /// Its unit in SI: `N*m`, `kg*m^2`, `1` for a number.
    pub fn si_unit(self) -> String {
        let find = |dimension| KNOWN.iter().find(|known| known.dimension == dimension);
        // A torque times an angular velocity is a power: the radian of what has a mass or a current cancels.
        let is_mechanical = self.kg != 0 || self.a != 0;
        match find(self).or_else(|| find(self.plain()).filter(|_| is_mechanical)) {
            Some(known) => known.unit.to_string(),
            None => self.base_units(),
        }
    }

    /// With its article and its unit: `a length (m)`, `an angle (rad)`, `a number`.
    pub fn describe(self) -> String {
        match self.known() {
            Some(known) if known.unit != "1" => format!("{} ({})", known.name, known.unit),
            _ => self.name(),
        }
    }

    /// Its name without the unit: `a length`, `an angle`; `a quantity in kg^2` if it has none.
    pub fn name(self) -> String {
        match self.known() {
            Some(known) => known.name.to_string(),
            None => format!("a quantity in {}", self.base_units()),
        }
    }

    /// The entry of the table; the radian counts only if that gives one.
    fn known(self) -> Option<&'static Known> {
        let find = |dimension| KNOWN.iter().find(|known| known.dimension == dimension);
        find(self).or_else(|| find(self.plain()))
    }

    fn base_units(self) -> String {
        let bases = [
            ("kg", self.kg),
            ("m", self.m),
            ("ampere", self.a),
            ("K", self.k),
            ("rad", self.rad),
            ("s", self.s),
        ];
        let mut text = String::new();
        let mut below = String::new();
        for (unit, exponent) in bases {
            let (target, mark) = if exponent > 0 { (&mut text, '*') } else { (&mut below, '/') };
            if exponent != 0 && (mark == '/' || !target.is_empty()) {
                target.push(mark);
            }
            let _ = match exponent.unsigned_abs() {
                0 => Ok(()),
                1 => write!(target, "{unit}"),
                power => write!(target, "{unit}^{power}"),
            };
        }
        let above = if text.is_empty() { "1".to_string() } else { text };
        above + &below
    }
}

struct Known {
    dimension: Dimension,
    name: &'static str,
    unit: &'static str,
}

const fn known(dimension: Dimension, name: &'static str, unit: &'static str) -> Known {
    Known { dimension, name, unit }
}

/// Dimensions with a name; the first entry of a dimension is the one that is shown.
const KNOWN: &[Known] = &[
    known(Dimension::NUMBER, "a number", "1"),
    known(Dimension::LENGTH, "a length", "m"),
    known(of(2, 0, 0, 0), "an area", "m^2"),
    known(of(3, 0, 0, 0), "a volume", "m^3"),
    known(Dimension::MASS, "a mass", "kg"),
    known(Dimension::INERTIA, "a moment of inertia", "kg*m^2"),
    known(of(-3, 1, 0, 0), "a density", "kg/m^3"),
    known(Dimension::TIME, "a time", "s"),
    known(of(0, 0, -1, 0), "a frequency", "1/s"),
    known(Dimension::ANGLE, "an angle", "rad"),
    known(Dimension::ANGULAR_VELOCITY, "an angular velocity", "rad/s"),
    known(Dimension::ANGULAR_ACCELERATION, "an angular acceleration", "rad/s^2"),
    known(Dimension::VELOCITY, "a velocity", "m/s"),
    known(Dimension::ACCELERATION, "an acceleration", "m/s^2"),
    known(Dimension::FORCE, "a force", "N"),
    known(Dimension::TORQUE, "a torque or an energy", "N*m"),
    known(of(2, 1, -3, 0), "a power", "W"),
    known(of(1, 1, -1, 0), "a momentum", "N*s"),
    known(of(0, 1, -2, 0), "a stiffness", "N/m"),
    known(of(0, -1, 2, 0), "a compliance", "m/N"),
    known(of(0, 1, -1, 0), "a damping coefficient", "N/(m/s)"),
    known(of(2, 1, -2, -1), "a rotary stiffness", "N*m/rad"),
    known(of(-2, -1, 2, 1), "a rotary compliance", "rad/(N*m)"),
    known(of(2, 1, -1, -1), "a rotary damping coefficient", "N*m/(rad/s)"),
    known(of(2, 1, -1, 0), "an angular momentum", "N*m*s"),
    known(of(-1, 1, -2, 0), "a pressure", "Pa"),
    known(of(-1, 1, -1, 0), "a viscosity", "Pa*s"),
    known(of(-1, 1, -3, 0), "a pressure rate", "Pa/s"),
    known(of(3, 0, -1, 0), "a volume flow", "m^3/s"),
    known(Dimension { k: 1, ..Dimension::NUMBER }, "a temperature", "K"),
];

#[cfg(test)]
mod tests {
    use super::Dimension;

    #[test]
    fn dimensions_say_what_they_are() {
        assert_eq!(Dimension::LENGTH.describe(), "a length (m)");
        assert_eq!(Dimension::NUMBER.describe(), "a number");
        assert_eq!(Dimension::ANGLE.describe(), "an angle (rad)");
        assert_eq!(Dimension::FORCE.power(2).describe(), "a quantity in kg^2*m^2/s^4");
        assert_eq!(Dimension::LENGTH.power(-2).si_unit(), "1/m^2");
        assert_eq!(Dimension::LENGTH.times(Dimension::ANGLE).describe(), "a length (m)");
    }

    #[test]
    fn the_radian_cancels_but_is_seen() {
        let stiffness = Dimension::TORQUE.over(Dimension::ANGLE);
        assert!(stiffness.same(Dimension::TORQUE));
        assert!(Dimension::ANGULAR_VELOCITY.is_angular());
        assert!(!stiffness.is_angular());
        assert_eq!(Dimension::LENGTH.power(2).root(), Some(Dimension::LENGTH));
        assert_eq!(Dimension::LENGTH.root(), None);
    }
}
