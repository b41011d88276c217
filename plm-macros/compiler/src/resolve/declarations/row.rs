//! Constraint rows and loads.

use plm_cas::Expr;

use crate::diag::Code;
use crate::model::{Declared, Name, Part};
use crate::resolve::Resolver;
use crate::resolve::names::{RowId, ScopeId};
use crate::resolve::values::lazy::Lazy;
use crate::resolve::values::{Eval, Failed, Reads};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::Dimension;

/// A constraint row on the way to its phi.
pub(crate) struct UnresolvedRow<'a> {
    pub(crate) scope: ScopeId,
    left: &'a ast::Expr,
    right: &'a ast::Expr,
    /// Full name, `shoulder.x`.
    pub(crate) name: String,
    pub(crate) part: usize,
    pub(crate) span: Span,
    pub(crate) lambda: Expr,
    /// It holds while this does; always, where it is not written.
    pub(crate) when: Option<&'a ast::Expr>,
    value: Lazy<RowValue>,
}

/// A row whose name is bound.
pub(crate) struct NamedRow {
    /// Full name.
    pub(crate) name: String,
    pub(crate) part: usize,
    pub(crate) span: Span,
    /// Symbol of its multiplier.
    pub(crate) lambda: Expr,
}

/// Value of a row.
#[derive(Clone, Copy)]
pub(crate) struct RowValue {
    pub(crate) phi: Expr,
    pub(crate) dimension: Dimension,
}

impl<'a> Resolver<'a> {
    /// A row in a part; at the top of the mechanism it is a part of its own.
    pub(crate) fn declare_row(
        &mut self,
        scope: ScopeId,
        name: &'a ast::IndexedName,
        ([left, right], when): ([&'a ast::Expr; 2], Option<&'a ast::Expr>),
        part: Option<usize>,
    ) {
        let id = RowId::Constraint(self.unresolved.rows.len());
        let Some(row) = self.name_row(scope, name, id, "constraint", part) else { return };
        self.unresolved.rows.push(UnresolvedRow {
            scope,
            left,
            right,
            name: row.name,
            part: row.part,
            span: row.span,
            lambda: row.lambda,
            when,
            value: Lazy::Waiting,
        });
    }

    /// Binds the name of a row. `word` is the kind of the part that it is at the top of the mechanism. `None` if the name is none.
    pub(crate) fn name_row(
        &mut self,
        scope: ScopeId,
        name: &'a ast::IndexedName,
        id: RowId,
        word: &str,
        part: Option<usize>,
    ) -> Option<NamedRow> {
        if self.needs_index(scope, name) {
            return None;
        }
        let key = self.key(scope, name).ok()?;
        let home = self.names.home(scope);
        let full = format!("{}{key}", self.names.prefix(scope));
        if let Some((_, first)) = self.names.scopes[home].rows.get(&key) {
            let first = *first;
            self.duplicate(scope, &key, name.ident.span, first);
            return None;
        }
        let span = match self.names.instance(scope) {
            Some(_) => self.unresolved.parts[part.unwrap_or(0)].name.span,
            None => name.ident.span,
        };
        let part = part.unwrap_or_else(|| {
            let name = Name { text: full.clone(), span };
            let kind = word.to_string();
            self.unresolved.parts.push(Part {
                name,
                kind,
                pair: None,
                declared: None,
                frames: Vec::new(),
                branch: None,
            });
            self.unresolved.parts.len() - 1
        });
        let lambda = Expr::symbol(format!("lambda_{full}"));
        self.names.scopes[home].rows.insert(key, (id, name.ident.span));
        Some(NamedRow { name: full, part, span, lambda })
    }

    /// Place of the equation of a row.
    pub(crate) fn row_declared(&self, row: usize) -> Declared {
        let UnresolvedRow { scope, left, right, .. } = self.unresolved.rows[row];
        Declared { span: left.span.to(right.span), uses: self.names.uses(scope) }
    }

    /// The phi of a row, worked out at its first use.
    pub(crate) fn row(&mut self, row: usize) -> Eval<RowValue> {
        // A constraint that reads its own reaction is told so where it does.
        self.lazy(|of| &mut of.unresolved.rows[row].value, |_| (), |of| of.phi(row))
    }

    fn phi(&mut self, row: usize) -> Eval<RowValue> {
        let UnresolvedRow { scope, left, right, .. } = self.unresolved.rows[row];
        let (a, b) = (self.eval_scalar(scope, left), self.eval_scalar(scope, right));
        let (a, b) = (a?, b?);
        let nature = self.joined(scope, left.span.to(right.span), a, b)?;
        let beyond = nature.reads.beyond(Reads::GEOMETRY);
        if beyond != Reads::NOTHING {
            let message = format!("a constraint reads {}", beyond.describe());
            let diagnostic = self
                .error(scope, Code::NotConstant, left.span.to(right.span), message)
                .note(format!("it may read {}", Reads::GEOMETRY.describe()));
            if let Some([why, instead]) = beyond.no_place() {
                diagnostic.note(why).help(instead);
            }
            return Err(Failed);
        }
        let phi = a.value - b.value;
        if phi.as_number().is_some() && !nature.reads.has(Reads::POSITION) {
            self.error(scope, Code::NotConstant, left.span, "a constraint that holds no position")
                .help("it must tie the positions of bodies");
            return Err(Failed);
        }
        Ok(RowValue { phi, dimension: nature.dimension })
    }
}
