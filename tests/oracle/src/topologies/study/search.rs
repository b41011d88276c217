//! The search: the six-bars of a seed, the best of them, and the outcome of each.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use plm_dynamic::{Error, Refused};
use plm_studies::batch;

use super::chains::{Point, SixBar};
use super::straight::{Portion, longest};
use super::trace::{path, trace};

/// A deviation of at most this fraction of the length counts as straight.
pub const STRAIGHT: f64 = 1e-3;
/// A portion takes at least so many samples: an eighth of a turn.
const LEAST: usize = super::trace::SAMPLES / 8;

/// The straightest path of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    pub number: u64,
    pub point: Point,
    pub portion: Portion,
    /// Length of the portion over the greatest extent of a link.
    pub score: f64,
}

/// Outcome of one mechanism.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// A whole turn, and its straightest path.
    Turned(Option<Found>),
    /// The crank cannot make a turn.
    Stuck,
    /// The compiler refused it: a bug here, or there.
    Refused(Refused),
}

/// Outcomes of a search, and the time that it took.
#[derive(Debug)]
pub struct Search {
    pub outcomes: Vec<Outcome>,
    pub taken: Duration,
}

/// One mechanism of a seed.
pub fn outcome(seed: u64, number: u64) -> Outcome {
    let six_bar = SixBar::random(seed, number);
    let poses = match trace(&six_bar.declaration(None)) {
        Ok(poses) => poses,
        Err(Error::Refused(refused)) => return Outcome::Refused(refused),
        Err(_) => return Outcome::Stuck,
    };
    let rated = six_bar.points.iter().filter_map(|point| {
        let portion = longest(&path(&poses, *point), LEAST, STRAIGHT)?;
        let score = 1e3 * portion.length / six_bar.size(*point);
        Some(Found { number, point: *point, portion, score })
    });
    Outcome::Turned(rated.max_by(|one, other| one.score.total_cmp(&other.score)))
}

/// Mechanisms `0..count` of a seed, on so many threads; 0 for as many as the machine has. The outcomes do not depend on the threads.
pub fn search(seed: u64, count: u64, threads: usize) -> Search {
    let clock = Instant::now();
    let points = batch::points(0..count).quiet();
    let points = if threads > 0 { points.threads(threads) } else { points };
    let runs = points.run(|number| Ok(outcome(seed, number)));
    let outcomes = runs.values().map(|(_, outcome)| outcome.clone()).collect();
    Search { outcomes, taken: clock.elapsed() }
}

impl Search {
    /// The longest straight portion of all, over the size.
    pub fn best(&self) -> Option<Found> {
        self.found().max_by(|one, other| one.score.total_cmp(&other.score))
    }

    pub fn found(&self) -> impl Iterator<Item = Found> {
        self.outcomes.iter().filter_map(|outcome| match outcome {
            Outcome::Turned(found) => *found,
            _ => None,
        })
    }

    /// By topology: how many, how many that turn, and the best score.
    pub fn table(&self, seed: u64) -> BTreeMap<&'static str, (usize, usize, f64)> {
        let mut table = BTreeMap::new();
        for (number, outcome) in (0..).zip(&self.outcomes) {
            let name = SixBar::random(seed, number).topology.name;
            let (all, turned, best) = table.entry(name).or_insert((0, 0, 0.0_f64));
            *all += 1;
            if let Outcome::Turned(found) = outcome {
                *turned += 1;
                *best = best.max(found.map_or(0.0, |found| found.score));
            }
        }
        table
    }
}
