//! The front end: from tokens to the model.

use plm_cas::Graph;

use crate::diag::Diagnostics;
use crate::library::Library;
use crate::model::Model;
use crate::resolve::resolve;
use crate::syntax::ast::Declaration;
use crate::syntax::parse;
use crate::token::{Files, Source, Sources};

/// Reads the declaration, source 0 of `sources`, and binds its names. Library parts that it uses are added to the
/// sources, so that messages can quote them. `None` if there are errors; all that were found are in the sink.
pub fn parse_and_resolve(sources: &mut Sources, sink: &mut Diagnostics) -> Option<Model> {
    read(sources, sink).model(sink)
}

/// A declaration as it was read, and the parts that it can use.
pub(crate) struct Reading {
    pub(crate) declaration: Declaration,
    pub(crate) library: Library,
    pub(crate) files: Files,
    /// The declaration as it was written.
    text: String,
}

pub(crate) fn read(sources: &mut Sources, sink: &mut Diagnostics) -> Reading {
    let declaration = match sources.get(0) {
        Some(source) => parse(source, sink),
        None => Declaration::default(),
    };
    let library = Library::load(&declaration, sources, sink);
    let text = sources.get(0).map(Source::whole).unwrap_or_default();
    Reading { declaration, library, files: sources.files().clone(), text }
}

impl Reading {
    /// Names bound; `None` if there are errors.
    pub(crate) fn model(&self, sink: &mut Diagnostics) -> Option<Model> {
        self.resolved(true, sink)
    }

    /// The model as it would be if nothing were observed.
    pub(crate) fn unobserved(&self) -> Option<Model> {
        self.resolved(false, &mut Diagnostics::new())
    }

    fn resolved(&self, observes: bool, sink: &mut Diagnostics) -> Option<Model> {
        let mut graph = Graph::new();
        let model = graph.enter(|| resolve(self, observes, sink))?;
        Some(Model { graph, text: self.text.clone(), ..model })
    }
}
