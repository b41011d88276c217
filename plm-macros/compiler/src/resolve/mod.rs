//! From the tree to the model: names bound, units checked, parts taken apart.
//!
//! Three steps. `declare` walks the items in order, unrolls repetitions, opens parts, and binds every name to a value
//! or to an expression that waits. Then everything that the model needs is evaluated; an expression that waits is
//! worked out at its first use. So the order of declaration does not matter, a part may read the outputs of another,
//! and only a true circle is an error. Last, rates of states and sums at nodes take the places of the symbols that stood for
//! them.
//!
//! * `names`: scopes, what is bound in them, what is said of a name that there is not.
//! * `values`: what an expression means; members and functions, as tables.
//! * `declarations`: items of the declaration (bodies, frames, parts, rows, loads, nodes, states), kept in the unresolved model.
//! * `finalise`: makes the model of the unresolved one: placeholders, compliances, outputs, what is observed, warnings.
//! * `calculus`: symbols that change with time, and total derivatives.

mod calculus;
mod declarations;
mod finalise;
mod names;
mod values;

use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::front::Reading;
use crate::library::Library;
use crate::model::Model;
use crate::span::Span;
use crate::syntax::ast::Mechanism;
use crate::token::Files;
use calculus::Calculus;
use declarations::UnresolvedModel;
pub(crate) use names::lookup::RESERVED;
use names::{Names, ScopeId};
use values::Value;
pub(crate) use values::function_table::{CallShape, FUNCTIONS, Function};
pub(crate) use values::member_table::{Member, Owner};

/// Binds the names of a mechanism; what it observes is left out unless it is asked for. `None` if it has errors; they are in the
/// sink.
pub(crate) fn resolve(reading: &Reading, observes: bool, sink: &mut Diagnostics) -> Option<Model> {
    let mechanism = reading.declaration.mechanism.as_ref()?;
    let mut resolver = Resolver {
        sink,
        library: &reading.library,
        files: &reading.files,
        names: Names::default(),
        calculus: Calculus::new(),
        unresolved: UnresolvedModel::default(),
        depth: 0,
    };
    resolver.begin(mechanism);
    resolver.evaluate();
    if !observes {
        resolver.unresolved.observed.clear();
    }
    resolver.into_model(&reading.declaration, mechanism)
}

/// Names, derivatives with respect to time, and declarations of a mechanism.
struct Resolver<'a> {
    sink: &'a mut Diagnostics,
    library: &'a Library,
    /// Files that the declaration names.
    files: &'a Files,
    names: Names<'a>,
    calculus: Calculus,
    unresolved: UnresolvedModel<'a>,
    /// How many expressions are being evaluated, one inside the other.
    depth: u32,
}

impl<'a> Resolver<'a> {
    /// Binds what every mechanism has, then what this one declares.
    fn begin(&mut self, mechanism: &'a Mechanism) {
        let top = self.names.new_scope(None, None);
        let ground = self.names.known_slot(mechanism.name.span, Value::Body(None));
        self.names.scopes[top].names.insert("ground".into(), ground);
        self.declare(&mechanism.items, top, None);
    }

    /// Evaluates all that the model needs, in the order of declaration.
    fn evaluate(&mut self) {
        for slot in std::mem::take(&mut self.names.checks) {
            let span = self.names.slots[slot].span;
            let _ = self.slot_value(slot, 0, span);
        }
        for body in 0..self.unresolved.bodies.len() {
            self.check_body(body);
        }
        for instance in 0..self.names.instances.len() {
            self.connect(instance);
        }
        for row in 0..self.unresolved.rows.len() {
            let _ = self.row(row);
        }
    }

    /// Reports an error in a scope: if it is the inside of a part, with the uses that lead there.
    fn error(
        &mut self,
        scope: ScopeId,
        code: Code,
        span: Span,
        message: impl Into<String>,
    ) -> &mut Diagnostic {
        let uses = self.names.uses(scope);
        let diagnostic = self.sink.error(code, span, message);
        diagnostic.uses = uses;
        diagnostic
    }
}
