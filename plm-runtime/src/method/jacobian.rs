//! Derivatives of the rate, exact if the rate is healthy.

use super::Context;
use crate::fault::{Cause, Fault};
use crate::linalg::{Dense, Derivatives};
use crate::linear::Linear;
use crate::scalar::{Real, Scalar};
use crate::system::Rate;
use crate::vector::Vector;

/// A decomposed lambda I - J that belongs to a system, for lambda of the type `T`.
pub(super) type Resolvent<M, T> =
    <<M as Linear>::Derivatives as Derivatives<<M as Rate>::S, <M as Rate>::X>>::Resolvent<T>;

impl<M: Linear> Context<'_, M> {
    /// Differentiates the rate by the state, and by the time if requested, at the state reached.
    pub(super) fn differentiate(
        &mut self,
        by_x: &mut M::Derivatives,
        by_t: Option<&mut M::X>,
    ) -> Result<(), Fault> {
        self.stats.jacobians += 1;
        let mut time_column = self.x;
        let wanted = by_t.is_some().then_some(&mut time_column);
        let health = self.system.differentiate(self.time, &self.held, &self.x, by_x, wanted);
        if !health.is_good() {
            let Some(matrix) = by_x.full() else {
                return Err(self.fault(Cause::Singular { rows: M::X::LEN }));
            };
            self.difference_quotients(matrix, &mut time_column)?;
        }
        if let Some(by_t) = by_t {
            *by_t = time_column;
        }
        Ok(())
    }

    /// One-sided difference quotients of the rate by rank. Methods keep their order with them: they need derivatives
    /// only for stability.
    #[cold]
    fn difference_quotients(
        &mut self,
        by_x: &mut <M::X as Dense<M::S>>::Matrix,
        by_t: &mut M::X,
    ) -> Result<(), Fault> {
        let (t, x, typical) = (self.time, self.x, self.system.typical());
        let root = M::S::EPSILON.sqrt();
        let (mut here, mut there) = (x, x);
        self.rate(t, &x, &mut here)?;
        for j in 0..M::X::LEN {
            let mut moved = x;
            moved.set(j, x.at(j) + root * typical.at(j).max(x.at(j).abs()));
            self.rate(t, &moved, &mut there)?;
            let distance = moved.at(j) - x.at(j);
            for i in 0..M::X::LEN {
                M::X::set_entry(by_x, i, j, (there.at(i) - here.at(i)) / distance);
            }
        }
        let later = t + root * t.abs().max(M::S::lit(1.0));
        self.rate(later, &x, &mut there)?;
        *by_t = there.map2(&here, |there, here| (there - here) / (later - t));
        Ok(())
    }
}
