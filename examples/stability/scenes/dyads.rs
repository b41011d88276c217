//! A dyad that comes to its own limit, while the loop before it could go on.

use plm::{Dop853, Fault, Method, Sim};

use super::run::{Trace, trace};

/// Stephenson's six-bar: the coupler of a four-bar leads a dyad to a third pivot, which it cannot always reach.
macro_rules! stephenson {
    ($(#[$doc:meta])* $name:ident, $module:ident { $($item:tt)* }) => {
        plm::mechanism! {
            $(#[$doc])*
            pub $name {
                $($item)*
                gravity: 9.81 m/s^2;
                ground { port a: (0, 0) m; port b: (0.4, 0) m; port c: (0.55, 0.25) m; }
                body crank {
                    mass: 1 kg;
                    inertia: 0.002 kg*m^2;
                    port a: (0, 0) m;
                    port p: (0.1, 0) m;
                    start angle: 60 deg, locked;
                    start omega: 20 rad/s, locked;
                }
                body coupler {
                    mass: 2 kg;
                    inertia: 0.03 kg*m^2;
                    centre: (0.15, 0.05) m;
                    port p: (0, 0) m;
                    port q: (0.3, 0) m;
                    port r: (0.15, 0.15) m;
                    start angle: 20 deg;
                }
                body rocker {
                    mass: 1 kg;
                    inertia: 0.01 kg*m^2;
                    centre: (0.125, 0) m;
                    port b: (0, 0) m;
                    port q: (0.25, 0) m;
                    start angle: 100 deg;
                    start x: 0.4 m;
                }
                body link {
                    mass: 1 kg;
                    inertia: 0.01 kg*m^2;
                    centre: (0.15, 0) m;
                    port r: (0, 0) m;
                    port s: (0.3, 0) m;
                    start angle: 20 deg;
                    start x: 0.15 m;
                    start y: 0.3 m;
                }
                body arm {
                    mass: 1 kg;
                    inertia: 0.01 kg*m^2;
                    centre: (0.1, 0) m;
                    port c: (0, 0) m;
                    port s: (0.2, 0) m;
                    start angle: 130 deg;
                    start x: 0.55 m;
                    start y: 0.25 m;
                }
                revolute main(ground.a, crank.a);
                revolute p(crank.p, coupler.p);
                revolute q(coupler.q, rocker.q);
                revolute b(ground.b, rocker.b);
                revolute r(coupler.r, link.r);
                revolute s(link.s, arm.s);
                revolute c(ground.c, arm.c);
            }
        }
    };
}
stephenson!(
    /// As it comes.
    Stephenson, stephenson {}
);
stephenson!(
    /// In absolute coordinates.
    StephensonAbsolute, stephenson_absolute { formulation: absolute; }
);

/// Energy (relative change), angles of crank and arm (rad), and the sine between link and arm, which changes sign
/// where they stretch.
pub fn leading<I: Method<Stephenson>>(sim: &mut Sim<Stephenson, I>, until: f64) -> Trace<4> {
    let energy = sim.kinetic_energy() + sim.gravity_energy();
    trace(sim, until, 2e-4, |s| {
        let (link, arm) = (s.link().angle, s.arm().angle);
        [(s.kinetic_energy() + s.gravity_energy()) / energy - 1.0, s.crank().angle, arm, (link - arm).sin()]
    })
}

/// Largest difference of an angle from absolute coordinates, rad, both at a tolerance of 1e-11.
pub fn apart(until: f64) -> Result<f64, Fault> {
    let mut sim = Stephenson::new().start_with(Dop853::new(1e-11))?;
    let mut other = StephensonAbsolute::new().start_with(Dop853::new(1e-11))?;
    let mut largest = 0.0_f64;
    while sim.time() < until {
        sim.step(0.01)?;
        other.step(0.01)?;
        let pairs = [(sim.crank(), other.crank()), (sim.rocker(), other.rocker()), (sim.arm(), other.arm())];
        largest = pairs.iter().fold(largest, |largest, (a, b)| largest.max((a.angle - b.angle).abs()));
    }
    Ok(largest)
}
