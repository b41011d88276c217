//! Linkages that come next to a flat pose: a difference of two lengths tells which way they go on.

use std::f64::consts::{FRAC_PI_2, PI};

use plm::{Fault, Mechanism, Method, Moment, Sim};

use super::run::{Trace, trace};
use super::theory;

/// A four-bar whose coupler is as long as the ground, with cranks that are nearly alike: flat within their difference.
macro_rules! nearly_parallel {
    ($(#[$doc:meta])* $name:ident, $module:ident { $($item:tt)* }) => {
        plm::mechanism! {
            $(#[$doc])*
            pub $name {
                $($item)*
                param gravity_y: m/s^2 = 0 m/s^2;
                param span: m = 2 m;
                param left_length: m = 0.5 m;
                param right_length: m = 0.5 m;
                gravity: gravity_y;
                ground { port a: (0, 0) m; port d: (span, 0 m); }
                body left {
                    mass: 1 kg;
                    inertia: 0.1 kg*m^2;
                    port low: (-left_length/2, 0 m);
                    port high: (left_length/2, 0 m);
                    start angle: 90 deg, locked;
                    start omega: 3 rad/s, locked;
                }
                body top {
                    mass: 1 kg;
                    inertia: 0.1 kg*m^2;
                    port a: (-span/2, 0 m);
                    port b: (span/2, 0 m);
                    start x: span/2;
                    start y: 0.3 m;
                }
                body right {
                    mass: 1 kg;
                    inertia: 0.1 kg*m^2;
                    port low: (-right_length/2, 0 m);
                    port high: (right_length/2, 0 m);
                    start x: span;
                    start angle: 90 deg;
                }
                revolute foot_left(ground.a, left.low);
                revolute high_left(left.high, top.a);
                revolute high_right(top.b, right.high);
                revolute foot_right(ground.d, right.low);
            }
        }

        impl $name {
            /// With a right crank that is longer by so much, m.
            pub fn differing(by: f64) -> Self {
                Self { right_length: 0.5 + by, ..Self::new() }
            }

            /// Both cranks start at an angle, rad, the left one at a speed, rad/s.
            pub fn from(mut self, angle: f64, speed: f64) -> Self {
                let start = &mut self.start;
                (start.left.angle.value, start.left.omega.value) = (angle, speed);
                (start.right.angle.value, start.top.y.value) = (angle, self.left_length * angle.sin());
                start.top.x.value = 0.5 * self.span + self.left_length * angle.cos();
                self
            }
        }

        impl Pair for $module::State {
            fn energy(&self) -> f64 {
                self.kinetic_energy() + self.gravity_energy()
            }

            fn bars(&self) -> [[f64; 2]; 2] {
                [self.left(), self.right()].map(|bar| [bar.angle, bar.omega])
            }
        }
    };
}

nearly_parallel!(
    /// As it comes.
    NearlyParallel, nearly_parallel {}
);
nearly_parallel!(
    /// In absolute coordinates.
    NearlyParallelAbsolute, nearly_parallel_absolute { formulation: absolute; }
);

plm::mechanism! {
    /// A slider-crank whose rod is nearly as long as its crank of 1 m: at 90 deg it is folded within their difference.
    pub NearlyFolded {
        param rod_length: m = 1 m;
        ground { port o: (0, 0) m; }
        body crank {
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port o: (-0.5, 0) m;
            port pin: (0.5, 0) m;
            start angle: 45 deg, locked;
            start omega: 3 rad/s, locked;
        }
        body rod {
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port pin: (-rod_length/2, 0 m);
            port wrist: (rod_length/2, 0 m);
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

impl Pair for nearly_folded::State {
    fn energy(&self) -> f64 {
        self.kinetic_energy()
    }

    fn bars(&self) -> [[f64; 2]; 2] {
        [self.crank(), self.rod()].map(|bar| [bar.angle, bar.omega])
    }
}

/// What is read of a loop with two bars of nearly the same length.
pub trait Pair {
    /// Energy, J.
    fn energy(&self) -> f64;
    /// Angle, rad, and speed, rad/s, of either bar.
    fn bars(&self) -> [[f64; 2]; 2];
}

/// Energy (relative change) and angle of the right bar, rad.
pub fn swinging<M: Mechanism<S = f64, State: Pair>, I: Method<M>>(
    sim: &mut Sim<M, I>,
    until: f64,
) -> Trace<2> {
    let energy = sim.state().energy();
    trace(sim, until, 0.01, |state| [state.energy() / energy - 1.0, state.bars()[1][0]])
}

/// A run over poses that are nearly flat.
pub struct Passed {
    pub end: Result<(), Fault>,
    /// Largest relative change of the energy.
    pub energy: f64,
    /// The time that the closed form gives for the way to the last pose, less that of the run, s.
    pub late: f64,
    /// Flat poses that were counted.
    pub change_points: u64,
}

/// Turns until the time `until`, s; `time` is that of the way on which a bar starts as given and ends at an angle.
///
/// The bar number `driver` is the one that goes all the way round.
fn pass<M, I>(mut sim: Sim<M, I>, until: f64, driver: usize, time: impl Fn([f64; 2], f64) -> f64) -> Passed
where
    M: Mechanism<S = f64, State: Pair>,
    I: Method<M>,
{
    let (energy, start) = (sim.state().energy(), sim.state().bars()[driver]);
    let mut largest = 0.0_f64;
    let end = sim.run(until, 0.01, |state| largest = largest.max((state.energy() / energy - 1.0).abs()));
    let late = time(start, sim.state().bars()[driver][0]) - sim.state().time();
    Passed { end, energy: largest, late, change_points: sim.stats().change_points }
}

/// The right crank of a nearly parallel four-bar is longer by `by`, m. The shorter crank turns, the other one swings.
pub fn parallel(by: f64, until: f64) -> Result<Passed, Fault> {
    let linkage = NearlyParallel::differing(by);
    let (left, right) = (linkage.left_length, linkage.right_length);
    let (driver, short, long) = if by < 0.0 { (1, right, left) } else { (0, left, right) };
    // Seen from the other side of the paper the right crank is the left one.
    let seen = |angle: f64| if by < 0.0 { PI - angle } else { angle };
    let inertia = |angle: f64| theory::four_bar_inertia([short, 2.0, long, 2.0], seen(angle));
    let time = |[from, speed]: [f64; 2], to: f64| match by {
        // Cranks that are alike turn at constant speed.
        0.0 => (to - from) / speed,
        _ => theory::time_between([from, to], speed, 0.0, inertia),
    };
    Ok(pass(linkage.start()?, until, driver, time))
}

/// The rod of a slider-crank is longer than its crank by `by`, m. The shorter bar turns, the other one swings.
pub fn folding(by: f64, until: f64) -> Result<Passed, Fault> {
    let linkage = NearlyFolded { rod_length: 1.0 + by, ..NearlyFolded::new() };
    let [crank, rod] = [1.0, linkage.rod_length];
    let (driver, short, long) = if by < 0.0 { (1, rod, crank) } else { (0, crank, rod) };
    let inertia = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        // Of the other bar; bars that are alike mirror each other all the way round.
        let far = -short * sin / long;
        let near = if by == 0.0 { cos } else { ((long - short * sin) * (long + short * sin)).sqrt() / long };
        let rate = -short * cos / (long * near);
        // Of each bar the velocity of its end and its rate, by the rate of the driver.
        let bars = [(short, sin, cos, 1.0), (long, far, near, rate)];
        let [(a, pin), (b, wrist)] = [bars[driver], bars[1 - driver]]
            .map(|(length, sin, cos, rate)| (rate, [-length * sin * rate, length * cos * rate]));
        let centre = [pin[0] + 0.5 * wrist[0], pin[1] + 0.5 * wrist[1]];
        a * a / 3.0 + b * b / 12.0 + centre[0].powi(2) + centre[1].powi(2) + (pin[0] + wrist[0]).powi(2)
    };
    let time = |[from, speed]: [f64; 2], to: f64| {
        let sign = speed.signum();
        theory::time_between([sign * from, sign * to], sign * speed, FRAC_PI_2, |angle| inertia(sign * angle))
    };
    Ok(pass(linkage.start()?, until, driver, time))
}
