//! Calls of the functions of the language.

use crate::collect::CollectVec;
use plm_cas::algebra::{Rotation, Vec2};
use plm_cas::{Expr, Number};

use crate::diag::{Code, help_similar};
use crate::model::ContactMode;
use crate::resolve::Resolver;
use crate::resolve::declarations::contact::WrittenContact;
use crate::resolve::names::unknown::function_elsewhere;
use crate::resolve::names::{RowId, ScopeId};
use crate::resolve::values::expect::text_of;
use crate::resolve::values::function_table::{FUNCTIONS, Function, Gives, Meaning, OfOne};
use crate::resolve::values::{Condition, Eval, Failed, Form, Nature, Quantity, Reads, Scalar, Value, Vector};
use crate::span::Span;
use crate::syntax::ast::{self, Ident};
use crate::units::Dimension;

impl<'a> Resolver<'a> {
    /// `function(arguments)`
    pub(crate) fn call(
        &mut self,
        scope: ScopeId,
        span: Span,
        name: &Ident,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        if let Some(function) = self.function_named(scope, &name.text) {
            return self.call_handed(scope, span, function?, arguments);
        }
        let Some(function) = Function::named(&name.text) else {
            return Err(self.unknown_function(scope, name, arguments));
        };
        self.count(scope, span, function, arguments.len())?;
        match &function.meaning {
            Meaning::OfOne(of) => self.of_one(scope, of, function.name, &arguments[0]),
            Meaning::Floor => self.floor(scope, &arguments[0]),
            Meaning::Remainder => self.remainder(scope, span, arguments),
            Meaning::OfAlike(of) => self.of_alike(scope, span, *of, arguments),
            Meaning::Atan2 => self.atan2(scope, span, arguments),
            Meaning::Table(how) => self.table(scope, span, *how, arguments),
            Meaning::Product(of) => self.vector_product(scope, *of, arguments),
            Meaning::Norm => self.norm(scope, &arguments[0]),
            Meaning::Turn => self.turned(scope, arguments),
            Meaning::Axes(to) => self.in_other_axes(scope, span, *to, arguments),
            Meaning::Rate => self.rate_of(scope, &arguments[0]),
            Meaning::Drawn => self.drawn(scope, &arguments[0]),
            Meaning::Derivative => self.derivative_of(scope, arguments),
            Meaning::Count => self.count_of(scope, &arguments[0]),
            Meaning::Reaction => self.reaction(scope, arguments),
            Meaning::Mode(mode) => self.mode(scope, *mode, &arguments[0]),
            Meaning::Inertia(numerator, denominator) => {
                self.moment_of_inertia(scope, [*numerator, *denominator], arguments)
            }
            Meaning::Section(wanted) => self.of_section(scope, *wanted, arguments),
        }
    }

    fn unknown_function(&mut self, scope: ScopeId, name: &Ident, arguments: &[ast::Expr]) -> Failed {
        let text = name.text.as_str();
        let names: Vec<&str> = FUNCTIONS.iter().map(|function| function.name).collect_vec();
        let elsewhere = function_elsewhere(text, arguments);
        let diagnostic =
            self.error(scope, Code::UnknownFunction, name.span, format!("unknown function `{text}`"));
        match elsewhere {
            Some(help) => drop(diagnostic.help(help)),
            None => help_similar(diagnostic, text, "function", "functions", &names),
        }
        Failed
    }

    fn count(&mut self, scope: ScopeId, span: Span, function: &Function, found: usize) -> Eval<()> {
        if function.arguments.contains(&found) {
            return Ok(());
        }
        let (least, most) = (function.arguments.start(), function.arguments.end());
        let wanted = if most > least { format!("{least} or more") } else { least.to_string() };
        let message = format!("`{}` takes {wanted} arguments, found {found}", function.name);
        self.error(scope, Code::WrongCount, span, message);
        Err(Failed)
    }

    /// `count(corners)`
    fn count_of(&mut self, scope: ScopeId, list: &'a ast::Expr) -> Eval<Value> {
        match self.eval(scope, list)? {
            Value::Points(count) => Ok(Quantity::new(Expr::from(count as i64), Nature::BARE).into()),
            other => Err(self.wrong_kind(scope, list, "a list of points", &other)),
        }
    }

    fn of_one(&mut self, scope: ScopeId, of: &OfOne, name: &str, argument: &'a ast::Expr) -> Eval<Value> {
        let Quantity { value: x, nature } = match of.argument {
            Some(dimension) => self.eval_quantity(scope, argument, dimension, Reads::ALL)?,
            None => self.eval_scalar(scope, argument)?,
        };
        let number = x.as_number().map(Number::to_f64);
        if let (Some(number), Some(domain)) = (number, &of.domain)
            && !(domain.holds)(number)
        {
            let message = format!("`{name}` is defined for {}, found {number}", domain.text);
            self.error(scope, Code::OutOfDomain, argument.span, message);
            return Err(Failed);
        }
        let dimension = match of.gives {
            Gives::Same => nature.dimension,
            Gives::Root => self.root(scope, argument, nature)?,
            Gives::Number => Dimension::NUMBER,
            Gives::Angle => Dimension::ANGLE,
        };
        let form = match nature.form {
            Form::Bare if dimension == Dimension::NUMBER => Form::Bare,
            Form::Written if of.gives == Gives::Same => Form::Written,
            _ => Form::Derived,
        };
        Ok(Quantity::new((of.value)(x), Nature { dimension, form, ..nature }).into())
    }

    fn root(&mut self, scope: ScopeId, argument: &ast::Expr, nature: Nature) -> Eval<Dimension> {
        nature.dimension.root().ok_or_else(|| {
            let message = format!("{} has no square root", nature.dimension.describe());
            self.error(scope, Code::WrongDimension, argument.span, message);
            Failed
        })
    }

    /// Numbers of one dimension.
    pub(crate) fn alike(
        &mut self,
        scope: ScopeId,
        span: Span,
        arguments: &'a [ast::Expr],
    ) -> Eval<(Vec<Expr>, Nature)> {
        // No iterator runs the evaluation: expressions nest deeply, and every frame takes of the stack.
        let mut found = Vec::with_capacity(arguments.len());
        for argument in arguments {
            found.push(self.eval_scalar(scope, argument));
        }
        let found = found.into_iter().collect::<Eval<Vec<Scalar>>>()?;
        let mut first = found[0];
        for other in &found[1..] {
            first.nature = self.joined(scope, span, first, *other)?;
        }
        Ok((found.iter().map(|of| of.value).collect_vec(), first.nature))
    }

    fn of_alike(
        &mut self,
        scope: ScopeId,
        span: Span,
        of: fn(&[Expr]) -> Expr,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let (x, nature) = self.alike(scope, span, arguments)?;
        Ok(Quantity::new(of(&x), nature).into())
    }

    /// `atan2(y, x)`
    fn atan2(&mut self, scope: ScopeId, span: Span, arguments: &'a [ast::Expr]) -> Eval<Value> {
        let (yx, nature) = self.alike(scope, span, arguments)?;
        Ok(Quantity::new(yx[0].atan2(yx[1]), Nature::derived(Dimension::ANGLE, nature.reads)).into())
    }

    fn vector(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<Vector> {
        match self.eval(scope, expr)? {
            Value::Vector(vector) => Ok(vector),
            other => Err(self.wrong_kind(scope, expr, "a vector", &other)),
        }
    }

    fn angle(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<Scalar> {
        self.eval_quantity(scope, expr, Dimension::ANGLE, Reads::ALL)
    }

    /// Of two vectors.
    fn vector_product(
        &mut self,
        scope: ScopeId,
        product: fn(Vec2, Vec2) -> Expr,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let (u, v) = (self.vector(scope, &arguments[0])?, self.vector(scope, &arguments[1])?);
        let dimension = u.nature.dimension.times(v.nature.dimension);
        Ok(Quantity::new(product(u.value, v.value), u.nature.scaled(v.nature, dimension)).into())
    }

    fn norm(&mut self, scope: ScopeId, vector: &'a ast::Expr) -> Eval<Value> {
        Ok(self.vector(scope, vector)?.map(|v| v.squared().sqrt()).into())
    }

    /// `turn(vector, angle)`, counter-clockwise
    fn turned(&mut self, scope: ScopeId, arguments: &'a [ast::Expr]) -> Eval<Value> {
        let (v, angle) = (self.vector(scope, &arguments[0])?, self.angle(scope, &arguments[1])?);
        let nature = v.nature.scaled(angle.nature, v.nature.dimension);
        Ok(Quantity::new(Rotation::by(angle.value) * v.value, nature).into())
    }

    /// Of a point, the origin and the angle of the relative axes.
    fn in_other_axes(
        &mut self,
        scope: ScopeId,
        span: Span,
        change: fn(Vec2, Vec2, Expr) -> Vec2,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let point = self.vector(scope, &arguments[0]);
        let origin = self.vector(scope, &arguments[1]);
        let angle = self.angle(scope, &arguments[2])?;
        let (point, origin) = (point?, origin?);
        let nature = self.joined(scope, span, point, origin)?;
        let found = change(point.value, origin.value, angle.value);
        Ok(Quantity::new(found, nature.scaled(angle.nature, nature.dimension)).into())
    }

    /// The multipliers of rows of this part.
    fn reaction(&mut self, scope: ScopeId, rows: &'a [ast::Expr]) -> Eval<Value> {
        let x = self.multiplier(scope, &rows[0]);
        let Some(second) = rows.get(1) else { return x.map(Value::Scalar) };
        let y = self.multiplier(scope, second);
        let (x, y) = (x?, y?);
        let nature = self.joined(scope, rows[0].span.to(second.span), x, y)?;
        Ok(Quantity::new(Vec2::new(x.value, y.value), nature).into())
    }

    /// The multiplier of a row. Times the row's residual it is an energy, which gives its dimension.
    fn multiplier(&mut self, scope: ScopeId, row: &'a ast::Expr) -> Eval<Scalar> {
        let (lambda, dimension, reads) = match self.lookup_row(scope, row)? {
            RowId::Constraint(row) => {
                let dimension = Dimension::TORQUE.over(self.row(row)?.dimension).plain();
                (self.unresolved.rows[row].lambda, dimension, Reads::REACTION)
            }
            RowId::Contact(contact) => {
                let dimension = self.displacement(contact)?.of_multiplier();
                let contact = &self.unresolved.contacts[contact];
                let reads = match contact.written {
                    WrittenContact::Unilateral(_) => Reads::PUSH,
                    WrittenContact::Friction(_) => Reads::FRICTION,
                };
                (contact.lambda, dimension, reads)
            }
        };
        Ok(Quantity::new(lambda, Nature::derived(dimension, reads)))
    }

    /// The condition that a row of contact is open, or sticks.
    fn mode(&mut self, scope: ScopeId, mode: ContactMode, row: &'a ast::Expr) -> Eval<Value> {
        let found = self.lookup_row(scope, row)?;
        let contact = match found {
            RowId::Contact(contact) => Some(&self.unresolved.contacts[contact]),
            RowId::Constraint(_) => None,
        };
        let fits = |is_friction: bool| is_friction == (mode == ContactMode::Sticking);
        if let Some(contact) = contact.filter(|contact| fits(contact.is_friction())) {
            let (low, high) = (Expr::from(1) / Expr::from(2), contact.mode);
            return Ok(Value::Condition(Condition::Less(low, high), Reads::MODE));
        }
        let (of, message) = match (mode, contact) {
            (ContactMode::Open, Some(_)) => ("is_sticking", "a friction is not open: it sticks or slips"),
            (ContactMode::Sticking, Some(_)) => ("is_open", "a gap does not stick: it is open or closed"),
            (_, None) => ("", "a constraint always holds: it is not open, and does not slip"),
        };
        let text = text_of(row).unwrap_or_default();
        let diagnostic = self.error(scope, Code::WrongKind, row.span, message);
        if !of.is_empty() {
            diagnostic.help(format!("write `{of}({text})`"));
        }
        Err(Failed)
    }
}
