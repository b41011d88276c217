//! Contents of all logs of a folder.

use std::fmt;
use std::fs::{File, TryLockError};
use std::path::{Path, PathBuf};

use super::log::logs;
use super::{Plan, Problem, Shard};

/// A row, or the message of a failure.
pub type Outcome<const C: usize> = Result<[f64; C], Box<str>>;

/// All finished points of a study, in their order. `Display` reports the progress, shard by shard, and points that failed.
#[derive(Clone, Debug)]
pub struct Gathered<const P: usize, const C: usize> {
    pub(super) plan: Plan<P, C>,
    outcomes: Vec<Option<Outcome<C>>>,
    shards: Vec<Progress>,
    notes: Vec<String>,
}

/// How far a shard is.
#[derive(Clone, Debug)]
struct Progress {
    shard: Shard,
    /// Points in its log, those that failed among them.
    done: usize,
    failed: usize,
    /// Is it at work just now?
    runs: bool,
}

/// Number of failed points that are listed with their messages.
const TOLD: usize = 10;

impl<const P: usize, const C: usize> Gathered<P, C> {
    pub(super) fn read(plan: &Plan<P, C>, folder: &Path) -> Result<Self, Problem> {
        let outcomes = vec![None; plan.points.len()];
        let mut gathered = Self { plan: plan.clone(), outcomes, shards: Vec::new(), notes: Vec::new() };
        for (shard, path) in logs(folder)? {
            gathered.add(shard, &path)?;
        }
        Ok(gathered)
    }

    /// Takes the points of a log.
    fn add(&mut self, shard: Shard, path: &PathBuf) -> Result<(), Problem> {
        let mut progress = Progress { shard, done: 0, failed: 0, runs: is_locked(path) };
        let (outcomes, mut other) = (&mut self.outcomes, None);
        let reading = self.plan.read_log(path, &mut |index, outcome| {
            let Some(kept) = outcomes.get_mut(index) else { return };
            progress.done += 1;
            progress.failed += usize::from(outcome.is_err());
            match kept {
                Some(kept) if !is_same(kept, &outcome) => other = Some(index),
                _ => *kept = Some(outcome),
            }
        })?;
        self.notes.extend(reading.notes(path));
        self.shards.push(progress);
        other.map_or(Ok(()), |index| {
            Err(Problem::file(
                path,
                format!(
                    "point {index} ({}) has another row here than in a log before it: the row of a point \
                     must follow from the point alone",
                    self.plan.points.words(index)
                ),
            ))
        })
    }

    /// Outcome of a point; `None` if it is missing.
    pub fn outcome(&self, index: usize) -> Option<&Outcome<C>> {
        self.outcomes.get(index)?.as_ref()
    }

    /// The numbers of the points that no log has.
    pub fn missing(&self) -> impl Iterator<Item = usize> {
        self.outcomes.iter().enumerate().filter(|(_, outcome)| outcome.is_none()).map(|(index, _)| index)
    }

    /// The numbers of the points that failed, and the messages.
    pub fn failed(&self) -> impl Iterator<Item = (usize, &str)> {
        self.done().filter_map(|(index, outcome)| Some((index, outcome.as_ref().err()?.as_ref())))
    }

    /// Defects of logs, a line each.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Points that are there.
    pub(super) fn done(&self) -> impl Iterator<Item = (usize, &Outcome<C>)> {
        self.outcomes.iter().enumerate().filter_map(|(index, outcome)| Some((index, outcome.as_ref()?)))
    }

    /// Shards that are not through, or of which points failed.
    fn fmt_shards(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let through =
            |shard: &Progress| shard.done >= shard.shard.len(self.outcomes.len()) && shard.failed == 0;
        for Progress { shard, done, failed, runs } in self.shards.iter().filter(|shard| !through(shard)) {
            let of = shard.len(self.outcomes.len());
            let runs = if *runs { ", running" } else { "" };
            write!(f, "\nshard {shard}: {done} of {of} points, {failed} failed{runs}")?;
        }
        let numbers = self.shards.chunk_by(|a, b| a.shard.of == b.shard.of);
        for shards in numbers {
            let (begun, of) = (shards.len(), shards[0].shard.of);
            let ends = shards.iter().filter(|shard| through(shard)).count();
            if of > 1 {
                write!(f, "\nof {of} shards {begun} have begun, {ends} are through without a failure")?;
            }
        }
        Ok(())
    }
}

impl<const P: usize, const C: usize> fmt::Display for Gathered<P, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (done, of) = (self.done().count(), self.outcomes.len());
        let failed = self.failed().count();
        write!(f, "{}: {done} of {of} points, {failed} failed", self.plan.name)?;
        self.fmt_shards(f)?;
        for (index, words) in self.failed().take(TOLD) {
            write!(f, "\npoint {index}, {}: {words}", self.plan.points.words(index))?;
        }
        if failed > TOLD {
            write!(f, "\nand {} more that failed: the table has them all", failed - TOLD)?;
        }
        self.notes.iter().try_for_each(|note| write!(f, "\n{note}"))
    }
}

/// True if two outcomes are equal to the bit. NaN is not equal to itself, so that bits are compared.
fn is_same<const C: usize>(a: &Outcome<C>, b: &Outcome<C>) -> bool {
    match (a, b) {
        (Ok(a), Ok(b)) => a.map(f64::to_bits) == b.map(f64::to_bits),
        (Err(a), Err(b)) => a == b,
        _ => false,
    }
}

/// Does a process append to this log?
fn is_locked(path: &PathBuf) -> bool {
    File::open(path).is_ok_and(|file| matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)))
}
