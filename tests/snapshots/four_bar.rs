#[doc(inline)]
#[allow(unreachable_pub)]
pub use plm_four_bar_::four_bar::FourBar;

#[doc(inline)]
#[allow(unreachable_pub, unused_imports)]
pub use plm_four_bar_::four_bar;
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]
mod plm_four_bar_ {
    /// Four-bar linkage: its loop is a dyad, solved in closed form in several charts.
    ///
    /// 3 bodies, 4 parts: 9 coordinates, 8 constraint rows, F = 3 N - M = 1.
    /// Formulation 3: joint coordinates; the loops are solved in closed form, so that no constraint is left.
    /// Chart 0: crank.angle; then RRR rocker.angle, coupler.angle.
    /// Chart 1: rocker.angle; then RRR crank.angle, coupler.angle.
    /// Chart 2: coupler.angle; then RRR crank.angle, rocker.angle.
    /// Accelerations by a dense mass matrix.
    /// State: 2 numbers, 16 bytes in f64.
    /// A solution by rank, where one is needed: 1088 bytes of stack in f64.
    /// One right-hand side: 26 add, 50 mul, 3 div, 2 neg, 1 sqrt, 1 sin_cos, 3 select.
    ///
    /// | row | constraint | equation | unit |
    /// |----:|------------|----------|------|
    /// | 0 | `drive.x` | `crank.x - 0.15*cos(crank.angle) = 0` | m |
    /// | 1 | `drive.y` | `crank.y - 0.15*sin(crank.angle) = 0` | m |
    /// | 2 | `crank_coupler.x` | `coupler.x - crank.x - 0.15*cos(crank.angle) - 0.45*cos(coupler.angle) = 0` | m |
    /// | 3 | `crank_coupler.y` | `coupler.y - crank.y - 0.15*sin(crank.angle) - 0.45*sin(coupler.angle) = 0` | m |
    /// | 4 | `coupler_rocker.x` | `rocker.x - coupler.x - 0.45*cos(coupler.angle) + 0.35*cos(rocker.angle) = 0` | m |
    /// | 5 | `coupler_rocker.y` | `rocker.y - coupler.y - 0.45*sin(coupler.angle) + 0.35*sin(rocker.angle) = 0` | m |
    /// | 6 | `pivot.x` | `rocker.x - 0.35*cos(rocker.angle) - 1 = 0` | m |
    /// | 7 | `pivot.y` | `rocker.y - 0.35*sin(rocker.angle) = 0` | m |
    pub mod four_bar {
        pub use super::code_::*;
        pub use super::type_::FourBar;
    }

    mod type_ {
        /// Four-bar linkage: its loop is a dyad, solved in closed form in several charts.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct FourBar<S = ::core::primitive::f64> {
            /// Start values of the bodies, and which of them assembly keeps.
            pub start: super::code_::Starts<S>,
        }
    }

    mod code_ {
        use super::type_::FourBar;
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
            /// Origin of body `coupler`.
            pub coupler: BodyStart<S>,
            /// Origin of body `rocker`.
            pub rocker: BodyStart<S>,
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
            [<S as Scalar>::Turns; 3],
            rt::charts::OfLoops<rt::charts::Continuation<S, 1, 3, 1, 0>, [S; 9]>,
        >;

        /// Pose, accelerations and a vector, which outputs have in common.
        type Common<S> = rt::Common<([S; 9], [S; 9]), Held<S>, ([S; 9], [S; 8]), [S; 2]>;

        /// The mechanism at one moment; its methods read poses and outputs, `input` has the inputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: FourBar<S>,
            held: rt::Held<
                Input<S>,
                [S; 0],
                [i32; 3],
                rt::charts::OfLoops<rt::charts::Continuation<S, 1, 3, 1, 0>, [S; 9]>,
            >,
            time: S,
            x: [S; 2],
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
        pub const NC: usize = 8;
        /// First-order states.
        pub const NX: usize = 0;
        /// Degrees of freedom, `3 N - M`.
        pub const NDOF: isize = 1;
        /// Operations of one evaluation of the right-hand side.
        pub const OPERATIONS: Operations =
            Operations { add: 28, mul: 50, div: 3, sqrt: 1, sin_cos: 1, other: 3 };
        impl<S: Real> State<S> {
            /// Time, s.
            pub fn time(&self) -> S {
                self.time
            }

            /// Pose and velocity of G of body `crank`: m, m, rad; m/s, m/s, rad/s.
            pub fn crank(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[0], q[1], rt::turns::whole(q[2], self.held.turns[0])], [v[0], v[1], v[2]])
            }

            /// Pose and velocity of G of body `coupler`: m, m, rad; m/s, m/s, rad/s.
            pub fn coupler(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[3], q[4], rt::turns::whole(q[5], self.held.turns[1])], [v[3], v[4], v[5]])
            }

            /// Pose and velocity of G of body `rocker`: m, m, rad; m/s, m/s, rad/s.
            pub fn rocker(&self) -> BodyState<S> {
                let (q, v) = self.pose_();
                BodyState::of([q[6], q[7], rt::turns::whole(q[8], self.held.turns[2])], [v[6], v[7], v[8]])
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

            /// Kinetic energy of all bodies, J.
            pub fn kinetic_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (_, v) = common.pose.get_or_init(|| self.pose_());
                let [
                    crank_vx,
                    crank_vy,
                    crank_omega,
                    coupler_vx,
                    coupler_vy,
                    coupler_omega,
                    rocker_vx,
                    rocker_vy,
                    rocker_omega,
                    ..,
                ] = *v;
                let by = rt::Factor;
                let t1 = (by(0.014291666666666666) * rocker_omega).mul_add(
                    rocker_omega,
                    (by(0.030375) * coupler_omega)
                        .mul_add(coupler_omega, by(0.001125) * crank_omega * crank_omega),
                );
                let t2 = by(0.45).mul_add(
                    coupler_vy.mul_add(coupler_vy, coupler_vx * coupler_vx),
                    by(0.15).mul_add(crank_vy.mul_add(crank_vy, crank_vx * crank_vx), t1),
                );
                by(0.35).mul_add(rocker_vy.mul_add(rocker_vy, rocker_vx * rocker_vx), t2)
            }

            /// Potential energy of gravity above the origin, J.
            pub fn gravity_energy(&self) -> S {
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [_, crank_y, _, _, coupler_y, _, _, rocker_y, ..] = *q;
                let by = rt::Factor;
                by(6.867).mul_add(rocker_y, by(8.829).mul_add(coupler_y, by(2.943) * crank_y))
            }

            /// Power of all forces and torques but gravity and reactions, W.
            pub fn load_power(&self) -> S {
                let lit = S::lit;
                lit(0.0)
            }

            /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
            /// the second turns from the first, rad, positive to the left.
            pub fn branches(&self) -> [(&'static str, S); 2] {
                let mut value = [S::lit(0.0); 2];
                let common = &Common::<S>::new();
                let (q, _) = common.pose.get_or_init(|| self.pose_());
                let [
                    crank_x,
                    crank_y,
                    crank_angle,
                    coupler_x,
                    coupler_y,
                    coupler_angle,
                    rocker_x,
                    rocker_y,
                    rocker_angle,
                    ..,
                ] = *q;
                let by = rt::Factor;
                let (
                    [sin_crank_angle, sin_coupler_angle, sin_rocker_angle],
                    [cos_crank_angle, cos_coupler_angle, cos_rocker_angle],
                ) = S::sin_cos_all([crank_angle, coupler_angle, rocker_angle]);
                let t1 = by(0.45).mul_add(sin_coupler_angle, coupler_y);
                let t2 = by(0.15).mul_add(sin_crank_angle, crank_y) - t1;
                let t3 = by(0.45).mul_add(cos_coupler_angle, coupler_x);
                let t4 = by(0.15).mul_add(cos_crank_angle, crank_x) - t3;
                let t5 = (by(-0.3) * (-sin_crank_angle).mul_add(t4, cos_crank_angle * t2))
                    .atan2(by(-0.3) * sin_crank_angle.mul_add(t2, cos_crank_angle * t4));
                value[0] = t5;
                let t6 = by(0.35).mul_add(sin_rocker_angle, -rocker_y) + t1;
                let t7 = by(0.35).mul_add(cos_rocker_angle, -rocker_x) + t3;
                let t8 = (by(-0.9) * (-sin_coupler_angle).mul_add(t7, cos_coupler_angle * t6))
                    .atan2(by(-0.9) * sin_coupler_angle.mul_add(t6, cos_coupler_angle * t7));
                value[1] = t8;
                [("crank_coupler", value[0]), ("coupler_rocker", value[1])]
            }

            /// Names and units of the columns of [`State::outputs`].
            pub const OUTPUTS: [(&'static str, &'static str); 2] =
                [("drive.force.x", "N"), ("drive.force.y", "N")];
            /// The declared outputs, in the units of [`State::OUTPUTS`].
            pub fn outputs(&self) -> [S; 2] {
                let common = &Common::<S>::new();
                let own_0 = self.drive_force_among_(common);
                [own_0[0], own_0[1]]
            }

            /// Names and SI units of the outputs and of all that is observed.
            pub const OBSERVED: [(&'static str, &'static str); 2] =
                [("drive.force.x", "N"), ("drive.force.y", "N")];

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
                        _ => S::lit(f64::NAN),
                    }
                }
                match column / 200 {
                    0 => block_0(self, column, common),
                    _ => S::lit(f64::NAN),
                }
            }
        }

        impl FourBar<f64> {
            /// The mechanism as declared, in `f64`; `FourBar { field: value, ..FourBar::new() }` changes some.
            pub fn new() -> Self {
                Self::of()
            }
        }

        impl Default for FourBar<f64> {
            fn default() -> Self {
                Self::of()
            }
        }

        impl<S: Scalar> FourBar<S> {
            /// The mechanism as declared, for any scalar.
            pub fn of() -> Self {
                let lit = S::lit;
                let start = Starts {
                    crank: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::locked(lit(1.0471975511965979)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    coupler: BodyStart {
                        x: Start::free(lit(0.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(0.5235987755982989)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                    rocker: BodyStart {
                        x: Start::free(lit(1.0)),
                        y: Start::free(lit(0.0)),
                        angle: Start::free(lit(1.6580627893946132)),
                        vx: Start::free(lit(0.0)),
                        vy: Start::free(lit(0.0)),
                        omega: Start::free(lit(0.0)),
                    },
                };
                FourBar { start }
            }
        }

        impl<S: Real> FourBar<S> {
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

        impl<S: Scalar> FourBar<S> {
            /// The inputs as declared.
            fn declared_input(&self) -> Input<S> {
                Input { none: core::marker::PhantomData }
            }
        }

        impl<S: Real> rt::charts::Charted for FourBar<S> {
            type Input = Input<S>;
            type Switches = [S; 0];
            type Turns = [i32; 3];
            type Contact = ();
            type Continuation = rt::charts::Continuation<S, 1, 3, 1, 0>;
            type Q = [S; 9];
            const CHARTS: rt::charts::Charts = rt::charts::Charts {
                count: 3,
                revolutions: &[
                    rt::charts::Revolutions { coordinates: &[&[0], &[], &[]], angles: &[0], iterated: &[] },
                    rt::charts::Revolutions { coordinates: &[&[], &[], &[0]], angles: &[2], iterated: &[] },
                    rt::charts::Revolutions { coordinates: &[&[], &[0], &[]], angles: &[1], iterated: &[] },
                ],
                is_loose: false,
                turning: &["crank", "rocker", "coupler"],
                found: &[&[1, 2], &[0, 2], &[0, 1]],
                iterated: &[],
                closing: &[&["coupler_rocker"], &["crank_coupler"], &["pivot"]],
            };

            fn pose(&self, t: S, held: &Self::U, x: &[S; 2]) -> ([S; 9], [S; 9], S) {
                let (mut q, mut v) = ([S::lit(0.0); 9], [S::lit(0.0); 9]);
                let measure = match &held.of_loops {
                    rt::charts::OfLoops::InChart { chart: 0, continuation: m } => {
                        self.pose_0(t, held, m, x, &mut q, &mut v)
                    }
                    rt::charts::OfLoops::InChart { chart: 1, continuation: m } => {
                        self.pose_1(t, held, m, x, &mut q, &mut v)
                    }
                    rt::charts::OfLoops::InChart { continuation: m, .. } => {
                        self.pose_2(t, held, m, x, &mut q, &mut v)
                    }
                    rt::charts::OfLoops::Free { q: free_q, v: free_v } => {
                        (q, v) = (*free_q, *free_v);
                        S::lit(0.0)
                    }
                };
                (q, v, measure)
            }

            fn continuation(&self, t: S, held: &Self::U, x: &[S; 2]) -> (Self::Continuation, S) {
                self.remember_(t, held, x)
            }

            fn continuation_at(&self, chart: usize, t: S, q: &[S; 9], v: &[S; 9]) -> (Self::Continuation, S) {
                let mut memory: Self::Continuation = rt::charts::ContinuationData::nothing();
                let measure = match chart {
                    0 => self.remember_pose_0(t, q, v, &mut memory),
                    1 => self.remember_pose_1(t, q, v, &mut memory),
                    _ => self.remember_pose_2(t, q, v, &mut memory),
                };
                (memory, measure)
            }

            fn to_chart(&self, chart: usize, t: S, q: &[S; 9], v: &[S; 9], x: &mut [S; 2]) {
                match chart {
                    0 => self.to_chart_0(t, q, v, x),
                    1 => self.to_chart_1(t, q, v, x),
                    _ => self.to_chart_2(t, q, v, x),
                }
            }
        }

        impl<S: Scalar> FourBar<S> {
            fn remember_(
                &self,
                t: S,
                held: &Held<S>,
                x: &[S; 2],
            ) -> (rt::charts::Continuation<S, 1, 3, 1, 0>, S) {
                let mut memory: rt::charts::Continuation<S, 1, 3, 1, 0> =
                    rt::charts::ContinuationData::nothing();
                let measure = match &held.of_loops {
                    rt::charts::OfLoops::InChart { chart: 0, continuation: m } => {
                        self.remember_0(t, held, m, x, &mut memory)
                    }
                    rt::charts::OfLoops::InChart { chart: 1, continuation: m } => {
                        self.remember_1(t, held, m, x, &mut memory)
                    }
                    rt::charts::OfLoops::InChart { continuation: m, .. } => {
                        self.remember_2(t, held, m, x, &mut memory)
                    }
                    rt::charts::OfLoops::Free { q: free_q, v: free_v } => S::lit(0.0),
                };
                (memory, measure)
            }
        }

        impl<S: Scalar> rt::Rate for FourBar<S> {
            type S = S;
            type X = [S; 2];
            type U = Held<S>;
            const NQ: usize = 1;
            const SHORT: bool = !S::REGISTERS.are_filled();
            #[inline(always)]
            fn rate(&self, t: S, u: &Self::U, x: &[S; 2], dx: &mut [S; 2]) -> rt::Health<S> {
                rt::Health(match &u.of_loops {
                    rt::charts::OfLoops::InChart { chart: 0, continuation: m } => {
                        self.motion_0(t, u, m, x, dx)
                    }
                    rt::charts::OfLoops::InChart { chart: 1, continuation: m } => {
                        let (at, mut out) = (*x, *dx);
                        let measure = self.motion_1(t, u, m, &at, &mut out);
                        *dx = out;
                        measure
                    }
                    rt::charts::OfLoops::InChart { continuation: m, .. } => {
                        let (at, mut out) = (*x, *dx);
                        let measure = self.motion_2(t, u, m, &at, &mut out);
                        *dx = out;
                        measure
                    }
                    rt::charts::OfLoops::Free { q: free_q, v: free_v } => S::lit(0.0),
                })
            }

            const PAIRED: bool = S::REGISTERS.pays_in_pairs(true);
            #[inline(always)]
            fn rate_pair(
                &self,
                t: [S; 2],
                u: &Self::U,
                x: [&[S; 2]; 2],
                dx: &mut [[S; 2]; 2],
                second: impl FnOnce(&[S; 2]) -> [S; 2],
            ) -> rt::Health<S> {
                let rt::charts::OfLoops::InChart { chart: 0, continuation: m } = &u.of_loops else {
                    let (k, health) = rt::system::rate_aside(self, t[0], u, *x[0]);
                    dx[0] = k;
                    let (k, other) = rt::system::rate_aside(self, t[1], u, second(&k));
                    dx[1] = k;
                    return health.worst(other);
                };
                let shared = Self::of_two_poses(m, x[0][0], x[1][0]);
                let health = self.rate_at_pose::<false>(t[0], u, m, x[0], &shared, &mut dx[0]);
                let next = second(&dx[0]);
                health.worst(self.rate_at_pose::<true>(t[1], u, m, &next, &shared, &mut dx[1]))
            }

            #[inline]
            fn typical(&self) -> [S; 2] {
                [1.0; 2].map(S::lit)
            }
        }

        impl<S: Scalar> FourBar<S> {
            /// Values of the poses of two stages that their rates share. Compilers begin to build vectors where results are stored: a
            /// function of its own.
            #[inline(never)]
            fn of_two_poses(
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                first_0: S,
                second_0: S,
            ) -> [Two<S>; 4] {
                let x: &[Two<S>; 1] = &[Two([first_0, second_0])];
                let [crank_angle, ..] = *x;
                let lit = Two::<S>::lit;
                let by = rt::Factor;
                let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                let loop_0_x = by(0.3).mul_add(cos_crank_angle, lit(-1.0));
                let loop_0_y = by(0.3) * sin_crank_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.32));
                let inverse_0 = by(1.0) / distance_0;
                let way_0_x = along_0 * inverse_0;
                let square_0 = (-along_0).mul_add(along_0, by(0.49) * distance_0);
                let last_area_0 = Two::both(m.determinants[0]);
                let area_0 = lit(0.0).max(square_0).sqrt()
                    * Two::<S>::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0));
                let way_0_y = area_0 * inverse_0;
                let rocker_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let t1 = cos_crank_angle - lit(0.3);
                let cross_0_0 = (-t1).mul_add(way_0_y, sin_crank_angle * way_0_x);
                let cross_0_1 = sin_crank_angle + cross_0_0;
                let reciprocal_0 = by(1.0) / area_0;
                let ratio_0_0 = by(0.3) * cross_0_1 * reciprocal_0;
                let ratio_0_1 = by(0.3) * cross_0_0 * reciprocal_0;
                let still_0 = (-(by(4.4145) * -(loop_0_x + rocker_arm_x))).mul_add(
                    ratio_0_1,
                    by(-3.09015).mul_add(cos_crank_angle, by(3.4335) * rocker_arm_x * ratio_0_0),
                );
                let momentum_0_1 = by(0.11433333333333333) * ratio_0_0;
                let t2 = ratio_0_1 * ratio_0_1;
                let dot_0_0 = -sin_crank_angle.mul_add(way_0_y, t1 * way_0_x);
                let dot_0_1 = dot_0_0 - t1;
                let t3 = along_0 + lit(0.49);
                let t4 = ratio_0_0 * ratio_0_0;
                let momentum_0_2 = by(-0.135).mul_add(dot_0_1, by(0.243) * ratio_0_1);
                let t5 = by(0.135) * ratio_0_1;
                let t6 = momentum_0_2.mul_add(
                    reciprocal_0 * by(-0.49).mul_add(t4, by(-0.3).mul_add(dot_0_0, t3 * t2)),
                    momentum_0_1
                        * (reciprocal_0 * (-t3).mul_add(t4, by(-0.3).mul_add(dot_0_1, by(0.81) * t2))),
                );
                [
                    still_0,
                    (-(cross_0_1 * ratio_0_1)).mul_add(lit(0.135) - t5, t6),
                    by(1.0)
                        / ratio_0_1.mul_add(
                            momentum_0_2,
                            ratio_0_0.mul_add(momentum_0_1, (-t5).mul_add(dot_0_1, lit(0.09))),
                        ),
                    by(2.5195263290501386) * square_0,
                ]
            }

            /// The rate in one of two stages, at its pose.
            #[inline(always)]
            fn rate_at_pose<const SECOND: bool>(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                shared: &[Two<S>; 4],
                dx: &mut [S; 2],
            ) -> rt::Health<S> {
                rt::Health({
                    let [_, crank_omega, ..] = *x;
                    let crank_angle_acceleration = (-(crank_omega * crank_omega))
                        .mul_add(shared[1].of::<SECOND>(), shared[0].of::<SECOND>())
                        * shared[2].of::<SECOND>();
                    dx[0] = crank_omega;
                    dx[1] = crank_angle_acceleration;
                    shared[3].of::<SECOND>()
                })
            }
        }

        impl<S: Real> rt::Constraints for FourBar<S> {
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
            fn rate_by_rank(&self, t: S, u: &Self::U, x: &[S; 2], dx: &mut [S; 2]) -> Result<(), Fault> {
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
            fn is_settled(&self, t: S, u: &Self::U, x: &[S; 2]) -> bool {
                rt::charts::is_calm(self, t, u, x)
            }

            #[inline]
            fn update(&self, t: S, u: &mut Self::U, x: &mut [S; 2]) -> Result<rt::Updated, Fault> {
                rt::charts::update(self, t, u, x)
            }

            fn energy(&self, t: S, u: &Self::U, x: &[S; 2]) -> Option<rt::Energy<S>> {
                let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
                let (kinetic, gravity) = (state.kinetic_energy(), state.gravity_energy());
                Some(rt::Energy { kinetic, gravity, power: state.load_power() })
            }
        }

        impl<S: Real> rt::Switched for FourBar<S> {
            type Guards = [S; 0];
            type Contact = rt::switched::NoContact;
            const SWITCHES: rt::Switches = rt::Switches::NONE;
        }

        impl<S: Real> rt::Labels for FourBar<S> {
            fn labels(&self) -> &'static rt::LabelTable {
                const {
                    &rt::LabelTable {
                        parts: rt::PartNames::Numbers(const { &["crank", "crank"] }),
                        states: const {
                            &[
                                "crank.angle or rocker.angle or coupler.angle",
                                "crank.omega or rocker.omega or coupler.omega",
                            ]
                        },
                        in_charts: const {
                            &[
                                "crank.angle",
                                "crank.omega",
                                "rocker.angle",
                                "rocker.omega",
                                "coupler.angle",
                                "coupler.omega",
                            ]
                        },
                        ..rt::LabelTable::NONE
                    }
                }
            }

            fn chart_of(&self, u: &Self::U) -> Option<usize> {
                rt::held::Loops::<S>::chart(&u.of_loops)
            }
        }

        #[doc(hidden)]
        impl<S: Real> rt::singular::ExtendedPrecision<9, 8, 18> for FourBar<S> {
            type Extended = FourBar<rt::DoubleDouble<S>>;
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
                let mut lambda = [rt::DoubleDouble::<S>::lit(0.0); 8];
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
                rt::turns::add(&self.held.turns, &mut q, &[&[2], &[5], &[8]]);
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
            type M = FourBar<S>;

            fn new(mechanism: FourBar<S>, held: Held<S>, time: S, x: [S; 2]) -> Self {
                State { mechanism, held, time, x }
            }

            fn mechanism(&self) -> &FourBar<S> {
                &self.mechanism
            }

            fn held(&self) -> Held<S> {
                self.held
            }

            fn time(&self) -> S {
                self.time
            }

            fn x(&self) -> &[S; 2] {
                &self.x
            }

            fn set(&mut self, time: S, held: &Held<S>, x: &[S; 2]) {
                self.time = time;
                self.held = *held;
                self.x = *x;
            }

            fn in_place(&mut self) -> rt::InPlace<'_, FourBar<S>> {
                let Self { mechanism, held, time, x } = self;
                rt::InPlace { system: mechanism, held, time, x }
            }
        }

        impl<S: Real> rt::Mechanism for FourBar<S> {
            type State = State<S>;
            type Rescue = rt::singular::NearSingular<Self, 9, 8, 18>;
            const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();
            fn start_state(&self, t: S) -> Result<(Held<S>, [S; 2]), Fault> {
                self.start_holding_(t, self.declared_input())
            }

            fn opening(&self, t: S, held: &Held<S>, x: &[S; 2]) -> rt::Drift<S> {
                let (q, v) = <State<S> as rt::Moment>::new(*self, *held, t, *x).pose_();
                absolute::opening::<S, Self, NQ, NC>(self, t, &q, &v)
            }
        }

        impl<S: Real> FourBar<S> {
            fn holding_(input: Input<S>) -> Held<S> {
                rt::Held {
                    input,
                    switches: [S::lit(1.0); 0],
                    turns: [0; 3],
                    of_loops: rt::charts::OfLoops::InChart {
                        chart: 0,
                        continuation: rt::charts::ContinuationData::nothing(),
                    },
                    contact: (),
                }
            }

            fn start_holding_(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; 2]), Fault> {
                let assembly = absolute::assemble(self, t)?;
                let mut x = [S::lit(0.0); 2];
                if assembly.redundant.contains(&true) {
                    let joints = rt::Names::marked(Self::LAYOUT_.parts, &assembly.redundant);
                    return Err(Fault::new(rt::Scalar::to_f64(t), rt::Cause::Repeats { joints }));
                }
                let mut held = Self::holding_(input);
                rt::charts::enter(self, t, &mut held, (&assembly.q, &assembly.v), &mut x);
                Ok((held, x))
            }
        }

        impl<S: Scalar> FourBar<S> {
            const LAYOUT_: absolute::Layout = absolute::Layout {
                rows: const {
                    &[
                        "drive.x",
                        "drive.y",
                        "crank_coupler.x",
                        "crank_coupler.y",
                        "coupler_rocker.x",
                        "coupler_rocker.y",
                        "pivot.x",
                        "pivot.y",
                    ]
                },
                parts: const {
                    &[
                        "drive",
                        "drive",
                        "crank_coupler",
                        "crank_coupler",
                        "coupler_rocker",
                        "coupler_rocker",
                        "pivot",
                        "pivot",
                    ]
                },
                coordinates: const {
                    &[
                        "crank.x",
                        "crank.y",
                        "crank.angle",
                        "coupler.x",
                        "coupler.y",
                        "coupler.angle",
                        "rocker.x",
                        "rocker.y",
                        "rocker.angle",
                    ]
                },
                angular: &[false; 8],
                given_angles: &[true; 3],
            };
            /// The derivatives of phi by q: the entries that are not zero, row by row.
            ///
            /// 8 mul, 3 sin_cos.
            #[cold]
            fn phi_q_entries(&self, t: S, q: &[S; 9], phi_q: &mut [S; 24]) {
                let crank_angle = q[2];
                let coupler_angle = q[5];
                let rocker_angle = q[8];
                let lit = S::lit;
                let by = rt::Factor;
                phi_q[0] = lit(1.0);
                let (
                    [sin_crank_angle, sin_coupler_angle, sin_rocker_angle],
                    [cos_crank_angle, cos_coupler_angle, cos_rocker_angle],
                ) = S::sin_cos_all([crank_angle, coupler_angle, rocker_angle]);
                let t1 = by(0.15) * sin_crank_angle;
                phi_q[1] = t1;
                phi_q[2] = lit(1.0);
                let t2 = by(-0.15) * cos_crank_angle;
                phi_q[3] = t2;
                phi_q[4] = lit(-1.0);
                phi_q[5] = t1;
                phi_q[6] = lit(1.0);
                let t3 = by(0.45) * sin_coupler_angle;
                phi_q[7] = t3;
                phi_q[8] = lit(-1.0);
                phi_q[9] = t2;
                phi_q[10] = lit(1.0);
                let t4 = by(-0.45) * cos_coupler_angle;
                phi_q[11] = t4;
                phi_q[12] = lit(-1.0);
                phi_q[13] = t3;
                phi_q[14] = lit(1.0);
                phi_q[15] = by(-0.35) * sin_rocker_angle;
                phi_q[16] = lit(-1.0);
                phi_q[17] = t4;
                phi_q[18] = lit(1.0);
                phi_q[19] = by(0.35) * cos_rocker_angle;
                phi_q[20] = lit(1.0);
                phi_q[21] = by(0.35) * sin_rocker_angle;
                phi_q[22] = lit(1.0);
                phi_q[23] = by(-0.35) * cos_rocker_angle;
            }
        }

        #[doc(hidden)]
        impl<S: Real> absolute::Absolute<S, NQ, NC> for FourBar<S> {
            fn layout(&self) -> &'static absolute::Layout {
                const { &Self::LAYOUT_ }
            }

            /// Residuals of the constraints, m or rad; the rows stand in the table of this module.
            ///
            /// 17 add, 6 mul, 3 sin_cos.
            fn phi(&self, t: S, q: &[S; 9]) -> [S; 8] {
                let mut phi = [S::lit(0.0); 8];
                let [
                    crank_x,
                    crank_y,
                    crank_angle,
                    coupler_x,
                    coupler_y,
                    coupler_angle,
                    rocker_x,
                    rocker_y,
                    rocker_angle,
                    ..,
                ] = *q;
                let lit = S::lit;
                let by = rt::Factor;
                let (
                    [sin_crank_angle, sin_coupler_angle, sin_rocker_angle],
                    [cos_crank_angle, cos_coupler_angle, cos_rocker_angle],
                ) = S::sin_cos_all([crank_angle, coupler_angle, rocker_angle]);
                let t1 = by(0.15) * cos_crank_angle;
                phi[0] = crank_x - t1;
                let t2 = by(0.15) * sin_crank_angle;
                phi[1] = crank_y - t2;
                let t3 = by(0.45) * cos_coupler_angle;
                phi[2] = coupler_x - crank_x - t1 - t3;
                let t4 = by(0.45) * sin_coupler_angle;
                phi[3] = coupler_y - crank_y - t2 - t4;
                let t5 = by(0.35) * cos_rocker_angle;
                phi[4] = rocker_x - coupler_x - t3 + t5;
                let t6 = by(0.35) * sin_rocker_angle;
                phi[5] = rocker_y - coupler_y - t4 + t6;
                phi[6] = rocker_x - t5 - lit(1.0);
                phi[7] = rocker_y - t6;
                phi
            }

            /// Their rates, `phi_q v - nu`, m/s or rad/s.
            ///
            /// 16 add, 12 mul, 3 sin_cos.
            fn phi_dot(&self, t: S, q: &[S; 9], v: &[S; 9]) -> [S; 8] {
                let mut phi_dot = [S::lit(0.0); 8];
                let crank_angle = q[2];
                let coupler_angle = q[5];
                let rocker_angle = q[8];
                let [
                    crank_vx,
                    crank_vy,
                    crank_omega,
                    coupler_vx,
                    coupler_vy,
                    coupler_omega,
                    rocker_vx,
                    rocker_vy,
                    rocker_omega,
                    ..,
                ] = *v;
                let by = rt::Factor;
                let (
                    [sin_crank_angle, sin_coupler_angle, sin_rocker_angle],
                    [cos_crank_angle, cos_coupler_angle, cos_rocker_angle],
                ) = S::sin_cos_all([crank_angle, coupler_angle, rocker_angle]);
                let t1 = by(0.15) * (crank_omega * sin_crank_angle);
                phi_dot[0] = crank_vx + t1;
                let t2 = by(0.15) * (crank_omega * cos_crank_angle);
                phi_dot[1] = crank_vy - t2;
                let t3 = by(0.45) * (coupler_omega * sin_coupler_angle);
                phi_dot[2] = coupler_vx - crank_vx + t1 + t3;
                let t4 = by(0.45) * (coupler_omega * cos_coupler_angle);
                phi_dot[3] = coupler_vy - crank_vy - t2 - t4;
                let t5 = by(0.35) * (rocker_omega * sin_rocker_angle);
                phi_dot[4] = rocker_vx - coupler_vx + t3 - t5;
                let t6 = by(0.35) * (rocker_omega * cos_rocker_angle);
                phi_dot[5] = rocker_vy - coupler_vy - t4 + t6;
                phi_dot[6] = rocker_vx + t5;
                phi_dot[7] = rocker_vy - t6;
                phi_dot
            }

            fn phi_q(&self, t: S, q: &[S; 9], each: &mut impl FnMut(usize, usize, S)) {
                let places: &[[u32; 2]] = const {
                    &rt::compact::pairs::<24>(&rt::compact::numbers::<48>(&[(
                        1,
                        &[
                            0, 0, 0, 2, 1, 1, 1, 2, 2, 0, 2, 2, 2, 3, 2, 5, 3, 1, 3, 2, 3, 4, 3, 5, 4, 3, 4,
                            5, 4, 6, 4, 8, 5, 4, 5, 5, 5, 7, 5, 8, 6, 6, 6, 8, 7, 7, 7, 8,
                        ],
                        &[],
                    )]))
                };
                let mut entries = [S::lit(0.0); 24];
                self.phi_q_entries(t, q, &mut entries);
                for (&[row, column], entry) in places.iter().zip(entries) {
                    each(row as usize, column as usize, entry);
                }
            }

            /// The shortest step in the norm of `W^-1` that closes `r`: `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 94 add, 143 mul, 9 div, 3 sin_cos, 34 select.
            fn min_norm(&self, t: S, q: &[S; 9], w: &[S; 9], r: &[S; 8], dq: &mut [S; 9]) -> rt::Health<S> {
                rt::Health({
                    let lit = S::lit;
                    let by = rt::Factor;
                    // phi_q W phi_q^T = L D L^T
                    let w_0 = w[0];
                    let crank_angle = q[2];
                    let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                    let w_2 = w[2];
                    let y_0_2 = by(0.15) * sin_crank_angle * w_2;
                    let t1 = by(0.15) * (sin_crank_angle * y_0_2);
                    let d_0 = w_0 + t1;
                    let r_0 = by(1.0) / d_0;
                    let t2 = by(-0.15) * cos_crank_angle;
                    let y_1_2 = t2 * w_2;
                    let g_1_0 = by(0.15) * (sin_crank_angle * y_1_2);
                    let l_1_0 = r_0 * g_1_0;
                    let g_2_0 = t1 - w_0;
                    let l_2_0 = r_0 * g_2_0;
                    let w_1 = w[1];
                    let t3 = cos_crank_angle * y_1_2;
                    let t4 = by(-0.15).mul_add(t3, w_1);
                    let t5 = g_1_0 * l_1_0;
                    let d_1 = t4 - t5;
                    let r_1 = by(1.0) / d_1;
                    let growth_1 = (t4 * r_1).abs();
                    let most_growth = lit(S::MOST_GROWTH);
                    let t6 = most_growth.lt(growth_1);
                    let kept_1 = S::select(t6, lit(0.0), r_1);
                    let g_2_1 = (-g_1_0).mul_add(l_2_0, t2 * y_0_2);
                    let l_2_1 = g_2_1 * kept_1;
                    let g_3_1 = by(-0.15).mul_add(t3, -w_1) - t5;
                    let l_3_1 = g_3_1 * kept_1;
                    let w_3 = w[3];
                    let coupler_angle = q[5];
                    let (sin_coupler_angle, cos_coupler_angle) = coupler_angle.sin_cos();
                    let w_5 = w[5];
                    let y_2_5 = by(0.45) * sin_coupler_angle * w_5;
                    let t7 = by(0.45) * (sin_coupler_angle * y_2_5);
                    let t8 = w_3 + t7;
                    let t9 = d_0 + t8;
                    let r_2 = by(1.0) / (-g_2_1).mul_add(l_2_1, (-g_2_0).mul_add(l_2_0, t9));
                    let growth_2 = (t9 * r_2).abs();
                    let t10 = most_growth.lt(growth_2);
                    let kept_2 = S::select(t10, lit(0.0), r_2);
                    let t11 = by(-0.45) * cos_coupler_angle;
                    let y_3_5 = t11 * w_5;
                    let g_5_2 = by(0.45) * (sin_coupler_angle * y_3_5);
                    let g_3_2 = (-g_2_1).mul_add(l_3_1, (-l_1_0).mul_add(g_2_0, g_1_0 + g_5_2));
                    let l_3_2 = kept_2 * g_3_2;
                    let g_4_2 = t7 - w_3;
                    let l_4_2 = g_4_2 * kept_2;
                    let l_5_2 = g_5_2 * kept_2;
                    let w_4 = w[4];
                    let t12 = cos_coupler_angle * y_3_5;
                    let t13 = by(-0.45).mul_add(t12, w_4);
                    let r_3 = by(1.0) / ((-g_3_2).mul_add(l_3_2, (-g_3_1).mul_add(l_3_1, d_1)) + t13);
                    let growth_3 = (r_3 * (t4 + t13)).abs();
                    let t14 = most_growth.lt(growth_3);
                    let kept_3 = S::select(t14, lit(0.0), r_3);
                    let g_4_3 = (-g_3_2).mul_add(l_4_2, t11 * y_2_5);
                    let l_4_3 = kept_3 * g_4_3;
                    let g_5_3 = (-g_3_2).mul_add(l_5_2, by(-0.45).mul_add(t12, -w_4));
                    let l_5_3 = kept_3 * g_5_3;
                    let w_6 = w[6];
                    let rocker_angle = q[8];
                    let (sin_rocker_angle, cos_rocker_angle) = rocker_angle.sin_cos();
                    let w_8 = w[8];
                    let t15 = sin_rocker_angle * w_8;
                    let y_4_8 = by(-0.35) * t15;
                    let t16 = by(0.35) * sin_rocker_angle;
                    let t17 = (-t16).mul_add(y_4_8, w_6) + t8;
                    let r_4 = by(1.0) / (-g_4_3).mul_add(l_4_3, (-g_4_2).mul_add(l_4_2, t17));
                    let growth_4 = (t17 * r_4).abs();
                    let t18 = most_growth.lt(growth_4);
                    let kept_4 = S::select(t18, lit(0.0), r_4);
                    let t19 = cos_rocker_angle * w_8;
                    let y_5_8 = by(0.35) * t19;
                    let g_5_4 =
                        (-g_4_3).mul_add(l_5_3, (-g_4_2).mul_add(l_5_2, (-t16).mul_add(y_5_8, g_5_2)));
                    let l_5_4 = kept_4 * g_5_4;
                    let y_6_8 = by(0.35) * t15;
                    let t20 = by(0.35) * (sin_rocker_angle * y_6_8);
                    let g_6_4 = w_6 - t20;
                    let l_6_4 = g_6_4 * kept_4;
                    let y_7_8 = by(-0.35) * t19;
                    let t21 = sin_rocker_angle * y_7_8;
                    let g_7_4 = by(-0.35) * t21;
                    let l_7_4 = g_7_4 * kept_4;
                    let w_7 = w[7];
                    let t22 = by(0.35) * cos_rocker_angle;
                    let t23 = t22.mul_add(y_5_8, w_7) + t13;
                    let r_5 = by(1.0)
                        / (-g_5_4).mul_add(l_5_4, (-g_5_3).mul_add(l_5_3, (-g_5_2).mul_add(l_5_2, t23)));
                    let growth_5 = (t23 * r_5).abs();
                    let t24 = most_growth.lt(growth_5);
                    let kept_5 = S::select(t24, lit(0.0), r_5);
                    let g_6_5 = (-g_5_4).mul_add(l_6_4, t22 * y_6_8);
                    let l_6_5 = kept_5 * g_6_5;
                    let t25 = by(0.35) * (cos_rocker_angle * y_7_8);
                    let g_7_5 = (-g_5_4).mul_add(l_7_4, w_7 + t25);
                    let l_7_5 = kept_5 * g_7_5;
                    let t26 = w_6 + t20;
                    let r_6 = by(1.0) / (-g_6_5).mul_add(l_6_5, (-g_6_4).mul_add(l_6_4, t26));
                    let growth_6 = (t26 * r_6).abs();
                    let t27 = most_growth.lt(growth_6);
                    let kept_6 = S::select(t27, lit(0.0), r_6);
                    let g_7_6 = (-g_6_5).mul_add(l_7_5, (-g_6_4).mul_add(l_7_4, by(0.35) * t21));
                    let l_7_6 = kept_6 * g_7_6;
                    let t28 = w_7 - t25;
                    let r_7 = by(1.0)
                        / (-g_7_6).mul_add(l_7_6, (-g_7_5).mul_add(l_7_5, (-g_7_4).mul_add(l_7_4, t28)));
                    let growth_7 = (t28 * r_7).abs();
                    let t29 = most_growth.lt(growth_7);
                    // (phi_q W phi_q^T) mu = r
                    let dphi_0 = r[0];
                    let dphi_1 = r[1];
                    let t30 = dphi_0 * l_1_0;
                    let b_1 = dphi_1 - t30;
                    let dphi_2 = r[2];
                    let b_2 = (-b_1).mul_add(l_2_1, (-dphi_0).mul_add(l_2_0, dphi_2));
                    let dphi_3 = r[3];
                    let b_3 = (-l_3_2).mul_add(b_2, (-b_1).mul_add(l_3_1, dphi_3 - t30));
                    let dphi_4 = r[4];
                    let b_4 = (-l_4_3).mul_add(b_3, (-l_4_2).mul_add(b_2, dphi_4));
                    let dphi_5 = r[5];
                    let b_5 = (-l_5_4).mul_add(b_4, (-l_5_3).mul_add(b_3, (-l_5_2).mul_add(b_2, dphi_5)));
                    let dphi_6 = r[6];
                    let b_6 = (-l_6_5).mul_add(b_5, (-l_6_4).mul_add(b_4, dphi_6));
                    let dphi_7 = r[7];
                    let mu_7 = S::select(t29, lit(0.0), r_7)
                        * (-l_7_6).mul_add(b_6, (-l_7_5).mul_add(b_5, (-l_7_4).mul_add(b_4, dphi_7)));
                    let mu_6 = (-l_7_6).mul_add(mu_7, kept_6 * b_6);
                    let mu_5 = (-l_7_5).mul_add(mu_7, (-l_6_5).mul_add(mu_6, kept_5 * b_5));
                    let mu_4 =
                        (-l_7_4).mul_add(mu_7, (-l_6_4).mul_add(mu_6, (-l_5_4).mul_add(mu_5, kept_4 * b_4)));
                    let mu_3 = (-l_5_3).mul_add(mu_5, (-l_4_3).mul_add(mu_4, kept_3 * b_3));
                    let mu_2 =
                        (-l_5_2).mul_add(mu_5, (-l_4_2).mul_add(mu_4, (-l_3_2).mul_add(mu_3, kept_2 * b_2)));
                    let mu_1 = (-l_3_1).mul_add(mu_3, (-l_2_1).mul_add(mu_2, b_1 * kept_1));
                    let t31 = mu_3 + mu_1;
                    let mu_0 = (-l_1_0).mul_add(t31, (-l_2_0).mul_add(mu_2, dphi_0 * r_0));
                    // Results
                    dq[0] = w_0 * (mu_0 - mu_2);
                    dq[1] = w_1 * (mu_1 - mu_3);
                    dq[2] = y_1_2.mul_add(t31, y_0_2 * (mu_2 + mu_0));
                    dq[3] = w_3 * (mu_2 - mu_4);
                    dq[4] = w_4 * (mu_3 - mu_5);
                    dq[5] = y_3_5.mul_add(mu_5 + mu_3, y_2_5 * (mu_4 + mu_2));
                    dq[6] = w_6 * (mu_6 + mu_4);
                    dq[7] = w_7 * (mu_7 + mu_5);
                    dq[8] = y_7_8.mul_add(mu_7, y_6_8.mul_add(mu_6, y_5_8.mul_add(mu_5, y_4_8 * mu_4)));
                    let t32 = S::select(t6, lit(0.0), growth_1)
                        .max(S::select(t10, lit(0.0), growth_2))
                        .max(S::select(t14, lit(0.0), growth_3));
                    let t33 = t32
                        .max(S::select(t18, lit(0.0), growth_4))
                        .max(S::select(t24, lit(0.0), growth_5))
                        .max(S::select(t27, lit(0.0), growth_6));
                    by(1.0) / t33.max(S::select(t29, lit(0.0), growth_7))
                })
            }

            /// Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body.
            fn inverse_mass(&self) -> [S; 9] {
                let mut inverse_mass = [S::lit(0.0); 9];
                let lit = S::lit;
                inverse_mass[0] = lit(3.3333333333333335);
                inverse_mass[1] = lit(3.3333333333333335);
                inverse_mass[2] = lit(444.44444444444446);
                inverse_mass[3] = lit(1.1111111111111112);
                inverse_mass[4] = lit(1.1111111111111112);
                inverse_mass[5] = lit(16.46090534979424);
                inverse_mass[6] = lit(1.4285714285714286);
                inverse_mass[7] = lit(1.4285714285714286);
                inverse_mass[8] = lit(34.98542274052478);
                inverse_mass
            }

            fn length(&self) -> S {
                S::lit(0.45)
            }

            fn start_position(&self) -> [Start<S>; 9] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 3] = [
                    self.start.crank.of_centre([lit(0.0), lit(0.0)]),
                    self.start.coupler.of_centre([lit(0.0), lit(0.0)]),
                    self.start.rocker.of_centre([lit(0.0), lit(0.0)]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn start_velocity(&self, q: &[S; 9]) -> [Start<S>; 9] {
                let lit = S::lit;
                let bodies: [[Start<S>; 3]; 3] = [
                    self.start.crank.velocity_of_centre([lit(0.0), lit(0.0)], q[2]),
                    self.start.coupler.velocity_of_centre([lit(0.0), lit(0.0)], q[5]),
                    self.start.rocker.velocity_of_centre([lit(0.0), lit(0.0)], q[8]),
                ];
                core::array::from_fn(|k| bodies[k / 3][k % 3])
            }

            fn refine(&self, t: S, q: &[S; 9]) -> Option<([S; 9], [S; 9])> {
                rt::singular::refine::<Self, 9, 8, 18>(self, t, q)
            }
        }

        impl<S: Real> FourBar<S> {
            /// Accelerations and multipliers by a rank-revealing decomposition.
            #[cold]
            fn accelerate(
                &self,
                t: S,
                u: &Held<S>,
                x: &[S; 18],
            ) -> Result<absolute::Acceleration<S, NQ, NC>, Fault> {
                let (q, _): ([S; 9], [S; 9]) = absolute::split(x);
                let (mut force, mut gamma) = ([S::lit(0.0); 9], [S::lit(0.0); 8]);
                self.free(t, u, x, &mut force, &mut gamma);
                let inverse_mass = absolute::Absolute::<S, NQ, NC>::inverse_mass(self);
                absolute::accelerate(t, &inverse_mass, &force, &gamma, |rows| {
                    absolute::phi_q_matrix(self, t, &q, rows)
                })
            }
        }

        impl<S: Real> State<S> {
            /// Accelerations and multipliers; multipliers that redundancy leaves undetermined have their minimum norm.
            fn solved_(&self, common: &Common<S>) -> ([S; 9], [S; 8]) {
                let (mut dx, mut lambda) = ([S::lit(0.0); 18], [S::lit(0.0); 8]);
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
            pub fn undetermined(&self) -> [bool; 8] {
                match self.mechanism.accelerate(self.time, &self.held, &self.absolute_()) {
                    Ok(solution) => solution.undetermined,
                    Err(_) => [true; 8],
                }
            }
        }

        impl<S: Real> rt::lanes::Pack for FourBar<S> {
            type Packed<T: Scalar> = FourBar<T>;

            #[allow(unused_variables)]
            fn pack<T: Scalar, const N: usize>(
                &self,
                all: [&Self; N],
                number: impl Fn([S; N]) -> T,
            ) -> FourBar<T> {
                let same = |s| number([s; N]);
                let start = Starts {
                    crank: self.start.crank.map(same),
                    coupler: self.start.coupler.map(same),
                    rocker: self.start.rocker.map(same),
                };
                FourBar { start }
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
                let mut turns = [T::ZERO.to_turns(); 3];
                for k in 0..3 {
                    turns[k] = number(rt::Vector::from_fn(|i| S::of_turns(all[i].turns[k]))).to_turns();
                }
                let contact = ();
                rt::Held { input, switches, turns, of_loops, contact }
            }

            const WATCHED: bool = false;
            #[inline]
            fn are_calm<T: Scalar>(typical: &[T; 2], t: T, held: &Held<T>, x: &[T; 2]) -> T {
                rt::charts::are_calm::<Self, T, _>(typical, t, &held.of_loops, x)
            }

            #[inline]
            fn are_short<T: Scalar>(typical: &[T; 2], held: &Held<T>, legs: [&[T; 2]; 2]) -> T {
                rt::charts::are_short::<Self, T, _>(typical, &held.of_loops, legs)
            }

            #[inline(never)]
            fn look<T: Scalar>(all: &FourBar<T>, t: T, held: &mut Held<T>, x: &[T; 2], due: T) -> T {
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

        impl<S: Real> rt::Linear for FourBar<S> {
            type Lifted<const K: usize> = FourBar<rt::Dual<S, K>>;
            type In<T: Real> = FourBar<T>;
            type Derivatives = [[S; 2]; 2];

            fn lift<const K: usize>(
                &self,
                held: &Held<S>,
            ) -> (FourBar<rt::Dual<S, K>>, Held<rt::Dual<S, K>>) {
                self.in_numbers(held, rt::Dual::constant)
            }

            fn in_numbers<T: Real>(&self, held: &Held<S>, number: impl Fn(S) -> T) -> (FourBar<T>, Held<T>) {
                use rt::lanes::Pack;
                let of_one = |[s]: [S; 1]| number(s);
                (self.pack([self], of_one), Self::pack_held(held, [held], of_one))
            }

            #[inline]
            fn rate_in_numbers<T: Real>(
                &self,
                held: &Held<S>,
                number: impl Fn(S) -> T,
            ) -> (FourBar<T>, Held<T>) {
                let value = Start::free(T::ZERO);
                let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
                let start = Starts { crank: zero, coupler: zero, rocker: zero };
                let own = FourBar { start };
                let same = |[s]: [S; 1]| S::of_plain(s.plain());
                let of_loops = rt::held::Loops::<S>::packed(&held.of_loops, [&held.of_loops], &same);
                let held = &rt::Held { of_loops, ..*held };
                (own, <Self as rt::lanes::Pack>::pack_held(held, [held], |[s]: [S; 1]| number(s)))
            }

            fn rate_reads_time(&self) -> bool {
                false
            }

            fn jacobian(
                &self,
                t: S,
                u: &Self::U,
                x: &[S; 2],
                by_x: &mut [[S; 2]; 2],
                by_t: Option<&mut [S; 2]>,
            ) -> rt::Health<S> {
                let colours = rt::linear::Colours::<2, 2> {
                    of_columns: [0, 1],
                    columns: [[2, 0], [2, 1]],
                    knows_time: false,
                };
                rt::linear::by_directions::<Self, 2, 2, 2>(self, (t, u, x), &colours, by_x, by_t)
            }
        }

        impl<S: Real> rt::Ports for FourBar<S> {
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

        impl<S: Real> rt::Described for FourBar<S> {
            const TABLES: &'static described::Tables = &described::Tables {
                name: "FourBar",
                docs: "Four-bar linkage: its loop is a dyad, solved in closed form in several charts.",
                report: described::Report {
                    rung: 3,
                    formulation: "joint coordinates",
                    reason: "the loops are solved in closed form, so that no constraint is left",
                    operations: OPERATIONS,
                    degrees_of_freedom: NDOF,
                },
                bodies: &[
                    described::Body { name: "crank", ports: &["a", "b"], contour: 0, first: 0 },
                    described::Body { name: "coupler", ports: &["b", "c"], contour: 0, first: 9 },
                    described::Body { name: "rocker", ports: &["d", "c"], contour: 0, first: 18 },
                ],
                ground: &[
                    described::GroundPort { name: "a", moves: false, first: 27 },
                    described::GroundPort { name: "d", moves: false, first: 31 },
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
                        first: 35,
                    },
                    described::Part {
                        name: "crank_coupler",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(0), port: 1 },
                            described::Frame { argument: "b", body: Some(1), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 36,
                    },
                    described::Part {
                        name: "coupler_rocker",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: Some(1), port: 1 },
                            described::Frame { argument: "b", body: Some(2), port: 1 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 37,
                    },
                    described::Part {
                        name: "pivot",
                        kind: "revolute",
                        pair: Some("revolute"),
                        frames: &[
                            described::Frame { argument: "a", body: None, port: 1 },
                            described::Frame { argument: "b", body: Some(2), port: 0 },
                        ],
                        sizes: &["pin_diameter"],
                        first: 38,
                    },
                ],
                parameters: &[],
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
                ],
                reads: &[None, None],
            };
            const OBSERVED: &'static [(&'static str, &'static str)] = &State::<S>::OBSERVED;
            const DECLARATION: &'static str = "/// Four-bar linkage: its loop is a dyad, solved in closed form in several charts.\npub FourBar {\n    gravity: 9.81 m/s^2;\n    ground { port a: (0, 0) m; port d: (1, 0) m; }\n    body crank {\n        mass: 0.3 kg;\n        inertia: 0.00225 kg*m^2;\n        port a: (-0.15, 0) m;\n        port b: (0.15, 0) m;\n        start angle: 60 deg, locked;\n    }\n    body coupler {\n        mass: 0.9 kg;\n        inertia: 0.06075 kg*m^2;\n        port b: (-0.45, 0) m;\n        port c: (0.45, 0) m;\n        start angle: 30 deg;\n    }\n    body rocker {\n        mass: 0.7 kg;\n        inertia: 0.7 kg * (0.7 m)^2 / 12;\n        port d: (-0.35, 0) m;\n        port c: (0.35, 0) m;\n        start x: 1 m;\n        start angle: 95 deg;\n    }\n    revolute drive(ground.a, crank.a);\n    revolute crank_coupler(crank.b, coupler.b);\n    revolute coupler_rocker(coupler.c, rocker.c);\n    revolute pivot(ground.d, rocker.d);\n    output drive.force;\n}\n";
            const FILES: &'static [(&'static str, &'static str)] = &[];
            fn figure(&self, t: S, index: usize) -> Option<S> {
                let constants: &[f64] = const {
                    &[
                        0.3,
                        0.00225,
                        0.0,
                        -0.15,
                        0.0,
                        0.0,
                        0.15,
                        0.0,
                        0.0,
                        0.9,
                        0.06075,
                        0.0,
                        -0.45,
                        0.0,
                        0.0,
                        0.45,
                        0.0,
                        0.0,
                        0.7,
                        0.028583333333333332,
                        0.0,
                        -0.35,
                        0.0,
                        0.0,
                        0.35,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        1.0,
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
                self.crank.each(
                    ["crank.x", "crank.y", "crank.angle", "crank.vx", "crank.vy", "crank.omega"],
                    &mut *each,
                );
                self.coupler.each(
                    ["coupler.x", "coupler.y", "coupler.angle", "coupler.vx", "coupler.vy", "coupler.omega"],
                    &mut *each,
                );
                self.rocker.each(
                    ["rocker.x", "rocker.y", "rocker.angle", "rocker.vx", "rocker.vy", "rocker.omega"],
                    &mut *each,
                );
            }
        }

        impl<S: Scalar> core::fmt::Display for Starts<S> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                rt::start::write_starts(*self, f)
            }
        }

        impl<S: Real> FourBar<S> {
            fn placed(&self, x: &[S; 18]) -> Starts<S> {
                let lit = S::lit;
                Starts {
                    crank: self.start.crank.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[0], x[1], x[2]],
                        [x[9], x[10], x[11]],
                    ),
                    coupler: self.start.coupler.with_centre_at(
                        [lit(0.0), lit(0.0)],
                        [x[3], x[4], x[5]],
                        [x[12], x[13], x[14]],
                    ),
                    rocker: self.start.rocker.with_centre_at(
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
                self.mechanism.placed(&<FourBar<S> as rt::Statics>::full(self))
            }
        }

        impl<S: Real> rt::Statics for FourBar<S> {
            type Full = [S; 18];
            type Rows = [S; 8];
            type Starts = Starts<S>;
            const COORDINATES: &'static [&'static str] = Self::LAYOUT_.coordinates;
            const ROWS: &'static [&'static str] = Self::LAYOUT_.rows;
            const STATES: &'static [(&'static str, &'static str)] = &[];
            fn full(state: &State<S>) -> [S; 18] {
                {
                    let mut x = state.absolute_();
                    rt::turns::add(&state.held.turns, &mut x, &[&[2], &[5], &[8]]);
                    x
                }
            }

            /// What vanishes at rest: applied forces `Q` (N, N, N m per body) that reactions do not balance, residuals of the
            /// constraints, rates of the first-order states, without accelerations.
            #[cold]
            fn equations(&self, t: S, u: &Self::U, x: &[S; 18], lambda: &[S; 8], each: &mut impl FnMut(S)) {
                let (mut force, mut x_dot) = ([S::lit(0.0); 9], [S::lit(0.0); 0]);
                let lit = S::lit;
                force[0] = lit(0.0);
                force[1] = lit(-2.943);
                force[2] = lit(0.0);
                force[3] = lit(0.0);
                force[4] = lit(-8.829);
                force[5] = lit(0.0);
                force[6] = lit(0.0);
                force[7] = lit(-6.867);
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

        impl<S: Scalar> FourBar<S> {
            /// The right-hand side and the multipliers: `M a + phi_q^T lambda = Q`, `phi_q a = gamma`.
            /// Returns the smallest pivot ratio of the factorisation.
            ///
            /// 102 add, 152 mul, 9 div, 5 neg, 3 sin_cos, 34 select.
            #[inline(always)]
            fn dynamics(&self, t: S, u: &Held<S>, x: &[S; 18], dx: &mut [S; 18], lambda: &mut [S; 8]) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                // Arms from G to each port: the entries of phi_q, and of phi_q M^-1
                let crank_angle = x[2];
                let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                let coupler_angle = x[5];
                let (sin_coupler_angle, cos_coupler_angle) = coupler_angle.sin_cos();
                let rocker_angle = x[8];
                let (sin_rocker_angle, cos_rocker_angle) = rocker_angle.sin_cos();
                let t1 = by(0.35) * cos_rocker_angle;
                let t2 = by(0.35) * sin_rocker_angle;
                let y_0_2 = by(66.66666666666667) * sin_crank_angle;
                let y_1_2 = by(-66.66666666666667) * cos_crank_angle;
                let y_2_5 = by(7.407407407407407) * sin_coupler_angle;
                let y_3_5 = by(-7.407407407407407) * cos_coupler_angle;
                let y_4_8 = by(-12.244897959183673) * sin_rocker_angle;
                let y_5_8 = by(12.244897959183673) * cos_rocker_angle;
                let y_6_8 = by(12.244897959183673) * sin_rocker_angle;
                let y_7_8 = by(-12.244897959183673) * cos_rocker_angle;
                // phi_q M^-1 phi_q^T = L D L^T
                let t3 = by(0.15) * (sin_crank_angle * y_0_2);
                let r_0 = by(1.0) / (t3 + lit(3.3333333333333335));
                let g_1_0 = by(0.15) * (sin_crank_angle * y_1_2);
                let l_1_0 = r_0 * g_1_0;
                let g_2_0 = t3 - lit(3.3333333333333335);
                let l_2_0 = r_0 * g_2_0;
                let t4 = by(0.15) * (cos_crank_angle * y_1_2);
                let t5 = g_1_0.mul_add(l_1_0, t4);
                let r_1 = by(1.0) / (lit(3.3333333333333335) - t5);
                let growth_1 = ((t4 - lit(3.3333333333333335)) * r_1).abs();
                let most_growth = lit(S::MOST_GROWTH);
                let t6 = most_growth.lt(growth_1);
                let kept_1 = S::select(t6, lit(0.0), r_1);
                let g_2_1 = (-g_1_0).mul_add(l_2_0, by(-0.15) * cos_crank_angle * y_0_2);
                let l_2_1 = g_2_1 * kept_1;
                let g_3_1 = lit(-3.3333333333333335) - t5;
                let l_3_1 = kept_1 * g_3_1;
                let t7 = by(0.45) * (sin_coupler_angle * y_2_5);
                let t8 = t3 + t7 + lit(4.444444444444445);
                let r_2 = by(1.0) / (-g_2_1).mul_add(l_2_1, (-g_2_0).mul_add(l_2_0, t8));
                let growth_2 = (t8 * r_2).abs();
                let t9 = most_growth.lt(growth_2);
                let kept_2 = S::select(t9, lit(0.0), r_2);
                let g_5_2 = by(0.45) * (sin_coupler_angle * y_3_5);
                let g_3_2 = (-g_2_1).mul_add(l_3_1, (-l_1_0).mul_add(g_2_0, g_1_0 + g_5_2));
                let l_3_2 = kept_2 * g_3_2;
                let g_4_2 = t7 - lit(1.1111111111111112);
                let l_4_2 = g_4_2 * kept_2;
                let l_5_2 = g_5_2 * kept_2;
                let t10 = by(0.45) * (cos_coupler_angle * y_3_5);
                let t11 = lit(4.444444444444445) - t10;
                let r_3 = by(1.0) / (-g_3_2).mul_add(l_3_2, (-g_3_1).mul_add(l_3_1, t11 - t5));
                let growth_3 = (r_3 * (t4 - t11)).abs();
                let t12 = most_growth.lt(growth_3);
                let kept_3 = S::select(t12, lit(0.0), r_3);
                let g_4_3 = (-g_3_2).mul_add(l_4_2, by(-0.45) * cos_coupler_angle * y_2_5);
                let l_4_3 = kept_3 * g_4_3;
                let g_5_3 = (-g_3_2).mul_add(l_5_2, lit(-1.1111111111111112) - t10);
                let l_5_3 = kept_3 * g_5_3;
                let t13 = (-t2).mul_add(y_4_8, t7) + lit(2.5396825396825395);
                let r_4 = by(1.0) / (-g_4_3).mul_add(l_4_3, (-g_4_2).mul_add(l_4_2, t13));
                let growth_4 = (t13 * r_4).abs();
                let t14 = most_growth.lt(growth_4);
                let kept_4 = S::select(t14, lit(0.0), r_4);
                let g_5_4 = (-g_4_3).mul_add(l_5_3, (-g_4_2).mul_add(l_5_2, (-t2).mul_add(y_5_8, g_5_2)));
                let l_5_4 = kept_4 * g_5_4;
                let t15 = by(0.35) * (sin_rocker_angle * y_6_8);
                let g_6_4 = lit(1.4285714285714286) - t15;
                let l_6_4 = g_6_4 * kept_4;
                let t16 = sin_rocker_angle * y_7_8;
                let g_7_4 = by(-0.35) * t16;
                let l_7_4 = g_7_4 * kept_4;
                let t17 = (-t1).mul_add(y_5_8, t10) - lit(2.5396825396825395);
                let r_5 = by(1.0) / -g_5_4.mul_add(l_5_4, g_5_3.mul_add(l_5_3, g_5_2.mul_add(l_5_2, t17)));
                let growth_5 = (t17 * r_5).abs();
                let t18 = most_growth.lt(growth_5);
                let kept_5 = S::select(t18, lit(0.0), r_5);
                let g_6_5 = (-g_5_4).mul_add(l_6_4, t1 * y_6_8);
                let l_6_5 = kept_5 * g_6_5;
                let t19 = by(0.35) * (cos_rocker_angle * y_7_8);
                let g_7_5 = (-g_5_4).mul_add(l_7_4, t19) + lit(1.4285714285714286);
                let l_7_5 = kept_5 * g_7_5;
                let t20 = t15 + lit(1.4285714285714286);
                let r_6 = by(1.0) / (-g_6_5).mul_add(l_6_5, (-g_6_4).mul_add(l_6_4, t20));
                let growth_6 = (t20 * r_6).abs();
                let t21 = most_growth.lt(growth_6);
                let kept_6 = S::select(t21, lit(0.0), r_6);
                let g_7_6 = (-g_6_5).mul_add(l_7_5, (-g_6_4).mul_add(l_7_4, by(0.35) * t16));
                let l_7_6 = kept_6 * g_7_6;
                let t22 = t19 - lit(1.4285714285714286);
                let r_7 = by(1.0) / -g_7_6.mul_add(l_7_6, g_7_5.mul_add(l_7_5, g_7_4.mul_add(l_7_4, t22)));
                let growth_7 = (t22 * r_7).abs();
                let t23 = most_growth.lt(growth_7);
                // Multipliers: (phi_q M^-1 phi_q^T) lambda = phi_q M^-1 Q - gamma
                let crank_omega = x[11];
                let t24 = crank_omega * crank_omega;
                let b_0 = by(0.15) * (cos_crank_angle * t24);
                let t25 = (-l_1_0).mul_add(b_0, by(0.15) * sin_crank_angle * t24);
                let b_1 = t25 - lit(9.81);
                let coupler_omega = x[14];
                let t26 = coupler_omega * coupler_omega;
                let t27 = by(0.45) * (cos_coupler_angle * t26);
                let b_2 = (-l_2_1).mul_add(b_1, (-l_2_0).mul_add(b_0, b_0 + t27));
                let t28 = by(0.45) * (sin_coupler_angle * t26);
                let b_3 = (-l_3_2).mul_add(b_2, (-l_3_1).mul_add(b_1, t25 + t28));
                let rocker_omega = x[17];
                let t29 = rocker_omega * rocker_omega;
                let t30 = by(0.35) * (cos_rocker_angle * t29);
                let b_4 = (-l_4_3).mul_add(b_3, (-l_4_2).mul_add(b_2, t27 - t30));
                let t31 = by(0.35) * (sin_rocker_angle * t29);
                let b_5 = (-l_5_4).mul_add(b_4, (-l_5_3).mul_add(b_3, (-l_5_2).mul_add(b_2, t28 - t31)));
                let b_6 = (-l_6_5).mul_add(b_5, (-l_6_4).mul_add(b_4, t30));
                let lambda_pivot_y = S::select(t23, lit(0.0), r_7)
                    * ((-l_7_6).mul_add(b_6, (-l_7_5).mul_add(b_5, (-l_7_4).mul_add(b_4, t31))) - lit(9.81));
                let lambda_pivot_x = (-l_7_6).mul_add(lambda_pivot_y, kept_6 * b_6);
                let lambda_coupler_rocker_y =
                    (-l_7_5).mul_add(lambda_pivot_y, (-l_6_5).mul_add(lambda_pivot_x, kept_5 * b_5));
                let lambda_coupler_rocker_x = (-l_7_4).mul_add(
                    lambda_pivot_y,
                    (-l_6_4).mul_add(lambda_pivot_x, (-l_5_4).mul_add(lambda_coupler_rocker_y, kept_4 * b_4)),
                );
                let lambda_crank_coupler_y = (-l_5_3).mul_add(
                    lambda_coupler_rocker_y,
                    (-l_4_3).mul_add(lambda_coupler_rocker_x, kept_3 * b_3),
                );
                let lambda_crank_coupler_x = (-l_5_2).mul_add(
                    lambda_coupler_rocker_y,
                    (-l_4_2).mul_add(
                        lambda_coupler_rocker_x,
                        (-l_3_2).mul_add(lambda_crank_coupler_y, kept_2 * b_2),
                    ),
                );
                let lambda_drive_y = (-l_3_1)
                    .mul_add(lambda_crank_coupler_y, (-l_2_1).mul_add(lambda_crank_coupler_x, kept_1 * b_1));
                let t32 = lambda_crank_coupler_y + lambda_drive_y;
                let lambda_drive_x =
                    (-l_1_0).mul_add(t32, (-l_2_0).mul_add(lambda_crank_coupler_x, r_0 * b_0));
                // Results
                dx[0] = x[9];
                dx[1] = x[10];
                dx[2] = crank_omega;
                dx[3] = x[12];
                dx[4] = x[13];
                dx[5] = coupler_omega;
                dx[6] = x[15];
                dx[7] = x[16];
                dx[8] = rocker_omega;
                dx[9] = by(3.3333333333333335) * (lambda_crank_coupler_x - lambda_drive_x);
                dx[10] = by(3.3333333333333335).mul_add(lambda_crank_coupler_y - lambda_drive_y, lit(-9.81));
                dx[11] = -y_1_2.mul_add(t32, y_0_2 * (lambda_crank_coupler_x + lambda_drive_x));
                dx[12] = by(1.1111111111111112) * (lambda_coupler_rocker_x - lambda_crank_coupler_x);
                dx[13] = by(1.1111111111111112)
                    .mul_add(lambda_coupler_rocker_y - lambda_crank_coupler_y, lit(-9.81));
                dx[14] = -y_3_5.mul_add(
                    lambda_coupler_rocker_y + lambda_crank_coupler_y,
                    y_2_5 * (lambda_coupler_rocker_x + lambda_crank_coupler_x),
                );
                dx[15] = by(-1.4285714285714286) * (lambda_pivot_x + lambda_coupler_rocker_x);
                dx[16] =
                    by(-1.4285714285714286).mul_add(lambda_pivot_y + lambda_coupler_rocker_y, lit(-9.81));
                dx[17] = -y_7_8.mul_add(
                    lambda_pivot_y,
                    y_6_8.mul_add(
                        lambda_pivot_x,
                        y_5_8.mul_add(lambda_coupler_rocker_y, y_4_8 * lambda_coupler_rocker_x),
                    ),
                );
                lambda[0] = lambda_drive_x;
                lambda[1] = lambda_drive_y;
                lambda[2] = lambda_crank_coupler_x;
                lambda[3] = lambda_crank_coupler_y;
                lambda[4] = lambda_coupler_rocker_x;
                lambda[5] = lambda_coupler_rocker_y;
                lambda[6] = lambda_pivot_x;
                lambda[7] = lambda_pivot_y;
                let t33 = S::select(t6, lit(0.0), growth_1)
                    .max(S::select(t9, lit(0.0), growth_2))
                    .max(S::select(t12, lit(0.0), growth_3));
                let t34 = t33
                    .max(S::select(t14, lit(0.0), growth_4))
                    .max(S::select(t18, lit(0.0), growth_5))
                    .max(S::select(t21, lit(0.0), growth_6));
                by(1.0) / t34.max(S::select(t23, lit(0.0), growth_7))
            }

            /// Applied forces `Q` (N, N, N m per body) and `gamma`, for the rank-revealing solution.
            ///
            /// 4 add, 17 mul, 3 sin_cos.
            #[cold]
            fn free(&self, t: S, u: &Held<S>, x: &[S; 18], force: &mut [S; 9], gamma: &mut [S; 8]) {
                let crank_angle = x[2];
                let coupler_angle = x[5];
                let rocker_angle = x[8];
                let crank_omega = x[11];
                let coupler_omega = x[14];
                let rocker_omega = x[17];
                let lit = S::lit;
                let by = rt::Factor;
                force[0] = lit(0.0);
                force[1] = lit(-2.943);
                force[2] = lit(0.0);
                force[3] = lit(0.0);
                force[4] = lit(-8.829);
                force[5] = lit(0.0);
                force[6] = lit(0.0);
                force[7] = lit(-6.867);
                force[8] = lit(0.0);
                let (
                    [sin_crank_angle, sin_coupler_angle, sin_rocker_angle],
                    [cos_crank_angle, cos_coupler_angle, cos_rocker_angle],
                ) = S::sin_cos_all([crank_angle, coupler_angle, rocker_angle]);
                let t1 = crank_omega * crank_omega;
                let t2 = by(-0.15) * (cos_crank_angle * t1);
                gamma[0] = t2;
                let t3 = by(-0.15) * (sin_crank_angle * t1);
                gamma[1] = t3;
                let t4 = coupler_omega * coupler_omega;
                let t5 = by(0.45) * (cos_coupler_angle * t4);
                gamma[2] = t2 - t5;
                let t6 = by(0.45) * (sin_coupler_angle * t4);
                gamma[3] = t3 - t6;
                let t7 = rocker_omega * rocker_omega;
                let t8 = cos_rocker_angle * t7;
                gamma[4] = by(0.35).mul_add(t8, -t5);
                let t9 = sin_rocker_angle * t7;
                gamma[5] = by(0.35).mul_add(t9, -t6);
                gamma[6] = by(-0.35) * t8;
                gamma[7] = by(-0.35) * t9;
            }
        }

        impl<S: Scalar> FourBar<S> {
            /// The right-hand side in the coordinates crank.angle.
            /// Returns the smallest square of a dyad's measure.
            ///
            /// 26 add, 50 mul, 3 div, 2 neg, 1 sqrt, 1 sin_cos, 3 select.
            #[inline(always)]
            fn motion_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                dx: &mut [S; 2],
            ) -> S {
                let [last_area_0, ..] = m.determinants;
                let [crank_angle, crank_omega, ..] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                // Masses and forces along the coordinates: M a = Q
                let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                let t1 = cos_crank_angle - lit(0.3);
                let loop_0_x = by(0.3).mul_add(cos_crank_angle, lit(-1.0));
                let loop_0_y = by(0.3) * sin_crank_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.32));
                let square_0 = (-along_0).mul_add(along_0, by(0.49) * distance_0);
                let area_0 =
                    lit(0.0).max(square_0).sqrt() * S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0));
                let inverse_0 = by(1.0) / distance_0;
                let way_0_y = area_0 * inverse_0;
                let way_0_x = along_0 * inverse_0;
                let cross_0_0 = (-t1).mul_add(way_0_y, sin_crank_angle * way_0_x);
                let cross_0_1 = sin_crank_angle + cross_0_0;
                let reciprocal_0 = by(1.0) / area_0;
                let ratio_0_0 = by(0.3) * cross_0_1 * reciprocal_0;
                let momentum_0_1 = by(0.11433333333333333) * ratio_0_0;
                let ratio_0_1 = by(0.3) * cross_0_0 * reciprocal_0;
                let dot_0_0 = -sin_crank_angle.mul_add(way_0_y, t1 * way_0_x);
                let dot_0_1 = dot_0_0 - t1;
                let t2 = by(0.135) * ratio_0_1;
                let momentum_0_2 = by(-0.135).mul_add(dot_0_1, by(0.243) * ratio_0_1);
                let rocker_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let still_0 = (-(by(4.4145) * -(loop_0_x + rocker_arm_x))).mul_add(
                    ratio_0_1,
                    by(-3.09015).mul_add(cos_crank_angle, by(3.4335) * rocker_arm_x * ratio_0_0),
                );
                let t3 = ratio_0_1 * ratio_0_1;
                let t4 = along_0 + lit(0.49);
                let t5 = ratio_0_0 * ratio_0_0;
                let t6 = momentum_0_2.mul_add(
                    reciprocal_0 * by(-0.49).mul_add(t5, by(-0.3).mul_add(dot_0_0, t4 * t3)),
                    momentum_0_1
                        * (reciprocal_0 * (-t4).mul_add(t5, by(-0.3).mul_add(dot_0_1, by(0.81) * t3))),
                );
                // Results
                dx[0] = crank_omega;
                let crank_angle_acceleration = (-(crank_omega * crank_omega))
                    .mul_add((-(cross_0_1 * ratio_0_1)).mul_add(lit(0.135) - t2, t6), still_0)
                    * (by(1.0)
                        / ratio_0_1.mul_add(
                            momentum_0_2,
                            ratio_0_0.mul_add(momentum_0_1, (-t2).mul_add(dot_0_1, lit(0.09))),
                        ));
                dx[1] = crank_angle_acceleration;
                by(2.5195263290501386) * square_0
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            ///
            /// 26 add, 51 mul, 2 div, 2 neg, 1 sqrt, 1 sin_cos, 3 select, 2 other.
            fn pose_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                q: &mut [S; 9],
                v: &mut [S; 9],
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let crank_angle = x[0];
                let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                let crank_x = by(0.15) * cos_crank_angle;
                q[0] = crank_x;
                let crank_y = by(0.15) * sin_crank_angle;
                q[1] = crank_y;
                q[2] = crank_angle;
                let loop_0_x = by(0.3).mul_add(cos_crank_angle, lit(-1.0));
                let loop_0_y = by(0.3) * sin_crank_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.32));
                let inverse_0 = by(1.0) / distance_0;
                let way_0_x = along_0 * inverse_0;
                let square_0 = (-along_0).mul_add(along_0, by(0.49) * distance_0);
                let last_area_0 = m.determinants[0];
                let area_0 =
                    lit(0.0).max(square_0).sqrt() * S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0));
                let way_0_y = area_0 * inverse_0;
                let rocker_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let coupler_arm_x = -(loop_0_x + rocker_arm_x);
                let t1 = by(0.5) * coupler_arm_x;
                q[3] = crank_x + t1 + crank_x;
                let rocker_arm_y = loop_0_y.mul_add(way_0_x, loop_0_x * way_0_y);
                let coupler_arm_y = -(loop_0_y + rocker_arm_y);
                let t2 = by(0.5) * coupler_arm_y;
                q[4] = crank_y + t2 + crank_y;
                let last_angle_2 = m.angles[2].angle;
                let last_cosine_2 = m.angles[2].cos;
                let coupler_sin = by(1.1111111111111112) * coupler_arm_y;
                let last_sine_2 = m.angles[2].sin;
                let coupler_cos = by(1.1111111111111112) * coupler_arm_x;
                let t3 = last_angle_2
                    + (-last_sine_2)
                        .mul_add(coupler_cos, last_cosine_2 * coupler_sin)
                        .atan2(last_sine_2.mul_add(coupler_sin, last_cosine_2 * coupler_cos));
                q[5] = t3;
                q[6] = by(-0.5).mul_add(rocker_arm_x, lit(1.0));
                q[7] = by(-0.5) * rocker_arm_y;
                let last_angle_1 = m.angles[1].angle;
                let last_cosine_1 = m.angles[1].cos;
                let rocker_sin = by(-1.4285714285714286) * rocker_arm_y;
                let last_sine_1 = m.angles[1].sin;
                let rocker_cos = by(-1.4285714285714286) * rocker_arm_x;
                let t4 = last_angle_1
                    + (-last_sine_1)
                        .mul_add(rocker_cos, last_cosine_1 * rocker_sin)
                        .atan2(last_sine_1.mul_add(rocker_sin, last_cosine_1 * rocker_cos));
                q[8] = t4;
                let crank_omega = x[1];
                let crank_vx = by(-0.15) * (crank_omega * sin_crank_angle);
                v[0] = crank_vx;
                let crank_vy = by(0.15) * (crank_omega * cos_crank_angle);
                v[1] = crank_vy;
                v[2] = crank_omega;
                let cross_0_0 = (-(cos_crank_angle - lit(0.3))).mul_add(way_0_y, sin_crank_angle * way_0_x);
                let reciprocal_0 = by(1.0) / area_0;
                let coupler_angle_rate = crank_omega * (by(0.3) * cross_0_0 * reciprocal_0);
                v[3] = (-t2).mul_add(coupler_angle_rate, crank_vx + crank_vx);
                v[4] = t1.mul_add(coupler_angle_rate, crank_vy + crank_vy);
                v[5] = coupler_angle_rate;
                let rocker_angle_rate =
                    crank_omega * (by(0.3) * (sin_crank_angle + cross_0_0) * reciprocal_0);
                v[6] = by(0.5) * rocker_arm_y * rocker_angle_rate;
                v[7] = by(-0.5) * rocker_arm_x * rocker_angle_rate;
                v[8] = rocker_angle_rate;
                by(2.5195263290501386) * square_0
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart_0(&self, t: S, q: &[S; 9], v: &[S; 9], x: &mut [S; 2]) {
                x[0] = q[2];
                x[1] = v[2];
            }

            /// What is to be remembered of a state, and the smallest square of a dyad's measure.
            ///
            /// 18 add, 34 mul, 4 div, 2 neg, 2 sqrt, 3 sin_cos, 10 select, 2 other.
            fn remember_0(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                memory: &mut rt::charts::Continuation<S, 1, 3, 1, 0>,
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let crank_angle = x[0];
                memory.coordinates[0].last = crank_angle;
                let (sin_crank_angle, cos_crank_angle) = crank_angle.sin_cos();
                let loop_0_x = by(0.3).mul_add(cos_crank_angle, lit(-1.0));
                let loop_0_y = by(0.3) * sin_crank_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.32));
                let square_0 = (-along_0).mul_add(along_0, by(0.49) * distance_0);
                let last_area_0 = m.determinants[0];
                let area_0 =
                    lit(0.0).max(square_0).sqrt() * S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0));
                let inverse_0 = by(1.0) / distance_0;
                let way_0_y = area_0 * inverse_0;
                let way_0_x = along_0 * inverse_0;
                let cross_0_0 = (-(cos_crank_angle - lit(0.3))).mul_add(way_0_y, sin_crank_angle * way_0_x);
                let reciprocal_0 = by(1.0) / area_0;
                let ratio_0_1 = by(0.3) * cross_0_0 * reciprocal_0;
                let ratio_0_0 = by(0.3) * (sin_crank_angle + cross_0_0) * reciprocal_0;
                let t1 = by(0.1)
                    / lit(1.0).max(
                        ratio_0_1.abs().max(
                            (by(0.63) * lit(1.0).max((ratio_0_0 - ratio_0_1).abs()) / square_0.sqrt())
                                .max(ratio_0_0.abs()),
                        ),
                    );
                memory.coordinates[0].reach = t1;
                memory.time.last = t;
                memory.time.reach = lit(1e30);
                memory.angles[0].angle = crank_angle;
                memory.angles[0].cos = cos_crank_angle;
                memory.angles[0].sin = sin_crank_angle;
                let last_angle_1 = m.angles[1].angle;
                let last_cosine_1 = m.angles[1].cos;
                let rocker_arm_y = loop_0_y.mul_add(way_0_x, loop_0_x * way_0_y);
                let rocker_sin = by(-1.4285714285714286) * rocker_arm_y;
                let last_sine_1 = m.angles[1].sin;
                let rocker_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let rocker_cos = by(-1.4285714285714286) * rocker_arm_x;
                let t2 = last_angle_1
                    + (-last_sine_1)
                        .mul_add(rocker_cos, last_cosine_1 * rocker_sin)
                        .atan2(last_sine_1.mul_add(rocker_sin, last_cosine_1 * rocker_cos));
                memory.angles[1].angle = t2;
                let (sin_t2, cos_t2) = t2.sin_cos();
                memory.angles[1].cos = cos_t2;
                memory.angles[1].sin = sin_t2;
                let last_angle_2 = m.angles[2].angle;
                let last_cosine_2 = m.angles[2].cos;
                let coupler_sin = by(1.1111111111111112) * -(loop_0_y + rocker_arm_y);
                let last_sine_2 = m.angles[2].sin;
                let coupler_cos = by(1.1111111111111112) * -(loop_0_x + rocker_arm_x);
                let t3 = last_angle_2
                    + (-last_sine_2)
                        .mul_add(coupler_cos, last_cosine_2 * coupler_sin)
                        .atan2(last_sine_2.mul_add(coupler_sin, last_cosine_2 * coupler_cos));
                memory.angles[2].angle = t3;
                let (sin_t3, cos_t3) = t3.sin_cos();
                memory.angles[2].cos = cos_t3;
                memory.angles[2].sin = sin_t3;
                memory.determinants[0] = area_0;
                by(2.5195263290501386) * square_0
            }

            /// The same of a pose and velocity.
            ///
            /// 1 add, 4 mul, 3 sin_cos.
            #[cold]
            fn remember_pose_0(
                &self,
                t: S,
                q: &[S; 9],
                v: &[S; 9],
                memory: &mut rt::charts::Continuation<S, 1, 3, 1, 0>,
            ) -> S {
                let crank_angle = q[2];
                let coupler_angle = q[5];
                let rocker_angle = q[8];
                let lit = S::lit;
                let by = rt::Factor;
                memory.coordinates[0].last = crank_angle;
                memory.coordinates[0].reach = lit(0.0);
                memory.time.last = t;
                memory.time.reach = lit(0.0);
                memory.angles[0].angle = crank_angle;
                let (
                    [sin_crank_angle, sin_rocker_angle, sin_coupler_angle],
                    [cos_crank_angle, cos_rocker_angle, cos_coupler_angle],
                ) = S::sin_cos_all([crank_angle, rocker_angle, coupler_angle]);
                memory.angles[0].cos = cos_crank_angle;
                memory.angles[0].sin = sin_crank_angle;
                memory.angles[1].angle = rocker_angle;
                memory.angles[1].cos = cos_rocker_angle;
                memory.angles[1].sin = sin_rocker_angle;
                memory.angles[2].angle = coupler_angle;
                memory.angles[2].cos = cos_coupler_angle;
                memory.angles[2].sin = sin_coupler_angle;
                let t1 = (-sin_coupler_angle).mul_add(cos_rocker_angle, cos_coupler_angle * sin_rocker_angle);
                memory.determinants[0] = by(0.63) * t1;
                t1 * t1
            }

            /// The right-hand side in the coordinates rocker.angle.
            /// Returns the smallest square of a dyad's measure.
            ///
            /// 26 add, 52 mul, 3 div, 2 neg, 1 sqrt, 1 sin_cos, 3 select.
            #[inline(never)]
            fn motion_1(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                dx: &mut [S; 2],
            ) -> S {
                let [last_area_0, ..] = m.determinants;
                let [rocker_angle, rocker_omega, ..] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                // Masses and forces along the coordinates: M a = Q
                let (sin_rocker_angle, cos_rocker_angle) = rocker_angle.sin_cos();
                let t1 = cos_rocker_angle + lit(0.7);
                let loop_0_x = by(-0.7).mul_add(cos_rocker_angle, lit(-1.0));
                let loop_0_y = by(-0.7) * sin_rocker_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.72));
                let square_0 = (-along_0).mul_add(along_0, by(0.09) * distance_0);
                let area_0 =
                    S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0)) * lit(0.0).max(square_0).sqrt();
                let inverse_0 = by(1.0) / distance_0;
                let way_0_y = area_0 * inverse_0;
                let way_0_x = along_0 * inverse_0;
                let cross_0_0 = (-t1).mul_add(way_0_y, sin_rocker_angle * way_0_x);
                let reciprocal_0 = by(1.0) / area_0;
                let ratio_0_0 = by(-0.7) * (sin_rocker_angle + cross_0_0) * reciprocal_0;
                let t2 = along_0 + lit(0.09);
                let ratio_0_1 = by(-0.7) * cross_0_0 * reciprocal_0;
                let t3 = by(0.45) * t2;
                let momentum_0_0 = (-t3).mul_add(ratio_0_1, by(0.09) * ratio_0_0);
                let momentum_0_2 = (-t3).mul_add(ratio_0_0, by(0.243) * ratio_0_1);
                let crank_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let still_0 = (-(by(4.4145) * -(loop_0_x + crank_arm_x))).mul_add(
                    ratio_0_1,
                    (-(by(10.3005) * crank_arm_x)).mul_add(ratio_0_0, by(-2.40345) * cos_rocker_angle),
                );
                let t4 = ratio_0_1 * ratio_0_1;
                let dot_0_0 = -sin_rocker_angle.mul_add(way_0_y, t1 * way_0_x);
                let t5 = ratio_0_0 * ratio_0_0;
                let t6 = momentum_0_0
                    * (reciprocal_0 * (-t2).mul_add(t5, by(0.7).mul_add(dot_0_0 - t1, by(0.81) * t4)));
                let t7 = momentum_0_2
                    .mul_add(reciprocal_0 * t2.mul_add(t4, by(-0.09).mul_add(t5, by(0.7) * dot_0_0)), t6);
                let t8 = rocker_omega
                    * rocker_omega
                    * (by(0.45) * area_0 * ratio_0_0 * ratio_0_1).mul_add(ratio_0_0 - ratio_0_1, t7);
                // Results
                dx[0] = rocker_omega;
                dx[1] = (still_0 - t8)
                    * (by(1.0)
                        / (ratio_0_1.mul_add(momentum_0_2, ratio_0_0 * momentum_0_0)
                            + lit(0.11433333333333333)));
                by(13.717421124828531) * square_0
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            ///
            /// 26 add, 53 mul, 2 div, 2 neg, 1 sqrt, 1 sin_cos, 3 select, 2 other.
            fn pose_1(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                q: &mut [S; 9],
                v: &mut [S; 9],
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let rocker_angle = x[0];
                let (sin_rocker_angle, cos_rocker_angle) = rocker_angle.sin_cos();
                let loop_0_x = by(-0.7).mul_add(cos_rocker_angle, lit(-1.0));
                let loop_0_y = by(-0.7) * sin_rocker_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.72));
                let inverse_0 = by(1.0) / distance_0;
                let way_0_x = along_0 * inverse_0;
                let last_area_0 = m.determinants[0];
                let square_0 = (-along_0).mul_add(along_0, by(0.09) * distance_0);
                let area_0 =
                    S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0)) * lit(0.0).max(square_0).sqrt();
                let way_0_y = area_0 * inverse_0;
                let crank_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let crank_x = by(0.5) * crank_arm_x;
                q[0] = crank_x;
                let crank_arm_y = loop_0_y.mul_add(way_0_x, loop_0_x * way_0_y);
                let crank_y = by(0.5) * crank_arm_y;
                q[1] = crank_y;
                let last_angle_0 = m.angles[0].angle;
                let last_cosine_0 = m.angles[0].cos;
                let crank_sin = by(3.3333333333333335) * crank_arm_y;
                let last_sine_0 = m.angles[0].sin;
                let crank_cos = by(3.3333333333333335) * crank_arm_x;
                let t1 = last_angle_0
                    + (-last_sine_0)
                        .mul_add(crank_cos, last_cosine_0 * crank_sin)
                        .atan2(last_sine_0.mul_add(crank_sin, last_cosine_0 * crank_cos));
                q[2] = t1;
                let coupler_arm_x = -(loop_0_x + crank_arm_x);
                q[3] = by(0.5).mul_add(crank_arm_x + coupler_arm_x, crank_x);
                let coupler_arm_y = -(loop_0_y + crank_arm_y);
                q[4] = by(0.5).mul_add(crank_arm_y + coupler_arm_y, crank_y);
                let last_angle_2 = m.angles[2].angle;
                let last_cosine_2 = m.angles[2].cos;
                let coupler_sin = by(1.1111111111111112) * coupler_arm_y;
                let last_sine_2 = m.angles[2].sin;
                let coupler_cos = by(1.1111111111111112) * coupler_arm_x;
                let t2 = last_angle_2
                    + (-last_sine_2)
                        .mul_add(coupler_cos, last_cosine_2 * coupler_sin)
                        .atan2(last_sine_2.mul_add(coupler_sin, last_cosine_2 * coupler_cos));
                q[5] = t2;
                q[6] = by(0.35).mul_add(cos_rocker_angle, lit(1.0));
                q[7] = by(0.35) * sin_rocker_angle;
                q[8] = rocker_angle;
                let rocker_omega = x[1];
                let cross_0_0 = (-(cos_rocker_angle + lit(0.7))).mul_add(way_0_y, sin_rocker_angle * way_0_x);
                let reciprocal_0 = by(1.0) / area_0;
                let crank_angle_rate =
                    rocker_omega * (by(-0.7) * (sin_rocker_angle + cross_0_0) * reciprocal_0);
                let t3 = crank_arm_y * crank_angle_rate;
                let crank_vx = by(-0.5) * t3;
                v[0] = crank_vx;
                let t4 = crank_arm_x * crank_angle_rate;
                let crank_vy = by(0.5) * t4;
                v[1] = crank_vy;
                v[2] = crank_angle_rate;
                let coupler_angle_rate = rocker_omega * (by(-0.7) * cross_0_0 * reciprocal_0);
                v[3] = by(-0.5).mul_add(coupler_arm_y.mul_add(coupler_angle_rate, t3), crank_vx);
                v[4] = by(0.5).mul_add(coupler_arm_x.mul_add(coupler_angle_rate, t4), crank_vy);
                v[5] = coupler_angle_rate;
                v[6] = by(-0.35) * rocker_omega * sin_rocker_angle;
                v[7] = by(0.35) * rocker_omega * cos_rocker_angle;
                v[8] = rocker_omega;
                by(13.717421124828531) * square_0
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart_1(&self, t: S, q: &[S; 9], v: &[S; 9], x: &mut [S; 2]) {
                x[0] = q[8];
                x[1] = v[8];
            }

            /// What is to be remembered of a state, and the smallest square of a dyad's measure.
            ///
            /// 18 add, 34 mul, 4 div, 2 neg, 2 sqrt, 3 sin_cos, 10 select, 2 other.
            fn remember_1(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                memory: &mut rt::charts::Continuation<S, 1, 3, 1, 0>,
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let rocker_angle = x[0];
                memory.coordinates[0].last = rocker_angle;
                let (sin_rocker_angle, cos_rocker_angle) = rocker_angle.sin_cos();
                let last_area_0 = m.determinants[0];
                let loop_0_x = by(-0.7).mul_add(cos_rocker_angle, lit(-1.0));
                let loop_0_y = by(-0.7) * sin_rocker_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.72));
                let square_0 = (-along_0).mul_add(along_0, by(0.09) * distance_0);
                let area_0 =
                    S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0)) * lit(0.0).max(square_0).sqrt();
                let inverse_0 = by(1.0) / distance_0;
                let way_0_y = area_0 * inverse_0;
                let way_0_x = along_0 * inverse_0;
                let cross_0_0 = (-(cos_rocker_angle + lit(0.7))).mul_add(way_0_y, sin_rocker_angle * way_0_x);
                let reciprocal_0 = by(1.0) / area_0;
                let ratio_0_1 = by(-0.7) * cross_0_0 * reciprocal_0;
                let ratio_0_0 = by(-0.7) * (sin_rocker_angle + cross_0_0) * reciprocal_0;
                let t1 = by(0.1)
                    / lit(1.0).max(
                        ratio_0_1.abs().max(
                            (by(0.27) * lit(1.0).max((ratio_0_0 - ratio_0_1).abs()) / square_0.sqrt())
                                .max(ratio_0_0.abs()),
                        ),
                    );
                memory.coordinates[0].reach = t1;
                memory.time.last = t;
                memory.time.reach = lit(1e30);
                let last_angle_0 = m.angles[0].angle;
                let last_cosine_0 = m.angles[0].cos;
                let crank_arm_y = loop_0_y.mul_add(way_0_x, loop_0_x * way_0_y);
                let crank_sin = by(3.3333333333333335) * crank_arm_y;
                let last_sine_0 = m.angles[0].sin;
                let crank_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let crank_cos = by(3.3333333333333335) * crank_arm_x;
                let t2 = last_angle_0
                    + (-last_sine_0)
                        .mul_add(crank_cos, last_cosine_0 * crank_sin)
                        .atan2(last_sine_0.mul_add(crank_sin, last_cosine_0 * crank_cos));
                memory.angles[0].angle = t2;
                let (sin_t2, cos_t2) = t2.sin_cos();
                memory.angles[0].cos = cos_t2;
                memory.angles[0].sin = sin_t2;
                memory.angles[1].angle = rocker_angle;
                memory.angles[1].cos = cos_rocker_angle;
                memory.angles[1].sin = sin_rocker_angle;
                let last_angle_2 = m.angles[2].angle;
                let last_cosine_2 = m.angles[2].cos;
                let coupler_sin = by(1.1111111111111112) * -(loop_0_y + crank_arm_y);
                let last_sine_2 = m.angles[2].sin;
                let coupler_cos = by(1.1111111111111112) * -(loop_0_x + crank_arm_x);
                let t3 = last_angle_2
                    + (-last_sine_2)
                        .mul_add(coupler_cos, last_cosine_2 * coupler_sin)
                        .atan2(last_sine_2.mul_add(coupler_sin, last_cosine_2 * coupler_cos));
                memory.angles[2].angle = t3;
                let (sin_t3, cos_t3) = t3.sin_cos();
                memory.angles[2].cos = cos_t3;
                memory.angles[2].sin = sin_t3;
                memory.determinants[0] = area_0;
                by(13.717421124828531) * square_0
            }

            /// The same of a pose and velocity.
            ///
            /// 1 add, 4 mul, 3 sin_cos.
            #[cold]
            fn remember_pose_1(
                &self,
                t: S,
                q: &[S; 9],
                v: &[S; 9],
                memory: &mut rt::charts::Continuation<S, 1, 3, 1, 0>,
            ) -> S {
                let crank_angle = q[2];
                let coupler_angle = q[5];
                let rocker_angle = q[8];
                let lit = S::lit;
                let by = rt::Factor;
                memory.coordinates[0].last = rocker_angle;
                memory.coordinates[0].reach = lit(0.0);
                memory.time.last = t;
                memory.time.reach = lit(0.0);
                memory.angles[0].angle = crank_angle;
                let (
                    [sin_crank_angle, sin_rocker_angle, sin_coupler_angle],
                    [cos_crank_angle, cos_rocker_angle, cos_coupler_angle],
                ) = S::sin_cos_all([crank_angle, rocker_angle, coupler_angle]);
                memory.angles[0].cos = cos_crank_angle;
                memory.angles[0].sin = sin_crank_angle;
                memory.angles[1].angle = rocker_angle;
                memory.angles[1].cos = cos_rocker_angle;
                memory.angles[1].sin = sin_rocker_angle;
                memory.angles[2].angle = coupler_angle;
                memory.angles[2].cos = cos_coupler_angle;
                memory.angles[2].sin = sin_coupler_angle;
                let t1 = (-cos_crank_angle).mul_add(sin_coupler_angle, sin_crank_angle * cos_coupler_angle);
                memory.determinants[0] = by(-0.27) * t1;
                t1 * t1
            }

            /// The right-hand side in the coordinates coupler.angle.
            /// Returns the smallest square of a dyad's measure.
            ///
            /// 26 add, 50 mul, 3 div, 2 neg, 1 sqrt, 1 sin_cos, 3 select.
            #[inline(never)]
            fn motion_2(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                dx: &mut [S; 2],
            ) -> S {
                let [last_area_0, ..] = m.determinants;
                let [coupler_angle, coupler_omega, ..] = *x;
                let lit = S::lit;
                let by = rt::Factor;
                // Masses and forces along the coordinates: M a = Q
                let (sin_coupler_angle, cos_coupler_angle) = coupler_angle.sin_cos();
                let t1 = cos_coupler_angle - lit(0.9);
                let loop_0_x = by(0.9).mul_add(cos_coupler_angle, lit(-1.0));
                let loop_0_y = by(0.9) * sin_coupler_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.4));
                let inverse_0 = by(1.0) / distance_0;
                let way_0_x = along_0 * inverse_0;
                let square_0 = (-along_0).mul_add(along_0, by(0.09) * distance_0);
                let area_0 =
                    S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0)) * lit(0.0).max(square_0).sqrt();
                let way_0_y = area_0 * inverse_0;
                let dot_0_0 = -sin_coupler_angle.mul_add(way_0_y, t1 * way_0_x);
                let cross_0_0 = (-t1).mul_add(way_0_y, sin_coupler_angle * way_0_x);
                let reciprocal_0 = by(1.0) / area_0;
                let ratio_0_0 = by(0.9) * (sin_coupler_angle + cross_0_0) * reciprocal_0;
                let t2 = by(0.405) * dot_0_0;
                let momentum_0_0 = by(0.09).mul_add(ratio_0_0, t2);
                let ratio_0_1 = by(0.9) * cross_0_0 * reciprocal_0;
                let momentum_0_1 = by(0.11433333333333333) * ratio_0_1;
                let crank_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let still_0 = (-(by(10.3005) * crank_arm_x)).mul_add(
                    ratio_0_0,
                    by(-3.97305)
                        .mul_add(cos_coupler_angle, by(3.4335) * -(loop_0_x + crank_arm_x) * ratio_0_1),
                );
                let t3 = ratio_0_1 * ratio_0_1;
                let t4 = along_0 + lit(0.09);
                let t5 = ratio_0_0 * ratio_0_0;
                let t6 = momentum_0_0
                    * (reciprocal_0 * (-t4).mul_add(t5, by(-0.9).mul_add(dot_0_0 - t1, by(0.49) * t3)));
                let t7 = momentum_0_1
                    .mul_add(reciprocal_0 * by(-0.09).mul_add(t5, by(-0.9).mul_add(dot_0_0, t4 * t3)), t6);
                let force_0 = (-(coupler_omega * coupler_omega)).mul_add(
                    (cross_0_0 * ratio_0_0).mul_add(by(-0.405).mul_add(ratio_0_0, lit(0.405)), t7),
                    still_0,
                );
                // Results
                dx[0] = coupler_omega;
                let coupler_angle_acceleration = by(1.0)
                    / ratio_0_1.mul_add(
                        momentum_0_1,
                        ratio_0_0.mul_add(momentum_0_0, t2.mul_add(ratio_0_0, lit(0.243))),
                    )
                    * force_0;
                dx[1] = coupler_angle_acceleration;
                by(22.675736961451246) * square_0
            }

            /// Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.
            ///
            /// 26 add, 52 mul, 2 div, 2 neg, 1 sqrt, 1 sin_cos, 3 select, 2 other.
            fn pose_2(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                q: &mut [S; 9],
                v: &mut [S; 9],
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let coupler_angle = x[0];
                let (sin_coupler_angle, cos_coupler_angle) = coupler_angle.sin_cos();
                let loop_0_x = by(0.9).mul_add(cos_coupler_angle, lit(-1.0));
                let loop_0_y = by(0.9) * sin_coupler_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.4));
                let inverse_0 = by(1.0) / distance_0;
                let way_0_x = along_0 * inverse_0;
                let last_area_0 = m.determinants[0];
                let square_0 = (-along_0).mul_add(along_0, by(0.09) * distance_0);
                let area_0 =
                    S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0)) * lit(0.0).max(square_0).sqrt();
                let way_0_y = area_0 * inverse_0;
                let crank_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let crank_x = by(0.5) * crank_arm_x;
                q[0] = crank_x;
                let crank_arm_y = loop_0_y.mul_add(way_0_x, loop_0_x * way_0_y);
                let crank_y = by(0.5) * crank_arm_y;
                q[1] = crank_y;
                let last_angle_0 = m.angles[0].angle;
                let last_cosine_0 = m.angles[0].cos;
                let crank_sin = by(3.3333333333333335) * crank_arm_y;
                let last_sine_0 = m.angles[0].sin;
                let crank_cos = by(3.3333333333333335) * crank_arm_x;
                let t1 = last_angle_0
                    + (-last_sine_0)
                        .mul_add(crank_cos, last_cosine_0 * crank_sin)
                        .atan2(last_sine_0.mul_add(crank_sin, last_cosine_0 * crank_cos));
                q[2] = t1;
                q[3] = by(0.45).mul_add(cos_coupler_angle, crank_x) + crank_x;
                q[4] = by(0.45).mul_add(sin_coupler_angle, crank_y) + crank_y;
                q[5] = coupler_angle;
                let rocker_arm_x = -(loop_0_x + crank_arm_x);
                q[6] = by(-0.5).mul_add(rocker_arm_x, lit(1.0));
                let rocker_arm_y = -(loop_0_y + crank_arm_y);
                q[7] = by(-0.5) * rocker_arm_y;
                let last_angle_1 = m.angles[1].angle;
                let last_cosine_1 = m.angles[1].cos;
                let rocker_sin = by(-1.4285714285714286) * rocker_arm_y;
                let last_sine_1 = m.angles[1].sin;
                let rocker_cos = by(-1.4285714285714286) * rocker_arm_x;
                let t2 = last_angle_1
                    + (-last_sine_1)
                        .mul_add(rocker_cos, last_cosine_1 * rocker_sin)
                        .atan2(last_sine_1.mul_add(rocker_sin, last_cosine_1 * rocker_cos));
                q[8] = t2;
                let coupler_omega = x[1];
                let cross_0_0 =
                    (-(cos_coupler_angle - lit(0.9))).mul_add(way_0_y, sin_coupler_angle * way_0_x);
                let reciprocal_0 = by(1.0) / area_0;
                let crank_angle_rate =
                    coupler_omega * (by(0.9) * (sin_coupler_angle + cross_0_0) * reciprocal_0);
                let crank_vx = by(-0.5) * (crank_arm_y * crank_angle_rate);
                v[0] = crank_vx;
                let crank_vy = by(0.5) * (crank_arm_x * crank_angle_rate);
                v[1] = crank_vy;
                v[2] = crank_angle_rate;
                let t3 = by(0.45) * coupler_omega;
                v[3] = (-t3).mul_add(sin_coupler_angle, crank_vx) + crank_vx;
                v[4] = t3.mul_add(cos_coupler_angle, crank_vy) + crank_vy;
                v[5] = coupler_omega;
                let rocker_angle_rate = coupler_omega * (by(0.9) * cross_0_0 * reciprocal_0);
                v[6] = by(0.5) * rocker_arm_y * rocker_angle_rate;
                v[7] = by(-0.5) * rocker_arm_x * rocker_angle_rate;
                v[8] = rocker_angle_rate;
                by(22.675736961451246) * square_0
            }

            /// The joint coordinates and their rates at a pose that closes the joints.
            fn to_chart_2(&self, t: S, q: &[S; 9], v: &[S; 9], x: &mut [S; 2]) {
                x[0] = q[5];
                x[1] = v[5];
            }

            /// What is to be remembered of a state, and the smallest square of a dyad's measure.
            ///
            /// 18 add, 34 mul, 4 div, 2 neg, 2 sqrt, 3 sin_cos, 10 select, 2 other.
            fn remember_2(
                &self,
                t: S,
                u: &Held<S>,
                m: &rt::charts::Continuation<S, 1, 3, 1, 0>,
                x: &[S; 2],
                memory: &mut rt::charts::Continuation<S, 1, 3, 1, 0>,
            ) -> S {
                let lit = S::lit;
                let by = rt::Factor;
                let coupler_angle = x[0];
                memory.coordinates[0].last = coupler_angle;
                let (sin_coupler_angle, cos_coupler_angle) = coupler_angle.sin_cos();
                let last_area_0 = m.determinants[0];
                let loop_0_x = by(0.9).mul_add(cos_coupler_angle, lit(-1.0));
                let loop_0_y = by(0.9) * sin_coupler_angle;
                let distance_0 = loop_0_y.mul_add(loop_0_y, loop_0_x * loop_0_x);
                let along_0 = by(-0.5) * (distance_0 - lit(0.4));
                let square_0 = (-along_0).mul_add(along_0, by(0.09) * distance_0);
                let area_0 =
                    S::select(last_area_0.lt(lit(0.0)), lit(-1.0), lit(1.0)) * lit(0.0).max(square_0).sqrt();
                let inverse_0 = by(1.0) / distance_0;
                let way_0_y = area_0 * inverse_0;
                let way_0_x = along_0 * inverse_0;
                let cross_0_0 =
                    (-(cos_coupler_angle - lit(0.9))).mul_add(way_0_y, sin_coupler_angle * way_0_x);
                let reciprocal_0 = by(1.0) / area_0;
                let ratio_0_1 = by(0.9) * cross_0_0 * reciprocal_0;
                let ratio_0_0 = by(0.9) * (sin_coupler_angle + cross_0_0) * reciprocal_0;
                let t1 = by(0.1)
                    / lit(1.0).max(
                        ratio_0_1.abs().max(
                            (by(0.21) * lit(1.0).max((ratio_0_0 - ratio_0_1).abs()) / square_0.sqrt())
                                .max(ratio_0_0.abs()),
                        ),
                    );
                memory.coordinates[0].reach = t1;
                memory.time.last = t;
                memory.time.reach = lit(1e30);
                let last_angle_0 = m.angles[0].angle;
                let last_cosine_0 = m.angles[0].cos;
                let crank_arm_y = loop_0_y.mul_add(way_0_x, loop_0_x * way_0_y);
                let crank_sin = by(3.3333333333333335) * crank_arm_y;
                let last_sine_0 = m.angles[0].sin;
                let crank_arm_x = (-loop_0_y).mul_add(way_0_y, loop_0_x * way_0_x);
                let crank_cos = by(3.3333333333333335) * crank_arm_x;
                let t2 = last_angle_0
                    + (-last_sine_0)
                        .mul_add(crank_cos, last_cosine_0 * crank_sin)
                        .atan2(last_sine_0.mul_add(crank_sin, last_cosine_0 * crank_cos));
                memory.angles[0].angle = t2;
                let (sin_t2, cos_t2) = t2.sin_cos();
                memory.angles[0].cos = cos_t2;
                memory.angles[0].sin = sin_t2;
                let last_angle_1 = m.angles[1].angle;
                let last_cosine_1 = m.angles[1].cos;
                let rocker_sin = by(-1.4285714285714286) * -(loop_0_y + crank_arm_y);
                let last_sine_1 = m.angles[1].sin;
                let rocker_cos = by(-1.4285714285714286) * -(loop_0_x + crank_arm_x);
                let t3 = last_angle_1
                    + (-last_sine_1)
                        .mul_add(rocker_cos, last_cosine_1 * rocker_sin)
                        .atan2(last_sine_1.mul_add(rocker_sin, last_cosine_1 * rocker_cos));
                memory.angles[1].angle = t3;
                let (sin_t3, cos_t3) = t3.sin_cos();
                memory.angles[1].cos = cos_t3;
                memory.angles[1].sin = sin_t3;
                memory.angles[2].angle = coupler_angle;
                memory.angles[2].cos = cos_coupler_angle;
                memory.angles[2].sin = sin_coupler_angle;
                memory.determinants[0] = area_0;
                by(22.675736961451246) * square_0
            }

            /// The same of a pose and velocity.
            ///
            /// 1 add, 4 mul, 3 sin_cos.
            #[cold]
            fn remember_pose_2(
                &self,
                t: S,
                q: &[S; 9],
                v: &[S; 9],
                memory: &mut rt::charts::Continuation<S, 1, 3, 1, 0>,
            ) -> S {
                let crank_angle = q[2];
                let coupler_angle = q[5];
                let rocker_angle = q[8];
                let lit = S::lit;
                let by = rt::Factor;
                memory.coordinates[0].last = coupler_angle;
                memory.coordinates[0].reach = lit(0.0);
                memory.time.last = t;
                memory.time.reach = lit(0.0);
                memory.angles[0].angle = crank_angle;
                let (
                    [sin_crank_angle, sin_rocker_angle, sin_coupler_angle],
                    [cos_crank_angle, cos_rocker_angle, cos_coupler_angle],
                ) = S::sin_cos_all([crank_angle, rocker_angle, coupler_angle]);
                memory.angles[0].cos = cos_crank_angle;
                memory.angles[0].sin = sin_crank_angle;
                memory.angles[1].angle = rocker_angle;
                memory.angles[1].cos = cos_rocker_angle;
                memory.angles[1].sin = sin_rocker_angle;
                memory.angles[2].angle = coupler_angle;
                memory.angles[2].cos = cos_coupler_angle;
                memory.angles[2].sin = sin_coupler_angle;
                let t1 = (-cos_crank_angle).mul_add(sin_rocker_angle, sin_crank_angle * cos_rocker_angle);
                memory.determinants[0] = by(0.21) * t1;
                t1 * t1
            }
        }
    }
}
