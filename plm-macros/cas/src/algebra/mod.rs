//! Expressions with operators, so that a formula stands in code as in its source.
//!
//! An [`Expr`] is an index; what it means stands in a graph. Operators write into the *present graph* of the thread, as the
//! compiler's own names do in rustc: with `x * y + 2` there is no place for another argument. [`Graph::enter`] makes a graph
//! the present one for as long as some work takes; every compilation enters a graph of its own, so that what came before
//! it on the same thread changes nothing. Outside of any, a thread has an empty one.
//!
//! Each operation is the constructor of the same name of [`Graph`], and makes the same nodes in the same order.

mod lists;
mod operators;
mod plane;

use core::cell::RefCell;

use crate::graph::Graph;
use crate::node::{Expr, Function, Node};
use crate::number::Number;

pub use lists::{
    count, directionals, dot, gradient, import, product, reachable, shared, substitute, sum, symbols, tape,
};
pub use plane::{Rotation, Vec2};

thread_local! {
    static PRESENT: RefCell<Graph> = RefCell::new(Graph::new());
}

/// Works on the present graph.
pub(crate) fn with<T>(work: impl FnOnce(&mut Graph) -> T) -> T {
    PRESENT.with_borrow_mut(work)
}

impl Graph {
    /// Does some work with this graph as the present one of the thread; the one before it comes back afterwards, in a panic too.
    ///
    /// ```
    /// use plm_cas::{Expr, Graph};
    ///
    /// let mut graph = Graph::new();
    /// let square = graph.enter(|| {
    ///     let x = Expr::symbol("x");
    ///     (x * x - 1) / 2
    /// });
    /// assert_eq!(graph.display(square).to_string(), "0.5*(x^2 - 1)");
    /// ```
    pub fn enter<T>(&mut self, work: impl FnOnce() -> T) -> T {
        let _entered = Entered::new(self);
        work()
    }
}

/// A graph that has changed places with the present one of the thread.
struct Entered<'a> {
    before: &'a mut Graph,
}

impl<'a> Entered<'a> {
    fn new(graph: &'a mut Graph) -> Self {
        with(|present| core::mem::swap(present, graph));
        Self { before: graph }
    }
}

impl Drop for Entered<'_> {
    fn drop(&mut self) {
        with(|present| core::mem::swap(present, self.before));
    }
}

impl Expr {
    /// 0, in every graph.
    pub const ZERO: Expr = Expr(0);
    /// 1, in every graph.
    pub const ONE: Expr = Expr(1);

    /// A new atom, different from all others, whatever their names.
    pub fn symbol(name: impl AsRef<str>) -> Expr {
        with(|graph| graph.symbol(name.as_ref()))
    }

    /// Pi, exact.
    pub fn pi() -> Expr {
        with(Graph::pi)
    }

    /// An atom that stands for this value; see [`Graph::define`].
    #[must_use]
    pub fn named(self, name: impl AsRef<str>) -> Expr {
        with(|graph| graph.define(name.as_ref(), self))
    }

    /// Is it the constant 0?
    pub fn is_zero(self) -> bool {
        self == Expr::ZERO
    }

    /// The constant that it is, if it is one.
    pub fn as_number(self) -> Option<Number> {
        with(|graph| graph.as_number(self))
    }

    /// The operation that it is.
    pub fn node(self) -> Node {
        with(|graph| graph.node(self).clone())
    }

    /// A name for emission; see [`Graph::hint`].
    pub fn hint(self, name: &str) {
        with(|graph| graph.hint(self, name));
    }

    /// Its name, if it has one.
    pub fn name(self) -> Option<String> {
        with(|graph| graph.name(self).map(str::to_owned))
    }

    /// `1 / self`.
    #[must_use]
    pub fn recip(self) -> Expr {
        with(|graph| graph.recip(self))
    }

    /// An integer power.
    #[must_use]
    pub fn powi(self, exponent: i32) -> Expr {
        with(|graph| graph.powi(self, exponent))
    }

    /// `self * self`.
    #[must_use]
    pub fn squared(self) -> Expr {
        self.powi(2)
    }

    /// Square root.
    #[must_use]
    pub fn sqrt(self) -> Expr {
        with(|graph| graph.sqrt(self))
    }

    /// Sine.
    #[must_use]
    pub fn sin(self) -> Expr {
        with(|graph| graph.sin(self))
    }

    /// Cosine.
    #[must_use]
    pub fn cos(self) -> Expr {
        with(|graph| graph.cos(self))
    }

    /// Tangent.
    #[must_use]
    pub fn tan(self) -> Expr {
        with(|graph| graph.tan(self))
    }

    /// Arc sine, in [-pi/2, pi/2].
    #[must_use]
    pub fn asin(self) -> Expr {
        with(|graph| graph.asin(self))
    }

    /// Arc cosine, in [0, pi].
    #[must_use]
    pub fn acos(self) -> Expr {
        with(|graph| graph.acos(self))
    }

    /// e to this power.
    #[must_use]
    pub fn exp(self) -> Expr {
        with(|graph| graph.exp(self))
    }

    /// Natural logarithm.
    #[must_use]
    pub fn ln(self) -> Expr {
        with(|graph| graph.ln(self))
    }

    /// The angle of the point (x, self), in [-pi, pi].
    #[must_use]
    pub fn atan2(self, x: Expr) -> Expr {
        with(|graph| graph.atan2(self, x))
    }

    /// Absolute value.
    #[must_use]
    pub fn abs(self) -> Expr {
        with(|graph| graph.abs(self))
    }

    /// -1, 0 or 1.
    #[must_use]
    pub fn sign(self) -> Expr {
        with(|graph| graph.sign(self))
    }

    /// The largest integer that is not above it.
    #[must_use]
    pub fn floor(self) -> Expr {
        with(|graph| graph.floor(self))
    }

    /// The smaller one.
    #[must_use]
    pub fn min(self, other: Expr) -> Expr {
        with(|graph| graph.min(self, other))
    }

    /// The larger one.
    #[must_use]
    pub fn max(self, other: Expr) -> Expr {
        with(|graph| graph.max(self, other))
    }

    /// Itself between two bounds.
    #[must_use]
    pub fn clamp(self, low: Expr, high: Expr) -> Expr {
        with(|graph| graph.clamp(self, low, high))
    }

    /// A function by its name; see [`Graph::call`].
    pub fn call(function: Function, arguments: &[Expr]) -> Expr {
        with(|graph| graph.call(function, arguments))
    }

    /// The condition `self < other`.
    #[must_use]
    pub fn less(self, other: Expr) -> Expr {
        with(|graph| graph.less(self, other))
    }

    /// Of a condition: `yes` where it holds, else `no`.
    #[must_use]
    pub fn select(self, yes: Expr, no: Expr) -> Expr {
        with(|graph| graph.select(self, yes, no))
    }

    /// The derivative with respect to an atom; see [`Graph::diff`].
    #[must_use]
    pub fn diff(self, wrt: Expr) -> Expr {
        with(|graph| graph.diff(self, wrt))
    }

    /// The derivative along a direction; see [`Graph::directional`].
    #[must_use]
    pub fn directional(self, along: &[(Expr, Expr)]) -> Expr {
        with(|graph| graph.directional(self, along))
    }
}

impl From<Number> for Expr {
    fn from(number: Number) -> Expr {
        with(|graph| graph.number(number))
    }
}

impl From<i64> for Expr {
    fn from(integer: i64) -> Expr {
        with(|graph| graph.int(integer))
    }
}

impl From<i32> for Expr {
    fn from(integer: i32) -> Expr {
        with(|graph| graph.int(integer.into()))
    }
}

impl core::fmt::Display for Expr {
    /// As a formula, by the names of the present graph.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        with(|graph| graph.display(*self).to_string()).fmt(f)
    }
}
