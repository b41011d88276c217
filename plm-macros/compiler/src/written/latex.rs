//! Formulas in LaTeX.

use crate::collect::CollectVec;
use plm_cas::Function;

use super::equation::Side;
use super::formula::{Formula, Signed};
use super::name::{GREEK, Name};

/// An equation.
pub(super) fn equation([left, right]: &[Side; 2]) -> String {
    format!("{} = {}", sum(left), sum(right))
}

fn sum(terms: &[Signed]) -> String {
    if terms.is_empty() {
        return "0".to_owned();
    }
    let term = |(k, (minus, formula)): (usize, &Signed)| {
        let sign = match (k, minus) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        let text = if matches!(formula, Formula::Sum(_)) { enclosed(formula) } else { written(formula) };
        format!("{sign}{text}")
    };
    terms.iter().enumerate().map(term).collect_vec().concat()
}

fn written(formula: &Formula) -> String {
    match formula {
        Formula::Number(text) => number(text),
        Formula::Name(own) => name(own),
        Formula::Sum(terms) => sum(terms),
        Formula::Product(factors) => factors.iter().map(factor).collect_vec().join(" "),
        Formula::Fraction(above, below) => format!("\\frac{{{}}}{{{}}}", written(above), written(below)),
        Formula::Power(base, power) => match &**base {
            // The power of a function stands behind its name.
            Formula::Call(function @ (Function::Sin | Function::Cos), arguments) => {
                call(&format!("\\{function}^{{{power}}}"), arguments)
            }
            Formula::Name(own) => format!("{}^{{{power}}}", name(own)),
            Formula::Number(text) => format!("{}^{{{power}}}", number(text)),
            other => format!("{}^{{{power}}}", enclosed(other)),
        },
        Formula::Call(function, arguments) => of_function(*function, arguments),
        Formula::Cases(parts) => {
            let [a, b, yes, no] = parts.each_ref().map(written);
            format!("\\begin{{cases}} {yes} & {a} < {b} \\\\ {no} & \\text{{else}} \\end{{cases}}")
        }
        Formula::Ellipsis => "\\dots".to_owned(),
    }
}

fn factor(formula: &Formula) -> String {
    if matches!(formula, Formula::Sum(_)) { enclosed(formula) } else { written(formula) }
}

fn enclosed(formula: &Formula) -> String {
    format!("\\left({}\\right)", written(formula))
}

fn of_function(function: Function, arguments: &[Formula]) -> String {
    let inside = || arguments.iter().map(written).collect_vec().join(", ");
    match function {
        Function::Sin | Function::Cos | Function::Ln => call(&format!("\\{function}"), arguments),
        Function::Asin => call("\\arcsin", arguments),
        Function::Acos => call("\\arccos", arguments),
        Function::Atan2 => format!("\\operatorname{{atan2}}\\left({}\\right)", inside()),
        Function::Sqrt => format!("\\sqrt{{{}}}", inside()),
        Function::Exp => format!("e^{{{}}}", inside()),
        Function::Abs => format!("\\left|{}\\right|", inside()),
        Function::Sign => format!("\\operatorname{{sgn}}\\left({}\\right)", inside()),
        Function::Min | Function::Max => format!("\\{function}\\left({}\\right)", inside()),
        Function::Floor => format!("\\left\\lfloor {}\\right\\rfloor", inside()),
    }
}

/// A function of one argument: a name or a number stands without brackets.
fn call(function: &str, arguments: &[Formula]) -> String {
    match arguments {
        [only @ (Formula::Name(_) | Formula::Number(_))] => format!("{function} {}", written(only)),
        _ => format!("{function}\\left({}\\right)", arguments.iter().map(written).collect_vec().join(", ")),
    }
}

/// `2.1e11` as a power of ten.
fn number(text: &str) -> String {
    text.split_once('e').map_or(text.to_owned(), |(digits, power)| format!("{digits} \\cdot 10^{{{power}}}"))
}

/// A symbol: letters as they are, words upright.
pub(super) fn name(Name { base, below, dots }: &Name) -> String {
    let own = letter(base);
    let own = match dots {
        0 => own,
        1 => format!("\\dot{{{own}}}"),
        _ => format!("\\ddot{{{own}}}"),
    };
    if below.is_empty() {
        return own;
    }
    let below = below.iter().map(|part| letter(part)).collect_vec().join(",");
    format!("{own}_{{{below}}}")
}

fn letter(word: &str) -> String {
    if GREEK.iter().any(|(name, _)| *name == word) {
        format!("\\{word}")
    } else if word.chars().count() == 1 || word.chars().all(|letter| letter.is_ascii_digit()) {
        word.to_owned()
    } else {
        format!("\\mathrm{{{}}}", word.replace('_', "\\_"))
    }
}
