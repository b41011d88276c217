//! The arena: nodes in order of creation, each form once, with names beside them.

use crate::hash::Table;
use crate::node::{Expr, Node, hash_product, hash_sum, hash_words};
use crate::number::Number;

/// Index of the name of a node that has none.
const NO_NAME: u32 = u32::MAX;

/// A hash-consed graph of expressions.
///
/// Every constructor returns the one node of its canonical form, so that `==` on [`Expr`] finds equal forms, and
/// nothing is ever removed. The constructors are the simplifier; [`RULES`](crate::RULES) lists what they do.
pub struct Graph {
    nodes: Vec<Node>,
    memo: Table,
    /// For each node the symbols that it depends on, folded to 64 bits: a clear bit is proof of independence.
    depends: Vec<u64>,
    /// For each node the index of its name, or `NO_NAME`.
    name_of: Vec<u32>,
    names: Vec<Box<str>>,
    symbols: u32,
    pub(crate) derivatives: Derivatives,
    pub(crate) marks: Marks,
}

/// Derivatives known so far, found by (expression, symbol).
pub(crate) struct Derivatives {
    memo: Table,
    entries: Vec<(Expr, Expr, Expr)>,
}

impl Derivatives {
    pub(crate) fn get(&self, e: Expr, wrt: Expr) -> Option<Expr> {
        let found = self.memo.find(hash_words(8, &[e.0, wrt.0]), |i| {
            let (known, symbol, _) = self.entries[i];
            known == e && symbol == wrt
        });
        found.map(|i| self.entries[i].2)
    }

    pub(crate) fn insert(&mut self, e: Expr, wrt: Expr, derivative: Expr) {
        self.memo.push(hash_words(8, &[e.0, wrt.0]));
        self.entries.push((e, wrt, derivative));
    }
}

/// One value per node that is cheap to forget: an entry counts only if its round is the present one.
pub(crate) struct Marks {
    entries: Vec<(u32, Expr)>,
    round: u32,
}

impl Marks {
    /// Forgets everything and makes room for `len` nodes.
    pub(crate) fn start(&mut self, len: usize) {
        self.round += 1;
        if self.entries.len() < len {
            self.entries.resize(len + len / 2, (0, Expr(0)));
        }
    }

    pub(crate) fn get(&self, e: Expr) -> Option<Expr> {
        match self.entries.get(e.index()) {
            Some(&(round, value)) if round == self.round => Some(value),
            _ => None,
        }
    }

    pub(crate) fn set(&mut self, e: Expr, value: Expr) {
        self.entries[e.index()] = (self.round, value);
    }
}

impl Default for Graph {
    fn default() -> Self {
        Self::new()
    }
}

impl Graph {
    /// A graph that holds 0 and 1.
    pub fn new() -> Self {
        let mut graph = Self {
            nodes: Vec::new(),
            memo: Table::new(),
            depends: Vec::new(),
            name_of: Vec::new(),
            names: Vec::new(),
            symbols: 0,
            derivatives: Derivatives { memo: Table::new(), entries: Vec::new() },
            marks: Marks { entries: Vec::new(), round: 0 },
        };
        graph.number(Number::ZERO);
        graph.number(Number::ONE);
        graph
    }

    /// The operation at an expression.
    pub fn node(&self, e: Expr) -> &Node {
        &self.nodes[e.index()]
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Never: 0 and 1 are always there.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The name of a symbol or defined atom, or the hint of another node.
    pub fn name(&self, e: Expr) -> Option<&str> {
        match self.name_of[e.index()] {
            NO_NAME => None,
            index => Some(&self.names[index as usize]),
        }
    }

    /// A name for emission; the first one stays. Atoms and numbers keep what they have.
    pub fn hint(&mut self, e: Expr, name: &str) {
        if self.name_of[e.index()] == NO_NAME && !matches!(self.node(e), Node::Number(_)) {
            self.name_of[e.index()] = self.names.len() as u32;
            self.names.push(name.into());
        }
    }

    /// Gives `to` the name of `from`, if it has none.
    pub(crate) fn copy_name(&mut self, from: Expr, to: Expr) {
        if self.name_of[to.index()] == NO_NAME && !matches!(self.node(to), Node::Number(_)) {
            self.name_of[to.index()] = self.name_of[from.index()];
        }
    }

    /// A new atom, different from all others, whatever their names.
    pub fn symbol(&mut self, name: &str) -> Expr {
        let bit = 1 << (self.symbols % 64);
        self.symbols += 1;
        let e = self.push(Node::Symbol, hash_words(9, &[self.symbols]), bit);
        self.hint(e, name);
        e
    }

    /// The first symbol or defined atom of this name. Linear in the size of the graph: for tests and tools.
    pub fn find_name(&self, name: &str) -> Option<Expr> {
        let is_it = |e: &Expr| {
            matches!(self.node(*e), Node::Symbol | Node::Defined(_)) && self.name(*e) == Some(name)
        };
        (0..self.nodes.len() as u32).map(Expr).find(is_it)
    }

    /// An atom that stands for `value`: differentiated and evaluated through, never expanded or simplified into.
    ///
    /// Numbers, atoms, their negatives and comparisons come back unchanged; a value that was defined before comes
    /// back as the atom that it has.
    pub fn define(&mut self, name: &str, value: Expr) -> Expr {
        if self.is_atom(self.split_scale(value).1) && self.split_scale(value).0.abs().is_one() {
            return value;
        }
        if matches!(self.node(value), Node::Number(_) | Node::Less(..)) {
            return value;
        }
        let e = self.intern(Node::Defined(value));
        self.hint(e, name);
        e
    }

    fn is_atom(&self, e: Expr) -> bool {
        matches!(self.node(e), Node::Symbol | Node::Defined(_))
    }

    /// `(c, x)` with `e = c * x`, where `x` is not itself a scaled expression.
    pub(crate) fn split_scale(&self, e: Expr) -> (Number, Expr) {
        match self.node(e) {
            Node::Sum { constant, terms } if terms.len() == 1 && constant.is_zero() => terms[0],
            _ => (Number::ONE, e),
        }
    }

    /// A constant.
    pub fn number(&mut self, number: Number) -> Expr {
        self.intern(Node::Number(number))
    }

    /// An integer constant.
    pub fn int(&mut self, value: i64) -> Expr {
        self.number(Number::from_int(value))
    }

    /// 0.
    pub fn zero(&self) -> Expr {
        Expr(0)
    }

    /// 1.
    pub fn one(&self) -> Expr {
        Expr(1)
    }

    /// Pi, exact.
    pub fn pi(&mut self) -> Expr {
        self.number(Number::pi())
    }

    /// The constant that an expression is, if it is one.
    pub fn as_number(&self, e: Expr) -> Option<Number> {
        match self.node(e) {
            Node::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// Is it the constant 0?
    pub fn is_zero(&self, e: Expr) -> bool {
        e == self.zero()
    }

    /// Is it the constant 1?
    pub fn is_one(&self, e: Expr) -> bool {
        e == self.one()
    }

    /// The symbols that `e` depends on, folded to 64 bits. Disjoint from a symbol's own bit: independent of it.
    pub(crate) fn depends(&self, e: Expr) -> u64 {
        self.depends[e.index()]
    }

    /// The node of this form, found or made. Sums and products have their own ways in, which allocate only if new.
    pub(crate) fn intern(&mut self, node: Node) -> Expr {
        let hash = node.hash();
        if let Some(index) = self.memo.find(hash, |i| self.nodes[i] == node) {
            return Expr(index as u32);
        }
        let mut mask = 0;
        node.for_each_child(|child| mask |= self.depends[child.index()]);
        self.push(node, hash, mask)
    }

    /// The node of a sum in this very form: terms ascend, coefficients are not zero.
    pub(crate) fn intern_sum(&mut self, constant: Number, terms: &[(Number, Expr)]) -> Expr {
        let hash = hash_sum(constant, terms);
        let found = self.memo.find(hash, |i| match &self.nodes[i] {
            Node::Sum { constant: c, terms: t } => *c == constant && **t == *terms,
            _ => false,
        });
        if let Some(index) = found {
            return Expr(index as u32);
        }
        let mut mask = 0;
        for &(_, term) in terms {
            mask |= self.depends[term.index()];
        }
        self.push(Node::Sum { constant, terms: terms.into() }, hash, mask)
    }

    /// The node of a product in this very form: factors ascend, exponents are not zero.
    pub(crate) fn intern_product(&mut self, factors: &[(Expr, i32)]) -> Expr {
        if let Some(known) = self.find_product(factors) {
            return known;
        }
        let mut mask = 0;
        for &(factor, _) in factors {
            mask |= self.depends[factor.index()];
        }
        self.push(Node::Product(factors.into()), hash_product(factors), mask)
    }

    pub(crate) fn find_product(&self, factors: &[(Expr, i32)]) -> Option<Expr> {
        let found = self.memo.find(hash_product(factors), |i| match &self.nodes[i] {
            Node::Product(f) => **f == *factors,
            _ => false,
        });
        found.map(|i| Expr(i as u32))
    }

    /// A node that is there already, without making it.
    pub(crate) fn find(&self, node: &Node) -> Option<Expr> {
        self.memo.find(node.hash(), |i| self.nodes[i] == *node).map(|i| Expr(i as u32))
    }

    fn push(&mut self, node: Node, hash: u32, mask: u64) -> Expr {
        let e = Expr(self.nodes.len() as u32);
        self.memo.push(hash);
        self.nodes.push(node);
        self.depends.push(mask);
        self.name_of.push(NO_NAME);
        e
    }
}

impl core::fmt::Debug for Graph {
    /// The size: the content is for [`Graph::display`].
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Graph").field("nodes", &self.len()).finish_non_exhaustive()
    }
}
