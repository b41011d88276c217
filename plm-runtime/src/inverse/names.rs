//! Targets and inputs by their names.

use super::error::NotNamed;
use crate::body::BodyMotion;
use crate::described::Described;

/// A quantity that is to move as wanted, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target<'a> {
    /// A coordinate of a body, `crank.angle` or `slider.x`: its acceleration is wanted.
    Coordinate(&'a str),
    /// An observed quantity that reads places and velocities alone, as `elbow.omega`: its rate is wanted.
    Rate(&'a str),
    /// An observed quantity that reads accelerations, reactions or inputs, as `gripper.force.x`: its value is wanted.
    Value(&'a str),
}

impl<'a> From<&'a str> for Target<'a> {
    fn from(name: &'a str) -> Self {
        Self::Coordinate(name)
    }
}

/// A target that the mechanism has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found<'a> {
    pub(super) name: &'a str,
    pub(super) quantity: Quantity,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    /// A body by its number, and one of its coordinates.
    Coordinate(usize, Axis),
    /// The rate of an observed quantity by its number.
    Rate(usize),
    /// An observed quantity by its number.
    Value(usize),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    X,
    Y,
    Angle,
}

impl Axis {
    /// Place and velocity.
    pub(super) fn of<S: Copy>(self, motion: &BodyMotion<S>) -> [S; 2] {
        match self {
            Self::X => [motion.x, motion.vx],
            Self::Y => [motion.y, motion.vy],
            Self::Angle => [motion.angle, motion.omega],
        }
    }
}

impl<'a> Found<'a> {
    pub(super) const NONE: Self = Self { name: "", quantity: Quantity::Value(usize::MAX) };

    pub(super) fn of<M: Described>(mechanism: &M, target: Target<'a>) -> Result<Self, NotNamed<'a>> {
        let (name, quantity) = match target {
            Target::Coordinate(name) => {
                (name, coordinate(mechanism, name).ok_or(NotNamed::Coordinate(name))?)
            }
            Target::Rate(name) => (name, Quantity::Rate(observed(mechanism, name)?)),
            Target::Value(name) => (name, Quantity::Value(observed(mechanism, name)?)),
        };
        Ok(Self { name, quantity })
    }
}

fn coordinate<M: Described>(mechanism: &M, name: &str) -> Option<Quantity> {
    let axes = [(".x", Axis::X), (".y", Axis::Y), (".angle", Axis::Angle)];
    let (body, axis) =
        axes.into_iter().find_map(|(end, axis)| name.strip_suffix(end).map(|body| (body, axis)))?;
    let body = mechanism.tables().bodies.iter().position(|own| own.name == body)?;
    Some(Quantity::Coordinate(body, axis))
}

fn observed<'a, M: Described>(mechanism: &M, name: &'a str) -> Result<usize, NotNamed<'a>> {
    let mut all = mechanism.observables().iter();
    all.position(|(own, _)| *own == name).ok_or(NotNamed::Observed(name))
}

pub(super) fn input<'a, M: Described>(mechanism: &M, name: &'a str) -> Result<usize, NotNamed<'a>> {
    let mut all = mechanism.input_names().iter();
    all.position(|(own, _)| *own == name).ok_or(NotNamed::Input(name))
}
