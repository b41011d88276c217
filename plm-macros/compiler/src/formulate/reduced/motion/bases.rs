//! Orientations of bodies by a vector that turns with them, and what such vectors make with each other.
//!
//! A dyad finds the vector along a bar, not the cosine and the sine of an angle: that vector is as good a base as the unit
//! vector is, and its products with others are those that velocities, accelerations and masses are made of. Complex numbers
//! tell how: a vector of the orientation is its base times a constant `v`, and
//! `conj(a u) b w = (conj(a) b) (conj(u) w)` holds the scalar product of two vectors and their cross product.

use crate::sorted::SortedMap;
use std::ops::{Add, Neg};

use plm_cas::{Expr, Rotation, Vec2};

use crate::formulate::reduced::joints::chain::Chain;

/// A vector that turns with an orientation.
#[derive(Clone, Copy)]
pub(crate) struct Base {
    /// In absolute axes.
    pub(crate) vector: Vec2,
    /// In the axes of the orientation; constant.
    pub(crate) own: Vec2,
    /// The square of its length.
    pub(crate) square: Expr,
}

/// Scalar and cross product of two vectors, `conj(a) b`.
#[derive(Clone, Copy)]
pub(crate) struct Products {
    pub(crate) dot: Expr,
    pub(crate) cross: Expr,
}

impl Products {
    pub(crate) fn of(a: Vec2, b: Vec2) -> Products {
        let dot = a.dot(b);
        Products { dot, cross: a.cross(b) }
    }

    /// Those of the second vector with the first.
    fn swapped(self) -> Products {
        Products { dot: self.dot, cross: -self.cross }
    }

    /// Those of the first vector with the second one turned and scaled by `by`.
    pub(crate) fn turned(self, by: Rotation) -> Products {
        let Vec2 { x: dot, y: cross } = by * Vec2::new(self.dot, self.cross);
        Products { dot, cross }
    }

    /// Atoms that stand for both.
    pub(crate) fn named(self, name: &str) -> Products {
        let dot = self.dot.named(format!("dot_{name}"));
        Products { dot, cross: self.cross.named(format!("cross_{name}")) }
    }
}

impl Add for Products {
    type Output = Products;

    fn add(self, other: Products) -> Products {
        let dot = self.dot + other.dot;
        Products { dot, cross: self.cross + other.cross }
    }
}

impl Neg for Products {
    type Output = Products;

    fn neg(self) -> Products {
        let dot = -self.dot;
        Products { dot, cross: -self.cross }
    }
}

/// Bases of the orientations.
#[derive(Clone, Default)]
pub(crate) struct Bases {
    /// By orientation; of the others the unit vector is the base.
    of_orientation: SortedMap<usize, Base>,
    /// Of two bases.
    products: SortedMap<(usize, usize), Products>,
}

impl Bases {
    /// Makes the vector of a loop that turns with an orientation the base, if nothing slides along it.
    pub(crate) fn insert_arm(&mut self, chain: &Chain, orientation: usize, base: Base) {
        if chain.of_orientation(orientation).all(|(displacement, _)| displacement.is_none()) {
            self.of_orientation.insert(orientation, base);
        }
    }

    /// The products of the bases of two orientations are these.
    pub(crate) fn insert_products(&mut self, orientations: (usize, usize), products: Products) {
        self.products.insert(orientations, products);
    }
}

impl Bases {
    /// The base of an orientation, if it is not the unit vector.
    pub(crate) fn of_orientation(&self, orientation: usize) -> Option<&Base> {
        self.of_orientation.get(&orientation)
    }

    /// The products of the bases of two orientations, if they were found otherwise than from the vectors.
    pub(crate) fn products(&self, a: usize, b: usize) -> Option<Products> {
        let swapped = self.products.get(&(b, a)).copied().map(Products::swapped);
        swapped.or_else(|| self.products.get(&(a, b)).copied())
    }
}
