//! Exact derivatives of the rate, for implicit methods and for linearisation.

use crate::dual::Dual;
use crate::linalg::{Dense, Derivatives};
use crate::scalar::{Real, Scalar};
use crate::system::{Health, System};
use crate::vector::Vector;

/// Directions in which one evaluation on dual numbers differentiates.
const DIRECTIONS: usize = 4;

/// The health of a matrix of derivatives: that of the rate, which is not a number if an entry is not finite.
pub fn finite<S: Real, const N: usize>(health: Health<S>, by_x: &[[S; N]; N]) -> Health<S> {
    // Zero times what is not finite is not a number.
    let probe = by_x.iter().flatten().fold(S::ZERO, |probe, entry| entry.mul_add(S::ZERO, probe));
    Health(health.0 + probe)
}

/// A system that can be differentiated: generated code says how its numbers become [`Dual`] numbers, the rest is done
/// by running it on them.
pub trait Linear: System<S: Real, X: Dense<<Self as System>::S>> {
    /// The same system of dual numbers.
    type Lifted<const K: usize>: Linear<S = Dual<Self::S, K>>;
    /// The form in which implicit methods keep the derivatives of the rate: a matrix, where states are few, or the
    /// coefficients of an augmented system.
    type Derivatives: Derivatives<Self::S, Self::X>;

    /// The system with what is held over a step, all numbers constant.
    fn lift<const K: usize>(&self, held: &Self::U) -> (Self::Lifted<K>, <Self::Lifted<K> as System>::U);

    /// Gives `row` the residual of every equation that a state has to keep: phi and phi_q v - nu.
    fn constraints(&self, t: Self::S, x: &Self::X, row: &mut impl FnMut(Self::S)) {
        let _ = (t, x, row);
    }

    /// The derivative of the rate along (`dt`, `dx`), exact but for rounding; with the health of the rate.
    fn jvp(
        &self,
        t: Self::S,
        u: &Self::U,
        x: &Self::X,
        (dt, dx): (Self::S, &Self::X),
        out: &mut Self::X,
    ) -> Health<Self::S> {
        let (lifted, held) = self.lift::<1>(u);
        let along = |value, tangent| Dual { value, tangents: [tangent] };
        let x = Vector::from_fn(|i| along(x.at(i), dx.at(i)));
        let mut rate = x;
        let health = lifted.rate(along(t, dt), &held, &x, &mut rate);
        *out = Vector::from_fn(|i| {
            let [tangent] = rate.at(i).tangents;
            tangent
        });
        Health(health.0.value)
    }

    /// The derivatives of the rate by the state as implicit methods take them, and by the time where asked for.
    ///
    /// The health is that of the rate; it is not a number if a derivative is not finite.
    fn differentiate(
        &self,
        t: Self::S,
        u: &Self::U,
        x: &Self::X,
        by_x: &mut Self::Derivatives,
        by_t: Option<&mut Self::X>,
    ) -> Health<Self::S> {
        match by_x.full() {
            Some(matrix) => self.jacobian(t, u, x, matrix, by_t),
            None => Health(Self::S::lit(f64::NAN)),
        }
    }

    /// The derivatives of the rate by the state, column by column, and by the time where asked for.
    ///
    /// The health is that of the rate; it is not a number if a derivative is not finite.
    fn jacobian(
        &self,
        t: Self::S,
        u: &Self::U,
        x: &Self::X,
        by_x: &mut <Self::X as Dense<Self::S>>::Matrix,
        by_t: Option<&mut Self::X>,
    ) -> Health<Self::S> {
        let (lifted, held) = self.lift::<DIRECTIONS>(u);
        let (size, mut time_column) = (Self::X::LEN, *x);
        let columns = size + usize::from(by_t.is_some());
        let (mut worst, mut probe) = (Health::perfect(), Self::S::ZERO);
        for first in (0..columns).step_by(DIRECTIONS) {
            // A column before the first wraps to a direction that does not exist.
            let variable = |value, column: usize| Dual::variable(value, column.wrapping_sub(first));
            let point = Vector::from_fn(|i| variable(x.at(i), i));
            let mut rate = point;
            let health = lifted.rate(variable(t, size), &held, &point, &mut rate);
            worst = worst.worst(Health(health.0.value));
            for i in 0..size {
                for (k, tangent) in rate.at(i).tangents.into_iter().enumerate() {
                    probe = tangent.mul_add(Self::S::ZERO, probe);
                    match first + k {
                        column if column < size => Self::X::set_entry(by_x, i, column, tangent),
                        column if column == size => time_column.set(i, tangent),
                        _ => {}
                    }
                }
            }
        }
        if let Some(by_t) = by_t {
            *by_t = time_column;
        }
        // Zero times what is not finite is not a number.
        Health(worst.0 + probe)
    }
}
