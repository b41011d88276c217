//! Mechanisms that rest for a while and are then moved smoothly: what a machine does all day.

use plm::{Dop853, Fault, Method, Sim};

use super::run::{Trace, trace};

/// A four-bar that rests until a torque grows at one of its bars and pushes it through its dead points.
macro_rules! swing {
    ($(#[$doc:meta])* $name:ident, $module:ident { $($item:tt)* }) => {
        plm::mechanism! {
            $(#[$doc])*
            pub $name {
                $($item)*
                param wait: s = 5 s;
                param push: N*m = 0.5 N*m;
                ground { port a: (0, 0) m; port b: (0.4, 0) m; }
                body one {
                    mass: 1 kg;
                    inertia: 0.02 kg*m^2;
                    centre: (0.25, 0) m;
                    port a: (0, 0) m;
                    port p: (0.5, 0) m;
                    start angle: 53.13 deg;
                }
                body two {
                    mass: 1 kg;
                    inertia: 0.02 kg*m^2;
                    centre: (0.25, 0) m;
                    port b: (0, 0) m;
                    port q: (0.5, 0) m;
                    start angle: 126.87 deg;
                    start x: 0.4 m;
                }
                body coupler {
                    mass: 1 kg;
                    inertia: 0.01 kg*m^2;
                    port p: (0.1, 0) m;
                    port q: (-0.1, 0) m;
                    start x: 0.2 m;
                    start y: 0.4 m;
                    start angle: 0 deg, locked;
                }
                revolute a(ground.a, one.a) { drive: push*clamp((t - wait)/2 s, 0, 1) - 0.05 N*m*s*one.omega; }
                revolute b(ground.b, two.b);
                revolute p(one.p, coupler.p);
                revolute q(two.q, coupler.q);
                output one.angle, two.angle, coupler.angle;
            }
        }
    };
}
swing!(
    /// As it comes.
    Swing, swing {}
);
swing!(
    /// In absolute coordinates.
    SwingAbsolute, swing_absolute { formulation: absolute; }
);

plm::mechanism! {
    /// A four-bar on a turntable that rests until a torque turns both: no other torque about the pivot acts on them.
    pub Turntable {
        param wait: s = 5 s;
        /// A torque beside the one that grows.
        input torque: N*m = 0 N*m;
        ground { port o: (0, 0) m; }
        body table {
            mass: 1 kg;
            inertia: 1 kg*m^2;
            port o: (0, 0) m;
            port a: (1, 0) m;
            port b: (1.5, 0) m;
            start angle: 0 deg, locked;
        }
        body crank {
            mass: 0.1 kg;
            inertia: 0.001 kg*m^2;
            port a: (0, 0) m;
            port p: (0.2, 0) m;
            start angle: 70 deg, locked;
            start x: 1 m;
        }
        body rocker {
            mass: 0.1 kg;
            inertia: 0.001 kg*m^2;
            port b: (0, 0) m;
            port q: (0.3, 0) m;
            start angle: 110 deg;
            start x: 1.5 m;
        }
        body coupler {
            mass: 0.1 kg;
            inertia: 0.001 kg*m^2;
            port p: (0, 0) m;
            port q: (0.4, 0) m;
            start angle: 10 deg;
            start x: 1 m;
            start y: 0.2 m;
        }
        revolute main(ground.o, table.o) { drive: torque + 0.5 N*m*clamp((t - wait)/2 s, 0, 1); }
        revolute a(table.a, crank.a) { stiffness: 1000 N*m/rad; rest: 70 deg; damping: 10 N*m/(rad/s); }
        revolute b(table.b, rocker.b);
        revolute p(crank.p, coupler.p);
        revolute q(coupler.q, rocker.q);
    }
}

/// The swing over 8 s from the moment on at which the torque begins: the angles of its bars, rad.
pub fn pushed(wait: f64, push: f64) -> Result<Trace<3>, Fault> {
    let mut sim = Swing { wait, push, ..Swing::new() }.start()?;
    sim.step(wait)?;
    Ok(trace(&mut sim, wait + 8.0, 0.02, |s| [s.one().angle, s.two().angle, s.coupler().angle]))
}

/// The same without a wait and in absolute coordinates, at a tolerance of 1e-12.
pub fn pushed_at_once(push: f64) -> Result<Trace<3>, Fault> {
    let mut sim = SwingAbsolute { wait: 0.0, push, ..SwingAbsolute::new() }.start_with(Dop853::new(1e-12))?;
    Ok(trace(&mut sim, 8.0, 0.02, |s| [s.one().angle, s.two().angle, s.coupler().angle]))
}

/// Largest difference of an angle of two such runs at their moments, rad, over the time since the torque began, s.
pub fn apart(run: &Trace<3>, other: &Trace<3>) -> Vec<(f64, f64)> {
    let rows = run.rows.iter().zip(&other.rows);
    rows.map(|((_, a), (time, b))| (*time, (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max))).collect()
}

impl turntable::State {
    /// Angular momentum about the pivot of the table, kg m^2/s.
    pub fn momentum(&self) -> f64 {
        let light = [self.crank(), self.rocker(), self.coupler()].map(|body| (0.1, 1e-3, body));
        let bodies = light.into_iter().chain([(1.0, 1.0, self.table())]);
        bodies.map(|(m, i, body)| i * body.omega + m * (body.x * body.vy - body.y * body.vx)).sum()
    }
}

/// Angle of the table, rad, and what the angular momentum is off by from the integral of the torque, kg m^2/s.
pub fn turned<I: Method<Turntable>>(sim: &mut Sim<Turntable, I>) -> Trace<2> {
    let wait = sim.mechanism.wait;
    trace(sim, wait + 10.0, 0.01, |s| {
        let pushed = (s.time() - wait).max(0.0);
        let torque = if pushed < 2.0 { 0.125 * pushed * pushed } else { 0.5 * (pushed - 1.0) };
        [s.table().angle, s.momentum() - torque]
    })
}
