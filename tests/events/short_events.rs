//! Conditions of a declaration that last shorter than a step.

use plm::{Cause, Dop853, Mechanism as _, Rk4};

use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// A rotor whose tip is braked in a window that it passes in a tenth of a turn.
    pub Brush {
        ground { port o: (0, 0) m; }
        body rotor { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port tip: (1, 0) m; start angle: 0 deg, locked; start omega: 10 rad/s, locked; }
        revolute pin(ground.o, rotor.o) { drive: if rotor.tip.y < -0.9 m then -1 N*m else 0 N*m; }
    }
}

#[test]
fn a_brush_gives_the_same_speed_whatever_interval_is_asked_for() {
    // Between two passes the energy falls by 1 N m times the angle: half of 0.1 kg m^2 + 0 at the joint, which is at G.
    let window = 2.0 * (0.9_f64).acos();
    for interval in [10.0, 1.0, 0.1, 0.01, 0.001] {
        let mut sim = Brush::new().start().unwrap();
        for _ in 0..(10.0 / interval) as u32 {
            sim.step(interval).unwrap();
        }
        // Of 5 J each pass takes the window's angle until it turns back within one, and leaves as it came in: then each
        // pass in the other direction gives the same energy back to the motion.
        let energy = 0.05 * sim.state_of("rotor").omega.powi(2);
        let passes = (5.0 - energy) / window;
        assert!((passes - passes.round()).abs() < 1e-6, "{interval}: {passes} passes");
        assert_eq!(sim.stats().switches, 16, "{interval}");
        assert!(
            (sim.state_of("rotor").omega + 6.773_240_184).abs() < 1e-6,
            "{interval}: {}",
            sim.state_of("rotor").omega
        );
    }
}

scene! {
    /// A tip that is braked while it is in a soft floor: the condition asks for what rests on its boundary.
    pub Floor {
        param floor: m = -0.9 m;
        ground { port o: (0, 0) m; }
        body rotor { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port tip: (1, 0) m; start angle: 0 deg, locked; start omega: 10 rad/s, locked; }
        revolute pin(ground.o, rotor.o);
        let depth = max(floor - rotor.tip.y, 0);
        let brake = if depth > 0 then 1 else 0;
        state braked: s = 0 s;
        rate braked = brake;
        output braked;
    }
}

#[test]
fn what_is_let_go_of_its_boundary_switches_back() {
    // Ten radians a second, and 2 acos(0.9) of each turn below the floor.
    let turns = 100.0 / (2.0 * core::f64::consts::PI);
    let known = turns.floor() * 2.0 * (0.9_f64).acos() / 10.0;
    for interval in [10.0, 0.1] {
        let mut sim = Floor::new().start().unwrap();
        for _ in 0..(10.0 / interval) as u32 {
            sim.step(interval).unwrap();
        }
        // The last turn ends before it comes to the floor.
        assert_eq!(sim.stats().switches, 2 * turns.floor() as u64 + 2, "{interval}");
        let last = 2.0 * (0.9_f64).acos() / 10.0;
        assert!(
            (sim.value_of("braked") - known - last).abs() < 1e-8,
            "{interval}: {} {known}",
            sim.value_of("braked")
        );
    }
}

scene! {
    /// A rotor whose tip is rubbed and pushed up while it is in a soft floor.
    pub Rubbed {
        param floor: m = -0.9 m;
        ground { port o: (0, 0) m; }
        body rotor { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port tip: (1, 0) m; start angle: 0 deg, locked; start omega: 10 rad/s, locked; }
        revolute pin(ground.o, rotor.o);
        let depth = max(floor - rotor.tip.y, 0);
        force floor_push(rotor.tip) { y: 10 N/m*depth; x: -1 N*s/m*rotor.tip.velocity.x*(if depth > 0 then 1 else 0); }
    }
}

/// Speed with which that rotor leaves the floor, which it enters at a speed, and whether it has passed: by Runge-Kutta 4
/// 0.1 kg m^2 w' = 10 N/m (-0.9 m - sin) 1 m cos - 1 N s/m (1 m sin)^2 w.
fn leaves_the_floor(mut omega: f64) -> (f64, bool) {
    let (half, h) = ((0.9_f64).acos(), 1e-5);
    let slope = |angle: f64, omega: f64| {
        let (sin, cos) = (-angle.cos(), angle.sin());
        10.0 * (10.0 * (-0.9 - sin) * cos - omega * sin * sin)
    };
    // From where the tip is lowest.
    let mut angle = -half;
    while angle.abs() <= half {
        let k1 = slope(angle, omega);
        let k2 = slope(angle + 0.5 * h * omega, omega + 0.5 * h * k1);
        let k3 = slope(angle + 0.5 * h * (omega + 0.5 * h * k1), omega + 0.5 * h * k2);
        let k4 = slope(angle + h * (omega + 0.5 * h * k2), omega + h * k3);
        angle += h * (omega + h / 6.0 * (k1 + k2 + k3));
        omega += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    // Back to the edge.
    let edge = half * angle.signum();
    (omega - slope(edge, omega) * (angle - edge) / omega, angle > 0.0)
}

#[test]
fn a_soft_floor_throws_a_rotor_back_whatever_interval_is_asked_for() {
    // It passes once; the second time it is thrown back so slowly that it does not come again.
    let (after, passed) = leaves_the_floor(10.0);
    let (known, again) = leaves_the_floor(after);
    assert!(passed && !again && (-1e-3..0.0).contains(&known), "{after} {known}");
    for interval in [10.0, 1.0, 0.1, 0.01] {
        let mut sim = Rubbed::new().start().unwrap();
        for _ in 0..(10.0 / interval) as u32 {
            sim.step(interval).unwrap();
        }
        let omega = sim.state_of("rotor").omega;
        assert!((omega - known).abs() < 3e-9, "{interval}: {omega:e} {known:e}, {:?}", sim.stats());
    }
}

scene! {
    /// A stone that is thrown up and just reaches, or just misses, a height.
    pub Thrown {
        param height: m = 1 m;
        gravity: 2 m/s^2;
        ground { port o: (0, 0) m, axis: 90 deg; }
        body stone { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start vy: 2 m/s, locked; start y: 0 m, locked; }
        prismatic rail(ground.o, stone.o);
        force wind(stone.o) { y: if stone.y > height then -1 N else 0 N; }
    }
}

#[test]
fn to_graze_a_boundary_is_no_end_of_a_run() {
    // y = 2 t - t^2 turns at 1 m. It comes to 1 - d at 2 sqrt(d) m/s, stays above for 4/3 sqrt(d) s under 3 m/s^2, where
    // without wind it were 2 sqrt(d) s, and so is earlier by 2/3 sqrt(d) s when it falls at 2 m/s.
    for off in [0.0, 1e-16, 1e-14, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6] {
        for height in [1.0 - off, 1.0 + off] {
            for interval in [2.0, 0.1, 1e-3] {
                let mechanism = Thrown::new().with("height", height);
                let mut sim = mechanism.start().unwrap();
                for _ in 0..(2.0 / interval) as u32 {
                    sim.step(interval).unwrap_or_else(|fault| panic!("{height}, {interval}: {fault}"));
                }
                let known = -4.0 / 3.0 * (1.0 - height).max(0.0).sqrt();
                // Rounding of the turn by 1e-13 m is that of its root by 3e-7.
                assert!(
                    (sim.state_of("stone").y - known).abs() < 1e-6,
                    "{height}: {} {known}",
                    sim.state_of("stone").y
                );
                assert!(sim.stats().switches <= 4, "{height}: {:?}", sim.stats());
            }
        }
    }
}

/// A four-bar whose rocker counts the time in a window of 0.2 mrad, in every formulation.
macro_rules! counted {
    ($name:ident, $formulation:ident) => {
        scene! {
            pub $name {
                formulation: $formulation;
                ground { port a: (0, 0) m; port d: (1, 0) m; }
                body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 7 rad/s, locked; }
                body coupler { mass: 0.9 kg; inertia: 0.06075 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; start angle: 30 deg; }
                body rocker { mass: 0.7 kg; inertia: 0.02858 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0) m; start x: 1 m; start angle: 95 deg; }
                state inside: s = 0 s;
                rate inside = if (rocker.angle - 100 deg)^2 < (1e-4 rad)^2 then 1 else 0;
                revolute drive(ground.a, crank.a);
                revolute crank_coupler(crank.b, coupler.b);
                revolute coupler_rocker(coupler.c, rocker.c);
                revolute pivot(ground.d, rocker.d);
                require low: coupler.y < 5 m;
                output inside;
            }
        }
    };
}
counted!(Counted, loops);
counted!(CountedAbsolute, absolute);

/// How often a run in such intervals switches, and how long it is inside.
fn windows(counted: Scene, interval: f64) -> (u64, f64) {
    let mut sim = counted.start_with(Dop853::new(1e-10)).unwrap();
    for _ in 0..(5.0_f64 / interval).round() as u32 {
        sim.step(interval).unwrap();
    }
    println!("{interval} {:?}", sim.stats());
    (sim.stats().switches, sim.value_of("inside"))
}

#[test]
fn windows_of_a_loop_are_found_through_its_closed_form() {
    let (switches, inside) = windows(Counted::new(), 1e-3);
    assert!(switches >= 8 && switches % 2 == 0, "{switches}");
    for (other, seconds) in [
        windows(Counted::new(), 5.0),
        windows(Counted::new(), 0.1),
        windows(CountedAbsolute::new(), 5.0),
        windows(CountedAbsolute::new(), 0.05),
    ] {
        assert_eq!(other, switches);
        assert!((seconds - inside).abs() < 1e-4 * inside, "{seconds} {inside}");
    }
}

scene! {
    /// Requirements of what lasts a millisecond.
    pub Calm {
        allow(W0002);
        body puck { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; start vx: 1 m/s, locked; start x: 0 m, locked; start y: 0 m, locked; start angle: 0 deg, locked; start omega: 0 rad/s, locked; start vy: 0 m/s, locked; }
        require calm: sin(2*pi*10 Hz*t) < 0.9;
    }
}

scene! {
    /// A force that changes its sign twenty times a second.
    pub Square {
        allow(W0002);
        body puck { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; start vx: 1 m/s, locked; start x: 0 m, locked; start y: 0 m, locked; start angle: 0 deg, locked; start omega: 0 rad/s, locked; start vy: 0 m/s, locked; }
        force push(puck.o) { x: if sin(2*pi*10 Hz*t) > 0 then 1 N else -1 N; }
    }
}

#[test]
fn a_square_wave_switches_at_every_half_of_its_period() {
    for interval in [10.0, 1.0, 0.1] {
        let mut sim = Square::new().start().unwrap();
        for _ in 0..(10.0 / interval) as u32 {
            sim.step(interval).unwrap();
        }
        assert_eq!(sim.stats().switches, 199, "{interval}");
        // Each period of 0.1 s it gains 0.05 s at 1 m/s^2 and loses them again: 1/2 0.05^2 + 1/2 0.05^2 m.
        let (x, v) = (sim.state_of("puck").x - 10.0 - 100.0 * 0.05 * 0.05, sim.state_of("puck").vx - 1.0);
        assert!(x.abs() < 1e-10 && v.abs() < 1e-11, "{interval}: {x:e} {v:e}");
    }
}

#[test]
fn a_requirement_of_a_wave_ends_the_run_at_its_first_crest() {
    let known = (0.9_f64).asin() / (20.0 * core::f64::consts::PI);
    for interval in [10.0, 1.0, 0.1, 0.01] {
        let mut sim = Calm::new().start().unwrap();
        let fault = (0..1000).find_map(|_| sim.step(interval).err()).unwrap();
        assert_eq!((fault.part, fault.cause), ("calm", Cause::Required));
        assert!((fault.time - known).abs() < 1e-12, "{interval}: {fault}");
    }
    let mut sim = Calm::new().start_with(Rk4::new(0.1)).unwrap();
    let fault = sim.step(1.0).unwrap_err();
    assert!((fault.time - 0.1).abs() < 1e-12, "the end of the step: {fault}");
}
