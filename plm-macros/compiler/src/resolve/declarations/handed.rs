//! Functions and lists of points that the use of a part hands over.

use std::borrow::Cow;

use plm_cas::{Expr, algebra};

use crate::collect::CollectVec;
use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::names::Thunk;
use crate::resolve::values::expect::Wanted;
use crate::resolve::values::lazy::Lazy;
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Scalar, Value};
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind, Field, IndexedName};
use crate::units::Dimension;

/// A function that the use of a part hands over, or its default.
pub(crate) struct HandedFunction<'a> {
    declared: &'a ast::Function,
    /// Names of the arguments where the expression stands.
    arguments: Vec<&'a IndexedName>,
    thunk: Thunk<'a>,
    value: Lazy<Formula>,
}

/// The value of a function in symbols that stand for its arguments.
#[derive(Clone)]
struct Formula {
    arguments: Vec<Expr>,
    value: Scalar,
}

impl<'a> Resolver<'a> {
    /// `function lift(angle: rad): m;`, whose value the use sets by `lift(angle): …;`
    pub(crate) fn declare_function(&mut self, scope: ScopeId, declared: &'a ast::Function) {
        let Some(id) = self.names.instance(scope) else { return };
        let name = &declared.name;
        let own = || declared.arguments.iter().map(|(name, _)| name).collect_vec();
        let handed = match (self.names.field(id, &name.text), &declared.default) {
            (Some((outer, field)), _) => self.fits_arguments(outer, declared, field).then(|| {
                let wanted = Wanted::Anything;
                (field.arguments.iter().collect_vec(), Thunk { scope: outer, expr: &field.value, wanted })
            }),
            (None, Some(expr)) => Some((own(), Thunk { scope, expr, wanted: Wanted::Anything })),
            (None, None) => {
                let written = format!("{}({}): …;", name.text, names_of(&own()));
                self.missing_field(id, &name.text, &written);
                None
            }
        };
        let slot = match handed {
            Some((arguments, thunk)) => {
                let value = Lazy::Waiting;
                self.names.functions.push(HandedFunction { declared, arguments, thunk, value });
                self.names.known_slot(name.span, Value::Function(self.names.functions.len() - 1))
            }
            None => self.names.failed_slot(name.span),
        };
        self.bind(scope, name, Cow::Borrowed(&name.text), slot);
    }

    /// Has a field as many arguments as the function?
    fn fits_arguments(&mut self, scope: ScopeId, declared: &ast::Function, field: &Field) -> bool {
        let (wanted, found) = (declared.arguments.len(), field.arguments.len());
        if wanted != found {
            let own = declared.arguments.iter().map(|(name, _)| name).collect_vec();
            let name = &declared.name.text;
            let message = format!("`{name}` is a function of {wanted}, found {found}");
            self.error(scope, Code::WrongCount, field.span(), message)
                .help(format!("write `{name}({}): …;`", names_of(&own)));
        }
        wanted == found
    }

    /// `points corners: m;`, which the use sets by `corners: (0, 0), (1, 0) m;`
    pub(crate) fn declare_points(&mut self, scope: ScopeId, declared: &'a ast::Points) {
        let Some(id) = self.names.instance(scope) else { return };
        let name = &declared.name;
        let Some((outer, field)) = self.names.field(id, &name.text) else {
            self.missing_field(id, &name.text, &format!("{}: (0, 0), … {};", name.text, declared.unit.text));
            let slot = self.names.failed_slot(name.span);
            return self.bind(scope, name, Cow::Borrowed(&name.text), slot);
        };
        let wanted = Wanted::Vector(declared.unit.dimension, Reads::FIXED);
        let list = std::iter::once(&field.value).chain(&field.others);
        for (k, expr) in list.enumerate() {
            let slot = self.names.waiting_slot(name.span, Thunk { scope: outer, expr, wanted });
            self.names.checks.push(slot);
            self.bind(scope, name, Cow::Owned(format!("{}[{k}]", name.text)), slot);
        }
        let slot = self.names.known_slot(name.span, Value::Points(1 + field.others.len()));
        self.bind(scope, name, Cow::Borrowed(&name.text), slot);
    }

    fn missing_field(&mut self, id: usize, name: &str, written: &str) {
        let instance = &self.names.instances[id];
        let (kind, outer, span) = (&instance.definition.name.text, instance.outer, instance.span);
        let message = format!("`{kind}` needs a value for `{name}`");
        self.error(outer, Code::MissingValue, span, message).help(format!("write `{{ {written} }}`"));
    }

    /// The function that a name stands for in a scope; a failure if it is known that there is none.
    pub(crate) fn function_named(&self, scope: ScopeId, name: &str) -> Option<Eval<usize>> {
        let slot = self.names.find(scope, name)?;
        match self.names.slots[slot].value {
            Lazy::Known(Value::Function(function)) => Some(Ok(function)),
            Lazy::Failed => Some(Err(Failed)),
            _ => None,
        }
    }

    /// `lift(x)` of a function that was handed over.
    pub(crate) fn call_handed(
        &mut self,
        scope: ScopeId,
        span: Span,
        function: usize,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let declared = self.names.functions[function].declared;
        let (wanted, found) = (declared.arguments.len(), arguments.len());
        if wanted != found {
            let message = format!("`{}` takes {wanted} arguments, found {found}", declared.name.text);
            self.error(scope, Code::WrongCount, span, message);
            return Err(Failed);
        }
        self.applied(scope, function, arguments, 0)
    }

    /// `derivative(lift, x)`, `derivative(lift, x, 2)`: of a function by its argument, at a place.
    pub(crate) fn derivative_of(&mut self, scope: ScopeId, arguments: &'a [ast::Expr]) -> Eval<Value> {
        let function = match &arguments[0].kind {
            ExprKind::Name(name) => self.function_named(scope, &name.ident.text),
            _ => None,
        };
        let function = function.transpose()?;
        let one = |function: &usize| self.names.functions[*function].declared.arguments.len() == 1;
        let Some(function) = function.filter(one) else {
            let message = "expected a function of one argument that the part has";
            self.error(scope, Code::WrongKind, arguments[0].span, message)
                .help("the derivative with time is `rate(x)`");
            return Err(Failed);
        };
        let order = match arguments.get(2) {
            Some(order) => self.eval_int(scope, order)?,
            None => 1,
        };
        let Some(order) = u8::try_from(order).ok().filter(|order| (1..=4).contains(order)) else {
            self.error(scope, Code::NotInteger, arguments[2].span, "an order of a derivative is 1 to 4");
            return Err(Failed);
        };
        self.applied(scope, function, &arguments[1..2], order)
    }

    /// A derivative of a function, or itself, with the arguments in the places of its symbols.
    fn applied(
        &mut self,
        scope: ScopeId,
        function: usize,
        arguments: &'a [ast::Expr],
        order: u8,
    ) -> Eval<Value> {
        let formula = self.formula(function);
        let declared = self.names.functions[function].declared;
        let mut reads = Reads::NOTHING;
        let mut found = Vec::with_capacity(arguments.len());
        for (argument, (_, unit)) in arguments.iter().zip(&declared.arguments) {
            let value = self.eval_quantity(scope, argument, unit.dimension, Reads::ALL)?;
            reads = reads.and(value.nature.reads);
            found.push(value.value);
        }
        let formula = formula?;
        let by = declared.arguments.first().map_or(Dimension::NUMBER, |(_, unit)| unit.dimension);
        let dimension = declared.unit.dimension.over(by.power(order.into()));
        let value = (0..order).fold(formula.value.value, |value, _| value.diff(formula.arguments[0]));
        let pairs = formula.arguments.into_iter().zip(found).collect_vec();
        let value = algebra::substitute(&[value], &pairs)[0];
        Ok(Quantity::new(value, Nature::derived(dimension, reads.and(formula.value.nature.reads))).into())
    }

    /// The formula of a function, worked out at its first use.
    fn formula(&mut self, function: usize) -> Eval<Formula> {
        self.lazy(
            |of| &mut of.names.functions[function].value,
            |_| (),
            |of| {
                let HandedFunction { declared, arguments, thunk, .. } = &of.names.functions[function];
                let (declared, names, Thunk { scope, expr, .. }) = (*declared, arguments.clone(), *thunk);
                let inside = of.names.new_scope(Some(scope), None);
                let mut arguments = Vec::with_capacity(names.len());
                for (name, (_, unit)) in names.into_iter().zip(&declared.arguments) {
                    of.refuse_unit_name(scope, name, Some(unit.dimension));
                    let symbol = Expr::symbol(&name.ident.text);
                    let nature = Nature::derived(unit.dimension, Reads::NOTHING);
                    let slot = of.names.known_slot(name.ident.span, Quantity::new(symbol, nature).into());
                    of.bind(inside, &name.ident, Cow::Borrowed(&name.ident.text), slot);
                    arguments.push(symbol);
                }
                let value = of.eval_quantity(inside, expr, declared.unit.dimension, Reads::FIXED)?;
                Ok(Formula { arguments, value })
            },
        )
    }
}

fn names_of(names: &[&IndexedName]) -> String {
    names.iter().map(|name| name.ident.text.as_str()).collect_vec().join(", ")
}
