//! Modes of contact rows, constant during a step.

use core::fmt;

use crate::scalar::{Real, Scalar};

/// Mode of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// A gap that is open, or kept closed by other rows alone: no contact force.
    Open,
    /// A gap that is closed: a constraint.
    Closed,
    /// A friction without normal force.
    Off,
    /// A friction that sticks: a constraint.
    Sticks,
    /// A friction that slips with a positive rate.
    Forwards,
    /// A friction that slips with a negative rate.
    Backwards,
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Open => "open",
            Self::Closed => "closed",
            Self::Off => "unloaded",
            Self::Sticks => "sticks",
            Self::Forwards => "slips forwards",
            Self::Backwards => "slips backwards",
        })
    }
}

impl Mode {
    /// True if the row is a constraint.
    pub fn holds(self) -> bool {
        matches!(self, Self::Closed | Self::Sticks)
    }

    /// True if the friction slips.
    pub fn slips(self) -> bool {
        matches!(self, Self::Forwards | Self::Backwards)
    }

    /// All modes, in the order of their numbers.
    pub const ALL: [Self; 6] =
        [Self::Open, Self::Closed, Self::Off, Self::Sticks, Self::Forwards, Self::Backwards];

    /// Number of the mode in saved runs and in other languages.
    pub fn number(self) -> u64 {
        match self {
            Self::Open => 0,
            Self::Closed => 1,
            Self::Off => 2,
            Self::Sticks => 3,
            Self::Forwards => 4,
            Self::Backwards => 5,
        }
    }

    /// The mode with this number; open for any other number.
    pub(super) fn of_number(number: u64) -> Self {
        match number {
            1 => Self::Closed,
            2 => Self::Off,
            3 => Self::Sticks,
            4 => Self::Forwards,
            5 => Self::Backwards,
            _ => Self::Open,
        }
    }

    /// The mode of a friction that slips with this rate; `None` if it does not slip.
    pub(super) fn of_slip<S: Real>(rate: S) -> Option<Self> {
        if rate > S::ZERO {
            Some(Self::Forwards)
        } else if rate < S::ZERO {
            Some(Self::Backwards)
        } else {
            None
        }
    }

    /// Sign of the slip, -1 or 1; zero if there is none.
    pub(super) fn sign<T: Scalar>(self) -> T {
        T::lit(match self {
            Self::Forwards => 1.0,
            Self::Backwards => -1.0,
            _ => 0.0,
        })
    }
}

/// Times at which modes change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Change {
    /// At events, which are located: the modes are constant during a step.
    #[default]
    AtEvents,
    /// In every step, by a method that does not locate events.
    InSteps,
    /// When the caller sets the state: frictions that stick constrain nothing until then, and the velocities
    /// decide which of them slip ([`state_was_set`](super::state_was_set)). It is for a state that a motion
    /// determines, not for a run.
    WhereSet,
}

/// Modes of all rows, and the data stored with them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modes<S, const N: usize> {
    /// The mode of each row.
    pub of: [Mode; N],
    /// True for a row that is at rest without being a constraint, since other rows carry it: more rows are at
    /// rest than there are degrees of freedom.
    pub carried: [bool; N],
    /// Displacement at which a friction sticks, m or rad.
    pub place: [S; N],
    /// Inverse of the determinant of the active rows when the modes were chosen.
    pub orientation: S,
    /// By reaction that bounds frictions: true if it is negative.
    pub negative: [bool; N],
    /// Times at which they change.
    pub change: Change,
}

impl<S: Scalar, const N: usize> Modes<S, N> {
    /// Modes with all gaps open.
    #[must_use]
    pub fn open() -> Self {
        Self {
            of: [Mode::Open; N],
            carried: [false; N],
            place: [S::ZERO; N],
            orientation: S::lit(1.0),
            negative: [false; N],
            change: Change::AtEvents,
        }
    }

    /// True if some row is a constraint.
    pub(super) fn hold(&self) -> bool {
        self.of.iter().any(|mode| mode.holds())
    }

    /// True if the gap `row` is open: it has no contact force and is not kept closed.
    pub fn is_open(&self, row: usize) -> bool {
        self.of.get(row) == Some(&Mode::Open) && !self.is_carried(row)
    }

    /// True if the friction `row` sticks, or if other rows carry it.
    pub fn is_sticking(&self, row: usize) -> bool {
        self.of.get(row) == Some(&Mode::Sticks) || self.is_carried(row)
    }

    /// True if other rows carry the row.
    pub fn is_carried(&self, row: usize) -> bool {
        self.carried.get(row) == Some(&true)
    }

    /// True if more rows are at rest than there are degrees of freedom: accelerations are unique, multipliers are
    /// not.
    pub fn are_undetermined(&self) -> bool {
        self.carried.contains(&true)
    }
}
