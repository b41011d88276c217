//! Dyads of three, four and five poses.

use nalgebra::{Matrix2, Matrix4, SMatrix, Vector2, Vector4};

use super::{BodyPose, Displacement, displacements, frame, scaled};
use crate::synthesis::four_bar::{Point, Vector, point, unit, vector};
use crate::synthesis::numbers::{ITERATIONS, first_without};
use crate::synthesis::roots::real_roots;

/// Dyad that guides a body: a bar between the ground and the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dyad {
    /// Pivot on the ground, m.
    pub centre: Point,
    /// Pin on the body, m, where it is at the first pose.
    pub circle: Point,
    /// Length of the bar, m.
    pub length: f64,
}

impl Dyad {
    fn of(centre: Vector, circle: Vector, (middle, extent): (Vector, f64)) -> Self {
        let back = |z: Vector| z * extent + middle;
        let (centre, circle) = (back(centre), back(circle));
        Self { centre: point(centre), circle: point(circle), length: (circle - centre).norm() }
    }

    /// Deviation of the pin's distance from the pivot at each pose, m.
    pub fn deviations(&self, poses: &[BodyPose]) -> Vec<f64> {
        let (centre, circle) = (vector(self.centre), vector(self.circle));
        let distance = |displacement: Displacement| (displacement.of(circle) - centre).norm();
        displacements(poses).into_iter().map(|d| distance(d) - self.length).collect()
    }
}

/// Why there are no dyads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoDyads {
    /// The call takes another number of poses.
    Count {
        /// Poses that it takes.
        needed: usize,
        /// Poses that were given.
        given: usize,
    },
    /// The poses leave a family of dyads, as with a pose twice or with translations alone.
    Dependent,
    /// A place or the angle of this pose, from 0, is no finite number.
    NoNumber {
        /// The pose.
        pose: usize,
    },
    /// The point that was given has a coordinate that is no finite number.
    Point,
}

impl std::fmt::Display for NoDyads {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Count { needed, given } => write!(f, "{needed} poses are needed, {given} were given"),
            Self::Dependent => f.write_str("the poses leave a family of dyads"),
            Self::NoNumber { pose } => write!(f, "a number of pose {pose}, counted from 0, is none"),
            Self::Point => f.write_str("a coordinate of the point is no number"),
        }
    }
}

impl std::error::Error for NoDyads {}

/// All real dyads of five poses: at most four.
///
/// The equations of equal distances are linear in the seven monomials G·W, G×W, G, W, 1. Their null space is of three dimensions, and the
/// monomials of a dyad satisfy two quadratic relations there. The two conics meet in four points, which are roots of a quartic; each
/// real one is improved by Newton's iteration on the four equations in G and W.
///
/// # Errors
/// [`NoDyads`].
pub fn five_pose_dyads(poses: &[BodyPose]) -> Result<Vec<Dyad>, NoDyads> {
    require(poses, 5)?;
    let frame = frame(poses);
    let displacements = displacements(&scaled(poses, frame));
    let basis = null_space(&displacements)?;
    let mut found: Vec<(Vector, Vector)> = Vec::new();
    for weights in meeting_points(&basis) {
        let Some((centre, circle)) = pair(&basis, weights).and_then(|start| newton(&displacements, start))
        else {
            continue;
        };
        let is_known = |&(g, w): &(Vector, Vector)| {
            (g - centre).norm() + (w - circle).norm() < 1e-7 * (1.0 + centre.norm() + circle.norm())
        };
        if !found.iter().any(is_known) {
            found.push((centre, circle));
        }
    }
    let mut dyads: Vec<Dyad> = found.into_iter().map(|(g, w)| Dyad::of(g, w, frame)).collect();
    dyads.sort_by(|a, b| a.centre[0].total_cmp(&b.centre[0]).then(a.centre[1].total_cmp(&b.centre[1])));
    Ok(dyads)
}

fn require(poses: &[BodyPose], needed: usize) -> Result<(), NoDyads> {
    if poses.len() != needed {
        return Err(NoDyads::Count { needed, given: poses.len() });
    }
    let numbers = poses.iter().map(|BodyPose { place: [x, y], angle }| [*x, *y, *angle]);
    first_without(numbers).map_or(Ok(()), |pose| Err(NoDyads::NoNumber { pose }))
}

fn require_point(own: Point) -> Result<(), NoDyads> {
    if own.iter().all(|number| number.is_finite()) { Ok(()) } else { Err(NoDyads::Point) }
}

/// Null space of the equations in the monomials G·W, G×W, Gx, Gy, Wx, Wy, 1, with G×W = Gx Wy - Gy Wx.
fn null_space(displacements: &[Displacement]) -> Result<[[f64; 7]; 3], NoDyads> {
    // Rows of zeros make the decomposition give the null space too.
    let mut matrix = SMatrix::<f64, 7, 7>::zeros();
    for (row, Displacement { turn, shift }) in displacements.iter().enumerate() {
        // G·A W = cos G·W - sin G×W.
        let back = turn.conj() * shift;
        let half = 0.5 * shift.norm_sqr();
        let terms = [turn.re - 1.0, -turn.im, shift.re, shift.im, -back.re, -back.im, -half];
        for (column, term) in terms.into_iter().enumerate() {
            matrix[(row, column)] = term;
        }
    }
    let decomposed = matrix.try_svd(false, true, f64::EPSILON, ITERATIONS).ok_or(NoDyads::Dependent)?;
    let values = decomposed.singular_values;
    if values[3] <= 1e-10 * values[0] {
        return Err(NoDyads::Dependent);
    }
    let rows = decomposed.v_t.ok_or(NoDyads::Dependent)?;
    Ok(std::array::from_fn(|k| std::array::from_fn(|column| rows[(4 + k, column)])))
}

/// Quadratic form of three weights: coefficients of a^2, ab, b^2, ac, bc, c^2.
type Conic = [f64; 6];

/// Product of two linear forms of the weights.
fn product(p: [f64; 3], q: [f64; 3]) -> Conic {
    [
        p[0] * q[0],
        p[0] * q[1] + p[1] * q[0],
        p[1] * q[1],
        p[0] * q[2] + p[2] * q[0],
        p[1] * q[2] + p[2] * q[1],
        p[2] * q[2],
    ]
}

/// Weights of the basis at which both conics are zero: `G·W 1 = Gx Wx + Gy Wy` and `G×W 1 = Gx Wy - Gy Wx`.
///
/// With c = 1 each conic is a quadratic in a, whose coefficients are polynomials in b; Sylvester's resultant is a quartic in b. A dyad
/// whose c is zero is found with the weights in another order.
fn meeting_points(basis: &[[f64; 7]; 3]) -> Vec<[f64; 3]> {
    let mut found = Vec::new();
    for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        let form = |monomial: usize| order.map(|k: usize| basis[k][monomial]);
        let difference = |p: Conic, q: Conic| -> Conic { std::array::from_fn(|k| p[k] - q[k]) };
        let sum = |p: Conic, q: Conic| -> Conic { std::array::from_fn(|k| p[k] + q[k]) };
        let [dot, cross, gx, gy, wx, wy, one] = std::array::from_fn(form);
        let first = difference(product(dot, one), sum(product(gx, wx), product(gy, wy)));
        let second = difference(product(cross, one), difference(product(gx, wy), product(gy, wx)));
        for b in real_roots(&resultant(&first, &second)) {
            // Both quadratics in a; their common root is that of their difference without a^2.
            let at = |q: &Conic| [q[0], q[1] * b + q[3], (q[2] * b + q[4]) * b + q[5]];
            let (p, q) = (at(&first), at(&second));
            let a = -(p[2] * q[0] - q[2] * p[0]) / (p[1] * q[0] - q[1] * p[0]);
            let mut weights = [0.0; 3];
            for (k, value) in order.into_iter().zip([a, b, 1.0]) {
                weights[k] = value;
            }
            found.push(weights);
        }
    }
    found
}

/// Resultant of two conics with c = 1, by a: a quartic in b, from the constant coefficient on.
fn resultant(p: &Conic, q: &Conic) -> [f64; 5] {
    type Polynomial = [f64; 5];
    let times = |x: &Polynomial, y: &Polynomial| -> Polynomial {
        std::array::from_fn(|n| (0..=n).map(|k| x[k] * y[n - k]).sum())
    };
    let minus = |x: &Polynomial, y: &Polynomial| -> Polynomial { std::array::from_fn(|k| x[k] - y[k]) };
    let parts = |c: &Conic| -> [Polynomial; 3] {
        [[c[0], 0.0, 0.0, 0.0, 0.0], [c[3], c[1], 0.0, 0.0, 0.0], [c[5], c[4], c[2], 0.0, 0.0]]
    };
    let ([a1, b1, c1], [a2, b2, c2]) = (parts(p), parts(q));
    // (a1 c2 - a2 c1)^2 - (a1 b2 - a2 b1)(b1 c2 - b2 c1)
    let ac = minus(&times(&a1, &c2), &times(&a2, &c1));
    let ab = minus(&times(&a1, &b2), &times(&a2, &b1));
    let bc = minus(&times(&b1, &c2), &times(&b2, &c1));
    minus(&times(&ac, &ac), &times(&ab, &bc))
}

/// The dyad of weights. `None` for one at infinity: a slider.
fn pair(basis: &[[f64; 7]; 3], weights: [f64; 3]) -> Option<(Vector, Vector)> {
    let monomial = |k: usize| (0..3).map(|n| weights[n] * basis[n][k]).sum::<f64>();
    let one = monomial(6);
    let size = (0..7).map(monomial).fold(0.0, |size: f64, m| size.max(m.abs()));
    let scaled = |k: usize| monomial(k) / one;
    (one.abs() > 1e-9 * size).then(|| (Vector::new(scaled(2), scaled(3)), Vector::new(scaled(4), scaled(5))))
}

/// Newton's iteration on the four equations of five poses. `None` where it finds none next to its start.
fn newton(displacements: &[Displacement], start: (Vector, Vector)) -> Option<(Vector, Vector)> {
    let (mut centre, mut circle) = start;
    for _ in 0..30 {
        let mut jacobian = Matrix4::zeros();
        let mut residual = Vector4::zeros();
        for (row, displacement) in displacements.iter().enumerate() {
            let Displacement { turn, shift } = displacement;
            let [x, y, _] = displacement.centre_row(circle);
            let by_circle = turn.conj() * centre - centre - turn.conj() * shift;
            jacobian.set_row(row, &Vector4::new(x, y, by_circle.re, by_circle.im).transpose());
            residual[row] = displacement.residual(centre, circle);
        }
        let step = jacobian.lu().solve(&residual)?;
        centre -= Vector::new(step[0], step[1]);
        circle -= Vector::new(step[2], step[3]);
        let size = 1.0 + centre.norm() + circle.norm();
        if !size.is_finite() {
            return None;
        }
        if step.norm() <= 1e-14 * size {
            break;
        }
    }
    let size = 1.0 + centre.norm() + circle.norm();
    let worst = displacements.iter().map(|d| d.residual(centre, circle).abs()).fold(0.0, f64::max);
    (worst <= 1e-11 * size * size).then_some((centre, circle))
}

/// Centre point of a circle point of three poses: the pin lies at the first pose at a point, m, the pivot is the centre of the circle
/// through its places. `None` where they lie on a line.
///
/// # Errors
/// [`NoDyads`].
pub fn centre_point(poses: &[BodyPose], circle: Point) -> Result<Option<Dyad>, NoDyads> {
    require(poses, 3)?;
    require_point(circle)?;
    let circle = vector(circle);
    let rows: Vec<[f64; 3]> = displacements(poses).iter().map(|d| d.centre_row(circle)).collect();
    let unscaled = (Vector::new(0.0, 0.0), 1.0);
    Ok(solve(rows[0], rows[1]).map(|centre| Dyad::of(centre, circle, unscaled)))
}

/// Circle point of a centre point of three poses: the pin of a bar that turns about a given pivot, m. `None` where the pivot's places,
/// seen from the body, lie on a line.
///
/// # Errors
/// [`NoDyads`].
pub fn circle_point(poses: &[BodyPose], centre: Point) -> Result<Option<Dyad>, NoDyads> {
    require(poses, 3)?;
    require_point(centre)?;
    let centre = vector(centre);
    let row = |d: &Displacement| {
        // Relative to the body, the ground makes the inverse motion.
        let inverse = Displacement { turn: d.turn.conj(), shift: -(d.turn.conj() * d.shift) };
        inverse.centre_row(centre)
    };
    let rows: Vec<[f64; 3]> = displacements(poses).iter().map(row).collect();
    let unscaled = (Vector::new(0.0, 0.0), 1.0);
    Ok(solve(rows[0], rows[1]).map(|circle| Dyad::of(centre, circle, unscaled)))
}

fn solve(first: [f64; 3], second: [f64; 3]) -> Option<Vector> {
    let matrix = Matrix2::new(first[0], first[1], second[0], second[1]);
    let (scale, determinant) = (matrix.norm_squared(), matrix.determinant());
    if determinant.abs() <= 1e-13 * scale {
        return None;
    }
    matrix.lu().solve(&Vector2::new(first[2], second[2])).map(|x| Vector::new(x[0], x[1]))
}

/// Point of Burmester's curves: a dyad of four poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// The dyad: its centre is on the centre-point curve, its circle point on the circle-point curve.
    pub dyad: Dyad,
    /// Angle of the line on which the circle point was found, rad.
    pub line: f64,
}

/// Burmester's curves of four poses: the circle points on so many lines through a point of the body at the first pose, m, up to three on
/// each, with their centre points. The circle-point curve is a cubic; on a line it is a polynomial in the distance.
///
/// # Errors
/// [`NoDyads`].
pub fn burmester_curves(
    poses: &[BodyPose],
    through: Point,
    lines: usize,
) -> Result<Vec<CurvePoint>, NoDyads> {
    require(poses, 4)?;
    require_point(through)?;
    let frame = frame(poses);
    let displacements = displacements(&scaled(poses, frame));
    let through = (vector(through) - frame.0) / frame.1;
    let mut found = Vec::new();
    for k in 0..lines {
        let line = std::f64::consts::PI * k as f64 / lines as f64;
        for distance in real_roots(&cubic(&displacements, through, unit(line))) {
            let circle = through + unit(line) * distance;
            if let Some(centre) = centre_of_four(&displacements, circle) {
                found.push(CurvePoint { dyad: Dyad::of(centre, circle, frame), line });
            }
        }
    }
    Ok(found)
}

/// Determinant of the three rows of a circle point on a line: a cubic in the distance, from its values at four distances.
fn cubic(displacements: &[Displacement], through: Vector, direction: Vector) -> [f64; 4] {
    let value = |distance: f64| {
        let rows = displacements.iter().map(|d| d.centre_row(through + direction * distance));
        let mut matrix = nalgebra::Matrix3::zeros();
        for (k, row) in rows.enumerate() {
            matrix.set_row(k, &nalgebra::RowVector3::from(row));
        }
        matrix.determinant()
    };
    // Values at -1, 0, 1, 2.
    let [m, z, p, t] = [-1.0, 0.0, 1.0, 2.0].map(value);
    let second = 0.5 * (p + m) - z;
    let third = (t - z - 4.0 * second - (p - m)) / 6.0;
    [z, 0.5 * (p - m) - third, second, third]
}

/// Centre of a circle point of four poses: of the three pairs of rows the best conditioned one.
fn centre_of_four(displacements: &[Displacement], circle: Vector) -> Option<Vector> {
    let rows: Vec<[f64; 3]> = displacements.iter().map(|d| d.centre_row(circle)).collect();
    let health = |&(i, j): &(usize, usize)| (rows[i][0] * rows[j][1] - rows[i][1] * rows[j][0]).abs();
    let best = [(0, 1), (0, 2), (1, 2)].into_iter().max_by(|a, b| health(a).total_cmp(&health(b)))?;
    solve(rows[best.0], rows[best.1])
}
