//! Polygons on lines, points on smooth ground.

use plm::runtime::contact::Mode;
use plm::{Dop853, Mechanism as _, Sim};

use super::{G, near};
use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// A box on a slope, sleds on curved ground.
    pub Grounds {
        param slope: rad = 20 deg;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; port incline: (0, 0) m, axis: slope; }

        body case {
            mass: 2 kg; inertia: plate(2 kg, 0.2 m, 0.4 m); port c: (0, 0) m;
            start x: -0.2 m*sin(slope); start y: 0.2 m*cos(slope); start angle: slope;
        }
        polygon_on_line feet(ground.incline, case.c) {
            corners: (-0.1, -0.2), (0.1, -0.2), (0.1, 0.2), (-0.1, 0.2) m;
            friction: 2;
        }
        body sled { mass: 2 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start x: -1 m; start y: 0.5 m; }
        ground_profile valley(ground.o, sled.c) { height(x): x^2/(2 m); friction: 0.2; }
        body hiker { mass: 2 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start vx: 1 m/s; }
        ground_profile crest(ground.o, hiker.c) { height(x): -x^2/(2 m); }

        output case.alpha, feet.push, feet.corner_push[0], feet.corner_push[1], feet.drag;
        output valley.push, valley.drag, valley.slip, valley.lost, crest.push;
        allow(W0002);
    }
}

fn run(mechanism: &Scene) -> Sim<Scene> {
    mechanism.start_with(Dop853::new(1e-10)).unwrap()
}

/// The box on a slope.
fn on_slope(slope: f64) -> Sim<Scene> {
    let mechanism = Grounds::new()
        .with("slope", slope)
        .with_start("case.x", -0.2 * slope.sin())
        .with_start("case.y", 0.2 * slope.cos())
        .with_start("case.angle", slope);
    run(&mechanism)
}

/// A box of 0.2 m by 0.4 m tips from tan = 1/2 on, about its lower corner with m g (h sin - w cos)/2 over its inertia there. Before,
/// the corners bear N/2 (1 -+ h/w tan).
#[test]
fn a_box_tips_on_a_slope() {
    let limit = 0.5_f64.atan();
    for (slope, mode) in [(limit - 1e-6, Mode::Closed), (limit + 1e-6, Mode::Open)] {
        let mut sim = on_slope(slope);
        sim.step(0.01).unwrap();
        assert_eq!(sim.contact("feet.contact[1]"), Some(mode), "{slope}");
    }
    let slope = 20_f64.to_radians();
    let mut sim = on_slope(slope);
    sim.step(0.1).unwrap();
    near(sim.value_of("feet.push"), 2.0 * G * slope.cos(), 1e-9);
    near(sim.value_of("feet.corner_push[0]"), G * slope.cos() * (1.0 + 2.0 * slope.tan()), 1e-9);
    near(sim.value_of("feet.corner_push[1]"), G * slope.cos() * (1.0 - 2.0 * slope.tan()), 1e-9);
    near(sim.value_of("feet.drag"), 2.0 * G * slope.sin(), 1e-9);
    let slope = 40_f64.to_radians();
    let sim = on_slope(slope);
    let inertia = 2.0 * (0.04 + 0.16) / 12.0 + 2.0 * (0.01 + 0.04);
    near(sim.value_of("case.alpha"), 2.0 * G * (0.2 * slope.sin() - 0.1 * slope.cos()) / inertia, 1e-9);
}

/// With the path's angle a and curvature k: v' = -g sin a - mu (g cos a + k v^2) sign v, by Runge and Kutta's method in the arc.
#[test]
fn a_sled_slides_through_a_valley() {
    let mut sim = run(&Grounds::new());
    let (mut x, mut v) = (-1.0_f64, 0.0_f64);
    let rate = |x: f64, v: f64| {
        let (cos, sin) = (1.0 / (1.0 + x * x).sqrt(), x / (1.0 + x * x).sqrt());
        (v * cos, -G * sin - 0.2 * (G * cos + cos.powi(3) * v * v))
    };
    let step = 1e-4;
    for _ in 0..5000 {
        let (a, b) = rate(x, v);
        let (c, d) = rate(x + 0.5 * step * a, v + 0.5 * step * b);
        let (e, f) = rate(x + 0.5 * step * c, v + 0.5 * step * d);
        let (g, h) = rate(x + step * e, v + step * f);
        x += step / 6.0 * (a + 2.0 * c + 2.0 * e + g);
        v += step / 6.0 * (b + 2.0 * d + 2.0 * f + h);
    }
    sim.step_to(0.5).unwrap();
    assert!(v > 0.5, "it slides forwards");
    near(sim.state_of("sled").x, x, 1e-8);
    near(sim.state_of("sled").y, 0.5 * x * x, 1e-9);
    near(sim.value_of("valley.slip"), v, 1e-8);
    let cos = 1.0 / (1.0 + x * x).sqrt();
    let push = 2.0 * (G * cos + cos.powi(3) * v * v);
    near(sim.value_of("valley.push"), push, 1e-7);
    near(sim.value_of("valley.drag"), -0.2 * push, 1e-7);
    near(sim.value_of("valley.lost"), 0.2 * push * v, 1e-7);
    // It comes to rest within the cone of friction, |y'| <= mu.
    sim.step_to(5.0).unwrap();
    assert_eq!(sim.contact("valley.rub"), Some(Mode::Sticks));
    assert!(sim.state_of("sled").x.abs() < 0.2 && sim.state_of("sled").vx.abs() < 1e-12);
}

/// Over a crest of radius 1 m one keeps to the ground as long as v^2 < g R.
#[test]
fn a_hiker_takes_off_on_a_crest() {
    for (speed, mode) in [(G.sqrt() - 1e-6, Mode::Closed), (G.sqrt() + 1e-6, Mode::Open)] {
        let mut mechanism = Grounds::new();
        mechanism = mechanism.with_start("hiker.vx", speed);
        let sim = run(&mechanism);
        assert_eq!(sim.contact("crest.contact"), Some(mode), "{speed} m/s");
        near(sim.value_of("crest.push"), (2.0 * (G - speed * speed)).max(0.0), 1e-9);
    }
}
