#[doc(inline)]
#[allow(unreachable_pub)]
pub use plm_arm_on_jack_::arm_on_jack::ArmOnJack;

#[doc(inline)]
#[allow(unreachable_pub, unused_imports)]
pub use plm_arm_on_jack_::arm_on_jack;
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]
mod plm_arm_on_jack_ {
    /// The arm of the manual, section 3.2.1.
    ///
    /// 1 bodies, 9 parts: 3 coordinates, 2 constraint rows, F = 3 N - M = 1.
    /// Formulation 2: joint coordinates; the joints make a tree, so that no constraint is left.
    /// Coordinates: arm.angle.
    /// Accelerations by a dense mass matrix.
    /// State: 10 numbers, 80 bytes in f64.
    /// A solution by rank, where one is needed: 80 bytes of stack in f64.
    /// One right-hand side: 54 add, 89 mul, 16 div, 1 neg, 9 sqrt, 1 sin_cos, 22 select.
    ///
    /// | row | constraint | equation | unit |
    /// |----:|------------|----------|------|
    /// | 0 | `hinge.x` | `arm.x - 0.8*cos(arm.angle) = 0` | m |
    /// | 1 | `hinge.y` | `arm.y - 0.8*sin(arm.angle) = 0` | m |
    pub mod arm_on_jack {
        pub use super::code_::*;
        pub use super::type_::ArmOnJack;
    }

    mod type_ {
        /// The arm of the manual, section 3.2.1.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct ArmOnJack<S = ::core::primitive::f64> {
            /// Acceleration of gravity; the manual's other runs had 9.80665 m/s^2.
            ///
            /// In m/s^2; 9.81 m/s^2 by default.
            pub g: S,
            /// Pressure drop at which the valve lets 20 L/min through: not in the manual.
            ///
            /// In Pa; 1 bar by default.
            pub rated_drop: S,
            /// Share of undissolved gas in the oil: not in the manual.
            ///
            /// In no unit; 0 by default.
            pub gas: S,
            /// Start values of the bodies, and which of them assembly keeps.
            pub start: super::code_::Starts<S>,
        }
    }

    mod code_ {
        use super::type_::ArmOnJack;
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
            /// State `press.chamber1.pressure`, Pa.
            pub press_chamber1_pressure: Start<S>,
            /// State `press.chamber2.pressure`, Pa.
            pub press_chamber2_pressure: Start<S>,
            /// State `line1.flow`, m^3/s.
            pub line1_flow: Start<S>,
            /// State `line1.inlet.pressure`, Pa.
            pub line1_inlet_pressure: Start<S>,
            /// State `line2.flow`, m^3/s.
            pub line2_flow: Start<S>,
            /// State `line2.inlet.pressure`, Pa.
            pub line2_inlet_pressure: Start<S>,
            /// State `valve.servo.value`, no unit.
            pub valve_servo_value: Start<S>,
            /// State `valve.servo.swing`, no unit.
            pub valve_servo_swing: Start<S>,
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
        type Held<S> = rt::Held<Input<S>, [S; 10], [<S as Scalar>::Turns; 1], ()>;

        /// Pose, accelerations and a vector, which outputs have in common.
        type Common<S> = rt::Common<([S; 3], [S; 3]), Held<S>, ([S; 3], [S; 2]), [S; 2]>;

        /// The mechanism at one moment; its methods read poses and outputs, `input` has the inputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: ArmOnJack<S>,
            held: rt::Held<Input<S>, [S; 10], [i32; 1], ()>,
            time: S,
            x: [S; 10],
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
        pub const NQ: usize = 3;
        /// Constraint rows.
        pub const NC: usize = 2;
        /// First-order states.
        pub const NX: usize = 8;
        /// Degrees of freedom, `3 N - M`.
        pub const NDOF: isize = 1;
        /// Operations of one evaluation of the right-hand side.
        pub const OPERATIONS: Operations =
            Operations { add: 55, mul: 89, div: 16, sqrt: 9, sin_cos: 1, other: 22 };
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

            /// Output `press.chamber1.pressure`, Pa.
            pub fn press_chamber1_pressure(&self) -> S {
                self.press_chamber1_pressure_among_(&Common::<S>::new())
            }

            #[inline]
            fn press_chamber1_pressure_among_(&self, common: &Common<S>) -> S {
                self.x[2]
            }

            /// Output `press.chamber2.pressure`, Pa.
            pub fn press_chamber2_pressure(&self) -> S {
                self.press_chamber2_pressure_among_(&Common::<S>::new())
            }

            #[inline]
            fn press_chamber2_pressure_among_(&self, common: &Common<S>) -> S {
                self.x[3]
            }

            /// Output `ram.length`, m.
            pub fn ram_length(&self) -> S {
                self.ram_length_among_(&Common::<S>::new())
            }

            #[inline]
            fn ram_length_among_(&self, common: &Common<S>) -> S {
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [arm_x, arm_y, arm_angle, ..] = *q;
                let lit = S::lit;
                let by = rt::Factor;
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                let t1 = by(-0.5).mul_add(cos_arm_angle, arm_x);
                let t2 = by(-0.5).mul_add(sin_arm_angle, arm_y) + lit(0.25);
                t2.mul_add(t2, t1 * t1).sqrt()
            }

            /// Kinetic energy of all bodies, J.
            pub fn kinetic_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [arm_vx, arm_vy, arm_omega, ..] = *v;
                let by = rt::Factor;
                by(50.0).mul_add(arm_vy.mul_add(arm_vy, arm_vx * arm_vx), by(0.005) * arm_omega * arm_omega)
            }

            /// Potential energy of gravity above the origin, J.
            pub fn gravity_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [_, arm_y, ..] = *q;
                let by = rt::Factor;
                let g = self.mechanism.g;
                by(100.0) * g * arm_y
            }

            /// Power of all forces and torques but gravity and reactions, W.
            pub fn load_power(&self) -> S {
                let common = &Common::<S>::new();
                let (q, v) = common.pose.get_or_init(|| self.pose_());
                let [arm_x, arm_y, arm_angle, ..] = *q;
                let [_, _, press_chamber1_pressure, press_chamber2_pressure, ..] = self.x;
                let [arm_vx, arm_vy, arm_omega, ..] = *v;
                let lit = S::lit;
                let by = rt::Factor;
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                let t1 = by(-0.5).mul_add(cos_arm_angle, arm_x);
                let t2 = by(-0.5).mul_add(sin_arm_angle, arm_y) + lit(0.25);
                let t3 = t2.mul_add(t2, t1 * t1).sqrt();
                let t4 = by(1.0) / t3;
                let t5 = by(0.5) * arm_omega;
                let t6 = t2
                    .mul_add((-t5).mul_add(cos_arm_angle, arm_vy), t1 * t5.mul_add(sin_arm_angle, arm_vx))
                    * t4;
                let t7 = lit(0.0).max(t3 - lit(0.57));
                let t8 = lit(0.0).max(lit(0.22) - t3);
                let t9 = by(-1000.0).mul_add(
                    t6,
                    by(-0.0012566370614359172)
                        .mul_add(press_chamber2_pressure, by(0.001963495408493621) * press_chamber1_pressure),
                ) - lit(0.0)
                    .max((by(1000.0) * lit(1.0).min(by(1000000.0) * t7)).mul_add(t6, by(100000000.0) * t7));
                let t10 = t9
                    + lit(0.0).max(
                        (-(by(1000.0) * lit(1.0).min(by(1000000.0) * t8))).mul_add(t6, by(100000000.0) * t8),
                    );
                let t11 = (-t5).mul_add(
                    t4 * (t10 * (-sin_arm_angle).mul_add(t1, cos_arm_angle * t2)),
                    t4 * (t10 * arm_vy.mul_add(t2, arm_vx * t1)),
                );
                t11
            }

            /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
            /// the second turns from the first, rad, positive to the left.
            pub fn branches(&self) -> [(&'static str, S); 0] {
                let mut value = [S::lit(0.0); 0];
                []
            }

            /// Names and units of the columns of [`State::outputs`].
            pub const OUTPUTS: [(&'static str, &'static str); 3] =
                [("press.chamber1.pressure", "Pa"), ("press.chamber2.pressure", "Pa"), ("ram.length", "m")];
            /// The declared outputs, in the units of [`State::OUTPUTS`].
            pub fn outputs(&self) -> [S; 3] {
                let common = &Common::<S>::new();
                let own_0 = self.press_chamber1_pressure_among_(common);
                let own_1 = self.press_chamber2_pressure_among_(common);
                let own_2 = self.ram_length_among_(common);
                [own_0, own_1, own_2]
            }

            /// Names and SI units of the outputs and of all that is observed.
            pub const OBSERVED: [(&'static str, &'static str); 3] =
                [("press.chamber1.pressure", "Pa"), ("press.chamber2.pressure", "Pa"), ("ram.length", "m")];

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
                        0 => state.press_chamber1_pressure_among_(common),
                        1 => state.press_chamber2_pressure_among_(common),
                        2 => state.ram_length_among_(common),
                        _ => S::lit(f64::NAN),
                    }
                }
                match column / 200 {
                    0 => block_0(self, column, common),
                    _ => S::lit(f64::NAN),
                }
            }
        }

        impl ArmOnJack<f64> {
            /// The mechanism as declared, in `f64`; `ArmOnJack { field: value, ..ArmOnJack::new() }` changes some.
            pub fn new() -> Self {
                Self::of()
            }
        }

        impl Default for ArmOnJack<f64> {
            fn default() -> Self {
                Self::of()
            }
        }

        impl<S: Scalar> ArmOnJack<S> {
            /// The mechanism as declared, for any scalar.
            pub fn of() -> Self {
                let lit = S::lit;
                let g = lit(9.81);
                let rated_drop = lit(100000.0);
                let gas = lit(0.0);
                let start = Starts {
                    arm: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::locked(lit(0.3490658503988659)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    press_chamber1_pressure: Start::free(lit(0.0)),
                    press_chamber2_pressure: Start::locked(lit(500000.0)),
                    line1_flow: Start::free(lit(0.0)),
                    line1_inlet_pressure: Start::free(lit(0.0)),
                    line2_flow: Start::free(lit(0.0)),
                    line2_inlet_pressure: Start::free(lit(500000.0)),
                    valve_servo_value: Start::free(lit(0.0)),
                    valve_servo_swing: Start::free(lit(0.0)),
                };
                ArmOnJack { g, rated_drop, gas, start }
            }
        }

        impl<S: Real> ArmOnJack<S> {
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

        impl<S: Scalar> ArmOnJack<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> Input<S> {
                Input { none: core::marker::PhantomData }
            }
        }

        impl<S: Scalar> rt::Rate for ArmOnJack<S> {
            type S = S;
            type X = [S; 10];
            type U = Held<S>;
            const NQ: usize = 1;
            const SHORT: bool = !S::REGISTERS.are_filled();
            #[inline(always)]
            fn rate(&self, t: S, u: &Self::U, x: &[S; 10], dx: &mut [S; 10]) -> rt::Health<S> {
                self.motion(t, u, x, dx);
                rt::Health::perfect()
            }

            #[inline]
            fn typical(&self) -> [S; 10] {
                [
                    1.0,
                    1.0,
                    100000.0,
                    100000.0,
                    1.6666666666666667e-5,
                    100000.0,
                    1.6666666666666667e-5,
                    100000.0,
                    1.0,
                    1.0,
                ]
                .map(S::lit)
            }
        }

        impl<S: Real> rt::Constraints for ArmOnJack<S> {
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
            fn is_settled(&self, _t: S, _u: &Self::U, x: &[S; 10]) -> bool {
                !rt::turns::are_due(x, &[&[0]])
            }

            #[inline]
            fn update(&self, _t: S, u: &mut Self::U, x: &mut [S; 10]) -> Result<rt::Updated, Fault> {
                let turned = rt::turns::unwind(&mut u.turns, x, &[&[0]]);
                Ok(rt::Updated { turned, ..Default::default() })
            }

            fn energy(&self, t: S, u: &Self::U, x: &[S; 10]) -> Option<rt::Energy<S>> {
                let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
                let (kinetic, gravity) = (state.kinetic_energy(), state.gravity_energy());
                Some(rt::Energy { kinetic, gravity, power: state.load_power() })
            }
        }

        impl<S: Real> rt::Switched for ArmOnJack<S> {
            type Guards = [S; 6];
            type Contact = rt::switched::NoContact;
            const SWITCHES: rt::Switches =
                rt::Switches { guards: 6, kinks: 13, times: 4, ..rt::Switches::NONE };
            #[inline]
            fn watch<T>(&self, t: S, u: &Self::U, x: &[S; 10], see: impl FnOnce(&[S]) -> T) -> T {
                let mut all = [S::lit(0.0); 19];
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
                let mut all = [rt::Enclosed::constant(S::lit(0.0)); 19];
                let within =
                    |u: &Held<rt::Enclosed<S>>, x: &[rt::Enclosed<S>; 10], g: &mut [rt::Enclosed<S>; 19]| {
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
                let (mut at, mut slope) = ([S::lit(0.0); 4], [S::lit(0.0); 4]);
                self.instants(u, &mut at, &mut slope);
                see(&at, &slope)
            }

            #[inline]
            fn is_required(&self, index: usize) -> bool {
                matches!(index, 0 | 1 | 2 | 3 | 4 | 5)
            }
        }

        impl<S: Real> rt::Labels for ArmOnJack<S> {
            fn labels(&self) -> &'static rt::LabelTable {
                const {
                    &rt::LabelTable {
                        parts: rt::PartNames::Numbers(
                            const {
                                &[
                                    "arm",
                                    "arm",
                                    "press.chamber1.pressure",
                                    "press.chamber2.pressure",
                                    "line1.flow",
                                    "line1.inlet.pressure",
                                    "line2.flow",
                                    "line2.inlet.pressure",
                                    "valve.servo.value",
                                    "valve.servo.swing",
                                ]
                            },
                        ),
                        states: const {
                            &[
                                "arm.angle",
                                "arm.omega",
                                "press.chamber1.pressure",
                                "press.chamber2.pressure",
                                "line1.flow",
                                "line1.inlet.pressure",
                                "line2.flow",
                                "line2.inlet.pressure",
                                "valve.servo.value",
                                "valve.servo.swing",
                            ]
                        },
                        guards: &[
                            "press.chamber1.has_room",
                            "press.chamber1.above_vacuum",
                            "press.chamber2.has_room",
                            "press.chamber2.above_vacuum",
                            "line1.inlet.above_vacuum",
                            "line2.inlet.above_vacuum",
                        ],
                        conditions: &[
                            "press.chamber1.has_room",
                            "press.chamber1.above_vacuum",
                            "press.chamber2.has_room",
                            "press.chamber2.above_vacuum",
                            "line1.inlet.above_vacuum",
                            "line2.inlet.above_vacuum",
                        ],
                        instants: &[
                            "valve.servo.swing",
                            "valve.servo.swing",
                            "valve.servo.swing",
                            "valve.servo.swing",
                        ],
                        ..rt::LabelTable::NONE
                    }
                }
            }
        }

        impl<S: Real> State<S> {
            /// Pose and velocity of every body.
            #[inline]
            fn pose_(&self) -> ([S; 3], [S; 3]) {
                let (mut q, mut v) = ([S::lit(0.0); 3], [S::lit(0.0); 3]);
                self.mechanism.pose(self.time, &self.held, &self.x, &mut q, &mut v);
                (q, v)
            }

            /// Poses and velocities with all revolutions of the angles.
            fn unwrapped_pose_(&self) -> ([S; 3], [S; 3]) {
                let (mut q, v) = self.pose_();
                rt::turns::add(&self.held.turns, &mut q, &[&[2]]);
                (q, v)
            }
        }

        impl<S: Real> State<S> {
            /// The state in absolute coordinates.
            fn absolute_(&self) -> [S; 14] {
                self.joined_(&self.pose_())
            }

            /// The state in absolute coordinates, of pose and velocity.
            fn joined_(&self, (q, v): &([S; 3], [S; 3])) -> [S; 14] {
                let mut x = [S::lit(0.0); 14];
                absolute::join(q, v, &mut x);
                for k in 0..8 {
                    x[6 + k] = self.x[2 + k];
                }
                x
            }
        }

        impl<S: Real> rt::Moment for State<S> {
            type M = ArmOnJack<S>;

            fn new(mechanism: ArmOnJack<S>, held: Held<S>, time: S, x: [S; 10]) -> Self {
                State { mechanism, held, time, x }
            }

            fn mechanism(&self) -> &ArmOnJack<S> {
                &self.mechanism
            }

            fn held(&self) -> Held<S> {
                self.held
            }

            fn time(&self) -> S {
                self.time
            }

            fn x(&self) -> &[S; 10] {
                &self.x
            }

            fn set(&mut self, time: S, held: &Held<S>, x: &[S; 10]) {
                self.time = time;
                self.held = *held;
                self.x = *x;
            }

            fn in_place(&mut self) -> rt::InPlace<'_, ArmOnJack<S>> {
                let Self { mechanism, held, time, x } = self;
                rt::InPlace { system: mechanism, held, time, x }
            }
        }

        impl<S: Real> rt::Mechanism for ArmOnJack<S> {
            type State = State<S>;
            type Rescue = rt::singular::Never<Self>;
            const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();
            fn start_state(&self, t: S) -> Result<(Held<S>, [S; 10]), Fault> {
                self.start_holding_(t, self.declared_input())
            }

            fn check(&self, t: S) -> Result<(), Fault> {
                rt::limits::check_numbers(
                    t,
                    [("g", "m/s^2", self.g), ("rated_drop", "Pa", self.rated_drop), ("gas", "", self.gas)],
                )?;
                Ok(())
            }

            fn opening(&self, t: S, held: &Held<S>, x: &[S; 10]) -> rt::Drift<S> {
                let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
            }
        }

        impl<S: Real> ArmOnJack<S> {
            fn holding_(input: Input<S>) -> Held<S> {
                rt::Held { input, switches: [S::lit(1.0); 10], turns: [0; 1], of_loops: (), contact: () }
            }

            fn start_holding_(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; 10]), Fault> {
                rt::Mechanism::check(self, t)?;
                let assembly = absolute::assemble(self, t)?;
                let mut x = [S::lit(0.0); 10];
                x[2] = self.start.press_chamber1_pressure.value;
                x[3] = self.start.press_chamber2_pressure.value;
                x[4] = self.start.line1_flow.value;
                x[5] = self.start.line1_inlet_pressure.value;
                x[6] = self.start.line2_flow.value;
                x[7] = self.start.line2_inlet_pressure.value;
                x[8] = self.start.valve_servo_value.value;
                x[9] = self.start.valve_servo_swing.value;
                let mut held = Self::holding_(input);
                self.to_chart(t, &assembly.q, &assembly.v, &mut x);
                rt::Events::switch_at_time(self, t, &mut held, &mut x)?;
                rt::events::switch_where_due(self, t, &mut held, &mut x)?;
                Ok((held, x))
            }
        }

        impl<S: Scalar> ArmOnJack<S> {
            const LAYOUT_: absolute::Layout = absolute::Layout {
                rows: const { &["hinge.x", "hinge.y"] },
                parts: const { &["hinge", "hinge"] },
                coordinates: const { &["arm.x", "arm.y", "arm.angle"] },
                angular: &[false; 2],
                given_angles: &[true; 1],
            };
            /// The derivatives of phi by q: the entries that are not zero, row by row.
            ///
            /// 2 mul, 1 sin_cos.
            #[cold]
            fn phi_q_entries(&self, t: S, q: &[S; 3], phi_q: &mut [S; 4]) {
                let [_, _, arm_angle, ..] = *q;
                let lit = S::lit;
                let by = rt::Factor;
                phi_q[0] = lit(1.0);
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                phi_q[1] = by(0.8) * sin_arm_angle;
                phi_q[2] = lit(1.0);
                phi_q[3] = by(-0.8) * cos_arm_angle;
            }
        }

        #[doc(hidden)]
        impl<S: Real> absolute::Absolute<S, NQ, NC> for ArmOnJack<S> {
            fn layout(&self) -> &'static absolute::Layout {
                const { &Self::LAYOUT_ }
            }

            /// Residuals of the constraints, m or rad; the rows stand in the table of this module.
            ///
            /// 2 add, 2 mul, 1 sin_cos.
            fn phi(&self, t: S, q: &[S; 3]) -> [S; 2] {
                let mut phi = [S::lit(0.0); 2];
                let [arm_x, arm_y, arm_angle, ..] = *q;
                let by = rt::Factor;
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                phi[0] = by(-0.8).mul_add(cos_arm_angle, arm_x);
                phi[1] = by(-0.8).mul_add(sin_arm_angle, arm_y);
                phi
            }

            /// Their rates, `phi_q v - nu`, m/s or rad/s.
            ///
            /// 2 add, 3 mul, 1 sin_cos.
            fn phi_dot(&self, t: S, q: &[S; 3], v: &[S; 3]) -> [S; 2] {
                let mut phi_dot = [S::lit(0.0); 2];
                let [_, _, arm_angle, ..] = *q;
                let [arm_vx, arm_vy, arm_omega, ..] = *v;
                let by = rt::Factor;
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                let t1 = by(0.8) * arm_omega;
                phi_dot[0] = t1.mul_add(sin_arm_angle, arm_vx);
                phi_dot[1] = (-t1).mul_add(cos_arm_angle, arm_vy);
                phi_dot
            }

            fn phi_q(&self, t: S, q: &[S; 3], each: &mut impl FnMut(usize, usize, S)) {
                let places: &[[u32; 2]] = const {
                    &rt::compact::pairs::<4>(&rt::compact::numbers::<8>(&[(
                        1,
                        &[0, 0, 0, 2, 1, 1, 1, 2],
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
            /// 6 add, 19 mul, 3 div, 1 sin_cos, 4 select.
            fn min_norm(&self, t: S, q: &[S; 3], w: &[S; 3], r: &[S; 2], dq: &mut [S; 3]) -> rt::Health<S> {
                rt::Health({
                    let [_, _, arm_angle, ..] = *q;
                    let [dphi_0, dphi_1, ..] = *r;
                    let [w_0, w_1, w_2, ..] = *w;
                    let lit = S::lit;
                    let by = rt::Factor;
                    // phi_q W phi_q^T = L D L^T
                    let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                    let t1 = by(0.8) * sin_arm_angle;
                    let y_0_2 = t1 * w_2;
                    let r_0 = by(1.0) / t1.mul_add(y_0_2, w_0);
                    let y_1_2 = by(-0.8) * cos_arm_angle * w_2;
                    let g_1_0 = t1 * y_1_2;
                    let l_1_0 = r_0 * g_1_0;
                    let t2 = (-(by(0.8) * cos_arm_angle)).mul_add(y_1_2, w_1);
                    let r_1 = by(1.0) / (-g_1_0).mul_add(l_1_0, t2);
                    let growth_1 = (t2 * r_1).abs();
                    let most_growth = lit(S::MOST_GROWTH);
                    let t3 = most_growth.lt(growth_1);
                    // (phi_q W phi_q^T) mu = r
                    let mu_1 = (-dphi_0).mul_add(l_1_0, dphi_1) * S::select(t3, lit(0.0), r_1);
                    let mu_0 = (-l_1_0).mul_add(mu_1, dphi_0 * r_0);
                    // Results
                    dq[0] = w_0 * mu_0;
                    dq[1] = w_1 * mu_1;
                    dq[2] = y_1_2.mul_add(mu_1, y_0_2 * mu_0);
                    by(1.0) / S::select(t3, lit(0.0), growth_1)
                })
            }

            /// Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body.
            fn inverse_mass(&self) -> [S; 3] {
                let mut inverse_mass = [S::lit(0.0); 3];
                let lit = S::lit;
                inverse_mass[0] = lit(0.01);
                inverse_mass[1] = lit(0.01);
                inverse_mass[2] = lit(100.0);
                inverse_mass
            }

            fn length(&self) -> S {
                S::lit(0.8)
            }

            fn start_position(&self) -> [Start<S>; 3] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 1] = [self.start.arm.of_centre([lit(0.0), lit(0.0)])];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn start_velocity(&self, q: &[S; 3]) -> [Start<S>; 3] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 1] =
                    [self.start.arm.velocity_of_centre([lit(0.0), lit(0.0)], q[2])];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }
        }

        impl<S: Real> State<S> {
            /// Reactions that redundancy leaves undetermined, by constraint row: none.
            pub fn undetermined(&self) -> [bool; 2] {
                [false; 2]
            }
        }

        impl<S: Real> rt::lanes::Pack for ArmOnJack<S> {
            type Packed<T: Scalar> = ArmOnJack<T>;

            #[allow(unused_variables)]
            fn pack<T: Scalar, const N: usize>(
                &self,
                all: [&Self; N],
                number: impl Fn([S; N]) -> T,
            ) -> ArmOnJack<T> {
                let same = |s| number([s; N]);
                let start = Starts {
                    arm: self.start.arm.map(same),
                    press_chamber1_pressure: self.start.press_chamber1_pressure.map(same),
                    press_chamber2_pressure: self.start.press_chamber2_pressure.map(same),
                    line1_flow: self.start.line1_flow.map(same),
                    line1_inlet_pressure: self.start.line1_inlet_pressure.map(same),
                    line2_flow: self.start.line2_flow.map(same),
                    line2_inlet_pressure: self.start.line2_inlet_pressure.map(same),
                    valve_servo_value: self.start.valve_servo_value.map(same),
                    valve_servo_swing: self.start.valve_servo_swing.map(same),
                };
                ArmOnJack {
                    start,
                    g: number(rt::Vector::from_fn(|i| all[i].g)),
                    rated_drop: number(rt::Vector::from_fn(|i| all[i].rated_drop)),
                    gas: number(rt::Vector::from_fn(|i| all[i].gas)),
                }
            }

            #[allow(unused_variables)]
            fn pack_held<T: Scalar, const N: usize>(
                first: &Held<S>,
                all: [&Held<S>; N],
                number: impl Fn([S; N]) -> T,
            ) -> Held<T> {
                let input = Input { none: core::marker::PhantomData };
                let switches = rt::Vector::from_fn(|k| number(rt::Vector::from_fn(|i| all[i].switches[k])));
                let of_loops = ();
                let mut turns = [T::ZERO.to_turns(); 1];
                for k in 0..1 {
                    turns[k] = number(rt::Vector::from_fn(|i| S::of_turns(all[i].turns[k]))).to_turns();
                }
                let contact = ();
                rt::Held { input, switches, turns, of_loops, contact }
            }

            const WATCHED: bool = true;
            #[inline]
            fn are_calm<T: Scalar>(typical: &[T; 10], t: T, held: &Held<T>, x: &[T; 10]) -> T {
                rt::turns::all_near(x, &[&[0]])
            }

            #[inline]
            fn are_short<T: Scalar>(typical: &[T; 10], held: &Held<T>, legs: [&[T; 10]; 2]) -> T {
                T::lit(1.0)
            }

            #[inline(never)]
            fn look<T: Scalar>(all: &ArmOnJack<T>, t: T, held: &mut Held<T>, x: &[T; 10], due: T) -> T {
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

        impl<S: Real> rt::Linear for ArmOnJack<S> {
            type Lifted<const K: usize> = ArmOnJack<rt::Dual<S, K>>;
            type In<T: Real> = ArmOnJack<T>;
            type Derivatives = rt::linalg::Sparse<S, Augmented<S>, 26, 34, 9>;

            fn lift<const K: usize>(
                &self,
                held: &Held<S>,
            ) -> (ArmOnJack<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                self.in_numbers(held, rt::Dual::constant)
            }

            fn in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (ArmOnJack<T>, Held<T>) {
                use rt::lanes::Pack;
                let of_one = |[s]: [S; 1]| number(s);
                (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
            }

            #[inline]
            fn rate_in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (ArmOnJack<T>, Held<T>) {
                let value = Start::free(T::ZERO);
                let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
                let start = Starts {
                    arm: zero,
                    press_chamber1_pressure: value,
                    press_chamber2_pressure: value,
                    line1_flow: value,
                    line1_inlet_pressure: value,
                    line2_flow: value,
                    line2_inlet_pressure: value,
                    valve_servo_value: value,
                    valve_servo_swing: value,
                };
                let own = ArmOnJack {
                    start,
                    g: number(self.g),
                    rated_drop: number(self.rated_drop),
                    gas: number(self.gas),
                };
                (own, <Self as rt::lanes::Pack>::pack_held(held, [held], |[s]: [S; 1]| number(s)))
            }

            fn differentiate(
                &self,
                t: S,
                u: &Self::U,
                x: &[S; 10],
                by_x: &mut Self::Derivatives,
                by_t: Option<&mut [S; 10]>,
            ) -> rt::Health<S> {
                let mut dx = [S::lit(0.0); 10];
                let health = rt::Rate::rate(self, t, u, x, &mut dx);
                self.linearised(t, u, x, &dx, &mut by_x.coefficients);
                match by_t {
                    Some(by_t) => self.jvp(t, u, x, (S::lit(1.0), &[S::lit(0.0); 10]), by_t),
                    None => health,
                }
            }
        }

        impl<S: Real> rt::Ports for ArmOnJack<S> {
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

        impl<S: Real> rt::Described for ArmOnJack<S> {
            const TABLES: &'static described::Tables = &described::Tables {
                name: "ArmOnJack",
                docs: "The arm of the manual, section 3.2.1.",
                report: described::Report {
                    rung: 2,
                    formulation: "joint coordinates",
                    reason: "the joints make a tree, so that no constraint is left",
                    operations: OPERATIONS,
                    degrees_of_freedom: NDOF,
                },
                bodies: &[described::Body {
                    name: "arm",
                    ports: &["tip", "jack", "o0"],
                    contour: 0,
                    first: 0,
                }],
                ground: &[
                    described::GroundPort { name: "o0", moves: false, first: 12 },
                    described::GroundPort { name: "foot", moves: false, first: 16 },
                ],
                parts: &[
                    described::Part {
                        name: "hinge",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 0 },
                            described::Frame { argument: "b", body: Some(0), port: 2 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 20,
                    },
                    described::Part {
                        name: "ram",
                        kind: "jack",
                        pair: None,
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 1 },
                            described::Frame { argument: "b", body: Some(0), port: 1 },
                        ],
                        sizes: &["free_length", "piston_diameter", "rod_diameter"],
                        first: 21,
                    },
                    described::Part {
                        name: "press",
                        kind: "cylinder",
                        pair: None,
                        frames: &[],
                        sizes: &[],
                        first: 24,
                    },
                    described::Part {
                        name: "line1",
                        kind: "oil_line",
                        pair: None,
                        frames: &[],
                        sizes: &[],
                        first: 24,
                    },
                    described::Part {
                        name: "line2",
                        kind: "oil_line",
                        pair: None,
                        frames: &[],
                        sizes: &[],
                        first: 24,
                    },
                    described::Part {
                        name: "valve",
                        kind: "servo_valve",
                        pair: None,
                        frames: &[],
                        sizes: &[],
                        first: 24,
                    },
                    described::Part {
                        name: "pump",
                        kind: "oil_source",
                        pair: None,
                        frames: &[],
                        sizes: &[],
                        first: 24,
                    },
                    described::Part {
                        name: "tank",
                        kind: "oil_tank",
                        pair: None,
                        frames: &[],
                        sizes: &[],
                        first: 24,
                    },
                    described::Part {
                        name: "command",
                        kind: "ramps",
                        pair: None,
                        frames: &[],
                        sizes: &[],
                        first: 24,
                    },
                ],
                parameters: &[
                    described::Quantity {
                        name: "g",
                        docs: "Acceleration of gravity; the manual's other runs had 9.80665 m/s^2.",
                        unit: "m/s^2",
                        factor: 1.0,
                        exponents: [1, 0, -2, 0, 0, 0, 0],
                        default: Some(9.81),
                    },
                    described::Quantity {
                        name: "rated_drop",
                        docs: "Pressure drop at which the valve lets 20 L/min through: not in the manual.",
                        unit: "bar",
                        factor: 100000.0,
                        exponents: [-1, 1, -2, 0, 0, 0, 0],
                        default: Some(100000.0),
                    },
                    described::Quantity {
                        name: "gas",
                        docs: "Share of undissolved gas in the oil: not in the manual.",
                        unit: "",
                        factor: 1.0,
                        exponents: [0, 0, 0, 0, 0, 0, 0],
                        default: Some(0.0),
                    },
                ],
                inputs: &[],
                states: &[
                    described::Quantity {
                        name: "press.chamber1.pressure",
                        docs: "",
                        unit: "bar",
                        factor: 100000.0,
                        exponents: [-1, 1, -2, 0, 0, 0, 0],
                        default: Some(0.0),
                    },
                    described::Quantity {
                        name: "press.chamber2.pressure",
                        docs: "",
                        unit: "bar",
                        factor: 100000.0,
                        exponents: [-1, 1, -2, 0, 0, 0, 0],
                        default: Some(500000.0),
                    },
                    described::Quantity {
                        name: "line1.flow",
                        docs: "",
                        unit: "L/min",
                        factor: 1.6666666666666667e-5,
                        exponents: [3, 0, -1, 0, 0, 0, 0],
                        default: Some(0.0),
                    },
                    described::Quantity {
                        name: "line1.inlet.pressure",
                        docs: "",
                        unit: "bar",
                        factor: 100000.0,
                        exponents: [-1, 1, -2, 0, 0, 0, 0],
                        default: Some(0.0),
                    },
                    described::Quantity {
                        name: "line2.flow",
                        docs: "",
                        unit: "L/min",
                        factor: 1.6666666666666667e-5,
                        exponents: [3, 0, -1, 0, 0, 0, 0],
                        default: Some(0.0),
                    },
                    described::Quantity {
                        name: "line2.inlet.pressure",
                        docs: "",
                        unit: "bar",
                        factor: 100000.0,
                        exponents: [-1, 1, -2, 0, 0, 0, 0],
                        default: Some(500000.0),
                    },
                    described::Quantity {
                        name: "valve.servo.value",
                        docs: "",
                        unit: "",
                        factor: 1.0,
                        exponents: [0, 0, 0, 0, 0, 0, 0],
                        default: Some(0.0),
                    },
                    described::Quantity {
                        name: "valve.servo.swing",
                        docs: "",
                        unit: "",
                        factor: 1.0,
                        exponents: [0, 0, 0, 0, 0, 0, 0],
                        default: Some(0.0),
                    },
                ],
                outputs: &[
                    described::Quantity {
                        name: "press.chamber1.pressure",
                        docs: "",
                        unit: "Pa",
                        factor: 1.0,
                        exponents: [-1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                    described::Quantity {
                        name: "press.chamber2.pressure",
                        docs: "",
                        unit: "Pa",
                        factor: 1.0,
                        exponents: [-1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                    described::Quantity {
                        name: "ram.length",
                        docs: "",
                        unit: "m",
                        factor: 1.0,
                        exponents: [1, 0, 0, 0, 0, 0, 0],
                        default: None,
                    },
                ],
                reads: &[
                    Some(described::Reads {
                        motion: described::Motion::Nothing,
                        time: false,
                        states: &[0],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Nothing,
                        time: false,
                        states: &[1],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Poses,
                        time: false,
                        states: &[],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Velocities,
                        time: false,
                        states: &[0, 2],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Velocities,
                        time: false,
                        states: &[1, 4],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Nothing,
                        time: false,
                        states: &[0, 2, 3],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Nothing,
                        time: false,
                        states: &[2, 3, 6],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Nothing,
                        time: false,
                        states: &[1, 4, 5],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Nothing,
                        time: false,
                        states: &[4, 5, 6],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Nothing,
                        time: false,
                        states: &[7],
                        inputs: &[],
                    }),
                    Some(described::Reads {
                        motion: described::Motion::Nothing,
                        time: true,
                        states: &[6, 7],
                        inputs: &[],
                    }),
                ],
            };
            const OBSERVED: &'static [(&'static str, &'static str)] = &State::<S>::OBSERVED;
            const DECLARATION: &'static str = "/// The arm of the manual, section 3.2.1.\npub ArmOnJack {\n    /// Acceleration of gravity; the manual's other runs had 9.80665 m/s^2.\n    param g: m/s^2 = 9.81 m/s^2;\n    /// Pressure drop at which the valve lets 20 L/min through: not in the manual.\n    param rated_drop: bar = 1 bar;\n    /// Share of undissolved gas in the oil: not in the manual.\n    param gas: 1 = 0;\n\n    gravity: g;\n    ground { port o0: (0, 0) m; port foot: (0, -0.25) m; }\n    body arm {\n        mass: 100 kg;\n        inertia: 0.01 kg*m^2;\n        port tip: (0.2, 0) m;\n        port jack: (-0.5, 0) m;\n        port o0: (-0.8, 0) m;\n        start angle: 20 deg, locked;\n    }\n    revolute hinge(ground.o0, arm.o0);\n    jack ram(ground.foot, arm.jack) { free_length: 0.22 m; }\n\n    cylinder press(ram.slider) {\n        piston_diameter: 50 mm;\n        rod_diameter: 30 mm;\n        stroke: 0.35 m;\n        friction: 1000 N/(m/s);\n        chamber1.oil.gas_content: gas;\n        chamber2.oil.gas_content: gas;\n        chamber2.pressure: 5 bar, locked;\n    }\n    oil_line line1(press.port1) { inlet.oil.gas_content: gas; }\n    oil_line line2(press.port2) { inlet.oil.gas_content: gas; inlet.pressure: 5 bar; }\n    servo_valve valve(pump.port, line1.port, line2.port, tank.port) {\n        signal: -0.2*command.value;\n        rated_drop: rated_drop;\n        frequency: 20 Hz;\n    }\n    oil_source pump() { pressure: 30 bar; }\n    oil_tank tank() { pressure: 5 bar; }\n    ramps command() {\n        duration1: 0.5 s;\n        duration2: 0.5 s; end2: 1;\n        duration3: 0.5 s; start3: 1; end3: 1;\n        duration4: 1 s; start4: 1;\n    }\n\n    output press.chamber1.pressure, press.chamber2.pressure, ram.length;\n}\n";
            const FILES: &'static [(&'static str, &'static str)] = &[];
            fn figure(&self, t: S, index: usize) -> Option<S> {
                let constants: &[f64] = const {
                    &[
                        100.0, 0.01, 0.0, 0.2, 0.0, 0.0, -0.5, 0.0, 0.0, -0.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
                        0.0, -0.25, 0.0, 0.0, 0.0, 0.22, 0.0, 0.0,
                    ]
                };
                constants.get(index).copied().map(S::lit)
            }

            fn parameter(&self, index: usize) -> Option<S> {
                match index {
                    0 => Some(self.g),
                    1 => Some(self.rated_drop),
                    2 => Some(self.gas),
                    _ => None,
                }
            }

            fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
                match index {
                    0 => Some(&mut self.g),
                    1 => Some(&mut self.rated_drop),
                    2 => Some(&mut self.gas),
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
                each("press.chamber1.pressure", &mut self.press_chamber1_pressure);
                each("press.chamber2.pressure", &mut self.press_chamber2_pressure);
                each("line1.flow", &mut self.line1_flow);
                each("line1.inlet.pressure", &mut self.line1_inlet_pressure);
                each("line2.flow", &mut self.line2_flow);
                each("line2.inlet.pressure", &mut self.line2_inlet_pressure);
                each("valve.servo.value", &mut self.valve_servo_value);
                each("valve.servo.swing", &mut self.valve_servo_swing);
            }
        }

        impl<S: Scalar> core::fmt::Display for Starts<S> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                rt::start::write_starts(*self, f)
            }
        }

        impl<S: Real> ArmOnJack<S> {
            fn placed(&self, x: &[S; 14]) -> Starts<S> {
                let lit = S::lit;
                Starts {
                    arm: self.start.arm.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[0], x[1], x[2]],
                        [x[3], x[4], x[5]],
                    ),
                    press_chamber1_pressure: self.start.press_chamber1_pressure.at(x[6]),
                    press_chamber2_pressure: self.start.press_chamber2_pressure.at(x[7]),
                    line1_flow: self.start.line1_flow.at(x[8]),
                    line1_inlet_pressure: self.start.line1_inlet_pressure.at(x[9]),
                    line2_flow: self.start.line2_flow.at(x[10]),
                    line2_inlet_pressure: self.start.line2_inlet_pressure.at(x[11]),
                    valve_servo_value: self.start.valve_servo_value.at(x[12]),
                    valve_servo_swing: self.start.valve_servo_swing.at(x[13]),
                }
            }
        }

        impl<S: Real> State<S> {
            /// Poses, velocities and states of this moment as start values, with the locks that are set: to go on from here
            /// later, `mechanism.start = sim.starts()`.
            pub fn starts(&self) -> Starts<S> {
                self.mechanism.placed(&<ArmOnJack<S> as rt::Statics>::full(self))
            }
        }

        impl<S: Real> rt::Statics for ArmOnJack<S> {
            type Full = [S; 14];
            type Rows = [S; 2];
            type Starts = Starts<S>;
            const COORDINATES: &'static [&'static str] = Self::LAYOUT_.coordinates;
            const ROWS: &'static [&'static str] = Self::LAYOUT_.rows;
            const STATES: &'static [(&'static str, &'static str)] = &[
                ("press.chamber1.pressure", "Pa"),
                ("press.chamber2.pressure", "Pa"),
                ("line1.flow", "m^3/s"),
                ("line1.inlet.pressure", "Pa"),
                ("line2.flow", "m^3/s"),
                ("line2.inlet.pressure", "Pa"),
                ("valve.servo.value", "no unit"),
                ("valve.servo.swing", "no unit"),
            ];
            fn full(state: &State<S>) -> [S; 14] {
                {
                    let mut x = state.absolute_();
                    rt::turns::add(&state.held.turns, &mut x, &[&[2]]);
                    x
                }
            }

            /// What vanishes at rest: applied forces `Q` (N, N, N m per body) that reactions do not balance, residuals of the
            /// constraints, rates of the first-order states, without accelerations.
            ///
            /// 54 add, 84 mul, 16 div, 1 neg, 9 sqrt, 1 sin_cos, 22 select.
            #[cold]
            fn equations(&self, t: S, u: &Self::U, x: &[S; 14], lambda: &[S; 2], each: &mut impl FnMut(S)) {
                let (mut force, mut x_dot) = ([S::lit(0.0); 3], [S::lit(0.0); 8]);
                let lit = S::lit;
                let by = rt::Factor;
                let arm_x = x[0];
                let arm_angle = x[2];
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                let t1 = by(-0.5).mul_add(cos_arm_angle, arm_x);
                let arm_y = x[1];
                let t2 = by(-0.5).mul_add(sin_arm_angle, arm_y) + lit(0.25);
                let t3 = t2.mul_add(t2, t1 * t1).sqrt();
                let t4 = by(1.0) / t3;
                let press_chamber1_pressure = x[6];
                let press_chamber2_pressure = x[7];
                let arm_vx = x[3];
                let arm_omega = x[5];
                let t5 = by(0.5) * arm_omega;
                let arm_vy = x[4];
                let t6 = t2
                    .mul_add((-t5).mul_add(cos_arm_angle, arm_vy), t1 * t5.mul_add(sin_arm_angle, arm_vx))
                    * t4;
                let t7 = lit(0.0).max(t3 - lit(0.57));
                let t8 = lit(0.0).max(lit(0.22) - t3);
                let t9 = by(-1000.0).mul_add(
                    t6,
                    by(-0.0012566370614359172)
                        .mul_add(press_chamber2_pressure, by(0.001963495408493621) * press_chamber1_pressure),
                ) - lit(0.0)
                    .max((by(1000.0) * lit(1.0).min(by(1000000.0) * t7)).mul_add(t6, by(100000000.0) * t7));
                let t10 = t9
                    + lit(0.0).max(
                        (-(by(1000.0) * lit(1.0).min(by(1000000.0) * t8))).mul_add(t6, by(100000000.0) * t8),
                    );
                let t11 = t4 * t10;
                force[0] = t1 * t11;
                let g = self.g;
                force[1] = by(-100.0).mul_add(g, t2 * t11);
                force[2] = by(-0.5) * t4 * (t10 * (-sin_arm_angle).mul_add(t1, cos_arm_angle * t2));
                let gas = self.gas;
                let t12 = by(1.0) / lit(1.0).max(press_chamber1_pressure + lit(101325.0));
                let t13 = gas * t12;
                let t14 = lit(1.0) - gas;
                let t15 = by(-5.88235294117647e-10) * t14;
                let line1_flow = x[8];
                let t16 = by(-101325.0).mul_add(t13, -t14)
                    * by(-0.001963495408493621).mul_add(t6, line1_flow)
                    / (by(0.001963495408493621).mul_add(t3, lit(-0.00038196898986859654))
                        * (-(by(101325.0) * t12)).mul_add(t13, t15));
                x_dot[0] = t16;
                let t17 = by(1.0) / lit(1.0).max(press_chamber2_pressure + lit(101325.0));
                let t18 = gas * t17;
                let line2_flow = x[10];
                let t19 = by(-101325.0).mul_add(t18, -t14)
                    * by(0.0012566370614359172).mul_add(t6, line2_flow)
                    / (by(-0.0012566370614359172).mul_add(t3, lit(0.0007662831250184729))
                        * (-(by(101325.0) * t17)).mul_add(t18, t15));
                x_dot[1] = t19;
                let line1_inlet_pressure = x[9];
                x_dot[2] = by(-5.774986495569473e-7)
                    * (by(5319492.958739931).mul_add(line1_flow, press_chamber1_pressure)
                        - line1_inlet_pressure);
                let t20 = by(1.0) / lit(1.0).max(line1_inlet_pressure + lit(101325.0));
                let t21 = gas * t20;
                let rated_drop = self.rated_drop;
                let valve_servo_value = x[12];
                let t22 = lit(-1.0).max(lit(1.0).min(valve_servo_value));
                let t23 = lit(0.0).max(t22);
                let t24 = line1_inlet_pressure - lit(3000000.0);
                let t25 = by(1.0) / rated_drop;
                let t26 = t24 * t25;
                let t27 = by(25000000.0) * (t25 * t25);
                let t28 = lit(0.0).max(-t22);
                let t29 = line1_inlet_pressure - lit(500000.0);
                let t30 = t25 * t29;
                let t31 = t23 * t24 / t26.mul_add(t26, t27).sqrt().sqrt()
                    + t28 * t29 / t30.mul_add(t30, t27).sqrt().sqrt();
                let t32 = by(-2037.1832715762603)
                    * by(-101325.0).mul_add(t21, -t14)
                    * (line1_flow + by(0.0003333333333333333) * t31 / rated_drop)
                    / (-(by(101325.0) * t20)).mul_add(t21, t15);
                x_dot[3] = t32;
                let line2_inlet_pressure = x[11];
                x_dot[4] = by(-5.774986495569473e-7)
                    * (by(5319492.958739931).mul_add(line2_flow, press_chamber2_pressure)
                        - line2_inlet_pressure);
                let t33 = by(1.0) / lit(1.0).max(line2_inlet_pressure + lit(101325.0));
                let t34 = gas * t33;
                let t35 = line2_inlet_pressure - lit(500000.0);
                let t36 = t25 * t35;
                let t37 = line2_inlet_pressure - lit(3000000.0);
                let t38 = t25 * t37;
                let t39 = t23 * t35 / t36.mul_add(t36, t27).sqrt().sqrt()
                    + t28 * t37 / t38.mul_add(t38, t27).sqrt().sqrt();
                let t40 = by(-2037.1832715762603)
                    * by(-101325.0).mul_add(t34, -t14)
                    * (line2_flow + by(0.0003333333333333333) * t39 / rated_drop)
                    / (-(by(101325.0) * t33)).mul_add(t34, t15);
                x_dot[5] = t40;
                let valve_servo_swing = x[13];
                x_dot[6] = by(125.66370614359172) * valve_servo_swing;
                let switch_9 = u.switches[9];
                let switch_8 = u.switches[8];
                let switch_7 = u.switches[7];
                let switch_6 = u.switches[6];
                let t41 = S::select(
                    switch_8.lt(lit(0.0)),
                    by(2.0).mul_add(t, lit(-1.0)),
                    S::select(
                        switch_7.lt(lit(0.0)),
                        lit(1.0),
                        S::select(switch_6.lt(lit(0.0)), lit(2.5) - t, lit(0.0)),
                    ),
                );
                let t42 = by(-25.132741228718345).mul_add(
                    S::select(switch_9.lt(lit(0.0)), lit(0.0), t41),
                    by(-201.06192982974676)
                        .mul_add(valve_servo_swing, by(-125.66370614359172) * valve_servo_value),
                );
                x_dot[7] = t42;
                let (q, _): ([S; 3], [S; 3]) = absolute::split(x);
                absolute::balance::<S, Self, NQ, NC>(self, t, &q, lambda, &force)
                    .into_iter()
                    .for_each(&mut *each);
                absolute::residuals::<S, Self, NQ, NC, 14>(self, t, x, each);
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

            fn starts_at(&self, x: &[S; 14]) -> Starts<S> {
                self.placed(x)
            }

            fn size(&self) -> S {
                absolute::Absolute::<S, NQ, NC>::length(self)
            }
        }

        impl<S: Scalar> ArmOnJack<S> {
            /// The right-hand side in joint coordinates.
            ///
            /// 54 add, 89 mul, 16 div, 1 neg, 9 sqrt, 1 sin_cos, 22 select.
            #[inline(always)]
            fn motion(&self, t: S, u: &Held<S>, x: &[S; 10], dx: &mut [S; 10]) {
                let lit = S::lit;
                let by = rt::Factor;
                // Masses and forces along the coordinates: M a = Q
                let arm_angle = x[0];
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                let t1 = by(-0.8).mul_add(cos_arm_angle, by(0.5) * cos_arm_angle);
                let t2 = by(-0.8).mul_add(sin_arm_angle, by(0.5) * sin_arm_angle) - lit(0.25);
                let t3 = t2.mul_add(t2, t1 * t1).sqrt();
                let t4 = by(1.0) / t3;
                let press_chamber1_pressure = x[2];
                let press_chamber2_pressure = x[3];
                let arm_omega = x[1];
                let t5 = arm_omega * sin_arm_angle;
                let t6 = arm_omega * cos_arm_angle;
                let t7 = (-t2)
                    .mul_add(by(-0.8).mul_add(t6, by(0.5) * t6), t1 * by(-0.8).mul_add(t5, by(0.5) * t5));
                let t8 = t7 * t4;
                let t9 = lit(0.0).max(t3 - lit(0.57));
                let t10 = lit(0.0).max(lit(0.22) - t3);
                let t11 = by(1000.0).mul_add(
                    t8,
                    by(-0.0012566370614359172)
                        .mul_add(press_chamber2_pressure, by(0.001963495408493621) * press_chamber1_pressure),
                ) - lit(0.0).max(
                    (-(by(1000.0) * lit(1.0).min(by(1000000.0) * t9))).mul_add(t8, by(100000000.0) * t9),
                );
                let t12 = t11
                    + lit(0.0).max(
                        (by(1000.0) * lit(1.0).min(by(1000000.0) * t10)).mul_add(t8, by(100000000.0) * t10),
                    );
                let t13 = t4 * t12;
                let g = self.g;
                let still_0 = (-cos_arm_angle)
                    .mul_add((by(0.3) * t2).mul_add(t13, by(80.0) * g), by(0.3) * sin_arm_angle * t1 * t13);
                // Results
                dx[0] = arm_omega;
                dx[1] = by(0.015622558975160131) * still_0;
                let gas = self.gas;
                let t14 = by(1.0) / lit(1.0).max(press_chamber1_pressure + lit(101325.0));
                let t15 = gas * t14;
                let t16 = lit(1.0) - gas;
                let t17 = by(-5.88235294117647e-10) * t16;
                let line1_flow = x[4];
                let t18 = by(-101325.0).mul_add(t15, -t16) * by(0.001963495408493621).mul_add(t8, line1_flow)
                    / ((-(by(101325.0) * t14)).mul_add(t15, t17)
                        * by(0.001963495408493621).mul_add(t3, lit(-0.00038196898986859654)));
                dx[2] = t18;
                let t19 = by(1.0) / lit(1.0).max(press_chamber2_pressure + lit(101325.0));
                let t20 = gas * t19;
                let line2_flow = x[6];
                let t21 = by(101325.0).mul_add(t20, t16) * by(-0.0012566370614359172).mul_add(t8, line2_flow)
                    / ((-(by(101325.0) * t19)).mul_add(t20, t17)
                        * by(0.0012566370614359172).mul_add(t3, lit(-0.0007662831250184729)));
                dx[3] = t21;
                let line1_inlet_pressure = x[5];
                dx[4] = by(-5.774986495569473e-7)
                    * (by(5319492.958739931).mul_add(line1_flow, press_chamber1_pressure)
                        - line1_inlet_pressure);
                let t22 = by(1.0) / lit(1.0).max(line1_inlet_pressure + lit(101325.0));
                let t23 = gas * t22;
                let rated_drop = self.rated_drop;
                let valve_servo_value = x[8];
                let t24 = lit(-1.0).max(lit(1.0).min(valve_servo_value));
                let t25 = lit(0.0).max(t24);
                let t26 = line1_inlet_pressure - lit(3000000.0);
                let t27 = by(1.0) / rated_drop;
                let t28 = t26 * t27;
                let t29 = by(25000000.0) * (t27 * t27);
                let t30 = lit(0.0).max(-t24);
                let t31 = line1_inlet_pressure - lit(500000.0);
                let t32 = t27 * t31;
                let t33 = t25 * t26 / t28.mul_add(t28, t29).sqrt().sqrt()
                    + t30 * t31 / t32.mul_add(t32, t29).sqrt().sqrt();
                let t34 = by(-2037.1832715762603)
                    * by(-101325.0).mul_add(t23, -t16)
                    * (line1_flow + by(0.0003333333333333333) * t33 / rated_drop)
                    / (-(by(101325.0) * t22)).mul_add(t23, t17);
                dx[5] = t34;
                let line2_inlet_pressure = x[7];
                dx[6] = by(-5.774986495569473e-7)
                    * (by(5319492.958739931).mul_add(line2_flow, press_chamber2_pressure)
                        - line2_inlet_pressure);
                let t35 = by(1.0) / lit(1.0).max(line2_inlet_pressure + lit(101325.0));
                let t36 = gas * t35;
                let t37 = line2_inlet_pressure - lit(500000.0);
                let t38 = t27 * t37;
                let t39 = line2_inlet_pressure - lit(3000000.0);
                let t40 = t27 * t39;
                let t41 = t25 * t37 / t38.mul_add(t38, t29).sqrt().sqrt()
                    + t30 * t39 / t40.mul_add(t40, t29).sqrt().sqrt();
                let t42 = by(-2037.1832715762603)
                    * by(-101325.0).mul_add(t36, -t16)
                    * (line2_flow + by(0.0003333333333333333) * t41 / rated_drop)
                    / (-(by(101325.0) * t35)).mul_add(t36, t17);
                dx[7] = t42;
                let valve_servo_swing = x[9];
                dx[8] = by(125.66370614359172) * valve_servo_swing;
                let switch_9 = u.switches[9];
                let switch_8 = u.switches[8];
                let switch_7 = u.switches[7];
                let switch_6 = u.switches[6];
                let t43 = S::select(
                    switch_8.lt(lit(0.0)),
                    by(2.0).mul_add(t, lit(-1.0)),
                    S::select(
                        switch_7.lt(lit(0.0)),
                        lit(1.0),
                        S::select(switch_6.lt(lit(0.0)), lit(2.5) - t, lit(0.0)),
                    ),
                );
                let t44 = by(-25.132741228718345).mul_add(
                    S::select(switch_9.lt(lit(0.0)), lit(0.0), t43),
                    by(-201.06192982974676)
                        .mul_add(valve_servo_swing, by(-125.66370614359172) * valve_servo_value),
                );
                dx[9] = t44;
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            ///
            /// 6 mul, 1 sin_cos.
            #[inline]
            fn pose(&self, t: S, u: &Held<S>, x: &[S; 10], q: &mut [S; 3], v: &mut [S; 3]) {
                let [arm_angle, arm_omega, ..] = *x;
                let by = rt::Factor;
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                q[0] = by(0.8) * cos_arm_angle;
                q[1] = by(0.8) * sin_arm_angle;
                q[2] = arm_angle;
                v[0] = by(-0.8) * arm_omega * sin_arm_angle;
                v[1] = by(0.8) * arm_omega * cos_arm_angle;
                v[2] = arm_omega;
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart(&self, t: S, q: &[S; 3], v: &[S; 3], x: &mut [S; 10]) {
                x[0] = q[2];
                x[1] = v[2];
            }

            /// How far every condition is from switching: positive while the side that is held applies; then what bends where it passes zero.
            ///
            /// 25 add, 29 mul, 1 div, 3 neg, 1 sqrt, 1 sin_cos, 6 select.
            fn switching(&self, t: S, u: &Held<S>, x: &[S; 10], g: &mut [S; 19]) {
                let lit = S::lit;
                let by = rt::Factor;
                let switch_0 = u.switches[0];
                let arm_angle = x[0];
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                let t1 = by(-0.8).mul_add(cos_arm_angle, by(0.5) * cos_arm_angle);
                let t2 = by(-0.8).mul_add(sin_arm_angle, by(0.5) * sin_arm_angle) - lit(0.25);
                let t3 = t2.mul_add(t2, t1 * t1).sqrt();
                g[0] = switch_0 * by(0.001963495408493621).mul_add(t3, lit(-0.0003819690898685966));
                let press_chamber1_pressure = x[2];
                let switch_1 = u.switches[1];
                g[1] = (press_chamber1_pressure + lit(101325.0)) * switch_1;
                let switch_2 = u.switches[2];
                g[2] = switch_2 * by(-0.0012566370614359172).mul_add(t3, lit(0.0007662830250184728));
                let press_chamber2_pressure = x[3];
                let switch_3 = u.switches[3];
                g[3] = (press_chamber2_pressure + lit(101325.0)) * switch_3;
                let line1_inlet_pressure = x[5];
                let switch_4 = u.switches[4];
                g[4] = (line1_inlet_pressure + lit(101325.0)) * switch_4;
                let line2_inlet_pressure = x[7];
                let switch_5 = u.switches[5];
                g[5] = (line2_inlet_pressure + lit(101325.0)) * switch_5;
                g[6] = lit(-101324.0) - press_chamber1_pressure;
                g[7] = lit(-101324.0) - press_chamber2_pressure;
                let t4 = t3 - lit(0.57);
                g[8] = -t4;
                let t5 = t3 - lit(0.22);
                g[9] = t5;
                let t6 = lit(0.0).max(t4);
                let t7 = by(1000000.0) * t6;
                g[10] = lit(1.0) - t7;
                let arm_omega = x[1];
                let t8 = arm_omega * sin_arm_angle;
                let t9 = arm_omega * cos_arm_angle;
                let t10 = (-t2)
                    .mul_add(by(-0.8).mul_add(t9, by(0.5) * t9), t1 * by(-0.8).mul_add(t8, by(0.5) * t8));
                let t11 = by(1000.0) * (t10 / t3);
                g[11] = by(-100000000.0).mul_add(t6, t11 * lit(1.0).min(t7));
                let t12 = lit(0.0).max(-t5);
                let t13 = by(1000000.0) * t12;
                g[12] = lit(1.0) - t13;
                g[13] = (-t11).mul_add(lit(1.0).min(t13), by(-100000000.0) * t12);
                g[14] = lit(-101324.0) - line1_inlet_pressure;
                g[15] = lit(-101324.0) - line2_inlet_pressure;
                let valve_servo_value = x[8];
                g[16] = lit(1.0) - valve_servo_value;
                let t14 = lit(1.0).min(valve_servo_value);
                g[17] = lit(-1.0) - t14;
                g[18] = -lit(-1.0).max(t14);
            }
        }

        impl<S: Scalar> ArmOnJack<S> {
            /// The coefficients of the linearised equations before anything is eliminated; `dx` is the rate there.
            ///
            /// 81 add, 204 mul, 25 div, 4 neg, 9 sqrt, 1 sin_cos, 44 select.
            fn linearised(&self, t: S, u: &Held<S>, x: &[S; 10], dx: &[S; 10], c: &mut [S; 26]) {
                let lit = S::lit;
                let by = rt::Factor;
                // Derivatives of M a - Q and of the rates of the states
                let g = self.g;
                let arm_angle = x[0];
                let (sin_arm_angle, cos_arm_angle) = arm_angle.sin_cos();
                let t1 = by(-0.8).mul_add(cos_arm_angle, by(0.5) * cos_arm_angle);
                let t2 = by(-0.8).mul_add(sin_arm_angle, by(0.5) * sin_arm_angle) - lit(0.25);
                let t3 = t2.mul_add(t2, t1 * t1);
                let t4 = t3.sqrt();
                let t5 = by(1.0) / t4;
                let press_chamber1_pressure = x[2];
                let press_chamber2_pressure = x[3];
                let arm_omega = x[1];
                let t6 = arm_omega * sin_arm_angle;
                let t7 = by(-0.8).mul_add(t6, by(0.5) * t6);
                let t8 = arm_omega * cos_arm_angle;
                let t9 = by(-0.8).mul_add(t8, by(0.5) * t8);
                let t10 = (-t2).mul_add(t9, t1 * t7);
                let t11 = t10 * t5;
                let t12 = t4 - lit(0.57);
                let t13 = lit(0.0).max(t12);
                let t14 = by(1000000.0) * t13;
                let t15 = lit(1.0).min(t14);
                let t16 = (-(by(1000.0) * t15)).mul_add(t11, by(100000000.0) * t13);
                let t17 = lit(0.22) - t4;
                let t18 = lit(0.0).max(t17);
                let t19 = by(1000000.0) * t18;
                let t20 = lit(1.0).min(t19);
                let t21 = (by(1000.0) * t20).mul_add(t11, by(100000000.0) * t18);
                let t22 = by(1000.0).mul_add(
                    t11,
                    by(-0.0012566370614359172)
                        .mul_add(press_chamber2_pressure, by(0.001963495408493621) * press_chamber1_pressure),
                ) - lit(0.0).max(t16)
                    + lit(0.0).max(t21);
                let t23 = (-sin_arm_angle).mul_add(t1, cos_arm_angle * t2);
                let t24 = t23 / t3;
                let t25 = (-cos_arm_angle).mul_add(
                    by(-0.3).mul_add(t1, by(0.09) * t2 * t24),
                    sin_arm_angle * (by(0.09) * t1).mul_add(t24, by(0.3) * t2),
                );
                let t26 = (-arm_omega).mul_add(
                    sin_arm_angle.mul_add(t2, cos_arm_angle * t1),
                    cos_arm_angle.mul_add(t9, sin_arm_angle * t7),
                );
                let t27 = t5 * t10.mul_add(t24, t26);
                let t28 = t16.lt(lit(0.0));
                let t29 = t5 * t23;
                let t30 = S::select(t12.lt(lit(0.0)), lit(0.0), by(-0.3) * t29);
                let t31 = by(300.0) * t15;
                let t32 = t10
                    * t31.mul_add(
                        t24,
                        by(1000.0) * S::select(lit(1.0).lt(t14), lit(0.0), by(1000000.0) * t30),
                    );
                let t33 = t21.lt(lit(0.0));
                let t34 = S::select(t17.lt(lit(0.0)), lit(0.0), by(0.3) * t29);
                let t35 = by(300.0) * t20;
                let t36 = t10
                    * t35.mul_add(
                        t24,
                        by(1000.0) * S::select(lit(1.0).lt(t19), lit(0.0), by(1000000.0) * t34),
                    );
                let t37 = by(300.0).mul_add(
                    t27,
                    -S::select(t28, lit(0.0), (-t5).mul_add(t31.mul_add(t26, t32), by(100000000.0) * t30)),
                );
                let t38 =
                    t37 + S::select(t33, lit(0.0), t5.mul_add(t35.mul_add(t26, t36), by(100000000.0) * t34));
                let t39 = (-t5).mul_add(
                    (-(by(0.3) * t23)).mul_add(t38, t22 * (t25 + lit(0.09))),
                    by(-80.0) * g * sin_arm_angle,
                );
                let t40 = by(300.0).mul_add(t29, -S::select(t28, lit(0.0), by(-300.0) * t15 * t29))
                    + S::select(t33, lit(0.0), t35 * t29);
                let gas = self.gas;
                let t41 = press_chamber1_pressure + lit(101325.0);
                let t42 = by(1.0) / lit(1.0).max(t41);
                let t43 = gas * t42;
                let t44 = lit(1.0) - gas;
                let t45 = by(-101325.0).mul_add(t43, -t44);
                let t46 = by(-5.88235294117647e-10) * t44;
                let t47 = by(1.0) / (-(by(101325.0) * t42)).mul_add(t43, t46);
                let t48 = by(1.0) / by(0.001963495408493621).mul_add(t4, lit(-0.00038196898986859654));
                let line1_flow = x[4];
                let t49 = by(0.001963495408493621).mul_add(t11, line1_flow);
                let t50 = t29 * t48;
                let t51 = t45 * t47;
                let t52 = t49
                    * (S::select(t41.lt(lit(1.0)), lit(0.0), lit(1.0))
                        * (-(by(202650.0) * t42)).mul_add(t51, lit(101325.0)));
                let t53 = press_chamber2_pressure + lit(101325.0);
                let t54 = by(1.0) / lit(1.0).max(t53);
                let t55 = gas * t54;
                let t56 = by(-101325.0).mul_add(t55, -t44);
                let t57 = by(1.0) / (-(by(101325.0) * t54)).mul_add(t55, t46);
                let t58 = by(1.0) / by(0.0012566370614359172).mul_add(t4, lit(-0.0007662831250184729));
                let line2_flow = x[6];
                let t59 = by(-0.0012566370614359172).mul_add(t11, line2_flow);
                let t60 = t29 * t58;
                let t61 = t56 * t57;
                let t62 = t59
                    * (S::select(t53.lt(lit(1.0)), lit(0.0), lit(1.0))
                        * (-(by(202650.0) * t54)).mul_add(t61, lit(101325.0)));
                let line1_inlet_pressure = x[5];
                let t63 = line1_inlet_pressure + lit(101325.0);
                let t64 = by(1.0) / lit(1.0).max(t63);
                let t65 = gas * t64;
                let t66 = by(-101325.0).mul_add(t65, -t44);
                let t67 = by(1.0) / (-(by(101325.0) * t64)).mul_add(t65, t46);
                let t68 = t66 * t67;
                let rated_drop = self.rated_drop;
                let t69 = by(1.0) / rated_drop;
                let t70 = line1_inlet_pressure - lit(3000000.0);
                let t71 = t70 * t69;
                let t72 = by(25000000.0) * (t69 * t69);
                let t73 = t71.mul_add(t71, t72);
                let valve_servo_value = x[8];
                let t74 = lit(-1.0).max(lit(1.0).min(valve_servo_value));
                let t75 = lit(0.0).max(t74);
                let t76 = by(1.0) / t73.sqrt().sqrt();
                let t77 = t75 * t76;
                let t78 = t70 * t77;
                let t79 = line1_inlet_pressure - lit(500000.0);
                let t80 = t69 * t79;
                let t81 = t80.mul_add(t80, t72);
                let t82 = -t74;
                let t83 = lit(0.0).max(t82);
                let t84 = by(1.0) / t81.sqrt().sqrt();
                let t85 = t83 * t84;
                let t86 = t79 * t85;
                let t87 = rated_drop * rated_drop;
                let t88 = by(0.6790610905254201).mul_add(
                    t77 + t85,
                    -(by(0.33953054526271004) * (t70 * t78 / t73 + t79 * t86 / t81) / t87),
                );
                let t89 = (line1_flow + by(0.0003333333333333333) * (t78 + t86) / rated_drop)
                    * (S::select(t63.lt(lit(1.0)), lit(0.0), lit(1.0))
                        * (-(by(412835189.98492914) * t64)).mul_add(t68, lit(206417594.99246457)));
                let t90 = S::select(
                    valve_servo_value.lt(lit(-1.0)),
                    lit(0.0),
                    S::select(lit(1.0).lt(valve_servo_value), lit(0.0), lit(1.0)),
                );
                let t91 = S::select(valve_servo_value.lt(lit(0.0)), lit(0.0), t90);
                let t92 = S::select(t82.lt(lit(0.0)), lit(0.0), -t90);
                let t93 = by(0.6790610905254201) * t68 * (t69 * (t79 * t92).mul_add(t84, t70 * t91 * t76));
                let line2_inlet_pressure = x[7];
                let t94 = line2_inlet_pressure + lit(101325.0);
                let t95 = by(1.0) / lit(1.0).max(t94);
                let t96 = gas * t95;
                let t97 = by(-101325.0).mul_add(t96, -t44);
                let t98 = by(1.0) / (-(by(101325.0) * t95)).mul_add(t96, t46);
                let t99 = t97 * t98;
                let t100 = line2_inlet_pressure - lit(500000.0);
                let t101 = t69 * t100;
                let t102 = t101.mul_add(t101, t72);
                let t103 = by(1.0) / t102.sqrt().sqrt();
                let t104 = t75 * t103;
                let t105 = t100 * t104;
                let t106 = line2_inlet_pressure - lit(3000000.0);
                let t107 = t69 * t106;
                let t108 = t107.mul_add(t107, t72);
                let t109 = by(1.0) / t108.sqrt().sqrt();
                let t110 = t83 * t109;
                let t111 = t106 * t110;
                let t112 = by(0.6790610905254201).mul_add(
                    t104 + t110,
                    -(by(0.33953054526271004) * (t100 * t105 / t102 + t106 * t111 / t108) / t87),
                );
                let t113 = (line2_flow + by(0.0003333333333333333) * (t105 + t111) / rated_drop)
                    * (S::select(t94.lt(lit(1.0)), lit(0.0), lit(1.0))
                        * (-(by(412835189.98492914) * t95)).mul_add(t99, lit(206417594.99246457)));
                let t114 =
                    by(0.6790610905254201) * t99 * (t69 * (t106 * t92).mul_add(t109, t100 * t91 * t103));
                // Results
                c[0] = t39;
                c[1] = by(0.3) * t5 * (t23 * t40);
                c[2] = lit(64.01);
                c[3] = by(0.0005890486225480862) * t29;
                c[4] = by(-0.0003769911184307752) * t29;
                c[5] = by(-0.0005890486225480862) * t45 * (t47 * (t48 * t49.mul_add(t50, t27)));
                c[6] = by(-0.0005890486225480862) * t50 * t51;
                c[7] = -(gas * (t42 * (t42 * (t47 * (t48 * t52)))));
                c[8] = lit(1.0);
                c[9] = -(t48 * t51);
                c[10] = by(0.0003769911184307752) * t56 * (t57 * (t58 * t59.mul_add(t60, -t27)));
                c[11] = by(-0.0003769911184307752) * t60 * t61;
                c[12] = gas * (t54 * (t54 * (t57 * (t58 * t62))));
                c[13] = t58 * t61;
                c[14] = lit(5.774986495569473e-7);
                c[15] = lit(3.072);
                c[16] = lit(-5.774986495569473e-7);
                c[17] = by(2037.1832715762603) * t68;
                c[18] = t67 * gas.mul_add(t64 * (t64 * t89), t66 * (t69 * t88));
                c[19] = t93;
                c[20] = by(2037.1832715762603) * t99;
                c[21] = t98 * gas.mul_add(t95 * (t95 * t113), t97 * (t69 * t112));
                c[22] = t114;
                c[23] = lit(-125.66370614359172);
                c[24] = lit(125.66370614359172);
                c[25] = lit(201.06192982974676);
            }
        }

        /// Places of the coefficients of the linearised equations, and the order of their elimination.
        #[doc(hidden)]
        #[derive(Clone, Copy, Debug)]
        pub struct Augmented<S>(core::marker::PhantomData<S>);

        impl<S: Real> rt::linalg::Patterned for Augmented<S> {
            const PATTERN: rt::linalg::Pattern = rt::linalg::Pattern {
                coordinates: 1,
                states: 8,
                terms: const {
                    &rt::compact::terms::<36>(&rt::compact::numbers::<180>(&[(
                        1,
                        &[
                            0, 0, 0, 3, 2, 1, 0, 0, 3, 3, 2, 0, 0, 3, 4, 3, 0, 1, 6, 0, 4, 0, 2, 7, 0, 5, 1,
                            0, 4, 2, 6, 1, 0, 4, 3, 7, 1, 1, 8, 0, 8, 1, 1, 8, 1, 9, 1, 3, 12, 0, 10, 2, 0,
                            5, 2, 11, 2, 0, 5, 3, 12, 2, 2, 13, 0, 8, 2, 2, 13, 1, 13, 2, 5, 17, 0, 14, 3, 1,
                            10, 0, 15, 3, 3, 18, 0, 8, 3, 3, 18, 1, 16, 3, 4, 21, 0, 17, 4, 3, 19, 0, 18, 4,
                            4, 23, 0, 8, 4, 4, 23, 1, 19, 4, 7, 26, 0, 14, 5, 2, 15, 0, 15, 5, 5, 27, 0, 8,
                            5, 5, 27, 1, 16, 5, 6, 29, 0, 20, 6, 5, 28, 0, 21, 6, 6, 31, 0, 8, 6, 6, 31, 1,
                            22, 6, 7, 32, 0, 8, 7, 7, 33, 1, 23, 7, 8, 1, 0, 24, 8, 7, 2, 0, 25, 8, 8, 0, 0,
                            8, 8, 8, 0, 1,
                        ],
                        &[],
                    )]))
                },
                pivots: const {
                    &rt::compact::pivots::<9>(&rt::compact::numbers::<63>(&[
                        (1, &[8, 0, 0, 1, 0, 1, 0, 0, 3, 1], &[]),
                        (4, &[3, 1, 3, 1, 1, 8, 3], &[2, 2, 2, 4, 1, 5, 2]),
                        (
                            1,
                            &[
                                10, 9, 11, 17, 5, 27, 10, 11, 11, 13, 19, 6, 31, 11, 11, 13, 14, 21, 7, 33,
                                11, 11, 14, 14, 21,
                            ],
                            &[],
                        ),
                    ]))
                },
                below: const {
                    &rt::compact::below::<11>(&rt::compact::numbers::<33>(&[(
                        1,
                        &[
                            7, 1, 2, 1, 4, 6, 2, 5, 7, 2, 9, 11, 3, 10, 12, 3, 14, 16, 5, 15, 17, 4, 19, 21,
                            5, 20, 22, 5, 24, 25, 6, 28, 29,
                        ],
                        &[],
                    )]))
                },
                right: const {
                    &rt::compact::pairs::<14>(&rt::compact::numbers::<28>(&[(
                        1,
                        &[
                            7, 2, 1, 6, 2, 7, 2, 11, 3, 12, 3, 16, 5, 17, 4, 21, 5, 22, 5, 25, 7, 26, 6, 29,
                            7, 30, 7, 32,
                        ],
                        &[],
                    )]))
                },
                targets: const {
                    &rt::compact::numbers::<21>(&[(
                        1,
                        &[33, 8, 11, 9, 13, 13, 16, 14, 18, 18, 22, 20, 27, 23, 25, 24, 27, 27, 30, 31, 32],
                        &[],
                    )])
                },
            };
        }

        impl<S: Scalar> ArmOnJack<S> {
            /// Times at which conditions change, s, and the slope of what they compare.
            #[cold]
            fn instants(&self, u: &Held<S>, at: &mut [S; 4], slope: &mut [S; 4]) {
                let lit = S::lit;
                at[0] = lit(2.5);
                at[1] = lit(1.5);
                at[2] = lit(1.0);
                at[3] = lit(0.5);
                slope[0] = lit(1.0);
                slope[1] = lit(1.0);
                slope[2] = lit(1.0);
                slope[3] = lit(1.0);
            }
        }
    }
}
