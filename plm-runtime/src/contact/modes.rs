//! Modes of contact rows, held over a step.

use core::fmt;

use crate::scalar::{Real, Scalar};

/// What a row does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// A gap is open, or closed by other rows alone: no push.
    Open,
    /// A gap is closed.
    Closed,
    /// A friction has no normal force.
    Off,
    /// A friction holds.
    Sticks,
    /// It slips, with a positive rate.
    Forwards,
    /// It slips, with a negative rate.
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
    /// The row is a constraint.
    pub fn holds(self) -> bool {
        matches!(self, Self::Closed | Self::Sticks)
    }

    /// The friction slips.
    pub fn slips(self) -> bool {
        matches!(self, Self::Forwards | Self::Backwards)
    }

    /// All modes, in the order of their numbers.
    pub const ALL: [Self; 6] =
        [Self::Open, Self::Closed, Self::Off, Self::Sticks, Self::Forwards, Self::Backwards];

    /// Its number, in saved runs and in other languages.
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

    /// The mode of a friction that slips with this rate; none where it does not.
    pub(super) fn of_slip<S: Real>(rate: S) -> Option<Self> {
        if rate > S::ZERO {
            Some(Self::Forwards)
        } else if rate < S::ZERO {
            Some(Self::Backwards)
        } else {
            None
        }
    }

    /// -1 or 1, the sign of the slip; zero where there is none.
    pub(super) fn sign<T: Scalar>(self) -> T {
        T::lit(match self {
            Self::Forwards => 1.0,
            Self::Backwards => -1.0,
            _ => 0.0,
        })
    }
}

/// When the modes of rows change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Change {
    /// At events, which are located: a step has one mode.
    #[default]
    AtEvents,
    /// In every step, by a method that steps over them.
    InSteps,
    /// Where the state is set: frictions that stick hold nothing until then, and the velocities decide what slips
    /// ([`state_was_set`](super::state_was_set)). It is for a state that is placed by a motion, not for a run.
    WhereSet,
}

/// The modes of all rows, and what they remember.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modes<S, const N: usize> {
    /// The mode of each row.
    pub of: [Mode; N],
    /// The row rests without being a constraint, since others hold it: more rows rest than there are freedoms.
    pub carried: [bool; N],
    /// Where a friction sticks: its displacement, m or rad.
    pub place: [S; N],
    /// One over the determinant of the active rows when the modes were chosen.
    pub orientation: S,
    /// By reaction that bounds frictions: it is negative.
    pub negative: [bool; N],
    /// When they change.
    pub change: Change,
}

impl<S: Scalar, const N: usize> Modes<S, N> {
    /// Everything is open.
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

    /// Some row holds.
    pub(super) fn hold(&self) -> bool {
        self.of.iter().any(|mode| mode.holds())
    }

    /// The gap `row` is open: it neither pushes nor rests.
    pub fn is_open(&self, row: usize) -> bool {
        self.of.get(row) == Some(&Mode::Open) && !self.is_carried(row)
    }

    /// The friction `row` does not slip.
    pub fn is_sticking(&self, row: usize) -> bool {
        self.of.get(row) == Some(&Mode::Sticks) || self.is_carried(row)
    }

    /// Other rows hold the row.
    pub fn is_carried(&self, row: usize) -> bool {
        self.carried.get(row) == Some(&true)
    }

    /// More rows rest than there are freedoms: accelerations are unique, multipliers are not.
    pub fn are_undetermined(&self) -> bool {
        self.carried.contains(&true)
    }
}
