//! The archive around a results file, a zip.

use std::collections::BTreeMap;
use std::io::{self, Cursor, Read, Write};

use zip::read::{ZipFile, read_zipfile_from_stream};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use super::budget::Budget;

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

/// An archive to be read. Nothing of it is unpacked before it is asked for.
pub(super) enum Archive<'a> {
    /// With the directory at its end, which alone says where each entry is. Entries that were written to a stream do not know
    /// their length before they end.
    Whole(Box<ZipArchive<Cursor<&'a [u8]>>>),
    /// Without it: the entries as they follow each other from the beginning, and where each of them begins.
    Cut { bytes: &'a [u8], starts: BTreeMap<String, usize> },
}

/// Contents of an entry.
pub(super) enum Entry {
    /// All of it.
    Whole(Vec<u8>),
    /// The bytes before the end of the file, which is within the entry.
    CutOff(Vec<u8>),
}

impl<'a> Archive<'a> {
    /// The archive in these bytes, and its defect as a whole.
    ///
    /// Without a directory all entries before the cut are found.
    pub(super) fn new(bytes: &'a [u8]) -> (Self, Option<String>) {
        if let Ok(zip) = ZipArchive::new(Cursor::new(bytes)) {
            return (Self::Whole(Box::new(zip)), None);
        }
        let (starts, problem) = starts(bytes);
        (Self::Cut { bytes, starts }, Some(problem))
    }

    /// Unpacks an entry; none if there is none of this name.
    ///
    /// # Errors
    /// If it is damaged, or larger than the rest of the budget: a text that continues after its name.
    pub(super) fn entry(&mut self, name: &str, budget: &Budget) -> Option<Result<Entry, String>> {
        match self {
            Self::Whole(zip) => {
                let file = zip.by_index(zip.index_for_name(name)?);
                let outcome =
                    file.map_err(|_| DAMAGED.to_owned()).and_then(|mut file| unpacked(&mut file, budget));
                Some(outcome.and_then(|(bytes, is_whole)| {
                    if is_whole { Ok(Entry::Whole(bytes)) } else { Err(DAMAGED.to_owned()) }
                }))
            }
            Self::Cut { bytes, starts } => {
                let mut rest = bytes.get(*starts.get(name)?..)?;
                // After this line the stream stands after the entry.
                let outcome = unpacked(&mut read_zipfile_from_stream(&mut rest).ok()??, budget);
                Some(outcome.and_then(|(bytes, is_whole)| match (is_whole, rest) {
                    (true, _) => Ok(Entry::Whole(bytes)),
                    (false, []) => Ok(Entry::CutOff(bytes)),
                    (false, _) => Err(DAMAGED.to_owned()),
                }))
            }
        }
    }
}

const DAMAGED: &str = "is damaged";

/// The contents of an entry as far as they come, and whether they are all that it promises: length and check sum.
fn unpacked<R: Read>(file: &mut ZipFile<'_, R>, budget: &Budget) -> Result<(Vec<u8>, bool), String> {
    let length = file.size();
    let mut bytes = budget.room(usize::try_from(length).unwrap_or(usize::MAX))?;
    let came = file.by_ref().take(length).read_to_end(&mut bytes);
    // The check sum is verified at the end.
    let is_whole =
        came.is_ok_and(|came| came as u64 == length) && file.read(&mut [0]).is_ok_and(|more| more == 0);
    Ok((bytes, is_whole))
}

/// Offsets of entries that follow each other from the beginning of a file, and why there are no more.
fn starts(bytes: &[u8]) -> (BTreeMap<String, usize>, String) {
    let (mut rest, mut starts) = (bytes, BTreeMap::new());
    loop {
        let start = bytes.len() - rest.len();
        let next = read_zipfile_from_stream(&mut rest);
        let problem = match next.map(|file| file.map(|file| file.name().to_owned())) {
            Ok(Some(name)) => {
                starts.insert(name, start);
                continue;
            }
            Ok(None) => "the directory at its end is cut off or damaged".to_owned(),
            Err(_) if rest.is_empty() => "it is cut off".to_owned(),
            Err(error) => format!("{error}, {} bytes from its end", rest.len()),
        };
        return (starts, problem);
    }
}
