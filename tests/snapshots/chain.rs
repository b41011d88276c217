#[doc(inline)]
#[allow(unreachable_pub)]
pub use plm_chain_::chain::Chain;

#[doc(inline)]
#[allow(unreachable_pub, unused_imports)]
pub use plm_chain_::chain;
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]
mod plm_chain_ {
    /// A chain of five bars: elimination body by body.
    ///
    /// 5 bodies, 5 parts: 15 coordinates, 10 constraint rows, F = 3 N - M = 5.
    /// Formulation 2: joint coordinates; the joints make a tree, so that no constraint is left.
    /// Coordinates: bar[0].angle, bar[1].angle, bar[2].angle, bar[3].angle, bar[4].angle.
    /// Accelerations by a dense mass matrix.
    /// State: 10 numbers, 80 bytes in f64.
    /// A solution by rank, where one is needed: 2000 bytes of stack in f64.
    /// One right-hand side: 81 add, 144 mul, 4 div, 5 sin_cos.
    ///
    /// | row | constraint | equation | unit |
    /// |----:|------------|----------|------|
    /// | 0 | `first.x` | `bar[0].x - 0.5*cos(bar[0].angle) = 0` | m |
    /// | 1 | `first.y` | `bar[0].y - 0.5*sin(bar[0].angle) = 0` | m |
    /// | 2 | `pin[1].x` | `bar[1].x - bar[0].x - 0.5*cos(bar[0].angle) - 0.5*cos(bar[1].angle) = 0` | m |
    /// | 3 | `pin[1].y` | `bar[1].y - bar[0].y - 0.5*sin(bar[0].angle) - 0.5*sin(bar[1].angle) = 0` | m |
    /// | 4 | `pin[2].x` | `bar[2].x - bar[1].x - 0.5*cos(bar[1].angle) - 0.5*cos(bar[2].angle) = 0` | m |
    /// | 5 | `pin[2].y` | `bar[2].y - bar[1].y - 0.5*sin(bar[1].angle) - 0.5*sin(bar[2].angle) = 0` | m |
    /// | 6 | `pin[3].x` | `bar[3].x - bar[2].x - 0.5*cos(bar[2].angle) - 0.5*cos(bar[3].angle) = 0` | m |
    /// | 7 | `pin[3].y` | `bar[3].y - bar[2].y - 0.5*sin(bar[2].angle) - 0.5*sin(bar[3].angle) = 0` | m |
    /// | 8 | `pin[4].x` | `bar[4].x - bar[3].x - 0.5*cos(bar[3].angle) - 0.5*cos(bar[4].angle) = 0` | m |
    /// | 9 | `pin[4].y` | `bar[4].y - bar[3].y - 0.5*sin(bar[3].angle) - 0.5*sin(bar[4].angle) = 0` | m |
    pub mod chain {
        pub use super::code_::*;
        pub use super::type_::Chain;
    }

    mod type_ {
        /// A chain of five bars: elimination body by body.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Chain<S = ::core::primitive::f64> {
            /// Start values of the bodies, and which of them assembly keeps.
            pub start: super::code_::Starts<S>,
        }
    }

    mod code_ {
        use super::type_::Chain;
        use ::plm::runtime::generated as rt;
        use ::plm::runtime::generated::lanes::Two;
        use ::plm::runtime::generated::{
            BodyStart, BodyState, Fault, Method, Operations, Real, Scalar, Sim, Start,
        };
        use ::plm::runtime::generated::{absolute, described};

        /// Start values, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Starts<S = f64> {
            /// Origin of body `bar[0]`.
            pub bar_0: BodyStart<S>,
            /// Origin of body `bar[1]`.
            pub bar_1: BodyStart<S>,
            /// Origin of body `bar[2]`.
            pub bar_2: BodyStart<S>,
            /// Origin of body `bar[3]`.
            pub bar_3: BodyStart<S>,
            /// Origin of body `bar[4]`.
            pub bar_4: BodyStart<S>,
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
        type Held<S> = rt::Held<Input<S>, [S; 0], [<S as Scalar>::Turns; 5], ()>;

        /// Pose, accelerations and a vector, which outputs have in common.
        type Common<S> = rt::Common<([S; 15], [S; 15]), Held<S>, ([S; 15], [S; 10]), [S; 2]>;

        /// The mechanism at one moment; its methods read poses and outputs, `input` has the inputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: Chain<S>,
            held: rt::Held<Input<S>, [S; 0], [i32; 5], ()>,
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
        pub const NQ: usize = 15;
        /// Constraint rows.
        pub const NC: usize = 10;
        /// First-order states.
        pub const NX: usize = 0;
        /// Degrees of freedom, `3 N - M`.
        pub const NDOF: isize = 5;
        /// Operations of one evaluation of the right-hand side.
        pub const OPERATIONS: Operations =
            Operations { add: 81, mul: 144, div: 4, sqrt: 0, sin_cos: 5, other: 0 };
        impl<S: Real> State<S> {
            /// Time, s.
            pub fn time(&self) -> S {
                self.time
            }

            /// Pose and velocity of G of body `bar[0]`: m, m, rad; m/s, m/s, rad/s.
            pub fn bar_0(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[0], q[1], rt::turns::whole(q[2], self.held.turns[0])], [v[0], v[1], v[2]])
            }

            /// Pose and velocity of G of body `bar[1]`: m, m, rad; m/s, m/s, rad/s.
            pub fn bar_1(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[3], q[4], rt::turns::whole(q[5], self.held.turns[1])], [v[3], v[4], v[5]])
            }

            /// Pose and velocity of G of body `bar[2]`: m, m, rad; m/s, m/s, rad/s.
            pub fn bar_2(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[6], q[7], rt::turns::whole(q[8], self.held.turns[2])], [v[6], v[7], v[8]])
            }

            /// Pose and velocity of G of body `bar[3]`: m, m, rad; m/s, m/s, rad/s.
            pub fn bar_3(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of(
                    [q[9], q[10], rt::turns::whole(q[11], self.held.turns[3])],
                    [v[9], v[10], v[11]],
                )
            }

            /// Pose and velocity of G of body `bar[4]`: m, m, rad; m/s, m/s, rad/s.
            pub fn bar_4(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of(
                    [q[12], q[13], rt::turns::whole(q[14], self.held.turns[4])],
                    [v[12], v[13], v[14]],
                )
            }

            /// Output `bar[4].b.y`, m.
            pub fn bar_4_b_y(&self) -> S {
                self.bar_4_b_y_among_(&Common::<S>::new())
            }

            #[inline]
            fn bar_4_b_y_among_(&self, common: &Common<S>) -> S {
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let bar_4_y = q[13];
                let bar_4_angle = q[14];
                let by = rt::Factor;
                by(0.5).mul_add(bar_4_angle.sin(), bar_4_y)
            }

            /// Kinetic energy of all bodies, J.
            pub fn kinetic_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [
                    bar_0_vx,
                    bar_0_vy,
                    bar_0_omega,
                    bar_1_vx,
                    bar_1_vy,
                    bar_1_omega,
                    bar_2_vx,
                    bar_2_vy,
                    bar_2_omega,
                    bar_3_vx,
                    bar_3_vy,
                    bar_3_omega,
                    bar_4_vx,
                    bar_4_vy,
                    bar_4_omega,
                    ..,
                ] = *v;
                let by = rt::Factor;
                let t1 = bar_4_omega.mul_add(
                    bar_4_omega,
                    bar_3_omega.mul_add(
                        bar_3_omega,
                        bar_2_omega.mul_add(
                            bar_2_omega,
                            bar_1_omega.mul_add(bar_1_omega, bar_0_omega * bar_0_omega),
                        ),
                    ),
                );
                let t2 = bar_2_vx.mul_add(
                    bar_2_vx,
                    bar_1_vy.mul_add(
                        bar_1_vy,
                        bar_1_vx.mul_add(bar_1_vx, bar_0_vy.mul_add(bar_0_vy, bar_0_vx * bar_0_vx)),
                    ),
                );
                let t3 = bar_4_vx.mul_add(
                    bar_4_vx,
                    bar_3_vy.mul_add(bar_3_vy, bar_3_vx.mul_add(bar_3_vx, bar_2_vy.mul_add(bar_2_vy, t2))),
                );
                by(0.5) * by(0.08333333333333333).mul_add(t1, bar_4_vy.mul_add(bar_4_vy, t3))
            }

            /// Potential energy of gravity above the origin, J.
            pub fn gravity_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let bar_0_y = q[1];
                let bar_1_y = q[4];
                let bar_2_y = q[7];
                let bar_3_y = q[10];
                let bar_4_y = q[13];
                let by = rt::Factor;
                by(9.81) * (bar_0_y + bar_1_y + bar_2_y + bar_3_y + bar_4_y)
            }

            /// Power of all forces and torques but gravity and reactions, W.
            pub fn load_power(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [_, _, bar_0_omega, ..] = *v;
                let by = rt::Factor;
                by(-0.1) * bar_0_omega * bar_0_omega
            }

            /// Pose and velocity of G of body `bar[i]`, m, m, rad; m/s, m/s, rad/s; none if there is no such body.
            pub fn bar(&self, i: usize) -> Option<BodyState<S>> {
                let body = match i {
                    0 => 0,
                    1 => 1,
                    2 => 2,
                    3 => 3,
                    4 => 4,
                    _ => return None,
                };
                let (q, v): ([S; 15], [S; 15]) = self.unwrapped_pose_();
                BodyState::among(&q, &v, body)
            }

            /// Output `bar[i].b.y`, m; none if there is no such output.
            pub fn bar_b_y(&self, i: usize) -> Option<S> {
                Some(match i {
                    4 => self.bar_4_b_y(),
                    _ => return None,
                })
            }

            /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
            /// the second turns from the first, rad, positive to the left.
            pub fn branches(&self) -> [(&'static str, S); 4] {
                let mut value = [S::lit(0.0); 4];
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [
                    bar_0_x,
                    bar_0_y,
                    bar_0_angle,
                    bar_1_x,
                    bar_1_y,
                    bar_1_angle,
                    bar_2_x,
                    bar_2_y,
                    bar_2_angle,
                    bar_3_x,
                    bar_3_y,
                    bar_3_angle,
                    bar_4_x,
                    bar_4_y,
                    ..,
                ] = *q;
                let by = rt::Factor;
                let (
                    [sin_bar_0_angle, sin_bar_1_angle, sin_bar_2_angle, sin_bar_3_angle],
                    [cos_bar_0_angle, cos_bar_1_angle, cos_bar_2_angle, cos_bar_3_angle],
                ) = S::sin_cos_all([bar_0_angle, bar_1_angle, bar_2_angle, bar_3_angle]);
                let t1 = by(0.5).mul_add(sin_bar_1_angle, bar_1_y);
                let t2 = by(0.5).mul_add(sin_bar_0_angle, bar_0_y) - t1;
                let t3 = by(0.5).mul_add(cos_bar_1_angle, bar_1_x);
                let t4 = by(0.5).mul_add(cos_bar_0_angle, bar_0_x) - t3;
                value[0] = (-cos_bar_0_angle)
                    .mul_add(t2, sin_bar_0_angle * t4)
                    .atan2(-sin_bar_0_angle.mul_add(t2, cos_bar_0_angle * t4));
                let t5 = by(0.5).mul_add(sin_bar_2_angle, bar_2_y);
                let t6 = t1 - t5;
                let t7 = by(0.5).mul_add(cos_bar_2_angle, bar_2_x);
                let t8 = t3 - t7;
                value[1] = (-cos_bar_1_angle)
                    .mul_add(t6, sin_bar_1_angle * t8)
                    .atan2(-sin_bar_1_angle.mul_add(t6, cos_bar_1_angle * t8));
                let t9 = by(0.5).mul_add(sin_bar_3_angle, bar_3_y);
                let t10 = t5 - t9;
                let t11 = by(0.5).mul_add(cos_bar_3_angle, bar_3_x);
                let t12 = t7 - t11;
                value[2] = (-cos_bar_2_angle)
                    .mul_add(t10, sin_bar_2_angle * t12)
                    .atan2(-sin_bar_2_angle.mul_add(t10, cos_bar_2_angle * t12));
                let t13 = t9 - bar_4_y;
                let t14 = t11 - bar_4_x;
                value[3] = (-cos_bar_3_angle)
                    .mul_add(t13, sin_bar_3_angle * t14)
                    .atan2(-sin_bar_3_angle.mul_add(t13, cos_bar_3_angle * t14));
                [("pin[1]", value[0]), ("pin[2]", value[1]), ("pin[3]", value[2]), ("pin[4]", value[3])]
            }

            /// Names and units of the columns of [`State::outputs`].
            pub const OUTPUTS: [(&'static str, &'static str); 1] = [("bar[4].b.y", "m")];
            /// The declared outputs, in the units of [`State::OUTPUTS`].
            pub fn outputs(&self) -> [S; 1] {
                let common = &Common::<S>::new();
                let own_0 = self.bar_4_b_y_among_(common);
                [own_0]
            }

            /// Names and SI units of the outputs and of all that is observed.
            pub const OBSERVED: [(&'static str, &'static str); 1] = [("bar[4].b.y", "m")];

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
                        0 => state.bar_4_b_y_among_(common),
                        _ => S::lit(f64::NAN),
                    }
                }
                match column / 200 {
                    0 => block_0(self, column, common),
                    _ => S::lit(f64::NAN),
                }
            }
        }

        impl Chain<f64> {
            /// The mechanism as declared, in `f64`; `Chain { field: value, ..Chain::new() }` changes some.
            pub fn new() -> Self {
                Self::of()
            }
        }

        impl Default for Chain<f64> {
            fn default() -> Self {
                Self::of()
            }
        }

        impl<S: Scalar> Chain<S> {
            /// The mechanism as declared, for any scalar.
            pub fn of() -> Self {
                let lit = S::lit;
                let start = Starts {
                    bar_0: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.0)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    bar_1: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.17453292519943295)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    bar_2: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.3490658503988659)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    bar_3: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.5235987755982989)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    bar_4: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.6981317007977318)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                };
                Chain { start }
            }
        }

        impl<S: Real> Chain<S> {
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

        impl<S: Scalar> Chain<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> Input<S> {
                Input { none: core::marker::PhantomData }
            }
        }

        impl<S: Scalar> rt::Rate for Chain<S> {
            type S = S;
            type X = [S; 10];
            type U = Held<S>;
            const NQ: usize = 5;
            const SHORT: bool = !S::REGISTERS.are_filled();
            #[inline(always)]
            fn rate(&self, t: S, u: &Self::U, x: &[S; 10], dx: &mut [S; 10]) -> rt::Health<S> {
                self.motion(t, u, x, dx);
                rt::Health::perfect()
            }

            #[inline]
            fn typical(&self) -> [S; 10] {
                [1.0; 10].map(S::lit)
            }
        }

        impl<S: Real> rt::Constraints for Chain<S> {
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
                !rt::turns::are_due(x, &[&[0], &[1], &[2], &[3], &[4]])
            }

            #[inline]
            fn update(&self, _t: S, u: &mut Self::U, x: &mut [S; 10]) -> Result<rt::Updated, Fault> {
                let turned = rt::turns::unwind(&mut u.turns, x, &[&[0], &[1], &[2], &[3], &[4]]);
                Ok(rt::Updated { turned, ..Default::default() })
            }

            fn energy(&self, t: S, u: &Self::U, x: &[S; 10]) -> Option<rt::Energy<S>> {
                let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
                let (kinetic, gravity) = (state.kinetic_energy(), state.gravity_energy());
                Some(rt::Energy { kinetic, gravity, power: state.load_power() })
            }
        }

        impl<S: Real> rt::Switched for Chain<S> {
            type Guards = [S; 0];
            type Contact = rt::switched::NoContact;
            const SWITCHES: rt::Switches = rt::Switches::NONE;
        }

        impl<S: Real> rt::Labels for Chain<S> {
            fn labels(&self) -> &'static rt::LabelTable {
                const {
                    &rt::LabelTable {
                        parts: rt::PartNames::Numbers(
                            const {
                                &[
                                    "bar[0]", "bar[1]", "bar[2]", "bar[3]", "bar[4]", "bar[0]", "bar[1]",
                                    "bar[2]", "bar[3]", "bar[4]",
                                ]
                            },
                        ),
                        states: const {
                            &[
                                "bar[0].angle",
                                "bar[1].angle",
                                "bar[2].angle",
                                "bar[3].angle",
                                "bar[4].angle",
                                "bar[0].omega",
                                "bar[1].omega",
                                "bar[2].omega",
                                "bar[3].omega",
                                "bar[4].omega",
                            ]
                        },
                        ..rt::LabelTable::NONE
                    }
                }
            }
        }

        impl<S: Real> State<S> {
            /// Pose and velocity of every body.
            #[inline]
            fn pose_(&self) -> ([S; 15], [S; 15]) {
                let (mut q, mut v) = ([S::lit(0.0); 15], [S::lit(0.0); 15]);
                self.mechanism.pose(self.time, &self.held, &self.x, &mut q, &mut v);
                (q, v)
            }

            /// Poses and velocities with all revolutions of the angles.
            fn unwrapped_pose_(&self) -> ([S; 15], [S; 15]) {
                let (mut q, v) = self.pose_();
                rt::turns::add(&self.held.turns, &mut q, &[&[2], &[5], &[8], &[11], &[14]]);
                (q, v)
            }
        }

        impl<S: Real> State<S> {
            /// The state in absolute coordinates.
            fn absolute_(&self) -> [S; 30] {
                self.joined_(&self.pose_())
            }

            /// The state in absolute coordinates, of pose and velocity.
            fn joined_(&self, (q, v): &([S; 15], [S; 15])) -> [S; 30] {
                let mut x = [S::lit(0.0); 30];
                absolute::join(q, v, &mut x);
                x
            }
        }

        impl<S: Real> rt::Moment for State<S> {
            type M = Chain<S>;

            fn new(mechanism: Chain<S>, held: Held<S>, time: S, x: [S; 10]) -> Self {
                State { mechanism, held, time, x }
            }

            fn mechanism(&self) -> &Chain<S> {
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

            fn in_place(&mut self) -> rt::InPlace<'_, Chain<S>> {
                let Self { mechanism, held, time, x } = self;
                rt::InPlace { system: mechanism, held, time, x }
            }
        }

        impl<S: Real> rt::Mechanism for Chain<S> {
            type State = State<S>;
            type Rescue = rt::singular::Never<Self>;
            const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();
            fn start_state(&self, t: S) -> Result<(Held<S>, [S; 10]), Fault> {
                self.start_holding_(t, self.declared_input())
            }

            fn opening(&self, t: S, held: &Held<S>, x: &[S; 10]) -> rt::Drift<S> {
                let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
            }
        }

        impl<S: Real> Chain<S> {
            fn holding_(input: Input<S>) -> Held<S> {
                rt::Held { input, switches: [S::lit(1.0); 0], turns: [0; 5], of_loops: (), contact: () }
            }

            fn start_holding_(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; 10]), Fault> {
                let assembly = absolute::assemble(self, t)?;
                let mut x = [S::lit(0.0); 10];
                let mut held = Self::holding_(input);
                self.to_chart(t, &assembly.q, &assembly.v, &mut x);
                Ok((held, x))
            }
        }

        impl<S: Scalar> Chain<S> {
            const LAYOUT_: absolute::Layout = absolute::Layout {
                rows: const {
                    &[
                        "first.x", "first.y", "pin[1].x", "pin[1].y", "pin[2].x", "pin[2].y", "pin[3].x",
                        "pin[3].y", "pin[4].x", "pin[4].y",
                    ]
                },
                parts: const {
                    &[
                        "first", "first", "pin[1]", "pin[1]", "pin[2]", "pin[2]", "pin[3]", "pin[3]",
                        "pin[4]", "pin[4]",
                    ]
                },
                coordinates: const {
                    &[
                        "bar[0].x",
                        "bar[0].y",
                        "bar[0].angle",
                        "bar[1].x",
                        "bar[1].y",
                        "bar[1].angle",
                        "bar[2].x",
                        "bar[2].y",
                        "bar[2].angle",
                        "bar[3].x",
                        "bar[3].y",
                        "bar[3].angle",
                        "bar[4].x",
                        "bar[4].y",
                        "bar[4].angle",
                    ]
                },
                angular: &[false; 10],
                given_angles: &[true; 5],
            };
            /// The derivatives of phi by q: the entries that are not zero, row by row.
            ///
            /// 10 mul, 5 sin_cos.
            #[cold]
            fn phi_q_entries(&self, t: S, q: &[S; 15], phi_q: &mut [S; 36]) {
                let lit = S::lit;
                let by = rt::Factor;
                phi_q[0] = lit(1.0);
                let bar_0_angle = q[2];
                let bar_1_angle = q[5];
                let bar_2_angle = q[8];
                let bar_3_angle = q[11];
                let (
                    [sin_bar_0_angle, sin_bar_1_angle, sin_bar_2_angle, sin_bar_3_angle],
                    [cos_bar_0_angle, cos_bar_1_angle, cos_bar_2_angle, cos_bar_3_angle],
                ) = S::sin_cos_all([bar_0_angle, bar_1_angle, bar_2_angle, bar_3_angle]);
                let t1 = by(0.5) * sin_bar_0_angle;
                phi_q[1] = t1;
                phi_q[2] = lit(1.0);
                let t2 = by(-0.5) * cos_bar_0_angle;
                phi_q[3] = t2;
                phi_q[4] = lit(-1.0);
                phi_q[5] = t1;
                phi_q[6] = lit(1.0);
                let t3 = by(0.5) * sin_bar_1_angle;
                phi_q[7] = t3;
                phi_q[8] = lit(-1.0);
                phi_q[9] = t2;
                phi_q[10] = lit(1.0);
                let t4 = by(-0.5) * cos_bar_1_angle;
                phi_q[11] = t4;
                phi_q[12] = lit(-1.0);
                phi_q[13] = t3;
                phi_q[14] = lit(1.0);
                let t5 = by(0.5) * sin_bar_2_angle;
                phi_q[15] = t5;
                phi_q[16] = lit(-1.0);
                phi_q[17] = t4;
                phi_q[18] = lit(1.0);
                let t6 = by(-0.5) * cos_bar_2_angle;
                phi_q[19] = t6;
                phi_q[20] = lit(-1.0);
                phi_q[21] = t5;
                phi_q[22] = lit(1.0);
                let t7 = by(0.5) * sin_bar_3_angle;
                phi_q[23] = t7;
                phi_q[24] = lit(-1.0);
                phi_q[25] = t6;
                phi_q[26] = lit(1.0);
                let t8 = by(-0.5) * cos_bar_3_angle;
                phi_q[27] = t8;
                phi_q[28] = lit(-1.0);
                phi_q[29] = t7;
                phi_q[30] = lit(1.0);
                let bar_4_angle = q[14];
                let (sin_bar_4_angle, cos_bar_4_angle) = bar_4_angle.sin_cos();
                phi_q[31] = by(0.5) * sin_bar_4_angle;
                phi_q[32] = lit(-1.0);
                phi_q[33] = t8;
                phi_q[34] = lit(1.0);
                phi_q[35] = by(-0.5) * cos_bar_4_angle;
            }
        }

        #[doc(hidden)]
        impl<S: Real> absolute::Absolute<S, NQ, NC> for Chain<S> {
            fn layout(&self) -> &'static absolute::Layout {
                const { &Self::LAYOUT_ }
            }

            /// Residuals of the constraints, m or rad; the rows stand in the table of this module.
            ///
            /// 26 add, 10 mul, 5 sin_cos.
            fn phi(&self, t: S, q: &[S; 15]) -> [S; 10] {
                let mut phi = [S::lit(0.0); 10];
                let [
                    bar_0_x,
                    bar_0_y,
                    bar_0_angle,
                    bar_1_x,
                    bar_1_y,
                    bar_1_angle,
                    bar_2_x,
                    bar_2_y,
                    bar_2_angle,
                    bar_3_x,
                    bar_3_y,
                    bar_3_angle,
                    bar_4_x,
                    bar_4_y,
                    bar_4_angle,
                    ..,
                ] = *q;
                let by = rt::Factor;
                let (
                    [sin_bar_0_angle, sin_bar_1_angle, sin_bar_2_angle, sin_bar_3_angle],
                    [cos_bar_0_angle, cos_bar_1_angle, cos_bar_2_angle, cos_bar_3_angle],
                ) = S::sin_cos_all([bar_0_angle, bar_1_angle, bar_2_angle, bar_3_angle]);
                phi[0] = by(-0.5).mul_add(cos_bar_0_angle, bar_0_x);
                phi[1] = by(-0.5).mul_add(sin_bar_0_angle, bar_0_y);
                phi[2] = by(-0.5).mul_add(cos_bar_0_angle + cos_bar_1_angle, bar_1_x - bar_0_x);
                phi[3] = by(-0.5).mul_add(sin_bar_0_angle + sin_bar_1_angle, bar_1_y - bar_0_y);
                phi[4] = by(-0.5).mul_add(cos_bar_1_angle + cos_bar_2_angle, bar_2_x - bar_1_x);
                phi[5] = by(-0.5).mul_add(sin_bar_1_angle + sin_bar_2_angle, bar_2_y - bar_1_y);
                phi[6] = by(-0.5).mul_add(cos_bar_2_angle + cos_bar_3_angle, bar_3_x - bar_2_x);
                phi[7] = by(-0.5).mul_add(sin_bar_2_angle + sin_bar_3_angle, bar_3_y - bar_2_y);
                let (sin_bar_4_angle, cos_bar_4_angle) = bar_4_angle.sin_cos();
                phi[8] = by(-0.5).mul_add(cos_bar_3_angle + cos_bar_4_angle, bar_4_x - bar_3_x);
                phi[9] = by(-0.5).mul_add(sin_bar_3_angle + sin_bar_4_angle, bar_4_y - bar_3_y);
                phi
            }

            /// Their rates, `phi_q v - nu`, m/s or rad/s.
            ///
            /// 26 add, 20 mul, 5 sin_cos.
            fn phi_dot(&self, t: S, q: &[S; 15], v: &[S; 15]) -> [S; 10] {
                let mut phi_dot = [S::lit(0.0); 10];
                let bar_0_angle = q[2];
                let bar_1_angle = q[5];
                let bar_2_angle = q[8];
                let bar_3_angle = q[11];
                let bar_4_angle = q[14];
                let [
                    bar_0_vx,
                    bar_0_vy,
                    bar_0_omega,
                    bar_1_vx,
                    bar_1_vy,
                    bar_1_omega,
                    bar_2_vx,
                    bar_2_vy,
                    bar_2_omega,
                    bar_3_vx,
                    bar_3_vy,
                    bar_3_omega,
                    bar_4_vx,
                    bar_4_vy,
                    bar_4_omega,
                    ..,
                ] = *v;
                let by = rt::Factor;
                let (
                    [sin_bar_0_angle, sin_bar_1_angle, sin_bar_2_angle, sin_bar_3_angle],
                    [cos_bar_0_angle, cos_bar_1_angle, cos_bar_2_angle, cos_bar_3_angle],
                ) = S::sin_cos_all([bar_0_angle, bar_1_angle, bar_2_angle, bar_3_angle]);
                let t1 = bar_0_omega * sin_bar_0_angle;
                phi_dot[0] = by(0.5).mul_add(t1, bar_0_vx);
                let t2 = bar_0_omega * cos_bar_0_angle;
                phi_dot[1] = by(-0.5).mul_add(t2, bar_0_vy);
                let t3 = bar_1_omega * sin_bar_1_angle;
                phi_dot[2] = by(0.5).mul_add(t1 + t3, bar_1_vx - bar_0_vx);
                let t4 = bar_1_omega * cos_bar_1_angle;
                phi_dot[3] = by(-0.5).mul_add(t2 + t4, bar_1_vy - bar_0_vy);
                let t5 = bar_2_omega * sin_bar_2_angle;
                phi_dot[4] = by(0.5).mul_add(t3 + t5, bar_2_vx - bar_1_vx);
                let t6 = bar_2_omega * cos_bar_2_angle;
                phi_dot[5] = by(-0.5).mul_add(t4 + t6, bar_2_vy - bar_1_vy);
                let t7 = bar_3_omega * sin_bar_3_angle;
                phi_dot[6] = by(0.5).mul_add(t5 + t7, bar_3_vx - bar_2_vx);
                let t8 = bar_3_omega * cos_bar_3_angle;
                phi_dot[7] = by(-0.5).mul_add(t6 + t8, bar_3_vy - bar_2_vy);
                let (sin_bar_4_angle, cos_bar_4_angle) = bar_4_angle.sin_cos();
                phi_dot[8] = by(0.5).mul_add(bar_4_omega.mul_add(sin_bar_4_angle, t7), bar_4_vx - bar_3_vx);
                phi_dot[9] = by(-0.5).mul_add(bar_4_omega.mul_add(cos_bar_4_angle, t8), bar_4_vy - bar_3_vy);
                phi_dot
            }

            fn phi_q(&self, t: S, q: &[S; 15], each: &mut impl FnMut(usize, usize, S)) {
                let places: &[[u32; 2]] = const {
                    &rt::compact::pairs::<36>(&rt::compact::numbers::<72>(&[
                        (1, &[0, 0, 0, 2, 1, 1], &[]),
                        (
                            4,
                            &[1, 2, 2, 0, 2, 2, 2, 3, 2, 5, 3, 1, 3, 2, 3, 4],
                            &[2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3],
                        ),
                        (1, &[9, 14], &[]),
                    ]))
                };
                let mut entries = [S::lit(0.0); 36];
                self.phi_q_entries(t, q, &mut entries);
                for (&[row, column], entry) in places.iter().zip(entries) {
                    each(row as usize, column as usize, entry);
                }
            }

            /// The shortest step in the norm of `W^-1` that closes `r`: `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 129 add, 194 mul, 11 div, 5 sin_cos, 44 select.
            fn min_norm(
                &self,
                t: S,
                q: &[S; 15],
                w: &[S; 15],
                r: &[S; 10],
                dq: &mut [S; 15],
            ) -> rt::Health<S> {
                rt::Health({
                    let lit = S::lit;
                    let by = rt::Factor;
                    // phi_q W phi_q^T = L D L^T
                    let w_0 = w[0];
                    let bar_0_angle = q[2];
                    let bar_1_angle = q[5];
                    let bar_2_angle = q[8];
                    let bar_3_angle = q[11];
                    let (
                        [sin_bar_0_angle, sin_bar_1_angle, sin_bar_2_angle, sin_bar_3_angle],
                        [cos_bar_0_angle, cos_bar_1_angle, cos_bar_2_angle, cos_bar_3_angle],
                    ) = S::sin_cos_all([bar_0_angle, bar_1_angle, bar_2_angle, bar_3_angle]);
                    let w_2 = w[2];
                    let y_0_2 = by(0.5) * sin_bar_0_angle * w_2;
                    let t1 = by(0.5) * (sin_bar_0_angle * y_0_2);
                    let d_0 = w_0 + t1;
                    let r_0 = by(1.0) / d_0;
                    let t2 = by(-0.5) * cos_bar_0_angle;
                    let y_1_2 = t2 * w_2;
                    let t3 = sin_bar_0_angle * y_1_2;
                    let g_1_0 = by(0.5) * t3;
                    let l_1_0 = r_0 * g_1_0;
                    let g_2_0 = t1 - w_0;
                    let l_2_0 = r_0 * g_2_0;
                    let w_1 = w[1];
                    let t4 = cos_bar_0_angle * y_1_2;
                    let t5 = by(-0.5).mul_add(t4, w_1);
                    let t6 = g_1_0 * l_1_0;
                    let d_1 = t5 - t6;
                    let r_1 = by(1.0) / d_1;
                    let growth_1 = (t5 * r_1).abs();
                    let most_growth = lit(S::MOST_GROWTH);
                    let t7 = most_growth.lt(growth_1);
                    let kept_1 = S::select(t7, lit(0.0), r_1);
                    let g_2_1 = (-g_1_0).mul_add(l_2_0, t2 * y_0_2);
                    let l_2_1 = g_2_1 * kept_1;
                    let g_3_1 = by(-0.5).mul_add(t4, -w_1) - t6;
                    let l_3_1 = g_3_1 * kept_1;
                    let w_3 = w[3];
                    let w_5 = w[5];
                    let y_2_5 = by(0.5) * sin_bar_1_angle * w_5;
                    let t8 = by(0.5) * (sin_bar_1_angle * y_2_5);
                    let t9 = w_3 + t8;
                    let t10 = d_0 + t9;
                    let r_2 = by(1.0) / (-g_2_1).mul_add(l_2_1, (-g_2_0).mul_add(l_2_0, t10));
                    let growth_2 = (t10 * r_2).abs();
                    let t11 = most_growth.lt(growth_2);
                    let kept_2 = S::select(t11, lit(0.0), r_2);
                    let t12 = by(-0.5) * cos_bar_1_angle;
                    let y_3_5 = t12 * w_5;
                    let t13 = sin_bar_1_angle * y_3_5;
                    let g_3_2 = (-g_2_1).mul_add(l_3_1, (-l_1_0).mul_add(g_2_0, by(0.5) * (t3 + t13)));
                    let l_3_2 = kept_2 * g_3_2;
                    let g_4_2 = t8 - w_3;
                    let l_4_2 = g_4_2 * kept_2;
                    let g_5_2 = by(0.5) * t13;
                    let l_5_2 = g_5_2 * kept_2;
                    let w_4 = w[4];
                    let t14 = cos_bar_1_angle * y_3_5;
                    let t15 = by(-0.5).mul_add(t14, w_4);
                    let r_3 = by(1.0) / ((-g_3_2).mul_add(l_3_2, (-g_3_1).mul_add(l_3_1, d_1)) + t15);
                    let growth_3 = (r_3 * (t5 + t15)).abs();
                    let t16 = most_growth.lt(growth_3);
                    let kept_3 = S::select(t16, lit(0.0), r_3);
                    let g_4_3 = (-g_3_2).mul_add(l_4_2, t12 * y_2_5);
                    let l_4_3 = kept_3 * g_4_3;
                    let g_5_3 = (-g_3_2).mul_add(l_5_2, by(-0.5).mul_add(t14, -w_4));
                    let l_5_3 = kept_3 * g_5_3;
                    let w_6 = w[6];
                    let w_8 = w[8];
                    let y_4_8 = by(0.5) * sin_bar_2_angle * w_8;
                    let t17 = by(0.5) * (sin_bar_2_angle * y_4_8);
                    let t18 = w_6 + t17;
                    let t19 = t9 + t18;
                    let r_4 = by(1.0) / (-g_4_3).mul_add(l_4_3, (-g_4_2).mul_add(l_4_2, t19));
                    let growth_4 = (t19 * r_4).abs();
                    let t20 = most_growth.lt(growth_4);
                    let kept_4 = S::select(t20, lit(0.0), r_4);
                    let t21 = by(-0.5) * cos_bar_2_angle;
                    let y_5_8 = t21 * w_8;
                    let t22 = sin_bar_2_angle * y_5_8;
                    let g_5_4 = (-g_4_3).mul_add(l_5_3, (-g_4_2).mul_add(l_5_2, by(0.5) * (t13 + t22)));
                    let l_5_4 = kept_4 * g_5_4;
                    let g_6_4 = t17 - w_6;
                    let l_6_4 = g_6_4 * kept_4;
                    let g_7_4 = by(0.5) * t22;
                    let l_7_4 = g_7_4 * kept_4;
                    let w_7 = w[7];
                    let t23 = cos_bar_2_angle * y_5_8;
                    let t24 = by(-0.5).mul_add(t23, w_7);
                    let t25 = t15 + t24;
                    let r_5 = by(1.0)
                        / (-g_5_4).mul_add(l_5_4, (-g_5_3).mul_add(l_5_3, (-g_5_2).mul_add(l_5_2, t25)));
                    let growth_5 = (t25 * r_5).abs();
                    let t26 = most_growth.lt(growth_5);
                    let kept_5 = S::select(t26, lit(0.0), r_5);
                    let g_6_5 = (-g_5_4).mul_add(l_6_4, t21 * y_4_8);
                    let l_6_5 = kept_5 * g_6_5;
                    let g_7_5 = (-g_5_4).mul_add(l_7_4, by(-0.5).mul_add(t23, -w_7));
                    let l_7_5 = kept_5 * g_7_5;
                    let w_9 = w[9];
                    let w_11 = w[11];
                    let y_6_11 = by(0.5) * sin_bar_3_angle * w_11;
                    let t27 = by(0.5) * (sin_bar_3_angle * y_6_11);
                    let t28 = w_9 + t27;
                    let t29 = t18 + t28;
                    let r_6 = by(1.0) / (-g_6_5).mul_add(l_6_5, (-g_6_4).mul_add(l_6_4, t29));
                    let growth_6 = (t29 * r_6).abs();
                    let t30 = most_growth.lt(growth_6);
                    let kept_6 = S::select(t30, lit(0.0), r_6);
                    let t31 = by(-0.5) * cos_bar_3_angle;
                    let y_7_11 = t31 * w_11;
                    let t32 = sin_bar_3_angle * y_7_11;
                    let g_7_6 = (-g_6_5).mul_add(l_7_5, (-g_6_4).mul_add(l_7_4, by(0.5) * (t22 + t32)));
                    let l_7_6 = kept_6 * g_7_6;
                    let g_8_6 = t27 - w_9;
                    let l_8_6 = g_8_6 * kept_6;
                    let g_9_6 = by(0.5) * t32;
                    let l_9_6 = g_9_6 * kept_6;
                    let w_10 = w[10];
                    let t33 = cos_bar_3_angle * y_7_11;
                    let t34 = by(-0.5).mul_add(t33, w_10);
                    let t35 = t24 + t34;
                    let r_7 = by(1.0)
                        / (-g_7_6).mul_add(l_7_6, (-g_7_5).mul_add(l_7_5, (-g_7_4).mul_add(l_7_4, t35)));
                    let growth_7 = (t35 * r_7).abs();
                    let t36 = most_growth.lt(growth_7);
                    let kept_7 = S::select(t36, lit(0.0), r_7);
                    let g_8_7 = (-g_7_6).mul_add(l_8_6, t31 * y_6_11);
                    let l_8_7 = kept_7 * g_8_7;
                    let g_9_7 = (-g_7_6).mul_add(l_9_6, by(-0.5).mul_add(t33, -w_10));
                    let l_9_7 = kept_7 * g_9_7;
                    let w_12 = w[12];
                    let bar_4_angle = q[14];
                    let (sin_bar_4_angle, cos_bar_4_angle) = bar_4_angle.sin_cos();
                    let w_14 = w[14];
                    let t37 = by(0.5) * sin_bar_4_angle;
                    let y_8_14 = t37 * w_14;
                    let t38 = t37.mul_add(y_8_14, w_12) + t28;
                    let r_8 = by(1.0) / (-g_8_7).mul_add(l_8_7, (-g_8_6).mul_add(l_8_6, t38));
                    let growth_8 = (t38 * r_8).abs();
                    let t39 = most_growth.lt(growth_8);
                    let kept_8 = S::select(t39, lit(0.0), r_8);
                    let y_9_14 = by(-0.5) * cos_bar_4_angle * w_14;
                    let g_9_8 = (-g_8_7).mul_add(
                        l_9_7,
                        (-g_8_6).mul_add(l_9_6, by(0.5) * sin_bar_4_angle.mul_add(y_9_14, t32)),
                    );
                    let l_9_8 = kept_8 * g_9_8;
                    let w_13 = w[13];
                    let t40 = (-(by(0.5) * cos_bar_4_angle)).mul_add(y_9_14, w_13) + t34;
                    let r_9 = by(1.0)
                        / (-g_9_8).mul_add(l_9_8, (-g_9_7).mul_add(l_9_7, (-g_9_6).mul_add(l_9_6, t40)));
                    let growth_9 = (t40 * r_9).abs();
                    let t41 = most_growth.lt(growth_9);
                    // (phi_q W phi_q^T) mu = r
                    let dphi_0 = r[0];
                    let dphi_1 = r[1];
                    let t42 = dphi_0 * l_1_0;
                    let b_1 = dphi_1 - t42;
                    let dphi_2 = r[2];
                    let b_2 = (-b_1).mul_add(l_2_1, (-dphi_0).mul_add(l_2_0, dphi_2));
                    let dphi_3 = r[3];
                    let b_3 = (-l_3_2).mul_add(b_2, (-b_1).mul_add(l_3_1, dphi_3 - t42));
                    let dphi_4 = r[4];
                    let b_4 = (-l_4_3).mul_add(b_3, (-l_4_2).mul_add(b_2, dphi_4));
                    let dphi_5 = r[5];
                    let b_5 = (-l_5_4).mul_add(b_4, (-l_5_3).mul_add(b_3, (-l_5_2).mul_add(b_2, dphi_5)));
                    let dphi_6 = r[6];
                    let b_6 = (-l_6_5).mul_add(b_5, (-l_6_4).mul_add(b_4, dphi_6));
                    let dphi_7 = r[7];
                    let b_7 = (-l_7_6).mul_add(b_6, (-l_7_5).mul_add(b_5, (-l_7_4).mul_add(b_4, dphi_7)));
                    let dphi_8 = r[8];
                    let b_8 = (-l_8_7).mul_add(b_7, (-l_8_6).mul_add(b_6, dphi_8));
                    let dphi_9 = r[9];
                    let mu_9 = S::select(t41, lit(0.0), r_9)
                        * (-l_9_8).mul_add(b_8, (-l_9_7).mul_add(b_7, (-l_9_6).mul_add(b_6, dphi_9)));
                    let mu_8 = (-l_9_8).mul_add(mu_9, kept_8 * b_8);
                    let mu_7 = (-l_9_7).mul_add(mu_9, (-l_8_7).mul_add(mu_8, kept_7 * b_7));
                    let mu_6 =
                        (-l_9_6).mul_add(mu_9, (-l_8_6).mul_add(mu_8, (-l_7_6).mul_add(mu_7, kept_6 * b_6)));
                    let mu_5 = (-l_7_5).mul_add(mu_7, (-l_6_5).mul_add(mu_6, kept_5 * b_5));
                    let mu_4 =
                        (-l_7_4).mul_add(mu_7, (-l_6_4).mul_add(mu_6, (-l_5_4).mul_add(mu_5, kept_4 * b_4)));
                    let mu_3 = (-l_5_3).mul_add(mu_5, (-l_4_3).mul_add(mu_4, kept_3 * b_3));
                    let mu_2 =
                        (-l_5_2).mul_add(mu_5, (-l_4_2).mul_add(mu_4, (-l_3_2).mul_add(mu_3, kept_2 * b_2)));
                    let mu_1 = (-l_3_1).mul_add(mu_3, (-l_2_1).mul_add(mu_2, b_1 * kept_1));
                    let t43 = mu_3 + mu_1;
                    let mu_0 = (-l_1_0).mul_add(t43, (-l_2_0).mul_add(mu_2, dphi_0 * r_0));
                    // Results
                    dq[0] = w_0 * (mu_0 - mu_2);
                    dq[1] = w_1 * (mu_1 - mu_3);
                    dq[2] = y_1_2.mul_add(t43, y_0_2 * (mu_2 + mu_0));
                    dq[3] = w_3 * (mu_2 - mu_4);
                    dq[4] = w_4 * (mu_3 - mu_5);
                    dq[5] = y_3_5.mul_add(mu_5 + mu_3, y_2_5 * (mu_4 + mu_2));
                    dq[6] = w_6 * (mu_4 - mu_6);
                    dq[7] = w_7 * (mu_5 - mu_7);
                    dq[8] = y_5_8.mul_add(mu_7 + mu_5, y_4_8 * (mu_6 + mu_4));
                    dq[9] = w_9 * (mu_6 - mu_8);
                    dq[10] = w_10 * (mu_7 - mu_9);
                    dq[11] = y_7_11.mul_add(mu_9 + mu_7, y_6_11 * (mu_8 + mu_6));
                    dq[12] = w_12 * mu_8;
                    dq[13] = w_13 * mu_9;
                    dq[14] = y_9_14.mul_add(mu_9, y_8_14 * mu_8);
                    let t44 = S::select(t7, lit(0.0), growth_1)
                        .max(S::select(t11, lit(0.0), growth_2))
                        .max(S::select(t16, lit(0.0), growth_3));
                    let t45 = t44
                        .max(S::select(t20, lit(0.0), growth_4))
                        .max(S::select(t26, lit(0.0), growth_5))
                        .max(S::select(t30, lit(0.0), growth_6));
                    let t46 = t45
                        .max(S::select(t36, lit(0.0), growth_7))
                        .max(S::select(t39, lit(0.0), growth_8))
                        .max(S::select(t41, lit(0.0), growth_9));
                    by(1.0) / t46
                })
            }

            /// Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body.
            fn inverse_mass(&self) -> [S; 15] {
                let mut inverse_mass = [S::lit(0.0); 15];
                let lit = S::lit;
                inverse_mass[0] = lit(1.0);
                inverse_mass[1] = lit(1.0);
                inverse_mass[2] = lit(12.0);
                inverse_mass[3] = lit(1.0);
                inverse_mass[4] = lit(1.0);
                inverse_mass[5] = lit(12.0);
                inverse_mass[6] = lit(1.0);
                inverse_mass[7] = lit(1.0);
                inverse_mass[8] = lit(12.0);
                inverse_mass[9] = lit(1.0);
                inverse_mass[10] = lit(1.0);
                inverse_mass[11] = lit(12.0);
                inverse_mass[12] = lit(1.0);
                inverse_mass[13] = lit(1.0);
                inverse_mass[14] = lit(12.0);
                inverse_mass
            }

            fn length(&self) -> S {
                S::lit(0.5)
            }

            fn start_position(&self) -> [Start<S>; 15] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 5] = [
                    self.start.bar_0.of_centre([lit(0.0), lit(0.0)]),
                    self.start.bar_1.of_centre([lit(0.0), lit(0.0)]),
                    self.start.bar_2.of_centre([lit(0.0), lit(0.0)]),
                    self.start.bar_3.of_centre([lit(0.0), lit(0.0)]),
                    self.start.bar_4.of_centre([lit(0.0), lit(0.0)]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn start_velocity(&self, q: &[S; 15]) -> [Start<S>; 15] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 5] = [
                    self.start.bar_0.velocity_of_centre([lit(0.0), lit(0.0)], q[2]),
                    self.start.bar_1.velocity_of_centre([lit(0.0), lit(0.0)], q[5]),
                    self.start.bar_2.velocity_of_centre([lit(0.0), lit(0.0)], q[8]),
                    self.start.bar_3.velocity_of_centre([lit(0.0), lit(0.0)], q[11]),
                    self.start.bar_4.velocity_of_centre([lit(0.0), lit(0.0)], q[14]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }
        }

        impl<S: Real> State<S> {
            /// Reactions that redundancy leaves undetermined, by constraint row: none.
            pub fn undetermined(&self) -> [bool; 10] {
                [false; 10]
            }
        }

        impl<S: Real> rt::lanes::Pack for Chain<S> {
            type Packed<T: Scalar> = Chain<T>;

            #[allow(unused_variables)]
            fn pack<T: Scalar, const N: usize>(
                &self,
                all: [&Self; N],
                number: impl Fn([S; N]) -> T,
            ) -> Chain<T> {
                let same = |s| number([s; N]);
                let start = Starts {
                    bar_0: self.start.bar_0.map(same),
                    bar_1: self.start.bar_1.map(same),
                    bar_2: self.start.bar_2.map(same),
                    bar_3: self.start.bar_3.map(same),
                    bar_4: self.start.bar_4.map(same),
                };
                Chain { start }
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
                let mut turns = [T::ZERO.to_turns(); 5];
                for k in 0..5 {
                    turns[k] = number(rt::Vector::from_fn(|i| S::of_turns(all[i].turns[k]))).to_turns();
                }
                let contact = ();
                rt::Held { input, switches, turns, of_loops, contact }
            }

            const WATCHED: bool = false;
            #[inline]
            fn are_calm<T: Scalar>(typical: &[T; 10], t: T, held: &Held<T>, x: &[T; 10]) -> T {
                rt::turns::all_near(x, &[&[0], &[1], &[2], &[3], &[4]])
            }

            #[inline]
            fn are_short<T: Scalar>(typical: &[T; 10], held: &Held<T>, legs: [&[T; 10]; 2]) -> T {
                T::lit(1.0)
            }

            #[inline(never)]
            fn look<T: Scalar>(all: &Chain<T>, t: T, held: &mut Held<T>, x: &[T; 10], due: T) -> T {
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

        impl<S: Real> rt::Linear for Chain<S> {
            type Lifted<const K: usize> = Chain<rt::Dual<S, K>>;
            type In<T: Real> = Chain<T>;
            type Derivatives = rt::linalg::Sparse<S, Augmented<S>, 61, 25, 5>;

            fn lift<const K: usize>(&self, held: &Held<S>) -> (Chain<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                self.in_numbers(held, rt::Dual::constant)
            }

            fn in_numbers<T: Real>(&self, held: &Held<S>, number: impl Fn(S) -> T) -> (Chain<T>, Held<T>) {
                use rt::lanes::Pack;
                let of_one = |[s]: [S; 1]| number(s);
                (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
            }

            #[inline]
            fn rate_in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (Chain<T>, Held<T>) {
                let value = Start::free(T::ZERO);
                let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
                let start = Starts { bar_0: zero, bar_1: zero, bar_2: zero, bar_3: zero, bar_4: zero };
                let own = Chain { start };
                (own, <Self as rt::lanes::Pack>::pack_held(held, [held], |[s]: [S; 1]| number(s)))
            }

            fn rate_reads_time(&self) -> bool {
                false
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

        impl<S: Real> rt::Ports for Chain<S> {
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

        impl<S: Real> rt::Described for Chain<S> {
            const TABLES: &'static described::Tables = &described::Tables {
                name: "Chain",
                docs: "A chain of five bars: elimination body by body.",
                report: described::Report {
                    rung: 2,
                    formulation: "joint coordinates",
                    reason: "the joints make a tree, so that no constraint is left",
                    operations: OPERATIONS,
                    degrees_of_freedom: NDOF,
                },
                bodies: &[
                    described::Body { name: "bar[0]", ports: &["a", "b"], contour: 0, first: 0 },
                    described::Body { name: "bar[1]", ports: &["a", "b"], contour: 0, first: 9 },
                    described::Body { name: "bar[2]", ports: &["a", "b"], contour: 0, first: 18 },
                    described::Body { name: "bar[3]", ports: &["a", "b"], contour: 0, first: 27 },
                    described::Body { name: "bar[4]", ports: &["a", "b"], contour: 0, first: 36 },
                ],
                ground: &[described::GroundPort { name: "o", moves: false, first: 45 }],
                parts: &[
                    described::Part {
                        name: "first",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 0 },
                            described::Frame { argument: "b", body: Some(0), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 49,
                    },
                    described::Part {
                        name: "pin[1]",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(0), port: 1 },
                            described::Frame { argument: "b", body: Some(1), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 50,
                    },
                    described::Part {
                        name: "pin[2]",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(1), port: 1 },
                            described::Frame { argument: "b", body: Some(2), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 51,
                    },
                    described::Part {
                        name: "pin[3]",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(2), port: 1 },
                            described::Frame { argument: "b", body: Some(3), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 52,
                    },
                    described::Part {
                        name: "pin[4]",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(3), port: 1 },
                            described::Frame { argument: "b", body: Some(4), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 53,
                    },
                ],
                parameters: &[],
                inputs: &[],
                states: &[],
                outputs: &[described::Quantity {
                    name: "bar[4].b.y",
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
            const DECLARATION: &'static str = "/// A chain of five bars: elimination body by body.\npub Chain {\n    gravity: 9.81 m/s^2;\n    ground { port o: (0, 0) m; }\n    repeat i in 0..5 {\n        body bar[i] { mass: 1 kg; inertia: 1 kg*m^2/12; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 10 deg*i; }\n    }\n    revolute first(ground.o, bar[0].a) { damping: 0.1 N*m*s/rad; }\n    repeat i in 1..5 {\n        revolute pin[i](bar[i - 1].b, bar[i].a);\n    }\n    output bar[4].b.y;\n}\n";
            const FILES: &'static [(&'static str, &'static str)] = &[];
            fn figure(&self, t: S, index: usize) -> Option<S> {
                let constants: &[f64] = const {
                    &[
                        1.0,
                        0.08333333333333333,
                        0.0,
                        -0.5,
                        0.0,
                        0.0,
                        0.5,
                        0.0,
                        0.0,
                        1.0,
                        0.08333333333333333,
                        0.0,
                        -0.5,
                        0.0,
                        0.0,
                        0.5,
                        0.0,
                        0.0,
                        1.0,
                        0.08333333333333333,
                        0.0,
                        -0.5,
                        0.0,
                        0.0,
                        0.5,
                        0.0,
                        0.0,
                        1.0,
                        0.08333333333333333,
                        0.0,
                        -0.5,
                        0.0,
                        0.0,
                        0.5,
                        0.0,
                        0.0,
                        1.0,
                        0.08333333333333333,
                        0.0,
                        -0.5,
                        0.0,
                        0.0,
                        0.5,
                        0.0,
                        0.0,
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
                self.bar_0.each(
                    ["bar[0].x", "bar[0].y", "bar[0].angle", "bar[0].vx", "bar[0].vy", "bar[0].omega"],
                    &mut *each,
                );
                self.bar_1.each(
                    ["bar[1].x", "bar[1].y", "bar[1].angle", "bar[1].vx", "bar[1].vy", "bar[1].omega"],
                    &mut *each,
                );
                self.bar_2.each(
                    ["bar[2].x", "bar[2].y", "bar[2].angle", "bar[2].vx", "bar[2].vy", "bar[2].omega"],
                    &mut *each,
                );
                self.bar_3.each(
                    ["bar[3].x", "bar[3].y", "bar[3].angle", "bar[3].vx", "bar[3].vy", "bar[3].omega"],
                    &mut *each,
                );
                self.bar_4.each(
                    ["bar[4].x", "bar[4].y", "bar[4].angle", "bar[4].vx", "bar[4].vy", "bar[4].omega"],
                    &mut *each,
                );
            }
        }

        impl<S: Scalar> core::fmt::Display for Starts<S> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                rt::start::write_starts(*self, f)
            }
        }

        impl<S: Real> Chain<S> {
            fn placed(&self, x: &[S; 30]) -> Starts<S> {
                let lit = S::lit;
                Starts {
                    bar_0: self.start.bar_0.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[0], x[1], x[2]],
                        [x[15], x[16], x[17]],
                    ),
                    bar_1: self.start.bar_1.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[3], x[4], x[5]],
                        [x[18], x[19], x[20]],
                    ),
                    bar_2: self.start.bar_2.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[6], x[7], x[8]],
                        [x[21], x[22], x[23]],
                    ),
                    bar_3: self.start.bar_3.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[9], x[10], x[11]],
                        [x[24], x[25], x[26]],
                    ),
                    bar_4: self.start.bar_4.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[12], x[13], x[14]],
                        [x[27], x[28], x[29]],
                    ),
                }
            }
        }

        impl<S: Real> State<S> {
            /// Poses, velocities and states of this moment as start values, with the locks that are set: to go on from here
            /// later, `mechanism.start = sim.starts()`.
            pub fn starts(&self) -> Starts<S> {
                self.mechanism.placed(&<Chain<S> as rt::Statics>::full(self))
            }
        }

        impl<S: Real> rt::Statics for Chain<S> {
            type Full = [S; 30];
            type Rows = [S; 10];
            type Starts = Starts<S>;
            const COORDINATES: &'static [&'static str] = Self::LAYOUT_.coordinates;
            const ROWS: &'static [&'static str] = Self::LAYOUT_.rows;
            const STATES: &'static [(&'static str, &'static str)] = &[];
            fn full(state: &State<S>) -> [S; 30] {
                {
                    let mut x = state.absolute_();
                    rt::turns::add(&state.held.turns, &mut x, &[&[2], &[5], &[8], &[11], &[14]]);
                    x
                }
            }

            /// What vanishes at rest: applied forces `Q` (N, N, N m per body) that reactions do not balance, residuals of the
            /// constraints, rates of the first-order states, without accelerations.
            ///
            /// 1 mul.
            #[cold]
            fn equations(&self, t: S, u: &Self::U, x: &[S; 30], lambda: &[S; 10], each: &mut impl FnMut(S)) {
                let (mut force, mut x_dot) = ([S::lit(0.0); 15], [S::lit(0.0); 0]);
                let bar_0_omega = x[17];
                let lit = S::lit;
                let by = rt::Factor;
                force[0] = lit(0.0);
                force[1] = lit(-9.81);
                force[2] = by(-0.1) * bar_0_omega;
                force[3] = lit(0.0);
                force[4] = lit(-9.81);
                force[5] = lit(0.0);
                force[6] = lit(0.0);
                force[7] = lit(-9.81);
                force[8] = lit(0.0);
                force[9] = lit(0.0);
                force[10] = lit(-9.81);
                force[11] = lit(0.0);
                force[12] = lit(0.0);
                force[13] = lit(-9.81);
                force[14] = lit(0.0);
                let (q, _): ([S; 15], [S; 15]) = absolute::split(x);
                absolute::balance::<S, Self, NQ, NC>(self, t, &q, lambda, &force)
                    .into_iter()
                    .for_each(&mut *each);
                absolute::residuals::<S, Self, NQ, NC, 30>(self, t, x, each);
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

            fn starts_at(&self, x: &[S; 30]) -> Starts<S> {
                self.placed(x)
            }

            fn size(&self) -> S {
                absolute::Absolute::<S, NQ, NC>::length(self)
            }
        }

        impl<S: Scalar> Chain<S> {
            /// The right-hand side in joint coordinates.
            ///
            /// 81 add, 144 mul, 4 div, 5 sin_cos.
            #[inline(always)]
            fn motion(&self, t: S, u: &Held<S>, x: &[S; 10], dx: &mut [S; 10]) {
                let lit = S::lit;
                let by = rt::Factor;
                // Masses and forces along the coordinates: M a = Q
                let bar_0_angle = x[0];
                let bar_1_angle = x[1];
                let bar_2_angle = x[2];
                let bar_3_angle = x[3];
                let (
                    [sin_bar_0_angle, sin_bar_1_angle, sin_bar_2_angle, sin_bar_3_angle],
                    [cos_bar_0_angle, cos_bar_1_angle, cos_bar_2_angle, cos_bar_3_angle],
                ) = S::sin_cos_all([bar_0_angle, bar_1_angle, bar_2_angle, bar_3_angle]);
                let m_1_0 =
                    by(3.5) * sin_bar_0_angle.mul_add(sin_bar_1_angle, cos_bar_0_angle * cos_bar_1_angle);
                let m_2_0 =
                    by(2.5) * sin_bar_0_angle.mul_add(sin_bar_2_angle, cos_bar_0_angle * cos_bar_2_angle);
                let m_3_0 =
                    by(1.5) * sin_bar_0_angle.mul_add(sin_bar_3_angle, cos_bar_0_angle * cos_bar_3_angle);
                let bar_4_angle = x[4];
                let (sin_bar_4_angle, cos_bar_4_angle) = bar_4_angle.sin_cos();
                let m_4_0 =
                    by(0.5) * sin_bar_0_angle.mul_add(sin_bar_4_angle, cos_bar_0_angle * cos_bar_4_angle);
                let bar_0_omega = x[5];
                let bar_1_omega = x[6];
                let t1 = bar_1_omega * bar_1_omega;
                let t2 = (-cos_bar_0_angle).mul_add(sin_bar_1_angle, sin_bar_0_angle * cos_bar_1_angle);
                let bar_2_omega = x[7];
                let t3 = bar_2_omega * bar_2_omega;
                let t4 = (-cos_bar_0_angle).mul_add(sin_bar_2_angle, sin_bar_0_angle * cos_bar_2_angle);
                let bar_3_omega = x[8];
                let t5 = bar_3_omega * bar_3_omega;
                let t6 = (-cos_bar_0_angle).mul_add(sin_bar_3_angle, sin_bar_0_angle * cos_bar_3_angle);
                let bar_4_omega = x[9];
                let t7 = (-cos_bar_0_angle).mul_add(sin_bar_4_angle, sin_bar_0_angle * cos_bar_4_angle);
                let t8 = by(2.5) * t3;
                let t9 = (-t8).mul_add(
                    t4,
                    (-(by(3.5) * t1))
                        .mul_add(t2, by(-44.145).mul_add(cos_bar_0_angle, by(-0.1) * bar_0_omega)),
                );
                let t10 = by(1.5) * t5;
                let t11 = by(0.5) * (bar_4_omega * bar_4_omega);
                let force_0 = (-t11).mul_add(t7, (-t10).mul_add(t6, t9));
                let t12 = bar_0_omega * bar_0_omega;
                let t13 = (-cos_bar_1_angle).mul_add(sin_bar_2_angle, sin_bar_1_angle * cos_bar_2_angle);
                let t14 = (-cos_bar_1_angle).mul_add(sin_bar_3_angle, sin_bar_1_angle * cos_bar_3_angle);
                let t15 = (-cos_bar_1_angle).mul_add(sin_bar_4_angle, sin_bar_1_angle * cos_bar_4_angle);
                let t16 = (-t10).mul_add(
                    t14,
                    (-t8).mul_add(t13, by(-34.335).mul_add(cos_bar_1_angle, by(3.5) * t12 * t2)),
                );
                let t17 = (-cos_bar_2_angle).mul_add(sin_bar_3_angle, sin_bar_2_angle * cos_bar_3_angle);
                let t18 = (-cos_bar_2_angle).mul_add(sin_bar_4_angle, sin_bar_2_angle * cos_bar_4_angle);
                let t19 = (-t10)
                    .mul_add(t17, by(-24.525).mul_add(cos_bar_2_angle, by(2.5) * t1.mul_add(t13, t12 * t4)));
                let t20 = (-cos_bar_3_angle).mul_add(sin_bar_4_angle, sin_bar_3_angle * cos_bar_4_angle);
                let t21 = by(-14.715)
                    .mul_add(cos_bar_3_angle, by(1.5) * t3.mul_add(t17, t1.mul_add(t14, t12 * t6)));
                let t22 = by(0.5) * t5.mul_add(t20, t3.mul_add(t18, t1.mul_add(t15, t12 * t7)));
                let l_1_0 = by(0.23076923076923078) * m_1_0;
                let l_2_0 = by(0.23076923076923078) * m_2_0;
                let l_3_0 = by(0.23076923076923078) * m_3_0;
                let l_4_0 = by(0.23076923076923078) * m_4_0;
                let r_1 = by(1.0) / (-m_1_0).mul_add(l_1_0, lit(3.3333333333333335));
                let g_2_1 = (-m_1_0).mul_add(
                    l_2_0,
                    by(2.5) * sin_bar_1_angle.mul_add(sin_bar_2_angle, cos_bar_1_angle * cos_bar_2_angle),
                );
                let l_2_1 = r_1 * g_2_1;
                let g_3_1 = (-m_1_0).mul_add(
                    l_3_0,
                    by(1.5) * sin_bar_1_angle.mul_add(sin_bar_3_angle, cos_bar_1_angle * cos_bar_3_angle),
                );
                let l_3_1 = r_1 * g_3_1;
                let g_4_1 = (-m_1_0).mul_add(
                    l_4_0,
                    by(0.5) * sin_bar_1_angle.mul_add(sin_bar_4_angle, cos_bar_1_angle * cos_bar_4_angle),
                );
                let l_4_1 = r_1 * g_4_1;
                let r_2 = by(1.0) / (-g_2_1).mul_add(l_2_1, (-m_2_0).mul_add(l_2_0, lit(2.3333333333333335)));
                let g_3_2 = (-g_2_1).mul_add(
                    l_3_1,
                    (-m_2_0).mul_add(
                        l_3_0,
                        by(1.5) * sin_bar_2_angle.mul_add(sin_bar_3_angle, cos_bar_2_angle * cos_bar_3_angle),
                    ),
                );
                let l_3_2 = r_2 * g_3_2;
                let g_4_2 = (-g_2_1).mul_add(
                    l_4_1,
                    (-m_2_0).mul_add(
                        l_4_0,
                        by(0.5) * sin_bar_2_angle.mul_add(sin_bar_4_angle, cos_bar_2_angle * cos_bar_4_angle),
                    ),
                );
                let l_4_2 = r_2 * g_4_2;
                let r_3 = by(1.0)
                    / (-g_3_2).mul_add(
                        l_3_2,
                        (-g_3_1).mul_add(l_3_1, (-m_3_0).mul_add(l_3_0, lit(1.3333333333333333))),
                    );
                let t23 = (-g_3_1).mul_add(
                    l_4_1,
                    (-m_3_0).mul_add(
                        l_4_0,
                        by(0.5) * sin_bar_3_angle.mul_add(sin_bar_4_angle, cos_bar_3_angle * cos_bar_4_angle),
                    ),
                );
                let g_4_3 = (-g_3_2).mul_add(l_4_2, t23);
                let l_4_3 = r_3 * g_4_3;
                let d_4 = (-g_4_3).mul_add(
                    l_4_3,
                    (-g_4_2).mul_add(
                        l_4_2,
                        (-g_4_1).mul_add(l_4_1, (-m_4_0).mul_add(l_4_0, lit(0.3333333333333333))),
                    ),
                );
                let b_1 = (-l_1_0).mul_add(force_0, (-t11).mul_add(t15, t16));
                let b_2 = (-l_2_1).mul_add(b_1, (-l_2_0).mul_add(force_0, (-t11).mul_add(t18, t19)));
                let b_3 = (-l_3_2)
                    .mul_add(b_2, (-l_3_1).mul_add(b_1, (-l_3_0).mul_add(force_0, (-t11).mul_add(t20, t21))));
                let t24 = (-l_4_2).mul_add(
                    b_2,
                    (-l_4_1)
                        .mul_add(b_1, (-l_4_0).mul_add(force_0, by(-4.905).mul_add(cos_bar_4_angle, t22))),
                );
                let bar_4_angle_acceleration = by(1.0) / d_4 * (-l_4_3).mul_add(b_3, t24);
                let bar_3_angle_acceleration = (-l_4_3).mul_add(bar_4_angle_acceleration, r_3 * b_3);
                let bar_2_angle_acceleration = (-l_4_2)
                    .mul_add(bar_4_angle_acceleration, (-l_3_2).mul_add(bar_3_angle_acceleration, r_2 * b_2));
                let bar_1_angle_acceleration = (-l_4_1).mul_add(
                    bar_4_angle_acceleration,
                    (-l_3_1).mul_add(
                        bar_3_angle_acceleration,
                        (-l_2_1).mul_add(bar_2_angle_acceleration, r_1 * b_1),
                    ),
                );
                let bar_0_angle_acceleration = (-l_4_0).mul_add(
                    bar_4_angle_acceleration,
                    (-l_3_0).mul_add(
                        bar_3_angle_acceleration,
                        (-l_2_0).mul_add(
                            bar_2_angle_acceleration,
                            (-l_1_0).mul_add(bar_1_angle_acceleration, by(0.23076923076923078) * force_0),
                        ),
                    ),
                );
                // Results
                dx[0] = bar_0_omega;
                dx[1] = bar_1_omega;
                dx[2] = bar_2_omega;
                dx[3] = bar_3_omega;
                dx[4] = bar_4_omega;
                dx[5] = bar_0_angle_acceleration;
                dx[6] = bar_1_angle_acceleration;
                dx[7] = bar_2_angle_acceleration;
                dx[8] = bar_3_angle_acceleration;
                dx[9] = bar_4_angle_acceleration;
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            ///
            /// 32 add, 30 mul, 5 sin_cos.
            #[inline]
            fn pose(&self, t: S, u: &Held<S>, x: &[S; 10], q: &mut [S; 15], v: &mut [S; 15]) {
                let by = rt::Factor;
                let bar_0_angle = x[0];
                let bar_1_angle = x[1];
                let bar_2_angle = x[2];
                let bar_3_angle = x[3];
                let (
                    [sin_bar_0_angle, sin_bar_1_angle, sin_bar_2_angle, sin_bar_3_angle],
                    [cos_bar_0_angle, cos_bar_1_angle, cos_bar_2_angle, cos_bar_3_angle],
                ) = S::sin_cos_all([bar_0_angle, bar_1_angle, bar_2_angle, bar_3_angle]);
                let bar_0_x = by(0.5) * cos_bar_0_angle;
                q[0] = bar_0_x;
                let bar_0_y = by(0.5) * sin_bar_0_angle;
                q[1] = bar_0_y;
                q[2] = bar_0_angle;
                let bar_1_x = by(0.5).mul_add(cos_bar_0_angle + cos_bar_1_angle, bar_0_x);
                q[3] = bar_1_x;
                let bar_1_y = by(0.5).mul_add(sin_bar_0_angle + sin_bar_1_angle, bar_0_y);
                q[4] = bar_1_y;
                q[5] = bar_1_angle;
                let bar_2_x = by(0.5).mul_add(cos_bar_1_angle + cos_bar_2_angle, bar_1_x);
                q[6] = bar_2_x;
                let bar_2_y = by(0.5).mul_add(sin_bar_1_angle + sin_bar_2_angle, bar_1_y);
                q[7] = bar_2_y;
                q[8] = bar_2_angle;
                let bar_3_x = by(0.5).mul_add(cos_bar_2_angle + cos_bar_3_angle, bar_2_x);
                q[9] = bar_3_x;
                let bar_3_y = by(0.5).mul_add(sin_bar_2_angle + sin_bar_3_angle, bar_2_y);
                q[10] = bar_3_y;
                q[11] = bar_3_angle;
                let bar_4_angle = x[4];
                let (sin_bar_4_angle, cos_bar_4_angle) = bar_4_angle.sin_cos();
                q[12] = by(0.5).mul_add(cos_bar_3_angle + cos_bar_4_angle, bar_3_x);
                q[13] = by(0.5).mul_add(sin_bar_3_angle + sin_bar_4_angle, bar_3_y);
                q[14] = bar_4_angle;
                let bar_0_omega = x[5];
                let t1 = bar_0_omega * sin_bar_0_angle;
                let bar_0_vx = by(-0.5) * t1;
                v[0] = bar_0_vx;
                let t2 = bar_0_omega * cos_bar_0_angle;
                let bar_0_vy = by(0.5) * t2;
                v[1] = bar_0_vy;
                v[2] = bar_0_omega;
                let bar_1_omega = x[6];
                let t3 = bar_1_omega * sin_bar_1_angle;
                let bar_1_vx = by(-0.5).mul_add(t1 + t3, bar_0_vx);
                v[3] = bar_1_vx;
                let t4 = bar_1_omega * cos_bar_1_angle;
                let bar_1_vy = by(0.5).mul_add(t2 + t4, bar_0_vy);
                v[4] = bar_1_vy;
                v[5] = bar_1_omega;
                let bar_2_omega = x[7];
                let t5 = bar_2_omega * sin_bar_2_angle;
                let bar_2_vx = by(-0.5).mul_add(t3 + t5, bar_1_vx);
                v[6] = bar_2_vx;
                let t6 = bar_2_omega * cos_bar_2_angle;
                let bar_2_vy = by(0.5).mul_add(t4 + t6, bar_1_vy);
                v[7] = bar_2_vy;
                v[8] = bar_2_omega;
                let bar_3_omega = x[8];
                let t7 = bar_3_omega * sin_bar_3_angle;
                let bar_3_vx = by(-0.5).mul_add(t5 + t7, bar_2_vx);
                v[9] = bar_3_vx;
                let t8 = bar_3_omega * cos_bar_3_angle;
                let bar_3_vy = by(0.5).mul_add(t6 + t8, bar_2_vy);
                v[10] = bar_3_vy;
                v[11] = bar_3_omega;
                let bar_4_omega = x[9];
                v[12] = by(-0.5).mul_add(bar_4_omega.mul_add(sin_bar_4_angle, t7), bar_3_vx);
                v[13] = by(0.5).mul_add(bar_4_omega.mul_add(cos_bar_4_angle, t8), bar_3_vy);
                v[14] = bar_4_omega;
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart(&self, t: S, q: &[S; 15], v: &[S; 15], x: &mut [S; 10]) {
                x[0] = q[2];
                x[1] = q[5];
                x[2] = q[8];
                x[3] = q[11];
                x[4] = q[14];
                x[5] = v[2];
                x[6] = v[5];
                x[7] = v[8];
                x[8] = v[11];
                x[9] = v[14];
            }
        }

        impl<S: Scalar> Chain<S> {
            /// The coefficients of the linearised equations before anything is eliminated; `dx` is the rate there.
            ///
            /// 60 add, 163 mul, 4 neg, 5 sin_cos.
            fn linearised(&self, t: S, u: &Held<S>, x: &[S; 10], dx: &[S; 10], c: &mut [S; 61]) {
                let lit = S::lit;
                let by = rt::Factor;
                // Derivatives of M a - Q and of the rates of the states
                let bar_0_angle = x[0];
                let bar_1_angle = x[1];
                let bar_2_angle = x[2];
                let bar_3_angle = x[3];
                let (
                    [sin_bar_0_angle, sin_bar_1_angle, sin_bar_2_angle, sin_bar_3_angle],
                    [cos_bar_0_angle, cos_bar_1_angle, cos_bar_2_angle, cos_bar_3_angle],
                ) = S::sin_cos_all([bar_0_angle, bar_1_angle, bar_2_angle, bar_3_angle]);
                let t1 = (-cos_bar_0_angle).mul_add(sin_bar_1_angle, sin_bar_0_angle * cos_bar_1_angle);
                let acceleration = dx[6];
                let bar_1_omega = x[6];
                let t2 = bar_1_omega * bar_1_omega;
                let t3 = sin_bar_0_angle.mul_add(sin_bar_1_angle, cos_bar_0_angle * cos_bar_1_angle);
                let t4 = (-t1).mul_add(acceleration, t2 * t3);
                let t5 = (-cos_bar_0_angle).mul_add(sin_bar_2_angle, sin_bar_0_angle * cos_bar_2_angle);
                let acceleration_2 = dx[7];
                let bar_2_omega = x[7];
                let t6 = bar_2_omega * bar_2_omega;
                let t7 = sin_bar_0_angle.mul_add(sin_bar_2_angle, cos_bar_0_angle * cos_bar_2_angle);
                let t8 = (-t5).mul_add(acceleration_2, t6 * t7);
                let t9 = (-cos_bar_0_angle).mul_add(sin_bar_3_angle, sin_bar_0_angle * cos_bar_3_angle);
                let acceleration_3 = dx[8];
                let bar_3_omega = x[8];
                let t10 = bar_3_omega * bar_3_omega;
                let t11 = sin_bar_0_angle.mul_add(sin_bar_3_angle, cos_bar_0_angle * cos_bar_3_angle);
                let t12 = (-t9).mul_add(acceleration_3, t10 * t11);
                let bar_4_angle = x[4];
                let (sin_bar_4_angle, cos_bar_4_angle) = bar_4_angle.sin_cos();
                let t13 = (-cos_bar_0_angle).mul_add(sin_bar_4_angle, sin_bar_0_angle * cos_bar_4_angle);
                let acceleration_4 = dx[9];
                let bar_4_omega = x[9];
                let t14 = bar_4_omega * bar_4_omega;
                let t15 = sin_bar_0_angle.mul_add(sin_bar_4_angle, cos_bar_0_angle * cos_bar_4_angle);
                let t16 = (-t13).mul_add(acceleration_4, t14 * t15);
                let t17 = by(0.5).mul_add(
                    t16,
                    by(1.5).mul_add(
                        t12,
                        by(2.5).mul_add(t8, by(-44.145).mul_add(sin_bar_0_angle, by(3.5) * t4)),
                    ),
                );
                let t18 = by(5.0) * bar_2_omega;
                let t19 = by(3.0) * bar_3_omega;
                let acceleration_5 = dx[5];
                let bar_0_omega = x[5];
                let t20 = bar_0_omega * bar_0_omega;
                let t21 = t20.mul_add(t3, t1 * acceleration_5);
                let t22 = (-cos_bar_1_angle).mul_add(sin_bar_2_angle, sin_bar_1_angle * cos_bar_2_angle);
                let t23 = sin_bar_1_angle.mul_add(sin_bar_2_angle, cos_bar_1_angle * cos_bar_2_angle);
                let t24 = (-t22).mul_add(acceleration_2, t6 * t23);
                let t25 = (-cos_bar_1_angle).mul_add(sin_bar_3_angle, sin_bar_1_angle * cos_bar_3_angle);
                let t26 = sin_bar_1_angle.mul_add(sin_bar_3_angle, cos_bar_1_angle * cos_bar_3_angle);
                let t27 = (-t25).mul_add(acceleration_3, t10 * t26);
                let t28 = (-cos_bar_1_angle).mul_add(sin_bar_4_angle, sin_bar_1_angle * cos_bar_4_angle);
                let t29 = sin_bar_1_angle.mul_add(sin_bar_4_angle, cos_bar_1_angle * cos_bar_4_angle);
                let t30 = (-t28).mul_add(acceleration_4, t14 * t29);
                let t31 = by(0.5).mul_add(
                    t30,
                    by(1.5).mul_add(
                        t27,
                        by(2.5).mul_add(t24, by(-34.335).mul_add(sin_bar_1_angle, by(3.5) * t21)),
                    ),
                );
                let t32 = t20.mul_add(t7, t5 * acceleration_5);
                let t33 = t2.mul_add(t23, t22 * acceleration);
                let t34 = (-cos_bar_2_angle).mul_add(sin_bar_3_angle, sin_bar_2_angle * cos_bar_3_angle);
                let t35 = sin_bar_2_angle.mul_add(sin_bar_3_angle, cos_bar_2_angle * cos_bar_3_angle);
                let t36 = (-t34).mul_add(acceleration_3, t10 * t35);
                let t37 = (-cos_bar_2_angle).mul_add(sin_bar_4_angle, sin_bar_2_angle * cos_bar_4_angle);
                let t38 = sin_bar_2_angle.mul_add(sin_bar_4_angle, cos_bar_2_angle * cos_bar_4_angle);
                let t39 = (-t37).mul_add(acceleration_4, t14 * t38);
                let t40 = by(2.5).mul_add(
                    t32 + t33,
                    by(0.5).mul_add(t39, by(-24.525).mul_add(sin_bar_2_angle, by(1.5) * t36)),
                );
                let t41 = t20.mul_add(t11, t9 * acceleration_5);
                let t42 = t2.mul_add(t26, t25 * acceleration);
                let t43 = t6.mul_add(t35, t34 * acceleration_2);
                let t44 = (-cos_bar_3_angle).mul_add(sin_bar_4_angle, sin_bar_3_angle * cos_bar_4_angle);
                let t45 = sin_bar_3_angle.mul_add(sin_bar_4_angle, cos_bar_3_angle * cos_bar_4_angle);
                let t46 = (-t44).mul_add(acceleration_4, t14 * t45);
                let t47 = t20.mul_add(t15, t13 * acceleration_5);
                let t48 = t2.mul_add(t29, t28 * acceleration);
                let t49 = t6.mul_add(t38, t37 * acceleration_2);
                let t50 = t10.mul_add(t45, t44 * acceleration_3);
                // Results
                c[0] = t17;
                c[1] = lit(0.1);
                c[2] = lit(4.333333333333333);
                c[3] = by(-3.5) * t4;
                c[4] = by(7.0) * bar_1_omega * t1;
                c[5] = by(3.5) * t3;
                c[6] = by(-2.5) * t8;
                c[7] = t18 * t5;
                c[8] = by(2.5) * t7;
                c[9] = by(-1.5) * t12;
                c[10] = t19 * t9;
                c[11] = by(1.5) * t11;
                c[12] = by(-0.5) * t16;
                c[13] = bar_4_omega * t13;
                c[14] = by(0.5) * t15;
                c[15] = by(-3.5) * t21;
                c[16] = by(-7.0) * bar_0_omega * t1;
                c[17] = t31;
                c[18] = lit(3.3333333333333335);
                c[19] = by(-2.5) * t24;
                c[20] = t18 * t22;
                c[21] = by(2.5) * t23;
                c[22] = by(-1.5) * t27;
                c[23] = t19 * t25;
                c[24] = by(1.5) * t26;
                c[25] = by(-0.5) * t30;
                c[26] = bar_4_omega * t28;
                c[27] = by(0.5) * t29;
                c[28] = by(-2.5) * t32;
                c[29] = by(-5.0) * bar_0_omega * t5;
                c[30] = by(-2.5) * t33;
                c[31] = by(-5.0) * bar_1_omega * t22;
                c[32] = t40;
                c[33] = lit(2.3333333333333335);
                c[34] = by(-1.5) * t36;
                c[35] = t19 * t34;
                c[36] = by(1.5) * t35;
                c[37] = by(-0.5) * t39;
                c[38] = bar_4_omega * t37;
                c[39] = by(0.5) * t38;
                c[40] = by(-1.5) * t41;
                c[41] = by(-3.0) * bar_0_omega * t9;
                c[42] = by(-1.5) * t42;
                c[43] = by(-3.0) * bar_1_omega * t25;
                c[44] = by(-1.5) * t43;
                c[45] = by(-3.0) * bar_2_omega * t34;
                c[46] = by(1.5).mul_add(t41 + t42 + t43, by(-14.715).mul_add(sin_bar_3_angle, by(0.5) * t46));
                c[47] = lit(1.3333333333333333);
                c[48] = by(-0.5) * t46;
                c[49] = bar_4_omega * t44;
                c[50] = by(0.5) * t45;
                c[51] = by(-0.5) * t47;
                c[52] = -(bar_0_omega * t13);
                c[53] = by(-0.5) * t48;
                c[54] = -(bar_1_omega * t28);
                c[55] = by(-0.5) * t49;
                c[56] = -(bar_2_omega * t37);
                c[57] = by(-0.5) * t50;
                c[58] = -(bar_3_omega * t44);
                c[59] = by(-4.905).mul_add(sin_bar_4_angle, by(0.5) * (t47 + t48 + t49 + t50));
                c[60] = lit(0.3333333333333333);
            }
        }

        /// Places of the coefficients of the linearised equations, and the order of their elimination.
        #[doc(hidden)]
        #[derive(Clone, Copy, Debug)]
        pub struct Augmented<S>(core::marker::PhantomData<S>);

        impl<S: Real> rt::linalg::Patterned for Augmented<S> {
            const PATTERN: rt::linalg::Pattern = rt::linalg::Pattern {
                coordinates: 5,
                states: 0,
                terms: const {
                    &rt::compact::terms::<71>(&rt::compact::numbers::<355>(&[
                        (1, &[0, 0, 0, 0, 2, 1, 0, 0, 0, 3, 2, 0, 0, 0, 4], &[]),
                        (
                            4,
                            &[3, 0, 1, 5, 2, 4, 0, 1, 5, 3, 5, 0, 1, 5, 4],
                            &[3, 0, 1, 1, 0, 3, 0, 1, 1, 0, 3, 0, 1, 1, 0],
                        ),
                        (
                            1,
                            &[
                                15, 1, 0, 1, 2, 16, 1, 0, 1, 3, 5, 1, 0, 1, 4, 17, 1, 1, 9, 2, 18, 1, 1, 9,
                                4, 19, 1, 2, 13, 2, 20, 1, 2, 13, 3, 21, 1, 2, 13, 4, 22, 1, 3, 14, 2, 23, 1,
                                3, 14, 3, 24, 1, 3, 14, 4, 25, 1, 4, 15, 2, 26, 1, 4, 15, 3, 27, 1, 4, 15, 4,
                                28, 2, 0, 2, 2, 29, 2, 0, 2, 3, 8, 2, 0, 2, 4, 30, 2, 1, 10, 2, 31, 2, 1, 10,
                                3, 21, 2, 1, 10, 4, 32, 2, 2, 16, 2, 33, 2, 2, 16, 4, 34, 2, 3, 19, 2, 35, 2,
                                3, 19, 3, 36, 2, 3, 19, 4, 37, 2, 4, 20, 2, 38, 2, 4, 20, 3, 39, 2, 4, 20, 4,
                                40, 3, 0, 3, 2, 41, 3, 0, 3, 3, 11, 3, 0, 3, 4, 42, 3, 1, 11, 2, 43, 3, 1,
                                11, 3, 24, 3, 1, 11, 4, 44, 3, 2, 17, 2, 45, 3, 2, 17, 3, 36, 3, 2, 17, 4,
                                46, 3, 3, 21, 2, 47, 3, 3, 21, 4, 48, 3, 4, 23, 2, 49, 3, 4, 23, 3, 50, 3, 4,
                                23, 4, 51, 4, 0, 4, 2, 52, 4, 0, 4, 3, 14, 4, 0, 4, 4, 53, 4, 1, 12, 2, 54,
                                4, 1, 12, 3, 27, 4, 1, 12, 4, 55, 4, 2, 18, 2, 56, 4, 2, 18, 3, 39, 4, 2, 18,
                                4, 57, 4, 3, 22, 2, 58, 4, 3, 22, 3, 50, 4, 3, 22, 4, 59, 4, 4, 24, 2, 60, 4,
                                4, 24, 4,
                            ],
                            &[],
                        ),
                    ]))
                },
                pivots: const {
                    &rt::compact::pivots::<5>(&rt::compact::numbers::<35>(&[(
                        1,
                        &[
                            0, 0, 0, 4, 0, 4, 0, 1, 9, 4, 7, 4, 7, 16, 2, 16, 7, 9, 7, 9, 25, 3, 21, 9, 10,
                            9, 10, 29, 4, 24, 10, 10, 10, 10, 30,
                        ],
                        &[],
                    )]))
                },
                below: const {
                    &rt::compact::below::<10>(&rt::compact::numbers::<30>(&[(
                        1,
                        &[
                            1, 1, 5, 2, 2, 6, 3, 3, 7, 4, 4, 8, 2, 10, 13, 3, 11, 14, 4, 12, 15, 3, 17, 19,
                            4, 18, 20, 4, 22, 23,
                        ],
                        &[],
                    )]))
                },
                right: const {
                    &rt::compact::pairs::<10>(&rt::compact::numbers::<20>(&[(
                        1,
                        &[1, 5, 2, 6, 3, 7, 4, 8, 2, 13, 3, 14, 4, 15, 3, 19, 4, 20, 4, 23],
                        &[],
                    )]))
                },
                targets: const {
                    &rt::compact::numbers::<30>(&[(
                        1,
                        &[
                            9, 13, 14, 15, 10, 16, 19, 20, 11, 17, 21, 23, 12, 18, 22, 24, 16, 19, 20, 17,
                            21, 23, 18, 22, 24, 21, 23, 22, 24, 24,
                        ],
                        &[],
                    )])
                },
            };
        }
    }
}
