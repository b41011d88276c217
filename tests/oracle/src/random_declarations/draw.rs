//! Random declarations: trees and loops of a few bodies, with what the language has beside joints.

use std::fmt::Write;

use plm_oracle::Random;

/// A body, or the ground: its place, and its ports so far.
struct Body {
    name: String,
    at: [f64; 2],
    /// rad.
    angle: f64,
    ports: String,
    count: usize,
}

impl Body {
    fn new(name: String, at: [f64; 2], degrees: f64) -> Body {
        Body { name, at, angle: degrees.to_radians(), ports: String::new(), count: 0 }
    }

    /// A port at a place, rounded as people write it, with the direction of its axis in degrees. Gives its name.
    fn port(&mut self, place: [f64; 2], axis: Option<f64>) -> String {
        let (s, c) = self.angle.sin_cos();
        let [x, y] = [place[0] - self.at[0], place[1] - self.at[1]];
        let (u, v) = (c * x + s * y, c * y - s * x);
        let axis =
            axis.map_or(String::new(), |axis| format!(", axis: {:.1} deg", axis - self.angle.to_degrees()));
        let _ = writeln!(self.ports, "        port p{}: ({u:.3}, {v:.3}) m{axis};", self.count);
        self.count += 1;
        format!("{}.p{}", self.name, self.count - 1)
    }
}

/// A declaration in the making.
struct Draft<'a> {
    random: &'a mut Random,
    /// The ground, then the bodies.
    bodies: Vec<Body>,
    heads: String,
    items: String,
    freedoms: usize,
}

/// The declaration of a number of a seed.
pub fn declaration(seed: u64, number: u64) -> String {
    let mut random = Random::new(seed, number);
    let count = 1 + random.below(5);
    let mut draft = Draft {
        bodies: vec![Body::new("ground".to_owned(), [0.0; 2], 0.0)],
        heads: String::new(),
        items: String::new(),
        freedoms: 3 * count,
        random: &mut random,
    };
    for k in 0..count {
        let at = [draft.tenth(1.5), draft.tenth(1.5)];
        let degrees = draft.tenth(180.0);
        draft.bodies.push(Body::new(format!("b{k}"), at, degrees));
    }
    for to in 1..=count {
        if draft.random.chance(0.9) {
            let from = draft.random.below(to);
            draft.joint(from, to);
        }
    }
    while count > 1 && draft.freedoms > 2 && draft.random.chance(0.4) {
        let from = draft.random.below(count);
        let to = from + 1 + draft.random.below(count - from);
        draft.joint(from, to);
    }
    for _ in 0..draft.random.below(4) {
        draft.load();
    }
    draft.beside();
    draft.text()
}

impl Draft<'_> {
    /// A decimal between minus and plus a size, with two digits of it.
    fn tenth(&mut self, size: f64) -> f64 {
        size * (50.0 * self.random.unit()).round() / 50.0
    }

    fn positive(&mut self, size: f64) -> f64 {
        size * (1.0 + self.random.below(40) as f64) / 20.0
    }

    /// A joint between two, at a place near the second one.
    fn joint(&mut self, from: usize, to: usize) {
        let place = [self.bodies[to].at[0] + self.tenth(0.5), self.bodies[to].at[1] + self.tenth(0.5)];
        let axis = self.tenth(180.0);
        let slides = self.random.below(5);
        let (kind, rows) = match slides {
            0 => ("prismatic", 2),
            1 => ("pin_slot", 1),
            _ => ("revolute", 2),
        };
        if self.freedoms <= rows {
            return;
        }
        self.freedoms -= rows;
        let axis = (slides < 2).then_some(axis);
        let along = axis.map_or([0.0; 2], |axis| {
            let (s, c) = axis.to_radians().sin_cos();
            let by = self.tenth(0.6);
            [by * c, by * s]
        });
        let a = self.bodies[from].port([place[0] - along[0], place[1] - along[1]], axis);
        let b = self.bodies[to].port(place, axis);
        let name = format!("j{}{}{}", from, to, self.items.len());
        let inside = self.of_joint(kind);
        let _ = writeln!(self.items, "    {kind} {name}({a}, {b}) {{ {inside}}}");
        if self.random.chance(0.3) {
            let _ = writeln!(self.items, "    output {name}.force;");
        }
    }

    /// Spring, damper, drive and friction of a joint.
    fn of_joint(&mut self, kind: &str) -> String {
        let (length, force) = if kind == "revolute" { ("rad", "N*m") } else { ("m", "N") };
        let mut inside = String::new();
        if self.random.chance(0.3) {
            let stiffness = self.number("k", &format!("{force}/{length}"), 20.0);
            let _ = write!(inside, "stiffness: {stiffness}; ");
        }
        if self.random.chance(0.4) {
            let damping = self.number("c", &format!("{force}/({length}/s)"), 1.0);
            let _ = write!(inside, "damping: {damping}; ");
        }
        if kind == "pin_slot" {
            return inside;
        }
        if self.random.chance(0.2) {
            let drive = self.signal(force);
            let _ = write!(inside, "drive: {drive}; ");
        }
        if self.random.chance(0.15) {
            let friction = self.positive(0.5);
            let _ = write!(inside, "seal_friction: {friction:.2} {force}; ");
        }
        inside
    }

    /// A number: literally or a parameter; what acts, `u`, may be an input, too.
    fn number(&mut self, stem: &str, unit: &str, size: f64) -> String {
        let value = self.positive(size);
        let word = ["", "param", "input"][self.random.below(if stem == "u" { 3 } else { 2 })];
        if word.is_empty() {
            return format!("{value:.2} {unit}");
        }
        let name = format!("{stem}{}", self.heads.len());
        let _ = writeln!(self.heads, "    {word} {name}: {unit} = {value:.2} {unit};");
        name
    }

    /// A value that follows the time or the state.
    fn signal(&mut self, unit: &str) -> String {
        let size = self.number("u", unit, 3.0);
        let body = 1 + self.random.below(self.bodies.len() - 1);
        let body = self.bodies[body].name.clone();
        let (x, w) = (self.tenth(1.0), self.positive(4.0));
        match self.random.below(10) {
            0 => format!("{size}*sin({w:.1} rad/s*t)"),
            1 => format!("(if {body}.x > {x:.2} m then {size} else -{size})"),
            2 => format!("{size}*table(t, (0 s, 0), (0.12 s, 1), (0.3 s, -0.4))"),
            3 => format!("-{size}*{body}.omega/(2 rad/s)"),
            4 => format!("{size}*sign({body}.vy)*min(abs({body}.vy)/(1 m/s), 0.7)"),
            5 => format!("clamp(-{size}*{body}.angle/(1 rad), -{size}, 0.5*{size})"),
            6 => format!("{size}*exp(-t/(0.3 s))*cos({body}.angle)"),
            7 => format!("(if t < 0.13 s then {size} else 0.2*{size})"),
            8 => format!("-{size}*norm({body}.velocity)*({body}.y/(1 m))^3/(1 m/s)"),
            _ => format!("{size}*floor(4*t/(1 s))"),
        }
    }

    /// A force on a body, or a spring between two.
    fn load(&mut self) {
        let to = 1 + self.random.below(self.bodies.len() - 1);
        let place = [self.bodies[to].at[0] + self.tenth(0.5), self.bodies[to].at[1] + self.tenth(0.5)];
        let b = self.bodies[to].port(place, None);
        let number = self.items.len();
        if self.random.chance(0.5) {
            let from = self.random.below(to);
            let a = self.bodies[from].port([place[0] + 0.73, place[1] - 0.41], None);
            let (k, c) = (self.number("k", "N/m", 50.0), self.number("c", "N/(m/s)", 2.0));
            let length = self.positive(0.5);
            let _ = writeln!(
                self.items,
                "    spring s{number}({a}, {b}) {{ stiffness: {k}; damping: {c}; free_length: {length:.2} m; }}"
            );
            return;
        }
        let (x, y) = (self.signal("N"), self.signal("N"));
        let torque =
            if self.random.chance(0.3) { format!(" torque: {};", self.signal("N*m")) } else { String::new() };
        let _ = writeln!(self.items, "    force f{number}({b}) {{ x: {x}; y: {y};{torque} }}");
    }

    /// States, events and contact.
    fn beside(&mut self) {
        let body = 1 + self.random.below(self.bodies.len() - 1);
        let name = self.bodies[body].name.clone();
        if self.random.chance(0.3) {
            let (start, lag) = (self.tenth(1.0), self.positive(0.2));
            let _ = writeln!(self.items, "    state z: 1 = {start:.2};");
            let _ = writeln!(self.items, "    rate z = ({name}.y/(1 m) - z)/({lag:.2} s);");
            let _ = writeln!(self.items, "    output z;");
        }
        if self.random.chance(0.25) {
            let level = self.tenth(1.5);
            let _ = writeln!(self.items, "    discrete n: 1 = 0;");
            let _ = writeln!(self.items, "    when {name}.y < {level:.2} m {{ n = n + 1; }}");
            let _ = writeln!(self.items, "    output n;");
        }
        if self.random.chance(0.3) {
            let at = self.bodies[body].at;
            let place = [at[0] + self.tenth(0.4), at[1] + self.tenth(0.4)];
            let tip = self.bodies[body].port(place, None);
            let (floor, e, mu) =
                (place[1] - self.positive(0.1) - 0.01, self.random.below(8), self.random.below(8));
            let _ = writeln!(
                self.items,
                "    unilateral floor: {tip}.y >= {floor:.2} m {{ restitution: 0.{e}; }}"
            );
            if mu > 2 {
                let _ =
                    writeln!(self.items, "    friction rub: rate({tip}.x) within 0.{mu}*reaction(floor);");
            }
        }
    }

    fn text(self) -> String {
        let Draft { random, bodies, heads, items, .. } = self;
        let gravity = ["9.81 m/s^2", "0", "(1.5, -9.8) m/s^2"][random.below(3)];
        let formulation = if random.chance(0.15) { "    formulation: absolute;\n" } else { "" };
        let mut text = format!(
            "pub Drawn {{\n    gravity: {gravity};\n{formulation}{heads}    ground {{\n{}    }}\n",
            bodies[0].ports
        );
        for body in &bodies[1..] {
            let (mass, inertia) =
                ((1.0 + random.below(30) as f64) / 10.0, (1.0 + random.below(30) as f64) / 100.0);
            let [x, y] = body.at;
            let _ = write!(
                text,
                "    body {} {{\n        mass: {mass:.1} kg; inertia: {inertia:.2} kg*m^2;\n{}        \
                 start x: {x:.2} m; start y: {y:.2} m; start angle: {:.1} deg;\n    }}\n",
                body.name,
                body.ports,
                body.angle.to_degrees()
            );
        }
        text + &items + "    allow(W0001);\n    allow(W0002);\n}\n"
    }
}
