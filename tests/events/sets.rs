//! Events that set states, against closed forms.

use plm::{BodyState, Dop853, mechanism};

use crate::beside_text::same;

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}: {:e}", found - known);
}

mechanism! {
    pub Ball {
        gravity: 9.81 m/s^2;
        param loss = 0.5;
        discrete bounces: 1 = 0;
        state warmth: 1 = 0;
        rate warmth = (if bounces > 1.5 then 3 else 1)/(1 s);
        allow(W0002);
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; }
        when ball.y < 0 m {
            ball.vy = -loss*ball.vy;
            bounces = bounces + 1;
        }
        output bounces, warmth;
    }
}

/// t_n+1 = t_n + 2 e^n sqrt(2 h/g).
#[test]
fn a_ball_is_thrown_back() {
    let mut sim = Ball::new().start_with(Dop853::new(1e-11)).unwrap();
    let (first, e): (f64, f64) = ((2.0_f64 / 9.81).sqrt(), 0.5);
    let mut begins = first;
    for n in 1..5 {
        let flight = 2.0 * e.powi(n) * first;
        sim.step_to(begins + 0.5 * flight).unwrap();
        near(sim.ball().y, e.powi(2 * n), 1e-10);
        near(sim.bounces(), f64::from(n), 0.0);
        begins += flight;
    }
    let second = first * (1.0 + 2.0 * e);
    near(sim.warmth(), second + 3.0 * (sim.time() - second), 1e-10);
}

mechanism! {
    /// A thermostat, and a counter that samples it ten times a second.
    pub Oven {
        allow(W0002);
        body none { mass: 1 kg; inertia: 1 kg*m^2; }
        param low: K = 290 K;
        param high: K = 300 K;
        discrete on: 1 = 0;
        discrete next: s = 0.1 s;
        discrete samples: 1 = 0;
        discrete last: K = 0 K;
        discrete full: 1 = 0;
        state heat: K = 295 K;
        rate heat = (280 K - heat)/(1 s) + (if on > 0.5 then 40 K/s else 0 K/s);
        when heat < low { on = 1; }
        when heat > high { on = 0; }
        when t > next { next = next + 0.1 s; samples = samples + 1; last = heat; }
        when samples >= 7 and on > 0.5 { full = full + samples; samples = 0; }
        output on, samples, full, last, heat;
    }
}

/// Cooling ln(20/10) s, heating ln(30/20) s.
#[test]
fn a_relay_has_hysteresis_and_a_clock_samples() {
    let mut sim = Oven::new().start_with(Dop853::new(1e-12)).unwrap();
    let first = (15.0_f64 / 10.0).ln();
    let (heats, cools) = ((30.0_f64 / 20.0).ln(), 2.0_f64.ln());
    for k in 0..5 {
        let begun = first + f64::from(k) * (heats + cools);
        sim.step_to(begun + 1e-9).unwrap();
        near(sim.heat(), 290.0, 1e-6);
        near(sim.on(), 1.0, 0.0);
        sim.step_to(begun + heats + 1e-9).unwrap();
        near(sim.heat(), 300.0, 1e-6);
        near(sim.on(), 0.0, 0.0);
    }
    let time = sim.time();
    near(sim.samples() + sim.full(), (time * 10.0).floor(), 0.0);
    let at = 0.1 * (time * 10.0).floor();
    let since = at - (first + 4.0 * (heats + cools));
    near(
        sim.last(),
        if since > heats { 280.0 + 20.0 * (heats - since).exp() } else { 320.0 - 30.0 * (-since).exp() },
        1e-8,
    );
}

macro_rules! chain {
    ($name:ident, $formulation:ident) => {
        mechanism! {
            pub $name {
                formulation: $formulation;
                ground { port o: (0, 0) m; }
                body first {
                    mass: 2 kg; inertia: 0.3 kg*m^2;
                    port o: (-0.5, 0) m; port a: (0.5, 0) m;
                    start angle: 20 deg, locked; start omega: 1 rad/s, locked;
                }
                body second {
                    mass: 1 kg; inertia: 0.2 kg*m^2;
                    port a: (-0.4, 0) m;
                    start angle: 80 deg, locked; start omega: 2 rad/s, locked;
                }
                revolute o(ground.o, first.o);
                revolute a(first.a, second.a);
                when t > 0.25 s { first.omega = 0 rad/s; }
            }
        }
    };
}

chain!(InTree, tree);
chain!(InAbsolute, absolute);

/// The hinge is stopped by impulses at the first body; the second one keeps its angular momentum about the hinge.
macro_rules! stopped {
    ($mechanism:expr) => {{
        let mut sim = $mechanism.start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(0.25 - 1e-9).unwrap();
        let (first, second) = (sim.first(), sim.second());
        let (sin, cos) = (0.4 * second.angle.sin(), 0.4 * second.angle.cos());
        let momentum = 0.2 * second.omega + cos * second.vy - sin * second.vx;
        sim.step_to(0.25).unwrap();
        near(sim.first().omega, 0.0, 1e-12);
        near(sim.first().vx.hypot(sim.first().vy), 0.0, 1e-12);
        near(sim.second().omega, momentum / (0.2 + 0.16), 1e-7);
        near(sim.first().angle, first.angle, 1e-8);
        sim.second().omega
    }};
}

#[test]
fn a_velocity_is_set_as_by_impulses() {
    near(stopped!(InTree::new()), stopped!(InAbsolute::new()), 1e-9);
}

mechanism! {
    pub FourBar {
        ground { port a: (0, 0) m; port d: (0.4, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (-0.05, 0) m; port b: (0.05, 0) m; start angle: 60 deg, locked; start omega: 4 rad/s, locked; }
        body coupler { mass: 1 kg; inertia: 0.02 kg*m^2; port b: (-0.2, 0) m; port c: (0.2, 0) m; start x: 0.2 m; start y: 0.1 m; }
        body rocker { mass: 1 kg; inertia: 0.02 kg*m^2; port d: (-0.15, 0) m; port c: (0.15, 0) m; start x: 0.4 m; start y: 0.15 m; start angle: 90 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(rocker.d, ground.d);
        when crank.angle > 400 deg { crank.omega = 2 rad/s; }
    }
}

#[test]
fn a_loop_goes_on_with_the_velocity_that_was_set() {
    let mut sim = FourBar::new().start_with(Dop853::new(1e-11)).unwrap();
    while sim.crank().angle < 400_f64.to_radians() - 1e-2 {
        sim.step(1e-3).unwrap();
    }
    let ratio = |crank: BodyState<f64>, rocker: BodyState<f64>| rocker.omega / crank.omega;
    let mut before = ratio(sim.crank(), sim.rocker());
    while sim.crank().omega > 2.5 {
        before = ratio(sim.crank(), sim.rocker());
        sim.step(1e-6).unwrap();
    }
    near(sim.crank().angle, 400_f64.to_radians(), 1e-5);
    near(sim.crank().omega, 2.0, 1e-5);
    near(ratio(sim.crank(), sim.rocker()), before, 1e-5);
    let energy = sim.kinetic_energy();
    sim.step(1.0).unwrap();
    near(sim.kinetic_energy(), energy, 1e-9);
    assert!(sim.drift().phi < 1e-12);
}

/// Events of mechanisms from text set the bits of compiled ones.
#[test]
fn mechanisms_from_text_set_the_same_bits() {
    same!(Ball: 1.6, Oven: 2.0, InTree: 1.0, InAbsolute: 1.0, FourBar: 1.0);
}
