//! The flat form on which sharing works: each sum and product is a row of items in one long list.

use crate::graph::Graph;
use crate::hash::{Mixer, Table};
use crate::node::{Expr, Node};
use crate::number::{Number, gcd};

/// The row that stands for the number 1, so that the constant of a sum is an item like the others.
pub(super) const UNIT: usize = 0;

/// Meaning of the items of a row.
#[derive(Copy, Clone, PartialEq, Eq)]
pub(super) enum Kind {
    /// `id` is a row, `coefficient` the index of a number.
    Sum,
    /// `id` is the [`literal`] of a factor or divisor; equal ones repeat. `coefficient` is 0.
    Product,
    /// No items: the node of the graph speaks for itself.
    Other,
}

/// A row as a factor or as a divisor of a product.
pub(super) const fn literal(row: u32, divides: bool) -> u32 {
    2 * row + divides as u32
}

/// Is the literal a divisor?
pub(super) const fn divides(literal: u32) -> bool {
    literal & 1 == 1
}

/// The row of a literal.
pub(super) const fn base(literal: u32) -> usize {
    (literal / 2) as usize
}

#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Item {
    pub(super) id: u32,
    pub(super) coefficient: u32,
}

struct Row {
    kind: Kind,
    start: u32,
    len: u32,
    source: Option<Expr>,
    /// Has a name: stays a value of its own.
    named: bool,
}

pub(super) struct Rows {
    list: Vec<Row>,
    items: Vec<Item>,
    pub(super) numbers: Numbers,
    pub(super) roots: Vec<u32>,
    /// The row of each expression that was loaded.
    row_of: Vec<u32>,
    /// The rows that each `Other` row reads.
    operands: Vec<(u32, u32)>,
    /// Finds a product by its items while loading: the base of a power may be a product of its own.
    products: Table,
    places: Vec<u32>,
    /// How many rows came from the graph.
    loaded: usize,
}

impl Rows {
    /// All that is reachable, operands first.
    pub(super) fn load(graph: &Graph, roots: &[Expr]) -> Self {
        let reachable = graph.reachable(roots);
        let mut rows = Self {
            list: Vec::with_capacity(reachable.len() * 3 / 2 + 1),
            items: Vec::with_capacity(reachable.len() * 3),
            numbers: Numbers::new(),
            roots: Vec::new(),
            row_of: vec![0; graph.len()],
            operands: Vec::new(),
            products: Table::new(),
            places: Vec::new(),
            loaded: 0,
        };
        rows.append(Kind::Other, Some(graph.one()), true); // UNIT
        for &e in &reachable {
            if e != graph.one() {
                rows.load_node(graph, e);
            }
        }
        rows.roots = roots.iter().map(|root| rows.row_of[root.index()]).collect();
        rows.loaded = rows.list.len();
        rows
    }

    fn load_node(&mut self, graph: &Graph, e: Expr) {
        let named = graph.name(e).is_some();
        match graph.node(e) {
            Node::Sum { constant, terms } => {
                self.append(Kind::Sum, Some(e), named);
                if !constant.is_zero() {
                    let coefficient = self.numbers.id(*constant);
                    self.append_item(Item { id: UNIT as u32, coefficient });
                }
                for &(coefficient, term) in terms {
                    let coefficient = self.numbers.id(coefficient);
                    self.append_item(Item { id: self.row_of[term.index()], coefficient });
                }
            }
            Node::Product(factors) if has_small_exponents(factors) => {
                let items = self.product_items(factors);
                let row = self.product_row(&items);
                self.row_of[e.index()] = row;
                self.list[row as usize].source = Some(e);
                self.list[row as usize].named = named;
            }
            node => {
                let row = self.list.len() as u32;
                self.append(Kind::Other, Some(e), named);
                node.for_each_child(|child| self.operands.push((row, self.row_of[child.index()])));
            }
        }
    }

    /// The literals of a product. One that is a power as a whole is that of a row for its base: (x*y)^2.
    fn product_items(&mut self, factors: &[(Expr, i32)]) -> Vec<Item> {
        let root = common_root(factors);
        let mut items = Vec::with_capacity(factors.len() + 2);
        for &(factor, exponent) in factors {
            self.append_power(self.row_of[factor.index()], exponent / root, &mut items);
        }
        if root > 1 {
            let base = self.product_row(&items);
            items.clear();
            self.append_power(base, root, &mut items);
        }
        items
    }

    /// Small powers are repeated literals, larger ones repeat a row for the square.
    fn append_power(&mut self, row: u32, exponent: i32, items: &mut Vec<Item>) {
        let item = |row: u32| Item { id: literal(row, exponent < 0), coefficient: 0 };
        let mut left = exponent.unsigned_abs() as usize;
        if left > 3 {
            let factor = Item { id: literal(row, false), coefficient: 0 };
            let square = self.product_row(&[factor, factor]);
            items.resize(items.len() + left / 2, item(square));
            left %= 2;
        }
        items.resize(items.len() + left, item(row));
        items.sort_unstable();
    }

    /// The row of a product, found or made.
    fn product_row(&mut self, items: &[Item]) -> u32 {
        let mut mixer = Mixer::new(0);
        for item in items {
            mixer.word(u64::from(item.id));
        }
        let hash = mixer.finish();
        let found = self.products.find(hash, |i| self.items(self.places[i] as usize) == items);
        if let Some(known) = found {
            return self.places[known];
        }
        let row = self.push(Kind::Product, items) as u32;
        self.products.push(hash);
        self.places.push(row);
        row
    }

    fn append(&mut self, kind: Kind, source: Option<Expr>, named: bool) {
        if let Some(e) = source {
            self.row_of[e.index()] = self.list.len() as u32;
        }
        self.list.push(Row { kind, start: self.items.len() as u32, len: 0, source, named });
    }

    fn append_item(&mut self, item: Item) {
        self.items.push(item);
        if let Some(row) = self.list.last_mut() {
            row.len += 1;
        }
    }

    fn append_items(&mut self, items: &[Item]) {
        for &item in items {
            self.append_item(item);
        }
    }

    /// A new row.
    pub(super) fn push(&mut self, kind: Kind, items: &[Item]) -> usize {
        self.append(kind, None, false);
        self.append_items(items);
        self.list.len() - 1
    }

    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    pub(super) fn kind(&self, row: usize) -> Kind {
        self.list[row].kind
    }

    pub(super) fn named(&self, row: usize) -> bool {
        self.list[row].named
    }

    pub(super) fn source(&self, row: usize) -> Option<Expr> {
        self.list[row].source
    }

    pub(super) fn row_of(&self, e: Expr) -> usize {
        self.row_of[e.index()] as usize
    }

    pub(super) fn items(&self, row: usize) -> &[Item] {
        let row = &self.list[row];
        &self.items[row.start as usize..(row.start + row.len) as usize]
    }

    pub(super) fn items_mut(&mut self, row: usize) -> &mut [Item] {
        let row = &self.list[row];
        &mut self.items[row.start as usize..(row.start + row.len) as usize]
    }

    /// Takes the item at `at` out of a row.
    pub(super) fn remove(&mut self, row: usize, at: usize) {
        let items = self.items_mut(row);
        for i in at + 1..items.len() {
            items[i - 1] = items[i];
        }
        self.list[row].len -= 1;
    }

    /// Gives a row other items, no more than it had.
    pub(super) fn shrink(&mut self, row: usize, items: &[Item]) {
        self.items_mut(row)[..items.len()].copy_from_slice(items);
        self.list[row].len = items.len() as u32;
    }

    /// Puts an item at the end of a row from which one was taken before.
    pub(super) fn put_back(&mut self, row: usize, item: Item) {
        self.list[row].len += 1;
        if let Some(last) = self.items_mut(row).last_mut() {
            *last = item;
        }
    }

    /// How often each row is read.
    pub(super) fn uses(&self) -> Vec<u32> {
        let mut uses = vec![0; self.list.len()];
        for &root in &self.roots {
            uses[root as usize] += 1;
        }
        for &(_, operand) in &self.operands {
            uses[operand as usize] += 1;
        }
        for row in 0..self.list.len() {
            let product = self.kind(row) == Kind::Product;
            for item in self.items(row) {
                uses[if product { base(item.id) } else { item.id as usize }] += 1;
            }
        }
        uses
    }

    /// Rows of this pass that only one row of their own kind reads go back into it.
    pub(super) fn inline_single_uses(&mut self) {
        let uses = self.uses();
        for row in 0..self.list.len() {
            if self.items(row).iter().any(|item| self.inlined(row, *item, &uses).is_some()) {
                let items = self.flattened(row, &uses);
                self.list[row].start = self.items.len() as u32;
                self.list[row].len = items.len() as u32;
                self.items.extend(items);
            }
        }
    }

    /// The items of a row with those of inlined rows in their place.
    fn flattened(&mut self, row: usize, uses: &[u32]) -> Vec<Item> {
        let mut open = self.items(row).to_vec();
        open.reverse();
        let mut items = Vec::new();
        while let Some(item) = open.pop() {
            let Some(inner) = self.inlined(row, item, uses) else {
                items.push(item);
                continue;
            };
            for i in (0..self.items(inner).len()).rev() {
                let Item { id, coefficient } = self.items(inner)[i];
                open.push(Item { id, coefficient: self.numbers.product(item.coefficient, coefficient) });
            }
        }
        items
    }

    /// The row that an item stands for, if it goes back into the row of the item.
    fn inlined(&self, row: usize, item: Item, uses: &[u32]) -> Option<usize> {
        let kind = self.kind(row);
        let inner = match kind {
            // A common magnitude was taken out on purpose.
            Kind::Sum if Numbers::is_unit(item.coefficient) => item.id as usize,
            Kind::Product if !divides(item.id) => base(item.id),
            _ => return None,
        };
        (inner >= self.loaded && uses[inner] == 1 && self.kind(inner) == kind).then_some(inner)
    }
}

/// Products with larger exponents stay as they are.
fn has_small_exponents(factors: &[(Expr, i32)]) -> bool {
    const LARGEST: i32 = 8;
    let root = common_root(factors);
    root <= LARGEST && factors.iter().all(|f| (f.1 / root).abs() <= LARGEST)
}

/// The largest exponent of which a product of several factors is a power.
fn common_root(factors: &[(Expr, i32)]) -> i32 {
    match factors {
        [_] => 1,
        _ => factors.iter().fold(0, |divisor, f| gcd(divisor, i128::from(f.1))) as i32,
    }
}

/// The distinct coefficients, by index.
pub(super) struct Numbers {
    values: Vec<Number>,
    memo: Table,
}

impl Numbers {
    /// Index of 1.
    pub(super) const ONE: u32 = 0;
    /// Index of -1.
    pub(super) const MINUS_ONE: u32 = 1;

    /// Is it 1 or -1?
    pub(super) const fn is_unit(id: u32) -> bool {
        id <= Self::MINUS_ONE
    }

    fn new() -> Self {
        let mut numbers = Self { values: Vec::new(), memo: Table::new() };
        numbers.id(Number::ONE);
        numbers.id(Number::MINUS_ONE);
        numbers
    }

    pub(super) fn get(&self, id: u32) -> Number {
        self.values[id as usize]
    }

    pub(super) fn id(&mut self, number: Number) -> u32 {
        let mut mixer = Mixer::new(0);
        number.mix(&mut mixer);
        let hash = mixer.finish();
        if let Some(known) = self.memo.find(hash, |i| self.values[i] == number) {
            return known as u32;
        }
        self.memo.push(hash);
        self.values.push(number);
        self.values.len() as u32 - 1
    }

    pub(super) fn product(&mut self, a: u32, b: u32) -> u32 {
        match (a, b) {
            (Self::ONE, other) | (other, Self::ONE) => other,
            (Self::MINUS_ONE, Self::MINUS_ONE) => Self::ONE,
            _ => self.id(self.get(a) * self.get(b)),
        }
    }

    /// `a / b`; coefficients are never zero.
    pub(super) fn quotient(&mut self, a: u32, b: u32) -> u32 {
        match b {
            Self::ONE => a,
            Self::MINUS_ONE => self.product(a, b),
            _ if a == b => Self::ONE,
            _ => {
                let quotient = self.get(a).div(self.get(b));
                self.id(quotient.unwrap_or(Number::Float(f64::NAN)))
            }
        }
    }

    /// Multiple of a row by which others are compared; none where it leaves the numbers that have all digits: many quotients are one there.
    pub(super) fn ratio(&mut self, a: u32, b: u32) -> Option<u32> {
        let ratio = self.quotient(a, b);
        self.get(ratio).to_f64().is_normal().then_some(ratio)
    }
}
