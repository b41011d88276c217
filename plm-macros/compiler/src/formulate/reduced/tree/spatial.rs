//! Planar spatial vectors: two components of a plane vector and one about the axis across the plane (R. Featherstone, Rigid
//! Body Dynamics Algorithms, 2008, section 2.16: planar vectors).

use crate::collect::MapEach;
use std::ops::{Add, Mul, Neg, Sub};

use plm_cas::{Expr, Vec2, algebra};

/// A motion (acceleration of a point, angular acceleration) or a wrench (force, moment about that point).
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Spatial(pub(super) [Expr; 3]);

/// A symmetric map from motions to wrenches: what a body, with all that hangs on it, answers.
#[derive(Clone, Copy)]
pub(crate) struct Inertia([[Expr; 3]; 3]);

impl Spatial {
    pub(crate) const ZERO: Spatial = Spatial([Expr::ZERO; 3]);
    /// About the axis across the plane.
    pub(crate) const ABOUT: Spatial = Spatial([Expr::ZERO, Expr::ZERO, Expr::ONE]);

    pub(crate) fn new(plane: Vec2, about: Expr) -> Spatial {
        Spatial([plane.x, plane.y, about])
    }

    pub(crate) fn plane(self) -> Vec2 {
        Vec2::new(self.0[0], self.0[1])
    }

    pub(crate) fn about(self) -> Expr {
        self.0[2]
    }

    pub(crate) fn dot(self, other: Spatial) -> Expr {
        let products = [0, 1, 2].map_each(|i| self.0[i] * other.0[i]);
        algebra::sum(&products)
    }

    /// The axis that it lies along, if it does.
    pub(crate) fn axis(self) -> Option<usize> {
        let mut along = (0..3).filter(|&i| !self.0[i].is_zero());
        let first = along.next()?;
        along.next().is_none().then_some(first)
    }
}

impl Add for Spatial {
    type Output = Spatial;

    fn add(self, other: Spatial) -> Spatial {
        Spatial([0, 1, 2].map_each(|i| self.0[i] + other.0[i]))
    }
}

impl Sub for Spatial {
    type Output = Spatial;

    fn sub(self, other: Spatial) -> Spatial {
        Spatial([0, 1, 2].map_each(|i| self.0[i] - other.0[i]))
    }
}

impl Neg for Spatial {
    type Output = Spatial;

    fn neg(self) -> Spatial {
        Spatial(self.0.map_each(|component| -component))
    }
}

impl Mul<Spatial> for Expr {
    type Output = Spatial;

    fn mul(self, vector: Spatial) -> Spatial {
        Spatial(vector.0.map_each(|component| self * component))
    }
}

impl Inertia {
    /// By its block of the plane, the column that couples it with the third component, and the entry there.
    pub(crate) fn new([xx, xy, yy]: [Expr; 3], coupling: Vec2, about: Expr) -> Inertia {
        let Vec2 { x, y } = coupling;
        Inertia([[xx, xy, x], [xy, yy, y], [x, y, about]])
    }

    /// `xx`, `xy` and `yy`.
    pub(crate) fn plane(self) -> [Expr; 3] {
        let [[xx, xy, _], [_, yy, _], _] = self.0;
        [xx, xy, yy]
    }

    /// With other entries `xx`, `xy` and `yy`.
    #[must_use]
    pub(crate) fn with_plane(self, plane: [Expr; 3]) -> Inertia {
        let [[.., x], [.., y], [.., about]] = self.0;
        Inertia::new(plane, Vec2::new(x, y), about)
    }

    /// Less `a b^T`, which is symmetric.
    #[must_use]
    pub(crate) fn less_outer(self, a: Spatial, b: Spatial) -> Inertia {
        let mut left = self;
        for i in 0..3 {
            for j in 0..=i {
                let entry = self.0[i][j] - a.0[i] * b.0[j];
                (left.0[i][j], left.0[j][i]) = (entry, entry);
            }
        }
        left
    }

    /// Without the row and the column of an axis.
    #[must_use]
    pub(crate) fn without(mut self, axis: usize) -> Inertia {
        for j in 0..3 {
            (self.0[axis][j], self.0[j][axis]) = (Expr::ZERO, Expr::ZERO);
        }
        self
    }
}

impl Add for Inertia {
    type Output = Inertia;

    fn add(self, other: Inertia) -> Inertia {
        Inertia([0, 1, 2].map_each(|i| (Spatial(self.0[i]) + Spatial(other.0[i])).0))
    }
}

impl Mul<Spatial> for Inertia {
    type Output = Spatial;

    fn mul(self, motion: Spatial) -> Spatial {
        Spatial(self.0.map_each(|row| Spatial(row).dot(motion)))
    }
}
