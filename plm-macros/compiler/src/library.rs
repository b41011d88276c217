//! The parts library: which definitions a declaration can use.
//!
//! Library files are read only if the declaration, or a part that it uses, names them: the library may grow without
//! anyone paying for what they do not use.

use std::collections::{BTreeMap, BTreeSet};

use crate::diag::{Code, Diagnostics};
use crate::syntax::ast::{Declaration, Definition, Item, ItemKind};
use crate::syntax::parse_parts;
use crate::token::Sources;

/// Name of each part of the library and the file that defines it.
pub(crate) const PARTS: &[(&str, &str)] = &[
    ("force", include_str!("../parts/force.plm")),
    ("jack", include_str!("../parts/jack.plm")),
    ("pin_slot", include_str!("../parts/pin_slot.plm")),
    ("prismatic", include_str!("../parts/prismatic.plm")),
    ("revolute", include_str!("../parts/revolute.plm")),
    ("spring", include_str!("../parts/spring.plm")),
    ("weld", include_str!("../parts/weld.plm")),
];

/// The definitions that a declaration can use: its own, and those of the library that it names.
#[derive(Debug)]
pub(crate) struct Library {
    definitions: BTreeMap<String, Definition>,
}

impl Library {
    /// Collects the definitions of a declaration and loads what it names from the library. A part of the user's own
    /// takes the place of one of the library.
    pub(crate) fn load(declaration: &Declaration, sources: &mut Sources, sink: &mut Diagnostics) -> Library {
        let mut library = Library { definitions: BTreeMap::new() };
        let mut open = BTreeSet::new();
        for part in &declaration.parts {
            library.add(part, sink);
        }
        let items = declaration.mechanism.as_ref().map_or(&[][..], |mechanism| &mechanism.items);
        library.collect(items, &mut open, sink);
        for part in &declaration.parts {
            library.collect(&part.items, &mut open, sink);
        }
        while let Some(kind) = open.pop_first() {
            library.load_part(&kind, &mut open, sources, sink);
        }
        library
    }

    fn load_part(
        &mut self,
        kind: &str,
        open: &mut BTreeSet<String>,
        sources: &mut Sources,
        sink: &mut Diagnostics,
    ) {
        let text = PARTS.iter().find(|(name, _)| *name == kind).map(|(_, text)| *text);
        let Some(text) = text.filter(|_| !self.definitions.contains_key(kind)) else { return };
        let source = sources.add_text(&format!("{kind}.plm"), text);
        let Some(source) = sources.get(source) else { return };
        for part in parse_parts(source, sink) {
            self.collect(&part.items, open, sink);
            self.definitions.entry(part.name.text.clone()).or_insert(part);
        }
    }

    fn add(&mut self, part: &Definition, sink: &mut Diagnostics) {
        let name = &part.name;
        match self.definitions.get(&name.text) {
            Some(first) => {
                let message = format!("the part `{}` is defined twice", name.text);
                sink.error(Code::DuplicateName, name.span, message)
                    .note_at(first.name.span, "it is defined first here");
            }
            None => {
                self.definitions.insert(name.text.clone(), part.clone());
            }
        }
    }

    /// Takes the definitions among items, and notes the names of the parts that they use.
    fn collect(&mut self, items: &[Item], open: &mut BTreeSet<String>, sink: &mut Diagnostics) {
        for item in items {
            match &item.kind {
                ItemKind::Definition(part) => {
                    self.add(part, sink);
                    self.collect(&part.items, open, sink);
                }
                ItemKind::Repeat(repeat) => self.collect(&repeat.items, open, sink),
                ItemKind::Instance(instance) => {
                    open.insert(instance.kind.text.clone());
                }
                _ => {}
            }
        }
    }

    /// The definition of a name.
    pub(crate) fn get(&self, kind: &str) -> Option<&Definition> {
        self.definitions.get(kind)
    }

    /// Names of all parts, also of those that are not loaded.
    pub(crate) fn kinds(&self) -> impl Iterator<Item = &str> {
        let own = self.definitions.keys().map(String::as_str);
        own.chain(PARTS.iter().map(|(name, _)| *name))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::PARTS;
    use crate::diag::Diagnostics;
    use crate::syntax::parse_parts;
    use crate::token::Sources;

    #[test]
    fn every_file_defines_the_part_of_its_name_and_documents_it() {
        for (name, text) in PARTS {
            let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
            let source = sources.add_text(name, text);
            let parts = parse_parts(sources.get(source).unwrap(), &mut sink);
            assert!(!sink.has_errors(), "{name}");
            assert_eq!(parts.iter().map(|part| part.name.text.as_str()).collect::<Vec<_>>(), [*name]);
            assert!(!parts[0].docs.is_empty(), "{name}");
        }
    }
}
