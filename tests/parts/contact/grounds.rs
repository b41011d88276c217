//! Polygons on lines, points and circles on profiles.

use plm::runtime::contact::Mode;
use plm::{Dop853, Sim};

use super::{G, near};

plm::mechanism! {
    /// A box on a slope, a pebble on stairs, a disc that rolls off an edge, sleds on curved ground.
    pub Grounds {
        param slope: rad = 20 deg;
        param speed: m/s = 1 m/s;
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
        body pebble { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start y: 1 m; start vx: 1 m/s; }
        point_on_polyline stairs(ground.o, pebble.c) {
            vertices: (-5, 0), (1, 0), (1, -0.5), (5, -0.5) m;
            thickness: 0.2 m;
            restitution: 0.5;
        }
        body disc { mass: 3 kg; inertia: disc(3 kg, 0.2 m); port c: (0, 0) m; start x: 0.9 m; start y: 0.2 m; start vx: 0.3 m/s; start omega: -1.5 rad/s; }
        circle_on_polyline edge(ground.o, disc.c) { vertices: (-5, 0), (1, 0), (1, -3), (5, -3) m; radius: 0.2 m; friction: 1e4; }
        body sled { mass: 2 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start x: -1 m; start y: 0.5 m; }
        ground_profile valley(ground.o, sled.c) { height(x): x^2/(2 m); friction: 0.2; }
        body hiker { mass: 2 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start vx: speed; }
        ground_profile crest(ground.o, hiker.c) { height(x): -x^2/(2 m); }

        output case.alpha, feet.push, feet.corner_push[0], feet.corner_push[1], feet.drag, stairs.push, edge.push, edge.lost;
        output valley.push, valley.drag, valley.slip, valley.lost, crest.push;
        allow(W0002);
    }
}

fn run(mechanism: Grounds) -> Sim<Grounds> {
    mechanism.start_with(Dop853::new(1e-10)).unwrap()
}

/// A box of 0.2 m by 0.4 m tips from tan = 1/2 on, about its lower corner with m g (h sin - w cos)/2 over its inertia there. Before,
/// the corners bear N/2 (1 -+ h/w tan).
#[test]
fn a_box_tips_on_a_slope() {
    let limit = 0.5_f64.atan();
    for (slope, mode) in [(limit - 1e-6, Mode::Closed), (limit + 1e-6, Mode::Open)] {
        let mut sim = run(Grounds { slope, ..Grounds::new() });
        sim.step(0.01).unwrap();
        assert_eq!(sim.contact("feet.contact[1]"), Some(mode), "{slope}");
    }
    let slope = 20_f64.to_radians();
    let mut sim = run(Grounds { slope, ..Grounds::new() });
    sim.step(0.1).unwrap();
    near(sim.feet_push(), 2.0 * G * slope.cos(), 1e-9);
    near(sim.feet_corner_push_0(), G * slope.cos() * (1.0 + 2.0 * slope.tan()), 1e-9);
    near(sim.feet_corner_push_1(), G * slope.cos() * (1.0 - 2.0 * slope.tan()), 1e-9);
    near(sim.feet_drag(), 2.0 * G * slope.sin(), 1e-9);
    let slope = 40_f64.to_radians();
    let sim = run(Grounds { slope, ..Grounds::new() });
    let inertia = 2.0 * (0.04 + 0.16) / 12.0 + 2.0 * (0.01 + 0.04);
    near(sim.case_alpha(), 2.0 * G * (0.2 * slope.sin() - 0.1 * slope.cos()) / inertia, 1e-9);
}

/// It falls by 1 m, bounces twice on the upper step, flies over the edge and falls by 0.5 m.
#[test]
fn a_pebble_bounces_down_stairs() {
    let mut sim = run(Grounds::new());
    let first = (2.0 / G).sqrt();
    let (second, up) = (2.0 * first, 0.25 * G * first);
    let third = second + (up + (up * up + G).sqrt()) / G;
    for (time, leaves) in [(first, 0.5 * G * first), (second, up), (third, 0.5 * (up * up + G).sqrt())] {
        sim.step_to(time - 1e-9).unwrap();
        assert!(sim.pebble().vy < 0.0, "before {time} s");
        sim.step_to(time + 1e-9).unwrap();
        near(sim.pebble().vy, leaves, 1e-7);
    }
    near(sim.pebble().x, third, 1e-8);
    near(sim.pebble().y, -0.5, 1e-8);
    // It comes to rest on the lower step, which bears it.
    sim.step_to(3.5).unwrap();
    assert_eq!((sim.pebble().vy, sim.contact("stairs.contact[3]")), (0.0, Some(Mode::Closed)));
    near(sim.stairs_push(), G, 1e-9);
}

/// A disc that rolls off an edge turns about it and leaves at cos = (4 + 3 v^2/(g r))/7.
#[test]
fn a_disc_rolls_off_an_edge() {
    let mut sim = run(Grounds::new());
    let over = 0.1 / 0.3;
    sim.step_to(over - 1e-6).unwrap();
    near(sim.edge_push(), 3.0 * G, 1e-9);
    sim.step_to(over + 1e-6).unwrap();
    assert_eq!(sim.contact("edge.corner[1]"), Some(Mode::Closed));
    near(sim.edge_push(), 3.0 * (G - 0.09 / 0.2), 1e-4);
    let saved = sim.save();
    let (mut low, mut high) = (over, 2.0);
    for _ in 0..45 {
        let half = 0.5 * (low + high);
        sim.resume(&saved);
        sim.step_to(half).unwrap();
        *(if sim.contact("edge.corner[1]") == Some(Mode::Closed) { &mut low } else { &mut high }) = half;
    }
    sim.resume(&saved);
    sim.step_to(low).unwrap();
    near(sim.disc().y / 0.2, (4.0 + 3.0 * 0.09 / (G * 0.2)) / 7.0, 1e-7);
    near(sim.edge_lost(), 0.0, 1e-3);
}

/// With the path's angle a and curvature k: v' = -g sin a - mu (g cos a + k v^2) sign v, by Runge and Kutta's method in the arc.
#[test]
fn a_sled_slides_through_a_valley() {
    let mut sim = run(Grounds::new());
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
    near(sim.sled().x, x, 1e-8);
    near(sim.sled().y, 0.5 * x * x, 1e-9);
    near(sim.valley_slip(), v, 1e-8);
    let cos = 1.0 / (1.0 + x * x).sqrt();
    let push = 2.0 * (G * cos + cos.powi(3) * v * v);
    near(sim.valley_push(), push, 1e-7);
    near(sim.valley_drag(), -0.2 * push, 1e-7);
    near(sim.valley_lost(), 0.2 * push * v, 1e-7);
    // It comes to rest within the cone of friction, |y'| <= mu.
    sim.step_to(5.0).unwrap();
    assert_eq!(sim.contact("valley.rub"), Some(Mode::Sticks));
    assert!(sim.sled().x.abs() < 0.2 && sim.sled().vx.abs() < 1e-12);
}

/// Over a crest of radius 1 m one keeps to the ground as long as v^2 < g R.
#[test]
fn a_hiker_takes_off_on_a_crest() {
    let limit = G.sqrt();
    let slow = run(Grounds { speed: limit - 1e-6, ..Grounds::new() });
    assert_eq!(slow.contact("crest.contact"), Some(Mode::Closed));
    near(slow.crest_push(), 2.0 * (G - (limit - 1e-6).powi(2)), 1e-9);
    let fast = run(Grounds { speed: limit + 1e-6, ..Grounds::new() });
    assert_eq!(fast.contact("crest.contact"), Some(Mode::Open));
}
