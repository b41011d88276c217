//! Problems of the synthesis of six-bars, and the linkages that solve them.

use super::{Chain, SixBar, search};
use crate::synthesis::four_bar::{Defect, Point};
use crate::synthesis::function::{Pair, Scales};
use crate::synthesis::numbers::first_without;
use crate::synthesis::path::{Crank, Search, Timing, without_number};

/// Task of a six-bar.
#[derive(Clone, Debug, PartialEq)]
pub enum Task {
    /// The second bar of the dyad, or the first one of [`Chain::StephensonTwo`], turns by a function of the crank; [`Pair::rocker`] is its
    /// angle. With given scales angles count from the line of the pivots.
    Function {
        /// Pairs of angles.
        pairs: Vec<Pair>,
        /// Which scales begin anywhere.
        scales: Scales,
    },
    /// The point of the first bar, or of the coupler of [`Chain::StephensonTwo`], passes through points.
    Path {
        /// Points, m, in the order in which they are passed.
        points: Vec<Point>,
        /// Prescribed angles of the crank at the points.
        timing: Timing,
    },
}

/// Least and greatest values; equal ones fix a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Coordinates of the crank's pivot, m.
    pub pivot: [[f64; 2]; 2],
    /// Lengths of ground, crank, coupler, rocker and of the bars of the dyad, m.
    pub lengths: [[f64; 2]; 6],
    /// Coordinates of the ends of the dyad and of the point in the frames of their links, m.
    pub points: [f64; 2],
}

impl Bounds {
    /// Lengths up to a greatest one, m, and places and points as far from their origins.
    pub fn up_to(length: f64) -> Self {
        let around = [-length, length];
        Self { pivot: [around; 2], lengths: [[1e-3 * length, length]; 6], points: around }
    }
}

/// Problem of the synthesis of a six-bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Chain.
    pub chain: Chain,
    /// Task of the linkage.
    pub task: Task,
    /// Bounds of the dimensions.
    pub bounds: Bounds,
    /// Motion that is demanded of the crank of the four-bar.
    pub crank: Crank,
    /// Least transmission angle of both dyads, rad: a bound at each position, and a linkage below it anywhere has a defect. It
    /// says nothing of [`Chain::StephensonTwo`], whose crank has other dead points.
    pub transmission: f64,
}

/// Six-bar that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The linkage.
    pub six_bar: SixBar,
    /// Angle that [`SixBar::pose`] takes at each position, rad: of the crank from the x-axis, but for [`Chain::StephensonTwo`].
    pub angles: Vec<f64>,
    /// Angle of the bar that turns by the function from the x-axis where the scale of the output is zero, rad; 0 of a path.
    pub output_zero: f64,
    /// Sum of the squared distances to the points, m^2; of a function, of the squared chords of the angles, `2 - 2 cos(error)`.
    pub error: f64,
    /// Greatest distance to a point, m, or greatest error of an angle, rad.
    pub greatest: f64,
    /// Defects.
    pub defects: Vec<Defect>,
    /// Number of the start that led to it.
    pub start: u64,
}

/// Why a problem has no search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoSixBar {
    /// Fewer than two positions.
    TooFewPositions,
    /// Another number of angles than of points.
    Angles {
        /// Points that were given.
        points: usize,
        /// Angles that were given.
        angles: usize,
    },
    /// A number of this position, from 0, is no finite one.
    NoNumber {
        /// The pair or the point.
        position: usize,
    },
    /// A bound whose least value is above its greatest, a length that is not bounded, or a transmission angle outside 0 to pi/2.
    Bounds,
}

impl std::fmt::Display for NoSixBar {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TooFewPositions => f.write_str("a six-bar has two positions at least"),
            Self::Angles { points, angles } => write!(f, "{points} points, but {angles} angles of the crank"),
            Self::NoNumber { position } => {
                write!(f, "a number of position {position}, counted from 0, is none")
            }
            Self::Bounds => f.write_str(
                "a least value is above its greatest, a length has no bound, or the transmission angle is none",
            ),
        }
    }
}

impl std::error::Error for NoSixBar {}

impl Problem {
    /// Best linkages of a search from random starts, those without a defect first, then by their errors. The result depends on the seed
    /// and on the number of starts alone.
    ///
    /// # Errors
    /// [`NoSixBar`].
    pub fn search(&self, search: &Search) -> Result<Vec<Found>, NoSixBar> {
        self.check()?;
        Ok(distinct(search::search(self, search), search.keep))
    }

    fn check(&self) -> Result<(), NoSixBar> {
        let positions = match &self.task {
            Task::Function { pairs, .. } => pairs.len(),
            Task::Path { points, timing: Timing::Given(angles) | Timing::Steps(angles) }
                if angles.len() != points.len() =>
            {
                return Err(NoSixBar::Angles { points: points.len(), angles: angles.len() });
            }
            Task::Path { points, .. } => points.len(),
        };
        if positions < 2 {
            return Err(NoSixBar::TooFewPositions);
        }
        let without = match &self.task {
            Task::Function { pairs, .. } => first_without(pairs.iter().map(|pair| [pair.crank, pair.rocker])),
            Task::Path { points, timing } => without_number(points, timing),
        };
        if let Some(position) = without {
            return Err(NoSixBar::NoNumber { position });
        }
        let Bounds { pivot, lengths, points } = &self.bounds;
        let holds = pivot.iter().chain(lengths).chain([points]).all(|[least, most]| least <= most);
        let bounded = lengths.iter().all(|[least, most]| *least > 0.0 && most.is_finite());
        let possible = (0.0..std::f64::consts::FRAC_PI_2).contains(&self.transmission);
        if holds && bounded && possible { Ok(()) } else { Err(NoSixBar::Bounds) }
    }
}

/// Linkages in order, each error once: those without a defect first.
fn distinct(mut all: Vec<Found>, keep: usize) -> Vec<Found> {
    let has_defect = |found: &Found| !found.defects.is_empty();
    all.sort_by(|a, b| {
        has_defect(a).cmp(&has_defect(b)).then(a.error.total_cmp(&b.error)).then(a.start.cmp(&b.start))
    });
    all.dedup_by(|b, a| has_defect(a) == has_defect(b) && (a.error - b.error).abs() <= 1e-6 * a.error);
    all.truncate(keep);
    all
}
