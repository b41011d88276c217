//! Mechanisms without singular poses.

use super::{Nearness, Rescue};
use crate::fault::Fault;
use crate::mechanism::Mechanism;
use crate::method::{Context, DenseOutput, ErrorControl, FixedLength, Length, Method};
use crate::scalar::Real;
use crate::system::{Drift, Step};

/// For mechanisms that have no singular poses.
#[derive(Clone, Copy, Debug)]
pub struct Never<M>(core::marker::PhantomData<M>);

impl<M: Mechanism> Rescue<M> for Never<M> {
    const POSSIBLE: bool = false;

    fn new() -> Self {
        Self(core::marker::PhantomData)
    }
    #[inline]
    fn holds(_context: &Context<'_, M>) -> bool {
        false
    }
    #[inline]
    fn nearness(_step: &Step<'_, M>, _length: Length) -> Nearness {
        Nearness::Regular
    }
    fn take(_context: &mut Context<'_, M>) -> bool {
        false
    }
    fn passed(&self) -> Option<&'static str> {
        None
    }
    fn followed(&self) -> Option<M::S> {
        None
    }
}

impl<M: Mechanism> Method<M> for Never<M> {
    fn advance(&mut self, _context: &mut Context<'_, M>) -> Result<(), Fault> {
        Ok(())
    }
    fn restart(&mut self) {}
    fn fresh(&self) -> Self {
        *self
    }
    fn drift_limit(&self, _system: &M) -> Drift<M::S> {
        Drift { phi: M::S::INFINITY, phi_dot: M::S::INFINITY }
    }
}

impl<M: Mechanism> DenseOutput<M> for Never<M> {}

impl<M: Mechanism> ErrorControl<M> for Never<M> {}

impl<M: Mechanism> FixedLength<M> for Never<M> {}
