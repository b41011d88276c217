//! The members of bodies and frames, as a table.

use crate::collect::CollectVec;
use Of::{Angle, Axis, Body, Normal, Position, X, Y};

/// Values with members.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Owner {
    Body,
    Frame,
}

/// A member of a body, of a frame, or of both.
pub(crate) struct Member {
    pub(crate) name: &'static str,
    pub(crate) of: Of,
    /// How often it is derived with respect to time.
    pub(crate) order: u8,
    /// Its owners.
    owners: &'static [Owner],
    /// Owners of which it is shown when they are observed, in the order of the table.
    observed: &'static [Owner],
}

/// Quantity of a pose that a member is, or of which it is a derivative.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Of {
    /// The first component of the position, m.
    X,
    /// The second component of the position, m.
    Y,
    /// Of G or of the point of a frame, m.
    Position,
    /// Against the absolute x axis, rad.
    Angle,
    /// Unit vector along the x axis.
    Axis,
    /// Unit vector along the y axis.
    Normal,
    /// The body of a frame.
    Body,
}

const BODY: &[Owner] = &[Owner::Body];
const FRAME: &[Owner] = &[Owner::Frame];
const BOTH: &[Owner] = &[Owner::Body, Owner::Frame];

static MEMBERS: [Member; 15] = [
    member("x", X, 0, BOTH, BODY),
    member("y", Y, 0, BOTH, BODY),
    member("position", Position, 0, BOTH, FRAME),
    member("angle", Angle, 0, BOTH, BOTH),
    member("axis", Axis, 0, BOTH, &[]),
    member("normal", Normal, 0, BOTH, &[]),
    member("vx", X, 1, BODY, BODY),
    member("vy", Y, 1, BODY, BODY),
    member("velocity", Position, 1, BOTH, FRAME),
    member("omega", Angle, 1, BOTH, BODY),
    member("ax", X, 2, BODY, BODY),
    member("ay", Y, 2, BODY, BODY),
    member("acceleration", Position, 2, BOTH, FRAME),
    member("alpha", Angle, 2, BOTH, BODY),
    member("body", Body, 0, FRAME, &[]),
];

const fn member(
    name: &'static str,
    of: Of,
    order: u8,
    owners: &'static [Owner],
    observed: &'static [Owner],
) -> Member {
    Member { name, of, order, owners, observed }
}

impl Member {
    /// A member of a body or of a frame by its name.
    pub(crate) fn named(owner: Owner, name: &str) -> Option<&'static Member> {
        MEMBERS.iter().find(|member| member.name == name && member.owners.contains(&owner))
    }

    /// Names of all members of bodies or of frames.
    pub(crate) fn names(owner: Owner) -> Vec<&'static str> {
        MEMBERS.iter().filter(|member| member.owners.contains(&owner)).map(|member| member.name).collect_vec()
    }

    /// Observed members of a body at its centre of gravity, or of a port.
    pub(crate) fn observed(owner: Owner) -> impl Iterator<Item = &'static Member> {
        MEMBERS.iter().filter(move |member| member.observed.contains(&owner))
    }

    /// Is it a vector? Else it is a number.
    pub(crate) fn is_vector(&self) -> bool {
        matches!(self.of, Position | Axis | Normal)
    }

    /// Is there a member of this name that is a vector?
    pub(crate) fn names_vector(name: &str) -> bool {
        MEMBERS.iter().any(|member| member.name == name && member.is_vector())
    }
}
