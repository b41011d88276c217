//! Recordings of runs: samples over time, with the description of the mechanism.

mod csv;
mod table;

use std::io;

use serde::{Deserialize, Serialize};

use crate::results::Mechanism;
use crate::results::number::or_nan;
pub(crate) use table::Table;

/// Numbers of the pose of a body: x, y, angle of G, and their rates.
pub(crate) const OF_POSE: usize = 6;
/// Numbers of a port of the ground: x, y, angle.
pub(crate) const OF_GROUND: usize = 3;

/// Quantity in a row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// Name as in the declaration, such as `arm.angle`.
    pub name: String,
    /// Unit of the numbers as in the declaration, such as `N*m`; empty for a pure number.
    pub unit: String,
    /// A value in SI is one in this unit times the factor. `None` for SI itself, and if the factor is unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub factor: Option<f64>,
    /// Role of its numbers, which decides how they are drawn.
    #[serde(default, skip_serializing_if = "Role::is_motion")]
    pub role: Role,
}

/// Role of the numbers of a column.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// A quantity of a motion: a curve.
    #[default]
    Motion,
    /// Readings of a measurement: marks, and none where a number is NaN.
    Reading,
    /// Differences between a motion and its readings: marks in a chart of their own, since they are small.
    Residual,
}

impl Role {
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "the form that serde asks for")]
    fn is_motion(&self) -> bool {
        *self == Self::Motion
    }
}

impl Column {
    /// Sets the role.
    #[must_use]
    pub fn with_role(self, role: Role) -> Self {
        Self { role, ..self }
    }

    /// `arm.angle (deg)`; the name alone for a pure number.
    fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} ({})", self.name, self.unit) }
    }
}

impl<N: Into<String>, U: Into<String>> From<(N, U)> for Column {
    fn from((name, unit): (N, U)) -> Self {
        Self { name: name.into(), unit: unit.into(), factor: None, role: Role::default() }
    }
}

/// Something that switched.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// When, s.
    pub time: f64,
    /// What: the part or condition, as diagnostics name it.
    pub what: String,
    /// The first row after it; none if none came.
    pub row: Option<usize>,
}

/// Fault that ended a run before its time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fault {
    /// When, s.
    #[serde(deserialize_with = "or_nan")]
    pub time: f64,
    /// The part by its name in the declaration; empty where no single part is to blame.
    pub part: String,
    /// Text of the cause.
    pub text: String,
}

/// Description of a recording beside its numbers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct About {
    /// Name of the run, such as `mass = 3 kg`; unique in a file.
    pub name: String,
    /// The mechanism with its parameters; empty for a table of numbers.
    pub mechanism: Mechanism,
    /// By which method it ran.
    pub method: String,
    pub(crate) columns: Vec<Column>,
    /// Events, in the order of time.
    pub events: Vec<Event>,
    /// Fault that ended the run.
    pub fault: Option<Fault>,
    /// Notices to the user that did not end the run.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notices: Vec<String>,
}

/// Numbers of one moment.
#[derive(Clone, Copy, Debug, Default)]
pub struct Row<'a> {
    /// s.
    pub time: f64,
    /// x, y, angle of G and their rates, body by body: m, m, rad; m/s, m/s, rad/s.
    pub poses: &'a [f64],
    /// x, y, angle of the ports of the ground: m, m, rad. Nothing where none moves.
    pub ground: &'a [f64],
    /// The columns, in their units.
    pub values: &'a [f64],
}

/// Samples of some quantities over time, in the order in which they were taken; those of a mechanism with the poses of its
/// bodies.
#[derive(Clone, Debug, Default)]
pub struct Recording {
    /// Description of the recording, with events and faults.
    pub about: About,
    times: Vec<f64>,
    values: Table,
    poses: Table,
    ground: Table,
    /// The first row that had another length than the columns, and how many numbers it had.
    uneven: Option<[usize; 2]>,
}

impl Recording {
    /// An empty recording of these columns, each `(name, unit)`.
    pub fn new<C: Into<Column>>(columns: impl IntoIterator<Item = C>) -> Self {
        Self::of(Mechanism::default(), columns)
    }

    /// An empty recording of a mechanism: its poses and these columns.
    pub fn of<C: Into<Column>>(mechanism: Mechanism, columns: impl IntoIterator<Item = C>) -> Self {
        let columns: Vec<Column> = columns.into_iter().map(Into::into).collect();
        Self::empty(About { mechanism, columns, ..About::default() })
    }

    pub(crate) fn empty(about: About) -> Self {
        let About { mechanism, columns, .. } = &about;
        let ground = if mechanism.ground_moves() { mechanism.ground.len() } else { 0 };
        Self {
            times: Vec::new(),
            values: Table::new(columns.len()),
            poses: Table::new(OF_POSE * mechanism.bodies.len()),
            ground: Table::new(OF_GROUND * ground),
            uneven: None,
            about,
        }
    }

    /// Puts whole tables in place of what there is.
    pub(crate) fn fill(&mut self, times: Vec<f64>, [poses, ground, values]: [Vec<f64>; 3]) {
        let rows = times.len();
        self.times = times;
        self.poses.fill(poses, rows);
        self.ground.fill(ground, rows);
        self.values.fill(values, rows);
    }

    /// Adds the sample `row`, an array or a slice in the units of the columns, taken at `time` (s).
    ///
    /// Every number is stored, NaN and infinities too: they show where a run went wrong. A row should have a number for each column;
    /// missing numbers are recorded as gaps, surplus ones are dropped, and writing the recording is an error then.
    pub fn push(&mut self, time: f64, row: impl AsRef<[f64]>) {
        self.push_row(&Row { time, values: row.as_ref(), ..Row::default() });
    }

    /// Adds a moment with its poses.
    pub fn push_row(&mut self, row: &Row) {
        if row.values.len() != self.values.width() {
            self.uneven = self.uneven.or(Some([self.times.len(), row.values.len()]));
        }
        for event in self.about.events.iter_mut().rev().take_while(|event| event.row.is_none()) {
            event.row = Some(self.times.len());
        }
        self.times.push(row.time);
        self.values.push(row.values);
        self.poses.push(row.poses);
        self.ground.push(row.ground);
    }

    /// Is this moment the last row, to the bit?
    pub fn ends_with(&self, row: &Row) -> bool {
        let same = |a: &[f64], b: &[f64]| {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
        };
        let Some(last) = self.times.len().checked_sub(1) else { return false };
        same(&self.times[last..], &[row.time])
            && same(self.values.row(last), row.values)
            && same(self.poses.row(last), row.poses)
            && same(self.ground.row(last), row.ground)
    }

    /// Adds an event; the row that is pushed next is the first after it.
    pub fn push_event(&mut self, time: f64, what: impl Into<String>) {
        self.about.events.push(Event { time, what: what.into(), row: None });
    }

    /// The columns after the time.
    pub fn columns(&self) -> &[Column] {
        &self.about.columns
    }

    /// The times of the samples (s).
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The samples, one row for each time.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        (0..self.len()).map(|row| self.values.row(row))
    }

    /// Poses at the time of a row: x, y, angle of G of each body, and their rates; m, m, rad; m/s, m/s, rad/s.
    pub fn poses(&self, row: usize) -> &[[f64; OF_POSE]] {
        self.poses.row(row).as_chunks().0
    }

    /// Ports of the ground at the time of a row: x, y, angle; m, m, rad. Nothing where none moves.
    pub fn ground(&self, row: usize) -> &[[f64; OF_GROUND]] {
        self.ground.row(row).as_chunks().0
    }

    /// All numbers of a kind: poses, ground, values.
    pub(crate) fn tables(&self) -> [&Table; 3] {
        [&self.poses, &self.ground, &self.values]
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// True if nothing was recorded.
    pub fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    /// Has every row a number for each column?
    pub(crate) fn check(&self) -> io::Result<()> {
        let Some([row, found]) = self.uneven else { return Ok(()) };
        let message = format!("row {row} has {found} numbers, and there are {} columns", self.values.width());
        Err(io::Error::new(io::ErrorKind::InvalidInput, message))
    }
}
