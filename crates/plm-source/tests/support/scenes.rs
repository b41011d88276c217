//! Mechanisms with friction and contact: crates, pins, a slide in a loop, and weights whose rows exist on conditions.

use plm_dynamic::Mechanism;

/// Two corners that bounce and rub, with a static bound; a controller that pushes.
const CRATE: &str = "pub Crate {
    gravity: 9.81 m/s^2;
    impacts: LAW;
    body body {
        mass: 1 kg; inertia: 0.01 kg*m^2; port left: (-0.1, 0) m; port right: (0.1, 0) m;
        start y: 0.2 m; start angle: 20 deg; start vx: 1 m/s;
    }
    discrete kick: N = 0 N;
    discrete due: s = 50 ms;
    when t > due { kick = 5 N - 10 N*s/m*body.vx; due = due + 50 ms; }
    force pull(body.left) { x: kick; }
    unilateral left: body.left.y >= 0 m { restitution: 0.5; }
    unilateral right: body.right.y >= 0 m { restitution: 0.5; }
    friction rub: rate(body.left.x) within 0.3*reaction(left) { static: 0.4*reaction(left); }
    friction drag: rate(body.right.x) within 0.3*reaction(right);
    output a = reaction(left), b = reaction(right), c = reaction(rub), body.vx;
}";

/// Pins that rub by their load, and a stop.
const PINS: &str = "pub Pins {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body arm { mass: 1 kg; inertia: rod(1 kg, 1 m); port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 45 deg; }
    body rod { mass: 0.5 kg; inertia: rod(0.5 kg, 0.6 m); port a: (-0.3, 0) m; port b: (0.3, 0) m; start angle: 45 deg; }
    revolute shoulder(ground.o, arm.a) { friction: 0.3; static_friction: 0.4; pin_diameter: 40 mm; }
    revolute elbow(arm.b, rod.a) { friction: 0.2; pin_diameter: 20 mm; lower_limit: -30 deg; upper_limit: 30 deg; restitution: 0.3; }
    output shoulder.friction_torque, elbow.friction_torque, elbow.lower_limit_torque, shoulder.force;
}";

/// A loop whose guide rubs along a line.
const SLIDE: &str = "pub Slide {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body crank { mass: 1 kg; inertia: rod(1 kg, 0.2 m); port a: (-0.1, 0) m; port b: (0.1, 0) m; start angle: 45 deg; }
    body link { mass: 1 kg; inertia: rod(1 kg, 0.5 m); port a: (-0.25, 0) m; port b: (0.25, 0) m; start x: 0.3 m; }
    body slide { mass: 2 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; start x: 0.6 m; }
    revolute main(ground.o, crank.a) { drive: 5 N*m; }
    revolute big(crank.b, link.a);
    revolute small(link.b, slide.a);
    prismatic guide(ground.o, slide.a) { friction: 0.2; static_friction: 0.3; guide_length: 0.1 m; }
    output guide.friction_force, guide.lost, main.force;
}";

/// A row that exists until a time, and one on a condition of the state.
const WEIGHTS: &str = "pub Weights {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m, axis: 90 deg; }
    body lower { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; start y: 0.1 m; }
    body upper { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; start y: 0.5 m; start vy: 1 m/s; }
    prismatic one(ground.o, lower.a) { lower_limit: 0 m; restitution: 0.5; seal_friction: 1 N; }
    prismatic two(ground.o, upper.a);
    unilateral meet: upper.y - lower.y >= 0.1 m { restitution: 0.5; when: t < 0.6 s; }
    unilateral shelf: upper.y >= -0.5 m { when: upper.y > -0.6 m; }
    output one.friction_force, one.lower_limit_force, lower.y, upper.y, open = if is_open(one.lower) then 1 else 0;
}";

/// The scenes, each with its name.
pub(crate) fn scenes() -> Vec<(String, Mechanism)> {
    let crates = ["poisson", "newton", "sequential"].map(|law| (law, CRATE.replace("LAW", law)));
    let others = [("pins", PINS), ("slide", SLIDE), ("weights", WEIGHTS)];
    let all = crates.into_iter().chain(others.map(|(name, text)| (name, text.to_owned())));
    all.map(|(name, text)| {
        (name.to_owned(), Mechanism::from_text(&text).unwrap_or_else(|why| panic!("{name}: {why}")))
    })
    .collect()
}
