//! Path generation: four-bars whose coupler point passes through given points.
//!
//! The sum of squared distances is minimised from many random starts, by the method of Levenberg and Marquardt with exact derivatives and
//! bounds. A crank that has to turn and to be the shortest link is a choice of unknowns: with the
//! crank r2 and three excesses s, t, w >= 0, the lengths r1 = r2 + (s + t)/2, r3 = r2 + (t + w)/2, r4 = r2 + (s + w)/2 are all those
//! of Grashof's crank-rockers, and no others.

mod kernel;
mod search;
mod solve;
mod start;

pub(crate) use self::search::CANDIDATES;
pub(crate) use self::start::spread;
use crate::synthesis::four_bar::{Defect, FourBar, Point};
use crate::synthesis::numbers::first_without;

/// Prescribed angles of the crank at the points.
#[derive(Clone, Debug, PartialEq)]
pub enum Timing {
    /// Nothing: the crank has any angle at each point.
    Free,
    /// Angle of the crank at each point, from the line of the pivots, rad.
    Given(Vec<f64>),
    /// Angle of the crank at each point beyond an angle that is free, rad.
    Steps(Vec<f64>),
}

/// Motion that is demanded of the crank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crank {
    /// The crank is the shortest link and turns: crank-rockers of Grashof.
    Turns,
    /// Any four-bar whose loop closes at each point.
    Any,
}

/// Least and greatest values; equal ones fix a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Coordinates of the crank's pivot, m.
    pub pivot: [[f64; 2]; 2],
    /// Angle from the x-axis to the line of the pivots, rad.
    pub ground_angle: [f64; 2],
    /// Lengths of ground, crank, coupler and rocker, m.
    pub lengths: [[f64; 2]; 4],
    /// Coupler point in the frame of the coupler, m.
    pub point: [[f64; 2]; 2],
}

impl Bounds {
    /// Lengths up to a greatest one, m, and places and coupler points as far from the origin.
    pub fn up_to(length: f64) -> Self {
        let around = [-length, length];
        Self {
            pivot: [around; 2],
            ground_angle: [f64::NEG_INFINITY, f64::INFINITY],
            lengths: [[1e-3 * length, length]; 4],
            point: [around; 2],
        }
    }
}

/// Problem of path generation.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Points, m, in the order in which they are passed.
    pub points: Vec<Point>,
    /// Prescribed angles of the crank at the points.
    pub timing: Timing,
    /// Bounds of the dimensions.
    pub bounds: Bounds,
    /// Motion that is demanded of the crank.
    pub crank: Crank,
    /// Least transmission angle and what it lacks to half a turn at most, rad; 0 demands nothing. It bounds the lengths of a crank-rocker
    /// over its whole turn, and with [`Crank::Any`] the angle at each point.
    pub transmission: f64,
}

/// Extent of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Search {
    /// Random starts.
    pub starts: u64,
    /// Seed of the random numbers; each start has its own sequence.
    pub seed: u64,
    /// Linkages that are given back, the best first.
    pub keep: usize,
}

impl Default for Search {
    fn default() -> Self {
        Self { starts: 10_000, seed: 1, keep: 10 }
    }
}

/// Four-bar that was found for a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The linkage.
    pub four_bar: FourBar,
    /// Angle of the crank from the x-axis at each point, rad.
    pub angles: Vec<f64>,
    /// Sum of the squared distances to the points, m^2.
    pub error: f64,
    /// Greatest distance to a point, m.
    pub greatest: f64,
    /// Defects: order, and a crank that does not turn where it should.
    pub defects: Vec<Defect>,
    /// Number of the start that led to it.
    pub start: u64,
}

/// Why a path has no search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoPath {
    /// Fewer than two points.
    TooFewPoints,
    /// Another number of angles than of points.
    Angles {
        /// Points that were given.
        points: usize,
        /// Angles that were given.
        angles: usize,
    },
    /// A coordinate or an angle of this point, from 0, is no finite number.
    NoNumber {
        /// The point.
        point: usize,
    },
    /// A bound whose least value is above its greatest, a length that is not bounded, or a transmission angle outside 0 to pi/2.
    Bounds,
}

impl std::fmt::Display for NoPath {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TooFewPoints => f.write_str("a path has two points at least"),
            Self::Angles { points, angles } => write!(f, "{points} points, but {angles} angles of the crank"),
            Self::NoNumber { point } => write!(f, "a number of point {point}, counted from 0, is none"),
            Self::Bounds => f.write_str("a least value is above its greatest, a length has no bound, or the transmission angle is none"),
        }
    }
}

impl std::error::Error for NoPath {}

impl Path {
    /// Best linkages of a search from random starts, those without a defect first, then by their errors. The result depends on the seed
    /// and on the number of starts alone, and not on the number of threads, which is rayon's.
    ///
    /// # Errors
    /// [`NoPath`].
    pub fn search(&self, search: &Search) -> Result<Vec<Found>, NoPath> {
        self.check()?;
        Ok(search::search(self, search))
    }

    fn check(&self) -> Result<(), NoPath> {
        let points = self.points.len();
        if points < 2 {
            return Err(NoPath::TooFewPoints);
        }
        if let Timing::Given(angles) | Timing::Steps(angles) = &self.timing
            && angles.len() != points
        {
            return Err(NoPath::Angles { points, angles: angles.len() });
        }
        if let Some(point) = without_number(&self.points, &self.timing) {
            return Err(NoPath::NoNumber { point });
        }
        let Bounds { pivot, ground_angle, lengths, point } = &self.bounds;
        let all = pivot.iter().chain(lengths).chain(point).chain([ground_angle]);
        let holds = all.clone().all(|[least, most]| least <= most);
        let bounded = lengths.iter().all(|[least, most]| *least > 0.0 && most.is_finite());
        let possible = (0.0..std::f64::consts::FRAC_PI_2).contains(&self.transmission);
        if holds && bounded && possible { Ok(()) } else { Err(NoPath::Bounds) }
    }
}

/// The first point that has a coordinate, or an angle of the crank, that is no finite number.
pub(crate) fn without_number(points: &[Point], timing: &Timing) -> Option<usize> {
    let angles = match timing {
        Timing::Free => &[][..],
        Timing::Given(angles) | Timing::Steps(angles) => angles,
    };
    first_without(points.iter().copied()).or_else(|| first_without(angles.iter().map(|angle| [*angle])))
}
