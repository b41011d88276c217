//! Vectors, rotations and poses in space.

pub(crate) type Vector = [f64; 3];

/// A rotation matrix, by rows; its columns are the axes of the turned frame.
pub(crate) type Matrix = [[f64; 3]; 3];

pub(crate) const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn sub(a: Vector, b: Vector) -> Vector {
    add(a, scaled(b, -1.0))
}

pub(crate) fn scaled(a: Vector, by: f64) -> Vector {
    a.map(|x| x * by)
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The unit vector along `a`; none of one that has no direction.
pub(crate) fn unit(a: Vector) -> Option<Vector> {
    let length = norm(a);
    (length > 1e-12 && length.is_finite()).then(|| scaled(a, 1.0 / length))
}

pub(crate) fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

pub(crate) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

pub(crate) fn turned(a: &Matrix, v: Vector) -> Vector {
    a.map(|row| dot(row, v))
}

/// The tensor `i` of a frame that stands at the rotation `a`, in the outer axes: `a i a^T`.
pub(crate) fn tensor(a: &Matrix, i: &Matrix) -> Matrix {
    product(&product(a, i), &transposed(a))
}

/// The matrix whose columns are these axes.
pub(crate) fn columns(x: Vector, y: Vector, z: Vector) -> Matrix {
    transposed(&[x, y, z])
}

/// Rotation about a unit vector by an angle, rad (Rodrigues).
pub(crate) fn about(axis: Vector, angle: f64) -> Matrix {
    let (sin, cos) = angle.sin_cos();
    let [x, y, z] = axis;
    let skew = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            (if i == j { cos } else { 0.0 }) + sin * skew[i][j] + (1.0 - cos) * axis[i] * axis[j]
        })
    })
}

/// Rotation by roll, pitch and yaw about fixed axes, rad: `Rz Ry Rx`, as URDF and SDF have it.
pub(crate) fn roll_pitch_yaw([roll, pitch, yaw]: Vector) -> Matrix {
    let [x, y, z] = IDENTITY;
    product(&product(&about(z, yaw), &about(y, pitch)), &about(x, roll))
}

/// Rotation of a quaternion `w, x, y, z`, which need not be normalised; none of zero.
pub(crate) fn quaternion([w, x, y, z]: [f64; 4]) -> Option<Matrix> {
    let length = norm([x, y, z]);
    match unit([x, y, z]) {
        Some(axis) => Some(about(axis, 2.0 * length.atan2(w))),
        None => (w != 0.0).then_some(IDENTITY),
    }
}

/// A pose: rotation and place of a frame in an outer one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    pub(crate) turn: Matrix,
    pub(crate) at: Vector,
}

impl Pose {
    pub(crate) const HERE: Pose = Pose { turn: IDENTITY, at: [0.0; 3] };

    /// The pose of `inner`, which is given in this frame, in the outer frame.
    pub(crate) fn of(&self, inner: &Pose) -> Pose {
        Pose { turn: product(&self.turn, &inner.turn), at: self.point(inner.at) }
    }

    pub(crate) fn point(&self, at: Vector) -> Vector {
        add(turned(&self.turn, at), self.at)
    }

    pub(crate) fn inverse(&self) -> Pose {
        let turn = transposed(&self.turn);
        Pose { turn, at: scaled(turned(&turn, self.at), -1.0) }
    }
}
