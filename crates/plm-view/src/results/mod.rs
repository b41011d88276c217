//! Results of runs in a file: a zip archive of NumPy arrays and one `plm.json` (docs/src/running/results.md).
//!
//! Most languages read such a file without a library of ours. Entries are read from the beginning of the file: the directory of a
//! zip archive is at its end, which a truncated file has lost.

mod archive;
mod budget;
mod mechanism;
mod npy;
pub(crate) mod number;
mod read;

use std::collections::BTreeSet;
use std::io;
use std::path::Path;

use serde::{Deserialize, Serialize};

pub(crate) use archive::write as zipped;
pub use mechanism::{Body, Frame, GroundPort, Mechanism, Parameter, Part, Port, Quantity, Report, Shape};

use crate::error::{Error, Unread, read_file, write_file};
use crate::recording::{About, OF_GROUND, OF_POSE, Recording};

/// The text that identifies a results file.
const FORMAT: &str = "plm results";
/// The version of the format that is written and read here.
const VERSION: u32 = 1;
/// The entry that stands beside the arrays.
const HEAD: &str = "plm.json";

/// The contents of `plm.json`.
#[derive(Serialize, Deserialize)]
struct Head {
    format: String,
    version: u32,
    made_by: String,
    runs: Vec<About>,
}

/// Runs that stand in one file.
#[derive(Clone, Debug, Default)]
pub struct Results {
    /// Program that wrote the file; empty for results that were not read.
    pub made_by: String,
    /// The runs.
    pub runs: Vec<Recording>,
}

impl From<Recording> for Results {
    fn from(run: Recording) -> Self {
        [run].into_iter().collect()
    }
}

impl FromIterator<Recording> for Results {
    fn from_iter<T: IntoIterator<Item = Recording>>(runs: T) -> Self {
        Self { made_by: String::new(), runs: runs.into_iter().collect() }
    }
}

impl Recording {
    /// Writes the recording as a results file; see [`Results::write`].
    ///
    /// # Errors
    /// As [`Results::write`].
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        write_file(path.as_ref(), bytes(&[self]))
    }
}

impl Results {
    /// Writes the runs as a results file (`.npz`) and makes the folders above it where they are missing. Runs without a name,
    /// or with that of another, get one.
    ///
    /// # Errors
    /// If the file cannot be written, or a row has not a number for each column; the error names the file.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        write_file(path.as_ref(), self.to_bytes())
    }

    /// The contents of a results file; the same runs give the same bytes.
    ///
    /// # Errors
    /// If a row has not a number for each column.
    pub fn to_bytes(&self) -> io::Result<Vec<u8>> {
        bytes(&self.runs.iter().collect::<Vec<&Recording>>())
    }

    /// Bytes that [`read`](Self::read) takes at most for what a file holds: 1 GiB, of numbers 134 million.
    pub const MOST_BYTES: usize = 1 << 30;

    /// Reads a results file, which may take [`MOST_BYTES`](Self::MOST_BYTES).
    ///
    /// # Errors
    /// If it cannot be read, is no results file, is cut off, damaged or too large: the error says what is missing, and
    /// [`Unread::whole`] has all the rest. Numbers that are missing there are NaN.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Unread<Self>> {
        Self::read_within(path, Self::MOST_BYTES)
    }

    /// Reads a results file, which may take so many bytes: itself, and unpacked what it holds, with what an array takes
    /// while it is unpacked. Some bytes of a file can stand for a thousand times as many numbers.
    ///
    /// The directory of the archive is not counted, which takes 20 times its own length.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_within(path: impl AsRef<Path>, most: usize) -> Result<Self, Unread<Self>> {
        read_file(path.as_ref(), most, |bytes| Self::from_bytes_within(bytes, most))
    }

    /// Contents of the bytes of a results file, and its defects; none if all is well. It takes [`MOST_BYTES`](Self::MOST_BYTES) at most.
    pub fn from_bytes(bytes: &[u8]) -> (Self, Vec<String>) {
        Self::from_bytes_within(bytes, Self::MOST_BYTES)
    }

    /// As [`from_bytes`](Self::from_bytes), with so many bytes at most; see [`read_within`](Self::read_within).
    pub fn from_bytes_within(bytes: &[u8], most: usize) -> (Self, Vec<String>) {
        read::results(bytes, most)
    }
}

fn bytes(runs: &[&Recording]) -> io::Result<Vec<u8>> {
    runs.iter().try_for_each(|run| run.check())?;
    let mut names = BTreeSet::new();
    let about =
        runs.iter().map(|run| About { name: unique(&run.about.name, &mut names), ..run.about.clone() });
    let head = Head {
        format: FORMAT.to_owned(),
        version: VERSION,
        made_by: concat!("plm ", env!("CARGO_PKG_VERSION")).to_owned(),
        runs: about.collect(),
    };
    let mut entries = vec![(HEAD.to_owned(), serde_json::to_vec(&head)?)];
    for (k, run) in runs.iter().enumerate() {
        let rows = run.len();
        entries.push((format!("{k}/time.npy"), npy::write(&[rows], run.times())));
        for (of, table) in TABLES.iter().zip(run.tables()) {
            if let Some(shape) = (of.shape)(rows, &run.about) {
                entries.push((format!("{k}/{}.npy", of.name), npy::write(&shape, table.numbers())));
            }
        }
    }
    archive::write(entries)
}

/// An array of a run, beside the times.
struct Kept {
    name: &'static str,
    /// Its shape; none where a run has no such array.
    shape: fn(usize, &About) -> Option<Vec<usize>>,
}

/// In the order of [`Recording::tables`].
const TABLES: [Kept; 3] = [
    Kept { name: "poses", shape: |rows, about| Some(vec![rows, about.mechanism.bodies.len(), OF_POSE]) },
    Kept {
        name: "ground",
        shape: |rows, about| {
            let Mechanism { ground, .. } = &about.mechanism;
            about.mechanism.ground_moves().then(|| vec![rows, ground.len(), OF_GROUND])
        },
    },
    Kept { name: "values", shape: |rows, about| Some(vec![rows, about.columns.len()]) },
];

/// A name that no other run has.
fn unique(name: &str, taken: &mut BTreeSet<String>) -> String {
    let name = if name.is_empty() { "run" } else { name };
    let others = (2..).map(|k| format!("{name} ({k})"));
    let free = std::iter::once(name.to_owned()).chain(others).find(|name| !taken.contains(name));
    let free = free.unwrap_or_default();
    taken.insert(free.clone());
    free
}
