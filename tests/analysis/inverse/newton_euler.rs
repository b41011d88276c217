//! Newton's and Euler's equations of free bodies, and the kinematics of dyads: inverse dynamics in another formulation than that of `plm`.

use nalgebra::{DMatrix, DVector};

/// A place in the plane with its velocity and acceleration.
#[derive(Clone, Copy)]
pub(super) struct Point(pub(super) [[f64; 2]; 3]);

impl Point {
    pub(super) fn fixed(x: f64, y: f64) -> Self {
        Self([[x, y], [0.0; 2], [0.0; 2]])
    }
}

/// A direction with its rate and its acceleration: the angle of a bar.
pub(super) type Angle = [f64; 3];

/// The point that stands at (along, across) on a bar from `from`.
pub(super) fn on_bar(from: Point, [angle, omega, alpha]: Angle, along: f64, across: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    let r = [along * cos - across * sin, along * sin + across * cos];
    let Point([place, velocity, acceleration]) = from;
    Point([
        [place[0] + r[0], place[1] + r[1]],
        [velocity[0] - omega * r[1], velocity[1] + omega * r[0]],
        [
            acceleration[0] - alpha * r[1] - omega * omega * r[0],
            acceleration[1] + alpha * r[0] - omega * omega * r[1],
        ],
    ])
}

/// The angle of the bar from one point to another.
pub(super) fn bar(from: Point, to: Point) -> Angle {
    let [r, v, a] = [0, 1, 2].map(|k| [to.0[k][0] - from.0[k][0], to.0[k][1] - from.0[k][1]]);
    let square = r[0] * r[0] + r[1] * r[1];
    [r[1].atan2(r[0]), (r[0] * v[1] - r[1] * v[0]) / square, (r[0] * a[1] - r[1] * a[0]) / square]
}

/// Two equations of the form normal . unknown = right.
fn solve(normals: [[f64; 2]; 2], right: [f64; 2]) -> [f64; 2] {
    let [[a, b], [c, d]] = normals;
    let determinant = a * d - b * c;
    [(right[0] * d - b * right[1]) / determinant, (a * right[1] - right[0] * c) / determinant]
}

/// The joint of two bars of known lengths on two points, to the left of the line from the first point to the second or to the right.
pub(super) fn dyad(one: Point, other: Point, lengths: [f64; 2], left: bool) -> Point {
    let [p, q] = [one.0[0], other.0[0]];
    let [dx, dy] = [q[0] - p[0], q[1] - p[1]];
    let d = dx.hypot(dy);
    let along = (lengths[0] * lengths[0] - lengths[1] * lengths[1] + d * d) / (2.0 * d);
    let across = (lengths[0] * lengths[0] - along * along).sqrt() * if left { 1.0 } else { -1.0 };
    let place = [p[0] + (along * dx - across * dy) / d, p[1] + (along * dy + across * dx) / d];
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let less = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let arms = [less(place, p), less(place, q)];
    let velocity = solve(arms, [dot(arms[0], one.0[1]), dot(arms[1], other.0[1])]);
    let relative = [less(velocity, one.0[1]), less(velocity, other.0[1])];
    let right = |k: usize, base: Point| dot(arms[k], base.0[2]) - dot(relative[k], relative[k]);
    Point([place, velocity, solve(arms, [right(0, one), right(1, other)])])
}

/// A body: mass, moment of inertia, its centre, its angle, the force at its centre and the torque besides joints and drives.
pub(super) struct Body {
    pub(super) mass: f64,
    pub(super) inertia: f64,
    pub(super) centre: Point,
    pub(super) angle: Angle,
    pub(super) force: [f64; 2],
    pub(super) torque: f64,
}

/// What joins bodies, by number, or the ground (`None`): the second gets the unknown, the first its opposite.
pub(super) enum Joint {
    /// A force in any direction at a place.
    Pin(Option<usize>, usize, [f64; 2]),
    /// A force across the x axis at the centre of the body, and a torque.
    Slide(usize),
    /// A torque that is looked for, with its weight.
    Motor(Option<usize>, usize, f64),
}

/// The torques and forces that are looked for, in the order of the joints, with the least sum of weight times square.
pub(super) fn drives(bodies: &[Body], joints: &[Joint]) -> Vec<f64> {
    let mut columns: Vec<(DVector<f64>, Option<f64>)> = Vec::new();
    let size = 3 * bodies.len();
    // A force at a place, or a torque, on a body.
    let wrench =
        |body: usize, force: [f64; 2], at: [f64; 2], torque: f64, sign: f64, to: &mut DVector<f64>| {
            let centre = bodies[body].centre.0[0];
            let arm = [at[0] - centre[0], at[1] - centre[1]];
            to[3 * body] += sign * force[0];
            to[3 * body + 1] += sign * force[1];
            to[3 * body + 2] += sign * (arm[0] * force[1] - arm[1] * force[0] + torque);
        };
    for joint in joints {
        let mut column = |first: Option<usize>, second: usize, force, at, torque, weight| {
            let mut own = DVector::zeros(size);
            wrench(second, force, at, torque, 1.0, &mut own);
            if let Some(first) = first {
                wrench(first, force, at, torque, -1.0, &mut own);
            }
            columns.push((own, weight));
        };
        match *joint {
            Joint::Pin(first, second, at) => {
                column(first, second, [1.0, 0.0], at, 0.0, None);
                column(first, second, [0.0, 1.0], at, 0.0, None);
            }
            Joint::Slide(body) => {
                column(None, body, [0.0, 1.0], bodies[body].centre.0[0], 0.0, None);
                column(None, body, [0.0, 0.0], [0.0; 2], 1.0, None);
            }
            Joint::Motor(first, second, weight) => {
                column(first, second, [0.0, 0.0], [0.0; 2], 1.0, Some(weight));
            }
        }
    }
    let mut right = DVector::zeros(size);
    for (k, body) in bodies.iter().enumerate() {
        let [ax, ay] = body.centre.0[2];
        right[3 * k] = body.mass * ax - body.force[0];
        right[3 * k + 1] = body.mass * (ay + 9.81) - body.force[1];
        right[3 * k + 2] = body.inertia * body.angle[2] - body.torque;
    }
    // Least squares of the drives under the equations: Lagrange's multipliers, all in one matrix.
    let unknowns = columns.len();
    let mut matrix = DMatrix::zeros(unknowns + size, unknowns + size);
    for (j, (column, weight)) in columns.iter().enumerate() {
        matrix[(j, j)] = weight.unwrap_or(0.0);
        for i in 0..size {
            matrix[(unknowns + i, j)] = column[i];
            matrix[(j, unknowns + i)] = column[i];
        }
    }
    let mut all = DVector::zeros(unknowns + size);
    all.rows_mut(unknowns, size).copy_from(&right);
    let found = matrix.full_piv_lu().solve(&all).unwrap();
    columns
        .iter()
        .zip(found.iter())
        .filter(|((_, weight), _)| weight.is_some())
        .map(|(_, drive)| *drive)
        .collect()
}
