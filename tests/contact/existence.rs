//! Rows that end, and events that contacts cause.

use plm::{Dop853, Mechanism as _};

use crate::declared::Stairs;
use crate::near;
use crate::scene::Named as _;

scene! {
    /// A table of 0.5 m, from whose edge a block slides onto the floor.
    pub Edge {
        allow(W0002);
        gravity: 9.81 m/s^2;
        param mu = 0.1;
        discrete falls: 1 = 0;
        discrete arrivals: 1 = 0;
        discrete landed: s = 0;
        discrete stopped: m = 0;
        body block { mass: 1 kg; inertia: 1 kg*m^2; start y: 0.8 m; start vx: 2 m/s; }
        unilateral table: block.y >= 0.8 m { when: block.x < 0.5 m; }
        friction rub: rate(block.x) within mu*reaction(table) { when: block.x < 0.5 m; }
        unilateral floor: block.y >= 0 m;
        friction drag: rate(block.x) within 0.5*reaction(floor);
        when is_open(table) { falls = falls + 1; }
        when not is_open(table) { arrivals = arrivals + 1; }
        when not is_open(floor) { landed = t; }
        when is_sticking(drag) and not is_open(floor) { stopped = block.x; }
        output push = reaction(table), landed, stopped, falls, arrivals;
        output on_table = if is_open(table) then 0 else 1;
    }
}

/// v_1^2 = v_0^2 - 2 mu g s at the edge, sqrt(2 h/g) to the floor, where an impact takes mu' v_y of the speed, and the rest v^2/(2 mu' g).
#[test]
fn a_block_leaves_its_table_and_lands() {
    let mut sim = Edge::new().start_with(Dop853::new(1e-11)).unwrap();
    let g = 9.81_f64;
    let leaves = (4.0 - 2.0 * 0.1 * g * 0.5).sqrt();
    let edge = (2.0 - leaves) / (0.1 * g);
    sim.step_to(edge - 1e-6).unwrap();
    near(sim.value_of("push"), g, 1e-12);
    near(sim.value_of("on_table"), 1.0, 0.0);
    // It begins on the table: that is no event.
    near(sim.value_of("arrivals"), 0.0, 0.0);
    sim.step_to(edge + 1e-6).unwrap();
    near(sim.value_of("push"), 0.0, 0.0);
    near(sim.value_of("on_table"), 0.0, 0.0);
    near(sim.value_of("falls"), 1.0, 0.0);
    near(sim.state_of("block").vx, leaves, 1e-10);
    let fall = (2.0 * 0.8 / g).sqrt();
    let slides = leaves - 0.5 * g * fall;
    assert!(slides < 0.0, "the impact stops it");
    sim.step_to(edge + fall + 1.0).unwrap();
    near(sim.value_of("landed"), edge + fall, 1e-10);
    near(sim.value_of("stopped"), 0.5 + leaves * fall, 1e-10);
    near(sim.state_of("block").x, sim.value_of("stopped"), 1e-15);
}

scene! {
    /// A block that a growing force draws from its magnet: the row is there until it is torn off.
    pub Magnet {
        part press(on: body) {
            input force: N = 0 N;
            force on on: (force, 0 N);
        }
        allow(W0002);
        param strength: N = 5 N;
        discrete holds: 1 = 1;
        discrete torn: s = 0;
        body block { mass: 2 kg; inertia: 1 kg*m^2; }
        constraint level: block.angle = 0;
        constraint height: block.y = 0;
        press press(block) { force: 1 N/s*t; }
        unilateral hook: block.x <= 0 { when: holds > 0.5; }
        when reaction(hook) > strength { holds = 0; torn = t; }
        output torn, pull = reaction(hook);
    }
}

/// Torn at 5 s; then x = (t^3 - 75 t + 250)/12.
#[test]
fn a_hook_tears_at_its_strength() {
    let mut sim = Magnet::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(4.9).unwrap();
    near(sim.value_of("pull"), 4.9, 1e-12);
    near(sim.state_of("block").x, 0.0, 0.0);
    sim.step_to(7.0).unwrap();
    near(sim.value_of("torn"), 5.0, 1e-10);
    near(sim.value_of("pull"), 0.0, 0.0);
    near(sim.state_of("block").x, (343.0 - 75.0 * 7.0 + 250.0) / 12.0, 1e-10);
}

/// Parabolas between strikes, each on the tread where it comes down.
#[test]
fn a_ball_bounces_down_stairs() {
    let mut sim = Stairs::new().start_with(Dop853::new(1e-12)).unwrap();
    let (g, e, vx) = (9.81_f64, 0.6, 0.4);
    let (mut time, mut y, mut vy) = (0.0, 0.5, 0.0_f64);
    for strike in 1..=8 {
        // The first tread, or the ground, above which the parabola comes down.
        let fall = |level: f64| (vy + (vy * vy + 2.0 * g * (y - level)).sqrt()) / g;
        let (level, flight) = (0..6)
            .map(|k| (-0.2 * f64::from(k), fall(-0.2 * f64::from(k)), f64::from(k)))
            .find(|(_, flight, k)| {
                let x = vx * (time + flight);
                x >= 0.3 * k && (*k > 4.5 || x < 0.3 * (k + 1.0))
            })
            .map(|(level, flight, _)| (level, flight))
            .unwrap();
        let middle = 0.5 * flight;
        sim.step_to(time + middle).unwrap();
        near(sim.state_of("ball").y, y + vy * middle - 0.5 * g * middle * middle, 1e-9);
        near(sim.state_of("ball").x, vx * (time + middle), 1e-12);
        near(sim.value_of("strikes"), f64::from(strike - 1), 0.0);
        (time, y, vy) = (time + flight, level, e * (g * flight - vy));
    }
}
