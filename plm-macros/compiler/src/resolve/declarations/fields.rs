//! Fields of the use of a part: parameters, inputs, choices, starts of states and requirements, also of the parts that it
//! contains.

use crate::collect::{CollectVec, PushAll};
use crate::diag::{Code, help_similar, nearest};
use crate::resolve::Resolver;
use crate::resolve::declarations::branch::{BRANCH, tells_branches};
use crate::resolve::finalise::compliance::WORDS;
use crate::resolve::finalise::release::WHEN;
use crate::resolve::names::{Names, ScopeId};
use crate::syntax::ast::{Definition, Field, Instance, Item, ItemKind, all_items};

impl<'a> Names<'a> {
    /// The field that the uses around a part set for a name inside it. The outermost has the last word.
    pub(crate) fn field(&self, part: usize, name: &str) -> Option<(ScopeId, &'a Field)> {
        let mut path = name.to_string();
        let mut found = None;
        for part in std::iter::once(part).chain(self.around(self.instances[part].outer)) {
            let part = &self.instances[part];
            let here = part.fields.iter().find(|(of, _)| *of == path);
            found = here.map(|(_, field)| (part.outer, *field)).or(found);
            path = format!("{}.{path}", part.key);
        }
        found
    }

    /// The field that the use of a joint sets for a word of the language, unless its definition has a parameter of that name.
    pub(crate) fn word(&self, joint: usize, word: &str) -> Option<(ScopeId, &'a Field)> {
        let definition = self.instances[joint].definition;
        let is_parameter = all_items(&definition.items).any(|item| field_name(&item.kind) == Some(word));
        if definition.is_joint && !is_parameter { self.field(joint, word) } else { None }
    }
}

impl<'a> Resolver<'a> {
    /// The fields of a use with their paths as text.
    pub(crate) fn fields_of(&mut self, scope: ScopeId, ast: &'a Instance) -> Vec<(String, &'a Field)> {
        let mut fields = Vec::with_capacity(ast.fields.len());
        for field in &ast.fields {
            let keys: Vec<_> = field.path.iter().map(|name| self.key(scope, name)).collect_vec();
            if let Ok(keys) = keys.into_iter().collect::<Result<Vec<_>, _>>() {
                fields.push((keys.join("."), field));
            }
        }
        fields
    }

    /// Every field that is set must exist, and be set once.
    pub(crate) fn check_fields(&mut self, id: usize) {
        let outer = self.names.instances[id].outer;
        let fields = self.names.instances[id].fields.clone();
        for (k, (path, field)) in fields.iter().enumerate() {
            self.check_field(id, path, field);
            if let Some((_, first)) = fields[..k].iter().find(|(before, _)| before == path) {
                let first = first.span();
                self.error(outer, Code::RepeatedItem, field.span(), format!("`{path}` is set twice"))
                    .note_at(first, "it is set first here");
            }
        }
    }

    fn check_field(&mut self, id: usize, path: &str, field: &'a Field) {
        let Some((last, parts)) = field.path.split_last() else { return };
        let (mut definition, outer) = (self.names.instances[id].definition, self.names.instances[id].outer);
        for part in parts {
            let inner = part_named(&definition.items, &part.ident.text);
            let Some(inner) = inner.and_then(|kind| self.library.get(kind)) else {
                let (name, text) = (&definition.name.text, &part.ident.text);
                let message = format!("the part `{name}` contains no `{text}`");
                let known = part_names(&definition.items);
                let diagnostic = self.error(outer, Code::UnknownField, part.ident.span, message);
                help_similar(diagnostic, text, "part", "parts inside", &known);
                return;
            };
            definition = inner;
        }
        let text = last.ident.text.as_str();
        let required = requirements(&definition.items);
        let mut known: Vec<&str> =
            all_items(&definition.items).filter_map(|item| field_name(&item.kind)).collect_vec();
        if definition.is_joint {
            known.push_all(WORDS);
            known.push(WHEN);
        }
        if tells_branches(definition) {
            known.push(BRANCH);
        }
        if required.contains(&text) && !known.contains(&text) {
            let name = format!("{}.{path}", self.names.instances[id].name);
            self.switch_requirement(outer, name, field);
        }
        if !known.contains(&text) && !required.contains(&text) {
            let message = format!("the part `{}` has no `{text}` to set", definition.name.text);
            let diagnostic = self.error(outer, Code::UnknownField, last.ident.span, message);
            let meant = ELSEWHERE.iter().find(|(word, here)| *word == text && known.contains(here));
            let instead = INSTEAD.iter().find(|(words, _)| definition.is_joint && words.contains(&text));
            match (meant, instead) {
                (Some((_, here)), _) => {
                    diagnostic.help(format!("write `{here}: …`"));
                }
                (None, Some((_, how))) => {
                    diagnostic.help(*how);
                }
                (None, None) if text == WHEN => {
                    diagnostic.help(NO_JOINT_LETS_GO);
                }
                (None, None) if nearest(text, required.iter().copied()).is_some() => {
                    help_similar(diagnostic, text, "requirement", "requirements", &required);
                }
                (None, None) => help_similar(diagnostic, text, "parameter", "parameters", &known),
            }
        } else if let Some(span) = field.locked.filter(|_| !is_state(&definition.items, text)) {
            self.error(
                outer,
                Code::MisplacedItem,
                span,
                format!("`{text}` is no state, and cannot be locked"),
            );
        } else {
            self.check_form(outer, definition, field, text);
        }
    }

    /// Arguments stand after the name of a function alone, and lists are points.
    fn check_form(&mut self, outer: ScopeId, definition: &Definition, field: &Field, text: &str) {
        let is_it = |item: &&Item| field_name(&item.kind) == Some(text);
        let kind = definition.items.iter().find(is_it).map(|item| &item.kind);
        let first = field.arguments.first().map(|name| name.ident.span);
        if let Some(span) = first.filter(|_| !matches!(kind, Some(ItemKind::Function(_)))) {
            let message = format!("`{text}` is no function, and has no argument");
            self.error(outer, Code::UnexpectedToken, span, message).help(format!("write `{text}: …;`"));
        }
        if let Some(other) = field.others.first().filter(|_| !matches!(kind, Some(ItemKind::Points(_)))) {
            let message = format!("`{text}` is one value, found a list");
            self.error(outer, Code::UnexpectedToken, other.span, message);
        }
    }
}

/// Parameters by the names that they have elsewhere.
const ELSEWHERE: &[(&str, &str)] = &[
    ("k", "stiffness"),
    ("c", "damping"),
    ("d", "damping"),
    ("length", "free_length"),
    ("l0", "free_length"),
    ("rest_length", "free_length"),
    ("rest", "free_angle"),
    ("fx", "x"),
    ("fy", "y"),
    ("moment", "torque"),
    ("tau", "torque"),
];

/// Help for a `when` in the use of a part that is no joint.
const NO_JOINT_LETS_GO: &str = "joints and rows of your own take a `when`; of another part a parameter changes by a condition, \
                                `if t < 1 s then 10 N/m else 0 N/m`";

/// Fields of joints in other programs, and how they are written here.
const INSTEAD: &[(&[&str], &str)] = &[
    (
        &["limits", "limit", "stop", "stops", "range", "min", "max", "lower", "upper"],
        "a joint is limited by `lower_limit` and `upper_limit`, rigid with a `restitution` or with a `limit_stiffness`; of a joint of your own \
         it is a row, `unilateral name: b.angle <= 90 deg;`",
    ),
    (
        &["friction", "coulomb", "mu", "dry_friction"],
        "a coefficient of friction is the `friction` of revolute, prismatic and pin_slot; elsewhere it is a row, \
         `friction name: rate(b.angle) within 1 N*m;`",
    ),
    (
        &["motor", "speed", "velocity", "omega", "angle", "position", "displacement"],
        "a motion that is prescribed is a row, `constraint name: body.angle = 2 rad/s*t;`, and where a body begins is its `start`",
    ),
];

/// The kind of the part of a name among items.
fn part_named<'a>(items: &'a [Item], name: &str) -> Option<&'a str> {
    all_items(items).find_map(|item| match &item.kind {
        ItemKind::Instance(instance) if instance.name.ident.text == name => Some(instance.kind.text.as_str()),
        _ => None,
    })
}

/// Names of the parts among items.
fn part_names(items: &[Item]) -> Vec<&str> {
    let names = all_items(items).filter_map(|item| match &item.kind {
        ItemKind::Instance(instance) => Some(instance.name.ident.text.as_str()),
        _ => None,
    });
    names.collect_vec()
}

/// Names of the requirements among items.
fn requirements(items: &[Item]) -> Vec<&str> {
    let names = all_items(items).filter_map(|item| match &item.kind {
        ItemKind::Require(name, _) => Some(name.ident.text.as_str()),
        _ => None,
    });
    names.collect_vec()
}

/// The name of what the use of a part can set by a value.
pub(crate) fn field_name(item: &ItemKind) -> Option<&str> {
    match item {
        ItemKind::Param(value)
        | ItemKind::Input(value)
        | ItemKind::State(value)
        | ItemKind::Discrete(value) => Some(&value.name.ident.text),
        ItemKind::Choice(choice) => Some(&choice.name.text),
        ItemKind::Function(function) => Some(&function.name.text),
        ItemKind::Points(points) => Some(&points.name.text),
        _ => None,
    }
}

fn is_state(items: &[Item], name: &str) -> bool {
    all_items(items).any(|item| matches!(&item.kind, ItemKind::State(value) if value.name.ident.text == name))
}
