//! Files and standard input, within bounds: a name that cannot be read is a message.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::excerpt::is_rust;

/// More than any declaration has: the compiler's own library is a tenth of it.
pub(crate) const LARGEST: u64 = 4 << 20;

/// More than drawings of parts have.
const LARGEST_DRAWING: u64 = 64 << 20;

/// A text and its name.
#[derive(Clone, Debug)]
pub(crate) struct File {
    /// The name in messages: `<stdin>` for the standard input.
    pub(crate) name: String,
    /// The text as it stands.
    pub(crate) text: String,
}

/// A file by its name, or the standard input, `-`.
///
/// # Errors
/// It cannot be read, is a folder, is not UTF-8, or has more than 4 MiB: a message that names it.
pub(crate) fn file(name: &str, input: &mut dyn Read) -> Result<File, String> {
    let (shown, text) = match name {
        "-" => ("<stdin>", text(input)),
        name => (name, text_of(Path::new(name))),
    };
    text.map(|text| File { name: shown.to_owned(), text }).map_err(|why| format!("{shown}: {why}"))
}

/// The bytes of a drawing, or of the standard input, `-`.
///
/// # Errors
/// It cannot be read, is a folder, or has more than 64 MiB: a message that names it.
pub(crate) fn drawing(name: &str, input: &mut dyn Read) -> Result<Vec<u8>, String> {
    let read = match name {
        "-" => bytes(input, LARGEST_DRAWING),
        name if Path::new(name).is_dir() => Err("is a folder".to_owned()),
        name => fs::File::open(name)
            .map_err(|why| why.to_string())
            .and_then(|mut file| bytes(&mut file, LARGEST_DRAWING)),
    };
    read.map_err(|why| format!("{name}: {why}"))
}

fn text_of(path: &Path) -> Result<String, String> {
    if path.is_dir() {
        return Err("is a folder".to_owned());
    }
    text(&mut fs::File::open(path).map_err(|why| why.to_string())?)
}

fn text(input: &mut dyn Read) -> Result<String, String> {
    let bytes = bytes(input, LARGEST)?;
    String::from_utf8(bytes).map_err(|why| format!("is not UTF-8 at byte {}", why.utf8_error().valid_up_to()))
}

fn bytes(input: &mut dyn Read, largest: u64) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    input.take(largest + 1).read_to_end(&mut bytes).map_err(|why| why.to_string())?;
    if bytes.len() as u64 > largest {
        return Err(format!("has more than {} MiB", largest >> 20));
    }
    Ok(bytes)
}

/// A file that a declaration names, as the macro looks for it: from the folder of Cargo.toml for a Rust file, else from the folder of
/// the declaration.
///
/// # Errors
/// It cannot be read.
pub(crate) fn named(name: &str, declaration: &str) -> Result<String, String> {
    text_of(&place_of(name, declaration, Path::new("")))
}

/// The place of such a file; that of the declaration is relative to `root`, as is the result.
pub(crate) fn place_of(name: &str, declaration: &str, root: &Path) -> PathBuf {
    let folder = Path::new(declaration).parent().unwrap_or(Path::new(""));
    let has_manifest = |folder: &&Path| root.join(folder).join("Cargo.toml").is_file();
    let package = || folder.ancestors().find(has_manifest).map(PathBuf::from);
    let folder = if is_rust(declaration) { package() } else { None }.unwrap_or_else(|| folder.to_owned());
    folder.join(name)
}
