//! Names: what is bound in which scope, and which part a scope is the inside of.

pub(super) mod lookup;
pub(super) mod unknown;

use crate::collect::CollectVec;
use crate::sorted::sort_by_key;
use crate::sorted::{SortedMap, SortedSet};
use std::borrow::Cow;

use crate::diag::Use;
use crate::resolve::declarations::handed::HandedFunction;
use crate::resolve::declarations::part::PartInUse;
use crate::resolve::finalise::warnings::Readable;
use crate::resolve::values::Value;
use crate::resolve::values::expect::Wanted;
use crate::resolve::values::lazy::Lazy;
use crate::span::Span;
use crate::syntax::ast;

/// Index of a scope; that of the mechanism is 0.
pub(crate) type ScopeId = usize;
/// Index of a named value.
pub(crate) type SlotId = usize;

/// Scopes, and what is named in them.
#[derive(Default)]
pub(crate) struct Names<'a> {
    pub(crate) scopes: Vec<Scope<'a>>,
    pub(crate) slots: Vec<Slot<'a>>,
    /// Parts in use, those inside of others too.
    pub(crate) instances: Vec<PartInUse<'a>>,
    /// Chosen option of each choice, and all of them.
    pub(crate) choices: Vec<(&'a str, Vec<&'a str>)>,
    /// Functions that uses of parts hand over.
    pub(crate) functions: Vec<HandedFunction<'a>>,
    /// Slots to evaluate even if nothing reads them: their mistakes count.
    pub(crate) checks: Vec<SlotId>,
    /// Params, inputs and `let`s of the user's own, with their names.
    pub(crate) readable: Vec<(String, Readable)>,
    /// Definitions whose outputs are among the checks already.
    pub(crate) checked: SortedSet<&'a str>,
}

/// Names of one block.
#[derive(Default)]
pub(crate) struct Scope<'a> {
    /// Scope in which a name is looked up next: the one around a turn of a repetition, a `given`, or a function that is handed over. `None`
    /// for the mechanism and for parts.
    pub(crate) parent: Option<ScopeId>,
    /// Names of values, parts, bodies.
    pub(crate) names: SortedMap<Cow<'a, str>, SlotId>,
    /// Names of rows.
    pub(crate) rows: SortedMap<Cow<'a, str>, (RowId, Span)>,
    /// Outputs of a part.
    pub(crate) outputs: SortedMap<Cow<'a, str>, SlotId>,
    /// Optional parameters of a part.
    pub(crate) optional: SortedMap<Cow<'a, str>, Optional>,
    /// Is it the block of a `given`? What is declared in it belongs to what encloses it.
    is_given: bool,
    /// The part whose inside this is.
    instance: Option<usize>,
}

/// A parameter that the use of a part need not set.
#[derive(Clone, Copy)]
pub(crate) enum Optional {
    Unset,
    Set(SlotId),
}

/// A row: index into the list of its kind.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum RowId {
    Constraint(usize),
    Contact(usize),
}

/// A named value.
pub(crate) struct Slot<'a> {
    /// Span of its declaration.
    pub(crate) span: Span,
    /// Has an expression named it?
    pub(crate) is_read: bool,
    /// The expression that gives its value.
    pub(crate) thunk: Option<Thunk<'a>>,
    pub(crate) value: Lazy<Value>,
}

/// An expression that waits for its first use.
#[derive(Clone, Copy)]
pub(crate) struct Thunk<'a> {
    pub(crate) scope: ScopeId,
    pub(crate) expr: &'a ast::Expr,
    pub(crate) wanted: Wanted,
}

impl<'a> Names<'a> {
    pub(crate) fn new_scope(&mut self, parent: Option<ScopeId>, instance: Option<usize>) -> ScopeId {
        self.scopes.push(Scope { parent, instance, ..Scope::default() });
        self.scopes.len() - 1
    }

    /// The scope of a block that exists where something is given.
    pub(crate) fn new_block(&mut self, parent: ScopeId) -> ScopeId {
        self.scopes.push(Scope { parent: Some(parent), is_given: true, ..Scope::default() });
        self.scopes.len() - 1
    }

    /// A slot whose value is known.
    pub(crate) fn known_slot(&mut self, span: Span, value: Value) -> SlotId {
        self.new_slot(span, None, Lazy::Known(value))
    }

    /// A slot of which the mistake has been told already.
    pub(crate) fn failed_slot(&mut self, span: Span) -> SlotId {
        self.new_slot(span, None, Lazy::Failed)
    }

    /// A slot whose value is worked out at its first use.
    pub(crate) fn waiting_slot(&mut self, span: Span, thunk: Thunk<'a>) -> SlotId {
        self.new_slot(span, Some(thunk), Lazy::Waiting)
    }

    fn new_slot(&mut self, span: Span, thunk: Option<Thunk<'a>>, value: Lazy<Value>) -> SlotId {
        self.slots.push(Slot { span, is_read: false, thunk, value });
        self.slots.len() - 1
    }

    /// The scope that a repetition stands in.
    pub(crate) fn home(&self, mut scope: ScopeId) -> ScopeId {
        while let Some(parent) = self.scopes[scope].parent {
            scope = parent;
        }
        scope
    }

    /// The scope that what is declared in a scope belongs to.
    pub(crate) fn owner(&self, mut scope: ScopeId) -> ScopeId {
        while let (true, Some(parent)) = (self.scopes[scope].is_given, self.scopes[scope].parent) {
            scope = parent;
        }
        scope
    }

    /// Does a scope stand in a repetition?
    pub(crate) fn is_repeated(&self, scope: ScopeId) -> bool {
        self.scopes[self.owner(scope)].parent.is_some()
    }

    /// The part that a scope is inside of.
    pub(crate) fn instance(&self, scope: ScopeId) -> Option<usize> {
        self.scopes[self.home(scope)].instance
    }

    /// The part that a scope is inside of, the part that contains that one, and so on.
    pub(crate) fn around(&self, scope: ScopeId) -> impl Iterator<Item = usize> {
        std::iter::successors(self.instance(scope), |part| self.instance(self.instances[*part].outer))
    }

    /// The uses that lead to a scope, from the declaration inwards.
    pub(crate) fn uses(&self, scope: ScopeId) -> Vec<Use> {
        let mut uses: Vec<Use> = self.around(scope).map(|part| self.instances[part].as_use()).collect_vec();
        uses.reverse();
        uses
    }

    /// The path of the part that a scope is inside of, as a prefix of names: empty at the top, else `arm.spring.`.
    pub(crate) fn prefix(&self, scope: ScopeId) -> String {
        self.instance(scope).map_or_else(String::new, |part| format!("{}.", self.instances[part].name))
    }

    /// The slot of a name that can be seen in a scope.
    pub(crate) fn find(&self, scope: ScopeId, key: &str) -> Option<SlotId> {
        self.outwards(scope).find_map(|scope| self.scopes[scope].names.get(key).copied())
    }

    /// A scope and those that enclose it, up to the inside of the part.
    pub(crate) fn outwards(&self, scope: ScopeId) -> impl Iterator<Item = ScopeId> {
        std::iter::successors(Some(scope), |scope| self.scopes[*scope].parent)
    }

    /// All names that can be seen, in the order of declaration; rows, which only `reaction` reads, after the others.
    pub(crate) fn visible(&self, scope: ScopeId) -> Vec<String> {
        let scopes = self.outwards(scope);
        let mut names: Vec<(&str, SlotId)> = scopes
            .flat_map(|scope| &self.scopes[scope].names)
            .map(|(name, slot)| (name.as_ref(), *slot))
            .collect_vec();
        sort_by_key(&mut names, |(_, slot)| *slot);
        let rows = &self.scopes[self.home(scope)].rows;
        let mut rows: Vec<(&str, RowId)> =
            rows.iter().map(|(name, row)| (name.as_ref(), row.0)).collect_vec();
        sort_by_key(&mut rows, |(_, row)| *row);
        let rows = rows.into_iter().map(|(name, _)| name);
        names.into_iter().map(|(name, _)| name).chain(rows).map(str::to_string).collect_vec()
    }
}
