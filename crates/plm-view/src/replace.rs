//! Files that are replaced as a whole, or stay as they were.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// Writes `contents` to the file `path`, which is afterwards whole or as it was before: they are written to a new file beside it, which
/// takes its name when all of it has come to the disk. Permissions stay, and a link stays one. What is no file (a device, a pipe) is
/// written as it stands.
///
/// # Errors
/// A file that may not be written, a folder in which no file can be made, a full disk.
pub fn replace_file(path: &Path, contents: &[u8]) -> io::Result<()> {
    let target = match fs::canonicalize(path) {
        Ok(target) => target,
        // A link to a file that is not there yet leads to where it is made: there is nothing to lose.
        Err(_) if path.is_symlink() => return fs::write(path, contents),
        Err(why) if why.kind() == io::ErrorKind::NotFound => path.to_owned(),
        Err(why) => return Err(why),
    };
    let present = fs::metadata(&target).ok();
    if present.as_ref().is_some_and(|present| !present.is_file()) {
        return fs::write(&target, contents);
    }
    if present.is_some() {
        // A new name would get round the file's own permissions.
        OpenOptions::new().write(true).open(&target)?;
    }
    let (part, file) = part_beside(&target)?;
    let done = whole(file, contents, present.map(|present| present.permissions()))
        .and_then(|()| fs::rename(&part, &target));
    if done.is_err() {
        // The first error is reported.
        let _ = fs::remove_file(&part);
    }
    done
}

/// A new file in the folder of another one.
fn part_beside(target: &Path) -> io::Result<(PathBuf, File)> {
    static COUNT: AtomicU32 = AtomicU32::new(0);
    let name = target.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    loop {
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let mut own = OsString::from(".");
        own.push(name);
        own.push(format!(".{}-{number}.part", std::process::id()));
        let part = target.with_file_name(own);
        match OpenOptions::new().write(true).create_new(true).open(&part) {
            // A program of the same number was ended here before.
            Err(why) if why.kind() == io::ErrorKind::AlreadyExists && number < u32::MAX => {}
            made => return made.map(|file| (part, file)),
        }
    }
}

/// Writes a file until it is on the disk: some file systems report only then that they are full.
fn whole(mut file: File, contents: &[u8], permissions: Option<fs::Permissions>) -> io::Result<()> {
    file.write_all(contents)?;
    if let Some(permissions) = permissions {
        file.set_permissions(permissions)?;
    }
    file.sync_all()
}
