//! Results of runs in a file: a zip archive of NumPy arrays and one `plm.json` (docs/src/running/results.md).

mod archive;
mod mechanism;
mod npy;
pub(crate) mod number;

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::Path;

use serde::{Deserialize, Serialize};

pub(crate) use archive::write as zipped;
pub use mechanism::{
    Body, Frame, GroundPort, Mechanism, Operations, Parameter, Part, Port, Quantity, Report,
};

use crate::error::{Error, Unread, read_file, write_file};
use crate::recording::{About, OF_GROUND, OF_POSE, Recording};

/// The word by which a results file is known.
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

/// What is looked at before the rest of `plm.json`.
#[derive(Deserialize)]
struct Kind {
    #[serde(default)]
    format: String,
    #[serde(default)]
    version: u32,
}

/// Runs that stand in one file.
#[derive(Clone, Debug, Default)]
pub struct Results {
    /// What wrote the file; of results that were not read, nothing.
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

    /// Reads a results file.
    ///
    /// # Errors
    /// If it cannot be read, is no results file, is cut off or damaged: the error says what is missing, and
    /// [`Unread::whole`] has all the rest. Numbers that are missing there are NaN.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Unread<Self>> {
        read_file(path.as_ref(), Self::from_bytes)
    }

    /// What these bytes of a results file hold, and what is missing or wrong; nothing if all is well.
    pub fn from_bytes(bytes: &[u8]) -> (Self, Vec<String>) {
        if !bytes.starts_with(b"PK") {
            return (Self::default(), vec!["it is no results file: no zip archive".to_owned()]);
        }
        let (entries, mut problems) = archive::read(bytes);
        let mut entries: BTreeMap<String, archive::Entry> =
            entries.into_iter().map(|entry| (entry.name.clone(), entry)).collect();
        let found = entries.remove(HEAD).ok_or_else(|| format!("{HEAD} is missing"));
        let head = match found.and_then(|entry| head(&entry)) {
            Ok(head) => head,
            Err(problem) => {
                problems.insert(0, problem);
                return (Self::default(), problems);
            }
        };
        let runs = head.runs.into_iter().enumerate();
        let runs = runs.map(|(run, about)| recording(run, about, &mut entries, &mut problems)).collect();
        (Self { made_by: head.made_by, runs }, problems)
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

fn head(entry: &archive::Entry) -> Result<Head, String> {
    if entry.is_cut_off {
        return Err(format!("{HEAD} is cut off"));
    }
    let wrong = |error: serde_json::Error| format!("{HEAD}: {error}");
    let Kind { format, version } = serde_json::from_slice(&entry.bytes).map_err(wrong)?;
    if format != FORMAT {
        return Err(format!("it is no results file: the format in {HEAD} is not `{FORMAT}`"));
    }
    if version != VERSION {
        return Err(format!("it is of version {version} of the format; {VERSION} can be read"));
    }
    serde_json::from_slice(&entry.bytes).map_err(wrong)
}

/// A run, as far as its arrays are there.
fn recording(
    run: usize,
    about: About,
    entries: &mut BTreeMap<String, archive::Entry>,
    problems: &mut Vec<String>,
) -> Recording {
    let mut array = |name: &str, fits: &dyn Fn(&[usize]) -> bool| {
        let name = format!("{run}/{name}.npy");
        let (numbers, problem) = numbers(entries.remove(&name), fits);
        problems.extend(problem.map(|problem| format!("{name} {problem}")));
        numbers
    };
    let times = array("time", &|shape| shape.len() == 1);
    let rows = times.len();
    let tables = TABLES.each_ref().map(|of| {
        let Some(expected) = (of.shape)(rows, &about) else { return Vec::new() };
        // Of times that were cut off there may be fewer.
        array(of.name, &|shape| shape.len() == expected.len() && shape[1..] == expected[1..])
    });
    let mut recording = Recording::empty(about);
    recording.fill(times, tables);
    recording
}

/// The numbers of an array as far as they came, and what is wrong.
fn numbers(entry: Option<archive::Entry>, fits: &dyn Fn(&[usize]) -> bool) -> (Vec<f64>, Option<String>) {
    let Some(entry) = entry else { return (Vec::new(), Some("is missing".to_owned())) };
    let array = match npy::read(&entry.bytes) {
        Ok(array) => array,
        Err(_) if entry.is_cut_off => return (Vec::new(), Some("is cut off".to_owned())),
        Err(problem) => return (Vec::new(), Some(problem)),
    };
    if !fits(&array.shape) {
        return (Vec::new(), Some(format!("has the shape {:?}, which {HEAD} does not say", array.shape)));
    }
    let rows = array.shape.first().copied().unwrap_or_default();
    let width: usize = array.shape.iter().skip(1).product();
    let (expected, mut numbers) = (rows * width, array.numbers);
    if numbers.len() >= expected {
        numbers.truncate(expected);
        return (numbers, None);
    }
    let came = numbers.len().checked_div(width).unwrap_or_default();
    numbers.truncate(came * width);
    (numbers, Some(format!("is cut off after {came} of {rows} rows")))
}
