//! What can go wrong when a file is written.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A file that could not be written: which one, and why.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
pub struct Error {
    path: PathBuf,
    source: io::Error,
}

impl Error {
    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot write {}: {}", self.path.display(), self.source)
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.source)
    }
}

/// Writes `contents` to the file `path`, makes the folders above it where they are missing, and names the
/// file in the error.
pub(crate) fn write_file(path: &Path, contents: io::Result<Vec<u8>>) -> Result<(), Error> {
    contents
        .and_then(|bytes| {
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder)?;
            }
            fs::write(path, bytes)
        })
        .map_err(|source| Error { path: path.to_owned(), source })
}
