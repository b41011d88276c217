#[doc(inline)]
#[allow(unreachable_pub)]
pub use plm_bouncer_::bouncer::Bouncer;

#[doc(inline)]
#[allow(unreachable_pub, unused_imports)]
pub use plm_bouncer_::bouncer;
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]
mod plm_bouncer_ {
    /// A block that is pushed back to the middle, a spring that does not pull, and a clock: conditions of the state and of the time.
    ///
    /// 2 bodies, 5 parts: 6 coordinates, 4 constraint rows, F = 3 N - M = 2.
    /// Formulation 2: joint coordinates; the joints make a tree, so that no constraint is left.
    /// Coordinates: rail.displacement, other.displacement.
    /// Accelerations by a dense mass matrix.
    /// State: 4 numbers, 32 bytes in f64.
    /// A solution by rank, where one is needed: 320 bytes of stack in f64.
    /// One right-hand side: 3 add, 2 mul, 8 select.
    ///
    /// | row | constraint | equation | unit |
    /// |----:|------------|----------|------|
    /// | 0 | `rail.normal` | `-block.y = 0` | m |
    /// | 1 | `rail.angle` | `-block.angle = 0` | rad |
    /// | 2 | `other.normal` | `-clock.y = 0` | m |
    /// | 3 | `other.angle` | `-clock.angle = 0` | rad |
    pub mod bouncer {
        pub use super::code_::*;
        pub use super::type_::Bouncer;
    }

    mod type_ {
        /// A block that is pushed back to the middle, a spring that does not pull, and a clock: conditions of the state and of the time.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Bouncer<S = ::core::primitive::f64> {
            /// When the pulse ends.
            ///
            /// In s; 0.7 s by default.
            pub until: S,
            /// Start values of the bodies, and which of them assembly keeps.
            pub start: super::code_::Starts<S>,
        }
    }

    mod code_ {
        use super::type_::Bouncer;
        use ::plm::runtime::generated as rt;
        use ::plm::runtime::generated::lanes::Two;
        use ::plm::runtime::generated::{
            BodyStart, BodyState, Fault, Method, Operations, Real, Scalar, Sim, Start,
        };
        use ::plm::runtime::generated::{absolute, described};

        /// Start values, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Starts<S = f64> {
            /// Origin of body `block`.
            pub block: BodyStart<S>,
            /// Origin of body `clock`.
            pub clock: BodyStart<S>,
        }

        /// Result of assembly.
        pub type Assembly<S = f64> = rt::Assembly<S, NQ, NC>;

        /// Inputs, held over a step, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Input<S = f64> {
            /// Input `push`, N; 0 N by default.
            pub push: S,
        }

        /// Discrete state: constant during a step.
        type Held<S> = rt::Held<Input<S>, [S; 4], [<S as Scalar>::Turns; 0], ()>;

        /// Pose, accelerations and a vector, which outputs have in common.
        type Common<S> = rt::Common<([S; 6], [S; 6]), Held<S>, ([S; 6], [S; 4]), [S; 2]>;

        /// The mechanism at one moment; its methods read poses and outputs, `input` has the inputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: Bouncer<S>,
            held: rt::Held<Input<S>, [S; 4], [i32; 0], ()>,
            time: S,
            x: [S; 4],
        }

        /// Gives the `input` of a moment, and all else that is held over a step.
        impl<S: Real> core::ops::Deref for State<S> {
            type Target = Held<S>;

            fn deref(&self) -> &Held<S> {
                &self.held
            }
        }

        impl<S: Real> core::ops::DerefMut for State<S> {
            fn deref_mut(&mut self) -> &mut Held<S> {
                &mut self.held
            }
        }

        /// Coordinates: (x, y, theta) of each body.
        pub const NQ: usize = 6;
        /// Constraint rows.
        pub const NC: usize = 4;
        /// First-order states.
        pub const NX: usize = 0;
        /// Degrees of freedom, `3 N - M`.
        pub const NDOF: isize = 2;
        /// Operations of one evaluation of the right-hand side.
        pub const OPERATIONS: Operations =
            Operations { add: 3, mul: 2, div: 0, sqrt: 0, sin_cos: 0, other: 8 };
        impl<S: Real> State<S> {
            /// Time, s.
            pub fn time(&self) -> S {
                self.time
            }

            /// Pose and velocity of G of body `block`: m, m, rad; m/s, m/s, rad/s.
            pub fn block(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[0], q[1], q[2]], [v[0], v[1], v[2]])
            }

            /// Pose and velocity of G of body `clock`: m, m, rad; m/s, m/s, rad/s.
            pub fn clock(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[3], q[4], q[5]], [v[3], v[4], v[5]])
            }

            /// Output `block.x`, m.
            pub fn block_x(&self) -> S {
                self.block_x_among_(&Common::<S>::new())
            }

            #[inline]
            fn block_x_among_(&self, common: &Common<S>) -> S {
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                q[0]
            }

            /// Kinetic energy of all bodies, J.
            pub fn kinetic_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [block_vx, block_vy, block_omega, clock_vx, clock_vy, clock_omega, ..] = *v;
                let by = rt::Factor;
                let t1 = by(2.0).mul_add(
                    block_vy.mul_add(block_vy, block_vx * block_vx),
                    clock_omega.mul_add(
                        clock_omega,
                        clock_vy.mul_add(clock_vy, clock_vx.mul_add(clock_vx, block_omega * block_omega)),
                    ),
                );
                by(0.5) * t1
            }

            /// Potential energy of gravity above the origin, J.
            pub fn gravity_energy(&self) -> S {
                let lit = S::lit;
                lit(0.0)
            }

            /// Power of all forces and torques but gravity and reactions, W.
            pub fn load_power(&self) -> S {
                let common = &Common::<S>::new();
                let (q, v) = common.pose.get_or_init(|| self.pose_());
                let [_, _, _, clock_x, ..] = *q;
                let [_, switch_1, switch_2, switch_3, ..] = self.held.switches;
                let [block_vx, _, _, clock_vx, ..] = *v;
                let lit = S::lit;
                let by = rt::Factor;
                let push = self.held.input.push;
                let t1 = S::select(clock_x.lt(lit(100.0)), lit(0.0), by(-10.0) * (clock_x - lit(100.0)))
                    + (push
                        + S::select(
                            switch_3.lt(lit(0.0)),
                            lit(0.0),
                            S::select(switch_2.lt(lit(0.0)), lit(3.0), lit(0.0)),
                        ));
                clock_vx.mul_add(t1, block_vx * S::select(switch_1.lt(lit(0.0)), lit(4.0), lit(-2.0)))
            }

            /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
            /// the second turns from the first, rad, positive to the left.
            pub fn branches(&self) -> [(&'static str, S); 0] {
                let mut value = [S::lit(0.0); 0];
                []
            }

            /// Names and units of the columns of [`State::outputs`].
            pub const OUTPUTS: [(&'static str, &'static str); 1] = [("block.x", "m")];
            /// The declared outputs, in the units of [`State::OUTPUTS`].
            pub fn outputs(&self) -> [S; 1] {
                let common = &Common::<S>::new();
                let own_0 = self.block_x_among_(common);
                [own_0]
            }

            /// Names and SI units of the outputs and of all that is observed.
            pub const OBSERVED: [(&'static str, &'static str); 1] = [("block.x", "m")];

            /// The quantities of these names; `Err` with the first that is not in [`State::OBSERVED`].
            pub fn find<'n, const K: usize>(names: [&'n str; K]) -> Result<[rt::Observed; K], &'n str> {
                rt::Observed::find(&Self::OBSERVED, names)
            }

            /// The values of these quantities, SI; each is worked out when it is asked for, and what they have in common once.
            pub fn observed<const K: usize>(&self, quantities: [rt::Observed; K]) -> [S; K] {
                let common = &Common::<S>::new();
                quantities.map(|quantity| self.column_(quantity.column(), common))
            }

            /// The value of a quantity by its number.
            fn column_(&self, column: usize, common: &Common<S>) -> S {
                fn block_0<S: Real>(state: &State<S>, column: usize, common: &Common<S>) -> S {
                    match column {
                        0 => state.block_x_among_(common),
                        _ => S::lit(f64::NAN),
                    }
                }
                match column / 200 {
                    0 => block_0(self, column, common),
                    _ => S::lit(f64::NAN),
                }
            }
        }

        impl Bouncer<f64> {
            /// The mechanism as declared, in `f64`; `Bouncer { field: value, ..Bouncer::new() }` changes some.
            pub fn new() -> Self {
                Self::of()
            }
        }

        impl Default for Bouncer<f64> {
            fn default() -> Self {
                Self::of()
            }
        }

        impl<S: Scalar> Bouncer<S> {
            /// The mechanism as declared, for any scalar.
            pub fn of() -> Self {
                let lit = S::lit;
                let until = lit(0.7);
                let start = Starts {
                    block: BodyStart {
                        x: Start::free(lit(1.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.0)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    clock: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.0)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                };
                Bouncer { until, start }
            }
        }

        impl<S: Real> Bouncer<S> {
            /// Closes the joints from the start values, as the manual's assembly does (section 4.4).
            ///
            /// # Errors
            /// Redundant locks, or joints that stay open: the part and by how much; a parameter that cannot have its value.
            pub fn assemble(&self) -> Result<Assembly<S>, Fault> {
                let t = S::lit(0.0);
                rt::Mechanism::check(self, t)?;
                let assembly = absolute::assemble(self, t)?;
                Ok(assembly)
            }

            /// Assembles, and gives a run by Dormand and Prince's method.
            ///
            /// # Errors
            /// As [`Self::assemble`].
            pub fn start(self) -> Result<Sim<Self>, Fault> {
                rt::Mechanism::start(self)
            }

            /// Assembles, and gives a run by a method of choice.
            ///
            /// # Errors
            /// As [`Self::assemble`].
            pub fn start_with<I: Method<Self>>(self, method: I) -> Result<Sim<Self, I>, Fault> {
                rt::Mechanism::start_with(self, method)
            }
        }

        impl<S: Scalar> Bouncer<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> Input<S> {
                let lit = S::lit;
                Input { push: lit(0.0) }
            }
        }

        impl<S: Scalar> rt::Rate for Bouncer<S> {
            type S = S;
            type X = [S; 4];
            type U = Held<S>;
            const NQ: usize = 2;
            const SHORT: bool = !S::REGISTERS.are_filled();
            #[inline(always)]
            fn rate(&self, t: S, u: &Self::U, x: &[S; 4], dx: &mut [S; 4]) -> rt::Health<S> {
                self.motion(t, u, x, dx);
                rt::Health::perfect()
            }

            #[inline]
            fn typical(&self) -> [S; 4] {
                [1.0; 4].map(S::lit)
            }
        }

        impl<S: Real> rt::Constraints for Bouncer<S> {
            #[inline(always)]
            fn compute<C: rt::Computation>(
                &self,
                times: (Self::S, Self::S),
                u: &Self::U,
                from: (&Self::X, &Self::X),
            ) -> (C::Made<Self::X>, rt::Health<Self::S>) {
                rt::linear::compute::<Self, C>(self, times, u, from)
            }

            #[inline(always)]
            fn ask<Q: rt::Question<Self::S>>(&self, u: &Self::U, question: Q) -> Q::Answer {
                rt::linear::ask::<Self, Q>(self, u, question)
            }

            #[inline]
            fn is_settled(&self, _t: S, _u: &Self::U, _x: &[S; 4]) -> bool {
                true
            }

            fn energy(&self, t: S, u: &Self::U, x: &[S; 4]) -> Option<rt::Energy<S>> {
                let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
                let (kinetic, gravity) = (state.kinetic_energy(), state.gravity_energy());
                Some(rt::Energy { kinetic, gravity, power: state.load_power() })
            }
        }

        impl<S: Real> rt::Switched for Bouncer<S> {
            type Guards = [S; 2];
            type Contact = rt::switched::NoContact;
            const SWITCHES: rt::Switches =
                rt::Switches { guards: 2, kinks: 1, times: 2, ..rt::Switches::NONE };
            #[inline]
            fn watch<T>(&self, t: S, u: &Self::U, x: &[S; 4], see: impl FnOnce(&[S]) -> T) -> T {
                let mut all = [S::lit(0.0); 3];
                let g = &mut all;
                self.switching(t, u, x, g);
                see(&all)
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
                let mut all = [rt::Enclosed::constant(S::lit(0.0)); 3];
                let within =
                    |u: &Held<rt::Enclosed<S>>, x: &[rt::Enclosed<S>; 4], g: &mut [rt::Enclosed<S>; 3]| {
                        mechanism.switching(t, u, x, g)
                    };
                within(&held, &rt::Vector::from_fn(x), &mut all);
                for (number, value) in all.into_iter().enumerate() {
                    each(number, value);
                }
                true
            }

            #[inline]
            fn known_times<T>(&self, u: &Self::U, see: impl FnOnce(&[S], &[S]) -> T) -> T {
                let (mut at, mut slope) = ([S::lit(0.0); 2], [S::lit(0.0); 2]);
                self.instants(u, &mut at, &mut slope);
                see(&at, &slope)
            }

            #[inline]
            fn is_required(&self, index: usize) -> bool {
                matches!(index, 0)
            }
        }

        impl<S: Real> rt::Labels for Bouncer<S> {
            fn labels(&self) -> &'static rt::LabelTable {
                const {
                    &rt::LabelTable {
                        parts: rt::PartNames::Numbers(const { &["rail", "other", "rail", "other"] }),
                        states: const { &["rail.displacement", "other.displacement", "rail.speed", "other.speed"] },
                        guards: &["near", "back"],
                        conditions: &["near", "block.x < 0 m"],
                        instants: &["pulse", "pulse"],
                        ..rt::LabelTable::NONE
                    }
                }
            }
        }

        impl<S: Real> State<S> {
            /// Pose and velocity of every body.
            #[inline]
            fn pose_(&self) -> ([S; 6], [S; 6]) {
                let (mut q, mut v) = ([S::lit(0.0); 6], [S::lit(0.0); 6]);
                self.mechanism.pose(self.time, &self.held, &self.x, &mut q, &mut v);
                (q, v)
            }
        }

        impl<S: Real> State<S> {
            /// The state in absolute coordinates.
            fn absolute_(&self) -> [S; 12] {
                self.joined_(&self.pose_())
            }

            /// The state in absolute coordinates, of pose and velocity.
            fn joined_(&self, (q, v): &([S; 6], [S; 6])) -> [S; 12] {
                let mut x = [S::lit(0.0); 12];
                absolute::join(q, v, &mut x);
                x
            }
        }

        impl<S: Real> rt::Moment for State<S> {
            type M = Bouncer<S>;

            fn new(mechanism: Bouncer<S>, held: Held<S>, time: S, x: [S; 4]) -> Self {
                State { mechanism, held, time, x }
            }

            fn mechanism(&self) -> &Bouncer<S> {
                &self.mechanism
            }

            fn held(&self) -> Held<S> {
                self.held
            }

            fn time(&self) -> S {
                self.time
            }

            fn x(&self) -> &[S; 4] {
                &self.x
            }

            fn set(&mut self, time: S, held: &Held<S>, x: &[S; 4]) {
                self.time = time;
                self.held = *held;
                self.x = *x;
            }

            fn in_place(&mut self) -> rt::InPlace<'_, Bouncer<S>> {
                let Self { mechanism, held, time, x } = self;
                rt::InPlace { system: mechanism, held, time, x }
            }
        }

        impl<S: Real> rt::Mechanism for Bouncer<S> {
            type State = State<S>;
            type Rescue = rt::singular::Never<Self>;
            const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();
            fn start_state(&self, t: S) -> Result<(Held<S>, [S; 4]), Fault> {
                self.start_holding_(t, self.declared_input())
            }

            fn check(&self, t: S) -> Result<(), Fault> {
                rt::limits::check_numbers(t, [("until", "s", self.until)])?;
                Ok(())
            }

            fn fingerprint(&self) -> u64 {
                rt::limits::fingerprint([self.until])
            }

            fn renew(&self, t: S, held: &mut Held<S>, x: &mut [S; 4]) -> Result<(), Fault> {
                let (mut q, mut v): ([S; 6], [S; 6]) =
                    <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::renew::<S, Self, NQ, NC>(self, t, &mut q, &mut v)?;
                self.to_chart(t, &q, &v, x);
                Ok(())
            }

            fn opening(&self, t: S, held: &Held<S>, x: &[S; 4]) -> rt::Drift<S> {
                let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
            }
        }

        impl<S: Real> Bouncer<S> {
            fn holding_(input: Input<S>) -> Held<S> {
                rt::Held { input, switches: [S::lit(1.0); 4], turns: [0; 0], of_loops: (), contact: () }
            }

            fn start_holding_(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; 4]), Fault> {
                rt::Mechanism::check(self, t)?;
                let assembly = absolute::assemble(self, t)?;
                let mut x = [S::lit(0.0); 4];
                let mut held = Self::holding_(input);
                self.to_chart(t, &assembly.q, &assembly.v, &mut x);
                rt::Events::switch_at_time(self, t, &mut held, &mut x)?;
                rt::events::switch_where_due(self, t, &mut held, &mut x)?;
                Ok((held, x))
            }
        }

        impl<S: Scalar> Bouncer<S> {
            const LAYOUT_: absolute::Layout = absolute::Layout {
                rows: const { &["rail.normal", "rail.angle", "other.normal", "other.angle"] },
                parts: const { &["rail", "rail", "other", "other"] },
                coordinates: const { &["block.x", "block.y", "block.angle", "clock.x", "clock.y", "clock.angle"] },
                angular: &[false, true, false, true],
                given_angles: &[],
            };
            /// The derivatives of phi by q: the entries that are not zero, row by row.
            #[cold]
            fn phi_q_entries(&self, t: S, q: &[S; 6], phi_q: &mut [S; 4]) {
                let lit = S::lit;
                phi_q[0] = lit(-1.0);
                phi_q[1] = lit(-1.0);
                phi_q[2] = lit(-1.0);
                phi_q[3] = lit(-1.0);
            }
        }

        #[doc(hidden)]
        impl<S: Real> absolute::Absolute<S, NQ, NC> for Bouncer<S> {
            fn layout(&self) -> &'static absolute::Layout {
                const { &Self::LAYOUT_ }
            }

            /// Residuals of the constraints, m or rad; the rows stand in the table of this module.
            ///
            /// 4 neg.
            fn phi(&self, t: S, q: &[S; 6]) -> [S; 4] {
                let mut phi = [S::lit(0.0); 4];
                let [_, block_y, block_angle, _, clock_y, clock_angle, ..] = *q;
                phi[0] = -block_y;
                phi[1] = -block_angle;
                phi[2] = -clock_y;
                phi[3] = -clock_angle;
                phi
            }

            /// Their rates, `phi_q v - nu`, m/s or rad/s.
            ///
            /// 4 neg.
            fn phi_dot(&self, t: S, q: &[S; 6], v: &[S; 6]) -> [S; 4] {
                let mut phi_dot = [S::lit(0.0); 4];
                let [_, block_vy, block_omega, _, clock_vy, clock_omega, ..] = *v;
                phi_dot[0] = -block_vy;
                phi_dot[1] = -block_omega;
                phi_dot[2] = -clock_vy;
                phi_dot[3] = -clock_omega;
                phi_dot
            }

            fn phi_q(&self, t: S, q: &[S; 6], each: &mut impl FnMut(usize, usize, S)) {
                let places: &[[u32; 2]] = const {
                    &rt::compact::pairs::<4>(&rt::compact::numbers::<8>(&[(
                        1,
                        &[0, 1, 1, 2, 2, 4, 3, 5],
                        &[],
                    )]))
                };
                let mut entries = [S::lit(0.0); 4];
                self.phi_q_entries(t, q, &mut entries);
                for (&[row, column], entry) in places.iter().zip(entries) {
                    each(row as usize, column as usize, entry);
                }
            }

            /// The shortest step in the norm of `W^-1` that closes `r`: `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 8 mul, 4 div, 4 neg.
            fn min_norm(&self, t: S, q: &[S; 6], w: &[S; 6], r: &[S; 4], dq: &mut [S; 6]) -> rt::Health<S> {
                rt::Health({
                    let [dphi_0, dphi_1, dphi_2, dphi_3, ..] = *r;
                    let [_, w_1, w_2, _, w_4, w_5, ..] = *w;
                    let lit = S::lit;
                    let by = rt::Factor;
                    // phi_q W phi_q^T = L D L^T
                    // (phi_q W phi_q^T) mu = r
                    // Results
                    dq[0] = lit(0.0);
                    dq[1] = -(w_1 * (dphi_0 * (by(1.0) / w_1)));
                    dq[2] = -(w_2 * (dphi_1 * (by(1.0) / w_2)));
                    dq[3] = lit(0.0);
                    dq[4] = -(w_4 * (dphi_2 * (by(1.0) / w_4)));
                    dq[5] = -(w_5 * (dphi_3 * (by(1.0) / w_5)));
                    lit(1.0)
                })
            }

            /// Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body.
            fn inverse_mass(&self) -> [S; 6] {
                let mut inverse_mass = [S::lit(0.0); 6];
                let lit = S::lit;
                inverse_mass[0] = lit(0.5);
                inverse_mass[1] = lit(0.5);
                inverse_mass[2] = lit(1.0);
                inverse_mass[3] = lit(1.0);
                inverse_mass[4] = lit(1.0);
                inverse_mass[5] = lit(1.0);
                inverse_mass
            }

            fn length(&self) -> S {
                S::lit(1.0)
            }

            fn start_position(&self) -> [Start<S>; 6] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 2] = [
                    self.start.block.of_centre([lit(0.0), lit(0.0)]),
                    self.start.clock.of_centre([lit(0.0), lit(0.0)]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn start_velocity(&self, q: &[S; 6]) -> [Start<S>; 6] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 2] = [
                    self.start.block.velocity_of_centre([lit(0.0), lit(0.0)], q[2]),
                    self.start.clock.velocity_of_centre([lit(0.0), lit(0.0)], q[5]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }
        }

        impl<S: Real> State<S> {
            /// Reactions that redundancy leaves undetermined, by constraint row: none.
            pub fn undetermined(&self) -> [bool; 4] {
                [false; 4]
            }
        }

        impl<S: Real> rt::lanes::Pack for Bouncer<S> {
            type Packed<T: Scalar> = Bouncer<T>;

            #[allow(unused_variables)]
            fn pack<T: Scalar, const N: usize>(
                &self,
                all: [&Self; N],
                number: impl Fn([S; N]) -> T,
            ) -> Bouncer<T> {
                let same = |s| number([s; N]);
                let start = Starts { block: self.start.block.map(same), clock: self.start.clock.map(same) };
                Bouncer { start, until: number(rt::Vector::from_fn(|i| all[i].until)) }
            }

            #[allow(unused_variables)]
            fn pack_held<T: Scalar, const N: usize>(
                first: &Held<S>,
                all: [&Held<S>; N],
                number: impl Fn([S; N]) -> T,
            ) -> Held<T> {
                let input = Input { push: number(rt::Vector::from_fn(|i| all[i].input.push)) };
                let switches = rt::Vector::from_fn(|k| number(rt::Vector::from_fn(|i| all[i].switches[k])));
                let of_loops = ();
                let turns = [];
                let contact = ();
                rt::Held { input, switches, turns, of_loops, contact }
            }

            const WATCHED: bool = true;
            #[inline]
            fn are_calm<T: Scalar>(typical: &[T; 4], t: T, held: &Held<T>, x: &[T; 4]) -> T {
                T::lit(1.0)
            }

            #[inline]
            fn are_short<T: Scalar>(typical: &[T; 4], held: &Held<T>, legs: [&[T; 4]; 2]) -> T {
                T::lit(1.0)
            }

            #[inline(never)]
            fn look<T: Scalar>(all: &Bouncer<T>, t: T, held: &mut Held<T>, x: &[T; 4], due: T) -> T {
                T::lit(0.0)
            }

            #[inline]
            fn put_held<T: Scalar>(wide: &mut Held<T>, one: &Held<S>, put: impl Fn(&mut T, S)) {
                rt::held::Loops::<S>::put(&mut wide.of_loops, &one.of_loops, &put);
                for (wide, &one) in wide.switches.iter_mut().zip(&one.switches) {
                    put(wide, one);
                }
                for (wide, &one) in wide.turns.iter_mut().zip(&one.turns) {
                    let mut turns = T::of_turns(*wide);
                    put(&mut turns, S::of_turns(one));
                    *wide = turns.to_turns();
                }
            }

            fn take_held<T: Scalar>(one: &mut Held<S>, wide: &Held<T>, take: impl Fn(T) -> S) {
                rt::held::Loops::<S>::take(&mut one.of_loops, &wide.of_loops, &take);
            }

            fn chart(held: &Held<S>) -> Option<usize> {
                rt::held::Loops::<S>::chart(&held.of_loops)
            }
        }

        impl<S: Real> rt::Linear for Bouncer<S> {
            type Lifted<const K: usize> = Bouncer<rt::Dual<S, K>>;
            type In<T: Real> = Bouncer<T>;
            type Derivatives = rt::linalg::Sparse<S, Augmented<S>, 3, 2, 2>;

            fn lift<const K: usize>(
                &self,
                held: &Held<S>,
            ) -> (Bouncer<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                self.in_numbers(held, rt::Dual::constant)
            }

            fn in_numbers<T: Real>(&self, held: &Held<S>, number: impl Fn(S) -> T) -> (Bouncer<T>, Held<T>) {
                use rt::lanes::Pack;
                let of_one = |[s]: [S; 1]| number(s);
                (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
            }

            #[inline]
            fn rate_in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (Bouncer<T>, Held<T>) {
                let value = Start::free(T::ZERO);
                let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
                let start = Starts { block: zero, clock: zero };
                let own = Bouncer { start, until: number(self.until) };
                (own, <Self as rt::lanes::Pack>::pack_held(held, [held], |[s]: [S; 1]| number(s)))
            }

            fn rate_reads_time(&self) -> bool {
                false
            }

            fn differentiate(
                &self,
                t: S,
                u: &Self::U,
                x: &[S; 4],
                by_x: &mut Self::Derivatives,
                by_t: Option<&mut [S; 4]>,
            ) -> rt::Health<S> {
                let mut dx = [S::lit(0.0); 4];
                let health = rt::Rate::rate(self, t, u, x, &mut dx);
                self.linearised(t, u, x, &dx, &mut by_x.coefficients);
                match by_t {
                    Some(by_t) => self.jvp(t, u, x, (S::lit(1.0), &[S::lit(0.0); 4]), by_t),
                    None => health,
                }
            }
        }

        impl<S: Real> rt::Ports for Bouncer<S> {
            type Input = Input<S>;
            const INPUTS: &'static [(&'static str, &'static str)] = &[("push", "N")];
            const OUTPUTS: &'static [(&'static str, &'static str)] = &State::<S>::OUTPUTS;
            fn inputs(held: &mut Held<S>) -> &mut Input<S> {
                &mut held.input
            }

            fn input(input: &mut Input<S>, index: usize) -> Option<&mut S> {
                match index {
                    0 => Some(&mut input.push),
                    _ => None,
                }
            }

            fn outputs(state: &State<S>, each: &mut impl FnMut(S)) {
                for output in state.outputs() {
                    each(output);
                }
            }
        }

        impl<S: Real> rt::Described for Bouncer<S> {
            const TABLES: &'static described::Tables = &described::Tables {
                name: "Bouncer",
                docs: "A block that is pushed back to the middle, a spring that does not pull, and a clock: conditions of the state and of the time.",
                report: described::Report {
                    rung: 2,
                    formulation: "joint coordinates",
                    reason: "the joints make a tree, so that no constraint is left",
                    operations: OPERATIONS,
                    degrees_of_freedom: NDOF,
                },
                bodies: &[
                    described::Body { name: "block", ports: &["o"], contour: 0, first: 0 },
                    described::Body { name: "clock", ports: &["o"], contour: 0, first: 6 },
                ],
                ground: &[described::GroundPort { name: "o", moves: false, first: 12 }],
                parts: &[
                    described::Part {
                        name: "rail",
                        kind: "prismatic",
                        pair: Some("prismatic"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 0 },
                            described::Frame { argument: "b", body: Some(0), port: 0 },
                        ],
                        sizes: &[],
                        first: 16,
                    },
                    described::Part {
                        name: "other",
                        kind: "prismatic",
                        pair: Some("prismatic"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 0 },
                            described::Frame { argument: "b", body: Some(1), port: 0 },
                        ],
                        sizes: &[],
                        first: 16,
                    },
                    described::Part {
                        name: "back",
                        kind: "force",
                        pair: None,
                        frames: &[described::Frame { argument: "a", body: Some(0), port: 0 }],
                        sizes: &[],
                        first: 16,
                    },
                    described::Part {
                        name: "pulse",
                        kind: "force",
                        pair: None,
                        frames: &[described::Frame { argument: "a", body: Some(1), port: 0 }],
                        sizes: &[],
                        first: 16,
                    },
                    described::Part {
                        name: "stop",
                        kind: "force",
                        pair: None,
                        frames: &[described::Frame { argument: "a", body: Some(1), port: 0 }],
                        sizes: &[],
                        first: 16,
                    },
                ],
                parameters: &[described::Quantity {
                    name: "until",
                    docs: "When the pulse ends.",
                    unit: "s",
                    factor: 1.0,
                    exponents: [0, 0, 1, 0, 0, 0, 0],
                    default: Some(0.7),
                }],
                inputs: &[described::Quantity {
                    name: "push",
                    docs: "",
                    unit: "N",
                    factor: 1.0,
                    exponents: [1, 1, -2, 0, 0, 0, 0],
                    default: Some(0.0),
                }],
                states: &[],
                outputs: &[described::Quantity {
                    name: "block.x",
                    docs: "",
                    unit: "m",
                    factor: 1.0,
                    exponents: [1, 0, 0, 0, 0, 0, 0],
                    default: None,
                }],
                reads: &[Some(described::Reads {
                    motion: described::Motion::Poses,
                    time: false,
                    states: &[],
                    inputs: &[],
                })],
            };
            const OBSERVED: &'static [(&'static str, &'static str)] = &State::<S>::OBSERVED;
            const DECLARATION: &'static str = "/// A block that is pushed back to the middle, a spring that does not pull, and a clock: conditions of the state and of the time.\npub Bouncer {\n    /// When the pulse ends.\n    param until: s = 0.7 s;\n    input push: N = 0 N;\n    ground { port o: (0, 0) m; }\n    body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 1 m; }\n    body clock { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }\n    prismatic rail(ground.o, block.o);\n    prismatic other(ground.o, clock.o);\n    force back(block.o) { x: if block.x < 0 m then 4 N else -2 N; }\n    force pulse(clock.o) { x: push + (if t < 0.3 s then 0 N else if t < until then 3 N else 0 N); }\n    force stop(clock.o) { x: if clock.x < 100 m then 0 N else -10 N/m*(clock.x - 100 m); }\n    require near: block.x < 10 m;\n    output block.x;\n}\n";
            const FILES: &'static [(&'static str, &'static str)] = &[];
            const SHAPES: &'static [described::Shape] = &[
                described::Shape {
                    part: 2,
                    look: "mark",
                    at: (Some(0), 0),
                    towards: None,
                    is_symbol: true,
                    points: 8,
                    first: 16,
                },
                described::Shape {
                    part: 3,
                    look: "mark",
                    at: (Some(1), 0),
                    towards: None,
                    is_symbol: true,
                    points: 8,
                    first: 32,
                },
                described::Shape {
                    part: 4,
                    look: "mark",
                    at: (Some(1), 0),
                    towards: None,
                    is_symbol: true,
                    points: 8,
                    first: 48,
                },
            ];

            fn figure(&self, t: S, index: usize) -> Option<S> {
                let constants: &[f64] = const {
                    &[
                        2.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
                        0.0, -3.0, -0.25, -1.3, -0.25, -1.3, -0.8, 0.0, 0.0, -1.3, 0.8, -1.3, 0.25, -3.0,
                        0.25, 0.0, 0.0, -3.0, -0.25, -1.3, -0.25, -1.3, -0.8, 0.0, 0.0, -1.3, 0.8, -1.3,
                        0.25, -3.0, 0.25, 0.0, 0.0, -3.0, -0.25, -1.3, -0.25, -1.3, -0.8, 0.0, 0.0, -1.3,
                        0.8, -1.3, 0.25, -3.0, 0.25,
                    ]
                };
                constants.get(index).copied().map(S::lit)
            }

            fn parameter(&self, index: usize) -> Option<S> {
                match index {
                    0 => Some(self.until),
                    _ => None,
                }
            }

            fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
                match index {
                    0 => Some(&mut self.until),
                    _ => None,
                }
            }

            fn poses(state: &State<S>, each: &mut impl FnMut(BodyState<S>)) {
                let (q, v) = state.pose_();
                for (q, v) in q.as_chunks::<3>().0.iter().zip(v.as_chunks::<3>().0) {
                    each(BodyState::of(*q, *v));
                }
            }

            fn observed(state: &State<S>, index: usize) -> Option<S> {
                (index < State::<S>::OBSERVED.len()).then(|| state.column_(index, &Common::<S>::new()))
            }

            fn observe(
                state: &State<S>,
                quantities: impl IntoIterator<Item = usize>,
                each: &mut impl FnMut(Option<S>),
            ) {
                let common = &Common::<S>::new();
                for index in quantities {
                    each((index < State::<S>::OBSERVED.len()).then(|| state.column_(index, common)));
                }
            }
        }

        impl<S: Scalar> rt::StartValues<S> for Starts<S> {
            fn each(&mut self, each: &mut impl FnMut(&'static str, &mut Start<S>)) {
                self.block.each(
                    ["block.x", "block.y", "block.angle", "block.vx", "block.vy", "block.omega"],
                    &mut *each,
                );
                self.clock.each(
                    ["clock.x", "clock.y", "clock.angle", "clock.vx", "clock.vy", "clock.omega"],
                    &mut *each,
                );
            }
        }

        impl<S: Scalar> core::fmt::Display for Starts<S> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                rt::start::write_starts(*self, f)
            }
        }

        impl<S: Real> Bouncer<S> {
            fn placed(&self, x: &[S; 12]) -> Starts<S> {
                let lit = S::lit;
                Starts {
                    block: self.start.block.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[0], x[1], x[2]],
                        [x[6], x[7], x[8]],
                    ),
                    clock: self.start.clock.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[3], x[4], x[5]],
                        [x[9], x[10], x[11]],
                    ),
                }
            }
        }

        impl<S: Real> State<S> {
            /// Poses, velocities and states of this moment as start values, with the locks that are set: to go on from here
            /// later, `mechanism.start = sim.starts()`.
            pub fn starts(&self) -> Starts<S> {
                self.mechanism.placed(&<Bouncer<S> as rt::Statics>::full(self))
            }
        }

        impl<S: Real> rt::Statics for Bouncer<S> {
            type Full = [S; 12];
            type Rows = [S; 4];
            type Starts = Starts<S>;
            const COORDINATES: &'static [&'static str] = Self::LAYOUT_.coordinates;
            const ROWS: &'static [&'static str] = Self::LAYOUT_.rows;
            const STATES: &'static [(&'static str, &'static str)] = &[];
            fn full(state: &State<S>) -> [S; 12] {
                state.absolute_()
            }

            /// What vanishes at rest: applied forces `Q` (N, N, N m per body) that reactions do not balance, residuals of the
            /// constraints, rates of the first-order states, without accelerations.
            ///
            /// 3 add, 1 mul, 8 select.
            #[cold]
            fn equations(&self, t: S, u: &Self::U, x: &[S; 12], lambda: &[S; 4], each: &mut impl FnMut(S)) {
                let (mut force, mut x_dot) = ([S::lit(0.0); 6], [S::lit(0.0); 0]);
                let [_, switch_1, switch_2, switch_3, ..] = u.switches;
                let [_, _, _, clock_x, ..] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                force[0] = S::select(switch_1.lt(lit(0.0)), lit(4.0), lit(-2.0));
                force[1] = lit(0.0);
                force[2] = lit(0.0);
                let push = u.input.push;
                let t1 = push
                    + S::select(clock_x.lt(lit(100.0)), lit(0.0), by(-10.0) * (clock_x - lit(100.0)))
                    + S::select(
                        switch_3.lt(lit(0.0)),
                        lit(0.0),
                        S::select(switch_2.lt(lit(0.0)), lit(3.0), lit(0.0)),
                    );
                force[3] = t1;
                force[4] = lit(0.0);
                force[5] = lit(0.0);
                let (q, _): ([S; 6], [S; 6]) = absolute::split(x);
                absolute::balance::<S, Self, NQ, NC>(self, t, &q, lambda, &force)
                    .into_iter()
                    .for_each(&mut *each);
                absolute::residuals::<S, Self, NQ, NC, 12>(self, t, x, each);
                x_dot.into_iter().for_each(each);
            }

            fn start_with_inputs(&self, t: S, held: &Self::U) -> Result<(Self::U, Self::X), Fault> {
                self.start_holding_(t, held.input)
            }

            fn unstarted(&self) -> Self::U {
                Self::holding_(self.declared_input())
            }

            fn starts_mut(&mut self) -> &mut Starts<S> {
                &mut self.start
            }

            fn starts_at(&self, x: &[S; 12]) -> Starts<S> {
                self.placed(x)
            }

            fn size(&self) -> S {
                absolute::Absolute::<S, NQ, NC>::length(self)
            }
        }

        impl<S: Scalar> Bouncer<S> {
            /// The right-hand side in joint coordinates.
            ///
            /// 3 add, 2 mul, 8 select.
            #[inline(always)]
            fn motion(&self, t: S, u: &Held<S>, x: &[S; 4], dx: &mut [S; 4]) {
                let [_, switch_1, switch_2, switch_3, ..] = u.switches;
                let [_, s_other, ..] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                // Masses and forces along the coordinates: M a = Q
                let push = u.input.push;
                let force_1 =
                    push + S::select(
                        switch_3.lt(lit(0.0)),
                        lit(0.0),
                        S::select(switch_2.lt(lit(0.0)), lit(3.0), lit(0.0)),
                    ) + S::select(s_other.lt(lit(100.0)), lit(0.0), by(-10.0).mul_add(s_other, lit(1000.0)));
                // Results
                dx[0] = x[2];
                dx[1] = x[3];
                dx[2] = by(0.5) * S::select(switch_1.lt(lit(0.0)), lit(4.0), lit(-2.0));
                dx[3] = force_1;
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            #[inline]
            fn pose(&self, t: S, u: &Held<S>, x: &[S; 4], q: &mut [S; 6], v: &mut [S; 6]) {
                let lit = S::lit;
                q[0] = x[0];
                q[1] = lit(0.0);
                q[2] = lit(0.0);
                q[3] = x[1];
                q[4] = lit(0.0);
                q[5] = lit(0.0);
                v[0] = x[2];
                v[1] = lit(0.0);
                v[2] = lit(0.0);
                v[3] = x[3];
                v[4] = lit(0.0);
                v[5] = lit(0.0);
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart(&self, t: S, q: &[S; 6], v: &[S; 6], x: &mut [S; 4]) {
                x[0] = q[0];
                x[1] = q[3];
                x[2] = v[0];
                x[3] = v[3];
            }

            /// How far every condition is from switching: positive while the side that is held applies; then what bends where it passes zero.
            ///
            /// 2 add, 2 mul.
            fn switching(&self, t: S, u: &Held<S>, x: &[S; 4], g: &mut [S; 3]) {
                let [switch_0, switch_1, ..] = u.switches;
                let [s_rail, s_other, ..] = *x;
                let lit = S::lit;
                g[0] = switch_0 * (lit(10.0) - s_rail);
                g[1] = switch_1 * s_rail;
                g[2] = s_other - lit(100.0);
            }
        }

        impl<S: Scalar> Bouncer<S> {
            /// The coefficients of the linearised equations before anything is eliminated; `dx` is the rate there.
            ///
            /// 1 neg, 2 select.
            fn linearised(&self, t: S, u: &Held<S>, x: &[S; 4], dx: &[S; 4], c: &mut [S; 3]) {
                let [_, s_other, ..] = *x;
                let lit = S::lit;
                // Derivatives of M a - Q and of the rates of the states
                // Results
                c[0] = lit(2.0);
                c[1] = -S::select(s_other.lt(lit(100.0)), lit(0.0), lit(-10.0));
                c[2] = lit(1.0);
            }
        }

        /// Places of the coefficients of the linearised equations, and the order of their elimination.
        #[doc(hidden)]
        #[derive(Clone, Copy, Debug)]
        pub struct Augmented<S>(core::marker::PhantomData<S>);

        impl<S: Real> rt::linalg::Patterned for Augmented<S> {
            const PATTERN: rt::linalg::Pattern = rt::linalg::Pattern {
                coordinates: 2,
                states: 0,
                terms: const {
                    &rt::compact::terms::<3>(&rt::compact::numbers::<15>(&[(
                        1,
                        &[0, 0, 0, 0, 4, 1, 1, 1, 1, 2, 2, 1, 1, 1, 4],
                        &[],
                    )]))
                },
                pivots: const {
                    &rt::compact::pivots::<2>(&rt::compact::numbers::<14>(&[(
                        1,
                        &[0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0],
                        &[],
                    )]))
                },
                below: const { &rt::compact::below::<0>(&rt::compact::numbers::<0>(&[])) },
                right: const { &rt::compact::pairs::<0>(&rt::compact::numbers::<0>(&[])) },
                targets: const { &rt::compact::numbers::<0>(&[]) },
            };
        }

        impl<S: Scalar> Bouncer<S> {
            /// Times at which conditions change, s, and the slope of what they compare.
            #[cold]
            fn instants(&self, u: &Held<S>, at: &mut [S; 2], slope: &mut [S; 2]) {
                let lit = S::lit;
                at[0] = self.until;
                at[1] = lit(0.3);
                slope[0] = lit(1.0);
                slope[1] = lit(1.0);
            }
        }
    }
}
