//! Parts in use.

use crate::collect::{CollectVec, MapEach};
use std::borrow::Cow;

use crate::diag::{Code, Use};
use crate::model::{Declared, FrameRef, Name, Pair, Part};
use crate::resolve::Resolver;
use crate::resolve::names::{ScopeId, SlotId, Thunk};
use crate::resolve::values::expect::Wanted;
use crate::resolve::values::{Reads, Value};
use crate::span::Span;
use crate::syntax::ast::{self, Definition, Field, Instance, ItemKind};
use crate::units::DisplayUnit;

/// Parts may contain parts this deeply.
const MAX_DEPTH: usize = 32;

/// Parts of one dimension that are looked for between two points, and those that stand there.
const BETWEEN_POINTS: &[(&str, &str)] = &[("cylinder", "jack")];

/// So many parts may be in use, with all that they contain: a few lines can ask for 2^32.
const MAX_INSTANCES: usize = 1 << 14;

/// A part in use.
pub(crate) struct PartInUse<'a> {
    pub(crate) definition: &'a Definition,
    pub(crate) ast: &'a Instance,
    /// Full path, `arm.spring`.
    pub(crate) name: String,
    /// The name, where it is used.
    pub(crate) span: Span,
    /// Its inside.
    pub(crate) scope: ScopeId,
    /// The scope that uses it.
    pub(crate) outer: ScopeId,
    /// Its name in the scope that uses it.
    pub(crate) key: String,
    /// Fields of its use, by path.
    pub(crate) fields: Vec<(String, &'a Field)>,
    /// The part of the mechanism that it is, or belongs to.
    pub(crate) part: usize,
    /// Is it that part itself?
    is_part: bool,
    pub(crate) arguments: Vec<SlotId>,
}

impl PartInUse<'_> {
    /// The kinematic pair that it is.
    pub(crate) fn pair(&self, parts: &[Part]) -> Option<Pair> {
        parts.get(self.part).filter(|_| self.is_part).and_then(|part| part.pair)
    }

    /// As one of the uses that lead to a place inside it.
    pub(crate) fn as_use(&self) -> Use {
        Use { span: self.span, instance: self.name.clone(), part: self.definition.name.text.clone() }
    }
}

impl<'a> Resolver<'a> {
    pub(crate) fn declare_instance(&mut self, scope: ScopeId, ast: &'a Instance, part: Option<usize>) {
        if self.needs_index(scope, &ast.name) {
            return;
        }
        let Ok(key) = self.key(scope, &ast.name) else { return };
        let Some(definition) = self.library.get(&ast.kind.text) else {
            self.unknown_part(scope, ast);
            // What reads it has been told already.
            let slot = self.names.failed_slot(ast.name.ident.span);
            self.bind(scope, &ast.name.ident, key, slot);
            return;
        };
        if !self.may_contain(scope, ast, definition) {
            return;
        }
        let name = format!("{}{key}", self.names.prefix(scope));
        let span = ast.name.ident.span;
        let id = self.names.instances.len();
        let stated = self.pair_of(definition);
        let pair = stated.map(|(pair, _)| pair);
        // A joint inside a part is walked through like any other.
        let is_part = part.is_none() || pair.is_some();
        let index = match part {
            Some(part) if !is_part => part,
            _ => {
                let span = part.map_or(span, |part| self.unresolved.parts[part].name.span);
                self.new_part(&name, span, definition, pair)
            }
        };
        let fields = self.fields_of(scope, ast);
        let inside = self.names.new_scope(None, Some(id));
        let ground = self.names.known_slot(span, Value::Body(None));
        self.names.scopes[inside].names.insert("ground".into(), ground);
        self.names.instances.push(PartInUse {
            definition,
            ast,
            name,
            span,
            scope: inside,
            outer: scope,
            key: key.to_string(),
            fields,
            part: index,
            is_part,
            arguments: Vec::new(),
        });
        let slot = self.names.known_slot(span, Value::Instance(id));
        self.bind(scope, &ast.name.ident, key, slot);
        self.bind_arguments(id, inside);
        self.check_fields(id);
        self.ask_for_branch(id);
        if let Some((_, span)) = stated {
            self.unresolved.parts[index].declared = Some(Declared { span, uses: self.names.uses(inside) });
        }
        self.declare(&definition.items, inside, Some(index));
        self.refuse_left_out(id);
        self.check_outputs(definition, inside);
    }

    /// A part must not contain itself, nor nest without bound.
    fn may_contain(&mut self, scope: ScopeId, ast: &Instance, definition: &'a Definition) -> bool {
        let is_it = |part: usize| std::ptr::eq(self.names.instances[part].definition, definition);
        if self.names.around(scope).any(is_it) {
            let message = format!("the part `{}` contains itself", definition.name.text);
            self.error(scope, Code::Cycle, ast.kind.span, message);
            return false;
        }
        let depth = self.names.around(scope).count();
        if depth >= MAX_DEPTH {
            let message = format!("more than {MAX_DEPTH} parts, one inside the other");
            self.error(scope, Code::TooDeep, ast.kind.span, message);
        }
        let too_many = self.names.instances.len() >= MAX_INSTANCES;
        if too_many && !std::mem::replace(&mut self.unresolved.too_many, true) {
            let message = format!("more than {MAX_INSTANCES} parts in all");
            self.error(scope, Code::TooMany, ast.kind.span, message);
        }
        depth < MAX_DEPTH && !too_many
    }

    /// The kinematic pair that a definition states, and where.
    fn pair_of(&mut self, definition: &'a Definition) -> Option<(Pair, Span)> {
        let pair = definition.items.iter().find_map(|item| match &item.kind {
            ItemKind::Pair(pair) => Some(pair),
            _ => None,
        })?;
        let known = Pair::named(&pair.text);
        if known.is_none() {
            self.unknown_option(0, &pair.text, pair.span, &Pair::ALL.map_each(Pair::name));
        }
        known.map(|known| (known, pair.span))
    }

    fn new_part(&mut self, name: &str, span: Span, definition: &Definition, pair: Option<Pair>) -> usize {
        let name = Name { text: name.to_string(), span };
        let kind = definition.name.text.clone();
        self.unresolved.parts.push(Part {
            name,
            kind,
            pair,
            declared: None,
            frames: Vec::new(),
            branch: None,
        });
        self.unresolved.parts.len() - 1
    }

    fn bind_arguments(&mut self, id: usize, inside: ScopeId) {
        let (definition, ast, outer) = {
            let instance = &self.names.instances[id];
            (instance.definition, instance.ast, instance.outer)
        };
        let (wanted, found) = (definition.arguments.len(), ast.arguments.len());
        let is_read = !ast.arguments.iter().any(|of| matches!(of.kind, ast::ExprKind::Unknown));
        if wanted != found && is_read {
            let names: Vec<&str> = definition.arguments.iter().map(|of| of.name.text.as_str()).collect_vec();
            let message = format!("`{}` joins {wanted} ports, found {found}", definition.name.text);
            let between = BETWEEN_POINTS.iter().find(|(kind, _)| *kind == definition.name.text && found == 2);
            let diagnostic = self.error(outer, Code::WrongCount, ast.name.ident.span, message);
            diagnostic.note(format!("its ports: {}", names.join(", ")));
            if let Some((_, meant)) = between {
                diagnostic.help(format!("between points of two bodies stands a `{meant}`"));
            }
        }
        for (k, argument) in definition.arguments.iter().enumerate() {
            let wanted = self.wanted_at(inside, &argument.kind).unwrap_or(Wanted::Anything);
            let slot = match ast.arguments.get(k) {
                Some(expr) => {
                    self.names.waiting_slot(argument.name.span, Thunk { scope: outer, expr, wanted })
                }
                None => self.names.failed_slot(argument.name.span),
            };
            self.names.instances[id].arguments.push(slot);
            self.bind(inside, &argument.name, Cow::Borrowed(&argument.name.text), slot);
        }
    }

    /// The value of a param or an input of a part: as the use sets it, else its default.
    pub(crate) fn field_slot(
        &mut self,
        id: usize,
        inside: ScopeId,
        ast: &'a ast::Value,
        unit: &DisplayUnit,
        kind: Reads,
    ) -> SlotId {
        let name = &ast.name.ident;
        let reads = if kind == Reads::PARAM { Reads::FIXED } else { Reads::ALL };
        let wanted = Wanted::Number(unit.dimension, reads);
        let thunk = match (self.names.field(id, &name.text), &ast.value) {
            (Some((scope, field)), _) => Thunk { scope, expr: &field.value, wanted },
            (None, Some(expr)) => Thunk { scope: inside, expr, wanted },
            (None, None) => {
                let (kind, outer) =
                    (self.names.instances[id].definition.name.text.clone(), self.names.instances[id].outer);
                let message = format!("`{kind}` needs a value for `{}`", name.text);
                let help = format!("write `{{ {}: … }}` with {}", name.text, unit.dimension.describe());
                self.error(outer, Code::MissingValue, self.names.instances[id].span, message).help(help);
                return self.names.failed_slot(name.span);
            }
        };
        let slot = self.names.waiting_slot(name.span, thunk);
        self.names.checks.push(slot);
        slot
    }

    pub(crate) fn declare_choice(&mut self, scope: ScopeId, choice: &'a ast::Choice) {
        let Some(id) = self.names.instance(scope) else { return };
        let options: Vec<&'a str> = choice.options.iter().map(|option| option.text.as_str()).collect_vec();
        let chosen = match (self.names.field(id, &choice.name.text), &choice.default) {
            (Some((outer, Field { value: expr, .. })), _) => {
                if let ast::ExprKind::Name(name) = &expr.kind {
                    Some((outer, &name.ident))
                } else {
                    let message = format!("expected one of {}", options.join(", "));
                    self.error(outer, Code::UnknownOption, expr.span, message);
                    None
                }
            }
            (None, Some(default)) => Some((scope, default)),
            (None, None) => {
                let (span, outer) = (self.names.instances[id].span, self.names.instances[id].outer);
                let message = format!("a choice is missing: `{}`", choice.name.text);
                self.error(outer, Code::MissingValue, span, message)
                    .note(format!("options: {}", options.join(", ")));
                None
            }
        };
        let chosen = chosen.and_then(|(scope, ident)| {
            let known = options.contains(&ident.text.as_str());
            if !known {
                self.unknown_option(scope, &ident.text, ident.span, &options);
            }
            known.then_some(ident.text.as_str())
        });
        let slot = match chosen {
            Some(chosen) => {
                self.names.choices.push((chosen, options));
                self.names.known_slot(choice.name.span, Value::Choice(self.names.choices.len() - 1))
            }
            None => self.names.failed_slot(choice.name.span),
        };
        self.bind(scope, &choice.name, Cow::Borrowed(&choice.name.text), slot);
    }

    /// Outputs that nothing reads cost nothing, but mistakes in them count: once for each part of the user's own.
    fn check_outputs(&mut self, definition: &'a Definition, inside: ScopeId) {
        let is_own = definition.name.span.source == 0;
        if is_own && self.names.checked.insert(&definition.name.text) {
            self.names.checks.extend(self.names.scopes[inside].outputs.values());
        }
    }

    /// Evaluates what a part is connected to. A joint must join two different bodies.
    pub(crate) fn connect(&mut self, id: usize) {
        let (arguments, outer) = (self.names.instances[id].arguments.clone(), self.names.instances[id].outer);
        let mut frames: Vec<FrameRef> = Vec::new();
        for slot in arguments {
            let span = self.names.slots[slot].span;
            if let Ok(Value::Frame(frame)) = self.slot_value(slot, outer, span) {
                self.unresolved.port(frame).used = true;
                frames.push(frame);
            }
        }
        let instance = &self.names.instances[id];
        let joins_itself = frames.len() > 1 && frames.iter().all(|frame| frame.body == frames[0].body);
        if instance.definition.is_joint && joins_itself {
            let (name, kind, span) = (&instance.name, &instance.definition.name.text, instance.span);
            let body = frames[0].body.map_or("ground", |body| &self.unresolved.bodies[body].name.text);
            let message = format!("the {kind} joint `{name}` joins `{body}` with itself");
            self.error(outer, Code::SelfJoint, span, message);
        }
        let (part, is_part) = (self.names.instances[id].part, self.names.instances[id].is_part);
        if is_part {
            self.unresolved.parts[part].frames = frames;
        }
    }
}
