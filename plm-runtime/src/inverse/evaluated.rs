//! Targets and how inputs change them, by dual numbers.

use super::names::Quantity;
use super::{Inverse, Invertible};
use crate::described::Described;
use crate::dual::Dual;
use crate::fault::{Cause, Fault};
use crate::linear::Linear;
use crate::mechanism::{Mechanism, Moment};
use crate::ports::Ports;
use crate::scalar::{Real, Scalar};
use crate::system::{Constraints, Rate};
use crate::vector::Vector;

/// Wanted quantities at a moment: accelerations, rates or values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Evaluated<S, const TARGETS: usize, const DRIVES: usize> {
    pub(super) values: [S; TARGETS],
    /// Of each target its derivatives by the inputs.
    pub(super) slopes: [[S; DRIVES]; TARGETS],
    /// Of each input its largest effect on a rate of the state.
    pub(super) scales: [S; DRIVES],
}

type Lifted<M, const K: usize> = <M as Linear>::Lifted<K>;
type X<M, const K: usize> = <Lifted<M, K> as Rate>::X;
type State<M, const K: usize> = <Lifted<M, K> as Mechanism>::State;

impl<S: Real, const TARGETS: usize, const DRIVES: usize> Inverse<'_, S, TARGETS, DRIVES> {
    /// The targets with these inputs.
    pub(super) fn evaluate<T>(
        &self,
        state: &T,
        inputs: &[S; DRIVES],
    ) -> Result<Evaluated<S, TARGETS, DRIVES>, Fault>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let (mechanism, time) = (state.mechanism(), state.time());
        let (lifted, mut held) = mechanism.lift::<DRIVES>(&state.held());
        let fixed = held;
        for (k, number) in self.drives.iter().enumerate() {
            let places = <Lifted<T::M, DRIVES>>::inputs(&mut held);
            if let (Some(place), Some(value)) =
                (<Lifted<T::M, DRIVES>>::input(places, *number), inputs.get(k))
            {
                *place = Dual::variable(*value, k);
            }
        }
        let x = X::<T::M, DRIVES>::from_fn(|i| Dual::constant(state.x().at(i)));
        let at = Dual::constant(time);
        let mut rate = x;
        let health = lifted.rate(at, &held, &x, &mut rate);
        if !mechanism.is_regular(&state.held()) || !health.is_good() {
            let rows = mechanism.states();
            return Err(Fault::new(time.to_f64(), Cause::Singular { rows }));
        }
        if !rate.is_finite() {
            return Err(Fault::new(time.to_f64(), Cause::NotFinite));
        }
        // The rate of h(t, x) is h_t + h_x x', and x' alone depends on inputs.
        let way = X::<T::M, 1>::from_fn(|i| Dual { value: state.x().at(i), tangents: [rate.at(i).value] });
        let (along, held_along) = mechanism.lift::<1>(&state.held());
        let along = State::<T::M, 1>::new(along, held_along, Dual::variable(time, 0), way);
        let ways =
            X::<T::M, DRIVES>::from_fn(|i| Dual { value: state.x().at(i), tangents: rate.at(i).tangents });
        let across = State::<T::M, DRIVES>::new(lifted, fixed, at, ways);
        let here = State::<T::M, DRIVES>::new(lifted, held, at, x);
        let mut all = Evaluated {
            values: [S::ZERO; TARGETS],
            slopes: [[S::ZERO; DRIVES]; TARGETS],
            scales: scales(mechanism, &rate),
        };
        self.coordinates::<T::M>(&along, &across, &mut all);
        self.observed::<T::M>(&along, &across, &here, &mut all);
        Ok(all)
    }

    /// Accelerations of coordinates of bodies.
    fn coordinates<M: Invertible<DRIVES, S = S>>(
        &self,
        along: &State<M, 1>,
        across: &State<M, DRIVES>,
        all: &mut Evaluated<S, TARGETS, DRIVES>,
    ) {
        let is_one = |quantity: Quantity| matches!(quantity, Quantity::Coordinate(..));
        if !self.targets.iter().any(|target| is_one(target.quantity)) {
            return;
        }
        let mut number = 0;
        <Lifted<M, 1>>::poses(along, &mut |pose| {
            for (target, value) in self.targets.iter().zip(&mut all.values) {
                if let Quantity::Coordinate(body, axis) = target.quantity
                    && body == number
                {
                    let [_, velocity] = axis.of(&pose);
                    [*value] = velocity.tangents;
                }
            }
            number += 1;
        });
        number = 0;
        <Lifted<M, DRIVES>>::poses(across, &mut |pose| {
            for (target, slopes) in self.targets.iter().zip(&mut all.slopes) {
                if let Quantity::Coordinate(body, axis) = target.quantity
                    && body == number
                {
                    let [_, velocity] = axis.of(&pose);
                    *slopes = velocity.tangents;
                }
            }
            number += 1;
        });
    }

    /// Rates and values of observed quantities.
    fn observed<M: Invertible<DRIVES, S = S>>(
        &self,
        along: &State<M, 1>,
        across: &State<M, DRIVES>,
        here: &State<M, DRIVES>,
        all: &mut Evaluated<S, TARGETS, DRIVES>,
    ) {
        let lines = all.values.iter_mut().zip(&mut all.slopes);
        for (target, (value, slopes)) in self.targets.iter().zip(lines) {
            match target.quantity {
                Quantity::Coordinate(..) => {}
                Quantity::Rate(index) => {
                    let rate = <Lifted<M, 1>>::observed(along, index).map(|number| number.tangents);
                    let change = <Lifted<M, DRIVES>>::observed(across, index).map(|number| number.tangents);
                    if let (Some([rate]), Some(change)) = (rate, change) {
                        (*value, *slopes) = (rate, change);
                    }
                }
                Quantity::Value(index) => {
                    if let Some(number) = <Lifted<M, DRIVES>>::observed(here, index) {
                        (*value, *slopes) = (number.value, number.tangents);
                    }
                }
            }
        }
    }

    /// Places and velocities of the targets that have some.
    pub(super) fn motion<T>(&self, state: &T) -> ([Option<S>; TARGETS], [Option<S>; TARGETS])
    where
        T: Moment<M: Described<S = S, State = T>>,
    {
        let (mut places, mut velocities) = ([None; TARGETS], [None; TARGETS]);
        let mut number = 0;
        <T::M as Described>::poses(state, &mut |pose| {
            for (k, target) in self.targets.iter().enumerate() {
                if let Quantity::Coordinate(body, axis) = target.quantity
                    && body == number
                {
                    let [place, velocity] = axis.of(&pose);
                    (places[k], velocities[k]) = (Some(place), Some(velocity));
                }
            }
            number += 1;
        });
        for (target, velocity) in self.targets.iter().zip(&mut velocities) {
            if let Quantity::Rate(index) = target.quantity {
                *velocity = <T::M as Described>::observed(state, index);
            }
        }
        (places, velocities)
    }
}

/// Of each input its largest effect on a rate of the state.
fn scales<M: Rate, const DRIVES: usize>(
    mechanism: &M,
    rate: &impl Vector<Dual<M::S, DRIVES>>,
) -> [M::S; DRIVES]
where
    M::S: Real,
{
    let mut scales = [M::S::lit(0.0); DRIVES];
    for place in (0..M::X::LEN).filter(|place| mechanism.has_number(*place)) {
        for (scale, tangent) in scales.iter_mut().zip(rate.at(place).tangents) {
            *scale = scale.max(tangent.abs());
        }
    }
    scales
}
