#[doc(inline)]
#[allow(unreachable_pub)]
pub use plm_plate_on_three_pins_::plate_on_three_pins::PlateOnThreePins;

#[doc(inline)]
#[allow(unreachable_pub, unused_imports)]
pub use plm_plate_on_three_pins_::plate_on_three_pins;
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]
mod plm_plate_on_three_pins_ {
    /// A plate on the pins of three driven cranks: an angle and three slides that only Newton's iteration finds.
    ///
    /// 4 bodies, 9 parts: 12 coordinates, 12 constraint rows, F = 3 N - M = 0.
    /// Formulation 1: kinematics; no freedom is left, and the motion follows from the time alone.
    /// Chart 0: none; then explicit crank[0].angle; explicit crank[1].angle; explicit crank[2].angle; Newton of 4 unknowns in 3 steps: plate.angle, slot[0].displacement, slot[1].displacement, slot[2].displacement.
    /// State: 0 numbers, 0 bytes in f64.
    /// A solution by rank, where one is needed: 2304 bytes of stack in f64.
    /// One right-hand side: 183 add, 273 mul, 7 div, 18 neg, 6 sin_cos, 4 select.
    ///
    /// | row | constraint | equation | unit |
    /// |----:|------------|----------|------|
    /// | 0 | `o[0].x` | `crank[0].x - 0.1*cos(crank[0].angle) = 0` | m |
    /// | 1 | `o[0].y` | `crank[0].y - 0.1*sin(crank[0].angle) = 0` | m |
    /// | 2 | `o[1].x` | `crank[1].x - 0.1*cos(crank[1].angle) - 1 = 0` | m |
    /// | 3 | `o[1].y` | `crank[1].y - 0.1*sin(crank[1].angle) = 0` | m |
    /// | 4 | `o[2].x` | `crank[2].x - 0.1*cos(crank[2].angle) - 0.5 = 0` | m |
    /// | 5 | `o[2].y` | `crank[2].y - 0.1*sin(crank[2].angle) - 0.9 = 0` | m |
    /// | 6 | `slot[0].normal` | `(0.573576436351046*cos(plate.angle) + 0.8191520442889918*sin(plate.angle))*(crank[0].x + 0.1*cos(crank[0].angle) - plate.x + 0.4*cos(plate.angle) - 0.3*sin(plate.angle)) - (0.8191520442889918*cos(plate.angle) - 0.573576436351046*sin(plate.angle))*(crank[0].y + 0.1*sin(crank[0].angle) - plate.y + 0.3*cos(plate.angle) + 0.4*sin(plate.angle)) = 0` | m |
    /// | 7 | `slot[1].normal` | `(0.6427876096865393*cos(plate.angle) - 0.766044443118978*sin(plate.angle))*(crank[1].x + 0.1*cos(crank[1].angle) - plate.x - 0.4*cos(plate.angle) - 0.3*sin(plate.angle)) + (0.766044443118978*cos(plate.angle) + 0.6427876096865393*sin(plate.angle))*(crank[1].y + 0.1*sin(crank[1].angle) - plate.y + 0.3*cos(plate.angle) - 0.4*sin(plate.angle)) = 0` | m |
    /// | 8 | `slot[2].normal` | `(0.984807753012208*cos(plate.angle) - 0.17364817766693033*sin(plate.angle))*(crank[2].x + 0.1*cos(crank[2].angle) - plate.x + 0.4*sin(plate.angle)) + (0.17364817766693033*cos(plate.angle) + 0.984807753012208*sin(plate.angle))*(crank[2].y + 0.1*sin(crank[2].angle) - plate.y - 0.4*cos(plate.angle)) = 0` | m |
    /// | 9 | `first` | `crank[0].angle - 0.4*sin(3*t) = 0` | rad |
    /// | 10 | `second` | `crank[1].angle - 0.3*cos(2*t) = 0` | rad |
    /// | 11 | `third` | `crank[2].angle - 0.2*sin(4*t) + 0.1 = 0` | rad |
    pub mod plate_on_three_pins {
        pub use super::code_::*;
        pub use super::type_::PlateOnThreePins;
    }

    mod type_ {
        /// A plate on the pins of three driven cranks: an angle and three slides that only Newton's iteration finds.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct PlateOnThreePins<S = ::core::primitive::f64> {
            /// Start values of the bodies, and which of them assembly keeps.
            pub start: super::code_::Starts<S>,
        }
    }

    mod code_ {
        use super::type_::PlateOnThreePins;
        use ::plm::runtime::generated as rt;
        use ::plm::runtime::generated::lanes::Two;
        use ::plm::runtime::generated::{
            BodyStart, BodyState, Fault, Method, Operations, Real, Scalar, Sim, Start,
        };
        use ::plm::runtime::generated::{absolute, described};

        /// Start values, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Starts<S = f64> {
            /// Origin of body `crank[0]`.
            pub crank_0: BodyStart<S>,
            /// Origin of body `crank[1]`.
            pub crank_1: BodyStart<S>,
            /// Origin of body `crank[2]`.
            pub crank_2: BodyStart<S>,
            /// Origin of body `plate`.
            pub plate: BodyStart<S>,
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
            rt::charts::OfLoops<rt::charts::Continuation<S, 0, 4, 1, 4>, [S; 12]>,
        >;

        /// Pose, accelerations and a vector, which outputs have in common.
        type Common<S> = rt::Common<([S; 12], [S; 12]), Held<S>, ([S; 12], [S; 12]), [S; 2]>;

        /// The mechanism at one moment; its methods read poses and outputs, `input` has the inputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: PlateOnThreePins<S>,
            held: rt::Held<
                Input<S>,
                [S; 0],
                [i32; 1],
                rt::charts::OfLoops<rt::charts::Continuation<S, 0, 4, 1, 4>, [S; 12]>,
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
        pub const NQ: usize = 12;
        /// Constraint rows.
        pub const NC: usize = 12;
        /// First-order states.
        pub const NX: usize = 0;
        /// Degrees of freedom, `3 N - M`.
        pub const NDOF: isize = 0;
        /// Operations of one evaluation of the right-hand side.
        pub const OPERATIONS: Operations =
            Operations { add: 201, mul: 273, div: 7, sqrt: 0, sin_cos: 6, other: 4 };
        impl<S: Real> State<S> {
            /// Time, s.
            pub fn time(&self) -> S {
                self.time
            }

            /// Pose and velocity of G of body `crank[0]`: m, m, rad; m/s, m/s, rad/s.
            pub fn crank_0(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[0], q[1], q[2]], [v[0], v[1], v[2]])
            }

            /// Pose and velocity of G of body `crank[1]`: m, m, rad; m/s, m/s, rad/s.
            pub fn crank_1(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[3], q[4], q[5]], [v[3], v[4], v[5]])
            }

            /// Pose and velocity of G of body `crank[2]`: m, m, rad; m/s, m/s, rad/s.
            pub fn crank_2(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[6], q[7], q[8]], [v[6], v[7], v[8]])
            }

            /// Pose and velocity of G of body `plate`: m, m, rad; m/s, m/s, rad/s.
            pub fn plate(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of(
                    [q[9], q[10], rt::turns::whole(q[11], self.held.turns[0])],
                    [v[9], v[10], v[11]],
                )
            }

            /// Output `slot[2].force`, N.
            ///
            /// What the slot does to `plate` at the point of `crank[2].p`, absolute axes; `crank[2]` feels the opposite.
            pub fn slot_2_force(&self) -> [S; 2] {
                self.slot_2_force_among_(&Common::<S>::new())
            }

            #[inline]
            fn slot_2_force_among_(&self, common: &Common<S>) -> [S; 2] {
                let mut value = [S::lit(0.0); 2];
                let (_, lambda) = common.solved.get_or_init(|| self.solved_(common));
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let lambda_slot_2_normal = lambda[8];
                let plate_angle = q[11];
                let by = rt::Factor;
                let (sin_plate_angle, cos_plate_angle) = plate_angle.sin_cos();
                value[0] = lambda_slot_2_normal
                    * by(-0.17364817766693033)
                        .mul_add(sin_plate_angle, by(0.984807753012208) * cos_plate_angle);
                value[1] = lambda_slot_2_normal
                    * by(0.984807753012208)
                        .mul_add(sin_plate_angle, by(0.17364817766693033) * cos_plate_angle);
                value
            }

            /// Kinetic energy of all bodies, J.
            pub fn kinetic_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [
                    crank_0_vx,
                    crank_0_vy,
                    crank_0_omega,
                    crank_1_vx,
                    crank_1_vy,
                    crank_1_omega,
                    crank_2_vx,
                    crank_2_vy,
                    crank_2_omega,
                    plate_vx,
                    plate_vy,
                    plate_omega,
                    ..,
                ] = *v;
                let by = rt::Factor;
                let t1 = crank_2_vx.mul_add(
                    crank_2_vx,
                    crank_1_vy.mul_add(
                        crank_1_vy,
                        crank_1_vx
                            .mul_add(crank_1_vx, crank_0_vy.mul_add(crank_0_vy, crank_0_vx * crank_0_vx)),
                    ),
                );
                let t2 = by(0.15).mul_add(
                    plate_omega.mul_add(plate_omega, crank_2_vy.mul_add(crank_2_vy, t1)),
                    plate_vy.mul_add(plate_vy, plate_vx * plate_vx),
                );
                by(0.005).mul_add(
                    crank_2_omega.mul_add(
                        crank_2_omega,
                        crank_1_omega.mul_add(crank_1_omega, crank_0_omega * crank_0_omega),
                    ),
                    t2,
                )
            }

            /// Potential energy of gravity above the origin, J.
            pub fn gravity_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let crank_0_y = q[1];
                let crank_1_y = q[4];
                let crank_2_y = q[7];
                let plate_y = q[10];
                let by = rt::Factor;
                by(2.943).mul_add(crank_0_y + crank_1_y + crank_2_y, by(19.62) * plate_y)
            }

            /// Power of all forces and torques but gravity and reactions, W.
            pub fn load_power(&self) -> S {
                let common = &Common::<S>::new();
                let (q, v) = common.pose.get_or_init(|| self.pose_());
                let [
                    crank_0_x,
                    crank_0_y,
                    crank_0_angle,
                    _,
                    _,
                    _,
                    _,
                    _,
                    _,
                    plate_x,
                    plate_y,
                    plate_angle,
                    ..,
                ] = *q;
                let [
                    crank_0_vx,
                    crank_0_vy,
                    crank_0_omega,
                    _,
                    _,
                    _,
                    _,
                    _,
                    _,
                    plate_vx,
                    plate_vy,
                    plate_omega,
                    ..,
                ] = *v;
                let by = rt::Factor;
                let ([sin_plate_angle, sin_crank_0_angle], [cos_plate_angle, cos_crank_0_angle]) =
                    S::sin_cos_all([plate_angle, crank_0_angle]);
                let t1 =
                    by(-0.573576436351046).mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle);
                let t2 = by(-0.3).mul_add(sin_plate_angle, by(0.4) * cos_plate_angle);
                let t3 =
                    by(0.8191520442889918).mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle);
                let t4 = by(0.4).mul_add(sin_plate_angle, by(0.3) * cos_plate_angle);
                let t5 = t3.mul_add(
                    by(0.1).mul_add(sin_crank_0_angle, crank_0_y) - plate_y + t4,
                    t1 * (by(0.1).mul_add(cos_crank_0_angle, crank_0_x) - plate_x + t2),
                );
                let t6 = t5.mul_add(
                    t3.mul_add(crank_0_vy - plate_vy, t1 * (crank_0_vx - plate_vx)),
                    plate_omega * (t5 * (-t4).mul_add(t1, t2 * t3)),
                );
                let t7 = by(-100.0).mul_add(
                    t6,
                    by(-10.0)
                        * crank_0_omega
                        * (t5 * (-sin_crank_0_angle).mul_add(t1, cos_crank_0_angle * t3)),
                );
                t7
            }

            /// Pose and velocity of G of body `crank[i]`, m, m, rad; m/s, m/s, rad/s; none if there is no such body.
            pub fn crank(&self, i: usize) -> Option<BodyState<S>> {
                let body = match i {
                    0 => 0,
                    1 => 1,
                    2 => 2,
                    _ => return None,
                };
                let (q, v): ([S; 12], [S; 12]) = self.unwrapped_pose_();
                BodyState::among(&q, &v, body)
            }

            /// Output `slot[i].force`, N; none if there is no such output.
            pub fn slot_force(&self, i: usize) -> Option<[S; 2]> {
                Some(match i {
                    2 => self.slot_2_force(),
                    _ => return None,
                })
            }

            /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
            /// the second turns from the first, rad, positive to the left.
            pub fn branches(&self) -> [(&'static str, S); 0] {
                let mut value = [S::lit(0.0); 0];
                []
            }

            /// Names and units of the columns of [`State::outputs`].
            pub const OUTPUTS: [(&'static str, &'static str); 2] =
                [("slot[2].force.x", "N"), ("slot[2].force.y", "N")];
            /// The declared outputs, in the units of [`State::OUTPUTS`].
            pub fn outputs(&self) -> [S; 2] {
                let common = &Common::<S>::new();
                let own_0 = self.slot_2_force_among_(common);
                [own_0[0], own_0[1]]
            }

            /// Names and SI units of the outputs and of all that is observed.
            pub const OBSERVED: [(&'static str, &'static str); 2] =
                [("slot[2].force.x", "N"), ("slot[2].force.y", "N")];

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
                        0 => common.vector(0, || state.slot_2_force_among_(common))[0],
                        1 => common.vector(0, || state.slot_2_force_among_(common))[1],
                        _ => S::lit(f64::NAN),
                    }
                }
                match column / 200 {
                    0 => block_0(self, column, common),
                    _ => S::lit(f64::NAN),
                }
            }
        }

        impl PlateOnThreePins<f64> {
            /// The mechanism as declared, in `f64`; `PlateOnThreePins { field: value, ..PlateOnThreePins::new() }` changes some.
            pub fn new() -> Self {
                Self::of()
            }
        }

        impl Default for PlateOnThreePins<f64> {
            fn default() -> Self {
                Self::of()
            }
        }

        impl<S: Scalar> PlateOnThreePins<S> {
            /// The mechanism as declared, for any scalar.
            pub fn of() -> Self {
                let lit = S::lit;
                let start = Starts {
                    crank_0: BodyStart {
                        x: Start::free(lit(0.1)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.3490658503988659)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    crank_1: BodyStart {
                        x: Start::free(lit(1.1)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.3490658503988659)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    crank_2: BodyStart {
                        x: Start::free(lit(0.6)),
                        y: Start::free(lit(0.9)),
                        angle: Start::free(lit(-0.3490658503988659)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    plate: BodyStart {
                        x: Start::free(lit(0.5)),
                        y: Start::free(lit(0.3)),
                        angle: Start::free(lit(0.0)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                };
                PlateOnThreePins { start }
            }
        }

        impl<S: Real> PlateOnThreePins<S> {
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

        impl<S: Scalar> PlateOnThreePins<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> Input<S> {
                Input { none: core::marker::PhantomData }
            }
        }

        impl<S: Real> rt::charts::Charted for PlateOnThreePins<S> {
            type Input = Input<S>;
            type Switches = [S; 0];
            type Turns = [i32; 1];
            type Contact = ();
            type Continuation = rt::charts::Continuation<S, 0, 4, 1, 4>;
            type Q = [S; 12];
            const CHARTS: rt::charts::Charts = rt::charts::Charts {
                count: 1,
                revolutions: &[rt::charts::Revolutions { coordinates: &[&[]], angles: &[3], iterated: &[0] }],
                is_loose: false,
                turning: &["crank[0]", "crank[1]", "crank[2]", "plate"],
                found: &[&[3]],
                iterated: &["plate", "slot[0]", "slot[1]", "slot[2]"],
                closing: &[&["o[1]"]],
            };

            fn pose(&self, t: S, held: &Self::U, x: &[S; 0]) -> ([S; 12], [S; 12], S) {
                let (mut q, mut v) = ([S::lit(0.0); 12], [S::lit(0.0); 12]);
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

            fn continuation_at(
                &self,
                chart: usize,
                t: S,
                q: &[S; 12],
                v: &[S; 12],
            ) -> (Self::Continuation, S) {
                let mut memory: Self::Continuation = rt::charts::ContinuationData::nothing();
                let measure = self.remember_pose_0(t, q, v, &mut memory);
                (memory, measure)
            }

            fn to_chart(&self, chart: usize, t: S, q: &[S; 12], v: &[S; 12], x: &mut [S; 0]) {
                self.to_chart_0(t, q, v, x)
            }
        }

        impl<S: Scalar> PlateOnThreePins<S> {
            fn remember_(
                &self,
                t: S,
                held: &Held<S>,
                x: &[S; 0],
            ) -> (rt::charts::Continuation<S, 0, 4, 1, 4>, S) {
                let mut memory: rt::charts::Continuation<S, 0, 4, 1, 4> =
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

        impl<S: Scalar> rt::Rate for PlateOnThreePins<S> {
            type S = S;
            type X = [S; 0];
            type U = Held<S>;
            const NQ: usize = 0;
            #[inline]
            fn rate(&self, t: S, u: &Self::U, x: &[S; 0], dx: &mut [S; 0]) -> rt::Health<S> {
                rt::Health(match &u.of_loops {
                    rt::charts::OfLoops::InChart { continuation: m, .. } => self.motion_0(t, u, m, x, dx),
                    rt::charts::OfLoops::Free { q: free_q, v: free_v } => S::lit(0.0),
                })
            }

            const PAIRED: bool = S::REGISTERS.pays_in_pairs(false);
            #[inline]
            fn rate_pair(
                &self,
                t: [S; 2],
                u: &Self::U,
                x: [&[S; 0]; 2],
                dx: &mut [[S; 0]; 2],
                second: impl FnOnce(&[S; 0]) -> [S; 0],
            ) -> rt::Health<S> {
                let rt::charts::OfLoops::InChart { chart: 0, continuation: m } = &u.of_loops else {
                    let (k, health) = rt::system::rate_aside(self, t[0], u, *x[0]);
                    dx[0] = k;
                    let (k, other) = rt::system::rate_aside(self, t[1], u, second(&k));
                    dx[1] = k;
                    return health.worst(other);
                };
                let shared = Self::of_two_poses(m, Two(t));
                let health = self.rate_at_pose::<false>(t[0], u, m, x[0], &shared, &mut dx[0]);
                let next = second(&dx[0]);
                health.worst(self.rate_at_pose::<true>(t[1], u, m, &next, &shared, &mut dx[1]))
            }

            #[inline]
            fn typical(&self) -> [S; 0] {
                [].map(S::lit)
            }
        }

        impl<S: Scalar> PlateOnThreePins<S> {
            /// Values of the poses of two stages that their rates share. Compilers begin to build vectors where results are stored: a
            /// function of its own.
            #[inline(never)]
            fn of_two_poses(m: &rt::charts::Continuation<S, 0, 4, 1, 4>, t: Two<S>) -> [Two<S>; 1] {
                let x: &[Two<S>; 0] = &[];
                let lit = Two::<S>::lit;
                let by = rt::Factor;
                let crank_0_angle = by(0.4) * (by(3.0) * t).sin();
                let (sin_crank_0_angle, cos_crank_0_angle) = crank_0_angle.sin_cos();
                let crank_1_angle = by(0.3) * (by(2.0) * t).cos();
                let (sin_crank_1_angle, cos_crank_1_angle) = crank_1_angle.sin_cos();
                let loop_0_x = by(0.2).mul_add(cos_crank_0_angle - cos_crank_1_angle, lit(-1.0));
                let last_cosine_3 = Two::both(m.angles[3].cos);
                let last_0 = Two::both(m.time.last);
                let since_remembered = t - last_0;
                let last_rate_3 = Two::both(m.iterated[0].rate);
                let last_bend_3 = Two::both(m.iterated[0].bend);
                let t1 = since_remembered * last_bend_3.mul_add(since_remembered, last_rate_3);
                let plate_angle_expected_tangent = t1 * (by(0.041666666666666664) * t1).mul_add(t1, lit(0.5));
                let plate_angle_expected_sine = by(2.0) * plate_angle_expected_tangent
                    / plate_angle_expected_tangent.mul_add(plate_angle_expected_tangent, lit(1.0));
                let last_sine_3 = Two::both(m.angles[3].sin);
                let plate_angle_expected_cos = (-plate_angle_expected_sine)
                    .mul_add(last_cosine_3.mul_add(plate_angle_expected_tangent, last_sine_3), last_cosine_3);
                let plate_angle_expected_sin = plate_angle_expected_sine.mul_add(
                    (-last_sine_3).mul_add(plate_angle_expected_tangent, last_cosine_3),
                    last_sine_3,
                );
                let t2 = by(0.8191520442889918)
                    .mul_add(plate_angle_expected_sin, by(0.573576436351046) * plate_angle_expected_cos);
                let t3 = by(0.984807753012208)
                    .mul_add(plate_angle_expected_sin, by(0.17364817766693033) * plate_angle_expected_cos);
                let t4 = by(-0.573576436351046)
                    .mul_add(plate_angle_expected_sin, by(0.8191520442889918) * plate_angle_expected_cos);
                let t5 = by(-0.17364817766693033)
                    .mul_add(plate_angle_expected_sin, by(0.984807753012208) * plate_angle_expected_cos);
                let j0_0_across_1_1 = t4.mul_add(t5, t2 * t3);
                let last_value_4 = Two::both(m.iterated[1].value);
                let last_rate_4 = Two::both(m.iterated[1].rate);
                let last_bend_4 = Two::both(m.iterated[1].bend);
                let slot_0_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_4.mul_add(since_remembered, last_rate_4), last_value_4);
                let last_value_5 = Two::both(m.iterated[2].value);
                let last_rate_5 = Two::both(m.iterated[2].rate);
                let last_bend_5 = Two::both(m.iterated[2].bend);
                let slot_1_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_5.mul_add(since_remembered, last_rate_5), last_value_5);
                let t6 = by(0.8191520442889918) * slot_0_displacement_expected;
                let t7 = by(0.766044443118978).mul_add(slot_1_displacement_expected, t6) - lit(0.8);
                let t8 = by(0.573576436351046) * slot_0_displacement_expected;
                let t9 = by(-0.6427876096865393).mul_add(slot_1_displacement_expected, t8);
                let arm0_0_4_x = (-t7).mul_add(plate_angle_expected_cos, t9 * plate_angle_expected_sin);
                let t10 = by(0.6427876096865393)
                    .mul_add(plate_angle_expected_sin, by(0.766044443118978) * plate_angle_expected_cos);
                let arm0_0_4_y = -t9.mul_add(plate_angle_expected_cos, t7 * plate_angle_expected_sin);
                let t11 = by(-0.766044443118978)
                    .mul_add(plate_angle_expected_sin, by(0.6427876096865393) * plate_angle_expected_cos);
                let j0_0_across_0_0 = (-arm0_0_4_x).mul_add(t10, arm0_0_4_y * t11);
                let j0_0_across_0_1 = t4.mul_add(t11, t2 * t10);
                let last_value_6 = Two::both(m.iterated[3].value);
                let last_rate_6 = Two::both(m.iterated[3].rate);
                let last_bend_6 = Two::both(m.iterated[3].bend);
                let slot_2_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_6.mul_add(since_remembered, last_rate_6), last_value_6);
                let t12 = by(0.17364817766693033).mul_add(slot_2_displacement_expected, t6) - lit(0.4);
                let t13 = by(-0.984807753012208).mul_add(slot_2_displacement_expected, t8) - lit(0.7);
                let arm0_1_4_x = (-t12).mul_add(plate_angle_expected_cos, t13 * plate_angle_expected_sin);
                let arm0_1_4_y = -t13.mul_add(plate_angle_expected_cos, t12 * plate_angle_expected_sin);
                let j0_0_across_1_0 = (-t3).mul_add(arm0_1_4_x, t5 * arm0_1_4_y);
                let j0_0_reciprocal =
                    by(1.0) / (-j0_0_across_0_1).mul_add(j0_0_across_1_0, j0_0_across_1_1 * j0_0_across_0_0);
                let j0_0_inverse_0_0 = j0_0_across_1_1 * j0_0_reciprocal;
                let loop_0_y = by(0.2) * (sin_crank_0_angle - sin_crank_1_angle);
                let gap0_0_y = loop_0_y + arm0_0_4_y;
                let gap0_0_x = loop_0_x + arm0_0_4_x;
                let j0_0_step_0_across_0 = -t11.mul_add(gap0_0_x, t10 * gap0_0_y);
                let j0_0_inverse_0_1 = -(j0_0_across_0_1 * j0_0_reciprocal);
                let crank_2_angle = by(0.2).mul_add((by(4.0) * t).sin(), lit(-0.1));
                let (sin_crank_2_angle, cos_crank_2_angle) = crank_2_angle.sin_cos();
                let loop_1_y = by(0.2).mul_add(sin_crank_0_angle - sin_crank_2_angle, lit(-0.9));
                let gap0_1_y = arm0_1_4_y + loop_1_y;
                let loop_1_x = by(0.2).mul_add(cos_crank_0_angle - cos_crank_2_angle, lit(-0.5));
                let gap0_1_x = arm0_1_4_x + loop_1_x;
                let j0_0_step_0_across_1 = -t5.mul_add(gap0_1_x, t3 * gap0_1_y);
                let j0_0_step_0_0 =
                    j0_0_inverse_0_1.mul_add(j0_0_step_0_across_1, j0_0_inverse_0_0 * j0_0_step_0_across_0);
                let plate_angle_0_tangent = by(-0.5) * j0_0_step_0_0;
                let plate_angle_0_sine = by(2.0) * plate_angle_0_tangent
                    / plate_angle_0_tangent.mul_add(plate_angle_0_tangent, lit(1.0));
                let plate_angle_0_cos = (-plate_angle_0_sine).mul_add(
                    plate_angle_expected_cos.mul_add(plate_angle_0_tangent, plate_angle_expected_sin),
                    plate_angle_expected_cos,
                );
                let plate_angle_0_sin = plate_angle_0_sine.mul_add(
                    (-plate_angle_expected_sin).mul_add(plate_angle_0_tangent, plate_angle_expected_cos),
                    plate_angle_expected_sin,
                );
                let j0_0_inverse_1_0 = -(j0_0_across_1_0 * j0_0_reciprocal);
                let j0_0_inverse_1_1 = j0_0_across_0_0 * j0_0_reciprocal;
                let j0_0_step_0_1 =
                    j0_0_step_0_across_1.mul_add(j0_0_inverse_1_1, j0_0_step_0_across_0 * j0_0_inverse_1_0);
                let slot_0_displacement_0 = slot_0_displacement_expected - j0_0_step_0_1;
                let j0_0_along_0_0 = by(1.0000000000000002) * arm0_0_4_x.mul_add(t11, t10 * arm0_0_4_y);
                let j0_0_along_0_1 = by(1.0000000000000002) * (-t2).mul_add(t11, t4 * t10);
                let j0_0_step_0_2 = (-j0_0_step_0_1).mul_add(
                    j0_0_along_0_1,
                    (-j0_0_step_0_0).mul_add(
                        j0_0_along_0_0,
                        by(-1.0000000000000002) * (-t11).mul_add(gap0_0_y, t10 * gap0_0_x),
                    ),
                );
                let slot_1_displacement_0 = slot_1_displacement_expected - j0_0_step_0_2;
                let t14 = by(0.8191520442889918) * slot_0_displacement_0;
                let t15 = by(0.766044443118978).mul_add(slot_1_displacement_0, t14) - lit(0.8);
                let t16 = by(0.573576436351046) * slot_0_displacement_0;
                let t17 = by(-0.6427876096865393).mul_add(slot_1_displacement_0, t16);
                let gap1_0_y = loop_0_y + -plate_angle_0_cos.mul_add(t17, plate_angle_0_sin * t15);
                let gap1_0_x = loop_0_x + (-plate_angle_0_cos).mul_add(t15, plate_angle_0_sin * t17);
                let j0_0_step_1_across_0 = -t11.mul_add(gap1_0_x, t10 * gap1_0_y);
                let j0_0_along_1_0 = by(1.0000000000000002) * t5.mul_add(arm0_1_4_x, t3 * arm0_1_4_y);
                let j0_0_along_1_1 = by(1.0000000000000002) * (-t2).mul_add(t5, t3 * t4);
                let j0_0_step_0_3 = (-j0_0_step_0_1).mul_add(
                    j0_0_along_1_1,
                    (-j0_0_step_0_0).mul_add(
                        j0_0_along_1_0,
                        by(-1.0000000000000002) * (-t5).mul_add(gap0_1_y, t3 * gap0_1_x),
                    ),
                );
                let slot_2_displacement_0 = slot_2_displacement_expected - j0_0_step_0_3;
                let t18 = by(0.17364817766693033).mul_add(slot_2_displacement_0, t14) - lit(0.4);
                let t19 = by(-0.984807753012208).mul_add(slot_2_displacement_0, t16) - lit(0.7);
                let gap1_1_y = loop_1_y + -plate_angle_0_cos.mul_add(t19, plate_angle_0_sin * t18);
                let gap1_1_x = loop_1_x + (-plate_angle_0_cos).mul_add(t18, plate_angle_0_sin * t19);
                let j0_0_step_1_across_1 = -t5.mul_add(gap1_1_x, t3 * gap1_1_y);
                let j0_0_step_1_0 =
                    j0_0_inverse_0_1.mul_add(j0_0_step_1_across_1, j0_0_inverse_0_0 * j0_0_step_1_across_0);
                let plate_angle_1_tangent = by(-0.5) * j0_0_step_1_0;
                let plate_angle_1_sine = by(2.0) * plate_angle_1_tangent
                    / plate_angle_1_tangent.mul_add(plate_angle_1_tangent, lit(1.0));
                let plate_angle_1_cos = (-plate_angle_1_sine).mul_add(
                    plate_angle_0_cos.mul_add(plate_angle_1_tangent, plate_angle_0_sin),
                    plate_angle_0_cos,
                );
                let plate_angle_1_sin = plate_angle_1_sine.mul_add(
                    (-plate_angle_0_sin).mul_add(plate_angle_1_tangent, plate_angle_0_cos),
                    plate_angle_0_sin,
                );
                let t20 = by(0.8191520442889918)
                    .mul_add(plate_angle_1_sin, by(0.573576436351046) * plate_angle_1_cos);
                let t21 = by(0.984807753012208)
                    .mul_add(plate_angle_1_sin, by(0.17364817766693033) * plate_angle_1_cos);
                let t22 = by(-0.573576436351046)
                    .mul_add(plate_angle_1_sin, by(0.8191520442889918) * plate_angle_1_cos);
                let t23 = by(-0.17364817766693033)
                    .mul_add(plate_angle_1_sin, by(0.984807753012208) * plate_angle_1_cos);
                let j2_0_across_1_1 = t22.mul_add(t23, t20 * t21);
                let j0_0_step_1_1 =
                    j0_0_inverse_1_1.mul_add(j0_0_step_1_across_1, j0_0_inverse_1_0 * j0_0_step_1_across_0);
                let slot_0_displacement_1 = slot_0_displacement_0 - j0_0_step_1_1;
                let j0_0_step_1_2 = (-j0_0_along_0_1).mul_add(
                    j0_0_step_1_1,
                    (-j0_0_along_0_0).mul_add(
                        j0_0_step_1_0,
                        by(-1.0000000000000002) * (-t11).mul_add(gap1_0_y, t10 * gap1_0_x),
                    ),
                );
                let slot_1_displacement_1 = slot_1_displacement_0 - j0_0_step_1_2;
                let t24 = by(0.8191520442889918) * slot_0_displacement_1;
                let t25 = by(0.766044443118978).mul_add(slot_1_displacement_1, t24) - lit(0.8);
                let t26 = by(0.573576436351046) * slot_0_displacement_1;
                let t27 = by(-0.6427876096865393).mul_add(slot_1_displacement_1, t26);
                let arm2_0_4_x = (-plate_angle_1_cos).mul_add(t25, plate_angle_1_sin * t27);
                let t28 = by(0.6427876096865393)
                    .mul_add(plate_angle_1_sin, by(0.766044443118978) * plate_angle_1_cos);
                let arm2_0_4_y = -plate_angle_1_cos.mul_add(t27, plate_angle_1_sin * t25);
                let t29 = by(-0.766044443118978)
                    .mul_add(plate_angle_1_sin, by(0.6427876096865393) * plate_angle_1_cos);
                let j2_0_across_0_0 = (-arm2_0_4_x).mul_add(t28, arm2_0_4_y * t29);
                let j2_0_across_0_1 = t22.mul_add(t29, t20 * t28);
                let j0_0_step_1_3 = (-j0_0_along_1_1).mul_add(
                    j0_0_step_1_1,
                    (-j0_0_along_1_0).mul_add(
                        j0_0_step_1_0,
                        by(-1.0000000000000002) * (-t5).mul_add(gap1_1_y, t3 * gap1_1_x),
                    ),
                );
                let slot_2_displacement_1 = slot_2_displacement_0 - j0_0_step_1_3;
                let t30 = by(0.17364817766693033).mul_add(slot_2_displacement_1, t24) - lit(0.4);
                let t31 = by(-0.984807753012208).mul_add(slot_2_displacement_1, t26) - lit(0.7);
                let arm2_1_4_x = (-plate_angle_1_cos).mul_add(t30, plate_angle_1_sin * t31);
                let arm2_1_4_y = -plate_angle_1_cos.mul_add(t31, plate_angle_1_sin * t30);
                let j2_0_across_1_0 = (-t21).mul_add(arm2_1_4_x, t23 * arm2_1_4_y);
                let j2_0_reciprocal =
                    by(1.0) / (-j2_0_across_0_1).mul_add(j2_0_across_1_0, j2_0_across_1_1 * j2_0_across_0_0);
                let gap2_0_y = loop_0_y + arm2_0_4_y;
                let gap2_0_x = loop_0_x + arm2_0_4_x;
                let j2_0_step_2_across_0 = -t29.mul_add(gap2_0_x, t28 * gap2_0_y);
                let gap2_1_y = loop_1_y + arm2_1_4_y;
                let gap2_1_x = loop_1_x + arm2_1_4_x;
                let j2_0_step_2_across_1 = -t23.mul_add(gap2_1_x, t21 * gap2_1_y);
                let j2_0_step_2_0 = (-(j2_0_across_0_1 * j2_0_reciprocal))
                    .mul_add(j2_0_step_2_across_1, j2_0_across_1_1 * j2_0_reciprocal * j2_0_step_2_across_0);
                let plate_angle_2_tangent = by(-0.5) * j2_0_step_2_0;
                let plate_angle_2_sine = by(2.0) * plate_angle_2_tangent
                    / plate_angle_2_tangent.mul_add(plate_angle_2_tangent, lit(1.0));
                let plate_angle_2_cos = (-plate_angle_2_sine).mul_add(
                    plate_angle_1_cos.mul_add(plate_angle_2_tangent, plate_angle_1_sin),
                    plate_angle_1_cos,
                );
                let j2_0_step_2_1 = j2_0_step_2_across_1.mul_add(
                    j2_0_across_0_0 * j2_0_reciprocal,
                    j2_0_step_2_across_0 * -(j2_0_across_1_0 * j2_0_reciprocal),
                );
                let slot_0_displacement_2 = slot_0_displacement_1 - j2_0_step_2_1;
                let t32 = (-j2_0_step_2_0).mul_add(
                    by(1.0000000000000002) * arm2_0_4_x.mul_add(t29, t28 * arm2_0_4_y),
                    by(-1.0000000000000002) * (-t29).mul_add(gap2_0_y, t28 * gap2_0_x),
                );
                let slot_1_displacement_2 = slot_1_displacement_1
                    - (-j2_0_step_2_1).mul_add(by(1.0000000000000002) * (-t20).mul_add(t29, t22 * t28), t32);
                let t33 = by(0.8191520442889918) * slot_0_displacement_2;
                let t34 = by(0.766044443118978).mul_add(slot_1_displacement_2, t33) - lit(0.8);
                let plate_angle_2_sin = plate_angle_2_sine.mul_add(
                    (-plate_angle_1_sin).mul_add(plate_angle_2_tangent, plate_angle_1_cos),
                    plate_angle_1_sin,
                );
                let t35 = by(0.573576436351046) * slot_0_displacement_2;
                let t36 = by(-0.6427876096865393).mul_add(slot_1_displacement_2, t35);
                let arm_0_4_x = (-plate_angle_2_cos).mul_add(t34, plate_angle_2_sin * t36);
                let gap_0_x = loop_0_x + arm_0_4_x;
                let arm_0_4_y = -plate_angle_2_cos.mul_add(t36, t34 * plate_angle_2_sin);
                let gap_0_y = loop_0_y + arm_0_4_y;
                let t37 = (-j2_0_step_2_0).mul_add(
                    by(1.0000000000000002) * t23.mul_add(arm2_1_4_x, t21 * arm2_1_4_y),
                    by(-1.0000000000000002) * (-t23).mul_add(gap2_1_y, t21 * gap2_1_x),
                );
                let slot_2_displacement_2 = slot_2_displacement_1
                    - (-j2_0_step_2_1).mul_add(by(1.0000000000000002) * (-t20).mul_add(t23, t21 * t22), t37);
                let t38 = by(0.17364817766693033).mul_add(slot_2_displacement_2, t33) - lit(0.4);
                let t39 = by(-0.984807753012208).mul_add(slot_2_displacement_2, t35) - lit(0.7);
                let arm_1_4_x = (-plate_angle_2_cos).mul_add(t38, plate_angle_2_sin * t39);
                let gap_1_x = loop_1_x + arm_1_4_x;
                let arm_1_4_y = -plate_angle_2_cos.mul_add(t39, plate_angle_2_sin * t38);
                let gap_1_y = loop_1_y + arm_1_4_y;
                let precision = lit(S::PRECISION);
                let t40 = gap_1_y
                    .mul_add(gap_1_y, gap_1_x.mul_add(gap_1_x, gap_0_y.mul_add(gap_0_y, gap_0_x * gap_0_x)))
                    .lt(by(2684354.5600000005) * precision * precision);
                let t41 = by(0.8191520442889918)
                    .mul_add(plate_angle_2_sin, by(0.573576436351046) * plate_angle_2_cos);
                let t42 = by(0.984807753012208)
                    .mul_add(plate_angle_2_sin, by(0.17364817766693033) * plate_angle_2_cos);
                let t43 = by(-0.573576436351046)
                    .mul_add(plate_angle_2_sin, by(0.8191520442889918) * plate_angle_2_cos);
                let t44 = by(-0.17364817766693033)
                    .mul_add(plate_angle_2_sin, by(0.984807753012208) * plate_angle_2_cos);
                let j_0_across_1_1 = t43.mul_add(t44, t41 * t42);
                let t45 = by(0.6427876096865393)
                    .mul_add(plate_angle_2_sin, by(0.766044443118978) * plate_angle_2_cos);
                let t46 = by(-0.766044443118978)
                    .mul_add(plate_angle_2_sin, by(0.6427876096865393) * plate_angle_2_cos);
                let j_0_across_0_1 = t43.mul_add(t46, t41 * t45);
                let j_0_across_1_0 = (-arm_1_4_x).mul_add(t42, arm_1_4_y * t44);
                let j_0_across_0_0 = (-arm_0_4_x).mul_add(t45, arm_0_4_y * t46);
                let t47 = by(1.9999999999999996).mul_add(
                    j_0_across_0_0.mul_add(j_0_across_0_0, j_0_across_1_0 * j_0_across_1_0),
                    by(0.32) * j_0_across_0_1.mul_add(j_0_across_0_1, j_0_across_1_1 * j_0_across_1_1),
                );
                let j_0_determinant =
                    (-j_0_across_0_1).mul_add(j_0_across_1_0, j_0_across_1_1 * j_0_across_0_0);
                let t48 = Two::<S>::select(
                    t40,
                    Two::<S>::select(
                        lit(0.0).lt(t47),
                        by(2.0) * j_0_determinant * j_0_determinant / t47,
                        lit(0.0),
                    ),
                    lit(-1.0),
                );
                [t48]
            }

            /// The rate in one of two stages, at its pose.
            #[inline]
            fn rate_at_pose<const SECOND: bool>(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 0, 4, 1, 4>,
                x: &[S; 0],
                shared: &[Two<S>; 1],
                dx: &mut [S; 0],
            ) -> rt::Health<S> {
                rt::Health({ shared[0].of::<SECOND>() })
            }
        }

        impl<S: Real> rt::Constraints for PlateOnThreePins<S> {
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

        impl<S: Real> rt::Switched for PlateOnThreePins<S> {
            type Guards = [S; 0];
            type Contact = rt::switched::NoContact;
            const SWITCHES: rt::Switches = rt::Switches::NONE;
        }

        impl<S: Real> rt::Labels for PlateOnThreePins<S> {
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
        impl<S: Real> rt::singular::ExtendedPrecision<12, 12, 24> for PlateOnThreePins<S> {
            type Extended = PlateOnThreePins<rt::DoubleDouble<S>>;
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
                x: &[rt::DoubleDouble<S>; 24],
                dx: &mut [rt::DoubleDouble<S>; 24],
            ) {
                let mut lambda = [rt::DoubleDouble::<S>::lit(0.0); 12];
                extended.dynamics(t, u, x, dx, &mut lambda);
            }
        }

        impl<S: Real> State<S> {
            /// Pose and velocity of every body.
            #[inline]
            fn pose_(&self) -> ([S; 12], [S; 12]) {
                rt::charts::pose(&self.mechanism, self.time, &self.held, &self.x)
            }

            /// Poses and velocities with all revolutions of the angles.
            fn unwrapped_pose_(&self) -> ([S; 12], [S; 12]) {
                let (mut q, v) = self.pose_();
                rt::turns::add(&self.held.turns, &mut q, &[&[11]]);
                (q, v)
            }
        }

        impl<S: Real> State<S> {
            /// The state in absolute coordinates.
            fn absolute_(&self) -> [S; 24] {
                self.joined_(&self.pose_())
            }

            /// The state in absolute coordinates, of pose and velocity.
            fn joined_(&self, (q, v): &([S; 12], [S; 12])) -> [S; 24] {
                let mut x = [S::lit(0.0); 24];
                absolute::join(q, v, &mut x);
                x
            }
        }

        impl<S: Real> rt::Moment for State<S> {
            type M = PlateOnThreePins<S>;

            fn new(mechanism: PlateOnThreePins<S>, held: Held<S>, time: S, x: [S; 0]) -> Self {
                State { mechanism, held, time, x }
            }

            fn mechanism(&self) -> &PlateOnThreePins<S> {
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

            fn in_place(&mut self) -> rt::InPlace<'_, PlateOnThreePins<S>> {
                let Self { mechanism, held, time, x } = self;
                rt::InPlace { system: mechanism, held, time, x }
            }
        }

        impl<S: Real> rt::Mechanism for PlateOnThreePins<S> {
            type State = State<S>;
            type Rescue = rt::singular::NearSingular<Self, 12, 12, 24>;
            const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();
            fn start_state(&self, t: S) -> Result<(Held<S>, [S; 0]), Fault> {
                self.start_holding_(t, self.declared_input())
            }

            fn opening(&self, t: S, held: &Held<S>, x: &[S; 0]) -> rt::Drift<S> {
                let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
            }
        }

        impl<S: Real> PlateOnThreePins<S> {
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

        impl<S: Scalar> PlateOnThreePins<S> {
            const LAYOUT_: absolute::Layout = absolute::Layout {
                rows: const {
                    &[
                        "o[0].x",
                        "o[0].y",
                        "o[1].x",
                        "o[1].y",
                        "o[2].x",
                        "o[2].y",
                        "slot[0].normal",
                        "slot[1].normal",
                        "slot[2].normal",
                        "first",
                        "second",
                        "third",
                    ]
                },
                parts: const {
                    &[
                        "o[0]", "o[0]", "o[1]", "o[1]", "o[2]", "o[2]", "slot[0]", "slot[1]", "slot[2]",
                        "first", "second", "third",
                    ]
                },
                coordinates: const {
                    &[
                        "crank[0].x",
                        "crank[0].y",
                        "crank[0].angle",
                        "crank[1].x",
                        "crank[1].y",
                        "crank[1].angle",
                        "crank[2].x",
                        "crank[2].y",
                        "crank[2].angle",
                        "plate.x",
                        "plate.y",
                        "plate.angle",
                    ]
                },
                angular: &[false, false, false, false, false, false, false, false, false, true, true, true],
                given_angles: &[true, true, true, false],
            };
            /// The derivatives of phi by q: the entries that are not zero, row by row.
            ///
            /// 40 add, 37 mul, 6 neg, 4 sin_cos.
            #[cold]
            fn phi_q_entries(&self, t: S, q: &[S; 12], phi_q: &mut [S; 33]) {
                let lit = S::lit;
                let by = rt::Factor;
                phi_q[0] = lit(1.0);
                let crank_0_angle = q[2];
                let crank_1_angle = q[5];
                let crank_2_angle = q[8];
                let plate_angle = q[11];
                let (
                    [sin_crank_0_angle, sin_crank_1_angle, sin_crank_2_angle, sin_plate_angle],
                    [cos_crank_0_angle, cos_crank_1_angle, cos_crank_2_angle, cos_plate_angle],
                ) = S::sin_cos_all([crank_0_angle, crank_1_angle, crank_2_angle, plate_angle]);
                let t1 = by(0.1) * sin_crank_0_angle;
                phi_q[1] = t1;
                phi_q[2] = lit(1.0);
                let t2 = by(-0.1) * cos_crank_0_angle;
                phi_q[3] = t2;
                phi_q[4] = lit(1.0);
                let t3 = by(0.1) * sin_crank_1_angle;
                phi_q[5] = t3;
                phi_q[6] = lit(1.0);
                let t4 = by(-0.1) * cos_crank_1_angle;
                phi_q[7] = t4;
                phi_q[8] = lit(1.0);
                let t5 = by(0.1) * sin_crank_2_angle;
                phi_q[9] = t5;
                phi_q[10] = lit(1.0);
                let t6 = by(-0.1) * cos_crank_2_angle;
                phi_q[11] = t6;
                let t7 =
                    by(0.8191520442889918).mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle);
                phi_q[12] = t7;
                let t8 =
                    by(-0.573576436351046).mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle);
                phi_q[13] = -t8;
                phi_q[14] = by(-0.1) * cos_crank_0_angle.mul_add(t8, sin_crank_0_angle * t7);
                phi_q[15] = -t7;
                phi_q[16] = t8;
                let t9 = by(0.4) * cos_plate_angle;
                let t10 = by(0.3) * sin_plate_angle;
                let t11 = t9 - t10;
                let crank_0_x = q[0];
                let plate_x = q[9];
                let t12 = by(0.3) * cos_plate_angle;
                let t13 = by(0.4) * sin_plate_angle;
                let t14 = t12 + t13;
                let crank_0_y = q[1];
                let plate_y = q[10];
                let t15 = t7.mul_add(
                    crank_0_y + t1 - plate_y + t14 - t14,
                    t8 * (crank_0_x - t2 - plate_x + t11 - t11),
                );
                phi_q[17] = t15;
                let t16 =
                    by(-0.766044443118978).mul_add(sin_plate_angle, by(0.6427876096865393) * cos_plate_angle);
                phi_q[18] = t16;
                let t17 =
                    by(0.6427876096865393).mul_add(sin_plate_angle, by(0.766044443118978) * cos_plate_angle);
                phi_q[19] = t17;
                phi_q[20] = by(-0.1) * (-cos_crank_1_angle).mul_add(t17, sin_crank_1_angle * t16);
                phi_q[21] = -t16;
                phi_q[22] = -t17;
                let t18 = t9 + t10;
                let crank_1_x = q[3];
                let t19 = t12 - t13;
                let crank_1_y = q[4];
                let t20 = (-t17).mul_add(
                    t18 + (crank_1_x - t4 - plate_x - t18),
                    t16 * (crank_1_y + t3 - plate_y + t19 - t19),
                );
                phi_q[23] = t20;
                let t21 = by(-0.17364817766693033)
                    .mul_add(sin_plate_angle, by(0.984807753012208) * cos_plate_angle);
                phi_q[24] = t21;
                let t22 =
                    by(0.984807753012208).mul_add(sin_plate_angle, by(0.17364817766693033) * cos_plate_angle);
                phi_q[25] = t22;
                phi_q[26] = by(-0.1) * (-cos_crank_2_angle).mul_add(t22, sin_crank_2_angle * t21);
                phi_q[27] = -t21;
                phi_q[28] = -t22;
                let crank_2_x = q[6];
                let crank_2_y = q[7];
                let t23 = (-t22).mul_add(
                    crank_2_x - t6 - plate_x + t13 - t13,
                    t21 * (t9 + (crank_2_y + t5 - plate_y - t9)),
                );
                phi_q[29] = t23;
                phi_q[30] = lit(1.0);
                phi_q[31] = lit(1.0);
                phi_q[32] = lit(1.0);
            }
        }

        #[doc(hidden)]
        impl<S: Real> absolute::Absolute<S, NQ, NC> for PlateOnThreePins<S> {
            fn layout(&self) -> &'static absolute::Layout {
                const { &Self::LAYOUT_ }
            }

            /// Residuals of the constraints, m or rad; the rows stand in the table of this module.
            ///
            /// 42 add, 34 mul, 7 sin_cos.
            fn phi(&self, t: S, q: &[S; 12]) -> [S; 12] {
                let mut phi = [S::lit(0.0); 12];
                let [
                    crank_0_x,
                    crank_0_y,
                    crank_0_angle,
                    crank_1_x,
                    crank_1_y,
                    crank_1_angle,
                    crank_2_x,
                    crank_2_y,
                    crank_2_angle,
                    plate_x,
                    plate_y,
                    plate_angle,
                    ..,
                ] = *q;
                let lit = S::lit;
                let by = rt::Factor;
                let (
                    [sin_crank_0_angle, sin_crank_1_angle, sin_crank_2_angle, sin_plate_angle],
                    [cos_crank_0_angle, cos_crank_1_angle, cos_crank_2_angle, cos_plate_angle],
                ) = S::sin_cos_all([crank_0_angle, crank_1_angle, crank_2_angle, plate_angle]);
                let t1 = by(0.1) * cos_crank_0_angle;
                phi[0] = crank_0_x - t1;
                let t2 = by(0.1) * sin_crank_0_angle;
                phi[1] = crank_0_y - t2;
                let t3 = by(0.1) * cos_crank_1_angle;
                phi[2] = crank_1_x - t3 - lit(1.0);
                let t4 = by(0.1) * sin_crank_1_angle;
                phi[3] = crank_1_y - t4;
                let t5 = by(0.1) * cos_crank_2_angle;
                phi[4] = crank_2_x - t5 - lit(0.5);
                let t6 = by(0.1) * sin_crank_2_angle;
                phi[5] = crank_2_y - t6 - lit(0.9);
                let t7 = by(0.3).mul_add(sin_plate_angle, plate_x);
                let t8 = by(0.4) * cos_plate_angle;
                let t9 = by(-0.3).mul_add(cos_plate_angle, plate_y);
                let t10 = by(0.4) * sin_plate_angle;
                let t11 = (-by(-0.573576436351046)
                    .mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle))
                .mul_add(
                    crank_0_y + t2 + t10 - t9,
                    by(0.8191520442889918).mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle)
                        * (crank_0_x + t1 + t8 - t7),
                );
                phi[6] = t11;
                let t12 = by(0.6427876096865393)
                    .mul_add(sin_plate_angle, by(0.766044443118978) * cos_plate_angle)
                    .mul_add(
                        crank_1_y + t4 - t10 - t9,
                        by(-0.766044443118978)
                            .mul_add(sin_plate_angle, by(0.6427876096865393) * cos_plate_angle)
                            * (crank_1_x + t3 - t8 - t7),
                    );
                phi[7] = t12;
                let t13 = by(0.984807753012208)
                    .mul_add(sin_plate_angle, by(0.17364817766693033) * cos_plate_angle)
                    .mul_add(
                        crank_2_y + t6 - plate_y - t8,
                        by(-0.17364817766693033)
                            .mul_add(sin_plate_angle, by(0.984807753012208) * cos_plate_angle)
                            * (crank_2_x + t5 - plate_x + t10),
                    );
                phi[8] = t13;
                phi[9] = by(-0.4).mul_add((by(3.0) * t).sin(), crank_0_angle);
                phi[10] = by(-0.3).mul_add((by(2.0) * t).cos(), crank_1_angle);
                phi[11] = by(-0.2).mul_add((by(4.0) * t).sin(), crank_2_angle) + lit(0.1);
                phi
            }

            /// Their rates, `phi_q v - nu`, m/s or rad/s.
            ///
            /// 70 add, 70 mul, 7 sin_cos.
            fn phi_dot(&self, t: S, q: &[S; 12], v: &[S; 12]) -> [S; 12] {
                let mut phi_dot = [S::lit(0.0); 12];
                let by = rt::Factor;
                let crank_0_vx = v[0];
                let crank_0_omega = v[2];
                let crank_0_angle = q[2];
                let crank_1_angle = q[5];
                let crank_2_angle = q[8];
                let plate_angle = q[11];
                let (
                    [sin_crank_0_angle, sin_crank_1_angle, sin_crank_2_angle, sin_plate_angle],
                    [cos_crank_0_angle, cos_crank_1_angle, cos_crank_2_angle, cos_plate_angle],
                ) = S::sin_cos_all([crank_0_angle, crank_1_angle, crank_2_angle, plate_angle]);
                let t1 = by(0.1) * (crank_0_omega * sin_crank_0_angle);
                phi_dot[0] = crank_0_vx + t1;
                let crank_0_vy = v[1];
                let t2 = by(0.1) * (crank_0_omega * cos_crank_0_angle);
                phi_dot[1] = crank_0_vy - t2;
                let crank_1_vx = v[3];
                let crank_1_omega = v[5];
                let t3 = by(0.1) * (crank_1_omega * sin_crank_1_angle);
                phi_dot[2] = crank_1_vx + t3;
                let crank_1_vy = v[4];
                let t4 = by(0.1) * (crank_1_omega * cos_crank_1_angle);
                phi_dot[3] = crank_1_vy - t4;
                let crank_2_vx = v[6];
                let crank_2_omega = v[8];
                let t5 = by(0.1) * (crank_2_omega * sin_crank_2_angle);
                phi_dot[4] = crank_2_vx + t5;
                let crank_2_vy = v[7];
                let t6 = by(0.1) * (crank_2_omega * cos_crank_2_angle);
                phi_dot[5] = crank_2_vy - t6;
                let plate_omega = v[11];
                let t7 = plate_omega * sin_plate_angle;
                let t8 = plate_omega * cos_plate_angle;
                let crank_0_x = q[0];
                let plate_x = q[9];
                let t9 = by(0.3).mul_add(sin_plate_angle, plate_x);
                let t10 = by(0.4) * cos_plate_angle;
                let t11 = by(-0.8191520442889918).mul_add(t8, by(0.573576436351046) * t7)
                    * (by(0.1).mul_add(cos_crank_0_angle, crank_0_x) + t10 - t9);
                let plate_vx = v[9];
                let t12 = by(0.3).mul_add(t8, plate_vx);
                let t13 = by(0.4) * t7;
                let crank_0_y = q[1];
                let plate_y = q[10];
                let t14 = by(-0.3).mul_add(cos_plate_angle, plate_y);
                let t15 = by(0.4) * sin_plate_angle;
                let t16 = by(0.573576436351046).mul_add(t8, by(0.8191520442889918) * t7)
                    * (by(0.1).mul_add(sin_crank_0_angle, crank_0_y) + t15 - t14);
                let plate_vy = v[10];
                let t17 = by(0.3).mul_add(t7, plate_vy);
                let t18 = by(0.4) * t8;
                let t19 = by(0.8191520442889918)
                    .mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle)
                    .mul_add(crank_0_vx - t1 - t13 - t12, -t11);
                let t20 = (-by(-0.573576436351046)
                    .mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle))
                .mul_add(crank_0_vy + t2 + t18 - t17, t19 + t16);
                phi_dot[6] = t20;
                let crank_1_x = q[3];
                let t21 = by(0.766044443118978).mul_add(t8, by(0.6427876096865393) * t7)
                    * (by(0.1).mul_add(cos_crank_1_angle, crank_1_x) - t10 - t9);
                let crank_1_y = q[4];
                let t22 = by(-0.6427876096865393).mul_add(t8, by(0.766044443118978) * t7)
                    * (by(0.1).mul_add(sin_crank_1_angle, crank_1_y) - t15 - t14);
                let t23 = by(-0.766044443118978)
                    .mul_add(sin_plate_angle, by(0.6427876096865393) * cos_plate_angle)
                    .mul_add(crank_1_vx + t13 - t3 - t12, -t21);
                let t24 = by(0.6427876096865393)
                    .mul_add(sin_plate_angle, by(0.766044443118978) * cos_plate_angle)
                    .mul_add(crank_1_vy - t18 + t4 - t17, t23 - t22);
                phi_dot[7] = t24;
                let crank_2_x = q[6];
                let t25 = (by(0.1).mul_add(cos_crank_2_angle, crank_2_x) - plate_x + t15)
                    * by(0.17364817766693033).mul_add(t8, by(0.984807753012208) * t7);
                let crank_2_y = q[7];
                let t26 = (by(0.1).mul_add(sin_crank_2_angle, crank_2_y) - plate_y - t10)
                    * by(-0.984807753012208).mul_add(t8, by(0.17364817766693033) * t7);
                let t27 = by(-0.17364817766693033)
                    .mul_add(sin_plate_angle, by(0.984807753012208) * cos_plate_angle)
                    .mul_add(crank_2_vx - plate_vx + t18 - t5, -t25);
                let t28 = by(0.984807753012208)
                    .mul_add(sin_plate_angle, by(0.17364817766693033) * cos_plate_angle)
                    .mul_add(crank_2_vy - plate_vy + t13 + t6, t27 - t26);
                phi_dot[8] = t28;
                phi_dot[9] = by(-1.2).mul_add((by(3.0) * t).cos(), crank_0_omega);
                phi_dot[10] = by(0.6).mul_add((by(2.0) * t).sin(), crank_1_omega);
                phi_dot[11] = by(-0.8).mul_add((by(4.0) * t).cos(), crank_2_omega);
                phi_dot
            }

            fn phi_q(&self, t: S, q: &[S; 12], each: &mut impl FnMut(usize, usize, S)) {
                let places: &[[u32; 2]] = const {
                    &rt::compact::pairs::<33>(&rt::compact::numbers::<66>(&[(
                        1,
                        &[
                            0, 0, 0, 2, 1, 1, 1, 2, 2, 3, 2, 5, 3, 4, 3, 5, 4, 6, 4, 8, 5, 7, 5, 8, 6, 0, 6,
                            1, 6, 2, 6, 9, 6, 10, 6, 11, 7, 3, 7, 4, 7, 5, 7, 9, 7, 10, 7, 11, 8, 6, 8, 7, 8,
                            8, 8, 9, 8, 10, 8, 11, 9, 2, 10, 5, 11, 8,
                        ],
                        &[],
                    )]))
                };
                let mut entries = [S::lit(0.0); 33];
                self.phi_q_entries(t, q, &mut entries);
                for (&[row, column], entry) in places.iter().zip(entries) {
                    each(row as usize, column as usize, entry);
                }
            }

            /// The shortest step in the norm of `W^-1` that closes `r`: `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 170 add, 260 mul, 13 div, 9 neg, 4 sin_cos, 44 select.
            fn min_norm(
                &self,
                t: S,
                q: &[S; 12],
                w: &[S; 12],
                r: &[S; 12],
                dq: &mut [S; 12],
            ) -> rt::Health<S> {
                rt::Health({
                    let lit = S::lit;
                    let by = rt::Factor;
                    // phi_q W phi_q^T = L D L^T
                    let w_0 = w[0];
                    let crank_0_angle = q[2];
                    let plate_angle = q[11];
                    let crank_1_angle = q[5];
                    let crank_2_angle = q[8];
                    let (
                        [sin_crank_0_angle, sin_plate_angle, sin_crank_1_angle, sin_crank_2_angle],
                        [cos_crank_0_angle, cos_plate_angle, cos_crank_1_angle, cos_crank_2_angle],
                    ) = S::sin_cos_all([crank_0_angle, plate_angle, crank_1_angle, crank_2_angle]);
                    let w_2 = w[2];
                    let t1 = by(0.1) * sin_crank_0_angle;
                    let y_0_2 = t1 * w_2;
                    let r_0 = by(1.0) / t1.mul_add(y_0_2, w_0);
                    let y_1_2 = by(-0.1) * (cos_crank_0_angle * w_2);
                    let g_1_0 = t1 * y_1_2;
                    let l_1_0 = r_0 * g_1_0;
                    let t2 = by(0.8191520442889918)
                        .mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle);
                    let y_6_0 = t2 * w_0;
                    let t3 = by(-0.573576436351046)
                        .mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle);
                    let t4 = cos_crank_0_angle.mul_add(t3, sin_crank_0_angle * t2);
                    let y_6_2 = by(-0.1) * (t4 * w_2);
                    let g_6_0 = t1.mul_add(y_6_2, y_6_0);
                    let l_6_0 = r_0 * g_6_0;
                    let l_9_0 = y_0_2 * r_0;
                    let w_1 = w[1];
                    let t5 = by(0.1) * cos_crank_0_angle;
                    let t6 = (-t5).mul_add(y_1_2, w_1);
                    let r_1 = by(1.0) / (-g_1_0).mul_add(l_1_0, t6);
                    let growth_1 = (t6 * r_1).abs();
                    let most_growth = lit(S::MOST_GROWTH);
                    let t7 = most_growth.lt(growth_1);
                    let kept_1 = S::select(t7, lit(0.0), r_1);
                    let y_6_1 = -(t3 * w_1);
                    let g_6_1 = (-g_1_0).mul_add(l_6_0, (-t5).mul_add(y_6_2, y_6_1));
                    let l_6_1 = g_6_1 * kept_1;
                    let g_9_1 = (-g_1_0).mul_add(l_9_0, y_1_2);
                    let l_9_1 = g_9_1 * kept_1;
                    let r_9 = by(1.0) / (-g_9_1).mul_add(l_9_1, (-y_0_2).mul_add(l_9_0, w_2));
                    let growth_9 = (w_2 * r_9).abs();
                    let t8 = most_growth.lt(growth_9);
                    let kept_9 = S::select(t8, lit(0.0), r_9);
                    let g_6_9 = (-g_6_1).mul_add(l_9_1, (-g_6_0).mul_add(l_9_0, y_6_2));
                    let l_6_9 = kept_9 * g_6_9;
                    let w_9 = w[9];
                    let y_6_9 = -(t2 * w_9);
                    let w_10 = w[10];
                    let y_6_10 = t3 * w_10;
                    let t9 = by(0.4) * cos_plate_angle;
                    let t10 = by(0.3) * sin_plate_angle;
                    let t11 = t9 - t10;
                    let crank_0_x = q[0];
                    let plate_x = q[9];
                    let t12 = by(0.3) * cos_plate_angle;
                    let t13 = by(0.4) * sin_plate_angle;
                    let t14 = t12 + t13;
                    let crank_0_y = q[1];
                    let plate_y = q[10];
                    let t15 = t2.mul_add(
                        crank_0_y + t1 - plate_y + t14 - t14,
                        t3 * (crank_0_x + t5 - plate_x + t11 - t11),
                    );
                    let w_11 = w[11];
                    let y_6_11 = w_11 * t15;
                    let t16 = (-t2)
                        .mul_add(y_6_9, (-(by(0.1) * t4)).mul_add(y_6_2, (-t3).mul_add(y_6_1, t2 * y_6_0)));
                    let t17 = t15.mul_add(y_6_11, t3.mul_add(y_6_10, t16));
                    let r_6 = by(1.0)
                        / (-g_6_9).mul_add(l_6_9, (-g_6_1).mul_add(l_6_1, (-g_6_0).mul_add(l_6_0, t17)));
                    let growth_6 = (t17 * r_6).abs();
                    let t18 = most_growth.lt(growth_6);
                    let kept_6 = S::select(t18, lit(0.0), r_6);
                    let t19 = by(-0.766044443118978)
                        .mul_add(sin_plate_angle, by(0.6427876096865393) * cos_plate_angle);
                    let y_7_9 = -(t19 * w_9);
                    let t20 = by(0.6427876096865393)
                        .mul_add(sin_plate_angle, by(0.766044443118978) * cos_plate_angle);
                    let y_7_10 = -(t20 * w_10);
                    let t21 = t9 + t10;
                    let crank_1_x = q[3];
                    let t22 = by(0.1) * cos_crank_1_angle;
                    let t23 = t12 - t13;
                    let crank_1_y = q[4];
                    let t24 = by(0.1) * sin_crank_1_angle;
                    let t25 = (-t19).mul_add(
                        crank_1_y + t24 - plate_y + t23 - t23,
                        t20 * (t21 + (crank_1_x + t22 - plate_x - t21)),
                    );
                    let y_7_11 = -(w_11 * t25);
                    let g_7_6 = t15.mul_add(y_7_11, (-t2).mul_add(y_7_9, t3 * y_7_10));
                    let l_7_6 = kept_6 * g_7_6;
                    let t26 = by(-0.17364817766693033)
                        .mul_add(sin_plate_angle, by(0.984807753012208) * cos_plate_angle);
                    let y_8_9 = -(t26 * w_9);
                    let t27 = by(0.984807753012208)
                        .mul_add(sin_plate_angle, by(0.17364817766693033) * cos_plate_angle);
                    let y_8_10 = -(t27 * w_10);
                    let crank_2_x = q[6];
                    let t28 = by(0.1) * cos_crank_2_angle;
                    let crank_2_y = q[7];
                    let t29 = by(0.1) * sin_crank_2_angle;
                    let t30 = (-t26).mul_add(
                        t9 + (crank_2_y + t29 - plate_y - t9),
                        t27 * (crank_2_x + t28 - plate_x + t13 - t13),
                    );
                    let y_8_11 = -(w_11 * t30);
                    let g_8_6 = t15.mul_add(y_8_11, (-t2).mul_add(y_8_9, t3 * y_8_10));
                    let l_8_6 = kept_6 * g_8_6;
                    let w_3 = w[3];
                    let w_5 = w[5];
                    let y_2_5 = t24 * w_5;
                    let r_2 = by(1.0) / t24.mul_add(y_2_5, w_3);
                    let y_3_5 = by(-0.1) * (cos_crank_1_angle * w_5);
                    let g_3_2 = t24 * y_3_5;
                    let l_3_2 = r_2 * g_3_2;
                    let y_7_3 = t19 * w_3;
                    let t31 = (-cos_crank_1_angle).mul_add(t20, sin_crank_1_angle * t19);
                    let y_7_5 = by(-0.1) * (t31 * w_5);
                    let g_7_2 = t24.mul_add(y_7_5, y_7_3);
                    let l_7_2 = r_2 * g_7_2;
                    let l_10_2 = y_2_5 * r_2;
                    let w_4 = w[4];
                    let t32 = (-t22).mul_add(y_3_5, w_4);
                    let r_3 = by(1.0) / (-g_3_2).mul_add(l_3_2, t32);
                    let growth_3 = (t32 * r_3).abs();
                    let t33 = most_growth.lt(growth_3);
                    let kept_3 = S::select(t33, lit(0.0), r_3);
                    let y_7_4 = t20 * w_4;
                    let g_7_3 = (-g_3_2).mul_add(l_7_2, (-t22).mul_add(y_7_5, y_7_4));
                    let l_7_3 = g_7_3 * kept_3;
                    let g_10_3 = (-g_3_2).mul_add(l_10_2, y_3_5);
                    let l_10_3 = g_10_3 * kept_3;
                    let r_10 = by(1.0) / (-g_10_3).mul_add(l_10_3, (-y_2_5).mul_add(l_10_2, w_5));
                    let growth_10 = (w_5 * r_10).abs();
                    let t34 = most_growth.lt(growth_10);
                    let kept_10 = S::select(t34, lit(0.0), r_10);
                    let g_7_10 = (-g_7_3).mul_add(l_10_3, (-g_7_2).mul_add(l_10_2, y_7_5));
                    let l_7_10 = kept_10 * g_7_10;
                    let t35 = (-t19)
                        .mul_add(y_7_9, (-(by(0.1) * t31)).mul_add(y_7_5, t20.mul_add(y_7_4, t19 * y_7_3)));
                    let t36 = (-t25).mul_add(y_7_11, (-t20).mul_add(y_7_10, t35));
                    let d_7 = (-g_7_10).mul_add(
                        l_7_10,
                        (-g_7_3).mul_add(l_7_3, (-g_7_6).mul_add(l_7_6, (-g_7_2).mul_add(l_7_2, t36))),
                    );
                    let r_7 = by(1.0) / d_7;
                    let growth_7 = (t36 * r_7).abs();
                    let t37 = most_growth.lt(growth_7);
                    let kept_7 = S::select(t37, lit(0.0), r_7);
                    let g_8_7 = -g_7_6.mul_add(l_8_6, t25.mul_add(y_8_11, t20.mul_add(y_8_10, t19 * y_8_9)));
                    let l_8_7 = kept_7 * g_8_7;
                    let w_6 = w[6];
                    let w_8 = w[8];
                    let y_4_8 = t29 * w_8;
                    let r_4 = by(1.0) / t29.mul_add(y_4_8, w_6);
                    let y_5_8 = by(-0.1) * (cos_crank_2_angle * w_8);
                    let g_5_4 = t29 * y_5_8;
                    let l_5_4 = r_4 * g_5_4;
                    let y_8_6 = t26 * w_6;
                    let t38 = (-cos_crank_2_angle).mul_add(t27, sin_crank_2_angle * t26);
                    let y_8_8 = by(-0.1) * (t38 * w_8);
                    let g_8_4 = t29.mul_add(y_8_8, y_8_6);
                    let l_8_4 = r_4 * g_8_4;
                    let l_11_4 = y_4_8 * r_4;
                    let w_7 = w[7];
                    let t39 = (-t28).mul_add(y_5_8, w_7);
                    let r_5 = by(1.0) / (-g_5_4).mul_add(l_5_4, t39);
                    let growth_5 = (t39 * r_5).abs();
                    let t40 = most_growth.lt(growth_5);
                    let kept_5 = S::select(t40, lit(0.0), r_5);
                    let y_8_7 = t27 * w_7;
                    let g_8_5 = (-g_5_4).mul_add(l_8_4, (-t28).mul_add(y_8_8, y_8_7));
                    let l_8_5 = g_8_5 * kept_5;
                    let g_11_5 = (-g_5_4).mul_add(l_11_4, y_5_8);
                    let l_11_5 = g_11_5 * kept_5;
                    let t41 = (-t26)
                        .mul_add(y_8_9, (-(by(0.1) * t38)).mul_add(y_8_8, t27.mul_add(y_8_7, t26 * y_8_6)));
                    let t42 = (-t30).mul_add(y_8_11, (-t27).mul_add(y_8_10, t41));
                    let d_8 = (-g_8_5).mul_add(
                        l_8_5,
                        (-g_8_7).mul_add(l_8_7, (-g_8_6).mul_add(l_8_6, (-g_8_4).mul_add(l_8_4, t42))),
                    );
                    let r_8 = by(1.0) / d_8;
                    let growth_8 = (t42 * r_8).abs();
                    let t43 = most_growth.lt(growth_8);
                    let kept_8 = S::select(t43, lit(0.0), r_8);
                    let g_11_8 = (-g_8_5).mul_add(l_11_5, (-g_8_4).mul_add(l_11_4, y_8_8));
                    let l_11_8 = kept_8 * g_11_8;
                    let r_11 = by(1.0)
                        / (-g_11_8).mul_add(l_11_8, (-g_11_5).mul_add(l_11_5, (-y_4_8).mul_add(l_11_4, w_8)));
                    let growth_11 = (w_8 * r_11).abs();
                    let t44 = most_growth.lt(growth_11);
                    // (phi_q W phi_q^T) mu = r
                    let dphi_0 = r[0];
                    let dphi_1 = r[1];
                    let b_1 = (-dphi_0).mul_add(l_1_0, dphi_1);
                    let dphi_9 = r[9];
                    let b_9 = (-b_1).mul_add(l_9_1, (-dphi_0).mul_add(l_9_0, dphi_9));
                    let dphi_6 = r[6];
                    let b_6 = (-l_6_9).mul_add(b_9, (-b_1).mul_add(l_6_1, (-dphi_0).mul_add(l_6_0, dphi_6)));
                    let dphi_2 = r[2];
                    let dphi_3 = r[3];
                    let b_3 = (-dphi_2).mul_add(l_3_2, dphi_3);
                    let dphi_10 = r[10];
                    let b_10 = (-b_3).mul_add(l_10_3, (-dphi_2).mul_add(l_10_2, dphi_10));
                    let dphi_7 = r[7];
                    let b_7 = (-l_7_10).mul_add(
                        b_10,
                        (-b_3).mul_add(l_7_3, (-l_7_6).mul_add(b_6, (-dphi_2).mul_add(l_7_2, dphi_7))),
                    );
                    let dphi_4 = r[4];
                    let dphi_5 = r[5];
                    let b_5 = (-dphi_4).mul_add(l_5_4, dphi_5);
                    let dphi_8 = r[8];
                    let b_8 = (-b_5).mul_add(
                        l_8_5,
                        (-l_8_7).mul_add(b_7, (-l_8_6).mul_add(b_6, (-dphi_4).mul_add(l_8_4, dphi_8))),
                    );
                    let dphi_11 = r[11];
                    let mu_11 = S::select(t44, lit(0.0), r_11)
                        * (-l_11_8).mul_add(b_8, (-b_5).mul_add(l_11_5, (-dphi_4).mul_add(l_11_4, dphi_11)));
                    let mu_8 = (-l_11_8).mul_add(mu_11, kept_8 * b_8);
                    let mu_5 = (-l_11_5).mul_add(mu_11, (-l_8_5).mul_add(mu_8, b_5 * kept_5));
                    let mu_4 = (-l_11_4)
                        .mul_add(mu_11, (-l_8_4).mul_add(mu_8, (-l_5_4).mul_add(mu_5, dphi_4 * r_4)));
                    let mu_7 = (-l_8_7).mul_add(mu_8, kept_7 * b_7);
                    let mu_10 = (-l_7_10).mul_add(mu_7, kept_10 * b_10);
                    let mu_3 = (-l_10_3).mul_add(mu_10, (-l_7_3).mul_add(mu_7, b_3 * kept_3));
                    let mu_2 = (-l_10_2)
                        .mul_add(mu_10, (-l_7_2).mul_add(mu_7, (-l_3_2).mul_add(mu_3, dphi_2 * r_2)));
                    let mu_6 = (-l_8_6).mul_add(mu_8, (-l_7_6).mul_add(mu_7, kept_6 * b_6));
                    let mu_9 = (-l_6_9).mul_add(mu_6, kept_9 * b_9);
                    let mu_1 = (-l_9_1).mul_add(mu_9, (-l_6_1).mul_add(mu_6, b_1 * kept_1));
                    let mu_0 =
                        (-l_9_0).mul_add(mu_9, (-l_6_0).mul_add(mu_6, (-l_1_0).mul_add(mu_1, dphi_0 * r_0)));
                    // Results
                    dq[0] = y_6_0.mul_add(mu_6, w_0 * mu_0);
                    dq[1] = y_6_1.mul_add(mu_6, w_1 * mu_1);
                    dq[2] = w_2.mul_add(mu_9, y_6_2.mul_add(mu_6, y_1_2.mul_add(mu_1, y_0_2 * mu_0)));
                    dq[3] = y_7_3.mul_add(mu_7, w_3 * mu_2);
                    dq[4] = y_7_4.mul_add(mu_7, w_4 * mu_3);
                    dq[5] = w_5.mul_add(mu_10, y_7_5.mul_add(mu_7, y_3_5.mul_add(mu_3, y_2_5 * mu_2)));
                    dq[6] = y_8_6.mul_add(mu_8, w_6 * mu_4);
                    dq[7] = y_8_7.mul_add(mu_8, w_7 * mu_5);
                    dq[8] = w_8.mul_add(mu_11, y_8_8.mul_add(mu_8, y_5_8.mul_add(mu_5, y_4_8 * mu_4)));
                    dq[9] = y_8_9.mul_add(mu_8, y_7_9.mul_add(mu_7, y_6_9 * mu_6));
                    dq[10] = y_8_10.mul_add(mu_8, y_7_10.mul_add(mu_7, y_6_10 * mu_6));
                    dq[11] = y_8_11.mul_add(mu_8, y_7_11.mul_add(mu_7, y_6_11 * mu_6));
                    let t45 = S::select(t7, lit(0.0), growth_1)
                        .max(S::select(t8, lit(0.0), growth_9))
                        .max(S::select(t18, lit(0.0), growth_6));
                    let t46 = t45
                        .max(S::select(t33, lit(0.0), growth_3))
                        .max(S::select(t34, lit(0.0), growth_10))
                        .max(S::select(t37, lit(0.0), growth_7));
                    let t47 = t46
                        .max(S::select(t40, lit(0.0), growth_5))
                        .max(S::select(t43, lit(0.0), growth_8))
                        .max(S::select(t44, lit(0.0), growth_11));
                    by(1.0) / t47
                })
            }

            /// Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body.
            fn inverse_mass(&self) -> [S; 12] {
                let mut inverse_mass = [S::lit(0.0); 12];
                let lit = S::lit;
                inverse_mass[0] = lit(3.3333333333333335);
                inverse_mass[1] = lit(3.3333333333333335);
                inverse_mass[2] = lit(100.0);
                inverse_mass[3] = lit(3.3333333333333335);
                inverse_mass[4] = lit(3.3333333333333335);
                inverse_mass[5] = lit(100.0);
                inverse_mass[6] = lit(3.3333333333333335);
                inverse_mass[7] = lit(3.3333333333333335);
                inverse_mass[8] = lit(100.0);
                inverse_mass[9] = lit(0.5);
                inverse_mass[10] = lit(0.5);
                inverse_mass[11] = lit(3.3333333333333335);
                inverse_mass
            }

            fn length(&self) -> S {
                S::lit(0.4)
            }

            fn start_position(&self) -> [Start<S>; 12] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 4] = [
                    self.start.crank_0.of_centre([lit(0.0), lit(0.0)]),
                    self.start.crank_1.of_centre([lit(0.0), lit(0.0)]),
                    self.start.crank_2.of_centre([lit(0.0), lit(0.0)]),
                    self.start.plate.of_centre([lit(0.0), lit(0.0)]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn start_velocity(&self, q: &[S; 12]) -> [Start<S>; 12] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 4] = [
                    self.start.crank_0.velocity_of_centre([lit(0.0), lit(0.0)], q[2]),
                    self.start.crank_1.velocity_of_centre([lit(0.0), lit(0.0)], q[5]),
                    self.start.crank_2.velocity_of_centre([lit(0.0), lit(0.0)], q[8]),
                    self.start.plate.velocity_of_centre([lit(0.0), lit(0.0)], q[11]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn refine(&self, t: S, q: &[S; 12]) -> Option<([S; 12], [S; 12])> {
                rt::singular::refine::<Self, 12, 12, 24>(self, t, q)
            }
        }

        impl<S: Real> PlateOnThreePins<S> {
            /// Accelerations and multipliers by a rank-revealing decomposition.
            #[cold]
            fn accelerate(
                &self,
                t: S,
                u: &Held<S>,
                x: &[S; 24],
            ) -> Result<absolute::Acceleration<S, NQ, NC>, Fault> {
                let (q, _): ([S; 12], [S; 12]) = absolute::split(x);
                let (mut force, mut gamma) = ([S::lit(0.0); 12], [S::lit(0.0); 12]);
                self.free(t, u, x, &mut force, &mut gamma);
                let inverse_mass = absolute::Absolute::<S, NQ, NC>::inverse_mass(self);
                absolute::accelerate(t, &inverse_mass, &force, &gamma, |rows| {
                    absolute::phi_q_matrix(self, t, &q, rows)
                })
            }
        }

        impl<S: Real> State<S> {
            /// Accelerations and multipliers; multipliers that redundancy leaves undetermined have their minimum norm.
            fn solved_(&self, common: &Common<S>) -> ([S; 12], [S; 12]) {
                let (mut dx, mut lambda) = ([S::lit(0.0); 24], [S::lit(0.0); 12]);
                let (u, x) = (&self.held, self.joined_(common.pose.get_or_init(|| self.pose_())));
                let health = self.mechanism.dynamics(self.time, u, &x, &mut dx, &mut lambda);
                if !rt::Health(health).is_good() {
                    if let Ok(solution) = self.mechanism.accelerate(self.time, u, &x) {
                        return (solution.a, solution.lambda);
                    }
                }
                let (_, a): ([S; 12], [S; 12]) = absolute::split(&dx);
                (a, lambda)
            }

            /// Reactions that redundancy leaves undetermined, by constraint row; they are given with minimum norm.
            pub fn undetermined(&self) -> [bool; 12] {
                match self.mechanism.accelerate(self.time, &self.held, &self.absolute_()) {
                    Ok(solution) => solution.undetermined,
                    Err(_) => [true; 12],
                }
            }
        }

        impl<S: Real> rt::lanes::Pack for PlateOnThreePins<S> {
            type Packed<T: Scalar> = PlateOnThreePins<T>;

            #[allow(unused_variables)]
            fn pack<T: Scalar, const N: usize>(
                &self,
                all: [&Self; N],
                number: impl Fn([S; N]) -> T,
            ) -> PlateOnThreePins<T> {
                let same = |s| number([s; N]);
                let start = Starts {
                    crank_0: self.start.crank_0.map(same),
                    crank_1: self.start.crank_1.map(same),
                    crank_2: self.start.crank_2.map(same),
                    plate: self.start.plate.map(same),
                };
                PlateOnThreePins { start }
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
            fn look<T: Scalar>(all: &PlateOnThreePins<T>, t: T, held: &mut Held<T>, x: &[T; 0], due: T) -> T {
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

        impl<S: Real> rt::Linear for PlateOnThreePins<S> {
            type Lifted<const K: usize> = PlateOnThreePins<rt::Dual<S, K>>;
            type In<T: Real> = PlateOnThreePins<T>;
            type Derivatives = [[S; 0]; 0];

            fn lift<const K: usize>(
                &self,
                held: &Held<S>,
            ) -> (PlateOnThreePins<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                self.in_numbers(held, rt::Dual::constant)
            }

            fn in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (PlateOnThreePins<T>, Held<T>) {
                use rt::lanes::Pack;
                let of_one = |[s]: [S; 1]| number(s);
                (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
            }

            #[inline]
            fn rate_in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (PlateOnThreePins<T>, Held<T>) {
                let value = Start::free(T::ZERO);
                let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
                let start = Starts { crank_0: zero, crank_1: zero, crank_2: zero, plate: zero };
                let own = PlateOnThreePins { start };
                let same = |[s]: [S; 1]| S::of_plain(s.plain());
                let of_loops = rt::held::Loops::<S>::packed(&held.of_loops, [&held.of_loops], &same);
                let held = &rt::Held { of_loops, ..*held };
                (own, <Self as rt::lanes::Pack>::pack_held(held, [held], |[s]: [S; 1]| number(s)))
            }
        }

        impl<S: Real> rt::Ports for PlateOnThreePins<S> {
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

        impl<S: Real> rt::Described for PlateOnThreePins<S> {
            const TABLES: &'static described::Tables = &described::Tables {
                name: "PlateOnThreePins",
                docs: "A plate on the pins of three driven cranks: an angle and three slides that only Newton's iteration finds.",
                report: described::Report {
                    rung: 1,
                    formulation: "kinematics",
                    reason: "no freedom is left, and the motion follows from the time alone",
                    operations: OPERATIONS,
                    degrees_of_freedom: NDOF,
                },
                bodies: &[
                    described::Body { name: "crank[0]", ports: &["o", "p"], contour: 0, first: 0 },
                    described::Body { name: "crank[1]", ports: &["o", "p"], contour: 0, first: 9 },
                    described::Body { name: "crank[2]", ports: &["o", "p"], contour: 0, first: 18 },
                    described::Body { name: "plate", ports: &["a", "b", "c"], contour: 0, first: 27 },
                ],
                ground: &[
                    described::GroundPort { name: "a", moves: false, first: 39 },
                    described::GroundPort { name: "b", moves: false, first: 43 },
                    described::GroundPort { name: "c", moves: false, first: 47 },
                ],
                parts: &[
                    described::Part {
                        name: "o[0]",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 0 },
                            described::Frame { argument: "b", body: Some(0), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 51,
                    },
                    described::Part {
                        name: "o[1]",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 1 },
                            described::Frame { argument: "b", body: Some(1), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 52,
                    },
                    described::Part {
                        name: "o[2]",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 2 },
                            described::Frame { argument: "b", body: Some(2), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 53,
                    },
                    described::Part {
                        name: "slot[0]",
                        kind: "pin_slot",
                        pair: Some("pin_slot"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(3), port: 0 },
                            described::Frame { argument: "b", body: Some(0), port: 1 },
                        ],
                        sizes: &[],
                        first: 54,
                    },
                    described::Part {
                        name: "slot[1]",
                        kind: "pin_slot",
                        pair: Some("pin_slot"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(3), port: 1 },
                            described::Frame { argument: "b", body: Some(1), port: 1 },
                        ],
                        sizes: &[],
                        first: 54,
                    },
                    described::Part {
                        name: "slot[2]",
                        kind: "pin_slot",
                        pair: Some("pin_slot"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(3), port: 2 },
                            described::Frame { argument: "b", body: Some(2), port: 1 },
                        ],
                        sizes: &[],
                        first: 54,
                    },
                ],
                parameters: &[],
                inputs: &[],
                states: &[],
                outputs: &[
                    described::Quantity {
                        name: "slot[2].force.x",
                        docs: "What the slot does to `plate` at the point of `crank[2].p`, absolute axes; `crank[2]` feels the opposite.",
                        unit: "N",
                        factor: 1.0,
                        exponents: [1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                    described::Quantity {
                        name: "slot[2].force.y",
                        docs: "What the slot does to `plate` at the point of `crank[2].p`, absolute axes; `crank[2]` feels the opposite.",
                        unit: "N",
                        factor: 1.0,
                        exponents: [1, 1, -2, 0, 0, 0, 0],
                        default: None,
                    },
                ],
                reads: &[None, None],
            };
            const OBSERVED: &'static [(&'static str, &'static str)] = &State::<S>::OBSERVED;
            const DECLARATION: &'static str = "/// A plate on the pins of three driven cranks: an angle and three slides that only Newton's iteration finds.\npub PlateOnThreePins {\n    gravity: 9.81 m/s^2;\n    ground { port a: (0, 0) m; port b: (1, 0) m; port c: (0.5, 0.9) m; }\n    body crank[0] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.1 m; start angle: 20 deg; }\n    body crank[1] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 1.1 m; start angle: 20 deg; }\n    body crank[2] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.6 m; start y: 0.9 m; start angle: -20 deg; }\n    body plate { mass: 2 kg; inertia: 0.3 kg*m^2; port a: (-0.4, -0.3) m, angle: 35 deg; port b: (0.4, -0.3) m, angle: 140 deg; port c: (0, 0.4) m, angle: 100 deg; start x: 0.5 m; start y: 0.3 m; }\n    revolute o[0](ground.a, crank[0].o);\n    revolute o[1](ground.b, crank[1].o);\n    revolute o[2](ground.c, crank[2].o);\n    pin_slot slot[0](plate.a, crank[0].p) { stiffness: 100 N/m; }\n    pin_slot slot[1](plate.b, crank[1].p);\n    pin_slot slot[2](plate.c, crank[2].p);\n    constraint first: crank[0].angle = 0.4 rad*sin(3 rad/s*t);\n    constraint second: crank[1].angle = 0.3 rad*cos(2 rad/s*t);\n    constraint third: crank[2].angle = 0.2 rad*sin(4 rad/s*t) - 0.1 rad;\n    output slot[2].force;\n}\n";
            const FILES: &'static [(&'static str, &'static str)] = &[];
            fn figure(&self, t: S, index: usize) -> Option<S> {
                let constants: &[f64] = const {
                    &[
                        0.3,
                        0.01,
                        0.0,
                        -0.1,
                        0.0,
                        0.0,
                        0.1,
                        0.0,
                        0.0,
                        0.3,
                        0.01,
                        0.0,
                        -0.1,
                        0.0,
                        0.0,
                        0.1,
                        0.0,
                        0.0,
                        0.3,
                        0.01,
                        0.0,
                        -0.1,
                        0.0,
                        0.0,
                        0.1,
                        0.0,
                        0.0,
                        2.0,
                        0.3,
                        0.0,
                        -0.4,
                        -0.3,
                        0.6108652381980153,
                        0.4,
                        -0.3,
                        2.443460952792061,
                        0.0,
                        0.4,
                        1.7453292519943295,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        1.0,
                        0.0,
                        0.0,
                        0.0,
                        0.5,
                        0.9,
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
                self.crank_0.each(
                    [
                        "crank[0].x",
                        "crank[0].y",
                        "crank[0].angle",
                        "crank[0].vx",
                        "crank[0].vy",
                        "crank[0].omega",
                    ],
                    &mut *each,
                );
                self.crank_1.each(
                    [
                        "crank[1].x",
                        "crank[1].y",
                        "crank[1].angle",
                        "crank[1].vx",
                        "crank[1].vy",
                        "crank[1].omega",
                    ],
                    &mut *each,
                );
                self.crank_2.each(
                    [
                        "crank[2].x",
                        "crank[2].y",
                        "crank[2].angle",
                        "crank[2].vx",
                        "crank[2].vy",
                        "crank[2].omega",
                    ],
                    &mut *each,
                );
                self.plate.each(
                    ["plate.x", "plate.y", "plate.angle", "plate.vx", "plate.vy", "plate.omega"],
                    &mut *each,
                );
            }
        }

        impl<S: Scalar> core::fmt::Display for Starts<S> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                rt::start::write_starts(*self, f)
            }
        }

        impl<S: Real> PlateOnThreePins<S> {
            fn placed(&self, x: &[S; 24]) -> Starts<S> {
                let lit = S::lit;
                Starts {
                    crank_0: self.start.crank_0.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[0], x[1], x[2]],
                        [x[12], x[13], x[14]],
                    ),
                    crank_1: self.start.crank_1.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[3], x[4], x[5]],
                        [x[15], x[16], x[17]],
                    ),
                    crank_2: self.start.crank_2.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[6], x[7], x[8]],
                        [x[18], x[19], x[20]],
                    ),
                    plate: self.start.plate.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[9], x[10], x[11]],
                        [x[21], x[22], x[23]],
                    ),
                }
            }
        }

        impl<S: Real> State<S> {
            /// Poses, velocities and states of this moment as start values, with the locks that are set: to go on from here
            /// later, `mechanism.start = sim.starts()`.
            pub fn starts(&self) -> Starts<S> {
                self.mechanism.placed(&<PlateOnThreePins<S> as rt::Statics>::full(self))
            }
        }

        impl<S: Real> rt::Statics for PlateOnThreePins<S> {
            type Full = [S; 24];
            type Rows = [S; 12];
            type Starts = Starts<S>;
            const COORDINATES: &'static [&'static str] = Self::LAYOUT_.coordinates;
            const ROWS: &'static [&'static str] = Self::LAYOUT_.rows;
            const STATES: &'static [(&'static str, &'static str)] = &[];
            fn full(state: &State<S>) -> [S; 24] {
                {
                    let mut x = state.absolute_();
                    rt::turns::add(&state.held.turns, &mut x, &[&[11]]);
                    x
                }
            }

            /// What vanishes at rest: applied forces `Q` (N, N, N m per body) that reactions do not balance, residuals of the
            /// constraints, rates of the first-order states, without accelerations.
            ///
            /// 15 add, 25 mul, 2 sin_cos.
            #[cold]
            fn equations(&self, t: S, u: &Self::U, x: &[S; 24], lambda: &[S; 12], each: &mut impl FnMut(S)) {
                let (mut force, mut x_dot) = ([S::lit(0.0); 12], [S::lit(0.0); 0]);
                let [
                    crank_0_x,
                    crank_0_y,
                    crank_0_angle,
                    _,
                    _,
                    _,
                    _,
                    _,
                    _,
                    plate_x,
                    plate_y,
                    plate_angle,
                    ..,
                ] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                let ([sin_plate_angle, sin_crank_0_angle], [cos_plate_angle, cos_crank_0_angle]) =
                    S::sin_cos_all([plate_angle, crank_0_angle]);
                let t1 =
                    by(-0.573576436351046).mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle);
                let t2 = by(-0.3).mul_add(sin_plate_angle, by(0.4) * cos_plate_angle);
                let t3 =
                    by(0.8191520442889918).mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle);
                let t4 = by(0.4).mul_add(sin_plate_angle, by(0.3) * cos_plate_angle);
                let t5 = t3.mul_add(
                    by(0.1).mul_add(sin_crank_0_angle, crank_0_y) - plate_y + t4,
                    t1 * (by(0.1).mul_add(cos_crank_0_angle, crank_0_x) - plate_x + t2),
                );
                let t6 = t1 * t5;
                force[0] = by(-100.0) * t6;
                let t7 = by(100.0) * (t3 * t5);
                force[1] = lit(-2.943) - t7;
                force[2] = by(-10.0) * t5 * (-sin_crank_0_angle).mul_add(t1, cos_crank_0_angle * t3);
                force[3] = lit(0.0);
                force[4] = lit(-2.943);
                force[5] = lit(0.0);
                force[6] = lit(0.0);
                force[7] = lit(-2.943);
                force[8] = lit(0.0);
                force[9] = by(100.0) * t6;
                force[10] = t7 - lit(19.62);
                force[11] = by(-100.0) * t5 * (-t4).mul_add(t1, t2 * t3);
                let (q, _): ([S; 12], [S; 12]) = absolute::split(x);
                absolute::balance::<S, Self, NQ, NC>(self, t, &q, lambda, &force)
                    .into_iter()
                    .for_each(&mut *each);
                absolute::residuals::<S, Self, NQ, NC, 24>(self, t, x, each);
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

            fn starts_at(&self, x: &[S; 24]) -> Starts<S> {
                self.placed(x)
            }

            fn size(&self) -> S {
                absolute::Absolute::<S, NQ, NC>::length(self)
            }
        }

        impl<S: Scalar> PlateOnThreePins<S> {
            /// The right-hand side and the multipliers: `M a + phi_q^T lambda = Q`, `phi_q a = gamma`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 261 add, 367 mul, 13 div, 5 neg, 7 sin_cos, 44 select.
            #[inline(always)]
            fn dynamics(&self, t: S, u: &Held<S>, x: &[S; 24], dx: &mut [S; 24], lambda: &mut [S; 12]) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let (
                    sin_crank_0_angle,
                    cos_crank_0_angle,
                    sin_crank_1_angle,
                    cos_crank_1_angle,
                    sin_crank_2_angle,
                    cos_crank_2_angle,
                    sin_plate_angle,
                    cos_plate_angle,
                    t4,
                    t5,
                    t13,
                    t14,
                    t16,
                    t17,
                    t18,
                    t21,
                    t23,
                    t24,
                    t25,
                    t26,
                    t28,
                    t29,
                    t30,
                    y_0_2,
                    y_1_2,
                    y_2_5,
                    y_3_5,
                    y_4_8,
                    y_5_8,
                    y_6_0,
                    y_6_1,
                    y_6_2,
                    y_6_9,
                    y_6_10,
                    y_6_11,
                    y_7_3,
                    y_7_4,
                    y_7_5,
                    y_7_9,
                    y_7_10,
                    y_7_11,
                    y_8_6,
                    y_8_7,
                    y_8_8,
                    y_8_9,
                    y_8_10,
                    y_8_11,
                    free_crank_0_x,
                    free_crank_0_y,
                    free_crank_0_angle,
                    free_plate_x,
                    free_plate_y,
                    free_plate_angle,
                    r_0,
                    l_1_0,
                    l_6_0,
                    l_9_0,
                    growth_1,
                    most_growth,
                    t35,
                    kept_1,
                    l_6_1,
                    l_9_1,
                    growth_9,
                    t36,
                    kept_9,
                    l_6_9,
                    t37,
                    growth_6,
                    t40,
                    kept_6,
                    l_7_6,
                    g_8_6,
                    l_8_6,
                    r_2,
                    l_3_2,
                    l_7_2,
                    l_10_2,
                    growth_3,
                    t43,
                    kept_3,
                    l_7_3,
                    l_10_3,
                    growth_10,
                    t44,
                    kept_10,
                    l_7_10,
                    growth_7,
                    t47,
                    kept_7,
                    g_8_7,
                    l_8_7,
                    r_4,
                    l_5_4,
                    g_8_4,
                    l_8_4,
                    l_11_4,
                    growth_5,
                    t50,
                    kept_5,
                    g_8_5,
                    l_8_5,
                    g_11_5,
                    l_11_5,
                    t51,
                ) = {
                    // Arms from G to each port: the entries of phi_q, and of phi_q M^-1
                    let crank_0_angle = x[2];
                    let crank_1_angle = x[5];
                    let crank_2_angle = x[8];
                    let plate_angle = x[11];
                    let (
                        [sin_crank_0_angle, sin_crank_1_angle, sin_crank_2_angle, sin_plate_angle],
                        [cos_crank_0_angle, cos_crank_1_angle, cos_crank_2_angle, cos_plate_angle],
                    ) = S::sin_cos_all([crank_0_angle, crank_1_angle, crank_2_angle, plate_angle]);
                    let t1 = by(0.1) * sin_crank_0_angle;
                    let t2 = by(0.1) * sin_crank_1_angle;
                    let t3 = by(0.1) * sin_crank_2_angle;
                    let t4 = by(0.8191520442889918)
                        .mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle);
                    let t5 = by(-0.573576436351046)
                        .mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle);
                    let t6 = cos_crank_0_angle.mul_add(t5, sin_crank_0_angle * t4);
                    let t7 = by(0.3) * cos_plate_angle;
                    let t8 = by(0.4) * sin_plate_angle;
                    let t9 = t7 + t8;
                    let t10 = by(0.4) * cos_plate_angle;
                    let t11 = by(0.3) * sin_plate_angle;
                    let t12 = t10 - t11;
                    let crank_0_x = x[0];
                    let plate_x = x[9];
                    let t13 = by(0.1).mul_add(cos_crank_0_angle, crank_0_x) - plate_x + t12;
                    let crank_0_y = x[1];
                    let plate_y = x[10];
                    let t14 = crank_0_y + t1 - plate_y + t9;
                    let t15 = t4.mul_add(t14, t5 * t13);
                    let t16 = (-t12).mul_add(t5, (-t9).mul_add(t4, t15));
                    let t17 = by(-0.766044443118978)
                        .mul_add(sin_plate_angle, by(0.6427876096865393) * cos_plate_angle);
                    let t18 = by(0.6427876096865393)
                        .mul_add(sin_plate_angle, by(0.766044443118978) * cos_plate_angle);
                    let t19 = (-cos_crank_1_angle).mul_add(t18, sin_crank_1_angle * t17);
                    let t20 = t10 + t11;
                    let crank_1_x = x[3];
                    let t21 = by(0.1).mul_add(cos_crank_1_angle, crank_1_x) - plate_x - t20;
                    let t22 = t7 - t8;
                    let crank_1_y = x[4];
                    let t23 = crank_1_y + t2 - plate_y + t22;
                    let t24 = (-t17).mul_add(t23 - t22, t18 * (t20 + t21));
                    let t25 = by(-0.17364817766693033)
                        .mul_add(sin_plate_angle, by(0.984807753012208) * cos_plate_angle);
                    let t26 = by(0.984807753012208)
                        .mul_add(sin_plate_angle, by(0.17364817766693033) * cos_plate_angle);
                    let t27 = (-cos_crank_2_angle).mul_add(t26, sin_crank_2_angle * t25);
                    let crank_2_x = x[6];
                    let t28 = by(0.1).mul_add(cos_crank_2_angle, crank_2_x) - plate_x + t8;
                    let crank_2_y = x[7];
                    let t29 = crank_2_y + t3 - plate_y - t10;
                    let t30 = (-t25).mul_add(t10 + t29, t26 * (t28 - t8));
                    let y_0_2 = by(10.0) * sin_crank_0_angle;
                    let y_1_2 = by(-10.0) * cos_crank_0_angle;
                    let y_2_5 = by(10.0) * sin_crank_1_angle;
                    let y_3_5 = by(-10.0) * cos_crank_1_angle;
                    let y_4_8 = by(10.0) * sin_crank_2_angle;
                    let y_5_8 = by(-10.0) * cos_crank_2_angle;
                    let y_6_0 = by(3.3333333333333335) * t4;
                    let y_6_1 = by(-3.3333333333333335) * t5;
                    let y_6_2 = by(-10.0) * t6;
                    let y_6_9 = by(-0.5) * t4;
                    let y_6_10 = by(0.5) * t5;
                    let y_6_11 = by(3.3333333333333335) * t16;
                    let y_7_3 = by(3.3333333333333335) * t17;
                    let y_7_4 = by(3.3333333333333335) * t18;
                    let y_7_5 = by(-10.0) * t19;
                    let y_7_9 = by(-0.5) * t17;
                    let y_7_10 = by(-0.5) * t18;
                    let y_7_11 = by(-3.3333333333333335) * t24;
                    let y_8_6 = by(3.3333333333333335) * t25;
                    let y_8_7 = by(3.3333333333333335) * t26;
                    let y_8_8 = by(-10.0) * t27;
                    let y_8_9 = by(-0.5) * t25;
                    let y_8_10 = by(-0.5) * t26;
                    let y_8_11 = by(-3.3333333333333335) * t30;
                    // Accelerations without constraints, M^-1 Q
                    let t31 = t5 * t15;
                    let free_crank_0_x = by(-333.3333333333333) * t31;
                    let t32 = t4 * t15;
                    let free_crank_0_y = by(-333.3333333333333).mul_add(t32, lit(-9.81));
                    let free_crank_0_angle =
                        by(-1000.0) * t15 * (-sin_crank_0_angle).mul_add(t5, cos_crank_0_angle * t4);
                    let free_plate_x = by(50.0) * t31;
                    let free_plate_y = by(50.0).mul_add(t32, lit(-9.81));
                    let free_plate_angle = by(-333.3333333333333) * t15 * (-t9).mul_add(t5, t12 * t4);
                    // phi_q M^-1 phi_q^T = L D L^T
                    let r_0 = by(1.0) / t1.mul_add(y_0_2, lit(3.3333333333333335));
                    let g_1_0 = t1 * y_1_2;
                    let l_1_0 = r_0 * g_1_0;
                    let g_6_0 = t1.mul_add(y_6_2, y_6_0);
                    let l_6_0 = r_0 * g_6_0;
                    let l_9_0 = y_0_2 * r_0;
                    let t33 = by(0.1) * cos_crank_0_angle;
                    let t34 = t33.mul_add(y_1_2, lit(-3.3333333333333335));
                    let r_1 = by(1.0) / -g_1_0.mul_add(l_1_0, t34);
                    let growth_1 = (t34 * r_1).abs();
                    let most_growth = lit(S::MOST_GROWTH);
                    let t35 = most_growth.lt(growth_1);
                    let kept_1 = S::select(t35, lit(0.0), r_1);
                    let g_6_1 = (-g_1_0).mul_add(l_6_0, (-t33).mul_add(y_6_2, y_6_1));
                    let l_6_1 = g_6_1 * kept_1;
                    let g_9_1 = (-g_1_0).mul_add(l_9_0, y_1_2);
                    let l_9_1 = g_9_1 * kept_1;
                    let r_9 = by(1.0) / (-g_9_1).mul_add(l_9_1, (-y_0_2).mul_add(l_9_0, lit(100.0)));
                    let growth_9 = by(100.0) * r_9.abs();
                    let t36 = most_growth.lt(growth_9);
                    let kept_9 = S::select(t36, lit(0.0), r_9);
                    let g_6_9 = (-g_6_1).mul_add(l_9_1, (-g_6_0).mul_add(l_9_0, y_6_2));
                    let l_6_9 = kept_9 * g_6_9;
                    let t37 = by(0.1) * t6;
                    let t38 = t5.mul_add(
                        y_6_10,
                        (-t4).mul_add(y_6_9, (-t37).mul_add(y_6_2, (-t5).mul_add(y_6_1, t4 * y_6_0))),
                    );
                    let t39 = t16.mul_add(y_6_11, t38);
                    let r_6 = by(1.0)
                        / (-g_6_9).mul_add(l_6_9, (-g_6_1).mul_add(l_6_1, (-g_6_0).mul_add(l_6_0, t39)));
                    let growth_6 = (t39 * r_6).abs();
                    let t40 = most_growth.lt(growth_6);
                    let kept_6 = S::select(t40, lit(0.0), r_6);
                    let g_7_6 = t16.mul_add(y_7_11, (-t4).mul_add(y_7_9, t5 * y_7_10));
                    let l_7_6 = kept_6 * g_7_6;
                    let g_8_6 = t16.mul_add(y_8_11, (-t4).mul_add(y_8_9, t5 * y_8_10));
                    let l_8_6 = kept_6 * g_8_6;
                    let r_2 = by(1.0) / t2.mul_add(y_2_5, lit(3.3333333333333335));
                    let g_3_2 = t2 * y_3_5;
                    let l_3_2 = r_2 * g_3_2;
                    let g_7_2 = t2.mul_add(y_7_5, y_7_3);
                    let l_7_2 = r_2 * g_7_2;
                    let l_10_2 = y_2_5 * r_2;
                    let t41 = by(0.1) * cos_crank_1_angle;
                    let t42 = t41.mul_add(y_3_5, lit(-3.3333333333333335));
                    let r_3 = by(1.0) / -g_3_2.mul_add(l_3_2, t42);
                    let growth_3 = (t42 * r_3).abs();
                    let t43 = most_growth.lt(growth_3);
                    let kept_3 = S::select(t43, lit(0.0), r_3);
                    let g_7_3 = (-g_3_2).mul_add(l_7_2, (-t41).mul_add(y_7_5, y_7_4));
                    let l_7_3 = g_7_3 * kept_3;
                    let g_10_3 = (-g_3_2).mul_add(l_10_2, y_3_5);
                    let l_10_3 = g_10_3 * kept_3;
                    let r_10 = by(1.0) / (-g_10_3).mul_add(l_10_3, (-y_2_5).mul_add(l_10_2, lit(100.0)));
                    let growth_10 = by(100.0) * r_10.abs();
                    let t44 = most_growth.lt(growth_10);
                    let kept_10 = S::select(t44, lit(0.0), r_10);
                    let g_7_10 = (-g_7_3).mul_add(l_10_3, (-g_7_2).mul_add(l_10_2, y_7_5));
                    let l_7_10 = kept_10 * g_7_10;
                    let t45 = (-t17)
                        .mul_add(y_7_9, (-(by(0.1) * t19)).mul_add(y_7_5, t18.mul_add(y_7_4, t17 * y_7_3)));
                    let t46 = (-t24).mul_add(y_7_11, (-t18).mul_add(y_7_10, t45));
                    let d_7 = (-g_7_10).mul_add(
                        l_7_10,
                        (-g_7_3).mul_add(l_7_3, (-g_7_6).mul_add(l_7_6, (-g_7_2).mul_add(l_7_2, t46))),
                    );
                    let r_7 = by(1.0) / d_7;
                    let growth_7 = (t46 * r_7).abs();
                    let t47 = most_growth.lt(growth_7);
                    let kept_7 = S::select(t47, lit(0.0), r_7);
                    let g_8_7 = -g_7_6.mul_add(l_8_6, t24.mul_add(y_8_11, t18.mul_add(y_8_10, t17 * y_8_9)));
                    let l_8_7 = kept_7 * g_8_7;
                    let r_4 = by(1.0) / t3.mul_add(y_4_8, lit(3.3333333333333335));
                    let g_5_4 = t3 * y_5_8;
                    let l_5_4 = r_4 * g_5_4;
                    let g_8_4 = t3.mul_add(y_8_8, y_8_6);
                    let l_8_4 = r_4 * g_8_4;
                    let l_11_4 = y_4_8 * r_4;
                    let t48 = by(0.1) * cos_crank_2_angle;
                    let t49 = t48.mul_add(y_5_8, lit(-3.3333333333333335));
                    let r_5 = by(1.0) / -g_5_4.mul_add(l_5_4, t49);
                    let growth_5 = (t49 * r_5).abs();
                    let t50 = most_growth.lt(growth_5);
                    let kept_5 = S::select(t50, lit(0.0), r_5);
                    let g_8_5 = (-g_5_4).mul_add(l_8_4, (-t48).mul_add(y_8_8, y_8_7));
                    let l_8_5 = g_8_5 * kept_5;
                    let g_11_5 = (-g_5_4).mul_add(l_11_4, y_5_8);
                    let l_11_5 = g_11_5 * kept_5;
                    let t51 = (-t25)
                        .mul_add(y_8_9, (-(by(0.1) * t27)).mul_add(y_8_8, t26.mul_add(y_8_7, t25 * y_8_6)));
                    (
                        sin_crank_0_angle,
                        cos_crank_0_angle,
                        sin_crank_1_angle,
                        cos_crank_1_angle,
                        sin_crank_2_angle,
                        cos_crank_2_angle,
                        sin_plate_angle,
                        cos_plate_angle,
                        t4,
                        t5,
                        t13,
                        t14,
                        t16,
                        t17,
                        t18,
                        t21,
                        t23,
                        t24,
                        t25,
                        t26,
                        t28,
                        t29,
                        t30,
                        y_0_2,
                        y_1_2,
                        y_2_5,
                        y_3_5,
                        y_4_8,
                        y_5_8,
                        y_6_0,
                        y_6_1,
                        y_6_2,
                        y_6_9,
                        y_6_10,
                        y_6_11,
                        y_7_3,
                        y_7_4,
                        y_7_5,
                        y_7_9,
                        y_7_10,
                        y_7_11,
                        y_8_6,
                        y_8_7,
                        y_8_8,
                        y_8_9,
                        y_8_10,
                        y_8_11,
                        free_crank_0_x,
                        free_crank_0_y,
                        free_crank_0_angle,
                        free_plate_x,
                        free_plate_y,
                        free_plate_angle,
                        r_0,
                        l_1_0,
                        l_6_0,
                        l_9_0,
                        growth_1,
                        most_growth,
                        t35,
                        kept_1,
                        l_6_1,
                        l_9_1,
                        growth_9,
                        t36,
                        kept_9,
                        l_6_9,
                        t37,
                        growth_6,
                        t40,
                        kept_6,
                        l_7_6,
                        g_8_6,
                        l_8_6,
                        r_2,
                        l_3_2,
                        l_7_2,
                        l_10_2,
                        growth_3,
                        t43,
                        kept_3,
                        l_7_3,
                        l_10_3,
                        growth_10,
                        t44,
                        kept_10,
                        l_7_10,
                        growth_7,
                        t47,
                        kept_7,
                        g_8_7,
                        l_8_7,
                        r_4,
                        l_5_4,
                        g_8_4,
                        l_8_4,
                        l_11_4,
                        growth_5,
                        t50,
                        kept_5,
                        g_8_5,
                        l_8_5,
                        g_11_5,
                        l_11_5,
                        t51,
                    )
                };
                let t95 = {
                    let t52 = (-t30).mul_add(y_8_11, (-t26).mul_add(y_8_10, t51));
                    let d_8 = (-g_8_5).mul_add(
                        l_8_5,
                        (-g_8_7).mul_add(l_8_7, (-g_8_6).mul_add(l_8_6, (-g_8_4).mul_add(l_8_4, t52))),
                    );
                    let r_8 = by(1.0) / d_8;
                    let growth_8 = (t52 * r_8).abs();
                    let t53 = most_growth.lt(growth_8);
                    let kept_8 = S::select(t53, lit(0.0), r_8);
                    let g_11_8 = (-g_8_5).mul_add(l_11_5, (-g_8_4).mul_add(l_11_4, y_8_8));
                    let l_11_8 = kept_8 * g_11_8;
                    let r_11 = by(1.0)
                        / (-g_11_8)
                            .mul_add(l_11_8, (-g_11_5).mul_add(l_11_5, (-y_4_8).mul_add(l_11_4, lit(100.0))));
                    let growth_11 = by(100.0) * r_11.abs();
                    let t54 = most_growth.lt(growth_11);
                    // Multipliers: (phi_q M^-1 phi_q^T) lambda = phi_q M^-1 Q - gamma
                    let crank_0_omega = x[14];
                    let t55 = crank_0_omega * cos_crank_0_angle;
                    let t56 = crank_0_omega * t55;
                    let b_0 =
                        by(0.1).mul_add(sin_crank_0_angle.mul_add(free_crank_0_angle, t56), free_crank_0_x);
                    let t57 = crank_0_omega * sin_crank_0_angle;
                    let t58 = crank_0_omega * t57;
                    let b_1 = by(0.1).mul_add(
                        (-cos_crank_0_angle).mul_add(free_crank_0_angle, t58),
                        (-l_1_0).mul_add(b_0, free_crank_0_y),
                    );
                    let b_9 = (-l_9_1).mul_add(
                        b_1,
                        (-l_9_0).mul_add(b_0, by(3.6).mul_add((by(3.0) * t).sin(), free_crank_0_angle)),
                    );
                    let plate_omega = x[23];
                    let t59 = plate_omega * sin_plate_angle;
                    let t60 = plate_omega * cos_plate_angle;
                    let crank_0_vx = x[12];
                    let plate_vx = x[21];
                    let t61 = by(0.3).mul_add(t60, plate_vx);
                    let t62 = by(0.4) * t59;
                    let t63 = by(-1.6383040885779836).mul_add(t60, by(1.147152872702092) * t59)
                        * (by(-0.1).mul_add(t57, crank_0_vx) - t62 - t61);
                    let t64 = plate_omega * t60;
                    let t65 = plate_omega * t59;
                    let crank_0_vy = x[13];
                    let plate_vy = x[22];
                    let t66 = by(0.3).mul_add(t59, plate_vy);
                    let t67 = by(0.4) * t60;
                    let t68 = by(-1.147152872702092).mul_add(t60, by(-1.6383040885779836) * t59)
                        * (by(0.1).mul_add(t55, crank_0_vy) + t67 - t66);
                    let t69 = by(0.3) * t64;
                    let t70 = by(0.4) * t65;
                    let t71 = by(0.4) * t64;
                    let t72 = by(0.3) * t65;
                    let t73 = (-t13).mul_add(
                        by(0.8191520442889918).mul_add(t65, by(0.573576436351046) * t64),
                        t14.mul_add(by(-0.573576436351046).mul_add(t65, by(0.8191520442889918) * t64), -t63),
                    );
                    let t74 = (-l_6_1).mul_add(
                        b_1,
                        (-l_6_0).mul_add(
                            b_0,
                            t16.mul_add(free_plate_angle, (-t37).mul_add(free_crank_0_angle, t73 - t68)),
                        ),
                    );
                    let t75 = t5.mul_add(
                        free_plate_y - free_crank_0_y + (by(0.1).mul_add(t58, t69) + t70),
                        (-l_6_9).mul_add(b_9, t74),
                    );
                    let b_6 =
                        (-t4).mul_add(free_plate_x - free_crank_0_x + (by(0.1).mul_add(t56, t71) - t72), t75);
                    let crank_1_omega = x[17];
                    let t76 = crank_1_omega * cos_crank_1_angle;
                    let b_2 = by(0.1) * (crank_1_omega * t76);
                    let t77 = crank_1_omega * sin_crank_1_angle;
                    let t78 = by(0.1) * (crank_1_omega * t77);
                    let b_3 = (-l_3_2).mul_add(b_2, t78) - lit(9.81);
                    let b_10 = (-l_10_3).mul_add(b_3, (-l_10_2).mul_add(b_2, by(1.2) * (by(2.0) * t).cos()));
                    let crank_1_vx = x[15];
                    let t79 = by(1.532088886237956).mul_add(t60, by(1.2855752193730785) * t59)
                        * (by(-0.1).mul_add(t77, crank_1_vx + t62) - t61);
                    let crank_1_vy = x[16];
                    let t80 = by(-1.2855752193730785).mul_add(t60, by(1.532088886237956) * t59)
                        * (by(0.1).mul_add(t76, crank_1_vy - t67) - t66);
                    let t81 = (-t21).mul_add(
                        by(-0.766044443118978).mul_add(t65, by(0.6427876096865393) * t64),
                        by(-6.305746451024951)
                            .mul_add(sin_plate_angle, by(-7.514895986997175) * cos_plate_angle)
                            - t79,
                    );
                    let t82 = (-t24).mul_add(
                        free_plate_angle,
                        (-t23).mul_add(
                            by(0.6427876096865393).mul_add(t65, by(0.766044443118978) * t64),
                            t81 - t80,
                        ),
                    );
                    let t83 = (-l_7_10).mul_add(
                        b_10,
                        (-l_7_3).mul_add(b_3, (-l_7_2).mul_add(b_2, (-l_7_6).mul_add(b_6, t82))),
                    );
                    let b_7 = (-t17).mul_add(
                        free_plate_x + (b_2 - t71 - t72),
                        (-t18).mul_add(free_plate_y + (t69 - t70 + t78), t83),
                    );
                    let crank_2_omega = x[20];
                    let t84 = crank_2_omega * cos_crank_2_angle;
                    let b_4 = by(0.1) * (crank_2_omega * t84);
                    let t85 = crank_2_omega * sin_crank_2_angle;
                    let t86 = by(0.1) * (crank_2_omega * t85);
                    let b_5 = (-l_5_4).mul_add(b_4, t86) - lit(9.81);
                    let crank_2_vx = x[18];
                    let t87 = by(-0.1).mul_add(t85, crank_2_vx - plate_vx + t67)
                        * by(0.34729635533386066).mul_add(t60, by(1.969615506024416) * t59);
                    let crank_2_vy = x[19];
                    let t88 = by(0.1).mul_add(t84, crank_2_vy - plate_vy + t62)
                        * by(-1.969615506024416).mul_add(t60, by(0.34729635533386066) * t59);
                    let t89 = t29.mul_add(
                        by(0.984807753012208).mul_add(t65, by(0.17364817766693033) * t64),
                        t28.mul_add(by(-0.17364817766693033).mul_add(t65, by(0.984807753012208) * t64), t87)
                            + t88,
                    );
                    let t90 = l_8_4.mul_add(
                        b_4,
                        l_8_7.mul_add(b_7, l_8_6.mul_add(b_6, t30.mul_add(free_plate_angle, t89))),
                    );
                    let t91 = t25.mul_add(
                        free_plate_x + (t70 + b_4),
                        t26.mul_add(free_plate_y + (t86 - t71) + lit(9.81), l_8_5.mul_add(b_5, t90)),
                    );
                    let b_8 = -t91;
                    let b_11 = (-l_11_8).mul_add(
                        b_8,
                        (-l_11_5).mul_add(b_5, (-l_11_4).mul_add(b_4, by(3.2) * (by(4.0) * t).sin())),
                    );
                    let lambda_third = S::select(t54, lit(0.0), r_11) * b_11;
                    let lambda_slot_2_normal = (-l_11_8).mul_add(lambda_third, kept_8 * b_8);
                    let lambda_o_2_y =
                        (-l_11_5).mul_add(lambda_third, (-l_8_5).mul_add(lambda_slot_2_normal, kept_5 * b_5));
                    let lambda_o_2_x = (-l_11_4).mul_add(
                        lambda_third,
                        (-l_8_4).mul_add(lambda_slot_2_normal, (-l_5_4).mul_add(lambda_o_2_y, r_4 * b_4)),
                    );
                    let lambda_slot_1_normal = (-l_8_7).mul_add(lambda_slot_2_normal, kept_7 * b_7);
                    let lambda_second = (-l_7_10).mul_add(lambda_slot_1_normal, kept_10 * b_10);
                    let lambda_o_1_y = (-l_10_3)
                        .mul_add(lambda_second, (-l_7_3).mul_add(lambda_slot_1_normal, kept_3 * b_3));
                    let lambda_o_1_x = (-l_10_2).mul_add(
                        lambda_second,
                        (-l_7_2).mul_add(lambda_slot_1_normal, (-l_3_2).mul_add(lambda_o_1_y, r_2 * b_2)),
                    );
                    let lambda_slot_0_normal = (-l_8_6)
                        .mul_add(lambda_slot_2_normal, (-l_7_6).mul_add(lambda_slot_1_normal, kept_6 * b_6));
                    let lambda_first = (-l_6_9).mul_add(lambda_slot_0_normal, kept_9 * b_9);
                    let lambda_o_0_y =
                        (-l_9_1).mul_add(lambda_first, (-l_6_1).mul_add(lambda_slot_0_normal, kept_1 * b_1));
                    let lambda_o_0_x = (-l_9_0).mul_add(
                        lambda_first,
                        (-l_6_0).mul_add(lambda_slot_0_normal, (-l_1_0).mul_add(lambda_o_0_y, r_0 * b_0)),
                    );
                    // Results
                    dx[0] = crank_0_vx;
                    dx[1] = crank_0_vy;
                    dx[2] = crank_0_omega;
                    dx[3] = crank_1_vx;
                    dx[4] = crank_1_vy;
                    dx[5] = crank_1_omega;
                    dx[6] = crank_2_vx;
                    dx[7] = crank_2_vy;
                    dx[8] = crank_2_omega;
                    dx[9] = plate_vx;
                    dx[10] = plate_vy;
                    dx[11] = plate_omega;
                    dx[12] = (-y_6_0).mul_add(
                        lambda_slot_0_normal,
                        by(-3.3333333333333335).mul_add(lambda_o_0_x, free_crank_0_x),
                    );
                    dx[13] = (-y_6_1).mul_add(
                        lambda_slot_0_normal,
                        by(-3.3333333333333335).mul_add(lambda_o_0_y, free_crank_0_y),
                    );
                    let t92 = (-y_6_2).mul_add(
                        lambda_slot_0_normal,
                        (-y_1_2).mul_add(
                            lambda_o_0_y,
                            (-y_0_2)
                                .mul_add(lambda_o_0_x, by(-100.0).mul_add(lambda_first, free_crank_0_angle)),
                        ),
                    );
                    dx[14] = t92;
                    dx[15] = (-y_7_3).mul_add(lambda_slot_1_normal, by(-3.3333333333333335) * lambda_o_1_x);
                    dx[16] = (-y_7_4).mul_add(
                        lambda_slot_1_normal,
                        by(-3.3333333333333335).mul_add(lambda_o_1_y, lit(-9.81)),
                    );
                    dx[17] = (-y_7_5).mul_add(
                        lambda_slot_1_normal,
                        (-y_3_5).mul_add(
                            lambda_o_1_y,
                            (-y_2_5).mul_add(lambda_o_1_x, by(-100.0) * lambda_second),
                        ),
                    );
                    dx[18] = (-y_8_6).mul_add(lambda_slot_2_normal, by(-3.3333333333333335) * lambda_o_2_x);
                    dx[19] = (-y_8_7).mul_add(
                        lambda_slot_2_normal,
                        by(-3.3333333333333335).mul_add(lambda_o_2_y, lit(-9.81)),
                    );
                    dx[20] = (-y_8_8).mul_add(
                        lambda_slot_2_normal,
                        (-y_5_8)
                            .mul_add(lambda_o_2_y, (-y_4_8).mul_add(lambda_o_2_x, by(-100.0) * lambda_third)),
                    );
                    dx[21] = (-y_8_9).mul_add(
                        lambda_slot_2_normal,
                        (-y_7_9).mul_add(
                            lambda_slot_1_normal,
                            (-y_6_9).mul_add(lambda_slot_0_normal, free_plate_x),
                        ),
                    );
                    dx[22] = (-y_8_10).mul_add(
                        lambda_slot_2_normal,
                        (-y_7_10).mul_add(
                            lambda_slot_1_normal,
                            (-y_6_10).mul_add(lambda_slot_0_normal, free_plate_y),
                        ),
                    );
                    dx[23] = (-y_8_11).mul_add(
                        lambda_slot_2_normal,
                        (-y_7_11).mul_add(
                            lambda_slot_1_normal,
                            (-y_6_11).mul_add(lambda_slot_0_normal, free_plate_angle),
                        ),
                    );
                    lambda[0] = lambda_o_0_x;
                    lambda[1] = lambda_o_0_y;
                    lambda[2] = lambda_o_1_x;
                    lambda[3] = lambda_o_1_y;
                    lambda[4] = lambda_o_2_x;
                    lambda[5] = lambda_o_2_y;
                    lambda[6] = lambda_slot_0_normal;
                    lambda[7] = lambda_slot_1_normal;
                    lambda[8] = lambda_slot_2_normal;
                    lambda[9] = lambda_first;
                    lambda[10] = lambda_second;
                    lambda[11] = lambda_third;
                    let t93 = S::select(t35, lit(0.0), growth_1)
                        .max(S::select(t36, lit(0.0), growth_9))
                        .max(S::select(t40, lit(0.0), growth_6));
                    let t94 = t93
                        .max(S::select(t43, lit(0.0), growth_3))
                        .max(S::select(t44, lit(0.0), growth_10))
                        .max(S::select(t47, lit(0.0), growth_7));
                    let t95 = t94
                        .max(S::select(t50, lit(0.0), growth_5))
                        .max(S::select(t53, lit(0.0), growth_8))
                        .max(S::select(t54, lit(0.0), growth_11));
                    t95
                };
                by(1.0) / t95
            }

            /// Applied forces `Q` (N, N, N m per body) and `gamma`, for the rank-revealing solution.
            ///
            /// 90 add, 125 mul, 7 sin_cos.
            #[cold]
            fn free(&self, t: S, u: &Held<S>, x: &[S; 24], force: &mut [S; 12], gamma: &mut [S; 12]) {
                let lit = S::lit;
                let by = rt::Factor;
                let plate_angle = x[11];
                let crank_0_angle = x[2];
                let crank_1_angle = x[5];
                let crank_2_angle = x[8];
                let (
                    [sin_plate_angle, sin_crank_0_angle, sin_crank_1_angle, sin_crank_2_angle],
                    [cos_plate_angle, cos_crank_0_angle, cos_crank_1_angle, cos_crank_2_angle],
                ) = S::sin_cos_all([plate_angle, crank_0_angle, crank_1_angle, crank_2_angle]);
                let t1 =
                    by(-0.573576436351046).mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle);
                let crank_0_x = x[0];
                let plate_x = x[9];
                let t2 = by(0.4) * cos_plate_angle;
                let t3 = by(0.3) * sin_plate_angle;
                let t4 = t2 - t3;
                let t5 = by(0.1).mul_add(cos_crank_0_angle, crank_0_x) - plate_x + t4;
                let t6 =
                    by(0.8191520442889918).mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle);
                let crank_0_y = x[1];
                let plate_y = x[10];
                let t7 = by(0.3) * cos_plate_angle;
                let t8 = by(0.4) * sin_plate_angle;
                let t9 = t7 + t8;
                let t10 = by(0.1).mul_add(sin_crank_0_angle, crank_0_y) - plate_y + t9;
                let t11 = t6.mul_add(t10, t1 * t5);
                let t12 = t1 * t11;
                force[0] = by(-100.0) * t12;
                let t13 = by(100.0) * (t6 * t11);
                force[1] = lit(-2.943) - t13;
                force[2] = by(-10.0) * t11 * (-sin_crank_0_angle).mul_add(t1, cos_crank_0_angle * t6);
                force[3] = lit(0.0);
                force[4] = lit(-2.943);
                force[5] = lit(0.0);
                force[6] = lit(0.0);
                force[7] = lit(-2.943);
                force[8] = lit(0.0);
                force[9] = by(100.0) * t12;
                force[10] = t13 - lit(19.62);
                force[11] = by(-100.0) * t11 * (-t9).mul_add(t1, t4 * t6);
                let crank_0_omega = x[14];
                let t14 = crank_0_omega * cos_crank_0_angle;
                let t15 = crank_0_omega * t14;
                gamma[0] = by(-0.1) * t15;
                let t16 = crank_0_omega * sin_crank_0_angle;
                let t17 = crank_0_omega * t16;
                gamma[1] = by(-0.1) * t17;
                let crank_1_omega = x[17];
                let t18 = crank_1_omega * cos_crank_1_angle;
                let t19 = crank_1_omega * t18;
                gamma[2] = by(-0.1) * t19;
                let t20 = crank_1_omega * sin_crank_1_angle;
                let t21 = by(-0.1) * (crank_1_omega * t20);
                gamma[3] = t21;
                let crank_2_omega = x[20];
                let t22 = crank_2_omega * cos_crank_2_angle;
                let t23 = by(-0.1) * (crank_2_omega * t22);
                gamma[4] = t23;
                let t24 = crank_2_omega * sin_crank_2_angle;
                let t25 = crank_2_omega * t24;
                gamma[5] = by(-0.1) * t25;
                let plate_omega = x[23];
                let t26 = plate_omega * sin_plate_angle;
                let t27 = plate_omega * cos_plate_angle;
                let crank_0_vx = x[12];
                let plate_vx = x[21];
                let t28 = by(0.3).mul_add(t27, plate_vx);
                let t29 = by(0.4) * t26;
                let t30 = by(-1.6383040885779836).mul_add(t27, by(1.147152872702092) * t26)
                    * (by(-0.1).mul_add(t16, crank_0_vx) - t29 - t28);
                let t31 = plate_omega * t27;
                let t32 = plate_omega * t26;
                let crank_0_vy = x[13];
                let plate_vy = x[22];
                let t33 = by(0.3).mul_add(t26, plate_vy);
                let t34 = by(0.4) * t27;
                let t35 = by(-1.147152872702092).mul_add(t27, by(-1.6383040885779836) * t26)
                    * (by(0.1).mul_add(t14, crank_0_vy) + t34 - t33);
                let t36 = by(0.4) * t31;
                let t37 = by(0.3) * t32;
                let t38 = by(0.3) * t31;
                let t39 = by(0.4) * t32;
                let t40 = (-t10).mul_add(
                    by(-0.573576436351046).mul_add(t32, by(0.8191520442889918) * t31),
                    t5.mul_add(by(0.8191520442889918).mul_add(t32, by(0.573576436351046) * t31), t30) + t35,
                );
                let t41 = (-t1).mul_add(
                    by(0.1).mul_add(t17, t38) + t39,
                    t6.mul_add(by(0.1).mul_add(t15, t36) - t37, t40),
                );
                gamma[6] = t41;
                let crank_1_vx = x[15];
                let t42 = by(1.532088886237956).mul_add(t27, by(1.2855752193730785) * t26)
                    * (by(-0.1).mul_add(t20, crank_1_vx + t29) - t28);
                let crank_1_vy = x[16];
                let t43 = by(-1.2855752193730785).mul_add(t27, by(1.532088886237956) * t26)
                    * (by(0.1).mul_add(t18, crank_1_vy - t34) - t33);
                let crank_1_x = x[3];
                let t44 = (by(0.1).mul_add(cos_crank_1_angle, crank_1_x) - plate_x - t2 - t3)
                    * by(-0.766044443118978).mul_add(t32, by(0.6427876096865393) * t31);
                let crank_1_y = x[4];
                let t45 = (by(0.1).mul_add(sin_crank_1_angle, crank_1_y) - plate_y + t7 - t8)
                    * by(0.6427876096865393).mul_add(t32, by(0.766044443118978) * t31);
                let t46 = by(-0.766044443118978)
                    .mul_add(sin_plate_angle, by(0.6427876096865393) * cos_plate_angle)
                    .mul_add(by(0.1).mul_add(t19, -t36) - t37, t42 + t43 + t44);
                let t47 = by(0.6427876096865393)
                    .mul_add(sin_plate_angle, by(0.766044443118978) * cos_plate_angle)
                    .mul_add(t38 - t39 - t21, t46 + t45);
                gamma[7] = t47;
                let crank_2_vx = x[18];
                let t48 = by(-0.1).mul_add(t24, crank_2_vx - plate_vx + t34)
                    * by(0.34729635533386066).mul_add(t27, by(1.969615506024416) * t26);
                let crank_2_x = x[6];
                let t49 = (by(0.1).mul_add(cos_crank_2_angle, crank_2_x) - plate_x + t8)
                    * by(-0.17364817766693033).mul_add(t32, by(0.984807753012208) * t31);
                let crank_2_vy = x[19];
                let t50 = by(0.1).mul_add(t22, crank_2_vy - plate_vy + t29)
                    * by(-1.969615506024416).mul_add(t27, by(0.34729635533386066) * t26);
                let crank_2_y = x[7];
                let t51 = (by(0.1).mul_add(sin_crank_2_angle, crank_2_y) - plate_y - t2)
                    * by(0.984807753012208).mul_add(t32, by(0.17364817766693033) * t31);
                let t52 = by(-0.17364817766693033)
                    .mul_add(sin_plate_angle, by(0.984807753012208) * cos_plate_angle)
                    .mul_add(t39 - t23, t48 + t49 + t50 + t51);
                gamma[8] = by(0.984807753012208)
                    .mul_add(sin_plate_angle, by(0.17364817766693033) * cos_plate_angle)
                    .mul_add(by(0.1).mul_add(t25, -t36), t52);
                gamma[9] = by(-3.6) * (by(3.0) * t).sin();
                gamma[10] = by(-1.2) * (by(2.0) * t).cos();
                gamma[11] = by(-3.2) * (by(4.0) * t).sin();
            }
        }

        impl<S: Scalar> PlateOnThreePins<S> {
            /// The right-hand side in the coordinates .
            /// Returns the smallest square of a dyad's measure.
            ///
            /// 183 add, 273 mul, 7 div, 18 neg, 6 sin_cos, 4 select.
            #[inline(always)]
            fn motion_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 0, 4, 1, 4>,
                x: &[S; 0],
                dx: &mut [S; 0],
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                // Results
                let crank_0_angle = by(0.4) * (by(3.0) * t).sin();
                let (sin_crank_0_angle, cos_crank_0_angle) = crank_0_angle.sin_cos();
                let crank_1_angle = by(0.3) * (by(2.0) * t).cos();
                let (sin_crank_1_angle, cos_crank_1_angle) = crank_1_angle.sin_cos();
                let loop_0_x = by(0.2).mul_add(cos_crank_0_angle - cos_crank_1_angle, lit(-1.0));
                let last_cosine_3 = m.angles[3].cos;
                let last_0 = m.time.last;
                let since_remembered = t - last_0;
                let last_rate_3 = m.iterated[0].rate;
                let last_bend_3 = m.iterated[0].bend;
                let t1 = since_remembered * last_bend_3.mul_add(since_remembered, last_rate_3);
                let plate_angle_expected_tangent = t1 * (by(0.041666666666666664) * t1).mul_add(t1, lit(0.5));
                let plate_angle_expected_sine = by(2.0) * plate_angle_expected_tangent
                    / plate_angle_expected_tangent.mul_add(plate_angle_expected_tangent, lit(1.0));
                let last_sine_3 = m.angles[3].sin;
                let plate_angle_expected_cos = (-plate_angle_expected_sine)
                    .mul_add(last_cosine_3.mul_add(plate_angle_expected_tangent, last_sine_3), last_cosine_3);
                let plate_angle_expected_sin = plate_angle_expected_sine.mul_add(
                    (-last_sine_3).mul_add(plate_angle_expected_tangent, last_cosine_3),
                    last_sine_3,
                );
                let t2 = by(0.8191520442889918)
                    .mul_add(plate_angle_expected_sin, by(0.573576436351046) * plate_angle_expected_cos);
                let t3 = by(0.984807753012208)
                    .mul_add(plate_angle_expected_sin, by(0.17364817766693033) * plate_angle_expected_cos);
                let t4 = by(-0.573576436351046)
                    .mul_add(plate_angle_expected_sin, by(0.8191520442889918) * plate_angle_expected_cos);
                let t5 = by(-0.17364817766693033)
                    .mul_add(plate_angle_expected_sin, by(0.984807753012208) * plate_angle_expected_cos);
                let j0_0_across_1_1 = t4.mul_add(t5, t2 * t3);
                let last_value_4 = m.iterated[1].value;
                let last_rate_4 = m.iterated[1].rate;
                let last_bend_4 = m.iterated[1].bend;
                let slot_0_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_4.mul_add(since_remembered, last_rate_4), last_value_4);
                let last_value_5 = m.iterated[2].value;
                let last_rate_5 = m.iterated[2].rate;
                let last_bend_5 = m.iterated[2].bend;
                let slot_1_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_5.mul_add(since_remembered, last_rate_5), last_value_5);
                let t6 = by(0.8191520442889918) * slot_0_displacement_expected;
                let t7 = by(0.766044443118978).mul_add(slot_1_displacement_expected, t6) - lit(0.8);
                let t8 = by(0.573576436351046) * slot_0_displacement_expected;
                let t9 = by(-0.6427876096865393).mul_add(slot_1_displacement_expected, t8);
                let arm0_0_4_x = (-t7).mul_add(plate_angle_expected_cos, t9 * plate_angle_expected_sin);
                let t10 = by(0.6427876096865393)
                    .mul_add(plate_angle_expected_sin, by(0.766044443118978) * plate_angle_expected_cos);
                let arm0_0_4_y = -t9.mul_add(plate_angle_expected_cos, t7 * plate_angle_expected_sin);
                let t11 = by(-0.766044443118978)
                    .mul_add(plate_angle_expected_sin, by(0.6427876096865393) * plate_angle_expected_cos);
                let j0_0_across_0_0 = (-arm0_0_4_x).mul_add(t10, arm0_0_4_y * t11);
                let j0_0_across_0_1 = t4.mul_add(t11, t2 * t10);
                let last_value_6 = m.iterated[3].value;
                let last_rate_6 = m.iterated[3].rate;
                let last_bend_6 = m.iterated[3].bend;
                let slot_2_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_6.mul_add(since_remembered, last_rate_6), last_value_6);
                let t12 = by(0.17364817766693033).mul_add(slot_2_displacement_expected, t6) - lit(0.4);
                let t13 = by(-0.984807753012208).mul_add(slot_2_displacement_expected, t8) - lit(0.7);
                let arm0_1_4_x = (-t12).mul_add(plate_angle_expected_cos, t13 * plate_angle_expected_sin);
                let arm0_1_4_y = -t13.mul_add(plate_angle_expected_cos, t12 * plate_angle_expected_sin);
                let j0_0_across_1_0 = (-t3).mul_add(arm0_1_4_x, t5 * arm0_1_4_y);
                let j0_0_reciprocal =
                    by(1.0) / (-j0_0_across_0_1).mul_add(j0_0_across_1_0, j0_0_across_1_1 * j0_0_across_0_0);
                let j0_0_inverse_0_0 = j0_0_across_1_1 * j0_0_reciprocal;
                let loop_0_y = by(0.2) * (sin_crank_0_angle - sin_crank_1_angle);
                let gap0_0_y = loop_0_y + arm0_0_4_y;
                let gap0_0_x = loop_0_x + arm0_0_4_x;
                let j0_0_step_0_across_0 = -t11.mul_add(gap0_0_x, t10 * gap0_0_y);
                let j0_0_inverse_0_1 = -(j0_0_across_0_1 * j0_0_reciprocal);
                let crank_2_angle = by(0.2).mul_add((by(4.0) * t).sin(), lit(-0.1));
                let (sin_crank_2_angle, cos_crank_2_angle) = crank_2_angle.sin_cos();
                let loop_1_y = by(0.2).mul_add(sin_crank_0_angle - sin_crank_2_angle, lit(-0.9));
                let gap0_1_y = arm0_1_4_y + loop_1_y;
                let loop_1_x = by(0.2).mul_add(cos_crank_0_angle - cos_crank_2_angle, lit(-0.5));
                let gap0_1_x = arm0_1_4_x + loop_1_x;
                let j0_0_step_0_across_1 = -t5.mul_add(gap0_1_x, t3 * gap0_1_y);
                let j0_0_step_0_0 =
                    j0_0_inverse_0_1.mul_add(j0_0_step_0_across_1, j0_0_inverse_0_0 * j0_0_step_0_across_0);
                let plate_angle_0_tangent = by(-0.5) * j0_0_step_0_0;
                let plate_angle_0_sine = by(2.0) * plate_angle_0_tangent
                    / plate_angle_0_tangent.mul_add(plate_angle_0_tangent, lit(1.0));
                let plate_angle_0_cos = (-plate_angle_0_sine).mul_add(
                    plate_angle_expected_cos.mul_add(plate_angle_0_tangent, plate_angle_expected_sin),
                    plate_angle_expected_cos,
                );
                let plate_angle_0_sin = plate_angle_0_sine.mul_add(
                    (-plate_angle_expected_sin).mul_add(plate_angle_0_tangent, plate_angle_expected_cos),
                    plate_angle_expected_sin,
                );
                let j0_0_inverse_1_0 = -(j0_0_across_1_0 * j0_0_reciprocal);
                let j0_0_inverse_1_1 = j0_0_across_0_0 * j0_0_reciprocal;
                let j0_0_step_0_1 =
                    j0_0_step_0_across_1.mul_add(j0_0_inverse_1_1, j0_0_step_0_across_0 * j0_0_inverse_1_0);
                let slot_0_displacement_0 = slot_0_displacement_expected - j0_0_step_0_1;
                let j0_0_along_0_0 = by(1.0000000000000002) * arm0_0_4_x.mul_add(t11, t10 * arm0_0_4_y);
                let j0_0_along_0_1 = by(1.0000000000000002) * (-t2).mul_add(t11, t4 * t10);
                let j0_0_step_0_2 = (-j0_0_step_0_1).mul_add(
                    j0_0_along_0_1,
                    (-j0_0_step_0_0).mul_add(
                        j0_0_along_0_0,
                        by(-1.0000000000000002) * (-t11).mul_add(gap0_0_y, t10 * gap0_0_x),
                    ),
                );
                let slot_1_displacement_0 = slot_1_displacement_expected - j0_0_step_0_2;
                let t14 = by(0.8191520442889918) * slot_0_displacement_0;
                let t15 = by(0.766044443118978).mul_add(slot_1_displacement_0, t14) - lit(0.8);
                let t16 = by(0.573576436351046) * slot_0_displacement_0;
                let t17 = by(-0.6427876096865393).mul_add(slot_1_displacement_0, t16);
                let gap1_0_y = loop_0_y + -plate_angle_0_cos.mul_add(t17, plate_angle_0_sin * t15);
                let gap1_0_x = loop_0_x + (-plate_angle_0_cos).mul_add(t15, plate_angle_0_sin * t17);
                let j0_0_step_1_across_0 = -t11.mul_add(gap1_0_x, t10 * gap1_0_y);
                let j0_0_along_1_0 = by(1.0000000000000002) * t5.mul_add(arm0_1_4_x, t3 * arm0_1_4_y);
                let j0_0_along_1_1 = by(1.0000000000000002) * (-t2).mul_add(t5, t3 * t4);
                let j0_0_step_0_3 = (-j0_0_step_0_1).mul_add(
                    j0_0_along_1_1,
                    (-j0_0_step_0_0).mul_add(
                        j0_0_along_1_0,
                        by(-1.0000000000000002) * (-t5).mul_add(gap0_1_y, t3 * gap0_1_x),
                    ),
                );
                let slot_2_displacement_0 = slot_2_displacement_expected - j0_0_step_0_3;
                let t18 = by(0.17364817766693033).mul_add(slot_2_displacement_0, t14) - lit(0.4);
                let t19 = by(-0.984807753012208).mul_add(slot_2_displacement_0, t16) - lit(0.7);
                let gap1_1_y = loop_1_y + -plate_angle_0_cos.mul_add(t19, plate_angle_0_sin * t18);
                let gap1_1_x = loop_1_x + (-plate_angle_0_cos).mul_add(t18, plate_angle_0_sin * t19);
                let j0_0_step_1_across_1 = -t5.mul_add(gap1_1_x, t3 * gap1_1_y);
                let j0_0_step_1_0 =
                    j0_0_inverse_0_1.mul_add(j0_0_step_1_across_1, j0_0_inverse_0_0 * j0_0_step_1_across_0);
                let plate_angle_1_tangent = by(-0.5) * j0_0_step_1_0;
                let plate_angle_1_sine = by(2.0) * plate_angle_1_tangent
                    / plate_angle_1_tangent.mul_add(plate_angle_1_tangent, lit(1.0));
                let plate_angle_1_cos = (-plate_angle_1_sine).mul_add(
                    plate_angle_0_cos.mul_add(plate_angle_1_tangent, plate_angle_0_sin),
                    plate_angle_0_cos,
                );
                let plate_angle_1_sin = plate_angle_1_sine.mul_add(
                    (-plate_angle_0_sin).mul_add(plate_angle_1_tangent, plate_angle_0_cos),
                    plate_angle_0_sin,
                );
                let t20 = by(0.8191520442889918)
                    .mul_add(plate_angle_1_sin, by(0.573576436351046) * plate_angle_1_cos);
                let t21 = by(0.984807753012208)
                    .mul_add(plate_angle_1_sin, by(0.17364817766693033) * plate_angle_1_cos);
                let t22 = by(-0.573576436351046)
                    .mul_add(plate_angle_1_sin, by(0.8191520442889918) * plate_angle_1_cos);
                let t23 = by(-0.17364817766693033)
                    .mul_add(plate_angle_1_sin, by(0.984807753012208) * plate_angle_1_cos);
                let j2_0_across_1_1 = t22.mul_add(t23, t20 * t21);
                let j0_0_step_1_1 =
                    j0_0_inverse_1_1.mul_add(j0_0_step_1_across_1, j0_0_inverse_1_0 * j0_0_step_1_across_0);
                let slot_0_displacement_1 = slot_0_displacement_0 - j0_0_step_1_1;
                let j0_0_step_1_2 = (-j0_0_along_0_1).mul_add(
                    j0_0_step_1_1,
                    (-j0_0_along_0_0).mul_add(
                        j0_0_step_1_0,
                        by(-1.0000000000000002) * (-t11).mul_add(gap1_0_y, t10 * gap1_0_x),
                    ),
                );
                let slot_1_displacement_1 = slot_1_displacement_0 - j0_0_step_1_2;
                let t24 = by(0.8191520442889918) * slot_0_displacement_1;
                let t25 = by(0.766044443118978).mul_add(slot_1_displacement_1, t24) - lit(0.8);
                let t26 = by(0.573576436351046) * slot_0_displacement_1;
                let t27 = by(-0.6427876096865393).mul_add(slot_1_displacement_1, t26);
                let arm2_0_4_x = (-plate_angle_1_cos).mul_add(t25, plate_angle_1_sin * t27);
                let t28 = by(0.6427876096865393)
                    .mul_add(plate_angle_1_sin, by(0.766044443118978) * plate_angle_1_cos);
                let arm2_0_4_y = -plate_angle_1_cos.mul_add(t27, plate_angle_1_sin * t25);
                let t29 = by(-0.766044443118978)
                    .mul_add(plate_angle_1_sin, by(0.6427876096865393) * plate_angle_1_cos);
                let j2_0_across_0_0 = (-arm2_0_4_x).mul_add(t28, arm2_0_4_y * t29);
                let j2_0_across_0_1 = t22.mul_add(t29, t20 * t28);
                let j0_0_step_1_3 = (-j0_0_along_1_1).mul_add(
                    j0_0_step_1_1,
                    (-j0_0_along_1_0).mul_add(
                        j0_0_step_1_0,
                        by(-1.0000000000000002) * (-t5).mul_add(gap1_1_y, t3 * gap1_1_x),
                    ),
                );
                let slot_2_displacement_1 = slot_2_displacement_0 - j0_0_step_1_3;
                let t30 = by(0.17364817766693033).mul_add(slot_2_displacement_1, t24) - lit(0.4);
                let t31 = by(-0.984807753012208).mul_add(slot_2_displacement_1, t26) - lit(0.7);
                let arm2_1_4_x = (-plate_angle_1_cos).mul_add(t30, plate_angle_1_sin * t31);
                let arm2_1_4_y = -plate_angle_1_cos.mul_add(t31, plate_angle_1_sin * t30);
                let j2_0_across_1_0 = (-t21).mul_add(arm2_1_4_x, t23 * arm2_1_4_y);
                let j2_0_reciprocal =
                    by(1.0) / (-j2_0_across_0_1).mul_add(j2_0_across_1_0, j2_0_across_1_1 * j2_0_across_0_0);
                let gap2_0_y = loop_0_y + arm2_0_4_y;
                let gap2_0_x = loop_0_x + arm2_0_4_x;
                let j2_0_step_2_across_0 = -t29.mul_add(gap2_0_x, t28 * gap2_0_y);
                let gap2_1_y = loop_1_y + arm2_1_4_y;
                let gap2_1_x = loop_1_x + arm2_1_4_x;
                let j2_0_step_2_across_1 = -t23.mul_add(gap2_1_x, t21 * gap2_1_y);
                let j2_0_step_2_0 = (-(j2_0_across_0_1 * j2_0_reciprocal))
                    .mul_add(j2_0_step_2_across_1, j2_0_across_1_1 * j2_0_reciprocal * j2_0_step_2_across_0);
                let plate_angle_2_tangent = by(-0.5) * j2_0_step_2_0;
                let plate_angle_2_sine = by(2.0) * plate_angle_2_tangent
                    / plate_angle_2_tangent.mul_add(plate_angle_2_tangent, lit(1.0));
                let plate_angle_2_cos = (-plate_angle_2_sine).mul_add(
                    plate_angle_1_cos.mul_add(plate_angle_2_tangent, plate_angle_1_sin),
                    plate_angle_1_cos,
                );
                let j2_0_step_2_1 = j2_0_step_2_across_1.mul_add(
                    j2_0_across_0_0 * j2_0_reciprocal,
                    j2_0_step_2_across_0 * -(j2_0_across_1_0 * j2_0_reciprocal),
                );
                let slot_0_displacement_2 = slot_0_displacement_1 - j2_0_step_2_1;
                let t32 = (-j2_0_step_2_0).mul_add(
                    by(1.0000000000000002) * arm2_0_4_x.mul_add(t29, t28 * arm2_0_4_y),
                    by(-1.0000000000000002) * (-t29).mul_add(gap2_0_y, t28 * gap2_0_x),
                );
                let slot_1_displacement_2 = slot_1_displacement_1
                    - (-j2_0_step_2_1).mul_add(by(1.0000000000000002) * (-t20).mul_add(t29, t22 * t28), t32);
                let t33 = by(0.8191520442889918) * slot_0_displacement_2;
                let t34 = by(0.766044443118978).mul_add(slot_1_displacement_2, t33) - lit(0.8);
                let plate_angle_2_sin = plate_angle_2_sine.mul_add(
                    (-plate_angle_1_sin).mul_add(plate_angle_2_tangent, plate_angle_1_cos),
                    plate_angle_1_sin,
                );
                let t35 = by(0.573576436351046) * slot_0_displacement_2;
                let t36 = by(-0.6427876096865393).mul_add(slot_1_displacement_2, t35);
                let arm_0_4_x = (-plate_angle_2_cos).mul_add(t34, plate_angle_2_sin * t36);
                let gap_0_x = loop_0_x + arm_0_4_x;
                let arm_0_4_y = -plate_angle_2_cos.mul_add(t36, t34 * plate_angle_2_sin);
                let gap_0_y = loop_0_y + arm_0_4_y;
                let t37 = (-j2_0_step_2_0).mul_add(
                    by(1.0000000000000002) * t23.mul_add(arm2_1_4_x, t21 * arm2_1_4_y),
                    by(-1.0000000000000002) * (-t23).mul_add(gap2_1_y, t21 * gap2_1_x),
                );
                let slot_2_displacement_2 = slot_2_displacement_1
                    - (-j2_0_step_2_1).mul_add(by(1.0000000000000002) * (-t20).mul_add(t23, t21 * t22), t37);
                let t38 = by(0.17364817766693033).mul_add(slot_2_displacement_2, t33) - lit(0.4);
                let t39 = by(-0.984807753012208).mul_add(slot_2_displacement_2, t35) - lit(0.7);
                let arm_1_4_x = (-plate_angle_2_cos).mul_add(t38, plate_angle_2_sin * t39);
                let gap_1_x = loop_1_x + arm_1_4_x;
                let arm_1_4_y = -plate_angle_2_cos.mul_add(t39, plate_angle_2_sin * t38);
                let gap_1_y = loop_1_y + arm_1_4_y;
                let precision = lit(S::PRECISION);
                let t40 = gap_1_y
                    .mul_add(gap_1_y, gap_1_x.mul_add(gap_1_x, gap_0_y.mul_add(gap_0_y, gap_0_x * gap_0_x)))
                    .lt(by(2684354.5600000005) * precision * precision);
                let t41 = by(0.8191520442889918)
                    .mul_add(plate_angle_2_sin, by(0.573576436351046) * plate_angle_2_cos);
                let t42 = by(0.984807753012208)
                    .mul_add(plate_angle_2_sin, by(0.17364817766693033) * plate_angle_2_cos);
                let t43 = by(-0.573576436351046)
                    .mul_add(plate_angle_2_sin, by(0.8191520442889918) * plate_angle_2_cos);
                let t44 = by(-0.17364817766693033)
                    .mul_add(plate_angle_2_sin, by(0.984807753012208) * plate_angle_2_cos);
                let j_0_across_1_1 = t43.mul_add(t44, t41 * t42);
                let t45 = by(0.6427876096865393)
                    .mul_add(plate_angle_2_sin, by(0.766044443118978) * plate_angle_2_cos);
                let t46 = by(-0.766044443118978)
                    .mul_add(plate_angle_2_sin, by(0.6427876096865393) * plate_angle_2_cos);
                let j_0_across_0_1 = t43.mul_add(t46, t41 * t45);
                let j_0_across_1_0 = (-arm_1_4_x).mul_add(t42, arm_1_4_y * t44);
                let j_0_across_0_0 = (-arm_0_4_x).mul_add(t45, arm_0_4_y * t46);
                let t47 = by(1.9999999999999996).mul_add(
                    j_0_across_0_0.mul_add(j_0_across_0_0, j_0_across_1_0 * j_0_across_1_0),
                    by(0.32) * j_0_across_0_1.mul_add(j_0_across_0_1, j_0_across_1_1 * j_0_across_1_1),
                );
                let j_0_determinant =
                    (-j_0_across_0_1).mul_add(j_0_across_1_0, j_0_across_1_1 * j_0_across_0_0);
                let t48 = S::select(
                    t40,
                    S::select(lit(0.0).lt(t47), by(2.0) * j_0_determinant * j_0_determinant / t47, lit(0.0)),
                    lit(-1.0),
                );
                t48
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            ///
            /// 212 add, 330 mul, 8 div, 21 neg, 6 sin_cos, 4 select, 1 other.
            fn pose_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 0, 4, 1, 4>,
                x: &[S; 0],
                q: &mut [S; 12],
                v: &mut [S; 12],
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let t1 = by(3.0) * t;
                let (sin_t1, cos_t1) = t1.sin_cos();
                let crank_0_angle = by(0.4) * sin_t1;
                let (sin_crank_0_angle, cos_crank_0_angle) = crank_0_angle.sin_cos();
                let crank_0_x = by(0.1) * cos_crank_0_angle;
                q[0] = crank_0_x;
                let crank_0_y = by(0.1) * sin_crank_0_angle;
                q[1] = crank_0_y;
                q[2] = crank_0_angle;
                let t2 = by(2.0) * t;
                let (sin_t2, cos_t2) = t2.sin_cos();
                let crank_1_angle = by(0.3) * cos_t2;
                let (sin_crank_1_angle, cos_crank_1_angle) = crank_1_angle.sin_cos();
                let t3 = by(0.1) * cos_crank_1_angle;
                q[3] = t3 + lit(1.0);
                q[4] = by(0.1) * sin_crank_1_angle;
                q[5] = crank_1_angle;
                let t4 = by(4.0) * t;
                let (sin_t4, cos_t4) = t4.sin_cos();
                let crank_2_angle = by(0.2).mul_add(sin_t4, lit(-0.1));
                let (sin_crank_2_angle, cos_crank_2_angle) = crank_2_angle.sin_cos();
                let t5 = by(0.1) * cos_crank_2_angle;
                q[6] = t5 + lit(0.5);
                q[7] = by(0.1).mul_add(sin_crank_2_angle, lit(0.9));
                q[8] = crank_2_angle;
                let last_cosine_3 = m.angles[3].cos;
                let last_0 = m.time.last;
                let since_remembered = t - last_0;
                let last_rate_3 = m.iterated[0].rate;
                let last_bend_3 = m.iterated[0].bend;
                let t6 = since_remembered * last_bend_3.mul_add(since_remembered, last_rate_3);
                let plate_angle_expected_tangent = t6 * (by(0.041666666666666664) * t6).mul_add(t6, lit(0.5));
                let plate_angle_expected_sine = by(2.0) * plate_angle_expected_tangent
                    / plate_angle_expected_tangent.mul_add(plate_angle_expected_tangent, lit(1.0));
                let last_sine_3 = m.angles[3].sin;
                let plate_angle_expected_cos = (-plate_angle_expected_sine)
                    .mul_add(last_cosine_3.mul_add(plate_angle_expected_tangent, last_sine_3), last_cosine_3);
                let plate_angle_expected_sin = plate_angle_expected_sine.mul_add(
                    (-last_sine_3).mul_add(plate_angle_expected_tangent, last_cosine_3),
                    last_sine_3,
                );
                let t7 = by(0.8191520442889918)
                    .mul_add(plate_angle_expected_sin, by(0.573576436351046) * plate_angle_expected_cos);
                let t8 = by(0.984807753012208)
                    .mul_add(plate_angle_expected_sin, by(0.17364817766693033) * plate_angle_expected_cos);
                let t9 = by(-0.573576436351046)
                    .mul_add(plate_angle_expected_sin, by(0.8191520442889918) * plate_angle_expected_cos);
                let t10 = by(-0.17364817766693033)
                    .mul_add(plate_angle_expected_sin, by(0.984807753012208) * plate_angle_expected_cos);
                let j0_0_across_1_1 = t9.mul_add(t10, t7 * t8);
                let last_value_4 = m.iterated[1].value;
                let last_rate_4 = m.iterated[1].rate;
                let last_bend_4 = m.iterated[1].bend;
                let slot_0_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_4.mul_add(since_remembered, last_rate_4), last_value_4);
                let last_value_5 = m.iterated[2].value;
                let last_rate_5 = m.iterated[2].rate;
                let last_bend_5 = m.iterated[2].bend;
                let slot_1_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_5.mul_add(since_remembered, last_rate_5), last_value_5);
                let t11 = by(0.8191520442889918) * slot_0_displacement_expected;
                let t12 = by(0.766044443118978).mul_add(slot_1_displacement_expected, t11) - lit(0.8);
                let t13 = by(0.573576436351046) * slot_0_displacement_expected;
                let t14 = by(-0.6427876096865393).mul_add(slot_1_displacement_expected, t13);
                let arm0_0_4_x = (-t12).mul_add(plate_angle_expected_cos, t14 * plate_angle_expected_sin);
                let t15 = by(0.6427876096865393)
                    .mul_add(plate_angle_expected_sin, by(0.766044443118978) * plate_angle_expected_cos);
                let arm0_0_4_y = -t14.mul_add(plate_angle_expected_cos, t12 * plate_angle_expected_sin);
                let t16 = by(-0.766044443118978)
                    .mul_add(plate_angle_expected_sin, by(0.6427876096865393) * plate_angle_expected_cos);
                let j0_0_across_0_0 = (-arm0_0_4_x).mul_add(t15, arm0_0_4_y * t16);
                let j0_0_across_0_1 = t9.mul_add(t16, t7 * t15);
                let last_value_6 = m.iterated[3].value;
                let last_rate_6 = m.iterated[3].rate;
                let last_bend_6 = m.iterated[3].bend;
                let slot_2_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_6.mul_add(since_remembered, last_rate_6), last_value_6);
                let t17 = by(0.17364817766693033).mul_add(slot_2_displacement_expected, t11) - lit(0.4);
                let t18 = by(-0.984807753012208).mul_add(slot_2_displacement_expected, t13) - lit(0.7);
                let arm0_1_4_x = (-t17).mul_add(plate_angle_expected_cos, t18 * plate_angle_expected_sin);
                let arm0_1_4_y = -t18.mul_add(plate_angle_expected_cos, t17 * plate_angle_expected_sin);
                let j0_0_across_1_0 = (-t8).mul_add(arm0_1_4_x, t10 * arm0_1_4_y);
                let j0_0_reciprocal =
                    by(1.0) / (-j0_0_across_0_1).mul_add(j0_0_across_1_0, j0_0_across_1_1 * j0_0_across_0_0);
                let j0_0_inverse_0_0 = j0_0_across_1_1 * j0_0_reciprocal;
                let loop_0_y = by(0.2) * (sin_crank_0_angle - sin_crank_1_angle);
                let gap0_0_y = loop_0_y + arm0_0_4_y;
                let loop_0_x = by(0.2).mul_add(cos_crank_0_angle - cos_crank_1_angle, lit(-1.0));
                let gap0_0_x = loop_0_x + arm0_0_4_x;
                let j0_0_step_0_across_0 = -t16.mul_add(gap0_0_x, t15 * gap0_0_y);
                let j0_0_inverse_0_1 = -(j0_0_across_0_1 * j0_0_reciprocal);
                let loop_1_y = by(0.2).mul_add(sin_crank_0_angle - sin_crank_2_angle, lit(-0.9));
                let gap0_1_y = arm0_1_4_y + loop_1_y;
                let loop_1_x = by(0.2).mul_add(cos_crank_0_angle - cos_crank_2_angle, lit(-0.5));
                let gap0_1_x = arm0_1_4_x + loop_1_x;
                let j0_0_step_0_across_1 = -t10.mul_add(gap0_1_x, t8 * gap0_1_y);
                let j0_0_step_0_0 =
                    j0_0_inverse_0_1.mul_add(j0_0_step_0_across_1, j0_0_inverse_0_0 * j0_0_step_0_across_0);
                let plate_angle_0_tangent = by(-0.5) * j0_0_step_0_0;
                let plate_angle_0_sine = by(2.0) * plate_angle_0_tangent
                    / plate_angle_0_tangent.mul_add(plate_angle_0_tangent, lit(1.0));
                let plate_angle_0_cos = (-plate_angle_0_sine).mul_add(
                    plate_angle_expected_cos.mul_add(plate_angle_0_tangent, plate_angle_expected_sin),
                    plate_angle_expected_cos,
                );
                let plate_angle_0_sin = plate_angle_0_sine.mul_add(
                    (-plate_angle_expected_sin).mul_add(plate_angle_0_tangent, plate_angle_expected_cos),
                    plate_angle_expected_sin,
                );
                let j0_0_inverse_1_0 = -(j0_0_across_1_0 * j0_0_reciprocal);
                let j0_0_inverse_1_1 = j0_0_across_0_0 * j0_0_reciprocal;
                let j0_0_step_0_1 =
                    j0_0_step_0_across_1.mul_add(j0_0_inverse_1_1, j0_0_step_0_across_0 * j0_0_inverse_1_0);
                let slot_0_displacement_0 = slot_0_displacement_expected - j0_0_step_0_1;
                let j0_0_along_0_0 = by(1.0000000000000002) * arm0_0_4_x.mul_add(t16, t15 * arm0_0_4_y);
                let j0_0_along_0_1 = by(1.0000000000000002) * (-t7).mul_add(t16, t9 * t15);
                let j0_0_step_0_2 = (-j0_0_step_0_1).mul_add(
                    j0_0_along_0_1,
                    (-j0_0_step_0_0).mul_add(
                        j0_0_along_0_0,
                        by(-1.0000000000000002) * (-t16).mul_add(gap0_0_y, t15 * gap0_0_x),
                    ),
                );
                let slot_1_displacement_0 = slot_1_displacement_expected - j0_0_step_0_2;
                let t19 = by(0.8191520442889918) * slot_0_displacement_0;
                let t20 = by(0.766044443118978).mul_add(slot_1_displacement_0, t19) - lit(0.8);
                let t21 = by(0.573576436351046) * slot_0_displacement_0;
                let t22 = by(-0.6427876096865393).mul_add(slot_1_displacement_0, t21);
                let gap1_0_y = loop_0_y + -plate_angle_0_cos.mul_add(t22, plate_angle_0_sin * t20);
                let gap1_0_x = loop_0_x + (-plate_angle_0_cos).mul_add(t20, plate_angle_0_sin * t22);
                let j0_0_step_1_across_0 = -t16.mul_add(gap1_0_x, t15 * gap1_0_y);
                let j0_0_along_1_0 = by(1.0000000000000002) * t10.mul_add(arm0_1_4_x, t8 * arm0_1_4_y);
                let j0_0_along_1_1 = by(1.0000000000000002) * (-t7).mul_add(t10, t8 * t9);
                let j0_0_step_0_3 = (-j0_0_step_0_1).mul_add(
                    j0_0_along_1_1,
                    (-j0_0_step_0_0).mul_add(
                        j0_0_along_1_0,
                        by(-1.0000000000000002) * (-t10).mul_add(gap0_1_y, t8 * gap0_1_x),
                    ),
                );
                let slot_2_displacement_0 = slot_2_displacement_expected - j0_0_step_0_3;
                let t23 = by(0.17364817766693033).mul_add(slot_2_displacement_0, t19) - lit(0.4);
                let t24 = by(-0.984807753012208).mul_add(slot_2_displacement_0, t21) - lit(0.7);
                let gap1_1_y = loop_1_y + -plate_angle_0_cos.mul_add(t24, plate_angle_0_sin * t23);
                let gap1_1_x = loop_1_x + (-plate_angle_0_cos).mul_add(t23, plate_angle_0_sin * t24);
                let j0_0_step_1_across_1 = -t10.mul_add(gap1_1_x, t8 * gap1_1_y);
                let j0_0_step_1_0 =
                    j0_0_inverse_0_1.mul_add(j0_0_step_1_across_1, j0_0_inverse_0_0 * j0_0_step_1_across_0);
                let plate_angle_1_tangent = by(-0.5) * j0_0_step_1_0;
                let plate_angle_1_sine = by(2.0) * plate_angle_1_tangent
                    / plate_angle_1_tangent.mul_add(plate_angle_1_tangent, lit(1.0));
                let plate_angle_1_cos = (-plate_angle_1_sine).mul_add(
                    plate_angle_0_cos.mul_add(plate_angle_1_tangent, plate_angle_0_sin),
                    plate_angle_0_cos,
                );
                let plate_angle_1_sin = plate_angle_1_sine.mul_add(
                    (-plate_angle_0_sin).mul_add(plate_angle_1_tangent, plate_angle_0_cos),
                    plate_angle_0_sin,
                );
                let t25 = by(0.8191520442889918)
                    .mul_add(plate_angle_1_sin, by(0.573576436351046) * plate_angle_1_cos);
                let t26 = by(0.984807753012208)
                    .mul_add(plate_angle_1_sin, by(0.17364817766693033) * plate_angle_1_cos);
                let t27 = by(-0.573576436351046)
                    .mul_add(plate_angle_1_sin, by(0.8191520442889918) * plate_angle_1_cos);
                let t28 = by(-0.17364817766693033)
                    .mul_add(plate_angle_1_sin, by(0.984807753012208) * plate_angle_1_cos);
                let j2_0_across_1_1 = t27.mul_add(t28, t25 * t26);
                let j0_0_step_1_1 =
                    j0_0_inverse_1_1.mul_add(j0_0_step_1_across_1, j0_0_inverse_1_0 * j0_0_step_1_across_0);
                let slot_0_displacement_1 = slot_0_displacement_0 - j0_0_step_1_1;
                let j0_0_step_1_2 = (-j0_0_along_0_1).mul_add(
                    j0_0_step_1_1,
                    (-j0_0_along_0_0).mul_add(
                        j0_0_step_1_0,
                        by(-1.0000000000000002) * (-t16).mul_add(gap1_0_y, t15 * gap1_0_x),
                    ),
                );
                let slot_1_displacement_1 = slot_1_displacement_0 - j0_0_step_1_2;
                let t29 = by(0.8191520442889918) * slot_0_displacement_1;
                let t30 = by(0.766044443118978).mul_add(slot_1_displacement_1, t29) - lit(0.8);
                let t31 = by(0.573576436351046) * slot_0_displacement_1;
                let t32 = by(-0.6427876096865393).mul_add(slot_1_displacement_1, t31);
                let arm2_0_4_x = (-plate_angle_1_cos).mul_add(t30, plate_angle_1_sin * t32);
                let t33 = by(0.6427876096865393)
                    .mul_add(plate_angle_1_sin, by(0.766044443118978) * plate_angle_1_cos);
                let arm2_0_4_y = -plate_angle_1_cos.mul_add(t32, plate_angle_1_sin * t30);
                let t34 = by(-0.766044443118978)
                    .mul_add(plate_angle_1_sin, by(0.6427876096865393) * plate_angle_1_cos);
                let j2_0_across_0_0 = (-arm2_0_4_x).mul_add(t33, arm2_0_4_y * t34);
                let j2_0_across_0_1 = t27.mul_add(t34, t25 * t33);
                let j0_0_step_1_3 = (-j0_0_along_1_1).mul_add(
                    j0_0_step_1_1,
                    (-j0_0_along_1_0).mul_add(
                        j0_0_step_1_0,
                        by(-1.0000000000000002) * (-t10).mul_add(gap1_1_y, t8 * gap1_1_x),
                    ),
                );
                let slot_2_displacement_1 = slot_2_displacement_0 - j0_0_step_1_3;
                let t35 = by(0.17364817766693033).mul_add(slot_2_displacement_1, t29) - lit(0.4);
                let t36 = by(-0.984807753012208).mul_add(slot_2_displacement_1, t31) - lit(0.7);
                let arm2_1_4_x = (-plate_angle_1_cos).mul_add(t35, plate_angle_1_sin * t36);
                let arm2_1_4_y = -plate_angle_1_cos.mul_add(t36, plate_angle_1_sin * t35);
                let j2_0_across_1_0 = (-t26).mul_add(arm2_1_4_x, t28 * arm2_1_4_y);
                let j2_0_reciprocal =
                    by(1.0) / (-j2_0_across_0_1).mul_add(j2_0_across_1_0, j2_0_across_1_1 * j2_0_across_0_0);
                let gap2_0_y = loop_0_y + arm2_0_4_y;
                let gap2_0_x = loop_0_x + arm2_0_4_x;
                let j2_0_step_2_across_0 = -t34.mul_add(gap2_0_x, t33 * gap2_0_y);
                let gap2_1_y = loop_1_y + arm2_1_4_y;
                let gap2_1_x = loop_1_x + arm2_1_4_x;
                let j2_0_step_2_across_1 = -t28.mul_add(gap2_1_x, t26 * gap2_1_y);
                let j2_0_step_2_0 = (-(j2_0_across_0_1 * j2_0_reciprocal))
                    .mul_add(j2_0_step_2_across_1, j2_0_across_1_1 * j2_0_reciprocal * j2_0_step_2_across_0);
                let plate_angle_2_tangent = by(-0.5) * j2_0_step_2_0;
                let plate_angle_2_sine = by(2.0) * plate_angle_2_tangent
                    / plate_angle_2_tangent.mul_add(plate_angle_2_tangent, lit(1.0));
                let plate_angle_2_cos = (-plate_angle_2_sine).mul_add(
                    plate_angle_1_cos.mul_add(plate_angle_2_tangent, plate_angle_1_sin),
                    plate_angle_1_cos,
                );
                let j2_0_step_2_1 = j2_0_step_2_across_1.mul_add(
                    j2_0_across_0_0 * j2_0_reciprocal,
                    j2_0_step_2_across_0 * -(j2_0_across_1_0 * j2_0_reciprocal),
                );
                let slot_0_displacement_2 = slot_0_displacement_1 - j2_0_step_2_1;
                let t37 = by(0.8191520442889918) * slot_0_displacement_2;
                let t38 = t37 - lit(0.4);
                let plate_angle_2_sin = plate_angle_2_sine.mul_add(
                    (-plate_angle_1_sin).mul_add(plate_angle_2_tangent, plate_angle_1_cos),
                    plate_angle_1_sin,
                );
                let t39 = by(0.573576436351046) * slot_0_displacement_2;
                let t40 = t39 - lit(0.3);
                let t41 = (-plate_angle_2_sin).mul_add(t40, plate_angle_2_cos * t38);
                q[9] = crank_0_x + crank_0_x - t41;
                let t42 = plate_angle_2_cos.mul_add(t40, plate_angle_2_sin * t38);
                q[10] = crank_0_y + crank_0_y - t42;
                let last_angle_3 = m.angles[3].angle;
                let t43 = last_angle_3
                    + (-last_sine_3)
                        .mul_add(plate_angle_2_cos, last_cosine_3 * plate_angle_2_sin)
                        .atan2(last_sine_3.mul_add(plate_angle_2_sin, last_cosine_3 * plate_angle_2_cos));
                q[11] = t43;
                let crank_0_angle_rate = by(1.2) * cos_t1;
                let crank_0_vx = by(-0.1) * (sin_crank_0_angle * crank_0_angle_rate);
                v[0] = crank_0_vx;
                let crank_0_vy = by(0.1) * (cos_crank_0_angle * crank_0_angle_rate);
                v[1] = crank_0_vy;
                v[2] = crank_0_angle_rate;
                let crank_1_angle_rate = by(-0.6) * sin_t2;
                v[3] = by(-0.1) * sin_crank_1_angle * crank_1_angle_rate;
                v[4] = t3 * crank_1_angle_rate;
                v[5] = crank_1_angle_rate;
                let crank_2_angle_rate = by(0.8) * cos_t4;
                v[6] = by(-0.1) * sin_crank_2_angle * crank_2_angle_rate;
                v[7] = t5 * crank_2_angle_rate;
                v[8] = crank_2_angle_rate;
                let t44 = by(0.24) * (cos_t1 * cos_crank_0_angle);
                let t45 = by(0.12) * sin_t2;
                let t46 = by(0.6427876096865393)
                    .mul_add(plate_angle_2_sin, by(0.766044443118978) * plate_angle_2_cos);
                let t47 = by(0.24) * (cos_t1 * sin_crank_0_angle);
                let t48 = by(-0.766044443118978)
                    .mul_add(plate_angle_2_sin, by(0.6427876096865393) * plate_angle_2_cos);
                let j_0_time_rate_across_0 = (-t45.mul_add(cos_crank_1_angle, t44))
                    .mul_add(t46, t45.mul_add(sin_crank_1_angle, t47) * t48);
                let t49 = by(0.984807753012208)
                    .mul_add(plate_angle_2_sin, by(0.17364817766693033) * plate_angle_2_cos);
                let t50 = (-j2_0_step_2_0).mul_add(
                    by(1.0000000000000002) * t28.mul_add(arm2_1_4_x, t26 * arm2_1_4_y),
                    by(-1.0000000000000002) * (-t28).mul_add(gap2_1_y, t26 * gap2_1_x),
                );
                let slot_2_displacement_2 = slot_2_displacement_1
                    - (-j2_0_step_2_1).mul_add(by(1.0000000000000002) * (-t25).mul_add(t28, t26 * t27), t50);
                let t51 = by(-0.984807753012208).mul_add(slot_2_displacement_2, t39) - lit(0.7);
                let t52 = by(0.17364817766693033).mul_add(slot_2_displacement_2, t38);
                let arm_1_4_x = (-plate_angle_2_cos).mul_add(t52, plate_angle_2_sin * t51);
                let t53 = by(-0.17364817766693033)
                    .mul_add(plate_angle_2_sin, by(0.984807753012208) * plate_angle_2_cos);
                let arm_1_4_y = -plate_angle_2_sin.mul_add(t52, plate_angle_2_cos * t51);
                let j_0_across_1_0 = (-t49).mul_add(arm_1_4_x, t53 * arm_1_4_y);
                let t54 = by(0.8191520442889918)
                    .mul_add(plate_angle_2_sin, by(0.573576436351046) * plate_angle_2_cos);
                let t55 = by(-0.573576436351046)
                    .mul_add(plate_angle_2_sin, by(0.8191520442889918) * plate_angle_2_cos);
                let j_0_across_1_1 = t55.mul_add(t53, t54 * t49);
                let t56 = (-j2_0_step_2_0).mul_add(
                    by(1.0000000000000002) * arm2_0_4_x.mul_add(t34, t33 * arm2_0_4_y),
                    by(-1.0000000000000002) * (-t34).mul_add(gap2_0_y, t33 * gap2_0_x),
                );
                let slot_1_displacement_2 = slot_1_displacement_1
                    - (-j2_0_step_2_1).mul_add(by(1.0000000000000002) * (-t25).mul_add(t34, t27 * t33), t56);
                let t57 = by(0.766044443118978).mul_add(slot_1_displacement_2, t37) - lit(0.8);
                let t58 = by(-0.6427876096865393).mul_add(slot_1_displacement_2, t39);
                let arm_0_4_x = (-plate_angle_2_cos).mul_add(t57, plate_angle_2_sin * t58);
                let arm_0_4_y = -plate_angle_2_cos.mul_add(t58, t57 * plate_angle_2_sin);
                let j_0_across_0_0 = (-arm_0_4_x).mul_add(t46, arm_0_4_y * t48);
                let j_0_across_0_1 = t55.mul_add(t48, t54 * t46);
                let j_0_determinant =
                    (-j_0_across_0_1).mul_add(j_0_across_1_0, j_0_across_1_1 * j_0_across_0_0);
                let j_0_reciprocal = by(1.0) / j_0_determinant;
                let t59 = by(0.16) * cos_t4;
                let j_0_time_rate_across_1 = (-(-t59).mul_add(cos_crank_2_angle, t44))
                    .mul_add(t49, (-t59).mul_add(sin_crank_2_angle, t47) * t53);
                let j_0_time_rate_1 = j_0_time_rate_across_1.mul_add(
                    j_0_across_0_0 * j_0_reciprocal,
                    j_0_time_rate_across_0 * -(j_0_across_1_0 * j_0_reciprocal),
                );
                let t60 = plate_angle_2_cos * j_0_time_rate_1;
                let t61 = plate_angle_2_sin * j_0_time_rate_1;
                let j_0_time_rate_0 = j_0_time_rate_across_1.mul_add(
                    -(j_0_across_0_1 * j_0_reciprocal),
                    j_0_time_rate_across_0 * (j_0_across_1_1 * j_0_reciprocal),
                );
                v[9] = (-t42).mul_add(
                    j_0_time_rate_0,
                    by(-0.573576436351046)
                        .mul_add(t61, by(0.8191520442889918).mul_add(t60, crank_0_vx + crank_0_vx)),
                );
                v[10] = t41.mul_add(
                    j_0_time_rate_0,
                    by(0.8191520442889918)
                        .mul_add(t61, by(0.573576436351046).mul_add(t60, crank_0_vy + crank_0_vy)),
                );
                v[11] = -j_0_time_rate_0;
                let gap_0_x = loop_0_x + arm_0_4_x;
                let gap_0_y = loop_0_y + arm_0_4_y;
                let gap_1_x = loop_1_x + arm_1_4_x;
                let gap_1_y = loop_1_y + arm_1_4_y;
                let precision = lit(S::PRECISION);
                let t62 = gap_1_y
                    .mul_add(gap_1_y, gap_1_x.mul_add(gap_1_x, gap_0_y.mul_add(gap_0_y, gap_0_x * gap_0_x)))
                    .lt(by(2684354.5600000005) * precision * precision);
                let t63 = by(1.9999999999999996).mul_add(
                    j_0_across_1_0.mul_add(j_0_across_1_0, j_0_across_0_0 * j_0_across_0_0),
                    by(0.32) * j_0_across_0_1.mul_add(j_0_across_0_1, j_0_across_1_1 * j_0_across_1_1),
                );
                let t64 = S::select(
                    t62,
                    S::select(lit(0.0).lt(t63), by(2.0) * j_0_determinant * j_0_determinant / t63, lit(0.0)),
                    lit(-1.0),
                );
                t64
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart_0(&self, t: S, q: &[S; 12], v: &[S; 12], x: &mut [S; 0]) {}

            /// What is to be remembered of a state, and the smallest square of a dyad's measure.
            ///
            /// 204 add, 332 mul, 10 div, 21 neg, 1 sqrt, 7 sin_cos, 12 select, 1 other.
            fn remember_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 0, 4, 1, 4>,
                x: &[S; 0],
                memory: &mut rt::charts::Continuation<S, 0, 4, 1, 4>,
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                memory.time.last = t;
                let last_cosine_3 = m.angles[3].cos;
                let last_0 = m.time.last;
                let since_remembered = t - last_0;
                let last_rate_3 = m.iterated[0].rate;
                let last_bend_3 = m.iterated[0].bend;
                let t1 = since_remembered * last_bend_3.mul_add(since_remembered, last_rate_3);
                let plate_angle_expected_tangent = t1 * (by(0.041666666666666664) * t1).mul_add(t1, lit(0.5));
                let plate_angle_expected_sine = by(2.0) * plate_angle_expected_tangent
                    / plate_angle_expected_tangent.mul_add(plate_angle_expected_tangent, lit(1.0));
                let last_sine_3 = m.angles[3].sin;
                let plate_angle_expected_cos = (-plate_angle_expected_sine)
                    .mul_add(last_cosine_3.mul_add(plate_angle_expected_tangent, last_sine_3), last_cosine_3);
                let plate_angle_expected_sin = plate_angle_expected_sine.mul_add(
                    (-last_sine_3).mul_add(plate_angle_expected_tangent, last_cosine_3),
                    last_sine_3,
                );
                let t2 = by(0.8191520442889918)
                    .mul_add(plate_angle_expected_sin, by(0.573576436351046) * plate_angle_expected_cos);
                let t3 = by(0.984807753012208)
                    .mul_add(plate_angle_expected_sin, by(0.17364817766693033) * plate_angle_expected_cos);
                let t4 = by(-0.573576436351046)
                    .mul_add(plate_angle_expected_sin, by(0.8191520442889918) * plate_angle_expected_cos);
                let t5 = by(-0.17364817766693033)
                    .mul_add(plate_angle_expected_sin, by(0.984807753012208) * plate_angle_expected_cos);
                let j0_0_across_1_1 = t4.mul_add(t5, t2 * t3);
                let last_value_4 = m.iterated[1].value;
                let last_rate_4 = m.iterated[1].rate;
                let last_bend_4 = m.iterated[1].bend;
                let slot_0_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_4.mul_add(since_remembered, last_rate_4), last_value_4);
                let last_value_5 = m.iterated[2].value;
                let last_rate_5 = m.iterated[2].rate;
                let last_bend_5 = m.iterated[2].bend;
                let slot_1_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_5.mul_add(since_remembered, last_rate_5), last_value_5);
                let t6 = by(0.8191520442889918) * slot_0_displacement_expected;
                let t7 = by(0.766044443118978).mul_add(slot_1_displacement_expected, t6) - lit(0.8);
                let t8 = by(0.573576436351046) * slot_0_displacement_expected;
                let t9 = by(-0.6427876096865393).mul_add(slot_1_displacement_expected, t8);
                let arm0_0_4_x = (-t7).mul_add(plate_angle_expected_cos, t9 * plate_angle_expected_sin);
                let t10 = by(0.6427876096865393)
                    .mul_add(plate_angle_expected_sin, by(0.766044443118978) * plate_angle_expected_cos);
                let arm0_0_4_y = -t9.mul_add(plate_angle_expected_cos, t7 * plate_angle_expected_sin);
                let t11 = by(-0.766044443118978)
                    .mul_add(plate_angle_expected_sin, by(0.6427876096865393) * plate_angle_expected_cos);
                let j0_0_across_0_0 = (-arm0_0_4_x).mul_add(t10, arm0_0_4_y * t11);
                let j0_0_across_0_1 = t4.mul_add(t11, t2 * t10);
                let last_value_6 = m.iterated[3].value;
                let last_rate_6 = m.iterated[3].rate;
                let last_bend_6 = m.iterated[3].bend;
                let slot_2_displacement_expected = by(0.4)
                    * since_remembered
                        .mul_add(last_bend_6.mul_add(since_remembered, last_rate_6), last_value_6);
                let t12 = by(0.17364817766693033).mul_add(slot_2_displacement_expected, t6) - lit(0.4);
                let t13 = by(-0.984807753012208).mul_add(slot_2_displacement_expected, t8) - lit(0.7);
                let arm0_1_4_x = (-t12).mul_add(plate_angle_expected_cos, t13 * plate_angle_expected_sin);
                let arm0_1_4_y = -t13.mul_add(plate_angle_expected_cos, t12 * plate_angle_expected_sin);
                let j0_0_across_1_0 = (-t3).mul_add(arm0_1_4_x, t5 * arm0_1_4_y);
                let j0_0_reciprocal =
                    by(1.0) / (-j0_0_across_0_1).mul_add(j0_0_across_1_0, j0_0_across_1_1 * j0_0_across_0_0);
                let j0_0_inverse_0_0 = j0_0_across_1_1 * j0_0_reciprocal;
                let t14 = by(3.0) * t;
                let (sin_t14, cos_t14) = t14.sin_cos();
                let crank_0_angle = by(0.4) * sin_t14;
                let (sin_crank_0_angle, cos_crank_0_angle) = crank_0_angle.sin_cos();
                let t15 = by(2.0) * t;
                let (sin_t15, cos_t15) = t15.sin_cos();
                let crank_1_angle = by(0.3) * cos_t15;
                let (sin_crank_1_angle, cos_crank_1_angle) = crank_1_angle.sin_cos();
                let loop_0_y = by(0.2) * (sin_crank_0_angle - sin_crank_1_angle);
                let gap0_0_y = loop_0_y + arm0_0_4_y;
                let loop_0_x = by(0.2).mul_add(cos_crank_0_angle - cos_crank_1_angle, lit(-1.0));
                let gap0_0_x = loop_0_x + arm0_0_4_x;
                let j0_0_step_0_across_0 = -t11.mul_add(gap0_0_x, t10 * gap0_0_y);
                let j0_0_inverse_0_1 = -(j0_0_across_0_1 * j0_0_reciprocal);
                let t16 = by(4.0) * t;
                let (sin_t16, cos_t16) = t16.sin_cos();
                let crank_2_angle = by(0.2).mul_add(sin_t16, lit(-0.1));
                let (sin_crank_2_angle, cos_crank_2_angle) = crank_2_angle.sin_cos();
                let loop_1_y = by(0.2).mul_add(sin_crank_0_angle - sin_crank_2_angle, lit(-0.9));
                let gap0_1_y = arm0_1_4_y + loop_1_y;
                let loop_1_x = by(0.2).mul_add(cos_crank_0_angle - cos_crank_2_angle, lit(-0.5));
                let gap0_1_x = arm0_1_4_x + loop_1_x;
                let j0_0_step_0_across_1 = -t5.mul_add(gap0_1_x, t3 * gap0_1_y);
                let j0_0_step_0_0 =
                    j0_0_inverse_0_1.mul_add(j0_0_step_0_across_1, j0_0_inverse_0_0 * j0_0_step_0_across_0);
                let plate_angle_0_tangent = by(-0.5) * j0_0_step_0_0;
                let plate_angle_0_sine = by(2.0) * plate_angle_0_tangent
                    / plate_angle_0_tangent.mul_add(plate_angle_0_tangent, lit(1.0));
                let plate_angle_0_cos = (-plate_angle_0_sine).mul_add(
                    plate_angle_expected_cos.mul_add(plate_angle_0_tangent, plate_angle_expected_sin),
                    plate_angle_expected_cos,
                );
                let plate_angle_0_sin = plate_angle_0_sine.mul_add(
                    (-plate_angle_expected_sin).mul_add(plate_angle_0_tangent, plate_angle_expected_cos),
                    plate_angle_expected_sin,
                );
                let j0_0_inverse_1_0 = -(j0_0_across_1_0 * j0_0_reciprocal);
                let j0_0_inverse_1_1 = j0_0_across_0_0 * j0_0_reciprocal;
                let j0_0_step_0_1 =
                    j0_0_step_0_across_1.mul_add(j0_0_inverse_1_1, j0_0_step_0_across_0 * j0_0_inverse_1_0);
                let slot_0_displacement_0 = slot_0_displacement_expected - j0_0_step_0_1;
                let j0_0_along_0_0 = by(1.0000000000000002) * arm0_0_4_x.mul_add(t11, t10 * arm0_0_4_y);
                let j0_0_along_0_1 = by(1.0000000000000002) * (-t2).mul_add(t11, t4 * t10);
                let j0_0_step_0_2 = (-j0_0_step_0_1).mul_add(
                    j0_0_along_0_1,
                    (-j0_0_step_0_0).mul_add(
                        j0_0_along_0_0,
                        by(-1.0000000000000002) * (-t11).mul_add(gap0_0_y, t10 * gap0_0_x),
                    ),
                );
                let slot_1_displacement_0 = slot_1_displacement_expected - j0_0_step_0_2;
                let t17 = by(0.8191520442889918) * slot_0_displacement_0;
                let t18 = by(0.766044443118978).mul_add(slot_1_displacement_0, t17) - lit(0.8);
                let t19 = by(0.573576436351046) * slot_0_displacement_0;
                let t20 = by(-0.6427876096865393).mul_add(slot_1_displacement_0, t19);
                let gap1_0_y = loop_0_y + -plate_angle_0_cos.mul_add(t20, plate_angle_0_sin * t18);
                let gap1_0_x = loop_0_x + (-plate_angle_0_cos).mul_add(t18, plate_angle_0_sin * t20);
                let j0_0_step_1_across_0 = -t11.mul_add(gap1_0_x, t10 * gap1_0_y);
                let j0_0_along_1_0 = by(1.0000000000000002) * t5.mul_add(arm0_1_4_x, t3 * arm0_1_4_y);
                let j0_0_along_1_1 = by(1.0000000000000002) * (-t2).mul_add(t5, t3 * t4);
                let j0_0_step_0_3 = (-j0_0_step_0_1).mul_add(
                    j0_0_along_1_1,
                    (-j0_0_step_0_0).mul_add(
                        j0_0_along_1_0,
                        by(-1.0000000000000002) * (-t5).mul_add(gap0_1_y, t3 * gap0_1_x),
                    ),
                );
                let slot_2_displacement_0 = slot_2_displacement_expected - j0_0_step_0_3;
                let t21 = by(0.17364817766693033).mul_add(slot_2_displacement_0, t17) - lit(0.4);
                let t22 = by(-0.984807753012208).mul_add(slot_2_displacement_0, t19) - lit(0.7);
                let gap1_1_y = loop_1_y + -plate_angle_0_cos.mul_add(t22, plate_angle_0_sin * t21);
                let gap1_1_x = loop_1_x + (-plate_angle_0_cos).mul_add(t21, plate_angle_0_sin * t22);
                let j0_0_step_1_across_1 = -t5.mul_add(gap1_1_x, t3 * gap1_1_y);
                let j0_0_step_1_0 =
                    j0_0_inverse_0_1.mul_add(j0_0_step_1_across_1, j0_0_inverse_0_0 * j0_0_step_1_across_0);
                let plate_angle_1_tangent = by(-0.5) * j0_0_step_1_0;
                let plate_angle_1_sine = by(2.0) * plate_angle_1_tangent
                    / plate_angle_1_tangent.mul_add(plate_angle_1_tangent, lit(1.0));
                let plate_angle_1_cos = (-plate_angle_1_sine).mul_add(
                    plate_angle_0_cos.mul_add(plate_angle_1_tangent, plate_angle_0_sin),
                    plate_angle_0_cos,
                );
                let plate_angle_1_sin = plate_angle_1_sine.mul_add(
                    (-plate_angle_0_sin).mul_add(plate_angle_1_tangent, plate_angle_0_cos),
                    plate_angle_0_sin,
                );
                let t23 = by(0.8191520442889918)
                    .mul_add(plate_angle_1_sin, by(0.573576436351046) * plate_angle_1_cos);
                let t24 = by(0.984807753012208)
                    .mul_add(plate_angle_1_sin, by(0.17364817766693033) * plate_angle_1_cos);
                let t25 = by(-0.573576436351046)
                    .mul_add(plate_angle_1_sin, by(0.8191520442889918) * plate_angle_1_cos);
                let t26 = by(-0.17364817766693033)
                    .mul_add(plate_angle_1_sin, by(0.984807753012208) * plate_angle_1_cos);
                let j2_0_across_1_1 = t25.mul_add(t26, t23 * t24);
                let j0_0_step_1_1 =
                    j0_0_inverse_1_1.mul_add(j0_0_step_1_across_1, j0_0_inverse_1_0 * j0_0_step_1_across_0);
                let slot_0_displacement_1 = slot_0_displacement_0 - j0_0_step_1_1;
                let j0_0_step_1_2 = (-j0_0_along_0_1).mul_add(
                    j0_0_step_1_1,
                    (-j0_0_along_0_0).mul_add(
                        j0_0_step_1_0,
                        by(-1.0000000000000002) * (-t11).mul_add(gap1_0_y, t10 * gap1_0_x),
                    ),
                );
                let slot_1_displacement_1 = slot_1_displacement_0 - j0_0_step_1_2;
                let t27 = by(0.8191520442889918) * slot_0_displacement_1;
                let t28 = by(0.766044443118978).mul_add(slot_1_displacement_1, t27) - lit(0.8);
                let t29 = by(0.573576436351046) * slot_0_displacement_1;
                let t30 = by(-0.6427876096865393).mul_add(slot_1_displacement_1, t29);
                let arm2_0_4_x = (-plate_angle_1_cos).mul_add(t28, plate_angle_1_sin * t30);
                let t31 = by(0.6427876096865393)
                    .mul_add(plate_angle_1_sin, by(0.766044443118978) * plate_angle_1_cos);
                let arm2_0_4_y = -plate_angle_1_cos.mul_add(t30, plate_angle_1_sin * t28);
                let t32 = by(-0.766044443118978)
                    .mul_add(plate_angle_1_sin, by(0.6427876096865393) * plate_angle_1_cos);
                let j2_0_across_0_0 = (-arm2_0_4_x).mul_add(t31, arm2_0_4_y * t32);
                let j2_0_across_0_1 = t25.mul_add(t32, t23 * t31);
                let j0_0_step_1_3 = (-j0_0_along_1_1).mul_add(
                    j0_0_step_1_1,
                    (-j0_0_along_1_0).mul_add(
                        j0_0_step_1_0,
                        by(-1.0000000000000002) * (-t5).mul_add(gap1_1_y, t3 * gap1_1_x),
                    ),
                );
                let slot_2_displacement_1 = slot_2_displacement_0 - j0_0_step_1_3;
                let t33 = by(0.17364817766693033).mul_add(slot_2_displacement_1, t27) - lit(0.4);
                let t34 = by(-0.984807753012208).mul_add(slot_2_displacement_1, t29) - lit(0.7);
                let arm2_1_4_x = (-plate_angle_1_cos).mul_add(t33, plate_angle_1_sin * t34);
                let arm2_1_4_y = -plate_angle_1_cos.mul_add(t34, plate_angle_1_sin * t33);
                let j2_0_across_1_0 = (-t24).mul_add(arm2_1_4_x, t26 * arm2_1_4_y);
                let j2_0_reciprocal =
                    by(1.0) / (-j2_0_across_0_1).mul_add(j2_0_across_1_0, j2_0_across_1_1 * j2_0_across_0_0);
                let gap2_0_y = loop_0_y + arm2_0_4_y;
                let gap2_0_x = loop_0_x + arm2_0_4_x;
                let j2_0_step_2_across_0 = -t32.mul_add(gap2_0_x, t31 * gap2_0_y);
                let gap2_1_y = loop_1_y + arm2_1_4_y;
                let gap2_1_x = loop_1_x + arm2_1_4_x;
                let j2_0_step_2_across_1 = -t26.mul_add(gap2_1_x, t24 * gap2_1_y);
                let j2_0_step_2_0 = (-(j2_0_across_0_1 * j2_0_reciprocal))
                    .mul_add(j2_0_step_2_across_1, j2_0_across_1_1 * j2_0_reciprocal * j2_0_step_2_across_0);
                let plate_angle_2_tangent = by(-0.5) * j2_0_step_2_0;
                let plate_angle_2_sine = by(2.0) * plate_angle_2_tangent
                    / plate_angle_2_tangent.mul_add(plate_angle_2_tangent, lit(1.0));
                let plate_angle_2_cos = (-plate_angle_2_sine).mul_add(
                    plate_angle_1_cos.mul_add(plate_angle_2_tangent, plate_angle_1_sin),
                    plate_angle_1_cos,
                );
                let plate_angle_2_sin = plate_angle_2_sine.mul_add(
                    (-plate_angle_1_sin).mul_add(plate_angle_2_tangent, plate_angle_1_cos),
                    plate_angle_1_sin,
                );
                let t35 = by(0.8191520442889918)
                    .mul_add(plate_angle_2_sin, by(0.573576436351046) * plate_angle_2_cos);
                let t36 = by(0.984807753012208)
                    .mul_add(plate_angle_2_sin, by(0.17364817766693033) * plate_angle_2_cos);
                let t37 = by(-0.573576436351046)
                    .mul_add(plate_angle_2_sin, by(0.8191520442889918) * plate_angle_2_cos);
                let t38 = by(-0.17364817766693033)
                    .mul_add(plate_angle_2_sin, by(0.984807753012208) * plate_angle_2_cos);
                let j_0_across_1_1 = t37.mul_add(t38, t35 * t36);
                let j2_0_step_2_1 = j2_0_step_2_across_1.mul_add(
                    j2_0_across_0_0 * j2_0_reciprocal,
                    j2_0_step_2_across_0 * -(j2_0_across_1_0 * j2_0_reciprocal),
                );
                let slot_0_displacement_2 = slot_0_displacement_1 - j2_0_step_2_1;
                let t39 = (-j2_0_step_2_0).mul_add(
                    by(1.0000000000000002) * arm2_0_4_x.mul_add(t32, t31 * arm2_0_4_y),
                    by(-1.0000000000000002) * (-t32).mul_add(gap2_0_y, t31 * gap2_0_x),
                );
                let slot_1_displacement_2 = slot_1_displacement_1
                    - (-j2_0_step_2_1).mul_add(by(1.0000000000000002) * (-t23).mul_add(t32, t25 * t31), t39);
                let t40 = by(0.8191520442889918) * slot_0_displacement_2;
                let t41 = by(0.766044443118978).mul_add(slot_1_displacement_2, t40) - lit(0.8);
                let t42 = by(0.573576436351046) * slot_0_displacement_2;
                let t43 = by(-0.6427876096865393).mul_add(slot_1_displacement_2, t42);
                let arm_0_4_x = (-plate_angle_2_cos).mul_add(t41, plate_angle_2_sin * t43);
                let t44 = by(0.6427876096865393)
                    .mul_add(plate_angle_2_sin, by(0.766044443118978) * plate_angle_2_cos);
                let arm_0_4_y = -plate_angle_2_cos.mul_add(t43, t41 * plate_angle_2_sin);
                let t45 = by(-0.766044443118978)
                    .mul_add(plate_angle_2_sin, by(0.6427876096865393) * plate_angle_2_cos);
                let j_0_across_0_0 = (-arm_0_4_x).mul_add(t44, arm_0_4_y * t45);
                let j_0_across_0_1 = t37.mul_add(t45, t35 * t44);
                let t46 = (-j2_0_step_2_0).mul_add(
                    by(1.0000000000000002) * t26.mul_add(arm2_1_4_x, t24 * arm2_1_4_y),
                    by(-1.0000000000000002) * (-t26).mul_add(gap2_1_y, t24 * gap2_1_x),
                );
                let slot_2_displacement_2 = slot_2_displacement_1
                    - (-j2_0_step_2_1).mul_add(by(1.0000000000000002) * (-t23).mul_add(t26, t24 * t25), t46);
                let t47 = by(0.17364817766693033).mul_add(slot_2_displacement_2, t40) - lit(0.4);
                let t48 = by(-0.984807753012208).mul_add(slot_2_displacement_2, t42) - lit(0.7);
                let arm_1_4_x = (-plate_angle_2_cos).mul_add(t47, plate_angle_2_sin * t48);
                let arm_1_4_y = -plate_angle_2_cos.mul_add(t48, plate_angle_2_sin * t47);
                let j_0_across_1_0 = (-arm_1_4_x).mul_add(t36, arm_1_4_y * t38);
                let j_0_determinant =
                    (-j_0_across_0_1).mul_add(j_0_across_1_0, j_0_across_1_1 * j_0_across_0_0);
                let j_0_reciprocal = by(1.0) / j_0_determinant;
                let t49 = by(0.24) * (cos_t14 * cos_crank_0_angle);
                let t50 = by(0.12) * sin_t15;
                let t51 = t50.mul_add(cos_crank_1_angle, t49);
                let t52 = by(0.24) * (cos_t14 * sin_crank_0_angle);
                let t53 = t50.mul_add(sin_crank_1_angle, t52);
                let j_0_time_rate_across_0 = (-t51).mul_add(t44, t53 * t45);
                let t54 = by(0.16) * cos_t16;
                let t55 = (-t54).mul_add(cos_crank_2_angle, t49);
                let t56 = (-t54).mul_add(sin_crank_2_angle, t52);
                let j_0_time_rate_across_1 = (-t55).mul_add(t36, t56 * t38);
                let j_0_time_rate_0 = (-(j_0_across_0_1 * j_0_reciprocal)).mul_add(
                    j_0_time_rate_across_1,
                    j_0_across_1_1 * j_0_reciprocal * j_0_time_rate_across_0,
                );
                let t57 = j_0_time_rate_0.abs();
                let gap_0_x = loop_0_x + arm_0_4_x;
                let gap_0_y = loop_0_y + arm_0_4_y;
                let gap_1_x = loop_1_x + arm_1_4_x;
                let gap_1_y = loop_1_y + arm_1_4_y;
                let precision = lit(S::PRECISION);
                let t58 = gap_1_y
                    .mul_add(gap_1_y, gap_1_x.mul_add(gap_1_x, gap_0_y.mul_add(gap_0_y, gap_0_x * gap_0_x)))
                    .lt(by(2684354.5600000005) * precision * precision);
                let t59 = by(1.9999999999999996).mul_add(
                    j_0_across_0_0.mul_add(j_0_across_0_0, j_0_across_1_0 * j_0_across_1_0),
                    by(0.32) * j_0_across_0_1.mul_add(j_0_across_0_1, j_0_across_1_1 * j_0_across_1_1),
                );
                let t60 = S::select(
                    t58,
                    S::select(lit(0.0).lt(t59), by(2.0) * j_0_determinant * j_0_determinant / t59, lit(0.0)),
                    lit(-1.0),
                );
                let t61 = t60.sqrt();
                let t62 = by(1.0) / t61;
                let j_0_time_rate_1 = j_0_time_rate_across_1.mul_add(
                    j_0_across_0_0 * j_0_reciprocal,
                    j_0_time_rate_across_0 * -(j_0_across_1_0 * j_0_reciprocal),
                );
                let t63 = (-j_0_time_rate_0).mul_add(
                    by(1.0000000000000002) * arm_1_4_x.mul_add(t38, arm_1_4_y * t36),
                    by(1.0000000000000002) * t55.mul_add(t38, t56 * t36),
                );
                let j_0_time_rate_3 = (-(by(1.0000000000000002) * (-t35).mul_add(t38, t36 * t37)))
                    .mul_add(j_0_time_rate_1, t63);
                let t64 = by(2.5) * t62;
                let t65 = (-j_0_time_rate_0).mul_add(
                    by(1.0000000000000002) * arm_0_4_x.mul_add(t45, arm_0_4_y * t44),
                    by(1.0000000000000002) * t51.mul_add(t45, t53 * t44),
                );
                let j_0_time_rate_2 =
                    (-j_0_time_rate_1).mul_add(by(1.0000000000000002) * (-t35).mul_add(t45, t37 * t44), t65);
                let t66 = t57
                    .max((t64 * j_0_time_rate_3.abs()).max(
                        (t64 * j_0_time_rate_2.abs()).max((t57 * t62).max(t64 * j_0_time_rate_1.abs())),
                    ));
                memory.time.reach = by(-0.1) / t66;
                memory.angles[0].angle = crank_0_angle;
                memory.angles[0].cos = cos_crank_0_angle;
                memory.angles[0].sin = sin_crank_0_angle;
                memory.angles[1].angle = crank_1_angle;
                memory.angles[1].cos = cos_crank_1_angle;
                memory.angles[1].sin = sin_crank_1_angle;
                memory.angles[2].angle = crank_2_angle;
                memory.angles[2].cos = cos_crank_2_angle;
                memory.angles[2].sin = sin_crank_2_angle;
                let last_angle_3 = m.angles[3].angle;
                let t67 = last_angle_3
                    + (-last_sine_3)
                        .mul_add(plate_angle_2_cos, last_cosine_3 * plate_angle_2_sin)
                        .atan2(last_sine_3.mul_add(plate_angle_2_sin, last_cosine_3 * plate_angle_2_cos));
                memory.angles[3].angle = t67;
                let (sin_t67, cos_t67) = t67.sin_cos();
                memory.angles[3].cos = cos_t67;
                memory.angles[3].sin = sin_t67;
                memory.determinants[0] = t61;
                memory.iterated[0].value = t67;
                memory.iterated[0].rate = -j_0_time_rate_0;
                memory.iterated[0].bend = lit(0.0);
                memory.iterated[1].value = by(2.5) * slot_0_displacement_2;
                memory.iterated[1].rate = by(-2.5) * j_0_time_rate_1;
                memory.iterated[1].bend = lit(0.0);
                memory.iterated[2].value = by(2.5) * slot_1_displacement_2;
                memory.iterated[2].rate = by(-2.5) * j_0_time_rate_2;
                memory.iterated[2].bend = lit(0.0);
                memory.iterated[3].value = by(2.5) * slot_2_displacement_2;
                memory.iterated[3].rate = by(-2.5) * j_0_time_rate_3;
                memory.iterated[3].bend = lit(0.0);
                t60
            }

            /// The same of a pose and velocity.
            ///
            /// 85 add, 107 mul, 1 div, 2 neg, 1 sqrt, 4 sin_cos, 2 select.
            #[cold]
            fn remember_pose_0(
                &self,
                t: S,
                q: &[S; 12],
                v: &[S; 12],
                memory: &mut rt::charts::Continuation<S, 0, 4, 1, 4>,
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                memory.time.last = t;
                memory.time.reach = lit(0.0);
                let crank_0_angle = q[2];
                memory.angles[0].angle = crank_0_angle;
                let crank_1_angle = q[5];
                let crank_2_angle = q[8];
                let plate_angle = q[11];
                let (
                    [sin_crank_0_angle, sin_crank_1_angle, sin_crank_2_angle, sin_plate_angle],
                    [cos_crank_0_angle, cos_crank_1_angle, cos_crank_2_angle, cos_plate_angle],
                ) = S::sin_cos_all([crank_0_angle, crank_1_angle, crank_2_angle, plate_angle]);
                memory.angles[0].cos = cos_crank_0_angle;
                memory.angles[0].sin = sin_crank_0_angle;
                memory.angles[1].angle = crank_1_angle;
                memory.angles[1].cos = cos_crank_1_angle;
                memory.angles[1].sin = sin_crank_1_angle;
                memory.angles[2].angle = crank_2_angle;
                memory.angles[2].cos = cos_crank_2_angle;
                memory.angles[2].sin = sin_crank_2_angle;
                memory.angles[3].angle = plate_angle;
                memory.angles[3].cos = cos_plate_angle;
                memory.angles[3].sin = sin_plate_angle;
                let t1 =
                    by(0.8191520442889918).mul_add(sin_plate_angle, by(0.573576436351046) * cos_plate_angle);
                let t2 =
                    by(0.984807753012208).mul_add(sin_plate_angle, by(0.17364817766693033) * cos_plate_angle);
                let t3 =
                    by(-0.573576436351046).mul_add(sin_plate_angle, by(0.8191520442889918) * cos_plate_angle);
                let t4 = by(-0.17364817766693033)
                    .mul_add(sin_plate_angle, by(0.984807753012208) * cos_plate_angle);
                let j_0_across_1_1 = t3.mul_add(t4, t1 * t2);
                let t5 =
                    by(0.6427876096865393).mul_add(sin_plate_angle, by(0.766044443118978) * cos_plate_angle);
                let t6 =
                    by(-0.766044443118978).mul_add(sin_plate_angle, by(0.6427876096865393) * cos_plate_angle);
                let j_0_across_0_1 = t3.mul_add(t6, t1 * t5);
                let crank_0_x = q[0];
                let plate_x = q[9];
                let t7 = by(0.3).mul_add(sin_plate_angle, plate_x);
                let t8 = by(0.4) * cos_plate_angle;
                let t9 = by(0.1).mul_add(cos_crank_0_angle, crank_0_x) + t8 - t7;
                let crank_0_y = q[1];
                let plate_y = q[10];
                let t10 = by(-0.3).mul_add(cos_plate_angle, plate_y);
                let t11 = by(0.4) * sin_plate_angle;
                let t12 = by(0.1).mul_add(sin_crank_0_angle, crank_0_y) + t11 - t10;
                let t13 = t1.mul_add(t12, t3 * t9);
                let crank_2_x = q[6];
                let t14 = by(0.1).mul_add(cos_crank_2_angle, crank_2_x) - plate_x + t11;
                let t15 = t2 * t14;
                let crank_2_y = q[7];
                let t16 = by(0.1).mul_add(sin_crank_2_angle, crank_2_y) - plate_y - t8;
                let t17 = t4 * t16;
                let t18 = by(0.8191520442889918) * t13;
                let t19 = by(-0.17364817766693033).mul_add(by(0.9999999999999999).mul_add(t15, -t17), t18)
                    - lit(0.4);
                let t20 = t15 - t17;
                let t21 = by(0.573576436351046) * t13;
                let t22 = by(0.984807753012208).mul_add(t20, t21) - lit(0.7);
                let j_0_across_1_0 = (-t2).mul_add(
                    (-cos_plate_angle).mul_add(t19, sin_plate_angle * t22),
                    t4 * -cos_plate_angle.mul_add(t22, sin_plate_angle * t19),
                );
                let crank_1_x = q[3];
                let t23 = by(0.1).mul_add(cos_crank_1_angle, crank_1_x) - t8 - t7;
                let t24 = t5 * t23;
                let crank_1_y = q[4];
                let t25 = by(0.1).mul_add(sin_crank_1_angle, crank_1_y) - t11 - t10;
                let t26 = t6 * t25;
                let t27 =
                    by(-0.766044443118978).mul_add(by(0.9999999999999999).mul_add(t24, -t26), t18) - lit(0.8);
                let t28 = t24 - t26;
                let t29 = by(0.6427876096865393).mul_add(t28, t21);
                let j_0_across_0_0 = (-t5).mul_add(
                    (-cos_plate_angle).mul_add(t27, sin_plate_angle * t29),
                    t6 * -cos_plate_angle.mul_add(t29, sin_plate_angle * t27),
                );
                let t30 = by(1.9999999999999996).mul_add(
                    j_0_across_0_0.mul_add(j_0_across_0_0, j_0_across_1_0 * j_0_across_1_0),
                    by(0.32) * j_0_across_0_1.mul_add(j_0_across_0_1, j_0_across_1_1 * j_0_across_1_1),
                );
                let j_0_determinant =
                    (-j_0_across_0_1).mul_add(j_0_across_1_0, j_0_across_1_1 * j_0_across_0_0);
                let t31 =
                    S::select(lit(0.0).lt(t30), by(2.0) * j_0_determinant * j_0_determinant / t30, lit(0.0));
                memory.determinants[0] = t31.sqrt();
                memory.iterated[0].value = plate_angle;
                let plate_omega = v[11];
                memory.iterated[0].rate = plate_omega;
                memory.iterated[0].bend = lit(0.0);
                memory.iterated[1].value = by(2.5) * t13;
                let t32 = plate_omega * sin_plate_angle;
                let t33 = plate_omega * cos_plate_angle;
                let crank_0_vx = v[0];
                let crank_0_omega = v[2];
                let plate_vx = v[9];
                let t34 = by(0.3).mul_add(t33, plate_vx);
                let t35 = by(0.1) * crank_0_omega;
                let t36 = by(0.4) * t32;
                let crank_0_vy = v[1];
                let plate_vy = v[10];
                let t37 = by(0.3).mul_add(t32, plate_vy);
                let t38 = by(0.4) * t33;
                let t39 = (-t3).mul_add(
                    (-t35).mul_add(sin_crank_0_angle, crank_0_vx) - t36 - t34,
                    by(0.573576436351046).mul_add(t33, by(0.8191520442889918) * t32) * t9,
                );
                let t40 = (-t1).mul_add(
                    t35.mul_add(cos_crank_0_angle, crank_0_vy) + t38 - t37,
                    by(-0.8191520442889918).mul_add(t33, by(0.573576436351046) * t32).mul_add(t12, t39),
                );
                memory.iterated[1].rate = by(-2.5) * t40;
                memory.iterated[1].bend = lit(0.0);
                memory.iterated[2].value = by(-2.5) * t28;
                let crank_1_vx = v[3];
                let crank_1_omega = v[5];
                let t41 = by(0.1) * crank_1_omega;
                let crank_1_vy = v[4];
                let t42 = (-t5).mul_add(
                    (-t41).mul_add(sin_crank_1_angle, crank_1_vx + t36) - t34,
                    by(-0.6427876096865393).mul_add(t33, by(0.766044443118978) * t32) * t23,
                );
                let t43 = t6.mul_add(
                    t41.mul_add(cos_crank_1_angle, crank_1_vy - t38) - t37,
                    (-by(0.766044443118978).mul_add(t33, by(0.6427876096865393) * t32)).mul_add(t25, t42),
                );
                memory.iterated[2].rate = by(2.5) * t43;
                memory.iterated[2].bend = lit(0.0);
                memory.iterated[3].value = by(-2.5) * t20;
                let crank_2_vx = v[6];
                let crank_2_omega = v[8];
                let t44 = by(0.1) * crank_2_omega;
                let crank_2_vy = v[7];
                let t45 = (-t2).mul_add(
                    (-t44).mul_add(sin_crank_2_angle, crank_2_vx - plate_vx + t38),
                    t14 * by(-0.984807753012208).mul_add(t33, by(0.17364817766693033) * t32),
                );
                let t46 = t4.mul_add(
                    t44.mul_add(cos_crank_2_angle, crank_2_vy - plate_vy + t36),
                    (-t16).mul_add(by(0.17364817766693033).mul_add(t33, by(0.984807753012208) * t32), t45),
                );
                memory.iterated[3].rate = by(2.5) * t46;
                memory.iterated[3].bend = lit(0.0);
                t31
            }
        }
    }
}
