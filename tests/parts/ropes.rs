//! Ropes: block and tackle, winch, capstan, a rope that gives way.

use plm::{Dop853, Sim};

use crate::near;

const G: f64 = 9.81;

plm::mechanism! {
    pub Ropes {
        param counter: kg = 1 kg;
        param heavy: kg = 3 kg;
        param hoisting: N*m = 30 N*m;
        gravity: 9.81 m/s^2;
        ground {
            port line[0]: (0, 0) m, axis: 90 deg; port line[1]: (0.2, 0) m, axis: 90 deg; port line[2]: (5, 0) m, axis: 90 deg;
            port line[3]: (6, 0) m, axis: 90 deg; port line[4]: (7, 0) m, axis: 90 deg; port line[5]: (8, 0) m, axis: 90 deg;
            port top: (-0.05, 3) m; port top2: (0.05, 3) m; port pulley: (0.2, 3) m; port bridge: (5, 3) m;
            port post: (6, 3) m; port post2: (7, 3) m; port crane: (8, 3) m;
        }
        // Two falls to a block, and a third to a weight.
        body block { mass: 4 kg; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; port left: (-0.05, 0) m; port right: (0.05, 0) m; start y: 1 m, locked; start vy: 0 m/s, locked; }
        body weight { mass: counter; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 0.2 m; start y: 1 m, locked; }
        prismatic guide[0](ground.line[0], block.line);
        prismatic guide[1](ground.line[1], weight.line);
        rope tackle() { length: 6 m; }
        fall first(tackle.end, ground.top, block.left);
        fall second(tackle.end, ground.top2, block.right);
        fall third(tackle.end, ground.pulley, weight.line);

        body jumper { mass: 70 kg; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 5 m; start y: 2.5 m, locked; }
        prismatic guide[2](ground.line[2], jumper.line);
        elastic_rope bungee() { length: 10 m; stiffness: 100 N/m; }
        fall leap(bungee.end, ground.bridge, jumper.line);

        body load { mass: heavy; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 6 m; start y: 2 m, locked; }
        body light { mass: 1 kg; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 7 m; start y: 2 m, locked; }
        prismatic guide[3](ground.line[3], load.line);
        prismatic guide[4](ground.line[4], light.line);
        shaft_ground bollard();
        capstan turns(bollard.shaft) { length: 2 m; radius: 5 cm; wrap: 270 deg; friction: 0.25; }
        fall down(turns.near, ground.post, load.line);
        fall up(turns.far, ground.post2, light.line);

        rotor drum() { inertia: 0.5 kg*m^2; drive: hoisting; }
        body crate { mass: 10 kg; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 8 m; start y: 1 m, locked; }
        prismatic guide[5](ground.line[5], crate.line);
        rope hoist() { length: 2 m; }
        fall hang(hoist.end, ground.crane, crate.line);
        winch lift(hoist.end, drum.shaft) { radius: 0.1 m; }

        output tackle.tension, tackle.slack, block.y, block.vy, weight.vy, bungee.tension, bungee.elongation, jumper.vy;
        output turns.tension_near, turns.tension_far, turns.lost, turns.speed, turns.torque, load.y, load.vy;
        output lift.speed, hoist.tension, drum.speed, crate.vy, bungee.energy, bungee.lost, first.length;
    }
}

fn started(ropes: &Ropes) -> Sim<Ropes> {
    ropes.start_with(Dop853::new(1e-11)).unwrap()
}

/// Tackle and winch stand still.
fn calm(heavy: f64) -> Ropes {
    Ropes { counter: 2.0, heavy, hoisting: 9.81, ..Ropes::new() }
}

/// The block is pulled twice, the weight once: a = (2 m - M) g/(M + 4 m), T = 3 M m g/(M + 4 m).
#[test]
fn a_tackle_pulls_twice() {
    for weight in [1.0, 2.0, 2.5] {
        let mut sim = started(&Ropes { counter: weight, ..Ropes::new() });
        sim.step_to(0.4).unwrap();
        near(sim.block_vy(), 0.4 * (2.0 * weight - 4.0) * G / (4.0 + 4.0 * weight), 1e-9);
        near(sim.weight_vy(), -2.0 * sim.block_vy(), 1e-9);
        near(sim.tackle_tension(), 12.0 * weight * G / (4.0 + 4.0 * weight), 1e-9);
    }
}

/// A block that is thrown up leaves the rope slack: both fall freely. Behind that the rope becomes taut by an impact, in which the momenta go by 2
/// to 1 and its ends have one speed.
#[test]
fn a_rope_pulls_only() {
    // The weight rests on the rope at the start; a start with a slack that opens is no impact.
    let mut ropes = Ropes { counter: 2.0, ..Ropes::new() };
    ropes.start.block.vy.value = 1.0;
    let mut sim = started(&ropes);
    sim.step_to(0.1).unwrap();
    near(sim.tackle_tension(), 0.0, 0.0);
    near(sim.block_vy(), 1.0 - 0.1 * G, 1e-9);
    near(sim.weight_vy(), -0.1 * G, 1e-9);
    // Slack: 2 (t - g t^2/2) - g t^2/2 = 0.
    let taut = 4.0 / (3.0 * G);
    near(sim.tackle_slack(), 0.2 - 1.5 * G * 0.01, 1e-9);
    let (block, weight) = (1.0 - G * taut, -G * taut);
    sim.step_to(taut + 1e-6).unwrap();
    // Impulse J: 4 dv = 2 J, 2 dw = J, and 2 v + w = 0 behind.
    let impulse = -(2.0 * block + weight) / (2.0 * 2.0 / 4.0 + 1.0 / 2.0);
    near(sim.block_vy(), block + impulse / 2.0, 1e-5);
    near(sim.weight_vy(), weight + impulse / 2.0, 1e-5);
}

/// The jumper comes as deep as m g (l + x) = c x^2/2.
#[test]
fn an_elastic_rope_catches_what_falls() {
    let mut sim = started(&calm(3.0));
    let (weight, stiffness) = (70.0 * G, 100.0);
    let deepest = (weight + (weight * weight + 2.0 * stiffness * weight * 9.5).sqrt()) / stiffness;
    // Free fall by 9.5 m, then from the middle of a swing.
    let fallen = (2.0 * 9.5 / G).sqrt();
    let rate = (stiffness / 70.0_f64).sqrt();
    let (speed, rest) = (G * fallen, weight / stiffness);
    sim.step_to(fallen - 1e-6).unwrap();
    near(sim.bungee_tension(), 0.0, 0.0);
    let lowest = fallen + (std::f64::consts::PI - (speed / rate / rest).atan()) / rate;
    sim.step_to(lowest).unwrap();
    near(sim.jumper_vy(), 0.0, 1e-6);
    near(sim.bungee_elongation(), deepest, 1e-7);
    near(sim.bungee_tension(), stiffness * deepest, 1e-5);
    near(sim.bungee_energy(), stiffness * deepest * deepest / 2.0, 1e-4);
    near(sim.bungee_lost(), 0.0, 1e-9);
}

/// exp(0.25 3/2 pi) = 3.248: 3 kg are held by 1 kg, and 4 kg run with g (M - m r)/(M + m r).
#[test]
fn a_capstan_holds_and_slips_by_euler_and_eytelwein() {
    let ratio = (0.25 * 1.5 * std::f64::consts::PI).exp();
    let mut held = started(&calm(3.0));
    held.step_to(2.0).unwrap();
    near(held.load_y(), 2.0, 1e-12);
    near(held.turns_tension_near(), 3.0 * G, 1e-9);
    near(held.turns_tension_far(), G, 1e-9);
    near(held.turns_torque(), -0.05 * 2.0 * G, 1e-9);
    for heavy in [4.0, 0.2] {
        let mut sim = started(&calm(heavy));
        sim.step_to(0.3).unwrap();
        let ratio = if heavy > 1.0 { ratio } else { 1.0 / ratio };
        let fall = G * (heavy - ratio) / (heavy + ratio);
        near(sim.load_vy(), -0.3 * fall, 1e-9);
        near(sim.turns_tension_near(), ratio * sim.turns_tension_far(), 1e-9);
        near(sim.turns_speed(), 0.3 * fall, 1e-9);
        near(sim.turns_lost(), (ratio - 1.0) * sim.turns_tension_far() * 0.3 * fall, 1e-8);
    }
}

/// 30 N m lift 10 kg by a drum of 0.1 m and 0.5 kg m^2: (30 - 0.981 10)/(0.5 + 0.1) rad/s^2.
#[test]
fn a_winch_lifts() {
    let mut sim = started(&Ropes::new());
    sim.step_to(0.2).unwrap();
    let alpha = (30.0 - 9.81) / 0.6;
    near(sim.drum_speed(), 0.2 * alpha, 1e-9);
    near(sim.crate_vy(), 0.02 * alpha, 1e-9);
    near(sim.lift_speed(), 0.02 * alpha, 1e-9);
    near(sim.hoist_tension(), 10.0 * (G + 0.1 * alpha), 1e-8);
}
