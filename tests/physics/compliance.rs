//! Joints that give way: against statics, against a spring's frequency, and against the rigid joint that they tend to.

use plm::{Dop853, Mechanism as _, Moment as _};

use crate::scene::{Given as _, Named as _};

/// Three parallel cranks of 1 m, the third longer by `error` and tied to the bar by a revolute that says `give`.
macro_rules! parallelogram {
    ($module:ident, [$($lock:tt)*], [$($give:tt)*]) => {
        mod $module {
            scene! {
                pub Parallelogram {
                    allow(W0007);
                    gravity: 9.81 m/s^2;
                    param error: m = 0 m;
                    param give: m/N = 1e-9 m/N;
                    param settle: s = 1e-5 s;
                    ground { port a: (0, 0) m; port b: (1, 0) m; port c: (2, 0) m; }
                    body one { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port p: (0.5, 0) m; start angle: 60 deg, locked; start y: 0.4 m; start omega: 0 rad/s, locked; }
                    body two { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (-0.5, 0) m; port q: (0.5, 0) m; start angle: 60 deg; start x: 1.2 m; start y: 0.4 m; }
                    body three { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (-0.5, 0) m; port r: (0.5 m + error, 0 m); start angle: 60 deg $($lock)*; start x: 2.2 m; start y: 0.4 m; }
                    body bar { mass: 2 kg; inertia: 0.5 kg*m^2; port p: (-1, 0) m; port q: (0, 0) m; port r: (1, 0) m; start x: 1.5 m; start y: 0.9 m; }
                    revolute p1(ground.a, one.a) { damping: 0.5 N*m/(rad/s); }
                    revolute p2(ground.b, two.b);
                    revolute p3(ground.c, three.c);
                    revolute p4(one.p, bar.p);
                    revolute p5(two.q, bar.q);
                    revolute p6(three.r, bar.r) { $($give)* }
                    allow(W0001);
                    output p6.force, p3.force;
                }
            }
        }
    };
}

parallelogram!(rigid, [], []);
parallelogram!(soft, [, locked], [compliance: give; relaxation: settle;]);

#[test]
fn a_crank_that_is_too_long_is_pressed_by_its_error_over_the_compliance() {
    let (error, give) = (1e-6, 1e-8);
    let scene = soft::Parallelogram::new().with("error", error).with("give", give);
    let mut sim = scene.start_with(Dop853::new(1e-11)).unwrap();
    for _ in 0..5 {
        sim.step(0.05).unwrap();
        let (angle, omega) = (sim.state_of("one").angle, sim.state_of("one").omega);
        let (sin, cos) = angle.sin_cos();
        let [x, y] = sim.vector_of("p6.force");
        let (along, across) = (x * cos + y * sin, y * cos - x * sin);
        // Along the cranks the bar is held, so that the whole error is the spring's: 100 N inwards.
        assert!((along + error / give).abs() < 1e-3, "{along}");
        // Across them the pin makes the third crank follow, as if all were rigid: J = 0.1 + 1 * 0.5^2 kg m^2 each.
        let inertia = 0.1 + 0.25;
        let torque = -(3.0 * 0.5 + 2.0) * 9.81 * cos - 0.5 * omega;
        let alpha = torque / (3.0 * inertia + 2.0);
        let expected = inertia * alpha + 0.5 * 9.81 * cos;
        assert!((across - expected).abs() < 1e-3, "{across} {expected}");
    }
}

#[test]
fn lengths_that_agree_move_as_rigid_ones_to_the_order_of_the_compliance() {
    let mut wanted = rigid::Parallelogram::new().start_with(Dop853::new(1e-12)).unwrap();
    wanted.step(0.4).unwrap();
    let off = |give: f64| {
        let scene = soft::Parallelogram::new().with("give", give).with("settle", 1e-4);
        let mut sim = scene.start_with(Dop853::new(1e-12)).unwrap();
        sim.step(0.4).unwrap();
        (sim.state_of("one").angle - wanted.state_of("one").angle).abs()
    };
    let (more, less) = (off(1e-5), off(1e-6));
    assert!(less < 2e-7 && (8.0..12.0).contains(&(more / less)), "{more:e} {less:e}");
}

scene! {
    pub Parts {
        /// A rigid link: the distance of two points is fixed.
        joint link(a: frame, b: frame) {
            param length: m;
            let between = b.position - a.position;
            constraint distance: norm(between) - length = 0;
            output tension = reaction(distance);
        }
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; port rail: (1, 0) m, axis: 30 deg; port slot: (2, 0) m, axis: 30 deg; port top: (3, 0) m; }
        body block { mass: 2 kg; inertia: 0.03 kg*m^2; port o: (0, 0) m; start omega: 0.1 rad/s, locked; }
        body shoe { mass: 2 kg; inertia: 0.03 kg*m^2; port o: (0, 0) m, angle: 30 deg; start x: 1 m, locked; start y: 0 m, locked; }
        body pin { mass: 2 kg; inertia: 0.03 kg*m^2; port o: (0, 0) m; start x: 2 m, locked; start y: 0 m, locked; }
        body bob { mass: 2 kg; inertia: 0.03 kg*m^2; port o: (0, 0) m; start x: 3 m, locked; start y: -0.5 m, locked; }
        weld seam(ground.o, block.o) { compliance: 1e-5 m/N; rotary_compliance: 1e-4 rad/(N*m); }
        prismatic rail(ground.rail, shoe.o) { compliance: 1e-5 m/N; }
        pin_slot slot(ground.slot, pin.o) { compliance: 1e-5 m/N; }
        link rope(ground.top, bob.o) { length: 0.5 m; compliance: 1e-5 m/N; }
        output seam.force, seam.torque, rail.force, slot.force, rope.tension, rail.displacement;
    }
}

#[test]
fn every_joint_swings_as_the_spring_that_it_is() {
    let mut sim = Parts::new().start_with(Dop853::new(1e-13)).unwrap();
    let close = |what: &str, found: f64, wanted: f64, scale: f64| {
        assert!((found - wanted).abs() < 1e-8 * scale, "{what}: {found} {wanted}");
    };
    // From rest, a weight W on a spring presses with W (1 - cos w t), w = 1/sqrt(m c).
    let (weight, frequency, turning) = (2.0 * 9.81, 1.0 / 2e-5_f64.sqrt(), 1.0 / 3e-6_f64.sqrt());
    let across = weight * 0.75_f64.sqrt();
    for _ in 0..10 {
        sim.step(0.0037).unwrap();
        let time = sim.time();
        let swing = 1.0 - (frequency * time).cos();
        close("seam.x", sim.vector_of("seam.force")[0], 0.0, weight);
        close("seam.y", sim.vector_of("seam.force")[1], -weight * swing, weight);
        close("seam.torque", sim.value_of("seam.torque"), 0.1 / turning * 1e4 * (turning * time).sin(), 1.0);
        close("rope", sim.value_of("rope.tension"), weight * swing, weight);
        for (what, [x, y]) in [("rail", sim.vector_of("rail.force")), ("slot", sim.vector_of("slot.force"))] {
            close(what, x * 0.75_f64.sqrt() + y * 0.5, 0.0, weight);
            close(what, y * 0.75_f64.sqrt() - x * 0.5, -across * swing, weight);
        }
        close("rail.displacement", sim.value_of("rail.displacement"), -0.25 * 9.81 * time * time, 1.0);
        close("shoe.angle", sim.state_of("shoe").angle, 0.0, 1.0);
    }
}
