//! Errors of writing or reading a file.

use std::fmt;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::replace::replace_file;

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
/// file in the error. A file that is there stays as it was until the new one is whole.
///
/// # Errors
/// `contents`, or a file that cannot be written.
pub fn write_file(path: &Path, contents: io::Result<Vec<u8>>) -> Result<(), Error> {
    contents
        .and_then(|bytes| {
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder)?;
            }
            replace_file(path, &bytes)
        })
        .map_err(|source| Error { path: path.to_owned(), source })
}

/// A file that could not be read, or not as a whole; its intact contents are given all the same.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
pub struct Unread<T> {
    path: PathBuf,
    problems: Vec<String>,
    whole: Box<T>,
}

impl<T> Unread<T> {
    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Defects of the file, as sentences without their end: `0/values.npy is cut off`.
    pub fn problems(&self) -> &[String] {
        &self.problems
    }

    /// The contents that could be read.
    pub fn whole(&self) -> &T {
        &self.whole
    }

    /// Becomes the contents that could be read.
    pub fn into_whole(self) -> T {
        *self.whole
    }
}

impl<T> fmt::Debug for Unread<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<T> fmt::Display for Unread<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot read all of {}: {}", self.path.display(), self.problems.join("; "))
    }
}

impl<T> std::error::Error for Unread<T> {}

/// Reads the file `path`, which has so many bytes at most: its contents, or the intact ones with the defects.
pub(crate) fn read_file<T: Default>(
    path: &Path,
    most: usize,
    read: impl FnOnce(&[u8]) -> (T, Vec<String>),
) -> Result<T, Unread<T>> {
    let (whole, problems) = match contents(path, most) {
        Ok(bytes) => read(&bytes),
        Err(problem) => (T::default(), vec![problem]),
    };
    if problems.is_empty() {
        return Ok(whole);
    }
    Err(Unread { path: path.to_owned(), problems, whole: Box::new(whole) })
}

fn contents(path: &Path, most: usize) -> Result<Vec<u8>, String> {
    let said = |error: io::Error| error.to_string();
    let file = File::open(path).map_err(said)?;
    let length = usize::try_from(file.metadata().map_err(said)?.len()).unwrap_or(usize::MAX);
    if length > most {
        return Err(format!("it has {length} bytes, and {most} may be taken"));
    }
    let mut bytes = Vec::with_capacity(length);
    // A file may grow while it is read; a pipe has no length.
    file.take(most as u64).read_to_end(&mut bytes).map_err(said)?;
    Ok(bytes)
}
