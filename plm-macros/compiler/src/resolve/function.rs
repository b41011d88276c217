//! The functions of the language.

use plm_cas::algebra::{Rotation, Vec2};
use plm_cas::{Expr, Number};

use super::Resolver;
use super::names::ScopeId;
use super::shape;
use super::unknown::function_elsewhere;
use super::value::{Eval, Failed, Form, Nature, Reads, Value};
use crate::diag::{Code, help_similar};
use crate::span::Span;
use crate::syntax::ast::{self, Ident};
use crate::units::Dimension;

/// Names and numbers of arguments; `usize::MAX` is any number.
const FUNCTIONS: &[(&str, usize, usize)] = &[
    ("abs", 1, 1),
    ("sign", 1, 1),
    ("min", 2, usize::MAX),
    ("max", 2, usize::MAX),
    ("clamp", 3, 3),
    ("sqrt", 1, 1),
    ("exp", 1, 1),
    ("ln", 1, 1),
    ("sin", 1, 1),
    ("cos", 1, 1),
    ("tan", 1, 1),
    ("asin", 1, 1),
    ("acos", 1, 1),
    ("atan2", 2, 2),
    ("table", 3, usize::MAX),
    ("smooth_table", 3, usize::MAX),
    ("dot", 2, 2),
    ("cross", 2, 2),
    ("norm", 1, 1),
    ("turn", 2, 2),
    ("to_absolute", 3, 3),
    ("to_relative", 3, 3),
    ("rate", 1, 1),
    ("reaction", 1, 2),
    ("rod", 2, 2),
    ("disc", 2, 2),
    ("hollow_cylinder", 3, 3),
    ("thin_cylinder", 2, 2),
    ("plate", 3, 3),
    ("sphere", 2, 2),
    ("thin_sphere", 2, 2),
];

impl<'a> Resolver<'a> {
    pub(super) fn call(
        &mut self,
        scope: ScopeId,
        span: Span,
        function: &Ident,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let name = function.text.as_str();
        let Some((_, least, most)) = FUNCTIONS.iter().find(|(known, ..)| *known == name) else {
            let names: Vec<&str> = FUNCTIONS.iter().map(|(name, ..)| *name).collect();
            let elsewhere = function_elsewhere(name, arguments);
            let diagnostic =
                self.error(scope, Code::UnknownFunction, function.span, format!("unknown function `{name}`"));
            match elsewhere {
                Some(help) => drop(diagnostic.help(help)),
                None => help_similar(diagnostic, name, "function", "functions", &names),
            }
            return Err(Failed);
        };
        if !(*least..=*most).contains(&arguments.len()) {
            let wanted = if most > least { format!("{least} or more") } else { least.to_string() };
            let message = format!("`{name}` takes {wanted} arguments, found {}", arguments.len());
            self.error(scope, Code::WrongCount, span, message);
            return Err(Failed);
        }
        match name {
            "dot" | "cross" => self.vector_product(scope, name, arguments),
            "norm" => self.norm(scope, &arguments[0]),
            "turn" => self.turn(scope, &arguments[0], &arguments[1]),
            "to_absolute" | "to_relative" => self.in_other_axes(scope, span, name, arguments),
            "table" | "smooth_table" => self.table(scope, span, name, arguments),
            "rate" => self.rate_of(scope, &arguments[0]),
            "reaction" => self.reaction(scope, arguments),
            "min" | "max" | "clamp" | "atan2" => self.of_one_dimension(scope, span, name, arguments),
            _ => match shape::named(name) {
                Some(shape) => self.moment_of_inertia(scope, shape, arguments),
                None => self.of_one_argument(scope, name, &arguments[0]),
            },
        }
    }

    fn of_one_argument(&mut self, scope: ScopeId, name: &str, argument: &'a ast::Expr) -> Eval<Value> {
        let wanted = match name {
            "sin" | "cos" | "tan" => Some(Dimension::ANGLE),
            "exp" | "ln" | "asin" | "acos" => Some(Dimension::NUMBER),
            _ => None,
        };
        let (x, nature) = match wanted {
            Some(dimension) => self.eval_quantity(scope, argument, dimension, Reads::ALL)?,
            None => self.eval_scalar(scope, argument)?,
        };
        self.domain(scope, name, argument, x)?;
        let dimension = match name {
            "abs" => nature.dimension,
            "asin" | "acos" => Dimension::ANGLE,
            "sqrt" => self.root(scope, argument, nature)?,
            _ => Dimension::NUMBER,
        };
        let form = match nature.form {
            Form::Bare if dimension == Dimension::NUMBER => Form::Bare,
            Form::Written if name == "abs" => Form::Written,
            _ => Form::Derived,
        };
        Ok(Value::Scalar(function_of_one(name, x), Nature { dimension, form, ..nature }))
    }

    fn root(&mut self, scope: ScopeId, argument: &ast::Expr, nature: Nature) -> Eval<Dimension> {
        nature.dimension.root().ok_or_else(|| {
            let message = format!("{} has no square root", nature.dimension.describe());
            self.error(scope, Code::WrongDimension, argument.span, message);
            Failed
        })
    }

    fn domain(&mut self, scope: ScopeId, name: &str, argument: &ast::Expr, x: Expr) -> Eval<()> {
        let Some(value) = x.as_number().map(Number::to_f64) else { return Ok(()) };
        let (inside, domain) = match name {
            "sqrt" => (value >= 0.0, "0 and above"),
            "ln" => (value > 0.0, "above 0"),
            "asin" | "acos" => (value.abs() <= 1.0, "-1 to 1"),
            _ => return Ok(()),
        };
        if inside {
            return Ok(());
        }
        let message = format!("`{name}` is defined for {domain}, found {value}");
        self.error(scope, Code::OutOfDomain, argument.span, message);
        Err(Failed)
    }

    /// Functions whose arguments have one dimension.
    fn of_one_dimension(
        &mut self,
        scope: ScopeId,
        span: Span,
        name: &str,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let mut found = Vec::with_capacity(arguments.len());
        for argument in arguments {
            found.push(self.eval_scalar(scope, argument));
        }
        let found = found.into_iter().collect::<Eval<Vec<(Expr, Nature)>>>()?;
        let (first, mut nature) = found[0];
        for (x, of_x) in &found[1..] {
            nature = self.joined(scope, span, (&[first], nature), (&[*x], *of_x))?;
        }
        let rest = found[1..].iter().map(|(x, _)| *x);
        Ok(match name {
            "clamp" => Value::Scalar(first.clamp(found[1].0, found[2].0), nature),
            "atan2" => {
                let nature = Nature::derived(Dimension::ANGLE, nature.reads);
                Value::Scalar(first.atan2(found[1].0), nature)
            }
            "min" => Value::Scalar(rest.fold(first, Expr::min), nature),
            _ => Value::Scalar(rest.fold(first, Expr::max), nature),
        })
    }

    fn vector(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<(Vec2, Nature)> {
        match self.eval(scope, expr)? {
            Value::Vector(vector, nature) => Ok((vector, nature)),
            other => Err(self.wrong_kind(scope, expr, "a vector", &other)),
        }
    }

    /// `dot(u, v) = ux vx + uy vy`, `cross(u, v) = ux vy - uy vx`
    fn vector_product(&mut self, scope: ScopeId, name: &str, arguments: &'a [ast::Expr]) -> Eval<Value> {
        let (u, of_u) = self.vector(scope, &arguments[0])?;
        let (v, of_v) = self.vector(scope, &arguments[1])?;
        let product = if name == "dot" { u.dot(v) } else { u.cross(v) };
        Ok(Value::Scalar(product, of_u.scaled(of_v, of_u.dimension.times(of_v.dimension))))
    }

    fn norm(&mut self, scope: ScopeId, argument: &'a ast::Expr) -> Eval<Value> {
        let (v, nature) = self.vector(scope, argument)?;
        Ok(Value::Scalar(v.squared().sqrt(), nature))
    }

    /// The vector turned by an angle, counter-clockwise.
    fn turn(&mut self, scope: ScopeId, vector: &'a ast::Expr, angle: &'a ast::Expr) -> Eval<Value> {
        let (v, of_v) = self.vector(scope, vector)?;
        let (by, of_angle) = self.eval_quantity(scope, angle, Dimension::ANGLE, Reads::ALL)?;
        Ok(Value::Vector(Rotation::by(by) * v, of_v.scaled(of_angle, of_v.dimension)))
    }

    /// A point given in relative axes in the absolute ones, or the other way: `(point, origin, angle)`, where origin and
    /// angle (counter-clockwise) are those of the relative axes in the absolute ones. The manual's PLMCALCUL, section 4.8.
    fn in_other_axes(
        &mut self,
        scope: ScopeId,
        span: Span,
        name: &str,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let point = self.vector(scope, &arguments[0]);
        let origin = self.vector(scope, &arguments[1]);
        let (angle, of_angle) = self.eval_quantity(scope, &arguments[2], Dimension::ANGLE, Reads::ALL)?;
        let ((point, of_point), (origin, of_origin)) = (point?, origin?);
        let nature =
            self.joined(scope, span, (&point.components(), of_point), (&origin.components(), of_origin))?;
        let found = if name == "to_absolute" {
            origin + Rotation::by(angle) * point
        } else {
            let arm = point - origin;
            Rotation::by(-angle) * arm
        };
        Ok(Value::Vector(found, nature.scaled(of_angle, nature.dimension)))
    }

    /// The multipliers of constraint rows of this part.
    fn reaction(&mut self, scope: ScopeId, arguments: &'a [ast::Expr]) -> Eval<Value> {
        let first = self.multiplier(scope, &arguments[0]);
        let Some(second) = arguments.get(1) else {
            return first.map(|(lambda, nature)| Value::Scalar(lambda, nature));
        };
        let second = self.multiplier(scope, second);
        let (first, second) = (first?, second?);
        let span = arguments[0].span.to(arguments[1].span);
        let nature = self.joined(scope, span, (&[first.0], first.1), (&[second.0], second.1))?;
        Ok(Value::Vector(Vec2::new(first.0, second.0), nature))
    }

    /// A multiplier times its residual is an energy: that gives its dimension.
    fn multiplier(&mut self, scope: ScopeId, row: &'a ast::Expr) -> Eval<(Expr, Nature)> {
        let row = self.lookup_row(scope, row)?;
        let dimension = self.row(row)?.dimension;
        let dimension = Dimension::TORQUE.over(dimension).plain();
        Ok((self.draft.rows[row].lambda, Nature::derived(dimension, Reads::REACTION)))
    }
}

fn function_of_one(name: &str, x: Expr) -> Expr {
    match name {
        "abs" => x.abs(),
        "sign" => x.sign(),
        "sqrt" => x.sqrt(),
        "exp" => x.exp(),
        "ln" => x.ln(),
        "sin" => x.sin(),
        "cos" => x.cos(),
        "tan" => x.tan(),
        "asin" => x.asin(),
        _ => x.acos(),
    }
}
