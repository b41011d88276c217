//! C99.

use crate::block::{Argument, OfOne, OfTwo};
use crate::dialect::Dialect;

/// C99 in one precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct C {
    /// `float`; else `double`.
    pub(crate) single: bool,
}

impl Dialect for C {
    /// Hexadecimal, since C rounds only these exactly (C99, 6.4.4.2); integers of few digits are exact in any form.
    fn number(&self, number: f64) -> String {
        let number = if self.single { f64::from(number as f32) } else { number };
        if number.is_nan() {
            return "PLM_NAN".to_owned();
        }
        let size = match number.abs() {
            size if size.is_infinite() => "PLM_INFINITY".to_owned(),
            size if size < 1e6 && size.fract() == 0.0 => format!("PLM_C({size:?})"),
            size => format!("PLM_C({})", hexadecimal(size)),
        };
        if number.is_sign_negative() { format!("(-{size})") } else { size }
    }

    fn argument(&self, argument: Argument) -> String {
        match argument {
            Argument::Time => "t".to_owned(),
            Argument::Parameter(k) => format!("self->parameter[{k}]"),
            Argument::Input(k) => format!("self->input[{k}]"),
            Argument::Side(k) => format!("self->side[{k}]"),
            Argument::Turns(k) => format!("(plm_real)self->turns[{k}]"),
            Argument::Mode(k, of_gap) => {
                let [mode, carried] = if of_gap { ["PLM_OPEN", "&& !"] } else { ["PLM_STICKS", "|| "] };
                format!(
                    "(((self->mode[{k}] == {mode}) {carried}self->carried[{k}]) ? PLM_C(1.0) : PLM_C(0.0))"
                )
            }
            Argument::Remembered(k) => format!("self->memory[{k}]"),
            Argument::Element(array, k) => format!("{array}[{k}]"),
        }
    }

    fn declare(&self, name: &str, value: &str) -> String {
        format!("const plm_real {name} = {value};")
    }

    fn declare_pair(&self, name: &str, angle: &str) -> String {
        format!("const plm_pair {name} = plm_sin_cos({angle});")
    }

    fn of_pair(&self, name: &str) -> [String; 2] {
        [format!("{name}.sine"), format!("{name}.cosine")]
    }

    fn one(&self, of: OfOne, a: &str) -> String {
        let function = match of {
            OfOne::Neg => return format!("-{a}"),
            OfOne::Sqrt => "sqrt",
            OfOne::Asin => "asin",
            OfOne::Acos => "acos",
            OfOne::Exp => "exp",
            OfOne::Ln => "ln",
            OfOne::Abs => "abs",
            OfOne::Sign => "sign",
            OfOne::Floor => "floor",
        };
        format!("plm_{function}({a})")
    }

    fn two(&self, of: OfTwo, a: &str, b: &str) -> String {
        match of {
            OfTwo::Add => format!("{a} + {b}"),
            OfTwo::Sub => format!("{a} - {b}"),
            OfTwo::Mul => format!("{a} * {b}"),
            OfTwo::Div => format!("{a} / {b}"),
            OfTwo::Atan2 => format!("plm_atan2({a}, {b})"),
            OfTwo::Min => self.select([a, b, a, b]),
            OfTwo::Max => self.select([b, a, a, b]),
        }
    }

    fn select(&self, [a, b, c, d]: [&str; 4]) -> String {
        format!("({a} < {b}) ? {c} : {d}")
    }

    fn store(&self, place: &str, value: &str) -> String {
        format!("{place} = {value};")
    }

    fn give_back(&self, value: &str) -> String {
        format!("return {value};")
    }
}

/// A finite number that is not negative.
fn hexadecimal(number: f64) -> String {
    let bits = number.to_bits();
    let (exponent, digits) = ((bits >> 52) as i32, bits & ((1 << 52) - 1));
    let (lead, exponent) = if exponent == 0 { (0, -1022) } else { (1, exponent - 1023) };
    let digits = format!("{digits:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("0x{lead}{point}{digits}p{exponent:+}")
}

#[cfg(test)]
mod tests {
    use super::{C, Dialect};

    #[test]
    fn constants_are_exact() {
        let double = |number| C { single: false }.number(number);
        let single = |number| C { single: true }.number(number);
        assert_eq!(double(0.0), "PLM_C(0.0)");
        assert_eq!(double(-0.0), "(-PLM_C(0.0))");
        assert_eq!(double(-2.0), "(-PLM_C(2.0))");
        assert_eq!(double(0.1), "PLM_C(0x1.999999999999ap-4)");
        assert_eq!(single(0.1), "PLM_C(0x1.99999ap-4)");
        assert_eq!(double(f64::MIN_POSITIVE / 4.0), "PLM_C(0x0.4p-1022)");
        assert_eq!(double(f64::NEG_INFINITY), "(-PLM_INFINITY)");
        assert_eq!(double(f64::NAN), "PLM_NAN");
    }
}
