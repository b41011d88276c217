//! Gears and racks in the plane: tooth forces, epicyclic motion, play, efficiency.

use plm::Dop853;

use crate::near;

plm::mechanism! {
    /// A pinion and a wheel, a rack, and an arm with a planet between a sun and a ring.
    pub Meshes {
        ground {
            port o: (0, 0) m; port w: (0.2, 0) m; port p: (1, 0.05) m; port rail: (1, 0) m;
            port sun: (2, 0) m; port arm: (2, 0) m; port ring: (2, 0) m;
        }
        body pinion { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; }
        body wheel { mass: 3 kg; inertia: 0.27 kg*m^2; port hub: (0, 0) m; start x: 0.2 m; }
        revolute first(ground.o, pinion.hub) { drive: 2 N*m; }
        revolute second(ground.w, wheel.hub);
        gear mesh(ground.o, pinion.hub, wheel.hub) { module: 5 mm; teeth_a: 20; teeth_b: 60; }

        body roller { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start x: 1 m; start y: 0.05 m; }
        body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port line: (0, 0) m; start x: 1 m; }
        revolute hub(ground.p, roller.hub) { drive: 3 N*m; }
        prismatic guide(ground.rail, bar.line);
        rack teeth(roller.hub, bar.line) { radius: 50 mm; }

        body sun { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start x: 2 m; start omega: 7 rad/s, locked; }
        body arm { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; port tip: (0.15, 0) m; start x: 2 m; start omega: 3 rad/s, locked; }
        body planet { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start x: 2.15 m; }
        body ring { mass: 1 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start x: 2 m; }
        revolute at_sun(ground.sun, sun.hub);
        revolute at_arm(ground.arm, arm.hub);
        revolute at_planet(arm.tip, planet.hub);
        revolute at_ring(ground.ring, ring.hub);
        gear inner(arm.hub, sun.hub, planet.hub) { radius_a: 100 mm; radius_b: 50 mm; }
        gear outer(arm.tip, planet.hub, ring.hub) { radius_a: 50 mm; radius_b: -200 mm; }
        output first.force, second.force, mesh.torque_a, mesh.torque_b, mesh.tooth_force, mesh.radial_force;
        output hub.force, guide.force, teeth.force, teeth.torque, bar.vx, roller.omega, wheel.omega;
    }
}

/// 2 N m on 0.01 + 0.27/9 = 0.04 kg m^2, seen from the pinion.
#[test]
fn teeth_press_on_each_other_and_on_the_bearings() {
    let mut sim = Meshes::new().start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(0.3).unwrap();
    let alpha = 2.0 / 0.04;
    near(sim.wheel_omega(), -alpha * 0.3 / 3.0, 1e-9);
    near(sim.mesh_torque_b(), -0.27 * alpha / 3.0, 1e-9);
    near(sim.mesh_torque_a(), -0.27 * alpha / 9.0, 1e-9);
    let tangential = 0.27 * alpha / 9.0 / 0.05;
    near(sim.mesh_tooth_force(), tangential / 20_f64.to_radians().cos(), 1e-9);
    near(sim.mesh_radial_force(), tangential * 20_f64.to_radians().tan(), 1e-9);
    // The wheel presses the pinion down at the right, and its bearing presses it up: on the ground it is down.
    near(sim.first_force()[1], -tangential, 1e-9);
    near(sim.second_force()[1], tangential, 1e-9);

    // 3 N m on 0.01 + 2 0.05^2.
    let alpha = 3.0 / (0.01 + 2.0 * 0.0025);
    near(sim.roller().omega, 0.3 * alpha, 1e-9);
    near(sim.bar().vx, 0.05 * sim.roller_omega(), 1e-12);
    near(sim.teeth_force(), -2.0 * 0.05 * alpha, 1e-9);
    near(sim.teeth_torque(), -2.0 * 0.05 * 0.05 * alpha, 1e-9);
    // The bearing takes what the rack presses with; the rack's line passes through its own centre, so that its guide bears no torque.
    near(sim.hub_force()[0].abs(), 2.0 * 0.05 * alpha, 1e-9);
}

/// Willis in the plane, for whole turns of the arm: (w_s - w_a)/(w_p - w_a) = -50/100, (w_p - w_a)/(w_r - w_a) = 200/50.
#[test]
fn a_planet_turns_by_willis_between_a_sun_and_a_ring() {
    let mut sim = Meshes::new().start_with(Dop853::new(1e-10)).unwrap();
    let energy = sim.kinetic_energy();
    sim.step_to(5.0).unwrap();
    let (sun, arm, planet, ring) = (sim.sun(), sim.arm(), sim.planet(), sim.ring());
    assert!(arm.angle > 6.3, "{}", arm.angle);
    near(planet.omega - arm.omega, -2.0 * (sun.omega - arm.omega), 1e-9);
    near(ring.omega - arm.omega, 0.25 * (planet.omega - arm.omega), 1e-9);
    near(planet.angle - arm.angle, -2.0 * (sun.angle - arm.angle), 1e-9);
    // 2 N m and 3 N m work on the other two; what is left stays.
    let worked = 2.0 * sim.pinion().angle + 3.0 * sim.roller().angle;
    near(sim.kinetic_energy() - energy, worked, 1e-8 * worked);
}

plm::mechanism! {
    /// Two wheels that rattle, and two that are driven, with play and losses.
    pub Play {
        param e: 1 = 0.8;
        param efficiency: 1 = 0.95;
        param apart: m = 0.15 m;
        ground { port a: (0, 0) m; port b: (0.15, 0) m; port c: (0, 1) m; port d: (apart, 1 m); }
        body one { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start omega: 2 rad/s, locked; }
        body two { mass: 1 kg; inertia: 0.03 kg*m^2; port hub: (0, 0) m; start x: 0.15 m; start omega: 0 rad/s, locked; }
        revolute at_one(ground.a, one.hub);
        revolute at_two(ground.b, two.hub);
        gear loose(ground.a, one.hub, two.hub) { radius_a: 50 mm; radius_b: 100 mm; backlash: 1 mm; restitution: e; }
        body three { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start y: 1 m; start omega: 0 rad/s, locked; }
        body four { mass: 1 kg; inertia: 0.03 kg*m^2; port hub: (0, 0) m; start x: apart; start y: 1 m; start omega: 0 rad/s, locked; }
        revolute at_three(ground.c, three.hub) { drive: 4 N*m; }
        revolute at_four(ground.d, four.hub) { damping: 0.5 N*m*s; }
        gear driven(ground.c, three.hub, four.hub) { radius_a: 50 mm; radius_b: 100 mm; backlash: 1 mm; efficiency: efficiency; }
        output loose.play_taken, loose.tooth_force, driven.play_taken, driven.tooth_force, driven.torque_a, driven.torque_b, driven.lost;
        output driven.radial_force, at_three.force;
    }
}

/// Masses along the pitch circles m1 = J1/r1^2 = 4 kg, m2 = 3 kg. The flanks meet after 0.5 mm, and after 1 mm each time behind that; the
/// relative speed turns round with e, the momentum stays.
#[test]
fn gears_rattle_in_their_play() {
    let mut sim = Play::new().start_with(Dop853::new(1e-10)).unwrap();
    let (m1, m2, e, v) = (4.0, 3.0, 0.8, 0.1);
    let (mut time, mut relative) = (0.5e-3 / v, v);
    for hit in 0..6 {
        sim.step_to(time - 1e-7).unwrap();
        let speed = |sim: &plm::Sim<Play>| 0.05 * sim.one().omega + 0.1 * sim.two().omega;
        near(speed(&sim), relative, 1e-9);
        let flank = if hit % 2 == 0 { 0.5e-3 } else { -0.5e-3 };
        near(sim.loose_play_taken(), flank - 1e-7 * relative, 1e-11);
        sim.step_to(time + 1e-7).unwrap();
        relative *= -e;
        near(speed(&sim), relative, 1e-9);
        near(m1 * 0.05 * sim.one().omega - m2 * 0.1 * sim.two().omega, m1 * v, 1e-9);
        time += 1e-3 / relative.abs();
    }
}

/// The wheel that is driven gets its share of the power; the bearings bear the tooth force along the line of action, which the distance of
/// the centres inclines: cos a = (r_a + r_b) cos 20 deg/distance.
#[test]
fn driven_gears_press_along_the_line_of_action() {
    for (apart, efficiency) in [(0.15, 0.95), (0.152, 1.0)] {
        let mut sim = Play { apart, efficiency, ..Play::new() }.start_with(Dop853::new(1e-10)).unwrap();
        sim.step_to(0.5).unwrap();
        let (three, four) = (sim.three(), sim.four());
        near(three.omega, -2.0 * four.omega, 1e-8);
        let taken = -sim.driven_torque_a() * three.omega;
        near(sim.driven_torque_b() * four.omega, efficiency * taken, 1e-7 * taken);
        near(sim.driven_lost(), (1.0 - efficiency) * taken, 1e-7 * taken);
        let cos = 0.15 * 20_f64.to_radians().cos() / apart;
        let [along, across] = sim.at_three_force();
        if efficiency == 1.0 {
            near(along.abs() / across.abs(), (1.0 - cos * cos).sqrt() / cos, 1e-7);
            near(along.hypot(across), sim.driven_tooth_force(), 1e-7 * sim.driven_tooth_force());
            // Base circles: the arm of the tooth force is r cos 20 deg.
            near(sim.driven_torque_a(), -0.05 * 20_f64.to_radians().cos() * sim.driven_tooth_force(), 1e-7);
        }
    }
}
