//! Texts that are compared with files, or written there where `PLM_BLESS` is set.

use std::fs;
use std::path::{Path, PathBuf};

/// Where the files are.
pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots")
}

/// Compares with a file, or writes it.
pub(crate) fn blessed(file: &str, found: &str) -> Result<(), String> {
    let path = folder().join(file);
    if std::env::var_os("PLM_BLESS").is_some() {
        fs::write(path, found).unwrap();
        return Ok(());
    }
    let expected = fs::read_to_string(path).unwrap_or_default();
    let mut lines = expected.lines().zip(found.lines()).zip(1..);
    match lines.find(|((expected, found), _)| expected != found) {
        Some(((expected, found), line)) => {
            Err(format!("{file}:{line}\n  blessed: {expected}\n  emitted: {found}"))
        }
        None if expected != found => Err(format!("{file}: one text goes on where the other ends")),
        None => Ok(()),
    }
}
