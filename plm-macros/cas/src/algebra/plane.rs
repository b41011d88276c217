//! Vectors and rotations of the plane.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::node::Expr;

/// A vector by its components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vec2 {
    /// Along the x axis.
    pub x: Expr,
    /// Along the y axis.
    pub y: Expr,
}

impl Vec2 {
    /// (0, 0)
    pub const ZERO: Vec2 = Vec2::new(Expr::ZERO, Expr::ZERO);
    /// (1, 0)
    pub const X: Vec2 = Vec2::new(Expr::ONE, Expr::ZERO);
    /// (0, 1)
    pub const Y: Vec2 = Vec2::new(Expr::ZERO, Expr::ONE);

    /// (x, y)
    pub const fn new(x: Expr, y: Expr) -> Vec2 {
        Vec2 { x, y }
    }

    /// Scalar product.
    pub fn dot(self, other: Vec2) -> Expr {
        self.x * other.x + self.y * other.y
    }

    /// The third component of the cross product.
    pub fn cross(self, other: Vec2) -> Expr {
        self.x * other.y - self.y * other.x
    }

    /// The square of its length.
    pub fn squared(self) -> Expr {
        self.dot(self)
    }

    /// A quarter turn to the left, `J v`.
    #[must_use]
    pub fn left(self) -> Vec2 {
        Vec2::new(-self.y, self.x)
    }

    /// Is it (0, 0)?
    pub fn is_zero(self) -> bool {
        self == Vec2::ZERO
    }

    /// The derivative with respect to an atom.
    #[must_use]
    pub fn diff(self, wrt: Expr) -> Vec2 {
        self.map(|component| component.diff(wrt))
    }

    /// Applies a function to each component.
    #[must_use]
    pub fn map(self, mut of: impl FnMut(Expr) -> Expr) -> Vec2 {
        let x = of(self.x);
        Vec2::new(x, of(self.y))
    }

    /// Atoms `name_x` and `name_y` that stand for the components.
    #[must_use]
    pub fn named(self, name: impl AsRef<str>) -> Vec2 {
        let name = name.as_ref();
        self.named_by([format!("{name}_x"), format!("{name}_y")])
    }

    /// Atoms of these names that stand for the components.
    #[must_use]
    pub fn named_by(self, names: [impl AsRef<str>; 2]) -> Vec2 {
        let [x, y] = names;
        let x = self.x.named(x);
        Vec2::new(x, self.y.named(y))
    }

    /// The components, x first.
    pub const fn components(self) -> [Expr; 2] {
        [self.x, self.y]
    }
}

impl From<[Expr; 2]> for Vec2 {
    fn from([x, y]: [Expr; 2]) -> Vec2 {
        Vec2::new(x, y)
    }
}

impl Add for Vec2 {
    type Output = Vec2;

    fn add(self, other: Vec2) -> Vec2 {
        let x = self.x + other.x;
        Vec2::new(x, self.y + other.y)
    }
}

impl Sub for Vec2 {
    type Output = Vec2;

    fn sub(self, other: Vec2) -> Vec2 {
        let x = self.x - other.x;
        Vec2::new(x, self.y - other.y)
    }
}

impl Neg for Vec2 {
    type Output = Vec2;

    fn neg(self) -> Vec2 {
        let x = -self.x;
        Vec2::new(x, -self.y)
    }
}

impl AddAssign for Vec2 {
    fn add_assign(&mut self, other: Vec2) {
        *self = *self + other;
    }
}

impl SubAssign for Vec2 {
    fn sub_assign(&mut self, other: Vec2) {
        *self = *self - other;
    }
}

impl Sum for Vec2 {
    fn sum<I: Iterator<Item = Vec2>>(vectors: I) -> Vec2 {
        vectors.fold(Vec2::ZERO, Add::add)
    }
}

impl Div<Expr> for Vec2 {
    type Output = Vec2;

    fn div(self, divisor: Expr) -> Vec2 {
        self.map(|component| component / divisor)
    }
}

impl Mul<Vec2> for Expr {
    type Output = Vec2;

    fn mul(self, vector: Vec2) -> Vec2 {
        let x = self * vector.x;
        Vec2::new(x, self * vector.y)
    }
}

/// Multiplication by the complex number `cos + i sin`: a rotation by the angle of this cosine and sine, and, where their
/// squares do not make 1, a scaling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rotation {
    /// The cosine; the scalar product of the unit vectors before and after.
    pub cos: Expr,
    /// The sine; their cross product.
    pub sin: Expr,
}

impl Rotation {
    /// None.
    pub const IDENTITY: Rotation = Rotation { cos: Expr::ONE, sin: Expr::ZERO };

    /// By an angle, rad.
    pub fn by(angle: Expr) -> Rotation {
        let cos = angle.cos();
        Rotation { cos, sin: angle.sin() }
    }

    /// The one that takes the x axis to this vector.
    pub const fn to(axis: Vec2) -> Rotation {
        Rotation { cos: axis.x, sin: axis.y }
    }

    /// The one that takes `from` to `to`, times the square of the length of `from`.
    pub fn between(from: Vec2, to: Vec2) -> Rotation {
        let cos = from.dot(to);
        Rotation { cos, sin: from.cross(to) }
    }

    /// Atoms that stand for the cosine and the sine.
    #[must_use]
    pub fn named(self, cos: impl AsRef<str>, sin: impl AsRef<str>) -> Rotation {
        let cos = self.cos.named(cos);
        Rotation { cos, sin: self.sin.named(sin) }
    }

    /// Image of the unit vector along x: `(cos, sin)`.
    pub const fn axis(self) -> Vec2 {
        Vec2::new(self.cos, self.sin)
    }

    /// The rotation back.
    #[must_use]
    pub fn inverse(self) -> Rotation {
        Rotation { cos: self.cos, sin: -self.sin }
    }
}

impl Mul<Vec2> for Rotation {
    type Output = Vec2;

    fn mul(self, vector: Vec2) -> Vec2 {
        let Rotation { cos, sin } = self;
        let x = cos * vector.x - sin * vector.y;
        Vec2::new(x, sin * vector.x + cos * vector.y)
    }
}

impl Mul for Rotation {
    type Output = Rotation;

    fn mul(self, first: Rotation) -> Rotation {
        Rotation::to(self * first.axis())
    }
}

impl Div<Expr> for Rotation {
    type Output = Rotation;

    fn div(self, divisor: Expr) -> Rotation {
        Rotation::to(self.axis() / divisor)
    }
}
