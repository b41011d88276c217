//! A shard of a study and its run.

use std::fmt;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use super::log::{Log, checksum, logs};
use super::{Plan, Problem, Rows, Study};
use crate::batch::{MOST_THREADS, on_threads, progress_bar};

/// One of several parts of a study. Of every N points that follow each other each of the N shards has one, and which one changes
/// without a pattern: if it were always the same place, shards would be columns of a grid, some of which cost more than others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shard {
    /// Which of them, counted from 1.
    pub(super) number: usize,
    /// How many there are.
    pub(super) of: usize,
}

/// A study has no more shards; the arithmetic of their numbers stays far from its bounds.
const MOST_SHARDS: usize = 1 << 30;

impl Shard {
    /// All points.
    pub const WHOLE: Shard = Shard { number: 1, of: 1 };

    /// Shard `number`, counted from 1, of so many.
    ///
    /// # Errors
    /// A number that is 0 or greater than `of`; an `of` beyond 2^30.
    pub fn new(number: usize, of: usize) -> Result<Self, Problem> {
        if of > MOST_SHARDS {
            Err(Problem::new(format!("{of} shards are too many: {MOST_SHARDS} is the most")))
        } else if (1..=of).contains(&number) {
            Ok(Self { number, of })
        } else {
            Err(Problem::new(format!("there is no shard {number}/{of}: they are 1/{of} to {of}/{of}")))
        }
    }

    /// Reads `3/64`.
    ///
    /// # Errors
    /// Another form, or a number that is out of range.
    pub fn parse(words: &str) -> Result<Self, Problem> {
        let numbers =
            words.split_once('/').and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
        let (number, of) = numbers.ok_or_else(|| {
            Problem::new(format!("a shard is its number and how many there are, 3/64, not `{words}`"))
        })?;
        Self::new(number, of)
    }

    /// Of how many points the shard is, where the study has so many.
    pub(super) fn len(self, points: usize) -> usize {
        points / self.of + usize::from(self.index(points / self.of) < points)
    }

    /// By how much the shards are turned against their numbers at a place.
    fn turn(self, place: usize) -> usize {
        // The upper half: in the lowest bits of the sum there is a pattern.
        ((checksum(&(place as u64).to_le_bytes()) >> 32) % self.of as u64) as usize
    }

    /// The number in the study of a point of the shard.
    fn index(self, place: usize) -> usize {
        place * self.of + (self.number - 1 + self.turn(place)) % self.of
    }

    /// The place in the shard of a point of the study.
    fn place(self, index: usize) -> Option<usize> {
        let place = index / self.of;
        (self.index(place) == index).then_some(place)
    }

    /// The name of its log.
    pub(super) fn log(self) -> String {
        format!("{}-of-{}.log", self.number, self.of)
    }

    /// The shard of which this is the log.
    pub(super) fn of_log(name: &str) -> Option<Self> {
        let (number, of) = name.strip_suffix(".log")?.split_once("-of-")?;
        let shard = Self::new(number.parse().ok()?, of.parse().ok()?).ok()?;
        (shard.log() == name).then_some(shard)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

/// Counts of the run of a shard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ran {
    /// Points of the shard that were there before.
    pub kept: usize,
    /// Points that were computed.
    pub computed: usize,
    /// Those of them that failed.
    pub failed: usize,
    /// Defects of logs, a line each.
    pub notes: Vec<String>,
}

impl<F: Rows<P, C>, const P: usize, const C: usize> Study<F, P, C> {
    /// Runs those points of a shard that no log in the folder has, on so many threads (0: one for each core), and appends each to the log
    /// of the shard as soon as it is done. A point that fails, or panics, is stored with its message; it is not tried again.
    ///
    /// If there are more shards than points, some have none, which [`Ran::notes`] report.
    ///
    /// # Errors
    /// A log that cannot be read or written, is of another study, or is open in another process; more than 1024 threads.
    pub fn run(&self, folder: &Path, shard: Shard, threads: usize) -> Result<Ran, Problem> {
        self.plan.check()?;
        check_threads(threads)?;
        fs::create_dir_all(folder).map_err(|error| Problem::file(folder, error))?;
        let Begun { log, done, notes } = self.plan.begin(folder, shard)?;
        let kept = done.iter().filter(|done| **done).count();
        let (log, failed) = (Mutex::new(log), AtomicUsize::new(0));
        let bar = progress_bar(done.len() - kept);
        let some = |places: &[usize]| {
            let index = |place: &usize| shard.index(*place);
            let there =
                places.iter().map(index).filter_map(|index| Some((index, self.plan.points.at(index)?)));
            let (indices, points): (Vec<usize>, Vec<[f64; P]>) = there.unzip();
            let mut outcome = Ok(());
            self.row.rows(&points, &mut |place, row| {
                failed.fetch_add(usize::from(row.is_err()), Ordering::Relaxed);
                bar.inc(1);
                let mut log = log.lock().unwrap_or_else(PoisonError::into_inner);
                if let (Ok(()), Some(index)) = (&outcome, indices.get(place)) {
                    outcome = log.append(*index, &row.map_err(Into::into));
                }
            });
            outcome
        };
        let places: Vec<usize> = (0..done.len()).filter(|place| !done[*place]).collect();
        let all = || places.par_chunks(F::AT_ONCE).with_max_len(1).try_for_each(some);
        let outcome = on_threads(threads, self.stack, all);
        bar.finish_and_clear();
        outcome.map(|()| Ran { kept, computed: done.len() - kept, failed: failed.into_inner(), notes })
    }
}

/// Are so many threads within reason? To start a hundred thousand takes longer than most studies.
pub(super) fn check_threads(threads: usize) -> Result<(), Problem> {
    if threads <= MOST_THREADS {
        return Ok(());
    }
    Err(Problem::new(format!(
        "{threads} threads are too many: {MOST_THREADS} is the most, and 0 takes one for each core"
    )))
}

/// A shard whose log is open.
struct Begun {
    log: Log,
    /// Of each point of the shard: is it there?
    done: Vec<bool>,
    notes: Vec<String>,
}

impl<const P: usize, const C: usize> Plan<P, C> {
    /// Opens the log, and finds what it has, and logs of other numbers of shards.
    fn begin(&self, folder: &Path, shard: Shard) -> Result<Begun, Problem> {
        let points = self.points.len();
        let mut done = vec![false; shard.len(points)];
        let empty =
            done.is_empty().then(|| format!("shard {shard} has none of the {points} points of the study"));
        let mut mark = |index, _| {
            if let Some(done) = shard.place(index).and_then(|place| done.get_mut(place)) {
                *done = true;
            }
        };
        let path = folder.join(shard.log());
        let (log, reading) = self.open_log(&path, &mut mark)?;
        let mut notes: Vec<String> = empty.into_iter().chain(reading.notes(&path)).collect();
        for (_, path) in logs(folder)?.into_iter().filter(|(other, _)| other.of != shard.of) {
            notes.extend(self.read_log(&path, &mut mark)?.notes(&path));
        }
        Ok(Begun { log, done, notes })
    }
}
