//! Mechanisms as the reference knows them: rigid bodies with three coordinates each, and functions of these coordinates.

/// A point of a body, or of the ground.
pub type At = (Option<usize>, [f64; 2]);

/// A function of the coordinates (x, y, angle of each body) and of the time.
#[derive(Clone, Debug)]
pub enum Place {
    /// How far the point `a` is from `b` along a direction, which turns with the body of `b` if it says so; `swing` takes
    /// amplitude sin(omega t) away.
    Along { a: At, b: At, angle: f64, turns: bool, swing: [f64; 2] },
    /// factor times the distance of two points, and an offset.
    Distance { a: At, b: At, factor: f64, offset: f64 },
    /// A sum of coordinates, an offset, and a rate times the time.
    Sum { terms: Vec<(usize, f64)>, offset: f64, rate: f64 },
}

/// An applied force.
#[derive(Clone, Debug)]
pub enum Force {
    /// amplitude sin(omega t + phase) on a coordinate, and a constant.
    On { coordinate: usize, constant: f64, amplitude: f64, omega: f64, phase: f64 },
    /// Against a place: stiffness (z - rest) + damping dz/dt.
    Spring { place: Place, stiffness: f64, rest: f64, damping: f64 },
}

/// Bound of a friction: the sum of its own, of a share of a push and of a share of a reaction.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bound {
    /// Its own, against a slip forwards and backwards.
    pub own: [f64; 2],
    /// A coefficient at the push of a gap.
    pub by: Option<(usize, f64)>,
    /// A coefficient at the size of the force of one or two rows of joints.
    pub joint: Option<(usize, Option<usize>, f64)>,
    /// The bound while it sticks is so many times that.
    pub adhesion: f64,
}

/// Law of a row of contact.
#[derive(Clone, Copy, Debug)]
pub enum Law {
    Gap { restitution: f64 },
    Rub(Bound),
}

/// A mechanism.
#[derive(Clone, Debug, Default)]
pub struct World {
    /// Mass, mass, moment of inertia of each body.
    pub inertia: Vec<f64>,
    /// Gravity, x and y.
    pub gravity: [f64; 2],
    pub forces: Vec<Force>,
    /// Places that are zero.
    pub joints: Vec<Place>,
    pub rows: Vec<(Place, Law)>,
}

/// A place at a state.
#[derive(Clone, Debug)]
pub struct Seen {
    pub value: f64,
    pub rate: f64,
    /// The second derivative without accelerations.
    pub zeta: f64,
    /// The derivatives with respect to coordinates, by number.
    pub slopes: Vec<(usize, f64)>,
}

impl World {
    pub fn body(&mut self, mass: f64, inertia: f64) -> usize {
        self.inertia.extend([mass, mass, inertia]);
        self.inertia.len() / 3 - 1
    }

    /// Two points coincide.
    pub fn pin(&mut self, a: At, b: At) -> usize {
        let along = |angle| Place::Along { a, b, angle, turns: false, swing: [0.0; 2] };
        self.joints.extend([along(0.0), along(std::f64::consts::FRAC_PI_2)]);
        self.joints.len() - 2
    }

    pub fn row(&mut self, place: Place, law: Law) -> usize {
        self.rows.push((place, law));
        self.rows.len() - 1
    }

    pub fn kinetic(&self, v: &[f64]) -> f64 {
        self.inertia.iter().zip(v).map(|(m, v)| 0.5 * m * v * v).sum()
    }
}

/// A moment of all bodies, with sine and cosine of each angle.
pub struct Pose<'s> {
    pub t: f64,
    pub q: &'s [f64],
    pub v: &'s [f64],
    turns: Vec<(f64, f64)>,
}

/// A point in motion: its place, its arm from the body's centre, its velocity, its acceleration without those of the coordinates.
struct Point {
    body: Option<usize>,
    place: [f64; 2],
    arm: [f64; 2],
    velocity: [f64; 2],
    zeta: [f64; 2],
}

impl<'s> Pose<'s> {
    pub fn new(t: f64, q: &'s [f64], v: &'s [f64]) -> Self {
        Self { t, q, v, turns: q.chunks(3).map(|body| body[2].sin_cos()).collect() }
    }

    fn point(&self, (body, [x, y]): At) -> Point {
        let Some(of) = body else {
            return Point { body, place: [x, y], arm: [0.0; 2], velocity: [0.0; 2], zeta: [0.0; 2] };
        };
        let ((s, c), k) = (self.turns[of], 3 * of);
        let (arm, omega) = ([c * x - s * y, s * x + c * y], self.v[k + 2]);
        Point {
            body,
            place: [self.q[k] + arm[0], self.q[k + 1] + arm[1]],
            arm,
            velocity: [self.v[k] - omega * arm[1], self.v[k + 1] + omega * arm[0]],
            zeta: arm.map(|x| -omega * omega * x),
        }
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn less(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Derivatives of sign e . p with respect to the coordinates of the body of p.
fn along(slopes: &mut Vec<(usize, f64)>, e: [f64; 2], sign: f64, point: &Point) {
    if let Some(body) = point.body {
        let turned = e[1] * point.arm[0] - e[0] * point.arm[1];
        slopes.extend([(3 * body, sign * e[0]), (3 * body + 1, sign * e[1]), (3 * body + 2, sign * turned)]);
    }
}

impl Place {
    pub fn see(&self, pose: &Pose) -> Seen {
        match self {
            Self::Along { a, b, angle, turns, swing: [amplitude, omega] } => {
                let (a, b) = (pose.point(*a), pose.point(*b));
                let carrier = b.body.filter(|_| *turns);
                let (angle, spin) =
                    carrier.map_or((*angle, 0.0), |k| (angle + pose.q[3 * k + 2], pose.v[3 * k + 2]));
                let (s, c) = angle.sin_cos();
                let (e, across) = ([c, s], [-s, c]);
                let (apart, moving) = (less(a.place, b.place), less(a.velocity, b.velocity));
                let (swing, swings) = (omega * pose.t).sin_cos();
                let mut slopes = Vec::with_capacity(7);
                along(&mut slopes, e, 1.0, &a);
                along(&mut slopes, e, -1.0, &b);
                slopes.extend(carrier.map(|k| (3 * k + 2, dot(across, apart))));
                Seen {
                    value: dot(e, apart) - amplitude * swing,
                    rate: dot(e, moving) + spin * dot(across, apart) - amplitude * omega * swings,
                    zeta: dot(e, less(a.zeta, b.zeta)) + 2.0 * spin * dot(across, moving)
                        - spin * spin * dot(e, apart)
                        + amplitude * omega * omega * swing,
                    slopes,
                }
            }
            Self::Distance { a, b, factor, offset } => {
                let (a, b) = (pose.point(*a), pose.point(*b));
                let (apart, moving) = (less(a.place, b.place), less(a.velocity, b.velocity));
                let distance = apart[0].hypot(apart[1]);
                let e = apart.map(|x| x / distance);
                let rate = dot(e, moving);
                let zeta = dot(e, less(a.zeta, b.zeta)) + (dot(moving, moving) - rate * rate) / distance;
                let mut slopes = Vec::with_capacity(6);
                along(&mut slopes, e, *factor, &a);
                along(&mut slopes, e, -factor, &b);
                Seen { value: factor * distance + offset, rate: factor * rate, zeta: factor * zeta, slopes }
            }
            Self::Sum { terms, offset, rate } => {
                let sum = |x: &[f64]| terms.iter().map(|(k, factor)| factor * x[*k]).sum::<f64>();
                Seen {
                    value: offset + rate * pose.t + sum(pose.q),
                    rate: rate + sum(pose.v),
                    zeta: 0.0,
                    slopes: terms.clone(),
                }
            }
        }
    }
}
