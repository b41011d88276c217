//! Loops on bodies that fall from an unstable rest: long steps at first, then a loop that is thrown about.

use plm::{Dop853, Moment as _, Rk4, Stabilise as _};

use super::formulations::{close, values};
use crate::scene::{By as _, Given as _, Named as _};

/// A four-bar that a jack holds, on a stick whose torque drives it away from where it stands.
macro_rules! stick {
    ($formulation:ident) => {
        pub(super) mod $formulation {
            scene! {
                pub Stick {
                    formulation: $formulation;
                    param growth: N*m/rad = 1e5 N*m/rad;
                    ground { port o: (0, 0) m; }
                    body stick { mass: 800 kg; inertia: 2000 kg*m^2; port pin: (0, 0) m; port tip: (2.4, 0) m; port rocker: (2.0, 0) m; port cyl: (0.5, 0.4) m; start angle: 0 deg, locked; }
                    body bucket { mass: 60 kg; inertia: 15 kg*m^2; port pin: (0, 0) m; port link: (0, 0.4) m; start angle: 15 deg; start x: 2.4 m; }
                    body rocker { mass: 6 kg; inertia: 0.3 kg*m^2; port pin: (0, 0) m; port joint: (0.5, 0) m; start angle: 114 deg; start x: 2 m; }
                    body link { mass: 5 kg; inertia: 0.3 kg*m^2; port joint: (0, 0) m; port bucket: (0.5, 0) m; start angle: -8 deg; start x: 1.8 m; start y: 0.46 m; }
                    revolute elbow(ground.o, stick.pin) { drive: growth*stick.angle; }
                    revolute wrist(stick.tip, bucket.pin);
                    revolute r(stick.rocker, rocker.pin);
                    revolute j(rocker.joint, link.joint);
                    revolute l(link.bucket, bucket.link);
                    jack ram(stick.cyl, rocker.joint) { drive: 4e6 N/m*(1.3 m - ram.length) - 4e5 N*s/m*ram.speed; }
                }
            }
        }
    };
}
mod stick {
    stick!(loops);
    stick!(absolute);
}

#[test]
fn a_loop_follows_the_body_that_carries_it() {
    for angle in [1e-9, 1e-4, 1e-2] {
        let least = stick::loops::Stick::new().with_start("stick.angle", angle);
        let absolute = stick::absolute::Stick::new().with_start("stick.angle", angle);
        let mut one = least.begin().unwrap();
        let mut fixed = least.by(Rk4::new(1e-4)).unwrap();
        let mut other = absolute.by(Dop853::new(1e-11)).unwrap();
        while other.state_of("stick").angle.abs() < 4.0 && other.time() < 4.0 {
            one.step(0.01).unwrap();
            fixed.step(0.01).unwrap();
            other.step(0.01).unwrap();
        }
        assert!(other.state_of("stick").angle.abs() > 4.0, "{angle}: it stands for {} s", other.time());
        for found in [
            [one.state_of("stick"), one.state_of("bucket"), one.state_of("rocker"), one.state_of("link")],
            [
                fixed.state_of("stick"),
                fixed.state_of("bucket"),
                fixed.state_of("rocker"),
                fixed.state_of("link"),
            ],
        ] {
            let wanted = [
                other.state_of("stick"),
                other.state_of("bucket"),
                other.state_of("rocker"),
                other.state_of("link"),
            ];
            for (found, wanted) in found.into_iter().zip(wanted) {
                close(&format!("from {angle} rad"), values(found), values(wanted), 3e-7);
            }
        }
    }
}

/// The arm of an excavator on its jacks, which controllers hold at their lengths.
macro_rules! excavator {
    ($formulation:ident) => {
        pub(super) mod $formulation {
            scene! {
                pub Excavator {
                    formulation: $formulation;
                    /// A jack that is held at a length.
                    part servo(a: frame, b: frame) {
                        param target: m = 1 m;
                        jack ram(a, b) { drive: 4e6 N/m*(target - ram.length) - 4e5 N*s/m*ram.speed; }
                    }
                    gravity: 9.81 m/s^2;
                    ground { port foot: (0, 1) m; port cyl: (0.6, 0.6) m; }
                    body boom { mass: 1500 kg; inertia: 2500 kg*m^2; centre: (2.2, 0.5) m; port foot: (0, 0) m; port tip: (5, 0) m; port cyl: (2.0, 0.2) m; port stick_cyl: (2.4, 0.9) m; start angle: 35 deg; start y: 1 m; }
                    body stick { mass: 800 kg; inertia: 600 kg*m^2; centre: (0.8, 0.1) m; port pin: (0, 0) m; port tail: (-0.6, 0.3) m; port tip: (2.4, 0) m; port rocker: (2.0, 0) m; port bucket_cyl: (0.5, 0.4) m; start angle: -60 deg; start x: 4 m; start y: 3.8 m; }
                    body bucket { mass: 600 kg; inertia: 150 kg*m^2; centre: (0.5, -0.3) m; port pin: (0, 0) m; port link: (0, 0.4) m; start angle: -120 deg; start x: 5.2 m; start y: 1.7 m; }
                    body rocker { mass: 60 kg; inertia: 3 kg*m^2; centre: (0.25, 0) m; port pin: (0, 0) m; port joint: (0.5, 0) m; start angle: 20 deg; start x: 5 m; start y: 2 m; }
                    body link { mass: 50 kg; inertia: 3 kg*m^2; centre: (0.25, 0) m; port joint: (0, 0) m; port bucket: (0.5, 0) m; start angle: -60 deg; start x: 5.5 m; start y: 2.2 m; }
                    revolute foot(ground.foot, boom.foot);
                    revolute elbow(boom.tip, stick.pin);
                    revolute wrist(stick.tip, bucket.pin);
                    revolute r(stick.rocker, rocker.pin);
                    revolute j(rocker.joint, link.joint);
                    revolute l(link.bucket, bucket.link);
                    servo boom_ram(ground.cyl, boom.cyl) { target: 1.9 m; }
                    servo stick_ram(boom.stick_cyl, stick.tail) { target: 1.7 m; }
                    servo bucket_ram(stick.bucket_cyl, rocker.joint) { target: 1.3 m; }
                }
            }
        }
    };
}
mod excavator {
    excavator!(loops);
    excavator!(absolute);
}

#[test]
fn an_excavator_falls_from_an_unstable_rest() {
    let found = excavator::loops::Excavator::new().stabilise().unwrap().balanced().unwrap();
    let mut sim = found.start().unwrap();
    // Rounding has its say in when it falls.
    while sim.state_of("stick").omega.abs() < 1e-3 {
        sim.step(0.01).unwrap();
        assert!(sim.time() < 2.0, "it stands");
    }
    // From there on in absolute coordinates too.
    let absolute = excavator::absolute::Excavator::new().with_starts(&sim.starts());
    let mut other = absolute.by(Dop853::new(1e-11)).unwrap();
    let (start, mut fallen) = (sim.state_of("stick").angle, 0.0_f64);
    for _ in 0..150 {
        sim.step(0.01).unwrap();
        other.step(0.01).unwrap();
        fallen = fallen.max((sim.state_of("stick").angle - start).abs());
        close("stick", values(sim.state_of("stick")), values(other.state_of("stick")), 1e-6);
        close("bucket", values(sim.state_of("bucket")), values(other.state_of("bucket")), 1e-6);
        close("link", values(sim.state_of("link")), values(other.state_of("link")), 1e-6);
    }
    assert!(fallen > 2.0, "it stays where it was: {fallen} rad");
}
