//! Studies: many runs of a mechanism, cut into shards that run as processes of their own, on one machine or on many.
//!
//! A [`Study`] has points, a function that makes a row of numbers of a point, and names for both. Point number i is a function of
//! i alone ([`Points`]), so that every process can make it. Of every n points that follow each other, shard k of n has one: neighbours on a grid cost alike,
//! so that shards cut in this way take about the same time.
//!
//! Each shard appends its rows to a log of its own as they come. A process that is ended loses the points at which it was; what
//! runs the shard again computes those that are not there. [`Study::gather`] reads all logs of a folder and puts the rows in
//! the order of the points: the same bytes, whatever the number of shards, threads and interruptions.
//!
//! [`Study::main`] is a whole program with a command line, which hands the shards to Slurm or HyperQueue too. The book has an
//! example (`docs/src/running/many-machines.md`).

mod command;
mod gathered;
mod log;
mod points;
mod random;
mod rows;
mod shard;
mod submit;
mod table;

use std::collections::BTreeSet;
use std::fmt;
use std::fmt::Write;
use std::path::Path;

pub use gathered::{Gathered, Outcome};
pub use points::{Points, Spread, linear};
pub use rows::{Rows, To};
pub use shard::{Ran, Shard};

/// A study of P parameters that gives C columns.
///
/// ```
/// use plm::study::{Points, Shard, Study, linear};
///
/// let points = Points::grid([("x", "m", linear(0.0, 1.0, 11)), ("y", "m", vec![1.0, 2.0])]);
/// let study = Study::new("areas", points, [("area", "m^2")], |[x, y]| {
///     if x < 0.95 { Ok([x * y]) } else { Err("too wide") }
/// });
/// let folder = std::env::temp_dir().join("plm-areas");
/// # let _ = std::fs::remove_dir_all(&folder);
/// study.run(&folder, Shard::parse("2/2")?, 1)?;
/// study.run(&folder, Shard::parse("1/2")?, 1)?;
/// let gathered = study.gather(&folder)?;
/// assert_eq!(gathered.missing().count(), 0);
/// assert_eq!(gathered.outcome(7), Some(&Ok([0.3 * 2.0])));
/// assert_eq!(gathered.failed().map(|(index, _)| index).collect::<Vec<_>>(), [20, 21]);
/// gathered.write(&folder.join("areas.csv"))?;
/// # std::fs::remove_dir_all(&folder).unwrap();
/// # Ok::<(), plm::study::Problem>(())
/// ```
#[derive(Clone, Debug)]
pub struct Study<F, const P: usize, const C: usize> {
    plan: Plan<P, C>,
    row: F,
    stack: usize,
}

/// Properties that two processes must have in common to work on the same study.
#[derive(Clone, Debug)]
struct Plan<const P: usize, const C: usize> {
    name: String,
    revision: String,
    points: Points<P>,
    columns: [Quantity; C],
}

/// The name of a parameter or a column, and its unit.
#[derive(Clone, Debug, PartialEq)]
struct Quantity {
    name: String,
    unit: String,
}

impl From<(&str, &str)> for Quantity {
    fn from((name, unit): (&str, &str)) -> Self {
        Self { name: name.to_owned(), unit: unit.to_owned() }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)?;
        if self.unit.is_empty() { Ok(()) } else { write!(f, " in {}", self.unit) }
    }
}

/// Reason why a study does not go on, as a text for its user.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
#[derive(Clone, PartialEq)]
pub struct Problem(String);

impl Problem {
    fn new(words: impl Into<String>) -> Self {
        Self(words.into())
    }

    /// A problem with a file.
    fn file(path: &Path, error: impl fmt::Display) -> Self {
        Self(format!("{}: {error}", path.display()))
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Debug for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for Problem {}

impl<F, E, const P: usize, const C: usize> Study<F, P, C>
where
    F: Fn([f64; P]) -> Result<[f64; C], E>,
{
    /// A study under this name. `row` computes the columns, (name, unit), of a point, or an error; it must be a function of the point
    /// alone. Units are labels of the table: values are written without conversion.
    pub fn new(name: &str, points: Points<P>, columns: [(&str, &str); C], row: F) -> Self {
        Self::of(name, points, columns, row)
    }
}

impl<S, R, const P: usize, const C: usize> Study<To<S, R>, P, C> {
    /// A study of simulations that run to a time, s: `start` assembles that of a point, and `row` computes its columns there. Each core has
    /// several of them side by side, as those of [`batch::Points::run_to`](crate::batch::Points::run_to).
    pub fn to(
        name: &str,
        points: Points<P>,
        columns: [(&str, &str); C],
        until: f64,
        (start, row): (S, R),
    ) -> Self
    where
        To<S, R>: Rows<P, C>,
    {
        Self::of(name, points, columns, To { until, start, row })
    }
}

impl<F, const P: usize, const C: usize> Study<F, P, C> {
    fn of(name: &str, points: Points<P>, columns: [(&str, &str); C], row: F) -> Self {
        let columns = columns.map(Quantity::from);
        let plan = Plan { name: name.to_owned(), revision: String::new(), points, columns };
        Self { plan, row, stack: crate::batch::STACK }
    }

    /// Sets a text that must change whenever the row of a point changes: duration of a run, method. Logs of another revision are refused.
    #[must_use]
    pub fn revision(mut self, words: &str) -> Self {
        words.clone_into(&mut self.plan.revision);
        self
    }

    /// With so many bytes of stack for each thread; see [`batch::Points::stack`](crate::batch::Points::stack).
    #[must_use]
    pub fn stack(self, bytes: usize) -> Self {
        Self { stack: bytes, ..self }
    }

    /// The points of the study in the logs of a folder.
    ///
    /// # Errors
    /// A folder or a log that cannot be read, a log of another study, or two logs that differ about a point.
    pub fn gather(&self, folder: &Path) -> Result<Gathered<P, C>, Problem> {
        self.plan.check()?;
        Gathered::read(&self.plan, folder)
    }
}

impl<const P: usize, const C: usize> Plan<P, C> {
    /// Text of the whole plan, at the head of every log. The number of Monte Carlo points is not part of it: it may grow.
    fn description(&self) -> String {
        let mut text = format!("plm study log 1\nstudy {}\nrevision {}\n", self.name, self.revision);
        text.push_str(&self.points.description());
        for column in &self.columns {
            let _ = writeln!(text, "column {column}");
        }
        text.push('\n');
        text
    }

    /// Are all names there, and different?
    fn check(&self) -> Result<(), Problem> {
        let mut seen = BTreeSet::from(["index", "failed", "fault"]);
        for Quantity { name, .. } in self.points.quantities.iter().chain(&self.columns) {
            let plain = |letter: char| letter.is_ascii_alphanumeric() || "._-".contains(letter);
            if name.is_empty() || !name.chars().all(plain) {
                return Err(Problem(format!(
                    "a parameter or column is called `{name}`; letters (a to z), digits, `.`, `_` and `-` make a name"
                )));
            }
            if !seen.insert(name) {
                return Err(Problem(format!(
                    "two columns of the table would be called `{name}` (index, failed and fault are there already)"
                )));
            }
        }
        let is_line = |text: &str| !text.chars().any(char::is_control);
        let units = self.points.quantities.iter().chain(&self.columns).map(|quantity| &quantity.unit);
        match units.chain([&self.name, &self.revision]).find(|text| !is_line(text)) {
            Some(text) => {
                Err(Problem(format!("{text:?} has a line break or another control character in it")))
            }
            None => Ok(()),
        }
    }
}
