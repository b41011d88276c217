//! A mechanism at one moment.

use plm_runtime::step::{Remainder, Stepped};
use plm_runtime::{BodyState, Common, Health, InPlace, Moment, Real, absolute, charts, turns};

use crate::capacity::{PARAMETERS, ROWS, SWITCHES};
use crate::handle::{Beside, Dynamic, Frame, Held};
use plm_compiler::lowered::Form;

/// Pose and velocity of every body.
type Pose<S, const NQ: usize> = ([S; NQ], [S; NQ]);
/// Accelerations and multipliers.
type Solution<S, const NQ: usize, const NC: usize> = ([S; NQ], [S; NC]);
/// A scalar, or the components of a vector.
type Vector<S> = Option<[S; 2]>;

/// A mechanism with its numbers at one moment.
#[derive(Clone, Copy, Debug)]
pub struct State<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize = NQ,
    const H: usize = SWITCHES,
    const R: usize = ROWS,
    const P: usize = PARAMETERS,
> {
    mechanism: Dynamic<S, NQ, NC, N, L, H, R, P>,
    held: Held<S, NQ, L, H, R>,
    time: S,
    x: [S; N],
    left_out: Remainder<S>,
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
> Moment for State<S, NQ, NC, N, L, H, R, P>
{
    type M = Dynamic<S, NQ, NC, N, L, H, R, P>;

    fn new(mechanism: Self::M, held: Held<S, NQ, L, H, R>, time: S, x: [S; N]) -> Self {
        State { mechanism, held, time, x, left_out: Remainder::none() }
    }

    fn mechanism(&self) -> &Self::M {
        &self.mechanism
    }

    fn held(&self) -> Held<S, NQ, L, H, R> {
        self.held
    }

    fn time(&self) -> S {
        self.time
    }

    fn x(&self) -> &[S; N] {
        &self.x
    }

    fn set(&mut self, time: S, held: &Held<S, NQ, L, H, R>, x: &[S; N]) {
        (self.time, self.held, self.x, self.left_out) = (time, *held, *x, Remainder::none());
    }

    fn in_place(&mut self) -> InPlace<'_, Self::M> {
        self.left_out = Remainder::none();
        self.stepped().0
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
> Stepped for State<S, NQ, NC, N, L, H, R, P>
{
    fn stepped(&mut self) -> (InPlace<'_, Self::M>, &mut Remainder<S>) {
        let Self { mechanism, held, time, x, left_out } = self;
        (InPlace { system: mechanism, held, time, x }, left_out)
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
> State<S, NQ, NC, N, L, H, R, P>
{
    /// Pose and velocity of every body, without whole revolutions.
    pub(crate) fn pose(&self) -> ([S; NQ], [S; NQ]) {
        match self.mechanism.model.lowered.form {
            Form::Absolute => absolute::split(&self.x),
            Form::Tree | Form::Loops => charts::pose(&self.mechanism, self.time, &self.held, &self.x),
        }
    }

    /// The state in absolute coordinates, without whole revolutions.
    pub(crate) fn absolute(&self) -> [S; N] {
        match self.mechanism.model.lowered.form {
            Form::Absolute => self.x,
            Form::Tree | Form::Loops => charts::full(&self.mechanism, self.time, &self.held, &self.x),
        }
    }

    /// The state in absolute coordinates, of pose and velocity.
    fn absolute_at(&self, (q, v): &Pose<S, NQ>) -> [S; N] {
        let mut full = self.x;
        for (k, (q, v)) in q.iter().zip(v).enumerate() {
            (full[k], full[NQ + k]) = (*q, *v);
        }
        full
    }

    /// Pose and velocity of every body, including whole revolutions.
    pub(crate) fn unwrapped_pose(&self) -> ([S; NQ], [S; NQ]) {
        let (mut q, v) = self.pose();
        turns::add(&self.held.turns, &mut q, &self.mechanism.turning());
        (q, v)
    }

    /// Pose and velocity of the centre of gravity of a body by its number; none after the last one.
    pub fn body(&self, number: usize) -> Option<BodyState<S>> {
        let (q, v) = self.unwrapped_pose();
        (number < self.mechanism.model.lowered.bodies.len()).then(|| BodyState::among(&q, &v, number))?
    }

    /// A number of the outputs, declared and observed, by its number, SI.
    pub fn output(&self, number: usize) -> Option<S> {
        self.output_of(number, &Common::new())
    }

    /// Gives `each` the declared outputs in their units.
    pub(crate) fn declared(&self, each: &mut impl FnMut(S)) {
        let common = &Common::new();
        let outputs = self.mechanism.model.lowered.outputs.iter().enumerate();
        for (k, output) in outputs.filter(|(_, output)| output.declared) {
            let value = self.output_of(k, common).unwrap_or(S::lit(f64::NAN));
            each(value / S::lit(output.factor));
        }
    }

    /// An output by its number, with what the outputs before it have worked out.
    pub(crate) fn output_of(
        &self,
        number: usize,
        common: &Common<Pose<S, NQ>, Held<S, NQ, L, H, R>, Solution<S, NQ, NC>, Vector<S>>,
    ) -> Option<S> {
        let output = self.mechanism.model.lowered.outputs.get(number)?;
        let first = number.checked_sub(output.component)?;
        common.vector(first, || self.value_of(output.value, common))?.get(output.component).copied()
    }

    /// A scalar, or the components of a vector.
    fn value_of(
        &self,
        number: usize,
        common: &Common<Pose<S, NQ>, Held<S, NQ, L, H, R>, Solution<S, NQ, NC>, Vector<S>>,
    ) -> Vector<S> {
        let model = self.mechanism.model;
        let (code, of) = (model.values.get(number)?, model.lowered.values.get(number)?);
        let (q, v) = common.pose.get_or_init(|| self.pose());
        let held = common.loaded.get_or_init(|| self.loaded());
        let mut frame = Frame { held: Some(held), x: &self.x, ..Frame::of_pose(self.time, q, v) };
        let beside;
        if of.solves {
            let (a, lambda) = common.solved.get_or_init(|| self.solved(common));
            beside = Beside { a, lambda, ..Beside::NONE };
            frame.beside = Some(&beside);
        }
        let mut value = [S::ZERO; 2];
        let returned = self.mechanism.run(code, &frame, [&mut value]);
        Some(if code.returns() { [returned, S::ZERO] } else { value })
    }

    /// Accelerations and multipliers; multipliers that redundancy leaves undetermined have their minimum norm.
    pub(crate) fn solved(
        &self,
        common: &Common<Pose<S, NQ>, Held<S, NQ, L, H, R>, Solution<S, NQ, NC>, Vector<S>>,
    ) -> Solution<S, NQ, NC> {
        let (mechanism, model) = (&self.mechanism, self.mechanism.model);
        let (mut a, mut lambda) = ([S::ZERO; NQ], [S::ZERO; NC]);
        let held = common.loaded.get_or_init(|| self.loaded());
        let tree = model.in_charts.first().filter(|_| model.lowered.form == Form::Tree);
        if let Some(reactions) = tree.and_then(|chart| chart.reactions.as_ref()) {
            let frame = Frame::of_state(self.time, held, &self.x);
            mechanism.run(reactions, &frame, [&mut a, &mut lambda]);
            return (a, lambda);
        }
        let (x, mut dx) = (self.absolute_at(common.pose.get_or_init(|| self.pose())), [S::ZERO; N]);
        let frame = Frame::of_state(self.time, held, &x);
        let health = mechanism.run(&model.absolute.dynamics, &frame, [&mut dx, &mut lambda]);
        if !Health(health).is_good()
            && let Ok(solution) = mechanism.accelerate(self.time, held, &x)
        {
            return (solution.a, solution.lambda);
        }
        let (_, accelerations): ([S; NQ], [S; NQ]) = absolute::split(&dx);
        a = accelerations;
        (a, lambda)
    }

    /// The discrete state, with the multipliers of contact.
    fn loaded(&self) -> Held<S, NQ, L, H, R> {
        self.mechanism.loaded(self.time, &self.held, &self.x)
    }

    /// A scalar of the state.
    fn value(&self, code: &'static crate::code::Code) -> S {
        let (q, v) = self.pose();
        let held = self.loaded();
        let frame = Frame { held: Some(&held), x: &self.x, ..Frame::of_pose(self.time, &q, &v) };
        self.mechanism.run(code, &frame, [])
    }

    /// Kinetic energy of all bodies, J.
    pub fn kinetic_energy(&self) -> S {
        self.value(&self.mechanism.model.absolute.kinetic_energy)
    }

    /// Potential energy of gravity above the origin, J.
    pub fn gravity_energy(&self) -> S {
        self.value(&self.mechanism.model.absolute.gravity_energy)
    }

    /// Power of all forces and torques but gravity and reactions, W.
    pub fn load_power(&self) -> S {
        self.value(&self.mechanism.model.absolute.load_power)
    }
}
