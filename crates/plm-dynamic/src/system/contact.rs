//! Rows of contact: the rate with their forces, and the contract of the runtime.

use plm_compiler::lowered::{ContactKind, Form, Impacts, OfRows, ReadByConditions, RowTerm};
use plm_runtime::charts::OfLoops;
use plm_runtime::contact::{
    self, Affine, Contacts, ImpactLaw, Kinematics, Law, Limit, Load, Motion, Rows, with_multipliers,
};
use plm_runtime::{Drift, Fault, Health, Real, Scalar, absolute};

use crate::code::Code;
use crate::contact::InChart;
use crate::handle::{Dynamic, Frame, Held};
use crate::places::Place;

/// The rate without contact forces, and what multipliers of one add to it.
struct Free<S, const N: usize, const R: usize> {
    rate: [S; N],
    responses: Box<[[S; N]; R]>,
    health: Health<S>,
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
    /// Has it rows of contact?
    pub(super) fn has_contacts(&self) -> bool {
        self.model.contacts.is_some()
    }

    /// Do conditions of the state read multipliers of contact?
    pub(super) fn conditions_read_multipliers(&self) -> bool {
        let contacts = self.model.contacts.as_ref();
        contacts.is_some_and(|contacts| contacts.lowered.read == ReadByConditions::Multipliers)
    }

    /// Functions of the rows in the present chart.
    pub(super) fn contact_functions(&self, u: &Held<S, NQ, L, H, R>) -> Option<&'static InChart> {
        let chart = match u.of_loops {
            OfLoops::InChart { chart, .. } if self.is_charted() => chart,
            OfLoops::Free { .. } if self.is_charted() => return None,
            _ => 0,
        };
        self.model.contacts.as_ref()?.charts.get(chart)
    }

    /// The rate with the contact forces of the present modes.
    pub(super) fn rate_with_contact(
        &self,
        t: S,
        u: &Held<S, NQ, L, H, R>,
        x: &[S; N],
        dx: &mut [S; N],
    ) -> Health<S> {
        let is_affine = self.model.contacts.as_ref().is_some_and(|contacts| contacts.lowered.is_affine);
        if !is_affine {
            let u = &self.loaded(t, u, x);
            let health = self.rate_holding(t, u, x, dx);
            contact::settle(dx, &u.contact, |lambda| self.contact_response(t, u, x, lambda));
            return health;
        }
        if !u.contact.has_forces() {
            return self.rate_holding(t, u, x, dx);
        }
        if let Some(health) = self.contact_sliding(t, u, x, dx, None) {
            return health;
        }
        let mut rows = Rows::none();
        let free = self.contact_motion(t, u, x, &mut rows);
        *dx = free.rate;
        contact::add_forces(dx, &rows, &u.contact, &free.responses);
        free.health
    }

    /// The discrete state with the multipliers of contact at a state.
    pub(super) fn loaded(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Held<S, NQ, L, H, R> {
        let mut held = *u;
        if !self.has_contacts() || !u.contact.has_forces() {
            return held;
        }
        let mut rows = Rows::none();
        let _ = self.contact_motion(t, u, x, &mut rows);
        held.contact = with_multipliers(&rows, &u.contact);
        held
    }

    fn contact_kinematics(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Kinematics<S, R> {
        let mut rows = Kinematics::none();
        if let Some(functions) = self.contact_functions(u) {
            let frame = Frame::of_state(t, u, x);
            self.evaluate(&functions.kinematics, &frame, &mut [], &mut |place, value| match place {
                Place::Rows(OfRows::Gap(row)) => store(&mut rows.gap, row, value),
                Place::Rows(OfRows::Rate(row)) => store(&mut rows.rate, row, value),
                _ => {}
            });
        }
        self.put_loads(u, &mut rows.load, &mut rows.read);
        rows
    }

    /// The rate without contact forces, and its responses; completes the rows.
    fn contact_motion(
        &self,
        t: S,
        u: &Held<S, NQ, L, H, R>,
        x: &[S; N],
        rows: &mut Rows<S, R>,
    ) -> Free<S, N, R> {
        self.contact_pass(self.contact_functions(u).map(|functions| &functions.motion), (t, u, x), rows)
    }

    fn contact_pass(
        &self,
        code: Option<&'static Code>,
        (t, u, x): (S, &Held<S, NQ, L, H, R>, &[S; N]),
        rows: &mut Rows<S, R>,
    ) -> Free<S, N, R> {
        let (mut rate, mut responses) = ([S::ZERO; N], Box::new([[S::ZERO; N]; R]));
        let is_tree = self.model.lowered.form == Form::Tree;
        let mut health = if is_tree { S::lit(1.0) } else { S::ZERO };
        if let Some(code) = code {
            let frame = Frame::of_state(t, u, x);
            let returned = self.evaluate(code, &frame, &mut [&mut rate], &mut |place, value| match place {
                Place::Response(row, k) => {
                    if let Some(response) = responses.get_mut(row) {
                        store(response, k, value);
                    }
                }
                Place::Rows(place) => put(rows, place, value),
                _ => {}
            });
            health = returned.unwrap_or(health);
        }
        self.put_loads(u, &mut rows.load, &mut rows.read);
        Free { rate, responses, health: Health(health) }
    }

    fn contact_rows(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Rows<S, R> {
        let mut rows = self.contact_kinematics(t, u, x).rows();
        let _ = self.contact_motion(t, u, x, &mut rows);
        rows
    }

    fn contact_response(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N], lambda: &[S; R]) -> [S; N] {
        let free = self.contact_motion(t, u, x, &mut Rows::none());
        contact::sum_of(&free.responses, lambda)
    }

    /// Kinds of the reactions that bound frictions, and the frictions that each bounds; the sign of one along a line is part of the
    /// discrete state.
    fn put_loads(&self, u: &Held<S, NQ, L, H, R>, loads: &mut [Load; R], read: &mut [[bool; R]; R]) {
        let Some(contacts) = &self.model.contacts else { return };
        let negative = &u.contact.modes.negative;
        for (load, reaction) in contacts.lowered.reactions.iter().enumerate() {
            let negative = negative.get(load) == Some(&true);
            store(loads, load, if reaction.in_plane { Load::Plane } else { Load::Line { negative } });
            for row in &reaction.rows {
                if let Some(reads) = read.get_mut(*row) {
                    store(reads, load, true);
                }
            }
        }
    }
}

/// Puts a value into its place, where there is one.
pub(super) fn store<T>(list: &mut [T], index: usize, value: T) {
    if let Some(place) = list.get_mut(index) {
        *place = value;
    }
}

/// Puts a number of rows of contact into its place.
fn put<S, const R: usize>(rows: &mut Rows<S, R>, place: OfRows, value: S) {
    match place {
        OfRows::Gap(row) => store(&mut rows.gap, row, value),
        OfRows::Rate(row) => store(&mut rows.rate, row, value),
        OfRows::Free(row) => store(&mut rows.free, row, value),
        OfRows::Bias(row) => store(&mut rows.bias, row, value),
        OfRows::Delassus(row, column) => {
            if let Some(entries) = rows.delassus.get_mut(row) {
                store(entries, column, value);
            }
        }
        OfRows::Limit { row, sticks, upper, term } => {
            let frictions = if sticks { &mut rows.adhesion } else { &mut rows.kinetic };
            if let Some(friction) = frictions.get_mut(row) {
                put_limit(if upper { &mut friction.upper } else { &mut friction.lower }, term, value);
            }
        }
        OfRows::Reaction { load, component, term } => {
            let reaction = rows.reaction.get_mut(load).and_then(|all| all.get_mut(component));
            if let Some(Affine { own, by }) = reaction {
                match term {
                    RowTerm::By(row) => store(by, row, value),
                    RowTerm::Own => *own = value,
                    // Sizes of reactions are in limits of frictions only.
                    RowTerm::Share(_) => {}
                }
            }
        }
    }
}

fn put_limit<S, const R: usize>(limit: &mut Limit<S, R>, term: RowTerm, value: S) {
    match term {
        RowTerm::Own => limit.own = value,
        RowTerm::By(row) => store(&mut limit.by, row, value),
        RowTerm::Share(load) => store(&mut limit.share, load, value),
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
> Contacts<R> for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    fn law(&self, row: usize) -> Law<S> {
        let Some(contacts) = &self.model.contacts else { return Law::Friction };
        match contacts.kind(row) {
            Some(ContactKind::Unilateral) => {
                let mut restitution = [S::ZERO];
                if let Some(code) = contacts.restitutions.get(row) {
                    self.run(code, &Frame::at(S::ZERO), [&mut restitution]);
                }
                Law::Unilateral { restitution: restitution[0] }
            }
            Some(ContactKind::Constraint) => Law::Constraint,
            Some(ContactKind::Friction) | None => Law::Friction,
        }
    }

    fn rows<T: Scalar>(
        &self,
        t: T,
        u: &Held<S, NQ, L, H, R>,
        x: &impl Fn(usize) -> T,
        constant: &impl Fn(S) -> T,
    ) -> Rows<T, R> {
        let (mechanism, held) = (self.map(constant), Self::map_held(u, constant));
        mechanism.contact_rows(t, &held, &core::array::from_fn(x))
    }

    fn rows_at(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Rows<S, R> {
        self.contact_rows(t, u, x)
    }

    fn exists(&self, u: &Held<S, NQ, L, H, R>, row: usize) -> bool {
        let Some(contacts) = &self.model.contacts else { return false };
        let Some(code) = &contacts.exist else { return row < contacts.lowered.rows.len() };
        let mut exist = [S::ZERO; R];
        self.run(code, &Frame { held: Some(u), ..Frame::at(S::ZERO) }, [&mut exist]);
        exist.get(row).is_some_and(|exists| *exists > S::lit(0.5))
    }

    fn is_bounded_by_pushes(&self, row: usize) -> bool {
        let row = self.model.contacts.as_ref().and_then(|contacts| contacts.lowered.rows.get(row));
        row.is_some_and(|row| row.bounded_by_pushes)
    }

    fn bound_may_fall(&self, row: usize) -> bool {
        let row = self.model.contacts.as_ref().and_then(|contacts| contacts.lowered.rows.get(row));
        row.is_some_and(|row| row.bound_may_fall)
    }

    fn kinematics<T: Scalar>(
        &self,
        t: T,
        u: &Held<S, NQ, L, H, R>,
        x: &impl Fn(usize) -> T,
        constant: &impl Fn(S) -> T,
    ) -> Kinematics<T, R> {
        let (mechanism, held) = (self.map(constant), Self::map_held(u, constant));
        mechanism.contact_kinematics(t, &held, &core::array::from_fn(x))
    }

    fn kinematics_at(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Kinematics<S, R> {
        self.contact_kinematics(t, u, x)
    }

    fn sliding(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Option<[S; R]> {
        let (mut dx, mut sizes) = ([S::ZERO; N], [S::ZERO; R]);
        self.contact_sliding(t, u, x, &mut dx, Some(&mut sizes)).map(|_| sizes)
    }

    fn free_rate(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N], dx: &mut [S; N]) -> Health<S> {
        let mut held = *u;
        held.contact.lambda = [S::ZERO; R];
        self.rate_holding(t, &held, x, dx)
    }

    fn response(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N], lambda: &[S; R]) -> [S; N] {
        self.contact_response(t, u, x, lambda)
    }

    fn motion_at(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Motion<S, [S; N], R> {
        let together = self.contact_functions(u).and_then(|functions| functions.together.as_ref());
        let (mut rows, free);
        if together.is_some() {
            rows = Rows::none();
            free = self.contact_pass(together, (t, u, x), &mut rows);
        } else {
            rows = self.contact_kinematics(t, u, x).rows();
            free = self.contact_motion(t, u, x, &mut rows);
        }
        Motion { rate: free.rate, responses: *free.responses, rows, health: free.health }
    }

    fn rate_with_forces(
        &self,
        t: S,
        u: &Held<S, NQ, L, H, R>,
        x: &[S; N],
        lambda: &[S; R],
    ) -> Option<[S; N]> {
        if self.model.contacts.as_ref().is_none_or(|contacts| contacts.lowered.is_affine) {
            return None;
        }
        let (mut held, mut dx) = (*u, [S::ZERO; N]);
        held.contact.lambda = *lambda;
        self.rate_holding(t, &held, x, &mut dx);
        Some(dx)
    }

    fn moves_by_time(&self) -> bool {
        self.model.contacts.as_ref().is_some_and(|contacts| contacts.lowered.moves_by_time)
    }

    fn impact_law(&self) -> ImpactLaw {
        match self.model.contacts.as_ref().map(|contacts| contacts.lowered.impacts) {
            Some(Impacts::Newton) => ImpactLaw::Newton,
            Some(Impacts::Sequential) => ImpactLaw::Sequential,
            Some(Impacts::Poisson) | None => ImpactLaw::Poisson,
        }
    }

    fn length(&self) -> S {
        S::lit(self.model.lowered.length)
    }

    fn project_joints(&self, t: S, _u: &Held<S, NQ, L, H, R>, x: &mut [S; N]) -> Result<(), Fault> {
        if self.projects() { absolute::project_state::<S, Self, NQ, NC, N>(self, t, x) } else { Ok(()) }
    }

    fn drift_of_joints(&self, t: S, _u: &Held<S, NQ, L, H, R>, x: &[S; N]) -> Drift<S> {
        if self.projects() {
            return absolute::drift::<S, Self, NQ, NC, N>(self, t, x);
        }
        Drift { phi: S::ZERO, phi_dot: S::ZERO }
    }
}
