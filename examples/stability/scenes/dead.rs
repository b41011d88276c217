//! Linkages with dead points: poses where one bar cannot drive the others, or where the motion ends.

use plm::{BodyState, Fault, Method, Sim};

use super::run::{Trace, trace};
use super::theory;

plm::mechanism! {
    /// Triple rocker: bars of 0.7, 0.6 and 0.5 m on a ground of 1 m, without gravity.
    ///
    /// No bar turns fully: the crank is dead at 78.46 deg, where coupler and rocker stretch, and so are the others in turn,
    /// while phi_q keeps its rank.
    pub TripleRocker {
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body crank {
            mass: 0.7 kg;
            inertia: 0.7 kg*(0.7 m)^2/12;
            port a: (-0.35, 0) m;
            port b: (0.35, 0) m;
            start angle: 60 deg, locked;
            start omega: 1 rad/s, locked;
        }
        body coupler {
            mass: 0.6 kg;
            inertia: 0.6 kg*(0.6 m)^2/12;
            port b: (-0.3, 0) m;
            port c: (0.3, 0) m;
            start x: 0.64 m;
            start y: 0.56 m;
            start angle: -10 deg;
        }
        body rocker {
            mass: 0.5 kg;
            inertia: 0.5 kg*(0.5 m)^2/12;
            port d: (-0.25, 0) m;
            port c: (0.25, 0) m;
            start x: 1 m;
            start y: 0.25 m;
            start angle: 90 deg;
        }
        revolute pivot_a(ground.a, crank.a);
        revolute pin_b(crank.b, coupler.b);
        revolute pin_c(coupler.c, rocker.c);
        revolute pivot_d(ground.d, rocker.d);
    }
}

plm::mechanism! {
    /// Crank-rocker: crank 0.5, coupler 1.2, rocker 0.8 m on a ground of 1 m; the crank is driven at 1 rad/s.
    pub CrankRocker {
        /// Angle of the crank at t = 0.
        param from: rad = 0 rad;
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body crank {
            mass: 0.5 kg;
            inertia: 0.5 kg*(0.5 m)^2/12;
            port a: (-0.25, 0) m;
            port b: (0.25, 0) m;
            start omega: 1 rad/s;
        }
        body coupler {
            mass: 1.2 kg;
            inertia: 1.2 kg*(1.2 m)^2/12;
            port b: (-0.6, 0) m;
            port c: (0.6, 0) m;
            start x: 1 m;
            start y: 0.4 m;
            start angle: 40 deg;
        }
        body rocker {
            mass: 0.8 kg;
            inertia: 0.8 kg*(0.8 m)^2/12;
            port d: (-0.4, 0) m;
            port c: (0.4, 0) m;
            start x: 1.2 m;
            start y: 0.4 m;
            start angle: 60 deg;
        }
        revolute pivot_a(ground.a, crank.a);
        revolute pin_b(crank.b, coupler.b);
        revolute pin_c(coupler.c, rocker.c);
        revolute pivot_d(ground.d, rocker.d);
        constraint drive: crank.angle = from + 1 rad/s*t;
    }
}

plm::mechanism! {
    /// The manual's Quadrorhomb (section 4.3.4): a crank, a Peaucellier cell and three scissor dyads; 13 bars of 1 kg.
    ///
    /// The manual prints no geometry; with these lengths the point D of the cell runs on the line x = 0.625 m, and the crank
    /// is limited to 2 acos(0.25/0.3) = 67.1146 deg.
    pub Quadrorhomb {
        param gravity_y: m/s^2 = 9.81 m/s^2;
        param crank_spring: N*m/rad = 0;
        gravity: gravity_y;
        ground { port q: (0.15, 0) m; port o: (0, 0) m; }
        body crank {
            mass: 1 kg;
            inertia: 1 kg*(0.15 m)^2/12;
            port p: (-0.075, 0) m;
            port c: (0.075, 0) m;
            start x: 0.225 m;
            start angle: 0, locked;
            start omega: 0, locked;
        }
        body oa {
            mass: 1 kg;
            inertia: 1 kg*(0.5 m)^2/12;
            port p: (-0.25, 0) m; port e: (0.25, 0) m;
            start x: 0.231 m; start y: 0.095 m; start angle: 22.33 deg;
        }
        body ob {
            mass: 1 kg;
            inertia: 1 kg*(0.5 m)^2/12;
            port p: (-0.25, 0) m; port e: (0.25, 0) m;
            start x: 0.231 m; start y: -0.095 m; start angle: -22.33 deg;
        }
        body ac {
            mass: 1 kg;
            inertia: 1 kg*(0.25 m)^2/12;
            port p: (-0.125, 0) m; port e: (0.125, 0) m;
            start x: 0.381 m; start y: 0.095 m; start angle: 49.46 deg;
        }
        body bc {
            mass: 1 kg;
            inertia: 1 kg*(0.25 m)^2/12;
            port p: (-0.125, 0) m; port e: (0.125, 0) m;
            start x: 0.381 m; start y: -0.095 m; start angle: -49.46 deg;
        }
        body a1 {
            mass: 1 kg;
            inertia: 1 kg*(0.5 m)^2/12;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
            start x: 0.625 m; start y: 0 m; start angle: -49.46 deg;
        }
        body b1 {
            mass: 1 kg;
            inertia: 1 kg*(0.5 m)^2/12;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
            start x: 0.625 m; start y: 0 m; start angle: 49.46 deg;
        }
        body a2 {
            mass: 1 kg;
            inertia: 1 kg*(0.5 m)^2/12;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
            start x: 0.95 m; start y: 0 m; start angle: -49.46 deg;
        }
        body b2 {
            mass: 1 kg;
            inertia: 1 kg*(0.5 m)^2/12;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
            start x: 0.95 m; start y: 0 m; start angle: 49.46 deg;
        }
        body a3 {
            mass: 1 kg;
            inertia: 1 kg*(0.5 m)^2/12;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
            start x: 1.275 m; start y: 0 m; start angle: -49.46 deg;
        }
        body b3 {
            mass: 1 kg;
            inertia: 1 kg*(0.5 m)^2/12;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
            start x: 1.275 m; start y: 0 m; start angle: 49.46 deg;
        }
        body a4 {
            mass: 1 kg;
            inertia: 1 kg*(0.25 m)^2/12;
            port p: (-0.125, 0) m; port e: (0.125, 0) m;
            start x: 1.519 m; start y: 0.095 m; start angle: -49.46 deg;
        }
        body b4 {
            mass: 1 kg;
            inertia: 1 kg*(0.25 m)^2/12;
            port p: (-0.125, 0) m; port e: (0.125, 0) m;
            start x: 1.519 m; start y: -0.095 m; start angle: 49.46 deg;
        }
        revolute q(ground.q, crank.p) { stiffness: crank_spring; }
        revolute o_oa(ground.o, oa.p);
        revolute o_ob(ground.o, ob.p);
        revolute c_ac(crank.c, ac.p);
        revolute c_bc(crank.c, bc.p);
        revolute oa_ac(oa.e, ac.e);
        revolute oa_a1(oa.e, a1.p);
        revolute ob_bc(ob.e, bc.e);
        revolute ob_b1(ob.e, b1.p);
        revolute a1_b1(a1.m, b1.m);
        revolute b1_a2(b1.e, a2.p);
        revolute a1_b2(a1.e, b2.p);
        revolute a2_b2(a2.m, b2.m);
        revolute b2_a3(b2.e, a3.p);
        revolute a2_b3(a2.e, b3.p);
        revolute a3_b3(a3.m, b3.m);
        revolute b3_a4(b3.e, a4.p);
        revolute a3_b4(a3.e, b4.p);
        revolute a4_b4(a4.e, b4.e);
    }
}

impl Quadrorhomb {
    /// At rest with the crank at an angle, rad.
    pub fn from_crank(angle: f64) -> Self {
        let mut mechanism = Self::new();
        let s = &mut mechanism.start;
        let starts = [
            &mut s.crank,
            &mut s.oa,
            &mut s.ob,
            &mut s.ac,
            &mut s.bc,
            &mut s.a1,
            &mut s.b1,
            &mut s.a2,
            &mut s.b2,
            &mut s.a3,
            &mut s.b3,
            &mut s.a4,
            &mut s.b4,
        ];
        for (start, [x, y, angle]) in starts.into_iter().zip(theory::quadrorhomb(angle)) {
            (start.x.value, start.y.value, start.angle.value) = (x, y, angle);
        }
        mechanism
    }

    /// Without gravity, a spring of 100 N m/rad at the crank, at rest from 40 deg.
    pub fn swinging() -> Self {
        Self { gravity_y: 0.0, crank_spring: 100.0, ..Self::from_crank(40_f64.to_radians()) }
    }
}

impl quadrorhomb::State {
    /// All bars, in the order of the declaration.
    pub fn bodies(&self) -> [BodyState<f64>; 13] {
        [
            self.crank(),
            self.oa(),
            self.ob(),
            self.ac(),
            self.bc(),
            self.a1(),
            self.b1(),
            self.a2(),
            self.b2(),
            self.a3(),
            self.b3(),
            self.a4(),
            self.b4(),
        ]
    }

    /// Kinetic energy, gravity, and the spring of the crank, J.
    pub fn energy(&self) -> f64 {
        let turn = self.crank().angle;
        self.kinetic_energy() + self.gravity_energy() + 0.5 * self.mechanism.crank_spring * turn * turn
    }
}

/// Energy (relative change), angles of crank and rocker (rad), and the sine between coupler and rocker, which changes sign
/// at a dead point of the crank.
pub fn rocking<I: Method<TripleRocker>>(sim: &mut Sim<TripleRocker, I>, until: f64) -> Trace<4> {
    let energy = sim.kinetic_energy();
    trace(sim, until, 0.005, |s| {
        let (crank, coupler, rocker) = (s.crank().angle, s.coupler().angle, s.rocker().angle);
        [s.kinetic_energy() / energy - 1.0, crank, rocker, (rocker - coupler).sin()]
    })
}

/// Largest difference of the coupler's and the rocker's angle from the closed form over so many turns of the crank, rad.
pub fn cranking<I: Method<CrankRocker>>(sim: &mut Sim<CrankRocker, I>, turns: u32) -> Trace<1> {
    let turn = std::f64::consts::TAU;
    trace(sim, f64::from(turns) * turn, turn / 360.0, |s| {
        let [coupler, rocker] = theory::four_bar([0.5, 1.2, 0.8, 1.0], s.time());
        [(s.coupler().angle - coupler).abs().max((s.rocker().angle - rocker).abs())]
    })
}

/// The same by assembly alone: every position is found from the one before, a degree of the crank away.
pub fn assembling() -> Result<Vec<(f64, f64)>, Fault> {
    let mut mechanism = CrankRocker::new();
    let mut differences = Vec::new();
    for degree in 0..=360 {
        let angle = f64::from(degree).to_radians();
        mechanism.from = angle;
        let state = mechanism.start()?;
        let [coupler, rocker] = theory::four_bar([0.5, 1.2, 0.8, 1.0], angle);
        let (found_coupler, found_rocker) = (state.coupler(), state.rocker());
        let off = (found_coupler.angle - coupler).abs().max((found_rocker.angle - rocker).abs());
        differences.push((f64::from(degree), off));
        for (start, body) in [
            (&mut mechanism.start.crank, state.crank()),
            (&mut mechanism.start.coupler, found_coupler),
            (&mut mechanism.start.rocker, found_rocker),
        ] {
            (start.x.value, start.y.value, start.angle.value) = (body.x, body.y, body.angle);
        }
    }
    Ok(differences)
}

/// Energy (J), and the angle of the crank (rad).
pub fn falling<I: Method<Quadrorhomb>>(sim: &mut Sim<Quadrorhomb, I>) -> Trace<2> {
    trace(sim, 1.0, 1e-3, |s| [s.energy(), s.crank().angle])
}

/// Energy (relative change), and the largest difference of a place (m) from that which the angle of the crank gives.
pub fn swinging<I: Method<Quadrorhomb>>(sim: &mut Sim<Quadrorhomb, I>, until: f64, every: f64) -> Trace<2> {
    let energy = sim.energy();
    trace(sim, until, every, |s| {
        let poses = s.bodies().into_iter().zip(theory::quadrorhomb(s.crank().angle));
        let off =
            poses.map(|(body, [u, v, _])| (body.x - u).abs().max((body.y - v).abs())).fold(0.0, f64::max);
        [s.energy() / energy - 1.0, off]
    })
}
