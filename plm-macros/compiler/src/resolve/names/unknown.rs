//! Help for unknown names.

use crate::collect::CollectVec;
use crate::diag::{Code, help_similar, nearest};
use crate::library::{ELSEWHERE, of_manual};
use crate::resolve::Resolver;
use crate::resolve::names::{RowId, ScopeId};
use crate::resolve::values::Failed;
use crate::resolve::values::expect::text_of;
use crate::syntax::ast::{self, IndexedName};
use crate::syntax::{CONSTANTS, unit_help};
use crate::units::{Dimension, unit};

impl Resolver<'_> {
    pub(crate) fn unknown_name(&mut self, scope: ScopeId, name: &IndexedName, key: &str) -> Failed {
        let (text, span) = (&name.ident.text, name.ident.span);
        let is_shown =
            [Code::UnknownName, Code::NeedsIndex, Code::BadIndex].iter().all(|of| self.sink.shows(*of));
        let names = if is_shown { self.names.visible(scope) } else { Vec::new() };
        let stem = format!("{text}[");
        let elements: Vec<&str> =
            names.iter().map(String::as_str).filter(|name| name.starts_with(&stem)).collect_vec();
        if let (Some(first), Some(last)) = (elements.first(), elements.last()) {
            let note = format!("there is `{first}` to `{last}`");
            let (code, message) = if name.indices.is_empty() {
                (Code::NeedsIndex, format!("`{text}` needs an index"))
            } else {
                (Code::BadIndex, format!("there is no `{key}`"))
            };
            self.error(scope, code, span, message).note(note);
            return Failed;
        }
        if let Some(unit) = unit(text).filter(|_| name.indices.is_empty()) {
            let message = format!("`{text}` is {}, and a unit follows a number", unit.word);
            let help = format!("write `1 {text}`, or choose a name like `{}`", instead_of(unit.dimension));
            self.error(scope, Code::UnitAsName, span, message).help(help);
            return Failed;
        }
        let home = self.names.home(scope);
        let row = self.names.scopes[home].rows.get(key).map(|(row, _)| *row);
        let is_optional = self.names.is_optional(scope, key);
        let outside = self.names.instance(scope).is_some() && self.names.find(0, key).is_some();
        let owner = self.owner_of_port(scope, key);
        let names: Vec<&str> = names.iter().map(String::as_str).collect_vec();
        let is_near = nearest(key, names.iter().copied()).is_some();
        let diagnostic = self.error(scope, Code::UnknownName, span, format!("unknown name `{key}`"));
        if let Some(row) = row {
            diagnostic.help(match row {
                RowId::Constraint(_) => {
                    format!("`{key}` is a constraint: what holds it is `reaction({key})`")
                }
                RowId::Contact(_) => {
                    format!("`{key}` is a row of contact: its force is `reaction({key})`")
                }
            });
            return Failed;
        }
        if is_optional {
            diagnostic.help(format!(
                "the use of the part need not set it: it is known in `given {key} {{ … }}` alone"
            ));
            return Failed;
        }
        if let Some(owner) = owner.filter(|_| !is_near) {
            diagnostic.help(format!(
                "`{key}` is a port of `{owner}`, which is `{owner}.{key}` in a motion; a point has a name by `let {key} = (…, …) m;`"
            ));
            return Failed;
        }
        if outside {
            diagnostic.help("a part sees only its own names: hand it over as a param or an input");
        }
        let meant = match text.as_str() {
            "PI" => Some("write `pi`".to_string()),
            "time" => Some("the time is `t`".to_string()),
            _ if is_constant(text) && !is_near => Some(CONSTANTS.to_string()),
            _ => unit_help(text),
        };
        let is_meant = meant.is_some();
        if let Some(help) = meant {
            diagnostic.help(help);
        }
        if !is_meant || is_near {
            help_similar(diagnostic, key, "name", "names here", &names);
        }
        Failed
    }

    /// The first body of the mechanism itself, or its ground, that has a port with this name.
    fn owner_of_port(&self, scope: ScopeId, port: &str) -> Option<String> {
        if self.names.instance(scope).is_some() {
            return None;
        }
        let has_port = |body| self.unresolved.port_index(body, port).is_some();
        let mut bodies = self.unresolved.bodies.iter().enumerate();
        let own = bodies.find(|(number, _)| has_port(Some(*number))).map(|(_, body)| body.name.text.clone());
        own.or_else(|| has_port(None).then(|| "ground".to_owned()))
    }

    pub(crate) fn unknown_part(&mut self, scope: ScopeId, ast: &ast::Instance) {
        let kind = &ast.kind.text;
        let mut names: Vec<&str> = self.library.kinds().collect_vec();
        names.sort_unstable();
        names.dedup();
        let lower = kind.to_lowercase();
        let elsewhere = ELSEWHERE.iter().find(|(words, _)| {
            words.iter().any(|word| *word == lower || (word.starts_with("plm") && lower.starts_with(word)))
        });
        let manual = of_manual(kind);
        let near = nearest(kind, names.iter().copied());
        let diagnostic =
            self.error(scope, Code::UnknownPart, ast.kind.span, format!("unknown part `{kind}`"));
        // The library is long: all of it is shown only to who is far off.
        match (elsewhere, near) {
            (Some((_, help)), _) => diagnostic.help(*help),
            _ if !manual.is_empty() => {
                diagnostic.help(format!("the manual's {kind} is `{}` here", manual.join("` or `")))
            }
            (_, Some(near)) => {
                diagnostic.help_with(format!("a part with a similar name exists: `{near}`"), near)
            }
            _ => diagnostic.note(format!("parts: {}", names.join(", "))),
        };
    }
}

/// Equivalents of functions of other languages.
pub(crate) fn function_elsewhere(name: &str, arguments: &[ast::Expr]) -> Option<String> {
    Some(match (name, arguments) {
        ("pow" | "powi" | "powf", [base, exponent]) => match (text_of(base), text_of(exponent)) {
            (Some(base), Some(exponent)) => format!("write `{base}^{exponent}`"),
            _ => "a power is written `x^2`".to_string(),
        },
        ("arctan", [_]) => "write `atan(x)`".to_string(),
        ("arctan" | "arctan2", _) => "write `atan2(y, x)`".to_string(),
        ("der" | "diff" | "ddt", _) => "the derivative with time is `rate(x)`".to_string(),
        ("deg" | "degrees" | "radians" | "rad", _) => "an angle has a unit: `30 deg`".to_string(),
        ("rem" | "modulo" | "fmod" | "remainder", [x, period]) => match (text_of(x), text_of(period)) {
            (Some(x), Some(period)) => format!("write `mod({x}, {period})`"),
            _ => "the remainder is `mod(x, period)`".to_string(),
        },
        ("ceil", _) => "write `-floor(-x)`".to_string(),
        ("round", _) => "write `floor(x + 0.5)`".to_string(),
        ("int" | "trunc" | "integer", _) => "the integer below is `floor(x)`".to_string(),
        ("lookup" | "interp" | "interp1" | "table1", _) => {
            "write `table(x, (x0, y0), (x1, y1), …)`".to_string()
        }
        ("lookup2" | "interp2" | "table2", _) => {
            "a table of two arguments is a table of tables: `table(x, (x0, table(y, …)), (x1, table(y, …)))`"
                .to_string()
        }
        ("log", _) => "the natural logarithm is `ln(x)`".to_string(),
        _ => return None,
    })
}

/// In the manner of Rust's constants.
fn is_constant(name: &str) -> bool {
    name.len() > 1 && name.chars().all(|c| c.is_uppercase() || c.is_ascii_digit() || c == '_')
}

/// A name that one could choose for a quantity of this dimension.
pub(crate) fn instead_of(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::LENGTH => "length",
        Dimension::MASS => "mass",
        Dimension::INERTIA => "inertia",
        Dimension::TIME => "time",
        Dimension::ANGLE => "angle",
        Dimension::VELOCITY | Dimension::ANGULAR_VELOCITY => "speed",
        Dimension::FORCE => "load",
        Dimension::TORQUE => "energy",
        _ => "value",
    }
}
