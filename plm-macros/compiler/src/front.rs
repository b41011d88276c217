//! The front end: from tokens to the model.

use crate::diag::Diagnostics;
use crate::library::Library;
use crate::model::Model;
use crate::resolve::resolve;
use crate::syntax::parse;
use crate::token::Sources;

/// Reads the declaration, source 0 of `sources`, and binds its names. Library parts that it uses are added to the
/// sources, so that messages can quote them. `None` if there are errors; all that were found are in the sink.
pub fn parse_and_resolve(sources: &mut Sources, sink: &mut Diagnostics) -> Option<Model> {
    let declaration = parse(sources.get(0)?, sink);
    let library = Library::load(&declaration, sources, sink);
    let mechanism = declaration.mechanism.as_ref()?;
    resolve(&declaration, mechanism, &library, sink)
}
