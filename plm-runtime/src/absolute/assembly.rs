//! Result of an assembly.

use core::fmt;

use super::{Far, Layout};
use crate::scalar::Real;

/// A start that the joints allow, compared with the one that was declared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly<S, const NQ: usize, const NC: usize> {
    /// Position, m and rad.
    pub q: [S; NQ],
    /// Velocity, m/s and rad/s.
    pub v: [S; NQ],
    /// How far assembly moved each coordinate.
    pub moved: [S; NQ],
    /// Which coordinates were locked.
    pub locked: [bool; NQ],
    /// Constraint rows that say nothing new, here and wherever the mechanism moves: it runs by rank.
    pub redundant: [bool; NC],
    /// Rank of the rows of joints and locks at this position.
    pub rank: usize,
    /// Rows of joints and locks.
    pub rows: usize,
    /// Number of locks on position.
    pub locks: usize,
    /// Number of coordinates less number of joint rows: F = 3N - M.
    pub freedom: i32,
    /// Do joints and locks determine the position?
    pub status: Status,
    /// The rank is lower here than at neighbouring positions: a dead point or a change point.
    pub singular: bool,
    /// The position turns a body farther than the gaps at the start explain: probably not the intended one.
    pub far: Option<Far<S>>,
    /// How the position was found.
    pub found: Found,
    /// Newton steps.
    pub iterations: u32,
    /// Largest remaining gap of the joints, m or rad.
    pub gap: S,
    pub(super) layout: &'static Layout,
}

/// How assembly found the position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// By Newton's steps from the start values.
    FromStart,
    /// Those closed nothing. Damped steps were led from the start values and from others about them, which are the same in every
    /// run; of the positions that they closed, this one is nearest to the start values.
    Searched {
        /// How many starts were tried.
        starts: u32,
        /// How many of them were closed.
        closed: u32,
    },
}

/// Do joints and locks determine the position?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// They do: as many independent rows as coordinates.
    Sufficient,
    /// They do not: assembly moved the free coordinates as little as possible.
    Insufficient,
    /// Some joint rows say nothing new (and do not contradict the others).
    Redundant,
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sufficient => "sufficient",
            Self::Insufficient => "insufficient",
            Self::Redundant => "redundant",
        })
    }
}

impl<S: Real, const NQ: usize, const NC: usize> fmt::Display for Assembly<S, NQ, NC> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { freedom, locks, rank, rows, status, iterations, layout, .. } = self;
        let (coordinates, joint_rows) = (layout.coordinates.len(), layout.rows.len());
        writeln!(
            f,
            "F = 3N - M = {coordinates} - {joint_rows} = {freedom}; {locks} locked; rank {rank} of {rows} rows: {status}"
        )?;
        writeln!(f, "closed to {:e} in {iterations} iterations", self.gap.to_f64())?;
        if let Found::Searched { starts, closed } = self.found {
            writeln!(
                f,
                "Newton's steps from the start values closed nothing: nearest of what {closed} of {starts} starts about them closed"
            )?;
        }
        if let Some(far) = self.far {
            writeln!(f, "{far}")?;
        }
        if self.singular {
            writeln!(f, "singular position: the rank is higher beside it")?;
        }
        for (name, _) in layout.rows.iter().zip(self.redundant).filter(|(_, redundant)| *redundant) {
            writeln!(f, "{name}: says nothing that other joints do not say")?;
        }
        for (i, name) in layout.coordinates.iter().enumerate() {
            let (q, moved) = (self.q[i].to_f64(), self.moved[i].to_f64());
            let lock = if self.locked[i] { ", locked" } else { "" };
            writeln!(f, "{name} = {q} (moved by {moved}{lock})")?;
        }
        Ok(())
    }
}
