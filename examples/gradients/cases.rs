//! Random mechanisms, each with the parameters by which its outputs are derived.

#[path = "../../tests/support/random.rs"]
mod random;

use random::Random;

/// Mechanisms of one kind.
pub struct Family {
    pub name: &'static str,
    /// The declaration, with `{0}`, `{1}`, ... for the values of its parameters.
    text: &'static str,
    /// Parameters by which it may be derived, with the ranges of their values.
    parameters: &'static [(&'static str, [f64; 2])],
    /// The latest time, s.
    until: f64,
}

/// A mechanism, by which of its parameters it is derived, and when.
pub struct Case {
    pub family: usize,
    pub text: String,
    pub by: [(&'static str, f64); 3],
    pub time: f64,
}

impl Case {
    pub fn new(seed: u64, number: u64) -> Self {
        let mut random = Random::new(seed, number);
        let family = (number % FAMILIES.len() as u64) as usize;
        let Family { text, parameters, until, .. } = &FAMILIES[family];
        // As people write them: three digits.
        let values: Vec<f64> = parameters
            .iter()
            .map(|(_, [low, high])| (1e3 * random.between(*low, *high)).round() / 1e3)
            .collect();
        let text = values.iter().enumerate().fold((*text).to_owned(), |text, (k, value)| {
            text.replace(&format!("{{{k}}}"), &value.to_string())
        });
        let first = random.below(parameters.len());
        let by = [0, 1, 2].map(|k| {
            let k = (first + k) % parameters.len();
            (parameters[k].0, values[k])
        });
        let time = (1e3 * random.between(0.1 * until, *until)).round() / 1e3;
        Self { family, text, by, time }
    }
}

pub const FAMILIES: [Family; 6] = [
    Family {
        name: "bouncing",
        text: "pub Bouncing {
    param height: m = {0} m;
    param e: 1 = {1};
    param mu: 1 = {2};
    param g: m/s^2 = {3} m/s^2;
    param speed: m/s = {4} m/s;
    gravity: g;
    body disc { mass: 1 kg; inertia: 0.01 kg*m^2; start y: height; start vx: speed, locked; }
    unilateral floor: disc.y >= 0 m { restitution: e; }
    friction grip: rate(disc.x + 0.1 m*disc.angle/(1 rad)) within mu*reaction(floor);
    output disc.x, disc.y, disc.angle, disc.vx;
}",
        parameters: &[
            ("height", [0.2, 2.0]),
            ("e", [0.3, 0.9]),
            ("mu", [0.05, 0.5]),
            ("g", [5.0, 15.0]),
            ("speed", [0.5, 3.0]),
        ],
        until: 1.2,
    },
    Family {
        name: "hammer",
        text: "pub Hammer {
    param upper: m = {0} m;
    param lower: m = {1} m;
    param e: 1 = {2};
    param stop: rad = {3} rad;
    param damping: N*m*s/rad = {4} N*m*s/rad;
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body one { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0 m, upper); port b: (0 m, -upper); start angle: 1 rad, locked; }
    body two { mass: 0.5 kg; inertia: 0.01 kg*m^2; port a: (0 m, lower); start angle: 1.4 rad, locked; }
    revolute shoulder(ground.o, one.a) { damping: damping; }
    revolute elbow(one.b, two.a);
    unilateral bump: one.angle >= stop { restitution: e; }
    output one.angle, two.angle, one.omega;
}",
        parameters: &[
            ("upper", [0.2, 0.6]),
            ("lower", [0.2, 0.6]),
            ("e", [0.2, 0.8]),
            ("stop", [-0.3, 0.4]),
            ("damping", [0.0, 0.2]),
        ],
        until: 1.5,
    },
    Family {
        name: "four-bar",
        text: "pub FourBar {
    param base: m = {0} m;
    param long: m = {1} m;
    param swing: m = {2} m;
    param torque: N*m = {3} N*m;
    param damping: N*m*s/rad = {4} N*m*s/rad;
    gravity: 9.81 m/s^2;
    ground { port left: (0, 0) m; port right: (base, 0 m); }
    body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (0.1, 0) m; start angle: 0.7 rad, locked; }
    body coupler { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0, 0) m; port b: (long, 0 m); start x: 0.08 m; start y: 0.06 m; start angle: 0.5 rad; }
    body rocker { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0, 0) m; port b: (swing, 0 m); start x: base; start angle: 1.9 rad; }
    part turning(on: body) { param torque: N*m; torque on on: torque; }
    turning motor(crank) { torque: torque; }
    revolute main(ground.left, crank.a) { damping: 0.05 N*m*s/rad; }
    revolute pin(crank.b, coupler.a);
    revolute end(coupler.b, rocker.b);
    revolute side(ground.right, rocker.a) { damping: damping; }
    output crank.angle, rocker.angle, crank.omega;
}",
        parameters: &[
            ("base", [0.36, 0.44]),
            ("long", [0.33, 0.4]),
            ("swing", [0.22, 0.28]),
            ("torque", [1.0, 6.0]),
            ("damping", [0.0, 0.1]),
        ],
        until: 1.0,
    },
    Family {
        name: "belt",
        text: "pub Belt {
    param kinetic: N = {0} N;
    param more: N = {1} N;
    param speed: m/s = {2} m/s;
    param stiffness: N/m = {3} N/m;
    param mass: kg = {4} kg;
    part elastic(on: body) { param stiffness: N/m; force on on: (-stiffness*on.x, 0 N); }
    body block { mass: mass; inertia: 1 kg*m^2; start vx: speed, locked; }
    constraint upright: block.angle = 0;
    constraint flat: block.y = 0;
    elastic spring(block) { stiffness: stiffness; }
    friction grip: rate(block.x - speed*t) within kinetic { static: kinetic + more; }
    output block.x, block.vx;
}",
        parameters: &[
            ("kinetic", [1.0, 4.0]),
            ("more", [0.5, 3.0]),
            ("speed", [0.05, 0.4]),
            ("stiffness", [50.0, 200.0]),
            ("mass", [0.5, 2.0]),
        ],
        until: 3.0,
    },
    Family {
        name: "buffer",
        text: "pub Buffer {
    param radius: m = {0} m;
    param rod: m = {1} m;
    param rub: N = {2} N;
    param place: m = {3} m;
    param stiffness: N/m = {4} N/m;
    part pad(on: body) { param place: m; param stiffness: N/m; force on on: (if on.x > place then -stiffness*(on.x - place) - 2 N else 0 N, 0 N); }
    ground { port o: (0, 0) m; }
    body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0, 0) m; port b: (radius, 0 m); start angle: 1.2 rad, locked; start omega: 6 rad/s, locked; }
    body link { mass: 0.5 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (rod, 0 m); start x: 0.04 m; start y: 0.09 m; start angle: -0.3 rad; }
    body slide { mass: 0.5 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; start x: 0.35 m; }
    revolute main(ground.o, crank.a);
    revolute pin(crank.b, link.a);
    revolute end(link.b, slide.b);
    prismatic guide(ground.o, slide.b);
    pad buffer(slide) { place: place; stiffness: stiffness; }
    friction rub: rate(slide.x) within rub;
    output crank.angle, slide.x, crank.omega;
}",
        parameters: &[
            ("radius", [0.08, 0.12]),
            ("rod", [0.3, 0.4]),
            ("rub", [0.1, 1.5]),
            ("place", [0.3, 0.4]),
            ("stiffness", [50.0, 400.0]),
        ],
        until: 1.5,
    },
    Family {
        name: "reset",
        text: "pub Reset {
    param place: m = {0} m;
    param share: 1 = {1};
    param pull: N = {2} N;
    param speed: m/s = {3} m/s;
    param drag: N*s/m = {4} N*s/m;
    part hauling(on: body) { param pull: N; param drag: N*s/m; force on on: (-pull - drag*on.vx, 0 N); }
    body cart { mass: 1 kg; inertia: 1 kg*m^2; start vx: speed, locked; }
    constraint upright: cart.angle = 0;
    constraint flat: cart.y = 0;
    hauling haul(cart) { pull: pull; drag: drag; }
    when cart.x > place { cart.vx = -share*cart.vx; }
    when cart.x < -place { cart.vx = -share*cart.vx; }
    output cart.x, cart.vx;
}",
        parameters: &[
            ("place", [0.3, 1.0]),
            ("share", [0.3, 0.9]),
            ("pull", [0.5, 3.0]),
            ("speed", [2.0, 5.0]),
            ("drag", [0.0, 0.5]),
        ],
        until: 2.0,
    },
];
