//! Operations on lists of expressions of the present graph.

use super::with;
use crate::graph::Graph;
use crate::node::Expr;
use crate::share::share;
use crate::tape::{Count, Tape};

/// The sum of all; 0 for none.
pub fn sum(terms: &[Expr]) -> Expr {
    with(|graph| graph.sum(terms))
}

/// The product of all; 1 for none.
pub fn product(factors: &[Expr]) -> Expr {
    with(|graph| graph.product(factors))
}

/// The scalar product of two lists.
pub fn dot(a: &[Expr], b: &[Expr]) -> Expr {
    a.iter().zip(b).map(|(&a, &b)| a * b).sum()
}

/// With the second of each pair in the place of the first; see [`Graph::substitute`].
pub fn substitute(roots: &[Expr], pairs: &[(Expr, Expr)]) -> Vec<Expr> {
    with(|graph| graph.substitute(roots, pairs))
}

/// The non-zero entries of a gradient; see [`Graph::gradient`].
pub fn gradient(e: Expr, wrt: &[Expr]) -> Vec<(usize, Expr)> {
    with(|graph| graph.gradient(e, wrt))
}

/// Derivatives along a direction; see [`Graph::directionals`].
pub fn directionals(roots: &[Expr], along: &[(Expr, Expr)]) -> Vec<Expr> {
    with(|graph| graph.directionals(roots, along))
}

/// The symbols that some expressions hold; see [`Graph::symbols`].
pub fn symbols(roots: &[Expr]) -> Vec<Expr> {
    with(|graph| graph.symbols(roots))
}

/// The nodes at and below some expressions; see [`Graph::reachable`].
pub fn reachable(roots: &[Expr]) -> Vec<Expr> {
    with(|graph| graph.reachable(roots))
}

/// Expressions of another graph in the present one; see [`Graph::import`].
pub fn import(from: &Graph, roots: &[Expr]) -> Vec<Expr> {
    with(|graph| graph.import(from, roots))
}

/// Equal values with their common subexpressions shared; see [`share`](crate::share()).
pub fn shared(roots: &[Expr]) -> Vec<Expr> {
    with(|graph| share(graph, roots))
}

/// The list of operations that computes some expressions; see [`Tape`].
pub fn tape(roots: &[Expr]) -> Tape {
    with(|graph| Tape::new(graph, roots))
}

/// How many operations that takes.
pub fn count(roots: &[Expr]) -> Count {
    tape(roots).count()
}
