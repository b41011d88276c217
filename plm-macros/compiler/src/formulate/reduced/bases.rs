//! Classes of bodies by a vector that turns with them, and what such vectors make with each other.
//!
//! A dyad finds the vector along a link, not the cosine and the sine of an angle: that vector is as good a base as the unit
//! vector is, and its products with others are those that velocities, accelerations and masses are made of. Complex numbers
//! tell how: a vector of the class is its base times a constant `v`, and
//! `conj(a u) b w = (conj(a) b) (conj(u) w)` holds the scalar product of two vectors and their cross product.

use std::collections::BTreeMap;

use plm_cas::Expr;

use super::chain::Chain;
use super::motion::Motion;
use super::plane::{self, Vec2};

/// A vector that turns with a class.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Base {
    /// In absolute axes.
    pub(crate) vector: Vec2,
    /// In the axes of the class; constant.
    pub(crate) own: Vec2,
    /// The square of its length.
    pub(crate) square: Expr,
}

/// What is known of the classes' bases.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bases {
    /// By class; of the others the unit vector is the base.
    of_class: BTreeMap<usize, Base>,
    /// Scalar and cross product of two bases.
    products: BTreeMap<(usize, usize), Vec2>,
}

impl Bases {
    /// Makes the vector of a loop that turns with a class the base, if nothing slides along it.
    pub(crate) fn insert_arm(&mut self, chain: &Chain, class: usize, base: Base) {
        if chain.of_class(class).all(|(slide, _)| slide.is_none()) {
            self.of_class.insert(class, base);
        }
    }

    /// Scalar and cross product of the bases of two classes are these.
    pub(crate) fn insert_products(&mut self, classes: (usize, usize), products: Vec2) {
        self.products.insert(classes, products);
    }
}

impl Motion {
    /// A vector in the axes of a class over the class's base.
    pub(crate) fn over_base(&self, class: usize, vector: Vec2) -> Vec2 {
        let Some(base) = self.bases.of_class.get(&class) else { return vector };
        let products = [plane::dot(base.own, vector), plane::cross(base.own, vector)];
        products.map(|product| product / base.square)
    }

    /// A vector in the axes of a class, in absolute axes.
    pub(crate) fn turned(&self, class: usize, vector: Vec2) -> Vec2 {
        let vector = self.over_base(class, vector);
        plane::turn(self.base(class), vector)
    }

    /// Scalar and cross product of two vectors over the bases of their classes.
    pub(crate) fn products(&self, (a, u): (usize, Vec2), (b, w): (usize, Vec2)) -> Vec2 {
        let constant = [plane::dot(u, w), plane::cross(u, w)];
        let bases = self.products_of_bases(a, b);
        plane::turn(bases, constant)
    }

    /// Scalar and cross product of the bases of two classes.
    pub(crate) fn products_of_bases(&self, a: usize, b: usize) -> Vec2 {
        if a == b {
            let square = self.bases.of_class.get(&a).map_or(Expr::ONE, |base| base.square);
            return [square, Expr::ZERO];
        }
        let Bases { products, .. } = &self.bases;
        if let Some(&[dot, cross]) = products.get(&(b, a)) {
            return [dot, -cross];
        }
        products.get(&(a, b)).copied().unwrap_or_else(|| {
            let (a, b) = (self.base(a), self.base(b));
            [plane::dot(a, b), plane::cross(a, b)]
        })
    }

    fn base(&self, class: usize) -> Vec2 {
        self.bases.of_class.get(&class).map_or(self.axis[class], |base| base.vector)
    }
}
