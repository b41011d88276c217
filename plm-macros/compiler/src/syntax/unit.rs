//! Units in expressions and declarations.
//!
//! ```text
//! unit  := uatom { ("*" | "/") uatom }      greedy, binds tighter than * and / of expressions
//! uatom := UNIT ["^" ["-"] INT] | "(" unit ")"
//! ```
//! After `*` or `/` the unit goes on only if the next token is the name of a unit that is not followed by `(`, `.` or
//! `[`, or a group that is wholly a unit: `10 N/area`, `2 m*min(a, b)` and `1 N/bar[1].x` come out right.

use crate::collect::CollectVec;
use proc_macro2::Delimiter;
use syn::buffer::Cursor;
use syn::ext::IdentExt;
use syn::{Token, token};

use super::input::{Input, Reported, Result};
use super::name::Ident;
use crate::diag::{Code, nearest};
use crate::units::{self, DisplayUnit, UnitFactor, is_unit, names};

/// Words that may follow a number without being a unit.
const WORDS: &[&str] = &["then", "else", "and", "or", "in", "within", "for"];

/// Largest exponent of a unit.
const MAX_EXPONENT: i32 = 9;

/// The unit after a number or a pair, if there is one.
pub(super) fn unit_after_number(input: Input) -> Result<Option<DisplayUnit>> {
    let is_word = input.peek(syn::Ident::peek_any) && !WORDS.contains(&input.next());
    // `mass: 10 inertia: 1` lacks a semicolon, not a unit.
    let is_next_field = input.peek2(Token![:]);
    if (is_word && !is_next_field) || is_unit_group(input.cursor()) {
        unit(input).map(Some)
    } else {
        Ok(None)
    }
}

/// A unit where a value is declared: also `1` for a bare number, and `1/s`.
pub(super) fn declared_unit(input: Input) -> Result<DisplayUnit> {
    let mut unit = UnitText::default();
    if input.next() == "1" {
        input.advance();
        unit.further_factors(input, 1)?;
        unit.text = if unit.text.is_empty() { String::new() } else { format!("1{}", unit.text) };
    } else {
        unit.factors(input, 1)?;
    }
    if input.eat(Token![*]) || input.eat(Token![/]) {
        // No expression can go on here: it is a unit, and none that is known.
        unit.atom(input, 1)?;
    }
    Ok(DisplayUnit::product(unit.text, &unit.factors))
}

/// A unit.
pub(super) fn unit(input: Input) -> Result<DisplayUnit> {
    let mut unit = UnitText::default();
    unit.factors(input, 1)?;
    Ok(DisplayUnit::product(unit.text, &unit.factors))
}

/// Text of a unit as far as it was read.
#[derive(Default)]
struct UnitText {
    text: String,
    factors: Vec<UnitFactor>,
}

impl UnitText {
    fn factors(&mut self, input: Input, sign: i32) -> Result<()> {
        self.atom(input, sign)?;
        self.further_factors(input, sign)
    }

    fn further_factors(&mut self, input: Input, sign: i32) -> Result<()> {
        while goes_on(input) {
            let below = input.peek(Token![/]);
            input.advance();
            self.text.push(if below { '/' } else { '*' });
            self.atom(input, if below { -sign } else { sign })?;
        }
        Ok(())
    }

    fn atom(&mut self, input: Input, sign: i32) -> Result<()> {
        if input.peek(token::Paren) {
            self.text.push('(');
            input.nested(|input| {
                input.group(Delimiter::Parenthesis, "a unit", |input| self.factors(input, sign))
            })?;
            self.text.push(')');
            return Ok(());
        }
        let start = input.position();
        let name = Ident::parse(input, "a unit")?;
        let Some(found) = units::unit(&name.text) else { return Err(unknown_unit(input, &name)) };
        self.text.push_str(found.name);
        let exponent = if input.eat_power(start) { self.exponent(input)? } else { 1 };
        self.factors.push(UnitFactor { unit: found, exponent: sign * exponent });
        Ok(())
    }

    fn exponent(&mut self, input: Input) -> Result<i32> {
        let sign = if input.eat(Token![-]) { -1 } else { 1 };
        let number: Option<i32> = input.next().parse().ok().filter(|number| *number <= MAX_EXPONENT);
        let Some(number) = number else {
            let message = format!("the exponent of a unit is a whole number up to {MAX_EXPONENT}");
            input.error(Code::BadUnit, input.here(), message);
            return Err(Reported);
        };
        input.advance();
        let exponent = sign * number;
        self.text.push('^');
        self.text.push_str(&exponent.to_string());
        Ok(exponent)
    }
}

fn unknown_unit(input: Input, name: &Ident) -> Reported {
    let Ident { text, span } = name;
    // Units of two letters are all alike: what differs in one is another.
    let near = nearest(text, names()).filter(|near| text.len() > 2 || near.eq_ignore_ascii_case(text));
    let help = unit_help(text).or_else(|| Some(format!("write `{}`", near?)));
    let mut diagnostic = input.error(Code::UnknownUnit, *span, format!("unknown unit `{text}`"));
    match help {
        Some(help) => diagnostic.help(help),
        None => diagnostic.note(format!("units: {}", names().collect_vec().join(", "))),
    };
    Reported
}

/// Does the unit go on after a `*` or `/` that stands here?
fn goes_on(input: Input) -> bool {
    let factor = input.cursor().punct().filter(|(mark, _)| ['*', '/'].contains(&mark.as_char()));
    factor.is_some_and(|(_, after)| after_unit_name(after).is_some() || is_unit_group(after))
}

/// The cursor after the name of a unit, if that is not the name of a function, of a body or of an array.
fn after_unit_name(cursor: Cursor) -> Option<Cursor> {
    let (name, after) = cursor.ident()?;
    let holds_on = after.group(Delimiter::Parenthesis).is_some()
        || after.group(Delimiter::Bracket).is_some()
        || is_point(after) && !after.punct().is_some_and(|(_, next)| is_point(next));
    (is_unit(&name.unraw().to_string()) && !holds_on).then_some(after)
}

/// Does a point stand here? Two of them are `..`, and no member follows.
fn is_point(cursor: Cursor) -> bool {
    cursor.punct().is_some_and(|(mark, _)| mark.as_char() == '.')
}

/// Does a group open here that is wholly a unit?
fn is_unit_group(cursor: Cursor) -> bool {
    let group = cursor.group(Delimiter::Parenthesis);
    group.is_some_and(|(inside, ..)| units_in(inside).is_some_and(|count| count > 0))
}

/// The number of units in brackets that hold nothing else.
fn units_in(mut cursor: Cursor) -> Option<usize> {
    let (mut count, mut is_exponent) = (0, false);
    while !cursor.eof() {
        let mark = cursor.punct();
        cursor = if let Some(after) = after_unit_name(cursor) {
            count += 1;
            after
        } else if let Some((inside, _, after)) = cursor.group(Delimiter::Parenthesis) {
            count += units_in(inside)?;
            after
        } else if let Some((mark, after)) = &mark {
            "*/^-".contains(mark.as_char()).then_some(*after)?
        } else {
            cursor.literal().filter(|_| is_exponent)?.1
        };
        is_exponent = mark.is_some_and(|(mark, _)| "^-".contains(mark.as_char()));
    }
    Some(count)
}

/// Quantities whose names stand where a unit is wanted, and their units.
const QUANTITIES: &[(&str, &str)] = &[
    ("length", "m"),
    ("distance", "m"),
    ("position", "m"),
    ("displacement", "m"),
    ("angle", "rad"),
    ("time", "s"),
    ("mass", "kg"),
    ("inertia", "kg*m^2"),
    ("force", "N"),
    ("torque", "N*m"),
    ("moment", "N*m"),
    ("velocity", "m/s"),
    ("speed", "m/s"),
    ("acceleration", "m/s^2"),
    ("frequency", "Hz"),
    ("energy", "J"),
    ("power", "W"),
    ("stiffness", "N/m"),
    ("damping", "N/(m/s)"),
    ("area", "m^2"),
    ("volume", "m^3"),
    ("density", "kg/m^3"),
    ("pressure", "Pa"),
    ("temperature", "K"),
    ("current", "ampere"),
    ("voltage", "volt"),
];

/// Spelling of a unit that goes by another name elsewhere.
pub(crate) fn unit_help(name: &str) -> Option<String> {
    let word = if name.len() > 2 { name.to_lowercase() } else { name.to_string() };
    if let Some((quantity, unit)) = QUANTITIES.iter().find(|(quantity, _)| *quantity == word) {
        return Some(format!("`{quantity}` is a quantity: write its unit, `{unit}`"));
    }
    let known = match word.as_str() {
        "Nm" => "N*m",
        "meter" | "meters" | "metre" | "metres" => "m",
        "kilogram" | "kilograms" => "kg",
        "second" | "seconds" | "sec" => "s",
        "newton" | "newtons" => "N",
        "turn" | "turns" => "rev",
        "rpm" => "rev/min",
        "l" => "L",
        "hr" => "h",
        "degrees" => "deg",
        "radian" | "radians" => "rad",
        "grams" => "gram",
        "ton" | "tons" | "tonnes" => "tonne",
        "mg" => "1e-3 gram",
        "µm" | "μm" => "um",
        "inch" | "inches" => "25.4 mm",
        "amp" | "amps" | "amperes" | "A" => "ampere",
        "volts" | "V" => "volt",
        "ohms" | "Ω" => "ohm",
        "henries" | "H" => "henry",
        "joule" | "joules" => "J",
        "watt" | "watts" => "W",
        "pascal" | "pascals" => "Pa",
        "kelvin" => "K",
        "ml" | "mL" => "1e-3 L",
        "degc" | "celsius" | "degreec" => {
            return Some("temperatures are absolute: 20 degrees Celsius are `293.15 K`".to_string());
        }
        "degf" | "fahrenheit" => {
            return Some("temperatures are absolute: 68 degrees Fahrenheit are `293.15 K`".to_string());
        }
        "g" => {
            let help = "grams are `gram`, and the acceleration of gravity is `9.81 m/s^2`";
            return Some(help.to_string());
        }
        "t" => return Some("write `tonne`: `t` is the time".to_string()),
        "f64" | "f32" | "float" | "double" | "i32" | "int" | "usize" => {
            let help = "a number has a unit and no type: write `m`, `N/m`, or `1` where it has none";
            return Some(help.to_string());
        }
        // `m2`
        _ => {
            let (unit, exponent) = name.split_at_checked(name.len().checked_sub(1)?)?;
            let is_power = is_unit(unit) && exponent.starts_with(|digit: char| ('2'..='9').contains(&digit));
            return is_power.then(|| format!("write `{unit}^{exponent}`"));
        }
    };
    Some(format!("write `{known}`"))
}
