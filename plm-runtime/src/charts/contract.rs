//! Contract of mechanisms whose loops are solved in charts, and the constants of their charts.

use super::continuation::{ContinuationData, OfLoops};
use crate::held::Held;
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// A mechanism whose loops are solved in closed form; implemented by generated code.
pub trait Charted:
    System<
        U = Held<
            Self::Input,
            Self::Switches,
            Self::Turns,
            OfLoops<Self::Continuation, Self::Q>,
            Self::Contact,
        >,
        S: Real,
    >
{
    /// The inputs.
    type Input: Copy;
    /// The sides of the switches.
    type Switches: Copy;
    /// Revolutions, by count.
    type Turns: Copy + AsMut<[i32]>;
    /// Discrete state of the contact rows.
    type Contact: Copy;
    /// Continuation data, a [`Continuation`](crate::charts::Continuation).
    type Continuation: ContinuationData<Self::S>;
    /// Pose or velocity of all bodies.
    type Q: Vector<Self::S>;
    /// The charts of all mechanisms of this type.
    const CHARTS: Charts;

    /// The charts.
    #[inline]
    fn charts(&self) -> &'static Charts {
        const { &Self::CHARTS }
    }

    /// True if the mechanism has charts: always of a type that has some, and by value of one from text.
    #[inline]
    fn has_charts(&self) -> bool {
        true
    }

    /// Pose and velocity of all bodies, and the square of the measure; negative where a loop cannot be closed, zero without a
    /// chart.
    fn pose(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Q, Self::Q, Self::S);

    /// The continuation data of a state, and the square of the measure; nothing and zero without a chart.
    fn continuation(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Continuation, Self::S);

    /// Continuation data at a pose and velocity in some chart, without how far the coordinates may move.
    fn continuation_at(
        &self,
        chart: usize,
        t: Self::S,
        q: &Self::Q,
        v: &Self::Q,
    ) -> (Self::Continuation, Self::S);

    /// Writes the coordinates of a chart and their rates; first-order states stay.
    fn to_chart(&self, chart: usize, t: Self::S, q: &Self::Q, v: &Self::Q, x: &mut Self::X);
}

/// Constants of the charts of a mechanism, for every state.
#[derive(Clone, Copy, Debug)]
pub struct Charts {
    /// Number of charts.
    pub count: usize,
    /// The angles of each count of revolutions.
    pub revolutions: &'static [Revolutions],
    /// True if a coordinate whose revolutions are counted moves no loop: how far it has turned is then checked in every step.
    pub is_loose: bool,
    /// The bodies whose angles are continued, in the order of the data.
    pub turning: &'static [&'static str],
    /// By chart: indices of those angles that loops give, known but for whole revolutions.
    pub found: &'static [&'static [usize]],
    /// The bodies and joints of the unknowns of iterations, in the order of the data.
    pub iterated: &'static [&'static str],
    /// By chart, by group: the part that closes its loop.
    pub closing: &'static [&'static [&'static str]],
}

/// The angles of bodies that turn as one, whose revolutions are counted together.
#[derive(Clone, Copy, Debug)]
pub struct Revolutions {
    /// By chart: the coordinates that are such angles.
    pub coordinates: &'static [&'static [usize]],
    /// Their places among the angles of the continuation data.
    pub angles: &'static [usize],
    /// Their places among the unknowns of iterations.
    pub iterated: &'static [usize],
}
