//! The mirror image of a loop that the use of a revolute asks for.

use super::Resolver;
use crate::diag::Code;
use crate::model::{Pair, Turn};
use crate::syntax::ast::ExprKind;

/// The word that asks for it.
pub(super) const BRANCH: &str = "branch";

impl Resolver<'_> {
    /// `{ branch: left; }`
    pub(super) fn ask_for_branch(&mut self, id: usize) {
        let Some((outer, field)) = self.word(id, BRANCH) else { return };
        let (part, is_part) = (self.instances[id].part, self.instances[id].is_part);
        if !is_part || self.parts[part].pair != Some(Pair::Revolute) {
            let message =
                format!("`{}` is no revolute joint, which could have a `{BRANCH}`", self.instances[id].name);
            self.error(outer, Code::UnknownField, field.span(), message);
            return;
        }
        let names = Turn::NAMES.map(|(name, _)| name);
        let ExprKind::Name(name) = &field.value.kind else {
            let message = format!("expected one of {}", names.join(", "));
            self.error(outer, Code::UnknownOption, field.value.span, message);
            return;
        };
        match Turn::NAMES.iter().find(|known| known.0 == name.ident.text) {
            Some((_, turn)) => self.parts[part].branch = Some((*turn, field.span())),
            None => self.unknown_option(outer, &name.ident.text, name.ident.span, &names),
        }
    }
}
