//! The parts library: which definitions a declaration can use.
//!
//! Library files are read only if the declaration, or a part that it uses, names them: the library may grow without
//! anyone paying for what they do not use.

use crate::collect::CollectVec;
use crate::sorted::{SortedMap, SortedSet};

use crate::diag::{Code, Diagnostics};
use crate::syntax::ast::{
    Argument, Declaration, Definition, Domain, Ident, Item, ItemKind, Shared, all_items,
};
use crate::syntax::parse_parts;
use crate::token::Sources;

mod catalogue;
mod elsewhere;

pub(crate) use catalogue::{DOMAINS, PARTS};
pub(crate) use elsewhere::{ELSEWHERE, OUTPUTS};

/// The parts of the library that have this name in the manual, `PLMPIV00` or `MAS002`, as their documentation says.
pub(crate) fn of_manual(name: &str) -> Vec<&'static str> {
    let is_code = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit();
    if name.len() < 4 || !name.chars().all(is_code) || !name.contains(|c: char| c.is_ascii_digit()) {
        return Vec::new();
    }
    let has_name = |text: &str| text.split(|c: char| !c.is_ascii_alphanumeric()).any(|word| word == name);
    let documents = |text: &str| text.lines().take_while(|line| line.starts_with("///")).any(has_name);
    PARTS.iter().filter(|(_, text)| documents(text)).map(|(part, _)| *part).collect_vec()
}

/// The definitions that a declaration can use: its own, and those of the library that it names.
pub(crate) struct Library {
    definitions: SortedMap<String, Definition>,
    domains: SortedMap<String, Domain>,
}

impl Library {
    /// Collects the definitions of a declaration and loads what it names from the library. A part of the user's own
    /// takes the place of one of the library.
    pub(crate) fn load(declaration: &Declaration, sources: &mut Sources, sink: &mut Diagnostics) -> Library {
        let mut library = Library { definitions: SortedMap::new(), domains: SortedMap::new() };
        let mut open = SortedSet::new();
        let Shared { parts, domains } = &declaration.shared;
        for domain in domains {
            library.add_domain(domain, sink);
        }
        for part in parts {
            library.add(part, sink);
        }
        let items = declaration.mechanism.as_ref().map_or(&[][..], |mechanism| &mechanism.items);
        library.collect(items, &mut open, sink);
        for part in parts {
            library.look_into(part, &mut open, sink);
        }
        while let Some(kind) = open.pop_first() {
            library.load_file(&kind, &mut open, sources, sink);
        }
        library
    }

    fn load_file(
        &mut self,
        kind: &str,
        open: &mut SortedSet<String>,
        sources: &mut Sources,
        sink: &mut Diagnostics,
    ) {
        let text = PARTS.iter().chain(DOMAINS).find(|(name, _)| *name == kind).map(|(_, text)| *text);
        let is_known = self.definitions.contains_key(kind) || self.domains.contains_key(kind);
        let Some(text) = text.filter(|_| !is_known) else { return };
        let source = sources.add_text(&format!("{kind}.plm"), text);
        let Some(source) = sources.get(source) else { return };
        let Shared { parts, domains } = parse_parts(source, sink);
        for part in parts {
            self.look_into(&part, open, sink);
            self.definitions.or_insert(part.name.text.clone(), part);
        }
        for domain in domains {
            self.domains.or_insert(domain.name.text.clone(), domain);
        }
    }

    fn add_domain(&mut self, domain: &Domain, sink: &mut Diagnostics) {
        if let Some(first) = self.domains.get(&domain.name.text) {
            defined_twice("domain", &domain.name, &first.name, sink);
        } else {
            self.domains.insert(domain.name.text.clone(), domain.clone());
        }
    }

    fn add(&mut self, part: &Definition, sink: &mut Diagnostics) {
        if let Some(first) = self.definitions.get(&part.name.text) {
            defined_twice("part", &part.name, &first.name, sink);
        } else {
            self.definitions.insert(part.name.text.clone(), part.clone());
        }
    }

    /// Notes what a part names: the domains of its ports, and the parts that it contains.
    fn look_into(&mut self, part: &Definition, open: &mut SortedSet<String>, sink: &mut Diagnostics) {
        open.extend(part.arguments.iter().map(|Argument { kind, .. }| kind.text.clone()));
        self.collect(&part.items, open, sink);
    }

    /// Takes the definitions among items, and notes the names of the parts that they use.
    fn collect(&mut self, items: &[Item], open: &mut SortedSet<String>, sink: &mut Diagnostics) {
        for item in all_items(items) {
            match &item.kind {
                ItemKind::Definition(part) => {
                    self.add(part, sink);
                    self.look_into(part, open, sink);
                }
                ItemKind::Domain(domain) => self.add_domain(domain, sink),
                ItemKind::Node(node) => {
                    open.insert(node.kind.text.clone());
                }
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

    /// The domain of a name.
    pub(crate) fn domain(&self, name: &str) -> Option<&Domain> {
        self.domains.get(name)
    }

    /// Names of the domains that the declaration can use.
    pub(crate) fn domains(&self) -> impl Iterator<Item = &str> {
        self.domains.keys().map(String::as_str)
    }

    /// Names of all parts, also of those that are not loaded.
    pub(crate) fn kinds(&self) -> impl Iterator<Item = &str> {
        let own = self.definitions.keys().map(String::as_str);
        own.chain(PARTS.iter().map(|(name, _)| *name))
    }
}

fn defined_twice(what: &str, name: &Ident, first: &Ident, sink: &mut Diagnostics) {
    sink.error(Code::DuplicateName, name.span, format!("the {what} `{}` is defined twice", name.text))
        .note_at(first.span, "it is defined first here");
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{DOMAINS, PARTS};
    use crate::diag::Diagnostics;
    use crate::syntax::parse_parts;
    use crate::token::Sources;

    #[test]
    fn every_file_defines_the_part_of_its_name_and_documents_it() {
        for (name, text) in PARTS.iter().chain(DOMAINS) {
            let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
            let source = sources.add_text(name, text);
            let shared = parse_parts(sources.get(source).unwrap(), &mut sink);
            assert!(!sink.has_errors(), "{name}");
            let parts = shared.parts.iter().map(|part| (part.name.text.as_str(), &part.docs));
            let domains = shared.domains.iter().map(|domain| (domain.name.text.as_str(), &domain.docs));
            let found: Vec<_> = parts.chain(domains).collect();
            assert_eq!(found.iter().map(|(of, _)| *of).collect::<Vec<_>>(), [*name]);
            assert!(found.iter().all(|(_, docs)| !docs.is_empty()), "{name}");
        }
    }
}
