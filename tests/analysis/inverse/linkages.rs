//! Closed chains: four-bar, slider-crank, five-bar, with as many drives as freedoms and with more.

use plm::Moment;
use plm::inverse::{Inverse, Unsolved, Wanted};

use super::newton_euler::{Body, Joint, Point, bar, drives, dyad, on_bar};
use super::{angle, near, started};

pub(super) const FOUR_BAR: &str = "pub FourBar {
    gravity: 9.81 m/s^2;
    input torque: N*m = 0;
    input other: N*m = 0;
    ground { port left: (0, 0) m; port right: (0.4, 0) m; }
    body crank {
        mass: 1.1 kg; inertia: 0.004 kg*m^2; port pivot: (-0.04, -0.01) m; port pin: (0.06, -0.01) m;
        start angle: 0.7 rad, locked; start omega: 12 rad/s, locked;
    }
    body coupler {
        mass: 1.7 kg; inertia: 0.02 kg*m^2; port pin: (-0.2, -0.03) m; port end: (0.15, -0.03) m;
        start angle: 0.5 rad;
    }
    body rocker {
        mass: 1.4 kg; inertia: 0.012 kg*m^2; port pivot: (-0.1, 0.02) m; port end: (0.15, 0.02) m;
        start angle: 1.9 rad;
    }
    revolute main(ground.left, crank.pivot) { drive: torque; }
    revolute pin(crank.pin, coupler.pin);
    revolute end(coupler.end, rocker.end);
    revolute side(ground.right, rocker.pivot) { damping: 0.05 N*m*s/rad; drive: other; }
}";

pub(super) const PRESS: &str = "pub Press {
    gravity: 9.81 m/s^2;
    input torque: N*m = 0;
    input push: N = 0;
    ground { port o: (0, 0) m; }
    body crank {
        mass: 2 kg; inertia: 0.01 kg*m^2; port o: (-0.03, 0) m; port pin: (0.07, 0) m;
        start angle: 0.4 rad, locked; start omega: 20 rad/s, locked;
    }
    body rod { mass: 1.2 kg; inertia: 0.01 kg*m^2; port pin: (-0.15, 0) m; port end: (0.25, 0) m; }
    body slider { mass: 3 kg; inertia: 0.01 kg*m^2; port end: (0, 0) m; start x: 0.5 m; }
    revolute main(ground.o, crank.o) { drive: torque; }
    revolute pin(crank.pin, rod.pin);
    revolute end(rod.end, slider.end);
    prismatic guide(ground.o, slider.end);
    force cutting(slider.end) { x: push - 800 N; }
}";

pub(super) const FIVE_BAR: &str = "pub FiveBar {
    gravity: 9.81 m/s^2;
    input left: N*m = 0;
    input right: N*m = 0;
    input elbow: N*m = 0;
    ground { port left: (-50, 0) mm; port right: (50, 0) mm; }
    body left_arm {
        mass: 0.5 kg; inertia: 1e-3 kg*m^2; port motor: (-50, 0) mm; port elbow: (70, 0) mm;
        start angle: 120 deg, locked; start omega: 3 rad/s, locked;
    }
    body right_arm {
        mass: 0.6 kg; inertia: 1.2e-3 kg*m^2; port motor: (-50, 0) mm; port elbow: (70, 0) mm;
        start angle: 60 deg, locked; start omega: -2 rad/s, locked;
    }
    body left_rod {
        mass: 0.3 kg; inertia: 8e-4 kg*m^2; port elbow: (-80, 0) mm; port pen: (80, 0) mm; start angle: 45 deg;
    }
    body right_rod {
        mass: 0.4 kg; inertia: 9e-4 kg*m^2; port elbow: (-80, 0) mm; port pen: (80, 0) mm; start angle: 135 deg;
    }
    revolute left_motor(ground.left, left_arm.motor) { drive: left; }
    revolute right_motor(ground.right, right_arm.motor) { drive: right; }
    revolute left_elbow(left_arm.elbow, left_rod.elbow) { drive: elbow; }
    revolute right_elbow(right_arm.elbow, right_rod.elbow);
    revolute pen(left_rod.pen, right_rod.pen);
}";

/// The torque on the crank, or those on both cranks with a weight of 1 on the first, by free bodies; and the rocker's angle.
fn four_bar(crank: [f64; 3], second: Option<f64>) -> (Vec<f64>, [f64; 3]) {
    let ground = [Point::fixed(0.0, 0.0), Point::fixed(0.4, 0.0)];
    let pin = on_bar(ground[0], crank, 0.1, 0.0);
    let end = dyad(pin, ground[1], [0.35, 0.25], true);
    let (coupler, rocker) = (bar(pin, end), bar(ground[1], end));
    let body = |mass, inertia, from, angle, along, across, torque| {
        let centre = on_bar(from, angle, along, across);
        Body { mass, inertia, centre, angle, force: [0.0; 2], torque }
    };
    let bodies = [
        body(1.1, 0.004, ground[0], crank, 0.04, 0.01, 0.0),
        body(1.7, 0.02, pin, coupler, 0.2, 0.03, 0.0),
        body(1.4, 0.012, ground[1], rocker, 0.1, -0.02, -0.05 * rocker[1]),
    ];
    let mut joints = vec![
        Joint::Pin(None, 0, ground[0].0[0]),
        Joint::Pin(Some(0), 1, pin.0[0]),
        Joint::Pin(Some(1), 2, end.0[0]),
        Joint::Pin(None, 2, ground[1].0[0]),
        Joint::Motor(None, 0, 1.0),
    ];
    joints.extend(second.map(|weight| Joint::Motor(None, 2, weight)));
    (drives(&bodies, &joints), rocker)
}

#[test]
fn of_a_four_bar_over_a_turn() {
    for (formulation, steps) in [("", 90), ("formulation: absolute;", 15)] {
        let declaration = FOUR_BAR.replace("gravity", &format!("{formulation} gravity"));
        let sim = started(&declaration);
        let inverse = Inverse::new(sim.state().mechanism(), ["crank.angle"], ["torque"]).unwrap();
        // From where it is to a turn further, ever faster.
        let motion = |t: f64| [0.7 + 12.0 * t + 15.0 * t * t, 12.0 + 30.0 * t, 30.0];
        let wanted = |t: f64| {
            let [place, velocity, acceleration] = motion(t).map(|number| [number]);
            Wanted { place, velocity, acceleration }
        };
        let (mut count, mut largest) = (0, 0.0_f64);
        inverse
            .over(sim.state(), (0..=steps).map(|k| f64::from(k) * 5e-3), wanted, |state, [torque]| {
                let (known, _) = four_bar(motion(f64::from(count) * 5e-3), None);
                near(torque, known[0], 1e-10);
                near(angle(state, "crank")[1], motion(f64::from(count) * 5e-3)[1], 1e-12);
                (count, largest) = (count + 1, largest.max(torque.abs()));
            })
            .unwrap();
        assert!(count == steps + 1 && largest > 2.0, "{count} {largest}");
    }
}

/// The same torque gives the rocker its acceleration, two torques share the work by their weights, and both coordinates follow one.
#[test]
fn of_a_four_bar_by_its_rocker_and_by_two_drives() {
    let mut sim = started(FOUR_BAR);
    sim.step(0.05).unwrap();
    let mechanism = *sim.state().mechanism();
    let [place, velocity] = angle(sim.state(), "crank");
    let (known, rocker) = four_bar([place, velocity, 25.0], None);
    let by_rocker = Inverse::new(&mechanism, ["rocker.angle"], ["torque"]).unwrap();
    near(by_rocker.inputs(&sim, [rocker[2]]).unwrap()[0], known[0], 1e-10);

    let (shared, _) = four_bar([place, velocity, 25.0], Some(3.0));
    let both = Inverse::new(&mechanism, ["crank.angle"], ["torque", "other"]).unwrap().weighted([1.0, 3.0]);
    let found = both.inputs(&sim, [25.0]).unwrap();
    near(found[0], shared[0], 1e-10);
    near(found[1], shared[1], 1e-10);
    // About what the crank needs alone nothing has to be added.
    let [alone, zero] = both.about([known[0], 0.0]).inputs(&sim, [25.0]).unwrap();
    near(alone, known[0], 1e-10);
    near(zero, 0.0, 1e-10);

    let two = Inverse::new(&mechanism, ["crank.angle", "rocker.angle"], ["torque", "other"]).unwrap();
    let found = two.inputs(&sim, [25.0, rocker[2]]).unwrap();
    let (shared, _) = four_bar([place, velocity, 25.0], Some(1.0));
    near(found[1], shared[1], 1e-10);
    let refused = two.inputs(&sim, [25.0, rocker[2] + 1.0]).unwrap_err();
    let Unsolved::Dependent { target: "rocker.angle", misses, .. } = refused else { panic!("{refused}") };
    near(misses, 1.0, 1e-9);
}

/// A motion of measured points by a constraint: its reaction is the torque that inverse dynamics finds for place, speed and acceleration there.
#[test]
fn of_a_four_bar_that_follows_a_table() {
    let told = FOUR_BAR
        .replace("start angle: 0.7 rad, locked; start omega: 12 rad/s, locked;", "start angle: 0.7 rad;")
        .replace(
            "revolute pin(",
            "constraint told: crank.angle = smooth_table(t, (0 s, 0.7 rad), (0.1 s, 1.3 rad), (0.25 s, 2.9 rad),
                (0.3 s, 3.2 rad), (0.5 s, 2.1 rad));
            output torque_told = -reaction(told), crank.alpha;
            revolute pin(",
        );
    let (mut told, free) = (started(&told), started(FOUR_BAR));
    let inverse = Inverse::new(free.state().mechanism(), ["crank.angle"], ["torque"]).unwrap();
    let (mut state, mut largest) = (*free.state(), 0.0_f64);
    for k in 1..50 {
        told.step_to(0.01 * f64::from(k)).unwrap();
        let [place, velocity] = angle(told.state(), "crank");
        let [torque, alpha] = [0, 1].map(|output| told.state().output(output).unwrap());
        let wanted = Wanted { place: [place], velocity: [velocity], acceleration: [alpha] };
        state = inverse.place(&state, 0.01 * f64::from(k), &wanted).unwrap();
        near(inverse.inputs(&state, [alpha]).unwrap()[0], torque, 1e-10);
        near(four_bar([place, velocity, alpha], None).0[0], torque, 1e-10);
        largest = largest.max(velocity.abs());
    }
    assert!(largest > 8.0, "{largest}");
}

#[test]
fn of_a_slider_crank_that_cuts() {
    let mut sim = started(PRESS);
    let inverse = Inverse::new(sim.state().mechanism(), ["crank.angle"], ["torque"]).unwrap();
    let by_slider = Inverse::new(sim.state().mechanism(), ["slider.x"], ["torque"]).unwrap();
    for _ in 0..20 {
        sim.step(2e-3).unwrap();
        let [place, velocity] = angle(sim.state(), "crank");
        let (known, slider) = slider_crank([place, velocity, -40.0]);
        near(inverse.inputs(&sim, [-40.0]).unwrap()[0], known[0], 1e-10);
        near(by_slider.inputs(&sim, [slider]).unwrap()[0], known[0], 1e-9);
    }
    // At a dead point the crank pushes the slider nowhere, and the slider the crank.
    let at_dead_point = Wanted { place: [0.0], velocity: [4.0], acceleration: [0.0] };
    let dead = inverse.place(sim.state(), 0.1, &at_dead_point).unwrap();
    let refused = by_slider.inputs(&dead, [1.0]).unwrap_err();
    assert_eq!(refused, Unsolved::Unmoved { time: 0.1, target: "slider.x" });
    let pushed = Inverse::new(dead.mechanism(), ["crank.angle"], ["push"]).unwrap();
    let refused = pushed.inputs(&dead, [1.0]).unwrap_err();
    assert_eq!(refused, Unsolved::Unmoved { time: 0.1, target: "crank.angle" });
}

/// The torque, and the acceleration of the slider.
fn slider_crank(crank: [f64; 3]) -> (Vec<f64>, f64) {
    let origin = Point::fixed(0.0, 0.0);
    let pin = on_bar(origin, crank, 0.1, 0.0);
    let [[px, py], [pvx, pvy], [pax, pay]] = pin.0;
    let dx = (0.4 * 0.4 - py * py).sqrt();
    // The rod keeps its length: d . v = 0, d . a + v . v = 0, where d, v, a are relative.
    let vx = pvx - py * pvy / dx;
    let ax = pax - (py * pay + (vx - pvx).powi(2) + pvy * pvy) / dx;
    let end = Point([[px + dx, 0.0], [vx, 0.0], [ax, 0.0]]);
    let rod = bar(pin, end);
    let body = |mass, centre, angle, force| Body { mass, inertia: 0.01, centre, angle, force, torque: 0.0 };
    let bodies = [
        body(2.0, on_bar(origin, crank, 0.03, 0.0), crank, [0.0; 2]),
        body(1.2, on_bar(pin, rod, 0.15, 0.0), rod, [0.0; 2]),
        body(3.0, end, [0.0; 3], [-800.0, 0.0]),
    ];
    let joints = [
        Joint::Pin(None, 0, [0.0; 2]),
        Joint::Pin(Some(0), 1, pin.0[0]),
        Joint::Pin(Some(1), 2, end.0[0]),
        Joint::Slide(2),
        Joint::Motor(None, 0, 1.0),
    ];
    (drives(&bodies, &joints), ax)
}

/// Arms of 0.12 m, rods of 0.16 m; a third motor at the left elbow has a weight of 5.
fn five_bar(arms: [[f64; 3]; 2], third: bool) -> (Vec<f64>, Point) {
    let ground = [Point::fixed(-0.05, 0.0), Point::fixed(0.05, 0.0)];
    let elbows = [0, 1].map(|k| on_bar(ground[k], arms[k], 0.12, 0.0));
    let pen = dyad(elbows[0], elbows[1], [0.16, 0.16], true);
    let rods = elbows.map(|elbow| bar(elbow, pen));
    let body = |mass, inertia, from, angle, along| {
        let centre = on_bar(from, angle, along, 0.0);
        Body { mass, inertia, centre, angle, force: [0.0; 2], torque: 0.0 }
    };
    let bodies = [
        body(0.5, 1e-3, ground[0], arms[0], 0.05),
        body(0.6, 1.2e-3, ground[1], arms[1], 0.05),
        body(0.3, 8e-4, elbows[0], rods[0], 0.08),
        body(0.4, 9e-4, elbows[1], rods[1], 0.08),
    ];
    let mut joints = vec![
        Joint::Pin(None, 0, ground[0].0[0]),
        Joint::Pin(None, 1, ground[1].0[0]),
        Joint::Pin(Some(0), 2, elbows[0].0[0]),
        Joint::Pin(Some(1), 3, elbows[1].0[0]),
        Joint::Pin(Some(2), 3, pen.0[0]),
        Joint::Motor(None, 0, 1.0),
        Joint::Motor(None, 1, if third { 2.0 } else { 1.0 }),
    ];
    if third {
        joints.push(Joint::Motor(Some(0), 2, 5.0));
    }
    (drives(&bodies, &joints), pen)
}

#[test]
fn of_a_five_bar_with_two_drives_and_with_three() {
    let mut sim = started(FIVE_BAR);
    let mechanism = *sim.state().mechanism();
    let arms = ["left_arm.angle", "right_arm.angle"];
    let two = Inverse::new(&mechanism, arms, ["left", "right"]).unwrap();
    let three = Inverse::new(&mechanism, arms, ["left", "right", "elbow"]).unwrap().weighted([1.0, 2.0, 5.0]);
    for _ in 0..10 {
        sim.step(5e-3).unwrap();
        let [left, right] = ["left_arm", "right_arm"].map(|name| angle(sim.state(), name));
        let wanted = [13.0, -21.0];
        let arms = [[left[0], left[1], wanted[0]], [right[0], right[1], wanted[1]]];
        let (known, _) = five_bar(arms, false);
        let found = two.inputs(&sim, wanted).unwrap();
        (0..2).for_each(|k| near(found[k], known[k], 1e-10));
        let (known, _) = five_bar(arms, true);
        let found = three.inputs(&sim, wanted).unwrap();
        (0..3).for_each(|k| near(found[k], known[k], 1e-10));
    }
}
