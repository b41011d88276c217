//! Tasks with gears and with a Geneva drive.

use std::f64::consts::TAU;

use super::check;

/// A gear that loses a share gives the driven wheel that share less; with a fixed ring a planetary gear of k = 72/24 turns the torque of its
/// sun into 1 + k e times of it (VDI 2157: the train where the carrier stands has the efficiency e). Bearings bear what teeth turn.
#[test]
fn a_hoist_with_a_pair_and_a_planetary_gear() {
    let (motor, load, pair, stands, k) = (10.0, 80.0, 0.98, 0.97, 3.0);
    let (pinion, wheel, drum) = (0.5 * 0.04_f64.powi(2), 3.0 * 0.12_f64.powi(2), 20.0);
    let turned = 1.0 + k * stands;
    let alpha = (turned * 3.0 * pair * motor - load) / (drum + turned * (4.0 * wheel + 36.0 * pair * pinion));
    let at_pinion = motor - 12.0 * alpha * pinion;
    let at_wheel = 3.0 * pair * at_pinion;
    let at_sun = at_wheel - 4.0 * alpha * wheel;
    let speed = 2.0 * alpha;
    // Both flanks see the same normal force but for the friction, which is half of what is lost on either side.
    let tangential = 0.5 * (at_pinion / 0.04 + at_wheel / 0.12);
    let bearing = (at_pinion + at_wheel) / 0.16;
    let lost = (1.0 - pair) * at_pinion * 12.0 * speed + at_sun * 4.0 * speed * (1.0 - turned / (1.0 + k));
    check(
        "gears",
        &[
            ("speed of the drum after 2 s", speed * 60.0 / TAU, 1e-7),
            ("torque on the drum", turned * at_sun, 1e-9),
            ("torque on the fixed ring", -k * stands * at_sun, 1e-9),
            ("force of the teeth of the pair", tangential / 20_f64.to_radians().cos(), 1e-8),
            ("force of the motor's bearing", bearing, 1e-8),
            ("efficiency of both gears", 1.0 - lost / (12.0 * motor * speed), 1e-10),
        ],
    );
}

/// Kinematics of an external Geneva drive: J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, 1980.
#[test]
fn a_table_with_six_stations() {
    let (distance, inertia, speed) = (0.16, 2.0, TAU);
    let crank = (TAU / 12.0).sin();
    let (mut force, mut torque) = (0.0_f64, 0.0_f64);
    for step in 0..6000 {
        let angle = f64::from(step) * 1e-4;
        let (sin, cos) = angle.sin_cos();
        let square = 1.0 - 2.0 * crank * cos + crank * crank;
        let ratio = crank * (cos - crank) / square;
        let alpha = speed * speed * crank * sin * (1.0 - crank * crank) / (square * square);
        force = force.max(inertia * alpha / (distance * square.sqrt()));
        torque = torque.max(inertia * alpha * ratio);
    }
    check(
        "geneva",
        &[
            ("the table rests for", 1.0 - 120.0 / 360.0, 3e-4),
            ("it turns in that turn by", -60.0, 1e-9),
            ("greatest speed over the driver's", crank / (1.0 - crank), 1e-5),
            ("greatest force of the pin", force, 1e-4 * force),
            ("greatest torque of the motor", torque, 1e-4 * torque),
        ],
    );
}
