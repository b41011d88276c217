//! Files that a declaration names. The compiler does no I/O; here they are read for it.

use std::fs;
use std::path::PathBuf;

use plm_compiler::token::Sources;

/// Hands over every file that is named, from the folder of the user's Cargo.toml.
pub(crate) fn read(sources: &mut Sources) {
    for name in sources.named_files() {
        let folder = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
        let content = fs::read_to_string(folder.join(&name)).map_err(|error| error.to_string());
        sources.add_file(&name, content);
    }
}
