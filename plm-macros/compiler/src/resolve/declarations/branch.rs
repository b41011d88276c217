//! The mirror image of a loop that the use of a revolute asks for.

use crate::collect::MapEach;
use crate::diag::Code;
use crate::model::Turn;
use crate::resolve::Resolver;
use crate::syntax::ast::{Definition, ExprKind, ItemKind};

/// The word that asks for it.
pub(crate) const BRANCH: &str = "branch";

/// Is it a joint that turns, whose turn may tell mirror images apart?
pub(crate) fn tells_branches(definition: &Definition) -> bool {
    definition.items.iter().any(|item| matches!(&item.kind, ItemKind::Pair(pair) if pair.text == "revolute"))
}

impl Resolver<'_> {
    /// `{ branch: left; }`; where no branch can be asked for, that has been told.
    pub(crate) fn ask_for_branch(&mut self, id: usize) {
        let Some((outer, field)) = self.names.word(id, BRANCH) else { return };
        if !tells_branches(self.names.instances[id].definition) {
            return;
        }
        let part = self.names.instances[id].part;
        let names = Turn::NAMES.map_each(|(name, _)| name);
        let ExprKind::Name(name) = &field.value.kind else {
            let message = format!("expected one of {}", names.join(", "));
            self.error(outer, Code::UnknownOption, field.value.span, message);
            return;
        };
        match Turn::NAMES.iter().find(|known| known.0 == name.ident.text) {
            Some((_, turn)) => self.unresolved.parts[part].branch = Some((*turn, field.span())),
            None => self.unknown_option(outer, &name.ident.text, name.ident.span, &names),
        }
    }
}
