//! The folder of a server: the only one whose files calls read and write.

use std::fs;
use std::path::{Component, Path, PathBuf};

use plm_compiler::token::Sources;
use plm_compiler::without_panic;

use crate::excerpt::excerpts;
use crate::read;

/// A folder that is there.
pub(super) struct Folder(PathBuf);

impl Folder {
    /// # Errors
    /// There is no such folder.
    pub(super) fn new(path: &str) -> Result<Folder, String> {
        let root = fs::canonicalize(path).map_err(|why| format!("{path}: {why}"))?;
        if root.is_dir() { Ok(Folder(root)) } else { Err(format!("{path}: is no folder")) }
    }

    pub(super) fn root(&self) -> &Path {
        &self.0
    }

    /// The name of a file or folder within this one, which need not be there yet.
    ///
    /// # Errors
    /// It is absolute, goes up by `..`, or leads through a link.
    pub(super) fn within<'a>(&self, name: &'a str) -> Result<&'a str, String> {
        let path = Path::new(name);
        if name.is_empty() || name == "-" || name.contains('\0') {
            return Err(format!("`{name}` is no name of a file"));
        }
        let is_stream = cfg!(windows) && name.contains(':');
        if path.is_absolute() || path.has_root() || is_stream {
            return Err(format!("{name}: names of files are relative to the folder of the server"));
        }
        let mut at = self.0.clone();
        for part in path.components() {
            match part {
                Component::CurDir => {}
                Component::Normal(part) => at.push(part),
                _ => {
                    return Err(format!(
                        "{name}: is outside the folder of the server, which `..` does not leave"
                    ));
                }
            }
            if fs::symlink_metadata(&at).is_ok_and(|found| found.is_symlink()) {
                return Err(format!("{name}: leads through a link, which is not followed"));
            }
        }
        Ok(name)
    }

    /// Are the files within the folder that a declaration names, such as contours?
    ///
    /// # Errors
    /// As [`Folder::within`], of one of them.
    pub(super) fn holds_all_of(&self, name: &str, text: &str) -> Result<(), String> {
        let text = text.replace("\r\n", "\n");
        let named = || {
            let mut all = Vec::new();
            for excerpt in excerpts(name, &text).found {
                let mut sources = Sources::new();
                match excerpt.masked(&text) {
                    Some(masked) => sources.add_excerpt(name, &text, &masked),
                    None => sources.add_text(name, &text),
                };
                all.extend(sources.named_files());
            }
            all
        };
        let all = without_panic(named).map_err(|bug| plm_compiler::bug_message(&bug))?;
        all.iter().try_for_each(|file| {
            // A part of its own goes first: `join` drops all before an absolute one.
            self.within(file)?;
            let place = read::place_of(file, name, &self.0);
            self.within(&place.to_string_lossy()).map(|_| ())
        })
    }
}
