//! Rates, constraints and names of the state.

use plm_runtime::absolute;
use plm_runtime::charts::{self, OfLoops};
use plm_runtime::contact::{self, Contacts};
use plm_runtime::system::{Computation, OneStep, Question, WholeStep};
use plm_runtime::{
    Cause, Constraints, Drift, Energy, Fault, Health, LabelTable, Labels, Moment, Rate, Real, Scalar,
    Updated, linear, turns,
};

use super::State;
use crate::code::Code;
use crate::handle::{Beside, Dynamic, Frame, Held};
use crate::whole::whole_step;
use plm_compiler::lowered::Form;

impl<
    S: Scalar,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Rate for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    type S = S;
    type X = [S; N];
    type U = Held<S, NQ, L, H, R>;
    const NQ: usize = NQ;
    const WHOLE: bool = true;

    fn rate(&self, t: S, u: &Self::U, x: &[S; N], dx: &mut [S; N]) -> Health<S> {
        if self.has_contacts() {
            *dx = [S::ZERO; N];
            return self.rate_with_contact(t, u, x, dx);
        }
        self.rate_holding(t, u, x, dx)
    }

    #[inline]
    fn whole_step<F: OneStep>(
        &self,
        (t, h): (S, S),
        u: &Self::U,
        from: &[S; N],
        to: &mut [S; N],
    ) -> Option<WholeStep<S>> {
        let rate = self.rate_code(u)?;
        let code = match rate.known_whole(F::NAME) {
            Some(code) => code,
            None => self.new_whole_step::<F>(rate)?,
        };
        let mut health = [S::ZERO];
        let beside = Beside { step: &[h], ..Beside::NONE };
        let frame = Frame { beside: Some(&beside), ..Frame::of_state(t, u, from) };
        let spread = self.compute(code, &frame, &mut [to, &mut health], &mut |_, _| {})?;
        let [health] = health;
        Some(WholeStep { health: Health(health), spread })
    }

    fn coordinates(&self) -> usize {
        self.model.coordinates
    }

    fn states(&self) -> usize {
        self.model.states()
    }

    fn is_finite(&self, x: &[S; N]) -> bool {
        let coordinates = self.model.coordinates;
        let all =
            |numbers: Option<&[S]>| numbers.is_some_and(|all| all.iter().all(|number| number.is_finite()));
        all(x.get(..coordinates))
            && all(x.get(NQ..NQ + coordinates))
            && all(x.get(2 * NQ..2 * NQ + self.model.lowered.states.len()))
    }

    fn typical(&self) -> [S; N] {
        let sizes = &self.model.typical;
        let mut typical = [S::lit(sizes.first().copied().unwrap_or(1.0)); N];
        for (to, size) in typical.iter_mut().zip(sizes) {
            *to = S::lit(*size);
        }
        typical
    }

    #[inline]
    fn typical_at(&self, place: usize) -> S {
        S::lit(self.model.typical_at(place))
    }
}

impl<
    S: Scalar,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// The rate with the multipliers of contact in the discrete state.
    pub(super) fn rate_holding(
        &self,
        t: S,
        u: &Held<S, NQ, L, H, R>,
        x: &[S; N],
        dx: &mut [S; N],
    ) -> Health<S> {
        let frame = Frame::of_state(t, u, x);
        *dx = [S::ZERO; N];
        let Some(rate) = self.rate_code(u) else { return Health(S::ZERO) };
        match self.model.lowered.form {
            Form::Absolute => {
                let mut lambda = [S::ZERO; NC];
                Health(self.run(rate, &frame, [dx, &mut lambda]))
            }
            Form::Tree => {
                self.run(rate, &frame, [dx]);
                Health::perfect()
            }
            Form::Loops => Health(self.run(rate, &frame, [dx])),
        }
    }

    /// The function of the step of a formula by a rate that is machine code: who steps seldom does not wait for a longer function.
    #[cold]
    fn new_whole_step<F: OneStep>(&self, rate: &'static Code) -> Option<&'static Code> {
        if self.has_contacts() {
            return None;
        }
        self.machine_code(rate)?;
        rate.whole(F::NAME, || whole_step::<F, NQ, N>(self.model, rate))
    }

    /// The function of the rate in the present coordinates; `None` for loops without a chart.
    #[inline]
    fn rate_code(&self, u: &Held<S, NQ, L, H, R>) -> Option<&'static Code> {
        let chart = match self.model.lowered.form {
            Form::Absolute => return Some(&self.model.absolute.dynamics),
            Form::Tree => 0,
            Form::Loops => match u.of_loops {
                OfLoops::InChart { chart, .. } => chart,
                OfLoops::Free { .. } => return None,
            },
        };
        self.model.in_charts.get(chart).map(|chart| &chart.rate)
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
> Constraints for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    #[inline]
    fn compute<C: Computation>(
        &self,
        times: (Self::S, Self::S),
        u: &Self::U,
        from: (&Self::X, &Self::X),
    ) -> (C::Made<Self::X>, Health<Self::S>) {
        linear::compute::<Self, C>(self, times, u, from)
    }

    #[inline]
    fn ask<Q: Question<Self::S>>(&self, u: &Self::U, question: Q) -> Q::Answer {
        linear::ask::<Self, Q>(self, u, question)
    }

    fn rate_by_rank(&self, t: S, u: &Self::U, x: &[S; N], dx: &mut [S; N]) -> Result<(), Fault> {
        match self.model.lowered.form {
            Form::Tree => {
                self.rate(t, u, x, dx);
                Ok(())
            }
            Form::Loops if self.rate(t, u, x, dx).is_good() => Ok(()),
            Form::Loops => Err(charts::not_regular(self, t, u, x)),
            Form::Absolute => {
                let solution = self.accelerate(t, &self.loaded(t, u, x), x)?;
                let (_, v): ([S; NQ], [S; NQ]) = absolute::split(x);
                absolute::join(&v, &solution.a, dx);
                let mut x_dot = [S::ZERO; N];
                self.run(&self.model.absolute.x_dot, &Frame::of_state(t, u, x), [&mut x_dot]);
                for (rate, value) in dx.iter_mut().skip(2 * NQ).zip(x_dot) {
                    *rate = value;
                }
                Ok(())
            }
        }
    }

    fn project(&self, t: S, u: &Self::U, x: &mut [S; N]) -> Result<(), Fault> {
        if self.has_contacts() {
            return contact::project::<Self, R>(self, t, u, x);
        }
        self.project_joints(t, u, x)
    }

    fn drift(&self, t: S, u: &Self::U, x: &[S; N]) -> Drift<S> {
        if self.has_contacts() {
            return contact::drift::<Self, R>(self, t, u, x);
        }
        self.drift_of_joints(t, u, x)
    }

    fn baumgarte_rate(&self) -> Option<f64> {
        let tau = self.model.start.baumgarte.as_ref().filter(|_| self.is_absolute())?;
        self.values(S::ZERO, tau, 1).first().map(|tau| 1.0 / tau.to_f64())
    }

    fn is_regular(&self, u: &Self::U) -> bool {
        !charts::is_free::<Self>(u)
    }

    fn update(&self, t: S, u: &mut Self::U, x: &mut [S; N]) -> Result<Updated, Fault> {
        if self.is_charted() {
            return charts::update(self, t, u, x);
        }
        if self.model.turns_in_state.is_empty() {
            return Ok(Updated::default());
        }
        let places: [&[usize]; NQ] =
            core::array::from_fn(|k| self.model.turns_in_state.get(k).copied().unwrap_or_default());
        let turned = turns::unwind(&mut u.turns, x, &places);
        Ok(Updated { turned, ..Updated::default() })
    }

    const SETTLES: bool = true;

    fn is_settled(&self, t: S, u: &Self::U, x: &[S; N]) -> bool {
        if self.is_charted() {
            return charts::is_calm(self, t, u, x);
        }
        let mut first = self.model.turns_in_state.iter().filter_map(|places| places.first());
        first.all(|place| x.get(*place).is_none_or(|angle| turns::is_near(*angle)))
    }

    fn energy(&self, t: S, u: &Self::U, x: &[S; N]) -> Option<Energy<S>> {
        if !self.model.lowered.has_energy {
            return None;
        }
        let state = State::new(*self, *u, t, *x);
        let (kinetic, gravity) = (state.kinetic_energy(), state.gravity_energy());
        Some(Energy { kinetic, gravity, power: state.load_power() })
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
    /// Are states projected onto constraints?
    pub(super) fn projects(&self) -> bool {
        self.is_absolute() && self.model.start.baumgarte.is_none()
    }

    /// Accelerations and multipliers by a rank-revealing decomposition.
    #[cold]
    pub(super) fn accelerate(
        &self,
        t: S,
        u: &Held<S, NQ, L, H, R>,
        x: &[S; N],
    ) -> Result<absolute::Acceleration<S, NQ, NC>, Fault> {
        let rows = self.model.lowered.rows.len();
        if self.model.lowered.feeds_back {
            return Err(Fault::new(t.to_f64(), Cause::Singular { rows }));
        }
        let (q, _): ([S; NQ], [S; NQ]) = absolute::split(x);
        let (mut force, mut gamma) = ([S::ZERO; NQ], [S::ZERO; NC]);
        self.run(&self.model.absolute.free, &Frame::of_state(t, u, x), [&mut force, &mut gamma]);
        let inverse_mass = absolute::Absolute::<S, NQ, NC>::inverse_mass(self);
        absolute::accelerate(t, &inverse_mass, &force, &gamma, |rows| {
            absolute::phi_q_matrix(self, t, &q, rows);
        })
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
> Labels for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    fn labels(&self) -> &'static LabelTable {
        &self.model.labels
    }

    fn chart_of(&self, u: &Self::U) -> Option<usize> {
        match u.of_loops {
            OfLoops::InChart { chart, .. } if self.is_charted() => Some(chart),
            _ => None,
        }
    }
}
