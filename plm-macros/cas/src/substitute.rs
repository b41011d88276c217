//! Replacing atoms, and the list of them.

use crate::graph::Graph;
use crate::node::{Expr, Node};
use crate::number::Number;

impl Graph {
    /// Rebuilds `roots` with the second of each pair in place of the first.
    ///
    /// All pairs act at once. A defined atom whose value changes becomes a new atom of the same name.
    pub fn substitute(&mut self, roots: &[Expr], pairs: &[(Expr, Expr)]) -> Vec<Expr> {
        self.marks.start(self.len());
        let mut mask = 0;
        for &(old, new) in pairs {
            mask |= self.depends(old);
            self.marks.set(old, new);
        }
        // A pair may replace a node without symbols (a constant definition), of which the mask knows nothing.
        let mask = if pairs.iter().all(|pair| self.depends(pair.0) != 0) { Some(mask) } else { None };
        for e in self.unmarked_below(roots, mask) {
            let rebuilt = self.rebuild(e);
            self.marks.set(e, rebuilt);
        }
        roots.iter().map(|&root| self.replaced(root)).collect()
    }

    /// The symbols below `roots`, in order of creation, through defined atoms.
    pub fn symbols(&self, roots: &[Expr]) -> Vec<Expr> {
        let mut found = self.reachable(roots);
        found.retain(|&e| matches!(self.node(e), Node::Symbol));
        found
    }

    /// Everything at and below `roots`, in ascending order, which is an order of evaluation.
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        let mut seen = vec![false; self.len()];
        let mut open = roots.to_vec();
        let mut found = Vec::new();
        while let Some(e) = open.pop() {
            if !seen[e.index()] {
                seen[e.index()] = true;
                found.push(e);
                self.node(e).for_each_child(|child| open.push(child));
            }
        }
        if found.len() * 16 < seen.len() {
            found.sort_unstable();
        } else {
            // Reading the marks in order is the faster way to sort a large part of the graph.
            found.clear();
            for (i, _) in seen.iter().enumerate().filter(|mark| *mark.1) {
                found.push(Expr(i as u32));
            }
        }
        found
    }

    fn unmarked_below(&mut self, roots: &[Expr], mask: Option<u64>) -> Vec<Expr> {
        let mut open = roots.to_vec();
        let mut found = Vec::new();
        while let Some(e) = open.pop() {
            let independent = mask.is_some_and(|mask| self.depends(e) & mask == 0);
            if !independent && self.marks.get(e).is_none() {
                self.marks.set(e, e);
                found.push(e);
                self.node(e).for_each_child(|child| open.push(child));
            }
        }
        found.sort_unstable();
        found
    }

    fn replaced(&self, e: Expr) -> Expr {
        self.marks.get(e).unwrap_or(e)
    }

    /// The node with replaced operands, through the constructors. Unchanged operands keep the node.
    fn rebuild(&mut self, e: Expr) -> Expr {
        let mut changed = false;
        self.node(e).for_each_child(|child| changed |= self.replaced(child) != child);
        if !changed {
            return e;
        }
        let rebuilt = match self.node(e).clone() {
            Node::Number(_) | Node::Symbol => e,
            Node::Defined(value) => {
                let (value, name) = (self.replaced(value), self.name(e).unwrap_or_default().to_owned());
                self.define(&name, value)
            }
            Node::Sum { constant, terms } => {
                let terms: Vec<_> = terms.iter().map(|&(c, term)| (c, self.replaced(term))).collect();
                self.linear(constant, &terms)
            }
            Node::Product(factors) => {
                let factors: Vec<_> = factors.iter().map(|&(f, n)| (self.replaced(f), n)).collect();
                self.monomial(Number::ONE, &factors)
            }
            Node::Call(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|&a| self.replaced(a)).collect();
                self.call(function, &arguments)
            }
            Node::Less(a, b) => self.less(self.replaced(a), self.replaced(b)),
            Node::Select(condition, a, b) => {
                self.select(self.replaced(condition), self.replaced(a), self.replaced(b))
            }
        };
        self.copy_name(e, rebuilt);
        rebuilt
    }
}
