//! Journals with clearance, stops and bushings.

use plm::{Dop853, mechanism};

use crate::joints::near;

mechanism! {
    /// Journals in bushes, a ball between stops, and two bodies on a bushing, without gravity.
    pub Loose {
        param e = 0.9;
        ground { port o: (0, 0) m; port p: (1, 0) m; port wall: (2, 0) m, axis: 30 deg; }
        body rigid { mass: 2 kg; inertia: 0.004 kg*m^2; port pin: (0, 0) m; start vx: 0.3 m/s; start vy: 0.4 m/s; start omega: 0 rad/s, locked; }
        clearance bush(ground.o, rigid.pin) { clearance: 1 mm; restitution: e; friction: 0.2; radius: 20 mm; }

        body soft { mass: 2 kg; inertia: 0.004 kg*m^2; port pin: (0, 0) m; start x: 1 m; start vx: 0.3 m/s; start vy: 0.4 m/s; }
        clearance shell(ground.p, soft.pin) { clearance: 1 mm; contact: compliant; restitution: e; radius: 20 mm; }

        body ball { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start x: 2 m + 1 m*cos(30 deg); start y: 1 m*sin(30 deg); start vx: -2 m/s*cos(30 deg); start vy: -2 m/s*sin(30 deg); }
        stop wall(ground.wall, ball.p) { distance: 0.2 m; restitution: 0.5; }

        body one { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0.1, 0.05) m, angle: 20 deg; start y: 5 m; start omega: 2 rad/s; }
        body two { mass: 2 kg; inertia: 0.3 kg*m^2; port p: (-0.2, 0.1) m; start x: 0.4 m; start y: 5 m; start vx: 0.3 m/s; }
        bushing mount(one.p, two.p) {
            stiffness_x: 500 N/m; stiffness_y: 200 N/m; stiffness_angle: 20 N*m/rad;
            stiffness_xy: 50 N/m; stiffness_x_angle: 10 N/rad; stiffness_y_angle: -8 N/rad;
            damping_x: 3 N*s/m; damping_y: 2 N*s/m; damping_angle: 0.1 N*m*s/rad; damping_xy: 0.5 N*s/m;
            free_x: 0.05 m; free_y: -0.02 m; rest: 5 deg;
        }
        stop buffer(one.p, two.p) { distance: 0.1 m; stiffness: 2000 N/m; damping: 5 N*s/m; }
        state lost: J = 0;
        rate lost = mount.lost + buffer.lost;
        output bush.force, shell.force, shell.penetration, wall.gap, mount.energy, mount.force, buffer.gap, lost;
        allow(W0002);
    }
}

/// From the middle the journal strikes with 0.5 m/s along (3, 4)/5 at 2 ms, and crosses the bush with e of it: no slip, no friction.
#[test]
fn a_journal_strikes_its_bush() {
    let mut sim = Loose { e: 0.8, ..Loose::new() }.start_with(Dop853::new(1e-11)).unwrap();
    let (mut time, mut speed, mut side) = (1e-3 / 0.5, 0.5, 1.0);
    for _ in 0..5 {
        sim.step_to(time + 1e-9).unwrap();
        (speed, side) = (0.8 * speed, -side);
        near(sim.rigid().vx, side * 0.6 * speed, 1e-10);
        near(sim.rigid().vy, side * 0.8 * speed, 1e-10);
        near(sim.rigid().omega, 0.0, 1e-10);
        time += 2e-3 / speed;
    }
    near(sim.rigid().x.hypot(sim.rigid().y), 1e-3, 1e-8);
}

/// A journal that turns is braked by the impact: with friction's impulse mu times that of the impact, as long as it slips.
#[test]
fn a_turning_journal_rubs_in_an_impact() {
    let mut start = Loose { e: 0.5, ..Loose::new() };
    start.start.rigid.omega.value = 100.0;
    let mut sim = start.start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(2e-3 + 1e-9).unwrap();
    let impulse = 1.5 * 2.0 * 0.5;
    let (radial, tangential) = (-0.25, -0.2 * impulse / 2.0);
    // The tangent to the left of (3, 4)/5 is (-4, 3)/5.
    near(sim.rigid().vx, 0.6 * radial - 0.8 * tangential, 1e-9);
    near(sim.rigid().vy, 0.8 * radial + 0.6 * tangential, 1e-9);
    near(sim.rigid().omega, 100.0 - 0.2 * impulse * 0.02 / 0.004, 1e-8);
}

/// Hertz's impact: depth (5 m v^2/(4 K))^(2/5), and with the damping of Lankarani and Nikravesh the speed v' behind it with
/// v/a - ln(1 + a v)/a^2 = -v'/a - ln(1 - a v')/a^2, a = 3 (1 - e^2)/(4 v), the first integral of m x'' = -K x^(3/2) (1 + a x').
#[test]
fn a_compliant_bush_gives_back_by_lankarani_and_nikravesh() {
    let stiffness = 2.0 / 3.0 * 207e9 / (1.0 - 0.09) * (0.02 * 0.021 / 0.001_f64).sqrt();
    let (mass, v) = (2.0, 0.5_f64);
    let depth = (5.0 * mass * v * v / (4.0 * stiffness)).powf(0.4);
    let mut sim = Loose { e: 1.0, ..Loose::new() }.start_with(Dop853::new(1e-11)).unwrap();
    // It lasts 2.943 depth/v (gamma functions: sqrt(pi) Gamma(2/5)/(Gamma(9/10) 5/4)).
    let lasts = 2.943_275 * depth / v;
    sim.step_to(2e-3 + 0.5 * lasts).unwrap();
    near(sim.shell_penetration() / depth, 1.0, 1e-9);
    near(sim.shell_force() / (stiffness * depth.powf(1.5)), 1.0, 1e-8);
    sim.step_to(2e-3 + lasts * 1.001).unwrap();
    near(sim.soft().vx.hypot(sim.soft().vy), v, 1e-9);
    near(sim.shell_force(), 0.0, 0.0);

    let mut sim = Loose { e: 0.9, ..Loose::new() }.start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(2e-3 + lasts * 1.1).unwrap();
    let a = 3.0 * (1.0 - 0.81) / (4.0 * v);
    let of = |x: f64| x / a - (a * x).ln_1p() / (a * a);
    let behind = -(sim.soft().vx * 0.6 + sim.soft().vy * 0.8);
    assert!(behind > 0.9 * v * 0.95 && behind < v, "{behind}");
    near(of(-behind), of(v), 1e-9);
}

/// The face stands 0.2 m before the port: the ball comes 0.8 m with 2 m/s, and leaves with 1 m/s.
#[test]
fn a_ball_strikes_a_stop() {
    let mut sim = Loose::new().start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(0.4 + 0.1).unwrap();
    near(sim.wall_gap(), 0.1, 1e-10);
    near(sim.ball().vx, 30_f64.to_radians().cos(), 1e-10);
    near(sim.ball().vy, 30_f64.to_radians().sin(), 1e-10);
}

/// Forces of a bushing and of an elastic stop between free bodies leave both momenta, and take from the energy what they lose.
#[test]
fn a_bushing_leaves_momentum_and_loses_what_it_says() {
    let mut sim = Loose::new().start_with(Dop853::new(1e-11)).unwrap();
    let sums = |sim: &plm::Sim<Loose, Dop853<Loose>>| {
        let (one, two) = (sim.one(), sim.two());
        let spin = |mass: f64, inertia: f64, x: f64, y: f64, vx: f64, vy: f64, omega: f64| {
            mass * (x * vy - y * vx) + inertia * omega
        };
        let kinetic = |mass: f64, inertia: f64, vx: f64, vy: f64, omega: f64| {
            0.5 * (mass * (vx * vx + vy * vy) + inertia * omega * omega)
        };
        let depth = (-sim.buffer_gap()).max(0.0);
        [
            one.vx + 2.0 * two.vx,
            one.vy + 2.0 * two.vy,
            spin(1.0, 0.1, one.x, one.y, one.vx, one.vy, one.omega)
                + spin(2.0, 0.3, two.x, two.y, two.vx, two.vy, two.omega),
            kinetic(1.0, 0.1, one.vx, one.vy, one.omega)
                + kinetic(2.0, 0.3, two.vx, two.vy, two.omega)
                + sim.mount_energy()
                + 1000.0 * depth * depth
                + sim.lost(),
        ]
    };
    let before = sums(&sim);
    let mut touched = false;
    for k in 1..=40 {
        sim.step_to(0.05 * f64::from(k)).unwrap();
        touched |= sim.buffer_gap() < 0.0;
        for (found, known) in sums(&sim).into_iter().zip(before) {
            near(found, known, 1e-8);
        }
    }
    assert!(touched && sim.lost() > 0.1, "{}", sim.lost());
}
