//! Formulas in MathML, of the elements that MathML Core has.

use crate::collect::CollectVec;
use plm_cas::Function;

use super::equation::Side;
use super::formula::{Formula, Signed};
use super::name::{GREEK, Name};

/// An equation as a `math` element.
pub(super) fn equation([left, right]: &[Side; 2]) -> String {
    format!("<math display=\"block\">{}<mo>=</mo>{}</math>", sum(left), sum(right))
}

fn sum(terms: &[Signed]) -> String {
    if terms.is_empty() {
        return "<mn>0</mn>".to_owned();
    }
    let term = |(k, (minus, formula)): (usize, &Signed)| {
        let sign = match (k, minus) {
            (0, false) => "",
            (0, true) => "<mo form=\"prefix\">−</mo>",
            (_, false) => "<mo>+</mo>",
            (_, true) => "<mo>−</mo>",
        };
        format!("{sign}{}", factor(formula))
    };
    terms.iter().enumerate().map(term).collect_vec().concat()
}

fn row(inside: &str) -> String {
    format!("<mrow>{inside}</mrow>")
}

fn enclosed(open: &str, inside: &str, close: &str) -> String {
    format!("<mrow><mo>{open}</mo>{inside}<mo>{close}</mo></mrow>")
}

fn factor(formula: &Formula) -> String {
    let text = written(formula);
    if matches!(formula, Formula::Sum(_)) { enclosed("(", &text, ")") } else { text }
}

fn written(formula: &Formula) -> String {
    match formula {
        Formula::Number(text) => number(text),
        Formula::Name(own) => name(own),
        Formula::Sum(terms) => row(&sum(terms)),
        Formula::Product(factors) => {
            row(&factors.iter().map(factor).collect_vec().join("<mspace width=\"0.17em\"/>"))
        }
        Formula::Fraction(above, below) => format!("<mfrac>{}{}</mfrac>", written(above), written(below)),
        Formula::Power(base, power) => match &**base {
            // The power of a function stands behind its name.
            Formula::Call(function @ (Function::Sin | Function::Cos), arguments) => {
                let function = format!("<msup><mi>{function}</mi><mn>{power}</mn></msup>");
                call(&function, arguments)
            }
            other => format!("<msup>{}<mn>{power}</mn></msup>", factor(other)),
        },
        Formula::Call(function, arguments) => of_function(*function, arguments),
        Formula::Cases(parts) => {
            let [a, b, yes, no] = parts.each_ref().map(written);
            let first = format!("<mtr><mtd>{yes}</mtd><mtd>{a}<mo>&lt;</mo>{b}</mtd></mtr>");
            let second = format!("<mtr><mtd>{no}</mtd><mtd><mtext>else</mtext></mtd></mtr>");
            format!("<mrow><mo>{{</mo><mtable>{first}{second}</mtable></mrow>")
        }
        Formula::Ellipsis => "<mo>…</mo>".to_owned(),
    }
}

fn of_function(function: Function, arguments: &[Formula]) -> String {
    let inside = || arguments.iter().map(written).collect_vec().join("<mo>,</mo>");
    match function {
        Function::Sqrt => format!("<msqrt>{}</msqrt>", inside()),
        Function::Exp => format!("<msup><mi>e</mi>{}</msup>", row(&inside())),
        Function::Abs => enclosed("|", &inside(), "|"),
        Function::Floor => enclosed("⌊", &inside(), "⌋"),
        Function::Asin => call("<mi>arcsin</mi>", arguments),
        Function::Acos => call("<mi>arccos</mi>", arguments),
        Function::Sign => call("<mi>sgn</mi>", arguments),
        other => call(&format!("<mi>{other}</mi>"), arguments),
    }
}

/// A function; one name or number stands without brackets.
fn call(function: &str, arguments: &[Formula]) -> String {
    let inside = arguments.iter().map(written).collect_vec().join("<mo>,</mo>");
    let inside = match arguments {
        [Formula::Name(_) | Formula::Number(_)] => format!("<mspace width=\"0.17em\"/>{inside}"),
        _ => enclosed("(", &inside, ")"),
    };
    row(&format!("{function}{inside}"))
}

fn number(text: &str) -> String {
    match text.split_once('e') {
        None => format!("<mn>{text}</mn>"),
        Some((digits, power)) => {
            row(&format!("<mn>{digits}</mn><mo>·</mo><msup><mn>10</mn><mn>{power}</mn></msup>"))
        }
    }
}

/// A symbol: one letter is slanted by itself, a word upright.
pub(super) fn name(Name { base, below, dots }: &Name) -> String {
    let own = format!("<mi>{}</mi>", letter(base));
    let own = match dots {
        0 => own,
        1 => format!("<mover>{own}<mo>˙</mo></mover>"),
        _ => format!("<mover>{own}<mo>¨</mo></mover>"),
    };
    if below.is_empty() {
        return own;
    }
    let below =
        below.iter().map(|part| format!("<mi>{}</mi>", letter(part))).collect_vec().join("<mo>,</mo>");
    format!("<msub>{own}{}</msub>", row(&below))
}

fn letter(word: &str) -> String {
    let greek = GREEK.iter().find(|(name, _)| *name == word).map(|(_, letter)| letter.to_string());
    greek.unwrap_or_else(|| word.replace('&', "&amp;").replace('<', "&lt;"))
}
