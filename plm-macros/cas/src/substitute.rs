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
        if let Some(few) = self.few_reachable(roots) {
            return few;
        }
        // Operands are older than what reads them.
        let mut seen = vec![false; roots.iter().map(|root| root.index() + 1).max().unwrap_or(0)];
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

    /// Reachable nodes if they are a handful, in work that does not grow with the graph.
    fn few_reachable(&self, roots: &[Expr]) -> Option<Vec<Expr>> {
        const MOST: usize = 48;
        let mut open = roots.to_vec();
        let mut found = Vec::new();
        while let Some(e) = open.pop() {
            if !found.contains(&e) {
                found.push(e);
                self.node(e).for_each_child(|child| open.push(child));
            }
            if found.len() > MOST || open.len() > MOST {
                return None;
            }
        }
        found.sort_unstable();
        Some(found)
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
        let (node, name) = (self.node(e).clone(), self.name(e).unwrap_or_default().to_owned());
        let node = node.mapped(|child| self.replaced(child));
        let rebuilt = self.make(e, node, &name);
        self.copy_name(e, rebuilt);
        rebuilt
    }

    /// A node through the constructors; what has no operands is `leaf`.
    fn make(&mut self, leaf: Expr, node: Node, name: &str) -> Expr {
        match node {
            Node::Number(_) | Node::Symbol => leaf,
            Node::Defined(value) => self.define(name, value),
            Node::Sum { constant, terms } => self.linear(constant, &terms),
            Node::Product(factors) => self.monomial(Number::ONE, &factors),
            Node::Call(function, arguments) => self.call(function, &arguments),
            Node::Less(a, b) => self.less(a, b),
            Node::Select(condition, a, b) => self.select(condition, a, b),
        }
    }

    /// Expressions of another graph in this one. Both made their symbols in the same order: the first of one is the first
    /// of the other, and so on; this one may have made more since.
    ///
    /// So what is worked out on the side leaves no trace in the order of a graph until it is fetched.
    pub fn import(&mut self, from: &Graph, roots: &[Expr]) -> Vec<Expr> {
        let symbols = |graph: &Graph| {
            let all = (0..graph.len() as u32).map(Expr);
            all.filter(|&e| matches!(graph.node(e), Node::Symbol)).collect::<Vec<Expr>>()
        };
        let mut copies = vec![self.zero(); from.len()];
        for (theirs, ours) in symbols(from).into_iter().zip(symbols(self)) {
            copies[theirs.index()] = ours;
        }
        for e in from.reachable(roots) {
            let leaf = match from.node(e) {
                Node::Number(number) => self.number(*number),
                _ => copies[e.index()],
            };
            let name = from.name(e).unwrap_or_default();
            let node = from.node(e).clone().mapped(|child| copies[child.index()]);
            copies[e.index()] = self.make(leaf, node, name);
        }
        roots.iter().map(|root| copies[root.index()]).collect()
    }
}
