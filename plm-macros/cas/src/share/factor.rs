//! Common factors leave the terms of a sum: `a*b + a*c` is `a*(b + c)`.

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
            let mut savings = Savings::of(rows, row, &uses);
            while let Some(factor) = savings.best().filter(|_| rows.items(row).len() > 1) {
                take_out(rows, row, factor, &uses, &mut savings);
            }
        }
        row += 1;
    }
}

/// How many operations each factor of the terms of a sum would save, in the order of the factors. It is kept while terms
/// leave: to list all of them for every factor that is taken out would take the square of their number.
struct Savings(Vec<(Factor, u32)>);

impl Savings {
    fn of(rows: &mut Rows, row: usize, uses: &[u32]) -> Savings {
        let mut found = Vec::new();
        for i in 0..rows.items(row).len() {
            let item = rows.items(row)[i];
            list_factors(rows, item, uses, &mut found);
        }
        found.sort_unstable();
        found.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            kept.1 += if same { next.1 } else { 0 };
            same
        });
        Savings(found)
    }

    /// The factor with the largest saving, the first of equals; it must save more than it costs afterwards.
    fn best(&self) -> Option<Factor> {
        let (mut best, mut most) = (None, 1);
        for &(factor, saving) in &self.0 {
            if saving > most {
                (best, most) = (Some(factor), saving);
            }
        }
        best
    }

    /// Terms with these factors have left.
    fn take(&mut self, factors: &[(Factor, u32)]) {
        for (factor, saving) in factors {
            if let Ok(at) = self.0.binary_search_by_key(factor, |known| known.0) {
                self.0[at].1 -= saving;
            }
        }
    }

    /// Terms with these factors have come.
    fn add(&mut self, factors: &[(Factor, u32)]) {
        for &(factor, saving) in factors {
            match self.0.binary_search_by_key(&factor, |known| known.0) {
                Ok(at) => self.0[at].1 += saving,
                Err(at) => self.0.insert(at, (factor, saving)),
            }
        }
    }
}

/// May the product be changed? Only if it is nobody else's and carries no name. What this pass makes is.
fn is_free_product(rows: &Rows, row: usize, uses: &[u32]) -> bool {
    rows.kind(row) == Kind::Product && !rows.named(row) && uses.get(row).is_none_or(|&uses| uses == 1)
}

/// Appends the factors of one term, each with the operations that the term saves without it.
fn list_factors(rows: &mut Rows, item: Item, uses: &[u32], found: &mut Vec<(Factor, u32)>) {
    if item.id as usize == UNIT {
        return;
    }
    let magnitude = magnitude(&mut rows.numbers, item.coefficient);
    if magnitude != Numbers::ONE {
        found.push((Factor::Magnitude(magnitude), 1));
    }
    if !is_free_product(rows, item.id as usize, uses) {
        found.push((Factor::Literal(literal(item.id, false)), u32::from(magnitude != Numbers::ONE)));
        return;
    }
    let factors = rows.items(item.id as usize);
    for i in 0..factors.len() {
        let id = factors[i].id;
        if i > 0 && factors[i - 1].id == id {
            continue;
        }
        let alone = factors.len() == 1 && magnitude == Numbers::ONE;
        found.push((Factor::Literal(id), u32::from(divides(id) || !alone)));
    }
}

fn magnitude(numbers: &mut Numbers, coefficient: u32) -> u32 {
    if coefficient == Numbers::MINUS_ONE { Numbers::ONE } else { numbers.id(numbers.get(coefficient).abs()) }
}

/// Replaces the terms with the factor by one: factor times the sum of what they leave.
fn take_out(rows: &mut Rows, row: usize, factor: Factor, uses: &[u32], savings: &mut Savings) {
    let (mut inner, mut factors) = (Vec::new(), Vec::new());
    let mut i = 0;
    while i < rows.items(row).len() {
        let item = rows.items(row)[i];
        let of_others = factors.len();
        list_factors(rows, item, uses, &mut factors);
        if let Some(rest) = without(rows, item, factor, uses) {
            inner.push(rest);
            rows.remove(row, i);
        } else {
            factors.truncate(of_others);
            i += 1;
        }
    }
    savings.take(&factors);
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
    rows.put_back(row, term);
    factors.clear();
    list_factors(rows, term, uses, &mut factors);
    savings.add(&factors);
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
