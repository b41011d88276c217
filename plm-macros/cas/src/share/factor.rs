//! Common factors leave the terms of a sum: `a*b + a*c` is `a*(b + c)`.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::rows::{Item, Kind, Numbers, Rows, UNIT, base, divides, literal};

/// A factor that terms can have in common.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Factor {
    /// A factor or divisor, as the items of a product name it.
    Literal(u32),
    /// The magnitude of a coefficient, by the index of the positive number.
    Magnitude(u32),
}

/// Takes out the factor that saves most, again and again, in every sum and in the sums that this makes.
pub(super) fn factor_sums(rows: &mut Rows) {
    let uses = rows.uses();
    let mut row = 0;
    while row < rows.len() {
        if rows.kind(row) == Kind::Sum && rows.items(row).len() > 1 {
            factor_sum(rows, row, &uses);
        }
        row += 1;
    }
}

fn factor_sum(rows: &mut Rows, row: usize, uses: &[u32]) {
    let mut terms = Terms::of(rows, row, uses);
    let mut is_changed = false;
    while let Some(factor) = terms.best().filter(|_| terms.count > 1) {
        take_out(rows, factor, uses, &mut terms);
        is_changed = true;
    }
    if is_changed {
        let left: Vec<Item> = terms.items.into_iter().flatten().collect();
        rows.shrink(row, &left);
    }
}

/// The terms of a sum while factors are taken out. What each factor would save is kept while terms leave, and where it stands:
/// to look through all terms for every factor that is taken out would take the square of their number.
struct Terms {
    /// In order; none where a term has left.
    items: Vec<Option<Item>>,
    count: usize,
    /// In order of the factors.
    factors: Vec<Saving>,
    /// Savings above 1, the largest first, of equals the first factor; some are out of date.
    largest: BinaryHeap<(u32, Reverse<Factor>)>,
}

/// Operations that taking out a factor would save.
struct Saving {
    factor: Factor,
    saves: u32,
    /// The terms that have it, ascending; some may have left.
    places: Vec<u32>,
}

impl Terms {
    fn of(rows: &mut Rows, row: usize, uses: &[u32]) -> Terms {
        let items: Vec<Item> = rows.items(row).to_vec();
        let mut found = Vec::new();
        for (place, &item) in items.iter().enumerate() {
            list_factors(rows, item, uses, |factor, saves| found.push((factor, place as u32, saves)));
        }
        found.sort_unstable();
        let mut factors: Vec<Saving> = Vec::new();
        for (factor, place, saves) in found {
            match factors.last_mut().filter(|last| last.factor == factor) {
                Some(last) => {
                    last.saves += saves;
                    last.places.push(place);
                }
                None => factors.push(Saving { factor, saves, places: vec![place] }),
            }
        }
        let saving = factors.iter().filter(|of| of.saves > 1);
        let largest = saving.map(|of| (of.saves, Reverse(of.factor))).collect();
        Terms { count: items.len(), items: items.into_iter().map(Some).collect(), factors, largest }
    }

    /// The factor with the largest saving, the first of equals; it must save more than it costs afterwards.
    fn best(&mut self) -> Option<Factor> {
        while let Some(&(saves, Reverse(factor))) = self.largest.peek() {
            let is_so = self.find(factor).is_ok_and(|at| self.factors[at].saves == saves);
            if is_so {
                return Some(factor);
            }
            self.largest.pop();
        }
        None
    }

    fn find(&self, factor: Factor) -> Result<usize, usize> {
        self.factors.binary_search_by_key(&factor, |known| known.factor)
    }

    /// The terms that have a factor.
    fn places(&mut self, factor: Factor) -> Vec<u32> {
        self.find(factor).map_or(Vec::new(), |at| std::mem::take(&mut self.factors[at].places))
    }

    /// A factor saves so much less, since a term has left.
    fn lose(&mut self, factor: Factor, saves: u32) {
        if let Ok(at) = self.find(factor) {
            self.factors[at].saves -= saves;
            self.rank(at);
        }
    }

    /// A factor saves so much more, since a term has come.
    fn gain(&mut self, factor: Factor, saves: u32, place: u32) {
        let at = self.find(factor).unwrap_or_else(|at| {
            self.factors.insert(at, Saving { factor, saves: 0, places: Vec::new() });
            at
        });
        self.factors[at].saves += saves;
        self.factors[at].places.push(place);
        self.rank(at);
    }

    fn rank(&mut self, at: usize) {
        let Saving { factor, saves, .. } = self.factors[at];
        if saves > 1 {
            self.largest.push((saves, Reverse(factor)));
        }
    }
}

/// May the product be changed? Only if it is nobody else's and carries no name. What this pass makes is.
fn is_free_product(rows: &Rows, row: usize, uses: &[u32]) -> bool {
    rows.kind(row) == Kind::Product && !rows.named(row) && uses.get(row).is_none_or(|&uses| uses == 1)
}

/// Gives the factors of one term, each with the operations that the term saves without it.
fn list_factors(rows: &mut Rows, item: Item, uses: &[u32], mut found: impl FnMut(Factor, u32)) {
    if item.id as usize == UNIT {
        return;
    }
    let magnitude = magnitude(&mut rows.numbers, item.coefficient);
    if magnitude != Numbers::ONE {
        found(Factor::Magnitude(magnitude), 1);
    }
    if !is_free_product(rows, item.id as usize, uses) {
        found(Factor::Literal(literal(item.id, false)), u32::from(magnitude != Numbers::ONE));
        return;
    }
    let factors = rows.items(item.id as usize);
    for i in 0..factors.len() {
        let id = factors[i].id;
        if i > 0 && factors[i - 1].id == id {
            continue;
        }
        let alone = factors.len() == 1 && magnitude == Numbers::ONE;
        found(Factor::Literal(id), u32::from(divides(id) || !alone));
    }
}

fn magnitude(numbers: &mut Numbers, coefficient: u32) -> u32 {
    if coefficient == Numbers::MINUS_ONE { Numbers::ONE } else { numbers.id(numbers.get(coefficient).abs()) }
}

/// Replaces the terms with the factor by one: factor times the sum of what they leave.
fn take_out(rows: &mut Rows, factor: Factor, uses: &[u32], terms: &mut Terms) {
    let mut inner = Vec::new();
    for place in terms.places(factor) {
        let Some(item) = terms.items[place as usize] else { continue };
        let mut factors = Vec::new();
        list_factors(rows, item, uses, |factor, saves| factors.push((factor, saves)));
        let Some(rest) = without(rows, item, factor, uses) else { continue };
        inner.push(rest);
        terms.items[place as usize] = None;
        for (factor, saves) in factors {
            terms.lose(factor, saves);
        }
    }
    terms.count -= inner.len();
    let sign =
        if rows.numbers.get(inner[0].coefficient).is_negative() { Numbers::MINUS_ONE } else { Numbers::ONE };
    for item in &mut inner {
        item.coefficient = rows.numbers.product(sign, item.coefficient);
    }
    inner.sort_unstable();
    let sum = rows.push(Kind::Sum, &inner) as u32;
    let term = match factor {
        Factor::Magnitude(number) => Item { id: sum, coefficient: rows.numbers.product(sign, number) },
        Factor::Literal(id) => {
            let sum = literal(sum, false);
            let mut product = [Item { id, coefficient: 0 }, Item { id: sum, coefficient: 0 }];
            product.sort_unstable();
            Item { id: rows.push(Kind::Product, &product) as u32, coefficient: sign }
        }
    };
    let place = terms.items.len() as u32;
    list_factors(rows, term, uses, |factor, saves| terms.gain(factor, saves, place));
    terms.items.push(Some(term));
    terms.count += 1;
}

/// The term without the factor, or `None` if it does not have it.
fn without(rows: &mut Rows, item: Item, factor: Factor, uses: &[u32]) -> Option<Item> {
    match factor {
        Factor::Magnitude(number) => {
            let has_it = item.id as usize != UNIT && magnitude(&mut rows.numbers, item.coefficient) == number;
            has_it.then(|| Item { id: item.id, coefficient: rows.numbers.quotient(item.coefficient, number) })
        }
        Factor::Literal(id) if is_free_product(rows, item.id as usize, uses) => {
            let product = item.id as usize;
            let at = rows.items(product).iter().position(|factor| factor.id == id)?;
            rows.remove(product, at);
            let id = match rows.items(product) {
                [] => UNIT as u32,
                [single] if !divides(single.id) => base(single.id) as u32,
                _ => item.id,
            };
            Some(Item { id, ..item })
        }
        Factor::Literal(id) => {
            (id == literal(item.id, false)).then_some(Item { id: UNIT as u32, coefficient: item.coefficient })
        }
    }
}
