//! Cams and Geneva drives.

use std::f64::consts::PI;

use plm::runtime::contact::Mode;
use plm::{Dop853, Mechanism as _, Moment as _, Sim};

use super::{G, near};
use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// A shaft with a harmonic cam under a flat follower and under a knife, and an eccentric under a roller and under one on an arm; two
    /// Geneva drives.
    pub Cams {
        param speed: rad/s = 20 rad/s;
        gravity: 9.81 m/s^2;
        ground { port cam: (0, 0) m, axis: 90 deg; port indexer: (0, 0) m, axis: 15 deg; }
        body shaft { mass: 1 kg; inertia: 1 kg*m^2; port cam: (0, 0) m, angle: 90 deg; port o: (0, 0) m, angle: 15 deg; }
        revolute bearing(ground.cam, shaft.cam);
        constraint drive: shaft.angle = speed*t;

        body plate { mass: 0.5 kg; inertia: 1 kg*m^2; port c: (0, 0) m, angle: 90 deg; start y: 30 mm; }
        prismatic tappet(ground.cam, plate.c) { stiffness: 2000 N/m; free_length: 25 mm; }
        cam flat(shaft.cam, plate.c) { face: flat; base_radius: 30 mm; lift(a): 10 mm*(1 - cos(a)); }
        body edge { mass: 0.5 kg; inertia: 1 kg*m^2; port c: (0, 0) m, angle: 90 deg; start x: -5 mm; start y: sqrt((30 mm)^2 - (5 mm)^2); }
        ground { port beside: (-5 mm, 0 m), axis: 90 deg; }
        prismatic blade(ground.beside, edge.c) { stiffness: 2000 N/m; free_length: 0 mm; }
        cam knife(shaft.cam, edge.c) { face: knife; base_radius: 30 mm; offset: 5 mm; lift(a): 10 mm*(1 - cos(a)); friction: 0.15; }
        // A disc of 30 mm, 10 mm beside its shaft, under a roller of 10 mm.
        body rod { mass: 0.5 kg; inertia: 1 kg*m^2; port c: (0, 0) m, angle: 90 deg; start y: 30 mm; }
        prismatic valve(ground.cam, rod.c) { stiffness: 2000 N/m; free_length: 0 mm; }
        cam roller(shaft.cam, rod.c) {
            base_radius: 20 mm;
            roller_radius: 10 mm;
            lift(angle): -10 mm*cos(angle) + sqrt((40 mm)^2 - (10 mm*sin(angle))^2) - 30 mm;
        }
        // A disc of 30 mm, 10 mm beside its shaft, under a roller of 10 mm on an arm of 95 mm, whose pivot is 100 mm above the shaft.
        ground { port pivot: (0, 100) mm; }
        body arm {
            mass: 0.5 kg;
            inertia: 1e-3 kg*m^2;
            port o: (0, 0) mm;
            start y: 100 mm;
            start angle: 270 deg - acos(((95 mm)^2 + (90 mm)^2 - (40 mm)^2)/(2*95 mm*90 mm));
            start omega: -speed/9;
        }
        revolute pivot(ground.pivot, arm.o) { stiffness: 20 N*m/rad; rest: 300 deg; }
        oscillating_follower lever(ground.cam, shaft.cam, arm.o) {
            distance: 100 mm;
            arm_length: 95 mm;
            roller_radius: 10 mm;
            swing(a): atan2(10 mm*sin(a), 100 mm - 10 mm*cos(a))
                + acos(((95 mm)^2 + (100 mm)^2 + (10 mm)^2 - 2*(10 mm)*(100 mm)*cos(a) - (40 mm)^2)
                    /(2*95 mm*sqrt((100 mm)^2 + (10 mm)^2 - 2*(10 mm)*(100 mm)*cos(a))));
        }

        body four { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0, 0) m; start x: 0.1 m*cos(15 deg); start y: 0.1 m*sin(15 deg); start angle: 15 deg; }
        ground { port four: (0.1*cos(15 deg), 0.1*sin(15 deg)) m; }
        revolute axle4(ground.four, four.o);
        geneva cross(ground.indexer, shaft.o, four.o) { slots: 4; }
        body six { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0, 0) m; start x: 0.1 m*cos(15 deg); start y: 0.1 m*sin(15 deg); start angle: 15 deg; }
        revolute axle6(ground.four, six.o);
        geneva star(ground.indexer, shaft.o, six.o) { slots: 6; }

        output flat.push, flat.gap, flat.torque, flat.contact_offset, flat.curvature_radius, plate.acceleration;
        output knife.push, knife.lost, knife.torque, knife.pressure_angle, knife.lift, edge.velocity, edge.acceleration;
        output roller.push, roller.torque, roller.pressure_angle, roller.curvature_radius, rod.acceleration;
        output lever.push, lever.gap, lever.torque, lever.arm_torque, lever.pressure_angle, arm.alpha, pivot.torque, pivot.force;
        output cross.ratio, cross.engaged, cross.torque, cross.pin_force, star.ratio, six.alpha, motor = -reaction(drive);
    }
}

const RISE: f64 = 0.01;

fn run(mechanism: &Scene) -> Sim<Scene> {
    mechanism.start_with(Dop853::new(1e-10)).unwrap()
}

/// A follower m on a spring k with the force p at the base lifts off a harmonic cam of lift e (1 - cos) from
/// omega^2 = (2 k e + p + m g)/(m e) on, where it is at its top.
#[test]
fn a_follower_lifts_off() {
    let (mass, stiffness) = (0.5, 2000.0);
    let held = stiffness * 0.005 + mass * G;
    let limit = ((2.0 * stiffness * RISE + held) / (mass * RISE)).sqrt();
    for (speed, mode) in [(limit * (1.0 - 1e-6), Mode::Closed), (limit * (1.0 + 1e-6), Mode::Open)] {
        let mut sim = run(&Cams::new().with("speed", speed));
        sim.step_to(PI / speed).unwrap();
        assert_eq!(sim.contact("flat.contact"), Some(mode), "{speed} rad/s");
    }
    // Faster, it lifts off where m e omega^2 cos + k e (1 - cos) + p + m g = 0.
    let speed = 1.2 * limit;
    let mut sim = run(&Cams::new().with("speed", speed));
    let cos = -(stiffness * RISE + held) / (mass * RISE * speed * speed - stiffness * RISE);
    let time = cos.acos() / speed;
    sim.step_to(time - 1e-9).unwrap();
    assert_eq!(sim.contact("flat.contact"), Some(Mode::Closed));
    sim.step_to(time + 1e-9).unwrap();
    assert_eq!(sim.contact("flat.contact"), Some(Mode::Open));
    sim.step(1e-3).unwrap();
    assert!(sim.value_of("flat.gap") > 0.0);
}

/// A flat follower: force m a + k s + m g, its place e sin beside the axis, the torque -N e sin, and the radius of curvature r + e.
#[test]
fn a_flat_follower_is_pushed_beside_its_axis() {
    let mut sim = run(&Cams::new());
    for _ in 0..10 {
        sim.step(0.03).unwrap();
        let (sin, cos) = (20.0 * sim.time()).sin_cos();
        let push = 0.5 * RISE * 400.0 * cos + 2000.0 * (0.005 + RISE * (1.0 - cos)) + 0.5 * G;
        near(sim.value_of("flat.push"), push, 1e-8);
        near(sim.value_of("flat.contact_offset"), -RISE * sin, 1e-12);
        near(sim.value_of("flat.torque"), -push * RISE * sin, 1e-9);
        near(sim.value_of("flat.curvature_radius"), 0.04, 1e-12);
    }
}

/// An eccentric is a crank of 10 mm with a coupler of 40 mm: sin(pressure angle) = -10/40 sin, and its pitch curve a circle of 40 mm.
#[test]
fn a_roller_on_an_eccentric_is_a_slider_crank() {
    let mut sim = run(&Cams::new());
    for _ in 0..10 {
        sim.step(0.03).unwrap();
        let (sin, cos) = (20.0 * sim.time()).sin_cos();
        let lean = 0.25 * sin;
        near(sim.value_of("roller.pressure_angle"), lean.asin(), 1e-9);
        near(sim.value_of("roller.curvature_radius"), 0.04, 1e-9);
        let place = -RISE * cos + 0.04 * (1.0 - lean * lean).sqrt();
        near(sim.state_of("rod").y, place, 1e-9);
        let along = 0.5 * (sim.vector_of("rod.acceleration")[1] + G) + 2000.0 * place;
        near(sim.value_of("roller.push"), along / (1.0 - lean * lean).sqrt(), 1e-7);
        // The lever of the coupler's force about the shaft.
        let lever = RISE * (sin - cos * lean / (1.0 - lean * lean).sqrt());
        near(sim.value_of("roller.torque"), -along * lever, 1e-7);
    }
}

/// An eccentric pushes along the line from its centre to that of the roller: the coupler of a four-bar with the crank 10 mm, the coupler
/// 40 mm and the rocker 95 mm, whose force turns the arm and loads its pivot.
#[test]
fn a_roller_on_an_arm_is_a_four_bar() {
    let mut sim = run(&Cams::new());
    for _ in 0..10 {
        sim.step(0.03).unwrap();
        let (sin, cos) = (20.0 * sim.time()).sin_cos();
        let centre = [-RISE * sin, RISE * cos];
        let (angle, alpha) = (sim.state_of("arm").angle, sim.value_of("arm.alpha"));
        let arm = [0.095 * angle.cos(), 0.095 * angle.sin()];
        let between = [arm[0] - centre[0], 0.1 + arm[1] - centre[1]];
        let length = between[0].hypot(between[1]);
        near(length, 0.04, 1e-9);
        near(sim.value_of("lever.gap"), 0.0, 1e-9);
        let normal = between.map(|x| x / length);
        let moment = 1e-3 * alpha - sim.value_of("pivot.torque");
        let push = moment / (arm[0] * normal[1] - arm[1] * normal[0]);
        near(sim.value_of("lever.push"), push, 1e-7);
        near(sim.value_of("lever.arm_torque"), moment, 1e-8);
        near(sim.value_of("lever.torque"), -push * (centre[0] * normal[1] - centre[1] * normal[0]), 1e-8);
        // The way of the roller where the cam lifts it: clockwise about the pivot.
        let way = [arm[1] / 0.095, -arm[0] / 0.095];
        near(sim.value_of("lever.pressure_angle").cos(), way[0] * normal[0] + way[1] * normal[1], 1e-9);
        // On the ground: the pivot holds the weight and the push.
        near(sim.vector_of("pivot.force")[0], push * normal[0], 1e-7);
        near(sim.vector_of("pivot.force")[1], push * normal[1] - 0.5 * G, 1e-7);
    }
}

/// Power of the shaft: what the followers take up, and mu N times the sliding speed. The other followers rub nowhere.
#[test]
fn a_knife_rubs() {
    let mut sim = run(&Cams::new());
    for _ in 0..10 {
        sim.step(0.03).unwrap();
        let (sin, cos) = (20.0 * sim.time()).sin_cos();
        let top = (0.03_f64.powi(2) - 0.005_f64.powi(2)).sqrt() + RISE * (1.0 - cos);
        let lean = (RISE * sin + 0.005) / top;
        near(sim.value_of("knife.pressure_angle"), lean.atan(), 1e-9);
        // Its speed along the tangent: omega times the distance from the shaft over the cosine of the angle between.
        let sliding = 20.0 * ((RISE * sin + 0.005).powi(2) + top * top).sqrt();
        near(sim.value_of("knife.lost"), 0.15 * sim.value_of("knife.push") * sliding, 1e-8);
        let [_, speed] = sim.vector_of("edge.velocity");
        let upwards = 0.5 * (sim.vector_of("edge.acceleration")[1] + G) + 2000.0 * sim.state_of("edge").y;
        near(-sim.value_of("knife.torque") * 20.0, upwards * speed + sim.value_of("knife.lost"), 1e-7);
        let others = sim.value_of("flat.torque")
            + sim.value_of("roller.torque")
            + sim.value_of("knife.torque")
            + sim.value_of("lever.torque");
        // The Geneva wheels need torque too: 0.02 kg m^2 each.
        let wheels = sim.value_of("cross.torque") * sim.value_of("cross.ratio")
            + 0.02 * sim.value_of("six.alpha") * sim.value_of("star.ratio");
        near(sim.value_of("motor"), wheels - others, 1e-7);
    }
}

/// With the driver at phi from the line of centres: tan = l sin/(1 - l cos), ratio -l (cos - l)/(1 - 2 l cos + l^2), l = sin(pi/n).
#[test]
fn geneva_drives_index_and_lock() {
    let mut sim = run(&Cams::new().with("speed", 2.0));
    for k in 0..64 {
        sim.step_to(0.1 * f64::from(k)).unwrap();
        let angle: f64 = 2.0 * sim.time();
        let turn = (angle / (2.0 * PI)).round();
        let phase = angle - 2.0 * PI * turn;
        for (slots, wheel, ratio) in [
            (4.0, sim.state_of("four"), sim.value_of("cross.ratio")),
            (6.0, sim.state_of("six"), sim.value_of("star.ratio")),
        ] {
            let l = (PI / slots).sin();
            let entry = PI / 2.0 - PI / slots;
            let [turned, speed] = if phase.abs() < entry {
                let (sin, cos) = phase.sin_cos();
                [-(l * sin / (1.0 - l * cos)).atan(), -l * (cos - l) / (1.0 - 2.0 * l * cos + l * l)]
            } else {
                [-phase.signum() * PI / slots, 0.0]
            };
            let known = 15_f64.to_radians() - 2.0 * PI / slots * turn + turned;
            near(wheel.angle, known, 1e-10);
            near(ratio, speed, 1e-10);
            near(wheel.omega, 2.0 * speed, 1e-10);
        }
        assert_eq!(sim.value_of("cross.engaged"), if phase.abs() < PI / 4.0 { 1.0 } else { 0.0 });
    }
    // The pin's force times its distance from the wheel is the torque on the wheel.
    sim.step_to(2.0 * PI + 0.2).unwrap();
    let l = (PI / 4.0).sin();
    let distance = 0.1 * (1.0 - 2.0 * l * 0.4_f64.cos() + l * l).sqrt();
    near(sim.value_of("cross.pin_force") * distance, sim.value_of("cross.torque"), 1e-9);
}
