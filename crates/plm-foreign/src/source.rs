//! Names of a mechanism in other languages, and the source of its functions.

use core::fmt;

use plm_runtime::described::Quantity;

use crate::{By, Foreign, Number};

/// `DoublePendulum` in the writings of C: `double_pendulum`, and `DOUBLE_PENDULUM`. What is no letter or digit of ASCII
/// becomes `_`.
#[derive(Clone, Copy, Debug)]
pub struct Names<'a> {
    name: &'a str,
    upper: bool,
}

impl<'a> Names<'a> {
    /// `double_pendulum`
    pub fn lower(name: &'a str) -> Self {
        Self { name, upper: false }
    }

    /// `DOUBLE_PENDULUM`; of `arm.angle`, `ARM_ANGLE`.
    pub fn upper(name: &'a str) -> Self {
        Self { name, upper: true }
    }
}

impl Names<'_> {
    /// The letters, in capitals: `_` before each part of the name but the first, none at the end of `bar[0]`.
    fn letters(&self) -> impl Iterator<Item = char> {
        let mut before = '_';
        let words = self.name.trim_matches(|letter: char| !letter.is_ascii_alphanumeric());
        words.chars().flat_map(move |letter| {
            let plain = if letter.is_ascii_alphanumeric() { letter } else { '_' };
            let begins = plain.is_ascii_uppercase() && !before.is_ascii_uppercase() && before != '_';
            let twice = plain == '_' && before == '_';
            before = plain;
            [begins.then_some('_'), (!twice).then(|| plain.to_ascii_uppercase())].into_iter().flatten()
        })
    }

    /// Does another name become the same in C?
    pub(crate) fn is_as(&self, other: &str) -> bool {
        self.letters().eq(Names { name: other, ..*self }.letters())
    }
}

impl fmt::Display for Names<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use fmt::Write;
        let mut letters = self.letters();
        letters.try_for_each(|letter| {
            f.write_char(if self.upper { letter } else { letter.to_ascii_lowercase() })
        })
    }
}

/// The SI unit of a quantity: as it was declared where that is one, else in base units, `kg*m^2/s^2`.
#[derive(Clone, Copy, Debug)]
pub struct Si<'a>(pub &'a Quantity);

impl fmt::Display for Si<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Quantity { unit, factor, exponents, .. } = self.0;
        if *factor == 1.0 {
            return f.write_str(unit);
        }
        let base = ["m", "kg", "s", "K", "A", "mol", "rad"];
        let above = base.into_iter().zip(*exponents).filter(|(_, exponent)| *exponent > 0);
        let below = base.into_iter().zip(*exponents).filter(|(_, exponent)| *exponent < 0);
        if above.clone().count() == 0 && below.clone().count() > 0 {
            f.write_str("1")?;
        }
        for (k, (unit, exponent)) in above.enumerate() {
            write!(f, "{}{unit}", if k > 0 { "*" } else { "" })?;
            power(f, exponent)?;
        }
        for (unit, exponent) in below {
            write!(f, "/{unit}")?;
            power(f, -exponent)?;
        }
        Ok(())
    }
}

fn power(f: &mut fmt::Formatter<'_>, exponent: i8) -> fmt::Result {
    if exponent == 1 { Ok(()) } else { write!(f, "^{exponent}") }
}

/// The functions of C.
const C: &str = include_str!("c.rs.txt");
/// One of a step by itself.
const STEP: &str = include_str!("c_step.rs.txt");

/// A mechanism in a library: its name, and the methods by which it runs.
#[derive(Clone, Copy, Debug)]
pub struct Entry<'a> {
    /// Prefix of its functions: `press`.
    pub name: &'a str,
    /// The methods, the usual one first.
    pub methods: &'a [By],
}

impl Entry<'_> {
    /// Bytes of an object, which are enough, and what its address is a multiple of.
    pub(crate) fn room<M: Foreign>(&self) -> (usize, usize) {
        let sizes = self.methods.iter().map(|by| by.room::<M>());
        let (size, align) = sizes.fold((0, 1), |all, (size, align)| (size.max(all.0), align.max(all.1)));
        // With several methods, the tag of the present one takes an aligned unit for each at most.
        let told = if self.methods.len() > 1 { self.methods.len() * align } else { 0 };
        (size + told, align)
    }
}

/// Source of a library: the mechanism of a declaration, and its functions of C.
///
/// # Errors
/// Those of the writer.
pub fn source<M: Foreign>(entry: Entry<'_>, to: &mut impl fmt::Write) -> fmt::Result {
    write!(to, "plm::mechanism! {{\n{}\n}}\n", M::DECLARATION)?;
    let (name, real, runs) =
        (M::TABLES.name, M::S::RUST, Runs { entry, own: M::TABLES.name, real: M::S::RUST });
    let words: [Word<'_>; 4] = [("PREFIX", &entry.name), ("NAME", &name), ("REAL", &real), ("RUNS", &runs)];
    replace(C, &words, to)?;
    for step in M::STEPS {
        replace(STEP, &[("PREFIX", &entry.name), ("REAL", &real), ("STEP", step)], to)?;
    }
    Ok(())
}

/// The type of runs by several methods.
struct Runs<'a> {
    entry: Entry<'a>,
    own: &'a str,
    real: &'a str,
}

impl fmt::Display for Runs<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { entry: Entry { methods, .. }, own, real } = self;
        for (k, by) in methods.iter().enumerate() {
            let is_last = k + 1 == methods.len();
            f.write_str(if is_last { "" } else { "plm::foreign::Either<" })?;
            write!(f, "plm::runtime::Sim<{own}<{real}>, plm::runtime::method::")?;
            let own = format_args!("{own}<{real}>");
            replace(by.called().kind, &[("OWN", &own), ("REAL", real)], f)?;
            f.write_str(if is_last { ">" } else { ">, " })?;
        }
        (1..methods.len()).try_for_each(|_| f.write_str(">"))
    }
}

/// A placeholder in a text, and its replacement.
pub(crate) type Word<'a> = (&'static str, &'a dyn fmt::Display);

/// Writes a text with the names of a mechanism for `NAME`, `PREFIX`.
#[cfg(feature = "fmi")]
pub(crate) fn fill(text: &str, name: &str, to: &mut impl fmt::Write) -> fmt::Result {
    replace(text, &[("PREFIX", &Names::lower(name)), ("NAME", &name)], to)
}

/// Writes a text with placeholders replaced.
pub(crate) fn replace(mut text: &str, words: &[Word<'_>], to: &mut impl fmt::Write) -> fmt::Result {
    loop {
        let places = words.iter().filter_map(|(word, other)| Some((text.find(word)?, word.len(), other)));
        let Some((place, length, other)) = places.min_by_key(|(place, ..)| *place) else {
            return to.write_str(text);
        };
        let (before, rest) = text.split_at(place);
        write!(to, "{before}{other}")?;
        text = rest.get(length..).unwrap_or_default();
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use std::string::ToString;

    use super::{Names, Si};
    use plm_runtime::described::Quantity;

    #[test]
    fn names_become_words_of_c() {
        for (name, c) in [
            ("DoublePendulum", "double_pendulum"),
            ("arm.angle", "arm_angle"),
            ("bar[10].b.position.x", "bar_10_b_position_x"),
            ("PID", "pid"),
            ("bar[0]", "bar_0"),
        ] {
            assert_eq!(Names::lower(name).to_string(), c);
            assert_eq!(Names::upper(name).to_string(), c.to_uppercase());
        }
        assert!(Names::upper("a.b").is_as("a_b") && !Names::upper("a.b").is_as("ab"));
    }

    #[test]
    fn units_become_those_of_si() {
        let row =
            |unit, factor, exponents| Quantity { name: "", docs: "", unit, factor, exponents, default: None };
        for (row, unit) in [
            (row("N*m", 1.0, [2, 1, -2, 0, 0, 0, 0]), "N*m"),
            (row("bar", 1e5, [-1, 1, -2, 0, 0, 0, 0]), "kg/m/s^2"),
            (row("1/min", 1.0 / 60.0, [0, 0, -1, 0, 0, 0, 0]), "1/s"),
            (row("deg", 0.1, [0, 0, 0, 0, 0, 0, 1]), "rad"),
        ] {
            assert_eq!(Si(&row).to_string(), unit);
        }
    }
}
