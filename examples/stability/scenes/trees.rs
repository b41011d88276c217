//! Pendulums.

use std::f64::consts::{FRAC_PI_2, PI};

use plm::{Dopri5, Fault, Method, Sim};

use super::run::{Trace, trace};
use super::theory::{self, G};

plm::mechanism! {
    /// A01, the simple pendulum of 1 m, released horizontally: a bar with J + m d^2 = 1 m d moves as a point at 1 m does.
    pub Pendulum {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.09 kg*m^2;
            port o: (0, 0.9) m;
            start x: -0.9 m;
            start angle: -90 deg, locked;
        }
        revolute hinge(ground.o, bob.o);
    }
}

plm::mechanism! {
    /// Kapitza's pendulum: the same bar upright, 0.1 deg off, on a pivot that moves by a cos(w t).
    pub Kapitza {
        param a: m = 0.05 m;
        param w: rad/s = 100 rad/s;
        gravity: 9.81 m/s^2;
        ground { port o: (0, a*cos(w*t)); }
        body bob {
            mass: 1 kg;
            inertia: 0.09 kg*m^2;
            port o: (0, -0.9) m;
            start y: 0.95 m;
            start angle: 0.1 deg, locked;
            start omega: 0, locked;
        }
        revolute hinge(ground.o, bob.o);
    }
}

/// Point masses of 1 kg on massless links of 1 m, hanging; `inertia` is what a revolute joint asks a point for.
macro_rules! point_chain {
    ($name:ident, $module:ident, $count:literal, $($index:literal $bob:ident [$($above:tt)*])*) => {
        plm::mechanism! {
            /// Point masses in a row, hanging.
            pub $name {
                param inertia: kg*m^2 = 1e-9 kg*m^2;
                gravity: 9.81 m/s^2;
                ground { port o: (0, 0) m; }
                $(body $bob {
                    mass: 1 kg;
                    inertia: inertia;
                    port high: (0, 1) m;
                    port low: (0, 0) m;
                    start y: -($index + 1)*1 m;
                    start angle: 0, locked;
                    start omega: 0, locked;
                })*
                $(revolute pin[$index]($($above)*, $bob.high);)*
            }
        }

        impl $name {
            /// Number of points.
            pub const POINTS: usize = $count;

            /// At rest, with the points at these horizontal places, m, from above.
            pub fn displaced(inertia: f64, places: &[f64; $count]) -> Self {
                let mut chain = Self { inertia, ..Self::new() };
                let mut above = 0.0;
                $(
                    chain.start.$bob.angle.value = (places[$index] - above).asin();
                    above = places[$index];
                )*
                chain
            }
        }

        impl $module::State {
            /// The horizontal places of the points, m, from above.
            pub fn places(&self) -> [f64; $count] {
                [$(self.$bob().x),*]
            }
        }
    };
}
point_chain!(Points2, points2, 2, 0 m0 [ground.o] 1 m1 [m0.low]);
point_chain!(Points5, points5, 5, 0 m0 [ground.o] 1 m1 [m0.low] 2 m2 [m1.low] 3 m3 [m2.low] 4 m4 [m3.low]);

plm::mechanism! {
    /// A load of 1 kg on two bars of 0.5 m whose mass is a parameter, released horizontally.
    pub LightBars {
        param mass: kg = 1e-6 kg;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body upper {
            mass: mass;
            inertia: mass*(0.5 m)^2/12;
            port a: (-0.25, 0) m;
            port b: (0.25, 0) m;
            start angle: 0, locked;
        }
        body lower {
            mass: mass;
            inertia: mass*(0.5 m)^2/12;
            port a: (-0.25, 0) m;
            port b: (0.25, 0) m;
            start x: 0.75 m;
            start angle: 0, locked;
        }
        body load { mass: 1 kg; inertia: 0.01 kg*m^2; port hook: (0, 0) m; start x: 1 m; }
        revolute top(ground.o, upper.a);
        revolute middle(upper.b, lower.a);
        revolute hook(lower.b, load.hook);
        output top.force;
    }
}

/// Angle of A01 less that of the elliptic function (rad), and change of its energy (J).
pub fn phase<I: Method<Pendulum>>(sim: &mut Sim<Pendulum, I>, until: f64, every: f64) -> Trace<2> {
    trace(sim, until, every, |s| {
        let known = theory::pendulum_angle(G.sqrt(), -FRAC_PI_2, s.time());
        [s.bob().angle - known, s.kinetic_energy() + s.gravity_energy()]
    })
}

/// Trace of the matrix that carries (angle, rate) from one period of the pivot to the next near the upright position; the
/// position is stable where it is between -2 and 2 (G. Floquet, Ann. Sci. École Norm. Sup. 12, 1883).
pub fn floquet(a: f64, w: f64) -> Result<f64, Fault> {
    let small = 1e-6;
    let after = |angle: f64, omega: f64| {
        let mut kapitza = Kapitza { a, w, ..Kapitza::new() };
        kapitza.start.bob.angle.value = angle;
        kapitza.start.bob.omega.value = omega;
        let mut sim = kapitza.start_with(Dopri5::new(1e-12))?;
        sim.step(2.0 * PI / w)?;
        Ok((sim.bob().angle, sim.bob().omega))
    };
    // The rates are measured in units of w, so that both columns are of one size.
    Ok((after(small, 0.0)?.0 + after(0.0, small * w)?.1 / w) / small)
}

/// (a w)^2/(2 g l) at which the upright position becomes stable, for a pivot that moves by `a` with l = 1 m.
pub fn kapitza_limit(a: f64) -> Result<f64, Fault> {
    let stable = |ratio: f64| Ok(floquet(a, (2.0 * G * ratio).sqrt() / a)? < 2.0);
    let (mut low, mut high) = (0.9, 1.1);
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if stable(middle)? { high = middle } else { low = middle }
    }
    Ok(0.5 * (low + high))
}

/// Relative error of the frequency of mode `mode` of five hanging points with an inertia, from the phase after 5/4 periods.
///
/// The mode of w^2 l/g = z has the displacements L_4(z), L_3(z), … L_0(z) from above; the one that moves most is
/// measured.
pub fn frequency_error(mode: usize, inertia: f64) -> Result<f64, Fault> {
    let z = theory::laguerre_zeros(5)[mode];
    let shape = [4, 3, 2, 1, 0].map(|order| theory::laguerre(order, z));
    let most = (0..5).max_by(|i, j| shape[*i].abs().total_cmp(&shape[*j].abs())).unwrap_or(4);
    let scale = 1e-5 / shape[most];
    let mut sim = Points5::displaced(inertia, &shape.map(|u| scale * u)).start_with(Dopri5::new(1e-12))?;
    let phase = 2.5 * PI;
    sim.step(phase / (z * G).sqrt())?;
    Ok(-(sim.places()[most] / 1e-5).asin() / phase)
}

/// Speed of the load on light bars in the lowest position over sqrt(2 g l), less 1.
pub fn speed_below(mass: f64) -> Result<f64, Fault> {
    let mut sim = LightBars { mass, ..LightBars::new() }.start()?;
    sim.step(0.25 * theory::pendulum_period(G.sqrt(), FRAC_PI_2))?;
    Ok(sim.load().vx.hypot(sim.load().vy) / (2.0 * G).sqrt() - 1.0)
}
