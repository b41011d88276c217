//! A mechanism with contact as generated code has it: a block of 1.7 kg on an inclined table.
//!
//! ```text
//! force: if block.x < until { pull } else { 0 N };
//! unilateral tip: block.y >= 0 { restitution: e; }
//! friction slip: rate(block.x) within mu*reaction(tip);
//! ```
//!
//! The `loads` of the motion have the multipliers of the discrete state. The rate computes with a copy that has those of its moment.
#![allow(
    clippy::unused_self,
    reason = "functions of generated code have the mechanism, whether they read it or not"
)]

use plm_runtime::generated as rt;
use rt::{Fault, Real, Scalar};

/// The length of the state; conditions of the mechanism's own, whose guards come first; contact rows.
const LENGTH: usize = 4;
const OWN: usize = 1;
const ROWS: usize = 2;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block<S = f64> {
    /// The angle of the table, rad.
    pub(crate) incline: S,
    /// The coefficient of friction.
    pub(crate) mu: S,
    /// The coefficient of restitution.
    pub(crate) e: S,
    /// How far it is pulled, m.
    pub(crate) until: S,
    /// Place and velocity where it starts.
    pub(crate) start: [S; LENGTH],
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Input<S = f64> {
    /// A force along the table, N.
    pub(crate) pull: S,
}

/// Discrete state: constant during a step.
pub(crate) type Held<S> =
    rt::Held<Input<S>, [S; OWN], [<S as Scalar>::Turns; 0], (), rt::contact::Held<S, ROWS>>;

/// What the equations are: code for any numbers.
impl<S: Scalar> Block<S> {
    const MASS: f64 = 1.7;
    const GRAVITY: f64 = 9.81;

    /// The rate with the multipliers of the discrete state.
    fn motion(&self, _t: S, u: &Held<S>, x: &[S; LENGTH], dx: &mut [S; LENGTH]) -> S {
        let lit = S::lit;
        let [_, _, vx, vy] = *x;
        let [tip, slip] = u.contact.lambda;
        let (sin, cos) = self.incline.sin_cos();
        let weight = lit(Self::MASS * Self::GRAVITY);
        dx[0] = vx;
        dx[1] = vy;
        dx[2] = (weight * sin + Self::pull(u) + slip) / lit(Self::MASS);
        dx[3] = (tip - weight * cos) / lit(Self::MASS);
        lit(1.0)
    }

    fn pull(u: &Held<S>) -> S {
        S::select(u.switches[0].lt(S::lit(0.0)), u.input.pull, S::lit(0.0))
    }

    /// Guards of its own conditions.
    fn switching(&self, _t: S, u: &Held<S>, x: &[S; LENGTH], g: &mut [S; OWN]) {
        g[0] = u.switches[0] * (x[0] - self.until);
    }

    /// Gaps, rates, free accelerations, the Delassus operator, and limits of friction.
    fn contact_rows(&self, _t: S, u: &Held<S>, x: &[S; LENGTH], rows: &mut rt::contact::Rows<S, ROWS>) {
        let lit = S::lit;
        let (sin, cos) = self.incline.sin_cos();
        rows.gap = [x[1], x[0]];
        rows.rate = [x[3], x[2]];
        rows.free = [-(lit(Self::GRAVITY) * cos), lit(Self::GRAVITY) * sin + Self::pull(u) / lit(Self::MASS)];
        rows.delassus[0][0] = lit(1.0 / Self::MASS);
        rows.delassus[1][1] = lit(1.0 / Self::MASS);
        rows.kinetic[1].lower.by[0] = self.mu;
        rows.kinetic[1].upper.by[0] = self.mu;
        rows.adhesion[1] = rows.kinetic[1];
    }

    /// What multipliers add to the rate.
    fn contact_response(&self, _t: S, _u: &Held<S>, _x: &[S; LENGTH], lambda: &[S; ROWS]) -> [S; LENGTH] {
        let (zero, mass) = (S::lit(0.0), S::lit(Self::MASS));
        [zero, zero, lambda[1] / mass, lambda[0] / mass]
    }
}

impl<S: Scalar> rt::Rate for Block<S> {
    type S = S;
    type X = [S; LENGTH];
    type U = Held<S>;
    const NQ: usize = 2;

    fn rate(&self, t: S, u: &Self::U, x: &[S; LENGTH], dx: &mut [S; LENGTH]) -> rt::Health<S> {
        if !u.contact.has_forces() {
            return rt::Health(self.motion(t, u, x, dx));
        }
        let mut rows = rt::contact::Rows::none();
        self.contact_rows(t, u, x, &mut rows);
        let u = &rt::Held { contact: rt::contact::with_multipliers(&rows, &u.contact), ..*u };
        let health = rt::Health(self.motion(t, u, x, dx));
        rt::contact::settle(dx, &u.contact, |lambda| self.contact_response(t, u, x, lambda));
        health
    }
}

impl<S: Real> rt::contact::Contacts<ROWS> for Block<S> {
    fn law(&self, row: usize) -> rt::contact::Law<S> {
        match row {
            0 => rt::contact::Law::Unilateral { restitution: self.e },
            _ => rt::contact::Law::Friction,
        }
    }
    fn rows<T: Scalar>(
        &self,
        t: T,
        u: &Self::U,
        x: &impl Fn(usize) -> T,
        constant: &impl Fn(S) -> T,
    ) -> rt::contact::Rows<T, ROWS> {
        use rt::lanes::Pack;
        let number = |[s]: [S; 1]| constant(s);
        let (mechanism, held) = (self.pack([self], number), Self::pack_held(u, [u], number));
        let mut rows = rt::contact::Rows::none();
        mechanism.contact_rows(t, &held, &core::array::from_fn(x), &mut rows);
        rows
    }
    fn rows_at(&self, t: S, u: &Self::U, x: &[S; LENGTH]) -> rt::contact::Rows<S, ROWS> {
        let mut rows = rt::contact::Rows::none();
        self.contact_rows(t, u, x, &mut rows);
        rows
    }
    fn free_rate(&self, t: S, u: &Self::U, x: &[S; LENGTH], dx: &mut [S; LENGTH]) -> rt::Health<S> {
        let mut u = *u;
        u.contact.lambda = [S::lit(0.0); ROWS];
        rt::Health(self.motion(t, &u, x, dx))
    }
    fn response(&self, t: S, u: &Self::U, x: &[S; LENGTH], lambda: &[S; ROWS]) -> [S; LENGTH] {
        self.contact_response(t, u, x, lambda)
    }
}

impl<S: Real> rt::Constraints for Block<S> {
    fn project(&self, t: S, u: &Self::U, x: &mut [S; LENGTH]) -> Result<(), Fault> {
        rt::contact::project::<Self, ROWS>(self, t, u, x)
    }
    fn drift(&self, t: S, u: &Self::U, x: &[S; LENGTH]) -> rt::Drift<S> {
        rt::contact::drift::<Self, ROWS>(self, t, u, x)
    }
    fn is_settled(&self, _t: S, _u: &Held<S>, _x: &[S; LENGTH]) -> bool {
        true
    }
}

impl<S: Real> rt::Switched for Block<S> {
    type Guards = [S; OWN + rt::contact::guard_count(ROWS)];
    type Contact = rt::switched::WithContact<ROWS>;
    const SWITCHES: rt::Switches = rt::Switches {
        guards: OWN,
        rows: ROWS,
        contact_guards: rt::contact::guard_count(ROWS),
        ..rt::Switches::NONE
    };

    fn watch<T>(&self, t: S, u: &Self::U, x: &[S; LENGTH], see: impl FnOnce(&[S]) -> T) -> T {
        let mut own = [S::lit(0.0); OWN];
        self.switching(t, u, x, &mut own);
        see(&own)
    }
    fn watch_within(
        &self,
        t: rt::Enclosed<S>,
        u: &Self::U,
        x: &impl Fn(usize) -> rt::Enclosed<S>,
        each: &mut impl FnMut(usize, rt::Enclosed<S>),
    ) -> bool {
        use rt::lanes::Pack;
        let constant = |[s]: [S; 1]| rt::Enclosed::constant(s);
        let (mechanism, held) = (self.pack([self], constant), Self::pack_held(u, [u], constant));
        let mut own = [rt::Enclosed::constant(S::lit(0.0)); OWN];
        mechanism.switching(t, &held, &core::array::from_fn(x), &mut own);
        for (number, guard) in own.into_iter().enumerate() {
            each(number, guard);
        }
        true
    }
}

impl<S: Real> rt::Labels for Block<S> {
    fn labels(&self) -> &'static rt::LabelTable {
        const {
            &rt::LabelTable {
                guards: &["near", "tip", "tip", "tip", "slip", "slip", "slip", "contact"],
                contacts: &["tip", "slip"],
                ..rt::LabelTable::NONE
            }
        }
    }
}

impl<S: Real> rt::Mechanism for Block<S> {
    type State = plm_runtime::At<Self>;
    type Rescue = rt::singular::Never<Self>;

    fn start_state(&self, t: S) -> Result<(Self::U, [S; LENGTH]), Fault> {
        let contact = rt::contact::Held::open();
        let input = Input { pull: S::lit(0.0) };
        let mut held = rt::Held { input, switches: [S::lit(1.0)], turns: [], of_loops: (), contact };
        let mut x = self.start;
        rt::events::switch_where_due(self, t, &mut held, &mut x)?;
        rt::contact::begin::<Self, ROWS>(self, t, &mut held, &mut x)?;
        Ok((held, x))
    }
}

impl<S: Real> rt::lanes::Pack for Block<S> {
    type Packed<T: Scalar> = Block<T>;
    const WATCHED: bool = true;

    fn pack<T: Scalar, const N: usize>(&self, all: [&Self; N], number: impl Fn([S; N]) -> T) -> Block<T> {
        Block {
            incline: number(all.map(|one| one.incline)),
            mu: number(all.map(|one| one.mu)),
            e: number(all.map(|one| one.e)),
            until: number(all.map(|one| one.until)),
            start: core::array::from_fn(|i| number(all.map(|one| one.start[i]))),
        }
    }
    fn pack_held<T: Scalar, const N: usize>(
        first: &Held<S>,
        all: [&Held<S>; N],
        number: impl Fn([S; N]) -> T,
    ) -> Held<T> {
        let contacts = all.map(|held| &held.contact);
        let contact = rt::contact::Held::packed(&first.contact, contacts, &number);
        let input = Input { pull: number(all.map(|held| held.input.pull)) };
        let switches = core::array::from_fn(|k| number(all.map(|held| held.switches[k])));
        rt::Held { input, switches, turns: [], of_loops: (), contact }
    }
    fn are_calm<T: Scalar>(_typical: &[T; LENGTH], _t: T, _held: &Held<T>, _x: &[T; LENGTH]) -> T {
        T::lit(1.0)
    }
    fn are_short<T: Scalar>(_typical: &[T; LENGTH], _held: &Held<T>, _ends: [&[T; LENGTH]; 2]) -> T {
        T::lit(1.0)
    }
    fn look<T: Scalar>(_all: &Block<T>, _t: T, _held: &mut Held<T>, _x: &[T; LENGTH], _due: T) -> T {
        T::lit(0.0)
    }
    fn put_held<T: Scalar>(_wide: &mut Held<T>, _one: &Held<S>, _put: impl Fn(&mut T, S)) {}
    fn take_held<T: Scalar>(_one: &mut Held<S>, _wide: &Held<T>, _take: impl Fn(T) -> S) {}
    fn chart(_held: &Held<S>) -> Option<usize> {
        Some(0)
    }
}

impl<S: Real> rt::Linear for Block<S> {
    type Lifted<const K: usize> = Block<rt::Dual<S, K>>;
    type In<T: Real> = Block<T>;
    type Derivatives = [[S; LENGTH]; LENGTH];

    fn lift<const K: usize>(&self, held: &Held<S>) -> (Block<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
        self.in_numbers(held, rt::Dual::constant)
    }

    fn in_numbers<T: Real>(&self, held: &Held<S>, number: impl Fn(S) -> T) -> (Block<T>, Held<T>) {
        use rt::lanes::Pack;
        let of_one = |[s]: [S; 1]| number(s);
        (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
    }

    fn held_rows(&self, t: S, u: &Held<S>, x: &[S; LENGTH], row: &mut impl FnMut(S)) {
        rt::contact::held_rows::<Self, ROWS>(self, t, u, x, row);
    }
}
