//! Machines that hold: jack, drawer, pads, gears, driven slider-crank.

use plm::{Dop853, Mechanism as _};

use crate::near;
use crate::scene::{Given as _, Named as _};

/// A mechanism with forces on its frames.
macro_rules! pushed {
    ($(#[$docs:meta])* pub $name:ident { $($items:tt)* }) => {
        scene! {
            $(#[$docs])*
            pub $name {
                part push(on: frame) {
                    param x: N = 0 N;
                    param y: N = 0 N;
                    force on on: (x, y);
                }
                $($items)*
            }
        }
    };
}

pushed! {
    /// A wedge of 10 N that lifts a load of 500 N. Its face rises to the right by 5 deg.
    pub Jack {
        param drive: N = 0 N;
        body wedge { mass: 1 kg; inertia: 1 kg*m^2; port g: (0, 0) m; }
        body load { mass: 50 kg; inertia: 1 kg*m^2; port g: (0, 0) m; }
        constraint wedge_level: wedge.angle = 0;
        constraint load_x: load.x = 0;
        constraint load_level: load.angle = 0;
        push on_wedge(wedge.g) { x: drive; y: -10 N; }
        push on_load(load.g) { y: -500 N; }
        let across = (load.y - wedge.y)*cos(5 deg) - (load.x - wedge.x)*sin(5 deg);
        let along = (load.x - wedge.x)*cos(5 deg) + (load.y - wedge.y)*sin(5 deg);
        unilateral face: across >= 0 m;
        unilateral bed: wedge.y >= 0 m;
        friction on_face: rate(along) within 0.1*reaction(face);
        friction on_bed: rate(wedge.x) within 0.1*reaction(bed);
    }
}

pushed! {
    /// A drawer that is pulled 0.5 m beside its middle, led by two points that are 0.3 m apart along it.
    pub Drawer {
        param pull: N = 1 N;
        param friction = 0.2;
        body drawer {
            mass: 2 kg; inertia: 0.1 kg*m^2;
            port front: (0.15, -0.05) m; port rear: (-0.15, 0.05) m; port handle: (0.2, 0.5) m;
        }
        push hand(drawer.handle) { x: pull; }
        unilateral low: drawer.front.y + 0.05 m >= 0 m;
        unilateral high: drawer.rear.y <= 0.05 m;
        friction on_low: rate(drawer.front.x) within friction*reaction(low);
        friction on_high: rate(drawer.rear.x) within friction*reaction(high);
    }
}

pushed! {
    /// A block between a wall and a pad.
    pub Pinched {
        param weight: N = 9 N;
        body block { mass: 1 kg; inertia: 1 kg*m^2; port g: (0, 0) m; }
        body pad { mass: 0.1 kg; inertia: 1 kg*m^2; port g: (0, 0) m; }
        constraint block_level: block.angle = 0;
        constraint pad_y: pad.y = 0;
        constraint pad_level: pad.angle = 0;
        push on_block(block.g) { y: -weight; }
        push on_pad(pad.g) { x: -20 N; }
        unilateral left: block.x >= 0 m;
        unilateral right: pad.x - block.x >= 0 m;
        friction on_left: rate(block.y) within 0.25*reaction(left);
        friction on_right: rate(block.y - pad.y) within 0.25*reaction(right);
    }
}

/// The face pushes at 5 deg and the angle of friction, the bed takes both weights. The drive to the left lifts, to the right it lets go.
#[test]
fn a_wedge_jack_locks_itself() {
    let (face, angle) = (0.1_f64.atan(), 5_f64.to_radians());
    let lifts = -(500.0 * (angle + face).tan() + 51.0);
    let lowers = 500.0 * (face - angle).tan() + 51.0;
    for (limit, name) in [(lifts, "lifts"), (lowers, "lowers")] {
        for (beyond, moves) in [(-1e-8, false), (1e-8, true)] {
            let jack = Jack::new().with("drive", limit * (1.0 + beyond));
            let mut sim = jack.start_with(Dop853::new(1e-10)).unwrap();
            sim.step_to(1.0).unwrap();
            assert_eq!(
                sim.state_of("wedge").x != 0.0,
                moves,
                "{name} {beyond:e}: {:?}",
                sim.state_of("wedge")
            );
            assert!(!moves || sim.state_of("load").y * (sim.state_of("wedge").x) < 0.0);
        }
    }
    let mut sim = Jack::new().start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(3600.0).unwrap();
    assert_eq!((sim.state_of("wedge").x, sim.state_of("load").y), (0.0, 0.0));
    assert!(sim.stats().steps < 20, "{:?}", sim.stats());
}

/// Both guides push by F e/b, and rub by 2 mu F e/b together: it jams from mu = b/(2 e) = 0.3 on, however hard it is pulled.
#[test]
fn a_drawer_jams() {
    for pull in [1.0, 1e4] {
        for (friction, moves) in [(0.3 - 1e-8, true), (0.3 + 1e-8, false), (0.2, true)] {
            let mut sim = Drawer::new()
                .with("friction", friction)
                .with("pull", pull)
                .start_with(Dop853::new(1e-10))
                .unwrap();
            sim.step_to(0.1).unwrap();
            assert_eq!(
                sim.state_of("drawer").x != 0.0,
                moves,
                "{friction} {pull} N: {:?}",
                sim.state_of("drawer")
            );
            if friction == 0.2 {
                near(sim.state_of("drawer").vx, 0.1 * pull / 2.0 * (1.0 - 0.2 / 0.3), 1e-10 * pull);
            }
            near(sim.state_of("drawer").angle, 0.0, 1e-15);
        }
    }
}

/// Two pads hold 10 N at most, each by 5 N.
#[test]
fn pads_hold_a_block_for_a_minute() {
    let mut sim = Pinched::new().start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(60.0).unwrap();
    assert_eq!((sim.state_of("block").x, sim.state_of("block").y, sim.state_of("pad").x), (0.0, 0.0, 0.0));
    for (weight, moves) in [(10.0 - 1e-7, false), (10.0 + 1e-7, true)] {
        let mut sim = Pinched::new().with("weight", weight).start_with(Dop853::new(1e-10)).unwrap();
        sim.step_to(1.0).unwrap();
        assert_eq!(sim.state_of("block").y != 0.0, moves, "{weight} N: {:?}", sim.state_of("block"));
    }
}

scene! {
    /// A planetary gear whose ring is held: teeth of sun, planet and ring 24, 24, 72. What the meshes lose is a friction of the planet.
    pub Planetary {
        part load(on: body) {
            param torque: N*m;
            torque on on: torque;
        }
        param loss = 0.0591;
        param out: N*m = -38.227 N*m;
        body sun { mass: 1 kg; inertia: 0.01 kg*m^2; start omega: 100 rad/s, locked; }
        body planet { mass: 1 kg; inertia: 0.01 kg*m^2; start omega: -50 rad/s; }
        body carrier { mass: 1 kg; inertia: 0.1 kg*m^2; start omega: 25 rad/s; }
        load motor(sun) { torque: 10 N*m; }
        load brake(carrier) { torque: out; }
        constraint inner: 24*(sun.angle - carrier.angle) + 24*(planet.angle - carrier.angle) = 0;
        constraint outer: -72*carrier.angle - 24*(planet.angle - carrier.angle) = 0;
        friction bearing: rate(planet.angle - carrier.angle) within 24*loss*abs(reaction(inner));
        output on_ring = 72*reaction(outer);
    }
}

/// Case C36: R. Willis; losses of 3 % in each mesh, in the frame of the carrier: 10 (1 + 3 0.97^2) N m come out, and nothing accelerates.
#[test]
fn c36_a_planetary_gear_runs_at_its_efficiency() {
    for (loss, out, ring) in [(0.0591, 38.227, 28.227), (0.0, 40.0, 30.0)] {
        let mut sim =
            Planetary::new().with("loss", loss).with("out", -out).start_with(Dop853::new(1e-10)).unwrap();
        sim.step_to(10.0).unwrap();
        near(sim.state_of("sun").omega, 100.0, 1e-9);
        near(sim.state_of("carrier").omega, 25.0, 1e-9);
        near(sim.state_of("planet").omega, -50.0, 1e-9);
        near(sim.value_of("on_ring").abs(), ring, 1e-9);
    }
}

scene! {
    /// A slider-crank that is driven, with friction at its slider; the rod has no mass.
    pub Driven {
        ground { port o: (0, 0) m; port rail: (0, 0) m, axis: 0 deg; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; port a: (0.1, 0) m; }
        body slider { mass: 2 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; start x: 0.4 m; }
        revolute o(ground.o, crank.o);
        prismatic rail(ground.rail, slider.b);
        constraint rod: norm(slider.position - crank.a.position) = 0.3 m;
        constraint drive: crank.angle = 20 rad/s*t;
        friction rub: rate(slider.x) within 15 N;
        output torque = -reaction(drive);
    }
}

/// Case C56: T = (m x'' + F sign x') dx/dphi, also after dead centres, where the friction is anything within its limits.
#[test]
fn c56_a_driven_slider_crank_rubs() {
    let mut sim = Driven::new().start_with(Dop853::new(1e-10)).unwrap();
    for (degrees, torque) in
        [(60.0_f64, 4.240_668_211_784_328), (200.0, 1.622_939_676_906_341_3), (420.0, 4.240_668_211_784_328)]
    {
        sim.step_to(degrees.to_radians() / 20.0).unwrap();
        near(sim.value_of("torque"), torque, 1e-9 * torque);
    }
}
