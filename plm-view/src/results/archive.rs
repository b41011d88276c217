//! The archive around a results file, a zip.

use std::io::{self, Cursor, Read, Write};

use zip::read::read_zipfile_from_stream;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

/// An entry as it was read.
pub(super) struct Entry {
    pub(super) name: String,
    /// Its contents, as far as they came.
    pub(super) bytes: Vec<u8>,
    /// Does the file end within it?
    pub(super) is_cut_off: bool,
}

/// An archive of these entries, name and contents, in their order.
pub(crate) fn write(entries: impl IntoIterator<Item = (String, Vec<u8>)>) -> io::Result<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (name, bytes) in entries {
        zip.start_file(name, options)?;
        zip.write_all(&bytes)?;
    }
    Ok(zip.finish()?.into_inner())
}

/// The entries of an archive, and what is wrong with it.
///
/// They are read one after the other from the beginning, so that of a file that is cut off all is there that came before
/// the cut; the directory of an archive stands at its end.
pub(super) fn read(bytes: &[u8]) -> (Vec<Entry>, Vec<String>) {
    let (mut rest, mut entries, mut problems) = (bytes, Vec::new(), Vec::new());
    loop {
        match next(&mut rest) {
            Ok(Some((entry, is_whole))) => {
                let is_cut_off = !is_whole && rest.is_empty();
                if is_whole || is_cut_off {
                    entries.push(Entry { is_cut_off, ..entry });
                } else {
                    problems.push(format!("{} is damaged", entry.name));
                }
            }
            Ok(None) => {
                if problems.is_empty() && ZipArchive::new(Cursor::new(bytes)).is_err() {
                    problems.push("the directory at its end is cut off or damaged".to_owned());
                }
                return (entries, problems);
            }
            Err(_) if rest.is_empty() => {
                problems.push("it is cut off".to_owned());
                return (entries, problems);
            }
            Err(error) => {
                problems.push(format!("{error}, {} bytes from its end", rest.len()));
                return (entries, problems);
            }
        }
    }
}

/// The next entry, and whether it is whole.
fn next(rest: &mut &[u8]) -> zip::result::ZipResult<Option<(Entry, bool)>> {
    let Some(mut file) = read_zipfile_from_stream(rest)? else { return Ok(None) };
    let (name, mut bytes) = (file.name().to_owned(), Vec::new());
    let is_whole = file.read_to_end(&mut bytes).is_ok();
    Ok(Some((Entry { name, bytes, is_cut_off: false }, is_whole)))
}
