//! Expectations of a place, and the error when something else stands there.

use crate::collect::CollectVec;
use plm_cas::algebra::Vec2;
use plm_cas::{Expr, Number};

use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::names::{ScopeId, Thunk};
use crate::resolve::values::{Additive, Eval, Failed, Form, Nature, Quantity, Reads, Scalar, Value, Vector};
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind, ItemKind};
use crate::units::Dimension;

/// Kind of value that a place expects.
#[derive(Clone, Copy)]
pub(crate) enum Wanted {
    /// Anything.
    Anything,
    /// A frame.
    Frame,
    /// A body.
    Body,
    /// A node of a domain: index into the resolver's list.
    Port(usize),
    /// Value of a node: its across quantity, or another node of its domain.
    Node(usize),
    /// A number of a dimension that reads no more than it may.
    Number(Dimension, Reads),
    /// A vector of a dimension that reads no more than it may.
    Vector(Dimension, Reads),
    /// Such a number, or a vector of two.
    NumberOrVector(Dimension, Reads),
}

/// Does a quantity fit a dimension?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fit {
    Fits,
    NoUnit,
    NoAngleUnit,
    Wrong,
}

fn fit(wanted: Dimension, found: Nature, is_zero: bool) -> Fit {
    let bare = found.form == Form::Bare;
    if bare && is_zero {
        return Fit::Fits;
    }
    if !wanted.same(found.dimension) {
        return if bare { Fit::NoUnit } else { Fit::Wrong };
    }
    // The radian cancels in what was worked out; what was written down must say what it is.
    if found.form == Form::Derived || wanted.rad == found.dimension.rad {
        return Fit::Fits;
    }
    match (wanted.is_angular(), found.dimension.is_angular()) {
        (true, _) if bare => Fit::NoAngleUnit,
        (true, _) | (_, true) => Fit::Wrong,
        _ => Fit::Fits,
    }
}

impl<'a> Resolver<'a> {
    /// Is the value what its place expects?
    pub(crate) fn wanted(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        value: Value,
        wanted: Wanted,
    ) -> Eval<Value> {
        match (wanted, &value) {
            (Wanted::Anything, _) | (Wanted::Frame, Value::Frame(_)) | (Wanted::Body, Value::Body(_)) => {
                Ok(value)
            }
            (Wanted::Frame, _) => Err(self.wrong_kind(scope, expr, "a frame", &value)),
            (Wanted::Body, _) => Err(self.wrong_kind(scope, expr, "a body", &value)),
            (Wanted::Port(domain), _) => self.port_of_domain(scope, expr, value, domain),
            (Wanted::Node(node), _) => self.value_of_node(scope, expr, value, node),
            (
                Wanted::Number(dimension, reads) | Wanted::NumberOrVector(dimension, reads),
                Value::Scalar(found),
            ) => Ok(self.suits(scope, expr, *found, dimension, reads)?.written_as(dimension).into()),
            (
                Wanted::Vector(dimension, reads) | Wanted::NumberOrVector(dimension, reads),
                Value::Vector(found),
            ) => Ok(self.suits(scope, expr, *found, dimension, reads)?.written_as(dimension).into()),
            (Wanted::NumberOrVector(..), _) => {
                Err(self.wrong_kind(scope, expr, "a number or a vector", &value))
            }
            (Wanted::Vector(..), _) => Err(self.wrong_kind(scope, expr, "a point", &value)),
            (Wanted::Number(..), _) => Err(self.wrong_kind(scope, expr, "a number", &value)),
        }
    }

    /// A number of a dimension that reads no more than it may.
    pub(crate) fn eval_number(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        dimension: Dimension,
        reads: Reads,
    ) -> Eval<Expr> {
        self.eval_quantity(scope, expr, dimension, reads).map(|found| found.value)
    }

    /// A number of a dimension that reads no more than it may, and what is known of it.
    pub(crate) fn eval_quantity(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        dimension: Dimension,
        reads: Reads,
    ) -> Eval<Scalar> {
        let found = self.eval_scalar(scope, expr)?;
        self.suits(scope, expr, found, dimension, reads)
    }

    /// A vector of a dimension that reads no more than it may, and what is known of it.
    pub(crate) fn eval_vector(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        dimension: Dimension,
        reads: Reads,
    ) -> Eval<Vector> {
        let found = match self.eval(scope, expr)? {
            Value::Vector(found) => found,
            // `0` needs no unit, and no second component.
            Value::Scalar(found) if found.is_bare_zero() => found.map(|_| Vec2::ZERO),
            other => return Err(self.wrong_kind(scope, expr, "a vector", &other)),
        };
        self.suits(scope, expr, found, dimension, reads)
    }

    /// A number of any dimension.
    pub(crate) fn eval_scalar(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<Scalar> {
        match self.eval(scope, expr)? {
            Value::Scalar(found) => Ok(found),
            other => Err(self.wrong_kind(scope, expr, "a number", &other)),
        }
    }

    /// Has it the dimension, and does it read no more than it may?
    pub(super) fn suits<T: Additive>(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        found: Quantity<T>,
        dimension: Dimension,
        reads: Reads,
    ) -> Eval<Quantity<T>> {
        self.fits(scope, expr, found, dimension)?;
        self.reads_only(scope, expr, found.nature.reads, reads)?;
        Ok(found)
    }

    /// The smallest part of an expression that reads any of these, and its scope: where one side of an operation alone does so, that
    /// side. In a part of the library it is what the use of the part has set.
    pub(crate) fn culprit(&mut self, scope: ScopeId, expr: &'a ast::Expr, of: Reads) -> (ScopeId, Span) {
        let mut reading = Vec::new();
        for part in self.operands(scope, expr) {
            if self.reads_any(scope, part, of) {
                reading.push(part);
            }
        }
        if let [part] = reading[..] {
            return self.culprit(scope, part, of);
        }
        match self.named_in_library(scope, expr) {
            Some(Thunk { scope, expr, .. }) => self.culprit(scope, expr, of),
            None => (scope, expr.span),
        }
    }

    /// A value as it was written: of a name in a part of the library, what the use of the part has set.
    pub(crate) fn origin(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> (ScopeId, &'a ast::Expr) {
        match self.named_in_library(scope, expr) {
            Some(Thunk { scope, expr, .. }) => self.origin(scope, expr),
            None => (scope, expr),
        }
    }

    /// The expression of a name that stands in a part of the library.
    fn named_in_library(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Option<Thunk<'a>> {
        let is_of_library = expr.span.source != 0;
        let slot = match &expr.kind {
            ExprKind::Name(name) if is_of_library => {
                self.key(scope, name).ok().and_then(|key| self.names.find(scope, &key))
            }
            _ => None,
        };
        self.names.slots[slot?].thunk
    }

    /// Operands of an operation, arguments of a function; of a choice that is made already, what is chosen.
    pub(crate) fn operands(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Vec<&'a ast::Expr> {
        match &expr.kind {
            ExprKind::Neg(inner) => vec![inner],
            ExprKind::Pair(x, y) | ExprKind::Power(x, y) => vec![x, y],
            ExprKind::Chain(first, links) => {
                std::iter::once(&**first).chain(links.iter().map(|link| &link.operand)).collect_vec()
            }
            ExprKind::Call(function, arguments) if function.text != "reaction" && function.text != "rate" => {
                // Points of a table are no vectors.
                arguments.iter().filter(|of| !matches!(of.kind, ExprKind::Pair(..))).collect_vec()
            }
            ExprKind::If(condition, yes, no) => match self.condition(scope, condition) {
                Ok((condition, _)) => match condition.known() {
                    Some(holds) => vec![if holds { yes } else { no }],
                    None => vec![yes, no],
                },
                Err(Failed) => Vec::new(),
            },
            _ => Vec::new(),
        }
    }

    /// Does an expression read any of these?
    pub(crate) fn reads_any(&mut self, scope: ScopeId, expr: &'a ast::Expr, of: Reads) -> bool {
        self.eval(scope, expr).is_ok_and(|value| value.reads().has(of))
    }

    /// A whole number that is known now.
    pub(crate) fn eval_int(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<i64> {
        let found = self.eval_scalar(scope, expr)?;
        whole_number(found).ok_or_else(|| {
            let message = "a whole number is expected that is known here";
            self.error(scope, Code::NotInteger, expr.span, message);
            Failed
        })
    }

    pub(crate) fn wrong_kind(
        &mut self,
        scope: ScopeId,
        expr: &ast::Expr,
        wanted: &str,
        found: &Value,
    ) -> Failed {
        let ports = match found {
            Value::Body(body) if wanted == "a frame" => self.unresolved.port_names(*body),
            _ => Vec::new(),
        };
        let message = format!("expected {wanted}, found {}", found.kind());
        let diagnostic = self.error(scope, Code::WrongKind, expr.span, message);
        if !ports.is_empty() {
            diagnostic.help(format!("name one of its ports: {}", ports.join(", ")));
        }
        Failed
    }

    fn fits<T: Additive>(
        &mut self,
        scope: ScopeId,
        expr: &ast::Expr,
        Quantity { value, nature: found }: Quantity<T>,
        wanted: Dimension,
    ) -> Eval<()> {
        let text = literal_text(expr);
        let expected = wanted.describe();
        let mut replacement = None;
        let (code, message, help) = match fit(wanted, found, value.is_zero()) {
            Fit::Fits => return Ok(()),
            Fit::Wrong => {
                let is_rate = found.dimension.over(Dimension::TIME) == wanted;
                replacement = text.as_ref().filter(|_| is_rate).map(|text| match text.strip_suffix("/s") {
                    Some(value) => format!("{value}/s^2"),
                    None => format!("{text}/s"),
                });
                let help = replacement.as_ref().map(|text| format!("write `{text}`"));
                let help = help.or_else(|| self.meant_parameter(expr, found.dimension));
                let found = match text {
                    Some(text) => format!("{text}, {}", found.dimension.name()),
                    None => found.dimension.describe(),
                };
                (Code::WrongDimension, format!("expected {expected}, found {found}"), help)
            }
            Fit::NoUnit => {
                replacement = text.as_ref().map(|text| format!("{text} {}", wanted.si_unit()));
                let text = text.unwrap_or_else(|| "a number".to_string());
                let help = format!("write its unit: `{} {}`", blank(&text), wanted.si_unit());
                (Code::MissingUnit, format!("expected {expected}, found {text} without a unit"), Some(help))
            }
            Fit::NoAngleUnit => {
                let text = text.unwrap_or_else(|| "a number".to_string());
                let per = wanted.si_unit().replacen("rad", "", 1);
                let number = blank(&text);
                let help = format!(
                    "say what it is: `{number} deg{per}`, `{number} rad{per}` or `{number} rev{per}`"
                );
                (
                    Code::MissingAngleUnit,
                    format!("expected {expected}, found {text} without a unit"),
                    Some(help),
                )
            }
        };
        let diagnostic = self.error(scope, code, expr.span, message);
        match (help, replacement) {
            (Some(help), Some(text)) => drop(diagnostic.help_with(help, text)),
            (Some(help), None) => drop(diagnostic.help(help)),
            (None, _) => {}
        }
        Err(Failed)
    }
}

impl Resolver<'_> {
    /// The parameter that may be meant where a part is given this value: its name ends in the one that was set, and it has the dimension.
    fn meant_parameter(&self, expr: &ast::Expr, found: Dimension) -> Option<String> {
        let set = |field: &&ast::Field| field.value.span == expr.span && field.path.len() == 1;
        self.names.instances.iter().find_map(|instance| {
            let ending = format!("_{}", instance.ast.fields.iter().find(set)?.path.first()?.ident.text);
            let is_meant = |item: &ast::Item| match &item.kind {
                ItemKind::Param(value) => {
                    let dimension = value.unit.as_ref().map(|unit| unit.dimension);
                    let name = &value.name.ident.text;
                    (dimension == Some(found) && name.ends_with(&ending)).then(|| name.clone())
                }
                _ => None,
            };
            let name = instance.definition.items.iter().find_map(is_meant)?;
            Some(format!("`{name}` is {}", found.describe()))
        })
    }
}

/// A literal as it was written, as nearly as is worth it: `30 deg`, `-0.5`.
pub(crate) fn literal_text(expr: &ast::Expr) -> Option<String> {
    match &expr.kind {
        ExprKind::Number(number) => Some(number.to_f64().to_string()),
        ExprKind::Quantity(number, unit) => Some(format!("{} {}", literal_text(number)?, unit.text)),
        ExprKind::Neg(inner) => Some(format!("-{}", literal_text(inner)?)),
        ExprKind::Pair(x, y) => Some(format!("({}, {})", literal_text(x)?, literal_text(y)?)),
        _ => None,
    }
}

/// An expression of names and literals as it was written, as nearly as is worth it.
pub(crate) fn text_of(expr: &ast::Expr) -> Option<String> {
    match &expr.kind {
        ExprKind::Name(name) if name.indices.is_empty() => Some(name.ident.text.clone()),
        ExprKind::Path(base, members) if members.iter().all(|member| member.indices.is_empty()) => {
            let members = members.iter().map(|member| format!(".{}", member.ident.text));
            Some(text_of(base)? + &members.collect::<String>())
        }
        ExprKind::Neg(inner) => Some(format!("-{}", text_of(inner)?)),
        ExprKind::Pair(x, y) => Some(format!("({}, {})", text_of(x)?, text_of(y)?)),
        ExprKind::Chain(first, links) if links.len() == 1 => {
            let link = &links[0];
            let is_product = matches!(link.operator, ast::Operator::Mul | ast::Operator::Div);
            let space = if is_product { "" } else { " " };
            let right = text_of(&link.operand)?;
            Some(format!("{}{space}{}{space}{right}", text_of(first)?, link.operator.text()))
        }
        _ => literal_text(expr),
    }
}

/// Text of an example where there is no literal to repeat.
fn blank(text: &str) -> &str {
    if text.starts_with("a ") { "1" } else { text }
}

pub(crate) fn whole_number(found: Scalar) -> Option<i64> {
    let number = found.value.as_number().filter(|_| found.nature.dimension == Dimension::NUMBER);
    number.and_then(Number::as_int)
}

#[cfg(test)]
mod tests {
    use super::{Fit, fit};
    use crate::resolve::values::{Form, Nature, Reads};
    use crate::units::Dimension;

    #[test]
    fn angles_must_say_so_where_they_are_written() {
        let number = |form| Nature { dimension: Dimension::NUMBER, form, reads: Reads::NOTHING };
        assert_eq!(fit(Dimension::ANGLE, number(Form::Bare), false), Fit::NoAngleUnit);
        assert_eq!(fit(Dimension::ANGLE, number(Form::Bare), true), Fit::Fits);
        assert_eq!(fit(Dimension::ANGLE, number(Form::Derived), false), Fit::Fits);
        assert_eq!(fit(Dimension::LENGTH, number(Form::Bare), false), Fit::NoUnit);
        let angle = Nature::written(Dimension::ANGLE, Reads::NOTHING);
        assert_eq!(fit(Dimension::NUMBER, angle, false), Fit::Wrong);
        assert_eq!(fit(Dimension::LENGTH, angle, false), Fit::Wrong);
        let torque = Nature::written(Dimension::TORQUE, Reads::NOTHING);
        assert_eq!(fit(Dimension::TORQUE.over(Dimension::ANGLE), torque, false), Fit::Fits);
    }
}
