//! The constructors: canonical forms, kept while an expression is made.

mod call;
mod product;
mod sum;
mod trigonometry;

use crate::graph::Graph;
use crate::node::Expr;
use crate::number::Number;

impl Graph {
    /// `a + b`.
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        self.linear(Number::ZERO, &[(Number::ONE, a), (Number::ONE, b)])
    }

    /// `a - b`.
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        self.linear(Number::ZERO, &[(Number::ONE, a), (Number::MINUS_ONE, b)])
    }

    /// `-a`.
    pub fn neg(&mut self, a: Expr) -> Expr {
        self.scale(Number::MINUS_ONE, a)
    }

    /// The sum of all; 0 for none.
    pub fn sum(&mut self, terms: &[Expr]) -> Expr {
        let terms: Vec<_> = terms.iter().map(|&term| (Number::ONE, term)).collect();
        self.linear(Number::ZERO, &terms)
    }

    /// `a * b`.
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        match (self.as_number(a), self.as_number(b)) {
            // Most products of sparse matrices.
            (Some(zero), _) | (_, Some(zero)) if zero.is_zero() => self.zero(),
            (Some(one), _) if one.is_one() => b,
            (_, Some(one)) if one.is_one() => a,
            _ => self.monomial(Number::ONE, &[(a, 1), (b, 1)]),
        }
    }

    /// The product of all; 1 for none.
    pub fn product(&mut self, factors: &[Expr]) -> Expr {
        let factors: Vec<_> = factors.iter().map(|&factor| (factor, 1)).collect();
        self.monomial(Number::ONE, &factors)
    }

    /// `a / b`. A zero `b` stays in the result as `0^-1`.
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        self.monomial(Number::ONE, &[(a, 1), (b, -1)])
    }

    /// `1 / a`.
    pub fn recip(&mut self, a: Expr) -> Expr {
        self.powi(a, -1)
    }

    /// `a^exponent`; `a^0` is 1.
    pub fn powi(&mut self, a: Expr, exponent: i32) -> Expr {
        self.monomial(Number::ONE, &[(a, exponent)])
    }
}
