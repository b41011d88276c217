//! Polynomial between the ends of a step.

use crate::method::Path;
use crate::method::path::POWERS;
use crate::scalar::Real;
use crate::system::values;
use crate::vector::Vector;

/// An accepted step: its ends and the rates there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span<S, X> {
    pub(crate) time: S,
    pub(crate) h: S,
    pub(crate) from: X,
    pub(crate) to: X,
    pub(crate) rate_from: X,
    pub(crate) rate_to: X,
}

impl<S: Real, X: Vector<S>> Span<S, X> {
    /// This step with states and rates without derivatives; times that are found within it have those of the step.
    pub(in crate::method) fn values(&self) -> Self {
        Self {
            from: values(&self.from),
            to: values(&self.to),
            rate_from: values(&self.rate_from),
            rate_to: values(&self.rate_to),
            ..*self
        }
    }

    /// State at `time`: through both ends with their rates, and with the terms `bends` in addition (Hairer,
    /// Nørsett, Wanner I, II.6; CONTD5 and CONTD8 of their programs). Without bends it is the cubic by C. Hermite.
    pub(in crate::method) fn at(&self, time: S, bends: &[X]) -> X {
        let theta = (time - self.time) / self.h;
        let rest = S::lit(1.0) - theta;
        X::from_fn(|i| {
            let mut bend = S::lit(0.0);
            for (k, b) in bends.iter().enumerate().rev() {
                bend = b.at(i) + if k % 2 == 0 { theta } else { rest } * bend;
            }
            let change = self.to.at(i) - self.from.at(i);
            let start_slope = self.h * self.rate_from.at(i) - change;
            let end_slope = change - self.h * self.rate_to.at(i) - start_slope;
            self.from.at(i) + theta * (change + rest * (start_slope + theta * (end_slope + rest * bend)))
        })
    }

    /// The polynomial of [`at`](Self::at) as powers of theta.
    pub(in crate::method) fn path(&self, bends: &[X]) -> Path<S, X> {
        Path::new(self.time, self.h, |i| {
            let mut sum = [S::ZERO; POWERS];
            for (k, b) in bends.iter().enumerate().rev() {
                sum = if k % 2 == 0 { by_theta(sum) } else { by_rest(sum) };
                sum[0] = sum[0] + b.at(i);
            }
            let change = self.to.at(i) - self.from.at(i);
            let start_slope = self.h * self.rate_from.at(i) - change;
            let end_slope = change - self.h * self.rate_to.at(i) - start_slope;
            sum = by_rest(sum);
            sum[0] = sum[0] + end_slope;
            sum = by_theta(sum);
            sum[0] = sum[0] + start_slope;
            sum = by_rest(sum);
            sum[0] = sum[0] + change;
            sum = by_theta(sum);
            sum[0] = sum[0] + self.from.at(i);
            sum
        })
    }
}

/// A polynomial, of degree 7 at most, times theta.
fn by_theta<S: Real>(c: [S; POWERS]) -> [S; POWERS] {
    Vector::from_fn(|k| if k == 0 { S::ZERO } else { c[k - 1] })
}

/// A polynomial, of degree 7 at most, times 1 - theta.
fn by_rest<S: Real>(c: [S; POWERS]) -> [S; POWERS] {
    let shifted = by_theta(c);
    Vector::from_fn(|k| c[k] - shifted[k])
}
