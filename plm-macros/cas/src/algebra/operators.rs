//! `+ - * /` of expressions, with integers on either side.

use core::iter::{Product, Sum};
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use super::with;
use crate::graph::Graph;
use crate::node::Expr;

macro_rules! operator {
    ($trait:ident, $operation:ident) => {
        impl $trait for Expr {
            type Output = Expr;

            fn $operation(self, other: Expr) -> Expr {
                with(|graph| Graph::$operation(graph, self, other))
            }
        }

        impl $trait<i32> for Expr {
            type Output = Expr;

            fn $operation(self, other: i32) -> Expr {
                $trait::$operation(self, Expr::from(other))
            }
        }

        impl $trait<Expr> for i32 {
            type Output = Expr;

            fn $operation(self, other: Expr) -> Expr {
                $trait::$operation(Expr::from(self), other)
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Expr {
    type Output = Expr;

    fn neg(self) -> Expr {
        with(|graph| Graph::neg(graph, self))
    }
}

impl AddAssign for Expr {
    fn add_assign(&mut self, other: Expr) {
        *self = *self + other;
    }
}

impl SubAssign for Expr {
    fn sub_assign(&mut self, other: Expr) {
        *self = *self - other;
    }
}

impl MulAssign for Expr {
    fn mul_assign(&mut self, other: Expr) {
        *self = *self * other;
    }
}

impl Sum for Expr {
    /// All terms at once: partial sums leave nothing behind.
    fn sum<I: Iterator<Item = Expr>>(terms: I) -> Expr {
        let terms: Vec<Expr> = terms.collect();
        with(|graph| Graph::sum(graph, &terms))
    }
}

impl<'a> Sum<&'a Expr> for Expr {
    fn sum<I: Iterator<Item = &'a Expr>>(terms: I) -> Expr {
        terms.copied().sum()
    }
}

impl Product for Expr {
    /// All factors at once.
    fn product<I: Iterator<Item = Expr>>(factors: I) -> Expr {
        let factors: Vec<Expr> = factors.collect();
        with(|graph| Graph::product(graph, &factors))
    }
}
