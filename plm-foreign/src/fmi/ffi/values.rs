//! Values of variables, states and rates.

use alloc::vec::Vec;

use plm_runtime::{Moment, Rate, Vector};

use super::{Handle, Outcome, fill, opened, put, read, with};
use crate::fmi::{Call, Exchanged, Instance, Variable, follow};
use crate::{Error, Status};

/// The variables of value references.
///
/// # Safety
/// As of [`read`].
unsafe fn variables<M: Exchanged>(
    of: &Instance<M>,
    (at, count): (*const u32, usize),
) -> Result<Vec<Variable>, Error> {
    // SAFETY: the caller's part.
    let references = unsafe { read(at, count)? };
    let found = references.iter().map(|reference| Variable::of(of.declared(), *reference));
    found.map(|found| found.ok_or(Status::NoSuch.into())).collect()
}

/// `fmi3GetFloat64`
///
/// # Safety
/// As of [`with`]; the arrays are null or the caller's.
pub unsafe fn get<M: Exchanged>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*mut f64, usize),
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let wanted = unsafe { variables(instance, references)? };
        let found: Result<Vec<f64>, _> = wanted.into_iter().map(|variable| instance.get(variable)).collect();
        // SAFETY: the caller's part.
        unsafe { fill(values, &found?) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::Get, work) }
}

/// `fmi3SetFloat64`; where one of several is refused, none is set.
///
/// # Safety
/// As of [`get`].
pub unsafe fn set<M: Exchanged>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*const f64, usize),
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let (wanted, values) = unsafe { (variables(instance, references)?, read(values.0, values.1)?) };
        if wanted.len() != values.len() {
            return Err(Status::NoSuch.into());
        }
        let mut changed = instance.clone();
        for (value, variable) in values.iter().zip(wanted) {
            changed.set(variable, *value)?;
        }
        *instance = changed;
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::Set, work) }
}

/// `fmi3GetDirectionalDerivative`
///
/// # Safety
/// As of [`get`].
pub unsafe fn tangents<M: Exchanged>(
    handle: *mut Handle<M>,
    (unknowns, knowns): ((*const u32, usize), (*const u32, usize)),
    seeds: (*const f64, usize),
    tangents: (*mut f64, usize),
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let (unknowns, knowns) = unsafe { (variables(instance, unknowns)?, variables(instance, knowns)?) };
        // SAFETY: the caller's part.
        let seeds = unsafe { read(seeds.0, seeds.1)? };
        if seeds.len() != knowns.len() {
            return Err(Status::NoSuch.into());
        }
        let knowns: Vec<_> = knowns.into_iter().zip(seeds.iter().copied()).collect();
        let found = instance.tangents(&knowns, &unknowns)?;
        // SAFETY: the caller's part.
        unsafe { fill(tangents, &found) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::GetDirectionalDerivative, work) }
}

/// A vector that a simulator asks for.
#[derive(Clone, Copy, Debug)]
pub enum Given {
    /// `fmi3GetContinuousStates`
    States,
    /// `fmi3GetContinuousStateDerivatives`
    Rates,
    /// `fmi3GetEventIndicators`
    Indicators,
    /// `fmi3GetNominalsOfContinuousStates`
    Nominals,
}

impl Given {
    fn call(self) -> Call {
        match self {
            Self::States => Call::GetContinuousStates,
            Self::Rates => Call::GetContinuousStateDerivatives,
            Self::Indicators => Call::GetEventIndicators,
            Self::Nominals => Call::GetNominalsOfContinuousStates,
        }
    }

    fn of<M: Exchanged>(self, instance: &mut Instance<M>) -> Result<Vec<f64>, Error> {
        instance.renew()?;
        Ok(match self {
            Self::States => numbers(instance.state()?.x()),
            Self::Rates => numbers(&instance.rates()?),
            Self::Indicators => instance.indicators()?,
            Self::Nominals => numbers(&instance.state()?.mechanism().typical()),
        })
    }
}

fn numbers<X: Vector<f64>>(vector: &X) -> Vec<f64> {
    (0..X::LEN).map(|index| vector.at(index)).collect()
}

/// A vector of the mechanism into room of the caller.
///
/// # Safety
/// As of [`get`].
pub unsafe fn give<M: Exchanged>(handle: *mut Handle<M>, what: Given, room: (*mut f64, usize)) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        let numbers = what.of(instance)?;
        // SAFETY: the caller's part.
        unsafe { fill(room, &numbers) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, what.call(), work) }
}

/// `fmi3GetNumberOfContinuousStates`, `fmi3GetNumberOfEventIndicators`
///
/// # Safety
/// As of [`with`]; `count` is null or the caller's.
pub unsafe fn count<M: Exchanged>(handle: *mut Handle<M>, call: Call, count: *mut usize) -> Outcome {
    let number = match call {
        Call::GetNumberOfEventIndicators => follow::indicators::<M>(),
        _ => <M as Rate>::X::LEN,
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, call, |_| put(count, number)) }
}

/// `fmi3SetContinuousStates`
///
/// # Safety
/// As of [`get`].
pub unsafe fn set_states<M: Exchanged>(handle: *mut Handle<M>, (at, count): (*const f64, usize)) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let states = unsafe { read(at, count)? };
        if states.len() != <M as Rate>::X::LEN {
            return Err(Status::NoSuch.into());
        }
        let x = <M as Rate>::X::from_fn(|index| states.get(index).copied().unwrap_or_default());
        instance.place(None, Some(x))
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::SetContinuousStates, work) }
}

/// `fmi3GetInt64`, `fmi2GetInteger`: the method of co-simulation is the one whole number.
///
/// # Safety
/// As of [`get`].
pub unsafe fn get_integers<M: Exchanged, T: TryFrom<i64> + Copy>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*mut T, usize),
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let wanted = unsafe { variables(instance, references)? };
        let number = T::try_from(instance.method().number()).map_err(|_| Status::NoSuch)?;
        let found: Option<Vec<T>> =
            wanted.into_iter().map(|variable| (variable == Variable::Method).then_some(number)).collect();
        // SAFETY: the caller's part.
        unsafe { fill(values, &found.ok_or(Status::NoSuch)?) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::Get, work) }
}

/// `fmi3SetInt64`, `fmi2SetInteger`; where one of several is refused, none is set.
///
/// # Safety
/// As of [`get`].
pub unsafe fn set_integers<M: Exchanged, T: Into<i64> + Copy>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*const T, usize),
) -> Outcome {
    let mut wanted = None;
    let look = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let (named, values) = unsafe { (variables(instance, references)?, read(values.0, values.1)?) };
        if named.len() != values.len() || named.iter().any(|variable| *variable != Variable::Method) {
            return Err(Status::NoSuch.into());
        }
        wanted = values.last().map(|value| (*value).into());
        Ok(())
    };
    // SAFETY: the caller's part.
    let outcome = unsafe { with(handle, Call::Set, look) };
    match wanted {
        // SAFETY: the caller's part.
        Some(number) if outcome == 0 => unsafe {
            opened(handle, None, |handle| handle.instance.set_method(number))
        },
        _ => outcome,
    }
}
