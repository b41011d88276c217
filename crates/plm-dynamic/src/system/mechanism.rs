//! Starts, and what parameters may be.

use plm_compiler::lowered::Form;
use plm_runtime::charts::{self, OfLoops};
use plm_runtime::contact;
use plm_runtime::held::Held as HeldOf;
use plm_runtime::singular::NearSingular;
use plm_runtime::switched;
use plm_runtime::{
    BodyStart, Cause, Drift, Events, Fault, Mechanism, Moment, Names, Real, Scalar, Start, absolute, events,
    limits, start,
};

use super::State;
use crate::handle::{Dynamic, Held, Starts};
use crate::memory::Memory;
use crate::model::Model;

impl<S: Scalar, const N: usize> Starts<S, N> {
    /// The start of a body by its number.
    pub(crate) fn body(&self, number: usize) -> BodyStart<S> {
        let none = [Start::free(S::ZERO); 6];
        let [x, y, angle, vx, vy, omega] =
            self.values.as_chunks::<6>().0.get(number).copied().unwrap_or(none);
        BodyStart { x, y, angle, vx, vy, omega }
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
    /// The mechanism as declared; parameters without a default have the values of `given`, by number.
    pub(crate) fn declared(model: &'static Model, given: &[Option<S>]) -> Self {
        let free = Start::free(S::ZERO);
        let starts = Starts { model, values: [free; N] };
        let mut own = Dynamic { model, parameters: [S::ZERO; P], starts };
        for (k, default) in model.start.defaults.iter().enumerate() {
            let declared =
                default.as_ref().and_then(|default| own.values(S::ZERO, default, 1).first().copied());
            let value = declared.or_else(|| given.get(k).copied().flatten());
            if let (Some(place), Some(value)) = (own.parameters.get_mut(k), value) {
                *place = value;
            }
        }
        own.starts = own.declared_starts();
        own
    }

    /// The start values as declared, with the parameters as they are.
    pub(crate) fn declared_starts(&self) -> Starts<S, N> {
        let of = &self.model.lowered.starts;
        let values = self.values(S::ZERO, &self.model.start.values, of.names.len());
        let mut starts = Starts { model: self.model, values: [Start::free(S::ZERO); N] };
        for (k, (place, value)) in starts.values.iter_mut().zip(values).enumerate() {
            let locked = of.locked.get(k) == Some(&true);
            *place = match of.follows.get(k) {
                Some(true) => Start::declared(value, locked),
                _ if locked => Start::locked(value),
                _ => Start::free(value),
            };
        }
        starts
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
    /// Discrete state with inputs, before anything is known of a state.
    pub(crate) fn holding(&self, input: [S; H]) -> Held<S, NQ, L, H, R> {
        HeldOf {
            input,
            switches: [S::lit(1.0); H],
            turns: [0; NQ],
            of_loops: OfLoops::InChart { chart: 0, continuation: Memory::new(self.model.counts) },
            contact: contact::Held::open(),
        }
    }

    /// By count, places of its angles in the pose of all bodies.
    pub(crate) fn turning(&self) -> [&'static [usize]; NQ] {
        core::array::from_fn(|k| self.model.turns_in_pose.get(k).copied().unwrap_or_default())
    }

    /// The inputs as declared.
    pub(crate) fn declared_input(&self) -> [S; H] {
        let values = self.values(S::ZERO, &self.model.start.inputs, self.model.lowered.inputs.len());
        let mut inputs = [S::ZERO; H];
        for (input, value) in inputs.iter_mut().zip(values) {
            *input = value;
        }
        inputs
    }

    /// The mechanism with start values that follow its parameters.
    fn following(mut self) -> Self {
        let mut given = [None; P];
        for (k, default) in self.model.start.defaults.iter().enumerate() {
            if let (None, Some(place)) = (default, given.get_mut(k)) {
                *place = self.parameters.get(k).copied();
            }
        }
        let (before, after) = (Self::declared(self.model, &given).starts, self.declared_starts());
        start::follow(&mut self.starts, before, after);
        self
    }

    /// Says that the start closes only far from where it is declared, if it does.
    pub(crate) fn told_far(&self, t: S) -> Option<String> {
        let assembly = absolute::assemble::<S, Self, NQ, NC>(&self.following(), t).ok()?;
        assembly.far.map(|far| far.to_string())
    }

    /// The assembled state with inputs.
    pub(crate) fn start_holding(&self, t: S, input: [S; H]) -> Result<(Held<S, NQ, L, H, R>, [S; N]), Fault> {
        let own = self.following();
        own.check(t)?;
        let assembly = absolute::assemble::<S, Self, NQ, NC>(&own, t)?;
        if let Some(bodies) = &self.model.start.carried {
            absolute::check_carried::<S, Self, NQ, NC>(&own, t, &assembly.q, bodies)?;
        }
        let mut x = [S::ZERO; N];
        let of_bodies = 6 * self.model.lowered.bodies.len();
        for (x, start) in x.iter_mut().skip(2 * NQ).zip(own.starts.values.iter().skip(of_bodies)) {
            *x = start.value;
        }
        let mut held = own.holding(input);
        let is_redundant = self.model.lowered.loops.as_ref().is_some_and(|loops| loops.is_redundant);
        if own.is_charted() && !is_redundant && own.repeats(&assembly.redundant) {
            let joints = Names::marked(self.model.layout.parts, &assembly.redundant);
            return Err(Fault::new(t.to_f64(), Cause::Repeats { joints }));
        }
        own.enter(t, &mut held, (&assembly.q, &assembly.v), &mut x);
        own.begin_sides(t, &mut held, &mut x)?;
        if let Some(contacts) = &self.model.contacts {
            own.close(t, input, &mut held, &mut x)?;
            contact::begin::<Self, R>(&own, t, &mut held, &mut x)?;
            if self.sets_states() || contacts.decide_sides() {
                own.take_sides(t, &mut held, &x);
            }
            if self.sets_states() && contacts.decide_sides() {
                own.take_sides(t, &mut held, &x);
            }
        }
        Ok((held, x))
    }

    /// Performs the assignments at the start of a run, and takes the sides of conditions that apply there. Events that follow conditions do
    /// not happen.
    fn begin_sides(&self, t: S, held: &mut Held<S, NQ, L, H, R>, x: &mut [S; N]) -> Result<(), Fault> {
        let switches = &self.model.lowered.switches;
        // Contacts have their modes when all conditions have their sides, which gaps may read, and all constraints that hold are closed.
        self.set_at_start(t, held, x)?;
        if self.sets_states() || self.has_contacts() {
            switched::take_sides_at_time(self, t, held);
            self.take_sides(t, held, x);
            return Ok(());
        }
        if !switches.all.is_empty() {
            self.switch_at_time(t, held, x)?;
        }
        if switches.guards > 0 {
            events::switch_where_due(self, t, held, x)?;
        }
        Ok(())
    }

    /// Takes the sides of all conditions of the state; nothing becomes true by that.
    fn take_sides(&self, t: S, held: &mut Held<S, NQ, L, H, R>, x: &[S; N]) {
        let guards = self.model.lowered.switches.guards;
        events::take_sides(self, t, held, x, (guards, |u: &mut Held<S, NQ, L, H, R>| &mut u.switches[..]));
    }

    /// Assembles anew with the constraints that hold where a run begins. Which hold may depend on the pose: it is asked again after
    /// that, a few times.
    fn close(
        &self,
        t: S,
        input: [S; H],
        held: &mut Held<S, NQ, L, H, R>,
        x: &mut [S; N],
    ) -> Result<(), Fault> {
        let contacts = self.model.contacts.as_ref();
        let conditional = contacts.and_then(|contacts| contacts.conditional.as_ref());
        let Some(conditional) = conditional else { return Ok(()) };
        let mut closed = [false; R];
        for _ in 0..4 {
            let holds = self.conditions_that_hold(conditional, held);
            if holds == closed {
                break;
            }
            let (q, v) = self.assembled_with(t, (conditional, holds))?;
            *held = self.holding(input);
            self.enter(t, held, (&q, &v), x);
            self.begin_sides(t, held, x)?;
            closed = holds;
        }
        Ok(())
    }

    /// Do some of its own rows repeat others?
    fn repeats(&self, redundant: &[bool; NC]) -> bool {
        redundant.iter().take(self.model.lowered.rows.len()).any(|redundant| *redundant)
    }

    /// From a pose and velocity to the state.
    pub(super) fn enter(
        &self,
        t: S,
        held: &mut Held<S, NQ, L, H, R>,
        (q, v): (&[S; NQ], &[S; NQ]),
        x: &mut [S; N],
    ) {
        match self.model.lowered.form {
            Form::Loops => charts::enter(self, t, held, (q, v), x),
            Form::Tree => charts::Charted::to_chart(self, 0, t, q, v, x),
            Form::Absolute => absolute::join(q, v, x),
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
> Mechanism for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    type State = State<S, NQ, NC, N, L, H, R, P>;
    type Rescue = NearSingular<Self, NQ, NC, N>;

    fn start_state(&self, t: S) -> Result<(Held<S, NQ, L, H, R>, [S; N]), Fault> {
        self.start_holding(t, self.declared_input())
    }

    fn check(&self, t: S) -> Result<(), Fault> {
        let named = self.model.parameters.iter().zip(self.parameters);
        limits::check_numbers(t, named.map(|((name, unit), value)| (*name, *unit, value)))?;
        let limits = &self.model.start.limits;
        limits::check(t, &self.values(t, &self.model.start.limited, limits.len()), limits)
    }

    fn fingerprint(&self) -> u64 {
        let shaping = &self.model.lowered.starts.shaping;
        if shaping.is_empty() {
            return 0;
        }
        let of_shape = |k: usize| if shaping.contains(&k) { self.parameters[k] } else { S::ZERO };
        limits::fingerprint::<S, P>(core::array::from_fn(of_shape))
    }

    fn renew(&self, t: S, held: &mut Held<S, NQ, L, H, R>, x: &mut [S; N]) -> Result<(), Fault> {
        if self.model.lowered.starts.shaping.is_empty() {
            return Ok(());
        }
        let (mut q, mut v) = State::new(*self, *held, t, *x).pose();
        absolute::renew::<S, Self, NQ, NC>(self, t, &mut q, &mut v)?;
        self.enter(t, held, (&q, &v), x);
        Ok(())
    }

    fn opening(&self, t: S, held: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Drift<S> {
        let (q, v) = State::new(*self, *held, t, *x).pose();
        absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
    }
}
