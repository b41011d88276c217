//! Derivatives of the rate.

use plm_runtime::charts::OfLoops;
use plm_runtime::linalg::Derivatives;
use plm_runtime::{Dual, Health, Linear, Rate, Real, Vector, absolute, contact, linear};

use crate::augmented::Augmented;
use crate::derivatives::AtRunTime;
use crate::handle::{Beside, Dynamic, Frame, Held};

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Linear for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    type Lifted<const K: usize> = Dynamic<Dual<S, K>, NQ, NC, N, L, H, R, P>;
    type In<T: Real> = Dynamic<T, NQ, NC, N, L, H, R, P>;
    type Derivatives = AtRunTime<S, N>;

    fn lift<const K: usize>(&self, held: &Self::U) -> (Self::Lifted<K>, Held<Dual<S, K>, NQ, L, H, R>) {
        self.in_numbers(held, Dual::constant)
    }

    fn in_numbers<T: Real>(
        &self,
        held: &Self::U,
        number: impl Fn(S) -> T,
    ) -> (Self::In<T>, Held<T, NQ, L, H, R>) {
        (self.map(&number), Self::map_held(held, &number))
    }

    fn rate_in_numbers<T: Real>(
        &self,
        held: &Self::U,
        number: impl Fn(S) -> T,
    ) -> (Self::In<T>, Held<T, NQ, L, H, R>) {
        let (own, held) = self.without_derivatives(held);
        own.in_numbers(&held, number)
    }

    fn differentiate(
        &self,
        t: S,
        u: &Self::U,
        x: &[S; N],
        by_x: &mut AtRunTime<S, N>,
        by_t: Option<&mut [S; N]>,
    ) -> Health<S> {
        let Some(Augmented { coefficients, pattern, .. }) = self.augmented() else {
            let coordinates = self.coordinates();
            by_x.fill(coordinates, self.states() - 2 * coordinates);
            let Some(matrix) = by_x.full() else { return Health(S::lit(f64::NAN)) };
            return self.jacobian(t, u, x, matrix, by_t);
        };
        let (mut dx, mut lambda) = ([S::ZERO; N], [S::ZERO; NC]);
        let frame = Frame::of_state(t, u, x);
        let health = if self.is_absolute() {
            Health(self.run(&self.model.absolute.dynamics, &frame, [&mut dx, &mut lambda]))
        } else {
            self.rate(t, u, x, &mut dx)
        };
        let beside = Beside { rates: &dx, lambda: &lambda, ..Beside::NONE };
        self.run(coefficients, &Frame { beside: Some(&beside), ..frame }, [by_x.coefficients(pattern)]);
        match by_t {
            Some(by_t) => self.jvp(t, u, x, (S::lit(1.0), &[S::ZERO; N]), by_t),
            None => health,
        }
    }

    fn jacobian(
        &self,
        t: S,
        u: &Self::U,
        x: &[S; N],
        by_x: &mut [[S; N]; N],
        by_t: Option<&mut [S; N]>,
    ) -> Health<S> {
        let chart = match u.of_loops {
            OfLoops::InChart { chart, .. } => self.model.in_charts.get(chart),
            OfLoops::Free { .. } => None,
        };
        let Some(entries) = chart.and_then(|chart| chart.jacobian.as_ref()) else {
            return linear::by_columns(self, (t, u, x), by_x, by_t);
        };
        let mut dx = [S::ZERO; N];
        let health = self.rate(t, u, x, &mut dx);
        *by_x = [[S::ZERO; N]; N];
        let beside = Beside { rates: &dx, ..Beside::NONE };
        self.entries(entries, &Frame { beside: Some(&beside), ..Frame::of_state(t, u, x) }, by_x);
        if let Some(by_t) = by_t {
            let _ = self.jvp(t, u, x, (S::lit(1.0), &[S::ZERO; N]), by_t);
        }
        linear::finite(health, by_x)
    }

    fn held_rows(&self, t: S, u: &Self::U, x: &[S; N], row: &mut impl FnMut(S)) {
        if self.has_contacts() {
            contact::held_rows::<Self, R>(self, t, u, x, row);
        }
        for state in &self.model.lowered.discrete {
            row(x.at(2 * NQ + state));
        }
    }

    fn constraints(&self, t: S, x: &[S; N], row: &mut impl FnMut(S)) {
        if self.is_absolute() {
            let (rows, mut index) = (self.model.lowered.rows.len(), 0);
            absolute::residuals::<S, Self, NQ, NC, N>(self, t, x, &mut |residual| {
                // After the last row there is room.
                if index % NC < rows {
                    row(residual);
                }
                index += 1;
            });
        }
    }
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// The equations that implicit methods solve in place of df/dx, where the room of a matrix holds them.
    fn augmented(&self) -> Option<&'static Augmented> {
        let augmented = self.model.augmented.as_ref()?;
        AtRunTime::<S, N>::fits(augmented.pattern, augmented.count).then_some(augmented)
    }
}
