//! Causes in sentences.

use core::fmt;

use super::{Cause, Names};

const LOCKS_UP: &str = "its loop cannot be closed beyond this pose: the mechanism locks up";

/// An error of so many times the state or more is reported by this bound alone.
const MANY: f64 = 10.0;

impl fmt::Display for Cause {
    #[allow(clippy::too_many_lines, reason = "a table: a line or two for each cause")]
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite => write!(f, "the state or its rate is infinite or not a number"),
            Self::NotAllowed { what, wanted, found, unit } => {
                let space = if unit.is_empty() { "" } else { " " };
                write!(f, "the {what} must be {wanted}, found {found}{space}{unit}")
            }
            Self::Singular { rows } => {
                write!(f, "the {rows} constraint rows could not be decomposed")
            }
            Self::NotRegular => f.write_str(
                "the equations of motion are nearly singular: a step by itself goes no further, `Sim` may",
            ),
            Self::Workspace { bytes, allowed } => write!(
                f,
                "a solution by rank takes {bytes} bytes of stack, and {allowed} are allowed (plm::runtime::workspace)"
            ),
            Self::StepTooSmall { step } => {
                write!(f, "the error stays above the tolerance down to a step of {step:e} s")
            }
            Self::TimeTooCoarse { step, spacing } => write!(
                f,
                "the motion asks for steps of {step:.1e} s, and times are {spacing:.1e} s apart at the end of this interval: it \
                 is too long for the digits of the scalar; shorter intervals, or `f64`"
            ),
            Self::StepTooLong { step, error } if *error < MANY => {
                let percent = 100.0 * error;
                write!(f, "a step of {step:e} s errs by about {percent:.0} % of the state; shorter steps")
            }
            Self::StepTooLong { step, .. } => {
                write!(f, "a step of {step:e} s errs by more than {MANY:.0} times the state; shorter steps")
            }
            Self::NotConverged { step } => {
                write!(
                    f,
                    "the stages of a step of {step:e} s were not found; shorter steps, or a method for stiff equations"
                )
            }
            Self::Locked => f.write_str(LOCKS_UP),
            Self::LockedAt { row, value, angular } => locked_at(f, row, *value, *angular),
            Self::TurnedTooFar { angle } => {
                write!(
                    f,
                    "a body turned by {angle:.1} rad within a step, too far to follow its loop; shorter steps"
                )
            }
            Self::Flat => write!(
                f,
                "its loop lies in one line at rest and can go on in several ways; `formulation: absolute` takes the least motion"
            ),
            Self::ChangePoint => write!(f, "its loop lies in one line and could go on in several ways"),
            Self::Undecided { gap } => write!(
                f,
                "its loop comes to lie in one line but for a difference of {gap:.1e} m in its lengths: so little that \
                 rounding decides which way it goes on; make the lengths equal, or differ by more"
            ),
            Self::EnergyJump { by, of } => {
                write!(
                    f,
                    "the energy jumps by {} J, of {} J that move, without work of any force",
                    Short(*by),
                    Short(*of)
                )
            }
            Self::TooManySteps { steps } => write!(f, "the interval needs more than {steps} steps"),
            Self::NotDecided => f.write_str(
                "it stays so near to its boundary that no part of a step tells its side: where it reads the direction of what is at rest, or a \
                 difference that is rounding, let it begin a little away from there",
            ),
            Self::Required => write!(f, "this requirement does not hold any more"),
            Self::NotMet { by } => not_met(f, *by),
            Self::Pole { by } => write!(f, "a pole: it divides by `{by}`, which passes zero"),
            Self::Domain { of } => write!(f, "`{of}` is not defined beyond this"),
            Self::Jump { by, angular, speed } => jump(f, *by, if *angular { "rad" } else { "m" }, *speed),
            Self::Zeno { events, within, conditions } => {
                match events {
                    0 => f.write_str("at rest where events without end throw it back")?,
                    _ => write!(f, "switches without end: {events} times within {within:.0e} s")?,
                }
                for (i, condition) in conditions.iter().enumerate() {
                    write!(f, "{} `{condition}`", if i == 0 { ", by" } else { " and" })?;
                }
                Ok(())
            }
            Self::Impact { .. }
            | Self::NoMode { .. }
            | Self::NotUnique { .. }
            | Self::ImpactGains { .. }
            | Self::TooManyContacts { .. }
            | Self::Sunk { .. }
            | Self::Slips => contact(f, self),
            Self::Interval { length } => interval(f, *length),
            Self::Grazes | Self::AtLimit | Self::AtOnce { .. } => underivable(f, self),
            Self::Drift { phi, phi_dot } => drift(f, *phi, *phi_dot),
            Self::Redundant { count, locks, joints } => redundant(f, *count, "position", locks, joints),
            Self::VelocityRedundant { count, locks, joints } => {
                redundant(f, *count, "velocity", locks, joints)
            }
            Self::Repeats { joints } => repeats(f, joints),
            Self::Disagree { gap, joints } => disagree(f, *gap, joints),
            Self::Open { gap } => {
                write!(f, "the mechanism cannot be assembled: {} m or rad stay open", Short(*gap))
            }
            Self::OtherBranch { first, second, left } => {
                let (found, asked) = if *left { ("left", "right") } else { ("right", "left") };
                write!(
                    f,
                    "on the way along {first} to this joint and on along {second} one turns {found}, and no pose was found where one \
                     turns {asked}; start nearer to it"
                )
            }
            Self::NoMotion => f.write_str(
                "the start is a change point, as of a loop that lies in one line: it can go on in two ways, and the start velocities \
                 belong to neither; give the angles of bodies of the loop, so that the start lies beside it",
            ),
            Self::VelocityOpen { gap } => {
                write!(f, "the start velocities contradict the joints by {} m/s or rad/s", Short(*gap))
            }
        }
    }
}

/// A number with three digits: more would not explain a fault better.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (number, size) = (self.0, self.0.abs());
        if !(1e-3..1e4).contains(&size) {
            return write!(f, "{number:.2e}");
        }
        let decimals = [100.0, 10.0, 1.0, 0.1, 0.01].iter().take_while(|bound| size < **bound).count();
        write!(f, "{number:.decimals$}")
    }
}

/// Why a run has no derivatives from here on.
fn underivable(f: &mut fmt::Formatter<'_>, cause: &Cause) -> fmt::Result {
    match cause {
        Cause::AtLimit => f.write_str(
            "there are other derivatives to either side: it is at its limit, and what the run is derived by says whether it holds",
        ),
        Cause::AtOnce { other } => write!(
            f,
            "no derivatives go beyond this event: `{other}` happens at the same time, and what the run is derived by says which of the two \
             is first"
        ),
        _ => f.write_str(
            "no derivatives go beyond this event: the motion touches its boundary and does not cross it",
        ),
    }
}

/// How long an interval is that is none.
fn interval(f: &mut fmt::Formatter<'_>, length: f64) -> fmt::Result {
    // A number so small would fill lines with zeros.
    if length.abs() < 1e-5 && length != 0.0 {
        return write!(f, "an interval of {length:e} s cannot be integrated");
    }
    write!(f, "an interval of {length} s cannot be integrated")
}

/// Text for redundant joints: what repeats what, and why that may be.
fn repeats(f: &mut fmt::Formatter<'_>, joints: &Names) -> fmt::Result {
    write!(
        f,
        "with these parameters {joints} hold what others hold already: pins of a loop coincide, or lengths repeat each \
                 other, so that something is free to turn that has no coordinate here; other lengths or angles, or \
                 `formulation: absolute`, or such parameters as defaults"
    )
}

/// By how much lengths disagree, and what to do.
fn disagree(f: &mut fmt::Formatter<'_>, gap: f64, joints: &Names) -> fmt::Result {
    write!(
        f,
        "lengths that repeat each other disagree, and {gap:.1e} m or rad stay open: {joints} hold the same; make the \
                 lengths equal, or let a joint give way with a `compliance`"
    )
}

/// A requirement that does not hold, or is left at once.
fn not_met(f: &mut fmt::Formatter<'_>, by: f64) -> fmt::Result {
    if by > 0.0 {
        return write!(f, "this requirement does not hold, by {} in SI units", Short(by));
    }
    write!(f, "the motion leaves this requirement at once, which holds by {} in SI units", Short(by.abs()))
}

/// Text for a jump: what jumps, and what to do.
fn jump(f: &mut fmt::Formatter<'_>, by: f64, unit: &str, speed: bool) -> fmt::Result {
    if speed {
        return write!(
            f,
            "the speed that this row holds jumps by {} {unit}/s; its sides must meet smoothly, as in `smooth_table`",
            Short(by)
        );
    }
    write!(f, "the place that this row holds jumps by {} {unit}; its sides must agree", Short(by))
}

/// Texts for faults of contact and friction.
fn contact(f: &mut fmt::Formatter<'_>, cause: &Cause) -> fmt::Result {
    match cause {
        Cause::Impact { tried } => write!(
            f,
            "its impact has no solution after {tried} impulses at one time; a smaller coefficient of restitution or of friction"
        ),
        Cause::ImpactGains { by, of } => write!(
            f,
            "its impact would gain {by:.6e} J, of {of:.6e} J that the impulses turn over: Newton's law with friction, or of several \
             contacts; Poisson's law never does"
        ),
        Cause::NoMode { touching, p } if *p < 0.0 => write!(
            f,
            "no forces of {touching} closed gaps and their friction satisfy all laws: what slides digs in, p = D_nn - sigma mu D_nt is \
             {p:.3} of D_nn (Painleve's paradox); less friction, or a contact that gives way"
        ),
        Cause::NoMode { touching, .. } => write!(
            f,
            "no forces of {touching} closed gaps and their friction satisfy all laws; less friction, or a contact that gives way"
        ),
        Cause::NotUnique { p } => write!(
            f,
            "it slips to where contact has no unique acceleration, p = D_nn - sigma mu D_nt passes zero ({p:.1e} of D_nn): beyond, sliding \
             on, lifting off and an impact satisfy all laws, and rigid bodies leave open which (Painleve's paradox); less \
             friction, or a contact that gives way"
        ),
        Cause::TooManyContacts { touching } => write!(
            f,
            "{touching} gaps close at once, with friction: more than are told apart; fewer points of contact"
        ),
        Cause::Sunk { by } => {
            // Differences of rounded numbers end in digits that mean nothing.
            f.write_str("the start has sunk in: the gap is negative by ")?;
            let written = if *by < 1e-3 { write!(f, "{by:.1e}") } else { write!(f, "{by:.4}") };
            written?;
            f.write_str(" m or rad; begin where it is zero or open")
        }
        Cause::Slips => f.write_str(
            "it slips with all the friction that it has, where all else could rest; more friction, or a stop",
        ),
        _ => Ok(()),
    }
}

/// Text for drift: which of the two residuals it is, and what to do.
fn drift(f: &mut fmt::Formatter<'_>, phi: f64, phi_dot: f64) -> fmt::Result {
    // The projection takes positions to rounding wherever joints can be closed: velocities that it cannot take there contradict
    // each other.
    if phi < 1e-9 && phi < phi_dot {
        return write!(
            f,
            "the pose is singular: this joint is closed, but {} m/s or rad/s of its velocity cannot be taken away; \
             shorter steps, or a `compliance` at this joint",
            Short(phi_dot)
        );
    }
    write!(
        f,
        "the joints come apart by {} m or rad, {} m/s or rad/s, and cannot be closed again; shorter steps, \
         or a `compliance` at this joint",
        Short(phi),
        Short(phi_dot)
    )
}

fn redundant(
    f: &mut fmt::Formatter<'_>,
    count: usize,
    what: &str,
    locks: &Names,
    joints: &Names,
) -> fmt::Result {
    let plural = if count == 1 { "" } else { "s" };
    write!(f, "{count} redundant {what} constraint{plural}: ")?;
    if what == "velocity" {
        locks.write_rates(f)?;
    } else {
        write!(f, "{locks:#}")?;
    }
    if !joints.is_empty() {
        write!(f, ", tied by {joints}")?;
    }
    Ok(())
}

/// Which drive can go no further, and where.
fn locked_at(f: &mut fmt::Formatter<'_>, row: &str, value: f64, angular: bool) -> fmt::Result {
    write!(f, "{LOCKS_UP}; `{row}` can go no further than {value:.6} ")?;
    if angular { write!(f, "rad ({:.3} deg)", value.to_degrees()) } else { f.write_str("m") }
}
