//! The passes, in order.

use crate::check;
use crate::derive::derive;
use crate::diag::Diagnostics;
use crate::emit::{self, Code};
use crate::formulate::formulate;
use crate::front;
use crate::model::Model;
use crate::oracle::Oracle;
use crate::report::Report;
use crate::syntax::ast::Declaration;
use crate::token::Sources;

/// What the compiler makes of a declaration.
#[derive(Debug, Default)]
pub struct Expansion {
    /// Rust source: the mechanism, or after errors a type by its name so that nothing cascades; `None` if not even a
    /// name was found.
    pub code: Option<Code>,
    /// Everything that is wrong.
    pub diagnostics: Diagnostics,
    /// What was found and chosen; `None` after errors.
    pub report: Option<Report>,
    /// The mechanism for the interpreter; `None` after errors.
    pub oracle: Option<Oracle>,
}

/// Compiles the declaration that is the first of `sources`; library files that it needs are added behind it.
///
/// Mistakes never end the compilation early with nothing: they are all in [`Expansion::diagnostics`].
pub fn compile(sources: &mut Sources) -> Expansion {
    let mut sink = Diagnostics::new();
    let (declaration, model) = front::read(sources, &mut sink);
    let mut expansion = match model {
        Some(model) => back_end(model, &mut sink),
        None => Expansion::default(),
    };
    if sink.has_errors() {
        // A mechanism that is complete but for its start has all its names; without them a stub has to do.
        let code = expansion.code.or_else(|| stub(&declaration));
        expansion = Expansion { code, ..Expansion::default() };
    }
    expansion.diagnostics = sink;
    expansion
}

/// From the model to source text.
fn back_end(mut model: Model, sink: &mut Diagnostics) -> Expansion {
    let mut graph = std::mem::take(&mut model.graph);
    check::check_reach(&model, sink);
    if sink.has_errors() {
        return Expansion::default();
    }
    let equations = derive(&model, &mut graph);
    let program = formulate(&model, &equations, &mut graph);
    let defaults = check::defaults(&model, &graph);
    let mut report = Report::new(&model, &equations, &program, &graph, &defaults);
    check::check_assembly(&model, &equations, &program, &graph, &mut report, sink);
    sink.allow(&model.allowed);
    let code = emit::emit(&model, &graph, &equations, &program, &report);
    let oracle = Oracle { model, graph, equations, program };
    Expansion { code: Some(code), report: Some(report), oracle: Some(oracle), ..Expansion::default() }
}

/// The declared name without content.
fn stub(declaration: &Declaration) -> Option<Code> {
    let mechanism = declaration.mechanism.as_ref()?;
    let path = declaration.crate_path.as_deref().unwrap_or("::plm");
    Some(emit::emit_stub(&mechanism.name.text, &mechanism.visibility, path, mechanism.name.span))
}
