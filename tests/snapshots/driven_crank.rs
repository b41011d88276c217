#[doc(inline)]
#[allow(unreachable_pub)]
pub use plm_driven_crank_::driven_crank::DrivenCrank;

#[doc(inline)]
#[allow(unreachable_pub, unused_imports)]
pub use plm_driven_crank_::driven_crank;
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]
mod plm_driven_crank_ {
    /// A crank that turns as it is told, on a ground that shakes: nothing is left to integrate.
    ///
    /// 3 bodies, 5 parts: 9 coordinates, 9 constraint rows, F = 3 N - M = 0.
    /// Formulation 1: kinematics; no freedom is left, and the motion follows from the time alone.
    /// Chart 0: none; then explicit crank.angle; RRP rod.angle, guide.displacement.
    /// State: 0 numbers, 0 bytes in f64.
    /// A solution by rank, where one is needed: 1296 bytes of stack in f64.
    /// One right-hand side: 3 add, 6 mul, 2 sin_cos.
    ///
    /// | row | constraint | equation | unit |
    /// |----:|------------|----------|------|
    /// | 0 | `drive.x` | `crank.x - 0.1*cos(crank.angle) = 0` | m |
    /// | 1 | `drive.y` | `crank.y - 0.1*sin(crank.angle) - amplitude*sin(20*t) = 0` | m |
    /// | 2 | `crank_pin.x` | `rod.x - crank.x - 0.1*cos(crank.angle) - 0.3*cos(rod.angle) = 0` | m |
    /// | 3 | `crank_pin.y` | `rod.y - crank.y - 0.1*sin(crank.angle) - 0.3*sin(rod.angle) = 0` | m |
    /// | 4 | `wrist_pin.x` | `slider.x - rod.x - 0.3*cos(rod.angle) = 0` | m |
    /// | 5 | `wrist_pin.y` | `slider.y - rod.y - 0.3*sin(rod.angle) = 0` | m |
    /// | 6 | `guide.normal` | `-slider.y = 0` | m |
    /// | 7 | `guide.angle` | `-slider.angle = 0` | rad |
    /// | 8 | `turns` | `crank.angle - 3*t - pi/3 = 0` | rad |
    pub mod driven_crank {
        pub use super::code_::*;
        pub use super::type_::DrivenCrank;
    }

    mod type_ {
        /// A crank that turns as it is told, on a ground that shakes: nothing is left to integrate.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct DrivenCrank<S = ::core::primitive::f64> {
            /// Parameter `amplitude`, m; 0.01 m by default.
            pub amplitude: S,
            /// Start values of the bodies, and which of them assembly keeps.
            pub start: super::code_::Starts<S>,
        }
    }

    mod code_ {
        use super::type_::DrivenCrank;
        use ::plm::runtime::generated as rt;
        use ::plm::runtime::generated::lanes::Two;
        use ::plm::runtime::generated::{
            BodyStart, BodyState, Fault, Method, Operations, Real, Scalar, Sim, Start,
        };
        use ::plm::runtime::generated::{absolute, described};

        /// Start values, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Starts<S = f64> {
            /// Origin of body `crank`.
            pub crank: BodyStart<S>,
            /// Origin of body `rod`.
            pub rod: BodyStart<S>,
            /// Origin of body `slider`.
            pub slider: BodyStart<S>,
        }

        /// Result of assembly.
        pub type Assembly<S = f64> = rt::Assembly<S, NQ, NC>;

        /// Inputs, held over a step, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Input<S = f64> {
            #[doc(hidden)]
            pub none: core::marker::PhantomData<S>,
        }

        /// Discrete state: constant during a step.
        type Held<S> = rt::Held<
            Input<S>,
            [S; 0],
            [<S as Scalar>::Turns; 1],
            rt::charts::OfLoops<rt::charts::Continuation<S, 0, 2, 1, 0>, [S; 9]>,
        >;

        /// Pose, accelerations and a vector, which outputs have in common.
        type Common<S> = rt::Common<([S; 9], [S; 9]), Held<S>, ([S; 9], [S; 9]), [S; 2]>;

        /// The mechanism at one moment; its methods read poses and outputs, `input` has the inputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: DrivenCrank<S>,
            held: rt::Held<
                Input<S>,
                [S; 0],
                [i32; 1],
                rt::charts::OfLoops<rt::charts::Continuation<S, 0, 2, 1, 0>, [S; 9]>,
            >,
            time: S,
            x: [S; 0],
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
        pub const NQ: usize = 9;
        /// Constraint rows.
        pub const NC: usize = 9;
        /// First-order states.
        pub const NX: usize = 0;
        /// Degrees of freedom, `3 N - M`.
        pub const NDOF: isize = 0;
        /// Operations of one evaluation of the right-hand side.
        pub const OPERATIONS: Operations =
            Operations { add: 3, mul: 6, div: 0, sqrt: 0, sin_cos: 2, other: 0 };
        impl<S: Real> State<S> {
            /// Time, s.
            pub fn time(&self) -> S {
                self.time
            }

            /// Pose and velocity of G of body `crank`: m, m, rad; m/s, m/s, rad/s.
            pub fn crank(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[0], q[1], q[2]], [v[0], v[1], v[2]])
            }

            /// Pose and velocity of G of body `rod`: m, m, rad; m/s, m/s, rad/s.
            pub fn rod(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[3], q[4], rt::turns::whole(q[5], self.held.turns[0])], [v[3], v[4], v[5]])
            }

            /// Pose and velocity of G of body `slider`: m, m, rad; m/s, m/s, rad/s.
            pub fn slider(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[6], q[7], q[8]], [v[6], v[7], v[8]])
            }

            /// Output `drive.force`, N.
            ///
            /// What the joint does to `ground`, absolute axes; `crank` feels the opposite.
            pub fn drive_force(&self) -> [S; 2] {
                self.drive_force_among_(&Common::<S>::new())
            }

            #[inline]
            fn drive_force_among_(&self, common: &Common<S>) -> [S; 2] {
                let mut value = [S::lit(0.0); 2];
                let (_, lambda) = common.solved.get_or_init(|| self.solved_(common));
                value[0] = lambda[0];
                value[1] = lambda[1];
                value
            }

            /// Output `torque`, N*m.
            pub fn torque(&self) -> S {
                self.torque_among_(&Common::<S>::new())
            }

            #[inline]
            fn torque_among_(&self, common: &Common<S>) -> S {
                let (_, lambda) = common.solved.get_or_init(|| self.solved_(common));
                lambda[8]
            }

            /// Kinetic energy of all bodies, J.
            pub fn kinetic_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [
                    crank_vx,
                    crank_vy,
                    crank_omega,
                    rod_vx,
                    rod_vy,
                    rod_omega,
                    slider_vx,
                    slider_vy,
                    slider_omega,
                    ..,
                ] = *v;
                let by = rt::Factor;
                let t1 = by(0.0005).mul_add(
                    slider_omega.mul_add(slider_omega, crank_omega * crank_omega),
                    by(0.1).mul_add(
                        crank_vy.mul_add(crank_vy, crank_vx * crank_vx),
                        by(0.009) * rod_omega * rod_omega,
                    ),
                );
                let t2 = by(0.25).mul_add(
                    slider_vy.mul_add(slider_vy, slider_vx * slider_vx),
                    by(0.3).mul_add(rod_vy.mul_add(rod_vy, rod_vx * rod_vx), t1),
                );
                t2
            }

            /// Potential energy of gravity above the origin, J.
            pub fn gravity_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [_, crank_y, _, _, rod_y, _, _, slider_y, ..] = *q;
                let by = rt::Factor;
                by(4.905).mul_add(slider_y, by(5.886).mul_add(rod_y, by(1.962) * crank_y))
            }

            /// Power of all forces and torques but gravity and reactions, W.
            pub fn load_power(&self) -> S {
                let lit = S::lit;
                lit(0.0)
            }

            /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
            /// the second turns from the first, rad, positive to the left.
            pub fn branches(&self) -> [(&'static str, S); 1] {
                let mut value = [S::lit(0.0); 1];
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [crank_x, crank_y, crank_angle, rod_x, rod_y, rod_angle, ..] = *q;
                let by = rt::Factor;
                let ([sin_crank_angle, sin_rod_angle], [cos_crank_angle, cos_rod_angle]) =
                    S::sin_cos_all([crank_angle, rod_angle]);
                let t1 = by(-0.3).mul_add(sin_rod_angle, by(0.1).mul_add(sin_crank_angle, crank_y) - rod_y);
                let t2 = by(-0.3).mul_add(cos_rod_angle, by(0.1).mul_add(cos_crank_angle, crank_x) - rod_x);
                let t3 = (by(-0.2) * (-sin_crank_angle).mul_add(t2, cos_crank_angle * t1))
                    .atan2(by(-0.2) * sin_crank_angle.mul_add(t1, cos_crank_angle * t2));
                value[0] = t3;
                [("crank_pin", value[0])]
            }

            /// Names and units of the columns of [`State::outputs`].
            pub const OUTPUTS: [(&'static str, &'static str); 3] =
                [("drive.force.x", "N"), ("drive.force.y", "N"), ("torque", "N*m")];
            /// The declared outputs, in the units of [`State::OUTPUTS`].
            pub fn outputs(&self) -> [S; 3] {
                let common = &Common::<S>::new();
                let own_0 = self.drive_force_among_(common);
                let own_1 = self.torque_among_(common);
                [own_0[0], own_0[1], own_1]
            }

            /// Names and SI units of the outputs and of all that is observed.
            pub const OBSERVED: [(&'static str, &'static str); 3] =
                [("drive.force.x", "N"), ("drive.force.y", "N"), ("torque", "N*m")];

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
                        0 => common.vector(0, || state.drive_force_among_(common))[0],
                        1 => common.vector(0, || state.drive_force_among_(common))[1],
                        2 => state.torque_among_(common),
                        _ => S::lit(f64::NAN),
                    }
                }
                match column / 200 {
                    0 => block_0(self, column, common),
                    _ => S::lit(f64::NAN),
                }
            }
        }

        impl DrivenCrank<f64> {
            /// The mechanism as declared, in `f64`; `DrivenCrank { field: value, ..DrivenCrank::new() }` changes some.
            pub fn new() -> Self {
                Self::of()
            }
        }

        impl Default for DrivenCrank<f64> {
            fn default() -> Self {
                Self::of()
            }
        }

        impl<S: Scalar> DrivenCrank<S> {
            /// The mechanism as declared, for any scalar.
            pub fn of() -> Self {
                let lit = S::lit;
                let amplitude = lit(0.01);
                let start = Starts {
                    crank: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(1.0471975511965979)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    rod: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(-0.29670597283903605)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    slider: BodyStart {
                        x: Start::free(lit(0.67)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.0)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                };
                DrivenCrank { amplitude, start }
            }
        }

        impl<S: Real> DrivenCrank<S> {
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

        impl<S: Scalar> DrivenCrank<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> Input<S> {
                Input { none: core::marker::PhantomData }
            }
        }

        impl<S: Real> rt::charts::Charted for DrivenCrank<S> {
            type Input = Input<S>;
            type Switches = [S; 0];
            type Turns = [i32; 1];
            type Contact = ();
            type Continuation = rt::charts::Continuation<S, 0, 2, 1, 0>;
            type Q = [S; 9];
            const CHARTS: rt::charts::Charts = rt::charts::Charts {
                count: 1,
                revolutions: &[rt::charts::Revolutions { coordinates: &[&[]], angles: &[1], iterated: &[] }],
                is_loose: false,
                turning: &["crank", "rod"],
                found: &[&[1]],
                iterated: &[],
                closing: &[&["guide"]],
            };

            fn pose(&self, t: S, held: &Self::U, x: &[S; 0]) -> ([S; 9], [S; 9], S) {
                let (mut q, mut v) = ([S::lit(0.0); 9], [S::lit(0.0); 9]);
                let measure = match &held.of_loops {
                    rt::charts::OfLoops::InChart { continuation: m, .. } => {
                        self.pose_0(t, held, m, x, &mut q, &mut v)
                    }
                    rt::charts::OfLoops::Free { q: free_q, v: free_v } => {
                        (q, v) = (*free_q, *free_v);
                        S::lit(0.0)
                    }
                };
                (q, v, measure)
            }

            fn continuation(&self, t: S, held: &Self::U, x: &[S; 0]) -> (Self::Continuation, S) {
                self.remember_(t, held, x)
            }

            fn continuation_at(&self, chart: usize, t: S, q: &[S; 9], v: &[S; 9]) -> (Self::Continuation, S) {
                let mut memory: Self::Continuation = rt::charts::ContinuationData::nothing();
                let measure = self.remember_pose_0(t, q, v, &mut memory);
                (memory, measure)
            }

            fn to_chart(&self, chart: usize, t: S, q: &[S; 9], v: &[S; 9], x: &mut [S; 0]) {
                self.to_chart_0(t, q, v, x)
            }
        }

        impl<S: Scalar> DrivenCrank<S> {
            fn remember_(
                &self,
                t: S,
                held: &Held<S>,
                x: &[S; 0],
            ) -> (rt::charts::Continuation<S, 0, 2, 1, 0>, S) {
                let mut memory: rt::charts::Continuation<S, 0, 2, 1, 0> =
                    rt::charts::ContinuationData::nothing();
                let measure = match &held.of_loops {
                    rt::charts::OfLoops::InChart { continuation: m, .. } => {
                        self.remember_0(t, held, m, x, &mut memory)
                    }
                    rt::charts::OfLoops::Free { q: free_q, v: free_v } => S::lit(0.0),
                };
                (memory, measure)
            }
        }

        impl<S: Scalar> rt::Rate for DrivenCrank<S> {
            type S = S;
            type X = [S; 0];
            type U = Held<S>;
            const NQ: usize = 0;
            const SHORT: bool = !S::REGISTERS.are_filled();
            #[inline(always)]
            fn rate(&self, t: S, u: &Self::U, x: &[S; 0], dx: &mut [S; 0]) -> rt::Health<S> {
                rt::Health(match &u.of_loops {
                    rt::charts::OfLoops::InChart { continuation: m, .. } => self.motion_0(t, u, m, x, dx),
                    rt::charts::OfLoops::Free { q: free_q, v: free_v } => S::lit(0.0),
                })
            }

            #[inline]
            fn typical(&self) -> [S; 0] {
                [].map(S::lit)
            }
        }

        impl<S: Real> rt::Constraints for DrivenCrank<S> {
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

            #[cold]
            fn rate_by_rank(&self, t: S, u: &Self::U, x: &[S; 0], dx: &mut [S; 0]) -> Result<(), Fault> {
                if rt::Rate::rate(self, t, u, x, dx).is_good() {
                    Ok(())
                } else {
                    Err(rt::charts::not_regular(self, t, u, x))
                }
            }

            fn is_regular(&self, u: &Self::U) -> bool {
                !rt::charts::is_free::<Self>(u)
            }

            #[inline]
            fn is_settled(&self, t: S, u: &Self::U, x: &[S; 0]) -> bool {
                rt::charts::is_calm(self, t, u, x)
            }

            #[inline]
            fn update(&self, t: S, u: &mut Self::U, x: &mut [S; 0]) -> Result<rt::Updated, Fault> {
                rt::charts::update(self, t, u, x)
            }
        }

        impl<S: Real> rt::Switched for DrivenCrank<S> {
            type Guards = [S; 0];
            type Contact = rt::switched::NoContact;
            const SWITCHES: rt::Switches = rt::Switches::NONE;
        }

        impl<S: Real> rt::Labels for DrivenCrank<S> {
            fn labels(&self) -> &'static rt::LabelTable {
                const {
                    &rt::LabelTable {
                        parts: rt::PartNames::Numbers(const { &[] }),
                        states: const { &[] },
                        ..rt::LabelTable::NONE
                    }
                }
            }
        }

        #[doc(hidden)]
        impl<S: Real> rt::singular::ExtendedPrecision<9, 9, 18> for DrivenCrank<S> {
            type Extended = DrivenCrank<rt::DoubleDouble<S>>;
            type Inputs = Held<rt::DoubleDouble<S>>;
            type Coordinates = rt::singular::InCharts;

            fn extended(&self) -> Self::Extended {
                rt::lanes::Pack::pack(self, [self], |[s]: [S; 1]| rt::DoubleDouble::written(s))
            }

            fn extended_with_inputs(&self, held: &Self::U) -> (Self::Extended, Self::Inputs) {
                use rt::lanes::Pack;
                (self.extended(), Self::pack_held(held, [held], |[s]: [S; 1]| rt::DoubleDouble::of(s)))
            }

            #[cold]
            fn accelerate(
                extended: &Self::Extended,
                t: rt::DoubleDouble<S>,
                u: &Self::Inputs,
                x: &[rt::DoubleDouble<S>; 18],
                dx: &mut [rt::DoubleDouble<S>; 18],
            ) {
                let mut lambda = [rt::DoubleDouble::<S>::lit(0.0); 9];
                extended.dynamics(t, u, x, dx, &mut lambda);
            }
        }

        impl<S: Real> State<S> {
            /// Pose and velocity of every body.
            #[inline]
            fn pose_(&self) -> ([S; 9], [S; 9]) {
                rt::charts::pose(&self.mechanism, self.time, &self.held, &self.x)
            }

            /// Poses and velocities with all revolutions of the angles.
            fn unwrapped_pose_(&self) -> ([S; 9], [S; 9]) {
                let (mut q, v) = self.pose_();
                rt::turns::add(&self.held.turns, &mut q, &[&[5]]);
                (q, v)
            }
        }

        impl<S: Real> State<S> {
            /// The state in absolute coordinates.
            fn absolute_(&self) -> [S; 18] {
                self.joined_(&self.pose_())
            }

            /// The state in absolute coordinates, of pose and velocity.
            fn joined_(&self, (q, v): &([S; 9], [S; 9])) -> [S; 18] {
                let mut x = [S::lit(0.0); 18];
                absolute::join(q, v, &mut x);
                x
            }
        }

        impl<S: Real> rt::Moment for State<S> {
            type M = DrivenCrank<S>;

            fn new(mechanism: DrivenCrank<S>, held: Held<S>, time: S, x: [S; 0]) -> Self {
                State { mechanism, held, time, x }
            }

            fn mechanism(&self) -> &DrivenCrank<S> {
                &self.mechanism
            }

            fn held(&self) -> Held<S> {
                self.held
            }

            fn time(&self) -> S {
                self.time
            }

            fn x(&self) -> &[S; 0] {
                &self.x
            }

            fn set(&mut self, time: S, held: &Held<S>, x: &[S; 0]) {
                self.time = time;
                self.held = *held;
                self.x = *x;
            }

            fn in_place(&mut self) -> rt::InPlace<'_, DrivenCrank<S>> {
                let Self { mechanism, held, time, x } = self;
                rt::InPlace { system: mechanism, held, time, x }
            }
        }

        impl<S: Real> rt::Mechanism for DrivenCrank<S> {
            type State = State<S>;
            type Rescue = rt::singular::NearSingular<Self, 9, 9, 18>;
            const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();
            fn start_state(&self, t: S) -> Result<(Held<S>, [S; 0]), Fault> {
                self.start_holding_(t, self.declared_input())
            }

            fn check(&self, t: S) -> Result<(), Fault> {
                rt::limits::check_numbers(t, [("amplitude", "m", self.amplitude)])?;
                Ok(())
            }

            fn fingerprint(&self) -> u64 {
                rt::limits::fingerprint([self.amplitude])
            }

            fn renew(&self, t: S, held: &mut Held<S>, x: &mut [S; 0]) -> Result<(), Fault> {
                let (mut q, mut v): ([S; 9], [S; 9]) =
                    <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::renew::<S, Self, NQ, NC>(self, t, &mut q, &mut v)?;
                rt::charts::enter(self, t, held, (&q, &v), x);
                Ok(())
            }

            fn opening(&self, t: S, held: &Held<S>, x: &[S; 0]) -> rt::Drift<S> {
                let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
            }
        }

        impl<S: Real> DrivenCrank<S> {
            fn holding_(input: Input<S>) -> Held<S> {
                rt::Held {
                    input,
                    switches: [S::lit(1.0); 0],
                    turns: [0; 1],
                    of_loops: rt::charts::OfLoops::InChart {
                        chart: 0,
                        continuation: rt::charts::ContinuationData::nothing(),
                    },
                    contact: (),
                }
            }

            fn start_holding_(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; 0]), Fault> {
                rt::Mechanism::check(self, t)?;
                let assembly = absolute::assemble(self, t)?;
                let mut x = [S::lit(0.0); 0];
                if assembly.redundant.contains(&true) {
                    let joints = rt::Names::marked(Self::LAYOUT_.parts, &assembly.redundant);
                    return Err(Fault::new(rt::Scalar::to_f64(t), rt::Cause::Repeats { joints }));
                }
                let mut held = Self::holding_(input);
                rt::charts::enter(self, t, &mut held, (&assembly.q, &assembly.v), &mut x);
                Ok((held, x))
            }
        }

        impl<S: Scalar> DrivenCrank<S> {
            const LAYOUT_: absolute::Layout = absolute::Layout {
                rows: const {
                    &[
                        "drive.x",
                        "drive.y",
                        "crank_pin.x",
                        "crank_pin.y",
                        "wrist_pin.x",
                        "wrist_pin.y",
                        "guide.normal",
                        "guide.angle",
                        "turns",
                    ]
                },
                parts: const {
                    &[
                        "drive",
                        "drive",
                        "crank_pin",
                        "crank_pin",
                        "wrist_pin",
                        "wrist_pin",
                        "guide",
                        "guide",
                        "turns",
                    ]
                },
                coordinates: const {
                    &[
                        "crank.x",
                        "crank.y",
                        "crank.angle",
                        "rod.x",
                        "rod.y",
                        "rod.angle",
                        "slider.x",
                        "slider.y",
                        "slider.angle",
                    ]
                },
                angular: &[false, false, false, false, false, false, false, true, true],
                given_angles: &[true, true, false],
            };
            /// The derivatives of phi by q: the entries that are not zero, row by row.
            ///
            /// 4 mul, 2 sin_cos.
            #[cold]
            fn phi_q_entries(&self, t: S, q: &[S; 9], phi_q: &mut [S; 21]) {
                let [_, _, crank_angle, _, _, rod_angle, ..] = *q;
                let lit = S::lit;
                let by = rt::Factor;
                phi_q[0] = lit(1.0);
                let ([sin_crank_angle, sin_rod_angle], [cos_crank_angle, cos_rod_angle]) =
                    S::sin_cos_all([crank_angle, rod_angle]);
                let t1 = by(0.1) * sin_crank_angle;
                phi_q[1] = t1;
                phi_q[2] = lit(1.0);
                let t2 = by(-0.1) * cos_crank_angle;
                phi_q[3] = t2;
                phi_q[4] = lit(-1.0);
                phi_q[5] = t1;
                phi_q[6] = lit(1.0);
                let t3 = by(0.3) * sin_rod_angle;
                phi_q[7] = t3;
                phi_q[8] = lit(-1.0);
                phi_q[9] = t2;
                phi_q[10] = lit(1.0);
                let t4 = by(-0.3) * cos_rod_angle;
                phi_q[11] = t4;
                phi_q[12] = lit(-1.0);
                phi_q[13] = t3;
                phi_q[14] = lit(1.0);
                phi_q[15] = lit(-1.0);
                phi_q[16] = t4;
                phi_q[17] = lit(1.0);
                phi_q[18] = lit(-1.0);
                phi_q[19] = lit(-1.0);
                phi_q[20] = lit(1.0);
            }
        }

        #[doc(hidden)]
        impl<S: Real> absolute::Absolute<S, NQ, NC> for DrivenCrank<S> {
            fn layout(&self) -> &'static absolute::Layout {
                const { &Self::LAYOUT_ }
            }

            /// Residuals of the constraints, m or rad; the rows stand in the table of this module.
            ///
            /// 15 add, 7 mul, 2 neg, 3 sin_cos.
            fn phi(&self, t: S, q: &[S; 9]) -> [S; 9] {
                let mut phi = [S::lit(0.0); 9];
                let [
                    crank_x,
                    crank_y,
                    crank_angle,
                    rod_x,
                    rod_y,
                    rod_angle,
                    slider_x,
                    slider_y,
                    slider_angle,
                    ..,
                ] = *q;
                let lit = S::lit;
                let by = rt::Factor;
                let ([sin_crank_angle, sin_rod_angle], [cos_crank_angle, cos_rod_angle]) =
                    S::sin_cos_all([crank_angle, rod_angle]);
                let t1 = by(0.1) * cos_crank_angle;
                phi[0] = crank_x - t1;
                let amplitude = self.amplitude;
                let t2 = by(0.1) * sin_crank_angle;
                phi[1] = (-amplitude).mul_add((by(20.0) * t).sin(), crank_y - t2);
                let t3 = by(0.3) * cos_rod_angle;
                phi[2] = rod_x - crank_x - t1 - t3;
                let t4 = by(0.3) * sin_rod_angle;
                phi[3] = rod_y - crank_y - t2 - t4;
                phi[4] = slider_x - rod_x - t3;
                phi[5] = slider_y - rod_y - t4;
                phi[6] = -slider_y;
                phi[7] = -slider_angle;
                phi[8] = by(-3.0).mul_add(t, crank_angle) - lit(1.0471975511965979);
                phi
            }

            /// Their rates, `phi_q v - nu`, m/s or rad/s.
            ///
            /// 14 add, 11 mul, 2 neg, 3 sin_cos.
            fn phi_dot(&self, t: S, q: &[S; 9], v: &[S; 9]) -> [S; 9] {
                let mut phi_dot = [S::lit(0.0); 9];
                let [_, _, crank_angle, _, _, rod_angle, ..] = *q;
                let [
                    crank_vx,
                    crank_vy,
                    crank_omega,
                    rod_vx,
                    rod_vy,
                    rod_omega,
                    slider_vx,
                    slider_vy,
                    slider_omega,
                    ..,
                ] = *v;
                let lit = S::lit;
                let by = rt::Factor;
                let ([sin_crank_angle, sin_rod_angle], [cos_crank_angle, cos_rod_angle]) =
                    S::sin_cos_all([crank_angle, rod_angle]);
                let t1 = by(0.1) * (crank_omega * sin_crank_angle);
                phi_dot[0] = crank_vx + t1;
                let amplitude = self.amplitude;
                let t2 = by(0.1) * (crank_omega * cos_crank_angle);
                phi_dot[1] = (-(by(20.0) * amplitude)).mul_add((by(20.0) * t).cos(), crank_vy - t2);
                let t3 = by(0.3) * (rod_omega * sin_rod_angle);
                phi_dot[2] = rod_vx - crank_vx + t1 + t3;
                let t4 = by(0.3) * (rod_omega * cos_rod_angle);
                phi_dot[3] = rod_vy - crank_vy - t2 - t4;
                phi_dot[4] = slider_vx - rod_vx + t3;
                phi_dot[5] = slider_vy - rod_vy - t4;
                phi_dot[6] = -slider_vy;
                phi_dot[7] = -slider_omega;
                phi_dot[8] = crank_omega - lit(3.0);
                phi_dot
            }

            fn phi_q(&self, t: S, q: &[S; 9], each: &mut impl FnMut(usize, usize, S)) {
                let places: &[[u32; 2]] = const {
                    &rt::compact::pairs::<21>(&rt::compact::numbers::<42>(&[(
                        1,
                        &[
                            0, 0, 0, 2, 1, 1, 1, 2, 2, 0, 2, 2, 2, 3, 2, 5, 3, 1, 3, 2, 3, 4, 3, 5, 4, 3, 4,
                            5, 4, 6, 5, 4, 5, 5, 5, 7, 6, 7, 7, 8, 8, 2,
                        ],
                        &[],
                    )]))
                };
                let mut entries = [S::lit(0.0); 21];
                self.phi_q_entries(t, q, &mut entries);
                for (&[row, column], entry) in places.iter().zip(entries) {
                    each(row as usize, column as usize, entry);
                }
            }

            /// The shortest step in the norm of `W^-1` that closes `r`: `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 85 add, 124 mul, 10 div, 4 neg, 2 sin_cos, 24 select.
            fn min_norm(&self, t: S, q: &[S; 9], w: &[S; 9], r: &[S; 9], dq: &mut [S; 9]) -> rt::Health<S> {
                rt::Health({
                    let lit = S::lit;
                    let by = rt::Factor;
                    // phi_q W phi_q^T = L D L^T
                    let w_8 = w[8];
                    let w_7 = w[7];
                    let r_6 = by(1.0) / w_7;
                    let l_5_6 = -(w_7 * r_6);
                    let w_6 = w[6];
                    let w_3 = w[3];
                    let rod_angle = q[5];
                    let (sin_rod_angle, cos_rod_angle) = rod_angle.sin_cos();
                    let w_5 = w[5];
                    let y_2_5 = by(0.3) * sin_rod_angle * w_5;
                    let t1 = by(0.3) * (sin_rod_angle * y_2_5);
                    let t2 = w_3 + t1;
                    let r_4 = by(1.0) / (w_6 + t2);
                    let g_2_4 = t1 - w_3;
                    let l_2_4 = g_2_4 * r_4;
                    let t3 = by(-0.3) * cos_rod_angle;
                    let g_3_4 = t3 * y_2_5;
                    let l_3_4 = g_3_4 * r_4;
                    let y_3_5 = t3 * w_5;
                    let g_5_4 = by(0.3) * (sin_rod_angle * y_3_5);
                    let l_5_4 = g_5_4 * r_4;
                    let w_4 = w[4];
                    let t4 = cos_rod_angle * y_3_5;
                    let t5 = by(-0.3).mul_add(t4, w_4);
                    let t6 = w_7 + t5;
                    let r_5 = by(1.0) / (-g_5_4).mul_add(l_5_4, w_7.mul_add(l_5_6, t6));
                    let growth_5 = (t6 * r_5).abs();
                    let most_growth = lit(S::MOST_GROWTH);
                    let t7 = most_growth.lt(growth_5);
                    let kept_5 = S::select(t7, lit(0.0), r_5);
                    let g_2_5 = (-g_2_4).mul_add(l_5_4, g_5_4);
                    let l_2_5 = kept_5 * g_2_5;
                    let g_3_5 = (-g_3_4).mul_add(l_5_4, by(-0.3).mul_add(t4, -w_4));
                    let l_3_5 = kept_5 * g_3_5;
                    let w_0 = w[0];
                    let crank_angle = q[2];
                    let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                    let w_2 = w[2];
                    let y_0_2 = by(0.1) * (sin_crank_angle * w_2);
                    let t8 = by(0.1) * (sin_crank_angle * y_0_2);
                    let d_0 = w_0 + t8;
                    let r_0 = by(1.0) / d_0;
                    let t9 = cos_crank_angle * w_2;
                    let y_1_2 = by(-0.1) * t9;
                    let g_1_0 = by(0.1) * (sin_crank_angle * y_1_2);
                    let l_1_0 = r_0 * g_1_0;
                    let g_2_0 = t8 - w_0;
                    let l_2_0 = r_0 * g_2_0;
                    let l_8_0 = y_0_2 * r_0;
                    let w_1 = w[1];
                    let t10 = cos_crank_angle * y_1_2;
                    let t11 = by(-0.1).mul_add(t10, w_1);
                    let t12 = g_1_0 * l_1_0;
                    let d_1 = t11 - t12;
                    let r_1 = by(1.0) / d_1;
                    let growth_1 = (t11 * r_1).abs();
                    let t13 = most_growth.lt(growth_1);
                    let kept_1 = S::select(t13, lit(0.0), r_1);
                    let g_2_1 = (-g_1_0).mul_add(l_2_0, by(-0.1) * cos_crank_angle * y_0_2);
                    let l_2_1 = g_2_1 * kept_1;
                    let g_3_1 = by(-0.1).mul_add(t10, -w_1) - t12;
                    let l_3_1 = g_3_1 * kept_1;
                    let t14 = g_1_0.mul_add(l_8_0, by(0.1) * t9);
                    let g_8_1 = -t14;
                    let l_8_1 = g_8_1 * kept_1;
                    let t15 = d_0 + t2;
                    let d_2 = (-g_2_1).mul_add(
                        l_2_1,
                        (-g_2_5).mul_add(l_2_5, (-g_2_4).mul_add(l_2_4, (-g_2_0).mul_add(l_2_0, t15))),
                    );
                    let r_2 = by(1.0) / d_2;
                    let growth_2 = (t15 * r_2).abs();
                    let t16 = most_growth.lt(growth_2);
                    let kept_2 = S::select(t16, lit(0.0), r_2);
                    let g_3_2 = (-g_2_1).mul_add(
                        l_3_1,
                        (-g_2_5)
                            .mul_add(l_3_5, (-g_2_4).mul_add(l_3_4, (-l_1_0).mul_add(g_2_0, g_1_0 + g_5_4))),
                    );
                    let l_3_2 = kept_2 * g_3_2;
                    let g_8_2 = (-g_2_1).mul_add(l_8_1, (-g_2_0).mul_add(l_8_0, y_0_2));
                    let l_8_2 = kept_2 * g_8_2;
                    let d_3 = (-g_3_2).mul_add(
                        l_3_2,
                        (-g_3_1).mul_add(l_3_1, (-g_3_5).mul_add(l_3_5, (-g_3_4).mul_add(l_3_4, t5 + d_1))),
                    );
                    let r_3 = by(1.0) / d_3;
                    let growth_3 = (r_3 * (t11 + t5)).abs();
                    let t17 = most_growth.lt(growth_3);
                    let kept_3 = S::select(t17, lit(0.0), r_3);
                    let g_8_3 = -g_3_2.mul_add(l_8_2, g_3_1.mul_add(l_8_1, t14));
                    let l_8_3 = kept_3 * g_8_3;
                    let d_8 = (-g_8_3).mul_add(
                        l_8_3,
                        (-g_8_2).mul_add(l_8_2, (-g_8_1).mul_add(l_8_1, (-y_0_2).mul_add(l_8_0, w_2))),
                    );
                    let r_8 = by(1.0) / d_8;
                    let growth_8 = (w_2 * r_8).abs();
                    let t18 = most_growth.lt(growth_8);
                    // (phi_q W phi_q^T) mu = r
                    let dphi_7 = r[7];
                    let dphi_6 = r[6];
                    let dphi_4 = r[4];
                    let dphi_5 = r[5];
                    let b_5 = (-dphi_4).mul_add(l_5_4, (-dphi_6).mul_add(l_5_6, dphi_5));
                    let dphi_0 = r[0];
                    let dphi_1 = r[1];
                    let t19 = dphi_0 * l_1_0;
                    let b_1 = dphi_1 - t19;
                    let dphi_2 = r[2];
                    let b_2 = (-b_1).mul_add(
                        l_2_1,
                        (-l_2_5).mul_add(b_5, (-dphi_4).mul_add(l_2_4, (-dphi_0).mul_add(l_2_0, dphi_2))),
                    );
                    let dphi_3 = r[3];
                    let b_3 = (-l_3_2).mul_add(
                        b_2,
                        (-b_1).mul_add(l_3_1, (-l_3_5).mul_add(b_5, (-dphi_4).mul_add(l_3_4, dphi_3 - t19))),
                    );
                    let dphi_8 = r[8];
                    let b_8 = (-l_8_3).mul_add(
                        b_3,
                        (-l_8_2).mul_add(b_2, (-b_1).mul_add(l_8_1, (-dphi_0).mul_add(l_8_0, dphi_8))),
                    );
                    let mu_8 = S::select(t18, lit(0.0), r_8) * b_8;
                    let mu_3 = (-l_8_3).mul_add(mu_8, kept_3 * b_3);
                    let mu_2 = (-l_8_2).mul_add(mu_8, (-l_3_2).mul_add(mu_3, kept_2 * b_2));
                    let mu_1 =
                        (-l_8_1).mul_add(mu_8, (-l_3_1).mul_add(mu_3, (-l_2_1).mul_add(mu_2, b_1 * kept_1)));
                    let t20 = mu_3 + mu_1;
                    let mu_0 =
                        (-l_1_0).mul_add(t20, (-l_8_0).mul_add(mu_8, (-l_2_0).mul_add(mu_2, dphi_0 * r_0)));
                    let mu_5 = (-l_3_5).mul_add(mu_3, (-l_2_5).mul_add(mu_2, kept_5 * b_5));
                    let mu_4 =
                        (-l_5_4).mul_add(mu_5, (-l_3_4).mul_add(mu_3, (-l_2_4).mul_add(mu_2, dphi_4 * r_4)));
                    // Results
                    dq[0] = w_0 * (mu_0 - mu_2);
                    dq[1] = w_1 * (mu_1 - mu_3);
                    dq[2] = y_1_2.mul_add(t20, y_0_2.mul_add(mu_2 + mu_0, w_2 * mu_8));
                    dq[3] = w_3 * (mu_2 - mu_4);
                    dq[4] = w_4 * (mu_3 - mu_5);
                    dq[5] = y_3_5.mul_add(mu_3 + mu_5, y_2_5 * (mu_2 + mu_4));
                    dq[6] = w_6 * mu_4;
                    dq[7] = w_7 * (mu_5 - (-l_5_6).mul_add(mu_5, dphi_6 * r_6));
                    dq[8] = -(w_8 * (dphi_7 * (by(1.0) / w_8)));
                    let t21 = S::select(t7, lit(0.0), growth_5)
                        .max(S::select(t13, lit(0.0), growth_1))
                        .max(S::select(t16, lit(0.0), growth_2));
                    by(1.0)
                        / t21.max(S::select(t17, lit(0.0), growth_3)).max(S::select(t18, lit(0.0), growth_8))
                })
            }

            /// Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body.
            fn inverse_mass(&self) -> [S; 9] {
                let mut inverse_mass = [S::lit(0.0); 9];
                let lit = S::lit;
                inverse_mass[0] = lit(5.0);
                inverse_mass[1] = lit(5.0);
                inverse_mass[2] = lit(1000.0);
                inverse_mass[3] = lit(1.6666666666666667);
                inverse_mass[4] = lit(1.6666666666666667);
                inverse_mass[5] = lit(55.55555555555556);
                inverse_mass[6] = lit(2.0);
                inverse_mass[7] = lit(2.0);
                inverse_mass[8] = lit(1000.0);
                inverse_mass
            }

            fn length(&self) -> S {
                S::lit(0.3)
            }

            fn start_position(&self) -> [Start<S>; 9] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 3] = [
                    self.start.crank.of_centre([lit(0.0), lit(0.0)]),
                    self.start.rod.of_centre([lit(0.0), lit(0.0)]),
                    self.start.slider.of_centre([lit(0.0), lit(0.0)]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn start_velocity(&self, q: &[S; 9]) -> [Start<S>; 9] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 3] = [
                    self.start.crank.velocity_of_centre([lit(0.0), lit(0.0)], q[2]),
                    self.start.rod.velocity_of_centre([lit(0.0), lit(0.0)], q[5]),
                    self.start.slider.velocity_of_centre([lit(0.0), lit(0.0)], q[8]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn refine(&self, t: S, q: &[S; 9]) -> Option<([S; 9], [S; 9])> {
                rt::singular::refine::<Self, 9, 9, 18>(self, t, q)
            }
        }

        impl<S: Real> DrivenCrank<S> {
            /// Accelerations and multipliers by a rank-revealing decomposition.
            #[cold]
            fn accelerate(
                &self,
                t: S,
                u: &Held<S>,
                x: &[S; 18],
            ) -> Result<absolute::Acceleration<S, NQ, NC>, Fault> {
                let (q, _): ([S; 9], [S; 9]) = absolute::split(x);
                let (mut force, mut gamma) = ([S::lit(0.0); 9], [S::lit(0.0); 9]);
                self.free(t, u, x, &mut force, &mut gamma);
                let inverse_mass = absolute::Absolute::<S, NQ, NC>::inverse_mass(self);
                absolute::accelerate(t, &inverse_mass, &force, &gamma, |rows| {
                    absolute::phi_q_matrix(self, t, &q, rows)
                })
            }
        }

        impl<S: Real> State<S> {
            /// Accelerations and multipliers; multipliers that redundancy leaves undetermined have their minimum norm.
            fn solved_(&self, common: &Common<S>) -> ([S; 9], [S; 9]) {
                let (mut dx, mut lambda) = ([S::lit(0.0); 18], [S::lit(0.0); 9]);
                let (u, x) = (&self.held, self.joined_(common.pose.get_or_init(|| self.pose_())));
                let health = self.mechanism.dynamics(self.time, u, &x, &mut dx, &mut lambda);
                if !rt::Health(health).is_good() {
                    if let Ok(solution) = self.mechanism.accelerate(self.time, u, &x) {
                        return (solution.a, solution.lambda);
                    }
                }
                let (_, a): ([S; 9], [S; 9]) = absolute::split(&dx);
                (a, lambda)
            }

            /// Reactions that redundancy leaves undetermined, by constraint row; they are given with minimum norm.
            pub fn undetermined(&self) -> [bool; 9] {
                match self.mechanism.accelerate(self.time, &self.held, &self.absolute_()) {
                    Ok(solution) => solution.undetermined,
                    Err(_) => [true; 9],
                }
            }
        }

        impl<S: Real> rt::lanes::Pack for DrivenCrank<S> {
            type Packed<T: Scalar> = DrivenCrank<T>;

            #[allow(unused_variables)]
            fn pack<T: Scalar, const N: usize>(
                &self,
                all: [&Self; N],
                number: impl Fn([S; N]) -> T,
            ) -> DrivenCrank<T> {
                let same = |s| number([s; N]);
                let start = Starts {
                    crank: self.start.crank.map(same),
                    rod: self.start.rod.map(same),
                    slider: self.start.slider.map(same),
                };
                DrivenCrank { start, amplitude: number(rt::Vector::from_fn(|i| all[i].amplitude)) }
            }

            #[allow(unused_variables)]
            fn pack_held<T: Scalar, const N: usize>(
                first: &Held<S>,
                all: [&Held<S>; N],
                number: impl Fn([S; N]) -> T,
            ) -> Held<T> {
                let input = Input { none: core::marker::PhantomData };
                let switches = [];
                let mut of_loops = [&first.of_loops; N];
                for i in 0..N {
                    of_loops[i] = &all[i].of_loops;
                }
                let of_loops = rt::held::Loops::<S>::packed(&first.of_loops, of_loops, &number);
                let mut turns = [T::ZERO.to_turns(); 1];
                for k in 0..1 {
                    turns[k] = number(rt::Vector::from_fn(|i| S::of_turns(all[i].turns[k]))).to_turns();
                }
                let contact = ();
                rt::Held { input, switches, turns, of_loops, contact }
            }

            const WATCHED: bool = false;
            #[inline]
            fn are_calm<T: Scalar>(typical: &[T; 0], t: T, held: &Held<T>, x: &[T; 0]) -> T {
                rt::charts::are_calm::<Self, T, _>(typical, t, &held.of_loops, x)
            }

            #[inline]
            fn are_short<T: Scalar>(typical: &[T; 0], held: &Held<T>, legs: [&[T; 0]; 2]) -> T {
                rt::charts::are_short::<Self, T, _>(typical, &held.of_loops, legs)
            }

            #[inline(never)]
            fn look<T: Scalar>(all: &DrivenCrank<T>, t: T, held: &mut Held<T>, x: &[T; 0], due: T) -> T {
                let (memory, measure) = all.remember_(t, held, x);
                rt::charts::look::<Self, T, _>(&mut held.of_loops, x, (&memory, measure), due)
            }

            #[inline]
            fn put_held<T: Scalar>(wide: &mut Held<T>, one: &Held<S>, put: impl Fn(&mut T, S)) {
                rt::held::Loops::<S>::put(&mut wide.of_loops, &one.of_loops, &put);
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

        impl<S: Real> rt::Linear for DrivenCrank<S> {
            type Lifted<const K: usize> = DrivenCrank<rt::Dual<S, K>>;
            type In<T: Real> = DrivenCrank<T>;
            type Derivatives = [[S; 0]; 0];

            fn lift<const K: usize>(
                &self,
                held: &Held<S>,
            ) -> (DrivenCrank<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                self.in_numbers(held, rt::Dual::constant)
            }

            fn in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (DrivenCrank<T>, Held<T>) {
                use rt::lanes::Pack;
                let of_one = |[s]: [S; 1]| number(s);
                (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
            }

            #[inline]
            fn rate_in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (DrivenCrank<T>, Held<T>) {
                let value = Start::free(T::ZERO);
                let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
                let start = Starts { crank: zero, rod: zero, slider: zero };
                let own = DrivenCrank { start, amplitude: number(self.amplitude) };
                let same = |[s]: [S; 1]| S::of_plain(s.plain());
                let of_loops = rt::held::Loops::<S>::packed(&held.of_loops, [&held.of_loops], &same);
                let held = &rt::Held { of_loops, ..*held };
                (own, <Self as rt::lanes::Pack>::pack_held(held, [held], |[s]: [S; 1]| number(s)))
            }
        }

        impl<S: Real> rt::Ports for DrivenCrank<S> {
            type Input = Input<S>;
            const INPUTS: &'static [(&'static str, &'static str)] = &[];
            const OUTPUTS: &'static [(&'static str, &'static str)] = &State::<S>::OUTPUTS;
            fn inputs(held: &mut Held<S>) -> &mut Input<S> {
                &mut held.input
            }

            fn input(input: &mut Input<S>, index: usize) -> Option<&mut S> {
                match index {
                    _ => None,
                }
            }

            fn outputs(state: &State<S>, each: &mut impl FnMut(S)) {
                for output in state.outputs() {
                    each(output);
                }
            }
        }

        impl<S: Real> rt::Described for DrivenCrank<S> {
            const TABLES: &'static described::Tables = &described::Tables {
                name: "DrivenCrank",
                docs: "A crank that turns as it is told, on a ground that shakes: nothing is left to integrate.",
                report: described::Report {
                    rung: 1,
                    formulation: "kinematics",
                    reason: "no freedom is left, and the motion follows from the time alone",
                    operations: OPERATIONS,
                    degrees_of_freedom: NDOF,
                },
                bodies: &[
                    described::Body { name: "crank", ports: &["o", "pin"], contour: 0, first: 0 },
                    described::Body { name: "rod", ports: &["pin", "wrist"], contour: 0, first: 9 },
                    described::Body { name: "slider", ports: &["wrist"], contour: 0, first: 18 },
                ],
                ground: &[
                    described::GroundPort { name: "o", moves: true, first: 24 },
                    described::GroundPort { name: "rail", moves: false, first: 28 },
                ],
                parts: &[
                    described::Part {
                        name: "drive",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 0 },
                            described::Frame { argument: "b", body: Some(0), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 32,
                    },
                    described::Part {
                        name: "crank_pin",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(0), port: 1 },
                            described::Frame { argument: "b", body: Some(1), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 33,
                    },
                    described::Part {
                        name: "wrist_pin",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(1), port: 1 },
                            described::Frame { argument: "b", body: Some(2), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 34,
                    },
                    described::Part {
                        name: "guide",
                        kind: "prismatic",
                        pair: Some("prismatic"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 1 },
                            described::Frame { argument: "b", body: Some(2), port: 0 },
                        ],
                        sizes: &[],
                        first: 35,
                    },
                ],
                parameters: &[described::Quantity {
                    name: "amplitude",
                    docs: "",
                    unit: "m",
                    factor: 1.0,
                    exponents: [1, 0, 0, 0, 0, 0, 0],
                    default: Some(0.01),
                }],
                inputs: &[],
                states: &[],
                outputs: &[
                    described::Quantity {
                        name: "drive.force.x",
                        docs: "What the joint does to `ground`, absolute axes; `crank` feels the opposite.",
                        unit: "N",
                        factor: 1.0,
                        exponents: [1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                    described::Quantity {
                        name: "drive.force.y",
                        docs: "What the joint does to `ground`, absolute axes; `crank` feels the opposite.",
                        unit: "N",
                        factor: 1.0,
                        exponents: [1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                    described::Quantity {
                        name: "torque",
                        docs: "",
                        unit: "N*m",
                        factor: 1.0,
                        exponents: [2, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                ],
                reads: &[None, None, None],
            };
            const OBSERVED: &'static [(&'static str, &'static str)] = &State::<S>::OBSERVED;
            const DECLARATION: &'static str = "/// A crank that turns as it is told, on a ground that shakes: nothing is left to integrate.\npub DrivenCrank {\n    param amplitude: m = 10 mm;\n    gravity: 9.81 m/s^2;\n    ground { port o: (0, amplitude*sin(20 rad/s*t)); port rail: (0, 0) m; }\n    body crank { mass: 0.2 kg; inertia: 0.001 kg*m^2; port o: (-0.1, 0) m; port pin: (0.1, 0) m; start angle: 60 deg; }\n    body rod { mass: 0.6 kg; inertia: 0.018 kg*m^2; port pin: (-0.3, 0) m; port wrist: (0.3, 0) m; start angle: -17 deg; }\n    body slider { mass: 0.5 kg; inertia: 0.001 kg*m^2; port wrist: (0, 0) m; start x: 0.67 m; }\n    revolute drive(ground.o, crank.o);\n    revolute crank_pin(crank.pin, rod.pin);\n    revolute wrist_pin(rod.wrist, slider.wrist);\n    prismatic guide(ground.rail, slider.wrist);\n    constraint turns: crank.angle = 60 deg + 3 rad/s*t;\n    output drive.force, torque = reaction(turns);\n}\n";
            const FILES: &'static [(&'static str, &'static str)] = &[];
            fn figure(&self, t: S, index: usize) -> Option<S> {
                let constants: &[f64] = const {
                    &[
                        0.2,
                        0.001,
                        0.0,
                        -0.1,
                        0.0,
                        0.0,
                        0.1,
                        0.0,
                        0.0,
                        0.6,
                        0.018,
                        0.0,
                        -0.3,
                        0.0,
                        0.0,
                        0.3,
                        0.0,
                        0.0,
                        0.5,
                        0.001,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        f64::NAN,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                    ]
                };

                fn block_0<S: Real>(mechanism: &DrivenCrank<S>, t: S, index: usize) -> Option<S> {
                    let lit = S::lit;
                    Some(match index {
                        25 => {
                            let amplitude = mechanism.amplitude;
                            amplitude * (lit(20.0) * t).sin()
                        }
                        _ => return None,
                    })
                }
                if let Some(varying) = block_0(self, t, index) {
                    return Some(varying);
                }
                constants.get(index).copied().map(S::lit)
            }

            fn parameter(&self, index: usize) -> Option<S> {
                match index {
                    0 => Some(self.amplitude),
                    _ => None,
                }
            }

            fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
                match index {
                    0 => Some(&mut self.amplitude),
                    _ => None,
                }
            }

            fn poses(state: &State<S>, each: &mut impl FnMut(BodyState<S>)) {
                let (q, v) = state.unwrapped_pose_();
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
                self.crank.each(
                    ["crank.x", "crank.y", "crank.angle", "crank.vx", "crank.vy", "crank.omega"],
                    &mut *each,
                );
                self.rod.each(["rod.x", "rod.y", "rod.angle", "rod.vx", "rod.vy", "rod.omega"], &mut *each);
                self.slider.each(
                    ["slider.x", "slider.y", "slider.angle", "slider.vx", "slider.vy", "slider.omega"],
                    &mut *each,
                );
            }
        }

        impl<S: Scalar> core::fmt::Display for Starts<S> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                rt::start::write_starts(*self, f)
            }
        }

        impl<S: Real> DrivenCrank<S> {
            fn placed(&self, x: &[S; 18]) -> Starts<S> {
                let lit = S::lit;
                Starts {
                    crank: self.start.crank.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[0], x[1], x[2]],
                        [x[9], x[10], x[11]],
                    ),
                    rod: self.start.rod.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[3], x[4], x[5]],
                        [x[12], x[13], x[14]],
                    ),
                    slider: self.start.slider.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[6], x[7], x[8]],
                        [x[15], x[16], x[17]],
                    ),
                }
            }
        }

        impl<S: Real> State<S> {
            /// Poses, velocities and states of this moment as start values, with the locks that are set: to go on from here
            /// later, `mechanism.start = sim.starts()`.
            pub fn starts(&self) -> Starts<S> {
                self.mechanism.placed(&<DrivenCrank<S> as rt::Statics>::full(self))
            }
        }

        impl<S: Real> rt::Statics for DrivenCrank<S> {
            type Full = [S; 18];
            type Rows = [S; 9];
            type Starts = Starts<S>;
            const COORDINATES: &'static [&'static str] = Self::LAYOUT_.coordinates;
            const ROWS: &'static [&'static str] = Self::LAYOUT_.rows;
            const STATES: &'static [(&'static str, &'static str)] = &[];
            fn full(state: &State<S>) -> [S; 18] {
                {
                    let mut x = state.absolute_();
                    rt::turns::add(&state.held.turns, &mut x, &[&[5]]);
                    x
                }
            }

            /// What vanishes at rest: applied forces `Q` (N, N, N m per body) that reactions do not balance, residuals of the
            /// constraints, rates of the first-order states, without accelerations.
            #[cold]
            fn equations(&self, t: S, u: &Self::U, x: &[S; 18], lambda: &[S; 9], each: &mut impl FnMut(S)) {
                let (mut force, mut x_dot) = ([S::lit(0.0); 9], [S::lit(0.0); 0]);
                let lit = S::lit;
                force[0] = lit(0.0);
                force[1] = lit(-1.962);
                force[2] = lit(0.0);
                force[3] = lit(0.0);
                force[4] = lit(-5.886);
                force[5] = lit(0.0);
                force[6] = lit(0.0);
                force[7] = lit(-4.905);
                force[8] = lit(0.0);
                let (q, _): ([S; 9], [S; 9]) = absolute::split(x);
                absolute::balance::<S, Self, NQ, NC>(self, t, &q, lambda, &force)
                    .into_iter()
                    .for_each(&mut *each);
                absolute::residuals::<S, Self, NQ, NC, 18>(self, t, x, each);
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

            fn starts_at(&self, x: &[S; 18]) -> Starts<S> {
                self.placed(x)
            }

            fn size(&self) -> S {
                absolute::Absolute::<S, NQ, NC>::length(self)
            }
        }

        impl<S: Scalar> DrivenCrank<S> {
            /// The right-hand side and the multipliers: `M a + phi_q^T lambda = Q`, `phi_q a = gamma`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 89 add, 125 mul, 8 div, 4 neg, 3 sin_cos, 24 select.
            #[inline(always)]
            fn dynamics(&self, t: S, u: &Held<S>, x: &[S; 18], dx: &mut [S; 18], lambda: &mut [S; 9]) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                // Arms from G to each port: the entries of phi_q, and of phi_q M^-1
                let crank_angle = x[2];
                let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                let rod_angle = x[5];
                let (sin_rod_angle, cos_rod_angle) = rod_angle.sin_cos();
                let y_0_2 = by(100.0) * sin_crank_angle;
                let y_1_2 = by(-100.0) * cos_crank_angle;
                let y_2_5 = by(16.666666666666668) * sin_rod_angle;
                let y_3_5 = by(-16.666666666666668) * cos_rod_angle;
                // phi_q M^-1 phi_q^T = L D L^T
                let t1 = by(0.3) * (sin_rod_angle * y_2_5);
                let r_4 = by(1.0) / (t1 + lit(3.6666666666666665));
                let g_2_4 = t1 - lit(1.6666666666666667);
                let l_2_4 = r_4 * g_2_4;
                let g_3_4 = by(-0.3) * cos_rod_angle * y_2_5;
                let l_3_4 = r_4 * g_3_4;
                let g_5_4 = by(0.3) * (sin_rod_angle * y_3_5);
                let l_5_4 = r_4 * g_5_4;
                let t2 = by(0.3) * (cos_rod_angle * y_3_5);
                let r_5 = by(1.0) / (-g_5_4).mul_add(l_5_4, lit(1.6666666666666667) - t2);
                let growth_5 = ((t2 - lit(3.6666666666666665)) * r_5).abs();
                let most_growth = lit(S::MOST_GROWTH);
                let t3 = most_growth.lt(growth_5);
                let kept_5 = S::select(t3, lit(0.0), r_5);
                let g_2_5 = (-g_2_4).mul_add(l_5_4, g_5_4);
                let l_2_5 = kept_5 * g_2_5;
                let g_3_5 = (-g_3_4).mul_add(l_5_4, lit(-1.6666666666666667) - t2);
                let l_3_5 = kept_5 * g_3_5;
                let t4 = by(0.1) * (sin_crank_angle * y_0_2);
                let r_0 = by(1.0) / (t4 + lit(5.0));
                let g_1_0 = by(0.1) * (sin_crank_angle * y_1_2);
                let l_1_0 = r_0 * g_1_0;
                let g_2_0 = t4 - lit(5.0);
                let l_2_0 = r_0 * g_2_0;
                let l_8_0 = y_0_2 * r_0;
                let t5 = by(0.1) * (cos_crank_angle * y_1_2);
                let t6 = g_1_0.mul_add(l_1_0, t5);
                let r_1 = by(1.0) / (lit(5.0) - t6);
                let growth_1 = ((t5 - lit(5.0)) * r_1).abs();
                let t7 = most_growth.lt(growth_1);
                let kept_1 = S::select(t7, lit(0.0), r_1);
                let g_2_1 = (-g_1_0).mul_add(l_2_0, by(-0.1) * cos_crank_angle * y_0_2);
                let l_2_1 = g_2_1 * kept_1;
                let g_3_1 = lit(-5.0) - t6;
                let l_3_1 = kept_1 * g_3_1;
                let t8 = g_1_0.mul_add(l_8_0, by(100.0) * cos_crank_angle);
                let g_8_1 = -t8;
                let l_8_1 = g_8_1 * kept_1;
                let t9 = t4 + t1 + lit(6.666666666666667);
                let d_2 = (-g_2_1).mul_add(
                    l_2_1,
                    (-g_2_0).mul_add(l_2_0, (-g_2_5).mul_add(l_2_5, (-g_2_4).mul_add(l_2_4, t9))),
                );
                let r_2 = by(1.0) / d_2;
                let growth_2 = (t9 * r_2).abs();
                let t10 = most_growth.lt(growth_2);
                let kept_2 = S::select(t10, lit(0.0), r_2);
                let g_3_2 = (-g_2_1).mul_add(
                    l_3_1,
                    (-l_1_0).mul_add(g_2_0, (-g_2_5).mul_add(l_3_5, (-g_2_4).mul_add(l_3_4, g_1_0 + g_5_4))),
                );
                let l_3_2 = kept_2 * g_3_2;
                let g_8_2 = (-g_2_1).mul_add(l_8_1, (-g_2_0).mul_add(l_8_0, y_0_2));
                let l_8_2 = kept_2 * g_8_2;
                let t11 = lit(6.666666666666667) - t2;
                let d_3 = (-g_3_2).mul_add(
                    l_3_2,
                    (-g_3_1).mul_add(l_3_1, (-g_3_5).mul_add(l_3_5, (-g_3_4).mul_add(l_3_4, t11)) - t6),
                );
                let r_3 = by(1.0) / d_3;
                let growth_3 = (r_3 * (t5 - t11)).abs();
                let t12 = most_growth.lt(growth_3);
                let kept_3 = S::select(t12, lit(0.0), r_3);
                let g_8_3 = -g_3_2.mul_add(l_8_2, g_3_1.mul_add(l_8_1, t8));
                let l_8_3 = kept_3 * g_8_3;
                let d_8 = (-g_8_3).mul_add(
                    l_8_3,
                    (-g_8_2).mul_add(l_8_2, (-g_8_1).mul_add(l_8_1, (-y_0_2).mul_add(l_8_0, lit(1000.0)))),
                );
                let r_8 = by(1.0) / d_8;
                let growth_8 = by(1000.0) * r_8.abs();
                let t13 = most_growth.lt(growth_8);
                // Multipliers: (phi_q M^-1 phi_q^T) lambda = phi_q M^-1 Q - gamma
                let rod_omega = x[14];
                let t14 = rod_omega * rod_omega;
                let b_4 = by(0.3) * (cos_rod_angle * t14);
                let t15 = by(0.3) * (sin_rod_angle * t14);
                let b_5 = (-l_5_4).mul_add(b_4, t15) + lit(9.81);
                let crank_omega = x[11];
                let t16 = crank_omega * crank_omega;
                let b_0 = by(0.1) * (cos_crank_angle * t16);
                let amplitude = self.amplitude;
                let t17 = (-l_1_0).mul_add(b_0, by(0.1) * sin_crank_angle * t16);
                let b_1 = (by(400.0) * amplitude).mul_add((by(20.0) * t).sin(), t17) - lit(9.81);
                let b_2 = (-l_2_1).mul_add(
                    b_1,
                    (-l_2_0).mul_add(b_0, (-l_2_5).mul_add(b_5, (-l_2_4).mul_add(b_4, b_4 + b_0))),
                );
                let b_3 = (-l_3_2).mul_add(
                    b_2,
                    (-l_3_1).mul_add(b_1, (-l_3_5).mul_add(b_5, (-l_3_4).mul_add(b_4, t15 + t17))),
                );
                let lambda_turns = S::select(t13, lit(0.0), r_8)
                    * -l_8_3.mul_add(b_3, l_8_2.mul_add(b_2, l_8_1.mul_add(b_1, l_8_0 * b_0)));
                let lambda_crank_pin_y = (-l_8_3).mul_add(lambda_turns, kept_3 * b_3);
                let lambda_crank_pin_x =
                    (-l_8_2).mul_add(lambda_turns, (-l_3_2).mul_add(lambda_crank_pin_y, kept_2 * b_2));
                let lambda_drive_y = (-l_8_1).mul_add(
                    lambda_turns,
                    (-l_3_1).mul_add(lambda_crank_pin_y, (-l_2_1).mul_add(lambda_crank_pin_x, kept_1 * b_1)),
                );
                let t18 = lambda_crank_pin_y + lambda_drive_y;
                let lambda_drive_x = (-l_1_0).mul_add(
                    t18,
                    (-l_8_0).mul_add(lambda_turns, (-l_2_0).mul_add(lambda_crank_pin_x, r_0 * b_0)),
                );
                let lambda_wrist_pin_y =
                    (-l_3_5).mul_add(lambda_crank_pin_y, (-l_2_5).mul_add(lambda_crank_pin_x, kept_5 * b_5));
                let lambda_wrist_pin_x = (-l_5_4).mul_add(
                    lambda_wrist_pin_y,
                    (-l_3_4).mul_add(lambda_crank_pin_y, (-l_2_4).mul_add(lambda_crank_pin_x, r_4 * b_4)),
                );
                let lambda_guide_normal = lambda_wrist_pin_y + lit(4.905);
                // Results
                dx[0] = x[9];
                dx[1] = x[10];
                dx[2] = crank_omega;
                dx[3] = x[12];
                dx[4] = x[13];
                dx[5] = rod_omega;
                dx[6] = x[15];
                dx[7] = x[16];
                dx[8] = x[17];
                dx[9] = by(5.0) * (lambda_crank_pin_x - lambda_drive_x);
                dx[10] = by(5.0).mul_add(lambda_crank_pin_y - lambda_drive_y, lit(-9.81));
                dx[11] = (-y_1_2).mul_add(
                    t18,
                    (-y_0_2).mul_add(lambda_crank_pin_x + lambda_drive_x, by(-1000.0) * lambda_turns),
                );
                dx[12] = by(-1.6666666666666667) * (lambda_crank_pin_x - lambda_wrist_pin_x);
                dx[13] = by(-1.6666666666666667).mul_add(lambda_crank_pin_y - lambda_wrist_pin_y, lit(-9.81));
                dx[14] = -y_3_5.mul_add(
                    lambda_crank_pin_y + lambda_wrist_pin_y,
                    y_2_5 * (lambda_crank_pin_x + lambda_wrist_pin_x),
                );
                dx[15] = by(-2.0) * lambda_wrist_pin_x;
                dx[16] = by(-2.0) * (lambda_guide_normal - lambda_guide_normal);
                dx[17] = lit(0.0);
                lambda[0] = lambda_drive_x;
                lambda[1] = lambda_drive_y;
                lambda[2] = lambda_crank_pin_x;
                lambda[3] = lambda_crank_pin_y;
                lambda[4] = lambda_wrist_pin_x;
                lambda[5] = lambda_wrist_pin_y;
                lambda[6] = lambda_guide_normal;
                lambda[7] = lit(0.0);
                lambda[8] = lambda_turns;
                let t19 = S::select(t3, lit(0.0), growth_5)
                    .max(S::select(t7, lit(0.0), growth_1))
                    .max(S::select(t10, lit(0.0), growth_2));
                by(1.0) / t19.max(S::select(t12, lit(0.0), growth_3)).max(S::select(t13, lit(0.0), growth_8))
            }

            /// Applied forces `Q` (N, N, N m per body) and `gamma`, for the rank-revealing solution.
            ///
            /// 3 add, 13 mul, 3 sin_cos.
            #[cold]
            fn free(&self, t: S, u: &Held<S>, x: &[S; 18], force: &mut [S; 9], gamma: &mut [S; 9]) {
                let crank_angle = x[2];
                let rod_angle = x[5];
                let crank_omega = x[11];
                let rod_omega = x[14];
                let lit = S::lit;
                let by = rt::Factor;
                force[0] = lit(0.0);
                force[1] = lit(-1.962);
                force[2] = lit(0.0);
                force[3] = lit(0.0);
                force[4] = lit(-5.886);
                force[5] = lit(0.0);
                force[6] = lit(0.0);
                force[7] = lit(-4.905);
                force[8] = lit(0.0);
                let ([sin_crank_angle, sin_rod_angle], [cos_crank_angle, cos_rod_angle]) =
                    S::sin_cos_all([crank_angle, rod_angle]);
                let t1 = crank_omega * crank_omega;
                let t2 = by(-0.1) * (cos_crank_angle * t1);
                gamma[0] = t2;
                let amplitude = self.amplitude;
                let t3 = by(0.1) * (sin_crank_angle * t1);
                gamma[1] = (by(-400.0) * amplitude).mul_add((by(20.0) * t).sin(), -t3);
                let t4 = rod_omega * rod_omega;
                let t5 = by(-0.3) * (cos_rod_angle * t4);
                gamma[2] = t5 + t2;
                let t6 = by(-0.3) * (sin_rod_angle * t4);
                gamma[3] = t6 - t3;
                gamma[4] = t5;
                gamma[5] = t6;
                gamma[6] = lit(0.0);
                gamma[7] = lit(0.0);
                gamma[8] = lit(0.0);
            }
        }

        impl<S: Scalar> DrivenCrank<S> {
            /// The right-hand side in the coordinates .
            /// Returns the smallest square of a dyad's measure.
            ///
            /// 3 add, 6 mul, 2 sin_cos.
            #[inline(always)]
            fn motion_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 0, 2, 1, 0>,
                x: &[S; 0],
                dx: &mut [S; 0],
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                // Results
                let amplitude = self.amplitude;
                let loop_0_y = by(0.2).mul_add(
                    by(3.0).mul_add(t, lit(1.0471975511965979)).sin(),
                    amplitude * (by(20.0) * t).sin(),
                );
                by(2.7777777777777777) * (-loop_0_y).mul_add(loop_0_y, lit(0.36))
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            ///
            /// 19 add, 30 mul, 1 div, 1 neg, 1 sqrt, 2 sin_cos, 3 select, 1 other.
            fn pose_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 0, 2, 1, 0>,
                x: &[S; 0],
                q: &mut [S; 9],
                v: &mut [S; 9],
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let crank_angle = by(3.0).mul_add(t, lit(1.0471975511965979));
                let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                let crank_x = by(0.1) * cos_crank_angle;
                q[0] = crank_x;
                let amplitude = self.amplitude;
                let t1 = by(20.0) * t;
                let (sin_t1, cos_t1) = t1.sin_cos();
                let t2 = amplitude * sin_t1;
                let t3 = by(0.1) * sin_crank_angle;
                let crank_y = t2 + t3;
                q[1] = crank_y;
                q[2] = crank_angle;
                let loop_0_y = by(0.2).mul_add(sin_crank_angle, t2);
                let square_0 = (-loop_0_y).mul_add(loop_0_y, lit(0.36));
                let last_area_0 = m.determinants[0];
                let area_0 =
                    lit(0.0).max(square_0).sqrt() * S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0));
                let t4 = by(0.5) * area_0;
                q[3] = crank_x + t4 + crank_x;
                let t5 = by(0.5) * loop_0_y;
                q[4] = t3 - t5 + crank_y;
                let last_angle_2 = m.angles[1].angle;
                let last_cosine_2 = m.angles[1].cos;
                let rod_sin = by(-1.6666666666666667) * loop_0_y;
                let last_sine_2 = m.angles[1].sin;
                let rod_cos = by(1.6666666666666667) * area_0;
                let t6 = last_angle_2
                    + (-last_sine_2)
                        .mul_add(rod_cos, last_cosine_2 * rod_sin)
                        .atan2(last_sine_2.mul_add(rod_sin, last_cosine_2 * rod_cos));
                q[5] = t6;
                q[6] = by(0.2).mul_add(cos_crank_angle, area_0);
                q[7] = lit(0.0);
                q[8] = lit(0.0);
                let crank_vx = by(-0.3) * sin_crank_angle;
                v[0] = crank_vx;
                let t7 = by(20.0) * (amplitude * cos_t1);
                let t8 = by(0.3) * cos_crank_angle;
                let crank_vy = t7 + t8;
                v[1] = crank_vy;
                v[2] = lit(3.0);
                let reciprocal_0 = by(1.0) / area_0;
                let t9 = by(0.6).mul_add(cos_crank_angle, t7);
                let time_rate_0_0 = -(reciprocal_0 * t9);
                v[3] = t5.mul_add(time_rate_0_0, crank_vx + crank_vx);
                v[4] = t4.mul_add(time_rate_0_0, t8 + crank_vy);
                v[5] = time_rate_0_0;
                v[6] = reciprocal_0 * (-loop_0_y).mul_add(t9, by(-0.6) * sin_crank_angle * area_0);
                v[7] = lit(0.0);
                v[8] = lit(0.0);
                by(2.7777777777777777) * square_0
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart_0(&self, t: S, q: &[S; 9], v: &[S; 9], x: &mut [S; 0]) {}

            /// What is to be remembered of a state, and the smallest square of a dyad's measure.
            ///
            /// 7 add, 18 mul, 3 div, 2 sqrt, 3 sin_cos, 5 select, 1 other.
            fn remember_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 0, 2, 1, 0>,
                x: &[S; 0],
                memory: &mut rt::charts::Continuation<S, 0, 2, 1, 0>,
            ) -> S {
                let [last_area_0, ..] = m.determinants;
                let lit = S::lit;
                let by = rt::Factor;
                memory.time.last = t;
                let amplitude = self.amplitude;
                let t1 = by(20.0) * t;
                let (sin_t1, cos_t1) = t1.sin_cos();
                let crank_angle = by(3.0).mul_add(t, lit(1.0471975511965979));
                let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                let loop_0_y = by(0.2).mul_add(sin_crank_angle, amplitude * sin_t1);
                let square_0 = (-loop_0_y).mul_add(loop_0_y, lit(0.36));
                let area_0 =
                    lit(0.0).max(square_0).sqrt() * S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0));
                let t2 = (by(1.0) / area_0
                    * by(-0.6).mul_add(cos_crank_angle, by(-20.0) * amplitude * cos_t1))
                .abs();
                memory.time.reach = by(-0.1) / t2.max(by(0.6) * t2 / square_0.sqrt());
                memory.angles[0].angle = crank_angle;
                memory.angles[0].cos = cos_crank_angle;
                memory.angles[0].sin = sin_crank_angle;
                let last_angle_2 = m.angles[1].angle;
                let last_cosine_2 = m.angles[1].cos;
                let rod_sin = by(-1.6666666666666667) * loop_0_y;
                let last_sine_2 = m.angles[1].sin;
                let rod_cos = by(1.6666666666666667) * area_0;
                let t3 = last_angle_2
                    + (-last_sine_2)
                        .mul_add(rod_cos, last_cosine_2 * rod_sin)
                        .atan2(last_sine_2.mul_add(rod_sin, last_cosine_2 * rod_cos));
                memory.angles[1].angle = t3;
                let (sin_t3, cos_t3) = t3.sin_cos();
                memory.angles[1].cos = cos_t3;
                memory.angles[1].sin = sin_t3;
                memory.determinants[0] = area_0;
                by(2.7777777777777777) * square_0
            }

            /// The same of a pose and velocity.
            ///
            /// 2 mul, 2 sin_cos.
            #[cold]
            fn remember_pose_0(
                &self,
                t: S,
                q: &[S; 9],
                v: &[S; 9],
                memory: &mut rt::charts::Continuation<S, 0, 2, 1, 0>,
            ) -> S {
                let [_, _, crank_angle, _, _, rod_angle, ..] = *q;
                let lit = S::lit;
                let by = rt::Factor;
                memory.time.last = t;
                memory.time.reach = lit(0.0);
                memory.angles[0].angle = crank_angle;
                let ([sin_crank_angle, sin_rod_angle], [cos_crank_angle, cos_rod_angle]) =
                    S::sin_cos_all([crank_angle, rod_angle]);
                memory.angles[0].cos = cos_crank_angle;
                memory.angles[0].sin = sin_crank_angle;
                memory.angles[1].angle = rod_angle;
                memory.angles[1].cos = cos_rod_angle;
                memory.angles[1].sin = sin_rod_angle;
                memory.determinants[0] = by(0.6) * cos_rod_angle;
                cos_rod_angle * cos_rod_angle
            }
        }
    }
}
