//! Linkages that pass through poses where their bars lie in one line: the rank of phi_q falls there, and the branches of
//! the motion cross.

use std::f64::consts::{FRAC_PI_2, TAU};

use plm::{Mechanism, Method, Sim};

use super::run::{Trace, gap, trace};
use super::theory::{self, wrapped};

/// What is read of a ladder.
pub trait Ladder {
    const WINDOWS: u32;
    /// Angle of the first upright, rad.
    fn upright(&self) -> f64;
    /// Speed of the first top while the uprights stand upright, m/s.
    fn speed(&self) -> f64;
    /// The gap at the ends of the first and the last top, m.
    fn apart(&self) -> f64;
    /// Difference of the first and the last upright, and angle of the first and last top, rad: other branches have it.
    fn askew(&self) -> f64;
    /// Energy, J.
    fn energy(&self) -> f64;
}

/// Energy (relative change), gap (m), askewness (rad) and angle from upright (rad) of a ladder over so many turns.
pub fn turning<M: Mechanism<S = f64, State: Ladder>, I: Method<M>>(
    sim: &mut Sim<M, I>,
    turns: u32,
    samples: u32,
) -> Trace<4> {
    let turn = theory::ladder_period(M::State::WINDOWS, sim.state().speed());
    let energy = sim.state().energy();
    trace(sim, f64::from(turns) * turn, turn / f64::from(samples), |s| {
        [s.energy() / energy - 1.0, s.apart(), s.askew(), s.upright() - FRAC_PI_2]
    })
}

/// S4 (the N-four-bar mechanism of the IFToMM benchmarks, problem A02): N windows of uprights and tops of 1 m and 1 kg.
///
/// The uprights start upright with the tops at 1 m/s. At the flat pose the mobility rises from 1 to N + 1.
macro_rules! ladder {
    (
        $(#[$doc:meta])* $name:ident, $module:ident { $($item:tt)* }, $windows:literal, $last_up:ident, $last_top:ident,
        $($index:literal $foot:ident)*
    ) => {
        plm::mechanism! {
            $(#[$doc])*
            pub $name {
                $($item)*
                gravity: 9.81 m/s^2;
                ground { $(port $foot: ($index, 0) m;)* }
                repeat i in 0..=$windows {
                    body up[i] {
                        mass: 1 kg;
                        inertia: 1 kg*m^2/12;
                        port low: (-0.5, 0) m;
                        port high: (0.5, 0) m;
                        start x: i*1 m;
                        start y: 0.5 m;
                        start angle: 90 deg;
                        start vx: 0.5 m/s;
                        start omega: -1 rad/s;
                    }
                }
                repeat i in 1..=$windows {
                    body top[i] {
                        mass: 1 kg;
                        inertia: 1 kg*m^2/12;
                        port a: (-0.5, 0) m;
                        port b: (0.5, 0) m;
                        start x: (i - 0.5)*1 m;
                        start y: 1 m;
                        start vx: 1 m/s;
                    }
                    revolute left[i](up[i - 1].high, top[i].a);
                    revolute right[i](top[i].b, up[i].high);
                }
                $(revolute foot[$index](ground.$foot, up[$index].low);)*
            }
        }

        impl Ladder for $module::State {
            const WINDOWS: u32 = $windows;

            fn upright(&self) -> f64 {
                self.up_0().angle
            }

            fn speed(&self) -> f64 {
                self.top_1().vx
            }

            fn apart(&self) -> f64 {
                let (first, last) = (self.up_0(), self.$last_up());
                let left = gap(first.point(0.5, 0.0), self.top_1().point(-0.5, 0.0));
                left.max(gap(last.point(0.5, 0.0), self.$last_top().point(0.5, 0.0)))
            }

            fn askew(&self) -> f64 {
                let lean = (self.up_0().angle - self.$last_up().angle).abs();
                lean.max(self.top_1().angle.abs()).max(self.$last_top().angle.abs())
            }

            fn energy(&self) -> f64 {
                self.kinetic_energy() + self.gravity_energy()
            }
        }
    };
}

ladder!(
    /// One window: the parallelogram of the benchmark.
    Ladder1, ladder1 {}, 1, up_1, top_1, 0 f0 1 f1
);
ladder!(
    /// Two windows.
    Ladder2, ladder2 {}, 2, up_2, top_2, 0 f0 1 f1 2 f2
);
ladder!(
    /// Five windows.
    Ladder5, ladder5 {}, 5, up_5, top_5, 0 f0 1 f1 2 f2 3 f3 4 f4 5 f5
);
ladder!(
    /// Two windows in absolute coordinates, with Baumgarte's stabilisation so slow that there is none.
    Adrift, adrift { formulation: absolute; stabilisation: baumgarte(1e9 s); }, 2, up_2, top_2, 0 f0 1 f1 2 f2
);
ladder!(
    /// Forty windows.
    Ladder40, ladder40 {}, 40, up_40, top_40,
    0 f0 1 f1 2 f2 3 f3 4 f4 5 f5 6 f6 7 f7 8 f8 9 f9 10 f10 11 f11 12 f12 13 f13 14 f14 15 f15 16 f16 17 f17 18 f18
    19 f19 20 f20 21 f21 22 f22 23 f23 24 f24 25 f25 26 f26 27 f27 28 f28 29 f29 30 f30 31 f31 32 f32 33 f33 34 f34
    35 f35 36 f36 37 f37 38 f38 39 f39 40 f40
);

impl Ladder5 {
    /// Its tops start at a speed, m/s.
    pub fn at(speed: f64) -> Self {
        let mut ladder = Self::new();
        let s = &mut ladder.start;
        for up in [&mut s.up_0, &mut s.up_1, &mut s.up_2, &mut s.up_3, &mut s.up_4, &mut s.up_5] {
            (up.vx.value, up.omega.value) = (0.5 * speed, -speed);
        }
        for top in [&mut s.top_1, &mut s.top_2, &mut s.top_3, &mut s.top_4, &mut s.top_5] {
            top.vx.value = speed;
        }
        ladder
    }
}

plm::mechanism! {
    /// A parallelogram of 2 m by 0.5 m without gravity: it turns at constant speed, through two change points a turn.
    pub Parallelogram {
        ground { port a: (0, 0) m; port d: (2, 0) m; }
        body left {
            mass: 1 kg;
            inertia: 1 kg*m^2/48;
            port low: (-0.25, 0) m;
            port high: (0.25, 0) m;
            start angle: 90 deg, locked;
            start omega: 1 rad/s, locked;
        }
        body top { mass: 2 kg; inertia: 2 kg*m^2/3; port a: (-1, 0) m; port b: (1, 0) m; start x: 1 m; start y: 0.5 m; }
        body right {
            mass: 1 kg;
            inertia: 1 kg*m^2/48;
            port low: (-0.25, 0) m;
            port high: (0.25, 0) m;
            start x: 2 m;
            start angle: 90 deg;
        }
        revolute foot_left(ground.a, left.low);
        revolute high_left(left.high, top.a);
        revolute high_right(top.b, right.high);
        revolute foot_right(ground.d, right.low);
    }
}

plm::mechanism! {
    /// Slider-crank with crank and rod of 1 m and a slider: folded, at 90 deg, rank phi_q falls from 8 to 7.
    ///
    /// E. Bayo, A. Avello, Singularity-free augmented Lagrangian algorithms for constrained multibody dynamics, Nonlinear
    /// Dynamics 5, 1994, start it at 45 deg with the slider at -4 m/s.
    pub Folded {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body crank {
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port o: (-0.5, 0) m;
            port pin: (0.5, 0) m;
            start angle: 45 deg, locked;
            start omega: sqrt(8)*1 rad/s, locked;
        }
        body rod {
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port pin: (-0.5, 0) m;
            port wrist: (0.5, 0) m;
            start x: 1.06 m;
            start y: 0.35 m;
            start angle: -45 deg;
        }
        body slider { mass: 1 kg; inertia: 0.01 kg*m^2; port wrist: (0, 0) m; start x: 1.4 m; }
        revolute drive(ground.o, crank.o);
        revolute crank_pin(crank.pin, rod.pin);
        revolute wrist_pin(rod.wrist, slider.wrist);
        prismatic guide(ground.o, slider.wrist);
    }
}

plm::mechanism! {
    /// The same bars with a pin in a slot for the slider, from 60 deg at 6 rad/s: 47.50 J.
    pub EqualBars {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body crank {
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port o: (-0.5, 0) m;
            port pin: (0.5, 0) m;
            start angle: 60 deg, locked;
            start omega: 6 rad/s, locked;
        }
        body rod {
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port pin: (-0.5, 0) m;
            port wrist: (0.5, 0) m;
            start x: 0.75 m;
            start y: 0.43 m;
            start angle: -60 deg;
        }
        revolute drive(ground.o, crank.o);
        revolute crank_pin(crank.pin, rod.pin);
        pin_slot guide(ground.o, rod.wrist);
    }
}

/// Energy (relative change), angle between the bars and angle from that of a turn at constant speed, rad.
pub fn turning_parallelogram<I: Method<Parallelogram>>(
    sim: &mut Sim<Parallelogram, I>,
    turns: u32,
) -> Trace<3> {
    let energy = sim.kinetic_energy();
    trace(sim, f64::from(turns) * TAU, TAU / 100.0, |s| {
        let askew = (s.left().angle - s.right().angle).abs().max(s.top().angle.abs());
        [s.kinetic_energy() / energy - 1.0, askew, s.left().angle - (FRAC_PI_2 + s.time())]
    })
}

/// Energy (J), angle of the rod from the mirror image of the crank (rad), gap at the pin (m).
pub fn folding<I: Method<Folded>>(sim: &mut Sim<Folded, I>, until: f64) -> Trace<3> {
    trace(sim, until, 0.01, |s| {
        let open = gap(s.crank().point(0.5, 0.0), s.rod().point(-0.5, 0.0));
        [s.kinetic_energy() + s.gravity_energy(), wrapped(s.crank().angle + s.rod().angle), open]
    })
}

/// As [`folding`].
pub fn equal_bars<I: Method<EqualBars>>(sim: &mut Sim<EqualBars, I>, until: f64) -> Trace<3> {
    trace(sim, until, 0.01, |s| {
        let open = gap(s.crank().point(0.5, 0.0), s.rod().point(-0.5, 0.0));
        [s.kinetic_energy() + s.gravity_energy(), wrapped(s.crank().angle + s.rod().angle), open]
    })
}
