//! Derivatives: forward accumulation over the nodes below an expression, in ascending order.

use crate::graph::Graph;
use crate::node::{Expr, Function, Node};
use crate::number::Number;

/// With respect to what the tangents are taken.
#[derive(Clone, Copy)]
enum Seed {
    /// One atom; results are kept in the graph's memo.
    Atom(Expr),
    /// The directions that are set in the graph's marks, where the results go as well.
    Marked,
}

impl Graph {
    /// The derivative of `e` with respect to an atom, through defined atoms (except `wrt` itself).
    ///
    /// At a kink it is the slope of the side that the definition takes there: `sign(0)` is 0, so `abs` has slope 0
    /// at 0; `min` and `max` take their second argument where both are equal; a comparison is constant.
    pub fn diff(&mut self, e: Expr, wrt: Expr) -> Expr {
        let atom = self.depends(wrt);
        self.marks.start(self.len());
        for node in self.below(e, atom, Some(wrt)) {
            let derivative = self.tangent(node, Seed::Atom(wrt));
            self.derivatives.insert(node, wrt, derivative);
        }
        self.known(e, Seed::Atom(wrt))
    }

    /// The non-zero entries of the gradient of `e`: index into `wrt`, derivative; in the order of `wrt`.
    pub fn gradient(&mut self, e: Expr, wrt: &[Expr]) -> Vec<(usize, Expr)> {
        self.marks.start(self.len());
        self.below(e, u64::MAX, None);
        let present: Vec<usize> = (0..wrt.len()).filter(|&i| self.marks.get(wrt[i]).is_some()).collect();
        let mut entries = Vec::with_capacity(present.len());
        for i in present {
            let derivative = self.diff(e, wrt[i]);
            if !self.is_zero(derivative) {
                entries.push((i, derivative));
            }
        }
        entries
    }

    /// The derivative of `e` along a direction: the sum of `de/ds * direction` over the pairs `(s, direction)`.
    ///
    /// With `(q_i, v_i)` for all coordinates and `(t, 1)` it is the total time derivative.
    pub fn directional(&mut self, e: Expr, along: &[(Expr, Expr)]) -> Expr {
        self.directionals(&[e], along)[0]
    }

    /// [`directional`](Self::directional) for several expressions at once, in one pass over what they share.
    pub fn directionals(&mut self, roots: &[Expr], along: &[(Expr, Expr)]) -> Vec<Expr> {
        self.marks.start(self.len());
        let mut mask = 0;
        for &(atom, direction) in along {
            mask |= self.depends(atom);
            self.marks.set(atom, direction);
        }
        for &root in roots {
            for node in self.below(root, mask, None) {
                let tangent = self.tangent(node, Seed::Marked);
                self.marks.set(node, tangent);
            }
        }
        roots.iter().map(|&root| self.known(root, Seed::Marked)).collect()
    }

    /// Marks the nodes at and below `e` that depend on the mask and were not marked (nor, for an atom, derived)
    /// before, and returns them in ascending order. The atom itself is left out.
    fn below(&mut self, e: Expr, mask: u64, wrt: Option<Expr>) -> Vec<Expr> {
        let mut open = vec![e];
        let mut found = Vec::new();
        while let Some(e) = open.pop() {
            let skip = self.depends(e) & mask == 0
                || self.marks.get(e).is_some()
                || wrt.is_some_and(|atom| e == atom || self.derivatives.get(e, atom).is_some());
            if !skip {
                self.marks.set(e, self.zero());
                found.push(e);
                self.node(e).for_each_child(|child| open.push(child));
            }
        }
        found.sort_unstable();
        found
    }

    /// The tangent of a node that was treated before, or that does not depend on the seed.
    fn known(&self, e: Expr, seed: Seed) -> Expr {
        let tangent = match seed {
            Seed::Atom(atom) if e == atom => Some(self.one()),
            Seed::Atom(atom) if self.depends(e) & self.depends(atom) == 0 => None,
            Seed::Atom(atom) => self.derivatives.get(e, atom),
            Seed::Marked => self.marks.get(e),
        };
        tangent.unwrap_or(self.zero())
    }

    /// The tangent of a node from those of its operands.
    fn tangent(&mut self, e: Expr, seed: Seed) -> Expr {
        match self.node(e) {
            Node::Number(_) | Node::Symbol | Node::Less(..) => self.zero(),
            Node::Defined(value) => self.known(*value, seed),
            Node::Sum { terms, .. } => {
                let terms: Vec<_> = terms.iter().map(|&(c, term)| (c, self.known(term, seed))).collect();
                self.linear(Number::ZERO, &terms)
            }
            Node::Product(factors) => {
                let factors = factors.to_vec();
                self.product_rule(factors, seed)
            }
            Node::Call(function, arguments) => {
                let (function, arguments) = (*function, arguments.clone());
                let tangents: Vec<_> = arguments.iter().map(|&a| self.known(a, seed)).collect();
                if tangents.iter().all(|&t| self.is_zero(t)) {
                    return self.zero();
                }
                self.chain_rule(e, function, &arguments, &tangents)
            }
            &Node::Select(condition, a, b) => {
                let (a, b) = (self.known(a, seed), self.known(b, seed));
                self.select(condition, a, b)
            }
        }
    }

    /// `sum over i of exponent_i * tangent_i / factor_i * product`.
    fn product_rule(&mut self, mut factors: Vec<(Expr, i32)>, seed: Seed) -> Expr {
        let count = factors.len();
        let mut terms = Vec::with_capacity(count);
        for i in 0..count {
            let (factor, exponent) = factors[i];
            let tangent = self.known(factor, seed);
            if self.is_zero(tangent) {
                continue;
            }
            // An exponent at the lower end of i32 cannot be reached by any computation that matters.
            factors[i].1 = exponent.saturating_sub(1);
            factors.push((tangent, 1));
            terms.push((Number::ONE, self.monomial(Number::from_int(i64::from(exponent)), &factors)));
            factors.pop();
            factors[i].1 = exponent;
        }
        self.linear(Number::ZERO, &terms)
    }

    /// The tangent of `e = function(x)` (or of two arguments).
    fn chain_rule(&mut self, e: Expr, function: Function, x: &[Expr], dx: &[Expr]) -> Expr {
        match function {
            Function::Sin => {
                let cosine = self.cos(x[0]);
                self.mul(cosine, dx[0])
            }
            Function::Cos => {
                let sine = self.sin(x[0]);
                self.monomial(Number::MINUS_ONE, &[(sine, 1), (dx[0], 1)])
            }
            Function::Asin => self.arc_slope(Number::ONE, x[0], dx[0]),
            Function::Acos => self.arc_slope(Number::MINUS_ONE, x[0], dx[0]),
            Function::Atan2 => self.angle_rate((x[0], dx[0]), (x[1], dx[1])),
            Function::Sqrt => self.monomial(Number::Exact { num: 1, den: 2, pi: 0 }, &[(dx[0], 1), (e, -1)]),
            Function::Exp => self.mul(e, dx[0]),
            Function::Ln => self.div(dx[0], x[0]),
            Function::Abs => {
                let sign = self.sign(x[0]);
                self.mul(sign, dx[0])
            }
            Function::Sign | Function::Floor => self.zero(),
            Function::Min => {
                let first = self.less(x[0], x[1]);
                self.select(first, dx[0], dx[1])
            }
            Function::Max => {
                let first = self.less(x[1], x[0]);
                self.select(first, dx[0], dx[1])
            }
        }
    }

    /// `sign * dx / sqrt(1 - x^2)`.
    fn arc_slope(&mut self, sign: Number, x: Expr, dx: Expr) -> Expr {
        let square = self.powi(x, 2);
        let cosine_squared = self.linear(Number::ONE, &[(Number::MINUS_ONE, square)]);
        let cosine = self.sqrt(cosine_squared);
        self.monomial(sign, &[(dx, 1), (cosine, -1)])
    }

    /// `(x*dy - y*dx) / (x^2 + y^2)`.
    fn angle_rate(&mut self, (y, dy): (Expr, Expr), (x, dx): (Expr, Expr)) -> Expr {
        let (xx, yy) = (self.powi(x, 2), self.powi(y, 2));
        let square = self.add(xx, yy);
        let (forward, backward) = (self.mul(x, dy), self.mul(y, dx));
        let cross = self.sub(forward, backward);
        self.div(cross, square)
    }
}
