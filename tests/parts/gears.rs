//! Gears and racks in the plane: tooth forces, epicyclic motion, play, efficiency.

use plm::{Dop853, Mechanism as _};

use crate::declared::{Meshes, Play};
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

/// 2 N m on 0.01 + 0.27/9 = 0.04 kg m^2, seen from the pinion.
#[test]
fn teeth_press_on_each_other_and_on_the_bearings() {
    let mut sim = Meshes::new().start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(0.3).unwrap();
    let alpha = 2.0 / 0.04;
    near(sim.value_of("wheel.omega"), -alpha * 0.3 / 3.0, 1e-9);
    near(sim.value_of("mesh.torque_b"), -0.27 * alpha / 3.0, 1e-9);
    near(sim.value_of("mesh.torque_a"), -0.27 * alpha / 9.0, 1e-9);
    let tangential = 0.27 * alpha / 9.0 / 0.05;
    near(sim.value_of("mesh.tooth_force"), tangential / 20_f64.to_radians().cos(), 1e-9);
    near(sim.value_of("mesh.radial_force"), tangential * 20_f64.to_radians().tan(), 1e-9);
    // The wheel presses the pinion down at the right, and its bearing presses it up: on the ground it is down.
    near(sim.vector_of("first.force")[1], -tangential, 1e-9);
    near(sim.vector_of("second.force")[1], tangential, 1e-9);

    // 3 N m on 0.01 + 2 0.05^2.
    let alpha = 3.0 / (0.01 + 2.0 * 0.0025);
    near(sim.state_of("roller").omega, 0.3 * alpha, 1e-9);
    near(sim.state_of("bar").vx, 0.05 * sim.value_of("roller.omega"), 1e-12);
    near(sim.value_of("teeth.force"), -2.0 * 0.05 * alpha, 1e-9);
    near(sim.value_of("teeth.torque"), -2.0 * 0.05 * 0.05 * alpha, 1e-9);
    // The bearing takes what the rack presses with; the rack's line passes through its own centre, so that its guide bears no torque.
    near(sim.vector_of("hub.force")[0].abs(), 2.0 * 0.05 * alpha, 1e-9);
}

/// Willis in the plane, for whole turns of the arm: (w_s - w_a)/(w_p - w_a) = -50/100, (w_p - w_a)/(w_r - w_a) = 200/50.
#[test]
fn a_planet_turns_by_willis_between_a_sun_and_a_ring() {
    let mut sim = Meshes::new().start_with(Dop853::new(1e-10)).unwrap();
    let energy = sim.kinetic_energy();
    sim.step_to(5.0).unwrap();
    let (sun, arm, planet, ring) =
        (sim.state_of("sun"), sim.state_of("arm"), sim.state_of("planet"), sim.state_of("ring"));
    assert!(arm.angle > 6.3, "{}", arm.angle);
    near(planet.omega - arm.omega, -2.0 * (sun.omega - arm.omega), 1e-9);
    near(ring.omega - arm.omega, 0.25 * (planet.omega - arm.omega), 1e-9);
    near(planet.angle - arm.angle, -2.0 * (sun.angle - arm.angle), 1e-9);
    // 2 N m and 3 N m work on the other two; what is left stays.
    let worked = 2.0 * sim.state_of("pinion").angle + 3.0 * sim.state_of("roller").angle;
    near(sim.kinetic_energy() - energy, worked, 1e-8 * worked);
}

/// Masses along the pitch circles m1 = J1/r1^2 = 4 kg, m2 = 3 kg. The flanks meet after 0.5 mm, and after 1 mm each time after that; the
/// relative speed turns round with e, the momentum stays.
#[test]
fn gears_rattle_in_their_play() {
    let mut sim = Play::new().start_with(Dop853::new(1e-10)).unwrap();
    let (m1, m2, e, v) = (4.0, 3.0, 0.8, 0.1);
    let (mut time, mut relative) = (0.5e-3 / v, v);
    for hit in 0..6 {
        sim.step_to(time - 1e-7).unwrap();
        let speed =
            |sim: &plm::Sim<Scene>| 0.05 * sim.state_of("one").omega + 0.1 * sim.state_of("two").omega;
        near(speed(&sim), relative, 1e-9);
        let flank = if hit % 2 == 0 { 0.5e-3 } else { -0.5e-3 };
        near(sim.value_of("loose.play_taken"), flank - 1e-7 * relative, 1e-11);
        sim.step_to(time + 1e-7).unwrap();
        relative *= -e;
        near(speed(&sim), relative, 1e-9);
        near(m1 * 0.05 * sim.state_of("one").omega - m2 * 0.1 * sim.state_of("two").omega, m1 * v, 1e-9);
        time += 1e-3 / relative.abs();
    }
}

/// The wheel that is driven gets its share of the power; the bearings bear the tooth force along the line of action, which the distance of
/// the centres inclines: cos a = (r_a + r_b) cos 20 deg/distance.
#[test]
fn driven_gears_press_along_the_line_of_action() {
    for (apart, efficiency) in [(0.15, 0.95), (0.152, 1.0)] {
        let mut sim = Play::new()
            .with("apart", apart)
            .with("efficiency", efficiency)
            .start_with(Dop853::new(1e-10))
            .unwrap();
        sim.step_to(0.5).unwrap();
        let (three, four) = (sim.state_of("three"), sim.state_of("four"));
        near(three.omega, -2.0 * four.omega, 1e-8);
        let taken = -sim.value_of("driven.torque_a") * three.omega;
        near(sim.value_of("driven.torque_b") * four.omega, efficiency * taken, 1e-7 * taken);
        near(sim.value_of("driven.lost"), (1.0 - efficiency) * taken, 1e-7 * taken);
        let cos = 0.15 * 20_f64.to_radians().cos() / apart;
        let [along, across] = sim.vector_of("at_three.force");
        if efficiency == 1.0 {
            near(along.abs() / across.abs(), (1.0 - cos * cos).sqrt() / cos, 1e-7);
            near(
                along.hypot(across),
                sim.value_of("driven.tooth_force"),
                1e-7 * sim.value_of("driven.tooth_force"),
            );
            // Base circles: the arm of the tooth force is r cos 20 deg.
            near(
                sim.value_of("driven.torque_a"),
                -0.05 * 20_f64.to_radians().cos() * sim.value_of("driven.tooth_force"),
                1e-7,
            );
        }
    }
}
