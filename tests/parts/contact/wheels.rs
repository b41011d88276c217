//! Wheels and tyres.

use plm::runtime::contact::Mode;
use plm::{Dop853, Mechanism as _, Moment as _, Sim};

use super::{G, near};
use crate::scene::{Given as _, Named as _, Scene};

const SPEED: f64 = 10.0;
const RADIUS: f64 = 0.3;

scene! {
    /// A wheel with a brake, one that coasts, a tyre that is led.
    pub Wheels {
        param brake: N*m = 30 N*m;
        param spin: rad/s = 30 rad/s;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }

        body front { mass: 20 kg; inertia: 0.9 kg*m^2; port c: (0, 0) m; start y: 0.3 m; start vx: 10 m/s; start omega: -10/0.3*1 rad/s; }
        wheel braked(ground.o, front.c) { radius: 0.3 m; friction: 0.8; }
        friction shoe: rate(front.angle) within brake;
        body rear { mass: 20 kg; inertia: 0.9 kg*m^2; port c: (0, 0) m; start y: 0.3 m; start vx: 10 m/s; start omega: -10/0.3*1 rad/s; }
        wheel coasting(ground.o, rear.c) { radius: 0.3 m; friction: 0.8; rolling_resistance: 3 mm; }

        body led { mass: 20 kg; inertia: 0.9 kg*m^2; port c: (0, 0) m; start y: 0.29 m; }
        constraint travel: led.x = 10 m/s*t;
        constraint height: led.y = 0.29 m;
        constraint turns: led.angle = -spin*t;
        tyre rubber(ground.o, led.c) {
            radius: 0.3 m; stiffness: 2e5 N/m; friction: 0.9; curvature_factor: 0.97; shape_factor: 1.9; relaxation_length: 0.5 m;
        }

        output braked.traction, braked.slip, braked.load, braked.lost, coasting.speed, coasting.resistance, coasting.lost;
        output rubber.traction, rubber.load, rubber.slip, rubber.slip_ratio, rubber.lost, hub = reaction(turns), pull = reaction(travel);
        allow(W0002);
    }
}

fn run(mechanism: &Scene) -> Sim<Scene> {
    mechanism.start_with(Dop853::new(1e-10)).unwrap()
}

/// A brake of less than mu N r (1 + J/(m r^2)) does not lock the wheel; it stops by T/(m r (1 + J/(m r^2))). One of more locks it after
/// J omega/(T - mu N r), and the vehicle stops by mu g.
#[test]
fn a_braked_wheel_locks() {
    let (mass, inertia, mu) = (20.0, 0.9, 0.8);
    let whole = 1.0 + inertia / (mass * RADIUS * RADIUS);
    let limit = mu * mass * G * RADIUS * whole;
    for (brake, mode) in [(limit * (1.0 - 1e-6), Mode::Sticks), (limit * (1.0 + 1e-6), Mode::Forwards)] {
        let sim = run(&Wheels::new().with("brake", brake));
        assert_eq!(sim.contact("braked.grip"), Some(mode), "{brake} N m");
    }
    let brake = 0.5 * limit;
    let mut sim = run(&Wheels::new().with("brake", brake));
    let slows = 0.5 * mu * G;
    near(sim.value_of("braked.traction"), -mass * slows, 1e-9);
    let stops = SPEED / slows;
    sim.step_to(stops - 1e-6).unwrap();
    near(sim.state_of("front").vx, 1e-6 * slows, 1e-9);
    sim.step_to(stops + 1.0).unwrap();
    assert_eq!(sim.contact("shoe"), Some(Mode::Sticks));
    near(sim.state_of("front").x, SPEED * SPEED / (2.0 * slows), 1e-8);

    let brake = 2.0 * limit;
    let mut sim = run(&Wheels::new().with("brake", brake));
    let locks = inertia * SPEED / RADIUS / (brake - mu * mass * G * RADIUS);
    sim.step_to(locks - 1e-9).unwrap();
    assert_eq!(sim.contact("shoe"), Some(Mode::Backwards));
    sim.step_to(locks + 1e-9).unwrap();
    assert_eq!(sim.contact("shoe"), Some(Mode::Sticks));
    near(sim.value_of("braked.lost"), mu * mass * G * sim.state_of("front").vx, 1e-6);
    near(sim.value_of("braked.slip"), sim.state_of("front").vx, 1e-9);
    sim.step_to(3.0).unwrap();
    assert_eq!(sim.state_of("front").omega, 0.0);
    near(sim.state_of("front").x, SPEED * SPEED / (2.0 * mu * G), 1e-8);
    near(sim.value_of("braked.load"), mass * G, 1e-9);
}

/// A lever arm f of the load slows by f N r/(J + m r^2).
#[test]
fn a_wheel_coasts() {
    let mut sim = run(&Wheels::new());
    let load = 20.0 * G;
    near(sim.value_of("coasting.resistance"), 0.003 * load, 1e-12);
    near(sim.value_of("coasting.lost"), 0.003 * load * SPEED / RADIUS, 1e-9);
    let slows = 0.003 * load * RADIUS / (0.9 + 20.0 * 0.09);
    sim.step_to(5.0).unwrap();
    near(sim.value_of("coasting.speed"), SPEED - 5.0 * slows, 1e-8);
}

/// The slip builds up as 1 - exp(-x/sigma), and the force is the magic formula of it.
#[test]
fn a_tyre_pulls_by_the_magic_formula() {
    for spin in [30.0, 40.0] {
        let mut sim = run(&Wheels::new().with("spin", spin));
        let load = 2e5 * 0.01;
        let steady = (0.3 * spin - SPEED) / SPEED;
        for _ in 0..5 {
            sim.step(0.02).unwrap();
            let slip = steady * (1.0 - (-SPEED * sim.time() / 0.5).exp());
            near(sim.value_of("rubber.slip"), slip, 1e-9);
            near(sim.value_of("rubber.slip_ratio"), steady, 1e-12);
            let (b, c, e) = (10.0, 1.9, 0.97);
            let bent = b * slip - e * (b * slip - (b * slip).atan());
            let traction = 0.9 * load * (c * bent.atan()).sin();
            near(sim.value_of("rubber.traction"), traction, 1e-6);
            // Of the constraints that lead it: a positive reaction pulls backwards, and turns clockwise.
            near(sim.value_of("pull"), traction, 1e-6);
            near(sim.value_of("hub"), 0.29 * traction, 1e-6);
            near(sim.value_of("rubber.lost"), traction * (0.3 * spin - SPEED), 1e-6);
        }
        near(sim.value_of("rubber.load"), load, 1e-9);
    }
}
