//! Journals with clearance, stops and bushings.

use plm::{Dop853, Mechanism as _};

use crate::declared::Loose;
use crate::joints::near;
use crate::scene::{Given as _, Named as _, Scene};

/// From the middle the journal strikes with 0.5 m/s along (3, 4)/5 at 2 ms, and crosses the bush with e of it: no slip, no friction.
#[test]
fn a_journal_strikes_its_bush() {
    let mut sim = Loose::new().with("e", 0.8).start_with(Dop853::new(1e-11)).unwrap();
    let (mut time, mut speed, mut side) = (1e-3 / 0.5, 0.5, 1.0);
    for _ in 0..5 {
        sim.step_to(time + 1e-9).unwrap();
        (speed, side) = (0.8 * speed, -side);
        near(sim.state_of("rigid").vx, side * 0.6 * speed, 1e-10);
        near(sim.state_of("rigid").vy, side * 0.8 * speed, 1e-10);
        near(sim.state_of("rigid").omega, 0.0, 1e-10);
        time += 2e-3 / speed;
    }
    near(sim.state_of("rigid").x.hypot(sim.state_of("rigid").y), 1e-3, 1e-8);
}

/// A journal that turns is braked by the impact: with friction's impulse mu times that of the impact, as long as it slips.
#[test]
fn a_turning_journal_rubs_in_an_impact() {
    let mut start = Loose::new().with("e", 0.5);
    start = start.with_start("rigid.omega", 100.0);
    let mut sim = start.start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(2e-3 + 1e-9).unwrap();
    let impulse = 1.5 * 2.0 * 0.5;
    let (radial, tangential) = (-0.25, -0.2 * impulse / 2.0);
    // The tangent to the left of (3, 4)/5 is (-4, 3)/5.
    near(sim.state_of("rigid").vx, 0.6 * radial - 0.8 * tangential, 1e-9);
    near(sim.state_of("rigid").vy, 0.8 * radial + 0.6 * tangential, 1e-9);
    near(sim.state_of("rigid").omega, 100.0 - 0.2 * impulse * 0.02 / 0.004, 1e-8);
}

/// Hertz's impact: depth (5 m v^2/(4 K))^(2/5), and with the damping of Lankarani and Nikravesh the speed v' after it with
/// v/a - ln(1 + a v)/a^2 = -v'/a - ln(1 - a v')/a^2, a = 3 (1 - e^2)/(4 v), the first integral of m x'' = -K x^(3/2) (1 + a x').
#[test]
fn a_compliant_bush_gives_back_by_lankarani_and_nikravesh() {
    let stiffness = 2.0 / 3.0 * 207e9 / (1.0 - 0.09) * (0.02 * 0.021 / 0.001_f64).sqrt();
    let (mass, v) = (2.0, 0.5_f64);
    let depth = (5.0 * mass * v * v / (4.0 * stiffness)).powf(0.4);
    let mut sim = Loose::new().with("e", 1.0).start_with(Dop853::new(1e-11)).unwrap();
    // It lasts 2.943 depth/v (gamma functions: sqrt(pi) Gamma(2/5)/(Gamma(9/10) 5/4)).
    let lasts = 2.943_275 * depth / v;
    sim.step_to(2e-3 + 0.5 * lasts).unwrap();
    near(sim.value_of("shell.penetration") / depth, 1.0, 1e-9);
    near(sim.value_of("shell.force") / (stiffness * depth.powf(1.5)), 1.0, 1e-8);
    sim.step_to(2e-3 + lasts * 1.001).unwrap();
    near(sim.state_of("soft").vx.hypot(sim.state_of("soft").vy), v, 1e-9);
    near(sim.value_of("shell.force"), 0.0, 0.0);

    let mut sim = Loose::new().with("e", 0.9).start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(2e-3 + lasts * 1.1).unwrap();
    let a = 3.0 * (1.0 - 0.81) / (4.0 * v);
    let of = |x: f64| x / a - (a * x).ln_1p() / (a * a);
    let after = -(sim.state_of("soft").vx * 0.6 + sim.state_of("soft").vy * 0.8);
    assert!(after > 0.9 * v * 0.95 && after < v, "{after}");
    near(of(-after), of(v), 1e-9);
}

/// The face stands 0.2 m before the port: the ball comes 0.8 m with 2 m/s, and leaves with 1 m/s.
#[test]
fn a_ball_strikes_a_stop() {
    let mut sim = Loose::new().start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(0.4 + 0.1).unwrap();
    near(sim.value_of("wall.gap"), 0.1, 1e-10);
    near(sim.state_of("ball").vx, 30_f64.to_radians().cos(), 1e-10);
    near(sim.state_of("ball").vy, 30_f64.to_radians().sin(), 1e-10);
}

/// Forces of a bushing and of an elastic stop between free bodies leave both momenta, and take from the energy what they lose.
#[test]
fn a_bushing_leaves_momentum_and_loses_what_it_says() {
    let mut sim = Loose::new().start_with(Dop853::new(1e-11)).unwrap();
    let sums = |sim: &plm::Sim<Scene, Dop853<Scene>>| {
        let (one, two) = (sim.state_of("one"), sim.state_of("two"));
        let spin = |mass: f64, inertia: f64, x: f64, y: f64, vx: f64, vy: f64, omega: f64| {
            mass * (x * vy - y * vx) + inertia * omega
        };
        let kinetic = |mass: f64, inertia: f64, vx: f64, vy: f64, omega: f64| {
            0.5 * (mass * (vx * vx + vy * vy) + inertia * omega * omega)
        };
        let depth = (-sim.value_of("buffer.gap")).max(0.0);
        [
            one.vx + 2.0 * two.vx,
            one.vy + 2.0 * two.vy,
            spin(1.0, 0.1, one.x, one.y, one.vx, one.vy, one.omega)
                + spin(2.0, 0.3, two.x, two.y, two.vx, two.vy, two.omega),
            kinetic(1.0, 0.1, one.vx, one.vy, one.omega)
                + kinetic(2.0, 0.3, two.vx, two.vy, two.omega)
                + sim.value_of("mount.energy")
                + 1000.0 * depth * depth
                + sim.value_of("lost"),
        ]
    };
    let before = sums(&sim);
    let mut touched = false;
    for k in 1..=40 {
        sim.step_to(0.05 * f64::from(k)).unwrap();
        touched |= sim.value_of("buffer.gap") < 0.0;
        for (found, known) in sums(&sim).into_iter().zip(before) {
            near(found, known, 1e-8);
        }
    }
    assert!(touched && sim.value_of("lost") > 0.1, "{}", sim.value_of("lost"));
}
