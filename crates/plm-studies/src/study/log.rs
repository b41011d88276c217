//! The log of a shard: the description of the study, then records of one length, appended as points are done.
//!
//! A record is the number of the point (8 bytes), what it holds (8), C numbers or a piece of a text (8 for each column, and for one
//! at least), and the checksum of all that (8), little endian. A text takes as many records as it needs. So what is cut off at the
//! end, or damaged in between, costs its own points and no other.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::gathered::Outcome;
use super::{Plan, Problem, Shard};

/// FNV-1a of 64 bits (G. Fowler, L. C. Noll, K.-P. Vo). Zeros, which a file system may leave behind, have another sum than 0.
pub(super) fn checksum(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// Tag of a record: a row, or a piece of a text with so many pieces after it, marked if it is the first.
const ROW: u64 = u64::MAX;
const FIRST: u64 = 1 << 32;
/// A number in a file.
const WORD: usize = 8;

/// Bytes of the contents of a record.
const fn room(columns: usize) -> usize {
    WORD * if columns == 0 { 1 } else { columns }
}

/// Bytes of a record.
const fn record_length(columns: usize) -> usize {
    room(columns) + 3 * WORD
}

fn word(bytes: &[u8], place: usize) -> u64 {
    let mut word = [0; WORD];
    word.copy_from_slice(&bytes[place * WORD..][..WORD]);
    u64::from_le_bytes(word)
}

/// Appends a record.
fn push(bytes: &mut Vec<u8>, index: usize, kind: u64, held: &[u8], columns: usize) {
    let start = bytes.len();
    bytes.extend((index as u64).to_le_bytes());
    bytes.extend(kind.to_le_bytes());
    bytes.extend(held);
    bytes.resize(start + 2 * WORD + room(columns), 0);
    bytes.extend(checksum(&bytes[start..]).to_le_bytes());
}

/// The records of a point.
fn records<const C: usize>(index: usize, outcome: &Outcome<C>) -> Vec<u8> {
    let mut bytes = Vec::new();
    match outcome {
        Ok(row) => push(&mut bytes, index, ROW, &row.map(f64::to_le_bytes).concat(), C),
        Err(text) => {
            // A text without letters takes a record too.
            let pieces = text.len().div_ceil(room(C)).max(1);
            for k in 0..pieces {
                let held = text.as_bytes().chunks(room(C)).nth(k).unwrap_or_default();
                let first = if k == 0 { FIRST } else { 0 };
                push(&mut bytes, index, first | (pieces - 1 - k) as u64, held, C);
            }
        }
    }
    bytes
}

/// Results of reading a log, beside its points.
#[derive(Clone, Debug, Default)]
pub(super) struct Reading {
    /// Bytes up to the end of the last point.
    end: u64,
    /// Records whose checksum is wrong, counted from 1.
    damaged: Vec<u64>,
    /// Some file systems have no locks: then nothing keeps two processes from running a shard.
    unlocked: Option<String>,
}

impl Reading {
    /// Defects of the log, a line each.
    pub(super) fn notes(&self, path: &Path) -> impl Iterator<Item = String> {
        let damaged = |number| format!("{}: record {number} is damaged and left out", path.display());
        self.damaged.iter().map(damaged).chain(self.unlocked.clone())
    }
}

/// A text as far as its pieces came.
struct Pieces {
    index: u64,
    left: u64,
    text: Vec<u8>,
}

impl<const P: usize, const C: usize> Plan<P, C> {
    /// Gives every point of a log to `take`. A description that is cut off is that of a log without points.
    fn read(
        &self,
        path: &Path,
        file: &File,
        take: &mut dyn FnMut(usize, Outcome<C>),
    ) -> Result<Reading, Problem> {
        let failed = |error: io::Error| Problem::file(path, error);
        let mut source = BufReader::new(file);
        let expected = self.description().into_bytes();
        let mut head = vec![0; expected.len()];
        let came = fill(&mut source, &mut head).map_err(failed)?;
        if head[..came] != expected[..came] {
            return Err(other_study(path, &head[..came], &expected));
        }
        let mut reading = Reading::default();
        if came < expected.len() {
            return Ok(reading);
        }
        reading.end = came as u64;
        let mut record = vec![0; record_length(C)];
        let (mut pieces, mut place, mut number) = (None, reading.end, 0);
        while fill(&mut source, &mut record).map_err(failed)? == record.len() {
            number += 1;
            place += record.len() as u64;
            let (held, sum) = record.split_at(record.len() - WORD);
            if checksum(held) != word(sum, 0) {
                reading.damaged.push(number);
                (pieces, reading.end) = (None, place);
            } else if let Some((index, outcome)) = decode(held, &mut pieces) {
                take(index, outcome);
                reading.end = place;
            }
        }
        Ok(reading)
    }

    /// Reads a log that others may be writing.
    pub(super) fn read_log(
        &self,
        path: &Path,
        take: &mut dyn FnMut(usize, Outcome<C>),
    ) -> Result<Reading, Problem> {
        let file = File::open(path).map_err(|error| Problem::file(path, error))?;
        self.read(path, &file, take)
    }

    /// Opens the log of a shard to append to it, and reads its points; an incomplete record at its end is removed.
    pub(super) fn open_log(
        &self,
        path: &Path,
        take: &mut dyn FnMut(usize, Outcome<C>),
    ) -> Result<(Log, Reading), Problem> {
        let failed = |error: io::Error| Problem::file(path, error);
        let options = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
        let mut file = options.map_err(failed)?;
        let mut unlocked = None;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                return Err(Problem::file(path, "another process runs this shard"));
            }
            Err(TryLockError::Error(error)) => unlocked = Some(error),
        }
        let mut reading = self.read(path, &file, take)?;
        reading.unlocked = unlocked.map(|error| format!("{}: it cannot be locked ({error})", path.display()));
        file.set_len(reading.end).map_err(failed)?;
        file.seek(SeekFrom::End(0)).map_err(failed)?;
        if reading.end == 0 {
            file.write_all(self.description().as_bytes()).map_err(failed)?;
        }
        Ok((Log { file, path: path.to_owned() }, reading))
    }
}

/// Fills as much as there is, and says how much that was.
fn fill(source: &mut impl Read, bytes: &mut [u8]) -> io::Result<usize> {
    let mut came = 0;
    while came < bytes.len() {
        match source.read(&mut bytes[came..]) {
            Ok(0) => break,
            Ok(more) => came += more,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(came)
}

/// The point that ends with this record.
fn decode<const C: usize>(held: &[u8], pieces: &mut Option<Pieces>) -> Option<(usize, Outcome<C>)> {
    let (index, kind, content) = (word(held, 0), word(held, 1), &held[2 * WORD..]);
    if kind == ROW {
        *pieces = None;
        return Some((index as usize, Ok(core::array::from_fn(|k| f64::from_bits(word(content, k))))));
    }
    let left = kind & (FIRST - 1);
    let mut so_far = if kind & FIRST == 0 {
        pieces.take().filter(|so_far| so_far.index == index && so_far.left == left + 1)?
    } else {
        Pieces { index, left, text: Vec::new() }
    };
    so_far.left = left;
    so_far.text.extend(content);
    if left > 0 {
        *pieces = Some(so_far);
        return None;
    }
    let text = String::from_utf8_lossy(&so_far.text);
    Some((index as usize, Err(text.trim_end_matches('\0').into())))
}

/// The first line in which a description is another one.
fn other_study(path: &Path, found: &[u8], expected: &[u8]) -> Problem {
    let [found, expected] = [found, expected].map(String::from_utf8_lossy);
    let mut pairs = found.lines().zip(expected.lines());
    let (found, expected) = pairs.find(|(found, expected)| found != expected).unwrap_or_default();
    let found: String = found.chars().filter(|letter| !letter.is_control()).take(200).collect();
    Problem::file(
        path,
        format!(
            "this log is of another study: it has `{found}`, this program `{expected}`; \
             name another folder by --folder, or take the old logs away"
        ),
    )
}

/// A log to which rows are appended, by one process at a time: it is locked.
pub(super) struct Log {
    file: File,
    path: PathBuf,
}

impl Log {
    /// Appends what came of a point, in one piece, and hands it to the system.
    pub(super) fn append<const C: usize>(
        &mut self,
        index: usize,
        outcome: &Outcome<C>,
    ) -> Result<(), Problem> {
        self.file.write_all(&records(index, outcome)).map_err(|error| Problem::file(&self.path, error))
    }
}

/// The logs in a folder, in the order of their shards; none where there is no folder.
pub(super) fn logs(folder: &Path) -> Result<Vec<(Shard, PathBuf)>, Problem> {
    let entries = match folder.read_dir() {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(Problem::file(folder, error)),
    };
    let mut found = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| Problem::file(folder, error))?.path();
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        found.extend(Shard::of_log(name).map(|shard| (shard, path.clone())));
    }
    found.sort_by_key(|(shard, _)| (shard.of, shard.number));
    Ok(found)
}
