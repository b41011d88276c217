//! Errors as numbers.

use core::ffi::CStr;
use core::fmt;

use plm_runtime::{Cause, Fault};

/// Result of a call; 0 is success.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Status {
    /// Done.
    Ok = 0,
    /// A pointer is null.
    Null = 1,
    /// The memory is too small or not aligned.
    Memory = 2,
    /// There is no object of this mechanism.
    NoObject = 3,
    /// There is no such kind, number or name.
    NoSuch = 4,
    /// A value is infinite or not a number.
    NotFinite = 5,
    /// It can be read, not set.
    ReadOnly = 6,
    /// It has not been started.
    NotStarted = 7,
    /// The time has passed, or is not a number.
    Interval = 8,
    /// It cannot be assembled from the start values.
    Assembly = 9,
    /// A parameter has a value that the equations do not allow.
    Parameter = 10,
    /// The mechanism goes no further: it locks up, or its loops can go on in several ways.
    Pose = 11,
    /// A requirement of the declaration does not hold any more.
    Required = 12,
    /// Conditions switch without end, or a prescribed value jumps.
    Switching = 13,
    /// The accuracy was not reached.
    Accuracy = 14,
    /// Another fault.
    Fault = 15,
    /// Bytes that are no saved run, or not whole.
    Damaged = 16,
    /// A run that another version has saved.
    OtherVersion = 17,
    /// A saved run of another mechanism.
    OtherMechanism = 18,
    /// A method that the library does not have, or an option of it that cannot be.
    Choice = 19,
}

impl Status {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 20] = [
        Self::Ok,
        Self::Null,
        Self::Memory,
        Self::NoObject,
        Self::NoSuch,
        Self::NotFinite,
        Self::ReadOnly,
        Self::NotStarted,
        Self::Interval,
        Self::Assembly,
        Self::Parameter,
        Self::Pose,
        Self::Required,
        Self::Switching,
        Self::Accuracy,
        Self::Fault,
        Self::Damaged,
        Self::OtherVersion,
        Self::OtherMechanism,
        Self::Choice,
    ];

    /// Its name in C after `PLM_`, and what it means.
    pub fn words(self) -> (&'static str, &'static CStr) {
        match self {
            Self::Ok => ("OK", c"done"),
            Self::Null => ("NULL_POINTER", c"a pointer is null"),
            Self::Memory => ("MEMORY", c"the memory is too small or not aligned"),
            Self::NoObject => ("NO_OBJECT", c"the pointer is not at an object of this mechanism"),
            Self::NoSuch => ("NO_SUCH", c"there is no such kind, number or name"),
            Self::NotFinite => ("NOT_FINITE", c"the value is infinite or not a number"),
            Self::ReadOnly => ("READ_ONLY", c"it can be read, not set"),
            Self::NotStarted => ("NOT_STARTED", c"the mechanism has not been started"),
            Self::Interval => ("INTERVAL", c"the time has passed, or is not a number"),
            Self::Assembly => ("ASSEMBLY", c"it cannot be assembled from the start values"),
            Self::Parameter => {
                ("PARAMETER_VALUE", c"a parameter has a value that the equations do not allow")
            }
            Self::Pose => ("POSE", c"the mechanism goes no further from this pose"),
            Self::Required => ("REQUIRED", c"a requirement of the declaration does not hold any more"),
            Self::Switching => ("SWITCHING", c"conditions switch without end, or what is prescribed jumps"),
            Self::Accuracy => ("ACCURACY", c"the accuracy was not reached"),
            Self::Fault => ("FAULT", c"another fault"),
            Self::Damaged => {
                ("DAMAGED", c"the bytes are not a saved run, or some are missing or were changed")
            }
            Self::OtherVersion => ("OTHER_VERSION", c"the run was saved by another version of plm"),
            Self::OtherMechanism => (
                "OTHER_MECHANISM",
                c"the run was saved of another mechanism, of one declared otherwise, or for another use",
            ),
            Self::Choice => ("CHOICE", c"a tolerance is above 0 and at most 0.1, a longest step above 0, a method one of the library"),
        }
    }
}

impl From<&Fault> for Status {
    fn from(fault: &Fault) -> Self {
        match fault.cause {
            Cause::Interval { .. } => Self::Interval,
            Cause::NotAllowed { .. } | Cause::Repeats { .. } => Self::Parameter,
            Cause::Open { .. }
            | Cause::Disagree { .. }
            | Cause::OtherBranch { .. }
            | Cause::NoMotion
            | Cause::Redundant { .. }
            | Cause::VelocityOpen { .. }
            | Cause::VelocityRedundant { .. } => Self::Assembly,
            Cause::Locked
            | Cause::LockedAt { .. }
            | Cause::Flat
            | Cause::ChangePoint
            | Cause::Undecided { .. }
            | Cause::Singular { .. }
            | Cause::Sunk { .. } => Self::Pose,
            Cause::Required | Cause::NotMet { .. } => Self::Required,
            Cause::Zeno { .. }
            | Cause::NotDecided
            | Cause::Jump { .. }
            | Cause::Pole { .. }
            | Cause::Domain { .. }
            | Cause::Impact { .. }
            | Cause::NoMode { .. }
            | Cause::NotUnique { .. }
            | Cause::ImpactGains { .. }
            | Cause::Slips
            | Cause::Grazes
            | Cause::AtLimit
            | Cause::AtOnce { .. }
            | Cause::TooManyContacts { .. } => Self::Switching,
            Cause::StepTooSmall { .. }
            | Cause::TimeTooCoarse { .. }
            | Cause::StepTooLong { .. }
            | Cause::NotConverged { .. }
            | Cause::TooManySteps { .. }
            | Cause::EnergyJump { .. }
            | Cause::TurnedTooFar { .. }
            | Cause::Drift { .. } => Self::Accuracy,
            _ => Self::Fault,
        }
    }
}

/// The error of a call that did nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Error {
    /// The call was wrong.
    Call(Status),
    /// The mechanism could not do it.
    Fault(Fault),
}

impl Error {
    /// Its number.
    pub fn status(&self) -> Status {
        match self {
            Self::Call(status) => *status,
            Self::Fault(fault) => fault.into(),
        }
    }
}

/// A fault with its time and its part.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Call(status) => f.write_str(status.words().1.to_str().unwrap_or_default()),
            Self::Fault(fault) => fault.fmt(f),
        }
    }
}

impl core::error::Error for Error {}

impl From<Status> for Error {
    fn from(status: Status) -> Self {
        Self::Call(status)
    }
}

impl From<Fault> for Error {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}
