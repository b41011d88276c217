//! Reads the bytes of a results file, as far as they are whole.

use serde::Deserialize;

use super::archive::{Archive, Entry};
use super::budget::Budget;
use super::{FORMAT, HEAD, Head, Results, TABLES, VERSION, npy};
use crate::recording::{About, Recording};

/// Memory of the parsed `plm.json`, at most, as a multiple of its length: for the smallest values that it can list.
const HEAD_GROWS: usize = 16;

/// Fields that are checked before the rest of `plm.json`.
#[derive(Deserialize)]
struct Kind {
    #[serde(default)]
    format: String,
    #[serde(default)]
    version: u32,
}

/// A results file while it is read.
struct Reading<'a> {
    archive: Archive<'a>,
    budget: Budget,
    problems: Vec<String>,
}

/// An array as far as it came.
#[derive(Default)]
struct Column {
    numbers: Vec<f64>,
    /// Rows that it says it has, if it is whole.
    rows: Option<usize>,
}

/// Contents of these bytes, and their defects.
pub(super) fn results(bytes: &[u8], most: usize) -> (Results, Vec<String>) {
    if !bytes.starts_with(b"PK") {
        return (Results::default(), vec!["it is no results file: no zip archive".to_owned()]);
    }
    let (archive, problem) = Archive::new(bytes);
    let mut reading = Reading { archive, budget: Budget::new(most), problems: problem.into_iter().collect() };
    match reading.head() {
        Ok(head) => {
            let runs = head.runs.into_iter().enumerate();
            let runs = runs.map(|(run, about)| reading.run(run, about)).collect();
            (Results { made_by: head.made_by, runs }, reading.problems)
        }
        Err(problem) => {
            reading.problems.insert(0, problem);
            (Results::default(), reading.problems)
        }
    }
}

impl Reading<'_> {
    fn head(&mut self) -> Result<Head, String> {
        let named = |problem: String| format!("{HEAD} {problem}");
        let bytes = match self.archive.entry(HEAD, &self.budget) {
            None => return Err(named("is missing".to_owned())),
            Some(Ok(Entry::CutOff(_))) => return Err(named("is cut off".to_owned())),
            Some(Ok(Entry::Whole(bytes))) => bytes,
            Some(Err(problem)) => return Err(named(problem)),
        };
        self.budget.take(bytes.len().saturating_mul(HEAD_GROWS)).map_err(named)?;
        let wrong = |error: serde_json::Error| format!("{HEAD}: {error}");
        let Kind { format, version } = serde_json::from_slice(&bytes).map_err(wrong)?;
        if format != FORMAT {
            return Err(format!("it is no results file: the format in {HEAD} is not `{FORMAT}`"));
        }
        if version != VERSION {
            return Err(format!("it is of version {version} of the format; {VERSION} can be read"));
        }
        serde_json::from_slice(&bytes).map_err(wrong)
    }

    /// A run, as far as its arrays are there.
    fn run(&mut self, run: usize, about: About) -> Recording {
        let times = self.array(&format!("{run}/time.npy"), &|shape| shape.len() == 1);
        let rows = times.numbers.len();
        let tables = TABLES.each_ref().map(|of| {
            let Some(expected) = (of.shape)(rows, &about) else { return Vec::new() };
            let name = format!("{run}/{}.npy", of.name);
            let fits = |shape: &[usize]| shape.len() == expected.len() && shape[1..] == expected[1..];
            let Column { numbers, rows: own } = self.array(&name, &fits);
            // Of times that are cut off there may be fewer.
            if let (Some(own), Some(all)) = (own, times.rows)
                && own != all
            {
                self.problems.push(format!("{name} has {own} rows where there are {all} times"));
            }
            numbers
        });
        let mut recording = Recording::empty(about);
        match self.gaps(&recording, rows, &tables) {
            Ok(()) => recording.fill(times.numbers, tables),
            Err(problem) => {
                self.problems.push(format!("what is missing of run {run} {problem}; its rows are left out"));
            }
        }
        recording
    }

    /// Takes room for numbers that are missing.
    fn gaps(&mut self, recording: &Recording, rows: usize, tables: &[Vec<f64>]) -> Result<(), String> {
        let all = recording.tables().map(|table| rows.saturating_mul(table.width()));
        let missing = all.into_iter().zip(tables).map(|(all, table)| all.saturating_sub(table.len()));
        let missing = missing.fold(0, usize::saturating_add);
        self.budget.take(missing.saturating_mul(size_of::<f64>()))
    }

    /// An array, as far as it came; its defects are reported.
    fn array(&mut self, name: &str, fits: &dyn Fn(&[usize]) -> bool) -> Column {
        let (column, problem) = self.column(name, fits);
        self.problems.extend(problem.map(|problem| format!("{name} {problem}")));
        column
    }

    fn column(&mut self, name: &str, fits: &dyn Fn(&[usize]) -> bool) -> (Column, Option<String>) {
        let (bytes, is_cut_off) = match self.archive.entry(name, &self.budget) {
            None => return (Column::default(), Some("is missing".to_owned())),
            Some(Ok(Entry::Whole(bytes))) => (bytes, false),
            Some(Ok(Entry::CutOff(bytes))) => (bytes, true),
            Some(Err(problem)) => return (Column::default(), Some(problem)),
        };
        let array = match npy::read(&bytes) {
            Ok(array) => array,
            Err(_) if is_cut_off => return (Column::default(), Some("is cut off".to_owned())),
            Err(problem) => return (Column::default(), Some(problem)),
        };
        if !fits(&array.shape) {
            let problem = format!("has the shape {:?}, which {HEAD} does not say", array.shape);
            return (Column::default(), Some(problem));
        }
        let read = self.budget.meanwhile(bytes.capacity(), |budget| numbers(&array, budget));
        match read.and_then(|read| read) {
            Ok(read) => read,
            Err(problem) => (Column::default(), Some(problem)),
        }
    }
}

/// The numbers of an array as far as they came, row by row, and their defect.
///
/// # Errors
/// If they take more than the rest of the budget.
fn numbers(array: &npy::Array, budget: &mut Budget) -> Result<(Column, Option<String>), String> {
    let rows = array.shape.first().copied().unwrap_or_default();
    // No array is as long as the largest number.
    let width = array.shape.iter().skip(1).fold(1, |width: usize, length| width.saturating_mul(*length));
    let expected = rows.saturating_mul(width);
    let (count, problem) = if array.len() >= expected {
        (expected, None)
    } else {
        let came = array.len().checked_div(width).unwrap_or_default();
        (came * width, Some(format!("is cut off after {came} of {rows} rows")))
    };
    let mut numbers = budget.room(count)?;
    budget.take(count * size_of::<f64>())?;
    array.read_into(&mut numbers, count);
    Ok((Column { numbers, rows: problem.is_none().then_some(rows) }, problem))
}
