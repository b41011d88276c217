#[doc(inline)]
#[allow(unreachable_pub)]
pub use plm_double_pendulum_::double_pendulum::DoublePendulum;

#[doc(inline)]
#[allow(unreachable_pub, unused_imports)]
pub use plm_double_pendulum_::double_pendulum;
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]
mod plm_double_pendulum_ {
    /// The double pendulum of the manual, section 2.2.
    ///
    /// 2 bodies, 2 parts: 6 coordinates, 4 constraint rows, F = 3 N - M = 2.
    /// Formulation 2: joint coordinates; the joints make a tree, so that no constraint is left.
    /// Coordinates: arm.angle, forearm.angle.
    /// Accelerations by a dense mass matrix.
    /// State: 4 numbers, 32 bytes in f64.
    /// A solution by rank, where one is needed: 320 bytes of stack in f64.
    /// One right-hand side: 11 add, 22 mul, 1 div, 2 sin_cos.
    ///
    /// | row | constraint | equation | unit |
    /// |----:|------------|----------|------|
    /// | 0 | `shoulder.x` | `arm.x - 0.5*cos(arm.angle) = 0` | m |
    /// | 1 | `shoulder.y` | `arm.y - 0.5*sin(arm.angle) = 0` | m |
    /// | 2 | `elbow.x` | `forearm.x - arm.x - 0.5*cos(arm.angle) - cos(forearm.angle) = 0` | m |
    /// | 3 | `elbow.y` | `forearm.y - arm.y - 0.5*sin(arm.angle) - sin(forearm.angle) = 0` | m |
    pub mod double_pendulum {
        pub use super::code_::*;
        pub use super::type_::DoublePendulum;
    }

    mod type_ {
        /// The double pendulum of the manual, section 2.2.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct DoublePendulum<S = ::core::primitive::f64> {
            /// Start values of the bodies, and which of them assembly keeps.
            pub start: super::code_::Starts<S>,
        }
    }

    mod code_ {
        use super::type_::DoublePendulum;
        use ::plm::runtime::generated as rt;
        use ::plm::runtime::generated::lanes::Two;
        use ::plm::runtime::generated::{
            BodyStart, BodyState, Fault, Method, Operations, Real, Scalar, Sim, Start,
        };
        use ::plm::runtime::generated::{absolute, described};

        /// Start values, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Starts<S = f64> {
            /// Origin of body `arm`.
            pub arm: BodyStart<S>,
            /// Origin of body `forearm`.
            pub forearm: BodyStart<S>,
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
        type Held<S> = rt::Held<Input<S>, [S; 0], [<S as Scalar>::Turns; 2], ()>;

        /// Pose, accelerations and a vector, which outputs have in common.
        type Common<S> = rt::Common<([S; 6], [S; 6]), Held<S>, ([S; 6], [S; 4]), [S; 2]>;

        /// The mechanism at one moment; its methods read poses and outputs, `input` has the inputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: DoublePendulum<S>,
            held: rt::Held<Input<S>, [S; 0], [i32; 2], ()>,
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
            Operations { add: 11, mul: 22, div: 1, sqrt: 0, sin_cos: 2, other: 0 };
        impl<S: Real> State<S> {
            /// Time, s.
            pub fn time(&self) -> S {
                self.time
            }

            /// Pose and velocity of G of body `arm`: m, m, rad; m/s, m/s, rad/s.
            pub fn arm(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[0], q[1], rt::turns::whole(q[2], self.held.turns[0])], [v[0], v[1], v[2]])
            }

            /// Pose and velocity of G of body `forearm`: m, m, rad; m/s, m/s, rad/s.
            pub fn forearm(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[3], q[4], rt::turns::whole(q[5], self.held.turns[1])], [v[3], v[4], v[5]])
            }

            /// Output `arm.angle`, rad.
            pub fn arm_angle(&self) -> S {
                self.arm_angle_among_(&Common::<S>::new())
            }

            #[inline]
            fn arm_angle_among_(&self, common: &Common<S>) -> S {
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [_, _, arm_angle, ..] = *q;
                let by = rt::Factor;
                let arm_turns = S::of_turns(self.held.turns[0]);
                by(6.283185307179586).mul_add(arm_turns, arm_angle)
            }

            /// Output `forearm.angle`, rad.
            pub fn forearm_angle(&self) -> S {
                self.forearm_angle_among_(&Common::<S>::new())
            }

            #[inline]
            fn forearm_angle_among_(&self, common: &Common<S>) -> S {
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let forearm_angle = q[5];
                let by = rt::Factor;
                let forearm_turns = S::of_turns(self.held.turns[1]);
                by(6.283185307179586).mul_add(forearm_turns, forearm_angle)
            }

            /// Output `shoulder.force`, N.
            ///
            /// What the joint does to `ground`, absolute axes; `arm` feels the opposite.
            pub fn shoulder_force(&self) -> [S; 2] {
                self.shoulder_force_among_(&Common::<S>::new())
            }

            #[inline]
            fn shoulder_force_among_(&self, common: &Common<S>) -> [S; 2] {
                let mut value = [S::lit(0.0); 2];
                let (_, lambda) = common.solved.get_or_init(|| self.solved_(common));
                value[0] = lambda[0];
                value[1] = lambda[1];
                value
            }

            /// Output `elbow.force`, N.
            ///
            /// What the joint does to `arm`, absolute axes; `forearm` feels the opposite.
            pub fn elbow_force(&self) -> [S; 2] {
                self.elbow_force_among_(&Common::<S>::new())
            }

            #[inline]
            fn elbow_force_among_(&self, common: &Common<S>) -> [S; 2] {
                let mut value = [S::lit(0.0); 2];
                let (_, lambda) = common.solved.get_or_init(|| self.solved_(common));
                value[0] = lambda[2];
                value[1] = lambda[3];
                value
            }

            /// Kinetic energy of all bodies, J.
            pub fn kinetic_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [arm_vx, arm_vy, arm_omega, forearm_vx, forearm_vy, forearm_omega, ..] = *v;
                let by = rt::Factor;
                let t1 = by(5.0)
                    * forearm_vy.mul_add(
                        forearm_vy,
                        forearm_vx.mul_add(forearm_vx, arm_vy.mul_add(arm_vy, arm_vx * arm_vx)),
                    );
                by(0.005).mul_add(forearm_omega.mul_add(forearm_omega, arm_omega * arm_omega), t1)
            }

            /// Potential energy of gravity above the origin, J.
            pub fn gravity_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [_, arm_y, _, _, forearm_y, ..] = *q;
                let by = rt::Factor;
                by(98.1) * (arm_y + forearm_y)
            }

            /// Power of all forces and torques but gravity and reactions, W.
            pub fn load_power(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [_, _, arm_omega, _, _, forearm_omega, ..] = *v;
                let by = rt::Factor;
                let t1 = arm_omega - forearm_omega;
                by(-9.54929658551372) * (-forearm_omega).mul_add(t1, arm_omega * (arm_omega + t1))
            }

            /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
            /// the second turns from the first, rad, positive to the left.
            pub fn branches(&self) -> [(&'static str, S); 1] {
                let mut value = [S::lit(0.0); 1];
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [arm_x, arm_y, arm_angle, forearm_x, forearm_y, ..] = *q;
                let by = rt::Factor;
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                let t1 = by(0.5).mul_add(sin_arm_angle, arm_y) - forearm_y;
                let t2 = by(0.5).mul_add(cos_arm_angle, arm_x) - forearm_x;
                value[0] = (-cos_arm_angle)
                    .mul_add(t1, sin_arm_angle * t2)
                    .atan2(-sin_arm_angle.mul_add(t1, cos_arm_angle * t2));
                [("elbow", value[0])]
            }

            /// Names and units of the columns of [`State::outputs`].
            pub const OUTPUTS: [(&'static str, &'static str); 6] = [
                ("arm.angle", "deg"),
                ("forearm.angle", "deg"),
                ("shoulder.force.x", "N"),
                ("shoulder.force.y", "N"),
                ("elbow.force.x", "N"),
                ("elbow.force.y", "N"),
            ];
            /// The declared outputs, in the units of [`State::OUTPUTS`].
            pub fn outputs(&self) -> [S; 6] {
                let common = &Common::<S>::new();
                let own_0 = self.arm_angle_among_(common);
                let own_1 = self.forearm_angle_among_(common);
                let own_2 = self.shoulder_force_among_(common);
                let own_3 = self.elbow_force_among_(common);
                [
                    own_0 / S::lit(0.017453292519943295),
                    own_1 / S::lit(0.017453292519943295),
                    own_2[0],
                    own_2[1],
                    own_3[0],
                    own_3[1],
                ]
            }

            /// Names and SI units of the outputs and of all that is observed.
            pub const OBSERVED: [(&'static str, &'static str); 6] = [
                ("arm.angle", "rad"),
                ("forearm.angle", "rad"),
                ("shoulder.force.x", "N"),
                ("shoulder.force.y", "N"),
                ("elbow.force.x", "N"),
                ("elbow.force.y", "N"),
            ];

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
                        0 => state.arm_angle_among_(common),
                        1 => state.forearm_angle_among_(common),
                        2 => common.vector(2, || state.shoulder_force_among_(common))[0],
                        3 => common.vector(2, || state.shoulder_force_among_(common))[1],
                        4 => common.vector(4, || state.elbow_force_among_(common))[0],
                        5 => common.vector(4, || state.elbow_force_among_(common))[1],
                        _ => S::lit(f64::NAN),
                    }
                }
                match column / 200 {
                    0 => block_0(self, column, common),
                    _ => S::lit(f64::NAN),
                }
            }
        }

        impl DoublePendulum<f64> {
            /// The mechanism as declared, in `f64`; `DoublePendulum { field: value, ..DoublePendulum::new() }` changes some.
            pub fn new() -> Self {
                Self::of()
            }
        }

        impl Default for DoublePendulum<f64> {
            fn default() -> Self {
                Self::of()
            }
        }

        impl<S: Scalar> DoublePendulum<S> {
            /// The mechanism as declared, for any scalar.
            pub fn of() -> Self {
                let lit = S::lit;
                let start = Starts {
                    arm: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::locked(lit(0.7853981633974483)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    forearm: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::locked(lit(0.0)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                };
                DoublePendulum { start }
            }
        }

        impl<S: Real> DoublePendulum<S> {
            /// Closes the joints from the start values, as the manual's assembly does (section 4.4).
            ///
            /// # Errors
            /// Redundant locks, or joints that stay open: the part and by how much; a parameter that cannot have its value.
            pub fn assemble(&self) -> Result<Assembly<S>, Fault> {
                let t = S::lit(0.0);
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

        impl<S: Scalar> DoublePendulum<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> Input<S> {
                Input { none: core::marker::PhantomData }
            }
        }

        impl<S: Scalar> rt::Rate for DoublePendulum<S> {
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

        impl<S: Real> rt::Constraints for DoublePendulum<S> {
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
            fn is_settled(&self, _t: S, _u: &Self::U, x: &[S; 4]) -> bool {
                !rt::turns::are_due(x, &[&[0], &[1]])
            }

            #[inline]
            fn update(&self, _t: S, u: &mut Self::U, x: &mut [S; 4]) -> Result<rt::Updated, Fault> {
                let turned = rt::turns::unwind(&mut u.turns, x, &[&[0], &[1]]);
                Ok(rt::Updated { turned, ..Default::default() })
            }

            fn energy(&self, t: S, u: &Self::U, x: &[S; 4]) -> Option<rt::Energy<S>> {
                let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
                let (kinetic, gravity) = (state.kinetic_energy(), state.gravity_energy());
                Some(rt::Energy { kinetic, gravity, power: state.load_power() })
            }
        }

        impl<S: Real> rt::Switched for DoublePendulum<S> {
            type Guards = [S; 0];
            type Contact = rt::switched::NoContact;
            const SWITCHES: rt::Switches = rt::Switches::NONE;
        }

        impl<S: Real> rt::Labels for DoublePendulum<S> {
            fn labels(&self) -> &'static rt::LabelTable {
                const {
                    &rt::LabelTable {
                        parts: rt::PartNames::Numbers(const { &["arm", "forearm", "arm", "forearm"] }),
                        states: const { &["arm.angle", "forearm.angle", "arm.omega", "forearm.omega"] },
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

            /// Poses and velocities with all revolutions of the angles.
            fn unwrapped_pose_(&self) -> ([S; 6], [S; 6]) {
                let (mut q, v) = self.pose_();
                rt::turns::add(&self.held.turns, &mut q, &[&[2], &[5]]);
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
            type M = DoublePendulum<S>;

            fn new(mechanism: DoublePendulum<S>, held: Held<S>, time: S, x: [S; 4]) -> Self {
                State { mechanism, held, time, x }
            }

            fn mechanism(&self) -> &DoublePendulum<S> {
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

            fn in_place(&mut self) -> rt::InPlace<'_, DoublePendulum<S>> {
                let Self { mechanism, held, time, x } = self;
                rt::InPlace { system: mechanism, held, time, x }
            }
        }

        impl<S: Real> rt::Mechanism for DoublePendulum<S> {
            type State = State<S>;
            type Rescue = rt::singular::Never<Self>;
            const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();
            fn start_state(&self, t: S) -> Result<(Held<S>, [S; 4]), Fault> {
                self.start_holding_(t, self.declared_input())
            }

            fn opening(&self, t: S, held: &Held<S>, x: &[S; 4]) -> rt::Drift<S> {
                let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
            }
        }

        impl<S: Real> DoublePendulum<S> {
            fn holding_(input: Input<S>) -> Held<S> {
                rt::Held { input, switches: [S::lit(1.0); 0], turns: [0; 2], of_loops: (), contact: () }
            }

            fn start_holding_(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; 4]), Fault> {
                let assembly = absolute::assemble(self, t)?;
                let mut x = [S::lit(0.0); 4];
                let mut held = Self::holding_(input);
                self.to_chart(t, &assembly.q, &assembly.v, &mut x);
                Ok((held, x))
            }
        }

        impl<S: Scalar> DoublePendulum<S> {
            const LAYOUT_: absolute::Layout = absolute::Layout {
                rows: const { &["shoulder.x", "shoulder.y", "elbow.x", "elbow.y"] },
                parts: const { &["shoulder", "shoulder", "elbow", "elbow"] },
                coordinates: const { &["arm.x", "arm.y", "arm.angle", "forearm.x", "forearm.y", "forearm.angle"] },
                angular: &[false; 4],
                given_angles: &[true; 2],
            };
            /// The derivatives of phi by q: the entries that are not zero, row by row.
            ///
            /// 2 mul, 1 neg, 2 sin_cos.
            #[cold]
            fn phi_q_entries(&self, t: S, q: &[S; 6], phi_q: &mut [S; 12]) {
                let [_, _, arm_angle, _, _, forearm_angle, ..] = *q;
                let lit = S::lit;
                let by = rt::Factor;
                phi_q[0] = lit(1.0);
                let ([sin_arm_angle, sin_forearm_angle], [cos_arm_angle, cos_forearm_angle]) =
                    S::sin_cos_all([arm_angle, forearm_angle]);
                let t1 = by(0.5) * sin_arm_angle;
                phi_q[1] = t1;
                phi_q[2] = lit(1.0);
                let t2 = by(-0.5) * cos_arm_angle;
                phi_q[3] = t2;
                phi_q[4] = lit(-1.0);
                phi_q[5] = t1;
                phi_q[6] = lit(1.0);
                phi_q[7] = sin_forearm_angle;
                phi_q[8] = lit(-1.0);
                phi_q[9] = t2;
                phi_q[10] = lit(1.0);
                phi_q[11] = -cos_forearm_angle;
            }
        }

        #[doc(hidden)]
        impl<S: Real> absolute::Absolute<S, NQ, NC> for DoublePendulum<S> {
            fn layout(&self) -> &'static absolute::Layout {
                const { &Self::LAYOUT_ }
            }

            /// Residuals of the constraints, m or rad; the rows stand in the table of this module.
            ///
            /// 8 add, 2 mul, 2 sin_cos.
            fn phi(&self, t: S, q: &[S; 6]) -> [S; 4] {
                let mut phi = [S::lit(0.0); 4];
                let [arm_x, arm_y, arm_angle, forearm_x, forearm_y, forearm_angle, ..] = *q;
                let by = rt::Factor;
                let ([sin_arm_angle, sin_forearm_angle], [cos_arm_angle, cos_forearm_angle]) =
                    S::sin_cos_all([arm_angle, forearm_angle]);
                let t1 = by(0.5) * cos_arm_angle;
                phi[0] = arm_x - t1;
                let t2 = by(0.5) * sin_arm_angle;
                phi[1] = arm_y - t2;
                phi[2] = forearm_x - arm_x - t1 - cos_forearm_angle;
                phi[3] = forearm_y - arm_y - t2 - sin_forearm_angle;
                phi
            }

            /// Their rates, `phi_q v - nu`, m/s or rad/s.
            ///
            /// 8 add, 6 mul, 2 sin_cos.
            fn phi_dot(&self, t: S, q: &[S; 6], v: &[S; 6]) -> [S; 4] {
                let mut phi_dot = [S::lit(0.0); 4];
                let [_, _, arm_angle, _, _, forearm_angle, ..] = *q;
                let [arm_vx, arm_vy, arm_omega, forearm_vx, forearm_vy, forearm_omega, ..] = *v;
                let by = rt::Factor;
                let ([sin_arm_angle, sin_forearm_angle], [cos_arm_angle, cos_forearm_angle]) =
                    S::sin_cos_all([arm_angle, forearm_angle]);
                let t1 = by(0.5) * (arm_omega * sin_arm_angle);
                phi_dot[0] = arm_vx + t1;
                let t2 = by(0.5) * (arm_omega * cos_arm_angle);
                phi_dot[1] = arm_vy - t2;
                phi_dot[2] = forearm_omega.mul_add(sin_forearm_angle, forearm_vx - arm_vx + t1);
                phi_dot[3] = (-forearm_omega).mul_add(cos_forearm_angle, forearm_vy - arm_vy - t2);
                phi_dot
            }

            fn phi_q(&self, t: S, q: &[S; 6], each: &mut impl FnMut(usize, usize, S)) {
                let places: &[[u32; 2]] = const {
                    &rt::compact::pairs::<12>(&rt::compact::numbers::<24>(&[(
                        1,
                        &[0, 0, 0, 2, 1, 1, 1, 2, 2, 0, 2, 2, 2, 3, 2, 5, 3, 1, 3, 2, 3, 4, 3, 5],
                        &[],
                    )]))
                };
                let mut entries = [S::lit(0.0); 12];
                self.phi_q_entries(t, q, &mut entries);
                for (&[row, column], entry) in places.iter().zip(entries) {
                    each(row as usize, column as usize, entry);
                }
            }

            /// The shortest step in the norm of `W^-1` that closes `r`: `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 36 add, 55 mul, 5 div, 1 neg, 2 sin_cos, 14 select.
            fn min_norm(&self, t: S, q: &[S; 6], w: &[S; 6], r: &[S; 4], dq: &mut [S; 6]) -> rt::Health<S> {
                rt::Health({
                    let lit = S::lit;
                    let by = rt::Factor;
                    // phi_q W phi_q^T = L D L^T
                    let w_0 = w[0];
                    let arm_angle = q[2];
                    let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                    let w_2 = w[2];
                    let y_0_2 = by(0.5) * sin_arm_angle * w_2;
                    let t1 = by(0.5) * (sin_arm_angle * y_0_2);
                    let d_0 = w_0 + t1;
                    let r_0 = by(1.0) / d_0;
                    let t2 = by(-0.5) * cos_arm_angle;
                    let y_1_2 = t2 * w_2;
                    let g_1_0 = by(0.5) * (sin_arm_angle * y_1_2);
                    let l_1_0 = r_0 * g_1_0;
                    let g_2_0 = t1 - w_0;
                    let l_2_0 = r_0 * g_2_0;
                    let w_1 = w[1];
                    let t3 = cos_arm_angle * y_1_2;
                    let t4 = by(-0.5).mul_add(t3, w_1);
                    let t5 = g_1_0 * l_1_0;
                    let d_1 = t4 - t5;
                    let r_1 = by(1.0) / d_1;
                    let growth_1 = (t4 * r_1).abs();
                    let most_growth = lit(S::MOST_GROWTH);
                    let t6 = most_growth.lt(growth_1);
                    let kept_1 = S::select(t6, lit(0.0), r_1);
                    let g_2_1 = (-g_1_0).mul_add(l_2_0, t2 * y_0_2);
                    let l_2_1 = g_2_1 * kept_1;
                    let g_3_1 = by(-0.5).mul_add(t3, -w_1) - t5;
                    let l_3_1 = g_3_1 * kept_1;
                    let w_3 = w[3];
                    let forearm_angle = q[5];
                    let (sin_forearm_angle, cos_forearm_angle) = forearm_angle.sin_cos();
                    let w_5 = w[5];
                    let y_2_5 = sin_forearm_angle * w_5;
                    let t7 = sin_forearm_angle.mul_add(y_2_5, w_3) + d_0;
                    let r_2 = by(1.0) / (-g_2_1).mul_add(l_2_1, (-g_2_0).mul_add(l_2_0, t7));
                    let growth_2 = (t7 * r_2).abs();
                    let t8 = most_growth.lt(growth_2);
                    let kept_2 = S::select(t8, lit(0.0), r_2);
                    let y_3_5 = -(cos_forearm_angle * w_5);
                    let g_3_2 = (-g_2_1)
                        .mul_add(l_3_1, (-l_1_0).mul_add(g_2_0, sin_forearm_angle.mul_add(y_3_5, g_1_0)));
                    let l_3_2 = kept_2 * g_3_2;
                    let w_4 = w[4];
                    let t9 = (-cos_forearm_angle).mul_add(y_3_5, w_4);
                    let r_3 = by(1.0) / ((-g_3_2).mul_add(l_3_2, (-g_3_1).mul_add(l_3_1, d_1)) + t9);
                    let growth_3 = (r_3 * (t4 + t9)).abs();
                    let t10 = most_growth.lt(growth_3);
                    // (phi_q W phi_q^T) mu = r
                    let dphi_0 = r[0];
                    let dphi_1 = r[1];
                    let t11 = dphi_0 * l_1_0;
                    let b_1 = dphi_1 - t11;
                    let dphi_2 = r[2];
                    let b_2 = (-b_1).mul_add(l_2_1, (-dphi_0).mul_add(l_2_0, dphi_2));
                    let dphi_3 = r[3];
                    let mu_3 = S::select(t10, lit(0.0), r_3)
                        * (-l_3_2).mul_add(b_2, (-b_1).mul_add(l_3_1, dphi_3 - t11));
                    let mu_2 = (-l_3_2).mul_add(mu_3, kept_2 * b_2);
                    let mu_1 = (-l_3_1).mul_add(mu_3, (-l_2_1).mul_add(mu_2, b_1 * kept_1));
                    let t12 = mu_3 + mu_1;
                    let mu_0 = (-l_1_0).mul_add(t12, (-l_2_0).mul_add(mu_2, dphi_0 * r_0));
                    // Results
                    dq[0] = w_0 * (mu_0 - mu_2);
                    dq[1] = w_1 * (mu_1 - mu_3);
                    dq[2] = y_1_2.mul_add(t12, y_0_2 * (mu_2 + mu_0));
                    dq[3] = w_3 * mu_2;
                    dq[4] = w_4 * mu_3;
                    dq[5] = y_3_5.mul_add(mu_3, y_2_5 * mu_2);
                    let t13 = S::select(t6, lit(0.0), growth_1)
                        .max(S::select(t8, lit(0.0), growth_2))
                        .max(S::select(t10, lit(0.0), growth_3));
                    by(1.0) / t13
                })
            }

            /// Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body.
            fn inverse_mass(&self) -> [S; 6] {
                let mut inverse_mass = [S::lit(0.0); 6];
                let lit = S::lit;
                inverse_mass[0] = lit(0.1);
                inverse_mass[1] = lit(0.1);
                inverse_mass[2] = lit(100.0);
                inverse_mass[3] = lit(0.1);
                inverse_mass[4] = lit(0.1);
                inverse_mass[5] = lit(100.0);
                inverse_mass
            }

            fn length(&self) -> S {
                S::lit(1.0)
            }

            fn start_position(&self) -> [Start<S>; 6] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 2] = [
                    self.start.arm.of_centre([lit(0.0), lit(0.0)]),
                    self.start.forearm.of_centre([lit(0.0), lit(0.0)]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn start_velocity(&self, q: &[S; 6]) -> [Start<S>; 6] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 2] = [
                    self.start.arm.velocity_of_centre([lit(0.0), lit(0.0)], q[2]),
                    self.start.forearm.velocity_of_centre([lit(0.0), lit(0.0)], q[5]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }
        }

        impl<S: Real> State<S> {
            /// Accelerations and multipliers.
            #[inline]
            fn solved_(&self, common: &Common<S>) -> ([S; 6], [S; 4]) {
                let (mut a, mut lambda) = ([S::lit(0.0); 6], [S::lit(0.0); 4]);
                self.mechanism.reactions(self.time, &self.held, &self.x, &mut a, &mut lambda);
                (a, lambda)
            }

            /// Reactions that redundancy leaves undetermined, by constraint row: none.
            pub fn undetermined(&self) -> [bool; 4] {
                [false; 4]
            }
        }

        impl<S: Real> rt::lanes::Pack for DoublePendulum<S> {
            type Packed<T: Scalar> = DoublePendulum<T>;

            #[allow(unused_variables)]
            fn pack<T: Scalar, const N: usize>(
                &self,
                all: [&Self; N],
                number: impl Fn([S; N]) -> T,
            ) -> DoublePendulum<T> {
                let same = |s| number([s; N]);
                let start = Starts { arm: self.start.arm.map(same), forearm: self.start.forearm.map(same) };
                DoublePendulum { start }
            }

            #[allow(unused_variables)]
            fn pack_held<T: Scalar, const N: usize>(
                first: &Held<S>,
                all: [&Held<S>; N],
                number: impl Fn([S; N]) -> T,
            ) -> Held<T> {
                let input = Input { none: core::marker::PhantomData };
                let switches = [];
                let of_loops = ();
                let mut turns = [T::ZERO.to_turns(); 2];
                for k in 0..2 {
                    turns[k] = number(rt::Vector::from_fn(|i| S::of_turns(all[i].turns[k]))).to_turns();
                }
                let contact = ();
                rt::Held { input, switches, turns, of_loops, contact }
            }

            const WATCHED: bool = false;
            #[inline]
            fn are_calm<T: Scalar>(typical: &[T; 4], t: T, held: &Held<T>, x: &[T; 4]) -> T {
                rt::turns::all_near(x, &[&[0], &[1]])
            }

            #[inline]
            fn are_short<T: Scalar>(typical: &[T; 4], held: &Held<T>, legs: [&[T; 4]; 2]) -> T {
                T::lit(1.0)
            }

            #[inline(never)]
            fn look<T: Scalar>(all: &DoublePendulum<T>, t: T, held: &mut Held<T>, x: &[T; 4], due: T) -> T {
                T::lit(0.0)
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

        impl<S: Real> rt::Linear for DoublePendulum<S> {
            type Lifted<const K: usize> = DoublePendulum<rt::Dual<S, K>>;
            type In<T: Real> = DoublePendulum<T>;
            type Derivatives = rt::linalg::Sparse<S, Augmented<S>, 11, 4, 2>;

            fn lift<const K: usize>(
                &self,
                held: &Held<S>,
            ) -> (DoublePendulum<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                self.in_numbers(held, rt::Dual::constant)
            }

            fn in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (DoublePendulum<T>, Held<T>) {
                use rt::lanes::Pack;
                let of_one = |[s]: [S; 1]| number(s);
                (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
            }

            #[inline]
            fn rate_in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (DoublePendulum<T>, Held<T>) {
                let value = Start::free(T::ZERO);
                let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
                let start = Starts { arm: zero, forearm: zero };
                let own = DoublePendulum { start };
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

        impl<S: Real> rt::Ports for DoublePendulum<S> {
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

        impl<S: Real> rt::Described for DoublePendulum<S> {
            const TABLES: &'static described::Tables = &described::Tables {
                name: "DoublePendulum",
                docs: "The double pendulum of the manual, section 2.2.",
                report: described::Report {
                    rung: 2,
                    formulation: "joint coordinates",
                    reason: "the joints make a tree, so that no constraint is left",
                    operations: OPERATIONS,
                    degrees_of_freedom: NDOF,
                },
                bodies: &[
                    described::Body { name: "arm", ports: &["o0", "p12"], contour: 0, first: 0 },
                    described::Body { name: "forearm", ports: &["p12"], contour: 0, first: 9 },
                ],
                ground: &[described::GroundPort { name: "o0", moves: false, first: 15 }],
                parts: &[
                    described::Part {
                        name: "shoulder",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 0 },
                            described::Frame { argument: "b", body: Some(0), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 19,
                    },
                    described::Part {
                        name: "elbow",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(0), port: 1 },
                            described::Frame { argument: "b", body: Some(1), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 20,
                    },
                ],
                parameters: &[],
                inputs: &[],
                states: &[],
                outputs: &[
                    described::Quantity {
                        name: "arm.angle",
                        docs: "",
                        unit: "deg",
                        factor: 0.017453292519943295,
                        exponents: [0, 0, 0, 0, 0, 0, 1],
                        default: None,
                    },
                    described::Quantity {
                        name: "forearm.angle",
                        docs: "",
                        unit: "deg",
                        factor: 0.017453292519943295,
                        exponents: [0, 0, 0, 0, 0, 0, 1],
                        default: None,
                    },
                    described::Quantity {
                        name: "shoulder.force.x",
                        docs: "What the joint does to `ground`, absolute axes; `arm` feels the opposite.",
                        unit: "N",
                        factor: 1.0,
                        exponents: [1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                    described::Quantity {
                        name: "shoulder.force.y",
                        docs: "What the joint does to `ground`, absolute axes; `arm` feels the opposite.",
                        unit: "N",
                        factor: 1.0,
                        exponents: [1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                    described::Quantity {
                        name: "elbow.force.x",
                        docs: "What the joint does to `arm`, absolute axes; `forearm` feels the opposite.",
                        unit: "N",
                        factor: 1.0,
                        exponents: [1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                    described::Quantity {
                        name: "elbow.force.y",
                        docs: "What the joint does to `arm`, absolute axes; `forearm` feels the opposite.",
                        unit: "N",
                        factor: 1.0,
                        exponents: [1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                ],
                reads: &[
                    Some(described::Reads {
                        motion: described::Motion::Poses,
                        time: false,
                        states: &[],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Poses,
                        time: false,
                        states: &[],
                        inputs: &[],
                    }),
                    None,
                    None,
                    None,
                    None,
                ],
            };
            const OBSERVED: &'static [(&'static str, &'static str)] = &State::<S>::OBSERVED;
            const DECLARATION: &'static str = "/// The double pendulum of the manual, section 2.2.\npub DoublePendulum {\n    gravity: 9.81 m/s^2;\n\n    ground { port o0: (0, 0) m; }\n\n    body arm {\n        mass: 10 kg;\n        inertia: 0.01 kg*m^2;\n        port o0:  (-0.5, 0) m;\n        port p12: ( 0.5, 0) m;\n        start angle: 45 deg, locked;\n    }\n    body forearm {\n        mass: 10 kg;\n        inertia: 0.01 kg*m^2;\n        port p12: (-1, 0) m;\n        start angle: 0 deg, locked;\n    }\n\n    revolute shoulder(ground.o0, arm.o0)    { damping: 1 N*m/(rev/min); }\n    revolute elbow(arm.p12, forearm.p12)    { damping: 1 N*m/(rev/min); }\n\n    output arm.angle in deg, forearm.angle in deg, shoulder.force, elbow.force;\n}\n";
            const FILES: &'static [(&'static str, &'static str)] = &[];
            fn figure(&self, t: S, index: usize) -> Option<S> {
                let constants: &[f64] = const {
                    &[
                        10.0, 0.01, 0.0, -0.5, 0.0, 0.0, 0.5, 0.0, 0.0, 10.0, 0.01, 0.0, -1.0, 0.0, 0.0, 0.0,
                        0.0, 0.0, 0.0, 0.0, 0.0,
                    ]
                };
                constants.get(index).copied().map(S::lit)
            }

            fn parameter(&self, index: usize) -> Option<S> {
                match index {
                    _ => None,
                }
            }

            fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
                match index {
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
                self.arm.each(["arm.x", "arm.y", "arm.angle", "arm.vx", "arm.vy", "arm.omega"], &mut *each);
                self.forearm.each(
                    ["forearm.x", "forearm.y", "forearm.angle", "forearm.vx", "forearm.vy", "forearm.omega"],
                    &mut *each,
                );
            }
        }

        impl<S: Scalar> core::fmt::Display for Starts<S> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                rt::start::write_starts(*self, f)
            }
        }

        impl<S: Real> DoublePendulum<S> {
            fn placed(&self, x: &[S; 12]) -> Starts<S> {
                let lit = S::lit;
                Starts {
                    arm: self.start.arm.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[0], x[1], x[2]],
                        [x[6], x[7], x[8]],
                    ),
                    forearm: self.start.forearm.with_centre_at(
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
                self.mechanism.placed(&<DoublePendulum<S> as rt::Statics>::full(self))
            }
        }

        impl<S: Real> rt::Statics for DoublePendulum<S> {
            type Full = [S; 12];
            type Rows = [S; 4];
            type Starts = Starts<S>;
            const COORDINATES: &'static [&'static str] = Self::LAYOUT_.coordinates;
            const ROWS: &'static [&'static str] = Self::LAYOUT_.rows;
            const STATES: &'static [(&'static str, &'static str)] = &[];
            fn full(state: &State<S>) -> [S; 12] {
                {
                    let mut x = state.absolute_();
                    rt::turns::add(&state.held.turns, &mut x, &[&[2], &[5]]);
                    x
                }
            }

            /// What vanishes at rest: applied forces `Q` (N, N, N m per body) that reactions do not balance, residuals of the
            /// constraints, rates of the first-order states, without accelerations.
            ///
            /// 2 add, 3 mul.
            #[cold]
            fn equations(&self, t: S, u: &Self::U, x: &[S; 12], lambda: &[S; 4], each: &mut impl FnMut(S)) {
                let (mut force, mut x_dot) = ([S::lit(0.0); 6], [S::lit(0.0); 0]);
                let arm_omega = x[8];
                let forearm_omega = x[11];
                let lit = S::lit;
                let by = rt::Factor;
                force[0] = lit(0.0);
                force[1] = lit(-98.1);
                force[2] = by(-19.09859317102744).mul_add(arm_omega, by(9.54929658551372) * forearm_omega);
                force[3] = lit(0.0);
                force[4] = lit(-98.1);
                force[5] = by(9.54929658551372) * (arm_omega - forearm_omega);
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

        impl<S: Scalar> DoublePendulum<S> {
            /// The right-hand side in joint coordinates.
            ///
            /// 11 add, 22 mul, 1 div, 2 sin_cos.
            #[inline(always)]
            fn motion(&self, t: S, u: &Held<S>, x: &[S; 4], dx: &mut [S; 4]) {
                let [arm_angle, forearm_angle, arm_omega, forearm_omega, ..] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                // Masses and forces along the coordinates: M a = Q
                let ([sin_arm_angle, sin_forearm_angle], [cos_arm_angle, cos_forearm_angle]) =
                    S::sin_cos_all([arm_angle, forearm_angle]);
                let m_1_0 =
                    by(10.0) * sin_arm_angle.mul_add(sin_forearm_angle, cos_arm_angle * cos_forearm_angle);
                let t1 = (-cos_arm_angle).mul_add(sin_forearm_angle, sin_arm_angle * cos_forearm_angle);
                let force_0 = by(-147.15).mul_add(
                    cos_arm_angle,
                    by(-19.09859317102744).mul_add(
                        arm_omega,
                        forearm_omega * (-(by(10.0) * forearm_omega)).mul_add(t1, lit(9.54929658551372)),
                    ),
                );
                let force_1 = by(-98.1).mul_add(
                    cos_forearm_angle,
                    by(-9.54929658551372).mul_add(
                        forearm_omega,
                        arm_omega * (by(10.0) * arm_omega).mul_add(t1, lit(9.54929658551372)),
                    ),
                );
                // Results
                dx[0] = arm_omega;
                dx[1] = forearm_omega;
                let reciprocal = by(1.0) / (-m_1_0).mul_add(m_1_0, lit(125.2251));
                dx[2] = reciprocal * (-m_1_0).mul_add(force_1, by(10.01) * force_0);
                dx[3] = reciprocal * (-m_1_0).mul_add(force_0, by(12.51) * force_1);
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            ///
            /// 8 add, 8 mul, 2 sin_cos.
            #[inline]
            fn pose(&self, t: S, u: &Held<S>, x: &[S; 4], q: &mut [S; 6], v: &mut [S; 6]) {
                let [arm_angle, forearm_angle, arm_omega, forearm_omega, ..] = *x;
                let by = rt::Factor;
                let ([sin_arm_angle, sin_forearm_angle], [cos_arm_angle, cos_forearm_angle]) =
                    S::sin_cos_all([arm_angle, forearm_angle]);
                let arm_x = by(0.5) * cos_arm_angle;
                q[0] = arm_x;
                let arm_y = by(0.5) * sin_arm_angle;
                q[1] = arm_y;
                q[2] = arm_angle;
                q[3] = arm_x + cos_forearm_angle + arm_x;
                q[4] = arm_y + sin_forearm_angle + arm_y;
                q[5] = forearm_angle;
                let arm_vx = by(-0.5) * (arm_omega * sin_arm_angle);
                v[0] = arm_vx;
                let arm_vy = by(0.5) * (arm_omega * cos_arm_angle);
                v[1] = arm_vy;
                v[2] = arm_omega;
                v[3] = (-forearm_omega).mul_add(sin_forearm_angle, arm_vx + arm_vx);
                v[4] = forearm_omega.mul_add(cos_forearm_angle, arm_vy) + arm_vy;
                v[5] = forearm_omega;
            }

            /// Accelerations of every body, and the multipliers: `M a + phi_q^T lambda = Q`.
            ///
            /// 23 add, 38 mul, 1 div, 2 sin_cos.
            #[inline]
            fn reactions(&self, t: S, u: &Held<S>, x: &[S; 4], a: &mut [S; 6], lambda: &mut [S; 4]) {
                let [arm_angle, forearm_angle, arm_omega, forearm_omega, ..] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                // Masses and forces along the coordinates: M a = Q
                let ([sin_arm_angle, sin_forearm_angle], [cos_arm_angle, cos_forearm_angle]) =
                    S::sin_cos_all([arm_angle, forearm_angle]);
                let m_1_0 =
                    by(10.0) * sin_arm_angle.mul_add(sin_forearm_angle, cos_arm_angle * cos_forearm_angle);
                let t1 = (-cos_arm_angle).mul_add(sin_forearm_angle, sin_arm_angle * cos_forearm_angle);
                let force_0 = by(-147.15).mul_add(
                    cos_arm_angle,
                    by(-19.09859317102744).mul_add(
                        arm_omega,
                        forearm_omega * (-(by(10.0) * forearm_omega)).mul_add(t1, lit(9.54929658551372)),
                    ),
                );
                let force_1 = by(-98.1).mul_add(
                    cos_forearm_angle,
                    by(-9.54929658551372).mul_add(
                        forearm_omega,
                        arm_omega * (by(10.0) * arm_omega).mul_add(t1, lit(9.54929658551372)),
                    ),
                );
                // Accelerations of the bodies, from the ground outwards
                let t2 = arm_omega * arm_omega;
                let reciprocal = by(1.0) / (-m_1_0).mul_add(m_1_0, lit(125.2251));
                let arm_angle_acceleration = reciprocal * (-m_1_0).mul_add(force_1, by(10.01) * force_0);
                let arm_ax = by(-0.5) * sin_arm_angle.mul_add(arm_angle_acceleration, cos_arm_angle * t2);
                let arm_ay = by(-0.5) * (-cos_arm_angle).mul_add(arm_angle_acceleration, sin_arm_angle * t2);
                let t3 = forearm_omega * forearm_omega;
                let forearm_angle_acceleration = reciprocal * (-m_1_0).mul_add(force_0, by(12.51) * force_1);
                let forearm_ax = (-sin_forearm_angle)
                    .mul_add(forearm_angle_acceleration, (-cos_forearm_angle).mul_add(t3, arm_ax))
                    + arm_ax;
                let forearm_ay = (-sin_forearm_angle)
                    .mul_add(t3, cos_forearm_angle * forearm_angle_acceleration)
                    + arm_ay
                    + arm_ay;
                // From the tips inwards: phi_q^T lambda = Q - M a
                let forearm_left_x = by(-10.0) * forearm_ax;
                let forearm_left_y = by(-10.0).mul_add(forearm_ay, lit(-98.1));
                // Results
                a[0] = arm_ax;
                a[1] = arm_ay;
                a[2] = arm_angle_acceleration;
                a[3] = forearm_ax;
                a[4] = forearm_ay;
                a[5] = forearm_angle_acceleration;
                lambda[0] = by(-10.0).mul_add(arm_ax, forearm_left_x);
                lambda[1] = by(-10.0).mul_add(arm_ay, forearm_left_y) - lit(98.1);
                lambda[2] = forearm_left_x;
                lambda[3] = forearm_left_y;
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart(&self, t: S, q: &[S; 6], v: &[S; 6], x: &mut [S; 4]) {
                x[0] = q[2];
                x[1] = q[5];
                x[2] = v[2];
                x[3] = v[5];
            }
        }

        impl<S: Scalar> DoublePendulum<S> {
            /// The coefficients of the linearised equations before anything is eliminated; `dx` is the rate there.
            ///
            /// 8 add, 21 mul, 2 sin_cos.
            fn linearised(&self, t: S, u: &Held<S>, x: &[S; 4], dx: &[S; 4], c: &mut [S; 11]) {
                let [_, _, acceleration_2, acceleration, ..] = *dx;
                let [arm_angle, forearm_angle, arm_omega, forearm_omega, ..] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                // Derivatives of M a - Q and of the rates of the states
                let ([sin_arm_angle, sin_forearm_angle], [cos_arm_angle, cos_forearm_angle]) =
                    S::sin_cos_all([arm_angle, forearm_angle]);
                let t1 = sin_arm_angle.mul_add(sin_forearm_angle, cos_arm_angle * cos_forearm_angle);
                let t2 = (-cos_arm_angle).mul_add(sin_forearm_angle, sin_arm_angle * cos_forearm_angle);
                let t3 = (-t2).mul_add(acceleration, forearm_omega * forearm_omega * t1);
                let t4 = t2.mul_add(acceleration_2, arm_omega * arm_omega * t1);
                // Results
                c[0] = by(-147.15).mul_add(sin_arm_angle, by(10.0) * t3);
                c[1] = lit(19.09859317102744);
                c[2] = lit(12.51);
                c[3] = by(-10.0) * t3;
                c[4] = (by(20.0) * forearm_omega).mul_add(t2, lit(-9.54929658551372));
                c[5] = by(10.0) * t1;
                c[6] = by(-10.0) * t4;
                c[7] = (-(by(20.0) * arm_omega)).mul_add(t2, lit(-9.54929658551372));
                c[8] = by(-98.1).mul_add(sin_forearm_angle, by(10.0) * t4);
                c[9] = lit(9.54929658551372);
                c[10] = lit(10.01);
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
                    &rt::compact::terms::<12>(&rt::compact::numbers::<60>(&[(
                        1,
                        &[
                            0, 0, 0, 0, 2, 1, 0, 0, 0, 3, 2, 0, 0, 0, 4, 3, 0, 1, 2, 2, 4, 0, 1, 2, 3, 5, 0,
                            1, 2, 4, 6, 1, 0, 1, 2, 7, 1, 0, 1, 3, 5, 1, 0, 1, 4, 8, 1, 1, 3, 2, 9, 1, 1, 3,
                            3, 10, 1, 1, 3, 4,
                        ],
                        &[],
                    )]))
                },
                pivots: const {
                    &rt::compact::pivots::<2>(&rt::compact::numbers::<14>(&[(
                        1,
                        &[0, 0, 0, 1, 0, 1, 0, 1, 3, 1, 1, 1, 1, 1],
                        &[],
                    )]))
                },
                below: const { &rt::compact::below::<1>(&rt::compact::numbers::<3>(&[(1, &[1, 1, 2], &[])])) },
                right: const { &rt::compact::pairs::<1>(&rt::compact::numbers::<2>(&[(1, &[1, 2], &[])])) },
                targets: const { &rt::compact::numbers::<1>(&[(1, &[3], &[])]) },
            };
        }
    }
}
