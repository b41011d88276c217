//! Expressions: names, members, operators, conditions.

use plm_cas::algebra::Vec2;
use plm_cas::{Expr, Node, Number};

use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::expect::whole_number;
use crate::resolve::values::{Additive, Condition, Eval, Failed, Form, Nature, Quantity, Reads, Value};
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind, Link, Operator};
use crate::units::{self, Dimension, DisplayUnit, MAY_BE_NAMES};

/// Definitions and expressions may need each other this deeply.
const MAX_DEPTH: u32 = 200;

/// Largest exponent.
const MAX_EXPONENT: i32 = 100;

impl<'a> Resolver<'a> {
    /// The value of an expression.
    pub(crate) fn eval(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<Value> {
        if self.depth >= MAX_DEPTH {
            let message = format!("definitions need each other more than {MAX_DEPTH} levels deep");
            self.error(scope, Code::TooDeep, expr.span, message);
            return Err(Failed);
        }
        self.depth += 1;
        let value = self.eval_kind(scope, expr);
        self.depth -= 1;
        let value = value?;
        let is_finite = match &value {
            Value::Scalar(x) => is_finite(x.value),
            Value::Vector(pair) => is_finite(pair.value.x) && is_finite(pair.value.y),
            _ => true,
        };
        if is_finite {
            return Ok(value);
        }
        let message = "this is beyond the numbers that there are, of at most 1.8e308";
        self.error(scope, Code::OutOfDomain, expr.span, message);
        Err(Failed)
    }

    fn eval_kind(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<Value> {
        match &expr.kind {
            ExprKind::Unknown => Err(Failed),
            ExprKind::Number(number) => Ok(Quantity::new(Expr::from(*number), Nature::BARE).into()),
            ExprKind::Quantity(inner, unit) => self.quantity(scope, inner, unit),
            ExprKind::Pair(x, y) => self.pair(scope, expr.span, x, y),
            ExprKind::Name(name) => self.lookup(scope, name),
            ExprKind::Path(base, members) => {
                let mut value = self.eval(scope, base)?;
                for member in members {
                    value = self.member(scope, &value, member)?;
                }
                Ok(value)
            }
            ExprKind::Call(function, arguments) => self.call(scope, expr.span, function, arguments),
            ExprKind::Neg(inner) => {
                let value = self.eval(scope, inner)?;
                self.negative(scope, inner, value)
            }
            ExprKind::Not(inner) => {
                let (condition, reads) = self.condition(scope, inner)?;
                Ok(Value::Condition(Condition::Not(Box::new(condition)), reads))
            }
            ExprKind::Power(base, exponent) => self.power(scope, base, exponent),
            ExprKind::Chain(first, links) => self.chain(scope, first, links),
            ExprKind::If(condition, yes, no) => self.choose(scope, expr.span, condition, yes, no),
        }
    }

    /// `10 N/L`, where `L` is a value as well: the unit is read.
    fn warn_of_unit_that_is_a_name(&mut self, scope: ScopeId, inner: &ast::Expr, unit: &DisplayUnit) {
        let mut factors =
            unit.text.split(['*', '/', '(', ')']).map(|of| of.split('^').next().unwrap_or_default());
        factors.next();
        let is_value = |name: &str| MAY_BE_NAMES.contains(&name) && self.names.find(scope, name).is_some();
        if let Some(name) = factors.find(|name| is_value(name)) {
            let word = units::unit(name).map_or("a unit", |unit| unit.word);
            let message =
                format!("`{}` is read as a unit, with {word}, and `{name}` is a value here too", unit.text);
            self.sink.warning(Code::UnitOrName, inner.span, message).help(format!(
                "the value stands in front: `{name}*…` or `1/{name}*…`; where the unit is meant, call the value otherwise"
            ));
        }
    }

    /// A literal with a unit, in SI.
    fn quantity(&mut self, scope: ScopeId, inner: &'a ast::Expr, unit: &DisplayUnit) -> Eval<Value> {
        self.warn_of_unit_that_is_a_name(scope, inner, unit);
        match self.eval(scope, inner)? {
            Value::Scalar(found) if found.nature.dimension != Dimension::NUMBER => {
                let message = format!("a unit after {}", found.nature.dimension.describe());
                self.error(scope, Code::BadUnit, inner.span, message)
                    .help("it has a unit: leave this one out");
                Err(Failed)
            }
            Value::Scalar(number) => Ok(in_unit(unit, number).into()),
            Value::Vector(pair) if pair.nature.dimension != Dimension::NUMBER => {
                let message = format!(
                    "a unit after the pair, but its components are {}",
                    pair.nature.dimension.describe()
                );
                let help = match crate::resolve::values::expect::text_of(inner) {
                    Some(pair) => format!("its components have their units: write `{pair}`"),
                    None => "its components have their units: leave this out".to_string(),
                };
                self.error(scope, Code::BadUnit, inner.span, message).help(help);
                Err(Failed)
            }
            Value::Vector(pair) => Ok(in_unit(unit, pair).into()),
            other => Err(self.wrong_kind(scope, inner, "a number", &other)),
        }
    }

    fn pair(&mut self, scope: ScopeId, span: Span, x: &'a ast::Expr, y: &'a ast::Expr) -> Eval<Value> {
        let (x, y) = (self.eval_scalar(scope, x), self.eval_scalar(scope, y));
        let (x, y) = (x?, y?);
        let nature = self.joined(scope, span, x, y)?;
        Ok(Quantity::new(Vec2::new(x.value, y.value), nature).into())
    }

    fn negative(&mut self, scope: ScopeId, inner: &'a ast::Expr, value: Value) -> Eval<Value> {
        match value {
            Value::Scalar(x) => Ok(x.map(|x| -x).into()),
            Value::Vector(v) => Ok(v.map(|v| -v).into()),
            other => Err(self.wrong_kind(scope, inner, "a number or a vector", &other)),
        }
    }

    /// Powers have whole exponents, so that dimensions and derivatives stay simple.
    fn power(&mut self, scope: ScopeId, base: &'a ast::Expr, exponent: &'a ast::Expr) -> Eval<Value> {
        let Quantity { value: x, nature } = self.eval_scalar(scope, base)?;
        let n = self.eval_scalar(scope, exponent)?;
        let n = whole_number(n).and_then(|n| i32::try_from(n).ok());
        let Some(n) = n.filter(|n| n.abs() <= MAX_EXPONENT) else {
            let message = format!("an exponent is a whole number up to {MAX_EXPONENT} that is known here");
            self.error(scope, Code::NotInteger, exponent.span, message)
                .help("for a square root there is `sqrt(x)`, for anything else `exp(a*ln(x))`");
            return Err(Failed);
        };
        if n < 0 && x.is_zero() {
            return Err(self.division_by_zero(scope, base.span));
        }
        let nature = Nature { dimension: nature.dimension.power(n), ..nature };
        Ok(Quantity::new(x.powi(n), nature).into())
    }

    fn chain(&mut self, scope: ScopeId, first: &'a ast::Expr, links: &'a [Link]) -> Eval<Value> {
        let operator = links.first().map_or(Operator::Add, |link| link.operator);
        match operator {
            Operator::And | Operator::Or => return self.logic(scope, first, links, operator),
            Operator::Add | Operator::Sub | Operator::Mul | Operator::Div => {}
            _ => return self.comparison(scope, first, links),
        }
        let mut left = self.eval(scope, first);
        let mut span = first.span;
        for link in links {
            // Both sides are evaluated, so that the mistakes of both are shown.
            let right = self.eval(scope, &link.operand);
            let whole = span.to(link.operand.span);
            left = match (left, right) {
                (Ok(left), Ok(right)) => self.operate(scope, whole, link, left, right),
                _ => Err(Failed),
            };
            span = whole;
        }
        left
    }

    fn operate(&mut self, scope: ScopeId, span: Span, link: &Link, left: Value, right: Value) -> Eval<Value> {
        let kinds = (left.kind(), right.kind());
        match (link.operator, left, right) {
            (Operator::Mul, Value::Scalar(a), Value::Scalar(b)) => Ok(b.times(a).into()),
            (Operator::Mul, Value::Scalar(a), Value::Vector(v))
            | (Operator::Mul, Value::Vector(v), Value::Scalar(a)) => Ok(v.times(a).into()),
            (Operator::Div, _, Value::Scalar(b)) if b.value.is_zero() => {
                Err(self.division_by_zero(scope, link.operand.span))
            }
            (Operator::Div, Value::Scalar(a), Value::Scalar(b)) => Ok(a.over(b).into()),
            (Operator::Div, Value::Vector(v), Value::Scalar(b)) => Ok(v.over(b).into()),
            (operator @ (Operator::Add | Operator::Sub), Value::Scalar(a), Value::Scalar(b)) => {
                let nature = self.joined(scope, span, a, b)?;
                Ok(Quantity::new(plus_minus(operator, a.value, b.value), nature).into())
            }
            (operator @ (Operator::Add | Operator::Sub), Value::Vector(a), Value::Vector(b)) => {
                let nature = self.joined(scope, span, a, b)?;
                Ok(Quantity::new(plus_minus(operator, a.value, b.value), nature).into())
            }
            (operator, ..) => {
                let message = format!("`{}` does not join {} and {}", operator.text(), kinds.0, kinds.1);
                let is_product = operator == Operator::Mul && kinds == ("a vector", "a vector");
                let diagnostic = self.error(scope, Code::WrongKind, span, message);
                if is_product {
                    diagnostic.help("there are `dot(u, v)` and `cross(u, v)`");
                }
                Err(Failed)
            }
        }
    }

    fn division_by_zero(&mut self, scope: ScopeId, span: Span) -> Failed {
        self.error(scope, Code::DivisionByZero, span, "this is zero, and something is divided by it");
        Failed
    }

    /// The nature of a sum, a comparison, a minimum: both sides must have one dimension.
    pub(crate) fn joined<T: Additive>(
        &mut self,
        scope: ScopeId,
        span: Span,
        a: Quantity<T>,
        b: Quantity<T>,
    ) -> Eval<Nature> {
        let (of_a, of_b) = (a.nature, b.nature);
        let reads = of_a.reads.and(of_b.reads);
        if a.is_bare_zero() {
            return Ok(Nature { reads, ..of_b });
        }
        if b.is_bare_zero() {
            return Ok(Nature { reads, ..of_a });
        }
        if of_a.dimension.same(of_b.dimension) {
            let bare_angle =
                |bare: Nature, other: Nature| bare.form == Form::Bare && other.dimension.is_angular();
            if bare_angle(of_a, of_b) || bare_angle(of_b, of_a) {
                self.error(scope, Code::MissingAngleUnit, span, "an angle and a number without a unit")
                    .help("a literal that is an angle says deg, rad or rev");
                return Err(Failed);
            }
            return Ok(of_a.joined(of_b));
        }
        let message =
            format!("{} and {} do not go together", of_a.dimension.describe(), of_b.dimension.describe());
        self.error(scope, Code::MixedDimensions, span, message);
        Err(Failed)
    }

    /// A condition.
    pub(crate) fn condition(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<(Condition, Reads)> {
        match self.eval(scope, expr)? {
            Value::Condition(condition, reads) => Ok((condition, reads)),
            other => Err(self.wrong_kind(scope, expr, "a condition", &other)),
        }
    }
}

/// Are the numbers of an expression finite? Those of its parts have been looked at.
fn is_finite(x: Expr) -> bool {
    let is_finite = |number: &Number| number.to_f64().is_finite();
    match x.node() {
        Node::Number(number) => is_finite(&number),
        Node::Sum { constant, terms } => {
            is_finite(&constant) && terms.iter().all(|(coefficient, _)| is_finite(coefficient))
        }
        _ => true,
    }
}

fn plus_minus<T: Additive>(operator: Operator, a: T, b: T) -> T {
    if operator == Operator::Sub { a - b } else { a + b }
}

/// A bare number or pair with a unit, in SI.
fn in_unit<T: Additive>(unit: &DisplayUnit, number: Quantity<T>) -> Quantity<T> {
    number.map(|number| number.each(|x| Expr::from(unit.factor) * x)).written_as(unit.dimension)
}
