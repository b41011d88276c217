//! Inverse dynamics: the inputs that a wanted motion needs, at a state, with feedback, and along a trajectory.
//!
//! Accelerations are affine in inputs that are forces: a = a_0 + J u. The rate on dual numbers gives a_0 and J, of trees and closed chains
//! alike, with friction and contact in the modes of the state (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, 8.12, has the same of
//! loops). More inputs than wanted accelerations are chosen by least weighted squares (Y. Nakamura, M. Ghodoussi, Dynamics computation of
//! closed-link robot mechanisms with nonredundant and redundant actuators, IEEE Trans. Robotics and Automation 5, 1989). Where an input
//! enters otherwise, as the opening of a valve, the same is a step of Newton's method.

mod error;
mod evaluated;
mod least;
mod modes;
mod names;
mod place;
mod sides;

pub use error::{NotNamed, Unsolved};
pub use names::Target;

use self::evaluated::Evaluated;
use self::least::{Dependence, least_norm};
use self::names::Found;
use crate::described::Described;
use crate::linear::Linear;
use crate::linearised::Linearisable;
use crate::mechanism::{AsMoment, Moment};
use crate::ports::Ports;
use crate::scalar::{Real, Scalar};
use crate::system::Rate;

/// Steps of Newton's method; inputs that are forces take two.
const ROUNDS: usize = 30;

/// A mechanism whose inputs can be found: generated ones can.
pub trait Invertible<const DRIVES: usize>: Linearisable + Linear<Lifted<DRIVES>: Described> {}

impl<M, const DRIVES: usize> Invertible<DRIVES> for M where M: Linearisable + Linear<Lifted<DRIVES>: Described>
{}

/// Inverse dynamics of a mechanism: which quantities are to move as wanted, and which inputs are to move them.
///
/// It neither allocates nor knows the mechanism's type, so that one value serves every run of it, on microcontrollers too.
#[derive(Clone, Copy, Debug)]
pub struct Inverse<'a, S, const TARGETS: usize, const DRIVES: usize> {
    targets: [Found<'a>; TARGETS],
    /// Numbers of inputs.
    drives: [usize; DRIVES],
    weights: [S; DRIVES],
    about: [S; DRIVES],
}

/// A wanted motion of the targets at a time, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted<S, const TARGETS: usize> {
    /// Places, m or rad; angles include revolutions. Those of [`Target::Rate`] and [`Target::Value`] are not read.
    pub place: [S; TARGETS],
    /// Velocities; of a [`Target::Rate`] the quantity itself. Those of [`Target::Value`] are not read.
    pub velocity: [S; TARGETS],
    /// Accelerations; of a [`Target::Rate`] the rate of the quantity, of a [`Target::Value`] the quantity itself.
    pub acceleration: [S; TARGETS],
}

/// Feedback of computed torque: deviations e from the wanted motion obey e'' + damping e' + stiffness e = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains<S> {
    /// Of deviations of places, 1/s^2.
    pub stiffness: S,
    /// Of deviations of velocities, 1/s.
    pub damping: S,
}

impl<S: Scalar> Gains<S> {
    /// Critical damping at a natural frequency, rad/s.
    pub fn critical(frequency: S) -> Self {
        Self { stiffness: frequency * frequency, damping: frequency + frequency }
    }
}

impl<'a, S: Real, const TARGETS: usize, const DRIVES: usize> Inverse<'a, S, TARGETS, DRIVES> {
    /// Targets and inputs by their names. A target that is a name alone is the [coordinate](Target::Coordinate) of a body: `crank.angle`.
    ///
    /// # Errors
    /// The first name that the mechanism does not have.
    pub fn new<M: Described<S = S>>(
        of: &M,
        targets: [impl Into<Target<'a>>; TARGETS],
        drives: [&'a str; DRIVES],
    ) -> Result<Self, NotNamed<'a>> {
        let mut found = [Found::NONE; TARGETS];
        for (found, target) in found.iter_mut().zip(targets) {
            *found = Found::of(of, target.into())?;
        }
        let mut numbers = [0; DRIVES];
        for (number, name) in numbers.iter_mut().zip(drives) {
            *number = names::input(of, name)?;
        }
        let one = S::lit(1.0);
        Ok(Self { targets: found, drives: numbers, weights: [one; DRIVES], about: [S::ZERO; DRIVES] })
    }

    /// Of the inputs that give the wanted motion, those with the least sum of weight (u - about)^2 are taken. Weights are positive; they are 1
    /// at first.
    #[must_use]
    pub fn weighted(self, weights: [S; DRIVES]) -> Self {
        Self { weights, ..self }
    }

    /// The inputs about which that sum is taken, as a preload of drives that work against each other; they are 0 at first.
    #[must_use]
    pub fn about(self, about: [S; DRIVES]) -> Self {
        Self { about, ..self }
    }

    /// The inputs, SI, that give the targets the wanted accelerations at a moment, in the modes of its conditions and contacts. Frictions
    /// that stick and prevent a target from moving slip to the side to which the wanted accelerations move them.
    ///
    /// # Errors
    /// [`Unsolved`]: a target that no input moves, targets that cannot move so together, a mode that the inputs would end.
    pub fn inputs<T>(
        &self,
        of: &impl AsMoment<State = T>,
        wanted: [S; TARGETS],
    ) -> Result<[S; DRIVES], Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let state = of.as_moment();
        self.inputs_in_modes(state, wanted).or_else(|held| self.inputs_from_rest(state, wanted, held))
    }

    /// As [`inputs`](Self::inputs), in the modes of the state.
    fn inputs_in_modes<T>(&self, state: &T, wanted: [S; TARGETS]) -> Result<[S; DRIVES], Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let time = state.time().to_f64();
        let (mut inputs, mut last) = (self.present(state), None);
        for _ in 0..ROUNDS {
            let now = match (self.evaluate(state, &inputs), last) {
                (Ok(now), _) => now,
                // The inputs have left what the equations allow.
                (Err(_), Some(last)) => return Err(self.not_converged(time, &last, &wanted)),
                (Err(fault), None) => return Err(Unsolved::Fault(fault)),
            };
            let next = match (self.next(&now, &inputs, &wanted), last) {
                (Ok(next), _) => next,
                (Err(Dependence::Unmoved { .. }), Some(last)) => {
                    return Err(self.not_converged(time, &last, &wanted));
                }
                (Err(dependence), _) => return Err(self.not_independent(time, dependence)),
            };
            let is_done = last.is_some() && is_solution(&now, [&inputs, &next], &wanted);
            (inputs, last) = (next, Some(now));
            if is_done {
                modes::stay(state, &self.with_inputs(state, &inputs))?;
                return Ok(inputs);
            }
        }
        let now = self.evaluate(state, &inputs)?;
        Err(self.not_converged(time, &now, &wanted))
    }

    /// Computed torque: the inputs that let deviations from the wanted motion decay by the gains.
    ///
    /// # Errors
    /// As [`inputs`](Self::inputs).
    pub fn track<T>(
        &self,
        of: &impl AsMoment<State = T>,
        wanted: &Wanted<S, TARGETS>,
        gains: Gains<S>,
    ) -> Result<[S; DRIVES], Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let (places, velocities) = self.motion(of.as_moment());
        let mut accelerations = wanted.acceleration;
        for k in 0..TARGETS {
            if let Some(place) = places[k] {
                accelerations[k] = gains.stiffness.mul_add(wanted.place[k] - place, accelerations[k]);
            }
            if let Some(velocity) = velocities[k] {
                accelerations[k] = gains.damping.mul_add(wanted.velocity[k] - velocity, accelerations[k]);
            }
        }
        self.inputs(of, accelerations)
    }

    /// Inverse dynamics along a trajectory that the targets describe wholly: gives `each` the state of every time with the inputs, by
    /// which reactions can be read there too. Nothing is integrated; from a time to the next one the poses are followed from `of`, so that
    /// times that are near each other stay on one branch. What slips is decided by the wanted velocities; at rest by the accelerations, and where
    /// these are zero too by the way to the next time.
    ///
    /// # Errors
    /// As [`inputs`](Self::inputs) and [`place`](Self::place); [`Unsolved::Free`] if the targets leave freedoms: these have to be simulated.
    pub fn over<T>(
        &self,
        of: &impl AsMoment<State = T>,
        times: impl IntoIterator<Item = S>,
        mut wanted: impl FnMut(S) -> Wanted<S, TARGETS>,
        mut each: impl FnMut(&T, [S; DRIVES]),
    ) -> Result<(), Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let mut state = *of.as_moment();
        let mut times = times.into_iter().map(|time| (time, wanted(time)));
        let mut next = times.next();
        while let Some((time, wanted)) = next {
            next = times.next();
            let (placed, freedoms) = self.placed_by_motion(&state, time, &wanted)?;
            if freedoms > 0 {
                return Err(Unsolved::Free { time: time.to_f64(), freedoms });
            }
            let placed = self.with_sides(&placed, &wanted, next.map(|(_, next)| next.place))?;
            let inputs = self.inputs(&placed, wanted.acceleration)?;
            state = self.with_inputs(&placed, &inputs);
            each(&state, inputs);
        }
        Ok(())
    }

    /// The moment with these inputs.
    pub fn with_inputs<T>(&self, of: &T, inputs: &[S; DRIVES]) -> T
    where
        T: Moment<M: Described<S = S, State = T>>,
    {
        let mut state = *of;
        let places = <T::M as Ports>::inputs(state.in_place().held);
        for (number, value) in self.drives.iter().zip(inputs) {
            if let Some(place) = <T::M as Ports>::input(places, *number) {
                *place = *value;
            }
        }
        state
    }

    /// The inputs as they are.
    fn present<T>(&self, state: &T) -> [S; DRIVES]
    where
        T: Moment<M: Described<S = S, State = T>>,
    {
        let mut held: <T::M as Rate>::U = state.held();
        let inputs = <T::M as Ports>::inputs(&mut held);
        self.drives.map(|number| <T::M as Ports>::input(inputs, number).map_or(S::ZERO, |input| *input))
    }

    /// A step of Newton's method to the inputs of least norm.
    fn next(
        &self,
        now: &Evaluated<S, TARGETS, DRIVES>,
        inputs: &[S; DRIVES],
        wanted: &[S; TARGETS],
    ) -> Result<[S; DRIVES], Dependence<S>> {
        let mut right = *wanted;
        let mut sizes = *wanted;
        for i in 0..TARGETS {
            let mut known = -now.values[i];
            for j in 0..DRIVES {
                known = now.slopes[i][j].mul_add(inputs[j] - self.about[j], known);
            }
            sizes[i] = wanted[i].abs() + now.values[i].abs();
            right[i] = right[i] + known;
        }
        let mut next = least_norm(&now.slopes, (&right, &sizes), (&self.weights, &now.scales))?;
        for (next, about) in next.iter_mut().zip(self.about) {
            *next = *next + about;
        }
        Ok(next)
    }

    fn name(&self, target: usize) -> &'a str {
        self.targets.get(target).map_or("", |found| found.name)
    }

    /// Newton's method has ended, with the target that misses most.
    fn not_converged(
        &self,
        time: f64,
        now: &Evaluated<S, TARGETS, DRIVES>,
        wanted: &[S; TARGETS],
    ) -> Unsolved<'a> {
        let (mut worst, mut misses) = (0, 0.0);
        for k in 0..TARGETS {
            let miss = (wanted[k] - now.values[k]).abs().to_f64();
            (worst, misses) = if miss > misses { (k, miss) } else { (worst, misses) };
        }
        Unsolved::NotConverged { time, target: self.name(worst), misses }
    }

    fn not_independent(&self, time: f64, dependence: Dependence<S>) -> Unsolved<'a> {
        match dependence {
            Dependence::Unmoved { row } => Unsolved::Unmoved { time, target: self.name(row) },
            Dependence::Follows { row, misses } => {
                Unsolved::Dependent { time, target: self.name(row), misses: misses.to_f64() }
            }
        }
    }
}

/// The accelerations are the wanted ones, and the inputs change no more. Below 1 in SI an acceleration counts as 1.
fn is_solution<S: Real, const TARGETS: usize, const DRIVES: usize>(
    now: &Evaluated<S, TARGETS, DRIVES>,
    [inputs, next]: [&[S; DRIVES]; 2],
    wanted: &[S; TARGETS],
) -> bool {
    (0..TARGETS).all(|i| {
        let (mut size, mut change) = (S::lit(1.0) + wanted[i].abs() + now.values[i].abs(), S::ZERO);
        for j in 0..DRIVES {
            let slope = now.slopes[i][j].abs();
            size = slope.mul_add(inputs[j].abs(), size);
            change = slope.mul_add((next[j] - inputs[j]).abs(), change);
        }
        let misses = (wanted[i] - now.values[i]).abs();
        // False for NaN.
        change <= S::RANK_TOLERANCE * size && misses <= S::RANK_TOLERANCE * size
    })
}
