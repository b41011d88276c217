//! Outputs of the mechanism.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use crate::diag::Code;
use crate::model::{Name, Output};
use crate::resolve::Resolver;
use crate::resolve::names::{ScopeId, SlotId};
use crate::resolve::values::{Eval, Failed, Form, Nature, Value};
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind, IndexedName};
use crate::units::DisplayUnit;

impl<'a> Resolver<'a> {
    /// All outputs, in the order of declaration.
    pub(crate) fn evaluate_outputs(&mut self) -> Vec<Output> {
        let mut outputs: Vec<Output> = Vec::new();
        let mut names: SortedMap<String, Span> = SortedMap::new();
        for (scope, ast, docs) in std::mem::take(&mut self.unresolved.outputs) {
            let Ok(output) = self.output(scope, ast, docs) else { continue };
            let Name { text, span } = output.name.clone();
            if let Some(first) = names.get(&text) {
                self.duplicate(scope, &text, span, *first);
            } else {
                names.insert(text, span);
                outputs.push(output);
            }
        }
        outputs
    }

    fn output(&mut self, scope: ScopeId, ast: &'a ast::Output, docs: &'a [String]) -> Eval<Output> {
        let name = self.output_name(scope, ast);
        let value = self.eval(scope, &ast.value);
        let (name, value) = (name?, value?);
        let Some((components, nature)) = value.components() else {
            return Err(self.not_a_quantity(scope, &ast.value, &value));
        };
        let unit = match &ast.unit {
            Some((unit, span)) => self.shown_in(scope, *span, nature, unit)?,
            None => DisplayUnit::si(nature.dimension),
        };
        let docs = if docs.is_empty() { self.docs_of_path(scope, &ast.value) } else { one_line(docs) };
        Ok(Output { name, components, unit, declared: true, docs })
    }

    /// Documentation of an output in the definition of its part, where a path shows that.
    fn docs_of_path(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> String {
        let ExprKind::Path(base, members) = &expr.kind else { return String::new() };
        match (self.eval(scope, base), members.first()) {
            (Ok(Value::Instance(part)), Some(member)) => self.docs_of_output(part, &member.ident.text),
            _ => String::new(),
        }
    }

    /// Documentation of an output in the definition of its part, with the bodies that its arguments belong to.
    pub(crate) fn docs_of_output(&mut self, part: usize, key: &str) -> String {
        let shows = |output: &ast::Output| match (&output.name, &output.value.kind) {
            (Some(name), _) | (None, ExprKind::Name(name)) => name.ident.text == key,
            _ => false,
        };
        let items = &self.names.instances[part].definition.items;
        let item = items
            .iter()
            .find(|item| matches!(&item.kind, ast::ItemKind::Output(list) if list.iter().any(shows)));
        let docs = item.map_or_else(String::new, |item| one_line(&item.docs));
        let (inside, span) = (self.names.instances[part].scope, self.names.instances[part].span);
        let names = self.names.instances[part]
            .definition
            .arguments
            .iter()
            .map(|argument| argument.name.text.as_str());
        let arguments: Vec<(&str, SlotId)> =
            names.zip(self.names.instances[part].arguments.iter().copied()).collect_vec();
        let mut words = docs.split('`');
        let mut told = words.next().unwrap_or_default().to_owned();
        // Code and prose by turns.
        while let Some(word) = words.next() {
            let slot = arguments.iter().find(|(argument, _)| *argument == word).map(|(_, slot)| *slot);
            let frame = slot.and_then(|slot| match self.slot_value(slot, inside, span) {
                Ok(Value::Frame(frame)) => Some(self.name_of_port(frame)),
                _ => None,
            });
            let of_body = told.strip_suffix("the body of ").map(str::to_owned);
            let name = match (frame, of_body) {
                (Some(port), Some(before)) => {
                    told = before;
                    port.rsplit_once('.').map_or(String::new(), |(body, _)| body.to_owned())
                }
                (Some(port), None) => port,
                (None, _) => word.to_owned(),
            };
            told += &["`", &name, "`", words.next().unwrap_or_default()].concat();
        }
        told
    }

    fn not_a_quantity(&mut self, scope: ScopeId, expr: &ast::Expr, found: &Value) -> Failed {
        let what = match found {
            Value::Instance(_) => "one of its outputs".to_string(),
            Value::Body(_) | Value::Frame(_) => "one of its members, `position` or `angle`".to_string(),
            Value::Node(node) => format!("one of its members: {}", self.members_of_node(*node).join(", ")),
            _ => "a quantity".to_string(),
        };
        let message = format!("an output is a number or a vector, found {}", found.kind());
        self.error(scope, Code::WrongKind, expr.span, message).help(format!("name {what}"));
        Failed
    }

    /// The unit must fit; an angle that was worked out may be shown in degrees though its radian has cancelled.
    fn shown_in(
        &mut self,
        scope: ScopeId,
        span: Span,
        Nature { dimension, form, .. }: Nature,
        unit: &DisplayUnit,
    ) -> Eval<DisplayUnit> {
        let fits = dimension.same(unit.dimension)
            && (dimension.rad == unit.dimension.rad || form != Form::Written || !dimension.is_angular());
        if fits {
            return Ok(unit.clone());
        }
        let message = format!("this is {}, which is not shown in {}", dimension.describe(), unit.text);
        self.error(scope, Code::WrongDimension, span, message);
        Err(Failed)
    }

    /// The name as written: `tip = …`, or the path of what is shown.
    fn output_name(&mut self, scope: ScopeId, ast: &'a ast::Output) -> Eval<Name> {
        if let Some(name) = &ast.name {
            let text = self.key(scope, name)?.to_string();
            return Ok(Name { text, span: name.ident.span });
        }
        let span = ast.value.span;
        let text = match &ast.value.kind {
            ExprKind::Name(name) => Some(self.key(scope, name)?.to_string()),
            ExprKind::Path(base, members) => self.path_text(scope, base, members)?,
            _ => None,
        };
        let Some(text) = text else {
            self.error(scope, Code::UnexpectedToken, span, "an expression needs a name to be an output")
                .help("write `output name = …;`");
            return Err(Failed);
        };
        Ok(Name { text, span })
    }

    fn path_text(
        &mut self,
        scope: ScopeId,
        base: &'a ast::Expr,
        members: &'a [IndexedName],
    ) -> Eval<Option<String>> {
        let ExprKind::Name(base) = &base.kind else { return Ok(None) };
        let mut text = self.key(scope, base)?.to_string();
        for member in members {
            text.push('.');
            text.push_str(&self.key(scope, member)?);
        }
        Ok(Some(text))
    }
}

fn one_line(docs: &[String]) -> String {
    docs.iter().map(|line| line.trim()).collect_vec().join(" ")
}
