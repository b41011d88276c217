//! Near singular poses: the equations in absolute coordinates, in numbers of twice the precision.

use plm_runtime::charts::{self, Charted, OfLoops};
use plm_runtime::singular::ExtendedPrecision;
use plm_runtime::{
    DoubleDouble, Dual, Health, Linear, Rate, Real, Scalar, Vector, absolute, contact, linear,
};

use crate::handle::{Beside, Dynamic, Frame, Held};

type Wide<S> = DoubleDouble<S>;

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
> ExtendedPrecision<NQ, NC, N> for Dynamic<S, NQ, NC, N, L, H, R>
{
    type Extended = Dynamic<Wide<S>, NQ, NC, N, L, H, R>;
    type Inputs = Held<Wide<S>, NQ, L, H, R>;

    fn extended(&self) -> Self::Extended {
        self.map(&|number| Wide::written(number))
    }

    fn extended_with_inputs(&self, held: &Self::U) -> (Self::Extended, Self::Inputs) {
        (self.extended(), Self::map_held(held, &|number| Wide::of(number)))
    }

    fn accelerate(
        extended: &Self::Extended,
        t: Wide<S>,
        u: &Self::Inputs,
        x: &[Wide<S>; N],
        dx: &mut [Wide<S>; N],
    ) {
        let mut lambda = [Wide::<S>::ZERO; NC];
        *dx = [Wide::<S>::ZERO; N];
        extended.run(&extended.model.absolute.dynamics, &Frame::of_state(t, u, x), [dx, &mut lambda]);
    }

    fn is_charted(&self) -> bool {
        Dynamic::is_charted(self)
    }

    fn may_be_singular(&self) -> bool {
        self.model.lowered.may_be_singular
    }

    fn crossed(&self, held: &Self::U, before: &[S; N], x: &[S; N]) -> S {
        if Dynamic::is_charted(self) { charts::crossed(self, held, before, x) } else { S::ZERO }
    }

    fn is_near(held: &Self::U) -> bool {
        charts::is_free::<Self>(held)
    }

    fn full(&self, t: S, held: &Self::U, x: &[S; N]) -> [S; N] {
        if self.is_absolute() { *x } else { full(self, t, held, x) }
    }

    fn hold(&self, held: &mut Self::U, x: &mut [S; N], full: &[S; N]) {
        if self.is_absolute() { *x = *full } else { charts::hold::<Self, N>(held, x, full) }
    }

    fn flat_part(&self, t: S, full: &[S; N]) -> &'static str {
        let (q, v): ([S; NQ], [S; NQ]) = absolute::split(full);
        if self.is_absolute() {
            absolute::flat_part::<_, _, NQ, NC>(self, t, &q)
        } else {
            charts::flat_part(self, t, &q, &v)
        }
    }
}

/// The state in absolute coordinates, of one in joint coordinates.
pub(super) fn full<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
>(
    mechanism: &Dynamic<S, NQ, NC, N, L, H, R>,
    t: S,
    held: &Held<S, NQ, L, H, R>,
    x: &[S; N],
) -> [S; N] {
    let (q, v, _) = Charted::pose(mechanism, t, held, x);
    let mut full = *x;
    absolute::join(&q, &v, &mut full);
    full
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
> Linear for Dynamic<S, NQ, NC, N, L, H, R>
{
    type Lifted<const K: usize> = Dynamic<Dual<S, K>, NQ, NC, N, L, H, R>;
    type In<T: Real> = Dynamic<T, NQ, NC, N, L, H, R>;
    type Derivatives = [[S; N]; N];

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
                // Behind the last row there is room.
                if index % NC < rows {
                    row(residual);
                }
                index += 1;
            });
        }
    }
}
