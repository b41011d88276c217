//! Errors as values: when, where and why a run or an assembly stopped.

mod names;
mod texts;

use core::fmt;

pub use names::Names;

/// Why a run or an assembly stopped, at which time, in which part.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it, and `unwrap`, show that one.
#[derive(Clone, Copy, PartialEq)]
pub struct Fault {
    /// The time, s.
    pub time: f64,
    /// The part by its name in the declaration; empty where no single part is to blame.
    pub part: &'static str,
    /// Cause of the fault.
    pub cause: Cause,
}

/// Cause of a fault.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// A state or its rate is infinite or not a number.
    NotFinite,
    /// A parameter gives the part a value that the equations do not allow: what the compiler says of such a literal.
    NotAllowed {
        /// Quantity of the part: `mass`, `inertia`, `compliance`, `parameter`.
        what: &'static str,
        /// Description of the allowed values.
        wanted: &'static str,
        /// Value that was found.
        found: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// The equations of motion could not be decomposed.
    Singular {
        /// Number of constraint rows.
        rows: usize,
    },
    /// They are nearly singular, where a step by itself ([`step`](crate::step)) does not know a second way.
    NotRegular,
    /// They had to be decomposed by rank, which would take more of the stack than is allowed
    /// ([`workspace`](crate::workspace)).
    Workspace {
        /// Stack that the solution would need, bytes.
        bytes: usize,
        /// Stack that is allowed, bytes.
        allowed: usize,
    },
    /// The error stayed above the tolerance down to the smallest step.
    StepTooSmall {
        /// The last step tried, s.
        step: f64,
    },
    /// The time has too few digits for the steps that the motion asks for: the interval is too long for the numbers.
    TimeTooCoarse {
        /// The step that was asked for, s.
        step: f64,
        /// How far apart times are at the end of the interval, s.
        spacing: f64,
    },
    /// The estimated error of a step of fixed length is out of all proportion.
    StepTooLong {
        /// The step, s.
        step: f64,
        /// The error as a fraction of the size of the state.
        error: f64,
    },
    /// The stages of an implicit step were not found.
    NotConverged {
        /// The step, s.
        step: f64,
    },
    /// A loop cannot be closed any further: the mechanism locks up. Where that is because lengths that repeat each other
    /// disagree, a joint can be declared to give way, with a `compliance`.
    Locked,
    /// As [`Locked`](Self::Locked), but for a driven mechanism: a prescribed motion can go no further. The time is that at which it ends.
    LockedAt {
        /// The constraint row that prescribes the motion.
        row: &'static str,
        /// Value of the row at that time, m or rad.
        value: f64,
        /// The row is an angle.
        angular: bool,
    },
    /// A body turned so far within a step that its loop could not be followed.
    TurnedTooFar {
        /// The angle, rad.
        angle: f64,
    },
    /// The bars of a loop lie in one line at rest: it can go on in several ways.
    Flat,
    /// A pose was reached where the mechanism can go on in several ways, and the run was to stop there; or it is derived by lengths beside
    /// which there is no such pose, so that it has no derivatives beyond.
    ChangePoint,
    /// The lengths of a loop differ so little from those with which it could go on in several ways that rounding decides.
    Undecided {
        /// The difference, m.
        gap: f64,
    },
    /// The energy jumped by what no force has done.
    EnergyJump {
        /// By how much, J.
        by: f64,
        /// Kinetic energy and work in the step, J.
        of: f64,
    },
    /// The interval needed more internal steps than allowed.
    TooManySteps {
        /// The number allowed.
        steps: u64,
    },
    /// A requirement of the part is violated; the time is that at which this began.
    Required,
    /// A requirement of the part does not hold at the start of the run, or after a change by the caller.
    NotMet {
        /// How far it is from holding, in the SI unit of what it compares; zero or less on its boundary, which the motion leaves to the
        /// wrong side.
        by: f64,
    },
    /// A divisor in a row, a force or a rate passes zero. The part is the row, the element or the state.
    Pole {
        /// Divisor that passes zero.
        by: &'static str,
    },
    /// A function in a row, a force or a rate is not defined beyond this. The part is the row, the element or the state.
    Domain {
        /// The function.
        of: &'static str,
    },
    /// The two sides of a constraint row differ where a condition in it changes: what it holds would have to jump, or would
    /// need an impulse. The part is the row.
    Jump {
        /// By how much: m, rad, or that over s.
        by: f64,
        /// The row is an angle.
        angular: bool,
        /// The speed jumps, not the place.
        speed: bool,
    },
    /// A condition switches more and more often: the times have a limit that they do not pass.
    Zeno {
        /// How often something switched; 0 where flights of no height would follow each other.
        events: u32,
        /// In how short a time, s.
        within: f64,
        /// The conditions that took part, as they were written.
        conditions: Names,
    },
    /// A condition stays so near to its boundary that its side is not decided, in many places of a step. The part is the condition, or the
    /// row of contact.
    NotDecided,
    /// Impacts have no end, or no impulses satisfy their law. The part is a row that approaches.
    Impact {
        /// Impacts that were tried at this time.
        tried: u32,
    },
    /// An impact gains energy, as Newton's law can. The part is a row that approaches.
    ImpactGains {
        /// By how much, J.
        by: f64,
        /// Energy that impulses and rates turn over, J.
        of: f64,
    },
    /// No forces of contact and friction satisfy all their laws: a body that slides digs in (Painleve). The part is a row that touches.
    NoMode {
        /// Rows that touch.
        touching: usize,
        /// The share of D_nn that friction leaves, p = 1 - sigma mu D_nt/D_nn, where all of them are closed: negative where a slip is to
        /// blame, not a number where it is not known.
        p: f64,
    },
    /// A slip has come to where contact has no unique acceleration (Painleve). The part is the row whose contact force does not
    /// change its normal acceleration there.
    NotUnique {
        /// The share of D_nn that friction leaves, p = 1 - sigma mu D_nt/D_nn: zero, or a little beyond.
        p: f64,
    },
    /// More rows of contact and friction come to rest at once than modes can be determined for.
    TooManyContacts {
        /// Gaps that are closed.
        touching: usize,
    },
    /// A gap is negative where the run begins.
    Sunk {
        /// By how much, m or rad.
        by: f64,
    },
    /// No static equilibrium: the friction slips where all else could rest. The part is its row.
    Slips,
    /// An interval ends before it begins, or is not a number.
    Interval {
        /// Its length, s.
        length: f64,
    },
    /// The run has no derivatives beyond this event: its condition touches its boundary and does not cross it. The part is the condition.
    Grazes,
    /// The run has other derivatives to either side from here on: the row begins at its limit, and holds or lets go for what the run is
    /// derived by. The part is the row.
    AtLimit,
    /// The run has no derivatives beyond this event, or other ones to either side: another one happens at the same time, and which of the
    /// two is first depends on what the run is derived by. The part is the condition.
    AtOnce {
        /// The condition of the other.
        other: &'static str,
    },
    /// The projection onto the constraints did not converge.
    Drift {
        /// Largest residual of position, m or rad.
        phi: f64,
        /// Largest residual of velocity, m/s or rad/s.
        phi_dot: f64,
    },
    /// Locks repeat what joints or other locks already say about the start position. Joints do so as well if their lengths
    /// repeat each other but for a small error; a `compliance` at one of them takes it up.
    Redundant {
        /// How many locks are too many.
        count: usize,
        /// The locked coordinates that depend on each other.
        locks: Names,
        /// The joints through which they do.
        joints: Names,
    },
    /// With these parameters joints repeat what others say, which they do not with those that were declared: the coordinates
    /// leave out a freedom.
    Repeats {
        /// The joints.
        joints: Names,
    },
    /// Redundant joints disagree: their lengths contradict each other. The part is the joint that stays open widest.
    Disagree {
        /// By how much, m or rad.
        gap: f64,
        /// The joints that repeat each other.
        joints: Names,
    },
    /// The joints cannot be closed; the part is the one that stays open widest.
    Open {
        /// Remaining gap, m or rad.
        gap: f64,
    },
    /// The mechanism was assembled on another mirror image than the joint, which is the part, asks for; that one was not
    /// found.
    OtherBranch {
        /// The first body of the joint.
        first: &'static str,
        /// The second.
        second: &'static str,
        /// True if the second body turns left from the first in the image found, while the joint asks for right; false for the reverse.
        left: bool,
    },
    /// The start is a change point, as of a linkage that lies in one line, from which two motions leave; the start velocities belong to
    /// neither. The part is a joint of the loop.
    NoMotion,
    /// Locks repeat what joints or other locks already say about the start velocity.
    VelocityRedundant {
        /// How many locks are too many.
        count: usize,
        /// The locked coordinates that depend on each other.
        locks: Names,
        /// The joints through which they do.
        joints: Names,
    },
    /// The start velocities contradict the joints; the part is the one that is violated most.
    VelocityOpen {
        /// Remaining violation, m/s or rad/s.
        gap: f64,
    },
}

impl Fault {
    /// A fault that no single part is to blame for.
    pub fn new(time: f64, cause: Cause) -> Self {
        Self { time, part: "", cause }
    }

    /// A fault of a part.
    pub fn of_part(time: f64, part: &'static str, cause: Cause) -> Self {
        Self { time, part, cause }
    }
}

impl core::error::Error for Fault {}

impl fmt::Debug for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "t = {} s: ", self.time)?;
        if !self.part.is_empty() {
            write!(f, "{}: ", self.part)?;
        }
        write!(f, "{}", self.cause)
    }
}
